//! Results: what all writers tell, test by test, and how much of it to whom.
//!
//! visible verdict, hidden verdict, [`Rubric`] -RESULTS-> entries -writers-> Gradescope, PrairieLearn, Classroom, JUnit
//!
//! A hint goes as far as its test is seen. What students see at once, or will see, has the cause, the rule, the smallest case.
//! What they never see, and every hidden probe, has counts, the mistake's name and where to read: no picture, no
//! place, no level, and no word that a program printed, which may be its input.

use super::text::aspect_text;
use crate::grade::rubric::{Rubric, Visibility};
use crate::grade::verdict::{AspectVerdict, Cause, Verdict};

/// A grade as writers get it.
#[derive(Clone, Copy)]
pub struct Results<'a> {
    /// By the probes that students have.
    pub visible: &'a Verdict,
    /// By those that they do not have.
    pub hidden: Option<&'a Verdict>,
    /// Who sees what; without one everything is visible but hidden probes.
    pub rubric: Option<&'a Rubric>,
    /// Why nothing could be graded at all.
    pub refused: Option<&'a str>,
    /// A leaderboard is asked for.
    pub leaderboard: bool,
    /// What held the submission while it ran; empty where it is part of this program, or nobody asked.
    pub layers: &'a [&'static str],
}

impl<'a> From<&'a Verdict> for Results<'a> {
    fn from(visible: &'a Verdict) -> Results<'a> {
        Results { visible, hidden: None, rubric: None, refused: None, leaderboard: false, layers: &[] }
    }
}

/// How a test ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Status {
    Passed,
    Failed,
    /// Not one picture came.
    Broken,
    NotYet,
}

/// One test: an aspect, by its visible or its hidden probes.
pub(super) struct Entry<'a> {
    /// "3", or "3.1" and "3.2" where hidden probes are asked.
    pub number: String,
    pub name: String,
    pub aspect: &'a AspectVerdict,
    pub verdict: &'a Verdict,
    pub visibility: Visibility,
    pub is_hidden_probe: bool,
    pub status: Status,
}

impl<'a> Results<'a> {
    /// All tests, in the lab's order. Hidden ones that are worth nothing are left out.
    pub(super) fn entries(&self) -> Vec<Entry<'a>> {
        let mut entries = Vec::new();
        for (index, aspect) in self.visible.aspects.iter().enumerate() {
            let visibility = self.rubric.map_or(Visibility::Visible, |rubric| rubric.visibility(aspect.name));
            let hidden = self.hidden.and_then(|hidden| Some((hidden, hidden.aspects.get(index)?)));
            let hidden = hidden.filter(|(_, aspect)| aspect.most > 0.0);
            let number = if hidden.is_some() { format!("{}.1", index + 1) } else { format!("{}", index + 1) };
            let (name, status) = (aspect.name.to_string(), self.status(aspect, self.visible));
            let (verdict, is_hidden_probe) = (self.visible, false);
            entries.push(Entry { number, name, aspect, verdict, visibility, is_hidden_probe, status });
            if let Some((verdict, aspect)) = hidden {
                let (number, status) = (format!("{}.2", index + 1), self.status(aspect, verdict));
                let (name, is_hidden_probe) = (format!("{}, hidden probes", aspect.name), true);
                let visibility = self.rubric.map_or(Visibility::Hidden, |rubric| rubric.hidden().visibility);
                entries.push(Entry { number, name, aspect, verdict, visibility, is_hidden_probe, status });
            }
        }
        entries
    }

    fn status(&self, aspect: &AspectVerdict, verdict: &Verdict) -> Status {
        if self.refused.is_some() || is_broken(aspect) {
            return Status::Broken;
        }
        if !verdict.is_whole && aspect.shots.is_empty() && aspect.answers.is_none() && aspect.cause.is_none() {
            return Status::NotYet;
        }
        if aspect.earned >= aspect.most { Status::Passed } else { Status::Failed }
    }

    fn verdicts(&self) -> impl Iterator<Item = &'a Verdict> + use<'a> {
        [Some(self.visible), self.hidden].into_iter().flatten()
    }

    /// Points earned by all probes.
    #[must_use]
    pub fn earned(&self) -> f64 {
        self.verdicts().map(Verdict::earned).sum()
    }

    /// The most points of all probes.
    #[must_use]
    pub fn most(&self) -> f64 {
        self.verdicts().map(Verdict::most).sum()
    }

    /// Seconds of all probes.
    #[must_use]
    pub fn seconds(&self) -> f64 {
        self.verdicts().map(|verdict| verdict.seconds).sum()
    }

    /// All of it is there.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        self.refused.is_none() && self.verdicts().all(|verdict| verdict.is_whole)
    }

    /// Nothing is found wanting.
    #[must_use]
    pub fn is_passed(&self) -> bool {
        self.refused.is_none() && self.verdicts().all(Verdict::is_passed)
    }

    /// What stands above all tests.
    pub(super) fn heading(&self) -> String {
        match self.refused {
            Some(reason) => format!("Nothing could be graded: {reason}"),
            None if self.is_whole() => String::new(),
            None => "The grader was stopped before its end; what was earned until then counts.".to_string(),
        }
    }
}

/// Whether not one of its pictures came.
fn is_broken(aspect: &AspectVerdict) -> bool {
    !aspect.shots.is_empty() && aspect.shots.iter().all(|shot| shot.answer.is_err())
}

impl Entry<'_> {
    /// Whether its text may show how the picture is wrong.
    pub fn may_show(&self) -> bool {
        !self.is_hidden_probe && self.visibility != Visibility::Hidden
    }

    /// What is to say about it, to those who see it.
    pub fn text(&self) -> String {
        if self.may_show() {
            return aspect_text(self.aspect, self.verdict);
        }
        let (aspect, faults) = (self.aspect, &self.verdict.faults);
        let (wrong, judged, unit) = (aspect.wrong(), aspect.judged(), aspect.unit());
        let mut text = format!("{}: {}\n", self.name, aspect.asks);
        let failed = aspect.shots.iter().filter(|shot| shot.answer.is_err()).count();
        if wrong > 0 {
            text += &format!("  {wrong} of {judged} {unit} are wrong.\n");
        }
        if failed > 0 {
            text += &format!("  {failed} of {} pictures did not come.\n", aspect.shots.len());
        }
        match &aspect.cause {
            None => {}
            Some(Cause::Named(fault)) => {
                let fault = &faults[*fault];
                text += &format!("  mistake: {}\n  read:    {}\n", fault.name, fault.read);
            }
            Some(Cause::FollowsFrom(fault)) => {
                text += &format!("  That follows from \"{}\".\n", faults[*fault].name);
            }
            Some(Cause::Unexplained { .. }) => text += "  No single mistake explains it.\n",
            Some(Cause::Other(_)) => text += "  Something else is wrong; the visible probes of this aspect say more.\n",
        }
        text
    }
}
