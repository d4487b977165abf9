//! Rows: trees as a planting machine sets them.
//!
//! Stand, its number -ROWS-> positions on a lattice of the world
//!
//! Why of the world: a plantation goes on over the border of a cell, and so do its rows. The lattice hangs on the stand's number and on its densest state, so
//! thinning takes trees out of rows that stay where they are. Rows are half as far apart again as the trees in them.
//!
//! Space: world metres; every lattice point is in the one cell that [`Head::cell_at`](crate::forest::area::Head::cell_at) says.
//! Cost: a lattice point in the stand's box costs a mix and a few products.

use super::{Site, planted};
use crate::forest::area::{Owner, Plant, StandState};
use crate::forest::random::{key, mix64, unit};
use crate::math::{PI, cos, sin};

/// How far rows are apart, in distances of trees in them.
const APART: f64 = 1.5;
/// How far a tree is from its lattice point, in distances, at most.
const JITTER: f64 = 0.12;

pub(super) fn grow(site: &mut Site) {
    let is_here = planted(&site.states, |plant| plant == Plant::Rows);
    for (stand, is_here) in is_here.into_iter().enumerate() {
        if let Some(state) = site.states[stand].filter(|_| is_here) {
            Lattice::of(site, stand, state).plant(site);
        }
    }
}

/// The places of a stand's trees, all over the world.
struct Lattice {
    stand: usize,
    key: u64,
    /// Metres from tree to tree along the row, and from row to row.
    steps: [[f64; 2]; 2],
    distance: f64,
    /// The share of places that have a tree.
    share: f64,
}

impl Lattice {
    fn of(site: &Site, stand: usize, state: &StandState) -> Lattice {
        let densest = site.cell.stands[stand].states.iter().map(|state| state.density).fold(state.density, f64::max);
        let key = key(&[site.head.seed, u64::from(site.cell.stands[stand].number)]);
        let distance = (1e4 / densest / APART).sqrt();
        let angle = PI * unit(key);
        let along = [cos(angle), sin(angle)];
        let steps = [along.map(|part| part * distance), [-along[1] * distance * APART, along[0] * distance * APART]];
        Lattice { stand, key, steps, distance, share: state.density / densest }
    }

    /// Plants the trees of one cell.
    fn plant(&self, site: &mut Site) {
        let corner = site.head.corner(site.cell.index);
        let Some([low, high]) = bounds(site, self.stand) else { return };
        // Ranges of lattice coordinates over the box, with room for the jitter.
        let coordinate = |axis: usize, at: [f64; 2]| {
            let step = self.steps[axis];
            (step[0] * (corner.x + at[0]) + step[1] * (corner.y + at[1])) / (step[0] * step[0] + step[1] * step[1])
        };
        let corners = [low, [high[0], low[1]], high, [low[0], high[1]]];
        let range = |axis: usize| {
            let all = corners.map(|at| coordinate(axis, at));
            let (first, last) = all.iter().fold((f64::MAX, f64::MIN), |(a, b), &c| (a.min(c), b.max(c)));
            (first - 1.0).floor() as i64..=(last + 1.0).ceil() as i64
        };
        for row in range(1) {
            for number in range(0) {
                self.plant_one(site, number, row);
            }
        }
    }

    fn plant_one(&self, site: &mut Site, number: i64, row: i64) {
        let bits = mix64(self.key ^ mix64((number as u64) << 32 ^ row as u64 & 0xFFFF_FFFF));
        if unit(bits) >= self.share {
            return;
        }
        let more = mix64(bits);
        let jitter = [more & 0xFFFF_FFFF, more >> 32]
            .map(|bits| (bits as f64 / (1_u64 << 31) as f64 - 1.0) * JITTER * self.distance);
        let world =
            [0, 1].map(|axis| number as f64 * self.steps[0][axis] + row as f64 * self.steps[1][axis] + jitter[axis]);
        if site.head.cell_at(world) == site.cell.index {
            let corner = site.head.corner(site.cell.index);
            let steps = |metres: f64| (metres / site.head.side * 65_536.0) as u16;
            site.plant(self.stand, [steps(world[0] - corner.x), steps(world[1] - corner.y)]);
        }
    }
}

/// The box around the patches of a stand, within the cell.
fn bounds(site: &Site, stand: usize) -> Option<[[f64; 2]; 2]> {
    let own = site.cell.patches.iter().filter(|patch| patch.owner == Owner::Stand(stand as u32));
    let corners: Vec<[f64; 2]> = own.flat_map(|patch| patch.outer.iter().copied()).collect();
    let (mut low, mut high) = (*corners.first()?, *corners.first()?);
    for corner in &corners {
        for axis in 0..2 {
            low[axis] = low[axis].min(corner[axis]);
            high[axis] = high[axis].max(corner[axis]);
        }
    }
    let side = site.head.side;
    Some([low.map(|metres| metres.clamp(0.0, side)), high.map(|metres| metres.clamp(0.0, side))])
}
