//! Mistakes about lines: which edges are drawn, from where to where, and which samples they show.
//!
//! A slip in stepping is tried with every common way to treat the ends of a line: which of them a program has is no part of the
//! slip, and they share its name.

mod whole;
mod words;

use super::{Mutant, each_with, mutant};
use crate::grade::lines::rule::{
    Around, Ask, At, Axis, Backward, Ends, Faces, Ink, Lost, Pen, Shape, Slope, Step, StepEnds, StepLost, Walk, When,
};
use crate::grade::rules::Rules;
use whole::WHOLE_ENDS;
use words::*;

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

const fn ends(ends: StepEnds) -> Walk {
    Walk::Step(Step { ends, ..Step::RIGHT })
}

const fn asked(around: Around, half: f64, when: When) -> Walk {
    Walk::Ask(Ask { around, half, when })
}

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

const ROWS: [&[Mutant]; 24] = [
    &stepped!(UNSIGNED, slope: Slope::RowsGrowFromStart),
    &stepped!(UNSIGNED, slope: Slope::RowsGrowFromStart, from_left: true),
    &stepped!(UNSIGNED, slope: Slope::RowsGrow),
    &stepped!(UNSIGNED, slope: Slope::RowsGrow, from_left: true),
    &stepped!(UNSIGNED, slope: Slope::RowsFall),
    &stepped!(UNSIGNED, slope: Slope::RowsFall, from_left: true),
    &stepped!(FROM_END, at: At::FirstMiddle),
    &stepped!(FROM_END, at: At::FirstMiddle, from_left: true),
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

/// One of the columns whose middle is reached lost, at the first or last, by the line's direction or from the left.
fn one_lost() -> Vec<Mutant> {
    let treated = stepped!(TRIMMED, lost: StepLost { is_one: true, ..StepLost::NONE });
    let ways: [fn(&mut Rules); 8] = [
        |_| (),
        |rules| lost(rules, |lost| lost.is_first = true),
        |rules| lost(rules, |lost| lost.from_left = true),
        |rules| lost(rules, |lost| (lost.is_first, lost.from_left) = (true, true)),
        |rules| lost(rules, |lost| lost.beyond = true),
        |rules| lost(rules, |lost| (lost.beyond, lost.is_first) = (true, true)),
        |rules| lost(rules, |lost| (lost.beyond, lost.from_left) = (true, true)),
        |rules| lost(rules, |lost| (lost.beyond, lost.is_first, lost.from_left) = (true, true, true)),
    ];
    let drawn = [
        mutant(TRIMMED, |rules| rules.lines.pen = Pen::TrimmedFromLeft(0, 1)),
        mutant(TRIMMED, |rules| rules.lines.pen = Pen::TrimmedFromLeft(1, 0)),
    ];
    [each_with(&treated, &ways), drawn.to_vec()].concat()
}

fn lost(rules: &mut Rules, change: fn(&mut StepLost)) {
    if let Walk::Step(step) = &mut rules.lines.walk {
        change(&mut step.lost);
    }
}

/// All of them.
pub(super) fn all() -> Vec<Mutant> {
    [
        one_lost(),
        SLOPES.concat(),
        ROWS.concat(),
        ENDS.concat(),
        DIAMONDS.concat(),
        LOST.concat(),
        SHAPES.concat(),
        PENS.concat(),
    ]
    .concat()
}
