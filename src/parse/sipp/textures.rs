//! Pictures of shaders: `texture "FILE"`, and what is said about it.
//!
//! block -TEXTURES-> Texture, read from the folder of the scene
//!
//! A picture that several shaders name is read once and shared.

use super::Reader;
use super::block::Block;
use super::check::Checked;
use super::notices::Oddity;
use super::trouble::Trouble;
use crate::diagnostic::{Diagnostic, Span};
use crate::image::textures::{self, Wrap};
use crate::parse::wording::plain;
use crate::scene::{CutOut, Texture, TextureId};
use std::sync::Arc;

/// Parameters that only make sense beside `texture`.
const OF_TEXTURE: [&str; 3] = ["cutout", "key", "wrap"];

impl Reader<'_> {
    /// The picture of a shader, if it has one.
    pub(super) fn texture(&mut self, block: &Block) -> Result<Option<TextureId>, Trouble> {
        let Some(given) = block.find("texture") else {
            let alone = OF_TEXTURE.into_iter().find_map(|word| block.find(word));
            return match alone {
                None => Ok(None),
                Some(alone) => {
                    let message = format!("`{}` says something about a picture, and there is none", alone.word);
                    let error = Diagnostic::error(message).at(alone.keyword, "belongs to nothing");
                    Err(error.help("add `texture \"FILE\"`, or remove it").into())
                }
            };
        };
        let cut_out = block.number("cutout").map(|threshold| CutOut { threshold });
        let key = key_of(block);
        let wrap = match self.words.bytes(block.place("wrap")) {
            b"repeat" => Wrap::Repeat,
            b"clamp" => Wrap::Clamp,
            // What is cut out ends where the picture ends.
            _ if cut_out.is_some() => Wrap::Clamp,
            _ => Wrap::Repeat,
        };
        self.picture(given.values, (key, cut_out, wrap)).map(Some)
    }

    /// Reads a picture, or shares one that was read before.
    pub(super) fn picture(
        &mut self,
        named: Span,
        (key, cut_out, wrap): (Option<[u8; 3]>, Option<CutOut>, Wrap),
    ) -> Result<TextureId, Trouble> {
        let name = plain(self.words.bytes(named));
        let known = self.draft.textures.iter().find(|known| known.name == name && known.key == key);
        let texels = match known {
            Some(known) => known.texels.clone(),
            None => {
                let read = textures::read(&self.path(named)).map_err(|error| {
                    let error = Diagnostic::error(format!("no texture `{name}`: {error}")).at(named, "named here");
                    error.help("PNG, BMP and PPM are read; the name is relative to the folder of the scene")
                })?;
                Arc::new(if let Some(key) = key { read.keyed(key) } else { read })
            }
        };
        self.draft.textures.push(Texture { name, texels, mosaic: None, lookup: None, cut_out, fade: None, wrap, key });
        Ok(TextureId(self.draft.textures.len() as u32 - 1))
    }

    /// Notes surfaces that have a picture and nothing to wear it: without texture coordinates, or shapes.
    pub(super) fn note_pictures_without_places(&mut self, checked: &Checked) {
        let surfaces = self.draft.surfaces.iter().zip(&checked.shaders);
        for (surface, &shader) in surfaces {
            let Some(shader) = shader else { continue };
            let has_picture = self.draft.shaders[shader as usize].material.texture.is_some();
            if has_picture && (surface.mesh.texture.is_empty() || surface.primitive.is_some()) {
                self.notices.note(Oddity::PictureWithoutPlaces, surface.shader);
            }
        }
    }
}

/// The color that is not there.
pub(super) fn key_of(block: &Block) -> Option<[u8; 3]> {
    block.find("key").map(|key| std::array::from_fn(|channel| level(key.numbers.get(channel))))
}

/// A display value as a level of 8 bits.
fn level(value: Option<&f64>) -> u8 {
    (value.copied().unwrap_or(0.0) * 255.0).round().clamp(0.0, 255.0) as u8
}
