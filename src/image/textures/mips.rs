//! Mips: a picture and its means, each level half as large.
//!
//! Texels -> levels in light, weighed by alpha -> PYRAMID of 8-bit texels
//!
//! Why means are weighed by alpha: the color of a texel that is not there must not count. A plain mean of a leaf and the black
//! around it is a dark leaf, and wherever alpha lets a little of it through, the tree has a dark rim.
//!
//! Why alpha is scaled for the alpha test: of a twig one texel wide, every level halves the alpha; below the threshold the twig is
//! gone. So each level's alpha is multiplied until as large a share of it passes the test as of level 0.
//! Why not for alpha-to-coverage: there a sample passes with probability alpha, and the plain mean already is the right share.
//!
//! Why 8 bits again: 20 tree pictures of 256 x 256 are 7 MB so, and would be 28 MB in floats.
//!
//! Source: Castano, "Computing Alpha Mipmaps", 2010. Cost: a third more texels; for the alpha test 20 measurements a level.

use super::filter::Wrap;
use super::repair::{coverage, dilate};
use super::{Rgba, Texels};
use crate::color::{Encoding, Rgb};

/// What alpha means to a pyramid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Alpha {
    /// Nothing: all of the picture is there.
    Ignored,
    /// A share: levels keep its mean.
    Mean,
    /// What is above the threshold is there: levels keep the share that is.
    Test(f32),
    /// As [`Alpha::Test`] in the papers of 1999 to 2008: colors of what is not there count, and nothing is kept.
    Paper,
}

/// A picture and its means.
#[derive(Clone, Debug, PartialEq)]
pub struct Pyramid {
    pub(super) levels: Vec<Level>,
    pub(super) wrap: Wrap,
    /// Lookups weigh colors by alpha.
    pub(super) weighed: bool,
    alpha: Alpha,
    encoding: Encoding,
    /// Light of every display value.
    pub(super) light: Box<[f32; 256]>,
}

/// One level; level 0 is the picture itself.
#[derive(Clone, PartialEq)]
pub(super) struct Level {
    pub width: u32,
    pub height: u32,
    pub rgba: Vec<Rgba>,
}

/// A level in numbers: linear light (times alpha, where that counts) and alpha.
struct Numbers {
    width: usize,
    height: usize,
    rgba: Vec<[f32; 4]>,
}

impl Pyramid {
    /// The pyramid of `texels`, whose colors mean what `encoding` says.
    #[must_use]
    pub fn new(texels: &Texels, encoding: Encoding, alpha: Alpha, wrap: Wrap) -> Pyramid {
        let light = Box::new(std::array::from_fn(|level| encoding.decode(Rgb::gray(level as f64 / 255.0)).r as f32));
        let weighed = matches!(alpha, Alpha::Mean | Alpha::Test(_));
        let mut picture = if weighed { dilate(texels, wrap) } else { texels.clone() };
        if alpha == Alpha::Ignored {
            picture.rgba.iter_mut().for_each(|texel| texel[3] = 255);
        }
        let (width, height) = picture.size();
        let first = Level { width, height, rgba: picture.rgba };
        let mut pyramid = Pyramid { levels: vec![first], wrap, weighed, alpha, encoding, light };
        pyramid.add_means();
        pyramid
    }

    /// How many levels there are, the picture itself included.
    #[must_use]
    pub fn level_count(&self) -> usize {
        self.levels.len()
    }

    /// Level `index` as a picture of its own.
    ///
    /// # Panics
    /// If there is no such level.
    #[must_use]
    pub fn level(&self, index: usize) -> Texels {
        let Level { width, height, ref rgba } = self.levels[index];
        Texels { width, height, rgba: rgba.clone() }
    }

    /// Texels across and up.
    #[must_use]
    pub fn size(&self) -> (u32, u32) {
        (self.levels[0].width, self.levels[0].height)
    }

    /// How lookups go on beyond the picture.
    #[must_use]
    pub fn wrap(&self) -> Wrap {
        self.wrap
    }

    /// Whether [`Pyramid::new`] with these would make the same of the same picture.
    #[must_use]
    pub fn is_made_for(&self, encoding: Encoding, alpha: Alpha, wrap: Wrap) -> bool {
        (self.encoding, self.alpha, self.wrap) == (encoding, alpha, wrap)
    }

    fn add_means(&mut self) {
        let mut numbers = self.numbers();
        let test = if let Alpha::Test(threshold) = self.alpha { Some(threshold) } else { None };
        let share = test.map(|threshold| coverage(&self.level(0), threshold, self.wrap));
        while numbers.width > 1 || numbers.height > 1 {
            numbers = numbers.halved();
            let mut level = self.level_of(&numbers);
            if let (Some(threshold), Some(share)) = (test, share) {
                keep_coverage(&mut level, &numbers, (threshold, share), self.wrap);
            }
            self.levels.push(level);
        }
    }

    /// Level 0 in numbers.
    fn numbers(&self) -> Numbers {
        let Level { width, height, rgba } = &self.levels[0];
        let convert = |&[r, g, b, a]: &Rgba| {
            let alpha = f32::from(a) / 255.0;
            let weight = if self.weighed { alpha } else { 1.0 };
            let [r, g, b] = [r, g, b].map(|level| self.light[usize::from(level)] * weight);
            [r, g, b, alpha]
        };
        Numbers { width: *width as usize, height: *height as usize, rgba: rgba.iter().map(convert).collect() }
    }

    /// Numbers as 8-bit texels.
    fn level_of(&self, numbers: &Numbers) -> Level {
        let convert = |&[r, g, b, alpha]: &[f32; 4]| {
            let weight = if self.weighed { alpha } else { 1.0 };
            let share = |light: f32| if weight > 0.0 { light / weight } else { 0.0 };
            let [r, g, b] = [r, g, b].map(|light| self.encoding.level(share(light)));
            [r, g, b, Encoding::Linear.level(alpha)]
        };
        let (width, height) = (numbers.width as u32, numbers.height as u32);
        Level { width, height, rgba: numbers.rgba.iter().map(convert).collect() }
    }
}

impl std::fmt::Debug for Level {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(formatter, "{} x {}", self.width, self.height)
    }
}

impl Numbers {
    /// Half as large each way, rounded down, at least 1; every texel is the mean of the area it covers.
    fn halved(&self) -> Numbers {
        let (width, height) = ((self.width / 2).max(1), (self.height / 2).max(1));
        let mut rgba = Vec::with_capacity(width * height);
        for y in 0..height {
            for x in 0..width {
                let mut sum = [0.0; 4];
                for (row, row_share) in shares(y, height, self.height) {
                    for (column, share) in shares(x, width, self.width) {
                        let texel = self.rgba[row * self.width + column];
                        (0..4).for_each(|channel| sum[channel] += f64::from(texel[channel]) * row_share * share);
                    }
                }
                rgba.push(sum.map(|channel| channel as f32));
            }
        }
        Numbers { width, height, rgba }
    }
}

/// The texels of a row of `from` that texel `index` of a row of `to` covers, with their shares of it; the sum is 1.
fn shares(index: usize, to: usize, from: usize) -> impl Iterator<Item = (usize, f64)> {
    // In units of 1 / to of the larger texels everything is a whole number.
    let (start, end) = (index * from, (index + 1) * from);
    (start / to..end.div_ceil(to)).map(move |texel| {
        let covered = end.min((texel + 1) * to) - start.max(texel * to);
        (texel, covered as f64 / from as f64)
    })
}

/// Multiplies the alpha of `level` until `share` of it is above `threshold`.
fn keep_coverage(level: &mut Level, numbers: &Numbers, (threshold, share): (f32, f64), wrap: Wrap) {
    if !(share > 0.0 && share < 1.0) {
        return;
    }
    let mut tried = Texels { width: level.width, height: level.height, rgba: std::mem::take(&mut level.rgba) };
    let of = |scale: f32, texels: &mut Texels| {
        for (texel, number) in texels.rgba.iter_mut().zip(&numbers.rgba) {
            texel[3] = Encoding::Linear.level(number[3] * scale);
        }
        coverage(texels, threshold, wrap)
    };
    // Coverage grows with the scale: halve the interval, then take the end that is nearer.
    let (mut low, mut high) = (0.0_f32, 64.0_f32);
    for _ in 0..20 {
        let middle = 0.5 * (low + high);
        if of(middle, &mut tried) < share { low = middle } else { high = middle }
    }
    let (below, above) = (share - of(low, &mut tried), of(high, &mut tried) - share);
    let _ = of(if below < above { low } else { high }, &mut tried);
    level.rgba = tried.rgba;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::image::textures::FirstRow;

    fn texels(width: u32, height: u32, texel: impl Fn(u32, u32) -> Rgba) -> Texels {
        let all = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        Texels::new(width, height, all.map(|(x, y)| texel(x, y)).collect(), FirstRow::AtV0).expect("a picture")
    }

    #[test]
    fn a_mean_is_one_of_light() {
        let checkered = texels(2, 2, |x, y| if (x + y) % 2 == 0 { [255, 255, 255, 255] } else { [0, 0, 0, 255] });
        let level = |encoding| Pyramid::new(&checkered, encoding, Alpha::Ignored, Wrap::Repeat).level(1).at(0, 0);
        assert_eq!(level(Encoding::Linear), [128, 128, 128, 255]);
        // Half the light of white is display value 188.
        assert_eq!(level(Encoding::Srgb), [188, 188, 188, 255]);
    }

    #[test]
    fn odd_sizes_share_the_texel_in_the_middle() {
        let row = texels(3, 1, |x, _| [[200, 0, 0, 255], [0, 200, 0, 255], [0, 0, 200, 255]][x as usize]);
        let pyramid = Pyramid::new(&row, Encoding::Linear, Alpha::Ignored, Wrap::Clamp);
        assert_eq!(pyramid.level_count(), 2);
        assert_eq!(pyramid.level(1).rgba(), [[67, 67, 67, 255]]);
        let row = texels(5, 1, |x, _| [(x * 10) as u8, 0, 0, 255]);
        let level = Pyramid::new(&row, Encoding::Linear, Alpha::Ignored, Wrap::Clamp).level(1);
        // (0 + 10 + 20 / 2) / 2.5 and (20 / 2 + 30 + 40) / 2.5.
        assert_eq!([level.at(0, 0)[0], level.at(1, 0)[0]], [8, 32]);
    }

    #[test]
    fn what_is_not_there_has_no_color() {
        let leaf = texels(2, 2, |x, _| if x == 0 { [100, 200, 50, 255] } else { [0, 0, 0, 0] });
        let level = |alpha| Pyramid::new(&leaf, Encoding::Linear, alpha, Wrap::Clamp).level(1).at(0, 0);
        assert_eq!(level(Alpha::Mean), [100, 200, 50, 128]);
        assert_eq!(level(Alpha::Paper), [50, 100, 25, 128], "the halo");
    }

    #[test]
    fn levels_keep_what_passes_the_test() {
        // Twigs one texel wide, every fifth column; a plain mean is below any useful threshold.
        let twigs = texels(64, 64, |x, y| [90, 60, 30, if (x * 2 + y) % 10 < 2 { 255 } else { 0 }]);
        let threshold = 0.5;
        let kept = Pyramid::new(&twigs, Encoding::Srgb, Alpha::Test(threshold), Wrap::Repeat);
        let paper = Pyramid::new(&twigs, Encoding::Srgb, Alpha::Paper, Wrap::Repeat);
        let share = |pyramid: &Pyramid, level| coverage(&pyramid.level(level), threshold, Wrap::Repeat);
        let first = share(&kept, 0);
        for level in 1..4 {
            let now = share(&kept, level);
            assert!((now - first).abs() <= 0.02, "level {level}: {now} of {first}");
        }
        assert_eq!(share(&paper, 3), 0.0, "the twigs vanish");
        // The mean of alpha stays by itself, without any scale.
        let mean = Pyramid::new(&twigs, Encoding::Srgb, Alpha::Mean, Wrap::Repeat);
        let alpha = |level| {
            let texels = mean.level(level);
            texels.rgba().iter().map(|texel| f64::from(texel[3])).sum::<f64>() / texels.rgba().len() as f64 / 255.0
        };
        (1..7).for_each(|level| assert!((alpha(level) - alpha(0)).abs() < 0.003, "level {level}: {}", alpha(level)));
    }
}
