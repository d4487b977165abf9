//! Mistakes about the samples of a pixel: where they are, and how they become its light.

use super::{Mutant, mutant};
use crate::grade::rules::{Count, Part, PixelFrom, Rules, SampleAt};

const PAGE: &str = "docs/conventions.md";
const ONE: [&str; 4] = [
    "one sample a pixel",
    "Of a pixel's A x A samples only one is shown, or all of them are asked for at one place.",
    "A pixel is the mean of its A x A samples.",
    PAGE,
];
const SOME: [&str; 4] = [
    "some samples of a pixel",
    "Only some of a pixel's samples are averaged: a row, a column, a diagonal, a square.",
    "Both loops over the samples of a pixel go from 0 to A - 1.",
    PAGE,
];
const LOST: [&str; 4] = [
    "samples of a pixel lost",
    "Some of a pixel's samples (the first or last, a row or column) are not added, but are counted.",
    "Both loops over the samples of a pixel go from 0 to A - 1.",
    PAGE,
];
const SUM: [&str; 4] = [
    "samples divided by another number",
    "The sum of a pixel's samples is not divided by A x A.",
    "Divide the sum by the number of samples, A x A.",
    PAGE,
];
const COVERED: [&str; 4] = [
    "background left out of the mean",
    "Only the samples that a polygon covers are averaged: edges stay hard.",
    "Samples without a polygon count with the background's color.",
    PAGE,
];
const BLACK: [&str; 4] = [
    "background counted as black",
    "Samples without a polygon add nothing to the mean, whatever the background is.",
    "Samples without a polygon count with the background's color.",
    PAGE,
];
const THRESHOLD: [&str; 4] = [
    "half or nothing",
    "A pixel shows the polygon or what is behind it by how many samples are covered: there are no levels between.",
    "A pixel is the mean of its A x A samples.",
    PAGE,
];
const FIRST: [&str; 4] = [
    "one polygon a pixel",
    "A pixel shows the color of one polygon that covers a sample of it.",
    "A pixel is the mean of its A x A samples.",
    PAGE,
];
const MOST: [&str; 4] =
    ["brightest sample", "A pixel shows its brightest sample.", "A pixel is the mean of its A x A samples.", PAGE];
const LEAST: [&str; 4] =
    ["darkest sample", "A pixel shows its darkest sample.", "A pixel is the mean of its A x A samples.", PAGE];
const MEDIAN: [&str; 4] = [
    "median of samples",
    "A pixel shows the middle of its samples by brightness, or of the brightest and the darkest.",
    "A pixel is the mean of its A x A samples.",
    PAGE,
];
const POWERS: [&str; 4] = [
    "mean of encoded light",
    "Samples are squared, or encoded for a display, before they are averaged.",
    "Average light itself; levels are made of the mean.",
    PAGE,
];
const TENT: [&str; 4] = [
    "weighted samples",
    "The samples of a pixel do not count alike: those near its middle, or those that come last, count more.",
    "All A x A samples of a pixel count alike: add them up, and divide once.",
    PAGE,
];
const LEVELS: [&str; 4] = [
    "levels averaged",
    "Samples are cut to levels before they are averaged.",
    "Average light, and turn the mean into a level once.",
    PAGE,
];
const FIRST_DIVIDED: [&str; 4] = [
    "divided before adding",
    "Levels are divided by the number of samples before they are added, in whole numbers.",
    "Add light first, divide the sum once, and turn that into a level.",
    PAGE,
];
const BYTE: [&str; 4] = [
    "sum in a byte",
    "The sum of a pixel's samples is kept in a byte, and begins anew at 256.",
    "Add in a number that holds A x A times 255, or in light.",
    PAGE,
];
const ONE_WAY: [&str; 4] = [
    "samples in one direction only",
    "The samples of a pixel differ in x only, or in y only.",
    "The samples of a pixel are a grid of A x A that fills it, each asked for at its own center.",
    PAGE,
];
const SPREAD: [&str; 4] = [
    "samples spread over another area",
    "The samples of a pixel are spread over a part of it, or beyond it.",
    "The samples of a pixel are a grid of A x A that fills it, each asked for at its own center.",
    PAGE,
];
const DEPTH: [&str; 4] = [
    "one depth a pixel",
    "Depth is taken or kept once a pixel, not at every sample.",
    "Every sample has a depth of its own.",
    PAGE,
];
const MIXED: [&str; 4] = [
    "mixed polygon by polygon",
    "Each polygon is mixed into the pixel by the part it covers: what is behind shines through between neighbors.",
    "Keep all samples until the last polygon is drawn, then average.",
    PAGE,
];

pub(super) const MUTANTS: &[Mutant] = &[
    mutant(ONE, |rules| rules.pixel = PixelFrom::One(0, 0)),
    mutant(ONE, |rules| rules.pixel = PixelFrom::One(0, 1)),
    mutant(ONE, |rules| rules.pixel = PixelFrom::One(0, 2)),
    mutant(ONE, |rules| rules.pixel = PixelFrom::One(0, 3)),
    mutant(ONE, |rules| rules.pixel = PixelFrom::One(1, 0)),
    mutant(ONE, |rules| rules.pixel = PixelFrom::One(1, 1)),
    mutant(ONE, |rules| rules.pixel = PixelFrom::One(1, 2)),
    mutant(ONE, |rules| rules.pixel = PixelFrom::One(1, 3)),
    mutant(ONE, |rules| rules.pixel = PixelFrom::One(2, 0)),
    mutant(ONE, |rules| rules.pixel = PixelFrom::One(2, 1)),
    mutant(ONE, |rules| rules.pixel = PixelFrom::One(2, 2)),
    mutant(ONE, |rules| rules.pixel = PixelFrom::One(2, 3)),
    mutant(ONE, |rules| rules.pixel = PixelFrom::One(3, 0)),
    mutant(ONE, |rules| rules.pixel = PixelFrom::One(3, 1)),
    mutant(ONE, |rules| rules.pixel = PixelFrom::One(3, 2)),
    mutant(ONE, |rules| rules.pixel = PixelFrom::One(3, 3)),
    mutant(ONE, |rules| rules.sample_at = SampleAt::Block(0.5)),
    mutant(ONE, |rules| rules.sample_at = SampleAt::Block(0.0)),
    mutant(ONE, |rules| rules.sample_at = SampleAt::Block(1.0)),
    mutant(SOME, |rules| some(rules, Part::Row(0))),
    mutant(SOME, |rules| some(rules, Part::Row(1))),
    mutant(SOME, |rules| some(rules, Part::Row(2))),
    mutant(SOME, |rules| some(rules, Part::Row(3))),
    mutant(SOME, |rules| some(rules, Part::Column(0))),
    mutant(SOME, |rules| some(rules, Part::Column(1))),
    mutant(SOME, |rules| some(rules, Part::Column(2))),
    mutant(SOME, |rules| some(rules, Part::Column(3))),
    mutant(SOME, |rules| some(rules, Part::Diagonal)),
    mutant(SOME, |rules| some(rules, Part::OtherDiagonal)),
    mutant(SOME, |rules| some(rules, Part::Corners)),
    mutant(SOME, |rules| some(rules, Part::Ends)),
    mutant(SOME, |rules| some(rules, Part::Square(2))),
    mutant(SOME, |rules| some(rules, Part::Square(3))),
    mutant(SOME, |rules| some(rules, Part::Checkered)),
    mutant(SOME, |rules| some(rules, Part::FirstHalf)),
    mutant(SOME, |rules| some(rules, Part::Cross)),
    mutant(SOME, |rules| some(rules, Part::WithoutFirst)),
    mutant(SOME, |rules| some(rules, Part::WithoutLast)),
    mutant(SOME, |rules| some(rules, Part::WithoutFirstRow)),
    mutant(SOME, |rules| some(rules, Part::WithoutLastRow)),
    mutant(SOME, |rules| some(rules, Part::WithoutFirstColumn)),
    mutant(SOME, |rules| some(rules, Part::WithoutLastColumn)),
    mutant(SOME, |rules| some(rules, Part::WithoutLastBoth)),
    mutant(SOME, |rules| some(rules, Part::WithoutFirstBoth)),
    mutant(LOST, |rules| lost(rules, Part::WithoutFirst)),
    mutant(LOST, |rules| lost(rules, Part::WithoutLast)),
    mutant(LOST, |rules| lost(rules, Part::WithoutFirstRow)),
    mutant(LOST, |rules| lost(rules, Part::WithoutLastRow)),
    mutant(LOST, |rules| lost(rules, Part::WithoutFirstColumn)),
    mutant(LOST, |rules| lost(rules, Part::WithoutLastColumn)),
    mutant(LOST, |rules| lost(rules, Part::WithoutLastBoth)),
    mutant(LOST, |rules| lost(rules, Part::WithoutFirstBoth)),
    mutant(LOST, |rules| lost(rules, Part::Square(2))),
    mutant(SUM, |rules| rules.pixel = PixelFrom::Part(Part::Row(0), Count::All)),
    mutant(SUM, |rules| rules.pixel = PixelFrom::Part(Part::Column(0), Count::All)),
    mutant(SUM, |rules| rules.pixel = PixelFrom::Part(Part::Diagonal, Count::All)),
    mutant(SUM, |rules| rules.pixel = PixelFrom::Divided(Count::One)),
    mutant(SUM, |rules| rules.pixel = PixelFrom::Divided(Count::Side)),
    mutant(SUM, |rules| rules.pixel = PixelFrom::Divided(Count::SideMore(1.0))),
    mutant(SUM, |rules| rules.pixel = PixelFrom::Divided(Count::SideMore(-1.0))),
    mutant(SUM, |rules| rules.pixel = PixelFrom::Divided(Count::TwoSides)),
    mutant(SUM, |rules| rules.pixel = PixelFrom::Divided(Count::AllMore(1.0))),
    mutant(SUM, |rules| rules.pixel = PixelFrom::Divided(Count::AllMore(-1.0))),
    mutant(SUM, |rules| rules.pixel = PixelFrom::Divided(Count::NextSquare)),
    mutant(SUM, |rules| rules.pixel = PixelFrom::Divided(Count::Fixed(2.0))),
    mutant(SUM, |rules| rules.pixel = PixelFrom::Divided(Count::Fixed(3.0))),
    mutant(SUM, |rules| rules.pixel = PixelFrom::Divided(Count::Fixed(4.0))),
    mutant(SUM, |rules| rules.pixel = PixelFrom::Divided(Count::Fixed(8.0))),
    mutant(SUM, |rules| rules.pixel = PixelFrom::Divided(Count::Fixed(9.0))),
    mutant(SUM, |rules| rules.pixel = PixelFrom::Divided(Count::Fixed(16.0))),
    mutant(SUM, |rules| rules.pixel = PixelFrom::Divided(Count::Fixed(256.0))),
    mutant(SUM, |rules| rules.pixel = PixelFrom::Divided(Count::Fixed(255.0))),
    mutant(SUM, |rules| rules.pixel = PixelFrom::Divided(Count::Cube)),
    mutant(SUM, |rules| rules.pixel = PixelFrom::Divided(Count::Fourth)),
    mutant(SUM, |rules| rules.pixel = PixelFrom::Times(2.0)),
    mutant(SUM, |rules| rules.pixel = PixelFrom::Times(0.5)),
    mutant(COVERED, |rules| rules.pixel = PixelFrom::Covered),
    mutant(BLACK, |rules| rules.pixel = PixelFrom::CoveredOfAll),
    mutant(THRESHOLD, |rules| rules.pixel = PixelFrom::Threshold((0.5, true))),
    mutant(THRESHOLD, |rules| rules.pixel = PixelFrom::Threshold((0.5, false))),
    mutant(THRESHOLD, |rules| rules.pixel = PixelFrom::Threshold((0.25, true))),
    mutant(THRESHOLD, |rules| rules.pixel = PixelFrom::Threshold((0.75, true))),
    mutant(THRESHOLD, |rules| rules.pixel = PixelFrom::Threshold((1.0, true))),
    mutant(FIRST, |rules| rules.pixel = PixelFrom::FirstCovered),
    mutant(FIRST, |rules| rules.pixel = PixelFrom::LastCovered),
    mutant(MOST, |rules| rules.pixel = PixelFrom::Most),
    mutant(LEAST, |rules| rules.pixel = PixelFrom::Least),
    mutant(MEDIAN, |rules| rules.pixel = PixelFrom::Median(true)),
    mutant(MEDIAN, |rules| rules.pixel = PixelFrom::Median(false)),
    mutant(MEDIAN, |rules| rules.pixel = PixelFrom::Extremes),
    mutant(POWERS, |rules| rules.pixel = PixelFrom::MeanOfPowers(2.0)),
    mutant(POWERS, |rules| rules.pixel = PixelFrom::MeanOfPowers(0.5)),
    mutant(POWERS, |rules| rules.pixel = PixelFrom::MeanOfPowers(2.2)),
    mutant(POWERS, |rules| rules.pixel = PixelFrom::MeanOfPowers(1.0 / 2.2)),
    mutant(POWERS, |rules| rules.pixel = PixelFrom::Root(0.5)),
    mutant(POWERS, |rules| rules.pixel = PixelFrom::Root(2.0)),
    mutant(POWERS, |rules| rules.pixel = PixelFrom::Root(2.2)),
    mutant(POWERS, |rules| rules.pixel = PixelFrom::Root(1.0 / 2.2)),
    mutant(TENT, |rules| rules.pixel = PixelFrom::Tent),
    mutant(LEVELS, |rules| rules.pixel = PixelFrom::MeanOfLevels(0.0)),
    mutant(LEVELS, |rules| rules.pixel = PixelFrom::LevelsCut(0.0)),
    mutant(LEVELS, |rules| rules.pixel = PixelFrom::LevelsCut(0.5)),
    mutant(FIRST_DIVIDED, |rules| rules.pixel = PixelFrom::DividedFirst(0.0)),
    mutant(FIRST_DIVIDED, |rules| rules.pixel = PixelFrom::DividedFirst(0.5)),
    mutant(FIRST_DIVIDED, |rules| rules.pixel = PixelFrom::DividedTwice(0.0)),
    mutant(FIRST_DIVIDED, |rules| rules.pixel = PixelFrom::DividedTwice(0.5)),
    mutant(BYTE, |rules| rules.pixel = PixelFrom::SumInByte(0.0)),
    mutant(BYTE, |rules| rules.pixel = PixelFrom::SumInByte(0.5)),
    mutant(BYTE, |rules| rules.pixel = PixelFrom::SumInByteCut(0.0)),
    mutant(BYTE, |rules| rules.pixel = PixelFrom::SumInByteCut(0.5)),
    mutant(BYTE, |rules| rules.pixel = PixelFrom::SumWraps),
    mutant(BYTE, |rules| rules.pixel = PixelFrom::SignedByte),
    mutant(ONE_WAY, |rules| rules.sample_at = SampleAt::BlockX(0.5)),
    mutant(ONE_WAY, |rules| rules.sample_at = SampleAt::BlockX(0.0)),
    mutant(ONE_WAY, |rules| rules.sample_at = SampleAt::BlockX(1.0)),
    mutant(ONE_WAY, |rules| rules.sample_at = SampleAt::BlockY(0.5)),
    mutant(ONE_WAY, |rules| rules.sample_at = SampleAt::BlockY(0.0)),
    mutant(ONE_WAY, |rules| rules.sample_at = SampleAt::BlockY(1.0)),
    mutant(SPREAD, |rules| rules.sample_at = SampleAt::Spread(0.5)),
    mutant(SPREAD, |rules| rules.sample_at = SampleAt::Spread(2.0)),
    mutant(SPREAD, |rules| rules.sample_at = SampleAt::Spread(0.25)),
    mutant(SPREAD, |rules| rules.sample_at = SampleAt::Spread(0.75)),
    mutant(SPREAD, |rules| rules.sample_at = SampleAt::Spread(1.5)),
    mutant(SPREAD, |rules| rules.sample_at = SampleAt::SpreadX(0.5)),
    mutant(SPREAD, |rules| rules.sample_at = SampleAt::SpreadY(0.5)),
    mutant(SPREAD, |rules| rules.sample_at = SampleAt::SpreadX(2.0)),
    mutant(SPREAD, |rules| rules.sample_at = SampleAt::SpreadY(2.0)),
    mutant(SPREAD, |rules| rules.sample_at = SampleAt::FromCorner(0.5)),
    mutant(SPREAD, |rules| rules.sample_at = SampleAt::FromCorner(2.0)),
    mutant(DEPTH, |rules| rules.depth_at = SampleAt::Block(0.5)),
    mutant(DEPTH, |rules| rules.depth_at = SampleAt::Block(0.0)),
    mutant(DEPTH, |rules| rules.depth_at = SampleAt::Block(1.0)),
    mutant(MIXED, |rules| rules.pixel = PixelFrom::MixedByFace(true)),
    mutant(MIXED, |rules| rules.pixel = PixelFrom::MixedByFace(false)),
];

/// Only those samples are averaged.
fn some(rules: &mut Rules, part: Part) {
    rules.pixel = PixelFrom::Part(part, Count::Kept);
}

/// Only those samples are added, and all are counted.
fn lost(rules: &mut Rules, part: Part) {
    rules.pixel = PixelFrom::Part(part, Count::All);
}
