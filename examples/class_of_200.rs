//! The class of 200: hanging, crashing, flooding, forking and cheating submissions among ordinary ones, graded to the end.
//!
//! ```text
//! cargo run --release --example class_of_200 [-- COUNT [JOBS]]
//! ```
//! Writes the class into a temporary folder, grades it with the `farop` beside this program, holds every grade against what
//! the submission is worth, looks for what was left behind, and prints time and memory.

#[path = "../tests/support/unruly.rs"]
mod unruly;

use std::path::PathBuf;
use std::process::Command;
use std::time::Instant;
use unruly::{Kind, Places};

fn main() {
    let numbers: Vec<usize> = std::env::args().skip(1).filter_map(|word| word.parse().ok()).collect();
    let (count, jobs) = (numbers.first().copied().unwrap_or(200), numbers.get(1).copied().unwrap_or(2));
    let desk = tempfile::Builder::new().prefix("class-of-200-").tempdir().expect("a folder");
    let places = Places::new(desk.path());
    let kinds: Vec<Kind> = unruly::ordinary().into_iter().chain(unruly::unruly(&places)).collect();
    let written: Vec<(&Kind, String)> = (0..count)
        .map(|number| {
            let kind = &kinds[number % kinds.len()];
            (kind, unruly::write(kind, number, &places))
        })
        .collect();
    let program = farop();
    let (start, jobs) = (Instant::now(), jobs.to_string());
    let status = Command::new(&program)
        .args(["grade", "zbuffer", "--class", "submissions", "--jobs", &jobs])
        .current_dir(desk.path())
        .status()
        .expect("farop starts");
    let seconds = start.elapsed().as_secs_f64();
    let text = std::fs::read(places.results.join("class.json")).expect("the class was graded");
    let class: serde_json::Value = serde_json::from_slice(&text).expect("whole JSON");
    let rows = class["submissions"].as_array().cloned().unwrap_or_default();
    let mut wrong = Vec::new();
    for (kind, source) in &written {
        match rows.iter().find(|row| row["source"] == source.as_str()) {
            Some(row) => wrong.extend(unruly::complaint(kind, row, &places)),
            None => wrong.push(format!("{source:?} has no grade")),
        }
    }
    wrong.dedup();
    println!(
        "\n{count} submissions of {} kinds, {jobs} at a time: {seconds:.0} s, exit code {:?}",
        kinds.len(),
        status.code()
    );
    println!("peak memory of the grader, of its largest child: {}", memory());
    println!("layers: {}", class["sandbox"]);
    println!("grades that are not as expected: {}", wrong.len());
    wrong.iter().for_each(|line| println!("  {line}"));
    println!("files left by attacks: {:?}", places.left_behind());
    println!("processes left: {:?}", processes());
    let is_bad = !wrong.is_empty() || !places.left_behind().is_empty() || !processes().is_empty();
    // `exit` would leave the folder behind.
    drop(desk);
    std::process::exit(i32::from(is_bad));
}

/// The program two folders up: examples lie in `target/PROFILE/examples`.
fn farop() -> PathBuf {
    let own = std::env::current_exe().expect("a program");
    let folder = own.parent().and_then(|folder| folder.parent()).expect("target/PROFILE");
    folder.join("farop")
}

/// What the system says of all children that have ended: the largest of them.
#[cfg(unix)]
fn memory() -> String {
    use nix::sys::resource::{UsageWho, getrusage};
    let usage = getrusage(UsageWho::RUSAGE_CHILDREN);
    usage.map_or("unknown".to_string(), |usage| format!("{} MB", usage.max_rss() / 1024))
}

#[cfg(not(unix))]
fn memory() -> String {
    "unknown".to_string()
}

/// Command lines of processes that were started in a cell and still run.
fn processes() -> Vec<String> {
    let entries = std::fs::read_dir("/proc").into_iter().flatten().flatten();
    let lines = entries.filter_map(|entry| std::fs::read(entry.path().join("cmdline")).ok());
    let lines = lines.map(|line| String::from_utf8_lossy(&line).replace('\0', " "));
    lines.filter(|line| line.contains("farop-class-")).collect()
}
