//! Says what is wrong with a statement, in words that tell what to write instead.
//!
//! Runs only on mistakes, so it may look at the text again: count words, find the n-th, guess what was meant.

use super::grammar::{Corners, KEYWORDS, Mismatch, VIEW_FIELDS, Wanted};
use super::is_keyword;
use super::nonsense::Nonsense;
use super::wording::{fields_in_order, name, shape};
use crate::diagnostic::{Diagnostic, Source, Span, printable, suggest};
use crate::parse::foreign;
use crate::parse::tokens::{self, NotANumber};
use crate::parse::wording::{list, number_meant, plain, quote};

/// The text that mistakes are in.
#[derive(Clone, Copy)]
pub(super) struct Explain<'a> {
    pub(super) text: &'a [u8],
    pub(super) source: &'a Source,
}

/// An error, or (`Err`) one that shows that the file is not text at all.
type Verdict = Result<Diagnostic, Diagnostic>;

impl<'a> Explain<'a> {
    /// Where the first word of a tail is; where the text ends, the place behind its last word.
    pub(super) fn span_of_word(&self, tail: &[u8]) -> Span {
        if tail.is_empty() {
            let end = self.text.trim_ascii_end().len();
            return Span::new(end, end);
        }
        let start = self.text.len() - tail.len();
        Span::new(start, start + tokens::word(tail).len())
    }

    /// Only comments, or nothing at all.
    pub(super) fn empty_file(&self) -> Diagnostic {
        Diagnostic::error(format!("no view: `{}` says nothing", printable(self.source.name.as_bytes())))
            .help("a scene starts with `v` and its fields, then lights (`l`), a surface (`f`), and objects")
    }

    /// Another format, told by its first word, or no text at all.
    pub(super) fn not_nff(&self, tail: &[u8]) -> Option<Diagnostic> {
        let word = tokens::word(tail);
        // Pictures and archives have a 0 early on; without this they would be twenty unknown keywords.
        let beginning = &self.text[..self.text.len().min(512)];
        if let Some(at) = beginning.iter().position(|&byte| byte == 0) {
            return self.check_text(&[0], Span::new(at, at + 1)).err();
        }
        let is_sense8 = word.eq_ignore_ascii_case(b"nff") || word.eq_ignore_ascii_case(b"nff2");
        is_sense8.then(|| {
            Diagnostic::error("this is an NFF of Sense8 WorldToolKit, not a Neutral File Format scene")
                .at(self.span_of_word(tail), "its header")
                .help("only the name is the same; export the scene as Eric Haines' NFF")
        })
    }

    /// A word where a statement should start; `follows_surface`: on the line of an `f`, behind its numbers.
    pub(super) fn unknown_keyword(&self, tail: &[u8], follows_surface: bool) -> Verdict {
        let (word, span) = (tokens::word(tail), self.span_of_word(tail));
        self.check_text(word, span)?;
        if tokens::looks_numeric(word) {
            let error =
                Diagnostic::error("a number where a statement should start").at(span, "no statement goes on here");
            return Ok(error.help(format!("statements start with one of {}", list(&KEYWORDS))));
        }
        let quoted = quote(word);
        if let Some((origin, help)) = foreign::keyword(word) {
            let error = Diagnostic::error(format!("{quoted} is not NFF: it belongs to {origin}"));
            return Ok(error.at(span, "not understood").help(help));
        }
        let error = Diagnostic::error(format!("unknown keyword {quoted}")).at(span, "not NFF");
        Ok(match foreign::meant(word) {
            _ if follows_surface => error.help("a texture behind the 8 numbers of an `f` is not NFF: remove it"),
            Some(keyword) => error.help(format!("did you mean `{keyword}`?")),
            None => error.help(format!("statements start with one of {}", list(&KEYWORDS))),
        })
    }

    /// A view or light behind an object.
    pub(super) fn too_late(&self, keyword: &[u8], span: Span, first_object: Span) -> Diagnostic {
        let what = if keyword == b"v" { "a view" } else { "a light" };
        Diagnostic::error(format!("{what} must come before all objects"))
            .at(span, "too late")
            .at(first_object, "the first object")
            .help(format!("move it above line {}", self.source.line(first_object.start)))
    }

    /// Well-formed words that make no sense.
    pub(super) fn nonsense(&self, statement: &[u8], nonsense: &Nonsense) -> Diagnostic {
        let (first, last) = (nonsense.words.start(), nonsense.words.end());
        let [first, last] = [first, last].map(|&index| self.span_of_word(tokens::nth_word(statement, index)));
        let on_one_line = self.source.line(first.start) == self.source.line(last.start);
        let span = if on_one_line { Span { start: first.start, end: last.end } } else { first };
        Diagnostic::error(nonsense.message.as_str()).at(span, "").help(nonsense.help)
    }

    /// Words that do not match the grammar.
    pub(super) fn mismatch(&self, statement: &[u8], mismatch: Mismatch, corners: &Corners) -> Verdict {
        let tail = &self.text[self.text.len() - mismatch.tail_length..];
        let (word, span) = (tokens::word(tail), self.span_of_word(tail));
        self.check_text(word, span)?;
        if word.is_empty() || is_keyword(word) {
            return Ok(self.too_few(statement, tail, (mismatch.wanted, corners)));
        }
        let keyword = tokens::word(statement);
        let error = match mismatch.wanted {
            Wanted::Field(field) => wrong_field(word, field, span),
            Wanted::WholeNumber if matches!(keyword, b"p" | b"pp") => bad_count(word, span, keyword),
            Wanted::WholeNumber => Diagnostic::error(format!("{} is not a whole number", quote(word)))
                .at(span, "expected a number of pixels")
                .help("write width and height in pixels: `resolution 512 512`"),
            Wanted::Number => self.bad_number(word, span, keyword),
        };
        let is_vertex = mismatch.wanted == Wanted::Number && matches!(keyword, b"p" | b"pp");
        let declaration = self.declaration(statement);
        Ok(if is_vertex { error.at(declaration, format!("in this {}", name(keyword))) } else { error })
    }

    fn bad_number(&self, word: &[u8], span: Span, keyword: &[u8]) -> Diagnostic {
        let quoted = quote(word);
        let expected = if matches!(keyword, b"p" | b"pp") {
            "expected a number, or a vertex is missing"
        } else {
            "expected a number"
        };
        if tokens::number(word) == Err(NotANumber::TooLarge) {
            let error =
                Diagnostic::error(format!("number too large: {quoted}")).at(span, "beyond the range of numbers");
            return error.help("the largest number is about 1.8e308");
        }
        if matches!(keyword, b"f" | b"b") && word.iter().all(u8::is_ascii_alphabetic) && !tokens::looks_numeric(word) {
            let error = Diagnostic::error(format!("{quoted} where a color has three numbers")).at(span, expected);
            return error.help(match foreign::color(word) {
                Some([r, g, b]) => format!("color names are not NFF: write `{r} {g} {b}`"),
                None => "color names are not NFF: write red, green and blue as numbers from 0 to 1".to_string(),
            });
        }
        let error = Diagnostic::error(format!("{quoted} is not a number")).at(span, expected);
        match number_meant(word) {
            Some(meant) => error.help(meant),
            None if tokens::looks_numeric(word) => error.help("numbers look like `12`, `-0.5` or `1.5e-3`"),
            None => error.help(format!("write {}", shape(keyword))),
        }
    }

    /// The keyword of a statement and, if it stands on the same line, the word behind it: `p 4`.
    pub(super) fn declaration(&self, statement: &[u8]) -> Span {
        let keyword = self.span_of_word(statement);
        let count = self.span_of_word(tokens::nth_word(statement, 1));
        let between = &self.text[keyword.end as usize..(count.start as usize).max(keyword.end as usize)];
        if between.contains(&b'\n') { keyword } else { Span { start: keyword.start, end: count.end } }
    }

    /// Scene files are ASCII outside comments.
    fn check_text(&self, word: &[u8], span: Span) -> Result<(), Diagnostic> {
        let Some(&byte) = word.iter().find(|byte| byte.is_ascii_control()) else { return Ok(()) };
        let error = Diagnostic::error("this is not a text file").at(span, format!("holds the byte 0x{byte:02X}"));
        Err(error.help("NFF scenes are plain text, or plain text packed by gzip"))
    }
}

/// Something else where a field of a view should be.
fn wrong_field(word: &[u8], expected: &str, span: Span) -> Diagnostic {
    let text = printable(word);
    let error = if VIEW_FIELDS.contains(&text.as_str()) {
        Diagnostic::error(format!("`{text}` where the view needs `{expected}`"))
    } else if tokens::looks_numeric(word) {
        Diagnostic::error(format!("a number too many before `{expected}`"))
    } else {
        Diagnostic::error(format!("a view has no field {}", quote(word)))
    };
    let error = error.at(span, format!("expected `{expected}`"));
    match suggest(&text, &VIEW_FIELDS) {
        Some(similar) if similar != text => error.help(format!("did you mean `{similar}`?")),
        _ => error.help(fields_in_order()),
    }
}

/// Something else where the number of vertices should be.
fn bad_count(word: &[u8], span: Span, keyword: &[u8]) -> Diagnostic {
    let quoted = quote(word);
    let message = match str::from_utf8(word).ok().and_then(|word| word.parse::<f64>().ok()) {
        Some(negative) if negative < 0.0 => format!("{} cannot have {} vertices", name(keyword), plain(word)),
        Some(whole) if whole.fract() == 0.0 && whole > 1e18 => {
            format!("{} cannot have so many vertices", name(keyword))
        }
        _ => format!("{quoted} is not a number of vertices"),
    };
    Diagnostic::error(message).at(span, "expected how many vertices follow").help(format!("write {}", shape(keyword)))
}
