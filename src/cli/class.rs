//! `farop grade LAB --class DIR`: a class of submissions that nobody trusts.

use super::error::{self, CliError, notice, tell};
use super::grade::read_rubric;
use crate::grade::Lab;
use crate::grade::class::build::Tools;
use crate::grade::class::ranking;
use crate::grade::class::roster::{Submission, roster};
use crate::grade::class::worksheet::worksheet;
use crate::grade::class::{Class, Sandbox, Store, rescored};
use clap::Args;
use serde_json::{Value, json};
use std::io::IsTerminal;
use std::path::{Path, PathBuf};

/// Options of a class.
#[derive(Args)]
pub(super) struct ClassOptions {
    /// Grade a class: a folder with a folder or file for each submission (docs/class.md)
    #[arg(long = "class", value_name = "DIR", group = "untrusted", conflicts_with_all = ["rasterizer", "pictures", "bundle", "watch", "extremes", "witness", "hidden", "gradescope", "leaderboard", "prairielearn", "classroom", "junit", "report", "hint"])]
    pub folder: Option<PathBuf>,
    /// With --class: where results go [default: DIR.graded]
    #[arg(long, value_name = "DIR", requires = "folder")]
    results: Option<PathBuf>,
    /// With --class: go on with the results that are there
    #[arg(long, requires = "folder")]
    resume: bool,
    /// With --class: other points for the results that are there; nothing is run
    #[arg(long, value_name = "RUBRIC", requires = "folder", conflicts_with_all = ["resume", "rubric"])]
    rescore: Option<PathBuf>,
    /// With --class: how many at a time [default: one a processor]
    #[arg(long, value_name = "N", requires = "folder", value_parser = clap::value_parser!(u32).range(1..=256))]
    jobs: Option<u32>,
    /// With --class or --submission: seconds for a picture [default: 5]
    #[arg(long, value_name = "S", requires = "untrusted", value_parser = clap::value_parser!(u64).range(1..=600))]
    time: Option<u64>,
    /// With either: the folder with libfarop.rlib and deps [default: beside this program]
    #[arg(long, value_name = "DIR", requires = "untrusted")]
    library: Option<PathBuf>,
    /// With either, as root: submissions run as root, too
    #[arg(long, requires = "untrusted")]
    as_root: bool,
    /// With either: run submissions even where a protection is missing
    #[arg(long, requires = "untrusted")]
    unsafe_no_sandbox: bool,
}

impl ClassOptions {
    /// What holds submissions and what compiles them.
    pub fn holders(&self) -> Result<(Sandbox, Tools), CliError> {
        Ok((self.sandbox()?, Tools::find(self.library.as_deref())))
    }

    /// What holds the submissions; a layer that is missing and may be is told.
    fn sandbox(&self) -> Result<Sandbox, CliError> {
        let sandbox = Sandbox::new(self.as_root, self.unsafe_no_sandbox).map_err(CliError::failed)?;
        for name in sandbox.missing() {
            notice(&format!("submissions are not held by this layer: {name}"));
        }
        Ok(match self.time {
            Some(seconds) => sandbox.with_time(std::time::Duration::from_secs(seconds)),
            None => sandbox,
        })
    }

    /// Grades the class, or scores it anew.
    pub fn run(&self, lab: &Lab, (seed, rubric): (u64, Option<&Path>), json: bool) -> Result<(), CliError> {
        let folder = self.folder.clone().unwrap_or_default();
        let results = self.results.clone().unwrap_or_else(|| beside(&folder));
        if let Some(path) = &self.rescore {
            return rescore(&results, lab, path, json);
        }
        let rubric = read_rubric(rubric, lab)?;
        let submissions = roster(&folder).map_err(CliError::failed)?;
        if submissions.is_empty() {
            return Err(CliError::failed(format!(
                "{} holds no submissions: a folder or a file for each is expected",
                folder.display()
            )));
        }
        let (sandbox, tools) = self.holders()?;
        let has_rust = submissions.iter().any(|submission| holds_rust(&submission.path));
        if let Some(trouble) = tools.trouble().filter(|_| has_rust) {
            return Err(CliError::failed(trouble));
        }
        let store = Store::open(&results, self.resume).map_err(CliError::failed)?;
        let jobs = self.jobs.unwrap_or_else(crate::render::available_threads) as usize;
        let class = Class { lab, seed, rubric: &rubric, sandbox: &sandbox, tools: &tools, jobs };
        let (count, shows) = (submissions.len(), std::io::stderr().is_terminal());
        let progress = |done: usize| {
            if shows {
                tell(&format!("\r{done} of {count} submissions"));
            }
        };
        class.run(&submissions, &store, &progress).map_err(CliError::failed)?;
        if shows {
            tell("\n");
        }
        let keys: Vec<&str> = submissions.iter().map(|submission: &Submission| submission.key.as_str()).collect();
        // What was kept from a run with another rubric gets this one's points.
        let verdicts: Vec<Value> =
            store.verdicts(Some(&keys)).into_iter().map(|verdict| rescored(verdict, lab, &rubric)).collect();
        finish(&store, &verdicts, &head(lab, &json!(seed), &json!(sandbox.layers())), json)
    }
}

fn head(lab: &Lab, seed: &Value, layers: &Value) -> Value {
    json!({ "lab": lab.name, "seed": seed, "sandbox": layers })
}

/// `DIR.graded`.
fn beside(folder: &Path) -> PathBuf {
    let absolute = std::path::absolute(folder).unwrap_or_else(|_| folder.to_path_buf());
    let mut name = absolute.file_name().unwrap_or_default().to_os_string();
    name.push(".graded");
    absolute.with_file_name(name)
}

/// Whether a submission has a `.rs` file at the top or one folder below.
fn holds_rust(path: &Path) -> bool {
    let is_rust = |path: &Path| path.extension().is_some_and(|ending| ending == "rs");
    let inside = |folder: &Path| std::fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
    is_rust(path) || inside(path).any(|path| is_rust(&path) || inside(&path).any(|path| is_rust(&path)))
}

fn rescore(results: &Path, lab: &Lab, path: &Path, json: bool) -> Result<(), CliError> {
    let rubric = read_rubric(Some(path), lab)?;
    let store = Store::existing(results).map_err(CliError::failed)?;
    let saved = store.verdicts(None);
    if let Some(other) = saved.iter().find(|verdict| verdict["lab"] != lab.name) {
        let name = other["lab"].as_str().unwrap_or("another");
        return Err(CliError::failed(format!("{} has results of lab {name}, not of {}", results.display(), lab.name)));
    }
    let Some(first) = saved.first() else {
        return Err(CliError::failed(format!("{} has no verdicts", results.display())));
    };
    let head = head(lab, &first["seed"], &first["sandbox"]["layers"]);
    let verdicts: Vec<Value> = saved.into_iter().map(|verdict| rescored(verdict, lab, &rubric)).collect();
    finish(&store, &verdicts, &head, json)
}

/// Writes what is said of the class, and the verdicts with the points of now.
fn finish(store: &Store, verdicts: &[Value], head: &Value, json: bool) -> Result<(), CliError> {
    for verdict in verdicts {
        store.keep(verdict["submission"]["key"].as_str().unwrap_or_default(), verdict).map_err(CliError::failed)?;
    }
    let class = ranking::class(verdicts, head);
    store.keep_class("class.json", &format!("{class:#}\n")).map_err(CliError::failed)?;
    store.keep_class("grades.csv", &worksheet(verdicts)).map_err(CliError::failed)?;
    store.keep_index().map_err(CliError::failed)?;
    error::print(&if json { format!("{class:#}\n") } else { ranking::summary(&class) })
}
