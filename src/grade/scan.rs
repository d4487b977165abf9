//! Scan: the spans of an outline line by line, as programs with an edge table make them: right, or with a slip.
//!
//! Outline, [`Scan`] -> first and end column of every span of every row
//!
//! Why beside [`super::covered`], which asks every sample by itself: slips of an edge table (a slope that loses its remainder, an
//! edge that stays too long) depend on the rows above. Columns under [`Scan::RIGHT`] are those of the contract; a test holds them to it.
//!
//! Cost: edges times rows.

use crate::math::edges as sides;

type Point = (f64, f64);

/// How an outline becomes spans.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scan {
    /// Which line inside a row edges are crossed with: 0.5 is right.
    pub row: f64,
    /// Which lines an edge crosses.
    pub owns: Owns,
    /// The first column of a span.
    pub first: Cut,
    /// The column after its last.
    pub end: Cut,
    /// No span is shorter than a sample.
    pub is_never_empty: bool,
    /// How x follows an edge down.
    pub slope: Slope,
    /// Edges that are left out.
    pub edges: Edges,
    /// How crossings become pairs.
    pub pairs: Pairs,
    /// What an odd crossing does.
    pub odd: Odd,
    /// Rows by which edges start late.
    pub starts_late: i32,
    /// Rows by which edges end late.
    pub ends_late: i32,
    /// Steps along an edge made too early.
    pub ahead: i32,
    /// Rows that are lost.
    pub lost: Lost,
    /// What lies beyond the right side of the picture is written to the next row.
    pub spills: bool,
}

impl Scan {
    /// The contract's.
    pub const RIGHT: Scan = Scan {
        row: 0.5,
        owns: Owns::Upper,
        first: Cut::CENTER,
        end: Cut::CENTER,
        is_never_empty: false,
        slope: Slope::Exact,
        edges: Edges::All,
        pairs: Pairs::Sorted,
        odd: Odd::Dropped,
        starts_late: 0,
        ends_late: 0,
        ahead: 0,
        lost: Lost::None,
        spills: false,
    };
}

/// From x to a column.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cut {
    /// floor(x + this).
    Floor(f64),
    /// ceil(x + this).
    Ceil(f64),
}

impl Cut {
    /// The first column whose center is not left of x.
    pub const CENTER: Cut = Cut::Ceil(-0.5);

    fn column(self, x: f64) -> i32 {
        match self {
            Cut::Floor(add) => (x + add).floor() as i32,
            Cut::Ceil(add) => (x + add).ceil() as i32,
        }
    }
}

/// Which lines an edge crosses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Owns {
    /// That of its upper end, not that of its lower.
    Upper,
    /// Those of both ends.
    Both,
    /// Those of neither.
    Neither,
    /// Level edges cross the line they lie on.
    Level,
}

/// How x follows an edge down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Slope {
    /// Exactly.
    Exact,
    /// x of the upper end everywhere.
    UpperEnd,
    /// x of the lower end everywhere.
    LowerEnd,
    /// x on the edge's first row everywhere.
    FirstRow,
    /// From the right place on the first row on by a whole number: the fraction of dx / dy is cut off.
    Cut,
    /// The same, rounded down.
    Down,
    /// The same, rounded.
    Rounded,
    /// dy / dx.
    TurnedOver,
    /// To the other side.
    Reversed,
    /// On the first row at the upper end, which lies higher than that row's line.
    FromEnd,
    /// As if the upper end lay on the upper side of its row.
    FromRow,
    /// Summed up in parts of a sample: one over this; rounded or cut, begun anew at every corner's height.
    Summed(f64, bool, bool),
}

/// Edges that are left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Edges {
    /// None.
    All,
    /// The one that closes the outline.
    LastLost,
    /// That from the first corner to the second.
    FirstLost,
    /// Those that run upward.
    UpwardLost,
    /// Those that run downward.
    DownwardLost,
    /// None; but the one that closes the outline leads to the second corner.
    ClosedToSecond,
    /// None; but all begin in the first corner.
    FromFirst,
    /// Those that are less than a row high.
    ShortLost,
    /// Those that are less than a column wide, and not upright.
    NarrowLost,
}

/// How crossings become pairs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pairs {
    /// From left to right.
    Sorted,
    /// In the order of the outline.
    Unsorted,
    /// Put in place when they begin, and never sorted again.
    KeptOrder,
    /// The first pair alone.
    FirstOnly,
    /// The last pair alone.
    LastOnly,
    /// Every crossing with the next.
    Overlapping,
    /// From left to right, and of those at one place one.
    Once,
    /// In the order in which they should be.
    Rightly,
}

/// What an odd crossing does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Odd {
    /// Nothing.
    Dropped,
    /// The span runs to the right side of the picture.
    RunsOn,
    /// A span comes from the left side of the picture.
    FromLeft,
}

/// Rows that are lost.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lost {
    /// None.
    None,
    /// The first row below each corner that is neither the uppermost nor the lowest.
    BelowMiddle,
    /// The last row above each.
    AboveMiddle,
    /// All below the second corner from above.
    LowerPart,
    /// All above the second corner from below.
    UpperPart,
}

struct Edge {
    top: Point,
    bottom: Point,
    first_row: i32,
    /// With what makes it start late or end late.
    rows: (i32, i32),
}

/// The spans of every row of a picture `height` rows high.
pub(super) fn spans(corners: &[Point], scan: &Scan, (width, height): (i32, i32)) -> Vec<Vec<(i32, i32)>> {
    let edges = edges(corners, scan);
    let mut heights: Vec<f64> = corners.iter().map(|corner| corner.1).collect();
    heights.sort_by(f64::total_cmp);
    let mut active: Vec<usize> = Vec::new();
    let row_of = |y: i32| {
        active.retain(|&edge| edges[edge].rows.1 > y);
        let x = |edge: usize| x_on(&edges[edge], y, scan, &heights);
        for (number, edge) in edges.iter().enumerate() {
            if edge.rows.1 <= y || edge.rows.0 > y || active.contains(&number) {
                continue;
            }
            let is_before = |&&other: &&usize| scan.first.column(x(other)) <= scan.first.column(x(number));
            let place = match scan.pairs {
                Pairs::KeptOrder => active.iter().take_while(is_before).count(),
                _ => active.len(),
            };
            active.insert(place, number);
        }
        let mut crossings: Vec<f64> = active.iter().map(|&edge| x(edge)).collect();
        match scan.pairs {
            Pairs::KeptOrder => {}
            Pairs::Unsorted => {
                let mut order: Vec<usize> = active.clone();
                order.sort_unstable();
                crossings = order.into_iter().map(x).collect();
            }
            Pairs::Rightly => {
                let right = Scan { slope: Slope::Exact, ahead: 0, ..*scan };
                let mut order = active.clone();
                order.sort_by(|&a, &b| {
                    let x = |edge: usize| x_on(&edges[edge], y, &right, &heights);
                    x(a).total_cmp(&x(b))
                });
                crossings = order.into_iter().map(x).collect();
            }
            Pairs::Once => {
                crossings.sort_by(f64::total_cmp);
                crossings.dedup();
            }
            _ => crossings.sort_by(f64::total_cmp),
        }
        if is_lost(y, &heights, scan.lost) { Vec::new() } else { paired(&crossings, scan, width) }
    };
    let mut rows: Vec<_> = (0..height).map(row_of).collect();
    if scan.spills {
        spill(&mut rows, width);
    }
    rows
}

/// Writes what lies beside a row to the rows beside it.
fn spill(rows: &mut [Vec<(i32, i32)>], width: i32) {
    for row in 0..rows.len() {
        for (first, end) in rows[row].clone() {
            if end > width && row + 1 < rows.len() {
                rows[row + 1].push(((first - width).max(0), end - width));
            }
            if first < 0 && row > 0 {
                rows[row - 1].push((first + width, (end + width).min(width)));
            }
        }
    }
}

fn edges(corners: &[Point], scan: &Scan) -> Vec<Edge> {
    let count = corners.len();
    let is_left_out = |number: usize, a: Point, b: Point| match scan.edges {
        Edges::All | Edges::ClosedToSecond | Edges::FromFirst => false,
        Edges::LastLost => number + 1 == count,
        Edges::FirstLost => number == 0,
        Edges::UpwardLost => a.1 > b.1,
        Edges::DownwardLost => a.1 < b.1,
        Edges::ShortLost => (a.1 - b.1).abs() < 1.0,
        Edges::NarrowLost => a.0 != b.0 && (a.0 - b.0).abs() < 1.0,
    };
    let edge = |(number, (&a, &b)): (usize, (&Point, &Point))| {
        let (a, b) = match scan.edges {
            Edges::ClosedToSecond if number + 1 == count => (a, corners[1]),
            Edges::FromFirst => (corners[0], b),
            _ => (a, b),
        };
        let (top, bottom) = if a.1 <= b.1 { (a, b) } else { (b, a) };
        let (up, down) = (top.1 - scan.row, bottom.1 - scan.row);
        let at_or_below = |y: f64| y.ceil() as i32;
        let below = |y: f64| y.floor() as i32 + 1;
        let (first_row, end_row) = match scan.owns {
            Owns::Upper => (at_or_below(up), at_or_below(down)),
            Owns::Both if up < down => (at_or_below(up), below(down)),
            Owns::Neither if up < down => (below(up), at_or_below(down)),
            Owns::Level if up == down => (at_or_below(up), below(up)),
            Owns::Level => (at_or_below(up), at_or_below(down)),
            Owns::Both | Owns::Neither => (0, 0),
        };
        let is_there = first_row < end_row && !is_left_out(number, a, b);
        let rows = (first_row + scan.starts_late, end_row.saturating_add(scan.ends_late));
        is_there.then_some(Edge { top, bottom, first_row, rows })
    };
    sides(corners).enumerate().filter_map(edge).collect()
}

/// Where an edge is thought to cross a row.
fn x_on(edge: &Edge, y: i32, scan: &Scan, heights: &[f64]) -> f64 {
    let (top, bottom) = (edge.top, edge.bottom);
    let (dx, dy) = (bottom.0 - top.0, bottom.1 - top.1);
    if dy == 0.0 {
        return top.0;
    }
    let y = y + scan.ahead;
    let exact = |y: i32| top.0 + dx * (f64::from(y) + scan.row - top.1) / dy;
    let steps = f64::from(y - edge.first_row);
    let slope = dx / dy;
    match scan.slope {
        Slope::Exact => exact(y),
        Slope::UpperEnd => top.0,
        Slope::LowerEnd => bottom.0,
        Slope::FirstRow => exact(edge.first_row),
        Slope::Cut => exact(edge.first_row) + slope.trunc() * steps,
        Slope::Down => exact(edge.first_row) + slope.floor() * steps,
        Slope::Rounded => exact(edge.first_row) + slope.round() * steps,
        Slope::TurnedOver => top.0 + (f64::from(y) + scan.row - top.1) * if dx == 0.0 { 0.0 } else { dy / dx },
        Slope::Reversed => top.0 - dx * (f64::from(y) + scan.row - top.1) / dy,
        Slope::FromEnd => top.0 + slope * steps,
        Slope::FromRow => top.0 + slope * (f64::from(y) - top.1.floor()),
        Slope::Summed(parts, is_cut, restarts) => {
            let begins = |height: &f64| (height - scan.row).ceil() as i32;
            let last = heights.iter().map(begins).filter(|&row| row <= y).max().filter(|_| restarts);
            let first = last.unwrap_or(edge.first_row).max(edge.first_row);
            let slope = if is_cut { (slope * parts).trunc() } else { (slope * parts).round() } / parts;
            let start = if is_cut { exact(first) } else { (exact(first) * parts).round() / parts };
            start + slope * f64::from(y - first)
        }
    }
}

fn is_lost(y: i32, heights: &[f64], lost: Lost) -> bool {
    let begins = |height: f64| (height - 0.5).ceil() as i32;
    let middle = &heights[1..heights.len() - 1];
    match (lost, middle) {
        (Lost::None, _) | (_, []) => false,
        (Lost::BelowMiddle, middle) => middle.iter().any(|&height| begins(height) == y),
        (Lost::AboveMiddle, middle) => middle.iter().any(|&height| begins(height) == y + 1),
        (Lost::LowerPart, [second, ..]) => y >= begins(*second),
        (Lost::UpperPart, [.., last]) => y < begins(*last),
    }
}

fn paired(crossings: &[f64], scan: &Scan, width: i32) -> Vec<(i32, i32)> {
    let mut columns: Vec<(i32, i32)> = crossings.iter().map(|&x| (scan.first.column(x), scan.end.column(x))).collect();
    match scan.pairs {
        Pairs::FirstOnly => columns.truncate(2),
        Pairs::LastOnly => drop(columns.drain(..columns.len().saturating_sub(2))),
        Pairs::Overlapping => columns = columns.windows(2).flatten().copied().collect(),
        Pairs::Sorted | Pairs::Unsorted | Pairs::KeptOrder | Pairs::Rightly | Pairs::Once => {}
    }
    if columns.len() % 2 == 1 {
        match scan.odd {
            Odd::Dropped => {}
            Odd::RunsOn => columns.push((width, width)),
            Odd::FromLeft => columns.insert(0, (0, 0)),
        }
    }
    let span = |pair: &[(i32, i32)]| {
        let (first, end) = (pair[0].0, pair[1].1);
        (first, if scan.is_never_empty && end == first { end + 1 } else { end })
    };
    columns.chunks_exact(2).map(span).collect()
}
