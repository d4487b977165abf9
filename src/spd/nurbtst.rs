//! nurbtst: one bicubic B-spline patch as 1500 triangles with normals that point the wrong way.
//!
//! What it tests: repair of the winding. All vertex normals oppose the order of the vertices, a fault of the
//! original that makes it a good trial for readers. Neither size nor resolution has an effect.
//!
//! Why single precision: the original computes parameters and basis in it, and the last two digits of the
//! file depend on that.
//!
//! Source: SPD 3.14; C. de Boor, "On Calculating with B-Splines", Journal of Approximation Theory 6, 1972, 50-62.

use super::nff::{Nff, View};
use super::tessellate::Patch;
use super::turn::{rotation_x, rotation_y};
use super::{Counts, SpdScene};
use crate::math::{Affine3, Vec3, radians, unit};
use std::io;

pub(super) const SCENE: SpdScene = SpdScene {
    name: "nurbtst",
    default_size: 1,
    summary: "a B-spline patch whose normals oppose the winding: a test for readers",
    sized: false,
    fixed_resolution: None,
    view,
    body,
    count: |_, _| Counts { pp: 2 * (STEPS_U * STEPS_V) as u128, l: 1, f: 1, ..Counts::default() },
};

/// Heights of the control points: x is the place in a row, y the number of the row.
const HEIGHTS: [[f64; 5]; 6] = [
    [0.0, 3.0, -3.0, 3.0, 0.0],
    [0.0, 0.0, 0.0, 0.0, 0.0],
    [0.0, 0.0, 5.0, 0.0, 0.0],
    [0.0, 0.0, 5.0, 0.0, 0.0],
    [0.0, 0.0, 0.0, 0.0, 0.0],
    [0.0, -3.0, 3.0, -3.0, 0.0],
];
const KNOTS_U: [f32; 10] = [0.0, 0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 3.0, 3.0, 3.0];
const KNOTS_V: [f32; 9] = [0.0, 0.0, 0.0, 0.0, 1.0, 2.0, 2.0, 2.0, 2.0];
const ORDER: usize = 4;
const STEPS_U: usize = 30;
const STEPS_V: usize = 25;

fn view(_size: u32) -> View {
    View {
        background: [0.0; 3],
        from: Vec3::new(0.0, 5.0, -10.0),
        at: Vec3::ZERO,
        up: Vec3::Y,
        angle: 30.0,
        hither: 0.001,
        resolution: 256,
        lights: vec![Vec3::new(0.0, 50.0, -10.0)],
    }
}

fn body(nff: &mut Nff<'_>, _size: u32) -> io::Result<()> {
    nff.surface([1.0, 0.0, 0.0], [0.7, 0.0, 45.2776, 0.0, 1.0])?;
    let turn = rotation_y(radians(30.0)) * rotation_x(radians(-90.0));
    let scene_from_patch = Affine3::from_mat3(turn) * Affine3::from_translation(Vec3::new(-2.0, -2.5, 0.0));
    let across: Vec<_> = parameters(2.0, STEPS_V).map(|v| basis(&KNOTS_V, v)).collect();
    let row = |u: f32| -> Vec<(Vec3, Vec3)> {
        let along = basis(&KNOTS_U, u);
        let vertices = across.iter().map(|across| vertex(&along, across));
        vertices.map(|(p, n)| (scene_from_patch.transform_point3(p), scene_from_patch.transform_vector3(n))).collect()
    };

    let rows: Vec<_> = parameters(3.0, STEPS_U).map(row).collect();
    for pair in rows.windows(2) {
        for j in 0..STEPS_V {
            let (last, next) = (&pair[0], &pair[1]);
            for corners in [[last[j], next[j], next[j + 1]], [last[j], next[j + 1], last[j + 1]]] {
                nff.patch(Patch { points: corners.map(|c| c.0), normals: corners.map(|c| c.1) })?;
            }
        }
    }
    Ok(())
}

/// From 0 to about `end`, added up step by step: the last may fall short of the end or pass it.
fn parameters(end: f32, steps: usize) -> impl Iterator<Item = f32> {
    let step = end / steps as f32;
    std::iter::successors(Some(0.0_f32), move |at| Some(at + step)).take(steps + 1)
}

/// Value and derivative of every basis function at one parameter.
struct Basis {
    value: Vec<f32>,
    slope: Vec<f32>,
}

/// The cubic basis at `t`, by de Boor's recurrence from steps to parabolas to cubics.
fn basis(knots: &[f32], t: f32) -> Basis {
    // Order 1: one where t lies, zero elsewhere. The last stretch goes on beyond its end.
    let controls = knots.len() - ORDER;
    let mut value: Vec<f32> =
        knots.windows(2).map(|span| if span[0] <= t && t < span[1] { 1.0 } else { 0.0 }).collect();
    if t >= knots[knots.len() - 1] {
        value[controls - 1] = 1.0;
    }
    let mut slope = vec![0.0_f32; value.len()];

    // 0 / 0 occurs where knots coincide, and means 0.
    let term = |factor: f32, function: f32, width: f32| if function == 0.0 { 0.0 } else { factor * function / width };
    for order in 2..=ORDER {
        for i in 0..knots.len() - order {
            let rising = knots[i + order - 1] - knots[i];
            let falling = knots[i + order] - knots[i + 1];
            let (past, left) = (t - knots[i], knots[i + order] - t);
            let (here, next) = (value[i], value[i + 1]);
            slope[i] = term(1.0, here, rising) - term(1.0, next, falling)
                + term(past, slope[i], rising)
                + term(left, slope[i + 1], falling);
            value[i] = term(past, here, rising) + term(left, next, falling);
        }
    }
    value.truncate(controls);
    slope.truncate(controls);
    Basis { value, slope }
}

/// Point and unit normal of the patch; weights multiply in single precision, sums are double.
fn vertex(u: &Basis, v: &Basis) -> (Vec3, Vec3) {
    let (mut point, mut along_u, mut along_v) = (Vec3::ZERO, Vec3::ZERO, Vec3::ZERO);
    for (i, row) in HEIGHTS.iter().enumerate() {
        for (j, &height) in row.iter().enumerate() {
            let control = Vec3::new(j as f64, i as f64, height);
            point += control * f64::from(u.value[i] * v.value[j]);
            along_u += control * f64::from(u.slope[i] * v.value[j]);
            along_v += control * f64::from(u.value[i] * v.slope[j]);
        }
    }
    (point, unit(along_v.cross(along_u)).unwrap_or(Vec3::ZERO))
}
