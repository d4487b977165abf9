//! Fit: the plane nearest to the values at a polygon's corners.
//!
//! A classic file has no planes, only rounded numbers at corners. The plane of least squared distance goes through all
//! three corners of a triangle; for more corners it averages what rounding did to each, and three corners that happen to
//! lie in a line do not spoil it. Space: samples.

use crate::screen::{Plane, Precision};

/// The plane nearest to the values (x, y, value), clamped to their range; where the corners lie in a line, their mean.
///
/// Never empty.
pub(super) fn fit(corners: impl Iterator<Item = [f64; 3]> + Clone, precision: Precision) -> Plane {
    let (low, high) = corners
        .clone()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), [_, _, value]| (low.min(value), high.max(value)));
    if low == high {
        return Plane::constant(low, precision);
    }
    // Differences from the mean: the plane goes through it, two unknowns are left.
    let count = corners.clone().count() as f64;
    let mean = corners.clone().fold([0.0; 3], add).map(|sum| sum / count);
    let (mut xx, mut xy, mut yy, mut xv, mut yv) = (0.0, 0.0, 0.0, 0.0, 0.0);
    for corner in corners {
        let [x, y, value] = add(corner, mean.map(|m| -m));
        (xx, xy, yy) = (xx + x * x, xy + x * y, yy + y * y);
        (xv, yv) = (xv + x * value, yv + y * value);
    }
    let determinant = xx * yy - xy * xy;
    // Below this the determinant is what rounding left of zero.
    if determinant <= 1e-12 * xx * yy {
        return Plane::constant(mean[2], precision);
    }
    let (a, b) = ((xv * yy - yv * xy) / determinant, (yv * xx - xv * xy) / determinant);
    let c = mean[2] - a * mean[0] - b * mean[1];
    Plane::new([a, b, c], (low, high), (low, high), precision)
}

fn add([x, y, value]: [f64; 3], other: [f64; 3]) -> [f64; 3] {
    [x + other[0], y + other[1], value + other[2]]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(plane: &Plane, x: f64, y: f64) -> f64 {
        plane.a * x + plane.b * y + plane.c
    }

    #[test]
    fn a_triangle_is_met_at_its_corners() {
        let corners = [[1.5, 1.5, 7.0], [5.5, 2.5, -3.0], [2.5, 9.5, 100.0]];
        let plane = fit(corners.into_iter(), Precision::Double);
        for [x, y, expected] in corners {
            assert!((value(&plane, x, y) - expected).abs() < 1e-12);
        }
        assert_eq!((plane.low, plane.high), (-3.0, 100.0));
    }

    #[test]
    fn collinear_first_corners_do_no_harm() {
        let corners = [[0.5, 0.5, 0.0], [2.5, 0.5, 2.0], [4.5, 0.5, 4.0], [4.5, 4.5, 8.0]];
        let plane = fit(corners.into_iter(), Precision::Double);
        assert!((value(&plane, 1.5, 2.5) - 3.0).abs() < 1e-12);
    }

    #[test]
    fn corners_in_a_line_have_a_mean() {
        let plane = fit([[0.5, 0.5, 1.0], [1.5, 1.5, 2.0], [2.5, 2.5, 6.0]].into_iter(), Precision::Double);
        assert_eq!(plane, Plane::constant(3.0, Precision::Double));
    }
}
