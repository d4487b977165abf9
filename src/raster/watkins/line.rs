//! One scan line: the segments on it, the spans between their ends, and what each span shows.
//!
//! ```text
//! polygon 0     |---------------|              segments: the samples each polygon covers
//! polygon 1           |-----------------|
//! polygon 2                 |--|
//!               |  0  | 0 1 |012|0 1| 1 |      spans: the same segments compete from end to end
//! ```
//!
//! Why pair crossings per polygon and not in one list: a concave polygon has several segments on a line, and polygons
//! that touch have crossings at the same place; only its own crossings tell where a polygon begins and ends.
//!
//! Space: samples; a segment covers the columns from `start` to before `end`.
//! Cost: sorting the crossings and the segments of the line.

use super::ActiveEdge;
use super::contest::{Contest, Decision};
use crate::color::Rgb;
use crate::raster::Target;
use crate::screen::{DrawList, ScreenPolygon};
use std::ops::Range;

/// A run of covered samples of one polygon.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Segment {
    pub start: i32,
    pub end: i32,
    pub polygon: u32,
}

/// Samples of one scan line that show one polygon, decided together.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Span {
    /// The samples.
    pub columns: Range<i32>,
    /// Index in the list of the polygon they show.
    pub polygon: u32,
    /// What decided that.
    pub decision: Decision,
}

/// The scan line in hand; keeps its memory from line to line.
#[derive(Default)]
pub(super) struct Line {
    /// Polygon and column of every edge that crosses the line.
    crossings: Vec<(u32, i32)>,
    /// Opaque segments, by their first column.
    segments: Vec<Segment>,
    /// Segments of surfaces that let something through: transparent, or with holes.
    glass: Vec<Segment>,
    /// Who competes for the span in hand.
    contest: Contest,
    /// The line's spans, from left to right.
    spans: Vec<Span>,
    segment_count: u64,
}

impl Line {
    /// Pairs the active edges of each polygon into segments.
    pub fn find_segments(&mut self, list: &DrawList, active: &[ActiveEdge], row: i32) {
        self.crossings.clear();
        let width = i64::from(list.width);
        let column = |edge: &ActiveEdge| edge.edge.first_column(i64::from(row), list.grid).clamp(0, width) as i32;
        self.crossings.extend(active.iter().map(|edge| (edge.polygon, column(edge))));
        // By polygon, then from left to right; a polygon's outline is closed, so its crossings come in pairs.
        self.crossings.sort_unstable();
        self.segments.clear();
        self.glass.clear();
        for pair in self.crossings.chunks_exact(2) {
            let segment = Segment { start: pair[0].1, end: pair[1].1, polygon: pair[0].0 };
            if segment.start < segment.end {
                let polygon = list.polygon(segment.polygon as usize);
                let opaque = list.shader.opacity(&polygon) == Rgb::gray(1.0) && !polygon.is_cut_out();
                if opaque { self.segments.push(segment) } else { self.glass.push(segment) }
            }
        }
        self.segments.sort_unstable();
        self.segment_count += (self.segments.len() + self.glass.len()) as u64;
    }

    /// Cuts the line into spans over which the same segments compete, and decides each.
    pub fn find_spans(&mut self, list: &DrawList, row: i32) {
        self.spans.clear();
        let (mut next, mut left) = (0, 0);
        while next < self.segments.len() || !self.contest.is_empty() {
            if self.contest.is_empty() {
                left = self.segments[next].start;
            }
            while self.segments.get(next).is_some_and(|segment| segment.start <= left) {
                self.contest.enter(self.segments[next]);
                next += 1;
            }
            // The span ends where the first of its segments ends or another begins.
            let begins = self.segments.get(next).map_or(i32::MAX, |segment| segment.start);
            let right = self.contest.first_end().min(begins);
            self.contest.decide(list, left..right, row, &mut self.spans);
            self.contest.leave(right);
            left = right;
        }
    }

    /// Puts every sample of the spans, then every sample of the other segments: the target keeps of the transparent ones what is
    /// in front of the opaque. Which samples of a surface with holes are there, no span can tell: they are compared one by one.
    pub fn draw(&self, list: &DrawList, row: i32, target: &mut Target<'_>) {
        for span in &self.spans {
            put_run(&list.polygon(span.polygon as usize), (span.columns.clone(), row), list, target);
        }
        for segment in &self.glass {
            let polygon = list.polygon(segment.polygon as usize);
            let columns = segment.start..segment.end;
            match list.shader.opacity(&polygon) == Rgb::gray(1.0) {
                true => put_cut_out(&polygon, (columns, row), list, target),
                false => put_run(&polygon, (columns, row), list, target),
            }
        }
    }

    /// The spans of the line.
    pub fn into_spans(self) -> Vec<Span> {
        self.spans
    }

    /// Tells the target what was counted.
    pub fn report(&self, target: &mut Target<'_>) {
        target.count("segments", self.segment_count);
        self.contest.report(target);
    }
}

/// Puts the samples of `columns` that are there and in front.
fn put_cut_out(
    polygon: &ScreenPolygon<'_>,
    (columns, row): (Range<i32>, i32),
    list: &DrawList,
    target: &mut Target<'_>,
) {
    for column in columns {
        // Not every sample that is behind need be shaded.
        if polygon.depth(column, row) >= target.depth(column, row) {
            let fragment = list.shader.fragment(polygon, column, row);
            if fragment.depth > 0.0 {
                target.put_if_in_front(fragment);
            }
        }
    }
}

/// Puts the samples of `columns`; what is infinitely far is not there.
fn put_run(polygon: &ScreenPolygon<'_>, (columns, row): (Range<i32>, i32), list: &DrawList, target: &mut Target<'_>) {
    for column in columns {
        let fragment = list.shader.fragment(polygon, column, row);
        if fragment.depth > 0.0 {
            target.put(fragment);
        }
    }
}
