//! The verdict as JSON, for programs.

use crate::grade::verdict::{Cause, Verdict};
use serde_json::{Value, json};

/// All of it but the pictures.
#[must_use]
pub fn json(verdict: &Verdict) -> Value {
    let aspect = |aspect: &crate::grade::verdict::AspectVerdict| {
        let (kind, words) = match &aspect.cause {
            None => ("right", String::new()),
            Some(Cause::Named(fault)) => ("named", verdict.faults[*fault].name.to_string()),
            Some(Cause::FollowsFrom(fault)) => ("follows", verdict.faults[*fault].name.to_string()),
            Some(Cause::Unexplained { closest, .. }) => ("unexplained", (*closest).to_string()),
            Some(Cause::Other(words)) => ("other", words.clone()),
        };
        let witness = aspect.witness.as_ref().map(|witness| {
            json!({
                "polygons": witness.case.faces.len(), "width": witness.case.width, "height": witness.case.height,
                "wrong": witness.wrong, "first": [witness.first.0, witness.first.1], "rows": witness.rows,
            })
        });
        json!({
            "name": aspect.name, "points": aspect.earned, "most": aspect.most, "wrong": aspect.wrong(), "judged": aspect.judged(),
            "verdict": kind, "cause": words, "witness": witness,
            "smallest": aspect.answers.as_ref().map(|answers| answers.witness.as_str()),
        })
    };
    let fault = |fault: &crate::grade::Fault| {
        json!({
            "name": fault.name, "cause": fault.cause, "rule": fault.rule, "read": fault.read,
            "explained": fault.explained, "of": fault.total, "accepted": fault.is_accepted,
        })
    };
    json!({
        "schema": 1, "lab": verdict.lab, "subject": verdict.subject, "whole": verdict.is_whole, "passed": verdict.is_passed(),
        "points": verdict.earned(), "most": verdict.most(), "seconds": verdict.seconds, "notes": verdict.notes,
        "faults": verdict.faults.iter().map(fault).collect::<Vec<_>>(),
        "aspects": verdict.aspects.iter().map(aspect).collect::<Vec<_>>(),
    })
}
