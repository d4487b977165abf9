//! Reads NFF, Eric Haines' Neutral File Format.
//!
//! Source -NFF (grammar, build)-> Scene
//!
//! Four parts: `grammar` says what stands where (`annotation`: in comments for farop), `build` what it means, `explain` what is wrong, and this loop goes
//! from statement to statement. After a mistake it goes on at the next keyword, so that one run tells up to
//! [`MOST_ERRORS`] of them.
//!
//! Lines are a convention in NFF: a statement ends where the next one starts. Source: E. Haines, NFF.TXT 3.9.

mod annotation;
mod build;
mod camera;
mod counts;
mod explain;
mod grammar;
mod nonsense;
mod notices;
mod weld;
mod wording;

use super::{ParseOptions, Parsed, tokens};
use crate::diagnostic::{Diagnostic, Diagnostics, Source, Span};
use crate::scene::Scene;
use annotation::Annotation;
use build::Builder;
pub(super) use camera::is_parallel;
use explain::Explain;
pub(super) use grammar::KEYWORDS;
use grammar::{Corners, Grammar};
use notices::Oddity;

/// How many errors of one file are told.
const MOST_ERRORS: usize = 20;

/// Reads a whole source.
///
/// # Errors
/// Up to [`MOST_ERRORS`] mistakes, and one that says there are more.
pub(super) fn read(source: &Source, options: ParseOptions) -> Result<Parsed, Diagnostics> {
    let mut errors = Vec::new();
    let reader = Reader::new(source, options);
    let (scene, notices) = reader.read(&mut errors);
    if errors.is_empty() {
        Ok(Parsed { scene, notices: Diagnostics::new(source, notices), default_camera: None })
    } else {
        Err(Diagnostics::new(source, errors))
    }
}

/// Goes through a source from statement to statement.
struct Reader<'a> {
    source: &'a Source,
    explain: Explain<'a>,
    grammar: Grammar,
    corners: Corners,
    builder: Builder,
    /// Behind the first object, views and lights are too late.
    first_object: Option<Span>,
    /// What a `#farop` line says about the statement behind it, and where.
    annotation: Option<(Annotation, Span)>,
    /// The line of the last statement, if it was an `f`: what other readers take for a texture follows on it.
    line_of_surface: Option<u32>,
}

impl<'a> Reader<'a> {
    fn new(source: &'a Source, options: ParseOptions) -> Self {
        Reader {
            source,
            explain: Explain { text: &source.text, source },
            grammar: Grammar::default(),
            corners: Corners::default(),
            builder: Builder::new(&source.name, options),
            first_object: None,
            annotation: None,
            line_of_surface: None,
        }
    }

    fn read(mut self, errors: &mut Vec<Diagnostic>) -> (Scene, Vec<Diagnostic>) {
        let mut tail = tokens::skip_space(&self.source.text);
        if tail.is_empty() {
            errors.push(self.explain.empty_file());
        }
        if let Some(refusal) = self.explain.not_nff(tail) {
            errors.push(refusal);
            tail = &[];
        }
        let mut lines = self.source.lines();
        while !tail.is_empty() {
            let keyword = self.explain.span_of_word(tail);
            let line = lines.at(keyword.start);
            match self.statement(tail, keyword, line, errors) {
                Some(rest) => tail = tokens::skip_space(rest),
                None => break,
            }
            if errors.len() >= MOST_ERRORS && !tail.is_empty() {
                errors.truncate(MOST_ERRORS);
                let stopped = format!("too many errors: stopped after {MOST_ERRORS}, at line {line}");
                errors.push(Diagnostic::error(stopped));
                break;
            }
        }
        self.check_annotation(&[], None, errors);
        self.finish()
    }

    /// Reads one statement and returns the tail behind it; `None` when it is no use to go on.
    fn statement(
        &mut self,
        tail: &'a [u8],
        keyword: Span,
        line: u32,
        errors: &mut Vec<Diagnostic>,
    ) -> Option<&'a [u8]> {
        let word = tokens::word(tail);
        self.builder.annotation = self.check_annotation(word, Some(keyword), errors);
        if word == annotation::WORD {
            self.line_of_surface = None;
            return Some(self.annotation(tail, keyword, errors));
        }
        let Some(result) = self.grammar.statement(word, &tail[word.len()..], &mut self.corners) else {
            let error = self.explain.unknown_keyword(tail, self.line_of_surface == Some(line));
            let is_text = error.is_ok();
            errors.push(error.unwrap_or_else(|binary| binary));
            return is_text.then(|| next_keyword(&tail[word.len()..]));
        };
        self.line_of_surface = (word == b"f").then_some(line);
        self.check_order(word, keyword, errors);
        let rest = match result {
            Ok((rest, statement)) => {
                let rest = tokens::skip_space(rest);
                if tokens::looks_numeric(tokens::word(rest)) {
                    errors.push(self.explain.too_many(tail, rest, &self.corners));
                    return Some(next_keyword(rest));
                }
                if let Err(nonsense) = self.builder.add(statement, &mut self.corners, (keyword, line)) {
                    errors.push(self.explain.nonsense(tail, &nonsense));
                }
                rest
            }
            Err(nom::Err::Error(mismatch) | nom::Err::Failure(mismatch)) => {
                let rest = &self.source.text[self.source.text.len() - mismatch.tail_length..];
                let error = self.explain.mismatch(tail, mismatch, &self.corners);
                let is_text = error.is_ok();
                errors.push(error.unwrap_or_else(|binary| binary));
                return is_text.then(|| next_keyword(rest));
            }
            Err(nom::Err::Incomplete(_)) => &[],
        };
        Some(rest)
    }

    /// Reads a `#farop` line, which ends with the line, and returns the tail behind it.
    fn annotation(&mut self, tail: &'a [u8], keyword: Span, errors: &mut Vec<Diagnostic>) -> &'a [u8] {
        let end = tail.iter().position(|&byte| byte == b'\n' || byte == b'\r').unwrap_or(tail.len());
        match Annotation::read(&tail[..end]) {
            Ok(annotation) => self.annotation = Some((annotation, keyword)),
            Err(mistake) => {
                let span = self.explain.span_of_word(tokens::nth_word(tail, mistake.word));
                errors.push(Diagnostic::error(mistake.message).at(span, "").help(mistake.help));
            }
        }
        &tail[end..]
    }

    /// The annotation for a statement that starts with `word` (none: the end of the file), if there is one and it belongs there.
    fn check_annotation(
        &mut self,
        word: &[u8],
        statement: Option<Span>,
        errors: &mut Vec<Diagnostic>,
    ) -> Option<Annotation> {
        let (annotation, span) = self.annotation.take()?;
        let (keyword, name) = annotation.belongs_to();
        if word == keyword {
            return Some(annotation);
        }
        let keyword = crate::parse::wording::plain(keyword);
        let error = Diagnostic::error(format!("`{name}` belongs to the `{keyword}` behind it, but none follows"));
        let error = error.at(span, "belongs to nothing").help(format!("put it right before an `{keyword}`"));
        errors.push(match statement {
            Some(statement) => error.at(statement, "this follows"),
            None => error,
        });
        None
    }

    /// Views and lights stand before all objects.
    fn check_order(&mut self, keyword: &[u8], span: Span, errors: &mut Vec<Diagnostic>) {
        let is_object = matches!(keyword, b"p" | b"pp" | b"s" | b"c");
        match (keyword, self.first_object) {
            (b"v" | b"l", Some(object)) => errors.push(self.explain.too_late(keyword, span, object)),
            (_, None) if is_object => self.first_object = Some(span),
            _ => {}
        }
    }

    fn finish(mut self) -> (Scene, Vec<Diagnostic>) {
        if let Some((count, tail_length)) = self.grammar.vanished.get() {
            let first = self.explain.span_of_word(&self.source.text[self.source.text.len() - tail_length..]);
            self.builder.notices.note_many(Oddity::NumberVanished, count, first);
        }
        let (scene, notices) = self.builder.finish();
        (scene, notices.list())
    }
}

/// The tail from the next keyword on; empty if there is none.
fn next_keyword(tail: &[u8]) -> &[u8] {
    let mut rest = tokens::skip_space(tail);
    loop {
        let word = tokens::word(rest);
        if word.is_empty() || is_keyword(word) {
            return rest;
        }
        rest = tokens::skip_space(&rest[word.len()..]);
    }
}

fn is_keyword(word: &[u8]) -> bool {
    word == annotation::WORD || KEYWORDS.iter().any(|keyword| keyword.as_bytes() == word)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Vec3;
    use crate::parse::{Winding, read_nff};
    use crate::scene::{NormalSource, Shape};

    fn read(text: &str) -> Scene {
        read_with(text, ParseOptions::default())
    }

    fn read_with(text: &str, options: ParseOptions) -> Scene {
        read_nff("folder/scene.nff", text.as_bytes(), options).expect("legal").scene
    }

    #[test]
    fn a_file_is_one_object_with_a_surface_for_each_f_that_shows_something() {
        let triangle = "p 3 0 0 0 1 0 0 1 1 0\n";
        let scene =
            read(&format!("{triangle}# gap\n\nf 1 0 0 .5 .2 3 .25 1\nf 0 1 0 1 0 0 0 1\ns 1 2 3 4\n{triangle}"));
        assert_eq!((scene.world.len(), scene.objects.len(), scene.surfaces.len()), (1, 1, 2));
        assert_eq!(scene.objects[0].name, "scene.nff");
        assert_eq!(scene.objects[0].surfaces.len(), 2);
        assert_eq!(scene.surfaces[0].material, crate::scene::Material::default());
        assert_eq!(scene.describe(scene.surfaces[1].place), "folder/scene.nff:5");
        assert_eq!(scene.surfaces[1].mesh.polygons[0].line, 7);
        assert_eq!(scene.surfaces[1].primitives[0].before, 0);
        let material = read(&format!("f 1 0 0 .5 .2 3 .25 1 {triangle}")).surfaces[0].material;
        assert_eq!((material.opacity.r, material.diffuse, material.specular, material.shine), (0.75, 0.5, 0.2, 3.0));
        assert!(read("b 0 0 1").objects.is_empty());
    }

    #[test]
    fn statements_need_no_lines() {
        let scene = read(
            "v from 0 -5 1 at 0 0 0 up 0 0 1 angle 40 hither 1 resolution 64 48 b 0 0 1 l 1 2 3 l 1 2 3\n.5 1 2 c\n0 0 0 1\n0 0 1 1",
        );
        assert_eq!(scene.camera.map(|camera| camera.resolution), Some((64, 48)));
        assert_eq!(scene.lights.iter().map(|light| light.color.r).collect::<Vec<_>>(), [1.0, 0.5]);
        assert_eq!(scene.surfaces[0].primitives.len(), 1);
    }

    #[test]
    fn vertices_are_shared_within_a_surface_only() {
        let square = "p 3 0 0 0 1 0 0 1 1 0 p 3 0 0 0 1 1 0 0 1 0 ";
        let scene = read(&format!("{square} f 1 1 1 1 0 0 0 0 {square}"));
        let counts: Vec<usize> = scene.surfaces.iter().map(|surface| surface.mesh.vertices.len()).collect();
        assert_eq!(counts, [4, 4]);
        assert_eq!(scene.surfaces[1].mesh.outlines, [0, 1, 2, 0, 2, 3]);
    }

    #[test]
    fn normals_become_unit_and_unit_ones_keep_their_bits() {
        let near_unit = [0.6, 0.0, 0.8f64.next_down()];
        let normals = [near_unit, [0.0, 0.0, 5.0], [0.0, 0.0, 0.0]];
        let corner = |i: usize| format!("{} {} 0 {} {} {} ", i % 2, i / 2, normals[i][0], normals[i][1], normals[i][2]);
        let mesh = &read(&format!("pp 3 {}{}{}", corner(0), corner(1), corner(2))).surfaces[0].mesh;
        assert_eq!(mesh.polygons[0].normals, NormalSource::Given);
        assert_eq!(mesh.normals, [Vec3::from_array(near_unit), Vec3::Z, Vec3::ZERO]);
    }

    #[test]
    fn winding_follows_the_normals_when_asked_to() {
        let upside_down = "pp 3 0 0 0 0 0 -1 1 0 0 0 0 -1 1 1 0 0 0 -1 ";
        let auto = ParseOptions { winding: Winding::Auto, ..ParseOptions::default() };
        let outline = |options| {
            let scene = read_with(upside_down, options);
            let mesh = &scene.surfaces[0].mesh;
            mesh.outlines.iter().map(|&index| mesh.vertices[index as usize].truncate().to_array()).collect::<Vec<_>>()
        };
        assert_eq!(outline(ParseOptions::default()), [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]);
        assert_eq!(outline(auto), [[0.0, 0.0], [1.0, 1.0], [1.0, 0.0]]);
    }

    #[test]
    fn polygons_can_be_smooth() {
        let options = ParseOptions { polygon_normals: NormalSource::Averaged, ..ParseOptions::default() };
        let scene = read_with("p 3 0 0 0 1 0 0 1 1 0", options);
        assert_eq!(scene.surfaces[0].mesh.polygons[0].normals, NormalSource::Averaged);
    }

    #[test]
    fn negative_radii_show_the_inside() {
        let scene = read("s 1 2 3 -4 c 0 0 0 -2 0 0 1 -1 c 0 0 0 -2 0 0 1 0");
        let primitives = &scene.surfaces[0].primitives;
        assert!(primitives.iter().all(|primitive| primitive.inside));
        assert_eq!(primitives[0].shape, Shape::Sphere { center: Vec3::new(1.0, 2.0, 3.0), radius: 4.0 });
        let (base, apex) = (Vec3::ZERO, Vec3::Z);
        assert_eq!(primitives[1].shape, Shape::Cone { base, base_radius: 2.0, apex, apex_radius: 1.0 });
    }

    #[test]
    fn the_last_view_counts() {
        let view = |angle: u32| format!("v from 0 -5 1 at 0 0 0 up 0 0 1 angle {angle} hither 1 resolution 64 64 ");
        let scene = read(&format!("{}{}", view(30), view(50)));
        assert_eq!(scene.camera.map(|camera| camera.angle), Some(50.0));
    }

    /// Polygons, spheres and cones of files that others wrote.
    #[test]
    fn the_standard_procedural_databases_are_read_whole() {
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/data/spd");
        let expected = [
            ("balls-s2-t.nff.gz", 9829, 0),
            ("gears-s4.nff.gz", 9345, 0),
            ("mount-s4-c.nff", 512, 4),
            ("nurbtst-def.nff", 1500, 0),
            ("rings-s2-c.nff", 1, 300),
            ("sample-c.nff", 880, 1),
            ("teapot-s12.nff.gz", 9264, 0),
        ];
        for (name, polygons, primitives) in expected {
            let path = folder.join(name);
            if !path.exists() {
                println!("not here, not compared: {}", path.display());
                continue;
            }
            let scene = crate::parse::load(&path, None, ParseOptions::default()).expect(name).scene;
            let sum = |count: fn(&crate::scene::Surface) -> usize| scene.surfaces.iter().map(count).sum::<usize>();
            assert_eq!(sum(|surface| surface.mesh.polygons.len()), polygons, "{name}");
            assert_eq!(sum(|surface| surface.primitives.len()), primitives, "{name}");
            assert!(scene.camera.is_some());
        }
    }
}
