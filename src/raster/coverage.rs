//! Coverage: which samples a polygon covers, decided exactly.
//!
//! Every edge leaves a mark on each scan line it crosses; between the first and the second mark of a scan line, the
//! third and the fourth, ..., samples are covered (even-odd). A mark is a column: the first sample whose center is at
//! or right of the edge. Two polygons that share an edge compute the same mark from it, one as its right end (the
//! sample is not covered) and one as its left end (it is): no hole, no double.
//!
//! Why whole numbers: vertices lie on a grid, so the crossing of an edge with a scan line is a fraction of whole
//! numbers, and its ceiling is exact. No slope is ever rounded, nothing drifts.
//!
//! Without a grid (`--subpixel-bits exact`) the same question is answered from the homogeneous corners: `exact_edge`.
//!
//! Tie rule: a sample is covered when its center is at or right of the left edge, strictly left of the right edge, at or
//! below the top, strictly above the bottom.
//!
//! Space: samples; sample (i, j) has its center at (i + 0.5, j + 0.5).
//! Cost: one division an edge and scan line.

use super::exact_edge::ExactEdge;
use crate::math::edges;
use crate::screen::{Grid, ScreenVertex};
use std::ops::Range;

/// A mark on a scan line: the row, and the first column whose center is at or right of the edge.
type Mark = (i32, i32);

/// Finds covered spans; keeps its memory from polygon to polygon.
#[derive(Clone, Debug)]
pub struct Spans {
    marks: Vec<Mark>,
    columns: Range<i32>,
}

impl Default for Spans {
    /// Of polygons that lie inside the picture.
    fn default() -> Self {
        Spans { marks: Vec::new(), columns: i32::MIN..i32::MAX }
    }
}

impl Spans {
    /// Finds only what lies in these columns: polygons that are not snapped reach beyond the picture.
    #[must_use]
    pub fn within(columns: Range<i32>) -> Spans {
        Spans { columns, ..Spans::default() }
    }

    /// From now on finds only what lies in these columns.
    pub(super) fn limit(&mut self, columns: Range<i32>) {
        self.columns = columns;
    }

    /// Calls `span(row, columns)` for every run of covered samples of `outline` in `rows`, from the top row down and from
    /// left to right. Runs are never empty.
    pub fn of(
        &mut self,
        outline: &[ScreenVertex],
        grid: Grid,
        rows: Range<i32>,
        mut span: impl FnMut(i32, Range<i32>),
    ) {
        self.mark(outline, grid, rows);
        // Rows come out sorted, and the marks of a row from left to right. Every row has an even number of marks: a closed
        // outline that crosses a line comes back over it.
        self.marks.sort_unstable();
        for pair in self.marks.chunks_exact(2) {
            let [(row, first), (_, end)] = [pair[0], pair[1]];
            let (first, end) = (first.max(self.columns.start), end.min(self.columns.end));
            if first < end {
                span(row, first..end);
            }
        }
    }

    fn mark(&mut self, outline: &[ScreenVertex], grid: Grid, rows: Range<i32>) {
        self.marks.clear();
        for (start, end) in edges(outline) {
            let edge = Edge::downward(start, end, grid);
            let reach = edge.rows(grid);
            for row in reach.start.max(i64::from(rows.start))..reach.end.min(i64::from(rows.end)) {
                self.marks.push((row as i32, edge.first_column(row, grid) as i32));
            }
        }
    }
}

/// An edge, turned downward, so that it gives the same marks whichever way its polygon walks it.
#[derive(Clone, Copy, Debug)]
pub struct Edge(Ends);

#[derive(Clone, Copy, Debug)]
enum Ends {
    /// In grid steps.
    Snapped {
        top: (i64, i64),
        bottom: (i64, i64),
    },
    Exact(ExactEdge),
}

impl Edge {
    /// The edge between two neighboring corners.
    #[must_use]
    pub fn downward(start: &ScreenVertex, end: &ScreenVertex, grid: Grid) -> Edge {
        if grid.is_exact() {
            return Edge(Ends::Exact(ExactEdge::downward(start.homogeneous, end.homogeneous)));
        }
        let (top, bottom) = if start.y <= end.y { (start, end) } else { (end, start) };
        let fixed = |vertex: &ScreenVertex| (grid.fixed(vertex.x), grid.fixed(vertex.y));
        Edge(Ends::Snapped { top: fixed(top), bottom: fixed(bottom) })
    }

    /// The rows it crosses: centers at or below its top end, strictly above its bottom end; none for horizontal edges.
    #[must_use]
    pub fn rows(&self, grid: Grid) -> Range<i64> {
        match &self.0 {
            Ends::Snapped { top, bottom } => first_center_from(top.1, grid)..first_center_from(bottom.1, grid),
            Ends::Exact(edge) => edge.rows(),
        }
    }

    /// Samples to the right for every row down; infinite for horizontal edges.
    #[must_use]
    pub fn slope(&self) -> f64 {
        match &self.0 {
            Ends::Snapped { top, bottom } => (bottom.0 - top.0) as f64 / (bottom.1 - top.1) as f64,
            Ends::Exact(edge) => edge.slope(),
        }
    }

    /// Where it crosses the center line of `row`, in samples. Rounded: good for values, never for coverage.
    #[must_use]
    pub fn crossing(&self, row: i64, grid: Grid) -> f64 {
        let top = match &self.0 {
            Ends::Snapped { top, .. } => [top.0, top.1].map(|fixed| fixed as f64 / grid.steps() as f64),
            Ends::Exact(edge) => edge.start(),
        };
        top[0] + (row as f64 + 0.5 - top[1]) * self.slope()
    }

    /// The first column whose center is at or right of the edge on the center line of `row`.
    #[must_use]
    pub fn first_column(&self, row: i64, grid: Grid) -> i64 {
        let (top, bottom) = match &self.0 {
            Ends::Snapped { top, bottom } => (*top, *bottom),
            Ends::Exact(edge) => return edge.first_column(row),
        };
        let (dx, dy) = (bottom.0 - top.0, bottom.1 - top.1);
        // All in half grid steps, where centers are whole numbers even for a grid of whole samples.
        let down = (2 * row + 1) * grid.steps() - 2 * top.1;
        let right = 2 * top.0 - grid.steps();
        // The crossing is at x = top.x + down dx / (2 dy); the column is the ceiling of (2 x - steps) / (2 steps).
        if grid.bits <= 8 {
            // At most 2^22 samples of 2^8 steps: the numerator stays below 2^63 (`the_largest_picture_does_not_overflow`).
            return ceiling(right * dy + down * dx, 2 * grid.steps() * dy);
        }
        let numerator = i128::from(right) * i128::from(dy) + i128::from(down) * i128::from(dx);
        let denominator = i128::from(2 * grid.steps()) * i128::from(dy);
        -((-numerator).div_euclid(denominator)) as i64
    }
}

/// The first sample whose center is at or after a coordinate in grid steps: the ceiling of `fixed / steps - 1/2`.
fn first_center_from(fixed: i64, grid: Grid) -> i64 {
    ceiling(2 * fixed - grid.steps(), 2 * grid.steps())
}

/// The least whole number that is not below `numerator / denominator`; the denominator is positive.
fn ceiling(numerator: i64, denominator: i64) -> i64 {
    -(-numerator).div_euclid(denominator)
}

/// Whether `outline` covers the sample (x, y): the same rule, one sample at a time.
///
/// Counts the edges that cross the sample's scan line left of its center or through it: an odd number means inside.
#[must_use]
pub fn covers(outline: &[ScreenVertex], grid: Grid, x: i32, y: i32) -> bool {
    let (column, row) = (i64::from(x), i64::from(y));
    let left_of_center = edges(outline).filter(|&(start, end)| {
        let edge = Edge::downward(start, end, grid);
        edge.rows(grid).contains(&row) && edge.first_column(row, grid) <= column
    });
    left_of_center.count() % 2 == 1
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Vec3;
    use crate::screen::EdgeKind;

    const GRID: Grid = Grid { bits: 8 };

    fn outline(corners: &[(f64, f64)]) -> Vec<ScreenVertex> {
        let vertex =
            |&(x, y): &(f64, f64)| ScreenVertex { x, y, homogeneous: Vec3::new(x, y, 1.0), edge: EdgeKind::Original };
        corners.iter().map(vertex).collect()
    }

    fn drawn(corners: &[(f64, f64)]) -> Vec<String> {
        let mut picture = vec![vec!['.'; 6]; 6];
        Spans::default().of(&outline(corners), GRID, 0..6, |row, columns| {
            columns.for_each(|column| picture[row as usize][column as usize] = '#');
        });
        picture.into_iter().map(String::from_iter).collect()
    }

    #[test]
    fn left_and_top_edges_through_centers_belong_to_the_polygon() {
        let square = [(1.5, 1.5), (4.5, 1.5), (4.5, 4.5), (1.5, 4.5)];
        assert_eq!(drawn(&square), ["......", ".###..", ".###..", ".###..", "......", "......"]);
    }

    #[test]
    fn a_concave_polygon_leaves_its_notch_open() {
        let notch = [(0.0, 0.0), (6.0, 0.0), (6.0, 6.0), (3.0, 2.0), (0.0, 6.0)];
        assert_eq!(drawn(&notch), ["######", "######", "######", "##..##", "#....#", "......"]);
    }

    #[test]
    fn orientation_does_not_matter() {
        let mut corners = vec![(0.3, 0.2), (5.1, 1.7), (2.2, 5.9)];
        let forward = drawn(&corners);
        corners.reverse();
        assert_eq!(drawn(&corners), forward);
    }

    #[test]
    fn the_largest_picture_does_not_overflow() {
        let side = f64::from(1 << 22);
        let huge = outline(&[(0.0, 0.0), (side, side), (0.0, side)]);
        let row = (1 << 22) - 1;
        let mut seen = Vec::new();
        Spans::default().of(&huge, GRID, row..row + 1, |row, columns| seen.push((row, columns)));
        assert_eq!(seen, [(row, 0..row)]);
        let falling = outline(&[(side, 0.0), (0.0, side), (side, side)]);
        seen.clear();
        Spans::default().of(&falling, GRID, row..row + 1, |row, columns| seen.push((row, columns)));
        assert_eq!(seen, [(row, 0..1 << 22)]);
    }
}
