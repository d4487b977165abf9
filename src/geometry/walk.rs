//! Walk: the vertices of a surface, moved to eye space and classified, once each.
//!
//! Scene -> WALK -> EyePolygon -> cull
//!
//! Why once: gears' 144-gons and teapot's triangles share vertices; moving, classifying and lighting a shared vertex
//! again for each polygon would be the largest cost of the stage.
//! Why an outcode: one bit a plane, set where the vertex lies outside. The AND over a polygon's corners tells that it is
//! wholly outside one plane, the OR which planes it crosses; only those are ever cut.
//!
//! Space: local -> world -> (world - eye) -> eye space, in f64.

use crate::color::Rgb;
use crate::math::{Affine3, Mat3, Vec3, unit};
use crate::model::segments::Lens;
use crate::model::{self, Detail};
use crate::plan::{ClipPlane, FlatRule, Plan, View, is_outside};
use crate::report::Work;
use crate::scene::{Mesh, NormalSource, Primitive, Shape};

/// The vertices of a [`Mesh`] in eye space.
#[derive(Default)]
pub(super) struct EyeMesh {
    pub positions: Vec<Vec3>,
    /// Unit normals on the front side; zero where none is given. Empty where nothing needs them.
    pub normals: Vec<Vec3>,
    /// Factors on the color of the surface, linear light; empty where the mesh has none, or none is needed.
    pub colors: Vec<Rgb>,
    /// Bits of the planes a vertex lies outside of; empty where no plane needs testing.
    codes: Vec<u8>,
    /// Light of a vertex seen from the front and from the back, once it was asked for.
    pub lit: [Vec<Option<Rgb>>; 2],
    local_normals: Vec<Vec3>,
}

impl EyeMesh {
    /// Moves every vertex of `mesh` to eye space and computes what the plan needs of it.
    pub fn fill(&mut self, mesh: &Mesh, world_from_local: &Affine3, plan: &Plan, work: &mut Work) {
        let view = &plan.view;
        self.positions.clear();
        let local = mesh.vertices.iter();
        self.positions.extend(local.map(|&vertex| view.to_eye(world_from_local.transform_point3(vertex))));
        work.vertices_transformed += mesh.vertices.len() as u64;
        self.classify(view, plan.needs.clip, work);
        self.lit.iter_mut().for_each(|side| {
            side.clear();
            side.resize(if plan.needs.light { mesh.vertices.len() } else { 0 }, None);
        });
        self.normals.clear();
        self.colors.clear();
        if plan.needs.light {
            self.colors.extend(mesh.colors.iter().map(|&color| plan.choices.encoding.decode(color)));
            self.turn_normals(mesh, world_from_local, plan, work);
        }
    }

    /// OR and AND of the outcodes of `outline`.
    pub fn outcodes(&self, outline: &[u32]) -> (u8, u8) {
        if self.codes.is_empty() {
            return (0, 0);
        }
        outline
            .iter()
            .map(|&index| self.codes[index as usize])
            .fold((0, 0xFF), |(any, all), code| (any | code, all & code))
    }

    fn classify(&mut self, view: &View, planes: u8, work: &mut Work) {
        self.codes.clear();
        if planes == 0 {
            return;
        }
        let (kx, ky) = view.clip_from_eye();
        work.plane_tests += self.positions.len() as u64 * u64::from(planes.count_ones());
        self.codes.extend(self.positions.iter().map(|eye| {
            // The same products as the clipper sees, so that both agree on what lies on a plane.
            let (x, y, w) = (eye.x * kx, eye.y * ky, eye.z);
            let outside = [w < view.hither, x < -w, x > w, y < -w, y > w, w > view.yon];
            let bits = ClipPlane::ALL.into_iter().zip(outside).filter(|&(_, outside)| outside);
            bits.fold(0, |code, (plane, _)| code | plane.bit()) & planes
        }));
    }

    fn turn_normals(&mut self, mesh: &Mesh, world_from_local: &Affine3, plan: &Plan, work: &mut Work) {
        let view = &plan.view;
        // SIPP knew no facets: its flat shading takes the mean there, too.
        let with_mean: &[NormalSource] = match plan.choices.flat {
            FlatRule::Face | FlatRule::Vertex => &[NormalSource::Averaged],
            FlatRule::Sipp => &[NormalSource::Averaged, NormalSource::Facet],
        };
        model::vertex_normals(mesh, with_mean, &mut self.local_normals);
        // Only directions matter: a normal that a singular map leaves without one is given up for the polygon's own.
        let identity = world_from_local.matrix3 == Mat3::IDENTITY;
        let world_normals = model::normals_from(world_from_local).unwrap_or(Mat3::ZERO);
        let to_eye = |&normal: &Vec3| view.eye_from_world * turned(normal, &world_normals, identity);
        self.normals.extend(self.local_normals.iter().map(to_eye));
        work.normals += self.normals.len() as u64;
    }
}

/// A normal in world space; under the identity the very same bits.
fn turned(normal: Vec3, world_normals: &Mat3, identity: bool) -> Vec3 {
    if identity || normal == Vec3::ZERO { normal } else { unit(*world_normals * normal).unwrap_or(Vec3::ZERO) }
}

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
