//! Site: a cell while its trees are placed.
//!
//! positions -SITE-> those on their stand's own land, off the roads, with a height and a picture
//!
//! Space: 1/65,536 of the cell's side. Cost: a look-up of the owner and of the ground a tree.

use super::{MEASURED, MOST_TREES, Tree};
use crate::forest::area::{Cell, Head, Owner, Plant, StandState};
use crate::forest::land::Land;
use crate::forest::random::{key, mix64};

/// A cell while its trees are placed.
pub(super) struct Site<'a> {
    pub(super) head: &'a Head,
    pub(super) cell: &'a Cell,
    pub(super) land: Land<'a>,
    /// By stand.
    pub(super) states: Vec<Option<&'a StandState>>,
    /// How many pictures its trees choose from, by stand.
    pub(super) pictures: Vec<u16>,
    pub(super) ground: &'a dyn Fn([f64; 2]) -> f64,
    pub(super) base: f64,
    pub(super) trees: Vec<Tree>,
}

impl Site<'_> {
    /// What all numbers of a stand in this cell begin with.
    pub(super) fn key(&self, stand: usize) -> u64 {
        let [column, row] = self.cell.index.map(|index| index as u32 as u64);
        key(&[self.head.seed, (column << 32) | row, self.cell.seed, u64::from(self.cell.stands[stand].number)])
    }

    /// The stands, each once, among some patches.
    pub(super) fn stands_of(&self, patches: impl Iterator<Item = usize>) -> Vec<usize> {
        let stand = |patch: usize| match self.cell.patches[patch].owner {
            Owner::Stand(stand) => Some(stand as usize).filter(|&stand| stand < self.states.len()),
            Owner::Cover(_) => None,
        };
        let mut stands: Vec<usize> = patches.filter_map(stand).collect();
        stands.sort_unstable();
        stands.dedup();
        stands
    }

    /// Plants a tree of a stand if that is the stand's land, and neither road nor river.
    #[inline]
    pub(super) fn plant(&mut self, stand: usize, place: [u16; 2]) {
        self.plant_at(stand, place, self.ground);
    }

    pub(super) fn plant_at(&mut self, stand: usize, place: [u16; 2], ground: &dyn Fn([f64; 2]) -> f64) {
        let mut tree = Tree { x: place[0], y: place[1], z: 0, kind: 0 };
        let at = tree.at(self.head.side);
        let owner = self.land.patch_at(at).map(|patch| self.cell.patches[patch].owner);
        let is_full = self.trees.len() > MOST_TREES;
        if owner != Some(Owner::Stand(stand as u32)) || is_full || self.land.is_on_line(at) {
            return;
        }
        let z = ground(at);
        if z.is_finite() {
            let count = u64::from(self.pictures[stand]);
            let own = || ((mix64((u64::from(place[0]) << 16) | u64::from(place[1])) >> 32) * count) >> 32;
            let picture = self.states[stand]
                .and_then(|state| state.picture)
                .map_or_else(own, |picture| u64::from(picture) % count);
            tree.z = sixteenths(z - self.base);
            tree.kind = (stand as u16) << 4 | picture as u16;
            self.trees.push(tree);
        }
    }

    pub(super) fn add_measured(&mut self) {
        let side = self.head.side;
        for (index, tree) in self.cell.trees.iter().enumerate() {
            let z = (self.ground)(tree.at);
            // Whoever stands on the far border stands in its last step.
            let [x, y] = tree.at.map(|metres| (metres / side * 65_536.0) as u16);
            if z.is_finite() {
                self.trees.push(Tree { x, y, z: sixteenths(z - self.base), kind: MEASURED | index as u16 });
            }
        }
    }
}

/// Metres as [`Tree::z`]; saturates beyond 2 km.
fn sixteenths(metres: f64) -> i16 {
    (metres * 16.0).round() as i16
}

/// Stands of this kind of planting, with their state, among all of a cell.
pub(super) fn planted(states: &[Option<&StandState>], is_kind: impl Fn(Plant) -> bool) -> Vec<bool> {
    states.iter().map(|state| state.is_some_and(|state| is_kind(state.plant) && state.density > 0.0)).collect()
}
