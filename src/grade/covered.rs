//! Covered: whether a point of a sample lies in an outline, under any of the rules.
//!
//! Why every sample is asked by itself: nothing is stepped, so no mistake but the one in the rules can creep in. Numbers are
//! multiples of 2^-9 below 2^12; their products round nothing in f64.
//!
//! Cost: a few operations an edge and sample.

use super::quarters;
use super::rules::{
    BlockEnd, BlockStart, Blocks, Bounds, BoundsBy, BoundsOf, Fill, Pieces, Rounding, Rules, Slack, Ties, Winding,
};
use super::scan;
use crate::math::edges;

type Point = (f64, f64);

/// An outline as the rules see it.
pub(super) struct Outline {
    pieces: Vec<Piece>,
    /// What two pieces cover is outside again.
    toggles: bool,
}

/// A part that is filled by itself.
struct Piece {
    corners: Vec<Point>,
    low: Point,
    high: Point,
    is_drawn: bool,
    /// Columns and rows that are looked at, first and last.
    window: [i32; 4],
    /// Of every row, where spans decide.
    spans: Vec<Vec<(i32, i32)>>,
    size: (i32, i32),
}

impl Outline {
    /// `size`: of the picture, in samples.
    pub fn new(corners: &[Point], rules: &Rules, size: (u32, u32)) -> Outline {
        let round = |x: f64| rounded(x, rules.corners);
        let corners: Vec<Point> = corners.iter().map(|&(x, y)| (round(x), round(y))).collect();
        let size = (size.0 as i32, size.1 as i32);
        let pieces = cut(corners, rules.pieces).into_iter().map(|corners| Piece::new(corners, rules, size)).collect();
        let toggles = matches!(rules.pieces, Pieces::Fan { toggles: true, .. } | Pieces::Strip { toggles: true });
        Outline { pieces, toggles }
    }

    /// Whether sample (x, y) is drawn.
    pub fn covers(&self, sample: (i32, i32), rules: &Rules) -> bool {
        let mut covering = self.pieces.iter().filter(|piece| piece.covers(sample, rules));
        if self.toggles { covering.count() % 2 == 1 } else { covering.next().is_some() }
    }
}

/// A coordinate, rounded.
pub(super) fn rounded(x: f64, rounding: Rounding) -> f64 {
    match rounding {
        Rounding::None => x,
        Rounding::Down => x.floor(),
        Rounding::Nearest => (x + 0.5).floor(),
        Rounding::Up => x.ceil(),
        Rounding::DownTo(parts) => (x * f64::from(parts)).floor() / f64::from(parts),
        Rounding::NearestTo(parts) => (x * f64::from(parts) + 0.5).floor() / f64::from(parts),
    }
}

/// The parts of an outline.
fn cut(corners: Vec<Point>, pieces: Pieces) -> Vec<Vec<Point>> {
    let count = corners.len();
    match pieces {
        Pieces::Whole => vec![corners],
        Pieces::FirstCorners(most) => vec![corners[..count.min(most)].to_vec()],
        Pieces::Fan { from, skipped, lost, of_all, .. } => {
            let corner = |number: usize| corners[(from + number) % count];
            // Whoever loses triangles of a fan still draws triangles.
            let (skipped, lost) = if count == 3 && !of_all { (0, 0) } else { (skipped, lost) };
            let end = (count - 1).saturating_sub(lost);
            (1 + skipped..end).map(|number| vec![corner(0), corner(number), corner(number + 1)]).collect()
        }
        Pieces::Strip { .. } => corners.windows(3).map(<[Point]>::to_vec).collect(),
    }
}

impl Piece {
    fn new(corners: Vec<Point>, rules: &Rules, size: (i32, i32)) -> Piece {
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
        let is_dropped = rules.dropped.has(&corners, (low, high), size);
        let is_drawn = turns_right && !is_dropped && twice_area.abs() / 2.0 >= rules.least_area;
        let spans = match &rules.fill {
            Fill::Scan(scan) if is_drawn => scan::spans(&corners, scan, size),
            _ => Vec::new(),
        };
        let window = window(bounds_of(&corners, rules.bounds.of, (low, high)), rules.bounds, size);
        Piece { is_drawn, corners, low, high, window, spans, size }
    }

    fn covers(&self, (x, y): (i32, i32), rules: &Rules) -> bool {
        let [left, right, top, bottom] = self.window;
        if !self.is_drawn || x < left || x > right || y < top || y > bottom {
            return false;
        }
        let (columns, rows) = rules.stepped;
        if (x - left).rem_euclid(columns) != 0 || (y - top).rem_euclid(rows) != 0 {
            return false;
        }
        let point = (f64::from(x) + rules.cover_at.0, f64::from(y) + rules.cover_at.1);
        match rules.fill {
            Fill::Nothing => false,
            Fill::Box => self.in_box(point),
            Fill::Corners => self.has_corner_in((x, y), rules.cover_at),
            Fill::Scan(_) => self.has_span_over((x, y)),
            Fill::Hull => self.is_between(point, rules.ties),
            Fill::AllEdges => self.is_on_one_side(point, rules.ties),
            Fill::BothEnds => has_odd_crossings(&self.corners, point, true),
            Fill::Outline => is_inside(&self.corners, point, rules.ties),
            Fill::Outside => self.in_box(point) && !is_inside(&self.corners, point, rules.ties),
            Fill::Slack(slack) => self.is_nearly_inside(point, slack),
            Fill::Narrow(parts) => self.is_on_one_side_in_16_bits(point, f64::from(parts)),
            Fill::Quarters(slip) => {
                let asked = quarters::asked(&self.corners, slip, self.size, (x, y));
                asked.is_some_and(|(x, y)| {
                    let point = (f64::from(x) + rules.cover_at.0, f64::from(y) + rules.cover_at.1);
                    is_inside(&self.corners, point, rules.ties)
                })
            }
        }
    }

    /// Blocks reach over the border of the picture, and spans do not: there is nothing on rows that there are not.
    fn has_span_over(&self, (x, y): (i32, i32)) -> bool {
        let row = usize::try_from(y).ok().and_then(|y| self.spans.get(y));
        row.is_some_and(|spans| spans.iter().any(|&(first, end)| first <= x && x < end))
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

    fn is_nearly_inside(&self, point: Point, slack: Slack) -> bool {
        let area = twice_area(&self.corners);
        let least = |a: Point, b: Point| match slack {
            Slack::Weight(least) => least * area.abs(),
            Slack::Cross(least) => least,
            Slack::Distance(least) => least * ((b.0 - a.0) * (b.0 - a.0) + (b.1 - a.1) * (b.1 - a.1)).sqrt(),
        };
        area != 0.0 && edges(&self.corners).all(|(a, b)| cross(*a, *b, point) * area.signum() >= -least(*a, *b))
    }

    fn is_on_one_side_in_16_bits(&self, point: Point, parts: f64) -> bool {
        let turn = if twice_area(&self.corners) > 0.0 { 1.0 } else { -1.0 };
        // Whoever keeps differences in 16 bits loses what is above.
        let narrow = |difference: f64| f64::from((difference * parts).round() as i64 as i16);
        edges(&self.corners).all(|(a, b)| {
            let (along, across) = (narrow(b.0 - a.0), narrow(b.1 - a.1));
            let value = (along * narrow(point.1 - a.1) - across * narrow(point.0 - a.0)) * turn;
            let is_owned = (b.1 - a.1) * turn < 0.0 || (a.1 == b.1 && (b.0 - a.0) * turn > 0.0);
            value > 0.0 || (value == 0.0 && is_owned)
        })
    }
}

/// Least and greatest coordinates, as they are found.
fn bounds_of(corners: &[Point], of: BoundsOf, (low, high): (Point, Point)) -> (Point, Point) {
    let among = |corners: &[Point]| {
        let all = |pick: fn(f64, f64) -> f64, start: f64| {
            corners.iter().fold((start, start), |(x, y), corner| (pick(x, corner.0), pick(y, corner.1)))
        };
        (all(f64::min, f64::INFINITY), all(f64::max, f64::NEG_INFINITY))
    };
    let with_side = |side: usize, corner: Point| match side {
        0 => ((corner.0, low.1), high),
        1 => (low, (corner.0, high.1)),
        2 => ((low.0, corner.1), high),
        _ => (low, (high.0, corner.1)),
    };
    let last = corners.len() - 1;
    match of {
        BoundsOf::All => (low, high),
        BoundsOf::FirstThree => among(&corners[..corners.len().min(3)]),
        BoundsOf::FirstAndThird => (corners[0], corners[last.min(2)]),
        BoundsOf::AllButLast => among(&corners[..last]),
        BoundsOf::SideOfFirst(side) => with_side(side, corners[0]),
        BoundsOf::SideOfSecond(side) => with_side(side, corners[last.min(1)]),
        BoundsOf::SideOfLast(side) => with_side(side, corners[last]),
    }
}

/// Columns and rows of the bounds that are looked at: left, right, top, bottom, all included.
fn window((low, high): (Point, Point), bounds: Bounds, size: (i32, i32)) -> [i32; 4] {
    let whole = |x: f64| x as i32;
    let range = |by: BoundsBy, low: f64, high: f64, size: i32| match by {
        BoundsBy::Floor => (whole(low.floor()), whole(high.floor())),
        BoundsBy::Clipped => (whole(low.floor()), whole(high.floor()).min(size - 1)),
        BoundsBy::Centers => (whole((low - 0.5).ceil()), whole((high - 0.5).ceil()) - 1),
        BoundsBy::Inner => (whole(low.ceil()), whole(high.floor()) - 1),
        BoundsBy::Rounded => (whole((low + 0.5).floor()), whole((high + 0.5).floor()) - 1),
        BoundsBy::Blocks(blocks) => in_blocks(blocks, (low, high), size),
    };
    let down = match bounds.by {
        BoundsBy::Blocks(Blocks { across_only: true, .. }) => BoundsBy::Clipped,
        by => by,
    };
    let (left, right) = range(bounds.by, low.0, high.0, size.0);
    let (top, bottom) = range(down, low.1, high.1, size.1);
    let [of_left, of_right, of_top, of_bottom] = bounds.lost;
    // Whatever is looked at beyond the bounds holds nothing; so the bounds do not decide where nothing is lost.
    let all = bounds == Bounds::WHOLE;
    if all {
        [0, size.0 - 1, 0, size.1 - 1]
    } else {
        [left + of_left, right - of_right, top + of_top, bottom - of_bottom]
    }
}

/// First and last sample of the whole blocks between two coordinates.
fn in_blocks(blocks: Blocks, (low, high): (f64, f64), size: i32) -> (i32, i32) {
    let (side, floor) = (blocks.side, low.floor() as i32);
    let first = match blocks.start {
        BlockStart::Floor => floor,
        BlockStart::Center => (low - 0.5).ceil() as i32,
        BlockStart::BlockBefore => floor.div_euclid(side) * side,
        BlockStart::BlockBehind => (floor + side - 1).div_euclid(side) * side,
    };
    let end = match blocks.end {
        BlockEnd::Floor => high.floor() as i32 + 1,
        BlockEnd::Ceil => high.ceil() as i32,
        BlockEnd::Center => (high - 0.5).ceil() as i32,
    };
    (first, first + (end.min(size) - first).div_euclid(side) * side - 1)
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
        Ties::Sides { .. } => {
            if is_on_outline(corners, point) {
                owns_all_touched(corners, point, ties)
            } else {
                odd(Ties::LEFT_TOP)
            }
        }
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

fn is_on_outline(corners: &[Point], point: Point) -> bool {
    edges(corners).any(|(a, b)| touches(*a, *b, point))
}

fn touches(a: Point, b: Point, (x, y): Point) -> bool {
    let within = x >= a.0.min(b.0) && x <= a.0.max(b.0) && y >= a.1.min(b.1) && y <= a.1.max(b.1);
    within && cross(a, b, (x, y)) == 0.0
}

/// Whether every edge that the point lies on belongs to the polygon.
fn owns_all_touched(corners: &[Point], point: Point, ties: Ties) -> bool {
    let Ties::Sides { left, right, top, bottom } = ties else { return false };
    let turn = if twice_area(corners) > 0.0 { 1.0 } else { -1.0 };
    edges(corners).filter(|(a, b)| touches(**a, **b, point)).all(|(a, b)| {
        let (dx, dy) = ((b.0 - a.0) * turn, (b.1 - a.1) * turn);
        if dy == 0.0 {
            if dx > 0.0 { top } else { bottom }
        } else if dy < 0.0 {
            left
        } else {
            right
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One sample may decide for a block that reaches over the border of the picture.
    #[test]
    fn rows_beyond_the_picture_have_no_spans() {
        let spans = vec![vec![(0, 4)]; 2];
        let (low, high, window, size) = ((0.0, 0.0), (4.0, 2.0), [0, 4, 0, 2], (4, 2));
        let piece = Piece { corners: Vec::new(), low, high, is_drawn: true, window, spans, size };
        assert!(piece.has_span_over((0, 0)) && piece.has_span_over((3, 1)));
        for beyond in [(3, 2), (3, -1), (4, 1), (-1, 0)] {
            assert!(!piece.has_span_over(beyond), "{beyond:?}");
        }
    }
}
