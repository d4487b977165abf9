//! DTED: Digital Terrain Elevation Data, levels 0, 1 and 2.
//!
//! Three headers (80, 648 and 2700 bytes), then one record a column from the west: 8 bytes of counts, the heights from the south, and a
//! checksum, the sum of all bytes before it. Heights are big-endian with a *sign bit*, not two's complement: 0x8001 is -1 m, and 0xFFFF
//! (-32767) is a void.
//!
//! Source: MIL-PRF-89020B, "Performance Specification: Digital Terrain Elevation Data", 2000.

use super::GridFile;
use crate::diagnostic::Diagnostics;
use crate::forest::elevation::{Frame, Grid, Unit};

/// Bytes before the first record.
const HEADERS: usize = 80 + 648 + 2700;
/// Bytes of a record besides its heights.
const RECORD_EXTRA: usize = 8 + 4;
/// The largest tile: level 2 has 3601 samples a side.
const MOST_SAMPLES: usize = 3601;

pub(super) fn read(file: &GridFile<'_>) -> Result<Grid, Diagnostics> {
    let bytes = file.bytes;
    if bytes.len() < HEADERS || !bytes.starts_with(b"UHL1") {
        return Err(file.refused(
            format!("`{}` does not begin as DTED does, with `UHL1` and {HEADERS} bytes of headers", file.name),
            "is it a DTED file, and whole?",
        ));
    }
    let header = Header::read(file)?;
    let record = header.rows * 2 + RECORD_EXTRA;
    let expected = HEADERS + header.columns * record;
    if bytes.len() != expected {
        let (columns, rows) = (header.columns, header.rows);
        return Err(file.refused(
            format!("`{}` has {} bytes; {columns} columns of {rows} heights take {expected}", file.name, bytes.len()),
            "is the file whole? Get it again",
        ));
    }
    let mut heights = vec![f32::NAN; header.columns * header.rows];
    for (column, record) in bytes[HEADERS..].chunks_exact(record).enumerate() {
        let (body, sum) = record.split_at(record.len() - 4);
        check(file, column, body, sum)?;
        for (from_south, pair) in body[8..].chunks_exact(2).enumerate() {
            heights[(header.rows - 1 - from_south) * header.columns + column] = height([pair[0], pair[1]]);
        }
    }
    file.grid((header.columns, header.rows), heights, header.frame())
}

/// Metres, from a sign and a magnitude.
fn height(pair: [u8; 2]) -> f32 {
    let word = u16::from_be_bytes(pair);
    let metres = f32::from(word & 0x7FFF);
    match (word, word >> 15) {
        (0xFFFF, _) => f32::NAN,
        (_, 0) => metres,
        // Not -0: there is only one level of the sea.
        _ => 0.0 - metres,
    }
}

/// Refuses a record that is damaged.
fn check(file: &GridFile<'_>, column: usize, body: &[u8], sum: &[u8]) -> Result<(), Diagnostics> {
    let counted: u32 = body.iter().map(|&byte| u32::from(byte)).sum();
    let written = u32::from_be_bytes([sum[0], sum[1], sum[2], sum[3]]);
    if body[0] == 0xAA && counted == written {
        return Ok(());
    }
    Err(file.refused(
        if body[0] == 0xAA {
            format!("`{}`, column {column}: its bytes add up to {counted}, its checksum says {written}", file.name)
        } else {
            format!("`{}`, column {column}: its record begins with {:#04x}, not with 0xaa", file.name, body[0])
        },
        "the file is damaged; get it again",
    ))
}

/// What the first header says.
struct Header {
    west: f64,
    south: f64,
    /// Degrees from column to column, and from row to row.
    step: [f64; 2],
    columns: usize,
    rows: usize,
}

impl Header {
    fn read(file: &GridFile<'_>) -> Result<Header, Diagnostics> {
        let text = |from: usize, to: usize| String::from_utf8_lossy(&file.bytes[from..to]).into_owned();
        let wrong = |what: &str, from: usize, to: usize| {
            let found = crate::diagnostic::printable(&file.bytes[from..to]);
            file.refused(
                format!("`{}`, bytes {from} to {}: expected {what}, found `{found}`", file.name, to - 1),
                "is it a DTED file, and whole?",
            )
        };
        let count = |from: usize, what: &str| {
            let number = text(from, from + 4).trim().parse::<usize>().ok();
            number.filter(|&number| (2..=MOST_SAMPLES).contains(&number)).ok_or_else(|| wrong(what, from, from + 4))
        };
        let step = |from: usize| {
            let tenths = text(from, from + 4).trim().parse::<u32>().ok().filter(|&tenths| tenths > 0);
            let tenths = tenths.ok_or_else(|| wrong("tenths of arc seconds, as in 0030", from, from + 4))?;
            Ok(f64::from(tenths) / 36_000.0)
        };
        let west = angle(&text(4, 12)).ok_or_else(|| wrong("a longitude, as in 1560000W", 4, 12))?;
        let south = angle(&text(12, 20)).ok_or_else(|| wrong("a latitude, as in 0190000N", 12, 20))?;
        let (columns, rows) = (count(47, "2 to 3601 columns")?, count(51, "2 to 3601 rows")?);
        Ok(Header { west, south, step: [step(20)?, step(24)?], columns, rows })
    }

    fn frame(&self) -> Frame {
        let north = self.south + self.step[1] * (self.rows - 1) as f64;
        Frame { unit: Unit::Degrees, west: self.west, north, step: self.step }
    }
}

/// Degrees of `DDDMMSSH`.
fn angle(text: &str) -> Option<f64> {
    let number = |from: usize, to: usize| text.get(from..to)?.parse::<u32>().ok().map(f64::from);
    let sign = match text.as_bytes().get(7)? {
        b'N' | b'E' => 1.0,
        b'S' | b'W' => -1.0,
        _ => return None,
    };
    let degrees = number(0, 3)? + number(3, 5)? / 60.0 + number(5, 7)? / 3600.0;
    (degrees <= 180.0).then_some(sign * degrees)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heights_have_a_sign_bit() {
        assert_eq!(height([0x00, 0x07]), 7.0);
        assert_eq!(height([0x80, 0x07]), -7.0);
        assert!(height([0x80, 0x00]).is_sign_positive());
        assert!(height([0xFF, 0xFF]).is_nan());
        assert_eq!(height([0xFF, 0xFE]), -32766.0);
    }

    #[test]
    fn angles() {
        assert_eq!(angle("1560000W"), Some(-156.0));
        assert_eq!(angle("0193000N"), Some(19.5));
        assert_eq!([angle(""), angle("1560000X"), angle("15é0000W"), angle("9990000E")], [None; 4]);
    }
}
