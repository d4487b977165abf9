//! `farop student new NAME`: a crate of one's own, made from the lab crate.
//!
//! Why the text of the real lab crate and not a template beside it: the lab crate is compiled and tested with every change,
//! a template would rot. Why into the workspace's own folder: its `Cargo.toml` takes in every `student_*` folder there, so
//! nothing has to be registered.
//!
//! What is written appears whole or not at all: it is made under another name and renamed at the end.

use std::fmt;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// The package that the text comes from; its name is replaced wherever it stands.
const ORIGINAL: &str = "student_rasterizers";

/// The files of a student crate, and the lab crate's text for them.
const FILES: [(&str, &str); 14] = [
    ("Cargo.toml", include_str!("../../student_rasterizers/Cargo.toml")),
    ("README.md", include_str!("../../student_rasterizers/README.md")),
    ("src/lib.rs", include_str!("../../student_rasterizers/src/lib.rs")),
    ("src/main.rs", include_str!("../../student_rasterizers/src/main.rs")),
    ("src/my_clip.rs", include_str!("../../student_rasterizers/src/my_clip.rs")),
    ("src/my_coverage.rs", include_str!("../../student_rasterizers/src/my_coverage.rs")),
    ("src/my_gouraud.rs", include_str!("../../student_rasterizers/src/my_gouraud.rs")),
    ("src/my_phong.rs", include_str!("../../student_rasterizers/src/my_phong.rs")),
    ("src/my_supersampling.rs", include_str!("../../student_rasterizers/src/my_supersampling.rs")),
    ("src/my_triangulate.rs", include_str!("../../student_rasterizers/src/my_triangulate.rs")),
    ("src/my_watkins.rs", include_str!("../../student_rasterizers/src/my_watkins.rs")),
    ("src/my_wire.rs", include_str!("../../student_rasterizers/src/my_wire.rs")),
    ("src/my_zbuffer.rs", include_str!("../../student_rasterizers/src/my_zbuffer.rs")),
    ("src/solved_example.rs", include_str!("../../student_rasterizers/src/solved_example.rs")),
];

/// A new crate. Printed, it says what to do next.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Created {
    /// Its folder.
    pub folder: PathBuf,
    /// Its package, `student_NAME`: what follows `-p`.
    pub package: String,
}

/// Why no crate was made. Nothing is left behind.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum StudentError {
    /// The name cannot be part of a package's name.
    #[error(
        "`{0}` cannot be used as a name: write lower-case letters, digits and _, a letter first, for example `ana`"
    )]
    Name(String),
    /// No workspace to put the crate into.
    #[error("{0} is not inside a farop workspace: change to the folder that farop was cloned into, and try again")]
    NoWorkspace(PathBuf),
    /// Something of that name is there.
    #[error("{0} is already there: choose another name, or remove it first")]
    Exists(PathBuf),
    /// The file system refused.
    #[error("could not write {path}: {source}")]
    Write {
        /// Which file or folder.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
}

/// Makes `student_NAME` in the workspace that `folder` lies in.
///
/// # Errors
/// [`StudentError`] when the name is unfit or taken, there is no workspace, or writing fails; then nothing is left behind.
pub fn create(folder: &Path, name: &str) -> Result<Created, StudentError> {
    if !is_fit(name) {
        return Err(StudentError::Name(name.to_string()));
    }
    let workspace = find_workspace(folder).ok_or_else(|| StudentError::NoWorkspace(folder.to_path_buf()))?;
    let package = format!("student_{name}");
    let created = Created { folder: workspace.join(&package), package };
    // A link that leads nowhere is something, too: ask for the entry itself.
    if created.folder.symlink_metadata().is_ok() {
        return Err(StudentError::Exists(created.folder));
    }

    // Write beside the final place, under a name that the workspace does not take in; a failure removes it.
    let failed = |path: &Path| {
        let path = path.to_path_buf();
        move |source| StudentError::Write { path, source }
    };
    let draft = tempfile::Builder::new().prefix(".new_student_").tempdir_in(&workspace).map_err(failed(&workspace))?;
    let crate_folder = draft.path().join(&created.package);
    for (file, original) in FILES {
        let path = crate_folder.join(file);
        fs::create_dir_all(path.parent().unwrap_or(&crate_folder)).map_err(failed(&created.folder))?;
        fs::write(&path, renamed(original, name)).map_err(failed(&created.folder.join(file)))?;
    }
    fs::rename(&crate_folder, &created.folder).map_err(failed(&created.folder))?;
    Ok(created)
}

/// Lower-case letters, digits and underscores, a letter first.
fn is_fit(name: &str) -> bool {
    let fits = |letter: char| letter.is_ascii_lowercase() || letter.is_ascii_digit() || letter == '_';
    name.starts_with(|first: char| first.is_ascii_lowercase()) && name.chars().all(fits)
}

/// The nearest folder at or above `folder` whose `Cargo.toml` takes in every `student_*` folder.
fn find_workspace(folder: &Path) -> Option<PathBuf> {
    let takes_in_students = |folder: &&Path| {
        let manifest = fs::read_to_string(folder.join("Cargo.toml")).unwrap_or_default();
        let mut lines = manifest.lines().skip_while(|line| line.trim() != "[workspace]").skip(1);
        lines.any(|line| line.trim_start().starts_with("members") && line.contains("\"student_*\""))
    };
    let absolute = std::path::absolute(folder).ok()?;
    absolute.ancestors().find(takes_in_students).map(Path::to_path_buf)
}

/// The lab crate's text under the new name. The program is renamed, too: two programs of one name in one workspace would
/// overwrite each other.
fn renamed(original: &str, name: &str) -> String {
    let program = format!("name = \"lab_{name}\"");
    original.replace(ORIGINAL, &format!("student_{name}")).replace("name = \"lab\"", &program)
}

impl fmt::Display for Created {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Created { folder, package } = self;
        writeln!(f, "{} is made. Draw a first picture, then see what the lab asks for:", folder.display())?;
        writeln!(f, "  cargo run -p {package} -- render spd:gears -r mine -o gears.png")?;
        write!(f, "  cargo test -p {package} -- --ignored")
    }
}
