//! What is in files of others: vectors of a map, lists of trees. `farop forest roads.geojson.gz`, `farop forest stand.svs`.

use crate::cli::error::{self, CliError};
use crate::diagnostic::Diagnostics;
use crate::forest::vector::Geometry;
use crate::parse::{Vectors, load_trees, load_vectors};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

/// Prints what is in `path` if it is a file of others; says whether it is one.
pub(super) fn report(path: &Path) -> Result<bool, CliError> {
    let name = path.to_string_lossy().to_lowercase();
    let plain = name.strip_suffix(".gz").unwrap_or(&name);
    let diagnosed = |errors: Diagnostics| CliError::Diagnosed(errors.render(error::stderr_has_color()));
    if [".geojson", ".json", ".shp", ".zip"].iter().any(|ending| plain.ends_with(ending)) {
        let read = load_vectors(path).map_err(diagnosed)?;
        if !read.notices.is_empty() {
            error::diagnose(&read.notices.render(error::stderr_has_color()));
        }
        error::print(&layer(path, &read))?;
    } else if [".svs", ".tre"].iter().any(|ending| plain.ends_with(ending)) {
        error::print(&trees(path, &load_trees(path).map_err(diagnosed)?))?;
    } else {
        return Ok(false);
    }
    Ok(true)
}

#[derive(Default)]
struct Counts {
    points: usize,
    lines: usize,
    polygons: usize,
    multipolygons: usize,
    holes: usize,
    positions: usize,
    bounds: Option<[[f64; 2]; 2]>,
}

impl Counts {
    fn add(&mut self, geometry: &Geometry) {
        match geometry {
            Geometry::Points(points) => {
                self.points += 1;
                self.positions(points);
            }
            Geometry::Lines(lines) => {
                self.lines += 1;
                lines.iter().for_each(|line| self.positions(line));
            }
            Geometry::Polygons(polygons) => {
                self.polygons += 1;
                self.multipolygons += usize::from(polygons.len() > 1);
                for rings in polygons {
                    self.holes += rings.holes.len();
                    self.positions(&rings.outer);
                    rings.holes.iter().for_each(|hole| self.positions(hole));
                }
            }
        }
    }

    fn positions(&mut self, positions: &[[f64; 2]]) {
        self.positions += positions.len();
        for &[x, y] in positions {
            let [low, high] = self.bounds.get_or_insert([[x, y]; 2]);
            (*low, *high) = ([low[0].min(x), low[1].min(y)], [high[0].max(x), high[1].max(y)]);
        }
    }
}

fn layer(path: &Path, Vectors { layer, kinds, .. }: &Vectors) -> String {
    let (mut counts, mut names) = (Counts::default(), BTreeMap::<&str, usize>::new());
    for feature in &layer.features {
        counts.add(&feature.geometry);
        feature.attributes.keys().for_each(|name| *names.entry(name).or_default() += 1);
    }
    let Counts { points, lines, polygons, multipolygons, holes, positions, bounds } = counts;
    let mut text = format!("{}: {} objects, {positions} positions\n", path.display(), layer.features.len());
    // Writing to a String cannot fail.
    let _ = writeln!(
        text,
        "  points {points}, lines {lines}, polygons {polygons} (of several parts {multipolygons}, holes {holes})"
    );
    let kinds: Vec<String> = kinds.iter().map(|(kind, count)| format!("{kind} {count}")).collect();
    let _ = writeln!(text, "  as the file has them: {}", kinds.join(", "));
    if let Some(crs) = layer.crs {
        let _ = writeln!(text, "  projection EPSG:{}", crs.code());
    }
    if let Some([[west, south], [east, north]]) = bounds {
        let _ = writeln!(text, "  from {west} {south} to {east} {north}");
    }
    let names: Vec<String> = names.iter().map(|(name, count)| format!("{name} ({count})")).collect();
    let _ = writeln!(text, "  attributes {}", if names.is_empty() { "none".to_string() } else { names.join(", ") });
    text
}

fn trees(path: &Path, list: &crate::parse::TreeList) -> String {
    let mut kinds = BTreeMap::<&str, (usize, f64, f64)>::new();
    for tree in &list.trees {
        let kind = kinds.entry(&tree.code).or_default();
        kind.0 += 1;
        kind.1 += tree.height.unwrap_or_default();
        kind.2 += f64::from(u8::from(tree.height.is_some()));
    }
    let title = list.title.as_deref().map(|title| format!(" ({title})")).unwrap_or_default();
    let placed = list.trees.iter().filter(|tree| tree.at.is_some()).count();
    let mut text = format!(
        "{}{title}: {} trees, {placed} with places; {} left out: lying, cut or dead\n",
        path.display(),
        list.trees.len(),
        list.left_out
    );
    for (code, (count, heights, measured)) in kinds {
        let mean = if measured > 0.0 { format!(", {:.1} m high", heights / measured) } else { String::new() };
        let _ = writeln!(text, "  {code} {count}{mean}");
    }
    text
}
