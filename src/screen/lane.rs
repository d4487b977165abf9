//! Lane: a number, or several side by side, that planes and light are computed with.
//!
//! Why: the readable rasterizers ask for one sample, a fast one for eight at a time. Both must do the same operations in the same order,
//! so the order is written once, here and in [`super::shader`], for anything that adds, multiplies, divides and compares like an IEEE 754
//! number in every lane.

use crate::math::power_of_two_below_reciprocal;
use std::ops::{Add, BitAnd, Div, Mul, Sub};

/// A number or a vector of numbers.
pub trait Lane: Copy + Add<Output = Self> + Mul<Output = Self> + Div<Output = Self> {
    /// `low` where the number is below it, `high` where it is not and is above that, else the number; not-a-number stays.
    #[must_use]
    fn hold(self, low: Self, high: Self) -> Self;
}

/// An `f64` or a vector of them: what light is computed with.
///
/// Instead of branches there are masks, one truth a lane: a result is computed in every lane and chosen where it holds.
pub trait Wide: Lane + Sub<Output = Self> {
    /// How many there are.
    const LANES: u32;

    /// One truth a lane.
    type Mask: Copy + BitAnd<Output = Self::Mask>;

    /// `number` in as many lanes as this has.
    #[must_use]
    fn all(self, number: f64) -> Self;
    /// Square roots, rounded once.
    #[must_use]
    fn sqrt(self) -> Self;
    /// Where this is above `other`; nowhere for not-a-number.
    #[must_use]
    fn above(self, other: Self) -> Self::Mask;
    /// `yes` where the mask is true, `no` elsewhere.
    #[must_use]
    fn choose(mask: Self::Mask, yes: Self, no: Self) -> Self;
    /// How many lanes of the mask are true.
    #[must_use]
    fn count(mask: Self::Mask) -> u32;
    /// Of positive normal numbers, the power of two 2^e that is not above it, as e, and the number divided by it, from 1 to before 2.
    #[must_use]
    fn exponent_and_fraction(self) -> (Self, Self);
    /// 2 to the power of whole numbers from -1022 to 1023.
    #[must_use]
    fn power_of_two(self) -> Self;
    /// `change` of every lane, one after the other: for what is rare.
    #[must_use]
    fn each(self, change: impl Fn(f64) -> f64) -> Self;
}

/// 2^52: added to a whole number from 0 up, it puts that into the last bits.
pub(crate) const WHOLE: f64 = 4_503_599_627_370_496.0;
/// What is added to exponents before they are stored.
pub(crate) const BIAS: f64 = 1023.0;
/// The bits of a fraction.
pub(crate) const FRACTION: u64 = (1 << 52) - 1;

macro_rules! number_lane {
    ($number:ty) => {
        impl Lane for $number {
            // Not clamp: that panics on an empty range, which a broken screen file may hold.
            #[inline(always)]
            fn hold(self, low: Self, high: Self) -> Self {
                if self < low {
                    low
                } else if self > high {
                    high
                } else {
                    self
                }
            }
        }
    };
}
number_lane!(f32);
number_lane!(f64);

impl Wide for f64 {
    const LANES: u32 = 1;

    type Mask = bool;

    #[inline(always)]
    fn all(self, number: f64) -> f64 {
        number
    }

    #[inline(always)]
    fn sqrt(self) -> f64 {
        f64::sqrt(self)
    }

    #[inline(always)]
    fn above(self, other: f64) -> bool {
        self > other
    }

    #[inline(always)]
    fn choose(mask: bool, yes: f64, no: f64) -> f64 {
        if mask { yes } else { no }
    }

    #[inline(always)]
    fn count(mask: bool) -> u32 {
        u32::from(mask)
    }

    #[inline(always)]
    fn exponent_and_fraction(self) -> (f64, f64) {
        let bits = self.to_bits();
        let exponent = f64::from_bits((bits >> 52) | WHOLE.to_bits()) - (WHOLE + BIAS);
        (exponent, f64::from_bits((bits & FRACTION) | 1.0_f64.to_bits()))
    }

    #[inline(always)]
    fn power_of_two(self) -> f64 {
        f64::from_bits((self + (WHOLE + BIAS)).to_bits() << 52)
    }

    #[inline(always)]
    fn each(self, change: impl Fn(f64) -> f64) -> f64 {
        change(self)
    }
}

/// The value of a plane inside a block: `anchor` at the block's first sample, `slope` per sample right and down, `at` samples right and
/// down of the first one. No fused multiply-add, nothing accumulated.
#[inline(always)]
#[must_use]
pub fn in_block<T: Lane>(anchor: T, slope: [T; 2], at: [T; 2]) -> T {
    anchor + (slope[0] * at[0] + slope[1] * at[1])
}

/// `yes` where the mask is true, `no` elsewhere.
#[inline(always)]
#[must_use]
pub fn choose<T: Wide>(mask: T::Mask, yes: [T; 3], no: [T; 3]) -> [T; 3] {
    [T::choose(mask, yes[0], no[0]), T::choose(mask, yes[1], no[1]), T::choose(mask, yes[2], no[2])]
}

/// The scalar product of two vectors.
#[inline(always)]
#[must_use]
pub fn dot<T: Lane>(a: [T; 3], b: [T; 3]) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The unit vector along `v`, and where there is one: not for zero, infinite, or not a number, as [`crate::math::unit`] has it.
///
/// Only where the square of the length might leave the range of `f64`, `v` is scaled by a power of two first.
#[inline(always)]
pub fn unit<T: Wide>(v: [T; 3]) -> ([T; 3], T::Mask) {
    /// 2^400.
    const MOST: f64 = f64::from_bits((1023 + 400) << 52);
    let [zero, one] = [v[0].all(0.0), v[0].all(1.0)];
    let (mut v, mut square) = (v, dot(v, v));
    let ordinary = square.above(v[0].all(1.0 / MOST)) & v[0].all(MOST).above(square);
    if T::count(ordinary) < T::LANES {
        let scale = T::choose(ordinary, one, largest(v).each(scale_to_one));
        v = [v[0] * scale, v[1] * scale, v[2] * scale];
        square = dot(v, v);
    }
    let has_direction = square.above(zero) & v[0].all(f64::INFINITY).above(square);
    let shrink = one / square.sqrt();
    ([v[0] * shrink, v[1] * shrink, v[2] * shrink], has_direction)
}

/// The largest magnitude of a coordinate.
#[cold]
#[inline(never)]
fn largest<T: Wide>(v: [T; 3]) -> T {
    let zero = v[0].all(0.0);
    v.into_iter().fold(zero, |largest, along| {
        let magnitude = T::choose(zero.above(along), zero - along, along);
        T::choose(largest.above(magnitude), largest, magnitude)
    })
}

/// A power of two that brings `largest` near 1; 1 where there is none.
fn scale_to_one(largest: f64) -> f64 {
    if largest > 0.0 && largest.is_finite() { power_of_two_below_reciprocal(largest) } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Vec3;

    #[test]
    fn numbers_come_apart_and_together() {
        for (number, exponent, fraction) in [(1.0, 0.0, 1.0), (0.375, -2.0, 1.5), (f64::MIN_POSITIVE, -1022.0, 1.0)] {
            assert_eq!(number.exponent_and_fraction(), (exponent, fraction));
            assert_eq!(exponent.power_of_two() * fraction, number);
        }
        assert_eq!(f64::MAX.exponent_and_fraction().0, 1023.0);
        assert_eq!(1023.0.power_of_two(), 1023.0_f64.exp2());
    }

    #[test]
    fn unit_vectors_are_those_of_the_vocabulary() {
        for scale in [5e-324, 1e-308, 1e-170, 1e-60, 1e-3, 1.0, 7e5, 1e60, 1e170, 1e308] {
            let v = [0.25 * scale, -0.5 * scale, scale];
            let (found, has_direction) = unit(v);
            let Some(expected) = crate::math::unit(Vec3::from(v)) else { panic!("{scale}") };
            assert!(has_direction && (Vec3::from(found) - expected).length() < 4e-16, "{scale}: {found:?} {expected}");
        }
        for none in [[0.0; 3], [-0.0, 0.0, 0.0], [f64::INFINITY, 0.0, 0.0], [f64::NAN, 1.0, 0.0], [1.0, 0.0, f64::NAN]]
        {
            assert!(!unit(none).1, "{none:?}");
        }
    }
}
