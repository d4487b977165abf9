//! Welds vertices: NFF repeats a vertex for every polygon around it, a mesh stores it once.
//!
//! Vertices are the same when position and normal are equal bit by bit: numbers written alike are, and nothing is
//! moved. (A tolerance would need a scale, and would join what the scene keeps apart.)
//!
//! Why an own table: it is asked once for every vertex of the file. It stores only indices, the vertices themselves are
//! the mesh's, so it adds 8 to 16 bytes a vertex, and emptying it for the next surface costs nothing.
//! Source: open addressing with linear probing, D. Knuth, The Art of Computer Programming 3, 6.4.
//! Cost: constant a vertex, one or two cache misses on a large surface.

use crate::math::Vec3;
use crate::scene::Mesh;

/// Where in a mesh a vertex is, by its bits.
#[derive(Clone, Debug, Default)]
pub(super) struct Weld {
    /// Index of a vertex plus 1, or 0 for a free slot; a power of two, at most half of them taken.
    slots: Vec<u32>,
}

const SMALLEST: usize = 64;

impl Weld {
    /// Forgets all vertices: the mesh is a new one.
    pub(super) fn clear(&mut self) {
        self.slots.clear();
    }

    /// Index in `mesh` of the vertex with this position and normal (zero: none given); added if it is new.
    pub(super) fn vertex(&mut self, mesh: &mut Mesh, position: Vec3, normal: Vec3) -> u32 {
        if mesh.vertices.len() * 2 >= self.slots.len() {
            self.grow(mesh);
        }
        let key = key(position, normal);
        let mut slot = self.first_slot(key);
        loop {
            match self.slots[slot] {
                0 => break,
                taken if is_same(key_in(mesh, taken - 1), key) => return taken - 1,
                _ => slot = (slot + 1) & (self.slots.len() - 1),
            }
        }
        let index = if normal == Vec3::ZERO {
            mesh.push_vertex(position)
        } else {
            mesh.push_vertex_with_normal(position, normal)
        };
        self.slots[slot] = index + 1;
        index
    }

    /// Makes room for four times as many vertices.
    fn grow(&mut self, mesh: &Mesh) {
        let size = (self.slots.len() * 4).max(SMALLEST);
        self.slots.clear();
        self.slots.resize(size, 0);
        for index in 0..mesh.vertices.len() as u32 {
            let mut slot = self.first_slot(key_in(mesh, index));
            while self.slots[slot] != 0 {
                slot = (slot + 1) & (size - 1);
            }
            self.slots[slot] = index + 1;
        }
    }

    fn first_slot(&self, key: [u64; 6]) -> usize {
        // Six products that need not wait for each other, turned so that no two meet in the same bits; the last product brings high
        // bits, which alone differ between round numbers, everywhere.
        const FACTOR: u64 = 0x9E37_79B9_7F4A_7C15;
        let product = |number: usize| key[number].wrapping_mul(FACTOR).rotate_left(11 * number as u32);
        let sum = (product(0) ^ product(1) ^ product(2)).wrapping_add(product(3) ^ product(4) ^ product(5));
        let mixed = (sum ^ (sum >> 32)).wrapping_mul(FACTOR);
        (mixed >> 32) as usize & (self.slots.len() - 1)
    }
}

fn key(position: Vec3, normal: Vec3) -> [u64; 6] {
    [position.x, position.y, position.z, normal.x, normal.y, normal.z].map(f64::to_bits)
}

/// Equal bits, without a branch for each word.
fn is_same(a: [u64; 6], b: [u64; 6]) -> bool {
    a.iter().zip(b).fold(0, |different, (&a, b)| different | (a ^ b)) == 0
}

fn key_in(mesh: &Mesh, index: u32) -> [u64; 6] {
    let index = index as usize;
    key(mesh.vertices[index], mesh.normals.get(index).copied().unwrap_or(Vec3::ZERO))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_bits_share_a_vertex() {
        let (mut weld, mut mesh) = (Weld::default(), Mesh::default());
        let mut vertex = |x: f64, normal| weld.vertex(&mut mesh, Vec3::new(x, 0.0, 0.0), normal);
        assert_eq!(vertex(1.0, Vec3::ZERO), 0);
        assert_eq!(vertex(2.0, Vec3::ZERO), 1);
        assert_eq!(vertex(1.0, Vec3::Z), 2, "another normal");
        assert_eq!(vertex(1.0, Vec3::ZERO), 0);
        assert_eq!(vertex(1.0, Vec3::Z), 2);
        assert_eq!(vertex(0.0, Vec3::ZERO), 3);
        assert_eq!(vertex(-0.0, Vec3::ZERO), 4, "-0 has other bits");
        assert_eq!(mesh.normals.len(), 5);
    }

    #[test]
    fn thousands_of_vertices_are_found_again() {
        let (mut weld, mut mesh) = (Weld::default(), Mesh::default());
        for round in 0..2 {
            for i in 0..10_000u32 {
                let position = Vec3::new(f64::from(i % 100), f64::from(i / 100) * 0.5, 1.0);
                assert_eq!(weld.vertex(&mut mesh, position, Vec3::ZERO), i, "round {round}");
            }
        }
        assert!(weld.slots.len() >= 2 * mesh.vertices.len());
    }
}
