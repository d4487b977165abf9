//! Errors: how far a configuration's picture is from the truth, of every kind that the lab knows.
//!
//! configuration, [`Truth`], oracles -ERRORS-> [`Errors`]
//!
//! Why so many: a mean hides a lost pixel, a maximum hides a tint. Light is compared before it is rounded to 8 bits (rounding adds
//! up to half a level to every picture), what the eye notices (FLIP, SSIM) on the written bytes.
//!
//! Everything is counted, nothing is timed: a second run gives the same numbers.
//! Cost: one picture, and rays or exact signs at no more than 2^16 samples each.

use super::configurations::Configuration;
use super::owners::{Parts, owners, wrong_coverage};
use super::truth::{Source, Truth, levels};
use crate::color::Encoding;
use crate::image::flip::FlipReference;
use crate::image::{Image, Picture, ssim};
use crate::oracle::Vertices;
use crate::oracle::ray::Tracer;
use crate::oracle::ray::silhouette::{Polygons, deviation, traced};
use crate::plan::{Choices, PlanError};
use crate::raster::Rasterizer;
use crate::render::{self, Canvas};
use crate::scene::Scene;
use crate::screen::DrawList;
use serde::Serialize;

/// How wrong a picture is. `None`: no oracle has an answer, or no picture came; where none came, the others are infinite.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Errors {
    /// The largest error of a channel of a pixel, in levels of 255.
    pub worst_levels: f64,
    /// One pixel in a thousand errs by more than this many levels.
    pub thousandth_levels: f64,
    /// Root of the mean square over all channels, in levels.
    pub rms_levels: f64,
    /// Samples in a million that show another polygon or shape than the one a ray meets.
    pub wrong_visible_ppm: Option<f64>,
    /// Of a million samples at edges, those whose owner differs from what the polygons cover before snapping.
    pub wrong_coverage_ppm: Option<f64>,
    /// Hausdorff's distance of the outlines, in pixels; at most [`FARTHEST`].
    pub silhouette_px: Option<f64>,
    /// Mean FLIP, 0 to 1.
    pub flip_mean: f64,
    /// One pixel in a hundred has a larger FLIP.
    pub flip_worst: f64,
    /// 1 - SSIM: 0 where the structure is the same.
    pub dissimilarity: f64,
}

impl Errors {
    /// Those of a picture that never came.
    pub const NO_PICTURE: Errors = Errors {
        worst_levels: f64::INFINITY,
        thousandth_levels: f64::INFINITY,
        rms_levels: f64::INFINITY,
        wrong_visible_ppm: None,
        wrong_coverage_ppm: None,
        silhouette_px: None,
        flip_mean: f64::INFINITY,
        flip_worst: f64::INFINITY,
        dissimilarity: f64::INFINITY,
    };
}

/// Why there are no errors.
#[derive(Clone, Debug, PartialEq)]
pub enum NoErrors {
    /// The configuration makes no plan.
    Plan(PlanError),
    /// A rasterizer outside farop gave no picture; its reason.
    NoPicture(String),
}

/// Silhouettes farther apart than this many pixels are not told apart.
pub const FARTHEST: f64 = 8.0;

/// A scene with all that its configurations are compared with.
pub struct Judge<'a> {
    scene: &'a Scene,
    truth: &'a Truth,
    encoding: Encoding,
    tracer: Option<Tracer<'a>>,
    parts: Parts,
    picture: Picture,
    flip: FlipReference,
}

impl<'a> Judge<'a> {
    /// Makes ready to judge pictures of `scene`; `truth` knows every pixel.
    ///
    /// `base`: size, angle, culling, encoding and light of the truth, with one sample a pixel.
    #[must_use]
    pub fn new(scene: &'a Scene, truth: &'a Truth, base: &'a Choices) -> Judge<'a> {
        let picture = truth.image().encode(base.encoding);
        let flip = FlipReference::new(&picture);
        let tracer = (truth.source == Source::Rays).then(|| Tracer::new(scene, base).ok()).flatten();
        Judge { scene, truth, encoding: base.encoding, tracer, parts: Parts::new(scene), picture, flip }
    }

    /// The errors of one configuration. A rasterizer that hands over a finished picture does not say which polygon shows where, so
    /// only its colors are judged.
    ///
    /// # Errors
    /// [`NoErrors`] when it makes no plan, or no picture comes.
    pub fn errors(&self, configuration: &Configuration, rasterizer: &dyn Rasterizer) -> Result<Errors, NoErrors> {
        let choices = &configuration.choices;
        let list = render::list(self.scene, choices, Some(rasterizer)).map_err(NoErrors::Plan)?;
        let canvas = Canvas::new(self.scene, choices);
        let (image, puts) = render::draw(&list, Some(rasterizer), &canvas);
        if let Some(reason) = puts.failure {
            return Err(NoErrors::NoPicture(reason));
        }
        let mut errors = self.of_image(&image);
        if list.has_depth && puts.shown == 0 {
            let drawn = owners(&list, rasterizer, &canvas);
            errors.wrong_coverage_ppm = wrong_coverage(&list, &drawn);
            if let Some(tracer) = &self.tracer {
                errors.wrong_visible_ppm = self.parts.wrong_visible(tracer, &list, &drawn, choices.samples);
                errors.silhouette_px = Some(silhouette(tracer, &list, choices.samples));
            }
        }
        Ok(errors)
    }

    /// The errors of the colors of a finished picture.
    pub(super) fn of_image(&self, image: &Image) -> Errors {
        let picture = image.encode(self.encoding);
        let mut differences = self.flip.differences(&picture);
        let count = differences.len().max(1) as f64;
        let flip_mean = differences.iter().sum::<f64>() / count;
        differences.sort_by(f64::total_cmp);
        Errors {
            flip_mean,
            flip_worst: exceeded_by(&differences, 100),
            dissimilarity: 1.0 - ssim::ssim(&self.picture, &picture),
            ..color_errors(self.truth, image, self.encoding)
        }
    }
}

/// The value that one in `share` of the sorted `values` exceeds.
fn exceeded_by(values: &[f64], share: usize) -> f64 {
    let allowed = values.len() / share;
    values.get(values.len().wrapping_sub(1 + allowed)).copied().unwrap_or(0.0)
}

/// Errors of color at the pixels that `truth` knows; the other fields are empty.
#[must_use]
pub fn color_errors(truth: &Truth, image: &Image, encoding: Encoding) -> Errors {
    let mut squares = 0.0;
    let mut largest: Vec<f64> = Vec::with_capacity(truth.pixels.len());
    for difference in pixel_errors(truth, image, encoding) {
        squares += difference.iter().map(|level| level * level).sum::<f64>();
        largest.push(difference.into_iter().fold(0.0, f64::max));
    }
    largest.sort_by(f64::total_cmp);
    Errors {
        worst_levels: largest.last().copied().unwrap_or(0.0),
        thousandth_levels: exceeded_by(&largest, 1000),
        rms_levels: (squares / (3 * largest.len().max(1)) as f64).sqrt(),
        ..Errors::default()
    }
}

/// The error of each channel of each pixel that `truth` knows, in levels.
pub fn pixel_errors(truth: &Truth, image: &Image, encoding: Encoding) -> impl Iterator<Item = [f64; 3]> {
    truth.pixels.iter().zip(&truth.light).map(move |(&pixel, &light)| {
        let drawn = levels(encoding, image.pixels()[pixel as usize].to_f64());
        let right = levels(encoding, light);
        [0, 1, 2].map(|axis| (drawn[axis] - right[axis]).abs())
    })
}

/// How far the outline of all that `list` draws is from that of all that rays meet, in pixels.
#[must_use]
pub fn silhouette(tracer: &Tracer<'_>, list: &DrawList, samples: u32) -> f64 {
    let polygons = Polygons::new(list, Vertices::Snapped, |_| true);
    let scale = f64::from(samples);
    // Both in pixels, whatever the list counts in.
    let drawn = |x: f64, y: f64| crate::oracle::ray::silhouette::Region::contains(&polygons, x * scale, y * scale);
    let seen = traced(tracer, |_| true);
    deviation(&seen, &drawn, tracer.size(), FARTHEST).largest
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::Rgb;

    fn truth(light: Vec<Rgb>) -> Truth {
        let count = light.len() as u32;
        let (pixels, uneven) = ((0..count).collect(), vec![false; light.len()]);
        Truth { size: (count, 1), pixels, light, uneven, source: Source::Rays }
    }

    #[test]
    fn color_errors_by_hand() {
        // Levels 51 and 102 of 255 where 0 and 51 should be; one channel is right.
        let truth = truth(vec![Rgb::BLACK, Rgb::gray(0.2)]);
        let mut image = Image::new(2, 1, Rgb::new(0.2, 0.2, 0.0));
        image.set_pixel(1, 0, Rgb::new(0.4, 0.2, 0.2));
        let found = color_errors(&truth, &image, Encoding::Linear);
        let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-4, "{a} {b}");
        close(found.worst_levels, 51.0);
        close(found.rms_levels, (3.0 * 51.0 * 51.0 / 6.0_f64).sqrt());
        // What is brighter than the display is cut before it is compared.
        let bright =
            color_errors(&self::truth(vec![Rgb::gray(3.0)]), &Image::new(1, 1, Rgb::gray(1.0)), Encoding::Srgb);
        close(bright.worst_levels, 0.0);
    }

    #[test]
    fn one_in_a_thousand_may_exceed() {
        let values: Vec<f64> = (0..2000).map(f64::from).collect();
        assert_eq!(
            (exceeded_by(&values, 1000), exceeded_by(&values[..10], 1000), exceeded_by(&[], 1000)),
            (1997.0, 9.0, 0.0)
        );
    }
}
