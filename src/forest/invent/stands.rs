//! Stands: what grows on a region, and what has become of it by 2011, 2018 and 2026.
//!
//! site, its height and distance from water -STANDS-> a stand, or a ground without trees
//!
//! Trees grow fast at first and then slowly; stands get thinner as their crowns get wider; eucalypts are cut after a dozen years, pines after
//! forty-five, and what is planted anew is small and dense. So the three years differ, and each place in its own way.
//!
//! Space: metres, trees a hectare, years.
//! Source: F. J. Richards, "A Flexible Growth Function for Empirical Use", Journal of Experimental Botany 10(2), 1959. The numbers of the species are round and ours.
//! Cost: nothing to speak of.

use super::regions::Site;
use super::relief::{HIGHEST, Relief, gradient_noise};
use crate::forest::area::{Cover, Form, Plant, Species, Spread, Stand, StandState};
use crate::forest::random::{key, unit};
use crate::math::{exp, pow};
use crate::scene::Place;

/// The years that every stand has a state for.
pub const YEARS: [i32; 3] = [2011, 2018, 2026];

/// Grounds of an invented landscape: picture, metres of the tile.
const COVERS: [(&str, f64); 8] = [
    ("pine_floor", 30.0),
    ("grass", 30.0),
    ("heath", 30.0),
    ("field", 40.0),
    ("water", 60.0),
    ("rock", 60.0),
    ("sand", 30.0),
    ("road", 12.0),
];
const PINE_FLOOR: u8 = 0;
pub(super) const GRASS: u8 = 1;
const HEATH: u8 = 2;
const FIELD: u8 = 3;
pub(super) const WATER: u8 = 4;
const ROCK: u8 = 5;

/// How a species grows.
struct Kind {
    code: &'static str,
    form: Form,
    /// Height that it tends to, metres; how fast, a year; diameter of the crown over height, and its least.
    height: f64,
    speed: f64,
    crown: [f64; 2],
    /// Trees a hectare when planted and when old; years until they are cut.
    density: [f64; 2],
    cut: f64,
    plant: Plant,
    cover: u8,
}

const KINDS: [Kind; 6] = [
    Kind {
        code: "PINPN",
        form: Form::Umbrella,
        height: 17.0,
        speed: 0.040,
        crown: [0.62, 0.8],
        density: [700.0, 180.0],
        cut: 80.0,
        plant: Plant::Jittered,
        cover: PINE_FLOOR,
    },
    Kind {
        code: "PINPR",
        form: Form::Conifer,
        height: 26.0,
        speed: 0.045,
        crown: [0.26, 0.9],
        density: [1500.0, 420.0],
        cut: 45.0,
        plant: Plant::Poisson,
        cover: PINE_FLOOR,
    },
    Kind {
        code: "QUESU",
        form: Form::Broadleaf,
        height: 13.0,
        speed: 0.030,
        crown: [0.80, 1.0],
        density: [320.0, 90.0],
        cut: 150.0,
        plant: Plant::Poisson,
        cover: GRASS,
    },
    Kind {
        code: "EUCGL",
        form: Form::Column,
        height: 32.0,
        speed: 0.110,
        crown: [0.19, 0.8],
        density: [1250.0, 950.0],
        cut: 12.0,
        plant: Plant::Rows,
        cover: HEATH,
    },
    Kind {
        code: "CASSA",
        form: Form::Broadleaf,
        height: 20.0,
        speed: 0.040,
        crown: [0.52, 1.0],
        density: [900.0, 260.0],
        cut: 90.0,
        plant: Plant::Jittered,
        cover: GRASS,
    },
    Kind {
        code: "ERIAR",
        form: Form::Shrub,
        height: 2.6,
        speed: 0.20,
        crown: [0.90, 0.5],
        density: [900.0, 800.0],
        cut: 300.0,
        plant: Plant::Poisson,
        cover: HEATH,
    },
];

/// All grounds, in the order that [`Land`] means.
pub(super) fn covers() -> Vec<Cover> {
    let cover = |(index, (name, tile)): (usize, &(&str, f64))| Cover {
        number: index as u32 + 1,
        image: format!("{}{name}", crate::forest::paint::PREFIX),
        tile: *tile,
        place: Place::default(),
    };
    COVERS.iter().enumerate().map(cover).collect()
}

/// All species.
pub(super) fn species() -> Vec<Species> {
    let species = |kind: &Kind| Species {
        code: kind.code.to_string(),
        form: kind.form,
        images: Vec::new(),
        place: Place::default(),
    };
    KINDS.iter().map(species).collect()
}

/// What a region is.
pub(super) enum Land {
    /// Trees.
    Stand(Box<Stand>),
    /// A ground, index into the covers.
    Bare(u8),
}

/// What is on the region of a site, by how high and how wet it is, and by chance.
pub(super) fn of_site(seed: u64, relief: &Relief, site: &Site) -> Land {
    let chance =
        |number: u64| unit(key(&[seed, 0x41, number, site.index[0] as u32 as u64, site.index[1] as u32 as u64]));
    let height = relief.height(site.at) / HIGHEST + 0.10 * (chance(0) - 0.5);
    let from_river = (site.at[0] - relief.river(site.at[1])).abs();
    let pick = chance(1);
    if from_river < 520.0 && pick < 0.62 || height < 0.12 && pick < 0.12 {
        return Land::Bare(if pick < 0.36 { FIELD } else { GRASS });
    }
    if height > 0.74 || pick > 0.965 {
        return Land::Bare(if height > 0.80 && pick < 0.8 { ROCK } else { HEATH });
    }
    if pick > 0.93 {
        return Land::Bare(GRASS);
    }
    // Neighbors are often of a kind: owners plant what grows on their slope. A noise of 3 km, and a little chance.
    let slope = gradient_noise(seed ^ 0x42, site.at[0] / 3000.0, site.at[1] / 3000.0)[0];
    let choice = (0.5 + 0.75 * slope + 0.45 * (chance(2) - 0.5)).clamp(0.0, 0.999);
    let [low, middle, high] = [[2, 0, 3, 2], [3, 1, 0, 4], [1, 4, 5, 1]];
    let choices = if height < 0.20 {
        low
    } else if height < 0.45 {
        middle
    } else {
        high
    };
    let kind = choices[(choice * 4.0) as usize % 4];
    let age = 2.0 + (KINDS[kind].cut.min(70.0) - 2.0) * chance(3);
    Land::Stand(Box::new(stand(number(site), kind, age, chance(4))))
}

/// A number that the stand has in every cell: from its site's column and row.
fn number(site: &Site) -> u32 {
    let [column, row] = site.index.map(|index| (index + 8).max(0) as u32);
    row * 4096 + column + 1
}

fn stand(number: u32, kind: usize, age_at_first: f64, soil: f64) -> Stand {
    let grown = &KINDS[kind];
    let state = |year: &i32| {
        let age = (age_at_first + f64::from(year - YEARS[0])) % grown.cut;
        let share = 1.0 - exp(-grown.speed * (age + 1.5));
        let height = grown.height * (0.82 + 0.3 * soil) * pow(share, 1.25);
        let crown = grown.crown[1] + grown.crown[0] * height;
        let [planted, old] = grown.density;
        let tenth = |number: f64| (number * 10.0).round() / 10.0;
        StandState {
            year: Some(*year),
            species: kind as u16,
            height: Spread { mean: tenth(height.max(0.6)), deviation: tenth(0.10 * height) },
            crown: Spread { mean: tenth(crown), deviation: tenth(0.14 * crown) },
            density: (old + (planted - old) * exp(-age / 18.0)).round(),
            crown_base: Some(tenth(0.3 * height)),
            plant: grown.plant,
            picture: None,
            cover: Some(grown.cover),
        }
    };
    Stand { number, states: YEARS.iter().map(state).collect(), place: Place::default() }
}
