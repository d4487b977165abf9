//! Textured: what lists with pictures need beside light: which samples of a surface with holes are there, and what a picture multiplies
//! light by.
//!
//! bins -cover-> samples in front -TEXTURED: alpha-> depth and owner -color-> light -TEXTURED: texels-> light
//!
//! A hole must be known before depth is written, so the deferred way (owner first, color at the end) is not enough. But only of samples
//! that would win: coverage, depth and the rejection of whole blocks are as for any other polygon, eight lanes at a time, and what is
//! left of it is kept apart, as glass is. When a polygon is through, alpha is looked up for those samples and they
//! are written or forgotten. That may wait until then, as a polygon covers a sample once.
//!
//! Why whole blocks may be rejected though holes show what is behind: a hole leaves depth alone, so the farthest depth of a block is that of
//! samples that are there. What is behind all of them cannot show.
//!
//! Space: samples of the tile. Cost: two planes, two quotients and one alpha a sample in front; at the end one color a sample.

use super::bins::Shape;
use super::cover::Samples;
use super::shown::Shown;
use super::tile::{Depth, NOBODY, Tile, Veil};
use crate::plan::Interpolation;
use crate::raster::coverage::Spans;
use crate::screen::lane::{Lane, in_block};
use crate::screen::shader::TextureShading;
use crate::screen::{BLOCK, DrawList, Fragment, Plane, ScreenPolygon};

/// Samples of a block that are written before its farthest depth is found anew.
const STALE: u16 = (BLOCK * BLOCK) as u16;

/// A plane in one block.
#[derive(Clone, Copy, Debug)]
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

/// Where one polygon's picture is looked up, made ready for one block.
#[derive(Clone, Copy)]
struct Place<'a> {
    polygon: ScreenPolygon<'a>,
    texture: Option<&'a TextureShading>,
    block: (i32, i32),
    /// u and v; `None` where their planes are no matter of `f32`.
    places: Option<[Channel; 2]>,
}

impl<'a> Place<'a> {
    #[inline]
    fn new((list, shown): (&'a DrawList, &'a Shown), polygon: u32, sample: (i32, i32)) -> Place<'a> {
        let (polygon, block) = (shown.polygon(list, polygon), block_of(sample));
        let first = list.varying.light_count();
        let places = match polygon.varying_planes().get(first..) {
            Some([u, v]) if list.interpolation != Interpolation::ScanLine && u.fits_single() && v.fits_single() => {
                let channel = |number, plane| Channel::new(plane, polygon.is_over_w(number, plane), block);
                Some([channel(first, u), channel(first + 1, v)])
            }
            _ => None,
        };
        Place { polygon, texture: list.shader.texture_of(polygon.surface()), block, places }
    }

    /// The one in `slot`, if it is of this polygon and block; else a new one, which is put there.
    #[inline]
    fn kept<'b>(
        slot: &'b mut Option<Place<'a>>,
        of: (&'a DrawList, &'a Shown),
        polygon: u32,
        sample: (i32, i32),
    ) -> &'b Place<'a> {
        let is_of = |place: &Place<'_>| place.polygon.index == polygon && place.block == block_of(sample);
        if !slot.as_ref().is_some_and(is_of) {
            *slot = None;
        }
        slot.get_or_insert_with(|| Place::new(of, polygon, sample))
    }

    /// u and v at sample (x, y), where 1/w is `inverse_w`.
    #[inline]
    fn uv(&self, (x, y): (i32, i32), inverse_w: f32) -> [f64; 2] {
        match &self.places {
            None => self.polygon.texture_place(x, y),
            Some(places) => {
                let at = [(x - self.block.0) as f32, (y - self.block.1) as f32];
                [f64::from(places[0].value(at, inverse_w)), f64::from(places[1].value(at, inverse_w))]
            }
        }
    }
}

impl Samples<'_> {
    /// Decides about the samples that `polygon`, which has holes, has kept apart from number `first` on: those that are there are written, or
    /// stay apart where it is transparent.
    #[inline(always)]
    pub fn settle(&mut self, polygon: u32, transparent: bool, first: usize) {
        if self.veils.len() > first {
            self.settle_all(polygon, transparent, first);
        }
    }

    #[inline(never)]
    fn settle_all(&mut self, polygon: u32, transparent: bool, first: usize) {
        let list = self.list;
        self.shown.add(list, [polygon]);
        let shown = std::mem::take(self.shown);
        // A small polygon's rows may lie in two blocks side by side.
        let mut places = [None, None];
        let mut kept = first;
        for number in first..self.veils.len() {
            let veil = self.veils[number];
            let (row, column) = (veil.index / self.stride as u32, veil.index % self.stride as u32);
            let sample = (self.area.columns.start + column as i32, self.area.rows.start + row as i32);
            let place = Place::kept(&mut places[((sample.0 / BLOCK) & 1) as usize], (list, &shown), polygon, sample);
            let uv = place.uv(sample, veil.depth as f32);
            if !list.shader.is_there_at(&place.polygon, sample, veil.depth, uv) {
                continue;
            }
            if transparent {
                self.veils[kept] = veil;
                kept += 1;
            } else {
                self.keep(veil, sample);
            }
        }
        self.veils.truncate(kept);
        *self.shown = shown;
    }

    fn keep(&mut self, veil: Veil, (x, y): (i32, i32)) {
        let index = veil.index as usize;
        (self.depth[index], self.owner[index]) = (veil.depth as f32, veil.polygon);
        let far = self.far_index(x, y);
        self.stale[far] += 1;
        if self.stale[far] >= STALE {
            self.stale[far] = 0;
            self.find_farthest(far, block_of((x, y)));
        }
    }

    /// The farthest depth of a block that lies in the tile as a whole.
    fn find_farthest(&mut self, far: usize, (x, y): (i32, i32)) {
        let (columns, rows) = (&self.area.columns, &self.area.rows);
        let is_whole = x >= columns.start && x + BLOCK <= columns.end && y >= rows.start && y + BLOCK <= rows.end;
        if !is_whole {
            return;
        }
        let first = (y - rows.start) as usize * self.stride + (x - columns.start) as usize;
        let rows = (0..BLOCK as usize).map(|row| &self.depth[first + row * self.stride..][..BLOCK as usize]);
        self.far[far] = rows.flatten().fold(f32::INFINITY, |least, &depth| if depth < least { depth } else { least });
    }
}

impl<D: Depth> Tile<D> {
    /// Draws one polygon with holes, whose depth is no matter of lanes, as the z-buffer does.
    pub(super) fn draw_cut_out(&mut self, list: &DrawList, shape: &Shape, spans: &mut Spans) {
        self.counts.spans += 1;
        let mut room = std::mem::take(&mut self.room);
        let polygon = list.polygon_in(shape.polygon as usize, &mut room);
        let rows = self.area.rows.clone();
        spans.of(polygon.vertices(), list.grid, rows, |row, columns| {
            for column in columns {
                let (index, depth) = (self.index(column, row), polygon.depth(column, row));
                // Strictly nearer: of two polygons at the same depth, the first in the list keeps the sample.
                if depth > self.depth[index].widened() && list.shader.is_there(&polygon, column, row) {
                    if shape.transparent {
                        self.veils.push(Veil { index: index as u32, polygon: shape.polygon, depth });
                    } else {
                        self.depth[index] = D::of(depth);
                        self.owner[index] = shape.polygon;
                    }
                }
            }
        });
        self.room = room;
    }

    /// Multiplies the light of every sample by the picture of its polygon; depths are 1/w.
    pub(super) fn wear_pictures(&mut self, list: &DrawList) {
        if !list.has_texture() {
            return;
        }
        let shown = std::mem::take(&mut self.shown);
        let (columns, rows) = (self.area.columns.clone(), self.area.rows.clone());
        let mut left = columns.start;
        while left < columns.end {
            let right = (block_of((left, 0)).0 + BLOCK).min(columns.end);
            let mut slot = None;
            for y in rows.clone() {
                for x in left..right {
                    self.wear_picture((list, &shown), &mut slot, (x, y));
                }
            }
            left = right;
        }
        self.shown = shown;
    }

    #[inline]
    fn wear_picture<'a>(&mut self, of: (&'a DrawList, &'a Shown), slot: &mut Option<Place<'a>>, (x, y): (i32, i32)) {
        let index = self.index(x, y);
        if self.owner[index] == NOBODY {
            return;
        }
        let place = Place::kept(slot, of, self.owner[index], (x, y));
        if let Some(texture) = place.texture {
            let inverse_w = self.depth[index].widened();
            let uv = place.uv((x, y), inverse_w as f32);
            let texel = of.0.shader.texel(&place.polygon, texture, inverse_w, uv);
            self.set_light(index, self.light(index) * texel);
        }
    }
}

/// The same for fragments; depths are 1/w.
pub(super) fn wear_on_fragments((list, shown): (&DrawList, &Shown), fragments: &mut [Fragment]) {
    if !list.has_texture() {
        return;
    }
    for fragment in fragments {
        let sample = (fragment.x, fragment.y);
        let place = Place::new((list, shown), fragment.polygon, sample);
        if let Some(texture) = place.texture {
            let uv = place.uv(sample, fragment.depth as f32);
            fragment.color = fragment.color * list.shader.texel(&place.polygon, texture, fragment.depth, uv);
        }
    }
}
