//! Watkins against the z-buffer, byte for byte: `cargo run --release --example watkins_agree [SCENES] [FOLDER]`.
//!
//! SCENES random scenes (10,000), every built-in scene, and every NFF file of FOLDER (`../shared/data/spd`; passed over
//! with a notice when it is not there). What was hard in the random scenes is counted from their draw lists, sample by
//! sample, by code that no rasterizer uses. Exit code 1 when one byte differs.

#[path = "../tests/support/mod.rs"]
mod support;

use farop::lab::check::random_scenes::{choices, hard};
use farop::parse::{Format, ParseOptions, load};
use farop::plan::{Choices, Culling, DepthFormat, Shading};
use farop::raster::{Watkins, ZBuffer};
use farop::render::{list, render};
use farop::scene::Scene;
use farop::spd::{Curves, SMALL};
use std::path::Path;
use support::built_in::built_in;
use support::census::{Census, census};

/// Whether both draw the same bytes.
fn agree(name: &str, scene: &Scene, choices: &Choices) -> bool {
    let expected = render(scene, choices, Some(&ZBuffer)).expect("a usable view").image;
    let actual = render(scene, choices, Some(&Watkins)).expect("a usable view").image;
    if expected != actual {
        println!("DIFFERENT: {name}, {choices:?}");
    }
    expected == actual
}

/// What was found in the random scenes.
#[derive(Default)]
struct Found {
    scenes: u64,
    wrong: u64,
    crowded: u64,
    piercing: u64,
    tied: u64,
    cut: u64,
    transparent: u64,
    cut_polygons: u64,
    total: Census,
}

impl Found {
    fn add(&mut self, seed: u64) {
        let (scene, choices) = (hard(seed), choices(seed));
        self.scenes += 1;
        self.wrong += u64::from(!agree(&format!("seed {seed}"), &scene, &choices));
        let rendered = render(&scene, &choices, None).expect("a usable view");
        let cut = rendered.counts.cut + rendered.counts.clipped;
        let here = census(&list(&scene, &choices, None).expect("a usable view"));
        self.crowded += u64::from(here.crowded_samples > 0);
        self.piercing += u64::from(here.piercing_pairs > 0);
        self.tied += u64::from(here.exact_ties > 0);
        self.transparent += u64::from(here.transparent_samples > 0);
        self.cut += u64::from(cut > 0);
        self.cut_polygons += cut;
        self.total += here;
    }

    fn print(&self) {
        let total = &self.total;
        println!("random scenes: {}, of which {} differ", self.scenes, self.wrong);
        println!("                                    scenes      in all");
        let row = |what: &str, scenes: u64, all: u64| println!("  {what:<30} {scenes:>9} {all:>11}");
        row("pixels with 2 or more polygons", self.crowded, total.crowded_samples);
        row("pairs that pierce each other", self.piercing, total.piercing_pairs);
        row("exact ties in front", self.tied, total.exact_ties);
        row("cut or clipped polygons", self.cut, self.cut_polygons);
        row("transparent pixels", self.transparent, total.transparent_samples);
        println!("  of {} screen polygons {} concave,", total.polygons, total.concave);
        println!("  {} pairs share an edge", total.touching_pairs);
    }
}

/// A scene in all shadings, with all depth formats, with back faces and without; how many pictures differ.
fn compare_all(name: &str, mut scene: Scene, side: u32) -> (u64, u64) {
    let (mut pictures, mut wrong) = (0, 0);
    // Integer depth needs a farthest plane.
    if let Some(camera) = &mut scene.camera {
        camera.yon = Some(camera.from.distance(camera.at) * 20.0);
    }
    for shading in [Shading::Flat, Shading::Gouraud, Shading::Phong] {
        for (&depth, culling) in
            DepthFormat::ALL.iter().zip([Culling::Back, Culling::None, Culling::Back, Culling::Nff])
        {
            let subpixel_bits = if depth == DepthFormat::Int16 { 0 } else { 8 };
            let size = Some((side, side));
            let choices = Choices { size, shading, depth, culling, subpixel_bits, ..Choices::default() };
            pictures += 1;
            wrong += u64::from(!agree(name, &scene, &choices));
        }
    }
    (pictures, wrong)
}

fn main() {
    let scenes = std::env::args().nth(1).and_then(|text| text.parse().ok()).unwrap_or(10_000);
    let folder = std::env::args().nth(2).unwrap_or_else(|| "../shared/data/spd".to_string());
    let mut found = Found::default();
    (1..=scenes).for_each(|seed| found.add(seed));
    found.print();
    let mut wrong = found.wrong;
    let mut compared = (0, 0);
    for (name, size) in SMALL {
        let (pictures, different) = compare_all(name, built_in(name, size, Curves::Kept), 200);
        compared = (compared.0 + pictures, compared.1 + different);
    }
    println!("built-in scenes: {}, pictures {}, of which {} differ", SMALL.len(), compared.0, compared.1);
    wrong += compared.1;
    let Ok(entries) = std::fs::read_dir(&folder) else {
        println!("notice: there is no folder {folder}; its files were not compared");
        std::process::exit(i32::from(wrong > 0));
    };
    let mut files: Vec<_> = entries.flatten().map(|entry| entry.path()).filter(|path| is_scene(path)).collect();
    files.sort();
    compared = (0, 0);
    for path in &files {
        let scene = load(path, None, ParseOptions::default()).unwrap_or_else(|errors| panic!("{errors}")).scene;
        let (pictures, different) = compare_all(&path.display().to_string(), scene, 200);
        compared = (compared.0 + pictures, compared.1 + different);
    }
    println!("files of {folder}: {}, pictures {}, of which {} differ", files.len(), compared.0, compared.1);
    std::process::exit(i32::from(wrong + compared.1 > 0));
}

fn is_scene(path: &Path) -> bool {
    Format::of_path(path).is_some()
}
