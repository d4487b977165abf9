//! Gradescope's `results.json`: one test an aspect, and one more where hidden probes are asked.
//!
//! No total is written: a `score` at the top would override the sum of the tests, which is it. One hidden test hides the total from
//! students, as the platform says.
//!
//! Source: gradescope/autograder_samples, docs/specs.md.

use super::results::{Entry, Results, Status};
use crate::grade::rubric::Visibility;
use crate::grade::verdict::Cause;
use serde_json::{Value, json};

/// The grade, whole or not, as Gradescope takes it.
#[must_use]
pub fn gradescope<'a>(results: impl Into<Results<'a>>) -> Value {
    let results: Results<'a> = results.into();
    let entries = results.entries();
    // What the grader prints says how hidden probes ended.
    let tells_hidden = results.hidden.is_some() || entries.iter().any(|entry| entry.visibility != Visibility::Visible);
    let verdict = results.visible;
    let mut value = json!({
        "execution_time": results.seconds(),
        "output": results.heading(),
        "output_format": "text",
        "test_output_format": "text",
        "test_name_format": "text",
        "visibility": "visible",
        "stdout_visibility": if tells_hidden { "hidden" } else { "visible" },
        "tests": entries.iter().map(test).collect::<Vec<_>>(),
        "extra_data": {
            "schema": 1, "lab": verdict.lab, "subject": verdict.subject, "whole": results.is_whole(), "sandbox": results.layers,
            "mistakes": verdict.faults.iter().map(|fault| fault.name).collect::<Vec<_>>(),
        },
    });
    if results.leaderboard {
        let of = |count: fn(&crate::grade::Verdict) -> usize| {
            [Some(verdict), results.hidden].into_iter().flatten().map(count).sum::<usize>()
        };
        let wrong = of(|verdict| verdict.aspects.iter().map(|aspect| aspect.wrong()).sum());
        value["leaderboard"] = json!([
            { "name": "points", "value": rounded(results.earned()), "order": "desc" },
            { "name": "wrong", "value": wrong, "order": "asc" },
        ]);
    }
    value
}

fn test(entry: &Entry<'_>) -> Value {
    let aspect = entry.aspect;
    let kind = match &aspect.cause {
        None => "right",
        Some(Cause::Named(_)) => "named",
        Some(Cause::FollowsFrom(_)) => "follows",
        Some(Cause::Unexplained { .. }) => "unexplained",
        Some(Cause::Other(_)) => "other",
    };
    json!({
        "name": entry.name,
        "name_format": "text",
        "number": entry.number,
        "score": aspect.earned,
        "max_score": aspect.most,
        "status": if entry.status == Status::Passed { "passed" } else { "failed" },
        "output": if entry.status == Status::NotYet { "not yet".to_string() } else { entry.text() },
        "output_format": "text",
        "visibility": entry.visibility.name(),
        "tags": [entry.verdict.lab, if entry.is_hidden_probe { "hidden probes" } else { "visible probes" }],
        "extra_data": { "wrong": aspect.wrong(), "judged": aspect.judged(), "unit": aspect.unit(), "verdict": kind, "seconds": aspect.seconds },
    })
}

fn rounded(points: f64) -> f64 {
    (points * 100.0).round() / 100.0
}
