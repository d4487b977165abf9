//! Shade: what the samples of a finished tile show, each computed once.
//!
//! tile -> SHADE -> light of samples
//!
//! Space: samples; light is linear.
//! Cost: one color a sample that shows a polygon, however many lie behind it.

use super::color::{self, Finished};
use super::tile::{Depth, NOBODY, Tile, Veil};
use crate::color::Rgb;
use crate::plan::Transparency;
use crate::raster::layers::composite;
use crate::screen::{DrawList, Fragment};
use fearless_simd::Level;

/// What lies behind everything, and how layers add up.
#[derive(Clone, Copy, Debug)]
pub(super) struct Behind {
    pub background: Rgb<f32>,
    pub rule: Transparency,
}

impl<D: Depth> Tile<D> {
    /// Finds the light of every sample.
    pub fn shade(&mut self, list: &DrawList, behind: Behind, level: Level) {
        self.light.resize(self.owner.len(), behind.background);
        let by_planes = color::applies(list);
        let is_done = self.shade_textured(list, behind.background);
        match D::singles(&mut self.depth) {
            _ if is_done => {}
            Some(depth) if by_planes => {
                let (area, stride, owner, light) = (&self.area, self.stride, &self.owner, &mut self.light);
                let background = behind.background;
                let mut tile = Finished { list, background, area, stride, depth, owner, light, shown: 0, powers: 0 };
                color::shade(level, &mut tile);
                self.counts.puts += tile.shown;
                list.shader.add_powers(tile.powers);
            }
            _ => self.shade_samples(list, behind.background),
        }
        if !self.veils.is_empty() {
            self.blend(list, behind.rule, by_planes);
        }
    }

    /// Shades sample by sample.
    fn shade_samples(&mut self, list: &DrawList, background: Rgb<f32>) {
        self.light.fill(background);
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
    }

    /// Blends the transparent fragments in front of each opaque sample, by the target's own functions.
    fn blend(&mut self, list: &DrawList, rule: Transparency, by_planes: bool) {
        self.counts.puts += self.veils.len() as u64;
        let veils = std::mem::take(&mut self.veils);
        veils.iter().for_each(|&veil| self.keep(list, veil));
        self.veils = veils;
        let mut sorted = Vec::new();
        for index in 0..self.owner.len() {
            self.layers.in_front(index, self.depth[index].widened(), self.owner[index], &mut sorted);
            if sorted.is_empty() {
                continue;
            }
            // Only what is in front after all is shaded.
            for layer in &mut sorted {
                let (at, polygon) = ((layer.x, layer.y), list.polygon(layer.polygon as usize));
                layer.color = if by_planes {
                    color::of_sample(list, layer.polygon, at, layer.depth as f32)
                } else {
                    list.shader.fragment(&polygon, at.0, at.1).color
                };
                layer.opacity = list.shader.opacity(&polygon);
            }
            self.light[index] = composite(&sorted, self.light[index], rule);
        }
    }

    /// Keeps a transparent fragment among the layers, if it may be in front of what is opaque.
    fn keep(&mut self, list: &DrawList, veil: Veil) {
        let index = veil.index as usize;
        // What cannot be in front need not be sorted. What is, the layers decide.
        if veil.depth < self.depth[index].widened() {
            return;
        }
        let (row, column) = (index / self.stride, index % self.stride);
        let (x, y) = (self.area.columns.start + column as i32, self.area.rows.start + row as i32);
        let (color, opacity) = (list.shader.line_color, Rgb::gray(0.0));
        let fragment = Fragment { x, y, depth: veil.depth, color, opacity, polygon: veil.polygon };
        self.layers.push(index, self.owner.len(), fragment);
    }
}
