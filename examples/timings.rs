//! Stage times of three scenes, from text to PNG: `cargo run --release --example timings [RUNS]`.
//!
//! Prints; judges nothing. Scenes take turns run by run, so that a machine that slows down slows all of them; the median of
//! each stage is printed with the least and the most of the whole. Memory is the most the process has held.

use farop::image::encode_for;
use farop::parse::{ParseOptions, read_nff};
use farop::plan::Choices;
use farop::raster::ZBuffer;
use farop::render::render;
use farop::report::{StageTimer, peak_bytes};
use farop::spd::{self, Curves};
use std::path::Path;

/// Scene, size, side of the picture.
const SCENES: [(&str, u32, u32); 3] = [("gears", 4, 1024), ("mount", 8, 1024), ("tetra", 9, 1024)];
const STAGES: [&str; 5] = ["parse", "plan", "geometry", "raster", "png"];

fn text_of(name: &str, size: u32) -> Vec<u8> {
    let scene = spd::find(name).expect("a built-in scene");
    let mut text = Vec::new();
    spd::generate(scene, size, Curves::Kept, &mut text).expect("memory takes it");
    text
}

/// Milliseconds of every stage, and how many polygons were handed on.
fn run(text: &[u8], side: u32) -> ([f64; 5], u64) {
    let timer = StageTimer::start();
    let scene = read_nff("timings", text, ParseOptions::default()).expect("a legal scene").scene;
    let parse = timer.stop().elapsed;
    let choices = Choices { size: Some((side, side)), threads: Some(1), ..Choices::default() };
    let rendered = render(&scene, &choices, Some(&ZBuffer)).expect("a usable view");
    let timer = StageTimer::start();
    let png = encode_for(Path::new("timings.png"), &rendered.image.encode(choices.encoding)).expect("a picture");
    let write = timer.stop().elapsed;
    assert!(png.len() > 100);
    let times = rendered.times;
    let stages = [parse, times.plan.elapsed, times.geometry.elapsed, times.raster.elapsed, write];
    (stages, rendered.counts.rendered + rendered.counts.tessellated.rendered)
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

fn main() {
    let runs = std::env::args().nth(1).and_then(|text| text.parse().ok()).unwrap_or(7);
    let texts: Vec<_> = SCENES.iter().map(|&(name, size, _)| text_of(name, size)).collect();
    let mut times: Vec<Vec<[f64; 5]>> = vec![Vec::new(); SCENES.len()];
    let mut rendered = [0; SCENES.len()];
    for round in 0..=runs {
        for (index, &(_, _, side)) in SCENES.iter().enumerate() {
            let (stages, polygons) = run(&texts[index], side);
            rendered[index] = polygons;
            // The first round warms up.
            if round > 0 {
                times[index].push(stages);
            }
        }
    }
    println!("median of {runs} interleaved runs, one thread, zbuffer, Gouraud, milliseconds");
    println!(
        "{:<9} {:>8} {:>9} {}  {:>8} (least, most)",
        "scene",
        "text MB",
        "rendered",
        STAGES.map(|stage| format!("{stage:>9}")).join(""),
        "all"
    );
    for (index, (name, size, side)) in SCENES.iter().enumerate() {
        let stage = |stage: usize| median(times[index].iter().map(|run| run[stage]).collect());
        let mut all: Vec<f64> = times[index].iter().map(|run| run.iter().sum()).collect();
        all.sort_by(f64::total_cmp);
        let columns: String = (0..5).map(|number| format!("{:>9.1}", stage(number))).collect();
        let megabytes = texts[index].len() as f64 / 1e6;
        println!(
            "{name}:{size:<3} {megabytes:>8.1} {:>9} {columns}  {:>8.1} ({:.1}, {:.1})  at {side}x{side}",
            rendered[index],
            all[all.len() / 2],
            all[0],
            all[all.len() - 1]
        );
    }
    println!("peak memory of the process: {:.0} MB", peak_bytes() as f64 / 1e6);
}
