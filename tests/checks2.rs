//! The accuracy checks, tiny: that each runs, holds, counts hard cases, and gives the same figures twice.
//!
//! `farop check` runs them with counts that mean something; here a seed of its own and the quick extent do.

use farop::lab::check::{Effort, Extent, Report, Value, find};

fn report(name: &str, seed: u64) -> Report {
    find(name).unwrap_or_else(|| panic!("no check {name}")).report(&Effort { extent: Extent::Tiny, seed })
}

fn holds(name: &str) -> Report {
    let report = report(name, 7);
    assert!(report.holds(), "{}", report.text());
    report
}

fn count(report: &Report, name: &str) -> u64 {
    let figure = report.figures.iter().find(|figure| figure.name.contains(name));
    match figure.unwrap_or_else(|| panic!("no figure {name}: {}", report.text())).value {
        Value::Count(count) => count,
        Value::Measure(measure) => panic!("{name} is a measure, {measure}"),
    }
}

#[test]
fn depth() {
    assert!(count(&holds("depth"), "samples asked") > 10_000);
}

#[test]
fn agree() {
    let found = holds("agree");
    assert!(count(&found, "pairs that pierce") > 5 && count(&found, "standard scenes") == 13);
    assert_eq!(found, report("agree", 7), "the same seed, the same figures");
    assert_ne!(found, report("agree", 8));
}

#[test]
fn fast() {
    let found = holds("fast");
    assert!(count(&found, "drawn by edges") > 200 && count(&found, "drawn by spans") > 50, "{}", found.text());
}

#[test]
fn color() {
    assert!(count(&holds("color"), "levels compared") > 10_000);
}

#[test]
fn metamorphic() {
    assert!(count(&holds("metamorphic"), "pictures: mirrored") > 10);
}

#[test]
fn aa() {
    // The fit needs many angles, the laws of axis edges many offsets; the largest error does not.
    let found = report("aa", 7);
    let others: Vec<_> =
        found.misses.iter().filter(|miss| !miss.contains("exponent") && !miss.contains("axis edges")).collect();
    assert!(others.is_empty(), "{others:?}");
}

#[test]
fn tess() {
    assert!(count(&holds("tess"), "8 segments or more, all tolerances") > 3);
}

#[test]
fn relief() {
    assert!(count(&holds("relief"), "halved and joined") > 100);
}

#[test]
fn extremes() {
    let found = report("extremes", 7);
    assert_eq!(count(&found, "items of the catalogue"), 102);
    let misses: Vec<_> = found.misses.iter().filter(|miss| !miss.starts_with("items that do not")).collect();
    assert!(misses.is_empty(), "{misses:?}");
}
