//! Predicates: which way do three points turn? The answer is exact for every finite `f64`.
//!
//! SPLIT asks it of every corner and every ear; coverage without a grid asks the same of edges and sample centers. One wrong sign among a million makes two triangles overlap,
//! so "nearly right" is not enough; with exact signs the algorithms above need no epsilon at all.
//!
//! Why two steps: the plain formula in `f64`, with a bound on its own error, decides nearly every case. What it
//! cannot decide is computed again with integers as long as `f64` is wide: a finite `f64` *is* an integer times
//! 2^-1074, so the six products of the determinant are integers times 2^-2148 and add up without rounding.
//! Nothing overflows or vanishes, be the coordinates subnormal, 1e300, or both in one triangle.
//!
//! Space: any plane, x right, y up; no unit.
//! Sources: J. R. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates",
//! Discrete & Computational Geometry 18, 1997 (the error bound); U. Kulisch, "Grundlagen des numerischen
//! Rechnens", 1976 (the long accumulator).
//! Cost: 2 products and 7 sums; in the rare second step, 6 long products and two numbers of 66 words.

use crate::math::{Vec2, Vec3};
use std::cmp::Ordering;

/// How three points turn, with x to the right and y up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Orientation {
    /// The third point lies to the right of the line from the first to the second.
    Clockwise,
    /// The three points lie on one line, or some of them coincide.
    Collinear,
    /// The third point lies to the left of the line from the first to the second.
    Counterclockwise,
}

/// How `a`, `b`, `c` turn: the sign of `(a - c) x (b - c)`, twice the area they enclose, as if computed without rounding.
///
/// Exact for every finite coordinate. Points that are not finite give an arbitrary answer, never a panic.
///
/// ```
/// use farop::geometry::predicates::{Orientation, orientation};
/// use farop::math::Vec2;
/// // The last bit of one coordinate decides; in plain f64 the determinant is 0.
/// let [a, b, c] = [Vec2::new(0.5, 0.5_f64.next_up()), Vec2::new(12.0, 12.0), Vec2::new(24.0, 24.0)];
/// assert_eq!((a - c).perp_dot(b - c), 0.0);
/// assert_eq!(orientation(a, b, c), Orientation::Counterclockwise);
/// assert_eq!(orientation(b, a, c), Orientation::Clockwise);
/// ```
#[must_use]
pub fn orientation(a: Vec2, b: Vec2, c: Vec2) -> Orientation {
    let left = (a.x - c.x) * (b.y - c.y);
    let right = (a.y - c.y) * (b.x - c.x);
    let determinant = left - right;

    // An overflow makes the bound infinite or NaN, and the comparison false: the exact step then decides.
    if determinant.abs() > ERROR_PER_MAGNITUDE * (left.abs() + right.abs()) + UNDERFLOW {
        return if determinant > 0.0 { Orientation::Counterclockwise } else { Orientation::Clockwise };
    }
    exact_orientation(a, b, c)
}

/// Shewchuk's `ccwerrboundA`: (3 + 16 u) u with u = 2^-53. Four differences, two products and one subtraction
/// each err by at most u relative; the rest covers the rounding of the bound itself.
const ERROR_PER_MAGNITUDE: f64 = (3.0 + 16.0 * UNIT_ROUNDOFF) * UNIT_ROUNDOFF;
/// Half a unit in the last place of 1.
const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;
/// What the relative bound misses: a product that becomes subnormal errs by up to 2^-1075. Two of them stay far below 2^-1022.
const UNDERFLOW: f64 = f64::MIN_POSITIVE;

/// The rare path. Most callers here have points on one horizontal or vertical line, or coinciding points:
/// those are settled by the signs of the differences, which `f64` always gets right.
#[cold]
fn exact_orientation(a: Vec2, b: Vec2, c: Vec2) -> Orientation {
    let left = sign_of_difference(a.x, c.x) * sign_of_difference(b.y, c.y);
    let right = sign_of_difference(a.y, c.y) * sign_of_difference(b.x, c.x);
    let order = if left == right && left != 0 { compare_exactly(a, b, c) } else { left.cmp(&right) };
    match order {
        Ordering::Less => Orientation::Clockwise,
        Ordering::Equal => Orientation::Collinear,
        Ordering::Greater => Orientation::Counterclockwise,
    }
}

fn sign_of_difference(a: f64, b: f64) -> i32 {
    i32::from(a > b) - i32::from(a < b)
}

/// Compares the determinant with zero: its positive products against its negative ones.
///
/// Multiplied out, `(a - c) x (b - c)` is `a x b + b x c + c x a`: no difference is left that could round.
fn compare_exactly(a: Vec2, b: Vec2, c: Vec2) -> Ordering {
    let mut positive = LongSum::ZERO;
    let mut negative = LongSum::ZERO;
    for (p, q) in [(a, b), (b, c), (c, a)] {
        for (s, t, opposite) in [(p.x, q.y, false), (p.y, q.x, true)] {
            let is_negative = s.is_sign_negative() ^ t.is_sign_negative() ^ opposite;
            if is_negative { negative.add_product(s, t, 1) } else { positive.add_product(s, t, 1) }
        }
    }
    positive.cmp(&negative)
}

/// On which side of the line through two homogeneous points a third one lies: the sign of the determinant of `a`, `b` and the
/// whole numbers `c`, as if computed without rounding.
///
/// Exact for every finite coordinate and `c` below 2^24; no filter, so for callers that have one.
#[must_use]
pub fn edge_side(a: Vec3, b: Vec3, c: [i32; 3]) -> Ordering {
    let mut positive = LongSum::ZERO;
    let mut negative = LongSum::ZERO;
    let minors = [(a.y, b.z, b.y, a.z), (a.z, b.x, b.z, a.x), (a.x, b.y, b.x, a.y)];
    for ((p, q, r, s), factor) in minors.into_iter().zip(c) {
        for (x, y, opposite) in [(p, q, false), (r, s, true)] {
            let is_negative = x.is_sign_negative() ^ y.is_sign_negative() ^ opposite ^ (factor < 0);
            let sum = if is_negative { &mut negative } else { &mut positive };
            sum.add_product(x, y, factor.unsigned_abs());
        }
    }
    positive.cmp(&negative)
}

/// A sum of products of `f64` magnitudes, held as one integer in units of 2^-2148, lowest word first.
///
/// The largest product, `f64::MAX` squared times 2^24, ends at bit 4220; a few of them stay below bit 4224 = 66 * 64.
#[derive(PartialEq, Eq)]
struct LongSum([u64; 66]);

impl LongSum {
    const ZERO: LongSum = LongSum([0; 66]);

    /// Adds |s| * |t| * `factor`; the factor is below 2^24.
    fn add_product(&mut self, s: f64, t: f64, factor: u32) {
        let (s, s_shift) = integer_and_shift(s);
        let (t, t_shift) = integer_and_shift(t);

        // An integer of 77 bits in two halves of 53 and 24, each times one of 53 bits; then moved within a word, into three words.
        let s = u128::from(s) * u128::from(factor);
        let (below, above) = ((s & ((1 << 53) - 1)) * u128::from(t), (s >> 53) * u128::from(t));
        let (word, bits) = ((s_shift + t_shift) / 64, (s_shift + t_shift) % 64);
        self.add_moved(below, word, bits);
        let (word, bits) = ((s_shift + t_shift + 53) / 64, (s_shift + t_shift + 53) % 64);
        self.add_moved(above, word, bits);
    }

    /// Adds an integer of up to 106 bits, moved up by `word` words and `bits` bits.
    fn add_moved(&mut self, product: u128, word: usize, bits: usize) {
        let low = product << bits;
        let high = if bits == 0 { 0 } else { (product >> (128 - bits)) as u64 };

        let parts = [low as u64, (low >> 64) as u64, high];
        let mut carry = 0;
        for (i, place) in self.0[word..].iter_mut().enumerate() {
            if i >= parts.len() && carry == 0 {
                break;
            }
            let sum = u128::from(*place) + u128::from(parts.get(i).copied().unwrap_or(0)) + carry;
            *place = sum as u64;
            carry = sum >> 64;
        }
    }
}

impl Ord for LongSum {
    fn cmp(&self, other: &LongSum) -> Ordering {
        self.0.iter().rev().cmp(other.0.iter().rev())
    }
}

impl PartialOrd for LongSum {
    fn partial_cmp(&self, other: &LongSum) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// The magnitude of `x` as `integer * 2^(shift - 1074)`.
fn integer_and_shift(x: f64) -> (u64, usize) {
    let fraction = x.to_bits() & ((1 << 52) - 1);
    let exponent = (x.to_bits() >> 52) & 0x7FF;
    if exponent == 0 { (fraction, 0) } else { (fraction | (1 << 52), exponent as usize - 1) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_bigint::BigInt;
    use proptest::prelude::*;
    use proptest::test_runner::RngSeed;

    /// The sign by another way: differences of big integers, as the definition says.
    fn by_big_integers(points: [Vec2; 3]) -> Orientation {
        let [a, b, c] = points.map(|p| [to_integer(p.x), to_integer(p.y)]);
        let left = (&a[0] - &c[0]) * (&b[1] - &c[1]);
        let right = (&a[1] - &c[1]) * (&b[0] - &c[0]);
        match left.cmp(&right) {
            Ordering::Less => Orientation::Clockwise,
            Ordering::Equal => Orientation::Collinear,
            Ordering::Greater => Orientation::Counterclockwise,
        }
    }

    /// `x * 2^1074`.
    fn to_integer(x: f64) -> BigInt {
        let (mut magnitude, mut doublings) = (x.abs(), 1074_usize);
        while magnitude.fract() != 0.0 {
            magnitude *= 2.0;
            doublings -= 1;
        }
        while magnitude >= 9_007_199_254_740_992.0 {
            magnitude /= 2.0;
            doublings += 1;
        }
        let integer = BigInt::from(magnitude as u64) << doublings;
        if x < 0.0 { -integer } else { integer }
    }

    /// Checks all six orders of the points against the big integers; returns how many were collinear.
    fn check(points: [Vec2; 3]) -> usize {
        let [a, b, c] = points;
        let expected = by_big_integers(points);
        let mirrored = by_big_integers([b, a, c]);
        for [p, q, r] in [[a, b, c], [b, c, a], [c, a, b]] {
            assert_eq!(orientation(p, q, r), expected, "{p:?} {q:?} {r:?}");
            assert_eq!(orientation(q, p, r), mirrored, "{q:?} {p:?} {r:?}");
        }
        usize::from(expected == Orientation::Collinear)
    }

    /// A small generator of equally likely bits (Marsaglia's xorshift), so that the cases are the same in every run.
    struct Bits(u64);

    impl Bits {
        fn next(&mut self) -> u64 {
            self.0 ^= self.0 << 13;
            self.0 ^= self.0 >> 7;
            self.0 ^= self.0 << 17;
            self.0
        }
        fn below(&mut self, end: u64) -> u64 {
            (self.next() >> 11) % end
        }
        /// Any finite `f64`, subnormals included.
        fn finite(&mut self) -> f64 {
            loop {
                let x = f64::from_bits(self.next());
                if x.is_finite() {
                    return x;
                }
            }
        }
        /// From a handful of exponents that meet each other: subnormal, 1e-300, 1e-155, 1, 1e155, 1e300, the largest.
        fn extreme(&mut self) -> f64 {
            let scales = [5e-324, 1e-310, 1e-300, 1e-170, 1e-155, 1.0, 1e155, 1e170, 1e300, f64::MAX / 16.0];
            let scale = scales[self.below(10) as usize];
            let factors = [0.0, -0.0, 1.0, -1.0, 3.0, -5.0, 16.0, 1.0 + f64::EPSILON];
            scale * factors[self.below(8) as usize]
        }
        /// A point within `steps` last places of the segment from `a` to `b`.
        fn beside(&mut self, a: Vec2, b: Vec2, steps: u64) -> Vec2 {
            let t = self.below(1025) as f64 / 1024.0;
            let p = a + (b - a) * t;
            let mut nudge =
                |x: f64| f64::from_bits(x.to_bits().wrapping_add(self.below(2 * steps + 1)).wrapping_sub(steps));
            let p = Vec2::new(nudge(p.x), nudge(p.y));
            if p.is_finite() { p } else { a }
        }
    }

    #[test]
    fn sign_is_that_of_big_integers() {
        let mut bits = Bits(0x5EED);
        let mut collinear = 0;
        for _ in 0..20_000 {
            // Anything at all, meeting extremes, and extremes next to ordinary numbers.
            let mut point = |f: fn(&mut Bits) -> f64| Vec2::new(f(&mut bits), f(&mut bits));
            collinear += check([point(Bits::finite), point(Bits::finite), point(Bits::finite)]);
            collinear += check([point(Bits::extreme), point(Bits::extreme), point(Bits::extreme)]);
            collinear += check([point(Bits::extreme), point(Bits::finite), point(Bits::extreme)]);

            // Nearly collinear at every scale.
            let scale = [1.0, 1e-300, 1e300, 1e-155, 1e155, 1e-320][bits.below(6) as usize];
            let mut unit = || Vec2::new(bits.below(1 << 50) as f64, bits.below(1 << 50) as f64) * (scale / 1e15);
            let (a, b) = (unit(), unit());
            let c = bits.beside(a, b, 2);
            collinear += check([a, b, c]);

            // Exactly collinear integers, and one off.
            let mut whole = |end| Vec2::new(bits.below(end) as f64, bits.below(end) as f64);
            let (origin, step) = (whole(1 << 40), whole(1 << 20));
            let (near, far) = (origin + step * 12_345.0, origin + step * 98_765.0);
            collinear += check([origin, near, far]);
            collinear += check([origin, near, far + Vec2::X]);
        }
        assert!(collinear > 20_000, "{collinear}");
    }

    #[test]
    fn largest_numbers_fit_in_the_long_sum() {
        let m = f64::MAX;
        check([Vec2::new(m, m), Vec2::new(-m, m), Vec2::new(-m, -m)]);
        check([Vec2::new(m, m), Vec2::new(-m, -m), Vec2::new(m, m.next_down())]);
        check([Vec2::new(m, -m), Vec2::new(5e-324, m), Vec2::new(-m, -5e-324)]);
    }

    #[test]
    fn not_finite_does_not_panic() {
        for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let _ = orientation(Vec2::new(x, x), Vec2::new(x, 1.0), Vec2::new(f64::MAX, x));
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig { rng_seed: RngSeed::Fixed(1997), ..ProptestConfig::default() })]
        #[test]
        fn any_three_points(p in prop::array::uniform6(prop::num::f64::NORMAL | prop::num::f64::SUBNORMAL | prop::num::f64::ZERO)) {
            check([Vec2::new(p[0], p[1]), Vec2::new(p[2], p[3]), Vec2::new(p[4], p[5])]);
        }
    }
}
