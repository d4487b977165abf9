//! Textures: pictures that are looked up by a place on them, smoothly and at any size.
//!
//! file, generator -> TEXELS (key, `repair`) -> PYRAMID (`mips`) -> SAMPLE (`filter`) -> screen/shader
//!
//! A picture seen from far away has many texels in a sample; taking one of them flickers, taking their mean costs. So their means
//! are kept beforehand, each level half as large as the one before (a *mip* pyramid), and a lookup says how many texels of level 0
//! its sample is wide.
//!
//! Why transparency makes it hard: a leaf's picture has a color where nothing is, and a plain mean mixes it in (a halo); and
//! the mean of a twig and much air is below any threshold (the twig vanishes). Both are repaired here, and left as they are in
//! [`Alpha::Paper`], to be looked at. `docs/textures.md` has the pictures.
//!
//! Space: u runs to the right, v upward, both 0 to 1 over the picture; texel (i, j) has its center at ((i + 0.5) / width,
//! (j + 0.5) / height), row 0 is the lowest. Colors of texels are display values, what lookups return is linear light.
//! Source: Williams, "Pyramidal Parametrics", SIGGRAPH 1983; Castano, "Computing Alpha Mipmaps", 2010.
//! Cost: 4 bytes a texel, and a third more for the pyramid.

mod file;
mod filter;
mod lookup;
mod mips;
mod mosaic;
mod repair;

pub use file::{MOST_TEXELS, TextureError, decode, encode_png, read};
pub use filter::{Filter, Sample, Wrap, level_of_detail};
pub use lookup::{Field, Lookup};
pub use mips::{Alpha, Pyramid};
pub use mosaic::{Mosaic, Tile};
pub use repair::{coverage, dilate};

/// Red, green, blue, alpha; 8 bits each, display values, not premultiplied. Alpha 255 hides, 0 is not there.
pub type Rgba = [u8; 4];

/// A picture with alpha, as a file holds it.
#[derive(Clone, PartialEq, Eq)]
pub struct Texels {
    width: u32,
    height: u32,
    /// Rows from the lowest, v = 0.
    rgba: Vec<Rgba>,
}

/// Which row of a picture comes first in memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FirstRow {
    /// The upper one, as in PNG files.
    Top,
    /// The one at v = 0.
    AtV0,
}

impl Texels {
    /// A picture of `width` x `height` texels, row by row. `None` where that is not their number, or there is none, or there
    /// are more than [`MOST_TEXELS`].
    #[must_use]
    pub fn new(width: u32, height: u32, mut rgba: Vec<Rgba>, first: FirstRow) -> Option<Texels> {
        let count = u64::from(width) * u64::from(height);
        if count == 0 || count > MOST_TEXELS || rgba.len() as u64 != count {
            return None;
        }
        if first == FirstRow::Top {
            rgba = rgba.chunks_exact(width as usize).rev().flatten().copied().collect();
        }
        Some(Texels { width, height, rgba })
    }

    /// Texels across and up.
    #[must_use]
    pub fn size(&self) -> (u32, u32) {
        (self.width, self.height)
    }

    /// All texels, row by row from the lowest.
    #[must_use]
    pub fn rgba(&self) -> &[Rgba] {
        &self.rgba
    }

    /// Texel (x, y), y from the lowest row.
    ///
    /// # Panics
    /// Outside the picture, as indexing does.
    #[must_use]
    pub fn at(&self, x: u32, y: u32) -> Rgba {
        self.rgba[y as usize * self.width as usize + x as usize]
    }

    /// The same picture, with alpha 0 wherever its color is `key`: how pictures without alpha say that nothing is there.
    #[must_use]
    pub fn keyed(mut self, key: [u8; 3]) -> Texels {
        for texel in &mut self.rgba {
            if texel[..3] == key {
                texel[3] = 0;
            }
        }
        self
    }

    /// Whether some texel lets something through.
    #[must_use]
    pub fn has_holes(&self) -> bool {
        self.rgba.iter().any(|texel| texel[3] < 255)
    }
}

impl std::fmt::Debug for Texels {
    /// Without the texels: a million of them is nothing to read.
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(formatter, "Texels({} x {})", self.width, self.height)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_turned_and_keys_make_holes() {
        let (red, black) = ([255, 0, 0, 255], [0, 0, 0, 255]);
        let upright = Texels::new(1, 2, vec![red, black], FirstRow::Top).expect("two texels");
        assert_eq!(upright.at(0, 0), black, "the lowest row is the last of a file");
        assert_eq!(Texels::new(1, 2, vec![black, red], FirstRow::AtV0), Some(upright.clone()));
        assert!(!upright.has_holes());
        let keyed = upright.keyed([0; 3]);
        assert_eq!((keyed.at(0, 0), keyed.at(0, 1)), ([0, 0, 0, 0], red));
        assert!(keyed.has_holes());
        assert!(
            Texels::new(2, 2, vec![red], FirstRow::Top).is_none() && Texels::new(0, 2, vec![], FirstRow::Top).is_none()
        );
    }
}
