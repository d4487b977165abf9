//! Measure: how long each configuration takes.
//!
//! configurations -MEASURE-> median, spread and minimum of each
//!
//! A machine that slows down must slow all of them: every round runs each configuration once, in a new random order, and the
//! first round warms up and is dropped. A time is what a frame costs: plan, geometry, rasterizer, averaging; not parsing
//! and not writing. Of a rasterizer that is a program the start and all that goes to and fro belong to the frame. Rounds end after 15, or when the budget is spent (but not before 3).

use super::check::Random;
use super::configurations::Configuration;
use crate::raster::Rasterizer;
use crate::render;
use crate::scene::Scene;
use serde::Serialize;
use std::time::{Duration, Instant};

/// Times of one configuration, milliseconds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Timing {
    /// The middle one.
    pub median: f64,
    /// Median distance from the median.
    pub spread: f64,
    /// The least.
    pub least: f64,
    /// How many runs were counted.
    pub runs: usize,
}

/// How long to measure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effort {
    /// Rounds after the one that warms up.
    pub rounds: usize,
    /// No further round starts when this is spent.
    pub budget: Duration,
    /// Decides the order within a round.
    pub seed: u64,
}

/// Rounds that are run whatever the budget.
const FEWEST_ROUNDS: usize = 3;

impl Timing {
    /// Median, spread and least of some times.
    #[must_use]
    pub fn of(times: &[f64]) -> Timing {
        let middle = median(times.to_vec());
        let distances = times.iter().map(|time| (time - middle).abs()).collect();
        let least = times.iter().copied().fold(f64::INFINITY, f64::min);
        Timing { median: middle, spread: median(distances), least, runs: times.len() }
    }
}

/// The middle value; the mean of the two middle ones; 0 of none.
#[must_use]
pub fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    match values.len() {
        0 => 0.0,
        count if count % 2 == 1 => values[count / 2],
        count => (values[count / 2 - 1] + values[count / 2]) / 2.0,
    }
}

/// Times every configuration; `progress` is told rounds done and rounds in all. One that gives no picture is not run again,
/// and its reason takes the place of its times.
pub fn measure(
    scene: &Scene,
    configurations: &[(&Configuration, &dyn Rasterizer)],
    effort: &Effort,
    progress: &dyn Fn(usize, usize),
) -> Vec<Result<Timing, String>> {
    let mut random = Random::new(effort.seed);
    let mut times = vec![Ok(Vec::new()); configurations.len()];
    let start = Instant::now();
    for round in 0..=effort.rounds {
        if round > FEWEST_ROUNDS && start.elapsed() > effort.budget {
            break;
        }
        for index in shuffled(configurations.len(), &mut random) {
            let (configuration, rasterizer) = configurations[index];
            let Ok(own_times) = &mut times[index] else { continue };
            let start = Instant::now();
            let rendered = render::render(scene, &configuration.choices, Some(rasterizer));
            let time = start.elapsed().as_secs_f64() * 1e3;
            // Freed outside the time.
            if let Some(reason) = rendered.ok().and_then(|rendered| rendered.puts.failure) {
                times[index] = Err(reason);
            } else if round > 0 {
                own_times.push(time);
            }
        }
        progress(round + 1, effort.rounds + 1);
    }
    times.into_iter().map(|times| times.map(|times| Timing::of(&times))).collect()
}

/// The numbers below `count` in random order (Fisher and Yates).
pub(super) fn shuffled(count: usize, random: &mut Random) -> Vec<usize> {
    let mut order: Vec<usize> = (0..count).collect();
    for last in (1..count).rev() {
        order.swap(last, random.below(last as u64 + 1) as usize);
    }
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn timings_by_hand() {
        let timing = Timing::of(&[5.0, 1.0, 2.0, 9.0, 3.0]);
        assert_eq!(timing, Timing { median: 3.0, spread: 2.0, least: 1.0, runs: 5 });
        assert_eq!(median(vec![4.0, 1.0]), 2.5);
    }

    #[test]
    fn an_order_has_everybody_once() {
        let mut order = shuffled(40, &mut Random::new(7));
        assert_ne!(order, (0..40).collect::<Vec<_>>());
        order.sort_unstable();
        assert_eq!(order, (0..40).collect::<Vec<_>>());
    }
}
