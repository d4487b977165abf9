//! Paint: the picture of a case under given rules, sample by sample.
//!
//! Case, [`Rules`] -PAINT-> levels of every pixel, with the band inside which an honest rasterizer may differ
//!
//! Shares no code with the rasterizers and no plane of the list: depth and values come from the faces' own planes in f64. Under
//! the contract's rules its owners are those of [`crate::oracle::exact`]; a test holds it to that.
//!
//! The ambiguous band: a level may be either of two where the light is within 1/25 of a level of the boundary between them; a
//! pixel is not judged at all where two slanted faces are closer in depth than eight last digits of f32, or where a line
//! passes within 1/500 of a sample of its diamond's border.
//!
//! Cost: the faces' corners times the samples of the case.

use super::case::{Case, Face};
use super::covered::Outline;
use super::covering::Covering;
use super::lighting;
use super::line_spans;
use super::lines;
use super::memory;
use super::pixels;
use super::place;
use super::rules::{Interpolation, Levels, Memory, PixelFrom, Rules, SampleAt};
use super::shape;
use super::stack::{Stack, depth, point};
use super::values::{self, Corners};
use crate::math::pow;

/// Half the width of the band around a boundary between two levels, in levels.
const LEVEL_BAND: f64 = 0.04;

/// A picture as it should be, with its tolerance.
#[derive(Clone, Debug, PartialEq)]
pub struct Painted {
    /// Pixels across.
    pub width: usize,
    /// Pixels down.
    pub height: usize,
    /// The least level of every channel.
    pub low: Vec<[u8; 3]>,
    /// The greatest.
    pub high: Vec<[u8; 3]>,
    /// Not judged.
    pub disputed: Vec<bool>,
    /// The face that is in front at the pixel's (first) sample.
    pub front: Vec<Option<usize>>,
}

impl Painted {
    /// Whether pixel `index` may show `level`.
    #[must_use]
    pub fn allows(&self, index: usize, level: [u8; 3]) -> bool {
        self.disputed[index]
            || (0..3).all(|channel| (self.low[index][channel]..=self.high[index][channel]).contains(&level[channel]))
    }
}

/// One sample, drawn.
#[derive(Clone, Copy, Default)]
pub(super) struct Sample {
    pub color: [f64; 3],
    pub front: Option<usize>,
    pub disputed: bool,
    /// A face shows here.
    pub is_drawn: bool,
}

/// Draws `case` under `rules`.
#[must_use]
pub fn paint(case: &Case, rules: &Rules) -> Painted {
    painted(case, rules, None)
}

/// The same, where `contract` is what the contract covers in it: most mistakes cover no other samples.
pub(super) fn paint_known(case: &Case, rules: &Rules, contract: &Covering) -> Painted {
    painted(case, rules, Some(contract).filter(|_| Covering::is_of_contract(rules)))
}

fn painted(case: &Case, rules: &Rules, known: Option<&Covering>) -> Painted {
    let case = &*shape::seen(case, rules);
    let mut samples = if case.lines { paint_lines(case, rules) } else { paint_samples(case, rules, known) };
    let size = (case.width as usize, case.height as usize);
    place::keep_inside_border(&mut samples, size, rules.border, empty(case, rules));
    let samples = place::placed(&samples, size, rules.place, empty(case, rules));
    let side = case.samples as usize;
    let (width, height) = (size.0 / side, size.1 / side);
    let mut painted =
        Painted { width, height, low: Vec::new(), high: Vec::new(), disputed: Vec::new(), front: Vec::new() };
    for y in 0..height {
        for x in 0..width {
            let all = (0..side * side).map(|at| samples[(y * side + at / side) * size.0 + x * side + at % side]);
            let all: Vec<Sample> = all.collect();
            let mixed = match rules.pixel {
                PixelFrom::MixedByFace(later) if side > 1 => Some(mixed(case, rules, (x, y), later)),
                _ => None,
            };
            let (low, high) = pixel(case, &all, rules, mixed);
            painted.low.push(low);
            painted.high.push(high);
            painted.disputed.push(all.iter().any(|sample| sample.disputed));
            painted.front.push(all[0].front);
        }
    }
    painted
}

fn empty(case: &Case, rules: &Rules) -> Sample {
    let color = rules.background.map_or(case.background, |level| [level; 3]);
    Sample { color, ..Sample::default() }
}

fn paint_lines(case: &Case, rules: &Rules) -> Vec<Sample> {
    let (empty, rule) = (empty(case, rules), &rules.lines);
    let mut samples = vec![empty; (case.width * case.height) as usize];
    let color = rule.ink.on(case.background);
    for (index, face) in case.faces.iter().enumerate().filter(|&(index, _)| rule.draws(index, case.faces.len())) {
        lines::outline(&face.corners, rule, (case.width, case.height), |at, is_certain| {
            let old = samples[at];
            let was_certain = old.front.is_some() && !old.disputed;
            let shown = Sample { color, front: Some(index), disputed: !is_certain && !was_certain, is_drawn: true };
            samples[at] = if rule.is_exclusive && old.front.is_some() { empty } else { shown };
        });
    }
    samples
}

fn paint_samples(case: &Case, rules: &Rules, known: Option<&Covering>) -> Vec<Sample> {
    let corner_values: Vec<_> = case.faces.iter().map(|face| Corners::of(face, rules)).collect();
    let right_places = rules.sample_at == SampleAt::Own || case.samples < 2;
    if !right_places {
        return paint_elsewhere(case, rules, &corner_values);
    }
    let own = known.is_none().then(|| Covering::of(case, rules));
    let Some(covering) = known.or(own.as_ref()) else { return Vec::new() };
    let color = |index: usize, sample: (i32, i32)| shown_color(case, index, &corner_values[index], rules, sample);
    if rules.memory != Memory::RIGHT {
        return memory::paint(case, rules, covering, (empty(case, rules), &color));
    }
    let mut samples = Vec::new();
    for y in 0..case.height as i32 {
        let covers = |x: i32| covering.at((x, y));
        let line = line_spans::stacks(case, rules, y, &covers);
        for x in 0..case.width as i32 {
            let stack = match &line {
                Some(stacks) => stacks[x as usize].clone(),
                None => Stack::of(case, rules, (x, y), covers(x)),
            };
            samples.push(stack.shown(case, rules, empty(case, rules), |index| color(index, (x, y))));
        }
    }
    samples
}

/// Samples of a pixel that are asked for at another place.
fn paint_elsewhere(case: &Case, rules: &Rules, corner_values: &[Corners]) -> Vec<Sample> {
    let outline = |face: &Face| Outline::new(&face.corners, rules, (case.width, case.height));
    let outlines: Vec<Outline> = case.faces.iter().map(outline).collect();
    let mut samples = Vec::new();
    for y in 0..case.height as i32 {
        for x in 0..case.width as i32 {
            let moved = asked_elsewhere(case, rules, (x, y));
            let covering = (0..case.faces.len()).filter(|&index| outlines[index].covers((x, y), &moved));
            let stack = Stack::of(case, &moved, (x, y), covering);
            let color = |index: usize| shown_color(case, index, &corner_values[index], &moved, (x, y));
            samples.push(stack.shown(case, &moved, empty(case, &moved), color));
        }
    }
    samples
}

fn shown_color(case: &Case, index: usize, corners: &Corners, rules: &Rules, sample: (i32, i32)) -> [f64; 3] {
    let color = face_color(case, index, corners, rules, sample);
    rules.face_tone.of(rules.face_channels.map(|channel| color[channel]))
}

/// The rules with the place at which a sample of a pixel is asked for.
fn asked_elsewhere(case: &Case, rules: &Rules, (x, y): (i32, i32)) -> Rules {
    let place = pixels::place((x, y), case.samples as i32, rules.sample_at);
    Rules { cover_at: (place.0 - f64::from(x), place.1 - f64::from(y)), ..rules.clone() }
}

/// A pixel to which each face is added by its share of it, in list order.
fn mixed(case: &Case, rules: &Rules, (x, y): (usize, usize), later_counts: bool) -> [f64; 3] {
    let side = case.samples as i32;
    let (mut color, mut kept) = (empty(case, rules).color, 0.0);
    for (index, face) in case.faces.iter().enumerate() {
        let outline = Outline::new(&face.corners, rules, (case.width, case.height));
        let places = (0..side * side).map(|at| (x as i32 * side + at % side, y as i32 * side + at / side));
        let own: Vec<_> = places.filter(|&place| outline.covers(place, rules)).collect();
        let Some(&first) = own.first() else { continue };
        let depth = depth(face, rules, (first, case.samples));
        if depth < kept || (depth == kept && !later_counts) {
            continue;
        }
        kept = depth;
        let share = own.len() as f64 / f64::from(side * side);
        let light = face_color(case, index, &Corners::of(face, rules), rules, first);
        color = [0, 1, 2].map(|channel| color[channel] * (1.0 - share) + light[channel] * share);
    }
    color
}

fn face_color(case: &Case, index: usize, corners: &Corners, rules: &Rules, sample: (i32, i32)) -> [f64; 3] {
    let face = &case.faces[index];
    let place = if rules.block.of_values { rules.block.of(face, sample) } else { sample };
    let at = rules.origin.of(face, point(place, rules));
    if let Some(lamp) = &case.lamp {
        return lighting::light((case, lamp), (face, corners), rules, at);
    }
    // One color is one color, whatever the weights; a divided or multiplied one is not.
    let stays = keeps_flat(rules.values) && !rules.spares_exact && !rules.divides_by_kept;
    if corners.is_flat && (stays || rules.spares_constants) {
        return corners.values[0];
    }
    let kept = rules.divides_by_kept.then(|| depth(face, rules, (sample, case.samples)));
    let values = values::interpolated(face, corners, rules, (at, kept));
    if rules.value_channels == [true; 3] {
        return values;
    }
    let right = face.values_at(at);
    [0, 1, 2].map(|channel: usize| if rules.value_channels[channel] { values[channel] } else { right[channel] })
}

/// Whether values that are the same at all corners stay so.
fn keeps_flat(values: Interpolation) -> bool {
    use Interpolation as I;
    !matches!(
        values,
        I::NotMultipliedBack
            | I::MultipliedTwice
            | I::TimesDepth
            | I::AffineDivided
            | I::AffineTimes
            | I::DividedBy(_)
            | I::LimitsOnOverW
            | I::Without(_)
            | I::Times(_)
            | I::WithoutX
            | I::WithoutY
    )
}

/// The least and greatest levels of a pixel.
///
/// A mean of levels differs from that of light by half a level at most, and who rounds every sample right is right.
fn pixel(case: &Case, samples: &[Sample], rules: &Rules, mixed: Option<[f64; 3]>) -> ([u8; 3], [u8; 3]) {
    let of = |rule: PixelFrom| pixel_by(samples, (rules, rule), mixed);
    let (low, high) = of(rules.pixel);
    if !case.answered_in_levels || samples.len() == 1 || rules.pixel != PixelFrom::Mean {
        return (low, high);
    }
    let (other_low, other_high) = of(PixelFrom::MeanOfLevels(if rules.levels == Levels::Down { 0.0 } else { 0.5 }));
    (
        [0, 1, 2].map(|channel| low[channel].min(other_low[channel])),
        [0, 1, 2].map(|channel| high[channel].max(other_high[channel])),
    )
}

fn pixel_by(samples: &[Sample], (rules, pixel): (&Rules, PixelFrom), mixed: Option<[f64; 3]>) -> ([u8; 3], [u8; 3]) {
    let side = (samples.len() as f64).sqrt() as usize;
    let shown: Vec<pixels::Shown> = samples.iter().map(|sample| (sample.color, sample.front)).collect();
    let color = mixed.unwrap_or_else(|| pixels::light(&shown, side, (pixel, rules.pixel_of_one)));
    let color = rules.tone.of(rules.channels.map(|channel| color[channel]));
    let is_face = samples.len() == 1 && samples[0].is_drawn;
    let levels = if is_face { rules.face_levels.unwrap_or(rules.levels) } else { rules.levels };
    (color.map(|light| level(light, -LEVEL_BAND, levels)), color.map(|light| level(light, LEVEL_BAND, levels)))
}

fn level(light: f64, band: f64, levels: Levels) -> u8 {
    let light = light.clamp(0.0, 1.0);
    let number = match levels {
        Levels::Round => (light * 255.0 + band).round(),
        Levels::Down => (light * 255.0 + band).floor(),
        Levels::Times256 => (light * 256.0 + band).floor(),
        Levels::Unscaled => light.floor(),
        Levels::Up => (light * 255.0 + band).ceil(),
        // Above 255 it starts again.
        Levels::Wraps => (light * 256.0 + band).round() % 256.0,
        Levels::More(more) => (light * 255.0 + band).round() + more,
        Levels::MoreInByte(more) => ((light * 255.0 + band).round() + more).rem_euclid(256.0),
        Levels::CutOf(steps) => ((light * steps + band * steps / 255.0).floor() * 255.0 / steps).round(),
        Levels::OfCut(steps) => ((light * steps + band * steps / 255.0).round() * 255.0 / steps).floor(),
        Levels::Power(power) => (pow(light, power) * 255.0 + band).round(),
        Levels::Of(steps) => ((light * steps + band * steps / 255.0).round() * 255.0 / steps).round(),
        Levels::Scaled(steps) => (light * steps + band).round(),
        Levels::Squared => (light * light * 255.0 + band).round(),
        Levels::Gamma22 => (pow(light, 1.0 / 2.2) * 255.0 + band).round(),
        Levels::Srgb => {
            let display = if light <= 0.003_130_8 { light * 12.92 } else { 1.055 * pow(light, 1.0 / 2.4) - 0.055 };
            (display * 255.0 + band).round()
        }
    };
    number.clamp(0.0, 255.0) as u8
}
