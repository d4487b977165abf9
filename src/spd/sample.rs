//! sample: three tori, a cone and a disc, one of each shape that the package can cut into polygons.
//!
//! What it tests: tessellation. The size has no effect; the resolution has one on all but the disc.
//!
//! Source: SPD 3.14.

use super::nff::{Nff, View};
use super::tessellate::{Cone, Torus};
use super::{Counts, SpdScene};
use crate::math::Vec3;
use std::io;

pub(super) const SCENE: SpdScene = SpdScene {
    name: "sample",
    default_size: 1,
    summary: "three tori through each other, a cone and a disc: a test of tessellation",
    sized: false,
    fixed_resolution: None,
    view,
    body,
    count: |_, n| Counts {
        p: 4 * u128::from(DISC_RESOLUTION),
        pp: 3 * 32 * u128::from(n) * u128::from(n),
        c: 1,
        l: 1,
        f: 5,
        ..Counts::default()
    },
};

const DISC_RESOLUTION: u32 = 4;

fn view(_size: u32) -> View {
    View {
        background: [0.8; 3],
        from: Vec3::new(0.0, 5.0, -5.0),
        at: Vec3::ZERO,
        up: Vec3::Y,
        angle: 45.0,
        hither: 0.001,
        resolution: 512,
        lights: vec![Vec3::new(-10.0, 20.0, -20.0)],
    }
}

fn body(nff: &mut Nff<'_>, _size: u32) -> io::Result<()> {
    let finish = [0.7, 0.0, 45.2776, 0.0, 1.0];
    for (color, x, axis) in [
        ([0.0, 1.0, 1.0], -1.0, Vec3::new(1.0, 1.0, -0.5)),
        ([1.0, 1.0, 0.0], 0.0, Vec3::new(0.0, 1.0, -0.5)),
        ([1.0, 0.0, 1.0], 1.0, Vec3::new(-1.0, 1.0, -0.5)),
    ] {
        nff.surface(color, finish)?;
        nff.torus(&Torus { center: Vec3::new(x, 0.0, 0.0), axis, major: 2.0, minor: 0.5 })?;
    }

    let (foot, top) = (Vec3::new(0.0, -2.0, 0.0), Vec3::new(0.0, 2.0, 0.0));
    nff.surface([1.0, 0.0, 0.0], finish)?;
    nff.cone(&Cone { base: foot, base_radius: 2.0, apex: top, apex_radius: 0.1 })?;
    nff.surface([1.0, 0.0, 0.0], finish)?;
    nff.disc((foot, Vec3::Y, 4.0), DISC_RESOLUTION)
}
