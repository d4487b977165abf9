//! Dress: the textures and materials of all trees, made once.
//!
//! Pictures -DRESS-> textures of the scene; picture and look -> key -> material
//!
//! A picture that is fading needs a texture for every share of samples it may have: 15 as the nearer look, 15 as the farther one, and one
//! for all samples. They share the texels, so a texture costs 200 bytes. The triangle that stands for a small tree wears no picture, and
//! a picture of one texel while it fades.
//!
//! Light: a tree has the light of level ground. A picture has no form that light could shade; and a crossed picture and a facing one of
//! the same tree must look alike, or fading shows ([`LIGHT`]).

use crate::color::Rgb;
use crate::forest::area::Head;
use crate::forest::pictures::{Painted, Pictures};
use crate::forest::solid::Solid;
use crate::image::textures::{FirstRow, Texels};
use crate::math::Vec3;
use crate::scene::{Light, LightSource, Material, Place, Texture, TextureId};

/// Where the sun is: south-west, 45 degrees high.
pub const SUN: Vec3 = Vec3::new(-0.5, -0.5, std::f64::consts::FRAC_1_SQRT_2);
/// Its light.
const SUNLIGHT: f64 = 0.75;
/// How much of the light ground sends back.
const DIFFUSE: f64 = 0.9;
/// What trees send back: as level ground does in the sun and in the light of the sky, which is half of a lamp's in scenes with one lamp.
const LIGHT: f64 = DIFFUSE * (0.5 + SUNLIGHT * std::f64::consts::FRAC_1_SQRT_2);

/// Keys of one picture: whole; 15 shares as the nearer look; 15 as the farther one; the triangle; 15 shares of it;
/// the mesh; 15 shares of it.
pub(super) const KEYS: usize = 63;
const NARROW: usize = 31;
const SOLID: usize = 47;
/// Textures of one picture: all keys before the mesh, but the triangle in one color.
const TEXTURES: usize = SOLID - 1;
/// What a mesh sends back of ambient light and of the sun's: on the mean of its lit and its shaded side about as much as its picture.
const SOLID_LIGHT: [f64; 2] = [0.6, 0.9];

/// What trees wear.
pub(super) struct Dress {
    /// Of the scene, before those of the ground.
    pub textures: Vec<Texture>,
    /// Index of a species' first picture, and how many it has.
    first: Vec<(u32, u32)>,
    colors: Vec<Rgb>,
    /// The mesh of each picture.
    pub solids: Vec<Solid>,
    /// How much of its rectangle each picture fills.
    pub shares: Vec<f64>,
}

impl Dress {
    pub fn new(head: &Head, pictures: &Pictures, threshold: f64) -> Dress {
        let mut dress = Dress {
            textures: Vec::new(),
            first: Vec::new(),
            colors: Vec::new(),
            solids: Vec::new(),
            shares: Vec::new(),
        };
        for (species, painted) in head.species.iter().zip(&pictures.trees) {
            dress.first.push((dress.colors.len() as u32, painted.len() as u32));
            for (number, picture) in painted.iter().enumerate() {
                dress.add(&format!("{}:{number}", species.code), picture, threshold);
            }
        }
        // Shares of meshes are the same for all pictures: their colors are at their corners.
        let white = Texture::opaque("mesh", one_texel(Rgb::WHITE));
        dress.textures.extend((1..16).map(|share| white.clone().faded(0, share)));
        dress
    }

    fn add(&mut self, name: &str, picture: &Painted, threshold: f64) {
        self.solids.push(Solid::new(picture, self.colors.len() as u64));
        self.colors.push(picture.color);
        self.shares.push(picture.share);
        let whole =
            Texture { texels: picture.texels.clone(), ..Texture::cut_out(name, one_texel(picture.color), threshold) };
        let plain = Texture::opaque(name, one_texel(picture.color));
        self.textures.push(whole.clone());
        self.textures.extend((1..16).map(|share| whole.clone().faded(0, share)));
        self.textures.extend((1..16).map(|share| whole.clone().faded(share, 16)));
        self.textures.extend((1..16).map(|share| plain.clone().faded(share, 16)));
    }

    /// The index of a picture, from 0 to that of all species; `None` where there is no such species.
    #[inline]
    pub fn picture(&self, species: u16, picture: u8) -> Option<usize> {
        let &(first, count) = self.first.get(usize::from(species))?;
        let own = u32::from(picture);
        (count > 0).then_some((first + if own < count { own } else { 0 }) as usize)
    }

    /// How many pictures there are.
    pub fn pictures(&self) -> usize {
        self.colors.len()
    }

    /// The key of a picture that has the samples from `from` to below `to`.
    #[inline]
    pub fn key(picture: usize, is_narrow: bool, from: u8, to: u8) -> usize {
        let own = match (from, to) {
            (0, 16..) => 0,
            (0, share) => usize::from(share),
            (share, _) => 15 + usize::from(share),
        };
        picture * KEYS + if is_narrow { NARROW + own.saturating_sub(15) } else { own }
    }

    /// The key of a picture's mesh that has the samples below `to`.
    #[inline]
    pub fn solid_key(picture: usize, to: u8) -> usize {
        picture * KEYS + SOLID + if to < 16 { usize::from(to) } else { 0 }
    }

    /// What surfaces of a key are made of.
    pub fn material(&self, key: usize) -> Material {
        let (picture, own) = (key / KEYS, key % KEYS);
        let matte = Material { ambient: Some(LIGHT), diffuse: 0.0, ..Material::default() };
        if own == NARROW {
            return Material { color: self.colors[picture], ..matte };
        }
        if own >= SOLID {
            let first = self.pictures() * TEXTURES;
            let texture = (own > SOLID).then(|| TextureId((first + own - SOLID - 1) as u32));
            let [ambient, diffuse] = SOLID_LIGHT;
            return Material { color: Rgb::WHITE, ambient: Some(ambient), diffuse, texture, ..Material::default() };
        }
        let texture = picture * TEXTURES + if own > NARROW { own - 1 } else { own };
        Material { texture: Some(TextureId(texture as u32)), ..matte }
    }
}

/// What ground is made of.
pub(super) fn ground_material(texture: Option<TextureId>) -> Material {
    Material { diffuse: DIFFUSE, texture, ..Material::default() }
}

/// The sun.
pub(super) fn sun() -> Light {
    let source = LightSource::Directional { to_light: SUN };
    Light { source, color: Rgb::WHITE, intensity: Some(SUNLIGHT), place: Place::default() }
}

fn one_texel(color: Rgb) -> Texels {
    let [r, g, b] = [color.r, color.g, color.b].map(|value| (value * 255.0).round() as u8);
    // One texel is always a picture.
    Texels::new(1, 1, vec![[r, g, b, 255]], FirstRow::AtV0).unwrap_or_else(|| unreachable!("one texel for 1 x 1"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::forest::area::{Form, Species};
    use std::path::Path;

    #[test]
    fn every_key_has_the_texture_of_its_samples() {
        let species =
            |code: &str| Species { code: code.into(), form: Form::Shrub, images: vec![], place: Place::default() };
        let head = Head { side: 240.0, species: vec![species("A"), species("B")], ..Head::default() };
        let pictures = Pictures::new(&head, Path::new(".")).expect("painted");
        let dress = Dress::new(&head, &pictures, 0.5);
        let picture = dress.picture(1, 2).expect("is there");
        assert_eq!((dress.pictures(), dress.textures.len()), (8, 8 * TEXTURES + 15));
        assert!(dress.picture(2, 0).is_none());
        for (is_narrow, from, to) in (0..16).flat_map(|k| [(false, 0, k + 1), (false, k, 16), (true, k, 16)]) {
            let material = dress.material(Dress::key(picture, is_narrow, from, to));
            let Some(texture) = material.texture else {
                assert!(is_narrow && from == 0);
                continue;
            };
            let texture = &dress.textures[texture.0 as usize];
            let shown = texture.fade.map_or((0, 16), |fade| (fade.from, fade.to));
            assert_eq!(shown, (from, to), "{is_narrow}");
            assert_eq!((texture.name.as_str(), texture.texels.size() == (1, 1)), ("B:2", is_narrow));
        }
    }
}
