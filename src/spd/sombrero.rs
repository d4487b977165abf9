//! sombrero: a damped ripple over a square grid, 2 (32 * 2^(size - 1) - 1)^2 triangles.
//!
//! What it tests: a height field of equal cells; shared edges everywhere; part of it outside the view.
//! The heights are sampled on a grid of W cells a side and drawn on one of W - 1, so the hat sits slightly off
//! center; the original does it, and so does this. The height is y, although the camera's up is z.
//!
//! Source: SPD 3.14. Memory: two rows of vertices.

use super::nff::{Nff, SKY, View};
use super::{Counts, SpdScene, power};
use crate::math::{PI, Vec3, cos, exp};
use std::io;

pub(super) const SCENE: SpdScene = SpdScene {
    name: "sombrero",
    default_size: 1,
    summary: "a damped ripple as a height field of equal triangles",
    sized: true,
    fixed_resolution: None,
    view,
    body,
    count: |size, _| {
        let cells = power(2, size).saturating_mul(16) - 1;
        Counts { p: cells.saturating_mul(cells).saturating_mul(2), l: 1, f: 1, ..Counts::default() }
    },
};

fn view(_size: u32) -> View {
    View {
        background: SKY,
        from: Vec3::new(0.0, 5.0, -8.0),
        at: Vec3::ZERO,
        up: Vec3::Z,
        angle: 40.0,
        hither: 0.01,
        resolution: 512,
        lights: vec![Vec3::new(10.0, 10.0, -10.0)],
    }
}

fn body(nff: &mut Nff<'_>, size: u32) -> io::Result<()> {
    nff.surface([1.0, 0.1, 0.1], [0.8, 0.0, 2.60078, 0.0, 1.0])?;
    let samples = 16 << size;
    let mut near = row(0, samples);
    for i in 1..samples {
        let far = row(i, samples);
        for (near, far) in near.windows(2).zip(far.windows(2)) {
            nff.polygon(&[near[0], far[1], near[1]])?;
            nff.polygon(&[near[0], far[0], far[1]])?;
        }
        near = far;
    }
    Ok(())
}

/// The vertices of row `i`, from x = -4 to x = 4.
fn row(i: u32, samples: u32) -> Vec<Vec3> {
    let sampled_at = |place: u32| -4.0 + 8.0 * f64::from(place) / f64::from(samples);
    let drawn_at = |place: u32| -4.0 + 8.0 * f64::from(place) / f64::from(samples - 1);
    (0..samples)
        .map(|j| {
            let (x, z) = (sampled_at(j), sampled_at(i));
            let radius = (x * x + z * z).sqrt();
            // The original keeps the heights in single precision.
            let height = (cos(2.0 * PI * radius) * exp(-radius)) as f32;
            Vec3::new(drawn_at(j), -3.0 + f64::from(height), drawn_at(i))
        })
        .collect()
}
