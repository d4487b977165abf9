//! Refusals: statements that are well formed and make no sense.

use std::ops::RangeInclusive;

/// A statement that is well formed and makes no sense.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Nonsense {
    /// What is wrong.
    pub(super) message: String,
    /// Which words of the statement say so; 0 is the keyword.
    pub(super) words: RangeInclusive<usize>,
    /// What to write instead.
    pub(super) help: &'static str,
}

/// A refusal of some words of a statement.
pub(super) fn refuse<T>(
    words: RangeInclusive<usize>,
    message: impl Into<String>,
    help: &'static str,
) -> Result<T, Nonsense> {
    Err(Nonsense { message: message.into(), words, help })
}
