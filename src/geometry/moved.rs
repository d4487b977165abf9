//! Moved: vertices and normals in eye space, eight at a time.
//!
//! local -MOVED-> eye space, outcodes
//!
//! Why the same bytes: in every lane the operations are those of [`Affine3::transform_point3`], of [`View::to_eye`] and of a matrix times a vector,
//! in their order; a test holds both against each other.
//!
//! Space: local in, eye space out. Cost: some 4 ns a vertex.

use crate::math::{Affine3, Mat3, Vec3};
use crate::plan::View;
use fearless_simd::{Level, Simd, SimdBase, SimdMask, dispatch, f64x8};

const LANES: usize = 8;

/// Three numbers of eight vertices, side by side.
type Three<S> = [f64x8<S>; 3];

/// Moves `vertices` from local to eye space.
pub(super) fn positions(level: Level, (map, view): (&Affine3, &View), vertices: &[Vec3], eyes: &mut [Vec3]) {
    dispatch!(level, simd => positions_by(simd, (map, view), vertices, eyes));
}

#[inline(always)]
fn positions_by<S: Simd>(simd: S, (map, view): (&Affine3, &View), vertices: &[Vec3], eyes: &mut [Vec3]) {
    let columns = columns(simd, &map.matrix3);
    let translation = all(simd, map.translation);
    let (eye, per_unit) = (all(simd, view.eye), f64x8::splat(simd, 1.0 / view.unit));
    let turn = self::columns(simd, &view.eye_from_world);
    let mut first = 0;
    while first < vertices.len() {
        let end = (first + LANES).min(vertices.len());
        let world = times(&columns, side_by_side(simd, &vertices[first..end]));
        let mut from_eye = world;
        let mut axis = 0;
        while axis < 3 {
            from_eye[axis] = ((world[axis] + translation[axis]) - eye[axis]) * per_unit;
            axis += 1;
        }
        put(times(&turn, from_eye), &mut eyes[first..end]);
        first = end;
    }
}

/// Turns `normals` from world to eye space.
pub(super) fn normals(level: Level, view: &View, normals: &[Vec3], eyes: &mut [Vec3]) {
    dispatch!(level, simd => normals_by(simd, view, normals, eyes));
}

#[inline(always)]
fn normals_by<S: Simd>(simd: S, view: &View, normals: &[Vec3], eyes: &mut [Vec3]) {
    let turn = columns(simd, &view.eye_from_world);
    let mut first = 0;
    while first < normals.len() {
        let end = (first + LANES).min(normals.len());
        put(times(&turn, side_by_side(simd, &normals[first..end])), &mut eyes[first..end]);
        first = end;
    }
}

/// Of every point in eye space, bits of the planes it lies outside of, as far as they are among `planes`.
pub(super) fn outcodes(level: Level, (view, planes): (&View, u8), eyes: &[Vec3], codes: &mut [u8]) {
    dispatch!(level, simd => outcodes_by(simd, (view, planes), eyes, codes));
}

#[inline(always)]
fn outcodes_by<S: Simd>(simd: S, (view, planes): (&View, u8), eyes: &[Vec3], codes: &mut [u8]) {
    let (kx, ky) = view.clip_from_eye();
    let [kx, ky, hither, yon, zero] = [kx, ky, view.hither, view.yon, 0.0].map(|number| f64x8::splat(simd, number));
    let mut first = 0;
    while first < eyes.len() {
        let end = (first + LANES).min(eyes.len());
        let [x, y, w] = side_by_side(simd, &eyes[first..end]);
        // The same products as the clipper sees, so that both agree on what lies on a plane.
        let (x, y, behind) = (x * kx, y * ky, zero - w);
        let outside =
            [w.simd_lt(hither), x.simd_lt(behind), x.simd_gt(w), y.simd_lt(behind), y.simd_gt(w), w.simd_gt(yon)];
        let any = outside[0] | outside[1] | outside[2] | outside[3] | outside[4] | outside[5];
        codes[first..end].fill(0);
        if any.any_true() {
            let mut plane = 0;
            while plane < outside.len() {
                let bits = outside[plane].to_bitmask();
                for (lane, code) in codes[first..end].iter_mut().enumerate() {
                    *code |= ((bits >> lane & 1) as u8) << plane & planes;
                }
                plane += 1;
            }
        }
        first = end;
    }
}

#[inline(always)]
fn all<S: Simd>(simd: S, v: Vec3) -> Three<S> {
    [f64x8::splat(simd, v.x), f64x8::splat(simd, v.y), f64x8::splat(simd, v.z)]
}

#[inline(always)]
fn columns<S: Simd>(simd: S, matrix: &Mat3) -> [Three<S>; 3] {
    [all(simd, matrix.x_axis), all(simd, matrix.y_axis), all(simd, matrix.z_axis)]
}

/// A matrix times vectors.
#[inline(always)]
fn times<S: Simd>(columns: &[Three<S>; 3], [x, y, z]: Three<S>) -> Three<S> {
    let mut product = [x; 3];
    let mut axis = 0;
    while axis < 3 {
        product[axis] = columns[0][axis] * x + columns[1][axis] * y + columns[2][axis] * z;
        axis += 1;
    }
    product
}

/// Up to eight vectors; missing ones are 0.
#[inline(always)]
fn side_by_side<S: Simd>(simd: S, vectors: &[Vec3]) -> Three<S> {
    let eight = turned(vectors);
    [f64x8::from_slice(simd, &eight[0]), f64x8::from_slice(simd, &eight[1]), f64x8::from_slice(simd, &eight[2])]
}

// Not inlined where lanes are compiled: there the loop becomes gathers, which take longer.
#[inline(never)]
fn turned(vectors: &[Vec3]) -> [[f64; LANES]; 3] {
    let mut eight = [[0.0; LANES]; 3];
    for (lane, vector) in vectors.iter().take(LANES).enumerate() {
        (eight[0][lane], eight[1][lane], eight[2][lane]) = (vector.x, vector.y, vector.z);
    }
    eight
}

#[inline(always)]
fn put<S: Simd>(eight: Three<S>, vectors: &mut [Vec3]) {
    let mut numbers = [[0.0; LANES]; 3];
    eight[0].store_slice(&mut numbers[0]);
    eight[1].store_slice(&mut numbers[1]);
    eight[2].store_slice(&mut numbers[2]);
    for (lane, vector) in vectors.iter_mut().enumerate() {
        *vector = Vec3::new(numbers[0][lane], numbers[1][lane], numbers[2][lane]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Camera;

    #[test]
    fn lanes_move_as_vectors_do() {
        let number = |seed: u32| f64::from(seed.wrapping_mul(2_654_435_761) >> 7) / 1e7 - 1.5;
        let vectors: Vec<Vec3> =
            (0..37).map(|n| Vec3::new(number(3 * n), number(3 * n + 1), number(3 * n + 2))).collect();
        let (from, at, up) = (Vec3::new(0.3, -0.2, -1.1), Vec3::ZERO, Vec3::Y);
        let (resolution, place) = ((64, 48), crate::scene::Place::default());
        let camera = Camera { from, at, up, angle: 71.0, hither: 0.7, yon: Some(1.9), resolution, place };
        let choices = crate::plan::Choices { size: Some((64, 48)), ..crate::plan::Choices::default() };
        let view = View::new(&camera, &choices).expect("a view");
        let map = Affine3 { matrix3: Mat3::from_cols(vectors[3], vectors[4], vectors[5]), translation: vectors[6] };
        for instructions in crate::screen::Instructions::ALL {
            let level = instructions.level();
            let (mut eyes, mut turned, mut codes) = (vectors.clone(), vectors.clone(), vec![0xFF; vectors.len()]);
            positions(level, (&map, &view), &vectors, &mut eyes);
            normals(level, &view, &vectors, &mut turned);
            outcodes(level, (&view, 0b11_1110), &eyes, &mut codes);
            for (number, &vector) in vectors.iter().enumerate() {
                assert_eq!(eyes[number], view.to_eye(map.transform_point3(vector)));
                assert_eq!(turned[number], view.eye_from_world * vector);
                let ((kx, ky), eye) = (view.clip_from_eye(), eyes[number]);
                let (x, y, w) = (eye.x * kx, eye.y * ky, eye.z);
                let outside = [false, x < -w, x > w, y < -w, y > w, w > view.yon];
                let expected = (0..).zip(outside).fold(0, |code, (plane, out)| code | u8::from(out) << plane);
                assert_eq!(codes[number], expected);
            }
            assert!(codes.contains(&0) && codes.iter().any(|&code| code != 0));
        }
    }
}
