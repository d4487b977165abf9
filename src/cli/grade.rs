//! `farop grade`: what is wrong with a rasterizer, why, and the smallest case that shows it.

use super::error::{self, CliError, notice};
use super::scenes::{Chosen, find_rasterizer};
use crate::grade::folder::Pictures;
use crate::grade::rubric::Rubric;
use crate::grade::{self, InProcess, Lab, Outside, Request, Subject, Verdict, write};
use crate::image::save;
use crate::raster::Registry;
use clap::Args;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

/// Grade a rasterizer: points, the mistake by its name, the smallest case
#[derive(Args)]
#[command(
    after_help = "Examples:\n  farop grade zbuffer -r mine --witness small.scr\n  farop grade zbuffer --pictures pictures"
)]
pub(super) struct GradeCommand {
    /// Which lab (`farop list labs` has the names)
    lab: String,
    /// Rasterizer
    #[arg(short, long, value_name = "NAME", required_unless_present = "pictures")]
    rasterizer: Option<String>,
    /// Folder of PPM or PNG pictures drawn elsewhere from the files of `farop suite LAB`
    #[arg(long, value_name = "DIR", conflicts_with = "rasterizer")]
    pictures: Option<PathBuf>,
    /// Grade again whenever the pictures, or this program, change
    #[arg(long)]
    watch: bool,
    /// Picks the random cases
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// Smallest case of the first mistake, as a screen file
    #[arg(short = 'o', long, value_name = "FILE")]
    witness: Option<PathBuf>,
    /// Gradescope's results, written anew after every picture
    #[arg(long, value_name = "FILE")]
    gradescope: Option<PathBuf>,
    /// JUnit's results, written anew after every picture
    #[arg(long, value_name = "FILE")]
    junit: Option<PathBuf>,
    /// Points by aspect, TOML
    #[arg(long, value_name = "FILE")]
    rubric: Option<PathBuf>,
    /// Instead of points: at which size, offset or depth it begins to be wrong
    #[arg(long, conflicts_with_all = ["pictures", "watch", "gradescope", "junit", "rubric"])]
    extremes: bool,
    /// The verdict as JSON on standard output
    #[arg(long)]
    json: bool,
}

impl GradeCommand {
    pub fn run(self, registry: &Registry) -> Result<(), CliError> {
        let lab = grade::labs::find(&self.lab).ok_or_else(|| {
            let names: Vec<_> = grade::LABS.iter().map(|lab| lab.name).collect();
            CliError::failed(format!("there is no lab `{}`; there is {}", self.lab, names.join(", ")))
        })?;
        if self.extremes {
            let name = self.rasterizer.as_deref().unwrap_or("zbuffer");
            return super::extremes::run(lab, (name, registry), self.witness.as_deref(), self.json);
        }
        let rubric = self.read_rubric(lab)?;
        if !self.watch {
            return self.grade(lab, &rubric, registry);
        }
        self.watch(lab, &rubric, registry)
    }

    fn read_rubric(&self, lab: &Lab) -> Result<Rubric, CliError> {
        let Some(path) = &self.rubric else { return Ok(Rubric::default()) };
        let text = std::fs::read_to_string(path)
            .map_err(|error| CliError::failed(format!("cannot read {}: {error}", path.display())))?;
        Rubric::parse(&text, lab).map_err(|error| CliError::failed(format!("{}: {error}", path.display())))
    }

    fn grade(&self, lab: &Lab, rubric: &Rubric, registry: &Registry) -> Result<(), CliError> {
        let verdict = match (&self.pictures, &self.rasterizer) {
            (Some(folder), _) => {
                let pictures = Pictures::new(folder, lab, self.seed);
                self.judge(&pictures, &folder.display().to_string(), (lab, rubric))?
            }
            (None, name) => {
                let name = name.as_deref().unwrap_or("zbuffer");
                let registered = find_rasterizer(registry, name)?
                    .ok_or_else(|| CliError::failed("`none` draws nothing: there is nothing to grade"))?;
                match registered {
                    Chosen::Registered(entry) => self.judge(&InProcess(&*entry.rasterizer), name, (lab, rubric))?,
                    Chosen::Outside(external) => self.judge(&Outside::new(external), name, (lab, rubric))?,
                }
            }
        };
        self.write_witness(&verdict)?;
        let text = if self.json { format!("{:#}\n", write::json(&verdict)) } else { write::text(&verdict) };
        error::print(&text)?;
        if verdict.is_passed() {
            return Ok(());
        }
        Err(CliError::Wanting(format!("found wanting: {:.1} of {:.1} points", verdict.earned(), verdict.most())))
    }

    fn judge(&self, subject: &dyn Subject, name: &str, (lab, rubric): (&Lab, &Rubric)) -> Result<Verdict, CliError> {
        let points = |aspect: &grade::labs::Aspect| rubric.points(aspect);
        let request = Request { lab, name: name.to_string(), seed: self.seed, points: &points };
        let mut trouble = None;
        let verdict = grade::grade(subject, &request, &mut |verdict| {
            // The first failure to write is told at the end; the grade goes on.
            trouble = trouble.take().or(self.write_results(verdict).err());
        });
        trouble.map_or(Ok(verdict), Err)
    }

    fn write_results(&self, verdict: &Verdict) -> Result<(), CliError> {
        if let Some(path) = &self.gradescope {
            save::write_whole(path, format!("{:#}\n", write::gradescope(verdict)).as_bytes())?;
        }
        if let Some(path) = &self.junit {
            save::write_whole(path, write::junit(verdict).as_bytes())?;
        }
        Ok(())
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

/// The newest change in a file, or in a folder and what is in it.
fn changed_at(path: &Path) -> Option<SystemTime> {
    let time = |path: &Path| std::fs::metadata(path).and_then(|about| about.modified()).ok();
    let inside = std::fs::read_dir(path).into_iter().flatten().flatten().filter_map(|entry| time(&entry.path()));
    inside.chain(time(path)).max()
}
