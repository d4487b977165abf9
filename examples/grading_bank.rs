//! How often the grader names a fault right: grades every rasterizer of `student_rasterizers/bank`, prints the table and the sums.
//!
//! cargo run --release --example grading_bank [-- --markdown docs/grading-bank.md] [WORD]
//!
//! WORD: only entries whose language, source, slip or lab is that. `--save FILE` keeps what the grader said; `--from FILE` holds it against
//! the catalogue again, and draws nothing: for when a name was added to the catalogue. `--held` takes the held-out set instead of the bank,
//! `--set fresh` the set of `student_rasterizers/bank/fresh`.

use std::process::ExitCode;

#[path = "../student_rasterizers/bank/mod.rs"]
mod bank;

use bank::{judge, kept, table};

const PREFACE: &str = "# How often the grader names a fault right\n
Rasterizers with one known fault each, and right ones, graded by `farop grade`: `student_rasterizers/bank/README.md` says how and why.
*Named*: what the grader said are names that lead to the wrong line, and nothing else. *Misnamed*: another name, or one too many.
Points are those of the lab, in percent. Made by `cargo run --example grading_bank -- --markdown docs/grading-bank.md`.\n\n";

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::from(2)
        }
    }
}

fn run() -> Result<(), String> {
    let mut words: Vec<String> = std::env::args().skip(1).collect();
    let [markdown, save, from] = ["--markdown", "--save", "--from"].map(|option| taken(&mut words, option));
    let set = taken(&mut words, "--set");
    let is_held = words.iter().any(|word| word == "--held");
    words.retain(|word| word != "--held");
    let (mut entries, mut notices) = (entries(set, is_held)?, Vec::new());
    entries.retain(|entry| words.iter().all(|word| entry.key().contains(word)));
    let graded = match from {
        Some(path) => read(&path, &entries)?,
        None => {
            leave_out(&mut entries, &mut notices);
            let temporary = tempfile::tempdir().map_err(|error| error.to_string())?;
            judge::grade_all(&entries, (temporary.path(), judge::Clock::Used), |one| print!("{}", table::line(one)))?
        }
    };
    print!("\n{}", table::sums(&graded, &notices));
    if let Some(path) = save {
        let reports: Vec<_> = graded.iter().map(|one| &one.report).collect();
        write(&path, &serde_json::to_string(&reports).map_err(|error| error.to_string())?)?;
    }
    markdown.map_or(Ok(()), |path| write(&path, &(PREFACE.to_string() + &table::markdown(&graded, &notices))))
}

/// The entries of a set; without a name of the held-out one, or of the bank.
fn entries(set: Option<String>, is_held: bool) -> Result<Vec<judge::Entry>, String> {
    match set.as_deref() {
        Some("fresh") => judge::set("fresh"),
        Some(other) => Err(format!("--set {other}: there is no such set; expected fresh")),
        None if is_held => judge::held_out(),
        None => judge::catalogue(),
    }
}

/// The word behind an option; both are taken away.
fn taken(words: &mut Vec<String>, option: &str) -> Option<String> {
    let at = words.iter().position(|word| word == option)?;
    words.drain(at..(at + 2).min(words.len())).nth(1)
}

/// Leaves out languages that are not there.
fn leave_out(entries: &mut Vec<judge::Entry>, notices: &mut Vec<String>) {
    for (language, program) in [("c", "cc"), ("python", "python3")] {
        if !kept::is_there(program) && entries.iter().any(|entry| entry.language == language) {
            notices.push(format!("Left out, because there is no `{program}`: everything in {language}."));
            entries.retain(|entry| entry.language != language);
        }
    }
}

fn write(path: &str, text: &str) -> Result<(), String> {
    std::fs::write(path, text).map_err(|error| format!("{path}: {error}"))
}

/// Reports that were saved, held against the catalogue anew.
fn read(path: &str, entries: &[judge::Entry]) -> Result<Vec<judge::Graded>, String> {
    let text = std::fs::read_to_string(path).map_err(|error| format!("{path}: {error}"))?;
    let mut reports: Vec<judge::Report> = serde_json::from_str(&text).map_err(|error| error.to_string())?;
    let place = |report: &judge::Report| entries.iter().position(|entry| entry.key() == report.key);
    reports.sort_by_key(place);
    let graded = reports.into_iter().filter_map(|report| {
        let entry = &entries[place(&report)?];
        Some(judge::held_against(entry, report))
    });
    Ok(graded.collect())
}
