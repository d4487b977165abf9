//! What the oracles cost: `cargo run --release --example oracle_speed`.
//!
//! Traces and judges built-in scenes at 256 x 256 and prints times.

use farop::oracle::exact::{Rules, judge};
use farop::oracle::ray::trace;
use farop::parse::{ParseOptions, read_nff};
use farop::plan::Choices;
use farop::spd::{self, Curves};
use std::time::Instant;

fn main() {
    for (name, size) in
        [("teapot", 6), ("balls", 2), ("balls", 3), ("gears", 2), ("mount", 6), ("tree", 8), ("tetra", 6)]
    {
        let mut text = Vec::new();
        let scene = spd::find(name).expect("a built-in scene");
        spd::generate(scene, size, Curves::Kept, &mut text).expect("memory takes it");
        let scene = read_nff(name, &text, ParseOptions::default()).expect("it is NFF").scene;
        let choices = Choices { size: Some((256, 256)), ..Choices::default() };
        let start = Instant::now();
        let picture = trace(&scene, &choices).expect("it has a camera");
        let traced = start.elapsed();
        let list = farop::render::list(&scene, &choices, None).expect("it has a camera");
        let time = |rules: &Rules| {
            let start = Instant::now();
            let counts = judge(&list, rules).counts;
            (start.elapsed(), counts)
        };
        let [contract, truth, raw] = [Rules::CONTRACT, Rules::TRUE_DEPTH, Rules::UNSNAPPED].map(|rules| time(&rules));
        let hits = picture.hits.iter().flatten().count();
        println!(
            "{name}:{size}: ray {traced:.2?}, {hits} hits; {} polygons: exact {:.2?}, true depth {:.2?}, raw {:.2?}",
            list.len(),
            contract.0,
            truth.0,
            raw.0
        );
        println!("    {:?}", raw.1);
    }
}
