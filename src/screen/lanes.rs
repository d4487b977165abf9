//! Lanes: eight numbers side by side, for what is written once for any number of them.

use super::lane::{BIAS, FRACTION, Lane, WHOLE, Wide};
use fearless_simd::{
    Select, Simd, SimdBase, SimdCombine, SimdFloat, SimdMask, SimdNarrow, SimdSplit, SimdWiden, f32x8, f64x8, mask64x8,
    prelude::ExtractToken, u64x8,
};

impl<S: Simd> Lane for f32x8<S> {
    #[inline(always)]
    fn hold(self, low: Self, high: Self) -> Self {
        // The lower bound is looked at last, so it wins where the range is empty, and not-a-number passes both.
        let below_high = self.simd_gt(high).select(high, self);
        self.simd_lt(low).select(low, below_high)
    }
}

impl<S: Simd> Lane for f64x8<S> {
    #[inline(always)]
    fn hold(self, low: Self, high: Self) -> Self {
        let below_high = self.simd_gt(high).select(high, self);
        self.simd_lt(low).select(low, below_high)
    }
}

impl<S: Simd> Wide for f64x8<S> {
    const LANES: u32 = 8;

    type Mask = mask64x8<S>;

    #[inline(always)]
    fn all(self, number: f64) -> Self {
        f64x8::splat(self.token(), number)
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        SimdFloat::sqrt(self)
    }

    #[inline(always)]
    fn above(self, other: Self) -> mask64x8<S> {
        self.simd_gt(other)
    }

    #[inline(always)]
    fn choose(mask: mask64x8<S>, yes: Self, no: Self) -> Self {
        mask.select(yes, no)
    }

    #[inline(always)]
    fn count(mask: mask64x8<S>) -> u32 {
        mask.to_bitmask().count_ones()
    }

    #[inline(always)]
    fn exponent_and_fraction(self) -> (Self, Self) {
        let simd = self.token();
        let bits: u64x8<S> = self.to_bits();
        let exponent = (bits >> 52) | u64x8::splat(simd, WHOLE.to_bits());
        let fraction = (bits & u64x8::splat(simd, FRACTION)) | u64x8::splat(simd, 1.0_f64.to_bits());
        (f64x8::from_bits(exponent) - self.all(WHOLE + BIAS), f64x8::from_bits(fraction))
    }

    #[inline(always)]
    fn power_of_two(self) -> Self {
        let bits: u64x8<S> = (self + self.all(WHOLE + BIAS)).to_bits();
        f64x8::from_bits(bits << 52)
    }

    #[inline(always)]
    fn each(self, change: impl Fn(f64) -> f64) -> Self {
        let mut numbers = self;
        for lane in 0..8 {
            numbers[lane] = change(numbers[lane]);
        }
        numbers
    }
}

/// 0, 1, ... 7.
#[inline(always)]
pub(crate) fn counting<S: Simd>(simd: S) -> f32x8<S> {
    f32x8::from_slice(simd, &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0])
}

/// Exact.
#[inline(always)]
pub(crate) fn widened<S: Simd>(numbers: f32x8<S>) -> f64x8<S> {
    let (low, high) = numbers.widen();
    low.combine(high)
}

/// Rounded once, to the nearest.
#[inline(always)]
pub(crate) fn rounded<S: Simd>(numbers: f64x8<S>) -> f32x8<S> {
    let (low, high) = numbers.split();
    low.narrow(high)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::screen::Instructions;
    use fearless_simd::dispatch;

    /// The same eight operations in lanes and one by one.
    #[inline(always)]
    fn lanes_are_numbers<S: Simd>(simd: S, numbers: [f64; 8]) {
        let eight = f64x8::from_slice(simd, &numbers);
        let (exponents, fractions) = eight.exponent_and_fraction();
        for lane in 0..8 {
            let number = numbers[lane];
            assert_eq!((exponents[lane], fractions[lane]), number.exponent_and_fraction(), "{number}");
            assert_eq!(exponents.power_of_two()[lane], exponents[lane].power_of_two());
            assert_eq!(Wide::sqrt(eight)[lane].to_bits(), number.sqrt().to_bits());
            assert_eq!(widened(rounded(eight))[lane], f64::from(number as f32));
            assert_eq!(eight.each(|number| number * 3.0)[lane], number * 3.0);
            assert_eq!(eight.hold(eight.all(0.5), eight.all(2.0))[lane], number.hold(0.5, 2.0));
        }
        assert_eq!(
            f64x8::count(eight.above(eight.all(1.0))),
            numbers.iter().filter(|&&number| number > 1.0).count() as u32
        );
    }

    #[test]
    fn lanes_compute_as_numbers_do() {
        let numbers = [1.0, 0.3, 1e-300, f64::MIN_POSITIVE, 7e200, 2.0, f64::MAX, 1.0 + f64::EPSILON];
        for instructions in Instructions::ALL {
            dispatch!(instructions.level(), simd => lanes_are_numbers(simd, numbers));
        }
    }
}
