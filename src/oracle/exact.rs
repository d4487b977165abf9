//! Exact: which polygon every sample of a draw list shows, and by how much that was decided.
//!
//! DrawList -EXACT-> [`ExactPicture`]
//!
//! Coverage is decided without rounding on the snapped corners or on those before snapping (`oracle/covering.rs`), depth
//! by the contract or by the true planes ([`super::depth`]). A sample is *disputed* when its two nearest polygons are
//! closer together than the stated band: there an honest `f32` rasterizer may differ from the true planes.
//!
//! Space: samples; sample (x, y) is at `y * width + x`.
//! Cost: a sign an edge and sample below the polygon's bounds; some 20 bytes a sample.

use super::Vertices;
use super::covering::{Outline, Standing};
use super::depth::{Depth, DepthOrder};
use crate::color::Rgb;
use crate::screen::{DrawList, ScreenPolygon};
use std::collections::BTreeSet;
use std::ops::Range;

/// What the oracle judges by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rules {
    /// Whose coverage.
    pub vertices: Vertices,
    /// Whose depth.
    pub depth: DepthOrder,
    /// Two depths are in dispute when they differ by no more than this part of the nearer one.
    pub band: f64,
}

/// Part of a depth that eight last digits of `f32` are: what the contract's evaluation may lose.
pub const SINGLE_BAND: f64 = 8.0 * f32::EPSILON as f64;

impl Rules {
    /// What every rasterizer must draw to the bit: snapped corners, the contract's depth, nothing in dispute but ties.
    pub const CONTRACT: Rules = Rules { vertices: Vertices::Snapped, depth: DepthOrder::Contract, band: 0.0 };
    /// The contract's coverage, but the true planes; disputed within [`SINGLE_BAND`].
    pub const TRUE_DEPTH: Rules = Rules { vertices: Vertices::Snapped, depth: DepthOrder::True, band: SINGLE_BAND };
    /// Nothing snapped, nothing rounded.
    pub const UNSNAPPED: Rules = Rules { vertices: Vertices::Raw, depth: DepthOrder::True, band: SINGLE_BAND };
}

/// The owner of every sample, and how hard it was to tell.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ExactPicture {
    /// Samples across.
    pub width: u32,
    /// Samples down.
    pub height: u32,
    /// The nearest opaque polygon that covers the sample; of equally near ones, the first of the list.
    pub owner: Vec<Option<u32>>,
    /// How many polygons cover the sample, transparent ones included.
    pub covering: Vec<u32>,
    /// The decision lies within the band.
    pub disputed: Vec<bool>,
    /// Sums.
    pub counts: ExactCounts,
}

/// How much was judged, and how adversarial it was.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ExactCounts {
    /// Samples of the picture.
    pub samples: u64,
    /// Samples covered by a polygon.
    pub covered: u64,
    /// Samples covered by two or more.
    pub overlapped: u64,
    /// Pairs of polygon and sample that were decided one by one.
    pub tests: u64,
    /// Of them, samples exactly on the polygon's outline.
    pub on_outline: u64,
    /// Samples whose two nearest polygons are exactly equally near.
    pub depth_ties: u64,
    /// Samples whose decision lies within the band.
    pub disputed: u64,
    /// Pairs of polygons each of which hides the other at some sample.
    pub piercing: u64,
    /// Polygons with an edge that clipping made.
    pub cut: u64,
    /// Polygons with a corner that has no place on the screen; they cover nothing.
    pub refused: u64,
}

impl ExactPicture {
    /// Samples at which `drawn` shows another owner: beyond dispute, and disputed.
    ///
    /// `drawn` has the same rows; samples that it lacks count as background.
    #[must_use]
    pub fn differences(&self, drawn: &[Option<u32>]) -> (u64, u64) {
        let other = (0..self.owner.len()).filter(|&at| self.owner[at] != drawn.get(at).copied().flatten());
        other.fold((0, 0), |(wrong, close), at| if self.disputed[at] { (wrong, close + 1) } else { (wrong + 1, close) })
    }
}

impl std::ops::AddAssign for ExactCounts {
    fn add_assign(&mut self, other: Self) {
        self.samples += other.samples;
        self.covered += other.covered;
        self.overlapped += other.overlapped;
        self.tests += other.tests;
        self.on_outline += other.on_outline;
        self.depth_ties += other.depth_ties;
        self.disputed += other.disputed;
        self.piercing += other.piercing;
        self.cut += other.cut;
        self.refused += other.refused;
    }
}

/// The exact picture of `list` under `rules`.
#[must_use]
pub fn judge(list: &DrawList, rules: &Rules) -> ExactPicture {
    judge_rows(list, rules, 0..list.height)
}

/// As [`judge`], of some rows only: the vectors hold these rows, and so do the counts of samples.
#[must_use]
pub fn judge_rows(list: &DrawList, rules: &Rules, rows: Range<u32>) -> ExactPicture {
    let mut judge = Judge::new(list, rules, rows);
    for polygon in list.polygons() {
        judge.add(&polygon);
    }
    judge.finish()
}

/// Whether `polygon` covers sample (x, y); `None` where a raw corner has no place on the screen.
#[must_use]
pub fn covers(polygon: &ScreenPolygon<'_>, vertices: Vertices, (x, y): (i32, i32)) -> Option<bool> {
    let outline = Outline::new(polygon, vertices, (u32::MAX, u32::MAX))?;
    Some(outline.column(x).standing(y).inside)
}

/// All polygons that cover sample (x, y), the nearest first, ties in list order; transparent ones included.
#[must_use]
pub fn layers(list: &DrawList, rules: &Rules, sample: (i32, i32)) -> Vec<u32> {
    let covering = list.polygons().filter(|polygon| covers(polygon, rules.vertices, sample) == Some(true));
    let mut found: Vec<(Option<Depth>, u32)> =
        covering.map(|polygon| (Depth::new(&polygon, rules.depth), polygon.index)).collect();
    // A stable sort keeps ties in list order.
    found.sort_by(|(a, _), (b, _)| match (a, b) {
        (Some(a), Some(b)) => b.compare(a, list, sample),
        _ => b.is_some().cmp(&a.is_some()),
    });
    found.into_iter().map(|(_, index)| index).collect()
}

/// The two nearest polygons of a sample so far.
#[derive(Clone, Copy, Default)]
struct Front {
    nearest: Option<u32>,
    second: Option<u32>,
}

struct Judge<'a> {
    list: &'a DrawList,
    rules: &'a Rules,
    rows: Range<u32>,
    depths: Vec<Option<Depth>>,
    fronts: Vec<Front>,
    covering: Vec<u32>,
    counts: ExactCounts,
}

impl<'a> Judge<'a> {
    fn new(list: &'a DrawList, rules: &'a Rules, rows: Range<u32>) -> Self {
        let rows = rows.start.min(list.height)..rows.end.min(list.height);
        let samples = rows.len() * list.width as usize;
        let depths = list.polygons().map(|polygon| Depth::new(&polygon, rules.depth)).collect();
        let counts = ExactCounts { samples: samples as u64, ..ExactCounts::default() };
        Judge { list, rules, rows, depths, fronts: vec![Front::default(); samples], covering: vec![0; samples], counts }
    }

    fn add(&mut self, polygon: &ScreenPolygon<'_>) {
        let cut = polygon.vertices().iter().any(|vertex| vertex.edge == crate::screen::EdgeKind::Cut);
        self.counts.cut += u64::from(cut);
        let opacity = self.list.shader.surfaces.get(polygon.surface() as usize).map(|surface| surface.opacity);
        let opaque = opacity.is_none_or(|opacity| opacity == Rgb::gray(1.0));
        let Some(outline) = Outline::new(polygon, self.rules.vertices, (self.list.width, self.list.height)) else {
            self.counts.refused += 1;
            return;
        };
        let rows = outline.rows().start.max(self.rows.start as i32)..outline.rows().end.min(self.rows.end as i32);
        for x in outline.columns() {
            let column = outline.column(x);
            for y in rows.clone() {
                let Standing { inside, on_outline } = column.standing(y);
                self.counts.on_outline += u64::from(on_outline);
                if inside {
                    self.cover((x, y), polygon.index, opaque);
                }
            }
            self.counts.tests += rows.len() as u64;
        }
    }

    fn index(&self, (x, y): (i32, i32)) -> usize {
        (y as usize - self.rows.start as usize) * self.list.width as usize + x as usize
    }

    /// Polygon `index` covers a sample: where does it stand among the nearest?
    fn cover(&mut self, sample: (i32, i32), index: u32, opaque: bool) {
        let at = self.index(sample);
        self.covering[at] += 1;
        let Some(depth) = self.depths[index as usize].as_ref().filter(|_| opaque) else { return };
        // A depth of 0 is infinitely far: nothing is drawn there.
        if matches!(depth, Depth::Contract(_)) && depth.at(self.list, sample) <= 0.0 {
            return;
        }
        let nearer_than = |other: Option<u32>| {
            let other = other.and_then(|other| self.depths[other as usize].as_ref());
            other.is_none_or(|other| depth.compare(other, self.list, sample).is_gt())
        };
        let front = self.fronts[at];
        self.fronts[at] = if nearer_than(front.nearest) {
            Front { nearest: Some(index), second: front.nearest }
        } else if nearer_than(front.second) {
            Front { second: Some(index), ..front }
        } else {
            front
        };
    }

    /// Whether the two nearest are within the band, and whether they are equal.
    fn dispute(&self, (nearest, second): (u32, u32), sample: (i32, i32)) -> (bool, bool) {
        let (Some(a), Some(b)) = (&self.depths[nearest as usize], &self.depths[second as usize]) else {
            return (false, false);
        };
        let (near, far) = (a.at(self.list, sample), b.at(self.list, sample));
        let slack = a.slack(sample) + b.slack(sample);
        let tie = a.compare(b, self.list, sample).is_eq();
        // A slack that is not a number disputes.
        let clear = near - far > self.rules.band * near.abs() + slack;
        (tie || !clear, tie)
    }

    fn finish(mut self) -> ExactPicture {
        let mut orders = BTreeSet::new();
        let mut disputed = vec![false; self.fronts.len()];
        for (at, front) in self.fronts.iter().enumerate() {
            let Front { nearest: Some(nearest), second: Some(second) } = *front else { continue };
            let width = self.list.width as usize;
            let sample = ((at % width) as i32, (at / width) as i32 + self.rows.start as i32);
            let (close, tie) = self.dispute((nearest, second), sample);
            disputed[at] = close;
            self.counts.disputed += u64::from(close);
            self.counts.depth_ties += u64::from(tie);
            if !tie {
                orders.insert((nearest, second));
            }
        }
        let pierces = |&&(a, b): &&(u32, u32)| a < b && orders.contains(&(b, a));
        self.counts.piercing = orders.iter().filter(pierces).count() as u64;
        self.counts.covered = self.covering.iter().filter(|&&count| count > 0).count() as u64;
        self.counts.overlapped = self.covering.iter().filter(|&&count| count > 1).count() as u64;
        ExactPicture {
            width: self.list.width,
            height: self.rows.len() as u32,
            owner: self.fronts.iter().map(|front| front.nearest).collect(),
            covering: self.covering,
            disputed,
            counts: self.counts,
        }
    }
}
