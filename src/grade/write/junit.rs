//! JUnit: one suite, a test case an aspect.

use super::text::aspect_text;
use crate::grade::verdict::Verdict;
use std::fmt::Write;

/// The verdict as an XML text.
#[must_use]
pub fn junit(verdict: &Verdict) -> String {
    let failures = verdict.aspects.iter().filter(|aspect| aspect.earned < aspect.most).count();
    let (lab, count) = (escaped(verdict.lab), verdict.aspects.len());
    let mut text = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n  <testsuite name=\"{lab}\" tests=\"{count}\" failures=\"{failures}\" \
         errors=\"0\" time=\"{:.3}\">\n",
        verdict.seconds
    );
    for aspect in &verdict.aspects {
        let _ = write!(text, "    <testcase classname=\"{lab}\" name=\"{}\"", escaped(aspect.name));
        if aspect.earned >= aspect.most {
            text += "/>\n";
            continue;
        }
        let words = escaped(&aspect_text(aspect, verdict));
        let _ = writeln!(
            text,
            ">\n      <failure message=\"{:.1} of {:.1} points\">{words}</failure>\n    </testcase>",
            aspect.earned, aspect.most
        );
    }
    text + "  </testsuite>\n</testsuites>\n"
}

/// Without the characters that XML keeps for itself, and without those it forbids.
fn escaped(text: &str) -> String {
    let allowed = text.chars().filter(|letter| !letter.is_control() || matches!(letter, '\n' | '\t'));
    allowed.fold(String::new(), |mut escaped, letter| {
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
