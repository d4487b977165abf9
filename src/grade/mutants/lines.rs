//! Mistakes about lines: which edges are drawn, from where to where, and which samples they show.
//!
//! A slip in stepping is tried with every common way to treat the ends of a line: which of them a program has is no part of the
//! slip, and they share its name.

use super::{Mutant, mutant};
use crate::grade::lines::rule::{
    Around, Ask, At, Axis, Backward, Ends, Faces, Ink, Lost, Pen, Shape, Slope, Step, StepEnds, Walk, When,
};

const PAGE: &str = "docs/conventions.md";
const DIAMOND: &str = "A line shows the samples whose diamond |dx| + |dy| < 1/2 it leaves.";
const CENTERS: &str = "Ask for the row where the line passes the middle of the column, and cut it to a whole number.";
const ONCE: &str =
    "Every edge of an outline is drawn once, from each corner to the next and from the last to the first.";

const WHOLE: [&str; 4] = [
    "line ends made whole",
    "Line ends are made whole (cut or rounded) before the line is stepped.",
    "A line shows the samples whose diamond |dx| + |dy| < 1/2 it leaves; ends lie between samples.",
    PAGE,
];
const LAST: [&str; 4] = [
    "last sample of lines drawn",
    "A line shows the sample it ends in, which belongs to the next line.",
    "A line shows the samples whose diamond it leaves, not the one it ends in.",
    PAGE,
];
const ENDS_DRAWN: [&str; 4] = [
    "end samples always drawn",
    "The samples that hold the ends of a line are drawn even where the line does not leave their diamonds.",
    DIAMOND,
    PAGE,
];
const ENDS_LOST: [&str; 4] = [
    "end samples left out",
    "The samples at the ends of a line are left out, at the start as well as at the end.",
    DIAMOND,
    PAGE,
];
const MIDDLES: [&str; 4] = [
    "line ends cut at columns",
    "A line begins and ends where it passes the middle of a column, not where it leaves a diamond.",
    DIAMOND,
    PAGE,
];
const TRIMMED: [&str; 4] = [
    "first or last column of lines lost",
    "The first or last column (or row) of every line is lost.",
    "Step from the first column to the last, both included, and ask for the diamonds at the ends.",
    PAGE,
];
const SIZE: [&str; 4] = [
    "diamonds of another size",
    "The diamond around a center is larger or smaller than |dx| + |dy| < 1/2.",
    DIAMOND,
    PAGE,
];
const SQUARE: [&str; 4] = [
    "squares for diamonds",
    "A square is used for the diamond: every sample that the line touches is shown.",
    DIAMOND,
    PAGE,
];
const CIRCLE: [&str; 4] =
    ["distance for diamonds", "Every sample nearer to the line than a fixed distance is shown.", DIAMOND, PAGE];
const AT_CORNER: [&str; 4] = [
    "samples at the corner",
    "Centers of samples are taken for their corners (x, y).",
    "The center is (x + 1/2, y + 1/2).",
    PAGE,
];
const AT_FAR_CORNER: [&str; 4] = [
    "samples at the far corner",
    "Centers of samples are taken for their corners (x + 1, y + 1).",
    "The center is (x + 1/2, y + 1/2).",
    PAGE,
];
const HALF_BESIDE: [&str; 4] = [
    "samples half beside the center",
    "The center of a sample is half a sample beside its place, in x or in y.",
    "The center is (x + 1/2, y + 1/2).",
    PAGE,
];
const GAPS: [&str; 4] = [
    "steep lines with gaps",
    "Lines are stepped along x only, so steep ones have gaps.",
    "Step along the longer direction.",
    PAGE,
];
const FLAT_GAPS: [&str; 4] = [
    "shallow lines with gaps",
    "Lines are stepped along y only, so shallow ones have gaps.",
    "Step along the longer direction.",
    PAGE,
];
const EXCHANGED: [&str; 4] = [
    "steep test turned round",
    "Steep lines are stepped along x and shallow ones along y: all have gaps.",
    "Step along the longer direction.",
    PAGE,
];
const WHOLE_SLOPE: [&str; 4] = [
    "slope made whole",
    "The slope of a line is a whole number: dy / dx loses its fraction.",
    "Divide as floating point numbers, or keep the remainder.",
    PAGE,
];
const SIGN: [&str; 4] = [
    "sign of the slope lost",
    "The slope has always the same sign: lines that should rise fall, or the other way round.",
    "The slope is (y2 - y1) / (x2 - x1), with its sign.",
    PAGE,
];
const OPPOSITE: [&str; 4] = [
    "slope reversed",
    "The slope has the wrong sign: lines that should rise fall, and those that should fall rise.",
    "The slope is (y2 - y1) / (x2 - x1).",
    PAGE,
];
const TURNED: [&str; 4] =
    ["slope turned over", "The slope is dx / dy for dy / dx.", "A row is passed on by dy / dx for every column.", PAGE];
const DIAGONAL: [&str; 4] = [
    "all lines at 45 degrees",
    "Every step goes a row further: the error term is never set back.",
    "Take a whole row off the error when the row changes.",
    PAGE,
];
const NO_SLOPE: [&str; 4] = [
    "slope forgotten",
    "All samples of a line are in the row of its start: the slope is not used.",
    "The row grows by dy / dx for every column.",
    PAGE,
];
const HALVED: [&str; 4] =
    ["slope halved", "The row grows by half of what it should.", "The row grows by dy / dx for every column.", PAGE];
const ROUNDED: [&str; 4] = [
    "rows of lines rounded",
    "Rows of lines (columns of steep ones) are rounded where they should be cut: half a sample beside.",
    CENTERS,
    PAGE,
];
const BESIDE: [&str; 4] =
    ["rows of lines one beside", "Rows of lines (columns of steep ones) are one too high or too low.", CENTERS, PAGE];
const ERROR: [&str; 4] = [
    "error term starts wrong",
    "The error of a line starts at the wrong value: rows change half a sample too late or too early.",
    "Rows change where the line is halfway between two centers.",
    PAGE,
];
const FROM_END: [&str; 4] = [
    "lines stepped from their ends",
    "Rows are asked for beside the middle of columns: stepping starts at the end of the line, or at a side of the column.",
    CENTERS,
    PAGE,
];
const DIRECTION: [&str; 4] = [
    "lines of one direction lost",
    "Lines that run one way (to the left, up, right or down) are lost.",
    "Outlines run in all directions: step from the smaller column to the larger, whichever end that is.",
    PAGE,
];
const UNSIGNED: [&str; 4] = [
    "direction of steps lost",
    "Lines that should run to the left (or up) are drawn to the right (or down).",
    "The step along a line has the sign of its extent, in x and in y.",
    PAGE,
];
const HALVES: [&str; 4] = [
    "ends exchanged by halves",
    "Where the ends of a line are exchanged only x (or only y) is: it is drawn mirrored.",
    "Exchange both coordinates of the ends, or none.",
    PAGE,
];
const NOT_BACK: [&str; 4] = [
    "steep lines not turned back",
    "x and y are exchanged to step along a steep line, and not exchanged again where samples are put.",
    "Whatever was exchanged for stepping is exchanged again for the sample.",
    PAGE,
];
const ONLY_TRIANGLES: [&str; 4] = [
    "triangles only",
    "Only polygons with three corners are drawn.",
    "A polygon may have any number of corners.",
    PAGE,
];
const NO_TRIANGLES: [&str; 4] =
    ["triangles lost", "Polygons with three corners are not drawn.", "A polygon has three corners or more.", PAGE];
const THRESHOLD: [&str; 4] = [
    "test for bright backgrounds wrong",
    "Another test than red + green + blue > 1.5 decides that lines are black.",
    "Lines are black where red + green + blue of the background is above 1.5.",
    PAGE,
];
const LEVEL: [&str; 4] = ["level lines lost", "Horizontal lines are lost.", "A line may have dy = 0.", PAGE];
const UPRIGHT: [&str; 4] = ["upright lines lost", "Vertical lines are lost.", "A line may have dx = 0.", PAGE];
const STRAIGHT: [&str; 4] = [
    "level and upright lines lost",
    "Horizontal and vertical lines are lost.",
    "A line may have dx = 0 or dy = 0.",
    PAGE,
];
const NO_DIAGONAL: [&str; 4] =
    ["diagonal lines lost", "Lines at 45 degrees are lost.", "A line may have |dx| = |dy|.", PAGE];
const STEEP: [&str; 4] =
    ["steep lines lost", "Steep lines are lost.", "A line with |dy| > |dx| is stepped along y.", PAGE];
const SHALLOW: [&str; 4] =
    ["shallow lines lost", "Shallow lines are lost.", "A line with |dx| > |dy| is stepped along x.", PAGE];
const LEANING: [&str; 4] = [
    "rising or falling lines lost",
    "Of the lines that rise to the right and those that fall, one kind is lost.",
    "The slope may have either sign.",
    PAGE,
];
const OPEN: [&str; 4] = ["outline not closed", "The first or the last edge of an outline is missing.", ONCE, PAGE];
const ONE_EDGE: [&str; 4] = ["an edge missing", "One edge of an outline that is not its last is missing.", ONCE, PAGE];
const FIRST_EDGE: [&str; 4] = ["first edge only", "Only the first edge of an outline is drawn.", ONCE, PAGE];
const OTHER: [&str; 4] = ["every other edge", "Every other edge is drawn, as if corners came in pairs.", ONCE, PAGE];
const STAR: [&str; 4] = ["edges from the first corner", "All edges start (or end) at the first corner.", ONCE, PAGE];
const SKIPPING: [&str; 4] = ["edges to the next but one", "Edges go to the next corner but one.", ONCE, PAGE];
const TRIANGLE: [&str; 4] =
    ["edges of the first triangle only", "Only the first three corners have edges.", ONCE, PAGE];
const FAN: [&str; 4] =
    ["inner edges drawn", "Outlines are cut into triangles, and the cuts are drawn as well.", ONCE, PAGE];
const BOUNDS: [&str; 4] = ["boxes for outlines", "The sides of the bounding box are drawn.", ONCE, PAGE];
const BOX: [&str; 4] = ["boxes filled", "The whole bounding box is filled.", "Draw the edges only.", PAGE];
const FILLED: [&str; 4] = ["filled, not outlined", "Polygons are filled.", "Draw the edges only.", PAGE];
const CORNERS: [&str; 4] = ["corners only", "Only the samples that hold a corner are drawn.", ONCE, PAGE];
const FIRST_FACE: [&str; 4] = [
    "first polygon lost",
    "The first polygon of the list is not drawn.",
    "The list goes from 0 to its length - 1.",
    PAGE,
];
const LAST_FACE: [&str; 4] = [
    "last polygon lost",
    "The last polygon of the list is not drawn.",
    "The list goes from 0 to its length - 1.",
    PAGE,
];
const ONE_FACE: [&str; 4] =
    ["one polygon only", "Only one polygon of the list is drawn.", "The list goes from 0 to its length - 1.", PAGE];
const WIDE: [&str; 4] = ["lines too wide", "Lines are two or three samples wide.", DIAMOND, PAGE];
const DASHED: [&str; 4] =
    ["lines dashed", "Lines leave samples out: only every second or third is drawn.", "Step by one sample.", PAGE];
const DIM: [&str; 4] = [
    "light of lines wrong",
    "Lines have not their full light, or not in all channels.",
    "Lines are white on a dark background and black on a bright one.",
    PAGE,
];
const ONE_INK: [&str; 4] = [
    "lines always white",
    "Lines are white (or gray) on every background, on a bright one, too.",
    "Lines are black where red + green + blue of the background is above 1.5.",
    PAGE,
];
const BLACK_INK: [&str; 4] = [
    "lines black for white",
    "Lines are black where they should be white.",
    "Lines are black where red + green + blue of the background is above 1.5, and white elsewhere.",
    PAGE,
];
const EXCLUSIVE: [&str; 4] = [
    "samples of two lines erased",
    "A sample that two lines show is empty again: lines are drawn by exclusive or.",
    "A sample is shown when any line shows it.",
    PAGE,
];

/// A slip in stepping with every common treatment of the ends.
macro_rules! stepped {
    ($words:expr, $($field:ident : $value:expr),+) => {
        stepped!(@ $words, ($($field: $value),+), Diamonds, RightDiamonds, All, AllOfLong, NotLast, Middles, MiddlesClosed)
    };
    (@ $words:expr, $fields:tt, $($ends:ident),+) => {
        [$(stepped!(= $words, $fields, $ends)),+]
    };
    (= $words:expr, ($($field:ident : $value:expr),+), $ends:ident) => {
        mutant($words, |rules| {
            rules.lines.walk = Walk::Step(Step { $($field: $value,)+ ends: StepEnds::$ends, ..Step::RIGHT });
        })
    };
}

/// A mistake that is one field of the line rules, each value a mutant.
macro_rules! simple {
    ($words:expr, $field:ident = $($value:expr),+) => {
        &[$(mutant($words, |rules| rules.lines.$field = $value)),+]
    };
}

/// Ends made whole: what the ends become, and which of the columns are shown.
macro_rules! whole {
    ($($ends:expr => $walk:expr),+ $(,)?) => {
        [$(mutant(WHOLE, |rules| (rules.lines.ends, rules.lines.walk) = ($ends, $walk))),+]
    };
}

const fn ends(ends: StepEnds) -> Walk {
    Walk::Step(Step { ends, ..Step::RIGHT })
}

const fn asked(around: Around, half: f64, when: When) -> Walk {
    Walk::Ask(Ask { around, half, when })
}

const WHOLE_ENDS: &[Mutant] = &whole![
    Ends::Center(0.0) => ends(StepEnds::All),
    Ends::Center(0.0) => ends(StepEnds::AllOfLong),
    Ends::Center(0.0) => ends(StepEnds::NotLast),
    Ends::Center(0.0) => ends(StepEnds::NotFirst),
    Ends::Center(0.0) => ends(StepEnds::Neither),
    Ends::Center(0.5) => ends(StepEnds::All),
    Ends::Center(0.5) => ends(StepEnds::NotLast),
    Ends::Center(0.5) => ends(StepEnds::Neither),
    Ends::Center(1.0) => ends(StepEnds::All),
    Ends::Center(1.0) => ends(StepEnds::NotLast),
    Ends::Center(0.0) => ends(StepEnds::Middles),
    Ends::Center(0.5) => ends(StepEnds::AllOfLong),
    Ends::CenterX(0.0) => ends(StepEnds::Diamonds),
    Ends::CenterX(0.0) => ends(StepEnds::All),
    Ends::CenterY(0.0) => ends(StepEnds::Diamonds),
    Ends::CenterY(0.0) => ends(StepEnds::All),
    Ends::Whole(0.0) => Walk::Ask(Ask::RIGHT),
    Ends::Whole(0.5) => Walk::Ask(Ask::RIGHT),
    Ends::Whole(1.0) => Walk::Ask(Ask::RIGHT),
    Ends::Whole(0.0) => ends(StepEnds::Diamonds),
    Ends::Whole(0.5) => ends(StepEnds::Diamonds),
    Ends::Whole(0.0) => ends(StepEnds::All),
    Ends::Whole(0.5) => ends(StepEnds::All),
];

const SLOPES: [&[Mutant]; 16] = [
    &stepped!(GAPS, axis: Axis::X),
    &stepped!(FLAT_GAPS, axis: Axis::Y),
    &stepped!(EXCHANGED, axis: Axis::Shorter),
    &stepped!(WHOLE_SLOPE, slope: Slope::Cut),
    &stepped!(WHOLE_SLOPE, slope: Slope::Down),
    &stepped!(WHOLE_SLOPE, slope: Slope::Rounded),
    &stepped!(SIGN, slope: Slope::Positive),
    &stepped!(SIGN, slope: Slope::Positive, from_left: true),
    &stepped!(SIGN, slope: Slope::Negative),
    &stepped!(SIGN, slope: Slope::Negative, from_left: true),
    &stepped!(OPPOSITE, slope: Slope::Opposite),
    &stepped!(OPPOSITE, slope: Slope::Opposite, from_left: true),
    &stepped!(TURNED, slope: Slope::TurnedOver),
    &stepped!(TURNED, slope: Slope::TurnedOver, from_left: true),
    &stepped!(DIAGONAL, slope: Slope::One),
    &stepped!(NO_SLOPE, slope: Slope::Zero),
];

const ROWS: [&[Mutant]; 16] = [
    &stepped!(NOT_BACK, axis: Axis::NotTurnedBack),
    &stepped!(WHOLE, slope: Slope::OfWholeEnds),
    &stepped!(WHOLE_SLOPE, slope: Slope::Cut, from_left: true),
    &stepped!(DIAGONAL, slope: Slope::One, from_left: true),
    &stepped!(NO_SLOPE, slope: Slope::Zero, from_left: true),
    &stepped!(HALVED, slope: Slope::Half),
    &stepped!(ROUNDED, shift: 0.5),
    &stepped!(ROUNDED, shift: -0.5),
    &stepped!(BESIDE, shift: 1.0),
    &stepped!(BESIDE, shift: -1.0),
    &stepped!(ERROR, lead: 0.5),
    &stepped!(ERROR, lead: -0.5),
    &stepped!(FROM_END, at: At::Start),
    &stepped!(FROM_END, at: At::Start, from_left: true),
    &stepped!(FROM_END, at: At::Part(0.0)),
    &stepped!(FROM_END, at: At::Part(1.0)),
];

const ENDS: [&[Mutant]; 8] = [
    WHOLE_ENDS,
    &[
        mutant(LAST, |rules| rules.lines.walk = asked(Around::Diamond, 0.5, When::Touches)),
        mutant(ENDS_LOST, |rules| rules.lines.walk = asked(Around::Diamond, 0.5, When::Crosses)),
    ],
    simple!(
        ENDS_DRAWN,
        walk = ends(StepEnds::All),
        ends(StepEnds::AllOfLong),
        ends(StepEnds::NotFirst),
        ends(StepEnds::NotLast)
    ),
    simple!(ENDS_LOST, walk = ends(StepEnds::Neither)),
    simple!(ENDS_LOST, pen = Pen::Trimmed(1, 1), Pen::Trimmed(1, 0), Pen::Trimmed(0, 1)),
    simple!(MIDDLES, walk = ends(StepEnds::Middles), ends(StepEnds::MiddlesClosed)),
    simple!(
        FROM_END,
        walk = Walk::Share { more: 0.0, shift: 0.0, last: true },
        Walk::Share { more: 0.0, shift: 0.0, last: false },
        Walk::Share { more: 0.5, shift: 0.0, last: true },
        Walk::Share { more: 0.5, shift: 0.0, last: false },
        Walk::Share { more: 1.0, shift: 0.0, last: true },
        Walk::Share { more: 1.0, shift: 0.0, last: false }
    ),
    &[
        mutant(TRIMMED, |rules| rules.lines.walk = Walk::Step(Step { trim: (0, 1), ..Step::RIGHT })),
        mutant(TRIMMED, |rules| rules.lines.walk = Walk::Step(Step { trim: (1, 0), ..Step::RIGHT })),
    ],
];

const DIAMONDS: [&[Mutant]; 7] = [
    simple!(
        SIZE,
        walk = asked(Around::Diamond, 0.25, When::Leaves),
        asked(Around::Diamond, 0.25, When::Touches),
        asked(Around::Diamond, 0.35, When::Leaves),
        asked(Around::Diamond, 0.7, When::Leaves),
        asked(Around::Diamond, 0.75, When::Leaves),
        asked(Around::Diamond, 1.0, When::Leaves),
        asked(Around::Diamond, 1.0, When::Touches)
    ),
    simple!(
        SQUARE,
        walk = asked(Around::Square, 0.5, When::Leaves),
        asked(Around::Square, 0.5, When::Touches),
        asked(Around::Square, 0.5, When::Enters),
        asked(Around::Square, 0.25, When::Leaves),
        asked(Around::Square, 1.0, When::Leaves)
    ),
    simple!(
        CIRCLE,
        walk = asked(Around::Circle, 0.5, When::Touches),
        asked(Around::Circle, 0.5, When::Leaves),
        asked(Around::Circle, 0.7, When::Touches),
        asked(Around::Circle, 1.0, When::Touches),
        asked(Around::Circle, 0.25, When::Touches)
    ),
    simple!(AT_CORNER, ends = Ends::Moved(0.5, 0.5)),
    simple!(AT_FAR_CORNER, ends = Ends::Moved(-0.5, -0.5)),
    simple!(
        HALF_BESIDE,
        ends = Ends::Moved(0.5, 0.0),
        Ends::Moved(0.0, 0.5),
        Ends::Moved(-0.5, 0.0),
        Ends::Moved(0.0, -0.5)
    ),
    simple!(
        ROUNDED,
        walk = Walk::Share { more: 0.5, shift: 0.5, last: true },
        Walk::Share { more: 0.5, shift: 0.5, last: false }
    ),
];

const LOST: [&[Mutant]; 10] = [
    simple!(UNSIGNED, ends = Ends::Unsigned(true, true), Ends::Unsigned(true, false), Ends::Unsigned(false, true)),
    simple!(
        HALVES,
        ends = Ends::HalfExchanged(Backward::Left),
        Ends::HalfExchanged(Backward::Up),
        Ends::HalfExchanged(Backward::Along)
    ),
    simple!(
        DIRECTION,
        lost = Lost::Left,
        Lost::Right,
        Lost::Up,
        Lost::Down,
        Lost::Backward,
        Lost::Forward,
        Lost::LeftOrUp,
        Lost::LeftAndUp,
        Lost::SteepUp,
        Lost::SteepDown,
        Lost::ShallowLeft,
        Lost::ShallowRight
    ),
    simple!(LEVEL, lost = Lost::Level),
    simple!(UPRIGHT, lost = Lost::Upright),
    simple!(STRAIGHT, lost = Lost::Straight),
    simple!(NO_DIAGONAL, lost = Lost::Diagonal),
    simple!(STEEP, lost = Lost::Steep),
    simple!(SHALLOW, lost = Lost::Shallow),
    simple!(LEANING, lost = Lost::Rising, Lost::Falling),
];

const SHAPES: [&[Mutant]; 17] = [
    simple!(ONLY_TRIANGLES, shape = Shape::TrianglesOnly),
    simple!(NO_TRIANGLES, shape = Shape::TrianglesLost),
    simple!(OPEN, shape = Shape::LastLost, Shape::FirstLost),
    simple!(ONE_EDGE, shape = Shape::SecondLost),
    simple!(FIRST_EDGE, shape = Shape::FirstAlone),
    simple!(OTHER, shape = Shape::Even, Shape::Odd),
    simple!(STAR, shape = Shape::FromFirst, Shape::ToFirst),
    simple!(SKIPPING, shape = Shape::Skipping),
    simple!(TRIANGLE, shape = Shape::FirstTriangle),
    simple!(FAN, shape = Shape::Fan),
    simple!(BOUNDS, shape = Shape::Bounds),
    simple!(BOX, shape = Shape::FilledBounds),
    simple!(FILLED, shape = Shape::Filled, Shape::FilledOutline),
    simple!(CORNERS, shape = Shape::Corners),
    simple!(FIRST_FACE, faces = Faces::FirstLost),
    simple!(LAST_FACE, faces = Faces::LastLost),
    simple!(ONE_FACE, faces = Faces::OnlyFirst, Faces::OnlyLast),
];

const PENS: [&[Mutant]; 8] = [
    simple!(
        WIDE,
        pen = Pen::Wide(&[(0, 0), (1, 0)]),
        Pen::Wide(&[(0, 0), (0, 1)]),
        Pen::Wide(&[(0, 0), (-1, 0)]),
        Pen::Wide(&[(0, 0), (0, -1)]),
        Pen::Wide(&[(0, 0), (1, 0), (0, 1)]),
        Pen::Wide(&[(0, 0), (1, 0), (0, 1), (1, 1)]),
        Pen::Wide(&[(0, 0), (1, 0), (0, 1), (-1, 0), (0, -1)]),
        Pen::Wide(&[(-1, -1), (0, -1), (1, -1), (-1, 0), (0, 0), (1, 0), (-1, 1), (0, 1), (1, 1)])
    ),
    simple!(WIDE, pen = Pen::Across(&[0, 1]), Pen::Across(&[-1, 0]), Pen::Across(&[-1, 0, 1])),
    simple!(
        DASHED,
        pen = Pen::Dashed(2, 0),
        Pen::Dashed(2, 1),
        Pen::Dashed(3, 0),
        Pen::Dashed(4, 0),
        Pen::Stride(2),
        Pen::Stride(3)
    ),
    simple!(
        DIM,
        ink = Ink::Times([0.5; 3]),
        Ink::Times([0.25; 3]),
        Ink::Times([0.75; 3]),
        Ink::Times([1.0 / 255.0; 3]),
        Ink::Times([254.0 / 255.0; 3]),
        Ink::Times([0.9; 3]),
        Ink::Times([0.8; 3]),
        Ink::Times([0.7; 3]),
        Ink::Times([0.6; 3]),
        Ink::Times([0.4; 3]),
        Ink::Times([0.3; 3]),
        Ink::Times([0.2; 3]),
        Ink::Times([0.1; 3]),
        Ink::Times([200.0 / 255.0; 3]),
        Ink::Times([1.0, 0.0, 0.0]),
        Ink::Times([0.0, 1.0, 0.0]),
        Ink::Times([0.0, 0.0, 1.0]),
        Ink::Times([1.0, 1.0, 0.0]),
        Ink::Times([1.0, 0.0, 1.0]),
        Ink::Times([0.0, 1.0, 1.0])
    ),
    simple!(ONE_INK, ink = Ink::Always(1.0)),
    simple!(
        THRESHOLD,
        ink = Ink::BlackAbove([1.0; 3], 0.5),
        Ink::BlackAbove([1.0; 3], 1.0),
        Ink::BlackAbove([1.0; 3], 2.0),
        Ink::BlackAbove([1.0, 0.0, 0.0], 0.5),
        Ink::BlackAbove([0.0, 1.0, 0.0], 0.5),
        Ink::BlackAbove([0.0, 0.0, 1.0], 0.5),
        Ink::BlackAbove([0.2126, 0.7152, 0.0722], 0.5),
        Ink::BlackAbove([0.299, 0.587, 0.114], 0.5)
    ),
    simple!(BLACK_INK, ink = Ink::Always(0.0), Ink::Opposite),
    simple!(EXCLUSIVE, is_exclusive = true),
];

/// All of them.
pub(super) fn all() -> Vec<Mutant> {
    [SLOPES.concat(), ROWS.concat(), ENDS.concat(), DIAMONDS.concat(), LOST.concat(), SHAPES.concat(), PENS.concat()]
        .concat()
}
