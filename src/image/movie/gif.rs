//! GIF: 256 colors a frame, seen everywhere.
//!
//! Frame -palette-> 256 colors -LZW (crate `image`)-> file
//!
//! Why the colors are chosen here and not by the encoder: its choice is a search with floating-point numbers; ours are counts
//! (see [`palette`](super::palette)), and a frame that has at most 256 colors keeps each of them.

use super::MovieError;
use super::palette::few_colors;
use crate::image::save::{SaveError, WholeFile};
use crate::image::{ImageError, Picture};
use image::codecs::gif::{GifEncoder, Repeat};
use image::{Delay, Frame, RgbaImage};
use std::cell::RefCell;
use std::io::{self, Write};
use std::rc::Rc;

/// The encoder keeps its writer to itself; so it writes to memory that is emptied into the file after each frame.
#[derive(Clone, Debug, Default)]
struct Memory(Rc<RefCell<Vec<u8>>>);

impl Write for Memory {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.borrow_mut().extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// A GIF in the making.
pub(super) struct Gif {
    file: WholeFile,
    memory: Memory,
    encoder: GifEncoder<Memory>,
    delay: Delay,
    begun: bool,
}

impl std::fmt::Debug for Gif {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.debug_struct("Gif").field("file", &self.file).finish_non_exhaustive()
    }
}

impl Gif {
    pub fn new(file: WholeFile, rate: u32) -> Gif {
        let memory = Memory::default();
        let encoder = GifEncoder::new(memory.clone());
        // Whole hundredths of a second, at least 2: players take less for a mistake and show such frames slowly.
        let hundredths = ((100 + rate.max(1) / 2) / rate.max(1)).max(2);
        Gif { file, memory, encoder, delay: Delay::from_numer_denom_ms(hundredths * 10, 1), begun: false }
    }

    pub fn push(&mut self, picture: &Picture) -> Result<(), MovieError> {
        let failed = |error: image::ImageError| ImageError::Gif { what: error.to_string() };
        if !std::mem::replace(&mut self.begun, true) {
            self.encoder.set_repeat(Repeat::Infinite).map_err(failed)?;
        }
        let few = few_colors(picture);
        let rgba = few.as_chunks::<3>().0.iter().flat_map(|&[red, green, blue]| [red, green, blue, 255]).collect();
        let (width, height) = (picture.width() as u32, picture.height() as u32);
        // The vector has four bytes a pixel, so this is never `None`.
        let pixels = RgbaImage::from_raw(width, height, rgba).unwrap_or_default();
        self.encoder.encode_frame(Frame::from_parts(pixels, 0, 0, self.delay)).map_err(failed)?;
        self.empty()
    }

    pub fn finish(mut self) -> Result<(), MovieError> {
        // Dropping writes the last byte of the format, into memory.
        drop(std::mem::replace(&mut self.encoder, GifEncoder::new(Memory::default())));
        self.empty()?;
        Ok(self.file.commit()?)
    }

    /// Moves what is in memory to the file.
    fn empty(&mut self) -> Result<(), MovieError> {
        let bytes = std::mem::take(&mut *self.memory.0.borrow_mut());
        let written = self.file.write_all(&bytes);
        Ok(written.map_err(|error| SaveError::at(self.file.path(), error))?)
    }
}
