//! The `farop` program: the whole command line is a library function that takes a registry of rasterizers.

use farop::raster::Registry;

fn main() -> std::process::ExitCode {
    farop::cli::main(Registry::built_in())
}
