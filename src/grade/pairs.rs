//! Pairs: two mistakes at once, where none alone explains an aspect; and mistakes with what goes along with them in some programs.
//!
//! Part of [`super::search`]. Cost: of pairs, a few names times all mutants on one aspect; of the rest, a hundred mutants times a dozen.

use super::mutants::{Mutant, companions};
use super::search::{Score, Search, margin, most_left};

/// Names that are tried as the first of two mistakes, and pairs that are compared on everything.
const FIRST_OF_PAIR: usize = 8;
const MOST_PAIRS: usize = 60;
/// Aspects that two mistakes at once are tried for: it is what costs most, and seldom helps where it did not before.
const MOST_PAIR_SEARCHES: usize = 2;
/// Mutants that are tried with what may go along with them.
const ACCOMPANIED: usize = 60;

impl Search<'_> {
    /// The first of two mistakes that together explain one aspect, as clearly as one must alone; tried with the best few.
    pub(super) fn of_pair(&mut self, aspect: usize) -> Option<Score> {
        if self.pair_searches == MOST_PAIR_SEARCHES {
            return None;
        }
        self.pair_searches += 1;
        let total = self.left[aspect];
        let (margin, limit) = (margin(total), most_left(total) + margin(total));
        let scores = self.ranked(aspect, total.saturating_sub(1));
        let mut pairs = Vec::new();
        for first in self.best_names(&scores) {
            let rules = self.mutants[first].applied_to(&self.rules);
            for second in (0..self.mutants.len()).filter(|&second| self.can_follow(first, second)) {
                let both = self.mutants[second].applied_to(&rules);
                pairs.extend(self.mismatches(aspect, &both, limit).map(|left| (left, first, second)));
            }
        }
        let least = pairs.iter().map(|pair| pair.0).min()?;
        pairs.retain(|pair| pair.0 < least + margin);
        if least > most_left(total) || pairs.len() > MOST_PAIRS {
            return None;
        }
        // What the aspect cannot tell apart, all of them together may.
        let everywhere = |&(_, first, second): &(usize, usize, usize)| {
            let rules = self.mutants[second].applied_to(&self.mutants[first].applied_to(&self.rules));
            let left =
                (0..self.aspects.len()).filter_map(|aspect| self.mismatches(aspect, &rules, usize::MAX)).sum::<usize>();
            (left, first, second)
        };
        let mut pairs: Vec<_> = pairs.iter().map(everywhere).collect();
        pairs.sort_unstable();
        let names = |pair: &(usize, usize, usize)| {
            let mut names = [self.mutants[pair.1].name, self.mutants[pair.2].name];
            names.sort_unstable();
            names
        };
        let rival = pairs.iter().find(|pair| names(pair) != names(&pairs[0]));
        let is_clear = rival.is_none_or(|rival| rival.0 >= pairs[0].0 + margin);
        scores.iter().find(|score| score.mutant == pairs[0].1).filter(|_| is_clear).copied()
    }

    fn can_follow(&self, first: usize, second: usize) -> bool {
        self.mutants[second].name != self.mutants[first].name && !self.is_old(&self.mutants[second])
    }

    /// The best mutant of each of the best few names.
    fn best_names(&self, scores: &[Score]) -> Vec<usize> {
        let mut best: Vec<usize> = Vec::new();
        for score in scores.iter().filter(|score| !self.is_old(&self.mutants[score.mutant])) {
            if best.len() < FIRST_OF_PAIR
                && best.iter().all(|&other| self.mutants[other].name != self.mutants[score.mutant].name)
            {
                best.push(score.mutant);
            }
        }
        best
    }

    /// Adds to the mutants those that do best where most is wrong, each with what goes along with it in some programs.
    pub(super) fn accompany(&mut self) {
        if self.is_accompanied {
            return;
        }
        self.is_accompanied = true;
        let Some(aspect) = (0..self.left.len()).max_by_key(|&aspect| self.left[aspect]) else { return };
        let scores = self.ranked(aspect, self.left[aspect].saturating_sub(1));
        let mut added: Vec<Mutant> = Vec::new();
        for score in scores.iter().filter(|score| self.mutants[score.mutant].is_plain()).take(ACCOMPANIED) {
            let mutant = self.mutants[score.mutant];
            let own = mutant.applied_to(&self.rules);
            for beside in companions() {
                let one = mutant.beside(*beside);
                let rules = one.applied_to(&self.rules);
                if rules != own && score.here > 0 && self.mismatches(aspect, &rules, score.here - 1).is_some() {
                    added.push(one);
                }
            }
        }
        self.table.borrow_mut().extend(added.iter().map(|_| vec![None; self.aspects.len()]));
        self.mutants.extend(added);
    }
}
