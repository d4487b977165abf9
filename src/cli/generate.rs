//! `farop generate`: a standard procedural database as an NFF file.

use super::error::CliError;
use super::scenes::find_built_in;
use crate::image::save::{SaveError, WholeFile};
use crate::spd::{self, Curves, SpdError};
use clap::Args;
use std::io::Write;
use std::path::PathBuf;

/// A built-in scene as an NFF file
#[derive(Args)]
#[command(
    after_help = "Examples:\n  farop generate gears --size 4 -o gears.nff\n  farop generate balls --size 2 --resolution 3 -o balls.nff"
)]
pub(super) struct GenerateCommand {
    /// balls, gears, jacks, ...: see `farop list scenes`
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
    #[arg(short, long, value_name = "FILE.nff")]
    output: PathBuf,
}

impl GenerateCommand {
    pub fn run(self) -> Result<(), CliError> {
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
