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

use super::asked::Asked;
use super::cull::Survivor;
use super::project::{Projector, Ready};
use super::{Part, Setting, moved};
use crate::math::{Affine3, Mat3, Vec3, unit};
use crate::model;
use crate::plan::{FlatRule, NeedsMode, Plan, Shading};
use crate::report::Work;
use crate::scene::{Mesh, NormalSource};
use crate::screen::{EdgeKind, Shared, SharedCorner};
use fearless_simd::Level;

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
    /// In place of that, where triangles are shared: what shared triangles are made of.
    places: Vec<[i32; 2]>,
    corners: Vec<SharedCorner>,
    uv: Vec<[f64; 2]>,
    factors: Vec<[f64; 3]>,
    /// Triangles of this mesh go into the list as shared ones.
    pub shares: bool,
    /// Corners and light that are in the list before those of this mesh.
    before: [u32; 2],
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
        // With few polygons of more corners, triangles are worth a form of their own.
        self.shares = setting.shares && mesh.outlines.len() == 3 * mesh.polygons.len();
        // Shared triangles know normals as others know light.
        let lights = setting.lighting.lights_vertices() || self.shares && setting.lighting.carries_normals();
        self.lights = lights && !self.normals.is_empty();
        // Room for all, so that nothing is copied when more are asked for; what is never asked for costs addresses, not memory.
        let lit = if self.lights { count } else { 0 };
        empty(&mut self.asked, count);
        let [own, shared] = if self.shares { [0, count] } else { [count, 0] };
        empty(&mut self.ready, own);
        empty(&mut self.places, shared);
        empty(&mut self.corners, shared);
        empty(&mut self.uv, 0);
        empty(&mut self.factors, 0);
        empty(&mut self.asked_light, lit);
        empty(&mut self.lit, lit);
        work.vertices_transformed += count as u64;
        work.plane_tests += self.codes.len() as u64 * u64::from(planes.count_ones());
        work.normals += local_normals.len() as u64;
        let (positions, codes, normals) = (&mut self.positions, &mut self.codes, &mut self.normals);
        VertexRange { vertices: &mesh.vertices, local_normals, positions, codes, normals }
    }

    /// Its corners will be behind those that are in the list now.
    pub fn stand_behind(&mut self, shared: &Shared) {
        self.before = [shared.places.len() as u32, shared.of_vertices.light.len() as u32];
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

    /// What was asked for and is not computed yet; with u and v and with a factor for each light, if there are any.
    pub fn asked(&mut self, setting: &Setting<'_>) -> Asked<'_> {
        let (ready_before, lit_before) = (self.ready.len().max(self.places.len()), self.lit.len());
        let [own, shared] = if self.shares { [0, self.asked.len()] } else { [self.asked.len(), 0] };
        self.ready.resize(own, Ready::default());
        self.places.resize(shared, [0; 2]);
        self.corners.resize(shared, SharedCorner::default());
        self.lit.resize(self.asked_light.len(), [0.0; 3]);
        self.uv.resize(if setting.plan.needs.texture { shared } else { 0 }, [0.0; 2]);
        let has_factors = setting.lighting.carries_factors() && self.shares;
        self.factors.resize(if has_factors { self.lit.len() } else { 0 }, [0.0; 3]);
        let EyeMesh { positions, normals, asked, ready, places, corners, uv, asked_light, lit, factors, .. } = self;
        Asked {
            positions,
            normals,
            asked: &asked[ready_before..],
            ready: ready.get_mut(ready_before..).unwrap_or_default(),
            places: places.get_mut(ready_before..).unwrap_or_default(),
            corners: corners.get_mut(ready_before..).unwrap_or_default(),
            uv: uv.get_mut(ready_before..).unwrap_or_default(),
            asked_light: &asked_light[lit_before..],
            lit: &mut lit[lit_before..],
            factors: factors.get_mut(lit_before..).unwrap_or_default(),
        }
    }

    /// A vertex that was asked for, made ready.
    #[inline]
    pub fn ready(&self, vertex: u32, projector: &Projector) -> Ready {
        if self.shares {
            return projector.ready(projector.clip_space(self.positions[vertex as usize]), EdgeKind::Original);
        }
        self.ready[self.slots[vertex as usize].ready as usize]
    }

    /// The light of a vertex that was asked for.
    #[inline]
    pub fn light(&self, vertex: u32, side: Side) -> [f64; 3] {
        self.lit[self.slots[vertex as usize].lit[side as usize] as usize]
    }

    /// Where the corners of a shared triangle are, and their light, unless it is its own.
    #[inline(always)]
    pub fn shared(&self, outline: [u32; 3], side: Side) -> ([u32; 3], Option<[u32; 3]>) {
        let slots = outline.map(|vertex| &self.slots[vertex as usize]);
        let lit = slots.map(|slot| slot.lit[side as usize]);
        let is_lit = self.lights && lit.iter().all(|&lit| lit != NOT_ASKED);
        let [corners, light] = self.before;
        (slots.map(|slot| slot.ready + corners), is_lit.then_some(lit.map(|lit| lit.wrapping_add(light))))
    }

    /// Hands the corners over to the list, behind those that are there.
    pub fn hand_over(&mut self, shared: &mut Shared) {
        if !self.shares {
            return;
        }
        append(&mut shared.places, &mut self.places);
        append(&mut shared.corners, &mut self.corners);
        append(&mut shared.uv, &mut self.uv);
        append(&mut shared.of_vertices.light, &mut self.lit);
        append(&mut shared.of_vertices.factors, &mut self.factors);
        // What was handed over is not to be looked for here.
        self.asked.clear();
        self.asked_light.clear();
    }
}

/// Moves what is in `part` to the end of `all`; memory changes hands where nothing has to be copied.
fn append<T: Copy>(all: &mut Vec<T>, part: &mut Vec<T>) {
    if all.is_empty() {
        std::mem::swap(all, part);
    } else {
        all.extend_from_slice(part);
    }
    part.clear();
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
    pub fn fill(self, world_from_local: &Affine3, plan: &Plan, level: Level) {
        let view = &plan.view;
        moved::positions(level, (world_from_local, view), self.vertices, self.positions);
        if !self.codes.is_empty() {
            moved::outcodes(level, (view, plan.needs.clip), self.positions, self.codes);
        }
        if world_from_local.matrix3 == Mat3::IDENTITY {
            // Under the identity the very same bits.
            return moved::normals(level, view, self.local_normals, self.normals);
        }
        // Only directions matter: a normal that a singular map leaves without one is given up for the polygon's own.
        let world_normals = model::normals_from(world_from_local).unwrap_or(Mat3::ZERO);
        for (normal, &local) in self.normals.iter_mut().zip(self.local_normals) {
            *normal = view.eye_from_world * turned(local, &world_normals);
        }
    }
}

/// A normal in world space.
#[inline]
fn turned(normal: Vec3, world_normals: &Mat3) -> Vec3 {
    if normal == Vec3::ZERO { normal } else { unit(*world_normals * normal).unwrap_or(Vec3::ZERO) }
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
