//! Words: cuts the text of a screen file into words and numbers, and knows where each of them stands.
//!
//! text -WORDS-> classic, v2
//!
//! Why not `split_whitespace`: an error needs line and column. Columns are counted only when there is an error, so the
//! text is walked once. Cost: linear in the text, nothing is allocated.

use super::ScreenFileError;
use std::ops::RangeInclusive;

/// Whether the ends of lines mean something.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Layout {
    /// One record a line, `#` starts a comment.
    Records,
    /// Words in a row, wherever lines end; no comments.
    Free,
}

/// A word, and where it stands. At the end of a line or of the text the word is empty.
#[derive(Clone, Copy, Debug)]
pub(super) struct Word<'a> {
    pub text: &'a str,
    line: usize,
    line_start: usize,
    start: usize,
}

/// Reads words from the front of a text to its end.
#[derive(Clone)]
pub(super) struct Words<'a> {
    text: &'a str,
    layout: Layout,
    at: usize,
    line: usize,
    line_start: usize,
}

impl Word<'_> {
    /// The line it stands on, from 1.
    pub fn line(&self) -> usize {
        self.line
    }
}

impl<'a> Words<'a> {
    pub fn new(text: &'a str, layout: Layout) -> Words<'a> {
        // Some editors on Windows begin a text with a byte order mark.
        let at = if text.starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 };
        Words { text, layout, at, line: 1, line_start: at }
    }

    /// How many bytes are still to be read: what a declared count is held against before memory is asked for.
    pub fn bytes_left(&self) -> u64 {
        (self.text.len() - self.at) as u64
    }

    /// The next word; empty at the end of the line (`Records`) or of the text.
    pub fn word(&mut self) -> Word<'a> {
        self.skip_blanks();
        let start = self.at;
        let rest = &self.text.as_bytes()[start..];
        let ends = |byte: &u8| byte.is_ascii_whitespace() || (self.layout == Layout::Records && *byte == b'#');
        let length = rest.iter().position(ends).unwrap_or(rest.len());
        self.at += length;
        Word { text: &self.text[start..self.at], line: self.line, line_start: self.line_start, start }
    }

    /// The word that [`Words::word`] would read next.
    pub fn peek(&self) -> Word<'a> {
        self.clone().word()
    }

    fn skip_blanks(&mut self) {
        while let Some(&byte) = self.text.as_bytes().get(self.at) {
            match byte {
                b'\n' if self.layout == Layout::Records => return,
                b'\n' => self.start_line(),
                _ if byte.is_ascii_whitespace() => self.at += 1,
                _ => return,
            }
        }
    }

    /// Steps over a line break.
    fn start_line(&mut self) {
        self.at += 1;
        self.line += 1;
        self.line_start = self.at;
    }

    /// Goes to the next line that is not empty and reads its first word, which must be `keyword`.
    pub fn record(&mut self, keyword: &str) -> Result<(), ScreenFileError> {
        let word = self.first_word();
        if word.text == keyword {
            return Ok(());
        }
        let error = self.error(word, format!("`{keyword}`"));
        let help = if word.text.is_empty() {
            "the file ends too early: was it copied whole?"
        } else {
            "every record has its place; `docs/screen-files.md` lists them in order"
        };
        Err(error.with_help(help))
    }

    /// The first word from here on, over ends of lines and comments; empty at the end of the text.
    pub fn first_word(&mut self) -> Word<'a> {
        loop {
            let word = self.word();
            if !word.text.is_empty() || self.at == self.text.len() {
                return word;
            }
            // At the end of a line, or at a comment that reaches there.
            let rest = &self.text.as_bytes()[self.at..];
            self.at += rest.iter().position(|&byte| byte == b'\n').unwrap_or(rest.len());
            if self.at < self.text.len() {
                self.start_line();
            }
        }
    }

    /// Nothing may be left on this line.
    pub fn end_of_record(&mut self) -> Result<(), ScreenFileError> {
        let word = self.word();
        if word.text.is_empty() { Ok(()) } else { Err(self.error(word, "the end of the line")) }
    }

    /// A finite number.
    pub fn number(&mut self, what: &str) -> Result<f64, ScreenFileError> {
        let word = self.word();
        self.number_of(word, word.text.parse().ok(), f64::is_finite, what)
    }

    /// A finite number in single precision.
    pub fn single(&mut self, what: &str) -> Result<f32, ScreenFileError> {
        let word = self.word();
        self.number_of(word, word.text.parse().ok(), f32::is_finite, what)
    }

    fn number_of<T>(
        &self,
        word: Word<'a>,
        parsed: Option<T>,
        is_finite: fn(T) -> bool,
        what: &str,
    ) -> Result<T, ScreenFileError>
    where
        T: Copy,
    {
        parsed.filter(|&number| is_finite(number)).ok_or_else(|| {
            let error = self.error(word, format!("{what}, a finite number"));
            if parsed.is_some() {
                error.with_help("`nan`, `inf` and numbers too large for the format are not drawn")
            } else {
                error
            }
        })
    }

    /// A whole number within `range`.
    pub fn whole(&mut self, what: &str, range: RangeInclusive<u64>) -> Result<u64, ScreenFileError> {
        let word = self.word();
        self.whole_of(word, what, range)
    }

    /// `word` as a whole number within `range`.
    pub fn whole_of(&self, word: Word<'a>, what: &str, range: RangeInclusive<u64>) -> Result<u64, ScreenFileError> {
        // Digits only: Rust would also take a `+`.
        let is_digits = word.text.bytes().all(|byte| byte.is_ascii_digit());
        let number = word.text.parse().ok().filter(|number| is_digits && range.contains(number));
        number.ok_or_else(|| {
            let (low, high) = (range.start(), range.end());
            if low == high {
                return self.error(word, format!("{what}, {low}"));
            }
            self.error(word, format!("{what}, a whole number from {low} to {high}"))
        })
    }

    /// A count of things that take at least `bytes_each` bytes.
    pub fn count(&mut self, what: &str, bytes_each: u64) -> Result<usize, ScreenFileError> {
        let word = self.word();
        self.count_of(word, what, (0, bytes_each))
    }

    /// `word` as a count of at least `least` things of at least `bytes_each` bytes: refused when so many cannot follow,
    /// before memory is asked for.
    pub fn count_of(
        &self,
        word: Word<'a>,
        what: &str,
        (least, bytes_each): (u64, u64),
    ) -> Result<usize, ScreenFileError> {
        let count = self.whole_of(word, what, least..=MOST)?;
        let (bytes, room) = (self.bytes_left(), self.bytes_left() / bytes_each);
        if count <= room {
            return Ok(count as usize);
        }
        let error = self.error(word, format!("{what}, at most {room} in a file of this length"));
        Err(error.with_help(format!("only {bytes} bytes follow, too few for so many; was the file copied whole?")))
    }

    /// One of the named values of `table`.
    pub fn choice<T: Copy>(&mut self, what: &str, table: &[(T, &str)]) -> Result<T, ScreenFileError> {
        let word = self.word();
        let found = table.iter().find(|(_, name)| *name == word.text);
        found.map(|(value, _)| *value).ok_or_else(|| {
            let names: Vec<_> = table.iter().map(|(_, name)| format!("`{name}`")).collect();
            self.error(word, format!("{what}, {}", names.join(" or ")))
        })
    }

    /// An error at `word`.
    pub fn error(&self, word: Word<'_>, expected: impl Into<String>) -> ScreenFileError {
        let column = self.text[word.line_start..word.start].chars().count() + 1;
        let span = word.start..word.start + word.text.len();
        let at_end = word.start == self.text.len();
        let found = match word.text {
            "" if at_end => "the end of the file".to_string(),
            "" => "the end of the line".to_string(),
            text => quoted(text),
        };
        ScreenFileError { line: word.line, column, span, expected: expected.into(), found, help: None }
    }
}

/// Counts above this are refused, so that every index of a list fits its 32 bits (seven planes a polygon).
const MOST: u64 = (u32::MAX / 8) as u64;

impl ScreenFileError {
    pub(super) fn with_help(self, help: impl Into<String>) -> Self {
        ScreenFileError { help: Some(help.into()), ..self }
    }
}

/// A word of the file for a message: short, and without what a terminal would obey.
fn quoted(word: &str) -> String {
    const LONGEST: usize = 32;
    let mut shown: String = word.chars().take(LONGEST).flat_map(char::escape_debug).collect();
    if word.chars().nth(LONGEST).is_some() {
        shown.push_str("...");
    }
    format!("`{shown}`")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_know_line_and_column() {
        let text = "\u{feff}one two # note\r\n\n  ação x";
        let mut words = Words::new(text, Layout::Records);
        assert_eq!([words.word().text, words.word().text, words.word().text], ["one", "two", ""]);
        assert_eq!(words.first_word().text, "ação");
        let error = words.number("a width").expect_err("x is no number");
        assert_eq!(error.to_string(), "line 3, column 8: expected a width, a finite number, found `x`");
        assert_eq!(&text[error.span], "x");
        let error = words.number("a width").expect_err("nothing left");
        assert_eq!(error.to_string(), "line 3, column 9: expected a width, a finite number, found the end of the file");
    }

    #[test]
    fn free_words_run_over_lines() {
        let mut words = Words::new("1\n\n2 3", Layout::Free);
        assert_eq!([(); 4].map(|()| words.word().text), ["1", "2", "3", ""]);
    }

    #[test]
    fn long_words_are_shown_short_and_harmless() {
        assert_eq!(quoted("\u{1b}[2J"), "`\\u{1b}[2J`");
        assert_eq!(quoted(&"x".repeat(1 << 20)).len(), 32 + 3 + 2);
    }
}
