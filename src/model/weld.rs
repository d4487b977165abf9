//! Weld: a vertex on the border of a net's pieces, found again when the neighbor comes to it.
//!
//! Why by position and not by index: files repeat control points, and a border may run the other way in the neighbor. Both
//! compute it to the same bits (`bezier`), so equal bits are enough and no distance has to be chosen.
//! Why the normal counts too: where two pieces meet in a crease each keeps its own; the positions still agree, so nothing opens.
//!
//! Cost: one look-up a border vertex; interior vertices have no neighbors outside their piece.

use super::Sheet;
use crate::math::Vec3;
use std::collections::HashMap;

/// Normals this close (radians) are one: less than a quarter of a color level, and far above rounding.
const SAME_NORMAL: f64 = 1e-3;

/// The border vertices of one net so far.
#[derive(Default)]
pub(super) struct Weld {
    known: HashMap<[u64; 3], Vec<(u32, Vec3)>>,
}

impl Weld {
    /// The vertex at `position` with `normal`: one that is there, or a new one.
    pub fn vertex(&mut self, position: Vec3, normal: Vec3, sheet: &mut Sheet<'_>) -> u32 {
        // Adding zero turns -0 into 0.
        let here = self.known.entry(position.to_array().map(|x| (x + 0.0).to_bits())).or_default();
        let same = here.iter().find(|(_, other)| (*other - normal).length() <= SAME_NORMAL);
        if let Some(&(index, _)) = same {
            return index;
        }
        let index = sheet.vertex(position, normal);
        here.push((index, normal));
        index
    }
}
