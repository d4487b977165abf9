//! Mistakes about lines whose ends are made whole before they are stepped.

use super::words::WHOLE;
use super::{Mutant, ends, mutant};
use crate::grade::lines::rule::{Ask, Ends, StepEnds, Walk};

/// Ends made whole: what the ends become, and which of the columns are shown.
macro_rules! whole {
    ($($ends:expr => $walk:expr),+ $(,)?) => {
        [$(mutant(WHOLE, |rules| (rules.lines.ends, rules.lines.walk) = ($ends, $walk))),+]
    };
}

pub(super) const WHOLE_ENDS: &[Mutant] = &whole![
    Ends::Center(0.0) => ends(StepEnds::All),
    Ends::Center(0.0) => ends(StepEnds::AllOfLong),
    Ends::Center(0.0) => ends(StepEnds::NotLast),
    Ends::Center(0.0) => ends(StepEnds::NotFirst),
    Ends::Center(0.0) => ends(StepEnds::Neither),
    Ends::Center(0.5) => ends(StepEnds::All),
    Ends::Center(0.5) => ends(StepEnds::NotLast),
    Ends::Center(0.5) => ends(StepEnds::Neither),
    Ends::Center(1.0) => ends(StepEnds::All),
    Ends::Center(1.0) => ends(StepEnds::NotLast),
    Ends::Center(0.0) => ends(StepEnds::Middles),
    Ends::Center(0.5) => ends(StepEnds::AllOfLong),
    Ends::CenterX(0.0) => ends(StepEnds::Diamonds),
    Ends::CenterX(0.0) => ends(StepEnds::All),
    Ends::CenterY(0.0) => ends(StepEnds::Diamonds),
    Ends::CenterY(0.0) => ends(StepEnds::All),
    Ends::Whole(0.0) => Walk::Ask(Ask::RIGHT),
    Ends::Whole(0.5) => Walk::Ask(Ask::RIGHT),
    Ends::Whole(1.0) => Walk::Ask(Ask::RIGHT),
    Ends::Whole(0.0) => ends(StepEnds::Diamonds),
    Ends::Whole(0.5) => ends(StepEnds::Diamonds),
    Ends::Whole(0.0) => ends(StepEnds::All),
    Ends::Whole(0.5) => ends(StepEnds::All),
];
