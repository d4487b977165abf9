//! Explain: which mistake gives the wrong answers of a function, and the smallest question that shows it.
//!
//! questions with answers -EXPLAIN-> faults, causes, points
//!
//! First one mistake is looked for behind everything; where none explains it all, one behind each aspect, in order.

use super::{Asked, Exercise};
use crate::grade::diagnose::Fault;
use crate::grade::rules::Rules;
use crate::grade::verdict::{Cause, Verdict};

/// Fills in causes, witnesses and points.
pub(super) fn explain<E: Exercise>(exercise: &E, asked: &mut [Vec<Asked<E>>], verdict: &mut Verdict) {
    if asked.iter().flatten().all(|asked| asked.complaint.is_none()) {
        return;
    }
    let count = exercise.mistakes().len();
    for asked in asked.iter_mut().flatten() {
        asked.fits = fits(exercise, count, asked);
    }
    let asked = &*asked;
    let mut search = Search { exercise, asked, named: Vec::new() };
    if let Some(mistake) = search.behind_everything()
        && let Some(first) = asked.iter().position(|cases| cases.iter().any(|asked| asked.complaint.is_some()))
    {
        search.name(mistake, first, verdict);
    }
    for aspect in 0..asked.len() {
        search.settle(aspect, verdict);
    }
}

/// Which mistakes give an answer.
fn fits<E: Exercise>(exercise: &E, count: usize, asked: &Asked<E>) -> Vec<bool> {
    let is_right = asked.complaint.is_none();
    (0..count).map(|mistake| exercise.fits(mistake, &asked.case, &asked.answer, is_right)).collect()
}

struct Search<'a, E: Exercise> {
    exercise: &'a E,
    asked: &'a [Vec<Asked<E>>],
    /// The mistake's number, the fault's number and the aspect it is charged to.
    named: Vec<(usize, usize, usize)>,
}

impl<E: Exercise> Search<'_, E> {
    fn fits(&self, mistake: usize, asked: &Asked<E>) -> bool {
        asked.fits[mistake]
    }

    /// Of some questions: wrong answers that a mistake gives, and all answers that it does not give.
    fn score<'b>(&self, mistake: usize, questions: impl Iterator<Item = &'b Asked<E>>) -> (usize, usize)
    where
        E: 'b,
    {
        questions.fold((0, 0), |(explained, against), asked| match self.fits(mistake, asked) {
            true => (explained + usize::from(asked.complaint.is_some()), against),
            false => (explained, against + 1),
        })
    }

    fn all(&self) -> impl Iterator<Item = &Asked<E>> {
        self.asked.iter().flatten()
    }

    /// The one mistake that gives every answer there is.
    fn behind_everything(&self) -> Option<usize> {
        self.only(
            (0..self.exercise.mistakes().len()).filter(|&mistake| self.score(mistake, self.all()).1 == 0).collect(),
        )
    }

    /// The only one of these, or the one that explains the most of everything.
    fn only(&self, candidates: Vec<usize>) -> Option<usize> {
        let known = self.exercise.mistakes();
        let mut ranked: Vec<((i64, u8), usize)> = candidates
            .into_iter()
            .map(|mistake| {
                let (explained, against) = self.score(mistake, self.all());
                ((explained as i64 - against as i64, known[mistake].special), mistake)
            })
            .collect();
        ranked.sort_by_key(|&(score, mistake)| (std::cmp::Reverse(score), mistake));
        match ranked.as_slice() {
            [] => None,
            [(best, first), (next, second), ..] if best == next && known[*first].name != known[*second].name => None,
            [(_, first), ..] => Some(*first),
        }
    }

    /// Names a mistake, and charges it to the aspect, this or a later one, in which it costs most.
    fn name(&mut self, mistake: usize, aspect: usize, verdict: &mut Verdict) {
        let cost = |at: usize| {
            let wrong = self.asked[at].iter().filter(|asked| asked.complaint.is_some() && self.fits(mistake, asked));
            verdict.aspects[at].most * wrong.count() as f64 / self.asked[at].len().max(1) as f64
        };
        let dearer = |best: usize, at: usize| if cost(at) > cost(best) { at } else { best };
        let aspect = (aspect..self.asked.len()).fold(aspect, dearer);
        let known = self.exercise.mistakes()[mistake];
        let wrong = |asked: &&Asked<E>| asked.complaint.is_some();
        verdict.faults.push(Fault {
            name: known.name,
            cause: known.cause,
            rule: known.rule,
            read: self.exercise.read(),
            aspect,
            explained: self.score(mistake, self.all().filter(wrong)).0,
            total: self.all().filter(wrong).count(),
            is_accepted: false,
            rules: (Rules::default(), Rules::default()),
        });
        self.named.push((mistake, verdict.faults.len() - 1, aspect));
    }

    /// Cause, points and witness of one aspect.
    fn settle(&mut self, aspect: usize, verdict: &mut Verdict) {
        let cases = &self.asked[aspect];
        let wrong: Vec<&Asked<E>> = cases.iter().filter(|asked| asked.complaint.is_some()).collect();
        if wrong.is_empty() {
            return;
        }
        let is_known =
            |search: &Self, asked: &Asked<E>| search.named.iter().any(|&(known, ..)| search.fits(known, asked));
        let rest: Vec<&Asked<E>> = wrong.iter().filter(|asked| !is_known(self, asked)).copied().collect();
        if let Some(first) = rest.first() {
            // Right answers speak, too; of wrong ones only those that nothing named explains.
            let speaking = || cases.iter().filter(|asked| asked.complaint.is_none()).chain(rest.iter().copied());
            let candidates =
                (0..self.exercise.mistakes().len()).filter(|&mistake| self.score(mistake, speaking()).1 == 0).collect();
            match self.only(candidates) {
                Some(mistake) => self.name(mistake, aspect, verdict),
                None => {
                    let words = first.complaint.clone().unwrap_or_default();
                    verdict.aspects[aspect].cause = Some(Cause::Other(format!(
                        "{} of {} {} are answered wrongly. The smallest: {words}",
                        wrong.len(),
                        cases.len(),
                        self.exercise.unit()
                    )));
                }
            }
        }
        self.charge(aspect, &wrong, verdict);
    }

    fn charge(&self, aspect: usize, wrong: &[&Asked<E>], verdict: &mut Verdict) {
        let now = &mut verdict.aspects[aspect];
        // What follows from a mistake that is charged elsewhere is free.
        let forgiven = |asked: &&&Asked<E>| {
            self.named.iter().any(|&(mistake, _, charged)| {
                charged != aspect && self.exercise.mistakes()[mistake].is_forgiven && self.fits(mistake, asked)
            })
        };
        let judged = self.asked[aspect].len();
        let paid = wrong.len() - wrong.iter().filter(forgiven).count();
        now.earned = now.most * (judged - paid) as f64 / judged as f64;
        let own = self.named.iter().find(|&&(.., charged)| charged == aspect);
        let fitting = || self.named.iter().find(|&&(mistake, ..)| wrong.iter().all(|asked| self.fits(mistake, asked)));
        now.cause = now
            .cause
            .take()
            .or(own.map(|&(_, fault, _)| Cause::Named(fault)))
            .or_else(|| fitting().map(|&(_, fault, _)| Cause::FollowsFrom(fault)))
            .or_else(|| self.named.last().map(|&(_, fault, _)| Cause::FollowsFrom(fault)));
        if !matches!(now.cause, Some(Cause::FollowsFrom(_)))
            && let Some(answers) = &mut now.answers
        {
            answers.witness = self.witness(own.map(|&(mistake, ..)| mistake), wrong);
        }
    }

    /// The smallest question that is answered wrongly in the same way.
    fn witness(&self, mistake: Option<usize>, wrong: &[&Asked<E>]) -> String {
        let fails_alike = |asked: &Asked<E>| {
            let gives = |mistake| self.exercise.fits(mistake, &asked.case, &asked.answer, false);
            asked.complaint.is_some() && mistake.is_none_or(gives)
        };
        let Some(first) = wrong.iter().find(|asked| fails_alike(asked)).or(wrong.first()) else { return String::new() };
        let mut smallest = Asked::new(self.exercise, first.case.clone());
        let mut is_smaller = true;
        while is_smaller {
            is_smaller = false;
            for case in self.exercise.smaller(&smallest.case) {
                let asked = Asked::new(self.exercise, case);
                if fails_alike(&asked) {
                    (smallest, is_smaller) = (asked, true);
                    break;
                }
            }
        }
        let complaint = smallest.complaint.clone().unwrap_or_default();
        self.exercise.show(&smallest.case, &smallest.answer, &complaint)
    }
}
