//! Mistakes of what an outline is cut into: fans, strips, boxes, and the spans of a line.

use super::{Mutant, mutant};
use crate::grade::rules::{Fill, LineSpans, Pieces, Quarters};

const SPLITTING: &str = "docs/splitting.md";
const SCANLINE: &str = "docs/scanline.md";
const PAGE: &str = "docs/conventions.md";
const CONVEX: [&str; 4] = [
    "convex outlines only",
    "The inside test is right for convex polygons, and this one has a notch.",
    "Count the edges left of the center, odd is inside; or ask for triangles: fn accepts() of the trait.",
    SPLITTING,
];
const FAN_SHORT: [&str; 4] = [
    "a triangle of the fan lost",
    "A polygon is cut into a fan, and its first or its last triangle is missing.",
    "A polygon of n corners has n - 2 triangles: (0, k, k + 1) for k from 1 to n - 2.",
    SPLITTING,
];
const STRIP: [&str; 4] = [
    "strip for a fan",
    "Corners are taken three in a row, as in a strip.",
    "An outline is a fan: all of its triangles have the first corner.",
    SPLITTING,
];
const FIRST: [&str; 4] = [
    "first triangle only",
    "Of a polygon with four corners or more only the first three are drawn.",
    "A polygon has as many corners as it says; or ask for triangles: fn accepts() of the trait.",
    SPLITTING,
];
const FEW: [&str; 4] = [
    "first corners only",
    "Of a polygon with many corners only the first few are read.",
    "A polygon has as many corners as it says: leave no fixed number in the program.",
    SPLITTING,
];
const SPAN_DECIDED: [&str; 4] = [
    "one sample decides a span",
    "The polygon in front at one place of a span is shown on all of it, so polygons cannot pierce each other inside.",
    "Where another polygon is in front at the other end, the span must be cut where they meet.",
    SCANLINE,
];
const HALVED: [&str; 4] = [
    "spans halved wrongly",
    "A span whose ends differ is halved only once, or the sample in the middle is in neither half.",
    "Halve until both ends show the same polygon: first to middle, and middle + 1 to last.",
    SCANLINE,
];
const CUT_NOTHING: [&str; 4] = [
    "spans not cut at every end",
    "Spans of a line are cut where polygons begin, but not where they end (or the other way round).",
    "A span ends where any polygon begins or ends.",
    SCANLINE,
];
const SPAN_LOST: [&str; 4] = [
    "a span of every line lost",
    "The last (or first) span of every line is not shown.",
    "n places where a line is cut make n - 1 spans; all of them are shown.",
    SCANLINE,
];
const SAMPLE_LOST: [&str; 4] = [
    "span ends rounded",
    "The last (or first) sample of every span is lost.",
    "A span covers the columns from its first up to, but not with, its end.",
    SCANLINE,
];
const BOXES: [&str; 4] = [
    "boxes quartered wrongly",
    "A box is taken for whole though an edge passes it, or a part of it is forgotten.",
    "A box is whole when no edge, the closing one included, comes near it; else all four quarters follow, down to one sample.",
    PAGE,
];

pub(super) const MUTANTS: &[Mutant] = &[
    mutant(CONVEX, |rules| rules.pieces = fan(0, 0, 0, false)),
    mutant(CONVEX, |rules| rules.pieces = fan(1, 0, 0, false)),
    mutant(CONVEX, |rules| rules.pieces = fan(2, 0, 0, false)),
    mutant(FIRST, |rules| rules.pieces = Pieces::FirstCorners(3)),
    mutant(FEW, |rules| rules.pieces = Pieces::FirstCorners(4)),
    mutant(FEW, |rules| rules.pieces = Pieces::FirstCorners(5)),
    mutant(FEW, |rules| rules.pieces = Pieces::FirstCorners(6)),
    mutant(FAN_SHORT, |rules| rules.pieces = fan(0, 0, 1, true)),
    mutant(FAN_SHORT, |rules| rules.pieces = fan(0, 0, 1, false)),
    mutant(FAN_SHORT, |rules| rules.pieces = fan(0, 1, 0, true)),
    mutant(FAN_SHORT, |rules| rules.pieces = fan(0, 1, 0, false)),
    mutant(STRIP, |rules| rules.pieces = Pieces::Strip { toggles: true }),
    mutant(STRIP, |rules| rules.pieces = Pieces::Strip { toggles: false }),
    mutant(SPAN_DECIDED, |rules| rules.line = LineSpans::LeftEnd),
    mutant(SPAN_DECIDED, |rules| rules.line = LineSpans::RightEnd),
    mutant(SPAN_DECIDED, |rules| rules.line = LineSpans::Middle),
    mutant(HALVED, |rules| rules.line = LineSpans::HalvedOnce),
    mutant(HALVED, |rules| rules.line = LineSpans::MiddleLost),
    mutant(CUT_NOTHING, |rules| rules.line = LineSpans::EndsCutNothing),
    mutant(CUT_NOTHING, |rules| rules.line = LineSpans::BeginningsCutNothing),
    mutant(SPAN_LOST, |rules| rules.line = LineSpans::LastLost),
    mutant(SPAN_LOST, |rules| rules.line = LineSpans::FirstLost),
    mutant(SAMPLE_LOST, |rules| rules.line = LineSpans::LastSampleLost),
    mutant(SAMPLE_LOST, |rules| rules.line = LineSpans::FirstSampleLost),
    mutant(BOXES, |rules| rules.fill = Fill::Quarters(Quarters::EdgeForgotten { closing: true })),
    mutant(BOXES, |rules| rules.fill = Fill::Quarters(Quarters::EdgeForgotten { closing: false })),
    mutant(BOXES, |rules| rules.fill = Fill::Quarters(Quarters::CornersOnly)),
    mutant(BOXES, |rules| rules.fill = Fill::Quarters(Quarters::Smallest(2))),
    mutant(BOXES, |rules| rules.fill = Fill::Quarters(Quarters::Smallest(4))),
    mutant(BOXES, |rules| rules.fill = Fill::Quarters(Quarters::OddCut)),
    mutant(BOXES, |rules| rules.fill = Fill::Quarters(Quarters::Lost(1))),
    mutant(BOXES, |rules| rules.fill = Fill::Quarters(Quarters::Lost(2))),
    mutant(BOXES, |rules| rules.fill = Fill::Quarters(Quarters::Lost(3))),
];

const fn fan(from: usize, skipped: usize, lost: usize, toggles: bool) -> Pieces {
    Pieces::Fan { from, skipped, lost, toggles, of_all: true }
}
