//! The standard procedural databases: thirteen scenes of any size, computed instead of stored.
//!
//! SPD -> NFF text -> parse -> Scene; one file a scene, and `farop generate` or `spd:NAME:SIZE` from outside.
//!
//! Why these: they were made to compare renderers, are free of rights, grow to millions of polygons from one
//! number, and between them stress everything a pipeline does: tiny and huge polygons, concave 144-gons (gears),
//! mirrors and glass (balls, mount), deep overlap (lattice), wrong normals (nurbtst). Why text and not a `Scene`: it
//! equals the files that the original programs write, byte for byte (`tests/spd.rs` has their hashes), so every
//! result can be compared with the published ones; and the parser gets exercised.
//!
//! Scene units, right-handed world, angles in radians. Source: E. Haines, "A Proposal for Standard Graphics
//! Environments", IEEE CG&A 7(11), 1987, 3-5; SPD package 3.14 (CC0). Written from a description of the geometry.
//! Cost: linear in the text, 100 to 250 MB a second; memory does not grow with the number of entities.

mod balls;
pub mod bench;
mod gears;
mod jacks;
mod lattice;
mod mount;
mod nff;
mod nurbtst;
mod rings;
mod rounded;
mod sample;
mod shells;
mod sombrero;
mod teapot;
mod tessellate;
mod tetra;
mod text;
mod tree;
mod turn;

use nff::{Nff, View};
use std::io;

/// One of the thirteen scenes.
#[derive(Debug)]
pub struct SpdScene {
    /// The name of the original program, in lower case.
    pub name: &'static str,
    /// The size of the original program when none is asked for; 1 where the size has no effect.
    pub default_size: u32,
    /// What there is to see, in one line.
    pub summary: &'static str,
    /// Whether the size changes anything.
    pub sized: bool,
    /// The resolution that is used in patches mode whatever is asked for.
    fixed_resolution: Option<u32>,
    /// Background, camera and lights.
    view: fn(size: u32) -> View,
    /// Surfaces and objects.
    body: fn(nff: &mut Nff<'_>, size: u32) -> io::Result<()>,
    /// Entities in curves mode; the second number is the resolution of what becomes polygons in any case.
    count: fn(size: u32, resolution: u32) -> Counts,
}

/// All scenes, in alphabetical order.
pub const SCENES: [SpdScene; 13] = [
    balls::SCENE,
    gears::SCENE,
    jacks::SCENE,
    lattice::SCENE,
    mount::SCENE,
    nurbtst::SCENE,
    rings::SCENE,
    sample::SCENE,
    shells::SCENE,
    sombrero::SCENE,
    teapot::SCENE,
    tetra::SCENE,
    tree::SCENE,
];

static ALL: [SpdScene; 13] = SCENES;

/// All of them by name, each with a size that is quick to draw: for tests and checks that go through all.
pub const SMALL: [(&str, u32); 13] = [
    ("balls", 2),
    ("gears", 1),
    ("jacks", 1),
    ("lattice", 2),
    ("mount", 4),
    ("nurbtst", 1),
    ("rings", 1),
    ("sample", 1),
    ("shells", 1),
    ("sombrero", 1),
    ("teapot", 4),
    ("tetra", 3),
    ("tree", 4),
];

/// The scene called `name` (lower case, as in [`SCENES`]), or `None`.
///
/// ```
/// assert_eq!(farop::spd::find("gears").map(|scene| scene.default_size), Some(4));
/// assert!(farop::spd::find("utah").is_none());
/// ```
#[must_use]
pub fn find(name: &str) -> Option<&'static SpdScene> {
    ALL.iter().find(|scene| scene.name == name)
}

/// What becomes of spheres and cones.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Curves {
    /// They stay `s` and `c` entities.
    Kept,
    /// They become triangles with vertex normals: with resolution n, 12 n^2 a sphere and 8 n a cone.
    Patches(u32),
}

impl Curves {
    /// The resolution of the original programs when none is asked for.
    pub const DEFAULT_RESOLUTION: u32 = 3;
}

/// How many entities of each kind a scene has. Numbers beyond `u128` stay at its largest value.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Polygons.
    pub p: u128,
    /// Triangles with vertex normals.
    pub pp: u128,
    /// Spheres.
    pub s: u128,
    /// Cones and cylinders.
    pub c: u128,
    /// Lights.
    pub l: u128,
    /// Surfaces.
    pub f: u128,
}

impl Counts {
    /// All entities together.
    #[must_use]
    pub fn total(&self) -> u128 {
        [self.p, self.pp, self.s, self.c, self.l, self.f].iter().fold(0, |sum: u128, &count| sum.saturating_add(count))
    }
}

/// The largest scene that [`generate`] will write: some gigabytes of text, a minute of work.
pub const MAX_ENTITIES: u128 = 50_000_000;

/// Counts the entities of a scene by closed formulas, without generating it.
///
/// ```
/// use farop::spd::{counts, find, Curves};
/// let gears = find("gears").expect("it is one of the thirteen");
/// assert_eq!(counts(gears, 4, Curves::Kept).p, 9345);
/// ```
#[must_use]
pub fn counts(scene: &SpdScene, size: u32, curves: Curves) -> Counts {
    match curves {
        Curves::Kept => (scene.count)(size, Curves::DEFAULT_RESOLUTION),
        Curves::Patches(asked) => {
            let n = scene.fixed_resolution.unwrap_or(asked);
            let kept = (scene.count)(size, n);
            let n = u128::from(n);
            let patches = kept.s.saturating_mul(12 * n * n).saturating_add(kept.c.saturating_mul(8 * n));
            Counts { pp: kept.pp.saturating_add(patches), s: 0, c: 0, ..kept }
        }
    }
}

/// Why a scene was not written.
#[derive(Debug, thiserror::Error)]
pub enum SpdError {
    /// Sizes start at 1.
    #[error("the size of a scene is at least 1")]
    ZeroSize,
    /// Resolutions start at 1.
    #[error("the resolution of curves is at least 1")]
    ZeroResolution,
    /// Sizes are exponents in most scenes: 9 more spheres for each, say.
    #[error("{scene} of size {size} has {entities} entities; the limit is {MAX_ENTITIES}")]
    TooLarge {
        /// The name of the scene.
        scene: &'static str,
        /// The size asked for.
        size: u32,
        /// What it would take; at most the largest `u128`.
        entities: u128,
    },
    /// The text could not be delivered.
    #[error("cannot write the scene")]
    Io(#[from] io::Error),
}

/// Writes a scene as NFF text to `out`, in pieces of 64 KiB, and flushes it.
///
/// Entities, order and numbers are those of the original programs.
///
/// # Errors
/// [`SpdError::ZeroSize`], [`SpdError::ZeroResolution`] and [`SpdError::TooLarge`] (more than [`MAX_ENTITIES`])
/// before anything is written; [`SpdError::Io`] when `out` refuses.
///
/// ```
/// use farop::spd::{find, generate, Curves};
/// let mut text = Vec::new();
/// generate(find("tetra").expect("there is one"), 1, Curves::Kept, &mut text)?;
/// assert!(text.ends_with(b"p 3\n-1 1 -1\n-1 -1 1\n1 1 1\n"));
/// # Ok::<(), farop::spd::SpdError>(())
/// ```
pub fn generate(scene: &SpdScene, size: u32, curves: Curves, out: &mut dyn io::Write) -> Result<(), SpdError> {
    // Refuse before writing: a size is easily mistyped, and 9 to the power of 40 is not a scene.
    if size == 0 {
        return Err(SpdError::ZeroSize);
    }
    if curves == Curves::Patches(0) {
        return Err(SpdError::ZeroResolution);
    }
    let entities = counts(scene, size, curves).total();
    if entities > MAX_ENTITIES {
        return Err(SpdError::TooLarge { scene: scene.name, size, entities });
    }

    let mut nff = Nff::new(out, curves);
    nff.view(&(scene.view)(size))?;
    (scene.body)(&mut nff, size)?;
    Ok(nff.finish()?)
}

/// `base` to the power of `exponent`, as far as numbers go.
fn power(base: u128, exponent: u32) -> u128 {
    base.saturating_pow(exponent)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scenes_are_in_alphabetical_order_and_found_by_name() {
        assert!(SCENES.is_sorted_by(|a, b| a.name < b.name));
        for scene in &SCENES {
            assert_eq!(find(scene.name).map(|found| found.name), Some(scene.name));
        }
    }

    #[test]
    fn senseless_and_runaway_sizes_are_refused_before_writing() {
        for scene in &SCENES {
            let mut text = Vec::new();
            assert!(matches!(generate(scene, 0, Curves::Kept, &mut text), Err(SpdError::ZeroSize)));
            assert!(matches!(generate(scene, 1, Curves::Patches(0), &mut text), Err(SpdError::ZeroResolution)));
            if scene.sized {
                let refused = generate(scene, u32::MAX, Curves::Patches(u32::MAX), &mut text);
                assert!(matches!(refused, Err(SpdError::TooLarge { .. })), "{}", scene.name);
            }
            assert!(text.is_empty());
        }
    }

    #[test]
    fn refusal_states_count_and_limit() {
        let refused = generate(&balls::SCENE, 9, Curves::Kept, &mut Vec::new());
        let message = refused.expect_err("too large").to_string();
        assert_eq!(message, "balls of size 9 has 435848056 entities; the limit is 50000000");
    }
}
