//! Which shader or object a name means.
//!
//! Objects at the level of the file have names of their own. Nested objects may share names (two arms, two hands), as long
//! as nobody uses one by a name that means several.

use super::draft::{Draft, NodeKind};
use crate::diagnostic::{Diagnostic, Source, Span, suggest};
use crate::parse::wording::quote;
use std::collections::HashMap;
use std::collections::hash_map::Entry;

/// How many names are looked through for a similar one.
const MOST_COMPARED: usize = 10_000;

/// All names of a file. Only looked up, never walked.
pub(super) struct Names<'a> {
    source: &'a Source,
    draft: &'a Draft,
    shaders: HashMap<&'a [u8], u32>,
    definitions: HashMap<&'a [u8], u32>,
    nested: HashMap<&'a [u8], Nested>,
}

/// Nested objects of one name.
#[derive(Clone, Copy)]
struct Nested {
    first: u32,
    second: Option<u32>,
}

impl<'a> Names<'a> {
    /// Collects all names; those that stand for two things are told in `errors`.
    pub fn new(source: &'a Source, draft: &'a Draft, errors: &mut Vec<Diagnostic>) -> Names<'a> {
        let (shaders, definitions, nested) = (HashMap::new(), HashMap::new(), HashMap::new());
        let mut names = Names { source, draft, shaders, definitions, nested };
        for (index, shader) in draft.shaders.iter().enumerate() {
            match names.shaders.entry(bytes(source, shader.name)) {
                Entry::Vacant(entry) => _ = entry.insert(index as u32),
                Entry::Occupied(entry) => {
                    let first = draft.shaders[*entry.get() as usize].name;
                    errors.push(names.twice("shaders", shader.name, first));
                }
            }
        }
        for (index, node) in draft.nodes.iter().enumerate().filter(|(_, node)| node.name != Span::default()) {
            let (name, index) = (bytes(source, node.name), index as u32);
            match node.kind {
                NodeKind::Definition => match names.definitions.entry(name) {
                    Entry::Vacant(entry) => _ = entry.insert(index),
                    Entry::Occupied(entry) => {
                        let first = draft.nodes[*entry.get() as usize].name;
                        errors.push(names.twice("objects", node.name, first));
                    }
                },
                NodeKind::Nested => match names.nested.entry(name) {
                    Entry::Vacant(entry) => _ = entry.insert(Nested { first: index, second: None }),
                    Entry::Occupied(mut entry) => entry.get_mut().second = entry.get().second.or(Some(index)),
                },
                NodeKind::World | NodeKind::Facing | NodeKind::Reference { .. } | NodeKind::Import(_) => {}
            }
        }
        names
    }

    /// Index of the shader called so.
    pub fn shader(&self, name: Span) -> Result<u32, Diagnostic> {
        let known = self.shaders.get(bytes(self.source, name)).copied();
        known.ok_or_else(|| {
            let shaders = self.draft.shaders.iter().map(|shader| shader.name);
            self.unknown("shader", name, shaders).help_if_none("write one: `shader NAME phong { color 1 0 0 }`")
        })
    }

    /// Index of the object called so.
    pub fn object(&self, name: Span) -> Result<u32, Diagnostic> {
        let text = bytes(self.source, name);
        if let Some(&definition) = self.definitions.get(text) {
            return Ok(definition);
        }
        match self.nested.get(text) {
            Some(Nested { first, second: None }) => Ok(*first),
            Some(Nested { first, second: Some(second) }) => {
                let place = |index: &u32| self.draft.nodes[*index as usize].name;
                Err(Diagnostic::error(format!("{} means several objects", quote(text)))
                    .at(name, "which one?")
                    .at(place(first), "this one")
                    .at(place(second), "or this one")
                    .help("give the one that is meant a name of its own"))
            }
            None => {
                let objects = self.draft.nodes.iter();
                let objects =
                    objects.filter(|node| matches!(node.kind, NodeKind::Definition | NodeKind::Nested)).map(|n| n.name);
                let error = self.unknown("object", name, objects.filter(|&name| name != Span::default()));
                Err(error.help_if_none("write it: `object NAME { ... }`"))
            }
        }
    }

    fn twice(&self, what: &str, again: Span, first: Span) -> Diagnostic {
        Diagnostic::error(format!("two {what} are called {}", quote(bytes(self.source, again))))
            .at(again, "again")
            .at(first, "first here")
            .help("rename one of them")
    }

    fn unknown(&self, what: &str, name: Span, known: impl Iterator<Item = Span>) -> Diagnostic {
        let text = bytes(self.source, name);
        let known = known.take(MOST_COMPARED).filter_map(|name| str::from_utf8(bytes(self.source, name)).ok());
        let known: Vec<&str> = known.collect();
        let error = Diagnostic::error(format!("there is no {what} {}", quote(text))).at(name, "not defined");
        let wanted = String::from_utf8_lossy(text);
        match (suggest(&wanted, &known), known.len()) {
            (Some(similar), _) => error.help(format!("did you mean `{similar}`?")),
            (None, 0) => error,
            (None, 1..=8) => error.help(format!("there is {}", known.join(", "))),
            (None, count) => error.help(format!("there are {count}: {}, ...", known[..8].join(", "))),
        }
    }
}

trait HelpIfNone {
    fn help_if_none(self, help: &str) -> Diagnostic;
}

impl HelpIfNone for Diagnostic {
    fn help_if_none(self, help: &str) -> Diagnostic {
        if self.help.is_some() { self } else { self.help(help) }
    }
}

/// The text of a span.
pub(super) fn bytes(source: &Source, span: Span) -> &[u8] {
    &source.text[span.start as usize..span.end as usize]
}
