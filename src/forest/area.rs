//! Area: land cut into square cells, and what grows on it.
//!
//! `.fcell` text -parse::fcell-> AREA -pack-> `.fpack` -window-> the cells around the observer -> trees, ground -> Scene
//!
//! Why cells: 95,000 ha hold thirty million trees, and nobody sees more than a few hundred cells at a time. A cell says all that
//! is needed to draw it, so cells are loaded and dropped without asking their neighbors. Trees are not in it: they grow out of the stands
//! and of the numbers of the cell, the same ones whenever and in whatever order cells are loaded.
//!
//! Space: metres. A cell's own positions run from 0 to the side of the cell, x to the east, y to the north, from its south-west corner.
//! World positions are counted from the south-west corner of cell (0, 0), in `f64`: the origin in the map's projection (4,000 km north of
//! the equator, say) is only added where somebody asks for it.
//! Source: A. Falcão, M. Próspero dos Santos, "Visualização de paisagens florestais"; the fields of a stand are those of forest inventories.

use super::objects::Standing;
use crate::math::Vec3;
use crate::scene::Place;
use std::collections::BTreeMap;

/// Column and row of a cell: cell (0, 0) has its south-west corner at the origin; rows run north.
pub type CellIndex = [i32; 2];

/// The most trees a hectare that a stand may have: seedlings on a bed.
pub const MOST_DENSITY: f64 = 20_000.0;
/// The least height, crown or width of anything, in metres.
pub const SMALLEST: f64 = 0.01;

/// Everything about an area that is not in one cell.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Head {
    /// Names of the files it came from; [`Place::file`] points here.
    pub files: Vec<String>,
    /// The map projection, as written: `EPSG:32629`. Empty: not said.
    pub crs: String,
    /// South-west corner of cell (0, 0) in that projection: metres east and north.
    pub origin: [f64; 2],
    /// Side of every cell.
    pub side: f64,
    /// Every random number of the area begins here.
    pub seed: u64,
    /// Kinds of trees; [`StandState::species`] points here.
    pub species: Vec<Species>,
    /// Kinds of ground; [`Owner::Cover`] and others point here. At most 255.
    pub covers: Vec<Cover>,
    /// Named places.
    pub marks: Vec<Mark>,
    /// Scenes that stand on the land.
    pub objects: Vec<Standing>,
}

/// An area that is all in memory.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Area {
    /// What belongs to no single cell.
    pub head: Head,
    /// The cells, by column and row. Not every place has one.
    pub cells: BTreeMap<CellIndex, Cell>,
}

/// A kind of tree.
#[derive(Clone, Debug, PartialEq)]
pub struct Species {
    /// What stands call it: `PINPN`.
    pub code: String,
    /// What it looks like where there is no picture.
    pub form: Form,
    /// Pictures of it, relative to the file that names them; a tree wears one of them. None: the program paints some.
    pub images: Vec<String>,
    /// Where it was declared.
    pub place: Place,
}

/// How a tree is built; decides what the program paints.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Form {
    /// A narrow cone: spruce, young pine.
    #[default]
    Conifer,
    /// A round crown on a stem: oak.
    Broadleaf,
    /// A flat crown on a bare stem: stone pine.
    Umbrella,
    /// A high thin crown on a high stem: eucalyptus.
    Column,
    /// A crown from the ground: heather, young growth.
    Shrub,
}

impl Form {
    /// All forms, by the word in a file.
    pub const ALL: [(&'static str, Form); 5] = [
        ("conifer", Form::Conifer),
        ("broadleaf", Form::Broadleaf),
        ("umbrella", Form::Umbrella),
        ("column", Form::Column),
        ("shrub", Form::Shrub),
    ];
}

/// A kind of ground.
#[derive(Clone, Debug, PartialEq)]
pub struct Cover {
    /// Its number in the file.
    pub number: u32,
    /// Its picture, relative to the file that names it; or `paint:NAME`: the program paints it.
    pub image: String,
    /// Metres of ground that the picture covers each way before it repeats.
    pub tile: f64,
    /// Where it was declared.
    pub place: Place,
}

/// A square of land.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    /// Where it is.
    pub index: CellIndex,
    /// Its own part of every random number.
    pub seed: u64,
    /// The ground where no patch says otherwise: index into [`Head::covers`]; `None`: plain.
    pub cover: Option<u8>,
    /// Its heights.
    pub ground: Ground,
    /// What grows in it; [`Owner::Stand`] points here.
    pub stands: Vec<Stand>,
    /// Which land belongs to which stand or cover. Where two overlap, the later one counts.
    pub patches: Vec<Patch>,
    /// Trees that somebody measured, one by one.
    pub trees: Vec<MeasuredTree>,
    /// Roads and rivers.
    pub lines: Vec<Line>,
    /// Where it was declared.
    pub place: Place,
}

/// The heights of a cell, in metres.
#[derive(Clone, Debug, PartialEq)]
pub enum Ground {
    /// Samples on a lattice that begins and ends on the borders of the cell, rows from the north, each from the west.
    Lattice {
        /// Columns and rows; at least 2 each.
        size: [u16; 2],
        /// Height of count 0.
        base: f64,
        /// Metres of one count; above 0.
        step: f64,
        /// [`Ground::VOID`] where nothing was measured.
        counts: Vec<i16>,
    },
    /// Triangles as they are, each with its cover (index into [`Head::covers`]) or none.
    Mesh {
        /// x, y, z in the cell.
        vertices: Vec<Vec3>,
        /// Counterclockwise seen from above.
        triangles: Vec<([u32; 3], Option<u8>)>,
    },
}

impl Ground {
    /// The count of a void.
    pub const VOID: i16 = i16::MIN;

    /// The height of a lattice sample; not a number in a void, outside the lattice and on a mesh.
    #[must_use]
    pub fn sample(&self, column: usize, row: usize) -> f64 {
        let Ground::Lattice { size, base, step, counts } = self else { return f64::NAN };
        if column >= usize::from(size[0]) {
            return f64::NAN;
        }
        match counts.get(row * usize::from(size[0]) + column) {
            None | Some(&Ground::VOID) => f64::NAN,
            Some(&count) => base + step * f64::from(count),
        }
    }
}

/// Trees of one kind and age, as an inventory knows them.
#[derive(Clone, Debug, PartialEq)]
pub struct Stand {
    /// Its number in the file; stays with it over cells and years.
    pub number: u32,
    /// What it was or will be, by year; one at least. Years ascend; `None` (always) is alone.
    pub states: Vec<StandState>,
    /// Where it was declared first.
    pub place: Place,
}

/// A stand in one year.
#[derive(Clone, Debug, PartialEq)]
pub struct StandState {
    /// From this year on, until the next state.
    pub year: Option<i32>,
    /// Index into [`Head::species`].
    pub species: u16,
    /// Height of its trees in metres.
    pub height: Spread,
    /// Diameter of their crowns in metres.
    pub crown: Spread,
    /// Trees a hectare, of the map's plane.
    pub density: f64,
    /// Height of the lowest branches in metres.
    pub crown_base: Option<f64>,
    /// How they stand.
    pub plant: Plant,
    /// Which of the species' pictures; `None`: each tree its own.
    pub picture: Option<u8>,
    /// The ground below: index into [`Head::covers`]; `None`: the cell's.
    pub cover: Option<u8>,
}

/// A mean, and how far values are from it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spread {
    /// The mean.
    pub mean: f64,
    /// The standard deviation; 0 or more.
    pub deviation: f64,
}

/// How the trees of a stand are placed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Plant {
    /// Anywhere, each by itself.
    #[default]
    Poisson,
    /// One in each square of a lattice, somewhere in it: no two are on each other.
    Jittered,
    /// In rows.
    Rows,
}

impl Plant {
    /// All ways, by the word in a file.
    pub const ALL: [(&'static str, Plant); 3] =
        [("poisson", Plant::Poisson), ("jittered", Plant::Jittered), ("rows", Plant::Rows)];
}

/// Whose land a patch is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Owner {
    /// Index into [`Cell::stands`].
    Stand(u32),
    /// Index into [`Head::covers`]: a lake, a field.
    Cover(u8),
}

/// A polygon with holes, in the cell.
#[derive(Clone, Debug, PartialEq)]
pub struct Patch {
    /// Whose land it is.
    pub owner: Owner,
    /// Simple, at least 3 corners, counterclockwise.
    pub outer: Vec<[f64; 2]>,
    /// Simple, within `outer`, clockwise.
    pub holes: Vec<Vec<[f64; 2]>>,
    /// Where it was declared.
    pub place: Place,
}

/// A tree that somebody measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeasuredTree {
    /// Index into [`Head::species`].
    pub species: u16,
    /// Its foot, in the cell.
    pub at: [f64; 2],
    /// Height in metres.
    pub height: f64,
    /// Diameter of the crown in metres.
    pub crown: f64,
    /// Turned by this much, degrees counterclockwise seen from above.
    pub turn: f64,
    /// Where it was declared.
    pub place: Place,
}

/// A road or a river.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// What it is: `road`, `river`, `path`.
    pub kind: String,
    /// Metres.
    pub width: f64,
    /// At least 2, in the cell.
    pub points: Vec<[f64; 2]>,
    /// Where it was declared.
    pub place: Place,
}

/// A named place.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// As people call it.
    pub name: String,
    /// World position on the map, metres from the south-west corner of cell (0, 0).
    pub at: [f64; 2],
    /// Where it was declared.
    pub place: Place,
}

impl Stand {
    /// What it is in `year`: the last state that has begun by then, else the first. Without a year: the first.
    #[must_use]
    pub fn in_year(&self, year: Option<i32>) -> Option<&StandState> {
        let begun = |state: &&StandState| year.is_some_and(|year| state.year.is_some_and(|begin| begin <= year));
        self.states.iter().rev().find(begun).or(self.states.first())
    }
}

impl Head {
    /// The south-west corner of a cell, world space, height 0.
    #[must_use]
    pub fn corner(&self, index: CellIndex) -> Vec3 {
        Vec3::new(f64::from(index[0]) * self.side, f64::from(index[1]) * self.side, 0.0)
    }

    /// The cell over a world position; saturates far outside.
    #[must_use]
    pub fn cell_at(&self, position: [f64; 2]) -> CellIndex {
        position.map(|number| (number / self.side).floor() as i32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn state(year: Option<i32>, density: f64) -> StandState {
        let spread = Spread { mean: 10.0, deviation: 1.0 };
        StandState {
            year,
            species: 0,
            height: spread,
            crown: spread,
            density,
            crown_base: None,
            plant: Plant::Poisson,
            picture: None,
            cover: None,
        }
    }

    #[test]
    fn a_stand_is_what_it_has_become() {
        let states = vec![state(Some(2011), 1.0), state(Some(2018), 2.0), state(Some(2026), 3.0)];
        let stand = Stand { number: 12, states, place: Place::default() };
        let found = [None, Some(2000), Some(2011), Some(2017), Some(2018), Some(3000)]
            .map(|year| stand.in_year(year).map(|state| state.density));
        assert_eq!(found, [1.0, 1.0, 1.0, 1.0, 2.0, 3.0].map(Some));
    }

    #[test]
    fn borders_belong_to_the_cell_north_east_of_them() {
        let head = Head { side: 240.0, ..Head::default() };
        assert_eq!(head.cell_at([0.0, 239.9]), [0, 0]);
        assert_eq!(head.cell_at([240.0, -0.1]), [1, -1]);
        assert_eq!(head.corner([2, -1]), Vec3::new(480.0, -240.0, 0.0));
        assert_eq!(head.cell_at([f64::INFINITY, f64::NEG_INFINITY]), [i32::MAX, i32::MIN]);
    }

    #[test]
    fn lattices_know_their_voids() {
        let ground = Ground::Lattice { size: [2, 2], base: 400.0, step: 0.5, counts: vec![0, 2, Ground::VOID, -2] };
        assert_eq!([ground.sample(0, 0), ground.sample(1, 0), ground.sample(1, 1)], [400.0, 401.0, 399.0]);
        assert!(ground.sample(0, 1).is_nan() && ground.sample(2, 0).is_nan() && ground.sample(0, 2).is_nan());
    }
}
