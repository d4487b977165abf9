//! Why a statement could not be read.

use crate::diagnostic::{Diagnostic, Span};
use crate::parse::foreign;
use crate::parse::tokens::{self, NotANumber};
use crate::parse::wording::{number_meant, quote};

/// Why a statement could not be read.
#[derive(Debug)]
pub(super) enum Trouble {
    /// A mistake, with its place.
    Mistake(Diagnostic),
    /// The file ends; what was expected there. The reader knows which block is cut.
    End(String),
}

impl From<Diagnostic> for Trouble {
    fn from(diagnostic: Diagnostic) -> Self {
        Trouble::Mistake(diagnostic)
    }
}

/// A word where a number is expected.
pub(super) fn bad_number(word: &[u8], span: Span, why: NotANumber, shape: &str) -> Trouble {
    if why == NotANumber::TooLarge {
        let error = Diagnostic::error(format!("number too large: {}", quote(word)));
        return error.at(span, "beyond the range of numbers").help("the largest number is about 1.8e308").into();
    }
    let error = Diagnostic::error(format!("{} is not a number", quote(word)))
        .at(span, format!("expected a number for {shape}"));
    let is_color = shape.contains("R G B");
    Trouble::Mistake(match (number_meant(word), foreign::color(word)) {
        (Some(meant), _) => error.help(meant),
        (None, Some([r, g, b])) if is_color => error.help(format!("colors are three numbers: write `{r} {g} {b}`")),
        _ if is_color && !tokens::looks_numeric(word) => error.help("write red, green and blue as numbers from 0 to 1"),
        _ if tokens::looks_numeric(word) => error.help("numbers look like `12`, `-0.5` or `1.5e-3`"),
        _ => error,
    })
}
