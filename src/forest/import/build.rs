//! Build: cells with heights, pieces of stands and stretches of roads.
//!
//! [`Sources`], [`Choices`] -BUILD-> [`Imported`]
//!
//! Space: layers in their projection, then metres from the south-west corner of cell 0 0. Cost: see [`super`].

use super::kinds::Kinds;
use super::land_use::line_of;
use super::owners::{Owned, Owners, place_of};
use super::survey::{bounds, check_degrees, map_of, nowhere, world};
use super::{Choices, Imported, Sources, StandLand, Summary, World, cut, land, stretches};
use crate::diagnostic::Diagnostic;
use crate::forest::area::{Area, Cell, CellIndex, Head, Line, Owner, Patch};
use crate::forest::polygon::Point;
use crate::forest::random::key;
use crate::forest::vector::{Crs, Geometry, Layer, Rings};
use crate::scene::Place;
use std::collections::BTreeMap;

/// Errors that are told before it ends.
const MOST_ERRORS: usize = 20;

/// An area in the making.
pub(super) struct Builder<'a> {
    sources: Sources<'a>,
    choices: &'a Choices,
    /// What the numbers of the stands mean.
    crs: Crs,
    world: World,
    cells: BTreeMap<CellIndex, Cell>,
    kinds: Kinds,
    summary: Summary,
    notices: Vec<Diagnostic>,
    errors: Vec<Diagnostic>,
}

impl<'a> Builder<'a> {
    /// An area without stands: its map, its cells with their heights.
    pub fn new(sources: Sources<'a>, choices: &'a Choices) -> Result<Builder<'a>, Vec<Diagnostic>> {
        let layer = sources.stands;
        let crs =
            layer.crs.ok_or_else(|| {
                let error = Diagnostic::error(format!("`{}` does not say its projection", layer.name));
                vec![error.help(
                    "say it: `--stands-crs EPSG:4326` for degrees, `EPSG:326zz` or `EPSG:327zz` for UTM on WGS 84",
                )]
            })?;
        let bounds = bounds(layer).ok_or_else(|| {
            let error = Diagnostic::error(format!("`{}` has no polygon", layer.name));
            vec![error.help("stands are polygons; roads come with `--lines`")]
        })?;
        check_degrees(layer, crs).map_err(|error| vec![error])?;
        let map = choices.crs.unwrap_or_else(|| map_of(crs, bounds));
        let (world, size) = world(layer, [crs, map], choices).map_err(|error| vec![error])?;
        let kinds = Kinds::default();
        let summary = Summary { side: choices.side, ..Summary::default() };
        let (notices, errors, cells) = (Vec::new(), Vec::new(), BTreeMap::new());
        let mut builder = Builder { sources, choices, crs, world, cells, kinds, summary, notices, errors };
        builder.make_cells(size);
        if builder.cells.is_empty() {
            return Err(vec![nowhere(sources.relief, layer, crs, bounds)]);
        }
        Ok(builder)
    }

    /// Cells wherever there is a height.
    fn make_cells(&mut self, size: [i32; 2]) {
        let ground = self.kinds.cover(&self.choices.ground);
        for index in (0..size[1]).flat_map(|row| (0..size[0]).map(move |column| [column, row])) {
            let Some((heights, voids)) = self.sources.relief.ground(&self.world, index, self.choices.samples) else {
                self.summary.cells[1] += 1;
                continue;
            };
            self.summary.cells[0] += 1;
            self.summary.voids += voids;
            let cell = Cell {
                index,
                seed: key(&[self.choices.seed, index[0] as u64, index[1] as u64]) >> 32,
                cover: Some(ground),
                ground: heights,
                stands: Vec::new(),
                patches: Vec::new(),
                trees: Vec::new(),
                lines: Vec::new(),
                place: Place::default(),
            };
            self.cells.insert(index, cell);
        }
    }

    /// Puts stands, grounds and lines into the cells.
    pub fn run(mut self) -> Result<Imported, Vec<Diagnostic>> {
        let layer = self.sources.stands;
        let mut owners = Owners::new(&self.sources, self.choices);
        for (index, feature) in layer.features.iter().enumerate() {
            let place = place_of(layer, feature, index);
            let Geometry::Polygons(parts) = &feature.geometry else {
                *owners.dropped.entry("features that are no polygons".to_string()).or_default() += 1;
                continue;
            };
            match owners.of(feature, &place, self.choices, &mut self.kinds) {
                Ok(Owned::Nothing) => {}
                Ok(owned) => self.polygons(parts, owned, &place, &owners),
                Err(error) => self.errors.push(error),
            }
            if self.errors.len() >= MOST_ERRORS {
                break;
            }
        }
        if let Some(lines) = self.sources.lines {
            self.lines(lines);
        }
        if !self.errors.is_empty() {
            return Err(self.errors);
        }
        self.notices.extend(owners.notices());
        self.finished(owners)
    }

    /// The parts of a feature, cut into the cells.
    fn polygons(&mut self, parts: &[Rings], owned: Owned, place: &str, owners: &Owners<'_>) {
        self.summary.polygons += parts.len();
        self.summary.multipolygons += usize::from(parts.len() > 1);
        self.summary.holes += parts.iter().map(|part| part.holes.len()).sum::<usize>();
        let (mut inside, mut outside) = (0.0, 0.0);
        for part in parts {
            let pieces = match cut(&self.world.rings(self.crs, part), self.world.side) {
                Ok(pieces) => pieces,
                Err(tangled) => {
                    let near = tangled.near.map(|number| format!("{number:.2}")).join(" ");
                    let error = Diagnostic::error(format!(
                        "{place}: an outline crosses itself near {near} (metres of the area)"
                    ));
                    self.errors.push(error.help("repair it, as a GIS does with `make valid`"));
                    return;
                }
            };
            for (index, piece) in
                pieces.into_iter().flat_map(|(index, pieces)| pieces.into_iter().map(move |piece| (index, piece)))
            {
                let land = land(&piece);
                match self.cells.get_mut(&index) {
                    Some(cell) => {
                        inside += land;
                        give(cell, piece, owned, owners, self.world.side);
                    }
                    None => outside += land,
                }
            }
        }
        self.count(owned, parts.len(), inside, owners);
        if outside > 0.0 {
            let message = format!(
                "{place}: {:.2} of {:.2} ha lie where the relief has no heights, and are left out",
                outside / 1e4,
                (inside + outside) / 1e4
            );
            self.notices.push(Diagnostic::notice(message).help("add the neighboring tile with another `--relief`"));
        }
    }

    fn count(&mut self, owned: Owned, polygons: usize, land: f64, owners: &Owners<'_>) {
        match owned {
            Owned::Stand(number) => {
                let stand = self.summary.stands.entry(number).or_default();
                if let Some((name, own)) = owners.stands.get(&number) {
                    let density = own.states.first().map_or(0.0, |state| state.density);
                    *stand = StandLand { name: name.clone(), density, ..stand.clone() };
                }
                stand.polygons += polygons;
                stand.land += land;
            }
            Owned::Ground(ground) => {
                let image = self.kinds.covers.get(usize::from(ground)).map_or("", |cover| cover.image.as_str());
                *self.summary.grounds.entry(image.trim_start_matches("paint:").to_string()).or_default() += land;
            }
            Owned::Nothing => {}
        }
    }

    /// Roads and rivers, cut into the cells.
    fn lines(&mut self, layer: &Layer) {
        let crs = layer.crs.unwrap_or(self.crs);
        for feature in &layer.features {
            let Geometry::Lines(parts) = &feature.geometry else {
                *self.summary.dropped.entry("features of `--lines` that are no lines".to_string()).or_default() += 1;
                continue;
            };
            let (kind, width) = line_of(feature);
            for part in parts {
                let line: Vec<Point> = part.iter().map(|&corner| self.world.place(crs, corner)).collect();
                let mut kept = false;
                for (index, points) in stretches(&line, self.world.side) {
                    let Some(cell) = self.cells.get_mut(&index) else { continue };
                    let points = points.iter().map(|&point| local(point, index, self.world.side)).collect();
                    cell.lines.push(Line { kind: kind.to_string(), width, points, place: Place::default() });
                    kept = true;
                }
                self.summary.lines += usize::from(kept);
                if !kept {
                    *self.summary.dropped.entry("lines outside of the cells".to_string()).or_default() += 1;
                }
            }
        }
    }

    fn finished(mut self, owners: Owners<'_>) -> Result<Imported, Vec<Diagnostic>> {
        for (why, count) in owners.dropped {
            *self.summary.dropped.entry(why).or_default() += count;
        }
        self.summary.species = self.kinds.species.iter().map(|species| species.code.clone()).collect();
        let mut years: Vec<i32> =
            owners.stands.values().flat_map(|(_, stand)| stand.states.iter().filter_map(|state| state.year)).collect();
        years.sort_unstable();
        years.dedup();
        self.summary.years = years;
        let head = Head {
            objects: Vec::new(),
            files: Vec::new(),
            crs: format!("EPSG:{}", self.world.crs.code()),
            origin: self.world.origin,
            side: self.world.side,
            seed: self.choices.seed,
            species: self.kinds.species,
            covers: self.kinds.covers,
            marks: Vec::new(),
        };
        Ok(Imported { area: Area { head, cells: self.cells }, summary: self.summary, notices: self.notices })
    }
}

/// A piece of land for a cell.
fn give(cell: &mut Cell, piece: Rings, owned: Owned, owners: &Owners<'_>, side: f64) {
    let owner = match owned {
        Owned::Ground(ground) => Owner::Cover(ground),
        Owned::Stand(number) => {
            let known = cell.stands.iter().position(|stand| stand.number == number);
            let at = known.unwrap_or_else(|| {
                cell.stands.extend(owners.stands.get(&number).map(|(_, stand)| stand.clone()));
                cell.stands.len() - 1
            });
            Owner::Stand(at as u32)
        }
        Owned::Nothing => return,
    };
    let ring = |ring: &[Point]| ring.iter().map(|&corner| local(corner, cell.index, side)).collect();
    let (outer, holes) = (ring(&piece.outer), piece.holes.iter().map(|hole| ring(hole)).collect());
    cell.patches.push(Patch { owner, outer, holes, place: Place::default() });
}

/// A position of the world in a cell: the difference is exact, and never beyond the border.
fn local(point: Point, index: CellIndex, side: f64) -> Point {
    [0, 1].map(|axis| (point[axis] - f64::from(index[axis]) * side).clamp(0.0, side))
}

impl World {
    /// A position of a layer, in metres from the south-west corner of cell 0 0.
    fn place(&self, crs: Crs, position: Point) -> Point {
        let map = crs.to(self.crs, position);
        [map[0] - self.origin[0], map[1] - self.origin[1]]
    }

    fn rings(&self, crs: Crs, rings: &Rings) -> Rings {
        let ring = |ring: &Vec<Point>| ring.iter().map(|&corner| self.place(crs, corner)).collect();
        Rings { outer: ring(&rings.outer), holes: rings.holes.iter().map(ring).collect() }
    }
}
