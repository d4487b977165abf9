//! Place: where every tree stands, and how tall it is, out of a few numbers a stand.
//!
//! Cell, year, ground -PLACE-> 8 bytes a tree -> window, detail -> quads
//!
//! Why out of nothing but numbers: an inventory knows 520 trees a hectare, 14 m high, give or take 2; it does not know the trees. Thirty million of them
//! would fill a disk, so they are made when their cell comes near, the same ones every time: each asks [`random`](super::random)
//! with the area's seed, its cell, its stand and its own number. Its size is not even kept: [`Sizes`] finds it again from its place.
//!
//! Three promises, each with a test: order and threads change no byte; a stand that is thinned keeps a part of its trees, and one that grows
//! denser keeps them all; no tree stands in two cells.
//!
//! Space: metres in the cell; densities in trees a hectare of the map's plane.
//! Source: A. Falcão, M. Próspero dos Santos, "Visualização de paisagens florestais" ([`Placement::Triangles`]); `docs/forest-growing.md`.
//! Cost: about as long a tree as a cache miss; `cargo run --release --example growing` prints it.

mod block;
mod rows;
mod site;
mod size;
#[cfg(test)]
mod tests;
mod triangles;

pub use size::{Size, Sizes, size_of};

use site::{Site, planted};

use super::area::{Cell, Ground, Head, Owner, StandState};
use super::land::Land;
use super::polygon;
use crate::math::Vec3;

/// A tree: where it stands, and what it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Tree {
    /// To the east, in 1/65,536 of the cell's side; the tree is in the middle of its step, so never on a border.
    pub x: u16,
    /// To the north, likewise.
    pub y: u16,
    /// Height of its foot over [`base_of`] its cell, in 1/16 m.
    pub z: i16,
    /// Bit 15: measured, the others are an index into [`Cell::trees`]. Else an index into [`Cell::stands`] times 16, plus its picture.
    pub kind: u16,
}

/// Bit of [`Tree::kind`]: somebody measured it.
const MEASURED: u16 = 1 << 15;
/// Pictures of a species that trees choose from, at most.
pub const MOST_PICTURES: u16 = 16;
/// Stands of a cell that can be told apart.
pub const MOST_STANDS: usize = 1 << 11;
/// The most trees of a cell.
pub const MOST_TREES: usize = 1 << 20;
/// The most trees a hectare of a stand.
const MOST_PER_HECTARE: f64 = 100_000.0;
/// Pictures that trees choose from where the species names none: as many as the program paints of each form.
pub const PAINTED: u16 = super::paint::VARIANTS as u16;

impl Tree {
    /// Where it stands in its cell of this side, in metres.
    #[must_use]
    #[inline]
    pub fn at(self, side: f64) -> [f64; 2] {
        [self.x, self.y].map(|steps| (f64::from(steps) + 0.5) * (side / 65_536.0))
    }

    /// Its stand: an index into [`Cell::stands`]. `None`: somebody measured it.
    #[must_use]
    #[inline]
    pub fn stand(self) -> Option<usize> {
        (self.kind & MEASURED == 0).then_some(usize::from(self.kind >> 4))
    }

    /// Which picture of its species it wears.
    #[must_use]
    #[inline]
    pub fn picture(self) -> u8 {
        if self.kind & MEASURED == 0 { (self.kind & 15) as u8 } else { 0 }
    }

    /// Its index in [`Cell::trees`] if somebody measured it.
    #[must_use]
    pub fn measured(self) -> Option<usize> {
        (self.kind & MEASURED != 0).then_some(usize::from(self.kind & !MEASURED))
    }

    /// Height of its foot in metres, in a cell with this base.
    #[must_use]
    #[inline]
    pub fn height_above_sea(self, base: f64) -> f64 {
        base + f64::from(self.z) / 16.0
    }
}

/// How places are found.
#[derive(Clone, Copy, Debug, Default)]
pub enum Placement<'a> {
    /// From the numbers of cell and stand alone: triangles of the relief may come and go, trees stay.
    #[default]
    Lattice,
    /// As the paper does: every triangle of the relief by itself, in a rectangle twice its size. Other triangles, other trees; [`Plant`](super::area::Plant) is not asked.
    /// Corners in the cell's metres, z in metres above the sea.
    Triangles(&'a [[Vec3; 3]]),
}

/// Why no trees grow in a cell.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PlaceError {
    /// More than [`MOST_TREES`], or a density beyond all woods.
    #[error("cell {} {} would have {trees:.0} trees, at most {MOST_TREES} are possible: lower the density of stand {stand}, or make cells smaller", cell[0], cell[1])]
    TooManyTrees {
        /// Which cell.
        cell: [i32; 2],
        /// The number of the stand that has most of them.
        stand: u32,
        /// How many there would be.
        trees: f64,
    },
    /// More than [`MOST_STANDS`] stands or 32,768 measured trees.
    #[error("cell {} {} has {count} {what}, at most {most} are possible: make cells smaller", cell[0], cell[1])]
    TooMany {
        /// Which cell.
        cell: [i32; 2],
        /// `stands` or `measured trees`.
        what: &'static str,
        /// How many it has.
        count: usize,
        /// How many it may have.
        most: usize,
    },
}

/// The height from which [`Tree::z`] counts: whole metres, in the middle between the lowest and the highest ground of the cell.
#[must_use]
pub fn base_of(cell: &Cell) -> f64 {
    let mut range = (f64::INFINITY, f64::NEG_INFINITY);
    let mut add = |z: f64| {
        if z.is_finite() {
            range = (range.0.min(z), range.1.max(z));
        }
    };
    match &cell.ground {
        Ground::Lattice { base, step, counts, .. } => {
            counts
                .iter()
                .filter(|&&count| count != Ground::VOID)
                .for_each(|&count| add(base + step * f64::from(count)));
        }
        Ground::Mesh { vertices, .. } => vertices.iter().for_each(|vertex| add(vertex.z)),
    }
    if range.0 <= range.1 { (0.5 * (range.0 + range.1)).round() } else { 0.0 }
}

/// The trees of a cell in a year: those of its stands, then those that were measured.
///
/// `ground` is the height of the ground *as it is drawn* over a position in the cell, metres above the sea; where it is not a number nothing grows.
///
/// # Errors
/// More trees or stands than fit ([`PlaceError`]); nothing is grown then.
pub fn grow(
    head: &Head,
    cell: &Cell,
    year: Option<i32>,
    placement: Placement,
    ground: &dyn Fn([f64; 2]) -> f64,
) -> Result<Vec<Tree>, PlaceError> {
    check(head, cell, year)?;
    let land = Land::new(cell, head.side);
    let states: Vec<Option<&StandState>> = cell.stands.iter().map(|stand| stand.in_year(year)).collect();
    let pictures = |state: &&StandState| match head
        .species
        .get(usize::from(state.species))
        .map_or(0, |species| species.images.len())
    {
        0 => PAINTED,
        count => (count as u64).min(u64::from(MOST_PICTURES)) as u16,
    };
    let pictures = states.iter().map(|state| state.as_ref().map_or(1, pictures)).collect();
    let mut site = Site { head, cell, land, states, pictures, ground, base: base_of(cell), trees: Vec::new() };
    match placement {
        Placement::Triangles(triangles) => triangles::grow(&mut site, triangles),
        Placement::Lattice => {
            block::grow(&mut site);
            rows::grow(&mut site);
        }
    }
    site.add_measured();
    if site.trees.len() > MOST_TREES {
        let stand = cell.stands.first().map_or(0, |stand| stand.number);
        return Err(PlaceError::TooManyTrees { cell: cell.index, stand, trees: site.trees.len() as f64 });
    }
    site.trees.shrink_to_fit();
    Ok(site.trees)
}

/// Refuses what would not fit, before growing it.
fn check(head: &Head, cell: &Cell, year: Option<i32>) -> Result<(), PlaceError> {
    for (what, count, most) in
        [("stands", cell.stands.len(), MOST_STANDS), ("measured trees", cell.trees.len(), usize::from(MEASURED))]
    {
        if count > most {
            return Err(PlaceError::TooMany { cell: cell.index, what, count, most });
        }
    }
    let hectares = head.side * head.side / 1e4;
    let mut expected = vec![0.0; cell.stands.len()];
    for patch in &cell.patches {
        let Owner::Stand(stand) = patch.owner else { continue };
        let Some(state) = cell.stands.get(stand as usize).and_then(|stand| stand.in_year(year)) else { continue };
        let land = (polygon::area(&patch.outer).abs() / 1e4).min(hectares);
        // A density that is not a number, or beyond all woods, counts for the whole cell.
        let grows = if state.density <= MOST_PER_HECTARE { land * state.density } else { state.density.max(f64::MAX) };
        expected[stand as usize] += grows;
    }
    let trees: f64 = expected.iter().sum::<f64>() + cell.trees.len() as f64;
    if trees <= MOST_TREES as f64 {
        return Ok(());
    }
    let most = expected.iter().enumerate().max_by(|a, b| a.1.total_cmp(b.1)).map_or(0, |(index, _)| index);
    let stand = cell.stands.get(most).map_or(0, |stand| stand.number);
    let trees = if trees < f64::MAX {
        trees
    } else {
        cell.stands.get(most).and_then(|stand| stand.in_year(year)).map_or(trees, |state| state.density * hectares)
    };
    Err(PlaceError::TooManyTrees { cell: cell.index, stand, trees })
}

#[cfg(test)]
pub(super) use tests::fixture;
