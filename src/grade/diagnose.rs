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

use super::case::Case;
use super::labs::Lab;
use super::paint::paint;
use super::rules::Rules;
use super::search::{MARGIN, Search, UNFORGIVEN, mismatches};
use super::subject::Subject;
use super::verdict::{AspectVerdict, Cause, Shot, Verdict, wrong};
use super::{watch, witness};
use crate::image::Picture;

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

/// Fills in causes, witnesses and points.
pub(super) fn explain(subject: &dyn Subject, lab: &Lab, verdict: &mut Verdict) {
    let aspects = std::mem::take(&mut verdict.aspects);
    let mut search = Search::new(lab, &aspects);
    match kept_between(&aspects) {
        // Pictures that depend on older pictures show no other mistake.
        Some(fault) => search.faults.push(fault),
        None => search.run(),
    }
    for fault in &mut search.faults {
        fault.is_accepted = fault.name == OTHER_TIES && !lab.fixes_ties;
    }
    let causes: Vec<Option<Cause>> = (0..aspects.len()).map(|index| search.cause(index, &aspects)).collect();
    let (faults, rules) = (search.faults, search.rules);
    verdict.aspects = aspects;
    for (aspect, cause) in verdict.aspects.iter_mut().zip(causes) {
        aspect.cause = aspect.cause.take().or(cause);
        aspect.earned = points(aspect, &faults, &rules);
    }
    verdict.notes = notes(&faults);
    verdict.faults = faults;
    witness::find_all(subject, verdict);
}

/// The mistake of a rasterizer that draws one list in two ways.
fn kept_between(aspects: &[AspectVerdict]) -> Option<Fault> {
    let is_kept = |shot: &Shot| shot.complaint.as_ref().is_some_and(|words| words.contains(watch::KEPT));
    let aspect = aspects.iter().position(|aspect| aspect.shots.iter().any(is_kept))?;
    let total = aspects.iter().map(AspectVerdict::wrong).sum();
    Some(Fault {
        name: "kept from picture to picture",
        cause: "Drawn twice, the same list gives two pictures: depths, counters or pixels are kept between calls.",
        rule: "Clear everything that belongs to a picture before its first polygon.",
        read: "docs/lab.md",
        aspect,
        explained: total,
        total,
        is_accepted: false,
        rules: (Rules::default(), Rules::default()),
    })
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
    aspect.shots.iter().all(|shot| shot.answer.is_ok() && complaint_follows(shot, rules))
        && mismatches(&aspect.shots, rules) as f64 <= MARGIN * aspect.wrong() as f64
}

/// Whether there is no complaint but one that the rules explain.
fn complaint_follows(shot: &Shot, rules: &Rules) -> bool {
    let Some(words) = &shot.complaint else { return true };
    if words.contains(watch::STRAY) {
        return *rules != Rules::default();
    }
    let is_right = |turned: &(Case, Picture)| {
        let wrong = |rules: &Rules| wrong(&turned.1, &paint(&turned.0, rules)).len();
        wrong(rules) as f64 <= MARGIN * wrong(&Rules::default()) as f64
    };
    words.contains(watch::ORDER) && shot.turned.as_ref().is_some_and(is_right)
}

impl Search<'_> {
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
        let is_kept = self.faults.first().is_some_and(|fault| fault.total > 0 && fault.rules.0 == fault.rules.1);
        if words.is_some() && !is_kept && (self.faults.is_empty() || !follows(aspect, &self.rules)) {
            return words.map(Cause::Other);
        }
        // The mistake that takes most of this aspect's mismatches away.
        let gain = |fault: &Fault| {
            mismatches(&aspect.shots, &fault.rules.0) as i64 - mismatches(&aspect.shots, &fault.rules.1) as i64
        };
        (0..self.faults.len()).max_by_key(|&fault| gain(&self.faults[fault])).map(Cause::FollowsFrom)
    }
}
