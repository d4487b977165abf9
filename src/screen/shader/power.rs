//! The cosine power of a highlight, for one number or several side by side.
//!
//! cosine, shine -> POWER -> share of light in the highlight
//!
//! Why not `libm`: its `pow` takes one number at a time and was a third of the time of a picture with Phong shading. This one has no
//! table and no branch, so eight lanes take as long as one; and every rasterizer asks it, so all agree.
//!
//! x^y = 2^(y log2 x). The logarithm is that of the fraction, by the series of the inverse hyperbolic tangent, plus the exponent; the power of
//! two is split into a whole one and the series of the exponential function. A shine that is a small whole number, as nearly all are, needs
//! neither: squares and products, a bit of the exponent at a time.
//!
//! Error: relative to the result at most 4e-16 (2 + |log2 result|), measured against `libm`: less than 5e-13 wherever the result is a
//! normal number. By products at most 1.2e-16 for each of `exponent`, 1.3e-13 at most. Light is rounded to `f32`, 6e-8, afterwards.
//! Source: the series are L. Euler, "Introductio in analysin infinitorum" I, 1748, chapter 7.
//! Cost: by products, at most two for each bit of the exponent; else one division and some seventy other operations, for as many numbers as there
//! are lanes.

use crate::screen::lane::Wide;
use std::f64::consts::{LN_2, SQRT_2};

/// 2 artanh(s) / s in powers of s^2, divided by ln 2. Fractions are held between sqrt(1/2) and sqrt(2), so s is at most 0.172, and what
/// is left out is below 2^-57 of the sum.
const LOGARITHM: [f64; 11] = {
    let mut terms = [0.0; 11];
    let mut term = 0;
    while term < 11 {
        terms[term] = 2.0 / LN_2 / (2 * term + 1) as f64;
        term += 1;
    }
    terms
};

/// The exponential function in powers of z; z is at most ln(2) / 2, and what is left out is below 2^-57.
const EXPONENTIAL: [f64; 14] = {
    let mut terms = [1.0; 14];
    let mut term = 1;
    while term < 14 {
        terms[term] = terms[term - 1] / term as f64;
        term += 1;
    }
    terms
};

/// Whole exponents from 1 to here are products. Farther up the error of products would pass that of the series.
const MOST_BY_PRODUCTS: u32 = 1024;

/// `base` to the power of `exponent`; a base that is not above 0 counts as 0, and 0 to the power of 0 is 1.
#[inline(always)]
pub(super) fn power<T: Wide>(base: T, exponent: f64) -> T {
    // Saturates: what is no whole number of 32 bits comes back as another number.
    let count = exponent as u32;
    if (1..=MOST_BY_PRODUCTS).contains(&count) && f64::from(count) == exponent {
        return T::choose(base.above(base.all(0.0)), product(base, count), base.all(0.0));
    }
    by_series(base, exponent)
}

/// `base` times itself, from the exponent's highest bit down. Every product on the way lies between the base and the result, so none is lost below
/// the smallest number unless the result is.
#[inline(always)]
fn product<T: Wide>(base: T, exponent: u32) -> T {
    let mut result = base;
    let mut bit = exponent.ilog2();
    while bit > 0 {
        bit -= 1;
        result = result * result;
        if exponent >> bit & 1 == 1 {
            result = result * base;
        }
    }
    result
}

#[inline(always)]
fn by_series<T: Wide>(base: T, exponent: f64) -> T {
    let [zero, one] = [base.all(0.0), base.all(1.0)];
    let (whole, fraction) = parts(base);
    let s = (fraction - one) / (fraction + one);
    let logarithm = whole + s * series(s * s, &LOGARITHM);

    // Beyond this the result is 0 or infinite.
    let wanted = (logarithm * base.all(exponent)).hold(base.all(-1100.0), base.all(1100.0));
    let whole = nearest_whole(wanted);
    let rest = series((wanted - whole) * base.all(LN_2), &EXPONENTIAL);
    // In two steps: the whole power of two may lie outside the range while the result does not, or is rounded to less digits.
    let half = nearest_whole(whole * base.all(0.5));
    let result = rest * half.power_of_two() * (whole - half).power_of_two();

    let at_zero = if exponent > 0.0 {
        zero
    } else if exponent < 0.0 {
        base.all(f64::INFINITY)
    } else {
        one
    };
    T::choose(base.above(zero), result, at_zero)
}

/// Splits a positive number into a whole power of two and a fraction between sqrt(1/2) and sqrt(2).
#[inline(always)]
fn parts<T: Wide>(number: T) -> (T, T) {
    /// Brings numbers with less than all digits into the range of the others.
    const LIFT: f64 = 54.0;
    let subnormal = number.all(f64::MIN_POSITIVE).above(number);
    let lifted = T::choose(subnormal, number * number.all((1_u64 << 54) as f64), number);
    let (whole, fraction) = lifted.exponent_and_fraction();
    let whole = T::choose(subnormal, whole - number.all(LIFT), whole);
    let upper = fraction.above(number.all(SQRT_2));
    (T::choose(upper, whole + number.all(1.0), whole), T::choose(upper, fraction * number.all(0.5), fraction))
}

/// The nearest whole number, of numbers up to 2^51: halves go to the even one.
#[inline(always)]
fn nearest_whole<T: Wide>(number: T) -> T {
    // Numbers from 2^52 to 2^53 are whole.
    let shift = number.all(1.5 * (1_u64 << 52) as f64);
    (number + shift) - shift
}

/// `terms` times the powers of x, added up: even and odd ones apart, so that two additions are under way at a time.
#[inline(always)]
fn series<T: Wide, const N: usize>(x: T, terms: &[f64; N]) -> T {
    let square = x * x;
    let (mut even, mut odd) = (x.all(0.0), x.all(0.0));
    let mut term = N;
    while term > 0 {
        term -= 1;
        if term.is_multiple_of(2) {
            even = even * square + x.all(terms[term]);
        } else {
            odd = odd * square + x.all(terms[term]);
        }
    }
    even + x * odd
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::pow;

    /// The error relative to `libm`'s power, in units of the stated bound.
    fn error(base: f64, exponent: f64) -> f64 {
        let (found, expected) = (power(base, exponent), pow(base, exponent));
        if found == expected {
            return 0.0;
        }
        // Results with less than all digits are rounded to steps of 5e-324 besides.
        let by_products = exponent.fract() == 0.0 && (1.0..=1024.0).contains(&exponent);
        let (steps, bound) = match by_products {
            // The last but one product may have been rounded to such steps, too.
            true => (2.0, 1.2e-16 * exponent + 4e-16),
            false => (1.0, 4e-16 * (2.0 + expected.log2().abs())),
        };
        let step = if expected < f64::MIN_POSITIVE { steps * 5e-324 } else { 0.0 };
        ((found - expected).abs() - step) / expected / bound
    }

    #[test]
    fn powers_are_those_of_libm_within_the_bound() {
        let mut state = 1996_u64;
        let mut bits = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            state >> 11
        };
        let (mut worst, mut normal) = (0.0_f64, 0);
        for number in 0..300_000 {
            let unit = bits() as f64 / (1_u64 << 53) as f64;
            // Near 1, between 0 and 1, and of any magnitude.
            let base = [1.0 - unit * 2e-5, unit, f64::from_bits(bits() << 10 & 0x3FF0_0000_0000_0000 | bits() >> 2)];
            let spread = bits() as f64 / (1_u64 << 53) as f64;
            let exponent = [spread * 100.0, spread * 1e5, (spread - 0.5) * 4.0, (bits() % 300) as f64];
            let (base, exponent) = (base[number % 3], exponent[number / 3 % 4]);
            let off = error(base, exponent);
            assert!(off <= 1.0, "{base:e} to the power of {exponent}: {off} times the bound");
            worst = worst.max(off);
            normal += u32::from(power(base, exponent).is_normal());
        }
        println!("worst error {worst:.3} of the bound");
        assert!(normal > 100_000, "{normal}");
    }

    #[test]
    fn products_and_series_agree() {
        for exponent in 1..=1024 {
            for base in [0.999_f64, 0.9, 0.5, 1.01] {
                let (product, series) = (product(base, exponent), by_series(base, f64::from(exponent)));
                assert!(
                    (product / series - 1.0).abs() < 6e-13,
                    "{base} to the power of {exponent}: {product:e}, {series:e}"
                );
            }
        }
        assert_eq!(power(0.75, 1.0), 0.75);
        assert_eq!(power(0.75, 2.0), 0.5625);
        assert_eq!(power(f64::NAN, 8.0), 0.0);
    }

    #[test]
    fn the_ends_are_exact() {
        for exponent in [0.0, 1e-300, 0.5, 1.0, 20.0, 1e5, 1e300, f64::MAX] {
            assert_eq!(power(1.0, exponent), 1.0, "{exponent}");
            assert_eq!(power(0.0, exponent), f64::from(u8::from(exponent == 0.0)), "{exponent}");
        }
        for base in [5e-324, 1e-310, f64::MIN_POSITIVE, 1e-9, 0.3, 0.999, 1.0] {
            assert_eq!(power(base, 0.0), 1.0, "{base}");
        }
        assert_eq!(power(0.5, 3.0), 0.125);
        assert_eq!(power(0.25, 511.0), pow(0.25, 511.0));
        // The last step above 0, and below.
        assert_eq!([1074.0, 1076.0, 1e9].map(|exponent| power(0.5, exponent)), [5e-324, 0.0, 0.0]);
        assert_eq!((power(0.5, -1e9), power(0.0, -1.0)), (f64::INFINITY, f64::INFINITY));
        assert_eq!(power(-0.5, 3.0), 0.0);
        assert!((power(5e-324, 0.5) / pow(5e-324, 0.5) - 1.0).abs() < 1e-13);
    }
}
