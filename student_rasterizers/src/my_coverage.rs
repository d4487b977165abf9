//! Lab: find the samples that a polygon covers. The handout is `docs/labs/coverage.md`.
//!
//! What is here compiles and draws something: the box around every polygon. Keep what the polygon covers.

use crate::reach;
use farop::raster::{PolygonRasterizer, Target};
use farop::screen::{ScreenPolygon, Shader};

/// The rasterizer of this lab, to be written. Depth is not asked for: later polygons may paint over earlier ones.
#[derive(Clone, Copy, Debug, Default)]
pub struct MyCoverage;

impl PolygonRasterizer for MyCoverage {
    fn draw_polygon(&self, polygon: &ScreenPolygon<'_>, shader: &Shader, target: &mut Target<'_>) {
        let (columns, rows) = reach(polygon, target);
        for y in rows {
            for x in columns.clone() {
                // To do: only where the polygon covers the center of the sample, (x + 0.5, y + 0.5).
                target.put(shader.fragment(polygon, x, y));
            }
        }
    }
}
