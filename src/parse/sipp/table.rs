//! Tables of parameters: what each is called, what follows it, which numbers make sense.

use super::block::Given;
use crate::diagnostic::Diagnostic;

/// What follows the word of a parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Takes {
    /// As many numbers as one of these says.
    Numbers(&'static [usize]),
    /// Pairs of numbers.
    Pairs,
    /// One of these words.
    OneOf(&'static [&'static str]),
    Name,
    Text,
    Nothing,
}

/// Which numbers make sense.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Range {
    Any,
    From0,
    Above0,
    /// 0 to 1.
    Fraction,
    /// Above 0, at most 1.
    PositiveFraction,
    /// Above 0, below 180.
    Opening,
    /// Whole, 1 to [`MOST_RESOLUTION`].
    Resolution,
    /// Not all of them 0.
    Direction,
}

/// The finest `res`: a sphere then has 8 million polygons.
pub(super) const MOST_RESOLUTION: f64 = 4096.0;

/// One row of a table.
#[derive(Clone, Copy, Debug)]
pub(super) struct Parameter {
    pub word: &'static str,
    /// How it is written, for messages.
    pub shape: &'static str,
    pub takes: Takes,
    pub range: Range,
    pub required: bool,
    pub repeats: bool,
}

/// A row with numbers.
pub(super) const fn numbers(
    word: &'static str,
    shape: &'static str,
    counts: &'static [usize],
    range: Range,
) -> Parameter {
    Parameter { word, shape, takes: Takes::Numbers(counts), range, required: false, repeats: false }
}

/// A row with something other than a fixed count of numbers.
pub(super) const fn other(word: &'static str, shape: &'static str, takes: Takes) -> Parameter {
    Parameter { word, shape, takes, range: Range::Any, required: false, repeats: false }
}

impl Parameter {
    pub const fn required(self) -> Parameter {
        Parameter { required: true, ..self }
    }

    pub const fn repeats(self) -> Parameter {
        Parameter { repeats: true, ..self }
    }
}

/// Whether the numbers of a parameter make sense.
pub(super) fn check_range(parameter: &Parameter, given: &Given) -> Result<(), Diagnostic> {
    let word = parameter.word;
    let all = |holds: fn(&f64) -> bool| given.numbers.iter().all(holds);
    let wrong = match parameter.range {
        Range::Any => return Ok(()),
        Range::From0 if !all(|&x| x >= 0.0) => "cannot be negative",
        Range::Above0 if !all(|&x| x > 0.0) => "must be above 0",
        Range::Fraction if !all(|x| (0.0..=1.0).contains(x)) => "must be from 0 to 1",
        Range::PositiveFraction if !all(|&x| x > 0.0 && x <= 1.0) => "must be above 0, at most 1",
        Range::Opening if !all(|&x| x > 0.0 && x < 180.0) => "must be above 0 and below 180 degrees",
        Range::Resolution if !all(|&x| x.fract() == 0.0 && (1.0..=MOST_RESOLUTION).contains(&x)) => {
            "must be a whole number from 1 to 4096"
        }
        Range::Direction if all(|&x| x == 0.0) => "is 0 0 0, which is no direction",
        _ => return Ok(()),
    };
    let error = Diagnostic::error(format!("`{word}` {wrong}")).at(given.values, format!("in `{}`", parameter.shape));
    let help = match word {
        "radius" | "radii" => Some("to see the inside of a shape, write `inside`"),
        "c3" => Some("small is shiny, 1 is dull"),
        "opacity" => Some("0 is invisible, 1 hides what is behind"),
        "to" => Some("it leads from the scene towards the light"),
        "res" => Some("leave `res` out, and the shape is cut as finely as the picture needs"),
        "opening" => Some("it is the full angle of the cone of light"),
        _ => None,
    };
    Err(if let Some(help) = help { error.help(help) } else { error })
}
