//! GeoTIFF: heights as a picture, and keys that say where it lies.
//!
//! bytes -crate `tiff`-> samples; keys -GEOTIFF-> frame -> Grid
//!
//! Only two kinds of map are read: degrees on any datum that is called geographic, and metres of a projection, as the rest of farop knows no other. Which one
//! it is, `GTModelTypeGeoKey` says. Whether a sample stands for its middle or its corner, `GTRasterTypeGeoKey` does: half a pixel is half a pixel.
//!
//! Source: OGC 19-008r4, "OGC GeoTIFF Standard" 1.1, 2019; GDAL's tag 42113 for what was not measured. Cost: the file once, and the grid.

use super::GridFile;
use crate::diagnostic::Diagnostics;
use crate::forest::elevation::{Frame, Grid, Unit};
use std::io::Cursor;
use tiff::ColorType;
use tiff::decoder::{Decoder, DecodingResult, Limits};
use tiff::tags::Tag;

/// Keys of the directory.
const MODEL_TYPE: u16 = 1024;
const RASTER_TYPE: u16 = 1025;

/// Reads a file.
pub(super) fn read(file: &GridFile<'_>) -> Result<Grid, Diagnostics> {
    let broken = |error: tiff::TiffError| {
        file.refused(format!("`{}` is no whole TIFF: {error}", file.name), "was it copied whole? Get it again")
    };
    let mut decoder = Decoder::new(Cursor::new(file.bytes)).map_err(broken)?.with_limits(Limits::default());
    let (width, height) = decoder.dimensions().map_err(broken)?;
    let color = decoder.colortype().map_err(broken)?;
    if !matches!(color, ColorType::Gray(_)) {
        let message = format!("`{}` has {color:?} samples: heights are one number a pixel", file.name);
        return Err(file.refused(message, "name a file of heights"));
    }
    let frame = frame(file, &mut decoder)?;
    let nodata = decoder.get_tag_ascii_string(Tag::GdalNodata).ok();
    let nodata: Option<f64> = nodata.and_then(|text| text.trim_matches(['\0', ' ']).parse().ok());
    let samples = heights(decoder.read_image().map_err(broken)?);
    let measured = |height: f64| {
        height.is_finite() && nodata.is_none_or(|nodata| height != nodata && height as f32 != nodata as f32)
    };
    let heights = samples.into_iter().map(|height| if measured(height) { height as f32 } else { f32::NAN });
    file.grid((width as usize, height as usize), heights.collect(), frame)
}

fn heights(samples: DecodingResult) -> Vec<f64> {
    fn widened<T: Into<f64>>(samples: Vec<T>) -> Vec<f64> {
        samples.into_iter().map(Into::into).collect()
    }
    match samples {
        DecodingResult::U8(samples) => widened(samples),
        DecodingResult::U16(samples) => widened(samples),
        DecodingResult::U32(samples) => widened(samples),
        DecodingResult::U64(samples) => samples.into_iter().map(|sample| sample as f64).collect(),
        DecodingResult::F16(samples) => samples.into_iter().map(|sample| sample.to_f64()).collect(),
        DecodingResult::F32(samples) => widened(samples),
        DecodingResult::F64(samples) => samples,
        DecodingResult::I8(samples) => widened(samples),
        DecodingResult::I16(samples) => widened(samples),
        DecodingResult::I32(samples) => widened(samples),
        DecodingResult::I64(samples) => samples.into_iter().map(|sample| sample as f64).collect(),
    }
}

/// Where the samples lie.
fn frame(file: &GridFile<'_>, decoder: &mut Decoder<Cursor<&[u8]>>) -> Result<Frame, Diagnostics> {
    let refused = |what: &str| {
        let message = format!("`{}` does not say where it lies: {what}", file.name);
        file.refused(message, "write it again with `gdal_translate -of GTiff`, north up, without rotation")
    };
    let scale = decoder.get_tag_f64_vec(Tag::ModelPixelScaleTag);
    let tie = decoder.get_tag_f64_vec(Tag::ModelTiepointTag);
    let (Ok(scale), Ok(tie)) = (scale, tie) else { return Err(refused("tags 33550 and 33922 are missing")) };
    let (&[dx, dy, ..], &[column, row, _, x, y, ..]) = (&scale[..], &tie[..]) else {
        return Err(refused("tags 33550 and 33922 are too short"));
    };
    let is_plain = [dx, dy, column, row, x, y].iter().all(|number| number.is_finite()) && dx > 0.0 && dy > 0.0;
    if !is_plain {
        return Err(refused(&format!("its pixels are {dx} by {dy}")));
    }
    let keys = decoder.get_tag_u16_vec(Tag::GeoKeyDirectoryTag).unwrap_or_default();
    let key = |wanted: u16| keys.chunks_exact(4).skip(1).find(|key| key[0] == wanted && key[1] == 0).map(|key| key[3]);
    let unit = match key(MODEL_TYPE) {
        Some(1) => Unit::Metres,
        Some(2) => Unit::Degrees,
        _ => return Err(refused("its keys name neither a projection nor degrees")),
    };
    // A pixel that is an area has its sample in its middle.
    let middle = if key(RASTER_TYPE) == Some(2) { 0.0 } else { 0.5 };
    Ok(Frame { unit, west: x + (middle - column) * dx, north: y - (middle - row) * dy, step: [dx, dy] })
}
