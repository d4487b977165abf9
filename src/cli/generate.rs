//! `farop generate`: a standard procedural database as an NFF file, or a scene for measuring as a `.ftri` file.

use super::error::CliError;
use super::scenes::find_built_in;
use crate::image::save::{SaveError, WholeFile};
use crate::parse::Format;
use crate::spd::{self, Curves, SpdError, bench};
use crate::write::write_ftri;
use clap::Args;
use std::io::Write;
use std::path::PathBuf;

/// A built-in scene as an NFF or .ftri file
#[derive(Args)]
#[command(
    after_help = "Examples:\n  farop generate balls --size 2 --resolution 3 -o balls.nff\n  farop generate flake:100k -o flake100k.ftri"
)]
pub(super) struct GenerateCommand {
    /// balls, gears, jacks, ..., flake:10k, fill_b2f, ...: see `farop list scenes`
    name: String,
    /// Size factor [default: the scene's own]
    #[arg(long, value_name = "N")]
    size: Option<u32>,
    /// Keep spheres and cones (the default)
    #[arg(long)]
    curves: bool,
    /// Turn them into triangles: 12 N N a sphere, 8 N a cone
    #[arg(long, value_name = "N", conflicts_with = "curves")]
    resolution: Option<u32>,
    /// File to write, `-` for standard output
    #[arg(short, long, value_name = "FILE.nff|ftri")]
    output: PathBuf,
}

impl GenerateCommand {
    pub fn run(self) -> Result<(), CliError> {
        if bench::is_family(&self.name) {
            return self.triangles();
        }
        let scene = find_built_in(&self.name)?;
        let size = self.size.unwrap_or(scene.default_size);
        let curves = self.resolution.map_or(Curves::Kept, Curves::Patches);
        if self.output.as_os_str() == "-" {
            return generate(scene, (size, curves), &mut std::io::stdout().lock(), &self.output);
        }
        let mut file = WholeFile::create(&self.output)?;
        generate(scene, (size, curves), &mut file, &self.output)?;
        Ok(file.commit()?)
    }

    /// A scene for measuring. It has no curves, and its size stands behind its name.
    fn triangles(&self) -> Result<(), CliError> {
        if self.size.is_some() || self.curves || self.resolution.is_some() {
            let name = self.name.split(':').next().unwrap_or_default();
            let help = format!("`{name}` takes neither --size nor --resolution: its size stands behind its name");
            return Err(CliError::failed(format!("{help}, as in `flake:100k`")));
        }
        let is_standard = self.output.as_os_str() == "-" || self.output.starts_with("/dev");
        if !is_standard && Format::of_path(&self.output) != Some(Format::Ftri) {
            return Err(CliError::failed(format!(
                "`{}` does not end in `.ftri`, and `{}` is written in no other format",
                self.output.display(),
                self.name
            )));
        }
        let triangles = bench::triangles(&self.name).map_err(CliError::failed)?;
        let failed = |error| SaveError::at(&self.output, error);
        if self.output.as_os_str() == "-" {
            return Ok(write_ftri(&triangles, &mut std::io::stdout().lock()).map_err(failed)?);
        }
        let mut file = WholeFile::create(&self.output)?;
        write_ftri(&triangles, &mut file).map_err(failed)?;
        Ok(file.commit()?)
    }
}

fn generate(
    scene: &spd::SpdScene,
    (size, curves): (u32, Curves),
    out: &mut dyn Write,
    path: &std::path::Path,
) -> Result<(), CliError> {
    spd::generate(scene, size, curves, out).map_err(|error| match error {
        SpdError::Io(error) => SaveError::at(path, error).into(),
        other => CliError::failed(other),
    })
}
