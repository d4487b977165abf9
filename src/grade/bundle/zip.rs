//! Zip: files in one file, with the permissions that a script needs.
//!
//! Why our own: two records a file and one at the end, and the same files give the same bytes, on every day and every machine.
//! Times are the first that the format knows. No file of four gigabytes, no encryption, no spanning.
//!
//! Source: PKWARE, "APPNOTE.TXT, .ZIP File Format Specification", 6.3.10, 2022, sections 4.3.7, 4.3.12, 4.3.16 and 4.4.

use flate2::{Compression, Crc, write::DeflateEncoder};
use std::io::{self, Write};

/// A file to pack.
pub struct Packed {
    /// Its name, folders with `/`.
    pub name: String,
    /// Whether it is a program.
    pub is_program: bool,
    /// What is in it.
    pub bytes: Vec<u8>,
}

/// Deflated; made by a Unix, so that permissions are read.
const DEFLATED: u16 = 8;
const VERSION: u16 = 20;
const MADE_BY_UNIX: u16 = 3 << 8 | VERSION;
/// Names are UTF-8.
const UTF_8: u16 = 1 << 11;
/// The first of January 1980, midnight.
const DATE: u16 = 1 << 5 | 1;

/// The files as the bytes of a zip.
///
/// # Errors
/// When a file is too large for the format, or there are more than it can count.
pub fn zip(files: &[Packed]) -> io::Result<Vec<u8>> {
    let (mut out, mut directory) = (Vec::new(), Vec::new());
    for file in files {
        let mut crc = Crc::new();
        crc.update(&file.bytes);
        let mut encoder = DeflateEncoder::new(Vec::new(), Compression::default());
        encoder.write_all(&file.bytes)?;
        let packed = encoder.finish()?;
        let (start, size, whole) = (number(out.len())?, number(packed.len())?, number(file.bytes.len())?);
        let name_length = u16::try_from(file.name.len()).map_err(io::Error::other)?;
        // What both records say of a file.
        let mut about = Vec::new();
        [VERSION, UTF_8, DEFLATED, 0, DATE].iter().for_each(|half| about.extend(half.to_le_bytes()));
        [crc.sum(), size, whole].iter().for_each(|word| about.extend(word.to_le_bytes()));
        about.extend(name_length.to_le_bytes());

        out.extend(b"PK\x03\x04");
        out.extend(&about);
        out.extend(0_u16.to_le_bytes());
        out.extend(file.name.as_bytes());
        out.extend(packed);

        directory.extend(b"PK\x01\x02");
        directory.extend(MADE_BY_UNIX.to_le_bytes());
        directory.extend(&about);
        // No extra field, no comment, first disk, no internal attributes.
        directory.extend([0; 8]);
        let mode: u32 = if file.is_program { 0o100_755 } else { 0o100_644 };
        directory.extend((mode << 16).to_le_bytes());
        directory.extend(start.to_le_bytes());
        directory.extend(file.name.as_bytes());
    }
    let count = u16::try_from(files.len()).map_err(io::Error::other)?;
    let (start, size) = (number(out.len())?, number(directory.len())?);
    out.extend(directory);
    out.extend(b"PK\x05\x06\0\0\0\0");
    [count, count].iter().for_each(|half| out.extend(half.to_le_bytes()));
    [size, start].iter().for_each(|word| out.extend(word.to_le_bytes()));
    out.extend([0; 2]);
    Ok(out)
}

fn number(length: usize) -> io::Result<u32> {
    u32::try_from(length).map_err(|_| io::Error::other("more than four gigabytes do not fit into a zip"))
}
