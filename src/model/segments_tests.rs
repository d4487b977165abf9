//! Outlines of polygons against outlines of the true shapes.

use super::*;
use crate::math::{Vec2, unit};
use crate::model::{Detail, tessellate};
use crate::scene::Mesh;

/// Numbers 0..1 without a pattern that matters (xorshift64*).
pub(super) struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }

    pub fn direction(&mut self) -> Vec3 {
        let v = Vec3::new(self.between(-1.0, 1.0), self.between(-1.0, 1.0), self.between(-1.0, 1.0));
        if v.length() < 1.0 { unit(v).unwrap_or(Vec3::X) } else { self.direction() }
    }
}

const HITHER: f64 = 0.01;

pub(super) fn image(lens: &Lens, point: Vec3) -> Vec2 {
    point.truncate() * (lens.pixels_per_unit_tangent / point.z)
}

/// The convex hull, counterclockwise (Andrew's monotone chain).
fn hull(mut points: Vec<Vec2>) -> Vec<Vec2> {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    let chain = |points: &mut dyn Iterator<Item = Vec2>| {
        let mut chain: Vec<Vec2> = Vec::new();
        for point in points {
            while let [.., a, b] = chain[..] {
                if (b - a).perp_dot(point - b) > 0.0 {
                    break;
                }
                chain.pop();
            }
            chain.push(point);
        }
        chain.pop();
        chain
    };
    let mut lower = chain(&mut points.iter().copied());
    lower.extend(chain(&mut points.iter().rev().copied()));
    lower
}

/// The largest distance of `points` from the hull, which they enclose.
fn largest_gap(points: &[Vec2], hull: &[Vec2]) -> f64 {
    let distance = |p: Vec2, (&a, &b): (&Vec2, &Vec2)| {
        let part = (p - a).dot(b - a) / (b - a).length_squared();
        (p - (a + (b - a) * part.clamp(0.0, 1.0))).length()
    };
    let of_point = |p: &Vec2| crate::math::edges(hull).map(|edge| distance(*p, edge)).fold(f64::INFINITY, f64::min);
    points.iter().map(of_point).fold(0.0, f64::max)
}

/// The distance of two convex outlines, one inside the other: how far apart their parallel tangents are at most.
fn largest_support_difference(outer: &[Vec2], inner: &[Vec2]) -> f64 {
    let support = |points: &[Vec2], u: Vec2| points.iter().map(|p| p.dot(u)).fold(f64::NEG_INFINITY, f64::max);
    let directions = (0..90).map(|i| Vec2::from_angle(f64::from(i) * (PI / 45.0)));
    directions.map(|u| support(outer, u) - support(inner, u)).fold(0.0, f64::max)
}

/// The circle of rays that touch a sphere, as points of the picture.
fn sphere_outline(lens: &Lens, center: Vec3, radius: f64) -> Vec<Vec2> {
    let distance = center.length();
    let (axis, sine) = (center / distance, radius / distance);
    let across = axis.any_orthonormal_vector();
    let rays = (0..720).map(|i| {
        let (s, c) = (f64::from(i) / 720.0 * 2.0 * PI).sin_cos();
        axis * (1.0 - sine * sine).sqrt() + (across * c + axis.cross(across) * s) * sine
    });
    rays.map(|ray| image(lens, ray)).collect()
}

fn ellipse_outline(lens: &Lens, center: Vec3, axes: [Vec3; 2], scale: f64) -> Vec<Vec2> {
    let points = (0..720).map(|i| {
        let (s, c) = (f64::from(i) / 720.0 * 2.0 * PI).sin_cos();
        image(lens, center + (axes[0] * c + axes[1] * s) * scale)
    });
    points.collect()
}

pub(super) struct Sample {
    pub lens: Lens,
    pub center: Vec3,
    pub radius: f64,
}

/// A ball of 1 to 500 pixels that is wholly in view, under an opening of 20 to 100 degrees.
pub(super) fn ball_in_view(random: &mut Random) -> Sample {
    loop {
        let half_field = random.between(10.0, 50.0).to_radians();
        let lens = Lens {
            pixels_per_unit_tangent: random.between(50.0, 600.0) / half_field.tan(),
            hither: HITHER,
            corner_cosine: 0.0,
        };
        let center = Vec3::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0), 1.0)
            * Vec3::new(half_field.tan(), half_field.tan(), 1.0)
            * random.between(1.0, 9.0);
        let radius = center.length() * 10f64.powf(random.between(-2.5, -0.1));
        let [off_axis, opening] =
            [center.truncate().length() / center.length(), radius / center.length()].map(f64::asin);
        if off_axis + opening < half_field {
            return Sample { lens, center, radius };
        }
    }
}

fn report(name: &str, mut ratios: Vec<f64>) -> (f64, f64, f64) {
    ratios.sort_by(f64::total_cmp);
    let (low, middle, high) = (ratios[0], ratios[ratios.len() / 2], ratios[ratios.len() - 1]);
    println!("{name}: min {low:.4}, median {middle:.4}, max {high:.4} of {}", ratios.len());
    (low, middle, high)
}

/// The fewest segments (in steps of `step`) whose gap in the worst position is within the tolerance.
fn fewest(start: u32, step: u32, tolerance: f64, gap: impl Fn(u32) -> f64) -> u32 {
    let mut n = start;
    while gap(n) > tolerance {
        n += step;
    }
    n
}

#[test]
fn spheres_keep_the_tolerance_and_waste_little() {
    let mut random = Random(42);
    let (mut errors, mut counts) = (Vec::new(), Vec::new());
    let mut mesh = Mesh::default();
    for sample in 0..150 {
        let Sample { lens, center, radius } = ball_in_view(&mut random);
        let tolerance = [1.0, 0.25, 0.0625][sample % 3];
        let [n, _] = segments(&Shape::Sphere { center, radius }, &Affine3::IDENTITY, &lens, tolerance);
        // Tessellate a turned sphere: poles may point anywhere.
        let turn = Affine3::from_axis_angle(random.direction(), random.between(0.0, 6.0));
        mesh.clear();
        tessellate(&Shape::Sphere { center: Vec3::ZERO, radius }, false, Detail::Segments(n), 0, &mut mesh);
        let polygons = hull(mesh.vertices.iter().map(|&v| image(&lens, center + turn.transform_point3(v))).collect());
        let outline = sphere_outline(&lens, center, radius);
        let error = largest_gap(&outline, &polygons);
        assert!(error <= tolerance * (1.0 + 1e-9), "{error} px at {center} r {radius}, n {n}");
        // The polygons may lie as deep as the inner ball anywhere; count against the n that just holds then.
        let outermost = |radius: f64| {
            let [off_axis, opening] =
                [center.truncate().length() / center.length(), radius / center.length()].map(f64::asin);
            lens.pixels_per_unit_tangent * (off_axis + opening).tan()
        };
        let gap = |n: u32| outermost(radius) - outermost(radius * (PI / f64::from(n)).cos().powi(2));
        if n > MIN_SPHERE {
            errors.push(error / tolerance);
            counts.push(f64::from(n) / f64::from(fewest(MIN_SPHERE, 2, tolerance, gap)));
        }
    }
    report("sphere error / tolerance", errors);
    let (_, _, waste) = report("sphere segments / fewest", counts);
    assert!(waste <= 1.15);
}

#[test]
fn cones_keep_the_tolerance_and_waste_little() {
    let mut random = Random(7);
    let (mut errors, mut counts) = (Vec::new(), Vec::new());
    let mut mesh = Mesh::default();
    for sample in 0..150 {
        let Sample { lens, center, radius } = ball_in_view(&mut random);
        let tolerance = [1.0, 0.25, 0.0625][sample % 3];
        // A cone in that ball: both end circles touch it, or the other end is a point.
        let (axis, share) = (random.direction(), random.between(0.05, 0.999));
        let thick = radius * (1.0 - share * share).sqrt();
        let thin = if sample % 2 == 0 { thick } else { 0.0 };
        let (base, apex) = (center - axis * radius * share, center + axis * radius * share);
        let shape = Shape::Cone { base, base_radius: thick, apex, apex_radius: thin };
        let [n, _] = segments(&shape, &Affine3::IDENTITY, &lens, tolerance);
        let frame = Cone { base, base_radius: thick, apex, apex_radius: thin }.frame();
        mesh.clear();
        tessellate(&shape, false, Detail::Segments(n), 0, &mut mesh);
        let (mut error, mut worst) = (0.0, 0);
        for (first, end, end_radius) in [(0, base, thick), (n as usize, apex, thin)] {
            if end_radius == 0.0 {
                continue;
            }
            let rim = hull(mesh.vertices[first..first + n as usize].iter().map(|&v| image(&lens, v)).collect());
            let axes = [frame.across * end_radius, frame.beside * end_radius];
            let outline = ellipse_outline(&lens, end, axes, 1.0);
            error = largest_gap(&outline, &rim).max(error);
            let inner = |n: u32| ellipse_outline(&lens, end, axes, (PI / f64::from(n)).cos());
            let gap = |n: u32| largest_support_difference(&outline, &inner(n));
            // The gap is monotone in n: start close below the answer instead of at 3.
            let start = (f64::from(n) * 0.8) as u32;
            if n > MIN_CIRCLE && sample % 3 < 2 {
                worst = worst.max(fewest(start.max(MIN_CIRCLE), 1, tolerance, gap));
            }
        }
        assert!(error <= tolerance * (1.0 + 1e-9), "{error} px at {shape:?}, n {n}");
        if n > MIN_CIRCLE {
            errors.push(error / tolerance);
        }
        // What is seen through is finer, for the corners of its hole.
        if worst > 0 && hole_sharpness(&shape, &Affine3::IDENTITY, &lens) == 1.0 {
            counts.push(f64::from(n) / f64::from(worst));
        }
    }
    report("cone error / tolerance", errors);
    let (_, _, waste) = report("cone segments / fewest", counts);
    assert!(waste <= 1.15);
}

#[test]
fn stretched_shapes_keep_the_tolerance_too() {
    let mut random = Random(11);
    let mut errors = Vec::new();
    let (mut mesh, mut fine) = (Mesh::default(), Mesh::default());
    let sphere = Shape::Sphere { center: Vec3::ZERO, radius: 1.0 };
    let tube = Shape::Cone { base: Vec3::NEG_Z, base_radius: 0.7, apex: Vec3::Z * 0.5, apex_radius: 0.3 };
    for sample in 0..40 {
        let Sample { lens, center, radius } = ball_in_view(&mut random);
        let scale = Vec3::new(1.0, random.between(0.05, 1.0), random.between(0.05, 1.0)) * (0.8 * radius);
        let turn = |random: &mut Random| Affine3::from_axis_angle(random.direction(), random.between(0.0, 6.0));
        let map = turn(&mut random) * Affine3::from_scale(scale) * turn(&mut random);
        let eye_from_local = Affine3::from_translation(center) * map;
        let shape = if sample % 2 == 0 { sphere.clone() } else { tube.clone() };
        let [n, _] = segments(&shape, &eye_from_local, &lens, 0.25);
        let outline = |n: u32, mesh: &mut Mesh| {
            mesh.clear();
            tessellate(&shape, false, Detail::Segments(n), 0, mesh);
            hull(mesh.vertices.iter().map(|&v| image(&lens, eye_from_local.transform_point3(v))).collect())
        };
        // What is five times finer errs by a twenty-fifth: small enough to stand for the truth.
        let error = largest_gap(&outline(5 * n, &mut fine), &outline(n, &mut mesh));
        assert!(error <= 0.25, "{error} px, n {n}");
        errors.push(error / 0.25);
    }
    let (_, middle, _) = report("stretched error / tolerance", errors);
    assert!(middle > 0.5);
}

#[test]
fn tangents_grow_as_fast_as_their_derivative_says() {
    // The general measure of an ellipsoid that is a sphere equals the closed form, but for the margin.
    let mut random = Random(3);
    for _ in 0..2000 {
        let Sample { lens, center, radius } = ball_in_view(&mut random);
        let turn = Affine3::from_axis_angle(random.direction(), random.between(0.0, 6.0)).matrix3;
        let axes = [turn.x_axis, turn.y_axis, turn.z_axis].map(|axis| axis * radius);
        let (general, closed) = (lens.ellipse_radius(center, &axes), lens.sphere_radius(center, radius));
        assert!(general >= closed * (1.0 - 1e-12) && general <= closed * 1.00484, "{general} {closed}");
    }
    // Far away it is the plain ratio, to the last digits.
    let lens = Lens { pixels_per_unit_tangent: 100.0, hither: 1.0, corner_cosine: 0.0 };
    let far = lens.ellipse_radius(Vec3::new(0.0, 0.0, 1e12), &[Vec3::X, Vec3::Y]);
    assert!((far / 1e-10 - 1.0).abs() < 1e-11, "{far}");
    assert!((projected_radius(Vec3::new(0.0, 0.0, 1e12), 1.0, 100.0, 1.0) / 1e-10 - 1.0).abs() < 1e-12);
}

#[test]
fn shapes_at_the_eye_have_a_bound() {
    let lens = Lens { pixels_per_unit_tangent: 500.0, hither: 0.1, corner_cosine: 0.8 };
    // Around the eye, through the eye, behind it, and one whose outline leaves the picture.
    for center in [Vec3::ZERO, Vec3::Z, Vec3::new(0.0, 0.0, -3.0), Vec3::new(0.9, 0.0, 0.7), Vec3::new(1.0, 0.0, 0.0)] {
        let radius = lens.sphere_radius(center, 1.0);
        assert!(radius > 0.0 && radius <= 500.0 / (0.1 * 0.64), "{center}: {radius}");
        let ring = lens.ellipse_radius(center, &[Vec3::X, Vec3::Z]);
        assert!(ring > 0.0 && ring <= 500.0 / (0.1 * 0.8) * 1.0001, "{center}: {ring}");
        // Without a known corner it may be much larger, but is a number.
        assert!(projected_radius(center, 1.0, 500.0, 0.1) >= radius);
    }
    assert_eq!((sphere_segments(f64::INFINITY, 0.25), circle_segments(f64::INFINITY, 0.25)), (MAX_SPHERE, MAX_CIRCLE));
    assert_eq!((sphere_segments(10.0, 0.0), circle_segments(10.0, -1.0)), (MAX_SPHERE, MAX_CIRCLE));
    assert_eq!((sphere_segments(f64::NAN, 0.25), circle_segments(0.0, 0.25)), (MIN_SPHERE, MIN_CIRCLE));
    assert_eq!([10.0, 512.0].map(|radius| circle_segments(radius, 0.25)), [15, 101]);
}

#[test]
fn stretch_bounds_every_direction_closely() {
    let mut random = Random(5);
    for _ in 0..500 {
        let columns = [0; 3].map(|_| random.direction() * 10f64.powf(random.between(-3.0, 3.0)));
        let map = Affine3::from_mat3(Mat3::from_cols(columns[0], columns[1], columns[2]));
        // Power iteration finds the true value from below.
        let gram = map.matrix3.transpose() * map.matrix3;
        let top = (0..2000).fold(random.direction(), |v, _| unit(gram * v).unwrap_or(v));
        let (bound, value) = (largest_stretch(&map), (map.matrix3 * top).length());
        assert!(bound >= value * (1.0 - 1e-14) && bound <= value * 1.036, "{bound} {value}");
        assert_eq!(similarity_scale(&map), None);
    }
    for scale in [1e-200, 0.3, 1.0, 7.0, 1e200] {
        let turned =
            Affine3::from_axis_angle(random.direction(), 1.0) * Affine3::from_scale(Vec3::new(scale, scale, -scale));
        assert!((largest_stretch(&turned) / scale - 1.0).abs() < 1e-14);
        assert!((similarity_scale(&turned).expect("is one") / scale - 1.0).abs() < 1e-14);
    }
    assert_eq!(largest_stretch(&Affine3::from_scale(Vec3::new(1.0, -4.0, 2.0))), 4.0);
    assert_eq!(
        (largest_stretch(&Affine3::from_scale(Vec3::ZERO)), similarity_scale(&Affine3::from_scale(Vec3::ZERO))),
        (0.0, None)
    );
}
