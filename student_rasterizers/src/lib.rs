//! A lab crate: rasterizers of your own, and the registry that makes them known to the command line.
//!
//! A new rasterizer is a file beside this one, a `pub mod` below, and a line in [`registry`]. The files `my_...` are the labs,
//! each begun; the handouts are in `docs/labs/`.

pub mod my_clip;
pub mod my_coverage;
pub mod my_gouraud;
pub mod my_phong;
pub mod my_supersampling;
pub mod my_triangulate;
pub mod my_watkins;
pub mod my_wire;
pub mod my_zbuffer;
pub mod solved_example;

use farop::raster::{PerPolygon, Registry, Target};
use farop::screen::ScreenPolygon;
use my_zbuffer::MyZBuffer;
use solved_example::TenLines;
use std::ops::Range;

/// The built-in rasterizers and the ones of this crate; the names are what follows `-r`.
#[must_use]
pub fn registry() -> Registry {
    Registry::built_in()
        .with("mine", PerPolygon(MyZBuffer))
        .with("ten_lines", PerPolygon(TenLines))
        .with("my_wire", PerPolygon(my_wire::MyWire))
        .with("my_coverage", PerPolygon(my_coverage::MyCoverage))
        .with("my_gouraud", PerPolygon(my_gouraud::MyGouraud))
        .with("my_watkins", my_watkins::MyWatkins)
        .with("my_phong", PerPolygon(my_phong::MyPhong))
        .with("my_supersampling", PerPolygon(my_supersampling::MySupersampling))
        .with_clip("mine", my_clip::clip)
        .with_triangulate("mine", my_triangulate::triangulate)
}

/// Columns and rows that a polygon can reach, held inside the target.
#[must_use]
pub fn reach(polygon: &ScreenPolygon<'_>, target: &Target<'_>) -> (Range<i32>, Range<i32>) {
    let corners = polygon.vertices();
    let (columns, rows) = (corners.iter().map(|corner| corner.x), corners.iter().map(|corner| corner.y));
    (between(columns, 0..target.width()), between(rows, target.row_range()))
}

/// Whole numbers from the least to the greatest coordinate, within `limits`.
fn between(coordinates: impl Iterator<Item = f64>, limits: Range<i32>) -> Range<i32> {
    let (low, high) = coordinates.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
    (low.floor() as i32).max(limits.start)..(high.ceil() as i32).min(limits.end)
}
