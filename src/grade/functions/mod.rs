//! Functions: labs in which a step of the geometry stage is written, and graded as a function, not by a picture.
//!
//! case -student's function-> answer -JUDGE (exact)-> complaint -NAME-> cause -> points
//!
//! An aspect's points go by the share of its cases that are right. A mistake is named when it fits every wrong answer of an
//! aspect and no right one speaks against it, and when only one does. It is charged to the aspect where it costs most; what fits it
//! elsewhere *follows from* it and costs nothing more, but for mistakes that leave the step undone.
//!
//! Cost: a few hundred calls of the function.

mod clip;
mod explain;
mod labs;
mod triangulate;

pub use labs::FUNCTION_LABS;

use super::hidden::Probes;
use super::labs::Aspect;
use super::verdict::{Answers, AspectVerdict, Request, Verdict};
use crate::raster::functions::{ClipFunction, TriangulateFunction};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Instant;

/// A mistake that can be named.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Mistake {
    /// Its name.
    pub name: &'static str,
    /// The cause, in one sentence.
    pub cause: &'static str,
    /// The right rule.
    pub rule: &'static str,
    /// What follows from it costs nothing more.
    pub is_forgiven: bool,
    /// Above 0 where it shows by where answers fail, not by what they are: of mistakes that explain as much as each other the highest
    /// is meant.
    pub special: u8,
}

/// A lab as the grader asks it.
pub(super) trait Exercise {
    /// A question.
    type Case: Clone;
    /// What the function answers, or how it failed.
    type Answer;

    /// The questions of an aspect.
    fn cases(&self, aspect: &str, seed: u64) -> Vec<Self::Case>;
    /// Asks the function.
    fn ask(&self, case: &Self::Case) -> Self::Answer;
    /// What is wrong with an answer.
    fn complaint(&self, case: &Self::Case, answer: &Self::Answer) -> Option<String>;
    /// All mistakes that have a name.
    fn mistakes(&self) -> Vec<Mistake>;
    /// Whether someone who makes mistake number `mistake` gives this answer, which is right or not.
    fn fits(&self, mistake: usize, case: &Self::Case, answer: &Self::Answer, is_right: bool) -> bool;
    /// Cases that are a little smaller.
    fn smaller(&self, case: &Self::Case) -> Vec<Self::Case>;
    /// A wrong answer for a reader, several lines.
    fn show(&self, case: &Self::Case, answer: &Self::Answer, complaint: &str) -> String;
    /// What a case is called in counts, plural.
    fn unit(&self) -> &'static str;
    /// Where to read.
    fn read(&self) -> &'static str;
}

/// A question with its answer.
pub(super) struct Asked<E: Exercise> {
    pub case: E::Case,
    pub answer: E::Answer,
    pub complaint: Option<String>,
    /// Which mistakes give this answer, by number; filled in when something is wrong.
    pub fits: Vec<bool>,
}

impl<E: Exercise> Asked<E> {
    fn new(exercise: &E, case: E::Case) -> Asked<E> {
        let answer = exercise.ask(&case);
        let complaint = exercise.complaint(&case, &answer);
        Asked { case, answer, complaint, fits: Vec::new() }
    }
}

/// Grades a clip; `progress` gets the verdict so far after every aspect.
pub fn grade_clip(clip: &ClipFunction, request: &Request<'_>, progress: &mut dyn FnMut(&Verdict)) -> Verdict {
    run(&clip::ClipExercise::new(clip), request, progress)
}

/// Grades a triangulation; `progress` gets the verdict so far after every aspect.
pub fn grade_triangulate(
    triangulate: &TriangulateFunction,
    request: &Request<'_>,
    progress: &mut dyn FnMut(&Verdict),
) -> Verdict {
    run(&triangulate::TriangulateExercise(triangulate), request, progress)
}

fn run<E: Exercise>(exercise: &E, request: &Request<'_>, progress: &mut dyn FnMut(&Verdict)) -> Verdict {
    let start = Instant::now();
    let mut verdict = Verdict::blank(request);
    let mut asked: Vec<Vec<Asked<E>>> = Vec::new();
    // Hidden questions are those of a seed that no small number is.
    let seed = if request.lab.probes == Probes::Hidden { request.seed ^ 0x000F_AB1E << 32 } else { request.seed };
    for (Aspect { name, .. }, now) in request.lab.aspects.iter().zip(0..) {
        let answers: Vec<_> = exercise.cases(name, seed).into_iter().map(|case| Asked::new(exercise, case)).collect();
        let wrong = answers.iter().filter(|asked| asked.complaint.is_some()).count();
        let aspect: &mut AspectVerdict = &mut verdict.aspects[now];
        let judged = answers.len();
        aspect.earned = aspect.most * (judged - wrong) as f64 / judged.max(1) as f64;
        aspect.answers = Some(Answers { wrong, judged, unit: exercise.unit(), witness: String::new() });
        asked.push(answers);
        let seconds = start.elapsed().as_secs_f64();
        aspect.seconds = seconds - verdict.seconds;
        verdict.seconds = seconds;
        progress(&verdict);
    }
    explain::explain(exercise, &mut asked, &mut verdict);
    verdict.is_whole = true;
    verdict.seconds = start.elapsed().as_secs_f64();
    progress(&verdict);
    verdict
}

/// Calls a function that may panic.
fn called<T>(function: impl FnOnce() -> T) -> Result<T, String> {
    catch_unwind(AssertUnwindSafe(function))
        .map_err(|panic| format!("the function panicked: {}", super::subject::panic_text(panic.as_ref())))
}
