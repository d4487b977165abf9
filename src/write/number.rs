//! Numbers as text: the fewest digits that read back to the same bits.
//!
//! Why not a fixed number of digits: six, as C's `%g` prints, move vertices; seventeen make every file twice as long as it need be.

use std::io::{self, Write};

/// Writes a blank and `value`, plain or with an exponent, whichever is shorter.
///
/// # Errors
/// [`io::ErrorKind::InvalidData`] where `value` is infinite or not a number, which no scene file can say; and those of `out`.
pub(super) fn write_number(out: &mut dyn Write, value: f64) -> io::Result<()> {
    if !value.is_finite() {
        return Err(io::Error::new(io::ErrorKind::InvalidData, format!("a number of the scene is {value}")));
    }
    // Only trailing zeros, or zeros behind the point, make the plain notation the longer one: 1200000, 0.00012.
    let size = value.abs();
    if size != 0.0 && !(0.1..100.0).contains(&size) {
        let (plain, exponential) = (format!("{value}"), format!("{value:e}"));
        let shorter = if exponential.len() < plain.len() { exponential } else { plain };
        return write!(out, " {shorter}");
    }
    write!(out, " {value}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(value: f64) -> String {
        let mut out = Vec::new();
        write_number(&mut out, value).expect("memory does not fail");
        String::from_utf8(out).expect("ascii").trim_start().to_string()
    }

    #[test]
    fn numbers_are_short_and_read_back() {
        for (value, expected) in [
            (0.0, "0"),
            (-0.0, "-0"),
            (1.0, "1"),
            (0.1, "0.1"),
            (0.05, "0.05"),
            (1e-3, "1e-3"),
            (512.0, "512"),
            (1e5, "1e5"),
            (-1e300, "-1e300"),
            (1e-300, "1e-300"),
            (0.1 + 0.2, "0.30000000000000004"),
        ] {
            assert_eq!(text(value), expected);
        }
        let mut bits = 0x9E37_79B9_7F4A_7C15u64;
        for _ in 0..100_000 {
            bits = bits.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let value = f64::from_bits(bits);
            if value.is_finite() {
                assert_eq!(text(value).parse::<f64>().expect("a number").to_bits(), value.to_bits());
            }
        }
    }

    #[test]
    fn what_no_file_can_say_is_an_error() {
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(write_number(&mut Vec::new(), value).expect_err("refused").kind(), io::ErrorKind::InvalidData);
        }
    }
}
