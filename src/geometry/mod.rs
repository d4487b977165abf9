//! The geometry stage: from the scene to polygons on the screen, in the order of FAROP's figure 4.
//!
//! Scene + Plan -walk-> EyePolygon -CULL, CLIP-> ClippedPolygon -LIGHT, SPLIT, PROJECT-> ScreenPolygon
//!
//! [`run`] is the loop of figure 4; every step is a function of its own in a file of its own. FAROP lights after
//! clipping; here, by default, the vertices of the scene are lit and a cut vertex takes its light from the two ends of
//! its edge, because otherwise colors change as the camera moves. `--clip-light relight` is FAROP's order.
//!
//! Space: eye space (x right, y up, z along the view, left-handed) until clipping, then clip space (x, y, w) with the
//! sides of the picture at x = +-w and y = +-w, then samples.
//! Source: Pereira, "FAROP", IST/INESC 1996, section 4.3.2.
//! Cost: linear in vertices; nothing is allocated per polygon, vertices shared inside a surface are moved and lit once.

pub mod clip;
mod cull;
mod flatten;
mod light;
pub mod predicates;
mod project;
pub mod split;
mod trace;
mod walk;
mod wear;

pub use cull::Facing;
pub use flatten::flatten;
pub use trace::{ClippedPolygon, EyePolygon, Trace};

use crate::math::{Affine3, Vec3};
use crate::model;
use crate::plan::{ClipPlane, Culling, Plan, Split};
use crate::report::Counts;
use crate::scene::{Mesh, Polygon, Scene, Surface};
use crate::screen::{DrawList, Source};
use clip::{ClipVertex, ClipVolume, Clipped, Clipper, Outcode};
use light::Lighting;
use project::Projector;
use walk::{EyeMesh, Tessellator};
use wear::Wardrobe;

/// Runs the whole stage: fills `list` with the screen polygons of `scene` under `plan`, in scene order.
///
/// `list` is emptied first and keeps its memory, so that a walk through a scene allocates nothing after its first frame.
pub fn run(scene: &Scene, plan: &Plan, list: &mut DrawList) -> Counts {
    Geometry::new(scene, plan, list, None).run()
}

/// As [`run`], and keeps the value of every stage for every polygon: `--dump-stage` prints them.
pub fn run_traced(scene: &Scene, plan: &Plan, list: &mut DrawList, trace: &mut Trace) -> Counts {
    Geometry::new(scene, plan, list, Some(trace)).run()
}

/// The stage at work: what it reads, what it fills, and memory that polygons take turns in.
struct Geometry<'a> {
    scene: &'a Scene,
    plan: &'a Plan,
    list: &'a mut DrawList,
    trace: Option<&'a mut Trace>,
    counts: Counts,
    projector: Projector,
    lighting: Lighting,
    wardrobe: Wardrobe,
    /// Vertices of the surface in hand, in eye space.
    surface_mesh: EyeMesh,
    /// Vertices of the shape in hand.
    shape_mesh: EyeMesh,
    tessellator: Tessellator,
    polygon: Corners,
    clipper: Clipper,
    crossing: split::Crossing,
}

/// The polygon in hand: its corners in eye space, and what varies at them.
#[derive(Default)]
struct Corners {
    /// Indices into the mesh; the first is the file's first.
    outline: Vec<u32>,
    eye: Vec<Vec3>,
    clip: Vec<ClipVertex>,
}

/// What the steps need to know of the surface or shape a polygon belongs to.
#[derive(Clone, Copy)]
struct Part<'a> {
    mesh: &'a Mesh,
    surface: &'a Surface,
    /// Index of the surface in the shader.
    shading: u32,
    /// The transform mirrors: outlines run the other way round.
    mirrored: bool,
    tessellated: bool,
    /// Which of the surface's shapes, where it is tessellated.
    shape: u32,
}

impl<'a> Geometry<'a> {
    fn new(scene: &'a Scene, plan: &'a Plan, list: &'a mut DrawList, trace: Option<&'a mut Trace>) -> Self {
        let projector = Projector::new(plan);
        projector.prepare(plan, list);
        Geometry {
            scene,
            plan,
            list,
            trace,
            counts: Counts::default(),
            projector,
            lighting: Lighting::new(plan),
            wardrobe: Wardrobe::new(plan),
            surface_mesh: EyeMesh::default(),
            shape_mesh: EyeMesh::default(),
            tessellator: Tessellator::default(),
            polygon: Corners::default(),
            clipper: Clipper::default(),
            crossing: split::Crossing::default(),
        }
    }

    fn run(mut self) -> Counts {
        let before = std::mem::take(&mut self.list.shader.textures);
        self.lighting.prepare(self.scene, self.plan, &mut self.list.shader);
        self.wardrobe.prepare(self.scene, self.plan, before, &mut self.list.shader);
        let scene = self.scene;
        // The plan has walked the same tree within its budget.
        let walked = scene.walk(|placed| {
            self.counts.objects += 1;
            for &id in &placed.object.surfaces {
                self.surface(scene.surface(id), &placed.world_from_local);
            }
        });
        debug_assert!(walked.is_ok());
        self.counts.work.vertices_lit = self.lighting.vertices_lit;
        self.counts.work.specular_powers = self.list.shader.powers();
        self.counts
    }

    /// One surface: its polygons and its shapes, in file order.
    fn surface(&mut self, surface: &Surface, world_from_local: &Affine3) {
        let shading = self.lighting.push_surface(&surface.material, surface.place, &mut self.list.shader);
        self.list.shader.surfaces[shading as usize].texture =
            self.wardrobe.picture(self.scene, surface, &mut self.list.shader);
        let mirrored = model::mirrors(world_from_local);
        self.counts.surfaces += 1;
        self.counts.vertices += surface.mesh.vertices.len() as u64;
        if model::normals_from(world_from_local).is_none() {
            return self.skip(surface);
        }
        // Move shared vertices to eye space, once.
        let mut eye_mesh = std::mem::take(&mut self.surface_mesh);
        eye_mesh.fill(&surface.mesh, world_from_local, self.plan, &mut self.counts.work);
        let part = Part { mesh: &surface.mesh, surface, shading, mirrored, tessellated: false, shape: 0 };
        let mut next = 0;
        for (number, primitive) in surface.primitives.iter().enumerate() {
            self.polygons(part, &mut eye_mesh, next..primitive.before as usize);
            next = primitive.before as usize;
            self.shape(part, number, world_from_local);
        }
        self.polygons(part, &mut eye_mesh, next..surface.mesh.polygons.len());
        self.surface_mesh = eye_mesh;
    }

    /// A transform that flattens space, or is not finite, leaves polygons without two sides: they and the shapes are only counted.
    fn skip(&mut self, surface: &Surface) {
        let polygons = surface.mesh.polygons.len() as u64;
        self.counts.polygons += polygons;
        self.counts.skipped += polygons + surface.primitives.len() as u64;
    }

    /// A shape: turned into polygons for this view, or left out when the view does not see it.
    fn shape(&mut self, of: Part<'_>, number: usize, world_from_local: &Affine3) {
        let mut tessellator = std::mem::take(&mut self.tessellator);
        let mut eye_mesh = std::mem::take(&mut self.shape_mesh);
        let primitive = &of.surface.primitives[number];
        if tessellator.tessellate(primitive, world_from_local, self.plan, &mut self.counts.work) {
            eye_mesh.fill(&tessellator.mesh, world_from_local, self.plan, &mut self.counts.work);
            let part = Part { mesh: &tessellator.mesh, tessellated: true, shape: number as u32, ..of };
            self.polygons(part, &mut eye_mesh, 0..tessellator.mesh.polygons.len());
            // Both halves of a quad went through the loop; it was one polygon of the shape.
            self.counts.nonplanar += tessellator.nonplanar;
            self.counts.tessellated.polygons -= tessellator.nonplanar;
        }
        self.tessellator = tessellator;
        self.shape_mesh = eye_mesh;
    }

    fn polygons(&mut self, part: Part<'_>, eye_mesh: &mut EyeMesh, range: std::ops::Range<usize>) {
        for number in range {
            let polygon = &part.mesh.polygons[number];
            // A piece of a shape is known by its shape.
            let number = if part.tessellated { part.shape } else { number as u32 };
            let source = Source { line: polygon.line, number, tessellated: part.tessellated };
            self.polygon(part, eye_mesh, polygon, source);
        }
    }

    /// The inner loop of FAROP's figure 4, for one polygon.
    fn polygon(&mut self, part: Part<'_>, eye_mesh: &mut EyeMesh, polygon: &Polygon, source: Source) {
        let mut corners = std::mem::take(&mut self.polygon);
        corners.collect(part, eye_mesh, polygon);
        self.counts.add_polygon(part.tessellated);
        if let Some(facing) = self.cull(part, &corners, source)
            && let Some(crossed) = self.classify(part, eye_mesh, &corners)
        {
            // Light belongs to the vertices of the scene (with `relight`, normals take its place until clipping is done).
            let normals = (polygon.normals, facing);
            let carried = self.lighting.light_corners(part, eye_mesh, normals, &mut corners, &mut self.list.shader);
            let carried = self.wardrobe.dress(part, &mut corners, carried);
            corners.place_in_clip_space(self.projector.clip_from_eye);
            if self.clip(part, &corners.clip, (crossed, carried), source) {
                let (clipped, clip_from_eye) = (&mut self.projector.clipped, self.projector.clip_from_eye);
                self.lighting.relight(part.shading, clipped, clip_from_eye, &mut self.list.shader);
                let crossing = !part.tessellated && self.crossing.is_in(&corners.eye, facing.newell());
                self.counts.self_crossing += u64::from(crossing);
                self.split_and_project(part, &corners.clip, (facing, crossing), source);
            }
        }
        self.polygon = corners;
    }

    /// Cull: which way the polygon faces, or `None` when it is dropped.
    fn cull(&mut self, part: Part<'_>, corners: &Corners, source: Source) -> Option<Facing> {
        let facing = Facing::of(&corners.eye);
        if let Some(trace) = self.trace.as_deref_mut() {
            trace.eye.push(EyePolygon { source, corners: corners.eye.clone(), facing });
        }
        let two_sided = match self.plan.choices.culling {
            Culling::Back => part.surface.two_sided,
            Culling::Nff => part.surface.two_sided || !part.surface.material.is_opaque(),
            Culling::None => true,
        };
        match facing {
            Facing::NotFinite => self.counts.skipped += 1,
            Facing::Back { .. } | Facing::EdgeOn if !two_sided => self.counts.add_backfacing(part.tessellated),
            // Seen exactly edge-on it covers nothing, and its depth has no plane.
            Facing::EdgeOn => self.counts.skipped += 1,
            Facing::Front { .. } | Facing::Back { .. } => return Some(facing),
        }
        None
    }

    /// Clip, as far as outcodes tell: whether the polygon crosses a plane, or `None` when it is wholly outside one.
    fn classify(&mut self, part: Part<'_>, eye_mesh: &EyeMesh, corners: &Corners) -> Option<bool> {
        let (any, all) = eye_mesh.outcodes(&corners.outline);
        if all != 0 {
            self.counts.add_clipped(part.tessellated);
            return None;
        }
        // Where nothing is snapped, nothing is cut at the sides.
        let depths = ClipPlane::Hither.bit() | ClipPlane::Yon.bit();
        Some(any & if self.plan.is_unsnapped() { depths } else { u8::MAX } != 0)
    }

    /// Clip: leaves in the projector what lies inside the view volume; `false` when nothing does.
    ///
    /// A polygon that crosses no plane passes untouched, to the last bit.
    fn clip(
        &mut self,
        part: Part<'_>,
        corners: &[ClipVertex],
        (crossed, carried): (bool, usize),
        source: Source,
    ) -> bool {
        let volume = ClipVolume { hither: self.plan.view.hither, yon: Some(self.plan.view.yon) };
        let planes = if self.plan.is_unsnapped() { Outcode::DEPTHS } else { Outcode::ALL };
        let left = if crossed { self.clipper.clip_by(planes, corners, &volume, carried) } else { Clipped::Inside };
        let vertices = match left {
            Clipped::Inside => corners,
            Clipped::Cut(vertices) => vertices,
            Clipped::Outside => {
                self.counts.add_clipped(part.tessellated);
                return false;
            }
            Clipped::NotFinite => {
                self.counts.skipped += 1;
                return false;
            }
        };
        self.projector.clipped.clear();
        self.projector.clipped.extend_from_slice(vertices);
        self.counts.add_rendered(part.tessellated, crossed, vertices.len());
        if let Some(trace) = self.trace.as_deref_mut() {
            trace.clipped.push(ClippedPolygon { source, vertices: vertices.to_vec() });
        }
        true
    }

    /// Split where the plan says so, and project to the screen.
    ///
    /// An outline that crosses itself has no triangles that cover what even-odd covers: it stays whole, if it may, and what
    /// varies follows its first three corners.
    fn split_and_project(
        &mut self,
        part: Part<'_>,
        corners: &[ClipVertex],
        (facing, crossing): (Facing, bool),
        source: Source,
    ) {
        let affine = crossing || self.lighting.is_affine(corners, &self.projector.clipped);
        let split = match self.plan.needs.split {
            Split::All => true,
            Split::NotAffine => !affine,
            Split::None => false,
        };
        let from_clipped = self.lighting.belongs_to_clipped();
        let outline = project::Outline { corners, from_clipped, newell: facing.newell(), affine };
        let report = self.projector.emit(&outline, split, (part.shading, source), self.list);
        self.counts.split += u64::from(split && self.projector.clipped.len() > 3);
        self.counts.forced_ears += report.forced as u64;
    }
}

impl Corners {
    /// Looks up the corners of `polygon`; a mirroring transform turns the outline round, the first vertex stays first.
    fn collect(&mut self, part: Part<'_>, eye_mesh: &EyeMesh, polygon: &Polygon) {
        self.outline.clear();
        self.outline.extend_from_slice(part.mesh.outline(polygon));
        if part.mirrored {
            self.outline[1..].reverse();
        }
        self.eye.clear();
        self.eye.extend(self.outline.iter().map(|&index| eye_mesh.positions[index as usize]));
    }

    /// Writes the positions of the corners, in clip space, beside what varies at them.
    fn place_in_clip_space(&mut self, (kx, ky): (f64, f64)) {
        for (vertex, eye) in self.clip.iter_mut().zip(&self.eye) {
            vertex.position = Vec3::new(eye.x * kx, eye.y * ky, eye.z);
        }
    }
}
