//! Segments of tori, patches, curves and the teapot: from bounds of how far a net of polygons is from its surface.
//!
//! **Pixels.** Let every point of the polygons be within d of a point of the surface and the other way round, and both lie
//! in a convex body at depths of at least z and distances of at most L from the eye. Then images differ by at most `p d`
//! pixels, `p = f / (z cos w)`, `cos w = z / L` (at least the corner's cosine), because a displacement moves its image
//! by at most that; so does a silhouette, whatever its shape. As ever, z counts as at least hither. Displacements are
//! measured in eye space, so any affine map is allowed; lengths grow by its largest stretch at most.
//!
//! **Torus.** First the tube's circle becomes an m-gon: `r (1 - cos(pi/m))`. What turns around the axis then becomes chords
//! of circles of radius up to R + r: `(R + r)(1 - cos(pi/n))`. Flat quads are exactly these chords of chords. For a given
//! sum, n m is smallest when each has half of it.
//!
//! **Curves.** The same with `M/8n^2` for the n chords of the curve, M = 6 times the largest second difference of its control
//! points, which bounds the second derivative of a cubic; and the farthest control point's distance from the axis for
//! R + r. A curve that leaves the planes through the axis has twisted cells: a triangle is off the bilinear cell by at most a
//! quarter of the twist, the difference between two chords of the curve that are 1/m turns apart: `(pi/2m) (3 D/n)`, D
//! the largest first difference. Then each of the three has a third.
//!
//! **Patches.** Over a triangle with legs 1/n in u and v a surface is off by at most `(A + 2 B + C) / 8n^2`, where A, B, C
//! bound its second derivatives uu, uv, vv; for a bicubic 6, 9 and 6 times the largest second differences of its net.
//! It holds for either diagonal.
//!
//! Measured on 18 random views against nets twice as fine (`tori_and_bezier_shapes_keep_the_tolerance`): the error is a quarter of the
//! tolerance in the median and 0.70 of it at most. Bounds of derivatives are that much too careful: a few times the polygons.
//!
//! Space: local and eye space in, pixels out. Cost: a few dozen operations a control point.
//! Source: D. Filip, R. Magedson, R. Markot, "Surface algorithms using bounds on derivatives", Computer Aided Geometric
//! Design 3, 1986, 295-311.

use super::{Lens, MAX_SPHERE, circle_segments, largest_stretch};
use crate::math::{Affine3, PI, Vec3};
use crate::model::teapot::Nets;
use crate::scene::{CurveNet, PatchNet};

/// No shape is cut finer for a tolerance than the finest sphere; beyond it the tolerance is not kept.
const MOST_POLYGONS: f64 = (MAX_SPHERE as f64) * (MAX_SPHERE as f64) / 2.0;

/// What all of these depend on besides the shape.
#[derive(Clone, Copy)]
pub(super) struct Seen<'a> {
    pub eye_from_local: &'a Affine3,
    pub lens: &'a Lens,
    /// Pixels.
    pub tolerance: f64,
}

impl Seen<'_> {
    /// Around the ring and around the tube.
    pub fn torus(&self, ring_radius: f64, tube_radius: f64) -> [u32; 2] {
        let matrix = &self.eye_from_local.matrix3;
        let (stretch, outer) = (largest_stretch(self.eye_from_local), ring_radius + tube_radius);
        // How far a torus reaches along the view: its ring, and a ball of its tube.
        let along = ring_radius * matrix.x_axis.z.hypot(matrix.y_axis.z)
            + tube_radius * matrix.x_axis.z.hypot(matrix.y_axis.z).hypot(matrix.z_axis.z);
        let center = self.eye_from_local.translation;
        let body = Body { nearest: center.z - along, farthest: center.length() + stretch * outer };
        let pixels = body.pixels_per_unit(self.lens) * stretch;
        within_budget([outer, tube_radius].map(|radius| circle_segments(pixels * radius, self.tolerance / 2.0)), 1)
    }

    /// Along every curve, and around the axis in fours.
    pub fn curves(&self, net: &CurveNet) -> [u32; 2] {
        let [mut along, mut around] = [1, 1];
        for curve in &net.curves {
            let [n, m] = self.curve(&curve.map(|index| net.vertices[index as usize]));
            (along, around) = (along.max(n), around.max(m.div_ceil(4)));
        }
        within_budget([along, around], 4 * net.curves.len())
    }

    /// Along one curve and around the axis.
    fn curve(&self, local: &[Vec3; 4]) -> [u32; 2] {
        let stretch = largest_stretch(self.eye_from_local);
        let mut body = Body::default();
        local.iter().for_each(|&point| body.add_ring(point, self.eye_from_local));
        let pixels = body.pixels_per_unit(self.lens) * stretch;
        let flat = |point: Vec3| point.with_z(0.0);
        let radius = largest(local.iter().map(|&point| flat(point)));
        let bend = 6.0 * largest(local.windows(3).map(|three| three[0] - 2.0 * three[1] + three[2]));
        let slope = 3.0 * largest(local.windows(2).map(|two| flat(two[1] - two[0])));

        // Does it stay in one plane through the axis, on both sides of which cells are mirror images?
        let off_plane = largest(local.iter().flat_map(|&a| local.iter().map(move |&b| flat(a).cross(flat(b)))));
        let twisted = off_plane > 1e-12 * radius * radius;
        let share = self.tolerance / if twisted { 3.0 } else { 2.0 };
        let around = circle_segments(pixels * radius, share);
        let along = steps((pixels * bend / (8.0 * share)).sqrt());
        let for_twist = steps(pixels * slope * PI / (2.0 * f64::from(around)) / share);
        [if twisted { along.max(for_twist) } else { along }, around]
    }

    /// Along both sides of every patch.
    pub fn patches(&self, net: &PatchNet) -> u32 {
        let of_patch = |patch: &[u32; 16]| {
            let eye = patch.map(|index| self.eye_from_local.transform_point3(net.vertices[index as usize]));
            let mut body = Body::default();
            eye.iter().for_each(|&point| body.add_point(point));
            let pixels = body.pixels_per_unit(self.lens);
            steps((pixels * bend_of_patch(&eye) / (8.0 * self.tolerance)).sqrt())
        };
        let n = net.patches.iter().map(of_patch).max().unwrap_or(1);
        within_budget([n, n], net.patches.len())[0]
    }

    /// The finest of what the parts need: along curves and both sides of patches; around the axis in fours.
    pub fn teapot(&self, parts: &[Nets]) -> [u32; 2] {
        let (mut along, mut around) = (1, 1);
        for nets in parts {
            let [n, m] = self.curves(&nets.curves);
            (along, around) = (along.max(n).max(self.patches(&nets.patches)), around.max(m));
        }
        within_budget([along, around], 7 * parts.len())
    }
}

/// A + 2 B + C of the module's formula.
fn bend_of_patch(points: &[Vec3; 16]) -> f64 {
    let at = |row: usize, column: usize| points[4 * row + column];
    let pairs = |rows: usize, columns: usize| (0..rows).flat_map(move |r| (0..columns).map(move |c| (r, c)));
    let along = largest(pairs(4, 2).map(|(r, c)| at(r, c) - 2.0 * at(r, c + 1) + at(r, c + 2)));
    let across = largest(pairs(2, 4).map(|(r, c)| at(r, c) - 2.0 * at(r + 1, c) + at(r + 2, c)));
    let mixed = largest(pairs(3, 3).map(|(r, c)| at(r + 1, c + 1) - at(r + 1, c) - at(r, c + 1) + at(r, c)));
    6.0 * along + 2.0 * 9.0 * mixed + 6.0 * across
}

fn largest(vectors: impl Iterator<Item = Vec3>) -> f64 {
    vectors.map(Vec3::length).fold(0.0, f64::max)
}

/// The next whole number; 1 where there is nothing to see. Numbers beyond the budget are brought down by [`within_budget`].
fn steps(number: f64) -> u32 {
    number.ceil().clamp(1.0, f64::from(MAX_SPHERE)).max(1.0) as u32
}

/// Both numbers, brought down alike where `pieces` times their product would be too many polygons.
fn within_budget(pair: [u32; 2], pieces: usize) -> [u32; 2] {
    let wanted = f64::from(pair[0]) * f64::from(pair[1]) * pieces as f64;
    let factor = (MOST_POLYGONS / wanted).sqrt();
    if wanted <= MOST_POLYGONS { pair } else { pair.map(|n| ((f64::from(n) * factor) as u32).max(1)) }
}

/// A convex body in eye space, as far as sizes in the picture depend on it.
struct Body {
    /// Least depth.
    nearest: f64,
    /// Largest distance from the eye.
    farthest: f64,
}

impl Default for Body {
    fn default() -> Body {
        Body { nearest: f64::INFINITY, farthest: 0.0 }
    }
}

impl Body {
    fn add_point(&mut self, eye: Vec3) {
        (self.nearest, self.farthest) = (self.nearest.min(eye.z), self.farthest.max(eye.length()));
    }

    /// Adds the circle that `point` runs on around the z axis.
    fn add_ring(&mut self, point: Vec3, eye_from_local: &Affine3) {
        let radius = point.truncate().length();
        let center = eye_from_local.transform_point3(Vec3::Z * point.z);
        let [across, beside] = [Vec3::X, Vec3::Y].map(|axis| eye_from_local.transform_vector3(axis * radius));
        self.nearest = self.nearest.min(center.z - across.z.hypot(beside.z));
        self.farthest = self.farthest.max(center.length() + across.length().hypot(beside.length()));
    }

    /// By how many pixels the image of something in the body moves, at most, when it moves by a unit.
    fn pixels_per_unit(&self, lens: &Lens) -> f64 {
        let depth = self.nearest.max(lens.hither);
        let secant = (1.0 / lens.corner_cosine).min(self.farthest / depth).max(1.0);
        lens.pixels_per_unit_tangent * secant / depth
    }
}

#[cfg(test)]
#[path = "curved_tests.rs"]
mod tests;
