//! Frames: the forest around an observer, as a picture.
//!
//! Camera -Composer-> Scene -plan, geometry-> DrawList -rasterizer-> light -> levels
//!
//! Memory is kept from frame to frame: after the first ones a walk allocates little.

use super::options::Picture as PictureOptions;
use crate::cli::error::CliError;
use crate::geometry::Stage;
use crate::image::{Image, Picture};
use crate::plan::{Choices, Plan};
use crate::raster::{Frame, Rasterizer};
use crate::render::{self, Canvas};
use crate::report::StageTimer;
use crate::scene::Scene;
use crate::screen::DrawList;

/// What one frame took and showed.
#[derive(Clone, Debug, Default)]
pub(super) struct Painted {
    /// Milliseconds of composing, geometry, rasterizer, levels.
    pub milliseconds: [f64; 4],
    /// Trees in view.
    pub trees: u64,
    /// Trees that are meshes, and their triangles.
    pub solids: [u64; 2],
    /// Polygons of the ground.
    pub terrain: u64,
    /// Polygons that the rasterizer was given.
    pub polygons: u64,
    /// Samples put, and those of them that were put over others; a rasterizer that hands over finished pixels counts none of these.
    pub puts: u64,
    pub overdraw: u64,
}

impl Painted {
    /// Milliseconds of the frame.
    pub fn total(&self) -> f64 {
        self.milliseconds.iter().sum()
    }
}

/// Makes pictures of scenes, one after the other.
pub(super) struct Painter<'a> {
    rasterizer: &'a dyn Rasterizer,
    choices: Choices,
    stage: Stage,
    list: DrawList,
    frame: Frame,
    image: Image,
    levels: Vec<u8>,
}

impl<'a> Painter<'a> {
    pub fn new(rasterizer: &'a dyn Rasterizer, options: &PictureOptions, size: (u32, u32)) -> Painter<'a> {
        let image = Image::new(0, 0, crate::color::Rgb::gray(0.0));
        let (stage, list, frame) = (Stage::default(), DrawList::new(0, 0), Frame::default());
        let choices = Choices {
            size: Some(size),
            shading: options.shading,
            samples: options.samples,
            threads: options.threads,
            alpha: options.alpha,
            encoding: options.encoding,
            ..Choices::default()
        };
        Painter { rasterizer, choices, stage, list, frame, image, levels: Vec::new() }
    }

    /// What the pictures are made with.
    pub fn choices(&self) -> &Choices {
        &self.choices
    }

    /// Draws a scene; the levels are kept until the next one.
    pub fn paint(&mut self, scene: &Scene) -> Result<Painted, CliError> {
        let timer = StageTimer::start();
        let plan = Plan::new(scene, &self.choices, self.rasterizer.accepts())?;
        self.stage.run(scene, &plan, &mut self.list);
        let geometry = timer.stop().elapsed;
        let (width, height) = plan.view.pixels;
        if (self.image.width(), self.image.height()) != (width as usize, height as usize) {
            self.image = Image::new(width as usize, height as usize, crate::color::Rgb::gray(0.0));
        }
        let canvas = Canvas::new(scene, &self.choices);
        let timer = StageTimer::start();
        let puts = render::draw_into(&self.list, self.rasterizer, &canvas, (&mut self.frame, &mut self.image));
        let raster = timer.stop().elapsed;
        crate::cli::scenes::check_drawn(&puts)?;
        let timer = StageTimer::start();
        self.image.encode_into(self.choices.encoding, canvas.threads, &mut self.levels);
        let levels = timer.stop().elapsed;
        let polygons = self.list.len() as u64;
        Ok(Painted {
            milliseconds: [0.0, geometry, raster, levels],
            polygons,
            puts: puts.puts,
            overdraw: puts.overdraw,
            ..Painted::default()
        })
    }

    /// Red, green and blue of every pixel of the last frame.
    pub fn levels(&self) -> &[u8] {
        &self.levels
    }

    /// The last frame.
    pub fn picture(&self) -> Result<Picture, CliError> {
        Picture::from_rgb(self.image.width(), self.image.height(), self.levels.clone()).map_err(CliError::failed)
    }
}
