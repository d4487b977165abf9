//! Mistakes: how they are told, and where reading goes on behind one.
//!
//! Reading goes on at the next word that makes sense in the block in hand, or at its `}`. Where a word belongs to a level above,
//! a `}` is missing: the block counts as closed, and its `}`, should it come after all, is forgiven.

use super::Reader;
use super::block::with_suggestion;
use super::is_item;
use super::trouble::Trouble;
use super::vocabulary::{self, FILE_WORDS, ITEM_WORDS};
use super::words::Kind;
use crate::diagnostic::{Diagnostic, Span};
use crate::parse::tokens;
use crate::parse::wording::{plain, quote};

impl Reader<'_> {
    /// Keeps a mistake for the user.
    pub(super) fn tell(&mut self, trouble: Trouble) {
        match trouble {
            Trouble::Mistake(error) => self.errors.push(error),
            Trouble::End(_) if self.stopped => {}
            Trouble::End(wanted) => {
                self.stopped = true;
                let error = self.cut_off(&wanted);
                self.errors.push(error);
            }
        }
    }

    /// The file ends too early.
    fn cut_off(&self, wanted: &str) -> Diagnostic {
        let end = Span::new(self.source.text.trim_ascii_end().len(), self.source.text.trim_ascii_end().len());
        let Some(&block) = self.open_blocks.last() else {
            return Diagnostic::error("the file ends in the middle of a statement")
                .at(end, format!("expected {wanted}"));
        };
        let word = plain(self.words.bytes(block));
        let line = self.source.line(block.start);
        Diagnostic::error(format!("the file ends inside the `{word}` of line {line}"))
            .at(end, format!("expected {wanted}"))
            .at(block, "not closed")
            .help("every `{` needs its `}`; was the file cut off?")
    }

    /// Tells that a `}` is missing before `span`.
    pub(super) fn not_closed(&mut self, span: Span) {
        self.forgiven += 1;
        let word = quote(self.words.bytes(span));
        let block = self.open_blocks.last().copied().unwrap_or_default();
        let owner = plain(self.words.bytes(block));
        let error = Diagnostic::error(format!("{word} cannot stand inside `{owner}`"))
            .at(span, "not here")
            .at(block, "this block is still open");
        self.tell(error.help(format!("close `{owner}` with `}}` before it")).into());
    }

    /// Goes to the next word that makes sense in the current block, or to its `}`.
    pub(super) fn recover(&mut self, makes_sense: impl Fn(&[u8]) -> bool) {
        loop {
            match self.words.peek().kind {
                Kind::End | Kind::Close => return,
                Kind::Open => self.skip_block(),
                Kind::Word if makes_sense(self.words.next_bytes()) => return,
                Kind::Word | Kind::Text | Kind::Unended => _ = self.words.take(),
            }
        }
    }

    /// Goes behind the `}` of the current block.
    pub(super) fn skip_to_close(&mut self) {
        self.recover(|_| false);
        self.words.take_if(Kind::Close);
    }

    /// Goes behind a block, if the next token opens one.
    pub(super) fn skip_block(&mut self) {
        let mut depth = 0usize;
        loop {
            match self.words.peek().kind {
                Kind::Open => depth += 1,
                Kind::Close => depth = depth.saturating_sub(1),
                Kind::End => return,
                _ => {}
            }
            if self.words.peek().kind == Kind::Close && depth == 0 {
                self.words.take();
                return;
            }
            if depth == 0 {
                return;
            }
            self.words.take();
        }
    }

    /// Scenes are text; after a byte that is none there is nothing more to say.
    pub(super) fn check_text(&mut self, word: &[u8], span: Span) -> Result<(), Trouble> {
        match word.iter().find(|byte| byte.is_ascii_control()) {
            Some(&byte) => {
                self.stopped = true;
                Err(not_text(byte, span).into())
            }
            None => Ok(()),
        }
    }
}

pub(super) fn not_text(byte: u8, span: Span) -> Diagnostic {
    let error = Diagnostic::error("this is not a text file").at(span, format!("holds the byte 0x{byte:02X}"));
    error.help("scenes are plain text, or plain text packed by gzip")
}

/// A definition without a name could never be used.
pub(super) fn nameless(trouble: Trouble, keyword: Span) -> Trouble {
    match trouble {
        Trouble::Mistake(_) => Diagnostic::error("an object at the level of the file needs a name")
            .at(keyword, "this one has none")
            .help("write `object NAME { ... }` and draw it by `world { use NAME }`")
            .into(),
        end @ Trouble::End(_) => end,
    }
}

pub(super) fn unknown_statement(word: &[u8], span: Span) -> Diagnostic {
    if tokens::looks_numeric(word) {
        return Diagnostic::error("a number where a statement should start").at(span, "no statement goes on here");
    }
    if is_item(word) {
        let error = Diagnostic::error(format!("{} stands outside of all objects", quote(word)));
        let help = "put it between the braces of an `object NAME { ... }` or of the `world { ... }`";
        return error.at(span, "belongs into an object").help(help);
    }
    unknown("a statement", word, span, FILE_WORDS)
}

pub(super) fn unknown_item(word: &[u8], span: Span) -> Diagnostic {
    if tokens::looks_numeric(word) {
        return Diagnostic::error("a number where an item of an object should start").at(span, "belongs to nothing");
    }
    unknown("part of an object", word, span, ITEM_WORDS)
}

fn unknown(what: &str, word: &[u8], span: Span, known: &[&str]) -> Diagnostic {
    if let Some((origin, help)) = vocabulary::foreign(word) {
        return Diagnostic::error(format!("{} is {origin}", quote(word))).at(span, "not understood").help(help);
    }
    let error = Diagnostic::error(format!("{} is not {what}", quote(word))).at(span, "not known here");
    with_suggestion(error, word, known)
}
