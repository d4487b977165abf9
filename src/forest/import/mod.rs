//! Import: polygons of stands, a table of what grows on them and measured heights, as an area.
//!
//! Layer (stands), records (inventory), Grid (relief) -IMPORT-> Area -pack, write::fcell-> `.fpack`, `.fcell`
//!
//! Cells are those of the rectangle around all polygons, and of a margin, wherever the relief has a height. Polygons are cut at their borders ([`cut`](fn@cut)), roads too;
//! heights are asked for at positions of the world, so neighbors share those on their border.
//!
//! Why an area and not a scene: what grows is said once a stand, by year, in an inventory's own words; trees grow out of it when somebody looks.
//!
//! Space: files lie in the projection that they say; the area is on a UTM map, its origin at whole cells of that map.
//! Cost: linear in corners, cells and samples; the area is held in memory, 1 kB a cell.

mod build;
mod cut;
mod kinds;
mod land_use;
mod owners;
mod record;
mod relief;
mod states;
mod summary;
mod survey;
mod ways;

pub use cut::{Tangled, cut, land};
pub use record::{Growth, Record, What};
pub use relief::Relief;
pub use summary::{StandLand, Summary};
pub use ways::stretches;

use super::area::Area;
use super::polygon::Point;
use super::vector::{Crs, Layer};
use crate::diagnostic::Diagnostic;
use std::collections::BTreeMap;

/// The most cells of an import: 14,400 square kilometres of 240 m.
pub const MOST_CELLS: usize = 250_000;

/// What is imported.
#[derive(Clone, Copy, Debug)]
pub struct Sources<'a> {
    /// Measured heights.
    pub relief: &'a Relief,
    /// Polygons of stands and grounds.
    pub stands: &'a Layer,
    /// Roads and rivers.
    pub lines: Option<&'a Layer>,
    /// Rows of the inventory.
    pub table: &'a [Record],
    /// What is planned, and goes before the inventory.
    pub plan: &'a [Record],
}

/// How it is imported.
#[derive(Clone, Debug, PartialEq)]
pub struct Choices {
    /// The map of the area, a UTM one; `None`: the zone of the middle of the stands.
    pub crs: Option<Crs>,
    /// Side of a cell in metres.
    pub side: f64,
    /// Samples of heights along the side of a cell, at least 2.
    pub samples: u16,
    /// Cells around the rectangle of the stands.
    pub margin: u32,
    /// Names of attributes, by what they are: `stand`, `class`, ...
    pub map: BTreeMap<String, String>,
    /// Polygons without a row get what is usual for their land use (OpenStreetMap's words).
    pub has_defaults: bool,
    /// Only what the stands are in this year.
    pub year: Option<i32>,
    /// The ground where no polygon is.
    pub ground: String,
    /// Every random number of the area begins here.
    pub seed: u64,
}

impl Default for Choices {
    fn default() -> Self {
        Choices {
            crs: None,
            side: 240.0,
            samples: 9,
            margin: 1,
            map: BTreeMap::new(),
            has_defaults: false,
            year: None,
            ground: "grass".to_string(),
            seed: 0,
        }
    }
}

/// An area, what is in it, and what is worth knowing about how it came to be.
#[derive(Clone, Debug)]
pub struct Imported {
    /// Cells, stands, heights.
    pub area: Area,
    /// Counts.
    pub summary: Summary,
    /// What was left out, and why.
    pub notices: Vec<Diagnostic>,
}

/// Makes an area of what is known about a forest.
///
/// # Errors
/// No polygon, polygons without projection, without a name for their stand, outside of the relief, with swapped axes or with outlines that cross; too many cells. Up to 20 are told,
/// each with file, line and number of the feature.
pub fn import(sources: &Sources<'_>, choices: &Choices) -> Result<Imported, Vec<Diagnostic>> {
    build::Builder::new(*sources, choices)?.run()
}

/// The world of an area: what its positions mean.
#[derive(Clone, Copy, Debug)]
struct World {
    crs: Crs,
    /// South-west corner of cell 0 0.
    origin: Point,
    side: f64,
}
