//! PNG: the compressed picture file that every tool opens. A thin layer over the `image` crate.
//!
//! Written as 8-bit RGB. Read from gray, palette, alpha and 16 bits too: gray becomes three equal channels, alpha
//! is dropped (not blended), 16 bits are rounded to 8.
//!
//! Note: two versions of the compressor may write the same picture in different bytes. Compare decoded pixels.

use super::file::checked_size;
use super::{ImageError, Picture};
use ::image::codecs::png::{CompressionType, FilterType, PngDecoder, PngEncoder};
use ::image::{DynamicImage, ExtendedColorType, ImageDecoder, ImageEncoder, Limits};
use std::io::Cursor;

pub(super) fn encode(picture: &Picture) -> Result<Vec<u8>, ImageError> {
    let size = |side: usize| u32::try_from(side).map_err(|_| broken("a side of more than 2^32 - 1 pixels"));
    let (width, height) = (size(picture.width())?, size(picture.height())?);
    let mut bytes = Vec::new();
    // Fast: 12 ms for 1024 x 1024 instead of 69 ms, for files about twice as large.
    PngEncoder::new_with_quality(&mut bytes, CompressionType::Fast, FilterType::Adaptive)
        .write_image(picture.rgb(), width, height, ExtendedColorType::Rgb8)
        .map_err(broken)?;
    Ok(bytes)
}

pub(super) fn decode(bytes: &[u8]) -> Result<Picture, ImageError> {
    // Check the size that the header claims before asking for memory.
    let mut decoder = PngDecoder::new(Cursor::new(bytes)).map_err(broken)?;
    let (width, height) = decoder.dimensions();
    let (width, height) = checked_size(u64::from(width), u64::from(height))?;
    let mut limits = Limits::no_limits();
    // At most 8 bytes a pixel (16-bit RGBA) for the picture and as much again to work in.
    limits.max_alloc = Some((width * height) as u64 * 16 + (1 << 20));
    decoder.set_limits(limits).map_err(broken)?;

    let rgb = DynamicImage::from_decoder(decoder).map_err(broken)?.into_rgb8().into_raw();
    Picture::from_rgb(width, height, rgb)
}

fn broken(cause: impl ToString) -> ImageError {
    ImageError::Png { what: cause.to_string() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn png_of(samples: &[u8], color: ExtendedColorType, width: u32) -> Vec<u8> {
        let mut bytes = Vec::new();
        PngEncoder::new(&mut bytes).write_image(samples, width, 1, color).expect("a row of samples");
        bytes
    }

    #[test]
    fn every_level_comes_back() {
        let rgb: Vec<u8> = (0..768).map(|index| (index * 7 % 256) as u8).collect();
        let picture = Picture::from_rgb(16, 16, rgb).expect("256 pixels");
        assert_eq!(decode(&encode(&picture).expect("encodes")).expect("decodes"), picture);
    }

    #[test]
    fn other_kinds_are_converted() {
        let gray = decode(&png_of(&[7, 200], ExtendedColorType::L8, 2)).expect("gray");
        assert_eq!(gray.rgb(), [7, 7, 7, 200, 200, 200]);
        let alpha = decode(&png_of(&[1, 2, 3, 0], ExtendedColorType::Rgba8, 1)).expect("alpha");
        assert_eq!(alpha.rgb(), [1, 2, 3]);
        // 16 bits: 257 steps a level.
        let deep: Vec<u8> = [0x8080u16, 0x0000, 0xFFFF].iter().flat_map(|sample| sample.to_ne_bytes()).collect();
        assert_eq!(decode(&png_of(&deep, ExtendedColorType::Rgb16, 1)).expect("16 bits").rgb(), [128, 0, 255]);
    }

    #[test]
    fn broken_files_are_errors() {
        let whole = encode(&Picture::filled(20, 20, [50, 60, 70])).expect("encodes");
        for length in 0..whole.len() - 12 {
            assert!(decode(&whole[..length]).is_err(), "cut at {length}");
        }
    }

    #[test]
    fn a_claimed_size_is_checked_before_memory_is_asked_for() {
        let claiming = |side: u32| {
            let mut bytes = encode(&Picture::filled(1, 1, [0; 3])).expect("encodes");
            // Width and height stand at bytes 16 and 20; the checksum of the header at 29.
            bytes[16..20].copy_from_slice(&side.to_be_bytes());
            bytes[20..24].copy_from_slice(&side.to_be_bytes());
            let checksum = header_checksum(&bytes[12..29]);
            bytes[29..33].copy_from_slice(&checksum.to_be_bytes());
            decode(&bytes)
        };
        assert!(claiming(1).is_ok());
        let refused = claiming(65_536);
        assert!(matches!(refused, Err(ImageError::TooLarge { width: 65_536, height: 65_536 })), "{refused:?}");
        assert!(claiming(0x7FFF_FFFF).is_err());
    }

    /// The checksum of PNG chunks (ISO 3309), bit by bit.
    fn header_checksum(chunk: &[u8]) -> u32 {
        !chunk.iter().fold(!0u32, |crc, &byte| {
            (0..8).fold(crc ^ u32::from(byte), |crc, _| (crc >> 1) ^ if crc & 1 == 1 { 0xEDB8_8320 } else { 0 })
        })
    }
}
