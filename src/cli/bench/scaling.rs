//! `farop bench --scaling`: how times grow with triangles and with pixels.

use super::super::error::{self, CliError};
use super::super::scenes::{Chosen, SceneOptions, find_rasterizer};
use super::{BenchCommand, ROUNDS};
use crate::lab::bench::scaling::{SIDES, exponent, steps};
use crate::lab::bench::summary::Summary;
use crate::lab::bench::{self, Contestant, Row};
use crate::plan::Choices;
use crate::raster::Registry;
use crate::scene::Scene;
use serde_json::{Value, json};
use std::fmt::Write;

/// Sizes of the flake, and the picture they are drawn at where nobody says.
const SIZES: [&str; 5] = ["1k", "10k", "100k", "1m", "10m"];
const SIDE: u32 = 1024;
/// Drawn for the exponent in pixels: enough triangles to be a scene, few enough to be cheap.
const SCENE: &str = "bench:flake:10k";

/// Sizes, and what one contestant took at each.
struct Curve {
    of: &'static str,
    name: String,
    threads: u32,
    /// (size, milliseconds of the processor).
    pairs: Vec<(f64, f64)>,
}

impl BenchCommand {
    pub(super) fn run_scaling(&self, registry: &Registry) -> Result<(), CliError> {
        if !self.scenes.is_empty() || self.instructions {
            return Err(CliError::failed("--scaling has its own scenes and counts no instructions: leave those out"));
        }
        let chosen = self.scaling_rasterizers(registry)?;
        let most = self.scaling.as_deref().and_then(|most| SIZES.iter().position(|&size| size == most)).unwrap_or(3);
        let mut curves = self.in_triangles(&chosen, most)?;
        curves.extend(self.in_pixels(&chosen)?);
        if self.json {
            let curves = curves.iter().map(Curve::json).collect();
            return error::print(&format!("{:#}\n", self.document(curves)));
        }
        let tables: String = curves.iter().map(Curve::text).collect();
        error::print(&format!("{tables}{LEGEND}"))
    }

    /// Those that were asked for, or the readable one and the fast one.
    fn scaling_rasterizers<'a>(&self, registry: &'a Registry) -> Result<Vec<Chosen<'a>>, CliError> {
        if !self.rasterizer.is_empty() {
            return self.rasterizers(registry);
        }
        let found = ["zbuffer", "fast"].map(|name| find_rasterizer(registry, name));
        found.into_iter().filter_map(Result::transpose).collect()
    }

    fn in_triangles(&self, chosen: &[Chosen<'_>], most: usize) -> Result<Vec<Curve>, CliError> {
        let size = self.picture.choices().size.unwrap_or((SIDE, SIDE));
        let points = SIZES[..=most].iter().map(|name| {
            let scene = self.load(&format!("bench:flake:{name}"))?;
            let rows = self.measure(&scene, chosen, size)?;
            let triangles = rows.first().map_or(0, |row| bench::triangles(&scene, &row.counts));
            Ok((triangles as f64, rows))
        });
        Ok(curves("triangles", points.collect::<Result<_, CliError>>()?))
    }

    fn in_pixels(&self, chosen: &[Chosen<'_>]) -> Result<Vec<Curve>, CliError> {
        let scene = self.load(SCENE)?;
        let most = self.picture.choices().max_pixels;
        let sides = SIDES.iter().filter(|&&side| u64::from(side) * u64::from(side) <= most);
        let points = sides.map(|&side| {
            let rows = self.measure(&scene, chosen, (side, side))?;
            Ok((f64::from(side) * f64::from(side), rows))
        });
        Ok(curves("pixels", points.collect::<Result<_, CliError>>()?))
    }

    fn load(&self, name: &str) -> Result<Scene, CliError> {
        Ok(SceneOptions::named(name, None).load(&self.picture)?.scene)
    }

    fn measure(&self, scene: &Scene, chosen: &[Chosen<'_>], size: (u32, u32)) -> Result<Vec<Row>, CliError> {
        let contestants: Vec<Contestant<'_>> = self
            .contestants(chosen)
            .into_iter()
            .map(|of| Contestant { choices: Choices { size: Some(size), ..of.choices }, ..of })
            .collect();
        let effort =
            crate::lab::measure::Effort { rounds: self.rounds.map_or(ROUNDS, |n| n as usize), ..self.effort() };
        let rows = bench::run(scene, &contestants, (&effort, false), &|_, _| ())?;
        super::check_any_drawn(&rows)?;
        Ok(rows)
    }
}

/// A curve for each contestant.
fn curves(of: &'static str, points: Vec<(f64, Vec<Row>)>) -> Vec<Curve> {
    let Some((_, first)) = points.first() else { return Vec::new() };
    let time =
        |row: &Row| Summary::of(row.times.iter().map(|times| times.frame()).map(|time| time.user + time.system)).median;
    let curve = |(index, row): (usize, &Row)| Curve {
        of,
        name: row.name.clone(),
        threads: row.threads,
        pairs: points.iter().map(|(size, rows)| (*size, time(&rows[index]))).collect(),
    };
    first.iter().enumerate().map(curve).collect()
}

impl Curve {
    /// The exponent over all sizes, and over the last three.
    fn exponents(&self) -> [Option<f64>; 2] {
        let last = self.pairs.len().saturating_sub(3);
        [exponent(&self.pairs), exponent(&self.pairs[last..])]
    }

    fn text(&self) -> String {
        let mut text = format!("{}, {} threads: processor time of a frame in {}\n", self.name, self.threads, self.of);
        let _ = writeln!(
            text,
            "{:>12} {:>12} {:>14} {:>9}",
            self.of,
            "ms",
            format!("ns/{}", &self.of[..self.of.len() - 1]),
            "exponent"
        );
        for (&(size, time), step) in self.pairs.iter().zip(steps(&self.pairs)) {
            let _ = writeln!(text, "{size:>12} {time:>12.3} {:>14.2} {:>9}", time / size * 1e6, maybe(step));
        }
        let [all, last] = self.exponents();
        let _ = writeln!(text, "exponent {} over all, {} over the last three\n", maybe(all), maybe(last));
        text
    }

    fn json(&self) -> Value {
        let [all, last] = self.exponents();
        json!({
            "of": self.of,
            "rasterizer": self.name,
            "threads": self.threads,
            "size_and_ms": self.pairs,
            "exponent": all,
            "exponent_of_the_last_three": last,
        })
    }
}

const LEGEND: &str = "An exponent of 1 is linear: twice as much takes twice as long.\n";

fn maybe(value: Option<f64>) -> String {
    value.map_or_else(|| "-".to_string(), |value| format!("{value:.2}"))
}
