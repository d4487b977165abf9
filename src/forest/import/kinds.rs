//! Kinds: species and grounds of an imported area, and what is usual for them where a table says nothing.
//!
//! code of a species -KINDS-> its form, its crown, how fast it grows; name of a ground -KINDS-> its number
//!
//! The numbers are round and ours: they are for looking at, not for forecasts. What a table says goes before.
//!
//! Space: metres, trees a hectare, years.
//! Source: F. J. Richards, "A Flexible Growth Function for Empirical Use", Journal of Experimental Botany 10(2), 1959.

use crate::forest::area::{Cover, Form, Species};
use crate::forest::paint;
use crate::math::{exp, pow};
use crate::scene::Place;

/// The most grounds of an area.
const MOST_COVERS: usize = 255;

/// Species and grounds, in the order in which they were asked for.
#[derive(Clone, Debug, Default)]
pub(super) struct Kinds {
    pub species: Vec<Species>,
    pub covers: Vec<Cover>,
}

impl Kinds {
    /// The number of a species; the first who names its form decides.
    pub fn species(&mut self, code: &str, form: Option<Form>) -> u16 {
        let known = self.species.iter().position(|species| species.code == code);
        known.unwrap_or_else(|| {
            let form = form.unwrap_or_else(|| form_of(code));
            let species = Species { code: code.to_string(), form, images: Vec::new(), place: Place::default() };
            self.species.push(species);
            self.species.len() - 1
        }) as u16
    }

    /// The form of a species that was asked for.
    pub fn form(&self, species: u16) -> Form {
        self.species.get(usize::from(species)).map_or(Form::Conifer, |species| species.form)
    }

    /// The number of a ground: one that the program paints, or a picture. From the 256th on all are the last one.
    pub fn cover(&mut self, name: &str) -> u8 {
        let image = if paint::GROUNDS.contains(&name) { format!("{}{name}", paint::PREFIX) } else { name.to_string() };
        let known = self.covers.iter().position(|cover| cover.image == image);
        known.unwrap_or_else(|| {
            if self.covers.len() < MOST_COVERS {
                let number = self.covers.len() as u32 + 1;
                let tile = if matches!(name, "water" | "rock") { 60.0 } else { 30.0 };
                self.covers.push(Cover { number, image, tile, place: Place::default() });
            }
            self.covers.len() - 1
        }) as u8
    }
}

/// What a tree of a code looks like, by the beginnings that inventories use: the Latin genus or its first letters.
fn form_of(code: &str) -> Form {
    let upper = code.to_ascii_uppercase();
    let begins = |words: &[&str]| words.iter().any(|word| upper.starts_with(word));
    if begins(&["PINPN", "PINUS PINEA", "UMBR"]) {
        Form::Umbrella
    } else if begins(&["EUC", "POPNI", "CUPRES", "COLUMN"]) {
        Form::Column
    } else if begins(&["ERI", "CYT", "ULE", "JUN", "CIS", "GENIS", "SHRUB", "RHO"]) {
        Form::Shrub
    } else if begins(&[
        "QUE", "FAG", "BET", "CAS", "ACE", "FRA", "TIL", "ALN", "ULM", "POP", "SAL", "OLE", "BROAD", "RA", "BM",
    ]) {
        Form::Broadleaf
    } else {
        Form::Conifer
    }
}

/// What is usual for a form.
pub(super) struct Usual {
    /// Height that it tends to, and how fast, a year.
    height: [f64; 2],
    /// Diameter of the crown: its least, and its share of the height.
    crown: [f64; 2],
    /// Trees a hectare when planted, and when old.
    density: [f64; 2],
    /// The ground below.
    pub cover: &'static str,
}

/// What is usual for a form.
pub(super) fn usual(form: Form) -> Usual {
    let (height, crown, density, cover) = match form {
        Form::Conifer => ([26.0, 0.045], [0.9, 0.24], [1600.0, 420.0], "pine_floor"),
        Form::Broadleaf => ([20.0, 0.035], [1.0, 0.50], [1200.0, 260.0], "grass"),
        Form::Umbrella => ([17.0, 0.040], [0.8, 0.60], [700.0, 180.0], "pine_floor"),
        Form::Column => ([32.0, 0.110], [0.8, 0.18], [1250.0, 950.0], "heath"),
        Form::Shrub => ([2.6, 0.200], [0.4, 0.80], [900.0, 800.0], "heath"),
    };
    Usual { height, crown, density, cover }
}

impl Usual {
    /// Diameter of the crown of a tree of this height.
    pub fn crown(&self, height: f64) -> f64 {
        self.crown[0].min(height) + self.crown[1] * height
    }

    /// Height and trees a hectare so many years after planting.
    pub fn grown(&self, age: f64) -> (f64, f64) {
        let share = 1.0 - exp(-self.height[1] * (age + 0.5));
        let [planted, old] = self.density;
        (tenth(self.height[0] * pow(share, 1.25)).max(0.3), (planted + (old - planted) * share).round())
    }
}

/// To a tenth: nobody measures crowns more closely.
pub(super) fn tenth(number: f64) -> f64 {
    (number * 10.0).round() / 10.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn species_and_grounds_are_counted_once() {
        let mut kinds = Kinds::default();
        assert_eq!(
            [kinds.species("PINPN", None), kinds.species("DF", None), kinds.species("PINPN", Some(Form::Shrub))],
            [0, 1, 0]
        );
        assert_eq!([kinds.form(0), kinds.form(1)], [Form::Umbrella, Form::Conifer]);
        assert_eq!([kinds.cover("grass"), kinds.cover("mine.png"), kinds.cover("grass")], [0, 1, 0]);
        assert_eq!((kinds.covers[0].image.as_str(), kinds.covers[1].number), ("paint:grass", 2));
        for number in 0..400 {
            kinds.cover(&format!("{number}.png"));
        }
        assert_eq!(kinds.covers.len(), MOST_COVERS);
    }

    #[test]
    fn what_is_planted_grows_and_thins() {
        for (_, form) in Form::ALL {
            let usual = usual(form);
            let ages = [0.0, 5.0, 10.0, 20.0, 40.0].map(|age| usual.grown(age));
            assert!(ages.windows(2).all(|pair| pair[0].0 <= pair[1].0 && pair[0].1 >= pair[1].1), "{form:?} {ages:?}");
            assert!(ages[0].0 < 1.5 && ages[4].0 > 2.0, "{form:?} {ages:?}");
        }
    }
}
