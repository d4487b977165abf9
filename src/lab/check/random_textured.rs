//! Random scenes in pictures: the hard ones and the meshes, dressed.
//!
//! seed -> Scene, Choices
//!
//! Every surface wears something or nothing: opaque pictures and cut-out ones of odd sizes, mosaics, fades of any two ends. Places on the
//! pictures are linear in space, or without any order, or all one, or far outside. Polygons get few different numbers, so that fades meet.
//!
//! Space: as in [`super::random_scenes`].

use super::Random;
use super::random_meshes::{mesh, mesh_choices};
use super::random_scenes::{choices, hard};
use crate::image::textures::{FirstRow, Mosaic, Texels, Tile, Wrap};
use crate::math::Vec3;
use crate::plan::{AlphaRule, Choices, Interpolation, Shading, TextureFilter};
use crate::scene::{CutOut, Fade, Mesh, Scene, Texture, TextureId};
use std::sync::Arc;

/// The dressed scene that belongs to `seed`, and choices for it.
pub(super) fn dressed(seed: u64) -> (Scene, Choices) {
    let (mut scene, plain) =
        if seed.is_multiple_of(2) { (hard(seed), choices(seed)) } else { (mesh(seed), mesh_choices(seed)) };
    let mut random = Random::new(seed ^ 0x7465_7874);
    for index in 0..scene.surfaces.len() {
        let surface = &mut scene.surfaces[index];
        surface.two_sided = random.once_in(3);
        surface.mesh.polygons.iter_mut().for_each(|polygon| polygon.line = random.below(6) as u32);
        place_on_picture(&mut surface.mesh, &mut random);
        if !random.once_in(5) {
            surface.material.texture = Some(TextureId(scene.textures.len() as u32));
            scene.textures.push(texture(&mut random));
        }
    }
    let mut choices = Choices {
        samples: 1 + random.below(4) as u32,
        texture_filter: TextureFilter::ALL[random.below(TextureFilter::ALL.len() as u64) as usize],
        alpha: AlphaRule::ALL[random.below(AlphaRule::ALL.len() as u64) as usize],
        interpolation: match random.below(9) {
            0 => Interpolation::Screen,
            1 => Interpolation::ScanLine,
            _ => Interpolation::Perspective,
        },
        ..plain
    };
    // Along scan lines run values that vary, over whole polygons.
    if choices.interpolation == Interpolation::ScanLine {
        choices.triangles = false;
        choices.shading = [Shading::Gouraud, Shading::Phong][random.below(2) as usize];
    }
    (scene, choices)
}

/// Gives every vertex a place on a picture.
fn place_on_picture(mesh: &mut Mesh, random: &mut Random) {
    let mut vector = |size: f64| {
        let mut along = || random.between(-size, size);
        Vec3::new(along(), along(), along())
    };
    let (u, v, start) = (vector(1.0), vector(1.0), vector(2.0));
    let kind = random.below(6);
    let place = |vertex: &Vec3| match kind {
        0 => Vec3::new(random.between(-1.0, 2.0), random.between(-1.0, 2.0), 0.0),
        1 => start,
        2 => Vec3::new(u.dot(*vertex) * 1e6, v.dot(*vertex) * 1e-3, 0.0),
        _ => Vec3::new(start.x + u.dot(*vertex), start.y + v.dot(*vertex), 0.0),
    };
    mesh.texture = mesh.vertices.iter().map(place).collect();
}

fn texture(random: &mut Random) -> Texture {
    let mut made = Texture::opaque("made", texels(random));
    made.wrap = [Wrap::Repeat, Wrap::Clamp][random.below(2) as usize];
    if !random.once_in(3) {
        let threshold = [0.5, random.unit(), 0.0, 1.0][random.below(4) as usize];
        made.cut_out = Some(CutOut { threshold });
    }
    if random.once_in(3) {
        let (from, to) = (random.below(17) as u8, random.below(17) as u8);
        made.fade = Some(Fade { from: from.min(to), to: from.max(to) });
    }
    if random.once_in(3) {
        made.mosaic = mosaic(random).map(Arc::new);
    }
    made
}

/// Up to 17 x 17 texels without any order, alpha often all or nothing.
fn texels(random: &mut Random) -> Texels {
    let (width, height) = (1 + random.below(17) as u32, 1 + random.below(17) as u32);
    let only_two = random.once_in(2);
    let texel = |_| {
        let [r, g, b, a, ..] = random.bits().to_le_bytes();
        [r, g, b, if only_two { 255 * (a & 1) } else { a }]
    };
    let rgba = (0..width * height).map(texel).collect();
    // There is a texel, and as many as there are places.
    Texels::new(width, height, rgba, FirstRow::AtV0).expect("width x height texels")
}

fn mosaic(random: &mut Random) -> Option<Mosaic> {
    let size = (1 + random.below(9) as u32, 1 + random.below(9) as u32);
    let count = 1 + random.below(4);
    let tiles = (0..count).map(|_| {
        let repeat = [random.between(0.2, 9.0), random.between(-4.0, 4.0)];
        Tile { texels: Arc::new(texels(random)), repeat }
    });
    let tiles = tiles.collect();
    let ids = (0..size.0 * size.1).map(|_| random.below(count) as u8).collect();
    Mosaic::new(size, ids, FirstRow::Top, tiles)
}
