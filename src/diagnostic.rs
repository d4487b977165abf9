//! What is wrong with an input, where, and what to do about it; printed the way rustc prints.
//!
//! parse, command line -> DIAGNOSTICS -> standard error
//!
//! Why the lines are copied out of the source: errors leave the room that read the file, the file's text does not.
//! Only lines that a message shows are kept, and of a long line only the part around the mistake.
//! Why the bytes are made printable: a scene is foreign input, and an escape sequence or a NUL in it must not reach
//! the terminal.
//!
//! Units: spans are bytes of a [`Source`]; printed lines and columns (characters) count from 1.
//! Cost: only paid on errors and notices.

mod source;
mod suggest;

pub use source::{Gap, Lines, Source, Span};
pub use suggest::suggest;

use annotate_snippets::{Annotation, AnnotationKind, Group, Level, Renderer, Snippet};
use std::collections::BTreeMap;
use std::fmt;

/// Whether a scene can still be used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Severity {
    /// It cannot.
    Error,
    /// It can: something was left out, replaced or looks wrong.
    Notice,
}

/// One mistake, or one thing worth knowing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// Error or notice.
    pub severity: Severity,
    /// What is wrong, in one line.
    pub message: String,
    /// Places and what to say there (may be empty); the first is where the mistake is.
    pub labels: Vec<(Span, String)>,
    /// What to do about it.
    pub help: Option<String>,
}

impl Diagnostic {
    /// An error without places yet.
    #[must_use]
    pub fn error(message: impl Into<String>) -> Diagnostic {
        Diagnostic { severity: Severity::Error, message: message.into(), labels: Vec::new(), help: None }
    }

    /// A notice without places yet.
    #[must_use]
    pub fn notice(message: impl Into<String>) -> Diagnostic {
        Diagnostic { severity: Severity::Notice, ..Diagnostic::error(message) }
    }

    /// Adds a place and what to say there; the first one added is the place of the mistake.
    #[must_use]
    pub fn at(mut self, span: Span, label: impl Into<String>) -> Diagnostic {
        self.labels.push((span, label.into()));
        self
    }

    /// Says what to do.
    #[must_use]
    pub fn help(mut self, help: impl Into<String>) -> Diagnostic {
        self.help = Some(help.into());
        self
    }
}

/// Diagnostics of one source, with the lines that are needed to print them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Diagnostics {
    /// What messages call the source; empty where there is none.
    pub name: String,
    /// In the order they were found.
    pub list: Vec<Diagnostic>,
    /// The line around each label, by where the label starts in the source, and lines between labels.
    excerpts: BTreeMap<u32, Excerpt>,
}

/// What is kept of a line of the source.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Excerpt {
    /// 1-based line of the file.
    line: u32,
    /// 1-based column, in characters, of the first kept byte.
    column: u32,
    /// Offset of the first kept byte in the source.
    offset: u32,
    /// The kept bytes, as read.
    bytes: Vec<u8>,
    /// Whether something was cut off behind them.
    cut_behind: bool,
}

/// Bytes kept before and behind the mistake of a line that is longer than both together.
const CONTEXT_BYTES: usize = 60;
/// Lines this far apart are still shown as one piece of the file.
const LINES_IN_ONE_PIECE: u32 = 1000;

impl Diagnostics {
    /// Takes what is needed of `source` along with the `list`.
    #[must_use]
    pub fn new(source: &Source, list: Vec<Diagnostic>) -> Diagnostics {
        let mut excerpts = BTreeMap::new();
        let mut lines = source.lines();
        for diagnostic in &list {
            for (span, _) in &diagnostic.labels {
                let (text, start) = source.line_text(span.start);
                excerpts.insert(span.start, Excerpt::around(*span, text, start, lines.at(start)));
                // A single line between two marked ones is shown too.
                if diagnostic.labels.len() > 1 && start > 0 {
                    let (text, above) = source.line_text(start - 1);
                    let span = Span { start: above, end: above };
                    excerpts.entry(above).or_insert_with(|| Excerpt::around(span, text, above, lines.at(above)));
                }
            }
        }
        Diagnostics { name: source.name.clone(), list, excerpts }
    }

    /// A single diagnostic about something that has no text, such as a file that cannot be opened.
    #[must_use]
    pub fn without_source(diagnostic: Diagnostic) -> Diagnostics {
        Diagnostics { name: String::new(), list: vec![diagnostic], excerpts: BTreeMap::new() }
    }

    /// The same, each saying that `place` names the source.
    #[must_use]
    pub fn named_by(mut self, place: &str) -> Diagnostics {
        for diagnostic in &mut self.list {
            diagnostic.message = format!("{} (named by {place})", diagnostic.message);
        }
        self
    }

    /// `name:line:column` of the mistake of one of them; `None` where it has no place.
    #[must_use]
    pub fn place(&self, diagnostic: &Diagnostic) -> Option<String> {
        let (span, _) = diagnostic.labels.first()?;
        let excerpt = self.excerpts.get(&span.start)?;
        let column = excerpt.column + characters(&excerpt.bytes[..excerpt.index_of(span.start)]);
        Some(format!("{}:{}:{column}", printable(self.name.as_bytes()), excerpt.line))
    }

    /// Whether one of them is an error.
    #[must_use]
    pub fn has_errors(&self) -> bool {
        self.list.iter().any(|diagnostic| diagnostic.severity == Severity::Error)
    }

    /// Whether there is nothing to say.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// The text for a terminal, with or without color, ending in a line break (empty if there is nothing to say).
    #[must_use]
    pub fn render(&self, color: bool) -> String {
        let renderer = if color { Renderer::styled() } else { Renderer::plain() };
        let mut text = String::new();
        for diagnostic in &self.list {
            // A blank line between diagnostics.
            text += if text.is_empty() { "" } else { "\n" };
            for report in self.reports(diagnostic) {
                text += &renderer.render(&report);
                text.push('\n');
            }
        }
        text
    }

    /// One diagnostic in the vocabulary of `annotate-snippets`.
    fn reports<'a>(&'a self, diagnostic: &'a Diagnostic) -> Vec<Vec<Group<'a>>> {
        let level = match diagnostic.severity {
            Severity::Error => Level::ERROR,
            Severity::Notice => Level::WARNING.with_name("notice"),
        };
        let mut message = Group::with_title(level.primary_title(diagnostic.message.as_str()));
        for piece in self.pieces(diagnostic) {
            message = message.element(piece);
        }
        let Some(help) = &diagnostic.help else { return vec![vec![message]] };
        let help = Group::with_title(Level::HELP.secondary_title(help.as_str()));
        // Groups of one report are joined by a `|`, which has nothing to stand under where no line is shown.
        if diagnostic.labels.is_empty() { vec![vec![message], vec![help]] } else { vec![vec![message, help]] }
    }

    /// The labels of one diagnostic, gathered into pieces of the file.
    fn pieces<'a>(&'a self, diagnostic: &'a Diagnostic) -> Vec<Piece<'a>> {
        let mut pieces: Vec<(u32, Vec<Mark<'a>>)> = Vec::new();
        for (index, (span, label)) in diagnostic.labels.iter().enumerate() {
            let Some(excerpt) = self.excerpts.get(&span.start) else { continue };
            let mark = Mark { excerpt, span: *span, label, primary: index == 0 };
            match pieces.iter_mut().find(|(line, _)| line.abs_diff(excerpt.line) <= LINES_IN_ONE_PIECE) {
                Some((_, marks)) => marks.push(mark),
                None => pieces.push((excerpt.line, vec![mark])),
            }
        }
        pieces.into_iter().map(|(_, marks)| self.piece(marks)).collect()
    }

    /// The lines under some marks as one text, lines between them blank: the printer folds those away.
    fn piece<'a>(&'a self, marks: Vec<Mark<'a>>) -> Piece<'a> {
        // Where a line is long, its first label decides which part of it is shown.
        let mut by_line: BTreeMap<u32, &Excerpt> = BTreeMap::new();
        marks.iter().for_each(|mark| _ = by_line.entry(mark.excerpt.line).or_insert(mark.excerpt));
        let (first_line, last_line) = (first(by_line.keys()), first(by_line.keys().rev()));
        let between = self.excerpts.values().filter(|excerpt| (first_line..last_line).contains(&excerpt.line));
        between.for_each(|excerpt| _ = by_line.entry(excerpt.line).or_insert(excerpt));

        let (mut text, mut line) = (String::new(), first_line);
        let mut annotations: Vec<Annotation<'a>> = Vec::new();
        for (&next, excerpt) in &by_line {
            text.extend((line..next).map(|_| '\n'));
            line = next;
            let start = text.len();
            text += &excerpt.printable();
            for mark in marks.iter().filter(|mark| mark.excerpt.line == line && excerpt.shows(mark.span.start)) {
                let kind = if mark.primary { AnnotationKind::Primary } else { AnnotationKind::Context };
                let range = excerpt.printed_range(mark.span);
                let annotation = kind.span(start + range.start..start + range.end);
                annotations.push(annotation.label((!mark.label.is_empty()).then_some(mark.label)));
            }
        }
        // A mark behind the last byte needs something to stand under.
        text.push('\n');
        let path = printable(self.name.as_bytes());
        Snippet::source(text).path(path).line_start(first_line as usize).annotations(annotations)
    }
}

/// The first of some line numbers.
fn first<'a>(mut lines: impl Iterator<Item = &'a u32>) -> u32 {
    lines.next().copied().unwrap_or(1)
}

/// A label and the line it stands on.
struct Mark<'a> {
    excerpt: &'a Excerpt,
    span: Span,
    label: &'a str,
    primary: bool,
}

/// Some lines of the file, ready for the printer.
type Piece<'a> = Snippet<'a, Annotation<'a>>;

impl Excerpt {
    /// Keeps the line, or the part of it around `span`.
    fn around(span: Span, text: &[u8], start: u32, line: u32) -> Excerpt {
        let at = ((span.start - start) as usize).min(text.len());
        let whole = text.len() <= 2 * CONTEXT_BYTES;
        let from = if whole { 0 } else { at.saturating_sub(CONTEXT_BYTES) };
        let to = if whole { text.len() } else { text.len().min(at + CONTEXT_BYTES) };
        Excerpt {
            line,
            column: 1 + characters(&text[..from]),
            offset: start + from as u32,
            bytes: text[from..to].to_vec(),
            cut_behind: to < text.len(),
        }
    }

    /// Index of a source offset in the kept bytes; what was cut off counts as the nearest end.
    fn index_of(&self, offset: u32) -> usize {
        (offset.saturating_sub(self.offset) as usize).min(self.bytes.len())
    }

    /// Whether this offset is within what was kept.
    fn shows(&self, offset: u32) -> bool {
        offset >= self.offset && (offset - self.offset) as usize <= self.bytes.len()
    }

    fn printable(&self) -> String {
        let right = if self.cut_behind { "..." } else { "" };
        format!("{}{}{right}", " ".repeat(self.column as usize - 1), printable(&self.bytes))
    }

    /// Where `span` is in [`Excerpt::printable`]; it marks at least one column.
    fn printed_range(&self, span: Span) -> std::ops::Range<usize> {
        let shift = self.column as usize - 1;
        let printed = printable(&self.bytes);
        let position = |offset| {
            let position = printable(&self.bytes[..self.index_of(offset)]).len();
            shift + printed.floor_char_boundary(position)
        };
        position(span.start)..position(span.end).max(position(span.start))
    }
}

/// How many characters these bytes print as, give or take broken UTF-8.
fn characters(bytes: &[u8]) -> u32 {
    bytes.iter().filter(|&&byte| byte & 0b1100_0000 != 0b1000_0000).count() as u32
}

/// Foreign bytes as text that is safe on a terminal: control characters as their pictures, what is not UTF-8 as U+FFFD.
#[must_use]
pub fn printable(bytes: &[u8]) -> String {
    let mut text = String::with_capacity(bytes.len());
    for chunk in bytes.utf8_chunks() {
        text.extend(chunk.valid().chars().map(printable_character));
        text.extend((!chunk.invalid().is_empty()).then_some(char::REPLACEMENT_CHARACTER));
    }
    text
}

fn printable_character(character: char) -> char {
    match character {
        '\t' => ' ',
        // U+2400 is the picture of NUL, and the others follow in order.
        '\0'..='\x1f' => char::from_u32(0x2400 + character as u32).unwrap_or(char::REPLACEMENT_CHARACTER),
        '\x7f' => '\u{2421}',
        // C1 controls, and what reorders or hides text.
        '\u{80}'..='\u{9f}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}' => {
            char::REPLACEMENT_CHARACTER
        }
        other => other,
    }
}

impl fmt::Display for Diagnostics {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.render(false))
    }
}

impl std::error::Error for Diagnostics {}

#[cfg(test)]
mod tests {
    use super::*;

    fn say(text: &str, error: Diagnostic) -> String {
        let source = Source { name: "a.nff".into(), ..Source::verbatim("", text.as_bytes()) };
        Diagnostics::new(&source, vec![error]).to_string()
    }

    fn at(text: &str, word: &str) -> Span {
        let start = text.find(word).expect("is in the text");
        Span::new(start, start + word.len())
    }

    #[test]
    fn it_looks_like_rustc() {
        let text = "p 4\n0 0 0\n1 0 0\n1 1 0\nf 1 0.2 0.2 1 0 100000 0 0\n";
        let error = Diagnostic::error("polygon declares 4 vertices but only 3 follow")
            .at(at(text, "p 4"), "declared here")
            .at(at(text, "f"), "expected the 4th vertex: three numbers, `x y z`")
            .help("write `p 3`, or add the missing vertex above line 5");
        let expected = "error: polygon declares 4 vertices but only 3 follow
 --> a.nff:1:1
  |
1 | p 4
  | ^^^ declared here
...
5 | f 1 0.2 0.2 1 0 100000 0 0
  | - expected the 4th vertex: three numbers, `x y z`
  |
help: write `p 3`, or add the missing vertex above line 5
";
        assert_eq!(say(text, error), expected);
    }

    #[test]
    fn a_place_is_file_line_and_column() {
        let text = "one\n  \u{e9} two";
        let error = Diagnostic::error("x").at(at(text, "two"), "");
        let source = Source { name: "a.nff".into(), ..Source::verbatim("", text.as_bytes()) };
        let errors = Diagnostics::new(&source, vec![error]);
        assert_eq!(errors.place(&errors.list[0]).as_deref(), Some("a.nff:2:5"));
        assert_eq!(errors.place(&Diagnostic::error("no place")), None);
    }

    #[test]
    fn of_a_long_line_the_part_around_the_mistake_is_shown() {
        let text = format!("{}nan{} inf{}", "1 ".repeat(400_000), " 2".repeat(9_000), " 3".repeat(9_000));
        for word in ["nan", "inf"] {
            let said = say(&text, Diagnostic::error("not a number").at(at(&text, word), "here"));
            let column = at(&text, word).start + 1;
            assert!(said.contains(&format!("a.nff:1:{column}")) && said.len() < 600, "{said}");
            let lines: Vec<&str> = said.lines().collect();
            assert_eq!(lines[3].find(word), lines[4].find("^^^ here"), "{said}");
        }
    }

    #[test]
    fn lines_between_are_true() {
        let text = "one\ntwo\nthree\nfour\n";
        let error = Diagnostic::error("x").at(at(text, "three"), "primary").at(at(text, "one"), "other");
        assert!(say(text, error).contains("2 | two\n3 | three\n"));
    }

    #[test]
    fn far_places_are_two_pieces() {
        let text = format!("first\n{}last", "\n".repeat(5_000_000));
        let error = Diagnostic::error("x").at(at(&text, "last"), "").at(at(&text, "first"), "here");
        let said = say(&text, error);
        assert!(said.contains("--> a.nff:5000002:1") && said.contains("::: a.nff:1:1"), "{said}");
    }

    #[test]
    fn foreign_bytes_are_safe_to_print() {
        assert_eq!(printable(b"a\0\x1B[31m\tb\xE9\x7F"), "a\u{2400}\u{241B}[31m b\u{FFFD}\u{2421}");
        assert_eq!(printable("\u{202e}caf\u{e9}".as_bytes()), "\u{FFFD}caf\u{e9}");
    }
}
