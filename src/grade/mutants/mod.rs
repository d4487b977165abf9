//! Mutants: the contract with one mistake, each with words for it.
//!
//! A mutant changes one of the [`Rules`]; what it draws is what a rasterizer with that mistake would. A picture that one of
//! them explains has a cause with a name. Several mutants may be one mistake made in several ways (corners cut off or rounded up):
//! they share its name, and are no rivals of each other.
//!
//! Why mutants of the oracle and not of a rasterizer: one rule, one change, no side effect of how a loop happens to be written.

mod areas;
mod carried;
mod color;
mod coverage;
mod depth;
mod drawing;
mod dropped;
mod highlight;
mod kept;
mod light;
mod lines;
mod list;
mod normal;
mod pieces;
mod pixel;
mod run;
mod shades;
mod spans;
mod value;

use super::labs::Lab;
use super::lines::rule::Lines;
use super::listed::Tone;
use super::rules::{Blending, Bounds, BoundsBy, DepthFrom, Pieces, Rules};

/// A change with a number in it.
pub type Numbered = fn(&mut Rules, f64);

/// A mistake that students make.
#[derive(Clone, Copy, Debug)]
pub struct Mutant {
    /// The mistake's name, a few words; ways to make one mistake share it.
    pub name: &'static str,
    /// The cause, in one sentence.
    pub cause: &'static str,
    /// The right rule, in one sentence.
    pub rule: &'static str,
    /// Where to read.
    pub read: &'static str,
    /// The change.
    pub change: fn(&mut Rules),
    /// A change with a number in it, and that number.
    pub with: Option<(Numbered, f64)>,
    /// What else goes with it in some programs, and is no mistake, or follows from this one.
    pub beside: [Option<fn(&mut Rules)>; 3],
}

/// The usual ones: one rule, one change.
#[must_use]
pub fn usual() -> Vec<Mutant> {
    let first = [coverage::MUTANTS, depth::MUTANTS, color::MUTANTS, drawing::MUTANTS].concat();
    let covered = [pieces::MUTANTS, spans::MUTANTS, list::MUTANTS].concat();
    let values = [value::MUTANTS, carried::MUTANTS, run::MUTANTS].concat();
    let light = [light::MUTANTS, normal::MUTANTS, highlight::MUTANTS].concat();
    [first, covered, values, light, pixel::MUTANTS.to_vec(), lines::all()].concat()
}

/// All of them: the usual ones first, then those that depend on how a program is built, or have a number in them.
#[must_use]
pub fn all() -> Vec<Mutant> {
    [usual(), areas::all(), kept::all(), dropped::all(), shades::all()].concat()
}

/// Those that may change a picture of `lab`: where no case has lines, no mistake about lines needs to be tried; where no aspect is about
/// near and far, none of how depth is kept and compared.
#[must_use]
pub fn of(lab: &Lab) -> Vec<Mutant> {
    let has_lines = lab.aspects.iter().any(|aspect| (aspect.cases)(0).iter().any(|case| case.lines));
    let has_range = lab.aspects.iter().any(|aspect| aspect.name == "depth range");
    let kept = if has_range { kept::all() } else { kept::anywhere() };
    let mut mutants = [usual(), areas::all(), kept, dropped::all(), shades::all()].concat();
    // Where only lines are drawn, light is bright or dark: how dark says nothing about levels.
    mutants.retain(|mutant| !has_lines || mutant.is_about_lines() || (mutant.with.is_none() && mutant.is_plain()));
    mutants.retain(|mutant| (has_lines || !mutant.is_about_lines()) && (has_range || !mutant.is_about_range()));
    mutants
}

impl Mutant {
    /// Whether it changes nothing but lines.
    #[must_use]
    pub fn is_about_lines(&self) -> bool {
        let changed = self.applied_to(&Rules::default());
        Rules { lines: Lines::RIGHT, ..changed } == Rules::default()
    }

    /// Whether it is about the numbers that depth is kept in, or what it is held against.
    #[must_use]
    pub fn is_about_range(&self) -> bool {
        let (changed, right) = (self.applied_to(&Rules::default()), Rules::default());
        let is_kept_in_steps = matches!(
            changed.depth,
            DepthFrom::Steps(_) | DepthFrom::RoundSteps(_) | DepthFrom::Wraps(..) | DepthFrom::DistanceSteps(_)
        );
        let numbers = |rules: &Rules| [rules.margin, rules.limit, rules.capped];
        is_kept_in_steps || numbers(&changed) != numbers(&right)
    }

    /// Whether nothing goes along with it.
    #[must_use]
    pub fn is_plain(&self) -> bool {
        self.beside.iter().all(Option::is_none)
    }

    /// The same with something more beside it; a fourth thing takes the place of the third.
    #[must_use]
    pub fn beside(mut self, change: fn(&mut Rules)) -> Mutant {
        let free = self.beside.iter().position(Option::is_none).unwrap_or(2);
        self.beside[free] = Some(change);
        self
    }

    /// `rules` with this mistake in them as well.
    #[must_use]
    pub fn applied_to(&self, rules: &Rules) -> Rules {
        let mut changed = rules.clone();
        (self.change)(&mut changed);
        if let Some((change, number)) = self.with {
            change(&mut changed, number);
        }
        for change in self.beside.iter().flatten() {
            change(&mut changed);
        }
        changed
    }
}

/// Name, cause, rule and page, for the lists of this folder.
const fn mutant(words: [&'static str; 4], change: fn(&mut Rules)) -> Mutant {
    let [name, cause, rule, read] = words;
    Mutant { name, cause, rule, read, change, with: None, beside: [None; 3] }
}

/// One mistake with each of some numbers in it.
fn family(words: [&'static str; 4], numbers: &[f64], change: fn(&mut Rules, f64)) -> Vec<Mutant> {
    let one = |&number: &f64| Mutant { with: Some((change, number)), ..mutant(words, |_| ()) };
    numbers.iter().map(one).collect()
}

/// Mistakes, each with each of what may go with it.
fn each_with(mutants: &[Mutant], besides: &[fn(&mut Rules)]) -> Vec<Mutant> {
    besides.iter().flat_map(|beside| mutants.iter().map(|mutant| mutant.beside(*beside))).collect()
}

/// The same with one of each of several lists.
fn each_of(mutants: &[Mutant], lists: &[&[fn(&mut Rules)]]) -> Vec<Mutant> {
    lists.iter().fold(mutants.to_vec(), |mutants, besides| each_with(&mutants, besides))
}

/// What goes along with a mistake in some programs: ways of doing things that are right by themselves, or follow from it.
pub(super) fn companions() -> &'static [fn(&mut Rules)] {
    &[
        |rules| (rules.divides_by_kept, rules.spares_exact) = (true, true),
        |rules| rules.divides_by_kept = true,
        |rules| rules.clamps = true,
        |rules| rules.shape.is_fan = true,
        |rules| rules.shape.planes_follow = true,
        |rules| rules.pieces = Pieces::Fan { from: 0, skipped: 0, lost: 0, toggles: true, of_all: true },
        |rules| rules.bounds = Bounds { by: BoundsBy::Clipped, ..Bounds::WHOLE },
        |rules| rules.least_area = 1e-9,
        |rules| rules.blending = Blending::AtOnce,
        |rules| rules.blending = Blending::AtEnd,
        |rules| (rules.face_tone, rules.tone) = (rules.tone, Tone::Own),
        |rules| (rules.divides_by_kept, rules.spares_exact, rules.shape.is_fan) = (true, true, true),
    ]
}
