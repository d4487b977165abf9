//! PNG as heights: gray levels, or heights in three colors.
//!
//! Paper 004's height map: every pixel a sample, the brighter the higher. What black and white mean and how far pixels are apart the file
//! does not say; options do. 8 and 16 bits of gray are read as they are; the grid lies in metres from its south-west corner.
//!
//! Heights in color are -10,000 m + 0.1 m (65536 R + 256 G + B), as web maps have them. A colored PNG is refused unless that was asked for:
//! a photograph has no heights.
//!
//! Source: J. Caralo, height maps and billboards (paper 004); PNG, ISO/IEC 15948.

use super::{GridFile, GridOptions};
use crate::diagnostic::Diagnostics;
use crate::forest::elevation::{Frame, Grid, SAMPLE_LIMIT, Unit};
use ::image::codecs::png::PngDecoder;
use ::image::{DynamicImage, ImageDecoder, Limits};
use std::io::Cursor;

pub(super) fn read(file: &GridFile<'_>, options: &GridOptions) -> Result<Grid, Diagnostics> {
    let broken = |cause: &dyn std::fmt::Display| {
        file.refused(format!("`{}` cannot be read as PNG: {cause}", file.name), "is it a PNG file, and whole?")
    };
    // Check the size that the header claims before asking for memory.
    let mut decoder = PngDecoder::new(Cursor::new(file.bytes)).map_err(|error| broken(&error))?;
    let (width, height) = decoder.dimensions();
    if u64::from(width) * u64::from(height) > SAMPLE_LIMIT as u64 {
        return Err(file.refused(
            format!("`{}` has {width} x {height} pixels, more than {SAMPLE_LIMIT}", file.name),
            "cut it into tiles",
        ));
    }
    let mut limits = Limits::no_limits();
    limits.max_alloc = Some(u64::from(width) * u64::from(height) * 16 + (1 << 20));
    decoder.set_limits(limits).map_err(|error| broken(&error))?;
    let image = DynamicImage::from_decoder(decoder).map_err(|error| broken(&error))?;
    let heights = heights(file, &image, options)?;
    let step = [options.spacing, options.spacing];
    let frame = Frame { unit: Unit::Metres, west: 0.0, north: f64::from(height.max(1) - 1) * options.spacing, step };
    file.grid((width as usize, height as usize), heights, frame)
}

fn heights(file: &GridFile<'_>, image: &DynamicImage, options: &GridOptions) -> Result<Vec<f32>, Diagnostics> {
    let (low, high) = options.heights;
    let between = |level: f64, white: f64| (low + (high - low) * level / white) as f32;
    Ok(match image {
        DynamicImage::ImageLuma8(gray) => gray.as_raw().iter().map(|&level| between(f64::from(level), 255.0)).collect(),
        DynamicImage::ImageLuma16(gray) => {
            gray.as_raw().iter().map(|&level| between(f64::from(level), 65_535.0)).collect()
        }
        DynamicImage::ImageRgb8(colors) if options.colored => {
            let tenths = |[r, g, b]: [u8; 3]| f64::from(r) * 65_536.0 + f64::from(g) * 256.0 + f64::from(b);
            colors.pixels().map(|pixel| (tenths(pixel.0) / 10.0 - 10_000.0) as f32).collect()
        }
        _ => {
            return Err(file.refused(
                format!("`{}` is no gray picture, so brightness is no height", file.name),
                "save it as gray of 8 or 16 bits without alpha; \
                 if red, green and blue hold the height as web maps have it, add `--colored`",
            ));
        }
    })
}
