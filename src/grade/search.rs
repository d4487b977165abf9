//! Search: which mistakes, one after another, explain the wrong pixels.
//!
//! Cost: every mutant draws every case once a round, but stops as soon as it leaves more pixels wrong than could name it.

use super::covering::Covering;
use super::diagnose::Fault;
use super::labs::Lab;
use super::mutants::{self, Mutant};
use super::paint::{paint, paint_known};
use super::rules::Rules;
use super::verdict::{AspectVerdict, Shot, wrong};
use crate::image::Picture;
use std::cell::RefCell;

/// Mistakes behind which there is nothing to be graded yet: what follows from them earns nothing.
pub(super) const UNFORGIVEN: [&str; 2] = ["nothing drawn", "corners only"];
/// Part of the mismatches that a named mistake leaves at most, and by which it beats the next.
pub(super) const MARGIN: f64 = 0.05;
/// The same for a mistake that leaves nothing.
const MARGIN_OF_ALL: f64 = 0.01;
/// More mistakes in one rasterizer are not told apart.
const MOST_FAULTS: usize = 5;
/// Part of the wrong pixels of an aspect that a later mistake explains at least: less than that is a rest of what was named before.
const SHARE_OF_LATER: f64 = 0.25;
/// Part of all wrong pixels that a mistake explains at least to stand beside what nothing explains.
const SHARE_OF_ALL: f64 = 0.75;
/// Aspects that it must explain whole, where it explains less.
const WHOLE_ASPECTS: usize = 2;

/// Pixels of all pictures that are not as the rules say.
pub(super) fn mismatches(shots: &[Shot], rules: &Rules) -> usize {
    let of = |shot: &Shot| shot.picture().map_or(0, |picture| wrong(picture, &paint(&shot.case, rules)).len());
    shots.iter().map(of).sum()
}

fn of_contract(shot: &Shot) -> Covering {
    Covering::of(&shot.case, &Rules::default())
}

pub(super) fn margin(total: usize) -> usize {
    ((total as f64 * MARGIN).ceil() as usize).max(1)
}

/// Mismatches that a mistake may leave and still be named.
pub(super) fn most_left(total: usize) -> usize {
    (total as f64 * MARGIN) as usize
}

/// How well one mutant does: mismatches left in what is in question.
#[derive(Clone, Copy)]
pub(super) struct Score {
    pub mutant: usize,
    pub here: usize,
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
    pub(super) aspects: &'a [AspectVerdict],
    pub(super) mutants: Vec<Mutant>,
    /// What the contract covers, of every shot of every aspect.
    covering: Vec<Vec<Covering>>,
    /// Wrong pixels of every aspect by the contract.
    wrong: Vec<usize>,
    /// The contract with all mistakes named so far.
    pub rules: Rules,
    pub faults: Vec<Fault>,
    pub given_up: Vec<GivenUp>,
    /// Mismatches left in every aspect under the rules.
    pub(super) left: Vec<usize>,
    /// The same under each mutant, as far as they were asked for; as long as the rules stay.
    pub(super) table: RefCell<Vec<Vec<Option<usize>>>>,
    pub(super) pair_searches: usize,
    /// What goes along with mistakes was tried.
    pub(super) is_accompanied: bool,
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
            covering: aspects.iter().map(|aspect| aspect.shots.iter().map(of_contract).collect()).collect(),
            wrong: Vec::new(),
            rules: Rules::default(),
            faults: Vec::new(),
            given_up: Vec::new(),
            left: Vec::new(),
            table: RefCell::default(),
            pair_searches: 0,
            is_accompanied: false,
            is_closed: false,
        };
        search.begin_round(Rules::default());
        search.wrong.clone_from(&search.left);
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
        self.left =
            (0..self.aspects.len()).map(|aspect| self.mismatches(aspect, &rules, usize::MAX).unwrap_or(0)).collect();
        self.table = RefCell::new(vec![vec![None; self.aspects.len()]; self.mutants.len()]);
        self.rules = rules;
    }

    /// Whether a mistake explains several aspects to the last pixel, or most of everything, and makes nothing worse.
    fn is_solid(&self, fault: &Fault) -> bool {
        let count = |aspect: usize, rules: &Rules| self.mismatches(aspect, rules, usize::MAX).unwrap_or(usize::MAX);
        let of = |aspect: usize| (count(aspect, &fault.rules.0), count(aspect, &fault.rules.1));
        let counts: Vec<_> = (0..self.aspects.len()).map(of).collect();
        let whole = counts.iter().filter(|&&(before, after)| before > 0 && after == 0).count();
        let (before, after) = counts.iter().fold((0, 0), |sum, count| (sum.0 + count.0, sum.1 + count.1));
        let is_most = after as f64 <= (1.0 - SHARE_OF_ALL) * before as f64;
        (whole >= WHOLE_ASPECTS || is_most) && counts.iter().all(|&(before, after)| after <= before)
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
            None => match self.for_everything_accompanied(all) {
                Some(found) => (Some(found), all),
                None => (self.for_aspect(first).or_else(|| self.of_pair(first)), self.left[first]),
            },
        };
        match found.filter(|found| self.is_no_rest(found)) {
            Some(score) => self.name(score, total),
            None => self.give_up(first),
        }
        true
    }

    fn give_up(&mut self, aspect: usize) {
        let none = ("none", self.left[aspect]);
        let mut best = [none, none];
        for mutant in 0..self.mutants.len() {
            // What is worse than the second best need not be counted to the end.
            let Some(here) = self.cell(mutant, aspect, best[1].1) else { continue };
            let name = self.mutants[mutant].name;
            if here < best[0].1 || best[0].0 == "none" {
                best = [(name, here), if best[0].0 == name { best[1] } else { best[0] }];
            } else if name != best[0].0 && (here < best[1].1 || best[1].0 == "none") {
                best[1] = (name, here);
            }
        }
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

    fn for_everything_accompanied(&mut self, total: usize) -> Option<Score> {
        if self.is_accompanied {
            return None;
        }
        self.accompany();
        self.for_everything(total)
    }

    /// Whether a mistake is more than what an earlier one, painted not quite as the program does it, left over.
    fn is_no_rest(&self, score: &Score) -> bool {
        let is_much = |aspect: usize| {
            let gained =
                self.left[aspect] - self.cell(score.mutant, aspect, self.left[aspect]).unwrap_or(self.left[aspect]);
            gained > 0 && gained as f64 >= SHARE_OF_LATER * self.wrong[aspect] as f64
        };
        self.faults.is_empty() || (0..self.left.len()).any(is_much)
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

    /// Mismatches in one aspect under some rules, if at most so many.
    pub(super) fn mismatches(&self, aspect: usize, rules: &Rules, most: usize) -> Option<usize> {
        let mut sum = 0;
        for (shot, covering) in self.aspects[aspect].shots.iter().zip(&self.covering[aspect]) {
            let painted = |picture: &Picture| wrong(picture, &paint_known(&shot.case, rules, covering)).len();
            sum += shot.picture().map_or(0, painted);
            if sum > most {
                return None;
            }
        }
        Some(sum)
    }

    /// Mutants that leave at most so much of an aspect, the best first.
    pub(super) fn ranked(&self, aspect: usize, most: usize) -> Vec<Score> {
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
            self.mismatches(aspect, &rules, most)?
        };
        self.table.borrow_mut()[mutant][aspect] = Some(count);
        (count <= most).then_some(count)
    }

    /// Whether a mutant was named before, or takes back what was: then it is no second mistake.
    pub(super) fn is_old(&self, mutant: &Mutant) -> bool {
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
        (rules.pixel, rules.pixel_of_one) = (right.pixel, right.pixel_of_one);
    }
    if !has(|shot| shot.case.lamp.is_some()) {
        rules.light = right.light;
    }
    if !has(|shot| shot.case.lines) {
        rules.lines = right.lines;
    }
    if !has(|shot| shot.case.faces.iter().any(|face| face.opacity < 1.0)) {
        (rules.blending, rules.mixed) = (right.blending, right.mixed);
    }
    let has_lit = has(|shot| shot.case.lamp.is_some());
    if !has_lit && !has(|shot| shot.case.faces.iter().any(|face| !face.is_flat())) && rules.cover_at == right.cover_at {
        // Where nothing varies but depth, depth is what is taken elsewhere.
        let at_corner = rules.value_at == (0.0, 0.0);
        (rules.value_at, rules.clamps) =
            if at_corner { (rules.value_at, rules.clamps) } else { (right.value_at, right.clamps) };
    }
    if lab.name != "watkins" {
        // Only scan-line programs have spans of several faces.
        rules.line = right.line;
    }
    rules != right
}
