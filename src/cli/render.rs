//! `farop render`: a picture, on disk or in the terminal.

use super::error::{self, CliError};
use super::options::{PictureOptions, PromiseOptions};
use super::scenes::{SceneOptions, as_rasterizer, check_drawn, find_rasterizer};
use super::stages::StageName;
use super::stats::{self, StatsFormat};
use crate::image::{Picture, encode_for, save, terminal};
use crate::plan::Shading;
use crate::raster::Registry;
use crate::render;
use crate::report::StageTimer;
use clap::Args;
use std::path::{Path, PathBuf};

/// A picture of scenes
#[derive(Args)]
#[command(
    after_help = "Examples:\n  farop render spd:gears -o gears.png\n  farop render scene.nff -s phong --samples 4 --size 640x480 -o phong.png"
)]
pub(super) struct RenderCommand {
    #[command(flatten)]
    scenes: SceneOptions,
    /// Picture to write, .png or .ppm; without it, the picture in the terminal
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Rasterizer: zbuffer, watkins, scanline, wire, none (counts and times only), a plugged-in one, exec:COMMAND or lib:PATH
    #[arg(short, long, value_name = "NAME", default_value = "zbuffer")]
    rasterizer: String,
    /// Counts and times, as text or as json
    #[arg(long, value_name = "FORMAT", num_args = 0..=1, require_equals = true, default_missing_value = "text")]
    stats: Option<StatsFormat>,
    /// Also write the screen-coordinate file
    #[arg(long, value_name = "FILE.scr")]
    dump: Option<PathBuf>,
    /// Print the values of a stage: scene, plan, eye, clip or screen
    #[arg(long, value_name = "NAME")]
    dump_stage: Option<StageName>,
    /// Draw only this screen polygon (numbers as `farop why` gives them)
    #[arg(long, value_name = "POLYGON")]
    only: Option<usize>,
    /// Draw only the first N screen polygons
    #[arg(long, value_name = "N", conflicts_with = "only")]
    first: Option<usize>,
    #[command(flatten)]
    promise: PromiseOptions,
    #[command(flatten)]
    picture: PictureOptions,
}

impl RenderCommand {
    pub fn run(self, registry: &Registry) -> Result<(), CliError> {
        let loaded = self.scenes.load(&self.picture)?;
        let mut choices = self.picture.choices();
        // `-s wire` and `-r wire` are one thing.
        let name =
            if choices.shading == Shading::Wire && self.rasterizer == "zbuffer" { "wire" } else { &self.rasterizer };
        if name == "wire" {
            choices.shading = Shading::Wire;
        }
        let registered = find_rasterizer(registry, name)?;
        if let Some(path) = &self.output {
            check_extension(path)?;
        }
        if let Some(goal) = self.promise.max_error {
            let areas = as_rasterizer(&registered).filter(|_| name != "wire");
            let promise = super::plan::promise(&loaded.scene, &choices, areas, goal)?;
            error::tell(&promise.text());
            choices = promise.choices;
        }
        if let Some(stage) = self.dump_stage {
            error::print(&stage.text(&loaded.scene, &choices, as_rasterizer(&registered))?)?;
            if self.output.is_none() {
                return Ok(());
            }
        }
        let mut rendered =
            render::render_with(&loaded.scene, &choices, as_rasterizer(&registered), |list| self.cut(list))?;
        check_drawn(&rendered.puts)?;
        rendered.times.parse = loaded.parse_time;
        if let Some(path) = &self.dump {
            super::dump::DumpFormat::lossless().write(
                path,
                &rendered.list,
                &super::dump::sheet(&loaded.scene, &choices),
            )?;
        }
        let timer = StageTimer::start();
        self.show(&rendered.image.encode(choices.encoding))?;
        rendered.times.write = timer.stop();
        if let Some(format) = self.stats {
            let output = self.output.as_deref();
            error::print(&stats::text(format, &loaded, &rendered, (name, output)))?;
        }
        Ok(())
    }

    /// Leaves in `list` what `--only` and `--first` ask for.
    fn cut(&self, list: &mut crate::screen::DrawList) {
        if let Some(only) = self.only {
            list.polygons = list.polygons.get(only).copied().into_iter().collect();
        }
        if let Some(first) = self.first {
            list.polygons.truncate(first);
        }
    }

    fn show(&self, picture: &Picture) -> Result<(), CliError> {
        if self.rasterizer == "none" {
            return Ok(());
        }
        match &self.output {
            Some(path) => save_picture(path, picture),
            None if self.stats == Some(StatsFormat::Json) => Ok(()),
            None => {
                let preview = terminal::half_blocks(picture, 72, error::stdout_has_color());
                error::print(&format!(
                    "{preview}\nThis is {}x{} pixels; save it with `-o picture.png`.\n",
                    picture.width(),
                    picture.height()
                ))
            }
        }
    }
}

/// Refuses an unknown ending before any work is done.
pub(super) fn check_extension(path: &Path) -> Result<(), CliError> {
    if path.as_os_str() == "-" || path.starts_with("/dev") {
        return Ok(());
    }
    if path.is_dir() {
        return Err(save::SaveError::IsFolder { path: path.to_path_buf() }.into());
    }
    encode_for(path, &Picture::filled(1, 1, [0; 3])).map(|_| ()).map_err(CliError::failed)
}

/// Writes a picture to `path`, or as PPM to standard output when it is `-`.
pub(super) fn save_picture(path: &Path, picture: &Picture) -> Result<(), CliError> {
    if path.as_os_str() == "-" {
        return write_standard_output(picture);
    }
    // Devices have no ending that names a format.
    let named = if path.starts_with("/dev") { Path::new("picture.ppm") } else { path };
    Ok(save::write_whole(path, &encode_for(named, picture).map_err(CliError::failed)?)?)
}

fn write_standard_output(picture: &Picture) -> Result<(), CliError> {
    use std::io::Write;
    let bytes = encode_for(Path::new("picture.ppm"), picture).map_err(CliError::failed)?;
    let mut out = std::io::stdout().lock();
    out.write_all(&bytes)
        .and_then(|()| out.flush())
        .map_err(|error| CliError::failed(format!("cannot write the picture to standard output: {error}")))
}
