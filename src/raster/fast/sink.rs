//! Sink: where finished tiles go, from any thread.
//!
//! tile -> SINK -> pixels of the picture, or samples of a target
//!
//! Why locks: rows of tiles are disjoint parts of the picture, but tiles of one row are not contiguous in memory. A tile is copied in a
//! hundredth of the time that drawing it takes, so threads hardly ever wait.

use super::layout::Area;
use super::tile::{Depth, NOBODY, Tile};
use crate::color::Rgb;
use crate::raster::{Pixels, Target};
use crate::screen::Fragment;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Takes finished tiles.
pub(super) trait Sink<D>: Sync {
    fn take(&self, tile: &Tile<D>);
    /// Takes a tile on which nothing is drawn.
    fn fill(&self, area: &Area, background: Rgb<f32>);
}

/// Locks; a panic elsewhere is passed on by the thread that had it.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Finished pixels: each the mean of A x A samples.
pub(super) struct PixelRows<'a> {
    /// The picture in bands as high as tiles.
    bands: Vec<Mutex<&'a mut [Rgb<f32>]>>,
    width: usize,
    samples: usize,
    side: i32,
}

impl<'a> PixelRows<'a> {
    /// Over all of `pixels`, for tiles of `side` samples, which are whole pixels.
    pub fn new(pixels: &'a mut Pixels<'_>, side: u32) -> PixelRows<'a> {
        let samples = pixels.samples.max(1) as usize;
        let band = (pixels.width * (side as usize / samples)).max(1);
        let bands = pixels.light.chunks_mut(band).map(Mutex::new).collect();
        PixelRows { bands, width: pixels.width, samples, side: side as i32 }
    }
}

impl<D: Depth> Sink<D> for PixelRows<'_> {
    fn take(&self, tile: &Tile<D>) {
        let Area { columns, rows } = &tile.area;
        let Some(band) = self.bands.get((rows.start / self.side) as usize) else { return };
        let left = columns.start as usize / self.samples;
        // Samples that fill no whole pixel are dropped.
        let right = (columns.end as usize / self.samples).min(self.width);
        let mut band = lock(band);
        for (number, pixels) in band.chunks_mut(self.width).enumerate() {
            let top = number * self.samples * tile.stride;
            let light = tile.light.each_ref().map(|channel| &channel[top..]);
            let pixels = &mut pixels[left..right];
            match self.samples {
                1 => means::<1>(pixels, light, (tile.stride, 1)),
                2 => means::<2>(pixels, light, (tile.stride, 2)),
                4 => means::<4>(pixels, light, (tile.stride, 4)),
                samples => means::<0>(pixels, light, (tile.stride, samples)),
            }
        }
    }

    fn fill(&self, area: &Area, background: Rgb<f32>) {
        let Some(band) = self.bands.get((area.rows.start / self.side) as usize) else { return };
        let left = area.columns.start as usize / self.samples;
        let right = (area.columns.end as usize / self.samples).min(self.width);
        lock(band).chunks_mut(self.width).for_each(|pixels| pixels[left..right].fill(background));
    }
}

/// Means of `samples` x `samples` samples, rows `stride` apart, in the order of [`crate::image::box_mean`]; A is `samples`, or 0
/// if the program is not made ready for it.
#[inline(always)]
fn means<const A: usize>(pixels: &mut [Rgb<f32>], light: [&[f32]; 3], (stride, samples): (usize, usize)) {
    let samples = if A == 0 { samples } else { A };
    let [red, green, blue] = light;
    if A == 1 {
        for (((pixel, &r), &g), &b) in pixels.iter_mut().zip(red).zip(green).zip(blue) {
            *pixel = Rgb::new(r, g, b);
        }
        return;
    }
    let count = (samples * samples) as f64;
    for (number, pixel) in pixels.iter_mut().enumerate() {
        let mut sums = [0.0_f64; 3];
        for row in 0..samples {
            let range = row * stride + number * samples..row * stride + (number + 1) * samples;
            for ((&r, &g), &b) in red[range.clone()].iter().zip(&green[range.clone()]).zip(&blue[range]) {
                sums = [sums[0] + f64::from(r), sums[1] + f64::from(g), sums[2] + f64::from(b)];
            }
        }
        *pixel = Rgb::from(sums.map(|sum| sum / count)).to_f32();
    }
}

/// A target with depth, color and owner of every sample.
pub(super) struct Samples<'a, 'b>(pub Mutex<&'a mut Target<'b>>);

impl<D: Depth> Sink<D> for Samples<'_, '_> {
    fn take(&self, tile: &Tile<D>) {
        let mut target = lock(&self.0);
        for y in tile.area.rows.clone() {
            for x in tile.area.columns.clone() {
                let index = tile.index(x, y);
                let (polygon, color) = (tile.owner[index], tile.light(index));
                if polygon != NOBODY {
                    let depth = tile.depth[index].widened();
                    target.put(Fragment { x, y, depth, color, opacity: Rgb::gray(1.0), polygon });
                } else {
                    target.show(x, y, color);
                }
            }
        }
    }

    fn fill(&self, area: &Area, background: Rgb<f32>) {
        let mut target = lock(&self.0);
        for y in area.rows.clone() {
            area.columns.clone().for_each(|x| target.show(x, y, background));
        }
    }
}
