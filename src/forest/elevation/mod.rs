//! Elevation: a rectangle of measured heights, and where on the Earth it lies.
//!
//! grid file -parse::grids-> GRID -merge, fill-> Grid -> relief
//!
//! Why `f32` with not-a-number for a void: 3601 x 3601 samples are 52 MB and not 104, whole metres are exact, and a height that was
//! never measured cannot be mistaken for one: it makes everything computed from it not a number.
//!
//! Space: columns from the west, rows from the north, heights in metres. A sample is a point, not a cell: the first and last of a
//! row lie *on* the borders of the rectangle, so neighbors share them.
//! Source of the ellipsoid: NIMA TR8350.2, "World Geodetic System 1984". Cost: 4 bytes a sample.

mod fill;
mod merge;
mod utm;

pub use fill::{Filled, fill_voids};
pub use merge::{MergeError, Merged, SAMPLE_LIMIT, merge};
pub use utm::{Utm, from_utm, utm, zone_of};

use crate::math::{cos, radians, sin};
use std::ops::Range;

/// What positions of a grid count in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// Degrees of longitude and latitude.
    Degrees,
    /// Metres east and north of some origin.
    Metres,
}

/// Where the samples of a grid lie.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// What the other fields count in.
    pub unit: Unit,
    /// Position of the first column.
    pub west: f64,
    /// Position of the first row.
    pub north: f64,
    /// From one column to the next, and from one row to the next; both above 0.
    pub step: [f64; 2],
}

/// A rectangle of heights. At least 2 x 2 samples.
#[derive(Clone, Debug, PartialEq)]
pub struct Grid {
    /// What messages call it.
    pub name: String,
    columns: usize,
    rows: usize,
    /// Metres, row after row from the north, each from the west; not a number where nothing was measured.
    heights: Vec<f32>,
    /// Where it lies.
    pub frame: Frame,
}

/// Heights that make no grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{heights} heights make no grid of {columns} x {rows} samples, which must be at least 2 x 2")]
pub struct WrongSize {
    /// Samples of a row.
    pub columns: usize,
    /// Number of rows.
    pub rows: usize,
    /// How many heights there are.
    pub heights: usize,
}

impl Grid {
    /// A grid of the given heights: metres, rows from the north, each from the west; not a number where nothing was measured.
    ///
    /// # Errors
    /// [`WrongSize`] when there are fewer than 2 x 2 samples, or not `columns * rows` heights.
    pub fn new(
        name: &str,
        (columns, rows): (usize, usize),
        heights: Vec<f32>,
        frame: Frame,
    ) -> Result<Grid, WrongSize> {
        if columns < 2 || rows < 2 || columns.checked_mul(rows) != Some(heights.len()) {
            return Err(WrongSize { columns, rows, heights: heights.len() });
        }
        Ok(Grid { name: name.to_string(), columns, rows, heights, frame })
    }

    /// Samples of a row.
    #[must_use]
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Number of rows.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// All heights, row after row from the north.
    #[must_use]
    pub fn heights(&self) -> &[f32] {
        &self.heights
    }

    /// All heights, to be changed.
    pub(in crate::forest) fn heights_mut(&mut self) -> &mut [f32] {
        &mut self.heights
    }

    /// One row of heights, counted from the north.
    ///
    /// # Panics
    /// Outside the grid, as indexing does.
    #[must_use]
    pub fn row(&self, row: usize) -> &[f32] {
        &self.heights[row * self.columns..(row + 1) * self.columns]
    }

    /// The height there; not a number in a void.
    ///
    /// # Panics
    /// Outside the grid, as indexing does.
    #[must_use]
    pub fn height(&self, column: usize, row: usize) -> f32 {
        self.row(row)[column]
    }

    /// How many samples were never measured.
    #[must_use]
    pub fn voids(&self) -> usize {
        self.heights.iter().filter(|height| height.is_nan()).count()
    }

    /// The lowest and the highest sample; `None` where all are voids.
    #[must_use]
    pub fn range(&self) -> Option<(f32, f32)> {
        let known = || self.heights.iter().copied().filter(|height| !height.is_nan());
        Some((known().reduce(f32::min)?, known().reduce(f32::max)?))
    }

    /// Metres from one column to the next, and from one row to the next.
    ///
    /// Degrees become metres on the WGS 84 ellipsoid, at the middle latitude of the grid: a degree of longitude is shorter than one of
    /// latitude, and distances, slopes and curvatures are only right in metres.
    #[must_use]
    pub fn spacing(&self) -> [f64; 2] {
        match self.frame.unit {
            Unit::Metres => self.frame.step,
            Unit::Degrees => {
                let middle = self.frame.north - self.frame.step[1] * (self.rows - 1) as f64 / 2.0;
                let [east, north] = metres_per_degree(middle);
                [self.frame.step[0] * east, self.frame.step[1] * north]
            }
        }
    }

    /// Width and height of the rectangle in metres.
    #[must_use]
    pub fn extent(&self) -> [f64; 2] {
        let [east, south] = self.spacing();
        [east * (self.columns - 1) as f64, south * (self.rows - 1) as f64]
    }

    /// West, south, east and north border, in units of the frame.
    #[must_use]
    pub fn borders(&self) -> [f64; 4] {
        let Frame { west, north, step, .. } = self.frame;
        [west, north - step[1] * (self.rows - 1) as f64, west + step[0] * (self.columns - 1) as f64, north]
    }

    /// The height at a position in columns and rows, bilinear between four samples; `None` outside and beside voids.
    #[must_use]
    pub fn sample(&self, column: f64, row: f64) -> Option<f64> {
        let inside = |at: f64, count: usize| (0.0..=(count - 1) as f64).contains(&at);
        if !inside(column, self.columns) || !inside(row, self.rows) {
            return None;
        }
        let cell = |at: f64, count: usize| (at as usize).min(count - 2);
        let (x, y) = (cell(column, self.columns), cell(row, self.rows));
        let (u, v) = (column - x as f64, row - y as f64);
        // A corner of weight 0 does not count: beside a void there is still a height on the far border of the cell.
        let corners = [(0, 0, (1.0 - u) * (1.0 - v)), (1, 0, u * (1.0 - v)), (0, 1, (1.0 - u) * v), (1, 1, u * v)];
        let weighted = corners.iter().filter(|corner| corner.2 != 0.0);
        let height: f64 = weighted.map(|&(i, j, w)| w * f64::from(self.height(x + i, y + j))).sum();
        (!height.is_nan()).then_some(height)
    }

    /// Column and row of a position in units of the frame; need not be inside or whole.
    #[must_use]
    pub fn place(&self, east: f64, north: f64) -> (f64, f64) {
        ((east - self.frame.west) / self.frame.step[0], (self.frame.north - north) / self.frame.step[1])
    }

    /// The part of it in the given columns and rows.
    ///
    /// # Errors
    /// [`WrongSize`] when less than 2 x 2 samples of the grid lie there.
    pub fn crop(&self, columns: Range<usize>, rows: Range<usize>) -> Result<Grid, WrongSize> {
        let columns = columns.start..columns.end.min(self.columns).max(columns.start);
        let rows = rows.start..rows.end.min(self.rows).max(rows.start);
        let heights: Vec<f32> =
            rows.clone().flat_map(|row| self.row(row).get(columns.clone()).unwrap_or_default()).copied().collect();
        let frame = Frame {
            west: self.frame.west + self.frame.step[0] * columns.start as f64,
            north: self.frame.north - self.frame.step[1] * rows.start as f64,
            ..self.frame
        };
        Grid::new(&self.name, (columns.len(), rows.len()), heights, frame)
    }
}

/// Semi-major axis of the WGS 84 ellipsoid, in metres.
const RADIUS: f64 = 6_378_137.0;
/// Its flattening.
const FLATTENING: f64 = 1.0 / 298.257_223_563;

/// Metres of a degree of longitude and of a degree of latitude, at a latitude in degrees.
///
/// ```
/// let [east, north] = farop::forest::elevation::metres_per_degree(60.0);
/// assert!((east - 55_800.0).abs() < 1.0 && (north - 111_412.0).abs() < 1.0);
/// ```
#[must_use]
pub fn metres_per_degree(latitude: f64) -> [f64; 2] {
    let (sine, cosine) = (sin(radians(latitude)), cos(radians(latitude)));
    let squared = FLATTENING * (2.0 - FLATTENING);
    let w = (1.0 - squared * sine * sine).sqrt();
    let (across, along) = (RADIUS / w * cosine, RADIUS * (1.0 - squared) / (w * w * w));
    [radians(across), radians(along)]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid(heights: &[f32]) -> Grid {
        let frame = Frame { unit: Unit::Metres, west: 100.0, north: 50.0, step: [10.0, 5.0] };
        Grid::new("g", (3, heights.len() / 3), heights.to_vec(), frame).expect("three columns")
    }

    #[test]
    fn rows_come_from_the_north_and_voids_are_no_heights() {
        let grid = grid(&[1.0, 2.0, 3.0, 4.0, 5.0, f32::NAN]);
        assert_eq!((grid.voids(), grid.range()), (1, Some((1.0, 5.0))));
        assert_eq!(grid.borders(), [100.0, 45.0, 120.0, 50.0]);
        assert_eq!(grid.place(110.0, 45.0), (1.0, 1.0));
        assert_eq!(grid.sample(0.5, 0.5), Some(3.0));
        assert_eq!(grid.sample(1.5, 0.5), None, "beside the void");
        assert_eq!(grid.sample(1.5, 0.0), Some(2.5), "but not on the far border of its cell");
        assert_eq!(grid.sample(2.1, 0.0), None);
        let part = grid.crop(1..3, 0..9).expect("2 x 2");
        assert_eq!((part.height(0, 1), part.frame.west), (5.0, 110.0));
        assert!(grid.crop(2..9, 0..2).is_err() && grid.crop(7..9, 0..2).is_err());
    }

    #[test]
    fn a_degree_is_as_long_as_the_tables_say() {
        // Lengths of a degree on WGS 84, National Geospatial-Intelligence Agency's tables.
        for (latitude, east, north) in
            [(0.0, 111_319.5, 110_574.3), (45.0, 78_846.8, 111_131.7), (90.0, 0.0, 111_693.9)]
        {
            let found = metres_per_degree(latitude);
            assert!((found[0] - east).abs() < 0.1 && (found[1] - north).abs() < 0.2, "{latitude}: {found:?}");
        }
    }
}
