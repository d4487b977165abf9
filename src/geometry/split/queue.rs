//! Queue: which corner is cut next.
//!
//! A heap alone would do, but a million entries do not fit in the processor's cache and every step of a heap is a
//! jump in memory. So only the front of the queue is a heap; the rest lies in a pile, which is looked through from one end to
//! the other when the heap has run empty. Entries that have gone out of date are thrown out then.
//!
//! Cost: O(log n) an entry, with a small heap.

use super::fit::Fit;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// A corner in the order of cutting: better rank, then shorter diagonal, then lower index. Packed so that one comparison does it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Candidate(u128);

/// How good a corner is for cutting, best first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Rank {
    /// Two of the three vertices are in one place: the triangle has no area wherever they are moved.
    Collapsed,
    /// Convex, and as far as known nothing is in the way.
    Ear,
    /// Something touches the ear's border.
    TouchedEar,
    /// The three vertices are on one line.
    Flat,
    /// Something runs along the ear's border, and cutting flat corners has not cleared it away.
    DoubtfulEar,
    /// Convex, and something is inside.
    Forced,
    /// Not convex.
    Reflex,
}

const RANKS: [Rank; 7] =
    [Rank::Collapsed, Rank::Ear, Rank::TouchedEar, Rank::Flat, Rank::DoubtfulEar, Rank::Forced, Rank::Reflex];

impl Rank {
    /// The rank of a convex corner.
    pub(super) fn of_ear(fit: Fit) -> Rank {
        match fit {
            Fit::Free => Rank::Ear,
            Fit::Touched => Rank::TouchedEar,
            Fit::Doubtful => Rank::DoubtfulEar,
            Fit::Blocked => Rank::Forced,
        }
    }
}

impl Candidate {
    /// The mark of a corner that has been cut.
    pub(super) const NONE: Candidate = Candidate(u128::MAX);

    /// `dimension` is positive, and the bits of positive numbers are ordered like the numbers.
    pub(super) fn new(rank: Rank, dimension: f64, vertex: u32) -> Candidate {
        Candidate((rank as u128) << 96 | u128::from(dimension.to_bits()) << 32 | u128::from(vertex))
    }

    pub(super) fn rank(self) -> Rank {
        RANKS[(self.0 >> 96) as usize]
    }

    pub(super) fn vertex(self) -> u32 {
        self.0 as u32
    }

    pub(super) fn with_rank(self, rank: Rank) -> Candidate {
        Candidate((rank as u128) << 96 | self.0 & ((1 << 96) - 1))
    }
}

/// Candidates, the best first. Its memory is reused.
#[derive(Debug)]
pub(super) struct Queue {
    /// All candidates up to `limit`.
    front: BinaryHeap<Reverse<Candidate>>,
    /// All others.
    pile: Vec<Candidate>,
    limit: Candidate,
}

/// The front takes this share of the pile, but at least `SMALL`.
const SHARE: usize = 8;
const SMALL: usize = 1024;

impl Default for Queue {
    fn default() -> Self {
        Queue { front: BinaryHeap::new(), pile: Vec::new(), limit: Candidate(0) }
    }
}

impl Queue {
    pub(super) fn clear(&mut self) {
        self.front.clear();
        self.pile.clear();
        self.limit = Candidate(0);
    }

    pub(super) fn push(&mut self, candidate: Candidate) {
        if candidate <= self.limit { self.front.push(Reverse(candidate)) } else { self.pile.push(candidate) }
    }

    /// Takes out the best candidate that is still `current`.
    pub(super) fn pop(&mut self, current: impl Fn(Candidate) -> bool) -> Option<Candidate> {
        loop {
            while let Some(Reverse(candidate)) = self.front.pop() {
                if current(candidate) {
                    return Some(candidate);
                }
            }
            self.pile.retain(|&candidate| current(candidate));
            if self.pile.is_empty() {
                return None;
            }

            // Move the best of the pile to the front.
            let moved = (self.pile.len() / SHARE).max(SMALL);
            self.limit = Candidate::NONE;
            let mut kept = 0;
            if moved < self.pile.len() {
                kept = self.pile.len() - moved;
                self.limit = *self.pile.select_nth_unstable_by(kept, |a, b| b.cmp(a)).1;
            }
            self.front.extend(self.pile.drain(kept..).map(Reverse));
        }
    }
}
