//! Summed: depth and values that are added up along a span, from its first sample on, with a step that is not exact.
//!
//! Space: samples. Cost: the face's edges, a sample.

use super::case::Face;
use crate::math::edges;

/// How a span is walked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Summed {
    /// The step is kept in parts: one over this. Nothing is lost where it is infinite.
    pub parts: f64,
    /// It is cut to them, not rounded.
    pub is_cut: bool,
    /// It is that from the first sample to the last, not that of the plane.
    pub between_samples: bool,
}

impl Summed {
    fn step(self, step: f64) -> f64 {
        if self.parts.is_infinite() {
            return step;
        }
        let parts = step * self.parts;
        (if self.is_cut { parts.trunc() } else { parts.round() }) / self.parts
    }

    /// A number at a sample's center, where `of` is that number at other points of its row.
    pub fn at(self, face: &Face, (x, y): (f64, f64), of: impl Fn((f64, f64)) -> f64) -> f64 {
        let Some((first, last)) = span(face, (x, y)) else { return of((x, y)) };
        let start = of((first, y));
        let step = if self.between_samples {
            if last > first { (of((last, y)) - start) / (last - first) } else { 0.0 }
        } else {
            of((first + 1.0, y)) - start
        };
        start + self.step(step) * (x - first)
    }
}

/// The first and the last center of the span around a point.
pub(super) fn span(face: &Face, (x, y): (f64, f64)) -> Option<(f64, f64)> {
    let crosses = |(a, b): (&(f64, f64), &(f64, f64))| {
        let (top, bottom) = if a.1 <= b.1 { (a, b) } else { (b, a) };
        let is_there = top.1 <= y && y < bottom.1;
        is_there.then(|| top.0 + (y - top.1) * (bottom.0 - top.0) / (bottom.1 - top.1))
    };
    let (mut left, mut right) = (None, None);
    for crossing in edges(&face.corners).filter_map(crosses) {
        if crossing <= x {
            left = Some(left.map_or(crossing, |left: f64| left.max(crossing)));
        } else {
            right = Some(right.map_or(crossing, |right: f64| right.min(crossing)));
        }
    }
    Some(((left? - 0.5).ceil() + 0.5, (right? - 0.5).ceil() - 0.5))
}
