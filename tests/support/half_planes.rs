//! Which samples a polygon covers, by another way than `farop::raster`: signs of integer edge functions, no division.
//!
//! A triangle is three half-planes. A sample on the line of an edge belongs to it on left and on upper edges. An outline
//! of any form is decided by a ray straight up from a point a hair right of the sample's center, and a hair of a hair
//! below it: such a point is never on an edge, and that is all the tie rule says.
//!
//! Nothing here is shared with the rasterizers; `tests/architecture.rs` could not tell, so the reader should.
//!
//! Space: half grid steps, x right, y down. Then centers are whole numbers on every grid: sample i is at (2 i + 1) steps.
//! Cost: three sums a sample one by one, or a binary search an edge and row. Pictures of 4096 samples a side and 16
//! sub-pixel bits need 2^29 half steps, edge functions stay below 2^60.

use std::ops::Range;

/// A corner, in half grid steps.
pub type Point = (i64, i64);

/// Covered columns of one row.
pub type Span = (i32, Range<i32>);

/// Twice the area of a, b, p: positive where p lies to the right of a -> b for somebody who walks there (y is down).
pub fn side(a: Point, b: Point, p: Point) -> i64 {
    (b.0 - a.0) * (p.1 - a.1) - (b.1 - a.1) * (p.0 - a.0)
}

/// The first and the last sample along one axis whose center can lie between two coordinates, one more at both ends.
pub fn reach(low: i64, high: i64, steps: i64) -> Range<i32> {
    ((low / (2 * steps)) as i32 - 1).max(0)..(high / (2 * steps)) as i32 + 2
}

/// Center of a sample along one axis.
pub fn center(sample: i32, steps: i64) -> i64 {
    (2 * i64::from(sample) + 1) * steps
}

/// What was found in a polygon besides its samples.
#[derive(Clone, Copy, Default)]
pub struct Ties {
    /// Pairs of a sample and an edge (or corner) of its polygon that it lies exactly on.
    pub on_edges: u64,
    /// Samples that were decided one by one.
    pub one_by_one: u64,
}

/// A triangle as three half-planes.
pub struct HalfPlanes {
    steps: i64,
    edges: [Edge; 3],
    rows: Range<i32>,
    columns: Range<i32>,
    /// No area: covers nothing.
    flat: bool,
}

/// The line of an edge with the inside on the positive side.
#[derive(Clone, Copy)]
struct Edge {
    from: Point,
    to: Point,
    /// The least value of `side` that belongs to the triangle: 0 on left and upper edges, 1 on the others.
    least: i64,
}

impl Edge {
    fn new(from: Point, to: Point) -> Edge {
        // Inside is to the right of the walk: an edge that goes up is a left one, one that goes right an upper one.
        let owned = to.1 < from.1 || (to.1 == from.1 && to.0 > from.0);
        Edge { from, to, least: i64::from(!owned) }
    }

    fn at(&self, p: Point) -> i64 {
        side(self.from, self.to, p)
    }

    /// Columns of `range` at height `y` whose value is at least `least`: a run from or to one end, found by halving.
    fn columns(&self, y: i64, steps: i64, range: Range<i32>, least: i64) -> Range<i32> {
        let holds = |column: i32| self.at((center(column, steps), y)) >= least;
        let rising = self.to.1 < self.from.1;
        if self.to.1 == self.from.1 {
            return if holds(range.start) { range } else { range.start..range.start };
        }
        // The first column that answers otherwise than the left end does at minus infinity.
        let (mut low, mut high) = (range.start, range.end);
        while low < high {
            let middle = low + (high - low) / 2;
            if holds(middle) == rising { high = middle } else { low = middle + 1 }
        }
        if rising { low..range.end } else { range.start..low }
    }
}

impl HalfPlanes {
    /// The triangle of three corners on a grid of `steps` steps a sample; either orientation.
    pub fn new(corners: [Point; 3], steps: i64) -> HalfPlanes {
        let [a, b, c] = corners;
        let area = side(a, b, c);
        let [a, b, c] = if area < 0 { [a, c, b] } else { [a, b, c] };
        let span = |axis: fn(&Point) -> i64| {
            let values = corners.each_ref().map(axis);
            reach(values.into_iter().min().unwrap_or(0), values.into_iter().max().unwrap_or(0), steps)
        };
        let edges = [Edge::new(a, b), Edge::new(b, c), Edge::new(c, a)];
        HalfPlanes { steps, edges, rows: span(|p| p.1), columns: span(|p| p.0), flat: area == 0 }
    }

    /// Rows and columns outside of which nothing is covered.
    pub fn bounds(&self) -> (Range<i32>, Range<i32>) {
        (self.rows.clone(), self.columns.clone())
    }

    /// Whether the sample is covered.
    pub fn covers(&self, x: i32, y: i32) -> bool {
        let p = (center(x, self.steps), center(y, self.steps));
        !self.flat && self.edges.iter().all(|edge| edge.at(p) >= edge.least)
    }

    /// Tests every sample of the bounds and counts those where `is_drawn` is wrong.
    pub fn wrong_one_by_one(&self, drawn: &[Span], ties: &mut Ties) -> u64 {
        let mut wrong = 0;
        let mut drawn = drawn.iter().peekable();
        let step = self.edges.map(|edge| -(edge.to.1 - edge.from.1) * 2 * self.steps);
        for y in self.rows.clone() {
            let columns = drawn.next_if(|(row, _)| *row == y).map_or(0..0, |(_, columns)| columns.clone());
            let start = (center(self.columns.start, self.steps), center(y, self.steps));
            let mut values = self.edges.map(|edge| edge.at(start));
            for x in self.columns.clone() {
                let [a, b, c] = values;
                let is_covered =
                    !self.flat && (a >= self.edges[0].least) & (b >= self.edges[1].least) & (c >= self.edges[2].least);
                wrong += u64::from(is_covered != columns.contains(&x));
                if a.min(b).min(c) == 0 {
                    ties.on_edges += u64::from(a == 0) + u64::from(b == 0) + u64::from(c == 0);
                }
                values = [a + step[0], b + step[1], c + step[2]];
            }
            ties.one_by_one += self.columns.len() as u64;
        }
        // What is drawn in rows beyond the bounds.
        wrong + drawn.map(|(_, columns)| columns.len() as u64).sum::<u64>()
    }

    /// The covered columns of row `y`, by halving.
    pub fn row(&self, y: i32, ties: &mut Ties) -> Range<i32> {
        if self.flat {
            return 0..0;
        }
        let height = center(y, self.steps);
        let within = |closed: bool| {
            self.edges.iter().fold(self.columns.clone(), |all, edge| {
                let least = if closed { 0 } else { edge.least };
                let columns = edge.columns(height, self.steps, self.columns.clone(), least);
                all.start.max(columns.start)..all.end.min(columns.end)
            })
        };
        let (covered, closed) = (within(false), within(true));
        // Ties are at the ends of the closed run, or all along it on a horizontal edge.
        for edge in &self.edges {
            let on_edge = |&x: &i32| edge.at((center(x, self.steps), height)) == 0;
            ties.on_edges += if edge.from.1 == edge.to.1 {
                closed.clone().filter(on_edge).count() as u64
            } else {
                let last = (closed.len() > 1).then(|| closed.end - 1);
                closed.clone().next().into_iter().chain(last).filter(on_edge).count() as u64
            };
        }
        if covered.start < covered.end { covered } else { 0..0 }
    }
}

/// Whether a closed outline of any form covers a sample, by the even-odd rule and a ray straight up.
pub fn outline_covers(outline: &[Point], steps: i64, (x, y): (i32, i32)) -> bool {
    let p = (center(x, steps), center(y, steps));
    let mut inside = false;
    for (i, &from) in outline.iter().enumerate() {
        let to = outline[(i + 1) % outline.len()];
        let (left, right) = if from.0 <= to.0 { (from, to) } else { (to, from) };
        // A hair to the right: an edge that starts at this x is met, one that ends here is not, a vertical one never.
        if !(left.0 <= p.0 && p.0 < right.0) {
            continue;
        }
        // Where the point is on the edge: the hair to the right leaves it below an edge that rises, above one that falls;
        // below a horizontal one by the hair down.
        let below = side(left, right, p);
        inside ^= below > 0 || (below == 0 && right.1 <= left.1);
    }
    inside
}

/// The covered spans of an outline row by row: by a ray a sample where that is cheap, else by halving.
pub fn outline_spans(outline: &[Point], steps: i64, ties: &mut Ties) -> Vec<Span> {
    let bound = |axis: fn(&Point) -> i64| {
        reach(outline.iter().map(axis).min().unwrap_or(0), outline.iter().map(axis).max().unwrap_or(0), steps)
    };
    let (columns, rows) = (bound(|p| p.0), bound(|p| p.1));
    let one_by_one = columns.len() * rows.len() * outline.len() < 1 << 18;
    let mut spans = Vec::new();
    for y in rows {
        if one_by_one {
            ties.one_by_one += columns.len() as u64;
            for x in columns.clone().filter(|&x| outline_covers(outline, steps, (x, y))) {
                push_span(&mut spans, y, x..x + 1);
            }
        } else {
            outline_row(outline, steps, y, &columns, &mut spans);
        }
    }
    spans
}

/// Where each edge is passed, in order: covered between the first and the second, the third and the fourth.
fn outline_row(outline: &[Point], steps: i64, y: i32, columns: &Range<i32>, spans: &mut Vec<Span>) {
    let height = center(y, steps);
    let mut passed: Vec<i32> = Vec::new();
    for (i, &from) in outline.iter().enumerate() {
        let to = outline[(i + 1) % outline.len()];
        let (low, high) = if from.1 > to.1 { (from, to) } else { (to, from) };
        // Walked upward, inside to the right; a center at the upper end is met, one at the lower end is not.
        if high.1 <= height && height < low.1 {
            passed.push(Edge { from: low, to: high, least: 0 }.columns(height, steps, columns.clone(), 0).start);
        }
    }
    passed.sort_unstable();
    for pair in passed.chunks_exact(2).filter(|pair| pair[0] < pair[1]) {
        push_span(spans, y, pair[0]..pair[1]);
    }
}

/// Appends a run, as part of the last one if it goes on where that ends.
pub fn push_span(spans: &mut Vec<Span>, row: i32, columns: Range<i32>) {
    match spans.last_mut() {
        Some((last_row, last)) if *last_row == row && last.end == columns.start => last.end = columns.end,
        _ => spans.push((row, columns)),
    }
}
