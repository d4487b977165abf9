//! Covered: whether a point of a sample lies in an outline, under any of the rules.
//!
//! Why every sample is asked by itself: nothing is stepped, so no mistake but the one in the rules can creep in. Numbers are
//! multiples of 2^-9 below 2^12; their products round nothing in f64.
//!
//! Cost: a few operations an edge and sample.

use super::rules::{Bounds, Fill, Rounding, Rules, SpanRule, Ties, Winding};
use crate::math::edges;

type Point = (f64, f64);

/// An outline as the rules see it.
pub(super) struct Outline {
    corners: Vec<Point>,
    low: Point,
    high: Point,
    is_drawn: bool,
}

impl Outline {
    pub fn new(corners: &[Point], rules: &Rules) -> Outline {
        let round = |x: f64| match rules.corners {
            Rounding::None => x,
            Rounding::Down => x.floor(),
            Rounding::Nearest => (x + 0.5).floor(),
            Rounding::Up => x.ceil(),
        };
        let corners: Vec<Point> = corners.iter().map(|&(x, y)| (round(x), round(y))).collect();
        let extreme = |pick: fn(f64, f64) -> f64, start: f64| {
            corners.iter().fold((start, start), |(x, y), corner| (pick(x, corner.0), pick(y, corner.1)))
        };
        let (low, high) = (extreme(f64::min, f64::INFINITY), extreme(f64::max, f64::NEG_INFINITY));
        let twice_area = twice_area(&corners);
        // y runs down: an outline that turns clockwise on the screen has a positive area.
        let turns_right = match rules.winding {
            Winding::Both => true,
            Winding::Clockwise => twice_area > 0.0,
            Winding::CounterClockwise => twice_area < 0.0,
        };
        Outline { is_drawn: turns_right && twice_area.abs() / 2.0 >= rules.least_area, corners, low, high }
    }

    /// Whether sample (x, y) is drawn.
    pub fn covers(&self, (x, y): (i32, i32), rules: &Rules) -> bool {
        if !self.is_drawn || !self.in_bounds((x, y), rules.bounds) {
            return false;
        }
        let point = (f64::from(x) + rules.cover_at.0, f64::from(y) + rules.cover_at.1);
        match rules.fill {
            Fill::Nothing => false,
            Fill::Box => self.in_box(point),
            Fill::Corners => self.has_corner_in((x, y), rules.cover_at),
            Fill::Spans(rule) => self.in_span((x, y), rule),
            Fill::Hull => self.is_between(point, rules.ties),
            Fill::AllEdges => self.is_on_one_side(point, rules.ties),
            Fill::BothEnds => has_odd_crossings(&self.corners, point, true),
            Fill::Outline => is_inside(&self.corners, point, rules.ties),
            Fill::FirstTriangle => is_inside(&self.corners[..3], point, rules.ties),
            Fill::Fan => self.corners[1..]
                .windows(2)
                .any(|pair| is_inside(&[self.corners[0], pair[0], pair[1]], point, rules.ties)),
        }
    }

    fn in_bounds(&self, (x, y): (i32, i32), bounds: Bounds) -> bool {
        let (x, y) = (f64::from(x), f64::from(y));
        let (last, first) = ((self.high.0.floor(), self.high.1.floor()), (self.low.0.floor(), self.low.1.floor()));
        match bounds {
            Bounds::Whole => true,
            Bounds::ColumnShort => x < last.0,
            Bounds::RowShort => y < last.1,
            Bounds::BothShort => x < last.0 && y < last.1,
            Bounds::FirstColumnLost => x > first.0,
            Bounds::FirstRowLost => y > first.1,
        }
    }

    fn in_box(&self, (x, y): Point) -> bool {
        self.low.0 <= x && x < self.high.0 && self.low.1 <= y && y < self.high.1
    }

    /// Whether a corner lies in the sample; what lies on the right or lower side of the picture is in nobody's.
    fn has_corner_in(&self, (x, y): (i32, i32), (dx, dy): Point) -> bool {
        let cell = |corner: &Point| ((corner.0 + 0.5 - dx).floor() as i32, (corner.1 + 0.5 - dy).floor() as i32);
        self.corners.iter().any(|corner| cell(corner) == (x, y))
    }

    fn is_between(&self, point: Point, ties: Ties) -> bool {
        let crossing = |side: i32| {
            edges(&self.corners).any(|(a, b)| spans(*a, *b, point, ties) && side_of(*a, *b, point, ties) == side)
        };
        crossing(1) && crossing(-1)
    }

    fn is_on_one_side(&self, point: Point, ties: Ties) -> bool {
        let turn = if twice_area(&self.corners) > 0.0 { 1 } else { -1 };
        edges(&self.corners).all(|(a, b)| sign_with_ties(cross(*a, *b, point), *a, *b, ties) == turn)
    }

    fn in_span(&self, (x, y): (i32, i32), rule: SpanRule) -> bool {
        let line = f64::from(y) + rule.row;
        let crossing = |(a, b): (&Point, &Point)| {
            let (top, bottom) = if a.1 <= b.1 { (a, b) } else { (b, a) };
            let spans = top.1 <= line && line < bottom.1;
            spans.then(|| top.0 + (bottom.0 - top.0) * (line - top.1) / (bottom.1 - top.1))
        };
        let mut crossings: Vec<f64> = edges(&self.corners).filter_map(crossing).collect();
        crossings.sort_by(f64::total_cmp);
        let column = f64::from(x);
        crossings
            .chunks_exact(2)
            .any(|pair| (pair[0] + rule.first).floor() <= column && column < (pair[1] + rule.end).floor())
    }
}

fn twice_area(corners: &[Point]) -> f64 {
    edges(corners).map(|(a, b)| a.0 * b.1 - b.0 * a.1).sum()
}

/// Positive when `point` is right of the edge from a to b, seen along it with y down.
pub(super) fn cross(a: Point, b: Point, point: Point) -> f64 {
    (b.0 - a.0) * (point.1 - a.1) - (b.1 - a.1) * (point.0 - a.0)
}

/// The sign of a cross product; of 0, the sign after a step as small as one likes in the direction of the tie rule.
fn sign_with_ties(cross: f64, a: Point, b: Point, ties: Ties) -> i32 {
    let sign = |number: f64| i32::from(number > 0.0) - i32::from(number < 0.0);
    let Ties::Consistent { x, y, x_first } = ties else { return sign(cross) };
    let (along_x, along_y) = (-(b.1 - a.1) * f64::from(x), (b.0 - a.0) * f64::from(y));
    let (first, second) = if x_first { (along_x, along_y) } else { (along_y, along_x) };
    [cross, first, second].map(sign).into_iter().find(|&sign| sign != 0).unwrap_or(0)
}

/// Whether the edge crosses the row of the point, the tie rule deciding about its ends.
fn spans(a: Point, b: Point, point: Point, ties: Ties) -> bool {
    let is_below = |corner: Point| match ties {
        Ties::Consistent { y: -1, .. } => corner.1 >= point.1,
        _ => corner.1 > point.1,
    };
    is_below(a) != is_below(b)
}

/// 1: the point is right of the edge, whichever way that goes; -1: left.
fn side_of(a: Point, b: Point, point: Point, ties: Ties) -> i32 {
    let (top, bottom) = if a.1 <= b.1 { (a, b) } else { (b, a) };
    -sign_with_ties(cross(top, bottom, point), top, bottom, ties)
}

/// Whether the point is inside by the even-odd rule.
fn is_inside(corners: &[Point], point: Point, ties: Ties) -> bool {
    let odd = |ties| {
        let crossed = |(a, b): (&Point, &Point)| spans(*a, *b, point, ties) && side_of(*a, *b, point, ties) > 0;
        edges(corners).filter(|&(a, b)| crossed((a, b))).count() % 2 == 1
    };
    match ties {
        Ties::Consistent { .. } => odd(ties),
        Ties::All => odd(Ties::LEFT_TOP) || is_on_outline(corners, point),
        Ties::Nobody => odd(Ties::LEFT_TOP) && !is_on_outline(corners, point),
    }
}

fn has_odd_crossings(corners: &[Point], point: Point, both_ends: bool) -> bool {
    let crossed = |(a, b): (&Point, &Point)| {
        let (low, high) = (a.1.min(b.1), a.1.max(b.1));
        let spans = low <= point.1 && (point.1 < high || (both_ends && point.1 == high)) && low < high;
        spans && side_of(*a, *b, point, Ties::LEFT_TOP) > 0
    };
    edges(corners).filter(|&(a, b)| crossed((a, b))).count() % 2 == 1
}

fn is_on_outline(corners: &[Point], (x, y): Point) -> bool {
    edges(corners).any(|(a, b)| {
        let within = x >= a.0.min(b.0) && x <= a.0.max(b.0) && y >= a.1.min(b.1) && y <= a.1.max(b.1);
        within && cross(*a, *b, (x, y)) == 0.0
    })
}
