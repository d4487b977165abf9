//! Exact: numbers of any length without rounding, for the decisions that `f64` cannot make.
//!
//! Every finite `f64` is a whole number times a power of two. Sums, differences and products of such numbers are such
//! numbers again, so the sign of a determinant of `f64`s can be found without any error, whatever the exponents: a factor
//! 2^3000 only makes the whole number longer.
//!
//! Why own arithmetic: forty lines of school arithmetic can be read and believed, and the library needs no new crate.
//!
//! Source: D. E. Knuth, "The Art of Computer Programming", vol. 2, section 4.3.1 (the classical algorithms).
//! Cost: a few memory allocations an operation; callers ask a floating-point filter first.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

/// A dyadic rational: a whole number of any length, times a power of two.
#[derive(Clone, Debug, Default)]
pub struct Exact {
    negative: bool,
    /// Digits to the base 2^64, the lowest first; no zero digit at the upper end. Empty: zero.
    digits: Vec<u64>,
    /// The power of two.
    exponent: i64,
}

impl Exact {
    /// The number `value` is; `None` where it is infinite or not a number.
    #[must_use]
    pub fn new(value: f64) -> Option<Exact> {
        if !value.is_finite() {
            return None;
        }
        let bits = value.to_bits();
        let (biased, fraction) = ((bits >> 52) & 0x7FF, bits & ((1 << 52) - 1));
        // Subnormal numbers have no hidden bit.
        let (whole, exponent) =
            if biased == 0 { (fraction, -1074) } else { (fraction | 1 << 52, biased as i64 - 1075) };
        if whole == 0 {
            return Some(Exact::default());
        }
        // Short numbers stay short: 0.5 is 1 * 2^-1.
        let zeros = whole.trailing_zeros();
        let digits = vec![whole >> zeros];
        Some(Exact { negative: value < 0.0, digits, exponent: exponent + i64::from(zeros) })
    }

    /// Below, at or above zero.
    #[must_use]
    pub fn sign(&self) -> Ordering {
        match (self.digits.is_empty(), self.negative) {
            (true, _) => Ordering::Equal,
            (false, true) => Ordering::Less,
            (false, false) => Ordering::Greater,
        }
    }

    /// An `f64` within 2^-52 of its size, or NaN where the exponent is near the limits of `f64`.
    #[must_use]
    pub fn approximate(&self) -> f64 {
        let Some(&top) = self.digits.last() else { return 0.0 };
        let below = self.digits.len().checked_sub(2).map_or(0, |index| self.digits[index]);
        let leading = u128::from(top) << 64 | u128::from(below);
        let exponent = self.exponent + 64 * (self.digits.len() as i64 - 2);
        if exponent.abs() > 800 {
            return f64::NAN;
        }
        let size = leading as f64 * power_of_two(exponent);
        if self.negative { -size } else { size }
    }

    /// The digits of the same number with a lower exponent.
    fn digits_at(&self, exponent: i64) -> Vec<u64> {
        let shift = (self.exponent - exponent) as u64;
        let (whole, bits) = ((shift / 64) as usize, shift % 64);
        let mut digits = vec![0; whole];
        let mut carry = 0;
        for &digit in &self.digits {
            digits.push(digit << bits | carry);
            carry = if bits == 0 { 0 } else { digit >> (64 - bits) };
        }
        digits.push(carry);
        digits
    }

    fn trimmed(negative: bool, mut digits: Vec<u64>, exponent: i64) -> Exact {
        while digits.last() == Some(&0) {
            digits.pop();
        }
        Exact { negative: negative && !digits.is_empty(), digits, exponent }
    }
}

fn power_of_two(exponent: i64) -> f64 {
    f64::from_bits(((exponent + 1023) as u64) << 52)
}

/// The order of two numbers given by their digits; unequal lengths are filled up with zeros.
fn compare(a: &[u64], b: &[u64]) -> Ordering {
    let at = |digits: &[u64], index: usize| digits.get(index).copied().unwrap_or(0);
    let indices = (0..a.len().max(b.len())).rev();
    indices.map(|index| at(a, index).cmp(&at(b, index))).find(|order| order.is_ne()).unwrap_or(Ordering::Equal)
}

fn sum(a: &[u64], b: &[u64]) -> Vec<u64> {
    let mut carry = 0;
    let length = a.len().max(b.len()) + 1;
    let at = |digits: &[u64], index: usize| u128::from(digits.get(index).copied().unwrap_or(0));
    let digit = |index| {
        let total = at(a, index) + at(b, index) + carry;
        carry = total >> 64;
        total as u64
    };
    (0..length).map(digit).collect()
}

/// `a - b`, where `a` is not below `b`.
fn difference(a: &[u64], b: &[u64]) -> Vec<u64> {
    let mut borrow = 0;
    let digit = |(index, &digit): (usize, &u64)| {
        let (rest, first) = digit.overflowing_sub(b.get(index).copied().unwrap_or(0));
        let (rest, second) = rest.overflowing_sub(borrow);
        borrow = u64::from(first || second);
        rest
    };
    a.iter().enumerate().map(digit).collect()
}

impl Add for &Exact {
    type Output = Exact;
    fn add(self, other: &Exact) -> Exact {
        if self.digits.is_empty() {
            return other.clone();
        }
        if other.digits.is_empty() {
            return self.clone();
        }
        let exponent = self.exponent.min(other.exponent);
        let (a, b) = (self.digits_at(exponent), other.digits_at(exponent));
        if self.negative == other.negative {
            return Exact::trimmed(self.negative, sum(&a, &b), exponent);
        }
        match compare(&a, &b) {
            Ordering::Less => Exact::trimmed(other.negative, difference(&b, &a), exponent),
            _ => Exact::trimmed(self.negative, difference(&a, &b), exponent),
        }
    }
}

impl Neg for &Exact {
    type Output = Exact;
    fn neg(self) -> Exact {
        Exact { negative: !self.negative && !self.digits.is_empty(), ..self.clone() }
    }
}

impl Sub for &Exact {
    type Output = Exact;
    fn sub(self, other: &Exact) -> Exact {
        self + &-other
    }
}

impl Mul for &Exact {
    type Output = Exact;
    fn mul(self, other: &Exact) -> Exact {
        let mut digits = vec![0; self.digits.len() + other.digits.len()];
        for (low, &a) in self.digits.iter().enumerate() {
            let mut carry = 0;
            for (high, &b) in other.digits.iter().enumerate() {
                let total = u128::from(a) * u128::from(b) + u128::from(digits[low + high]) + carry;
                digits[low + high] = total as u64;
                carry = total >> 64;
            }
            digits[low + other.digits.len()] = carry as u64;
        }
        Exact::trimmed(self.negative != other.negative, digits, self.exponent + other.exponent)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_bigint::BigInt;

    /// The same number by the crate that only tests may use, times 2^4400.
    fn big(exact: &Exact) -> BigInt {
        let digits = exact.digits.iter().rev().fold(BigInt::from(0), |sum, &digit| (sum << 64) + digit);
        let size = digits << (exact.exponent + 4400);
        if exact.negative { -size } else { size }
    }

    fn of(value: f64) -> Exact {
        Exact::new(value).expect("finite")
    }

    fn numbers() -> Vec<f64> {
        let mut state = 1_u64;
        let mut numbers = vec![0.0, -0.0, 1.0, -1.0, 0.5, 5e-324, -5e-324, f64::MAX, f64::MIN, f64::MIN_POSITIVE];
        while numbers.len() < 60 {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            numbers.push(f64::from_bits(state ^ state >> 29));
            numbers.push((state >> 40) as f64 - 8_388_608.5);
        }
        numbers.retain(|number| number.is_finite());
        numbers
    }

    #[test]
    fn sums_and_products_equal_those_of_another_program() {
        let scale = BigInt::from(1) << 4400;
        for a in numbers() {
            for b in numbers() {
                let (a, b) = (of(a), of(b));
                assert_eq!(big(&(&a + &b)), big(&a) + big(&b));
                assert_eq!(big(&(&a - &b)), big(&a) - big(&b));
                assert_eq!(big(&(&a * &b)) * &scale, big(&a) * big(&b));
                // Longer ones, with carries over digits.
                let (c, d) = (&(&a * &b) + &a, &(&a * &b) - &b);
                assert_eq!(big(&(&c - &d)), big(&c) - big(&d));
                assert_eq!((&a - &b).sign(), big(&a).cmp(&big(&b)));
            }
        }
    }

    #[test]
    fn approximation_is_close() {
        for a in numbers().into_iter().filter(|a| (1e-200..1e200).contains(&a.abs())) {
            assert_eq!(of(a).approximate(), a);
            let square = &of(a * 1e-60) * &of(a * 1e-60);
            let close = (square.approximate() / (a * 1e-60 * (a * 1e-60)) - 1.0).abs() < 1e-15;
            assert!(close || square.approximate().is_nan(), "{a}");
        }
        assert_eq!(of(0.0).approximate(), 0.0);
        assert!(of(f64::MAX).approximate().is_nan());
        assert!(Exact::new(f64::INFINITY).is_none() && Exact::new(f64::NAN).is_none());
    }
}
