//! Mutants of light, values and pixels: every one changes a picture of its lab, and no other name explains that as well.

use farop::grade::labs;
use farop::grade::mutants::{self, Mutant};
use farop::grade::paint::{Painted, paint};
use farop::grade::rules::{Fill, Rules};
use farop::grade::scan::Scan;

/// Wrong pixels of what `drawn` shows, by what is allowed; counting ends at `enough`.
fn wrong(drawn: &[Painted], allowed: &[Painted], enough: usize) -> usize {
    let one = |(drawn, allowed): (&Painted, &Painted)| {
        (0..drawn.low.len()).filter(|&at| !allowed.allows(at, drawn.low[at])).count()
    };
    let mut sum = 0;
    for pair in drawn.iter().zip(allowed) {
        sum += one(pair);
        if sum >= enough {
            break;
        }
    }
    sum
}

/// Mutants that `is_ours` picks, held against all others in a lab: those that change nothing, and those taken for another.
fn confused(lab: &str, is_ours: fn(&Rules, &Rules) -> bool) -> (usize, Vec<String>) {
    let lab = labs::find(lab).expect("a lab");
    let cases: Vec<_> = lab.aspects.iter().flat_map(|aspect| (aspect.cases)(1)).collect();
    let draw = |rules: &Rules| cases.iter().map(|case| paint(case, rules)).collect::<Vec<_>>();
    let right = Rules::default();
    let contract = draw(&right);
    // Variants with a number or with company are of the same names, and too many for a test.
    let all: Vec<(Mutant, Rules, Vec<Painted>)> = mutants::of(lab)
        .into_iter()
        .filter(|mutant| mutant.with.is_none() && mutant.is_plain())
        .map(|mutant| (mutant, mutant.applied_to(&right)))
        .map(|(mutant, rules)| (mutant, rules.clone(), draw(&rules)))
        .collect();
    let ours: Vec<_> = all.iter().filter(|(_, rules, _)| is_ours(rules, &right)).collect();
    let mut found = Vec::new();
    for (mutant, rules, drawn) in &ours {
        let total = wrong(drawn, &contract, usize::MAX);
        if total == 0 {
            found.push(format!("{}: nothing is wrong: {}", mutant.name, differing(rules, &right)));
            continue;
        }
        let margin = ((total as f64 * 0.05).ceil() as usize).max(1);
        let rivals = all.iter().filter(|(other, ..)| other.name != mutant.name);
        for (other, other_rules, pictures) in rivals {
            let left = wrong(drawn, pictures, margin);
            if left < margin {
                let (one, two) = (differing(rules, &right), differing(other_rules, &right));
                found.push(format!("{} {one} is {} {two}: {left} of {total}", mutant.name, other.name));
            }
        }
    }
    (ours.len(), found)
}

/// The fields in which rules differ, as text.
fn differing(rules: &Rules, right: &Rules) -> String {
    let (a, b) = (format!("{rules:#?}"), format!("{right:#?}"));
    let old: Vec<&str> = b.lines().map(str::trim).collect();
    let new: Vec<&str> = a.lines().map(str::trim).filter(|line| !old.contains(line)).collect();
    new.join(" ")
}

fn assert_told_apart(lab: &str, least: usize, is_ours: fn(&Rules, &Rules) -> bool) {
    let (number, found) = confused(lab, is_ours);
    assert!(number >= least, "{number}");
    assert!(found.is_empty(), "{} of {number}:\n{}", found.len(), found.join("\n"));
}

#[test]
fn mistakes_of_light_are_told_apart() {
    assert_told_apart("phong", 150, |rules, right| rules.light != right.light);
}

#[test]
fn mistakes_of_values_are_told_apart() {
    assert_told_apart("gouraud", 150, |rules, right| {
        rules.values != right.values
            || rules.carried != right.carried
            || (rules.value_at != right.value_at && rules.cover_at == right.cover_at)
    });
}

#[test]
fn mistakes_of_pixels_are_told_apart() {
    assert_told_apart("supersampling", 90, |rules, right| {
        rules.pixel != right.pixel || rules.sample_at != right.sample_at || rules.depth_at != right.depth_at
    });
}

#[test]
fn mistakes_of_memory_are_told_apart() {
    assert_told_apart("zbuffer", 15, |rules, right| {
        rules.kept != right.kept
            || rules.most_at_sample != right.most_at_sample
            || rules.mixed != right.mixed
            || rules.stencil != right.stencil
            || rules.dropped != right.dropped
    });
}

/// Screen files say coordinates in 256ths: what `farop suite` writes must be read again.
#[test]
fn corners_of_all_cases_lie_on_the_grid() {
    for lab in labs::LABS {
        for aspect in lab.aspects {
            for case in (aspect.cases)(1) {
                let corners = case.faces.iter().flat_map(|face| &face.corners);
                let off: Vec<_> =
                    corners.filter(|(x, y)| (x * 256.0).fract() != 0.0 || (y * 256.0).fract() != 0.0).collect();
                assert!(off.is_empty(), "{}, {}: {off:?}", lab.name, case.name);
            }
        }
    }
}

/// Without a slip, an edge table covers what the contract says.
#[test]
fn the_right_scan_is_the_contract() {
    let by_lines = Rules { fill: Fill::Scan(Scan::RIGHT), ..Rules::default() };
    for aspect in labs::find("watkins").expect("a lab").aspects {
        for case in (1..4).flat_map(aspect.cases) {
            assert_eq!(paint(&case, &by_lines), paint(&case, &Rules::default()), "{}", case.name);
        }
    }
}
