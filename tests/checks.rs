//! Every check of `farop check`, on its first few cases: a check that panics, misses or tests nothing shows here.

use farop::lab::check::{CHECKS, Effort, Extent, Report};

fn report(name: &str) -> Report {
    let check = CHECKS.iter().find(|check| check.name == name);
    check.unwrap_or_else(|| panic!("there is no check {name}")).report(&Effort { extent: Extent::Tiny, seed: 5 })
}

macro_rules! tiny_checks {
    ($($name:ident),+) => {
        $(#[test]
        fn $name() {
            let report = report(stringify!($name));
            assert!(report.holds(), "{}", report.text());
            assert!(!report.figures.is_empty());
        })+
    };
}

tiny_checks!(predicates, coverage, unsnapped, seams, clip, tri, cts, hash, fuzz);

#[test]
fn the_same_seed_finds_the_same() {
    for name in ["coverage", "seams", "clip", "fuzz"] {
        assert_eq!(report(name), report(name), "{name}");
    }
}
