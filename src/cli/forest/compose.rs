//! The scene of one frame, for now of the ground alone.

use super::options::Forest;
use crate::cli::error::CliError;
use crate::forest::cells::Cells;
use crate::scene::{Camera, Scene};

/// What a frame shows.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Shown {
    pub trees: u64,
    pub terrain: u64,
}

/// Makes the scene of a frame.
pub(super) struct Composer<'a> {
    _cells: &'a Cells,
    scene: Scene,
}

impl<'a> Composer<'a> {
    pub fn new(
        cells: &'a Cells,
        _options: &Forest,
        _year: Option<i32>,
        _silhouettes: bool,
    ) -> Result<Composer<'a>, CliError> {
        Ok(Composer { _cells: cells, scene: Scene::default() })
    }

    pub fn compose(&mut self, camera: &Camera) -> Result<(&Scene, Shown), CliError> {
        self.scene.camera = Some(*camera);
        Ok((&self.scene, Shown::default()))
    }
}
