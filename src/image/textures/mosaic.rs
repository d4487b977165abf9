//! Mosaic: many pictures over one surface, each place saying which one it shows.
//!
//! raster of numbers over (u, v) -MOSAIC-> number of a tile, and the place in its picture
//!
//! Why: a cell of a map has fields, meadows and roads; cutting its ground along their borders makes polygons that follow two
//! things at once, relief and land. A number looked up at every sample cuts nothing.
//!
//! Numbers are never mixed: between field 3 and field 5 there is no field 4. So borders are as fine as the raster.
//!
//! Space: (u, v) from 0 to 1 over the raster, v upward; a tile repeats a whole or fractional number of times over it.
//! Cost: one number a sample more than a picture.

use super::filter::Wrap;
use super::{FirstRow, MOST_TEXELS, Texels};
use std::sync::Arc;

/// A raster of numbers, and the pictures they mean.
#[derive(Clone, PartialEq)]
pub struct Mosaic {
    width: u32,
    height: u32,
    /// Rows from the lowest, v = 0; each below the number of tiles.
    ids: Vec<u8>,
    tiles: Vec<Tile>,
}

/// One picture of a mosaic; it begins again beyond its edges.
#[derive(Clone, Debug, PartialEq)]
pub struct Tile {
    /// The picture.
    pub texels: Arc<Texels>,
    /// How often it stands side by side over the raster, to the right and up.
    pub repeat: [f64; 2],
}

impl Mosaic {
    /// `width` x `height` numbers of `tiles`, row by row. `None` where that is not how many there are, there is none, there are more
    /// than [`MOST_TEXELS`], one is no tile, there are more than 256 tiles, or some `repeat` is not finite.
    #[must_use]
    pub fn new((width, height): (u32, u32), mut ids: Vec<u8>, first: FirstRow, tiles: Vec<Tile>) -> Option<Mosaic> {
        let count = u64::from(width) * u64::from(height);
        let is_legal = count > 0 && count <= MOST_TEXELS && ids.len() as u64 == count;
        let are_tiles = tiles.len() <= 256 && ids.iter().all(|&id| usize::from(id) < tiles.len());
        let are_finite = tiles.iter().all(|tile| tile.repeat.iter().all(|repeat| repeat.is_finite()));
        if !(is_legal && are_tiles && are_finite) {
            return None;
        }
        if first == FirstRow::Top {
            ids = ids.chunks_exact(width as usize).rev().flatten().copied().collect();
        }
        Some(Mosaic { width, height, ids, tiles })
    }

    /// Numbers across and up.
    #[must_use]
    pub fn size(&self) -> (u32, u32) {
        (self.width, self.height)
    }

    /// The numbers, row by row from the lowest.
    #[must_use]
    pub fn ids(&self) -> &[u8] {
        &self.ids
    }

    /// The pictures; at least one.
    #[must_use]
    pub fn tiles(&self) -> &[Tile] {
        &self.tiles
    }

    /// The number of the tile at `place`, and the place in its picture.
    #[must_use]
    #[inline]
    pub fn at(&self, place: [f64; 2], wrap: Wrap) -> (usize, [f64; 2]) {
        let id = usize::from(self.ids[wrap.cell(place, self.size())]);
        let repeat = self.tiles[id].repeat;
        (id, [place[0] * repeat[0], place[1] * repeat[1]])
    }
}

impl std::fmt::Debug for Mosaic {
    /// Without the numbers.
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(formatter, "Mosaic({} x {} of {} tiles)", self.width, self.height, self.tiles.len())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tile(repeat: [f64; 2]) -> Tile {
        let texels = Texels::new(1, 1, vec![[9; 4]], FirstRow::Top).expect("a texel");
        Tile { texels: Arc::new(texels), repeat }
    }

    #[test]
    fn every_place_has_its_tile() {
        let tiles = vec![tile([1.0, 1.0]), tile([4.0, 8.0]), tile([0.5, 3.0])];
        let mosaic = Mosaic::new((3, 2), vec![0, 1, 2, 2, 1, 0], FirstRow::Top, tiles).expect("legal");
        assert_eq!(mosaic.ids(), [2, 1, 0, 0, 1, 2], "the lowest row first");
        for (place, wrap, expected) in [
            ([0.1, 0.1], Wrap::Clamp, (2, [0.05, 0.1 * 3.0])),
            ([0.34, 0.9], Wrap::Clamp, (1, [0.34 * 4.0, 0.9 * 8.0])),
            ([0.99, 0.49], Wrap::Clamp, (0, [0.99, 0.49])),
            // Beyond the edges the outermost numbers go on, or the raster begins again; places go on in any case.
            ([1.5, 0.75], Wrap::Clamp, (2, [0.75, 2.25])),
            ([1.5, 0.75], Wrap::Repeat, (1, [6.0, 6.0])),
            ([1.0, 1.0], Wrap::Clamp, (2, [0.5, 3.0])),
        ] {
            assert_eq!(mosaic.at(place, wrap), expected, "{place:?} {wrap:?}");
        }
        let _ = mosaic.at([f64::NAN, f64::INFINITY], Wrap::Repeat);
    }

    #[test]
    fn what_is_none() {
        let of = |size, ids: &[u8], repeat| Mosaic::new(size, ids.to_vec(), FirstRow::AtV0, vec![tile(repeat)]);
        assert!(of((2, 1), &[0, 0], [1.0; 2]).is_some());
        assert!(of((2, 1), &[0, 1], [1.0; 2]).is_none(), "no such tile");
        assert!(of((2, 2), &[0, 0], [1.0; 2]).is_none() && of((0, 1), &[], [1.0; 2]).is_none());
        assert!(of((1, 1), &[0], [1.0, f64::NAN]).is_none());
        assert!(Mosaic::new((1, 1), vec![0], FirstRow::Top, vec![]).is_none());
    }
}
