//! What was done and how long it took: FAROP's diagnostics (appendix A.3 of the paper) as values.
//!
//! Stages return counts; the driver adds them up. Nothing here prints.

use serde::Serialize;

/// What the stages counted. Polygons are those of the files; tessellated ones are counted apart.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Placed objects.
    pub objects: u64,
    /// Placed surfaces.
    pub surfaces: u64,
    /// Polygons that went into the pipeline.
    pub polygons: u64,
    /// Vertices, shared ones once.
    pub vertices: u64,
    /// Polygons dropped by culling.
    pub backfacing: u64,
    /// Polygons of which clipping left nothing.
    pub clipped: u64,
    /// Polygons that a plane cut.
    pub cut: u64,
    /// Polygons wholly inside the view volume.
    pub inside: u64,
    /// Polygons handed on: cut + inside.
    pub rendered: u64,
    /// Triangles that the rendered polygons are worth: the sum of n - 2.
    pub triangles: u64,
    /// Polygons that were split.
    pub split: u64,
    /// Polygons dropped because a number in them is not finite, or because they are seen exactly edge-on; and polygons and shapes
    /// (a shape counts once) whose transform is singular or not finite: they have no inside and outside any more.
    pub skipped: u64,
    /// Quads of Bezier shapes that are not planar (their diagonals pass each other at more than 1e-9 of the longer one) and were cut
    /// along the shorter diagonal. `tessellated.polygons` counts such a quad once; its two triangles are then culled, clipped and
    /// rendered each for itself, so tessellated polygons + nonplanar = backfacing + clipped + rendered (+ skipped).
    pub nonplanar: u64,
    /// Polygons in view whose outline crosses itself.
    pub self_crossing: u64,
    /// Ears that had to be forced, in self-crossing outlines.
    pub forced_ears: u64,
    /// The same for polygons that shapes were turned into.
    pub tessellated: Tessellated,
    /// What was computed: the proof that what is not needed is not done.
    pub work: Work,
}

/// Counts of polygons that shapes were turned into.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Tessellated {
    /// Made.
    pub polygons: u64,
    /// Dropped by culling.
    pub backfacing: u64,
    /// Nothing left by clipping.
    pub clipped: u64,
    /// Handed on.
    pub rendered: u64,
}

/// Work done, to compare with the plan.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Work {
    /// Vertices moved to eye space.
    pub vertices_transformed: u64,
    /// Vertices that shapes were turned into.
    pub shape_vertices: u64,
    /// Shapes left out because they lie outside the view.
    pub shapes_outside: u64,
    /// Vertex normals computed or moved to eye space.
    pub normals: u64,
    /// Vertices lit.
    pub vertices_lit: u64,
    /// Cosine powers computed, at vertices and at samples.
    pub specular_powers: u64,
    /// Distances to clip planes computed for outcodes.
    pub plane_tests: u64,
}

impl Counts {
    /// Counts polygons that enter the pipeline.
    pub fn add_polygons(&mut self, tessellated: bool, count: u64) {
        *(if tessellated { &mut self.tessellated.polygons } else { &mut self.polygons }) += count;
    }

    /// Counts a polygon dropped by culling.
    pub fn add_backfacing(&mut self, tessellated: bool) {
        *(if tessellated { &mut self.tessellated.backfacing } else { &mut self.backfacing }) += 1;
    }

    /// Counts a polygon of which clipping left nothing.
    pub fn add_clipped(&mut self, tessellated: bool) {
        *(if tessellated { &mut self.tessellated.clipped } else { &mut self.clipped }) += 1;
    }

    /// Counts a polygon that is handed on with `vertices` vertices, cut by a plane or wholly inside.
    pub fn add_rendered(&mut self, tessellated: bool, cut: bool, vertices: usize) {
        if tessellated {
            self.tessellated.rendered += 1;
            return;
        }
        self.rendered += 1;
        *(if cut { &mut self.cut } else { &mut self.inside }) += 1;
        self.triangles += vertices as u64 - 2;
    }
}

/// Time of one stage in milliseconds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct StageTime {
    /// Wall clock.
    pub elapsed: f64,
    /// Processor, in the program.
    pub user: f64,
    /// Processor, in the system.
    pub system: f64,
}

/// Times of all stages.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Times {
    /// Text to scene.
    pub parse: StageTime,
    /// Scene to plan.
    pub plan: StageTime,
    /// Scene to draw list.
    pub geometry: StageTime,
    /// Draw list to picture.
    pub raster: StageTime,
    /// Picture to file.
    pub write: StageTime,
}

impl std::ops::AddAssign<&Counts> for Counts {
    fn add_assign(&mut self, other: &Counts) {
        self.objects += other.objects;
        self.surfaces += other.surfaces;
        self.polygons += other.polygons;
        self.vertices += other.vertices;
        self.backfacing += other.backfacing;
        self.clipped += other.clipped;
        self.cut += other.cut;
        self.inside += other.inside;
        self.rendered += other.rendered;
        self.triangles += other.triangles;
        self.split += other.split;
        self.skipped += other.skipped;
        self.nonplanar += other.nonplanar;
        self.self_crossing += other.self_crossing;
        self.forced_ears += other.forced_ears;
        self.tessellated += other.tessellated;
        self.work += other.work;
    }
}

impl std::ops::AddAssign for Tessellated {
    fn add_assign(&mut self, other: Tessellated) {
        self.polygons += other.polygons;
        self.backfacing += other.backfacing;
        self.clipped += other.clipped;
        self.rendered += other.rendered;
    }
}

impl std::ops::AddAssign for Work {
    fn add_assign(&mut self, other: Work) {
        self.vertices_transformed += other.vertices_transformed;
        self.shape_vertices += other.shape_vertices;
        self.shapes_outside += other.shapes_outside;
        self.normals += other.normals;
        self.vertices_lit += other.vertices_lit;
        self.specular_powers += other.specular_powers;
        self.plane_tests += other.plane_tests;
    }
}

impl std::ops::AddAssign for StageTime {
    fn add_assign(&mut self, other: Self) {
        self.elapsed += other.elapsed;
        self.user += other.user;
        self.system += other.system;
    }
}

/// Measures one stage: started before it, read after it.
#[derive(Clone, Copy, Debug)]
pub struct StageTimer {
    started: std::time::Instant,
    processor: (f64, f64),
}

impl StageTimer {
    /// Starts the clock.
    #[must_use]
    pub fn start() -> StageTimer {
        StageTimer { started: std::time::Instant::now(), processor: processor_times() }
    }

    /// Time since the start.
    #[must_use]
    pub fn stop(self) -> StageTime {
        let (user, system) = processor_times();
        let elapsed = self.started.elapsed().as_secs_f64() * 1e3;
        StageTime { elapsed, user: user - self.processor.0, system: system - self.processor.1 }
    }
}

/// User and system time of this process so far, milliseconds; zeros where the system does not tell.
#[cfg(unix)]
fn processor_times() -> (f64, f64) {
    use nix::sys::resource::{UsageWho, getrusage};
    use nix::sys::time::TimeValLike;
    let Ok(usage) = getrusage(UsageWho::RUSAGE_SELF) else { return (0.0, 0.0) };
    let milliseconds = |time: nix::sys::time::TimeVal| time.num_microseconds() as f64 / 1e3;
    (milliseconds(usage.user_time()), milliseconds(usage.system_time()))
}

#[cfg(not(unix))]
fn processor_times() -> (f64, f64) {
    (0.0, 0.0)
}

/// The most memory this process has held so far, in bytes; 0 where the system does not tell.
#[must_use]
#[cfg(unix)]
pub fn peak_bytes() -> u64 {
    use nix::sys::resource::{UsageWho, getrusage};
    let kilobytes = getrusage(UsageWho::RUSAGE_SELF).map_or(0, |usage| usage.max_rss());
    // macOS counts bytes, the others kilobytes.
    let unit = if cfg!(target_os = "macos") { 1 } else { 1024 };
    u64::try_from(kilobytes).unwrap_or(0) * unit
}

/// The most memory this process has held so far, in bytes; 0 where the system does not tell.
#[must_use]
#[cfg(not(unix))]
pub fn peak_bytes() -> u64 {
    0
}
