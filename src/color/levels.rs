//! Levels: light as 8-bit display values, for whole pictures.
//!
//! light of pixels -LEVELS-> bytes
//!
//! Why it is written twice as carefully as it looks: a picture of a million pixels has three million channels, and a frame of a small scene
//! takes some milliseconds. So nothing here branches, and channels are taken in blocks, which the compiler turns into lanes where it can.
//!
//! Cost: some tenths of a nanosecond a channel.

use super::{Encoding, Rgb, srgb_decode, srgb_encode};
use fearless_simd::{Level, Simd, dispatch};
use std::sync::OnceLock;

/// Pixels of a block.
const BLOCK: usize = 16;

impl Encoding {
    /// The levels of pixels: [`Encoding::level`] of every channel, red, green, blue, pixel after pixel.
    ///
    /// Pixels without bytes and bytes without a pixel are left out.
    pub fn levels(self, light: &[Rgb<f32>], bytes: &mut [u8]) {
        let whole = light.len().min(bytes.len() / (3 * BLOCK) * BLOCK) / BLOCK * BLOCK;
        let (blocks, rest) = light.split_at(whole);
        let (block_bytes, rest_bytes) = bytes.split_at_mut(3 * whole);
        dispatch!(Level::new(), simd => by_blocks(simd, self, blocks, block_bytes));
        for (light, bytes) in rest.iter().zip(rest_bytes.chunks_mut(3)) {
            let levels = light.to_array().map(|channel| self.level(channel));
            bytes.copy_from_slice(&levels[..bytes.len()]);
        }
    }
}

/// Whole blocks of pixels. Says nothing of lanes itself: compiled for the instructions that the machine has, loops of known length become lanes.
#[inline(always)]
fn by_blocks<S: Simd>(_: S, encoding: Encoding, light: &[Rgb<f32>], bytes: &mut [u8]) {
    let blocks = light.as_chunks::<BLOCK>().0.iter().zip(bytes.as_chunks_mut::<{ 3 * BLOCK }>().0);
    match encoding {
        Encoding::Linear => {
            for (light, bytes) in blocks {
                *bytes = each_channel(light, linear);
            }
        }
        Encoding::Srgb => {
            let table = table();
            for (light, bytes) in blocks {
                *bytes = each_channel(light, |channel| srgb(channel, table));
            }
        }
    }
}

/// The levels of a block. Two loops without a call: a closure that stays a call has no lanes (see `fearless_simd`).
#[inline(always)]
fn each_channel(light: &[Rgb<f32>; BLOCK], level: impl Fn(f32) -> u8) -> [u8; 3 * BLOCK] {
    let (mut channels, mut levels) = ([0.0; 3 * BLOCK], [0; 3 * BLOCK]);
    let mut pixel = 0;
    while pixel < BLOCK {
        let Rgb { r, g, b } = light[pixel];
        (channels[3 * pixel], channels[3 * pixel + 1], channels[3 * pixel + 2]) = (r, g, b);
        pixel += 1;
    }
    let mut channel = 0;
    while channel < 3 * BLOCK {
        levels[channel] = level(channels[channel]);
        channel += 1;
    }
    levels
}

/// The level of a channel of light that is a display value already.
#[inline(always)]
pub(super) fn linear(light: f32) -> u8 {
    /// Numbers from here on are whole, so that adding it rounds; the last digits of the sum are the number.
    const WHOLE: f64 = (1_u64 << 52) as f64;
    // Exact: 24 digits times 8. Not-a-number is not above 0. The only half from 0 to 255 is 127.5 (an odd multiple of 1/510 with few
    // digits is a half), and it goes to the even 128: up, as halves do.
    let level = f64::from(light) * 255.0;
    let level = if level > 0.0 { level } else { 0.0 };
    let level = if level < 255.0 { level } else { 255.0 };
    (level + WHOLE).to_bits() as u8
}

/// The level of a channel of light by the curve of sRGB.
#[inline(always)]
pub(super) fn srgb(light: f32, table: &Table) -> u8 {
    // Also sends NaN to 0.
    let bits = if light > 0.0 { light.to_bits() } else { DARK };
    let bits = bits.clamp(DARK, ONE);
    ((table[((bits - DARK) >> 16) as usize] + (bits & 0xFFFF)) >> 16) as u8
}

/// The bits of 2^-13: all light up to there is level 0.
const DARK: u32 = 0x3900_0000;
/// The bits of 1: all light from there on is level 255.
const ONE: u32 = 0x3F80_0000;

/// The curve without a power per channel, which would cost more than rasterizing it, and without a branch.
///
/// The bits of an `f32` grow with it. Their upper half chooses an entry, a range of light so narrow that at most one level begins in it
/// (a test tries every level). An entry has the level at its start in its upper half, and in its lower half what must be added to the lower
/// half of the light's bits for a carry where the next level begins: one sum and one shift are the level.
/// Source: Giesen, "Float to sRGB8 conversions", 2012, who fits lines; ours are steps, and exact.
pub(super) type Table = [u32; ((ONE - DARK) >> 16) as usize + 1];

pub(super) fn table() -> &'static Table {
    static TABLE: OnceLock<Table> = OnceLock::new();
    TABLE.get_or_init(|| {
        // The smallest lights of levels 1 to 255.
        let thresholds: [f32; 255] = std::array::from_fn(|index| threshold((index + 1) as f64));
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
fn threshold(level: f64) -> f32 {
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
    fn one_level_at_most_begins_in_a_range() {
        let thresholds: Vec<f32> = (1..=255).map(|level| threshold(f64::from(level))).collect();
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
            // Bytes that end in the middle of a pixel.
            let mut bytes = vec![7; 3 * 32 + 5];
            encoding.levels(&lights[..35], &mut bytes);
            let each = lights.iter().flat_map(|light| light.to_array().map(|channel| encoding.level(channel)));
            assert!(bytes.into_iter().eq(each.take(3 * 32 + 5)));
        }
    }

    #[test]
    fn halves_go_up() {
        for light in [0.5_f32, 0.5_f32.next_down(), 0.5_f32.next_up(), 1.0, 2.5, -0.1] {
            let rounded = (f64::from(light) * 255.0 + 0.5).floor().clamp(0.0, 255.0) as u8;
            assert_eq!(linear(light), rounded, "{light}");
        }
    }
}
