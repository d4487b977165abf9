//! shells: a sea shell of 180 * 2^size + 1 overlapping spheres along a spiral.
//!
//! What it tests: heavy overlap of spheres; surfaces that cut through each other everywhere.
//! The spiral is logarithmic: the radius grows by the same factor with every turn.
//!
//! Source: SPD 3.14; kindred: C. Pickover, "A Short Recipe for Seashell Synthesis",
//! IEEE CG&A 9(6), 1989, 8-11.

use super::nff::{Nff, SKY, View};
use super::rounded::sin_cos;
use super::{Counts, SpdScene, power};
use crate::math::{PI, Vec3, exp};
use std::io;

pub(super) const SCENE: SpdScene = SpdScene {
    name: "shells",
    default_size: 5,
    summary: "a sea shell of overlapping spheres that grow along a spiral",
    sized: true,
    fixed_resolution: None,
    view,
    body,
    count: |size, _| {
        let spheres = power(2, size).saturating_mul(180).saturating_add(1);
        Counts { s: spheres, l: 1, f: 1, ..Counts::default() }
    },
};

fn view(_size: u32) -> View {
    View {
        background: SKY,
        from: Vec3::new(-6.0, -60.0, 35.0),
        at: Vec3::new(0.0, 8.0, -15.0),
        up: Vec3::Z,
        angle: 45.0,
        hither: 0.5,
        resolution: 512,
        lights: vec![Vec3::new(-100.0, -100.0, 100.0)],
    }
}

fn body(nff: &mut Nff<'_>, size: u32) -> io::Result<()> {
    nff.surface([1.0, 0.8, 0.4], [0.8, 0.2, 45.2776, 0.0, 1.0])?;
    // Nine turns in all: six inward from the start, three outward.
    let spheres = 180_i32 << size;
    (-2 * (spheres / 3)..=spheres / 3).try_for_each(|i| {
        let angle = 18.0 * PI * f64::from(i) / f64::from(spheres);
        let radius = exp(0.15 * angle);
        let (sine, cosine) = sin_cos(angle);
        nff.sphere(Vec3::new(radius * sine, radius * cosine, -2.0 * radius), radius)
    })
}
