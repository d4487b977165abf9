//! Lights.
//!
//! Space: world space. Colors are light, not display values. None of them fades with distance (SIPP's and NFF's rule).

use super::{Place, Scene};
use crate::color::Rgb;
use crate::math::Vec3;

/// A light and where its light comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// Where its light comes from.
    pub source: LightSource,
    /// Relative color. White where the file gives none.
    pub color: Rgb,
    /// Factor on `color`. `None` (NFF has none): the renderer chooses, see [`crate::plan`].
    pub intensity: Option<f64>,
    /// Where it was declared.
    pub place: Place,
}

impl Light {
    /// A point light that leaves its intensity to the renderer, as NFF's are.
    #[must_use]
    pub fn point(position: Vec3, color: Rgb, place: Place) -> Light {
        Light { source: LightSource::Point { position }, color, intensity: None, place }
    }
}

impl Scene {
    /// The intensity of each light that leaves it open, and of the ambient light: sqrt(n) / (2 n) for n such lights; where none leaves it
    /// open, for all lights; 1 without lights.
    ///
    /// Source: E. Haines, readme of the Standard Procedural Databases.
    #[must_use]
    pub fn suggested_intensity(&self) -> f64 {
        let open = self.lights.iter().filter(|light| light.intensity.is_none()).count();
        let count = if open > 0 { open } else { self.lights.len() } as f64;
        if count == 0.0 { 1.0 } else { count.sqrt() / (2.0 * count) }
    }
}

impl LightSource {
    /// Where it stands; for a directional light, the end of its vector.
    #[must_use]
    pub fn position(&self) -> Vec3 {
        match *self {
            LightSource::Point { position } | LightSource::Spot { position, .. } => position,
            LightSource::Directional { to_light } => to_light,
        }
    }
}

/// Where light comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightSource {
    /// From a point in all directions.
    Point {
        /// World space.
        position: Vec3,
    },
    /// From infinitely far away: the same direction everywhere.
    Directional {
        /// Leads from the scene *towards* the light; not zero, need not be unit.
        to_light: Vec3,
    },
    /// From a point into a cone.
    Spot {
        /// World space.
        position: Vec3,
        /// The point it is aimed at; not `position`.
        at: Vec3,
        /// Full opening of the cone in degrees, above 0, below 180.
        opening: f64,
        /// How it ends at the cone.
        edge: SpotEdge,
    },
}

/// How the light of a spot ends at its cone.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SpotEdge {
    /// All or nothing.
    #[default]
    Sharp,
    /// Fades from the axis to the cone like half a cosine wave.
    Soft,
}
