//! Pareto: which configurations nobody beats in both time and error.
//!
//! times, errors -PARETO-> standing of each
//!
//! Time is noisy, error is not. The front is drawn through the medians; but a configuration is called *dominated* only when it is
//! beaten by more than the spread of both times. What is beaten by less is *tied*: another run may put it on the front. Of
//! equal errors and equal times the first in the list stands for all, which is the one nearest to the base.

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
