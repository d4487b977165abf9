//! Project: from clip space to the screen.
//!
//! light -> SPLIT, PROJECT -> ScreenPolygon -> rasterizer
//!
//! Corners are divided by w, moved to samples and snapped; `screen::linear` makes the planes of depth and of everything that varies.
//!
//! Space: clip space in, samples out.
//! Cost: two divisions and two roundings a corner.

use super::split::{SplitReport, SplitScratch, split};
use crate::math::Vec3;
use crate::plan::{DepthFormat, Interpolation, Plan, Varying};
pub(super) use crate::screen::corner::{Corner, Outline, Projection, Ready, ScreenMap};
use crate::screen::linear::Planes;
use crate::screen::{DepthMapping, DrawList, EdgeKind, Grid, PolygonRecord, Precision, ScreenVertex, Source};

/// Turns clipped polygons into screen polygons: what holds for all of a frame.
#[derive(Clone, Copy)]
pub(super) struct Projector(Projection);

impl std::ops::Deref for Projector {
    type Target = Projection;
    #[inline(always)]
    fn deref(&self) -> &Projection {
        &self.0
    }
}

/// Memory for polygons that are split.
#[derive(Default)]
pub(super) struct Triangles {
    eye: Vec<Vec3>,
    list: Vec<[u32; 3]>,
    scratch: SplitScratch,
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
        Projector(Projection { clip_from_eye: plan.view.clip_from_eye(), planes })
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

    /// Lets `list` have shared triangles, if it may: whoever reads them makes planes in `f32`, and has corners in 1/256 of a sample.
    pub fn share(&self, plan: &Plan, list: &mut DrawList) -> bool {
        let Planes { varying, has_depth, scan_line, ref screen } = self.planes;
        let is_lit = varying.without_texture() != Varying::Nothing;
        let on_grid = !screen.grid.is_exact() && screen.grid.bits <= 8;
        let can = has_depth && is_lit && !scan_line && on_grid && plan.choices.depth == DepthFormat::F32;
        list.shared.projection = can.then_some(self.0);
        can
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
}
