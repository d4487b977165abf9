//! What a v2 file says about pictures, written and read side by side: the pictures themselves stand in it.
//!
//! Why not their names: the file is for a machine elsewhere, and a program behind a door sees no other file.
//!
//! A picture is a head, `texture NUMBER WIDTH HEIGHT WRAP THRESHOLD NAME`, and a line of `texels` for every row, from the lowest:
//! eight hexadecimal digits a texel, red, green, blue, alpha. The threshold is `opaque` where alpha means nothing. A fade and a mosaic
//! ([`super::mosaics`]) are told behind the name.

use super::header::name_of;
use super::mosaics::{read_mosaic, read_mosaic_size, write_mosaic};
use super::number::Number;
use super::records::WHOLE;
use super::words::Words;
use super::{ScreenFileError, Sheet};
use crate::image::textures::{FirstRow, MOST_TEXELS, Rgba, Texels, Wrap};
use crate::plan::{AlphaRule, TextureFilter};
use crate::scene::Fade;
use crate::screen::DrawList;
use crate::screen::shader::{Picture, TextureShading, Textures};
use std::io::{self, Write};
use std::sync::Arc;

const WRAPS: [(Wrap, &str); 2] = [(Wrap::Repeat, "repeat"), (Wrap::Clamp, "clamp")];

/// Writes how pictures are looked up, and how many there are; nothing for a list without.
pub(super) fn write_head(list: &DrawList, out: &mut dyn Write) -> io::Result<()> {
    if !list.has_texture() {
        return Ok(());
    }
    let Textures { list: textures, filter, alpha, .. } = &list.shader.textures;
    writeln!(out, "texture_filter {}", filter.name())?;
    writeln!(out, "alpha {}", alpha.name())?;
    writeln!(out, "textures {}", textures.len())
}

/// Reads what [`write_head`] wrote: empty textures, and how many follow.
pub(super) fn read_head(words: &mut Words<'_>, sheet: &Sheet) -> Result<(Textures, usize), ScreenFileError> {
    words.record("texture_filter")?;
    let filters = TextureFilter::ALL.iter().map(|&value| (value, value.name())).collect::<Vec<_>>();
    let filter = words.choice("how pictures are looked up", &filters)?;
    words.end_of_record()?;
    words.record("alpha")?;
    let rules = AlphaRule::ALL.iter().map(|&value| (value, value.name())).collect::<Vec<_>>();
    let alpha = words.choice("which samples of surfaces with holes are there", &rules)?;
    words.end_of_record()?;
    words.record("textures")?;
    let count = words.count("the number of pictures", 30)?;
    words.end_of_record()?;
    Ok((Textures::new(filter, alpha, sheet.samples), count))
}

pub(super) fn write_texture(index: usize, texture: &TextureShading, out: &mut dyn Write) -> io::Result<()> {
    let (width, height) = texture.texels.size();
    let wrap = name_of(texture.pyramid.wrap(), &WRAPS);
    let threshold = texture.threshold.map_or("opaque".to_string(), |threshold| Number(threshold).to_string());
    write!(out, "texture {index} {width} {height} {wrap} {threshold} {}", one_word(&texture.name))?;
    if let Some(Fade { from, to }) = texture.fade {
        write!(out, " fade {from} {to}")?;
    }
    let mosaic = texture.mosaic.as_ref().map(|shading| &*shading.mosaic);
    if let Some(mosaic) = mosaic {
        let (width, height) = mosaic.size();
        write!(out, " mosaic {width} {height} {}", mosaic.tiles().len())?;
    }
    writeln!(out)?;
    write_texels(&texture.texels, out)?;
    mosaic.map_or(Ok(()), |mosaic| write_mosaic(mosaic, out))
}

/// A line for every row.
pub(super) fn write_texels(texels: &Texels, out: &mut dyn Write) -> io::Result<()> {
    for row in texels.rgba().chunks_exact(texels.size().0 as usize) {
        write!(out, "texels ")?;
        row.iter().try_for_each(|&[r, g, b, a]| write!(out, "{r:02x}{g:02x}{b:02x}{a:02x}"))?;
        writeln!(out)?;
    }
    Ok(())
}

/// Reads picture `index` and adds it to `textures`.
pub(super) fn read_texture(
    words: &mut Words<'_>,
    index: usize,
    sheet: &Sheet,
    textures: &mut Textures,
) -> Result<(), ScreenFileError> {
    words.record("texture")?;
    words.whole("the number of the picture", index as u64..=index as u64)?;
    let size = read_size(words)?;
    let wrap = words.choice("how the picture goes on", &WRAPS)?;
    let word = words.word();
    let number = || word.text.parse().ok().filter(|threshold: &f32| (0.0..=1.0).contains(threshold));
    let threshold = if word.text == "opaque" { None } else { number().map(Some).unwrap_or_default() };
    if threshold.is_none() && word.text != "opaque" {
        return Err(words.error(word, "what alpha must be above, 0 to 1, or `opaque`"));
    }
    let name = words.word().text.to_string();
    let fade = read_fade(words)?;
    let mosaic = read_mosaic_size(words)?;
    words.end_of_record()?;
    let texels = read_texels(words, size)?;
    let mosaic = mosaic.map(|size| read_mosaic(words, size)).transpose()?;
    let (encoding, mosaic) = (sheet.encoding, mosaic.as_ref());
    let picture = Picture { name: &name, texels: &texels, mosaic, lookup: None, encoding, threshold, fade, wrap };
    textures.push(&picture, &Textures::default());
    Ok(())
}

/// Width and height of a picture whose rows follow.
pub(super) fn read_size(words: &mut Words<'_>) -> Result<(u32, u32), ScreenFileError> {
    let width = words.whole("texels across", 1..=MOST_TEXELS)?;
    let word = words.word();
    let height = words.whole_of(word, "texels up", 1..=MOST_TEXELS / width)?;
    if width * height * 8 > words.bytes_left() {
        return Err(words.error(word, "so many texels as follow").with_help("was the file copied whole?"));
    }
    Ok((width as u32, height as u32))
}

fn read_fade(words: &mut Words<'_>) -> Result<Option<Fade>, ScreenFileError> {
    if words.peek().text != "fade" {
        return Ok(None);
    }
    words.word();
    let ranks = 0..=u64::from(Fade::RANKS);
    let from = words.whole("the first rank that is shown", ranks.clone())? as u8;
    let to = words.whole("the first rank above that is not", ranks)? as u8;
    Ok(Some(Fade { from, to }))
}

/// A picture of that size.
pub(super) fn read_texels(words: &mut Words<'_>, (width, height): (u32, u32)) -> Result<Arc<Texels>, ScreenFileError> {
    let mut rgba = Vec::with_capacity(width as usize * height as usize);
    for _ in 0..height {
        read_row(words, width as usize, &mut rgba)?;
    }
    let word = words.peek();
    let texels = Texels::new(width, height, rgba, FirstRow::AtV0);
    Ok(Arc::new(texels.ok_or_else(|| words.error(word, "a picture"))?))
}

fn read_row(words: &mut Words<'_>, width: usize, rgba: &mut Vec<Rgba>) -> Result<(), ScreenFileError> {
    words.record("texels")?;
    let digits = read_digits(words, 8 * width, "8 a texel")?;
    let texel = |digits: &[u8]| std::array::from_fn(|channel| digits[2 * channel] << 4 | digits[2 * channel + 1]);
    rgba.extend(digits.chunks_exact(8).map(texel));
    words.end_of_record()
}

/// A word of hexadecimal digits.
pub(super) fn read_digits(words: &mut Words<'_>, count: usize, each: &str) -> Result<Vec<u8>, ScreenFileError> {
    let word = words.word();
    let digit = |digit: &u8| (*digit as char).to_digit(16).map(|digit| digit as u8);
    let digits: Option<Vec<u8>> = word.text.as_bytes().iter().map(digit).collect();
    let digits = digits.filter(|digits| digits.len() == count);
    digits.ok_or_else(|| words.error(word, format!("{count} hexadecimal digits, {each}")))
}

/// The picture of a surface: the last words of its record.
pub(super) fn read_texture_of_surface(
    words: &mut Words<'_>,
    textures: &Textures,
) -> Result<Option<u32>, ScreenFileError> {
    let word = words.peek();
    if word.text != "texture" {
        return Ok(None);
    }
    words.word();
    let word = words.word();
    let Some(last) = textures.list.len().checked_sub(1) else {
        return Err(words.error(word, "no picture, because the file has none"));
    };
    Ok(Some(words.whole_of(word, "the number of a picture", WHOLE)? as u32).filter(|&index| index as usize <= last))
        .and_then(|index| index.map(Some).ok_or_else(|| words.error(word, format!("a picture, 0 to {last}"))))
}

/// A file name without blanks, line ends or what starts a comment.
fn one_word(name: &str) -> String {
    let plain =
        |letter: char| if letter.is_whitespace() || letter == '#' || letter.is_control() { '_' } else { letter };
    if name.is_empty() { "-".to_string() } else { name.chars().map(plain).collect() }
}
