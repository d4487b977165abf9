//! Texture files: PNG, BMP and PPM with their alpha.
//!
//! bytes -> DECODE -> Texels
//!
//! Pictures that are compared and written have no alpha ([`crate::image::decode`] drops it); textures live by it. The formats
//! themselves, BMP's padded rows, upside-down heights and palettes among them, are the `image` crate's business.

use super::{FirstRow, Rgba, Texels};
use ::image::codecs::png::{CompressionType, FilterType, PngEncoder};
use ::image::{ExtendedColorType, ImageEncoder, ImageFormat, ImageReader, Limits};
use std::fs::File;
use std::io::{Cursor, Read};
use std::path::Path;

/// The largest texture, in texels: 4096 x 4096.
pub const MOST_TEXELS: u64 = 1 << 24;
/// The longest file that is read: 8 bytes a texel and some more.
const MOST_BYTES: u64 = MOST_TEXELS * 8 + 65_536;

/// Why a texture could not be read.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum TextureError {
    /// The file cannot be opened or read.
    #[error("cannot read it: {0}")]
    Read(#[from] std::io::Error),
    /// The first bytes belong to no format that is read.
    #[error("it is no picture farop can read: PNG, BMP and PPM are")]
    UnknownFormat,
    /// The format's reader gave up.
    #[error("it is broken: {0}")]
    Broken(String),
    /// No texels, or more than [`MOST_TEXELS`].
    #[error("it has {width} x {height} texels: a texture has 1 to {MOST_TEXELS}")]
    Size {
        /// Columns, as the file says.
        width: u32,
        /// Rows, as the file says.
        height: u32,
    },
}

/// Reads a texture file; its first bytes say which format it is.
///
/// # Errors
/// When the file cannot be read, is no picture, is broken, or is larger than [`MOST_TEXELS`].
pub fn read(path: &Path) -> Result<Texels, TextureError> {
    let mut file = File::open(path)?.take(MOST_BYTES);
    let mut bytes = Vec::new();
    // A device or a huge file of another kind must not fill the memory.
    file.by_ref().take(8).read_to_end(&mut bytes)?;
    format_of(&bytes)?;
    file.read_to_end(&mut bytes)?;
    decode(&bytes)
}

/// The texture in the bytes of a PNG, BMP or PPM file. Without alpha in the file, all of it is there.
///
/// # Errors
/// When the bytes are no picture, are broken, or say a size of more than [`MOST_TEXELS`].
pub fn decode(bytes: &[u8]) -> Result<Texels, TextureError> {
    let format = format_of(bytes)?;
    let open = || ImageReader::with_format(Cursor::new(bytes), format);
    let broken = |error: ::image::ImageError| TextureError::Broken(error.to_string());
    // Hold the size that the header claims against the limit before asking for memory.
    let (width, height) = open().into_dimensions().map_err(broken)?;
    if !(1..=MOST_TEXELS).contains(&(u64::from(width) * u64::from(height))) {
        return Err(TextureError::Size { width, height });
    }
    let mut reader = open();
    let mut limits = Limits::no_limits();
    limits.max_alloc = Some(u64::from(width) * u64::from(height) * 16 + (1 << 20));
    reader.limits(limits);
    let rgba = reader.decode().map_err(broken)?.into_rgba8();
    let texels = rgba.as_chunks().0.to_vec();
    Texels::new(width, height, texels, FirstRow::Top).ok_or(TextureError::Size { width, height })
}

/// The bytes of a PNG file with alpha: how scenes' own textures are written (`examples/texture_pictures.rs`).
///
/// # Errors
/// What the encoder says.
pub fn encode_png(texels: &Texels) -> Result<Vec<u8>, TextureError> {
    let (width, height) = texels.size();
    let rows = texels.rgba().chunks_exact(width as usize).rev();
    let rgba: Vec<u8> = rows.flatten().flat_map(|texel: &Rgba| *texel).collect();
    let mut bytes = Vec::new();
    PngEncoder::new_with_quality(&mut bytes, CompressionType::Best, FilterType::Adaptive)
        .write_image(&rgba, width, height, ExtendedColorType::Rgba8)
        .map_err(|error| TextureError::Broken(error.to_string()))?;
    Ok(bytes)
}

fn format_of(bytes: &[u8]) -> Result<ImageFormat, TextureError> {
    match bytes {
        [0x89, b'P', b'N', b'G', ..] => Ok(ImageFormat::Png),
        [b'B', b'M', ..] => Ok(ImageFormat::Bmp),
        [b'P', b'1'..=b'6', ..] => Ok(ImageFormat::Pnm),
        _ => Err(TextureError::UnknownFormat),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A 24-bit BMP of 3 x 2 pixels by hand: rows from the bottom, padded to 4 bytes, blue first.
    fn bmp(height: i32) -> Vec<u8> {
        let mut bytes = b"BM".to_vec();
        let word = |bytes: &mut Vec<u8>, number: u32| bytes.extend(number.to_le_bytes());
        [54 + 24, 0, 54, 40, 3].into_iter().for_each(|number| word(&mut bytes, number));
        word(&mut bytes, height as u32);
        bytes.extend([1, 0, 24, 0]);
        [0, 24, 0, 0, 0, 0].into_iter().for_each(|number| word(&mut bytes, number));
        for row in [[[0, 0, 255], [0, 255, 0], [255, 0, 0]], [[0, 0, 0], [1, 2, 3], [255, 255, 255]]] {
            bytes.extend(row.into_iter().flatten());
            bytes.extend([0xEE; 3]);
        }
        bytes
    }

    #[test]
    fn padded_rows_of_bmp_come_out_straight() {
        let texels = decode(&bmp(2)).expect("a BMP");
        assert_eq!(texels.size(), (3, 2));
        let lower = [[255, 0, 0, 255], [0, 255, 0, 255], [0, 0, 255, 255]];
        let upper = [[0, 0, 0, 255], [3, 2, 1, 255], [255, 255, 255, 255]];
        assert_eq!(texels.rgba(), [lower, upper].concat());
        // A negative height says that the upper row comes first.
        assert_eq!(decode(&bmp(-2)).expect("a BMP").rgba(), [upper, lower].concat());
        let keyed = texels.keyed([0; 3]);
        assert_eq!(keyed.rgba().iter().filter(|texel| texel[3] == 0).count(), 1);
    }

    #[test]
    fn png_keeps_its_alpha() {
        let rgba = (0..12u8).map(|index| [index, 2 * index, 255 - index, index * 20]).collect();
        let texels = Texels::new(4, 3, rgba, FirstRow::AtV0).expect("12 texels");
        assert_eq!(decode(&encode_png(&texels).expect("encodes")).expect("decodes"), texels);
        // What PPM has no word for is there.
        assert_eq!(decode(b"P3 1 1 255 1 2 3").expect("a PPM").rgba(), [[1, 2, 3, 255]]);
    }

    #[test]
    fn what_is_no_texture_is_an_error() {
        for bytes in [&b""[..], b"GIF89a", b"BM", b"\x89PNG", b"P6 70000 70000 255 "] {
            assert!(decode(bytes).is_err(), "{bytes:?}");
        }
        let cut = bmp(2);
        (2..cut.len() - 12).for_each(|length| assert!(decode(&cut[..length]).is_err(), "cut at {length}"));
        assert!(read(Path::new("no such file.png")).is_err());
    }
}
