//! Voids: what was never measured is filled in where it is small, and stays a hole where it is not.
//!
//! Grid with voids -FILL-> Grid
//!
//! Small voids are shadows of the radar on steep slopes: the smoothest surface through their rim, the solution of Laplace's equation, is as
//! good a guess as any. Over a large void it would be an invention, so that stays, and the relief has a hole there.
//!
//! Why successive over-relaxation in the order of rows: it needs nothing but the heights and gives the same bits everywhere.
//! Source: D. Young, "Iterative Methods for Solving Partial Difference Equations of Elliptic Type", Trans. AMS 76, 1954.
//! Cost: about the square root of a void's samples in rounds over it.

use super::Grid;

/// What became of the voids.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Filled {
    /// Samples that have a height now.
    pub samples: usize,
    /// Voids (connected by sides) that they were.
    pub voids: usize,
    /// Samples of the voids that were too large, or had no rim.
    pub left: usize,
}

/// Heights change by less than this, in metres, when the rounds end.
const CLOSE_ENOUGH: f64 = 1e-4;
/// As many rounds as the largest voids that anybody would want filled need.
const MOST_ROUNDS: usize = 20_000;

/// Fills every void of at most `most` samples, connected by sides, with the smoothest surface through its rim.
///
/// Beyond the border of the grid there is no rim: the surface meets it level. Where all known heights are whole metres the new ones
/// are rounded to whole metres, too.
pub fn fill_voids(grid: &mut Grid, most: usize) -> Filled {
    let mut filled = Filled::default();
    let whole = grid.heights.iter().all(|height| height.is_nan() || height.fract() == 0.0);
    let mut seen = vec![false; grid.heights.len()];
    for start in 0..grid.heights.len() {
        if seen[start] || !grid.heights[start].is_nan() {
            continue;
        }
        let (members, rim) = connected(grid, start, &mut seen);
        if members.len() > most || rim.is_none() {
            filled.left += members.len();
            continue;
        }
        filled.samples += members.len();
        filled.voids += 1;
        let heights = relaxed(grid, &members, rim.unwrap_or_default());
        for (&at, height) in members.iter().zip(heights) {
            grid.heights[at] = if whole { height.round() } else { height } as f32;
        }
    }
    filled
}

/// The samples of the void around `start`, in rising order, and the mean height of its rim.
fn connected(grid: &Grid, start: usize, seen: &mut [bool]) -> (Vec<usize>, Option<f64>) {
    let (mut members, mut stack) = (Vec::new(), vec![start]);
    let (mut sum, mut count) = (0.0, 0.0);
    seen[start] = true;
    while let Some(at) = stack.pop() {
        members.push(at);
        for next in neighbors(grid, at) {
            let height = grid.heights[next];
            if !height.is_nan() {
                sum += f64::from(height);
                count += 1.0;
            } else if !seen[next] {
                seen[next] = true;
                stack.push(next);
            }
        }
    }
    members.sort_unstable();
    (members, (count > 0.0).then(|| sum / count))
}

/// The samples beside one: up to four.
fn neighbors(grid: &Grid, at: usize) -> impl Iterator<Item = usize> {
    let (columns, column, row) = (grid.columns, at % grid.columns, at / grid.columns);
    let beside = [
        (row > 0).then(|| at - columns),
        (column > 0).then(|| at - 1),
        (column + 1 < columns).then(|| at + 1),
        (row + 1 < grid.rows).then(|| at + columns),
    ];
    beside.into_iter().flatten()
}

/// The heights of `members`: each the mean of its neighbors.
fn relaxed(grid: &Grid, members: &[usize], start: f64) -> Vec<f64> {
    // Neighbors within the void by their place in `members`; of the rim only the sum counts.
    let mut inner: Vec<([u32; 4], usize)> = Vec::with_capacity(members.len());
    let mut fixed: Vec<(f64, f64)> = Vec::with_capacity(members.len());
    for &at in members {
        let (mut within, mut count, mut sum, mut all) = ([0; 4], 0, 0.0, 0.0);
        for next in neighbors(grid, at) {
            all += 1.0;
            match members.binary_search(&next) {
                Ok(index) => {
                    within[count] = index as u32;
                    count += 1;
                }
                Err(_) => sum += f64::from(grid.heights[next]),
            }
        }
        inner.push((within, count));
        fixed.push((sum, all));
    }
    // The best factor for a square of that many samples.
    let side = (members.len() as f64).sqrt() + 1.0;
    let factor = 2.0 / (1.0 + crate::math::sin(crate::math::PI / (side + 1.0)));
    let mut heights = vec![start; members.len()];
    for _ in 0..MOST_ROUNDS {
        let mut largest = 0.0_f64;
        for index in 0..heights.len() {
            let (within, count) = &inner[index];
            let (sum, all) = fixed[index];
            let mean = within[..*count].iter().fold(sum, |sum, &next| sum + heights[next as usize]) / all;
            let change = factor * (mean - heights[index]);
            heights[index] += change;
            largest = largest.max(change.abs());
        }
        if largest < CLOSE_ENOUGH {
            break;
        }
    }
    heights
}

#[cfg(test)]
mod tests {
    use super::super::{Frame, Unit};
    use super::*;

    /// A plane of 20 x 12 samples with a slope of `slope`, without the samples that `is_void` names.
    fn plane(slope: f32, is_void: impl Fn(usize, usize) -> bool) -> Grid {
        let frame = Frame { unit: Unit::Metres, west: 0.0, north: 0.0, step: [30.0, 30.0] };
        let height = |at: usize| {
            let (x, y) = (at % 20, at / 20);
            if is_void(x, y) { f32::NAN } else { slope * (x + 2 * y) as f32 }
        };
        Grid::new("plane", (20, 12), (0..240).map(height).collect(), frame).expect("20 x 12")
    }

    #[test]
    fn a_plane_is_filled_as_a_plane() {
        for (slope, off) in [(3.0, 0.0), (0.3, 2e-3)] {
            let mut grid = plane(slope, |x, y| (3..9).contains(&x) && (2..8).contains(&y));
            assert_eq!(fill_voids(&mut grid, 36), Filled { samples: 36, voids: 1, left: 0 });
            let whole = plane(slope, |_, _| false);
            let worst = grid.heights().iter().zip(whole.heights()).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
            assert!(worst <= off, "{worst}");
        }
    }

    #[test]
    fn large_voids_and_grids_without_heights_stay() {
        let mut grid = plane(1.0, |x, y| x > 12 || (x, y) == (2, 2) || (x, y) == (3, 3));
        assert_eq!(fill_voids(&mut grid, 50), Filled { samples: 2, voids: 2, left: 84 });
        assert_eq!(grid.height(2, 2), 6.0);
        let mut nothing = plane(1.0, |_, _| true);
        assert_eq!(fill_voids(&mut nothing, usize::MAX), Filled { samples: 0, voids: 0, left: 240 });
    }

    #[test]
    fn a_void_at_the_border_is_level_there() {
        let mut grid = plane(0.0, |x, _| x < 4);
        assert_eq!(fill_voids(&mut grid, 100).samples, 48);
        assert!(grid.heights().iter().all(|&height| height == 0.0));
    }
}
