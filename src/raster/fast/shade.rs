//! Shade: what the samples of a finished tile show, each computed once.
//!
//! tile -> SHADE -> light of samples
//!
//! Space: samples; light is linear.
//! Cost: one color a sample that shows a polygon, however many lie behind it.

use super::tile::{Depth, NOBODY, Tile};
use crate::color::Rgb;
use crate::plan::Transparency;
use crate::raster::layers::composite;
use crate::screen::DrawList;

/// What lies behind everything, and how layers add up.
#[derive(Clone, Copy, Debug)]
pub(super) struct Behind {
    pub background: Rgb<f32>,
    pub rule: Transparency,
}

impl<D: Depth> Tile<D> {
    /// Finds the light of every sample.
    pub fn shade(&mut self, list: &DrawList, behind: Behind) {
        self.light.clear();
        self.light.resize(self.owner.len(), behind.background);
        for y in self.area.rows.clone() {
            for x in self.area.columns.clone() {
                let index = self.index(x, y);
                if self.owner[index] != NOBODY {
                    let polygon = list.polygon(self.owner[index] as usize);
                    self.light[index] = list.shader.fragment(&polygon, x, y).color;
                    self.counts.puts += 1;
                }
            }
        }
        if !self.layers.is_empty() {
            self.blend(list, behind.rule);
        }
    }

    /// Blends the transparent fragments in front of each opaque sample.
    fn blend(&mut self, list: &DrawList, rule: Transparency) {
        let mut sorted = Vec::new();
        for index in 0..self.owner.len() {
            self.layers.in_front(index, self.depth[index].widened(), self.owner[index], &mut sorted);
            if sorted.is_empty() {
                continue;
            }
            // Only what is in front after all is shaded.
            for layer in &mut sorted {
                let polygon = list.polygon(layer.polygon as usize);
                *layer = list.shader.fragment(&polygon, layer.x, layer.y);
            }
            self.light[index] = composite(&sorted, self.light[index], rule);
        }
    }
}
