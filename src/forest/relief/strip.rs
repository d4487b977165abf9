//! Strip: the whole relief as one list of vertices, every three in a row a triangle.
//!
//! ReliefMesh along the Sierpinski curve -STRIP-> vertices
//!
//! The paper halves a strip's triangle of type B, right angle in the middle: {1,2,3} becomes {1,2,4,2,3}, two vertices more, one of the five
//! triples without area. It leaves A and C (right angle first and last) open. Along the Sierpinski curve every two triangles in a row share an
//! edge, so one rule serves all: the shared edge must be the last two vertices, in the order that leaves the corner both
//! edges of the triangle meet in behind; where it is not, that corner is repeated. Every second triple is turned round,
//! as in every graphics library, and triples with a vertex twice are dropped.
//!
//! Cost: between 1 and 2 vertices a triangle, instead of 3.

use super::mesh::ReliefMesh;

/// Every three in a row are a triangle, every second turned round; triples with a vertex twice are none.
#[must_use]
pub fn strip(mesh: &ReliefMesh) -> Vec<u32> {
    let triangles = triangles(mesh);
    let mut strip = Vec::with_capacity(2 * triangles.len());
    for (at, triangle) in triangles.iter().enumerate() {
        let next = triangles.get(at + 1);
        let entered = at.checked_sub(1).and_then(|before| shared(&triangles[before], triangle));
        match entered {
            Some(edge) if ends_in(&strip, edge) => go_on(&mut strip, triangle, edge, next),
            _ => begin(&mut strip, triangle, next),
        }
    }
    strip
}

/// The triangles that a strip says, each counterclockwise from its smallest index.
#[must_use]
pub fn unrolled(strip: &[u32]) -> Vec<[u32; 3]> {
    let triples = strip.windows(3).enumerate();
    let real = triples.filter(|(_, t)| t[0] != t[1] && t[1] != t[2] && t[2] != t[0]);
    real.map(|(at, t)| turned_first(if at % 2 == 0 { [t[0], t[1], t[2]] } else { [t[1], t[0], t[2]] })).collect()
}

/// The faces as triangles, in order, each counterclockwise from its smallest index.
#[must_use]
pub fn triangles(mesh: &ReliefMesh) -> Vec<[u32; 3]> {
    let fan = |outline: &[u32]| {
        let first = outline[0];
        outline[1..].windows(2).map(|pair| turned_first([first, pair[0], pair[1]])).collect::<Vec<_>>()
    };
    mesh.faces.iter().flat_map(|face| fan(mesh.outline(face))).collect()
}

/// The same triangle, its smallest index first.
fn turned_first([a, b, c]: [u32; 3]) -> [u32; 3] {
    if a < b && a < c {
        [a, b, c]
    } else if b < c {
        [b, c, a]
    } else {
        [c, a, b]
    }
}

/// The two vertices that two triangles have in common.
fn shared(one: &[u32; 3], other: &[u32; 3]) -> Option<[u32; 2]> {
    let mut both = one.iter().copied().filter(|vertex| other.contains(vertex));
    Some([both.next()?, both.next()?])
}

fn ends_in(strip: &[u32], edge: [u32; 2]) -> bool {
    matches!(strip, [.., a, b] if [*a, *b] == edge || [*b, *a] == edge)
}

/// Adds the third vertex; before it, once more the corner where the entered edge and the edge to the next triangle meet, if that is
/// not the last one.
fn go_on(strip: &mut Vec<u32>, triangle: &[u32; 3], edge: [u32; 2], next: Option<&[u32; 3]>) {
    let Some(&new) = triangle.iter().find(|vertex| !edge.contains(vertex)) else { return };
    let left = next.and_then(|next| shared(triangle, next));
    let pivot = left.and_then(|left| edge.into_iter().find(|vertex| left.contains(vertex)));
    if let (Some(pivot), Some(&last)) = (pivot, strip.last())
        && pivot != last
    {
        strip.push(pivot);
    }
    strip.push(new);
}

/// Begins anew, behind a bridge of triples without area.
fn begin(strip: &mut Vec<u32>, triangle: &[u32; 3], next: Option<&[u32; 3]>) {
    // The edge to the next triangle comes last.
    let left = next.and_then(|next| shared(triangle, next)).unwrap_or([triangle[1], triangle[2]]);
    let first = triangle.iter().position(|vertex| !left.contains(vertex)).unwrap_or(0);
    let [a, b, c] = [0, 1, 2].map(|step| triangle[(first + step) % 3]);
    if let Some(&last) = strip.last() {
        strip.extend([last, a]);
    }
    // An even place, or the triangle would be turned round.
    if strip.len() % 2 == 1 {
        strip.push(a);
    }
    strip.extend([a, b, c]);
}

#[cfg(test)]
mod tests {
    use super::super::tests::{hills, with_voids};
    use super::super::{Hierarchy, mesh};
    use super::*;

    #[test]
    fn a_strip_has_the_triangles_of_the_mesh() {
        // Where faces are cut or missing the strip begins anew more often.
        for (grid, most) in [(hills(33, 33), 1.8), (hills(50, 29), 2.5), (with_voids(40, 33), 2.5)] {
            let hierarchy = Hierarchy::new(&grid);
            for error in [0.0, 20.0, 100.0] {
                let mesh = mesh::within(&hierarchy, error);
                let strip = strip(&mesh);
                let (mut said, mut meant) = (unrolled(&strip), triangles(&mesh));
                said.sort_unstable();
                meant.sort_unstable();
                assert_eq!(said, meant, "{error}");
                let ratio = strip.len() as f64 / meant.len() as f64;
                assert!((1.0..most).contains(&ratio), "{error}: {ratio}");
            }
        }
    }

    #[test]
    fn the_papers_b_is_halved_as_the_paper_says() {
        // {1,2,4,2,3}: (1,2,4), (2,4,2) without area, (4,2,3).
        assert_eq!(unrolled(&[1, 2, 4, 2, 3]), [[1, 2, 4], [2, 3, 4]]);
        let grid = super::super::tests::grid(2, 2, |_, _| 0.0);
        let mesh = mesh::within(&Hierarchy::new(&grid), 0.0);
        assert_eq!((mesh.triangles(), strip(&mesh).len()), (2, 4));
    }
}
