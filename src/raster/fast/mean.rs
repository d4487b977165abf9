//! Mean: pixels of A x A samples, eight pixels at a time where A is 1, 2 or 4.
//!
//! light of samples, red, green and blue apart -MEAN-> pixels
//!
//! The order of sums is that of [`crate::image::box_mean`]: `f64`, row by row, divided and rounded once. A lane is a pixel.
//!
//! Space: samples in, pixels out. Cost: some two operations a sample.

use super::lanes::{rounded, widened};
use super::layout::LANES;
use crate::color::Rgb;
use fearless_simd::{Level, Simd, SimdBase, dispatch, f32x8, f64x8};

const COUNT: usize = LANES as usize;

/// One row of pixels from their samples: rows of samples are `stride` apart, `samples` is A.
pub(super) fn means(level: Level, pixels: &mut [Rgb<f32>], light: [&[f32]; 3], (stride, samples): (usize, usize)) {
    dispatch!(level, simd => means_by(simd, pixels, light, (stride, samples)));
}

#[inline(always)]
fn means_by<S: Simd>(simd: S, pixels: &mut [Rgb<f32>], light: [&[f32]; 3], (stride, samples): (usize, usize)) {
    let mut first = 0;
    if matches!(samples, 1 | 2 | 4) {
        while first + COUNT <= pixels.len() {
            let red = eight(simd, light[0], first, (stride, samples)).to_array();
            let green = eight(simd, light[1], first, (stride, samples)).to_array();
            let blue = eight(simd, light[2], first, (stride, samples)).to_array();
            let pixels = &mut pixels[first..first + COUNT];
            let mut lane = 0;
            while lane < COUNT {
                pixels[lane] = Rgb::new(red[lane], green[lane], blue[lane]);
                lane += 1;
            }
            first += COUNT;
        }
    }
    while first < pixels.len() {
        let one = |channel: &[f32]| mean(channel, first, (stride, samples));
        pixels[first] = Rgb::new(one(light[0]), one(light[1]), one(light[2]));
        first += 1;
    }
}

/// The mean of one pixel.
#[inline(always)]
fn mean(channel: &[f32], pixel: usize, (stride, samples): (usize, usize)) -> f32 {
    let mut sum = 0.0;
    let mut row = 0;
    while row < samples {
        let first = row * stride + pixel * samples;
        let samples = &channel[first..first + samples];
        let mut column = 0;
        while column < samples.len() {
            sum += f64::from(samples[column]);
            column += 1;
        }
        row += 1;
    }
    (sum / (samples * samples) as f64) as f32
}

/// The means of eight pixels; A is 1, 2 or 4.
#[inline(always)]
fn eight<S: Simd>(simd: S, channel: &[f32], pixel: usize, (stride, samples): (usize, usize)) -> f32x8<S> {
    if samples == 1 {
        return f32x8::from_slice(simd, &channel[pixel..pixel + COUNT]);
    }
    let mut sum = f64x8::splat(simd, 0.0);
    let mut row = 0;
    while row < samples {
        let first = row * stride + pixel * samples;
        let line = &channel[first..first + samples * COUNT];
        if samples == 2 {
            let (even, odd) = apart(f32x8::from_slice(simd, &line[..8]), f32x8::from_slice(simd, &line[8..16]));
            sum = sum + widened(even) + widened(odd);
        } else {
            let (even, odd) = apart(f32x8::from_slice(simd, &line[..8]), f32x8::from_slice(simd, &line[8..16]));
            let (next_even, next_odd) =
                apart(f32x8::from_slice(simd, &line[16..24]), f32x8::from_slice(simd, &line[24..32]));
            let ((zeroth, second), (first, third)) = (apart(even, next_even), apart(odd, next_odd));
            sum = sum + widened(zeroth) + widened(first) + widened(second) + widened(third);
        }
        row += 1;
    }
    rounded(sum / f64x8::splat(simd, (samples * samples) as f64))
}

/// Of sixteen numbers, those with even places and those with odd ones.
#[inline(always)]
fn apart<S: Simd>(low: f32x8<S>, high: f32x8<S>) -> (f32x8<S>, f32x8<S>) {
    (low.unzip_low(high), low.unzip_high(high))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::image::box_mean;
    use crate::raster::fast::Instructions;

    #[test]
    fn means_are_those_of_the_readable_path() {
        for (samples, instructions) in (1..=5).flat_map(|samples| Instructions::ALL.map(|level| (samples, level))) {
            let (width, stride) = (19, 19 * samples + 3);
            let light: Vec<Rgb<f32>> = (0..stride * samples)
                .map(|number| Rgb::new(0.1 * number as f32, 1.0 / (number as f32 + 0.7), -0.3 * number as f32))
                .collect();
            let channels = [0, 1, 2].map(|channel| light.iter().map(|rgb| rgb.to_array()[channel]).collect::<Vec<_>>());
            let mut pixels = vec![Rgb::gray(9.0); width];
            let slices = [&channels[0][..], &channels[1], &channels[2]];
            means(instructions.level(), &mut pixels, slices, (stride, samples));
            for (number, &pixel) in pixels.iter().enumerate() {
                assert_eq!(pixel, box_mean(&light[number * samples..], stride, samples), "{samples} {number}");
            }
        }
    }
}
