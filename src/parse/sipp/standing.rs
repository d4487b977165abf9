//! Standing pictures: `billboard "tree.png" 5 8`, which turns to the camera, and `crossed`, two pictures square to each other.
//!
//! Both stand on the origin along z, as wide as they say, and show their picture as it is, in any light. What is not there (alpha, or the color of
//! `key`) is no part of them: neither color nor depth.
//!
//! Space: local, z up; u to the right, v upward. Source: D. Caralo's billboards, with what they had wrong put right: not mirrored, not half underground,
//! not transparent where they hide.

use super::Reader;
use super::block::Block;
use super::draft::{Node, NodeKind, RawSurface};
use super::empty_node;
use super::textures::key_of;
use super::trouble::Trouble;
use super::vocabulary::STANDING;
use super::words::Kind;
use crate::diagnostic::{Diagnostic, Span};
use crate::image::textures::Wrap;
use crate::math::Vec3;
use crate::parse::wording::plain;
use crate::scene::{CutOut, Mesh, NormalSource};

impl Reader<'_> {
    /// Reads what stands behind the keyword; the node that was made of it, or `None` when a mistake in its block was told.
    pub(super) fn standing(&mut self, keyword: Span, line: u32) -> Result<Option<u32>, Trouble> {
        let word = plain(self.words.bytes(keyword));
        let is_crossed = word == "crossed";
        let image = match self.words.peek().kind {
            Kind::Text => self.words.text("a picture")?,
            _ => self.words.name("a picture, such as \"tree.png\"")?,
        };
        let (width, height) = (self.extent(&word, "WIDTH")?, self.extent(&word, "HEIGHT")?);
        let block = match self.words.peek().kind {
            Kind::Open => self.block(keyword, line, &[STANDING])?,
            _ => Block { keyword, line, given: Vec::new(), broken: false },
        };
        if block.broken {
            return Ok(None);
        }
        let cut_out = CutOut { threshold: block.number("cutout").unwrap_or(CutOut::default().threshold) };
        let texture = self.picture(image, (key_of(&block), Some(cut_out), Wrap::Clamp))?;
        let mut mesh = Mesh::default();
        upright(&mut mesh, Vec3::X * width, height, line);
        if is_crossed {
            upright(&mut mesh, Vec3::Y * width, height, line);
        }
        let (shader, two_sided, picture) = (Span::default(), Some(true), Some(texture));
        self.draft.surfaces.push(RawSurface { shader, mesh, primitive: None, two_sided, picture });
        let surfaces = vec![self.draft.surfaces.len() as u32 - 1];
        let kind = if is_crossed { NodeKind::Nested } else { NodeKind::Facing };
        Ok(Some(self.add_node(Node { kind, surfaces, ..empty_node(Span::default(), keyword, line) })))
    }

    fn extent(&mut self, word: &str, what: &str) -> Result<f64, Trouble> {
        let span = self.words.peek().span;
        let number = self.words.number(&format!("`{word} \"FILE\" WIDTH HEIGHT`"))?;
        if number > 0.0 && number.is_finite() {
            return Ok(number);
        }
        let error =
            Diagnostic::error(format!("a picture cannot be {number} wide or high")).at(span, format!("the {what}"));
        Err(error.help("expected a number above 0").into())
    }
}

/// A rectangle on the origin, with all of a picture.
fn upright(mesh: &mut Mesh, across: Vec3, height: f64, line: u32) {
    let first = mesh.vertices.len() as u32;
    for (place, share) in [(Vec3::ZERO, -0.5), (Vec3::X, 0.5), (Vec3::new(1.0, 1.0, 0.0), 0.5), (Vec3::Y, -0.5)] {
        mesh.vertices.push(across * share + Vec3::Z * (height * place.y));
        mesh.texture.push(place);
    }
    mesh.push_polygon(&[first, first + 1, first + 2, first + 3], NormalSource::Facet, line);
}
