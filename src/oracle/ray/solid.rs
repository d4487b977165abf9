//! Solid: where a straight line crosses the surface of a shape, by the shape's own equation.
//!
//! Quadratic equations are solved from the point of the line nearest to the shape: a sphere seen from a thousand radii
//! away would otherwise lose six digits in b^2 - 4 a c, and its outline with them.
//!
//! Space: the shape's local space. Normals point outward and are not unit.
//! Source: A. S. Glassner (ed.), "An Introduction to Ray Tracing", Academic Press 1989, chapter 2.

use crate::math::{Vec3, edges};
use crate::scene::Shape;

/// A straight line: origin + t direction.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ray {
    pub origin: Vec3,
    pub direction: Vec3,
}

/// A place where the line goes through the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Crossing {
    pub t: f64,
    /// Outward, not unit.
    pub normal: Vec3,
}

impl Ray {
    fn at(&self, t: f64) -> Vec3 {
        self.origin + self.direction * t
    }

    /// The same line, from its point nearest to `center`; and the t of that point.
    fn starting_nearest(&self, center: Vec3) -> (Ray, f64) {
        let t = (center - self.origin).dot(self.direction) / self.direction.length_squared();
        (Ray { origin: self.at(t), ..*self }, t)
    }
}

/// The name of a shape that has no equation here.
pub(super) fn unknown(shape: &Shape) -> Option<&'static str> {
    match shape {
        Shape::Torus { .. } => Some("torus"),
        Shape::Patches(_) => Some("Bezier patch"),
        Shape::Curves(_) => Some("Bezier curve of rotation"),
        Shape::Teapot(_) => Some("teapot"),
        _ => None,
    }
}

/// A box around a shape: two opposite corners.
pub(super) fn bounds(shape: &Shape) -> (Vec3, Vec3) {
    let around = |center: Vec3, half: Vec3| (center - half, center + half);
    match *shape {
        Shape::Sphere { center, radius } => around(center, Vec3::splat(radius)),
        Shape::Ellipsoid { radii } => around(Vec3::ZERO, radii),
        Shape::Cone { base, base_radius, apex, apex_radius } => {
            let radius = Vec3::splat(base_radius.max(apex_radius));
            (base.min(apex) - radius, base.max(apex) + radius)
        }
        Shape::CappedCone { bottom_radius, top_radius, length } => {
            let radius = bottom_radius.max(top_radius);
            around(Vec3::ZERO, Vec3::new(radius, radius, length / 2.0))
        }
        Shape::Block { size } => around(Vec3::ZERO, size / 2.0),
        Shape::Prism { ref outline, height } => {
            let reach = outline.iter().flatten().fold(0.0, |reach: f64, at| reach.max(at.abs()));
            around(Vec3::ZERO, Vec3::new(reach, reach, height / 2.0))
        }
        Shape::Torus { ring_radius, tube_radius } => {
            let reach = ring_radius + tube_radius;
            around(Vec3::ZERO, Vec3::new(reach, reach, tube_radius))
        }
        Shape::Patches(_) | Shape::Curves(_) | Shape::Teapot(_) => around(Vec3::ZERO, Vec3::ZERO),
    }
}

/// Calls `found` at every crossing of the line with the surface of `shape`, in no order.
pub(super) fn cross(shape: &Shape, ray: &Ray, found: &mut dyn FnMut(Crossing)) {
    match *shape {
        Shape::Sphere { center, radius } => sphere(center, radius, ray, found),
        Shape::Ellipsoid { radii } => {
            // A unit sphere once lengths are measured in half axes.
            let scaled = Ray { origin: ray.origin / radii, direction: ray.direction / radii };
            sphere(Vec3::ZERO, 1.0, &scaled, &mut |crossing| {
                found(Crossing { normal: crossing.normal / radii, ..crossing });
            });
        }
        Shape::Cone { base, base_radius, apex, apex_radius } if base == apex => {
            let radii = (base_radius.min(apex_radius), base_radius.max(apex_radius));
            ring(base, radii, Vec3::Z, ray, found);
        }
        Shape::Cone { base, base_radius, apex, apex_radius } => {
            side((base, base_radius), (apex, apex_radius), ray, found);
        }
        Shape::CappedCone { bottom_radius, top_radius, length } => {
            let (bottom, top) = (Vec3::NEG_Z * (length / 2.0), Vec3::Z * (length / 2.0));
            side((bottom, bottom_radius), (top, top_radius), ray, found);
            ring(bottom, (0.0, bottom_radius), Vec3::NEG_Z, ray, found);
            ring(top, (0.0, top_radius), Vec3::Z, ray, found);
        }
        Shape::Block { size } => block(size / 2.0, ray, found),
        Shape::Prism { ref outline, height } => prism(outline, height / 2.0, ray, found),
        Shape::Torus { .. } | Shape::Patches(_) | Shape::Curves(_) | Shape::Teapot(_) => (),
    }
}

/// The real solutions of a t^2 + 2 b t + c = 0, without subtracting nearly equal numbers.
fn roots(a: f64, b: f64, c: f64) -> impl Iterator<Item = f64> {
    let discriminant = b * b - a * c;
    let far = -(b + discriminant.max(0.0).sqrt().copysign(b));
    let pair = if discriminant < 0.0 { [f64::NAN; 2] } else { [far / a, c / far] };
    // A double root, or a linear equation, leaves one or none that is finite.
    pair.into_iter().filter(|t| t.is_finite())
}

fn sphere(center: Vec3, radius: f64, ray: &Ray, found: &mut dyn FnMut(Crossing)) {
    let (ray, start) = ray.starting_nearest(center);
    let nearest = ray.origin - center;
    // From the nearest point both crossings are equally far.
    let half = ((radius * radius - nearest.length_squared()) / ray.direction.length_squared()).sqrt();
    if half.is_nan() {
        return;
    }
    for t in [-half, half] {
        found(Crossing { t: start + t, normal: ray.at(t) - center });
    }
}

/// The side of a cone between two circles, open at both ends.
fn side(
    (base, base_radius): (Vec3, f64),
    (apex, apex_radius): (Vec3, f64),
    ray: &Ray,
    found: &mut dyn FnMut(Crossing),
) {
    let (ray, start) = ray.starting_nearest((base + apex) / 2.0);
    let height = (apex - base).length();
    let along = (apex - base) / height;
    let growth = (apex_radius - base_radius) / height;
    // Split into the part along the axis and the part across: |across|^2 = (radius at that height)^2.
    let split = |v: Vec3| (v.dot(along), v - along * v.dot(along));
    let ((from_height, from), (up, direction)) = (split(ray.origin - base), split(ray.direction));
    let radius = base_radius + growth * from_height;
    let a = direction.length_squared() - (growth * up) * (growth * up);
    let b = from.dot(direction) - radius * growth * up;
    let c = (from.length() - radius) * (from.length() + radius);
    for t in roots(a, b, c) {
        let at = from_height + up * t;
        if (0.0..=height).contains(&at) {
            let outward = from + direction * t;
            found(Crossing { t: start + t, normal: outward - along * (growth * (base_radius + growth * at)) });
        }
    }
}

/// A flat ring between two radii; a disc where the inner one is 0.
fn ring(center: Vec3, (inner, outer): (f64, f64), normal: Vec3, ray: &Ray, found: &mut dyn FnMut(Crossing)) {
    let t = (center - ray.origin).dot(normal) / ray.direction.dot(normal);
    let distance = (ray.at(t) - center).length();
    if outer > 0.0 && (inner..=outer).contains(&distance) {
        found(Crossing { t, normal });
    }
}

fn block(half: Vec3, ray: &Ray, found: &mut dyn FnMut(Crossing)) {
    for (axis, normal) in Vec3::AXES.into_iter().enumerate() {
        for sign in [-1.0, 1.0] {
            let t = (sign * half[axis] - ray.origin[axis]) / ray.direction[axis];
            let at = ray.at(t).abs();
            if (0..3).all(|other| other == axis || at[other] <= half[other]) {
                found(Crossing { t, normal: normal * sign });
            }
        }
    }
}

fn prism(outline: &[[f64; 2]], half: f64, ray: &Ray, found: &mut dyn FnMut(Crossing)) {
    for sign in [-1.0, 1.0] {
        let t = (sign * half - ray.origin.z) / ray.direction.z;
        let at = ray.at(t);
        if within(outline, at.x, at.y) {
            found(Crossing { t, normal: Vec3::Z * sign });
        }
    }
    for (&[ax, ay], &[bx, by]) in edges(outline) {
        // Counterclockwise: outward is to the right of the walk.
        let normal = Vec3::new(by - ay, ax - bx, 0.0);
        let t = (Vec3::new(ax, ay, 0.0) - ray.origin).dot(normal) / ray.direction.dot(normal);
        let at = ray.at(t);
        let share = (at.x - ax) * (bx - ax) + (at.y - ay) * (by - ay);
        if at.z.abs() <= half && (0.0..=normal.length_squared()).contains(&share) {
            found(Crossing { t, normal });
        }
    }
}

/// Even-odd, by a line to the right.
fn within(outline: &[[f64; 2]], x: f64, y: f64) -> bool {
    let crossed = edges(outline)
        .filter(|&(&[ax, ay], &[bx, by])| (ay <= y) != (by <= y) && ((y - ay) / (by - ay)).mul_add(bx - ax, ax) > x);
    crossed.count() % 2 == 1
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Arc;

    fn crossings(shape: &Shape, origin: [f64; 3], direction: [f64; 3]) -> Vec<(f64, Vec3)> {
        let mut all = Vec::new();
        let ray = Ray { origin: origin.into(), direction: direction.into() };
        cross(shape, &ray, &mut |crossing| all.push((crossing.t, crossing.normal.normalize())));
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        all
    }

    fn expect(shape: &Shape, origin: [f64; 3], direction: [f64; 3], expected: &[(f64, [f64; 3])]) {
        let found = crossings(shape, origin, direction);
        let close = |a: &(f64, Vec3), b: &(f64, [f64; 3])| {
            (a.0 - b.0).abs() < 1e-12 && (a.1 - Vec3::from(b.1)).length() < 1e-12
        };
        let equal = found.len() == expected.len() && found.iter().zip(expected).all(|(a, b)| close(a, b));
        assert!(equal, "{shape:?}: {found:?}");
    }

    #[test]
    fn hand_computed_crossings() {
        let (left, right) = ([-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]);
        let sphere = Shape::Sphere { center: Vec3::new(5.0, 0.0, 0.0), radius: 2.0 };
        expect(&sphere, [0.0; 3], [2.0, 0.0, 0.0], &[(1.5, left), (3.5, right)]);
        expect(&sphere, [0.0, 2.5, 0.0], [1.0, 0.0, 0.0], &[]);
        let ellipsoid = Shape::Ellipsoid { radii: Vec3::new(3.0, 1.0, 1.0) };
        expect(&ellipsoid, [-5.0, 0.0, 0.0], [1.0, 0.0, 0.0], &[(2.0, left), (8.0, right)]);
        let block = Shape::Block { size: Vec3::new(2.0, 4.0, 6.0) };
        expect(&block, [-5.0, 1.9, 2.9], [1.0, 0.0, 0.0], &[(4.0, left), (6.0, right)]);
        expect(&block, [-5.0, 2.1, 0.0], [1.0, 0.0, 0.0], &[]);
        let disc = Shape::Cone { base: Vec3::Z, base_radius: 1.0, apex: Vec3::Z, apex_radius: 3.0 };
        expect(&disc, [2.0, 0.0, 5.0], [0.0, 0.0, -1.0], &[(4.0, [0.0, 0.0, 1.0])]);
        expect(&disc, [0.5, 0.0, 5.0], [0.0, 0.0, -1.0], &[]);
    }

    #[test]
    fn cones_and_prisms() {
        // Radius 2 at z = 0, a point at z = 2: 45 degrees. At height 1 the radius is 1.
        let (r, cone) =
            (0.5_f64.sqrt(), Shape::Cone { base: Vec3::ZERO, base_radius: 2.0, apex: Vec3::Z * 2.0, apex_radius: 0.0 });
        expect(&cone, [-5.0, 0.0, 1.0], [1.0, 0.0, 0.0], &[(4.0, [-r, 0.0, r]), (6.0, [r, 0.0, r])]);
        expect(&cone, [-5.0, 0.0, 2.5], [1.0, 0.0, 0.0], &[]);
        // Along the axis of an open cylinder nothing is met; of a capped one both ends.
        let pipe = Shape::Cone { base: Vec3::ZERO, base_radius: 1.0, apex: Vec3::Z * 2.0, apex_radius: 1.0 };
        expect(&pipe, [0.0, 0.0, -5.0], [0.0, 0.0, 1.0], &[]);
        let capped = Shape::CappedCone { bottom_radius: 1.0, top_radius: 1.0, length: 2.0 };
        let ends = [(4.0, [0.0, 0.0, -1.0]), (6.0, [0.0, 0.0, 1.0])];
        expect(&capped, [0.5, 0.0, -5.0], [0.0, 0.0, 1.0], &ends);
        // An L, from the side through its notch: four walls.
        let outline = [[0.0, 0.0], [3.0, 0.0], [3.0, 2.0], [2.0, 2.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]];
        let prism = Shape::Prism { outline: Arc::from(outline), height: 2.0 };
        let (left, right) = ([-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]);
        expect(&prism, [-1.0, 1.5, 0.5], right, &[(1.0, left), (2.0, right), (3.0, left), (4.0, right)]);
        expect(&prism, [0.5, 1.5, 5.0], [0.0, 0.0, -1.0], &[(4.0, [0.0, 0.0, 1.0]), (6.0, [0.0, 0.0, -1.0])]);
        expect(&prism, [1.5, 1.5, 5.0], [0.0, 0.0, -1.0], &[]);
    }

    #[test]
    fn a_far_sphere_keeps_its_outline() {
        let sphere = Shape::Sphere { center: Vec3::new(0.0, 0.0, 1e6), radius: 1.0 };
        let is_met = |offset: f64| !crossings(&sphere, [offset, 0.0, 0.0], [0.0, 0.0, 1.0]).is_empty();
        assert!(is_met(1.0 - 1e-12) && !is_met(1.0 + 1e-12));
    }
}
