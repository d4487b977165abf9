//! Crossing: whether an outline crosses itself. Touching itself, as clipping leaves it, is no crossing.
//!
//! geometry -> CROSSING -> a count, and even-odd instead of a split
//!
//! Crossings come in three kinds: two edges in a point inside both; a chain that passes over an edge at one of its own corners;
//! two chains that visit one place and change sides there, so that the directions of one alternate with those of the other.
//! The third kind is found among corners in the same place. The first two meet in two edges that lie side by
//! side just before, so a line that sweeps over the outline from left to right and keeps its edges in order asks each edge only
//! about its two neighbors. Until a crossing is found no two edges change places, so the order of two edges is a sign that
//! does not depend on where the line stands, and a plain ordered set will do. Vertical edges take part because points are ordered
//! by x and then by y, as if all were leaned over by a hair.
//!
//! Where edges lie on each other (spikes, bridges) the line may lose its order and miss a crossing: an outline that visits a place twice is
//! asked pair by pair as well, if it is not too large.
//!
//! Not noticed: chains that change sides after they ran along each other over more than one edge.
//!
//! Space: the plane of the polygon. Source: M. I. Shamos and D. Hoey, "Geometric Intersection Problems", FOCS 1976.
//! Cost: O(n) for convex outlines, O(n log n) for others; nothing is allocated up to 32 corners.

use super::plane::Plane;
use crate::geometry::predicates::{Orientation, orientation};
use crate::math::{Vec2, Vec3};
use std::cmp::Ordering;
use std::collections::BTreeSet;
use std::ops::Bound::{Excluded, Unbounded};

/// Up to this many corners every edge is held against every other.
const SMALL: usize = 32;
/// And so they are up to this many, where corners share places.
const LARGE: usize = 1024;
/// In one place, up to this many visits are held against each other.
const VISITS: usize = 64;

/// Finds crossings; keeps its memory from outline to outline.
#[derive(Debug, Default)]
pub struct Crossing {
    points: Vec<Vec2>,
    /// Indices of points, by place.
    order: Vec<u32>,
}

impl Crossing {
    /// Whether `outline`, seen along `normal` (any length), crosses itself. Exact for every finite coordinate.
    ///
    /// ```
    /// use farop::geometry::split::Crossing;
    /// use farop::math::Vec3;
    /// let corners = [(0.0, 0.0), (4.0, 4.0), (4.0, 0.0), (0.0, 4.0)].map(|(x, y)| Vec3::new(x, y, 1.0));
    /// let [a, b, c, d] = corners;
    /// assert!(Crossing::default().is_in(&[a, b, c, d], Vec3::Z));
    /// assert!(!Crossing::default().is_in(&[a, c, b, d], Vec3::Z));
    /// ```
    pub fn is_in(&mut self, outline: &[Vec3], normal: Vec3) -> bool {
        if outline.len() < 4 {
            return false;
        }
        let plane = Plane::facing(outline, normal);
        self.points.clear();
        self.points.extend(outline.iter().map(|&p| plane.flatten(p)));
        self.points.dedup();
        while self.points.len() > 1 && self.points.first() == self.points.last() {
            self.points.pop();
        }
        if self.points.len() < 4 || self.is_convex() {
            return false;
        }
        if self.points.len() <= SMALL {
            return self.any_pair_meets() || self.visits_cross();
        }
        let found = self.sweeps_into_one() || self.visits_cross();
        found || (self.points.len() <= LARGE && self.visits_a_place_twice() && self.any_pair_meets())
    }

    fn any_pair_meets(&self) -> bool {
        let edge = |index| Edge::new(&self.points, index);
        (0..self.points.len() as u32).any(|i| (0..i).any(|j| self.meet(&edge(j), &edge(i))))
    }

    /// Whether two corners are in one place; they have been sorted.
    fn visits_a_place_twice(&self) -> bool {
        self.order.windows(2).any(|pair| self.points[pair[0] as usize] == self.points[pair[1] as usize])
    }

    /// Whether it turns one way only and goes from left to right and back once.
    fn is_convex(&self) -> bool {
        let count = self.points.len();
        let at = |i: usize| self.points[i % count];
        let mut turns = (false, false);
        let mut returns = 0;
        for i in 0..count {
            let (a, b, c) = (at(i), at(i + 1), at(i + 2));
            match orientation(a, b, c) {
                Orientation::Counterclockwise => turns.0 = true,
                Orientation::Clockwise => turns.1 = true,
                Orientation::Collinear => {}
            }
            returns += usize::from(by_place(a, b) != by_place(b, c));
        }
        turns != (true, true) && returns == 2
    }

    /// Sweeps over the edges until two neighbors cross.
    fn sweeps_into_one(&mut self) -> bool {
        let count = self.points.len() as u32;
        self.sort_by_place();
        let mut line: BTreeSet<Edge> = BTreeSet::new();
        for &vertex in &self.order {
            // Of the two edges at a corner, first take out those that end there: then those around them become neighbors.
            let edges = [vertex, (vertex + count - 1) % count].map(|index| Edge::new(&self.points, index));
            let here = self.points[vertex as usize];
            for edge in edges.iter().filter(|edge| edge.right == here) {
                line.remove(edge);
                let below = line.range((Unbounded, Excluded(edge))).next_back();
                let above = line.range((Excluded(edge), Unbounded)).next();
                if below.zip(above).is_some_and(|(below, above)| self.meet(below, above)) {
                    return true;
                }
            }
            for edge in edges.iter().filter(|edge| edge.left == here) {
                let below = line.range((Unbounded, Excluded(edge))).next_back();
                let above = line.range((Excluded(edge), Unbounded)).next();
                if below.into_iter().chain(above).any(|neighbor| self.meet(neighbor, edge)) {
                    return true;
                }
                line.insert(*edge);
            }
        }
        false
    }

    fn sort_by_place(&mut self) {
        let points = &self.points;
        self.order.clear();
        self.order.extend(0..points.len() as u32);
        self.order.sort_unstable_by(|&a, &b| by_place(points[a as usize], points[b as usize]).then(a.cmp(&b)));
    }

    /// Whether two edges cross inside both, or a chain passes over one of them at a corner of the other.
    fn meet(&self, a: &Edge, b: &Edge) -> bool {
        let of_a = [a.side_of(b.left), a.side_of(b.right)];
        let of_b = [b.side_of(a.left), b.side_of(a.right)];
        if are_opposite(of_a) && are_opposite(of_b) {
            return true;
        }
        let passes = |edge: &Edge, sides: [Orientation; 2], [left, right]: [u32; 2]| {
            sides != [Orientation::Collinear; 2]
                && ((sides[0] == Orientation::Collinear && self.passes_over(edge, left))
                    || (sides[1] == Orientation::Collinear && self.passes_over(edge, right)))
        };
        let count = self.points.len() as u32;
        passes(a, of_a, b.ends(count)) || passes(b, of_b, a.ends(count))
    }

    /// Whether the chain through a corner on the line of `edge` goes from one side of it to the other.
    fn passes_over(&self, edge: &Edge, corner: u32) -> bool {
        let here = self.points[corner as usize];
        if by_place(edge.left, here) != Ordering::Less || by_place(here, edge.right) != Ordering::Less {
            return false;
        }
        let count = self.points.len() as u32;
        // Both ways along the chain, past one corner that still lies on the edge.
        let leaves = |step: u32| {
            let mut sides = (1..3).map(|times| {
                let place = self.points[((corner + times * step) % count) as usize];
                let within =
                    by_place(edge.left, place) == Ordering::Less && by_place(place, edge.right) == Ordering::Less;
                (edge.side_of(place), within)
            });
            match sides.next() {
                Some((Orientation::Collinear, true)) => sides.next().map_or(Orientation::Collinear, |(side, _)| side),
                Some((side, _)) => side,
                None => Orientation::Collinear,
            }
        };
        are_opposite([leaves(1), leaves(count - 1)])
    }

    /// Whether two visits to one place change sides there.
    fn visits_cross(&mut self) -> bool {
        self.sort_by_place();
        let points = &self.points;
        let groups = self.order.chunk_by(|&a, &b| points[a as usize] == points[b as usize]);
        groups.filter(|group| group.len() > 1).any(|group| {
            let group = &group[..group.len().min(VISITS)];
            (0..group.len()).any(|i| (0..i).any(|j| self.alternate(group[i], group[j])))
        })
    }

    /// Whether the directions of two visits to one place alternate around it.
    fn alternate(&self, first: u32, second: u32) -> bool {
        let count = self.points.len() as u32;
        let around = |vertex: u32| [vertex + count - 1, vertex + 1].map(|index| self.points[(index % count) as usize]);
        let here = self.points[first as usize];
        let is_left = |a: Vec2, b: Vec2| orientation(here, a, b) == Orientation::Counterclockwise;
        // Strictly between a and b, counterclockwise.
        let is_between = |a: Vec2, b: Vec2, d: Vec2| {
            if is_left(a, b) { is_left(a, d) && is_left(d, b) } else { is_left(a, d) || is_left(d, b) }
        };
        // The tip of a spike leaves the way it came, and changes no side.
        let is_tip = |[a, b]: [Vec2; 2]| {
            orientation(here, a, b) == Orientation::Collinear && by_place(here, a) == by_place(here, b)
        };
        let ([a, b], [c, d]) = (around(first), around(second));
        if is_tip([a, b]) || is_tip([c, d]) {
            return false;
        }
        (is_between(a, b, c) && is_between(b, a, d)) || (is_between(a, b, d) && is_between(b, a, c))
    }
}

fn are_opposite(sides: [Orientation; 2]) -> bool {
    matches!(
        sides,
        [Orientation::Clockwise, Orientation::Counterclockwise]
            | [Orientation::Counterclockwise, Orientation::Clockwise]
    )
}

/// By x, then by y. Coordinates are finite.
fn by_place(a: Vec2, b: Vec2) -> Ordering {
    let order = |a: f64, b: f64| a.partial_cmp(&b).unwrap_or(Ordering::Equal);
    order(a.x, b.x).then(order(a.y, b.y))
}

/// An edge of the outline, from left to right.
#[derive(Clone, Copy, Debug)]
struct Edge {
    left: Vec2,
    right: Vec2,
    /// The corner it starts at.
    index: u32,
    /// The outline walks it from right to left.
    turned: bool,
}

impl Edge {
    fn new(points: &[Vec2], index: u32) -> Edge {
        let (from, to) = (points[index as usize], points[(index as usize + 1) % points.len()]);
        let turned = by_place(from, to) == Ordering::Greater;
        let (left, right) = if turned { (to, from) } else { (from, to) };
        Edge { left, right, index, turned }
    }

    fn side_of(&self, p: Vec2) -> Orientation {
        orientation(self.left, self.right, p)
    }

    /// The corners at its left and right end.
    fn ends(&self, count: u32) -> [u32; 2] {
        let next = (self.index + 1) % count;
        if self.turned { [next, self.index] } else { [self.index, next] }
    }
}

impl Ord for Edge {
    /// The lower one first, of two edges that the line meets at the same time and that do not cross; on one line, by index.
    fn cmp(&self, other: &Edge) -> Ordering {
        if self.index == other.index {
            return Ordering::Equal;
        }
        // Ask at the left end of the later one; if they touch there, at the right end of the earlier one.
        let lower = |side: Orientation| match side {
            Orientation::Counterclockwise => Ordering::Less,
            Orientation::Collinear => Ordering::Equal,
            Orientation::Clockwise => Ordering::Greater,
        };
        let at_left = if by_place(self.left, other.left) == Ordering::Less {
            lower(self.side_of(other.left))
        } else {
            lower(other.side_of(self.left)).reverse()
        };
        let at_right = || {
            if by_place(self.right, other.right) == Ordering::Less {
                lower(other.side_of(self.right)).reverse()
            } else {
                lower(self.side_of(other.right))
            }
        };
        at_left.then_with(at_right).then(self.index.cmp(&other.index))
    }
}

impl PartialOrd for Edge {
    fn partial_cmp(&self, other: &Edge) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Edge {
    fn eq(&self, other: &Edge) -> bool {
        self.index == other.index
    }
}

impl Eq for Edge {}
