//! How far `scanline` drifts from `zbuffer`, and how fast it is: `cargo run --release --example scanline_drift [RUNS] [WIDTH...]`.
//!
//! Levels are of 255, display values. Drift is taken where both show the same polygon; where they show different ones, the
//! drift has turned a close decision. Depth is relative. Times are of the rasterizer alone, one thread: the two take turns
//! run by run, and the ratio of the medians is printed, because a machine's speed is not a property of the algorithm.

use farop::color::{Encoding, Rgb};
use farop::parse::{ParseOptions, read_nff};
use farop::plan::{Choices, Shading, Transparency};
use farop::raster::{Frame, Rasterizer, Scanline, ZBuffer};
use farop::render::list;
use farop::scene::Scene;
use farop::screen::DrawList;
use farop::spd::{self, Curves};
use std::time::Instant;

/// Scene, size, shading.
const SCENES: [(&str, u32, Shading); 5] = [
    ("gears", 2, Shading::Gouraud),
    ("teapot", 12, Shading::Gouraud),
    ("teapot", 12, Shading::Phong),
    ("mount", 4, Shading::Gouraud),
    ("tetra", 2, Shading::Gouraud),
];

fn scene(name: &str, size: u32) -> Scene {
    let mut text = Vec::new();
    spd::generate(spd::find(name).expect("a built-in scene"), size, Curves::Kept, &mut text).expect("memory takes it");
    read_nff(name, &text, ParseOptions::default()).expect("a legal scene").scene
}

/// Draws into `frame`, all rows at once, and returns the milliseconds.
fn draw(list: &DrawList, rasterizer: &dyn Rasterizer, frame: &mut Frame) -> f64 {
    let size = (list.width, list.height);
    let mut target = frame.target(size, 0..list.height, Rgb::gray(0.0), Transparency::Over);
    let start = Instant::now();
    rasterizer.draw(list, &mut target);
    let elapsed = start.elapsed().as_secs_f64() * 1e3;
    target.finish();
    elapsed
}

#[derive(Default)]
struct Drift {
    /// Samples with something on them.
    covered: u64,
    /// Of these, other bytes; another polygon.
    bytes_differ: u64,
    owners_differ: u64,
    /// Levels, where the polygon is the same.
    most_levels: f64,
    levels: f64,
    /// Relative depth, where the polygon is the same.
    most_depth: f64,
    depth: f64,
}

fn levels(light: Rgb<f32>) -> [f64; 3] {
    light.to_f64().to_array().map(|channel| Encoding::Srgb.encode(Rgb::gray(channel)).r * 255.0)
}

fn drift(list: &DrawList, expected: &Frame, actual: &Frame) -> Drift {
    let mut drift = Drift::default();
    for index in 0..list.width as usize * list.height as usize {
        let (owner, depth, light) = expected.sample(index);
        let (other_owner, other_depth, other_light) = actual.sample(index);
        assert_eq!(owner.is_some(), other_owner.is_some(), "coverage is the same");
        drift.covered += u64::from(owner.is_some());
        drift.owners_differ += u64::from(owner != other_owner);
        if light == other_light && depth == other_depth {
            continue;
        }
        let (here, there) = (levels(light), levels(other_light));
        drift.bytes_differ += u64::from((0..3).any(|channel| here[channel].round() != there[channel].round()));
        if owner.is_some() && owner == other_owner {
            let most = (0..3).map(|channel| (here[channel] - there[channel]).abs()).fold(0.0, f64::max);
            let relative = (depth - other_depth).abs() / depth;
            (drift.most_levels, drift.levels) = (drift.most_levels.max(most), drift.levels + most);
            (drift.most_depth, drift.depth) = (drift.most_depth.max(relative), drift.depth + relative);
        }
    }
    drift
}

fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

fn row(name: (&str, u32, Shading), width: u32, runs: usize) {
    let choices = Choices { size: Some((width, width)), shading: name.2, ..Choices::default() };
    let list = list(&scene(name.0, name.1), &choices, None).expect("a usable view");
    let (mut expected, mut actual) = (Frame::default(), Frame::default());
    let mut times = [Vec::new(), Vec::new()];
    for run in 0..=runs {
        let pair = [draw(&list, &ZBuffer, &mut expected), draw(&list, &Scanline, &mut actual)];
        // The first run warms up.
        (0..2).filter(|_| run > 0).for_each(|which| times[which].push(pair[which]));
    }
    let drift = drift(&list, &expected, &actual);
    let ratio = median(&mut times[1]) / median(&mut times[0]);
    let covered = drift.covered.max(1) as f64;
    let (bytes, owners) = (drift.bytes_differ as f64 / covered * 1e2, drift.owners_differ as f64 / covered * 1e6);
    let title = format!("{}:{} {}", name.0, name.1, name.2.name());
    println!(
        "| {title:<17} | {width:>5} | {:>10.4} | {:>11.6} | {:>9.1e} | {:>10.1e} | {bytes:>8.3} | {owners:>12.1} | {ratio:>5.2} |",
        drift.most_levels,
        drift.levels / covered,
        drift.most_depth,
        drift.depth / covered
    );
}

fn main() {
    let mut numbers = std::env::args().skip(1).filter_map(|text| text.parse::<u32>().ok());
    let runs = numbers.next().unwrap_or(7) as usize;
    let mut widths: Vec<u32> = numbers.collect();
    if widths.is_empty() {
        widths = vec![256, 1024, 4096];
    }
    println!(
        "| scene             | width | most level | mean levels | most depth | mean depth | bytes, % | owners, ppm | time |"
    );
    println!("|---|--:|--:|--:|--:|--:|--:|--:|--:|");
    for name in SCENES {
        for &width in &widths {
            row(name, width, runs);
        }
    }
}
