//! Stack: what covers one sample, which face keeps it, and what shows through glass.
//!
//! Faces over a sample, [`Rules`] -STACK-> the front one, and the color that is seen
//!
//! Space: samples; depth is 1/w. Cost: the faces over a sample.

use super::case::{Case, Face};
use super::paint::Sample;
use super::pixels;
use super::rules::{Blending, DepthFrom, DepthPoint, Front, Rules, SampleAt};
use super::runs;
use super::values;

/// Part of a depth within which the order of slanted faces is not judged.
const DEPTH_BAND: f64 = 8.0 * f32::EPSILON as f64;

/// What covers one sample.
#[derive(Clone, Default)]
pub(super) struct Stack {
    /// Face, depth, and whether it was in front of what was opaque when its turn came; in list order.
    layers: Vec<(usize, f64, bool)>,
    /// The opaque face that keeps the sample.
    pub front: Option<(usize, f64)>,
    /// The depth that later ones are held against.
    pub kept: Option<f64>,
}

/// Whether a face at `depth` shows, where `kept` is remembered.
pub(super) fn wins(rules: &Rules, kept: Option<f64>, depth: f64) -> bool {
    match (rules.front, kept) {
        (Front::Last, _) | (Front::Farthest | Front::Second, None) => true,
        (Front::First, kept) => kept.is_none(),
        (Front::Nearest, None) => depth > rules.clear && depth < rules.limit,
        (Front::Nearest | Front::Second, Some(old)) => {
            (depth > old + rules.margin && depth < rules.limit) || (rules.later_wins_ties && depth == old)
        }
        (Front::Farthest, Some(old)) => depth < old || (rules.later_wins_ties && depth == old),
    }
}

impl Stack {
    pub fn of(case: &Case, rules: &Rules, sample: (i32, i32), covering: impl Iterator<Item = usize>) -> Stack {
        let mut stack = Stack::default();
        let mut kept = None;
        for index in covering.take(rules.most_at_sample) {
            let face = &case.faces[index];
            let depth = depth(face, rules, (sample, case.samples)).min(rules.capped);
            let wins = wins(rules, kept, depth);
            stack.layers.push((index, depth, wins));
            let is_clear = face.opacity < 1.0 && rules.blending != Blending::Ignored;
            if is_clear && rules.blending == Blending::OverKept {
                kept = rules.kept.after(kept, (depth, wins));
            }
            if is_clear && rules.blending != Blending::AtOnceKept {
                continue;
            }
            if wins {
                stack.front = Some((index, depth));
            }
            kept = rules.kept.after(kept, (depth, wins));
        }
        stack.kept = kept;
        if rules.front == Front::Second {
            stack.keep_second(case);
        }
        stack
    }

    /// A sample that one face shows, of which nothing else is known.
    pub fn of_front(index: usize, depth: f64) -> Stack {
        Stack { layers: vec![(index, depth, true)], front: Some((index, depth)), kept: Some(depth) }
    }

    /// Adds glass that is blended when everything opaque is there.
    pub fn add_glass(&mut self, index: usize, depth: f64) {
        self.layers.push((index, depth, true));
    }

    /// The second nearest opaque face in place of the nearest, where there are two.
    fn keep_second(&mut self, case: &Case) {
        let mut opaque: Vec<(usize, f64)> = Vec::new();
        opaque.extend(
            self.layers.iter().filter(|layer| case.faces[layer.0].opacity >= 1.0).map(|layer| (layer.0, layer.1)),
        );
        opaque.sort_by(|a, b| b.1.total_cmp(&a.1));
        self.front = opaque.get(1).or_else(|| opaque.first()).copied();
        self.kept = self.front.map(|(_, depth)| depth);
    }

    /// What is there when each face is mixed with what was drawn before it.
    fn at_once(&self, case: &Case, rules: &Rules, empty: [f64; 3], color: impl Fn(usize) -> [f64; 3]) -> [f64; 3] {
        let is_tested = rules.blending != Blending::AtOnceUntested;
        let is_mixed =
            |&&(index, _, wins): &&(usize, f64, bool)| wins || (!is_tested && case.faces[index].opacity < 1.0);
        self.layers.iter().filter(is_mixed).fold(empty, |shown, &(index, ..)| {
            let (own, opacity) = (color(index), case.faces[index].opacity);
            rules.mixed.of(own, shown, opacity)
        })
    }

    pub fn shown(&self, case: &Case, rules: &Rules, empty: Sample, color: impl Fn(usize) -> [f64; 3]) -> Sample {
        let is_drawn = !self.layers.is_empty();
        let (front, disputed) = (self.front.map(|(index, _)| index), self.is_disputed(case));
        if matches!(rules.blending, Blending::AtOnce | Blending::AtOnceKept | Blending::AtOnceUntested) {
            let color = self.at_once(case, rules, empty.color, color);
            return Sample { color, front, disputed, is_drawn };
        }
        let mut shown = front.map_or(empty.color, &color);
        for (index, _) in self.glass(case, rules) {
            let opacity = case.faces[index].opacity;
            let opacity = if rules.blending == Blending::Swapped { 1.0 - opacity } else { opacity };
            let own = color(index);
            shown = rules.mixed.of(own, shown, opacity);
        }
        Sample { color: shown, front, disputed, is_drawn }
    }

    /// The glass that is blended over the opaque face, in order.
    fn glass(&self, case: &Case, rules: &Rules) -> Vec<(usize, f64)> {
        let behind = self.kept.unwrap_or(f64::NEG_INFINITY);
        let is_seen = |&&(index, depth, wins): &&(usize, f64, bool)| {
            let is_before = match rules.blending {
                Blending::Everywhere | Blending::EverywhereTurned | Blending::EverywhereSorted => true,
                Blending::AtEnd => depth > behind,
                Blending::Turned => self.kept.is_none_or(|kept| depth < kept),
                Blending::OverKept => wins,
                _ => wins && depth > behind,
            };
            case.faces[index].opacity < 1.0 && is_before
        };
        let mut clear: Vec<_> = self.layers.iter().filter(is_seen).map(|&(index, depth, _)| (index, depth)).collect();
        match rules.blending {
            Blending::Ignored | Blending::Invisible => clear.clear(),
            // A stable sort keeps ties in list order; the farthest is blended first.
            Blending::EverywhereTurned => clear.reverse(),
            Blending::NearestFirst => clear.sort_by(|a, b| b.1.total_cmp(&a.1)),
            Blending::Over | Blending::Swapped | Blending::AtEnd | Blending::EverywhereSorted | Blending::OverKept => {
                clear.sort_by(|a, b| b.1.total_cmp(&a.1));
                clear.reverse();
            }
            Blending::Turned => {
                clear.sort_by(|a, b| a.1.total_cmp(&b.1));
                clear.reverse();
            }
            _ => {}
        }
        clear
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

/// Where depth and values of a sample are taken.
pub(super) fn point((x, y): (i32, i32), rules: &Rules) -> (f64, f64) {
    (f64::from(x) + rules.value_at.0, f64::from(y) + rules.value_at.1)
}

/// Depth at a sample, where `samples` of them are the side of a pixel.
pub(super) fn depth(face: &Face, rules: &Rules, (sample, samples): ((i32, i32), u32)) -> f64 {
    let depths = || face.corners.iter().map(|&corner| face.inverse_w_at(corner));
    let (least, most) = (|| depths().fold(f64::INFINITY, f64::min), || depths().fold(0.0, f64::max));
    let clamped = |depth: f64| depth.clamp(least(), most());
    if rules.depth_at != SampleAt::Own && samples > 1 {
        return clamped(face.inverse_w_at(pixels::place(sample, samples as i32, rules.depth_at)));
    }
    let sample = if rules.block.of_depth { rules.block.of(face, sample) } else { sample };
    let at = rules.depth_origin.of(face, rules.depth_point.of(point(sample, rules)));
    let plane = || {
        if rules.clamps || rules.depth_point != DepthPoint::Own {
            clamped(face.inverse_w_at(at))
        } else {
            face.inverse_w_at(at)
        }
    };
    match rules.depth {
        DepthFrom::Plane => plane(),
        DepthFrom::Corner(number) => face.inverse_w_at(face.corners[number.min(face.corners.len() - 1)]),
        DepthFrom::NearestCorner => most(),
        DepthFrom::FarthestCorner => least(),
        DepthFrom::MeanCorner => depths().sum::<f64>() / face.corners.len() as f64,
        DepthFrom::MeanDistance => face.corners.len() as f64 / depths().map(|depth| 1.0 / depth).sum::<f64>(),
        DepthFrom::Ends => (least() + most()) / 2.0,
        DepthFrom::Steps(steps) => (plane() * steps).floor() / steps,
        DepthFrom::RoundSteps(steps) => (plane() * steps).round() / steps,
        DepthFrom::Wraps(steps, most) => (plane() * steps).floor().rem_euclid(most) / steps,
        // Distances that are cut to 0 are equal, and as near as can be.
        DepthFrom::DistanceSteps(steps) => (steps / (steps / plane()).floor()).min(f64::MAX),
        DepthFrom::AsText(scale) => as_text(scale / plane()),
        DepthFrom::Whole => plane().floor(),
        // What faces the viewer has one depth, to the last digit.
        DepthFrom::LinearW if face.inverse_w[..2] == [0.0, 0.0] => face.inverse_w[2],
        DepthFrom::LinearW => {
            let weights = values::weights(face, at);
            1.0 / (0..3).map(|corner| weights[corner] / face.inverse_w_at(face.corners[corner])).sum::<f64>()
        }
        DepthFrom::Runs(rule) => runs::depth(face, rule, at),
        DepthFrom::Summed(rule) => rule.at(face, at, |at| face.inverse_w_at(at)),
    }
}

/// A number that orders distances as their texts are ordered: 100 before 20.
fn as_text(distance: f64) -> f64 {
    let text = format!("{distance:?}");
    let digit = |number: usize| f64::from(text.as_bytes().get(number).copied().unwrap_or(0));
    // Seven digits of seven bits each.
    2.0_f64.powi(50) - (0..7).fold(0.0, |sum, number| sum * 128.0 + digit(number))
}
