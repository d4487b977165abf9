//! Store: the folder of results, and the cells in which submissions are worked on.
//!
//! verdict -STORE-> `submissions/KEY/verdict.json`, whole or not at all
//!
//! Cells lie in the system's folder for temporary files, because the way to the results may be closed to whoever runs a submission. Where they
//! lie is written down before the first is made: a grader that was killed cannot tidy up, so the next one does.

use super::Sandbox;
use super::sandbox::open_folder;
use crate::image::save;
use serde_json::Value;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// Where the place of the cells is written down.
const CELLS: &str = ".cells";
const PREFIX: &str = "farop-class-";

/// A folder of results.
pub struct Store {
    folder: PathBuf,
}

/// The folder of all cells; it goes away with this value.
pub(super) struct Cells<'a> {
    folder: Option<TempDir>,
    store: &'a Store,
}

impl Store {
    /// The results in `folder`; with `goes_on`, what is there stays.
    ///
    /// # Errors
    /// In words, when results are there and it is not to go on, or the folder cannot be made.
    pub fn open(folder: &Path, goes_on: bool) -> Result<Store, String> {
        let store = Store { folder: folder.to_path_buf() };
        if !goes_on && store.folder.join("submissions").exists() {
            return Err(format!(
                "{} has results already\nhelp: --resume goes on with them; --results names another folder; or remove it",
                folder.display()
            ));
        }
        let made = std::fs::create_dir_all(store.folder.join("submissions"));
        made.map_err(|error| format!("cannot make {}: {error}", folder.display()))?;
        Ok(store)
    }

    /// The results in `folder`, which must be there.
    ///
    /// # Errors
    /// In words, when there are none.
    pub fn existing(folder: &Path) -> Result<Store, String> {
        if folder.join("submissions").is_dir() {
            return Ok(Store { folder: folder.to_path_buf() });
        }
        Err(format!(
            "{} has no results\nhelp: grade the class first, without --rescore, or name its results with --results",
            folder.display()
        ))
    }

    /// Where the verdict on `key` is.
    #[must_use]
    pub fn verdict(&self, key: &str) -> PathBuf {
        self.folder.join("submissions").join(key).join("verdict.json")
    }

    /// Whether there is a whole verdict on what `fingerprint` says.
    pub(super) fn has(&self, key: &str, fingerprint: &str) -> bool {
        let saved = self.read(key);
        saved.is_some_and(|saved| saved["submission"]["fingerprint"] == fingerprint && saved["whole"] == true)
    }

    fn read(&self, key: &str) -> Option<Value> {
        serde_json::from_slice(&std::fs::read(self.verdict(key)).ok()?).ok()
    }

    /// Saves a verdict.
    ///
    /// # Errors
    /// In words, when it cannot be written.
    pub fn keep(&self, key: &str, verdict: &Value) -> Result<(), String> {
        let path = self.verdict(key);
        std::fs::create_dir_all(path.parent().unwrap_or(&self.folder)).map_err(|error| error.to_string())?;
        self.write(&path, &format!("{verdict:#}\n"))
    }

    /// Saves the report on a submission beside its verdict.
    ///
    /// # Errors
    /// In words, when it cannot be written.
    pub fn keep_page(&self, key: &str, page: &str) -> Result<(), String> {
        let path = self.verdict(key).with_file_name("report.html");
        std::fs::create_dir_all(path.parent().unwrap_or(&self.folder)).map_err(|error| error.to_string())?;
        self.write(&path, page)
    }

    /// Writes the page about the class, with links to the reports that are there.
    ///
    /// # Errors
    /// In words, when it cannot be written.
    pub fn keep_index(&self) -> Result<(), String> {
        crate::grade::html::write_class_index(&self.folder)
    }

    /// Saves a file about the class.
    ///
    /// # Errors
    /// In words, when it cannot be written.
    pub fn keep_class(&self, name: &str, text: &str) -> Result<(), String> {
        self.write(&self.folder.join(name), text)
    }

    fn write(&self, path: &Path, text: &str) -> Result<(), String> {
        save::write_whole(path, text.as_bytes()).map_err(|error| error.to_string())
    }

    /// The saved verdicts on `keys`, in that order; on all that is there, sorted, without.
    #[must_use]
    pub fn verdicts(&self, keys: Option<&[&str]>) -> Vec<Value> {
        if let Some(keys) = keys {
            return keys.iter().filter_map(|key| self.read(key)).collect();
        }
        let entries = std::fs::read_dir(self.folder.join("submissions")).into_iter().flatten().flatten();
        let mut keys: Vec<_> = entries.map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
        keys.sort();
        keys.iter().filter_map(|key| self.read(key)).collect()
    }

    /// A place for cells, after the one of a grader that was killed is gone.
    pub(super) fn cells(&self) -> Result<Cells<'_>, String> {
        let note = self.folder.join(CELLS);
        if let Ok(old) = std::fs::read_to_string(&note) {
            let old = Path::new(&old);
            let is_ours = old.file_name().is_some_and(|name| name.to_string_lossy().starts_with(PREFIX));
            if is_ours && old.parent() == Some(&std::env::temp_dir()) {
                let _ = std::fs::remove_dir_all(old);
            }
        }
        self.tidy();
        let folder = tempfile::Builder::new().prefix(PREFIX).tempdir().map_err(|error| error.to_string())?;
        self.write(&note, &folder.path().display().to_string())?;
        open_folder(folder.path())?;
        Ok(Cells { folder: Some(folder), store: self })
    }

    /// Removes files that a killed grader did not finish.
    fn tidy(&self) {
        let folders = std::fs::read_dir(self.folder.join("submissions")).into_iter().flatten().flatten();
        let folders = folders.map(|entry| entry.path()).chain([self.folder.clone()]);
        let files = folders.flat_map(|folder| std::fs::read_dir(folder).into_iter().flatten().flatten());
        for file in files {
            let name = file.file_name().to_string_lossy().into_owned();
            if name.starts_with(".farop-") && name.ends_with(".part") {
                let _ = std::fs::remove_file(file.path());
            }
        }
    }
}

impl Cells<'_> {
    /// A new cell, in which the sandbox's user may make files.
    pub(super) fn open(&self, sandbox: &Sandbox) -> Result<TempDir, String> {
        let folder = self.folder.as_ref().ok_or("the cells are gone")?;
        let cell = tempfile::Builder::new().prefix("cell-").tempdir_in(folder).map_err(|error| error.to_string())?;
        open_folder(cell.path())?;
        #[cfg(unix)]
        if let Some(user) = sandbox.user() {
            let given = std::os::unix::fs::chown(cell.path(), Some(user), Some(user));
            given.map_err(|error| format!("a cell cannot be given to user {user}: {error}"))?;
        }
        let _ = sandbox;
        Ok(cell)
    }
}

impl Drop for Cells<'_> {
    fn drop(&mut self) {
        // First the cells, then the note of them.
        drop(self.folder.take());
        let _ = std::fs::remove_file(self.store.folder.join(CELLS));
    }
}
