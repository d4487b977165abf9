//! Project: from clip space to the screen.
//!
//! light -> SPLIT, PROJECT -> ScreenPolygon -> rasterizer
//!
//! Corners are divided by w, moved to samples and snapped; `planes` makes the planes of depth and of everything that varies.
//!
//! Space: clip space in, samples out.
//! Cost: two divisions and two roundings a corner.

use super::planes::Planes;
use super::split::{SplitReport, SplitScratch, split};
use crate::math::Vec3;
use crate::plan::{DepthFormat, Interpolation, Plan, Varying};
use crate::screen::{DepthMapping, DrawList, EdgeKind, Grid, PolygonRecord, Precision, ScreenVertex, Source};

/// A vertex made ready for the screen.
#[derive(Clone, Copy)]
pub(super) struct Ready {
    pub screen: ScreenVertex,
    /// Clip space taken back to eye space: nearly where the vertex comes from, and what planes are made of.
    pub eye: Vec3,
    /// 1/w.
    pub inverse_w: f64,
}

/// A corner of a polygon on its way to the screen.
#[derive(Clone, Copy, Default)]
pub(super) struct Corner {
    pub ready: Ready,
    /// What varies: a color, or a normal.
    pub values: [f64; 3],
    /// u, v of its texture; 0 where the plan needs none.
    pub place: [f64; 2],
    /// What the color of the surface is multiplied with where it is lit later; 0 where it is not, or has one color.
    pub factor: [f64; 3],
}

/// A polygon ready for the screen: what clipping left of it, and, as far as its planes need it, what it was before.
pub(super) struct Outline<'a> {
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

/// Turns clipped polygons into screen polygons: what holds for all of a frame.
#[derive(Clone, Copy)]
pub(super) struct Projector {
    /// Factors from eye x, y to clip x, y.
    pub clip_from_eye: (f64, f64),
    planes: Planes,
}

/// Memory for polygons that are split.
#[derive(Default)]
pub(super) struct Triangles {
    eye: Vec<Vec3>,
    list: Vec<[u32; 3]>,
    scratch: SplitScratch,
}

/// From eye and clip space to samples.
#[derive(Clone, Copy)]
pub(super) struct ScreenMap {
    half: (f64, f64),
    scale: f64,
    grid: Grid,
    pub precision: Precision,
    pub perspective: bool,
}

/// What is the same at all corners of a polygon before clipping, number by number.
pub(super) struct Constants {
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
    /// A corner that fixes what is linear over the polygon.
    #[inline(always)]
    pub fn fixing(&self, corner: usize) -> &Corner {
        if self.affine && !self.from_clipped { &self.before[corner] } else { &self.clipped[corner] }
    }
}

impl Projector {
    pub fn new(plan: &Plan) -> Projector {
        let choices = &plan.choices;
        let precision = if choices.depth == DepthFormat::F64 { Precision::Double } else { Precision::Single };
        let screen = ScreenMap {
            half: plan.view.half(),
            scale: plan.view.scale,
            // Lines lie on a grid, on the finest if nothing is to be snapped.
            grid: if plan.is_unsnapped() { Grid::EXACT } else { Grid { bits: choices.subpixel_bits.min(16) } },
            precision,
            perspective: choices.interpolation == Interpolation::Perspective,
        };
        let scan_line = choices.interpolation == Interpolation::ScanLine;
        let planes = Planes { screen, varying: plan.varying(), has_depth: plan.needs.depth, scan_line };
        Projector { clip_from_eye: plan.view.clip_from_eye(), planes }
    }

    /// Empties `list` and sets what holds for all its polygons.
    pub fn prepare(&self, plan: &Plan, list: &mut DrawList) {
        list.clear();
        (list.width, list.height) = plan.view.sample_size();
        list.unit = plan.view.unit;
        list.grid = self.planes.screen.grid;
        list.precision = self.planes.screen.precision;
        list.varying = self.planes.varying;
        list.interpolation = plan.choices.interpolation;
        list.has_depth = self.planes.has_depth;
        list.has_blending = plan.needs.blending;
        let (nearest, farthest) = (1.0 / plan.view.hither, 1.0 / plan.view.yon);
        list.depth_mapping = DepthMapping { format: plan.choices.depth, nearest, farthest };
    }

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

    /// Adds a polygon to `list`, whole.
    #[inline(always)]
    pub fn emit(&self, outline: &Outline<'_>, (surface, source): (u32, Source), list: &mut DrawList) {
        let first_plane = self.planes.push(outline, [0, 1, 2], &mut list.planes);
        let (first_vertex, vertex_count) = (list.vertices.len() as u32, outline.clipped.len() as u32);
        for corner in outline.clipped {
            list.vertices.push(corner.ready.screen);
            self.push_values(corner, &mut list.values);
        }
        list.polygons.push(PolygonRecord { first_vertex, vertex_count, first_plane, surface, source });
    }

    /// Adds a polygon of four corners or more to `list`, in triangles.
    pub fn emit_triangles(
        &self,
        outline: &Outline<'_>,
        owner: (u32, Source),
        triangles: &mut Triangles,
        list: &mut DrawList,
    ) -> SplitReport {
        triangles.list.clear();
        triangles.eye.clear();
        triangles.eye.extend(outline.clipped.iter().map(|corner| corner.ready.eye));
        let report = split(&triangles.eye, outline.newell, &mut triangles.scratch, &mut triangles.list);
        // Triangles of a polygon over which everything is linear share its planes: the picture is that of the whole.
        let shared = outline.affine.then(|| self.planes.push(outline, [0, 1, 2], &mut list.planes));
        for &triangle in &triangles.list {
            let first_plane = shared.unwrap_or_else(|| self.planes.push(outline, triangle, &mut list.planes));
            self.push_triangle(outline, triangle, (first_plane, owner), list);
        }
        report
    }

    fn push_triangle(
        &self,
        outline: &Outline<'_>,
        triangle: [u32; 3],
        (first_plane, (surface, source)): (u32, (u32, Source)),
        list: &mut DrawList,
    ) {
        let first_vertex = list.vertices.len() as u32;
        let count = outline.clipped.len() as u32;
        for (from, to) in [(0, 1), (1, 2), (2, 0)] {
            let corner = &outline.clipped[triangle[from] as usize];
            let is_original = triangle[to] == (triangle[from] + 1) % count;
            let edge = if is_original { corner.ready.screen.edge } else { EdgeKind::Diagonal };
            list.vertices.push(ScreenVertex { edge, ..corner.ready.screen });
            self.push_values(corner, &mut list.values);
        }
        list.polygons.push(PolygonRecord { first_vertex, vertex_count: 3, first_plane, surface, source });
    }

    #[inline(always)]
    fn push_values(&self, corner: &Corner, values: &mut Vec<f64>) {
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
