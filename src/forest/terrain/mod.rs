//! Terrain: the heights of a whole area on one lattice, and what its cells look like from afar.
//!
//! Cells -[`survey`]-> TERRAIN -[`relief`]-> faces of one frame; -> heights under trees, [`horizon`]
//!
//! Why of the whole area, not of the window: a diamond of the hierarchy has one place and one bound then, whichever cells are loaded. What is drawn of
//! the relief is a function of the eye alone, walked-in or jumped-to, and the land goes on beyond the horizon of the trees. It costs
//! 14 bytes a sample: 95,000 ha with a sample every 30 m are 15 MB. Areas of more samples than [`MOST_SAMPLES`] keep every second of
//! them, or every fourth, and say so ([`Terrain::squares`]).
//!
//! A cell that is missing is a void: no triangle crosses its border, because diamonds that would are always halved. A cell that is a
//! mesh is a void nearby, where the mesh itself is drawn; from afar its heights are drawn like all others.
//!
//! For faithful ground ([`Terrain::with_covers`]) every sample also has its cover, and there are as many as the borders between covers want.
//!
//! Space: samples count columns from the west and rows from the north of the rectangle around all cells; metres are the world's.
//! Source: `forest::relief`; A. Falcão, M. Próspero dos Santos (cells).

pub mod horizon;
pub mod relief;
mod survey;

pub use survey::TerrainError;

use super::area::{Cell, CellIndex, Ground};
use super::elevation::Grid;
use super::relief::borders::Borders;
use super::relief::lattice::{Field, Lattice};
use crate::color::Rgb;
use crate::math::Vec3;

/// The most samples of an area: 2^21.
pub const MOST_SAMPLES: usize = 1 << 21;

/// The most samples where borders between covers are kept: 2^23, at 23 bytes each.
pub const MOST_FINE_SAMPLES: usize = 1 << 23;

/// What a cell has to draw.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Kind {
    /// Nothing: there is no such cell, or it has no height at all.
    #[default]
    Missing,
    /// Its samples.
    Lattice,
    /// Triangles of its own; samples from afar.
    Mesh,
}

/// What is known of a cell that is not loaded.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Outline {
    kind: Kind,
    /// Lowest and highest ground, metres.
    ground: [f32; 2],
    /// The tallest tree, metres.
    tallest: f32,
    /// Lowest ground of each quarter: south-west, south-east, north-west, north-east.
    quarters: [f32; 4],
}

/// The heights of an area.
#[derive(Clone, Debug)]
pub struct Terrain {
    side: f64,
    /// The cell in the south-west corner, and cells across and up.
    corner: CellIndex,
    size: [usize; 2],
    squares: usize,
    grid: Grid,
    lattice: Lattice,
    bounds: Field<f32>,
    radii: Field<f32>,
    /// By column, then row from the south.
    outlines: Vec<Outline>,
    /// 5 bits red, 6 green, 5 blue of each sample: the land without its trees, or their crowns.
    colors: Vec<u16>,
    filled: usize,
    /// Borders between covers, and the metres to which nearby triangles keep them.
    borders: Option<(Borders, f64)>,
}

impl Terrain {
    /// Squares along the side of a cell, a power of two: the largest number of any cell, unless the area is too large for it.
    #[must_use]
    pub fn squares(&self) -> usize {
        self.squares
    }

    /// Samples of cells that were never measured; they have the height of the nearest in their row.
    #[must_use]
    pub fn filled(&self) -> usize {
        self.filled
    }

    /// Bytes of memory, but for a few hundred.
    #[must_use]
    pub fn bytes(&self) -> usize {
        let covers = if self.borders.is_some() { 1 + 4 + 4 } else { 0 };
        self.grid.heights().len() * (4 + 4 + 4 + 2 + covers) + std::mem::size_of_val(&self.outlines[..])
    }

    /// The lowest ground and the highest tree top of a cell, in metres; `None` where there is nothing.
    #[must_use]
    pub fn range(&self, cell: CellIndex) -> Option<(f64, f64)> {
        let outline = self.outline(cell)?;
        Some((f64::from(outline.ground[0]), f64::from(outline.ground[1]) + f64::from(outline.tallest)))
    }

    /// Metres between samples.
    fn step(&self) -> f64 {
        self.side / self.squares as f64
    }

    /// World position of the south-west corner.
    fn origin(&self) -> [f64; 2] {
        self.corner.map(|index| f64::from(index) * self.side)
    }

    fn outline(&self, [column, row]: CellIndex) -> Option<&Outline> {
        let place = |index: i32, corner: i32, size: usize| {
            usize::try_from(i64::from(index) - i64::from(corner)).ok().filter(|&at| at < size)
        };
        let column = place(column, self.corner[0], self.size[0])?;
        let row = place(row, self.corner[1], self.size[1])?;
        Some(&self.outlines[column * self.size[1] + row]).filter(|outline| outline.kind != Kind::Missing)
    }

    /// The cell around a square of the lattice: its column and row, and where that stands in the table.
    fn cell_of(&self, column: usize, row_from_north: usize) -> (CellIndex, usize) {
        let (column, north) = (column / self.squares, row_from_north / self.squares);
        let row = self.size[1] - 1 - north;
        ([self.corner[0] + column as i32, self.corner[1] + row as i32], column * self.size[1] + row)
    }

    /// Height of the ground of a cell at a position in it, metres; not a number where there is none.
    ///
    /// On lattices it is the surface of the finest triangles, those that are drawn under the feet of the observer.
    #[must_use]
    pub fn height(&self, cell: &Cell, [x, y]: [f64; 2]) -> f64 {
        if let Ground::Mesh { vertices, triangles } = &cell.ground {
            return height_on_mesh(vertices, triangles, [x, y]);
        }
        if self.outline(cell.index).is_none() {
            return f64::NAN;
        }
        let place = [0, 1].map(|axis| i64::from(cell.index[axis] - self.corner[axis]) as f64 * self.side);
        self.height_on_lattice([place[0] + x, place[1] + y])
    }

    /// The finest triangles, at metres from the south-west corner of the area.
    fn height_on_lattice(&self, [x, y]: [f64; 2]) -> f64 {
        let (columns, rows) = (self.grid.columns(), self.grid.rows());
        let (u, v) = (x / self.step(), (rows - 1) as f64 - y / self.step());
        let column = (u.max(0.0) as usize).min(columns - 2);
        let row = (v.max(0.0) as usize).min(rows - 2);
        let (u, v) = (u - column as f64, v - row as f64);
        let at = |across: usize, down: usize| f64::from(self.grid.height(column + across, row + down));
        let [nw, ne, sw, se] = [at(0, 0), at(1, 0), at(0, 1), at(1, 1)];
        // The last halving draws a diagonal through the corner whose column and row are both odd.
        if (column ^ row) & 1 == 0 {
            if u >= v { nw + (ne - nw) * u + (se - ne) * v } else { nw + (se - sw) * u + (sw - nw) * v }
        } else if u + v <= 1.0 {
            nw + (ne - nw) * u + (sw - nw) * v
        } else {
            se + (sw - se) * (1.0 - u) + (ne - se) * (1.0 - v)
        }
    }

    /// Unit normal of the ground at a sample, from its four neighbors.
    fn normal(&self, column: usize, row: usize) -> Vec3 {
        let (east, south) = (self.grid.columns() - 1, self.grid.rows() - 1);
        let (west, right) = (column.saturating_sub(1), (column + 1).min(east));
        let (north, below) = (row.saturating_sub(1), (row + 1).min(south));
        let height = |column, row| f64::from(self.grid.height(column, row));
        let across = (height(right, row) - height(west, row)) / ((right - west) as f64 * self.step());
        let up = (height(column, north) - height(column, below)) / ((below - north) as f64 * self.step());
        Vec3::new(-across, -up, 1.0).normalize()
    }

    /// What a sample looks like from afar.
    fn color(&self, column: usize, row: usize) -> Rgb {
        let packed = self.colors[row * self.grid.columns() + column];
        let [red, green, blue] = [(packed >> 11, 31.0), (packed >> 5 & 63, 63.0), (packed & 31, 31.0)];
        Rgb::new(f64::from(red.0) / red.1, f64::from(green.0) / green.1, f64::from(blue.0) / blue.1)
    }
}

/// Height of a mesh over a position: of the highest triangle there.
fn height_on_mesh(vertices: &[Vec3], triangles: &[([u32; 3], Option<u8>)], [x, y]: [f64; 2]) -> f64 {
    let mut highest = f64::NAN;
    for (corners, _) in triangles {
        let [Some(a), Some(b), Some(c)] = corners.map(|corner| vertices.get(corner as usize)) else { continue };
        let area =
            |p: [f64; 2], q: [f64; 2], r: [f64; 2]| (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
        let [p, q, r] = [a, b, c].map(|corner| [corner.x, corner.y]);
        let weights = [area(q, r, [x, y]), area(r, p, [x, y]), area(p, q, [x, y])];
        let sum = weights[0] + weights[1] + weights[2];
        // Slightly outside counts: a tree on an edge must not fall through between two triangles.
        if sum > 0.0 && weights.iter().all(|&weight| weight >= -1e-9 * sum) {
            let height = (weights[0] * a.z + weights[1] * b.z + weights[2] * c.z) / sum;
            highest = highest.max(height);
        }
    }
    highest
}
