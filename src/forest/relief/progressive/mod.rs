//! Progressive: a relief as a stream of halvings, of which any beginning is a relief.
//!
//! Hierarchy -WRITE-> bytes, as many as there is time for -READ-> ReliefMesh, and how far it may be off
//!
//! Halvings stand in order of their bounds, the worst first, in bands of a factor of the square root of two; within a band the coarse
//! ones first. A diamond's parents have no smaller bound and a coarser level, so they always stand before it: cut the stream anywhere,
//! and what is left is a mesh without cracks. All that is missing then has a bound below that of its band: the error is known, too.
//!
//! A halving is two numbers of variable length: how many places after the one before it stands, and how far its height is from the
//! middle of its hypotenuse. Both are small; most take one byte each. Every chunk (one level of one band) ends with a checksum, so a
//! stream that was cut is told apart from one that was damaged.
//!
//! Bytes: `docs/terrain.md`. Units: metres; heights are whole numbers of a step that the stream names.
//! Source: H. Hoppe, "Progressive Meshes", SIGGRAPH 1996, for the idea; order and code are ours. Cost: 2 to 4 bytes a halving.

mod code;
mod read;
mod write;

pub use read::read;
pub use write::{stepped, write};

use super::mesh::ReliefMesh;
use crate::forest::elevation::Grid;

/// The first bytes.
const MAGIC: &[u8; 8] = b"FRELIEF1";
/// A height that is no whole number of metres is rounded to this step.
const FINE_STEP: f64 = 1.0 / 64.0;
/// Bytes of the head in front of the name: magic, columns, rows, unit, frame, step, four corners, the bound of two triangles, length of the name.
const HEAD: usize = 8 + 4 + 4 + 1 + 4 * 8 + 8 + 4 * 4 + 4 + 2;
/// Bytes in front of the halvings of a chunk: level, number of halvings, number of bytes, the bound of the band.
const CHUNK: usize = 1 + 4 + 4 + 4;

/// Why bytes are no relief.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ProgressiveError {
    /// Not such a stream, or not even its head.
    #[error("byte {at}: {what}")]
    Head {
        /// Where, from 0.
        at: usize,
        /// What is wrong and what is expected.
        what: String,
    },
    /// A chunk that is whole does not say what was written.
    #[error(
        "the chunk at byte {at} is damaged: {what}; what stands before it is whole, so the first {at} bytes are a relief of their own"
    )]
    Chunk {
        /// Where it begins.
        at: usize,
        /// What is wrong.
        what: String,
    },
    /// Voids have no place in it.
    #[error("{voids} samples are voids, and a progressive relief has none; fill them first (--fill N)")]
    Voids {
        /// How many.
        voids: usize,
    },
}

/// What the beginning of a stream says.
#[derive(Clone, Debug)]
pub struct Received {
    /// The relief read at every sample: as far from the true heights as the mesh is.
    pub grid: Grid,
    /// The relief.
    pub mesh: ReliefMesh,
    /// No sample is farther from it than this, in metres.
    pub bound: f64,
    /// Halvings that were read.
    pub halvings: usize,
    /// Nothing is missing.
    pub is_whole: bool,
}

#[cfg(test)]
mod tests {
    use super::super::Hierarchy;
    use super::super::mesh::edge_uses;
    use super::super::tests::{grid, hills, with_voids};
    use super::super::{mesh, quality};
    use super::*;

    fn stream(grid: &Grid) -> (Grid, Vec<u8>) {
        let (stepped, step) = stepped(grid);
        let mut bytes = Vec::new();
        write(&Hierarchy::new(&stepped), step, &mut bytes).expect("no voids");
        (stepped, bytes)
    }

    /// An edge of one face lies on the border, one of two within.
    fn has_no_crack(grid: &Grid, mesh: &ReliefMesh) -> bool {
        let on_border = |at: u32| {
            let point = mesh.vertices[at as usize].point;
            [point.x == 0, point.y == 0, point.x as usize + 1 == grid.columns(), point.y as usize + 1 == grid.rows()]
        };
        edge_uses(mesh).iter().all(|(&(a, b), &uses)| {
            let is_border = on_border(a).iter().zip(on_border(b)).any(|(&a, b)| a && b);
            uses == if is_border { 1 } else { 2 }
        })
    }

    #[test]
    fn every_beginning_is_a_relief_within_its_bound() {
        for original in [hills(65, 65), hills(50, 37), grid(9, 40, |x, y| (x * y) as f32 / 3.0)] {
            let (stepped, bytes) = stream(&original);
            let mut last = f64::INFINITY;
            let mut seen = 0;
            for length in (0..bytes.len()).step_by(7).chain([bytes.len()]) {
                let Ok(received) = read("cut", &bytes[..length]) else { continue };
                seen += 1;
                let found = quality(&stepped, &received.mesh);
                assert!(found.largest <= received.bound, "{length} bytes: {found:?}, {} promised", received.bound);
                assert!(received.bound <= last && found.uncovered == 0);
                assert!(has_no_crack(&stepped, &received.mesh), "{length} bytes");
                assert_eq!(received.is_whole, length == bytes.len());
                last = received.bound;
            }
            assert!(7 * seen + 100 > bytes.len(), "{seen} of {} lengths", bytes.len());
            assert_eq!(last, 0.0);
        }
    }

    #[test]
    fn the_whole_is_the_mesh_without_error() {
        let (stepped, bytes) = stream(&hills(40, 33));
        let hierarchy = Hierarchy::new(&stepped);
        let received = read("whole", &bytes).expect("it is whole");
        assert_eq!(received.mesh, mesh::within(&hierarchy, 0.0));
        assert_eq!(received.grid.heights(), stepped.heights());
        assert_eq!(received.grid.frame, stepped.frame);
    }

    #[test]
    fn flat_land_is_its_head() {
        let (_, bytes) = stream(&grid(33, 33, |_, _| 7.0));
        let received = read("flat", &bytes).expect("it is whole");
        assert!(received.is_whole && received.halvings == 0 && received.mesh.triangles() == 2);
        assert_eq!(received.bound, 0.0);
    }

    #[test]
    fn a_changed_byte_is_told_with_its_place() {
        let (stepped, bytes) = stream(&hills(20, 33));
        for at in 0..bytes.len() {
            let mut changed = bytes.clone();
            changed[at] ^= 0x20;
            match read("changed", &changed) {
                Err(ProgressiveError::Head { .. }) => assert!(at < HEAD + 4 + stepped.name.len(), "{at}"),
                // What stands before it is a relief.
                Err(ProgressiveError::Chunk { at: start, .. }) => {
                    assert!(start <= at && read("before", &changed[..start]).is_ok(), "{at} {start}");
                }
                Err(ProgressiveError::Voids { .. }) => panic!("{at}"),
                // A length that grew makes the chunk reach beyond the end: it looks cut there, and is a relief up to it.
                Ok(received) => assert!(!received.is_whole, "{at}"),
            }
        }
    }

    #[test]
    fn voids_are_refused() {
        let grid = with_voids(33, 30);
        let error = write(&Hierarchy::new(&grid), 1.0, &mut Vec::new()).expect_err("voids");
        assert!(error.to_string().contains("--fill"), "{error}");
    }
}
