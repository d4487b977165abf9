//! JUnit in the dialect of Jenkins: a suite for visible probes and one for hidden ones, a test case an aspect.
//!
//! A wrong picture is a failure, no picture at all an error, and what was not asked yet is skipped.

use super::results::{Entry, Results, Status};
use std::fmt::Write;

/// The grade as an XML text.
#[must_use]
pub fn junit<'a>(results: impl Into<Results<'a>>) -> String {
    let results: Results<'a> = results.into();
    let entries = results.entries();
    let mut text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n".to_string();
    for is_hidden in [false, true] {
        let entries: Vec<_> = entries.iter().filter(|entry| entry.is_hidden_probe == is_hidden).collect();
        if !entries.is_empty() {
            suite(&entries, &results, &mut text);
        }
    }
    text + "</testsuites>\n"
}

fn suite(entries: &[&Entry<'_>], results: &Results<'_>, text: &mut String) {
    let count = |status: Status| entries.iter().filter(|entry| entry.status == status).count();
    let verdict = entries[0].verdict;
    let name =
        escaped(&if entries[0].is_hidden_probe { format!("{} hidden", verdict.lab) } else { verdict.lab.into() });
    // Writing to a String cannot fail.
    let _ = writeln!(
        text,
        "  <testsuite name=\"{name}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\" time=\"{:.3}\">",
        entries.len(),
        count(Status::Failed),
        count(Status::Broken),
        count(Status::NotYet),
        verdict.seconds
    );
    for entry in entries {
        case(entry, &name, text);
    }
    let heading = results.heading();
    if !heading.is_empty() {
        let _ = writeln!(text, "    <system-out>{}</system-out>", escaped(&heading));
    }
    *text += "  </testsuite>\n";
}

fn case(entry: &Entry<'_>, suite: &str, text: &mut String) {
    let aspect = entry.aspect;
    let _ = write!(
        text,
        "    <testcase classname=\"{suite}\" name=\"{}\" time=\"{:.3}\"",
        escaped(&entry.name),
        aspect.seconds
    );
    let tag = match entry.status {
        Status::Passed => return *text += "/>\n",
        Status::NotYet => return *text += "><skipped message=\"not yet\"/></testcase>\n",
        Status::Failed => "failure",
        Status::Broken => "error",
    };
    let _ = writeln!(
        text,
        ">\n      <{tag} message=\"{:.1} of {:.1} points\">{}</{tag}>\n    </testcase>",
        aspect.earned,
        aspect.most,
        escaped(&entry.text())
    );
}

/// Without the characters that XML keeps for itself, and without those it forbids.
fn escaped(text: &str) -> String {
    let is_allowed = |letter: &char| {
        !letter.is_control() && !matches!(letter, '\u{FFFE}' | '\u{FFFF}') || matches!(letter, '\n' | '\t')
    };
    text.chars().filter(is_allowed).fold(String::new(), |mut escaped, letter| {
        match letter {
            '&' => escaped += "&amp;",
            '<' => escaped += "&lt;",
            '>' => escaped += "&gt;",
            '"' => escaped += "&quot;",
            other => escaped.push(other),
        }
        escaped
    })
}
