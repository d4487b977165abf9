//! Vector: reads files of points, lines and polygons into layers.
//!
//! GeoJSON -VECTOR-> Layer -forest::map-> a map; forest import -> stands
//!
//! What a file says of its objects is kept as it says it. What is no shape (a ring that does not close, or crosses itself) is an error with
//! its place: half a lake would be drawn as something else.
//!
//! Space: the file's projection.

mod geojson;
mod rings;

pub(super) use rings::told;

use super::load::whole_source;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::forest::vector::Layer;
use std::path::Path;

/// A layer, and what is worth knowing about how it was read.
#[derive(Clone, Debug)]
pub struct Vectors {
    /// The objects.
    pub layer: Layer,
    /// Notices: objects without a shape, attributes that are lists.
    pub notices: Diagnostics,
}

/// Reads a file of vectors: `.geojson` or `.json`, plain or with `.gz` behind.
///
/// # Errors
/// The file cannot be read, its ending is not known, or what is in it is no layer; with line and column where there are any.
pub fn load_vectors(path: &Path) -> Result<Vectors, Diagnostics> {
    let name = path.to_string_lossy().to_lowercase();
    let plain = name.strip_suffix(".gz").unwrap_or(&name);
    if plain.ends_with(".geojson") || plain.ends_with(".json") {
        return geojson::read(&whole_source(path)?);
    }
    let error = Diagnostic::error(format!("`{}` is no file of vectors that is known", path.display()));
    Err(Diagnostics::without_source(error.help("known are `.geojson` and `.json`, plain or with `.gz` behind")))
}
