//! What the experiments share: reading, drawing, and comparing with the oracle.
//!
//! Space: scenes made here are seen by the camera of `random_scenes`: at the origin, 90 degrees, places in eye space.

use super::super::agree::owners;
use super::super::random_scenes::{camera, facets, scene, surface};
use super::Outcome;
use crate::math::Vec3;
use crate::oracle::exact::{ExactPicture, Rules, judge};
use crate::parse::{ParseOptions, Parsed, read_nff};
use crate::plan::{Choices, Culling, Shading};
use crate::raster::ZBuffer;
use crate::render::{Rendered, render};
use crate::scene::{Material, Scene};
use crate::screen::DrawList;

/// A view of the origin from (0, 0, 5).
pub(super) const VIEW: &str = "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\nresolution 32 32\n";
/// A triangle that fills most of that view, with a light and a surface.
pub(super) const TRIANGLE: &str = "l 3 4 6\nf 0.9 0.2 0.1 0.9 0 0 0 1\np 3\n-1.6 -1.4 0\n1.2 -1.4 0\n-0.4 1.5 0\n";
/// Samples of a side of pictures of made scenes.
pub(super) const SIDE: u32 = 64;

/// `Err(wrong)` unless `holds`.
pub(super) fn ensure(holds: bool, wrong: impl Into<String>) -> Outcome {
    if holds { Ok(()) } else { Err(wrong.into()) }
}

/// Reads NFF.
pub(super) fn read(text: impl AsRef<[u8]>) -> Result<Parsed, String> {
    read_nff("x.nff", text.as_ref(), ParseOptions::default()).map_err(|errors| errors.to_string())
}

/// The text must be refused, with a message that has all of `words` in it; a line number is one of them.
pub(super) fn refused(text: impl AsRef<[u8]>, words: &[&str]) -> Outcome {
    match read(text) {
        Ok(_) => Err("it was read".to_string()),
        Err(message) => match words.iter().find(|word| !message.contains(**word)) {
            Some(word) => Err(format!("the message lacks `{word}`: {message}")),
            None => Ok(()),
        },
    }
}

/// The text must be read, with a notice that has `words` in it.
pub(super) fn noticed(text: impl AsRef<[u8]>, words: &str) -> Result<Parsed, String> {
    let parsed = read(text)?;
    let said = parsed.notices.to_string();
    if said.contains(words) { Ok(parsed) } else { Err(format!("no notice says `{words}`: {said:?}")) }
}

/// The picture of a scene; every number of it is finite.
pub(super) fn draw(scene: &Scene, choices: &Choices) -> Result<Rendered, String> {
    let drawn = render(scene, choices, Some(&ZBuffer)).map_err(|error| error.to_string())?;
    let finite = drawn.image.pixels().iter().all(|light| light.to_array().iter().all(|channel| channel.is_finite()));
    if finite { Ok(drawn) } else { Err("a pixel is not finite".to_string()) }
}

/// The picture of a text.
pub(super) fn picture(text: impl AsRef<[u8]>) -> Result<Rendered, String> {
    draw(&read(text)?.scene, &Choices::default())
}

/// Choices that show both sides, one color a polygon: what varies linearly is never split into triangles.
pub(super) fn both_sides() -> Choices {
    Choices { culling: Culling::None, shading: Shading::Flat, ..Choices::default() }
}

/// A white surface of polygons given in eye space.
pub(super) fn made(outlines: &[Vec<Vec3>]) -> Scene {
    scene(camera(SIDE, SIDE), vec![surface(Material::default(), facets(outlines))])
}

/// Eye-space points of places on the screen, in samples of a picture of [`SIDE`], all at distance `w`; exact for whole quarters and
/// a power of two.
pub(super) fn on_screen(places: &[(f64, f64)], w: f64) -> Vec<Vec3> {
    let half = f64::from(SIDE) / 2.0;
    places.iter().map(|&(x, y)| Vec3::new((x / half - 1.0) * w, (1.0 - y / half) * w, w)).collect()
}

/// Draws polygons of eye space, holds the owners against the exact oracle, and returns what it says.
pub(super) fn exactly(outlines: &[Vec<Vec3>], choices: &Choices) -> Result<(Rendered, ExactPicture), String> {
    let drawn = draw(&made(outlines), choices)?;
    let truth = exact_list(&drawn.list)?;
    Ok((drawn, truth))
}

/// The z-buffer must show the owner by the contract at every sample of `list`.
pub(super) fn exact_list(list: &DrawList) -> Result<ExactPicture, String> {
    let truth = judge(list, &Rules::CONTRACT);
    let drawn = owners(list, &ZBuffer);
    match (0..drawn.len()).find(|&at| drawn[at] != truth.owner[at]) {
        Some(at) => Err(format!("sample {at} shows {:?}, not {:?}", drawn[at], truth.owner[at])),
        None => Ok(truth),
    }
}

/// Which samples anything covers.
pub(super) fn mask(list: &DrawList) -> Vec<bool> {
    owners(list, &ZBuffer).iter().map(Option::is_some).collect()
}

/// How many samples anything covers.
pub(super) fn covered(list: &DrawList) -> usize {
    mask(list).into_iter().filter(|&covered| covered).count()
}
