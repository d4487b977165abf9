//! The head of a v2 file: everything that holds for the whole picture, one record a line, written and read in one order.
//!
//! Why so many words that never change (`y_axis down`): a file that leaves its pixel center and tie rule to be guessed is
//! drawn half a pixel off by everybody but its author. A reader that finds another word there must not go on.

use super::number::Number;
use super::textures;
use super::v2::{Attributes, NAME};
use super::words::Words;
use super::{ReadOptions, ScreenFileError, Sheet, read_size};
use crate::color::{Encoding, Rgb};
use crate::plan::{DepthFormat, Interpolation, Transparency, Varying};
use crate::screen::{DepthMapping, DrawList, Grid, Precision};
use std::io::{self, Write};

/// Rules that every v2 file follows.
const RULES: [(&str, &str); 6] = [
    ("pixel_center", "0.5 0.5"),
    ("y_axis", "down"),
    ("coverage", "even_odd left_top"),
    ("depth_is", "inverse_w larger_is_nearer"),
    ("depth_ties", "first_polygon"),
    ("plane_blocks", "16"),
];

/// Where a v2 file stores depth planes and what varies: yes, or no.
const YES_NO: [(bool, &str); 2] = [(true, "yes"), (false, "no")];
const ENCODINGS: [(Encoding, &str); 2] = [(Encoding::Srgb, "srgb"), (Encoding::Linear, "linear")];
const PRECISIONS: [(Precision, &str); 2] = [(Precision::Single, "single"), (Precision::Double, "double")];
const VARYINGS: [(Varying, &str); 7] = [
    (Varying::Color, "color"),
    (Varying::NormalEye, "normal_eye"),
    (Varying::NormalEyeColor, "normal_eye_color"),
    (Varying::Nothing, "nothing"),
    (Varying::ColorTexture, "color_texture"),
    (Varying::NormalEyeTexture, "normal_eye_texture"),
    (Varying::NormalEyeColorTexture, "normal_eye_color_texture"),
];

/// What may vary beside normals, all of it.
const ALL_NAMES: [&str; 11] = [
    "normal_x",
    "normal_y",
    "normal_z",
    "eye_x",
    "eye_y",
    "eye_z",
    "factor_red",
    "factor_green",
    "factor_blue",
    "u",
    "v",
];

/// How many records of each sort follow the head.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct RecordCounts {
    pub lights: usize,
    pub surfaces: usize,
    pub polygons: usize,
    pub vertices: usize,
}

/// The head, read: a list without polygons, and what follows.
pub(super) struct Header {
    pub list: DrawList,
    /// The unit of eye space to draw in; the file's numbers are in scene units.
    pub unit: f64,
    pub sheet: Sheet,
    /// Vertices of a list of normals carry colors besides.
    pub extra_color: bool,
    pub counts: RecordCounts,
    /// How many pictures follow.
    pub textures: usize,
}

/// The names of the numbers that vary, in order.
pub(super) fn varying_names(varying: Varying) -> &'static [&'static str] {
    match varying {
        Varying::Nothing => &[],
        Varying::Color => &["red", "green", "blue"],
        Varying::NormalEye => &["normal_x", "normal_y", "normal_z", "eye_x", "eye_y", "eye_z"],
        Varying::NormalEyeColor => &ALL_NAMES[..9],
        Varying::NormalEyeColorTexture => &ALL_NAMES,
        Varying::ColorTexture => &["red", "green", "blue", "u", "v"],
        Varying::NormalEyeTexture => &["normal_x", "normal_y", "normal_z", "eye_x", "eye_y", "eye_z", "u", "v"],
    }
}

/// The fields of a vertex record, in order.
fn vertex_fields(varying: Varying, extra_color: bool) -> String {
    let extra: &[_] = if extra_color { varying_names(Varying::Color) } else { &[] };
    [&["x", "y", "inverse_w", "xw", "yw", "w", "edge"], varying_names(varying), extra].concat().join(" ")
}

/// Writes the head of `list`.
pub(super) fn write(
    (list, unit): (&DrawList, f64),
    sheet: &Sheet,
    attributes: Attributes,
    out: &mut dyn Write,
) -> io::Result<()> {
    writeln!(out, "{NAME} 2")?;
    writeln!(out, "# One record a line: its keyword, then its fields. What each number means: docs/screen-files.md")?;
    writeln!(out, "samples {}", sheet.samples)?;
    writeln!(out, "size {} {}", list.width, list.height)?;
    for (keyword, rule) in RULES {
        writeln!(out, "{keyword} {rule}")?;
    }
    let DepthMapping { format, nearest, farthest } = list.depth_mapping;
    writeln!(out, "depth_format {} {} {}", format.name(), Number(nearest), Number(farthest))?;
    if unit != 1.0 {
        writeln!(out, "eye_unit {}", Number(unit))?;
    }
    writeln!(out, "subpixel_bits {}", list.grid.bits)?;
    writeln!(out, "precision {}", name_of(list.precision, &PRECISIONS))?;
    writeln!(out, "interpolation {}", list.interpolation.name())?;
    writeln!(out, "transparency {}", sheet.transparency.name())?;
    writeln!(out, "encoding {}", sheet.encoding.name())?;
    writeln!(out, "background {}", color_text(sheet.background))?;
    writeln!(out, "line_color {}", color_text(list.shader.line_color))?;
    writeln!(out, "planes {}", name_of(list.has_depth, &YES_NO))?;
    writeln!(out, "blending {}", name_of(list.has_blending, &YES_NO))?;
    writeln!(out, "varying {}", name_of(list.varying, &VARYINGS))?;
    textures::write_head(list, out)?;
    writeln!(out, "vertex_fields {}", vertex_fields(list.varying, attributes.adds_color(list)))?;
    writeln!(out, "lights {}", list.shader.lights.len())?;
    writeln!(out, "surfaces {}", list.shader.surfaces.len())?;
    writeln!(out, "polygons {}", list.len())?;
    writeln!(out, "vertices {}", list.vertices.len())
}

/// Reads the head, from the first word of the file on.
pub(super) fn read(words: &mut Words<'_>, options: &ReadOptions) -> Result<Header, ScreenFileError> {
    words.record(NAME)?;
    words.whole("the version of the format", 2..=2)?;
    words.end_of_record()?;
    let samples = field(words, "samples", |words| words.whole("samples per pixel and direction", 1..=64))?;
    let (width, height) = field(words, "size", |words| read_size(words, samples, options))?;
    let mut list = DrawList::new(width, height);
    for (keyword, rule) in RULES {
        field(words, keyword, |words| rule.split(' ').try_for_each(|word| fixed(words, word)))?;
    }
    list.depth_mapping = field(words, "depth_format", depth_mapping)?;
    let unit = if words.clone().first_word().text == "eye_unit" { field(words, "eye_unit", eye_unit)? } else { 1.0 };
    let bits = field(words, "subpixel_bits", |words| words.whole("sub-pixel bits", 0..=16))?;
    list.grid = Grid { bits: bits as u32 };
    list.precision = field(words, "precision", |words| words.choice("the digits of planes", &PRECISIONS))?;
    let interpolations = Interpolation::ALL.iter().map(|&value| (value, value.name())).collect::<Vec<_>>();
    list.interpolation = field(words, "interpolation", |words| words.choice("how values run", &interpolations))?;
    let mut sheet = Sheet { samples: samples as u32, ..Sheet::default() };
    let rules = Transparency::ALL.iter().map(|&value| (value, value.name())).collect::<Vec<_>>();
    sheet.transparency = field(words, "transparency", |words| words.choice("how layers add up", &rules))?;
    sheet.encoding = field(words, "encoding", |words| words.choice("what levels mean", &ENCODINGS))?;
    sheet.background = field(words, "background", |words| color(words, "of the background"))?;
    list.shader.line_color = field(words, "line_color", |words| color(words, "of lines"))?;
    list.has_depth = field(words, "planes", |words| words.choice("whether polygons have planes", &YES_NO))?;
    list.has_blending = field(words, "blending", |words| words.choice("whether surfaces are transparent", &YES_NO))?;
    list.varying = field(words, "varying", |words| words.choice("what varies", &VARYINGS))?;
    let mut textures = 0;
    if list.has_texture() {
        (list.shader.textures, textures) = textures::read_head(words, &sheet)?;
    }
    let extra_color = field(words, "vertex_fields", |words| read_vertex_fields(words, list.varying))?;
    let counts = RecordCounts {
        lights: field(words, "lights", |words| words.count("the number of lights", 12))?,
        surfaces: field(words, "surfaces", |words| words.count("the number of surfaces", 26))?,
        polygons: field(words, "polygons", |words| words.count("the number of polygons", 26))?,
        vertices: field(words, "vertices", |words| words.count("the number of vertices", 21))?,
    };
    Ok(Header { list, sheet, unit, extra_color, counts, textures })
}

/// Reads the record of `keyword`, its fields by `fields`.
fn field<'a, T>(
    words: &mut Words<'a>,
    keyword: &str,
    fields: impl FnOnce(&mut Words<'a>) -> Result<T, ScreenFileError>,
) -> Result<T, ScreenFileError> {
    words.record(keyword)?;
    let value = fields(words)?;
    words.end_of_record()?;
    Ok(value)
}

/// A word that is always the same.
fn fixed(words: &mut Words<'_>, expected: &str) -> Result<(), ScreenFileError> {
    let word = words.word();
    if word.text == expected {
        return Ok(());
    }
    let error = words.error(word, format!("`{expected}`"));
    Err(error.with_help("farop knows one rule for this; a picture drawn by another would be wrong"))
}

fn depth_mapping(words: &mut Words<'_>) -> Result<DepthMapping, ScreenFileError> {
    let formats = DepthFormat::ALL.iter().map(|&value| (value, value.name())).collect::<Vec<_>>();
    let format = words.choice("how depth is kept", &formats)?;
    let nearest = words.number("1 / hither")?;
    let word = words.word();
    let farthest = word.text.parse().ok().filter(|&farthest| 0.0 <= farthest && farthest < nearest);
    let farthest = farthest.ok_or_else(|| words.error(word, "1 / yon, at least 0 and below 1 / hither"))?;
    Ok(DepthMapping { format, nearest, farthest })
}

/// The unit of eye space, in scenes whose hither is extreme.
fn eye_unit(words: &mut Words<'_>) -> Result<f64, ScreenFileError> {
    let word = words.word();
    let is_power = |unit: &f64| *unit > 0.0 && unit.is_normal() && unit.to_bits() << 12 == 0;
    let unit = word.text.parse().ok().filter(is_power);
    unit.ok_or_else(|| words.error(word, "the unit of eye space, a power of two"))
}

/// The names of the fields of a vertex; returns whether a color follows the normal and eye point.
fn read_vertex_fields(words: &mut Words<'_>, varying: Varying) -> Result<bool, ScreenFileError> {
    vertex_fields(varying, false).split(' ').try_for_each(|name| fixed(words, name))?;
    if !varying.has_normals() {
        return Ok(false);
    }
    let word = words.word();
    if word.text.is_empty() {
        return Ok(false);
    }
    if word.text != "red" {
        return Err(words.error(word, "`red`, or the end of the line"));
    }
    ["green", "blue"].into_iter().try_for_each(|name| fixed(words, name))?;
    Ok(true)
}

/// Three channels in single precision.
pub(super) fn color(words: &mut Words<'_>, of: &str) -> Result<Rgb<f32>, ScreenFileError> {
    let mut channel = |name: &str| words.single(&format!("{name} {of}"));
    Ok(Rgb::new(channel("red")?, channel("green")?, channel("blue")?))
}

/// Three channels as text.
pub(super) fn color_text(color: Rgb<f32>) -> String {
    color.to_array().map(|channel| Number(channel).to_string()).join(" ")
}

/// The name of `value` in `table`, which holds all values.
pub(super) fn name_of<T: PartialEq>(value: T, table: &[(T, &'static str)]) -> &'static str {
    table.iter().find(|(listed, _)| *listed == value).map_or("", |(_, name)| name)
}
