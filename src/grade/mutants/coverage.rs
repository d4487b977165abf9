//! Mistakes about which samples a polygon covers.

use super::{Mutant, mutant};
use crate::grade::rules::{Bounds, Fill, Front, Rounding, SpanRule, Ties, Winding};

const PAGE: &str = "docs/conventions.md";

const CORNER: [&str; 4] = [
    "samples at the corner",
    "Samples are asked for at (x, y), their upper left corner.",
    "The sample (x, y) has its center at (x + 0.5, y + 0.5): ask there.",
    PAGE,
];
const CENTER_LOST: [&str; 4] =
    ["samples half beside the center", "Only one of x and y gets its half.", "The center is (x + 0.5, y + 0.5).", PAGE];
const ROUNDED: [&str; 4] = [
    "corners made whole",
    "Corners are turned into whole numbers before anything is asked (`int`, `as i32`, round).",
    "Corners lie between samples, on multiples of 1/256: compute with x and y as they are.",
    PAGE,
];
const TIES: [&str; 4] = [
    "another side owns the edges",
    "Centers exactly on an edge go to the wrong side; every center still goes to exactly one polygon.",
    "Left and upper edges belong to a polygon, right and lower ones to its neighbor.",
    PAGE,
];
const ALL_TIES: [&str; 4] = [
    "every edge is inside",
    "A center exactly on an edge is drawn by both polygons that share it (>= at all edges).",
    "Left and upper edges belong to the polygon (>=), right and lower ones do not (>).",
    PAGE,
];
const NO_TIES: [&str; 4] = [
    "no edge is inside",
    "A center exactly on an edge is drawn by nobody (> at all edges): cracks.",
    "Left and upper edges belong to the polygon (>=), right and lower ones do not (>).",
    PAGE,
];
const WINDING: [&str; 4] = [
    "one way round only",
    "Polygons that go the other way round are not drawn.",
    "Inside does not depend on the way round: facing was decided before, in eye space.",
    PAGE,
];
const CONVEX: [&str; 4] = [
    "convex outlines only",
    "The inside test is right for convex polygons, and this one has a notch.",
    "Count the edges left of the center, odd is inside; or ask for triangles: fn accepts() of the trait.",
    "docs/splitting.md",
];
const SPAN_ENDS: [&str; 4] = [
    "span ends rounded",
    "The ends of a scan line's span are rounded to columns the wrong way.",
    "A span covers the columns from ceil(left - 0.5) up to, but not with, ceil(right - 0.5).",
    "docs/scanline.md",
];
const SPAN_ROWS: [&str; 4] = [
    "scan lines at whole y",
    "Edges are crossed with the upper side of a row, y, not with the line through its centers, y + 0.5.",
    "Row y is crossed at y + 0.5; it is drawn when that lies at or below the top and above the bottom.",
    "docs/scanline.md",
];
const SHORT: [&str; 4] = [
    "bounds too short",
    "The last column or row of a polygon's bounds is not looked at (< instead of <=).",
    "Look at every column from floor(least x) to floor(greatest x), both included, and at rows alike.",
    PAGE,
];
const SHORT_FIRST: [&str; 4] = [
    "bounds begin too late",
    "The first column or row of a polygon's bounds is not looked at.",
    "Look at every column from floor(least x) to floor(greatest x), both included, and at rows alike.",
    PAGE,
];
const SMALL: [&str; 4] = [
    "small polygons dropped",
    "Polygons with a small area are thrown away.",
    "A polygon smaller than a sample still covers a center if one lies in it; only zero area draws nothing.",
    PAGE,
];

pub(super) const MUTANTS: &[Mutant] = &[
    mutant(CORNER, |rules| (rules.cover_at, rules.value_at) = ((0.0, 0.0), (0.0, 0.0))),
    mutant(CORNER, |rules| rules.cover_at = (0.0, 0.0)),
    mutant(["samples at the far corner", "Samples are asked for at (x + 1, y + 1).", CORNER[2], PAGE], |rules| {
        rules.cover_at = (1.0, 1.0);
    }),
    mutant(CENTER_LOST, |rules| rules.cover_at = (0.5, 0.0)),
    mutant(CENTER_LOST, |rules| rules.cover_at = (0.0, 0.5)),
    mutant(CENTER_LOST, |rules| (rules.cover_at, rules.value_at) = ((0.5, 0.0), (0.5, 0.0))),
    mutant(CENTER_LOST, |rules| (rules.cover_at, rules.value_at) = ((0.0, 0.5), (0.0, 0.5))),
    mutant(
        [
            "values at the corner",
            "Depth and values are taken at (x, y), though coverage is asked for at the center.",
            "Take depth, color and normal at (x + 0.5, y + 0.5), where coverage is asked for.",
            PAGE,
        ],
        |rules| rules.value_at = (0.0, 0.0),
    ),
    mutant(ROUNDED, |rules| rules.corners = Rounding::Down),
    mutant(ROUNDED, |rules| rules.corners = Rounding::Nearest),
    mutant(ROUNDED, |rules| rules.corners = Rounding::Up),
    mutant(ROUNDED, |rules| (rules.corners, rules.cover_at, rules.value_at) = (Rounding::Down, (0.0, 0.0), (0.0, 0.0))),
    mutant(ROUNDED, |rules| (rules.corners, rules.cover_at) = (Rounding::Down, (0.0, 0.0))),
    mutant(ROUNDED, |rules| (rules.corners, rules.ties) = (Rounding::Down, Ties::All)),
    mutant(ROUNDED, |rules| (rules.corners, rules.cover_at, rules.ties) = (Rounding::Down, (0.0, 0.0), Ties::All)),
    mutant(ROUNDED, |rules| (rules.corners, rules.cover_at, rules.ties) = (Rounding::Nearest, (0.0, 0.0), Ties::All)),
    mutant(TIES, |rules| rules.ties = Ties::Consistent { x: -1, y: 1, x_first: true }),
    mutant(TIES, |rules| rules.ties = Ties::Consistent { x: 1, y: -1, x_first: true }),
    mutant(TIES, |rules| rules.ties = Ties::Consistent { x: -1, y: -1, x_first: true }),
    mutant(TIES, |rules| rules.ties = Ties::Consistent { x: 1, y: 1, x_first: false }),
    mutant(TIES, |rules| rules.ties = Ties::Consistent { x: -1, y: 1, x_first: false }),
    mutant(TIES, |rules| rules.ties = Ties::Consistent { x: 1, y: -1, x_first: false }),
    mutant(TIES, |rules| rules.ties = Ties::Consistent { x: -1, y: -1, x_first: false }),
    mutant(ALL_TIES, |rules| rules.ties = Ties::All),
    // Without area there is no inside, even for many who count every edge in.
    mutant(ALL_TIES, |rules| (rules.ties, rules.least_area) = (Ties::All, 1e-9)),
    mutant(NO_TIES, |rules| rules.ties = Ties::Nobody),
    mutant(WINDING, |rules| rules.winding = Winding::Clockwise),
    mutant(WINDING, |rules| rules.winding = Winding::CounterClockwise),
    mutant(CONVEX, |rules| rules.fill = Fill::Hull),
    mutant(CONVEX, |rules| rules.fill = Fill::AllEdges),
    mutant(CONVEX, |rules| rules.fill = Fill::Fan),
    mutant(
        [
            "first triangle only",
            "Of a polygon with four corners or more only the first three are drawn.",
            "A polygon has as many corners as it says; or ask for triangles: fn accepts() of the trait.",
            "docs/splitting.md",
        ],
        |rules| rules.fill = Fill::FirstTriangle,
    ),
    mutant(
        [
            "corners only",
            "Only the samples that hold a corner are drawn: nothing is filled yet.",
            "Every sample whose center is inside the outline is drawn: go over the polygon's bounds and ask.",
            PAGE,
        ],
        |rules| (rules.fill, rules.front) = (Fill::Corners, Front::Last),
    ),
    mutant(
        [
            "boxes filled",
            "The whole bounding box is drawn: no inside test.",
            "Of the samples in the bounds only those are drawn whose center is inside the outline.",
            PAGE,
        ],
        |rules| rules.fill = Fill::Box,
    ),
    mutant(
        [
            "corners on scan lines counted twice",
            "Where a corner lies exactly on a row's center line both of its edges are counted, so parity is wrong.",
            "An edge owns its upper end and not its lower: top.y <= y < bottom.y. Horizontal edges own nothing.",
            "docs/scanline.md",
        ],
        |rules| rules.fill = Fill::BothEnds,
    ),
    mutant(SPAN_ENDS, |rules| rules.fill = span(0.5, 0.0, 0.0)),
    mutant(SPAN_ENDS, |rules| rules.fill = span(0.5, 0.0, 1.0)),
    mutant(SPAN_ENDS, |rules| rules.fill = span(0.5, 0.5, 1.5)),
    mutant(SPAN_ENDS, |rules| rules.fill = span(0.5, UP, UP)),
    mutant(SPAN_ENDS, |rules| rules.fill = span(0.5, UP, 1.0)),
    mutant(SPAN_ENDS, |rules| rules.fill = span(0.5, 0.0, UP)),
    mutant(SPAN_ROWS, |rules| rules.fill = span(0.0, UP - 0.5, UP - 0.5)),
    mutant(SPAN_ROWS, |rules| rules.fill = span(0.0, 0.0, 0.0)),
    mutant(SPAN_ROWS, |rules| rules.fill = span(0.0, 0.0, 1.0)),
    mutant(SPAN_ROWS, |rules| rules.fill = span(0.0, 0.5, 1.5)),
    mutant(SHORT, |rules| rules.bounds = Bounds::ColumnShort),
    mutant(SHORT, |rules| rules.bounds = Bounds::RowShort),
    mutant(SHORT, |rules| rules.bounds = Bounds::BothShort),
    mutant(SHORT_FIRST, |rules| rules.bounds = Bounds::FirstColumnLost),
    mutant(SHORT_FIRST, |rules| rules.bounds = Bounds::FirstRowLost),
    mutant(SMALL, |rules| rules.least_area = 1.0),
    mutant(SMALL, |rules| rules.least_area = 0.5),
    mutant(SMALL, |rules| rules.least_area = 2.0),
];

/// Just below 1: floor(x + UP) is the ceiling of every multiple of 1/256.
const UP: f64 = 1.0 - 1e-6;

const fn span(row: f64, first: f64, end: f64) -> Fill {
    Fill::Spans(SpanRule { row, first, end })
}
