//! Lines column by column, as most programs draw them, with the slips that this invites.
//!
//! A steep line is turned: its rows are the columns here. (u, v) is (x, y), or (y, x) of a steep line.

use super::rule::{At, Axis, Slope, Step, StepEnds, StepLost};
use super::{Line, Point};

/// Calls `show` with the cells of a line.
pub(super) fn step(line: Line, step: Step, mut show: impl FnMut((i64, i64))) {
    let is_steep = (line.1.1 - line.0.1).abs() > (line.1.0 - line.0.0).abs();
    let is_turned = match step.axis {
        Axis::Longer | Axis::NotTurnedBack => is_steep,
        Axis::Shorter => !is_steep,
        Axis::X => false,
        Axis::Y => true,
    };
    let turn = |p: Point| if is_turned { (p.1, p.0) } else { p };
    let (start, end) = (turn(line.0), turn(line.1));
    let turns_back = is_turned && step.axis != Axis::NotTurnedBack;
    let mut emit = |u: i64, v: i64| show(if turns_back { (v, u) } else { (u, v) });
    if start.0 == end.0 {
        // Without an extent there is no slope; what asks nothing about the ends shows the start.
        if step.ends == StepEnds::All {
            emit(start.0.floor() as i64, (start.1 + step.shift).floor() as i64);
        }
        return;
    }
    let slope = slope(start, end, step.slope);
    let right_slope = (end.1 - start.1) / (end.0 - start.0);
    let anchor = if step.from_left && end.0 < start.0 { end } else { start };
    let lead = step.lead * (end.1 - start.1).signum();
    let (low, high) = (start.0.min(end.0), start.0.max(end.0));
    // The columns whose middle is reached.
    let reached = ((low - 0.5).ceil() as i64, (high - 0.5).floor() as i64);
    let is_forward = anchor.0 == low;
    let first = if is_forward { reached.0 } else { reached.1 };
    let first_row = (anchor.1 + (first as f64 + 0.5 - anchor.0) * right_slope).floor() as i64;
    let is_from_left = step.lost.from_left || end.0 > start.0;
    for column in low.floor() as i64 + step.trim.0..=high.floor() as i64 - step.trim.1 {
        let middle = (column as f64 + 0.5).clamp(low, high);
        let at = match step.at {
            At::Middle => middle,
            At::Part(part) => column as f64 + part,
            At::Start => anchor.0 + column as f64 - anchor.0.floor(),
            At::FirstMiddle => anchor.0 + (column - first) as f64,
        };
        let row = (anchor.1 + (at - anchor.0) * slope + step.shift + lead).floor() as i64;
        let row = match step.slope {
            Slope::RowsGrow => first_row + (row - first_row).abs(),
            Slope::RowsGrowFromStart => anchor.1.floor() as i64 + (row - anchor.1.floor() as i64).abs(),
            Slope::RowsFall => first_row - (row - first_row).abs(),
            _ => row,
        };
        if is_lost(step.lost, (column, is_from_left), reached) {
            continue;
        }
        let right = (middle, start.1 + (middle - start.0) * right_slope);
        // Most programs ask for the diamond where they believe the line to be.
        let (asked, nearest) = match step.ends {
            StepEnds::RightDiamonds => (right.1.floor() as i64, right),
            _ => (row, (middle, anchor.1 + (middle - anchor.0) * slope)),
        };
        if is_shown((start, end), nearest, (column, asked), step.ends) {
            emit(column, row);
        }
    }
}

fn is_lost(lost: StepLost, (column, is_from_left): (i64, bool), (low, high): (i64, i64)) -> bool {
    let at_low = lost.is_first == is_from_left;
    let beyond = if at_low { column <= low } else { column >= high };
    let at = column == if at_low { low } else { high };
    lost.is_one && if lost.beyond { beyond } else { at }
}

fn slope(start: Point, end: Point, rule: Slope) -> f64 {
    let (du, dv) = (end.0 - start.0, end.1 - start.1);
    let or_level = |slope: f64| if slope.is_finite() { slope } else { 0.0 };
    let slope = dv / du;
    match rule {
        Slope::Right | Slope::RowsGrow | Slope::RowsFall | Slope::RowsGrowFromStart => slope,
        Slope::Cut => slope.trunc(),
        Slope::Down => slope.floor(),
        Slope::Rounded => slope.round(),
        Slope::Positive => slope.abs(),
        Slope::Negative => -slope.abs(),
        Slope::Opposite => -slope,
        Slope::TurnedOver => or_level(du / dv),
        Slope::One => or_level(slope / slope.abs()),
        Slope::Zero => 0.0,
        Slope::Half => slope / 2.0,
        Slope::OfWholeEnds => or_level((end.1.floor() - start.1.floor()) / (end.0.floor() - start.0.floor())),
    }
}

/// Whether a cell is shown; `at` is where the line is nearest to the middle of its column.
fn is_shown((start, end): Line, at: Point, cell: (i64, i64), ends: StepEnds) -> bool {
    let middle = cell.0 as f64 + 0.5;
    let is_cell_of = |p: Point| p.0.floor() as i64 == cell.0;
    let in_diamond = |p: Point| (p.0 - middle).abs() + (p.1 - cell.1 as f64 - 0.5).abs() < 0.5;
    let is_reached =
        if end.0 > start.0 { start.0 <= middle && middle < end.0 } else { end.0 < middle && middle <= start.0 };
    match ends {
        StepEnds::Diamonds | StepEnds::RightDiamonds => (at.0 == middle || in_diamond(at)) && !in_diamond(end),
        StepEnds::All | StepEnds::AllOfLong => true,
        StepEnds::NotFirst => !is_cell_of(start),
        StepEnds::NotLast => !is_cell_of(end),
        StepEnds::Neither => !is_cell_of(start) && !is_cell_of(end),
        StepEnds::Middles => is_reached,
        StepEnds::MiddlesClosed => at.0 == middle,
    }
}

/// Calls `show` with the cells of a line cut into equal shares.
pub(super) fn share((start, end): Line, more: f64, shift: f64, last: bool, mut show: impl FnMut((i64, i64))) {
    let (dx, dy) = (end.0 - start.0, end.1 - start.1);
    let count = (dx.abs().max(dy.abs()) + more).floor();
    let shown = if last { count as i64 + 1 } else { count as i64 };
    for number in 0..shown {
        let part = if count > 0.0 { number as f64 / count } else { 0.0 };
        show(((start.0 + part * dx + shift).floor() as i64, (start.1 + part * dy + shift).floor() as i64));
    }
}
