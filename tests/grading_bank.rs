//! The bank of faulty rasterizers: right ones are accused of nothing, and faults are named as often as they were.

use bank::judge::{self, Clock, Entry, Outcome};
use bank::{kept, table};

#[path = "../student_rasterizers/bank/mod.rs"]
#[allow(dead_code, reason = "the table is the example's")]
mod bank;

/// Faults named right among those tested, at least: the goal. A regression bound; of the whole bank it is 95.7 % (docs/grading-bank.md).
const NAMED: f64 = 0.95;

fn graded(entries: &[Entry]) -> Vec<judge::Graded> {
    let temporary = tempfile::tempdir().expect("a temporary folder");
    judge::grade_all(entries, (temporary.path(), Clock::Unused), |_| ()).expect("everything builds")
}

/// Entries that can be graded here, with a notice about the others.
fn entries(is_asked: impl Fn(&Entry) -> bool) -> Vec<Entry> {
    let mut entries = judge::catalogue().expect("bank.toml");
    entries.retain(is_asked);
    for (language, program) in [("c", "cc"), ("python", "python3")] {
        if !kept::is_there(program) {
            println!("notice: there is no `{program}`, everything in {language} is left out");
            entries.retain(|entry| entry.language != language);
        }
    }
    entries
}

#[test]
fn right_rasterizers_are_accused_of_nothing() {
    let right = entries(|entry| entry.right);
    assert!(right.iter().filter(|entry| entry.language == "rust").count() >= 8);
    let graded = graded(&right);
    assert_eq!(graded.len(), right.len());
    for one in &graded {
        assert_eq!(one.outcome, Outcome::Clean, "{}", table::line(one));
    }
}

#[test]
fn faults_are_named_as_often_as_they_were() {
    // Every seventh of those in this process. What only a clock can tell is left to the table.
    let is_timed = |entry: &Entry| entry.names.iter().any(|name| name.contains("every sample of the picture"));
    let faults = entries(|entry| !entry.right && entry.language == "rust" && !is_timed(entry));
    let some: Vec<Entry> = faults.into_iter().step_by(7).collect();
    assert!(some.len() >= 20);
    let graded = graded(&some);
    let lines: String = graded.iter().map(table::line).collect();
    let (named, faults) = (table::Sums::of(&graded).share_named(), graded.len());
    assert!(named >= NAMED, "{:.1} % of {faults}\n{lines}{}", 100.0 * named, table::sums(&graded, &[]));
}

#[test]
fn the_catalogue_is_large_and_spread_over_all_labs() {
    let entries = judge::catalogue().expect("bank.toml");
    for lab in farop::grade::LABS {
        assert!(entries.iter().filter(|entry| entry.lab == lab.name && !entry.right).count() >= 10, "{}", lab.name);
        assert!(entries.iter().any(|entry| entry.lab == lab.name && entry.right), "{}", lab.name);
    }
    for (language, least) in [("rust", 25), ("c", 15), ("python", 15)] {
        assert!(entries.iter().filter(|entry| entry.language == language && !entry.right).count() >= least);
    }
    assert!(entries.iter().all(|entry| entry.right == entry.names.is_empty() || !entry.right));
    let mut keys: Vec<_> = entries.iter().map(Entry::key).collect();
    keys.sort();
    keys.dedup();
    assert_eq!(keys.len(), entries.len());
}
