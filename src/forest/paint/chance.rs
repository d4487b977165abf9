//! Chance: the numbers of one picture, one after the other.
//!
//! seed -CHANCE-> shares, directions, noise that repeats
//!
//! Here a generator with a state is right: a picture is painted as a whole, by one thread. Only the four operations, square roots and `libm`
//! are used, so a picture is the same on every machine.

use crate::forest::random::{key, mix64, unit};
use crate::math::{PI, cos, sin};

/// Numbers in a row.
pub(super) struct Chance {
    state: u64,
}

impl Chance {
    pub(super) fn new(words: &[u64]) -> Chance {
        Chance { state: key(words) }
    }

    /// 0 to 1.
    pub(super) fn share(&mut self) -> f64 {
        self.state = mix64(self.state);
        unit(self.state)
    }

    /// `low` to `high`.
    pub(super) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.share()
    }

    /// -1 to 1, near 0 more often.
    pub(super) fn around(&mut self) -> f64 {
        self.share() + self.share() - 1.0
    }

    /// A direction in the plane.
    pub(super) fn direction(&mut self) -> [f64; 2] {
        let angle = 2.0 * PI * self.share();
        [cos(angle), sin(angle)]
    }

    /// A direction in space, all alike.
    pub(super) fn normal(&mut self) -> [f64; 3] {
        let y = self.between(-1.0, 1.0);
        let around = (1.0 - y * y).sqrt();
        let [x, z] = self.direction();
        [x * around, y, z * around]
    }
}

/// Smooth noise, -1 to 1, that repeats after `cells` lattice cells: x and y from 0 to 1 over all of them.
pub(super) fn noise(seed: u64, x: f64, y: f64, cells: u32) -> f64 {
    let (x, y) = (x * f64::from(cells), y * f64::from(cells));
    let (column, row) = (x.floor(), y.floor());
    let [fx, fy] = [x - column, y - row].map(|share| share * share * (3.0 - 2.0 * share));
    let value = |dx: i64, dy: i64| {
        let [i, j] = [column as i64 + dx, row as i64 + dy].map(|index| index.rem_euclid(i64::from(cells)) as u64);
        2.0 * unit(key(&[seed, u64::from(cells), i, j])) - 1.0
    };
    let lower = value(0, 0) + (value(1, 0) - value(0, 0)) * fx;
    let upper = value(0, 1) + (value(1, 1) - value(0, 1)) * fx;
    lower + (upper - lower) * fy
}

/// Noise on noise: each octave twice as fine and half as strong; about -1 to 1.
pub(super) fn octaves(seed: u64, x: f64, y: f64, cells: u32, count: u32) -> f64 {
    let octave = |index: u32| noise(seed + u64::from(index), x, y, cells << index) / f64::from(1_u32 << index);
    (0..count).map(octave).sum::<f64>() / 1.5
}
