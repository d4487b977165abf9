//! Level: what the inner loops are compiled for ([`Instructions`]), and what they leave out.

pub use crate::screen::{Instructions, VARIABLE};

/// Shortcuts that save time and change nothing; each can be left out, to measure it and to test what is behind it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shortcuts {
    /// Polygons in squares of 8 x 8 samples are decided when they are binned.
    pub small: bool,
    /// Blocks outside an edge are left out; inside all edges, edges are not looked at.
    pub blocks: bool,
    /// Blocks in which a polygon is nowhere nearer than the farthest that is there are left out.
    pub far: bool,
}

impl Default for Shortcuts {
    fn default() -> Self {
        Shortcuts { small: true, blocks: true, far: true }
    }
}
