//! Light: the reflection models, from their formulas.
//!
//! NFF: color = Kd C Ia + sum over the lights with N.L > 0 of Ii (Kd C N.L + Ks (R.V)^n), R = 2 (N.L) N - L, R.V not below 0.
//! The format states neither ambient nor intensity: for n lights each of them, and the ambient, is sqrt(n) / (2 n).
//! SIPP's phong clamps the diffuse sum, the specular sum and the result to 1 and does not gate highlights; its basic has
//! no diffuse coefficient and c3^2 q / (q^2 (c3^2 - 1) + 1), q = R.V, in place of the power.
//!
//! Space: world space; colors are light.
//! Source: Phong, CACM 18(6), 1975; E. Haines, NFF and the SPD readme; Yngvesson and Wallin, "SIPP User's Guide".

use crate::color::Rgb;
use crate::math::{PI, Vec3, cos, pow, radians};
use crate::plan::Choices;
use crate::scene::{Light, LightSource, Material, Reflection, Scene, SpotEdge};

/// The lights of a scene at their levels.
pub(super) struct Lighting<'a> {
    lights: &'a [Light],
    ambient: f64,
    level: f64,
    choices: &'a Choices,
}

/// A point of a surface, seen from a direction; all unit.
pub(super) struct Point {
    pub place: Vec3,
    pub normal: Vec3,
    pub to_eye: Vec3,
}

impl<'a> Lighting<'a> {
    pub fn new(scene: &'a Scene, choices: &'a Choices) -> Lighting<'a> {
        let count = scene.lights.iter().filter(|light| light.intensity.is_none()).count() as f64;
        let suggested = if count > 0.0 { count.sqrt() / (2.0 * count) } else { 1.0 };
        let (ambient, level) = (choices.ambient.unwrap_or(suggested), choices.light_intensity.unwrap_or(suggested));
        Lighting { lights: &scene.lights, ambient, level, choices }
    }

    /// The light that a point of `material` sends to the eye.
    pub fn reflected(&self, material: &Material, point: &Point) -> Rgb {
        let terms = self.choices.light_terms;
        let color = self.choices.encoding.decode(material.color);
        let switch = |on: bool, value: f64| if on { value } else { 0.0 };
        let ambient = switch(terms.ambient, material.ambient.unwrap_or(self.ambient * material.diffuse));
        let diffuse = match material.reflection {
            Reflection::Basic { .. } => switch(terms.diffuse, 1.0),
            _ => switch(terms.diffuse, material.diffuse),
        };
        let specular = switch(terms.specular, material.specular);
        let (mut scattered, mut mirrored) = (Rgb::BLACK, Rgb::BLACK);
        for light in self.lights {
            let Some((to_light, share)) = arrival(light, point.place) else { continue };
            let arriving = light.color * (light.intensity.unwrap_or(self.level) * share);
            let cosine = point.normal.dot(to_light);
            if cosine > 0.0 {
                scattered += arriving * cosine;
            }
            if specular > 0.0 && (cosine > 0.0 || material.reflection != Reflection::Nff) {
                let reflected = point.normal * (2.0 * cosine) - to_light;
                mirrored += arriving * highlight(material, reflected.dot(point.to_eye).min(1.0));
            }
        }
        if material.reflection == Reflection::Nff {
            return color * ambient + color * scattered * diffuse + mirrored * specular;
        }
        let clamp = |light: Rgb| light.map(|channel| channel.min(1.0));
        clamp(color * ambient + color * clamp(scattered) * diffuse + clamp(mirrored) * specular)
    }
}

fn highlight(material: &Material, cosine: f64) -> f64 {
    match material.reflection {
        // NFF's 0^0 is 1: a shine of 0 is a highlight everywhere.
        Reflection::Nff => pow(cosine.max(0.0), material.shine),
        _ if cosine <= 0.0 => 0.0,
        Reflection::Phong => pow(cosine, material.shine),
        Reflection::Basic { c3 } => c3 * c3 * cosine / (cosine * cosine * (c3 * c3 - 1.0) + 1.0),
    }
}

/// The unit direction to a light and the share of its light that comes this way; `None` where it has no direction.
fn arrival(light: &Light, place: Vec3) -> Option<(Vec3, f64)> {
    match light.source {
        LightSource::Directional { to_light } => Some((to_light.try_normalize()?, 1.0)),
        LightSource::Point { position } => Some(((position - place).try_normalize()?, 1.0)),
        LightSource::Spot { position, at, opening, edge } => {
            let to_light = (position - place).try_normalize()?;
            let along = (at - position).try_normalize()?;
            let (angle, border) = (-to_light.dot(along), cos(radians(opening) / 2.0));
            let share = match edge {
                _ if angle < border => 0.0,
                SpotEdge::Sharp => 1.0,
                SpotEdge::Soft => 0.5 + 0.5 * cos(PI * (1.0 - angle) / (1.0 - border)),
            };
            Some((to_light, share))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::LightTerms;
    use crate::scene::Place;

    /// A lamp in the direction `(x, 0, z)` of a point whose normal and eye are at +z.
    fn lit(material: &Material, source: LightSource) -> Rgb {
        let light = Light { intensity: Some(0.5), ..Light::point(Vec3::ZERO, Rgb::WHITE, Place::default()) };
        let scene = Scene { lights: vec![Light { source, ..light }], ..Scene::default() };
        let choices = Choices { ambient: Some(0.25), light_terms: LightTerms::default(), ..Choices::default() };
        let point = Point { place: Vec3::ZERO, normal: Vec3::Z, to_eye: Vec3::Z };
        Lighting::new(&scene, &choices).reflected(material, &point)
    }

    #[test]
    fn formulas_by_hand() {
        // cos 60 = 1/2 for the diffuse term and, mirrored, for the highlight.
        let slanted = LightSource::Directional { to_light: Vec3::new(0.75_f64.sqrt(), 0.0, 0.5) };
        let nff = Material { diffuse: 0.5, specular: 0.25, shine: 2.0, ..Material::default() };
        let close = |light: Rgb, expected: f64| assert!((light.r - expected).abs() < 1e-15, "{light:?} {expected}");
        close(lit(&nff, slanted), 0.25 * 0.5 + 0.5 * 0.5 * 0.5 + 0.25 * 0.5 * 0.25);
        let phong = Material { reflection: Reflection::Phong, ambient: Some(2.0), ..nff };
        close(lit(&phong, slanted), 1.0);
        let basic = Material { reflection: Reflection::Basic { c3: 0.5 }, ambient: Some(0.125), ..nff };
        let q = 0.25 * 0.5 / (0.25 * (0.25 - 1.0) + 1.0);
        close(lit(&basic, slanted), 0.125 + 0.25 + 0.25 * 0.5 * q);
        // From behind NFF keeps the ambient; so does phong, whose highlight would need the eye on that side, too.
        close(lit(&nff, LightSource::Directional { to_light: Vec3::NEG_Z }), 0.125);
        // Aimed so that the point lies halfway between axis and border, in cosines; then beyond the border.
        let border = 0.5_f64.sqrt();
        let aimed = |cosine: f64, edge| {
            let at = Vec3::Z + Vec3::new((1.0 - cosine * cosine).sqrt(), 0.0, -cosine);
            LightSource::Spot { position: Vec3::Z, at, opening: 90.0, edge }
        };
        let dull = Material { specular: 0.0, ..nff };
        close(lit(&dull, aimed((1.0 + border) / 2.0, SpotEdge::Sharp)), 0.125 + 0.25);
        close(lit(&dull, aimed((1.0 + border) / 2.0, SpotEdge::Soft)), 0.125 + 0.125);
        close(lit(&dull, aimed(border - 0.01, SpotEdge::Soft)), 0.125);
    }

    #[test]
    fn only_sipp_has_highlights_on_the_dark_side() {
        // Light from 0.6 below the surface, mirrored to 0.8 along the view.
        let source = LightSource::Directional { to_light: Vec3::new(-0.8, 0.0, -0.6) };
        let light = Light { source, intensity: Some(1.0), ..Light::point(Vec3::ZERO, Rgb::WHITE, Place::default()) };
        let scene = Scene { lights: vec![light], ..Scene::default() };
        let choices = Choices { ambient: Some(0.0), ..Choices::default() };
        let point = Point { place: Vec3::ZERO, normal: Vec3::Z, to_eye: Vec3::X };
        let lit = |reflection| {
            let material = Material { reflection, specular: 0.5, shine: 2.0, ..Material::default() };
            Lighting::new(&scene, &choices).reflected(&material, &point).r
        };
        assert_eq!(lit(Reflection::Nff), 0.0);
        assert!((lit(Reflection::Phong) - 0.32).abs() < 1e-15);
    }
}
