//! `farop dump`: a screen-coordinate file, for a rasterizer anywhere.

use super::error::{CliError, notice};
use super::options::PictureOptions;
use super::scenes::{SceneOptions, as_rasterizer, find_rasterizer};
use crate::image::save::{SaveError, WholeFile};
use crate::plan::{Choices, Shading};
use crate::raster::Registry;
use crate::render;
use crate::scene::Scene;
use crate::screen::DrawList;
use crate::screen::file::{Attributes, ClassicOptions, ScreenWriteError, Sheet, write_classic, write_v2};
use clap::Args;
use std::io::Write;
use std::path::{Path, PathBuf};

/// A screen-coordinate file of scenes: everything a rasterizer needs
#[derive(Args)]
#[command(
    after_help = "Examples:\n  farop dump spd:gears -o gears.scr\n  farop dump spd:teapot --classic --yon 20 -o teapot.scr"
)]
pub(super) struct DumpCommand {
    #[command(flatten)]
    scenes: SceneOptions,
    /// File to write, `-` for standard output
    #[arg(short, long, value_name = "FILE.scr")]
    output: PathBuf,
    #[command(flatten)]
    format: DumpFormat,
    /// Rasterizer the file is made for: decides what is split
    #[arg(short, long, value_name = "NAME", default_value = "none")]
    rasterizer: String,
    #[command(flatten)]
    picture: PictureOptions,
}

/// Which kind of file, and how fine.
#[derive(Args, Clone, Debug)]
pub(super) struct DumpFormat {
    /// FAROP's integer file instead of the lossless one
    #[arg(long)]
    classic: bool,
    /// At the vertices: color, phong (normals and eye points), texture (u and v, and the pictures)
    #[arg(long, value_name = "NAMES", value_parser = attributes, conflicts_with = "classic")]
    attributes: Option<Attributes>,
    /// Largest z of a classic file
    #[arg(long, value_name = "N", requires = "classic", default_value_t = 65535)]
    z_resolution: u32,
    /// Largest color of a classic file
    #[arg(long, value_name = "N", requires = "classic", default_value_t = 255)]
    color_resolution: u32,
}

fn attributes(names: &str) -> Result<Attributes, String> {
    Attributes::from_names(names).ok_or_else(|| "there is color, phong, texture".to_string())
}

impl DumpCommand {
    pub fn run(self, registry: &Registry) -> Result<(), CliError> {
        let loaded = self.scenes.load(&self.picture)?;
        let registered = find_rasterizer(registry, &self.rasterizer)?;
        let mut choices = self.picture.choices();
        if self.format.attributes.is_some_and(|attributes| attributes.phong) && choices.shading != Shading::Phong {
            notice("--attributes phong: the file is made with phong shading");
            choices.shading = Shading::Phong;
        }
        let plan_for = as_rasterizer(&registered);
        let list = render::list(&loaded.scene, &choices, plan_for)?;
        self.format.write(&self.output, &list, &sheet(&loaded.scene, &choices))
    }
}

/// What a screen file says of the picture besides its polygons.
pub(super) fn sheet(scene: &Scene, choices: &Choices) -> Sheet {
    let canvas = render::Canvas::new(scene, choices);
    let (samples, background, transparency) = (canvas.samples, canvas.background, canvas.transparency);
    Sheet { samples, background, transparency, encoding: choices.encoding }
}

impl DumpFormat {
    /// The lossless file with what the list carries.
    pub fn lossless() -> DumpFormat {
        DumpFormat { classic: false, attributes: None, z_resolution: 65535, color_resolution: 255 }
    }

    /// Whether this is FAROP's integer file.
    pub fn is_classic(&self) -> bool {
        self.classic
    }

    /// Writes `list` to `path` (`-`: standard output), whole or not at all.
    pub fn write(&self, path: &Path, list: &DrawList, sheet: &Sheet) -> Result<(), CliError> {
        if path.as_os_str() == "-" {
            return self.write_to(&mut std::io::stdout().lock(), list, sheet).map_err(|error| failed(path, error));
        }
        let mut file = WholeFile::create(path)?;
        self.write_to(&mut file, list, sheet).map_err(|error| failed(path, error))?;
        Ok(file.commit()?)
    }

    /// Writes `list` to `out`; prints what a classic file had to leave open.
    pub fn write_to(&self, out: &mut dyn Write, list: &DrawList, sheet: &Sheet) -> Result<(), ScreenWriteError> {
        if !self.classic {
            return write_v2(list, sheet, self.attributes.unwrap_or_default(), out);
        }
        let (z_resolution, color_resolution) = (self.z_resolution, self.color_resolution);
        let options = ClassicOptions { z_resolution, color_resolution, yon: None, encoding: sheet.encoding };
        if list.has_texture() {
            notice(&format!("{} polygons lose their pictures in a classic file", list.textured_polygons()));
        }
        let report = write_classic(list, &options, out)?;
        notice(&format!("z is {z_resolution} at yon {}", report.yon));
        if report.transparent > 0 {
            notice(&format!("{} transparent polygons are opaque in a classic file", report.transparent));
        }
        if report.collapsed > 0 {
            notice(&format!("{} polygons are too small for whole coordinates: they cover nothing", report.collapsed));
        }
        Ok(())
    }
}

fn failed(path: &Path, error: ScreenWriteError) -> CliError {
    match error {
        ScreenWriteError::Io(error) => SaveError::at(path, error).into(),
        other => CliError::failed(other),
    }
}
