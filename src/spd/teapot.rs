//! teapot: Newell's teapot of 32 bicubic Bezier patches on a checkered board.
//!
//! What it tests: smooth shading from vertex normals, patches that shrink to a point (the knob and the bottom),
//! gaps that show the inside (draw it two-sided).
//! `size` squares a side on the board and 2 * size^2 triangles a patch; those that have no area are dropped.
//!
//! Source: SPD 3.14; M. Newell, "The Utilization of Procedure Models in Digital Image Synthesis", doctoral thesis,
//! University of Utah, 1975. Control points: `crate::model`'s `newell`.

use super::nff::{Nff, SKY, View};
use super::tessellate::Patch;
use super::{Counts, SpdScene};
use crate::math::{Vec3, unit};
use crate::model::newell::{Grid, grids};
use std::io;

pub(super) const SCENE: SpdScene = SpdScene {
    name: "teapot",
    default_size: 6,
    summary: "Newell's teapot on a checkered board, 32 curved patches in 2 * size^2 triangles each",
    sized: true,
    fixed_resolution: None,
    view,
    body,
    count: |size, _| {
        let s = u128::from(size);
        Counts { p: s * s, pp: (64 * s * s).saturating_sub(8 * s), l: 2, f: 3, ..Counts::default() }
    },
};

fn view(_size: u32) -> View {
    View {
        background: SKY,
        from: Vec3::new(4.86, 7.2, 5.4),
        at: Vec3::ZERO,
        up: Vec3::Z,
        angle: 45.0,
        hither: 1.0,
        resolution: 512,
        lights: vec![Vec3::new(-3.1, 9.8, 12.1), Vec3::new(11.3, 5.1, 8.8)],
    }
}

fn body(nff: &mut Nff<'_>, size: u32) -> io::Result<()> {
    nff.surface([1.0; 3], [0.5, 0.5, 4.81884, 0.0, 0.0])?;
    squares(nff, size, 1)?;
    nff.surface([0.5; 3], [0.5, 0.5, 4.81884, 0.0, 0.0])?;
    squares(nff, size, 0)?;
    nff.surface([1.0, 0.5, 0.1], [0.75, 0.25, 3.0827, 0.0, 0.0])?;
    grids().iter().try_for_each(|grid| patch(nff, &PowerForm::new(grid), size))
}

/// The squares of one color: those whose row and column add up to an odd (1) or even (0) number.
fn squares(nff: &mut Nff<'_>, size: u32, parity: u32) -> io::Result<()> {
    let at = |place: u32| 4.0 * (2.0 * f64::from(place) / f64::from(size) - 1.0);
    for i in 0..size {
        for j in (0..size).filter(|j| (i + j) % 2 == parity) {
            let (x0, x1, y0, y1) = (at(i), at(i + 1), at(j), at(j + 1));
            nff.polygon(&[(x0, y0), (x1, y0), (x1, y1), (x0, y1)].map(|(x, y)| Vec3::new(x, y, 0.0)))?;
        }
    }
    Ok(())
}

/// Point and unit normal.
type Vertex = (Vec3, Vec3);

/// Draws a patch row by row.
fn patch(nff: &mut Nff<'_>, form: &PowerForm, size: u32) -> io::Result<()> {
    let row = |i: u32| -> Vec<Vertex> {
        let a = f64::from(i) / f64::from(size);
        (0..=size).map(|j| form.vertex(a, f64::from(j) / f64::from(size))).collect()
    };
    let mut last = row(0);
    for i in 1..=size {
        let next = row(i);
        for (k, l) in last.windows(2).zip(next.windows(2)) {
            triangle(nff, [k[0], k[1], l[1]])?;
            triangle(nff, [l[1], l[0], k[0]])?;
        }
        last = next;
    }
    Ok(())
}

/// Draws a triangle, unless two of its vertices are the same pole. At a pole the patch has no normal of its own.
fn triangle(nff: &mut Nff<'_>, corners: [Vertex; 3]) -> io::Result<()> {
    let is_pole = |(point, _): &Vertex| point.x.abs() <= 1e-4 && point.y.abs() <= 1e-4;
    if corners.iter().filter(|corner| is_pole(corner)).count() >= 2 {
        return Ok(());
    }
    let normals = corners.map(|corner| match corner {
        (point, _) if is_pole(&corner) => {
            if point.z > 1.5 {
                Vec3::Z
            } else {
                Vec3::NEG_Z
            }
        }
        (_, normal) => normal,
    });
    nff.patch(Patch { points: corners.map(|corner| corner.0), normals })
}

/// From Bernstein polynomials to powers: rows are t^3, t^2, t, 1.
const POWERS: [[f64; 4]; 4] =
    [[-1.0, 3.0, -3.0, 1.0], [3.0, -6.0, 3.0, 0.0], [-3.0, 3.0, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0]];

/// A patch as a polynomial in powers of both parameters; a 4 x 4 matrix for each coordinate.
struct PowerForm {
    x: [[f64; 4]; 4],
    y: [[f64; 4]; 4],
    z: [[f64; 4]; 4],
}

impl PowerForm {
    fn new(grid: &Grid) -> Self {
        // POWERS is its own transpose, so it stands on both sides.
        let form = |coordinate: fn(&Vec3) -> f64| {
            product(&product(&POWERS, &grid.map(|row| row.map(|point| coordinate(&point)))), &POWERS)
        };
        PowerForm { x: form(|p| p.x), y: form(|p| p.y), z: form(|p| p.z) }
    }

    /// Point and normal at (a, b), both from 0 to 1. Where the patch shrinks to a point the normal is zero.
    fn vertex(&self, a: f64, b: f64) -> Vertex {
        let powers = |t: f64| [t * t * t, t * t, t, 1.0];
        let slopes = |t: f64| [3.0 * t * t, 2.0 * t, 1.0, 0.0];
        let point = self.at(&powers(a), &powers(b));
        let along_a = self.at(&slopes(a), &powers(b));
        let along_b = self.at(&powers(a), &slopes(b));
        (point, unit(along_b.cross(along_a)).unwrap_or(Vec3::ZERO))
    }

    fn at(&self, a: &[f64; 4], b: &[f64; 4]) -> Vec3 {
        let value = |form: &[[f64; 4]; 4]| {
            let inner =
                [0, 1, 2, 3].map(|c| a[0] * form[0][c] + a[1] * form[1][c] + a[2] * form[2][c] + a[3] * form[3][c]);
            inner[0] * b[0] + inner[1] * b[1] + inner[2] * b[2] + inner[3] * b[3]
        };
        Vec3::new(value(&self.x), value(&self.y), value(&self.z))
    }
}

/// The product of two matrices, given by rows.
fn product(a: &[[f64; 4]; 4], b: &[[f64; 4]; 4]) -> [[f64; 4]; 4] {
    a.map(|row| [0, 1, 2, 3].map(|c| row[0] * b[0][c] + row[1] * b[1][c] + row[2] * b[2][c] + row[3] * b[3][c]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_patch_passes_through_its_corners() {
        for grid in grids() {
            let form = PowerForm::new(&grid);
            for (a, b) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                let (point, _) = form.vertex(f64::from(a), f64::from(b));
                let corner = grid[3 * a as usize][3 * b as usize];
                assert!(point.abs_diff_eq(corner, 1e-12), "{point} {corner}");
            }
        }
    }
}
