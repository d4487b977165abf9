//! Paint: pictures of trees and grounds, made by the program.
//!
//! form and variant, or `paint:NAME` -PAINT-> Texels -> textures of the scene
//!
//! Why painted: photographs have owners and take room. A landscape that names no picture shall still look like one, on any machine and without a file: so
//! pictures are grown like the trees are, from numbers, the same bytes everywhere.
//!
//! Space: 256 x 256 texels, rows from the lowest. Trees fill their picture: foot in the middle of the lower edge, top at the upper edge, the crown from side
//! to side, stretched to a square ([`aspect`] says how wide it is). Where nothing is (alpha 0) stands the color of the nearest leaf.
//! Source: ours. Cost: 10 to 30 ms a picture.

mod canvas;
mod chance;
mod forms;
mod ground;
mod tree;

pub use canvas::SIDE;
pub use ground::GROUNDS;

use super::area::Form;
use crate::diagnostic::suggest;
use crate::image::textures::Texels;
use canvas::Canvas;
use chance::Chance;
use forms::Plan;

/// Pictures of each form of tree.
pub const VARIANTS: u32 = 4;

/// What a picture's name begins with if the program shall paint it.
pub const PREFIX: &str = "paint:";

/// A `paint:` word that means nothing.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the program cannot paint `{word}`: {advice}")]
pub struct PaintError {
    /// What was asked for, without `paint:`.
    pub word: String,
    /// What to write instead.
    pub advice: String,
}

/// The picture of a tree; variants beyond [`VARIANTS`] begin again.
///
/// ```
/// use farop::forest::{area::Form, paint};
/// let oak = paint::tree(Form::Broadleaf, 1);
/// assert_eq!((oak.size(), oak.has_holes()), ((256, 256), true));
/// ```
#[must_use]
pub fn tree(form: Form, variant: u32) -> Texels {
    let plan = Plan::of(form);
    let number = Form::ALL.iter().position(|(_, other)| *other == form).unwrap_or(0) as u64;
    let mut chance = Chance::new(&[number, u64::from(variant % VARIANTS)]);
    let mut canvas = Canvas::of_tree(plan.width);
    forms::build(form, &plan, &mut chance).paint(&plan, &mut canvas);
    canvas.finish()
}

/// How wide the trees of a form are painted for, in their heights. A tree that is drawn about so has leaves as they grew.
#[must_use]
pub fn aspect(form: Form) -> f64 {
    Plan::of(form).width
}

/// The picture of a ground: one of [`GROUNDS`], or a form and its variant as `conifer` or `conifer:2`. With or without `paint:` before it.
///
/// # Errors
/// [`PaintError`] for any other word; it knows what was meant, or tells all there are.
pub fn named(word: &str) -> Result<Texels, PaintError> {
    let word = word.strip_prefix(PREFIX).unwrap_or(word);
    if let Some(canvas) = ground::paint(word) {
        return Ok(canvas.finish());
    }
    let (name, variant) = word.split_once(':').map_or((word, Some(0)), |(name, variant)| (name, variant.parse().ok()));
    let form = Form::ALL.iter().find(|(other, _)| *other == name);
    match (form, variant) {
        (Some((_, form)), Some(variant)) => Ok(tree(*form, variant)),
        _ => Err(PaintError { word: word.to_string(), advice: advice(name) }),
    }
}

/// Whether the program can paint this, without painting it.
///
/// # Errors
/// As [`named`].
pub fn check(word: &str) -> Result<(), PaintError> {
    let word = word.strip_prefix(PREFIX).unwrap_or(word);
    let (name, variant) = word.split_once(':').unwrap_or((word, "0"));
    let is_form = Form::ALL.iter().any(|(form, _)| *form == name) && variant.parse::<u32>().is_ok();
    if GROUNDS.contains(&word) || is_form {
        Ok(())
    } else {
        Err(PaintError { word: word.to_string(), advice: advice(name) })
    }
}

fn advice(name: &str) -> String {
    let known: Vec<&str> = GROUNDS.into_iter().chain(Form::ALL.iter().map(|(form, _)| *form)).collect();
    match suggest(name, &known) {
        Some(meant) => format!("did you mean `paint:{meant}`?"),
        None => format!("write `paint:` and one of {}", known.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::forest::random::mix64;

    fn hash(texels: &Texels) -> u64 {
        texels.rgba().iter().fold(0, |sum, rgba| mix64(sum ^ u64::from(u32::from_le_bytes(*rgba))))
    }

    #[test]
    fn trees_fill_their_picture_and_stand_on_its_edge() {
        for (name, form) in Form::ALL {
            let texels = tree(form, 0);
            assert_eq!(hash(&texels), hash(&tree(form, VARIANTS)), "{name}: the same every time");
            assert_ne!(hash(&texels), hash(&tree(form, 1)), "{name}: variants differ");
            let solid = |index: &usize| texels.rgba()[*index][3] >= 128;
            let there: Vec<usize> = (0..SIDE * SIDE).filter(solid).collect();
            let share = there.len() as f64 / (SIDE * SIDE) as f64;
            assert!((0.15..0.8).contains(&share), "{name}: {share}");
            let columns = there.iter().map(|index| index % SIDE);
            let (west, east) = (columns.clone().min(), columns.max());
            assert!(west < Some(30) && east > Some(SIDE - 30), "{name}: from {west:?} to {east:?}");
            let rows = (there.first().map(|index| index / SIDE), there.last().map(|index| index / SIDE));
            assert!(rows.0 < Some(3) && rows.1 > Some(SIDE - 16), "{name}: rows {rows:?}");
        }
    }

    #[test]
    fn nothing_has_the_color_of_what_is_near() {
        // Dilated: no black behind the leaves.
        let texels = tree(Form::Conifer, 2);
        assert!(texels.rgba().iter().all(|rgba| rgba[3] > 0 || rgba[..3] != [0, 0, 0]));
    }

    #[test]
    fn the_left_of_a_crown_is_lighter() {
        for (name, form) in Form::ALL {
            let texels = tree(form, 0);
            let mean = |columns: std::ops::Range<usize>| {
                let inside = texels
                    .rgba()
                    .iter()
                    .enumerate()
                    .filter(|(index, rgba)| columns.contains(&(index % SIDE)) && rgba[3] == 255);
                let (sum, count) =
                    inside.fold((0.0, 0.0), |(sum, count), (_, rgba)| (sum + f64::from(rgba[1]), count + 1.0));
                sum / count
            };
            assert!(mean(0..SIDE / 2) > 1.05 * mean(SIDE / 2..SIDE), "{name}");
        }
    }

    #[test]
    fn grounds_fit_to_themselves() {
        for name in GROUNDS {
            let texels = named(&format!("paint:{name}")).expect("a ground");
            assert!(!texels.has_holes(), "{name}");
            let last = SIDE as u32 - 1;
            let difference = |a: [u8; 4], b: [u8; 4]| (0..3).map(|c| f64::from(a[c].abs_diff(b[c]))).sum::<f64>();
            let across =
                |x: u32, next: u32| (0..=last).map(|y| difference(texels.at(x, y), texels.at(next, y))).sum::<f64>();
            let up =
                |y: u32, next: u32| (0..=last).map(|x| difference(texels.at(x, y), texels.at(x, next))).sum::<f64>();
            // Over the seam it changes as much as elsewhere.
            let [inner, outer] = [(20..last - 20).map(|x| across(x, x + 1)).fold(0.0, f64::max), across(last, 0)];
            assert!(outer < 1.3 * inner, "{name}: {outer} over the seam, at most {inner} elsewhere");
            let [inner, outer] = [(20..last - 20).map(|y| up(y, y + 1)).fold(0.0, f64::max), up(last, 0)];
            assert!(outer < 1.3 * inner, "{name}: {outer} over the upper seam, at most {inner} elsewhere");
        }
    }

    #[test]
    fn words_that_mean_nothing_are_told_what_was_meant() {
        let message = |word: &str| named(word).expect_err("no such picture").to_string();
        assert_eq!(message("paint:gras"), "the program cannot paint `gras`: did you mean `paint:grass`?");
        assert!(message("paint:zzzzzz").contains("pine_floor, grass"), "{}", message("paint:zzzzzz"));
        assert!(named("conifer:x").is_err() && check("paint:conifer:x").is_err());
        assert!(check("paint:conifer:3").is_ok() && check("paint:road").is_ok() && check("paint:rod").is_err());
    }
}
