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
use super::lighting;
use super::line_spans;
use super::lines;
use super::pixels;
use super::place;
use super::rules::{Blending, DepthFrom, Front, Interpolation, Levels, PixelFrom, Rules, SampleAt};
use super::runs;
use super::values::{self, Corners};
use crate::math::pow;

/// Half the width of the band around a boundary between two levels, in levels.
const LEVEL_BAND: f64 = 0.04;
/// Part of a depth within which the order of slanted faces is not judged.
const DEPTH_BAND: f64 = 8.0 * f32::EPSILON as f64;

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
struct Sample {
    color: [f64; 3],
    front: Option<usize>,
    disputed: bool,
}

/// Draws `case` under `rules`.
#[must_use]
pub fn paint(case: &Case, rules: &Rules) -> Painted {
    let mut samples = if case.lines { paint_lines(case, rules) } else { paint_samples(case, rules) };
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
            let (low, high) = pixel(&all, rules, mixed);
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
            let shown = Sample { color, front: Some(index), disputed: !is_certain && !was_certain };
            samples[at] = if rule.is_exclusive && old.front.is_some() { empty } else { shown };
        });
    }
    samples
}

fn paint_samples(case: &Case, rules: &Rules) -> Vec<Sample> {
    let outlines: Vec<Outline> =
        case.faces.iter().map(|face| Outline::new(&face.corners, rules, (case.width, case.height))).collect();
    let corner_values: Vec<_> = case.faces.iter().map(|face| Corners::of(face, rules)).collect();
    let right_places = rules.sample_at == SampleAt::Own || case.samples < 2;
    let mut samples = Vec::new();
    for y in 0..case.height as i32 {
        let outlines = &outlines;
        let count = case.faces.len();
        let covers = move |x: i32| {
            let listed = (0..count).filter(move |&index| rules.listed.has(index, count));
            listed.filter(move |&index| outlines[index].covers((x, y), rules))
        };
        let line = line_spans::stacks(case, rules, y, &covers);
        for x in 0..case.width as i32 {
            let moved = (!right_places).then(|| asked_elsewhere(case, rules, (x, y)));
            let stack = match (&moved, &line) {
                (Some(rules), _) => {
                    let covering = (0..case.faces.len()).filter(|&index| outlines[index].covers((x, y), rules));
                    Stack::of(case, rules, (x, y), covering)
                }
                (None, Some(stacks)) => stacks[x as usize].clone(),
                (None, None) => Stack::of(case, rules, (x, y), covers(x)),
            };
            let rules = moved.as_ref().unwrap_or(rules);
            let color = |index: usize| {
                let color = face_color(case, index, &corner_values[index], rules, (x, y));
                rules.face_tone.of(rules.face_channels.map(|channel| color[channel]))
            };
            samples.push(stack.shown(case, rules, empty(case, rules), color));
        }
    }
    samples
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

/// What covers one sample.
#[derive(Clone, Default)]
pub(super) struct Stack {
    /// Face, depth, and whether it was in front of what was opaque when its turn came; in list order.
    layers: Vec<(usize, f64, bool)>,
    /// The opaque face that keeps the sample.
    pub front: Option<(usize, f64)>,
}

impl Stack {
    pub fn of(case: &Case, rules: &Rules, sample: (i32, i32), covering: impl Iterator<Item = usize>) -> Stack {
        let mut stack = Stack { layers: Vec::new(), front: None };
        for index in covering {
            let face = &case.faces[index];
            let depth = depth(face, rules, (sample, case.samples)).min(rules.capped);
            let wins = match (rules.front, stack.front) {
                (Front::Last, _) => true,
                (Front::First, front) => front.is_none(),
                (Front::Nearest, None) => depth > rules.clear && depth < rules.limit,
                (Front::Farthest, None) => true,
                (Front::Nearest, Some((_, old))) => {
                    (depth > old + rules.margin && depth < rules.limit) || (rules.later_wins_ties && depth == old)
                }
                (Front::Farthest, Some((_, old))) => depth < old,
            };
            stack.layers.push((index, depth, wins));
            let is_clear = face.opacity < 1.0 && rules.blending != Blending::Ignored;
            if wins && (!is_clear || rules.blending == Blending::AtOnceKept) {
                stack.front = Some((index, depth));
            }
        }
        stack
    }

    /// What is there when each face is mixed with what was drawn before it.
    fn at_once(&self, case: &Case, empty: [f64; 3], color: impl Fn(usize) -> [f64; 3]) -> [f64; 3] {
        self.layers.iter().filter(|&&(.., wins)| wins).fold(empty, |shown, &(index, ..)| {
            let (own, opacity) = (color(index), case.faces[index].opacity);
            [0, 1, 2].map(|channel| own[channel] * opacity + shown[channel] * (1.0 - opacity))
        })
    }

    fn shown(&self, case: &Case, rules: &Rules, empty: Sample, color: impl Fn(usize) -> [f64; 3]) -> Sample {
        if matches!(rules.blending, Blending::AtOnce | Blending::AtOnceKept) {
            let color = self.at_once(case, empty.color, color);
            return Sample { color, front: self.front.map(|(index, _)| index), disputed: self.is_disputed(case) };
        }
        let mut shown = self.front.map_or(empty.color, |(index, _)| color(index));
        let behind = self.front.map_or(f64::NEG_INFINITY, |(_, depth)| depth);
        let is_clear = |&&(index, depth, wins): &&(usize, f64, bool)| {
            case.faces[index].opacity < 1.0 && (rules.blending == Blending::Everywhere || (wins && depth > behind))
        };
        let mut clear: Vec<_> = self.layers.iter().filter(is_clear).collect();
        match rules.blending {
            Blending::Ignored | Blending::Invisible | Blending::AtOnce | Blending::AtOnceKept => clear.clear(),
            // A stable sort keeps ties in list order; the farthest is blended first.
            Blending::Over | Blending::Swapped => {
                clear.sort_by(|a, b| b.1.total_cmp(&a.1));
                clear.reverse();
            }
            Blending::ListOrder | Blending::Everywhere => {}
        }
        for &&(index, ..) in &clear {
            let opacity = case.faces[index].opacity;
            let opacity = if rules.blending == Blending::Swapped { 1.0 - opacity } else { opacity };
            let own = color(index);
            shown = [0, 1, 2].map(|channel| own[channel] * opacity + shown[channel] * (1.0 - opacity));
        }
        Sample { color: shown, front: self.front.map(|(index, _)| index), disputed: self.is_disputed(case) }
    }

    /// Whether a slanted face is as near as the front one, but for rounding.
    fn is_disputed(&self, case: &Case) -> bool {
        let slanted = |index: usize| case.faces[index].inverse_w[..2] != [0.0, 0.0];
        let Some((front, depth)) = self.front else { return false };
        self.layers.iter().any(|&(index, other, _)| {
            index != front
                && (slanted(index) || slanted(front))
                && case.faces[index].inverse_w != case.faces[front].inverse_w
                && (depth - other).abs() <= DEPTH_BAND * depth.abs()
        })
    }
}

fn point((x, y): (i32, i32), rules: &Rules) -> (f64, f64) {
    (f64::from(x) + rules.value_at.0, f64::from(y) + rules.value_at.1)
}

/// Depth at a sample, where `samples` of them are the side of a pixel.
fn depth(face: &Face, rules: &Rules, (sample, samples): ((i32, i32), u32)) -> f64 {
    let depths = || face.corners.iter().map(|&corner| face.inverse_w_at(corner));
    let clamped = |depth: f64| {
        let (least, most) = (depths().fold(f64::INFINITY, f64::min), depths().fold(0.0, f64::max));
        depth.clamp(least, most)
    };
    if rules.depth_at != SampleAt::Own && samples > 1 {
        return clamped(face.inverse_w_at(pixels::place(sample, samples as i32, rules.depth_at)));
    }
    match rules.depth {
        DepthFrom::Plane if rules.clamps => clamped(face.inverse_w_at(point(sample, rules))),
        DepthFrom::Plane => face.inverse_w_at(point(sample, rules)),
        DepthFrom::FirstCorner => face.inverse_w_at(face.corners[0]),
        DepthFrom::NearestCorner => depths().fold(0.0, f64::max),
        DepthFrom::MeanCorner => depths().sum::<f64>() / face.corners.len() as f64,
        DepthFrom::Steps(steps) => (face.inverse_w_at(point(sample, rules)) * steps).floor() / steps,
        DepthFrom::RoundSteps(steps) => (face.inverse_w_at(point(sample, rules)) * steps).round() / steps,
        DepthFrom::Whole => face.inverse_w_at(point(sample, rules)).floor(),
        // What faces the viewer has one depth, to the last digit.
        DepthFrom::LinearW if face.inverse_w[..2] == [0.0, 0.0] => face.inverse_w[2],
        DepthFrom::LinearW => {
            let weights = values::weights(face, point(sample, rules));
            1.0 / (0..3).map(|corner| weights[corner] / face.inverse_w_at(face.corners[corner])).sum::<f64>()
        }
        DepthFrom::Runs(rule) => runs::depth(face, rule, point(sample, rules)),
    }
}

fn face_color(case: &Case, index: usize, corners: &Corners, rules: &Rules, sample: (i32, i32)) -> [f64; 3] {
    let (face, at) = (&case.faces[index], point(sample, rules));
    if let Some(lamp) = &case.lamp {
        return lighting::light((case, lamp), (face, corners), rules, at);
    }
    // One color is one color, whatever the weights; a divided or multiplied one is not.
    if corners.is_flat && (keeps_flat(rules.values) || rules.spares_constants) {
        return corners.values[0];
    }
    values::interpolated(face, corners, rules, at)
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
fn pixel(samples: &[Sample], rules: &Rules, mixed: Option<[f64; 3]>) -> ([u8; 3], [u8; 3]) {
    let side = (samples.len() as f64).sqrt() as usize;
    let shown: Vec<pixels::Shown> = samples.iter().map(|sample| (sample.color, sample.front)).collect();
    let color = mixed.unwrap_or_else(|| pixels::light(&shown, side, rules.pixel));
    let color = rules.tone.of(rules.channels.map(|channel| color[channel]));
    (
        color.map(|light| level(light, -LEVEL_BAND, rules.levels)),
        color.map(|light| level(light, LEVEL_BAND, rules.levels)),
    )
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
