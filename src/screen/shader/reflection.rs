//! What a surface sends back: a material made ready, and the formulas of its reflection model.
//!
//! With L towards a light, N the normal, V towards the eye, R = 2 (N.L) N - L, I the light that arrives, all sums over the lights:
//!
//! ```text
//! nff     C (Ka Ia + Kd sum I max(0, N.L)) + Ks sum I max(0, R.V)^n          highlights only where N.L > 0; no clamping
//! phong   C (a + Kd D) + Ks min(1, sum I q^n)                                D = min(1, sum I max(0, N.L)), q = R.V > 0
//! basic   C (a + D)    + Ks min(1, sum I c^2 q / (q^2 (c^2 - 1) + 1))        c = c3: 0 shiny, 1 dull
//! ```
//!
//! The sums and the results of `phong` and `basic` are cut at 1, channel by channel. 1 is the light of display white: numbers here are
//! light, so with `--encoding srgb` a sum reaches 1 where the *light* adds up to white; with `--encoding linear` display values
//! themselves are added and cut, which is SIPP's own arithmetic. A highlight of theirs may appear on the night side of a surface,
//! where N.L < 0 and R still points to the eye; SIPP never asked.
//!
//! Space: none; colors are linear light.
//! Source: Phong, CACM 18(6), 1975; Yngvesson and Wallin, SIPP 3.3 (shaders `phong` and `basic`); the quotient with c3 is Trowbridge and
//! Reitz's distribution of facets without its square, as in Blinn, "Models of Light Reflection for Computer Synthesized Pictures",
//! SIGGRAPH 1977.

use super::BRIGHTEST;
use super::power::power;
use crate::color::Rgb;
use crate::scene::{Place, Reflection};
use crate::screen::lane::Wide;

/// A material made ready: colors decoded and multiplied by their coefficients.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SurfaceShading {
    /// Which formula the numbers belong to.
    pub reflection: Reflection,
    /// Ka Ia C; for `phong` and `basic` a C.
    pub ambient: Rgb,
    /// Kd C.
    pub diffuse: Rgb,
    /// Ks.
    pub specular: f64,
    /// Cosine power; unused by `basic`.
    pub shine: f64,
    /// Per channel.
    pub opacity: Rgb<f32>,
    /// Its picture in [`super::Textures::list`].
    pub texture: Option<u32>,
    /// Where the surface was declared.
    pub place: Place,
}

impl SurfaceShading {
    /// Highlights appear only where the light is above the surface, and nothing is cut at 1.
    pub(super) fn is_nff(&self) -> bool {
        self.reflection == Reflection::Nff
    }

    /// How much light leaves where the cosine between the mirrored light and the eye is `cosine`, above 0, at most 1.
    #[inline(always)]
    pub(super) fn highlight<T: Wide>(&self, cosine: T) -> T {
        match self.reflection {
            Reflection::Nff | Reflection::Phong => power(cosine, self.shine),
            Reflection::Basic { c3 } => {
                // q^2 (c^2 - 1) + 1 as c^2 q^2 + (1 - q)(1 + q): exactly c^2 at q = 1, however small c is.
                let [one, least] = [cosine.all(1.0), cosine.all(f64::MIN_POSITIVE)];
                let numerator = cosine.all(c3 * c3) * cosine;
                let denominator = numerator * cosine + (one - cosine) * (one + cosine);
                numerator / T::choose(denominator.above(least), denominator, least)
            }
        }
    }

    /// The light that leaves, of the sums over the lights. The surface's color is multiplied with `factor`; highlights keep theirs.
    #[inline(always)]
    pub(super) fn sent<T: Wide>(&self, diffuse: [T; 3], specular: [T; 3], factor: Option<[T; 3]>) -> [T; 3] {
        let (own, scattered) = (self.ambient.to_array(), self.diffuse.to_array());
        let mut light = diffuse;
        let mut channel = 0;
        while channel < 3 {
            let (diffuse, specular) = (diffuse[channel], specular[channel]);
            let (mut ambient, mut color) = (diffuse.all(own[channel]), diffuse.all(scattered[channel]));
            if let Some(factor) = factor {
                (ambient, color) = (ambient * factor[channel], color * factor[channel]);
            }
            let mirror = diffuse.all(self.specular);
            light[channel] = if self.is_nff() {
                cut(ambient + color * diffuse + specular * mirror, BRIGHTEST)
            } else {
                cut(ambient + color * cut(diffuse, 1.0) + cut(specular, 1.0) * mirror, 1.0)
            };
            channel += 1;
        }
        light
    }
}

/// At most `most`; not-a-number counts as more.
#[inline(always)]
fn cut<T: Wide>(light: T, most: f64) -> T {
    T::choose(light.all(most).above(light), light, light.all(most))
}
