//! A lab crate: rasterizers of your own, and the registry that makes them known to the command line.
//!
//! A new rasterizer is a file beside this one, a `pub mod` below, and a line in [`registry`].

pub mod my_zbuffer;
pub mod solved_example;

use farop::raster::{PerPolygon, Registry};
use my_zbuffer::MyZBuffer;
use solved_example::TenLines;

/// The built-in rasterizers and the ones of this crate; the names are what follows `-r`.
#[must_use]
pub fn registry() -> Registry {
    Registry::built_in().with("mine", PerPolygon(MyZBuffer)).with("ten_lines", PerPolygon(TenLines))
}
