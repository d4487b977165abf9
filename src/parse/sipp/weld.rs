//! Welds vertices that are written in place: SIPP's rule, inside one surface.
//!
//! Two vertices are the same when position, texture coordinates and normal differ by at most 1e-10 of the distance of the
//! first two distinct positions, in every coordinate. (NFF is welded by equal bits; SIPP's own scenes count on this.)
//!
//! Why cells: a tolerance has no hash of its own. Positions go into cells eight tolerances wide, so equal ones are in
//! the same cell or, near its wall, in the next; nearly always one cell is looked at. Of several equal vertices the first wins.
//!
//! Source: facts of SIPP 3.1. Cost: constant a vertex.

use crate::math::Vec3;
use std::collections::HashMap;

/// A vertex as written.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Vertex {
    pub position: Vec3,
    /// Unit; zero: none given.
    pub normal: Vec3,
    pub texture: Option<Vec3>,
}

/// Distinct vertices so far.
#[derive(Default)]
pub(super) struct Weld {
    pub vertices: Vec<Vertex>,
    /// 0 until two distinct positions are known.
    tolerance: f64,
    /// The vertices of a cell, oldest first. Only looked up, never walked.
    cells: HashMap<[u64; 3], Vec<u32>>,
}

/// Of the distance of the first two distinct positions.
const RELATIVE_TOLERANCE: f64 = 1e-10;
/// In tolerances.
const CELL_WIDTH: f64 = 8.0;

impl Weld {
    /// The index of a vertex equal to this one; added if there is none.
    pub fn index(&mut self, vertex: Vertex) -> u32 {
        if self.tolerance == 0.0 && self.vertices.first().is_some_and(|first| first.position != vertex.position) {
            self.learn_tolerance(vertex.position);
        }
        if let Some(index) = self.find(&vertex) {
            return index;
        }
        let index = self.vertices.len() as u32;
        self.vertices.push(vertex);
        self.cells.entry(self.cell(vertex.position)).or_default().push(index);
        index
    }

    /// The second distinct position has come: cells now have their size, and those so far move.
    fn learn_tolerance(&mut self, second: Vec3) {
        self.tolerance = (second - self.vertices[0].position).length() * RELATIVE_TOLERANCE;
        self.cells.clear();
        for (index, vertex) in self.vertices.iter().enumerate() {
            self.cells.entry(self.cell(vertex.position)).or_default().push(index as u32);
        }
    }

    fn find(&self, vertex: &Vertex) -> Option<u32> {
        let (low, high) = (self.cell(vertex.position - self.tolerance), self.cell(vertex.position + self.tolerance));
        let mut found: Option<u32> = None;
        for corner in 0..8 {
            // Only the cells that the tolerance reaches; each once.
            let picks = [corner & 1, corner >> 1 & 1, corner >> 2 & 1];
            if (0..3).any(|axis| picks[axis] == 1 && low[axis] == high[axis]) {
                continue;
            }
            let cell: [u64; 3] = std::array::from_fn(|axis| if picks[axis] == 1 { high[axis] } else { low[axis] });
            let here = self.cells.get(&cell).into_iter().flatten();
            let first = here.copied().find(|&index| self.is_same(&self.vertices[index as usize], vertex));
            found = [found, first].into_iter().flatten().min();
        }
        found
    }

    fn is_same(&self, a: &Vertex, b: &Vertex) -> bool {
        let near = |a: Vec3, b: Vec3| (a - b).abs().max_element() <= self.tolerance;
        let texture = match (a.texture, b.texture) {
            (None, None) => true,
            (Some(a), Some(b)) => near(a, b),
            _ => false,
        };
        near(a.position, b.position) && near(a.normal, b.normal) && texture
    }

    fn cell(&self, position: Vec3) -> [u64; 3] {
        let width = self.tolerance * CELL_WIDTH;
        // Without a width all are in one cell. Adding 0 makes -0 and 0 the same.
        let cell = |x: f64| if width > 0.0 { ((x / width).floor() + 0.0).to_bits() } else { 0 };
        [cell(position.x), cell(position.y), cell(position.z)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(x: f64) -> Vertex {
        Vertex { position: Vec3::new(x, 0.0, -0.0), ..Vertex::default() }
    }

    #[test]
    fn the_first_two_distinct_vertices_set_the_scale() {
        let mut weld = Weld::default();
        assert_eq!([at(0.0), at(0.0), at(100.0)].map(|vertex| weld.index(vertex)), [0, 0, 1]);
        assert_eq!(weld.index(at(0.9e-8)), 0);
        assert_eq!(weld.index(at(-0.9e-8)), 0, "beyond the wall of a cell");
        assert_eq!(weld.index(at(1.1e-8)), 2);
        assert_eq!(weld.index(at(100.0 + 0.9e-8)), 1);
        assert_eq!(weld.index(at(100.0 + 1.1e-8)), 3);
    }

    #[test]
    fn normal_and_texture_keep_apart() {
        let mut weld = Weld::default();
        weld.index(at(0.0));
        weld.index(at(1.0));
        let smooth = Vertex { normal: Vec3::Z, ..at(0.0) };
        let painted = Vertex { texture: Some(Vec3::ZERO), ..at(0.0) };
        assert_eq!([smooth, painted, smooth, painted, at(0.0)].map(|vertex| weld.index(vertex)), [2, 3, 2, 3, 0]);
    }

    /// Against comparing with all.
    #[test]
    fn cells_find_what_comparing_with_all_finds() {
        let mut state = 7u64;
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 60) as f64 * 0.4e-10 - 3e-10
        };
        let mut weld = Weld::default();
        weld.index(Vertex::default());
        weld.index(at(1.0));
        let mut slow = weld.vertices.clone();
        for _ in 0..2000 {
            let vertex = Vertex { position: Vec3::new(random(), random(), random()), ..Vertex::default() };
            let expected = slow.iter().position(|known| weld.is_same(known, &vertex)).unwrap_or_else(|| {
                slow.push(vertex);
                slow.len() - 1
            });
            assert_eq!(weld.index(vertex) as usize, expected);
        }
        assert!(slow.len() > 20 && slow.len() < 1000, "{}", slow.len());
    }
}
