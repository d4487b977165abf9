//! Mistakes about channels and levels of the polygons alone, in any steps; and values that one sample decides for several.

use super::{Mutant, each_with, family, mutant};
use crate::grade::rules::{Block, Levels, Origin, PixelFrom, Rules};

const PAGE: &str = "docs/conventions.md";
const STEPPED: [&str; 4] =
    ["levels in other steps", "Levels are counted in other steps than 255.", "A level is round(255 c).", PAGE];
const OFF: [&str; 4] = [
    "levels off by some",
    "Every level is too low or too high by the same number.",
    "A level is round(255 c), and nothing is added to it.",
    PAGE,
];
const GAMMA: [&str; 4] = [
    "encoded for a display",
    "Levels are encoded with a gamma curve, which this sheet does not ask for (`encoding linear`).",
    "With linear encoding a level is round(255 light).",
    "docs/shading.md",
];
const SQUARED: [&str; 4] =
    ["light squared", "Light is decoded or multiplied once too often.", "A level is round(255 light).", PAGE];
const WRAPS: [&str; 4] =
    ["levels wrap around", "A level above 255 starts again at 0.", "A level is round(255 c): never above 255.", PAGE];
const CUT: [&str; 4] = [
    "levels cut off",
    "Light is turned into a level by cutting the fraction off (`int(255 * c)`).",
    "A level is round(255 light): add a half before cutting.",
    PAGE,
];
const UP: [&str; 4] =
    ["levels rounded up", "Levels are rounded up.", "A level is round(255 c): the nearest one.", PAGE];
const OF_256: [&str; 4] =
    ["levels of 256", "Levels are made by multiplying with 256.", "A level is round(255 light).", PAGE];
const EXCHANGED: [&str; 4] = [
    "channels exchanged",
    "Red, green and blue are written in another order.",
    "A pixel is red, green, blue, in that order.",
    PAGE,
];
const ONE: [&str; 4] =
    ["one channel for all", "All three channels show the same one.", "A pixel is red, green, blue.", PAGE];
const TWICE: [&str; 4] = [
    "a channel written twice",
    "One channel is written in the place of another.",
    "The order is red, green, blue.",
    PAGE,
];
const BLOCK: [&str; 4] = [
    "one value a block",
    "Values are evaluated once for a block of samples, and shown on all of it.",
    "Values are evaluated at the center of every sample.",
    PAGE,
];
const RUNNING: [&str; 4] = [
    "weighted samples",
    "The samples of a pixel do not count alike: those near its middle, or those that come last, count more.",
    "All A x A samples of a pixel count alike: add them up, and divide once.",
    PAGE,
];

/// All of them.
pub(super) fn all() -> Vec<Mutant> {
    [levels(), channels(), blocks(), pixels(), inexact(), counted()].concat()
}

/// For the whole picture, or for polygons alone.
fn levels() -> Vec<Mutant> {
    let steps = [3.0, 4.0, 7.0, 8.0, 15.0, 16.0, 31.0, 32.0, 63.0, 64.0, 99.0, 100.0, 127.0, 200.0, 1000.0];
    let known = [
        mutant(CUT, |rules| rules.levels = Levels::Down),
        mutant(UP, |rules| rules.levels = Levels::Up),
        mutant(OF_256, |rules| rules.levels = Levels::Times256),
        mutant(WRAPS, |rules| rules.levels = Levels::Wraps),
        mutant(GAMMA, |rules| rules.levels = Levels::Srgb),
        mutant(GAMMA, |rules| rules.levels = Levels::Gamma22),
        mutant(SQUARED, |rules| rules.levels = Levels::Squared),
    ];
    let all = [
        known.to_vec(),
        family(OFF, &[-1.0, 1.0, -2.0, 2.0], |rules, more| rules.levels = Levels::More(more)),
        family(OFF, &[-1.0, 1.0], |rules, more| rules.levels = Levels::MoreInByte(more)),
        family(STEPPED, &steps, |rules, steps| rules.levels = Levels::Of(steps)),
        family(STEPPED, &steps, |rules, steps| rules.levels = Levels::CutOf(steps)),
        family(STEPPED, &steps, |rules, steps| rules.levels = Levels::OfCut(steps)),
        family(STEPPED, &[100.0, 127.0, 128.0, 254.0, 256.0], |rules, steps| rules.levels = Levels::Scaled(steps)),
        family(GAMMA, &[0.5, 1.0 / 2.0, 1.0 / 1.8, 1.0 / 2.4], |rules, power| rules.levels = Levels::Power(power)),
        family(SQUARED, &[2.2, 1.8, 2.4], |rules, power| rules.levels = Levels::Power(power)),
    ]
    .concat();
    let of_faces: fn(&mut Rules) = |rules| {
        (rules.face_levels, rules.levels) = (Some(rules.levels), Levels::Round);
    };
    [all.clone(), each_with(&all, &[of_faces])].concat()
}

/// Every way to take three channels from three, for the whole picture and for polygons alone.
fn channels() -> Vec<Mutant> {
    let map = |number: usize| [number / 9, number / 3 % 3, number % 3];
    let words = |number: usize| {
        let [r, g, b] = map(number);
        match (r != g && g != b && r != b, r == g && g == b) {
            (true, _) => EXCHANGED,
            (_, true) => ONE,
            _ => TWICE,
        }
    };
    let of = |rules: &mut Rules, number: f64| {
        let number = number as usize;
        rules.channels = [number / 9, number / 3 % 3, number % 3];
    };
    let all: Vec<Mutant> = (0..27)
        .filter(|&number| map(number) != [0, 1, 2])
        .flat_map(|number| family(words(number), &[number as f64], of))
        .collect();
    let of_faces: fn(&mut Rules) = |rules| {
        (rules.face_channels, rules.channels) = (rules.channels, [0, 1, 2]);
    };
    [all.clone(), each_with(&all, &[of_faces])].concat()
}

/// One value a block, row or column of samples; and with it depth, or not.
fn blocks() -> Vec<Mutant> {
    let sizes = [2.0, 3.0, 4.0, 8.0, 16.0];
    let ways: [fn(&mut Rules, f64); 6] = [
        |rules, side| rules.block = valued((side as i32, side as i32), 0, false),
        |rules, side| rules.block = valued((side as i32, side as i32), 0, true),
        |rules, side| rules.block = valued((side as i32, side as i32), side as i32 / 2, false),
        |rules, side| rules.block = valued((side as i32, side as i32), side as i32 / 2, true),
        |rules, side| rules.block = valued((side as i32, 1), 0, false),
        |rules, side| rules.block = valued((side as i32, 1), 0, true),
    ];
    let all: Vec<Mutant> = ways.iter().flat_map(|change| family(BLOCK, &sizes, *change)).collect();
    let clamps: fn(&mut Rules) = |rules| rules.clamps = true;
    let depth: fn(&mut Rules) = |rules| (rules.clamps, rules.block.of_depth) = (true, true);
    [all.clone(), each_with(&all, &[clamps, depth])].concat()
}

const fn valued(size: (i32, i32), at: i32, from_bounds: bool) -> Block {
    Block { size, at: (at, if size.1 > 1 { at } else { 0 }), from_bounds, of_values: true, ..Block::ONE }
}

fn pixels() -> Vec<Mutant> {
    let running = [
        mutant(RUNNING, |rules| rules.pixel = PixelFrom::Running(true)),
        mutant(RUNNING, |rules| rules.pixel = PixelFrom::Running(false)),
    ];
    let of_one: fn(&mut Rules) = |rules| rules.pixel_of_one = true;
    let made: Vec<Mutant> = super::pixel::MUTANTS.iter().filter(|mutant| is_made(mutant)).copied().collect();
    [running.to_vec(), each_with(&made, &[of_one])].concat()
}

/// Whether levels are divided before they are added: with one sample a pixel they are cut all the same.
fn is_made(mutant: &Mutant) -> bool {
    let pixel = mutant.applied_to(&Rules::default()).pixel;
    matches!(pixel, PixelFrom::DividedFirst(_) | PixelFrom::DividedTwice(_))
}

/// Mistakes about values where what is the same at all corners stays so only where it is the same to the last digit.
fn inexact() -> Vec<Mutant> {
    let exact: fn(&mut Rules) = |rules| rules.spares_exact = true;
    let values: Vec<Mutant> = [super::value::MUTANTS, super::carried::MUTANTS].concat();
    let is_plain = |mutant: &&Mutant| !mutant.applied_to(&Rules::default()).spares_constants;
    let plain: Vec<Mutant> = values.iter().filter(is_plain).copied().collect();
    // A line for each channel, and a slip in one of them.
    let of_one: [fn(&mut Rules); 3] = [
        |rules| rules.value_channels = [true, false, false],
        |rules| rules.value_channels = [false, true, false],
        |rules| rules.value_channels = [false, false, true],
    ];
    [each_with(&plain, &[exact]), each_with(&plain, &of_one)].concat()
}

const COUNTED: [&str; 4] = [
    "x or y counted from elsewhere",
    "x or y is counted from the span, the polygon's bounds or a corner, where the plane is that of the whole picture.",
    "Planes are evaluated at (x + 0.5, y + 0.5) of the picture.",
    PAGE,
];

/// Planes of the picture at places that are counted from elsewhere.
fn counted() -> Vec<Mutant> {
    let of_values = [
        mutant(COUNTED, |rules| rules.origin = Origin::Span),
        mutant(COUNTED, |rules| rules.origin = Origin::Bounds),
        mutant(COUNTED, |rules| rules.origin = Origin::FirstCorner),
    ];
    let clamps: fn(&mut Rules) = |rules| rules.clamps = true;
    let both: fn(&mut Rules) = |rules| (rules.depth_origin, rules.clamps) = (rules.origin, true);
    let depth: fn(&mut Rules) =
        |rules| (rules.depth_origin, rules.origin, rules.clamps) = (rules.origin, Origin::Picture, true);
    each_with(&of_values, &[|_| (), clamps, both, depth])
}
