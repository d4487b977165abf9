//! Eight: what is computed of vertices that survivors asked for, eight vertices at a time.
//!
//! asked -EIGHT-> corners of shared triangles; light
//!
//! Why the same bytes: sums, products and quotients are rounded alike in one lane and in eight, light is written once for both
//! ([`crate::screen::lane`]), and places are computed in the order of [`Projection::ready`] and [`crate::screen::Grid::snap`].
//!
//! Space: eye space in; samples out. Cost: a few ns a vertex, and what its lights take, by eight.

use super::project::Projection;
use super::walk::Side;
use crate::math::Vec3;
use crate::screen::lane::{Lane, WHOLE};
use crate::screen::{Shader, SharedCorner};
use fearless_simd::{Level, Select, Simd, SimdBase, SimdMask, dispatch, f64x8, mask64x8};

const LANES: usize = 8;
/// Three numbers of eight vertices.
type Eight = [[f64; LANES]; 3];

/// Makes corners of shared triangles of the vertices `asked`.
pub(super) fn corners(
    level: Level,
    projection: &Projection,
    (positions, asked): (&[Vec3], &[u32]),
    (places, corners): (&mut [[i32; 2]], &mut [SharedCorner]),
) {
    dispatch!(level, simd => corners_by(simd, projection, (positions, asked), (places, corners)));
}

#[inline(always)]
fn corners_by<S: Simd>(
    simd: S,
    projection: &Projection,
    (positions, asked): (&[Vec3], &[u32]),
    (places, corners): (&mut [[i32; 2]], &mut [SharedCorner]),
) {
    let mut first = 0;
    while first < asked.len() {
        let end = (first + LANES).min(asked.len());
        let at = gathered(positions, &asked[first..end]);
        let (fixed, eye, inverse_w) = corners_of_eight(simd, projection, lanes(simd, &at));
        let mut lane = 0;
        while first + lane < end {
            let position = Vec3::new(at[0][lane], at[1][lane], at[2][lane]);
            let (eye, inverse_w) = ([eye[0][lane], eye[1][lane]], inverse_w[lane]);
            places[first + lane] = [fixed[0][lane] as i32, fixed[1][lane] as i32];
            corners[first + lane] = SharedCorner { position, eye, inverse_w };
            lane += 1;
        }
        first = end;
    }
}

/// Of points in eye space: places in 1/256 of a sample; x and y of the eye points that clip space gives back; 1/w.
#[inline(always)]
fn corners_of_eight<S: Simd>(
    simd: S,
    projection: &Projection,
    [x, y, z]: [f64x8<S>; 3],
) -> ([f64x8<S>; 2], [f64x8<S>; 2], f64x8<S>) {
    let (screen, all) = (&projection.planes.screen, |number: f64| f64x8::splat(simd, number));
    let k = [all(projection.clip_from_eye.0), all(projection.clip_from_eye.1)];
    let half = [all(screen.half.0), all(screen.half.1)];
    let steps = screen.grid.steps() as f64;
    let clip = [x * k[0], y * k[1]];
    let from_corner = [(z + clip[0]) * half[0], (z - clip[1]) * half[1]];
    let mut fixed = [z; 2];
    let mut axis = 0;
    while axis < 2 {
        // Below 0 it does not matter which whole number it is: it is held at 0.
        let step = from_corner[axis] / z * all(steps);
        let rounded = all(WHOLE).simd_gt(step).select((step + all(WHOLE)) - all(WHOLE), step);
        let rounded = all(0.0).simd_gt(step).select(all(0.0), rounded);
        fixed[axis] = (rounded * all(1.0 / steps)).hold(all(0.0), all(2.0) * half[axis]) * all(256.0);
        axis += 1;
    }
    (fixed, [clip[0] / k[0], clip[1] / k[1]], all(1.0) / z)
}

/// Vertices of one surface that are to be lit.
pub(super) struct Lit<'a> {
    pub shader: &'a Shader,
    pub surface: u32,
    pub positions: &'a [Vec3],
    pub normals: &'a [Vec3],
    /// What the color of the surface is multiplied with at a vertex, linear light.
    pub factor: Option<&'a dyn Fn(u32) -> [f64; 3]>,
}

impl Lit<'_> {
    /// Computes the light of vertices, each seen from one side; returns the highlights.
    pub fn light(&self, level: Level, asked: &[(u32, Side)], lit: &mut [[f64; 3]]) -> u64 {
        let mut powers = 0;
        dispatch!(level, simd => self.light_by(simd, asked, lit, &mut powers));
        powers
    }

    #[inline(always)]
    fn light_by<S: Simd>(&self, simd: S, asked: &[(u32, Side)], lit: &mut [[f64; 3]], powers: &mut u64) {
        let mut first = 0;
        while first < asked.len() {
            let end = (first + LANES).min(asked.len());
            let [at, normal, factor] = self.gathered(&asked[first..end]);
            let [at, normal, factor] = [lanes(simd, &at), lanes(simd, &normal), lanes(simd, &factor)];
            let factor = self.factor.map(|_| factor);
            let wanted = mask64x8::from_bitmask(simd, (1 << (end - first)) - 1);
            let light = self.shader.lights_at(self.surface, (at, normal), factor, (wanted, powers));
            let mut lane = 0;
            while first + lane < end {
                lit[first + lane] = [light[0][lane], light[1][lane], light[2][lane]];
                lane += 1;
            }
            first = end;
        }
    }

    /// Positions, normals and factors of up to eight vertices; the last one is repeated.
    // Not inlined where lanes are compiled: there the loop becomes gathers, which take longer.
    #[inline(never)]
    fn gathered(&self, asked: &[(u32, Side)]) -> [Eight; 3] {
        let mut eight = [[[0.0; LANES]; 3]; 3];
        for lane in 0..LANES {
            let (vertex, side) = asked[lane.min(asked.len() - 1)];
            let normal = side.turn(self.normals[vertex as usize]);
            put(&mut eight[0], lane, self.positions[vertex as usize].to_array());
            put(&mut eight[1], lane, normal.to_array());
            if let Some(factor) = self.factor {
                put(&mut eight[2], lane, factor(vertex));
            }
        }
        eight
    }
}

/// Up to eight of `positions`; the last one is repeated.
#[inline(never)]
fn gathered(positions: &[Vec3], asked: &[u32]) -> Eight {
    let mut eight = [[0.0; LANES]; 3];
    for lane in 0..LANES {
        put(&mut eight, lane, positions[asked[lane.min(asked.len() - 1)] as usize].to_array());
    }
    eight
}

#[inline(always)]
fn put(eight: &mut Eight, lane: usize, numbers: [f64; 3]) {
    (eight[0][lane], eight[1][lane], eight[2][lane]) = (numbers[0], numbers[1], numbers[2]);
}

#[inline(always)]
fn lanes<S: Simd>(simd: S, eight: &Eight) -> [f64x8<S>; 3] {
    [f64x8::from_slice(simd, &eight[0]), f64x8::from_slice(simd, &eight[1]), f64x8::from_slice(simd, &eight[2])]
}
