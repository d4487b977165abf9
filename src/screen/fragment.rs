//! One sample of one polygon, and the interpolated values a fragment is shaded from.

use crate::color::Rgb;

/// What a polygon shows at one sample: handed to the target by a rasterizer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fragment {
    /// Column, 0 is the leftmost. Signed, so that a wrong rounding is a stray write that is counted, not a crash.
    pub x: i32,
    /// Row, 0 is the uppermost.
    pub y: i32,
    /// 1/w at the sample's center, larger is nearer (with integer depth formats: steps, larger is nearer).
    pub depth: f64,
    /// Linear light.
    pub color: Rgb<f32>,
    /// 1 hides what is behind, 0 is invisible; per channel.
    pub opacity: Rgb<f32>,
    /// Which polygon of the list it belongs to: decides ties.
    pub polygon: u32,
}

impl Fragment {
    /// What a polygon shows where it has a hole: nothing, infinitely far away. Targets drop it; depth stays what it is.
    #[must_use]
    pub fn hole(x: i32, y: i32, polygon: u32) -> Fragment {
        let (color, opacity) = (Rgb::gray(0.0), Rgb::gray(0.0));
        Fragment { x, y, depth: 0.0, color, opacity, polygon }
    }

    /// Whether nothing is there: neither color nor depth is to be put.
    #[must_use]
    #[inline]
    pub fn is_hole(&self) -> bool {
        self.depth <= 0.0 && self.opacity == Rgb::gray(0.0)
    }
}

/// Interpolated values of one sample: red, green, blue; or normal and eye point; behind them u and v, where surfaces have pictures.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Values {
    numbers: [f64; Values::MAX],
    count: usize,
}

impl Values {
    /// The most numbers any [`crate::plan::Varying`] has.
    pub const MAX: usize = 11;

    /// Values from their numbers; at most [`Values::MAX`], further ones are dropped.
    #[must_use]
    pub fn new(numbers: &[f64]) -> Values {
        let mut values = Values::default();
        numbers.iter().take(Values::MAX).for_each(|&number| values.push(number));
        values
    }

    /// Adds one number.
    #[inline]
    pub(crate) fn push(&mut self, number: f64) {
        self.numbers[self.count] = number;
        self.count += 1;
    }
}

impl std::ops::Deref for Values {
    type Target = [f64];
    #[inline]
    fn deref(&self) -> &[f64] {
        &self.numbers[..self.count]
    }
}
