//! Exact edge: the crossings of an edge whose ends lie on no grid (`--subpixel-bits exact`).
//!
//! coverage -> EXACT EDGE -> the same marks as an edge on the grid leaves
//!
//! An end is the point (x w, y w, w) as projecting left it, and nothing is divided or snapped: a sample's center C =
//! (2i + 1, 2j + 1, 2) is right of the edge from T down to B when the determinant of T, B, C is negative, and on it when that is 0
//! (all w are positive). Its columns, `a (2i + 1) + b (2j + 1) + 2 c`, are few products; where their rounding could matter,
//! the sign is computed again with long integers. So ends may be a billion samples away, and need no clipping at the sides.
//!
//! Why the quotient is only a guess: it is quick and nearly always right, and its neighbor to the left proves it. So every mark
//! is exact whatever the quotient's digits are worth.
//!
//! Bound: a, b and c are two products and a difference each, the sum has three products and two additions: each of the six
//! terms passes at most five roundings, so the error is below 8 u times the sum of the terms' magnitudes, u = 2^-53; the rest
//! covers the rounding of that sum. What underflows adds less than 2^-1022 times the sample's coordinates.
//!
//! Space: homogeneous samples. Source: Olano and Greer, "Triangle Scan Conversion using 2D Homogeneous Coordinates", Graphics
//! Hardware 1997, for edges without division.
//! Cost: about 30 operations and one division an edge and scan line; a microsecond in the rare exact step.

use crate::geometry::predicates::edge_side;
use crate::math::Vec3;
use std::cmp::Ordering;
use std::ops::Range;

/// Rows and columns are held within this, half as far again as the largest picture reaches.
const LIMIT: f64 = ((1 << 22) + (1 << 21)) as f64;
/// 8 u, see above.
const ERROR_PER_MAGNITUDE: f64 = 4.0 * f64::EPSILON;
/// Products below the range of `f64` lose at most this much, with the largest coordinates of samples.
const UNDERFLOW: f64 = f64::MIN_POSITIVE * 268_435_456.0;

/// The first row (or column) whose center is at or after the coordinate `x_times_w / w`; w is positive.
pub(super) fn first_center_from(x_times_w: f64, w: f64) -> i64 {
    let place = x_times_w / w - 0.5;
    if place.is_nan() || place.abs() > LIMIT {
        return if place > 0.0 { LIMIT as i64 } else { -LIMIT as i64 };
    }
    // The quotient errs by less than 2^-29 here. Nearer to a whole number than that, compare (2 n + 1) w with 2 x w: one
    // fused operation, rounded once, has the sign of the exact difference.
    let nearest = place.round();
    if (place - nearest).abs() > 1e-8 {
        return place.ceil() as i64;
    }
    let is_at_or_after = (2.0 * nearest + 1.0).mul_add(w, -2.0 * x_times_w) >= 0.0;
    nearest as i64 + i64::from(!is_at_or_after)
}

/// An edge between two points (x w, y w, w), turned downward.
#[derive(Clone, Copy, Debug)]
pub(super) struct ExactEdge {
    top: Vec3,
    bottom: Vec3,
}

impl ExactEdge {
    pub fn downward(start: Vec3, end: Vec3) -> ExactEdge {
        // Ends between the same two rows are in no order, and need none.
        if first_center_from(start.y, start.z) <= first_center_from(end.y, end.z) {
            ExactEdge { top: start, bottom: end }
        } else {
            ExactEdge { top: end, bottom: start }
        }
    }

    /// Where it begins, in samples; rounded.
    pub fn start(&self) -> [f64; 2] {
        [self.top.x / self.top.z, self.top.y / self.top.z]
    }

    /// Samples to the right for every row down; rounded, infinite for horizontal edges.
    pub fn slope(&self) -> f64 {
        let ([x, y], bottom) = (self.start(), self.bottom);
        (bottom.x / bottom.z - x) / (bottom.y / bottom.z - y)
    }

    pub fn rows(&self) -> Range<i64> {
        first_center_from(self.top.y, self.top.z)..first_center_from(self.bottom.y, self.bottom.z)
    }

    /// The first column whose center is at or right of the edge on the center line of `row`, a row it crosses.
    pub fn first_column(&self, row: i64) -> i64 {
        let (t, b) = (self.top, self.bottom);
        let terms = [(t.y * b.z, b.y * t.z), (t.z * b.x, b.z * t.x), (t.x * b.y, b.x * t.y)];
        let [along_x, along_y, constant] = terms.map(|(plus, minus)| plus - minus);
        let [x_size, y_size, size] = terms.map(|(plus, minus)| plus.abs() + minus.abs());
        let height = (2 * row + 1) as f64;
        let (at_row, size_at_row) = (along_y * height + 2.0 * constant, y_size * height + 2.0 * size);

        // Guess by a quotient, clamped; prove that the guess is right of the edge or on it, and the column before is not.
        let guess = (-at_row / along_x * 0.5 - 0.5).ceil();
        let guess = if guess.abs() <= LIMIT { guess } else { LIMIT.copysign(guess) };
        let place = 2.0 * guess + 1.0;
        let value = along_x * place + at_row;
        let error = ERROR_PER_MAGNITUDE * (x_size * (place.abs() + 2.0) + size_at_row) + UNDERFLOW;
        let before = along_x * (place - 2.0) + at_row;
        if value < -error && before > error {
            return guess as i64;
        }
        // Far beyond the picture, which side is enough.
        if (guess == LIMIT && value > error) || (guess == -LIMIT && value < -error) {
            return guess as i64;
        }
        self.search(row, guess)
    }

    /// Whether the center of a sample is at or right of the edge: exact.
    fn is_at_or_right(&self, column: i64, row: i64) -> bool {
        edge_side(self.top, self.bottom, [2 * column as i32 + 1, 2 * row as i32 + 1, 2]) != Ordering::Greater
    }

    /// As [`ExactEdge::first_column`], by exact signs from a guess on.
    #[cold]
    fn search(&self, row: i64, guess: f64) -> i64 {
        let limit = LIMIT as i64;
        let guess = if guess.is_nan() { 0 } else { guess as i64 };
        // Mostly the guess is right, or one off; if not, halve what is left.
        let (mut low, mut high) = (-limit, limit);
        for column in [guess, guess - 1, guess + 1] {
            if column > low && column < high {
                if self.is_at_or_right(column, row) { high = column } else { low = column }
            }
        }
        while high - low > 1 {
            let middle = low + (high - low) / 2;
            if self.is_at_or_right(middle, row) { high = middle } else { low = middle }
        }
        high
    }
}
