//! Mistakes about which samples a polygon covers.

use super::{Mutant, mutant};
use crate::grade::rules::{Bounds, BoundsBy, BoundsOf, Fill, Front, Pieces, Rounding, Ties, Winding};

const PAGE: &str = "docs/conventions.md";

pub(super) const CORNER: [&str; 4] = [
    "samples at the corner",
    "Samples are asked for at (x, y), their upper left corner.",
    "The sample (x, y) has its center at (x + 0.5, y + 0.5): ask there.",
    PAGE,
];
pub(super) const FAR_CORNER: [&str; 4] =
    ["samples at the far corner", "Samples are asked for at (x + 1, y + 1).", CORNER[2], PAGE];
pub(super) const CENTER_LOST: [&str; 4] = [
    "samples half beside the center",
    "x or y is asked for half a sample beside the center.",
    "The center is (x + 0.5, y + 0.5).",
    PAGE,
];
pub(super) const OFF_CENTER: [&str; 4] = [
    "samples a little beside the center",
    "Samples are asked for less than half a sample beside their centers.",
    "The sample (x, y) has its center at (x + 0.5, y + 0.5): ask there.",
    PAGE,
];
const STEPS: [&str; 4] = [
    "corners in coarse steps",
    "Corners are rounded or cut to halves, quarters, eighths or sixteenths of a sample: too few bits behind the point.",
    "Corners lie on multiples of 1/256: keep eight bits behind the point.",
    PAGE,
];
const LEVEL_LOST: [&str; 4] = [
    "level edges own nothing",
    "A center on a level edge goes to neither of the polygons above and below: only left or right edges own theirs.",
    "Upper edges own their centers, too: dy == 0 and the inside below.",
    PAGE,
];
const LEVEL_SHARED: [&str; 4] = [
    "every level edge owns",
    "A center on a level edge goes to both polygons: every level edge counts as an upper one.",
    "Of level edges only upper ones own their centers: dy == 0 and the inside below, so ask for the sign of dx.",
    PAGE,
];
const SIDES_LOST: [&str; 4] = [
    "left and right edges own nothing",
    "A center on an edge that is not level goes to neither polygon: only upper or lower edges own theirs.",
    "Left edges own their centers, too.",
    PAGE,
];
const SIDES_SHARED: [&str; 4] = [
    "left and right edges both own",
    "A center on an edge that is not level goes to both polygons.",
    "Of edges that are not level only the left ones own their centers: ask for the sign of dy.",
    PAGE,
];
const NARROW: [&str; 4] = [
    "edge functions overflow",
    "Differences of corners are kept in 16 bits, which is too little for a long edge.",
    "With steps of 1/256 a difference needs more than 16 bits and a product more than 32: use 64-bit numbers.",
    PAGE,
];
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
pub(super) const SHORT: [&str; 4] = [
    "bounds too short",
    "The last columns or rows of a polygon's bounds are not looked at (< instead of <=, or bounds of some of the corners).",
    "Look at every column from floor(least x) to floor(greatest x), both included, and at rows alike.",
    PAGE,
];
pub(super) const SHORT_FIRST: [&str; 4] = [
    "bounds begin too late",
    "The first columns or rows of a polygon's bounds are not looked at.",
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
    mutant(FAR_CORNER, |rules| rules.cover_at = (1.0, 1.0)),
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
    mutant(SHORT, |rules| rules.bounds = bounds([0, 1, 0, 0], BoundsBy::Floor)),
    mutant(SHORT, |rules| rules.bounds = bounds([0, 0, 0, 1], BoundsBy::Floor)),
    mutant(SHORT, |rules| rules.bounds = bounds([0, 1, 0, 1], BoundsBy::Floor)),
    mutant(SHORT, |rules| rules.bounds = bounds([0, 1, 0, 0], BoundsBy::Clipped)),
    mutant(SHORT, |rules| rules.bounds = bounds([0, 0, 0, 1], BoundsBy::Clipped)),
    mutant(SHORT, |rules| rules.bounds = bounds([0, 1, 0, 1], BoundsBy::Clipped)),
    mutant(SHORT, |rules| rules.bounds = bounds([0, 1, 0, 0], BoundsBy::Centers)),
    mutant(SHORT, |rules| rules.bounds = bounds([0, 0, 0, 1], BoundsBy::Centers)),
    mutant(SHORT, |rules| rules.bounds = bounds([0, 1, 0, 1], BoundsBy::Centers)),
    mutant(SHORT, |rules| rules.bounds = bounds([0, 1, 0, 1], BoundsBy::Rounded)),
    mutant(SHORT, |rules| rules.bounds = bounds([0; 4], BoundsBy::Inner)),
    mutant(SHORT_FIRST, |rules| rules.bounds = bounds([1, 0, 0, 0], BoundsBy::Floor)),
    mutant(SHORT_FIRST, |rules| rules.bounds = bounds([0, 0, 1, 0], BoundsBy::Floor)),
    mutant(SHORT_FIRST, |rules| rules.bounds = bounds([1, 0, 1, 0], BoundsBy::Floor)),
    mutant(SHORT_FIRST, |rules| rules.bounds = bounds([1, 0, 0, 0], BoundsBy::Centers)),
    mutant(SHORT_FIRST, |rules| rules.bounds = bounds([0, 0, 1, 0], BoundsBy::Centers)),
    mutant(SHORT_FIRST, |rules| rules.bounds = bounds([1, 0, 1, 0], BoundsBy::Centers)),
    mutant(OFF_CENTER, |rules| rules.cover_at = (0.25, 0.25)),
    mutant(OFF_CENTER, |rules| (rules.cover_at, rules.value_at) = ((0.25, 0.25), (0.25, 0.25))),
    mutant(OFF_CENTER, |rules| rules.cover_at = (0.75, 0.75)),
    mutant(OFF_CENTER, |rules| rules.cover_at = (0.25, 0.5)),
    mutant(OFF_CENTER, |rules| rules.cover_at = (0.5, 0.25)),
    mutant(OFF_CENTER, |rules| rules.cover_at = (0.75, 0.5)),
    mutant(OFF_CENTER, |rules| rules.cover_at = (0.5, 0.75)),
    mutant(OFF_CENTER, |rules| rules.cover_at = (0.499, 0.499)),
    mutant(OFF_CENTER, |rules| rules.cover_at = (0.501, 0.501)),
    mutant(CENTER_LOST, |rules| rules.cover_at = (1.0, 0.5)),
    mutant(CENTER_LOST, |rules| rules.cover_at = (0.5, 1.0)),
    mutant(CENTER_LOST, |rules| rules.cover_at = (1.0, 0.0)),
    mutant(CENTER_LOST, |rules| rules.cover_at = (0.0, 1.0)),
    mutant(STEPS, |rules| rules.corners = Rounding::NearestTo(2)),
    mutant(STEPS, |rules| rules.corners = Rounding::NearestTo(4)),
    mutant(STEPS, |rules| rules.corners = Rounding::NearestTo(8)),
    mutant(STEPS, |rules| rules.corners = Rounding::NearestTo(10)),
    mutant(STEPS, |rules| rules.corners = Rounding::NearestTo(16)),
    mutant(STEPS, |rules| rules.corners = Rounding::DownTo(2)),
    mutant(STEPS, |rules| rules.corners = Rounding::DownTo(4)),
    mutant(STEPS, |rules| rules.corners = Rounding::DownTo(8)),
    mutant(STEPS, |rules| rules.corners = Rounding::DownTo(10)),
    mutant(STEPS, |rules| rules.corners = Rounding::DownTo(16)),
    mutant(LEVEL_LOST, |rules| rules.ties = sides(true, false, false, false)),
    mutant(LEVEL_LOST, |rules| rules.ties = sides(false, true, false, false)),
    mutant(LEVEL_SHARED, |rules| rules.ties = sides(true, false, true, true)),
    mutant(LEVEL_SHARED, |rules| rules.ties = sides(false, true, true, true)),
    mutant(LEVEL_SHARED, |rules| rules.ties = sides(false, false, true, true)),
    mutant(SIDES_LOST, |rules| rules.ties = sides(false, false, true, false)),
    mutant(SIDES_LOST, |rules| rules.ties = sides(false, false, false, true)),
    mutant(SIDES_SHARED, |rules| rules.ties = sides(true, true, true, false)),
    mutant(SIDES_SHARED, |rules| rules.ties = sides(true, true, false, true)),
    mutant(SIDES_SHARED, |rules| rules.ties = sides(true, true, false, false)),
    mutant(LEVEL_LOST, |rules| (rules.ties, rules.pieces) = (sides(true, false, false, false), FAN)),
    mutant(LEVEL_LOST, |rules| (rules.ties, rules.pieces) = (sides(false, true, false, false), FAN)),
    mutant(LEVEL_SHARED, |rules| (rules.ties, rules.pieces) = (sides(true, false, true, true), FAN)),
    mutant(SIDES_LOST, |rules| (rules.ties, rules.pieces) = (sides(false, false, true, false), FAN)),
    mutant(SIDES_LOST, |rules| (rules.ties, rules.pieces) = (sides(false, false, false, true), FAN)),
    mutant(SIDES_SHARED, |rules| (rules.ties, rules.pieces) = (sides(true, true, true, false), FAN)),
    mutant(NO_TIES, |rules| (rules.ties, rules.pieces) = (Ties::Nobody, FAN)),
    mutant(ALL_TIES, |rules| (rules.ties, rules.pieces) = (Ties::All, FAN)),
    // A triangle without area has no inside for most who divide by it.
    mutant(LEVEL_SHARED, |rules| (rules.ties, rules.least_area) = (sides(true, false, true, true), 1e-9)),
    mutant(LEVEL_SHARED, |rules| (rules.ties, rules.least_area) = (sides(false, true, true, true), 1e-9)),
    mutant(SIDES_SHARED, |rules| (rules.ties, rules.least_area) = (sides(true, true, true, false), 1e-9)),
    mutant(SIDES_SHARED, |rules| (rules.ties, rules.least_area) = (sides(true, true, false, true), 1e-9)),
    mutant(LEVEL_SHARED, |rules| {
        (rules.ties, rules.pieces, rules.least_area) = (sides(true, false, true, true), FAN, 1e-9)
    }),
    mutant(SIDES_SHARED, |rules| {
        (rules.ties, rules.pieces, rules.least_area) = (sides(true, true, true, false), FAN, 1e-9)
    }),
    mutant(ALL_TIES, |rules| (rules.ties, rules.pieces, rules.least_area) = (Ties::All, FAN, 1e-9)),
    mutant(WINDING, |rules| (rules.winding, rules.pieces) = (Winding::Clockwise, FAN)),
    mutant(WINDING, |rules| (rules.winding, rules.pieces) = (Winding::CounterClockwise, FAN)),
    mutant(NARROW, |rules| rules.fill = Fill::Narrow(256)),
    mutant(NARROW, |rules| rules.fill = Fill::Narrow(512)),
    mutant(NARROW, |rules| (rules.fill, rules.pieces) = (Fill::Narrow(256), FAN)),
    mutant(NARROW, |rules| (rules.fill, rules.pieces) = (Fill::Narrow(512), FAN)),
    mutant(NARROW, |rules| (rules.fill, rules.pieces) = (Fill::Narrow(1024), FAN)),
    mutant(
        [
            "outside filled",
            "The inside test is turned over: what is outside is drawn.",
            "A sample is drawn when its center is inside the outline.",
            PAGE,
        ],
        |rules| rules.fill = Fill::Outside,
    ),
    mutant(SMALL, |rules| rules.least_area = 1.0),
    mutant(SMALL, |rules| rules.least_area = 0.5),
    mutant(SMALL, |rules| rules.least_area = 2.0),
];

/// Triangles from the first corner, where a second one takes back: right, whatever the outline.
const FAN: Pieces = Pieces::Fan { from: 0, skipped: 0, lost: 0, toggles: true, of_all: true };

const fn bounds(lost: [i32; 4], by: BoundsBy) -> Bounds {
    Bounds { lost, by, of: BoundsOf::All }
}

const fn sides(left: bool, right: bool, top: bool, bottom: bool) -> Ties {
    Ties::Sides { left, right, top, bottom }
}
