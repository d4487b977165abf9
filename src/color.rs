//! Vocabulary: colors, and the one place where display values and light meet.
//!
//! Why light: adding two lamps, blending through glass and averaging samples are sums of *light*. Numbers on a
//! display are not light: 8-bit sRGB value 128 is 22 % of the light of 255. So scene colors are decoded once on
//! reading, everything between is linear, and the picture is encoded once on writing (`Encoding::Srgb`).
//! `Encoding::Linear` passes numbers straight through, as FAROP did in 1996.
//!
//! Source: IEC 61966-2-1 (1999), sRGB transfer curve.

mod levels;

use crate::math::pow;
use std::ops::{Add, AddAssign, Mul, Sub};

/// Red, green and blue. `Rgb` (in `f64`) for scenes and lighting, `Rgb<f32>` for pixels. Linear light unless said otherwise.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rgb<T = f64> {
    /// Red, 0 to 1 on a display; light may exceed 1 until the picture is written.
    pub r: T,
    /// Green.
    pub g: T,
    /// Blue.
    pub b: T,
}

impl Rgb {
    /// No light.
    pub const BLACK: Rgb = Rgb { r: 0.0, g: 0.0, b: 0.0 };
    /// Full display white.
    pub const WHITE: Rgb = Rgb { r: 1.0, g: 1.0, b: 1.0 };

    /// Rounds each channel once, to the nearest `f32`.
    #[must_use]
    #[inline]
    pub fn to_f32(self) -> Rgb<f32> {
        self.map(|channel| channel as f32)
    }
}

impl Rgb<f32> {
    /// Widens each channel; exact.
    #[must_use]
    #[inline]
    pub fn to_f64(self) -> Rgb {
        self.map(f64::from)
    }
}

impl<T: Copy> Rgb<T> {
    /// A color of three channels.
    #[must_use]
    #[inline]
    pub const fn new(r: T, g: T, b: T) -> Self {
        Rgb { r, g, b }
    }

    /// Red, green and blue all `value`.
    #[must_use]
    #[inline]
    pub const fn gray(value: T) -> Self {
        Rgb { r: value, g: value, b: value }
    }

    /// Applies `f` to each channel.
    #[must_use]
    #[inline]
    pub fn map<U>(self, f: impl Fn(T) -> U) -> Rgb<U> {
        Rgb { r: f(self.r), g: f(self.g), b: f(self.b) }
    }

    /// The channels in the order red, green, blue.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [T; 3] {
        [self.r, self.g, self.b]
    }
}

impl<T> From<[T; 3]> for Rgb<T> {
    fn from([r, g, b]: [T; 3]) -> Self {
        Rgb { r, g, b }
    }
}

impl<T: Add<Output = T>> Add for Rgb<T> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Rgb { r: self.r + other.r, g: self.g + other.g, b: self.b + other.b }
    }
}

impl<T: Copy + Add<Output = T>> AddAssign for Rgb<T> {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<T: Sub<Output = T>> Sub for Rgb<T> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Rgb { r: self.r - other.r, g: self.g - other.g, b: self.b - other.b }
    }
}

impl<T: Mul<Output = T>> Mul for Rgb<T> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Rgb { r: self.r * other.r, g: self.g * other.g, b: self.b * other.b }
    }
}

impl<T: Copy + Mul<Output = T>> Mul<T> for Rgb<T> {
    type Output = Self;
    #[inline]
    fn mul(self, factor: T) -> Self {
        self.map(|channel| channel * factor)
    }
}

/// How the numbers of scene files and of 8-bit pictures relate to light.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Encoding {
    /// Scene colors are display values: decoded on reading, light added linearly, encoded once on writing.
    #[default]
    Srgb,
    /// Numbers straight through, as in 1996.
    Linear,
}

impl Encoding {
    /// The name on the command line and in files: `srgb` or `linear`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Encoding::Srgb => "srgb",
            Encoding::Linear => "linear",
        }
    }

    /// Light of a display value (0..1; values above 1 follow the same curve).
    #[must_use]
    pub fn decode(self, display: Rgb) -> Rgb {
        match self {
            Encoding::Srgb => display.map(srgb_decode),
            Encoding::Linear => display,
        }
    }

    /// Display value (0..1) of light; the inverse of [`Encoding::decode`].
    #[must_use]
    pub fn encode(self, light: Rgb) -> Rgb {
        match self {
            Encoding::Srgb => light.map(srgb_encode),
            Encoding::Linear => light,
        }
    }

    /// The 8-bit display level nearest to a channel of light; below 0 gives 0, above 1 gives 255.
    #[must_use]
    #[inline]
    pub fn level(self, light: f32) -> u8 {
        match self {
            Encoding::Linear => levels::linear(light),
            Encoding::Srgb => levels::srgb(light, levels::table()),
        }
    }
}

fn srgb_decode(display: f64) -> f64 {
    if display <= 0.04045 { display / 12.92 } else { pow((display + 0.055) / 1.055, 2.4) }
}

fn srgb_encode(light: f64) -> f64 {
    if light <= 0.003_130_8 { light * 12.92 } else { 1.055 * pow(light, 1.0 / 2.4) - 0.055 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_equal_the_rounded_curve() {
        let mut light = 0.0f32;
        while light < 1.1 {
            let rounded = (srgb_encode(f64::from(light)) * 255.0).round().clamp(0.0, 255.0) as u8;
            assert_eq!(Encoding::Srgb.level(light), rounded, "light {light}");
            light += 1.7e-5;
        }
    }

    #[test]
    fn linear_levels_are_the_nearest() {
        for level in 0..=255u32 {
            // Where the next level begins, and its neighbors among the floats.
            let border = ((f64::from(level) + 0.5) / 255.0) as f32;
            for light in [border, border.next_up(), border.next_down(), border / 3.0, -border] {
                let rounded = (f64::from(light) * 255.0).round().clamp(0.0, 255.0) as u8;
                assert_eq!(Encoding::Linear.level(light), rounded, "light {light}");
            }
        }
    }

    #[test]
    fn levels_outside_the_display_are_clamped() {
        for encoding in [Encoding::Srgb, Encoding::Linear] {
            assert_eq!(encoding.level(-1.0), 0);
            assert_eq!(encoding.level(7.0), 255);
            assert_eq!(encoding.level(f32::NAN), 0);
            assert_eq!(encoding.level(f32::INFINITY), 255);
        }
    }

    #[test]
    fn every_level_survives_decode_and_encode() {
        for level in 0..=255u8 {
            let light = Encoding::Srgb.decode(Rgb::gray(f64::from(level) / 255.0));
            assert_eq!(Encoding::Srgb.level(light.r as f32), level);
        }
    }
}
