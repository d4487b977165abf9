//! What a v2 file says about light: lights and surfaces, written and read side by side.
//!
//! A point light and a surface of NFF's model are written as they always were, so older files are read and older readers read on. Other kinds
//! add words behind the numbers: `directional`; `spot`, its axis, cosine and edge; `phong`; `basic` and its c3.

use super::ScreenFileError;
use super::header::{color, color_text, name_of};
use super::number::Number;
use super::records::{WHOLE, numbers, vector};
use super::textures::read_texture_of_surface;
use super::words::Words;
use crate::color::Rgb;
use crate::math::Vec3;
use crate::scene::{Place, Reflection, SpotEdge};
use crate::screen::shader::{EyeLight, EyeSource, Spot, SurfaceShading, Textures};
use std::io::{self, Write};

const EDGES: [(SpotEdge, &str); 2] = [(SpotEdge::Sharp, "sharp"), (SpotEdge::Soft, "soft")];
const SOURCES: [(SourceKind, &str); 2] = [(SourceKind::Directional, "directional"), (SourceKind::Spot, "spot")];
const MODELS: [(ModelKind, &str); 2] = [(ModelKind::Phong, "phong"), (ModelKind::Basic, "basic")];

#[derive(Clone, Copy, PartialEq)]
enum SourceKind {
    Directional,
    Spot,
}

#[derive(Clone, Copy, PartialEq)]
enum ModelKind {
    Phong,
    Basic,
}

pub(super) fn write_light(light: &EyeLight, out: &mut dyn Write) -> io::Result<()> {
    let place = match light.source {
        EyeSource::Point { position } | EyeSource::Spot(Spot { position, .. }) => position,
        EyeSource::Directional { to_light } => to_light,
    };
    write!(out, "light")?;
    numbers(out, &place.to_array())?;
    numbers(out, &light.color.to_array())?;
    match light.source {
        EyeSource::Point { .. } => {}
        EyeSource::Directional { .. } => write!(out, " directional")?,
        EyeSource::Spot(Spot { axis, cosine, edge, .. }) => {
            write!(out, " spot")?;
            numbers(out, &axis.to_array())?;
            write!(out, " {} {}", Number(cosine), name_of(edge, &EDGES))?;
        }
    }
    writeln!(out)
}

pub(super) fn read_light(words: &mut Words<'_>) -> Result<EyeLight, ScreenFileError> {
    words.record("light")?;
    let place = vector(words, ["x of the light", "y of the light", "z of the light"])?;
    let color = vector(words, ["red of the light", "green of the light", "blue of the light"])?;
    let source = read_source(words, place)?;
    words.end_of_record()?;
    Ok(EyeLight { source, color: Rgb::from(color.to_array()) })
}

/// The words behind the numbers of a light; none: a point light.
fn read_source(words: &mut Words<'_>, place: Vec3) -> Result<EyeSource, ScreenFileError> {
    if words.peek().text.is_empty() {
        return Ok(EyeSource::Point { position: place });
    }
    match words.choice("the kind of light, or the end of the line", &SOURCES)? {
        SourceKind::Directional => Ok(EyeSource::Directional { to_light: place }),
        SourceKind::Spot => {
            let axis = vector(words, ["x of the axis", "y of the axis", "z of the axis"])?;
            let word = words.word();
            let cosine = word.text.parse().ok().filter(|cosine: &f64| (-1.0..1.0).contains(cosine));
            let cosine = cosine.ok_or_else(|| words.error(word, "the cosine of half the opening, below 1"))?;
            let edge = words.choice("how the spot ends", &EDGES)?;
            Ok(EyeSource::Spot(Spot { position: place, axis, cosine, edge }))
        }
    }
}

pub(super) fn write_surface(index: usize, surface: &SurfaceShading, out: &mut dyn Write) -> io::Result<()> {
    write!(out, "surface {index}")?;
    numbers(out, &surface.ambient.to_array())?;
    numbers(out, &surface.diffuse.to_array())?;
    numbers(out, &[surface.specular, surface.shine])?;
    write!(out, " {} {} {}", color_text(surface.opacity), surface.place.file, surface.place.line)?;
    match surface.reflection {
        Reflection::Nff => {}
        Reflection::Phong => write!(out, " phong")?,
        Reflection::Basic { c3 } => write!(out, " basic {}", Number(c3))?,
    }
    if let Some(texture) = surface.texture {
        write!(out, " texture {texture}")?;
    }
    writeln!(out)
}

pub(super) fn read_surface(
    words: &mut Words<'_>,
    index: usize,
    textures: &Textures,
) -> Result<SurfaceShading, ScreenFileError> {
    words.record("surface")?;
    words.whole("the number of the surface", index as u64..=index as u64)?;
    let ambient = vector(words, ["ambient red", "ambient green", "ambient blue"])?;
    let diffuse = vector(words, ["diffuse red", "diffuse green", "diffuse blue"])?;
    let (specular, shine) = (words.number("Ks")?, words.number("the cosine power")?);
    let opacity = color(words, "opacity")?;
    let file = words.whole("the number of the scene file", 0..=u64::from(u16::MAX))? as u16;
    let line = words.whole("the line in the scene file", WHOLE)? as u32;
    let reflection = read_reflection(words)?;
    let texture = read_texture_of_surface(words, textures)?;
    words.end_of_record()?;
    let (ambient, diffuse) = (Rgb::from(ambient.to_array()), Rgb::from(diffuse.to_array()));
    let place = Place { file, line };
    Ok(SurfaceShading { reflection, ambient, diffuse, specular, shine, opacity, texture, place })
}

/// The words behind the numbers of a surface; none: NFF's model.
fn read_reflection(words: &mut Words<'_>) -> Result<Reflection, ScreenFileError> {
    if words.peek().text.is_empty() || words.peek().text == "texture" {
        return Ok(Reflection::Nff);
    }
    match words.choice("the reflection model, or the end of the line", &MODELS)? {
        ModelKind::Phong => Ok(Reflection::Phong),
        ModelKind::Basic => {
            let word = words.word();
            let c3 = word.text.parse().ok().filter(|c3: &f64| (0.0..=1.0).contains(c3));
            Ok(Reflection::Basic { c3: c3.ok_or_else(|| words.error(word, "c3, a number from 0 to 1"))? })
        }
    }
}
