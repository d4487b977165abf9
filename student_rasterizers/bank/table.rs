//! The table: fault, what the grader said, and the sums.

use super::judge::{Graded, Outcome};
use std::fmt::Write;

/// Counts over a table.
pub struct Sums {
    /// Faults.
    pub faults: usize,
    /// Faults named right.
    pub named: usize,
    /// Right ones.
    pub right: usize,
    /// Right ones that were accused.
    pub accused: usize,
    /// Faults with a witness.
    pub witnesses: usize,
    /// Of at most two polygons on at most 16 x 16 pixels.
    pub small: usize,
}

impl Sums {
    /// Counts.
    pub fn of(graded: &[Graded]) -> Sums {
        let count = |is: &dyn Fn(&Graded) -> bool| graded.iter().filter(|one| is(one)).count();
        let is_small = |&(polygons, width, height): &(usize, u32, u32)| polygons <= 2 && width <= 16 && height <= 16;
        Sums {
            faults: count(&|one| !one.entry.right),
            named: count(&|one| matches!(one.outcome, Outcome::Named | Outcome::NamedInPart)),
            right: count(&|one| one.entry.right),
            accused: count(&|one| one.outcome == Outcome::Accused),
            witnesses: count(&|one| !one.entry.right && one.report.witness.is_some()),
            small: count(&|one| !one.entry.right && one.report.witness.as_ref().is_some_and(is_small)),
        }
    }

    /// Of the faults, those named right; 0 to 1.
    pub fn share_named(&self) -> f64 {
        self.named as f64 / self.faults.max(1) as f64
    }
}

fn word(outcome: Outcome) -> &'static str {
    match outcome {
        Outcome::Clean => "clean",
        Outcome::Accused => "ACCUSED",
        Outcome::Named => "named",
        Outcome::NamedInPart => "named, a rest",
        Outcome::Misnamed => "misnamed",
        Outcome::Unexplained => "unexplained",
        Outcome::NotFound => "not found",
    }
}

/// Names and words; of what is unexplained, the first.
fn shortened(said: &[String]) -> String {
    let rest = said.iter().filter(|word| word.starts_with('?')).count();
    let first = said.iter().find(|word| word.starts_with('?'));
    let words = said.iter().filter(|word| !word.starts_with('?')).chain(first);
    let text = words.map(|word| word.replace(['\n', '|'], " ")).collect::<Vec<_>>().join("; ");
    if rest > 1 { format!("{text}; and {} more aspects", rest - 1) } else { text }
}

/// The table in Markdown, and the sums below it.
pub fn markdown(graded: &[Graded], notices: &[String]) -> String {
    let mut text = String::from(
        "| source | slip | lab | what is wrong | the grader | verdict | witness |\n|---|---|---|---|---|---|---|\n",
    );
    for one in graded {
        let witness = one.report.witness.map_or(String::new(), |(n, w, h)| format!("{n} on {w} x {h}"));
        let entry = &one.entry;
        let _ = writeln!(
            text,
            "| {} {} | `{}` | {} | {} | {} | {} | {witness} |",
            entry.language,
            entry.source,
            entry.slip,
            entry.lab,
            entry.truth,
            shortened(&one.report.said),
            word(one.outcome),
        );
    }
    text + "\n" + &sums(graded, notices)
}

/// A line for the terminal.
pub fn line(one: &Graded) -> String {
    let entry = &one.entry;
    let witness = one.report.witness.map_or(String::from("-"), |(n, w, h)| format!("{n} on {w}x{h}"));
    let name = format!("{} {}", entry.source, entry.slip);
    format!(
        "{:6} {name:34} {:13} {:13} {witness:11} {:5.1} s  {}\n",
        entry.language,
        entry.lab,
        word(one.outcome),
        one.report.seconds,
        one.report.said.join("; ")
    )
}

/// What it comes to.
pub fn sums(graded: &[Graded], notices: &[String]) -> String {
    let sums = Sums::of(graded);
    let count = |outcome: Outcome| graded.iter().filter(|one| one.outcome == outcome).count();
    let mut text = notices.iter().fold(String::new(), |text, notice| text + notice + "\n");
    let _ = writeln!(
        text,
        "{} faults: {} named right ({:.1} %; {} of them with a rest), {} misnamed, {} unexplained, {} not found.",
        sums.faults,
        sums.named,
        100.0 * sums.share_named(),
        count(Outcome::NamedInPart),
        count(Outcome::Misnamed),
        count(Outcome::Unexplained),
        count(Outcome::NotFound)
    );
    let _ = writeln!(text, "{} right rasterizers: {} accused.", sums.right, sums.accused);
    let _ = writeln!(
        text,
        "{} witnesses: {} ({:.1} %) of at most 2 polygons on at most 16 x 16 pixels.",
        sums.witnesses,
        sums.small,
        100.0 * sums.small as f64 / sums.witnesses.max(1) as f64
    );
    text
}
