//! Worksheet: grades as Moodle imports them ("Upload grading worksheet").
//!
//! verdicts -WORKSHEET-> `grades.csv`
//!
//! Moodle finds its columns by these names (of its English language pack); it refuses a file without Identifier, Grade and Last modified (grade),
//! and takes the number behind `Participant ` for the student. Feedback is HTML there, so what students wrote is escaped.
//!
//! A cell that begins with `=`, `+`, `-` or `@` is a formula to a spreadsheet; names are other people's words, so such a cell gets a `'`.
//!
//! Source: Moodle, mod/assign/feedback/offline/importgradeslib.php (read, not copied).

use serde_json::Value;

const HEAD: &str = "Identifier,Full name,Email address,Status,Grade,Maximum grade,Grade can be changed,Last modified (grade),Feedback comments\r\n";

/// The worksheet of a class.
#[must_use]
pub fn worksheet(verdicts: &[Value]) -> String {
    // The mark of UTF-8: spreadsheets damage names without it, Moodle skips it.
    let mut out = format!("\u{feff}{HEAD}");
    for verdict in verdicts {
        let about = &verdict["submission"];
        let text = |key: &str| about[key].as_str().unwrap_or_default();
        let participant =
            if about["origin"] == "moodle" { format!("Participant {}", text("id")) } else { text("id").to_string() };
        let number = |key: &str| format!("{:.2}", verdict[key].as_f64().unwrap_or(0.0));
        let cells = [
            words(&participant),
            words(text("name")),
            words(text("email")),
            quoted("Submitted for grading"),
            number("points"),
            number("most"),
            quoted("Yes"),
            // No time: with one, Moodle leaves grades alone that were changed since.
            quoted("-"),
            quoted(&feedback(verdict)),
        ];
        out += &cells.join(",");
        out += "\r\n";
    }
    out
}

fn words(text: &str) -> String {
    let mark = if text.starts_with(['=', '+', '-', '@', '\t', '\r']) { "'" } else { "" };
    quoted(&format!("{mark}{text}"))
}

fn quoted(text: &str) -> String {
    let plain: String = text.chars().map(|letter| if letter.is_control() { ' ' } else { letter }).collect();
    format!("\"{}\"", plain.replace('"', "\"\""))
}

/// What is wrong, mistake by mistake, as HTML in one line.
fn feedback(verdict: &Value) -> String {
    let list = |key: &str| verdict[key].as_array().cloned().unwrap_or_default();
    let mut out = String::new();
    for aspect in list("aspects") {
        let text = |key: &str| aspect[key].as_str().unwrap_or_default().to_string();
        let (points, most) = (aspect["points"].as_f64().unwrap_or(0.0), aspect["most"].as_f64().unwrap_or(0.0));
        if points < most {
            let said =
                if text("verdict") == "follows" { format!("follows from: {}", text("cause")) } else { text("short") };
            out += &format!("<li>{} ({points:.1} of {most}): {}</li>", escaped(&text("name")), escaped(&said));
        }
    }
    for fault in list("faults").iter().filter(|fault| fault["accepted"] != true) {
        let text = |key: &str| escaped(fault[key].as_str().unwrap_or_default());
        out += &format!("<li>{}: {} {}</li>", text("name"), text("cause"), text("rule"));
    }
    if out.is_empty() { "<p>Everything is right.</p>".to_string() } else { format!("<ul>{out}</ul>") }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn what_others_wrote_does_no_harm() {
        let verdict = json!({
            "submission": {"id": "17", "name": "=cmd(\"x\")\n", "email": "a@b", "origin": "moodle"}, "points": 7.5, "most": 10.0,
            "aspects": [{"name": "ties", "points": 7.5, "most": 10.0, "short": "<script>", "verdict": "other"}], "faults": [],
        });
        let text = worksheet(&[verdict]);
        let row = text.lines().nth(1).expect("a row");
        assert!(text.starts_with("\u{feff}Identifier,Full name,Email address,Status,Grade,Maximum grade,"), "{text}");
        assert_eq!(
            row,
            "\"Participant 17\",\"'=cmd(\"\"x\"\") \",\"a@b\",\"Submitted for grading\",7.50,10.00,\"Yes\",\"-\",\
             \"<ul><li>ties (7.5 of 10): &lt;script&gt;</li></ul>\""
        );
    }
}
