//! Merge: tiles that lie side by side become one grid.
//!
//! Grids of any order and resolution -MERGE-> one Grid over all of them
//!
//! The paper calls this the "algoritmo de encaje" and says no more. Here: the joint grid is as fine as the finest tile; a tile of the same
//! lattice is copied sample by sample, a coarser one is read bilinearly. Where tiles overlap (neighbors share a row or a column)
//! the finer one wins, of equals the first; a void never wins. So both tiles of a seam have one and the same row, and there is
//! nothing to stitch. What no tile covers is void.
//!
//! Source: M. Cifuentes et al., "Remallado de Terrenos Multirresolución", section 2. Cost: linear in the joint grid.

use super::{Frame, Grid, Unit};

/// The most samples of a joint grid: 2^27, half a gigabyte.
pub const SAMPLE_LIMIT: usize = 1 << 27;

/// A joint grid and what was found on its seams.
#[derive(Clone, Debug)]
pub struct Merged {
    /// All tiles.
    pub grid: Grid,
    /// Samples that two tiles both have, with a height in each.
    pub shared: usize,
    /// Of them, those whose heights differ.
    pub differing: usize,
    /// The largest difference, in metres.
    pub largest: f32,
    /// Tiles that were read bilinearly because their lattice is another.
    pub resampled: usize,
}

/// Why tiles make no grid.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MergeError {
    /// There is none.
    #[error("there is no grid to merge; name at least one file")]
    Nothing,
    /// One counts in degrees, the other in metres.
    #[error("`{first}` lies in degrees and `{second}` in metres; merge grids of one kind")]
    Units {
        /// A grid in degrees.
        first: String,
        /// A grid in metres.
        second: String,
    },
    /// The rectangle around them is too large.
    #[error(
        "the rectangle around `{first}` and `{second}` has {columns} x {rows} samples, more than {SAMPLE_LIMIT}; \
         are they neighbors? Merge only grids that lie side by side"
    )]
    TooLarge {
        /// The first grid.
        first: String,
        /// The grid that makes it too large.
        second: String,
        /// Samples of a row.
        columns: u64,
        /// Number of rows.
        rows: u64,
    },
}

/// Joins grids that lie side by side; a single one stays as it is.
///
/// # Errors
/// [`MergeError`]: no grid, degrees and metres together, or a rectangle of more than [`SAMPLE_LIMIT`] samples.
pub fn merge(grids: Vec<Grid>) -> Result<Merged, MergeError> {
    let (frame, columns, rows) = joint(&grids)?;
    let mut report = Report::default();
    if let [_] = grids[..] {
        let grid = grids.into_iter().next().ok_or(MergeError::Nothing)?;
        return Ok(Merged { grid, shared: 0, differing: 0, largest: 0.0, resampled: 0 });
    }
    let name = grids.iter().map(|grid| grid.name.as_str()).collect::<Vec<_>>().join(" + ");
    let mut heights = vec![f32::NAN; columns * rows];
    // The finer first, of equals in the order given: who comes first keeps the sample.
    let mut order: Vec<&Grid> = grids.iter().collect();
    order.sort_by(|a, b| area(a).total_cmp(&area(b)));
    for tile in order {
        lay(tile, &frame, (columns, rows), &mut heights, &mut report);
    }
    let Report { shared, differing, largest, resampled } = report;
    let grid = Grid { name, columns, rows, heights, frame };
    Ok(Merged { grid, shared, differing, largest, resampled })
}

/// What one sample stands for.
fn area(grid: &Grid) -> f64 {
    grid.frame.step[0] * grid.frame.step[1]
}

/// The frame and size of the rectangle around all grids.
fn joint(grids: &[Grid]) -> Result<(Frame, usize, usize), MergeError> {
    let first = grids.first().ok_or(MergeError::Nothing)?;
    let mut frame = first.frame;
    let [mut west, mut south, mut east, mut north] = first.borders();
    let mut size = (first.columns as u64, first.rows as u64);
    for grid in &grids[1..] {
        if grid.frame.unit != frame.unit {
            let of = |unit| if grid.frame.unit == unit { grid.name.clone() } else { first.name.clone() };
            return Err(MergeError::Units { first: of(Unit::Degrees), second: of(Unit::Metres) });
        }
        let other = grid.borders();
        (west, south, east, north) = (west.min(other[0]), south.min(other[1]), east.max(other[2]), north.max(other[3]));
        frame.step = [frame.step[0].min(grid.frame.step[0]), frame.step[1].min(grid.frame.step[1])];
        let count = |from: f64, to: f64, step: f64| ((to - from) / step).round() as u64 + 1;
        size = (count(west, east, frame.step[0]), count(south, north, frame.step[1]));
        if size.0.saturating_mul(size.1) > SAMPLE_LIMIT as u64 {
            let (columns, rows) = size;
            return Err(MergeError::TooLarge { first: first.name.clone(), second: grid.name.clone(), columns, rows });
        }
    }
    (frame.west, frame.north) = (west, north);
    Ok((frame, size.0 as usize, size.1 as usize))
}

#[derive(Default)]
struct Report {
    shared: usize,
    differing: usize,
    largest: f32,
    resampled: usize,
}

/// Writes a tile into the joint grid, where nothing finer stands.
fn lay(tile: &Grid, frame: &Frame, (columns, rows): (usize, usize), heights: &mut [f32], report: &mut Report) {
    let offset = ((tile.frame.west - frame.west) / frame.step[0], (frame.north - tile.frame.north) / frame.step[1]);
    let ratio = [frame.step[0] / tile.frame.step[0], frame.step[1] / tile.frame.step[1]];
    // A thousandth of a sample: borders of tiles are written in decimal degrees.
    let near = |a: f64, b: f64| (a - b).abs() < 1e-3;
    let last = |count: usize, ratio: f64| (count - 1) as f64 / ratio;
    let same = near(offset.0, offset.0.round())
        && near(offset.1, offset.1.round())
        && near(last(tile.columns, ratio[0]), (tile.columns - 1) as f64)
        && near(last(tile.rows, ratio[1]), (tile.rows - 1) as f64);
    report.resampled += usize::from(!same);
    // Joint samples on or within the tile's borders.
    let span = |offset: f64, count: usize, ratio: f64, limit: usize| {
        let end = ((offset + last(count, ratio) + 1e-3).floor() as usize).min(limit - 1);
        (offset - 1e-3).ceil().max(0.0) as usize..=end
    };
    for row in span(offset.1, tile.rows, ratio[1], rows) {
        let v = ((row as f64 - offset.1) * ratio[1]).clamp(0.0, (tile.rows - 1) as f64);
        for column in span(offset.0, tile.columns, ratio[0], columns) {
            let u = ((column as f64 - offset.0) * ratio[0]).clamp(0.0, (tile.columns - 1) as f64);
            let height = if same {
                tile.height(u.round() as usize, v.round() as usize)
            } else {
                tile.sample(u, v).map_or(f32::NAN, |height| height as f32)
            };
            let there = &mut heights[row * columns + column];
            if there.is_nan() {
                *there = height;
            } else if !height.is_nan() {
                report.shared += 1;
                report.differing += usize::from(*there != height);
                report.largest = report.largest.max((*there - height).abs());
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tile(name: &str, (west, north): (f64, f64), cells: usize, height: impl Fn(f64, f64) -> f32) -> Grid {
        let step = 1.0 / cells as f64;
        let frame = Frame { unit: Unit::Degrees, west, north, step: [step, step] };
        let side = cells + 1;
        let at = |at: usize| height(west + (at % side) as f64 * step, north - (at / side) as f64 * step);
        Grid::new(name, (side, side), (0..side * side).map(at).collect(), frame).expect("square")
    }

    #[test]
    fn neighbors_share_their_row() {
        let height = |x: f64, y: f64| (x * 10.0 + y * 100.0).round() as f32;
        let upper = tile("N42E001", (1.0, 43.0), 10, height);
        let lower = tile("N41E001", (1.0, 42.0), 10, height);
        for grids in [vec![upper.clone(), lower.clone()], vec![lower.clone(), upper.clone()]] {
            let merged = merge(grids).expect("neighbors");
            assert_eq!((merged.grid.columns(), merged.grid.rows()), (11, 21));
            assert_eq!((merged.shared, merged.differing, merged.resampled), (11, 0, 0));
            assert_eq!(merged.grid.row(10), lower.row(0));
            assert_eq!(merged.grid.row(20), lower.row(10));
            assert_eq!(merged.grid.voids(), 0);
        }
    }

    #[test]
    fn the_finer_tile_wins_on_the_seam_and_the_coarser_is_resampled() {
        let slope = |x: f64, y: f64| (x + y) as f32 * 64.0;
        let fine = tile("fine", (0.0, 1.0), 12, slope);
        let coarse = tile("coarse", (1.0, 1.0), 4, |x, y| slope(x, y) + 1.0);
        let merged = merge(vec![coarse, fine.clone()]).expect("neighbors");
        assert_eq!((merged.grid.columns(), merged.grid.rows()), (25, 13));
        assert_eq!((merged.shared, merged.resampled, merged.largest), (13, 1, 1.0));
        let seam: Vec<f32> = (0..13).map(|row| merged.grid.height(12, row)).collect();
        let own: Vec<f32> = (0..13).map(|row| fine.height(12, row)).collect();
        assert_eq!(seam, own);
        // A plane is bilinear: every resampled height is right.
        for (row, column) in [(0, 13), (5, 18), (12, 24)] {
            let expected = slope(column as f64 / 12.0, 1.0 - row as f64 / 12.0) + 1.0;
            assert!((merged.grid.height(column, row) - expected).abs() < 1e-4);
        }
    }

    #[test]
    fn a_void_never_wins_and_gaps_are_void() {
        let upper = tile("a", (0.0, 1.0), 2, |_, y| if y == 0.0 { f32::NAN } else { 1.0 });
        let lower = tile("b", (1.0, 0.0), 2, |_, _| 2.0);
        let merged = merge(vec![upper, lower]).expect("corner to corner");
        assert_eq!(merged.grid.height(2, 2), 2.0);
        assert_eq!(merged.grid.voids(), 25 - 6 - 9);
    }

    #[test]
    fn what_cannot_be_joined_is_told() {
        let one = tile("a", (0.0, 1.0), 1200, |_, _| 0.0);
        let far = tile("b", (-156.0, 20.0), 1200, |_, _| 0.0);
        assert!(matches!(merge(vec![one.clone(), far]), Err(MergeError::TooLarge { .. })));
        let mut metres = one.clone();
        metres.frame.unit = Unit::Metres;
        let error = merge(vec![metres, one]).expect_err("two kinds").to_string();
        assert!(error.contains("in degrees"), "{error}");
        assert_eq!(merge(Vec::new()).expect_err("none"), MergeError::Nothing);
    }
}
