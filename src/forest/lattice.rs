//! Lattice: measured heights of a cell as counts.
//!
//! heights at the positions of a lattice -LATTICE-> Ground
//!
//! Why sixteenths of a metre from a whole metre on: both are exact in binary, so the samples on a common border of two cells, which
//! lie at the same place, have the same height to the last bit whatever else is in the cells.
//!
//! Space: metres. Cost: linear.

use super::area::Ground;

/// Metres of a count, doubled until the heights of a cell fit.
const STEP: f64 = 1.0 / 16.0;

/// Heights as counts of a power of two of a metre; not a number is a void.
#[must_use]
pub fn lattice(size: [u16; 2], heights: &[f64]) -> Ground {
    let known = || heights.iter().copied().filter(|height| !height.is_nan());
    let (low, high) = (known().fold(f64::INFINITY, f64::min), known().fold(f64::NEG_INFINITY, f64::max));
    let base = if low <= high { ((low + high) / 2.0).round() } else { 0.0 };
    let mut step = STEP;
    while (high - base).max(base - low) / step > f64::from(i16::MAX) {
        step *= 2.0;
    }
    let count = |height: f64| if height.is_nan() { Ground::VOID } else { ((height - base) / step).round() as i16 };
    Ground::Lattice { size, base, step, counts: heights.iter().map(|&height| count(height)).collect() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_height_has_the_same_bits_in_both_cells() {
        let shared = 412.34;
        let [left, right] =
            [[shared, 300.0, 410.0, 420.0], [shared, 2000.0, 1.0, 7.0]].map(|heights| lattice([2, 2], &heights));
        assert_eq!(left.sample(0, 0).to_bits(), right.sample(0, 0).to_bits());
        assert!((left.sample(0, 0) - shared).abs() <= STEP / 2.0);
        assert!(lattice([2, 2], &[f64::NAN; 4]).sample(0, 0).is_nan());
        let high = lattice([2, 2], &[-9000.0, 9000.0, 0.0, 0.5]);
        assert_eq!(high.sample(1, 0), 9000.0);
    }
}
