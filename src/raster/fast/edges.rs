//! Edges: which samples a convex polygon covers, by the signs of whole numbers.
//!
//! For an edge from P to Q, walked with the inside on the right, E(S) = (Q - P) x (S - P) is positive inside, negative outside and 0 on
//! the edge. Centers on an edge belong to the polygon on left and upper edges only, so 1 is taken from E on the others, and then
//! `E >= 0` for every edge says that a sample is covered: the same rule that [`crate::raster::coverage`] states with marks.
//!
//! Why the numbers stay small: all centers are congruent modulo 256 (coordinates are in 1/256 of a sample), so E at any center is E at the
//! tile's first center plus a multiple of 256, and E >= 0 exactly if `(E >> 8) + a dx + b dy >= 0` with whole steps of samples. The first is
//! computed once in 64 bits; held within +-2^30 it keeps its sign over the tile, as steps inside a tile stay below 2^29.
//!
//! Space: 1/256 of a sample; y runs down. Cost: two multiplications an edge and tile, one addition an edge and step of samples.

use super::bins::{BITS, MOST_EDGES};
use crate::screen::ScreenVertex;

/// Bound of E >> 8 at the first sample of a tile.
const CLAMP: i64 = 1 << 30;
/// Bound of the steps inside a tile: side times change per sample along both axes.
const MOST_STEPS: i64 = 1 << 28;

/// One edge over one tile: E >> 8 at the center of the tile's first sample, and its change per sample.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Edge {
    pub start: i32,
    pub right: i32,
    pub down: i32,
}

impl Edge {
    /// The edge from `from` to `to`, seen from the sample (x, y).
    #[inline(always)]
    pub fn new(from: [i32; 2], to: [i32; 2], (x, y): (i32, i32)) -> Edge {
        let (dx, dy) = (i64::from(to[0]) - i64::from(from[0]), i64::from(to[1]) - i64::from(from[1]));
        let center = |sample: i32| (i64::from(sample) << BITS) + (1 << (BITS - 1));
        let value = dx * (center(y) - i64::from(from[1])) - dy * (center(x) - i64::from(from[0]));
        // Walked with the inside on the right, left edges go up and upper edges go right.
        let keeps_centers = dy < 0 || (dy == 0 && dx > 0);
        let start = (value - i64::from(!keeps_centers)) >> BITS;
        Edge { start: start.clamp(-CLAMP, CLAMP) as i32, right: -dy as i32, down: dx as i32 }
    }
}

/// An outline of a few corners in 1/256 of a sample.
#[derive(Clone, Copy, Debug)]
pub(super) struct Outline {
    corners: [[i32; 2]; MOST_EDGES],
    count: usize,
    pub least: [i32; 2],
    pub most: [i32; 2],
}

impl Outline {
    /// `None` for an outline without corners. At most [`MOST_EDGES`], on a grid of at most 8 bits.
    #[inline(always)]
    pub fn new(vertices: &[ScreenVertex]) -> Option<Outline> {
        let [first, second, third] = vertices else { return Outline::of_many(vertices) };
        Some(Outline::of_three([corner(first), corner(second), corner(third)]))
    }

    /// A triangle.
    #[inline(always)]
    pub fn of_three([a, b, c]: [[i32; 2]; 3]) -> Outline {
        let least = [a[0].min(b[0]).min(c[0]), a[1].min(b[1]).min(c[1])];
        let most = [a[0].max(b[0]).max(c[0]), a[1].max(b[1]).max(c[1])];
        let mut corners = [[0; 2]; MOST_EDGES];
        (corners[0], corners[1], corners[2]) = (a, b, c);
        Outline { corners, count: 3, least, most }
    }

    // Not inlined where lanes are compiled: there the loop becomes gathers of eight corners, which take twice the time of binning.
    #[inline(never)]
    fn of_many(vertices: &[ScreenVertex]) -> Option<Outline> {
        let (mut least, mut most) = ([i32::MAX; 2], [i32::MIN; 2]);
        let mut corners = [[0; 2]; MOST_EDGES];
        let count = vertices.len().min(MOST_EDGES);
        for (place, vertex) in corners.iter_mut().zip(vertices) {
            let [x, y] = corner(vertex);
            least = [least[0].min(x), least[1].min(y)];
            most = [most[0].max(x), most[1].max(y)];
            *place = [x, y];
        }
        (count > 0).then_some(Outline { corners, count, least, most })
    }

    #[inline(always)]
    pub fn corners(&self) -> &[[i32; 2]] {
        &self.corners[..self.count]
    }

    /// Brings it into the form that edges are made of: no corner twice, inside on the right. Says whether it is convex; one without
    /// area loses all its corners.
    #[inline(always)]
    pub fn make_ready(&mut self) -> bool {
        if let &[a, b, c] = self.corners() {
            let [u, v] = [between(a, b), between(b, c)];
            let cross = u[0] * v[1] - u[1] * v[0];
            if cross < 0 {
                self.corners.swap(0, 2);
            }
            if cross == 0 {
                self.count = 0;
            }
            return true;
        }
        self.make_larger_ready()
    }

    fn make_larger_ready(&mut self) -> bool {
        self.drop_repeated();
        match turn(self.corners()) {
            Turn::Right => true,
            Turn::Left => {
                self.corners[..self.count].reverse();
                true
            }
            Turn::Flat => {
                self.count = 0;
                true
            }
            Turn::Both => false,
        }
    }

    /// Drops corners that are where the one before is.
    fn drop_repeated(&mut self) {
        let mut kept = 0;
        for index in 0..self.count {
            if kept == 0 || self.corners[index] != self.corners[kept - 1] {
                self.corners[kept] = self.corners[index];
                kept += 1;
            }
        }
        while kept > 1 && self.corners[kept - 1] == self.corners[0] {
            kept -= 1;
        }
        self.count = kept;
    }
}

#[inline(always)]
fn corner(vertex: &ScreenVertex) -> [i32; 2] {
    [fixed(vertex.x), fixed(vertex.y)]
}

/// A coordinate in 1/256 of a sample; exact on grids of up to 8 bits.
#[inline(always)]
fn fixed(snapped: f64) -> i32 {
    (snapped * f64::from(1 << BITS)) as i32
}

#[inline]
fn between(from: [i32; 2], to: [i32; 2]) -> [i64; 2] {
    [i64::from(to[0]) - i64::from(from[0]), i64::from(to[1]) - i64::from(from[1])]
}

/// Whether edge functions of an outline between `least` and `most` keep within 32 bits in tiles of `side` samples.
#[inline]
pub(super) fn are_in_range(least: [i32; 2], most: [i32; 2], side: i32) -> bool {
    let reach = MOST_STEPS / i64::from(side);
    // A picture has at most 2^22 samples of 2^8 steps.
    let held = |axis: usize| i64::from(least[axis]) > -CLAMP && i64::from(most[axis]) <= CLAMP;
    let [width, height] = between(least, most);
    held(0) && held(1) && width <= reach && height <= reach
}

/// How an outline turns.
enum Turn {
    Right,
    Left,
    /// All corners on a line: it has no inside.
    Flat,
    /// It is not convex, or goes around twice.
    Both,
}

fn turn(outline: &[[i32; 2]]) -> Turn {
    let count = outline.len();
    if count < 3 {
        return Turn::Flat;
    }
    let step = |index: usize| between(outline[index % count], outline[(index + 1) % count]);
    let (mut right, mut left, mut back, mut reversals) = (false, false, false, 0);
    let mut last_down = 0;
    for index in 0..=count {
        let ([x, y], [next_x, next_y]) = (step(index), step(index + 1));
        let cross = x * next_y - y * next_x;
        right |= cross > 0;
        left |= cross < 0;
        back |= cross == 0 && x * next_x + y * next_y < 0;
        if y != 0 {
            reversals += usize::from(last_down != 0 && (y > 0) != (last_down > 0));
            last_down = y;
        }
    }
    match (right, left) {
        // Flat triangles only: longer flat outlines may still cover nothing, but that is for the spans to say.
        (false, false) if count == 3 => Turn::Flat,
        // A convex outline goes down once and up once.
        (true, false) if !back && reversals <= 2 => Turn::Right,
        (false, true) if !back && reversals <= 2 => Turn::Left,
        _ => Turn::Both,
    }
}
