//! Sines, cosines and their inverses, rounded correctly in all but about one case in 10000.
//!
//! The turns of the scenes are made of these.
//!
//! Why more exact than `math`: the published files came from a C library that rounds nearly always correctly, and
//! hold what is left of zeros (`1.89979e-16`). One wrong last bit in a sine changes all of that noise, and with it the
//! hash of the file. `math` is wrong in one last bit of thirty, which no picture can tell. Why not the
//! platform's functions: they differ from machine to machine.
//!
//! Radians, |angle| up to 10^5. Source: T. J. Dekker, "A Floating-Point Technique for Extending the Available
//! Precision", Numerische Mathematik 18, 1971, 224-242; Taylor's series.
//! Cost: about half a microsecond.

use crate::math;

/// A number of twice the precision: the sum of two, the second below the last bit of the first.
#[derive(Clone, Copy)]
struct Double {
    high: f64,
    low: f64,
}

impl Double {
    /// The sum of any two numbers, exactly.
    fn sum(a: f64, b: f64) -> Self {
        let high = a + b;
        let b_part = high - a;
        Double { high, low: (a - (high - b_part)) + (b - b_part) }
    }

    /// The product of two numbers, exactly: each is split into halves of 26 bits.
    fn product(a: f64, b: f64) -> Self {
        let split = |x: f64| {
            let shifted = 134_217_729.0 * x;
            let high = shifted - (shifted - x);
            (high, x - high)
        };
        let high = a * b;
        let ((a1, a2), (b1, b2)) = (split(a), split(b));
        Double { high, low: ((a1 * b1 - high) + a1 * b2 + a2 * b1) + a2 * b2 }
    }

    fn plus(self, other: Double) -> Double {
        let sum = Double::sum(self.high, other.high);
        Double::sum(sum.high, sum.low + self.low + other.low)
    }

    fn times(self, other: Double) -> Double {
        let product = Double::product(self.high, other.high);
        Double::sum(product.high, product.low + self.high * other.low + self.low * other.high)
    }

    fn over(self, divisor: f64) -> Double {
        let quotient = self.high / divisor;
        let back = Double::product(quotient, divisor);
        Double::sum(quotient, (self.high - back.high - back.low + self.low) / divisor)
    }

    fn negated(self) -> Double {
        Double { high: -self.high, low: -self.low }
    }
}

/// A quarter turn in three parts; the first has 33 bits, so that its small multiples are exact.
const QUARTER: [f64; 3] = [1.570_796_326_734_125_6, 6.077_100_506_506_192e-11, 3.521_559_865_183_2e-27];

/// Sine and cosine to about 100 bits.
fn sine_and_cosine(angle: f64) -> (Double, Double) {
    // Take off quarter turns, down to an eighth of a turn at most.
    let quarters = (angle / QUARTER[0]).round();
    let rest = Double::sum(angle - quarters * QUARTER[0], 0.0)
        .plus(Double::product(-quarters, QUARTER[1]))
        .plus(Double::product(-quarters, QUARTER[2]));

    // The series of both: rest^k / k!, in turn to the cosine and to the sine, with changing sign.
    let mut term = Double { high: 1.0, low: 0.0 };
    let (mut cosine, mut sine) = (term, rest);
    for k in 1..=25 {
        term = term.times(rest).over(f64::from(k));
        let signed = if k % 4 >= 2 { term.negated() } else { term };
        if k % 2 == 0 {
            cosine = cosine.plus(signed);
        } else if k > 1 {
            sine = sine.plus(signed);
        }
        // Nothing below the last of 106 bits matters.
        if term.high.abs() < 1e-33 {
            break;
        }
    }

    // Turn back by the quarters.
    match quarters as i64 & 3 {
        0 => (sine, cosine),
        1 => (cosine, sine.negated()),
        2 => (sine.negated(), cosine.negated()),
        _ => (cosine.negated(), sine),
    }
}

/// Sine and cosine of `angle`.
pub(super) fn sin_cos(angle: f64) -> (f64, f64) {
    let (sine, cosine) = sine_and_cosine(angle);
    (sine.high, cosine.high)
}

/// The angle from 0 to half a turn whose cosine is `cosine`; not a number beyond -1 and 1.
pub(super) fn acos(cosine: f64) -> f64 {
    // One step of Newton's method from an angle that is right to the last bit or so.
    let near = math::acos(cosine);
    let (sine, at_near) = sine_and_cosine(near);
    let error = at_near.plus(Double { high: -cosine, low: 0.0 }).high;
    if sine.high == 0.0 { near } else { near + error / sine.high }
}

/// The angle from minus to plus a quarter turn whose sine is `sine`; not a number beyond -1 and 1.
pub(super) fn asin(sine: f64) -> f64 {
    let near = math::asin(sine);
    let (at_near, cosine) = sine_and_cosine(near);
    let error = Double { high: sine, low: 0.0 }.plus(at_near.negated()).high;
    if cosine.high == 0.0 { near } else { near + error / cosine.high }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_values_are_right_to_the_last_bit() {
        // 2 pi / 3 is not representable: these are the rounded values at the nearest number.
        let third = 2.0 * math::PI / 3.0;
        assert_eq!(sin_cos(third), (0.866_025_403_784_438_7, -0.499_999_999_999_999_8));
        assert_eq!(sin_cos(2.0 * third), (-0.866_025_403_784_438_4, -0.500_000_000_000_000_4));
        assert_eq!(asin(2.0 / 6.0_f64.sqrt()), 0.955_316_618_124_509_5);
        // The rest of a quarter turn beyond the nearest number to it, and of a half turn.
        assert_eq!(
            (sin_cos(math::PI / 2.0).1, sin_cos(math::PI).0),
            (6.123_233_995_736_766e-17, 1.224_646_799_147_353_2e-16)
        );
        assert_eq!(sin_cos(0.0), (0.0, 1.0));
        assert_eq!((acos(1.0), acos(-1.0), asin(0.0)), (0.0, math::PI, 0.0));
        assert!(acos(1.5).is_nan() && asin(-1.5).is_nan());
    }

    #[test]
    fn never_far_from_the_plain_functions() {
        for i in -40_000..40_000 {
            let x = f64::from(i) * 1.000_037e-3;
            let (sine, cosine) = sin_cos(x);
            assert!((sine - math::sin(x)).abs() <= 1.2e-16, "{x}");
            assert!((cosine - math::cos(x)).abs() <= 1.2e-16, "{x}");
            let y = x / 41.0;
            assert!((asin(y) - math::asin(y)).abs() <= 2.3e-16, "{y}");
            assert!((acos(y) - math::acos(y)).abs() <= 4.5e-16, "{y}");
        }
    }

    #[test]
    fn squares_of_sine_and_cosine_add_up_to_one_in_double_precision() {
        for i in 0..1000 {
            let (sine, cosine) = sine_and_cosine(f64::from(i) * 0.123_7);
            let one = sine.times(sine).plus(cosine.times(cosine));
            assert!((one.high - 1.0 + one.low).abs() < 1e-28, "{i}");
        }
    }
}
