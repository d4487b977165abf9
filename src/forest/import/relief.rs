//! Relief: heights of the cells out of a grid of measured heights.
//!
//! Grid in degrees or metres -RELIEF-> a lattice of each cell
//!
//! A sample on a common border of two cells is asked for at one position of the world, whichever cell asks: both get the same height to the last bit.
//!
//! Space: the grid's own reference system; the cells' is a UTM map. Cost: a projection and four heights a sample.

use super::World;
use crate::forest::area::{CellIndex, Ground};
use crate::forest::elevation::Grid;
use crate::forest::lattice::lattice;
use crate::forest::polygon::Point;
use crate::forest::vector::Crs;

/// Measured heights, and what their positions mean.
#[derive(Clone, Debug)]
pub struct Relief {
    /// The heights.
    pub grid: Grid,
    /// What its frame counts in.
    pub crs: Crs,
}

impl Relief {
    /// The height at a position of a reference system; `None` outside and beside voids.
    #[must_use]
    pub fn height(&self, crs: Crs, position: Point) -> Option<f64> {
        let [east, north] = crs.to(self.crs, position);
        let (column, row) = self.grid.place(east, north);
        self.grid.sample(column, row)
    }

    /// The lattice of a cell, and how many of its samples are void; `None` where all are.
    pub(super) fn ground(&self, world: &World, index: CellIndex, samples: u16) -> Option<(Ground, usize)> {
        let last = i64::from(samples) - 1;
        let along = |axis: usize, number: i64| {
            // The number of the sample in the world: on a border it is that of the neighbor.
            (i64::from(index[axis]) * last + number) as f64 * (world.side / last as f64) + world.origin[axis]
        };
        let sample = |number: i64| {
            let (column, row) = (number % (last + 1), number / (last + 1));
            self.height(world.crs, [along(0, column), along(1, last - row)]).unwrap_or(f64::NAN)
        };
        let heights: Vec<f64> = (0..(last + 1) * (last + 1)).map(sample).collect();
        let voids = heights.iter().filter(|height| height.is_nan()).count();
        (voids < heights.len()).then(|| (lattice([samples; 2], &heights), voids))
    }
}
