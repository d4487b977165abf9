//! Confined: a submission of a class as a subject of the grader, and its patience.
//!
//! DrawList -CONFINED-> jail -> Picture, or the reason why there is none
//!
//! One that hangs would be waited for at each of a hundred pictures, and one that fills its memory takes a second for each. So after some
//! time-outs, after many failures and no picture at all, or when the time for all pictures is used up, the rest is not asked for any more: its
//! points are lost, and the class goes on.

use super::Sandbox;
use super::build::Built;
use crate::color::Encoding;
use crate::grade::harness::{ACCEPTS, Remark, TRIANGLES, WATCH};
use crate::grade::subject::{Answer, Failure, Subject};
use crate::plan::Accepts;
use crate::raster::external::{self, External, Limits};
use crate::raster::{Order, PutCounts};
use crate::screen::DrawList;
use crate::screen::file::Sheet;
use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::ffi::OsString;
use std::path::Path;
use std::time::{Duration, Instant};

/// Time-outs after which nothing more is asked.
const PATIENCE: u32 = 2;
/// Failures after which nothing more is asked of one that has not drawn a single picture. Counted, so that no busy machine changes a grade.
const FRUITLESS: usize = 24;
/// Time for all pictures of a submission together.
const ALL: Duration = Duration::from_secs(300);
/// Lists in one run.
const BATCH: usize = 24;

/// A submission that was built.
pub(super) struct Confined {
    external: External,
    /// A Rust submission's program: it says more than pictures.
    watcher: Option<External>,
    accepts: Accepts,
    /// A program did not draw several lists in one run, or not as it draws them alone.
    draws_one: Cell<bool>,
    is_trusted: Cell<bool>,
    time_outs: Cell<u32>,
    used: Cell<Duration>,
    /// How often it failed before its first picture; none once there was one.
    fruitless: Cell<Option<usize>>,
    last: RefCell<Option<Failure>>,
    /// How its cell's path begins: chance, which no report repeats.
    place: String,
    /// Names of failures by what they say.
    failures: RefCell<BTreeMap<String, &'static str>>,
}

impl Confined {
    /// What was built in `cell`.
    pub fn new(built: Built, sandbox: &Sandbox, cell: &Path) -> Confined {
        let limits = sandbox.run(cell, Vec::new());
        let mut accepts = Accepts::AnyPolygon;
        let (external, watcher) = match built {
            Built::Rust(program) | Built::Function(program) => {
                let with = |word: &str| vec![program.clone().into(), OsString::from(word)];
                if answers(&with(ACCEPTS), &limits).as_deref() == Some(TRIANGLES) {
                    accepts = Accepts::Triangles;
                }
                let watcher = External::program("the submission", with(WATCH)).with_limits(limits.clone());
                let program = External::program("the submission", vec![program.into()]);
                (program.with_limits(limits), Some(watcher))
            }
            Built::Library(path) => {
                let host = external::host().map(Path::to_path_buf).into_iter().collect();
                (External::library("the submission", path).with_limits(sandbox.run(cell, host)), None)
            }
            Built::Program(words, _) => (External::program("the submission", words).with_limits(limits), None),
        };
        Confined {
            external,
            watcher,
            accepts,
            draws_one: Cell::default(),
            is_trusted: Cell::default(),
            time_outs: Cell::default(),
            used: Cell::default(),
            fruitless: Cell::new(Some(0)),
            last: RefCell::default(),
            place: format!("{}/", cell.display()),
            failures: RefCell::default(),
        }
    }

    /// The short name of the failure that says `message`.
    pub fn failure(&self, message: &str) -> Option<&'static str> {
        self.failures.borrow().get(message).copied()
    }

    /// Why nothing is asked any more.
    fn impatient(&self) -> Option<Failure> {
        if self.fruitless.get().is_some_and(|count| count >= FRUITLESS) {
            return self.last.borrow().clone();
        }
        let words = if self.time_outs.get() >= PATIENCE {
            format!("not asked for any more, after {PATIENCE} pictures that did not come in time")
        } else if self.used.get() > ALL {
            format!("not asked for any more: all pictures together took longer than {} s", ALL.as_secs())
        } else {
            return None;
        };
        self.failures.borrow_mut().insert(words.clone(), "time-out");
        Some(Failure { message: words, hint: "Look for an endless loop.".to_string() })
    }

    fn seen(&self, answer: &external::Answer, sheet: &Sheet) -> Answer {
        self.fruitless.set(None);
        let picture = answer.image.average(sheet.samples as usize).encode(Encoding::Linear);
        let puts = remark(answer).filter(|_| self.watcher.is_some()).map(|remark| {
            let stray_writes = remark.stray;
            PutCounts { stray_writes, ..PutCounts::default() }
        });
        Answer { picture, puts }
    }

    /// Measures what `work` takes.
    fn timed<T>(&self, work: impl FnOnce() -> T) -> T {
        let start = Instant::now();
        let value = work();
        self.used.set(self.used.get() + start.elapsed());
        value
    }

    /// All pictures from one run, where that can be trusted.
    fn together(&self, lists: &[DrawList], sheet: &Sheet) -> Option<Vec<Answer>> {
        let answers = self.timed(|| self.external.at_once(lists, sheet))?;
        let answers: Vec<_> = answers.iter().map(|answer| self.seen(answer, sheet)).collect();
        // A Rust submission is asked again and again by the contract; a program need draw only one picture, and what is left over from
        // that in the next must not count against it.
        if self.watcher.is_none() && !self.is_trusted.get() {
            let alone = self.draw(lists.last()?, sheet).ok()?;
            if alone.picture != answers.last()?.picture {
                return None;
            }
            self.is_trusted.set(true);
        }
        Some(answers)
    }
}

/// The first line that a program prints.
fn answers(words: &[OsString], limits: &Limits) -> Option<String> {
    let run = external::run(words, limits).ok()?;
    String::from_utf8(run.stdout).ok()?.lines().next().map(str::to_string)
}

fn remark(answer: &external::Answer) -> Option<Remark> {
    serde_json::from_str(answer.remark.as_ref()?).ok()
}

impl Subject for Confined {
    fn draw(&self, list: &DrawList, sheet: &Sheet) -> Result<Answer, Failure> {
        if let Some(failure) = self.impatient() {
            return Err(failure);
        }
        let answer = self.timed(|| self.external.picture(list, sheet)).map_err(|failure| {
            if failure.name() == "time-out" {
                self.time_outs.set(self.time_outs.get() + 1);
            }
            let message = failure.to_string().replace(&self.place, "");
            self.failures.borrow_mut().insert(message.clone(), failure.name());
            let failed =
                Failure { message, hint: "Draw the file of this case alone: farop suite writes it.".to_string() };
            self.fruitless.set(self.fruitless.get().map(|count| count + 1));
            *self.last.borrow_mut() = Some(failed.clone());
            failed
        })?;
        Ok(self.seen(&answer, sheet))
    }

    fn batch(&self) -> usize {
        if self.draws_one.get() { 1 } else { BATCH }
    }

    fn draw_all(&self, lists: &[DrawList], sheet: &Sheet) -> Vec<Result<Answer, Failure>> {
        if lists.len() > 1 && !self.draws_one.get() && self.impatient().is_none() {
            if let Some(answers) = self.together(lists, sheet) {
                return answers.into_iter().map(Ok).collect();
            }
            // One list on which a Rust submission breaks off does not make it a program of one picture.
            self.draws_one.set(self.watcher.is_none());
        }
        lists.iter().map(|list| self.draw(list, sheet)).collect()
    }

    fn order(&self, list: &DrawList, sheet: &Sheet) -> Option<Order> {
        let watcher = self.watcher.as_ref().filter(|_| self.impatient().is_none())?;
        let answer = self.timed(|| watcher.picture(list, sheet)).ok()?;
        Some(remark(&answer)?.order())
    }

    fn can_be_watched(&self) -> bool {
        self.watcher.is_some()
    }

    fn accepts(&self) -> Accepts {
        self.accepts
    }

    fn answers_in_levels(&self) -> bool {
        self.watcher.is_none()
    }
}
