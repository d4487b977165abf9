//! rings: a pyramid of dodecahedral chains; 30 spheres and 30 cylinders a ring.
//!
//! What it tests: cylinders and spheres of equal size, many surfaces, a wall that shows every gap.
//! A ring is six pentagons of cylinders with spheres at the corners, each in a color of its own; layer L
//! behind the eye's plane has (L + 1)^2 rings.
//!
//! Source: SPD 3.14.

use super::nff::{NO_HIGHLIGHT, Nff, SKY, View};
use super::rounded::{acos, sin_cos};
use super::tessellate::Cone;
use super::turn::{rotation_x, rotation_z};
use super::{Counts, SpdScene};
use crate::math::{PI, Vec3, tan};
use std::io;

pub(super) const SCENE: SpdScene = SpdScene {
    name: "rings",
    default_size: 7,
    summary: "a pyramid of linked rings: cylinders with spheres at the joints, before a wall",
    sized: true,
    fixed_resolution: None,
    view,
    body,
    count: |size, _| {
        let s = u128::from(size);
        let rings = s * (s + 1) * (2 * s + 1) / 6;
        Counts { p: 1, s: 30 * rings, c: 30 * rings, l: 3, f: 6 * rings + 1, ..Counts::default() }
    },
};

const RADIUS: f64 = 0.07412;

const COLORS: [[f64; 3]; 6] =
    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 1.0], [1.0, 0.0, 1.0], [1.0, 1.0, 0.0]];

/// From layer to layer: what makes the pyramid fill an angle of view of 45 degrees.
fn layer_distance() -> f64 {
    1.0 / sin_cos(PI / 8.0).0
}

fn view(_size: u32) -> View {
    let d = layer_distance();
    View {
        background: SKY,
        from: Vec3::new(-1.0, -d, 0.5),
        at: Vec3::new(-1.0, 1.0 - d, 0.5),
        up: Vec3::Z,
        angle: 45.0,
        hither: 1.0,
        resolution: 512,
        lights: vec![Vec3::new(3.0, -d, 3.0), Vec3::new(-4.0, -d, 1.0), Vec3::new(2.0, -d, -4.0)],
    }
}

fn body(nff: &mut Nff<'_>, size: u32) -> io::Result<()> {
    // The wall.
    let d = layer_distance();
    let y = d * (f64::from(size) + 1.0);
    let w = 1.01 * d * (f64::from(size) + 2.0) * tan(PI / 8.0);
    nff.surface([1.0; 3], [1.0, 0.0, NO_HIGHLIGHT, 0.0, 0.0])?;
    nff.polygon(
        &[(w - 1.0, w + 0.5), (-w - 1.0, w + 0.5), (-w - 1.0, -w + 0.5), (w - 1.0, -w + 0.5)]
            .map(|(x, z)| Vec3::new(x, y, z)),
    )?;

    // The rings, layer by layer away from the eye.
    let joints = joints();
    for layer in 0..size {
        for iz in 0..=layer {
            for ix in 0..=layer {
                let across = |place: u32| 2.0 * f64::from(place) - f64::from(layer);
                ring(nff, &joints, Vec3::new(across(ix), d * (f64::from(layer) + 1.0), across(iz)))?;
            }
        }
    }
    Ok(())
}

/// The corners of six pentagons around the origin, five each.
fn joints() -> Vec<Vec3> {
    let pentagon = [0, 1, 2, 3, 4].map(|j| {
        let angle = 2.0 * PI * f64::from(j) / 5.0;
        let (sine, cosine) = sin_cos(angle);
        Vec3::new(cosine, sine, 0.0) * (1.0 / (1.0 + RADIUS))
    });
    // The other five lean over by the angle between two faces of a dodecahedron.
    let lean = rotation_x(2.0 * acos(sin_cos(PI / 3.0).1 / sin_cos(PI / 5.0).0));
    let mut joints = pentagon.to_vec();
    for m in 1..=5 {
        let turn = rotation_z(PI * (2.0 * f64::from(m) - 1.0) / 5.0);
        joints.extend(pentagon.map(|corner| turn * (lean * corner)));
    }
    joints
}

fn ring(nff: &mut Nff<'_>, joints: &[Vec3], offset: Vec3) -> io::Result<()> {
    for (pentagon, color) in joints.chunks_exact(5).zip(COLORS) {
        nff.surface(color, [0.5, 0.2, 3.0827, 0.0, 0.0])?;
        for (e, &joint) in pentagon.iter().enumerate() {
            let base = offset + joint;
            let apex = offset + pentagon[(e + 4) % 5];
            nff.cone(&Cone { base, base_radius: RADIUS, apex, apex_radius: RADIUS })?;
            nff.sphere(base, RADIUS)?;
        }
    }
    Ok(())
}
