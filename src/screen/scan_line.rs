//! Values along a scan line: Gouraud's interpolation of 1971, over a whole polygon with any number of corners.
//!
//! corners, sample -SCAN LINE-> value. Asked for by `--interpolation scanline`; else planes are used (`plane`).
//!
//! The scan line through the sample's center crosses the outline an even number of times. Of the two crossings around
//! the center each takes its value linearly from the ends of its edge, and the sample takes its own linearly from the
//! two. Nothing else of the polygon counts. That is why it is cheap to build, and why it is no property of the
//! polygon: turn the camera about its axis, and other edges stand left and right of the same point.
//!
//! Why a function of outline and sample alone, when an incremental rasterizer steps `color += dcolor`: every rasterizer
//! gets the same bits, whatever it draws first and on how many threads. Edges are walked from their upper end, so two
//! polygons see the same value on the edge they share.
//!
//! Space: samples, the snapped outline: then a covered sample always has a crossing on either side.
//! Source: H. Gouraud, "Continuous Shading of Curved Surfaces", IEEE Transactions on Computers C-20(6), 1971.
//! Cost: one comparison an edge and one division an edge that is crossed, for every sample.

use super::ScreenVertex;

/// The two crossings of a scan line that stand around a sample.
#[derive(Clone, Copy, Debug)]
pub(super) struct ScanLine {
    left: Crossing,
    right: Crossing,
    /// How far the sample is on its way from left to right, 0 to 1.
    share: f64,
}

/// Where the scan line crosses an edge.
#[derive(Clone, Copy, Debug)]
struct Crossing {
    x: f64,
    /// Corners at the ends of the edge.
    upper: usize,
    lower: usize,
    /// How far down the edge it is, 0 to 1.
    share: f64,
}

impl ScanLine {
    /// The crossings around the center of sample (x, y); `None` where the scan line misses the outline.
    pub fn around(outline: &[ScreenVertex], x: i32, y: i32) -> Option<ScanLine> {
        let (center_x, center_y) = (f64::from(x) + 0.5, f64::from(y) + 0.5);
        let (mut left, mut right): (Option<Crossing>, Option<Crossing>) = (None, None);
        for from in 0..outline.len() {
            let to = (from + 1) % outline.len();
            let (upper, lower) = if outline[from].y <= outline[to].y { (from, to) } else { (to, from) };
            let (top, bottom) = (&outline[upper], &outline[lower]);
            // Coverage's rule: a center on the upper end belongs to the edge, on the lower end to the next one.
            if !(top.y <= center_y && center_y < bottom.y) {
                continue;
            }
            let share = (center_y - top.y) / (bottom.y - top.y);
            let crossing = Crossing { x: top.x + (bottom.x - top.x) * share, upper, lower, share };
            // Which side, from products that round nothing on pictures up to 2^17 samples: x itself is rounded.
            let at_or_left = (bottom.x - top.x) * (center_y - top.y) <= (center_x - top.x) * (bottom.y - top.y);
            if at_or_left && left.is_none_or(|nearest| nearest.x < crossing.x) {
                left = Some(crossing);
            }
            if !at_or_left && right.is_none_or(|nearest| crossing.x < nearest.x) {
                right = Some(crossing);
            }
        }
        // Outside the outline one side may be missing: the other speaks alone.
        let (left, right) = (left.or(right)?, right.or(left)?);
        let width = right.x - left.x;
        let share = if width > 0.0 { ((center_x - left.x) / width).clamp(0.0, 1.0) } else { 0.0 };
        Some(ScanLine { left, right, share })
    }

    /// The value at the sample of what is `at_corner` at the corners.
    pub fn value(&self, at_corner: impl Fn(usize) -> f64) -> f64 {
        let on_edge = |crossing: &Crossing| lerp(at_corner(crossing.upper), at_corner(crossing.lower), crossing.share);
        lerp(on_edge(&self.left), on_edge(&self.right), self.share)
    }
}

/// From `a` at share 0 to `b` at share 1; exact at both ends.
fn lerp(a: f64, b: f64, share: f64) -> f64 {
    a * (1.0 - share) + b * share
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Vec3;
    use crate::screen::EdgeKind;

    fn value(outline: &[(f64, f64)], values: &[f64], (x, y): (i32, i32)) -> Option<f64> {
        let edge = EdgeKind::Original;
        let corners: Vec<_> =
            outline.iter().map(|&(x, y)| ScreenVertex { x, y, homogeneous: Vec3::new(x, y, 1.0), edge }).collect();
        ScanLine::around(&corners, x, y).map(|line| line.value(|corner| values[corner]))
    }

    #[test]
    fn the_middle_of_a_square_changes_when_the_square_is_turned() {
        let upright = [(0.5, 0.5), (4.5, 0.5), (4.5, 4.5), (0.5, 4.5)];
        let on_its_corner = [(2.5, -0.5), (5.5, 2.5), (2.5, 5.5), (-0.5, 2.5)];
        assert_eq!(value(&upright, &[0.0, 1.0, 0.0, 1.0], (2, 2)), Some(0.5));
        assert_eq!(value(&on_its_corner, &[0.0, 1.0, 0.0, 1.0], (2, 2)), Some(1.0));
    }

    #[test]
    fn beyond_a_notch_the_next_pair_of_crossings_counts() {
        // A "V": at row 1 it is 0 to 2.25 and 6.75 to 9, and the notch between has no part in either.
        let v = [(0.0, 0.0), (1.5, 0.0), (4.5, 6.0), (7.5, 0.0), (9.0, 0.0), (6.0, 9.0), (3.0, 9.0)];
        let values = [0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.0];
        assert_eq!(value(&v, &values, (1, 1)), Some(0.0));
        assert!(value(&v, &values, (7, 1)).is_some_and(|value| value > 0.7));
    }

    #[test]
    fn a_line_that_misses_the_outline_has_no_value() {
        assert_eq!(value(&[(0.0, 0.0), (2.0, 0.0), (0.0, 2.0)], &[1.0; 3], (0, 5)), None);
    }
}
