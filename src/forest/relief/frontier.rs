//! Frontier: the mesh that follows the observer, changed only where it must.
//!
//! mesh of the last frame, criterion -two queues-> mesh of this frame
//!
//! One queue holds diamonds that are to be halved, the worst first, the other those that may be joined again, the least needed first. Halving
//! forces the parents first; joining waits for the children. Because scores grow from children to parents, what is left in the end is
//! exactly what a mesh from scratch would be, whatever the mesh was before (`the_frontier_forgets_where_it_came_from`).
//!
//! The paper coarsens where "close *or* large *or* not plane" and goes on with the same triangle: that never ends. Joined is here what is
//! *not* to be halved, and next its parents.
//!
//! Source: M. Cifuentes et al., section 2; M. Duchaineau et al., "ROAMing Terrain", IEEE Visualization 1997, 81-88 (the queues).
//! Cost: a visit of every triangle of the mesh to fill the queues, and n log n for n changes.

use super::criterion::Criterion;
use super::hierarchy::Hierarchy;
use super::lattice::{Field, Point};
use super::mesh::{ReliefMesh, for_each_leaf, mesh};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// The halved diamonds of a mesh without cracks.
#[derive(Clone, Debug)]
pub struct Frontier<'a> {
    hierarchy: &'a Hierarchy<'a>,
    halved: Field<bool>,
    count: usize,
}

/// What one step changed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize)]
pub struct Changes {
    /// Diamonds that were halved, forced ones included.
    pub halved: usize,
    /// Diamonds that were joined.
    pub joined: usize,
    /// Changes that were due and over the limit.
    pub left: usize,
}

impl<'a> Frontier<'a> {
    /// Two triangles.
    #[must_use]
    pub fn new(hierarchy: &'a Hierarchy<'a>) -> Frontier<'a> {
        Frontier { hierarchy, halved: Field::new(&hierarchy.lattice, false), count: 0 }
    }

    /// Whether the diamond of a middle is halved.
    #[must_use]
    pub fn is_halved(&self, middle: Point) -> bool {
        self.halved.at(middle)
    }

    /// How many diamonds are halved.
    #[must_use]
    pub fn halved(&self) -> usize {
        self.count
    }

    /// The faces.
    #[must_use]
    pub fn mesh(&self) -> ReliefMesh {
        mesh(self.hierarchy, |middle| self.is_halved(middle))
    }

    /// Halves one diamond, and what must be halved before it; nothing for what is no diamond or touches no sample.
    pub fn halve(&mut self, middle: Point) {
        let lattice = &self.hierarchy.lattice;
        if lattice.diamond(middle).is_some() && lattice.touches(middle) && !self.is_halved(middle) {
            self.chain(middle).into_iter().for_each(|middle| self.set(middle, true));
        }
    }

    /// Halves what scores above 1 and joins what no longer does; stops after `most` changes, the most needed halvings first.
    pub fn follow(&mut self, criterion: &impl Criterion, most: usize) -> Changes {
        let (mut worst, mut least) = self.queues(criterion);
        let mut changes = Changes::default();
        while let Some((_, Reverse(middle))) = worst.pop() {
            if self.is_halved(middle) {
                continue;
            }
            let chain = self.chain(middle);
            if changes.halved + chain.len() > most {
                changes.left += 1 + worst.len();
                break;
            }
            for middle in chain {
                self.set(middle, true);
                changes.halved += 1;
                worst.extend(self.hierarchy.lattice.children(middle).filter_map(|child| self.wanted(criterion, child)));
            }
        }
        while let Some(Reverse((_, middle))) = least.pop() {
            if !self.is_halved(middle) || !self.can_be_joined(middle) {
                continue;
            }
            if changes.halved + changes.joined >= most {
                changes.left += 1 + least.len();
                break;
            }
            self.set(middle, false);
            changes.joined += 1;
            least.extend(self.hierarchy.lattice.parents(middle).filter_map(|parent| self.unwanted(criterion, parent)));
        }
        changes
    }

    /// What is to be halved, and what may be joined.
    #[expect(clippy::type_complexity, reason = "the two queues of the module's title, used in one place")]
    fn queues(
        &self,
        criterion: &impl Criterion,
    ) -> (BinaryHeap<(u64, Reverse<Point>)>, BinaryHeap<Reverse<(u64, Point)>>) {
        let (mut worst, mut least) = (BinaryHeap::new(), BinaryHeap::new());
        let lattice = &self.hierarchy.lattice;
        for_each_leaf(lattice, &|triangle| self.is_halved(triangle.middle()), &mut |leaf| {
            if leaf.can_be_halved() {
                worst.extend(self.wanted(criterion, leaf.middle()));
            }
            // The parent of a leaf, if all that it was halved into is whole.
            least.extend(
                Some(leaf.apex).filter(|&apex| self.is_halved(apex)).and_then(|apex| self.unwanted(criterion, apex)),
            );
        });
        (worst, least)
    }

    /// An entry of the first queue. Scores are not negative, so their bits are in their order.
    fn wanted(&self, criterion: &impl Criterion, middle: Point) -> Option<(u64, Reverse<Point>)> {
        if self.is_halved(middle) || !self.hierarchy.lattice.touches(middle) {
            return None;
        }
        let score = criterion.score(middle);
        (score > 1.0).then(|| (score.to_bits(), Reverse(middle)))
    }

    /// An entry of the second queue.
    fn unwanted(&self, criterion: &impl Criterion, middle: Point) -> Option<Reverse<(u64, Point)>> {
        if !self.can_be_joined(middle) {
            return None;
        }
        let score = criterion.score(middle);
        (score <= 1.0).then(|| Reverse((score.to_bits(), middle)))
    }

    fn can_be_joined(&self, middle: Point) -> bool {
        !self.hierarchy.lattice.children(middle).any(|child| self.is_halved(child))
    }

    /// The diamonds to halve for `middle` to be halved, itself last.
    fn chain(&self, middle: Point) -> Vec<Point> {
        chain(self.hierarchy, &self.halved, middle)
    }

    fn set(&mut self, middle: Point, halved: bool) {
        self.halved.set(middle, halved);
        self.count = if halved { self.count + 1 } else { self.count - 1 };
    }
}

/// The diamonds to halve for `middle` to be halved without cracks: parents before children, itself last, none twice.
pub(super) fn chain(hierarchy: &Hierarchy<'_>, halved: &Field<bool>, middle: Point) -> Vec<Point> {
    let mut chain = vec![middle];
    let mut at = 0;
    while at < chain.len() {
        for parent in hierarchy.lattice.parents(chain[at]) {
            if !halved.at(parent) && !chain.contains(&parent) {
                chain.push(parent);
            }
        }
        at += 1;
    }
    // The larger the reach, and of equal ones the cells, the nearer to the roots.
    chain.sort_by_key(|&middle| Reverse(super::lattice::level(middle)));
    chain
}

#[cfg(test)]
mod tests {
    use super::super::criterion::{ByError, Factors, FromEye, Observer, Spheres, ThreeFactors};
    use super::super::tests::{hills, with_voids};
    use super::*;
    use crate::math::Vec3;
    use crate::scene::{Camera, Place};

    fn camera(step: usize) -> Camera {
        let turn = step as f64 * 0.7;
        let from = Vec3::new(600.0 + 500.0 * crate::math::cos(turn), 500.0 + 700.0 * crate::math::sin(turn), 350.0);
        let (at, up, place) = (Vec3::new(500.0, 400.0, 100.0), Vec3::Z, Place::default());
        Camera { from, at, up, angle: 40.0, hither: 1.0, yon: None, resolution: (640, 480), place }
    }

    fn from_scratch(hierarchy: &Hierarchy<'_>, criterion: &impl Criterion) -> ReliefMesh {
        mesh(hierarchy, |middle| criterion.score(middle) > 1.0)
    }

    #[test]
    fn the_frontier_forgets_where_it_came_from() {
        for grid in [hills(65, 65), hills(50, 37), with_voids(40, 33)] {
            let hierarchy = Hierarchy::new(&grid);
            let spheres = Spheres::new(&hierarchy);
            let mut three = ThreeFactors::new(&spheres, Factors::default(), Vec3::ZERO);
            let (mut frontier, mut other) = (Frontier::new(&hierarchy), Frontier::new(&hierarchy));
            let mut changes = Changes::default();
            for step in 0..12 {
                let observer = Observer::new(&camera(step), (640, 480));
                let criterion = FromEye { hierarchy: &hierarchy, spheres: &spheres, observer, tolerance: 4.0 };
                let changed = frontier.follow(&criterion, usize::MAX);
                (changes.halved, changes.joined) = (changes.halved + changed.halved, changes.joined + changed.joined);
                assert!(frontier.mesh() == from_scratch(&hierarchy, &criterion), "another mesh at step {step}");
                three.move_to(observer.eye);
                other.follow(&three, usize::MAX);
                assert!(other.mesh() == from_scratch(&hierarchy, &three), "another mesh at step {step}");
            }
            assert!(changes.halved > 200 && changes.joined > 200, "{changes:?}");
            // And back to an error that knows no eye.
            frontier.follow(&ByError { hierarchy: &hierarchy, error: 25.0 }, usize::MAX);
            assert!(frontier.mesh() == super::super::mesh::within(&hierarchy, 25.0));
        }
    }

    #[test]
    fn scores_grow_towards_the_roots() {
        let grid = hills(50, 37);
        let hierarchy = Hierarchy::new(&grid);
        let spheres = Spheres::new(&hierarchy);
        let observer = Observer::new(&camera(3), (640, 480));
        let eye = FromEye { hierarchy: &hierarchy, spheres: &spheres, observer, tolerance: 2.0 };
        let three = ThreeFactors::new(&spheres, Factors::default(), observer.eye);
        let (mut seen, mut unseen) = (0, 0);
        hierarchy.lattice.from_the_smallest(|middle| {
            let (by_eye, by_three) = (eye.score(middle), three.score(middle));
            seen += usize::from(by_eye > 1.0);
            unseen += usize::from(by_eye == 0.0);
            for child in hierarchy.lattice.children(middle) {
                assert!(eye.score(child) <= by_eye && three.score(child) <= by_three, "{middle:?} {child:?}");
            }
        });
        assert!(seen > 100 && unseen > 100, "{seen} {unseen}");
    }

    #[test]
    fn a_limit_spreads_the_work_over_frames() {
        let grid = hills(65, 65);
        let hierarchy = Hierarchy::new(&grid);
        let criterion = ByError { hierarchy: &hierarchy, error: 10.0 };
        let mut frontier = Frontier::new(&hierarchy);
        let mut frames = 0;
        while frontier.follow(&criterion, 50).left > 0 {
            frames += 1;
            assert!(frames < 1000);
        }
        assert!(frames > 5);
        assert!(frontier.mesh() == super::super::mesh::within(&hierarchy, 10.0));
    }
}
