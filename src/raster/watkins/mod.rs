//! Watkins: scan line by scan line, span by span; every sample is shaded and put once.
//!
//! DrawList -WATKINS-> Fragment
//!
//! Edges are sorted once by their first scan line. On a scan line, the active edges of a polygon pair up into segments, and
//! the ends of all segments cut the line into spans over which the same segments are active. Most spans are decided by
//! their ends: depth is linear, so what is nearer at both ends is nearer throughout. Where it is not (polygons pierce each
//! other, or are too close to tell), the span is halved; after at most log2(width) halvings it is one sample wide.
//!
//! Why it draws the z-buffer's bytes: both ask the same planes at the same sample centers, and a span is decided by its
//! ends only when the difference there exceeds what rounding could have made of it (`depth`).
//!
//! Space: samples. Source: Watkins, "A Real-Time Visible Surface Algorithm", Ph.D. thesis, University of Utah, 1970; the
//! bookkeeping after Agoston, "Computer Graphics and Geometric Modeling", 2005. Different here: crossings are exact whole
//! numbers instead of accumulated slopes, parity is kept per polygon, and transparent segments are handed to the target.
//! Cost: sorting edges once; on a scan line, its segments and spans; shading once a sample, whatever the depth complexity.

mod depth;
mod line;

use super::coverage::Edge;
use super::{Rasterizer, Target};
use crate::math::edges;
use crate::screen::DrawList;
use line::ScanLine;

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
    let mut buckets = sort_edges(list, &rows, target);
    let mut active: Vec<ActiveEdge> = Vec::new();
    let mut line = ScanLine::default();
    let mut longest = 0;
    for row in rows.clone() {
        // Take in the edges that begin here, let go those that ended.
        active.retain(|edge| edge.end_row > i64::from(row));
        active.append(&mut buckets[(row - rows.start) as usize]);
        longest = longest.max(active.len() as u64);
        line.find_segments(list, &active, row);
        line.draw(list, row, target);
    }
    line.report(target);
    target.count_most("longest active edge list", longest);
}

/// The edges of all polygons, by the first of `rows` that they cross.
fn sort_edges(list: &DrawList, rows: &std::ops::Range<i32>, target: &mut Target<'_>) -> Vec<Vec<ActiveEdge>> {
    let mut buckets: Vec<Vec<ActiveEdge>> = vec![Vec::new(); rows.len()];
    let mut count = 0;
    for polygon in list.polygons() {
        for (start, end) in edges(polygon.vertices()) {
            let edge = Edge::downward(start, end, list.grid);
            let reach = edge.rows(list.grid);
            let first = reach.start.max(i64::from(rows.start));
            // Horizontal edges, and edges between two rows of centers, cross nothing.
            if first < reach.end.min(i64::from(rows.end)) {
                let entry = ActiveEdge { edge, polygon: polygon.index, end_row: reach.end };
                buckets[(first - i64::from(rows.start)) as usize].push(entry);
                count += 1;
            }
        }
    }
    target.count("edges", count);
    buckets
}
