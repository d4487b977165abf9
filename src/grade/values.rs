//! Values: how red, green, blue (or a normal) get from the corners of a face to a point, right or with one mistake.
//!
//! By the contract value / w and 1/w are planes on the screen, and a value is their quotient. What goes along edges first and then
//! along scan lines is in [`super::runs`].

use super::case::Face;
use super::covered::cross;
use super::rules::{Carried, Divisor, Interpolation, OverW, Rules};
use super::runs;

type Point = (f64, f64);

/// What the first three corners hold after mistakes in carrying it there.
pub(super) struct Corners {
    pub values: [[f64; 3]; 3],
    /// 1/w that goes with the values.
    pub inverse_w: [f64; 3],
    /// Whether the values are the same all over the face.
    pub is_flat: bool,
}

impl Corners {
    pub fn of(face: &Face, rules: &Rules) -> Corners {
        let order = order(face, rules.carried);
        let value = |corner: usize| face.values_at(face.corners[corner]);
        let inverse_w = |corner: usize| face.inverse_w_at(face.corners[corner]);
        let own = [0, 1, 2].map(inverse_w);
        Corners {
            values: order.map(value),
            inverse_w: if rules.over_w == OverW::Stays { own } else { order.map(inverse_w) },
            is_flat: face.is_flat(),
        }
    }
}

/// Whose values the first three corners get.
fn order(face: &Face, carried: Carried) -> [usize; 3] {
    let [a, b, c] = [face.corners[0], face.corners[1], face.corners[2]];
    let is_clockwise = cross(a, b, c) > 0.0;
    let turned = |right: [usize; 3], left: [usize; 3]| if is_clockwise { right } else { left };
    match carried {
        Carried::Right => [0, 1, 2],
        Carried::Rotated => [1, 2, 0],
        Carried::RotatedBack => [2, 0, 1],
        Carried::LastTwoSwapped => [0, 2, 1],
        Carried::FirstTwoSwapped => [1, 0, 2],
        Carried::OuterSwapped => [2, 1, 0],
        Carried::TurnedRight => turned([1, 2, 0], [2, 0, 1]),
        Carried::TurnedLeft => turned([2, 0, 1], [1, 2, 0]),
        Carried::FirstTwoByTurn => turned([1, 0, 2], [2, 1, 0]),
        Carried::OuterByTurn => turned([2, 1, 0], [1, 0, 2]),
        Carried::Clockwise(swapped) => turned(swapped, [0, 1, 2]),
        Carried::CounterClockwise(swapped) => turned([0, 1, 2], swapped),
        Carried::SortedByY => sorted([a.1, b.1, c.1]),
        Carried::SortedByYDown => sorted([-a.1, -b.1, -c.1]),
        Carried::SortedByX => sorted([a.0, b.0, c.0]),
    }
}

/// Which values the corners get when corners are sorted and values are not.
fn sorted(keys: [f64; 3]) -> [usize; 3] {
    let mut sorted = [0, 1, 2];
    sorted.sort_by(|&a: &usize, &b: &usize| keys[a].total_cmp(&keys[b]));
    // The corner that stands at position p after sorting gets the value of input p.
    let mut order = [0; 3];
    for (position, corner) in sorted.into_iter().enumerate() {
        order[corner] = position;
    }
    order
}

/// Weights of the first three corners at a point of the screen.
pub(super) fn weights(face: &Face, point: Point) -> [f64; 3] {
    let [a, b, c] = [face.corners[0], face.corners[1], face.corners[2]];
    let area = cross(a, b, c);
    if area == 0.0 {
        return [1.0, 0.0, 0.0];
    }
    [cross(b, c, point) / area, cross(c, a, point) / area, cross(a, b, point) / area]
}

/// The sum of three values, each times its weight.
pub(super) fn weighted(weights: &[f64; 3], values: &[[f64; 3]; 3]) -> [f64; 3] {
    [0, 1, 2].map(|number| (0..3).map(|corner| weights[corner] * values[corner][number]).sum())
}

/// The corner with the greatest weight.
pub(super) fn heaviest(face: &Face, at: Point) -> usize {
    let weights = weights(face, at);
    (0..3).fold(0, |best, corner| if weights[corner] > weights[best] { corner } else { best })
}

/// The corner nearest to the eye.
pub(super) fn nearest(face: &Face) -> usize {
    let depth = |corner: usize| face.inverse_w_at(face.corners[corner]);
    (0..3).fold(0, |best, corner| if depth(corner) > depth(best) { corner } else { best })
}

/// The middle of the first three corners.
pub(super) fn middle(face: &Face) -> Point {
    let sum = |pick: fn(&Point) -> f64| face.corners[..3].iter().map(pick).sum::<f64>() / 3.0;
    (sum(|corner| corner.0), sum(|corner| corner.1))
}

/// The corner that is closest on the screen.
fn closest(face: &Face, at: Point) -> usize {
    let far = |corner: usize| {
        let (dx, dy) = (face.corners[corner].0 - at.0, face.corners[corner].1 - at.1);
        dx * dx + dy * dy
    };
    (0..3).fold(0, |best, corner| if far(corner) < far(best) { corner } else { best })
}

/// The face's values at a point; where `kept` is given, it is what value / w is divided by.
pub(super) fn interpolated(
    face: &Face,
    corners: &Corners,
    rules: &Rules,
    (at, kept): (Point, Option<f64>),
) -> [f64; 3] {
    let mut values = spread(face, corners, rules, (at, kept));
    for (number, value) in values.iter_mut().enumerate() {
        let all = [0, 1, 2].map(|corner| corners.values[corner][number]);
        let (low, high) = limits(all);
        if rules.spares_exact && low == high {
            *value = low;
            continue;
        }
        if rules.spares_constants && high - low < 1e-12 {
            *value = low;
        } else if rules.clamps {
            *value = value.clamp(low, high);
        }
    }
    values
}

pub(super) fn limits([a, b, c]: [f64; 3]) -> (f64, f64) {
    (a.min(b).min(c), a.max(b).max(c))
}

fn spread(face: &Face, corners: &Corners, rules: &Rules, (at, kept): (Point, Option<f64>)) -> [f64; 3] {
    let values = &corners.values;
    let weights = weights(face, at);
    let times = |numbers: [f64; 3], factor: f64| numbers.map(|number| number * factor);
    let weighed = |factor: &dyn Fn(usize) -> f64| [0, 1, 2].map(|corner| weights[corner] * factor(corner));
    let over_w = || weighted(&weighed(&|corner| corners.inverse_w[corner]), values);
    let here = match rules.over_w {
        OverW::WithDivisor => weighed(&|corner| corners.inverse_w[corner]).iter().sum(),
        _ if rules.clamps => {
            let (low, high) = limits([0, 1, 2].map(|corner| face.inverse_w_at(face.corners[corner])));
            face.inverse_w_at(at).clamp(low, high)
        }
        _ => face.inverse_w_at(at),
    };
    let here = kept.unwrap_or(here);
    match rules.values {
        Interpolation::Perspective => times(over_w(), 1.0 / here),
        Interpolation::Affine => weighted(&weights, values),
        Interpolation::NotMultipliedBack => over_w(),
        Interpolation::MultipliedTwice => times(over_w(), 1.0 / (here * here)),
        Interpolation::TimesDepth => times(over_w(), here),
        Interpolation::AffineDivided => times(weighted(&weights, values), 1.0 / here),
        Interpolation::AffineTimes => times(weighted(&weights, values), here),
        Interpolation::DividedBy(divisor) => times(over_w(), 1.0 / self::divisor(face, &weights, divisor)),
        Interpolation::ByW => {
            let by_w = weighed(&|corner| 1.0 / corners.inverse_w[corner]);
            times(weighted(&by_w, values), 1.0 / by_w.iter().sum::<f64>())
        }
        Interpolation::LimitsOnOverW => {
            let over = over_w();
            [0, 1, 2].map(|number| {
                let (low, high) = limits([0, 1, 2].map(|corner| values[corner][number]));
                over[number].clamp(low, high) / here
            })
        }
        Interpolation::Without(corner) => {
            let mut kept = weighed(&|corner| corners.inverse_w[corner]);
            kept[corner] = 0.0;
            times(weighted(&kept, values), 1.0 / here)
        }
        Interpolation::Times(factor) => times(over_w(), factor / here),
        Interpolation::WithoutX | Interpolation::WithoutY => {
            let fixed = if rules.values == Interpolation::WithoutX { (0.0, at.1) } else { (at.0, 0.0) };
            let there = self::weights(face, fixed);
            let over = [0, 1, 2].map(|corner| there[corner] * corners.inverse_w[corner]);
            times(weighted(&over, values), 1.0 / here)
        }
        Interpolation::Distances => {
            let far = |corner: usize| {
                let (x, y) = face.corners[corner];
                ((x - at.0) * (x - at.0) + (y - at.1) * (y - at.1)).sqrt().max(1e-9)
            };
            let near = [0, 1, 2].map(|corner| 1.0 / far(corner));
            times(weighted(&near, values), 1.0 / near.iter().sum::<f64>())
        }
        Interpolation::Corner(corner) => values[corner],
        Interpolation::NearestToEye => values[nearest(face)],
        Interpolation::Least => [0, 1, 2].map(|number| limits([0, 1, 2].map(|corner| values[corner][number])).0),
        Interpolation::Greatest => [0, 1, 2].map(|number| limits([0, 1, 2].map(|corner| values[corner][number])).1),
        Interpolation::Mean => times(weighted(&[1.0; 3], values), 1.0 / 3.0),
        Interpolation::Middle => face.values_at(middle(face)),
        Interpolation::Heaviest => values[heaviest(face, at)],
        Interpolation::Closest => values[closest(face, at)],
        Interpolation::Runs(rule) => runs::values(face, corners, rule, at),
        Interpolation::Summed(rule) => [0, 1, 2].map(|number| rule.at(face, at, |at| face.values_at(at)[number])),
        Interpolation::SummedOverW(rule) => {
            let over = |number: usize, at: Point| face.values_at(at)[number] * face.inverse_w_at(at);
            [0, 1, 2].map(|number| rule.at(face, at, |at| over(number, at)) / here)
        }
    }
}

fn divisor(face: &Face, weights: &[f64; 3], divisor: Divisor) -> f64 {
    let [a, b, c] = [0, 1, 2].map(|corner| face.inverse_w_at(face.corners[corner]));
    match divisor {
        Divisor::Corner(corner) => [a, b, c][corner],
        Divisor::Nearest => limits([a, b, c]).1,
        Divisor::Farthest => limits([a, b, c]).0,
        Divisor::Mean => (a + b + c) / 3.0,
        // w itself drawn out straight.
        Divisor::LinearW => 1.0 / (weights[0] / a + weights[1] / b + weights[2] / c),
    }
}
