//! Scanline: FAROP's internal algorithm, where every value is one addition away from its neighbor.
//!
//! DrawList -SCANLINE-> Fragment
//!
//! Two coherences, "cálculos incrementais" in the paper. *Edge coherence*: the crossing of an edge with the next scan line
//! lies dx/dy to the right, and each value there has changed by a constant. *Scan-line coherence*: the next sample's values
//! differ by constants again. So a polygon costs a few multiplications at its edges, and a sample costs additions. Which
//! samples are covered stays exact (`coverage`); visibility is the z-buffer's.
//!
//! What it costs instead: every addition rounds, and the errors of a long edge and a long span pile up. Its picture is *not*
//! the z-buffer's; by how much it drifts away is measured in `docs/scanline.md`.
//!
//! Why `f32` accumulators: a program of 1996 had `float` registers and a `float` z-buffer, and in `f64` (measured: 1e-9
//! levels) there would be nothing to see. `--depth f64` does not change them. Why the constants are those of the polygon's
//! plane and not differences between the two ends of an edge or span: a span one sample long would divide by next to nothing.
//!
//! Space: samples. Source: Foley, van Dam, Feiner and Hughes, "Computer Graphics: Principles and Practice", 1990, 3.6 and
//! 15.4, which the paper cites. Cost: one addition a value and sample, one division and the shading where it is in front.

use super::coverage::Edge;
use super::{Rasterizer, Target};
use crate::math::edges;
use crate::screen::{DrawList, ScreenPolygon, Values};
use std::ops::Range;

/// Draws polygon by polygon, scan line by scan line, with incremental values.
#[derive(Clone, Copy, Debug, Default)]
pub struct Scanline;

impl Rasterizer for Scanline {
    fn draw(&self, list: &DrawList, target: &mut Target<'_>) {
        match target.threads() {
            1 => draw_rows(list, target),
            threads => target.bands(threads, |band| draw_rows(list, band)),
        }
    }
}

/// 1/w, then value / w of every number that varies: all linear on the screen. Unused ones stay 0.
#[derive(Clone, Copy, Debug, Default)]
struct Linear([f32; 1 + Values::MAX]);

impl Linear {
    /// Each number of `planes` (a, b, c of the depth plane, then of the varying ones) as `number` says.
    fn of(polygon: &ScreenPolygon<'_>, number: impl Fn([f64; 3]) -> f64) -> Linear {
        let mut linear = Linear::default();
        let planes = polygon.depth_plane().into_iter().chain(polygon.varying_planes());
        for (slot, plane) in linear.0.iter_mut().zip(planes) {
            *slot = number([plane.a, plane.b, plane.c]) as f32;
        }
        linear
    }

    /// The one operation of the inner loop.
    fn add(&mut self, step: &Linear) {
        self.0.iter_mut().zip(step.0).for_each(|(value, change)| *value += change);
    }

    /// `share` of a step further.
    fn moved(mut self, step: &Linear, share: f32) -> Linear {
        self.0.iter_mut().zip(step.0).for_each(|(value, change)| *value += change * share);
        self
    }
}

/// An edge with everything at its crossing with the current scan line.
#[derive(Clone, Copy, Debug)]
struct Walk {
    edge: Edge,
    /// The next row it crosses, and the first that it does not cross any more.
    row: i64,
    end_row: i64,
    /// Where it crosses that row, in samples, and how far right the next crossing lies.
    x: f32,
    slope: f32,
    /// The values there, and how they change from row to row along the edge.
    values: Linear,
    step: Linear,
}

impl Walk {
    /// At the first row of the picture that `edge` crosses: the only place where a plane is evaluated.
    fn start(edge: Edge, polygon: &ScreenPolygon<'_>) -> Walk {
        let Range { start, end: end_row } = edge.rows(polygon.grid());
        // What is not snapped is not clipped at the sides either.
        let row = start.max(0);
        let (x, y, slope) = (edge.crossing(row, polygon.grid()), row as f64 + 0.5, edge.slope());
        let values = Linear::of(polygon, |[a, b, c]| a * x + b * y + c);
        let step = Linear::of(polygon, |[a, b, _]| a * slope + b);
        Walk { edge, row, end_row, x: x as f32, slope: slope as f32, values, step }
    }

    /// Edge coherence: one row down.
    fn step_down(&mut self) {
        self.row += 1;
        self.x += self.slope;
        self.values.add(&self.step);
    }
}

/// The edges of the polygon in hand; keeps its memory from polygon to polygon.
#[derive(Default)]
struct Walks {
    /// Edges that begin further down, the uppermost last.
    waiting: Vec<Walk>,
    active: Vec<Walk>,
    /// First column right of each active edge, and its place in `active`.
    marks: Vec<(i32, usize)>,
}

fn draw_rows(list: &DrawList, target: &mut Target<'_>) {
    let mut walks = Walks::default();
    for polygon in list.polygons() {
        walks.draw(&polygon, list, target);
    }
}

impl Walks {
    /// Draws the rows of `polygon` that `target` keeps.
    fn draw(&mut self, polygon: &ScreenPolygon<'_>, list: &DrawList, target: &mut Target<'_>) {
        let rows = i64::from(target.row_range().start)..i64::from(target.row_range().end);
        self.start(polygon, &rows);
        let right = Linear::of(polygon, |[a, _, _]| a);
        while let Some(row) = self.next_row().filter(|&row| row < rows.end) {
            while self.waiting.last().is_some_and(|walk| walk.row == row) {
                self.active.extend(self.waiting.pop());
            }
            // Rows above the target's are walked, not drawn: starting further down would give other last bits, and the
            // picture would depend on the number of threads (tests/scanline.rs, `threads_draw_the_same_bytes`).
            if row >= rows.start {
                self.draw_line((polygon, &right), row, list, target);
            }
            self.active.iter_mut().for_each(Walk::step_down);
            self.active.retain(|walk| walk.row < walk.end_row);
        }
    }

    /// Makes all edges wait, except those that cross none of `rows` or end above them.
    fn start(&mut self, polygon: &ScreenPolygon<'_>, rows: &Range<i64>) {
        self.waiting.clear();
        self.active.clear();
        for (start, end) in edges(polygon.vertices()) {
            let edge = Edge::downward(start, end, polygon.grid());
            let reach = edge.rows(polygon.grid());
            if !reach.is_empty() && reach.end > rows.start && reach.start < rows.end {
                self.waiting.push(Walk::start(edge, polygon));
            }
        }
        self.waiting.sort_by_key(|walk| std::cmp::Reverse(walk.row));
    }

    fn next_row(&self) -> Option<i64> {
        self.active.first().or(self.waiting.last()).map(|walk| walk.row)
    }

    /// Pairs the edges into spans, from left to right, and draws each from the values at its left edge.
    fn draw_line(
        &mut self,
        (polygon, right): (&ScreenPolygon<'_>, &Linear),
        row: i64,
        list: &DrawList,
        target: &mut Target<'_>,
    ) {
        self.marks.clear();
        let width = i64::from(list.width);
        let column = |walk: &Walk| walk.edge.first_column(row, list.grid).clamp(0, width) as i32;
        self.marks.extend(self.active.iter().enumerate().map(|(place, walk)| (column(walk), place)));
        self.marks.sort_unstable();
        for pair in self.marks.chunks_exact(2) {
            let (first, end) = (pair[0].0, pair[1].0);
            let left = &self.active[pair[0].1];
            // From the edge to the first sample's center: less than one sample.
            let start = left.values.moved(right, first as f32 + 0.5 - left.x);
            draw_span((polygon, right), (row as i32, first..end), start, (list, target));
        }
    }
}

/// Scan-line coherence: from sample to sample by additions.
fn draw_span(
    (polygon, right): (&ScreenPolygon<'_>, &Linear),
    (row, columns): (i32, Range<i32>),
    mut values: Linear,
    (list, target): (&DrawList, &mut Target<'_>),
) {
    let Some(plane) = polygon.depth_plane() else { return };
    for column in columns {
        // Within the range at the corners, as the contract says: drift may carry a value out of it.
        let [inverse_w, over_w @ ..] = values.0;
        let inverse_w = plane.clamp(f64::from(inverse_w));
        let depth = list.depth_mapping.apply(inverse_w);
        if depth > target.depth(column, row) {
            let values = polygon.values_from((column, row), inverse_w, &over_w);
            target.put(list.shader.fragment_from(polygon, (column, row), inverse_w, &values));
        }
        values.add(right);
    }
}
