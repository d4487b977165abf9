//! Screen files: a draw list as text, for a rasterizer in any language on any machine, and back.
//!
//! DrawList -WRITE-> text -> somebody's rasterizer; text -READ-> DrawList -> rasterizer
//!
//! Two kinds. The *classic* file of whole numbers is FAROP's own (1996): small, easily read, and it rounds everything. The
//! *v2* file loses nothing: reading it back gives the same list, and drawing that the same bytes of picture.
//! `docs/screen-files.md` describes both, number by number.
//!
//! Why v2 is text: a student reads it with the eyes first, then with forty lines of any language ([`READERS`]).
//! Why readers are strict: whoever is told of line and column at once does not hunt for a missing triangle later.
//!
//! Space: samples, x right, y down. Source: Pereira, "FAROP", IST/INESC 1996, appendix A.2, for the classic file.
//! Cost: linear in the text; memory is asked for only after a declared count was held against the length of the text.

mod classic_read;
mod classic_write;
mod error;
mod fit;
mod header;
mod mosaics;
mod number;
mod records;
mod shading;
mod textures;
mod v2;
mod words;

pub use classic_read::read_classic;
pub use classic_write::{ClassicOptions, ClassicReport, write_classic};
pub use error::{ScreenFileError, ScreenWriteError};
pub use v2::{Attributes, write_v2};

use super::DrawList;
use crate::color::{Encoding, Rgb};
use crate::plan::Transparency;
use words::{Layout, Words};

/// Example readers of v2 files, each of at most 40 lines: file name and text. A lab hands them out with its files.
pub const READERS: [(&str, &str); 4] = [
    ("reader.c", include_str!("readers/reader.c")),
    ("reader.cpp", include_str!("readers/reader.cpp")),
    ("Reader.java", include_str!("readers/Reader.java")),
    ("reader.py", include_str!("readers/reader.py")),
];

/// What a picture depends on besides the draw list.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sheet {
    /// A: the picture is the list's grid, divided by A in each direction.
    pub samples: u32,
    /// Linear light behind everything.
    pub background: Rgb<f32>,
    /// How transparent layers add up.
    pub transparency: Transparency,
    /// How the picture's levels are made of light.
    pub encoding: Encoding,
}

impl Default for Sheet {
    fn default() -> Self {
        let (background, transparency) = (Rgb::gray(0.0), Transparency::Over);
        Sheet { samples: 1, background, transparency, encoding: Encoding::Srgb }
    }
}

/// Which of the two formats a screen file has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// FAROP's whole numbers.
    Classic,
    /// Lossless.
    V2,
}

/// A screen file, read.
#[derive(Clone, Debug, PartialEq)]
pub struct ScreenFile {
    /// The format it was in.
    pub kind: Kind,
    /// What to draw.
    pub list: DrawList,
    /// What to draw it on.
    pub sheet: Sheet,
}

/// What a reader is told.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ReadOptions {
    /// How the colors of a classic file are encoded; a v2 file says so itself.
    pub encoding: Encoding,
    /// Files of larger pictures are refused.
    pub max_pixels: u64,
}

impl Default for ReadOptions {
    fn default() -> Self {
        ReadOptions { encoding: Encoding::Srgb, max_pixels: crate::image::MAX_PIXELS as u64 }
    }
}

/// Reads a screen file of either kind.
///
/// # Errors
/// [`ScreenFileError`] at the first thing that breaks the format. No text, however mangled, makes it panic.
pub fn read(text: &str, options: &ReadOptions) -> Result<ScreenFile, ScreenFileError> {
    let mut words = Words::new(text, Layout::Records);
    let first = words.first_word();
    if first.text == v2::NAME {
        return v2::read_v2(text, options);
    }
    if first.text.starts_with(|letter: char| letter.is_ascii_digit()) {
        return read_classic(text, options);
    }
    let error = words.error(first, format!("`{} 2`, or the four whole numbers of a classic screen file", v2::NAME));
    Err(error.with_help("`farop dump SCENE -o FILE.scr` writes a screen file"))
}

/// The side of the largest sample grid: up to here the fixed-point products of coverage are proven not to overflow.
const MAX_SIDE: u64 = 1 << 22;

/// Reads `width height` in samples and checks that a picture of that size can be made.
fn read_size(words: &mut Words<'_>, samples: u64, options: &ReadOptions) -> Result<(u32, u32), ScreenFileError> {
    let width = words.whole("the width in samples", 1..=MAX_SIDE)?;
    let word = words.word();
    let height = words.whole_of(word, "the height in samples", 1..=MAX_SIDE)?;
    for (what, side) in [("width", width), ("height", height)] {
        if side % samples != 0 {
            let expected = format!("a {what} of whole pixels, a multiple of {samples} samples");
            return Err(words.error(word, expected));
        }
    }
    if width * height / (samples * samples) > options.max_pixels {
        let expected = format!("a picture of at most {} pixels", options.max_pixels);
        return Err(words.error(word, expected).with_help("`--max-pixels N` allows more"));
    }
    Ok((width as u32, height as u32))
}
