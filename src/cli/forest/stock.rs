//! Files of forests: opened, packed, unpacked, made.

use crate::cli::error::{self, CliError};
use crate::cli::options::not_negative;
use crate::forest::cells::Cells;
use crate::forest::invent::invent;
use crate::forest::pack;
use crate::image::save::{SaveError, WholeFile};
use crate::parse;
use crate::write::write_fcell;
use clap::Args;
use std::path::{Path, PathBuf};

/// A text of an area as a pack, for walking through
#[derive(Args)]
#[command(after_help = "Example:\n  farop forest pack area.fcell -o area.fpack")]
pub(in crate::cli) struct Pack {
    /// The area, .fcell
    #[arg(value_name = "FILE.fcell")]
    file: PathBuf,
    /// Pack to write
    #[arg(short, long, value_name = "FILE.fpack")]
    output: PathBuf,
}

/// A pack as text
#[derive(Args)]
#[command(after_help = "Example:\n  farop forest unpack area.fpack -o area.fcell")]
pub(in crate::cli) struct Unpack {
    /// The pack
    #[arg(value_name = "FILE.fpack")]
    file: PathBuf,
    /// Text to write, `-` for standard output
    #[arg(short, long, value_name = "FILE.fcell")]
    output: PathBuf,
}

/// An invented landscape as a pack
#[derive(Args)]
#[command(after_help = "Example:\n  farop forest new --hectares 95000 --seed 7 -o area.fpack")]
pub(in crate::cli) struct New {
    /// How large
    #[arg(long, value_name = "N", default_value_t = 1000.0, value_parser = not_negative, allow_hyphen_values = true)]
    hectares: f64,
    /// Another number, another landscape
    #[arg(long, value_name = "S", default_value_t = 1)]
    seed: u64,
    /// Pack to write
    #[arg(short, long, value_name = "FILE.fpack")]
    output: PathBuf,
}

/// The area in a file: text or pack, told by its name.
pub(super) fn open(path: &Path) -> Result<Cells, CliError> {
    let loaded = parse::load_cells(path);
    let (cells, notices) = loaded.map_err(|errors| CliError::Diagnosed(errors.render(error::stderr_has_color())))?;
    if !notices.is_empty() {
        error::diagnose(&notices.render(error::stderr_has_color()));
    }
    Ok(cells)
}

/// Whether a name is that of a pack.
pub(super) fn is_pack(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("fpack"))
}

/// Refuses a name that nobody would open again, before any work.
pub(super) fn check_ending(path: &Path, ending: &str) -> Result<(), CliError> {
    let fits = path.extension().is_some_and(|own| own.eq_ignore_ascii_case(ending));
    if fits || path.as_os_str() == "-" || path.starts_with("/dev") {
        return Ok(());
    }
    Err(CliError::failed(format!(
        "cannot write `{}`: name it `.{ending}`, or farop would not know it again",
        path.display()
    )))
}

impl Pack {
    pub fn run(&self) -> Result<(), CliError> {
        check_ending(&self.output, "fpack")?;
        let Cells::Loaded(area) = open(&self.file)? else {
            return Err(CliError::failed(format!("`{}` is a pack already", self.file.display())));
        };
        let counts = pack::write(&area.head, area.cells.into_values(), &self.output).map_err(CliError::failed)?;
        told(&self.output, &counts)
    }
}

/// What a pack came to be.
pub(super) fn told(path: &Path, counts: &pack::PackCounts) -> Result<(), CliError> {
    let mean = counts.bytes / (counts.cells as u64).max(1);
    error::print(&format!(
        "{}: {} cells, {} bytes: {mean} a cell, {} the largest\n",
        path.display(),
        counts.cells,
        counts.bytes,
        counts.largest
    ))
}

impl Unpack {
    pub fn run(&self) -> Result<(), CliError> {
        check_ending(&self.output, "fcell")?;
        if !is_pack(&self.file) {
            return Err(CliError::failed(format!(
                "`{}` is no pack: its name does not end in .fpack",
                self.file.display()
            )));
        }
        let cells = open(&self.file)?;
        if self.output.as_os_str() == "-" {
            return write_fcell(&cells, &mut std::io::stdout().lock()).map_err(|error| written(&self.output, error));
        }
        let mut file = WholeFile::create(&self.output)?;
        write_fcell(&cells, &mut file).map_err(|error| written(&self.output, error))?;
        Ok(file.commit()?)
    }
}

/// A broken cell speaks for itself; everything else is about the file that is written.
pub(super) fn written(path: &Path, error: std::io::Error) -> CliError {
    if error.kind() == std::io::ErrorKind::InvalidData {
        return CliError::failed(error);
    }
    SaveError::at(path, error).into()
}

impl New {
    pub fn run(&self) -> Result<(), CliError> {
        check_ending(&self.output, "fpack")?;
        let invented = invent(self.hectares, self.seed).map_err(CliError::failed)?;
        let counts = pack::write(invented.head(), invented.cells(), &self.output).map_err(CliError::failed)?;
        told(&self.output, &counts)
    }
}
