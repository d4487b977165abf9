//! Lab: light at every sample. The handout is `docs/labs/phong.md`.
//!
//! What is here compiles and draws something: each polygon in the light of its first corner. Coverage and depth are done.

use crate::reach;
use farop::plan::Accepts;
use farop::raster::coverage::covers;
use farop::raster::{PolygonRasterizer, Target};
use farop::screen::{Fragment, ScreenPolygon, Shader};

/// The rasterizer of this lab, to be written.
#[derive(Clone, Copy, Debug, Default)]
pub struct MyPhong;

impl PolygonRasterizer for MyPhong {
    fn draw_polygon(&self, polygon: &ScreenPolygon<'_>, shader: &Shader, target: &mut Target<'_>) {
        let (columns, rows) = reach(polygon, target);
        for y in rows {
            for x in columns.clone() {
                let depth = polygon.depth(x, y);
                if !covers(polygon.vertices(), polygon.grid(), x, y) || depth <= target.depth(x, y) {
                    continue;
                }
                // Six numbers: the normal, and the point in eye space. To do: those of this sample. Then the light there: its
                // parts are in `shader.lights` and `shader.surfaces[polygon.surface() as usize]`; `shader.color` adds them up.
                let values = polygon.vertex_values(0);
                let (color, opacity) = (shader.color(polygon, values), shader.opacity(polygon));
                target.put(Fragment { x, y, depth, color, opacity, polygon: polygon.index });
            }
        }
    }

    fn accepts(&self) -> Accepts {
        Accepts::Triangles
    }
}
