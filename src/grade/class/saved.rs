//! Saved: a verdict as `verdict.json`, and the same with other points.
//!
//! Graded -SAVED-> JSON; JSON, rubric -RESCORED-> JSON
//!
//! Why shares and not points are the truth of the file: points are a matter of the rubric, which an instructor changes after the deadline.

use super::roster::Submission;
use super::{Class, Graded};
use crate::grade::labs::Lab;
use crate::grade::rubric::Rubric;
use crate::grade::write;
use serde_json::{Value, json};

/// The verdict on a submission: what `farop grade --json` prints, and what a class needs besides. `docs/class.md` lists the fields.
pub(super) fn saved(graded: &Graded, submission: &Submission, (class, fingerprint): (&Class<'_>, &str)) -> Value {
    let mut value = write::json(&graded.verdict);
    let aspects = graded.verdict.aspects.iter().zip(&graded.causes);
    for (index, (aspect, cause)) in aspects.enumerate() {
        let saved = &mut value["aspects"][index];
        saved["share"] = aspect.earned.into();
        saved["short"] = cause.as_str().into();
        let is_wanting = aspect.cause.is_some();
        saved["text"] = if is_wanting { write::aspect_text(aspect, &graded.verdict).into() } else { "".into() };
    }
    let Submission { key, source, name, id, email, origin, .. } = submission;
    value["submission"] = json!({
        "key": key, "source": source, "name": name, "id": id, "email": email, "origin": origin, "door": graded.door,
        "status": graded.status.name(), "files": graded.files, "fingerprint": fingerprint,
    });
    value["seed"] = class.seed.into();
    value["sandbox"] = json!({ "layers": class.sandbox.layers(), "missing": class.sandbox.missing() });
    rescored(value, class.lab, class.rubric)
}

/// A saved verdict with the points of `rubric`.
#[must_use]
pub fn rescored(mut verdict: Value, lab: &Lab, rubric: &Rubric) -> Value {
    let (mut earned, mut most) = (0.0, 0.0);
    for saved in verdict["aspects"].as_array_mut().into_iter().flatten() {
        let aspect = lab.aspects.iter().find(|aspect| saved["name"] == aspect.name);
        let points = aspect.map_or(0.0, |aspect| rubric.points(aspect));
        let share = saved["share"].as_f64().unwrap_or(0.0);
        saved["points"] = (share * points).into();
        saved["most"] = points.into();
        earned += share * points;
        most += points;
    }
    verdict["points"] = earned.into();
    verdict["most"] = most.into();
    verdict["passed"] = (verdict["whole"] == true && earned >= most).into();
    verdict
}
