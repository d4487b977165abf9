//! Tessellate: spheres, cones, tori and discs as triangles, the way the original programs cut them.
//!
//! scene file -> sphere, cone, ... -> TESSELLATE -> triangles with vertex normals -> `nff`
//!
//! Why a second tessellation beside the one in `model`: this one must reproduce published files triangle by
//! triangle; that one serves the picture (few triangles, error in pixels).
//!
//! Scene units, angles in radians; triangles counterclockwise from outside. Source: the SPD 3.14 package (CC0), by
//! E. Haines, "A Proposal for Standard Graphics Environments", IEEE CG&A 7(11), 1987.
//! Cost: with resolution n, a sphere has 12 n^2 triangles, a cone 8 n, a torus 32 n^2, a disc 4 n.

use super::rounded::{acos, sin_cos};
use super::turn::rotation;
use crate::math::{Mat3, PI, Vec3};
use std::io;

/// A triangle with a normal at each vertex.
#[derive(Clone, Copy)]
pub(super) struct Patch {
    pub points: [Vec3; 3],
    pub normals: [Vec3; 3],
}

/// The side of a cone, a cone stub or a cylinder; it has no caps.
pub(super) struct Cone {
    pub base: Vec3,
    pub base_radius: f64,
    pub apex: Vec3,
    pub apex_radius: f64,
}

/// A ring of circular section.
pub(super) struct Torus {
    pub center: Vec3,
    /// Through the hole; any length but zero.
    pub axis: Vec3,
    /// From the center to the middle of the tube.
    pub major: f64,
    /// Of the tube.
    pub minor: f64,
}

/// A sixth of the unit sphere: (n + 1) x (n + 1) unit vectors over one face of the surrounding cube.
pub(super) struct SphereGrid {
    directions: Vec<Vec3>,
    n: usize,
}

impl SphereGrid {
    /// The face around +z, cut by planes at equal angles.
    pub fn new(n: u32) -> Self {
        let angle = |i: u32| PI / 4.0 * (2.0 * f64::from(i) / f64::from(n) - 1.0);
        let circle: Vec<_> = (0..=n).map(|i| sin_cos(angle(i))).collect();
        let mut directions = Vec::with_capacity(circle.len() * circle.len());
        for &(sin_u, cos_u) in &circle {
            for &(sin_v, cos_v) in &circle {
                // Each plane is given by its normal; two planes meet along the cross product.
                let along = Vec3::new(cos_u, 0.0, 0.0 - sin_u).cross(Vec3::new(0.0, cos_v, sin_v));
                directions.push(along / along.length());
            }
        }
        SphereGrid { directions, n: n as usize }
    }

    /// Hands the 12 n^2 triangles of a sphere to `emit`, face by face.
    pub fn sphere(&self, center: Vec3, radius: f64, mut emit: impl FnMut(Patch) -> io::Result<()>) -> io::Result<()> {
        for face in 1..=6 {
            for u in 0..self.n {
                for v in 0..self.n {
                    let [q0, q1, q2, q3] = [(u, v), (u, v + 1), (u + 1, v + 1), (u + 1, v)]
                        .map(|(u, v)| turned(self.directions[u * (self.n + 1) + v], face));
                    for normals in [[q0, q1, q2], [q2, q3, q0]] {
                        emit(Patch { points: normals.map(|q| center + q * radius), normals })?;
                    }
                }
            }
        }
        Ok(())
    }
}

/// Brings a direction of the first grid to cube face 1 to 6: each face is a quarter turn away from the one before.
fn turned(direction: Vec3, face: u32) -> Vec3 {
    (0..face).fold(direction, |Vec3 { x, y, z }, quarter| match quarter % 3 {
        0 => Vec3::new(-z, y, x),
        1 => Vec3::new(-y, x, z),
        _ => Vec3::new(x, -z, y),
    })
}

/// The end of an angle that starts at 0 and grows by `step`, added up one step at a time.
///
/// Adding up is less exact than multiplying; the published files were made this way.
fn accumulated(step: f64) -> impl Iterator<Item = f64> {
    std::iter::successors(Some(0.0), move |angle| Some(angle + step))
}

/// Hands the 8 n triangles of a cone's side to `emit`.
pub(super) fn cone(cone: &Cone, n: u32, mut emit: impl FnMut(Patch) -> io::Result<()>) -> io::Result<()> {
    // A frame: the axis, and a radius to start from.
    let span = cone.apex - cone.base;
    let height = span.length();
    let axis = span / height;
    let mut across = span.cross(Vec3::Z);
    if across.length() < 1e-6 {
        across = span.cross(Vec3::X);
    }
    let start = across / across.length();
    let mut start_normal = start;
    if cone.base_radius != cone.apex_radius {
        let slanted = start * height + axis * (cone.base_radius - cone.apex_radius);
        start_normal = slanted / slanted.length();
    }

    // Sweep it around; each step closes a quadrilateral, cut into two triangles.
    let rib = |turn: Mat3| {
        let apex = cone.apex + turn * (start * cone.apex_radius);
        let base = cone.base + turn * (start * cone.base_radius);
        (apex, base, turn * start_normal)
    };
    let mut last = rib(Mat3::IDENTITY);
    for angle in accumulated(2.0 * PI / (4.0 * f64::from(n))).skip(1).take(4 * n as usize) {
        let next = rib(rotation(axis, angle));
        let ((a0, b0, m0), (a1, b1, m1)) = (last, next);
        emit(Patch { points: [a1, a0, b0], normals: [m1, m0, m0] })?;
        emit(Patch { points: [b1, a1, b0], normals: [m1, m1, m0] })?;
        last = next;
    }
    Ok(())
}

/// Hands the 32 n^2 triangles of a torus to `emit`.
pub(super) fn torus(torus: &Torus, n: u32, mut emit: impl FnMut(Patch) -> io::Result<()>) -> io::Result<()> {
    let steps = 4 * n as usize;
    let circle: Vec<_> = circle(n).collect();
    let world_from_ring = from_z_axis(torus.axis);

    // One ring of vertices for each angle around the tube.
    let ring = |(sin_t, cos_t): (f64, f64)| -> Vec<(Vec3, Vec3)> {
        let outward = torus.major + torus.minor * sin_t;
        let vertices = circle.iter().map(|&(sin_f, cos_f)| {
            let point = Vec3::new(outward * cos_f, outward * sin_f, torus.minor * cos_t);
            let normal = Vec3::new(sin_t * cos_f, sin_t * sin_f, cos_t);
            (torus.center + world_from_ring * point, world_from_ring * normal)
        });
        vertices.collect()
    };
    let mut last = ring(circle[0]);
    for &angle in &circle[1..=steps] {
        let next = ring(angle);
        for j in 0..steps {
            for corners in [[next[j + 1], last[j + 1], last[j]], [next[j], next[j + 1], last[j]]] {
                emit(Patch { points: corners.map(|corner| corner.0), normals: corners.map(|corner| corner.1) })?;
            }
        }
        last = next;
    }
    Ok(())
}

/// Hands the 4 n sectors of a disc to `emit`, as outlines: the inner edge, of radius 0, is the center twice.
pub(super) fn disc(
    (center, axis, radius): (Vec3, Vec3, f64),
    n: u32,
    mut emit: impl FnMut(&[Vec3]) -> io::Result<()>,
) -> io::Result<()> {
    let world_from_disc = from_z_axis(axis);
    let rim: Vec<_> = circle(n)
        .map(|(sine, cosine)| center + world_from_disc * Vec3::new(radius * cosine, radius * sine, 0.0))
        .collect();
    rim.windows(2).try_for_each(|edge| emit(&[edge[0], edge[1], center, center]))
}

/// Sine and cosine of 4 n + 1 angles from 0 to a full turn.
fn circle(n: u32) -> impl Iterator<Item = (f64, f64)> {
    accumulated(2.0 * PI / (4.0 * f64::from(n))).take(4 * n as usize + 1).map(sin_cos)
}

/// The turn that takes the z axis to `axis`.
fn from_z_axis(axis: Vec3) -> Mat3 {
    let axis = axis / axis.length();
    let hinge = if axis.z.abs() == 1.0 {
        Vec3::X
    } else {
        let across = Vec3::new(-axis.y, axis.x, 0.0);
        across / across.length()
    };
    rotation(hinge, acos(axis.z))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Volume enclosed by outward triangles, by the divergence theorem.
    fn volume(patches: &[Patch]) -> f64 {
        patches.iter().map(|patch| patch.points[0].dot(patch.points[1].cross(patch.points[2])) / 6.0).sum()
    }

    fn collect(shape: impl FnOnce(&mut dyn FnMut(Patch) -> io::Result<()>) -> io::Result<()>) -> Vec<Patch> {
        let mut patches = Vec::new();
        shape(&mut |patch| {
            patches.push(patch);
            Ok(())
        })
        .expect("nothing to fail");
        patches
    }

    #[test]
    fn a_fine_sphere_encloses_the_volume_of_a_ball() {
        let patches = collect(|emit| SphereGrid::new(20).sphere(Vec3::new(1.0, 2.0, 3.0), 2.0, emit));
        assert_eq!(patches.len(), 12 * 20 * 20);
        let ball = 4.0 / 3.0 * PI * 8.0;
        assert!(volume(&patches) < ball && volume(&patches) > 0.995 * ball, "{}", volume(&patches));
    }

    #[test]
    fn a_fine_torus_encloses_the_volume_of_a_ring() {
        let shape = Torus { center: Vec3::ONE, axis: Vec3::new(1.0, -2.0, 0.5), major: 2.0, minor: 0.5 };
        let patches = collect(|emit| torus(&shape, 20, emit));
        assert_eq!(patches.len(), 32 * 20 * 20);
        let ring = PI * 0.25 * 2.0 * PI * 2.0;
        assert!(volume(&patches) < ring && volume(&patches) > 0.99 * ring, "{}", volume(&patches));
    }

    #[test]
    fn cone_normals_are_unit_and_agree_with_the_winding() {
        for (apex, apex_radius) in [(Vec3::new(0.0, 0.0, 3.0), 0.5), (Vec3::new(1.0, 2.0, 0.5), 1.0)] {
            let shape = Cone { base: Vec3::ZERO, base_radius: 1.0, apex, apex_radius };
            let patches = collect(|emit| cone(&shape, 5, emit));
            assert_eq!(patches.len(), 40);
            for patch in patches {
                let [a, b, c] = patch.points;
                let face = (b - a).cross(c - a);
                for normal in patch.normals {
                    assert!((normal.length() - 1.0).abs() < 1e-12);
                    assert!(normal.dot(face) > 0.0);
                }
            }
        }
    }
}
