//! Reads `.sipp`, farop's language for scenes as SIPP has them: a tree of objects, shaders, lights.
//!
//! Source -SIPP (words, reader, check, build)-> Scene
//!
//! Four steps: `words` cuts the text, this reader and its parts (`statements`, `surface`, `shapes`, `transforms`, `uses`)
//! make a [`Draft`] in which everything is known by name, `check` looks names up and finds cycles and runaway
//! copies, `build` makes the scene. After a mistake the reader goes on at the next word it knows in that block.
//!
//! Why no recursion: nesting is input, the stack is not. Open objects are a list ([`Reader::open_nodes`]).
//!
//! Source: J. Yngvesson and I. Wallin, "SIPP User's Guide" (what a scene says); the language is farop's (docs/formats.md).

mod block;
mod build;
mod check;
mod draft;
mod external;
mod names;
mod notices;
mod order;
mod outline;
mod recover;
mod shapes;
mod standing;
mod statements;
mod surface;
mod table;
mod textures;
mod transforms;
mod trouble;
mod uses;
mod vocabulary;
mod weld;
mod words;

use super::{ParseOptions, Parsed};
use crate::diagnostic::{Diagnostic, Diagnostics, Source, Span, printable};
use draft::{Draft, NodeKind};
use notices::{Notices, Oddity};
use recover::{nameless, not_text, unknown_item, unknown_statement};
use std::collections::HashMap;
use std::path::Path;
use trouble::Trouble;
use uses::{empty_node, is_transform};
use vocabulary::{FILE_WORDS, ITEM_WORDS, shape_parameters};
use words::{Kind, Token, Words};

/// How many errors of one file are told.
const MOST_ERRORS: usize = 20;

/// Reads a whole source; files that it names are looked for in `folder`.
///
/// # Errors
/// Up to [`MOST_ERRORS`] mistakes, and one that says there are more.
pub(super) fn read(source: &Source, folder: &Path, options: ParseOptions) -> Result<Parsed, Diagnostics> {
    let mut reader = Reader::new(source, folder, options);
    reader.file();
    let mut errors = std::mem::take(&mut reader.errors);
    if errors.is_empty() {
        match check::check(source, &reader.draft, &mut reader.notices) {
            Ok(checked) => return Ok(reader.finish(source, &checked)),
            Err(found) => errors = found,
        }
    }
    if errors.len() > MOST_ERRORS {
        errors.truncate(MOST_ERRORS);
        errors.push(Diagnostic::error(format!("too many errors: stopped after {MOST_ERRORS}")));
    }
    Err(Diagnostics::new(source, errors))
}

/// Goes through a source from statement to statement.
struct Reader<'a> {
    words: Words<'a>,
    source: &'a Source,
    folder: &'a Path,
    options: ParseOptions,
    draft: Draft,
    errors: Vec<Diagnostic>,
    notices: Notices,
    /// The words whose `{` is not closed yet, outermost first.
    open_blocks: Vec<Span>,
    /// The nodes of those that are objects or worlds.
    open_nodes: Vec<u32>,
    /// How many `}` may close nothing: blocks that were taken as closed before theirs came.
    forgiven: usize,
    /// The end of the file was told, or it is no text: nothing more to say.
    stopped: bool,
    /// The last statement of each kind of which only the last counts.
    last_of_kind: Vec<(Oddity, Span)>,
    /// What was imported so far, by name: index into [`Draft::imports`].
    imports: HashMap<&'a [u8], u32>,
}

impl<'a> Reader<'a> {
    fn new(source: &'a Source, folder: &'a Path, options: ParseOptions) -> Reader<'a> {
        Reader {
            words: Words::new(source),
            source,
            folder,
            options,
            draft: Draft::default(),
            errors: Vec::new(),
            notices: Notices::default(),
            open_blocks: Vec::new(),
            open_nodes: Vec::new(),
            forgiven: 0,
            stopped: false,
            last_of_kind: Vec::new(),
            imports: HashMap::new(),
        }
    }

    fn file(&mut self) {
        if self.words.peek().kind == Kind::End {
            let message = format!("no scene: `{}` says nothing", printable(self.source.name.as_bytes()));
            let help = "a scene has shaders, objects, a `world { ... }` that uses them, and lights";
            self.errors.push(Diagnostic::error(message).help(help));
            return;
        }
        // Pictures and archives have a 0 early on; without this they would be twenty unknown words.
        let beginning = &self.source.text[..self.source.text.len().min(512)];
        if let Some(at) = beginning.iter().position(|&byte| byte == 0) {
            return self.tell(Trouble::Mistake(not_text(0, Span::new(at, at + 1))));
        }
        while self.goes_on() {
            if let Err(trouble) = self.next() {
                self.tell(trouble);
                let is_in_object = !self.open_nodes.is_empty();
                self.recover(|word| if is_in_object { is_item(word) } else { is_statement(word) });
            }
        }
        if let Some((count, first)) = self.words.vanished {
            self.notices.note_many(Oddity::NumberVanished, count, first);
        }
    }

    /// Whether there is more to read, and sense in reading it. Tells of a block that the file's end cuts off.
    fn goes_on(&mut self) -> bool {
        if self.words.peek().kind == Kind::End && !self.open_blocks.is_empty() && !self.stopped {
            self.tell(Trouble::End("`}`".to_string()));
        }
        self.words.peek().kind != Kind::End && !self.stopped && self.errors.len() <= MOST_ERRORS
    }

    /// Reads a statement, an item of the innermost open object, or its end.
    fn next(&mut self) -> Result<(), Trouble> {
        let token = self.words.peek();
        if token.kind == Kind::Close {
            self.words.take();
            self.open_blocks.pop();
            if self.open_nodes.is_empty() && self.forgiven > 0 {
                self.forgiven -= 1;
                return Ok(());
            }
            return self.open_nodes.pop().map(|_| ()).ok_or_else(|| {
                let error = Diagnostic::error("a `}` that closes nothing").at(token.span, "no block is open here");
                error.help("remove it, or look for a `}` too many above").into()
            });
        }
        let token = self.words.expect_word("the scene", "a word that starts a statement")?;
        match self.open_nodes.last() {
            Some(&node) => self.item(token, node),
            None => self.statement(token),
        }
    }

    fn statement(&mut self, token: Token) -> Result<(), Trouble> {
        let word = self.words.bytes(token.span);
        self.check_text(word, token.span)?;
        let line = self.words.line(token.span);
        self.words.take();
        match word {
            b"shader" => self.shader(line),
            b"object" | b"world" => self.open_node(token.span, line),
            b"light" => self.light(line),
            b"camera" => self.camera(token.span, line),
            b"background" => self.background(token.span),
            b"two_sided" => self.two_sided(token.span),
            b"image" => self.image(token.span),
            _ => Err(unknown_statement(word, token.span).into()),
        }
    }

    /// Reads one item of the object `owner`.
    fn item(&mut self, token: Token, owner: u32) -> Result<(), Trouble> {
        let word = self.words.bytes(token.span);
        let is_statement_only = is_statement(word) && !is_item(word);
        if is_statement_only {
            // Objects cannot hold it: a `}` is missing above. Go on as if it stood here.
            self.not_closed(token.span);
            self.forgiven += self.open_nodes.len() - 1;
            self.open_blocks.clear();
            self.open_nodes.clear();
            return Ok(());
        }
        if is_transform(word) {
            let so_far = self.draft.nodes[owner as usize].parent_from_local;
            let transformed = self.transform(so_far)?;
            let node = &mut self.draft.nodes[owner as usize];
            (node.parent_from_local, node.is_transformed) = (transformed, true);
            return Ok(());
        }
        self.check_text(word, token.span)?;
        let line = self.words.line(token.span);
        self.words.take();
        match word {
            b"object" => return self.open_node(token.span, line),
            b"use" | b"copy" | b"clone" | b"import" => {
                let child = match word {
                    b"import" => self.import(token.span, line)?,
                    _ => self.reference(token.span, line)?,
                };
                self.draft.nodes[owner as usize].children.push(child);
            }
            b"billboard" | b"crossed" => {
                let child = self.standing(token.span, line)?;
                self.draft.nodes[owner as usize].children.extend(child);
            }
            b"surface" => {
                let surface = self.surface(token.span)?;
                self.draft.nodes[owner as usize].surfaces.push(surface);
            }
            _ if shape_parameters(word).is_some() => {
                let surface = self.shape(token.span, line)?;
                self.draft.nodes[owner as usize].surfaces.extend(surface);
            }
            _ => return Err(unknown_item(word, token.span).into()),
        }
        Ok(())
    }

    /// Reads `NAME {` of an object, or `{` of a world or an object without name.
    fn open_node(&mut self, keyword: Span, line: u32) -> Result<(), Trouble> {
        let is_world = self.words.bytes(keyword) == b"world";
        let parent = self.open_nodes.last().copied();
        let is_named = matches!(self.words.peek().kind, Kind::Word | Kind::Text | Kind::Unended);
        let name = match (parent, is_world, is_named) {
            (_, false, true) => self.words.name("an object")?,
            (None, false, false) => self.words.name("an object").map_err(|trouble| nameless(trouble, keyword))?,
            _ => Span::default(),
        };
        self.words.open(if is_world { "world" } else { "object" })?;
        let kind = match parent {
            Some(_) => NodeKind::Nested,
            None if is_world => NodeKind::World,
            None => NodeKind::Definition,
        };
        let node = self.add_node(draft::Node { kind, ..empty_node(name, keyword, line) });
        if let Some(parent) = parent {
            self.draft.nodes[parent as usize].children.push(node);
        }
        self.open_blocks.push(keyword);
        self.open_nodes.push(node);
        Ok(())
    }

    fn finish(mut self, source: &Source, checked: &check::Checked) -> Parsed {
        self.note_pictures_without_places(checked);
        if !self.draft.nodes.iter().any(|node| node.kind == NodeKind::World && node.has_content()) {
            let notice = Diagnostic::notice("nothing is drawn: the world is empty");
            self.notices.told.push(notice.help("objects are drawn where the world uses them: `world { use NAME }`"));
        }
        let default_camera = self.draft.camera.is_none().then(|| {
            let camera = statements::default_camera();
            crate::scene::Camera { resolution: self.draft.image.unwrap_or(camera.resolution), ..camera }
        });
        let scene = build::build(source, self.draft, checked);
        Parsed { scene, notices: Diagnostics::new(source, self.notices.list()), default_camera }
    }
}

fn is_item(word: &[u8]) -> bool {
    ITEM_WORDS.iter().any(|known| known.as_bytes() == word)
}

fn is_statement(word: &[u8]) -> bool {
    FILE_WORDS.iter().any(|known| known.as_bytes() == word)
}
