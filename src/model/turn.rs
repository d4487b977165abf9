//! The corners of a regular n-gon on the unit circle, with the symmetry of the circle kept to the last bit.
//!
//! Why not cosine and sine of `2 PI i / n` alone: cos(PI/2) is 6e-17 and not 0, and a cylinder's left and right side
//! would differ in their last bits. Angles are brought into the first eighth of the circle while they are still integers.

use crate::math::{PI, cos, sin};

/// Cosine and sine of `i / n` turns; exact at quarter turns, and mirror images are equal to the bit. `n` is at least 1.
pub(super) fn turn(i: u32, n: u32) -> (f64, f64) {
    // Split into whole quarters and the rest, both counted in n-ths of a quarter.
    let quarters = u64::from(i) * 4 / u64::from(n);
    let rest = u64::from(i) * 4 % u64::from(n);
    let opposite = u64::from(n) - rest;
    let angle = |part: u64| PI / 2.0 * (part as f64 / f64::from(n));
    let (x, y) = match rest.cmp(&opposite) {
        std::cmp::Ordering::Less => (cos(angle(rest)), sin(angle(rest))),
        std::cmp::Ordering::Equal => (std::f64::consts::FRAC_1_SQRT_2, std::f64::consts::FRAC_1_SQRT_2),
        std::cmp::Ordering::Greater => (sin(angle(opposite)), cos(angle(opposite))),
    };
    match quarters % 4 {
        0 => (x, y),
        1 => (-y, x),
        2 => (-x, -y),
        _ => (y, -x),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quarters_are_exact_and_mirrors_equal() {
        for n in [4, 8, 12, 100, 1024] {
            assert_eq!([0, 1, 2, 3].map(|q| turn(q * n / 4, n)), [(1.0, 0.0), (-0.0, 1.0), (-1.0, -0.0), (0.0, -1.0)]);
            for i in 1..n {
                let ((x, y), (mirror_x, mirror_y)) = (turn(i, n), turn(n - i, n));
                assert_eq!((x, y), (mirror_x, -mirror_y));
                assert!((x - (f64::from(i) / f64::from(n) * 2.0 * PI).cos()).abs() < 1e-15);
                assert!((x * x + y * y - 1.0).abs() < 4e-16);
            }
        }
    }
}
