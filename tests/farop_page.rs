//! `docs/farop.md` promises a command for every sentence of the paper: no row is empty, and every command runs.

#[path = "support/command.rs"]
mod command;

use command::Desk;
use std::path::Path;

/// What stands between backticks, in order.
fn code_spans(text: &str) -> impl Iterator<Item = &str> {
    text.split('`').skip(1).step_by(2)
}

/// The rows of all tables, as their cells; headings and rules left out.
fn rows(page: &str) -> Vec<Vec<&str>> {
    let lines = page.lines().filter(|line| line.starts_with('|') && !line.starts_with("|---"));
    let rows = lines.map(|line| line.trim_matches('|').split('|').map(str::trim).collect::<Vec<_>>());
    rows.filter(|cells| !matches!(cells.last(), Some(&("Shown by" | "Function")))).collect()
}

/// The same command on a picture small enough for a test.
fn small(command: &str) -> String {
    let draws = ["farop render", "farop dump", "farop suite"].iter().any(|start| command.starts_with(start));
    let size = if draws && !command.contains("--size") { " --size 40" } else { "" };
    format!("{}{size}", command.trim_start_matches("farop ").replace("--size 1024", "--size 64"))
}

/// `command` with `option` in place of the same option, if it has it.
fn with_option(command: &str, option: &str) -> String {
    let flag = option.split([' ', '=']).next().unwrap_or(option);
    let mut words: Vec<&str> = command.split(' ').collect();
    if let Some(place) = words.iter().position(|&word| word == flag) {
        let has_value = words.get(place + 1).is_some_and(|next| !next.starts_with('-'));
        words.drain(place..=place + usize::from(has_value));
    }
    format!("{} {option}", words.join(" "))
}

#[test]
fn no_row_is_empty_and_every_command_runs() {
    let project = Path::new(env!("CARGO_MANIFEST_DIR"));
    let page = std::fs::read_to_string(project.join("docs/farop.md")).expect("the page is there");
    let desk = Desk::new();
    std::fs::create_dir(desk.path("scenes")).expect("a folder");
    for entry in std::fs::read_dir(project.join("scenes")).expect("scenes are there").flatten() {
        std::fs::copy(entry.path(), desk.path("scenes").join(entry.file_name())).expect("copied");
    }
    let rows = rows(&page);
    assert!(rows.len() > 60, "{}", rows.len());
    let mut done = std::collections::BTreeSet::new();
    for cells in &rows {
        let shown = cells.last().copied().unwrap_or_default();
        assert!(!shown.is_empty(), "{cells:?}");
        let mut last = "farop render spd:balls:1 -o a.png".to_string();
        for span in code_spans(shown) {
            let command = match span {
                // Student programs and tests have checks of their own; this one's name must exist.
                _ if span.starts_with("cargo test --test ") => {
                    let name = span.rsplit(' ').next().unwrap_or_default();
                    assert!(project.join(format!("tests/{name}.rs")).exists(), "{span}");
                    continue;
                }
                _ if span.starts_with("farop student") => continue,
                _ if span.starts_with("farop ") => {
                    last = span.to_string();
                    span.to_string()
                }
                // Options alone go with the command before them.
                _ if span.starts_with('-') && last.starts_with("farop render") => with_option(&last, span),
                _ => continue,
            };
            if done.insert(command.clone()) {
                desk.done(&small(&command));
            }
        }
    }
    assert!(done.len() > 50, "{}", done.len());
}

#[test]
fn links_lead_somewhere() {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs");
    let page = std::fs::read_to_string(docs.join("farop.md")).expect("the page is there");
    for target in page.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
        assert!(docs.join(target).exists(), "{target}");
    }
}
