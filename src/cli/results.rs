//! Where `farop grade` writes its results besides the terminal: one file a platform, whole after every picture.

use super::error::CliError;
use crate::grade::html;
use crate::grade::rubric::Rubric;
use crate::grade::write::{self, Results};
use crate::grade::{Lab, Request, Verdict};
use crate::image::save;
use clap::Args;
use std::path::{Path, PathBuf};

/// Files for graders' platforms.
#[derive(Args, Clone, Debug, Default)]
pub(super) struct ResultOptions {
    /// Ask hidden probes, too: those that this number picks
    #[arg(long, value_name = "SEED")]
    pub hidden: Option<u64>,
    /// Gradescope's results, written anew after every picture
    #[arg(long, value_name = "FILE")]
    gradescope: Option<PathBuf>,
    /// Points and wrong samples on Gradescope's leaderboard
    #[arg(long)]
    pub leaderboard: bool,
    /// PrairieLearn's results, likewise
    #[arg(long, value_name = "FILE")]
    prairielearn: Option<PathBuf>,
    /// GitHub Classroom's results (base64), likewise
    #[arg(long, value_name = "FILE")]
    classroom: Option<PathBuf>,
    /// JUnit's results, likewise
    #[arg(long, value_name = "FILE")]
    junit: Option<PathBuf>,
    /// A page with pictures, mistakes and an inspector, for eyes
    #[arg(long, value_name = "FILE.html")]
    report: Option<PathBuf>,
}

impl ResultOptions {
    fn with<'a>(&self, visible: &'a Verdict, hidden: Option<&'a Verdict>, rubric: &'a Rubric) -> Results<'a> {
        Results { hidden, rubric: Some(rubric), leaderboard: self.leaderboard, ..Results::from(visible) }
    }

    /// Writes every file that is asked for.
    pub fn write(&self, results: Results<'_>) -> Result<(), CliError> {
        let write = |path: &Option<PathBuf>, text: &dyn Fn() -> String| -> Result<(), CliError> {
            path.as_ref().map_or(Ok(()), |path: &PathBuf| write(path, &text()))
        };
        write(&self.gradescope, &|| format!("{:#}\n", write::gradescope(results)))?;
        write(&self.prairielearn, &|| format!("{}\n", write::prairielearn(results)))?;
        write(&self.classroom, &|| write::classroom(results))?;
        write(&self.junit, &|| write::junit(results))?;
        // A page takes as long to make as many pictures: it is written once there is all of it.
        if results.is_whole() || results.refused.is_some() {
            write(&self.report, &|| html::report(results))?;
        }
        Ok(())
    }

    /// Writes that nothing could be graded, and why: a platform must not be left without an answer.
    pub fn write_refusal(&self, (lab, rubric): (&Lab, &Rubric), name: &str, reason: &str) -> Result<(), CliError> {
        let points = |aspect: &crate::grade::labs::Aspect| rubric.points(aspect);
        let verdict = Verdict::blank(&Request { lab, name: name.to_string(), seed: 0, points: &points });
        self.write(Results { refused: Some(reason), ..self.with(&verdict, None, rubric) })
    }
}

fn write(path: &Path, text: &str) -> Result<(), CliError> {
    Ok(save::write_whole(path, text.as_bytes())?)
}

/// Something that grades, and hands on the verdict so far.
type Grader<'a> = dyn FnMut(&Request<'_>, &mut dyn FnMut(&Verdict)) -> Verdict + 'a;

/// A grade in the making, by visible probes and by hidden ones, written to files as it grows.
pub(super) struct Ledger<'a> {
    options: &'a ResultOptions,
    rubric: &'a Rubric,
    lab: Lab,
    name: &'a str,
    seed: u64,
    /// Labs about functions have no cases to look at.
    asks_all_hidden: bool,
    /// What holds the submission while it runs.
    layers: Vec<&'static str>,
}

impl<'a> Ledger<'a> {
    pub fn new(
        options: &'a ResultOptions,
        (lab, rubric): (&Lab, &'a Rubric),
        (name, seed): (&'a str, u64),
        asks_all_hidden: bool,
    ) -> Ledger<'a> {
        Ledger { options, rubric, lab: *lab, name, seed, asks_all_hidden, layers: Vec::new() }
    }

    /// The same about a submission that these layers hold.
    pub fn held_by(self, layers: Vec<&'static str>) -> Ledger<'a> {
        Ledger { layers, ..self }
    }

    fn write(&self, visible: &Verdict, hidden: Option<&Verdict>) -> Result<(), CliError> {
        self.options.write(Results { layers: &self.layers, ..self.options.with(visible, hidden, self.rubric) })
    }

    /// Grades by visible probes, then by hidden ones; the first failure to write is told at the end, and the grade goes on.
    pub fn fill(&self, grade: &mut Grader<'_>) -> Result<(Verdict, Option<Verdict>), CliError> {
        let hidden_lab = self.lab.hidden();
        let points = |aspect: &crate::grade::labs::Aspect| self.rubric.points(aspect) * (1.0 - self.share(aspect));
        let hidden_points = |aspect: &crate::grade::labs::Aspect| self.rubric.points(aspect) * self.share(aspect);
        let name = || self.name.to_string();
        let request = Request { lab: &self.lab, name: name(), seed: self.seed, points: &points };
        let later =
            self.options.hidden.map(|seed| Request { lab: &hidden_lab, name: name(), seed, points: &hidden_points });
        let mut trouble = None;
        let not_yet = later.as_ref().map(Verdict::blank);
        // Whoever is stopped before the first picture must leave a file, too.
        self.write(&Verdict::blank(&request), not_yet.as_ref())?;
        let visible = grade(&request, &mut |so_far| {
            trouble = trouble.take().or(self.write(so_far, not_yet.as_ref()).err());
        });
        let hidden = later.map(|request| {
            grade(&request, &mut |so_far| {
                trouble = trouble.take().or(self.write(&visible, Some(so_far)).err());
            })
        });
        trouble.map_or(Ok((visible, hidden)), Err)
    }

    /// How much of an aspect's points hidden probes give.
    fn share(&self, aspect: &crate::grade::labs::Aspect) -> f64 {
        let asks = self.options.hidden.is_some() && (self.asks_all_hidden || !(aspect.cases)(self.seed).is_empty());
        if asks { self.rubric.hidden().share } else { 0.0 }
    }
}
