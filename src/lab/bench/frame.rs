//! One frame, in memory that earlier frames have warmed, stage by stage.
//!
//! Scene -plan, geometry, raster, levels, write-> times
//!
//! `levels` turns light into 8 bits a channel: what other renderers leave in memory. A frame ends there; `write` (the picture as PNG,
//! in memory) comes on top where pictures are kept.

use crate::geometry::Stage;
use crate::image::{Image, Picture, encode_for};
use crate::plan::{Choices, Plan, PlanError};
use crate::raster::{Frame, Rasterizer};
use crate::render::{self, Canvas};
use crate::report::{Counts, StageTime, StageTimer};
use crate::scene::Scene;
use crate::screen::DrawList;
use serde::Serialize;
use std::path::Path;

/// Names of the stages, in their order.
pub const STAGES: [&str; 5] = ["plan", "geometry", "raster", "levels", "write"];

/// Times of one frame, a stage each.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct FrameTimes {
    /// What the scene needs.
    pub plan: StageTime,
    /// Scene to draw list.
    pub geometry: StageTime,
    /// Draw list to light.
    pub raster: StageTime,
    /// Light to 8 bits a channel.
    pub levels: StageTime,
    /// The picture as PNG, in memory; not part of the frame.
    pub write: StageTime,
}

impl FrameTimes {
    /// All stages, in the order of [`STAGES`].
    #[must_use]
    pub fn stages(&self) -> [StageTime; 5] {
        [self.plan, self.geometry, self.raster, self.levels, self.write]
    }

    /// The frame: everything up to the levels.
    #[must_use]
    pub fn frame(&self) -> StageTime {
        let mut sum = StageTime::default();
        self.stages()[..4].iter().for_each(|&stage| sum += stage);
        sum
    }
}

/// Memory that frames take turns in.
pub struct Buffers {
    stage: Stage,
    list: DrawList,
    frame: Frame,
    image: Image,
    levels: Vec<u8>,
    /// Whether pictures are also compressed as PNG.
    pub writes: bool,
}

impl Default for Buffers {
    fn default() -> Self {
        let image = Image::new(0, 0, crate::color::Rgb::gray(0.0));
        let (stage, list, frame) = (Stage::default(), DrawList::new(0, 0), Frame::default());
        Buffers { stage, list, frame, image, levels: Vec::new(), writes: true }
    }
}

/// A frame that was drawn.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// How long it took.
    pub times: FrameTimes,
    /// What the geometry stage counted.
    pub counts: Counts,
    /// Polygons handed to the rasterizer.
    pub polygons: usize,
    /// Bytes of memory it was made in.
    pub bytes: u64,
    /// Why there is no picture.
    pub failure: Option<String>,
}

/// Draws one frame of `scene`.
///
/// # Errors
/// [`PlanError`] when the scene has no usable view or the choices contradict each other.
pub fn draw(
    scene: &Scene,
    choices: &Choices,
    rasterizer: &dyn Rasterizer,
    buffers: &mut Buffers,
) -> Result<Drawn, PlanError> {
    let mut times = FrameTimes::default();
    let timer = StageTimer::start();
    let plan = Plan::new(scene, choices, rasterizer.accepts())?;
    times.plan = timer.stop();

    let timer = StageTimer::start();
    buffers.stage.shares = rasterizer.reads_shared();
    let counts = buffers.stage.run(scene, &plan, &mut buffers.list);
    times.geometry = timer.stop();

    buffers.fit(plan.view.pixels);
    let canvas = Canvas::new(scene, choices);
    let timer = StageTimer::start();
    let puts = render::draw_into(&buffers.list, rasterizer, &canvas, (&mut buffers.frame, &mut buffers.image));
    times.raster = timer.stop();

    let timer = StageTimer::start();
    buffers.image.encode_into(choices.encoding, canvas.threads, &mut buffers.levels);
    times.levels = timer.stop();

    if buffers.writes && puts.failure.is_none() {
        times.write = buffers.write();
    }
    let (polygons, bytes) = (buffers.list.len(), buffers.bytes());
    Ok(Drawn { times, counts, polygons, bytes, failure: puts.failure })
}

impl Buffers {
    /// Red, green and blue of every pixel of the last frame.
    #[must_use]
    pub fn levels(&self) -> &[u8] {
        &self.levels
    }

    /// Gives up the grid of samples, so that only those who need one have it.
    pub fn forget_samples(&mut self) {
        self.frame = Frame::default();
    }

    /// Another picture only where its size is another.
    fn fit(&mut self, (width, height): (u32, u32)) {
        let size = (width as usize, height as usize);
        if (self.image.width(), self.image.height()) != size {
            self.image = Image::new(size.0, size.1, crate::color::Rgb::gray(0.0));
        }
    }

    /// How long PNG takes.
    fn write(&self) -> StageTime {
        let (width, height) = (self.image.width(), self.image.height());
        let Ok(picture) = Picture::from_rgb(width, height, self.levels.clone()) else { return StageTime::default() };
        let timer = StageTimer::start();
        let bytes = encode_for(Path::new("frame.png"), &picture);
        let time = timer.stop();
        // The bytes are wanted, or there was nothing to measure.
        std::hint::black_box(bytes.is_ok_and(|bytes| !bytes.is_empty()));
        time
    }

    fn bytes(&self) -> u64 {
        let list = &self.list;
        let bytes = std::mem::size_of_val(&list.vertices[..])
            + std::mem::size_of_val(&list.values[..])
            + std::mem::size_of_val(&list.planes[..])
            + std::mem::size_of_val(&list.polygons[..])
            + list.shared.bytes()
            + std::mem::size_of_val(self.image.pixels())
            + self.levels.len();
        bytes as u64 + self.frame.bytes()
    }
}
