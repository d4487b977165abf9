//! Picture: 8-bit display values, as they stand in a file.
//!
//! `Image` -> encode -> PICTURE -> file, terminal, comparison
//!
//! Space: rows from the top, 3 bytes a pixel in the order red, green, blue. What a level means as light is the
//! business of the encoding that made the picture; nothing here adds or averages light.

use super::ImageError;

/// A picture of 8-bit display values, rows from the top.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    width: usize,
    height: usize,
    rgb: Vec<u8>,
}

impl Picture {
    /// A picture of the given bytes: red, green, blue of each pixel, row after row from the top.
    ///
    /// # Errors
    /// [`ImageError::Length`] when `rgb` does not hold exactly 3 bytes for every pixel.
    pub fn from_rgb(width: usize, height: usize, rgb: Vec<u8>) -> Result<Self, ImageError> {
        let needed = width.checked_mul(height).and_then(|count| count.checked_mul(3));
        if needed != Some(rgb.len()) {
            return Err(ImageError::Length { width, height, bytes: rgb.len() });
        }
        Ok(Picture { width, height, rgb })
    }

    /// As [`Picture::from_rgb`], for callers in this room that have just counted.
    pub(super) fn from_parts(width: usize, height: usize, rgb: Vec<u8>) -> Self {
        debug_assert_eq!(rgb.len(), width * height * 3);
        Picture { width, height, rgb }
    }

    /// A picture of one color.
    ///
    /// # Panics
    /// When the bytes do not fit into the address space; callers with sizes from outside check
    /// [`MAX_PIXELS`](super::MAX_PIXELS) first.
    #[must_use]
    pub fn filled(width: usize, height: usize, color: [u8; 3]) -> Self {
        let count = width.checked_mul(height).expect("callers check sizes against MAX_PIXELS");
        Picture { width, height, rgb: color.repeat(count) }
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

    /// All bytes: red, green, blue of each pixel, row after row from the top.
    #[must_use]
    pub fn rgb(&self) -> &[u8] {
        &self.rgb
    }

    /// Red, green and blue at column `x` of row `y`, counted from the top left.
    ///
    /// # Panics
    /// Outside the picture, as indexing does.
    #[must_use]
    pub fn pixel(&self, x: usize, y: usize) -> [u8; 3] {
        let at = self.offset(x, y);
        [self.rgb[at], self.rgb[at + 1], self.rgb[at + 2]]
    }

    /// Red, green and blue at column `x` of row `y`, or `None` outside the picture.
    #[must_use]
    pub fn pixel_if_inside(&self, x: usize, y: usize) -> Option<[u8; 3]> {
        (x < self.width && y < self.height).then(|| self.pixel(x, y))
    }

    /// Replaces the color at column `x` of row `y`.
    ///
    /// # Panics
    /// Outside the picture, as indexing does.
    pub fn set_pixel(&mut self, x: usize, y: usize, color: [u8; 3]) {
        let at = self.offset(x, y);
        self.rgb[at..at + 3].copy_from_slice(&color);
    }

    /// The colors, row after row from the top.
    pub fn colors(&self) -> impl Iterator<Item = [u8; 3]> {
        self.rgb.as_chunks::<3>().0.iter().copied()
    }

    fn offset(&self, x: usize, y: usize) -> usize {
        assert!(x < self.width && y < self.height, "({x}, {y}) is outside {} x {}", self.width, self.height);
        (y * self.width + x) * 3
    }
}

/// How bright a display color looks, 0 to 255: the weights of Rec. ITU-R BT.709, in whole numbers, rounded down.
pub(super) fn luma([red, green, blue]: [u8; 3]) -> u8 {
    ((2126 * u32::from(red) + 7152 * u32::from(green) + 722 * u32::from(blue)) / 10_000) as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_must_match_the_size() {
        assert!(Picture::from_rgb(2, 1, vec![0; 6]).is_ok());
        let error = Picture::from_rgb(2, 2, vec![0; 6]).expect_err("six bytes are two pixels");
        assert_eq!(error.to_string(), "a picture of 2 x 2 needs 3 bytes a pixel, but there are 6 bytes in all");
        assert!(Picture::from_rgb(usize::MAX, usize::MAX, Vec::new()).is_err());
    }

    #[test]
    fn brightness_covers_the_whole_range() {
        assert_eq!(luma([0; 3]), 0);
        assert_eq!(luma([255; 3]), 255);
        assert!(luma([0, 255, 0]) > luma([255, 0, 0]) && luma([255, 0, 0]) > luma([0, 0, 255]));
    }

    #[test]
    #[should_panic(expected = "outside")]
    fn a_column_too_far_is_not_the_next_row() {
        let _ = Picture::filled(2, 2, [0; 3]).pixel(2, 0);
    }
}
