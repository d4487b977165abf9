//! Balls around things, for asking cheaply whether they can be in view at all.
//!
//! Why balls and not boxes: a turned ball is the same ball, so the test against the planes of the view needs one
//! distance each. They are never too small; they may be a little too large.

use super::cone::Cone;
use super::cone_about_z;
use super::segments::largest_stretch;
use super::teapot::{Nets, parts};
use crate::math::{Affine3, Vec3};
use crate::scene::{CurveNet, Mesh, PatchNet, Shape};

/// All points within `radius` of `center`. An infinite radius holds everything.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    /// Same space as what it bounds.
    pub center: Vec3,
    /// Not negative.
    pub radius: f64,
}

impl Ball {
    /// A ball that holds the image of this one.
    #[must_use]
    pub fn transformed(&self, target_from_source: &Affine3) -> Ball {
        let center = target_from_source.transform_point3(self.center);
        Ball { center, radius: self.radius * largest_stretch(target_from_source) }.rounded_outward()
    }

    /// Covers the rounding of the sums that made it; what is not a number holds everything.
    fn rounded_outward(self) -> Ball {
        let slack = 1e-15 * self.center.abs().max_element();
        let radius = self.radius * (1.0 + 1e-14) + slack;
        if radius.is_finite() && self.center.is_finite() {
            Ball { radius, ..self }
        } else {
            Ball { center: Vec3::ZERO, radius: f64::INFINITY }
        }
    }
}

/// The ball around a shape.
///
/// The smallest one around spheres, ellipsoids, both end circles of a cone, blocks and tori. Around prisms, patches, curves and the
/// teapot one about the middle of their bounding box; what is bounded is the control points, and a Bezier shape lies within them.
#[must_use]
pub fn bounding_ball(shape: &Shape) -> Ball {
    let about_origin = |radius: f64| Ball { center: Vec3::ZERO, radius };
    match *shape {
        Shape::Sphere { center, radius } => Ball { center, radius },
        Shape::Ellipsoid { radii } => about_origin(radii.max_element()),
        Shape::Cone { base, base_radius, apex, apex_radius } => {
            ball_of_cone(&Cone { base, base_radius, apex, apex_radius })
        }
        Shape::CappedCone { bottom_radius, top_radius, length } => {
            ball_of_cone(&cone_about_z(bottom_radius, top_radius, length))
        }
        Shape::Block { size } => about_origin(size.length() / 2.0),
        Shape::Prism { ref outline, height } => {
            let levels = [-height / 2.0, height / 2.0];
            let corners = outline.iter().flat_map(|&[x, y]| levels.map(|z| Ring::point(Vec3::new(x, y, z))));
            ball_of_rings(&corners.collect::<Vec<_>>())
        }
        Shape::Torus { ring_radius, tube_radius } => about_origin(ring_radius + tube_radius),
        Shape::Patches(ref net) => ball_of_rings(&rings_of_patches(net).collect::<Vec<_>>()),
        Shape::Curves(ref net) => ball_of_rings(&rings_of_curves(net).collect::<Vec<_>>()),
        Shape::Teapot(part) => {
            let of_part = |nets: &'static Nets| rings_of_curves(&nets.curves).chain(rings_of_patches(&nets.patches));
            ball_of_rings(&parts(part).iter().flat_map(of_part).collect::<Vec<_>>())
        }
    }
    .rounded_outward()
}

fn ball_of_cone(cone: &Cone) -> Ball {
    // On the axis, as far from the one circle as from the other, unless one of them holds the other anyway.
    let axis = cone.apex - cone.base;
    let height_squared = axis.length_squared();
    let difference = cone.apex_radius * cone.apex_radius - cone.base_radius * cone.base_radius;
    let part = if height_squared > 0.0 { 0.5 + 0.5 * difference / height_squared } else { 0.0 };
    let center = cone.base + axis * part.clamp(0.0, 1.0);
    let reach = |end: Vec3, radius: f64| ((end - center).length_squared() + radius * radius).sqrt();
    Ball { center, radius: reach(cone.base, cone.base_radius).max(reach(cone.apex, cone.apex_radius)) }
}

/// A point, or the circle that it runs on around the z axis.
#[derive(Clone, Copy)]
struct Ring {
    center: Vec3,
    radius: f64,
}

impl Ring {
    fn point(center: Vec3) -> Ring {
        Ring { center, radius: 0.0 }
    }

    fn turned(point: Vec3) -> Ring {
        Ring { center: Vec3::Z * point.z, radius: point.truncate().length() }
    }
}

fn rings_of_patches(net: &PatchNet) -> impl Iterator<Item = Ring> + '_ {
    net.patches.iter().flatten().map(|&index| Ring::point(net.vertices[index as usize]))
}

fn rings_of_curves(net: &CurveNet) -> impl Iterator<Item = Ring> + '_ {
    net.curves.iter().flatten().map(|&index| Ring::turned(net.vertices[index as usize]))
}

/// A ball about the middle of the rings' bounding box, as large as it must be.
fn ball_of_rings(rings: &[Ring]) -> Ball {
    let Some(first) = rings.first() else { return Ball { center: Vec3::ZERO, radius: 0.0 } };
    let sides = |ring: &Ring| Vec3::new(ring.radius, ring.radius, 0.0);
    let (low, high) = rings.iter().fold((first.center, first.center), |(low, high), ring| {
        (low.min(ring.center - sides(ring)), high.max(ring.center + sides(ring)))
    });
    let center = low + (high - low) * 0.5;
    let reach = |ring: &Ring| {
        let way = ring.center - center;
        (way.truncate().length() + ring.radius).hypot(way.z)
    };
    // Also not a number where a ring is none; such a ball becomes infinite.
    let radius = rings.iter().map(reach).fold(0.0, |most: f64, reach| if reach <= most { most } else { reach });
    Ball { center, radius }
}

/// A ball around all vertices of a mesh, about the middle of their bounding box; `None` where there are none.
#[must_use]
pub fn bounding_ball_of_mesh(mesh: &Mesh) -> Option<Ball> {
    let first = *mesh.vertices.first()?;
    let (low, high) = mesh.vertices.iter().fold((first, first), |(low, high), &v| (low.min(v), high.max(v)));
    let center = low + (high - low) * 0.5;
    let farthest = mesh.vertices.iter().map(|&vertex| (vertex - center).length_squared()).fold(0.0, f64::max);
    Some(Ball { center, radius: farthest.sqrt() }.rounded_outward())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Detail, tessellate};

    #[test]
    fn balls_hold_their_shapes_and_touch_them() {
        let (base, apex) = (Vec3::new(1.0, 2.0, 3.0), Vec3::new(-4.0, 0.5, 7.0));
        for (base_radius, apex_radius) in [(1.0, 0.0), (2.0, 2.0), (0.5, 30.0)] {
            let shape = Shape::Cone { base, base_radius, apex, apex_radius };
            let mut mesh = Mesh::default();
            tessellate(&shape, false, Detail::Segments(64), 0, &mut mesh);
            for (map, tight) in [
                (Affine3::IDENTITY, 1e-13),
                (Affine3::from_rotation_x(0.3) * Affine3::from_scale(Vec3::new(1.0, -3.0, 0.1)), f64::INFINITY),
            ] {
                let ball = bounding_ball(&shape).transformed(&map);
                let reach = mesh.vertices.iter().map(|&v| (map.transform_point3(v) - ball.center).length());
                let reach = reach.fold(0.0, f64::max);
                assert!(reach <= ball.radius && reach * (1.0 + tight) >= ball.radius, "{reach} {ball:?}");
            }
            let ball = bounding_ball_of_mesh(&mesh).expect("has vertices");
            assert!(mesh.vertices.iter().all(|&v| (v - ball.center).length() <= ball.radius));
        }
        assert_eq!(bounding_ball_of_mesh(&Mesh::default()), None);
    }

    #[test]
    fn balls_of_sipps_shapes_hold_them_and_are_close() {
        use crate::model::test_bodies::{TORUS, angle_iron, capped, pillow, vase};
        use crate::scene::TeapotPart::{Body, Handle, Lid, Spout, Whole};
        let ellipsoid = Shape::Ellipsoid { radii: Vec3::new(1.0, 2.0, 0.5) };
        let block = Shape::Block { size: Vec3::new(1.0, 2.0, 3.0) };
        // How much larger than what it holds: nothing, or what control points stand off (and the corner of a bounding box).
        let mut shapes = vec![(ellipsoid, 1e-13), (block, 1e-13), (TORUS, 1e-13), (angle_iron(), 1e-13)];
        shapes.extend([(capped(2.0, 0.5), 1e-13), (capped(1.0, 0.0), 1e-13), (pillow(), 0.1), (vase(0.0), 0.2)]);
        shapes.extend([Body, Lid, Handle, Spout, Whole].map(|part| (Shape::Teapot(part), 0.2)));
        for (shape, slack) in shapes {
            let mut mesh = Mesh::default();
            tessellate(&shape, false, Detail::Segments(24), 0, &mut mesh);
            let ball = bounding_ball(&shape);
            let reach = mesh.vertices.iter().map(|&v| (v - ball.center).length()).fold(0.0, f64::max);
            assert!(reach <= ball.radius && ball.radius <= reach * (1.0 + slack), "{shape:?}: {reach} {ball:?}");
        }
        let nothing = Shape::Patches(std::sync::Arc::default());
        assert!(bounding_ball(&nothing).radius < 1e-14);
    }

    #[test]
    fn what_overflows_holds_everything() {
        let apex = Vec3::splat(1e300);
        let shape = Shape::Cone { base: -apex, base_radius: 1e300, apex, apex_radius: 1.0 };
        assert_eq!(bounding_ball(&shape).radius, f64::INFINITY);
    }
}
