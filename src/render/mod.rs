//! The driver: scene and choices in, picture and counts out.
//!
//! Scene -Plan::new-> Plan -geometry::run-> DrawList -Rasterizer::draw-> Target -average-> Image
//!
//! Everything that holds for *every* rasterizer, students' too, is here: supersampling (a rasterizer only ever sees a
//! sample grid A times larger), the background, and drawing in bands of rows when a grid would not fit into memory.

pub mod why;

use crate::color::Rgb;
use crate::geometry::{self, Stage};
use crate::image::Image;
use crate::plan::{Accepts, Choices, Plan, PlanError, Transparency};
use crate::raster::{Frame, Pixels, PutCounts, Rasterizer};
use crate::report::{Counts, StageTimer, Times};
use crate::scene::Scene;
use crate::screen::DrawList;
use crate::screen::file::Sheet;

/// Sample grids larger than this are drawn in bands: 2^23 samples take 200 MB.
const SAMPLES_AT_ONCE: u64 = 1 << 23;

/// A picture and how it came about.
#[derive(Clone, Debug)]
pub struct Rendered {
    /// The picture, linear light.
    pub image: Image,
    /// What was needed and chosen.
    pub plan: Plan,
    /// What the rasterizer was given; [`DrawList::whole`] has all of it in its arrays.
    pub list: DrawList,
    /// What the geometry stage counted.
    pub counts: Counts,
    /// What the rasterizer put.
    pub puts: PutCounts,
    /// Times of plan, geometry and raster.
    pub times: Times,
}

/// What drawing a list depends on besides the list.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Canvas {
    /// A: the picture is the list's grid, divided by A in each direction.
    pub samples: u32,
    /// Linear light behind everything.
    pub background: Rgb<f32>,
    /// How transparent layers add up.
    pub transparency: Transparency,
    /// Threads a rasterizer may use.
    pub threads: u32,
}

impl Canvas {
    /// The canvas of a scene under `choices`.
    #[must_use]
    pub fn new(scene: &Scene, choices: &Choices) -> Canvas {
        let background = choices.encoding.decode(scene.background.unwrap_or(Rgb::BLACK)).to_f32();
        let threads = choices.threads.unwrap_or_else(available_threads);
        Canvas { samples: choices.samples, background, transparency: choices.transparency, threads }
    }
}

/// Renders `scene`: plan, geometry, rasterizer. Without a rasterizer the picture is the background.
///
/// # Errors
/// [`PlanError`] when the scene has no usable view or the choices contradict each other.
pub fn render(scene: &Scene, choices: &Choices, rasterizer: Option<&dyn Rasterizer>) -> Result<Rendered, PlanError> {
    // Only who looks into the list needs all of it in its arrays.
    let shares = rasterizer.is_some_and(Rasterizer::reads_shared);
    render_changed(scene, choices, (rasterizer, shares), |_| ())
}

/// As [`render`]; `change` may alter the list between the geometry stage and the rasterizer: a part of it, an order.
///
/// # Errors
/// As [`render`].
pub fn render_with(
    scene: &Scene,
    choices: &Choices,
    rasterizer: Option<&dyn Rasterizer>,
    change: impl FnOnce(&mut DrawList),
) -> Result<Rendered, PlanError> {
    render_changed(scene, choices, (rasterizer, false), change)
}

fn render_changed(
    scene: &Scene,
    choices: &Choices,
    (rasterizer, shares): (Option<&dyn Rasterizer>, bool),
    change: impl FnOnce(&mut DrawList),
) -> Result<Rendered, PlanError> {
    let accepts = rasterizer.map_or(Accepts::AnyPolygon, Rasterizer::accepts);
    let timer = StageTimer::start();
    let plan = Plan::new(scene, choices, accepts)?;
    let mut times = Times { plan: timer.stop(), ..Times::default() };
    let timer = StageTimer::start();
    let mut list = DrawList::new(0, 0);
    let mut counts = Stage::sharing(shares).run(scene, &plan, &mut list);
    times.geometry = timer.stop();
    change(&mut list);
    let timer = StageTimer::start();
    let (image, puts) = draw(&list, rasterizer, &Canvas::new(scene, choices));
    times.raster = timer.stop();
    counts.work.specular_powers = list.shader.powers();
    Ok(Rendered { image, plan, list, counts, puts, times })
}

/// The draw list of `scene` for a rasterizer, without drawing it.
///
/// # Errors
/// As [`render`].
pub fn list(scene: &Scene, choices: &Choices, rasterizer: Option<&dyn Rasterizer>) -> Result<DrawList, PlanError> {
    let accepts = rasterizer.map_or(Accepts::AnyPolygon, Rasterizer::accepts);
    let plan = Plan::new(scene, choices, accepts)?;
    let mut list = DrawList::new(0, 0);
    geometry::run(scene, &plan, &mut list);
    Ok(list)
}

/// Draws `list` and averages its samples to pixels.
#[must_use]
pub fn draw(list: &DrawList, rasterizer: Option<&dyn Rasterizer>, canvas: &Canvas) -> (Image, PutCounts) {
    let (width, height) = (list.width / canvas.samples, list.height / canvas.samples);
    let mut image = Image::new(width as usize, height as usize, canvas.background);
    let mut puts = PutCounts::default();
    if let Some(rasterizer) = rasterizer {
        puts = draw_into(list, rasterizer, canvas, (&mut Frame::default(), &mut image));
    }
    (image, puts)
}

/// As [`draw`], into an image of the right size and memory for samples that earlier frames have used.
pub fn draw_into(
    list: &DrawList,
    rasterizer: &dyn Rasterizer,
    canvas: &Canvas,
    (frame, image): (&mut Frame, &mut Image),
) -> PutCounts {
    if let Some(puts) = draw_pixels(list, rasterizer, canvas, image) {
        return puts;
    }
    let mut puts = PutCounts::default();
    let height = image.height() as u32;
    // Whole rows of pixels at a time, as many as memory allows; one band for all but enormous grids.
    let samples_a_row = u64::from(list.width) * u64::from(canvas.samples);
    let rows_a_band = (SAMPLES_AT_ONCE / samples_a_row.max(1)).clamp(1, u64::from(height.max(1))) as u32;
    for first in (0..height).step_by(rows_a_band as usize) {
        let end = (first + rows_a_band).min(height);
        let rows = first * canvas.samples..end * canvas.samples;
        let target = frame.target((list.width, list.height), rows.clone(), canvas.background, canvas.transparency);
        let mut target = target.with_threads(canvas.threads);
        rasterizer.draw(list, &mut target);
        puts += target.finish();
        let band = frame.image(list.width, rows).average(canvas.samples as usize);
        for row in first..end {
            image.row_mut(row as usize).copy_from_slice(band.row((row - first) as usize));
        }
    }
    puts
}

/// Lets a rasterizer that can do so draw finished pixels over all of `image`; `None`, and nothing drawn, where it cannot.
///
/// The image has the size of the list divided by the samples of the canvas; frame after frame may go into the same one.
pub fn draw_pixels(
    list: &DrawList,
    rasterizer: &dyn Rasterizer,
    canvas: &Canvas,
    image: &mut Image,
) -> Option<PutCounts> {
    let &Canvas { samples, background, transparency: rule, threads } = canvas;
    let (width, counts) = (image.width(), PutCounts::default());
    let mut pixels = Pixels { width, samples, background, rule, threads, light: image.pixels_mut(), counts };
    rasterizer.draw_pixels(list, &mut pixels).then_some(pixels.counts)
}

impl Canvas {
    /// The canvas that a screen file describes.
    #[must_use]
    pub fn of_sheet(sheet: &Sheet) -> Canvas {
        let (samples, background, transparency) = (sheet.samples, sheet.background, sheet.transparency);
        Canvas { samples, background, transparency, threads: available_threads() }
    }
}

/// As many threads as the machine has; 1 where it does not tell.
#[must_use]
pub fn available_threads() -> u32 {
    std::thread::available_parallelism().map_or(1, |count| count.get() as u32)
}
