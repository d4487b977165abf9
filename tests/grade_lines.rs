//! Mistakes about lines: every one is seen in the wire lab, and none looks like a mistake of another name.

use farop::grade::case::Case;
use farop::grade::labs::find;
use farop::grade::mutants::{self, Mutant};
use farop::grade::paint::{Painted, paint};
use farop::grade::rules::Rules;

fn cases(seed: u64) -> Vec<Case> {
    find("wire").expect("a lab").aspects.iter().flat_map(|aspect| (aspect.cases)(seed)).collect()
}

fn about_lines() -> Vec<Mutant> {
    mutants::all().into_iter().filter(Mutant::is_about_lines).collect()
}

/// Pixels of the one that the other does not allow.
fn difference(pictures: &[Painted], others: &[Painted]) -> usize {
    let count = |(one, other): (&Painted, &Painted)| {
        one.low.iter().enumerate().filter(|&(at, level)| !other.allows(at, *level)).count()
    };
    pictures.iter().zip(others).map(count).sum()
}

#[test]
fn no_mistake_about_lines_looks_like_one_of_another_name() {
    let (mutants, cases) = (about_lines(), cases(1));
    let painted = |rules: &Rules| cases.iter().map(|case| paint(case, rules)).collect::<Vec<_>>();
    let right = painted(&Rules::default());
    let pictures: Vec<_> = mutants.iter().map(|mutant| painted(&mutant.applied_to(&Rules::default()))).collect();
    for (mutant, picture) in mutants.iter().zip(&pictures) {
        let wrong = difference(picture, &right);
        assert!(wrong > 0, "{} is not seen", mutant.name);
        for (other, drawn) in mutants.iter().zip(&pictures).filter(|(other, _)| other.name != mutant.name) {
            let left = difference(picture, drawn);
            assert!(left * 20 >= wrong, "{}: {} leaves {left} of {wrong}", mutant.name, other.name);
        }
    }
}

#[test]
fn every_sample_of_the_cases_is_judged_and_random_ones_change() {
    for seed in 1..4 {
        for case in cases(seed) {
            assert!(!paint(&case, &Rules::default()).disputed.contains(&true), "{} {seed}", case.name);
        }
    }
    assert_ne!(cases(1), cases(2));
    assert_eq!(cases(1), cases(1));
}

#[test]
fn labs_without_lines_try_no_mistake_about_them() {
    let [wire, zbuffer] = ["wire", "zbuffer"].map(|name| mutants::of(find(name).expect("a lab")));
    assert_eq!(zbuffer.len() + about_lines().len(), mutants::all().len());
    assert_eq!(wire.iter().filter(|mutant| mutant.is_about_lines()).count(), about_lines().len());
}
