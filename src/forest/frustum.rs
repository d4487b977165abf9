//! Frustum: what of the world a picture can show, as planes, and which cells reach into it.
//!
//! matrix -FRUSTUM-> planes -> is a sphere in view?
//!
//! Points inside have clip coordinates with -w <= x <= w, and so on: each side is a linear test, and its plane is a sum of two rows of the
//! matrix. Rows of the projection alone give planes in *eye* space; rows of projection times view give planes in *world* space. The paper
//! does not say which, and testing spheres of the world with planes of the eye hides half of the forest.
//!
//! Planes are divided by the length of their normals, so that distances are metres and can be held against the radius of a sphere.
//!
//! Space: that of the matrix. Eye space here is x right, y up, z along the view; near and far are 0 <= z <= w ([`Near::Zero`]); in
//! OpenGL's they are -w <= z <= w ([`Near::MinusW`]).
//! Source: G. Gribb, K. Hartmann, "Fast Extraction of Viewing Frustum Planes from the World-View-Projection Matrix", 2001; A. Falcão,
//! M. Próspero dos Santos. Cost: one product a plane and sphere.

use crate::math::{Mat4, Vec3, radians, tan};
use crate::scene::Camera;

/// All points with `normal . p + offset >= 0`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Plane {
    /// Unit, pointing inward; zero where the plane bounds nothing (a far plane infinitely far).
    pub normal: Vec3,
    /// Distance of the origin.
    pub offset: f64,
}

impl Plane {
    /// How far inside a point is; below 0 outside.
    #[must_use]
    #[inline]
    pub fn distance(&self, point: Vec3) -> f64 {
        self.normal.dot(point) + self.offset
    }
}

/// What z is on the near plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Near {
    /// 0: the near plane is the third row alone.
    Zero,
    /// -w, as in OpenGL.
    MinusW,
}

/// The planes around a view: left, right, bottom, top, near, far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frustum {
    /// In that order.
    pub planes: [Plane; 6],
}

impl Frustum {
    /// The planes of `clip_from_space`, in that space.
    #[must_use]
    pub fn new(clip_from_space: &Mat4, near: Near) -> Frustum {
        let [x, y, z, w] = [0, 1, 2, 3].map(|row| clip_from_space.row(row));
        let front = if near == Near::Zero { z } else { w + z };
        let planes = [w + x, w - x, w + y, w - y, front, w - z].map(|row| {
            let normal = row.truncate();
            let length = normal.length();
            if length > 1e-12 * w.truncate().length() {
                Plane { normal: normal / length, offset: row.w / length }
            } else {
                Plane::default()
            }
        });
        Frustum { planes }
    }

    /// The planes of a camera with a focal length in pixels and a picture of `size` pixels, world space.
    ///
    /// Looking straight along `up` there is no right and no left: then only what is behind the camera is out of view.
    #[must_use]
    pub fn of_camera(camera: &Camera, focal: f64, size: (u32, u32)) -> Frustum {
        Frustum::new(&(clip_from_eye(camera, focal, size) * eye_from_world(camera)), Near::Zero)
    }

    /// Whether some of a sphere may be inside: not where it is wholly outside of one plane. A few spheres near edges of the view pass
    /// that no picture shows; none that it shows is refused.
    #[must_use]
    #[inline]
    pub fn sees(&self, center: Vec3, radius: f64) -> bool {
        self.planes.iter().all(|plane| plane.distance(center) >= -radius)
    }

    /// Whether all of a sphere is inside.
    #[must_use]
    #[inline]
    pub fn holds(&self, center: Vec3, radius: f64) -> bool {
        self.planes.iter().all(|plane| plane.normal == Vec3::ZERO || plane.distance(center) >= radius)
    }
}

/// The sphere around a cell: half the diagonal of the box of its land and its tallest tree, around the box's middle.
#[must_use]
pub fn sphere([west, south]: [f64; 2], side: f64, (low, high): (f64, f64)) -> (Vec3, f64) {
    let center = Vec3::new(west + side / 2.0, south + side / 2.0, (low + high) / 2.0);
    (center, 0.5 * (2.0 * side * side + (high - low) * (high - low)).sqrt())
}

/// Eye space from world space: x right, y up, z along the view.
#[must_use]
pub fn eye_from_world(camera: &Camera) -> Mat4 {
    let ahead = (camera.at - camera.from).normalize_or_zero();
    let right = ahead.cross(camera.up).normalize_or_zero();
    let rows = [right, right.cross(ahead), ahead].map(|axis| axis.extend(-axis.dot(camera.from)));
    Mat4::from_cols(rows[0], rows[1], rows[2], glam::DVec4::W).transpose()
}

/// Clip space from eye space, 0 <= z <= w. `focal` is in pixels: what a length of 1 has at distance 1.
#[must_use]
pub fn clip_from_eye(camera: &Camera, focal: f64, (width, height): (u32, u32)) -> Mat4 {
    let near = if camera.hither > 0.0 { camera.hither } else { (camera.at - camera.from).length() / 1000.0 };
    // z = w at the far plane; without one z is w minus the near distance and never gets there.
    let (scale, shift) = match camera.yon {
        Some(far) if far > near => (far / (far - near), -near * far / (far - near)),
        _ => (1.0, -near),
    };
    let half = |pixels: u32| 2.0 * focal / f64::from(pixels.max(1));
    Mat4::from_cols_array_2d(&[
        [half(width), 0.0, 0.0, 0.0],
        [0.0, half(height), 0.0, 0.0],
        [0.0, 0.0, scale, 1.0],
        [0.0, 0.0, shift, 0.0],
    ])
}

/// Pixels that a length of 1 has at distance 1, for a camera with a picture of this size.
#[must_use]
pub fn focal(camera: &Camera, (width, height): (u32, u32)) -> f64 {
    f64::from(width.min(height).max(1)) / (2.0 * tan(radians(camera.angle) / 2.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Place;

    fn camera(turn: f64, pitch: f64, yon: Option<f64>) -> Camera {
        let from = Vec3::new(1234.5, -77.0, 310.0);
        let [cos, sin] = [crate::math::cos(turn), crate::math::sin(turn)];
        let at = from + Vec3::new(cos, sin, crate::math::tan(pitch)) * 50.0;
        Camera { from, at, up: Vec3::Z, angle: 45.0, hither: 0.5, yon, resolution: (640, 480), place: Place::default() }
    }

    #[test]
    fn planes_of_a_known_view() {
        // 90 degrees across a square picture, eye space: x = -z, x = z and so on.
        let camera = Camera { hither: 2.0, yon: Some(10.0), ..camera(0.0, 0.0, None) };
        let frustum = Frustum::new(&clip_from_eye(&camera, 100.0, (200, 200)), Near::Zero);
        let half = 0.5_f64.sqrt();
        let expected = [
            (Vec3::new(half, 0.0, half), 0.0),
            (Vec3::new(-half, 0.0, half), 0.0),
            (Vec3::new(0.0, half, half), 0.0),
            (Vec3::new(0.0, -half, half), 0.0),
            (Vec3::Z, -2.0),
            (Vec3::NEG_Z, 10.0),
        ];
        for (plane, (normal, offset)) in frustum.planes.iter().zip(expected) {
            assert!((plane.normal - normal).length() < 1e-12 && (plane.offset - offset).abs() < 1e-12, "{plane:?}");
        }
        // OpenGL's z runs from -w to w: its near plane comes out the same.
        let gl = Mat4::from_cols_array_2d(&[
            [1.0, 0.0, 0.0, 0.0],
            [0.0, 1.0, 0.0, 0.0],
            [0.0, 0.0, 1.5, 1.0],
            [0.0, 0.0, -5.0, 0.0],
        ]);
        let near = Frustum::new(&gl, Near::MinusW).planes[4];
        assert!((near.normal - Vec3::Z).length() < 1e-12 && (near.offset + 2.0).abs() < 1e-12, "{near:?}");
    }

    #[test]
    fn planes_of_the_eye_and_of_the_world_are_the_same() {
        let camera = camera(2.0, -0.4, Some(2000.0));
        let (size, view) = ((640, 480), eye_from_world(&camera));
        let focal = focal(&camera, size);
        let eye = Frustum::new(&clip_from_eye(&camera, focal, size), Near::Zero);
        let world = Frustum::of_camera(&camera, focal, size);
        for step in 0..100 {
            let turn = f64::from(step);
            let direction = Vec3::new(crate::math::cos(turn), crate::math::sin(turn), -0.2);
            let point = camera.from + direction * (turn * 17.0);
            for (in_eye, in_world) in eye.planes.iter().zip(&world.planes) {
                let distances = (in_eye.distance(view.transform_point3(point)), in_world.distance(point));
                assert!((distances.0 - distances.1).abs() < 1e-7, "{distances:?}");
            }
        }
    }

    #[test]
    fn no_cell_that_shows_is_refused() {
        let (side, mut seen, mut refused) = (240.0, 0, 0);
        for view in 0..60 {
            let yon = (view % 3 == 0).then_some(1500.0);
            let camera = camera(f64::from(view) * 0.37, f64::from(view % 7) * 0.3 - 1.1, yon);
            let size = if view % 2 == 0 { (640, 480) } else { (300, 700) };
            let clip = clip_from_eye(&camera, focal(&camera, size), size) * eye_from_world(&camera);
            let frustum = Frustum::of_camera(&camera, focal(&camera, size), size);
            for (column, row) in (-8..12_i32).flat_map(|column| (-9..9).map(move |row| (column, row))) {
                let corner = [f64::from(column) * side, f64::from(row) * side];
                let range = (100.0, 100.0 + f64::from((column * row).rem_euclid(9)) * 20.0 + 30.0);
                // Brute force: any point of a fine lattice in the box.
                let shows = (0..9 * 9 * 5).any(|index| {
                    let [x, y, z] = [index % 9, index / 9 % 9, index / 81].map(f64::from);
                    let z = range.0 + (range.1 - range.0) * z / 4.0;
                    let point = clip * Vec3::new(corner[0] + side * x / 8.0, corner[1] + side * y / 8.0, z).extend(1.0);
                    point.x.abs() <= point.w && point.y.abs() <= point.w && (0.0..=point.w).contains(&point.z)
                });
                let (center, radius) = sphere(corner, side, range);
                let passes = frustum.sees(center, radius);
                assert!(passes || !shows, "view {view}: cell {column} {row}");
                (seen, refused) = (seen + i32::from(shows), refused + i32::from(!passes));
            }
        }
        assert!(seen > 1000 && refused > 10_000, "{seen} {refused}");
    }

    #[test]
    fn straight_down_along_up_refuses_nothing_ahead() {
        let from = Vec3::new(0.0, 0.0, 500.0);
        let camera = Camera { from, at: Vec3::ZERO, up: Vec3::Z, ..camera(0.0, 0.0, None) };
        let frustum = Frustum::of_camera(&camera, 500.0, (640, 480));
        assert!(frustum.sees(Vec3::ZERO, 1.0) && frustum.sees(Vec3::new(300.0, 0.0, 0.0), 1.0));
        assert!(frustum.planes.iter().all(|plane| plane.normal.is_finite() && plane.offset.is_finite()));
    }
}
