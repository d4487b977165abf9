//! Lab: hidden surfaces scan line by scan line. The handout is `docs/labs/watkins.md`.
//!
//! What is here compiles and draws something: every sample is put once, in scan-line order, but it shows the polygon that
//! comes first in the list, not the nearest. And it asks every polygon for every sample.

use farop::raster::coverage::covers;
use farop::raster::{Rasterizer, Target};
use farop::screen::DrawList;

/// The Watkins rasterizer of this lab, to be written. It sees all polygons at once.
#[derive(Clone, Copy, Debug, Default)]
pub struct MyWatkins;

impl Rasterizer for MyWatkins {
    fn draw(&self, list: &DrawList, target: &mut Target<'_>) {
        for y in target.row_range() {
            // To do: the edges that cross this scan line, from left to right; between two of them one polygon is in front.
            for x in 0..target.width() {
                let covers = |polygon: &farop::screen::ScreenPolygon<'_>| covers(polygon.vertices(), list.grid, x, y);
                if let Some(polygon) = list.polygons().find(covers) {
                    target.put(list.shader.fragment(&polygon, x, y));
                }
            }
        }
    }
}
