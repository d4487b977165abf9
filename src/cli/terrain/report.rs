//! What `farop terrain` says: the grid, the relief and its error over all samples, as text or JSON.

use super::covers::BorderFigures;
use super::relief::Made;
use crate::cli::error::CliError;
use crate::forest::elevation::{Filled, Grid, Merged, Unit, utm, zone_of};
use crate::forest::relief::strip;
use std::fmt::Write;

/// The figures as lines of text.
pub(super) fn text(merged: &Merged, filled: &Filled, made: &Made, with_times: bool) -> String {
    let grid = &merged.grid;
    let [width, height] = grid.extent();
    let [dx, dy] = grid.spacing();
    let mut text =
        format!("grid       {}: {} x {} samples, {}\n", grid.name, grid.columns(), grid.rows(), extent(grid));
    let kilometres = |metres: f64| metres / 1000.0;
    let _ = writeln!(
        text,
        "metres     {dx:.2} x {dy:.2} from sample to sample, {:.2} x {:.2} km",
        kilometres(width),
        kilometres(height)
    );
    if let Some(line) = corner(grid) {
        text += &line;
    }
    if merged.shared > 0 || merged.resampled > 0 {
        let Merged { shared, differing, largest, resampled, .. } = merged;
        let _ = writeln!(
            text,
            "seams      {shared} samples shared, {differing} of them differ, by at most {largest} m; {resampled} tiles resampled"
        );
    }
    let (low, high) = grid.range().unwrap_or_default();
    let Filled { samples, voids, left } = filled;
    let _ =
        writeln!(text, "heights    {low} to {high} m; {samples} samples of {voids} voids filled, {left} left as holes");
    text += &relief(made);
    if with_times {
        let [errors, mesh] = made.times.map(|time| time.user + time.system);
        let _ = writeln!(text, "times      {errors:.1} ms errors, {mesh:.1} ms mesh (processor)");
    }
    text
}

/// The lines about the mesh.
fn relief(made: &Made) -> String {
    let found = &made.quality;
    let mut text = format!("relief     {}\n", made.wanted);
    let _ = writeln!(
        text,
        "mesh       {} triangles ({:.4} % of the grid's), {} vertices",
        found.triangles, found.percent, found.vertices
    );
    if let Some((selected, fictitious, junctions)) = made.fictitious {
        let _ = writeln!(
            text,
            "states     {selected} vertices selected, {fictitious} fictitious; {junctions} edges with a vertex within"
        );
    }
    if found.rmse.is_nan() {
        text += "error      not measured: name the grid it was made of with --against\n";
    } else {
        let _ = writeln!(
            text,
            "error      largest {:.2} m, RMSE {:.2} m, SSD {:.4e} m2, over {} samples",
            found.largest, found.rmse, found.ssd, found.samples
        );
    }
    if found.uncovered > 0 {
        let _ = writeln!(text, "holes      {} samples beside voids lie under no triangle", found.uncovered);
    }
    if let Some((_, figures)) = &made.covered {
        text += &borders(figures);
    }
    let strip = strip::strip(&made.mesh).len();
    let _ =
        writeln!(text, "strip      {strip} vertices, {:.2} a triangle", strip as f64 / found.triangles.max(1) as f64);
    for (step, (changes, triangles)) in made.walk.iter().enumerate() {
        let _ = writeln!(
            text,
            "step {step:<5} {} halved, {} joined, {triangles} triangles",
            changes.halved, changes.joined
        );
    }
    text
}

/// The lines about covers.
fn borders(figures: &BorderFigures) -> String {
    let BorderFigures { tolerance, promise, wrong, samples, farthest, parts } = *figures;
    let mut text = format!(
        "borders    {tolerance:.2} m asked: no wrong cover farther than {promise:.2} m from a border; {wrong} of {samples} samples wrong, the farthest {farthest:.2} m\n"
    );
    if parts > 1 {
        let _ = writeln!(text, "finer      every square of the grid is {parts} x {parts}, on the same surface");
    }
    text
}

fn extent(grid: &Grid) -> String {
    let [west, south, east, north] = grid.borders();
    match grid.frame.unit {
        Unit::Degrees => format!("{south:.6} to {north:.6} N, {west:.6} to {east:.6} E"),
        Unit::Metres => format!("{west} to {east} m east, {south} to {north} m north"),
    }
}

/// Where the south-west corner is on a map.
fn corner(grid: &Grid) -> Option<String> {
    let [west, south, ..] = grid.borders();
    if grid.frame.unit == Unit::Metres || !(-80.0..=84.0).contains(&south) {
        return None;
    }
    let place = utm(west, south, zone_of(west));
    let half = if place.south { "south" } else { "north" };
    Some(format!("corner     UTM zone {} {half}, {:.1} E {:.1} N\n", place.zone, place.east, place.north))
}

#[derive(serde::Serialize)]
struct Figures<'a> {
    grid: &'a str,
    columns: usize,
    rows: usize,
    /// West, south, east, north.
    borders: [f64; 4],
    /// Metres from sample to sample.
    spacing: [f64; 2],
    heights: (f32, f32),
    filled: usize,
    holes: usize,
    shared: usize,
    differing: usize,
    relief: &'a str,
    #[serde(flatten)]
    quality: crate::forest::relief::Quality,
    strip: usize,
    fictitious: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    covers: Option<BorderFigures>,
    walk: Vec<crate::forest::relief::frontier::Changes>,
}

/// The figures as JSON; without times, so that the same input gives the same bytes.
pub(super) fn json(merged: &Merged, filled: &Filled, made: &Made) -> Result<String, CliError> {
    let grid = &merged.grid;
    let figures = Figures {
        grid: &grid.name,
        columns: grid.columns(),
        rows: grid.rows(),
        borders: grid.borders(),
        spacing: grid.spacing(),
        heights: grid.range().unwrap_or_default(),
        filled: filled.samples,
        holes: filled.left,
        shared: merged.shared,
        differing: merged.differing,
        relief: &made.wanted,
        quality: made.quality,
        strip: strip::strip(&made.mesh).len(),
        fictitious: made.fictitious.map(|(_, fictitious, _)| fictitious),
        covers: made.covered.as_ref().map(|covered| covered.1),
        walk: made.walk.iter().map(|step| step.0).collect(),
    };
    let text = serde_json::to_string_pretty(&figures).map_err(CliError::failed)?;
    Ok(text + "\n")
}
