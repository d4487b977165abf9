//! Lines: which samples the outline of a face shows, by the diamond-exit rule or with one mistake.
//!
//! Corners, [`Lines`] -OUTLINE-> samples
//!
//! A line shows a sample when it leaves the diamond |dx| + |dy| < 1/2 around the sample's center. Where the line comes closer to
//! the diamond's border than 1/500 of a sample the answer is not judged: there the built-in's whole numbers decide.
//!
//! Space: samples. Cost: the samples of the lines' bounds.

mod ask;
pub mod rule;
mod step;
mod step_rule;

use crate::math::edges;
use rule::{Backward, Ends, Lines, Lost, Pen, Shape, Walk};

type Point = (f64, f64);
type Line = (Point, Point);

/// Calls `show(index, is_certain)` for every sample of the picture that the outline shows or may show.
pub(super) fn outline(corners: &[Point], rule: &Lines, (width, height): (u32, u32), mut show: impl FnMut(usize, bool)) {
    let mut put = |(x, y): (i64, i64), is_certain: bool| {
        if (0..i64::from(width)).contains(&x) && (0..i64::from(height)).contains(&y) {
            show((y * i64::from(width) + x) as usize, is_certain);
        }
    };
    let (low, high) = bounds(corners);
    let is_filled = matches!(rule.shape, Shape::Filled | Shape::FilledOutline | Shape::FilledBounds);
    if is_filled {
        for y in 0..i64::from(height) {
            for x in 0..i64::from(width) {
                let at = (x as f64 + 0.5, y as f64 + 0.5);
                let in_bounds = low.0 <= at.0 && at.0 < high.0 && low.1 <= at.1 && at.1 < high.1;
                if in_bounds && (rule.shape == Shape::FilledBounds || is_inside(corners, at)) {
                    put((x, y), true);
                }
            }
        }
    }
    if rule.shape == Shape::Corners {
        corners.iter().for_each(|corner| put((corner.0.floor() as i64, corner.1.floor() as i64), true));
    }
    for (start, end) in lines(corners, rule.shape) {
        let line = exchanged((moved(start, rule.ends), moved(end, rule.ends)), rule.ends);
        if !is_lost(line, rule.lost) {
            draw(line, rule, &mut put);
        }
    }
}

/// The lines that are drawn of a face.
fn lines(corners: &[Point], shape: Shape) -> Vec<Line> {
    let all = |corners: &[Point]| edges(corners).map(|(&start, &end)| (start, end)).collect::<Vec<_>>();
    let numbered = |keep: &dyn Fn(usize) -> bool| {
        all(corners).into_iter().enumerate().filter(|(number, _)| keep(*number)).map(|(_, line)| line).collect()
    };
    let (first, count) = (corners[0], corners.len());
    match shape {
        Shape::Outline | Shape::FilledOutline => all(corners),
        Shape::TrianglesOnly => {
            if count == 3 {
                all(corners)
            } else {
                Vec::new()
            }
        }
        Shape::TrianglesLost => {
            if count == 3 {
                Vec::new()
            } else {
                all(corners)
            }
        }
        Shape::LastLost => numbered(&|number| number + 1 < count),
        Shape::FirstLost => numbered(&|number| number > 0),
        Shape::SecondLost => numbered(&|number| number != 1),
        Shape::FirstAlone => numbered(&|number| number == 0),
        Shape::Even => numbered(&|number| number % 2 == 0),
        Shape::Odd => numbered(&|number| number % 2 == 1),
        Shape::FromFirst => corners[1..].iter().map(|&corner| (first, corner)).collect(),
        Shape::ToFirst => corners[1..].iter().map(|&corner| (corner, first)).collect(),
        Shape::Skipping => (0..count).map(|number| (corners[number], corners[(number + 2) % count])).collect(),
        Shape::FirstTriangle => all(&corners[..count.min(3)]),
        Shape::Fan => (1..count - 1).flat_map(|next| all(&[first, corners[next], corners[next + 1]])).collect(),
        Shape::Bounds => {
            let (low, high) = bounds(corners);
            all(&[low, (high.0, low.1), high, (low.0, high.1)])
        }
        Shape::Filled | Shape::FilledBounds | Shape::Corners | Shape::Nothing => Vec::new(),
    }
}

fn bounds(corners: &[Point]) -> Line {
    let start = ((f64::INFINITY, f64::INFINITY), (f64::NEG_INFINITY, f64::NEG_INFINITY));
    corners.iter().fold(start, |(low, high), p| ((low.0.min(p.0), low.1.min(p.1)), (high.0.max(p.0), high.1.max(p.1))))
}

fn is_inside(corners: &[Point], (x, y): Point) -> bool {
    let crosses =
        |(a, b): (&Point, &Point)| (a.1 <= y) != (b.1 <= y) && a.0 + (y - a.1) * (b.0 - a.0) / (b.1 - a.1) <= x;
    edges(corners).filter(|&edge| crosses(edge)).count() % 2 == 1
}

fn moved((x, y): Point, ends: Ends) -> Point {
    match ends {
        Ends::Kept | Ends::Unsigned(..) | Ends::HalfExchanged(_) => (x, y),
        Ends::CenterX(more) => ((x + more).floor() + 0.5, y),
        Ends::CenterY(more) => (x, (y + more).floor() + 0.5),
        Ends::Center(more) => ((x + more).floor() + 0.5, (y + more).floor() + 0.5),
        Ends::Whole(more) => ((x + more).floor(), (y + more).floor()),
        Ends::Moved(columns, rows) => (x + columns, y + rows),
    }
}

/// A line whose ends are mixed up.
fn exchanged((start, end): Line, ends: Ends) -> Line {
    let (dx, dy) = (end.0 - start.0, end.1 - start.1);
    match ends {
        Ends::Unsigned(in_x, in_y) => {
            let by = (if in_x { dx.abs() } else { dx }, if in_y { dy.abs() } else { dy });
            (start, (start.0 + by.0, start.1 + by.1))
        }
        Ends::HalfExchanged(backward) => {
            let runs_back = match backward {
                Backward::Left => dx < 0.0,
                Backward::Up => dy < 0.0,
                Backward::Along => (if dy.abs() > dx.abs() { dy } else { dx }) < 0.0,
            };
            if runs_back { ((end.0, start.1), (start.0, end.1)) } else { (start, end) }
        }
        _ => (start, end),
    }
}

fn is_lost((start, end): Line, lost: Lost) -> bool {
    let (dx, dy) = (end.0 - start.0, end.1 - start.1);
    let along = if dy.abs() > dx.abs() { dy } else { dx };
    match lost {
        Lost::None => false,
        Lost::Left => dx < 0.0,
        Lost::Right => dx > 0.0,
        Lost::Up => dy < 0.0,
        Lost::Down => dy > 0.0,
        Lost::Backward => along < 0.0,
        Lost::Forward => along > 0.0,
        Lost::LeftOrUp => dx < 0.0 || dy < 0.0,
        Lost::LeftAndUp => dx < 0.0 && dy < 0.0,
        Lost::SteepUp => dy < 0.0 && dy.abs() > dx.abs(),
        Lost::SteepDown => dy > 0.0 && dy.abs() > dx.abs(),
        Lost::ShallowLeft => dx < 0.0 && dy.abs() <= dx.abs(),
        Lost::ShallowRight => dx > 0.0 && dy.abs() <= dx.abs(),
        Lost::Level => dy == 0.0,
        Lost::Upright => dx == 0.0,
        Lost::Straight => dx == 0.0 || dy == 0.0,
        Lost::Diagonal => dx.abs() == dy.abs(),
        Lost::Steep => dy.abs() > dx.abs(),
        Lost::Shallow => dy.abs() < dx.abs(),
        Lost::Rising => dx * dy < 0.0,
        Lost::Falling => dx * dy > 0.0,
    }
}

/// One line with its pen.
fn draw(line: Line, rule: &Lines, put: &mut impl FnMut((i64, i64), bool)) {
    let is_steep = (line.1.1 - line.0.1).abs() > (line.1.0 - line.0.0).abs();
    match rule.pen {
        Pen::One => walk(line, rule.walk, put),
        Pen::Wide(around) => walk(line, rule.walk, &mut |cell, is_certain| {
            around.iter().for_each(|by| put((cell.0 + by.0, cell.1 + by.1), is_certain));
        }),
        Pen::Across(around) => walk(line, rule.walk, &mut |cell, is_certain| {
            around.iter().for_each(|by| {
                put(if is_steep { (cell.0 + by, cell.1) } else { (cell.0, cell.1 + by) }, is_certain);
            });
        }),
        Pen::Stride(step) => walk(line, rule.walk, &mut |cell, is_certain| {
            let columns = if is_steep { cell.1 - line.0.1.floor() as i64 } else { cell.0 - line.0.0.floor() as i64 };
            if columns % step == 0 {
                put(cell, is_certain);
            }
        }),
        Pen::Dashed(step, first) => {
            let keeps = |number: usize, _: usize| number % step == first;
            in_order(line, rule.walk, keeps, put);
        }
        Pen::Trimmed(first, last) => {
            let keeps = |number: usize, count: usize| number >= first && number + last < count;
            in_order(line, rule.walk, keeps, put);
        }
        Pen::TrimmedFromLeft(first, last) => {
            let runs_back = if is_steep { line.1.1 < line.0.1 } else { line.1.0 < line.0.0 };
            let (first, last) = if runs_back { (last, first) } else { (first, last) };
            let keeps = |number: usize, count: usize| number >= first && number + last < count;
            in_order(line, rule.walk, keeps, put);
        }
    }
}

fn walk(line: Line, walk: Walk, put: &mut impl FnMut((i64, i64), bool)) {
    match walk {
        Walk::Ask(rule) => ask::ask(line, rule, put),
        Walk::Step(rule) => step::step(line, rule, |cell| put(cell, true)),
        Walk::Share { more, shift, last } => step::share(line, more, shift, last, |cell| put(cell, true)),
    }
}

/// The samples of a line from its start to its end, those that `keeps(number, count)`.
fn in_order(line: Line, rule: Walk, keeps: impl Fn(usize, usize) -> bool, put: &mut impl FnMut((i64, i64), bool)) {
    let mut cells = Vec::new();
    walk(line, rule, &mut |cell, is_certain| cells.push((cell, is_certain)));
    let (dx, dy) = (line.1.0 - line.0.0, line.1.1 - line.0.1);
    cells.sort_by(|(a, _), (b, _)| {
        let along = |cell: &(i64, i64)| cell.0 as f64 * dx + cell.1 as f64 * dy;
        along(a).total_cmp(&along(b))
    });
    let count = cells.len();
    for (number, (cell, is_certain)) in cells.into_iter().enumerate() {
        if keeps(number, count) {
            put(cell, is_certain);
        }
    }
}
