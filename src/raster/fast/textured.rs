//! Textured: lists with pictures. Polygons with holes are drawn sample by sample; colors are looked up once, for what is in front.
//!
//! bins -> TEXTURED -> depth and owner; depth and owner -> TEXTURED -> light
//!
//! A hole must be known before depth is written, so the deferred way (owner first, color at the end) is not enough: a picture's alpha
//! is looked up here, its color at the end, for the samples that stay. What a polygon's planes need in a row of a block is made ready
//! once for as long as the samples go on in it.
//!
//! Space: samples of the tile. Cost: three planes, two quotients and one alpha a sample in front; at the end one color a sample.

use super::bins::Shape;
use super::tile::{Depth, NOBODY, Tile, Veil};
use crate::color::Rgb;
use crate::plan::{DepthFormat, Interpolation};
use crate::raster::coverage::Spans;
use crate::screen::lane::{Lane, in_block};
use crate::screen::{BLOCK, DrawList, Plane, Precision, ScreenPolygon, Values};
use std::ops::Range;

/// Whether depths are 1/w in `f32`, and what varies comes from planes: then what is made ready here applies.
fn applies(list: &DrawList) -> bool {
    list.precision == Precision::Single
        && list.depth_mapping.format == DepthFormat::F32
        && list.interpolation != Interpolation::ScanLine
}

/// A plane in one block.
#[derive(Clone, Copy, Debug, Default)]
struct Channel {
    anchor: f32,
    slope: [f32; 2],
    range: [f32; 2],
    over_w: bool,
}

impl Channel {
    #[inline]
    fn new(plane: &Plane, over_w: bool, (x, y): (i32, i32)) -> Channel {
        let range = [plane.low as f32, plane.high as f32];
        Channel { anchor: plane.anchor(x, y), slope: plane.slope(), range, over_w }
    }

    /// The value `at` samples right and down of the block's first, where 1/w is `inverse_w`.
    #[inline]
    fn value(&self, at: [f32; 2], inverse_w: f32) -> f32 {
        let plane = in_block(self.anchor, self.slope, at);
        let value = if self.over_w { plane / inverse_w } else { plane };
        value.hold(self.range[0], self.range[1])
    }
}

/// The first sample of the block that sample (x, y) is in.
#[inline]
fn block_of((x, y): (i32, i32)) -> (i32, i32) {
    (x & !(BLOCK - 1), y & !(BLOCK - 1))
}

impl<D: Depth> Tile<D> {
    /// Draws one polygon with holes as the z-buffer does.
    pub(super) fn draw_cut_out(&mut self, list: &DrawList, shape: &Shape, spans: &mut Spans) {
        self.counts.spans += 1;
        let polygon = list.polygon(shape.polygon as usize);
        let first = list.varying.light_count();
        let planes = polygon.varying_planes().get(first..).unwrap_or_default();
        let rows = self.area.rows.clone();
        match *planes {
            [ref u, ref v] if applies(list) && [&shape.depth, u, v].iter().all(|plane| plane.fits_single()) => {
                spans.of(polygon.vertices(), list.grid, rows, |row, columns| {
                    self.draw_cut_out_run(list, (&polygon, shape), [u, v], (row, columns));
                });
            }
            _ => spans.of(polygon.vertices(), list.grid, rows, |row, columns| {
                for column in columns {
                    let (index, depth) = (self.index(column, row), polygon.depth(column, row));
                    // Strictly nearer: of two polygons at the same depth, the first in the list keeps the sample.
                    if depth > self.depth[index].widened() && list.shader.is_there(&polygon, column, row) {
                        self.keep_sample(index, depth, shape);
                    }
                }
            }),
        }
    }

    /// The same for a run of samples, with planes made ready once a block.
    fn draw_cut_out_run(
        &mut self,
        list: &DrawList,
        (polygon, shape): (&ScreenPolygon<'_>, &Shape),
        places: [&Plane; 2],
        (row, columns): (i32, Range<i32>),
    ) {
        let first = list.varying.light_count();
        let mut start = columns.start;
        while start < columns.end {
            let block = block_of((start, row));
            let end = (block.0 + BLOCK).min(columns.end);
            let depth_channel = Channel::new(&shape.depth, false, block);
            let [u, v] = [0, 1].map(|n| Channel::new(places[n], polygon.is_over_w(first + n, places[n]), block));
            for column in start..end {
                let at = [(column - block.0) as f32, (row - block.1) as f32];
                let inverse_w = depth_channel.value(at, 1.0);
                let (index, depth) = (self.index(column, row), f64::from(inverse_w));
                if depth > self.depth[index].widened() {
                    let place = [u, v].map(|channel| f64::from(channel.value(at, inverse_w)));
                    if list.shader.is_there_at(polygon, (column, row), depth, place) {
                        self.keep_sample(index, depth, shape);
                    }
                }
            }
            start = end;
        }
    }

    fn keep_sample(&mut self, index: usize, depth: f64, shape: &Shape) {
        if shape.transparent {
            self.veils.push(Veil { index: index as u32, polygon: shape.polygon, depth });
        } else {
            self.depth[index] = D::of(depth);
            self.owner[index] = shape.polygon;
        }
    }

    /// Finds the light of every sample of a list with pictures; `false`, and nothing done, where nothing can be made ready.
    pub(super) fn shade_textured(&mut self, list: &DrawList, background: Rgb<f32>) -> bool {
        if !list.has_texture() || !applies(list) {
            return false;
        }
        for (channel, value) in self.light.iter_mut().zip(background.to_array()) {
            channel.fill(value);
        }
        let mut ready = Ready::nothing();
        for y in self.area.rows.clone() {
            for x in self.area.columns.clone() {
                let index = self.index(x, y);
                let polygon = self.owner[index];
                if polygon != NOBODY {
                    if ready.polygon != polygon || ready.block != block_of((x, y)) {
                        ready = Ready::new(list, polygon, (x, y));
                    }
                    let light = ready.light(list, (x, y), self.depth[index].widened() as f32);
                    self.set_light(index, light);
                    self.counts.puts += 1;
                }
            }
        }
        true
    }
}

/// What the values of one polygon in one block need.
struct Ready {
    polygon: u32,
    block: (i32, i32),
    /// Planes do not fit `f32`: the shader's own way.
    by_shader: bool,
    count: usize,
    channels: [Channel; Values::MAX],
}

impl Ready {
    fn nothing() -> Ready {
        let channels = [Channel::default(); Values::MAX];
        Ready { polygon: NOBODY, block: (0, 0), by_shader: true, count: 0, channels }
    }

    fn new(list: &DrawList, polygon: u32, sample: (i32, i32)) -> Ready {
        let view = list.polygon(polygon as usize);
        let (planes, block) = (view.varying_planes(), block_of(sample));
        let by_shader = !planes.iter().all(Plane::fits_single);
        let mut ready = Ready { polygon, block, by_shader, count: planes.len(), ..Ready::nothing() };
        for (number, (channel, plane)) in ready.channels.iter_mut().zip(planes).enumerate() {
            *channel = Channel::new(plane, view.is_over_w(number, plane), block);
        }
        ready
    }

    /// The light of sample (x, y), where 1/w is `inverse_w`.
    fn light(&self, list: &DrawList, (x, y): (i32, i32), inverse_w: f32) -> Rgb<f32> {
        let view = list.polygon(self.polygon as usize);
        if self.by_shader {
            return list.shader.fragment(&view, x, y).color;
        }
        let at = [(x - self.block.0) as f32, (y - self.block.1) as f32];
        let mut values = [0.0; Values::MAX];
        for (value, channel) in values.iter_mut().zip(&self.channels[..self.count]) {
            *value = f64::from(channel.value(at, inverse_w));
        }
        list.shader.fragment_from(&view, (x, y), f64::from(inverse_w), &values[..self.count]).color
    }
}
