//! `farop convert`: scenes as one file, by its ending: NFF, polygons in world coordinates; or SIPP, the tree as it is; areas of forest as text or pack.

use super::error::{self, CliError, notice};
use super::options::PictureOptions;
use super::scenes::{SceneOptions, make_plan};
use crate::diagnostic::Diagnostics;
use crate::forest::pack::write_cells;
use crate::geometry::flatten;
use crate::image::save::{SaveError, WholeFile, write_streamed};
use crate::parse::{Format, load_cells};
use crate::write::{write_fcell, write_nff, write_sipp};
use clap::Args;
use std::path::{Path, PathBuf};

/// Scenes as one file: NFF (polygons in world coordinates) or SIPP
#[derive(Args)]
#[command(
    after_help = "Examples:\n  farop convert spd:balls:2 -o balls.nff\n  farop convert a.nff b.nff --triangles -o merged.nff"
)]
pub(super) struct ConvertCommand {
    #[command(flatten)]
    scenes: SceneOptions,
    /// File to write: FILE.nff, FILE.sipp, or `-`: NFF on standard output; of an area also FILE.fcell, FILE.fpack
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
    #[command(flatten)]
    picture: PictureOptions,
}

impl ConvertCommand {
    pub fn run(self) -> Result<(), CliError> {
        if let Some(format @ (Format::Fcell | Format::Fpack)) = Format::of_path(&self.output) {
            return self.area(format);
        }
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

    /// An area of forest stays one: text becomes a pack and a pack text, cell by cell.
    fn area(self, format: Format) -> Result<(), CliError> {
        let [name] = self.scenes.scenes.as_slice() else {
            return Err(CliError::failed("areas of forest do not merge: convert one at a time"));
        };
        let diagnosed = |errors: Diagnostics| CliError::Diagnosed(errors.render(error::stderr_has_color()));
        let (cells, notices) = load_cells(Path::new(name)).map_err(diagnosed)?;
        if !notices.is_empty() {
            error::diagnose(&notices.render(error::stderr_has_color()));
        }
        if format == Format::Fcell {
            let written = write_streamed(&self.output, |out| write_fcell(&cells, out));
            return written.map_err(CliError::from);
        }
        let counts = write_cells(&cells, &self.output);
        let counts = counts.map_err(CliError::failed)?;
        notice(&format!("{} cells, {} bytes; the largest cell has {}", counts.cells, counts.bytes, counts.largest));
        Ok(())
    }
}
