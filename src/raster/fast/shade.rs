//! Shade: what the samples of a finished tile show, each computed once.
//!
//! tile -> SHADE -> light of samples
//!
//! Space: samples; light is linear.
//! Cost: one color a sample that shows a polygon, however many lie behind it.

use super::color::{self, Finished};
use super::textured::wear_on_fragments;
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

/// Transparent fragments of a tile that show, sample by sample.
#[derive(Debug, Default)]
pub(super) struct Blended {
    /// Those of one sample.
    in_front: Vec<Fragment>,
    /// Those of all, nearest first.
    fragments: Vec<Fragment>,
    /// Where a sample is kept, and where its fragments end.
    ends: Vec<(usize, usize)>,
}

impl<D: Depth> Tile<D> {
    /// Finds the light of every sample.
    pub fn shade(&mut self, list: &DrawList, behind: Behind, level: Level) {
        let samples = self.owner.len();
        self.light.iter_mut().for_each(|channel| channel.resize(samples, 0.0));
        let by_planes = self.shortcuts.light && color::applies(list);
        self.shown.add(list, self.owner.iter().copied());
        match D::singles(&mut self.depth) {
            Some(depth) if by_planes => {
                let (area, stride, owner, planes) = (&self.area, self.stride, &self.owner, &self.shown);
                let light = self.light.each_mut().map(Vec::as_mut_slice);
                let background = behind.background;
                let mut tile =
                    Finished { list, planes, background, area, stride, depth, owner, light, shown: 0, powers: 0 };
                color::shade(level, &mut tile);
                self.counts.puts += tile.shown;
                list.shader.add_powers(tile.powers);
                self.wear_pictures(list);
            }
            _ => self.shade_samples(list, behind.background),
        }
        if !self.veils.is_empty() {
            self.blend(list, behind.rule, by_planes.then_some(level));
        }
    }

    /// Shades sample by sample.
    fn shade_samples(&mut self, list: &DrawList, background: Rgb<f32>) {
        for y in self.area.rows.clone() {
            for x in self.area.columns.clone() {
                let index = self.index(x, y);
                let mut color = background;
                if self.owner[index] != NOBODY {
                    let polygon = list.polygon(self.owner[index] as usize);
                    color = list.shader.fragment(&polygon, x, y).color;
                    self.counts.puts += 1;
                }
                self.set_light(index, color);
            }
        }
    }

    /// What a sample shows.
    pub fn light(&self, index: usize) -> Rgb<f32> {
        let [red, green, blue] = &self.light;
        Rgb::new(red[index], green[index], blue[index])
    }

    pub(super) fn set_light(&mut self, index: usize, color: Rgb<f32>) {
        for (channel, value) in self.light.iter_mut().zip(color.to_array()) {
            channel[index] = value;
        }
    }

    /// Blends the transparent fragments in front of each opaque sample, by the target's own functions; colors come from lanes if
    /// there is a `level`.
    fn blend(&mut self, list: &DrawList, rule: Transparency, level: Option<Level>) {
        self.counts.puts += self.veils.len() as u64;
        let veils = std::mem::take(&mut self.veils);
        veils.iter().for_each(|&veil| self.keep(list, veil));
        self.veils = veils;
        let Blended { mut in_front, mut fragments, mut ends } = std::mem::take(&mut self.blended);
        fragments.clear();
        ends.clear();
        for index in 0..self.owner.len() {
            self.layers.in_front(index, self.depth[index].widened(), self.owner[index], &mut in_front);
            if !in_front.is_empty() {
                fragments.extend_from_slice(&in_front);
                ends.push((index, fragments.len()));
            }
        }
        // Only what is in front after all is shaded.
        if let Some(level) = level {
            self.shown.add(list, fragments.iter().map(|fragment| fragment.polygon));
            color::shade_fragments(level, (list, &self.shown), &mut fragments);
            wear_on_fragments((list, &self.shown), &mut fragments);
        }
        for fragment in &mut fragments {
            fragment.opacity = list.shader.opacity_of(list.polygons[fragment.polygon as usize].surface);
            if level.is_none() {
                let polygon = list.polygon(fragment.polygon as usize);
                fragment.color = list.shader.fragment(&polygon, fragment.x, fragment.y).color;
            }
        }
        let mut first = 0;
        for &(index, end) in &ends {
            self.set_light(index, composite(&fragments[first..end], self.light(index), rule));
            first = end;
        }
        self.blended = Blended { in_front, fragments, ends };
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
