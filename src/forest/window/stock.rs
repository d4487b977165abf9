//! Stock: the cells of the window, with their trees grown.
//!
//! Cells, observer -STOCK-> [`Stocked`] cells -> frame
//!
//! Cells whose trees may show are loaded before the frame, all of them: what a picture shows never depends on how fast the observer came. The
//! others of the window, beyond the horizon, come a few a frame, the nearest first, so that a border is crossed without a hitch.
//!
//! Trees are kept by squares of the cell ([`SQUARES`] along each side), so that a frame sorts squares, not trees, and drops most of them unseen.
//!
//! Space: metres. Cost: 8 bytes a tree, [`RASTER`]^2 bytes of ground a cell.

use super::Window;
use crate::forest::area::{Cell, CellIndex, Head};
use crate::forest::cells::Cells;
use crate::forest::cover;
use crate::forest::pack::PackError;
use crate::forest::pictures::Pictures;
use crate::forest::place::{PlaceError, Placement, Sizes, Tree, base_of, grow};
use crate::forest::terrain::Terrain;
use crate::forest::terrain::relief::distance_to_cell;
use crate::image::textures::{FirstRow, Mosaic, Tile};
use crate::math::Vec3;
use crate::scene::Texture;

/// Squares along the side of a cell.
pub const SQUARES: usize = 8;
/// Numbers of ground along the side of a cell: one every 2 m of 240.
pub const RASTER: usize = 120;

/// Why a cell is not in memory.
#[derive(Debug, thiserror::Error)]
pub enum StockError {
    /// It cannot be read.
    #[error(transparent)]
    Pack(#[from] PackError),
    /// No trees can be grown in it.
    #[error(transparent)]
    Place(#[from] PlaceError),
}

/// A cell in memory.
#[derive(Clone, Debug)]
pub struct Stocked {
    /// As it was read.
    pub cell: Cell,
    /// From where [`Tree::z`] counts, metres.
    pub base: f64,
    /// By square, row after row from the south.
    trees: Vec<Tree>,
    starts: Vec<u32>,
    /// Lowest foot and highest top in each square, metres; the first above the second where no tree is.
    ranges: Vec<[f32; 2]>,
    /// The ground, as a picture of pictures.
    pub ground: Texture,
}

/// The trees of one square.
#[derive(Clone, Copy, Debug)]
pub struct Grove<'a> {
    /// The trees.
    pub trees: &'a [Tree],
    /// Lowest foot and highest top, metres.
    pub range: [f64; 2],
}

impl Stocked {
    fn new(
        cells: &Cells,
        cell: Cell,
        year: Option<i32>,
        terrain: &Terrain,
        pictures: &Pictures,
    ) -> Result<Stocked, StockError> {
        let head = cells.head();
        let trees = grow(head, &cell, year, Placement::Lattice, &|at| terrain.height(&cell, at))?;
        let base = base_of(&cell);
        let square = |tree: &Tree| {
            let [column, row] = [tree.x, tree.y].map(|steps| (usize::from(steps) * SQUARES) >> 16);
            row * SQUARES + column
        };
        let mut starts = vec![0_u32; SQUARES * SQUARES + 1];
        trees.iter().for_each(|tree| starts[square(tree) + 1] += 1);
        (0..SQUARES * SQUARES).for_each(|at| starts[at + 1] += starts[at]);
        let mut next = starts.clone();
        let mut sorted = trees.clone();
        let mut ranges = vec![[f32::INFINITY, f32::NEG_INFINITY]; SQUARES * SQUARES];
        let sizes = Sizes::new(head, &cell, year);
        for tree in trees {
            let at = square(&tree);
            sorted[next[at] as usize] = tree;
            next[at] += 1;
            let foot = tree.height_above_sea(base);
            let top = (foot + sizes.of(tree).height) as f32;
            ranges[at] = [ranges[at][0].min(foot as f32), ranges[at][1].max(top.next_up())];
        }
        let ground = ground(head, &cell, year, pictures);
        Ok(Stocked { cell, base, trees: sorted, starts, ranges, ground })
    }

    /// The trees of square `at`.
    #[must_use]
    pub fn grove(&self, at: usize) -> Grove<'_> {
        let trees = &self.trees[self.starts[at] as usize..self.starts[at + 1] as usize];
        Grove { trees, range: self.ranges[at].map(f64::from) }
    }

    /// All its trees.
    #[must_use]
    pub fn trees(&self) -> &[Tree] {
        &self.trees
    }

    /// Bytes of memory.
    #[must_use]
    pub fn bytes(&self) -> usize {
        let outlines = self.cell.patches.iter().flat_map(|patch| std::iter::once(&patch.outer).chain(&patch.holes));
        let outlines: usize = outlines.map(|outline| std::mem::size_of_val(&outline[..])).sum();
        std::mem::size_of::<Stocked>()
            + std::mem::size_of_val(&self.trees[..])
            + std::mem::size_of_val(&self.starts[..])
            + std::mem::size_of_val(&self.ranges[..])
            + std::mem::size_of_val(&self.cell.stands[..])
            + outlines
            + RASTER * RASTER
    }
}

/// The ground of a cell: covers, then roads and rivers over them.
fn ground(head: &Head, cell: &Cell, year: Option<i32>, pictures: &Pictures) -> Texture {
    let mut numbers = cover::raster(head, cell, year, RASTER);
    let last = pictures.grounds.len().saturating_sub(1) as u8;
    let road = pictures.road() as u8;
    for line in &cell.lines {
        let number = if line.kind == "river" { last } else { road };
        line.points
            .windows(2)
            .for_each(|ends| paint(&mut numbers, head.side, [ends[0], ends[1]], line.width / 2.0, number));
    }
    numbers.iter_mut().for_each(|number| *number = (*number).min(last));
    let repeat = |number: usize| {
        let metres = number.checked_sub(1).and_then(|cover| head.covers.get(cover)).map_or(10.0, |cover| cover.tile);
        [head.side / metres; 2]
    };
    let tile = |(number, ground): (usize, &crate::forest::pictures::Painted)| Tile {
        texels: ground.texels.clone(),
        repeat: repeat(number),
    };
    let tiles = pictures.grounds.iter().enumerate().map(tile).collect();
    let size = (RASTER as u32, RASTER as u32);
    match Mosaic::new(size, numbers, FirstRow::AtV0, tiles) {
        Some(mosaic) => Texture::mosaic("ground", mosaic),
        // A tile of no metres; parsers refuse it.
        None => Texture {
            wrap: crate::image::textures::Wrap::Repeat,
            ..Texture::opaque("ground", (*pictures.grounds[0].texels).clone())
        },
    }
}

/// Gives a number to the texels whose centers are near a line.
fn paint(numbers: &mut [u8], side: f64, [from, to]: [[f64; 2]; 2], reach: f64, number: u8) {
    let step = side / RASTER as f64;
    let span = |axis: usize| {
        let (low, high) = (from[axis].min(to[axis]) - reach, from[axis].max(to[axis]) + reach);
        (low / step).max(0.0) as usize..((high / step).max(0.0).ceil() as usize).min(RASTER)
    };
    let along = [to[0] - from[0], to[1] - from[1]];
    let length = along[0] * along[0] + along[1] * along[1];
    for (row, column) in span(1).flat_map(|row| span(0).map(move |column| (row, column))) {
        let at = [(column as f64 + 0.5) * step - from[0], (row as f64 + 0.5) * step - from[1]];
        let share = if length > 0.0 { ((at[0] * along[0] + at[1] * along[1]) / length).clamp(0.0, 1.0) } else { 0.0 };
        let away = [at[0] - along[0] * share, at[1] - along[1] * share];
        if away[0] * away[0] + away[1] * away[1] <= reach * reach {
            numbers[row * RASTER + column] = number;
        }
    }
}

/// The cells of the window.
#[derive(Debug)]
pub struct Stock {
    window: Window,
    /// By column and row, each modulo the side of the window: who stays in the window stays where it is.
    slots: Vec<Option<Stocked>>,
    year: Option<i32>,
    horizon: f64,
    prefetch: usize,
}

impl Stock {
    /// Empty; the horizon in metres, the buffer in cells. `prefetch` cells a frame come before they are needed.
    #[must_use]
    pub fn new(head: &Head, year: Option<i32>, (horizon, buffer): (f64, u16), prefetch: usize) -> Stock {
        let window = Window::new(buffer, Window::cells_to(horizon, head.side), [0, 0]);
        Stock { window, slots: vec![None; window.side() * window.side()], year, horizon, prefetch }
    }

    /// The window.
    #[must_use]
    pub fn window(&self) -> &Window {
        &self.window
    }

    /// Takes the window along, and loads what the eye may see and a little more; how many cells were loaded.
    ///
    /// # Errors
    /// A cell cannot be read, or has too many trees.
    pub fn follow(
        &mut self,
        cells: &Cells,
        terrain: &Terrain,
        pictures: &Pictures,
        eye: Vec3,
    ) -> Result<usize, StockError> {
        let side = cells.head().side;
        let at = cells.head().cell_at([eye.x, eye.y]);
        if self.window.follow(at) != [0, 0] {
            let window = self.window;
            self.slots.iter_mut().for_each(|slot| {
                slot.take_if(|stocked| !window.contains(stocked.cell.index));
            });
        }
        let (mut loaded, mut early) = (0, 0);
        for index in self.window.cells_from(at) {
            let is_seen = self.window.is_within_horizon(at, index) && distance_to_cell(index, side, eye) < self.horizon;
            if !cells.contains(index) || self.at(index).is_some() || (!is_seen && early >= self.prefetch) {
                continue;
            }
            if let Some(cell) = cells.load(index)? {
                let slot = self.slot(index);
                self.slots[slot] = Some(Stocked::new(cells, cell, self.year, terrain, pictures)?);
                loaded += 1;
                early += usize::from(!is_seen);
            }
        }
        Ok(loaded)
    }

    /// A cell, if it is loaded.
    #[must_use]
    pub fn at(&self, index: CellIndex) -> Option<&Stocked> {
        self.slots[self.slot(index)].as_ref().filter(|stocked| stocked.cell.index == index)
    }

    /// All that are loaded.
    pub fn cells(&self) -> impl Iterator<Item = &Stocked> {
        self.slots.iter().flatten()
    }

    /// Bytes of memory.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.cells().map(Stocked::bytes).sum()
    }

    fn slot(&self, index: CellIndex) -> usize {
        let side = self.window.side();
        let [column, row] = index.map(|index| index.rem_euclid(side as i32) as usize);
        column * side + row
    }
}
