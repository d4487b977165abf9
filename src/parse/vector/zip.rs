//! Zip: the files of an archive, as shapefiles are passed around.
//!
//! bytes -ZIP-> named files
//!
//! Why own: of the format only the directory at the end and two ways of packing (none, deflate) are needed, and `flate2` is here already.
//!
//! Source: PKWARE, "APPNOTE.TXT - .ZIP File Format Specification" 6.3. Cost: what is unpacked.

use flate2::read::DeflateDecoder;
use std::io::Read;

/// The most bytes that a file may unpack to.
const MOST_BYTES: u64 = 1 << 30;

/// The files whose names end in one of `endings`, small letters.
pub(super) fn files(bytes: &[u8], endings: &[&str]) -> Result<Vec<(String, Vec<u8>)>, String> {
    let at = |at: usize, count: usize| bytes.get(at..at.checked_add(count)?);
    let u16_at = |place: usize| at(place, 2).map(|b| usize::from(u16::from_le_bytes([b[0], b[1]])));
    let u32_at = |place: usize| at(place, 4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]]) as usize);
    let truncated = || "it ends too early: was it copied whole?".to_string();
    // The directory's place stands near the end, behind a comment of unknown length.
    let from = bytes.len().saturating_sub(65_557);
    let end =
        (from..bytes.len()).rev().find(|&place| bytes[place..].starts_with(b"PK\x05\x06")).ok_or_else(truncated)?;
    let (count, mut entry) = (u16_at(end + 10).ok_or_else(truncated)?, u32_at(end + 16).ok_or_else(truncated)?);
    let mut files = Vec::new();
    for _ in 0..count {
        if at(entry, 4) != Some(b"PK\x01\x02") {
            return Err("its directory is damaged".to_string());
        }
        let numbers = [
            u16_at(entry + 10),
            u32_at(entry + 20),
            u16_at(entry + 28),
            u16_at(entry + 30),
            u16_at(entry + 32),
            u32_at(entry + 42),
        ];
        let [Some(method), Some(packed), Some(name), Some(extra), Some(comment), Some(local)] = numbers else {
            return Err(truncated());
        };
        let name_bytes = at(entry + 46, name).ok_or_else(truncated)?;
        let file = String::from_utf8_lossy(name_bytes).to_lowercase();
        entry += 46 + name + extra + comment;
        if !endings.iter().any(|ending| file.ends_with(ending)) {
            continue;
        }
        let (Some(local_name), Some(local_extra)) = (u16_at(local + 26), u16_at(local + 28)) else {
            return Err(truncated());
        };
        let data = at(local + 30 + local_name + local_extra, packed).ok_or_else(truncated)?;
        let mut unpacked = Vec::new();
        match method {
            0 => unpacked.extend_from_slice(data),
            8 => {
                let read = DeflateDecoder::new(data).take(MOST_BYTES).read_to_end(&mut unpacked);
                read.map_err(|error| format!("`{file}` in it cannot be unpacked: {error}"))?;
            }
            _ => return Err(format!("`{file}` in it is packed in a way (number {method}) that is not known")),
        }
        files.push((file, unpacked));
    }
    Ok(files)
}
