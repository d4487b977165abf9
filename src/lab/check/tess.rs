//! Tess: outlines of tessellated shapes against the shapes themselves, and whether fewer segments would have done.
//!
//! random sphere, ellipsoid or cone -> polygons as the pipeline makes them; [`crate::oracle::ray`] -> the true outline -> largest distance
//!
//! A cone that is seen through has a hole with corners; the bound for those counts on the worst turn, and is reported apart.
//! Fewer would have done where n / 1.15 segments hold the tolerance, too, however the shape is turned: it is turned about until an outline
//! errs by more. The ends of a cone are held to it, too, where the outline hides them: they are seen from inside. Shapes that need fewer than eight segments step too coarsely for such a ratio and are only reported.
//! Patches and tori have no equation in the oracle: for them the number of segments comes from bounds, proven in `model::segments`.
//!
//! Space: pixels. Source: the distance of two outlines is Hausdorff's; see [`crate::oracle::ray::silhouette`].
//! Cost: a tenth of a second a shape and turn.

use super::random_scenes::of_shape;
use super::{Effort, Random, Report};
use crate::math::{Affine3, Mat3, PI, Vec3, cos, sin, unit};
use crate::model::segments::{Lens, hole_sharpness};
use crate::oracle::Vertices;
use crate::oracle::ray::Tracer;
use crate::oracle::ray::silhouette::{Deviation, Polygons, deviation, traced};
use crate::plan::{Accepts, Choices, Culling, Plan};
use crate::render::render;
use crate::scene::{Scene, Shape};

/// Pixels of a side.
const SIDE: u32 = 96;
/// Tolerances that are asked for.
const TOLERANCES: [f64; 3] = [1.0, 0.25, 1.0 / 16.0];
/// The most that a number of segments may be above the least that holds.
const WASTE: f64 = 1.15;
/// Fewer segments count as enough below this part of the tolerance: the outline is met on lines between samples, and its deepest place
/// may lie between them.
const MARGIN: f64 = 0.97;
/// From here on the ratio is asked for.
const COUNTED: u32 = 8;

/// Random shapes at all tolerances.
pub(super) fn run(effort: &Effort, report: &mut Report) {
    let shapes = effort.count(6, 100).max(2);
    let mut large = 0;
    for (tolerance, part) in TOLERANCES.into_iter().zip(1..) {
        let mut random = effort.random(part);
        let mut sums = [Sum::default(), Sum::default(), Sum::default()];
        for _ in 0..shapes {
            for (kind, sum) in sums.iter_mut().enumerate() {
                let posed = Posed::random(kind, &mut random);
                sum.add(&posed, tolerance, &mut random, report);
            }
        }
        for (name, sum) in ["spheres", "ellipsoids", "cones"].into_iter().zip(&sums) {
            sum.print(&format!("{name}, tolerance {tolerance}"), report);
            large += sum.counted;
        }
    }
    report.some(format!("spheres and cones of {COUNTED} segments or more, all tolerances"), large);
}

/// A shape about the origin, how it is turned, and where it stands.
struct Posed {
    shape: Shape,
    turn: Mat3,
    place: Vec3,
}

impl Posed {
    /// Wholly in view (an outline beyond the border is not judged), in front of hither, at any place and slant.
    fn random(kind: usize, random: &mut Random) -> Posed {
        let distance = random.between(3.0, 12.0);
        let place = Vec3::new(random.between(-0.4, 0.4), random.between(-0.4, 0.4), -1.0) * distance;
        let mut part = |low: f64, high: f64| random.between(low, high) * distance;
        let shape = match kind {
            0 => Shape::Sphere { center: Vec3::ZERO, radius: part(0.03, 0.25) },
            1 => Shape::Ellipsoid { radii: Vec3::new(part(0.05, 0.25), part(0.05, 0.25), part(0.05, 0.25)) },
            _ => {
                let (radius, half) = (part(0.04, 0.2), part(0.05, 0.2));
                let apex_radius = if random.once_in(3) { 0.0 } else { random.between(0.3, 1.0) * radius };
                let (base, apex) = (Vec3::new(0.0, 0.0, -half), Vec3::new(0.0, 0.0, half));
                Shape::Cone { base, base_radius: radius, apex, apex_radius }
            }
        };
        Posed { shape, turn: rotation(random), place }
    }

    /// The scene; `resolution` segments instead of those that the tolerance asks for.
    fn scene(&self, about: Mat3, resolution: Option<u32>) -> Scene {
        let mut scene = of_shape(self.shape.clone(), SIDE);
        scene.objects[0].parent_from_local = Affine3::from_mat3_translation(self.turn * about, self.place);
        scene.surfaces[0].primitives[0].resolution = resolution.map(|n| [n, n]);
        scene
    }

    /// How far the outline of the polygons is from that of the shape, and how many polygons there are.
    fn deviation(&self, tolerance: f64, about: Mat3, resolution: Option<u32>) -> Option<(Deviation, u64)> {
        let scene = self.scene(about, resolution);
        let choices = Choices { culling: Culling::None, tolerance, ..Choices::default() };
        let drawn = render(&scene, &choices, None).ok()?;
        let tracer = Tracer::new(&scene, &choices).ok()?;
        let polygons = Polygons::new(&drawn.list, Vertices::Raw, |_| true);
        let found = deviation(&traced(&tracer, |_| true), &polygons, tracer.size(), 4.0);
        Some((found, drawn.counts.tessellated.polygons))
    }

    /// Segments around, from the number of polygons: n n / 2 of a sphere, n of a cone.
    fn segments(&self, polygons: u64) -> u32 {
        match self.shape {
            Shape::Cone { .. } => polygons as u32,
            _ => ((2 * polygons) as f64).sqrt().round() as u32,
        }
    }

    /// Whether `segments` hold the tolerance in all of some turns about.
    fn holds(&self, segments: u32, tolerance: f64, random: &mut Random) -> bool {
        (0..40).all(|_| {
            let about = match self.shape {
                Shape::Sphere { radius, .. } => self.facet_on_outline(segments, radius, random),
                _ => about_z(random.unit() * 2.0 * PI),
            };
            let keeps = |found: (Deviation, u64)| found.0.largest <= tolerance * MARGIN;
            let kept = |posed: &Posed| posed.deviation(tolerance, about, Some(segments)).is_none_or(keeps);
            kept(self) && self.ends().iter().all(kept)
        })
    }

    /// Whether the eye looks through it, and the hole has corners.
    fn has_cornered_hole(&self) -> bool {
        let scene = self.scene(Mat3::IDENTITY, None);
        let Ok(plan) = Plan::new(&scene, &Choices::default(), Accepts::AnyPolygon) else { return false };
        let lens = Lens { pixels_per_unit_tangent: plan.view.scale, hither: plan.view.hither, corner_cosine: 0.0 };
        let eye_from_local = plan.view.eye_from_world_affine() * scene.objects[0].parent_from_local;
        hole_sharpness(&self.shape, &eye_from_local, &lens) < 1.0
    }

    /// The discs at the ends of a cone.
    fn ends(&self) -> Vec<Posed> {
        let Shape::Cone { base, base_radius, apex, apex_radius } = self.shape else { return Vec::new() };
        let ends = [(base, base_radius), (apex, apex_radius)].into_iter().filter(|&(_, radius)| radius > 0.0);
        let disc = |(center, radius)| Shape::Cone { base: center, base_radius: radius, apex: center, apex_radius: 0.0 };
        ends.map(|end| Posed { shape: disc(end), turn: self.turn, place: self.place }).collect()
    }

    /// A turn of a sphere that puts the middle of a facet on its outline, where that is farthest from the middle of the picture or anywhere:
    /// there the polyhedron is flattest and the picture largest.
    fn facet_on_outline(&self, segments: u32, radius: f64, random: &mut Random) -> Mat3 {
        let half = PI / f64::from(segments);
        // An even number of bands has an edge along the equator.
        let latitude = if (segments / 2).is_multiple_of(2) { half } else { 0.0 };
        let middle = Vec3::new(cos(latitude) * cos(half), cos(latitude) * sin(half), sin(latitude));
        let toward_eye = unit(-self.place).unwrap_or(Vec3::Z);
        let outward = Vec3::new(self.place.x, self.place.y, 0.0);
        let any = rotation(random).x_axis;
        let aside = if random.once_in(4) { any } else { outward };
        let aside = unit(aside - toward_eye * aside.dot(toward_eye)).unwrap_or(any);
        // The plane of the facet passes through the eye.
        let sine = radius * cos(half) * cos(half) / self.place.length();
        let on_outline = aside * (1.0 - sine * sine).sqrt() + toward_eye * sine;
        // From a frame around the facet to one around the place on the outline, turned about it by chance.
        let frame = |axis: Vec3| {
            let across = unit(axis.cross(Vec3::new(0.3, 0.5, 0.8))).unwrap_or(Vec3::X);
            Mat3::from_cols(across, axis.cross(across), axis)
        };
        let world = frame(on_outline) * about_z(random.unit() * 2.0 * PI) * frame(middle).transpose();
        self.turn.transpose() * world
    }
}

/// What was found for one kind of shape at one tolerance.
#[derive(Default)]
struct Sum {
    shapes: u64,
    points: u64,
    worst: f64,
    beyond: u64,
    counted: u64,
    wasteful: u64,
    wasteful_few: u64,
    seen_through: u64,
    wasteful_through: u64,
}

impl Sum {
    fn add(&mut self, posed: &Posed, tolerance: f64, random: &mut Random, report: &mut Report) {
        let Some((found, polygons)) = posed.deviation(tolerance, Mat3::IDENTITY, None) else {
            report.miss(format!("{:?} cannot be judged", posed.shape));
            return;
        };
        self.shapes += 1;
        self.points += found.points;
        self.worst = self.worst.max(found.largest / tolerance);
        // The search meets an outline up to 1 % too late.
        if found.largest > tolerance * 1.01 + 1e-3 {
            self.beyond += 1;
            report.miss(format!("{:?} errs by {} pixels at tolerance {tolerance}", posed.shape, found.largest));
        }
        if matches!(posed.shape, Shape::Ellipsoid { .. }) {
            return;
        }
        let segments = posed.segments(polygons);
        let fewer = fewer(segments, matches!(posed.shape, Shape::Sphere { .. }));
        let seen_through = posed.has_cornered_hole();
        if segments >= COUNTED {
            self.counted += u64::from(!seen_through);
            self.seen_through += u64::from(seen_through);
        }
        if fewer >= 3 && posed.holds(fewer, tolerance, random) {
            if seen_through {
                self.wasteful_through += 1;
            } else if segments >= COUNTED {
                self.wasteful += 1;
                report.miss(format!("{:?}: {fewer} segments hold {tolerance}, too, not only {segments}", posed.shape));
            } else {
                self.wasteful_few += 1;
            }
        }
    }

    fn print(&self, of: &str, report: &mut Report) {
        report.count(of, self.shapes);
        report.some(format!("points of outlines, {of}"), self.points);
        report.measure(format!("largest error as a multiple of the tolerance, {of}"), self.worst);
        report.none(format!("outlines beyond the tolerance, {of}"), self.beyond);
        if self.counted > 0 {
            report.count(format!("shapes of {COUNTED} segments or more, {of}"), self.counted);
            report.none(format!("of them with more than {WASTE} times the fewest segments, {of}"), self.wasteful);
        }
        report.count(format!("wasteful ones of fewer segments, {of}"), self.wasteful_few);
        if self.seen_through > 0 {
            report.count(format!("seen through, with corners, {of}"), self.seen_through);
            report.count(format!("wasteful ones of these, {of}"), self.wasteful_through);
        }
    }
}

/// The largest number of segments that `segments` is more than [`WASTE`] times; even for spheres.
fn fewer(segments: u32, even: bool) -> u32 {
    let step = if even { 2 } else { 1 };
    let mut fewer = segments.saturating_sub(step);
    while fewer > 0 && f64::from(segments) <= WASTE * f64::from(fewer) {
        fewer = fewer.saturating_sub(step);
    }
    fewer
}

fn about_z(angle: f64) -> Mat3 {
    Mat3::from_cols(Vec3::new(cos(angle), sin(angle), 0.0), Vec3::new(-sin(angle), cos(angle), 0.0), Vec3::Z)
}

/// Any rotation.
fn rotation(random: &mut Random) -> Mat3 {
    let mut direction =
        || unit(Vec3::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0)));
    let axis = direction().unwrap_or(Vec3::Z);
    let across = direction().and_then(|other| unit(axis.cross(other))).unwrap_or(Vec3::X);
    let turned = Mat3::from_cols(across, axis.cross(across), axis);
    turned * about_z(random.unit() * 2.0 * PI)
}
