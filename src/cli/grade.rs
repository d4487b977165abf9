//! `farop grade`: what is wrong with a rasterizer or a function, why, and the smallest case that shows it.

use super::class::ClassOptions;
use super::error::{self, CliError, notice};
use super::results::{Ledger, ResultOptions};
use super::scenes::{Chosen, find_rasterizer};
use crate::grade::bundle::Order;
use crate::grade::class::with_submission;
use crate::grade::folder::Pictures;
use crate::grade::functions::{FUNCTION_LABS, grade_clip, grade_triangulate};
use crate::grade::handout;
use crate::grade::rubric::Rubric;
use crate::grade::{self, InProcess, Lab, Outside, Subject, Verdict, write};
use crate::image::save;
use crate::raster::Registry;
use clap::Args;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

/// The verdict by visible probes, and by hidden ones.
type Judged = (Verdict, Option<Verdict>);

/// Grade a rasterizer: points, the mistake by its name, the smallest case
#[derive(Args)]
#[command(
    after_help = "Examples:\n  farop grade zbuffer -r mine --witness small.scr\n  farop grade zbuffer --class submissions --jobs 4"
)]
pub(super) struct GradeCommand {
    /// Which lab (`farop list labs` has the names)
    lab: String,
    /// Rasterizer; in `clip` and `triangulate` a function
    #[arg(short, long, value_name = "NAME", required_unless_present_any = ["pictures", "submission", "hint", "bundle", "folder"])]
    rasterizer: Option<String>,
    /// Folder of PPM or PNG pictures drawn elsewhere from the files of `farop suite LAB`
    #[arg(long, value_name = "DIR", conflicts_with = "rasterizer")]
    pictures: Option<PathBuf>,
    /// One submission as a platform has it, a file or a folder; compiled and run in the jail
    #[arg(long, value_name = "PATH", group = "untrusted", conflicts_with_all = ["rasterizer", "pictures", "watch", "extremes"])]
    submission: Option<PathBuf>,
    /// Write what a platform wants uploaded (gradescope), as a .zip or a folder
    #[arg(long, num_args = 2, value_names = ["PLATFORM", "PATH"])]
    bundle: Option<Vec<PathBuf>>,
    /// Print a hint: 1 asks, 2 tells the idea, 3 is nearly the code
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=i64::from(handout::HINTS)))]
    hint: Option<u32>,
    /// Grade again whenever the pictures, or this program, change
    #[arg(long)]
    watch: bool,
    /// Picks the random cases
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// Smallest case of the first mistake, as a screen file
    #[arg(short = 'o', long, value_name = "FILE")]
    witness: Option<PathBuf>,
    #[command(flatten)]
    results: ResultOptions,
    /// Points by aspect, TOML
    #[arg(long, value_name = "FILE")]
    rubric: Option<PathBuf>,
    /// Instead of points: at which size, offset or depth it begins to be wrong
    #[arg(long, conflicts_with_all = ["pictures", "watch", "hidden", "gradescope", "prairielearn", "classroom", "junit", "rubric"])]
    extremes: bool,
    /// The verdict as JSON on standard output
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    class: ClassOptions,
}

impl GradeCommand {
    pub fn run(self, registry: &Registry) -> Result<(), CliError> {
        let labs = || grade::LABS.iter().chain(FUNCTION_LABS);
        let lab = labs().find(|lab| lab.name == self.lab).ok_or_else(|| {
            let names: Vec<_> = labs().map(|lab| lab.name).collect();
            CliError::failed(format!("there is no lab `{}`; there is {}", self.lab, names.join(", ")))
        })?;
        if let Some(number) = self.hint {
            let hint = handout::hint(lab.name, number).unwrap_or("There is none.");
            return error::print(&format!("{hint}\n"));
        }
        if self.extremes {
            let name = self.rasterizer.as_deref().unwrap_or("zbuffer");
            return super::extremes::run(lab, (name, registry), self.witness.as_deref(), self.json);
        }
        if let Some([platform, path]) = self.bundle.as_deref() {
            return self.write_bundle((lab, &platform.to_string_lossy()), path);
        }
        if self.class.folder.is_some() {
            return self.class.run(lab, (self.seed, self.rubric.as_deref()), self.json);
        }
        let rubric = self.read_rubric(lab)?;
        if !self.watch {
            return self.grade(lab, &rubric, registry);
        }
        self.watch(lab, &rubric, registry)
    }

    fn write_bundle(&self, (lab, platform): (&Lab, &str), path: &Path) -> Result<(), CliError> {
        if is_about_function(lab) {
            let words =
                "submissions in other languages draw pictures, and this lab is about a function: there is no bundle";
            return Err(CliError::failed(format!("lab {}: {words}", lab.name)));
        }
        self.read_rubric(lab)?;
        let text = self.rubric.as_deref().map(std::fs::read_to_string).transpose().map_err(CliError::failed)?;
        let (seed, hidden, leaderboard) = (self.seed, self.results.hidden, self.results.leaderboard);
        let order = Order { lab: lab.name, seed, hidden, rubric: text.as_deref(), leaderboard };
        super::bundle::write(platform, path, &order)
    }

    fn read_rubric(&self, lab: &Lab) -> Result<Rubric, CliError> {
        read_rubric(self.rubric.as_deref(), lab)
    }

    fn grade(&self, lab: &Lab, rubric: &Rubric, registry: &Registry) -> Result<(), CliError> {
        let graded = self.judged(lab, rubric, registry);
        if let Err(CliError::Failed(reason) | CliError::Diagnosed(reason)) = &graded {
            let submitted = self.submission.as_deref().and_then(Path::file_name).map(|name| name.to_string_lossy());
            let name = self.rasterizer.as_deref().or(submitted.as_deref()).unwrap_or_default();
            self.results.write_refusal((lab, rubric), name, reason.trim_end())?;
        }
        let (verdict, hidden) = graded?;
        self.write_witness(&verdict)?;
        error::print(&self.told(&verdict, hidden.as_ref()))?;
        let (earned, most) = [Some(&verdict), hidden.as_ref()]
            .into_iter()
            .flatten()
            .fold((0.0, 0.0), |(earned, most), verdict| (earned + verdict.earned(), most + verdict.most()));
        if verdict.is_passed() && hidden.is_none_or(|hidden| hidden.is_passed()) {
            return Ok(());
        }
        Err(CliError::Wanting(format!("found wanting: {earned:.1} of {most:.1} points")))
    }

    /// The text for standard output.
    fn told(&self, verdict: &Verdict, hidden: Option<&Verdict>) -> String {
        if !self.json {
            return write::text(verdict) + &hidden.map(write::hidden_text).unwrap_or_default();
        }
        let mut value = write::json(verdict);
        if let Some(hidden) = hidden {
            value["hidden"] = write::json(hidden);
        }
        format!("{value:#}\n")
    }

    /// The verdict by visible probes, and by hidden ones if they are asked.
    fn judged(&self, lab: &Lab, rubric: &Rubric, registry: &Registry) -> Result<Judged, CliError> {
        if let Some(path) = &self.submission
            && !is_about_function(lab)
        {
            return self.judge_submission(path, (lab, rubric));
        }
        match (&self.pictures, &self.rasterizer) {
            (pictures, name) if is_about_function(lab) => {
                if pictures.is_some() || self.submission.is_some() || self.witness.is_some() {
                    return Err(CliError::failed(format!(
                        "lab {} is about a function: there are no pictures and no screen files, leave --pictures, --submission and --witness out",
                        lab.name
                    )));
                }
                self.judge_function(name.as_deref().unwrap_or_default(), (lab, rubric), registry)
            }
            (Some(folder), _) => {
                let mut pictures = Pictures::new(folder, lab, self.seed);
                if let Some(seed) = self.results.hidden {
                    pictures = pictures.and(&lab.hidden(), seed);
                }
                self.judge(&pictures, &folder.display().to_string(), (lab, rubric))
            }
            (None, name) => {
                let name = name.as_deref().unwrap_or("zbuffer");
                let registered = find_rasterizer(registry, name)?
                    .ok_or_else(|| CliError::failed("`none` draws nothing: there is nothing to grade"))?;
                match registered {
                    Chosen::Registered(entry) => self.judge(&InProcess(&*entry.rasterizer), name, (lab, rubric)),
                    Chosen::Outside(external) => self.judge(&Outside::new(external), name, (lab, rubric)),
                }
            }
        }
    }

    fn judge(&self, subject: &dyn Subject, name: &str, (lab, rubric): (&Lab, &Rubric)) -> Result<Judged, CliError> {
        let ledger = Ledger::new(&self.results, (lab, rubric), (name, self.seed), false);
        ledger.fill(&mut |request, keep| grade::grade(subject, request, keep))
    }

    /// Grades what lies in `path`.
    fn judge_submission(&self, path: &Path, (lab, rubric): (&Lab, &Rubric)) -> Result<Judged, CliError> {
        let (sandbox, tools) = self.class.holders()?;
        let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
        let ledger = Ledger::new(&self.results, (lab, rubric), (&name, self.seed), false).held_by(sandbox.layers());
        let mut fill = |subject: &dyn Subject| ledger.fill(&mut |request, keep| grade::grade(subject, request, keep));
        with_submission(lab, path, (&sandbox, &tools), &mut fill).map_err(CliError::failed)?
    }

    /// Grades a clip or a triangulation.
    fn judge_function(
        &self,
        name: &str,
        (lab, rubric): (&Lab, &Rubric),
        registry: &Registry,
    ) -> Result<Judged, CliError> {
        let clip = registry.clips().iter().find(|entry| lab.name == "clip" && entry.name == name);
        let split = registry.triangulations().iter().find(|entry| lab.name == "triangulate" && entry.name == name);
        let ledger = Ledger::new(&self.results, (lab, rubric), (name, self.seed), true);
        match (clip, split) {
            (Some(clip), _) => ledger.fill(&mut |request, keep| grade_clip(&*clip.function, request, keep)),
            (_, Some(split)) => ledger.fill(&mut |request, keep| grade_triangulate(&*split.function, request, keep)),
            (None, None) => Err(no_function(name, lab.name, registry)),
        }
    }

    fn write_witness(&self, verdict: &Verdict) -> Result<(), CliError> {
        let Some(path) = &self.witness else { return Ok(()) };
        let Some(witness) = verdict.aspects.iter().find_map(|aspect| aspect.witness.as_ref()) else {
            notice(&format!("nothing fails, so {} is not written", path.display()));
            return Ok(());
        };
        let text = witness.screen_file().map_err(CliError::failed)?;
        Ok(save::write_whole(path, &text)?)
    }

    /// Grades whenever something changed. A rasterizer in this program cannot change while it runs: when the program's file
    /// does, the new one must be started, and that is said.
    fn watch(&self, lab: &Lab, rubric: &Rubric, registry: &Registry) -> Result<(), CliError> {
        let program = std::env::current_exe().unwrap_or_default();
        let watched = self.pictures.as_deref().unwrap_or(&program);
        loop {
            let seen = changed_at(watched);
            match self.grade(lab, rubric, registry) {
                Ok(()) => error::print("passed\n")?,
                Err(CliError::Wanting(text)) => error::print(&(text + "\n"))?,
                Err(error) => return Err(error),
            }
            while changed_at(watched) == seen {
                std::thread::sleep(Duration::from_millis(300));
            }
            if self.pictures.is_none() {
                return error::print(
                    "the program was built anew: start it again, or use a loop of `cargo run -- grade`\n",
                );
            }
        }
    }
}

/// The rubric in a file; each aspect's own points without one.
pub(super) fn read_rubric(path: Option<&Path>, lab: &Lab) -> Result<Rubric, CliError> {
    let Some(path) = path else { return Ok(Rubric::default()) };
    let text = std::fs::read_to_string(path)
        .map_err(|error| CliError::failed(format!("cannot read {}: {error}", path.display())))?;
    Rubric::parse(&text, lab).map_err(|error| CliError::failed(format!("{}: {error}", path.display())))
}

pub(super) fn is_about_function(lab: &Lab) -> bool {
    FUNCTION_LABS.iter().any(|function| function.name == lab.name)
}

fn no_function(name: &str, lab: &str, registry: &Registry) -> CliError {
    let names: Vec<&str> = if lab == "clip" {
        registry.clips().iter().map(|entry| entry.name.as_str()).collect()
    } else {
        registry.triangulations().iter().map(|entry| entry.name.as_str()).collect()
    };
    CliError::failed(format!(
        "there is no {lab} function `{name}` in this program; there is {}\n\
         help: one of your own is added to your crate's registry: `.with_{lab}(\"{name}\", my_{lab}::{lab})`",
        names.join(", ")
    ))
}

/// The newest change in a file, or in a folder and what is in it.
fn changed_at(path: &Path) -> Option<SystemTime> {
    let time = |path: &Path| std::fs::metadata(path).and_then(|about| about.modified()).ok();
    let inside = std::fs::read_dir(path).into_iter().flatten().flatten().filter_map(|entry| time(&entry.path()));
    inside.chain(time(path)).max()
}
