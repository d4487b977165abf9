//! Judge: what is wrong with a list of triangles. Whole numbers, no rounding.

use super::{Case, Whole};
use crate::math::edges;

/// Twice the area of a triangle; positive when counterclockwise.
pub(super) fn turn(a: Whole, b: Whole, c: Whole) -> i128 {
    let [abx, aby] = [0, 1].map(|axis| i128::from(b[axis]) - i128::from(a[axis]));
    let [acx, acy] = [0, 1].map(|axis| i128::from(c[axis]) - i128::from(a[axis]));
    abx * acy - aby * acx
}

/// Twice the area of a ring.
pub(super) fn doubled_area(ring: &[Whole]) -> i128 {
    edges(ring).map(|(&a, &b)| turn(ring[0], a, b)).sum()
}

/// The corners of a triangle.
pub(super) fn corners(ring: &[Whole], triangle: [u32; 3]) -> [Whole; 3] {
    triangle.map(|index| ring[index as usize])
}

/// Whether a point lies inside an edge, not at its ends.
pub(super) fn is_within_edge(a: Whole, b: Whole, p: Whole) -> bool {
    let between = |axis: usize| p[axis] >= a[axis].min(b[axis]) && p[axis] <= a[axis].max(b[axis]);
    turn(a, b, p) == 0 && between(0) && between(1) && p != a && p != b
}

/// What is wrong, in one sentence.
pub(super) fn complaint(case: &Case, triangles: &[[u32; 3]]) -> Option<String> {
    let (ring, count) = (&case.ring, case.ring.len());
    for (number, triangle) in triangles.iter().enumerate() {
        if let Some(index) = triangle.iter().find(|&&index| index as usize >= count) {
            return Some(format!(
                "triangle {number}, {triangle:?}, names corner {index}; there are 0 to {}",
                count - 1
            ));
        }
        if triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[0] == triangle[2] {
            return Some(format!("triangle {number}, {triangle:?}, names a corner twice"));
        }
    }
    if triangles.len() != count - 2 {
        return Some(format!("{} triangles for {count} corners; {} are expected", triangles.len(), count - 2));
    }
    let area = |triangle: &[u32; 3]| {
        let [a, b, c] = corners(ring, *triangle);
        turn(a, b, c)
    };
    if let Some(number) = triangles.iter().position(|triangle| area(triangle) < 0) {
        return Some(format!("triangle {number}, {:?}, runs the other way round", triangles[number]));
    }
    let (sum, whole) = (triangles.iter().map(area).sum::<i128>(), doubled_area(ring));
    if sum != whole {
        return Some(format!("the areas of the triangles add up to {}, not {}", half(sum), half(whole)));
    }
    edge_complaint(triangles, count as u32).or_else(|| junction(case, triangles))
}

/// An area in words from twice the area.
fn half(doubled: i128) -> String {
    if doubled % 2 == 0 { format!("{}", doubled / 2) } else { format!("{doubled}/2") }
}

fn directed(triangles: &[[u32; 3]]) -> Vec<(u32, u32)> {
    triangles.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]).collect()
}

/// Every edge of the outline once, every other once in each direction.
fn edge_complaint(triangles: &[[u32; 3]], count: u32) -> Option<String> {
    let all = directed(triangles);
    for index in 0..count {
        let edge = (index, (index + 1) % count);
        let times = all.iter().filter(|&&other| other == edge).count();
        if times != 1 {
            return Some(format!("the outline's edge {} - {} is in {times} triangles, not in one", edge.0, edge.1));
        }
    }
    let lonely =
        all.iter().find(|&&(a, b)| (a + 1) % count != b && all.iter().filter(|&&other| other == (b, a)).count() != 1);
    lonely.map(|(a, b)| format!("the diagonal {a} - {b} has not one triangle on each side"))
}

/// A corner inside of a triangle's edge. An outline that touches itself cannot always do without.
fn junction(case: &Case, triangles: &[[u32; 3]]) -> Option<String> {
    let ring = &case.ring;
    directed(triangles).into_iter().filter(|_| case.is_simple).find_map(|(a, b)| {
        let (from, to) = (ring[a as usize], ring[b as usize]);
        let corner = ring.iter().position(|&p| is_within_edge(from, to, p))?;
        Some(format!("the edge {a} - {b} runs through corner {corner}"))
    })
}

/// The triangle that is missing when all others are there.
pub(super) fn missing(case: &Case, triangles: &[[u32; 3]]) -> Option<[u32; 3]> {
    let count = case.ring.len() as u32;
    let all = directed(triangles);
    // Edges of the outline, and diagonals backward, that no triangle has.
    let outline = (0..count).map(|index| (index, (index + 1) % count));
    let backward = all.iter().filter(|&&(a, b)| (a + 1) % count != b).map(|&(a, b)| (b, a));
    let open: Vec<_> = outline.chain(backward).filter(|edge| !all.contains(edge)).collect();
    match open[..] {
        [(a, b), ..] if open.len() == 3 => open.iter().find(|edge| edge.0 == b).map(|edge| [a, b, edge.1]),
        _ => None,
    }
}
