//! Why an area makes no scene tree, and what to do.

use super::{MOST_CELLS, MOST_TREES};
use crate::forest::objects::ObjectError;
use crate::forest::pack::PackError;

/// Why an area makes no scene tree. The message says what, and what to do.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum TreeError {
    /// More trees than a scene tree holds.
    #[error(
        "the area has about {trees:.0} trees, and a scene has at most {MOST_TREES} as objects; walk through it with `farop forest`, which draws what is near"
    )]
    TooManyTrees {
        /// As many as the stands say; counting ended when there were too many.
        trees: f64,
    },
    /// More cells than a scene tree holds.
    #[error(
        "the area has {cells} cells, and a scene has at most {MOST_CELLS}; walk through it with `farop forest`, which draws what is near"
    )]
    TooManyCells {
        /// All of them.
        cells: usize,
    },
    /// A picture cannot be used.
    #[error(
        "no picture `{name}`: {what}; pictures are looked for in the folder of the area, and `paint:NAME` needs no file"
    )]
    Picture {
        /// As the area calls it.
        name: String,
        /// Why.
        what: String,
    },
    /// Trees cannot be placed.
    #[error("{0}")]
    Growth(String),
    /// An object cannot stand.
    #[error(transparent)]
    Object(#[from] ObjectError),
    /// A cell cannot be read.
    #[error(transparent)]
    Pack(#[from] PackError),
}
