//! Vector: reads files of points, lines and polygons into layers.
//!
//! GeoJSON, shapefile -VECTOR-> Layer -forest::map-> a map; forest import -> stands
//!
//! What a file says of its objects is kept as it says it. What is no shape (a ring that does not close, or crosses itself) is an error with
//! its place: half a lake would be drawn as something else.
//!
//! Space: the file's projection.

mod geojson;
mod rings;
#[cfg(feature = "gis")]
mod shapefile;
#[cfg(feature = "gis")]
mod zip;

pub(super) use rings::told;

use super::load::whole_source;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::forest::vector::Layer;
use std::collections::BTreeMap;
use std::path::Path;

/// A layer, and what is worth knowing about how it was read.
#[derive(Clone, Debug)]
pub struct Vectors {
    /// The objects.
    pub layer: Layer,
    /// How many shapes of each type there are, as the file calls it.
    pub kinds: BTreeMap<String, usize>,
    /// Notices: objects without a shape, attributes that are lists.
    pub notices: Diagnostics,
}

/// Reads a file of vectors: `.geojson` or `.json`, plain or with `.gz` behind; with the feature `gis` `.shp`, and `.zip` with one in it.
///
/// # Errors
/// The file cannot be read, its ending is not known, or what is in it is no layer; with line and column where there are any.
pub fn load_vectors(path: &Path) -> Result<Vectors, Diagnostics> {
    let name = path.to_string_lossy().to_lowercase();
    let plain = name.strip_suffix(".gz").unwrap_or(&name);
    if plain.ends_with(".geojson") || plain.ends_with(".json") {
        return geojson::read(&whole_source(path)?);
    }
    if name.ends_with(".shp") || name.ends_with(".zip") {
        return shapes(path);
    }
    let error = Diagnostic::error(format!("`{}` is no file of vectors that is known", path.display()));
    let help = "known are `.geojson` and `.json`, plain or with `.gz` behind, `.shp`, and `.zip` with a `.shp` in it";
    Err(Diagnostics::without_source(error.help(help)))
}

#[cfg(not(feature = "gis"))]
fn shapes(path: &Path) -> Result<Vectors, Diagnostics> {
    let error = Diagnostic::error(format!("`{}` is a shapefile, and this farop was built without GIS", path.display()));
    Err(Diagnostics::without_source(error.help("build it with `cargo build --release --features gis`")))
}

/// A shapefile, in an archive or beside its other files.
#[cfg(feature = "gis")]
fn shapes(path: &Path) -> Result<Vectors, Diagnostics> {
    let first = whole_source(path)?;
    let name = first.name.clone();
    let is_zip = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("zip"));
    if !is_zip {
        // What is beside it may be missing; what it means then, its reader says.
        let beside = |ending: &str| {
            std::fs::read(path.with_extension(ending))
                .or(std::fs::read(path.with_extension(ending.to_uppercase())))
                .ok()
        };
        return shapefile::read(&shapefile::Files { name, shp: first.text, dbf: beside("dbf"), prj: beside("prj") });
    }
    let refused = |what: String| Diagnostics::without_source(Diagnostic::error(format!("`{name}`: {what}")));
    let mut files = zip::files(&first.text, &[".shp", ".dbf", ".prj"]).map_err(refused)?;
    let mut take = |ending: &str| {
        let at = files.iter().position(|(file, _)| file.ends_with(ending))?;
        Some(files.swap_remove(at).1)
    };
    let Some(shp) = take(".shp") else { return Err(refused("there is no `.shp` in it".to_string())) };
    let (dbf, prj) = (take(".dbf"), take(".prj"));
    shapefile::read(&shapefile::Files { name, shp, dbf, prj })
}
