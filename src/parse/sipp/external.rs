//! What a `.sipp` scene takes from elsewhere: NFF files, built-in scenes, Bezier files.
//!
//! Names are relative to the folder of the `.sipp` file. Only NFF can be imported, and NFF imports nothing: files cannot go round
//! in circles. A file that is imported several times is read once, and its objects are shared.

use super::Reader;
use super::trouble::Trouble;
use crate::diagnostic::{Diagnostic, Diagnostics, Severity, Span, printable};
use crate::parse::bezier::{self, Net};
use crate::parse::wording::plain;
use crate::parse::{Parsed, built_in, load};
use crate::scene::{Scene, Shape};
use crate::spd::Curves;
use std::path::PathBuf;
use std::sync::Arc;

/// How many different files one scene may import: places count files with 16 bits.
const MOST_IMPORTS: usize = 10_000;

impl Reader<'_> {
    /// Index of the scene in that file, which is read if it was not yet.
    pub(super) fn imported(&mut self, file: Span) -> Result<u32, Trouble> {
        let name = self.words.bytes(file);
        if let Some(&known) = self.imports.get(name) {
            return Ok(known);
        }
        if self.imports.len() >= MOST_IMPORTS {
            let error = Diagnostic::error(format!("a scene imports at most {MOST_IMPORTS} files"));
            return Err(error
                .at(file, "one more")
                .help("join some of them: `farop convert a.nff b.nff -o ab.nff`")
                .into());
        }
        let parsed = match name.strip_prefix(b"spd:") {
            Some(built_in) => self.built_in(built_in, file)?,
            None => self.nff_file(file)?,
        };
        for notice in &parsed.notices.list {
            let message = format!("in `{}`: {}", plain(name), notice.message);
            self.notices.told.push(Diagnostic::notice(message).at(file, "imported here"));
        }
        let scene = self.without_view(parsed.scene, file);
        self.draft.imports.push(scene);
        let index = self.draft.imports.len() as u32 - 1;
        self.imports.insert(name, index);
        Ok(index)
    }

    fn built_in(&self, name: &[u8], file: Span) -> Result<Parsed, Trouble> {
        let name = printable(name);
        let text = built_in::text(&name, Curves::Kept).map_err(|message| {
            let (message, help) = message.split_once("; ").unwrap_or((&message, "`farop list scenes` names them"));
            Diagnostic::error(message).at(file, "imported here").help(help)
        })?;
        let parsed = crate::parse::read_nff(&format!("spd:{name}"), &text, self.options);
        parsed.map_err(|errors| refused(&errors, file, "an import").into())
    }

    fn nff_file(&self, file: Span) -> Result<Parsed, Trouble> {
        let path = self.path(file);
        match load::Format::of_path(&path) {
            Some(load::Format::Nff) | None => {}
            Some(other) => {
                let kind = load::Format::ALL.iter().find(|(_, format)| *format == other).map_or("", |&(name, _)| name);
                let error = Diagnostic::error("only NFF can be imported").at(file, format!("this is a `.{kind}` file"));
                let help = "give both files to farop: they merge. Or `farop convert` this one to NFF first";
                return Err(error.help(help).into());
            }
        }
        // What `--normals` and `--winding` say holds for NFF wherever it comes from.
        load::load(&path, Some(load::Format::Nff), self.options)
            .map_err(|errors| refused(&errors, file, "an import").into())
    }

    /// Lights, camera and background of an import are left out, with a notice.
    fn without_view(&mut self, mut scene: Scene, file: Span) -> Scene {
        let left_out: Vec<&str> = [
            (!scene.lights.is_empty(), "lights"),
            (scene.camera.is_some(), "camera"),
            (scene.background.is_some(), "background"),
        ]
        .into_iter()
        .filter_map(|(is_there, what)| is_there.then_some(what))
        .collect();
        if !left_out.is_empty() {
            let name = plain(self.words.bytes(file));
            let message = format!("the {} of `{name}` are left out: an import is objects alone", left_out.join(", "));
            self.notices.told.push(Diagnostic::notice(message).at(file, "imported here"));
        }
        (scene.lights, scene.camera, scene.background) = (Vec::new(), None, None);
        scene
    }

    /// Reads a Bezier file.
    pub(super) fn bezier_file(&self, file: Span) -> Result<Shape, Trouble> {
        let path = self.path(file);
        let source = load::source(&path).map_err(|errors| refused(&errors, file, "a Bezier file"))?;
        match bezier::read(&source).map_err(|errors| refused(&errors, file, "a Bezier file"))? {
            Net::Patches(net) => Ok(Shape::Patches(Arc::new(net))),
            Net::Curves(net) => Ok(Shape::Curves(Arc::new(net))),
        }
    }

    pub(super) fn path(&self, file: Span) -> PathBuf {
        let name = self.words.bytes(file);
        self.folder.join(&*String::from_utf8_lossy(name))
    }
}

/// What is wrong with another file, told where this one names it.
fn refused(errors: &Diagnostics, file: Span, what: &str) -> Diagnostic {
    let mistakes = errors.list.iter().filter(|error| error.severity == Severity::Error);
    let Some(first) = mistakes.clone().next() else { return Diagnostic::error("not read").at(file, "") };
    let Some(place) = errors.place(first) else {
        // Not there, no folder, no permission: the message names the file.
        let error = Diagnostic::error(first.message.clone()).at(file, "named here");
        return if let Some(help) = &first.help { error.help(help.clone()) } else { error };
    };
    let error = Diagnostic::error(format!("{what} has a mistake: {}", first.message)).at(file, format!("at {place}"));
    match (&first.help, mistakes.count() - 1) {
        (Some(help), 0) => error.help(help.clone()),
        (None, 0) => error,
        (_, more) => error.help(format!("and {more} more in the same file")),
    }
}
