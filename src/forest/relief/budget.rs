//! Budget: as good a mesh as so many triangles can be.
//!
//! Hierarchy, number of triangles -BUDGET-> halved diamonds -> mesh
//!
//! Greedy: again and again the worst diamond is halved, with the parents that it forces, until the next would be one triangle too many. What
//! "worst" means is the caller's: the largest distance (then it is the mesh of some error limit, or part of the way to the next), or the sum of
//! squares, the paper's own measure, which leaves lone peaks off and has the smaller RMSE.
//!
//! Cost: n log n for n triangles, and for squares a visit of the samples under every triangle that ever was.

use super::frontier::chain;
use super::hierarchy::Hierarchy;
use super::lattice::{Field, Point, Triangle};
use super::mesh::{ReliefMesh, mesh, pieces};
use super::scan::distances;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// What makes a triangle the worst.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// The largest distance of any sample.
    Largest,
    /// The sum of the squares of all distances.
    Squares,
}

/// The mesh of at most `triangles` triangles that halving the worst first gives. Never fewer than the roots are.
#[must_use]
pub fn with_triangles(hierarchy: &Hierarchy<'_>, triangles: usize, measure: Measure) -> ReliefMesh {
    let lattice = &hierarchy.lattice;
    let mut halved = Field::new(lattice, false);
    let mut count: usize = lattice.roots().iter().map(|root| pieces(lattice, root)).sum();
    let mut worst: BinaryHeap<(u64, Reverse<Point>)> = BinaryHeap::new();
    worst.extend(lattice.roots().iter().filter_map(|root| entry(hierarchy, root, measure)));
    while let Some((_, Reverse(middle))) = worst.pop() {
        if halved.at(middle) {
            continue;
        }
        let chain = chain(hierarchy, &halved, middle);
        let more: usize = chain.iter().map(|&middle| growth(hierarchy, middle)).sum();
        if count + more > triangles {
            break;
        }
        count += more;
        for middle in chain {
            halved.set(middle, true);
            let halves = lattice.triangles(middle).flat_map(|triangle| triangle.halves());
            worst.extend(halves.filter_map(|half| entry(hierarchy, &half, measure)));
        }
    }
    mesh(hierarchy, |middle| halved.at(middle))
}

/// How many more triangles there are once a diamond is halved.
fn growth(hierarchy: &Hierarchy<'_>, middle: Point) -> usize {
    let lattice = &hierarchy.lattice;
    let grown = |triangle: Triangle| {
        let after: usize = triangle.halves().iter().map(|half| pieces(lattice, half)).sum();
        after.saturating_sub(pieces(lattice, &triangle))
    };
    lattice.triangles(middle).map(grown).sum()
}

/// The entry of a triangle in the queue; none where there is nothing to gain.
fn entry(hierarchy: &Hierarchy<'_>, triangle: &Triangle, measure: Measure) -> Option<(u64, Reverse<Point>)> {
    let middle = triangle.middle();
    if !triangle.can_be_halved() || !hierarchy.lattice.touches(middle) {
        return None;
    }
    let badness = match measure {
        Measure::Largest => f64::from(hierarchy.bound(middle)),
        Measure::Squares => {
            let found = distances(hierarchy.grid, triangle, hierarchy.corners(triangle));
            let is_void = found.squares.is_nan() || found.is_mixed();
            if is_void { f64::INFINITY } else { found.squares }
        }
    };
    // What is not negative has its bits in its order.
    (badness > 0.0).then(|| (badness.to_bits(), Reverse(middle)))
}

#[cfg(test)]
mod tests {
    use super::super::mesh::edge_uses;
    use super::super::quality;
    use super::super::tests::{hills, with_voids};
    use super::*;

    #[test]
    fn budgets_are_kept_and_more_triangles_are_better() {
        for grid in [hills(65, 65), hills(50, 37)] {
            let hierarchy = Hierarchy::new(&grid);
            for measure in [Measure::Largest, Measure::Squares] {
                let mut last = f64::INFINITY;
                for budget in [2, 10, 45, 200, 845] {
                    let found = quality(&grid, &with_triangles(&hierarchy, budget, measure));
                    // The last halving did not fit: chains are short.
                    assert!(found.triangles <= budget.max(4) && found.triangles + 40 > budget, "{budget}: {found:?}");
                    assert!(found.rmse < last, "{budget}: {found:?}");
                    last = found.rmse;
                }
            }
            let mesh = with_triangles(&hierarchy, 845, Measure::Squares);
            assert!(edge_uses(&mesh).values().all(|&uses| uses <= 2));
        }
    }

    #[test]
    fn squares_have_the_smaller_rmse_and_largest_the_smaller_largest() {
        let grid = hills(65, 65);
        let hierarchy = Hierarchy::new(&grid);
        let of = |measure| quality(&grid, &with_triangles(&hierarchy, 400, measure));
        let (largest, squares) = (of(Measure::Largest), of(Measure::Squares));
        assert!(squares.rmse < largest.rmse && largest.largest < squares.largest, "{largest:?} {squares:?}");
    }

    #[test]
    fn enough_triangles_are_exact_and_voids_stay_holes() {
        let grid = with_voids(33, 30);
        let hierarchy = Hierarchy::new(&grid);
        let found = quality(&grid, &with_triangles(&hierarchy, usize::MAX, Measure::Squares));
        assert_eq!(found.ssd, 0.0);
        let voids = grid.voids();
        assert!(voids > 40 && found.samples + voids + found.uncovered == 33 * 30 && found.uncovered < 9, "{found:?}");
    }
}
