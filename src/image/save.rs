//! Save: a file appears under its final name only whole.
//!
//! bytes -> temporary file beside the target -> rename -> target
//!
//! Why: a program that is stopped half way, or a disk that fills up, must not leave half a picture under a good name;
//! a script would take it for the result. Renaming inside one folder is one step for the file system.
//!
//! What is no regular file (`/dev/full`, `/dev/stdout`, a named pipe) cannot be renamed over and is written directly.
//! A power cut is not covered: nothing here waits for the disk.

use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;

/// Why a file could not be written. The message says what, where, and what to do.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SaveError {
    /// The folder is not there.
    #[error("cannot write `{}`: there is no folder `{}`; make it first, or choose another place", path.display(), folder.display())]
    NoFolder {
        /// The file as the caller named it.
        path: PathBuf,
        /// Where it should go.
        folder: PathBuf,
    },
    /// The name belongs to a folder.
    #[error("cannot write `{}`: it is a folder; name a file in it", path.display())]
    IsFolder {
        /// The file as the caller named it.
        path: PathBuf,
    },
    /// No permission.
    #[error("cannot write `{}`: no permission to write in `{}`; change it, or choose another place", path.display(), folder.display())]
    NoPermission {
        /// The file as the caller named it.
        path: PathBuf,
        /// Where it should go.
        folder: PathBuf,
    },
    /// There is a file of that name that says it must not be changed.
    #[error("cannot write `{}`: the file is write-protected; remove it, or choose another name", path.display())]
    Protected {
        /// The file as the caller named it.
        path: PathBuf,
    },
    /// The disk, or the user's share of it, is full.
    #[error("cannot write `{}`: the disk is full; free some space, or choose another place", path.display())]
    DiskFull {
        /// The file as the caller named it.
        path: PathBuf,
    },
    /// Anything else the system said.
    #[error("cannot write `{}`: {source}", path.display())]
    Other {
        /// The file as the caller named it.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
}

impl SaveError {
    /// The error in words of the user's world: which file, which folder, what to do.
    #[must_use]
    pub fn at(path: &Path, source: io::Error) -> Self {
        let folder = folder_of(path).to_path_buf();
        let path = path.to_path_buf();
        match source.kind() {
            ErrorKind::NotFound | ErrorKind::NotADirectory => SaveError::NoFolder { path, folder },
            ErrorKind::IsADirectory => SaveError::IsFolder { path },
            ErrorKind::PermissionDenied | ErrorKind::ReadOnlyFilesystem => SaveError::NoPermission { path, folder },
            ErrorKind::StorageFull | ErrorKind::QuotaExceeded => SaveError::DiskFull { path },
            _ => SaveError::Other { path, source },
        }
    }
}

/// Writes `bytes` to `path`; an earlier file of that name is replaced, or on failure left as it was.
///
/// # Errors
/// [`SaveError`]; nothing is left behind, neither under the final name nor beside it.
pub fn write_whole(path: &Path, bytes: &[u8]) -> Result<(), SaveError> {
    write_streamed(path, |out| out.write_all(bytes))
}

/// As [`write_whole`], for output too long to hold in memory: `write` is given the file, buffered.
///
/// # Errors
/// [`SaveError`]; also when `write` itself fails. Nothing is left behind.
pub fn write_streamed(path: &Path, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), SaveError> {
    let mut file = WholeFile::create(path)?;
    write(&mut file).map_err(|error| SaveError::at(path, error))?;
    file.commit()
}

/// A file in the making. It gets its final name by [`WholeFile::commit`]; dropped before, it vanishes.
#[derive(Debug)]
pub struct WholeFile {
    /// The name the caller gave, for messages.
    path: PathBuf,
    out: Out,
}

#[derive(Debug)]
enum Out {
    /// Renamed to the second, which has no symbolic link in it, when committed.
    Temporary(BufWriter<NamedTempFile>, PathBuf),
    /// A device or a pipe: what is written is gone.
    Direct(BufWriter<File>),
}

impl WholeFile {
    /// Begins a file that will be called `path`.
    ///
    /// # Errors
    /// [`SaveError`] when the folder is missing or closed, or `path` is a folder or write-protected.
    pub fn create(path: &Path) -> Result<Self, SaveError> {
        let failed = |error| SaveError::at(path, error);
        let existing = fs::metadata(path).ok();
        if existing.as_ref().is_some_and(fs::Metadata::is_dir) || names_a_folder(path) {
            return Err(SaveError::IsFolder { path: path.to_path_buf() });
        }

        // Write devices and pipes directly.
        if existing.as_ref().is_some_and(|there| !there.is_file() || is_open_file(path)) {
            // Appending: standard output may be a file that others have already written to.
            let file = OpenOptions::new().append(true).open(path).map_err(failed)?;
            return Ok(WholeFile { path: path.to_path_buf(), out: Out::Direct(BufWriter::new(file)) });
        }

        // Make the temporary file beside the target, because renaming does not cross file systems.
        let mut target = path.to_path_buf();
        if let Some(there) = &existing {
            if there.permissions().readonly() {
                return Err(SaveError::Protected { path: target });
            }
            // A symbolic link stays one: the file it leads to is replaced.
            target = fs::canonicalize(path).map_err(failed)?;
        }
        let temporary = temporary_beside(&target).map_err(failed)?;
        if let Some(there) = existing {
            fs::set_permissions(temporary.path(), there.permissions()).map_err(failed)?;
        }
        Ok(WholeFile { path: path.to_path_buf(), out: Out::Temporary(BufWriter::new(temporary), target) })
    }

    /// The name it was asked for.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Gives the file its final name.
    ///
    /// # Errors
    /// [`SaveError`] when the last bytes cannot be written or the name cannot be given; then nothing is left behind.
    pub fn commit(self) -> Result<(), SaveError> {
        let WholeFile { path, out } = self;
        let failed = |error| SaveError::at(&path, error);
        match out {
            Out::Direct(mut file) => file.flush().map_err(failed),
            Out::Temporary(buffer, target) => {
                let temporary = buffer.into_inner().map_err(|error| failed(error.into_error()))?;
                temporary.persist(target).map_err(|error| failed(error.error))?;
                Ok(())
            }
        }
    }
}

impl Write for WholeFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut self.out {
            Out::Temporary(file, _) => file.write(bytes),
            Out::Direct(file) => file.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match &mut self.out {
            Out::Temporary(file, _) => file.flush(),
            Out::Direct(file) => file.flush(),
        }
    }
}

fn temporary_beside(target: &Path) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".farop-").suffix(".part");
    // Temporary files are private by default; a picture is not. The user's mask still applies.
    #[cfg(unix)]
    builder.permissions(<fs::Permissions as std::os::unix::fs::PermissionsExt>::from_mode(0o666));
    builder.tempfile_in(folder_of(target))
}

/// The folder a file goes to; `.` for a bare name.
fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

/// `name/`, `..` and the empty name cannot be files, whatever is there.
fn names_a_folder(path: &Path) -> bool {
    let ends_in_separator = path.to_string_lossy().ends_with(std::path::is_separator);
    ends_in_separator || path.file_name().is_none()
}

/// `/dev/stdout` and its relatives lead to whatever the program was started with, perhaps a regular file that
/// others hold open: it must not be replaced by another one. (`/dev/shm` is a folder like any other.)
fn is_open_file(path: &Path) -> bool {
    ["/dev/stdout", "/dev/stderr", "/dev/fd", "/proc"].iter().any(|place| path.starts_with(place))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names_in(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).expect("folder is there");
        let mut names: Vec<_> =
            entries.map(|entry| entry.expect("entry").file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }

    #[test]
    fn a_file_is_written_and_replaced() {
        let folder = tempfile::tempdir().expect("temporary folder");
        let path = folder.path().join("a.ppm");
        write_whole(&path, b"one").expect("new");
        write_whole(&path, b"two").expect("replaced");
        assert_eq!(fs::read(&path).expect("read"), b"two");
        assert_eq!(names_in(folder.path()), ["a.ppm"]);
    }

    #[test]
    fn nothing_appears_before_the_commit_and_nothing_stays_without_it() {
        let folder = tempfile::tempdir().expect("temporary folder");
        let path = folder.path().join("a.scr");
        let mut file = WholeFile::create(&path).expect("created");
        file.write_all(&[7; 100_000]).expect("written");
        assert!(!path.exists());
        drop(file);
        assert_eq!(names_in(folder.path()), [""; 0]);
    }

    #[test]
    fn a_failing_writer_leaves_the_old_file() {
        let folder = tempfile::tempdir().expect("temporary folder");
        let path = folder.path().join("a.scr");
        write_whole(&path, b"old").expect("new");
        let full = || io::Error::from(ErrorKind::StorageFull);
        let error = write_streamed(&path, |out| out.write_all(b"ne").and(Err(full()))).expect_err("full");
        assert!(error.to_string().contains("a.scr`: the disk is full; free some space"), "{error}");
        assert_eq!(fs::read(&path).expect("read"), b"old");
        assert_eq!(names_in(folder.path()), ["a.scr"]);
    }

    #[test]
    fn wrong_places_are_explained() {
        let folder = tempfile::tempdir().expect("temporary folder");
        let inside = |name: &str| folder.path().join(name);
        fs::write(inside("file"), "").expect("write");
        for (path, expected) in [
            (inside("missing/a.png"), "missing`; make it first"),
            (inside("file/a.png"), "there is no folder"),
            (folder.path().to_path_buf(), "it is a folder; name a file in it"),
            (inside("new/"), "it is a folder"),
            (PathBuf::new(), "it is a folder"),
        ] {
            let error = write_whole(&path, b"x").expect_err(expected).to_string();
            assert!(error.contains(expected) && error.contains(&*path.to_string_lossy()), "{error}");
        }
        assert_eq!(names_in(folder.path()), ["file"]);
        let closed = SaveError::at(Path::new("a.png"), ErrorKind::PermissionDenied.into()).to_string();
        assert_eq!(closed, "cannot write `a.png`: no permission to write in `.`; change it, or choose another place");
    }

    #[test]
    fn a_protected_file_stays() {
        let folder = tempfile::tempdir().expect("temporary folder");
        let path = folder.path().join("a.png");
        fs::write(&path, "keep").expect("write");
        let mut permissions = fs::metadata(&path).expect("is there").permissions();
        permissions.set_readonly(true);
        fs::set_permissions(&path, permissions).expect("own file");
        assert!(matches!(write_whole(&path, b"x"), Err(SaveError::Protected { .. })));
        assert_eq!(fs::read(&path).expect("read"), b"keep");
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn devices_are_written_directly() {
        write_whole(Path::new("/dev/null"), b"x").expect("takes everything");
        assert!(matches!(write_whole(Path::new("/dev/full"), b"x"), Err(SaveError::DiskFull { .. })));
        assert!(!Path::new("/dev/full").is_file(), "still a device");
        assert!(is_open_file(Path::new("/dev/fd/1")) && !is_open_file(Path::new("/dev/shm/a.png")));
    }

    #[cfg(unix)]
    #[test]
    fn permissions_are_the_usual_ones_and_links_stay_links() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().expect("temporary folder");
        let inside = |name: &str| folder.path().join(name);
        let mode = |name: &str| fs::metadata(inside(name)).expect("is there").permissions().mode() & 0o777;
        File::create(inside("usual")).expect("created");
        write_whole(&inside("ours"), b"x").expect("written");
        assert_eq!(mode("ours"), mode("usual"));

        fs::set_permissions(inside("ours"), fs::Permissions::from_mode(0o640)).expect("own file");
        std::os::unix::fs::symlink("ours", inside("link")).expect("linked");
        write_whole(&inside("link"), b"new").expect("written");
        assert_eq!(fs::read(inside("ours")).expect("read"), b"new");
        assert_eq!(mode("ours"), 0o640);
        assert!(fs::symlink_metadata(inside("link")).expect("is there").is_symlink());
    }

    #[cfg(unix)]
    #[test]
    fn a_named_pipe_is_written_directly() {
        let folder = tempfile::tempdir().expect("temporary folder");
        let pipe = folder.path().join("pipe");
        let made = std::process::Command::new("mkfifo").arg(&pipe).status();
        if !made.is_ok_and(|status| status.success()) {
            println!("notice: no mkfifo here, named pipes not tested");
            return;
        }
        let reader = std::thread::spawn({
            let pipe = pipe.clone();
            move || fs::read(pipe)
        });
        write_whole(&pipe, b"through").expect("written");
        assert!(!pipe.is_file(), "still a pipe");
        assert_eq!(reader.join().expect("reader lives").expect("read"), b"through");
        assert_eq!(names_in(folder.path()), ["pipe"]);
    }
}
