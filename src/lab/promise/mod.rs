//! Promise: the cheapest choices that keep an error that the user asks for.
//!
//! Scene, `--max-error` -PROMISE-> choices, and why
//!
//! `N` levels: at most one pixel in a thousand errs by more in a channel, before rounding to 8 bits (which adds up to half a
//! level). `Npx`: no point of the outline is farther from where it belongs. The ray oracle is the judge; nothing is promised
//! from a formula alone. Formulas only say where to look (`search.rs`).
//!
//! A picture of more than 65,536 pixels is judged at 32,768 of them, one at random in each of as many equal shares. Then
//! less than one in a thousand is allowed: so much less (two standard deviations) that chance hides a miss once in forty. And
//! as the rays themselves err a little, pixels must keep to 95 % of the limit.
//!
//! Cost: the truth (see [`super::truth`]) and some ten pictures.

mod search;

use super::check::Random;
use super::errors::{FARTHEST, pixel_errors, silhouette};
use super::truth::{Source, Truth};
use crate::image::Image;
use crate::oracle::ray::{RayError, Tracer};
use crate::plan::{Accepts, Choices, Plan, PlanError};
use crate::raster::Rasterizer;
use crate::render;
use crate::scene::Scene;
use std::time::Instant;

/// What is asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Goal {
    /// Levels of 255 that at most one pixel in a thousand exceeds.
    Levels(f64),
    /// Pixels between the outlines.
    Pixels(f64),
}

impl std::str::FromStr for Goal {
    type Err = String;

    /// `4` are levels, `0.5px` are pixels.
    fn from_str(text: &str) -> Result<Goal, String> {
        let (number, make): (&str, fn(f64) -> Goal) =
            text.strip_suffix("px").map_or((text, Goal::Levels as fn(f64) -> Goal), |number| (number, Goal::Pixels));
        match number.trim().parse::<f64>() {
            Ok(value) if value > 0.0 && value.is_finite() => Ok(make(value)),
            _ => Err("expected levels above 0, as in 4, or pixels, as in 0.5px".to_string()),
        }
    }
}

impl std::fmt::Display for Goal {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Goal::Levels(levels) => write!(formatter, "{levels} levels"),
            Goal::Pixels(pixels) => write!(formatter, "{pixels} px"),
        }
    }
}

/// One picture that was tried.
#[derive(Clone, Debug, PartialEq)]
pub struct Attempt {
    /// What it was drawn with.
    pub choices: Choices,
    /// Its error, in the unit of the goal.
    pub error: f64,
    /// Whether it keeps the promise.
    pub holds: bool,
    /// How long it took, milliseconds.
    pub time: f64,
    /// Why it was tried.
    pub reason: &'static str,
}

/// Choices that keep the promise, and how they were found.
#[derive(Clone, Debug, PartialEq)]
pub struct Promise {
    /// What was asked for.
    pub goal: Goal,
    /// What keeps it.
    pub choices: Choices,
    /// The error they have, in the unit of the goal.
    pub error: f64,
    /// All pictures that were tried, in order.
    pub attempts: Vec<Attempt>,
    /// Pixels judged, and pixels in all.
    pub judged: (usize, usize),
    /// Who judged.
    pub source: Source,
    /// Seconds spent on the search.
    pub seconds: f64,
}

/// Why nothing can be promised.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PromiseError {
    /// The scene has no usable view.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// Outlines are only known of shapes with an equation.
    #[error("an outline cannot be promised: {0}")]
    NoOracle(#[from] RayError),
    /// The best that was found is worse.
    #[error(
        "an error of at most {goal} cannot be promised: the best found is {best:.3} {unit}, with {choices}\n\
         help: ask for --max-error {help}"
    )]
    Impossible {
        /// What was asked for.
        goal: Goal,
        /// The least error found.
        best: f64,
        /// Its unit.
        unit: &'static str,
        /// What it was reached with.
        choices: String,
        /// An error that can be promised.
        help: String,
    },
}

/// Pictures of so many pixels are judged at every pixel; larger ones at [`SUBSET`].
const WHOLE: u64 = 1 << 16;
const SUBSET: u64 = 1 << 15;
/// The rays themselves err, by about a level at an edge from black to white: pixels may reach only this part of the limit.
const MARGIN: f64 = 0.95;

/// Finds choices that keep `goal`; everything but shading, samples, tolerance, sub-pixel bits and depth is taken from `base`.
///
/// # Errors
/// [`PromiseError`] when nothing that was tried keeps it.
pub fn keep(scene: &Scene, base: &Choices, rasterizer: &dyn Rasterizer, goal: Goal) -> Result<Promise, PromiseError> {
    let start = Instant::now();
    let plan = Plan::new(scene, base, rasterizer.accepts())?;
    let pixels = u64::from(plan.view.pixels.0) * u64::from(plan.view.pixels.1);
    let mut trials = Trials { scene, rasterizer, attempts: Vec::new() };
    let (found, judged, source) = match goal {
        Goal::Levels(levels) => {
            let some = (pixels > WHOLE).then(|| subset(pixels));
            let truth = Truth::new(scene, base, some)?;
            let levels = levels * MARGIN;
            let court = Court { allowed: allowed(truth.pixels.len(), pixels), levels, truth: &truth };
            let found = search::levels(&mut trials, &court, base, &plan)?;
            (found, truth.pixels.len(), truth.source)
        }
        Goal::Pixels(limit) => {
            let base_of_rays = Choices { samples: 1, ..base.clone() };
            let tracer = Tracer::new(scene, &base_of_rays)?;
            (search::outline(&mut trials, &tracer, base, (limit, &plan))?, pixels as usize, Source::Rays)
        }
    };
    let attempts = trials.attempts;
    let Some(found) = found else { return Err(impossible(goal, &attempts)) };
    let (choices, error) = (attempts[found].choices.clone(), attempts[found].error);
    let seconds = start.elapsed().as_secs_f64();
    Ok(Promise { goal, choices, error, attempts, judged: (judged, pixels as usize), source, seconds })
}

/// One pixel in each of [`SUBSET`] equal shares of the picture.
fn subset(pixels: u64) -> Vec<u32> {
    let mut random = Random::new(pixels);
    let start = |share: u64| share * pixels / SUBSET;
    (0..SUBSET).map(|share| (start(share) + random.below(start(share + 1) - start(share))) as u32).collect()
}

/// How many of the judged pixels may exceed the limit.
fn allowed(judged: usize, pixels: u64) -> usize {
    let expected = judged as f64 / 1000.0;
    if judged as u64 == pixels { expected as usize } else { (expected - 2.0 * expected.sqrt()).max(0.0) as usize }
}

fn impossible(goal: Goal, attempts: &[Attempt]) -> PromiseError {
    let best = attempts.iter().min_by(|a, b| a.error.total_cmp(&b.error));
    let (best, choices) = best.map_or((f64::INFINITY, String::new()), |best| (best.error, describe(&best.choices)));
    let above = (best * 11.0).ceil() / 10.0;
    let (unit, help) = match goal {
        Goal::Levels(_) => ("levels", format!("{above}")),
        Goal::Pixels(_) => ("px", format!("{}px", (best * 1100.0).ceil() / 1000.0)),
    };
    PromiseError::Impossible { goal, best, unit, choices, help }
}

/// The knobs that a promise turns, in words.
#[must_use]
pub fn describe(choices: &Choices) -> String {
    format!(
        "{} shading, {1} x {1} samples, tolerance {2} px, {3} sub-pixel bits, depth {4}",
        choices.shading.name(),
        choices.samples,
        choices.tolerance,
        choices.subpixel_bits,
        choices.depth.name()
    )
}

impl Promise {
    /// What was picked and why, in lines.
    #[must_use]
    pub fn text(&self) -> String {
        let Promise { goal, error, judged, seconds, .. } = self;
        let unit = if matches!(goal, Goal::Levels(_)) { "levels" } else { "px" };
        let mut text = format!("max-error  {goal}: {}\n", describe(&self.choices));
        for attempt in &self.attempts {
            let verdict = if attempt.holds { "holds" } else { "fails" };
            let (error, time) = (attempt.error, attempt.time);
            text += &format!(
                "  {verdict} {error:>8.3} {unit:<6} {time:>8.1} ms  {}: {}\n",
                describe(&attempt.choices),
                attempt.reason
            );
        }
        let who = match &self.source {
            Source::Rays => "rays".to_string(),
            Source::OwnFinest(why) => format!("our own finest picture, because {why}"),
        };
        text + &format!(
            "  error {error:.3} {unit}, judged by {who} at {} of {} pixels; the search took {seconds:.1} s\n",
            judged.0, judged.1
        )
    }
}

/// Draws what is tried and remembers it.
struct Trials<'a> {
    scene: &'a Scene,
    rasterizer: &'a dyn Rasterizer,
    attempts: Vec<Attempt>,
}

/// Judges pictures by their levels.
struct Court<'a> {
    truth: &'a Truth,
    levels: f64,
    /// Pixels that may exceed the levels.
    allowed: usize,
}

/// What a picture came to.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Verdict {
    attempt: usize,
    holds: bool,
    /// Pixels too wrong where nothing happens: shading's fault.
    even: usize,
    /// The level that as many pixels exceed as may.
    reached: f64,
    time: f64,
}

impl Court<'_> {
    fn judge(&self, image: &Image, choices: &Choices) -> (usize, usize, f64) {
        let errors = pixel_errors(self.truth, image, choices.encoding);
        let mut largest: Vec<f64> = errors.map(|error| error.into_iter().fold(0.0, f64::max)).collect();
        let even =
            largest.iter().zip(&self.truth.uneven).filter(|&(&error, &uneven)| error > self.levels && !uneven).count();
        let all = largest.iter().filter(|&&error| error > self.levels).count();
        largest.sort_by(|a, b| b.total_cmp(a));
        (all, even, largest.get(self.allowed).copied().unwrap_or(0.0))
    }
}

impl Trials<'_> {
    fn try_levels(&mut self, court: &Court<'_>, choices: Choices, reason: &'static str) -> Result<Verdict, PlanError> {
        if let Some(at) = self.attempts.iter().position(|attempt| attempt.choices == choices) {
            let Attempt { holds, error, time, .. } = self.attempts[at];
            return Ok(Verdict { attempt: at, holds, even: 0, reached: error, time });
        }
        let start = Instant::now();
        let image = render::render(self.scene, &choices, Some(self.rasterizer))?.image;
        let time = start.elapsed().as_secs_f64() * 1e3;
        let (all, even, reached) = court.judge(&image, &choices);
        let holds = all <= court.allowed;
        self.attempts.push(Attempt { choices, error: reached, holds, time, reason });
        Ok(Verdict { attempt: self.attempts.len() - 1, holds, even, reached, time })
    }

    fn try_outline(
        &mut self,
        tracer: &Tracer<'_>,
        choices: Choices,
        limit: f64,
        reason: &'static str,
    ) -> Result<usize, PlanError> {
        let start = Instant::now();
        let list = render::list(self.scene, &choices, Some(self.rasterizer))?;
        let time = start.elapsed().as_secs_f64() * 1e3;
        let error = silhouette(tracer, &list, choices.samples);
        self.attempts.push(Attempt { choices, error, holds: error <= limit && error < FARTHEST, time, reason });
        Ok(self.attempts.len() - 1)
    }
}

/// Whether a plan has shapes that a tolerance can act on.
fn has_shapes(plan: &Plan) -> bool {
    debug_assert!(plan.accepts == Accepts::AnyPolygon || plan.accepts == Accepts::Triangles);
    plan.survey.shapes > 0 && plan.choices.resolution.is_none()
}
