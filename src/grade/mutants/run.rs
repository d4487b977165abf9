//! Mistakes about values that go along edges first and then along scan lines.

use super::{Mutant, mutant};
use crate::grade::rules::{DepthFrom, Interpolation, Rules};
use crate::grade::runs::{EdgeShare, RowShare, RunRule};

const SCANLINE: &str = "docs/scanline.md";
const EDGE_ROW: [&str; 4] = [
    "edge values beside the row's center",
    "Values along edges are taken at the upper or lower side of a row, not on the line through its centers.",
    "Along an edge the share is (y + 0.5 - top) / (bottom - top), with y + 0.5 the line through the row's centers.",
    SCANLINE,
];
const EDGE_TURNED: [&str; 4] = [
    "edge values from the wrong end",
    "The share along an edge is measured from its other end.",
    "Along an edge the share is (y + 0.5 - top) / (bottom - top), with y + 0.5 the line through the row's centers.",
    SCANLINE,
];
const EDGE_WHOLE: [&str; 4] = [
    "edge share made whole",
    "The share along an edge is a whole number (a division of integers), so an edge has the value of one end.",
    "Along an edge the share is (y + 0.5 - top) / (bottom - top), with y + 0.5 the line through the row's centers.",
    SCANLINE,
];
const EDGE_LENGTH: [&str; 4] = [
    "edge height off by one",
    "The share along an edge is of a height in whole rows, or of one that is a row too large or too small.",
    "Along an edge the share is (y + 0.5 - top) / (bottom - top), with y + 0.5 the line through the row's centers.",
    SCANLINE,
];
const EDGE_AFFINE: [&str; 4] = [
    "affine along edges",
    "Along edges values are interpolated linearly on the screen, along rows in space.",
    "Interpolate value / w and 1/w along edges and along rows, and divide at every sample.",
    SCANLINE,
];
const ROW_SAMPLES: [&str; 4] = [
    "span values put on its samples",
    "The values of a span's ends are given to its first (and last) sample, though the ends lie between centers.",
    "Along a row the share is (x + 0.5 - left) / (right - left), with x + 0.5 the center and both ends where the edges are.",
    SCANLINE,
];
const ROW_CORNER: [&str; 4] = [
    "values beside the center",
    "Values along a span are taken at the left or right side of a sample, not at its center.",
    "Along a row the share is (x + 0.5 - left) / (right - left), with x + 0.5 the center and both ends where the edges are.",
    SCANLINE,
];
const ROW_TURNED: [&str; 4] = [
    "span values from the wrong end",
    "The share along a span is measured from its right end.",
    "Along a row the share is (x + 0.5 - left) / (right - left), with x + 0.5 the center and both ends where the edges are.",
    SCANLINE,
];
const ROW_FIXED: [&str; 4] = [
    "one value a span",
    "A whole span shows the value of one of its ends, or of its middle.",
    "Along a row the share is (x + 0.5 - left) / (right - left), with x + 0.5 the center and both ends where the edges are.",
    SCANLINE,
];
const ROW_LENGTH: [&str; 4] = [
    "span width off by one",
    "The share along a span is of a width that is a column too large or too small.",
    "Along a row the share is (x + 0.5 - left) / (right - left), with x + 0.5 the center and both ends where the edges are.",
    SCANLINE,
];
const ROW_AFFINE: [&str; 4] = [
    "affine along spans",
    "Along rows values are interpolated linearly on the screen, along edges in space.",
    "Interpolate value / w and 1/w along edges and along rows, and divide at every sample.",
    SCANLINE,
];

/// A way along edges and rows for values only: depth and 1/w are right.
fn with_own_depth(rules: &mut Rules, rule: RunRule) {
    rules.values = Interpolation::Runs(RunRule { own_depth: true, ..rule });
}

/// The same way for values and 1/w, by which they are divided; depth is right.
fn for_values(rules: &mut Rules, rule: RunRule) {
    rules.values = Interpolation::Runs(rule);
}

/// The same way for values and for depth.
fn for_all(rules: &mut Rules, rule: RunRule) {
    (rules.values, rules.depth) = (Interpolation::Runs(rule), DepthFrom::Runs(rule));
}

const fn edge(edge: EdgeShare) -> RunRule {
    RunRule { edge, ..RunRule::RIGHT }
}

const fn row(row: RowShare) -> RunRule {
    RunRule { row, ..RunRule::RIGHT }
}

/// With values that are linear on the screen along rows, or along both.
const fn on_the_screen(rule: RunRule) -> RunRule {
    RunRule { affine_edges: true, affine_rows: true, ..rule }
}

pub(super) const MUTANTS: &[Mutant] = &[
    mutant(EDGE_ROW, |rules| for_values(rules, edge(EdgeShare::Row(0.0)))),
    mutant(EDGE_ROW, |rules| for_all(rules, edge(EdgeShare::Row(0.0)))),
    mutant(EDGE_ROW, |rules| with_own_depth(rules, edge(EdgeShare::Row(0.0)))),
    mutant(EDGE_ROW, |rules| for_values(rules, on_the_screen(edge(EdgeShare::Row(0.0))))),
    mutant(EDGE_ROW, |rules| for_values(rules, edge(EdgeShare::RowUnlimited(0.0)))),
    mutant(EDGE_ROW, |rules| for_all(rules, edge(EdgeShare::RowUnlimited(0.0)))),
    mutant(EDGE_ROW, |rules| with_own_depth(rules, edge(EdgeShare::RowUnlimited(0.0)))),
    mutant(EDGE_ROW, |rules| for_values(rules, on_the_screen(edge(EdgeShare::RowUnlimited(0.0))))),
    mutant(EDGE_ROW, |rules| for_values(rules, edge(EdgeShare::Row(1.0)))),
    mutant(EDGE_ROW, |rules| for_all(rules, edge(EdgeShare::Row(1.0)))),
    mutant(EDGE_ROW, |rules| with_own_depth(rules, edge(EdgeShare::Row(1.0)))),
    mutant(EDGE_ROW, |rules| for_values(rules, on_the_screen(edge(EdgeShare::Row(1.0))))),
    mutant(EDGE_ROW, |rules| for_values(rules, edge(EdgeShare::RowUnlimited(1.0)))),
    mutant(EDGE_ROW, |rules| for_all(rules, edge(EdgeShare::RowUnlimited(1.0)))),
    mutant(EDGE_ROW, |rules| with_own_depth(rules, edge(EdgeShare::RowUnlimited(1.0)))),
    mutant(EDGE_ROW, |rules| for_values(rules, on_the_screen(edge(EdgeShare::RowUnlimited(1.0))))),
    mutant(EDGE_TURNED, |rules| for_values(rules, edge(EdgeShare::Turned))),
    mutant(EDGE_TURNED, |rules| for_all(rules, edge(EdgeShare::Turned))),
    mutant(EDGE_TURNED, |rules| with_own_depth(rules, edge(EdgeShare::Turned))),
    mutant(EDGE_TURNED, |rules| for_values(rules, on_the_screen(edge(EdgeShare::Turned)))),
    mutant(EDGE_WHOLE, |rules| for_values(rules, edge(EdgeShare::Fixed(0.0)))),
    mutant(EDGE_WHOLE, |rules| for_all(rules, edge(EdgeShare::Fixed(0.0)))),
    mutant(EDGE_WHOLE, |rules| with_own_depth(rules, edge(EdgeShare::Fixed(0.0)))),
    mutant(EDGE_WHOLE, |rules| for_values(rules, on_the_screen(edge(EdgeShare::Fixed(0.0))))),
    mutant(EDGE_WHOLE, |rules| for_values(rules, edge(EdgeShare::Fixed(1.0)))),
    mutant(EDGE_WHOLE, |rules| for_all(rules, edge(EdgeShare::Fixed(1.0)))),
    mutant(EDGE_WHOLE, |rules| with_own_depth(rules, edge(EdgeShare::Fixed(1.0)))),
    mutant(EDGE_WHOLE, |rules| for_values(rules, on_the_screen(edge(EdgeShare::Fixed(1.0))))),
    mutant(EDGE_WHOLE, |rules| for_values(rules, edge(EdgeShare::Fixed(0.5)))),
    mutant(EDGE_WHOLE, |rules| for_all(rules, edge(EdgeShare::Fixed(0.5)))),
    mutant(EDGE_WHOLE, |rules| with_own_depth(rules, edge(EdgeShare::Fixed(0.5)))),
    mutant(EDGE_WHOLE, |rules| for_values(rules, on_the_screen(edge(EdgeShare::Fixed(0.5))))),
    mutant(EDGE_WHOLE, |rules| for_values(rules, edge(EdgeShare::Rounded))),
    mutant(EDGE_WHOLE, |rules| for_all(rules, edge(EdgeShare::Rounded))),
    mutant(EDGE_WHOLE, |rules| with_own_depth(rules, edge(EdgeShare::Rounded))),
    mutant(EDGE_WHOLE, |rules| for_values(rules, on_the_screen(edge(EdgeShare::Rounded)))),
    mutant(EDGE_LENGTH, |rules| for_values(rules, edge(EdgeShare::Whole(0.0)))),
    mutant(EDGE_LENGTH, |rules| for_all(rules, edge(EdgeShare::Whole(0.0)))),
    mutant(EDGE_LENGTH, |rules| with_own_depth(rules, edge(EdgeShare::Whole(0.0)))),
    mutant(EDGE_LENGTH, |rules| for_values(rules, on_the_screen(edge(EdgeShare::Whole(0.0))))),
    mutant(EDGE_LENGTH, |rules| for_values(rules, edge(EdgeShare::Whole(1.0)))),
    mutant(EDGE_LENGTH, |rules| for_all(rules, edge(EdgeShare::Whole(1.0)))),
    mutant(EDGE_LENGTH, |rules| with_own_depth(rules, edge(EdgeShare::Whole(1.0)))),
    mutant(EDGE_LENGTH, |rules| for_values(rules, on_the_screen(edge(EdgeShare::Whole(1.0))))),
    mutant(EDGE_LENGTH, |rules| for_values(rules, edge(EdgeShare::Whole(-1.0)))),
    mutant(EDGE_LENGTH, |rules| for_all(rules, edge(EdgeShare::Whole(-1.0)))),
    mutant(EDGE_LENGTH, |rules| with_own_depth(rules, edge(EdgeShare::Whole(-1.0)))),
    mutant(EDGE_LENGTH, |rules| for_values(rules, on_the_screen(edge(EdgeShare::Whole(-1.0))))),
    mutant(EDGE_LENGTH, |rules| for_values(rules, edge(EdgeShare::Longer(1.0)))),
    mutant(EDGE_LENGTH, |rules| for_all(rules, edge(EdgeShare::Longer(1.0)))),
    mutant(EDGE_LENGTH, |rules| with_own_depth(rules, edge(EdgeShare::Longer(1.0)))),
    mutant(EDGE_LENGTH, |rules| for_values(rules, on_the_screen(edge(EdgeShare::Longer(1.0))))),
    mutant(EDGE_LENGTH, |rules| for_values(rules, edge(EdgeShare::Longer(-1.0)))),
    mutant(EDGE_LENGTH, |rules| for_all(rules, edge(EdgeShare::Longer(-1.0)))),
    mutant(EDGE_LENGTH, |rules| with_own_depth(rules, edge(EdgeShare::Longer(-1.0)))),
    mutant(EDGE_LENGTH, |rules| for_values(rules, on_the_screen(edge(EdgeShare::Longer(-1.0))))),
    mutant(ROW_SAMPLES, |rules| for_values(rules, row(RowShare::Whole(0.0, 0.0)))),
    mutant(ROW_SAMPLES, |rules| for_all(rules, row(RowShare::Whole(0.0, 0.0)))),
    mutant(ROW_SAMPLES, |rules| with_own_depth(rules, row(RowShare::Whole(0.0, 0.0)))),
    mutant(ROW_SAMPLES, |rules| for_values(rules, on_the_screen(row(RowShare::Whole(0.0, 0.0))))),
    mutant(ROW_SAMPLES, |rules| for_values(rules, row(RowShare::Whole(0.0, -1.0)))),
    mutant(ROW_SAMPLES, |rules| for_all(rules, row(RowShare::Whole(0.0, -1.0)))),
    mutant(ROW_SAMPLES, |rules| with_own_depth(rules, row(RowShare::Whole(0.0, -1.0)))),
    mutant(ROW_SAMPLES, |rules| for_values(rules, on_the_screen(row(RowShare::Whole(0.0, -1.0))))),
    mutant(ROW_SAMPLES, |rules| for_values(rules, row(RowShare::Whole(0.5, 0.0)))),
    mutant(ROW_SAMPLES, |rules| for_all(rules, row(RowShare::Whole(0.5, 0.0)))),
    mutant(ROW_SAMPLES, |rules| with_own_depth(rules, row(RowShare::Whole(0.5, 0.0)))),
    mutant(ROW_SAMPLES, |rules| for_values(rules, on_the_screen(row(RowShare::Whole(0.5, 0.0))))),
    mutant(ROW_SAMPLES, |rules| for_values(rules, row(RowShare::Whole(1.0, 0.0)))),
    mutant(ROW_SAMPLES, |rules| for_all(rules, row(RowShare::Whole(1.0, 0.0)))),
    mutant(ROW_SAMPLES, |rules| with_own_depth(rules, row(RowShare::Whole(1.0, 0.0)))),
    mutant(ROW_SAMPLES, |rules| for_values(rules, on_the_screen(row(RowShare::Whole(1.0, 0.0))))),
    mutant(ROW_SAMPLES, |rules| for_values(rules, row(RowShare::Whole(1.0, 1.0)))),
    mutant(ROW_SAMPLES, |rules| for_all(rules, row(RowShare::Whole(1.0, 1.0)))),
    mutant(ROW_SAMPLES, |rules| with_own_depth(rules, row(RowShare::Whole(1.0, 1.0)))),
    mutant(ROW_SAMPLES, |rules| for_values(rules, on_the_screen(row(RowShare::Whole(1.0, 1.0))))),
    mutant(ROW_SAMPLES, |rules| for_values(rules, row(RowShare::Cut))),
    mutant(ROW_SAMPLES, |rules| for_all(rules, row(RowShare::Cut))),
    mutant(ROW_SAMPLES, |rules| with_own_depth(rules, row(RowShare::Cut))),
    mutant(ROW_SAMPLES, |rules| for_values(rules, on_the_screen(row(RowShare::Cut)))),
    mutant(ROW_CORNER, |rules| for_values(rules, row(RowShare::Left(0.0)))),
    mutant(ROW_CORNER, |rules| for_all(rules, row(RowShare::Left(0.0)))),
    mutant(ROW_CORNER, |rules| with_own_depth(rules, row(RowShare::Left(0.0)))),
    mutant(ROW_CORNER, |rules| for_values(rules, on_the_screen(row(RowShare::Left(0.0))))),
    mutant(ROW_CORNER, |rules| for_values(rules, row(RowShare::LeftUnlimited(0.0)))),
    mutant(ROW_CORNER, |rules| for_all(rules, row(RowShare::LeftUnlimited(0.0)))),
    mutant(ROW_CORNER, |rules| with_own_depth(rules, row(RowShare::LeftUnlimited(0.0)))),
    mutant(ROW_CORNER, |rules| for_values(rules, on_the_screen(row(RowShare::LeftUnlimited(0.0))))),
    mutant(ROW_CORNER, |rules| for_values(rules, row(RowShare::Left(1.0)))),
    mutant(ROW_CORNER, |rules| for_all(rules, row(RowShare::Left(1.0)))),
    mutant(ROW_CORNER, |rules| with_own_depth(rules, row(RowShare::Left(1.0)))),
    mutant(ROW_CORNER, |rules| for_values(rules, on_the_screen(row(RowShare::Left(1.0))))),
    mutant(ROW_CORNER, |rules| for_values(rules, row(RowShare::LeftUnlimited(1.0)))),
    mutant(ROW_CORNER, |rules| for_all(rules, row(RowShare::LeftUnlimited(1.0)))),
    mutant(ROW_CORNER, |rules| with_own_depth(rules, row(RowShare::LeftUnlimited(1.0)))),
    mutant(ROW_CORNER, |rules| for_values(rules, on_the_screen(row(RowShare::LeftUnlimited(1.0))))),
    mutant(ROW_TURNED, |rules| for_values(rules, row(RowShare::Turned))),
    mutant(ROW_TURNED, |rules| for_all(rules, row(RowShare::Turned))),
    mutant(ROW_TURNED, |rules| with_own_depth(rules, row(RowShare::Turned))),
    mutant(ROW_TURNED, |rules| for_values(rules, on_the_screen(row(RowShare::Turned)))),
    mutant(ROW_FIXED, |rules| for_values(rules, row(RowShare::Fixed(0.0)))),
    mutant(ROW_FIXED, |rules| for_all(rules, row(RowShare::Fixed(0.0)))),
    mutant(ROW_FIXED, |rules| with_own_depth(rules, row(RowShare::Fixed(0.0)))),
    mutant(ROW_FIXED, |rules| for_values(rules, on_the_screen(row(RowShare::Fixed(0.0))))),
    mutant(ROW_FIXED, |rules| for_values(rules, row(RowShare::Fixed(1.0)))),
    mutant(ROW_FIXED, |rules| for_all(rules, row(RowShare::Fixed(1.0)))),
    mutant(ROW_FIXED, |rules| with_own_depth(rules, row(RowShare::Fixed(1.0)))),
    mutant(ROW_FIXED, |rules| for_values(rules, on_the_screen(row(RowShare::Fixed(1.0))))),
    mutant(ROW_FIXED, |rules| for_values(rules, row(RowShare::Fixed(0.5)))),
    mutant(ROW_FIXED, |rules| for_all(rules, row(RowShare::Fixed(0.5)))),
    mutant(ROW_FIXED, |rules| with_own_depth(rules, row(RowShare::Fixed(0.5)))),
    mutant(ROW_FIXED, |rules| for_values(rules, on_the_screen(row(RowShare::Fixed(0.5))))),
    mutant(ROW_LENGTH, |rules| for_values(rules, row(RowShare::Longer(1.0)))),
    mutant(ROW_LENGTH, |rules| for_all(rules, row(RowShare::Longer(1.0)))),
    mutant(ROW_LENGTH, |rules| with_own_depth(rules, row(RowShare::Longer(1.0)))),
    mutant(ROW_LENGTH, |rules| for_values(rules, on_the_screen(row(RowShare::Longer(1.0))))),
    mutant(ROW_LENGTH, |rules| for_values(rules, row(RowShare::Longer(-1.0)))),
    mutant(ROW_LENGTH, |rules| for_all(rules, row(RowShare::Longer(-1.0)))),
    mutant(ROW_LENGTH, |rules| with_own_depth(rules, row(RowShare::Longer(-1.0)))),
    mutant(ROW_LENGTH, |rules| for_values(rules, on_the_screen(row(RowShare::Longer(-1.0))))),
    mutant(ROW_LENGTH, |rules| for_values(rules, row(RowShare::Whole(0.0, 1.0)))),
    mutant(ROW_LENGTH, |rules| for_all(rules, row(RowShare::Whole(0.0, 1.0)))),
    mutant(ROW_LENGTH, |rules| with_own_depth(rules, row(RowShare::Whole(0.0, 1.0)))),
    mutant(ROW_LENGTH, |rules| for_values(rules, on_the_screen(row(RowShare::Whole(0.0, 1.0))))),
    mutant(EDGE_AFFINE, |rules| for_values(rules, RunRule { affine_edges: true, ..RunRule::RIGHT })),
    mutant(ROW_AFFINE, |rules| for_values(rules, RunRule { affine_rows: true, ..RunRule::RIGHT })),
];
