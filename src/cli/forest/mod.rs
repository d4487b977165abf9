//! `farop forest`: what is in a forest, pictures of it, walks through it.
//!
//! `.fcell`, `.fpack` -cells-> report, or observer -Composer-> Scene a frame -> picture, movie, hashes, figures
//!
//! One command and three verbs: the command looks, `pack`, `unpack` and `new` make files.

mod compose;
mod figures;
mod foreign;
pub(super) mod frame;
mod import;
mod inspect;
mod labels;
pub(super) mod maps;
mod observer;
mod options;
mod paint;
mod play;
mod stock;
mod walk;

use super::error::{self, CliError, notice};
use super::render::{check_extension, save_picture};
use super::scenes::{Chosen, find_rasterizer};
use crate::forest::cells::Cells;
use crate::image::Picture;
use crate::image::movie::Movie;
use crate::plan::Shading;
use crate::raster::Registry;
use crate::scene::Camera;
use compose::{Composer, Wanted};
use observer::Observer;
pub(super) use options::{DrapeName, ForestCommand};
use options::{TreesName, Verb};
use paint::Painter;
use play::{Over, Play};
use std::path::Path;

impl ForestCommand {
    pub fn run(mut self: Box<Self>, registry: &Registry) -> Result<(), CliError> {
        match self.verb {
            Some(Verb::Pack(ref pack)) => return pack.run(),
            Some(Verb::Unpack(ref unpack)) => return unpack.run(),
            Some(Verb::New(ref new)) => return new.run(),
            Some(Verb::Import(ref import)) => return import.run(),
            None => {}
        }
        self.check()?;
        let Some(path) = self.file.take() else {
            return Err(CliError::failed("name a forest, as in `farop forest area.fpack`"));
        };
        if self.output.is_none() && !self.walk.is_wanted() {
            if foreign::report(&path)? {
                return Ok(());
            }
            return inspect::report(&path, &stock::open(&path)?, self.year);
        }
        // Before minutes of work: is there such a rasterizer?
        let found = find_rasterizer(registry, &self.picture.rasterizer)?;
        let found =
            found.ok_or_else(|| CliError::failed("`-r none` draws nothing; leave it out, or name a rasterizer"))?;
        if found.name() == "wire" {
            self.picture.shading = Shading::Wire;
        }
        let cells = stock::open(&path)?;
        match &self.output {
            Some(output) => self.picture_of((&cells, folder_of(&path)), &found, output),
            None => self.walk_through(&path, &cells, &found),
        }
    }

    /// Contradictions that the parser of the command line does not see.
    fn check(&self) -> Result<(), CliError> {
        let walk = &self.walk;
        if walk.is_wanted() && self.output.is_some() {
            return Err(CliError::failed(
                "-o writes one picture; the pictures of a walk go to --frames OUT.gif|OUT.y4m|DIR",
            ));
        }
        if walk.is_wanted() && !walk.has_purpose() {
            return Err(CliError::failed(
                "what is to become of the walk? --frames OUT writes a movie, --benchmark measures, --hash compares, --record FILE keeps the path",
            ));
        }
        if walk.has_purpose() && !walk.is_wanted() {
            return Err(CliError::failed(
                "there is no walk: add --path FILE, --walk \"X Y H X Y H\", --input FILE or --tour",
            ));
        }
        if let Some(frames) = &walk.frames {
            Movie::check_name(frames).map_err(CliError::failed)?;
        }
        self.output.as_deref().map_or(Ok(()), check_extension)
    }

    /// Programs outside farop get colors and no pictures: trees are silhouettes then.
    fn has_silhouettes(&self, found: &Chosen<'_>) -> bool {
        let is_outside = matches!(found, Chosen::Outside(_)) && self.forest.trees != TreesName::Silhouettes;
        if is_outside {
            notice("programs outside farop get no pictures: trees are silhouettes, ground has one color a polygon");
        }
        is_outside || self.forest.trees == TreesName::Silhouettes
    }

    fn picture_of(&self, (cells, folder): (&Cells, &Path), found: &Chosen<'_>, output: &Path) -> Result<(), CliError> {
        let silhouettes = self.has_silhouettes(found);
        let shown = |year: Option<i32>, size: (u32, u32)| {
            let mut observer = Observer::new(year);
            let camera = observer.camera(&self.eye, cells, size)?;
            let mut painter = Painter::new(found.rasterizer(), &self.picture, size);
            let mut composer = Composer::new(&Wanted { cells, folder, options: &self.forest, year, silhouettes })?;
            play::frame(&camera, &mut composer, &mut painter)?;
            composer.map_told().iter().for_each(|told| notice(told));
            tell_borders(&composer);
            let picture = painter.picture()?;
            self.labeled(&picture, &camera, &painter, (cells, &mut observer))
        };
        let (width, height) = self.picture.size;
        let picture = match self.compare.as_deref() {
            Some(&[first, second]) => {
                let half = (width.saturating_sub(labels::LINE as u32) / 2, height);
                let pictures = [shown(Some(first), half)?, shown(Some(second), half)?];
                labels::side_by_side(pictures, [&first.to_string(), &second.to_string()])
            }
            _ => shown(self.year, (width, height))?,
        };
        save_picture(output, &picture)
    }

    fn labeled(
        &self,
        picture: &Picture,
        camera: &Camera,
        painter: &Painter<'_>,
        (cells, observer): (&Cells, &mut Observer),
    ) -> Result<Picture, CliError> {
        if !self.labels {
            return Ok(picture.clone());
        }
        labels::over(picture, camera, painter.choices(), &labels::landmarks(cells, observer)?)
    }

    fn walk_through(&self, path: &Path, cells: &Cells, found: &Chosen<'_>) -> Result<(), CliError> {
        let mut observer = Observer::new(self.year);
        if self.walk.collide.is_some() {
            observer.stand_in_the_way(compose::boxes(cells, folder_of(path))?);
        }
        let poses = walk::poses(self, cells, &mut observer)?;
        if !(self.walk.hash || self.walk.benchmark || self.walk.frames.is_some()) {
            return Ok(());
        }
        let size = self.picture.size;
        let camera = Camera { angle: self.eye.angle_of_view, ..observer.camera(&self.eye, cells, size)? };
        let mut painter = Painter::new(found.rasterizer(), &self.picture, size);
        let (folder, options, year, silhouettes) =
            (folder_of(path), &self.forest, self.year, self.has_silhouettes(found));
        let mut composer = Composer::new(&Wanted { cells, folder, options, year, silhouettes })?;
        let landmarks = labels::landmarks(cells, &mut observer)?;
        let choices = painter.choices().clone();
        let over = |picture: &Picture, camera: &Camera| labels::over(picture, camera, &choices, &landmarks);
        let over: Option<&Over<'_>> = if self.labels { Some(&over) } else { None };
        let figures = Play { walk: &self.walk, camera, over }.run(&poses, &mut composer, &mut painter)?;
        if self.walk.benchmark {
            let threads = self.picture.threads.map_or("all".to_string(), |threads| threads.to_string());
            let head = format!(
                "{}: {} frames of {}x{}, {samples} x {samples} samples, {}, {threads} threads",
                path.display(),
                poses.len(),
                size.0,
                size.1,
                found.name(),
                samples = self.picture.samples
            );
            error::print(&figures.text(&head, crate::report::peak_bytes()))?;
        }
        Ok(())
    }
}

/// Says how exactly the last frame kept borders between covers, if it did.
fn tell_borders(composer: &Composer<'_>) {
    if let Some(error) = composer.border_error() {
        notice(&format!("no wrong cover on the ground nearby is farther than {error:.2} m from a border"));
    }
}

/// Where pictures are that an area names.
fn folder_of(path: &Path) -> &Path {
    path.parent().unwrap_or(Path::new(""))
}
