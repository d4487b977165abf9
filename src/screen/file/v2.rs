//! The v2 screen file: a draw list, whole, as text.
//!
//! DrawList -WRITE-> text -READ-> DrawList, equal to the last bit
//!
//! Every number has the shortest digits that read back to the same bits. So a picture of the file is the picture of the
//! list, byte for byte, whatever the shading: a Phong list holds normals, eye points, surfaces and lights.
//!
//! A file is a head ([`super::header`]), then records ([`super::records`]), then `end`:
//! lights, pictures, surfaces, and every polygon with its planes and vertices.

use super::header::{self, Header};
use super::records;
use super::shading;
use super::textures;
use super::words::{Layout, Words};
use super::{Kind, ReadOptions, ScreenFile, ScreenFileError, ScreenWriteError, Sheet};
use crate::plan::Varying;
use crate::screen::DrawList;
use std::io::{BufWriter, Write};

/// The first word of a v2 file.
pub(super) const NAME: &str = "farop-screen";

/// What is asked to be at the vertices of a v2 file (`--attributes`). None of it: what the list carries. Pictures, and the texture
/// coordinates that belong to them, stand in the file if they are asked for or nothing is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Attributes {
    /// Colors; in a list of normals they are lit and stand behind normal and eye point.
    pub color: bool,
    /// Normals and eye points.
    pub phong: bool,
    /// Texture coordinates.
    pub texture: bool,
}

impl Attributes {
    /// Attributes from names: `color`, `phong`, `texture`, with commas between. `None` for any other name.
    #[must_use]
    pub fn from_names(names: &str) -> Option<Attributes> {
        names.split(',').try_fold(Attributes::default(), |attributes, name| match name.trim() {
            "color" => Some(Attributes { color: true, ..attributes }),
            "phong" => Some(Attributes { phong: true, ..attributes }),
            "texture" => Some(Attributes { texture: true, ..attributes }),
            _ => None,
        })
    }

    /// Whether vertices of `list` get colors besides what varies.
    pub(super) fn adds_color(self, list: &DrawList) -> bool {
        self.color && list.varying.has_normals()
    }

    /// Whether `list` has what is asked for.
    fn check(self, list: &DrawList) -> Result<(), ScreenWriteError> {
        match list.varying {
            _ if list.grid.is_exact() => Err(ScreenWriteError::Unsnapped),
            _ if self.texture && !list.has_texture() => Err(ScreenWriteError::NoTexture),
            _ if list.has_texture() && list.shader.textures.list.iter().any(|texture| texture.lookup.is_some()) => {
                Err(ScreenWriteError::Map)
            }
            Varying::Color | Varying::ColorTexture | Varying::Nothing if self.phong => Err(ScreenWriteError::NoNormals),
            Varying::Nothing if self.color => Err(ScreenWriteError::NoColors),
            _ => Ok(()),
        }
    }
}

/// Writes `list` as a v2 file.
///
/// # Errors
/// [`ScreenWriteError`] when the list does not carry the `attributes`, and whatever `out` says.
pub fn write_v2(
    list: &DrawList,
    sheet: &Sheet,
    attributes: Attributes,
    out: &mut dyn Write,
) -> Result<(), ScreenWriteError> {
    attributes.check(list)?;
    let plain;
    let list = if list.has_texture() && !attributes.texture && attributes != Attributes::default() {
        plain = list.without_texture();
        &plain
    } else {
        list
    };
    let unit = list.unit;
    let in_scene_units;
    let list = if unit == 1.0 {
        list
    } else {
        in_scene_units = list.in_unit(1.0);
        // What does not come back was outside the range of the numbers.
        if in_scene_units.in_unit(unit) != *list {
            return Err(ScreenWriteError::OutOfRange);
        }
        &in_scene_units
    };
    let mut out = BufWriter::new(out);
    header::write((list, unit), sheet, attributes, &mut out)?;
    for light in &list.shader.lights {
        shading::write_light(light, &mut out)?;
    }
    for (index, texture) in list.shader.textures.list.iter().enumerate() {
        textures::write_texture(index, texture, &mut out)?;
    }
    for (index, surface) in list.shader.surfaces.iter().enumerate() {
        shading::write_surface(index, surface, &mut out)?;
    }
    for polygon in list.polygons() {
        records::write_polygon(list, &polygon, attributes.adds_color(list), &mut out)?;
    }
    writeln!(out, "end")?;
    Ok(out.flush()?)
}

/// Reads a v2 file.
pub(super) fn read_v2(text: &str, options: &ReadOptions) -> Result<ScreenFile, ScreenFileError> {
    let mut words = Words::new(text, Layout::Records);
    let mut header = header::read(&mut words, options)?;
    records::read_body(&mut words, &mut header)?;
    let Header { mut list, sheet, unit, .. } = header;
    if unit != 1.0 {
        list = list.in_unit(unit);
    }
    Ok(ScreenFile { kind: Kind::V2, list, sheet })
}
