//! The shader: what light a point of a surface sends to the eye.
//!
//! lights -> ARRIVING light -> REFLECTION -> color
//!
//! Used by the geometry stage at vertices (flat, Gouraud) and by every rasterizer at samples (Phong), so that both
//! mean the same by "light". `lights` knows what arrives at a point, `reflection` what leaves it, and has the formulas of the
//! three models; this file goes from light to light, and `texture` multiplies it by pictures. `docs/shading.md` explains all of it
//! with pictures. Light is written for one point or several side by side ([`super::lane::Wide`]): the readable path lights one sample at
//! a time, the fast one eight, by the same lines.
//!
//! Space: eye space; the eye is the origin. Colors are linear light.
//! Source: Phong, "Illumination for Computer Generated Pictures", CACM 18(6), 1975, 311-317; coefficients as in NFF and SIPP.
//! Cost: per light one square root, and one power or division where Ks > 0.

mod fade;
mod lights;
mod picture;
mod power;
mod reflection;
mod texture;

pub use lights::{EyeLight, EyeSource, Spot};
pub use picture::{Picture, TextureShading};
pub use reflection::SurfaceShading;
pub(crate) use texture::Seen;
pub use texture::Textures;

use self::lights::Arriving;
use super::lane::{Wide, choose, dot, unit};
use super::{Fragment, ScreenPolygon};
use crate::color::Rgb;
use crate::math::Vec3;
use std::sync::atomic::{AtomicU64, Ordering};

/// Turns interpolated values into color: the lights and surfaces of one picture, in eye space.
#[derive(Debug, Default)]
pub struct Shader {
    /// In the order of the scene.
    pub lights: Vec<EyeLight>,
    /// One entry a placed surface.
    pub surfaces: Vec<SurfaceShading>,
    /// Pictures on surfaces.
    pub textures: Textures,
    /// Highlights are computed even where Ks is 0.
    pub specular_everywhere: bool,
    /// Color of lines, which have no light.
    pub line_color: Rgb<f32>,
    /// How many cosine powers (for `basic`: quotients in their place) were computed: the plan's "not needed" is checked against it.
    powers: AtomicU64,
}

/// Light and coefficients above this count as this: no scene means more, and `f32` and sums of thousands of them stay finite.
pub const BRIGHTEST: f64 = 1e30;

impl Shader {
    /// Forgets lights, surfaces and counts, and keeps its memory for the next frame.
    pub fn clear(&mut self) {
        self.lights.clear();
        self.surfaces.clear();
        let (lights, surfaces) = (std::mem::take(&mut self.lights), std::mem::take(&mut self.surfaces));
        *self = Shader { lights, surfaces, ..Shader::default() };
    }

    /// Light that the point `eye` of a surface with unit normal `normal` sends to the eye, which stands at the origin.
    ///
    /// NFF's model is not clamped: a value above 1 is brighter than the display and is cut once, when the picture is written.
    #[must_use]
    pub fn light(&self, surface: u32, eye: Vec3, normal: Vec3) -> Rgb {
        self.light_and_count(surface, (eye, normal), None)
    }

    /// As [`Shader::light`], where the color of the surface is multiplied with `color`, linear light.
    #[must_use]
    pub fn light_colored(&self, surface: u32, point: (Vec3, Vec3), color: Rgb) -> Rgb {
        self.light_and_count(surface, point, Some(color))
    }

    fn light_and_count(&self, surface: u32, point: (Vec3, Vec3), factor: Option<Rgb>) -> Rgb {
        let mut powers = 0;
        let light = self.light_at(surface, point, factor, &mut powers);
        self.add_powers(powers);
        light
    }

    /// As [`Shader::light`]; highlights are added to `powers`, for many points to be counted at once ([`Shader::add_powers`]).
    #[inline]
    pub(crate) fn light_at(
        &self,
        surface: u32,
        (eye, normal): (Vec3, Vec3),
        factor: Option<Rgb>,
        powers: &mut u64,
    ) -> Rgb {
        let factor = factor.map(|factor| factor.to_array());
        let points = Points { eye: eye.to_array(), normal: normal.to_array(), factor, wanted: true };
        self.light_of(&self.surfaces[surface as usize], points, powers).into()
    }

    /// The same for points side by side, of which those in the mask `wanted` are asked for.
    #[inline(always)]
    pub(crate) fn lights_at<T: Wide>(
        &self,
        surface: u32,
        (eye, normal): ([T; 3], [T; 3]),
        factor: Option<[T; 3]>,
        (wanted, powers): (T::Mask, &mut u64),
    ) -> [T; 3] {
        self.light_of(&self.surfaces[surface as usize], Points { eye, normal, factor, wanted }, powers)
    }

    /// The same for one point or several side by side; highlights are added to `powers`.
    #[inline(always)]
    fn light_of<T: Wide>(&self, surface: &SurfaceShading, points: Points<T>, powers: &mut u64) -> [T; 3] {
        let Points { eye, normal, factor, wanted } = points;
        let zero = eye[0].all(0.0);
        let has_highlight = surface.specular > 0.0 || self.specular_everywhere;
        // Only highlights depend on where the eye stands.
        let view = if has_highlight {
            let (to_eye, is_apart) = unit([zero - eye[0], zero - eye[1], zero - eye[2]]);
            choose(is_apart, to_eye, normal)
        } else {
            normal
        };
        let (mut diffuse, mut specular) = ([zero; 3], [zero; 3]);
        for light in &self.lights {
            let Arriving { to_light, color, arrives } = light.arriving_at(eye);
            let cosine = dot(normal, to_light);
            let faces = cosine.above(zero) & arrives;
            add(&mut diffuse, color, T::choose(faces, cosine, zero));
            let lit = if surface.is_nff() { faces } else { arrives } & wanted;
            if has_highlight && T::count(lit) > 0 {
                let twice = cosine.all(2.0) * cosine;
                let mirrored =
                    [normal[0] * twice - to_light[0], normal[1] * twice - to_light[1], normal[2] * twice - to_light[2]];
                add(&mut specular, color, highlight(surface, dot(mirrored, view), lit, powers));
            }
        }
        surface.sent(diffuse, specular, factor)
    }

    /// The fragment of `polygon` at sample (x, y): depth, color and opacity by the contract's definition.
    ///
    /// Where the surface has a hole it is [`Fragment::hole`]: not to be put. A rasterizer that puts it all the same does no harm, if
    /// it has only asked for depth before.
    #[must_use]
    #[inline]
    pub fn fragment(&self, polygon: &ScreenPolygon<'_>, x: i32, y: i32) -> Fragment {
        self.fragment_from(polygon, (x, y), polygon.inverse_w(x, y), &polygon.values(x, y))
    }

    /// The same from 1/w and interpolated `values`, however a rasterizer came by them: incrementally, say.
    #[must_use]
    #[inline]
    pub fn fragment_from(
        &self,
        polygon: &ScreenPolygon<'_>,
        sample: (i32, i32),
        inverse_w: f64,
        values: &[f64],
    ) -> Fragment {
        let seen = match *values {
            [_, _, _, u, v] | [_, _, _, _, _, _, u, v] => self.seen(polygon, sample, inverse_w, [u, v]),
            _ => Seen::Plain,
        };
        let color = match seen {
            Seen::Plain => self.color(polygon, values),
            Seen::Color(texel) => self.color(polygon, values) * texel,
            // Before any light is computed.
            Seen::Hole => return Fragment::hole(sample.0, sample.1, polygon.index),
        };
        Fragment { color, opacity: self.opacity(polygon), ..polygon.bare_fragment(sample, inverse_w) }
    }

    /// The color of interpolated `values`: themselves, or for normal and eye point the light there; without any picture.
    #[must_use]
    #[inline]
    pub fn color(&self, polygon: &ScreenPolygon<'_>, values: &[f64]) -> Rgb<f32> {
        let mut powers = 0;
        let color = self.color_counting(polygon.surface(), values, &mut powers);
        self.add_powers(powers);
        color
    }

    /// As [`Shader::color`]; highlights are added to `powers`, for many points to be counted at once ([`Shader::add_powers`]).
    #[inline]
    pub(crate) fn color_counting(&self, surface: u32, values: &[f64], powers: &mut u64) -> Rgb<f32> {
        match *values {
            [r, g, b] | [r, g, b, _, _] => Rgb::new(r as f32, g as f32, b as f32),
            [nx, ny, nz, ex, ey, ez] | [nx, ny, nz, ex, ey, ez, _, _] => {
                Rgb::from(self.light_counting(surface, ([nx, ny, nz, ex, ey, ez], None), true, powers)).to_f32()
            }
            [nx, ny, nz, ex, ey, ez, r, g, b] | [nx, ny, nz, ex, ey, ez, r, g, b, _, _] => {
                let values = ([nx, ny, nz, ex, ey, ez], Some([r, g, b]));
                Rgb::from(self.light_counting(surface, values, true, powers)).to_f32()
            }
            _ => self.line_color,
        }
    }

    /// The light of interpolated normals, eye points and, where vertices have them, colors, one or several side by side; where the mask
    /// `wanted` is false, whatever it is.
    #[inline(always)]
    pub(crate) fn light_counting<T: Wide>(
        &self,
        surface: u32,
        ([nx, ny, nz, ex, ey, ez], factor): ([T; 6], Option<[T; 3]>),
        wanted: T::Mask,
        powers: &mut u64,
    ) -> [T; 3] {
        // Interpolated normals are shorter than 1 between the vertices.
        let (unit_normal, has_direction) = unit([nx, ny, nz]);
        let normal = choose(has_direction, unit_normal, [nx.all(0.0), nx.all(0.0), nx.all(-1.0)]);
        let points = Points { eye: [ex, ey, ez], normal, factor, wanted };
        self.light_of(&self.surfaces[surface as usize], points, powers)
    }

    /// The opacity of the polygon's surface.
    #[must_use]
    #[inline]
    pub fn opacity(&self, polygon: &ScreenPolygon<'_>) -> Rgb<f32> {
        self.opacity_of(polygon.surface())
    }

    /// The opacity of a surface.
    #[must_use]
    #[inline]
    pub(crate) fn opacity_of(&self, surface: u32) -> Rgb<f32> {
        self.surfaces.get(surface as usize).map_or(Rgb::gray(1.0), |surface| surface.opacity)
    }

    /// Highlights computed so far: cosine powers, or the quotients of `basic`.
    #[must_use]
    pub fn powers(&self) -> u64 {
        self.powers.load(Ordering::Relaxed)
    }

    /// Counts highlights.
    #[inline]
    pub(crate) fn add_powers(&self, powers: u64) {
        if powers > 0 {
            self.powers.fetch_add(powers, Ordering::Relaxed);
        }
    }

    /// Adds an opaque surface that no light reaches, and returns its index.
    pub fn push_unlit_surface(&mut self) -> u32 {
        self.surfaces.push(SurfaceShading { opacity: Rgb::gray(1.0), ..SurfaceShading::default() });
        (self.surfaces.len() - 1) as u32
    }
}

/// Points of one surface, side by side.
struct Points<T: Wide> {
    /// Eye space.
    eye: [T; 3],
    /// Unit.
    normal: [T; 3],
    /// What the color of the surface is multiplied with, linear light.
    factor: Option<[T; 3]>,
    /// Of which points the light is asked for.
    wanted: T::Mask,
}

/// Adds `color` times `share`.
#[inline(always)]
fn add<T: Wide>(sum: &mut [T; 3], color: [T; 3], share: T) {
    *sum = [sum[0] + color[0] * share, sum[1] + color[1] * share, sum[2] + color[2] * share];
}

/// Highlights of `surface` at the points that are `lit`, where the mirrored light and the eye are `cosine` apart; none where it is not
/// above 0.
#[inline(always)]
fn highlight<T: Wide>(surface: &SurfaceShading, cosine: T, lit: T::Mask, powers: &mut u64) -> T {
    let [zero, one] = [cosine.all(0.0), cosine.all(1.0)];
    // NFF's power 0 is 1 everywhere.
    let is_everywhere = surface.is_nff() && surface.shine <= 0.0;
    let shows = if is_everywhere { lit } else { lit & cosine.above(zero) };
    let count = T::count(shows);
    if count == 0 {
        return zero;
    }
    *powers += u64::from(count);
    // Rounding may give a cosine just above 1; a large power would make light out of it.
    T::choose(shows, surface.highlight(cosine.hold(zero, one)), zero)
}

impl Clone for Shader {
    fn clone(&self) -> Self {
        Shader {
            lights: self.lights.clone(),
            surfaces: self.surfaces.clone(),
            textures: self.textures.clone(),
            specular_everywhere: self.specular_everywhere,
            line_color: self.line_color,
            powers: AtomicU64::new(self.powers()),
        }
    }
}

impl PartialEq for Shader {
    /// Equal pictures; how much work was done does not count.
    fn eq(&self, other: &Self) -> bool {
        self.lights == other.lights
            && self.surfaces == other.surfaces
            && self.line_color == other.line_color
            && self.textures == other.textures
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shader(specular: f64, shine: f64) -> Shader {
        let (ambient, diffuse) = (Rgb::gray(0.125), Rgb::new(0.5, 0.25, 0.0));
        let surface =
            SurfaceShading { ambient, diffuse, specular, shine, opacity: Rgb::gray(1.0), ..SurfaceShading::default() };
        Shader { lights: vec![EyeLight::point(Vec3::ZERO, Rgb::WHITE)], surfaces: vec![surface], ..Shader::default() }
    }

    #[test]
    fn a_lamp_at_the_eye_lights_a_face_squarely() {
        // N.L = 1 and R.V = 1: ambient + diffuse + specular.
        let lit = shader(0.25, 8.0).light(0, Vec3::new(0.0, 0.0, 4.0), Vec3::NEG_Z);
        assert_eq!(lit, Rgb::new(0.875, 0.625, 0.375));
    }

    #[test]
    fn at_sixty_degrees_half_the_diffuse_light_remains() {
        let normal = Vec3::new(0.75_f64.sqrt(), 0.0, -0.5);
        let lit = shader(0.0, 0.0).light(0, Vec3::new(0.0, 0.0, 4.0), normal);
        assert!((lit.r - 0.375).abs() < 1e-12 && (lit.g - 0.25).abs() < 1e-12, "{lit:?}");
    }

    #[test]
    fn no_highlight_no_power() {
        let shader = shader(0.0, 8.0);
        let _ = shader.light(0, Vec3::new(0.0, 0.0, 4.0), Vec3::NEG_Z);
        assert_eq!(shader.powers(), 0);
    }

    #[test]
    fn a_light_at_the_point_or_behind_it_leaves_the_ambient() {
        let mut shader = shader(1.0, 0.0);
        assert_eq!(shader.light(0, Vec3::new(0.0, 0.0, 4.0), Vec3::Z), Rgb::gray(0.125));
        shader.lights[0] = EyeLight::point(Vec3::new(0.0, 0.0, 4.0), Rgb::WHITE);
        assert_eq!(shader.light(0, Vec3::new(0.0, 0.0, 4.0), Vec3::NEG_Z), Rgb::gray(0.125));
    }
}
