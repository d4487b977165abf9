//! Fit: what is in the way of an ear, asked of one neighbor or one obstacle at a time.
//!
//! Inside and outside are clear from signs. The border needs care, since outlines touch themselves: a vertex on the border
//! is in the way if an edge of its own goes inside, and is not if both go away. If both run along the border, the
//! coordinates do not tell on which side of it they run (a slit in the ear, or a neighbor that leans on it from
//! outside), and the answer is doubtful.
//!
//! Space: the plane of the polygon, counterclockwise.
//! Cost: 3 signs for what is off the ear, up to 9 for what is not.

use crate::geometry::predicates::{Orientation, orientation};
use crate::math::Vec2;

/// What lies in the triangle of a convex corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Fit {
    Free,
    /// Something lies on the border and goes away from it.
    Touched,
    /// Something runs along the border; the place alone does not tell on which side of it.
    Doubtful,
    /// Something lies inside or reaches in.
    Blocked,
}

/// How signs are taken: as the coordinates say, or with an allowance for rounding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Turns {
    Exact,
    /// The power of two that brings the coordinates near 1.
    Rounded(f64),
}

/// How far rounding may have moved a vertex off a line it was computed to lie on: 16 last places of the largest coordinate.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

impl Turns {
    /// [`orientation`]; with the allowance, collinear already when moving one of the three as far as rounding does makes it so.
    pub(super) fn orientation(self, a: Vec2, b: Vec2, c: Vec2) -> Orientation {
        let Turns::Rounded(scale) = self else { return orientation(a, b, c) };
        let [a, b, c] = [a, b, c].map(|p| p * scale);
        let (ab, bc, ca) = (b - a, c - b, a - c);
        let area = ab.perp_dot(bc);
        let longest = ab.length_squared().max(bc.length_squared()).max(ca.length_squared());
        if area * area <= ROUNDING * ROUNDING * longest {
            Orientation::Collinear
        } else if area > 0.0 {
            Orientation::Counterclockwise
        } else {
            Orientation::Clockwise
        }
    }

    /// How far outside a triangle something may lie that counts as on its border.
    pub(super) fn margin(self) -> f64 {
        match self {
            Turns::Exact => 0.0,
            Turns::Rounded(scale) => ROUNDING / scale,
        }
    }

    /// How an ear `[previous, current, next]` fits the outline edges beyond it, whose far `ends` come before previous and after next.
    pub(super) fn fit_of_diagonal(self, ear: [Vec2; 3], ends: [Vec2; 2]) -> Fit {
        let [previous, current, next] = ear;
        let fit_at = |at, other, end| {
            let sides = (self.orientation(at, current, end), self.orientation(at, other, end));
            let (left, right) = (self.orientation(at, current, other), self.orientation(at, other, current));
            match sides {
                // Back along the ear's own edge: a spike, and its angle may be none or a full turn. Let the spike be cut first.
                (Orientation::Collinear, _) if is_ahead(at, current, end) => Fit::Blocked,
                (_, Orientation::Collinear) if is_ahead(at, other, end) => Fit::Touched,
                _ if sides == (left, right) => Fit::Blocked,
                _ => Fit::Free,
            }
        };
        fit_at(previous, next, ends[0]).max(fit_at(next, previous, ends[1]))
    }

    /// How an ear fits a vertex at `place` that is none of its three, and the two ends of the `chain` through it.
    pub(super) fn fit_of_obstacle(self, ear: [Vec2; 3], place: Vec2, chain: [Vec2; 2]) -> Fit {
        let [a, b, c] = ear;
        let sides = [(a, b), (b, c), (c, a)];
        let turns = sides.map(|(from, to)| self.orientation(from, to, place));
        if turns.contains(&Orientation::Clockwise) {
            return Fit::Free;
        }

        // On the border it does no harm, unless an edge of its own leaves into the ear: to the left of the side it lies on, or of
        // both sides where it shares the place of a corner. Inside it lies on no side, and any edge does.
        let on = || sides.iter().zip(turns).filter(|(_, turn)| *turn == Orientation::Collinear).map(|(side, _)| *side);
        let enters = |end| on().all(|(from, to)| self.orientation(from, to, end) == Orientation::Counterclockwise);
        if chain.into_iter().any(enters) {
            return Fit::Blocked;
        }
        let follows = |end| on().any(|(from, to)| self.orientation(from, to, end) == Orientation::Collinear);
        match (chain.into_iter().all(follows), on().count()) {
            (true, _) => Fit::Doubtful,
            (false, 1) => Fit::Touched,
            (false, _) => Fit::Free,
        }
    }
}

/// Whether `p` and `q`, on a line with `at`, lie in the same direction from it.
fn is_ahead(at: Vec2, p: Vec2, q: Vec2) -> bool {
    let (p, q) = (p - at, q - at);
    if p.x.abs() > p.y.abs() { (p.x > 0.0) == (q.x > 0.0) } else { (p.y > 0.0) == (q.y > 0.0) }
}
