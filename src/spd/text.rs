//! Numbers as text, exactly as `printf("%g")` writes them: six significant digits, correctly rounded.
//!
//! The last step of the room: every coordinate of every scene passes here.
//!
//! Why not `format!`: the scenes are compared byte for byte with published files, which were written by `%g`, and
//! Rust has no such format. Why two ways: the scaled integer below costs a tenth of exact formatting, and proves for
//! each number that it may be trusted; where the proof fails (a few numbers in a billion) the exact way answers.
//!
//! Source: ISO C, fprintf, conversion `g`. Rounding by proof: the idea of D. Gay, "Correctly Rounded Binary-Decimal
//! and Decimal-Binary Conversions", Numerical Analysis Manuscript 90-10, AT&T Bell Laboratories, 1990.
//! Cost: one multiplication or division, one rounding, six digits; no heap.

use std::io::Write;

/// A positive number rounded to six digits: `digits / 100000 * 10^exponent`, `digits` from 100000 to 999999.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Decimal {
    digits: u32,
    exponent: i32,
}

/// Appends `value` the way C prints it with `%g`, whatever it is: `-0`, `1e+06`, `-2.22045e-16`, `inf`, `nan`.
pub(super) fn write_g(text: &mut Vec<u8>, value: f64) {
    if value.is_sign_negative() {
        text.push(b'-');
    }
    let magnitude = value.abs();
    if magnitude == 0.0 {
        text.push(b'0');
    } else if magnitude.is_finite() {
        let decimal = rounded_by_scaling(magnitude).unwrap_or_else(|| rounded_exactly(magnitude));
        write_decimal(text, decimal);
    } else {
        text.extend_from_slice(if magnitude.is_nan() { b"nan" } else { b"inf" });
    }
}

/// Powers of ten that `f64` holds exactly.
const POWERS_OF_TEN: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
    1e21, 1e22,
];

/// Rounds by scaling to an integer of six digits; `None` where the result would not be certain.
///
/// The scale is exact, so the product has one rounding, and rounding is monotone: it may carry a product onto a
/// number that `f64` holds, such as a tie or a million, but never across. Only a product that lands on a tie is in doubt.
fn rounded_by_scaling(magnitude: f64) -> Option<Decimal> {
    // The exponent of 10 from the exponent of 2: 78913 / 2^18 = log10(2) closely enough for |binary| <= 1650.
    let binary = (magnitude.to_bits() >> 52) as i32 - 1023;
    let mut exponent = (binary * 78913) >> 18;
    let mut scaled = scale(magnitude, 5 - exponent)?;
    if scaled >= 1e6 {
        exponent += 1;
        scaled = scale(magnitude, 5 - exponent)?;
    }

    // Round to nearest, ties to even, unless the tie may be one by rounding only.
    let whole = scaled as u32;
    let fraction = scaled - f64::from(whole);
    if fraction == 0.5 && !is_exact_product(magnitude, 5 - exponent) {
        return None;
    }
    let digits = whole + u32::from(fraction > 0.5 || (fraction == 0.5 && whole % 2 == 1));

    // 999999.7 has become 1000000: one digit too many.
    if digits == 1_000_000 {
        return Some(Decimal { digits: 100_000, exponent: exponent + 1 });
    }
    Some(Decimal { digits, exponent })
}

/// `magnitude * 10^power` with one rounding; `None` where 10^|power| is not exact.
fn scale(magnitude: f64, power: i32) -> Option<f64> {
    let factor = POWERS_OF_TEN.get(power.unsigned_abs() as usize)?;
    Some(if power >= 0 { magnitude * factor } else { magnitude / factor })
}

/// Whether [`scale`] rounds nothing. Scenes halve and halve again: a quarter of the numbers of tetra 9 are true ties.
///
/// The product by 2^power is always exact, that by 5^power (at most 7/3 power + 1 bits) when all bits find room.
fn is_exact_product(magnitude: f64, power: i32) -> bool {
    let fraction = magnitude.to_bits() | 1 << 52;
    let bits = 53 - fraction.trailing_zeros() as i32;
    power >= 0 && bits + 7 * power / 3 < 53
}

/// Rounds through `{:.5e}`, which rounds the exact binary value, ties to even.
fn rounded_exactly(magnitude: f64) -> Decimal {
    let mut line = [0; 16];
    let mut rest = &mut line[..];
    write!(rest, "{magnitude:.5e}").expect("d.ddddde-ddd has 12 characters, the line 16");
    let free = rest.len();

    // "d.ddddde-XX": the figures stand at fixed places, the exponent from the ninth on.
    let written = &line[..16 - free];
    let digits = written[..7].iter().filter(|figure| figure.is_ascii_digit());
    let digits = digits.fold(0, |sum, figure| 10 * sum + u32::from(figure - b'0'));
    let negative = written[8] == b'-';
    let size = written[8..].iter().filter(|figure| figure.is_ascii_digit());
    let size = size.fold(0, |sum, figure| 10 * sum + i32::from(figure - b'0'));
    Decimal { digits, exponent: if negative { -size } else { size } }
}

/// Lays a decimal out by the rules of `%g`: plain for exponents -4 to 5, scientific otherwise, no trailing zeros.
fn write_decimal(text: &mut Vec<u8>, decimal: Decimal) {
    let mut figures = [b'0'; 6];
    let mut rest = decimal.digits;
    for figure in figures.iter_mut().rev() {
        *figure = b'0' + (rest % 10) as u8;
        rest /= 10;
    }
    let significant = figures.iter().rposition(|&figure| figure != b'0').map_or(1, |last| last + 1);

    match decimal.exponent {
        before @ 0..=5 => write_pointed(text, &figures, before as usize + 1, significant),
        small @ -4..=-1 => {
            text.extend_from_slice(&b"0.000"[..(1 - small) as usize]);
            text.extend_from_slice(&figures[..significant]);
        }
        exponent => {
            write_pointed(text, &figures, 1, significant);
            text.extend_from_slice(if exponent < 0 { b"e-" } else { b"e+" });
            write!(text, "{:02}", exponent.unsigned_abs()).expect("writing to memory does not fail");
        }
    }
}

/// Writes `whole` figures, then a point and the rest of the `significant` ones if there are any.
fn write_pointed(text: &mut Vec<u8>, figures: &[u8; 6], whole: usize, significant: usize) {
    text.extend_from_slice(&figures[..whole]);
    if significant > whole {
        text.push(b'.');
        text.extend_from_slice(&figures[whole..significant]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn printed(value: f64) -> String {
        let mut text = Vec::new();
        write_g(&mut text, value);
        String::from_utf8(text).expect("ASCII")
    }

    /// Expected texts are those of C's printf.
    #[test]
    fn agrees_with_printf() {
        let cases = [
            (0.0, "0"),
            (-0.0, "-0"),
            (1.0, "1"),
            (-12.0, "-12"),
            (100_000.0, "100000"),
            (999_999.0, "999999"),
            (999_999.5, "1e+06"),
            (999_999.4, "999999"),
            (1e6, "1e+06"),
            (1_234_565.0, "1.23456e+06"),
            (0.007_812_5, "0.0078125"),
            (0.501_953_125, "0.501953"),
            (0.507_812_5, "0.507812"),
            (0.523_437_5, "0.523438"),
            (1_234_575.0, "1.23458e+06"),
            (0.1, "0.1"),
            (2.0 / 3.0, "0.666667"),
            (1e-4, "0.0001"),
            (1e-5, "1e-05"),
            (9.999_995e-5, "0.0001"),
            (9.999_994_9e-5, "9.99999e-05"),
            (0.000_123_456_78, "0.000123457"),
            (-2.220_446_049_250_313e-16, "-2.22045e-16"),
            (1e100, "1e+100"),
            (f64::MAX, "1.79769e+308"),
            (f64::MIN_POSITIVE, "2.22507e-308"),
            (5e-324, "4.94066e-324"),
            (f64::INFINITY, "inf"),
            (f64::NEG_INFINITY, "-inf"),
            (f64::NAN, "nan"),
        ];
        for (value, expected) in cases {
            assert_eq!(printed(value), expected, "{value:e}");
        }
    }

    /// Scaling may decline, but must never disagree with exact rounding.
    #[track_caller]
    fn check_scaling(value: f64) -> bool {
        let fast = rounded_by_scaling(value);
        if let Some(fast) = fast {
            assert_eq!(fast, rounded_exactly(value), "{value:e}");
        }
        fast.is_some()
    }

    #[test]
    fn scaling_agrees_with_exact_rounding_wherever_it_answers() {
        // A linear congruential sequence, so that a failure repeats.
        let mut state = 1_u64;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            state ^ (state >> 29)
        };
        let mut declined = 0;
        for _ in 0..400_000 {
            // Any bit pattern; a number of everyday size; a short decimal; a decimal tie and its two neighbors.
            let any = f64::from_bits(next() & !(1 << 63));
            if any.is_finite() && any > 0.0 {
                check_scaling(any);
            }
            let everyday = f64::from_bits((1003 + next() % 40) << 52 | next() >> 12);
            declined += u32::from(!check_scaling(everyday));
            let power = POWERS_OF_TEN[(next() % 23) as usize];
            check_scaling((1 + next() % 1_000_000) as f64 / power);
            // Multiples of powers of 1/2, which the scenes are full of: many are ties.
            check_scaling((1 + next() % 5000) as f64 / (1 << (next() % 14)) as f64);
            let tie = (10 * (100_000 + next() % 900_000) + 5) as f64 / power;
            for near in [tie.next_down(), tie, tie.next_up()] {
                check_scaling(near);
            }
        }
        assert!(declined < 10, "the quick way declined {declined} everyday numbers of 400000");
    }

    #[test]
    fn scaling_agrees_at_every_power_of_ten_and_two() {
        for exponent in -1074..1024 {
            let power = 2_f64.powi(exponent);
            for near in [power.next_down(), power, power.next_up()] {
                if near > 0.0 {
                    check_scaling(near);
                }
            }
        }
        for exponent in -323..308 {
            let power: f64 = format!("1e{exponent}").parse().expect("a number");
            for near in [power.next_down(), power, power.next_up(), 0.999_999_5 * power, 0.999_999_4 * power] {
                if near > 0.0 {
                    check_scaling(near);
                }
            }
        }
    }
}
