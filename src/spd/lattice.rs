//! lattice: a cubic grid of spheres joined by thin cylinders, seen from inside.
//!
//! What it tests: great depth complexity, an eye within the scene with hither 0, a surface line for every object.
//!
//! Source: SPD 3.14.

use super::nff::{NO_HIGHLIGHT, Nff, SKY, View};
use super::tessellate::Cone;
use super::{Counts, SpdScene, power};
use crate::math::Vec3;
use std::io;

pub(super) const SCENE: SpdScene = SpdScene {
    name: "lattice",
    default_size: 12,
    summary: "(size + 1)^3 spheres joined by rods along the axes, seen from inside",
    sized: true,
    fixed_resolution: None,
    view,
    body,
    count: |size, _| {
        let s = u128::from(size);
        let (spheres, rods) = (power(s + 1, 3), 3 * s * power(s + 1, 2));
        Counts { s: spheres, c: rods, l: 6, f: spheres + rods, ..Counts::default() }
    },
};

fn view(size: u32) -> View {
    let cells = f64::from(size);
    let middle = (f64::from(size / 2) + 0.5) / cells;
    let down = 1.0 / (2.0 * cells);
    View {
        background: SKY,
        from: Vec3::new(middle, 1.0, 1.0 - down),
        at: Vec3::new(middle, -1.0, -1.0 - down),
        up: Vec3::new(0.2, 1.0, 0.0),
        angle: 60.0,
        hither: 0.0,
        resolution: 512,
        lights: vec![
            Vec3::new(2.0, 0.5, 0.5),
            Vec3::new(-1.0, 0.5, 0.5),
            Vec3::new(0.5, 2.0, 0.5),
            Vec3::new(0.5, -1.0, 0.5),
            Vec3::new(0.5, 0.5, 2.0),
            Vec3::new(0.5, 0.5, -1.0),
        ],
    }
}

fn body(nff: &mut Nff<'_>, size: u32) -> io::Result<()> {
    for x in 0..=size {
        for y in 0..=size {
            for z in 0..=size {
                node(nff, [x, y, z], size)?;
            }
        }
    }
    Ok(())
}

/// A sphere, and from it a rod along each axis that goes on.
fn node(nff: &mut Nff<'_>, place: [u32; 3], size: u32) -> io::Result<()> {
    let cells = f64::from(size);
    let center = place.map(|index| f64::from(index) / cells);
    nff.surface([0.9; 3], [0.5, 0.5, 3.0827, 0.0, 0.0])?;
    nff.sphere(Vec3::from_array(center), 1.0 / (4.0 * cells))?;

    // A rod begins and ends just below the surface of its spheres.
    let below = 0.25 / cells * 0.5 * 0.99;
    for axis in 0..3 {
        if place[axis] < size {
            let mut color = [0.1; 3];
            color[axis] = 0.9;
            let (mut base, mut apex) = (center, center);
            base[axis] += below;
            apex[axis] = apex[axis] + 1.0 / cells - below;
            let [base, apex] = [base, apex].map(Vec3::from_array);
            let radius = 1.0 / (16.0 * cells);
            nff.surface(color, [0.99, 0.0, NO_HIGHLIGHT, 0.0, 0.0])?;
            nff.cone(&Cone { base, base_radius: radius, apex, apex_radius: radius })?;
        }
    }
    Ok(())
}
