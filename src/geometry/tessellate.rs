//! Tessellate: a shape turned into polygons, fine enough for the view.
//!
//! Scene (shapes) -TESSELLATE-> Mesh -> walk
//!
//! `model` knows how to cut a shape up; here it is decided whether and how finely, from where the shape stands.
//!
//! Space: local, in and out; the view is asked in eye space.

use crate::math::Affine3;
use crate::model::segments::Lens;
use crate::model::{self, Detail};
use crate::plan::{Plan, is_outside};
use crate::report::Work;
use crate::scene::{Mesh, Primitive, Shape};

/// Turns shapes into polygons, fine enough for the view; keeps its memory from shape to shape.
#[derive(Default)]
pub(super) struct Tessellator {
    pub mesh: Mesh,
    /// Quads of the shape that became two triangles each, because they are not planar.
    pub nonplanar: u64,
}

impl Tessellator {
    /// Fills `mesh` with the polygons of `primitive`; `false` when it lies outside the view and nothing asks for it.
    pub fn tessellate(
        &mut self,
        primitive: &Primitive,
        world_from_local: &Affine3,
        plan: &Plan,
        work: &mut Work,
    ) -> bool {
        self.mesh.clear();
        if !plan.needs.shapes_outside && is_outside(&primitive.shape, world_from_local, &plan.view) {
            work.shapes_outside += 1;
            return false;
        }
        let detail = detail(primitive, world_from_local, plan);
        self.nonplanar = model::tessellate(&primitive.shape, primitive.inside, detail, primitive.line, &mut self.mesh);
        work.shape_vertices += self.mesh.vertices.len() as u64;
        true
    }
}

/// How finely a shape is cut up: as its file says, as the user fixed it, or so that its silhouette is within the tolerance.
pub(super) fn detail(primitive: &Primitive, world_from_local: &Affine3, plan: &Plan) -> Detail {
    match (primitive.resolution, plan.choices.resolution) {
        (Some(pair), _) => Detail::Grid(pair),
        (None, Some(resolution)) => Detail::Resolution(resolution),
        (None, None) => Detail::Grid(segments(&primitive.shape, world_from_local, plan)),
    }
}

fn segments(shape: &Shape, world_from_local: &Affine3, plan: &Plan) -> [u32; 2] {
    let view = &plan.view;
    let (half_width, half_height) = view.half();
    let corner_tangent_squared = (half_width * half_width + half_height * half_height) / (view.scale * view.scale);
    let lens = Lens {
        // The tolerance is in pixels of the final picture, not in samples.
        pixels_per_unit_tangent: view.scale / f64::from(view.samples),
        hither: view.hither,
        corner_cosine: 1.0 / (1.0 + corner_tangent_squared).sqrt(),
    };
    model::segments::segments(shape, &(view.eye_from_world_affine() * *world_from_local), &lens, plan.choices.tolerance)
}
