//! What splitting outlines of a million corners costs: `cargo run --release --example large_outlines [CORNERS] [RUNS]`.
//!
//! Prints, for each form, the least and the median seconds, and what splitting met. Prints only; judges nothing.
//! A comb turned by 45 degrees is the hardest: its long thin teeth lie along neither axis, so boxes around them overlap.

use farop::geometry::split::{SplitReport, SplitScratch, split};
use farop::math::{PI, Vec3, cos, sin};
use std::time::Instant;

fn main() {
    let mut numbers = std::env::args().skip(1).filter_map(|text| text.parse::<usize>().ok());
    let corners = numbers.next().unwrap_or(1_000_000).max(16);
    let runs = numbers.next().unwrap_or(5).max(1);
    let forms: [(&str, Vec<Vec3>); 5] = [
        ("convex", convex(corners)),
        ("star", star(corners)),
        ("comb", comb(corners)),
        ("comb45", turned(comb(corners))),
        ("spiral", spiral(corners)),
    ];
    println!(
        "{:<8}{:>10}{:>10}{:>10}{:>10}{:>8}{:>8}",
        "outline", "corners", "least s", "median s", "triangles", "forced", "flat"
    );
    for (name, outline) in forms {
        let mut scratch = SplitScratch::default();
        let (mut triangles, mut report) = (Vec::new(), SplitReport::default());
        let mut times: Vec<f64> = (0..runs)
            .map(|_| {
                triangles.clear();
                let start = Instant::now();
                report = split(&outline, Vec3::Z, &mut scratch, &mut triangles);
                start.elapsed().as_secs_f64()
            })
            .collect();
        times.sort_by(f64::total_cmp);
        println!(
            "{name:<8}{:>10}{:>10.3}{:>10.3}{:>10}{:>8}{:>8}",
            outline.len(),
            times[0],
            times[runs / 2],
            triangles.len(),
            report.forced,
            report.flat
        );
    }
}

fn at(x: f64, y: f64) -> Vec3 {
    Vec3::new(x, y, 1.0)
}

fn on_circle(index: usize, count: usize, radius: f64) -> Vec3 {
    let angle = index as f64 / count as f64 * 2.0 * PI;
    at(cos(angle) * radius, sin(angle) * radius)
}

fn convex(corners: usize) -> Vec<Vec3> {
    (0..corners).map(|index| on_circle(index, corners, 1000.0)).collect()
}

fn star(corners: usize) -> Vec<Vec3> {
    (0..corners).map(|index| on_circle(index, corners, if index % 2 == 0 { 1000.0 } else { 400.0 })).collect()
}

/// Teeth a thousandth of their height wide, in a row as long as they are high.
fn comb(corners: usize) -> Vec<Vec3> {
    let teeth = corners / 2 - 1;
    let width = 1000.0 / teeth as f64;
    let mut outline = vec![at(0.0, -10.0), at(1000.0, -10.0)];
    outline.extend((0..2 * teeth).map(|index| {
        let (x, is_tip) = (1000.0 - index as f64 / 2.0 * width, index % 2 == 1);
        at(x, if is_tip { 1000.0 } else { 0.0 })
    }));
    outline
}

fn turned(outline: Vec<Vec3>) -> Vec<Vec3> {
    let half = 0.5_f64.sqrt();
    outline.into_iter().map(|p| at((p.x - p.y) * half, (p.x + p.y) * half)).collect()
}

/// A corridor that winds in, and its other wall on the way out.
fn spiral(corners: usize) -> Vec<Vec3> {
    let steps = corners / 2;
    let wall = |step: usize, inset: f64| {
        let part = step as f64 / steps as f64;
        let (angle, radius) = (part * 100.0 * PI, 1000.0 * (1.0 - 0.9 * part) - inset);
        at(cos(angle) * radius, sin(angle) * radius)
    };
    // A turn takes 18; half of it is corridor.
    (0..steps).map(|step| wall(step, 0.0)).chain((0..steps).rev().map(|step| wall(step, 9.0))).collect()
}
