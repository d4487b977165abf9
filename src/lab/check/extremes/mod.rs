//! Extremes: input at the edge of what can be said, and what must come of it.
//!
//! text, scene or draw list -> parse, plan, geometry, rasterizer -> the stated outcome
//!
//! The catalogue has 102 items. Each is a small function that makes its input, runs it through the library and says what is wrong.
//! Nothing may panic, nothing may take long, no picture may hold a number that is not finite.
//!
//! Source: `docs/accuracy.md` has the table. Cost: milliseconds an item; a few are large on purpose.

mod clip;
mod coordinates;
mod hierarchy;
mod misbehaving;
mod output;
mod parse;
mod polygons;
mod shapes;
mod surfaces;
mod terrain;
mod tools;
mod view;

use super::{Effort, Report};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Instant;

/// What is wrong with an outcome, in a sentence; or nothing.
type Outcome = Result<(), String>;

/// How an item is tried.
#[derive(Clone, Copy)]
enum Trial {
    /// By this experiment.
    Run(fn(&Effort) -> Outcome),
}

/// One item of the catalogue: its number, what goes in and what must come out, and the experiment.
type Item = (u32, &'static str, Trial);

/// How many items the catalogue has.
const ITEMS: usize = 102;

/// Tries every item.
pub(super) fn run(effort: &Effort, report: &mut Report) {
    let items = catalogue();
    let (mut met, mut missed) = (0, 0);
    let mut slowest = (0.0_f64, 0);
    for &(number, text, trial) in &items {
        let start = Instant::now();
        let Trial::Run(experiment) = trial;
        match caught(experiment, effort) {
            Ok(()) => met += 1,
            Err(wrong) => {
                missed += 1;
                report.miss(format!("{number} {text}: {wrong}"));
            }
        }
        let seconds = start.elapsed().as_secs_f64();
        if seconds > slowest.0 {
            slowest = (seconds, number);
        }
    }
    if let Some(notice) = misbehaving::notice() {
        report.count(format!("notice: {notice}"), 1);
    }
    let numbers: Vec<u32> = items.iter().map(|item| item.0).collect();
    if numbers != (1..=ITEMS as u32).collect::<Vec<_>>() {
        report.miss("the catalogue is not the numbers 1 to 102 in order");
    }
    report.count("items of the catalogue", ITEMS as u64);
    report.some("items that meet the stated outcome", met);
    report.none("items that do not", missed);
    // Informs only: a busy machine must not decide whether a claim holds.
    report.measure(format!("seconds of the slowest item, {}", slowest.1), slowest.0);
}

fn catalogue() -> Vec<Item> {
    [
        parse::ITEMS,
        view::ITEMS,
        coordinates::ITEMS,
        polygons::ITEMS,
        clip::ITEMS,
        surfaces::ITEMS,
        shapes::ITEMS,
        hierarchy::ITEMS,
        terrain::ITEMS,
        output::ITEMS,
    ]
    .concat()
}

/// A panic is an outcome, too, and never the stated one.
fn caught(experiment: fn(&Effort) -> Outcome, effort: &Effort) -> Outcome {
    catch_unwind(AssertUnwindSafe(|| experiment(effort))).unwrap_or_else(|_| Err("panicked".to_string()))
}
