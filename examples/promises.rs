//! Are promises kept? `cargo run --release --example promises [LEVELS]...` (24 unless said otherwise)
//!
//! Built-in scenes at sizes and from places that were not looked at while the search was made, and all of `scenes/`. Each
//! promise is judged anew at every pixel of the picture, by rays: a grid of 5 x 5, and 256 of a Hammersley set where those
//! differ. The search has other rays, and looks at half of the pixels of the larger pictures.

use farop::color::{Encoding, Rgb};
use farop::lab::errors::pixel_errors;
use farop::lab::promise::{Goal, Promise, PromiseError, describe, keep};
use farop::lab::truth::{Source, Truth, levels};
use farop::oracle::ray::Tracer;
use farop::parse::{ParseOptions, read_nff};
use farop::plan::Choices;
use farop::raster::ZBuffer;
use farop::render::render;
use farop::scene::Scene;
use farop::spd::{self, Curves};
use std::path::Path;

/// Steps of the grid of rays that finds out whether anything happens in a pixel: from border to border, because a level edge
/// close to the border is missed by a whole row of rays in the middles.
const GRID: u32 = 4;
/// Rays a pixel, where something does. Not a grid: of a level edge that takes a whole row of rays or leaves it, a grid of
/// 12 x 12 knows the area to 1/24 only, which is six levels of a bright edge.
const RAYS: u32 = 256;
/// Name, size, how far the eye has moved towards what it looks at.
const BUILT_IN: [(&str, u32, f64); 13] = [
    ("balls", 3, 0.15),
    ("gears", 2, 0.1),
    ("jacks", 2, 0.2),
    ("lattice", 2, 0.2),
    ("mount", 5, 0.3),
    ("nurbtst", 1, 0.2),
    ("rings", 2, 0.1),
    ("sample", 1, 0.1),
    ("shells", 3, 0.2),
    ("sombrero", 2, 0.1),
    ("teapot", 4, 0.2),
    ("tetra", 5, 0.2),
    ("tree", 4, 0.1),
];

fn scenes() -> Vec<(String, Scene)> {
    let mut all = Vec::new();
    for (name, size, nearer) in BUILT_IN {
        let mut text = Vec::new();
        let made = spd::find(name).map(|scene| spd::generate(scene, size, Curves::Kept, &mut text));
        let Some(Ok(_)) = made else { continue };
        let mut scene = read_nff(name, &text, ParseOptions::default()).expect("a legal scene").scene;
        if let Some(camera) = &mut scene.camera {
            camera.from = camera.from + (camera.at - camera.from) * nearer;
        }
        all.push((format!("{name}:{size}"), scene));
    }
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes");
    let mut files: Vec<_> = std::fs::read_dir(folder).expect("a folder").flatten().map(|entry| entry.path()).collect();
    files.sort();
    for path in files.iter().filter(|path| path.extension().is_some_and(|ending| ending == "nff")) {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let text = std::fs::read(path).expect("a file");
        if let Ok(parsed) = read_nff(&name, &text, ParseOptions::default()) {
            all.push((name, parsed.scene));
        }
    }
    all
}

/// The mean light over `rays` of a pixel, and whether all of them meet the same and are a level apart at most.
fn mean(
    tracer: &Tracer<'_>,
    encoding: Encoding,
    (x, y): (u32, u32),
    rays: impl Iterator<Item = (f64, f64)>,
) -> (Rgb, bool) {
    let (mut sum, mut count, mut first, mut even) = (Rgb::BLACK, 0.0, None, true);
    for (right, down) in rays {
        let (light, hit) = tracer.light(f64::from(x) + right, f64::from(y) + down);
        let seen = (levels(encoding, light), hit.map(|hit| (hit.instance, hit.surface, hit.part)));
        let (level, met) = *first.get_or_insert(seen);
        even &= met == seen.1 && (0..3).all(|axis| (level[axis] - seen.0[axis]).abs() <= 0.5);
        sum += light;
        count += 1.0;
    }
    (sum * (1.0 / count), even)
}

/// The crossings of a grid, those on the pixel's border, too.
fn grid() -> impl Iterator<Item = (f64, f64)> {
    let at = |step: u32| f64::from(step) / f64::from(GRID);
    (0..(GRID + 1) * (GRID + 1)).map(move |ray| (at(ray % (GRID + 1)), at(ray / (GRID + 1))))
}

/// Hammersley's points: i/n beside the binary digits of i in reverse.
fn hammersley() -> impl Iterator<Item = (f64, f64)> {
    let half = 0.5 / f64::from(RAYS);
    (0..RAYS).map(move |ray| {
        (f64::from(ray) / f64::from(RAYS) + half, f64::from(ray.reverse_bits()) / 4_294_967_296.0 + half)
    })
}

/// The mean light of every pixel.
fn truth(scene: &Scene, choices: &Choices) -> Truth {
    let choices = Choices { samples: 1, ..choices.clone() };
    let tracer = Tracer::new(scene, &choices).expect("shapes with equations");
    let (width, height) = tracer.size();
    let row = |y: u32| -> Vec<Rgb> {
        let pixel = |x: u32| {
            let (light, even) = mean(&tracer, choices.encoding, (x, y), grid());
            if even { light } else { mean(&tracer, choices.encoding, (x, y), hammersley()).0 }
        };
        (0..width).map(pixel).collect()
    };
    let (row, half) = (&row, height / 2);
    let light = std::thread::scope(|scope| {
        let upper = scope.spawn(move || (0..half).flat_map(row).collect::<Vec<_>>());
        let lower: Vec<Rgb> = (half..height).flat_map(row).collect();
        [upper.join().expect("rays do not panic"), lower].concat()
    });
    let (pixels, uneven) = ((0..width * height).collect(), vec![false; light.len()]);
    Truth { size: (width, height), pixels, light, uneven, source: Source::Rays }
}

/// How many pixels of the promised picture err by more than `levels`.
fn broken(scene: &Scene, promise: &Promise, levels: f64) -> usize {
    let image = render(scene, &promise.choices, Some(&ZBuffer)).expect("it was drawn before").image;
    let truth = truth(scene, &promise.choices);
    let errors = pixel_errors(&truth, &image, promise.choices.encoding);
    errors.filter(|error| error.iter().any(|&channel| channel > levels)).count()
}

fn main() {
    let mut goals: Vec<f64> = std::env::args().skip(1).filter_map(|text| text.parse().ok()).collect();
    if goals.is_empty() {
        goals.push(24.0);
    }
    let scenes = scenes();
    for levels in goals {
        let (mut kept, mut missed, mut refused) = (0, Vec::new(), Vec::new());
        println!("at most one pixel in a thousand errs by more than {levels} levels");
        for (index, (name, scene)) in scenes.iter().enumerate() {
            // Half of them small enough to be judged whole, half not.
            let size = if index % 2 == 0 { (110, 84) } else { (264, 250) };
            let base = Choices { size: Some(size), ..Choices::default() };
            match keep(scene, &base, &ZBuffer, Goal::Levels(levels)) {
                Ok(promise) => {
                    let (wrong, pixels) = (broken(scene, &promise, levels), size.0 as usize * size.1 as usize);
                    let holds = wrong * 1000 <= pixels;
                    if holds {
                        kept += 1
                    } else {
                        missed.push(name.as_str())
                    }
                    let verdict = if holds { "kept  " } else { "MISSED" };
                    let (tries, seconds) = (promise.attempts.len(), promise.seconds);
                    println!(
                        "{verdict} {name:<20} {wrong:>4} of {pixels} pixels, {tries} tries, {seconds:>5.1} s: {}",
                        describe(&promise.choices)
                    );
                }
                Err(error @ PromiseError::Impossible { .. }) => {
                    let text = error.to_string();
                    println!("refused {name:<19} {}", text.lines().next().unwrap_or_default());
                    refused.push(name.as_str());
                }
                Err(error) => println!("no      {name:<20} {error}"),
            }
        }
        let made = kept + missed.len();
        let share = 100.0 * f64::from(kept as u32) / (made.max(1) as f64);
        println!("{kept} of {made} promises kept ({share:.1} %); missed: {missed:?}; refused: {refused:?}\n");
    }
}
