//! Polygon: what lies inside, decided exactly.
//!
//! Patch -POLYGON-> is a tree in it, is a texel in it, does its outline cross itself
//!
//! Why exact: two stands share an outline. A tree near it must belong to one of them, not to both and not to none, whatever
//! rounding says. So the rule is half-open (a point on an edge belongs to the polygon right of the edge as it is walked upward), every edge is walked
//! upward, and the sign that decides is exact: neighbors ask the very same question and get the very same answer.
//!
//! Space: any plane, x to the right, y up; a cell's metres here. Coordinates of magnitude 1e-100 to 1e100, or 0, are decided exactly.
//! Source: J. R. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates", Discrete &
//! Computational Geometry 18, 1997. `geometry::predicates` has another way, which also takes subnormal numbers; it stands to the right of this room.
//! Cost: a comparison an edge; two products where the edge is level with the point; rarely a sum of twelve numbers.

use crate::math::edges;
use std::cmp::Ordering;

/// A position in the plane.
pub type Point = [f64; 2];

/// How `a`, `b`, `c` turn, as if computed without rounding: `Greater` is counterclockwise, `Equal` is on one line.
///
/// ```
/// use farop::forest::polygon::turn;
/// use std::cmp::Ordering;
/// assert_eq!(turn([0.0, 0.0], [1.0, 0.0], [0.0, 1.0]), Ordering::Greater);
/// // In plain f64 this determinant is 0.
/// assert_eq!(turn([0.5, 0.5_f64.next_up()], [12.0, 12.0], [24.0, 24.0]), Ordering::Greater);
/// ```
#[must_use]
#[inline]
pub fn turn(a: Point, b: Point, c: Point) -> Ordering {
    let left = (a[0] - c[0]) * (b[1] - c[1]);
    let right = (a[1] - c[1]) * (b[0] - c[0]);
    let determinant = left - right;
    // Shewchuk's `ccwerrboundA`: (3 + 16 u) u with u = 2^-53.
    let bound = (3.0 + 8.0 * f64::EPSILON) * (f64::EPSILON / 2.0) * (left.abs() + right.abs());
    if determinant.abs() > bound { determinant.total_cmp(&0.0) } else { exact_turn(a, b, c) }
}

/// The sign of a x b + b x c + c x a: six products, each as two numbers, added without loss.
#[cold]
fn exact_turn(a: Point, b: Point, c: Point) -> Ordering {
    let mut sum = [0.0_f64; 13];
    let mut length = 0;
    for (p, q) in [(a, b), (b, c), (c, a)] {
        for (s, t) in [(p[0], q[1]), (-p[1], q[0])] {
            let product = s * t;
            for term in [s.mul_add(t, -product), product] {
                length = add_term(&mut sum, length, term);
            }
        }
    }
    // Terms ascend in magnitude and do not overlap: the last one that is not 0 has the sign of all.
    sum[..length].iter().rev().find(|term| **term != 0.0).map_or(Ordering::Equal, |term| term.total_cmp(&0.0))
}

/// Adds a number to an exact sum of `length` terms; returns how many there are now (Shewchuk's GROW-EXPANSION).
fn add_term(sum: &mut [f64; 13], length: usize, mut term: f64) -> usize {
    for part in &mut sum[..length] {
        let total = term + *part;
        let virtual_part = total - term;
        *part = (term - (total - virtual_part)) + (*part - virtual_part);
        term = total;
    }
    sum[length] = term;
    length + 1
}

/// Whether the edge from `a` to `b` is crossed by the ray from `point` in the direction of x: ends above or level with the point are
/// "above", and a point on the edge is not left of it.
#[inline]
pub(super) fn crosses(a: Point, b: Point, point: Point) -> bool {
    if (a[1] > point[1]) == (b[1] > point[1]) {
        return false;
    }
    let (lower, upper) = if a[1] < b[1] { (a, b) } else { (b, a) };
    turn(lower, upper, point) == Ordering::Greater
}

/// Whether a point is in a polygon with holes: even-odd over all its rings, half-open.
///
/// Of polygons that share their corners and cover the plane without overlap, every point is in exactly one.
///
/// ```
/// use farop::forest::polygon::contains;
/// let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
/// assert!(contains(&square, &[], [0.5, 0.5]) && contains(&square, &[], [0.0, 0.0]) && !contains(&square, &[], [1.0, 0.5]));
/// ```
#[must_use]
pub fn contains(outer: &[Point], holes: &[Vec<Point>], point: Point) -> bool {
    let rings = std::iter::once(outer).chain(holes.iter().map(Vec::as_slice));
    rings.flat_map(edges).filter(|&(&a, &b)| crosses(a, b, point)).count() % 2 == 1
}

/// Twice the area would be an integer for whole coordinates; this is the area, positive where the ring is counterclockwise.
#[must_use]
pub fn area(ring: &[Point]) -> f64 {
    let Some(&first) = ring.first() else { return 0.0 };
    // Counted from a corner: far from the origin the products would cancel.
    let from_first = |p: &Point| [p[0] - first[0], p[1] - first[1]];
    let cross = |(a, b): (&Point, &Point)| {
        let (a, b) = (from_first(a), from_first(b));
        a[0] * b[1] - a[1] * b[0]
    };
    0.5 * edges(ring).map(cross).sum::<f64>()
}

/// Two edges of a polygon that meet where they should not: numbers of their first corners, counted through the rings, outer first.
///
/// Edges that follow each other may share their corner; all other edges must not even touch, and no edge may have length 0 or fold back.
/// Pairs are looked at from the left, and only as long as they overlap in x: n log n for outlines as they are drawn, n squared at worst.
/// Tests ask it about invented land; files are asked by their reader, which knows places and says what is wrong.
#[cfg(test)]
pub(in crate::forest) fn self_crossing(outer: &[Point], holes: &[Vec<Point>]) -> Option<[usize; 2]> {
    let mut all: Vec<(Point, Point, usize, usize)> = Vec::new();
    for ring in std::iter::once(outer).chain(holes.iter().map(Vec::as_slice)) {
        let start = all.len();
        let next = |index: usize| start + (index + 1) % ring.len();
        all.extend(edges(ring).enumerate().map(|(index, (&a, &b))| (a, b, start + index, next(index))));
    }
    all.sort_by(|one, other| one.0[0].min(one.1[0]).total_cmp(&other.0[0].min(other.1[0])));
    for (position, first) in all.iter().enumerate() {
        if first.0 == first.1 {
            return Some([first.2, first.2]);
        }
        let reach = first.0[0].max(first.1[0]);
        let near = all[position + 1..].iter().take_while(|second| second.0[0].min(second.1[0]) <= reach);
        for second in near {
            let in_order = if first.3 == second.2 {
                Some((first, second))
            } else {
                (second.3 == first.2).then_some((second, first))
            };
            let wrong = match in_order {
                Some((before, after)) => folds_back(before.0, before.1, after.1),
                None => touch(first.0, first.1, second.0, second.1),
            };
            if wrong {
                return Some([first.2.min(second.2), first.2.max(second.2)]);
            }
        }
    }
    None
}

/// Whether walking on from `b` to `c` goes back over the way from `a`.
#[cfg(test)]
fn folds_back(a: Point, b: Point, c: Point) -> bool {
    let ahead = (0..2).map(|axis| (b[axis] - a[axis]) * (c[axis] - b[axis])).sum::<f64>();
    turn(a, b, c) == Ordering::Equal && ahead <= 0.0
}

/// Whether two closed segments have a point in common.
#[cfg(test)]
fn touch(a: Point, b: Point, c: Point, d: Point) -> bool {
    let overlap =
        |axis: usize| a[axis].min(b[axis]) <= c[axis].max(d[axis]) && c[axis].min(d[axis]) <= a[axis].max(b[axis]);
    let not_one_side = |p: Ordering, q: Ordering| p == Ordering::Equal || q == Ordering::Equal || p != q;
    overlap(0) && overlap(1) && not_one_side(turn(a, b, c), turn(a, b, d)) && not_one_side(turn(c, d, a), turn(c, d, b))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::forest::random::{mix64, unit};

    /// A fan of triangles around a center; random points, and points on the shared edges, are in exactly one of them.
    #[test]
    fn neighbors_share_no_point_and_lose_none() {
        let rim: Vec<Point> = [[0.0, 0.0], [7.3, -0.1], [10.0, 0.3], [10.1, 9.7], [4.4, 10.0], [-0.2, 9.1]].to_vec();
        let center = [4.1, 5.3];
        let fan: Vec<Vec<Point>> = edges(&rim).map(|(&a, &b)| vec![center, a, b]).collect();
        let mut points: Vec<Point> = (0..2000)
            .map(|index| [0.1 + 9.0 * unit(mix64(2 * index)), 0.5 + 8.0 * unit(mix64(2 * index + 1))])
            .collect();
        for corner in &rim {
            points.extend((1..64).map(|step| {
                let share = f64::from(step) / 64.0;
                [center[0] + (corner[0] - center[0]) * share, center[1] + (corner[1] - center[1]) * share]
            }));
        }
        points.push(center);
        for point in points {
            let owners = fan.iter().filter(|triangle| contains(triangle, &[], point)).count();
            assert_eq!(owners, 1, "{point:?}");
        }
    }

    #[test]
    fn the_last_bit_of_a_coordinate_decides() {
        // Along the line y = x, points one bit off, where plain arithmetic says 0.
        for step in 1..200 {
            let at = 0.37 * f64::from(step);
            let above = turn([0.1, 0.1], [99.7, 99.7], [at, at.next_up()]);
            assert_eq!(above, Ordering::Greater, "{at}");
            assert_eq!(turn([99.7, 99.7], [0.1, 0.1], [at, at.next_up()]), Ordering::Less);
            assert_eq!(turn([0.1, 0.1], [99.7, 99.7], [at, at]), Ordering::Equal);
        }
    }

    #[test]
    fn holes_are_outside_and_areas_have_a_sign() {
        let outer = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]];
        let hole = vec![vec![[4.0, 4.0], [4.0, 6.0], [6.0, 6.0], [6.0, 4.0]]];
        assert!(!contains(&outer, &hole, [5.0, 5.0]) && contains(&outer, &hole, [3.0, 5.0]));
        assert_eq!((area(&outer), area(&hole[0]), area(&[])), (100.0, -4.0, 0.0));
    }

    #[test]
    fn outlines_that_meet_themselves_are_found() {
        let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
        let hole = |x: f64| vec![vec![[x, 1.0], [x, 2.0], [x + 1.0, 2.0]]];
        assert_eq!(self_crossing(&square, &hole(1.0)), None);
        assert!(self_crossing(&square, &hole(3.5)).is_some(), "a hole through the outline");
        assert!(self_crossing(&square, &hole(3.0)).is_some(), "a hole that touches it");
        assert_eq!(self_crossing(&[[0.0, 0.0], [4.0, 4.0], [4.0, 0.0], [0.0, 4.0]], &[]), Some([0, 2]), "a bow tie");
        assert!(self_crossing(&[[0.0, 0.0], [4.0, 0.0], [2.0, 0.0], [2.0, 3.0]], &[]).is_some(), "folds back");
        assert!(self_crossing(&[[0.0, 0.0], [0.0, 0.0], [2.0, 3.0]], &[]).is_some(), "a corner twice");
    }
}
