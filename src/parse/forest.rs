//! Opens texts of areas.
//!
//! path -load-> Source -fcell-> Area

use super::{fcell, load};
use crate::diagnostic::Diagnostics;
use crate::forest::area::Area;
use std::path::Path;

/// Reads an area of forest from a `.fcell` file, plain or gzip; grids that it names are looked for beside it.
///
/// # Errors
/// The file cannot be read, or its text has mistakes.
pub fn load_area(path: &Path) -> Result<(Area, Diagnostics), Diagnostics> {
    fcell::read(&load::source(path)?, path.parent().unwrap_or(Path::new("")))
}
