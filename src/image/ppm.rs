//! PPM: the picture file that a student can write with a `printf`. P6 (binary) is written; P6 and P3 (text) are read.
//!
//! A header `P6 width height 255`, one white space character, then 3 bytes a pixel, rows from the top. In a P3 the
//! pixels are decimal numbers. `#` begins a comment that lasts to the end of the line.
//!
//! Source: J. Poskanzer, Netpbm, `ppm(5)`, 1989. One picture a file, largest value 255.
//! Cost: one pass; the size in the header is believed only as far as there are bytes behind it.

use super::file::checked_size;
use super::{ImageError, Picture};

/// Longest comment-free word that can be a number of this format.
const MAX_DIGITS: usize = 10;

pub(super) fn encode(picture: &Picture) -> Result<Vec<u8>, ImageError> {
    let mut bytes = format!("P6\n{} {}\n255\n", picture.width(), picture.height()).into_bytes();
    bytes.extend_from_slice(picture.rgb());
    Ok(bytes)
}

pub(super) fn decode(bytes: &[u8]) -> Result<Picture, ImageError> {
    let mut scanner = Scanner { bytes, at: 2 };

    // Read the header.
    let width = scanner.side("the width")?;
    let height = scanner.side("the height")?;
    let (width, height) = checked_size(width, height)?;
    let (maximum_at, maximum) = scanner.number("the largest value")?;
    if maximum != 255 {
        return Err(broken(maximum_at, format!("the largest value is {maximum}, but only 255 is read")));
    }

    // Read the pixels.
    let samples = width * height * 3;
    let rgb = if bytes[1] == b'6' { scanner.binary(samples)? } else { scanner.text(samples)? };
    Picture::from_rgb(width, height, rgb)
}

fn broken(offset: usize, what: impl Into<String>) -> ImageError {
    ImageError::Ppm { offset, what: what.into() }
}

/// A position in the file that moves over white space, comments and numbers.
struct Scanner<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl Scanner<'_> {
    fn rest(&self) -> &[u8] {
        &self.bytes[self.at..]
    }

    fn skip_space_and_comments(&mut self) {
        while let Some(&byte) = self.rest().first() {
            match byte {
                b'#' => self.at += self.rest().iter().take_while(|&&byte| byte != b'\n' && byte != b'\r').count(),
                _ if is_space(byte) => self.at += 1,
                _ => return,
            }
        }
    }

    /// The next number and the byte where it begins; `what` is its name in messages.
    fn number(&mut self, what: &str) -> Result<(usize, u64), ImageError> {
        let before = self.at;
        self.skip_space_and_comments();
        let start = self.at;
        let length = self.rest().iter().take_while(|&&byte| !is_space(byte) && byte != b'#').count();
        let word = &self.rest()[..length];
        if word.is_empty() {
            return Err(broken(start, format!("the file ends where {what} was expected")));
        }
        if start == before {
            return Err(broken(start, format!("expected a space before {what}, found {}", quoted(word))));
        }
        let number = std::str::from_utf8(word).ok().filter(|_| length <= MAX_DIGITS);
        let number = number.filter(|word| word.bytes().all(|byte| byte.is_ascii_digit()));
        let Some(number) = number.and_then(|word| word.parse().ok()) else {
            return Err(broken(start, format!("expected {what}, a number, found {}", quoted(word))));
        };
        self.at += length;
        Ok((start, number))
    }

    fn side(&mut self, what: &str) -> Result<u64, ImageError> {
        match self.number(what)? {
            (start, 0) => Err(broken(start, format!("{what} is 0: a picture has at least one pixel"))),
            (_, side) => Ok(side),
        }
    }

    /// The bytes of a P6: exactly one white space character, then the samples and nothing else.
    fn binary(mut self, samples: usize) -> Result<Vec<u8>, ImageError> {
        if !self.rest().first().copied().is_some_and(is_space) {
            return Err(broken(self.at, "expected one white space character before the pixels"));
        }
        self.at += 1;
        let there = self.rest().len();
        if there < samples {
            let what = format!("the pixels need {samples} bytes, but only {there} follow");
            return Err(broken(self.at, what));
        }
        if there > samples {
            let what = format!("{} more bytes follow after the last pixel", there - samples);
            return Err(broken(self.at + samples, what));
        }
        Ok(self.rest().to_vec())
    }

    /// The numbers of a P3.
    fn text(mut self, samples: usize) -> Result<Vec<u8>, ImageError> {
        // Every sample is at least a space and a digit: a size without bytes behind it asks for no memory.
        let there = self.rest().len();
        if there / 2 < samples {
            let what =
                format!("the pixels need {samples} numbers, which do not fit into the {there} bytes that follow");
            return Err(broken(self.at, what));
        }
        let mut rgb = Vec::with_capacity(samples);
        for index in 0..samples {
            let (start, number) = self.number("a color value")?;
            let Ok(level) = u8::try_from(number) else {
                let what = format!("color value {} of {samples} is {number}: at most 255 is allowed", index + 1);
                return Err(broken(start, what));
            };
            rgb.push(level);
        }
        self.skip_space_and_comments();
        match self.rest() {
            [] => Ok(rgb),
            _ => Err(broken(self.at, "something follows after the last pixel")),
        }
    }
}

fn is_space(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\n' | b'\r' | 0x0B | 0x0C)
}

/// At most 16 bytes of a word, safe to print.
fn quoted(word: &[u8]) -> String {
    let shown = word[..word.len().min(16)].escape_ascii();
    format!("`{shown}{}`", if word.len() > 16 { "..." } else { "" })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn error(bytes: &[u8]) -> String {
        decode(bytes).expect_err("broken").to_string()
    }

    #[test]
    fn p6_is_written_as_the_format_says() {
        let picture = Picture::from_rgb(2, 1, vec![0, 10, 32, 255, 1, 2]).expect("two pixels");
        let bytes = encode(&picture).expect("encodes");
        assert_eq!(bytes, b"P6\n2 1\n255\n\x00\x0A\x20\xFF\x01\x02");
        assert_eq!(decode(&bytes).expect("decodes"), picture);
    }

    #[test]
    fn p3_and_comments_are_read() {
        let text = b"P3 # text\n# two pixels\r\n 2\t1#w h\n255\n1 2 3\n# between\n4 5 006 # end";
        assert_eq!(decode(text).expect("decodes").rgb(), [1, 2, 3, 4, 5, 6]);
        assert_eq!(decode(b"P3 1 1 255 1 # old line end\r2 3").expect("decodes").rgb(), [1, 2, 3]);
        // A pixel may look like a space or a comment: only one character separates it from the header.
        assert_eq!(decode(b"P6#c\n1 1 255\n# \n").expect("decodes").rgb(), *b"# \n");
    }

    #[test]
    fn errors_say_what_and_where() {
        let expected = [
            ("P6", "at byte 2: the file ends where the width was expected"),
            ("P612 1 255 ", "at byte 2: expected a space before the width, found `12`"),
            ("P6 x 1 255 ", "at byte 3: expected the width, a number, found `x`"),
            ("P6 -1 1 255 ", "at byte 3: expected the width, a number, found `-1`"),
            ("P6 1 0 255 ", "at byte 5: the height is 0: a picture has at least one pixel"),
            ("P6 1 1 65535 ", "at byte 7: the largest value is 65535, but only 255 is read"),
            ("P6 1 1 255", "at byte 10: expected one white space character before the pixels"),
            ("P6 1 2 255 abcde", "at byte 11: the pixels need 6 bytes, but only 5 follow"),
            ("P6 1 1 255 abcde", "at byte 14: 2 more bytes follow after the last pixel"),
            ("P3 1 1 255 1 2", "at byte 10: the pixels need 3 numbers, which do not fit into the 4 bytes that follow"),
            ("P3 1 1 255 11 22  ", "at byte 18: the file ends where a color value was expected"),
            ("P3 1 1 255 1 256 3", "at byte 13: color value 2 of 3 is 256: at most 255 is allowed"),
            ("P3 1 1 255 1 2 3 4", "at byte 17: something follows after the last pixel"),
        ];
        for (text, message) in expected {
            assert_eq!(error(text.as_bytes()), format!("broken PPM {message}"), "{text}");
        }
        assert!(error(b"P6 99999999999999999999 1 255 ").contains("byte 3"));
    }

    #[test]
    fn a_claimed_size_is_checked_before_memory_is_asked_for() {
        assert!(error(b"P6 4000000000 4000000000 255 ").contains("too large"));
        assert!(error(b"P3 16384 16384 255 1 2 3").contains("do not fit"));
    }

    proptest! {
        #[test]
        fn mangled_files_never_panic(mut tail in proptest::collection::vec(any::<u8>(), 0..60), text in "P[36][ 0-9#\n]{0,30}") {
            let mut bytes = text.into_bytes();
            bytes.append(&mut tail);
            let _ = decode(&bytes);
        }
    }
}
