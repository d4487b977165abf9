//! Pictures on surfaces: which color a sample's light is multiplied by, and whether the sample is there at all.
//!
//! u, v and their planes -LEVEL-> pyramid -COLOR, ALPHA-> RULE -> multiplied light, or a hole
//!
//! Why the size of a sample comes from planes and not from its neighbors: a GPU takes differences within blocks of 2 x 2 samples,
//! and a block's samples outside the polygon are invented. Here u = (u/w) / (1/w) with both linear on the screen, so
//! du/dx = (a_u - u a_w) / (1/w), and every rasterizer, tile and thread gets the same.
//!
//! Why a hole decides before depth is written: what is not there hides nothing. A rasterizer asks for the fragment before it puts it,
//! and puts none that is a hole ([`super::Fragment::is_hole`]).
//!
//! Alpha-to-coverage: of the A x A samples of a pixel, ranked 0 to A x A - 1, those are there whose alpha is above
//! (rank + 1/2) / (A x A). Their share is alpha, so the pixel's mean is what blending would show, without any order. Ranks are
//! spread over the pixel, and turned by a number of the polygon: two leaves one behind the other must not hide the same samples.
//!
//! Before all that a fade may leave the sample to another surface (`fade`).
//!
//! Space: samples. Source: Castano 2010; for ranks, Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018.
//! Cost: one lookup a sample.

use super::picture::{Picture, TextureShading};
use super::{Shader, fade};
use crate::color::Rgb;
use crate::image::textures::{Alpha, Sample};
use crate::plan::{AlphaRule, TextureFilter};
use crate::screen::ScreenPolygon;

/// The pictures of one list, and how they are looked up.
#[derive(Clone, Debug, PartialEq)]
pub struct Textures {
    /// [`super::SurfaceShading::texture`] points here.
    pub list: Vec<TextureShading>,
    /// How.
    pub filter: TextureFilter,
    /// Which samples of a surface with holes are there.
    pub alpha: AlphaRule,
    /// A: samples of a pixel each way.
    samples: u32,
    /// For each sample of a pixel, row by row: how much alpha it asks for.
    asked: Vec<f32>,
}

/// What a picture makes of one sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Seen {
    /// The surface has no picture.
    Plain,
    /// Nothing is there.
    Hole,
    /// Light is multiplied by this.
    Color(Rgb<f32>),
}

impl Default for Textures {
    fn default() -> Self {
        Textures::new(TextureFilter::Trilinear, AlphaRule::Coverage, 1)
    }
}

impl Textures {
    /// None so far, for pictures of `samples` x `samples` samples a pixel.
    #[must_use]
    pub fn new(filter: TextureFilter, alpha: AlphaRule, samples: u32) -> Textures {
        let samples = samples.max(1);
        Textures { list: Vec::new(), filter, alpha, samples, asked: asked_alpha(samples) }
    }

    /// A: samples of a pixel each way.
    #[must_use]
    pub fn samples(&self) -> u32 {
        self.samples
    }

    /// Adds a picture and returns its index. Means that were made for the picture `before`, in the last frame, are used again.
    pub fn push(&mut self, picture: &Picture<'_>, before: &Textures) -> u32 {
        let alpha = match (picture.threshold, self.alpha) {
            (None, _) => Alpha::Ignored,
            (Some(_), AlphaRule::Paper) => Alpha::Paper,
            (Some(_), AlphaRule::Coverage) if self.samples > 1 => Alpha::Mean,
            (Some(threshold), _) => Alpha::Test(threshold),
        };
        let shading = TextureShading::new(picture, alpha, [&self.list, &before.list]);
        self.list.push(shading);
        (self.list.len() - 1) as u32
    }

    /// Whether a sample with that `alpha` is there. `turn`: a number of the polygon, any.
    #[inline]
    fn is_there(&self, alpha: f32, threshold: f32, (x, y): (i32, i32), turn: impl FnOnce() -> u32) -> bool {
        if self.alpha != AlphaRule::Coverage || self.samples == 1 {
            return alpha > threshold;
        }
        let side = self.samples as i32;
        let place = y.rem_euclid(side) * side + x.rem_euclid(side);
        let turned = (place as usize + turn() as usize) % self.asked.len();
        centered(alpha, threshold) > self.asked[turned]
    }
}

/// Alpha bent so that the threshold lies at one half.
#[inline]
fn centered(alpha: f32, threshold: f32) -> f32 {
    if alpha > threshold {
        0.5 + 0.5 * (alpha - threshold) / (1.0 - threshold)
    } else if threshold > 0.0 {
        0.5 * alpha / threshold
    } else {
        0.0
    }
}

/// (rank + 1/2) / n for the n = A x A samples of a pixel, row by row. A row goes on in the next one, so turning is adding.
fn asked_alpha(samples: u32) -> Vec<f32> {
    let count = samples as usize * samples as usize;
    // One sample asks its threshold, and no memory.
    if count == 1 {
        return Vec::new();
    }
    // Fractions of multiples of the golden ratio are as far from each other as can be; in whole numbers, exactly.
    let fraction = |index: usize| (index as u64).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by_key(|&index| fraction(index));
    let mut asked = vec![0.0; count];
    for (rank, &index) in order.iter().enumerate() {
        asked[index] = ((rank as f64 + 0.5) / count as f64) as f32;
    }
    asked
}

impl Shader {
    /// Whether a surface has holes: which samples of it are there is known only one by one.
    #[must_use]
    #[inline]
    pub fn is_cut_out(&self, surface: u32) -> bool {
        self.texture_of(surface).is_some_and(TextureShading::has_holes)
    }

    #[inline]
    pub(crate) fn texture_of(&self, surface: u32) -> Option<&TextureShading> {
        let index = self.surfaces.get(surface as usize)?.texture?;
        self.textures.list.get(index as usize)
    }

    /// Whether sample (x, y) of a polygon is there, and not in a hole: what [`Shader::fragment`] finds, without any light.
    #[must_use]
    pub fn is_there(&self, polygon: &ScreenPolygon<'_>, x: i32, y: i32) -> bool {
        self.is_there_at(polygon, (x, y), polygon.inverse_w(x, y), polygon.texture_place(x, y))
    }

    /// The same where 1/w and u, v are these.
    #[inline]
    pub(crate) fn is_there_at(
        &self,
        polygon: &ScreenPolygon<'_>,
        sample: (i32, i32),
        inverse_w: f64,
        uv: [f64; 2],
    ) -> bool {
        let Some(texture) = self.texture_of(polygon.surface()) else { return true };
        if !is_shown(texture, polygon, sample) {
            return false;
        }
        let Some(threshold) = texture.threshold else { return true };
        let alpha = texture.alpha(self.textures.filter, uv, || polygon.texture_slopes(inverse_w, uv));
        self.textures.is_there(alpha, threshold, sample, || turn_of(polygon))
    }

    /// What the picture of a polygon makes of sample (x, y), where 1/w and u, v are these.
    #[inline]
    pub(crate) fn seen(&self, polygon: &ScreenPolygon<'_>, sample: (i32, i32), inverse_w: f64, uv: [f64; 2]) -> Seen {
        let Some(texture) = self.texture_of(polygon.surface()) else { return Seen::Plain };
        if !is_shown(texture, polygon, sample) {
            return Seen::Hole;
        }
        let Sample { color, alpha } = self.look_up(polygon, texture, inverse_w, uv);
        match texture.threshold {
            Some(threshold) if !self.textures.is_there(alpha, threshold, sample, || turn_of(polygon)) => Seen::Hole,
            _ => Seen::Color(color),
        }
    }

    /// What light is multiplied by at a sample that is there, where 1/w and u, v are these.
    #[inline]
    pub(crate) fn texel(
        &self,
        polygon: &ScreenPolygon<'_>,
        texture: &TextureShading,
        inverse_w: f64,
        uv: [f64; 2],
    ) -> Rgb<f32> {
        self.look_up(polygon, texture, inverse_w, uv).color
    }

    #[inline]
    fn look_up(&self, polygon: &ScreenPolygon<'_>, texture: &TextureShading, inverse_w: f64, uv: [f64; 2]) -> Sample {
        texture.sample(self.textures.filter, uv, || polygon.texture_slopes(inverse_w, uv))
    }
}

/// Whether a fade leaves the sample to this polygon. What is one thing in the scene has one line.
#[inline]
fn is_shown(texture: &TextureShading, polygon: &ScreenPolygon<'_>, sample: (i32, i32)) -> bool {
    texture.fade.is_none_or(|fade| fade::shows(fade, sample, polygon.record().source.line))
}

/// A number of the polygon's place in the scene: the same for its pieces, and wherever the camera stands.
#[inline]
fn turn_of(polygon: &ScreenPolygon<'_>) -> u32 {
    let source = polygon.record().source;
    let place = u64::from(source.line) << 32 | u64::from(source.number);
    mixed(place ^ u64::from(polygon.surface()).rotate_left(48))
}

/// 24 bits that look like chance, of any number.
#[inline]
pub(super) fn mixed(number: u64) -> u32 {
    let mixed = number.wrapping_add(0x9E37_79B9_7F4A_7C15);
    let mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    (mixed >> 40) as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    fn there(textures: &Textures, alpha: f32, threshold: f32, turn: u32) -> usize {
        let side = textures.samples as i32;
        let samples = (0..side * side).map(|index| (index % side - side, index / side + 5 * side));
        samples.filter(|&sample| textures.is_there(alpha, threshold, sample, || turn)).count()
    }

    #[test]
    fn as_many_samples_are_there_as_alpha_says() {
        for samples in [2, 3, 4, 8] {
            let textures = Textures::new(TextureFilter::Nearest, AlphaRule::Coverage, samples);
            let all = (samples * samples) as usize;
            for step in 0..=all {
                let alpha = step as f32 / all as f32;
                for turn in [0, 1, 7, u32::MAX >> 8] {
                    assert_eq!(there(&textures, alpha, 0.5, turn), step, "{samples} {alpha} {turn}");
                }
            }
            // Another threshold moves the middle, not the ends.
            assert_eq!(there(&textures, 1.0, 0.25, 3), all);
            assert_eq!(there(&textures, 0.0, 0.25, 3), 0);
            assert_eq!(there(&textures, 0.25 + 1e-6, 0.25, 3), all.div_ceil(2));
        }
    }

    #[test]
    fn one_sample_is_a_test() {
        for alpha in [AlphaRule::Coverage, AlphaRule::Test, AlphaRule::Paper] {
            let textures = Textures::new(TextureFilter::Nearest, alpha, 1);
            assert_eq!([0.29, 0.3, 0.31].map(|alpha| there(&textures, alpha, 0.3, 9)), [0, 0, 1]);
        }
        let textures = Textures::new(TextureFilter::Nearest, AlphaRule::Test, 4);
        assert_eq!([0.5, 0.51].map(|alpha| there(&textures, alpha, 0.5, 9)), [0, 16]);
    }

    #[test]
    fn two_layers_of_half_cover_three_quarters_on_average() {
        let textures = Textures::new(TextureFilter::Nearest, AlphaRule::Coverage, 4);
        let mut covered = 0;
        for turn in 0..16 {
            for index in 0..16 {
                let sample = (index % 4, index / 4);
                covered += u32::from([0, turn].iter().any(|&turn| textures.is_there(0.5, 0.5, sample, || turn)));
            }
        }
        assert_eq!(covered, 16 * 12);
    }
}
