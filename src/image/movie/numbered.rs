//! Numbered: a folder of PNG, `frame-00000.png` and on.
//!
//! Frame -NUMBERED-> a folder with a passing name -rename-> the folder
//!
//! Why not into a folder that has files: the frames of a longer film of yesterday would follow those of today.

use super::MovieError;
use crate::image::save::{SaveError, write_whole};
use crate::image::{Picture, encode_for};
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// Frames in the making.
#[derive(Debug)]
pub(super) struct Numbered {
    path: PathBuf,
    folder: TempDir,
}

impl Numbered {
    pub fn create(path: &Path) -> Result<Numbered, MovieError> {
        let failed = |error| SaveError::at(path, error);
        if let Ok(known) = fs::metadata(path) {
            let empty = known.is_dir() && fs::read_dir(path).map_err(failed)?.next().is_none();
            if !empty {
                return Err(MovieError::FolderInUse { path: path.to_path_buf() });
            }
        }
        let beside = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let mut builder = tempfile::Builder::new();
        builder.prefix(".farop-").suffix(".part");
        // Temporary folders are private by default; pictures are not. The user's mask still applies.
        #[cfg(unix)]
        builder.permissions(<fs::Permissions as std::os::unix::fs::PermissionsExt>::from_mode(0o777));
        let folder = builder.tempdir_in(beside).map_err(failed)?;
        Ok(Numbered { path: path.to_path_buf(), folder })
    }

    pub fn push(&mut self, frame: u64, picture: &Picture) -> Result<(), MovieError> {
        let path = self.folder.path().join(format!("frame-{frame:05}.png"));
        Ok(write_whole(&path, &encode_for(&path, picture)?)?)
    }

    pub fn finish(self) -> Result<(), MovieError> {
        let failed = |error| SaveError::at(&self.path, error);
        // An empty folder of that name gives way: not every system renames over it.
        if self.path.is_dir() {
            fs::remove_dir(&self.path).map_err(failed)?;
        }
        fs::rename(self.folder.path(), &self.path).map_err(failed)?;
        // It has moved: nothing is left to remove.
        let _ = self.folder.keep();
        Ok(())
    }
}
