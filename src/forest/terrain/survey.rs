//! Survey: every cell of an area is looked at once.
//!
//! Cells, year, Pictures -SURVEY-> Terrain
//!
//! Twice, to be exact: first for how finely heights are measured, then for the heights. Nothing of a cell is kept but its samples, a color
//! for each, how high it is and how tall its trees may become.
//!
//! Source: ours. Cost: about 60 us a cell, and half a microsecond a sample for the bounds.

use super::{Kind, MOST_FINE_SAMPLES, MOST_SAMPLES, Outline, Terrain};
use crate::color::Rgb;
use crate::forest::area::{Cell, CellIndex, Ground, Head, Owner};
use crate::forest::cells::Cells;
use crate::forest::cover::{Samples, at_samples};
use crate::forest::elevation::{Frame, Grid, Unit};
use crate::forest::land::Land;
use crate::forest::pack::PackError;
use crate::forest::pictures::Pictures;
use crate::forest::relief::borders::Borders;
use crate::forest::relief::criterion::Spheres;
use crate::forest::relief::lattice::{Field, Point};
use crate::forest::relief::{Hierarchy, Lattice};

/// Trees are at most this many deviations taller than the mean.
const TALLEST: f64 = 2.5;

/// Why an area cannot be surveyed.
#[derive(Debug, thiserror::Error)]
pub enum TerrainError {
    /// A cell cannot be read.
    #[error(transparent)]
    Pack(#[from] PackError),
    /// There is none.
    #[error("the area has no cell with heights: there is nothing to draw")]
    Empty,
    /// The rectangle around all cells has too many of them.
    #[error("the cells span {columns} x {rows} cells, at most {MOST_SAMPLES} together can be drawn: split the area")]
    TooLarge {
        /// Cells across.
        columns: u64,
        /// Cells up.
        rows: u64,
    },
    /// Borders between covers cannot be kept that exactly.
    #[error(
        "a cover tolerance of {tolerance} m wants more than {MOST_FINE_SAMPLES} samples; {least:.2} m can be kept, or a part of the area taken"
    )]
    TooFine {
        /// Metres asked for.
        tolerance: f64,
        /// Metres that can be kept.
        least: f64,
    },
}

impl Terrain {
    /// Looks at every cell of an area in a year.
    ///
    /// # Errors
    /// [`TerrainError`].
    pub fn new(cells: &Cells, year: Option<i32>, pictures: &Pictures) -> Result<Terrain, TerrainError> {
        Terrain::with_covers(cells, year, pictures, None)
    }

    /// As [`Terrain::new`]; with a tolerance in metres, above 0, nearby triangles wear one cover each, and no wrong cover is farther than that from
    /// a border between covers.
    ///
    /// # Errors
    /// [`TerrainError`].
    pub fn with_covers(
        cells: &Cells,
        year: Option<i32>,
        pictures: &Pictures,
        tolerance: Option<f64>,
    ) -> Result<Terrain, TerrainError> {
        let indices = cells.indices();
        let [corner, far] = cells.bounds().ok_or(TerrainError::Empty)?;
        let [columns, rows] = [0, 1].map(|axis| (i64::from(far[axis]) - i64::from(corner[axis]) + 1) as u64);
        let samples = |squares: u64| (columns * squares + 1).saturating_mul(rows * squares + 1);
        if columns.saturating_mul(rows) > MOST_SAMPLES as u64 || samples(1) > MOST_SAMPLES as u64 {
            return Err(TerrainError::TooLarge { columns, rows });
        }
        let mut squares = finest(cells, &indices)?;
        while samples(squares as u64) > MOST_SAMPLES as u64 {
            squares /= 2;
        }
        if let Some(tolerance) = tolerance {
            squares = finer(squares, cells.head().side, tolerance, samples)?;
        }
        let mut survey = Survey::new(cells.head(), corner, [columns as usize, rows as usize], squares);
        for index in indices {
            if let Some(cell) = cells.load(index)? {
                survey.add(&cell, year, pictures);
            }
        }
        let mut terrain = survey.finish().ok_or(TerrainError::Empty)?;
        if let Some(tolerance) = tolerance {
            let [width, height] = [terrain.grid.columns(), terrain.grid.rows()];
            let samples = Samples { corner: terrain.origin(), spacing: [terrain.step(); 2], size: [width, height] };
            let numbers = at_samples(cells, year, &samples)?;
            terrain.borders = Some((Borders::new(&terrain.grid, |x, y| numbers[y * width + x]), tolerance));
        }
        Ok(terrain)
    }
}

/// Squares along the side of a cell that keep a tolerance: half of it is a square's side, or all of it where that are too many samples.
fn finer(least: usize, side: f64, tolerance: f64, samples: impl Fn(u64) -> u64) -> Result<usize, TerrainError> {
    let can_be = |squares: usize| samples(squares as u64) <= MOST_FINE_SAMPLES as u64;
    let mut squares = least;
    while side / squares as f64 > tolerance / 2.0 && can_be(2 * squares) {
        squares *= 2;
    }
    let kept = side / squares as f64;
    if kept <= tolerance { Ok(squares) } else { Err(TerrainError::TooFine { tolerance, least: kept }) }
}

/// Squares along the side of the cell that is measured most finely, as a power of two.
fn finest(cells: &Cells, indices: &[CellIndex]) -> Result<usize, TerrainError> {
    let mut most = 8;
    for &index in indices {
        if let Some(Cell { ground: Ground::Lattice { size, .. }, .. }) = cells.load(index)? {
            most = most.max(usize::from(size[0].max(size[1])) - 1);
        }
    }
    Ok(most.next_power_of_two().min(1 << 10))
}

/// A terrain that is being made.
struct Survey<'a> {
    head: &'a Head,
    corner: CellIndex,
    size: [usize; 2],
    squares: usize,
    heights: Vec<f32>,
    colors: Vec<u16>,
    outlines: Vec<Outline>,
}

impl<'a> Survey<'a> {
    fn new(head: &'a Head, corner: CellIndex, size: [usize; 2], squares: usize) -> Survey<'a> {
        let count = (size[0] * squares + 1) * (size[1] * squares + 1);
        let (heights, colors) = (vec![f32::NAN; count], vec![packed(Rgb::gray(0.5)); count]);
        let outlines = vec![Outline::default(); size[0] * size[1]];
        Survey { head, corner, size, squares, heights, colors, outlines }
    }

    fn add(&mut self, cell: &Cell, year: Option<i32>, pictures: &Pictures) {
        let [column, row] = [0, 1].map(|axis| (cell.index[axis] - self.corner[axis]) as usize);
        let (n, columns) = (self.squares, self.size[0] * self.squares + 1);
        let (first, north) = (column * n, (self.size[1] - 1 - row) * n);
        let mut outline = Outline { ground: [f32::INFINITY, f32::NEG_INFINITY], ..Outline::default() };
        outline.quarters = [f32::INFINITY; 4];
        for (i, j) in (0..=n).flat_map(|j| (0..=n).map(move |i| (i, j))) {
            let height = sample(cell, self.head.side, (i, j), n) as f32;
            if !height.is_finite() {
                continue;
            }
            self.heights[(north + j) * columns + first + i] = height;
            outline.ground = [outline.ground[0].min(height), outline.ground[1].max(height)];
            // A sample on the middle belongs to both halves.
            let (west, east, upper, lower) = (2 * i <= n, 2 * i >= n, 2 * j <= n, 2 * j >= n);
            for (quarter, is_in) in [lower && west, lower && east, upper && west, upper && east].into_iter().enumerate()
            {
                if is_in {
                    outline.quarters[quarter] = outline.quarters[quarter].min(height);
                }
            }
        }
        if outline.ground[0] > outline.ground[1] {
            return;
        }
        outline.kind = if matches!(cell.ground, Ground::Mesh { .. }) { Kind::Mesh } else { Kind::Lattice };
        outline.tallest = tallest(cell, year) as f32;
        outline.quarters = outline.quarters.map(|low| if low.is_finite() { low } else { outline.ground[0] });
        self.outlines[column * self.size[1] + row] = outline;
        self.color(cell, year, pictures, (first, north));
    }

    /// Every square gives its north-west sample its color; the samples on the far borders of the area keep their neighbor's.
    fn color(&mut self, cell: &Cell, year: Option<i32>, pictures: &Pictures, (first, north): (usize, usize)) {
        let (n, columns) = (self.squares, self.size[0] * self.squares + 1);
        let land = Land::new(cell, self.head.side);
        let looks: Vec<Rgb> =
            cell.patches.iter().map(|patch| look(self.head, cell, year, pictures, patch.owner)).collect();
        let plain = ground_color(pictures, cell.cover);
        for (i, j) in (0..=n).flat_map(|j| (0..=n).map(move |i| (i, j))) {
            let at = [(i.min(n - 1) as f64 + 0.5) / n as f64, 1.0 - (j.min(n - 1) as f64 + 0.5) / n as f64];
            let patch = land.patch_at(at.map(|share| share * self.head.side));
            self.colors[(north + j) * columns + first + i] = packed(patch.map_or(plain, |patch| looks[patch]));
        }
    }

    fn finish(mut self) -> Option<Terrain> {
        let (columns, rows) = (self.size[0] * self.squares + 1, self.size[1] * self.squares + 1);
        let filled = self.filled_samples();
        fill(&mut self.heights, columns);
        let step = self.head.side / self.squares as f64;
        let [west, south] = self.corner.map(|index| f64::from(index) * self.head.side);
        let frame = Frame { unit: Unit::Metres, west, north: south + step * (rows - 1) as f64, step: [step, step] };
        let grid = Grid::new("area", (columns, rows), self.heights, frame).ok()?;
        if grid.voids() > 0 {
            return None;
        }
        let hierarchy = Hierarchy::new(&grid);
        let radii = Spheres::new(&hierarchy).into_radii();
        let (lattice, bounds) = (hierarchy.lattice, hierarchy.into_bounds());
        let Survey { corner, size, squares, colors, outlines, .. } = self;
        let side = self.head.side;
        let mut terrain = Terrain {
            side,
            corner,
            size,
            squares,
            grid,
            lattice,
            bounds,
            radii,
            outlines,
            colors,
            filled,
            borders: None,
        };
        terrain.cut_at_voids();
        Some(terrain)
    }

    /// Samples in cells that are there, without a height.
    fn filled_samples(&self) -> usize {
        let (n, columns) = (self.squares, self.size[0] * self.squares + 1);
        let is_there = |index: &usize| {
            let (column, row) = (index % columns, index / columns);
            let (column, north) = ((column / n).min(self.size[0] - 1), (row / n).min(self.size[1] - 1));
            self.outlines[column * self.size[1] + self.size[1] - 1 - north].kind != Kind::Missing
        };
        (0..self.heights.len()).filter(|&index| self.heights[index].is_nan()).filter(is_there).count()
    }
}

impl Terrain {
    /// Diamonds with a triangle over both cells that are there and cells that are not are never whole.
    fn cut_at_voids(&mut self) {
        if self.outlines.iter().all(|outline| outline.kind == Kind::Lattice) {
            return;
        }
        let lattice = self.lattice;
        let mut bounds = std::mem::replace(&mut self.bounds, Field::new(&Lattice { side: 1, east: 0, south: 0 }, 0.0));
        let sums = self.sums();
        lattice.from_the_smallest(|middle| {
            let own =
                lattice.triangles(middle).any(|triangle| self.is_mixed(&sums, [triangle.a, triangle.b, triangle.apex]));
            let below = lattice.children(middle).any(|child| bounds.at(child) == f32::INFINITY);
            if own || below {
                bounds.set(middle, f32::INFINITY);
            }
        });
        self.bounds = bounds;
    }

    /// Whether the box around some points has cells of different kinds.
    fn is_mixed(&self, sums: &[[u32; 2]], points: [Point; 3]) -> bool {
        let [west, east] = self.span(points.map(|point| point.x), self.size[0]);
        let [north, south] = self.span(points.map(|point| point.y), self.size[1]);
        let at = |column: usize, row: usize| sums[column * (self.size[1] + 1) + row];
        let count = |kind: usize| {
            (at(east, south)[kind] + at(west, north)[kind]) - (at(west, south)[kind] + at(east, north)[kind])
        };
        let all = ((east - west) * (south - north)) as u32;
        (0..2).any(|kind| !(count(kind) == 0 || count(kind) == all))
    }

    /// The cells, first and behind the last, that samples span.
    pub(super) fn span(&self, samples: [u32; 3], cells: usize) -> [usize; 2] {
        let [a, b, c] = samples.map(|sample| sample as usize);
        let first = (a.min(b).min(c) / self.squares).min(cells - 1);
        [first, a.max(b).max(c).div_ceil(self.squares).clamp(first + 1, cells)]
    }

    /// How many lattices and meshes are west and north of each corner of a cell; rows from the north.
    fn sums(&self) -> Vec<[u32; 2]> {
        let rows = self.size[1] + 1;
        let mut sums = vec![[0; 2]; (self.size[0] + 1) * rows];
        for (column, row) in (0..self.size[0]).flat_map(|column| (0..self.size[1]).map(move |row| (column, row))) {
            let kind = self.outlines[column * self.size[1] + self.size[1] - 1 - row].kind;
            for (number, is_it) in [kind == Kind::Lattice, kind == Kind::Mesh].into_iter().enumerate() {
                let at = |column: usize, row: usize| sums[column * rows + row][number];
                let sum = at(column + 1, row) + at(column, row + 1) - at(column, row) + u32::from(is_it);
                sums[(column + 1) * rows + row + 1][number] = sum;
            }
        }
        sums
    }
}

/// Height of a cell at sample (i, j) of n + 1 each way, j from the north; not a number where nothing was measured.
fn sample(cell: &Cell, side: f64, (i, j): (usize, usize), n: usize) -> f64 {
    let share = [i, j].map(|index| index as f64 / n as f64);
    let Ground::Lattice { size, .. } = &cell.ground else {
        return match &cell.ground {
            Ground::Mesh { vertices, triangles } => {
                super::height_on_mesh(vertices, triangles, [share[0] * side, (1.0 - share[1]) * side])
            }
            Ground::Lattice { .. } => f64::NAN,
        };
    };
    let [x, y] = [0, 1].map(|axis| share[axis] * f64::from(size[axis].max(2) - 1));
    let [column, row] = [x, y].map(|place| place as usize);
    let along = |row: usize| {
        mixed(x - column as f64, || cell.ground.sample(column, row), || cell.ground.sample(column + 1, row))
    };
    mixed(y - row as f64, || along(row), || along(row + 1))
}

/// `low` alone where the share of `high` is 0: neighbors ask for the samples on their border and no others, and get the same bits.
fn mixed(share: f64, low: impl Fn() -> f64, high: impl Fn() -> f64) -> f64 {
    if share == 0.0 { low() } else { low() + (high() - low()) * share }
}

/// Metres of the tallest tree that may grow in a cell.
fn tallest(cell: &Cell, year: Option<i32>) -> f64 {
    let states = cell.stands.iter().filter_map(|stand| stand.in_year(year));
    let grown = states.map(|state| state.height.mean + TALLEST * state.height.deviation);
    grown.chain(cell.trees.iter().map(|tree| tree.height)).fold(0.0, f64::max)
}

fn ground_color(pictures: &Pictures, cover: Option<u8>) -> Rgb {
    let number = cover.map_or(0, |cover| usize::from(cover) + 1);
    pictures.grounds.get(number).map_or(Rgb::gray(0.5), |ground| ground.color)
}

/// What a patch looks like from afar: its ground, as far as crowns leave it open.
fn look(head: &Head, cell: &Cell, year: Option<i32>, pictures: &Pictures, owner: Owner) -> Rgb {
    let stand = match owner {
        Owner::Cover(cover) => return ground_color(pictures, Some(cover)),
        Owner::Stand(stand) => cell.stands.get(stand as usize).and_then(|stand| stand.in_year(year)),
    };
    let Some(state) = stand else { return ground_color(pictures, cell.cover) };
    let ground = ground_color(pictures, state.cover.or(cell.cover));
    debug_assert!(pictures.trees.len() == head.species.len());
    let Some(tree) = pictures.tree(state.species, 0) else { return ground };
    let crown = state.crown.mean;
    let layers = state.density / 1e4 * crown * crown * std::f64::consts::FRAC_PI_4;
    let closed = 1.0 - crate::math::exp(-layers);
    let mix = |ground: f64, tree: f64| ground + (tree - ground) * closed;
    Rgb::new(mix(ground.r, tree.color.r), mix(ground.g, tree.color.g), mix(ground.b, tree.color.b))
}

fn packed(color: Rgb) -> u16 {
    let level = |value: f64, most: f64| (value.clamp(0.0, 1.0) * most).round() as u16;
    level(color.r, 31.0) << 11 | level(color.g, 63.0) << 5 | level(color.b, 31.0)
}

/// Gives voids the height of the nearest sample to the west in their row, else to the east; rows of voids that of the nearest row.
fn fill(heights: &mut [f32], columns: usize) {
    for row in heights.chunks_exact_mut(columns) {
        spread(row.iter_mut());
        spread(row.iter_mut().rev());
    }
    for column in 0..columns {
        spread(heights.iter_mut().skip(column).step_by(columns));
        spread(heights.iter_mut().skip(column).step_by(columns).rev());
    }
}

fn spread<'a>(heights: impl Iterator<Item = &'a mut f32>) {
    let mut last = f32::NAN;
    for height in heights {
        if height.is_nan() {
            *height = last;
        }
        last = *height;
    }
}
