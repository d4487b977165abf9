//! Pareto: which configurations nobody beats in both time and error.
//!
//! times, errors -PARETO-> standing of each
//!
//! Time is noisy, error is not. The front is drawn through the medians; but a configuration is called *dominated* only when it is
//! beaten by more than the spread of both times. What is beaten by less is *tied*: another run may put it on the front. Of
//! equal errors and equal times the first in the list stands for all, which is the one nearest to the base.
//!
//! A front as one number is its *hypervolume*: the share of a box of the chart (both axes logarithmic) that its points dominate. The
//! box reaches from the ideal point, the least time and the least error of all that was measured, to the reference point, the most
//! of both. So 1 is a point in the ideal corner, and numbers compare only within one box: sets of points of one run.
//!
//! Source: E. Zitzler, L. Thiele, "Multiobjective Optimization Using Evolutionary Algorithms", PPSN V, 1998.

use crate::math::log;

/// Where a configuration stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Standing {
    /// No other is as accurate in less time.
    Front,
    /// Beaten, but by less than the spread of the times.
    Tied,
    /// Beaten.
    Dominated,
}

/// A configuration as a point: what it costs and how wrong it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Median milliseconds.
    pub time: f64,
    /// Spread of the time, milliseconds.
    pub spread: f64,
    /// Error of one kind; infinite where it is not known.
    pub error: f64,
}

/// Errors closer than this part of each other are equal.
const SAME: f64 = 1e-9;

/// The standing of each point.
#[must_use]
pub fn standings(points: &[Point]) -> Vec<Standing> {
    let standing = |own: usize| {
        let beaten_by = |other: usize| {
            let (a, b) = (&points[other], &points[own]);
            let same = (a.error - b.error).abs() <= SAME * b.error.abs() || a.error == b.error;
            let wins = same && (a.time, other) < (b.time, own) || a.error < b.error && !same && a.time <= b.time;
            (other != own && wins).then_some(b.time - a.time > a.spread + b.spread)
        };
        let beaten: Vec<bool> = (0..points.len()).filter_map(beaten_by).collect();
        match (beaten.is_empty(), beaten.contains(&true)) {
            (true, _) => Standing::Front,
            (false, false) => Standing::Tied,
            (false, true) => Standing::Dominated,
        }
    };
    (0..points.len())
        .map(|own| if points[own].error.is_finite() { standing(own) } else { Standing::Dominated })
        .collect()
}

/// The indices of the front, the cheapest and least accurate first.
#[must_use]
pub fn front(points: &[Point]) -> Vec<usize> {
    let standings = standings(points);
    let mut front: Vec<usize> = (0..points.len()).filter(|&at| standings[at] == Standing::Front).collect();
    front.sort_by(|&a, &b| points[b].error.total_cmp(&points[a].error).then(a.cmp(&b)));
    front
}

/// The box that hypervolumes are shares of. Both corners are (milliseconds, error).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    /// The least time and the least error.
    pub ideal: (f64, f64),
    /// The most time and the largest error.
    pub reference: (f64, f64),
}

/// An error of 0 has no logarithm: it counts as this part of the least positive one.
const ZERO: f64 = 0.1;

impl Extent {
    /// The box around all points whose error is known; `None` where it has no area, because all times or all errors are the same.
    #[must_use]
    pub fn of(points: &[Point]) -> Option<Extent> {
        let known = || points.iter().filter(|point| point.error.is_finite());
        let range = |values: &mut dyn Iterator<Item = f64>| {
            values.fold((f64::INFINITY, 0.0), |(low, high): (f64, f64), value| (low.min(value), high.max(value)))
        };
        let times = range(&mut known().map(|point| point.time).filter(|&time| time > 0.0));
        let mut errors = range(&mut known().map(|point| point.error).filter(|&error| error > 0.0));
        if known().any(|point| point.error == 0.0) {
            errors.0 *= ZERO;
        }
        let has_area = times.0 < times.1 && errors.0 < errors.1;
        has_area.then_some(Extent { ideal: (times.0, errors.0), reference: (times.1, errors.1) })
    }

    /// Where a point is in the box: (0, 0) is the ideal corner, (1, 1) the reference.
    fn place(&self, point: &Point) -> (f64, f64) {
        let share = |value: f64, low: f64, high: f64| {
            if value > low { (log(value / low) / log(high / low)).min(1.0) } else { 0.0 }
        };
        (share(point.time, self.ideal.0, self.reference.0), share(point.error, self.ideal.1, self.reference.1))
    }
}

/// The share of the box that `points` dominate: what is as slow or slower and as wrong or worse. Points outside count as on its border.
#[must_use]
pub fn hypervolume(points: &[Point], extent: &Extent) -> f64 {
    let known = points.iter().filter(|point| point.error.is_finite());
    let mut places: Vec<(f64, f64)> = known.map(|point| extent.place(point)).collect();
    places.sort_by(|a, b| a.0.total_cmp(&b.0));

    // From fast to slow: until the next point comes, the most accurate so far dominates all above it.
    let ends = places.iter().skip(1).map(|place| place.0).chain([1.0]);
    let mut least = 1.0_f64;
    let mut sum = 0.0;
    for (&(start, error), end) in places.iter().zip(ends) {
        least = least.min(error);
        sum += (end - start) * (1.0 - least);
    }
    sum
}
