//! The teapot as SIPP has it: lathe curves for body and lid, patches for handle and spout, no bottom.
//!
//! newell (control points) -> TEAPOT -> `curves`, `patches`
//!
//! Newell's data at a quarter of their size, moved down so that the body stands on z = 0 (the bottom that was added later reaches
//! 0.15 lower and is not part of it). The body and lid are turned on true circles, where the published patches only come close to them.
//!
//! Source: M. Newell, 1975; SIPP's `teapot`.

use super::newell::{HANDLE, KNOB, LID, LOWER_BODY, Profile, RIM, SPOUT, Tube, UPPER_BODY, halves};
use super::{Detail, Sheet, curves, patches};
use crate::math::Vec3;
use crate::scene::{CurveNet, PatchNet, TeapotPart};
use std::sync::LazyLock;

/// The nets of a part: curves and patches, one of them without any where the part has none.
pub(super) struct Nets {
    pub curves: CurveNet,
    pub patches: PatchNet,
}

/// Adds `part` of the teapot.
pub(super) fn teapot(part: TeapotPart, detail: Detail, sheet: &mut Sheet<'_>) {
    for nets in parts(part) {
        curves::curves(&nets.curves, detail, sheet);
        patches::patches(&nets.patches, detail, sheet);
    }
}

/// The nets of `part`; all four for the whole.
pub(super) fn parts(part: TeapotPart) -> &'static [Nets] {
    static NETS: LazyLock<[Nets; 4]> = LazyLock::new(|| {
        [
            // From the foot upward: the front is to the right.
            lathe(&[&LOWER_BODY, &UPPER_BODY, &RIM]),
            lathe(&[&LID, &KNOB]),
            tubes(&HANDLE),
            tubes(&SPOUT),
        ]
    });
    match part {
        TeapotPart::Whole => &NETS[..],
        TeapotPart::Body => &NETS[0..1],
        TeapotPart::Lid => &NETS[1..2],
        TeapotPart::Handle => &NETS[2..3],
        TeapotPart::Spout => &NETS[3..4],
    }
}

/// A published point in SIPP's teapot.
fn placed(point: Vec3) -> Vec3 {
    let foot = LOWER_BODY[3].1;
    (point - Vec3::Z * foot) * 0.25
}

/// Curves of these profiles; the published ones run downward, these run up.
fn lathe(profiles: &[&Profile]) -> Nets {
    let upward = profiles.iter().flat_map(|profile| profile.iter().rev());
    let vertices: Vec<Vec3> = upward.map(|&(radius, height, _)| placed(Vec3::new(radius, 0.0, height))).collect();
    let curves = (0..profiles.len() as u32).map(|curve| [0, 1, 2, 3].map(|point| 4 * curve + point)).collect();
    Nets { curves: CurveNet { vertices, curves }, patches: PatchNet::default() }
}

/// Two patches for each piece of a tube.
fn tubes(pieces: &[Tube]) -> Nets {
    let grids: Vec<_> = pieces.iter().flat_map(halves).collect();
    let vertices = grids.iter().flatten().flatten().map(|&point| placed(point)).collect();
    let patches = (0..grids.len() as u32).map(|patch| std::array::from_fn(|point| 16 * patch + point as u32)).collect();
    Nets { curves: CurveNet::default(), patches: PatchNet { vertices, patches } }
}
