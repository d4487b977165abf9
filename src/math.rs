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
/// A linear map of directions, column vectors: `target_from_source * source`.
pub type Mat3 = glam::DMat3;
/// An affine map of points (a 3 x 3 matrix and a translation), column vectors: `target_from_source`.
pub type Affine3 = glam::DAffine3;

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
pub fn edges<T>(outline: &[T]) -> impl Iterator<Item = (&T, &T)> {
    outline.iter().zip(outline.iter().cycle().skip(1)).take(outline.len())
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
pub fn unit(v: Vec3) -> Option<Vec3> {
    let largest = v.abs().max_element();
    if !(largest > 0.0 && largest.is_finite()) || v.is_nan() {
        return None;
    }
    let scaled = v * power_of_two_below(1.0 / largest);
    let length_squared = scaled.length_squared();
    (length_squared > 0.0).then(|| scaled / length_squared.sqrt())
}

/// The largest power of two that is not above `x`; `x` is positive. Scaling by it rounds nothing.
fn power_of_two_below(x: f64) -> f64 {
    // 1 / subnormal is infinite: the largest power of two there is will do.
    if x.is_infinite() {
        return f64::from_bits(0x7FE0_0000_0000_0000);
    }
    let bits = x.to_bits() & 0x7FF0_0000_0000_0000;
    if bits == 0 { f64::MIN_POSITIVE } else { f64::from_bits(bits) }
}

/// The Newell normal of an outline: not unit, its length is twice the enclosed area.
///
/// Counterclockwise outlines, seen from the tip of the normal, give a positive area. Unlike the cross product
/// of the first two edges it stays right when the first three vertices are collinear or the corner is reflex.
/// Differences are taken from the first vertex, so that a small polygon far from the origin loses no digits.
/// Source: Sutherland, Sproull and Schumacker, "A Characterization of Ten Hidden-Surface Algorithms",
/// ACM Computing Surveys 6(1), 1974, who credit M. Newell.
#[must_use]
pub fn newell_normal(outline: &[Vec3]) -> Vec3 {
    let Some(&origin) = outline.first() else { return Vec3::ZERO };
    edges(outline).map(|(&a, &b)| (a - origin).cross(b - origin)).sum()
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
    fn newell_normal_survives_collinear_first_vertices() {
        let square = [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)].map(|(x, y)| Vec3::new(x, y, 7.0));
        assert_eq!(newell_normal(&square), Vec3::new(0.0, 0.0, 8.0));
    }
}
