//! Vocabulary: colors, and the one place where display values and light meet.
//!
//! Why light: adding two lamps, blending through glass and averaging samples are sums of *light*. Numbers on a
//! display are not light: 8-bit sRGB value 128 is 22 % of the light of 255. So scene colors are decoded once on
//! reading, everything between is linear, and the picture is encoded once on writing (`Encoding::Srgb`).
//! `Encoding::Linear` passes numbers straight through, as FAROP did in 1996.
//!
//! Source: IEC 61966-2-1 (1999), sRGB transfer curve.

use crate::math::pow;
use std::ops::{Add, AddAssign, Mul, Sub};
use std::sync::OnceLock;

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
    pub fn level(self, light: f32) -> u8 {
        match self {
            // The cast cuts at 0 and 255, and drops what is behind the point: halves go up.
            Encoding::Linear => (f64::from(light) * 255.0 + 0.5) as u8,
            Encoding::Srgb => srgb_level(light, srgb_table()),
        }
    }

    /// The levels of pixels: [`Encoding::level`] of every channel, red, green, blue, pixel after pixel.
    ///
    /// What is missing in `bytes` or `light` is left out.
    pub fn levels(self, light: &[Rgb<f32>], bytes: &mut [u8]) {
        match self {
            Encoding::Linear => each_pixel(light, bytes, |channel| self.level(channel)),
            Encoding::Srgb => {
                let table = srgb_table();
                each_pixel(light, bytes, |channel| srgb_level(channel, table));
            }
        }
    }
}

#[inline]
fn each_pixel(light: &[Rgb<f32>], bytes: &mut [u8], level: impl Fn(f32) -> u8) {
    let (mut last, mut shown) = (Rgb::gray(0.0), [level(0.0); 3]);
    for (bytes, &light) in bytes.chunks_exact_mut(3).zip(light) {
        // Neighbors are often equal: background, flat faces.
        if light != last {
            (last, shown) = (light, light.to_array().map(&level));
        }
        bytes.copy_from_slice(&shown);
    }
}

fn srgb_decode(display: f64) -> f64 {
    if display <= 0.04045 { display / 12.92 } else { pow((display + 0.055) / 1.055, 2.4) }
}

fn srgb_encode(light: f64) -> f64 {
    if light <= 0.003_130_8 { light * 12.92 } else { 1.055 * pow(light, 1.0 / 2.4) - 0.055 }
}

#[inline]
fn srgb_level(light: f32, table: &SrgbTable) -> u8 {
    // Also sends NaN to 0.
    let bits = if light > 0.0 { light.to_bits().clamp(DARK, ONE) } else { DARK };
    ((table[((bits - DARK) >> 16) as usize] + (bits & 0xFFFF)) >> 16) as u8
}

/// The bits of 2^-13: all light up to there is level 0.
const DARK: u32 = 0x3900_0000;
/// The bits of 1: all light from there on is level 255.
const ONE: u32 = 0x3F80_0000;

/// The curve without a power per channel, which would cost more than rasterizing it, and without a branch.
///
/// The bits of an `f32` grow with it. Their upper half chooses an entry, a range of light so narrow that at most one level begins in it
/// (tests try every range). An entry has the level at its start in its upper half, and in its lower half what must be added to the lower half
/// of the light's bits for a carry where the next level begins: one sum and one shift are the level.
/// Source: Giesen, "Float to sRGB8 conversions", 2012, who fits lines; ours are steps, and exact.
type SrgbTable = [u32; ((ONE - DARK) >> 16) as usize + 1];

fn srgb_table() -> &'static SrgbTable {
    static TABLE: OnceLock<SrgbTable> = OnceLock::new();
    TABLE.get_or_init(|| {
        // The smallest lights of levels 1 to 255.
        let thresholds: [f32; 255] = std::array::from_fn(|index| srgb_threshold((index + 1) as f64));
        std::array::from_fn(|index| {
            let start = DARK + ((index as u32) << 16);
            let level = thresholds.partition_point(|threshold| threshold.to_bits() <= start);
            let next = thresholds.get(level).map_or(u32::MAX, |threshold| threshold.to_bits());
            let carry = 0x1_0000 - (next - start).min(0x1_0000);
            (level as u32) << 16 | carry
        })
    })
}

/// The smallest light whose encoded value rounds to `level`: the curve is monotone, so there is one.
fn srgb_threshold(level: f64) -> f32 {
    let rounds_to_at_least = |light: f32| (srgb_encode(f64::from(light)) * 255.0).round() >= level;
    let mut light = srgb_decode((level - 0.5) / 255.0) as f32;
    while rounds_to_at_least(light.next_down()) {
        light = light.next_down();
    }
    while !rounds_to_at_least(light) {
        light = light.next_up();
    }
    light
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
    fn one_level_at_most_begins_in_a_range() {
        let thresholds: Vec<f32> = (1..=255).map(|level| srgb_threshold(f64::from(level))).collect();
        assert!(thresholds[0].to_bits() > DARK && thresholds[254] < 1.0);
        for pair in thresholds.windows(2) {
            assert!(pair[1].to_bits() >> 16 > pair[0].to_bits() >> 16, "{pair:?}");
        }
        // Where each begins, and its neighbors among the floats, alone and as pixels.
        for (index, &threshold) in thresholds.iter().enumerate() {
            let level = index as u8 + 1;
            assert_eq!(Encoding::Srgb.level(threshold), level);
            assert_eq!(Encoding::Srgb.level(threshold.next_down()), level - 1);
            assert_eq!(Encoding::Srgb.level(threshold.next_up()), level);
        }
    }

    #[test]
    fn pixels_have_the_levels_of_their_channels() {
        let mut lights: Vec<Rgb<f32>> = (0..900).map(|k| Rgb::new(k as f32 * 1.3e-3, k as f32 * -7e-4, 1.0)).collect();
        lights.extend([Rgb::gray(f32::NAN), Rgb::gray(-0.0), Rgb::gray(0.0), Rgb::gray(f32::INFINITY)]);
        lights.extend([Rgb::gray(0.25), Rgb::gray(0.25), Rgb::new(0.25, 0.25, 0.5)]);
        for encoding in [Encoding::Srgb, Encoding::Linear] {
            let mut bytes = vec![7; lights.len() * 3];
            encoding.levels(&lights, &mut bytes);
            let each = lights.iter().flat_map(|light| light.to_array().map(|channel| encoding.level(channel)));
            assert!(bytes.into_iter().eq(each));
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
