//! The `farop` program: the whole command line is a library function that takes a registry of rasterizers.

fn main() {}
