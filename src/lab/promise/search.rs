//! Search: from a guess to the cheapest choices that hold.
//!
//! The error has two parts with two remedies. Where nothing happens in a pixel, shading and tessellation are to blame; where an
//! outline passes, samples. So:
//! 1. the cheapest shading whose even pixels are right, at one sample a pixel;
//! 2. samples: an edge errs like A^-1.5 (`accuracy` of a grid on slanted edges), so the first guess at A is
//!    (error / goal)^(2/3) of the last; tolerance and depth become finer where more samples stop helping;
//! 3. back: one step less of each knob, as long as the promise still holds and the picture took less time.
//!
//! Source for the exponent: measured, `farop check aa`. Cost: some ten pictures.

use super::{Court, Trials, Verdict, has_shapes};
use crate::lab::configurations::TOLERANCES;
use crate::math::pow;
use crate::oracle::ray::Tracer;
use crate::plan::{Choices, DepthFormat, Plan, PlanError, Shading};

/// Samples a pixel in each direction that are tried.
const SAMPLES: [u32; 8] = [1, 2, 3, 4, 6, 8, 12, 16];
/// A grid of more samples is not tried: it would take minutes.
const MOST_SAMPLES: u64 = 1 << 26;
/// More samples that leave more than this part of the error do not help.
const STALL: f64 = 0.9;
/// Finer than the lab's: the last resort.
const FINEST_TOLERANCE: f64 = 1.0 / 64.0;

/// The attempt that keeps the court's levels at the least cost found; `None` when none does.
pub(super) fn levels(
    trials: &mut Trials<'_>,
    court: &Court<'_>,
    base: &Choices,
    plan: &Plan,
) -> Result<Option<usize>, PlanError> {
    let (mut choices, mut verdict) = shading(trials, court, base, has_shapes(plan))?;
    let mut stalled = false;
    while !verdict.holds {
        let pixels = u64::from(plan.view.pixels.0) * u64::from(plan.view.pixels.1);
        let next = if stalled { None } else { finer(&choices, verdict.reached / court.levels, pixels) };
        let Some((next, reason)) = next.or_else(|| last_resort(&choices, has_shapes(plan))) else { return Ok(None) };
        let (last, more_samples) = (verdict.reached, next.samples > choices.samples);
        choices = next;
        verdict = trials.try_levels(court, choices.clone(), reason)?;
        // Twice the samples should leave a third of the error.
        stalled = more_samples && verdict.reached > STALL * last;
    }
    back(trials, court, (choices, verdict), has_shapes(plan)).map(Some)
}

/// The cheapest shading that is right where nothing happens.
fn shading(
    trials: &mut Trials<'_>,
    court: &Court<'_>,
    base: &Choices,
    has_shapes: bool,
) -> Result<(Choices, Verdict), PlanError> {
    let with = |shading: Shading, tolerance: f64| Choices { shading, tolerance, samples: 1, ..base.clone() };
    let mut guesses = vec![
        (with(Shading::Flat, base.tolerance), "cheapest shading"),
        (with(Shading::Gouraud, base.tolerance), "flat faces err inside"),
        (with(Shading::Phong, base.tolerance), "light between vertices errs"),
    ];
    if has_shapes {
        guesses.push((with(Shading::Phong, base.tolerance / 16.0), "facets err inside"));
    }
    let mut found = None;
    for (choices, reason) in guesses {
        let verdict = trials.try_levels(court, choices.clone(), reason)?;
        let right = verdict.even <= court.allowed / 2;
        found = Some((choices, verdict));
        if right {
            break;
        }
    }
    Ok(found.expect("there are guesses"))
}

/// More samples: as many as the error asks for.
fn finer(choices: &Choices, excess: f64, pixels: u64) -> Option<(Choices, &'static str)> {
    let wanted = f64::from(choices.samples) * pow(excess, 2.0 / 3.0) * 0.8;
    let affordable = |samples: &&u32| pixels * u64::from(**samples) * u64::from(**samples) <= MOST_SAMPLES;
    let mut larger = SAMPLES.iter().filter(|&&samples| samples > choices.samples).filter(affordable);
    let last = larger.clone().next_back();
    let samples = *larger.find(|&&samples| f64::from(samples) >= wanted).or(last)?;
    Some((Choices { samples, ..choices.clone() }, "outlines err: more samples"))
}

/// When samples do not help any more.
fn last_resort(choices: &Choices, has_shapes: bool) -> Option<(Choices, &'static str)> {
    if choices.shading != Shading::Phong {
        return Some((
            Choices { shading: Shading::Phong, ..choices.clone() },
            "samples do not help: light at every sample",
        ));
    }
    if has_shapes && choices.tolerance > FINEST_TOLERANCE {
        let tolerance = FINEST_TOLERANCE;
        return Some((Choices { tolerance, ..choices.clone() }, "samples do not help: finer shapes"));
    }
    let exact = Choices { depth: DepthFormat::F64, subpixel_bits: 12.max(choices.subpixel_bits), ..choices.clone() };
    (exact != *choices).then_some((exact, "samples do not help: more digits"))
}

/// From choices that hold to cheaper ones that hold.
fn back(
    trials: &mut Trials<'_>,
    court: &Court<'_>,
    (mut choices, mut verdict): (Choices, Verdict),
    has_shapes: bool,
) -> Result<usize, PlanError> {
    let knobs: [fn(&Choices, bool) -> Option<Choices>; 3] = [fewer_samples, coarser_shapes, simpler_shading];
    for knob in knobs {
        while let Some(cheaper) = knob(&choices, has_shapes) {
            let tried = trials.try_levels(court, cheaper.clone(), "is less enough?")?;
            if !tried.holds || tried.time > verdict.time {
                break;
            }
            (choices, verdict) = (cheaper, tried);
        }
    }
    Ok(verdict.attempt)
}

fn fewer_samples(choices: &Choices, _: bool) -> Option<Choices> {
    let samples = *SAMPLES.iter().rev().find(|&&samples| samples < choices.samples)?;
    Some(Choices { samples, ..choices.clone() })
}

fn coarser_shapes(choices: &Choices, has_shapes: bool) -> Option<Choices> {
    let tolerance = *TOLERANCES.iter().rev().find(|&&tolerance| tolerance > choices.tolerance)?;
    has_shapes.then(|| Choices { tolerance, ..choices.clone() })
}

fn simpler_shading(choices: &Choices, _: bool) -> Option<Choices> {
    let shading = match choices.shading {
        Shading::Phong => Shading::Gouraud,
        Shading::Gouraud => Shading::Flat,
        _ => return None,
    };
    Some(Choices { shading, ..choices.clone() })
}

/// The attempt whose outline is nowhere farther off than `limit` pixels; `None` when none is.
pub(super) fn outline(
    trials: &mut Trials<'_>,
    tracer: &Tracer<'_>,
    base: &Choices,
    (limit, plan): (f64, &Plan),
) -> Result<Option<usize>, PlanError> {
    // Snapping moves a corner by up to half a diagonal of its grid.
    let snap = |bits: u32| 0.71 / f64::from(1_u32 << bits) / f64::from(base.samples);
    let bits = (base.subpixel_bits..=16).find(|&bits| snap(bits) < limit / 4.0).unwrap_or(16);
    let first = Choices { tolerance: (limit - snap(bits)).max(limit / 4.0), subpixel_bits: bits, ..base.clone() };
    let found = trials.try_outline(tracer, first.clone(), limit, "as tolerance and snapping say")?;
    if trials.attempts[found].holds {
        return Ok(Some(found));
    }
    let mut choices = first;
    for _ in 0..4 {
        if has_shapes(plan) {
            choices.tolerance /= 2.0;
        } else if choices.subpixel_bits < 16 {
            choices.subpixel_bits = 16.min(choices.subpixel_bits + 4);
        } else {
            break;
        }
        let found = trials.try_outline(tracer, choices.clone(), limit, "finer")?;
        if trials.attempts[found].holds {
            return Ok(Some(found));
        }
    }
    Ok(None)
}
