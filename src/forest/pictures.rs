//! Pictures: what trees and grounds of an area look like, and which color they have from afar.
//!
//! Head, folder -PICTURES-> texels by species and cover -> frame
//!
//! Pictures that the area names are read, the others painted. Each is in memory once, however many cells show it.
//!
//! Space: texture space; mean colors are display values of mean light.

use super::area::{Head, Species};
use super::paint::{self, PaintError};
use crate::color::{Encoding, Rgb};
use crate::image::textures::{Texels, TextureError, read};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A picture and its mean.
#[derive(Clone, Debug, PartialEq)]
pub struct Painted {
    /// As it was read or painted.
    pub texels: Arc<Texels>,
    /// Mean light of what is there, as a display value.
    pub color: Rgb,
    /// How much of it is there, 0 to 1.
    pub share: f64,
}

/// The pictures of an area.
#[derive(Clone, Debug, PartialEq)]
pub struct Pictures {
    /// By species, at least one each.
    pub trees: Vec<Vec<Painted>>,
    /// Ground of no cover, then by cover, then road and river: what numbers of a cell's ground mean.
    pub grounds: Vec<Painted>,
}

/// Why there is no picture.
#[derive(Debug, thiserror::Error)]
pub enum PictureError {
    /// It cannot be read.
    #[error("cannot read the picture `{}`: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        source: TextureError,
    },
    /// The program paints nothing of that name.
    #[error(transparent)]
    Paint(#[from] PaintError),
}

impl Pictures {
    /// Reads and paints all pictures of an area; names of files count from `folder`.
    ///
    /// # Errors
    /// A file cannot be read, or a word after `paint:` is unknown.
    pub fn new(head: &Head, folder: &Path) -> Result<Pictures, PictureError> {
        let trees = head.species.iter().map(|species| trees(species, folder)).collect::<Result<_, _>>()?;
        let named = head.covers.iter().map(|cover| cover.image.as_str());
        let words = std::iter::once("paint:grass").chain(named).chain(["paint:road", "paint:water"]);
        let grounds = words.map(|word| Ok(Painted::new(picture(word, folder)?)));
        Ok(Pictures { trees, grounds: grounds.collect::<Result<_, PictureError>>()? })
    }

    /// The number of roads among [`Pictures::grounds`]; rivers have the next.
    #[must_use]
    pub fn road(&self) -> usize {
        self.grounds.len().saturating_sub(2)
    }

    /// A picture of a species; of one that there is none of, the first.
    #[must_use]
    pub fn tree(&self, species: u16, picture: u8) -> Option<&Painted> {
        let pictures = self.trees.get(usize::from(species))?;
        pictures.get(usize::from(picture)).or(pictures.first())
    }

    /// Bytes of all texels.
    #[must_use]
    pub fn bytes(&self) -> usize {
        let all = self.trees.iter().flatten().chain(&self.grounds);
        all.map(|painted| std::mem::size_of_val(painted.texels.rgba())).sum()
    }
}

fn trees(species: &Species, folder: &Path) -> Result<Vec<Painted>, PictureError> {
    if species.images.is_empty() {
        return Ok((0..paint::VARIANTS).map(|variant| Painted::new(paint::tree(species.form, variant))).collect());
    }
    species.images.iter().map(|image| Ok(Painted::new(picture(image, folder)?))).collect()
}

fn picture(word: &str, folder: &Path) -> Result<Texels, PictureError> {
    if word.starts_with(paint::PREFIX) {
        return Ok(paint::named(word)?);
    }
    let path = folder.join(word);
    read(&path).map_err(|source| PictureError::Read { path, source })
}

impl Painted {
    /// Measures a picture.
    #[must_use]
    pub fn new(texels: Texels) -> Painted {
        let light: Vec<f64> =
            (0..256).map(|level| Encoding::Srgb.decode(Rgb::gray(f64::from(level) / 255.0)).r).collect();
        let (mut sum, mut count) = ([0.0; 3], 0_usize);
        for texel in texels.rgba().iter().filter(|texel| texel[3] > 127) {
            (0..3).for_each(|channel| sum[channel] += light[usize::from(texel[channel])]);
            count += 1;
        }
        let mean = sum.map(|sum| f64::from(Encoding::Srgb.level((sum / count.max(1) as f64) as f32)) / 255.0);
        let share = count as f64 / texels.rgba().len() as f64;
        Painted { texels: Arc::new(texels), color: Rgb::new(mean[0], mean[1], mean[2]), share }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::image::textures::FirstRow;

    #[test]
    fn means_are_of_light_and_of_what_is_there() {
        let texels = vec![[0, 0, 0, 255], [255, 255, 255, 255], [255, 0, 0, 0], [9, 9, 9, 0]];
        let painted = Painted::new(Texels::new(2, 2, texels, FirstRow::AtV0).expect("four texels"));
        assert_eq!(painted.share, 0.5);
        // Half of the light is level 188 of sRGB.
        assert_eq!(painted.color, Rgb::gray(188.0 / 255.0));
    }
}
