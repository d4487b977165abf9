//! Reads `.fcell`, farop's text for an area of forest: cells, heights, stands, roads.
//!
//! Source -FCELL (words, statements)-> Area -forest::tree-> Scene
//!
//! Statements are keyword lines: `statements` cuts the text and knows where a statement begins, `header` reads what belongs to the whole area,
//! `cell`, `ground`, `stand` and `poly` what belongs to a cell, `outline` decides exactly whether a polygon is one. After a mistake the
//! reader goes on at the next line that begins with a keyword, so that one run tells up to [`MOST_ERRORS`] of them.
//!
//! Why names come before their use: an area may be long, and a reader, human or not, should know what a word means when it comes.
//!
//! Space: metres in the cell, x east, y north, from its south-west corner. Language: `docs/fcell.md`.

mod cell;
mod ground;
mod header;
pub(super) mod outline;
mod poly;
mod reference;
mod stand;
mod vocabulary;

use crate::diagnostic::{Diagnostic, Diagnostics, Lines, Source, Span, printable};
use crate::forest::area::{Area, Cell, CellIndex, Head, Stand};
use crate::parse::statements::{Word, Words, did_you_mean};
use crate::parse::wording::quote;
use crate::scene::Place;
use cell::Open;
use reference::Grids;
use std::collections::BTreeMap;
use std::path::Path;

/// How many errors of one file are told.
const MOST_ERRORS: usize = 20;
/// The side of cells where no file says one: Landscaper's.
const USUAL_SIDE: f64 = 240.0;

/// Reads a whole source; grids that it names are looked for in `folder`.
///
/// # Errors
/// Up to [`MOST_ERRORS`] mistakes, and one that says there are more.
pub(super) fn read(source: &Source, folder: &Path) -> Result<(Area, Diagnostics), Diagnostics> {
    let mut reader = Reader::new(source, folder);
    reader.file();
    if reader.errors.is_empty() {
        let notices = reader.notices();
        return Ok((Area { head: reader.head, cells: reader.cells }, Diagnostics::new(source, notices)));
    }
    if reader.errors.len() > MOST_ERRORS {
        reader.errors.truncate(MOST_ERRORS);
        reader.errors.push(Diagnostic::error(format!("too many errors: stopped after {MOST_ERRORS}")));
    }
    Err(Diagnostics::new(source, reader.errors))
}

/// Goes through a source from statement to statement.
struct Reader<'a> {
    words: Words<'a>,
    lines: Lines<'a>,
    grids: Grids<'a>,
    head: Head,
    /// Somebody said how large cells are, and where.
    side: Option<Span>,
    /// Stands declared before all cells: every cell may use them.
    shared: Vec<Stand>,
    cells: BTreeMap<CellIndex, Cell>,
    /// The cell in hand.
    open: Option<Open>,
    /// The head of the cell in hand was wrong: what belongs to it is read, and not missed.
    is_lost: bool,
    ended: Option<Span>,
    errors: Vec<Diagnostic>,
    oddities: Vec<Diagnostic>,
    /// Corners that were moved onto the border, and the first of them.
    moved: (usize, Span),
}

impl<'a> Reader<'a> {
    fn new(source: &'a Source, folder: &'a Path) -> Reader<'a> {
        Reader {
            words: Words::new(source, &vocabulary::STATEMENTS),
            lines: source.lines(),
            grids: Grids::new(folder),
            head: Head { files: vec![source.name.clone()], side: USUAL_SIDE, ..Head::default() },
            side: None,
            shared: Vec::new(),
            cells: BTreeMap::new(),
            open: None,
            is_lost: false,
            ended: None,
            errors: Vec::new(),
            oddities: Vec::new(),
            moved: (0, Span::default()),
        }
    }

    fn file(&mut self) {
        if let Err(error) = self.start() {
            self.errors.push(error);
            return;
        }
        while !self.words.peek().is_end() && self.errors.len() <= MOST_ERRORS {
            if let Err(error) = self.statement() {
                self.errors.push(error);
                self.words.skip_statement();
            }
        }
        if self.errors.len() <= MOST_ERRORS {
            self.finish();
        }
    }

    /// The first line: `fcell 1`.
    fn start(&mut self) -> Result<(), Diagnostic> {
        let source = self.words.source;
        // Pictures and archives have a 0 early on; without this they would be twenty unknown keywords.
        let beginning = &source.text[..source.text.len().min(512)];
        if let Some(at) = beginning.iter().position(|&byte| byte == 0) {
            let error = Diagnostic::error("this is no text").at(Span::new(at, at + 1), "a byte that no text has");
            return Err(error.help("is it a pack? Those end in `.fpack`"));
        }
        let word = self.words.peek();
        if word.is_end() {
            let error = Diagnostic::error(format!("no area: `{}` says nothing", printable(source.name.as_bytes())));
            return Err(error.help("an area begins with `fcell 1`; then come species, covers and cells"));
        }
        if !word.is("fcell") {
            let error = Diagnostic::error("this is no area of forest").at(word.span, "expected `fcell 1`");
            return Err(error.help("every `.fcell` begins with `fcell 1`"));
        }
        self.words.keyword = self.words.take().span;
        let version = self.words.peek();
        let number: u32 = self.words.whole("the version", 0..=u32::MAX)?;
        if number != 1 {
            let error = Diagnostic::error(format!("version {number} of `.fcell` is not known"));
            return Err(error.at(version.span, "expected 1").help("a later farop may read it"));
        }
        Ok(())
    }

    /// Reads one statement.
    fn statement(&mut self) -> Result<(), Diagnostic> {
        let word = self.words.take();
        if let Some(end) = self.ended {
            let error =
                Diagnostic::error("text behind `end`").at(word.span, "what is this?").at(end, "the area ends here");
            self.words = Words::new(self.words.source, &vocabulary::STATEMENTS);
            self.skip_everything();
            return Err(error.help("remove it, or move `end` behind it"));
        }
        if word.is_quoted || !vocabulary::STATEMENTS.is_keyword(word.bytes) {
            return Err(self.no_statement(word));
        }
        self.words.keyword = word.span;
        let fields = self.dispatch(word.bytes)?;
        // A keyword may follow on the same line; anything else is one word too many.
        let next = self.words.peek();
        if next.begins_statement() || !next.is_quoted && vocabulary::STATEMENTS.is_keyword(next.bytes) {
            return Ok(());
        }
        Err(self.words.unexpected(next, fields))
    }

    /// Reads the statement behind a keyword, and returns the fields that it can have.
    fn dispatch(&mut self, keyword: &[u8]) -> Result<&'static [&'static str], Diagnostic> {
        match keyword {
            b"fcell" => Err(Diagnostic::error("`fcell` again").at(self.words.keyword, "the area has begun already")),
            b"crs" | b"origin" | b"side" | b"seed" => self.of_area(keyword).map(|()| &[] as &[_]),
            b"species" => self.species().map(|()| &["form", "image"] as &[_]),
            b"cover" => self.cover().map(|()| &["tile"] as &[_]),
            b"stand" => self.stand().map(|()| stand::FIELDS),
            b"cell" => self.cell().map(|()| &["size", "seed"] as &[_]),
            b"ground" => self.ground_cover().map(|()| &[] as &[_]),
            b"dem" => self.dem().map(|()| &["z0", "dz"] as &[_]),
            b"demref" => self.demref().map(|()| &["lattice", "black", "white"] as &[_]),
            b"v" => self.vertex().map(|()| &[] as &[_]),
            b"t" => self.triangle().map(|()| &["cover"] as &[_]),
            b"poly" => self.poly().map(|()| &["outer", "hole"] as &[_]),
            b"tree" => self.tree().map(|()| &[] as &[_]),
            b"line" => self.line().map(|()| &["w"] as &[_]),
            b"mark" => self.mark().map(|()| &[] as &[_]),
            b"object" => self.object().map(|()| &[] as &[_]),
            _ => {
                self.close_cell();
                self.ended = Some(self.words.keyword);
                Ok(&[])
            }
        }
    }

    /// A word where a statement should begin.
    fn no_statement(&self, word: Word<'_>) -> Diagnostic {
        if word.is_numeric() {
            let error =
                Diagnostic::error("a number where a statement should begin").at(word.span, "belongs to nothing");
            return error.help("every statement begins with a keyword");
        }
        let known: Vec<&str> = vocabulary::STATEMENTS.keywords().collect();
        let error = Diagnostic::error(format!("unknown keyword {}", quote(word.bytes))).at(word.span, "not understood");
        error.help(did_you_mean(word.bytes, &known))
    }

    fn skip_everything(&mut self) {
        while !self.words.peek().is_end() {
            self.words.take();
        }
    }

    /// What can only be said behind the last statement.
    fn finish(&mut self) {
        if self.ended.is_none() {
            let end = self.words.peek().span;
            let error = Diagnostic::error("the text ends without `end`").at(end, "expected `end`");
            self.errors.push(error.help("is the file whole? If so, write `end` behind the last cell"));
            self.close_cell();
        }
        if self.cells.is_empty() && self.errors.is_empty() {
            let error = Diagnostic::error("an area without cells").at(self.ended.unwrap_or_default(), "ends here");
            self.errors.push(error.help("write `cell 0 0`, its heights (`dem`) and what grows there"));
        }
    }

    fn notices(&mut self) -> Vec<Diagnostic> {
        let mut notices = std::mem::take(&mut self.oddities);
        if self.moved.0 > 0 {
            let count = self.moved.0;
            let notice =
                Diagnostic::notice(format!("{count} positions beyond the border by less than 1 mm were moved onto it"));
            notices.push(notice.at(self.moved.1, "the first of them"));
        }
        let more = notices.len().saturating_sub(MOST_ERRORS);
        if more > 0 {
            notices.truncate(MOST_ERRORS);
            notices.push(Diagnostic::notice(format!("{more} more notices are not shown")));
        }
        notices
    }

    /// The place of the statement in hand, for the model.
    fn place(&mut self) -> Place {
        Place { file: 0, line: self.lines.at(self.words.keyword.start) }
    }
}
