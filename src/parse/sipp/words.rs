//! Words of a `.sipp` file, one ahead: braces, quoted strings, numbers and angles.
//!
//! Source -WORDS-> Token -reader-> Draft
//!
//! Why an own step above `tokens`: NFF's words end at white space only; here `{`, `}`, `;` and quotes end them, too, so that
//! `sphere{radius 1}` is what it looks like. `;` counts as white space.
//!
//! Units: spans are bytes of the source. Cost: one pass, nothing is copied.

use super::trouble::{Trouble, bad_number};
use crate::diagnostic::{Diagnostic, Lines, Source, Span};
use crate::math::Vec3;
use crate::parse::tokens::{self, is_space};
use crate::parse::wording::{plain, quote};

/// What a token is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Word,
    /// A quoted string; the span is what stands between the quotes.
    Text,
    /// A quoted string that does not end on its line.
    Unended,
    Open,
    Close,
    End,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Token {
    pub kind: Kind,
    pub span: Span,
}

/// Goes through a source token by token.
pub(super) struct Words<'a> {
    source: &'a Source,
    next: Token,
    /// Where the token after `next` is looked for.
    behind: usize,
    lines: Lines<'a>,
    /// How many numbers are not 0 and were read as 0, and the first of them.
    pub vanished: Option<(usize, Span)>,
}

impl<'a> Words<'a> {
    pub fn new(source: &'a Source) -> Words<'a> {
        let next = Token { kind: Kind::End, span: Span::default() };
        let mut words = Words { source, next, behind: 0, lines: source.lines(), vanished: None };
        words.advance();
        words
    }

    pub fn peek(&self) -> Token {
        self.next
    }

    pub fn take(&mut self) -> Token {
        let token = self.next;
        self.advance();
        token
    }

    /// Takes the next token if it is of this kind.
    pub fn take_if(&mut self, kind: Kind) -> Option<Token> {
        (self.next.kind == kind).then(|| self.take())
    }

    /// Takes the next token if it is this word.
    pub fn take_word(&mut self, word: &str) -> bool {
        let found = self.is_next(word);
        if found {
            self.advance();
        }
        found
    }

    /// Whether the next token is this word.
    pub fn is_next(&self, word: &str) -> bool {
        self.next.kind == Kind::Word && self.next_bytes() == word.as_bytes()
    }

    /// Whether the next word was meant as a number.
    pub fn is_number_next(&self) -> bool {
        self.next.kind == Kind::Word && tokens::looks_numeric(self.next_bytes())
    }

    pub fn bytes(&self, span: Span) -> &'a [u8] {
        &self.source.text[span.start as usize..span.end as usize]
    }

    pub fn next_bytes(&self) -> &'a [u8] {
        self.bytes(self.next.span)
    }

    /// The line of a span; fast when asked in the order of the file.
    pub fn line(&mut self, span: Span) -> u32 {
        self.lines.at(span.start)
    }

    /// A number; `shape` is the parameter it belongs to, as it should be written.
    pub fn number(&mut self, shape: &str) -> Result<f64, Trouble> {
        let token = self.expect_word(shape, "a number")?;
        let bytes = self.bytes(token.span);
        let number = tokens::number(bytes).map_err(|why| bad_number(bytes, token.span, why, shape))?;
        if number.vanished {
            let (count, first) = self.vanished.unwrap_or((0, token.span));
            self.vanished = Some((count + 1, first));
        }
        self.advance();
        Ok(number.value)
    }

    pub fn vector(&mut self, shape: &str) -> Result<Vec3, Trouble> {
        Ok(Vec3::new(self.number(shape)?, self.number(shape)?, self.number(shape)?))
    }

    /// A name, or a quoted one; its span without quotes.
    pub fn name(&mut self, of_what: &str) -> Result<Span, Trouble> {
        let token = self.peek();
        match token.kind {
            Kind::Text if token.span.start == token.span.end => {
                let error = Diagnostic::error("a name cannot be empty").at(token.span, "nothing between the quotes");
                return Err(error.help(format!("write the name of {of_what}")).into());
            }
            Kind::Text => {}
            _ => {
                self.expect_word(of_what, "a name")?;
                let bytes = self.bytes(token.span);
                let starts_well = bytes[0].is_ascii_alphabetic() || bytes[0] == b'_';
                if !starts_well || !bytes.iter().all(|&byte| is_of_name(byte)) {
                    let error = Diagnostic::error(format!("{} is not a name", quote(bytes)))
                        .at(token.span, format!("expected the name of {of_what}"));
                    let help = "names are letters, digits, `_`, `.` and `-`, and start with a letter; any other name \
                                stands in quotes";
                    return Err(error.help(help).into());
                }
            }
        }
        self.advance();
        Ok(token.span)
    }

    /// A quoted string; its span without quotes.
    pub fn text(&mut self, shape: &str) -> Result<Span, Trouble> {
        if let Some(token) = self.take_if(Kind::Text) {
            return Ok(token.span);
        }
        let token = self.expect_word(shape, "a quoted string")?;
        let word = self.bytes(token.span);
        let error = Diagnostic::error(format!("{} where a quoted string is expected", quote(word)));
        Err(error.at(token.span, "expected quotes").help(format!("write `\"{}\"`", plain(word))).into())
    }

    /// `{`
    pub fn open(&mut self, owner: &str) -> Result<(), Trouble> {
        if self.take_if(Kind::Open).is_some() {
            return Ok(());
        }
        let wanted = format!("`{{` behind `{owner}`");
        let token = self.peek();
        if token.kind == Kind::End {
            return Err(Trouble::End(wanted));
        }
        let error = Diagnostic::error(format!("{} where `{{` is expected", self.describe(token)));
        Err(error.at(token.span, format!("expected {wanted}")).into())
    }

    /// The next token, if it is a word; else what stands there is not `wanted`.
    pub fn expect_word(&self, shape: &str, wanted: &str) -> Result<Token, Trouble> {
        let token = self.peek();
        match token.kind {
            Kind::Word => Ok(token),
            Kind::End => Err(Trouble::End(format!("{wanted} for {shape}"))),
            Kind::Unended => Err(unended(token.span)),
            Kind::Text | Kind::Open | Kind::Close => {
                let error = Diagnostic::error(format!("{} where {wanted} is expected", self.describe(token)));
                Err(error.at(token.span, format!("expected {wanted} for {shape}")).into())
            }
        }
    }

    /// A token in a message.
    pub fn describe(&self, token: Token) -> String {
        match token.kind {
            Kind::Open => "`{`".to_string(),
            Kind::Close => "`}`".to_string(),
            Kind::Text => format!("the string \"{}\"", plain(self.bytes(token.span))),
            Kind::End => "the end".to_string(),
            Kind::Word | Kind::Unended => quote(self.bytes(token.span)),
        }
    }

    fn advance(&mut self) {
        let text = &self.source.text;
        let mut start = self.behind;
        while text.get(start).is_some_and(|&byte| is_space(byte) || byte == b';') {
            start += 1;
        }
        let span = |end: usize| Span::new(start, end);
        let (kind, span) = match text.get(start) {
            None => {
                // What is missing at the end is shown behind the last word.
                let end = text.trim_ascii_end().len();
                (Kind::End, Span::new(end, end))
            }
            Some(b'{') => (Kind::Open, span(start + 1)),
            Some(b'}') => (Kind::Close, span(start + 1)),
            Some(b'"') => {
                let rest = &text[start + 1..];
                let length = rest.iter().position(|&byte| byte == b'"' || byte == b'\n').unwrap_or(rest.len());
                let kind = if rest.get(length) == Some(&b'"') { Kind::Text } else { Kind::Unended };
                (kind, Span::new(start + 1, start + 1 + length))
            }
            Some(_) => {
                let rest = &text[start..];
                (Kind::Word, span(start + rest.iter().position(|&byte| ends_word(byte)).unwrap_or(rest.len())))
            }
        };
        self.next = Token { kind, span };
        self.behind = span.end as usize + usize::from(kind == Kind::Text);
        if kind == Kind::End {
            self.behind = text.len();
        }
    }
}

/// A string without its second quote.
pub(super) fn unended(span: Span) -> Trouble {
    let span = Span { start: span.start - 1, end: span.end };
    let help = "put a `\"` behind it; a `#` starts a comment even between quotes";
    Diagnostic::error("a string must end on its line").at(span, "no second `\"`").help(help).into()
}

fn ends_word(byte: u8) -> bool {
    is_space(byte) || matches!(byte, b';' | b'{' | b'}' | b'"')
}

/// Whether this byte can stand in a name without quotes.
fn is_of_name(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || matches!(byte, b'_' | b'.' | b'-')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn braces_and_semicolons_need_no_blanks() {
        let source = Source::verbatim("", b"sphere{radius 1;res 2}\n\"my arm\" \"cut\n}");
        let mut words = Words::new(&source);
        let mut seen = Vec::new();
        loop {
            let token = words.take();
            seen.push((token.kind, words.bytes(token.span)));
            if token.kind == Kind::End {
                break;
            }
        }
        let word = |text: &'static str| (Kind::Word, text.as_bytes());
        assert_eq!(
            seen,
            [
                word("sphere"),
                (Kind::Open, &b"{"[..]),
                word("radius"),
                word("1"),
                word("res"),
                word("2"),
                (Kind::Close, b"}"),
                (Kind::Text, b"my arm"),
                (Kind::Unended, b"cut"),
                (Kind::Close, b"}"),
                (Kind::End, b""),
            ]
        );
    }
}
