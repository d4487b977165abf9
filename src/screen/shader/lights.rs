//! Lights in eye space: from which direction, and how much of it, light arrives at a point.
//!
//! No light fades with distance: SIPP's and NFF's rule. What a spot adds is its cone.
//!
//! Space: eye space. Directions are unit and lead *towards* the light, so that N.L needs no sign.
//! Source: J. Yngvesson and I. Wallin, "SIPP User's Guide" and the light evaluation of SIPP 3.3.
//! Cost: one square root for a point light, none for a directional one; a soft spot adds one cosine.

use crate::color::Rgb;
use crate::math::{PI, Vec3, cos};
use crate::scene::SpotEdge;
use crate::screen::lane::{Wide, dot, unit};

/// A light in eye space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EyeLight {
    /// Where its light comes from.
    pub source: EyeSource,
    /// Light color times intensity.
    pub color: Rgb,
}

/// Where light comes from, in eye space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum EyeSource {
    /// From a point in all directions.
    Point {
        /// Eye space.
        position: Vec3,
    },
    /// From infinitely far away.
    Directional {
        /// Unit, towards the light.
        to_light: Vec3,
    },
    /// From a point into a cone.
    Spot(Spot),
}

/// A spot light made ready.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// Eye space.
    pub position: Vec3,
    /// Unit, along the middle of the cone, away from the light.
    pub axis: Vec3,
    /// Cosine of half the opening.
    pub cosine: f64,
    /// How its light ends at the cone.
    pub edge: SpotEdge,
}

impl EyeLight {
    /// A point light.
    #[must_use]
    pub fn point(position: Vec3, color: Rgb) -> EyeLight {
        EyeLight { source: EyeSource::Point { position }, color }
    }

    /// The same light with eye space measured in another unit.
    pub(in crate::screen) fn scale_lengths(&mut self, factor: f64) {
        match &mut self.source {
            EyeSource::Point { position } | EyeSource::Spot(Spot { position, .. }) => *position *= factor,
            EyeSource::Directional { .. } => {}
        }
    }

    /// The unit direction towards the light and the color that arrives at the point `eye`; `None` where nothing does.
    ///
    /// A light exactly at the point has no direction and adds nothing.
    #[must_use]
    #[inline]
    pub fn arriving(&self, eye: Vec3) -> Option<(Vec3, Rgb)> {
        let Arriving { to_light, color, arrives } = self.arriving_at(eye.to_array());
        arrives.then(|| (to_light.into(), color.into()))
    }

    /// The same at one point or several side by side.
    #[inline(always)]
    pub(super) fn arriving_at<T: Wide>(&self, eye: [T; 3]) -> Arriving<T> {
        let (zero, one) = (eye[0].all(0.0), eye[0].all(1.0));
        let color = everywhere(zero, self.color.to_array());
        match self.source {
            EyeSource::Point { position } => {
                let (to_light, arrives) = direction(position, eye);
                Arriving { to_light, color, arrives }
            }
            EyeSource::Directional { to_light } => {
                Arriving { to_light: everywhere(zero, to_light.to_array()), color, arrives: one.above(zero) }
            }
            EyeSource::Spot(spot) => {
                let (to_light, has_direction) = direction(spot.position, eye);
                let axis = everywhere(zero, spot.axis.to_array());
                let share = (zero - dot(axis, to_light)).each(|cosine| spot.share(cosine));
                let color = [color[0] * share, color[1] * share, color[2] * share];
                Arriving { to_light, color, arrives: has_direction & share.above(zero) }
            }
        }
    }
}

/// Three numbers in as many lanes as `like` has.
#[inline(always)]
fn everywhere<T: Wide>(like: T, numbers: [f64; 3]) -> [T; 3] {
    [like.all(numbers[0]), like.all(numbers[1]), like.all(numbers[2])]
}

/// The unit direction from points to `position`, and where there is one.
#[inline(always)]
fn direction<T: Wide>(position: Vec3, eye: [T; 3]) -> ([T; 3], T::Mask) {
    let position = everywhere(eye[0], position.to_array());
    unit([position[0] - eye[0], position[1] - eye[1], position[2] - eye[2]])
}

/// Light that arrives at points, one or several side by side.
pub(super) struct Arriving<T: Wide> {
    /// Unit directions towards the light.
    pub to_light: [T; 3],
    pub color: [T; 3],
    /// At which points any arrives; elsewhere the rest says nothing.
    pub arrives: T::Mask,
}

impl Spot {
    /// How much of its light, 0 to 1, goes a way whose angle to the axis has this `cosine`.
    ///
    /// Sharp: all inside the cone. Soft: half a cosine wave from the axis (1) to the cone (0). The wave runs over the cosine d of the
    /// angle to the axis, not over the angle: half the light is left at d = (1 + c)/2.
    fn share(&self, cosine: f64) -> f64 {
        // Rounding may give a cosine just above 1.
        let cosine = cosine.min(1.0);
        if cosine < self.cosine {
            return 0.0;
        }
        match self.edge {
            SpotEdge::Sharp => 1.0,
            SpotEdge::Soft => 0.5 + 0.5 * cos(PI * (1.0 - cosine) / (1.0 - self.cosine)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{radians, sin};

    /// A spot at the origin that shines along the view, and the light at `degrees` off its axis.
    fn light_at(opening: f64, edge: SpotEdge, degrees: f64) -> f64 {
        let cosine = cos(radians(opening) / 2.0);
        let spot = Spot { position: Vec3::ZERO, axis: Vec3::Z, cosine, edge };
        let light = EyeLight { source: EyeSource::Spot(spot), color: Rgb::WHITE };
        let angle = radians(degrees);
        light.arriving(Vec3::new(sin(angle), 0.0, cos(angle)) * 7.0).map_or(0.0, |(_, color)| color.g)
    }

    #[test]
    fn a_sharp_spot_is_all_or_nothing() {
        for (degrees, expected) in [(0.0, 1.0), (14.9, 1.0), (15.1, 0.0), (90.0, 0.0), (180.0, 0.0)] {
            assert_eq!(light_at(30.0, SpotEdge::Sharp, degrees), expected, "{degrees}");
        }
        assert_eq!(light_at(170.0, SpotEdge::Sharp, 84.9), 1.0);
    }

    #[test]
    fn a_soft_spot_fades_from_one_to_nothing() {
        assert_eq!(light_at(40.0, SpotEdge::Soft, 0.0), 1.0);
        assert_eq!(light_at(40.0, SpotEdge::Soft, 20.01), 0.0);
        assert!(light_at(40.0, SpotEdge::Soft, 19.99) < 1e-5);
        // Halfway between the axis and the cone, measured along the axis.
        let halfway = crate::math::acos((1.0 + cos(radians(20.0))) / 2.0).to_degrees();
        assert!((light_at(40.0, SpotEdge::Soft, halfway) - 0.5).abs() < 1e-12);
        let samples: Vec<f64> = (0..=20).map(|degrees| light_at(40.0, SpotEdge::Soft, f64::from(degrees))).collect();
        assert!(samples.windows(2).all(|pair| pair[0] > pair[1]), "{samples:?}");
    }

    #[test]
    fn a_directional_light_is_the_same_everywhere() {
        let light = EyeLight { source: EyeSource::Directional { to_light: Vec3::Y }, color: Rgb::gray(0.5) };
        for eye in [Vec3::ZERO, Vec3::splat(1e9), Vec3::NEG_Y] {
            assert_eq!(light.arriving(eye), Some((Vec3::Y, Rgb::gray(0.5))));
        }
        let point = EyeLight::point(Vec3::Y, Rgb::WHITE);
        assert_eq!(point.arriving(Vec3::Y), None);
    }
}
