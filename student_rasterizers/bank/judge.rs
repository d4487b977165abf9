//! The catalogue, and the grade of each entry held against it.

use super::kept::{self, Kept};
use super::rust::Drawer;
use farop::grade::labs::{self, Aspect, Lab, Watch};
use farop::grade::verdict::Cause;
use farop::grade::witness::Witness;
use farop::grade::{Request, Subject, Verdict, grade};
use serde::{Deserialize, Serialize};
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

/// One rasterizer of the bank.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Entry {
    /// `rust`, `c` or `python`.
    pub language: String,
    /// The file, without its ending.
    pub source: String,
    /// The change that makes it wrong; `none` for a right one.
    pub slip: String,
    /// The lab it is graded in.
    pub lab: String,
    /// What is wrong, in one sentence.
    pub truth: String,
    /// Names that send a reader to the right line. `~words` is part of a complaint that is no name.
    #[serde(default)]
    pub names: Vec<String>,
    /// Nothing is wrong with it.
    #[serde(default)]
    pub right: bool,
    /// The folder of another set than the bank, `held` or `fresh`: its programs are built and started one by one.
    #[serde(skip)]
    pub set: Option<&'static str>,
}

#[derive(Deserialize)]
struct Catalogue {
    entry: Vec<Entry>,
}

/// What the grader made of an entry.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// A right one, and nothing was found.
    Clean,
    /// A right one, and something was found.
    Accused,
    /// The fault was named, and nothing else.
    Named,
    /// The fault was named, and no other; but some wrong pixels, or a complaint, were left without it.
    NamedInPart,
    /// Another name, or one more.
    Misnamed,
    /// Wrong pixels without a name.
    Unexplained,
    /// All points.
    NotFound,
}

/// What the grader said of an entry.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct Report {
    /// Language, source, slip, lab.
    pub key: [String; 4],
    /// Names; complaints in words, with `~`; aspects left unexplained, with `?`.
    pub said: Vec<String>,
    /// All points.
    pub passed: bool,
    /// Polygons of the witness, and its width and height in pixels.
    pub witness: Option<(usize, u32, u32)>,
    /// Seconds.
    pub seconds: f64,
}

/// A graded entry.
#[derive(Clone, Debug)]
pub struct Graded {
    /// Who was graded.
    pub entry: Entry,
    /// How that went.
    pub outcome: Outcome,
    /// In the grader's words.
    pub report: Report,
}

impl Entry {
    /// Language, source, slip, lab.
    pub fn key(&self) -> [String; 4] {
        [&self.language, &self.source, &self.slip, &self.lab].map(Clone::clone)
    }
}

/// Whether the aspect that is a matter of time is graded: tests must not depend on how busy the machine is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Clock {
    /// It is.
    Used,
    /// It is left out.
    #[allow(dead_code, reason = "for tests")]
    Unused,
}

/// The entries of `bank.toml`.
pub fn catalogue() -> Result<Vec<Entry>, String> {
    read(&kept::folder().join("bank.toml"))
}

/// The entries of `held/held.toml`: nobody who improves the grader looks at them.
#[allow(dead_code, reason = "tests of the bank do not grade them")]
pub fn held_out() -> Result<Vec<Entry>, String> {
    set("held")
}

/// The entries of a set that has a folder of its own: `NAME/NAME.toml`.
#[allow(dead_code, reason = "tests of the bank do not grade them")]
pub fn set(name: &'static str) -> Result<Vec<Entry>, String> {
    let mut entries = read(&kept::folder().join(name).join(format!("{name}.toml")))?;
    entries.iter_mut().for_each(|entry| entry.set = Some(name));
    Ok(entries)
}

fn read(path: &Path) -> Result<Vec<Entry>, String> {
    let text = std::fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
    let catalogue: Catalogue = toml::from_str(&text).map_err(|error| error.to_string())?;
    Ok(catalogue.entry)
}

/// Grades entries, on two threads; `seen` is told of each at once, the result is in their order.
pub fn grade_all(
    entries: &[Entry],
    (temporary, clock): (&Path, Clock),
    seen: impl Fn(&Graded) + Sync,
) -> Result<Vec<Graded>, String> {
    let (next, results) = (AtomicUsize::new(0), Mutex::new(Vec::new()));
    std::thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| {
                while let Some(entry) = entries.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let graded = grade_one(entry, (temporary, clock)).map(|report| held_against(entry, report));
                    graded.iter().for_each(&seen);
                    results.lock().unwrap_or_else(PoisonError::into_inner).push(graded);
                }
            });
        }
    });
    let results = results.into_inner().unwrap_or_else(PoisonError::into_inner);
    let mut graded = results.into_iter().collect::<Result<Vec<_>, _>>()?;
    graded.sort_by_key(|one| entries.iter().position(|entry| entry.key() == one.report.key));
    Ok(graded)
}

fn grade_one(entry: &Entry, (temporary, clock): (&Path, Clock)) -> Result<Report, String> {
    if entry.set.is_some() {
        let program = Kept::start(&kept::held_command(entry, temporary)?)?;
        return Ok(report(entry, &verdict_of(entry, &program, clock)?));
    }
    let verdict = match entry.language.as_str() {
        "rust" => {
            let none = || format!("there is no source {}", entry.source);
            Drawer::new(&entry.source, &entry.slip).ok_or_else(none)?.with_subject(|s| verdict_of(entry, s, clock))
        }
        "c" => {
            let program = kept::compile(&entry.source, &entry.slip, temporary)?;
            verdict_of(entry, &Kept::start(&[program.into()])?, clock)
        }
        _ => {
            let script = kept::folder().join("python").join(format!("{}.py", entry.source));
            let words = ["python3".into(), "-S".into(), "-B".into(), script.into(), entry.slip.clone().into()];
            verdict_of(entry, &Kept::start(&words)?, clock)
        }
    }?;
    Ok(report(entry, &verdict))
}

/// The verdict on a subject in the entry's lab.
pub fn verdict_of(entry: &Entry, subject: &dyn Subject, clock: Clock) -> Result<Verdict, String> {
    let found = labs::find(&entry.lab).ok_or_else(|| format!("there is no lab {}", entry.lab))?;
    let untimed = found.aspects.iter().filter(|aspect| clock == Clock::Used || aspect.watch != Watch::Cost);
    // A few hundred bytes for each grade, until the program ends.
    let lab: &'static Lab = Box::leak(Box::new(Lab { aspects: Vec::leak(untimed.copied().collect()), ..*found }));
    let points = |aspect: &Aspect| f64::from(aspect.points);
    let request = Request { lab, name: entry.slip.clone(), seed: 1, points: &points };
    Ok(grade(subject, &request, &mut |_| ()))
}

/// What of a verdict the bank looks at.
pub fn report(entry: &Entry, verdict: &Verdict) -> Report {
    let charged = verdict.faults.iter().filter(|fault| !fault.is_accepted);
    let mut said: Vec<String> = charged.map(|fault| fault.name.to_string()).collect();
    for aspect in &verdict.aspects {
        match &aspect.cause {
            Some(Cause::Other(words)) => said.push(format!("~{words}")),
            Some(Cause::Unexplained { closest, explained, next, next_explained }) => said.push(format!(
                "? {}: of {} wrong, {closest} {explained}, {next} {next_explained}",
                aspect.name,
                aspect.wrong()
            )),
            _ => {}
        }
    }
    let (passed, witness) = (verdict.is_passed(), witness_of(verdict));
    Report { key: entry.key(), said, passed, witness, seconds: verdict.seconds }
}

/// How a report compares with the truth.
pub fn held_against(entry: &Entry, report: Report) -> Graded {
    let said = &report.said;
    let is_expected = |word: &String| {
        entry.names.iter().any(|name| match name.strip_prefix('~') {
            Some(part) => word.starts_with('~') && word.contains(part),
            None => name == word,
        })
    };
    // A complaint says what was seen, not why; but this one does say why.
    let is_name = |word: &&String| !word.starts_with(['~', '?']) || word.contains(SLOW);
    let outcome = if entry.right {
        if report.passed && said.is_empty() { Outcome::Clean } else { Outcome::Accused }
    } else if said.is_empty() {
        Outcome::NotFound
    } else if said.iter().all(is_expected) {
        Outcome::Named
    } else if said.iter().filter(is_name).any(|word| !is_expected(word)) {
        Outcome::Misnamed
    } else if said.iter().any(is_expected) {
        Outcome::NamedInPart
    } else {
        Outcome::Unexplained
    };
    Graded { entry: entry.clone(), outcome, report }
}

/// In the complaint about time.
pub const SLOW: &str = "every sample of the picture is asked";

/// The witness of the first mistake.
fn witness_of(verdict: &Verdict) -> Option<(usize, u32, u32)> {
    let charged = verdict.faults.iter().filter(|fault| !fault.is_accepted).map(|fault| fault.aspect);
    let own = charged.filter_map(|aspect| verdict.aspects.get(aspect)?.witness.as_ref()).next();
    let any = || verdict.aspects.iter().find_map(|aspect| aspect.witness.as_ref());
    own.or_else(any)
        .map(|Witness { case, .. }| (case.faces.len(), case.width / case.samples, case.height / case.samples))
}
