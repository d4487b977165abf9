//! One scan line: its segments, its spans, and which segment each span shows.
//!
//! Space: samples; a segment covers the columns from `start` to before `end`.

use super::ActiveEdge;
use super::depth::EndDepths;
use crate::color::Rgb;
use crate::raster::Target;
use crate::screen::{DrawList, ScreenPolygon};

/// A run of covered samples of one polygon.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Segment {
    start: i32,
    end: i32,
    polygon: u32,
}

/// What was counted over all scan lines.
#[derive(Clone, Copy, Debug, Default)]
struct LineCounts {
    segments: u64,
    spans: u64,
    by_ends: u64,
    halvings: u64,
    comparisons: u64,
}

/// The scan line in hand; keeps its memory from line to line.
#[derive(Default)]
pub(super) struct ScanLine {
    /// Polygon and column of every edge that crosses the line.
    crossings: Vec<(u32, i32)>,
    /// By their first column.
    segments: Vec<Segment>,
    /// Those that cover the span in hand, in list order: at equal depth the first wins.
    active: Vec<Segment>,
    /// Transparent segments of the line.
    glass: Vec<Segment>,
    counts: LineCounts,
}

impl ScanLine {
    /// Pairs the active edges of each polygon into segments.
    pub fn find_segments(&mut self, list: &DrawList, active: &[ActiveEdge], row: i32) {
        self.crossings.clear();
        let width = i64::from(list.width);
        let column = |edge: &ActiveEdge| edge.edge.first_column(i64::from(row), list.grid).clamp(0, width) as i32;
        self.crossings.extend(active.iter().map(|edge| (edge.polygon, column(edge))));
        // By polygon, then from left to right; a polygon's outline is closed, so its crossings come in pairs. (Pairing per
        // polygon and not in one list keeps concave and touching polygons right.)
        self.crossings.sort_unstable();
        self.segments.clear();
        self.glass.clear();
        for pair in self.crossings.chunks_exact(2) {
            let segment = Segment { start: pair[0].1, end: pair[1].1, polygon: pair[0].0 };
            if segment.start < segment.end {
                let opaque = list.shader.opacity(&list.polygon(segment.polygon as usize)) == Rgb::gray(1.0);
                if opaque { self.segments.push(segment) } else { self.glass.push(segment) }
            }
        }
        self.segments.sort_unstable();
        self.counts.segments += (self.segments.len() + self.glass.len()) as u64;
    }

    /// Cuts the line into spans over which the same segments are active, and draws each.
    pub fn draw(&mut self, list: &DrawList, row: i32, target: &mut Target<'_>) {
        self.active.clear();
        let mut next = 0;
        let mut left = 0;
        while next < self.segments.len() || !self.active.is_empty() {
            if self.active.is_empty() {
                left = self.segments[next].start;
            }
            // Take in what begins at the left end.
            while self.segments.get(next).is_some_and(|segment| segment.start <= left) {
                let segment = self.segments[next];
                let place = self.active.partition_point(|other| other.polygon < segment.polygon);
                self.active.insert(place, segment);
                next += 1;
            }
            // The span ends where the first of them ends or another begins.
            let begins = self.segments.get(next).map_or(i32::MAX, |segment| segment.start);
            let right = self.active.iter().map(|segment| segment.end).min().unwrap_or(left).min(begins);
            self.counts.spans += 1;
            self.resolve(list, (left, right), row, target);
            self.active.retain(|segment| segment.end > right);
            left = right;
        }
        self.draw_glass(list, row, target);
    }

    /// Decides the span from `left` to before `right`: by its ends, else by halving it down to single samples.
    fn resolve(&mut self, list: &DrawList, (left, right): (i32, i32), row: i32, target: &mut Target<'_>) {
        let mut undecided = vec![(left, right)];
        let mut whole = true;
        // A stack, rightmost at the bottom: pieces are drawn from left to right.
        while let Some((left, right)) = undecided.pop() {
            let winner = if right - left == 1 {
                self.nearest_at(list, left, row)
            } else {
                self.nearest_at_both_ends(list, (left, right - 1), row)
            };
            let Some(winner) = winner else {
                let middle = left + (right - left) / 2;
                undecided.extend([(middle, right), (left, middle)]);
                self.counts.halvings += 1;
                whole = false;
                continue;
            };
            let polygon = list.polygon(winner as usize);
            put_run(list, &polygon, (left, right), row, target);
        }
        self.counts.by_ends += u64::from(whole);
    }

    /// The polygon in front at one sample: the largest depth, the first in the list where depths are equal.
    fn nearest_at(&mut self, list: &DrawList, column: i32, row: i32) -> Option<u32> {
        self.counts.comparisons += self.active.len() as u64 - 1;
        let depths = self
            .active
            .iter()
            .map(|segment| (segment.polygon, list.polygon(segment.polygon as usize).depth(column, row)));
        depths
            .reduce(|best, next| if next.1 > best.1 { next } else { best })
            .filter(|&(_, depth)| depth > 0.0)
            .map(|(polygon, _)| polygon)
    }

    /// The polygon that the ends of a span prove to be in front of all others throughout; `None` where they do not.
    fn nearest_at_both_ends(&mut self, list: &DrawList, ends: (i32, i32), row: i32) -> Option<u32> {
        if let [only] = self.active[..] {
            return Some(only.polygon);
        }
        let depths = |segment: &Segment| {
            let polygon = list.polygon(segment.polygon as usize);
            polygon.depth_plane().map(|plane| EndDepths::new(plane, ends, row))
        };
        let (mut winner, mut nearest) = (self.active[0].polygon, depths(&self.active[0])?);
        for segment in &self.active[1..] {
            self.counts.comparisons += 1;
            let other = depths(segment)?;
            if other.hides(&nearest, list) {
                (winner, nearest) = (segment.polygon, other);
            } else if !nearest.hides(&other, list) {
                return None;
            }
        }
        Some(winner)
    }

    /// Puts every sample of the transparent segments: the target keeps what is in front of the opaque.
    fn draw_glass(&self, list: &DrawList, row: i32, target: &mut Target<'_>) {
        for segment in &self.glass {
            let polygon = list.polygon(segment.polygon as usize);
            put_run(list, &polygon, (segment.start, segment.end), row, target);
        }
    }

    /// Tells the target what was counted.
    pub fn report(&self, target: &mut Target<'_>) {
        let counts = &self.counts;
        target.count("segments", counts.segments);
        target.count("spans", counts.spans);
        target.count("spans decided by their ends", counts.by_ends);
        target.count("halvings", counts.halvings);
        target.count("depth comparisons", counts.comparisons);
    }
}

/// Puts the samples from `left` to before `right`; with integer depth, what rounds to infinitely far is not there.
fn put_run(list: &DrawList, polygon: &ScreenPolygon<'_>, (left, right): (i32, i32), row: i32, target: &mut Target<'_>) {
    for column in left..right {
        let fragment = list.shader.fragment(polygon, column, row);
        if fragment.depth > 0.0 {
            target.put(fragment);
        }
    }
}
