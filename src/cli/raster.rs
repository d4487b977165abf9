//! `farop raster`: a picture from a screen-coordinate file, of either kind.

use super::error::CliError;
use super::options::encoding;
use super::render::{check_extension, save_picture};
use super::scenes::{as_rasterizer, check_drawn, find_rasterizer};
use crate::color::Encoding;
use crate::plan::Varying;
use crate::raster::Registry;
use crate::render::{self, Canvas};
use crate::screen::file::{ReadOptions, ScreenFile, read};
use clap::Args;
use std::io::Read;
use std::path::{Path, PathBuf};

/// A picture from a screen-coordinate file
#[derive(Args)]
#[command(
    after_help = "Examples:\n  farop raster gears.scr -o gears.png\n  farop dump spd:balls -o - | farop raster - -o balls.ppm"
)]
pub(super) struct RasterCommand {
    /// Screen-coordinate file, classic or v2; `-` for standard input
    file: PathBuf,
    /// Picture to write, .png or .ppm
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
    /// Rasterizer: zbuffer, watkins, scanline, wire, a plugged-in one, exec:COMMAND or lib:PATH
    #[arg(short, long, value_name = "NAME", default_value = "zbuffer")]
    rasterizer: String,
    /// What the colors of a classic file mean: srgb or linear
    #[arg(long, value_name = "NAME", default_value = "srgb", value_parser = encoding)]
    encoding: Encoding,
    /// Refuse larger pictures
    #[arg(long, value_name = "N", default_value_t = 1 << 28)]
    max_pixels: u64,
}

impl RasterCommand {
    pub fn run(self, registry: &Registry) -> Result<(), CliError> {
        check_extension(&self.output)?;
        let options = ReadOptions { encoding: self.encoding, max_pixels: self.max_pixels };
        let file = read_screen_file(&self.file, &options)?;
        // A file without anything that varies was made for wire.
        let name = if file.list.varying == Varying::Nothing && self.rasterizer == "zbuffer" {
            "wire"
        } else {
            &self.rasterizer
        };
        let registered = find_rasterizer(registry, name)?;
        let (image, puts) = render::draw(&file.list, as_rasterizer(&registered), &Canvas::of_sheet(&file.sheet));
        check_drawn(&puts)?;
        save_picture(&self.output, &image.encode(file.sheet.encoding))
    }
}

/// The screen file at `path`, or on standard input where that is `-`.
pub(super) fn read_screen_file(path: &Path, options: &ReadOptions) -> Result<ScreenFile, CliError> {
    read(&read_text(path)?, options).map_err(|error| {
        let help = error.help.as_ref().map_or(String::new(), |help| format!("\nhelp: {help}"));
        CliError::failed(format!("{}: {error}{help}", path.display()))
    })
}

fn read_text(path: &Path) -> Result<String, CliError> {
    let mut bytes = Vec::new();
    let result = if path.as_os_str() == "-" {
        std::io::stdin().lock().read_to_end(&mut bytes)
    } else {
        std::fs::File::open(path).and_then(|mut file| file.read_to_end(&mut bytes))
    };
    result.map_err(|error| CliError::failed(format!("cannot read {}: {error}", path.display())))?;
    String::from_utf8(bytes).map_err(|error| {
        let place = error.utf8_error().valid_up_to();
        CliError::failed(format!(
            "{} is not text: byte {place} belongs to no character; is it a screen file?",
            path.display()
        ))
    })
}
