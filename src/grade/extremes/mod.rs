//! Extremes: at which size, offset or depth a rasterizer begins to be wrong.
//!
//! kind of list x 2^k -SUBJECT-> Picture, held against [`crate::oracle::exact`] -> the first k at which it breaks
//!
//! The probes of a lab are a dozen samples wide; there every number fits everywhere. Here one number of a list is doubled again and again:
//! how far right, how large, how thin, how many, how near in depth. A wrong program says itself where its numbers end.
//!
//! Judged by whole numbers of any length, not by a rasterizer. No center lies on an outline, so tie rules do not matter. Only
//! facts are reported: the step, what shows there, and how many binary digits the numbers of that list have.
//!
//! Space: samples; a list's polygons have colors of their own. Cost: some 150 pictures, the largest of a million samples.

mod depths;
mod kinds;
mod outlines;
mod report;

pub use report::{json, text};

use super::labs::Lab;
use super::subject::{Failure, Subject};
use crate::oracle::exact::{Rules, judge};
use crate::plan::Accepts;
use crate::screen::DrawList;
use crate::screen::file::Sheet;
use std::collections::BTreeMap;

/// One number that is pushed to its extremes.
#[derive(Clone, Copy)]
pub struct Kind {
    /// In reports.
    pub name: &'static str,
    /// What is drawn.
    pub draws: &'static str,
    /// It asks which polygon is in front, not only what is covered.
    pub is_about_depth: bool,
    /// It has polygons of more than three corners.
    pub has_polygons: bool,
    /// The steps, the mildest first: a name and the list.
    pub steps: fn() -> Vec<Step>,
}

/// One list of a kind.
#[derive(Clone, Debug)]
pub struct Step {
    /// How far it is pushed: `2^13`.
    pub name: String,
    /// What to draw.
    pub list: DrawList,
}

/// What is wrong at one step.
#[derive(Clone, Debug)]
pub struct Break {
    /// The step.
    pub step: Step,
    /// What is seen.
    pub what: What,
}

/// What is seen of a list that is not drawn right.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum What {
    /// Samples are wrong.
    Wrong {
        /// How many.
        count: usize,
        /// Samples of the picture.
        samples: usize,
        /// The first: column and row.
        first: (usize, usize),
        /// What it shows; `None`: a color of no polygon.
        shown: Option<Shown>,
        /// What it should show.
        expected: Shown,
    },
    /// The picture is right, but so many fragments were put outside of it.
    Stray(u64),
    /// There is no picture.
    NoPicture(Failure),
}

/// What a sample shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shown {
    /// Nothing.
    Background,
    /// The polygon of that number, from 0.
    Polygon(u32),
}

/// What was found of one kind.
#[derive(Clone, Debug)]
pub struct Finding {
    /// The kind's name.
    pub kind: &'static str,
    /// What it draws.
    pub draws: &'static str,
    /// Names of the steps that were tried.
    pub tried: Vec<String>,
    /// Of them, those that are wrong.
    pub wrong: Vec<String>,
    /// The first that is wrong.
    pub first: Option<Break>,
}

/// The kinds that `lab` is about, for a rasterizer that takes `accepts`; empty for a lab that fills no polygons.
#[must_use]
pub fn kinds(lab: &Lab, accepts: Accepts) -> Vec<Kind> {
    let has = |name: &str| lab.aspects.iter().any(|aspect| aspect.name == name);
    let (fills, depth) = (has("sample position"), has("depth"));
    let applies = |kind: &Kind| {
        fills && (depth || !kind.is_about_depth) && (accepts == Accepts::AnyPolygon || !kind.has_polygons)
    };
    [kinds::KINDS, outlines::KINDS, depths::KINDS].concat().into_iter().filter(applies).collect()
}

/// Draws all steps of `kind`; behind a step without a picture nothing more is tried.
#[must_use]
pub fn probe(subject: &dyn Subject, kind: &Kind) -> Finding {
    let mut finding = Finding { kind: kind.name, draws: kind.draws, tried: Vec::new(), wrong: Vec::new(), first: None };
    for step in (kind.steps)() {
        finding.tried.push(step.name.clone());
        let Some(what) = fault(subject, &step.list) else { continue };
        finding.wrong.push(step.name.clone());
        let is_over = matches!(what, What::NoPicture(_));
        finding.first.get_or_insert(Break { step, what });
        if is_over {
            break;
        }
    }
    finding
}

/// What is wrong with the subject's picture of `list`; `None` when nothing is.
#[must_use]
pub fn fault(subject: &dyn Subject, list: &DrawList) -> Option<What> {
    let answer = match subject.draw(list, &Sheet::default()) {
        Ok(answer) => answer,
        Err(failure) => return Some(What::NoPicture(failure)),
    };
    let (width, height) = (list.width as usize, list.height as usize);
    let drawn = (answer.picture.width(), answer.picture.height());
    if drawn != (width, height) {
        let message = format!("the picture is {} x {}, not {width} x {height}", drawn.0, drawn.1);
        return Some(What::NoPicture(Failure { message, hint: String::new() }));
    }
    let owners = judge(list, &Rules::CONTRACT).owner;
    let shown = |owner: &Option<u32>| owner.map_or(Shown::Background, Shown::Polygon);
    let levels: BTreeMap<[u8; 3], Shown> = std::iter::once(([0; 3], Shown::Background))
        .chain((0..list.len() as u32).map(|number| (level(number), Shown::Polygon(number))))
        .collect();
    let pairs: Vec<_> =
        answer.picture.colors().zip(&owners).map(|(color, owner)| (levels.get(&color), shown(owner))).collect();
    let is_wrong = |(drawn, expected): &(Option<&Shown>, Shown)| *drawn != Some(expected);
    if let Some(at) = pairs.iter().position(is_wrong) {
        let count = pairs.iter().filter(|pair| is_wrong(pair)).count();
        let (drawn, expected) = pairs[at];
        let (first, shown) = ((at % width, at / width), drawn.copied());
        return Some(What::Wrong { count, samples: width * height, first, shown, expected });
    }
    let stray = answer.puts.map_or(0, |puts| puts.stray_writes);
    (stray > 0).then_some(What::Stray(stray))
}

/// The levels of polygon `number`: no two alike below 2^24, none like the background.
fn level(number: u32) -> [u8; 3] {
    // An odd factor permutes the numbers below 2^24, and neighbors get colors that the eye can tell apart.
    let [_, red, green, blue] = ((number + 1).wrapping_mul(0x9E_3779) & 0xFF_FFFF).to_be_bytes();
    [red, green, blue]
}

/// Adds a polygon with a color of its own.
fn push(list: &mut DrawList, corners: &[(f64, f64)], depth: f64) {
    let color = level(list.len() as u32).map(|level| f64::from(level) / 255.0);
    list.push_flat(corners, depth, color);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_center_lies_on_an_outline_and_something_is_covered() {
        for kind in [kinds::KINDS, outlines::KINDS, depths::KINDS].concat() {
            for step in (kind.steps)() {
                let counts = judge(&step.list, &Rules::CONTRACT).counts;
                assert_eq!(counts.on_outline, 0, "{} {}", kind.name, step.name);
                let may_be_empty = ["empty list", "corners that coincide"].contains(&kind.name);
                assert!(counts.covered > 0 || may_be_empty, "{} {}", kind.name, step.name);
            }
        }
    }
}
