//! Streams of halvings: written from grids, read back whole or cut.

use super::command::TerrainCommand;
use super::relief::Made;
use crate::cli::error::CliError;
use crate::forest::elevation::{Filled, Grid, Merged};
use crate::forest::relief::progressive::{read, stepped, write};
use crate::forest::relief::{Hierarchy, Quality, ReliefMesh, quality};
use crate::image::save::{SaveError, WholeFile};
use crate::report::StageTime;
use crate::scene::Camera;
use std::path::{Path, PathBuf};

/// Whether a name is that of a stream.
pub(super) fn is_stream(path: &Path) -> bool {
    path.extension().is_some_and(|end| end.eq_ignore_ascii_case("frel"))
}

/// Writes `grid` to `path` and tells how long the stream is.
pub(super) fn send(path: &Path, grid: &Grid) -> Result<String, CliError> {
    if !is_stream(path) {
        return Err(CliError::failed(format!(
            "`{}`: a progressive relief is written to a file that ends in .frel",
            path.display()
        )));
    }
    let (stepped, step) = stepped(grid);
    let mut file = WholeFile::create(path)?;
    let halvings = write(&Hierarchy::new(&stepped), step, &mut file);
    let halvings = halvings.map_err(|error| CliError::from(SaveError::at(path, error)))?;
    file.commit()?;
    let bytes = std::fs::metadata(path).map_or(0, |file| file.len());
    let each = bytes as f64 / halvings.max(1) as f64;
    let rounded = if step < 1.0 { format!(", heights rounded to {step} m") } else { String::new() };
    Ok(format!("stream     {halvings} halvings, {bytes} bytes, {each:.2} a halving{rounded}\n"))
}

/// Reads a stream; what it says of itself, measured against `known` where that is given.
pub(super) fn receive(
    path: &Path,
    known: Option<&Grid>,
    camera: impl FnOnce(&Grid) -> Camera,
) -> Result<(Merged, Filled, Made), CliError> {
    let fault = |error: &dyn std::fmt::Display| CliError::failed(format!("`{}`: {error}", path.display()));
    let bytes = std::fs::read(path).map_err(|error| fault(&error))?;
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let received = read(&name, &bytes).map_err(|error| fault(&error))?;
    let size = |grid: &Grid| (grid.columns(), grid.rows());
    if let Some(known) = known.filter(|known| size(known) != size(&received.grid)) {
        let ((columns, rows), (w, h)) = (size(&received.grid), size(known));
        return Err(CliError::failed(format!(
            "`{}` has {columns} x {rows} samples, `{}` {w} x {h}: it was not made of this grid",
            path.display(),
            known.name
        )));
    }
    let state = if received.is_whole { "whole" } else { "cut" };
    let wanted = format!(
        "{} halvings of {} bytes, {state}: no sample farther than {:.2} m",
        received.halvings,
        bytes.len(),
        received.bound
    );
    let measured = known.map(|known| quality(known, &received.mesh));
    let quality = measured.unwrap_or_else(|| counted(&received.grid, &received.mesh, received.bound));
    let made = Made {
        mesh: received.mesh,
        quality,
        wanted,
        fictitious: None,
        covered: None,
        walk: Vec::new(),
        camera: camera(&received.grid),
        times: [StageTime::default(); 2],
    };
    let merged = Merged { grid: received.grid, shared: 0, differing: 0, largest: 0.0, resampled: 0 };
    Ok((merged, Filled { samples: 0, voids: 0, left: 0 }, made))
}

/// The counts of a mesh whose errors nobody can measure here: the bound stands for the largest, the others are not known.
fn counted(grid: &Grid, mesh: &ReliefMesh, bound: f64) -> Quality {
    Quality { largest: bound, rmse: f64::NAN, ssd: f64::NAN, ..quality(grid, mesh) }
}

impl TerrainCommand {
    /// The stream among the inputs, if that is what is asked about.
    pub(super) fn stream(&self) -> Result<Option<&PathBuf>, CliError> {
        let stream = self.files().iter().find(|path| is_stream(path));
        match stream {
            Some(path) if self.files().len() > 1 => Err(CliError::failed(format!(
                "`{}` is a relief already and merges with no grid: name it alone, and a grid to measure against with --against",
                path.display()
            ))),
            None if self.against().is_some() => {
                Err(CliError::failed("--against measures a .frel; grids are measured against themselves".to_string()))
            }
            _ => Ok(stream),
        }
    }
}
