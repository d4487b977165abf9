//! Lab: what accuracy farop has, and what more of it would cost.
//!
//! oracle, render -LAB-> figures
//!
//! Why a room of its own: tests say *that* something holds, on cases small enough for every commit; the lab says *how well*, with
//! counts large enough to mean something, and anybody can run it again by name.
//!
//! [`check`] has the claims about accuracy. The rest is the trade of speed for accuracy: [`configurations`] lists ways to draw a
//! scene, [`measure`] times them, [`errors`] compares them with the [`truth`], [`pareto`] finds the ones worth having, [`table`] and
//! [`chart`] show them, [`bench`] tells where the time of a frame goes, and [`promise`] picks one for an error that is asked for.

pub mod bench;
pub mod chart;
pub mod check;
pub mod configurations;
pub mod errors;
pub mod forest;
pub mod measure;
mod owners;
pub mod pareto;
pub mod promise;
pub mod table;
pub mod truth;

use self::configurations::Configuration;
use self::errors::{Errors, Judge, NoErrors};
use self::measure::{Effort, Timing};
use self::pareto::{Extent, Point, hypervolume};
use self::truth::Truth;
use crate::plan::{Choices, PlanError};
use crate::raster::Rasterizer;
use crate::scene::Scene;
use serde::Serialize;
use std::collections::BTreeMap;

/// One configuration with what it costs and how wrong it is.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// What was drawn.
    pub configuration: Configuration,
    /// How long it took.
    pub timing: Timing,
    /// How far it is from the truth.
    pub errors: Errors,
    /// Why there is no picture, from a rasterizer outside farop; then times are 0 and errors those of no picture.
    pub failure: Option<String>,
}

/// So many failures of a rasterizer that has never given a picture, and its other configurations are not tried: each may take its
/// whole time limit.
const HOPELESS: usize = 3;

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

    /// The name of its column.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Kind::Rms => "rms",
            Kind::Worst => "worst",
            Kind::Thousandth => "1/1000",
            Kind::Visible => "visible",
            Kind::Silhouette => "outline",
            Kind::Flip => "FLIP",
        }
    }

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

/// How much of time and error of one kind the rows dominate: see [`pareto::hypervolume`].
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Volume {
    /// Which error.
    #[serde(skip)]
    pub kind: Kind,
    /// Least milliseconds and least error of all rows.
    pub ideal: (f64, f64),
    /// Most milliseconds and largest error of all rows.
    pub reference: (f64, f64),
    /// Hypervolume of all rows.
    pub all: f64,
    /// Hypervolume of the rows of each rasterizer, in the same box; `None` where the error of none of them is known.
    pub of: BTreeMap<String, Option<f64>>,
}

/// The hypervolumes of every kind of error that tells rows apart.
#[must_use]
pub fn volumes(rows: &[Row]) -> Vec<Volume> {
    let volume = |kind: Kind| {
        let points = points(rows, kind);
        let extent = Extent::of(&points)?;
        let mut by_rasterizer: BTreeMap<String, Vec<Point>> = BTreeMap::new();
        for (row, &point) in rows.iter().zip(&points) {
            by_rasterizer.entry(row.configuration.rasterizer.clone()).or_default().push(point);
        }
        let is_known = |points: &[Point]| points.iter().any(|point| point.error.is_finite());
        let of = |points: Vec<Point>| is_known(&points).then(|| hypervolume(&points, &extent));
        let of = by_rasterizer.into_iter().map(|(name, points)| (name, of(points))).collect();
        let Extent { ideal, reference } = extent;
        Some(Volume { kind, ideal, reference, all: hypervolume(&points, &extent), of })
    };
    Kind::ALL.into_iter().filter_map(volume).collect()
}

/// Told what is going on: the work, how much of it is done, how much there is.
pub type Progress<'a> = &'a dyn Fn(&str, usize, usize);

/// Judges and times every configuration; `truth` is that of `base`. What gives no picture becomes a row with its reason.
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
    let mut rows: Vec<Row> = Vec::new();
    for (index, (configuration, rasterizer)) in configurations.iter().enumerate() {
        progress("judging", index, configurations.len());
        let judged = match hopeless(&rows, &configuration.rasterizer) {
            Some(reason) => Err(NoErrors::NoPicture(format!("not tried after {HOPELESS} failures: {reason}"))),
            None => judge.errors(configuration, *rasterizer),
        };
        let (errors, failure) = match judged {
            Ok(errors) => (errors, None),
            Err(NoErrors::NoPicture(reason)) => (Errors::NO_PICTURE, Some(reason)),
            Err(NoErrors::Plan(error)) => return Err(error),
        };
        rows.push(Row { configuration: configuration.clone(), timing: Timing::default(), errors, failure });
    }
    let drawn: Vec<usize> = (0..rows.len()).filter(|&index| rows[index].failure.is_none()).collect();
    let borrowed: Vec<_> = drawn.iter().map(|&index| (&configurations[index].0, configurations[index].1)).collect();
    let timings = measure::measure(scene, &borrowed, effort, &|done, all| progress("timing", done, all));
    for (index, timing) in drawn.into_iter().zip(timings) {
        match timing {
            Ok(timing) => rows[index].timing = timing,
            Err(reason) => (rows[index].errors, rows[index].failure) = (Errors::NO_PICTURE, Some(reason)),
        }
    }
    Ok(rows)
}

/// The first reason of a rasterizer that has failed often enough and never given a picture.
fn hopeless<'a>(rows: &'a [Row], rasterizer: &str) -> Option<&'a str> {
    let own = || rows.iter().filter(|row| row.configuration.rasterizer == rasterizer);
    (own().count() >= HOPELESS && own().all(|row| row.failure.is_some()))
        .then(|| own().find_map(|row| row.failure.as_deref()))
        .flatten()
}
