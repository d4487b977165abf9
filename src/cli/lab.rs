//! `farop lab`: what speed and accuracy cost each other, as a table and a chart.

use super::error::{self, CliError};
use super::options::PictureOptions;
use super::scenes::{Chosen, SceneOptions, find_rasterizer};
use crate::image::{encode_for, save};
use crate::lab::chart::Chart;
use crate::lab::configurations::{Configuration, Spread, configurations};
use crate::lab::measure::Effort;
use crate::lab::truth::{Source, Truth};
use crate::lab::{self, Row, table};
use crate::raster::{Rasterizer, Registry};
use crate::scene::Scene;
use clap::Args;
use std::cell::Cell;
use std::io::{IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// What speed and accuracy cost each other: a table and a chart
#[derive(Args)]
#[command(
    after_help = "Examples:\n  farop lab spd:teapot:6 --plot lab.svg\n  farop lab scene.nff --size 256 -r zbuffer -r exec:./mine --csv lab.csv"
)]
pub(super) struct LabCommand {
    #[command(flatten)]
    scenes: SceneOptions,
    /// Rasterizers; may be repeated, the first draws the base [default: all that draw areas]
    #[arg(short, long, value_name = "NAME")]
    rasterizer: Vec<String>,
    /// All combinations of shading, samples, tolerance, sub-pixel bits, depth and rasterizer
    #[arg(long)]
    all: bool,
    /// Stop measuring time after so many seconds (but not before 3 rounds)
    #[arg(long, value_name = "SECONDS", default_value_t = 60.0)]
    budget: f64,
    /// Rounds of measuring time, after one that warms up
    #[arg(long, value_name = "N", default_value_t = 15, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    runs: u32,
    /// Decides the order of the runs
    #[arg(long, value_name = "N", default_value_t = 1996)]
    seed: u64,
    /// Everything as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// The table as CSV
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
    /// The charts, one panel a kind of error
    #[arg(long, value_name = "FILE.svg|png")]
    plot: Option<PathBuf>,
    #[command(flatten)]
    picture: PictureOptions,
}

impl LabCommand {
    pub fn run(self, registry: &Registry) -> Result<(), CliError> {
        if let Some(path) = &self.plot {
            check_plot(path)?;
        }
        if !(self.budget >= 0.0 && self.budget < 1e9) {
            return Err(CliError::failed("--budget: give seconds, 0 or more"));
        }
        if super::forest::frame::is_forest(&self.scenes.scenes) {
            return self.of_forest(registry);
        }
        let loaded = self.scenes.load(&self.picture)?;
        let base = self.picture.choices();
        let rasterizers = self.rasterizers(registry)?;
        let spread = if self.all { Spread::All } else { Spread::Sensible };
        let borrowed: Vec<(&str, &dyn Rasterizer)> =
            rasterizers.iter().map(|chosen| (chosen.name(), chosen.rasterizer())).collect();
        let list = configurations(&loaded.scene, &base, &borrowed, spread)?;
        let find = |of: &Configuration| borrowed.iter().find(|entry| entry.0 == of.rasterizer).map(|entry| entry.1);
        let list: Vec<(Configuration, &dyn Rasterizer)> =
            list.into_iter().filter_map(|of| find(&of).map(|found| (of, found))).collect();
        let start = Instant::now();
        let truth = Truth::new(&loaded.scene, &base, None)?;
        let traced = start.elapsed();
        let effort = self.effort();
        let bar = Bar::new();
        let rows =
            lab::run(&loaded.scene, (&base, &truth), &list, (&effort, &|work, done, all| bar.show(work, done, all)))?;
        bar.clear();
        self.report(&loaded.scene, &truth, &rows, traced)
    }

    fn effort(&self) -> Effort {
        Effort { rounds: self.runs as usize, budget: Duration::from_secs_f64(self.budget), seed: self.seed }
    }

    /// The lab of a pack: what is compared is the scene of a frame itself.
    fn of_forest(&self, registry: &Registry) -> Result<(), CliError> {
        let name = self.rasterizer.first().map_or("fast", String::as_str);
        let chosen = find_rasterizer(registry, name)?;
        let Some(chosen) = chosen.filter(|chosen| self.rasterizer.len() < 2 && chosen.name() != "wire") else {
            return Err(CliError::failed("the lab of a forest compares frames: give one rasterizer that draws areas"));
        };
        let path = Path::new(&self.scenes.scenes[0]);
        let bar = Bar::new();
        let progress = |work: &str, done: usize, all: usize| bar.show(work, done, all);
        let (rows, (width, height)) =
            super::forest::frame::lab(path, &self.picture, chosen.rasterizer(), (&self.effort(), &progress))?;
        bar.clear();
        let title = format!("{} at {width}x{height}, {name}", path.display());
        let runs = rows.iter().map(|row| row.timing.runs).max().unwrap_or(0);
        let head = format!(
            "{title}: {} ways, {runs} runs each; truth: every tree, the finest relief, 4 x 4 samples",
            rows.len()
        );
        error::print(&format!("{head}\n\n{}\n{}\n{}", table::text(&rows), table::volume_text(&rows), table::LEGEND))?;
        if let Some(path) = &self.csv {
            save::write_whole(path, table::csv(&rows).as_bytes())?;
        }
        if let Some(path) = &self.json {
            let run = serde_json::json!({
                "scenes": self.scenes.scenes,
                "size": [width, height],
                "truth": "own finest frame",
                "seed": self.seed,
                "version": env!("CARGO_PKG_VERSION"),
            });
            save::write_whole(path, format!("{:#}\n", table::json(&rows, &run)).as_bytes())?;
        }
        self.plot.as_ref().map_or(Ok(()), |path| write_plot(path, &Chart::new(&title, &rows)))
    }

    /// Those that were asked for, in this program or outside of it, or all of this program that draw areas.
    fn rasterizers<'a>(&self, registry: &'a Registry) -> Result<Vec<Chosen<'a>>, CliError> {
        if self.rasterizer.is_empty() {
            return Ok(registry.iter().filter(|entry| entry.name != "wire").map(Chosen::Registered).collect());
        }
        let known = |name: &String| match find_rasterizer(registry, name)? {
            Some(chosen) if chosen.name() != "wire" => Ok(chosen),
            _ => Err(CliError::failed(format!("the lab compares rasterizers that draw areas, and `{name}` does not"))),
        };
        self.rasterizer.iter().map(known).collect()
    }

    fn report(&self, scene: &Scene, truth: &Truth, rows: &[Row], traced: Duration) -> Result<(), CliError> {
        let names = self.scenes.scenes.join(" + ");
        let judge = match &truth.source {
            Source::Rays => format!("rays, {} s", traced.as_millis() as f64 / 1e3),
            Source::OwnFinest(why) => format!("our own finest picture, because {why}; no rays"),
        };
        let runs = rows.iter().map(|row| row.timing.runs).max().unwrap_or(0);
        let (width, height) = truth.size;
        let threads = self.picture.choices().threads.map_or("all".to_string(), |count| count.to_string());
        let head = format!(
            "{names} at {width}x{height}: {} configurations, {runs} runs each, {threads} threads; truth: {judge}",
            rows.len()
        );
        error::print(&format!("{head}\n\n{}\n{}\n{}", table::text(rows), table::volume_text(rows), table::LEGEND))?;
        if let Some(path) = &self.csv {
            save::write_whole(path, table::csv(rows).as_bytes())?;
        }
        if let Some(path) = &self.json {
            let run = serde_json::json!({
                "scenes": self.scenes.scenes,
                "size": [width, height],
                "truth": judge_name(truth),
                "lights": scene.lights.len(),
                "seed": self.seed,
                "threads": threads,
                "version": env!("CARGO_PKG_VERSION"),
            });
            save::write_whole(path, format!("{:#}\n", table::json(rows, &run)).as_bytes())?;
        }
        if let Some(path) = &self.plot {
            write_plot(path, &Chart::new(&format!("{names} at {width}x{height}"), rows))?;
        }
        Ok(())
    }
}

fn judge_name(truth: &Truth) -> &'static str {
    match truth.source {
        Source::Rays => "rays",
        Source::OwnFinest(_) => "own finest picture",
    }
}

fn is_svg(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("svg"))
}

/// Refuses an unknown ending before minutes of work.
fn check_plot(path: &Path) -> Result<(), CliError> {
    if is_svg(path) { Ok(()) } else { super::render::check_extension(path) }
}

fn write_plot(path: &Path, chart: &Chart) -> Result<(), CliError> {
    let bytes = if is_svg(path) {
        chart.svg().into_bytes()
    } else {
        encode_for(path, &chart.picture()).map_err(CliError::failed)?
    };
    Ok(save::write_whole(path, &bytes)?)
}

/// Progress on stderr: only on a terminal, only when the work takes longer than a second.
struct Bar {
    start: Instant,
    shown: Cell<bool>,
    is_terminal: bool,
}

impl Bar {
    fn new() -> Bar {
        Bar { start: Instant::now(), shown: Cell::new(false), is_terminal: std::io::stderr().is_terminal() }
    }

    fn show(&self, work: &str, done: usize, all: usize) {
        if self.is_terminal && self.start.elapsed() > Duration::from_secs(1) {
            self.shown.set(true);
            let filled = 30 * done / all.max(1);
            // A closed stderr must not stop the work.
            let _ = write!(std::io::stderr(), "\r{work:<8} [{:<30}] {done}/{all} ", "#".repeat(filled.min(30)));
        }
    }

    fn clear(&self) {
        if self.shown.get() {
            let _ = write!(std::io::stderr(), "\r{:70}\r", "");
        }
    }
}
