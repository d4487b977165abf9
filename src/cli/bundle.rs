//! `farop grade LAB --bundle PLATFORM PATH`: what a platform wants uploaded, as a zip or as a folder.

use super::error::{self, CliError};
use crate::grade::bundle::{Order, Packed, gradescope, zip};
use crate::image::save::{SaveError, write_whole};
use std::path::Path;

/// Writes the bundle to `path`: a zip when its name says so, else a folder.
pub(super) fn write(platform: &str, path: &Path, order: &Order<'_>) -> Result<(), CliError> {
    if platform != "gradescope" {
        return Err(CliError::failed(format!("there is no bundle for `{platform}`; there is gradescope")));
    }
    let program = std::env::current_exe().and_then(std::fs::read);
    let program = program.map_err(|error| CliError::failed(format!("cannot read this program itself: {error}")))?;
    let files = gradescope(order, program);
    if path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("zip")) {
        let bytes = zip(&files).map_err(|error| SaveError::at(path, error))?;
        write_whole(path, &bytes)?;
    } else {
        write_folder(path, &files)?;
    }
    let size = files.iter().map(|file| file.bytes.len()).sum::<usize>() / 1_000_000;
    error::print(&format!("{} files, {size} MB unpacked, in {}\n", files.len(), path.display()))
}

fn write_folder(path: &Path, files: &[Packed]) -> Result<(), CliError> {
    let made = if path.is_dir() { Ok(()) } else { std::fs::create_dir(path) };
    made.map_err(|error| SaveError::at(path, error))?;
    for file in files {
        let place = path.join(&file.name);
        write_whole(&place, &file.bytes)?;
        #[cfg(unix)]
        if file.is_program {
            use std::os::unix::fs::PermissionsExt;
            let mode = std::fs::Permissions::from_mode(0o755);
            std::fs::set_permissions(&place, mode).map_err(|error| SaveError::at(&place, error))?;
        }
    }
    Ok(())
}
