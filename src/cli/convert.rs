//! `farop convert`: scenes as one file, by its ending: NFF, polygons in world coordinates; or SIPP, the tree as it is.

use super::error::{CliError, notice};
use super::options::PictureOptions;
use super::scenes::{SceneOptions, make_plan};
use crate::geometry::flatten;
use crate::image::save::{SaveError, WholeFile};
use crate::write::{write_nff, write_sipp};
use clap::Args;
use std::path::PathBuf;

/// Scenes as one file: NFF (polygons in world coordinates) or SIPP
#[derive(Args)]
#[command(
    after_help = "Examples:\n  farop convert spd:balls:2 -o balls.nff\n  farop convert a.nff b.nff --triangles -o merged.nff"
)]
pub(super) struct ConvertCommand {
    #[command(flatten)]
    scenes: SceneOptions,
    /// File to write: FILE.nff, FILE.sipp, or `-`: NFF on standard output
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
    #[command(flatten)]
    picture: PictureOptions,
}

impl ConvertCommand {
    pub fn run(self) -> Result<(), CliError> {
        let loaded = self.scenes.load(&self.picture)?;
        let plan = make_plan(&loaded.scene, &self.picture, None)?;
        // NFF has neither tree nor most shapes; in `.sipp` both stay, unless triangles are asked for.
        let is_sipp = self.output.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("sipp"));
        let stays_a_tree = is_sipp && !plan.choices.triangles;
        let mut scene = if stays_a_tree { loaded.scene } else { flatten(&loaded.scene, &plan, plan.choices.triangles) };
        if let Some(camera) = &mut scene.camera {
            camera.resolution = plan.view.pixels;
        }
        let write = if is_sipp { write_sipp } else { write_nff };
        let failed = |error| CliError::from(SaveError::at(&self.output, error));
        let lost = if self.output.as_os_str() == "-" {
            write(&scene, &mut std::io::stdout().lock()).map_err(failed)?
        } else {
            let mut file = WholeFile::create(&self.output)?;
            let lost = write(&scene, &mut file).map_err(failed)?;
            file.commit()?;
            lost
        };
        let format = if is_sipp { "SIPP" } else { "NFF" };
        lost.iter().for_each(|text| notice(&format!("not in the {format} file: {text}")));
        Ok(())
    }
}
