//! Quarters: which sample decides about another, when boxes are quartered until no edge comes near (Warnock), with a slip.
//!
//! Cost: edges times the logarithm of the picture's size, a sample.

use super::rules::Quarters;
use crate::math::edges;

type Point = (f64, f64);

/// The upper left sample of the box that (x, y) is decided in; `None` when nobody looks at it.
pub(super) fn asked(corners: &[Point], slip: Quarters, size: (i32, i32), (x, y): (i32, i32)) -> Option<(i32, i32)> {
    let (mut left, mut top, mut width, mut height) = (0, 0, size.0, size.1);
    let smallest = if let Quarters::Smallest(side) = slip { side } else { 1 };
    loop {
        let is_small = width <= smallest && height <= smallest;
        if is_small || !is_near(corners, slip, (left, top), (width, height)) {
            return Some((left, top));
        }
        let half = |size: i32| match slip {
            Quarters::OddCut => ((size / 2).max(1), if size > 1 { size / 2 } else { 0 }),
            _ => ((size + 1) / 2, size / 2),
        };
        let ((w, rest_w), (h, rest_h)) = (half(width), half(height));
        let (is_right, is_below) = (x >= left + w, y >= top + h);
        (left, width) = if is_right { (left + w, rest_w) } else { (left, w) };
        (top, height) = if is_below { (top + h, rest_h) } else { (top, h) };
        if x >= left + width || y >= top + height {
            return None;
        }
        if slip == Quarters::Lost(u8::from(is_right) + 2 * u8::from(is_below)) {
            return None;
        }
    }
}

/// Whether an edge may come into the box around the centers.
fn is_near(corners: &[Point], slip: Quarters, (x, y): (i32, i32), (width, height): (i32, i32)) -> bool {
    let (left, top) = (f64::from(x) + 0.5, f64::from(y) + 0.5);
    let (right, bottom) = (left + f64::from(width - 1), top + f64::from(height - 1));
    if slip == Quarters::CornersOnly {
        return corners.iter().any(|&(x, y)| left <= x && x <= right && top <= y && y <= bottom);
    }
    let last = corners.len() - 1;
    edges(corners).enumerate().any(|(number, (a, b))| {
        let is_forgotten = match slip {
            Quarters::EdgeForgotten { closing } => number == if closing { last } else { 0 },
            _ => false,
        };
        let beside = a.0.max(b.0) < left || a.0.min(b.0) > right || a.1.max(b.1) < top || a.1.min(b.1) > bottom;
        !is_forgotten && !beside
    })
}
