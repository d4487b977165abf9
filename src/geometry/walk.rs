//! Walk: the vertices of a surface, moved to eye space and classified, once each, in arrays.
//!
//! Scene -> WALK -> EyePolygon -> cull
//!
//! Why once: gears' 144-gons and teapot's triangles share vertices; moving, classifying and lighting a shared vertex
//! again for each polygon would be the largest cost of the stage.
//! Why an outcode: one bit a plane, set where the vertex lies outside. The AND over a polygon's corners tells that it is
//! wholly outside one plane, the OR which planes it crosses; only those are ever cut.
//! Why asking: vertices are brought to the screen and lit after culling, and only where a polygon in view asks for it. A vertex that
//! was asked for knows its place in an array without gaps; for light it has two, one for each side it is seen from.
//!
//! Space: local -> world -> (world - eye) -> eye space, in f64.

use super::cull::Survivor;
use super::project::{Projector, Ready};
use super::{Part, Setting};
use crate::math::{Affine3, Mat3, Vec3, unit};
use crate::model;
use crate::plan::{FlatRule, NeedsMode, Plan, Shading, View};
use crate::report::Work;
use crate::scene::{Mesh, NormalSource};
use crate::screen::EdgeKind;

/// The vertices of a [`Mesh`] in eye space.
#[derive(Default)]
pub(super) struct EyeMesh {
    pub positions: Vec<Vec3>,
    /// Unit normals on the front side; zero where none is given. Empty where nothing needs them.
    pub normals: Vec<Vec3>,
    /// Bits of the planes a vertex lies outside of; empty where no plane needs testing.
    codes: Vec<u8>,
    /// What survivors asked for, of every vertex.
    slots: Vec<Slot>,
    /// Vertices that are needed on the screen, in the order of asking.
    asked: Vec<u32>,
    /// They, made ready, as far as it is done.
    ready: Vec<Ready>,
    /// Vertices whose light is needed and the side it is needed for.
    asked_light: Vec<(u32, Side)>,
    /// Their light, as far as it has been computed.
    lit: Vec<[f64; 3]>,
    /// Vertices are lit once for all polygons around them.
    lights: bool,
    /// Means of normals, local space.
    means: Vec<Vec3>,
}

/// Where a vertex is in the arrays of what was asked for.
#[derive(Clone, Copy)]
struct Slot {
    ready: u32,
    /// Seen from the front and from the back.
    lit: [u32; 2],
}

const NOT_ASKED: u32 = u32::MAX;

/// The side of a vertex that the eye sees.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    Front,
    Back,
}

/// Some vertices of an [`EyeMesh`]: what one thread fills.
pub(super) struct VertexRange<'a> {
    vertices: &'a [Vec3],
    local_normals: &'a [Vec3],
    positions: &'a mut [Vec3],
    codes: &'a mut [u8],
    normals: &'a mut [Vec3],
}

/// Some of what was asked for: what one thread computes.
pub(super) struct Asked<'a> {
    positions: &'a [Vec3],
    normals: &'a [Vec3],
    asked: &'a [u32],
    ready: &'a mut [Ready],
    asked_light: &'a [(u32, Side)],
    lit: &'a mut [[f64; 3]],
}

impl EyeMesh {
    /// Forgets the mesh before and makes room for `mesh`; its vertices are still to be filled.
    pub fn open<'a>(&'a mut self, mesh: &'a Mesh, setting: &Setting<'_>, work: &mut Work) -> VertexRange<'a> {
        let (count, planes) = (mesh.vertices.len(), setting.plan.needs.clip);
        // Not cleared: every number is written anew.
        self.positions.resize(count, Vec3::ZERO);
        self.codes.resize(if planes == 0 { 0 } else { count }, 0);
        let local_normals = local_normals(mesh, setting.plan, &mut self.means);
        self.normals.resize(local_normals.len(), Vec3::ZERO);
        self.slots.clear();
        self.slots.resize(count, Slot { ready: NOT_ASKED, lit: [NOT_ASKED; 2] });
        self.lights = setting.lighting.lights_vertices() && !self.normals.is_empty();
        // Room for all, so that nothing is copied when more are asked for; what is never asked for costs addresses, not memory.
        let lit = if self.lights { count } else { 0 };
        empty(&mut self.asked, count);
        empty(&mut self.ready, count);
        empty(&mut self.asked_light, lit);
        empty(&mut self.lit, lit);
        work.vertices_transformed += count as u64;
        work.plane_tests += self.codes.len() as u64 * u64::from(planes.count_ones());
        work.normals += local_normals.len() as u64;
        let (positions, codes, normals) = (&mut self.positions, &mut self.codes, &mut self.normals);
        VertexRange { vertices: &mesh.vertices, local_normals, positions, codes, normals }
    }

    /// OR and AND of the outcodes of `outline`.
    #[inline]
    pub fn outcodes(&self, outline: &[u32]) -> (u8, u8) {
        if self.codes.is_empty() {
            return (0, 0);
        }
        let codes = outline.iter().map(|&index| self.codes[index as usize]);
        codes.fold((0, 0xFF), |(any, all), code| (any | code, all & code))
    }

    /// The normal that `polygon`'s kind of light takes at a vertex, if the vertex has one.
    #[inline]
    pub fn normal(&self, vertex: u32) -> Option<Vec3> {
        self.normals.get(vertex as usize).copied().filter(|&normal| normal != Vec3::ZERO)
    }

    /// Asks for the vertices of `survivors`, once each, and for their light, once for each side a vertex is seen from.
    pub fn ask(&mut self, part: Part<'_>, survivors: &[Survivor]) {
        for survivor in survivors {
            let polygon = &part.mesh.polygons[survivor.polygon as usize];
            for &vertex in part.mesh.outline(polygon) {
                let slot = &mut self.slots[vertex as usize];
                if slot.ready == NOT_ASKED {
                    slot.ready = self.asked.len() as u32;
                    self.asked.push(vertex);
                }
            }
            if self.lights && polygon.normals != NormalSource::Facet {
                self.ask_for_light(part.mesh.outline(polygon), Side::of(survivor));
            }
        }
    }

    fn ask_for_light(&mut self, outline: &[u32], side: Side) {
        for &vertex in outline {
            let slot = &mut self.slots[vertex as usize].lit[side as usize];
            // Without a normal of its own it is lit with the polygon's.
            if *slot == NOT_ASKED && self.normals.get(vertex as usize).is_some_and(|&normal| normal != Vec3::ZERO) {
                *slot = self.asked_light.len() as u32;
                self.asked_light.push((vertex, side));
            }
        }
    }

    /// What was asked for and is not computed yet.
    pub fn asked(&mut self) -> Asked<'_> {
        let (ready_before, lit_before) = (self.ready.len(), self.lit.len());
        self.ready.resize(self.asked.len(), Ready::default());
        self.lit.resize(self.asked_light.len(), [0.0; 3]);
        let EyeMesh { positions, normals, asked, ready, asked_light, lit, .. } = self;
        let (asked, asked_light) = (&asked[ready_before..], &asked_light[lit_before..]);
        Asked { positions, normals, asked, ready: &mut ready[ready_before..], asked_light, lit: &mut lit[lit_before..] }
    }

    /// A vertex that was asked for, made ready.
    #[inline]
    pub fn ready(&self, vertex: u32) -> &Ready {
        &self.ready[self.slots[vertex as usize].ready as usize]
    }

    /// The light of a vertex that was asked for.
    #[inline]
    pub fn light(&self, vertex: u32, side: Side) -> [f64; 3] {
        self.lit[self.slots[vertex as usize].lit[side as usize] as usize]
    }
}

/// Forgets what is in `list`, and makes room for `count`.
fn empty<T>(list: &mut Vec<T>, count: usize) {
    list.clear();
    list.reserve(count);
}

/// The normals of `mesh` in local space, given ones and means; none where nothing looks at them.
fn local_normals<'a>(mesh: &'a Mesh, plan: &Plan, means: &'a mut Vec<Vec3>) -> &'a [Vec3] {
    let sipp = plan.choices.flat == FlatRule::Sipp;
    // One color a polygon is the light of its own normal.
    let idle = plan.choices.shading == Shading::Flat
        && plan.choices.flat == FlatRule::Face
        && plan.choices.needs == NeedsMode::Derived;
    if !plan.needs.light || idle {
        return &[];
    }
    // SIPP knew no facets: its flat shading takes the mean there, too.
    let with_mean: &[NormalSource] =
        if sipp { &[NormalSource::Averaged, NormalSource::Facet] } else { &[NormalSource::Averaged] };
    if !mesh.polygons.iter().any(|polygon| with_mean.contains(&polygon.normals)) {
        return &mesh.normals;
    }
    model::vertex_normals(mesh, with_mean, means);
    means
}

impl<'a> VertexRange<'a> {
    /// The same in at most `count` parts.
    pub fn parts(self, count: usize) -> Vec<VertexRange<'a>> {
        let each = self.vertices.len().div_ceil(count).max(1);
        let mut positions = self.positions.chunks_mut(each);
        // Codes and normals may be missing.
        let (mut codes, mut normals) = (self.codes.chunks_mut(each), self.normals.chunks_mut(each));
        let mut local_normals = self.local_normals.chunks(each);
        let part = |vertices| VertexRange {
            vertices,
            local_normals: local_normals.next().unwrap_or_default(),
            positions: positions.next().unwrap_or_default(),
            codes: codes.next().unwrap_or_default(),
            normals: normals.next().unwrap_or_default(),
        };
        self.vertices.chunks(each).map(part).collect()
    }

    /// Moves the vertices to eye space and computes what the plan needs of them.
    pub fn fill(self, world_from_local: &Affine3, plan: &Plan) {
        let view = &plan.view;
        for (eye, &vertex) in self.positions.iter_mut().zip(self.vertices) {
            *eye = view.to_eye(world_from_local.transform_point3(vertex));
        }
        for (code, eye) in self.codes.iter_mut().zip(&*self.positions) {
            *code = outcode(eye, view) & plan.needs.clip;
        }
        // Only directions matter: a normal that a singular map leaves without one is given up for the polygon's own.
        let identity = world_from_local.matrix3 == Mat3::IDENTITY;
        let world_normals = model::normals_from(world_from_local).unwrap_or(Mat3::ZERO);
        for (normal, &local) in self.normals.iter_mut().zip(self.local_normals) {
            *normal = view.eye_from_world * turned(local, &world_normals, identity);
        }
    }
}

/// Bits of the planes that a point in eye space lies outside of.
#[inline]
fn outcode(eye: &Vec3, view: &View) -> u8 {
    let (kx, ky) = view.clip_from_eye();
    // The same products as the clipper sees, so that both agree on what lies on a plane.
    let (x, y, w) = (eye.x * kx, eye.y * ky, eye.z);
    let outside = [w < view.hither, x < -w, x > w, y < -w, y > w, w > view.yon];
    (0..).zip(outside).fold(0, |code, (plane, is_outside)| code | u8::from(is_outside) << plane)
}

/// A normal in world space; under the identity the very same bits.
#[inline]
fn turned(normal: Vec3, world_normals: &Mat3, identity: bool) -> Vec3 {
    if identity || normal == Vec3::ZERO { normal } else { unit(*world_normals * normal).unwrap_or(Vec3::ZERO) }
}

impl Side {
    /// The side of its polygon's vertices that the eye sees.
    #[inline]
    pub fn of(survivor: &Survivor) -> Side {
        if survivor.facing.is_back() { Side::Back } else { Side::Front }
    }

    /// A normal on the front, turned to this side.
    #[inline]
    pub fn turn(self, normal: Vec3) -> Vec3 {
        if self == Side::Back { -normal } else { normal }
    }
}

impl<'a> Asked<'a> {
    /// The same in `count` parts.
    pub fn parts(self, count: usize) -> Vec<Asked<'a>> {
        let Asked { positions, normals, asked, ready, asked_light, lit } = self;
        let each = |length: usize| length.div_ceil(count).max(1);
        let mut ready = asked.chunks(each(asked.len())).zip(ready.chunks_mut(each(asked.len())));
        let mut lit = asked_light.chunks(each(asked_light.len())).zip(lit.chunks_mut(each(asked_light.len())));
        let part = |_| {
            let (asked, ready) = ready.next().unwrap_or_default();
            let (asked_light, lit) = lit.next().unwrap_or_default();
            Asked { positions, normals, asked, ready, asked_light, lit }
        };
        (0..count).map(part).collect()
    }

    /// Computes it; `light` is the light of a vertex, at a point with a normal.
    pub fn compute(self, projector: &Projector, mut light: impl FnMut(u32, (Vec3, Vec3)) -> [f64; 3]) {
        for (ready, &vertex) in self.ready.iter_mut().zip(self.asked) {
            *ready = projector.ready(projector.clip_space(self.positions[vertex as usize]), EdgeKind::Original);
        }
        for (lit, &(vertex, side)) in self.lit.iter_mut().zip(self.asked_light) {
            let normal = side.turn(self.normals[vertex as usize]);
            *lit = light(vertex, (self.positions[vertex as usize], normal));
        }
    }
}
