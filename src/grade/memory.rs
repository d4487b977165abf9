//! Memory: pictures of programs that keep the depth or the color of a sample at a wrong address.
//!
//! Faces one after another, sample by sample -> what is kept at the addresses -> the picture that is read from it
//!
//! Why beside [`super::stack`], which asks every sample by itself: here samples share a place, so the order of all of them matters.
//!
//! Cost: as any picture.

use super::case::Case;
use super::covering::Covering;
use super::paint::Sample;
use super::rules::{Address, Blending, Memory, Rules};
use super::stack::{Stack, depth, wins};
use std::collections::BTreeMap;

impl Address {
    /// The place of a sample in a picture of that size, where `side` samples are the side of a pixel.
    fn of(self, (x, y): (i32, i32), (width, height): (i32, i32), side: i32) -> i32 {
        match self {
            Address::Own => y * width + x,
            Address::TimesHeight => y * height + x,
            Address::ByColumns => x * height + y,
            Address::ColumnTimesWidth => x * width + y,
            Address::Stride(more) => y * (width + more) + x,
            Address::Pixel => y / side * side * width + x / side * side,
            Address::Row => y * width,
            Address::Column => x,
            Address::One => 0,
        }
    }
}

type Color<'a> = &'a dyn Fn(usize, (i32, i32)) -> [f64; 3];

/// The samples as they are read in the end, row by row.
pub(super) fn paint(
    case: &Case,
    rules: &Rules,
    covering: &Covering,
    (empty, color): (Sample, Color<'_>),
) -> Vec<Sample> {
    let (size, side) = ((case.width as i32, case.height as i32), case.samples as i32);
    let Memory { depth_at, color_at, walk, read_beside, written_beside } = rules.memory;
    let beside =
        |(x, y): (i32, i32), by: (i32, i32)| ((x + by.0).clamp(0, size.0 - 1), (y + by.1).clamp(0, size.1 - 1));
    let mut depths: BTreeMap<i32, f64> = BTreeMap::new();
    let mut shown = vec![empty; (case.width * case.height) as usize];
    let is_glass = |index: usize| case.faces[index].opacity < 1.0 && rules.blending != Blending::Ignored;
    for (index, samples) in covering.faces().filter(|face| !is_glass(face.0)) {
        let mut samples: Vec<_> = samples.collect();
        walk.sort(&case.faces[index], &mut samples);
        for sample in samples {
            let own = depth(&case.faces[index], rules, (sample, case.samples)).min(rules.capped);
            let kept = depths.get(&depth_at.of(beside(sample, read_beside), size, side)).copied();
            let place = depth_at.of(beside(sample, written_beside), size, side);
            let is_shown = wins(rules, kept, own);
            let old = depths.get(&place).copied();
            depths.extend(rules.kept.after(old, (own, is_shown)).map(|depth| (place, depth)));
            if is_shown && let Some(at) = shown.get_mut(color_at.of(sample, size, side) as usize) {
                *at = Stack::of_front(index, own).shown(case, rules, empty, |index| color(index, sample));
            }
        }
    }
    for y in 0..size.1 {
        for x in 0..size.0 {
            let kept = depths.get(&depth_at.of((x, y), size, side)).copied();
            let mut panes = Stack::default();
            panes.kept = kept;
            for index in covering.at((x, y)).filter(|&index| is_glass(index)) {
                panes.add_glass(index, depth(&case.faces[index], rules, ((x, y), case.samples)));
            }
            if let Some(at) = shown.get_mut(color_at.of((x, y), size, side) as usize) {
                at.color = panes.shown(case, rules, *at, |index| color(index, (x, y))).color;
            }
        }
    }
    shown
}
