//! Textured: polygons with holes, sample by sample.
//!
//! bins -> TEXTURED -> depth and owner
//!
//! A hole must be known before depth is written, so the deferred way (owner first, color at the end) does not do: the picture's alpha
//! is looked up here, its color once at the end, for the samples that stay.
//!
//! Space: samples of the tile. Cost: two planes, two quotients and one alpha a sample in front.

use super::bins::Shape;
use super::tile::{Depth, Tile, Veil};
use crate::raster::coverage::Spans;
use crate::screen::DrawList;

impl<D: Depth> Tile<D> {
    /// Draws one polygon with holes as the z-buffer does.
    pub(super) fn draw_cut_out(&mut self, list: &DrawList, shape: &Shape, spans: &mut Spans) {
        self.counts.spans += 1;
        let polygon = list.polygon(shape.polygon as usize);
        let rows = self.area.rows.clone();
        spans.of(polygon.vertices(), list.grid, rows, |row, columns| {
            for column in columns {
                let (index, depth) = (self.index(column, row), polygon.depth(column, row));
                // Strictly nearer: of two polygons at the same depth, the first in the list keeps the sample.
                if depth > self.depth[index].widened() && list.shader.is_there(&polygon, column, row) {
                    self.keep_sample(index, depth, shape);
                }
            }
        });
    }

    fn keep_sample(&mut self, index: usize, depth: f64, shape: &Shape) {
        if shape.transparent {
            self.veils.push(Veil { index: index as u32, polygon: shape.polygon, depth });
        } else {
            self.depth[index] = D::of(depth);
            self.owner[index] = shape.polygon;
        }
    }
}
