//! Diagnose: which mistake explains the wrong pixels.
//!
//! wrong pixels -DIAGNOSE-> [`Fault`]s, each aspect's cause
//!
//! A mutant explains a wrong pixel when it draws what the subject drew; right pixels that the mutant gets wrong count against it.
//! It is named when at least 95 % of the mismatches vanish and every mutant of another name leaves at least 5 % more. First one
//! mistake is tried for everything, then one for each aspect, in order. What is named is built into the rules that the rest
//! is held against: so a second mistake is found behind the first, and one mistake fails one aspect.
//!
//! Cost: every mutant draws every case once a round, some 10^7 operations.

use super::labs::Lab;
use super::mutants::{self, Mutant};
use super::paint::paint;
use super::rules::Rules;
use super::subject::Subject;
use super::verdict::{AspectVerdict, Cause, Shot, Verdict, wrong};
use super::witness;

/// A mistake that was named.
#[derive(Clone, Debug)]
pub struct Fault {
    /// The mistake's name.
    pub name: &'static str,
    /// The cause, in one sentence.
    pub cause: &'static str,
    /// The right rule.
    pub rule: &'static str,
    /// Where to read.
    pub read: &'static str,
    /// The aspect it is charged to.
    pub aspect: usize,
    /// Wrong pixels it explains.
    pub explained: usize,
    /// Wrong pixels there were.
    pub total: usize,
    /// It costs no points: a tie rule that is consistent.
    pub is_accepted: bool,
    /// The rules that the subject follows, as far as known, before and with this mistake.
    pub rules: (Rules, Rules),
}

/// The name of the mistake that a lab may accept.
const OTHER_TIES: &str = "another side owns the edges";
/// Mistakes behind which there is nothing to be graded yet: what follows from them earns nothing.
const UNFORGIVEN: [&str; 2] = ["nothing drawn", "corners only"];
/// Part of the mismatches that a named mistake leaves at most, and by which it beats the next.
const MARGIN: f64 = 0.05;
/// Names that are tried as the first of two mistakes, and pairs that are compared on everything.
const FIRST_OF_PAIR: usize = 8;
const MOST_PAIRS: usize = 60;
/// More mistakes in one rasterizer are not told apart.
const MOST_FAULTS: usize = 5;

/// Fills in causes, witnesses and points.
pub(super) fn explain(subject: &dyn Subject, lab: &Lab, verdict: &mut Verdict) {
    let mut search = Search {
        mutants: mutants::all(),
        rules: Rules::default(),
        faults: Vec::new(),
        given_up: Vec::new(),
        tables: None,
    };
    while search.faults.len() < MOST_FAULTS && search.step(&verdict.aspects) {}
    for fault in &mut search.faults {
        fault.is_accepted = fault.name == OTHER_TIES && !lab.fixes_ties;
    }
    for index in 0..verdict.aspects.len() {
        let cause = search.cause(index, &verdict.aspects);
        let aspect = &mut verdict.aspects[index];
        aspect.cause = aspect.cause.take().or(cause);
        aspect.earned = points(aspect, &search.faults, &search.rules);
    }
    verdict.notes = notes(&search.faults);
    verdict.faults = search.faults;
    witness::find_all(subject, verdict);
}

fn notes(faults: &[Fault]) -> Vec<String> {
    let accepted = faults.iter().filter(|fault| fault.is_accepted);
    accepted
        .map(|fault| format!("your tie rule: {}; it is consistent, so it is accepted", fault.rules.1.ties.words()))
        .collect()
}

fn points(aspect: &AspectVerdict, faults: &[Fault], rules: &Rules) -> f64 {
    let is_forgiven = |fault: &Fault| fault.is_accepted || !UNFORGIVEN.contains(&fault.name);
    match aspect.cause {
        Some(Cause::FollowsFrom(fault)) if is_forgiven(&faults[fault]) && follows(aspect, rules) => aspect.most,
        Some(Cause::Named(fault)) if faults[fault].is_accepted && follows(aspect, rules) => aspect.most,
        Some(Cause::Other(_)) if aspect.shots.is_empty() => 0.0,
        _ => {
            let right = aspect.shots.iter().filter(|shot| shot.is_right()).count();
            aspect.most * if aspect.shots.is_empty() { 1.0 } else { right as f64 / aspect.shots.len() as f64 }
        }
    }
}

/// Whether nothing is wrong with an aspect but what the rules say.
fn follows(aspect: &AspectVerdict, rules: &Rules) -> bool {
    aspect.shots.iter().all(|shot| shot.answer.is_ok() && shot.complaint.is_none())
        && mismatches(&aspect.shots, rules) as f64 <= MARGIN * aspect.wrong() as f64
}

/// Pixels of all pictures that are not as the rules say.
fn mismatches(shots: &[Shot], rules: &Rules) -> usize {
    let count = |shot: &Shot| shot.picture().map_or(0, |picture| wrong(picture, &paint(&shot.case, rules)).len());
    shots.iter().map(count).sum()
}

/// How well one mutant does: mismatches left in the aspect in question, and in all.
struct Score {
    mutant: usize,
    here: usize,
    everywhere: usize,
}

/// An aspect that no mistake explains.
struct GivenUp {
    aspect: usize,
    /// The best two: name, and mismatches that are left.
    best: [(&'static str, usize); 2],
    /// Mismatches that there were.
    total: usize,
}

struct Search {
    mutants: Vec<Mutant>,
    /// The contract with all mistakes named so far.
    rules: Rules,
    faults: Vec<Fault>,
    given_up: Vec<GivenUp>,
    /// Mismatches left in every aspect under the rules, and under each mutant, as long as the rules stay.
    tables: Option<(Vec<usize>, Vec<Vec<usize>>)>,
}

impl Search {
    /// Names one mistake or gives one aspect up; false when there is nothing left to do.
    fn step(&mut self, aspects: &[AspectVerdict]) -> bool {
        if self.faults.iter().any(|fault| UNFORGIVEN.contains(&fault.name)) {
            return false;
        }
        let (left, tables) = self.tables.take().unwrap_or_else(|| self.count(aspects));
        let open = |index: usize| !self.given_up.iter().any(|given_up| given_up.aspect == index);
        let Some(first) = (0..aspects.len()).find(|&index| left[index] > 0 && open(index)) else { return false };

        // One mistake for everything.
        let total = left.iter().sum();
        let scores = ranked(&tables, |table| table.iter().sum());
        if self.is_clear(&scores, total) {
            self.name(&scores[0], (&left, &tables), total);
            return true;
        }
        // One mistake for the first aspect that has no cause.
        let scores = ranked(&tables, |table| table[first]);
        if self.is_clear(&scores, left[first]) {
            self.name(&scores[0], (&left, &tables), left[first]);
            return true;
        }
        // Two at once for that aspect: the first is named, the second is alone then.
        if let Some(score) =
            self.pair(first, aspects, &scores).and_then(|mutant| scores.iter().find(|score| score.mutant == mutant))
        {
            self.name(score, (&left, &tables), left[first]);
            return true;
        }
        let next = self.next(&scores);
        let best = |score: &Score| (self.mutants[score.mutant].name, score.here);
        let best = [best(&scores[0]), next.map_or(("none", left[first]), best)];
        self.given_up.push(GivenUp { aspect: first, best, total: left[first] });
        // Nothing was named, so nothing has changed.
        self.tables = Some((left, tables));
        true
    }

    /// The first of two mistakes that together explain one aspect, as clearly as one must alone; tried with the best few.
    fn pair(&self, aspect: usize, aspects: &[AspectVerdict], scores: &[Score]) -> Option<usize> {
        let shots = &aspects[aspect].shots;
        let total = mismatches(shots, &self.rules);
        let margin = ((total as f64 * MARGIN).ceil() as usize).max(1);
        let mut pairs = Vec::new();
        for first in self.best_names(scores) {
            let rules = self.mutants[first].applied_to(&self.rules);
            for second in (0..self.mutants.len()).filter(|&second| self.can_follow(first, second)) {
                pairs.push((mismatches(shots, &self.mutants[second].applied_to(&rules)), first, second));
            }
        }
        let least = pairs.iter().map(|pair| pair.0).min()?;
        pairs.retain(|pair| pair.0 < least + margin);
        if least as f64 > MARGIN * total as f64 || pairs.len() > MOST_PAIRS {
            return None;
        }
        // What the aspect cannot tell apart, all of them together may.
        let everywhere = |&(_, first, second): &(usize, usize, usize)| {
            let rules = self.mutants[second].applied_to(&self.mutants[first].applied_to(&self.rules));
            let left = aspects.iter().map(|aspect| mismatches(&aspect.shots, &rules)).sum::<usize>();
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
        rival.is_none_or(|rival| rival.0 >= pairs[0].0 + margin).then_some(pairs[0].1)
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

    /// Mismatches left in every aspect when `mutant` is added to the rules.
    fn table(&self, mutant: &Mutant, aspects: &[AspectVerdict], left: &[usize]) -> Vec<usize> {
        let rules = mutant.applied_to(&self.rules);
        if rules == self.rules || self.is_old(mutant) {
            return left.to_vec();
        }
        aspects.iter().map(|aspect| mismatches(&aspect.shots, &rules)).collect()
    }

    fn count(&self, aspects: &[AspectVerdict]) -> (Vec<usize>, Vec<Vec<usize>>) {
        let left: Vec<usize> = aspects.iter().map(|aspect| mismatches(&aspect.shots, &self.rules)).collect();
        let tables = self.mutants.iter().map(|mutant| self.table(mutant, aspects, &left)).collect();
        (left, tables)
    }

    /// Whether a mutant was named before, or takes back what was: then it is no second mistake.
    fn is_old(&self, mutant: &Mutant) -> bool {
        let takes_back = |fault: &Fault| mutant.applied_to(&fault.rules.0) == mutant.applied_to(&fault.rules.1);
        self.faults.iter().any(|fault| fault.name == mutant.name || takes_back(fault))
    }

    /// The best mutant of another name than the first.
    fn next<'a>(&self, scores: &'a [Score]) -> Option<&'a Score> {
        let name = |score: &Score| self.mutants[score.mutant].name;
        scores.iter().find(|score| name(score) != name(&scores[0]))
    }

    fn is_clear(&self, scores: &[Score], total: usize) -> bool {
        let best = &scores[0];
        let margin = ((total as f64 * MARGIN).ceil() as usize).max(1);
        let beats = |next: &Score| {
            next.here >= best.here + margin || (next.here == best.here && next.everywhere >= best.everywhere + margin)
        };
        best.here as f64 <= MARGIN * total as f64 && self.next(scores).is_none_or(beats)
    }

    fn name(&mut self, score: &Score, (left, tables): (&[usize], &[Vec<usize>]), total: usize) {
        let mutant = self.mutants[score.mutant];
        let table = &tables[score.mutant];
        let rules = mutant.applied_to(&self.rules);
        let aspect = (0..left.len()).find(|&index| table[index] < left[index]).unwrap_or(0);
        self.faults.push(Fault {
            name: mutant.name,
            cause: mutant.cause,
            rule: mutant.rule,
            read: mutant.read,
            aspect,
            explained: total - score.here.min(total),
            total,
            is_accepted: false,
            rules: (self.rules.clone(), rules.clone()),
        });
        self.rules = rules;
        // What was given up may be explained behind this one.
        self.given_up.clear();
    }

    fn cause(&self, index: usize, aspects: &[AspectVerdict]) -> Option<Cause> {
        let aspect = &aspects[index];
        if let Some(fault) = self.faults.iter().position(|fault| fault.aspect == index) {
            return Some(Cause::Named(fault));
        }
        if aspect.is_right() {
            return None;
        }
        if let Some(given_up) = self.given_up.iter().find(|given_up| given_up.aspect == index) {
            let [closest, next] = given_up.best;
            let explained = |left: usize| given_up.total - left.min(given_up.total);
            return Some(Cause::Unexplained {
                closest: closest.0,
                explained: explained(closest.1),
                next: next.0,
                next_explained: explained(next.1),
            });
        }
        let words = aspect.shots.iter().find_map(|shot| match &shot.answer {
            Err(failure) => Some(format!("{}: {}. {}", shot.case.name, failure.message, failure.hint)),
            Ok(_) => shot.complaint.as_ref().map(|complaint| format!("{}: {complaint}", shot.case.name)),
        });
        if words.is_some() && (self.faults.is_empty() || !follows(aspect, &self.rules)) {
            return words.map(Cause::Other);
        }
        // The mistake that takes most of this aspect's mismatches away.
        let gain = |fault: &Fault| {
            mismatches(&aspect.shots, &fault.rules.0) as i64 - mismatches(&aspect.shots, &fault.rules.1) as i64
        };
        (0..self.faults.len()).max_by_key(|&fault| gain(&self.faults[fault])).map(Cause::FollowsFrom)
    }
}

/// Mutants by mismatches here, then everywhere.
fn ranked(tables: &[Vec<usize>], here: impl Fn(&[usize]) -> usize) -> Vec<Score> {
    let score =
        |(mutant, table): (usize, &Vec<usize>)| Score { mutant, here: here(table), everywhere: table.iter().sum() };
    let mut scores: Vec<Score> = tables.iter().enumerate().map(score).collect();
    scores.sort_by_key(|score| (score.here, score.everywhere, score.mutant));
    scores
}
