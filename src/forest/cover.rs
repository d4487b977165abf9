//! Cover: which ground lies where in a cell, as a small picture of numbers.
//!
//! Cell, year -COVER-> numbers of covers -> which ground picture a fragment shows
//!
//! Why a picture of numbers: triangles of the relief come and go with the distance, borders of stands must not. A texel is the ground at its
//! center, exactly: the half-open rule of [`polygon`](super::polygon), so two neighbors leave no gap.
//!
//! Space: texels; rows from the south, columns from the west; texel (i, j) has its center at ((i + 0.5), (j + 0.5)) times the cell's side over theirs.
//! Cost: a few operations a run of texels.

use super::area::{Cell, Ground, Head, Owner};
use super::land::{fill, rings};

/// The ground at the centers of `side` x `side` texels: index into [`Head::covers`] plus 1, or 0 for none. Rows from the south.
///
/// Where patches overlap the later one counts; a stand without a ground of its own has the cell's. Triangles with a ground
/// ([`Ground::Mesh`]) lie below all patches.
#[must_use]
pub fn raster(head: &Head, cell: &Cell, year: Option<i32>, side: usize) -> Vec<u8> {
    let plain = cell.cover.map_or(0, number);
    let mut numbers = vec![plain; side * side];
    let mut paint = |rings: &mut dyn Iterator<Item = &[[f64; 2]]>, number: u8| {
        fill(rings, head.side, side, |row, columns| numbers[row * side..][columns].fill(number));
    };
    if let Ground::Mesh { vertices, triangles } = &cell.ground {
        for (corners, cover) in triangles {
            let corner = |index: u32| vertices.get(index as usize).map_or([0.0; 2], |v| [v.x, v.y]);
            if let Some(cover) = cover {
                paint(&mut std::iter::once(corners.map(corner).as_slice()), number(*cover));
            }
        }
    }
    for patch in &cell.patches {
        let ground = match patch.owner {
            Owner::Cover(cover) => number(cover),
            Owner::Stand(stand) => {
                let state = cell.stands.get(stand as usize).and_then(|stand| stand.in_year(year));
                state.and_then(|state| state.cover).map_or(plain, number)
            }
        };
        paint(&mut rings(patch), ground);
    }
    numbers
}

/// The number of a cover; 255, which no head has, would not fit and is 255.
fn number(cover: u8) -> u8 {
    cover.saturating_add(1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::forest::land::{Land, center_of};
    use crate::forest::place::fixture;
    use crate::forest::polygon::contains;

    #[test]
    fn every_texel_is_the_ground_at_its_center() {
        let (head, cell) = fixture();
        // 120: centers on whole odd metres, where the outlines of the fixture have corners.
        for side in [7, 32, 120] {
            let numbers = raster(&head, &cell, None, side);
            for (index, number) in numbers.iter().enumerate() {
                let at = [index % side, index / side].map(|index| center_of(index, head.side, side));
                let inside = |patch: &&crate::forest::area::Patch| contains(&patch.outer, &patch.holes, at);
                let expected = match cell.patches.iter().rev().find(inside).map(|patch| patch.owner) {
                    None => 1,
                    Some(Owner::Cover(cover)) => cover + 1,
                    Some(Owner::Stand(stand)) => {
                        cell.stands[stand as usize].states[0].cover.map_or(1, |cover| cover + 1)
                    }
                };
                assert_eq!(*number, expected, "{at:?} of {side}");
            }
        }
    }

    #[test]
    fn squares_change_no_answer() {
        let (head, cell) = fixture();
        let land = Land::new(&cell, head.side);
        for index in 0..20_000_usize {
            let at = [index * 7919 % 4801, index * 104_729 % 4799].map(|number| number as f64 / 20.0);
            let expected = cell.patches.iter().rposition(|patch| contains(&patch.outer, &patch.holes, at));
            assert_eq!(land.patch_at(at), expected, "{at:?}");
        }
    }
}
