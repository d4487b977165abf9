//! Plays a walk: a picture a pose, into a movie, as hashes, or for the time it takes.

use super::compose::Composer;
use super::figures::Figures;
use super::options::Walk;
use super::paint::{Painted, Painter};
use crate::cli::error::{self, CliError, notice};
use crate::image::Picture;
use crate::image::movie::Movie;
use crate::report::StageTimer;
use crate::scene::Camera;
use crate::view::path::Pose;
use sha2::{Digest, Sha256};
use std::fmt::Write;

/// What writes over a frame.
pub(super) type Over<'a> = dyn Fn(&Picture, &Camera) -> Result<Picture, CliError> + 'a;

/// What becomes of each frame.
pub(super) struct Play<'a> {
    pub walk: &'a Walk,
    /// Everything of the camera but the pose.
    pub camera: Camera,
    /// What is written over a frame, if anything.
    pub over: Option<&'a Over<'a>>,
}

impl Play<'_> {
    /// Plays `poses`; the figures of all frames.
    pub fn run(
        &self,
        poses: &[Pose],
        composer: &mut Composer<'_>,
        painter: &mut Painter<'_>,
    ) -> Result<Figures, CliError> {
        let size = self.camera.resolution;
        let movie = self.walk.frames.as_deref();
        let movie = movie.map(|path| Movie::create(path, (size.0 as usize, size.1 as usize), self.walk.rate));
        let mut movie = movie.transpose().map_err(CliError::failed)?;
        let mut figures = Figures::default();
        let mut hashes = String::new();
        for pose in poses {
            let camera = Camera { from: pose.from, at: pose.at, up: pose.up, ..self.camera };
            figures.add(frame(&camera, composer, painter)?);
            if self.walk.hash {
                // The levels alone: what is written over them is not the forest.
                let _ = writeln!(hashes, "{}", hash(painter.levels()));
                error::print(&std::mem::take(&mut hashes))?;
            }
            if let Some(movie) = &mut movie {
                let picture = painter.picture()?;
                let picture = self.over.map_or(Ok(picture.clone()), |over| over(&picture, &camera))?;
                movie.push(&picture).map_err(CliError::failed)?;
            }
        }
        if let (Some(movie), Some(path)) = (movie, &self.walk.frames) {
            let frames = movie.finish().map_err(CliError::failed)?;
            notice(&format!("{}: {frames} frames of {}x{}", path.display(), size.0, size.1));
        }
        Ok(figures)
    }
}

/// One frame: composed and painted.
pub(super) fn frame(
    camera: &Camera,
    composer: &mut Composer<'_>,
    painter: &mut Painter<'_>,
) -> Result<Painted, CliError> {
    let timer = StageTimer::start();
    let (scene, counts) = composer.compose(camera)?;
    let composing = timer.stop().elapsed;
    let mut painted = painter.paint(scene)?;
    painted.milliseconds[0] = composing;
    let solids = [counts.solid, counts.solid_triangles];
    Ok(Painted { solids, trees: counts.submitted, terrain: counts.terrain_polygons, ..painted })
}

fn hash(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}
