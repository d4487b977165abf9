//! Tile: depth and owner of the samples of one small square, which stay in the nearest caches while everything that touches it is drawn.
//!
//! bins -> TILE -> shade
//!
//! Nothing is shaded here: a sample remembers which polygon it shows, and is shaded once, when all polygons are through. Transparent
//! fragments are kept apart as in [`crate::raster::Target`], by the same type.
//!
//! Space: samples of the tile, row by row, `stride` to a row.
//! Cost: 8 bytes a sample, 12 with `f64` depth.

use super::bins::{Entry, Kind, Segment, Shape, Way};
use super::cover::{self, Run, Samples, blocks_across};
use super::layout::{Area, LANES};
use super::level::Shortcuts;
use super::shade::Blended;
use super::shown::Shown;
use crate::raster::coverage::Spans;
use crate::raster::layers::Layers;
use crate::screen::{DrawList, ScreenPolygon, Whole};
use fearless_simd::Level;

/// The owner of samples that no polygon shows on.
pub(super) const NOBODY: u32 = u32::MAX;

/// What depth is kept in.
pub(super) trait Depth: Copy + PartialOrd + Send + Sync {
    const FAR: Self;
    /// Exact: values are as wide as the list's precision says, steps of integer formats have 24 bits.
    fn of(depth: f64) -> Self;
    fn widened(self) -> f64;
    /// The depths as `f32`, if they are.
    fn singles(depths: &mut [Self]) -> Option<&mut [f32]>;
}

impl Depth for f32 {
    const FAR: f32 = 0.0;
    fn of(depth: f64) -> f32 {
        depth as f32
    }
    fn widened(self) -> f64 {
        f64::from(self)
    }
    fn singles(depths: &mut [f32]) -> Option<&mut [f32]> {
        Some(depths)
    }
}

impl Depth for f64 {
    const FAR: f64 = 0.0;
    fn of(depth: f64) -> f64 {
        depth
    }
    fn widened(self) -> f64 {
        self
    }
    fn singles(_: &mut [f64]) -> Option<&mut [f32]> {
        None
    }
}

/// One tile's samples. Kept from tile to tile and from frame to frame.
#[derive(Debug)]
pub(super) struct Tile<D> {
    pub area: Area,
    /// Samples from a row to the next.
    pub stride: usize,
    pub depth: Vec<D>,
    pub owner: Vec<u32>,
    /// Per block, a bound: no sample of it is farther.
    far: Vec<f32>,
    /// Per block, how many samples of surfaces with holes were kept since that was found.
    stale: Vec<u16>,
    /// Transparent fragments, as they came.
    pub veils: Vec<Veil>,
    /// Those of them that are blended.
    pub layers: Layers,
    runs: Vec<Run>,
    spans: Spans,
    pub blended: Blended,
    pub shown: Shown,
    pub(super) room: Whole,
    /// What the samples show, when they are shaded: red, green, blue.
    pub light: [Vec<f32>; 3],
    pub counts: Counts,
    pub shortcuts: Shortcuts,
}

/// A transparent fragment: kept apart, it leaves depth alone.
#[derive(Clone, Copy, Debug)]
pub(super) struct Veil {
    /// Where its sample is kept.
    pub index: u32,
    pub polygon: u32,
    pub depth: f64,
}

/// What was done, for `--stats`.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Counts {
    /// Samples that show a polygon, and transparent fragments that were kept.
    pub puts: u64,
    /// Polygon and tile pairs that went the way of the z-buffer.
    pub spans: u64,
    /// Polygon and tile pairs drawn by edges.
    pub edges: u64,
    /// Polygon and tile pairs drawn by spans and lanes.
    pub runs: u64,
}

impl std::ops::Add for Counts {
    type Output = Counts;
    fn add(self, other: Counts) -> Counts {
        let Counts { puts, spans, edges, runs } = other;
        Counts { puts: self.puts + puts, spans: self.spans + spans, edges: self.edges + edges, runs: self.runs + runs }
    }
}

impl<D: Depth> Tile<D> {
    pub fn new() -> Tile<D> {
        let (area, layers) = (Area { columns: 0..0, rows: 0..0 }, Layers::default());
        let (depth, owner, light, counts) = (Vec::new(), Vec::new(), Default::default(), Counts::default());
        let shortcuts = Shortcuts::default();
        Tile {
            area,
            stride: 0,
            depth,
            owner,
            far: Vec::new(),
            stale: Vec::new(),
            veils: Vec::new(),
            layers,
            runs: Vec::new(),
            spans: Spans::default(),
            blended: Blended::default(),
            shown: Shown::default(),
            room: Whole::default(),
            light,
            counts,
            shortcuts,
        }
    }

    /// Empties it and puts it over `area`; rows are `stride` samples apart.
    pub fn clear(&mut self, area: Area, stride: usize) {
        // Eight samples that start in the last row end in the array.
        let samples = stride * area.rows.len() + LANES as usize;
        self.depth.clear();
        self.depth.resize(samples, D::FAR);
        self.owner.clear();
        self.owner.resize(samples, NOBODY);
        self.far.clear();
        self.far.resize(blocks_across(stride) * blocks_across(area.rows.len()), 0.0);
        self.stale.clear();
        self.stale.resize(self.far.len(), 0);
        self.veils.clear();
        self.layers.clear();
        self.shown.clear();
        (self.area, self.stride) = (area, stride);
    }

    /// Where sample (x, y) is kept.
    #[inline(always)]
    pub fn index(&self, x: i32, y: i32) -> usize {
        (y - self.area.rows.start) as usize * self.stride + (x - self.area.columns.start) as usize
    }

    /// Draws what touches tile `number`, in the order of the list.
    pub fn draw(&mut self, list: &DrawList, segments: &[Segment], number: usize, level: Level) {
        let mut spans = std::mem::take(&mut self.spans);
        spans.limit(self.area.columns.clone());
        for segment in segments {
            let mut entries = segment.bins[number].as_slice();
            while !entries.is_empty() {
                let other = entries.iter().position(|entry| entry.kind() == Kind::Other).unwrap_or(entries.len());
                let (by_edges, rest) = entries.split_at(other);
                self.draw_edges(list, segment, by_edges, level);
                entries = rest;
                if let Some((entry, after)) = rest.split_first() {
                    let shape = &segment.shapes[entry.index()];
                    match shape.way {
                        Way::CutOut => self.draw_cut_out(list, shape, &mut spans),
                        Way::Runs => self.draw_runs(list, shape, &mut spans, level),
                        Way::Edges | Way::Spans => self.draw_spans(list, shape, &mut spans),
                    }
                    entries = after;
                }
            }
        }
        self.spans = spans;
    }

    fn draw_edges(&mut self, list: &DrawList, segment: &Segment, entries: &[Entry], level: Level) {
        self.counts.edges += entries.len() as u64;
        if let Some(samples) = self.samples(list) {
            cover::draw(level, samples, segment, entries);
        }
    }

    /// Draws one polygon by the z-buffer's spans and depth in lanes.
    fn draw_runs(&mut self, list: &DrawList, shape: &Shape, spans: &mut Spans, level: Level) {
        self.counts.runs += 1;
        let mut room = std::mem::take(&mut self.room);
        let polygon = list.polygon_in(shape.polygon as usize, &mut room);
        let mut runs = std::mem::take(&mut self.runs);
        runs.clear();
        spans.of(polygon.vertices(), list.grid, self.area.rows.clone(), |row, columns| {
            runs.push((row, columns.start, columns.end));
        });
        if let Some(samples) = self.samples(list) {
            cover::draw_runs(level, samples, shape, &runs);
        }
        self.runs = runs;
        self.room = room;
    }

    /// The samples, if their depths are `f32`.
    fn samples<'a>(&'a mut self, list: &'a DrawList) -> Option<Samples<'a>> {
        let depth = D::singles(&mut self.depth)?;
        let (area, stride, shortcuts) = (&self.area, self.stride, self.shortcuts);
        let (owner, far, stale) = (&mut self.owner, &mut self.far, &mut self.stale);
        let (veils, shown) = (&mut self.veils, &mut self.shown);
        Some(Samples { area, stride, depth, owner, far, stale, veils, shown, shortcuts, list })
    }

    /// Draws one polygon as the z-buffer does.
    fn draw_spans(&mut self, list: &DrawList, shape: &Shape, spans: &mut Spans) {
        self.counts.spans += 1;
        let mut room = std::mem::take(&mut self.room);
        let polygon = list.polygon_in(shape.polygon as usize, &mut room);
        let rows = self.area.rows.clone();
        spans.of(polygon.vertices(), list.grid, rows, |row, columns| {
            for column in columns {
                self.draw_sample(&polygon, (column, row), shape.transparent);
            }
        });
        self.room = room;
    }

    fn draw_sample(&mut self, polygon: &ScreenPolygon<'_>, (x, y): (i32, i32), transparent: bool) {
        let (index, depth) = (self.index(x, y), polygon.depth(x, y));
        // Strictly nearer: of two polygons at the same depth, the first in the list keeps the sample.
        let nearer = depth > self.depth[index].widened();
        if nearer && transparent {
            self.veils.push(Veil { index: index as u32, polygon: polygon.index, depth });
        } else if nearer {
            self.depth[index] = D::of(depth);
            self.owner[index] = polygon.index;
        }
    }
}
