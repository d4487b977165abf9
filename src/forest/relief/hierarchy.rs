//! Hierarchy: for every diamond, how wrong the relief is as long as it stays whole.
//!
//! Grid -HIERARCHY-> bound of every diamond -> mesh
//!
//! The error of a triangle is the *largest distance of any sample under it* from its plane. The bound of a diamond is the largest error of
//! its two triangles and of all diamonds below. So bounds grow towards the roots, and halving exactly the diamonds above a limit gives
//! a mesh without cracks that is nowhere farther from the samples than the limit.
//!
//! Why not only the distance at the middle of the hypotenuse, as is common: that is no bound. On real tiles the true error is then
//! 1.5 to 2.2 times what was asked for, and at equal true error the mesh needs 1.3 to 3.3 times as many triangles.
//!
//! Units: metres. Source: W. Evans, D. Kirkpatrick, G. Townsend, Algorithmica 30, 2001; `docs/terrain.md` has the measurements.
//! Cost: every sample once a level, 2 log2(side) levels.

use super::lattice::{Field, Lattice, Point, Triangle};
use super::scan::largest_distance;
use crate::forest::elevation::Grid;

/// The grid with the bound of every diamond.
#[derive(Clone, Debug)]
pub struct Hierarchy<'a> {
    /// The heights.
    pub grid: &'a Grid,
    /// The virtual square over it.
    pub lattice: Lattice,
    /// Some samples are voids.
    pub has_voids: bool,
    bounds: Field<f32>,
}

impl<'a> Hierarchy<'a> {
    /// Measures every diamond of the lattice over `grid`.
    #[must_use]
    pub fn new(grid: &'a Grid) -> Hierarchy<'a> {
        let lattice = Lattice::new(grid);
        let bounds = Field::new(&lattice, 0.0);
        let mut hierarchy = Hierarchy { grid, lattice, has_voids: grid.voids() > 0, bounds };
        lattice.from_the_smallest(|middle| {
            let own = hierarchy.own_error(middle);
            let below = lattice.children(middle).map(|child| hierarchy.bounds.at(child));
            let bound = below.fold(rounded_up(own), f32::max);
            hierarchy.bounds.set(middle, bound);
        });
        hierarchy
    }

    /// The same without any bound: for a mesh whose halvings are known.
    #[must_use]
    pub fn without_bounds(grid: &'a Grid) -> Hierarchy<'a> {
        let lattice = Lattice::new(grid);
        Hierarchy { grid, lattice, has_voids: grid.voids() > 0, bounds: Field::new(&lattice, 0.0) }
    }

    /// The height at a point of the square, in metres; beyond the grid, of the nearest sample. Not a number in a void.
    #[must_use]
    #[inline]
    pub fn height(&self, point: Point) -> f64 {
        let Point { x, y } = self.lattice.nearest(point);
        f64::from(self.grid.height(x as usize, y as usize))
    }

    /// The heights of `a`, `b` and `apex`.
    #[must_use]
    #[inline]
    pub fn corners(&self, triangle: &Triangle) -> [f64; 3] {
        [triangle.a, triangle.b, triangle.apex].map(|corner| self.height(corner))
    }

    /// The largest distance, in metres, of a sample under `triangle` from its plane: infinite where some but not all samples are voids.
    #[must_use]
    #[inline]
    pub fn error(&self, triangle: &Triangle) -> f64 {
        largest_distance(self.grid, triangle, self.corners(triangle), self.has_voids)
    }

    /// What a mesh may be wrong by, in metres, that leaves the diamond of `middle` whole; 0 for what is no diamond.
    #[must_use]
    #[inline]
    pub fn bound(&self, middle: Point) -> f32 {
        self.bounds.at(middle)
    }

    /// The bounds alone, for whoever keeps the grid himself.
    #[must_use]
    pub fn into_bounds(self) -> Field<f32> {
        self.bounds
    }

    /// The largest error of the triangles of one diamond.
    fn own_error(&self, middle: Point) -> f64 {
        let Some(diamond) = self.lattice.diamond(middle) else { return 0.0 };
        // Half of all diamonds are the smallest: one sample lies within, the middle itself.
        let is_smallest = (middle.x & 1) != (middle.y & 1);
        let is_inside = middle.x <= self.lattice.east && middle.y <= self.lattice.south;
        if is_smallest && is_inside && !self.has_voids {
            return (self.height(middle) - (self.height(diamond.a) + self.height(diamond.b)) / 2.0).abs();
        }
        self.lattice.triangles(middle).map(|triangle| self.error(&triangle)).fold(0.0, f64::max)
    }
}

/// The least `f32` that is not below `error`: what is stored stays a bound.
fn rounded_up(error: f64) -> f32 {
    let near = error as f32;
    if f64::from(near) < error { near.next_up() } else { near }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{hills, with_voids};
    use super::*;

    #[test]
    fn bounds_grow_towards_the_roots() {
        for grid in [hills(33, 33), hills(40, 21), with_voids(30, 33)] {
            let hierarchy = Hierarchy::new(&grid);
            let mut positive = 0;
            hierarchy.lattice.from_the_smallest(|middle| {
                let bound = hierarchy.bound(middle);
                positive += usize::from(bound > 0.0);
                assert!(f64::from(bound) >= hierarchy.own_error(middle), "{middle:?}");
                hierarchy.lattice.children(middle).for_each(|child| assert!(hierarchy.bound(child) <= bound));
            });
            assert!(positive > 300);
        }
    }

    #[test]
    fn a_plane_needs_two_triangles() {
        let plane = super::super::tests::grid(17, 17, |x, y| (4 * x + 7 * y) as f32);
        let hierarchy = Hierarchy::new(&plane);
        assert_eq!(hierarchy.bound(Point { x: 8, y: 8 }), 0.0);
    }
}
