//! Lab: several samples a pixel. The handout is `docs/labs/supersampling.md`.
//!
//! What is here compiles and draws something, with staircases that `--samples 4` does not smooth: four neighbors share the
//! answer of the first of them. Ask for each sample by itself, and then make it quick.

use crate::reach;
use farop::raster::coverage::covers;
use farop::raster::{PolygonRasterizer, Target};
use farop::screen::{ScreenPolygon, Shader};

/// The rasterizer of this lab, to be written.
#[derive(Clone, Copy, Debug, Default)]
pub struct MySupersampling;

impl PolygonRasterizer for MySupersampling {
    fn draw_polygon(&self, polygon: &ScreenPolygon<'_>, shader: &Shader, target: &mut Target<'_>) {
        let (columns, rows) = reach(polygon, target);
        for y in rows {
            for x in columns.clone() {
                // To do: the sample's own coverage and depth.
                let (asked_x, asked_y) = (x / 2 * 2, y / 2 * 2);
                let is_covered = covers(polygon.vertices(), polygon.grid(), asked_x, asked_y);
                if is_covered && polygon.depth(asked_x, asked_y) > target.depth(x, y) {
                    target.put(shader.fragment(polygon, x, y));
                }
            }
        }
    }
}
