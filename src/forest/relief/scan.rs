//! Scan: the samples under one triangle, row by row, and how far they are from its plane.
//!
//! All edges run along rows, columns or diagonals, so the ends of a row are whole numbers and every sample on an edge is found from both
//! sides. Legs are powers of two and heights have 24 bits, so planes and distances in `f64` are exact for whole metres.
//!
//! Cost: about a nanosecond a sample.

use super::lattice::{Point, Triangle};
use crate::forest::elevation::Grid;

/// The plane through three corners with heights.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    origin: Point,
    height: f64,
    /// Metres a column and a row.
    slope: [f64; 2],
}

impl Plane {
    /// The plane of a triangle whose `a`, `b` and `apex` have these heights, in metres.
    #[must_use]
    #[inline]
    pub fn new(triangle: &Triangle, [a, b, apex]: [f64; 3]) -> Plane {
        let Triangle { a: pa, b: pb, apex: origin } = *triangle;
        let from = |p: Point| (f64::from(p.x) - f64::from(origin.x), f64::from(p.y) - f64::from(origin.y));
        let ((ax, ay), (bx, by)) = (from(pa), from(pb));
        let (rise_a, rise_b) = (a - apex, b - apex);
        // The legs are as long as each other and at right angles: the determinant is a power of two.
        let determinant = ax * by - bx * ay;
        let slope = [(rise_a * by - rise_b * ay) / determinant, (ax * rise_b - bx * rise_a) / determinant];
        Plane { origin, height: apex, slope }
    }

    /// Its height there.
    #[must_use]
    #[inline]
    pub fn at(&self, x: u32, y: u32) -> f64 {
        let (dx, dy) = (f64::from(x) - f64::from(self.origin.x), f64::from(y) - f64::from(self.origin.y));
        self.height + (self.slope[0] * dx + self.slope[1] * dy)
    }
}

/// Calls `visit` with every row of samples under `triangle`, edges and corners included, that lies within the grid: row, first column,
/// last column.
#[inline]
pub fn rows(triangle: &Triangle, (east, south): (u32, u32), mut visit: impl FnMut(u32, u32, u32)) {
    let corners = [triangle.a, triangle.b, triangle.apex];
    let top = corners[0].y.min(corners[1].y).min(corners[2].y);
    let bottom = corners[0].y.max(corners[1].y).max(corners[2].y).min(south);
    for y in top..=bottom {
        let (mut first, mut last) = (u32::MAX, 0);
        for edge in [(corners[0], corners[1]), (corners[1], corners[2]), (corners[2], corners[0])] {
            let (upper, lower) = if edge.0.y <= edge.1.y { edge } else { (edge.1, edge.0) };
            if y < upper.y || y > lower.y || upper.y == lower.y {
                continue;
            }
            // Its slope is -1, 0 or 1.
            let along = y - upper.y;
            let x = match lower.x.cmp(&upper.x) {
                std::cmp::Ordering::Less => upper.x - along,
                std::cmp::Ordering::Equal => upper.x,
                std::cmp::Ordering::Greater => upper.x + along,
            };
            (first, last) = (first.min(x), last.max(x));
        }
        if first <= east {
            visit(y, first, last.min(east));
        }
    }
}

/// How far samples are from a plane.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Distances {
    /// The largest distance, in metres.
    pub largest: f64,
    /// The sum of squares, in square metres.
    pub squares: f64,
    /// Samples with a height.
    pub known: u64,
    /// Samples without.
    pub void: u64,
}

impl Distances {
    /// Some of the samples have a height and some have none: no triangle over them can be right.
    #[must_use]
    pub fn is_mixed(&self) -> bool {
        self.known > 0 && self.void > 0
    }
}

/// The largest distance of the samples under `triangle` from the plane of its corners; infinite where only some are voids, 0 where all are.
#[must_use]
#[inline]
pub fn largest_distance(grid: &Grid, triangle: &Triangle, heights: [f64; 3], has_voids: bool) -> f64 {
    if has_voids {
        let found = distances(grid, triangle, heights);
        let plane_is_void = heights.iter().any(|height| height.is_nan());
        return if found.is_mixed() || (plane_is_void && found.known > 0) { f64::INFINITY } else { found.largest };
    }
    let plane = Plane::new(triangle, heights);
    let limits = (grid.columns() as u32 - 1, grid.rows() as u32 - 1);
    let mut largest = 0.0_f64;
    rows(triangle, limits, |y, first, last| {
        let start = plane.at(first, y);
        let slope = plane.slope[0];
        let samples = &grid.row(y as usize)[first as usize..=last as usize];
        let mut column = 0.0;
        for &sample in samples {
            let distance = (f64::from(sample) - (start + slope * column)).abs();
            largest = if distance > largest { distance } else { largest };
            column += 1.0;
        }
    });
    largest
}

/// All there is to know about the samples under `triangle` and the plane of its corners.
#[must_use]
pub fn distances(grid: &Grid, triangle: &Triangle, heights: [f64; 3]) -> Distances {
    let plane = Plane::new(triangle, heights);
    let limits = (grid.columns() as u32 - 1, grid.rows() as u32 - 1);
    let mut found = Distances::default();
    rows(triangle, limits, |y, first, last| {
        let samples = &grid.row(y as usize)[first as usize..=last as usize];
        for (x, &sample) in (first..).zip(samples) {
            if sample.is_nan() {
                found.void += 1;
                continue;
            }
            let distance = (f64::from(sample) - plane.at(x, y)).abs();
            found.known += 1;
            found.squares += distance * distance;
            found.largest = found.largest.max(distance);
        }
    });
    found
}

#[cfg(test)]
mod tests {
    use super::super::lattice::Lattice;
    use super::*;
    use crate::forest::elevation::{Frame, Unit};

    #[test]
    fn every_sample_lies_under_the_triangles_that_hold_it() {
        let lattice = Lattice { side: 16, east: 13, south: 16 };
        let mut stack = lattice.roots().to_vec();
        while let Some(triangle) = stack.pop() {
            // By signs of turns, which knows nothing of diagonals.
            let turn = |p: Point, q: Point, x: i64, y: i64| {
                let side = |a: u32, b: u32| i64::from(a) - i64::from(b);
                side(q.x, p.x) * (y - i64::from(p.y)) - side(q.y, p.y) * (x - i64::from(p.x))
            };
            let corners = [triangle.a, triangle.b, triangle.apex];
            let holds = |x: u32, y: u32| {
                let turns = [0, 1, 2].map(|i| turn(corners[i], corners[(i + 1) % 3], i64::from(x), i64::from(y)));
                turns.iter().all(|&turn| turn >= 0) || turns.iter().all(|&turn| turn <= 0)
            };
            let expected: Vec<_> =
                (0..=16).flat_map(|y| (0..=13).map(move |x| (x, y))).filter(|&(x, y)| holds(x, y)).collect();
            let mut found = Vec::new();
            rows(&triangle, (13, 16), |y, first, last| found.extend((first..=last).map(|x| (x, y))));
            assert_eq!(found, expected, "{triangle:?}");
            if triangle.can_be_halved() {
                stack.extend(triangle.halves());
            }
        }
    }

    #[test]
    fn a_plane_is_at_no_distance_and_a_spike_at_its_own() {
        let frame = Frame { unit: Unit::Metres, west: 0.0, north: 0.0, step: [1.0, 1.0] };
        let mut heights: Vec<f32> = (0..81).map(|at| (3 * (at % 9) - 2 * (at / 9)) as f32).collect();
        let corners =
            |heights: &[f32], t: &Triangle| [t.a, t.b, t.apex].map(|p| f64::from(heights[(p.y * 9 + p.x) as usize]));
        for spike in [0.0, 7.5] {
            heights[2 * 9 + 5] += spike;
            let grid = Grid::new("", (9, 9), heights.clone(), frame).expect("9 x 9");
            let [upper, lower] = Lattice::new(&grid).roots();
            assert_eq!(largest_distance(&grid, &upper, corners(&heights, &upper), false), f64::from(spike));
            assert_eq!(largest_distance(&grid, &lower, corners(&heights, &lower), true), 0.0);
            assert_eq!(distances(&grid, &upper, corners(&heights, &upper)).squares, f64::from(spike * spike));
        }
    }
}
