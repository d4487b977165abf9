//! Shapes: `sphere { radius 1 shader red }` -> Primitive, one surface each.
//!
//! Space: local. Source: J. Yngvesson and I. Wallin, "SIPP User's Guide" (what the numbers mean).

use super::Reader;
use super::block::{Block, vector};
use super::draft::RawSurface;
use super::notices::Oddity;
use super::outline;
use super::trouble::Trouble;
use super::vocabulary::{SHAPE, shape_parameters};
use crate::diagnostic::{Diagnostic, Span};
use crate::math::Vec3;
use crate::scene::{CurveNet, Mesh, PatchNet, Primitive, Shape, TeapotPart, TextureMapping};
use std::sync::Arc;

impl Reader<'_> {
    /// Reads the block of a shape; `None` when a mistake in it was told.
    pub(super) fn shape(&mut self, keyword: Span, line: u32) -> Result<Option<u32>, Trouble> {
        let word = self.words.bytes(keyword);
        let own = shape_parameters(word).unwrap_or_default();
        let block = self.block(keyword, line, &[own, SHAPE])?;
        let (Some(shader), false) = (block.find("shader"), block.broken) else { return Ok(None) };
        let shape = self.shape_of(word, &block)?;
        let primitive = Primitive {
            inside: block.has("inside"),
            resolution: self.resolution(&block, &shape)?,
            texture: match self.words.bytes(block.place("texture")) {
                b"natural" => TextureMapping::Natural,
                b"cylindrical" => TextureMapping::Cylindrical,
                b"spherical" => TextureMapping::Spherical,
                _ => TextureMapping::World,
            },
            ..Primitive::new(shape, 0, line)
        };
        let two_sided = block.find("two_sided").map(|given| self.words.bytes(given.values) == b"on");
        let (shader, primitive) = (shader.values, Some(primitive));
        self.draft.surfaces.push(RawSurface { shader, mesh: Mesh::default(), primitive, two_sided, picture: None });
        Ok(Some(self.draft.surfaces.len() as u32 - 1))
    }

    /// `res`: one number, and for a torus one or two.
    fn resolution(&self, block: &Block, shape: &Shape) -> Result<Option<[u32; 2]>, Trouble> {
        let Some(res) = block.find("res") else { return Ok(None) };
        let first = res.numbers.first().map_or(1, |&res| res as u32);
        let second = res.numbers.get(1).map_or(first, |&res| res as u32);
        if res.numbers.len() == 2 && !matches!(shape, Shape::Torus { .. }) {
            let error = Diagnostic::error("only a torus takes two numbers behind `res`").at(res.values, "one too many");
            return Err(error.help(format!("write `res {first}`")).into());
        }
        Ok(Some([first, second]))
    }

    fn shape_of(&mut self, word: &[u8], block: &Block) -> Result<Shape, Trouble> {
        let number = |word: &str| block.number(word).unwrap_or(1.0);
        let vector = |word: &str| block.vector(word).unwrap_or_default();
        Ok(match word {
            b"cube" => Shape::Block { size: Vec3::splat(number("size")) },
            b"block" => Shape::Block { size: vector("size") },
            b"prism" => self.prism(block)?,
            b"sphere" => Shape::Sphere { center: vector("center"), radius: number("radius") },
            b"ellipsoid" => Shape::Ellipsoid { radii: vector("radii") },
            b"cylinder" => {
                let radius = number("radius");
                Shape::CappedCone { bottom_radius: radius, top_radius: radius, length: number("length") }
            }
            b"cone" => cone(block)?,
            b"torus" => Shape::Torus { ring_radius: number("ring"), tube_radius: number("tube") },
            b"open_cone" => self.open_cone(block)?,
            b"bezier" => self.bezier(block)?,
            b"teapot_body" => Shape::Teapot(TeapotPart::Body),
            b"teapot_lid" => Shape::Teapot(TeapotPart::Lid),
            b"teapot_handle" => Shape::Teapot(TeapotPart::Handle),
            b"teapot_spout" => Shape::Teapot(TeapotPart::Spout),
            _ => Shape::Teapot(TeapotPart::Whole),
        })
    }

    fn prism(&mut self, block: &Block) -> Result<Shape, Trouble> {
        let numbers = block.find("outline").map_or(&[][..], |given| &given.numbers);
        let mut points: Vec<[f64; 2]> = numbers.as_chunks().0.to_vec();
        let place = self.on_one_line(block.place("outline"));
        if let Err(outline::Fault { message, help }) = outline::check(&points) {
            return Err(Diagnostic::error(message).at(place, "this outline").help(help).into());
        }
        if outline::is_clockwise(&points) {
            points[1..].reverse();
            self.notices.note(Oddity::OutlineTurned, place);
        }
        Ok(Shape::Prism { outline: points.into(), height: block.number("height").unwrap_or(1.0) })
    }

    fn open_cone(&self, block: &Block) -> Result<Shape, Trouble> {
        let end = |word: &str| block.find(word).map_or(&[][..], |given| &given.numbers[..]);
        let (base, apex) = (end("base"), end("apex"));
        let radius = |numbers: &[f64]| numbers.get(3).copied().unwrap_or(0.0);
        let (base_radius, apex_radius) = (radius(base), radius(apex));
        let (base, apex) = (vector(base), vector(apex));
        let mistake = if base_radius.min(apex_radius) < 0.0 {
            Some(("a radius cannot be negative", "to see the inside of a shape, write `inside`"))
        } else if base_radius == 0.0 && apex_radius == 0.0 {
            Some(("a cone with both radii 0 is a line", "make one of them larger"))
        } else if base == apex && base_radius == apex_radius {
            Some(("both ends of this cone are the same circle", "move one of them"))
        } else {
            None
        };
        match mistake {
            Some((message, help)) => {
                Err(Diagnostic::error(message).at(block.keyword, "this `open_cone`").help(help).into())
            }
            None => Ok(Shape::Cone { base, base_radius, apex, apex_radius }),
        }
    }

    /// Control points from a file, or written in place.
    fn bezier(&mut self, block: &Block) -> Result<Shape, Trouble> {
        let has_patches = block.has("patch");
        let in_place = block.has("v") || has_patches || block.has("curve");
        let help = "a `bezier` has `file \"NAME\"`, or `v`s with `patch`es, or `v`s with `curve`s";
        let mistake = |message: &str| Diagnostic::error(message).at(block.keyword, "this `bezier`").help(help);
        match block.find("file") {
            Some(_) if in_place => return Err(mistake("a `bezier` cannot have a file and points of its own").into()),
            Some(file) => return self.bezier_file(file.values),
            None => {}
        }
        if has_patches == block.has("curve") {
            let message =
                if has_patches { "a `bezier` has patches or curves, not both" } else { "a `bezier` of nothing" };
            return Err(mistake(message).into());
        }
        let vertices: Vec<Vec3> = block.all("v").map(|given| vector(&given.numbers)).collect();
        if has_patches {
            let patches = self.indices(block, "patch", vertices.len())?;
            return Ok(Shape::Patches(Arc::new(PatchNet { vertices, patches })));
        }
        let mut curves = self.indices(block, "curve", vertices.len())?;
        // As in a Bezier file: from the curve's end to its start.
        curves.iter_mut().for_each(|curve: &mut [u32; 4]| curve.reverse());
        Ok(Shape::Curves(Arc::new(CurveNet { vertices, curves })))
    }

    /// The indices behind all `word`s, counted from 0.
    fn indices<const N: usize>(
        &self,
        block: &Block,
        word: &'static str,
        vertices: usize,
    ) -> Result<Vec<[u32; N]>, Trouble> {
        let mut all = Vec::new();
        for given in block.all(word) {
            let place = self.on_one_line(given.values);
            let mut indices = [0; N];
            for (index, &number) in indices.iter_mut().zip(&given.numbers) {
                let is_index = number.fract() == 0.0 && number >= 1.0 && number <= vertices as f64;
                if !is_index {
                    let error = Diagnostic::error(format!("there is no vertex {number} in this `bezier`"));
                    let error = error.at(place, format!("among the indices of this `{word}`"));
                    return Err(error.help(format!("it has {vertices} vertices, counted from 1")).into());
                }
                *index = number as u32 - 1;
            }
            all.push(indices);
        }
        Ok(all)
    }
}

fn cone(block: &Block) -> Result<Shape, Trouble> {
    let number = |word: &str| block.number(word).unwrap_or(0.0);
    let (bottom_radius, top_radius) = (number("bottom"), number("top"));
    if bottom_radius == 0.0 && top_radius == 0.0 {
        let error = Diagnostic::error("a cone with both radii 0 is a line").at(block.keyword, "this `cone`");
        return Err(error.help("make one of them larger").into());
    }
    Ok(Shape::CappedCone { bottom_radius, top_radius, length: number("length") })
}
