//! The hole of a cone: where the eye looks through both of its open ends, and how sharp the hole's corners are.
//!
//! Why: polygons lie inside the circles of both ends, each by up to the tolerance. Where the images of the two ends cross, the hole between
//! them has a corner, and a corner of angle a between two lines that move inward by t moves by t / sin(a/2). So the ends of such
//! a cone must keep to a tolerance smaller by that sine.
//!
//! Seen from the eye, the base is a circle in the plane of the apex, too (the planes are parallel): two circles in one plane cross in at
//! most two points, whose tangents are then looked at in the picture.
//!
//! Space: eye space in; a sine out. Source: our own derivation. Cost: a few dozen multiplications a cone.

use super::super::cone::{Cone, Frame};
use crate::math::{Affine3, Vec3};

/// Sharper corners are not followed: such a hole is a sliver, and four times as many segments are enough to pay.
const SHARPEST: f64 = 1.0 / 16.0;

/// The sine of half the angle of the sharpest corner of the hole that is seen; 1 where there is none.
pub(super) fn sharpness(cone: &Cone, eye_from_local: &Affine3, hither: f64) -> f64 {
    let frame = cone.frame();
    let eye = eye_from_local.inverse().transform_point3(Vec3::ZERO) - cone.base;
    let (x, y, z) = (eye.dot(frame.across), eye.dot(frame.beside), eye.dot(frame.along));

    // Throw the base onto the plane of the apex; an eye between the planes looks through one end only.
    let scale = (frame.height - z) / -z;
    if !(scale > 0.0 && scale.is_finite()) {
        return 1.0;
    }
    let base = Circle { x: x * (1.0 - scale), y: y * (1.0 - scale), radius: cone.base_radius * scale };
    let apex = Circle { x: 0.0, y: 0.0, radius: cone.apex_radius };
    let sines = base.crossings(&apex).into_iter().flatten().map(|corner| {
        let tangents = [base, apex].map(|circle| in_eye_space(circle.tangent(corner), &frame, eye_from_local));
        let point = cone.apex + frame.across * corner.0 + frame.beside * corner.1;
        let point = eye_from_local.transform_point3(point);
        // Each arc of the hole runs from the corner into the other circle.
        let inwards = [apex.inward(corner, base.tangent(corner)), base.inward(corner, apex.tangent(corner))];
        if point.z < hither { 1.0 } else { half_angle_sine(point, tangents, inwards) }
    });
    sines.fold(1.0, f64::min).max(SHARPEST)
}

/// A circle in the plane of the apex, about the axis' coordinates.
#[derive(Clone, Copy, Debug)]
struct Circle {
    x: f64,
    y: f64,
    radius: f64,
}

impl Circle {
    /// The points where two circles cross.
    fn crossings(&self, other: &Circle) -> [Option<(f64, f64)>; 2] {
        let (dx, dy) = (other.x - self.x, other.y - self.y);
        let squared = dx * dx + dy * dy;
        let along = (squared + self.radius * self.radius - other.radius * other.radius) / (2.0 * squared);
        let across_squared = self.radius * self.radius / squared - along * along;
        if !(across_squared > 0.0 && across_squared.is_finite()) {
            return [None, None];
        }
        let across = across_squared.sqrt();
        [across, -across].map(|side| Some((self.x + along * dx - side * dy, self.y + along * dy + side * dx)))
    }

    fn tangent(&self, (x, y): (f64, f64)) -> (f64, f64) {
        (self.y - y, x - self.x)
    }

    /// 1 where `direction` leads into the circle from a point on it, else -1.
    fn inward(&self, (x, y): (f64, f64), direction: (f64, f64)) -> f64 {
        let outward = (x - self.x) * direction.0 + (y - self.y) * direction.1;
        if outward < 0.0 { 1.0 } else { -1.0 }
    }
}

fn in_eye_space((x, y): (f64, f64), frame: &Frame, eye_from_local: &Affine3) -> Vec3 {
    eye_from_local.transform_vector3(frame.across * x + frame.beside * y)
}

/// The sine of half the angle between two directions at `point`, as the picture shows it.
fn half_angle_sine(point: Vec3, tangents: [Vec3; 2], signs: [f64; 2]) -> f64 {
    let seen = |direction: Vec3| {
        (direction.x * point.z - point.x * direction.z, direction.y * point.z - point.y * direction.z)
    };
    let [(ax, ay), (bx, by)] = tangents.map(seen);
    let lengths = ((ax * ax + ay * ay) * (bx * bx + by * by)).sqrt();
    let cosine = (ax * bx + ay * by) * signs[0] * signs[1] / lengths;
    // Seen along an edge, the plane of the ends shows no hole.
    if cosine.is_finite() { ((1.0 - cosine) / 2.0).max(0.0).sqrt() } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pipe(apex_radius: f64) -> Cone {
        Cone { base: Vec3::new(0.0, 0.0, 4.0), base_radius: 1.0, apex: Vec3::new(0.0, 0.0, 8.0), apex_radius }
    }

    /// The eye is moved by `aside` from the axis; it looks along it.
    fn sharpness_from(aside: f64, cone: &Cone) -> f64 {
        sharpness(cone, &Affine3::from_translation(Vec3::new(-aside, 0.0, 0.0)), 0.1)
    }

    #[test]
    fn ends_that_do_not_cross_have_no_corner() {
        assert_eq!(sharpness_from(0.0, &pipe(1.0)), 1.0);
        // Between the ends, and beside them.
        assert_eq!(sharpness(&pipe(1.0), &Affine3::from_translation(Vec3::new(0.0, 0.0, -6.0)), 0.1), 1.0);
        assert_eq!(sharpness_from(9.0, &pipe(1.0)), 1.0);
    }

    #[test]
    fn equal_circles_cross_as_their_distance_says() {
        // In the plane of the apex both circles have radius 2, and their centers are `aside` apart: half the angle of the hole is
        // 90 degrees minus asin(aside / 4). The plane is square to the view, so the picture shows it as it is.
        for aside in [0.5, 1.0, 2.0, 3.0] {
            let half: f64 = 1.0 - (aside / 4.0) * (aside / 4.0);
            let found = sharpness_from(aside, &pipe(2.0));
            assert!((found - half.sqrt()).abs() < 1e-12, "{aside}: {found}");
        }
    }

    #[test]
    fn slivers_are_not_followed_for_ever() {
        assert_eq!(sharpness_from(3.9999, &pipe(2.0)), SHARPEST);
    }
}
