//! Image: what rasterizers leave behind, and everything that happens to pictures after that.
//!
//! Rasterizer -> `Image` (linear light) -> average -> encode -> `Picture` (8-bit display values) -> file, terminal, comparison
//!
//! Why two types: light may be averaged and added, display values may be stored and compared, and mixing them up
//! is the oldest mistake of the trade. The only road from one to the other is [`Image::encode`], walked once.
//!
//! Space: pixels, rows from the top, x to the right.
//! Cost: 12 bytes a pixel for an [`Image`], 3 for a [`Picture`].

mod file;
pub mod flip;
pub mod metrics;
pub mod movie;
mod picture;
mod planes;
mod png;
mod ppm;
pub mod save;
pub mod snapshot;
pub mod ssim;
mod summary;
pub mod terminal;
pub mod textures;

pub use file::{ImageError, decode, encode_for, read};
pub use picture::Picture;

use crate::color::{Encoding, Rgb};

/// Pictures with more pixels than this are refused by the readers before any memory is asked for: 2^28, or 16384 x 16384.
pub const MAX_PIXELS: usize = 1 << 28;

/// A picture in linear light, three `f32` a pixel, rows from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    width: usize,
    height: usize,
    pixels: Vec<Rgb<f32>>,
}

impl Image {
    /// An image of `width` x `height` pixels, all of them `fill`. Either may be 0: an image without pixels.
    ///
    /// # Panics
    /// When the pixels do not fit into the address space; callers with sizes from outside check [`MAX_PIXELS`] first.
    #[must_use]
    pub fn new(width: usize, height: usize, fill: Rgb<f32>) -> Self {
        let count = width.checked_mul(height).expect("callers check sizes against MAX_PIXELS");
        Image { width, height, pixels: vec![fill; count] }
    }

    /// Pixels in a row.
    #[must_use]
    pub fn width(&self) -> usize {
        self.width
    }

    /// Number of rows.
    #[must_use]
    pub fn height(&self) -> usize {
        self.height
    }

    /// The light at column `x` of row `y`, counted from the top left.
    ///
    /// # Panics
    /// Outside the image, as indexing does.
    #[must_use]
    pub fn pixel(&self, x: usize, y: usize) -> Rgb<f32> {
        self.row(y)[x]
    }

    /// Replaces the light at column `x` of row `y`.
    ///
    /// # Panics
    /// Outside the image, as indexing does.
    pub fn set_pixel(&mut self, x: usize, y: usize, light: Rgb<f32>) {
        self.row_mut(y)[x] = light;
    }

    /// Row `y`, counted from the top.
    ///
    /// # Panics
    /// Below the image, as indexing does.
    #[must_use]
    pub fn row(&self, y: usize) -> &[Rgb<f32>] {
        &self.pixels[y * self.width..(y + 1) * self.width]
    }

    /// Row `y`, counted from the top, to write into.
    ///
    /// # Panics
    /// Below the image, as indexing does.
    pub fn row_mut(&mut self, y: usize) -> &mut [Rgb<f32>] {
        &mut self.pixels[y * self.width..(y + 1) * self.width]
    }

    /// All pixels, row after row from the top.
    #[must_use]
    pub fn pixels(&self) -> &[Rgb<f32>] {
        &self.pixels
    }

    /// All pixels to write into, row after row from the top (threads split them into bands of rows).
    pub fn pixels_mut(&mut self) -> &mut [Rgb<f32>] {
        &mut self.pixels
    }

    /// The image `samples` times smaller each way: every pixel is the mean of its `samples` x `samples` box.
    ///
    /// A picture drawn with A x A samples a pixel is a virtual picture A times larger, averaged here (FAROP 1996).
    /// The sums are taken in `f64`, row by row, and rounded once, so they do not depend on who drew which part.
    /// Columns and rows that fill no whole box are dropped; `samples` 0 counts as 1.
    #[must_use]
    pub fn average(&self, samples: usize) -> Image {
        if samples <= 1 {
            return self.clone();
        }
        let mut small = Image::new(self.width / samples, self.height / samples, Rgb::gray(0.0));
        for y in 0..small.height {
            for x in 0..small.width {
                let first = y * samples * self.width + x * samples;
                small.set_pixel(x, y, box_mean(&self.pixels[first..], self.width, samples));
            }
        }
        small
    }

    /// The 8-bit display values of this light: each channel encoded and rounded once.
    ///
    /// Light below 0 and not-a-number become 0, light above 1 becomes 255.
    #[must_use]
    pub fn encode(&self, encoding: Encoding) -> Picture {
        let mut rgb = Vec::new();
        let threads = std::thread::available_parallelism().map_or(1, |count| count.get() as u32);
        self.encode_into(encoding, threads, &mut rgb);
        Picture::from_parts(self.width, self.height, rgb)
    }

    /// The bytes of [`Image::encode`], in memory that earlier pictures have used, by up to `threads` threads.
    ///
    /// A small picture is encoded before another thread would have begun: each has at least 2^16 pixels to do.
    pub fn encode_into(&self, encoding: Encoding, threads: u32, rgb: &mut Vec<u8>) {
        const LEAST: usize = 1 << 16;
        rgb.resize(self.pixels.len() * 3, 0);
        let each = self.pixels.len().div_ceil(threads.max(1) as usize).max(LEAST);
        if self.pixels.len() <= each {
            return encoding.levels(&self.pixels, rgb);
        }
        std::thread::scope(|scope| {
            for (bytes, pixels) in rgb.chunks_mut(3 * each).zip(self.pixels.chunks(each)) {
                scope.spawn(move || encoding.levels(pixels, bytes));
            }
        });
    }
}

/// The mean of `side` x `side` lights, rows `stride` apart: summed in `f64`, row by row, and rounded once.
///
/// # Panics
/// When there are fewer lights, as indexing does.
#[must_use]
pub fn box_mean(lights: &[Rgb<f32>], stride: usize, side: usize) -> Rgb<f32> {
    let mut sum = Rgb::BLACK;
    for row in 0..side {
        for light in &lights[row * stride..row * stride + side] {
            sum += light.to_f64();
        }
    }
    let count = (side * side) as f64;
    sum.map(|channel| channel / count).to_f32()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn threads_change_no_level() {
        let mut image = Image::new(701, 300, Rgb::gray(0.0));
        for (index, pixel) in image.pixels_mut().iter_mut().enumerate() {
            *pixel = Rgb::new((index % 997) as f32 / 990.0, (index % 89) as f32 / 88.0, 0.5);
        }
        let by = |threads| {
            let mut bytes = vec![3; 5];
            image.encode_into(Encoding::Srgb, threads, &mut bytes);
            bytes
        };
        let one = by(1);
        assert_eq!(one.len(), 701 * 300 * 3);
        assert!([0, 2, 3, 64].into_iter().all(|threads| by(threads) == one));
        assert_eq!(one[3 * 996], Encoding::Srgb.level(996.0 / 990.0));
    }

    #[test]
    fn rows_are_counted_from_the_top() {
        let mut image = Image::new(3, 2, Rgb::gray(0.0));
        image.set_pixel(2, 0, Rgb::new(1.0, 0.0, 0.0));
        image.row_mut(1)[0] = Rgb::new(0.0, 1.0, 0.0);
        assert_eq!(image.pixels()[2], Rgb::new(1.0, 0.0, 0.0));
        assert_eq!(image.pixels()[3], image.pixel(0, 1));
        let picture = image.encode(Encoding::Linear);
        assert_eq!(picture.pixel(2, 0), [255, 0, 0]);
        assert_eq!(picture.pixel(0, 1), [0, 255, 0]);
    }

    #[test]
    fn average_is_the_mean_of_each_box() {
        // Columns 4 and row 2 fill no whole box.
        let mut image = Image::new(5, 3, Rgb::gray(9.0));
        for (x, y, light) in [(0, 0, 1.0), (1, 0, 2.0), (0, 1, 3.0), (1, 1, 5.0)] {
            image.set_pixel(x, y, Rgb::new(light, 0.0, 1.0));
        }
        let small = image.average(2);
        assert_eq!((small.width(), small.height()), (2, 1));
        assert_eq!(small.pixel(0, 0), Rgb::new(2.75, 0.0, 1.0));
        assert_eq!(small.pixel(1, 0), Rgb::gray(9.0));
        assert_eq!(image.average(1), image);
    }

    #[test]
    fn average_sums_in_double_precision() {
        // In f32 the small ones would drown: 2^24 + 1 = 2^24.
        let mut image = Image::new(2, 2, Rgb::gray(1.0));
        image.set_pixel(0, 0, Rgb::gray(16_777_216.0));
        assert_eq!(image.average(2).pixel(0, 0), Rgb::gray(4_194_304.75f64 as f32));
    }

    #[test]
    fn averaging_is_done_on_light_not_on_display_values() {
        let mut image = Image::new(2, 2, Rgb::gray(0.0));
        image.row_mut(0).fill(Rgb::gray(1.0));
        assert_eq!(image.average(2).encode(Encoding::Srgb).pixel(0, 0), [188; 3]);
        assert_eq!(image.average(2).encode(Encoding::Linear).pixel(0, 0), [128; 3]);
    }

    #[test]
    fn an_image_without_pixels_is_no_special_case() {
        let empty = Image::new(0, 7, Rgb::gray(1.0));
        assert_eq!(empty.average(3).encode(Encoding::Srgb).rgb(), &[] as &[u8]);
    }
}
