//! Mistakes about where samples land, and what is behind them.

use super::{Mutant, mutant};
use crate::grade::lines::rule::Shape;
use crate::grade::rules::{Border, Fill, Place};

const PAGE: &str = "docs/conventions.md";
const SHIFTED: [&str; 4] = [
    "picture moved by one",
    "The whole picture lies one sample beside its place.",
    "The first column and the first row are number 0.",
    PAGE,
];
pub(super) const BORDER: [&str; 4] = [
    "border of the picture left out",
    "The last or first column or row of the picture (or several of them) is never drawn.",
    "Columns are 0 to width - 1, rows 0 to height - 1, all included.",
    PAGE,
];
/// Also of rows that are as long as the picture is high.
pub(super) const SQUARE: [&str; 4] = [
    "square pictures only",
    "Width and height are taken for equal, or exchanged: right only where they are the same.",
    "Columns go to width - 1, rows to height - 1; a pixel stands at y * width + x.",
    PAGE,
];

pub(super) const MUTANTS: &[Mutant] = &[
    mutant(["nothing drawn", "No polygon is drawn.", "Put a fragment on every covered sample.", PAGE], |rules| {
        (rules.fill, rules.lines.shape) = (Fill::Nothing, Shape::Nothing)
    }),
    mutant(["upside down", "The picture is upside down.", "y runs down: row 0 is the uppermost.", PAGE], |rules| {
        rules.place = Place::UpsideDown
    }),
    mutant(
        ["mirrored", "Left and right are exchanged.", "x runs to the right: column 0 is the leftmost.", PAGE],
        |rules| rules.place = Place::Mirrored,
    ),
    mutant(
        ["turned by half", "The picture is turned by 180 degrees.", "Row 0 is on top, column 0 on the left.", PAGE],
        |rules| rules.place = Place::HalfTurn,
    ),
    mutant(
        ["x and y exchanged", "Rows and columns are exchanged.", "A pixel stands at y * width + x.", PAGE],
        |rules| rules.place = Place::Transposed,
    ),
    mutant(SHIFTED, |rules| rules.place = Place::OneRight),
    mutant(SHIFTED, |rules| rules.place = Place::OneLeft),
    mutant(SHIFTED, |rules| rules.place = Place::OneDown),
    mutant(SHIFTED, |rules| rules.place = Place::OneUp),
    mutant(SHIFTED, |rules| rules.place = Place::NextInMemory),
    mutant(SHIFTED, |rules| rules.place = Place::LastInMemory),
    mutant(BORDER, |rules| rules.border = Border::LastColumn),
    mutant(BORDER, |rules| rules.border = Border::LastRow),
    mutant(BORDER, |rules| rules.border = Border::LastBoth),
    mutant(BORDER, |rules| rules.border = Border::FirstColumn),
    mutant(BORDER, |rules| rules.border = Border::FirstRow),
    mutant(SQUARE, |rules| rules.border = Border::BeyondSquare),
    mutant(
        [
            "background ignored",
            "Samples without a polygon are black.",
            "Samples without a polygon show the sheet's background.",
            PAGE,
        ],
        |rules| rules.background = Some(0.0),
    ),
    mutant(
        [
            "white background",
            "Samples without a polygon are white.",
            "Samples without a polygon show the sheet's background.",
            PAGE,
        ],
        |rules| rules.background = Some(1.0),
    ),
];
