//! Fits: whether somebody with a given mistake would answer as the student did.

use super::judge::{self, NEAR};
use super::mutants::{self, Rules};
use super::names::Kind;
use super::{ATTRIBUTES, Answer, Asks, Case};
use crate::geometry::clip::ClipVertex;

/// What `f32` is off by at most, in sizes of the polygon.
const SINGLE: f64 = 2e-5;

/// Whether `answer`, which is right or not, is that of the mistake.
pub(super) fn fits(kind: &Kind, case: &Case, answer: &Answer, is_right: bool) -> bool {
    let Ok(answers) = answer else { return false };
    let symptom = |asks: Asks| is_right || (case.asks == asks && has_shape(case, answer));
    match kind {
        Kind::Rules(rules) => fits_rules(rules, case, answers, is_right),
        Kind::Cracks => symptom(Asks::Neighbor),
        Kind::OneSided => symptom(Asks::OtherSide),
        Kind::LastPlace => symptom(Asks::LastPlace),
        Kind::Doubles => symptom(Asks::NoDoubles),
        Kind::Single => {
            let right = mutants::right(case);
            is_right || (!alike(case, &answers[0], &right, NEAR) && alike(case, &answers[0], &right, SINGLE))
        }
    }
}

fn has_shape(case: &Case, answer: &Answer) -> bool {
    judge::complaint(&Case { asks: Asks::Shape, ..case.clone() }, answer).is_none()
}

fn fits_rules(rules: &Rules, case: &Case, answers: &[Vec<ClipVertex>], is_right: bool) -> bool {
    let would: Vec<_> = case.inputs().iter().map(|(polygon, volume)| mutants::clip(rules, polygon, volume)).collect();
    let is_same = answers.iter().zip(&would).all(|(answer, would)| alike(case, answer, would, NEAR));
    match (is_right, is_same) {
        (true, true) => return true,
        (false, false) => return false,
        _ => {}
    }
    // Right in another way; or wrong by last places only. Mutants round as they like.
    let asks = if case.asks == Asks::LastPlace { Asks::Shape } else { case.asks };
    let would_be_right = judge::complaint(&Case { asks, ..case.clone() }, &Ok(would)).is_none();
    would_be_right == is_right
}

/// Whether two answers are the same outline, begun anywhere, with the same of what is asked for.
fn alike(case: &Case, one: &[ClipVertex], two: &[ClipVertex], near: f64) -> bool {
    let (one, two) = (without_doubles(one), without_doubles(two));
    if one.len() != two.len() {
        return false;
    }
    let near = near * case.size();
    let close = |a: f64, b: f64| (a - b).abs() <= 16.0 * near || a == b;
    let same = |a: &ClipVertex, b: &ClipVertex| {
        (a.position - b.position).abs().max_element() <= near
            && (case.asks != Asks::Attributes || (0..ATTRIBUTES).all(|n| close(a.attributes[n], b.attributes[n])))
            && (case.asks != Asks::Marks || a.edge == b.edge)
    };
    one.is_empty() || (0..one.len()).any(|by| (0..one.len()).all(|at| same(&one[at], &two[(at + by) % two.len()])))
}

fn without_doubles(outline: &[ClipVertex]) -> Vec<ClipVertex> {
    let mut kept: Vec<ClipVertex> = Vec::new();
    for vertex in outline {
        match kept.last_mut() {
            Some(last) if last.position == vertex.position => *last = *vertex,
            _ => kept.push(*vertex),
        }
    }
    while kept.len() > 1 && kept.first().map(|v| v.position) == kept.last().map(|v| v.position) {
        kept.pop();
    }
    if kept.len() < 3 { Vec::new() } else { kept }
}
