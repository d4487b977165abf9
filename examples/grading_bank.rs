//! How often the grader names a fault right: grades every rasterizer of `student_rasterizers/bank`, prints the table and the sums.
//!
//! cargo run --release --example grading_bank [-- --markdown docs/grading-bank.md] [WORD]
//!
//! WORD: only entries whose language, source, slip or lab is that.

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
    let mut arguments: Vec<String> = std::env::args().skip(1).collect();
    let markdown = match arguments.iter().position(|word| word == "--markdown") {
        Some(at) if at + 1 < arguments.len() => arguments.drain(at..at + 2).nth(1),
        Some(_) => return Err("--markdown needs a file".to_string()),
        None => None,
    };
    let is_asked = |entry: &judge::Entry| {
        arguments.iter().all(|word| [&entry.language, &entry.source, &entry.slip, &entry.lab].contains(&word))
    };
    let (mut entries, mut notices) = (judge::catalogue()?, Vec::new());
    entries.retain(is_asked);
    for (language, program) in [("c", "cc"), ("python", "python3")] {
        if !kept::is_there(program) && entries.iter().any(|entry| entry.language == language) {
            notices.push(format!("Left out, because there is no `{program}`: everything in {language}."));
            entries.retain(|entry| entry.language != language);
        }
    }
    let temporary = tempfile::tempdir().map_err(|error| error.to_string())?;
    let graded = judge::grade_all(&entries, temporary.path(), |one| {
        if let Ok(one) = one {
            print!("{}", table::line(one));
        }
    })?;
    print!("\n{}", table::sums(&graded, &notices));
    if let Some(path) = markdown {
        let text = PREFACE.to_string() + &table::markdown(&graded, &notices);
        std::fs::write(&path, text).map_err(|error| format!("{path}: {error}"))?;
    }
    Ok(())
}
