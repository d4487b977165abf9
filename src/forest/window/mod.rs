//! Window: the square of cells around the observer that are in memory.
//!
//! place of the observer -WINDOW-> which cells are loaded, which are dropped
//!
//! The horizon is `horizon` cells away, and `buffer` more are kept beyond it: the window is 2 (buffer + horizon) + 1 cells wide. Its middle
//! (2 buffer + 1)^2 cells are free: walking about in them changes nothing. Who leaves them by some cells takes the window along by as
//! many, in both directions at once: diagonal steps and jumps need no rule of their own. So the horizon may touch the edge of the window and never
//! passes it, and turning back at once loads nothing: the hysteresis comes free.
//!
//! The paper prints (buffer + 1)^2 free cells; its own example (columns 6 to 12, column 13 comes when column 10 is left) has (2 buffer + 1)^2.
//!
//! Space: columns and rows of cells. Source: A. Falcão, M. Próspero dos Santos, "Visualização de paisagens florestais".

mod stock;

pub use stock::{Grove, RASTER, SQUARES, Stock, StockError, Stocked};

use super::area::CellIndex;

/// Columns and rows beyond this are nowhere: sums of them stay numbers.
const FAR: i32 = 1 << 28;

/// Which cells are in memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Window {
    buffer: i32,
    horizon: i32,
    center: CellIndex,
}

impl Window {
    /// Around the cell of the observer; `buffer` and `horizon` in cells.
    #[must_use]
    pub fn new(buffer: u16, horizon: u16, at: CellIndex) -> Window {
        Window { buffer: i32::from(buffer), horizon: i32::from(horizon), center: at.map(near) }
    }

    /// How many cells the horizon needs: those that a circle of `metres` around any place in a cell may touch.
    #[must_use]
    pub fn cells_to(metres: f64, side: f64) -> u16 {
        (metres / side).ceil().clamp(0.0, 1000.0) as u16
    }

    /// Cells along its side.
    #[must_use]
    pub fn side(&self) -> usize {
        (2 * (self.buffer + self.horizon) + 1) as usize
    }

    /// The cell in its middle.
    #[must_use]
    pub fn center(&self) -> CellIndex {
        self.center
    }

    /// Whether a cell is in it.
    #[must_use]
    pub fn contains(&self, cell: CellIndex) -> bool {
        (0..2).all(|axis| away(cell[axis], self.center[axis]) <= i64::from(self.buffer + self.horizon))
    }

    /// Whether the observer in `at` may see something of `cell`.
    #[must_use]
    pub fn is_within_horizon(&self, at: CellIndex, cell: CellIndex) -> bool {
        (0..2).all(|axis| away(cell[axis], near(at[axis])) <= i64::from(self.horizon))
    }

    /// Takes the window along to an observer in `at`; by how many columns and rows it moved.
    pub fn follow(&mut self, at: CellIndex) -> [i32; 2] {
        [0, 1].map(|axis| {
            let away = near(at[axis]) - self.center[axis];
            let excess = away - away.clamp(-self.buffer, self.buffer);
            self.center[axis] += excess;
            excess
        })
    }

    /// All its cells, the nearest to `at` first; those at the same distance by row, then column.
    #[must_use]
    pub fn cells_from(&self, at: CellIndex) -> Vec<CellIndex> {
        let (reach, at) = (self.buffer + self.horizon, at.map(near));
        let [column, row] = self.center;
        let rows = (row - reach)..=(row + reach);
        let mut cells: Vec<CellIndex> =
            rows.flat_map(|row| ((column - reach)..=(column + reach)).map(move |column| [column, row])).collect();
        let away = |cell: &CellIndex| {
            let [x, y] = [0, 1].map(|axis| i64::from(cell[axis]) - i64::from(at[axis]));
            x * x + y * y
        };
        cells.sort_by_key(|cell| (away(cell), cell[1], cell[0]));
        cells
    }
}

fn away(a: i32, b: i32) -> i64 {
    (i64::from(a) - i64::from(b)).abs()
}

fn near(index: i32) -> i32 {
    index.clamp(-FAR, FAR)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_paper_s_example() {
        // Seven columns, 6 to 12, free are 8 to 10. Right past 10: column 6 goes, column 13 comes.
        let mut window = Window::new(1, 2, [9, 9]);
        assert_eq!(window.side(), 7);
        assert!(window.contains([6, 9]) && window.contains([12, 12]) && !window.contains([13, 9]));
        for free in [[8, 8], [10, 9], [10, 10], [9, 8]] {
            assert_eq!(window.follow(free), [0, 0], "{free:?}");
        }
        assert_eq!(window.follow([11, 9]), [1, 0]);
        assert!(!window.contains([6, 9]) && window.contains([13, 9]));
        assert_eq!(window.follow([10, 9]), [0, 0], "and turning back loads nothing");
        assert_eq!(Window::cells_to(2000.0, 240.0), 9);
        assert_eq!(Window::new(1, 9, [0, 0]).side(), 21);
    }

    #[test]
    fn the_horizon_never_passes_the_edge() {
        let (mut state, side) = (1_u64, 240.0);
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        for (buffer, horizon) in [(0, 1), (1, 2), (2, 9), (3, 0)] {
            let mut window = Window::new(buffer, horizon, [0, 0]);
            let (mut place, mut touched) = ([0.0_f64; 2], false);
            for step in 0..250_000 {
                // Straight, diagonal, and now and then a jump across the map.
                let length = if step % 1000 == 999 { 1e5 } else { 400.0 };
                place = place.map(|metres| metres + (random() - 0.5) * length);
                let at = place.map(|metres| (metres / side).floor() as i32);
                let before = window;
                let moved = window.follow(at);
                assert_eq!(window.center(), [before.center[0] + moved[0], before.center[1] + moved[1]]);
                let reach = f64::from(buffer + horizon);
                for axis in 0..2 {
                    let edges = [f64::from(window.center[axis]) - reach, f64::from(window.center[axis]) + reach + 1.0];
                    let [low, high] = edges.map(|edge| edge * side);
                    let far = f64::from(horizon) * side;
                    assert!(place[axis] - far >= low && place[axis] + far <= high, "step {step}");
                    let cell = (at[axis] - window.center[axis]).abs();
                    touched |= cell == i32::from(buffer);
                }
                // No farther than needed: it moved only if the observer left the free cells.
                assert!(
                    (0..2).all(|axis| moved[axis] == 0 || (at[axis] - window.center[axis]).abs() == i32::from(buffer))
                );
            }
            assert!(touched);
        }
    }

    #[test]
    fn nowhere_is_no_overflow() {
        let mut window = Window::new(1, 9, [i32::MIN, i32::MAX]);
        window.follow([i32::MAX, i32::MIN]);
        assert!(window.contains([FAR, -FAR]) && !window.contains([i32::MIN, i32::MAX]));
        assert_eq!(window.cells_from([i32::MAX, i32::MIN]).len(), 21 * 21);
        assert_eq!(window.cells_from([FAR, -FAR])[0], [FAR, -FAR]);
    }
}
