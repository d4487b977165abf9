//! Causes: a short name for why an aspect is wanting, the same for every student who did the same.
//!
//! A report to one student has places and numbers in it; a class is counted by names.

use super::confined::Confined;
use crate::grade::verdict::{AspectVerdict, Cause, Verdict};
use crate::grade::watch;

/// What complaints contain, and what they are called.
const COMPLAINTS: [(&str, &str); 7] = [
    ("fragments were put outside", "puts fragments outside the picture"),
    ("something is kept between calls", "kept from picture to picture"),
    ("the picture depends on the order", "depends on the order of the list"),
    ("reads depth", "reads depth: this is a z-buffer"),
    ("puts a sample more than once", "puts a sample more than once"),
    ("not in scan-line order", "not in scan-line order"),
    ("every sample of the picture is asked", "looks at the whole picture for every polygon"),
];

/// The short name of an aspect's cause; empty where nothing is wrong.
pub(super) fn of(aspect: &AspectVerdict, verdict: &Verdict, subject: Option<&Confined>) -> String {
    match &aspect.cause {
        None => String::new(),
        Some(Cause::Named(fault) | Cause::FollowsFrom(fault)) => verdict.faults[*fault].name.to_string(),
        Some(Cause::Unexplained { .. }) => "unexplained".to_string(),
        Some(Cause::Other(words)) => {
            // Who never drew is not quick either, for the same reason.
            let all = verdict.aspects.iter().flat_map(|aspect| &aspect.shots).filter(|_| words == watch::NOTHING);
            let failed = aspect.shots.iter().chain(all).find_map(|shot| shot.answer.as_ref().err());
            let failure = failed.and_then(|failure| subject?.failure(&failure.message));
            let complaint = COMPLAINTS.iter().find(|(part, _)| words.contains(part)).map(|(_, name)| *name);
            failure.or(complaint).unwrap_or("other").to_string()
        }
    }
}
