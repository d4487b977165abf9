//! Land: which patch of a cell a position belongs to, exactly and fast.
//!
//! Cell -LAND-> the patch at a position -> place; -FILL-> runs of texels -> cover
//!
//! Why squares first: a cell has thousands of trees and a dozen patches. Squares that no outline passes have one owner, found once; only trees in
//! the others ask the outlines themselves. Both ways ask [`polygon`](super::polygon)'s exact question, so the squares change speed, not answers.
//!
//! Space: metres in the cell; squares and texels count columns from the west and *rows from the south*.
//! Cost: 32 x 32 squares a cell; a run costs one exact test or two.

use super::area::{Cell, Patch};
use super::polygon::{Point, contains, turn};
use crate::math::edges;
use std::cmp::Ordering;
use std::ops::Range;

/// Squares along a side of a cell.
pub(super) const SQUARES: usize = 32;
/// A square that an outline passes.
const MIXED: u16 = u16::MAX;
/// Metres that trees keep from the edge of a road.
const VERGE: f64 = 0.5;
/// Metres by which an outline may be somewhere else than computed when squares are marked; far more than it is.
const SLACK: f64 = 1e-6;

/// The owners of a cell's squares.
pub(super) struct Land<'a> {
    patches: &'a [Patch],
    boxes: Vec<[Point; 2]>,
    /// Patch + 1, 0 for none, or [`MIXED`].
    squares: Vec<u16>,
    /// Pieces of roads and rivers, with the half width that they keep free.
    lines: Vec<(Point, Point, f64)>,
    /// Squares that a line may reach.
    near_line: Vec<bool>,
    per_metre: f64,
}

impl<'a> Land<'a> {
    /// Looks at all patches of a cell of this side; at most 65,534 of them count.
    pub(super) fn new(cell: &'a Cell, side: f64) -> Land<'a> {
        let patches = &cell.patches[..cell.patches.len().min(usize::from(MIXED) - 1)];
        let mut squares = vec![0; SQUARES * SQUARES];
        for (index, patch) in patches.iter().enumerate() {
            let paint = |row: usize, columns: Range<usize>| {
                squares[row * SQUARES..][columns].fill(index as u16 + 1);
            };
            fill(rings(patch), side, SQUARES, paint);
        }
        let per_metre = SQUARES as f64 / side;
        let boxes = patches.iter().map(|patch| bounds(&patch.outer)).collect();
        let pieces = cell
            .lines
            .iter()
            .flat_map(|line| line.points.windows(2).map(move |pair| (pair[0], pair[1], 0.5 * line.width + VERGE)));
        let near_line = vec![false; if cell.lines.is_empty() { 0 } else { SQUARES * SQUARES }];
        let mut land = Land { patches, boxes, squares, lines: pieces.collect(), near_line, per_metre };
        land.mark_lines();
        for patch in patches {
            rings(patch).flat_map(edges).for_each(|(&a, &b)| land.mark(a, b));
        }
        land
    }

    /// Marks the squares that an edge passes, and perhaps a few more.
    fn mark(&mut self, a: Point, b: Point) {
        let column = |metres: f64| ((metres * self.per_metre) as isize).clamp(0, SQUARES as isize - 1) as usize;
        let (lower, upper) = if a[1] <= b[1] { (a, b) } else { (b, a) };
        for row in column(lower[1] - SLACK)..=column(upper[1] + SLACK) {
            let (south, north) = (row as f64 / self.per_metre, (row + 1) as f64 / self.per_metre);
            let at = |y: f64| {
                let height = upper[1] - lower[1];
                let share = if height > 0.0 { ((y - lower[1]) / height).clamp(0.0, 1.0) } else { 0.0 };
                lower[0] + (upper[0] - lower[0]) * share
            };
            let level = upper[1] - lower[1] < 2.0 * SLACK;
            let ends = if level { [lower[0], upper[0]] } else { [at(south - SLACK), at(north + SLACK)] };
            // A slanted edge moves in x by more than the slack in y: take the ends where the row was widened, and widen them too.
            let (west, east) = (ends[0].min(ends[1]) - SLACK, ends[0].max(ends[1]) + SLACK);
            self.squares[row * SQUARES..][column(west)..=column(east)].fill(MIXED);
        }
    }

    /// Marks the squares in the boxes around the pieces of lines.
    fn mark_lines(&mut self) {
        let per_metre = self.per_metre;
        let square = |metres: f64| ((metres * per_metre) as usize).min(SQUARES - 1);
        for &(a, b, half) in &self.lines {
            let range = |axis: usize| square(a[axis].min(b[axis]) - half)..=square(a[axis].max(b[axis]) + half);
            for row in range(1) {
                self.near_line[row * SQUARES..][range(0)].fill(true);
            }
        }
    }

    /// Whether a road or a river is here.
    pub(super) fn is_on_line(&self, point: Point) -> bool {
        let [column, row] = point.map(|metres| ((metres * self.per_metre) as usize).min(SQUARES - 1));
        let is_near = self.near_line.get(row * SQUARES + column).is_some_and(|near| *near);
        is_near && self.lines.iter().any(|&(a, b, half)| square_distance(point, a, b) < half * half)
    }

    /// The patch that owns a position: the last one that contains it.
    pub(super) fn patch_at(&self, point: Point) -> Option<usize> {
        let [column, row] = point.map(|metres| ((metres * self.per_metre) as usize).min(SQUARES - 1));
        match self.squares[row * SQUARES + column] {
            MIXED => {
                let inside = |index: &usize| {
                    let [low, high] = self.boxes[*index];
                    let is_near = (0..2).all(|axis| low[axis] <= point[axis] && point[axis] <= high[axis]);
                    is_near && contains(&self.patches[*index].outer, &self.patches[*index].holes, point)
                };
                (0..self.patches.len()).rev().find(inside)
            }
            owner => usize::from(owner).checked_sub(1),
        }
    }

    /// For a block of squares: those patches of which some part may lie in it.
    pub(super) fn patches_in(&self, columns: Range<usize>, rows: Range<usize>) -> impl Iterator<Item = usize> {
        let metres = |square: usize| square as f64 / self.per_metre;
        let block = [[metres(columns.start), metres(rows.start)], [metres(columns.end), metres(rows.end)]];
        let owners = rows.flat_map(|row| self.squares[row * SQUARES..][columns.clone()].iter().copied());
        let mut seen: Vec<u16> = owners.collect();
        seen.sort_unstable();
        seen.dedup();
        let is_mixed = seen.last() == Some(&MIXED);
        (0..self.patches.len()).filter(move |&index| {
            let [low, high] = self.boxes[index];
            let overlaps = (0..2).all(|axis| low[axis] <= block[1][axis] && block[0][axis] <= high[axis]);
            overlaps && (is_mixed || seen.contains(&(index as u16 + 1)))
        })
    }
}

/// Square of the distance of a point from a piece of line.
fn square_distance(point: Point, a: Point, b: Point) -> f64 {
    let along = [b[0] - a[0], b[1] - a[1]];
    let off = [point[0] - a[0], point[1] - a[1]];
    let square = along[0] * along[0] + along[1] * along[1];
    let share = if square > 0.0 { ((off[0] * along[0] + off[1] * along[1]) / square).clamp(0.0, 1.0) } else { 0.0 };
    let left = [off[0] - share * along[0], off[1] - share * along[1]];
    left[0] * left[0] + left[1] * left[1]
}

/// The outline of a patch and its holes.
pub(super) fn rings(patch: &Patch) -> impl Iterator<Item = &[Point]> {
    std::iter::once(patch.outer.as_slice()).chain(patch.holes.iter().map(Vec::as_slice))
}

/// The corners of the smallest box around points.
fn bounds(points: &[Point]) -> [Point; 2] {
    let fold = |start: f64, choose: fn(f64, f64) -> f64| {
        [0, 1].map(|axis| points.iter().map(|point| point[axis]).fold(start, choose))
    };
    [fold(f64::INFINITY, f64::min), fold(f64::NEG_INFINITY, f64::max)]
}

/// Hands out the runs of texels, `count` along each side, whose centers are in a polygon; rows from the south.
///
/// Exactly those: where the outline passes a row, the column is found in `f64` and corrected with exact turns.
pub(super) fn fill<'a>(
    rings: impl Iterator<Item = &'a [Point]>,
    side: f64,
    count: usize,
    mut paint: impl FnMut(usize, Range<usize>),
) {
    let mut hits: Vec<(u32, u32)> = Vec::new();
    for (&a, &b) in rings.flat_map(edges) {
        cross_rows(a, b, side, count, &mut hits);
    }
    hits.sort_unstable();
    // A texel is inside when an odd number of edges is to the right of it: between the first and the second hit of its row, and so on.
    for pair in hits.chunks_exact(2) {
        let [(row, west), (_, east)] = [pair[0], pair[1]];
        if west < east {
            paint(row as usize, west as usize..east as usize);
        }
    }
}

/// For every row whose middle an edge crosses: how many texel centers are left of it.
fn cross_rows(a: Point, b: Point, side: f64, count: usize, hits: &mut Vec<(u32, u32)>) {
    let center = |index: usize| center_of(index, side, count);
    let (lower, upper) = if a[1] < b[1] { (a, b) } else { (b, a) };
    let first_not_below = |y: f64| {
        let mut row = ((y / side * count as f64) as usize).min(count);
        while row > 0 && center(row - 1) >= y {
            row -= 1;
        }
        while row < count && center(row) < y {
            row += 1;
        }
        row
    };
    for row in first_not_below(lower[1])..first_not_below(upper[1]) {
        let y = center(row);
        let is_left = |column: usize| turn(lower, upper, [center(column), y]) == Ordering::Greater;
        let x = lower[0] + (upper[0] - lower[0]) * ((y - lower[1]) / (upper[1] - lower[1]));
        let mut column = ((x / side * count as f64) as usize).min(count);
        while column > 0 && !is_left(column - 1) {
            column -= 1;
        }
        while column < count && is_left(column) {
            column += 1;
        }
        hits.push((row as u32, column as u32));
    }
}

/// The center of a texel along one axis, in metres.
pub(super) fn center_of(index: usize, side: f64, count: usize) -> f64 {
    (index as f64 + 0.5) * side / count as f64
}
