//! `demref`: heights of a cell taken out of a grid of measured heights.
//!
//! grid file -parse::grids-> Grid -REFERENCE-> lattice of the cell, by position
//!
//! Where the grid counts metres, they are those of the area's projection; where it counts degrees, the area's projection must be a UTM
//! one on WGS 84 (EPSG:326zz or 327zz), and each sample of the cell asks the grid at its longitude and latitude. A picture (`.png`) says
//! nothing about where it lies: its borders are laid on those of the cell.
//!
//! Samples on a common border of two cells lie at the same place and have the same height to the last bit (`forest::lattice`).

use super::Reader;
use super::ground::HIGHEST;
use crate::diagnostic::{Diagnostic, Span};
use crate::forest::area::CellIndex;
use crate::forest::elevation::{Grid, Unit, Utm, from_utm};
use crate::forest::lattice::lattice;
use crate::parse::grids::{GridOptions, load_grid};
use crate::parse::statements::did_you_mean;
use crate::parse::wording::quote;
use std::collections::BTreeMap;
use std::path::Path;
use std::rc::Rc;

/// Columns and rows of a cell where the file does not say: every 30 m in a cell of 240.
const USUAL_SIZE: [u16; 2] = [9, 9];

/// Grids that were read, by name and by what black and white mean.
pub(super) struct Grids<'a> {
    folder: &'a Path,
    known: BTreeMap<(String, [u64; 2]), Rc<Grid>>,
}

impl<'a> Grids<'a> {
    pub fn new(folder: &'a Path) -> Grids<'a> {
        Grids { folder, known: BTreeMap::new() }
    }

    fn grid(&mut self, name: &str, heights: (f64, f64)) -> Result<Rc<Grid>, String> {
        let key = (name.to_string(), [heights.0.to_bits(), heights.1.to_bits()]);
        if let Some(grid) = self.known.get(&key) {
            return Ok(grid.clone());
        }
        let options = GridOptions { heights, unit: None, ..GridOptions::default() };
        let read = load_grid(&self.folder.join(name), &options);
        let grid = Rc::new(read.map_err(|errors| {
            let first = errors.list.first();
            first.map_or_else(String::new, |error| match &error.help {
                Some(help) => format!("{}; {help}", error.message),
                None => error.message.clone(),
            })
        })?);
        self.known.insert(key, grid.clone());
        Ok(grid)
    }
}

/// Where the grid is asked for a sample of the cell.
enum Map {
    /// Its borders are those of the cell.
    Stretched,
    /// It counts in the metres of the area.
    Metres,
    /// It counts in degrees.
    Degrees { zone: u32, south: bool },
}

impl Reader<'_> {
    /// `demref FILE [lattice COLUMNS ROWS] [black METRES white METRES]`
    pub(super) fn demref(&mut self) -> Result<(), Diagnostic> {
        self.begin_ground(false)?;
        let (name, span) = self.words.text("a file of heights")?;
        let (mut size, mut heights) = (USUAL_SIZE, (0.0, 255.0));
        loop {
            if self.words.take_field("lattice") {
                size = self.lattice_size()?;
            } else if self.words.take_field("black") {
                heights.0 = self.words.within("the height of black", -HIGHEST..=HIGHEST)?;
            } else if self.words.take_field("white") {
                heights.1 = self.words.within("the height of white", -HIGHEST..=HIGHEST)?;
            } else {
                break;
            }
        }
        let read = self.grids.grid(&name, heights);
        let grid = read.map_err(|what| {
            let error = Diagnostic::error(format!("no heights from {}: {what}", quote(name.as_bytes())));
            error
                .at(span, "named here")
                .help("`.hgt`, `.asc`, `.dt0` to `.dt2` and gray `.png` are read, from the folder of the area")
        })?;
        let map = self.map(&name, &grid, span)?;
        let index = self.opened()?.cell.index;
        let found = self.samples(&grid, &map, index, size);
        if found.iter().all(|height| height.is_nan()) && !self.is_lost {
            let [column, row] = index;
            let message = format!("{} has no height in cell {column} {row}", quote(name.as_bytes()));
            let borders = grid.borders().map(|border| format!("{border:.4}")).join(" ");
            let error = Diagnostic::error(message).at(span, format!("it reaches from west south {borders} east north"));
            return Err(error.help("is `origin` the south-west corner of cell 0 0 in that projection?"));
        }
        self.opened()?.cell.ground = lattice(size, &found);
        Ok(())
    }

    /// How positions of the area become those of the grid.
    fn map(&self, name: &str, grid: &Grid, span: Span) -> Result<Map, Diagnostic> {
        let lower = name.to_lowercase();
        if lower.ends_with(".png") || lower.ends_with(".png.gz") {
            return Ok(Map::Stretched);
        }
        if grid.frame.unit == Unit::Metres {
            return Ok(Map::Metres);
        }
        utm_zone(&self.head.crs).ok_or_else(|| {
            let crs = &self.head.crs;
            let message =
                if crs.is_empty() { "an area without `crs`".to_string() } else { format!("`crs {crs}` is no UTM") };
            let error = Diagnostic::error(format!("{message}, and {} counts degrees", quote(name.as_bytes())));
            let error = error.at(span, "where would it lie?");
            match crs.is_empty() {
                true => error.help("write `crs EPSG:326zz` (north) or `EPSG:327zz` (south), zz the zone from 01 to 60"),
                false => {
                    error.help(did_you_mean(crs.as_bytes(), &["EPSG:32601 to EPSG:32660", "EPSG:32701 to EPSG:32760"]))
                }
            }
        })
    }

    /// Heights of the cell's lattice; not a number where the grid has none.
    fn samples(&self, grid: &Grid, map: &Map, index: CellIndex, size: [u16; 2]) -> Vec<f64> {
        let [columns, rows] = size.map(usize::from);
        let part = |at: usize, count: usize| at as f64 / (count - 1) as f64;
        let sample = |row: usize, column: usize| {
            let (u, v) = (part(column, columns), part(row, rows));
            // Of a border, both cells compute the same position.
            let along = |at: f64, axis: usize| (f64::from(index[axis]) + at) * self.head.side;
            let [east, north] = [along(u, 0) + self.head.origin[0], along(1.0 - v, 1) + self.head.origin[1]];
            let (x, y) = match *map {
                Map::Stretched => (u * (grid.columns() - 1) as f64, v * (grid.rows() - 1) as f64),
                Map::Metres => grid.place(east, north),
                Map::Degrees { zone, south } => {
                    let (longitude, latitude) = from_utm(&Utm { zone, south, east, north });
                    grid.place(longitude, latitude)
                }
            };
            grid.sample(x, y).unwrap_or(f64::NAN)
        };
        (0..rows)
            .flat_map(|row| (0..columns).map(move |column| (row, column)))
            .map(|(row, column)| sample(row, column))
            .collect()
    }
}

/// The zone of a UTM projection on WGS 84, from its EPSG number.
fn utm_zone(crs: &str) -> Option<Map> {
    let number: u32 = crs.to_ascii_uppercase().strip_prefix("EPSG:")?.parse().ok()?;
    let (zone, south) = (number % 100, number / 100 == 327);
    (matches!(number / 100, 326 | 327) && (1..=60).contains(&zone)).then_some(Map::Degrees { zone, south })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zones_are_read_out_of_numbers() {
        let zone = |crs: &str| {
            utm_zone(crs).map(|map| if let Map::Degrees { zone, south } = map { (zone, south) } else { (0, false) })
        };
        assert_eq!(zone("EPSG:32629"), Some((29, false)));
        assert_eq!(zone("epsg:32760"), Some((60, true)));
        for crs in ["", "EPSG:3763", "EPSG:32600", "EPSG:32661", "UTM 29"] {
            assert_eq!(zone(crs), None, "{crs}");
        }
    }
}
