//! The lab program: all of farop's command line, and the rasterizers of this crate.

use std::process::ExitCode;

fn main() -> ExitCode {
    farop::cli::main(student_rasterizers::registry())
}
