//! What a surface does with light.
//!
//! Space: none; colors are display values, as written in the file.

use super::TextureId;
use crate::color::Rgb;

/// Which reflection model a surface follows; [`crate::screen::shader`] has the formulas.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Reflection {
    /// Phong's, as NFF means it: sums are not clamped, and highlights appear only where the light is above the surface.
    #[default]
    Nff,
    /// SIPP's `phong`: diffuse sum, specular sum and result are clamped to 1; highlights are not gated.
    Phong,
    /// SIPP's `basic`: the highlight is a rational function of the angle instead of a power. `c3`: 0 shiny, 1 dull.
    Basic {
        /// Width of the highlight, above 0, at most 1.
        c3: f64,
    },
}

/// What light a surface sends back: color, coefficients and the model they belong to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// What the coefficients mean.
    pub reflection: Reflection,
    /// Scales ambient and diffuse light; display values 0..1.
    pub color: Rgb,
    /// Coefficient of ambient light. `None` (NFF has none): the renderer's ambient light, reflected as `diffuse` says.
    pub ambient: Option<f64>,
    /// Coefficient of diffuse light, NFF's Kd. Unused by `Basic`, whose is 1.
    pub diffuse: f64,
    /// Coefficient of the highlight, NFF's Ks.
    pub specular: f64,
    /// Phong's cosine power, NFF's Shine: larger is smaller and sharper. 100000 means no visible highlight. Unused by `Basic`.
    pub shine: f64,
    /// 1 hides what is behind, 0 is invisible; per channel. NFF's 1 - T.
    pub opacity: Rgb,
    /// Index of refraction: kept for the NFF writer, unused by rasterizers.
    pub refraction: f64,
    /// A picture that the light is multiplied by; the surface's polygons then have texture coordinates.
    pub texture: Option<TextureId>,
}

impl Default for Material {
    /// What NFF objects get before any `f`: white, Kd 0.8, opaque.
    fn default() -> Self {
        Material {
            reflection: Reflection::Nff,
            color: Rgb::WHITE,
            ambient: None,
            diffuse: 0.8,
            specular: 0.0,
            shine: 0.0,
            opacity: Rgb::WHITE,
            refraction: 1.0,
            texture: None,
        }
    }
}

impl Material {
    /// Hides everything behind it.
    #[must_use]
    pub fn is_opaque(&self) -> bool {
        self.opacity == Rgb::WHITE
    }
}
