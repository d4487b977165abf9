//! Writes packs: cells come one by one and in any order, and lie in Morton order.
//!
//! cells -> WRITE (spool) -> index, cells in order -> `.fpack`
//!
//! Why twice to disk: the index stands before the cells and says where each lies, so all must be known first; 95,000 ha are 30 MB, and
//! only 28 bytes a cell are kept in memory.

use super::{ENTRY, MAGIC, MOST_CELL_BYTES, MOST_PLACES, PackError, START, cell, crc, head};
use crate::forest::area::{Cell, CellIndex, Head};
use crate::forest::cells::{Cells, bounds};
use crate::image::save::{SaveError, WholeFile};
use std::fs::File;
use std::io::{BufReader, BufWriter, Read, Seek, SeekFrom, Write, copy};
use std::path::Path;

/// What was written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PackCounts {
    /// Cells.
    pub cells: usize,
    /// Bytes of the whole file.
    pub bytes: u64,
    /// Bytes of the largest cell.
    pub largest: u32,
}

/// A cell that is on the spool.
struct Spooled {
    index: CellIndex,
    offset: u64,
    length: u32,
    crc: u32,
}

/// Packs `head` and `cells` into a file, which appears under its name only whole. The order of the cells does not matter.
///
/// # Errors
/// [`PackError`]: the file cannot be written, a cell comes twice or cannot be packed, or cells are too far apart for one index.
pub fn write(head: &Head, cells: impl IntoIterator<Item = Cell>, path: &Path) -> Result<PackCounts, PackError> {
    write_all(head, cells.into_iter().map(Ok), path)
}

/// As [`write`], for all cells of an area, in memory or packed: each is loaded when its turn comes.
///
/// # Errors
/// As [`write`], and when a cell cannot be loaded.
pub fn write_cells(cells: &Cells, path: &Path) -> Result<PackCounts, PackError> {
    let all = cells.indices().into_iter().filter_map(|index| cells.load(index).transpose());
    write_all(cells.head(), all, path)
}

fn write_all(
    head: &Head,
    cells: impl Iterator<Item = Result<Cell, PackError>>,
    path: &Path,
) -> Result<PackCounts, PackError> {
    let unpackable = |what: String| PackError::Unpackable { index: None, what };
    let head_bytes = head::encode(head).map_err(unpackable)?;
    // The target comes first: a folder that is not there is told before an hour of packing.
    let mut out = WholeFile::create(path)?;
    let failed = |source| PackError::Save(SaveError::at(path, source));
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut spool = BufWriter::new(tempfile::tempfile_in(folder).map_err(failed)?);
    let mut entries = spooled(head, cells, &mut spool, path)?;
    let mut spool = spool.into_inner().map_err(|error| failed(error.into_error()))?;

    let plan = Layout::new(&mut entries, head_bytes.len())?;
    let start = plan.start(&head_bytes)?;
    [&start, &head_bytes, &plan.index].into_iter().try_for_each(|bytes| out.write_all(bytes)).map_err(failed)?;
    copy_cells(&mut spool, &entries, &mut out).map_err(failed)?;
    out.commit()?;
    let largest = entries.iter().map(|entry| entry.length).max().unwrap_or_default();
    Ok(PackCounts { cells: entries.len(), bytes: plan.length, largest })
}

/// Where everything lies.
struct Layout {
    south_west: CellIndex,
    size: [u64; 2],
    index: Vec<u8>,
    /// Bytes of the whole file.
    length: u64,
}

impl Layout {
    /// Sorts `entries` as they will lie, and makes the index.
    fn new(entries: &mut [Spooled], head_length: usize) -> Result<Layout, PackError> {
        let [south_west, north_east] = bounds(entries.iter().map(|entry| entry.index)).unwrap_or([[0, 0], [-1, -1]]);
        let steps = |from: CellIndex, to: CellIndex| -> [u64; 2] {
            std::array::from_fn(|axis| (i64::from(to[axis]) - i64::from(from[axis])) as u64)
        };
        let size = std::array::from_fn(|axis| (i64::from(north_east[axis]) - i64::from(south_west[axis]) + 1) as u64);
        let [columns, rows] = size;
        if u128::from(columns) * u128::from(rows) > u128::from(MOST_PLACES) {
            let what = format!(
                "its cells are spread over {columns} x {rows} places, and an index has at most {MOST_PLACES}; make several packs"
            );
            return Err(PackError::Unpackable { index: None, what });
        }
        entries.sort_by_key(|entry| morton(steps(south_west, entry.index)));
        if let Some(pair) = entries.windows(2).find(|pair| pair[0].index == pair[1].index) {
            return Err(PackError::Unpackable { index: Some(pair[0].index), what: "it comes twice".to_string() });
        }
        let mut index = vec![0_u8; (columns * rows) as usize * ENTRY];
        let mut length = (START + head_length + index.len()) as u64;
        for entry in entries {
            let [column, row] = steps(south_west, entry.index);
            let at = (row * columns + column) as usize * ENTRY;
            index[at..at + 8].copy_from_slice(&length.to_le_bytes());
            index[at + 8..at + 12].copy_from_slice(&entry.length.to_le_bytes());
            index[at + 12..at + 16].copy_from_slice(&entry.crc.to_le_bytes());
            length += u64::from(entry.length);
        }
        Ok(Layout { south_west, size, index, length })
    }

    /// What stands before the head.
    fn start(&self, head: &[u8]) -> Result<Vec<u8>, PackError> {
        let length = u32::try_from(head.len());
        let length = length
            .map_err(|_| PackError::Unpackable { index: None, what: "its head is longer than 4 GiB".to_string() })?;
        let mut start = MAGIC.to_vec();
        [1, length, crc(head)].into_iter().for_each(|number| start.extend(number.to_le_bytes()));
        self.south_west.into_iter().for_each(|number| start.extend(number.to_le_bytes()));
        [self.size[0] as u32, self.size[1] as u32, 0].into_iter().for_each(|number| start.extend(number.to_le_bytes()));
        Ok(start)
    }
}

/// Writes all cells as they come, and remembers where.
fn spooled(
    head: &Head,
    cells: impl Iterator<Item = Result<Cell, PackError>>,
    spool: &mut BufWriter<File>,
    path: &Path,
) -> Result<Vec<Spooled>, PackError> {
    let (mut entries, mut offset) = (Vec::new(), 0);
    for cell in cells {
        let cell = cell?;
        let index = cell.index;
        let unpackable = |what: String| PackError::Unpackable { index: Some(index), what };
        let bytes = cell::encode(head, &cell).map_err(unpackable)?;
        let length = u32::try_from(bytes.len()).unwrap_or(u32::MAX);
        if length > MOST_CELL_BYTES {
            return Err(unpackable(format!(
                "it takes {} bytes, and a cell has at most {MOST_CELL_BYTES}",
                bytes.len()
            )));
        }
        spool.write_all(&bytes).map_err(|source| SaveError::at(path, source))?;
        entries.push(Spooled { index, offset, length, crc: crc(&bytes) });
        offset += u64::from(length);
    }
    Ok(entries)
}

fn copy_cells(spool: &mut File, entries: &[Spooled], out: &mut WholeFile) -> std::io::Result<()> {
    let mut reader = BufReader::new(spool);
    let mut at = 0;
    reader.rewind()?;
    for entry in entries {
        if entry.offset != at {
            reader.seek(SeekFrom::Start(entry.offset))?;
        }
        copy(&mut (&mut reader).take(u64::from(entry.length)), out)?;
        at = entry.offset + u64::from(entry.length);
    }
    Ok(())
}

/// The place on Morton's curve: bits of column and row in turn.
fn morton([column, row]: [u64; 2]) -> u64 {
    let spread = |number: u64| {
        let steps = [(16, 0x0000_FFFF_0000_FFFF), (8, 0x00FF_00FF_00FF_00FF), (4, 0x0F0F_0F0F_0F0F_0F0F)];
        let steps = steps.into_iter().chain([(2, 0x3333_3333_3333_3333), (1, 0x5555_5555_5555_5555)]);
        steps.fold(number & 0xFFFF_FFFF, |bits, (shift, mask)| (bits | bits << shift) & mask)
    };
    spread(column) | spread(row) << 1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn morton_order_keeps_squares_together() {
        let order = [[0, 0], [1, 0], [0, 1], [1, 1], [2, 0], [3, 0], [2, 1], [3, 1], [0, 2]];
        assert!(order.windows(2).all(|pair| morton(pair[0]) < morton(pair[1])));
        assert_eq!((morton([3, 5]), morton([u64::from(u32::MAX); 2])), (0b10_01_11, u64::MAX));
    }
}
