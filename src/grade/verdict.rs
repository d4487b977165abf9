//! Verdict: draw the cases of a lab, hold every pixel against the contract, and say what is wrong.
//!
//! Lab, Subject -SHOOT-> pictures -JUDGE-> wrong pixels -[`super::diagnose`]-> causes -> points
//!
//! Points: an aspect gives its points by the share of its cases that are right. What an earlier aspect's mistake explains
//! costs nothing more: it *follows from* that. Pictures come first and causes after, so whoever stops the grader keeps what was
//! earned: [`grade`] hands the verdict so far to its caller after every picture.

use super::case::Case;
use super::diagnose::{self, Fault};
use super::labs::{Aspect, Lab, Watch};
use super::paint::{Painted, paint};
use super::rules::Rules;
use super::subject::{Answer, Failure, Subject};
use super::watch;
use super::witness::Witness;
use crate::image::Picture;
use std::time::Instant;

/// One case, drawn and judged.
#[derive(Clone, Debug)]
pub struct Shot {
    /// What was to be drawn.
    pub case: Case,
    /// The picture; or why there is none.
    pub answer: Result<Answer, Failure>,
    /// Pixels that are wrong by the contract, in rows from the top.
    pub wrong: Vec<usize>,
    /// Pixels judged.
    pub judged: usize,
    /// What else is wrong.
    pub complaint: Option<String>,
    /// The case with its list reversed, and the picture of that, when it is wrong.
    pub turned: Option<(Case, Picture)>,
}

impl Shot {
    /// Whether nothing is wrong.
    #[must_use]
    pub fn is_right(&self) -> bool {
        self.answer.is_ok() && self.wrong.is_empty() && self.complaint.is_none()
    }

    /// The picture, if there is one.
    #[must_use]
    pub fn picture(&self) -> Option<&Picture> {
        self.answer.as_ref().ok().map(|answer| &answer.picture)
    }
}

/// Why an aspect is found wanting.
#[derive(Clone, Debug)]
pub enum Cause {
    /// A mistake with a name: its number among [`Verdict::faults`].
    Named(usize),
    /// An earlier aspect's mistake explains it.
    FollowsFrom(usize),
    /// No mistake explains 95 % of the wrong pixels better than all others.
    Unexplained {
        /// Name of the mistake that explains most.
        closest: &'static str,
        /// Of the wrong pixels, those it explains.
        explained: usize,
        /// Name of the next.
        next: &'static str,
        /// What that explains.
        next_explained: usize,
    },
    /// Something that is no matter of pixels, in words.
    Other(String),
}

/// What a function answered about one aspect.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Answers {
    /// Questions answered wrongly.
    pub wrong: usize,
    /// Questions asked.
    pub judged: usize,
    /// What a question is called, plural.
    pub unit: &'static str,
    /// The smallest question answered wrongly, several lines; empty when there is none.
    pub witness: String,
}

/// What was found about one aspect.
#[derive(Clone, Debug)]
pub struct AspectVerdict {
    /// Its name.
    pub name: &'static str,
    /// What it asks.
    pub asks: &'static str,
    /// The most points.
    pub most: f64,
    /// Points earned.
    pub earned: f64,
    /// Its cases as far as they are drawn.
    pub shots: Vec<Shot>,
    /// Why it is wanting; `None` when it is not.
    pub cause: Option<Cause>,
    /// A small failing case.
    pub witness: Option<Witness>,
    /// In labs about functions: its questions, in place of shots.
    pub answers: Option<Answers>,
    /// Seconds that its pictures or questions took.
    pub seconds: f64,
}

impl AspectVerdict {
    pub(super) fn blank(aspect: &Aspect, most: f64) -> AspectVerdict {
        let Aspect { name, asks, .. } = *aspect;
        let (earned, seconds, shots) = (0.0, 0.0, Vec::new());
        AspectVerdict { name, asks, most, earned, shots, cause: None, witness: None, answers: None, seconds }
    }

    /// Wrong pixels of all its cases; wrong answers of a function.
    #[must_use]
    pub fn wrong(&self) -> usize {
        let pixels = || self.shots.iter().map(|shot| shot.wrong.len()).sum();
        self.answers.as_ref().map_or_else(pixels, |answers| answers.wrong)
    }

    /// Pixels judged; questions to a function.
    #[must_use]
    pub fn judged(&self) -> usize {
        let pixels = || self.shots.iter().map(|shot| shot.judged).sum();
        self.answers.as_ref().map_or_else(pixels, |answers| answers.judged)
    }

    /// What is judged, plural.
    #[must_use]
    pub fn unit(&self) -> &'static str {
        self.answers.as_ref().map_or("samples", |answers| answers.unit)
    }

    /// Whether every case is right.
    #[must_use]
    pub fn is_right(&self) -> bool {
        self.shots.iter().all(Shot::is_right) && !matches!(self.cause, Some(Cause::Other(_)))
    }

    fn points_by_cases(&self) -> f64 {
        let right = self.shots.iter().filter(|shot| shot.is_right()).count();
        if self.shots.is_empty() {
            return if self.is_right() { self.most } else { 0.0 };
        }
        self.most * right as f64 / self.shots.len() as f64
    }
}

/// A whole grade, or as much of it as there is.
#[derive(Clone, Debug, Default)]
pub struct Verdict {
    /// The lab's name.
    pub lab: &'static str,
    /// Who was graded.
    pub subject: String,
    /// In the lab's order.
    pub aspects: Vec<AspectVerdict>,
    /// Mistakes with a name.
    pub faults: Vec<Fault>,
    /// What is worth knowing and costs no points.
    pub notes: Vec<String>,
    /// All of it is there.
    pub is_whole: bool,
    /// Seconds so far.
    pub seconds: f64,
}

impl Verdict {
    /// Nothing asked yet.
    #[must_use]
    pub fn blank(request: &Request<'_>) -> Verdict {
        let aspects = request.lab.aspects.iter();
        Verdict {
            lab: request.lab.name,
            subject: request.name.clone(),
            aspects: aspects.map(|aspect| AspectVerdict::blank(aspect, (request.points)(aspect))).collect(),
            ..Verdict::default()
        }
    }

    /// Points earned.
    #[must_use]
    pub fn earned(&self) -> f64 {
        self.aspects.iter().map(|aspect| aspect.earned).sum()
    }

    /// The most points.
    #[must_use]
    pub fn most(&self) -> f64 {
        self.aspects.iter().map(|aspect| aspect.most).sum()
    }

    /// Pictures were asked for and not one came.
    #[must_use]
    pub fn is_blank(&self) -> bool {
        let mut shots = self.aspects.iter().flat_map(|aspect| &aspect.shots).peekable();
        shots.peek().is_some() && shots.all(|shot| shot.answer.is_err())
    }

    /// Nothing is found wanting but what is accepted.
    #[must_use]
    pub fn is_passed(&self) -> bool {
        self.is_whole && self.earned() >= self.most()
    }
}

/// What a grade is asked for with.
pub struct Request<'a> {
    /// What is graded.
    pub lab: &'a Lab,
    /// Its name, for reports.
    pub name: String,
    /// Picks the random cases.
    pub seed: u64,
    /// The most points of an aspect.
    pub points: &'a dyn Fn(&Aspect) -> f64,
}

/// Grades `subject`; `progress` gets the verdict so far after every picture.
pub fn grade(subject: &dyn Subject, request: &Request<'_>, progress: &mut dyn FnMut(&Verdict)) -> Verdict {
    let start = Instant::now();
    let mut verdict = Verdict::blank(request);
    for (index, aspect) in request.lab.aspects.iter().enumerate() {
        for (case, answer) in drawn(subject, request.lab.cases(aspect, request.seed)) {
            let shot = shoot(subject, case, answer, aspect.watch);
            let aspect = &mut verdict.aspects[index];
            aspect.shots.push(shot);
            let seconds = start.elapsed().as_secs_f64();
            aspect.seconds += seconds - verdict.seconds;
            verdict.seconds = seconds;
            progress(&verdict);
        }
        if aspect.watch == Watch::Cost {
            let drew = verdict.aspects.iter().flat_map(|aspect| &aspect.shots).any(|shot| shot.answer.is_ok());
            let words = if drew { watch::cost(subject) } else { Some(watch::NOTHING.to_string()) };
            verdict.aspects[index].cause = words.map(Cause::Other);
        }
        let now = &mut verdict.aspects[index];
        now.earned = now.points_by_cases();
        progress(&verdict);
    }
    diagnose::explain(subject, request.lab, &mut verdict);
    verdict.notes.extend(watch::unseen(subject, request.lab));
    verdict.is_whole = true;
    verdict.seconds = start.elapsed().as_secs_f64();
    progress(&verdict);
    verdict
}

type Drawn = Result<Answer, Failure>;

/// Each case with its answer: one by one, so that whoever is asked in vain is asked late; together where that saves starts.
fn drawn<'a>(subject: &'a dyn Subject, cases: Vec<Case>) -> Box<dyn Iterator<Item = (Case, Drawn)> + 'a> {
    let for_subject = |case: Case| {
        let answered_in_levels = subject.answers_in_levels();
        Case { answered_in_levels, ..case.cut_for(subject.accepts()) }
    };
    let cases: Vec<Case> = cases.into_iter().map(for_subject).collect();
    let list = |case: &Case| case.list(subject.accepts());
    let is_one_sheet = cases.windows(2).all(|pair| pair[0].sheet() == pair[1].sheet());
    if subject.batch() > 1 && is_one_sheet && cases.len() > 1 {
        let lists: Vec<_> = cases.iter().map(list).collect();
        let answers = subject.draw_all(&lists, &cases[0].sheet());
        return Box::new(cases.into_iter().zip(answers));
    }
    Box::new(cases.into_iter().map(move |case| {
        let answer = subject.draw(&list(&case), &case.sheet());
        (case, answer)
    }))
}

/// Judges one case by the contract.
fn shoot(subject: &dyn Subject, case: Case, answer: Drawn, watch: Watch) -> Shot {
    let right = paint(&case, &Rules::default());
    let answer = checked(answer, &right);
    let mut shot = Shot { case, answer, wrong: Vec::new(), judged: 0, complaint: None, turned: None };
    let Ok(answer) = &shot.answer else { return shot };
    shot.wrong = wrong(&answer.picture, &right);
    shot.judged = right.disputed.iter().filter(|&&disputed| !disputed).count();
    shot.complaint = watch::complaint(subject, &mut shot, watch);
    shot
}

/// A picture of another size cannot be judged pixel by pixel.
pub(super) fn checked(answer: Result<Answer, Failure>, right: &Painted) -> Result<Answer, Failure> {
    let answer = answer?;
    let (width, height) = (answer.picture.width(), answer.picture.height());
    if (width, height) == (right.width, right.height) {
        return Ok(answer);
    }
    let exchanged = (height, width) == (right.width, right.height);
    let hint =
        if exchanged { "Width comes first, then height." } else { "The size is in the head of the screen file." };
    Err(Failure {
        message: format!(
            "the picture is {width} x {height}, not {} x {}{}",
            right.width,
            right.height,
            if exchanged { ": width and height are exchanged" } else { "" }
        ),
        hint: hint.to_string(),
    })
}

/// The pixels of `picture` that `right` does not allow.
pub(super) fn wrong(picture: &Picture, right: &Painted) -> Vec<usize> {
    picture.colors().enumerate().filter(|&(index, level)| !right.allows(index, level)).map(|(index, _)| index).collect()
}
