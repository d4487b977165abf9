//! What the viewer cannot do itself: files. Saves pictures, frames and paths; reads a scene again when its file changes.

use super::super::error::CliError;
use super::super::options::PictureOptions;
use super::super::scenes::SceneOptions;
use super::ViewCommand;
use crate::image::{encode_for, save};
use crate::scene::Scene;
use crate::view::path::{read_path, write_path};
use crate::view::{Action, Event, Viewer};
use std::path::{Path, PathBuf};
use std::time::SystemTime;

/// A viewer and the files around it.
pub(super) struct Shell<'a> {
    pub viewer: Viewer<'a>,
    scenes: SceneOptions,
    picture: PictureOptions,
    path: PathBuf,
    frames: PathBuf,
    /// Every file that was read, and how it looked.
    seen: Vec<(PathBuf, Option<Stamp>)>,
}

/// What changes when a file does.
type Stamp = (SystemTime, u64);

impl<'a> Shell<'a> {
    pub fn new(viewer: Viewer<'a>, command: &ViewCommand) -> Shell<'a> {
        let files = command.scenes.scenes.iter().filter(|name| *name != "-" && !name.starts_with("spd:"));
        let seen = files.map(|name| (PathBuf::from(name), stamp(Path::new(name)))).collect();
        Shell {
            viewer,
            scenes: command.scenes.clone(),
            picture: command.picture.clone(),
            path: command.path.clone(),
            frames: command.frames.clone(),
            seen,
        }
    }

    /// Hands events to the viewer and does what it asks for; `false`: it is over.
    pub fn feed(&mut self, events: impl IntoIterator<Item = Event>) -> bool {
        for event in events {
            match self.viewer.handle(&event) {
                Some(Action::Quit) => return false,
                Some(action) => self.perform(action),
                None => {}
            }
        }
        true
    }

    fn perform(&mut self, action: Action) {
        let said = match action {
            Action::Quit => Ok(String::new()),
            Action::SavePicture => self.save_picture(&free_name()),
            Action::SaveFrame(number) => self.save_frame(number),
            Action::SavePath => self.save_path(),
            Action::LoadPath => self.load_path(),
        };
        let said = said.unwrap_or_else(|error| format!("error: {error}"));
        if !said.is_empty() {
            self.viewer.say(said);
        }
    }

    fn save_picture(&mut self, path: &Path) -> Result<String, String> {
        let picture = self.viewer.draw().picture();
        let bytes = encode_for(path, &picture).map_err(|error| error.to_string())?;
        save::write_whole(path, &bytes).map_err(|error| error.to_string())?;
        Ok(format!("saved {}", path.display()))
    }

    /// A frame that cannot be written ends the saving: one message instead of one a frame.
    fn save_frame(&mut self, number: u64) -> Result<String, String> {
        let saved = std::fs::create_dir_all(&self.frames)
            .map_err(|error| format!("cannot make the folder {}: {error}", self.frames.display()))
            .and_then(|()| self.save_picture(&self.frames.join(format!("frame-{number:05}.png"))));
        if saved.is_err() {
            self.viewer.state.movie = None;
        }
        saved.map(|_| String::new())
    }

    fn save_path(&mut self) -> Result<String, String> {
        let poses = &self.viewer.state.path;
        if poses.is_empty() {
            return Err("there is no path: record one with p".to_string());
        }
        save::write_whole(&self.path, write_path(poses).as_bytes()).map_err(|error| error.to_string())?;
        Ok(format!("wrote {} frames to {}", poses.len(), self.path.display()))
    }

    fn load_path(&mut self) -> Result<String, String> {
        let text = std::fs::read_to_string(&self.path);
        let text = text.map_err(|error| format!("cannot read {}: {error}", self.path.display()))?;
        let poses = read_path(&text).map_err(|error| format!("{}: {error}", self.path.display()))?;
        let said = format!("{} frames from {}", poses.len(), self.path.display());
        self.viewer.state.path = poses;
        self.viewer.state.playing = None;
        Ok(said)
    }

    /// Reads the scene again if a file of it changed; `true` if one did.
    #[cfg_attr(not(feature = "window"), allow(dead_code, reason = "only a window lasts long enough"))]
    pub fn look_for_changes(&mut self) -> bool {
        let mut changed = false;
        for (path, seen) in &mut self.seen {
            let now = stamp(path);
            changed |= now != *seen;
            *seen = now;
        }
        if changed {
            let scene = self.read();
            self.viewer.reload(scene);
        }
        changed
    }

    fn read(&self) -> Result<Scene, String> {
        // Messages may be colored for a terminal; letters of the window have one color.
        let plain = |error: CliError| anstream::adapter::strip_str(&error.message()).to_string();
        self.scenes.load(&self.picture).map(|loaded| loaded.scene).map_err(plain)
    }
}

fn stamp(path: &Path) -> Option<Stamp> {
    let known = std::fs::metadata(path).ok()?;
    Some((known.modified().ok()?, known.len()))
}

/// The first of farop-001.png, farop-002.png, ... that is not there.
fn free_name() -> PathBuf {
    let names = (1..10_000).map(|number| PathBuf::from(format!("farop-{number:03}.png")));
    names.into_iter().find(|name| !name.exists()).unwrap_or_else(|| PathBuf::from("farop-last.png"))
}
