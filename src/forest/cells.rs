//! Cells: where the cells of an area come from, one at a time.
//!
//! `.fcell` -parse-> Area, or `.fpack` -Pack-> CELLS -> window, scene
//!
//! Why one door for both: who draws a forest asks for cells by column and row, and need not know whether they are in memory or on disk.

use super::area::{Area, Cell, CellIndex, Head};
use super::pack::{Pack, PackError};

/// An area, in memory or on disk.
#[derive(Debug)]
pub enum Cells {
    /// All of it is in memory.
    Loaded(Area),
    /// Each cell is read when it is asked for.
    Packed(Pack),
}

impl Cells {
    /// What belongs to no single cell.
    #[must_use]
    pub fn head(&self) -> &Head {
        match self {
            Cells::Loaded(area) => &area.head,
            Cells::Packed(pack) => pack.head(),
        }
    }

    /// Columns and rows of the cells there are, by column, then row.
    #[must_use]
    pub fn indices(&self) -> Vec<CellIndex> {
        match self {
            Cells::Loaded(area) => area.cells.keys().copied().collect(),
            Cells::Packed(pack) => pack.indices(),
        }
    }

    /// The south-west and the north-east cell of the rectangle around all cells; `None` where there is none.
    #[must_use]
    pub fn bounds(&self) -> Option<[CellIndex; 2]> {
        match self {
            Cells::Loaded(area) => bounds(area.cells.keys().copied()),
            Cells::Packed(pack) => pack.bounds(),
        }
    }

    /// Whether there is such a cell. Cheap: it is not read.
    #[must_use]
    pub fn contains(&self, index: CellIndex) -> bool {
        match self {
            Cells::Loaded(area) => area.cells.contains_key(&index),
            Cells::Packed(pack) => pack.contains(index),
        }
    }

    /// The cell there; `None` where there is none.
    ///
    /// # Errors
    /// The pack cannot be read, or the bytes of this cell are broken; the other cells can still be loaded.
    pub fn load(&self, index: CellIndex) -> Result<Option<Cell>, PackError> {
        match self {
            Cells::Loaded(area) => Ok(area.cells.get(&index).cloned()),
            Cells::Packed(pack) => pack.load(index),
        }
    }
}

/// The corners of the rectangle around `indices`.
pub(super) fn bounds(indices: impl Iterator<Item = CellIndex>) -> Option<[CellIndex; 2]> {
    indices.fold(None, |bounds, [column, row]| {
        let [[west, south], [east, north]] = bounds.unwrap_or([[column, row]; 2]);
        Some([[west.min(column), south.min(row)], [east.max(column), north.max(row)]])
    })
}
