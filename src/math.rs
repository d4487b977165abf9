//! Vocabulary: vectors, matrices and the few functions whose bits a picture depends on.
//!
//! Stands at the left end of the flow: every other room may use it, it uses none.
//!
//! Why own `sin`, `cos` and `pow`: the ones of the standard library differ in the last bit between
//! platforms, and a last bit can move a vertex or a color level. The `libm` crate is the same code everywhere.
//! Square roots and the four operations are exact to the last bit by IEEE 754 and need no care.

/// A point, a direction or a normal; three `f64`.
pub type Vec3 = glam::DVec3;
/// A point in a plane; two `f64`.
pub type Vec2 = glam::DVec2;
/// A linear map in a plane, column vectors.
pub type Mat2 = glam::DMat2;
/// A linear map of directions, column vectors: `target_from_source * source`.
pub type Mat3 = glam::DMat3;
/// An affine map of points (a 3 x 3 matrix and a translation), column vectors: `target_from_source`.
pub type Affine3 = glam::DAffine3;
/// A projective map of homogeneous points, column vectors: `target_from_source`.
pub type Mat4 = glam::DMat4;

pub use libm::{acos, asin, atan, cos, exp, fabs, log, pow, sin, tan};

/// Half a turn, in radians.
pub const PI: f64 = std::f64::consts::PI;

/// Turns degrees into radians.
#[must_use]
pub fn radians(degrees: f64) -> f64 {
    degrees * (PI / 180.0)
}

/// The edges of a closed outline: every neighboring pair, and last the pair from the end back to the start.
///
/// An empty outline has no edges; an outline of one point has one edge, from the point to itself.
///
/// ```
/// let edges: Vec<_> = farop::math::edges(&["a", "b", "c"]).collect();
/// assert_eq!(edges, [(&"a", &"b"), (&"b", &"c"), (&"c", &"a")]);
/// ```
#[inline]
pub fn edges<T>(outline: &[T]) -> impl Iterator<Item = (&T, &T)> {
    let next = outline.get(1..).unwrap_or_default().iter().chain(outline.first());
    outline.iter().zip(next)
}

/// The unit vector along `v`, or `None` where it has no direction: zero, infinite, or not a number.
///
/// Scales by a power of two first, so that lengths whose square would overflow or vanish (1e200, 1e-200)
/// still have a direction.
///
/// ```
/// use farop::math::{unit, Vec3};
/// assert_eq!(unit(Vec3::new(0.0, 0.0, 1e-300)), Some(Vec3::Z));
/// assert_eq!(unit(Vec3::ZERO), None);
/// ```
#[must_use]
#[inline]
pub fn unit(v: Vec3) -> Option<Vec3> {
    let largest = v.abs().max_element();
    if !(largest > 0.0 && largest.is_finite()) {
        return None;
    }
    let scaled = v * power_of_two_below_reciprocal(largest);
    let length_squared = scaled.length_squared();
    // Not so where one of the numbers is none.
    (length_squared > 0.0).then(|| scaled / length_squared.sqrt())
}

/// The largest power of two that is not above 1 / `x`, without dividing; `x` is positive and finite. Scaling by it rounds nothing.
///
/// Held between the smallest and the largest power of two that are not subnormal.
#[inline]
pub(crate) fn power_of_two_below_reciprocal(x: f64) -> f64 {
    const FRACTION: u64 = (1 << 52) - 1;
    // The biased exponent of the smallest power of two that is not below x; 2^-1023 and less count as 2^-1023.
    let above = if x.to_bits() <= 1 << 51 { 0 } else { (x.to_bits() + FRACTION) >> 52 };
    f64::from_bits((2046 - above.min(2045)) << 52)
}

/// The length of `v`, also where its square would leave the range of `f64`.
///
/// ```
/// use farop::math::{length, Vec3};
/// assert!((length(Vec3::new(3e200, 0.0, 4e200)) / 5e200 - 1.0).abs() < 1e-15);
/// ```
#[must_use]
pub fn length(v: Vec3) -> f64 {
    let scale = ordinary_scale(v.abs().max_element());
    (v * scale).length() / scale
}

/// A power of two that brings numbers of which `largest` is the largest magnitude near 1, where products of four of them
/// and of their differences might leave the range of `f64`; 1 for all others. Multiplying by it rounds nothing.
///
/// ```
/// use farop::math::ordinary_scale;
/// assert_eq!(ordinary_scale(1e30), 1.0);
/// assert_eq!(1e-200 * ordinary_scale(1e-200), 1e-200 * 664f64.exp2());
/// ```
#[must_use]
#[inline]
pub fn ordinary_scale(largest: f64) -> f64 {
    // A difference of two numbers near 2^-100 is at least 2^-152 or 0, a cross product of such at least 2^-357 or 0, and
    // even its square is far above 2^-1022.
    const LEAST: f64 = f64::from_bits((1023 - 100) << 52);
    if (LEAST..=1.0 / LEAST).contains(&largest) || largest == 0.0 || !largest.is_finite() {
        return 1.0;
    }
    power_of_two_below_reciprocal(largest)
}

/// The exponent of the largest power of two that is not above a positive finite `x`.
///
/// ```
/// assert_eq!([0.75, 1.0, 5e-324].map(farop::math::exponent), [-1, 0, -1074]);
/// ```
#[must_use]
pub fn exponent(x: f64) -> i64 {
    let (biased, fraction) = ((x.to_bits() >> 52) as i64 & 0x7FF, x.to_bits() & ((1 << 52) - 1));
    if biased == 0 { 63 - i64::from(fraction.leading_zeros()) - 1074 } else { biased - 1023 }
}

/// The largest magnitude of any coordinate; NaN where one is not a number.
#[must_use]
#[inline(always)]
pub fn largest_coordinate(points: &[Vec3]) -> f64 {
    // Without its sign a number has the same order as its bits, and NaN comes last. Three at a time do not wait for each other.
    let magnitude = |x: f64| x.to_bits() & (u64::MAX >> 1);
    let [mut x, mut y, mut z] = [0; 3];
    for point in points {
        (x, y, z) = (x.max(magnitude(point.x)), y.max(magnitude(point.y)), z.max(magnitude(point.z)));
    }
    f64::from_bits(x.max(y).max(z))
}

/// The Newell normal of an outline: not unit, its length is twice the enclosed area.
///
/// Counterclockwise outlines, seen from the tip of the normal, give a positive area. Unlike the cross product
/// of the first two edges it stays right when the first three vertices are collinear or the corner is reflex.
/// Differences are taken from the first vertex, so that a small polygon far from the origin loses no digits.
/// Where coordinates are so large or small that the area may leave the range of `f64` ([`ordinary_scale`]), it is the
/// normal of the outline scaled by that power of two: the direction is the same.
/// Source: Sutherland, Sproull and Schumacker, "A Characterization of Ten Hidden-Surface Algorithms",
/// ACM Computing Surveys 6(1), 1974, who credit M. Newell.
#[must_use]
#[inline(always)]
pub fn newell_normal(outline: &[Vec3]) -> Vec3 {
    let [origin, rest @ ..] = outline else { return Vec3::ZERO };
    let scale = ordinary_scale(largest_coordinate(outline));
    // The edges at the first vertex have no share: one of their ends is the origin.
    let pairs = rest.iter().zip(rest.get(1..).unwrap_or_default());
    if scale == 1.0 {
        return pairs.map(|(&a, &b)| (a - origin).cross(b - origin)).sum();
    }
    let from_origin = |p: Vec3| p * scale - *origin * scale;
    pairs.map(|(&a, &b)| from_origin(a).cross(from_origin(b))).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unit_holds_at_the_extremes() {
        for scale in [5e-324, 1e-308, 1e-170, 1.0, 1e170, 1e308] {
            let direction = unit(Vec3::new(scale, -scale, 0.0)).expect("has a direction");
            assert!((direction.length() - 1.0).abs() < 1e-15, "{scale}: {direction}");
            assert!((direction.x + direction.y).abs() < 1e-16);
        }
        assert_eq!(unit(Vec3::new(f64::INFINITY, 0.0, 0.0)), None);
        assert_eq!(unit(Vec3::new(f64::NAN, 1.0, 0.0)), None);
    }

    #[test]
    fn powers_of_two_are_found_without_dividing() {
        let by_division = |x: f64| match 1.0 / x {
            reciprocal if reciprocal.is_infinite() => f64::from_bits(0x7FE0_0000_0000_0000),
            reciprocal if reciprocal < f64::MIN_POSITIVE => f64::MIN_POSITIVE,
            reciprocal => f64::from_bits(reciprocal.to_bits() & 0x7FF0_0000_0000_0000),
        };
        for exponent in 0..2047_u64 {
            for fraction in [0, 1, 2, 1 << 51, (1 << 52) - 2, (1 << 52) - 1] {
                let x = f64::from_bits(exponent << 52 | fraction);
                assert!(x == 0.0 || power_of_two_below_reciprocal(x) == by_division(x), "{x:e}");
            }
        }
    }

    #[test]
    fn the_largest_coordinate_is_found_wherever_it_stands() {
        for place in 0..9 {
            for largest in [-7.0, f64::NEG_INFINITY, f64::NAN, 5e-324] {
                let mut numbers =
                    if largest.abs() < 1.0 { [0.0; 9] } else { [-0.0, 1.0, -2.0, 3.0, 0.5, -6.0, 2.0, 0.0, 1e-9] };
                numbers[place] = largest;
                let points: Vec<Vec3> = numbers.chunks(3).map(Vec3::from_slice).collect();
                assert_eq!(largest_coordinate(&points).to_bits(), largest.abs().to_bits(), "{largest} at {place}");
            }
        }
    }

    #[test]
    fn newell_normal_survives_collinear_first_vertices() {
        let square = [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)].map(|(x, y)| Vec3::new(x, y, 7.0));
        assert_eq!(newell_normal(&square), Vec3::new(0.0, 0.0, 8.0));
    }
}
