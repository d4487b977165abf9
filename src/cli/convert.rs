//! `farop convert`: scenes as one NFF file of polygons in world coordinates.

use super::error::{CliError, notice};
use super::options::PictureOptions;
use super::scenes::{SceneOptions, make_plan};
use crate::geometry::flatten;
use crate::image::save::{SaveError, WholeFile};
use crate::write::write_nff;
use clap::Args;
use std::path::PathBuf;

/// Scenes as one NFF file: polygons only, in world coordinates
#[derive(Args)]
#[command(
    after_help = "Examples:\n  farop convert spd:balls:2 -o balls.nff\n  farop convert a.nff b.nff --triangles -o merged.nff"
)]
pub(super) struct ConvertCommand {
    #[command(flatten)]
    scenes: SceneOptions,
    /// File to write, `-` for standard output
    #[arg(short, long, value_name = "FILE.nff")]
    output: PathBuf,
    #[command(flatten)]
    picture: PictureOptions,
}

impl ConvertCommand {
    pub fn run(self) -> Result<(), CliError> {
        let loaded = self.scenes.load(&self.picture)?;
        let plan = make_plan(&loaded.scene, &self.picture, None)?;
        let mut flat = flatten(&loaded.scene, &plan, plan.choices.triangles);
        if let Some(camera) = &mut flat.camera {
            camera.resolution = plan.view.pixels;
        }
        let failed = |error| CliError::from(SaveError::at(&self.output, error));
        let lost = if self.output.as_os_str() == "-" {
            write_nff(&flat, &mut std::io::stdout().lock()).map_err(failed)?
        } else {
            let mut file = WholeFile::create(&self.output)?;
            let lost = write_nff(&flat, &mut file).map_err(failed)?;
            file.commit()?;
            lost
        };
        lost.iter().for_each(|text| notice(&format!("not in the NFF file: {text}")));
        Ok(())
    }
}
