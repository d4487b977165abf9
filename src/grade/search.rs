//! Search: which mistakes, one after another, explain the wrong pixels.
//!
//! Cost: every mutant draws every case once a round, but stops as soon as it leaves more pixels wrong than could name it.

use super::diagnose::Fault;
use super::labs::Lab;
use super::mutants::{self, Mutant};
use super::paint::paint;
use super::rules::Rules;
use super::verdict::{AspectVerdict, Shot, wrong};
use std::cell::RefCell;

/// Mistakes behind which there is nothing to be graded yet: what follows from them earns nothing.
pub(super) const UNFORGIVEN: [&str; 2] = ["nothing drawn", "corners only"];
/// Part of the mismatches that a named mistake leaves at most, and by which it beats the next.
pub(super) const MARGIN: f64 = 0.05;
/// The same for a mistake that leaves nothing.
const MARGIN_OF_ALL: f64 = 0.01;
/// Names that are tried as the first of two mistakes, and pairs that are compared on everything.
const FIRST_OF_PAIR: usize = 8;
const MOST_PAIRS: usize = 60;
/// Aspects that two mistakes at once are tried for: it is what costs most, and seldom helps where it did not before.
const MOST_PAIR_SEARCHES: usize = 2;
/// More mistakes in one rasterizer are not told apart.
const MOST_FAULTS: usize = 5;
/// Aspects that a mistake must explain whole to stand beside what nothing explains.
const WHOLE_ASPECTS: usize = 2;

/// Pixels of all pictures that are not as the rules say.
pub(super) fn mismatches(shots: &[Shot], rules: &Rules) -> usize {
    mismatches_up_to(shots, rules, usize::MAX)
}

/// The same; counting ends above `most`.
fn mismatches_up_to(shots: &[Shot], rules: &Rules, most: usize) -> usize {
    let mut sum = 0;
    for shot in shots {
        sum += shot.picture().map_or(0, |picture| wrong(picture, &paint(&shot.case, rules)).len());
        if sum > most {
            break;
        }
    }
    sum
}

fn margin(total: usize) -> usize {
    ((total as f64 * MARGIN).ceil() as usize).max(1)
}

/// Mismatches that a mistake may leave and still be named.
fn most_left(total: usize) -> usize {
    (total as f64 * MARGIN) as usize
}

/// How well one mutant does: mismatches left in what is in question.
#[derive(Clone, Copy)]
struct Score {
    mutant: usize,
    here: usize,
}

/// An aspect that no mistake explains.
pub(super) struct GivenUp {
    pub aspect: usize,
    /// The best two: name, and mismatches that are left.
    pub best: [(&'static str, usize); 2],
    /// Mismatches that there were.
    pub total: usize,
}

/// The mistakes found so far.
pub(super) struct Search<'a> {
    aspects: &'a [AspectVerdict],
    mutants: Vec<Mutant>,
    /// The contract with all mistakes named so far.
    pub rules: Rules,
    pub faults: Vec<Fault>,
    pub given_up: Vec<GivenUp>,
    /// Mismatches left in every aspect under the rules.
    left: Vec<usize>,
    /// The same under each mutant, as far as they were asked for; as long as the rules stay.
    table: RefCell<Vec<Vec<Option<usize>>>>,
    pair_searches: usize,
    /// Nothing more is named: only what is closest is looked for.
    is_closed: bool,
}

impl<'a> Search<'a> {
    pub fn new(lab: &Lab, aspects: &'a [AspectVerdict]) -> Search<'a> {
        let mut mutants = mutants::of(lab);
        mutants.retain(|mutant| concerns(mutant, lab, aspects));
        let mut search = Search {
            aspects,
            mutants,
            rules: Rules::default(),
            faults: Vec::new(),
            given_up: Vec::new(),
            left: Vec::new(),
            table: RefCell::default(),
            pair_searches: 0,
            is_closed: false,
        };
        search.begin_round(Rules::default());
        search
    }

    /// Names what can be named, and takes back what does not hold.
    pub fn run(&mut self) {
        let total: usize = self.left.iter().sum();
        while self.faults.len() < MOST_FAULTS && self.step() {}
        let is_explained = self.left.iter().sum::<usize>() <= most_left(total);
        if is_explained || self.faults.iter().any(|fault| UNFORGIVEN.contains(&fault.name)) {
            return;
        }
        // What is left over says that the names may be wrong, too: only what explains much and whole aspects stands.
        let holds = self.faults.iter().take_while(|fault| self.is_solid(fault)).count();
        if let Some(first) = self.faults.get(holds) {
            let rules = first.rules.0.clone();
            self.faults.truncate(holds);
            self.given_up.clear();
            self.begin_round(rules);
        }
        self.is_closed = true;
        while self.step() {}
    }

    fn begin_round(&mut self, rules: Rules) {
        self.left = self.aspects.iter().map(|aspect| mismatches(&aspect.shots, &rules)).collect();
        self.table = RefCell::new(vec![vec![None; self.aspects.len()]; self.mutants.len()]);
        self.rules = rules;
    }

    /// Whether a mistake explains several aspects to the last pixel, and makes nothing worse.
    fn is_solid(&self, fault: &Fault) -> bool {
        let counts = |aspect: &AspectVerdict| {
            (mismatches(&aspect.shots, &fault.rules.0), mismatches(&aspect.shots, &fault.rules.1))
        };
        let counts: Vec<_> = self.aspects.iter().map(counts).collect();
        let whole = counts.iter().filter(|&&(before, after)| before > 0 && after == 0).count();
        whole >= WHOLE_ASPECTS && counts.iter().all(|&(before, after)| after <= before)
    }

    /// Names one mistake or gives one aspect up; false when there is nothing left to do.
    fn step(&mut self) -> bool {
        if self.faults.iter().any(|fault| UNFORGIVEN.contains(&fault.name)) {
            return false;
        }
        let open = |index: usize| !self.given_up.iter().any(|given_up| given_up.aspect == index);
        let Some(first) = (0..self.left.len()).find(|&index| self.left[index] > 0 && open(index)) else {
            return false;
        };
        if self.is_closed {
            self.give_up(first);
            return true;
        }
        // One mistake for everything; one for the first aspect that has no cause; two at once for that, of which the first is
        // named, and the second is alone then.
        let all: usize = self.left.iter().sum();
        let (found, total) = match self.for_everything(all) {
            Some(found) => (Some(found), all),
            None => (self.for_aspect(first).or_else(|| self.of_pair(first)), self.left[first]),
        };
        match found {
            Some(score) => self.name(score, total),
            None => self.give_up(first),
        }
        true
    }

    fn give_up(&mut self, aspect: usize) {
        let scores = self.ranked(aspect, usize::MAX);
        let best = |score: &Score| (self.mutants[score.mutant].name, score.here);
        let closest = scores.first().map_or(("none", self.left[aspect]), best);
        let next = scores.iter().find(|score| self.mutants[score.mutant].name != closest.0);
        let best = [closest, next.map_or(("none", self.left[aspect]), best)];
        self.given_up.push(GivenUp { aspect, best, total: self.left[aspect] });
    }

    fn for_everything(&self, total: usize) -> Option<Score> {
        let limit = most_left(total) + margin(total);
        let score = |mutant: usize| self.everywhere(mutant, limit).map(|here| Score { mutant, here });
        let mut scores: Vec<Score> = (0..self.mutants.len()).filter_map(score).collect();
        scores.sort_by_key(|score| (score.here, score.mutant));
        let best = *scores.first()?;
        let gap = gap(&best, total);
        let is_rival = |score: &&Score| self.is_rival(best.mutant, score.mutant) && score.here < best.here + gap;
        (best.here <= most_left(total) && !scores.iter().any(|score| is_rival(&score))).then_some(best)
    }

    fn for_aspect(&self, aspect: usize) -> Option<Score> {
        let total = self.left[aspect];
        let scores = self.ranked(aspect, most_left(total) + margin(total));
        let best = *scores.first()?;
        if best.here > most_left(total) {
            return None;
        }
        // Who is as good here must be clearly worse on all the rest.
        let everywhere = |score: &Score| self.everywhere(score.mutant, usize::MAX).unwrap_or(usize::MAX);
        let close = scores.iter().filter(|score| score.here < best.here + gap(&best, total));
        let mut close: Vec<(usize, Score)> = close.map(|score| (everywhere(score), *score)).collect();
        close.sort_by_key(|(everywhere, score)| (score.here, *everywhere, score.mutant));
        let (all, best) = *close.first()?;
        let is_rival = |(other, score): &(usize, Score)| {
            let is_worse = score.here == best.here && *other >= all + margin(total);
            self.is_rival(best.mutant, score.mutant) && !is_worse
        };
        let is_better = all < self.left.iter().sum();
        (is_better && !close.iter().any(is_rival)).then_some(best)
    }

    /// Whether two mutants say different things that the pictures tell apart. What they do not goes by the more usual name.
    fn is_rival(&self, best: usize, other: usize) -> bool {
        let [first, second] = [best, other].map(|mutant| &self.mutants[mutant]);
        if first.name == second.name {
            return false;
        }
        let (first, second) = (first.applied_to(&self.rules), second.applied_to(&self.rules));
        let mut shots = self.aspects.iter().flat_map(|aspect| &aspect.shots).filter(|shot| shot.picture().is_some());
        best > other || shots.any(|shot| paint(&shot.case, &first) != paint(&shot.case, &second))
    }

    /// Mutants that leave at most so much of an aspect, the best first.
    fn ranked(&self, aspect: usize, most: usize) -> Vec<Score> {
        let score = |mutant: usize| self.cell(mutant, aspect, most).map(|here| Score { mutant, here });
        let mut scores: Vec<Score> = (0..self.mutants.len()).filter_map(score).collect();
        scores.sort_by_key(|score| (score.here, score.mutant));
        scores
    }

    /// Mismatches that a mutant leaves in all aspects, if at most so many.
    fn everywhere(&self, mutant: usize, most: usize) -> Option<usize> {
        // Most mutants fail where most is wrong.
        let mut aspects: Vec<usize> = (0..self.aspects.len()).collect();
        aspects.sort_by_key(|&aspect| std::cmp::Reverse(self.left[aspect]));
        let mut sum = 0;
        for aspect in aspects {
            sum += self.cell(mutant, aspect, most.checked_sub(sum)?)?;
        }
        (sum <= most).then_some(sum)
    }

    /// Mismatches left in one aspect when a mutant is added to the rules, if at most so many.
    fn cell(&self, mutant: usize, aspect: usize, most: usize) -> Option<usize> {
        let known = self.table.borrow()[mutant][aspect];
        if let Some(count) = known {
            return (count <= most).then_some(count);
        }
        let rules = self.mutants[mutant].applied_to(&self.rules);
        let count = if rules == self.rules || self.is_old(&self.mutants[mutant]) {
            self.left[aspect]
        } else {
            let count = mismatches_up_to(&self.aspects[aspect].shots, &rules, most);
            if count > most {
                return None;
            }
            count
        };
        self.table.borrow_mut()[mutant][aspect] = Some(count);
        (count <= most).then_some(count)
    }

    /// The first of two mistakes that together explain one aspect, as clearly as one must alone; tried with the best few.
    fn of_pair(&mut self, aspect: usize) -> Option<Score> {
        if self.pair_searches == MOST_PAIR_SEARCHES {
            return None;
        }
        self.pair_searches += 1;
        let shots = &self.aspects[aspect].shots;
        let total = self.left[aspect];
        let (margin, limit) = (margin(total), most_left(total) + margin(total));
        let scores = self.ranked(aspect, usize::MAX);
        let mut pairs = Vec::new();
        for first in self.best_names(&scores) {
            let rules = self.mutants[first].applied_to(&self.rules);
            for second in (0..self.mutants.len()).filter(|&second| self.can_follow(first, second)) {
                let both = self.mutants[second].applied_to(&rules);
                pairs.push((mismatches_up_to(shots, &both, limit), first, second));
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
            let left = self.aspects.iter().map(|aspect| mismatches(&aspect.shots, &rules)).sum::<usize>();
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

    /// Whether a mutant was named before, or takes back what was: then it is no second mistake.
    fn is_old(&self, mutant: &Mutant) -> bool {
        let takes_back = |fault: &Fault| mutant.applied_to(&fault.rules.0) == mutant.applied_to(&fault.rules.1);
        self.faults.iter().any(|fault| fault.name == mutant.name || takes_back(fault))
    }

    fn name(&mut self, score: Score, total: usize) {
        let mutant = self.mutants[score.mutant];
        let rules = mutant.applied_to(&self.rules);
        let old = std::mem::take(&mut self.left);
        let before = std::mem::replace(&mut self.rules, rules.clone());
        self.begin_round(rules.clone());
        let aspect = (0..old.len()).find(|&index| self.left[index] < old[index]).unwrap_or(0);
        self.faults.push(Fault {
            name: mutant.name,
            cause: mutant.cause,
            rule: mutant.rule,
            read: mutant.read,
            aspect,
            explained: total - score.here.min(total),
            total,
            is_accepted: false,
            rules: (before, rules),
        });
        // What was given up may be explained behind this one.
        self.given_up.clear();
    }
}

/// By how much a mutant must beat the next.
fn gap(best: &Score, total: usize) -> usize {
    if best.here > 0 { margin(total) } else { ((total as f64 * MARGIN_OF_ALL).ceil() as usize).max(1) }
}

/// Whether the lab asks for what a mutant changes: who averages nothing averages nothing wrongly.
fn concerns(mutant: &Mutant, lab: &Lab, aspects: &[AspectVerdict]) -> bool {
    let right = Rules::default();
    let mut rules = mutant.applied_to(&right);
    let has = |what: fn(&Shot) -> bool| aspects.iter().flat_map(|aspect| &aspect.shots).any(what);
    if !has(|shot| shot.case.samples > 1) {
        rules.pixel = right.pixel;
    }
    if !has(|shot| shot.case.lamp.is_some()) {
        rules.light = right.light;
    }
    if !has(|shot| shot.case.lines) {
        rules.lines = right.lines;
    }
    if !has(|shot| shot.case.faces.iter().any(|face| face.opacity < 1.0)) {
        rules.blending = right.blending;
    }
    if lab.name != "watkins" {
        // Only scan-line programs have spans of several faces.
        rules.line = right.line;
    }
    rules != right
}
