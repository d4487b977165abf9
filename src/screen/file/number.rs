//! Numbers as text: the shortest digits that read back to the same bits.

use std::fmt::{Display, Formatter, LowerExp, Result};

/// Prints a finite `f32` or `f64`: plainly, or with an exponent where plain digits would be a row of zeros.
pub(super) struct Number<T>(pub T);

impl<T: Copy + Display + LowerExp + Into<f64>> Display for Number<T> {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> Result {
        let size = self.0.into().abs();
        if size == 0.0 || (1e-5..1e16).contains(&size) {
            write!(formatter, "{}", self.0)
        } else {
            write!(formatter, "{:e}", self.0)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_are_short_and_exact() {
        let shown = [0.1, -0.0, 2.0, 1e-7, 1.5e300, 5e-324].map(|number: f64| Number(number).to_string());
        assert_eq!(shown, ["0.1", "-0", "2", "1e-7", "1.5e300", "5e-324"]);
        assert_eq!(Number(0.1f32).to_string(), "0.1");
        for bits in (0..2000u64).map(|step| step * 0x000A_5A5A_5A5A_5A5A % 0x7FF0_0000_0000_0000) {
            let number = f64::from_bits(bits);
            assert_eq!(Number(number).to_string().parse::<f64>().expect("a number").to_bits(), bits);
        }
    }
}
