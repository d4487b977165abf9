//! Lines: which samples the outline of a face shows, by the diamond-exit rule from its definition.
//!
//! A line shows a sample when it leaves the diamond |dx| + |dy| < 1/2 around the sample's center. Where the line comes closer to
//! the diamond's border than 1/500 of a sample the answer is not judged: there the built-in's whole numbers decide.

use super::rules::Lines;
use crate::math::edges;

type Point = (f64, f64);

/// Half the diamond, and how near to its border nothing is judged.
const HALF: f64 = 0.5;
const BAND: f64 = 0.002;

/// Calls `show(index, is_certain)` for every sample of the picture that the outline shows or may show.
pub(super) fn outline(corners: &[Point], rule: Lines, (width, height): (u32, u32), mut show: impl FnMut(usize, bool)) {
    let mut segments: Vec<_> = edges(corners).collect();
    if rule == Lines::Open {
        segments.pop();
    }
    for (start, end) in segments {
        for at in 0..(width * height) as usize {
            let center = ((at % width as usize) as f64 + 0.5, (at / width as usize) as f64 + 0.5);
            match rule {
                Lines::Nothing => {}
                Lines::DiamondExit | Lines::Open => {
                    let (sure, maybe) =
                        (leaves(*start, *end, center, HALF - BAND), leaves(*start, *end, center, HALF + BAND));
                    let certain = sure == maybe && !is_near_border(*end, center);
                    if sure || maybe || !certain {
                        show(at, certain);
                    }
                }
                Lines::WithLastSample => {
                    if touches(*start, *end, center, HALF) {
                        show(at, true);
                    }
                }
                Lines::Truncated | Lines::ColumnsOnly => {
                    if steps(*start, *end, rule).any(|cell| cell == (center.0.floor(), center.1.floor())) {
                        show(at, true);
                    }
                }
            }
        }
    }
}

/// Part of the segment inside the diamond of that size, as parameters 0..1.
fn inside(start: Point, end: Point, center: Point, half: f64) -> Option<(f64, f64)> {
    let (mut enter, mut exit): (f64, f64) = (0.0, 1.0);
    for (sx, sy) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
        let height = |p: Point| sx * (p.0 - center.0) + sy * (p.1 - center.1) - half;
        let (from, to) = (height(start), height(end));
        if from >= 0.0 && to >= 0.0 {
            return None;
        }
        let crossing = from / (from - to);
        if from > 0.0 {
            enter = enter.max(crossing);
        }
        if to > 0.0 {
            exit = exit.min(crossing);
        }
    }
    (enter < exit).then_some((enter, exit))
}

fn leaves(start: Point, end: Point, center: Point, half: f64) -> bool {
    inside(start, end, center, half).is_some() && distance(end, center) >= half
}

fn touches(start: Point, end: Point, center: Point, half: f64) -> bool {
    inside(start, end, center, half).is_some()
}

fn distance(p: Point, center: Point) -> f64 {
    (p.0 - center.0).abs() + (p.1 - center.1).abs()
}

fn is_near_border(p: Point, center: Point) -> bool {
    (distance(p, center) - HALF).abs() <= BAND
}

/// The cells of a line that steps a sample at a time along x (or along the longer side), ends truncated.
fn steps(start: Point, end: Point, rule: Lines) -> impl Iterator<Item = Point> {
    let (from, to) = ((start.0.floor(), start.1.floor()), (end.0.floor(), end.1.floor()));
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let count = if rule == Lines::ColumnsOnly { dx.abs() } else { dx.abs().max(dy.abs()) };
    (0..=count as usize).map(move |step| {
        let share = if count > 0.0 { step as f64 / count } else { 0.0 };
        ((from.0 + dx * share + 0.5).floor(), (from.1 + dy * share + 0.5).floor())
    })
}
