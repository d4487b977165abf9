//! Which of the segments that compete for a span is in front: three questions about the whole span, then halving.
//!
//! The questions, cheapest first. Is one segment *alone*? Is one nearer than all others by the *range* of its depths (the
//! z-extent test, no arithmetic at all)? Is one nearer than all others at both *ends*? Depth is linear, so it is then
//! nearer throughout. When the answer is three times no, something crosses inside the span: it is halved, and the
//! questions are asked again of each half. Where polygons pierce each other this is a binary search for the place.
//!
//! Why halve and not divide to find the crossing: Watkins' hardware could shift but not divide; and a computed crossing
//! would be rounded, while a piece of one sample is decided exactly, by the z-buffer's own comparison.
//!
//! Space: samples. Source: Watkins 1970. Cost: two plane evaluations a segment and question about ends; a piercing
//! costs log2(span) halvings.

use super::depth::{DepthOrder, EndDepths};
use super::line::{Segment, Span};
use crate::raster::Target;
use crate::screen::DrawList;
use std::ops::Range;

/// What decided which polygon a span shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Decision {
    /// There is no other.
    Alone,
    /// Its farthest point is nearer than the nearest point of all others.
    Range,
    /// It is nearer than all others at both ends of the span.
    Ends,
    /// Too close to tell by the ends: the span is one sample wide, and the z-buffer's own depths were compared there.
    Sample,
}

/// What was counted over all scan lines.
#[derive(Clone, Copy, Debug, Default)]
struct Counts {
    /// By [`Decision`]; spans that had to be halved are not among them.
    decided: [u64; 4],
    halved: u64,
    halvings: u64,
    comparisons: u64,
}

/// The segments that compete for the span in hand; keeps its memory from span to span.
#[derive(Default)]
pub(super) struct Contest {
    /// In list order: at equal depth the first wins.
    segments: Vec<Segment>,
    /// Those whose depth range does not already rule them out.
    candidates: Vec<u32>,
    /// Pieces of the span, the leftmost last.
    undecided: Vec<Range<i32>>,
    counts: Counts,
}

impl Contest {
    /// Whether nobody competes.
    pub fn is_empty(&self) -> bool {
        self.segments.is_empty()
    }

    /// Takes in a segment that begins where the span begins.
    pub fn enter(&mut self, segment: Segment) {
        let place = self.segments.partition_point(|other| other.polygon < segment.polygon);
        self.segments.insert(place, segment);
    }

    /// Lets go the segments that end at `column`.
    pub fn leave(&mut self, column: i32) {
        self.segments.retain(|segment| segment.end > column);
    }

    /// The column where the first of them ends.
    pub fn first_end(&self) -> i32 {
        self.segments.iter().map(|segment| segment.end).min().unwrap_or(i32::MAX)
    }

    /// Decides `span` of `row`, as a whole or in pieces, and adds them to `spans` from left to right.
    pub fn decide(&mut self, list: &DrawList, span: Range<i32>, row: i32, spans: &mut Vec<Span>) {
        let halvings = self.counts.halvings;
        self.undecided.push(span);
        while let Some(columns) = self.undecided.pop() {
            if let Some((polygon, decision)) = self.winner(list, &columns, row) {
                spans.push(Span { columns, polygon, decision });
            } else {
                let middle = columns.start + (columns.end - columns.start) / 2;
                self.undecided.extend([middle..columns.end, columns.start..middle]);
                self.counts.halvings += 1;
            }
        }
        match spans.last() {
            Some(whole) if self.counts.halvings == halvings => self.counts.decided[whole.decision as usize] += 1,
            _ => self.counts.halved += 1,
        }
    }

    /// The polygon that `columns` show throughout; `None` where that cannot be told.
    fn winner(&mut self, list: &DrawList, columns: &Range<i32>, row: i32) -> Option<(u32, Decision)> {
        if let [only] = self.segments[..] {
            return Some((only.polygon, Decision::Alone));
        }
        let order = DepthOrder::of(list);
        self.find_candidates(list, &order);
        if let [nearest] = self.candidates[..] {
            return Some((nearest, Decision::Range));
        }
        if let Some(nearest) = self.nearest_at_both_ends(list, &order, (columns.start, columns.end - 1), row) {
            return Some((nearest, Decision::Ends));
        }
        (columns.len() == 1).then(|| (self.nearest_at(list, columns.start, row), Decision::Sample))
    }

    /// The z-extent test: a polygon whose nearest point is behind the farthest point of another cannot win.
    fn find_candidates(&mut self, list: &DrawList, order: &DepthOrder) {
        let planes = |segment: &Segment| list.polygon(segment.polygon as usize).depth_plane();
        // A broken screen file may hold a range upside down; its ends are still the ends.
        let farthest_points = self.segments.iter().filter_map(planes).map(|plane| plane.low.min(plane.high));
        let to_beat = farthest_points.fold(f64::NEG_INFINITY, f64::max);
        self.candidates.clear();
        let may_win = |segment: &&Segment| {
            planes(segment).is_none_or(|plane| !order.nearer(to_beat, plane.high.max(plane.low), 0.0))
        };
        self.candidates.extend(self.segments.iter().filter(may_win).map(|segment| segment.polygon));
        self.counts.comparisons += self.segments.len() as u64 - 1;
    }

    /// The candidate in front at one sample: the largest depth, the first in the list where depths are equal.
    fn nearest_at(&mut self, list: &DrawList, column: i32, row: i32) -> u32 {
        let depth = |polygon: u32| list.polygon(polygon as usize).depth(column, row);
        let mut nearest = (self.candidates[0], depth(self.candidates[0]));
        for &polygon in &self.candidates[1..] {
            self.counts.comparisons += 1;
            let other = depth(polygon);
            if other > nearest.1 {
                nearest = (polygon, other);
            }
        }
        nearest.0
    }

    /// The candidate that the ends of a span prove to be in front of all others throughout; `None` where they do not.
    fn nearest_at_both_ends(&mut self, list: &DrawList, order: &DepthOrder, ends: (i32, i32), row: i32) -> Option<u32> {
        let depths = |polygon: u32| {
            let plane = list.polygon(polygon as usize).depth_plane()?;
            Some(EndDepths::new(plane, ends, row))
        };
        let (mut winner, mut nearest) = (self.candidates[0], depths(self.candidates[0])?);
        for &polygon in &self.candidates[1..] {
            self.counts.comparisons += 1;
            let other = depths(polygon)?;
            if other.hides(&nearest, order) {
                (winner, nearest) = (polygon, other);
            } else if !nearest.hides(&other, order) {
                return None;
            }
        }
        Some(winner)
    }

    /// Tells the target what was counted.
    pub fn report(&self, target: &mut Target<'_>) {
        let counts = &self.counts;
        let [alone, range, ends, sample] = counts.decided;
        target.count("spans", alone + range + ends + sample + counts.halved);
        target.count("spans of one segment", alone);
        target.count("spans decided by depth ranges", range);
        target.count("spans decided by their ends", ends);
        target.count("spans of one sample, compared", sample);
        target.count("spans halved", counts.halved);
        target.count("halvings", counts.halvings);
        target.count("depth comparisons", counts.comparisons);
    }
}
