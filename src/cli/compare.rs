//! `farop compare`: are two pictures the same?

use super::error::{self, CliError};
use crate::image::metrics::{self, Tolerance};
use crate::image::{encode_for, read, save};
use clap::Args;
use std::path::PathBuf;

/// Two pictures, pixel by pixel; exit code 1 when they differ
#[derive(Args)]
#[command(
    after_help = "Examples:\n  farop compare expected.png actual.png\n  farop compare a.png b.ppm --max-diff 1 --max-pixels 20 --diff diff.png"
)]
pub(super) struct CompareCommand {
    /// Picture that is right
    expected: PathBuf,
    /// Picture to judge
    actual: PathBuf,
    /// Levels of 255 by which a channel may differ
    #[arg(long, value_name = "L", default_value_t = 0)]
    max_diff: u8,
    /// Pixels that may differ by more
    #[arg(long, value_name = "N", default_value_t = 0)]
    max_pixels: usize,
    /// Write expected | difference | actual side by side
    #[arg(long, value_name = "OUT.png")]
    diff: Option<PathBuf>,
}

impl CompareCommand {
    pub fn run(self) -> Result<(), CliError> {
        let expected = read(&self.expected).map_err(CliError::failed)?;
        let actual = read(&self.actual).map_err(CliError::failed)?;
        let tolerance = Tolerance { max_diff: self.max_diff, max_pixels: self.max_pixels };
        let comparison = metrics::compare(&expected, &actual, tolerance);
        if let Some(path) = &self.diff {
            let difference = metrics::difference_picture(&expected, &actual);
            let picture = metrics::side_by_side(&[&expected, &difference, &actual]);
            save::write_whole(path, &encode_for(path, &picture).map_err(CliError::failed)?)?;
        }
        if comparison.passes() {
            error::print(&format!("{comparison}\n"))
        } else {
            Err(CliError::Wanting(comparison.to_string()))
        }
    }
}
