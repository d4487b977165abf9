//! The incremental rasterizer: exact coverage, bounded drift, the same bytes in any order and on any number of threads.

mod support;

use farop::color::{Encoding, Rgb};
use farop::lab::check::random_scenes::{choices, hard};
use farop::plan::{Choices, Culling, Shading, Transparency};
use farop::raster::{Frame, Rasterizer, Scanline, ZBuffer};
use farop::render::{list, render};
use farop::screen::DrawList;
use farop::spd::{Curves, SMALL};
use support::built_in::built_in;

fn frame(list: &DrawList, rasterizer: &dyn Rasterizer) -> Frame {
    let mut frame = Frame::default();
    let target = frame.target((list.width, list.height), 0..list.height, Rgb::gray(0.0), Transparency::Over);
    let mut target = target.with_threads(1);
    rasterizer.draw(list, &mut target);
    target.finish();
    frame
}

/// Owner and display levels of every sample.
fn samples(list: &DrawList, frame: &Frame) -> Vec<(Option<u32>, f64, [f64; 3])> {
    let sample = |index| {
        let (owner, depth, light) = frame.sample(index);
        let level = |channel: f32| Encoding::Srgb.encode(Rgb::gray(f64::from(channel))).r * 255.0;
        (owner, depth, light.to_array().map(level))
    };
    (0..list.width as usize * list.height as usize).map(sample).collect()
}

#[test]
fn every_polygon_covers_what_it_covers_for_the_z_buffer() {
    for seed in 1..=120 {
        let (scene, choices) = (hard(seed), choices(seed));
        let whole = list(&scene, &choices, None).expect("a usable view");
        for index in 0..whole.len() {
            let mut alone = whole.clone();
            alone.polygons = vec![whole.polygons[index]];
            alone.shader.surfaces.iter_mut().for_each(|surface| surface.opacity = Rgb::gray(1.0));
            let owners = |rasterizer: &dyn Rasterizer| -> Vec<_> {
                samples(&alone, &frame(&alone, rasterizer)).into_iter().map(|sample| sample.0).collect()
            };
            assert!(owners(&Scanline) == owners(&ZBuffer), "seed {seed}, polygon {index}");
        }
    }
}

/// Levels of 255 that a sample may be off where both show the same polygon.
const LEVELS: f64 = 0.05;
/// Relative depth that it may be off there.
const DEPTH: f64 = 2e-4;
/// Samples in a million that may show another polygon.
const OWNERS: f64 = 50.0;

#[test]
fn drift_is_bounded_on_all_built_in_scenes() {
    let mut differs = false;
    for (name, size) in SMALL {
        let scene = built_in(name, size, Curves::Kept);
        for shading in [Shading::Flat, Shading::Gouraud, Shading::Phong] {
            let choices = Choices { size: Some((200, 150)), shading, culling: Culling::None, ..Choices::default() };
            let list = list(&scene, &choices, None).expect("a usable view");
            let [expected, actual] =
                [samples(&list, &frame(&list, &ZBuffer)), samples(&list, &frame(&list, &Scanline))];
            let (mut owners, mut levels, mut depth): (u32, f64, f64) = (0, 0.0, 0.0);
            for (here, there) in expected.iter().zip(&actual) {
                assert_eq!(here.0.is_some(), there.0.is_some(), "{name}: coverage");
                differs |= here != there;
                if here.0 != there.0 {
                    owners += 1;
                } else if here.0.is_some() {
                    depth = depth.max((here.1 - there.1).abs() / here.1);
                    (0..3).for_each(|channel| levels = levels.max((here.2[channel] - there.2[channel]).abs()));
                }
            }
            let owners = f64::from(owners) / expected.len() as f64 * 1e6;
            let context = format!("{name} {}: {levels} levels, depth {depth}, {owners} ppm", shading.name());
            println!("{context}");
            assert!(levels <= LEVELS && depth <= DEPTH && owners <= OWNERS, "{context}");
        }
    }
    assert!(differs, "values are incremental: some last bits must differ");
}

#[test]
fn threads_draw_the_same_bytes() {
    for (name, size) in [("gears", 2), ("teapot", 4), ("mount", 4)] {
        let scene = built_in(name, size, Curves::Kept);
        let picture = |threads| {
            let choices = Choices { size: Some((97, 101)), threads: Some(threads), ..Choices::default() };
            render(&scene, &choices, Some(&Scanline)).expect("a usable view").image
        };
        let alone = picture(1);
        for threads in [2, 3, 7, 200] {
            assert!(picture(threads) == alone, "{name}, {threads} threads");
        }
    }
}
