//! What can be wrong with a screen file, and with the wish to write one.
//!
//! Why a place and not only a message: these files are long and are edited by hand and by programs in other languages;
//! "line 4711, column 9" is half of the repair.

use std::io;
use std::ops::Range;

/// A mistake in a screen file: where, what should stand there, what stands there.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("line {line}, column {column}: expected {expected}, found {found}")]
pub struct ScreenFileError {
    /// From 1.
    pub line: usize,
    /// In characters, from 1.
    pub column: usize,
    /// The same place as a range of bytes in the text; empty where something is missing.
    pub span: Range<usize>,
    /// What the format wants here.
    pub expected: String,
    /// The word that stands there, in backquotes; or `the end of the line`, `the end of the file`.
    pub found: String,
    /// How to repair it, where that can be said.
    pub help: Option<String>,
}

/// Why a screen file cannot be written.
#[derive(Debug, thiserror::Error)]
pub enum ScreenWriteError {
    /// The disk is full, the pipe is closed, ...
    #[error(transparent)]
    Io(#[from] io::Error),
    /// Normals were asked for and the list carries colors, or nothing.
    #[error(
        "the list carries no normals to write: it was made with colors at its vertices; make it with Phong shading"
    )]
    NoNormals,
    /// Colors were asked for and the list carries nothing (wire).
    #[error("the list carries no colors to write: wire has only edges; make it with another shading")]
    NoColors,
    /// Nothing is snapped.
    #[error(
        "a screen file needs a grid: with --subpixel-bits exact corners lie on none, and outside the picture; choose 0 to 16"
    )]
    Unsnapped,
    /// Distances in scene units leave the range of the numbers.
    #[error(
        "the scene is so small or large that 1/w in its units is no number: scale the scene, or give a larger --hither"
    )]
    OutOfRange,
    /// Texture coordinates were asked for.
    #[error("the list carries no texture coordinates to write")]
    NoTexture,
    /// A map lies on the ground.
    #[error("a map lies on the ground, which no screen file can tell: leave out --map")]
    Map,
    /// A resolution of the classic file is 0 or above 2^31.
    #[error("{what} is {value}: it must be a whole number from 1 to 2147483648")]
    Resolution {
        /// `z-resolution` or `color-resolution`.
        what: &'static str,
        /// What was asked for.
        value: u32,
    },
    /// The far plane of the classic file is not behind the near one.
    #[error("yon is {yon}: it must be a finite distance beyond hither, {hither}")]
    Yon {
        /// What was asked for.
        yon: f64,
        /// The list's near plane.
        hither: f64,
    },
}
