//! How many segments a shape needs, so that its outline in the picture is right to a tolerance in pixels.
//!
//! Here: spheres, ellipsoids and cones, whose outlines have closed forms. Tori and Bezier shapes: `curved`, from bounds.
//!
//! Space: eye space, +z along the view, in; pixels out. Cost: a few square roots a sphere, a few hundred multiplications a circle.
//!
//! **From radius to segments.** A regular n-gon in a circle of radius R contains the circle of radius R cos(pi/n), so its
//! outline errs by at most `R (1 - cos(pi/n)) = 2 R sin^2(pi/2n)`, about `R pi^2 / 2n^2`. A sphere of n columns and n/2 bands errs in two
//! directions. The plane of a facet between latitudes a and b, half a column pi/n to either side, is
//! `R cos^2(pi/n) / sqrt(cos^2(pi/n) sin^2 m + cos^2 m)` from the center, m = (a+b)/2; never less than `R cos^2(pi/n)`, and equal to
//! it at the equator. So the polyhedron lies between the balls R and R cos^2(pi/n), whatever side it is seen from,
//! and errs by at most `R sin^2(pi/n)`, about `R pi^2 / n^2`. An even number of bands has no facet on the equator, the flattest have
//! m = pi/n: two segments fewer may then do (6 % less error for n = 8). Solved for n, with t the tolerance:
//! `n = pi / (2 asin sqrt(t/2R))` and `n = pi / asin sqrt(t/R)`; for small t/R the well-known `pi / sqrt(2t/R)` and `pi / sqrt(t/R)`.
//!
//! **From shape to radius in pixels.** Both bodies between which the polygons lie are the shape, scaled about its center by 1 and by
//! 1 - s. What is asked is how fast the image's outline grows with the scale; that number, in pixels, is the R above.
//! *Sphere* of radius r, center at distance d, at an angle q off the view axis: its outline is a cone of rays of half
//! angle a, sin a = r/d, around the ray to the center. Growing, a rises by `r/L` a unit of scale, L = sqrt(d^2 - r^2) being the
//! distance of every point of the outline. A turn of a ray at an angle w off axis moves its image by up to `1/cos^2 w` (away from the
//! middle of the picture), w is at most q + a, and there the movement is away from the middle: `R = f r / (L cos^2(q + a))`, f pixels a unit
//! tangent. It is exact and not only a bound.
//! *Ellipse or ellipsoid* with half axes e_i (a circle or sphere under any transform): a line of the picture with unit normal u at distance h from
//! its middle is a plane through the eye with normal m = (u, -h). It touches the body where `(m.C)^2 = sum (m.e_i)^2`, a quadratic equation in h
//! with one root for u and one for -u. At the touching point p, m.p = 0 gives `dh/dscale = -(m.C) / p_z`. Its maximum over all u is R;
//! it is as smooth as the distance of an ellipse's tangents, so sixteen directions, both roots, and a margin
//! of 1/cos(pi/32) = 1.005 for the directions between hold it (`cones_keep_the_tolerance_and_waste_little`).
//! A cone's image is the hull of its two ends' images, and hulls differ by no more than what they are made of: its R is the larger end's.
//! Seen through, it has a hole, whose corners move by more: [`hole`].
//!
//! **Near the eye.** Only what is in front of hither and within the picture is seen: L and depths count as at least hither, angles w as at
//! most the corner's where the corner is known. An eye inside a sphere sees no outline; then L is the distance to the wall.
//! Where hither itself cuts a shape, the cut's edge is no outline and is not held to the tolerance.
//!
//! Measured on 4,000 random balls and 4,000 cones in view (tolerances 1, 1/4, 1/16): none errs by more than the tolerance. Counted against the
//! fewest that hold in the worst position: 1 sphere of 3,873 and 10 cones of 2,431 got one step too many, all of 7 segments or fewer.
//!
//! Source: the derivation is our own; the one-direction formula is common knowledge.

mod curved;
mod hole;

use super::cone::Cone;
use crate::math::{Affine3, Mat3, PI, Vec3, asin, cos};
use crate::scene::Shape;

/// Fewest segments around a sphere: an octahedron.
pub const MIN_SPHERE: u32 = 4;
/// Most segments around a sphere: 524,288 polygons. Enough for a radius of 26,000 pixels at a tolerance of 1/4.
pub const MAX_SPHERE: u32 = 1024;
/// Fewest segments around a cone.
pub const MIN_CIRCLE: u32 = 3;
/// Most segments around a cone. Enough for a radius of 850,000 pixels at a tolerance of 1/4.
pub const MAX_CIRCLE: u32 = 4096;

/// What turns eye space into pixels: as much of the camera as the size of an image depends on. Pixels are square.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lens {
    /// How many pixels from the middle of the picture a ray hits that leaves it by one unit sideways per unit along.
    pub pixels_per_unit_tangent: f64,
    /// Depth of the near plane; above 0.
    pub hither: f64,
    /// Cosine of the angle between the view and a corner of the picture; 0 where it is not known.
    pub corner_cosine: f64,
}

/// The numbers of segments a shape needs, as [`super::Detail::Grid`] takes them: even for spheres; around the ring and the tube of a torus; along
/// a curve and, in fours, around its axis; otherwise twice the same.
///
/// * `eye_from_local`: any affine map; ellipses and ellipsoids are measured as what they are.
/// * `tolerance`: pixels; zero or less gives the maximum.
#[must_use]
pub fn segments(shape: &Shape, eye_from_local: &Affine3, lens: &Lens, tolerance: f64) -> [u32; 2] {
    let axis = |direction: Vec3, radius: f64| eye_from_local.transform_vector3(direction * radius);
    let ellipsoid = |center: Vec3, radii: Vec3| {
        let half_axes = [axis(Vec3::X, radii.x), axis(Vec3::Y, radii.y), axis(Vec3::Z, radii.z)];
        lens.ellipse_radius(eye_from_local.transform_point3(center), &half_axes)
    };
    let seen = curved::Seen { eye_from_local, lens, tolerance: tolerance.max(0.0) };
    let both = |n: u32| [n, n];
    match *shape {
        Shape::Sphere { center, radius } => {
            let projected = match similarity_scale(eye_from_local) {
                Some(scale) => lens.sphere_radius(eye_from_local.transform_point3(center), radius * scale),
                None => ellipsoid(center, Vec3::splat(radius)),
            };
            both(sphere_segments(projected, tolerance))
        }
        Shape::Ellipsoid { radii } => both(sphere_segments(ellipsoid(Vec3::ZERO, radii), tolerance)),
        Shape::Cone { base, base_radius, apex, apex_radius } => {
            let cone = Cone { base, base_radius, apex, apex_radius };
            let tolerance = tolerance * hole_sharpness(shape, eye_from_local, lens);
            both(circle_segments(cone_radius(&cone, eye_from_local, lens), tolerance))
        }
        Shape::CappedCone { bottom_radius, top_radius, length } => {
            let cone = super::cone_about_z(bottom_radius, top_radius, length);
            both(circle_segments(cone_radius(&cone, eye_from_local, lens), tolerance))
        }
        // Flat faces are what they are.
        Shape::Block { .. } | Shape::Prism { .. } => both(1),
        Shape::Torus { ring_radius, tube_radius } => seen.torus(ring_radius, tube_radius),
        Shape::Patches(ref net) => both(seen.patches(net)),
        Shape::Curves(ref net) => seen.curves(net),
        Shape::Teapot(part) => seen.teapot(super::teapot::parts(part)),
    }
}

/// The sine of half the sharpest corner of the hole that a cone seen through its open ends shows; 1 for whatever has none.
/// By this factor the outlines of its ends are finer than the tolerance asks.
#[must_use]
pub fn hole_sharpness(shape: &Shape, eye_from_local: &Affine3, lens: &Lens) -> f64 {
    let Shape::Cone { base, base_radius, apex, apex_radius } = *shape else { return 1.0 };
    hole::sharpness(&Cone { base, base_radius, apex, apex_radius }, eye_from_local, lens.hither)
}

/// The radius in pixels of the larger end.
fn cone_radius(cone: &Cone, eye_from_local: &Affine3, lens: &Lens) -> f64 {
    let frame = cone.frame();
    let end = |center: Vec3, radius: f64| {
        let half_axes = [frame.across, frame.beside].map(|axis| eye_from_local.transform_vector3(axis * radius));
        lens.ellipse_radius(eye_from_local.transform_point3(center), &half_axes)
    };
    end(cone.base, cone.base_radius).max(end(cone.apex, cone.apex_radius))
}

/// Segments around a sphere of `radius` pixels that errs by at most `tolerance` pixels; even, [`MIN_SPHERE`] to [`MAX_SPHERE`].
///
/// ```
/// assert_eq!(farop::model::segments::sphere_segments(61.0, 0.25), 50);
/// ```
#[must_use]
pub fn sphere_segments(radius: f64, tolerance: f64) -> u32 {
    let ratio = tolerance / radius;
    // Also where radius is 0 or not a number: nothing to see.
    if ratio >= 1.0 || ratio.is_nan() {
        return MIN_SPHERE;
    }
    let half = (PI / (2.0 * asin(ratio.max(0.0).sqrt()))).ceil();
    let segments = 2 * half.clamp(f64::from(MIN_SPHERE / 2), f64::from(MAX_SPHERE / 2)) as u32;
    let fewer = segments - 2;
    let has_none_on_equator = (fewer / 2).is_multiple_of(2) && fewer >= MIN_SPHERE;
    if has_none_on_equator && off_equator_error(fewer) <= ratio { fewer } else { segments }
}

/// The largest error of a unit sphere of `n` segments, n / 2 even: facets next to the equator, their middles at a latitude of pi/n.
fn off_equator_error(n: u32) -> f64 {
    let cosine = cos(PI / f64::from(n));
    let squared = cosine * cosine;
    1.0 - squared / (squared * (1.0 - squared) + squared).sqrt()
}

/// Segments around a circle, cone or cylinder of `radius` pixels; [`MIN_CIRCLE`] to [`MAX_CIRCLE`].
///
/// ```
/// assert_eq!(farop::model::segments::circle_segments(100.0, 0.25), 45);
/// ```
#[must_use]
pub fn circle_segments(radius: f64, tolerance: f64) -> u32 {
    let ratio = tolerance / radius;
    if ratio >= 1.0 || ratio.is_nan() {
        return MIN_CIRCLE;
    }
    let around = (PI / (2.0 * asin((ratio.max(0.0) / 2.0).sqrt()))).ceil();
    around.clamp(f64::from(MIN_CIRCLE), f64::from(MAX_CIRCLE)) as u32
}

/// The radius in pixels that [`sphere_segments`] wants, where the picture's corner is not known: [`Lens::sphere_radius`].
#[must_use]
pub fn projected_radius(center_in_eye: Vec3, radius: f64, pixels_per_unit_tangent: f64, hither: f64) -> f64 {
    Lens { pixels_per_unit_tangent, hither, corner_cosine: 0.0 }.sphere_radius(center_in_eye, radius)
}

impl Lens {
    /// Pixels by which a sphere's outline moves per unit of scale, at the place where it moves most.
    ///
    /// Exact where the whole outline is seen, never too small where part of it is; may be infinite.
    #[must_use]
    pub fn sphere_radius(&self, center: Vec3, radius: f64) -> f64 {
        let distance = center.length();
        let to_outline =
            if distance > radius { ((distance - radius) * (distance + radius)).sqrt() } else { radius - distance };
        // The cosine of q + a, by the addition theorem.
        let off_axis = center.truncate().length();
        let outermost = (center.z * to_outline - off_axis * radius) / (distance * distance);
        let seen_from = to_outline.max(self.hither);
        let cosine = outermost.max(self.hither / seen_from).max(self.corner_cosine);
        self.pixels_per_unit_tangent * radius / (seen_from * cosine * cosine)
    }

    /// The same for an ellipse (two half axes) or ellipsoid (three): a circle or sphere under any affine map.
    ///
    /// At most 0.5 % too large where all of it is in front of hither; a safe bound otherwise.
    #[must_use]
    pub fn ellipse_radius(&self, center: Vec3, half_axes: &[Vec3]) -> f64 {
        let reach = half_axes.iter().map(|axis| axis.z * axis.z).sum::<f64>().sqrt();
        let exact = if center.z - reach >= self.hither {
            TANGENT_DIRECTIONS.iter().map(|&u| fastest_tangent(u, center, half_axes)).fold(0.0, f64::max)
                * (self.pixels_per_unit_tangent * BETWEEN_DIRECTIONS)
        } else {
            f64::INFINITY
        };
        exact.min(self.nearest_point_bound(center, half_axes, reach))
    }

    /// A displacement moves its image by at most `1 / (depth cos w)` times its length.
    fn nearest_point_bound(&self, center: Vec3, half_axes: &[Vec3], reach: f64) -> f64 {
        let column = |index: usize| half_axes.get(index).copied().unwrap_or(Vec3::ZERO);
        let radius = stretch_of(&Mat3::from_cols(column(0), column(1), column(2)));
        let depth = (center.z - reach).max(self.hither);
        let secant = (1.0 / self.corner_cosine).min((center.length() + radius) / depth).max(1.0);
        self.pixels_per_unit_tangent * radius * secant / depth
    }
}

/// Unit vectors 0, 11.25, ... 168.75 degrees; each stands for its opposite too.
const TANGENT_DIRECTIONS: [[f64; 2]; 16] = {
    const C1: f64 = 0.980_785_280_403_230_4;
    const S1: f64 = 0.195_090_322_016_128_27;
    const C2: f64 = 0.923_879_532_511_286_7;
    const S2: f64 = 0.382_683_432_365_089_8;
    const C3: f64 = 0.831_469_612_302_545_2;
    const S3: f64 = 0.555_570_233_019_602_2;
    const D: f64 = std::f64::consts::FRAC_1_SQRT_2;
    let (first, second) = ([[1.0, 0.0], [C1, S1], [C2, S2], [C3, S3]], [[D, D], [S3, C3], [S2, C2], [S1, C1]]);
    let (third, fourth) = ([[0.0, 1.0], [-S1, C1], [-S2, C2], [-S3, C3]], [[-D, D], [-C3, S3], [-C2, S2], [-C1, S1]]);
    let [[a, b, c, d], [e, f, g, h], [i, j, k, l], [m, n, o, p]] = [first, second, third, fourth];
    [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p]
};
/// 1 / cos(pi/32): how much more a tangent half way between two of the directions may move.
const BETWEEN_DIRECTIONS: f64 = 1.004_838_572_376_311_4;

/// dh/dscale of the faster of the two tangents with normal `u` and `-u`, for a picture at distance 1. All of the body is at positive depth.
fn fastest_tangent(u: [f64; 2], center: Vec3, half_axes: &[Vec3]) -> f64 {
    let along_u = |v: Vec3| u[0] * v.x + u[1] * v.y;
    let a = along_u(center);

    // Solve q2 h^2 - 2 q1 h + q0 = 0; its discriminant is summed from small terms, so that a body far away keeps its size.
    let (mut q2, mut q1, mut discriminant) = (center.z * center.z, a * center.z, 0.0);
    for (index, axis) in half_axes.iter().enumerate() {
        q2 -= axis.z * axis.z;
        q1 -= along_u(*axis) * axis.z;
        discriminant += (along_u(*axis) * center.z - a * axis.z).powi(2);
        for other in &half_axes[..index] {
            discriminant -= (along_u(*axis) * other.z - along_u(*other) * axis.z).powi(2);
        }
    }

    // Take both tangents: the touching point lies on opposite sides of the center.
    let root = discriminant.max(0.0).sqrt();
    let speed = |side: f64| {
        let h = (q1 + side * root) / q2;
        let across = |axis: &Vec3| along_u(*axis) - h * axis.z;
        let radius = half_axes.iter().map(|axis| across(axis).powi(2)).sum::<f64>().sqrt();
        let depth = center.z + side * half_axes.iter().map(|axis| axis.z * across(axis)).sum::<f64>() / radius;
        if radius > 0.0 { radius / depth } else { 0.0 }
    };
    speed(1.0).max(speed(-1.0))
}

/// By how much a map lengthens vectors at most: never below its largest singular value (but for rounding), at most 4 % above, equal to it
/// for similarities and for scales along the axes. Not finite for a map that is not.
#[must_use]
pub fn largest_stretch(map: &Affine3) -> f64 {
    stretch_of(&map.matrix3)
}

fn stretch_of(matrix: &Mat3) -> f64 {
    // The largest row sum of a symmetric matrix bounds its eigenvalues, to a factor 3 at worst. Squaring the matrix squares them:
    // after four squarings of M^T M the factor is the 32nd root of 3.
    let largest_number = largest_entry(matrix);
    if largest_number == 0.0 || !matrix.is_finite() {
        return largest_number;
    }
    let scaled = matrix.to_cols_array().map(|x| x / largest_number);
    let scaled = Mat3::from_cols_array(&scaled);
    let mut gram = scaled.transpose() * scaled;
    let mut stretch = largest_number;
    let mut exponent = 0.5;
    for _ in 0..4 {
        let size = largest_row_sum(&gram);
        stretch *= crate::math::pow(size, exponent);
        gram *= 1.0 / size;
        gram = gram * gram;
        exponent *= 0.5;
    }
    stretch * crate::math::pow(largest_row_sum(&gram), exponent)
}

fn largest_entry(matrix: &Mat3) -> f64 {
    matrix.to_cols_array().into_iter().fold(0.0f64, |largest, x| largest.max(x.abs()))
}

fn largest_row_sum(matrix: &Mat3) -> f64 {
    // Symmetric: columns are rows.
    [matrix.x_axis, matrix.y_axis, matrix.z_axis]
        .map(|column| column.abs().element_sum())
        .into_iter()
        .fold(0.0, f64::max)
}

/// The factor by which a similarity (turn, mirror, equal scale, move) scales lengths; `None` for other maps.
///
/// Ten thousand chained rotations drift by 1e-12; what is within 1e-9 counts as a similarity.
#[must_use]
pub fn similarity_scale(map: &Affine3) -> Option<f64> {
    let largest_number = largest_entry(&map.matrix3);
    if largest_number == 0.0 || !map.matrix3.is_finite() {
        return None;
    }
    let scaled = Mat3::from_cols_array(&map.matrix3.to_cols_array().map(|x| x / largest_number));
    let gram = scaled.transpose() * scaled;
    let mean = (gram.x_axis.x + gram.y_axis.y + gram.z_axis.z) / 3.0;
    let rest = gram - Mat3::from_diagonal(Vec3::splat(mean));
    (largest_entry(&rest) <= 1e-9 * mean).then(|| largest_number * mean.sqrt())
}

#[cfg(test)]
#[path = "segments_tests.rs"]
mod tests;
