//! What `--subpixel-bits exact` costs against 8 bits: `cargo run --release --example exact_speed [RUNS] [SIDE]`.
//!
//! Three scenes take turns run by run, each with both, so that a machine that slows down slows all; the first round warms up. Printed
//! are medians in milliseconds and the ratio exact / 8 bits: of the way from text to picture (read, plan, geometry, raster, encoding),
//! and of the rasterizer alone. One thread, z-buffer, Gouraud. Prints; judges nothing.

use farop::parse::{ParseOptions, read_nff};
use farop::plan::{Choices, EXACT_SUBPIXELS};
use farop::raster::ZBuffer;
use farop::render::render;
use farop::spd::{self, Curves};
use std::time::Instant;

const SCENES: [(&str, u32); 3] = [("gears", 4), ("mount", 6), ("teapot", 20)];
const BITS: [u32; 2] = [8, EXACT_SUBPIXELS];

/// Milliseconds from text to picture, and of the rasterizer; how many pixels are other bytes than `expected`.
fn run(text: &[u8], side: u32, subpixel_bits: u32, expected: &mut Vec<u8>) -> ([f64; 2], usize) {
    let choices = Choices { size: Some((side, side)), subpixel_bits, threads: Some(1), ..Choices::default() };
    let start = Instant::now();
    let scene = read_nff("exact_speed", text, ParseOptions::default()).expect("a legal scene").scene;
    let rendered = render(&scene, &choices, Some(&ZBuffer)).expect("a usable view");
    let picture = rendered.image.encode(choices.encoding);
    let whole = start.elapsed().as_secs_f64() * 1e3;
    let raster = rendered.times.raster.elapsed;
    let differing = if expected.is_empty() {
        expected.extend(picture.rgb());
        0
    } else {
        picture.rgb().chunks(3).zip(expected.chunks(3)).filter(|(a, b)| a != b).count()
    };
    ([whole, raster], differing)
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

fn main() {
    let mut numbers = std::env::args().skip(1).filter_map(|text| text.parse::<u32>().ok());
    let (runs, side) = (numbers.next().unwrap_or(11), numbers.next().unwrap_or(512));
    let text_of = |&(name, size): &(&str, u32)| {
        let mut text = Vec::new();
        spd::generate(spd::find(name).expect("a built-in scene"), size, Curves::Kept, &mut text)
            .expect("memory takes it");
        text
    };
    let texts: Vec<Vec<u8>> = SCENES.iter().map(text_of).collect();
    let mut times = vec![[Vec::new(), Vec::new()]; SCENES.len()];
    let mut differing = [0; SCENES.len()];
    for round in 0..=runs {
        for (index, text) in texts.iter().enumerate() {
            let mut picture = Vec::new();
            for turn in 0..2 {
                // Who goes first changes from round to round.
                let which = (turn + round as usize) % 2;
                let (found, pixels) = run(text, side, BITS[which], &mut picture);
                differing[index] = differing[index].max(pixels);
                if round > 0 {
                    times[index][which].push(found);
                }
            }
        }
    }
    println!("median of {runs} interleaved runs at {side} x {side}, milliseconds; pixels that differ between the two");
    println!(
        "{:<10}{:>11}{:>11}{:>8}{:>12}{:>12}{:>8}{:>9}",
        "scene", "picture 8", "exact", "ratio", "raster 8", "exact", "ratio", "pixels"
    );
    for (index, (name, size)) in SCENES.iter().enumerate() {
        let of = |which: usize, part: usize| median(times[index][which].iter().map(|found| found[part]).collect());
        let [[whole, raster], [exact_whole, exact_raster]] = [0, 1].map(|which| [of(which, 0), of(which, 1)]);
        println!(
            "{:<10}{whole:>11.2}{exact_whole:>11.2}{:>8.2}{raster:>12.2}{exact_raster:>12.2}{:>8.2}{:>9}",
            format!("{name}:{size}"),
            exact_whole / whole,
            exact_raster / raster,
            differing[index]
        );
    }
}
