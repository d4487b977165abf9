//! Color: interpolated colors against the plane through the corners, in space.
//!
//! lit triangles, cut ones too -> DrawList -> level of every sample; corners before snapping -> weights -> reference
//!
//! The reference is the definition: a point of the picture is a ray, the ray meets the triangle in space, the weights of the corners there are
//! ratios of determinants of (x w, y w, w) and (px, py, 1). Nothing of `screen::plane` is used; the determinants are taken relative to the sample
//! and are good to some 1e-12. A level is 1/255 of linear light: an exact value, rounded once, is off by half a level.
//!
//! Space: samples. Cost: one sample costs a microsecond; of wide pictures a part of the samples is asked.

use super::random_scenes::{camera, scene, surface, world};
use super::report::Value;
use super::{Effort, Random, Report};
use crate::color::{Encoding, Rgb};
use crate::math::{Vec3, pow, unit};
use crate::oracle::Vertices;
use crate::oracle::exact::covers;
use crate::plan::{Choices, Culling};
use crate::render::list;
use crate::scene::{Camera, Light, LightSource, Material, Mesh, NormalSource, Place, Scene};
use crate::screen::{DrawList, ScreenPolygon};

/// Levels that a color may be off: half a level is rounding.
const LIMIT: f64 = 0.5005;
/// Smaller polygons, in samples, are reported apart.
const SMALL: f64 = 16.0;

/// Triangles of every size, slant and light.
pub(super) fn run(effort: &Effort, report: &mut Report) {
    let mut sums = [Sum::default(), Sum::default()];
    let mut hard = Hardness::default();
    for (size, pictures) in [
        ((64, 64), effort.count(150, 20_000).max(10)),
        ((1024, 64), effort.count(20, 2000).max(2)),
        ((65_535, 4), effort.count(8, 400)),
    ] {
        let mut random = effort.random(u64::from(size.0));
        let mut longest = 0;
        for _ in 0..pictures {
            let (scene, ratio) = slanted(&mut random, size);
            let choices = Choices { encoding: Encoding::Linear, culling: Culling::None, ..Choices::default() };
            match list(&scene, &choices, None) {
                Ok(list) => longest = longest.max(judge(&list, &mut random, &mut sums, &mut hard)),
                Err(error) => report.miss(error.to_string()),
            }
            hard.steep += u64::from(ratio > 10.0);
        }
        report.count(format!("longest span in pictures {} wide", size.0), longest);
    }
    let [large, small] = &sums;
    report.some("levels compared", large.samples + small.samples);
    report.some("triangles whose corners differ more than 10 times in distance", hard.steep);
    report.some("cut polygons", hard.cut);
    report.some("samples on a snapped outline only, left out", hard.outside);
    report.some("references within 0.001 of a half level", hard.disputes);
    let largest = |name: &str, sum: &Sum, report: &mut Report| {
        report.at_most(format!("largest error, {name}"), Value::Measure(sum.level), Value::Measure(LIMIT));
        report.measure(format!("largest error before rounding, {name}"), sum.light * 255.0);
    };
    largest("polygons of 16 samples or more", large, report);
    report.measure("largest error, smaller polygons", small.level);
    report.measure("largest error before rounding, smaller polygons", small.light * 255.0);
    report.count("levels of smaller polygons beyond 0.5005", small.beyond);
    report.count("levels of smaller polygons", small.samples);
}

#[derive(Default)]
struct Hardness {
    steep: u64,
    cut: u64,
    outside: u64,
    disputes: u64,
}

#[derive(Default)]
struct Sum {
    samples: u64,
    /// Largest difference between the rounded level and the reference in levels.
    level: f64,
    /// Largest difference before rounding, light.
    light: f64,
    beyond: u64,
}

/// A few triangles at random slants with normals of their own, and how many times the farthest corner of one is farther than its nearest.
fn slanted(random: &mut Random, size: (u32, u32)) -> (Scene, f64) {
    let mut mesh = Mesh::default();
    let (across, down) = (f64::from(size.0) / f64::from(size.1), 1.0);
    let mut steepest = 1.0_f64;
    for _ in 0..3 {
        let reach = pow(10.0, random.between(0.0, 2.0));
        let scale = if random.once_in(4) { 0.2 } else { 1.1 };
        let (cx, cy) = (random.between(-0.3, 0.3) * across, random.between(-0.3, 0.3) * down);
        let mut distances = (f64::MAX, 0.0_f64);
        let corners = [(-1.0, -1.0), (1.0, -0.8), (0.1, 1.0)].map(|(x, y)| {
            let w = 2.0 * pow(reach, random.unit());
            distances = (distances.0.min(w), distances.1.max(w));
            let shake = random.between(0.8, 1.0) * scale;
            let eye = Vec3::new((cx + x * across * shake) * w, (cy + y * down * shake) * w, w);
            let normal = Vec3::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0), 0.6);
            mesh.push_vertex_with_normal(world(eye), unit(normal).unwrap_or(Vec3::Z))
        });
        steepest = steepest.max(distances.1 / distances.0);
        mesh.push_polygon(&corners, NormalSource::Given, 1);
    }
    let material = Material { color: Rgb::new(1.0, 0.7, 0.3), diffuse: 1.0, ambient: Some(0.0), ..Material::default() };
    let view = Camera { hither: 1.0, ..camera(size.0, size.1) };
    let mut scene = scene(view, vec![surface(material, mesh)]);
    // One light from far away at full strength: levels from 0 to 255.
    let source = LightSource::Directional { to_light: Vec3::new(0.6, 0.5, 0.7) };
    scene.lights = vec![Light { source, color: Rgb::WHITE, intensity: Some(1.0), place: Place::default() }];
    (scene, steepest)
}

/// Compares samples of every polygon; the longest span that was asked.
fn judge(list: &DrawList, random: &mut Random, sums: &mut [Sum; 2], hard: &mut Hardness) -> u64 {
    let mut longest = 0;
    for polygon in list.polygons() {
        let bounds = |axis: fn(&crate::screen::ScreenVertex) -> f64| {
            polygon.vertices().iter().map(axis).fold((f64::MAX, f64::MIN), |(l, h), at| (l.min(at), h.max(at)))
        };
        let (columns, rows) = (bounds(|v| v.x), bounds(|v| v.y));
        let span = columns.1 - columns.0;
        longest = longest.max(span as u64);
        hard.cut += u64::from(polygon.vertices().len() > 3);
        let small = span.min(rows.1 - rows.0) < SMALL && span.max(rows.1 - rows.0) < 4.0 * SMALL;
        for _ in 0..1500 {
            let place = |(low, high): (f64, f64)| random.between(low, high).floor() as i32;
            let mut place = place;
            let sample = (place(columns), place(rows));
            if covers(&polygon, Vertices::Snapped, sample) == Some(true) {
                compare(list, &polygon, sample, (&mut sums[usize::from(small)], hard));
            }
        }
    }
    longest
}

/// Three channels of one sample.
fn compare(list: &DrawList, polygon: &ScreenPolygon<'_>, (x, y): (i32, i32), (sum, hard): (&mut Sum, &mut Hardness)) {
    if covers(polygon, Vertices::Raw, (x, y)) != Some(true) {
        hard.outside += 1;
        return;
    }
    let Some((corners, weights)) = weights(polygon, (f64::from(x) + 0.5, f64::from(y) + 0.5)) else { return };
    let drawn = list.shader.fragment(polygon, x, y).color.to_array();
    for (channel, &light) in drawn.iter().enumerate() {
        let values = corners.map(|corner| polygon.vertex_values(corner)[channel]);
        let reference: f64 = values.iter().zip(weights).map(|(value, weight)| value * weight).sum();
        let exact = (reference * 255.0).clamp(0.0, 255.0);
        let error = (f64::from(Encoding::Linear.level(light)) - exact).abs();
        sum.samples += 1;
        sum.level = sum.level.max(error);
        sum.beyond += u64::from(error > LIMIT);
        sum.light = sum.light.max((f64::from(light) - reference).abs());
        hard.disputes += u64::from((exact.fract() - 0.5).abs() < 1e-3);
    }
}

/// Three corners of the polygon that span much, and their weights, in space, where the ray through (px, py) meets its plane.
fn weights(polygon: &ScreenPolygon<'_>, (px, py): (f64, f64)) -> Option<([usize; 3], [f64; 3])> {
    let vertices = polygon.vertices();
    // Relative to the sample: (x w - px w, y w - py w), so that nothing large cancels in the determinants.
    let moved = |corner: usize| {
        let h = vertices[corner].homogeneous;
        (h.x - px * h.z, h.y - py * h.z)
    };
    let cross = |a: (f64, f64), b: (f64, f64)| a.0 * b.1 - a.1 * b.0;
    let area = |&(i, j, k): &(usize, usize, usize)| {
        let at = |corner: usize| vertices[corner].homogeneous / vertices[corner].homogeneous.z;
        (at(j) - at(i)).cross(at(k) - at(i)).length_squared()
    };
    let count = vertices.len();
    let triples = (0..count).flat_map(|i| (i + 1..count).flat_map(move |j| (j + 1..count).map(move |k| (i, j, k))));
    let (i, j, k) = triples.max_by(|a, b| area(a).total_cmp(&area(b)))?;
    let [a, b, c] = [i, j, k].map(moved);
    let parts = [cross(b, c), cross(c, a), cross(a, b)];
    let whole: f64 = parts.iter().sum();
    (whole != 0.0).then(|| ([i, j, k], parts.map(|part| part / whole)))
}
