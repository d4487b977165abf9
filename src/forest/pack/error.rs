//! Why a pack cannot be read or written, and what to do.

use crate::forest::area::CellIndex;
use crate::image::save::SaveError;
use std::path::PathBuf;

/// Why a pack cannot be read or written. The message says what, where, and what to do.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum PackError {
    /// The system cannot open or read the file.
    #[error("cannot read `{}`: {source}", path.display())]
    Read {
        /// The pack.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// It begins otherwise than packs do.
    #[error("`{}` is no pack: expected the bytes of `FPACK` at its start; make one with `farop convert AREA.fcell -o {}`", path.display(), path.display())]
    NotAPack {
        /// The file.
        path: PathBuf,
    },
    /// A later farop wrote it.
    #[error("`{}` is a pack of version {version}, and this farop reads version 1; pack the area again", path.display())]
    Version {
        /// The pack.
        path: PathBuf,
        /// What it says.
        version: u32,
    },
    /// Its head or index is wrong: no cell can be read.
    #[error("the head of `{}` is broken: {what}; copy the pack again, or pack the area again", path.display())]
    Broken {
        /// The pack.
        path: PathBuf,
        /// What is wrong.
        what: String,
    },
    /// One cell is wrong; the others can be read.
    #[error("cell {} {} of `{}` is broken: {what}; the other cells can be read, to mend this one pack the area again", index[0], index[1], path.display())]
    Cell {
        /// The pack.
        path: PathBuf,
        /// Which cell.
        index: CellIndex,
        /// What is wrong.
        what: String,
    },
    /// Something of the area that a pack cannot hold.
    #[error("cannot pack {}: {what}", index.map_or_else(|| "the area".to_string(), |[column, row]| format!("cell {column} {row}")))]
    Unpackable {
        /// Which cell; `None`: what belongs to no single one.
        index: Option<CellIndex>,
        /// What is wrong with it.
        what: String,
    },
    /// The file cannot be written.
    #[error(transparent)]
    Save(#[from] SaveError),
}
