//! Horizon: how high the land hides what is behind it, in every direction around the eye.
//!
//! cells from near to far -HORIZON-> is a group of trees wholly hidden?
//!
//! A ray from the eye across a piece of land is above that land's lowest point, or it ends there. So a piece whose lowest point looks steeper than
//! some slope hides everything behind it that looks flatter, in the directions it covers *wholly*. This is careful on all sides: lowest
//! points, far edges, whole sectors; what it hides no picture shows (`what_is_hidden_is_behind_land`). It misses much; what it finds costs nothing
//! to draw.
//!
//! Space: directions on the map as numbers from 0 to [`SECTORS`], slopes as metres up per metre ahead.
//! Source: ours; the floating horizon is older: T. Wright, "A Two-Space Solution to the Hidden Line Problem for Plotting Functions
//! of Two Variables", IEEE Trans. Computers C-22, 1973. Cost: a few operations a piece and sector.

use super::{Kind, Terrain};
use crate::forest::area::CellIndex;
use crate::math::Vec3;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Directions that are told apart.
pub const SECTORS: usize = 512;

/// The horizon of one eye, as far as land has been added.
#[derive(Clone, Debug, Default)]
pub struct Horizon {
    eye: Vec3,
    /// The steepest slope that hides, by sector.
    slopes: Vec<f64>,
    /// Land that begins to hide at a distance: bits of the distance, first sector, count, bits of the slope.
    waiting: BinaryHeap<Reverse<(u64, u32, u32, u64)>>,
}

/// A square on the map.
#[derive(Clone, Copy, Debug)]
pub struct Square {
    /// South-west corner, world metres.
    pub corner: [f64; 2],
    /// Metres.
    pub side: f64,
}

impl Horizon {
    /// Forgets all land and looks from `eye`.
    pub fn start(&mut self, eye: Vec3) {
        self.eye = eye;
        self.slopes.clear();
        self.slopes.resize(SECTORS, f64::NEG_INFINITY);
        self.waiting.clear();
    }

    /// Lets land hide that ends nearer than `distance` metres.
    pub fn advance(&mut self, distance: f64) {
        while let Some(&Reverse((bits, first, count, slope))) = self.waiting.peek() {
            if f64::from_bits(bits) > distance {
                break;
            }
            self.waiting.pop();
            for sector in first..first + count {
                let hides = &mut self.slopes[sector as usize % SECTORS];
                *hides = hides.max(f64::from_bits(slope));
            }
        }
    }

    /// Adds a square of land nowhere lower than `lowest`; it hides from its far end on.
    pub fn add(&mut self, square: Square, lowest: f64) {
        let Some((sectors, [near, far])) = self.spread(square) else { return };
        // Only directions that the square covers from border to border.
        let (first, end) = (sectors[0].ceil(), sectors[1].floor());
        if near <= 0.0 || end <= first {
            return;
        }
        let rise = lowest - self.eye.z;
        let slope = if rise > 0.0 { rise / far } else { rise / near };
        let first = first.rem_euclid(SECTORS as f64) as u32;
        let count = ((end - sectors[0].ceil()) as u32).min(SECTORS as u32);
        self.waiting.push(Reverse((far.to_bits(), first, count, slope.to_bits())));
    }

    /// Whether land hides everything over a square that is nowhere higher than `highest`. Asks only what was added and is nearer.
    #[must_use]
    pub fn hides(&self, square: Square, highest: f64) -> bool {
        let Some((sectors, [near, far])) = self.spread(square) else { return false };
        if near <= 0.0 {
            return false;
        }
        let rise = highest - self.eye.z;
        let slope = if rise > 0.0 { rise / near } else { rise / far };
        let (first, end) = (sectors[0].floor() as i64, sectors[1].ceil() as i64);
        (first..end).all(|sector| self.slopes[sector.rem_euclid(SECTORS as i64) as usize] > slope)
    }

    /// Directions of a square, from its right to its left border seen from the eye, and its nearest and farthest distance; `None` around the eye.
    fn spread(&self, square: Square) -> Option<([f64; 2], [f64; 2])> {
        let [west, south] = [square.corner[0] - self.eye.x, square.corner[1] - self.eye.y];
        let (east, north) = (west + square.side, south + square.side);
        if west <= 0.0 && east >= 0.0 && south <= 0.0 && north >= 0.0 {
            return None;
        }
        let corners = [[west, south], [east, south], [east, north], [west, north]];
        let middle = direction([west + east, south + north]);
        let half = SECTORS as f64 / 2.0;
        let mut sectors = [f64::INFINITY, f64::NEG_INFINITY];
        for corner in corners {
            // Counted from the middle, so that no square is cut by the end of the numbers.
            let away = (direction(corner) - middle + half).rem_euclid(SECTORS as f64) - half;
            sectors = [sectors[0].min(away), sectors[1].max(away)];
        }
        let near = [west.max(-east).max(0.0), south.max(-north).max(0.0)];
        let far = corners.map(|[x, y]| (x * x + y * y).sqrt()).into_iter().fold(0.0, f64::max);
        let near = (near[0] * near[0] + near[1] * near[1]).sqrt();
        (near.is_finite() && far.is_finite()).then_some(([middle + sectors[0], middle + sectors[1]], [near, far]))
    }
}

/// A number from 0 to [`SECTORS`] that grows counterclockwise with the direction, without an arc tangent: the way around a square.
fn direction([x, y]: [f64; 2]) -> f64 {
    let share = y / (x.abs() + y.abs());
    let around = if x >= 0.0 { share } else { 2.0 - share };
    around.rem_euclid(4.0) * (SECTORS as f64 / 4.0)
}

impl Terrain {
    /// Adds a cell's land to a horizon, lowered by `error` metres: as far as what is drawn may be below what was measured.
    pub fn add_to(&self, horizon: &mut Horizon, cell: CellIndex, error: f64) {
        let Some(outline) = self.outline(cell).filter(|outline| outline.kind == Kind::Lattice) else { return };
        let [west, south] = cell.map(|index| f64::from(index) * self.side);
        let half = self.side / 2.0;
        for (quarter, &lowest) in outline.quarters.iter().enumerate() {
            let corner = [west + half * (quarter & 1) as f64, south + half * (quarter >> 1) as f64];
            horizon.add(Square { corner, side: half }, f64::from(lowest) - error);
        }
        horizon.add(Square { corner: [west, south], side: self.side }, f64::from(outline.ground[0]) - error);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_grow_all_around() {
        let mut last = -1.0;
        for step in 0..1000 {
            let turn = f64::from(step) / 1000.0 * 2.0 * crate::math::PI;
            let now = direction([crate::math::cos(turn), crate::math::sin(turn)]);
            assert!(now > last && now < SECTORS as f64, "{step}: {now}");
            last = now;
        }
        assert_eq!(direction([0.0, 1.0]), SECTORS as f64 / 4.0);
    }

    #[test]
    fn what_is_hidden_is_behind_land() {
        // Walls of random squares; hidden squares are checked with rays, one by one.
        let (mut state, mut hidden) = (7_u64, 0);
        let mut random = move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        for _ in 0..300 {
            let eye = Vec3::new(random() * 10.0, random() * 10.0, 100.0);
            let squares: Vec<(Square, f64)> = (0..40)
                .map(|_| {
                    let corner = [random() * 400.0 - 200.0, random() * 400.0 - 200.0];
                    (Square { corner, side: 10.0 + 60.0 * random() }, 60.0 + 90.0 * random())
                })
                .collect();
            let mut horizon = Horizon::default();
            horizon.start(eye);
            squares.iter().for_each(|&(square, lowest)| horizon.add(square, lowest));
            let target = Square { corner: [random() * 600.0 - 300.0, random() * 600.0 - 300.0], side: 20.0 };
            let highest = 60.0 + 60.0 * random();
            let Some((_, [near, _])) = horizon.spread(target) else { continue };
            horizon.advance(near);
            if !horizon.hides(target, highest) {
                continue;
            }
            hidden += 1;
            for index in 0..64 {
                let share = [f64::from(index % 8) / 7.0, f64::from(index / 8) / 7.0];
                let point = [0, 1].map(|axis| target.corner[axis] + target.side * share[axis]);
                let meets = |&(square, lowest): &(Square, f64)| {
                    (0..2000).any(|step| {
                        let t = f64::from(step) / 2000.0;
                        let at = [eye.x + (point[0] - eye.x) * t, eye.y + (point[1] - eye.y) * t];
                        let z = eye.z + (highest - eye.z) * t;
                        z < lowest
                            && (0..2).all(|a| (square.corner[a]..=square.corner[a] + square.side).contains(&at[a]))
                    })
                };
                assert!(squares.iter().any(meets), "{point:?} shows");
            }
        }
        assert!(hidden > 10, "{hidden}");
    }
}
