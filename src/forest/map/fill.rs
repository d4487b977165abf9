//! Fill: outlines as texels, each as much covered as it is.
//!
//! rings -FILL-> shares of texels, row by row
//!
//! Every row of texels is cut at four heights. At each the outlines are crossed, and what lies between crossings is covered, exactly to the left and right.
//!
//! Space: texels; row 0 is the lowest. Cost: the edges that cross a row, four times, sorted.

use crate::forest::polygon::Point;
use crate::math::edges;

/// Heights of a row.
const CUTS: usize = 4;

/// What is inside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Rule {
    /// What an odd number of outlines surround: polygons with holes.
    EvenOdd,
    /// What outlines go around: all of a line's pieces, which overlap.
    NonZero,
}

/// An edge that is not level, from its lower end up.
#[derive(Clone, Copy)]
struct Edge {
    low: Point,
    high: Point,
    upward: bool,
}

/// Calls `row` with every row's number, first column, and shares from 0 to 1 of the texels there.
pub(super) fn fill(rings: &[Vec<Point>], rule: Rule, side: u32, mut row: impl FnMut(usize, usize, &[f32])) {
    let mut all: Vec<Edge> = rings.iter().flat_map(|ring| edges(ring)).filter_map(|(&a, &b)| edge(a, b)).collect();
    all.sort_by(|a, b| a.low[1].total_cmp(&b.low[1]));
    let Some(first) = all.first() else { return };
    let top = all.iter().map(|edge| edge.high[1]).fold(f64::NEG_INFINITY, f64::max);
    let limit = f64::from(side);
    let rows = first.low[1].clamp(0.0, limit).floor() as usize..top.clamp(0.0, limit).ceil() as usize;
    let (mut next, mut active, mut crossings) = (0, Vec::new(), Vec::new());
    let mut shares = vec![0.0_f32; side as usize];
    for number in rows {
        while next < all.len() && all[next].low[1] < (number + 1) as f64 {
            active.push(all[next]);
            next += 1;
        }
        active.retain(|edge: &Edge| edge.high[1] > number as f64);
        let mut reach = (side as usize, 0);
        for cut in 0..CUTS {
            let y = number as f64 + (cut as f64 + 0.5) / CUTS as f64;
            crossings.clear();
            crossings.extend(active.iter().filter(|edge| edge.low[1] <= y && y < edge.high[1]).map(|edge| {
                let share = (y - edge.low[1]) / (edge.high[1] - edge.low[1]);
                (edge.low[0] + (edge.high[0] - edge.low[0]) * share, edge.upward)
            }));
            crossings.sort_by(|a: &(f64, bool), b| a.0.total_cmp(&b.0));
            spans(&crossings, rule, |from, to| cover(&mut shares, from.max(0.0), to.min(limit), &mut reach));
        }
        if reach.0 < reach.1 {
            row(number, reach.0, &shares[reach.0..reach.1]);
            shares[reach.0..reach.1].fill(0.0);
        }
    }
}

fn edge(a: Point, b: Point) -> Option<Edge> {
    let upward = a[1] < b[1];
    let (low, high) = if upward { (a, b) } else { (b, a) };
    let is_finite = [low, high].iter().flatten().all(|number| number.is_finite());
    (is_finite && low[1] < high[1]).then_some(Edge { low, high, upward })
}

/// From where to where it is inside.
fn spans(crossings: &[(f64, bool)], rule: Rule, mut span: impl FnMut(f64, f64)) {
    let mut around = 0;
    for pair in crossings.windows(2) {
        around += match rule {
            Rule::EvenOdd => 1,
            Rule::NonZero if pair[0].1 => 1,
            Rule::NonZero => -1,
        };
        let inside = if rule == Rule::EvenOdd { around % 2 != 0 } else { around != 0 };
        if inside {
            span(pair[0].0, pair[1].0);
        }
    }
}

/// Adds a cut's share to the texels from `from` to `to`.
fn cover(shares: &mut [f32], from: f64, to: f64, reach: &mut (usize, usize)) {
    if to.is_nan() || to <= from {
        return;
    }
    let (first, end) = (from.floor() as usize, (to.ceil() as usize).min(shares.len()));
    *reach = (reach.0.min(first), reach.1.max(end));
    for (column, share) in shares.iter_mut().enumerate().take(end).skip(first) {
        let width = to.min((column + 1) as f64) - from.max(column as f64);
        *share += (width / CUTS as f64) as f32;
    }
}
