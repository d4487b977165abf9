//! Level: which instructions the inner loops are compiled for, chosen when the program runs.
//!
//! Every level draws the same bytes: an addition, a product and a quotient are rounded alike in one lane and in eight, and nothing is
//! fused. So a level is a matter of time only, and tests run all of them.

use fearless_simd::Level;

/// Instructions for the inner loops.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Instructions {
    /// None but those of the language: eight lanes are a loop.
    Plain,
    /// What every processor of this kind has: SSE2, NEON.
    Baseline,
    /// Eight lanes: AVX2 (x86-64-v3), if the processor has it.
    Avx2,
    /// The best there is.
    #[default]
    Best,
}

/// Shortcuts that save time and change nothing; each can be left out, to measure it and to test what is behind it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shortcuts {
    /// Boxes of up to four samples are drawn one sample after the other, not eight at a time.
    pub tiny: bool,
    /// Blocks outside an edge are left out; inside all edges, edges are not looked at.
    pub blocks: bool,
    /// Blocks in which a polygon is nowhere nearer than the farthest that is there are left out.
    pub far: bool,
}

impl Default for Shortcuts {
    fn default() -> Self {
        Shortcuts { tiny: true, blocks: true, far: true }
    }
}

impl Instructions {
    /// All of them, slowest first.
    pub const ALL: [Instructions; 4] =
        [Instructions::Plain, Instructions::Baseline, Instructions::Avx2, Instructions::Best];

    /// A level that this processor has.
    pub(super) fn level(self) -> Level {
        let best = Level::new();
        match self {
            Instructions::Plain => Level::fallback(),
            Instructions::Baseline => baseline(best),
            Instructions::Avx2 => avx2(best),
            Instructions::Best => best,
        }
    }
}

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
fn baseline(best: Level) -> Level {
    best.as_sse2().map_or(best, Level::Sse2)
}

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
fn avx2(best: Level) -> Level {
    best.as_avx2().map_or(best, Level::Avx2)
}

#[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
fn baseline(best: Level) -> Level {
    best
}

#[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
fn avx2(best: Level) -> Level {
    best
}
