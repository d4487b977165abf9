//! Which of two polygons is in front over a whole span, as far as its ends can tell.
//!
//! The planes that are compared are evaluated with rounding, so their computed difference is not exactly linear. But each
//! computed value is within a bound of the exact plane; when the computed differences at both ends exceed the two bounds
//! together, the exact difference has the same sign at both ends, hence throughout, hence by the margin also the computed
//! one at every sample between.
//!
//! Cost: two plane evaluations a polygon and span.

use crate::plan::DepthFormat;
use crate::screen::{DrawList, Evaluation, Plane};

/// When one value of 1/w is in front of another in the depth format of a list.
#[derive(Clone, Copy, Debug)]
pub(super) struct DepthOrder {
    /// Integer depth: two steps of 1/w, within which two depths may become equal.
    margin: f64,
    /// Integer depth: beyond these all depths are equal.
    range: (f64, f64),
}

impl DepthOrder {
    /// The order of `list`.
    pub fn of(list: &DrawList) -> DepthOrder {
        let mapping = &list.depth_mapping;
        let steps = match mapping.format {
            DepthFormat::F32 | DepthFormat::F64 => {
                return DepthOrder { margin: 0.0, range: (f64::NEG_INFINITY, f64::INFINITY) };
            }
            DepthFormat::Int24 => f64::from((1 << 24) - 1),
            DepthFormat::Int16 => f64::from((1 << 16) - 1),
        };
        let margin = 2.0 * (mapping.nearest - mapping.farthest).abs() / steps;
        DepthOrder { margin, range: (mapping.farthest, mapping.nearest) }
    }

    /// Whether depth `a` is in front of depth `b` even when `bound` is taken from their difference.
    pub fn nearer(&self, a: f64, b: f64, bound: f64) -> bool {
        let seen = |inverse_w: f64| inverse_w.min(self.range.1).max(self.range.0);
        seen(a) - seen(b) > self.margin + bound
    }
}

/// Depth of one polygon at both ends of a span, with what rounding may have done to it.
#[derive(Clone, Copy, Debug)]
pub(super) struct EndDepths {
    /// 1/w at the first and the last sample.
    pub ends: [f64; 2],
    /// The computed value is within this of the exact plane, at every sample between; infinite where that is not known.
    pub bound: f64,
}

impl EndDepths {
    /// The ends of the span from `first` to `last` (inclusive) of `row`.
    pub fn new(plane: &Plane, (first, last): (i32, i32), row: i32) -> EndDepths {
        let raw = [plane.at(first, row), plane.at(last, row)];
        let ends = raw.map(|value| plane.clamp(value));
        // Clamped somewhere, it is not linear there: the ends say nothing about what lies between.
        let bound = if ends == raw { rounding_bound(plane) } else { f64::INFINITY };
        EndDepths { ends, bound }
    }

    /// Whether this is in front of `other` by more than rounding, at both ends and so everywhere between.
    pub fn hides(&self, other: &EndDepths, order: &DepthOrder) -> bool {
        (0..2).all(|end| order.nearer(self.ends[end], other.ends[end], self.bound + other.bound))
    }
}

/// How far a computed value of `plane` can be from the exact one, inside the range of the polygon's vertices.
fn rounding_bound(plane: &Plane) -> f64 {
    // The largest numbers that occur: a value of the polygon, and the step over one block.
    let change = (plane.a.abs() + plane.b.abs()) * 16.0;
    let largest = plane.high.abs().max(plane.low.abs()) + change;
    // In f64, a x + b y + c with x, y below 2^22: three roundings of numbers that may cancel.
    let exact = (plane.c.abs() + (plane.a.abs() + plane.b.abs()) * 4_194_304.0) * 4.0 * f64::EPSILON;
    match plane.evaluation {
        // Depth never runs along scan lines.
        Evaluation::Constant | Evaluation::ScanLine => 0.0,
        Evaluation::Double => exact,
        // One rounding to f32, and for blocks: of a, b, two products, their sum, and the last sum. Seven half units, doubled.
        Evaluation::Samples | Evaluation::Blocks => exact + largest * 8.0 * f64::from(f32::EPSILON),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::screen::Precision;

    #[test]
    fn computed_values_stay_within_their_bound() {
        let mut state = 1_u64;
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
        };
        let mut worst: f64 = 0.0;
        for _ in 0..20_000 {
            let (x, y) = ((random() * 4000.0) as i32 + 2000, (random() * 4000.0) as i32 + 2000);
            let (a, b) = (random() * 1e-3, random() * 1e-3);
            let value = random() + 0.6;
            let c = value - a * (f64::from(x) + 0.5) - b * (f64::from(y) + 0.5);
            let range = (value - 0.05, value + 0.05);
            let plane = Plane::new([a, b, c], range, range, Precision::Single);
            worst = worst.max((plane.at(x, y) - value).abs() / rounding_bound(&plane));
        }
        // Below 1, or the picture could be wrong; not far below, or spans would be halved for nothing.
        assert!((0.05..1.0).contains(&worst), "{worst}");
    }

    #[test]
    fn integer_depths_that_may_round_to_the_same_step_are_not_told_apart() {
        let mut list = DrawList::new(1, 1);
        list.depth_mapping.format = DepthFormat::Int16;
        let order = DepthOrder::of(&list);
        assert!(!order.nearer(0.5, 0.5 - 1.0 / 65536.0, 0.0));
        assert!(order.nearer(0.5, 0.4999, 0.0));
        assert!(!order.nearer(0.5, 0.4999, 0.001));
        // Beyond hither all depths are the same step.
        assert!(!order.nearer(3.0, 2.0, 0.0));
    }
}
