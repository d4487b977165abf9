//! The z-buffer: the readable reference. Every other rasterizer must draw the same bytes.
//!
//! DrawList -Z-BUFFER-> Fragment
//!
//! For every sample a polygon covers: where it is nearer than what is there, show it. Polygons may come in any order;
//! what is hidden is hidden by comparison, not by sorting.
//!
//! Source: Catmull, "A Subdivision Algorithm for Computer Display of Curved Surfaces", Ph.D. thesis, University of
//! Utah, 1974. FAROP's internal algorithm used the same scheme.
//! Cost: one plane evaluation a covered sample, shading only where it is in front so far.

use super::coverage::Spans;
use super::{Rasterizer, Target};
use crate::screen::{DrawList, ScreenPolygon, Shader};

/// Draws polygon by polygon, keeping the depth of the nearest at every sample.
#[derive(Clone, Copy, Debug, Default)]
pub struct ZBuffer;

impl Rasterizer for ZBuffer {
    fn draw(&self, list: &DrawList, target: &mut Target<'_>) {
        match target.threads() {
            1 => draw_rows(list, target),
            // Rows are independent: every thread draws the whole list into rows of its own.
            threads => target.bands(threads, |band| draw_rows(list, band)),
        }
    }
}

fn draw_rows(list: &DrawList, target: &mut Target<'_>) {
    let mut spans = Spans::within(0..target.width());
    for polygon in list.polygons() {
        spans.of(polygon.vertices(), list.grid, target.row_range(), |row, columns| {
            for column in columns {
                draw_sample(&polygon, &list.shader, (column, row), target);
            }
        });
    }
}

fn draw_sample(polygon: &ScreenPolygon<'_>, shader: &Shader, (x, y): (i32, i32), target: &mut Target<'_>) {
    // Strictly nearer: of two polygons at the same depth, the first in the list keeps the sample.
    if polygon.depth(x, y) > target.depth(x, y) {
        let fragment = shader.fragment(polygon, x, y);
        // What is not there hides nothing: a hole must leave depth alone.
        if !fragment.is_hole() {
            target.put(fragment);
        }
    }
}
