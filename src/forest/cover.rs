//! Cover: which ground lies where in a cell, as a small picture of numbers.
//!
//! Cell, year -COVER-> numbers of covers -> which ground picture a fragment shows; at samples of a relief -> borders
//!
//! Why a picture of numbers: triangles of the relief come and go with the distance, borders of stands must not. A texel is the ground at its
//! center, exactly: the half-open rule of [`polygon`](super::polygon), so two neighbors leave no gap.
//!
//! Space: texels; rows from the south, columns from the west; texel (i, j) has its center at ((i + 0.5), (j + 0.5)) times the cell's side over theirs.
//! Cost: a few operations a run of texels.

use super::area::{Cell, Ground, Head, Owner};
use super::cells::Cells;
use super::land::{Land, fill, rings};
use super::pack::PackError;

/// The ground at the centers of `side` x `side` texels: index into [`Head::covers`] plus 1, or 0 for none. Rows from the south.
///
/// Where patches overlap the later one counts; a stand without a ground of its own has the cell's. Triangles with a ground
/// ([`Ground::Mesh`]) lie below all patches.
#[must_use]
pub fn raster(head: &Head, cell: &Cell, year: Option<i32>, side: usize) -> Vec<u8> {
    let plain = cell.cover.map_or(0, number);
    let mut numbers = vec![plain; side * side];
    let mut paint = |rings: &mut dyn Iterator<Item = &[[f64; 2]]>, number: u8| {
        fill(rings, head.side, side, |row, columns| numbers[row * side..][columns].fill(number));
    };
    if let Ground::Mesh { vertices, triangles } = &cell.ground {
        for (corners, cover) in triangles {
            let corner = |index: u32| vertices.get(index as usize).map_or([0.0; 2], |v| [v.x, v.y]);
            if let Some(cover) = cover {
                paint(&mut std::iter::once(corners.map(corner).as_slice()), number(*cover));
            }
        }
    }
    for patch in &cell.patches {
        paint(&mut rings(patch), worn(cell, patch.owner, year));
    }
    numbers
}

/// The number of a patch's ground.
fn worn(cell: &Cell, owner: Owner, year: Option<i32>) -> u8 {
    let plain = cell.cover.map_or(0, number);
    match owner {
        Owner::Cover(cover) => number(cover),
        Owner::Stand(stand) => {
            let state = cell.stands.get(stand as usize).and_then(|stand| stand.in_year(year));
            state.and_then(|state| state.cover).map_or(plain, number)
        }
    }
}

/// Samples of a rectangle of land.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Samples {
    /// World metres of the south-west one.
    pub corner: [f64; 2],
    /// Metres from one to the next, east and north.
    pub spacing: [f64; 2],
    /// Columns and rows.
    pub size: [usize; 2],
}

/// The ground at samples of an area, numbered as in [`raster`]; 0 where there is no cell. Rows from the *north*, as heights.
///
/// A sample on the border between two cells belongs to the one in the east, or north; if there is none, to the other one.
/// Triangles with a ground of their own ([`Ground::Mesh`]) do not count, nor do roads and rivers.
///
/// # Errors
/// A cell cannot be read.
pub fn at_samples(cells: &Cells, year: Option<i32>, samples: &Samples) -> Result<Vec<u8>, PackError> {
    let [columns, rows] = samples.size;
    let mut numbers = vec![0; columns * rows];
    let side = cells.head().side;
    // Ascending: cells in the east and north come later, and take what lies on the border.
    for index in cells.indices() {
        let ranges = [0, 1].map(|axis| samples.within(f64::from(index[axis]) * side, side, axis));
        if ranges.iter().any(std::ops::Range::is_empty) {
            continue;
        }
        let Some(cell) = cells.load(index)? else { continue };
        let land = Land::new(&cell, side);
        let plain = cell.cover.map_or(0, number);
        // On the far border just inside, where its own patches still are.
        let last = side * (1.0 - 1e-12);
        let place = |at: usize, axis: usize| {
            let metres = samples.corner[axis] + at as f64 * samples.spacing[axis] - f64::from(index[axis]) * side;
            metres.clamp(0.0, last)
        };
        for y in ranges[1].clone() {
            for x in ranges[0].clone() {
                let patch = land.patch_at([place(x, 0), place(y, 1)]);
                let ground = patch.map_or(plain, |patch| worn(&cell, cell.patches[patch].owner, year));
                numbers[(rows - 1 - y) * columns + x] = ground;
            }
        }
    }
    Ok(numbers)
}

impl Samples {
    /// Which samples lie in a stretch of land, ends included.
    fn within(&self, start: f64, length: f64, axis: usize) -> std::ops::Range<usize> {
        let (step, count) = (self.spacing[axis], self.size[axis]);
        // Rounding must not lose the samples on the ends.
        let slack = 1e-9 * length;
        let first = ((start - slack - self.corner[axis]) / step).ceil().max(0.0);
        let last = ((start + length + slack - self.corner[axis]) / step).floor();
        if last < first { 0..0 } else { (first as usize).min(count)..(last as usize + 1).min(count) }
    }
}

/// The number of a cover; 255, which no head has, would not fit and is 255.
fn number(cover: u8) -> u8 {
    cover.saturating_add(1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::forest::land::{Land, center_of};
    use crate::forest::place::fixture;
    use crate::forest::polygon::contains;

    #[test]
    fn every_texel_is_the_ground_at_its_center() {
        let (head, cell) = fixture();
        // 120: centers on whole odd metres, where the outlines of the fixture have corners.
        for side in [7, 32, 120] {
            let numbers = raster(&head, &cell, None, side);
            for (index, number) in numbers.iter().enumerate() {
                let at = [index % side, index / side].map(|index| center_of(index, head.side, side));
                let inside = |patch: &&crate::forest::area::Patch| contains(&patch.outer, &patch.holes, at);
                let expected = match cell.patches.iter().rev().find(inside).map(|patch| patch.owner) {
                    None => 1,
                    Some(Owner::Cover(cover)) => cover + 1,
                    Some(Owner::Stand(stand)) => {
                        cell.stands[stand as usize].states[0].cover.map_or(1, |cover| cover + 1)
                    }
                };
                assert_eq!(*number, expected, "{at:?} of {side}");
            }
        }
    }

    #[test]
    fn samples_have_the_ground_where_they_are() {
        let (head, cell) = fixture();
        let index = cell.index;
        let area = crate::forest::area::Area { head, cells: [(index, cell.clone())].into() };
        let cells = Cells::Loaded(area);
        let corner = index.map(|index| f64::from(index) * cells.head().side);
        let samples = Samples { corner: [corner[0] - 21.0, corner[1] - 40.0], spacing: [7.0, 8.0], size: [40, 39] };
        let numbers = at_samples(&cells, None, &samples).expect("all in memory");
        let (mut inside, mut kinds) = (0, std::collections::BTreeSet::new());
        for (at, number) in numbers.iter().enumerate() {
            let place = [at % 40, 38 - at / 40];
            let at =
                [0, 1].map(|axis| samples.corner[axis] + place[axis] as f64 * samples.spacing[axis] - corner[axis]);
            let holds = |patch: &&crate::forest::area::Patch| contains(&patch.outer, &patch.holes, at);
            if at.iter().any(|metres| *metres < 0.0 || *metres > cells.head().side) {
                assert_eq!(*number, 0, "{at:?}");
            } else if at.iter().all(|metres| *metres < cells.head().side) {
                let patch = cell.patches.iter().rev().find(holds);
                assert_eq!(*number, patch.map_or(1, |patch| worn(&cell, patch.owner, None)), "{at:?}");
                inside += 1;
                kinds.insert(*number);
            }
        }
        assert!(inside > 900 && kinds.len() > 1, "{inside} {kinds:?}");
    }

    #[test]
    fn squares_change_no_answer() {
        let (head, cell) = fixture();
        let land = Land::new(&cell, head.side);
        for index in 0..20_000_usize {
            let at = [index * 7919 % 4801, index * 104_729 % 4799].map(|number| number as f64 / 20.0);
            let expected = cell.patches.iter().rposition(|patch| contains(&patch.outer, &patch.holes, at));
            assert_eq!(land.patch_at(at), expected, "{at:?}");
        }
    }
}
