//! Hand: the loop of FAROP's figure 4, over the polygons of a surface or of a shape.
//!
//! Part + EyeMesh -CULL-> survivors -LIGHT, CLIP, SPLIT, PROJECT-> DrawList
//!
//! Why in two halves: what is culled first is never lit. So some polygons are culled, then the vertices that the survivors ask
//! for are lit, in one go, and only then are the survivors clipped and projected. A thread has one hand, and a hand owns the memory that polygons take turns in.
//!
//! Space: eye space until clipping, clip space behind it.
//! Cost: nothing is allocated per polygon.

mod emit;

use super::asked::Asked;
use super::clip::{ClipVertex, Clipper};
use super::cull::Survivor;
use super::light::LightWork;
use super::project::{Corner, Triangles};
use super::tessellate::Tessellator;
use super::walk::EyeMesh;
use super::{EyePolygon, Facing, Part, Setting, Task, Trace, split, wear};
use crate::color::Rgb;
use crate::math::Vec3;
use crate::plan::{ClipPlane, Culling};
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
            vertices.fill(&task.world_from_local, setting.plan, setting.level);
        }
        // Corners of a shape in between would come before those of the mesh.
        mesh.shares &= task.shapes.is_empty();
        mesh.stand_behind(&list.shared);
        let mut next = task.polygons.start;
        for number in task.shapes.clone() {
            let before = (part.surface.primitives[number].before as usize).clamp(next, task.polygons.end);
            self.polygons(part, &mut mesh, next..before, setting, list);
            next = before;
            self.shape((task, part), number, setting, list);
        }
        self.polygons(part, &mut mesh, next..task.polygons.end, setting, list);
        if !task.polygons.is_empty() {
            mesh.hand_over(&mut list.shared);
        }
        self.surface_mesh = mesh;
    }

    /// A shape: turned into polygons for this view, or left out when the view does not see it.
    fn shape(&mut self, (task, of): (&Task, Part<'_>), number: usize, setting: &Setting<'_>, list: &mut DrawList) {
        let mut tessellator = std::mem::take(&mut self.tessellator);
        let mut mesh = std::mem::take(&mut self.shape_mesh);
        let primitive = &of.surface.primitives[number];
        if tessellator.tessellate(primitive, &task.world_from_local, setting.plan, &mut self.counts.work) {
            let vertices = mesh.open(&tessellator.mesh, setting, &mut self.counts.work);
            vertices.fill(&task.world_from_local, setting.plan, setting.level);
            mesh.stand_behind(&list.shared);
            let part = Part { mesh: &tessellator.mesh, tessellated: true, shape: number as u32, ..of };
            self.polygons(part, &mut mesh, 0..tessellator.mesh.polygons.len(), setting, list);
            mesh.hand_over(&mut list.shared);
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
            survivors.reserve(AT_ONCE);
            self.cull(part, mesh, start..(start + AT_ONCE).min(range.end), setting, &mut survivors);
            mesh.ask(part, &survivors);
            self.compute(mesh.asked(setting), part, setting);
            self.emit((part, mesh), &survivors, setting, list);
        }
        self.survivors = survivors;
    }

    /// Brings to the screen and lights what survivors asked for.
    pub fn compute(&mut self, mut asked: Asked<'_>, part: Part<'_>, setting: &Setting<'_>) {
        let lighting = setting.lighting;
        asked.project(setting.projector, setting.level);
        asked.keep_uv(|vertex| wear::place(part, vertex));
        let factor = |vertex| lighting.factor(part, vertex).unwrap_or(Rgb::WHITE).to_array();
        asked.keep_factors(factor);
        if lighting.carries_normals() {
            return asked.keep_normals();
        }
        // A mesh has a color for every vertex or none.
        let factor: Option<&dyn Fn(u32) -> [f64; 3]> = if part.mesh.colors.is_empty() { None } else { Some(&factor) };
        let (vertices, powers) = asked.light((setting.shader, part.shading), factor, setting.level);
        self.light.vertices += vertices;
        self.light.powers += powers;
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
}
