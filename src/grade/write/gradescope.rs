//! Gradescope's `results.json`: one test an aspect.
//!
//! Fields as in gradescope/autograder_samples, docs/specs.md. No total is written: the sum of the tests is it.

use super::text::aspect_text;
use crate::grade::verdict::Verdict;
use serde_json::{Value, json};

/// The verdict, whole or not, as Gradescope takes it.
#[must_use]
pub fn gradescope(verdict: &Verdict) -> Value {
    let test = |(index, aspect): (usize, &crate::grade::verdict::AspectVerdict)| {
        json!({
            "name": aspect.name,
            "number": format!("{}", index + 1),
            "score": aspect.earned,
            "max_score": aspect.most,
            "status": if aspect.earned >= aspect.most { "passed" } else { "failed" },
            "output": aspect_text(aspect, verdict),
            "output_format": "text",
            "visibility": "visible",
        })
    };
    json!({
        "execution_time": verdict.seconds,
        "output": if verdict.is_whole { String::new() } else { "The grader was stopped before its end; what was earned until then counts.".to_string() },
        "output_format": "text",
        "stdout_visibility": "visible",
        "tests": verdict.aspects.iter().enumerate().map(test).collect::<Vec<_>>(),
        "extra_data": { "lab": verdict.lab, "subject": verdict.subject, "whole": verdict.is_whole },
    })
}
