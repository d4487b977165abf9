//! The geometry stage: from the scene to polygons on the screen, in the order of FAROP's figure 4.
//!
//! Scene + Plan -walk-> EyePolygon -CULL, CLIP-> ClippedPolygon -LIGHT, SPLIT, PROJECT-> ScreenPolygon
//!
//! [`run`] walks the tree of objects and makes a list of tasks; `hand` is the loop of figure 4, `threads` shares the tasks among
//! hands. Every step is a function of its own in a file of its own. FAROP lights after
//! clipping; here, by default, the vertices of the scene are lit and a cut vertex takes its light from the two ends of
//! its edge, because otherwise colors change as the camera moves. `--clip-light relight` is FAROP's order.
//!
//! Space: eye space (x right, y up, z along the view, left-handed) until clipping, then clip space (x, y, w) with the
//! sides of the picture at x = +-w and y = +-w, then samples.
//! Source: Pereira, "FAROP", IST/INESC 1996, section 4.3.2.
//! Cost: linear in vertices and polygons; nothing is allocated per polygon, vertices shared inside a surface are moved and lit once,
//! and only those are lit that a polygon in view asks for. `docs/fast.md` and `docs/benchmarks.md` have the figures.

mod asked;
pub mod clip;
mod cull;
mod eight;
mod flatten;
mod hand;
mod light;
mod moved;
pub mod predicates;
mod project;
pub mod split;
mod tessellate;
mod threads;
mod trace;
mod walk;
mod wear;

pub use cull::Facing;
pub use flatten::flatten;
pub use trace::{ClippedPolygon, EyePolygon, Trace};

use crate::math::Affine3;
use crate::model;
use crate::plan::Plan;
use crate::report::Counts;
use crate::scene::{Mesh, Polygon, Scene, Surface, SurfaceId, Walk};
use crate::screen::{DrawList, Instructions, Shader, Source};
use fearless_simd::Level;
use hand::Hand;
use light::Lighting;
use project::Projector;
use std::ops::Range;
use threads::Crew;
use wear::Wardrobe;

/// Runs the whole stage: fills `list` with the screen polygons of `scene` under `plan`, in scene order.
///
/// `list` is emptied first and keeps its memory. Who makes frame after frame keeps a [`Stage`] as well.
pub fn run(scene: &Scene, plan: &Plan, list: &mut DrawList) -> Counts {
    Stage::default().run(scene, plan, list)
}

/// As [`run`], and keeps the value of every stage for every polygon: `--dump-stage` prints them.
pub fn run_traced(scene: &Scene, plan: &Plan, list: &mut DrawList, trace: &mut Trace) -> Counts {
    let mut stage = Stage::default();
    // One hand keeps the trace in order.
    stage.crew.hands.push(Hand::tracing(std::mem::take(trace)));
    let mut plan = plan.clone();
    plan.choices.threads = Some(1);
    let counts = stage.run(scene, &plan, list);
    *trace = stage.crew.hands[0].trace.take().unwrap_or_default();
    counts
}

/// The geometry stage with its memory: with the same stage and the same list, a walk through a scene allocates nothing once its
/// largest frame has been made (with one thread; starting threads takes memory).
///
/// What was in view before has no influence on the next frame.
///
/// ```
/// use farop::geometry::Stage;
/// use farop::plan::{Accepts, Choices, Plan};
/// use farop::screen::DrawList;
/// # fn draw(_: &DrawList) {}
/// # let text = b"v\nfrom 0 0 4\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\nresolution 8 8\nf 1 1 1 1 0 0 0 0\ns 0 0 0 1\n";
/// # let options = farop::parse::ParseOptions::default();
/// # let mut scene = farop::parse::read_nff("doc", text, options).expect("a scene").scene;
/// let (mut stage, mut list) = (Stage::default(), DrawList::new(0, 0));
/// for _ in 0..3 {
///     scene.camera.as_mut().expect("has one").from.x += 0.1;
///     let plan = Plan::new(&scene, &Choices::default(), Accepts::AnyPolygon).expect("a view");
///     stage.run(&scene, &plan, &mut list);
///     draw(&list);
/// }
/// # assert!(list.len() > 10);
/// ```
pub struct Stage {
    walk: Walk,
    tasks: Vec<Task>,
    crew: Crew,
    /// Lists are for a rasterizer that reads shared triangles ([`crate::raster::Rasterizer::reads_shared`]).
    pub shares: bool,
    /// Instructions for vertices side by side. The list does not depend on it.
    pub instructions: Instructions,
}

/// What all polygons of a frame have in common.
struct Setting<'a> {
    scene: &'a Scene,
    plan: &'a Plan,
    lighting: &'a Lighting,
    projector: &'a Projector,
    shader: &'a Shader,
    /// Triangles may go into the list as shared ones.
    shares: bool,
    /// Instructions for vertices side by side.
    level: Level,
}

/// A placed surface, or some of it.
struct Task {
    surface: SurfaceId,
    world_from_local: Affine3,
    /// The transform mirrors: outlines run the other way round.
    mirrored: bool,
    /// Index of the surface in the shader.
    shading: u32,
    polygons: Range<usize>,
    /// Shapes among these polygons.
    shapes: Range<usize>,
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

/// So many tasks are worked off together.
const TASKS_AT_ONCE: usize = 1 << 14;
/// Shapes of one task: few, so that threads find something to share.
const SHAPES_AT_ONCE: usize = 16;

impl Default for Stage {
    /// With the instructions that [`crate::screen::VARIABLE`] asks for; the best if that is no name.
    fn default() -> Self {
        let instructions = Instructions::asked().unwrap_or_default();
        Stage { walk: Walk::default(), tasks: Vec::new(), crew: Crew::default(), shares: false, instructions }
    }
}

impl Stage {
    /// A stage without memory, for a rasterizer that reads shared triangles or for one that does not
    /// ([`crate::raster::Rasterizer::reads_shared`]).
    #[must_use]
    pub fn sharing(shares: bool) -> Stage {
        Stage { shares, ..Stage::default() }
    }

    /// Fills `list` with the screen polygons of `scene` under `plan`, in scene order; it is emptied first and keeps its memory.
    ///
    /// The list does not depend on the number of threads, which is [`Plan::threads`].
    pub fn run(&mut self, scene: &Scene, plan: &Plan, list: &mut DrawList) -> Counts {
        let (projector, lighting) = (Projector::new(plan), Lighting::new(plan));
        projector.prepare(plan, list);
        let shares = self.shares && lighting.can_share() && projector.share(plan, list);
        let mut shader = std::mem::take(&mut list.shader);
        let mut wardrobe = Wardrobe::new(plan, std::mem::take(&mut shader.textures));
        lighting.prepare(scene, plan, &mut shader);
        wardrobe.prepare(scene, plan, &mut shader);
        let mut counts = Counts::default();
        let level = self.instructions.level();
        let Stage { walk, tasks, crew, .. } = self;
        let mut work = |tasks: &mut Vec<Task>, shader: &Shader| {
            let setting = Setting { scene, plan, lighting: &lighting, projector: &projector, shader, shares, level };
            crew.work(tasks, &setting, list);
            tasks.clear();
        };
        // The plan has walked the same tree within its budget.
        let walked = scene.walk_with(walk, |placed| {
            counts.objects += 1;
            for &id in &placed.object.surfaces {
                let surface = scene.surface(id);
                let shading = lighting.push_surface(&surface.material, surface.place, &mut shader);
                shader.surfaces[shading as usize].texture = wardrobe.picture(scene, surface, &mut shader);
                push_tasks(surface, (id, placed.world_from_local, shading), tasks, &mut counts);
                if tasks.len() >= TASKS_AT_ONCE {
                    work(tasks, &shader);
                }
            }
        });
        debug_assert!(walked.is_ok());
        work(tasks, &shader);
        for hand in &mut self.crew.hands {
            hand.count(&mut counts, &shader);
        }
        counts.work.specular_powers = shader.powers();
        list.shader = shader;
        counts
    }
}

/// Adds the tasks of one placed surface, in file order.
///
/// A transform that flattens space, or is not finite, leaves polygons without two sides: they and the shapes are only counted.
fn push_tasks(
    surface: &Surface,
    (id, world_from_local, shading): (SurfaceId, Affine3, u32),
    tasks: &mut Vec<Task>,
    counts: &mut Counts,
) {
    let (polygons, shapes) = (surface.mesh.polygons.len(), surface.primitives.len());
    counts.surfaces += 1;
    counts.vertices += surface.mesh.vertices.len() as u64;
    if model::normals_from(&world_from_local).is_none() {
        counts.polygons += polygons as u64;
        counts.skipped += (polygons + shapes) as u64;
        return;
    }
    let mirrored = model::mirrors(&world_from_local);
    let mut push = |polygons, shapes| {
        tasks.push(Task { surface: id, world_from_local, mirrored, shading, polygons, shapes });
    };
    // Shapes before and behind all polygons share nothing with them; those in between stay with the mesh.
    let leading = surface.primitives.partition_point(|primitive| primitive.before == 0);
    let trailing = surface.primitives.partition_point(|primitive| (primitive.before as usize) < polygons).max(leading);
    let some = |range: Range<usize>| {
        range.clone().step_by(SHAPES_AT_ONCE).map(move |start| start..(start + SHAPES_AT_ONCE).min(range.end))
    };
    some(0..leading).for_each(|shapes| push(0..0, shapes));
    if polygons > 0 {
        push(0..polygons, leading..trailing);
    }
    some(trailing..shapes).for_each(|shapes| push(0..0, shapes));
}

impl Setting<'_> {
    fn threads(&self) -> usize {
        self.plan.threads()
    }
}

impl Task {
    /// The polygons of the surface itself.
    fn part<'a>(&self, scene: &'a Scene) -> Part<'a> {
        let surface = scene.surface(self.surface);
        let (shading, mirrored) = (self.shading, self.mirrored);
        Part { mesh: &surface.mesh, surface, shading, mirrored, tessellated: false, shape: 0 }
    }
}

impl<'a> Part<'a> {
    /// The outline of a polygon, its first vertex first; a mirroring transform turns it round.
    #[inline]
    fn outline(&self, polygon: &Polygon) -> impl Iterator<Item = u32> + use<'a> {
        let (outline, mirrored) = (self.mesh.outline(polygon), self.mirrored);
        let count = outline.len();
        (0..count).map(move |corner| outline[if mirrored && corner > 0 { count - corner } else { corner }])
    }

    /// Where polygon `number` of the mesh comes from.
    #[inline]
    fn source(&self, number: u32) -> Source {
        let line = self.mesh.polygons[number as usize].line;
        // A piece of a shape is known by its shape.
        let number = if self.tessellated { self.shape } else { number };
        Source { line, number, tessellated: self.tessellated }
    }
}
