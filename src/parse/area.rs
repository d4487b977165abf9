//! Does a polygon have any area at all? Decided exactly, not by a tolerance.
//!
//! Why exact: a tolerance drops polygons of a scene that is merely small. All vertices on one line is a yes-or-no
//! property of the given numbers, so it is computed as one: floating point first, with a bound for its error, and
//! where that cannot tell, sums of `f64` that lose nothing.
//!
//! Source: J. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates",
//! Discrete & Computational Geometry 18, 1997; T. Dekker, Numerische Mathematik 18, 1971 (exact products).
//! Cost: one cross product for a polygon that has area; about 300 additions a vertex for one that has none.

use crate::math::{Vec3, newell_normal, unit};

/// Whether all vertices are on one line (or at one point): the polygon has no area.
///
/// Exact where the extents of the polygon are not below 2^-500 of its largest coordinate; smaller ones count as none.
#[must_use]
pub fn is_collinear(outline: &[Vec3]) -> bool {
    let Some((&a, others)) = outline.split_first() else { return true };
    let Some(&b) = others.iter().find(|&&b| b != a) else { return true };
    others.iter().all(|&c| c == a || c == b || !surely_turns(a, b, c) && is_straight(a, b, c))
}

/// Twice the area of the triangle a, b, c in the plane, as a sign: above 0 where it turns left, 0 exactly where it is straight.
#[must_use]
pub fn turn_in_plane(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    let left = (b[0] - a[0]) * (c[1] - a[1]);
    let right = (b[1] - a[1]) * (c[0] - a[0]);
    let magnitude = left.abs() + right.abs();
    if (left - right).abs() > 4.0 * f64::EPSILON * magnitude && magnitude > 1e-280 && magnitude.is_finite() {
        return left - right;
    }
    let largest = [a, b, c].iter().flatten().fold(0.0, |largest: f64, x| largest.max(x.abs()));
    if largest == 0.0 {
        return 0.0;
    }
    let [a, b, c] = [a, b, c].map(|[x, y]| scale_below_two(Vec3::new(x, y, 0.0), largest));
    let mut sum = ExactSum::default();
    sum.add_product(difference(b.x, a.x), difference(c.y, a.y), 1.0);
    sum.add_product(difference(b.y, a.y), difference(c.x, a.x), -1.0);
    sum.largest_part()
}

/// How far corners lie outside the polygon's plane, as a part of the polygon's size; 0 where it has no plane.
///
/// The plane is the one of the Newell normal through the mean of the corners.
#[must_use]
pub fn out_of_plane(outline: &[Vec3]) -> f64 {
    let middle = outline.iter().sum::<Vec3>() / outline.len() as f64;
    let Some(normal) = unit(newell_normal(outline)).filter(|_| middle.is_finite()) else { return 0.0 };
    let reach =
        |measure: &dyn Fn(Vec3) -> f64| outline.iter().map(|&corner| measure(corner - middle)).fold(0.0, f64::max);
    let size = 2.0 * reach(&|offset| offset.length());
    if size > 0.0 { reach(&|offset| normal.dot(offset).abs()) / size } else { 0.0 }
}

/// `normal` with length 1, zero where it has no direction.
///
/// A few roundings away from 1 is as near as it gets: left alone, so that a written file reads back the same.
#[must_use]
pub fn unit_normal(normal: Vec3) -> Vec3 {
    if (normal.length_squared() - 1.0).abs() <= 4.0 * f64::EPSILON {
        return normal;
    }
    unit(normal).unwrap_or(Vec3::ZERO)
}

/// Floating point is certain that a, b, c are not on one line.
fn surely_turns(a: Vec3, b: Vec3, c: Vec3) -> bool {
    let (u, v) = (b - a, c - a);
    let certain = |left: f64, right: f64| {
        let magnitude = left.abs() + right.abs();
        // Three roundings of 2^-53 each, and room; below the second bound they are no longer relative.
        (left - right).abs() > 4.0 * f64::EPSILON * magnitude && magnitude > 1e-280 && magnitude.is_finite()
    };
    certain(u.x * v.y, u.y * v.x) || certain(u.y * v.z, u.z * v.y) || certain(u.z * v.x, u.x * v.z)
}

/// Exactly: (b - a) x (c - a) is zero.
fn is_straight(a: Vec3, b: Vec3, c: Vec3) -> bool {
    let largest = [a, b, c].iter().map(|point| point.abs().max_element()).fold(0.0, f64::max);
    let [a, b, c] = [a, b, c].map(|point| scale_below_two(point, largest));
    let parallel = |i: usize, j: usize| {
        let (u_i, v_j) = (difference(b[i], a[i]), difference(c[j], a[j]));
        let (u_j, v_i) = (difference(b[j], a[j]), difference(c[i], a[i]));
        let mut sum = ExactSum::default();
        sum.add_product(u_i, v_j, 1.0);
        sum.add_product(u_j, v_i, -1.0);
        sum.is_zero()
    };
    parallel(0, 1) && parallel(1, 2) && parallel(2, 0)
}

/// Multiplies by the power of two that brings `largest` into 1..2: products then neither overflow nor vanish.
fn scale_below_two(point: Vec3, largest: f64) -> Vec3 {
    let exponent = libm::ilogb(largest);
    // In two steps: 2^1074 itself is not an `f64`.
    let (half, rest) = (-exponent / 2, -exponent - -exponent / 2);
    point * libm::scalbn(1.0, half) * libm::scalbn(1.0, rest)
}

/// x - y as a rounded value and its exact error.
fn difference(x: f64, y: f64) -> [f64; 2] {
    sum_of_two(x, -y)
}

/// x + y as a rounded value and its exact error (Knuth).
fn sum_of_two(x: f64, y: f64) -> [f64; 2] {
    let sum = x + y;
    let y_part = sum - x;
    let x_part = sum - y_part;
    [sum, (x - x_part) + (y - y_part)]
}

/// x * y as a rounded value and its exact error (Dekker): each factor is cut into halves of 26 bits.
fn product(x: f64, y: f64) -> [f64; 2] {
    let halves = |value: f64| {
        let shifted = value * 134_217_729.0; // 2^27 + 1
        let high = shifted - (shifted - value);
        [high, value - high]
    };
    let ([x_high, x_low], [y_high, y_low]) = (halves(x), halves(y));
    let rounded = x * y;
    let error = ((x_high * y_high - rounded) + x_high * y_low + x_low * y_high) + x_low * y_low;
    [rounded, error]
}

/// A sum that loses nothing: parts that do not overlap, smallest first (Shewchuk's expansion).
#[derive(Default)]
struct ExactSum {
    parts: [f64; 16],
    count: usize,
}

impl ExactSum {
    fn add(&mut self, value: f64) {
        let mut carry = value;
        let mut kept = 0;
        for index in 0..self.count {
            let [sum, error] = sum_of_two(carry, self.parts[index]);
            carry = sum;
            if error != 0.0 {
                self.parts[kept] = error;
                kept += 1;
            }
        }
        self.count = kept;
        if carry != 0.0 {
            self.parts[kept] = carry;
            self.count += 1;
        }
    }

    /// Adds `sign * u * v`, both given as a rounded value and its error.
    fn add_product(&mut self, u: [f64; 2], v: [f64; 2], sign: f64) {
        for (s, t) in [(u[0], v[0]), (u[0], v[1]), (u[1], v[0]), (u[1], v[1])] {
            product(s, t).iter().for_each(|part| self.add(sign * part));
        }
    }

    fn is_zero(&self) -> bool {
        self.count == 0
    }

    /// The part that decides the sign; 0 where there is none.
    fn largest_part(&self) -> f64 {
        if self.count == 0 { 0.0 } else { self.parts[self.count - 1] }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points<const N: usize>(points: [[f64; 3]; N]) -> [Vec3; N] {
        points.map(Vec3::from_array)
    }

    #[test]
    fn lines_and_points_have_no_area() {
        assert!(is_collinear(&points([[1.0, 2.0, 3.0]; 3])));
        assert!(is_collinear(&points([[0.1, 0.2, 0.3], [0.2, 0.4, 0.6], [0.4, 0.8, 1.2], [0.1, 0.2, 0.3]])));
        assert!(is_collinear(&points([[1e300, 0.0, 0.0], [-1e300, 0.0, 0.0], [1.0, 0.0, 0.0]])));
        assert!(is_collinear(&points([[5e-324, 0.0, 0.0], [1e-323, 0.0, 0.0], [0.0; 3]])));
        // Far from the origin and far apart: the differences themselves are not exact.
        assert!(is_collinear(&points([[1.0, 1.0, 1.0], [1e-20, 1e-20, 1e-20], [1e20, 1e20, 1e20]])));
    }

    #[test]
    fn turns_are_exact() {
        assert!(turn_in_plane([0.0, 0.0], [1.0, 0.0], [0.0, 1.0]) > 0.0);
        assert!(turn_in_plane([0.0, 0.0], [0.0, 1.0], [1.0, 0.0]) < 0.0);
        assert_eq!(turn_in_plane([0.1, 0.1], [0.2, 0.2], [0.3, 0.3]), 0.0);
        assert_eq!(turn_in_plane([0.0; 2], [0.0; 2], [0.0; 2]), 0.0);
        let e = f64::EPSILON;
        assert!(turn_in_plane([0.0, 0.0], [1.0 + e, 1.0], [1.0, 1.0 - e]) < 0.0, "its rounded area is 0");
        assert!(turn_in_plane([0.0, 0.0], [5e-324, 0.0], [0.0, 5e-324]) > 0.0);
    }

    #[test]
    fn the_thinnest_triangles_have_area() {
        let above_one = 1.0 + f64::EPSILON;
        assert!(!is_collinear(&points([[0.0; 3], [1.0, 1.0, 1.0], [3.0, 3.0, 3.0 + 4.0 * f64::EPSILON]])));
        assert!(!is_collinear(&points([[1e-20; 3], [1.0; 3], [above_one, 1.0, 1.0]])));
        assert!(!is_collinear(&points([[0.0; 3], [5e-324, 0.0, 0.0], [0.0, 5e-324, 0.0]])));
        assert!(!is_collinear(&points([[1e308, 0.0, 0.0], [-1e308, 0.0, 0.0], [0.0, 1e308, 0.0]])));
        assert!(!is_collinear(&points([[1e30, 0.0, 0.0], [0.0, 1e-30, 0.0], [0.0, 0.0, 0.0]])));
        // The rounded cross product is 0 here: (1 + e)(1 - e) = 1 - e^2 is not 1 * 1.
        let e = f64::EPSILON;
        assert!(!is_collinear(&points([[0.0; 3], [1.0 + e, 1.0, 0.0], [1.0, 1.0 - e, 0.0]])));
    }
}
