//! What is in a forest: cells, heights, stands, species, covers, places.
//!
//! Trees are estimated: area of each stand's polygons times its density. How many stand in a picture, the picture counts.

use crate::cli::error::{self, CliError};
use crate::forest::area::{Cell, Ground, Head, Owner, Patch};
use crate::forest::cells::Cells;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::path::Path;

/// Sums over cells.
#[derive(Default)]
struct Survey {
    cells: usize,
    /// Lowest and highest sample.
    heights: Option<[f64; 2]>,
    samples: u64,
    voids: u64,
    triangles: u64,
    /// Samples each way, and how many cells have them.
    lattices: BTreeMap<[u16; 2], usize>,
    stands: BTreeSet<u32>,
    years: BTreeSet<i32>,
    measured: u64,
    lines: BTreeMap<String, f64>,
    /// By species: polygons, hectares, trees.
    species: BTreeMap<u16, [f64; 3]>,
    /// Hectares of patches of covers.
    covers: BTreeMap<u8, f64>,
    bytes: Vec<u32>,
    broken: Vec<String>,
}

/// Prints what is in `cells`.
pub(super) fn report(path: &Path, cells: &Cells, year: Option<i32>) -> Result<(), CliError> {
    let mut survey = Survey::default();
    for index in cells.indices() {
        match cells.load(index) {
            Ok(Some(cell)) => survey.add(&cell, year),
            Ok(None) => {}
            Err(broken) => survey.broken.push(broken.to_string()),
        }
        if let Cells::Packed(pack) = cells {
            survey.bytes.push(pack.bytes_of(index));
        }
    }
    error::print(&survey.text(path, cells, year))?;
    if survey.broken.is_empty() {
        return Ok(());
    }
    let more = survey.broken.len() - 1;
    let rest = if more > 0 { format!("\n{more} more cells are broken") } else { String::new() };
    Err(CliError::failed(format!("{}{rest}", survey.broken[0])))
}

impl Survey {
    fn add(&mut self, cell: &Cell, year: Option<i32>) {
        self.cells += 1;
        self.ground(&cell.ground);
        self.measured += cell.trees.len() as u64;
        for stand in &cell.stands {
            self.stands.insert(stand.number);
            self.years.extend(stand.states.iter().filter_map(|state| state.year));
        }
        for patch in &cell.patches {
            let hectares = area(patch) / 10_000.0;
            match patch.owner {
                Owner::Cover(cover) => *self.covers.entry(cover).or_default() += hectares,
                Owner::Stand(stand) => {
                    let state = cell.stands.get(stand as usize).and_then(|stand| stand.in_year(year));
                    let Some(state) = state else { continue };
                    let sums = self.species.entry(state.species).or_default();
                    let added = [1.0, hectares, hectares * state.density];
                    sums.iter_mut().zip(added).for_each(|(sum, added)| *sum += added);
                }
            }
        }
        for line in &cell.lines {
            let pairs = line.points.windows(2);
            let metres: f64 = pairs.map(|pair| (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1])).sum();
            *self.lines.entry(line.kind.clone()).or_default() += metres;
        }
    }

    fn ground(&mut self, ground: &Ground) {
        match ground {
            Ground::Mesh { vertices, triangles } => {
                self.triangles += triangles.len() as u64;
                vertices.iter().for_each(|vertex| self.height(vertex.z));
            }
            Ground::Lattice { size, base, step, counts } => {
                *self.lattices.entry(*size).or_default() += 1;
                self.samples += counts.len() as u64;
                for &count in counts {
                    match count {
                        Ground::VOID => self.voids += 1,
                        _ => self.height(base + step * f64::from(count)),
                    }
                }
            }
        }
    }

    fn height(&mut self, height: f64) {
        let [low, high] = self.heights.unwrap_or([height; 2]);
        self.heights = Some([low.min(height), high.max(height)]);
    }

    fn text(&self, path: &Path, cells: &Cells, year: Option<i32>) -> String {
        let head = cells.head();
        let hectares = self.cells as f64 * head.side * head.side / 10_000.0;
        let mut text =
            format!("{}: {} of {} m, {hectares:.1} ha", path.display(), count(self.cells, "cell"), head.side);
        if let Some([[west, south], [east, north]]) = cells.bounds() {
            text += &format!(", columns {west} to {east}, rows {south} to {north}");
        }
        text.push('\n');
        let mut row = |name: &str, value: String| {
            if !value.is_empty() {
                // Writing to a String cannot fail.
                let _ = writeln!(text, "  {name:8} {value}");
            }
        };
        let [east, north] = head.origin;
        let crs = if head.crs.is_empty() { "not said".to_string() } else { head.crs.clone() };
        row("map", format!("{crs}, cell 0 0 at {east} {north}"));
        row("heights", self.heights_text());
        row("stands", self.stands_text(year));
        for (&species, sums) in &self.species {
            row("", species_text(head, species, sums));
        }
        for (&cover, hectares) in &self.covers {
            let name = head.covers.get(usize::from(cover)).map_or("?", |cover| &cover.image);
            row("cover", format!("{hectares:10.1} ha of {name}"));
        }
        for (kind, metres) in &self.lines {
            row("line", format!("{:10.1} km of {kind}", metres / 1000.0));
        }
        row("trees", if self.measured > 0 { format!("{} measured", self.measured) } else { String::new() });
        row("bytes", self.bytes_text());
        for mark in &head.marks {
            row("mark", format!("\"{}\" at {:.0} {:.0}", mark.name, mark.at[0], mark.at[1]));
        }
        text
    }

    fn heights_text(&self) -> String {
        let Some([low, high]) = self.heights else { return "none: every sample is a void".to_string() };
        let mut text = format!("{low:.1} to {high:.1} m");
        for ([columns, rows], cells) in &self.lattices {
            text += &format!(", {columns} x {rows} samples in {}", count(*cells, "cell"));
        }
        if self.voids > 0 {
            text += &format!(", {} of {} samples are voids", self.voids, self.samples);
        }
        if self.triangles > 0 {
            text += &format!(", {} triangles", self.triangles);
        }
        text
    }

    fn stands_text(&self, year: Option<i32>) -> String {
        let years: Vec<String> = self.years.iter().map(i32::to_string).collect();
        let trees: f64 = self.species.values().map(|sums| sums[2]).sum();
        let shown = year.map_or(String::new(), |year| format!(" in {year}"));
        let known = if years.is_empty() { String::new() } else { format!("; years {}", years.join(", ")) };
        format!("{} with about {trees:.0} trees{shown}{known}", self.stands.len())
    }

    fn bytes_text(&self) -> String {
        let mut bytes = self.bytes.clone();
        bytes.sort_unstable();
        let (Some(least), Some(most)) = (bytes.first(), bytes.last()) else { return String::new() };
        format!("{} a cell in the middle, {least} to {most}", bytes[bytes.len() / 2])
    }
}

/// `1 cell`, `2 cells`.
fn count(number: usize, noun: &str) -> String {
    format!("{number} {noun}{}", if number == 1 { "" } else { "s" })
}

fn species_text(head: &Head, species: u16, [polygons, hectares, trees]: &[f64; 3]) -> String {
    let code = head.species.get(usize::from(species)).map_or("?", |species| &species.code);
    format!("{code:8} {hectares:10.1} ha in {}, about {trees:.0} trees", count(*polygons as usize, "polygon"))
}

/// Square metres of a patch, holes taken out. Where patches overlap, both count.
fn area(patch: &Patch) -> f64 {
    let ring = |corners: &[[f64; 2]]| {
        let edges = crate::math::edges(corners);
        edges.map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum::<f64>().abs() / 2.0
    };
    ring(&patch.outer) - patch.holes.iter().map(|hole| ring(hole)).sum::<f64>()
}
