//! Ranking: what the class got wrong, the commonest first, computed from saved verdicts alone.
//!
//! verdicts -RANKING-> `class.json`, and the summary on the terminal
//!
//! A cause is counted once a submission, under the aspect where it shows first; what follows from it is lost with it. Nothing here depends on
//! time or on who was graded first: a class that was stopped and resumed has the same file.

use serde_json::{Map, Value, json};
use std::collections::BTreeMap;
use std::fmt::Write;

/// One cause over the class.
#[derive(Clone, Debug, Default)]
struct Ranked {
    about: Map<String, Value>,
    submissions: Vec<String>,
    points_lost: f64,
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or(0.0)
}

fn text<'a>(value: &'a Value, key: &str) -> &'a str {
    value[key].as_str().unwrap_or_default()
}

fn aspects(verdict: &Value) -> impl Iterator<Item = &Value> {
    verdict["aspects"].as_array().into_iter().flatten()
}

/// The class, from its verdicts; `head` has the fields that are not in them.
#[must_use]
pub fn class(verdicts: &[Value], head: &Value) -> Value {
    let mut class = head.clone();
    class["schema"] = 1.into();
    class["most"] = verdicts.first().map_or(Value::from(0.0), |verdict| verdict["most"].clone());
    class["submissions"] = verdicts.iter().map(submission).collect();
    class["causes"] = causes(verdicts);
    class["aspects"] = by_aspect(verdicts);
    class["points"] = points(verdicts);
    class
}

/// Short names of a submission's causes, in the order of its aspects; what is accepted is none.
fn causes_of(verdict: &Value) -> Vec<&str> {
    let mut names: Vec<&str> = Vec::new();
    for aspect in aspects(verdict).filter(|aspect| number(&aspect["share"]) < 1.0) {
        let name = text(aspect, "short");
        if !name.is_empty() && !names.contains(&name) {
            names.push(name);
        }
    }
    names
}

fn submission(verdict: &Value) -> Value {
    let about = &verdict["submission"];
    json!({
        "key": about["key"], "source": about["source"], "name": about["name"], "id": about["id"], "email": about["email"],
        "door": about["door"], "status": about["status"], "points": verdict["points"], "most": verdict["most"],
        "passed": verdict["passed"], "causes": causes_of(verdict),
        "verdict": format!("submissions/{}/verdict.json", text(about, "key")),
    })
}

fn causes(verdicts: &[Value]) -> Value {
    let mut all: BTreeMap<&str, Ranked> = BTreeMap::new();
    for verdict in verdicts {
        for name in causes_of(verdict) {
            let ranked = all.entry(name).or_default();
            ranked.submissions.push(text(&verdict["submission"], "key").to_string());
            let of_this = |aspect: &&Value| text(aspect, "short") == name;
            for aspect in aspects(verdict).filter(of_this) {
                ranked.points_lost += number(&aspect["most"]) - number(&aspect["points"]);
            }
            if ranked.about.is_empty() {
                ranked.about = about(verdict, name);
            }
        }
    }
    let mut ranked: Vec<_> = all.into_iter().collect();
    // The map is sorted by name, and this sort keeps the order of equals.
    ranked.sort_by(|(_, a), (_, b)| {
        let counts = b.submissions.len().cmp(&a.submissions.len());
        counts.then(b.points_lost.total_cmp(&a.points_lost))
    });
    let value = |(name, ranked): (&str, Ranked)| {
        let mut value = ranked.about;
        value.insert("cause".to_string(), name.into());
        value.insert("submissions".to_string(), ranked.submissions.into());
        // Sums in another order differ in their last digits.
        value.insert("points_lost".to_string(), rounded(ranked.points_lost));
        Value::Object(value)
    };
    ranked.into_iter().map(value).collect()
}

fn rounded(value: f64) -> Value {
    ((value * 1e6).round() / 1e6).into()
}

/// What is to say about a cause, from the first verdict that has it.
fn about(verdict: &Value, name: &str) -> Map<String, Value> {
    let faults = verdict["faults"].as_array();
    let fault = faults.into_iter().flatten().find(|fault| fault["name"] == name);
    let first = aspects(verdict).find(|aspect| text(aspect, "short") == name);
    let kind = match (fault, name) {
        (Some(_), _) => "named",
        (None, "unexplained") => "unexplained",
        _ => "other",
    };
    let of_fault = |key: &str| fault.map_or("", |fault| text(fault, key));
    let entries = [
        ("kind", kind),
        ("why", of_fault("cause")),
        ("rule", of_fault("rule")),
        ("read", of_fault("read")),
        ("aspect", first.map_or("", |aspect| text(aspect, "name"))),
    ];
    entries.into_iter().map(|(key, value)| (key.to_string(), value.into())).collect()
}

fn by_aspect(verdicts: &[Value]) -> Value {
    let Some(first) = verdicts.first() else { return json!([]) };
    let one = |(index, aspect): (usize, &Value)| {
        let earned = verdicts.iter().map(|verdict| number(&verdict["aspects"][index]["points"]));
        let right = verdicts.iter().filter(|verdict| number(&verdict["aspects"][index]["share"]) >= 1.0).count();
        json!({
            "name": aspect["name"], "most": aspect["most"], "mean": rounded(earned.sum::<f64>() / verdicts.len() as f64),
            "right": right, "wanting": verdicts.len() - right,
        })
    };
    aspects(first).enumerate().map(one).collect()
}

fn points(verdicts: &[Value]) -> Value {
    let mut all: Vec<f64> = verdicts.iter().map(|verdict| number(&verdict["points"])).collect();
    all.sort_by(f64::total_cmp);
    let count = all.len();
    let median = if count == 0 { 0.0 } else { (all[(count - 1) / 2] + all[count / 2]) / 2.0 };
    json!({
        "submissions": count, "passed": verdicts.iter().filter(|verdict| verdict["passed"] == true).count(),
        "least": all.first().copied().unwrap_or(0.0), "median": median,
        "mean": rounded(all.iter().sum::<f64>() / count.max(1) as f64), "most": all.last().copied().unwrap_or(0.0),
    })
}

/// The class on the terminal: a line a submission, then the mistakes.
#[must_use]
pub fn summary(class: &Value) -> String {
    let mut out = String::new();
    let rows = |key: &str| class[key].as_array().cloned().unwrap_or_default();
    for row in rows("submissions") {
        let causes: Vec<_> = row["causes"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
        let name = shown(text(&row, "name"), 28);
        let (points, most) = (number(&row["points"]), number(&row["most"]));
        let said = if causes.is_empty() { "right".to_string() } else { causes.join("; ") };
        let _ = writeln!(out, "  {points:>6.1} /{most:>4}  {name:<28}  {said}");
    }
    let _ = writeln!(out, "\nmistakes of the class:");
    for row in rows("causes") {
        let count = row["submissions"].as_array().map_or(0, Vec::len);
        let _ = writeln!(out, "  {count:>5}  {:>7.1} points  {}", number(&row["points_lost"]), text(&row, "cause"));
    }
    let points = &class["points"];
    let _ = writeln!(
        out,
        "\n{} submissions, {} with all points; mean {:.1}, median {:.1} of {}",
        points["submissions"],
        points["passed"],
        number(&points["mean"]),
        number(&points["median"]),
        number(&class["most"])
    );
    out
}

/// A name as it may stand in a table: one line, nothing that moves a cursor.
fn shown(name: &str, most: usize) -> String {
    name.chars().map(|letter| if letter.is_control() { '?' } else { letter }).take(most).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn verdict(key: &str, shares: [(f64, &str); 2]) -> Value {
        let aspect = |(share, short): (f64, &str)| json!({"name": "a", "most": 10.0, "points": share * 10.0, "share": share, "short": short});
        json!({
            "submission": {"key": key, "name": "An\u{1b}a"}, "points": (shares[0].0 + shares[1].0) * 10.0, "most": 20.0,
            "passed": shares[0].0 + shares[1].0 == 2.0, "aspects": shares.map(aspect), "faults": [{"name": "corner", "cause": "because"}],
        })
    }

    #[test]
    fn causes_are_ranked_and_what_is_right_has_none() {
        let all = [
            verdict("a", [(1.0, ""), (0.5, "corner")]),
            verdict("b", [(0.0, "time-out"), (0.0, "time-out")]),
            verdict("c", [(1.0, "tie accepted"), (1.0, "")]),
            verdict("d", [(0.9, "corner"), (1.0, "")]),
        ];
        let class = class(&all, &json!({"lab": "x"}));
        let names: Vec<_> =
            class["causes"].as_array().expect("a list").iter().map(|cause| text(cause, "cause")).collect();
        assert_eq!(names, ["corner", "time-out"]);
        assert_eq!((&class["causes"][0]["points_lost"], &class["causes"][0]["kind"]), (&json!(6.0), &json!("named")));
        assert_eq!((&class["points"]["median"], &class["points"]["passed"]), (&json!(17.0), &json!(1)));
        let text = summary(&class);
        assert!(text.contains("An?a") && !text.contains("tie") && !text.contains('\u{1b}'), "{text}");
    }
}
