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
use super::lines;
use super::place;
use super::rules::{Blending, Carried, DepthFrom, Front, Interpolation, Levels, PixelFrom, Rules};
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
            let (low, high) = pixel(&all, rules);
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
    let outlines: Vec<Outline> = case.faces.iter().map(|face| Outline::new(&face.corners, rules)).collect();
    let corner_values: Vec<_> = case.faces.iter().map(|face| carried(face, rules.carried)).collect();
    let mut samples = Vec::new();
    for y in 0..case.height as i32 {
        for x in 0..case.width as i32 {
            let covering = (0..case.faces.len()).filter(|&index| outlines[index].covers((x, y), rules));
            let stack = Stack::of(case, rules, (x, y), covering);
            let color = |index: usize| {
                let color = face_color(case, index, &corner_values[index], rules, (x, y));
                rules.face_channels.map(|channel| color[channel])
            };
            samples.push(stack.shown(case, rules, empty(case, rules), color));
        }
    }
    samples
}

/// What covers one sample.
struct Stack {
    /// Face, depth, and whether it was in front of what was opaque when its turn came; in list order.
    layers: Vec<(usize, f64, bool)>,
    /// The opaque face that keeps the sample.
    front: Option<(usize, f64)>,
}

impl Stack {
    fn of(case: &Case, rules: &Rules, sample: (i32, i32), covering: impl Iterator<Item = usize>) -> Stack {
        let mut stack = Stack { layers: Vec::new(), front: None };
        for index in covering {
            let face = &case.faces[index];
            let depth = depth(face, rules, sample);
            let wins = match (rules.front, stack.front) {
                (Front::Last, _) => true,
                (Front::First, front) => front.is_none(),
                (Front::Nearest, None) => depth > rules.clear,
                (Front::Farthest, None) => true,
                (Front::Nearest, Some((_, old))) => depth > old || (rules.later_wins_ties && depth == old),
                (Front::Farthest, Some((_, old))) => depth < old,
            };
            stack.layers.push((index, depth, wins));
            let is_clear = face.opacity < 1.0 && rules.blending != Blending::Ignored;
            if wins && !is_clear {
                stack.front = Some((index, depth));
            }
        }
        stack
    }

    fn shown(&self, case: &Case, rules: &Rules, empty: Sample, color: impl Fn(usize) -> [f64; 3]) -> Sample {
        let mut shown = self.front.map_or(empty.color, |(index, _)| color(index));
        let behind = self.front.map_or(f64::NEG_INFINITY, |(_, depth)| depth);
        let is_clear =
            |&&(index, depth, wins): &&(usize, f64, bool)| wins && case.faces[index].opacity < 1.0 && depth > behind;
        let mut clear: Vec<_> = self.layers.iter().filter(is_clear).collect();
        match rules.blending {
            Blending::Ignored | Blending::Invisible => clear.clear(),
            // A stable sort keeps ties in list order; the farthest is blended first.
            Blending::Over | Blending::Swapped => {
                clear.sort_by(|a, b| b.1.total_cmp(&a.1));
                clear.reverse();
            }
            Blending::ListOrder => {}
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

fn depth(face: &Face, rules: &Rules, sample: (i32, i32)) -> f64 {
    let depths = || face.corners.iter().map(|&corner| face.inverse_w_at(corner));
    match rules.depth {
        DepthFrom::Plane => face.inverse_w_at(point(sample, rules)),
        DepthFrom::FirstCorner => face.inverse_w_at(face.corners[0]),
        DepthFrom::NearestCorner => depths().fold(0.0, f64::max),
        DepthFrom::MeanCorner => depths().sum::<f64>() / face.corners.len() as f64,
        DepthFrom::Whole => face.inverse_w_at(point(sample, rules)).floor(),
        DepthFrom::LinearW => {
            let weights = weights(face, point(sample, rules));
            1.0 / (0..3).map(|corner| weights[corner] / face.inverse_w_at(face.corners[corner])).sum::<f64>()
        }
    }
}

/// The values at the first three corners and at the last, after they were carried.
fn carried(face: &Face, carried: Carried) -> [[f64; 3]; 4] {
    let last = face.corners.len() - 1;
    let value = |corner: usize| face.values_at(face.corners[corner]);
    let order = match carried {
        Carried::Right => [0, 1, 2],
        Carried::Rotated => [1, 2, 0],
        Carried::RotatedBack => [2, 0, 1],
        Carried::LastTwoSwapped => [0, 2, 1],
        Carried::FirstTwoSwapped => [1, 0, 2],
        Carried::OuterSwapped => [2, 1, 0],
        Carried::SortedByY => order_by_y(&face.corners),
    };
    [value(order[0]), value(order[1]), value(order[2]), if last == 2 { value(order[2]) } else { value(last) }]
}

/// Which values the corners get when corners are sorted by y and values are not.
fn order_by_y(corners: &[(f64, f64)]) -> [usize; 3] {
    let mut sorted = [0, 1, 2];
    sorted.sort_by(|&a: &usize, &b: &usize| corners[a].1.total_cmp(&corners[b].1));
    // The corner that stands at position p after sorting gets the value of input p.
    let mut order = [0; 3];
    for (position, corner) in sorted.into_iter().enumerate() {
        order[corner] = position;
    }
    order
}

/// Weights of the first three corners at a point of the screen.
fn weights(face: &Face, point: (f64, f64)) -> [f64; 3] {
    let [a, b, c] = [face.corners[0], face.corners[1], face.corners[2]];
    let cross = super::covered::cross;
    let area = cross(a, b, c);
    if area == 0.0 {
        return [1.0, 0.0, 0.0];
    }
    [cross(b, c, point) / area, cross(c, a, point) / area, cross(a, b, point) / area]
}

fn interpolated(face: &Face, values: &[[f64; 3]; 4], rules: &Rules, at: (f64, f64)) -> [f64; 3] {
    let weights = weights(face, at);
    let sum = |factor: &dyn Fn(usize) -> f64| {
        [0, 1, 2].map(|number| (0..3).map(|corner| weights[corner] * factor(corner) * values[corner][number]).sum())
    };
    let inverse_w = |corner: usize| face.inverse_w_at(face.corners[corner]);
    let times = |numbers: [f64; 3], factor: f64| numbers.map(|number| number * factor);
    let here = face.inverse_w_at(at);
    match rules.values {
        Interpolation::Perspective => times(sum(&inverse_w), 1.0 / here),
        Interpolation::Affine => sum(&|_| 1.0),
        Interpolation::NotMultipliedBack => sum(&inverse_w),
        Interpolation::MultipliedTwice => times(sum(&inverse_w), 1.0 / (here * here)),
        Interpolation::FirstCorner => values[0],
        Interpolation::LastCorner => values[3],
        Interpolation::Mean => [0, 1, 2].map(|number| (0..3).map(|corner| values[corner][number]).sum::<f64>() / 3.0),
        Interpolation::NearestCorner => {
            let heaviest = (0..3).fold(0, |best, corner| if weights[corner] > weights[best] { corner } else { best });
            values[heaviest]
        }
    }
}

fn face_color(case: &Case, index: usize, values: &[[f64; 3]; 4], rules: &Rules, sample: (i32, i32)) -> [f64; 3] {
    let (face, at) = (&case.faces[index], point(sample, rules));
    let Some(lamp) = &case.lamp else {
        // One color is one color, whatever the weights; a carried or divided one is not.
        if face.is_flat() && !matches!(rules.values, Interpolation::NotMultipliedBack | Interpolation::MultipliedTwice)
        {
            return values[0];
        }
        return interpolated(face, values, rules, at);
    };
    let normal = |at: (f64, f64)| interpolated(face, values, rules, at);
    lighting::light(case, face, (lamp, rules), at, normal)
}

/// The least and greatest levels of a pixel.
fn pixel(samples: &[Sample], rules: &Rules) -> ([u8; 3], [u8; 3]) {
    let mean = |value: &dyn Fn(&Sample) -> [f64; 3]| {
        [0, 1, 2].map(|channel| samples.iter().map(|sample| value(sample)[channel]).sum::<f64>() / samples.len() as f64)
    };
    let side = (samples.len() as f64).sqrt() as usize;
    let color = match rules.pixel {
        PixelFrom::Mean => mean(&|sample| sample.color),
        PixelFrom::FirstSample => samples[0].color,
        PixelFrom::MiddleSample => samples[side / 2 * side + side / 2].color,
        PixelFrom::MeanOfLevels => mean(&|sample| sample.color.map(|light| (light * 255.0).floor() / 255.0)),
        PixelFrom::Most => samples
            .iter()
            .fold([0.0; 3], |most: [f64; 3], sample| [0, 1, 2].map(|channel| most[channel].max(sample.color[channel]))),
    };
    let color = rules.channels.map(|channel| color[channel]);
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
        Levels::Squared => (light * light * 255.0 + band).round(),
        Levels::Gamma22 => (pow(light, 1.0 / 2.2) * 255.0 + band).round(),
        Levels::Srgb => {
            let display = if light <= 0.003_130_8 { light * 12.92 } else { 1.055 * pow(light, 1.0 / 2.4) - 0.055 };
            (display * 255.0 + band).round()
        }
    };
    number.clamp(0.0, 255.0) as u8
}
