//! The list of screen polygons of one picture.

use super::shared::Shared;
use super::{EdgeKind, Grid, Plane, Precision, ScreenPolygon, ScreenVertex, Shader};
use crate::math::Vec3;
use crate::plan::{DepthFormat, Interpolation, Varying};

/// Everything a rasterizer needs to draw one picture: polygons in scene order, planes, and the shader.
///
/// All numbers are in samples: with A x A samples a pixel the list is A times the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawList {
    /// Samples across.
    pub width: u32,
    /// Samples down.
    pub height: u32,
    /// Scene units in one unit of eye space, a power of two: 1 unless hither is extreme. Depth, w and eye points are in it.
    pub unit: f64,
    /// What vertices are snapped to.
    pub grid: Grid,
    /// What varies over a polygon.
    pub varying: Varying,
    /// Whether what varies is linear in space, on the screen, or along edges and scan lines.
    pub interpolation: Interpolation,
    /// Digits of the planes.
    pub precision: Precision,
    /// From 1/w to the depth that is compared.
    pub depth_mapping: DepthMapping,
    /// Polygons have planes; without them (wire) there is no depth and nothing varies.
    pub has_depth: bool,
    /// Some surface is not opaque: the target keeps lists.
    pub has_blending: bool,
    /// Turns what varies into color.
    pub shader: Shader,
    /// Corners of all polygons, one polygon behind the other.
    pub vertices: Vec<ScreenVertex>,
    /// What varies at the corners: `varying.count()` numbers a vertex.
    pub values: Vec<f64>,
    /// Depth plane and varying planes; triangles of one affine polygon share theirs.
    pub planes: Vec<Plane>,
    /// The polygons.
    pub polygons: Vec<PolygonRecord>,
    /// Triangles that are kept as indices: none unless a rasterizer reads them ([`crate::raster::Rasterizer::reads_shared`]). What
    /// concerns them is not in the arrays above; [`DrawList::whole`] has it there.
    pub shared: Shared,
}

/// One polygon's place in the arrays of a [`DrawList`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PolygonRecord {
    /// Its first corner in [`DrawList::vertices`].
    pub first_vertex: u32,
    /// How many corners it has.
    pub vertex_count: u32,
    /// Its depth plane in [`DrawList::planes`]; the varying planes follow.
    pub first_plane: u32,
    /// Its surface in the shader.
    pub surface: u32,
    /// Where it comes from.
    pub source: Source,
}

/// Where a screen polygon comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Source {
    /// 1-based line of its polygon or shape, in the file of its surface; 0: unknown.
    pub line: u32,
    /// Number of the polygon within its surface, from 0; of the shape for tessellated ones.
    pub number: u32,
    /// It is a piece of a sphere or cone.
    pub tessellated: bool,
}

/// From 1/w to the depth that is stored and compared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DepthMapping {
    /// The format.
    pub format: DepthFormat,
    /// 1 / hither: the nearest.
    pub nearest: f64,
    /// 1 / yon: the farthest.
    pub farthest: f64,
}

impl DepthMapping {
    /// Depth of a sample at 1/w: itself, or the nearest of 2^k - 1 steps from yon (1) to hither; 0 stays infinitely far.
    #[must_use]
    #[inline]
    pub fn apply(&self, inverse_w: f64) -> f64 {
        let steps = match self.format {
            DepthFormat::F32 | DepthFormat::F64 => return inverse_w,
            DepthFormat::Int24 => f64::from((1 << 24) - 1),
            DepthFormat::Int16 => f64::from((1 << 16) - 1),
        };
        let share = (inverse_w - self.farthest) / (self.nearest - self.farthest);
        (1.0 + share * (steps - 1.0)).round().clamp(1.0, steps)
    }
}

impl DrawList {
    /// An empty list of `width` x `height` samples that carries colors in single precision on an n.8 grid.
    #[must_use]
    pub fn new(width: u32, height: u32) -> DrawList {
        DrawList {
            width,
            height,
            unit: 1.0,
            grid: Grid { bits: 8 },
            varying: Varying::Color,
            interpolation: Interpolation::Perspective,
            precision: Precision::Single,
            depth_mapping: DepthMapping { format: DepthFormat::F32, nearest: 1.0, farthest: 0.0 },
            has_depth: true,
            has_blending: false,
            shader: Shader::default(),
            vertices: Vec::new(),
            values: Vec::new(),
            planes: Vec::new(),
            polygons: Vec::new(),
            shared: Shared::default(),
        }
    }

    /// Empties it and keeps its memory for the next frame.
    pub fn clear(&mut self) {
        self.vertices.clear();
        self.values.clear();
        self.planes.clear();
        self.polygons.clear();
        self.shared.clear();
    }

    /// Takes over what holds for all polygons of `other`, but not its shader.
    pub(super) fn take_setting(&mut self, other: &DrawList) {
        (self.width, self.height, self.unit) = (other.width, other.height, other.unit);
        (self.grid, self.varying, self.interpolation) = (other.grid, other.varying, other.interpolation);
        (self.precision, self.depth_mapping) = (other.precision, other.depth_mapping);
        (self.has_depth, self.has_blending) = (other.has_depth, other.has_blending);
    }

    /// A depth of this list in scene units, 1/w as people know it; integer steps stay what they are.
    #[must_use]
    pub fn depth_in_scene_units(&self, depth: f64) -> f64 {
        match self.depth_mapping.format {
            DepthFormat::F32 | DepthFormat::F64 => depth / self.unit,
            DepthFormat::Int16 | DepthFormat::Int24 => depth,
        }
    }

    /// The same list with eye space measured in another `unit`, a power of two: the picture is the same as long as no number
    /// leaves its range.
    #[must_use]
    pub fn in_unit(&self, unit: f64) -> DrawList {
        let mut list = DrawList { unit, ..self.whole().clone() };
        let lengths = self.unit / unit;
        list.depth_mapping.nearest /= lengths;
        list.depth_mapping.farthest /= lengths;
        list.vertices.iter_mut().for_each(|vertex| vertex.homogeneous *= lengths);
        list.shader.lights.iter_mut().for_each(|light| light.scale_lengths(lengths));
        let numbers = self.varying.count();
        for values in list.values.chunks_exact_mut(numbers.max(1)) {
            let numbers = values.iter_mut().enumerate();
            numbers.filter(|&(number, _)| self.varying.is_eye_point(number)).for_each(|(_, value)| *value *= lengths);
        }
        let perspective = self.interpolation == Interpolation::Perspective;
        for planes in list.planes.chunks_exact_mut(1 + numbers) {
            planes[0].scale(1.0 / lengths, 1.0 / lengths);
            for (number, plane) in planes[1..].iter_mut().enumerate() {
                plane.scale_varying(self.varying.is_eye_point(number), perspective, lengths);
            }
        }
        list
    }

    /// Drops vertices, values and planes that no polygon uses any more, after polygons were taken out.
    pub fn compact(&mut self) {
        let whole = self.whole().clone();
        self.clear();
        let planes_each = if self.has_depth { 1 + self.varying.count() } else { 0 };
        for (index, record) in whole.polygons.iter().enumerate() {
            let polygon = whole.polygon(index);
            let (first_vertex, first_plane) = (self.vertices.len() as u32, self.planes.len() as u32);
            self.vertices.extend_from_slice(polygon.vertices());
            (0..polygon.vertices().len())
                .for_each(|corner| self.values.extend_from_slice(polygon.vertex_values(corner)));
            let planes = record.first_plane as usize..record.first_plane as usize + planes_each;
            self.planes.extend_from_slice(&whole.planes[planes]);
            self.polygons.push(PolygonRecord { first_vertex, first_plane, ..*record });
        }
    }

    /// How many polygons it has.
    #[must_use]
    pub fn len(&self) -> usize {
        self.polygons.len()
    }

    /// Whether it has none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.polygons.is_empty()
    }

    /// The polygon at `index`.
    ///
    /// # Panics
    /// If there is no such polygon.
    #[must_use]
    #[inline]
    pub fn polygon(&self, index: usize) -> ScreenPolygon<'_> {
        ScreenPolygon::new(self.whole(), index)
    }

    /// The polygon at `index`, which is none of the shared triangles.
    #[inline]
    pub(crate) fn polygon_in_arrays(&self, index: usize) -> ScreenPolygon<'_> {
        ScreenPolygon::new(self, index)
    }

    /// All polygons, in scene order.
    pub fn polygons(&self) -> impl ExactSizeIterator<Item = ScreenPolygon<'_>> {
        let whole = self.whole();
        (0..self.polygons.len()).map(move |index| ScreenPolygon::new(whole, index))
    }

    /// Adds a flat, opaque polygon that faces the viewer at distance 1/`depth`: for tests and small experiments.
    ///
    /// `corners` are in samples and are snapped; `color` is linear light.
    pub fn push_flat(&mut self, corners: &[(f64, f64)], depth: f64, color: [f64; 3]) {
        let surface = self.shader.push_unlit_surface();
        let first_vertex = self.vertices.len() as u32;
        for &(x, y) in corners {
            let homogeneous = Vec3::new(x, y, 1.0) / depth;
            self.vertices.push(ScreenVertex {
                x: self.grid.snap(x),
                y: self.grid.snap(y),
                homogeneous,
                edge: EdgeKind::Original,
            });
            self.values.extend_from_slice(&color[..self.varying.count().min(3)]);
            self.values.resize(self.values.len() + self.varying.texture_count(), 0.0);
        }
        let first_plane = self.planes.len() as u32;
        self.planes.push(Plane::constant(depth, self.precision));
        self.planes.extend(color.map(|channel| Plane::constant(channel, self.precision)));
        self.planes.resize(self.planes.len() + self.varying.texture_count(), Plane::constant(0.0, self.precision));
        let vertex_count = corners.len() as u32;
        self.polygons.push(PolygonRecord {
            first_vertex,
            vertex_count,
            first_plane,
            surface,
            source: Source::default(),
        });
    }
}
