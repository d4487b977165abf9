//! Words of a text of statements (`.fcell`, `.fmap`), and what is wrong where one is expected and another stands.
//!
//! Source -WORDS-> words, numbers -> statements
//!
//! A word that is the first on its line and one of the keywords begins a statement, so a mistake in one statement does not eat the next:
//! `cover` at the start of a line declares a cover, behind a `stand` it is a field. Words in `"..."` may have blanks.

use crate::diagnostic::{Diagnostic, Source, Span, suggest};
use crate::parse::tokens::{self, NotANumber};
use crate::parse::wording::{number_meant, plain, quote};
use std::fmt::Display;
use std::ops::RangeInclusive;
use std::str::FromStr;

/// The keywords of a language, and how the statement of each is written.
#[derive(Debug)]
pub(super) struct Vocabulary(pub &'static [(&'static str, &'static str)]);

impl Vocabulary {
    /// Whether `word` begins a statement where it is the first on its line.
    pub fn is_keyword(&self, word: &[u8]) -> bool {
        self.0.iter().any(|(keyword, _)| keyword.as_bytes() == word)
    }

    /// The keywords.
    pub fn keywords(&self) -> impl Iterator<Item = &'static str> {
        self.0.iter().map(|&(keyword, _)| keyword)
    }

    /// How a statement is written, as a line of help.
    pub fn shape(&self, keyword: &str) -> String {
        let known = self.0.iter().find(|(name, _)| *name == keyword);
        known.map_or_else(String::new, |(_, shape)| format!("write `{shape}`"))
    }
}

/// A word and where it stands.
#[derive(Clone, Copy, Debug)]
pub(super) struct Word<'a> {
    /// Without the quotes; empty at the end of the text, and for `""`.
    pub bytes: &'a [u8],
    pub span: Span,
    /// Nothing stands before it on its line.
    pub is_first: bool,
    /// It stood in quotes.
    pub is_quoted: bool,
    /// It is one of the language's keywords.
    is_keyword: bool,
}

impl Word<'_> {
    /// The text is over.
    pub fn is_end(&self) -> bool {
        self.bytes.is_empty() && !self.is_quoted
    }

    /// It begins a statement.
    pub fn begins_statement(&self) -> bool {
        self.is_end() || self.is_first && !self.is_quoted && self.is_keyword
    }

    pub fn is(&self, word: &str) -> bool {
        self.bytes == word.as_bytes() && !self.is_quoted
    }

    /// It was meant as a number.
    pub fn is_numeric(&self) -> bool {
        !self.is_quoted && tokens::looks_numeric(self.bytes)
    }
}

/// Goes through the words of a text.
#[derive(Clone, Debug)]
pub(super) struct Words<'a> {
    pub source: &'a Source,
    pub vocabulary: &'static Vocabulary,
    at: usize,
    /// The keyword of the statement in hand.
    pub keyword: Span,
}

impl<'a> Words<'a> {
    pub fn new(source: &'a Source, vocabulary: &'static Vocabulary) -> Words<'a> {
        Words { source, vocabulary, at: 0, keyword: Span::default() }
    }

    /// The next word, which stays the next one.
    pub fn peek(&self) -> Word<'a> {
        let text = &self.source.text;
        let start = text.len() - tokens::skip_space(&text[self.at..]).len();
        if start == text.len() {
            let end = text.trim_ascii_end().len();
            let span = Span::new(end, end);
            return Word { bytes: b"", span, is_first: true, is_quoted: false, is_keyword: false };
        }
        let line_start = text[self.at..start].contains(&b'\n') || self.at == 0;
        let is_first = line_start || text[..start].last() == Some(&b'\n');
        let tail = &text[start..];
        if tail[0] == b'"' {
            let line = tail[1..].iter().position(|&byte| byte == b'"' || byte == b'\n').unwrap_or(tail.len() - 1);
            let is_closed = tail.get(1 + line) == Some(&b'"');
            let end = start + 1 + line + usize::from(is_closed);
            let bytes = if is_closed { &tail[1..=line] } else { tokens::word(tail) };
            let span = Span::new(start, end);
            return Word { bytes, span, is_first, is_quoted: is_closed, is_keyword: self.vocabulary.is_keyword(bytes) };
        }
        let bytes = tokens::word(tail);
        let (span, is_keyword) = (Span::new(start, start + bytes.len()), self.vocabulary.is_keyword(bytes));
        Word { bytes, span, is_first, is_quoted: false, is_keyword }
    }

    pub fn take(&mut self) -> Word<'a> {
        let word = self.peek();
        self.at = word.span.end as usize;
        word
    }

    /// Takes the next word if it is `field` of the statement in hand.
    pub fn take_field(&mut self, field: &str) -> bool {
        let word = self.peek();
        let is_field = word.is(field) && !word.begins_statement();
        if is_field {
            self.take();
        }
        is_field
    }

    /// Goes on to where the next statement begins.
    pub fn skip_statement(&mut self) {
        while !self.peek().begins_statement() {
            self.take();
        }
    }

    /// The bytes of the keyword of the statement in hand.
    pub fn keyword_text(&self) -> &'a [u8] {
        &self.source.text[self.keyword.start as usize..self.keyword.end as usize]
    }

    /// A word of this statement; `what` says which one is expected.
    pub fn word(&mut self, what: &str) -> Result<Word<'a>, Diagnostic> {
        let word = self.peek();
        if word.begins_statement() {
            return Err(self.ends_early(word, what));
        }
        if word.bytes.first() == Some(&b'"') && !word.is_quoted {
            return Err(Diagnostic::error("a quote is not closed on its line")
                .at(word.span, "opened here")
                .help("close it with `\"`; a name has no `#` in it, for that begins a comment"));
        }
        Ok(self.take())
    }

    /// A word of this statement as text.
    pub fn text(&mut self, what: &str) -> Result<(String, Span), Diagnostic> {
        let word = self.word(what)?;
        match str::from_utf8(word.bytes) {
            Ok("") => Err(Diagnostic::error(format!("{what} is empty")).at(word.span, "nothing in here")),
            Ok(text) => Ok((text.to_string(), word.span)),
            Err(_) => {
                let error = Diagnostic::error(format!("{} is not UTF-8 text", quote(word.bytes)));
                Err(error.at(word.span, format!("expected {what}")).help("save the file as UTF-8"))
            }
        }
    }

    /// The statement ends where `what` is expected.
    pub fn ends_early(&self, word: Word<'_>, what: &str) -> Diagnostic {
        let message = if word.is_end() {
            format!("the text ends within a `{}`", plain(self.keyword_text()))
        } else {
            format!("`{}` ends too early", plain(self.keyword_text()))
        };
        Diagnostic::error(message).at(word.span, format!("expected {what}")).at(self.keyword, "of this")
    }

    /// A finite number.
    pub fn number(&mut self, what: &str) -> Result<f64, Diagnostic> {
        let word = self.word(what)?;
        let error = match tokens::number(word.bytes) {
            Ok(number) if !word.is_quoted => return Ok(number.value),
            Err(NotANumber::TooLarge) => {
                let error = Diagnostic::error(format!("number too large: {}", quote(word.bytes)));
                return Err(error
                    .at(word.span, "beyond the range of numbers")
                    .help("the largest number is about 1.8e308"));
            }
            _ => Diagnostic::error(format!("{} is not a number", quote(word.bytes))),
        };
        Err(match number_meant(word.bytes) {
            Some(meant) => error.at(word.span, format!("expected {what}")).help(meant),
            None => error.at(word.span, format!("expected {what}")),
        })
    }

    /// A number in `range`.
    pub fn within(&mut self, what: &str, range: RangeInclusive<f64>) -> Result<f64, Diagnostic> {
        let span = self.peek().span;
        let number = self.number(what)?;
        if range.contains(&number) {
            return Ok(number);
        }
        Err(out_of_range(number, what, &range, span))
    }

    /// A whole number in `range`.
    pub fn whole<T: FromStr + PartialOrd + Display>(
        &mut self,
        what: &str,
        range: RangeInclusive<T>,
    ) -> Result<T, Diagnostic> {
        let word = self.word(what)?;
        let digits = word.bytes.strip_prefix(b"-").or(word.bytes.strip_prefix(b"+")).unwrap_or(word.bytes);
        let is_whole = !digits.is_empty() && digits.iter().all(u8::is_ascii_digit) && !word.is_quoted;
        if !is_whole {
            let error = Diagnostic::error(format!("{} is not a whole number", quote(word.bytes)));
            let error = error.at(word.span, format!("expected {what}, a whole number"));
            let is_odd = tokens::number(word.bytes).is_err();
            let meant = number_meant(word.bytes).filter(|_| is_odd);
            return Err(meant.map_or(error.clone(), |meant| error.help(meant)));
        }
        let number = str::from_utf8(word.bytes).ok().and_then(|text| text.parse().ok());
        match number.filter(|number| range.contains(number)) {
            Some(number) => Ok(number),
            None => Err(out_of_range(plain(word.bytes), what, &range, word.span)),
        }
    }

    /// A word of a fixed list, by its name in the list.
    pub fn choice<T: Copy>(&mut self, what: &str, all: &[(&'static str, T)]) -> Result<T, Diagnostic> {
        let word = self.word(what)?;
        if let Some(&(_, value)) = all.iter().find(|(name, _)| word.is(name)) {
            return Ok(value);
        }
        let names: Vec<&str> = all.iter().map(|&(name, _)| name).collect();
        let error = Diagnostic::error(format!("{} is no {what}", quote(word.bytes))).at(word.span, "not known");
        Err(error.help(did_you_mean(word.bytes, &names)))
    }

    /// What to say of a word that belongs to no field of this statement.
    pub fn unexpected(&self, word: Word<'_>, fields: &[&'static str]) -> Diagnostic {
        let (keyword, quoted) = (plain(self.keyword_text()), quote(word.bytes));
        if word.is_first && !word.is_numeric() {
            let error = Diagnostic::error(format!("unknown keyword {quoted}")).at(word.span, "not understood");
            return error.help(did_you_mean(
                word.bytes,
                &fields.iter().copied().chain(self.vocabulary.keywords()).collect::<Vec<_>>(),
            ));
        }
        if word.is_numeric() {
            let error = Diagnostic::error(format!("`{keyword}` has a number too many: {quoted}"));
            let error = error.at(word.span, "what is this?").at(self.keyword, "of this");
            return error.help(self.vocabulary.shape(&keyword));
        }
        let error = Diagnostic::error(format!("`{keyword}` has no field {quoted}"));
        let error = error.at(word.span, "not understood").at(self.keyword, "in this");
        if fields.is_empty() {
            return error.help(self.vocabulary.shape(&keyword));
        }
        error.help(did_you_mean(word.bytes, fields))
    }
}

/// A number that is not in its range.
fn out_of_range<T: Display>(found: impl Display, what: &str, range: &RangeInclusive<T>, span: Span) -> Diagnostic {
    let error = Diagnostic::error(format!("{what} cannot be {found}"));
    error.at(span, format!("expected {} to {}", range.start(), range.end()))
}

/// The known word that was probably meant, or all of them.
pub(super) fn did_you_mean(word: &[u8], known: &[&str]) -> String {
    // Codes of species are in capitals, and a mistake in one is no mistake in every letter.
    let small: Vec<String> = known.iter().map(|known| known.to_lowercase()).collect();
    let small: Vec<&str> = small.iter().map(String::as_str).collect();
    let similar =
        suggest(&String::from_utf8_lossy(word), &small).and_then(|similar| small.iter().position(|&s| s == similar));
    match (similar.map(|index| known[index]), known) {
        (Some(similar), _) => format!("did you mean `{similar}`?"),
        (None, [only]) => format!("there is only `{only}`"),
        (None, _) => format!("known are {}", known.join(", ")),
    }
}
