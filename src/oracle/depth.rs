//! Depth: which of two polygons is nearer at a sample, in the two meanings that "nearer" has.
//!
//! [`DepthOrder::Contract`] follows the written definition that every rasterizer must meet to the bit: the stored plane in
//! `f64` at the first sample center of each 16 x 16 block, rounded once to `f32`, a dx + b dy added in `f32`, held within
//! the range at the corners. [`DepthOrder::True`] asks the polygons themselves: the plane through three corners before
//! snapping, compared as fractions of exact numbers. Where the two disagree, the separation is below the digits of `f32`.
//!
//! With the corners (x w, y w, w) and the sample s = (px, py, 1), the plane n.P = d of three corners meets the ray through
//! s where 1/w = n.s / d.
//!
//! Space: samples. Cost: contract: one evaluation a sample; true: the same in `f64`, and exact numbers where that cannot tell.

use super::number::Exact;
use crate::math::Vec3;
use crate::plan::DepthFormat;
use crate::screen::{DrawList, Evaluation, Plane, ScreenPolygon};
use std::cmp::Ordering;

/// What "nearer" means.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DepthOrder {
    /// As the contract's planes say, rounded as it says.
    #[default]
    Contract,
    /// As the corners say, without rounding.
    True,
}

/// The depth of one polygon, ready to be asked.
#[derive(Clone, Debug)]
pub enum Depth {
    /// By the contract.
    Contract(Plane),
    /// By its corners.
    True(Box<TruePlane>),
}

/// 1/w as a fraction of exact numbers, with what `f64` needs to decide most comparisons alone.
#[derive(Clone, Debug)]
pub struct TruePlane {
    normal: [Exact; 3],
    /// Not zero; the signs of normal and distance are such that it is positive.
    distance: Exact,
    /// n / d, each within 2^-50 of its size.
    slopes: [f64; 3],
    /// How far n / d may be off because the corners themselves are rounded.
    slack: [f64; 3],
    /// What 1/w is held within, as by the contract.
    range: (f64, f64),
}

impl Depth {
    /// The depth of `polygon` under `order`; `None` in lists without depth, and where a corner is not finite.
    #[must_use]
    pub fn new(polygon: &ScreenPolygon<'_>, order: DepthOrder) -> Option<Depth> {
        let plane = polygon.depth_plane()?;
        match order {
            DepthOrder::Contract => Some(Depth::Contract(*plane)),
            DepthOrder::True => {
                let corners: Vec<Vec3> = polygon.vertices().iter().map(|vertex| vertex.homogeneous).collect();
                TruePlane::new(&corners, (plane.low, plane.high)).map(|plane| Depth::True(Box::new(plane)))
            }
        }
    }

    /// Depth at sample (x, y) as a number: the contract's depth of `list` to the bit, or 1/w to within its last digits.
    #[must_use]
    pub fn at(&self, list: &DrawList, (x, y): (i32, i32)) -> f64 {
        match self {
            Depth::Contract(plane) => contract_depth(list, plane, (x, y)),
            Depth::True(plane) => plane.rounded(x, y).0,
        }
    }

    /// How far apart two depths must be, beyond a band relative to their size, for their order to be beyond dispute: the
    /// corners of both planes are rounded numbers.
    #[must_use]
    pub fn slack(&self, (x, y): (i32, i32)) -> f64 {
        match self {
            Depth::Contract(_) => 0.0,
            Depth::True(plane) => {
                let [across, down, constant] = plane.slack;
                across * (f64::from(x) + 0.5) + down * (f64::from(y) + 0.5) + constant
            }
        }
    }

    /// The order of two depths at a sample; greater is nearer.
    #[must_use]
    pub fn compare(&self, other: &Depth, list: &DrawList, sample: (i32, i32)) -> Ordering {
        match (self, other) {
            (Depth::True(a), Depth::True(b)) => a.compare(b, sample),
            _ => self.at(list, sample).total_cmp(&other.at(list, sample)),
        }
    }
}

/// The contract, written a second time: `raster/` and `screen/plane.rs` have the first.
fn contract_depth(list: &DrawList, plane: &Plane, (x, y): (i32, i32)) -> f64 {
    let at = |column: i32, row: i32| {
        let (px, py) = (f64::from(2 * column + 1) / 2.0, f64::from(2 * row + 1) / 2.0);
        (plane.a * px + plane.b * py) + plane.c
    };
    let value = match plane.evaluation {
        Evaluation::Constant => plane.c,
        // A depth never runs along scan lines; were one marked so, its plane would still be one.
        Evaluation::Double | Evaluation::ScanLine => at(x, y),
        Evaluation::Samples => f64::from(at(x, y) as f32),
        Evaluation::Blocks => {
            let (dx, dy) = (x.rem_euclid(16), y.rem_euclid(16));
            let first = at(x - dx, y - dy) as f32;
            let (right, down) = ((plane.a as f32) * (dx as f32), (plane.b as f32) * (dy as f32));
            f64::from(first + (right + down))
        }
    };
    // In this order even an empty range gives an end of it.
    let inverse_w = if value < plane.low { plane.low } else { value.min(plane.high) };
    let mapping = &list.depth_mapping;
    let most = match mapping.format {
        DepthFormat::F32 | DepthFormat::F64 => return inverse_w,
        DepthFormat::Int24 => 16_777_215.0,
        DepthFormat::Int16 => 65_535.0,
    };
    let share = (inverse_w - mapping.farthest) / (mapping.nearest - mapping.farthest);
    // Step 0 means infinitely far: 1 is yon, the last is hither.
    (1.0 + share * (most - 1.0)).round().max(1.0).min(most)
}

impl TruePlane {
    /// The plane of `corners`, (x w, y w, w), held within `range`; `None` where they are not finite or not in front.
    fn new(corners: &[Vec3], range: (f64, f64)) -> Option<TruePlane> {
        let three = widest(corners)?;
        let exact = |corner: Vec3| -> Option<[Exact; 3]> {
            Some([Exact::new(corner.x)?, Exact::new(corner.y)?, Exact::new(corner.z)?])
        };
        let [a, b, c] = [exact(three[0])?, exact(three[1])?, exact(three[2])?];
        let minus = |p: &[Exact; 3], q: &[Exact; 3]| -> [Exact; 3] { std::array::from_fn(|axis| &p[axis] - &q[axis]) };
        let (first, second) = (minus(&b, &a), minus(&c, &a));
        let minor = |p: usize, q: usize| &(&first[p] * &second[q]) - &(&first[q] * &second[p]);
        let normal = [minor(1, 2), minor(2, 0), minor(0, 1)];
        let distance = &(&(&normal[0] * &a[0]) + &(&normal[1] * &a[1])) + &(&normal[2] * &a[2]);
        match distance.sign() {
            Ordering::Greater => Some(TruePlane::of(normal, distance, three, range)),
            Ordering::Less => Some(TruePlane::of(normal.map(|n| -&n), -&distance, three, range)),
            // Without area or seen edge-on there is no plane: as far away as its first corner.
            Ordering::Equal => {
                let [_, _, w] = exact(corners[0])?;
                let one = Exact::new(1.0)?;
                let flat = [Exact::default(), Exact::default(), one];
                (w.sign().is_gt()).then(|| TruePlane::of(flat, w, [corners[0]; 3], range))
            }
        }
    }

    fn of(normal: [Exact; 3], distance: Exact, three: [Vec3; 3], range: (f64, f64)) -> TruePlane {
        let d = distance.approximate();
        let n = normal.each_ref().map(Exact::approximate);
        let slopes = n.map(|n| n / d);
        // First-order change of n and d when every coordinate of the corners moves by its last digit.
        let [a, b, c] = three;
        let (first, second) = ((b - a).abs(), (c - a).abs());
        let (first_off, second_off) = ((a.abs() + b.abs()) * f64::EPSILON, (a.abs() + c.abs()) * f64::EPSILON);
        let moved = |p: usize, q: usize| {
            first[p] * second_off[q] + first_off[p] * second[q] + first[q] * second_off[p] + first_off[q] * second[p]
        };
        let n_off = [moved(1, 2), moved(2, 0), moved(0, 1)];
        let d_off: f64 = (0..3).map(|axis| (n_off[axis] + n[axis].abs() * f64::EPSILON) * a[axis].abs()).sum();
        let slack = std::array::from_fn(|axis| (n_off[axis] + slopes[axis].abs() * d_off) / d);
        TruePlane { normal, distance, slopes, slack, range }
    }

    /// 1/w at a sample, and how far the arithmetic may have left it from the fraction.
    fn rounded(&self, x: i32, y: i32) -> (f64, f64) {
        let (px, py) = (f64::from(x) + 0.5, f64::from(y) + 0.5);
        let [a, b, c] = self.slopes;
        let (right, down) = (a * px, b * py);
        let error = (right.abs() + down.abs() + c.abs()) * (16.0 * f64::EPSILON);
        (self.held(right + down + c), error)
    }

    fn held(&self, value: f64) -> f64 {
        let (low, high) = self.range;
        if value < low { low } else { value.min(high) }
    }

    fn compare(&self, other: &TruePlane, (x, y): (i32, i32)) -> Ordering {
        let ((a, a_error), (b, b_error)) = (self.rounded(x, y), other.rounded(x, y));
        // Written so that NaN goes the exact way.
        if (a - b).abs() > a_error + b_error && a.min(b) > 1e-280 {
            return a.total_cmp(&b);
        }
        let ((a, a_below), (b, b_below)) = (self.fraction(x, y), other.fraction(x, y));
        (&(&a * &b_below) - &(&b * &a_below)).sign()
    }

    /// 1/w at a sample as numerator and positive denominator.
    fn fraction(&self, x: i32, y: i32) -> (Exact, Exact) {
        let whole = |value: f64| Exact::new(value).unwrap_or_default();
        let across = &self.normal[0] * &whole(f64::from(x) + 0.5);
        let down = &self.normal[1] * &whole(f64::from(y) + 0.5);
        let above = &(&across + &down) + &self.normal[2];
        let beyond = |end: f64| (&above - &(&whole(end) * &self.distance)).sign();
        let (low, high) = self.range;
        if beyond(low).is_lt() {
            (whole(low), whole(1.0))
        } else if beyond(high).is_gt() {
            (whole(high), whole(1.0))
        } else {
            (above, self.distance.clone())
        }
    }
}

/// Three corners that span much: the first, the one farthest from it, and the one farthest from their line.
fn widest(corners: &[Vec3]) -> Option<[Vec3; 3]> {
    let &first = corners.first()?;
    let largest = |size: &dyn Fn(Vec3) -> f64| {
        corners.iter().copied().max_by(|&a, &b| size(a).total_cmp(&size(b))).unwrap_or(first)
    };
    let second = largest(&|corner| (corner - first).length_squared());
    let third = largest(&|corner| (second - first).cross(corner - first).length_squared());
    Some([first, second, third])
}
