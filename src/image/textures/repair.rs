//! Repair: what transparency breaks in a picture, measured and mended.
//!
//! Texels -> DILATE -> Texels; Texels, threshold -> COVERAGE -> share
//!
//! Space: texels. Cost: dilation visits every texel once.

use super::filter::{Taps, Wrap};
use super::{Rgba, Texels};

/// Gives texels that are not there (alpha 0) the mean color of their neighbors that are, then of those, and so on to the last.
///
/// So no lookup finds a color that nobody painted, however it filters. Alpha stays. A picture that is nowhere stays as it is.
#[must_use]
pub fn dilate(texels: &Texels, wrap: Wrap) -> Texels {
    let mut filled = texels.clone();
    let (width, height) = (texels.width as usize, texels.height as usize);
    let mut known: Vec<bool> = texels.rgba.iter().map(|texel| texel[3] > 0).collect();
    let neighbors = |index: usize| {
        let (x, y) = ((index % width) as i64, (index / width) as i64);
        let around = (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (dx, dy))).filter(|&step| step != (0, 0));
        around.map(move |(dx, dy)| wrap.index(y + dy, height) * width + wrap.index(x + dx, width))
    };
    // Ring by ring: a texel takes the mean of the rings before, never of its own.
    let is_rim = |known: &[bool], index: usize| !known[index] && neighbors(index).any(|other| known[other]);
    let mut ring: Vec<usize> = (0..known.len()).filter(|&index| is_rim(&known, index)).collect();
    while !ring.is_empty() {
        for &index in &ring {
            let colors = neighbors(index).filter(|&other| known[other]).map(|other| filled.rgba[other]);
            let color = mean(colors);
            filled.rgba[index][..3].copy_from_slice(&color);
        }
        ring.iter().for_each(|&index| known[index] = true);
        let mut next: Vec<usize> = ring.iter().flat_map(|&index| neighbors(index)).filter(|&at| !known[at]).collect();
        next.sort_unstable();
        next.dedup();
        ring = next;
    }
    filled
}

/// The mean of display values, rounded.
fn mean(colors: impl Iterator<Item = Rgba>) -> [u8; 3] {
    let (mut sum, mut count) = ([0u32; 3], 0);
    for color in colors {
        (0..3).for_each(|channel| sum[channel] += u32::from(color[channel]));
        count += 1;
    }
    sum.map(|channel| ((channel + count / 2) / count.max(1)) as u8)
}

/// Places at which [`coverage`] is measured.
const PLACES: u64 = 1 << 14;

/// Which share of a picture is above `threshold` in alpha, 0 to 1, between texels as bilinear lookups see it.
///
/// Measured at 16,384 places that are spread evenly and lie differently in every texel: in a regular grid all twigs of a fence would
/// pass at once.
#[must_use]
pub fn coverage(texels: &Texels, threshold: f32, wrap: Wrap) -> f64 {
    // Multiples of two irrational numbers, as fractions of 2^64 (Roberts 2018).
    let steps = [0xC13F_A9A9_02A6_328F_u64, 0x91E1_0DA5_C79E_7B1D];
    let fraction = |multiple: u64| (multiple >> 11) as f64 / (1_u64 << 53) as f64;
    let passes = |index: &u64| {
        let place = steps.map(|step| fraction(index.wrapping_mul(step)));
        let taps = Taps::bilinear(wrap.coordinates(place), texels.size(), wrap);
        taps.sum(|index| f32::from(texels.rgba[index][3])) / 255.0 > threshold
    };
    (1..=PLACES).filter(passes).count() as f64 / PLACES as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::image::textures::FirstRow;

    fn row(rgba: &[Rgba]) -> Texels {
        Texels::new(rgba.len() as u32, 1, rgba.to_vec(), FirstRow::AtV0).expect("a row")
    }

    #[test]
    fn colors_grow_into_the_holes_ring_by_ring() {
        let (red, blue, hole) = ([200, 0, 0, 255], [0, 0, 100, 40], [9, 9, 9, 0]);
        let filled = dilate(&row(&[red, hole, hole, hole, blue]), Wrap::Clamp);
        let middle = [100, 0, 50, 0];
        assert_eq!(filled.rgba(), [red, [200, 0, 0, 0], middle, [0, 0, 100, 0], blue]);
        // Once more changes nothing.
        assert_eq!(dilate(&filled, Wrap::Clamp), filled);
        let nowhere = row(&[hole, hole]);
        assert_eq!(dilate(&nowhere, Wrap::Repeat), nowhere);
    }

    #[test]
    fn coverage_is_a_share_of_the_area() {
        let picture = |alphas: [u8; 4]| row(&alphas.map(|alpha| [0, 0, 0, alpha]));
        assert_eq!(coverage(&picture([255; 4]), 0.5, Wrap::Repeat), 1.0);
        assert_eq!(coverage(&picture([0; 4]), 0.0, Wrap::Repeat), 0.0);
        // Half of it, whichever way the ramps between are cut.
        assert!((coverage(&picture([255, 255, 0, 0]), 0.5, Wrap::Repeat) - 0.5).abs() < 0.02);
    }
}
