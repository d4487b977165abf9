//! Outline: whether rings of corners are a polygon with holes. Decided exactly, from the numbers as they are.
//!
//! rings -OUTLINE-> what is wrong with them, or nothing
//!
//! Why exact: with a tolerance, a polygon that was cut at a cell border would be refused for touching what it does not touch.
//!
//! Source: the sign of a triangle's area, J. Shewchuk, Discrete & Computational Geometry 18, 1997 ([`turn_in_plane`]).
//! Cost: edges are sorted by their west end and compared with those they overlap: about n log n for land, n^2 for combs.

use crate::math::edges;
use crate::parse::area::turn_in_plane;

type Point = [f64; 2];

/// What is wrong with rings; ring 0 is the outline, the others are holes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::parse) enum Flaw {
    /// All corners of a ring are on one line.
    Flat { ring: usize },
    /// Two corners behind each other are the same.
    Twice { ring: usize, at: Point },
    /// Two edges of a ring (counted from 1) meet elsewhere than at their common corner.
    Crossing { ring: usize, edges: [usize; 2], near: Point },
    /// A corner of a hole is outside of the outline.
    Outside { hole: usize, at: Point },
    /// Edges of two rings cross, or one hole is within another.
    Rings { rings: [usize; 2], near: Point },
}

/// An edge of a ring, from its lower number of corner on.
#[derive(Clone, Copy)]
struct Edge {
    from: Point,
    to: Point,
    ring: usize,
    /// Its place in the ring, and how many edges the ring has.
    number: usize,
    count: usize,
}

/// The first thing that is wrong with these rings.
pub(in crate::parse) fn flaw(rings: &[Vec<Point>]) -> Option<Flaw> {
    for (ring, corners) in rings.iter().enumerate() {
        if let Some((&at, _)) = edges(corners).find(|(a, b)| a == b) {
            return Some(Flaw::Twice { ring, at });
        }
        let [first, second] = [corners[0], corners[1]];
        if corners.iter().all(|&corner| turn_in_plane(first, second, corner) == 0.0) {
            return Some(Flaw::Flat { ring });
        }
    }
    crossing(rings).or_else(|| nesting(rings))
}

/// Two edges that meet where they must not.
fn crossing(rings: &[Vec<Point>]) -> Option<Flaw> {
    let mut all = Vec::new();
    for (ring, corners) in rings.iter().enumerate() {
        let edges = edges(corners).enumerate();
        all.extend(edges.map(|(number, (&from, &to))| Edge { from, to, ring, number, count: corners.len() }));
    }
    all.sort_by(|a, b| west(a).total_cmp(&west(b)));
    for (index, edge) in all.iter().enumerate() {
        let east = edge.from[0].max(edge.to[0]);
        let overlapping = all[index + 1..].iter().take_while(|other| west(other) <= east);
        for other in overlapping {
            if let Some(near) = meeting(edge, other) {
                let mut pair = [edge, other];
                pair.sort_by_key(|edge| (edge.ring, edge.number));
                let [a, b] = pair;
                return Some(match a.ring == b.ring {
                    true => Flaw::Crossing { ring: a.ring, edges: [a.number + 1, b.number + 1], near },
                    false => Flaw::Rings { rings: [a.ring, b.ring], near },
                });
            }
        }
    }
    None
}

fn west(edge: &Edge) -> f64 {
    edge.from[0].min(edge.to[0])
}

/// Where two edges meet that must not: a corner of one of them nearby.
fn meeting(a: &Edge, b: &Edge) -> Option<Point> {
    let low = |edge: &Edge| edge.from[1].min(edge.to[1]);
    let high = |edge: &Edge| edge.from[1].max(edge.to[1]);
    if low(a) > high(b) || low(b) > high(a) {
        return None;
    }
    if a.ring == b.ring && (a.number + 1) % a.count == b.number {
        return folds_back(a.from, a.to, b.to).then_some(a.to);
    }
    if a.ring == b.ring && (b.number + 1) % b.count == a.number {
        return folds_back(b.from, b.to, a.to).then_some(b.to);
    }
    let sides = |edge: &Edge, other: &Edge| {
        [other.from, other.to].map(|corner| sign(turn_in_plane(edge.from, edge.to, corner)))
    };
    let ([c, d], [e, f]) = (sides(a, b), sides(b, a));
    if c * d < 0 && e * f < 0 {
        return Some(b.from);
    }
    // Rings may touch each other: a clearing on the edge of the wood. A ring that touches itself is two.
    if a.ring != b.ring {
        return None;
    }
    let touching = [(c, b.from, a), (d, b.to, a), (e, a.from, b), (f, a.to, b)];
    touching
        .into_iter()
        .find(|&(side, corner, edge)| side == 0 && is_between(corner, edge))
        .map(|(_, corner, _)| corner)
}

/// Whether the way from `b` to `c` leads back over the one from `a` to `b`.
fn folds_back(a: Point, b: Point, c: Point) -> bool {
    let along = (a[0] - b[0]) * (c[0] - b[0]) + (a[1] - b[1]) * (c[1] - b[1]);
    turn_in_plane(a, b, c) == 0.0 && along > 0.0
}

/// Whether a point on the line of an edge is on the edge.
fn is_between(point: Point, edge: &Edge) -> bool {
    (0..2).all(|axis| {
        let (from, to) = (edge.from[axis], edge.to[axis]);
        (from.min(to)..=from.max(to)).contains(&point[axis])
    })
}

fn sign(number: f64) -> i32 {
    i32::from(number > 0.0) - i32::from(number < 0.0)
}

/// Holes outside of the outline, or within each other. No edges cross.
fn nesting(rings: &[Vec<Point>]) -> Option<Flaw> {
    let (outer, holes) = rings.split_first()?;
    for (index, hole) in holes.iter().enumerate() {
        if let Some(&at) = hole.iter().find(|&&corner| side_of(outer, corner) == Some(false)) {
            return Some(Flaw::Outside { hole: index + 1, at });
        }
        for (earlier, other) in holes[..index].iter().enumerate() {
            let within = |ring: &[Point], corners: &[Point]| {
                corners.iter().copied().find(|&corner| side_of(ring, corner) == Some(true))
            };
            if let Some(near) = within(other, hole).or_else(|| within(hole, other)) {
                return Some(Flaw::Rings { rings: [earlier + 1, index + 1], near });
            }
        }
    }
    None
}

/// Whether a point is within a ring; `None` on it.
fn side_of(ring: &[Point], point: Point) -> Option<bool> {
    let mut is_inside = false;
    for (&from, &to) in edges(ring) {
        let edge = Edge { from, to, ring: 0, number: 0, count: 0 };
        let turn = turn_in_plane(from, to, point);
        if turn == 0.0 && is_between(point, &edge) {
            return None;
        }
        // Half open, so that a corner at the point's height counts once.
        if (from[1] <= point[1]) != (to[1] <= point[1]) && (turn > 0.0) == (to[1] > from[1]) {
            is_inside = !is_inside;
        }
    }
    Some(is_inside)
}

/// Whether a ring without flaws runs counterclockwise.
pub(super) fn is_counterclockwise(ring: &[Point]) -> bool {
    // At the lowest, then most western corner the ring turns as it runs, unless its neighbors are on one line with it.
    let count = ring.len();
    let at = |index: usize| ring[index % count];
    let lowest = (0..count).min_by(|&a, &b| ring[a][1].total_cmp(&ring[b][1]).then(ring[a][0].total_cmp(&ring[b][0])));
    let lowest = lowest.unwrap_or_default();
    turn_in_plane(at(lowest + count - 1), at(lowest), at(lowest + 1)) > 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ring(corners: &[(f64, f64)]) -> Vec<Point> {
        corners.iter().map(|&(x, y)| [x, y]).collect()
    }

    fn square(x: f64, y: f64, side: f64) -> Vec<Point> {
        ring(&[(x, y), (x + side, y), (x + side, y + side), (x, y + side)])
    }

    #[test]
    fn flaws_are_found_in_each_kind() {
        let bow_tie = ring(&[(0.0, 0.0), (10.0, 10.0), (10.0, 0.0), (0.0, 10.0)]);
        assert!(matches!(flaw(&[bow_tie]), Some(Flaw::Crossing { ring: 0, edges: [1, 3], .. })));
        let spike = ring(&[(0.0, 0.0), (10.0, 0.0), (5.0, 0.0), (5.0, 5.0)]);
        assert!(matches!(flaw(&[spike]), Some(Flaw::Crossing { .. })));
        let pinch = ring(&[(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (2.0, 0.0), (0.0, 4.0)]);
        assert!(matches!(flaw(&[pinch]), Some(Flaw::Crossing { .. })));
        assert!(matches!(flaw(&[ring(&[(0.0, 0.0), (1.0, 1.0), (3.0, 3.0)])]), Some(Flaw::Flat { ring: 0 })));
        assert!(matches!(flaw(&[ring(&[(0.0, 0.0), (0.0, 0.0), (3.0, 1.0)])]), Some(Flaw::Twice { ring: 0, .. })));
        let outer = square(0.0, 0.0, 10.0);
        assert!(matches!(flaw(&[outer.clone(), square(20.0, 0.0, 2.0)]), Some(Flaw::Outside { hole: 1, .. })));
        assert!(matches!(flaw(&[outer.clone(), square(9.0, 5.0, 2.0)]), Some(Flaw::Rings { rings: [0, 1], .. })));
        let holes = [outer.clone(), square(1.0, 1.0, 4.0), square(2.0, 2.0, 1.0)];
        assert!(matches!(flaw(&holes), Some(Flaw::Rings { rings: [1, 2], .. })));
    }

    #[test]
    fn what_only_touches_is_no_flaw() {
        let outer = square(0.0, 0.0, 10.0);
        assert_eq!(flaw(&[outer.clone(), square(0.0, 2.0, 3.0), square(3.0, 2.0, 3.0)]), None);
        // A hair's breadth of room, which a tolerance would not see.
        let near = ring(&[(0.0, 0.0), (10.0, 0.0), (10.0, 5.0), (5.0, f64::MIN_POSITIVE), (0.0, 5.0)]);
        assert_eq!(flaw(&[near]), None);
    }

    #[test]
    fn directions_are_told_at_the_lowest_corner() {
        let mut ring = ring(&[(0.0, 0.0), (2.0, 0.0), (5.0, 0.0), (5.0, 5.0)]);
        assert!(is_counterclockwise(&ring));
        ring.reverse();
        assert!(!is_counterclockwise(&ring));
    }
}
