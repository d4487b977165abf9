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
    /// Surfaces with holes are compared in lanes, and alpha is looked up of what would win; without it, sample by sample.
    pub holes: bool,
    /// Light is found in lanes; without it, sample by sample.
    pub light: bool,
}

impl Shortcuts {
    /// All of them or none.
    #[must_use]
    pub fn all(taken: bool) -> Shortcuts {
        Shortcuts { small: taken, blocks: taken, far: taken, holes: taken, light: taken }
    }
}

impl Default for Shortcuts {
    fn default() -> Self {
        Shortcuts::all(true)
    }
}
