//! `farop bench`: where the time of a frame goes, each rasterizer side by side.

mod options;
mod scaling;

use super::error::{self, CliError};
use super::scenes::{Chosen, SceneOptions, find_rasterizer};
use crate::lab::bench::summary::Summary;
use crate::lab::bench::table::{self, Subject};
use crate::lab::bench::{self, Contestant, Row, instructions};
use crate::lab::measure::Effort;
use crate::plan::{Choices, Shading};
use crate::raster::Registry;
use crate::report::peak_bytes;
use crate::scene::Scene;
pub(super) use options::BenchCommand;
use std::ffi::OsString;
use std::time::Duration;

/// Scenes where none are named: curves and large polygons, small triangles, large ones.
const SCENES: [&str; 3] = ["spd:gears", "bench:flake:10k", "bench:fill_b2f"];
/// How often a scene is read to time it: that changes little, and may take long.
const READINGS: usize = 3;
/// Rounds where nobody says how many.
const ROUNDS: usize = 9;

impl BenchCommand {
    pub fn run(self, registry: &Registry) -> Result<(), CliError> {
        if self.scaling.is_some() {
            return self.run_scaling(registry);
        }
        if self.scenes.is_empty() && self.one_line {
            return Err(CliError::failed("--one-line needs a scene: name one, as in `farop bench a.ftri --one-line`"));
        }
        let defaults = SCENES.map(str::to_string);
        let names = if self.scenes.is_empty() { &defaults[..] } else { &self.scenes };
        let mut documents = Vec::new();
        for (number, name) in names.iter().enumerate() {
            let (subject, rows) = self.scene(registry, name)?;
            if self.one_line {
                error::print(&table::one_line(&subject, &rows[0]))?;
            } else if self.json {
                documents.push(table::json(&subject, &rows));
            } else {
                let gap = if number > 0 { "\n" } else { "" };
                error::print(&format!("{gap}{}", table::text(&subject, &rows)))?;
            }
        }
        if self.json {
            error::print(&format!("{:#}\n", self.document(documents)))?;
        } else if !self.one_line {
            error::print(&format!("\n{}", table::LEGEND))?;
        }
        Ok(())
    }

    /// All scenes, with what they have in common.
    fn document(&self, scenes: Vec<serde_json::Value>) -> serde_json::Value {
        serde_json::json!({
            "schema": 1,
            "version": env!("CARGO_PKG_VERSION"),
            "cores": crate::render::available_threads(),
            "scenes": scenes,
        })
    }

    /// Measures one scene.
    fn scene(&self, registry: &Registry, name: &str) -> Result<(Subject, Vec<Row>), CliError> {
        let (scene, parse) = self.read(name)?;
        let chosen = self.rasterizers(registry)?;
        let contestants = self.contestants(&chosen);
        let mut rows = bench::run(&scene, &contestants, (&self.effort(), !self.one_line), &|_, _| ())?;
        check_any_drawn(&rows)?;
        if self.instructions {
            for row in &mut rows {
                row.instructions = Some(self.count_instructions(name, &row.name)?);
            }
        }
        let choices = self.picture.choices();
        let size = choices.size.or(scene.camera.map(|camera| camera.resolution)).unwrap_or((1, 1));
        let subject = Subject {
            scene: name.to_string(),
            size,
            shading: choices.shading.name(),
            samples: choices.samples,
            triangles: bench::triangles(&scene, &rows[0].counts),
            parse,
            file_bytes: std::fs::metadata(name).ok().filter(std::fs::Metadata::is_file).map(|file| file.len()),
            peak_bytes: peak_bytes(),
        };
        Ok((subject, rows))
    }

    /// The scene, and how long reading it takes; standard input can be read once.
    fn read(&self, name: &str) -> Result<(Scene, Summary), CliError> {
        let options = SceneOptions::named(name, self.format.as_deref());
        let loaded = options.load(&self.picture)?;
        let mut times = vec![loaded.parse_time.elapsed];
        let readings = if name == "-" || self.one_line { 1 } else { READINGS };
        for _ in 1..readings {
            times.push(options.load_silently(&self.picture)?.elapsed);
        }
        Ok((loaded.scene, Summary::of(times)))
    }

    /// Those that were asked for; in one line, the first or `fast`; else all of this program that draw what is asked for.
    fn rasterizers<'a>(&self, registry: &'a Registry) -> Result<Vec<Chosen<'a>>, CliError> {
        let lines = self.picture.choices().shading == Shading::Wire;
        let names: Vec<&str> = match &self.rasterizer[..] {
            [] if self.one_line => vec![if lines { "wire" } else { "fast" }],
            [] => registry.iter().map(|entry| &*entry.name).filter(|&name| (name == "wire") == lines).collect(),
            asked => asked.iter().map(String::as_str).take(if self.one_line { 1 } else { usize::MAX }).collect(),
        };
        let found = |name: &&str| match find_rasterizer(registry, name)? {
            Some(chosen) => Ok(chosen),
            None => Err(CliError::failed("`-r none` draws nothing: the columns plan and geometry say what it costs")),
        };
        names.iter().map(found).collect()
    }

    /// Every rasterizer with every number of threads.
    fn contestants<'a>(&self, chosen: &'a [Chosen<'_>]) -> Vec<Contestant<'a>> {
        let base = self.picture.choices();
        let threads: Vec<Option<u32>> = match &self.threads.0[..] {
            [] => vec![None],
            asked => asked.iter().copied().map(Some).collect(),
        };
        let of = |chosen: &'a Chosen<'_>, threads: Option<u32>| {
            let shading = if chosen.name() == "wire" { Shading::Wire } else { base.shading };
            let choices = Choices { threads, shading, ..base.clone() };
            Contestant { name: chosen.name().to_string(), rasterizer: chosen.rasterizer(), choices }
        };
        chosen.iter().flat_map(|chosen| threads.iter().map(move |&threads| of(chosen, threads))).collect()
    }

    fn effort(&self) -> Effort {
        let rounds = self.rounds.map_or(ROUNDS, |rounds| rounds as usize);
        Effort { rounds, budget: Duration::from_secs_f64(self.budget), seed: 1996 }
    }

    /// Instructions of a frame of the same picture on one thread.
    fn count_instructions(&self, scene: &str, rasterizer: &str) -> Result<u64, CliError> {
        if scene == "-" {
            return Err(CliError::failed("--instructions reads the scene several times: give it as a file"));
        }
        let program = std::env::current_exe().map_err(|error| CliError::failed(format!("no program: {error}")))?;
        let choices = self.picture.choices();
        let mut arguments: Vec<OsString> = vec!["bench".into(), scene.into(), "--one-line".into()];
        let mut option = |name: &str, value: &str| arguments.extend([name.into(), value.into()]);
        option("--rasterizer", rasterizer);
        option("--threads", "1");
        option("--shading", choices.shading.name());
        option("--samples", &choices.samples.to_string());
        option("--encoding", choices.encoding.name());
        if let Some((width, height)) = choices.size {
            option("--size", &format!("{width}x{height}"));
        }
        if let Some(format) = &self.format {
            option("--format", format);
        }
        instructions::of_a_frame(&program, &arguments)
            .map_err(|message| CliError::failed(format!("--instructions: {message}")))
    }
}

/// Ends the command where no rasterizer gave a picture.
fn check_any_drawn(rows: &[Row]) -> Result<(), CliError> {
    match rows.iter().find_map(|row| row.failure.as_ref()) {
        Some(reason) if rows.iter().all(|row| row.failure.is_some()) => Err(CliError::failed(reason)),
        _ => Ok(()),
    }
}
