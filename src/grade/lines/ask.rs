//! The diamond-exit rule from its definition: every sample is asked what the line does to the diamond around its center.

use super::rule::{Around, Ask, When};
use super::{Line, Point};

/// How near to a diamond's border nothing is judged.
const BAND: f64 = 0.002;

/// Calls `show(cell, is_certain)` for every sample near the line that it shows or may show.
pub(super) fn ask(line: Line, ask: Ask, mut show: impl FnMut((i64, i64), bool)) {
    let range = |a: f64, b: f64| (a.min(b) - ask.half).floor() as i64 - 1..=(a.max(b) + ask.half).floor() as i64 + 1;
    for y in range(line.0.1, line.1.1) {
        for x in range(line.0.0, line.1.0) {
            let center = (x as f64 + 0.5, y as f64 + 0.5);
            if ask != Ask::RIGHT {
                if shows(line, center, ask) {
                    show((x, y), true);
                }
                continue;
            }
            let with = |half: f64| shows(line, center, Ask { half, ..ask });
            let (sure, maybe) = (with(ask.half - BAND), with(ask.half + BAND));
            let certain = sure == maybe && (distance(line.1, center, ask.around) - ask.half).abs() > BAND;
            if sure || maybe || !certain {
                show((x, y), certain);
            }
        }
    }
}

fn shows(line: Line, center: Point, ask: Ask) -> bool {
    let is_inside = |end: Point| distance(end, center, ask.around) < ask.half;
    let by_ends = match ask.when {
        When::Touches => true,
        When::Leaves => !is_inside(line.1),
        When::Enters => !is_inside(line.0),
        When::Crosses => !is_inside(line.0) && !is_inside(line.1),
    };
    by_ends && touches(line, center, ask)
}

fn distance(p: Point, center: Point, around: Around) -> f64 {
    let (dx, dy) = ((p.0 - center.0).abs(), (p.1 - center.1).abs());
    match around {
        Around::Diamond => dx + dy,
        Around::Square => dx.max(dy),
        Around::Circle => (dx * dx + dy * dy).sqrt(),
    }
}

fn touches(line: Line, center: Point, ask: Ask) -> bool {
    let sides = match ask.around {
        Around::Circle => return nearest(line, center) < ask.half,
        Around::Diamond => [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)],
        Around::Square => [(1.0, 0.0), (0.0, -1.0), (0.0, 1.0), (-1.0, 0.0)],
    };
    let (mut enter, mut exit): (f64, f64) = (0.0, 1.0);
    for (sx, sy) in sides {
        let height = |p: Point| sx * (p.0 - center.0) + sy * (p.1 - center.1) - ask.half;
        let (from, to) = (height(line.0), height(line.1));
        if from >= 0.0 && to >= 0.0 {
            return false;
        }
        let crossing = from / (from - to);
        if from > 0.0 {
            enter = enter.max(crossing);
        }
        if to > 0.0 {
            exit = exit.min(crossing);
        }
    }
    enter < exit
}

/// Distance of a point from a line between its ends.
fn nearest((start, end): Line, center: Point) -> f64 {
    let (dx, dy) = (end.0 - start.0, end.1 - start.1);
    let length = dx * dx + dy * dy;
    let along = (center.0 - start.0) * dx + (center.1 - start.1) * dy;
    let share = if length > 0.0 { (along / length).clamp(0.0, 1.0) } else { 0.0 };
    distance((start.0 + share * dx, start.1 + share * dy), center, Around::Circle)
}
