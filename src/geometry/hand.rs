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
use super::project::{Corner, Outline, Triangles};
use super::tessellate::Tessellator;
use super::walk::{Asked, EyeMesh};
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
    /// The polygon in hand: indices into its mesh, the first is the file's first; its corners; what clipping left of it.
    outline: Vec<u32>,
    corners: Vec<Corner>,
    clipped: Vec<Corner>,
    /// It, as clipping sees it.
    polygon: Vec<ClipVertex>,
    clipper: Clipper,
    crossing: split::Crossing,
    triangles: Triangles,
}

/// What the polygons of a part have in common on their way to the screen.
struct Way<'a> {
    part: Part<'a>,
    mesh: &'a EyeMesh,
    setting: &'a Setting<'a>,
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
            self.compute(mesh.asked(), part, setting);
            self.emit((part, mesh), &survivors, setting, list);
        }
        self.survivors = survivors;
    }

    /// Brings to the screen and lights what survivors asked for.
    pub fn compute(&mut self, asked: Asked<'_>, part: Part<'_>, setting: &Setting<'_>) {
        let of = (part, setting.shader);
        let light = |vertex, point| setting.lighting.vertex_light(of, vertex, point, &mut self.light);
        asked.compute(setting.projector, light);
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
        for (number, polygon) in (range.start as u32..).zip(&part.mesh.polygons[range.clone()]) {
            let facing = self.facing(part, mesh, polygon, number);
            match facing {
                Facing::NotFinite => self.counts.skipped += 1,
                Facing::Back { .. } | Facing::EdgeOn if !two_sided => self.counts.add_backfacing(part.tessellated),
                // Seen exactly edge-on it covers nothing, and its depth has no plane.
                Facing::EdgeOn => self.counts.skipped += 1,
                Facing::Front { .. } | Facing::Back { .. } => match mesh.outcodes(part.mesh.outline(polygon)) {
                    (any, 0) => survivors.push(Survivor { polygon: number, facing, crossed: any & cutting != 0 }),
                    _ => self.counts.add_clipped(part.tessellated),
                },
            }
        }
        self.counts.add_polygons(part.tessellated, range.len() as u64);
    }

    /// Which way a polygon faces.
    #[inline]
    fn facing(&mut self, part: Part<'_>, mesh: &EyeMesh, polygon: &Polygon, number: u32) -> Facing {
        let at = |index: u32| mesh.positions[index as usize];
        // Three corners need no memory.
        let facing = match (part.mesh.outline(polygon), part.mirrored) {
            (&[a, b, c], false) => Facing::of(&[at(a), at(b), at(c)]),
            (&[a, b, c], true) => Facing::of(&[at(a), at(c), at(b)]),
            _ => {
                self.places.clear();
                self.places.extend(part.outline(polygon).map(at));
                Facing::of(&self.places)
            }
        };
        if let Some(trace) = &mut self.trace {
            let corners = part.outline(polygon).map(at).collect();
            trace.eye.push(EyePolygon { source: part.source(number), corners, facing });
        }
        facing
    }

    /// Light, clip, split, project: appends to `list` what is left of `survivors`.
    pub fn emit(
        &mut self,
        (part, mesh): (Part<'_>, &EyeMesh),
        survivors: &[Survivor],
        setting: &Setting<'_>,
        list: &mut DrawList,
    ) {
        let on_the_way = Way { part, mesh, setting };
        for survivor in survivors {
            let polygon = &part.mesh.polygons[survivor.polygon as usize];
            // Three corners need no memory, and what follows is unrolled for them; it is the same code.
            match (part.mesh.outline(polygon), part.mirrored) {
                (&[a, b, c], false) if !survivor.crossed => self.inside(&on_the_way, survivor, [a, b, c], list),
                (&[a, b, c], true) if !survivor.crossed => self.inside(&on_the_way, survivor, [a, c, b], list),
                _ => self.any(&on_the_way, survivor, list),
            }
        }
    }

    /// A triangle that no plane cuts.
    #[inline]
    fn inside(&mut self, way: &Way<'_>, survivor: &Survivor, outline: [u32; 3], list: &mut DrawList) {
        let corner = |index| Corner { ready: *way.mesh.ready(index), ..Corner::default() };
        let mut corners = [corner(outline[0]), corner(outline[1]), corner(outline[2])];
        way.light(survivor, (&outline, &mut corners), &mut self.light);
        self.handed_on(way, survivor, &outline, &corners);
        self.project(way, survivor, (&mut corners, None), list);
    }

    /// A polygon of any number of corners.
    fn any(&mut self, way: &Way<'_>, survivor: &Survivor, list: &mut DrawList) {
        self.outline.clear();
        self.outline.extend(way.part.outline(&way.part.mesh.polygons[survivor.polygon as usize]));
        let (outline, mut corners) = (std::mem::take(&mut self.outline), std::mem::take(&mut self.corners));
        corners.clear();
        corners.extend(outline.iter().map(|&index| Corner { ready: *way.mesh.ready(index), ..Corner::default() }));
        // Light belongs to the vertices of the scene (with `relight`, normals take its place until clipping is done).
        way.light(survivor, (&outline, &mut corners), &mut self.light);
        self.clipped.clear();
        let is_in_view = if survivor.crossed {
            self.clip(way, survivor, &outline, &corners)
        } else {
            self.handed_on(way, survivor, &outline, &corners);
            true
        };
        if is_in_view {
            let mut clipped = std::mem::take(&mut self.clipped);
            let cut = (!clipped.is_empty()).then_some(clipped.as_mut_slice());
            self.project(way, survivor, (&mut corners, cut), list);
            self.clipped = clipped;
        }
        (self.outline, self.corners) = (outline, corners);
    }

    /// Clip: leaves in `clipped` what lies inside the view volume, or nothing where all of it does; `false` when none of it does.
    ///
    /// A polygon that crosses no plane passes untouched, to the last bit.
    fn clip(&mut self, way: &Way<'_>, survivor: &Survivor, outline: &[u32], corners: &[Corner]) -> bool {
        let Way { part, setting, .. } = *way;
        let view = &setting.plan.view;
        let volume = ClipVolume { hither: view.hither, yon: Some(view.yon) };
        let planes = if setting.plan.is_unsnapped() { Outcode::DEPTHS } else { Outcode::ALL };
        self.polygon.clear();
        self.polygon.extend(outline.iter().zip(corners).map(|(&index, corner)| way.clip_vertex(index, corner)));
        match self.clipper.clip_by(planes, &self.polygon, &volume, way.carried()) {
            Clipped::Inside => self.handed_on(way, survivor, outline, corners),
            Clipped::Cut(vertices) => {
                self.counts.add_rendered(part.tessellated, true, vertices.len());
                if let Some(trace) = &mut self.trace {
                    let source = part.source(survivor.polygon);
                    trace.clipped.push(ClippedPolygon { source, vertices: vertices.to_vec() });
                }
                self.clipped.extend(vertices.iter().map(|vertex| {
                    let [a, b, c, u, v, red, green, blue] = vertex.attributes;
                    let ready = setting.projector.ready(vertex.position, vertex.edge);
                    Corner { ready, values: [a, b, c], place: [u, v], factor: [red, green, blue] }
                }));
            }
            Clipped::Outside => {
                self.counts.add_clipped(part.tessellated);
                return false;
            }
            Clipped::NotFinite => {
                self.counts.skipped += 1;
                return false;
            }
        }
        true
    }

    /// Counts a polygon that passes clipping as it was.
    #[inline]
    fn handed_on(&mut self, way: &Way<'_>, survivor: &Survivor, outline: &[u32], corners: &[Corner]) {
        self.counts.add_rendered(way.part.tessellated, survivor.crossed, corners.len());
        if let Some(trace) = &mut self.trace {
            let vertices = outline.iter().zip(corners).map(|(&index, corner)| way.clip_vertex(index, corner)).collect();
            trace.clipped.push(ClippedPolygon { source: way.part.source(survivor.polygon), vertices });
        }
    }

    /// Relight where that is chosen, split where the plan says so, and project to the screen: the corners before clipping, and what
    /// clipping left where it cut.
    ///
    /// An outline that crosses itself has no triangles that cover what even-odd covers: it stays whole, if it may, and what
    /// varies follows its first three corners.
    #[inline(always)]
    fn project(
        &mut self,
        way: &Way<'_>,
        survivor: &Survivor,
        (before, cut): (&mut [Corner], Option<&mut [Corner]>),
        list: &mut DrawList,
    ) {
        let Way { part, setting, .. } = *way;
        let (lighting, newell) = (setting.lighting, survivor.facing.newell());
        let from_clipped = lighting.belongs_to_clipped();
        let constants = setting.projector.constants(before);
        let settle = |left: &mut [Corner], work| {
            lighting.relight(part.shading, left, setting.shader, work);
            if !from_clipped {
                left.iter_mut().for_each(|corner| constants.hold(corner));
            }
        };
        let (before, clipped) = match cut {
            Some(cut) => {
                settle(cut, &mut self.light);
                (&*before, &*cut)
            }
            None => {
                settle(before, &mut self.light);
                (&*before, &*before)
            }
        };
        let affine = self.crosses_itself(way, survivor) || lighting.is_affine(before, clipped);
        let outline = Outline { before, clipped, from_clipped, newell, affine };
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

    /// Whether an outline crosses itself; it is counted. Shapes make none that does, and three corners cannot.
    #[inline]
    fn crosses_itself(&mut self, way: &Way<'_>, survivor: &Survivor) -> bool {
        let polygon = &way.part.mesh.polygons[survivor.polygon as usize];
        if way.part.tessellated || polygon.count < 4 {
            return false;
        }
        self.places.clear();
        self.places.extend(way.part.outline(polygon).map(|index| way.mesh.positions[index as usize]));
        let crosses = self.crossing.is_in(&self.places, survivor.facing.newell());
        self.counts.self_crossing += u64::from(crosses);
        crosses
    }
}

impl Way<'_> {
    /// Light: what varies at the corners of an outline.
    #[inline(always)]
    fn light(&self, survivor: &Survivor, (outline, corners): (&[u32], &mut [Corner]), work: &mut LightWork) {
        let lit = (self.part, self.mesh, self.setting.shader);
        self.setting.lighting.light_corners(lit, survivor, (outline, corners), work);
        if self.setting.plan.needs.texture {
            wear::dress(self.part, outline, corners);
        }
    }

    /// How many numbers a vertex carries through clipping.
    fn carried(&self) -> usize {
        let places = if self.setting.plan.needs.texture { 5 } else { 0 };
        self.setting.lighting.carried().max(places)
    }

    /// A corner as clipping sees it.
    fn clip_vertex(&self, index: u32, corner: &Corner) -> ClipVertex {
        let position = self.setting.projector.to_clip(self.mesh.positions[index as usize]);
        let mut vertex = ClipVertex { position, ..ClipVertex::default() };
        vertex.attributes = attributes(corner);
        vertex
    }
}

/// What a corner carries through clipping; what is behind [`Way::carried`] is 0.
fn attributes(corner: &Corner) -> [f64; MAX_ATTRIBUTES] {
    let ([a, b, c], [u, v], [red, green, blue]) = (corner.values, corner.place, corner.factor);
    [a, b, c, u, v, red, green, blue]
}
