//! `farop grade LAB --submission PATH`: one submission as a platform has it, a file or a folder, in a language that needs no workspace.
//!
//! files -SUBMISSION-> a door: `exec:...`, `lib:...`, compiled first where it is C or C++

use super::error::CliError;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::Command;
use tempfile::TempDir;

/// What students' C programs include.
const HEADER: &str = include_str!("../../student_rasterizers/other_languages/c/farop.h");

/// A submission that can be graded.
pub(super) struct Submission {
    /// Its name in reports: that of its file.
    pub name: String,
    /// The door to it, as `-r` takes it.
    pub door: String,
    /// What was compiled lies here as long as this lives.
    _cell: Option<TempDir>,
}

/// Finds what is to be graded in `path`.
pub(super) fn find(path: &Path) -> Result<Submission, CliError> {
    let file = candidate(path)?;
    let name = file.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let whole =
        file.canonicalize().map_err(|error| CliError::failed(format!("cannot read {}: {error}", file.display())))?;
    let (door, cell) = match ending(&file) {
        "py" => (format!("exec:python3 {}", quoted(&whole)?), None),
        "c" | "cpp" | "cc" => {
            let (door, cell) = compiled(&whole)?;
            (door, Some(cell))
        }
        _ => (format!("exec:{}", quoted(&whole)?), None),
    };
    Ok(Submission { name, door, _cell: cell })
}

fn ending(path: &Path) -> &str {
    path.extension().and_then(OsStr::to_str).unwrap_or_default()
}

/// As a word of `exec:`; a name may be anything.
fn quoted(path: &Path) -> Result<String, CliError> {
    let text = path.display().to_string();
    match (text.contains('"'), text.contains('\'')) {
        (false, _) => Ok(format!("\"{text}\"")),
        (true, false) => Ok(format!("'{text}'")),
        (true, true) => {
            Err(CliError::failed(format!("{text}: a name with both kinds of quotes cannot be run; rename it")))
        }
    }
}

/// The file in a submission that is the program: C before C++ before Python before a program; one of its kind.
fn candidate(path: &Path) -> Result<PathBuf, CliError> {
    let unreadable = |error: std::io::Error| CliError::failed(format!("cannot read {}: {error}", path.display()));
    if std::fs::metadata(path).map_err(unreadable)?.is_file() {
        return Ok(path.to_path_buf());
    }
    let entries = std::fs::read_dir(path).map_err(unreadable)?.flatten();
    // A link may lead to what is none of the student's business.
    let plain = entries.filter(|entry| entry.file_type().is_ok_and(|kind| kind.is_file())).map(|entry| entry.path());
    let mut files: Vec<PathBuf> = plain.collect();
    files.sort();
    let kinds: [&dyn Fn(&Path) -> bool; 4] = [
        &|file| ending(file) == "c",
        &|file| matches!(ending(file), "cpp" | "cc"),
        &|file| ending(file) == "py",
        &is_program,
    ];
    for kind in kinds {
        match &files.iter().filter(|file| kind(file)).collect::<Vec<_>>()[..] {
            [] => {}
            [file] => return Ok((*file).clone()),
            several => {
                let names: Vec<_> =
                    several.iter().map(|file| file.file_name().unwrap_or_default().to_string_lossy()).collect();
                return Err(CliError::failed(format!(
                    "which of these is the submission? {}; hand in one",
                    names.join(", ")
                )));
            }
        }
    }
    Err(CliError::failed(
        "there is nothing to run in the submission: a .c, a .cpp, a .py or an executable file is expected\n\
         help: docs/doors.md says what such a program reads and writes",
    ))
}

#[cfg(unix)]
fn is_program(path: &Path) -> bool {
    use std::os::unix::fs::PermissionsExt;
    std::fs::metadata(path).is_ok_and(|about| about.permissions().mode() & 0o111 != 0)
}

#[cfg(not(unix))]
fn is_program(path: &Path) -> bool {
    ending(path) == "exe"
}

/// A library where the file has `farop_draw`, else a program.
fn compiled(source: &Path) -> Result<(String, TempDir), CliError> {
    let failed = |error: std::io::Error| CliError::failed(format!("cannot compile {}: {error}", source.display()));
    let cell = tempfile::tempdir().map_err(failed)?;
    std::fs::write(cell.path().join("farop.h"), HEADER).map_err(failed)?;
    let text = std::fs::read(source).map_err(failed)?;
    let is_library = text.windows(b"farop_draw".len()).any(|words| words == b"farop_draw");
    let product = cell.path().join(if is_library { "submission.so" } else { "submission" });
    let mut command = Command::new(if ending(source) == "c" { "gcc" } else { "g++" });
    command.args(["-O2", "-I"]).arg(cell.path()).arg("-o").arg(&product).arg(source);
    if is_library {
        command.args(["-shared", "-fPIC"]);
    }
    let output = command.arg("-lm").output().map_err(failed)?;
    if !output.status.success() {
        return Err(CliError::failed(format!("it does not compile:\n{}", String::from_utf8_lossy(&output.stderr))));
    }
    let door = if is_library { format!("lib:{}", product.display()) } else { format!("exec:{}", quoted(&product)?) };
    Ok((door, cell))
}
