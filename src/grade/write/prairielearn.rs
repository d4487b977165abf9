//! PrairieLearn's `results.json`: a score from 0 to 1, tests with points, pictures inside.
//!
//! At most a million bytes: the platform refuses more, and with it the grade. Pictures go first, the last ones before the first.
//! Where nothing could be graded at all, or not one picture came, `gradable` is false and costs no attempt.
//!
//! Source: PrairieLearn, docs/externalGrading.md.

use super::base64::png_url;
use super::results::{Results, Status};
use crate::grade::pictures;
use crate::grade::verdict::Shot;
use serde_json::{Value, json};

/// Bytes that the platform takes.
pub const MOST_BYTES: usize = 1_000_000;

/// Pictures of an aspect that are shown.
const PICTURES: usize = 3;

/// Letters of one test's text that are kept; a program may print as much as it likes.
const MOST_LETTERS: usize = 12_000;

/// The grade, whole or not, as PrairieLearn takes it.
#[must_use]
pub fn prairielearn<'a>(results: impl Into<Results<'a>>) -> Value {
    let results: Results<'a> = results.into();
    if let Some(reason) = results.refused.map(str::to_string).or_else(|| broken(&results)) {
        let message = format!("Nothing could be graded: {reason}");
        return json!({ "gradable": false, "format_errors": [reason], "score": 0.0, "message": message, "output": "", "images": [], "tests": [] });
    }
    let entries = results.entries();
    let test = |entry: &super::results::Entry<'_>| {
        let aspect = entry.aspect;
        let shown = entry.may_show() && entry.status != Status::Passed;
        let failing = aspect.shots.iter().filter(|shot| shown && !shot.is_right());
        json!({
            "name": entry.name,
            "description": aspect.asks,
            "points": aspect.earned,
            "max_points": aspect.most,
            "message": if entry.status == Status::NotYet { "not yet" } else { "" },
            "output": shortened(&entry.text()),
            "images": failing.take(PICTURES).filter_map(image).collect::<Vec<_>>(),
        })
    };
    let most = results.most();
    let mut value = json!({
        "gradable": true,
        "score": if most > 0.0 { (results.earned() / most).clamp(0.0, 1.0) } else { 1.0 },
        "message": results.heading(),
        "output": results.visible.notes.join("\n"),
        "images": [],
        "tests": entries.iter().map(test).collect::<Vec<_>>(),
    });
    limit(&mut value);
    value
}

/// Why not one picture came, where that is so: a program that does not build or does not start.
fn broken(results: &Results<'_>) -> Option<String> {
    let verdict = results.visible;
    let mut failures =
        verdict.aspects.iter().flat_map(|aspect| &aspect.shots).filter_map(|shot| shot.answer.as_ref().err());
    let failure = failures.next().filter(|_| verdict.is_whole && verdict.is_blank())?;
    Some(format!("{}\n{}", failure.message, failure.hint))
}

fn image(shot: &Shot) -> Option<Value> {
    let picture = pictures::triptych(shot)?;
    let label = format!("{}: drawn, right, difference", shot.case.name);
    Some(json!({ "label": label, "url": png_url(&pictures::png(&picture)) }))
}

fn shortened(text: &str) -> String {
    match text.char_indices().nth(MOST_LETTERS) {
        Some((end, _)) => format!("{}\n[cut here: {} bytes more]", &text[..end], text.len() - end),
        None => text.to_string(),
    }
}

/// Takes pictures away, the last ones first, until it is small enough.
fn limit(value: &mut Value) {
    let mut size = value.to_string().len();
    while size > MOST_BYTES {
        let Some(tests) = value["tests"].as_array_mut() else { return };
        let with_images = tests.iter_mut().rev().filter_map(|test| test["images"].as_array_mut());
        let Some(image) = with_images.filter(|images| !images.is_empty()).find_map(Vec::pop) else { return };
        size -= image.to_string().len();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_too_large_loses_its_last_pictures() {
        let image = |number: usize| json!({ "label": number, "url": "x".repeat(300_000) });
        let mut value = json!({ "tests": [{ "images": [image(1), image(2)] }, { "images": [image(3), image(4)] }] });
        limit(&mut value);
        assert!(value.to_string().len() <= MOST_BYTES);
        let labels = |test: usize| value["tests"][test]["images"].as_array().map(Vec::len);
        assert_eq!((labels(0), labels(1)), (Some(2), Some(1)));
    }

    #[test]
    fn long_output_is_cut_between_letters() {
        let text = shortened(&"é".repeat(MOST_LETTERS + 5));
        assert!(text.ends_with("é\n[cut here: 10 bytes more]"), "{}", &text[text.len() - 40..]);
    }
}
