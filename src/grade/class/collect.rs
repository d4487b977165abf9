//! Collect: a copy of what somebody handed in, plain files only.
//!
//! submission's folder -COLLECT-> cell
//!
//! Links are not followed: the grader reads with its own rights, and a link would let a student have it read anything. What a device or a
//! pipe is for cannot be handed in. Files keep their names; the copy belongs to the grader, so a compiler cannot change it.

use sha2::{Digest, Sha256};
use std::path::{Path, PathBuf};

/// More than any lab needs: files, bytes of all together, folders in folders.
const MOST_FILES: usize = 200;
const MOST_BYTES: u64 = 16 << 20;
const MOST_DEPTH: usize = 6;
/// Folders of tools.
const SKIPPED: [&str; 4] = ["target", "__MACOSX", "node_modules", "__pycache__"];

/// The plain files in `path`, or `path` itself: where each lies, and its name inside; sorted, and no more than is allowed.
fn plain_files(path: &Path) -> Vec<(PathBuf, PathBuf)> {
    let is_file = path.symlink_metadata().is_ok_and(|about| about.is_file());
    let (mut folders, mut found) = (Vec::new(), Vec::new());
    match path.file_name() {
        Some(name) if is_file => found.push((path.to_path_buf(), PathBuf::from(name))),
        _ => folders.push((path.to_path_buf(), PathBuf::new(), 0)),
    }
    while let Some((folder, inside, depth)) = folders.pop() {
        let mut entries: Vec<_> = std::fs::read_dir(&folder).into_iter().flatten().flatten().collect();
        entries.sort_by_key(std::fs::DirEntry::file_name);
        for entry in entries {
            let (name, Ok(kind)) = (entry.file_name(), entry.file_type()) else { continue };
            let is_hidden = name.as_encoded_bytes().starts_with(b".") || SKIPPED.iter().any(|skipped| name == *skipped);
            if kind.is_dir() && !is_hidden && depth < MOST_DEPTH {
                folders.push((entry.path(), inside.join(&name), depth + 1));
            } else if kind.is_file() && !is_hidden && found.len() < MOST_FILES {
                found.push((entry.path(), inside.join(&name)));
            }
        }
    }
    found.sort_by(|a, b| a.1.cmp(&b.1));
    let mut bytes = 0;
    found.retain(|(path, _)| {
        bytes += path.symlink_metadata().map_or(0, |about| about.len());
        bytes <= MOST_BYTES
    });
    found
}

/// Copies the plain files of a submission into `cell`; their names inside it, sorted. What cannot be read is left out.
pub(super) fn copy(path: &Path, cell: &Path) -> Vec<String> {
    let copied = |(from, inside): (PathBuf, PathBuf)| {
        let to = cell.join(&inside);
        std::fs::create_dir_all(to.parent()?).ok()?;
        std::fs::copy(&from, &to).ok()?;
        open_to_readers(&from, &to, cell)?;
        Some(inside.to_string_lossy().into_owned())
    };
    plain_files(path).into_iter().filter_map(copied).collect()
}

/// Readable by whoever runs it, executable where it was, and not writable; the folders on the way can be passed.
#[cfg(unix)]
fn open_to_readers(from: &Path, to: &Path, cell: &Path) -> Option<()> {
    use std::os::unix::fs::PermissionsExt;
    let give = |path: &Path, mode| std::fs::set_permissions(path, std::fs::Permissions::from_mode(mode)).ok();
    let mode = std::fs::metadata(from).ok()?.permissions().mode();
    for folder in to.ancestors().skip(1).take_while(|folder| *folder != cell) {
        give(folder, 0o755)?;
    }
    give(to, if mode & 0o111 != 0 { 0o555 } else { 0o444 })
}

#[cfg(not(unix))]
fn open_to_readers(_: &Path, _: &Path, _: &Path) -> Option<()> {
    Some(())
}

/// Writes a file of ours into `cell`, readable by whoever works there.
pub(super) fn put(cell: &Path, name: &str, text: &str) -> std::io::Result<()> {
    let path = cell.join(name);
    std::fs::write(&path, text)?;
    let _ = open_to_readers(&path, &path, cell);
    Ok(())
}

/// Changes when the submission, or what is asked of it, does.
pub(super) fn fingerprint(path: &Path, (lab, seed): (&str, u64)) -> String {
    let mut hash = Sha256::new();
    hash.update(format!("{} {lab} {seed}\n", env!("CARGO_PKG_VERSION")));
    for (path, inside) in plain_files(path) {
        let bytes = std::fs::read(path).unwrap_or_default();
        hash.update(format!("{} {}\n", inside.display(), bytes.len()));
        hash.update(bytes);
    }
    hash.finalize().iter().take(16).map(|byte| format!("{byte:02x}")).collect()
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    #[test]
    fn links_and_tools_stay_outside() {
        let (folder, cell) = (tempfile::tempdir().expect("one"), tempfile::tempdir().expect("two"));
        let inside = |name: &str| folder.path().join(name);
        ["src", ".git", "target"].iter().for_each(|name| std::fs::create_dir(inside(name)).expect("made"));
        for name in ["src/my_zbuffer.rs", ".git/config", "target/x.rs", "new\nline.c"] {
            std::fs::write(inside(name), name).expect("written");
        }
        std::os::unix::fs::symlink("/etc/passwd", inside("secret.rs")).expect("linked");
        std::os::unix::fs::symlink("/etc", inside("etc")).expect("linked");
        assert_eq!(copy(folder.path(), cell.path()), ["new\nline.c", "src/my_zbuffer.rs"]);
        assert!(!cell.path().join("secret.rs").exists());
        let before = fingerprint(folder.path(), ("zbuffer", 1));
        assert_eq!(before, fingerprint(folder.path(), ("zbuffer", 1)));
        assert_ne!(before, fingerprint(folder.path(), ("zbuffer", 2)));
        std::fs::write(inside("src/my_zbuffer.rs"), "other").expect("written");
        assert_ne!(before, fingerprint(folder.path(), ("zbuffer", 1)));
    }
}
