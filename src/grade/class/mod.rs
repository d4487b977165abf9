//! Class: grade many submissions that nobody trusts, and say what the class got wrong.
//!
//! folder -ROSTER-> submissions -COLLECT-> copies -BUILD-> programs, in the jail -grade-> verdicts, a file each -RANKING-> `class.json`
//!
//! Every submission has a cell: a folder that is made for it, filled with a copy of its plain files, and removed after it. What is compiled
//! and run sees that folder and the system's programs, nothing else ([`sandbox`]). A verdict is a file that appears whole; all that is said of
//! the class is computed from these files alone, so a grader that was killed goes on from them, and other points need no run.
//!
//! Cost: a compilation (a second in Rust) and some dozens of starts a submission; as many at a time as `jobs` says.

pub mod build;
mod causes;
mod collect;
mod confined;
pub mod ranking;
pub mod roster;
pub mod sandbox;
mod saved;
mod store;
pub mod worksheet;

pub use sandbox::Sandbox;
pub use saved::rescored;
pub use store::Store;

use super::functions::{FUNCTION_LABS, grade_clip, grade_triangulate};
use super::labs::{Aspect, Lab};
use super::remote::Remote;
use super::rubric::Rubric;
use super::verdict::{Cause, Request, Verdict, grade};
use build::{Built, Tools};
use confined::Confined;
use roster::Submission;
use serde_json::Value;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// How a class is graded.
pub struct Class<'a> {
    /// What is graded.
    pub lab: &'a Lab,
    /// Picks the random cases.
    pub seed: u64,
    /// Points by aspect.
    pub rubric: &'a Rubric,
    /// What holds the submissions.
    pub sandbox: &'a Sandbox,
    /// What compiles them.
    pub tools: &'a Tools,
    /// How many at a time.
    pub jobs: usize,
}

/// What became of a submission, for `verdict.json`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// It drew, well or badly.
    Graded,
    /// It never gave a picture.
    Failed,
    /// Its compiler refused.
    NotCompiled,
    /// There is nothing to run.
    Nothing,
}

impl Status {
    /// As it stands in files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Status::Graded => "graded",
            Status::Failed => "failed",
            Status::NotCompiled => "not-compiled",
            Status::Nothing => "nothing",
        }
    }
}

impl Class<'_> {
    /// Grades those of `submissions` that `store` has no verdict of; `progress` hears how many are done.
    ///
    /// # Errors
    /// In words, when results cannot be written: then the rest is not begun.
    pub fn run(
        &self,
        submissions: &[Submission],
        store: &Store,
        progress: &(dyn Fn(usize) + Sync),
    ) -> Result<(), String> {
        let (next, done) = (AtomicUsize::new(0), AtomicUsize::new(0));
        let cells = store.cells()?;
        let work = || {
            while let Some(submission) = submissions.get(next.fetch_add(1, Ordering::Relaxed)) {
                let fingerprint = collect::fingerprint(&submission.path, (self.lab.name, self.seed));
                if store.has(&submission.key, &fingerprint) {
                    progress(done.fetch_add(1, Ordering::Relaxed) + 1);
                    continue;
                }
                let cell = cells.open(self.sandbox)?;
                let verdict = self.one(submission, cell.path(), &fingerprint);
                drop(cell);
                if let Err(error) = store.keep(&submission.key, &verdict) {
                    next.store(submissions.len(), Ordering::Relaxed);
                    return Err(error);
                }
                progress(done.fetch_add(1, Ordering::Relaxed) + 1);
            }
            Ok(())
        };
        std::thread::scope(|scope| {
            let workers: Vec<_> = (0..self.jobs.max(1)).map(|_| scope.spawn(work)).collect();
            let ends =
                workers.into_iter().map(|worker| worker.join().unwrap_or_else(|_| Err("a job broke off".into())));
            ends.fold(Ok(()), Result::and)
        })
    }

    /// The verdict on one submission, as it is saved. Whatever happens, there is one.
    fn one(&self, submission: &Submission, cell: &Path, fingerprint: &str) -> Value {
        let graded = catch_unwind(AssertUnwindSafe(|| self.graded(submission, cell)));
        let graded = graded.unwrap_or_else(|panic| {
            let words = super::subject::panic_text(panic.as_ref());
            Graded::without(
                self,
                submission,
                Status::Failed,
                ("the grader failed", &format!("farop itself failed: {words}")),
            )
        });
        saved::saved(&graded, submission, (self, fingerprint))
    }

    fn graded(&self, submission: &Submission, cell: &Path) -> Graded {
        let files = collect::copy(&submission.path, cell);
        let built = match build::build(&files, cell, self) {
            Ok(built) => built,
            Err(build::NotBuilt::Nothing(words)) => {
                return Graded::without(self, submission, Status::Nothing, ("nothing to run", &words));
            }
            Err(build::NotBuilt::Refused(words)) => {
                let cause = ("does not compile", words.as_str());
                return Graded { files, ..Graded::without(self, submission, Status::NotCompiled, cause) };
            }
        };
        let (door, request) = (built.door(), self.request(submission));
        let (verdict, causes) = match built {
            Built::Function(program) => {
                let remote = Remote::new(vec![program.into()], self.sandbox.run(cell, Vec::new()));
                let verdict = self.asked(Arc::new(remote), &request);
                let causes = verdict.aspects.iter().map(|aspect| causes::of(aspect, &verdict, None)).collect();
                (verdict, causes)
            }
            built => {
                let subject = Confined::new(built, self.sandbox, cell);
                let verdict = grade(&subject, &request, &mut |_| ());
                let causes =
                    verdict.aspects.iter().map(|aspect| causes::of(aspect, &verdict, Some(&subject))).collect();
                (verdict, causes)
            }
        };
        let drew = verdict.aspects.iter().any(|aspect| aspect.judged() > 0);
        let status = if drew { Status::Graded } else { Status::Failed };
        Graded { verdict, status, door, files, causes }
    }

    /// The verdict on a function.
    fn asked(&self, remote: Arc<Remote>, request: &Request<'_>) -> Verdict {
        if self.lab.name == "clip" {
            let clip = move |polygon: &[_], volume: &_, attributes| remote.clip(polygon, volume, attributes);
            return grade_clip(&clip, request, &mut |_| ());
        }
        let triangulate = move |outline: &[_], normal| remote.triangulate(outline, normal);
        grade_triangulate(&triangulate, request, &mut |_| ())
    }

    /// Whether a function is asked for, not a rasterizer.
    fn is_about_function(&self) -> bool {
        FUNCTION_LABS.iter().any(|lab| lab.name == self.lab.name)
    }

    /// Every aspect is worth a point here: the rubric comes after, and can come again.
    fn request(&self, submission: &Submission) -> Request<'_> {
        const ONE: &dyn Fn(&Aspect) -> f64 = &|_| 1.0;
        Request { lab: self.lab, name: submission.name.clone(), seed: self.seed, points: ONE }
    }
}

/// A verdict, and what is known besides.
struct Graded {
    verdict: Verdict,
    status: Status,
    door: &'static str,
    files: Vec<String>,
    /// The short name of every aspect's cause; empty where it is right.
    causes: Vec<String>,
}

impl Graded {
    /// No points, for one reason.
    fn without(class: &Class<'_>, submission: &Submission, status: Status, (cause, words): (&str, &str)) -> Graded {
        let mut verdict = Verdict::blank(&class.request(submission));
        for (index, aspect) in verdict.aspects.iter_mut().enumerate() {
            let words = if index == 0 { words } else { "nothing was drawn" };
            aspect.cause = Some(Cause::Other(words.to_string()));
        }
        verdict.is_whole = true;
        let causes = vec![cause.to_string(); verdict.aspects.len()];
        Graded { verdict, status, door: Built::NO_DOOR, files: Vec::new(), causes }
    }
}
