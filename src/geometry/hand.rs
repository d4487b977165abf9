//! Hand: the loop of FAROP's figure 4, over the polygons of a surface or of a shape.
//!
//! Part + EyeMesh -CULL-> survivors -LIGHT, CLIP, SPLIT, PROJECT-> DrawList
//!
//! Why in two halves: what is culled first is never lit. So some polygons are culled, then the vertices that the survivors ask
//! for are lit, in one go, and only then are the survivors clipped and projected. A thread has one hand, and a hand owns the memory that polygons take turns in.
//!
//! Space: eye space until clipping, clip space behind it.
//! Cost: nothing is allocated per polygon.

use super::clip::{ClipVertex, ClipVolume, Clipped, Clipper, MAX_ATTRIBUTES, Outcode};
use super::cull::Survivor;
use super::light::LightWork;
use super::project::{Outline, Projector, Triangles};
use super::tessellate::Tessellator;
use super::walk::{AskedRange, EyeMesh};
use super::{ClippedPolygon, EyePolygon, Facing, Part, Setting, Task, Trace, split, wear};
use crate::math::Vec3;
use crate::plan::{ClipPlane, Culling, Split};
use crate::report::Counts;
use crate::scene::Polygon;
use crate::screen::{DrawList, Shader};
use std::ops::Range;

/// So many polygons are culled before the vertices they ask for are lit: few enough to stay in the nearest caches.
const AT_ONCE: usize = 512;

/// Memory for the polygons that one thread works on, and what it counted.
#[derive(Default)]
pub(super) struct Hand {
    pub counts: Counts,
    pub light: LightWork,
    pub trace: Option<Trace>,
    /// Vertices of the surface in hand.
    surface_mesh: EyeMesh,
    /// Vertices of the shape in hand.
    shape_mesh: EyeMesh,
    tessellator: Tessellator,
    survivors: Vec<Survivor>,
    /// Corners of an outline, eye space.
    places: Vec<Vec3>,
    corners: Corners,
    /// What clipping left of the polygon in hand.
    clipped: Vec<ClipVertex>,
    clipped_eye: Vec<Vec3>,
    clipper: Clipper,
    crossing: split::Crossing,
    triangles: Triangles,
}

/// The polygon in hand: its corners, and what varies at them.
#[derive(Default)]
pub(super) struct Corners {
    /// Indices into the mesh; the first is the file's first.
    pub outline: Vec<u32>,
    /// Clip space.
    pub clip: Vec<ClipVertex>,
    /// Clip space taken back to eye space: nearly where they come from, and what planes are made of.
    pub eye: Vec<Vec3>,
}

impl Hand {
    /// A hand that keeps the values between the stages.
    pub fn tracing(trace: Trace) -> Hand {
        Hand { trace: Some(trace), ..Hand::default() }
    }

    /// One surface, or some of it: its polygons and its shapes, in file order.
    pub fn task(&mut self, task: &Task, setting: &Setting<'_>, list: &mut DrawList) {
        let part = task.part(setting.scene);
        let mut mesh = std::mem::take(&mut self.surface_mesh);
        if !task.polygons.is_empty() {
            let vertices = mesh.open(part.mesh, setting, &mut self.counts.work);
            vertices.fill(&task.world_from_local, setting.plan);
        }
        let mut next = task.polygons.start;
        for number in task.shapes.clone() {
            let before = (part.surface.primitives[number].before as usize).clamp(next, task.polygons.end);
            self.polygons(part, &mut mesh, next..before, setting, list);
            next = before;
            self.shape((task, part), number, setting, list);
        }
        self.polygons(part, &mut mesh, next..task.polygons.end, setting, list);
        self.surface_mesh = mesh;
    }

    /// A shape: turned into polygons for this view, or left out when the view does not see it.
    fn shape(&mut self, (task, of): (&Task, Part<'_>), number: usize, setting: &Setting<'_>, list: &mut DrawList) {
        let mut tessellator = std::mem::take(&mut self.tessellator);
        let mut mesh = std::mem::take(&mut self.shape_mesh);
        let primitive = &of.surface.primitives[number];
        if tessellator.tessellate(primitive, &task.world_from_local, setting.plan, &mut self.counts.work) {
            let vertices = mesh.open(&tessellator.mesh, setting, &mut self.counts.work);
            vertices.fill(&task.world_from_local, setting.plan);
            let part = Part { mesh: &tessellator.mesh, tessellated: true, shape: number as u32, ..of };
            self.polygons(part, &mut mesh, 0..tessellator.mesh.polygons.len(), setting, list);
            // Both halves of a quad went through the loop; it was one polygon of the shape.
            self.counts.nonplanar += tessellator.nonplanar;
            self.counts.tessellated.polygons -= tessellator.nonplanar;
        }
        self.tessellator = tessellator;
        self.shape_mesh = mesh;
    }

    /// Polygons `range` of a part, some at a time.
    fn polygons(
        &mut self,
        part: Part<'_>,
        mesh: &mut EyeMesh,
        range: Range<usize>,
        setting: &Setting<'_>,
        list: &mut DrawList,
    ) {
        let mut survivors = std::mem::take(&mut self.survivors);
        for start in range.clone().step_by(AT_ONCE) {
            survivors.clear();
            self.cull(part, mesh, start..(start + AT_ONCE).min(range.end), setting, &mut survivors);
            mesh.ask(part, &survivors);
            self.light_asked(mesh.unlit(), part, setting);
            self.emit(part, mesh, &survivors, setting, list);
        }
        self.survivors = survivors;
    }

    /// Light: computes what survivors asked for.
    pub fn light_asked(&mut self, asked: AskedRange<'_>, part: Part<'_>, setting: &Setting<'_>) {
        let of = (part, setting.shader);
        asked.fill(|vertex, point| setting.lighting.vertex_light(of, vertex, point, &mut self.light));
    }

    /// Adds to `counts`, and to the shader's, what was counted since the last time.
    pub fn count(&mut self, counts: &mut Counts, shader: &Shader) {
        let LightWork { vertices, powers } = std::mem::take(&mut self.light);
        self.counts.work.vertices_lit += vertices;
        shader.add_powers(powers);
        *counts += &std::mem::take(&mut self.counts);
    }

    /// Cull, and clip as far as outcodes tell: appends to `survivors` what the eye sees and is not wholly outside a plane.
    pub fn cull(
        &mut self,
        part: Part<'_>,
        mesh: &EyeMesh,
        range: Range<usize>,
        setting: &Setting<'_>,
        survivors: &mut Vec<Survivor>,
    ) {
        let two_sided = match setting.plan.choices.culling {
            Culling::Back => part.surface.two_sided,
            Culling::Nff => part.surface.two_sided || !part.surface.material.is_opaque(),
            Culling::None => true,
        };
        // Where nothing is snapped, nothing is cut at the sides.
        let depths = ClipPlane::Hither.bit() | ClipPlane::Yon.bit();
        let cutting = if setting.plan.is_unsnapped() { depths } else { u8::MAX };
        let first = range.start;
        for (number, polygon) in part.mesh.polygons[range].iter().enumerate() {
            self.counts.add_polygon(part.tessellated);
            let facing = self.facing(part, mesh, polygon, first + number);
            match facing {
                Facing::NotFinite => self.counts.skipped += 1,
                Facing::Back { .. } | Facing::EdgeOn if !two_sided => self.counts.add_backfacing(part.tessellated),
                // Seen exactly edge-on it covers nothing, and its depth has no plane.
                Facing::EdgeOn => self.counts.skipped += 1,
                Facing::Front { .. } | Facing::Back { .. } => match mesh.outcodes(part.mesh.outline(polygon)) {
                    (any, 0) => {
                        let crossed = any & cutting != 0;
                        survivors.push(Survivor { polygon: (first + number) as u32, facing, crossed });
                    }
                    _ => self.counts.add_clipped(part.tessellated),
                },
            }
        }
    }

    /// Which way a polygon faces.
    #[inline]
    fn facing(&mut self, part: Part<'_>, mesh: &EyeMesh, polygon: &Polygon, number: usize) -> Facing {
        let at = |&index: &u32| mesh.positions[index as usize];
        // Three corners need no memory.
        let facing = match (part.mesh.outline(polygon), part.mirrored) {
            ([a, b, c], false) => Facing::of(&[a, b, c].map(at)),
            ([a, b, c], true) => Facing::of(&[a, c, b].map(at)),
            _ => {
                self.corners.collect(part, polygon);
                self.places.clear();
                self.places.extend(self.corners.outline.iter().map(at));
                Facing::of(&self.places)
            }
        };
        if let Some(trace) = &mut self.trace {
            self.corners.collect(part, polygon);
            let corners = self.corners.outline.iter().map(at).collect();
            trace.eye.push(EyePolygon { source: part.source(number as u32), corners, facing });
        }
        facing
    }

    /// Light, clip, split, project: appends to `list` what is left of `survivors`.
    pub fn emit(
        &mut self,
        part: Part<'_>,
        mesh: &EyeMesh,
        survivors: &[Survivor],
        setting: &Setting<'_>,
        list: &mut DrawList,
    ) {
        for survivor in survivors {
            self.corners.collect(part, &part.mesh.polygons[survivor.polygon as usize]);
            self.corners.place(mesh, &setting.projector);
            // Light belongs to the vertices of the scene (with `relight`, normals take its place until clipping is done).
            let lit = (part, mesh, setting.shader);
            let mut carried = setting.lighting.light_corners(lit, survivor, &mut self.corners, &mut self.light);
            if setting.plan.needs.texture {
                carried = carried.max(wear::dress(part, &mut self.corners));
            }
            if self.clip(part, survivor, carried, setting) {
                self.relight_and_project((part, mesh), survivor, setting, list);
            }
        }
    }

    /// Clip: leaves in `clipped` what lies inside the view volume, or nothing where all of it does; `false` when none of it does.
    ///
    /// A polygon that crosses no plane passes untouched, to the last bit.
    fn clip(&mut self, part: Part<'_>, survivor: &Survivor, carried: usize, setting: &Setting<'_>) -> bool {
        self.clipped.clear();
        if survivor.crossed {
            let view = &setting.plan.view;
            let volume = ClipVolume { hither: view.hither, yon: Some(view.yon) };
            let planes = if setting.plan.is_unsnapped() { Outcode::DEPTHS } else { Outcode::ALL };
            match self.clipper.clip_by(planes, &self.corners.clip, &volume, carried) {
                Clipped::Inside => {}
                Clipped::Cut(vertices) => self.clipped.extend_from_slice(vertices),
                Clipped::Outside => {
                    self.counts.add_clipped(part.tessellated);
                    return false;
                }
                Clipped::NotFinite => {
                    self.counts.skipped += 1;
                    return false;
                }
            }
        }
        let left = if self.clipped.is_empty() { &mut self.corners.clip } else { &mut self.clipped };
        self.counts.add_rendered(part.tessellated, survivor.crossed, left.len());
        if let Some(trace) = &mut self.trace {
            trace.clipped.push(ClippedPolygon { source: part.source(survivor.polygon), vertices: left.clone() });
        }
        true
    }

    /// Relight where that is chosen, split where the plan says so, and project to the screen.
    ///
    /// An outline that crosses itself has no triangles that cover what even-odd covers: it stays whole, if it may, and what
    /// varies follows its first three corners.
    #[inline]
    fn relight_and_project(
        &mut self,
        (part, mesh): (Part<'_>, &EyeMesh),
        survivor: &Survivor,
        setting: &Setting<'_>,
        list: &mut DrawList,
    ) {
        let (lighting, newell) = (&setting.lighting, survivor.facing.newell());
        let crossing = self.crosses_itself(part, mesh, newell);
        let Hand { corners: Corners { clip: before, eye: before_eye, .. }, clipped, clipped_eye, .. } = self;
        let from_clipped = lighting.belongs_to_clipped();
        let constants = setting.projector.constants(before);
        clipped_eye.clear();
        clipped_eye.extend(clipped.iter().map(|vertex| setting.projector.to_eye(vertex)));
        let (left, left_eye) =
            if clipped.is_empty() { (&mut *before, &*before_eye) } else { (&mut *clipped, &*clipped_eye) };
        lighting.relight(part.shading, left, (left_eye, setting.shader), &mut self.light);
        if !from_clipped {
            left.iter_mut().for_each(|vertex| hold(vertex, constants));
        }
        let (clipped, clipped_eye) =
            if clipped.is_empty() { (&*before, &*before_eye) } else { (&*clipped, &*clipped_eye) };
        let affine = crossing || lighting.is_affine(before, clipped);
        let outline = Outline { before, before_eye, clipped, clipped_eye, from_clipped, newell, affine };
        let owner = (part.shading, part.source(survivor.polygon));
        let split = match setting.plan.needs.split {
            Split::All => true,
            Split::NotAffine => !affine,
            Split::None => false,
        };
        if split && clipped.len() > 3 {
            self.counts.split += 1;
            let report = setting.projector.emit_triangles(&outline, owner, &mut self.triangles, list);
            self.counts.forced_ears += report.forced as u64;
        } else {
            setting.projector.emit(&outline, owner, list);
        }
    }

    /// Whether the outline in hand crosses itself; it is counted. Shapes make none that does, and three corners cannot.
    #[inline]
    fn crosses_itself(&mut self, part: Part<'_>, mesh: &EyeMesh, newell: Vec3) -> bool {
        if part.tessellated || self.corners.outline.len() < 4 {
            return false;
        }
        self.places.clear();
        self.places.extend(self.corners.outline.iter().map(|&index| mesh.positions[index as usize]));
        let crosses = self.crossing.is_in(&self.places, newell);
        self.counts.self_crossing += u64::from(crosses);
        crosses
    }
}

impl Corners {
    /// Looks up the outline of `polygon`; a mirroring transform turns it round, the first vertex stays first.
    #[inline]
    fn collect(&mut self, part: Part<'_>, polygon: &Polygon) {
        self.outline.clear();
        self.outline.extend_from_slice(part.mesh.outline(polygon));
        if part.mirrored {
            self.outline[1..].reverse();
        }
    }

    /// Looks up the corners of the outline.
    #[inline]
    fn place(&mut self, mesh: &EyeMesh, projector: &Projector) {
        self.clip.clear();
        self.clip.extend(self.outline.iter().map(|&index| {
            let position = projector.to_clip(mesh.positions[index as usize]);
            ClipVertex { position, ..ClipVertex::default() }
        }));
        self.eye.clear();
        self.eye.extend(self.clip.iter().map(|vertex| projector.to_eye(vertex)));
    }
}

/// Gives a vertex the numbers that are the same all over its polygon: to the last bit, also where clipping made it.
#[inline]
fn hold(vertex: &mut ClipVertex, constants: [Option<f64>; MAX_ATTRIBUTES]) {
    for (number, constant) in constants.into_iter().enumerate() {
        if let Some(value) = constant {
            vertex.attributes[number] = value;
        }
    }
}
