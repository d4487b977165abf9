//! Pages with commands and what is seen: blocks of `sh`, each followed by a block of `text` that is shortened with `...`.

#![allow(dead_code, reason = "every test binary uses a part")]

/// A block of commands, and what is to be seen behind its last one.
pub struct Step {
    pub commands: Vec<String>,
    /// Lines that must be printed, without blanks at their ends.
    pub seen: Vec<String>,
    /// What the last command ends with: `(exit code 1)` says so.
    pub code: i32,
}

/// The steps below the headline `## section`, up to the next.
pub fn steps(page: &str, section: &str) -> Vec<Step> {
    let start = page.find(&format!("\n## {section}")).unwrap_or_else(|| panic!("no section {section}")) + 1;
    let body = &page[start..];
    let body = &body[..body[1..].find("\n## ").map_or(body.len(), |end| end + 1)];
    let mut steps: Vec<Step> = Vec::new();
    let mut kind = None;
    for line in body.lines() {
        match (line.strip_prefix("```"), kind) {
            (Some(_), Some(_)) => kind = None,
            (Some("sh"), None) => {
                steps.push(Step { commands: Vec::new(), seen: Vec::new(), code: 0 });
                kind = Some("sh");
            }
            (Some(other), None) => kind = Some(if other == "text" { "text" } else { "other" }),
            (None, Some("sh")) => steps.last_mut().expect("a step").commands.push(line.to_string()),
            (None, Some("text")) if line.trim() != "..." => {
                let step = steps.last_mut().expect("commands stand before what is seen");
                match line.strip_prefix("(exit code ").and_then(|rest| rest.strip_suffix(')')) {
                    Some(code) => step.code = code.parse().expect("a number"),
                    None => step.seen.push(line.trim().to_string()),
                }
            }
            _ => {}
        }
    }
    steps
}

/// Every line of the page must be among those printed, in order; a line that ends in ` ...` goes on.
pub fn assert_seen(step: &Step, printed: &str) {
    let mut lines = printed.lines().map(str::trim);
    for expected in &step.seen {
        let is_it = |line: &str| match expected.strip_suffix(" ...") {
            Some(start) => line.starts_with(start),
            None => line == expected,
        };
        assert!(lines.any(is_it), "{:?}\n`{expected}` is not seen, or not there, in\n{printed}", step.commands);
    }
}
