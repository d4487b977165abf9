//! Words and numbers: the scanner under all grammars of this room.
//!
//! Source -TOKENS-> words, numbers -grammar-> statements
//!
//! Why an own number scanner: a scene file is numbers, so this is where reading spends its time, and the standard
//! parser takes `nan` and `inf` and turns `1e999` into infinity. A decimal of at most 15 digits and a small exponent is
//! an integer below 2^53 times or over a power of ten that `f64` holds exactly: one multiplication or division, rounded
//! once, is the correctly rounded value. Everything else goes to the standard parser, which is correctly rounded too.
//! Source: W. Clinger, "How to Read Floating Point Numbers Accurately", PLDI 1990 (the fast case). Most numbers are read eight bytes
//! at a time (`eight`).
//!
//! Why a tail and no position: a parser's input is the rest of the text, so the offset of anything is the length of
//! the text minus the length of the tail. Lines and columns are only worked out for messages.

#[path = "eight.rs"]
mod eight;

/// Whether this byte separates words.
#[inline]
#[must_use]
pub fn is_space(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\n' | b'\r' | 0x0B | 0x0C)
}

/// The tail from the next word on.
#[inline]
#[must_use]
pub fn skip_space(tail: &[u8]) -> &[u8] {
    let mut rest = tail;
    while let Some((&byte, after)) = rest.split_first() {
        if !is_space(byte) {
            break;
        }
        rest = after;
    }
    rest
}

/// The word a tail starts with; empty at the end or before white space.
#[must_use]
pub fn word(tail: &[u8]) -> &[u8] {
    &tail[..tail.iter().position(|&byte| is_space(byte)).unwrap_or(tail.len())]
}

/// The tail that starts with the n-th word; 0 is the first.
#[must_use]
pub fn nth_word(tail: &[u8], n: usize) -> &[u8] {
    let mut rest = tail;
    for _ in 0..n {
        rest = skip_space(&rest[word(rest).len()..]);
    }
    rest
}

/// How many words there are before `end`, a later tail.
#[must_use]
pub fn count_words(tail: &[u8], end: &[u8]) -> usize {
    let (mut rest, mut count) = (tail, 0);
    while rest.len() > end.len() {
        rest = nth_word(rest, 1);
        count += 1;
    }
    count
}

/// How many words follow that were meant as numbers.
#[must_use]
pub fn count_numbers(tail: &[u8]) -> usize {
    let (mut rest, mut count) = (skip_space(tail), 0);
    while looks_numeric(word(rest)) {
        rest = nth_word(rest, 1);
        count += 1;
    }
    count
}

/// Whether a word was probably meant as a number: it starts like one, or is a name for what is not finite.
#[must_use]
pub fn looks_numeric(word: &[u8]) -> bool {
    let unsigned = word.strip_prefix(b"-").or(word.strip_prefix(b"+")).unwrap_or(word);
    let starts = |name: &[u8]| unsigned.len() >= name.len() && unsigned[..name.len()].eq_ignore_ascii_case(name);
    unsigned.len() < word.len()
        || matches!(word.first(), Some(b'0'..=b'9' | b'.'))
        || unsigned.eq_ignore_ascii_case(b"nan")
        || unsigned.eq_ignore_ascii_case(b"inf")
        || starts(b"infinity")
        || starts(b"nan(")
}

/// A decimal number at the start of a tail.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Number {
    /// Correctly rounded, finite.
    pub value: f64,
    /// How many bytes it takes; white space or the end follows.
    pub length: usize,
    /// It is written as something other than 0 but rounds to 0.
    pub vanished: bool,
}

/// Why a word is not a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NotANumber {
    /// It is written otherwise than `[+-] digits [. digits] [e [+-] digits]`.
    Malformed,
    /// It rounds to infinity.
    TooLarge,
}

pub(super) const POWERS_OF_TEN: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
    1e21, 1e22,
];

/// Reads the number a tail starts with (no white space before it).
///
/// # Errors
/// The word is not a decimal number, or too large for `f64`.
#[inline(always)]
pub fn number(tail: &[u8]) -> Result<Number, NotANumber> {
    match eight::number(tail) {
        Some(number) => Ok(number),
        None => any_number(tail),
    }
}

/// Reads any number, byte by byte. Rarely called, so it stays out of the way of the quick one.
#[inline(never)]
fn any_number(tail: &[u8]) -> Result<Number, NotANumber> {
    let mut at = usize::from(matches!(tail.first(), Some(b'-' | b'+')));
    let negative = tail.first() == Some(&b'-');

    // Digits, as one integer and the power of ten it must be multiplied with.
    let digits = Digits::default().read(tail, &mut at);
    let whole_digits = digits.count;
    let mut digits = digits;
    if tail.get(at) == Some(&b'.') {
        at += 1;
        digits = digits.read(tail, &mut at);
    }
    let decimals = digits.count - whole_digits;
    if digits.count == 0 {
        return Err(NotANumber::Malformed);
    }
    let mut exponent = -(decimals as i64);
    if matches!(tail.get(at), Some(b'e' | b'E')) {
        at += 1;
        exponent += scan_exponent(tail, &mut at)?;
    }
    if tail.get(at).is_some_and(|&byte| !is_space(byte)) {
        return Err(NotANumber::Malformed);
    }

    // One correctly rounded operation, where both operands are exact.
    let is_exact = digits.exact && digits.value <= 1 << 53;
    let magnitude = match usize::try_from(exponent.unsigned_abs()) {
        Ok(power) if is_exact && power < POWERS_OF_TEN.len() => {
            let (mantissa, power) = (digits.value as f64, POWERS_OF_TEN[power]);
            if exponent < 0 { mantissa / power } else { mantissa * power }
        }
        _ => round_slowly(&tail[..at])?,
    };
    let value = if negative { -magnitude } else { magnitude };
    Ok(Number { value, length: at, vanished: value == 0.0 && (digits.value != 0 || !digits.exact) })
}

/// Decimal digits read so far, the point left out.
#[derive(Clone, Copy)]
struct Digits {
    value: u64,
    count: usize,
    /// `value` is all of them: it did not overflow.
    exact: bool,
}

impl Default for Digits {
    fn default() -> Self {
        Digits { value: 0, count: 0, exact: true }
    }
}

impl Digits {
    #[inline]
    fn read(mut self, tail: &[u8], at: &mut usize) -> Digits {
        let start = *at;
        while let Some(digit) = tail.get(*at).map(|byte| byte.wrapping_sub(b'0')).filter(|&digit| digit < 10) {
            // Below this, ten times the value and a digit cannot overflow.
            if self.value < u64::MAX / 10 {
                self.value = self.value * 10 + u64::from(digit);
            } else {
                self.exact = false;
            }
            *at += 1;
        }
        self.count += *at - start;
        self
    }
}

/// Reads `[+-] digits` after the `e`. What overflows is as good as 10^12: the value is 0 or infinite.
fn scan_exponent(tail: &[u8], at: &mut usize) -> Result<i64, NotANumber> {
    let negative = tail.get(*at) == Some(&b'-');
    *at += usize::from(matches!(tail.get(*at), Some(b'-' | b'+')));
    let digits = Digits::default().read(tail, at);
    if digits.count == 0 {
        return Err(NotANumber::Malformed);
    }
    let magnitude = if digits.exact { digits.value.min(1_000_000_000_000) as i64 } else { 1_000_000_000_000 };
    Ok(if negative { -magnitude } else { magnitude })
}

/// The magnitude of a well-formed number by the standard library.
#[cold]
fn round_slowly(number: &[u8]) -> Result<f64, NotANumber> {
    let value: f64 = str::from_utf8(number).ok().and_then(|text| text.parse().ok()).ok_or(NotANumber::Malformed)?;
    if value.is_infinite() { Err(NotANumber::TooLarge) } else { Ok(value.abs()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shapes_of_numbers() {
        for good in
            ["1.", "+.5", "-0", "-0.93e-2", "007", "1E+3", "4.44089e-16", "9007199254740993", "1e22", "1e-22", ".0"]
        {
            let number = number(good.as_bytes()).expect(good);
            assert_eq!(number.value.to_bits(), good.parse::<f64>().expect(good).to_bits(), "{good}");
            assert_eq!(number.length, good.len());
        }
        for bad in ["", ".", "-", "1d5", "0x1F", "nan", "inf", "1e", "1e+", "1.2.3", "1,5", "--1", "1f", "1_0"] {
            assert_eq!(number(bad.as_bytes()), Err(NotANumber::Malformed), "{bad}");
        }
        for large in ["1e999", "-1e309", "1e99999999999999999999", "2e308"] {
            assert_eq!(number(large.as_bytes()), Err(NotANumber::TooLarge), "{large}");
        }
    }

    #[test]
    fn small_numbers_vanish_and_say_so() {
        for (text, vanished) in
            [("1e-400", true), ("-1e-400", true), ("0e-400", false), ("5e-324", false), ("0.0", false)]
        {
            assert_eq!(number(text.as_bytes()).expect(text).vanished, vanished, "{text}");
        }
        let many_zeros = format!("0.{}1", "0".repeat(400));
        assert!(number(many_zeros.as_bytes()).expect("a number").vanished);
    }

    #[test]
    fn what_was_meant_as_a_number() {
        for word in ["1d5", "-x", ".", "+", "NaN", "-INF", "infinity"] {
            assert!(looks_numeric(word.as_bytes()), "{word}");
        }
        for word in ["p", "pp", "info", "red", "from", "nano", ""] {
            assert!(!looks_numeric(word.as_bytes()), "{word}");
        }
    }
}
