//! Sink: where finished tiles go, from any thread.
//!
//! tile -> SINK -> pixels of the picture, or samples of a target
//!
//! Why locks: rows of tiles are disjoint parts of the picture, but tiles of one row are not contiguous in memory. A tile is copied in a
//! hundredth of the time that drawing it takes, so threads hardly ever wait.

use super::layout::Area;
use super::mean::means;
use super::tile::{Depth, NOBODY, Tile};
use crate::color::Rgb;
use crate::raster::{Pixels, Target};
use crate::screen::Fragment;
use fearless_simd::Level;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Takes finished tiles.
pub(super) trait Sink<D>: Sync {
    fn take(&self, tile: &Tile<D>, level: Level);
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
    fn take(&self, tile: &Tile<D>, level: Level) {
        let Area { columns, rows } = &tile.area;
        let Some(band) = self.bands.get((rows.start / self.side) as usize) else { return };
        let left = columns.start as usize / self.samples;
        // Samples that fill no whole pixel are dropped.
        let right = (columns.end as usize / self.samples).min(self.width);
        let mut band = lock(band);
        for (number, pixels) in band.chunks_mut(self.width).enumerate() {
            let top = number * self.samples * tile.stride;
            let [red, green, blue] = &tile.light;
            let light = [&red[top..], &green[top..], &blue[top..]];
            means(level, &mut pixels[left..right], light, (tile.stride, self.samples));
        }
    }

    fn fill(&self, area: &Area, background: Rgb<f32>) {
        let Some(band) = self.bands.get((area.rows.start / self.side) as usize) else { return };
        let left = area.columns.start as usize / self.samples;
        let right = (area.columns.end as usize / self.samples).min(self.width);
        lock(band).chunks_mut(self.width).for_each(|pixels| pixels[left..right].fill(background));
    }
}

/// A target with depth, color and owner of every sample.
pub(super) struct Samples<'a, 'b>(pub Mutex<&'a mut Target<'b>>);

impl<D: Depth> Sink<D> for Samples<'_, '_> {
    fn take(&self, tile: &Tile<D>, _level: Level) {
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
