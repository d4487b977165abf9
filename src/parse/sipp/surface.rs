//! `surface SHADER { ... }`: polygons over a list of vertices, or with vertices written in place.
//!
//! words -SURFACE-> Mesh
//!
//! The list (`v`) is kept as it stands; vertices written in place are welded, SIPP's way. Polygons may stand above the
//! vertices they name, so indices are only looked at when the block ends.
//!
//! Space: local; counterclockwise seen from the front. Cost: one look-up a vertex in place.

use super::Reader;
use super::block::with_suggestion;
use super::draft::RawSurface;
use super::notices::Oddity;
use super::trouble::Trouble;
use super::vocabulary::{FILE_WORDS, ITEM_WORDS, SURFACE_WORDS};
use super::weld::{Vertex, Weld};
use super::words::Kind;
use crate::diagnostic::{Diagnostic, Span};
use crate::math::Vec3;
use crate::parse::area::{is_collinear, unit_normal};
use crate::parse::tokens;
use crate::parse::wording::quote;
use crate::scene::{Mesh, NormalSource};

/// A surface as far as it was read.
#[derive(Default)]
struct Draft {
    list: Vec<Vertex>,
    welded: Weld,
    polygons: Vec<RawPolygon>,
    /// Corners of all polygons: places in the list or among the welded.
    corners: Vec<u32>,
    two_sided: Option<bool>,
    is_clockwise: bool,
}

/// A polygon as it was read.
struct RawPolygon {
    start: u32,
    count: u32,
    keyword: Span,
    line: u32,
    normals: NormalSource,
    /// Corners are places in the list; else among the welded.
    by_index: bool,
}

impl Reader<'_> {
    /// Reads a surface and puts it into the draft.
    pub(super) fn surface(&mut self, keyword: Span) -> Result<u32, Trouble> {
        let shader = self.words.name("a shader")?;
        self.words.open("surface NAME")?;
        self.open_blocks.push(keyword);
        let mut draft = Draft::default();
        while self.goes_on() && self.words.take_if(Kind::Close).is_none() {
            match self.surface_item(&mut draft) {
                Ok(true) => {}
                Ok(false) => break,
                Err(trouble) => {
                    self.tell(trouble);
                    self.recover(|word| SURFACE_WORDS.iter().any(|known| known.as_bytes() == word));
                }
            }
        }
        self.open_blocks.pop();
        let two_sided = draft.two_sided;
        let mesh = self.mesh(draft);
        self.draft.surfaces.push(RawSurface { shader, mesh, primitive: None, two_sided, picture: None });
        Ok(self.draft.surfaces.len() as u32 - 1)
    }

    /// Reads one item; `false` when the surface was probably meant to end before it.
    fn surface_item(&mut self, draft: &mut Draft) -> Result<bool, Trouble> {
        let token = self.words.expect_word("`surface`", "`v`, `polygon` or `facet`")?;
        let word = self.words.bytes(token.span);
        let is_of_surface = SURFACE_WORDS.iter().any(|known| known.as_bytes() == word);
        if !is_of_surface && FILE_WORDS.iter().chain(ITEM_WORDS).any(|known| known.as_bytes() == word) {
            self.not_closed(token.span);
            return Ok(false);
        }
        self.check_text(word, token.span)?;
        self.words.take();
        match word {
            b"v" => {
                let vertex = self.vertex()?;
                draft.list.push(vertex);
                self.no_number_more("a vertex is `v X Y Z`, then `n X Y Z` and `t U V W` if it has them")?;
            }
            b"polygon" => self.polygon(draft, token.span, NormalSource::Averaged)?,
            b"facet" => self.polygon(draft, token.span, NormalSource::Facet)?,
            b"two_sided" => draft.two_sided = Some(self.on_off("two_sided")?),
            b"winding" => draft.is_clockwise = self.winding()?,
            _ if tokens::looks_numeric(word) => {
                let error =
                    Diagnostic::error("a number too many in this `surface`").at(token.span, "belongs to nothing");
                return Err(error.help("indices and vertices of a polygon stand between its braces").into());
            }
            _ => {
                let error =
                    Diagnostic::error(format!("`surface` has no {}", quote(word))).at(token.span, "not known here");
                return Err(with_suggestion(error, word, SURFACE_WORDS).into());
            }
        }
        Ok(true)
    }

    fn winding(&mut self) -> Result<bool, Trouble> {
        let token = self.words.expect_word("`winding`", "`ccw` or `cw`")?;
        let word = self.words.bytes(token.span);
        if word != b"ccw" && word != b"cw" {
            let error = Diagnostic::error(format!("{} is no winding", quote(word)));
            let error = error.at(token.span, "expected `ccw` or `cw`");
            return Err(error.help("counterclockwise or clockwise, seen from the front").into());
        }
        self.words.take();
        Ok(word == b"cw")
    }

    /// What stands behind a `v`.
    fn vertex(&mut self) -> Result<Vertex, Trouble> {
        let mut vertex = Vertex { position: self.words.vector("`v X Y Z`")?, ..Vertex::default() };
        if self.words.is_next("n") {
            let span = self.words.take().span;
            let normal = self.words.vector("`n X Y Z`")?;
            vertex.normal = unit_normal(normal);
            if vertex.normal == Vec3::ZERO {
                self.notices.note(Oddity::ZeroNormal, span);
            }
        }
        if self.words.take_word("t") {
            vertex.texture = Some(self.words.vector("`t U V W`")?);
        }
        Ok(vertex)
    }

    fn no_number_more(&self, help: &'static str) -> Result<(), Trouble> {
        if !self.words.is_number_next() {
            return Ok(());
        }
        let span = self.words.peek().span;
        Err(Diagnostic::error("a number too many").at(span, "belongs to nothing").help(help).into())
    }

    fn polygon(&mut self, draft: &mut Draft, keyword: Span, normals: NormalSource) -> Result<(), Trouble> {
        let line = self.words.line(keyword);
        let name = if normals == NormalSource::Facet { "facet" } else { "polygon" };
        self.words.open(name)?;
        self.open_blocks.push(keyword);
        let start = draft.corners.len();
        let by_index = !self.words.is_next("v");
        let corners = self.corners(draft, by_index, name);
        self.open_blocks.pop();
        if let Err(trouble) = corners {
            self.tell(trouble);
            self.skip_to_close();
            return Ok(());
        }
        let count = draft.corners.len() - start;
        if count < 3 {
            let error = Diagnostic::error(format!("a {name} has at least 3 corners, this one has {count}"));
            return Err(error.at(keyword, "too few").help("add the missing corners, or remove it").into());
        }
        if draft.is_clockwise {
            // The first vertex stays the first: it gives the color of flat shading.
            draft.corners[start + 1..].reverse();
        }
        let (start, count) = (start as u32, count as u32);
        draft.polygons.push(RawPolygon { start, count, keyword, line, normals, by_index });
        Ok(())
    }

    /// Reads corners up to and including the `}`.
    fn corners(&mut self, draft: &mut Draft, by_index: bool, name: &str) -> Result<(), Trouble> {
        while self.words.take_if(Kind::Close).is_none() {
            let wanted = if by_index { "an index" } else { "`v X Y Z`" };
            let token = self.words.expect_word(&format!("`{name}`"), wanted)?;
            if by_index && !self.words.is_next("v") {
                let number = self.words.number(&format!("`{name}`: indices or vertices `v X Y Z`"))?;
                draft.corners.push(self.index(number, token.span)?);
            } else if !by_index && self.words.take_word("v") {
                let vertex = self.vertex()?;
                draft.corners.push(draft.welded.index(vertex));
            } else {
                let word = self.words.bytes(token.span);
                let message = format!("{} among the corners of a `{name}`", quote(word));
                let error = Diagnostic::error(message).at(token.span, format!("expected {wanted}"));
                return Err(error.help("corners are all indices, or all vertices `v X Y Z`").into());
            }
        }
        Ok(())
    }

    /// A place in a list that counts from 1, here from 0.
    pub(super) fn index(&self, number: f64, span: Span) -> Result<u32, Trouble> {
        if number.fract() == 0.0 && (1.0..=f64::from(u32::MAX)).contains(&number) {
            return Ok(number as u32 - 1);
        }
        let word = quote(self.words.bytes(span));
        let error = Diagnostic::error(format!("{word} is no index")).at(span, "expected a whole number from 1 up");
        Err(error.help("vertices are counted from 1, in the order of their `v`").into())
    }

    /// The mesh of a whole surface; mistakes are told.
    fn mesh(&mut self, draft: Draft) -> Mesh {
        let in_list = draft.list.len() as u32;
        let vertices: Vec<Vertex> = draft.list.into_iter().chain(draft.welded.vertices).collect();
        let mut mesh = Mesh { vertices: vertices.iter().map(|vertex| vertex.position).collect(), ..Mesh::default() };
        if vertices.iter().any(|vertex| vertex.normal != Vec3::ZERO) {
            mesh.normals = vertices.iter().map(|vertex| vertex.normal).collect();
        }
        if vertices.iter().any(|vertex| vertex.texture.is_some()) {
            mesh.texture = vertices.iter().map(|vertex| vertex.texture.unwrap_or_default()).collect();
        }
        let mut positions = Vec::new();
        for polygon in &draft.polygons {
            let corners = &draft.corners[polygon.start as usize..][..polygon.count as usize];
            if let Some(&missing) = corners.iter().find(|&&corner| polygon.by_index && corner >= in_list) {
                self.tell(self.no_such_vertex(polygon, missing, in_list));
                continue;
            }
            let first = if polygon.by_index { 0 } else { in_list };
            let outline: Vec<u32> = corners.iter().map(|corner| corner + first).collect();
            positions.clear();
            positions.extend(outline.iter().map(|&index| mesh.vertices[index as usize]));
            if is_collinear(&positions) {
                self.notices.note(Oddity::NoArea, polygon.keyword);
                continue;
            }
            mesh.push_polygon(&outline, polygon.normals, polygon.line);
        }
        mesh
    }

    fn no_such_vertex(&self, polygon: &RawPolygon, missing: u32, in_list: u32) -> Trouble {
        let message = format!("there is no vertex {} in this surface", u64::from(missing) + 1);
        let error = Diagnostic::error(message).at(polygon.keyword, "used here");
        error
            .help(match in_list {
                0 => "this surface has no list of vertices: write `v X Y Z` above, or the corners in place".to_string(),
                1 => "this surface lists 1 vertex".to_string(),
                _ => format!("this surface lists {in_list} vertices, counted from 1"),
            })
            .into()
    }
}
