//! Summary: what an import found, what came of it, and what was left out.
//!
//! import -SUMMARY-> a few lines of text
//!
//! Space: square metres; text counts hectares.

use std::collections::BTreeMap;
use std::fmt;

/// How many stands are told one by one.
const MOST_STANDS: usize = 20;

/// Counts of an import.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Summary {
    /// Polygons that became land, multi-geometries counted part by part.
    pub polygons: usize,
    /// Features of them with several parts.
    pub multipolygons: usize,
    /// Holes of them.
    pub holes: usize,
    /// Cells, and places in the rectangle where the relief has no height.
    pub cells: [usize; 2],
    /// Samples of heights that are void.
    pub voids: usize,
    /// Side of a cell in metres.
    pub side: f64,
    /// Stands by number.
    pub stands: BTreeMap<u32, StandLand>,
    /// Land of each ground in square metres.
    pub grounds: BTreeMap<String, f64>,
    /// Roads, rivers and paths of the files.
    pub lines: usize,
    /// Kinds of trees.
    pub species: Vec<String>,
    /// Years that the stands have states for.
    pub years: Vec<i32>,
    /// What was left out, and how often.
    pub dropped: BTreeMap<String, usize>,
}

/// A stand that came to be.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StandLand {
    /// What the inventory calls it.
    pub name: String,
    /// Its polygons.
    pub polygons: usize,
    /// Square metres in the cells, as if nothing lay over it.
    pub land: f64,
    /// Trees a hectare of its first state.
    pub density: f64,
}

impl fmt::Display for Summary {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let hectares = |land: f64| land / 1e4;
        let [cells, empty] = self.cells;
        writeln!(out, "{} polygons, {} multipolygons, {} holes", self.polygons, self.multipolygons, self.holes)?;
        let all = hectares(cells as f64 * self.side * self.side);
        writeln!(
            out,
            "{cells} cells of {} m, {all:.1} ha; {empty} places without heights; {} void samples",
            self.side, self.voids
        )?;
        let land: f64 = self.stands.values().map(|stand| stand.land).sum();
        let trees: f64 = self.stands.values().map(|stand| hectares(stand.land) * stand.density).sum();
        writeln!(
            out,
            "{} stands, {:.1} ha, about {trees:.0} trees; species: {}",
            self.stands.len(),
            hectares(land),
            listed(&self.species)
        )?;
        for (number, stand) in self.stands.iter().take(MOST_STANDS) {
            writeln!(
                out,
                "  stand {number}: {}, {} polygons, {:.2} ha",
                stand.name,
                stand.polygons,
                hectares(stand.land)
            )?;
        }
        if self.stands.len() > MOST_STANDS {
            writeln!(out, "  and {} more", self.stands.len() - MOST_STANDS)?;
        }
        for (ground, land) in &self.grounds {
            writeln!(out, "  ground {ground}: {:.2} ha", hectares(*land))?;
        }
        if self.lines > 0 {
            writeln!(out, "{} lines", self.lines)?;
        }
        if !self.years.is_empty() {
            let years: Vec<String> = self.years.iter().map(i32::to_string).collect();
            writeln!(out, "years: {}", years.join(", "))?;
        }
        for (why, count) in &self.dropped {
            writeln!(out, "left out: {count} {why}")?;
        }
        Ok(())
    }
}

fn listed(names: &[String]) -> String {
    if names.is_empty() { "none".to_string() } else { names.join(", ") }
}
