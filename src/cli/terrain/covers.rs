//! Covers on the relief: read from an area of forest, kept to a tolerance, told.

use super::command::{ModeName, TerrainCommand};
use super::progressive::is_stream;
use crate::cli::error::{self, CliError};
use crate::cli::options::not_negative;
use crate::color::Rgb;
use crate::forest::cover::{Samples, at_samples};
use crate::forest::elevation::Grid;
use crate::forest::pictures::Pictures;
use crate::forest::relief::ReliefMesh;
use crate::forest::relief::borders::Borders;
use crate::forest::relief::finer::finer;
use clap::Args;
use serde::Serialize;
use std::path::{Path, PathBuf};

/// The most samples of a grid that is made finer for its covers: 2^24, half a gigabyte with their bounds.
const MOST_SAMPLES: f64 = 16_777_216.0;

/// What lies on the relief.
#[derive(Args, Clone)]
#[command(next_help_heading = "Covers")]
pub(super) struct CoverOptions {
    /// An area (.fcell, .fpack) whose stands and covers lie on the relief, metres from its south-west corner; a triangle wears one
    #[arg(long, value_name = "FILE", conflicts_with_all = ["triangles", "progressive", "against"])]
    covers: Option<PathBuf>,
    /// No wrong cover farther than M metres from a border [default: from sample to sample]
    #[arg(long, value_name = "M", value_parser = not_negative, requires = "covers", allow_hyphen_values = true)]
    cover_tolerance: Option<f64>,
    /// Stands as in this year
    #[arg(long, value_name = "Y", requires = "covers", allow_hyphen_values = true)]
    year: Option<i32>,
}

/// The covers of a relief, and how exactly they are kept.
pub(super) struct Covered {
    pub borders: Borders,
    /// Metres.
    pub tolerance: f64,
    /// How many squares one of the grid has become, along a side.
    pub parts: u32,
    /// Of each number of a cover; empty where nothing is drawn.
    pub colors: Vec<Rgb>,
}

/// How far the relief is from the borders.
#[derive(Clone, Copy, Debug, Serialize)]
pub(super) struct BorderFigures {
    pub tolerance: f64,
    /// Metres within which every wrong place is from a border.
    pub promise: f64,
    /// Samples under a triangle that wears another cover.
    pub wrong: usize,
    pub samples: usize,
    /// Metres of the farthest of them from a sample of another cover.
    pub farthest: f64,
    /// Squares along a side of what was one.
    pub parts: u32,
}

impl Covered {
    /// The covers that are asked for; `grid` becomes as fine as their tolerance wants.
    pub fn new(command: &TerrainCommand, grid: &mut Grid) -> Result<Option<Covered>, CliError> {
        let options = &command.covers;
        let Some(path) = &options.covers else { return Ok(None) };
        command.check_covers()?;
        let spacing = grid.spacing();
        let side = spacing[0].max(spacing[1]);
        let tolerance = options.cover_tolerance.unwrap_or(side);
        let parts = parts(grid, side, tolerance)?;
        *grid = finer(grid, parts);
        let (cells, notices) = crate::parse::load_cells(path)
            .map_err(|errors| CliError::Diagnosed(errors.render(error::stderr_has_color())))?;
        if !notices.is_empty() {
            error::diagnose(&notices.render(error::stderr_has_color()));
        }
        let size = [grid.columns(), grid.rows()];
        let samples = Samples { corner: [0.0; 2], spacing: grid.spacing(), size };
        let numbers = at_samples(&cells, options.year, &samples).map_err(CliError::failed)?;
        if numbers.iter().all(|number| *number == 0) {
            let [width, height] = grid.extent();
            return Err(CliError::failed(format!(
                "`{}` covers no sample of the relief, which reaches {width:.0} m east and {height:.0} m north of its south-west corner; its cells count metres from there",
                path.display()
            )));
        }
        let folder = path.parent().unwrap_or(Path::new(""));
        // Pictures take a while to paint, figures have no colors.
        let colors = if command.output.is_some() {
            let pictures = Pictures::new(cells.head(), folder).map_err(CliError::failed)?;
            pictures.grounds.iter().map(|ground| ground.color).collect()
        } else {
            Vec::new()
        };
        let borders = Borders::new(grid, |x, y| numbers[y * size[0] + x]);
        Ok(Some(Covered { borders, tolerance, parts, colors }))
    }

    /// What a mesh makes of them.
    pub fn figures(&self, grid: &Grid, mesh: &ReliefMesh) -> BorderFigures {
        let triangles = || mesh.faces.iter().map(|face| &face.triangle);
        let (wrong, farthest) = self.borders.wrong(triangles());
        let (promise, samples) = (self.borders.promise(triangles()), grid.columns() * grid.rows());
        // Distances are rounded up, and are not those of borders but of samples behind them.
        let farthest = farthest.min(promise);
        BorderFigures { tolerance: self.tolerance, promise, wrong, samples, farthest, parts: self.parts }
    }
}

/// How many squares one of the grid must become, along a side, for the smallest triangle to keep a tolerance.
fn parts(grid: &Grid, side: f64, tolerance: f64) -> Result<u32, CliError> {
    let squares = (grid.columns() - 1) as f64 * (grid.rows() - 1) as f64;
    let can_be = |parts: f64| squares * parts * parts <= MOST_SAMPLES;
    let mut parts = 1.0;
    while side / parts > tolerance && can_be(parts) {
        parts *= 2.0;
    }
    if parts == 1.0 || can_be(parts) {
        // Once more if that is possible: bounds are closer to the truth then, and fewer triangles do.
        let is_close = side / parts <= tolerance / 2.0 || !can_be(2.0 * parts);
        return Ok(if is_close { parts } else { 2.0 * parts } as u32);
    }
    let least = side / (parts / 2.0);
    Err(CliError::failed(format!(
        "--cover-tolerance {tolerance}: squares of {side:.1} m would have to become more than {MOST_SAMPLES:.0} small ones; write {:.2} or more, or take a part of the grid",
        (least * 100.0).ceil() / 100.0
    )))
}

impl TerrainCommand {
    /// What covers do not go together with.
    fn check_covers(&self) -> Result<(), CliError> {
        let wrong = if self.covers.cover_tolerance == Some(0.0) {
            "--cover-tolerance 0: no triangle is that small; write metres above 0"
        } else if self.wanted.mode == ModeName::Fictitious {
            "--covers wants a mesh without T-junctions: leave out --mode fictitious"
        } else if self.files().iter().any(|path| is_stream(path)) {
            "--covers chooses the triangles, which a .frel has chosen already: name the grid"
        } else {
            return Ok(());
        };
        Err(CliError::failed(wrong))
    }
}
