//! Corner: a corner of a polygon between clip space and the screen, and what planes are made of.
//!
//! clip space -CORNER-> ScreenVertex, planes
//!
//! Why here and not in the geometry stage: shared triangles ([`super::Shared`]) get their vertices and planes when they are asked for, by the
//! same functions as all others when the list is made.
//!
//! Space: clip space in, samples out. Cost: five divisions and two roundings a corner.

use super::linear::Planes;
use super::{EdgeKind, Grid, Precision, ScreenVertex};
use crate::math::Vec3;
use crate::plan::Varying;

/// A vertex made ready for the screen.
#[derive(Clone, Copy)]
pub(crate) struct Ready {
    pub screen: ScreenVertex,
    /// Clip space taken back to eye space: nearly where the vertex comes from, and what planes are made of.
    pub eye: Vec3,
    /// 1/w.
    pub inverse_w: f64,
}

/// A corner of a polygon on its way to the screen.
#[derive(Clone, Copy, Default)]
pub(crate) struct Corner {
    pub ready: Ready,
    /// What varies: a color, or a normal.
    pub values: [f64; 3],
    /// u, v of its texture; 0 where the plan needs none.
    pub place: [f64; 2],
    /// What the color of the surface is multiplied with where it is lit later; 0 where it is not, or has one color.
    pub factor: [f64; 3],
}

/// A polygon ready for the screen: what clipping left of it, and, as far as its planes need it, what it was before.
pub(crate) struct Outline<'a> {
    /// Its corners before clipping.
    pub before: &'a [Corner],
    /// The corners that are left; the same ones where nothing was cut.
    pub clipped: &'a [Corner],
    /// What varies is taken from the clipped vertices.
    pub from_clipped: bool,
    /// Newell normal, eye space.
    pub newell: Vec3,
    /// What varies is linear over it.
    pub affine: bool,
}

/// From clip space to the screen and to planes: what holds for all of a list.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Projection {
    /// Factors from eye x, y to clip x, y.
    pub clip_from_eye: (f64, f64),
    pub planes: Planes,
}

/// From eye and clip space to samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ScreenMap {
    pub half: (f64, f64),
    pub scale: f64,
    pub grid: Grid,
    pub precision: Precision,
    pub perspective: bool,
}

/// What is the same at all corners of a polygon before clipping, number by number.
pub(crate) struct Constants {
    values: [Option<f64>; 3],
    place: [Option<f64>; 2],
    factor: [Option<f64>; 3],
}

impl Constants {
    /// Gives a corner the numbers that are the same all over its polygon: to the last bit, also where clipping made it.
    #[inline(always)]
    pub fn hold(&self, corner: &mut Corner) {
        hold(&mut corner.values, self.values);
        hold(&mut corner.place, self.place);
        hold(&mut corner.factor, self.factor);
    }
}

#[inline(always)]
fn hold<const N: usize>(values: &mut [f64; N], constants: [Option<f64>; N]) {
    for (value, constant) in values.iter_mut().zip(constants) {
        *value = constant.unwrap_or(*value);
    }
}

/// The numbers that are the same at all `corners`; none where there are no corners.
#[inline(always)]
fn same<const N: usize>(corners: &[Corner], of: impl Fn(&Corner) -> [f64; N]) -> [Option<f64>; N] {
    let mut constants = [None; N];
    if let Some(first) = corners.first() {
        for (number, constant) in constants.iter_mut().enumerate() {
            let value = of(first)[number];
            *constant = corners.iter().all(|corner| of(corner)[number] == value).then_some(value);
        }
    }
    constants
}

impl Default for Ready {
    fn default() -> Self {
        let (homogeneous, edge) = (Vec3::ZERO, EdgeKind::Original);
        Ready { screen: ScreenVertex { x: 0.0, y: 0.0, homogeneous, edge }, eye: Vec3::ZERO, inverse_w: 0.0 }
    }
}

impl Outline<'_> {
    /// The functional of 1/w over the screen: n/d, from the polygon as it was before clipping.
    #[inline(always)]
    pub fn inverse_w(&self) -> Vec3 {
        self.newell / self.newell.dot(self.before[0].ready.eye)
    }

    /// A corner that fixes what is linear over the polygon.
    #[inline(always)]
    pub fn fixing(&self, corner: usize) -> &Corner {
        if self.affine && !self.from_clipped { &self.before[corner] } else { &self.clipped[corner] }
    }
}

impl Projection {
    /// An eye-space position in clip space.
    #[inline]
    pub fn clip_space(&self, eye: Vec3) -> Vec3 {
        let (kx, ky) = self.clip_from_eye;
        Vec3::new(eye.x * kx, eye.y * ky, eye.z)
    }

    /// A vertex in clip space, made ready for the screen.
    #[inline]
    pub fn ready(&self, clip: Vec3, edge: EdgeKind) -> Ready {
        let (kx, ky) = self.clip_from_eye;
        let eye = Vec3::new(clip.x / kx, clip.y / ky, clip.z);
        Ready { screen: self.planes.screen.vertex(clip, edge), eye, inverse_w: 1.0 / clip.z }
    }

    /// Gives the vertices that are left the numbers that are the same at all corners before clipping: they stay the same, to the
    /// last bit.
    #[inline(always)]
    pub fn constants(&self, before: &[Corner]) -> Constants {
        let varying = self.planes.varying;
        let when = |is_there: bool| if is_there { before } else { &[] };
        Constants {
            values: same(when(varying != Varying::Nothing), |corner| corner.values),
            place: same(when(varying.texture_count() > 0), |corner| corner.place),
            factor: same(when(varying.has_factor()), |corner| corner.factor),
        }
    }

    /// Adds the numbers that vary, at a corner.
    #[inline(always)]
    pub fn push_values(&self, corner: &Corner, values: &mut Vec<f64>) {
        if self.planes.varying == Varying::Nothing {
            return;
        }
        values.extend_from_slice(&corner.values);
        if self.planes.varying.has_normals() {
            values.extend_from_slice(&corner.ready.eye.to_array());
        }
        if self.planes.varying.has_factor() {
            values.extend_from_slice(&corner.factor);
        }
        if self.planes.varying.texture_count() > 0 {
            values.extend_from_slice(&corner.place);
        }
    }
}

impl ScreenMap {
    /// A clip-space position on the screen, snapped.
    #[inline]
    fn vertex(&self, clip: Vec3, edge: EdgeKind) -> ScreenVertex {
        let (half_width, half_height) = self.half;
        let homogeneous = Vec3::new((clip.z + clip.x) * half_width, (clip.z - clip.y) * half_height, clip.z);
        if self.grid.is_exact() {
            // Not held in the picture: it was not clipped to it.
            let (x, y) = (homogeneous.x / clip.z, homogeneous.y / clip.z);
            return ScreenVertex { x, y, homogeneous, edge };
        }
        // Rounding may leave a vertex on the right or lower side a hair outside; snapping brings it back.
        let (x, y) = (self.grid.snap(homogeneous.x / clip.z), self.grid.snap(homogeneous.y / clip.z));
        ScreenVertex { x: x.clamp(0.0, 2.0 * half_width), y: y.clamp(0.0, 2.0 * half_height), homogeneous, edge }
    }

    /// An eye-space point on the screen, not snapped; z is 0.
    #[inline(always)]
    pub fn exact(&self, eye: Vec3) -> Vec3 {
        let (half_width, half_height) = self.half;
        Vec3::new(half_width + eye.x / eye.z * self.scale, half_height - eye.y / eye.z * self.scale, 0.0)
    }

    /// Coefficients over samples of a functional on (X, Y, 1), X = x/w, Y = y/w.
    #[inline(always)]
    pub fn plane(&self, functional: Vec3) -> [f64; 3] {
        let (a, b) = (functional.x / self.scale, -functional.y / self.scale);
        [a, b, functional.z - a * self.half.0 - b * self.half.1]
    }
}
