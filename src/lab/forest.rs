//! The lab on a forest: what relief, trees, horizon and pictures cost, and how far each is from all of it.
//!
//! Cells, camera -composer, render-> rows of (time, error) -table, chart->
//!
//! In other scenes only the way of drawing is chosen; here the scene of a frame itself is, too: how exact the land is, what stands for a
//! tree, where trees end. So the truth is a frame of which nothing was left out: every tree two crossed pictures, the finest relief, the
//! farthest horizon, [`SAMPLES`] x [`SAMPLES`] samples a pixel.
//!
//! A time is that of a frame of a walk: composing, plan, geometry, rasterizer, averaging; with the cells in memory.
//! Cost: one composer for every horizon, and so its cells.

use super::check::Random;
use super::configurations::Configuration;
use super::errors::{Errors, Judge};
use super::measure::{Effort, Timing, shuffled};
use super::truth::{Source, Truth};
use super::{Progress, Row};
use crate::forest::cells::Cells;
use crate::forest::frame::{self, Composer, FrameError, Trees};
use crate::forest::pictures::Pictures;
use crate::image::Image;
use crate::oracle::ray::RayError;
use crate::plan::{Choices, PlanError, TextureFilter};
use crate::raster::Rasterizer;
use crate::render;
use crate::scene::Camera;
use std::time::Instant;

/// Samples a pixel, each way, of the truth.
pub const SAMPLES: u32 = 4;
/// Errors of the relief in pixels.
pub const TOLERANCES: [f64; 5] = [0.5, 1.0, 2.0, 4.0, 8.0];
/// What stands for trees, by the words of the command line.
pub const TREES: [(&str, Trees); 4] =
    [("auto", Trees::Auto), ("crossed", Trees::Crossed), ("billboards", Trees::Billboards), ("none", Trees::None)];
/// Shares of the base's horizon.
pub const HORIZONS: [f64; 3] = [1.0, 0.5, 0.25];
/// The finest relief, as a share of a pixel.
const FINEST: f64 = 0.1;
/// Rounds that are run whatever the budget.
const FEWEST_ROUNDS: usize = 3;

/// Why the lab has no answer.
#[derive(Debug, thiserror::Error)]
pub enum ForestLabError {
    /// A frame cannot be composed.
    #[error(transparent)]
    Frame(#[from] FrameError),
    /// A frame makes no plan.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// The rasterizer gave no picture.
    #[error("{0}")]
    NoPicture(String),
}

/// One way to show a forest.
#[derive(Clone, Debug, PartialEq)]
pub struct Way {
    /// What it differs in from the base; `base` for the base itself.
    pub name: String,
    /// What is composed.
    pub frame: frame::Choices,
    /// How it is drawn.
    pub choices: Choices,
}

/// What is compared.
pub struct Subject<'a> {
    /// The area.
    pub cells: &'a Cells,
    /// Its pictures.
    pub pictures: &'a Pictures,
    /// Where it is seen from; its resolution is the size of the picture.
    pub camera: Camera,
    /// What draws.
    pub rasterizer: &'a dyn Rasterizer,
}

/// The base and its neighbors, one knob at a time; then all knobs towards cheap.
#[must_use]
pub fn ways(base: &frame::Choices, choices: &Choices) -> Vec<Way> {
    let mut ways = vec![Way { name: "base".to_string(), frame: *base, choices: choices.clone() }];
    let mut add = |name: String, frame: frame::Choices, choices: Choices| {
        if ways.iter().all(|way| way.frame != frame || way.choices != choices) {
            ways.push(Way { name, frame, choices });
        }
    };
    for tolerance in TOLERANCES {
        add(format!("tolerance {tolerance}"), frame::Choices { tolerance, ..*base }, choices.clone());
    }
    for (word, trees) in TREES {
        add(format!("trees {word}"), frame::Choices { trees, ..*base }, choices.clone());
    }
    for share in HORIZONS {
        let horizon = base.horizon * share;
        add(format!("horizon {horizon}"), frame::Choices { horizon, ..*base }, choices.clone());
    }
    for &texture_filter in TextureFilter::ALL {
        let name = format!("filter {}", texture_filter.name());
        add(name, *base, Choices { texture_filter, ..choices.clone() });
    }
    for samples in [1, 2] {
        add(format!("samples {samples}"), *base, Choices { samples, ..choices.clone() });
    }
    let cheap = frame::Choices { tolerance: 4.0, horizon: base.horizon * 0.5, ..*base };
    add("tolerance 4, half the horizon".to_string(), cheap, choices.clone());
    let fine = frame::Choices { tolerance: 0.5, ..*base };
    add("tolerance 0.5, samples 2".to_string(), fine, Choices { samples: 2, ..choices.clone() });
    ways
}

/// Judges and times every way.
///
/// # Errors
/// [`ForestLabError`] when a frame cannot be composed or drawn.
pub fn run(
    subject: &Subject<'_>,
    ways: &[Way],
    (effort, progress): (&Effort, Progress<'_>),
) -> Result<Vec<Row>, ForestLabError> {
    let mut bench = Bench { subject, composers: Vec::new() };
    let Some(base) = ways.first() else { return Ok(Vec::new()) };
    let (truth, scene) = bench.truth(base)?;
    let plain = Choices { samples: 1, ..base.choices.clone() };
    let judge = Judge::new(&scene, &truth, &plain);
    let mut rows = Vec::new();
    for (index, way) in ways.iter().enumerate() {
        progress("judging", index, ways.len());
        let errors = judge.of_image(&bench.draw(way)?);
        rows.push(row(way, errors));
    }
    let times = bench.times(ways, effort, progress)?;
    for (row, times) in rows.iter_mut().zip(times) {
        row.timing = Timing::of(&times);
    }
    Ok(rows)
}

fn row(way: &Way, errors: Errors) -> Row {
    let configuration =
        Configuration { name: way.name.clone(), rasterizer: "forest".to_string(), choices: way.choices.clone() };
    Row { configuration, timing: Timing::default(), errors, failure: None }
}

/// Composers by horizon: other choices can change from frame to frame.
struct Bench<'a> {
    subject: &'a Subject<'a>,
    composers: Vec<Composer<'a>>,
}

impl<'a> Bench<'a> {
    /// The composer of a way, with its choices made.
    fn composer(&mut self, wanted: &frame::Choices) -> Result<&mut Composer<'a>, FrameError> {
        let is_right = |composer: &Composer<'_>| composer.choices().horizon == wanted.horizon;
        let index = match self.composers.iter().position(is_right) {
            Some(index) => index,
            None => {
                let Subject { cells, pictures, .. } = *self.subject;
                self.composers.push(Composer::new(cells, pictures.clone(), *wanted)?);
                self.composers.len() - 1
            }
        };
        let composer = &mut self.composers[index];
        composer.choose(*wanted)?;
        Ok(composer)
    }

    fn draw(&mut self, way: &Way) -> Result<Image, ForestLabError> {
        let (camera, rasterizer) = (self.subject.camera, self.subject.rasterizer);
        let (scene, _) = self.composer(&way.frame)?.compose(&camera, camera.resolution)?;
        let rendered = render::render(scene, &way.choices, Some(rasterizer))?;
        match rendered.puts.failure {
            Some(reason) => Err(ForestLabError::NoPicture(reason)),
            None => Ok(rendered.image),
        }
    }

    /// The frame of which nothing is left out, and the scene it shows.
    fn truth(&mut self, base: &Way) -> Result<(Truth, crate::scene::Scene), ForestLabError> {
        let frame = frame::Choices { trees: Trees::Crossed, tolerance: FINEST, hiding: false, ..base.frame };
        let choices = Choices { samples: SAMPLES, ..base.choices.clone() };
        let way = Way { name: String::new(), frame, choices };
        let image = self.draw(&way)?;
        let camera = self.subject.camera;
        let (scene, _) = self.composer(&frame)?.compose(&camera, camera.resolution)?;
        let light: Vec<_> = image.pixels().iter().map(|light| light.to_f64()).collect();
        let size = (image.width() as u32, image.height() as u32);
        let uneven = vec![false; light.len()];
        let source = Source::OwnFinest(RayError::Picture { place: "forest".to_string() });
        Ok((Truth { size, pixels: (0..light.len() as u32).collect(), light, uneven, source }, scene.clone()))
    }

    /// Milliseconds of every way, each once a round in random order; the first round warms up.
    fn times(
        &mut self,
        ways: &[Way],
        effort: &Effort,
        progress: Progress<'_>,
    ) -> Result<Vec<Vec<f64>>, ForestLabError> {
        let mut random = Random::new(effort.seed);
        let mut times = vec![Vec::new(); ways.len()];
        let start = Instant::now();
        for round in 0..=effort.rounds {
            if round > FEWEST_ROUNDS && start.elapsed() > effort.budget {
                break;
            }
            for index in shuffled(ways.len(), &mut random) {
                let start = Instant::now();
                self.draw(&ways[index])?;
                if round > 0 {
                    times[index].push(start.elapsed().as_secs_f64() * 1e3);
                }
            }
            progress("timing", round + 1, effort.rounds + 1);
        }
        Ok(times)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_axis_is_there_and_nothing_twice() {
        let ways = ways(&frame::Choices::default(), &Choices::default());
        for word in ["base", "tolerance", "trees", "horizon", "filter", "samples"] {
            assert!(ways.iter().any(|way| way.name.starts_with(word)), "{word}");
        }
        for (index, way) in ways.iter().enumerate() {
            let twin = ways[..index].iter().find(|other| other.frame == way.frame && other.choices == way.choices);
            assert!(twin.is_none(), "{} {twin:?}", way.name);
        }
        // The base is in the middle of the axes: it is named once.
        assert_eq!((ways[0].frame.tolerance, ways.len()), (1.0, 1 + 4 + 3 + 2 + 2 + 1 + 2));
    }
}
