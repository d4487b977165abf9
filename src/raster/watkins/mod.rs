//! Watkins: scan line by scan line, span by span; every sample is shaded and put once.
//!
//! DrawList -WATKINS-> Fragment
//!
//! The z-buffer asks "is this polygon in front?" at every sample of every polygon. Watkins asks it once a *span*:
//!
//! 1. Edges are sorted once by their first scan line (here). Those that cross the line in hand are the *active* ones.
//! 2. On a scan line, the crossings of a polygon pair up into *segments*: the samples it covers (`line`).
//! 3. The ends of all segments cut the line into *spans*, over which the same segments compete (`line`).
//! 4. A span is decided as a whole: one segment is alone, or nearer by its depth range, or nearer at both ends and, depth
//!    being linear, nearer throughout (`contest`, `depth`).
//! 5. Where that fails, because polygons pierce each other or are too close to tell, the span is halved; after at most
//!    log2(width) halvings a piece is one sample wide (`contest`).
//!
//! Why it draws the z-buffer's bytes: both ask the same planes at the same sample centers, and a span is decided as a whole
//! only where no rounding could have decided one of its samples otherwise (`depth`).
//!
//! Space: samples. Source: Watkins, "A Real-Time Visible Surface Algorithm", Ph.D. thesis, University of Utah, 1970; the
//! bookkeeping after Agoston, "Computer Graphics and Geometric Modeling", 2005. Different here: crossings are exact whole
//! numbers instead of accumulated slopes, parity is kept per polygon, and transparent segments are handed to the target.
//! Cost: sorting edges once; on a scan line, its segments and spans; shading once a sample, whatever the depth complexity.

mod contest;
mod depth;
mod line;

pub use contest::Decision;
pub use line::Span;

use super::coverage::Edge;
use super::{Rasterizer, Target};
use crate::math::edges;
use crate::screen::DrawList;
use line::Line;
use std::ops::Range;

/// Draws scan line by scan line.
#[derive(Clone, Copy, Debug, Default)]
pub struct Watkins;

/// An edge of a polygon, waiting for its first scan line or crossing the current one.
#[derive(Clone, Copy, Debug)]
struct ActiveEdge {
    edge: Edge,
    /// Index of its polygon in the list.
    polygon: u32,
    /// The first row it does not cross any more.
    end_row: i64,
}

impl Rasterizer for Watkins {
    fn draw(&self, list: &DrawList, target: &mut Target<'_>) {
        if target.threads() > 1 {
            return target.bands(target.threads(), |band| draw_rows(list, band));
        }
        draw_rows(list, target);
    }
}

fn draw_rows(list: &DrawList, target: &mut Target<'_>) {
    let rows = target.row_range();
    let mut buckets = sort_edges(list, &rows);
    // Each where it begins, so that threads do not count it twice.
    let begins = |entry: &&ActiveEdge| entry.edge.rows(list.grid).start >= i64::from(rows.start);
    target.count("edges", buckets.iter().flatten().filter(begins).count() as u64);
    let mut active: Vec<ActiveEdge> = Vec::new();
    let mut line = Line::default();
    let mut longest = 0;
    for row in rows.clone() {
        // Let go the edges that ended, take in those that begin here.
        active.retain(|edge| edge.end_row > i64::from(row));
        active.append(&mut buckets[(row - rows.start) as usize]);
        longest = longest.max(active.len() as u64);
        line.find_segments(list, &active, row);
        line.find_spans(list, row);
        line.draw(list, row, target);
    }
    line.report(target);
    target.count_most("longest active edge list", longest);
}

/// The edges of all polygons, by the first of `rows` that they cross.
fn sort_edges(list: &DrawList, rows: &Range<i32>) -> Vec<Vec<ActiveEdge>> {
    let mut buckets: Vec<Vec<ActiveEdge>> = vec![Vec::new(); rows.len()];
    for polygon in list.polygons() {
        for (start, end) in edges(polygon.vertices()) {
            let edge = Edge::downward(start, end, list.grid);
            let reach = edge.rows(list.grid);
            let first = reach.start.max(i64::from(rows.start));
            // Horizontal edges, and edges between two rows of centers, cross nothing.
            if first < reach.end.min(i64::from(rows.end)) {
                let entry = ActiveEdge { edge, polygon: polygon.index, end_row: reach.end };
                buckets[(first - i64::from(rows.start)) as usize].push(entry);
            }
        }
    }
    buckets
}

/// The spans of one row, from left to right, as [`Watkins`] cuts and decides them: to look at (`docs/watkins.md`).
///
/// Only opaque polygons make spans; where there is none, there is no span.
#[must_use]
pub fn spans(list: &DrawList, row: i32) -> Vec<Span> {
    let mut line = Line::default();
    for bucket in sort_edges(list, &(row..row.saturating_add(1))) {
        line.find_segments(list, &bucket, row);
        line.find_spans(list, row);
    }
    line.into_spans()
}
