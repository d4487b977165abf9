//! A picture of Watkins' spans: `cargo run --example watkins_spans SCENE OUT.png [SIDE] [ROW]`.
//!
//! Every sample has the color of what decided its span: gray where a segment was alone, blue where depth ranges told, green
//! where both ends told, red where the span was one sample wide. The first sample of every span is light, so that span ends
//! show as dots, which add up to the outlines of visible and hidden polygons. With ROW, that scan line is also printed.

use farop::image::{Picture, encode_for};
use farop::parse::{ParseOptions, load, read_nff};
use farop::plan::Choices;
use farop::raster::watkins::{Decision, spans};
use farop::render::list;
use farop::scene::Scene;
use farop::spd::{self, Curves};
use std::path::Path;

fn scene(name: &str) -> Scene {
    let Some(name) = name.strip_prefix("spd:") else {
        return load(Path::new(name), None, ParseOptions::default()).unwrap_or_else(|errors| panic!("{errors}")).scene;
    };
    let (name, size) = name.split_once(':').unwrap_or((name, "1"));
    let mut text = Vec::new();
    let scene = spd::find(name).expect("a built-in scene");
    spd::generate(scene, size.parse().expect("a size"), Curves::Kept, &mut text).expect("memory takes it");
    read_nff(name, &text, ParseOptions::default()).expect("a legal scene").scene
}

fn color(decision: Decision) -> [u8; 3] {
    match decision {
        Decision::Alone => [70, 70, 70],
        Decision::Range => [40, 70, 170],
        Decision::Ends => [30, 130, 50],
        Decision::Sample => [230, 40, 30],
    }
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [name, output, rest @ ..] = &arguments[..] else {
        eprintln!("usage: watkins_spans SCENE OUT.png [SIDE] [ROW]");
        std::process::exit(2);
    };
    let side: u32 = rest.first().and_then(|text| text.parse().ok()).unwrap_or(256);
    let chosen: Option<i32> = rest.get(1).and_then(|text| text.parse().ok());
    let choices = Choices { size: Some((side, side)), ..Choices::default() };
    let list = list(&scene(name), &choices, None).expect("a usable view");
    let mut picture = Picture::filled(list.width as usize, list.height as usize, [0; 3]);
    for row in 0..list.height as i32 {
        for span in spans(&list, row) {
            if chosen == Some(row) {
                println!(
                    "{:>4} to {:>4}  polygon {:<4} {:?}",
                    span.columns.start, span.columns.end, span.polygon, span.decision
                );
            }
            let dark = color(span.decision);
            for column in span.columns.clone() {
                let light = span.decision != Decision::Sample && column == span.columns.start;
                let shown = if light { dark.map(|channel| channel / 2 + 120) } else { dark };
                picture.set_pixel(column as usize, row as usize, shown);
            }
        }
    }
    let path = Path::new(output);
    std::fs::write(path, encode_for(path, &picture).expect("a .png or .ppm")).expect("a place to write to");
}
