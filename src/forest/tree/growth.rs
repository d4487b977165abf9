//! Growth: the trees of a cell, with all that is needed to make objects of them.
//!
//! Cell -place::grow, Sizes-> GROWTH -> quads, pictures

use super::TreeError;
use super::ground::Land;
use crate::forest::area::{Cell, Head, Owner};
use crate::forest::place::{Placement, Sizes, grow};
use crate::forest::polygon::area;
use crate::math::Vec3;
use crate::scene::Place;

/// A tree where it stands.
#[derive(Clone, Copy, Debug)]
pub(super) struct Standing {
    /// The number of its stand; `None`: somebody measured it.
    pub stand: Option<u32>,
    /// Index into [`Head::species`].
    pub species: u16,
    /// Which picture of the species.
    pub picture: u8,
    /// Its foot, in the cell.
    pub foot: Vec3,
    /// In metres.
    pub height: f64,
    /// In metres.
    pub crown: f64,
    /// Degrees counterclockwise.
    pub turn: f64,
    /// Its stand, or the tree, in the file.
    pub place: Place,
}

/// About how many trees a cell has: land times density, overlaps counted twice.
pub(super) fn expected(cell: &Cell, year: Option<i32>) -> f64 {
    let of_patch = |owner: Owner| match owner {
        Owner::Stand(stand) => cell.stands.get(stand as usize).and_then(|stand| stand.in_year(year)),
        Owner::Cover(_) => None,
    };
    let trees = cell.patches.iter().filter_map(|patch| {
        let state = of_patch(patch.owner)?;
        let holes: f64 = patch.holes.iter().map(|hole| area(hole).abs()).sum();
        Some((area(&patch.outer).abs() - holes) / 10_000.0 * state.density)
    });
    trees.sum::<f64>() + cell.trees.len() as f64
}

/// The trees of a cell on the drawn ground.
///
/// # Errors
/// The cell has too many.
pub(super) fn trees(head: &Head, cell: &Cell, year: Option<i32>, land: &Land<'_>) -> Result<Vec<Standing>, TreeError> {
    let ground = |at: [f64; 2]| land.height_in(cell, at).unwrap_or(f64::NAN);
    let grown = grow(head, cell, year, Placement::Lattice, &ground);
    let grown = grown.map_err(|error| TreeError::Growth(error.to_string()))?;
    let sizes = Sizes::new(head, cell, year);
    let standing = grown.into_iter().filter_map(|tree| {
        let size = sizes.of(tree);
        let stand = tree.stand().and_then(|stand| cell.stands.get(stand));
        let measured = tree.measured().and_then(|index| cell.trees.get(index));
        // The 16ths of a metre of a stored tree are for forests of millions; here the ground itself is asked.
        let [x, y] = measured.map_or(tree.at(head.side), |tree| tree.at);
        let foot = Vec3::new(x, y, land.height_in(cell, [x, y])?);
        let place = measured.map(|tree| tree.place).or(stand.map(|stand| stand.place)).unwrap_or_default();
        Some(Standing {
            stand: stand.map(|stand| stand.number),
            species: size.species,
            picture: tree.picture(),
            foot,
            height: size.height,
            crown: size.crown,
            turn: size.turn,
            place,
        })
    });
    Ok(standing.collect())
}
