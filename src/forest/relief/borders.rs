//! Borders: triangles that wear one cover each, and how far from a border the wrong cover may show.
//!
//! Grid, cover of every sample -BORDERS-> cover of a triangle, bound of every diamond -> criterion, mesh
//!
//! A triangle of the relief wears the cover of one place in it (in *faithful* ground). Places on the other side of a border between covers
//! are wrong then. The error of a triangle is the largest distance of a wrong place from the nearest border; it is bounded twice:
//!
//! - The way from a wrong place to the place whose cover is worn stays in the triangle and crosses a border. So no wrong place is farther
//!   from one than from the place asked: half the hypotenuse, for its middle.
//! - A wrong *sample* is no farther from a border than from the nearest sample with another cover. And no place of a triangle is farther than
//!   half the diagonal of a square from some sample of it: a right one, with a border between, or a wrong one.
//!
//! The smaller of both counts. The bound of a diamond is the largest error of its triangles and of all diamonds below, as for heights: what is
//! halved above a limit makes a mesh without cracks. Both arguments ask for nothing but covers at samples, so it does not matter
//! what says them: polygons, however they overlap, or a raster.
//!
//! What is smaller than the tolerance may be missed altogether: all of it is near a border.
//!
//! Space: lattice points; metres on the map. Source: ours. Cost: every sample once a level, and four visits of each for the distances.

use super::criterion::Criterion;
use super::lattice::{Field, Lattice, Point, Triangle};
use super::scan::rows;
use crate::forest::elevation::Grid;

/// Covers at samples, and what triangles that wear one of them are wrong by.
#[derive(Clone, Debug)]
pub struct Borders {
    lattice: Lattice,
    spacing: [f64; 2],
    /// Rows from the north, as heights.
    covers: Vec<u8>,
    /// Metres to the nearest known sample of another cover.
    distances: Vec<f32>,
    bounds: Field<f32>,
}

impl Borders {
    /// Measures every diamond of the lattice over `grid`; `cover` says what is at a sample, by column and row from the north.
    #[must_use]
    pub fn new(grid: &Grid, cover: impl Fn(usize, usize) -> u8) -> Borders {
        let (columns, lattice) = (grid.columns(), Lattice::new(grid));
        let covers: Vec<u8> = (0..columns * grid.rows()).map(|at| cover(at % columns, at / columns)).collect();
        let spacing = grid.spacing();
        let distances = distances(&covers, columns, spacing);
        let mut borders = Borders { lattice, spacing, covers, distances, bounds: Field::new(&lattice, 0.0) };
        lattice.from_the_smallest(|middle| {
            let own = lattice.triangles(middle).map(|triangle| borders.crossing(&triangle)).fold(0.0, f64::max);
            let below = lattice.children(middle).map(|child| borders.bounds.at(child));
            let own = if own > 0.0 { (own as f32).next_up() } else { 0.0 };
            let bound = below.fold(own, f32::max);
            borders.bounds.set(middle, bound);
        });
        borders
    }

    /// The cover at a sample; beyond the grid, of the nearest.
    #[must_use]
    pub fn at(&self, point: Point) -> u8 {
        self.covers[self.place(self.lattice.nearest(point))]
    }

    /// The cover that a triangle wears.
    #[must_use]
    pub fn cover(&self, triangle: &Triangle) -> u8 {
        self.at(self.asked(triangle).0)
    }

    /// Metres that a mesh may be wrong by that leaves the diamond of `middle` whole, beyond [`Borders::unseen`]; 0: no sample is wrong.
    #[must_use]
    #[inline]
    pub fn bound(&self, middle: Point) -> f32 {
        self.bounds.at(middle)
    }

    /// Metres that any mesh may be wrong by: half the diagonal of a square. What lies between samples is not seen.
    #[must_use]
    pub fn unseen(&self) -> f64 {
        length(self.spacing) / 2.0
    }

    /// The least tolerance that the finest mesh is sure to keep: the longer side of a square.
    #[must_use]
    pub fn finest(&self) -> f64 {
        self.spacing[0].max(self.spacing[1])
    }

    /// Metres within which all wrong places of some triangles are from a border.
    #[must_use]
    pub fn promise<'t>(&self, triangles: impl Iterator<Item = &'t Triangle>) -> f64 {
        triangles.map(|triangle| self.crossing(triangle)).fold(self.unseen(), f64::max)
    }

    /// How many samples under some triangles are wrong, and how far at most from a sample of another cover: what the promise is held to.
    ///
    /// A sample on an edge is wrong if it is wrong on one side.
    #[must_use]
    pub fn wrong<'t>(&self, triangles: impl Iterator<Item = &'t Triangle>) -> (usize, f64) {
        let mut wrong = vec![false; self.covers.len()];
        let mut largest = 0.0_f64;
        for triangle in triangles {
            self.for_each_wrong(triangle, |at| {
                wrong[at] = true;
                largest = largest.max(f64::from(self.distances[at]));
            });
        }
        (wrong.iter().filter(|wrong| **wrong).count(), largest)
    }

    /// The error of a triangle, in metres: 0 where no sample is wrong.
    fn crossing(&self, triangle: &Triangle) -> f64 {
        let mut largest = None::<f32>;
        self.for_each_wrong(triangle, |at| largest = Some(largest.unwrap_or(0.0).max(self.distances[at])));
        largest.map_or(0.0, |largest| (f64::from(largest) + self.unseen()).min(self.asked(triangle).1))
    }

    /// The place whose cover a triangle wears, and how far the farthest corner is from it.
    fn asked(&self, triangle: &Triangle) -> (Point, f64) {
        let Triangle { a, b, apex } = *triangle;
        if !triangle.can_be_halved() {
            // The middle may be no sample.
            return (apex, self.metres(apex, a).max(self.metres(apex, b)));
        }
        let middle = triangle.middle();
        if self.lattice.nearest(middle) == middle {
            return (middle, self.metres(middle, a).max(self.metres(middle, apex)));
        }
        // It lies beyond the grid: any sample of the part within.
        let mut first = None;
        rows(triangle, (self.lattice.east, self.lattice.south), |y, x, _| {
            first.get_or_insert(Point { x, y });
        });
        let reach = self.metres(a, b).max(self.metres(a, apex)).max(self.metres(b, apex));
        (first.unwrap_or(middle), reach)
    }

    fn for_each_wrong(&self, triangle: &Triangle, mut visit: impl FnMut(usize)) {
        let worn = self.cover(triangle);
        rows(triangle, (self.lattice.east, self.lattice.south), |y, first, last| {
            let row = self.place(Point { x: first, y });
            let covers = &self.covers[row..=row + (last - first) as usize];
            covers.iter().enumerate().filter(|(_, cover)| **cover != worn).for_each(|(at, _)| visit(row + at));
        });
    }

    fn place(&self, point: Point) -> usize {
        point.y as usize * (self.lattice.east as usize + 1) + point.x as usize
    }

    fn metres(&self, p: Point, q: Point) -> f64 {
        length([f64::from(p.x.abs_diff(q.x)) * self.spacing[0], f64::from(p.y.abs_diff(q.y)) * self.spacing[1]])
    }
}

fn length([x, y]: [f64; 2]) -> f64 {
    (x * x + y * y).sqrt()
}

/// Metres from each sample to a sample of another cover: the nearest, or one not much farther. Infinite where none was found.
///
/// Source: P.-E. Danielsson, "Euclidean Distance Mapping", Computer Graphics and Image Processing 14, 1980, 227-248, with many covers.
fn distances(covers: &[u8], columns: usize, spacing: [f64; 2]) -> Vec<f32> {
    let rows = covers.len() / columns;
    let mut nearest = vec![None::<u32>; covers.len()];
    let mut distances = vec![f32::INFINITY; covers.len()];
    let mut look = |x: usize, y: usize, [dx, dy]: [isize; 2]| {
        let (Some(i), Some(j)) = (x.checked_add_signed(dx), y.checked_add_signed(dy)) else { return };
        if i >= columns || j >= rows {
            return;
        }
        let (at, beside) = (y * columns + x, j * columns + i);
        let other = if covers[beside] == covers[at] { nearest[beside] } else { Some(beside as u32) };
        let Some(other) = other else { return };
        let (u, v) = (other as usize % columns, other as usize / columns);
        let away = length([x.abs_diff(u) as f64 * spacing[0], y.abs_diff(v) as f64 * spacing[1]]);
        // Rounded up: it is a bound.
        let away = (away as f32).next_up();
        if away < distances[at] {
            (distances[at], nearest[at]) = (away, Some(other));
        }
    };
    for y in 0..rows {
        (0..columns).for_each(|x| [[-1, 0], [-1, -1], [0, -1], [1, -1]].into_iter().for_each(|to| look(x, y, to)));
        (0..columns).rev().for_each(|x| look(x, y, [1, 0]));
    }
    for y in (0..rows).rev() {
        (0..columns).rev().for_each(|x| [[1, 0], [1, 1], [0, 1], [-1, 1]].into_iter().for_each(|to| look(x, y, to)));
        (0..columns).for_each(|x| look(x, y, [-1, 0]));
    }
    distances
}

/// Halves what another criterion halves, and what crosses borders by more than a tolerance.
#[derive(Clone, Copy, Debug)]
pub struct KeepingBorders<'a, C> {
    /// What else is worth halving.
    pub criterion: C,
    /// The borders; `None`: there are none to keep.
    pub borders: Option<&'a Borders>,
    /// Metres, above 0.
    pub tolerance: f64,
}

impl<C: Criterion> Criterion for KeepingBorders<'_, C> {
    fn score(&self, middle: Point) -> f64 {
        let score = self.criterion.score(middle);
        let bound = self.borders.map_or(0.0, |borders| f64::from(borders.bound(middle)));
        // Bounds grow towards the roots, so the larger of two scores does, too.
        score.max(bound / self.tolerance)
    }
}

#[cfg(test)]
mod tests {
    use super::super::criterion::ByError;
    use super::super::frontier::Frontier;
    use super::super::tests::hills;
    use super::super::{Hierarchy, finer::finer, mesh};
    use super::*;

    /// Three covers, the borders of which follow nothing.
    fn cover(x: usize, y: usize) -> u8 {
        if x * x + 2 * y * y < 900 { 1 } else { u8::from(3 * x + y > 110) * 2 }
    }

    #[test]
    fn bounds_grow_and_hold_for_every_diamond() {
        for (columns, rows) in [(33, 33), (50, 37), (41, 20)] {
            let grid = hills(columns, rows);
            let borders = Borders::new(&grid, cover);
            let lattice = Lattice::new(&grid);
            let mut positive = 0;
            lattice.from_the_smallest(|middle| {
                let bound = borders.bound(middle);
                positive += usize::from(bound > 0.0);
                lattice.children(middle).for_each(|child| assert!(borders.bound(child) <= bound));
                lattice.triangles(middle).for_each(|triangle| assert!(borders.crossing(&triangle) <= f64::from(bound)));
            });
            assert!(positive > 50);
        }
    }

    #[test]
    fn distances_are_those_of_all_pairs_or_a_little_more() {
        let (columns, rows, spacing) = (31, 24, [3.0, 4.0]);
        let covers: Vec<u8> = (0..columns * rows).map(|at| cover(at % columns * 2, at / columns * 2)).collect();
        for (at, distance) in distances(&covers, columns, spacing).into_iter().enumerate() {
            let metres = |other: usize| {
                let away = |a: usize, b: usize, step: f64| a.abs_diff(b) as f64 * step;
                length([away(at % columns, other % columns, 3.0), away(at / columns, other / columns, 4.0)])
            };
            let others = (0..covers.len()).filter(|&other| covers[other] != covers[at]);
            let nearest = others.map(metres).fold(f64::INFINITY, f64::min);
            assert!(
                f64::from(distance) >= nearest && f64::from(distance) <= 1.1 * nearest + 0.01,
                "{distance} {nearest}"
            );
        }
    }

    #[test]
    fn the_frontier_ends_where_the_mesh_from_scratch_does() {
        let grid = hills(50, 37);
        let hierarchy = Hierarchy::new(&grid);
        let borders = Borders::new(&grid, cover);
        let mut frontier = Frontier::new(&hierarchy);
        for (error, tolerance) in [(300.0, 200.0), (60.0, 35.0), (1e6, 70.0), (25.0, 1e6), (1e6, 35.0)] {
            let criterion = ByError { hierarchy: &hierarchy, error };
            let keeping = KeepingBorders { criterion, borders: Some(&borders), tolerance };
            frontier.follow(&keeping, usize::MAX);
            let scratch = mesh::mesh(&hierarchy, |middle| keeping.score(middle) > 1.0);
            assert!(frontier.mesh() == scratch, "{error} m, {tolerance} m");
            let triangles = || scratch.faces.iter().map(|face| &face.triangle);
            assert!(borders.promise(triangles()) <= tolerance.max(borders.unseen()));
            assert!(borders.wrong(triangles()).1 <= tolerance);
        }
    }

    #[test]
    fn between_samples_the_surface_stays() {
        let grid = hills(20, 13);
        let fine = finer(&grid, 4);
        assert_eq!((fine.columns(), fine.rows(), fine.extent()), (77, 49, grid.extent()));
        let (coarse, finest) = (Hierarchy::new(&grid), Hierarchy::new(&fine));
        for error in [0.0, 12.0, 80.0] {
            let (one, other) = (mesh::within(&coarse, error), mesh::within(&finest, error));
            assert_eq!(one.triangles(), other.triangles(), "{error}: no triangle more");
        }
    }
}
