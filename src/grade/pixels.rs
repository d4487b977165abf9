//! Pixels: how the samples of a pixel become its light, right (their mean) or with one mistake.
//!
//! With one sample a pixel there is nothing to be done; most programs do nothing wrong there, some the same as ever.

use super::rules::{Count, Part, PixelFrom, SampleAt};
use crate::math::pow;

type Color = [f64; 3];

/// Where sample (x, y) of blocks of `side` is asked for, in samples.
pub(super) fn place((x, y): (i32, i32), side: i32, rule: SampleAt) -> (f64, f64) {
    let own = |s: i32| f64::from(s) + 0.5;
    let block = |s: i32| f64::from(s.div_euclid(side) * side);
    let (half, whole) = (f64::from(side) / 2.0, f64::from(side));
    let spread = |s: i32, factor: f64| block(s) + half + (f64::from(s.rem_euclid(side)) + 0.5 - half) * factor;
    match rule {
        SampleAt::Own => (own(x), own(y)),
        SampleAt::Block(part) => (block(x) + part * whole, block(y) + part * whole),
        SampleAt::BlockX(part) => (block(x) + part * whole, own(y)),
        SampleAt::BlockY(part) => (own(x), block(y) + part * whole),
        SampleAt::Spread(factor) => (spread(x, factor), spread(y, factor)),
        SampleAt::SpreadX(factor) => (spread(x, factor), own(y)),
        SampleAt::SpreadY(factor) => (own(x), spread(y, factor)),
        SampleAt::FromCorner(factor) => {
            let near = |s: i32| block(s) + (f64::from(s.rem_euclid(side)) + 0.5) * factor;
            (near(x), near(y))
        }
    }
}

/// A sample: its light, and the face that is in front.
pub(super) type Shown = (Color, Option<usize>);

/// The light of a pixel of `side` x `side` samples, in rows; the rule holds for one sample a pixel, or not.
pub(super) fn light(samples: &[Shown], side: usize, (rule, of_one): (PixelFrom, bool)) -> Color {
    let all = || samples.iter().map(|sample| sample.0);
    let count = samples.len() as f64;
    match rule {
        _ if side < 2 && !of_one => samples[0].0,
        PixelFrom::Mean => sum(all()).map(|light| light / count),
        PixelFrom::Divided(by) => sum(all()).map(|light| light / divisor(by, side)),
        PixelFrom::Times(factor) => sum(all()).map(|light| light * factor / count),
        PixelFrom::One(column, row) => samples[place_of(row, side) * side + place_of(column, side)].0,
        PixelFrom::Part(part, by) => {
            let kept = (0..samples.len()).filter(|&at| is_in(part, at % side, at / side, side));
            let number = kept.clone().count() as f64;
            let divisor = if by == Count::Kept { number } else { divisor(by, side) };
            sum(kept.map(|at| samples[at].0)).map(|light| light / divisor)
        }
        PixelFrom::Covered => {
            let covered = samples.iter().filter(|sample| sample.1.is_some());
            let number = covered.clone().count() as f64;
            if number == 0.0 { samples[0].0 } else { sum(covered.map(|sample| sample.0)).map(|light| light / number) }
        }
        PixelFrom::CoveredOfAll => {
            let covered = samples.iter().filter(|sample| sample.1.is_some());
            // A pixel that nobody covers shows what is behind.
            if covered.clone().count() == 0 {
                samples[0].0
            } else {
                sum(covered.map(|sample| sample.0)).map(|light| light / count)
            }
        }
        PixelFrom::Threshold(part) => most_or_nothing(samples, part),
        PixelFrom::FirstCovered => samples.iter().find(|sample| sample.1.is_some()).unwrap_or(&samples[0]).0,
        PixelFrom::LastCovered => samples.iter().rfind(|sample| sample.1.is_some()).unwrap_or(&samples[0]).0,
        PixelFrom::Most => all().fold([0.0; 3], |most, color| each(most, color, f64::max)),
        PixelFrom::Least => all().fold([1.0; 3], |least, color| each(least, color, f64::min)),
        PixelFrom::Extremes => {
            let most = all().fold([0.0; 3], |most, color| each(most, color, f64::max));
            each(most, all().fold([1.0; 3], |least, color| each(least, color, f64::min)), |a, b| (a + b) / 2.0)
        }
        PixelFrom::Median(up) => [0, 1, 2].map(|channel| {
            let mut lights: Vec<f64> = all().map(|color| color[channel]).collect();
            lights.sort_by(f64::total_cmp);
            lights[if up { lights.len() / 2 } else { (lights.len() - 1) / 2 }]
        }),
        PixelFrom::MeanOfPowers(power) => sum(all().map(|color| color.map(|light| pow(light.max(0.0), power))))
            .map(|sum| pow(sum / count, 1.0 / power)),
        PixelFrom::Root(power) => sum(all()).map(|light| pow((light / count).max(0.0), power)),
        PixelFrom::Tent => tent(samples, side),
        PixelFrom::Running(from_first) => {
            let (first, rest) = if from_first { (samples[0].0, &samples[1..]) } else { ([0.0; 3], samples) };
            rest.iter().fold(first, |mean, sample| each(mean, sample.0, |mean, light| (mean + light) / 2.0))
        }
        _ => in_levels(samples, rule),
    }
}

/// What is computed with levels, not with light.
fn in_levels(samples: &[Shown], rule: PixelFrom) -> Color {
    let count = samples.len() as f64;
    let levels = |round: f64| samples.iter().map(move |sample| sample.0.map(|light| (light * 255.0 + round).floor()));
    let mean = match rule {
        PixelFrom::MeanOfLevels(round) => sum(levels(round)).map(|sum| sum / count),
        PixelFrom::LevelsCut(round) => sum(levels(round)).map(|sum| (sum / count).floor()),
        PixelFrom::DividedFirst(round) => sum(levels(round).map(|level| level.map(|level| (level / count).floor()))),
        PixelFrom::DividedTwice(round) => {
            sum(levels(round).map(|level| level.map(|level| (level / count).floor()))).map(|sum| sum / count)
        }
        PixelFrom::SumInByte(round) => sum(levels(round)).map(|sum| sum.rem_euclid(256.0) / count),
        PixelFrom::SumInByteCut(round) => sum(levels(round)).map(|sum| (sum.rem_euclid(256.0) / count).floor()),
        PixelFrom::SumWraps => sum(levels(0.5)).map(|sum| sum.rem_euclid(256.0)),
        PixelFrom::SignedByte => sum(levels(0.5)).map(|sum| ((sum + 128.0).rem_euclid(256.0) - 128.0) / count),
        _ => sum(levels(0.5)),
    };
    mean.map(|level| level / 255.0)
}

fn sum(colors: impl Iterator<Item = Color>) -> Color {
    colors.fold([0.0; 3], |sum, color| each(sum, color, |a, b| a + b))
}

fn each(a: Color, b: Color, with: impl Fn(f64, f64) -> f64) -> Color {
    [0, 1, 2].map(|channel| with(a[channel], b[channel]))
}

/// 0: first, 1: the one left of the middle, 2: the one right of it, 3: last.
fn place_of(kind: u8, side: usize) -> usize {
    [0, (side - 1) / 2, side / 2, side - 1][usize::from(kind.min(3))]
}

fn is_in(part: Part, x: usize, y: usize, side: usize) -> bool {
    let last = side - 1;
    match part {
        Part::Row(kind) => y == place_of(kind, side),
        Part::Column(kind) => x == place_of(kind, side),
        Part::Diagonal => x == y,
        Part::OtherDiagonal => x + y == last,
        Part::Corners => (x == 0 || x == last) && (y == 0 || y == last),
        Part::Ends => (x, y) == (0, 0) || (x, y) == (last, last),
        Part::Square(size) => x < size && y < size,
        Part::WithoutFirst => (x, y) != (0, 0),
        Part::WithoutLast => (x, y) != (last, last),
        Part::WithoutFirstRow => y > 0,
        Part::WithoutLastRow => y < last,
        Part::WithoutFirstColumn => x > 0,
        Part::WithoutLastColumn => x < last,
        Part::WithoutLastBoth => x < last && y < last,
        Part::WithoutFirstBoth => x > 0 && y > 0,
        Part::Checkered => (x + y).is_multiple_of(2),
        Part::FirstHalf => y * side + x < side * side / 2,
        Part::Cross => x == side / 2 || y == side / 2,
    }
}

fn divisor(by: Count, side: usize) -> f64 {
    let side = side as f64;
    match by {
        Count::All | Count::Kept => side * side,
        Count::One => 1.0,
        Count::Side => side,
        Count::SideMore(more) => side + more,
        Count::TwoSides => 2.0 * side,
        Count::AllMore(more) => side * side + more,
        Count::NextSquare => (side + 1.0) * (side + 1.0),
        Count::Fixed(number) => number,
        Count::Cube => side * side * side,
        Count::Fourth => side * side * side * side,
    }
}

/// The face that has more than this part of the samples, or what is behind it.
fn most_or_nothing(samples: &[Shown], (part, or_equal): (f64, bool)) -> Color {
    let hits = samples.iter().filter(|sample| sample.1.is_some()).count() as f64;
    let limit = part * samples.len() as f64;
    let is_hit = hits > limit || (or_equal && hits >= limit && hits > 0.0);
    samples.iter().find(|sample| sample.1.is_some() == is_hit).unwrap_or(&samples[0]).0
}

/// Samples count the more, the nearer they are to the middle.
fn tent(samples: &[Shown], side: usize) -> Color {
    let weight = |at: usize| (at + 1).min(side - at) as f64;
    let (mut color, mut whole) = ([0.0; 3], 0.0);
    for (at, sample) in samples.iter().enumerate() {
        let share = weight(at % side) * weight(at / side);
        whole += share;
        color = each(color, sample.0, |sum, light| sum + light * share);
    }
    color.map(|sum| sum / whole)
}
