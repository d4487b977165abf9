//! From a key to the picture, in the window's core, at 1024 x 768: `cargo run --release --example view_timings [ROUNDS]`.
//!
//! Prints; judges nothing. Cases take turns round by round; medians of wall clock and of processor time (all threads).
//! An idle machine needs at most the processor time, a busy one makes the clock run on. What a window adds is copying the
//! finished pixels to the display.

use farop::parse::{ParseOptions, built_in, read_nff};
use farop::plan::Choices;
use farop::raster::{Fast, Rasterizer, Watkins, ZBuffer};
use farop::report::{StageTime, StageTimer};
use farop::scene::Scene;
use farop::spd::Curves;
use farop::view::{Viewer, read_keys};

const SIZE: (u32, u32) = (1024, 768);
const TARGET: f64 = 33.0;

fn scene(name: &str) -> Scene {
    let text = built_in::text(name, Curves::Kept).expect("a built-in scene");
    read_nff(name, &text, ParseOptions::default()).expect("a legal scene").scene
}

/// The time from these keys to the picture.
fn time(viewer: &mut Viewer<'_>, keys: &str) -> StageTime {
    let events = read_keys(keys).expect("known keys");
    let timer = StageTimer::start();
    events.iter().for_each(|event| _ = viewer.handle(event));
    viewer.draw();
    timer.stop()
}

fn median(mut numbers: Vec<f64>) -> f64 {
    numbers.sort_by(f64::total_cmp);
    numbers[numbers.len() / 2]
}

fn main() {
    let rounds = std::env::args().nth(1).and_then(|text| text.parse().ok()).unwrap_or(15);
    let fast = Fast::default();
    let rasterizers: [(&str, &dyn Rasterizer); 3] = [("fast", &fast), ("zbuffer", &ZBuffer), ("watkins", &Watkins)];
    let cases = [("turn", "<right>"), ("shading", "s"), ("help", "h"), ("step 6", "6."), ("eye space", "2<right>")];
    let choices = Choices { size: Some(SIZE), ..Choices::default() };
    let mut viewers = Vec::new();
    for name in ["gears", "teapot"] {
        for (rasterizer, with) in rasterizers {
            for (case, keys) in cases.iter().filter(|case| rasterizer == "fast" || case.0 == "turn") {
                let viewer = Viewer::new(scene(name), &choices, vec![(rasterizer.to_string(), with)]);
                viewers.push(((name, rasterizer, *case, *keys), viewer.expect("a camera"), Vec::new()));
            }
        }
    }
    // The first round warms up.
    for round in 0..=rounds {
        for ((_, _, case, keys), viewer, times) in &mut viewers {
            // From Gouraud to flat and back.
            let keys = if *case == "shading" && round % 2 == 1 { "S" } else { *keys };
            let took = time(viewer, keys);
            times.extend((round > 0).then_some(took));
        }
    }
    println!("{}x{}, {rounds} rounds, medians; target {TARGET} ms", SIZE.0, SIZE.1);
    println!("scene    rasterizer  key          elapsed ms  processor ms");
    for ((name, rasterizer, case, _), _, times) in &viewers {
        let elapsed = median(times.iter().map(|time| time.elapsed).collect());
        let processor = median(times.iter().map(|time| time.user + time.system).collect());
        let verdict = if elapsed.min(processor) < TARGET { "" } else { "  over the target" };
        println!("{name:<8} {rasterizer:<11} {case:<12} {elapsed:>10.1} {processor:>13.1}{verdict}");
    }
}
