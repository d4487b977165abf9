//! Ground: the land of all cells as triangles, a mesh for every cover, and the height of any place on them.
//!
//! lattices -> squares, finer where covers differ -> a mesh a cover
//!
//! A square of the lattice is two triangles, cut from south-west to north-east. Where an area has patches with covers of their own, squares
//! are divided into smaller ones that lie in the planes of those triangles, the same number in every cell: a smaller one has the cover of
//! its middle. So land keeps its form whatever grows on it, no edge has a corner of a neighbor in its middle, and trees stand on what is drawn.
//!
//! Normals are those of the lattice across the borders of cells, so no border is seen in the light.
//! Space: meshes in the cell; heights by world position or by position in the cell.

use crate::forest::area::{Cell, CellIndex, Ground, Head, Owner};
use crate::forest::polygon::contains;
use crate::math::{Vec3, unit};
use crate::scene::{Mesh, NormalSource};
use std::collections::BTreeMap;

/// Into how many squares the side of a cell is divided, about, where covers differ.
const FINE: usize = 64;
/// The most small squares of all cells together.
const MOST_SQUARES: usize = 600_000;

/// All cells, and how finely their ground is drawn.
pub(super) struct Land<'a> {
    head: &'a Head,
    cells: &'a BTreeMap<CellIndex, Cell>,
    year: Option<i32>,
    is_fine: bool,
}

impl<'a> Land<'a> {
    pub fn new(head: &'a Head, cells: &'a BTreeMap<CellIndex, Cell>, year: Option<i32>) -> Land<'a> {
        let has_covers = |cell: &Cell| cell.patches.iter().any(|patch| cover_of(cell, patch.owner, year) != cell.cover);
        let is_fine = cells.values().any(has_covers);
        Land { head, cells, year, is_fine }
    }

    pub fn side(&self) -> f64 {
        self.head.side
    }

    /// South-west and north-east corner of the rectangle of all cells.
    pub fn borders(&self) -> ([f64; 2], [f64; 2]) {
        let bounds = crate::forest::cells::bounds(self.cells.keys().copied());
        let [south_west, north_east] = bounds.unwrap_or_default();
        let far = north_east.map(|number| f64::from(number) + 1.0);
        (south_west.map(|number| f64::from(number) * self.side()), far.map(|number| number * self.side()))
    }

    /// The lowest and the highest place.
    pub fn heights(&self) -> (f64, f64) {
        let mut range = (f64::INFINITY, f64::NEG_INFINITY);
        let mut add = |height: f64| {
            if height.is_finite() {
                range = (range.0.min(height), range.1.max(height));
            }
        };
        for cell in self.cells.values() {
            match &cell.ground {
                Ground::Lattice { size, .. } => {
                    let [columns, rows] = size.map(usize::from);
                    (0..rows).for_each(|row| (0..columns).for_each(|column| add(cell.ground.sample(column, row))));
                }
                Ground::Mesh { vertices, .. } => vertices.iter().for_each(|vertex| add(vertex.z)),
            }
        }
        if range.0 <= range.1 { range } else { (0.0, 0.0) }
    }

    /// The height of the drawn ground at a world position; `None` outside and in voids.
    pub fn height(&self, at: [f64; 2]) -> Option<f64> {
        let cell = self.cells.get(&self.head.cell_at(at))?;
        let corner = self.head.corner(cell.index);
        self.height_in(cell, [at[0] - corner.x, at[1] - corner.y])
    }

    /// The height of the drawn ground at a position in the cell; the border goes on beyond it.
    pub fn height_in(&self, cell: &Cell, at: [f64; 2]) -> Option<f64> {
        match &cell.ground {
            Ground::Lattice { size, .. } => {
                let [columns, rows] = size.map(|length| usize::from(length) - 1);
                let place = |at: f64, count: usize| (at / self.side() * count as f64).clamp(0.0, count as f64);
                let (x, y) = (place(at[0], columns), place(self.side() - at[1], rows));
                let (column, row) = ((x as usize).min(columns - 1), (y as usize).min(rows - 1));
                let square = Square::of(&cell.ground, column, row)?;
                Some(square.height(x - column as f64, row as f64 + 1.0 - y))
            }
            Ground::Mesh { vertices, triangles } => {
                let inside = |a: f64, b: f64| a >= -1e-9 && b >= -1e-9 && a + b <= 1.0 + 1e-9;
                triangles.iter().find_map(|(corners, _)| {
                    let [a, b, c] = corners.map(|corner| vertices[corner as usize]);
                    let (ab, ac) = (b - a, c - a);
                    let [x, y] = [at[0] - a.x, at[1] - a.y];
                    let area = ab.x * ac.y - ab.y * ac.x;
                    let (u, v) = ((x * ac.y - y * ac.x) / area, (ab.x * y - ab.y * x) / area);
                    inside(u, v).then_some(a.z + u * ab.z + v * ac.z)
                })
            }
        }
    }

    /// The ground of a cell: a mesh for every cover, by number; `None` first.
    pub fn meshes(&self, cell: &Cell) -> BTreeMap<Option<u8>, Mesh> {
        match &cell.ground {
            Ground::Lattice { size, .. } => self.lattice(cell, size.map(|length| usize::from(length) - 1)),
            Ground::Mesh { vertices, triangles } => {
                let mut meshes: BTreeMap<Option<u8>, Mesh> = BTreeMap::new();
                for (corners, cover) in triangles {
                    let cover = cover.or(cell.cover);
                    let mesh = meshes.entry(cover).or_default();
                    let outline = corners.map(|corner| {
                        let vertex = vertices[corner as usize];
                        self.push(mesh, cell, cover, (vertex, None))
                    });
                    mesh.push_polygon(&outline, NormalSource::Averaged, cell.place.line);
                }
                meshes
            }
        }
    }

    fn lattice(&self, cell: &Cell, [columns, rows]: [usize; 2]) -> BTreeMap<Option<u8>, Mesh> {
        let most = (MOST_SQUARES / self.cells.len().max(1)).isqrt();
        let parts = if self.is_fine { (FINE.min(most) / columns.max(rows)).max(1) } else { 1 };
        let mut meshes: BTreeMap<Option<u8>, Sheet> = BTreeMap::new();
        let (wide, high) = (columns * parts, rows * parts);
        let step = [self.side() / wide as f64, self.side() / high as f64];
        for row in 0..high {
            for column in 0..wide {
                let Some(square) = Square::of(&cell.ground, column / parts, row / parts) else { continue };
                let middle = [(column as f64 + 0.5) * step[0], self.side() - (row as f64 + 0.5) * step[1]];
                let cover = self.cover(cell, middle);
                let sheet = meshes.entry(cover).or_insert_with(|| Sheet::new(wide, high));
                // From the south-west corner counterclockwise.
                let corners = [(column, row + 1), (column + 1, row + 1), (column + 1, row), (column, row)];
                let outline = corners.map(|(x, y)| {
                    let known = sheet.vertices[y * (wide + 1) + x];
                    if known != u32::MAX {
                        return known;
                    }
                    let [u, v] = [x as f64 / parts as f64, y as f64 / parts as f64];
                    let (left, top) = ((column / parts) as f64, (row / parts) as f64);
                    let z = square.height(u - left, top + 1.0 - v);
                    let position = Vec3::new(x as f64 * step[0], self.side() - y as f64 * step[1], z);
                    let normal = self.normal(cell, [columns, rows], [u, v]);
                    let index = self.push(&mut sheet.mesh, cell, cover, (position, Some(normal)));
                    sheet.vertices[y * (wide + 1) + x] = index;
                    index
                });
                let [a, b, c, d] = outline;
                sheet.mesh.push_polygon(&[a, b, c], NormalSource::Given, cell.place.line);
                sheet.mesh.push_polygon(&[a, c, d], NormalSource::Given, cell.place.line);
            }
        }
        meshes.into_iter().map(|(cover, sheet)| (cover, sheet.mesh)).collect()
    }

    /// Adds a vertex with the place on its cover's picture, which goes on over the borders of cells.
    fn push(&self, mesh: &mut Mesh, cell: &Cell, cover: Option<u8>, (at, normal): (Vec3, Option<Vec3>)) -> u32 {
        let index = match normal {
            Some(normal) => mesh.push_vertex_with_normal(at, normal),
            None => mesh.push_vertex(at),
        };
        if let Some(cover) = cover.and_then(|cover| self.head.covers.get(usize::from(cover))) {
            // Whole tiles before the corner of the cell are left out: coordinates stay small, and the picture stays where it is.
            let corner = self.head.corner(cell.index);
            let [x, y] = [corner.x, corner.y].map(|start| (start / cover.tile).fract());
            mesh.texture.resize(index as usize, Vec3::ZERO);
            mesh.texture.push(Vec3::new(x + at.x / cover.tile, y + at.y / cover.tile, 0.0));
        }
        index
    }

    /// The cover at a place of a cell: that of the last patch over it that has one.
    fn cover(&self, cell: &Cell, at: [f64; 2]) -> Option<u8> {
        let patches = cell.patches.iter().rev();
        let owner = patches.filter(|patch| contains(&patch.outer, &patch.holes, at)).map(|patch| patch.owner).next();
        owner.map_or(cell.cover, |owner| cover_of(cell, owner, self.year))
    }

    /// The normal at a place of the lattice, in columns and rows: of the slopes to its neighbors, those in other cells among them.
    fn normal(&self, cell: &Cell, size: [usize; 2], [u, v]: [f64; 2]) -> Vec3 {
        let step = [self.side() / size[0] as f64, self.side() / size[1] as f64];
        let at = |x: i64, y: i64| self.sample(cell, size, [x, y]);
        let slope = |column: i64, row: i64| {
            let here = at(column, row).unwrap_or_default();
            let between = |a: Option<f64>, b: Option<f64>, step: f64| {
                let width = f64::from(u8::from(a.is_some()) + u8::from(b.is_some())).max(1.0) * step;
                (b.unwrap_or(here) - a.unwrap_or(here)) / width
            };
            let east = between(at(column - 1, row), at(column + 1, row), step[0]);
            [east, between(at(column, row + 1), at(column, row - 1), step[1])]
        };
        // Between samples, the mean of the slopes at the corners of the square.
        let (column, row) = ((u as i64).min(size[0] as i64 - 1), (v as i64).min(size[1] as i64 - 1));
        let (x, y) = (u - column as f64, v - row as f64);
        let mut mean = [0.0; 2];
        for (i, j, weight) in
            [(0, 0, (1.0 - x) * (1.0 - y)), (1, 0, x * (1.0 - y)), (0, 1, (1.0 - x) * y), (1, 1, x * y)]
        {
            if weight > 0.0 {
                let [east, north] = slope(column + i, row + j);
                mean = [mean[0] + weight * east, mean[1] + weight * north];
            }
        }
        unit(Vec3::new(-mean[0], -mean[1], 1.0)).unwrap_or(Vec3::Z)
    }

    /// A sample of the cell, or of a neighbor with an equal lattice; `None` where there is none.
    fn sample(&self, cell: &Cell, size: [usize; 2], at: [i64; 2]) -> Option<f64> {
        let count = size.map(|steps| steps as i64);
        let over = |axis: usize| i32::from(at[axis] > count[axis]) - i32::from(at[axis] < 0);
        let (east, south) = (over(0), over(1));
        let ground = match (east, south) {
            (0, 0) => &cell.ground,
            _ => &self.cells.get(&[cell.index[0] + east, cell.index[1] - south])?.ground,
        };
        let Ground::Lattice { size: theirs, .. } = ground else { return None };
        let is_equal = theirs.map(|length| usize::from(length) - 1) == size;
        let column = usize::try_from(at[0] - i64::from(east) * count[0]).ok()?;
        let row = usize::try_from(at[1] - i64::from(south) * count[1]).ok()?;
        Some(ground.sample(column, row)).filter(|height| is_equal && !height.is_nan())
    }
}

/// The vertices of one cover, found again by their place in the cell.
struct Sheet {
    mesh: Mesh,
    vertices: Vec<u32>,
}

impl Sheet {
    fn new(wide: usize, high: usize) -> Sheet {
        Sheet { mesh: Mesh::default(), vertices: vec![u32::MAX; (wide + 1) * (high + 1)] }
    }
}

/// The heights of the corners of a square of a lattice: south-west, south-east, north-east, north-west.
struct Square([f64; 4]);

impl Square {
    /// `None` where a corner is a void.
    fn of(ground: &Ground, column: usize, row: usize) -> Option<Square> {
        let corners = [(column, row + 1), (column + 1, row + 1), (column + 1, row), (column, row)];
        let heights = corners.map(|(column, row)| ground.sample(column, row));
        heights.iter().all(|height| !height.is_nan()).then_some(Square(heights))
    }

    /// The height at a place of it, 0 to 1 east and north: in one of two planes that meet from south-west to north-east.
    fn height(&self, east: f64, north: f64) -> f64 {
        let [sw, se, ne, nw] = self.0;
        if east >= north {
            sw + (se - sw) * east + (ne - se) * north
        } else {
            sw + (nw - sw) * north + (ne - nw) * east
        }
    }
}

/// The cover of an owner in a year: its own, else the cell's.
fn cover_of(cell: &Cell, owner: Owner, year: Option<i32>) -> Option<u8> {
    match owner {
        Owner::Cover(cover) => Some(cover),
        Owner::Stand(stand) => {
            let state = cell.stands.get(stand as usize).and_then(|stand| stand.in_year(year));
            state.and_then(|state| state.cover).or(cell.cover)
        }
    }
}
