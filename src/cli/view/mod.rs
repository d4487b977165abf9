//! `farop view`: the window; or, with `--shot`, the picture that the window would show.
//!
//! options -> Viewer -window, or written keys-> board -> display, file

mod shell;
#[cfg(feature = "window")]
mod window;

use super::error::CliError;
use super::options::PictureOptions;
use super::render::{check_extension, save_picture};
use super::scenes::{Chosen, SceneOptions, find_rasterizer};
use crate::plan::Shading;
use crate::raster::{Rasterizer, Registry};
use crate::view::made::Named;
use crate::view::{Viewer, read_keys};
use clap::Args;
use shell::Shell;
use std::path::PathBuf;

/// A window: every stage, any pixel, a walk through the scene (the key h tells the keys)
#[derive(Args)]
#[command(
    after_help = "Examples:\n  farop view spd:gears\n  farop view scene.nff --keys \"2<right*3>\" --shot eye.png"
)]
pub(super) struct ViewCommand {
    #[command(flatten)]
    scenes: SceneOptions,
    /// Rasterizer to begin with; the key r goes through all
    #[arg(short, long, value_name = "NAME", default_value = "fast")]
    rasterizer: String,
    /// No window: write what it would show, .png or .ppm, and end
    #[arg(long, value_name = "FILE")]
    shot: Option<PathBuf>,
    /// Keys pressed at the start, as in "s2<right*5><at:40,30>i"
    #[arg(long, value_name = "KEYS", default_value = "", hide_default_value = true)]
    keys: String,
    /// Where the keys w and l write and read the path
    #[arg(long, value_name = "FILE", default_value = "farop-path.txt")]
    path: PathBuf,
    /// Folder for the frames of key m, frame-00000.png and on
    #[arg(long, value_name = "DIR", default_value = "frames")]
    frames: PathBuf,
    /// Pixels a dot of a letter [default: 1, and 2 where there are more than 1400 rows]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=8))]
    text_size: Option<u32>,
    #[command(flatten)]
    picture: PictureOptions,
}

impl ViewCommand {
    pub fn run(self, registry: &Registry) -> Result<(), CliError> {
        if let Some(path) = &self.shot {
            check_extension(path)?;
        }
        let events = read_keys(&self.keys).map_err(|error| CliError::failed(format!("--keys: {error}")))?;
        let scene = self.scenes.load(&self.picture)?.scene;
        let choices = self.picture.choices();
        let chosen = find_rasterizer(registry, &self.rasterizer)?;
        let rasterizers = self.rasterizers(registry, chosen.as_ref())?;
        let mut viewer = Viewer::new(scene, &choices, rasterizers)?;
        viewer.text_size = self.text_size;
        if self.rasterizer == "wire" {
            viewer.state.choices.shading = Shading::Wire;
        }
        let mut shell = Shell::new(viewer, &self);
        let goes_on = shell.feed(events);
        match &self.shot {
            Some(path) => {
                shell.viewer.draw();
                shell.viewer.trouble().map_or(Ok(()), |trouble| Err(CliError::failed(trouble)))?;
                save_picture(path, &shell.viewer.board().picture())
            }
            None if goes_on => self.open(&mut shell),
            None => Ok(()),
        }
    }

    #[cfg(feature = "window")]
    fn open(&self, shell: &mut Shell<'_>) -> Result<(), CliError> {
        window::open(shell, &format!("farop: {}", self.scenes.scenes.join(" ")))
            .map_err(|why| self.without_window(&why))
    }

    #[cfg(not(feature = "window"))]
    fn open(&self, _shell: &mut Shell<'_>) -> Result<(), CliError> {
        Err(self.without_window("this farop was built without the feature `window`"))
    }

    /// What to do where there is no window.
    fn without_window(&self, why: &str) -> CliError {
        let keys = if self.keys.is_empty() { String::new() } else { format!(" --keys \"{}\"", self.keys) };
        let scenes = self.scenes.scenes.join(" ");
        CliError::failed(format!(
            "cannot open a window: {why}\n\
             help: a window needs a display (DISPLAY); without one,\n      \
             `farop view {scenes}{keys} --shot picture.png` makes the picture it would show"
        ))
    }

    /// The one that was asked for, then all others; lines have a shading of their own.
    fn rasterizers<'a>(
        &self,
        registry: &'a Registry,
        chosen: Option<&'a Chosen<'a>>,
    ) -> Result<Vec<Named<'a>>, CliError> {
        let Some(chosen) = chosen else {
            return Err(CliError::failed("`-r none` draws nothing to look at; leave it out, or name a rasterizer"));
        };
        let first = (chosen.name().to_string(), chosen.rasterizer());
        let others = registry.iter().filter(|entry| entry.name != chosen.name());
        let others = others.map(|entry| (entry.name.clone(), &*entry.rasterizer as &dyn Rasterizer));
        Ok(std::iter::once(first).chain(others).filter(|named| named.0 != "wire").collect())
    }
}
