//! The scene of one frame: the composer's, or with silhouettes in place of pictures.

use super::maps;
use super::options::{Forest, NearName, SeasonName, TreesName};
use crate::cli::error::{self, CliError};
use crate::forest::cells::Cells;
use crate::forest::frame::{self, FrameCounts, Trees};
use crate::forest::heights::Heights;
use crate::forest::objects::stand;
use crate::forest::pictures::Pictures;
use crate::forest::season::Season;
use crate::forest::silhouette::without_pictures;
use crate::math::Vec3;
use crate::parse::load_models;
use crate::scene::{Camera, Scene};
use std::path::Path;

/// Makes the scene of a frame.
pub(super) struct Composer<'a> {
    composer: frame::Composer<'a>,
    /// The scene without pictures, where that is asked for.
    flat: Option<Scene>,
}

/// What is composed.
#[derive(Clone, Copy)]
pub(super) struct Wanted<'a> {
    pub cells: &'a Cells,
    /// Where pictures are that the area names.
    pub folder: &'a Path,
    pub options: &'a Forest,
    pub year: Option<i32>,
    pub silhouettes: bool,
}

impl<'a> Composer<'a> {
    pub fn new(wanted: &Wanted<'a>) -> Result<Composer<'a>, CliError> {
        let pictures = Pictures::new(wanted.cells.head(), wanted.folder).map_err(CliError::failed)?;
        let pictures = match season(wanted.options, &wanted.cells.head().crs) {
            Some(season) => season.dress(wanted.cells.head(), pictures),
            None => pictures,
        };
        let choices = choices(wanted.options, wanted.year);
        let mut composer = frame::Composer::new(wanted.cells, pictures, choices).map_err(CliError::failed)?;
        let models = load_models(wanted.cells.head(), wanted.folder);
        let models = models.map_err(|errors| CliError::Diagnosed(errors.render(error::stderr_has_color())))?;
        composer.stand_objects(&models).map_err(CliError::failed)?;
        if let Some((name, shapes)) = maps::of(wanted.options, wanted.cells.head())? {
            composer.lay_map(&name, shapes, maps::laying(wanted.options)).map_err(CliError::failed)?;
        }
        Ok(Composer { composer, flat: wanted.silhouettes.then(Scene::default) })
    }

    /// How sharp the map of the last frame was, in words.
    pub fn map_told(&self) -> Option<String> {
        self.composer.map_figures().as_ref().map(maps::told)
    }

    /// Metres within which every wrong cover of the last frame is from a border, where borders are kept.
    pub fn border_error(&self) -> Option<f64> {
        self.composer.border_error()
    }

    /// The scene that `camera` sees.
    pub fn compose(&mut self, camera: &Camera) -> Result<(&Scene, FrameCounts), CliError> {
        let (scene, counts) = self.composer.compose(camera, camera.resolution).map_err(CliError::failed)?;
        match &mut self.flat {
            None => Ok((scene, counts)),
            Some(flat) => {
                *flat = without_pictures(scene);
                Ok((flat, counts))
            }
        }
    }
}

/// Boxes around what stands on an area, world space.
pub(super) fn boxes(cells: &Cells, folder: &Path) -> Result<Vec<[Vec3; 2]>, CliError> {
    let models = load_models(cells.head(), folder);
    let models = models.map_err(|errors| CliError::Diagnosed(errors.render(error::stderr_has_color())))?;
    let mut heights = Heights::default();
    let stood = stand(cells.head(), &models, |place| heights.at(cells, place).unwrap_or_default());
    Ok(stood.map_err(CliError::failed)?.boxes)
}

/// The season that options name.
fn season(options: &Forest, crs: &str) -> Option<Season> {
    let named = options.season.map(|name| match name {
        SeasonName::Spring => Season::Spring,
        SeasonName::Summer => Season::Summer,
        SeasonName::Autumn => Season::Autumn,
        SeasonName::Winter => Season::Winter,
    });
    named.or(options.day.map(|day| Season::of_day(day, crs)))
}

/// The choices that options make.
fn choices(options: &Forest, year: Option<i32>) -> frame::Choices {
    let trees = match options.trees {
        TreesName::Auto | TreesName::Silhouettes => Trees::Auto,
        TreesName::Crossed => Trees::Crossed,
        TreesName::Billboards => Trees::Billboards,
        TreesName::Mesh => Trees::Solids,
        TreesName::None => Trees::None,
    };
    let Forest { horizon, tolerance, cover_tolerance, .. } = *options;
    let solid_above = (options.near_trees == NearName::Mesh).then_some(options.near_height);
    frame::Choices { solid_above, year, horizon, tolerance, trees, cover_tolerance, ..frame::Choices::default() }
}
