//! Season: the pictures of an area as they are in spring, in autumn, in winter.
//!
//! Pictures as painted or read -SEASON-> Pictures -> frame
//!
//! A picture is changed once, texel by texel, before any tree wears it; so a season costs a frame nothing. Leaves are what is green in a picture, stems are not.
//! Trees that drop their leaves (broadleaf ones) turn in autumn, each picture of a species to another color, and in winter keep a few leaf texels, brown, as twigs. Evergreen
//! trees darken a little. Grounds that are green fade. Summer is the picture itself.
//!
//! Why by picture and not by tree: trees of a species wear several pictures by their hash already, and a texture for every tree would be
//! millions of them.
//!
//! Space: display values. Source: ours; the wish is that of Landscaper's users. Cost: one pass over all texels, once.

use super::area::{Form, Head};
use super::pictures::{Painted, Pictures};
use super::random::mix64;
use super::vector::Crs;
use crate::image::textures::{FirstRow, Rgba, Texels};

/// A quarter of the year.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Season {
    /// Fresh leaves.
    Spring,
    /// As painted.
    Summer,
    /// Turning leaves.
    Autumn,
    /// Bare trees.
    Winter,
}

/// Colors that leaves turn to, one picture after the other.
const TURNED: [[f64; 3]; 4] = [[205.0, 140.0, 40.0], [190.0, 90.0, 35.0], [215.0, 175.0, 65.0], [165.0, 60.0, 40.0]];
const FRESH: [f64; 3] = [150.0, 190.0, 75.0];
const TWIGS: [f64; 3] = [105.0, 90.0, 75.0];
const STRAW: [f64; 3] = [150.0, 135.0, 80.0];
/// Of a hundred leaf texels of a bare tree so many are twigs.
const TWIGS_OF_100: u64 = 22;

impl Season {
    /// The season of a day of the year, 1 to 366, in the projection `crs`: south of the equator half a year later.
    #[must_use]
    pub fn of_day(day: u32, crs: &str) -> Season {
        let is_south = matches!(Crs::named(crs), Some(Crs::Utm { south: true, .. }));
        let day = if is_south { (day + 182) % 365 } else { day };
        match day {
            80..172 => Season::Spring,
            172..266 => Season::Summer,
            266..355 => Season::Autumn,
            _ => Season::Winter,
        }
    }

    /// The pictures of an area in this season.
    #[must_use]
    pub fn dress(self, head: &Head, pictures: Pictures) -> Pictures {
        if self == Season::Summer {
            return pictures;
        }
        let trees = head.species.iter().zip(pictures.trees).map(|(species, painted)| {
            let drops = species.form == Form::Broadleaf;
            painted
                .into_iter()
                .enumerate()
                .map(|(number, it)| changed(&it, |at, texel| self.leaf(drops, number, at, texel)))
                .collect()
        });
        let grounds = pictures.grounds.into_iter().map(|it| changed(&it, |_, texel| self.ground(texel)));
        Pictures { trees: trees.collect(), grounds: grounds.collect() }
    }

    /// A texel of a tree; `at` is its number in the picture.
    fn leaf(self, drops: bool, picture: usize, at: usize, texel: Rgba) -> Rgba {
        if !is_green(texel) {
            return texel;
        }
        match (self, drops) {
            (Season::Spring, true) => toward(texel, FRESH, 0.45),
            (Season::Spring, false) => toward(texel, FRESH, 0.12),
            (Season::Autumn, true) => toward(texel, TURNED[picture % TURNED.len()], 0.9),
            (Season::Winter, true) => {
                let is_twig = mix64(at as u64 ^ (picture as u64) << 40) % 100 < TWIGS_OF_100;
                let [red, green, blue, alpha] = toward(texel, TWIGS, 1.0);
                [red, green, blue, if is_twig { alpha } else { 0 }]
            }
            (Season::Autumn | Season::Winter, false) => toward(texel, [60.0, 75.0, 55.0], 0.25),
            (Season::Summer, _) => texel,
        }
    }

    fn ground(self, texel: Rgba) -> Rgba {
        match self {
            _ if !is_green(texel) => texel,
            Season::Spring => toward(texel, FRESH, 0.2),
            Season::Summer => texel,
            Season::Autumn => toward(texel, STRAW, 0.4),
            Season::Winter => toward(texel, STRAW, 0.65),
        }
    }
}

/// Whether a texel shows leaves or grass.
fn is_green([red, green, blue, _]: Rgba) -> bool {
    green > blue && green >= red
}

/// A share of the way to a color, as light or dark beside it as the texel is beside a mean green.
fn toward([red, green, blue, alpha]: Rgba, color: [f64; 3], share: f64) -> Rgba {
    /// The green of a mean leaf.
    const MEAN: f64 = 100.0;
    let light = (f64::from(green) / MEAN).clamp(0.4, 1.4);
    let mixed =
        |own: u8, other: f64| (f64::from(own) * (1.0 - share) + other * light * share).round().clamp(0.0, 255.0) as u8;
    [mixed(red, color[0]), mixed(green, color[1]), mixed(blue, color[2]), alpha]
}

fn changed(painted: &Painted, texel: impl Fn(usize, Rgba) -> Rgba) -> Painted {
    let (width, height) = painted.texels.size();
    let rgba = painted.texels.rgba().iter().enumerate().map(|(at, &old)| texel(at, old)).collect();
    Texels::new(width, height, rgba, FirstRow::AtV0).map_or_else(|| painted.clone(), Painted::new)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::forest::area::Species;
    use crate::scene::Place;
    use std::path::Path;

    fn area() -> (Head, Pictures) {
        let species = |code: &str, form| Species { code: code.into(), form, images: vec![], place: Place::default() };
        let species = vec![species("OAK", Form::Broadleaf), species("FIR", Form::Conifer)];
        let head = Head { side: 240.0, species, ..Head::default() };
        let pictures = Pictures::new(&head, Path::new(".")).expect("painted");
        (head, pictures)
    }

    #[test]
    fn oaks_turn_and_are_bare_and_firs_stay() {
        let (head, summer) = area();
        assert_eq!(Season::Summer.dress(&head, summer.clone()), summer);
        let [spring, autumn, winter] =
            [Season::Spring, Season::Autumn, Season::Winter].map(|season| season.dress(&head, summer.clone()));
        for picture in 0..summer.trees[0].len() {
            let oak = |pictures: &Pictures| pictures.trees[0][picture].clone();
            let is_green = |painted: Painted| painted.color.g > painted.color.r;
            assert!(is_green(oak(&summer)) && is_green(oak(&spring)) && !is_green(oak(&autumn)), "{picture}");
            assert!(oak(&spring).color.r > oak(&summer).color.r, "{picture}");
            assert!(oak(&winter).share < 0.6 * oak(&summer).share, "{picture}");
            assert_eq!(oak(&autumn).share, oak(&summer).share);
            let fir = |pictures: &Pictures| pictures.trees[1][picture].clone();
            assert!(is_green(fir(&winter)) && fir(&winter).share == fir(&summer).share, "{picture}");
        }
        // Trees of one species turn to several colors.
        assert!(autumn.trees[0].windows(2).all(|pair| pair[0].color != pair[1].color));
        let grass = |pictures: &Pictures| pictures.grounds[0].color;
        assert!(grass(&winter).r / grass(&winter).g > grass(&summer).r / grass(&summer).g);
    }

    #[test]
    fn days_are_half_a_year_apart_beyond_the_equator() {
        let of = |day, crs| Season::of_day(day, crs);
        let north = [1, 100, 200, 300, 366].map(|day| of(day, "EPSG:32629"));
        assert_eq!(north, [Season::Winter, Season::Spring, Season::Summer, Season::Autumn, Season::Winter]);
        assert_eq!(
            [1, 100, 200, 300].map(|day| of(day, "EPSG:32733")),
            [Season::Summer, Season::Autumn, Season::Winter, Season::Spring]
        );
        assert_eq!(of(200, ""), Season::Summer);
    }
}
