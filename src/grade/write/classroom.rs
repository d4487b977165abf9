//! GitHub Classroom: JSON in base64, the output `result` of a step, which the reporter reads as `<ID>_RESULTS`.
//!
//! The reporter sums the tests' scores, or in some releases counts the tests that passed: both read the same file, so a course that needs the points of
//! the rubric to the digit takes them from `--json` or from Gradescope's file.
//!
//! Source: the graders and the reporter of github.com/classroom-resources, as read in 2026.

use super::base64::base64;
use super::results::{Entry, Results, Status};
use serde_json::{Value, json};

/// The grade, whole or not, as the reporter takes it, before base64.
#[must_use]
pub fn classroom_json<'a>(results: impl Into<Results<'a>>) -> Value {
    let results: Results<'a> = results.into();
    let entries = results.entries();
    let broken = results.refused.is_some() || (results.visible.is_whole && results.visible.is_blank());
    let command = format!("farop grade {} -r {}", results.visible.lab, results.visible.subject);
    let test = |entry: &Entry<'_>| {
        let passed = entry.status == Status::Passed;
        json!({
            "name": entry.name,
            "status": word(entry.status),
            "message": if passed { String::new() } else { entry.text() },
            "test_code": command,
            "filename": "",
            "line_no": 0,
            "execution_time": format!("{:.3}s", entry.aspect.seconds),
            "score": entry.aspect.earned,
        })
    };
    let status = match (broken, results.is_passed()) {
        (true, _) => "error",
        (_, true) => "pass",
        _ => "fail",
    };
    json!({
        "version": 1,
        "status": status,
        "max_score": results.most(),
        "tests": entries.iter().map(test).collect::<Vec<_>>(),
    })
}

/// [`classroom_json`] as the step's output wants it: base64 on one line.
#[must_use]
pub fn classroom<'a>(results: impl Into<Results<'a>>) -> String {
    base64(classroom_json(results).to_string().as_bytes()) + "\n"
}

fn word(status: Status) -> &'static str {
    match status {
        Status::Passed => "pass",
        Status::Failed | Status::NotYet => "fail",
        Status::Broken => "error",
    }
}
