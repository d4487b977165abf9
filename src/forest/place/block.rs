//! Block: trees anywhere, or one in each square, block by block.
//!
//! Stand -> blocks of 1/8 of the cell's side -BLOCK-> positions in order of their rank
//!
//! Why blocks: a sequence over the whole cell would mostly fall on other stands' land; and trees that come block by block are near each other, which the
//! rasterizer likes. Every block has its own sequence, whatever part of it the stand owns.
//!
//! Why ranks: a tree has a rank, the density from which on it is there. The stand takes all ranks below its density: thinning takes trees away and
//! moves none. *Poisson*: ranks are sums of exponential steps, so the trees below any density are a Poisson process of that density.
//! *Jittered*: a square with a tree is cut in four, the quarter that has the tree keeps it and the other three get one each, at ranks that
//! fill the three densities in between; and so on. New trees stand in the middle half of their square, so two trees are nowhere nearer than a quarter of the side of the smallest squares.
//!
//! Space: 1/65,536 of the cell's side; ranks in trees a block.
//! Cost: one mix, one logarithm (Poisson only), one look-up of the owner a tree.

use super::{Site, planted};
use crate::forest::area::Plant;
use crate::forest::land::SQUARES;
use crate::forest::random::{mix64, unit};

/// Blocks along a side of a cell.
const BLOCKS: usize = 8;
/// Steps along a side of a block.
const STEPS: u16 = (65_536 / BLOCKS) as u16;
/// The odd number that SplitMix64 counts by.
const GOLDEN: u64 = 0x9E37_79B9_7F4A_7C15;

pub(super) fn grow(site: &mut Site) {
    let is_here = planted(&site.states, |plant| plant != Plant::Rows);
    let keys: Vec<u64> = (0..site.states.len()).map(|stand| site.key(stand)).collect();
    let hectares = (site.head.side / BLOCKS as f64) * (site.head.side / BLOCKS as f64) / 1e4;
    let squares = |block: usize| block * SQUARES / BLOCKS..(block + 1) * SQUARES / BLOCKS;
    for block in 0..BLOCKS * BLOCKS {
        let (column, row) = (block % BLOCKS, block / BLOCKS);
        let near: Vec<usize> = site.land.patches_in(squares(column), squares(row)).collect();
        for stand in site.stands_of(near.into_iter()) {
            let Some(state) = site.states[stand].filter(|_| is_here[stand]) else { continue };
            let sequence = Sequence {
                key: mix64(keys[stand] ^ block as u64),
                corner: [column, row].map(|index| index as u16 * STEPS),
                below: state.density * hectares,
                stand,
            };
            match state.plant {
                Plant::Jittered => sequence.jittered(site),
                _ => sequence.poisson(site),
            }
        }
    }
}

/// The trees of a stand in a block.
struct Sequence {
    key: u64,
    /// South-west corner of the block.
    corner: [u16; 2],
    /// Trees with a lower rank are there.
    below: f64,
    stand: usize,
}

/// A square of a block that has a tree.
#[derive(Clone, Copy)]
struct Square {
    low: [u16; 2],
    side: u16,
    tree: [u16; 2],
}

impl Sequence {
    fn poisson(&self, site: &mut Site) {
        let mut rank = 0.0;
        for number in 0_u64.. {
            let bits = mix64(self.key.wrapping_add(number.wrapping_mul(GOLDEN)));
            // 38 bits of chance for the step, 13 for each coordinate; never the logarithm of 0.
            rank -= libm::log(((bits >> 26) + 1) as f64 / (1_u64 << 38) as f64);
            if rank >= self.below {
                return;
            }
            let place = [bits & 0x1FFF, (bits >> 13) & 0x1FFF];
            site.plant(self.stand, [self.corner[0] + place[0] as u16, self.corner[1] + place[1] as u16]);
        }
    }

    fn jittered(&self, site: &mut Site) {
        let bits = mix64(self.key);
        if unit(bits) < self.below {
            let tree = middle(self.corner, STEPS, mix64(bits));
            site.plant(self.stand, tree);
            self.quarter(site, Square { low: self.corner, side: STEPS, tree }, 1.0);
        }
    }

    /// Cuts a square with a tree in four, of which each gets a tree if its rank is low enough; `full` trees a block have it so far.
    fn quarter(&self, site: &mut Site, square: Square, full: f64) {
        let side = square.side / 2;
        if full >= self.below || side < 8 {
            return;
        }
        let own = [0, 1].map(|axis| usize::from(square.tree[axis] >= square.low[axis] + side));
        let bits = mix64(
            self.key ^ mix64(u64::from(square.low[0]) << 32 | u64::from(square.low[1]) << 16 | u64::from(square.side)),
        );
        let mut third = bits % 3;
        for child in 0..4 {
            let part = [child & 1, child >> 1];
            let low = [0, 1].map(|axis| square.low[axis] + part[axis] as u16 * side);
            if part == own {
                self.quarter(site, Square { low, side, ..square }, 4.0 * full);
                continue;
            }
            let own_bits = mix64(bits ^ child as u64);
            let rank = full * (1.0 + third as f64 + unit(own_bits));
            // Round or the other way round: each of the three gets a third of its own.
            third = (third + 1 + (bits >> 60) % 2) % 3;
            if rank < self.below {
                let tree = middle(low, side, mix64(own_bits));
                site.plant(self.stand, tree);
                self.quarter(site, Square { low, side, tree }, 4.0 * full);
            }
        }
    }
}

/// A place in the middle half of a square.
fn middle(low: [u16; 2], side: u16, bits: u64) -> [u16; 2] {
    let step = |share: u64| side / 4 + (((share & 0xFFFF_FFFF) * u64::from(side / 2)) >> 32) as u16;
    [low[0] + step(bits), low[1] + step(bits >> 32)]
}
