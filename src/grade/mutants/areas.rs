//! Mistakes about areas: slack at edges, blocks of samples, masks that are not cleared, corners that are turned, borders.

use super::{Mutant, drawing, each_of, each_with, family, mutant};
use crate::grade::rules::{
    Address, Block, BlockEnd, BlockStart, Blocks, Border, Bounds, BoundsBy, BoundsOf, Fill, LineSpans, Memory, Pieces,
    Place, Quarters, Rules, Shape, Slack, Stencil, Ties, Turned,
};
use crate::grade::scan::{Edges, Odd, Pairs, Scan, Slope};

const PAGE: &str = "docs/conventions.md";
const SLACK: [&str; 4] = [
    "edges with slack",
    "A sample a little outside an edge is taken for inside (or one a little inside for outside): the comparison has a tolerance.",
    "Compare with 0: coordinates are multiples of 1/256, so nothing is rounded.",
    PAGE,
];
const BLOCKS: [&str; 4] = [
    "whole blocks only",
    "Bounds are walked in blocks of samples (2 x 2, a vector), and what does not fill a block at their end is left out.",
    "Where the bounds end inside a block, the samples that are left are drawn one by one.",
    PAGE,
];
const COVERED_BLOCKS: [&str; 4] = [
    "one sample covers a block",
    "Coverage is asked for once for a block of samples.",
    "Coverage is asked for at every sample.",
    PAGE,
];
const MASK: [&str; 4] = [
    "kept from polygon to polygon",
    "What one polygon covers (a mask, a list of crossings, the ends of rows) is not cleared before the next.",
    "Clear everything that belongs to a polygon before its first sample.",
    PAGE,
];
const FAN_SHORT: [&str; 4] = [
    "a triangle of the fan lost",
    "A polygon is cut into a fan, and its first or its last triangle is missing.",
    "A polygon of n corners has n - 2 triangles: (0, k, k + 1) for k from 1 to n - 2.",
    "docs/splitting.md",
];
const TURNED: [&str; 4] =
    ["x and y exchanged", "Rows and columns are exchanged.", "A pixel stands at y * width + x.", PAGE];
const UPSIDE: [&str; 4] = ["upside down", "The picture is upside down.", "y runs down: row 0 is the uppermost.", PAGE];
const MIRRORED: [&str; 4] =
    ["mirrored", "Left and right are exchanged.", "x runs to the right: column 0 is the leftmost.", PAGE];
const HALF: [&str; 4] =
    ["turned by half", "The picture is turned by 180 degrees.", "Row 0 is on top, column 0 on the left.", PAGE];
const WHOLE: [&str; 4] = [
    "corners made whole",
    "Corners are turned into whole numbers before anything is asked (`int`, `as i32`, round).",
    "Corners lie between samples, on multiples of 1/256: compute with x and y as they are.",
    PAGE,
];

/// All of them.
pub(super) fn all() -> Vec<Mutant> {
    [slack(), blocks(), masks(), fans(), turned(), borders(), followed(), shifted(), scans(), events()].concat()
}

fn slack() -> Vec<Mutant> {
    let sizes = [0.0001, 0.001, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, -0.001, -0.01, -0.05, -0.1];
    let weights = family(SLACK, &sizes, |rules, size| rules.fill = Fill::Slack(Slack::Weight(size)));
    let cross = family(SLACK, &[0.01, 0.1, 0.5, 1.0, 2.0, -0.1, -0.5, -1.0], |rules, size| {
        rules.fill = Fill::Slack(Slack::Cross(size));
    });
    let distances = family(SLACK, &[0.01, 0.05, 0.1, 0.25, 0.5, 0.7, 1.0, -0.05, -0.1, -0.25, -0.5], |rules, size| {
        rules.fill = Fill::Slack(Slack::Distance(size));
    });
    let all = [weights, cross, distances].concat();
    each_with(&all, &[fan_toggled, fan_added, |_| ()])
}

fn fan_toggled(rules: &mut Rules) {
    rules.pieces = Pieces::Fan { from: 0, skipped: 0, lost: 0, toggles: true, of_all: true };
}

fn fan_added(rules: &mut Rules) {
    rules.pieces = Pieces::Fan { from: 0, skipped: 0, lost: 0, toggles: false, of_all: true };
}

fn blocks() -> Vec<Mutant> {
    let sides = [2.0, 3.0, 4.0, 8.0, 16.0];
    let lost = family(BLOCKS, &sides, |rules, side| by(rules, BoundsBy::Blocks(Blocks { side: side as i32, ..PAIRS })));
    let across: fn(&mut Rules) = |rules| in_blocks(rules, |blocks| blocks.across_only = true);
    let starts: [fn(&mut Rules); 4] = [
        |_| (),
        |rules| in_blocks(rules, |blocks| blocks.start = BlockStart::Center),
        |rules| in_blocks(rules, |blocks| blocks.start = BlockStart::BlockBefore),
        |rules| in_blocks(rules, |blocks| blocks.start = BlockStart::BlockBehind),
    ];
    let ends: [fn(&mut Rules); 3] = [
        |_| (),
        |rules| in_blocks(rules, |blocks| blocks.end = BlockEnd::Ceil),
        |rules| in_blocks(rules, |blocks| blocks.end = BlockEnd::Center),
    ];
    let lost = each_of(&lost, &[&starts, &ends, &[|_| (), across]]);
    let covered: [fn(&mut Rules, f64); 4] = [
        |rules, side| rules.block = covering(side as i32, 0, false),
        |rules, side| rules.block = covering(side as i32, 0, true),
        |rules, side| rules.block = covering(side as i32, side as i32 / 2, false),
        |rules, side| rules.block = covering(side as i32, side as i32 / 2, true),
    ];
    let covered: Vec<_> = covered.iter().flat_map(|change| family(COVERED_BLOCKS, &sides, *change)).collect();
    let with_values = each_with(&covered, &[|rules| (rules.block.of_values, rules.block.of_depth) = (true, true)]);
    [lost, covered, with_values].concat()
}

fn ask_at(rules: &mut Rules, at: (f64, f64)) {
    (rules.cover_at, rules.value_at) = (at, at);
}

fn by(rules: &mut Rules, by: BoundsBy) {
    rules.bounds = Bounds { lost: [0; 4], by, of: BoundsOf::All };
}

const PAIRS: Blocks = Blocks { side: 2, across_only: false, start: BlockStart::Floor, end: BlockEnd::Floor };

fn in_blocks(rules: &mut Rules, change: fn(&mut Blocks)) {
    if let BoundsBy::Blocks(blocks) = &mut rules.bounds.by {
        change(blocks);
    }
}

const fn covering(side: i32, at: i32, from_bounds: bool) -> Block {
    Block { size: (side, side), at: (at, at), from_bounds, of_cover: true, ..Block::ONE }
}

fn masks() -> Vec<Mutant> {
    vec![
        mutant(MASK, |rules| rules.stencil = Stencil::Toggled),
        mutant(MASK, |rules| rules.stencil = Stencil::Added),
        mutant(MASK, |rules| rules.stencil = Stencil::Rows),
    ]
}

fn fans() -> Vec<Mutant> {
    vec![
        mutant(FAN_SHORT, |rules| rules.pieces = of_many(0, 1, true)),
        mutant(FAN_SHORT, |rules| rules.pieces = of_many(0, 1, false)),
        mutant(FAN_SHORT, |rules| rules.pieces = of_many(1, 0, true)),
        mutant(FAN_SHORT, |rules| rules.pieces = of_many(1, 0, false)),
    ]
}

const fn of_many(skipped: usize, lost: usize, toggles: bool) -> Pieces {
    Pieces::Fan { from: 0, skipped, lost, toggles, of_all: false }
}

/// Corners that are turned before they are filled, so that another side owns the edges; and pictures that are read in another order.
fn turned() -> Vec<Mutant> {
    let turned = |words, change: [fn(&mut Rules); 2]| change.map(|change| mutant(words, change)).to_vec();
    let corners = [
        turned(UPSIDE, [|rules| turn(rules, Turned::UpsideDown, false), |rules| turn(rules, Turned::UpsideDown, true)]),
        turned(MIRRORED, [|rules| turn(rules, Turned::Mirrored, false), |rules| turn(rules, Turned::Mirrored, true)]),
        turned(HALF, [|rules| turn(rules, Turned::Half, false), |rules| turn(rules, Turned::Half, true)]),
        turned(TURNED, [|rules| turn(rules, Turned::Transposed, false), |rules| turn(rules, Turned::Transposed, true)]),
    ];
    let written = vec![
        mutant(TURNED, |rules| rules.place = Place::ByColumns),
        mutant(drawing::SQUARE, |rules| rules.place = Place::SizeExchanged),
        mutant(TURNED, |rules| color_at(rules, Address::ByColumns)),
        mutant(TURNED, |rules| color_at(rules, Address::ColumnTimesWidth)),
        mutant(drawing::SQUARE, |rules| color_at(rules, Address::TimesHeight)),
        mutant(STRIDE, |rules| color_at(rules, Address::Stride(1))),
        mutant(STRIDE, |rules| color_at(rules, Address::Stride(-1))),
    ];
    [corners.concat(), written].concat()
}

const STRIDE: [&str; 4] = [
    "rows of another length",
    "Rows are taken to be a pixel longer or shorter than they are: the picture slants.",
    "A pixel stands at y * width + x.",
    PAGE,
];

fn color_at(rules: &mut Rules, color_at: Address) {
    rules.memory = Memory { color_at, ..Memory::RIGHT };
}

fn turn(rules: &mut Rules, turned: Turned, planes_follow: bool) {
    rules.shape = Shape { turned, planes_follow, is_fan: false };
}

/// All sides of the picture that may be left out; four of them alone stand elsewhere.
fn borders() -> Vec<Mutant> {
    let sides: Vec<f64> = (1..16).map(f64::from).collect();
    family(drawing::BORDER, &sides, |rules, sides| {
        let has = |bit: u8| sides as u8 & bit != 0;
        rules.border = Border::Sides([has(1), has(2), has(4), has(8)]);
    })
}

/// Corners that are rounded, and depth and values with them.
fn followed() -> Vec<Mutant> {
    use crate::grade::rules::Rounding;
    let whole = [
        mutant(WHOLE, |rules| rules.corners = Rounding::Down),
        mutant(WHOLE, |rules| rules.corners = Rounding::Nearest),
        mutant(WHOLE, |rules| rules.corners = Rounding::Up),
        mutant(WHOLE, |rules| {
            (rules.corners, rules.cover_at, rules.value_at) = (Rounding::Down, (0.0, 0.0), (0.0, 0.0))
        }),
        mutant(WHOLE, |rules| (rules.corners, rules.ties) = (Rounding::Down, Ties::All)),
        mutant(WHOLE, |rules| (rules.corners, rules.ties) = (Rounding::Nearest, Ties::All)),
    ];
    let follow: fn(&mut Rules) = |rules| rules.shape.planes_follow = true;
    let fan: fn(&mut Rules) = |rules| rules.shape = Shape { is_fan: true, planes_follow: true, turned: Turned::No };
    each_with(&whole, &[follow, fan])
}

/// Samples that are asked for elsewhere, with the bounds, the values, the boxes that go with it in some programs.
fn shifted() -> Vec<Mutant> {
    use super::coverage::{CENTER_LOST, CORNER, FAR_CORNER, OFF_CENTER};
    let shifts = [
        mutant(CORNER, |rules| ask_at(rules, (0.0, 0.0))),
        mutant(FAR_CORNER, |rules| ask_at(rules, (1.0, 1.0))),
        mutant(CENTER_LOST, |rules| ask_at(rules, (0.5, 0.0))),
        mutant(CENTER_LOST, |rules| ask_at(rules, (0.0, 0.5))),
        mutant(CENTER_LOST, |rules| ask_at(rules, (1.0, 0.5))),
        mutant(CENTER_LOST, |rules| ask_at(rules, (0.5, 1.0))),
        mutant(CENTER_LOST, |rules| ask_at(rules, (1.0, 0.0))),
        mutant(CENTER_LOST, |rules| ask_at(rules, (0.0, 1.0))),
        mutant(OFF_CENTER, |rules| ask_at(rules, (0.25, 0.25))),
        mutant(OFF_CENTER, |rules| ask_at(rules, (0.75, 0.75))),
        mutant(OFF_CENTER, |rules| ask_at(rules, (0.25, 0.5))),
        mutant(OFF_CENTER, |rules| ask_at(rules, (0.5, 0.25))),
        mutant(OFF_CENTER, |rules| ask_at(rules, (0.75, 0.5))),
        mutant(OFF_CENTER, |rules| ask_at(rules, (0.5, 0.75))),
    ];
    let bounded: fn(&mut Rules) = |rules| by(rules, BoundsBy::Clipped);
    let boxed: fn(&mut Rules) = |rules| rules.fill = Fill::Quarters(Quarters::Smallest(1));
    let alone: fn(&mut Rules) = |rules| rules.value_at = (0.5, 0.5);
    let bounded_alone: fn(&mut Rules) = |rules| {
        by(rules, BoundsBy::Clipped);
        rules.value_at = (0.5, 0.5);
    };
    let boxed_alone: fn(&mut Rules) = |rules| {
        rules.fill = Fill::Quarters(Quarters::Smallest(1));
        rules.value_at = (0.5, 0.5);
    };
    each_with(&shifts, &[|_| (), bounded, boxed, alone, bounded_alone, boxed_alone])
}

/// Mistakes of an edge table, with what follows where a span runs over the side of the picture, or stays where it should be.
fn scans() -> Vec<Mutant> {
    use super::spans::{FORGOTTEN, MUTANTS, NARROW, OPEN, SHORT, TWICE};
    let own = [
        mutant(FORGOTTEN, |rules| scan(rules, |scan| scan.slope = Slope::FirstRow)),
        mutant(SHORT, |rules| scan(rules, |scan| scan.edges = Edges::ShortLost)),
        mutant(SHORT, |rules| scan(rules, |scan| (scan.edges, scan.odd) = (Edges::ShortLost, Odd::RunsOn))),
        mutant(SHORT, |rules| scan(rules, |scan| (scan.edges, scan.odd) = (Edges::ShortLost, Odd::FromLeft))),
        mutant(OPEN, |rules| scan(rules, |scan| scan.edges = Edges::ClosedToSecond)),
        mutant(OPEN, |rules| scan(rules, |scan| (scan.edges, scan.odd) = (Edges::ClosedToSecond, Odd::RunsOn))),
        mutant(OPEN, |rules| scan(rules, |scan| (scan.edges, scan.odd) = (Edges::ClosedToSecond, Odd::FromLeft))),
        mutant(OPEN, |rules| scan(rules, |scan| scan.edges = Edges::FromFirst)),
        mutant(TWICE, |rules| scan(rules, |scan| scan.pairs = Pairs::Once)),
        mutant(TWICE, |rules| scan(rules, |scan| (scan.pairs, scan.odd) = (Pairs::Once, Odd::RunsOn))),
        mutant(NARROW, |rules| scan(rules, |scan| scan.edges = Edges::NarrowLost)),
        mutant(NARROW, |rules| scan(rules, |scan| (scan.edges, scan.odd) = (Edges::NarrowLost, Odd::RunsOn))),
    ];
    let all = [own.as_slice(), MUTANTS].concat();
    let spills: fn(&mut Rules) = |rules| scan(rules, |scan| scan.spills = true);
    let rightly: fn(&mut Rules) = |rules| scan(rules, |scan| scan.pairs = Pairs::Rightly);
    let both: fn(&mut Rules) = |rules| scan(rules, |scan| (scan.pairs, scan.spills) = (Pairs::Rightly, true));
    let sloped = |mutant: &&Mutant| matches!(mutant.applied_to(&Rules::default()).fill, Fill::Scan(scan) if scan.slope != Slope::Exact || scan.ahead != 0);
    let sloped: Vec<Mutant> = all.iter().filter(sloped).copied().collect();
    [own.to_vec(), each_with(&all, &[spills]), each_with(&sloped, &[rightly, both])].concat()
}

fn scan(rules: &mut Rules, change: fn(&mut Scan)) {
    let mut scan = if let Fill::Scan(scan) = rules.fill { scan } else { Scan::RIGHT };
    change(&mut scan);
    rules.fill = Fill::Scan(scan);
}

/// Slips of programs that follow beginnings and ends of polygons along a line.
fn events() -> Vec<Mutant> {
    vec![
        mutant(BEHIND, |rules| rules.line = LineSpans::NothingBehind),
        mutant(BEHIND, |rules| rules.line = LineSpans::NothingUntilNext),
        mutant(UNSORTED, |rules| rules.line = LineSpans::ListOrder),
        mutant(UNSORTED, |rules| rules.line = LineSpans::ListOrderOnward),
        mutant(LATEST, |rules| rules.line = LineSpans::LatestBegun),
    ]
}

const BEHIND: [&str; 4] = [
    "nothing behind what ends",
    "Where the polygon in front ends on a line, the background shows, not what was behind it.",
    "Keep all polygons of a span, and look for the nearest anew wherever one ends.",
    "docs/scanline.md",
];
const UNSORTED: [&str; 4] = [
    "crossings of polygons not sorted",
    "The crossings of a line are taken polygon by polygon, not from left to right.",
    "Sort the crossings of all polygons of a line by x.",
    "docs/scanline.md",
];
const LATEST: [&str; 4] = [
    "the latest begun shows",
    "Along a line the polygon that began last is shown, whatever its depth.",
    "Wherever a polygon begins or ends, look for the nearest of all that are there.",
    "docs/scanline.md",
];
