//! The grid that screen coordinates are snapped to.
//!
//! Why snap at all: on a grid, which samples a polygon covers is a question about whole numbers and has an exact
//! answer. Why not to whole samples, as FAROP did: that gets 14 % of the pixels along edges wrong, 8 bits 0.06 %.

/// Coordinates are multiples of 2^-bits samples; with [`Grid::EXACT`] they are what they are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Grid {
    /// Sub-pixel bits, 0 to 16; or those of [`Grid::EXACT`].
    pub bits: u32,
}

impl Grid {
    /// No grid: nothing is snapped, and coverage is decided on the homogeneous corners (`--subpixel-bits exact`).
    pub const EXACT: Grid = Grid { bits: crate::plan::EXACT_SUBPIXELS };

    /// Whether nothing is snapped.
    #[must_use]
    pub fn is_exact(self) -> bool {
        self == Grid::EXACT
    }

    /// Grid steps in one sample. Without a grid, those of the finest there is, for algorithms that need one all the same.
    #[must_use]
    pub fn steps(self) -> i64 {
        1 << self.bits.min(16)
    }

    /// The grid point nearest to `coordinate`; halfway between two, the even one. Without a grid, itself.
    #[must_use]
    #[inline]
    pub fn snap(self, coordinate: f64) -> f64 {
        if self.is_exact() {
            return coordinate;
        }
        let steps = self.steps() as f64;
        // Multiplying by a power of two rounds nothing.
        round_to_even(coordinate * steps) * (1.0 / steps)
    }

    /// A snapped coordinate in grid steps; exact if there is a grid.
    #[must_use]
    pub fn fixed(self, snapped: f64) -> i64 {
        (snapped * self.steps() as f64) as i64
    }
}

/// As [`f64::round_ties_even`], to the last bit, but without a call where the processor has no instruction for it.
#[inline]
fn round_to_even(x: f64) -> f64 {
    // Above 2^52 there is no place for a fraction: adding that much leaves a whole number, rounded as ever to the nearest and to
    // even in between.
    const WHOLE: f64 = (1_u64 << 52) as f64;
    let rounded = ((x.abs() + WHOLE) - WHOLE).copysign(x);
    if x.abs() < WHOLE { rounded } else { x }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_without_a_call_is_rounding() {
        let edges =
            [0.0, 0.5, 1.5, 2.5, 0.49999999999999994, 4503599627370495.5, 4503599627370496.0, 1e300, f64::INFINITY];
        let some = (0..1000).map(|i| f64::from(i) * 0.37);
        for x in edges.into_iter().chain(some).flat_map(|x| [x, -x]) {
            assert_eq!(round_to_even(x).to_bits(), x.round_ties_even().to_bits(), "{x}");
        }
        assert!(round_to_even(f64::NAN).is_nan());
    }

    #[test]
    fn halves_go_to_the_even_step() {
        let grid = Grid { bits: 1 };
        assert_eq!([0.25, 0.75, 1.25, -0.25].map(|x| grid.snap(x)), [0.0, 1.0, 1.0, 0.0]);
        assert_eq!(grid.fixed(1.5), 3);
        assert_eq!(Grid { bits: 0 }.snap(7.49), 7.0);
    }
}
