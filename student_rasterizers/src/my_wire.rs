//! Lab: draw edges. The handout is `docs/labs/wire.md`.
//!
//! What is here compiles and draws something: a dot at every corner. Draw the lines between them.

use farop::math::edges;
use farop::raster::{PolygonRasterizer, Target};
use farop::screen::{EdgeKind, ScreenPolygon, Shader};

/// The wire rasterizer of this lab, to be written.
#[derive(Clone, Copy, Debug, Default)]
pub struct MyWire;

impl PolygonRasterizer for MyWire {
    fn draw_polygon(&self, polygon: &ScreenPolygon<'_>, shader: &Shader, target: &mut Target<'_>) {
        for (start, _end) in edges(polygon.vertices()) {
            // Edges that clipping made are not the object's.
            if start.edge == EdgeKind::Cut {
                continue;
            }
            // To do: every sample whose diamond the line from start to end leaves.
            let (x, y) = (start.x as i32, start.y as i32);
            if x < target.width() && y < target.height() {
                target.put(shader.fragment(polygon, x, y));
            }
        }
    }
}
