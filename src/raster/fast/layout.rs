//! Layout: how a picture is cut into tiles.
//!
//! Tiles are squares that start at the picture's upper left corner; a tile's samples fit into the nearest caches.
//!
//! Space: samples. Blocks of 16 x 16 samples, at which planes are anchored, are fixed on the picture, so the side of the tiles
//! changes no bit.

use std::ops::Range;

/// The widest tile.
pub(super) const LARGEST_SIDE: u32 = 256;
/// Samples that one step of the inner loops works on; a step never crosses a block.
pub(super) const LANES: u32 = 8;

/// Tiles over the rows that are drawn.
#[derive(Clone, Debug)]
pub(super) struct Layout {
    /// Samples across.
    pub width: i32,
    /// Rows of samples that are drawn.
    pub rows: Range<i32>,
    /// Samples of a tile's side.
    pub side: i32,
    /// Tiles across.
    pub columns: usize,
    /// The first row of tiles.
    first_row: i32,
    /// Rows of tiles.
    tile_rows: usize,
    /// 2^32 / side, rounded up: a product in place of a quotient.
    inverse_side: u64,
}

/// One tile's samples, cut at the picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Area {
    pub columns: Range<i32>,
    pub rows: Range<i32>,
}

impl Layout {
    pub fn new(width: i32, rows: Range<i32>, side: u32) -> Layout {
        let side = side as i32;
        let first_row = rows.start / side;
        let end_row = rows.end.max(rows.start).div_euclid(side) + i32::from(rows.end % side != 0);
        let columns = (width.max(0) as usize).div_ceil(side as usize);
        let tile_rows = (end_row - first_row).max(0) as usize;
        let inverse_side = (1_u64 << 32).div_ceil(side as u64);
        Layout { width, rows, side, columns, first_row, tile_rows, inverse_side }
    }

    /// How many tiles there are.
    pub fn tiles(&self) -> usize {
        self.columns * self.tile_rows
    }

    /// The samples of tile `index`.
    pub fn area(&self, index: usize) -> Area {
        let column = (index % self.columns) as i32 * self.side;
        let row = (self.first_row + (index / self.columns) as i32) * self.side;
        let columns = column..(column + self.side).min(self.width);
        Area { columns, rows: row.max(self.rows.start)..(row + self.side).min(self.rows.end) }
    }

    /// The tiles that a box of samples inside the picture touches: columns, rows of tiles from the first one.
    #[inline]
    pub fn touched(&self, columns: [i32; 2], rows: [i32; 2]) -> [Range<usize>; 2] {
        let first_row = self.first_row as usize;
        [
            self.tile(columns[0])..self.tile(columns[1] - 1) + 1,
            self.tile(rows[0]) - first_row..self.tile(rows[1] - 1) - first_row + 1,
        ]
    }

    /// A column or row of samples, divided by the side. Exact below 2^32 / 256: the rounded inverse is off by less than 1 / 2^32.
    #[inline]
    fn tile(&self, sample: i32) -> usize {
        ((sample as u64 * self.inverse_side) >> 32) as usize
    }
}

/// The side of tiles that hold whole pixels of `samples` x `samples` and whole steps of the inner loops, near `wanted`; `None` where
/// there is none up to the largest.
pub(super) fn side_of_whole_pixels(wanted: u32, samples: u32) -> Option<u32> {
    let samples = samples.max(1);
    let unit = LANES * samples / greatest_common_divisor(LANES, samples);
    (unit <= LARGEST_SIDE).then(|| wanted.clamp(unit, LARGEST_SIDE) / unit * unit)
}

fn greatest_common_divisor(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { greatest_common_divisor(b, a % b) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tiles_cover_every_sample_once() {
        for (width, rows, side) in [(100, 0..70, 64), (8, 3..9, 8), (300, 130..131, 16), (0, 0..5, 64), (5, 4..4, 8)] {
            let layout = Layout::new(width, rows.clone(), side);
            let mut seen = std::collections::BTreeSet::new();
            for tile in 0..layout.tiles() {
                let area = layout.area(tile);
                for y in area.rows.clone() {
                    area.columns.clone().for_each(|x| assert!(seen.insert((x, y)), "{x} {y}"));
                }
                let [columns, rows] =
                    layout.touched([area.columns.start, area.columns.end], [area.rows.start, area.rows.end]);
                assert_eq!(
                    (columns.start, columns.len(), rows.start, rows.len()),
                    (tile % layout.columns, 1, tile / layout.columns, 1)
                );
            }
            assert_eq!(seen.len(), (width.max(0) * rows.len() as i32) as usize);
        }
    }

    #[test]
    fn products_divide_exactly() {
        for side in (8..=256).step_by(8) {
            let layout = Layout::new(1 << 22, 0..1 << 22, side);
            let near = (0..1 << 14).map(|tile| tile * side as i32).filter(|&sample| sample > 0 && sample <= 1 << 22);
            for sample in near {
                assert_eq!(
                    [layout.tile(sample - 1), layout.tile(sample)],
                    [sample - 1, sample].map(|x| (x / side as i32) as usize)
                );
            }
        }
    }

    #[test]
    fn sides_hold_whole_pixels() {
        assert_eq!(
            [1, 2, 3, 4, 5, 7].map(|samples| side_of_whole_pixels(64, samples)),
            [64, 64, 48, 64, 40, 56].map(Some)
        );
        assert_eq!(side_of_whole_pixels(64, 31), Some(248));
        assert_eq!(side_of_whole_pixels(64, 33), None);
        assert_eq!(side_of_whole_pixels(8, 1), Some(8));
        assert_eq!(side_of_whole_pixels(1000, 1), Some(256));
    }
}
