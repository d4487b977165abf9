//! Pack: an area on disk, for walking through: any cell by one read.
//!
//! cells -WRITE-> `.fpack` -OPEN-> [`Pack`] -load(column, row)-> Cell
//!
//! ```text
//! 0   magic  FPACK CR LF SUB      8 bytes: a copy that changed line ends is noticed
//! 8   version 1                   u32
//! 12  length of the head, its CRC 2 x u32
//! 20  west column, south row      2 x i32
//! 28  columns, rows               2 x u32
//! 36  0                           u32
//! 40  head                        chunks (`head`)
//!     index                       columns x rows times { offset u64, length u32, CRC u32 }, row after row from the south; length 0: no cell
//!     cells                       chunks (`cell`), in Morton order
//! ```
//!
//! A chunk is { tag: 4 bytes, length u32, contents }. A reader skips tags it does not know, so packs can grow.
//!
//! Why Morton order: what is near in both directions is near in the file, and a window of cells is a few stretches of it.
//! Why no checksum over all of it: a broken byte loses its cell and no other.
//! Why `read_at` and no memory map: it is safe, threads can share it, and a file that changes below a map ends the program.
//!
//! Little endian. Source: G. Morton, "A computer oriented geodetic data base", IBM Ottawa, 1966.
//! Cost: 16 bytes a place in memory; a cell of 9 x 9 heights takes about 0.5 to 2 kB of disk.

mod bytes;
mod cell;
mod check;
mod error;
mod head;
mod stand;
mod write;

pub use error::PackError;
pub use write::{PackCounts, write, write_cells};

use super::area::{Cell, CellIndex, Head};
use flate2::Crc;
use std::fs::File;
use std::path::{Path, PathBuf};

/// How every pack begins.
pub const MAGIC: &[u8; 8] = b"FPACK\r\n\x1A";
/// Bytes before the head.
const START: usize = 40;
/// Bytes of an entry of the index.
const ENTRY: usize = 16;
/// The most places of an index: 24 million hectares of cells of 240 m.
const MOST_PLACES: u64 = 1 << 22;
/// The most bytes of a cell.
const MOST_CELL_BYTES: u32 = 1 << 26;

/// An area on disk; cells are read when they are asked for, by any number of threads.
#[derive(Debug)]
pub struct Pack {
    path: PathBuf,
    file: At,
    length: u64,
    head: Head,
    south_west: CellIndex,
    size: [u32; 2],
    /// Entry after entry, as in the file.
    index: Vec<u8>,
}

impl Pack {
    /// Opens a pack: reads its head and its index, and no cell.
    ///
    /// # Errors
    /// [`PackError`]: the file cannot be read, is no pack, or its head is broken.
    pub fn open(path: &Path) -> Result<Pack, PackError> {
        let failed = |source| PackError::Read { path: path.to_path_buf(), source };
        let broken = |what: String| PackError::Broken { path: path.to_path_buf(), what };
        let file = File::open(path).map_err(failed)?;
        let length = file.metadata().map_err(failed)?.len();
        let file = At::new(file);
        let mut start = [0; START];
        let there = START.min(usize::try_from(length).unwrap_or(START));
        file.read(&mut start[..there], 0).map_err(failed)?;
        if !start.starts_with(MAGIC) {
            return Err(PackError::NotAPack { path: path.to_path_buf() });
        }
        if there < START {
            return Err(broken(format!("it is cut off after {there} bytes")));
        }
        let fixed = Fixed::read(&start).map_err(broken)?;
        if fixed.version != 1 {
            return Err(PackError::Version { path: path.to_path_buf(), version: fixed.version });
        }
        let [head_length, index_length] = fixed.lengths(length).map_err(broken)?;

        // Both lengths are within the file: this asks for no more memory than there are bytes.
        let mut bytes = vec![0; head_length];
        file.read(&mut bytes, START as u64).map_err(failed)?;
        if crc(&bytes) != fixed.head_crc {
            return Err(broken("its checksum is another".to_string()));
        }
        let head = head::decode(&bytes).map_err(broken)?;
        let mut index = vec![0; index_length];
        file.read(&mut index, (START + head_length) as u64).map_err(failed)?;
        Ok(Pack { path: path.to_path_buf(), file, length, head, south_west: fixed.south_west, size: fixed.size, index })
    }

    /// What belongs to no single cell.
    #[must_use]
    pub fn head(&self) -> &Head {
        &self.head
    }

    /// Columns and rows of the cells there are, by column, then row.
    #[must_use]
    pub fn indices(&self) -> Vec<CellIndex> {
        let [columns, rows] = self.size;
        let all = (0..columns).flat_map(|column| (0..rows).map(move |row| [column, row]));
        all.filter(|&place| self.entry(place).1 > 0).map(|place| self.index_of(place)).collect()
    }

    /// The south-west and the north-east corner of the rectangle of the index; `None` where there are no cells.
    #[must_use]
    pub fn bounds(&self) -> Option<[CellIndex; 2]> {
        let [columns, rows] = self.size;
        (columns > 0 && rows > 0).then(|| [self.south_west, self.index_of([columns - 1, rows - 1])])
    }

    /// Whether there is such a cell.
    #[must_use]
    pub fn contains(&self, index: CellIndex) -> bool {
        self.place_of(index).is_some_and(|place| self.entry(place).1 > 0)
    }

    /// The cell there; `None` where there is none.
    ///
    /// # Errors
    /// [`PackError`]: the file cannot be read, or the bytes of this cell are broken; the others can still be read.
    pub fn load(&self, index: CellIndex) -> Result<Option<Cell>, PackError> {
        let broken = |what: String| PackError::Cell { path: self.path.clone(), index, what };
        let Some(place) = self.place_of(index) else { return Ok(None) };
        let (offset, length, expected) = self.entry(place);
        if length == 0 {
            return Ok(None);
        }
        let is_inside = offset.checked_add(u64::from(length)).is_some_and(|end| end <= self.length);
        if !is_inside || length > MOST_CELL_BYTES {
            let file = self.length;
            return Err(broken(format!(
                "its {length} bytes from {offset} on are not all in the {file} bytes of the pack"
            )));
        }
        let mut bytes = vec![0; length as usize];
        let read = self.file.read(&mut bytes, offset);
        read.map_err(|source| PackError::Read { path: self.path.clone(), source })?;
        if crc(&bytes) != expected {
            return Err(broken("its checksum is another".to_string()));
        }
        let cell = cell::decode(&self.head, &bytes).map_err(broken)?;
        if cell.index != index {
            return Err(broken(format!("what lies there is cell {} {}", cell.index[0], cell.index[1])));
        }
        Ok(Some(cell))
    }

    /// How many bytes the cell takes on disk; 0 where there is none.
    #[must_use]
    pub fn bytes_of(&self, index: CellIndex) -> u32 {
        self.place_of(index).map_or(0, |place| self.entry(place).1)
    }

    /// Column and row within the index.
    fn place_of(&self, index: CellIndex) -> Option<[u32; 2]> {
        let within = |axis: usize| {
            let steps = i64::from(index[axis]) - i64::from(self.south_west[axis]);
            u32::try_from(steps).ok().filter(|&steps| steps < self.size[axis])
        };
        Some([within(0)?, within(1)?])
    }

    fn index_of(&self, place: [u32; 2]) -> CellIndex {
        std::array::from_fn(|axis| self.south_west[axis].wrapping_add_unsigned(place[axis]))
    }

    /// Offset, length and checksum of a cell.
    fn entry(&self, [column, row]: [u32; 2]) -> (u64, u32, u32) {
        let at = (row as usize * self.size[0] as usize + column as usize) * ENTRY;
        let mut reader = bytes::Reader::new(&self.index[at..at + ENTRY], "index");
        let entry = (|| Ok::<_, String>((reader.u64()?, reader.u32()?, reader.u32()?)))();
        entry.unwrap_or_default()
    }
}

/// What stands before the head.
struct Fixed {
    version: u32,
    head_length: u32,
    head_crc: u32,
    south_west: CellIndex,
    size: [u32; 2],
}

impl Fixed {
    fn read(start: &[u8]) -> Result<Fixed, String> {
        let mut reader = bytes::Reader::new(&start[MAGIC.len()..], "first bytes");
        Ok(Fixed {
            version: reader.u32()?,
            head_length: reader.u32()?,
            head_crc: reader.u32()?,
            south_west: [reader.i32()?, reader.i32()?],
            size: [reader.u32()?, reader.u32()?],
        })
    }

    /// Bytes of head and index, both within a file of `length` bytes.
    fn lengths(&self, length: u64) -> Result<[usize; 2], String> {
        let places = u64::from(self.size[0]) * u64::from(self.size[1]);
        let fits =
            |axis: usize| i64::from(self.south_west[axis]) + i64::from(self.size[axis]) <= i64::from(i32::MAX) + 1;
        if places > MOST_PLACES || !fits(0) || !fits(1) {
            let [columns, rows] = self.size;
            return Err(format!("it claims {columns} x {rows} cells, and at most {MOST_PLACES} can be"));
        }
        let (head, index) = (u64::from(self.head_length), places * ENTRY as u64);
        let expected = START as u64 + head + index;
        if expected > length {
            return Err(format!("it is cut off: head and index end at byte {expected}, the file at {length}"));
        }
        Ok([head as usize, index as usize])
    }
}

/// The checksum of gzip and PNG.
fn crc(bytes: &[u8]) -> u32 {
    let mut crc = Crc::new();
    crc.update(bytes);
    crc.sum()
}

/// A file that is read at any place, by several threads.
#[derive(Debug)]
struct At {
    #[cfg(unix)]
    file: File,
    #[cfg(not(unix))]
    file: std::sync::Mutex<File>,
}

#[cfg(unix)]
impl At {
    fn new(file: File) -> At {
        At { file }
    }

    fn read(&self, bytes: &mut [u8], offset: u64) -> std::io::Result<()> {
        std::os::unix::fs::FileExt::read_exact_at(&self.file, bytes, offset)
    }
}

#[cfg(not(unix))]
impl At {
    fn new(file: File) -> At {
        At { file: std::sync::Mutex::new(file) }
    }

    /// One reader at a time: the place in the file is shared.
    fn read(&self, bytes: &mut [u8], offset: u64) -> std::io::Result<()> {
        use std::io::{Read, Seek, SeekFrom};
        let mut file = self.file.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        file.seek(SeekFrom::Start(offset))?;
        file.read_exact(bytes)
    }
}
