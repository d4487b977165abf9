//! Numbers of ordinary files, eight bytes at a time.
//!
//! Why: `-0.992188` is a loop of eight rounds and branches that a processor guesses wrong half of the time. Eight bytes in one word are
//! looked at together: which of them are digits takes four operations, what they are worth three multiplications. Where the number ends is
//! found first and without a branch, so that the next number can be begun before this one is known.
//!
//! Only what is certain to be exact is read here: `[+-] digits [. digits]`, up to 7 digits before the point and 7 behind it, white space
//! behind all. Everything else, mistakes too, is left to the reader that goes byte by byte.
//! Source: the idea of digits in words is told in D. Lemire, "Number Parsing at a Gigabyte per Second", Software: Practice and
//! Experience 51(8), 2021. Byte i of the text is byte i of the word, the lowest first.

use super::{Number, POWERS_OF_TEN, is_space};

/// The same byte eight times.
const fn everywhere(byte: u8) -> u64 {
    u64::from_le_bytes([byte; 8])
}

/// Bytes that a number and the white space behind it may take, and room to read eight bytes from the last of them on.
const ROOM: usize = 24;

/// The number a tail starts with, if it is one of those.
#[inline(always)]
pub(super) fn number(tail: &[u8]) -> Option<Number> {
    let bytes: &[u8; ROOM] = tail.get(..ROOM)?.try_into().ok()?;
    let length = first_space(bytes);
    let start = usize::from(bytes[0] == b'-' || bytes[0] == b'+');
    let (whole, count) = digits(bytes, start);
    let point = start + count;
    let behind = usize::from(bytes[point] == b'.');
    let (fraction, decimals) = digits(bytes, point + behind);
    // A number without a point reads the white space behind it once more, which has no digits.
    let end = point + behind + decimals;
    if end != length || count == 8 || decimals == 8 || count + decimals == 0 || !is_space(bytes[end]) {
        return None;
    }
    let magnitude = (whole * TENS[decimals] + fraction) as f64 / POWERS_OF_TEN[decimals];
    let sign = u64::from(bytes[0] == b'-') << 63;
    Some(Number { value: f64::from_bits(magnitude.to_bits() | sign), length, vanished: false })
}

/// Powers of ten of up to eight digits.
const TENS: [u64; 9] = [1, 10, 100, 1000, 10_000, 100_000, 1_000_000, 10_000_000, 100_000_000];

/// The place of the first byte of sixteen that is no more than `b' '`; 16 if there is none.
#[inline(always)]
fn first_space(bytes: &[u8; ROOM]) -> usize {
    // Above the lowest hit, bits may be wrong: nobody looks at them.
    let hits = |at: usize| {
        let word = eight(bytes, at);
        word.wrapping_sub(everywhere(b' ' + 1)) & !word & everywhere(0x80)
    };
    let (low, high) = (hits(0), hits(8));
    let bits = if low != 0 { low.trailing_zeros() } else { 64 + high.trailing_zeros() };
    bits as usize / 8
}

/// What the digits from `at` on are worth, and how many there are, up to eight; `at` is at most 16.
#[inline(always)]
fn digits(bytes: &[u8; ROOM], at: usize) -> (u64, usize) {
    // Digits become 0 to 9. What is more gets its highest bit set; a carry can only spoil bytes behind the first such.
    let values = eight(bytes, at.min(ROOM - 8)) ^ everywhere(b'0');
    let others = (values.wrapping_add(everywhere(0x76)) | values) & everywhere(0x80);
    let count = others.trailing_zeros() as usize / 8;
    // Zeros in front of them and nothing behind: the last digit in the highest byte. In two steps, for none may be left.
    let aligned = (values << (56 - 8 * count.min(7))) << 8;
    let aligned = if count == 8 { values } else { aligned };
    (worth(aligned), count)
}

#[inline(always)]
fn eight(bytes: &[u8; ROOM], at: usize) -> u64 {
    let mut word = [0; 8];
    word.copy_from_slice(&bytes[at..at + 8]);
    u64::from_le_bytes(word)
}

/// The number of eight digits, one a byte, the first in the lowest.
#[inline(always)]
fn worth(digits: u64) -> u64 {
    // Pairs in every second byte, then fours in every fourth, then all: each step adds the neighbor times a power of ten.
    let pairs = (digits.wrapping_mul(10).wrapping_add(digits >> 8)) & 0x00FF_00FF_00FF_00FF;
    let fours = (pairs.wrapping_mul(100).wrapping_add(pairs >> 16)) & 0x0000_FFFF_0000_FFFF;
    (fours.wrapping_mul(10_000).wrapping_add(fours >> 32)) & 0xFFFF_FFFF
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse::tokens::any_number;

    /// Texts of every shape, by chance but always the same, ends and mistakes among them.
    fn text(number: u64) -> String {
        let mut state = number.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
        let mut below = |most: u64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) % most
        };
        let mut text = ["", "-", "+", "--"][[0, 1, 1, 0, 2, 0, 0, 0, 3][below(9) as usize]].to_string();
        for _ in 0..[0, 1, 1, 2, 3, 7, 8, 9, 17][below(9) as usize] {
            text.push(char::from(b'0' + below(10) as u8));
        }
        if below(4) > 0 {
            text.push('.');
            for _ in 0..[0, 1, 2, 5, 6, 6, 7, 8, 9, 15, 16, 20][below(12) as usize] {
                text.push(char::from(b'0' + below(10) as u8));
            }
        }
        text += ["", "", "", "", "", "e5", "E-3", "x", ":", "/", "\u{e9}", ".", "-"][below(13) as usize];
        text + [
            "",
            " ",
            "\n",
            "\t1",
            " 123456789012345678901234567890 ",
            "\r\n-0.5 1 2 3 4 5 6 7 8 9 10 11 12",
            "                            ",
        ][below(7) as usize]
    }

    #[test]
    fn eight_at_a_time_are_as_one_by_one() {
        let mut read = 0;
        for number in 0..2_000_000 {
            let text = text(number);
            let word = text.split_ascii_whitespace().next().unwrap_or_default();
            let standard = word.parse().map(f64::to_bits).ok();
            if let Some(quick) = super::number(text.as_bytes()) {
                read += 1;
                assert_eq!(Some(quick.value.to_bits()), standard, "{text:?}");
                assert_eq!(any_number(text.as_bytes()), Ok(quick), "{text:?}");
            } else if let Ok(slow) = any_number(text.as_bytes()) {
                assert_eq!(Some(slow.value.to_bits()), standard.filter(|_| !word.is_empty()), "{text:?}");
            }
        }
        assert!(read > 100_000, "{read} of 2,000,000 were read eight at a time");
    }

    #[test]
    fn digits_are_worth_what_they_say() {
        assert_eq!(worth(u64::from_le_bytes([1, 2, 3, 4, 5, 6, 7, 8])), 12_345_678);
        assert_eq!(worth(u64::from_le_bytes([0, 0, 0, 0, 9, 9, 9, 9])), 9_999);
        let value =
            |text: &str| super::number(format!("{text:024}").as_bytes()).map(|number| (number.value, number.length));
        assert_eq!(value("-12.5 "), Some((-12.5, 5)));
        assert_eq!(value("1234567.1234567\n"), Some((1_234_567.123_456_7, 15)));
        assert_eq!(value("0 "), Some((0.0, 1)));
        for text in ["12345678 ", "1.12345678 ", ". ", "1:5 ", "1\u{e9} ", "1e5 ", "1\u{1} "] {
            assert_eq!(value(text), None, "{text:?}");
        }
    }
}
