//! Reads `.ftri`: triangles in binary, made for measuring renderers side by side.
//!
//! bytes -FTRI (fields)-> Triangles -scene-> Scene
//!
//! Why it is careful where the file is foreign: every size is compared with the bytes that are there before anything is allocated,
//! every index with the vertices that are there, every number must be finite. A message names the byte, what was expected there
//! and what to do; a file has one mistake at most, because behind a wrong size nothing means anything.
//!
//! Little endian. Layout and meaning: `docs/formats.md`. Cost: one pass over the bytes, memory for them and for the scene.

mod camera;
mod fields;
mod surfaces;

use super::Parsed;
use crate::color::Rgb;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::image::textures::{FirstRow, Texels};
use crate::math::{Affine3, Vec3};
use crate::scene::{Light, LightSource, Object, ObjectId, Place, Scene, SurfaceId, Texture, TriangleKind, Triangles};

/// Reads a whole file; `name` is what messages and the scene call it.
///
/// # Errors
/// The one mistake that was found.
pub(super) fn read(name: &str, bytes: &[u8]) -> Result<Parsed, Diagnostics> {
    let triangles = fields::read(name, bytes).map_err(Diagnostics::without_source)?;
    scene(name, &triangles)
}

/// The scene of `triangles`; `name` is what messages and the scene call it.
///
/// One object; a surface for each range, or for each color of a range where there are few.
///
/// # Errors
/// The matrices are none of a camera.
pub(super) fn scene(name: &str, triangles: &Triangles) -> Result<Parsed, Diagnostics> {
    let camera = camera::camera(name, triangles).map_err(Diagnostics::without_source)?;
    let surfaces = surfaces::surfaces(triangles);
    let place = Place::default();
    let lights = triangles.lights.iter().map(|&(position, color)| {
        let source = LightSource::Point { position: vector(position) };
        Light { source, color: color.map(f64::from).into(), intensity: Some(1.0), place }
    });
    let background: Rgb = triangles.background.map(f64::from).into();
    let mut scene = Scene {
        files: vec![name.to_string()],
        lights: lights.collect(),
        camera: Some(camera),
        background: Some(background),
        ..Scene::default()
    };
    if !surfaces.is_empty() {
        scene.objects.push(Object {
            name: name.rsplit(['/', '\\']).next().unwrap_or_default().to_string(),
            parent_from_local: Affine3::IDENTITY,
            surfaces: (0..surfaces.len() as u32).map(SurfaceId).collect(),
            children: Vec::new(),
            place,
        });
        scene.world.push(ObjectId(0));
    }
    scene.surfaces = surfaces;
    scene.textures = picture(name, triangles).into_iter().collect();
    let notices = notice(triangles).map_or_else(Diagnostics::default, Diagnostics::without_source);
    Ok(Parsed { scene, notices, default_camera: None })
}

/// The picture that textured triangles wear: cut out at one half, its outermost texels go on beyond its edges.
fn picture(name: &str, triangles: &Triangles) -> Option<Texture> {
    let (width, height) = triangles.texture_size;
    let (texels, _) = triangles.texels.as_chunks::<4>();
    let texels = Texels::new(width, height, texels.to_vec(), FirstRow::AtV0)?;
    Some(Texture::cut_out(name, texels, CUT_OUT))
}

/// Alpha below this is not there: 127 of 255 is below, 128 above.
const CUT_OUT: f64 = 0.5;

/// What is drawn otherwise than the file means: textured triangles of a file without a texture.
fn notice(triangles: &Triangles) -> Option<Diagnostic> {
    let textured = triangles.ranges.iter().filter(|range| range.kind == TriangleKind::Textured);
    let count: u32 = textured.map(|range| range.count / 3).sum();
    let notice =
        Diagnostic::notice(format!("{count} textured triangles are drawn whole, in the colors of their vertices"));
    let help = "the file has no texture, or one with more texels than are drawn: give width and height of the picture, and its texels";
    (count > 0 && picture("", triangles).is_none()).then(|| notice.help(help))
}

fn vector(numbers: [f32; 3]) -> Vec3 {
    Vec3::from_array(numbers.map(f64::from))
}
