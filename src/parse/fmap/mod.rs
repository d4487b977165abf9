//! Reads `.fmap`, farop's text for maps: layers of vectors, themes, views.
//!
//! Source -FMAP (statements)-> Map; files it names -vector-> layers
//!
//! A layer's objects stand in the text, or in a file that it names. After a mistake the reader goes on at the next line that begins with a keyword.
//!
//! Space: positions in each layer's projection. Language: `docs/maps.md`.

mod layer;
mod theme;

use super::load::source;
use super::statements::{Vocabulary, Words, did_you_mean};
use super::wording::quote;
use crate::diagnostic::{Diagnostic, Diagnostics, Lines, Source, Span};
use crate::forest::map::{Map, MapView};
use crate::forest::vector::Crs;
use crate::scene::Place;
use std::path::Path;

/// How many errors of one file are told.
const MOST_ERRORS: usize = 20;

/// Every keyword and the statement it begins.
static STATEMENTS: Vocabulary = Vocabulary(&[
    ("fmap", "fmap 1"),
    ("crs", "crs EPSG:NUMBER"),
    ("layer", "layer NAME [from FILE]"),
    ("point", "point X Y [is NAME VALUE]..."),
    ("line", "line N X Y ... [is NAME VALUE]..."),
    ("polygon", "polygon outer N X Y ... [hole N X Y ...]... [is NAME VALUE]..."),
    (
        "theme",
        "theme NAME layer LAYER [where NAME OPERATOR VALUE]... [color R G B] [width N m|px] [fill R G B] [dash ON OFF] [size N m|px]",
    ),
    ("case", "case NAME OPERATOR VALUE and a look: color, width, fill, dash, size"),
    (
        "ramp",
        "ramp NAME LOW HIGH and looks at both ends: color R G B R G B, fill likewise, width A B m|px, size A B m|px",
    ),
    ("view", "view NAME THEME..., the one on top first"),
    ("end", "end"),
]);

/// Reads a map, and the files of vectors that it names beside it; with what is worth knowing about how they were read.
///
/// # Errors
/// A file cannot be read, or has mistakes.
pub fn load_map(path: &Path) -> Result<(Map, Vec<Diagnostics>), Diagnostics> {
    let source = source(path)?;
    let mut reader = Reader::new(&source, path.parent().unwrap_or(Path::new("")));
    reader.file();
    if !reader.errors.is_empty() {
        if reader.errors.len() > MOST_ERRORS {
            reader.errors.truncate(MOST_ERRORS);
            reader.errors.push(Diagnostic::error(format!("too many errors: stopped after {MOST_ERRORS}")));
        }
        return Err(Diagnostics::new(&source, reader.errors));
    }
    Ok((reader.map, reader.notices))
}

/// Goes through a source from statement to statement.
struct Reader<'a> {
    words: Words<'a>,
    lines: Lines<'a>,
    folder: &'a Path,
    map: Map,
    /// What positions mean from here on.
    crs: Option<Crs>,
    /// The layer above has a file of its own.
    is_file: bool,
    ended: bool,
    errors: Vec<Diagnostic>,
    notices: Vec<Diagnostics>,
}

impl<'a> Reader<'a> {
    fn new(source: &'a Source, folder: &'a Path) -> Reader<'a> {
        Reader {
            words: Words::new(source, &STATEMENTS),
            lines: source.lines(),
            folder,
            map: Map { files: vec![source.name.clone()], ..Map::default() },
            crs: None,
            is_file: false,
            ended: false,
            errors: Vec::new(),
            notices: Vec::new(),
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
        let end = self.words.peek().span;
        if !self.ended && self.errors.is_empty() {
            let error = Diagnostic::error("the text ends without `end`").at(end, "expected `end`");
            self.errors.push(error.help("is the file whole? If so, write `end` behind the last view"));
        } else if self.map.views.is_empty() && self.errors.is_empty() {
            let error = Diagnostic::error("a map without views").at(end, "ends here");
            self.errors.push(error.help("write `view NAME THEME...` before `end`"));
        }
    }

    /// The first line: `fmap 1`.
    fn start(&mut self) -> Result<(), Diagnostic> {
        let word = self.words.take();
        if !word.is("fmap") {
            let error = Diagnostic::error("this is no map").at(word.span, "expected `fmap 1`");
            return Err(error.help("every `.fmap` begins with `fmap 1`"));
        }
        self.words.keyword = word.span;
        let at = self.words.peek().span;
        match self.words.whole("the version", 0..=u32::MAX)? {
            1 => Ok(()),
            other => {
                let error = Diagnostic::error(format!("version {other} of `.fmap` is not known"));
                Err(error.at(at, "expected 1").help("a later farop may read it"))
            }
        }
    }

    fn statement(&mut self) -> Result<(), Diagnostic> {
        let word = self.words.take();
        if self.ended {
            return Err(Diagnostic::error("text behind `end`").at(word.span, "what is this?").help("remove it"));
        }
        if !word.begins_statement() {
            let known: Vec<&str> = STATEMENTS.keywords().collect();
            let error = Diagnostic::error(format!("{} begins no statement", quote(word.bytes)));
            return Err(error.at(word.span, "not understood").help(did_you_mean(word.bytes, &known)));
        }
        self.words.keyword = word.span;
        let fields: &[&'static str] = match word.bytes {
            b"crs" => self.set_crs().map(|()| &[] as &[_])?,
            b"layer" => self.layer().map(|()| &["from"] as &[_])?,
            b"point" | b"line" | b"polygon" => self.object(word.bytes).map(|()| &["is", "hole"] as &[_])?,
            b"theme" => self.theme().map(|()| theme::FIELDS)?,
            b"case" => self.case().map(|()| theme::LOOKS)?,
            b"ramp" => self.ramp().map(|()| &["color", "fill", "width", "size"] as &[_])?,
            b"view" => self.view().map(|()| &[] as &[_])?,
            b"end" => {
                self.ended = true;
                &[]
            }
            _ => return Err(Diagnostic::error("`fmap` again").at(word.span, "the map has begun already")),
        };
        let next = self.words.peek();
        if next.begins_statement() { Ok(()) } else { Err(self.words.unexpected(next, fields)) }
    }

    fn set_crs(&mut self) -> Result<(), Diagnostic> {
        let (name, span) = self.words.text("a projection such as EPSG:32631")?;
        let Some(crs) = Crs::named(&name) else {
            let error = Diagnostic::error(format!("the projection `{name}` is not known")).at(span, "not known");
            return Err(
                error.help("known are EPSG:4326 (longitude and latitude), EPSG:326zz and EPSG:327zz (zones of UTM)")
            );
        };
        self.crs = Some(crs);
        Ok(())
    }

    /// `view NAME THEME...`
    fn view(&mut self) -> Result<(), Diagnostic> {
        let place = self.place();
        let (name, span) = self.words.text("the view's name")?;
        if self.map.views.iter().any(|view| view.name == name) {
            return Err(again("view", &name, span));
        }
        let mut themes = Vec::new();
        loop {
            let (theme, at) = self.words.text("a theme")?;
            let known: Vec<&str> = self.map.themes.iter().map(|theme| theme.name.as_str()).collect();
            themes.push(found(&theme, at, "theme", &known)?);
            if self.words.peek().begins_statement() {
                self.map.views.push(MapView { name, themes, place });
                return Ok(());
            }
        }
    }

    /// The place of the statement in hand, for the model.
    fn place(&mut self) -> Place {
        Place { file: 0, line: self.lines.at(self.words.keyword.start) }
    }
}

/// A name that is taken.
fn again(what: &str, name: &str, span: Span) -> Diagnostic {
    let error = Diagnostic::error(format!("{what} `{name}` is declared twice")).at(span, "again");
    error.help("give it another name")
}

/// Which of `known` has the name.
fn found(name: &str, span: Span, what: &str, known: &[&str]) -> Result<usize, Diagnostic> {
    known.iter().position(|known| *known == name).ok_or_else(|| {
        let error = Diagnostic::error(format!("there is no {what} `{name}`")).at(span, "not declared above");
        match known {
            [] => error
                .help(format!("declare it first: `{}`", STATEMENTS.shape(what).replace("write ", "").replace('`', ""))),
            _ => error.help(did_you_mean(name.as_bytes(), known)),
        }
    })
}
