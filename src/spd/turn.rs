//! Turns: right-handed rotations about an axis, as matrices for column vectors.
//!
//! The scenes place copies of themselves with these; tessellation sweeps a radius around a cone with them.
//!
//! Why written out, term by term: the published files hold noise around zero (`-2.22045e-16`), and only the same
//! operations in the same order give the same noise, hence the same text.
//!
//! Angles in radians. Source: O. Rodrigues' rotation formula, 1840.

use super::rounded::sin_cos;
use crate::math::{Mat3, Vec3};

/// The turn by `angle` about the unit vector `axis`; counterclockwise, seen from the tip of the axis.
pub(super) fn rotation(axis: Vec3, angle: f64) -> Mat3 {
    let (sine, cosine) = sin_cos(angle);
    let Vec3 { x, y, z } = axis;
    let rest = 1.0 - cosine;
    Mat3::from_cols(
        Vec3::new(x * x + (1.0 - x * x) * cosine, x * y * rest + z * sine, x * z * rest - y * sine),
        Vec3::new(x * y * rest - z * sine, y * y + (1.0 - y * y) * cosine, y * z * rest + x * sine),
        Vec3::new(x * z * rest + y * sine, y * z * rest - x * sine, z * z + (1.0 - z * z) * cosine),
    )
}

/// The turn about the x axis: y towards z.
pub(super) fn rotation_x(angle: f64) -> Mat3 {
    let (sine, cosine) = sin_cos(angle);
    Mat3::from_cols(Vec3::X, Vec3::new(0.0, cosine, sine), Vec3::new(0.0, -sine, cosine))
}

/// The turn about the y axis: z towards x.
pub(super) fn rotation_y(angle: f64) -> Mat3 {
    let (sine, cosine) = sin_cos(angle);
    Mat3::from_cols(Vec3::new(cosine, 0.0, -sine), Vec3::Y, Vec3::new(sine, 0.0, cosine))
}

/// The turn about the z axis: x towards y.
pub(super) fn rotation_z(angle: f64) -> Mat3 {
    let (sine, cosine) = sin_cos(angle);
    Mat3::from_cols(Vec3::new(cosine, sine, 0.0), Vec3::new(-sine, cosine, 0.0), Vec3::Z)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_about_the_axes_are_special_cases() {
        for angle in [-2.5, 0.0, 0.3, 1.9] {
            for (axis, special) in
                [(Vec3::X, rotation_x(angle)), (Vec3::Y, rotation_y(angle)), (Vec3::Z, rotation_z(angle))]
            {
                assert!(rotation(axis, angle).abs_diff_eq(special, 1e-15), "{axis} {angle}");
            }
        }
    }

    #[test]
    fn a_third_of_a_turn_about_the_diagonal_permutes_the_axes() {
        let turn = rotation(Vec3::ONE / Vec3::ONE.length(), crate::math::radians(120.0));
        assert!((turn * Vec3::X).abs_diff_eq(Vec3::Y, 1e-15));
        assert!((turn * Vec3::Y).abs_diff_eq(Vec3::Z, 1e-15));
    }
}
