//! Pictures: what trees and ground wear, each read or painted once.
//!
//! Species, Cover -PICTURES (file, paint)-> Texture, Material

use super::TreeError;
use super::growth::Standing;
use super::quads::crossed;
use crate::color::Rgb;
use crate::forest::area::{Form, Head};
use crate::forest::paint;
use crate::image::textures;
use crate::scene::{Material, Place, Reflection, Surface, SurfaceId, Texture, TextureId};
use std::collections::BTreeMap;
use std::path::Path;

/// Alpha below this is not there.
const CUT_OUT: f64 = 0.5;
/// Before the name of a picture that the program paints.
const PAINTED: &str = "paint:";

/// The textures of a scene in the making.
pub(super) struct Pictures<'a> {
    head: &'a Head,
    folder: &'a Path,
    pub textures: Vec<Texture>,
    /// By name, and whether it is cut out.
    known: BTreeMap<(String, bool), TextureId>,
    /// The surfaces of trees, by species and picture.
    trees: BTreeMap<(u16, u8), SurfaceId>,
}

impl<'a> Pictures<'a> {
    pub fn new(head: &'a Head, folder: &'a Path) -> Pictures<'a> {
        Pictures { head, folder, textures: Vec::new(), known: BTreeMap::new(), trees: BTreeMap::new() }
    }

    /// What ground of a cover is made of; `None`: bare earth.
    pub fn ground(&mut self, cover: Option<u8>) -> Result<Material, TreeError> {
        let (reflection, ambient) = (Reflection::Phong, Some(0.35));
        let earth = Material { reflection, ambient, diffuse: 0.65, specular: 0.0, ..Material::default() };
        let Some(cover) = cover.and_then(|cover| self.head.covers.get(usize::from(cover))) else {
            return Ok(Material { color: Rgb::new(0.48, 0.46, 0.36), ..earth });
        };
        let name = cover.image.clone();
        let texture = self.texture(&name, false)?;
        Ok(Material { texture: Some(texture), ..earth })
    }

    /// The surface that a tree wears: crossed quads with its picture.
    pub fn tree(&mut self, tree: &Standing, surfaces: &mut Vec<Surface>) -> Result<SurfaceId, TreeError> {
        let key = (tree.species, tree.picture);
        if let Some(&known) = self.trees.get(&key) {
            return Ok(known);
        }
        let species = &self.head.species[usize::from(tree.species)];
        let (place, form) = (species.place, species.form);
        let name = match species.images.len() {
            0 => format!("{PAINTED}{}:{}", word(form), tree.picture),
            count => species.images[usize::from(tree.picture) % count].clone(),
        };
        let texture = self.texture(&name, true)?;
        let texture = Some(texture);
        let reflection = Reflection::Phong;
        let material = Material { reflection, ambient: Some(0.6), diffuse: 0.5, texture, ..Material::default() };
        surfaces.push(tree_surface(material, place));
        let id = SurfaceId(surfaces.len() as u32 - 1);
        self.trees.insert(key, id);
        Ok(id)
    }

    /// The texture of that name: known, painted, or read from a file.
    fn texture(&mut self, name: &str, is_cut_out: bool) -> Result<TextureId, TreeError> {
        if let Some(&known) = self.known.get(&(name.to_string(), is_cut_out)) {
            return Ok(known);
        }
        let failed = |what: String| TreeError::Picture { name: name.to_string(), what };
        let texels = if name.starts_with(PAINTED) {
            paint::named(name).map_err(|error| failed(error.to_string()))?
        } else {
            textures::read(&self.folder.join(name)).map_err(|error| failed(error.to_string()))?
        };
        self.textures.push(match is_cut_out {
            true => Texture::cut_out(name, texels, CUT_OUT),
            false => Texture::opaque(name, texels),
        });
        let id = TextureId(self.textures.len() as u32 - 1);
        self.known.insert((name.to_string(), is_cut_out), id);
        Ok(id)
    }
}

fn tree_surface(material: Material, place: Place) -> Surface {
    Surface { material, mesh: crossed(place.line), primitives: Vec::new(), two_sided: true, place }
}

/// The word of a form.
fn word(form: Form) -> &'static str {
    Form::ALL.iter().find(|(_, known)| *known == form).map_or("", |&(word, _)| word)
}
