//! Invent: landscapes of any size out of one number, cell by cell.
//!
//! hectares, seed -INVENT-> Head, cells one after the other -pack-> `.fpack`
//!
//! Why invented: real inventories of 95,000 ha have owners. An invented one shows what farop can do, and measures it, without a file: mountains and a
//! valley, a lake, a river, roads, six species of many ages in three years.
//!
//! Why cell by cell: any cell can be asked for by itself, and is the same whichever were asked for before. Heights are asked at positions of the world, so neighbors share the samples
//! on their border bit for bit; stands are regions of the world, cut at borders (`regions.rs`), and keep their number beyond them.
//!
//! Space: cells of 240 m; lattices of 9 x 9 samples, 30 m apart, in counts of 5 cm above the sea.
//! Cost: 0.1 ms a cell; kept is only what crosses many cells, the lines (1 MB for 95,000 ha).

mod regions;
mod relief;
mod stands;
#[cfg(test)]
mod tests;
mod ways;

pub use stands::YEARS;

use super::area::{Cell, CellIndex, Ground, Head, Owner, Patch};
use super::random::key;
use crate::scene::Place;
use regions::{Point, round};
use relief::Relief;
use stands::Land;

/// Side of a cell in metres.
pub const SIDE: f64 = 240.0;
/// Samples along the side of a cell.
const SAMPLES: u16 = 9;
/// Metres of a count.
const STEP: f64 = 0.05;
/// Corners of the lake.
const CORNERS: u32 = 120;
/// The largest landscape: 1,000 cells each way.
pub const MOST_HECTARES: f64 = 5_760_000.0;

/// A size that no landscape can have.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("a landscape of {hectares} ha cannot be invented: ask for more than 0 and at most {MOST_HECTARES} ha")]
pub struct InventError {
    /// What was asked for.
    pub hectares: f64,
}

/// An invented landscape; gives any of its cells.
pub struct Invented {
    head: Head,
    relief: Relief,
    lines: ways::Lines,
    columns: usize,
    count: usize,
    lake: Vec<Point>,
}

/// A landscape of at least so many hectares, about square: rows of cells from the south, the last one as long as needed.
///
/// # Errors
/// [`InventError`] where there is nothing, or more than [`MOST_HECTARES`], to invent.
///
/// ```
/// let land = farop::forest::invent::invent(95_000.0, 7).expect("a size");
/// assert_eq!(land.len(), 16_494);
/// let cell = land.cell([40, 60]).expect("within");
/// assert_eq!(cell, land.cells().find(|other| other.index == [40, 60]).expect("within"));
/// ```
pub fn invent(hectares: f64, seed: u64) -> Result<Invented, InventError> {
    if !(hectares > 0.0 && hectares <= MOST_HECTARES) {
        return Err(InventError { hectares });
    }
    let count = ((hectares / (SIDE * SIDE / 1e4)).ceil() as usize).max(1);
    let columns = (count as f64).sqrt().ceil() as usize;
    let rows = count.div_ceil(columns);
    let relief = Relief::new(seed, [columns as f64 * SIDE, rows as f64 * SIDE]);
    let marks = ways::marks(&relief);
    let lines = ways::lines(&relief, &marks, SIDE);
    let head = Head {
        objects: Vec::new(),
        files: Vec::new(),
        crs: String::new(),
        origin: [0.0; 2],
        side: SIDE,
        seed,
        species: stands::species(),
        covers: stands::covers(),
        marks,
    };
    let lake = shore(&relief);
    Ok(Invented { head, relief, lines, columns, count, lake })
}

impl Invented {
    /// What belongs to no single cell.
    #[must_use]
    pub fn head(&self) -> &Head {
        &self.head
    }

    /// How many cells there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.count
    }

    /// Never so: the smallest landscape is a cell.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// Columns and rows of cells; the last row may be shorter.
    #[must_use]
    pub fn size(&self) -> [usize; 2] {
        [self.columns, self.count.div_ceil(self.columns)]
    }

    /// All cells, row by row from the south, each invented when it is asked for.
    pub fn cells(&self) -> impl Iterator<Item = Cell> + '_ {
        let index = |number: usize| [(number % self.columns) as i32, (number / self.columns) as i32];
        (0..self.count).filter_map(move |number| self.cell(index(number)))
    }

    /// Metres above the sea at a position of the world: what the lattices sample.
    #[must_use]
    pub fn height(&self, at: [f64; 2]) -> f64 {
        self.relief.height(at)
    }

    /// A cell; `None` outside the landscape.
    #[must_use]
    pub fn cell(&self, index: CellIndex) -> Option<Cell> {
        let [column, row] = [usize::try_from(index[0]).ok()?, usize::try_from(index[1]).ok()?];
        if column >= self.columns || row * self.columns + column >= self.count {
            return None;
        }
        let low = [column as f64 * SIDE, row as f64 * SIDE];
        let mut cell = Cell {
            index,
            seed: key(&[self.head.seed, column as u64, row as u64]) >> 32,
            cover: Some(stands::GRASS),
            ground: self.ground(column, row),
            stands: Vec::new(),
            patches: Vec::new(),
            trees: Vec::new(),
            lines: self.lines.get(&index).cloned().unwrap_or_default(),
            place: Place::default(),
        };
        for (site, corners) in regions::in_square(self.head.seed, low, SIDE) {
            let owner = match stands::of_site(self.head.seed, &self.relief, &site) {
                Land::Bare(cover) => Owner::Cover(cover),
                Land::Stand(stand) => {
                    cell.stands.push(*stand);
                    Owner::Stand(cell.stands.len() as u32 - 1)
                }
            };
            cell.patches.push(patch(owner, &corners, low));
        }
        let lake = in_square(&self.lake, low);
        if lake.len() >= 3 {
            cell.patches.push(patch(Owner::Cover(stands::WATER), &lake, low));
        }
        Some(cell)
    }

    fn ground(&self, column: usize, row: usize) -> Ground {
        let last = usize::from(SAMPLES) - 1;
        // The number of a sample in the world, not in the cell: on a border both cells ask for the same one.
        let count = |number: usize| {
            let (i, j) = (number % (last + 1), number / (last + 1));
            let at = [column * last + i, (row + 1) * last - j].map(|steps| steps as f64 * (SIDE / last as f64));
            (self.relief.height(at) / STEP).round() as i16
        };
        let counts = (0..(last + 1) * (last + 1)).map(count).collect();
        Ground::Lattice { size: [SAMPLES; 2], base: 0.0, step: STEP, counts }
    }
}

fn patch(owner: Owner, corners: &[Point], low: Point) -> Patch {
    let outer = corners.iter().map(|corner| [corner[0] - low[0], corner[1] - low[1]]).collect();
    Patch { owner, outer, holes: Vec::new(), place: Place::default() }
}

/// The outline of the lake, counterclockwise.
fn shore(relief: &Relief) -> Vec<Point> {
    let corner = |number: u32| {
        let angle = 2.0 * crate::math::PI * f64::from(number) / f64::from(CORNERS);
        let direction = [crate::math::cos(angle), crate::math::sin(angle)];
        let reach = relief.lake.reach(direction);
        [0, 1].map(|axis| round(relief.lake.center[axis] + reach * direction[axis]))
    };
    (0..CORNERS).map(corner).collect()
}

/// The part of a convex outline in the cell with this corner. Cuts are computed in one direction whichever cell asks, and rounded.
fn in_square(outline: &[Point], low: Point) -> Vec<Point> {
    let mut corners = outline.to_vec();
    for (axis, border, keeps_above) in
        [(0, low[0], true), (0, low[0] + SIDE, false), (1, low[1], true), (1, low[1] + SIDE, false)]
    {
        let is_in = |at: &Point| if keeps_above { at[axis] >= border } else { at[axis] <= border };
        let mut kept: Vec<Point> = Vec::new();
        for (a, b) in crate::math::edges(&corners) {
            if is_in(a) {
                kept.push(*a);
            }
            if is_in(a) != is_in(b) && a[axis] != border && b[axis] != border {
                let (a, b) = if a < b { (a, b) } else { (b, a) };
                let across = 1 - axis;
                let cut = round(a[across] + (b[across] - a[across]) * ((border - a[axis]) / (b[axis] - a[axis])));
                kept.push(if axis == 0 { [border, cut] } else { [cut, border] });
            }
        }
        kept.dedup();
        corners = kept;
    }
    if super::polygon::area(&corners) > 0.0 { corners } else { Vec::new() }
}
