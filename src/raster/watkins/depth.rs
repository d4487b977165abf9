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
    pub fn hides(&self, other: &EndDepths, list: &DrawList) -> bool {
        let margin = self.bound + other.bound + step(list);
        (0..2).all(|end| self.ends[end] - other.ends[end] > margin)
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

/// Integer depth: a step of 1/w, within which two depths may become equal.
fn step(list: &DrawList) -> f64 {
    let mapping = &list.depth_mapping;
    let steps = match mapping.format {
        DepthFormat::F32 | DepthFormat::F64 => return 0.0,
        DepthFormat::Int24 => f64::from((1 << 24) - 1),
        DepthFormat::Int16 => f64::from((1 << 16) - 1),
    };
    2.0 * (mapping.nearest - mapping.farthest) / steps
}
