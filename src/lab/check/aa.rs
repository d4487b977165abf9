//! Aa: A x A samples a pixel against the exact area, and the exact area against another way to find it.
//!
//! half planes at all angles, snapped -> samples of the z-buffer -> share of each pixel; [`crate::oracle::area`] -> the true share
//!
//! The error of an edge at a random angle falls as A to the power of -1.5: A rows err independently by a part of a sample each, and
//! sqrt(A) of A equal errors remain. On an edge along an axis all rows err alike: 1 / (A sqrt 12), the spread of a number rounded to A steps.
//!
//! Space: pixels of A x A samples, the middle one of three by three and those around it.
//! Source: the law was measured before (`docs/accuracy-2.md`); its two parts are the central limit theorem and a uniform distribution.
//! Cost: A^2 a picture.

use super::agree::owners;
use super::report::Value;
use super::{Effort, Random, Report};
use crate::math::{PI, cos, log, sin};
use crate::oracle::Vertices;
use crate::oracle::area::{outline, share};
use crate::raster::ZBuffer;
use crate::screen::{DrawList, Grid};

/// Samples across that are tried.
const SAMPLES: [u32; 7] = [1, 2, 4, 8, 16, 32, 64];

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
        let drawn = owners(&list, &ZBuffer);
        let outline = outline(&list.polygon(0), Vertices::Snapped, f64::from(samples));
        for pixel in 0..9_u32 {
            let exact = share(&outline, (f64::from(pixel % 3), f64::from(pixel / 3))).area;
            if exact > 0.0 && exact < 1.0 {
                let error = counted(&drawn, samples, pixel) - exact;
                errors.squares += error * error;
                errors.count += 1;
                errors.largest = errors.largest.max(error.abs());
            }
        }
    }
    errors
}

/// The share of a pixel's samples that are covered.
fn counted(drawn: &[Option<u32>], samples: u32, pixel: u32) -> f64 {
    let (left, top) = (pixel % 3 * samples, pixel / 3 * samples);
    let row = |y: u32| {
        let start = (y * 3 * samples + left) as usize;
        drawn[start..start + samples as usize].iter().flatten().count()
    };
    let covered: usize = (top..top + samples).map(row).sum();
    covered as f64 / f64::from(samples * samples)
}

/// What lies on one side of a line past the middle pixel, in a picture of three by three pixels.
fn half_plane((angle, edges): (f64, Edges), offset: f64, samples: u32) -> DrawList {
    // An edge along an axis is exactly that: no rounding of a sine may tilt it.
    let exact = |value: f64| if edges == Edges::Axis { value.round() } else { value };
    let (c, s) = (exact(cos(angle)), exact(sin(angle)));
    let at = |along: f64, across: f64| {
        let (x, y) = (1.5 + c * along - s * across, 1.5 + s * along + c * across);
        (x * f64::from(samples), y * f64::from(samples))
    };
    let mut list = DrawList::new(3 * samples, 3 * samples);
    list.grid = Grid { bits: 16 };
    list.push_flat(&[at(-9.0, offset), at(9.0, offset), at(9.0, 9.0), at(-9.0, 9.0)], 1.0, [1.0; 3]);
    list
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
