//! One frame of a forest, for commands that take scenes; and the lab of a forest.
//!
//! A large pack is no scene: thirty million trees do not fit. What a camera sees of it is one.

use super::observer::Observer;
use super::options::Eye;
use super::{folder_of, stock};
use crate::cli::error::{self, CliError};
use crate::cli::options::PictureOptions;
use crate::forest::cells::Cells;
use crate::forest::frame::{Choices, Composer};
use crate::forest::pictures::Pictures;
use crate::lab::Row;
use crate::lab::forest::{Subject, run, ways};
use crate::lab::measure::Effort;
use crate::parse::load_models;
use crate::raster::Rasterizer;
use crate::scene::{Camera, Scene};
use std::path::Path;

/// Packs of more cells than these are shown as frames.
const MOST_CELLS: usize = 64;
/// The size of a picture where nobody says one.
const SIZE: (u32, u32) = (640, 480);

/// The scene of what a camera sees of a pack, if `path` is one and too large for a scene of all its trees; and a notice that says so.
pub(in crate::cli) fn of_large_pack(
    path: &Path,
    picture: &PictureOptions,
) -> Result<Option<(Scene, String)>, CliError> {
    if !stock::is_pack(path) || !path.is_file() {
        return Ok(None);
    }
    let cells = stock::open(path)?;
    let count = cells.indices().len();
    if count <= MOST_CELLS {
        return Ok(None);
    }
    let camera = camera(&cells, picture)?;
    let choices = Choices::default();
    let mut composer = composer(&cells, path, choices)?;
    let (scene, counts) = composer.compose(&camera, camera.resolution).map_err(CliError::failed)?;
    let notice = format!(
        "{}: of {count} cells, the {} trees that the camera sees within {} m; `farop forest` has all choices",
        path.display(),
        counts.submitted,
        choices.horizon
    );
    Ok(Some((scene.clone(), notice)))
}

fn composer<'a>(cells: &'a Cells, path: &Path, choices: Choices) -> Result<Composer<'a>, CliError> {
    let pictures = Pictures::new(cells.head(), folder_of(path)).map_err(CliError::failed)?;
    let mut composer = Composer::new(cells, pictures, choices).map_err(CliError::failed)?;
    let models = load_models(cells.head(), folder_of(path));
    let models = models.map_err(|errors| CliError::Diagnosed(errors.render(error::stderr_has_color())))?;
    composer.stand_objects(&models).map_err(CliError::failed)?;
    Ok(composer)
}

/// The camera of an observer who was told nothing, and what the command line makes of it.
fn camera(cells: &Cells, picture: &PictureOptions) -> Result<Camera, CliError> {
    let size = picture.choices().size.unwrap_or(SIZE);
    let camera = Observer::new(None).camera(&Eye::usual(), cells, size)?;
    let mut scene = Scene { camera: Some(camera), ..Scene::default() };
    picture.override_view(&mut scene);
    Ok(scene.camera.unwrap_or(camera))
}

/// The rows of `farop lab PACK`.
pub(in crate::cli) fn lab(
    path: &Path,
    picture: &PictureOptions,
    rasterizer: &dyn Rasterizer,
    (effort, progress): (&Effort, crate::lab::Progress<'_>),
) -> Result<(Vec<Row>, (u32, u32)), CliError> {
    let cells = stock::open(path)?;
    let pictures = Pictures::new(cells.head(), folder_of(path)).map_err(CliError::failed)?;
    let camera = camera(&cells, picture)?;
    let subject = Subject { cells: &cells, pictures: &pictures, camera, rasterizer };
    let ways = ways(&Choices::default(), &picture.choices());
    let rows = run(&subject, &ways, (effort, progress)).map_err(CliError::failed)?;
    Ok((rows, camera.resolution))
}

/// Whether the lab of a forest is meant.
pub(in crate::cli) fn is_forest(scenes: &[String]) -> bool {
    matches!(scenes, [one] if stock::is_pack(Path::new(one)))
}
