//! Aa: A x A samples a pixel against the exact area, and the exact area against another way to find it.
//!
//! half planes at all angles, snapped -> averaged picture of the z-buffer -> share of each pixel; [`crate::oracle::area`] -> the true share
//!
//! What is judged is the picture, not the samples: weights that are not all the same show, too. The same half planes then go the whole
//! way from a scene, slanted in space, at numbers of samples that are no powers of two as well: there the share is known from
//! where the scene puts the edge, so samples that stand in other places than they should show.
//!
//! The error of an edge at a random angle falls as A to the power of -1.5: A rows err independently by a part of a sample each, and
//! sqrt(A) of A equal errors remain. On an edge along an axis all rows err alike: 1 / (A sqrt 12), the spread of a number rounded to A steps.
//!
//! Space: pixels of A x A samples, the middle one of three by three and those around it.
//! Source: the law was measured before (`docs/accuracy.md`); its two parts are the central limit theorem and a uniform distribution.
//! Cost: A^2 a picture.

use super::random_scenes::{camera, facets, scene, surface};
use super::report::Value;
use super::{Effort, Random, Report};
use crate::color::{Encoding, Rgb};
use crate::image::Image;
use crate::math::{PI, Vec3, cos, log, sin};
use crate::oracle::Vertices;
use crate::oracle::area::{outline, share};
use crate::plan::{Choices, Culling, Shading, Transparency};
use crate::raster::ZBuffer;
use crate::render::{self, Canvas, render};
use crate::scene::{Camera, Material, Scene};
use crate::screen::{DrawList, Grid};

/// Samples across that are tried.
const SAMPLES: [u32; 7] = [1, 2, 4, 8, 16, 32, 64];
/// Samples across that are tried on the way from a scene.
const SCENE_SAMPLES: [u32; 6] = [1, 2, 3, 4, 5, 8];

/// Fits the two laws.
pub(super) fn run(effort: &Effort, report: &mut Report) {
    let angles = effort.count(600, 8_000).max(40);
    let mut points = Vec::new();
    let mut partial = 0;
    for samples in SAMPLES {
        let slanted = errors(effort, angles, samples, Edges::Slanted);
        let straight = errors(effort, angles.min(2000), samples, Edges::Axis);
        report.measure(format!("rms of slanted edges, A = {samples}"), slanted.rms());
        let law = 1.0 / (f64::from(samples) * 12.0_f64.sqrt());
        report.within(
            format!("rms of axis edges, A = {samples}, as a multiple of 1 / (A sqrt 12)"),
            straight.rms() / law,
            (0.99, 1.01),
        );
        let half = 0.5 / f64::from(samples);
        let largest = slanted.largest.max(straight.largest) / half;
        report.at_most(
            format!("largest error, A = {samples}, as a multiple of 1 / (2 A)"),
            Value::Measure(largest),
            Value::Measure(1.0 + 1e-9),
        );
        partial += slanted.count;
        points.push((log(f64::from(samples)), log(slanted.rms())));
    }
    report.some("pixels that an edge passes through", partial);
    report.within("exponent of the error of slanted edges", slope(&points), (-1.52, -1.48));
    scenes(effort, report);
    areas(effort, report);
}

#[derive(Clone, Copy, PartialEq)]
enum Edges {
    Slanted,
    Axis,
}

/// Sums of errors.
#[derive(Default)]
struct Errors {
    squares: f64,
    count: u64,
    largest: f64,
}

impl Errors {
    fn rms(&self) -> f64 {
        (self.squares / self.count.max(1) as f64).sqrt()
    }
}

/// Edges in equal steps of angle (the mean is carried by the few near the axes and near simple fractions) or of offset.
fn errors(effort: &Effort, count: u64, samples: u32, edges: Edges) -> Errors {
    // The same edges for every A: the fit compares like with like.
    let mut random = effort.random(edges as u64 + 1);
    let mut errors = Errors::default();
    for step in 0..count {
        let part = (step as f64 + random.unit()) / count as f64;
        let (angle, offset) = match edges {
            Edges::Slanted => (part * 2.0 * PI, random.between(-0.5, 0.5)),
            Edges::Axis => ((step % 4) as f64 * PI / 2.0, part - 0.5),
        };
        let list = half_plane((angle, edges), offset, samples);
        let canvas = Canvas { samples, background: Rgb::gray(0.0), transparency: Transparency::Over, threads: 1 };
        let (drawn, _) = render::draw(&list, Some(&ZBuffer), &canvas);
        let outline = outline(&list.polygon(0), Vertices::Snapped, f64::from(samples));
        errors.add(&drawn, 1.0, &outline);
    }
    errors
}

impl Errors {
    /// Adds the errors of the pixels of `drawn`, where `white` is the light of a full one, that `outline` covers in part.
    fn add(&mut self, drawn: &Image, white: f64, outline: &[(f64, f64)]) {
        for pixel in 0..9_u32 {
            let exact = share(outline, (f64::from(pixel % 3), f64::from(pixel / 3))).area;
            if exact > 0.0 && exact < 1.0 {
                let light = drawn.pixel((pixel % 3) as usize, (pixel / 3) as usize);
                let error = f64::from(light.g) / white - exact;
                self.squares += error * error;
                self.count += 1;
                self.largest = self.largest.max(error.abs());
            }
        }
    }
}

/// Half planes of scenes, on the finest grid: a corner moves by 2^-17 of a sample at most, the share by little more.
fn scenes(effort: &Effort, report: &mut Report) {
    let count = effort.count(400, 8_000).max(40);
    for samples in SCENE_SAMPLES {
        let mut random = effort.random(11);
        let mut errors = Errors::default();
        for step in 0..count {
            let angle = (step as f64 + random.unit()) / count as f64 * 2.0 * PI;
            let edges = if step % 8 == 0 { Edges::Axis } else { Edges::Slanted };
            let corners = corners((angle, edges), random.between(-0.5, 0.5));
            // Distances whose inverse is linear on the screen: that is a plane.
            let slant = [0; 2].map(|_| random.between(-0.03, 0.03));
            let full = drawn(&[(-8.0, -8.0), (11.0, -8.0), (11.0, 11.0), (-8.0, 11.0)], slant, samples);
            let (Some(full), Some(image)) = (full, drawn(&corners, slant, samples)) else {
                return report.miss("a half plane cannot be drawn");
            };
            errors.add(&image, f64::from(full.pixel(1, 1).g), &corners);
        }
        report.some(format!("pixels that an edge of a scene passes through, A = {samples}"), errors.count);
        report.at_most(
            format!("largest error in pictures of scenes, A = {samples}, as a multiple of 1 / (2 A)"),
            Value::Measure(errors.largest * 2.0 * f64::from(samples)),
            Value::Measure(1.0 + 1e-4),
        );
    }
}

/// A polygon whose corners are at these pixels of a picture of three by three, white under ambient light.
fn drawn(corners: &[(f64, f64)], [across, down]: [f64; 2], samples: u32) -> Option<Image> {
    let in_space = |&(x, y): &(f64, f64)| {
        let w = 2.0 / (1.0 + across * (x - 1.5) + down * (y - 1.5));
        Vec3::new((x / 1.5 - 1.0) * w, (1.0 - y / 1.5) * w, w)
    };
    let material = Material { ambient: Some(1.0), ..Material::default() };
    let mesh = facets(&[corners.iter().map(in_space).collect()]);
    let camera = Camera { hither: 1e-3, ..camera(3, 3) };
    let scene = Scene { lights: Vec::new(), ..scene(camera, vec![surface(material, mesh)]) };
    let choices = Choices {
        samples,
        shading: Shading::Flat,
        culling: Culling::None,
        encoding: Encoding::Linear,
        subpixel_bits: 16,
        threads: Some(1),
        ..Choices::default()
    };
    Some(render(&scene, &choices, Some(&ZBuffer)).ok()?.image)
}

/// What lies on one side of a line past the middle pixel, in a picture of three by three pixels.
fn half_plane(line: (f64, Edges), offset: f64, samples: u32) -> DrawList {
    let mut list = DrawList::new(3 * samples, 3 * samples);
    list.grid = Grid { bits: 16 };
    let in_samples = |(x, y): (f64, f64)| (x * f64::from(samples), y * f64::from(samples));
    list.push_flat(&corners(line, offset).map(in_samples), 1.0, [1.0; 3]);
    list
}

/// Its corners, in pixels.
fn corners((angle, edges): (f64, Edges), offset: f64) -> [(f64, f64); 4] {
    // An edge along an axis is exactly that: no rounding of a sine may tilt it.
    let exact = |value: f64| if edges == Edges::Axis { value.round() } else { value };
    let (c, s) = (exact(cos(angle)), exact(sin(angle)));
    let at = |along: f64, across: f64| (1.5 + c * along - s * across, 1.5 + s * along + c * across);
    [at(-9.0, offset), at(9.0, offset), at(9.0, 9.0), at(-9.0, 9.0)]
}

/// The slope of the line of least squares.
fn slope(points: &[(f64, f64)]) -> f64 {
    let mean = |f: fn(&(f64, f64)) -> f64| points.iter().map(f).sum::<f64>() / points.len() as f64;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let run: f64 = points.iter().map(|p| (p.0 - x) * (p.0 - x)).sum();
    points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum::<f64>() / run
}

/// Shares of random triangles by integration, against the area of the triangle cut to the pixel.
fn areas(effort: &Effort, report: &mut Report) {
    let mut random = effort.random(9);
    let (mut largest, mut bound, mut partial) = (0.0_f64, 0.0_f64, 0);
    for _ in 0..effort.count(20_000, 3_000_000) {
        let triangle = corner_triple(&mut random);
        let found = share(&triangle, (0.0, 0.0));
        let expected = cut_area(&triangle);
        largest = largest.max((found.area - expected).abs());
        bound = bound.max(found.error);
        partial += u64::from(expected > 0.0 && expected < 1.0);
    }
    report.some("pixels with a part of a triangle", partial);
    report.at_most("largest error of the exact area", Value::Measure(largest), Value::Measure(1e-12));
    report.at_most("largest error that it claims for itself", Value::Measure(bound), Value::Measure(1e-12));
}

fn corner_triple(random: &mut Random) -> [(f64, f64); 3] {
    let reach = [0.5, 2.0, 8.0][random.below(3) as usize];
    [0; 3].map(|_| (random.between(-reach, reach) + 0.5, random.between(-reach, reach) + 0.5))
}

/// The area of a triangle within the unit square: cut by its four sides, then the shoelace formula.
fn cut_area(triangle: &[(f64, f64)]) -> f64 {
    let mut corners = triangle.to_vec();
    let sides: [fn((f64, f64)) -> f64; 4] = [|p| p.0, |p| 1.0 - p.0, |p| p.1, |p| 1.0 - p.1];
    for inside in sides {
        let mut kept = Vec::new();
        for (at, &b) in corners.iter().enumerate() {
            let a = corners[(at + corners.len() - 1) % corners.len()];
            let (from, to) = (inside(a), inside(b));
            if (from < 0.0) != (to < 0.0) {
                let part = from / (from - to);
                kept.push((a.0 + part * (b.0 - a.0), a.1 + part * (b.1 - a.1)));
            }
            if to >= 0.0 {
                kept.push(b);
            }
        }
        corners = kept;
    }
    let doubled: f64 = crate::math::edges(&corners).map(|(a, b)| a.0 * b.1 - a.1 * b.0).sum();
    doubled.abs() / 2.0
}
