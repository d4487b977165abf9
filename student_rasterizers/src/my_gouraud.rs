//! Lab: spread colors over a polygon. The handout is `docs/labs/gouraud.md`.
//!
//! What is here compiles and draws something: each polygon in the color of its first corner. Coverage and depth are done, so that
//! you can see the colors; compute them yourself.

use crate::reach;
use farop::plan::Accepts;
use farop::raster::coverage::covers;
use farop::raster::{PolygonRasterizer, Target};
use farop::screen::{Fragment, ScreenPolygon, Shader};

/// The rasterizer of this lab, to be written.
#[derive(Clone, Copy, Debug, Default)]
pub struct MyGouraud;

impl PolygonRasterizer for MyGouraud {
    fn draw_polygon(&self, polygon: &ScreenPolygon<'_>, shader: &Shader, target: &mut Target<'_>) {
        let (columns, rows) = reach(polygon, target);
        for y in rows {
            for x in columns.clone() {
                let depth = polygon.depth(x, y);
                if !covers(polygon.vertices(), polygon.grid(), x, y) || depth <= target.depth(x, y) {
                    continue;
                }
                // To do: red, green, blue between the corners, in perspective. A corner has
                // `polygon.vertices()[i].homogeneous` (x, y, w) and `polygon.vertex_values(i)`.
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
