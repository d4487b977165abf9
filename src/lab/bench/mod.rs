//! Bench: how long each stage of a frame takes, for several rasterizers side by side.
//!
//! scene, rasterizers -BENCH (frame, summary)-> rows -table-> text, JSON
//!
//! A machine that slows down must slow all of them: every round draws one frame with each contestant, in a new random order, and
//! the first two rounds warm up and are dropped. Memory is kept from frame to frame, as in a program that moves: fresh pages cost more
//! than the work in them. What the first contestant draws, the others are compared with: a fast picture that is another one is
//! no answer.
//!
//! Units: milliseconds, of the clock and of the processor. `docs/benchmarks.md` says what each figure means.

pub mod frame;
pub mod instructions;
pub mod scaling;
pub mod summary;
pub mod table;

use self::frame::{Buffers, Drawn, FrameTimes};
use super::check::Random;
use super::measure::{Effort, shuffled};
use crate::plan::{Choices, PlanError};
use crate::raster::Rasterizer;
use crate::report::Counts;
use crate::scene::Scene;
use std::time::Instant;

/// One way to draw a scene.
#[derive(Clone)]
pub struct Contestant<'a> {
    /// What tables call it.
    pub name: String,
    /// What draws.
    pub rasterizer: &'a dyn Rasterizer,
    /// How, threads included.
    pub choices: Choices,
}

/// What a contestant did.
#[derive(Clone, Debug, Default)]
pub struct Row {
    /// What tables call it.
    pub name: String,
    /// Threads that it might use.
    pub threads: u32,
    /// Times of every counted frame.
    pub times: Vec<FrameTimes>,
    /// What the geometry stage counted.
    pub counts: Counts,
    /// Polygons handed to the rasterizer.
    pub drawn: usize,
    /// Bytes of memory that a frame is made in: draw list, sample grid, picture.
    pub bytes: u64,
    /// Pixels that show something else than the first contestant's.
    pub differing: u64,
    /// Processor instructions of one frame, where they were counted.
    pub instructions: Option<u64>,
    /// Why there is no picture.
    pub failure: Option<String>,
}

/// Rounds that are not counted: one tells how much memory each contestant needs, one warms that memory.
const WARM_UP: usize = 2;

/// Draws `scene` round by round with every contestant; with `writes`, pictures are also compressed as PNG. `progress` is told rounds done and rounds in all.
///
/// # Errors
/// [`PlanError`] when the scene has no usable view or choices contradict each other.
pub fn run(
    scene: &Scene,
    contestants: &[Contestant<'_>],
    (effort, writes): (&Effort, bool),
    progress: &dyn Fn(usize, usize),
) -> Result<Vec<Row>, PlanError> {
    let mut random = Random::new(effort.seed);
    let (mut buffers, mut reference) = (Buffers::default(), Vec::new());
    buffers.writes = writes;
    let mut rows: Vec<Row> = contestants.iter().map(Row::of).collect();
    let start = Instant::now();
    for round in 0..effort.rounds + WARM_UP {
        if round > WARM_UP && start.elapsed() > effort.budget {
            break;
        }
        // The first round keeps the order: the first contestant's picture is what others are compared with.
        let order = if round == 0 { (0..rows.len()).collect() } else { shuffled(rows.len(), &mut random) };
        for index in order {
            let (contestant, row) = (&contestants[index], &mut rows[index]);
            if row.failure.is_some() {
                continue;
            }
            if round == 0 {
                buffers.forget_samples();
            }
            let drawn = frame::draw(scene, &contestant.choices, contestant.rasterizer, &mut buffers)?;
            if round == 0 {
                row.note(drawn, buffers.levels(), &mut reference);
            } else if round >= WARM_UP {
                row.times.push(drawn.times);
            }
        }
        progress(round + 1, effort.rounds + WARM_UP);
    }
    Ok(rows)
}

impl Row {
    fn of(contestant: &Contestant<'_>) -> Row {
        let threads = contestant.choices.threads.unwrap_or_else(crate::render::available_threads);
        Row { name: contestant.name.clone(), threads, ..Row::default() }
    }

    /// Keeps what is the same in every frame.
    fn note(&mut self, drawn: Drawn, levels: &[u8], reference: &mut Vec<u8>) {
        (self.counts, self.drawn) = (drawn.counts, drawn.polygons);
        (self.bytes, self.failure) = (drawn.bytes, drawn.failure);
        if self.failure.is_some() {
            return;
        }
        if reference.is_empty() {
            reference.extend_from_slice(levels);
        }
        let pixels = levels.chunks_exact(3).zip(reference.chunks_exact(3));
        self.differing = pixels.filter(|(own, other)| own != other).count() as u64;
    }
}

/// Triangles that go into the pipeline: what polygons of the files are worth, and the pieces of shapes.
#[must_use]
pub fn triangles(scene: &Scene, counts: &Counts) -> u64 {
    let mut triangles = counts.tessellated.polygons;
    // The frame has walked the same tree.
    let _ = scene.walk(|placed| {
        for &id in &placed.object.surfaces {
            let mesh = &scene.surface(id).mesh;
            triangles += mesh.outlines.len() as u64 - 2 * mesh.polygons.len() as u64;
        }
    });
    triangles
}
