//! Size: how tall and how wide a tree is, found again whenever somebody looks.
//!
//! Tree, Cell, year -SIZE-> height, crown, turn, tint
//!
//! Why not kept: 8 bytes a tree instead of 24, and two million trees around the observer. A size depends on the place of the tree, the seed and its
//! stand, not on the year: as the stand's mean grows, a tree that is tall among its neighbors stays so.
//!
//! Space: metres; turns in radians. Cost: two mixes, two look-ups in a table of 4 kB.

use super::Tree;
use crate::forest::area::{Cell, Head, Spread};
use crate::forest::random::{Normal, key, mix64};
use crate::math::{PI, radians};

/// What a tree looks like.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Size {
    /// Metres from the foot to the top.
    pub height: f64,
    /// Diameter of the crown in metres.
    pub crown: f64,
    /// Turned by this much, radians counterclockwise seen from above.
    pub turn: f64,
    /// 0 to 1: how light or dark it is among its kind.
    pub tint: f64,
    /// Index into [`Head::species`].
    pub species: u16,
    /// Chance of its own, for whatever else: which of its neighbors fade first, say.
    pub chance: u32,
}

/// Finds the sizes of a cell's trees in a year.
pub struct Sizes<'a> {
    cell: &'a Cell,
    key: u64,
    /// Height, crown, species by stand.
    stands: Vec<(Spread, Spread, u16)>,
    normal: &'static Normal,
}

/// The size of one tree. Whoever wants many asks [`Sizes`], which looks the stands up once.
#[must_use]
pub fn size_of(head: &Head, cell: &Cell, year: Option<i32>, tree: Tree) -> Size {
    Sizes::new(head, cell, year).of(tree)
}

impl<'a> Sizes<'a> {
    /// Looks up what the stands are in that year.
    #[must_use]
    pub fn new(head: &Head, cell: &'a Cell, year: Option<i32>) -> Sizes<'a> {
        let state = |stand: &crate::forest::area::Stand| {
            stand.in_year(year).map_or(Default::default(), |state| (state.height, state.crown, state.species))
        };
        let [column, row] = cell.index.map(|index| index as u32 as u64);
        let key = key(&[head.seed, (column << 32) | row, cell.seed, SIZES]);
        Sizes { cell, key, stands: cell.stands.iter().map(state).collect(), normal: Normal::shared() }
    }

    /// The size of a tree of this cell; all zero for a tree of another.
    #[must_use]
    #[inline]
    pub fn of(&self, tree: Tree) -> Size {
        let stand = tree.stand().map_or(0, |stand| stand as u64 + 1);
        let bits = mix64(self.key ^ (u64::from(tree.x) << 32 | u64::from(tree.y) << 16 | stand));
        let more = mix64(bits);
        let turn = (more & 0xFFFF) as f64 / 65_536.0 * 2.0 * PI;
        let tint = (more >> 16 & 0xFFFF) as f64 / 65_536.0;
        let chance = (more >> 32) as u32;
        if let Some(index) = tree.measured() {
            return self.cell.trees.get(index).map_or(NOTHING, |tree| Size {
                height: tree.height,
                crown: tree.crown,
                turn: radians(tree.turn),
                tint,
                species: tree.species,
                chance,
            });
        }
        let Some(&(height, crown, species)) = tree.stand().and_then(|stand| self.stands.get(stand)) else {
            return NOTHING;
        };
        let [height, crown] =
            [(height, bits as u32), (crown, (bits >> 32) as u32)].map(|(spread, bits)| self.vary(spread, bits));
        Size { height, crown, turn, tint, species, chance }
    }

    /// A number around a mean: normal, at most 2.5 deviations away, at least a twentieth of the mean.
    fn vary(&self, spread: Spread, bits: u32) -> f64 {
        (spread.mean + spread.deviation * self.normal.at(bits)).max(0.05 * spread.mean)
    }
}

/// Tells the numbers of sizes from those of places.
const SIZES: u64 = 0x5153;
const NOTHING: Size = Size { height: 0.0, crown: 0.0, turn: 0.0, tint: 0.0, species: 0, chance: 0 };
