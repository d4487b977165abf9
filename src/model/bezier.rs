//! Bezier curves: a cubic cut in two at a parameter, from which its point and its direction there can be read.
//!
//! `patches` and `curves` -> BEZIER
//!
//! Why de Casteljau and not powers of t: four equal control points give that very point, ends are control points to the last
//! bit, and a curve read backwards gives the same points. So two neighbors agree on their common border
//! whichever way each of them runs along it, and nothing opens between them.
//!
//! Source: P. de Casteljau, 1959; G. Farin, "Curves and Surfaces for Computer Aided Geometric Design", 1988. Cost: six mixes a point.

use crate::math::Vec3;

/// Lengths below this part of the whole count as none: far above rounding, far below anything drawn.
const NO_LENGTH: f64 = 1e-12;

/// A parameter from 0 to 1, and what is left of it to 1: computed apart, so that both ends are alike.
#[derive(Clone, Copy, Debug)]
pub(super) struct At {
    t: f64,
    rest: f64,
}

impl At {
    /// `i / n`.
    pub fn step(i: u32, n: u32) -> At {
        At { t: f64::from(i) / f64::from(n), rest: f64::from(n - i) / f64::from(n) }
    }

    /// A parameter `part` of the way to the middle.
    pub fn inward(self, part: f64) -> At {
        At { t: self.t + (0.5 - self.t) * part, rest: self.rest + (0.5 - self.rest) * part }
    }

    /// From `a` to `b`. Swapping both the ends and the parameter gives the same bits.
    fn mix(self, a: Vec3, b: Vec3) -> Vec3 {
        if self.t < self.rest {
            a + (b - a) * self.t
        } else if self.t > self.rest {
            b + (a - b) * self.rest
        } else {
            (a + b) * 0.5
        }
    }
}

/// A cubic cut in two: the control points of both halves. `left[3]` and `right[0]` are the point of the cut.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cut {
    pub left: [Vec3; 4],
    pub right: [Vec3; 4],
}

/// Cuts the cubic over four control points.
pub(super) fn cut(&[a, b, c, d]: &[Vec3; 4], at: At) -> Cut {
    let (ab, bc, cd) = (at.mix(a, b), at.mix(b, c), at.mix(c, d));
    let (abc, bcd) = (at.mix(ab, bc), at.mix(bc, cd));
    let point = at.mix(abc, bcd);
    Cut { left: [a, ab, abc, point], right: [point, bcd, cd, d] }
}

impl Cut {
    /// The point of the curve.
    pub fn point(&self) -> Vec3 {
        self.right[0]
    }

    /// The derivative by the parameter.
    pub fn derivative(&self) -> Vec3 {
        (self.right[1] - self.left[2]) * 3.0
    }

    /// A direction in which the curve goes on: the derivative or, where control points coincide and it vanishes, its limit.
    ///
    /// The limit at the start of a cubic is the way to the first control point that is somewhere else. Zero for a point.
    pub fn tangent(&self) -> Vec3 {
        let [_, _, from_2, from_3] = self.right.map(|later| later - self.right[0]);
        let [to_0, to_1, ..] = self.left.map(|earlier| self.left[3] - earlier);
        let size =
            self.left.iter().chain(&self.right).map(|&point| (point - self.left[0]).length()).fold(0.0, f64::max);
        let candidates = [self.derivative(), from_2, from_3, to_1, to_0];
        candidates.into_iter().find(|way| way.length() > NO_LENGTH * size).unwrap_or(Vec3::ZERO)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ARC: [Vec3; 4] =
        [Vec3::new(0.1, 0.7, -3.0), Vec3::new(1.3, 0.2, 0.9), Vec3::new(2.7, -4.1, 0.3), Vec3::new(0.4, 5.5, 1.1)];

    #[test]
    fn points_are_bernsteins_and_do_not_depend_on_the_direction() {
        let mut backward = ARC;
        backward.reverse();
        for (i, n) in [1, 3, 7, 10].into_iter().flat_map(|n| (0..=n).map(move |i| (i, n))) {
            let t = f64::from(i) / f64::from(n);
            let s = 1.0 - t;
            let weights = [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t];
            let expected: Vec3 = ARC.iter().zip(weights).map(|(&point, weight)| point * weight).sum();
            let (here, there) = (cut(&ARC, At::step(i, n)), cut(&backward, At::step(n - i, n)));
            assert!((here.point() - expected).length() < 1e-14);
            assert_eq!(here.point(), there.point(), "{i}/{n}");
            let slopes = [-3.0 * s * s, 3.0 * s * s - 6.0 * s * t, 6.0 * s * t - 3.0 * t * t, 3.0 * t * t];
            let expected: Vec3 = ARC.iter().zip(slopes).map(|(&point, slope)| point * slope).sum();
            assert!((here.derivative() - expected).length() < 1e-13);
        }
        assert_eq!((cut(&ARC, At::step(0, 3)).point(), cut(&ARC, At::step(3, 3)).point()), (ARC[0], ARC[3]));
        assert_eq!(cut(&[ARC[0]; 4], At::step(2, 7)).point(), ARC[0]);
    }

    #[test]
    fn coincident_control_points_leave_a_direction() {
        let [a, b, c, d] = [Vec3::ZERO, Vec3::X, Vec3::new(1.0, 1.0, 0.0), Vec3::Y];
        assert_eq!(cut(&[a, a, c, d], At::step(0, 4)).tangent(), c);
        assert_eq!(cut(&[a, a, a, d], At::step(0, 4)).tangent(), d);
        assert_eq!(cut(&[a, b, d, d], At::step(4, 4)).tangent(), d - b);
        assert_eq!(cut(&[a, d, d, d], At::step(4, 4)).tangent(), d);
        assert_eq!(cut(&[d; 4], At::step(1, 4)).tangent(), Vec3::ZERO);
    }
}
