//! tetra: Sierpinski's tetrahedron, 4^size triangles.
//!
//! What it tests: many small polygons of one surface, half of them back-facing, hidden by each other.
//! One tetrahedron becomes four of half the size at its corners, `size` - 1 times.
//!
//! Source: SPD 3.14; kindred: B. Mandelbrot, "The Fractal Geometry of Nature", Freeman, 1982.

use super::nff::{NO_HIGHLIGHT, Nff, SKY, View};
use super::{Counts, SpdScene, power};
use crate::math::Vec3;
use std::io;

pub(super) const SCENE: SpdScene = SpdScene {
    name: "tetra",
    default_size: 6,
    summary: "Sierpinski's tetrahedron: 4^size small triangles of one surface",
    sized: true,
    fixed_resolution: None,
    view,
    body,
    count: |size, _| Counts { p: power(4, size), l: 1, f: 1, ..Counts::default() },
};

/// Every other corner of a cube.
const CORNERS: [Vec3; 4] =
    [Vec3::new(-1.0, -1.0, 1.0), Vec3::new(-1.0, 1.0, -1.0), Vec3::new(1.0, -1.0, -1.0), Vec3::new(1.0, 1.0, 1.0)];

fn view(_size: u32) -> View {
    View {
        background: SKY,
        from: Vec3::new(1.022846, -3.177154, -2.174512),
        at: Vec3::new(-0.004103, -0.004103, 0.216539),
        up: Vec3::new(-0.816497, -0.816497, 0.816497),
        angle: 45.0,
        hither: 1.0,
        resolution: 512,
        lights: vec![Vec3::new(2.0, -18.0, -5.0)],
    }
}

fn body(nff: &mut Nff<'_>, size: u32) -> io::Result<()> {
    nff.surface([1.0, 0.2, 0.2], [1.0, 0.0, NO_HIGHLIGHT, 0.0, 0.0])?;
    tetrahedra(nff, size, Vec3::ZERO, 1.0)
}

/// Fills the cube around `center`, of half width `half`.
fn tetrahedra(nff: &mut Nff<'_>, depth: u32, center: Vec3, half: f64) -> io::Result<()> {
    if depth > 1 {
        return CORNERS
            .iter()
            .try_for_each(|&corner| tetrahedra(nff, depth - 1, center + corner * (half / 2.0), half / 2.0));
    }
    let v = CORNERS.map(|corner| center + corner * half);
    for outline in [[v[0], v[1], v[2]], [v[3], v[2], v[1]], [v[2], v[3], v[0]], [v[1], v[0], v[3]]] {
        nff.polygon(&outline)?;
    }
    Ok(())
}
