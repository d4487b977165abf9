//! Filter: what a picture shows at one place, seen at one size.
//!
//! Pyramid, (u, v), level of detail -> SAMPLE -> light and alpha
//!
//! Everything is a function of its arguments alone, in single precision and in a fixed order of operations: who asks first and in
//! which tile must not matter.
//!
//! Cost: 4 texels bilinear, 8 trilinear.

use super::mips::{Level, Pyramid};
use crate::color::Rgb;

/// How texels become a value between them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Filter {
    /// The texel that the place is in, of the picture itself.
    Nearest,
    /// Linear between the four around it, of the picture itself.
    Bilinear,
    /// Bilinear in the two levels around the size, linear between them.
    Trilinear,
}

/// How a picture goes on beyond its edges.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Wrap {
    /// It begins again.
    #[default]
    Repeat,
    /// Its outermost texels go on.
    Clamp,
}

/// What a lookup finds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Linear light, not multiplied by alpha.
    pub color: Rgb<f32>,
    /// 1 is there, 0 is not.
    pub alpha: f32,
}

/// The texels around a place, and their weights.
pub(super) struct Taps {
    indices: [usize; 4],
    weights: [f32; 4],
}

impl Wrap {
    /// A column or row, wherever it lies, as one of `count`.
    #[inline]
    pub(super) fn index(self, index: i64, count: usize) -> usize {
        match self {
            // Nearly all are inside already.
            _ if (0..count as i64).contains(&index) => index as usize,
            Wrap::Repeat => index.rem_euclid(count as i64) as usize,
            Wrap::Clamp => index.clamp(0, count as i64 - 1) as usize,
        }
    }

    /// Texels of two columns and two rows, whose first are these, row by row.
    #[inline]
    fn square(self, [left, low]: [i64; 2], [width, height]: [usize; 2]) -> [usize; 4] {
        // Most lie in the picture as a whole.
        if (0..width as i64 - 1).contains(&left) && (0..height as i64 - 1).contains(&low) {
            let first = low as usize * width + left as usize;
            return [first, first + 1, first + width, first + width + 1];
        }
        let columns = [left, left + 1].map(|column| self.index(column, width));
        let rows = [low, low + 1].map(|row| self.index(row, height) * width);
        [rows[0] + columns[0], rows[0] + columns[1], rows[1] + columns[0], rows[1] + columns[1]]
    }

    /// A coordinate, wherever it lies, as one from 0 to 1.
    #[inline]
    fn coordinate(self, along: f64) -> f32 {
        (match self {
            // Nearly all are inside already.
            _ if (0.0..1.0).contains(&along) => along,
            Wrap::Repeat => along - floor(along),
            Wrap::Clamp => along.clamp(0.0, 1.0),
        }) as f32
    }

    #[inline]
    pub(super) fn coordinates(self, [u, v]: [f64; 2]) -> [f32; 2] {
        [self.coordinate(u), self.coordinate(v)]
    }

    /// Which of `width` x `height` cells over 0 to 1 a place is in, row by row.
    #[inline]
    pub(super) fn cell(self, place: [f64; 2], (width, height): (u32, u32)) -> usize {
        let [u, v] = self.coordinates(place);
        let column = (u * width as f32).min(width as f32 - 1.0) as usize;
        let row = (v * height as f32).min(height as f32 - 1.0) as usize;
        row * width as usize + column
    }
}

impl Taps {
    /// The four texels around (u, v), from 0 to 1, in a picture of `size`.
    #[inline]
    pub fn bilinear([u, v]: [f32; 2], (width, height): (u32, u32), wrap: Wrap) -> Taps {
        let (x, y) = (u * width as f32 - 0.5, v * height as f32 - 0.5);
        let (left, low) = (floor(f64::from(x)) as f32, floor(f64::from(y)) as f32);
        let (fx, fy) = (x - left, y - low);
        Taps {
            indices: wrap.square([left as i64, low as i64], [width as usize, height as usize]),
            weights: [(1.0 - fx) * (1.0 - fy), fx * (1.0 - fy), (1.0 - fx) * fy, fx * fy],
        }
    }

    /// The weighted sum of what is `at` each texel.
    #[inline]
    pub fn sum(&self, at: impl Fn(usize) -> f32) -> f32 {
        let [a, b, c, d] = self.indices.map(at);
        let [wa, wb, wc, wd] = self.weights;
        (a * wa + b * wb) + (c * wc + d * wd)
    }
}

impl Pyramid {
    /// What the picture shows at (u, v) to a sample 2^`level` texels wide.
    #[must_use]
    pub fn sample(&self, place: [f64; 2], level: f32, filter: Filter) -> Sample {
        if filter == Filter::Nearest {
            return self.texel(place);
        }
        let (first, second) = self.taps(place, level, filter);
        let alpha = mixed(&first, second.as_ref(), alpha_at);
        let channel = |channel: usize| {
            mixed(&first, second.as_ref(), |level, index| {
                let light = self.light[usize::from(level.rgba[index][channel])];
                if self.weighed { light * alpha_at(level, index) } else { light }
            })
        };
        self.mean(Rgb::new(channel(0), channel(1), channel(2)), alpha)
    }

    /// The texel of the picture itself that (u, v) is in.
    #[inline]
    fn texel(&self, place: [f64; 2]) -> Sample {
        let (level, index) = self.nearest(place);
        let ([red, green, blue, _], alpha) = (level.rgba[index], alpha_at(level, index));
        let light = Rgb::new(red, green, blue).map(|level| self.light[usize::from(level)]);
        self.mean(if self.weighed { light * alpha } else { light }, alpha)
    }

    #[inline]
    fn nearest(&self, place: [f64; 2]) -> (&Level, usize) {
        let level = &self.levels[0];
        (level, self.wrap.cell(place, (level.width, level.height)))
    }

    /// What shows, of a mean of light (times alpha where lookups weigh by it) and of alpha in 255ths.
    #[inline]
    fn mean(&self, light: Rgb<f32>, alpha: f32) -> Sample {
        let color = match (self.weighed, alpha > 0.0) {
            (false, _) => light,
            // Both in 255ths.
            (true, true) => light.map(|channel| channel / alpha),
            (true, false) => Rgb::gray(0.0),
        };
        Sample { color, alpha: alpha / 255.0 }
    }

    /// The alpha of [`Pyramid::sample`] alone, to the last bit.
    #[must_use]
    pub fn alpha(&self, place: [f64; 2], level: f32, filter: Filter) -> f32 {
        if filter == Filter::Nearest {
            let (level, index) = self.nearest(place);
            return alpha_at(level, index) / 255.0;
        }
        let (first, second) = self.taps(place, level, filter);
        mixed(&first, second.as_ref(), alpha_at) / 255.0
    }

    /// Texels of one level, or of two, the second with its share.
    #[inline]
    fn taps(&self, place: [f64; 2], level: f32, filter: Filter) -> (Tapped<'_>, Option<(Tapped<'_>, f32)>) {
        let last = self.levels.len() - 1;
        let place = self.wrap.coordinates(place);
        let of = |index: usize| {
            let level = &self.levels[index];
            (level, Taps::bilinear(place, (level.width, level.height), self.wrap))
        };
        if filter != Filter::Trilinear || level <= 0.0 {
            return (of(0), None);
        }
        let level = level.min(last as f32);
        let below = level as usize;
        let share = level - below as f32;
        (of(below), (share > 0.0).then(|| (of(below + 1), share)))
    }
}

/// The greatest whole number that is not greater, without the call that `f64::floor` is on processors that every program runs on.
#[inline]
fn floor(number: f64) -> f64 {
    /// From here on all numbers are whole.
    const WHOLE: f64 = (1_u64 << 52) as f64;
    if number.abs() < WHOLE {
        let toward_zero = number as i64 as f64;
        if toward_zero > number { toward_zero - 1.0 } else { toward_zero }
    } else {
        number.floor()
    }
}

/// Alpha of a texel in 255ths: one division a lookup is enough.
#[inline]
fn alpha_at(level: &Level, index: usize) -> f32 {
    f32::from(level.rgba[index][3])
}

type Tapped<'a> = (&'a Level, Taps);

/// A value from one level, or between those of two.
#[inline]
fn mixed((level, taps): &Tapped<'_>, second: Option<&(Tapped<'_>, f32)>, value: impl Fn(&Level, usize) -> f32) -> f32 {
    let first = taps.sum(|index| value(level, index));
    match second {
        None => first,
        Some(((level, taps), share)) => first * (1.0 - share) + taps.sum(|index| value(level, index)) * share,
    }
}

/// The level at which a sample is one texel wide: log2 of its width in texels of level 0.
///
/// `slopes`: change of (u, v) to the next sample on the right, and to the next below; the longer of the two counts.
/// The logarithm is linear between powers of two: at most 0.043 levels off, continuous, and the same on every machine.
#[must_use]
#[inline]
pub fn level_of_detail(slopes: [[f32; 2]; 2], (width, height): (u32, u32)) -> f32 {
    let squared = slopes.map(|[du, dv]| {
        let (x, y) = (du * width as f32, dv * height as f32);
        x * x + y * y
    });
    let longest = squared[0].max(squared[1]);
    // Nothing varies, or nothing is known: the picture itself.
    if longest.is_nan() || longest <= f32::MIN_POSITIVE {
        return 0.0;
    }
    // The bits of a float are its logarithm, nearly.
    let log2 = (longest.to_bits() as i32 - 1.0_f32.to_bits() as i32) as f32 / (1 << 23) as f32;
    0.5 * log2
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::Encoding;
    use crate::image::textures::{Alpha, FirstRow, Texels};

    fn gray(width: u32, height: u32, levels: &[u8], wrap: Wrap) -> Pyramid {
        let rgba = levels.iter().map(|&level| [level, level, level, 255]).collect();
        let texels = Texels::new(width, height, rgba, FirstRow::AtV0).expect("a picture");
        Pyramid::new(&texels, Encoding::Linear, Alpha::Ignored, wrap)
    }

    /// The level in 255ths.
    fn look(pyramid: &Pyramid, u: f64, v: f64, level: f32, filter: Filter) -> f32 {
        pyramid.sample([u, v], level, filter).color.r * 255.0
    }

    #[test]
    fn centers_of_texels_show_the_texel_itself() {
        let levels: Vec<u8> = (0..32).map(|index| index * 8 + 3).collect();
        for wrap in [Wrap::Repeat, Wrap::Clamp] {
            let pyramid = gray(8, 4, &levels, wrap);
            for (index, &level) in levels.iter().enumerate() {
                let (u, v) = ((index % 8) as f64 / 8.0 + 0.0625, (index / 8) as f64 / 4.0 + 0.125);
                for filter in [Filter::Nearest, Filter::Bilinear, Filter::Trilinear] {
                    let light = f32::from(level) / 255.0;
                    assert_eq!(pyramid.sample([u, v], 0.0, filter), Sample { color: Rgb::gray(light), alpha: 1.0 });
                }
            }
        }
    }

    #[test]
    fn between_texels_and_levels_values_run_linearly() {
        let pyramid = gray(4, 1, &[0, 40, 80, 120], Wrap::Clamp);
        assert!((look(&pyramid, 0.25, 0.5, 0.0, Filter::Bilinear) - 20.0).abs() < 1e-4);
        assert!((look(&pyramid, 0.1875, 0.3, 0.0, Filter::Bilinear) - 10.0).abs() < 1e-4);
        assert_eq!(look(&pyramid, 0.2499, 0.5, 9.0, Filter::Nearest), 0.0);
        // Levels by hand: 20 and 100, then 60.
        assert!((look(&pyramid, 0.25, 0.5, 1.0, Filter::Trilinear) - 20.0).abs() < 1e-4);
        assert!((look(&pyramid, 0.25, 0.5, 2.0, Filter::Trilinear) - 60.0).abs() < 1e-4);
        assert!((look(&pyramid, 0.25, 0.5, 1.5, Filter::Trilinear) - 40.0).abs() < 1e-4);
        assert!((look(&pyramid, 0.9, 0.5, 77.0, Filter::Trilinear) - 60.0).abs() < 1e-4);
    }

    #[test]
    fn floor_is_that_of_the_language() {
        let whole = [0.0, -0.0, 1.0, -1.0, 7.0, -8.0, 2.0_f64.powi(51), 2.0_f64.powi(52), -2.0_f64.powi(53), 1e300];
        for number in whole.into_iter().flat_map(|number| [number, number + 0.25, number - 0.25, number * 0.999]) {
            assert_eq!(floor(number), number.floor(), "{number}");
            assert_eq!(floor(number.next_up()), number.next_up().floor(), "{number}");
            assert_eq!(floor(number.next_down()), number.next_down().floor(), "{number}");
        }
        assert!(floor(f64::NAN).is_nan());
        assert_eq!(floor(f64::NEG_INFINITY), f64::NEG_INFINITY);
    }

    #[test]
    fn beyond_the_edges() {
        let (repeat, clamp) = (gray(2, 1, &[10, 90], Wrap::Repeat), gray(2, 1, &[10, 90], Wrap::Clamp));
        for (u, repeated, clamped) in
            [(1.25, 10.0, 90.0), (-0.25, 90.0, 10.0), (-7.75, 10.0, 10.0), (1e9 + 0.25, 10.0, 90.0)]
        {
            assert!((look(&repeat, u, 0.5, 0.0, Filter::Bilinear) - repeated).abs() < 1e-4, "{u}");
            assert!((look(&clamp, u, 0.5, 0.0, Filter::Nearest) - clamped).abs() < 1e-4, "{u}");
        }
        // At the seam the first and the last meet.
        assert!((look(&repeat, 0.0, 0.5, 0.0, Filter::Bilinear) - 50.0).abs() < 1e-4);
        for place in [f64::NAN, f64::INFINITY, -1e300] {
            let _ = look(&repeat, place, place, f32::NAN, Filter::Trilinear);
            let _ = look(&clamp, place, place, f32::INFINITY, Filter::Nearest);
        }
    }

    #[test]
    fn the_level_is_the_width_of_a_sample_in_texels() {
        let of = |slopes| level_of_detail(slopes, (64, 32));
        let texel = [1.0 / 64.0, 1.0 / 32.0];
        assert_eq!(of([[texel[0], 0.0], [0.0, texel[1]]]), 0.0);
        assert_eq!(of([[8.0 * texel[0], 0.0], [0.0, texel[1]]]), 3.0);
        assert_eq!(of([[0.0, 0.0], [0.0, 2.0 * texel[1]]]), 1.0);
        assert_eq!(of([[0.25 * texel[0], 0.0], [0.0, 0.0]]), -2.0);
        assert_eq!(of([[0.0; 2]; 2]), 0.0);
        assert_eq!(of([[f32::NAN; 2]; 2]), 0.0);
        for step in 1..400 {
            let width = 0.01 * step as f32;
            let error = of([[width * texel[0], 0.0], [0.0; 2]]) - width.log2();
            assert!((-0.044..1e-5).contains(&error), "{width}: {error}");
        }
    }
}
