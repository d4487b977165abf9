//! Tracer: finds what a ray meets.

use super::camera::Eye;
use super::{Hit, RayError, RayPicture};
use crate::color::Rgb;
use crate::plan::Choices;
use crate::scene::Scene;

/// A scene made ready for rays.
pub struct Tracer<'a> {
    #[allow(dead_code)]
    scene: &'a Scene,
    eye: Eye,
    choices: Choices,
}

impl<'a> Tracer<'a> {
    /// Makes `scene` ready.
    ///
    /// # Errors
    /// [`RayError`] when there is no usable camera, or a shape without an equation.
    pub fn new(scene: &'a Scene, choices: &Choices) -> Result<Tracer<'a>, RayError> {
        let eye = Eye::new(scene.camera.as_ref().ok_or(RayError::NoCamera)?, choices)?;
        Ok(Tracer { scene, eye, choices: choices.clone() })
    }

    /// Width and height of the picture in samples.
    #[must_use]
    pub fn size(&self) -> (u32, u32) {
        self.eye.size
    }

    /// What the ray through the place (x, y), in samples, meets first; sample (i, j) has its center at (i + .5, j + .5).
    #[must_use]
    pub fn hit(&self, x: f64, y: f64) -> Option<Hit> {
        let _ = self.eye.ray(x, y);
        None
    }

    /// The light that comes through the place (x, y), transparent layers included, and what is met first.
    #[must_use]
    pub fn light(&self, x: f64, y: f64) -> (Rgb, Option<Hit>) {
        (Rgb::BLACK, self.hit(x, y))
    }

    /// Every sample.
    #[must_use]
    pub fn picture(&self) -> RayPicture {
        let (width, height) = self.eye.size;
        let places = (0..height).flat_map(|y| (0..width).map(move |x| (f64::from(x) + 0.5, f64::from(y) + 0.5)));
        let (light, hits) = places.map(|(x, y)| self.light(x, y)).unzip();
        RayPicture { width, height, samples: self.choices.samples, light, hits }
    }
}
