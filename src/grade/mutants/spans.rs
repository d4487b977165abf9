//! Mistakes of scan-line programs: span ends, slopes, crossings, the list of active edges.

use super::{Mutant, mutant};
use crate::grade::rules::Fill;
use crate::grade::scan::{Cut, Edges, Lost, Odd, Owns, Pairs, Scan, Slope};

const PAGE: &str = "docs/scanline.md";
const ENDS: [&str; 4] = [
    "span ends rounded",
    "The ends of a scan line's span are turned into columns the wrong way, or a column is lost or added.",
    "A span covers the columns from ceil(left - 0.5) up to, but not with, ceil(right - 0.5).",
    PAGE,
];
const NEVER_EMPTY: [&str; 4] = [
    "span ends rounded",
    "A span without a center shows one sample all the same.",
    "A span whose first column is its end column covers nothing.",
    PAGE,
];
const ROWS: [&str; 4] = [
    "scan lines at whole y",
    "Edges are crossed with the upper side of a row, y, not with the line through its centers, y + 0.5.",
    "Row y is crossed at y + 0.5; it is drawn when that lies at or below the top and above the bottom.",
    PAGE,
];
pub(super) const TWICE: [&str; 4] = [
    "corners on scan lines counted twice",
    "Where a corner lies exactly on a row's center line its edges are not counted as they should be (both, neither, or one of two), so parity is wrong.",
    "An edge owns its upper end and not its lower: top.y <= y < bottom.y.",
    PAGE,
];
const LEVEL: [&str; 4] = [
    "level edges counted",
    "Level edges count as crossings, so parity is wrong on the line they lie on.",
    "Level edges cross no scan line: leave them out.",
    PAGE,
];
pub(super) const SHORT: [&str; 4] = [
    "short edges lost",
    "Edges that are less than a row high are left out, as if they were level.",
    "An edge is left out when it crosses the center line of no row: its height does not matter.",
    PAGE,
];
pub(super) const NARROW: [&str; 4] = [
    "narrow edges lost",
    "Edges that are less than a column wide are left out, or taken for upright ones.",
    "Every edge that crosses the center line of a row counts, however steep.",
    PAGE,
];
pub(super) const FORGOTTEN: [&str; 4] = [
    "slope forgotten",
    "x of one end of an edge, or of its first line, is used on all its lines.",
    "On line y an edge is at x = top.x + (y + 0.5 - top.y) * dx / dy.",
    PAGE,
];
const WHOLE: [&str; 4] = [
    "slope is a whole number",
    "dx / dy is divided as whole numbers, or its remainder is not carried from line to line.",
    "Keep the fraction of dx / dy: as a remainder that is added up, or divide anew on every line.",
    PAGE,
];
const TURNED: [&str; 4] = [
    "slope turned over",
    "dy / dx is used for dx / dy, or its sign is wrong.",
    "From line to line x grows by dx / dy.",
    PAGE,
];
const STEP: [&str; 4] = [
    "first step of an edge forgotten",
    "x starts at the upper end of the edge, which lies above the center of its first row.",
    "On its first row an edge is at top.x + (row + 0.5 - top.y) * dx / dy.",
    PAGE,
];
const SUMMED: [&str; 4] = [
    "slope added up inexactly",
    "x is added up from line to line with a slope of too few bits, and drifts away.",
    "Add up quotient and remainder in whole numbers, or compute x anew on every line.",
    PAGE,
];
const AHEAD: [&str; 4] = [
    "edges stepped too early",
    "Edges are stepped before their line is drawn: x is one line ahead.",
    "Draw the line first, then step every edge to the next.",
    PAGE,
];
pub(super) const OPEN: [&str; 4] = [
    "an edge of the outline forgotten",
    "The edge from the last corner back to the first (or the first edge) is left out, or leads elsewhere.",
    "An outline is closed: the edge after the last corner leads to the first.",
    PAGE,
];
const ONE_WAY: [&str; 4] = [
    "edges of one direction left out",
    "Edges that run upward (or those that run downward) are left out.",
    "Exchange the ends of an edge that runs upward, and keep it.",
    PAGE,
];
const UNSORTED: [&str; 4] = [
    "crossings not sorted",
    "The crossings of a line are paired in the order of the outline or of an older line.",
    "Sort the crossings of every line by x before they are paired.",
    PAGE,
];
const PAIRS: [&str; 4] = [
    "convex outlines only",
    "Only two crossings of a line are used, or each with the next: right for convex polygons alone.",
    "Fill between the first and second crossing, the third and fourth, and so on.",
    PAGE,
];
const LATE: [&str; 4] = [
    "edges end late",
    "Edges stay active after their lower end: for a line, or for ever.",
    "Before a line is drawn take off every edge whose lower end is not below it.",
    PAGE,
];
const STARTS: [&str; 4] = [
    "edges start late",
    "Edges become active a line late, and the first line of each is lost.",
    "An edge becomes active on the first row whose center line is at or below its upper end.",
    PAGE,
];
const EARLY: [&str; 4] = [
    "edges end early",
    "Edges are taken off a line too early.",
    "An edge is active on every row whose center line is above its lower end.",
    PAGE,
];
const MIDDLE: [&str; 4] = [
    "a row at middle corners lost",
    "Where a polygon is cut at the height of a corner, the row there is drawn by neither part.",
    "Both parts use the same bounds: rows from ceil(upper - 0.5) up to, but not with, ceil(lower - 0.5).",
    PAGE,
];
const PART: [&str; 4] = [
    "part of a polygon lost",
    "Only the part above (or below) a middle corner is drawn.",
    "Draw all parts: from the uppermost corner to the middle one, and from there to the lowest.",
    PAGE,
];

pub(super) const MUTANTS: &[Mutant] = &[
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Floor(0.0), end: Cut::Floor(0.0), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Floor(0.0), end: Cut::Ceil(0.0), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Floor(0.0), end: Cut::Floor(1.0), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Floor(0.0), end: Cut::Floor(0.5), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Floor(0.0), end: Cut::Ceil(-0.5), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Floor(0.0), end: Cut::Ceil(1.0), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Floor(0.0), end: Cut::Floor(1.5), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Floor(0.0), end: Cut::Ceil(0.5), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Floor(0.0), end: Cut::Ceil(-1.5), ..Scan::RIGHT })),
    mutant(ENDS, |rules| {
        rules.fill = Fill::Scan(Scan { first: Cut::Floor(0.0), end: Cut::Floor(-0.5), ..Scan::RIGHT })
    }),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Ceil(0.0), end: Cut::Floor(0.0), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Ceil(0.0), end: Cut::Ceil(0.0), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Ceil(0.0), end: Cut::Floor(1.0), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Ceil(0.0), end: Cut::Floor(0.5), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Ceil(0.0), end: Cut::Ceil(-0.5), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Ceil(0.0), end: Cut::Ceil(1.0), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Ceil(0.0), end: Cut::Floor(1.5), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Ceil(0.0), end: Cut::Ceil(0.5), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Ceil(0.0), end: Cut::Ceil(-1.5), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Ceil(0.0), end: Cut::Floor(-0.5), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Floor(1.0), end: Cut::Floor(0.0), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Floor(1.0), end: Cut::Ceil(0.0), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Floor(1.0), end: Cut::Floor(1.0), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Floor(1.0), end: Cut::Floor(0.5), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Floor(1.0), end: Cut::Ceil(-0.5), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Floor(1.0), end: Cut::Ceil(1.0), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Floor(1.0), end: Cut::Floor(1.5), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Floor(1.0), end: Cut::Ceil(0.5), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Floor(1.0), end: Cut::Ceil(-1.5), ..Scan::RIGHT })),
    mutant(ENDS, |rules| {
        rules.fill = Fill::Scan(Scan { first: Cut::Floor(1.0), end: Cut::Floor(-0.5), ..Scan::RIGHT })
    }),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Floor(0.5), end: Cut::Floor(0.0), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Floor(0.5), end: Cut::Ceil(0.0), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Floor(0.5), end: Cut::Floor(1.0), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Floor(0.5), end: Cut::Ceil(1.0), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Floor(0.5), end: Cut::Floor(1.5), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Floor(0.5), end: Cut::Ceil(0.5), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Floor(0.5), end: Cut::Ceil(-1.5), ..Scan::RIGHT })),
    mutant(ENDS, |rules| {
        rules.fill = Fill::Scan(Scan { first: Cut::Floor(0.5), end: Cut::Floor(-0.5), ..Scan::RIGHT })
    }),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Ceil(-0.5), end: Cut::Floor(0.0), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Ceil(-0.5), end: Cut::Ceil(0.0), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Ceil(-0.5), end: Cut::Floor(1.0), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Ceil(-0.5), end: Cut::Ceil(1.0), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Ceil(-0.5), end: Cut::Floor(1.5), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Ceil(-0.5), end: Cut::Ceil(0.5), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Ceil(-0.5), end: Cut::Ceil(-1.5), ..Scan::RIGHT })),
    mutant(ENDS, |rules| {
        rules.fill = Fill::Scan(Scan { first: Cut::Ceil(-0.5), end: Cut::Floor(-0.5), ..Scan::RIGHT })
    }),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Ceil(0.5), end: Cut::Ceil(-0.5), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Ceil(-1.5), end: Cut::Ceil(-0.5), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Ceil(0.5), end: Cut::Ceil(0.5), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Ceil(0.5), end: Cut::Ceil(-1.5), ..Scan::RIGHT })),
    mutant(ENDS, |rules| rules.fill = Fill::Scan(Scan { first: Cut::Floor(1.5), end: Cut::Floor(0.5), ..Scan::RIGHT })),
    mutant(NEVER_EMPTY, |rules| rules.fill = Fill::Scan(Scan { is_never_empty: true, ..Scan::RIGHT })),
    mutant(ROWS, |rules| {
        rules.fill = Fill::Scan(Scan { row: 0.0, first: Cut::Ceil(-0.5), end: Cut::Ceil(-0.5), ..Scan::RIGHT })
    }),
    mutant(ROWS, |rules| {
        rules.fill = Fill::Scan(Scan { row: 0.0, first: Cut::Ceil(0.0), end: Cut::Ceil(0.0), ..Scan::RIGHT })
    }),
    mutant(ROWS, |rules| {
        rules.fill = Fill::Scan(Scan { row: 0.0, first: Cut::Floor(0.0), end: Cut::Floor(0.0), ..Scan::RIGHT })
    }),
    mutant(ROWS, |rules| {
        rules.fill = Fill::Scan(Scan { row: 0.0, first: Cut::Floor(0.0), end: Cut::Floor(1.0), ..Scan::RIGHT })
    }),
    mutant(ROWS, |rules| {
        rules.fill = Fill::Scan(Scan { row: 0.0, first: Cut::Floor(0.5), end: Cut::Floor(1.5), ..Scan::RIGHT })
    }),
    mutant(ROWS, |rules| {
        rules.fill = Fill::Scan(Scan { row: 0.0, first: Cut::Floor(0.0), end: Cut::Ceil(0.0), ..Scan::RIGHT })
    }),
    mutant(ROWS, |rules| {
        rules.fill = Fill::Scan(Scan { row: 0.0, first: Cut::Ceil(0.0), end: Cut::Floor(1.0), ..Scan::RIGHT })
    }),
    mutant(ROWS, |rules| rules.fill = Fill::Scan(Scan { row: 1.0, ..Scan::RIGHT })),
    mutant(TWICE, |rules| rules.fill = Fill::Scan(Scan { owns: Owns::Both, odd: Odd::Dropped, ..Scan::RIGHT })),
    mutant(TWICE, |rules| rules.fill = Fill::Scan(Scan { owns: Owns::Neither, odd: Odd::Dropped, ..Scan::RIGHT })),
    mutant(LEVEL, |rules| rules.fill = Fill::Scan(Scan { owns: Owns::Level, odd: Odd::Dropped, ..Scan::RIGHT })),
    mutant(OPEN, |rules| rules.fill = Fill::Scan(Scan { edges: Edges::LastLost, odd: Odd::Dropped, ..Scan::RIGHT })),
    mutant(OPEN, |rules| rules.fill = Fill::Scan(Scan { edges: Edges::FirstLost, odd: Odd::Dropped, ..Scan::RIGHT })),
    mutant(LATE, |rules| rules.fill = Fill::Scan(Scan { ends_late: 1, odd: Odd::Dropped, ..Scan::RIGHT })),
    mutant(LATE, |rules| rules.fill = Fill::Scan(Scan { ends_late: i32::MAX, odd: Odd::Dropped, ..Scan::RIGHT })),
    mutant(STARTS, |rules| rules.fill = Fill::Scan(Scan { starts_late: 1, odd: Odd::Dropped, ..Scan::RIGHT })),
    mutant(EARLY, |rules| rules.fill = Fill::Scan(Scan { ends_late: -1, odd: Odd::Dropped, ..Scan::RIGHT })),
    mutant(TWICE, |rules| rules.fill = Fill::Scan(Scan { owns: Owns::Both, odd: Odd::RunsOn, ..Scan::RIGHT })),
    mutant(TWICE, |rules| rules.fill = Fill::Scan(Scan { owns: Owns::Neither, odd: Odd::RunsOn, ..Scan::RIGHT })),
    mutant(LEVEL, |rules| rules.fill = Fill::Scan(Scan { owns: Owns::Level, odd: Odd::RunsOn, ..Scan::RIGHT })),
    mutant(OPEN, |rules| rules.fill = Fill::Scan(Scan { edges: Edges::LastLost, odd: Odd::RunsOn, ..Scan::RIGHT })),
    mutant(OPEN, |rules| rules.fill = Fill::Scan(Scan { edges: Edges::FirstLost, odd: Odd::RunsOn, ..Scan::RIGHT })),
    mutant(ONE_WAY, |rules| {
        rules.fill = Fill::Scan(Scan { edges: Edges::UpwardLost, odd: Odd::RunsOn, ..Scan::RIGHT })
    }),
    mutant(ONE_WAY, |rules| {
        rules.fill = Fill::Scan(Scan { edges: Edges::DownwardLost, odd: Odd::RunsOn, ..Scan::RIGHT })
    }),
    mutant(LATE, |rules| rules.fill = Fill::Scan(Scan { ends_late: 1, odd: Odd::RunsOn, ..Scan::RIGHT })),
    mutant(LATE, |rules| rules.fill = Fill::Scan(Scan { ends_late: i32::MAX, odd: Odd::RunsOn, ..Scan::RIGHT })),
    mutant(STARTS, |rules| rules.fill = Fill::Scan(Scan { starts_late: 1, odd: Odd::RunsOn, ..Scan::RIGHT })),
    mutant(EARLY, |rules| rules.fill = Fill::Scan(Scan { ends_late: -1, odd: Odd::RunsOn, ..Scan::RIGHT })),
    mutant(TWICE, |rules| rules.fill = Fill::Scan(Scan { owns: Owns::Both, odd: Odd::FromLeft, ..Scan::RIGHT })),
    mutant(TWICE, |rules| rules.fill = Fill::Scan(Scan { owns: Owns::Neither, odd: Odd::FromLeft, ..Scan::RIGHT })),
    mutant(LEVEL, |rules| rules.fill = Fill::Scan(Scan { owns: Owns::Level, odd: Odd::FromLeft, ..Scan::RIGHT })),
    mutant(OPEN, |rules| rules.fill = Fill::Scan(Scan { edges: Edges::LastLost, odd: Odd::FromLeft, ..Scan::RIGHT })),
    mutant(OPEN, |rules| rules.fill = Fill::Scan(Scan { edges: Edges::FirstLost, odd: Odd::FromLeft, ..Scan::RIGHT })),
    mutant(ONE_WAY, |rules| {
        rules.fill = Fill::Scan(Scan { edges: Edges::UpwardLost, odd: Odd::FromLeft, ..Scan::RIGHT })
    }),
    mutant(ONE_WAY, |rules| {
        rules.fill = Fill::Scan(Scan { edges: Edges::DownwardLost, odd: Odd::FromLeft, ..Scan::RIGHT })
    }),
    mutant(LATE, |rules| rules.fill = Fill::Scan(Scan { ends_late: 1, odd: Odd::FromLeft, ..Scan::RIGHT })),
    mutant(LATE, |rules| rules.fill = Fill::Scan(Scan { ends_late: i32::MAX, odd: Odd::FromLeft, ..Scan::RIGHT })),
    mutant(STARTS, |rules| rules.fill = Fill::Scan(Scan { starts_late: 1, odd: Odd::FromLeft, ..Scan::RIGHT })),
    mutant(EARLY, |rules| rules.fill = Fill::Scan(Scan { ends_late: -1, odd: Odd::FromLeft, ..Scan::RIGHT })),
    mutant(FORGOTTEN, |rules| rules.fill = Fill::Scan(Scan { slope: Slope::UpperEnd, ..Scan::RIGHT })),
    mutant(FORGOTTEN, |rules| rules.fill = Fill::Scan(Scan { slope: Slope::LowerEnd, ..Scan::RIGHT })),
    mutant(WHOLE, |rules| rules.fill = Fill::Scan(Scan { slope: Slope::Cut, ..Scan::RIGHT })),
    mutant(WHOLE, |rules| rules.fill = Fill::Scan(Scan { slope: Slope::Down, ..Scan::RIGHT })),
    mutant(WHOLE, |rules| rules.fill = Fill::Scan(Scan { slope: Slope::Rounded, ..Scan::RIGHT })),
    mutant(TURNED, |rules| rules.fill = Fill::Scan(Scan { slope: Slope::TurnedOver, ..Scan::RIGHT })),
    mutant(TURNED, |rules| rules.fill = Fill::Scan(Scan { slope: Slope::Reversed, ..Scan::RIGHT })),
    mutant(STEP, |rules| rules.fill = Fill::Scan(Scan { slope: Slope::FromEnd, ..Scan::RIGHT })),
    mutant(STEP, |rules| rules.fill = Fill::Scan(Scan { slope: Slope::FromRow, ..Scan::RIGHT })),
    mutant(SUMMED, |rules| rules.fill = Fill::Scan(Scan { slope: Slope::Summed(4.0, true, false), ..Scan::RIGHT })),
    mutant(SUMMED, |rules| rules.fill = Fill::Scan(Scan { slope: Slope::Summed(4.0, false, false), ..Scan::RIGHT })),
    mutant(SUMMED, |rules| rules.fill = Fill::Scan(Scan { slope: Slope::Summed(8.0, true, false), ..Scan::RIGHT })),
    mutant(SUMMED, |rules| rules.fill = Fill::Scan(Scan { slope: Slope::Summed(8.0, false, false), ..Scan::RIGHT })),
    mutant(SUMMED, |rules| rules.fill = Fill::Scan(Scan { slope: Slope::Summed(10.0, true, false), ..Scan::RIGHT })),
    mutant(SUMMED, |rules| rules.fill = Fill::Scan(Scan { slope: Slope::Summed(10.0, false, false), ..Scan::RIGHT })),
    mutant(SUMMED, |rules| rules.fill = Fill::Scan(Scan { slope: Slope::Summed(16.0, true, false), ..Scan::RIGHT })),
    mutant(SUMMED, |rules| rules.fill = Fill::Scan(Scan { slope: Slope::Summed(16.0, false, false), ..Scan::RIGHT })),
    mutant(SUMMED, |rules| rules.fill = Fill::Scan(Scan { slope: Slope::Summed(32.0, true, false), ..Scan::RIGHT })),
    mutant(SUMMED, |rules| rules.fill = Fill::Scan(Scan { slope: Slope::Summed(32.0, false, false), ..Scan::RIGHT })),
    mutant(SUMMED, |rules| rules.fill = Fill::Scan(Scan { slope: Slope::Summed(64.0, true, false), ..Scan::RIGHT })),
    mutant(SUMMED, |rules| rules.fill = Fill::Scan(Scan { slope: Slope::Summed(64.0, false, false), ..Scan::RIGHT })),
    mutant(SUMMED, |rules| rules.fill = Fill::Scan(Scan { slope: Slope::Summed(100.0, true, false), ..Scan::RIGHT })),
    mutant(SUMMED, |rules| rules.fill = Fill::Scan(Scan { slope: Slope::Summed(100.0, false, false), ..Scan::RIGHT })),
    mutant(SUMMED, |rules| rules.fill = Fill::Scan(Scan { slope: Slope::Summed(128.0, true, false), ..Scan::RIGHT })),
    mutant(SUMMED, |rules| rules.fill = Fill::Scan(Scan { slope: Slope::Summed(128.0, false, false), ..Scan::RIGHT })),
    mutant(SUMMED, |rules| rules.fill = Fill::Scan(Scan { slope: Slope::Summed(256.0, true, false), ..Scan::RIGHT })),
    mutant(SUMMED, |rules| rules.fill = Fill::Scan(Scan { slope: Slope::Summed(256.0, false, false), ..Scan::RIGHT })),
    mutant(SUMMED, |rules| rules.fill = Fill::Scan(Scan { slope: Slope::Summed(16.0, true, true), ..Scan::RIGHT })),
    mutant(SUMMED, |rules| rules.fill = Fill::Scan(Scan { slope: Slope::Summed(64.0, true, true), ..Scan::RIGHT })),
    mutant(SUMMED, |rules| rules.fill = Fill::Scan(Scan { slope: Slope::Summed(256.0, true, true), ..Scan::RIGHT })),
    mutant(AHEAD, |rules| rules.fill = Fill::Scan(Scan { ahead: 1, ..Scan::RIGHT })),
    mutant(UNSORTED, |rules| rules.fill = Fill::Scan(Scan { pairs: Pairs::Unsorted, ..Scan::RIGHT })),
    mutant(UNSORTED, |rules| rules.fill = Fill::Scan(Scan { pairs: Pairs::KeptOrder, ..Scan::RIGHT })),
    mutant(PAIRS, |rules| rules.fill = Fill::Scan(Scan { pairs: Pairs::FirstOnly, ..Scan::RIGHT })),
    mutant(PAIRS, |rules| rules.fill = Fill::Scan(Scan { pairs: Pairs::LastOnly, ..Scan::RIGHT })),
    mutant(PAIRS, |rules| rules.fill = Fill::Scan(Scan { pairs: Pairs::Overlapping, ..Scan::RIGHT })),
    mutant(MIDDLE, |rules| rules.fill = Fill::Scan(Scan { lost: Lost::BelowMiddle, ..Scan::RIGHT })),
    mutant(MIDDLE, |rules| rules.fill = Fill::Scan(Scan { lost: Lost::AboveMiddle, ..Scan::RIGHT })),
    mutant(PART, |rules| rules.fill = Fill::Scan(Scan { lost: Lost::LowerPart, ..Scan::RIGHT })),
    mutant(PART, |rules| rules.fill = Fill::Scan(Scan { lost: Lost::UpperPart, ..Scan::RIGHT })),
];
