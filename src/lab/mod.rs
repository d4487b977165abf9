//! Lab: what accuracy farop has, and what more of it would cost.
//!
//! oracle, render -LAB-> figures
//!
//! Why a room of its own: tests say *that* something holds, on cases small enough for every commit; the lab says *how well*, with
//! counts large enough to mean something, and anybody can run it again by name.
//!
//! [`check`] has the claims about accuracy. The rest is the trade of speed for accuracy: [`configurations`] lists ways to draw a
//! scene, [`measure`] times them, [`errors`] compares them with the [`truth`], [`pareto`] finds the ones worth having, [`table`] and
//! [`chart`] show them, and [`promise`] picks one for an error that is asked for.

pub mod chart;
pub mod check;
pub mod configurations;
pub mod errors;
pub mod measure;
mod owners;
pub mod pareto;
pub mod promise;
pub mod table;
pub mod truth;

use self::configurations::Configuration;
use self::errors::{Errors, Judge};
use self::measure::{Effort, Timing};
use self::truth::Truth;
use crate::plan::{Choices, PlanError};
use crate::raster::Rasterizer;
use crate::scene::Scene;
use serde::Serialize;

/// One configuration with what it costs and how wrong it is.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// What was drawn.
    pub configuration: Configuration,
    /// How long it took.
    pub timing: Timing,
    /// How far it is from the truth.
    pub errors: Errors,
}

/// The kinds of error that are charted and have a front.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Kind {
    /// [`Errors::rms_levels`].
    Rms,
    /// [`Errors::worst_levels`].
    Worst,
    /// [`Errors::thousandth_levels`].
    Thousandth,
    /// [`Errors::wrong_visible_ppm`].
    Visible,
    /// [`Errors::silhouette_px`].
    Silhouette,
    /// [`Errors::flip_mean`].
    Flip,
}

impl Kind {
    /// All kinds, the one that the table's front is about first.
    pub const ALL: [Kind; 6] = [Kind::Rms, Kind::Worst, Kind::Thousandth, Kind::Visible, Kind::Silhouette, Kind::Flip];

    /// Name and unit.
    #[must_use]
    pub fn title(self) -> &'static str {
        match self {
            Kind::Rms => "RMS error, levels of 255",
            Kind::Worst => "worst pixel, levels of 255",
            Kind::Thousandth => "error that 1 pixel in 1000 exceeds, levels",
            Kind::Visible => "wrong polygon or shape visible, samples in a million",
            Kind::Silhouette => "farthest point of the outline, pixels",
            Kind::Flip => "mean FLIP",
        }
    }

    /// The error of this kind; infinite where no oracle has an answer.
    #[must_use]
    pub fn of(self, errors: &Errors) -> f64 {
        match self {
            Kind::Rms => errors.rms_levels,
            Kind::Worst => errors.worst_levels,
            Kind::Thousandth => errors.thousandth_levels,
            Kind::Visible => errors.wrong_visible_ppm.unwrap_or(f64::INFINITY),
            Kind::Silhouette => errors.silhouette_px.unwrap_or(f64::INFINITY),
            Kind::Flip => errors.flip_mean,
        }
    }
}

/// The rows as points of one kind of error.
#[must_use]
pub fn points(rows: &[Row], kind: Kind) -> Vec<pareto::Point> {
    let point =
        |row: &Row| pareto::Point { time: row.timing.median, spread: row.timing.spread, error: kind.of(&row.errors) };
    rows.iter().map(point).collect()
}

/// Told what is going on: the work, how much of it is done, how much there is.
pub type Progress<'a> = &'a dyn Fn(&str, usize, usize);

/// Judges and times every configuration; `truth` is that of `base`.
///
/// # Errors
/// [`PlanError`] when a configuration makes no plan.
pub fn run(
    scene: &Scene,
    (base, truth): (&Choices, &Truth),
    configurations: &[(Configuration, &dyn Rasterizer)],
    (effort, progress): (&Effort, Progress<'_>),
) -> Result<Vec<Row>, PlanError> {
    let base = Choices { samples: 1, ..base.clone() };
    let judge = Judge::new(scene, truth, &base);
    let mut errors = Vec::new();
    for (index, (configuration, rasterizer)) in configurations.iter().enumerate() {
        progress("judging", index, configurations.len());
        errors.push(judge.errors(configuration, *rasterizer)?);
    }
    let borrowed: Vec<_> =
        configurations.iter().map(|(configuration, rasterizer)| (configuration, *rasterizer)).collect();
    let timings = measure::measure(scene, &borrowed, effort, &|done, all| progress("timing", done, all));
    let rows = configurations.iter().zip(timings).zip(errors);
    Ok(rows.map(|((entry, timing), errors)| Row { configuration: entry.0.clone(), timing, errors }).collect())
}
