//! What a v2 file says about mosaics, written and read side by side, behind the picture they belong to.
//!
//! `mosaic WIDTH HEIGHT TILES` ends the record of the picture. A line of `ids` follows for every row of numbers, from the lowest, two
//! hexadecimal digits each; then for each tile `tile NUMBER WIDTH HEIGHT REPEAT-U REPEAT-V` and its rows of `texels`.

use super::ScreenFileError;
use super::number::Number;
use super::textures::{read_digits, read_size, read_texels, write_texels};
use super::words::Words;
use crate::image::textures::{FirstRow, MOST_TEXELS, Mosaic, Tile};
use std::io::{self, Write};
use std::sync::Arc;

/// Width, height, tiles.
pub(super) type MosaicSize = (u32, u32, usize);

/// Everything behind the record of the picture.
pub(super) fn write_mosaic(mosaic: &Mosaic, out: &mut dyn Write) -> io::Result<()> {
    for row in mosaic.ids().chunks_exact(mosaic.size().0 as usize) {
        write!(out, "ids ")?;
        row.iter().try_for_each(|id| write!(out, "{id:02x}"))?;
        writeln!(out)?;
    }
    for (number, Tile { texels, repeat: [u, v] }) in mosaic.tiles().iter().enumerate() {
        let (width, height) = texels.size();
        writeln!(out, "tile {number} {width} {height} {} {}", Number(*u), Number(*v))?;
        write_texels(texels, out)?;
    }
    Ok(())
}

/// The last words of a picture's record.
pub(super) fn read_mosaic_size(words: &mut Words<'_>) -> Result<Option<MosaicSize>, ScreenFileError> {
    if words.peek().text != "mosaic" {
        return Ok(None);
    }
    words.word();
    let width = words.whole("numbers across", 1..=MOST_TEXELS)?;
    let word = words.word();
    let height = words.whole_of(word, "numbers up", 1..=MOST_TEXELS / width)?;
    if width * height * 2 > words.bytes_left() {
        return Err(words.error(word, "so many numbers as follow").with_help("was the file copied whole?"));
    }
    let tiles = words.whole("how many tiles there are", 1..=256)?;
    Ok(Some((width as u32, height as u32, tiles as usize)))
}

/// Reads what [`write_mosaic`] wrote.
pub(super) fn read_mosaic(
    words: &mut Words<'_>,
    (width, height, count): MosaicSize,
) -> Result<Arc<Mosaic>, ScreenFileError> {
    let mut ids = Vec::with_capacity(width as usize * height as usize);
    for _ in 0..height {
        words.record("ids")?;
        let word = words.peek();
        let digits = read_digits(words, 2 * width as usize, "2 a number")?;
        ids.extend(digits.chunks_exact(2).map(|digits| digits[0] << 4 | digits[1]));
        if ids.iter().any(|&id| usize::from(id) >= count) {
            return Err(words.error(word, format!("numbers of tiles, below {count}")));
        }
        words.end_of_record()?;
    }
    let tiles = (0..count).map(|number| read_tile(words, number)).collect::<Result<_, _>>()?;
    let word = words.peek();
    let mosaic = Mosaic::new((width, height), ids, FirstRow::AtV0, tiles);
    Ok(Arc::new(mosaic.ok_or_else(|| words.error(word, "a mosaic"))?))
}

fn read_tile(words: &mut Words<'_>, number: usize) -> Result<Tile, ScreenFileError> {
    words.record("tile")?;
    words.whole("the number of the tile", number as u64..=number as u64)?;
    let size = read_size(words)?;
    let repeat = [words.number("how often it repeats to the right")?, words.number("how often it repeats upward")?];
    words.end_of_record()?;
    Ok(Tile { texels: read_texels(words, size)?, repeat })
}
