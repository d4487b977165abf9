//! Handouts: every lab has one with three hints, and it tells the aspects that are really graded.

use farop::grade::LABS;
use farop::grade::functions::FUNCTION_LABS;
use farop::grade::handout::{HANDOUTS, HINTS, handout, hint};
use farop::grade::labs::Lab;

fn labs() -> impl Iterator<Item = &'static Lab> {
    LABS.iter().chain(FUNCTION_LABS)
}

#[test]
fn every_lab_has_a_handout_and_every_handout_a_lab() {
    let labs: Vec<_> = labs().map(|lab| lab.name).collect();
    assert_eq!(HANDOUTS.map(|(name, _)| name).to_vec(), labs);
    for lab in labs {
        let text = handout(lab).expect("a handout");
        let headings = ["## Background", "## What to write", "## Graded", "## Hints", "## Read on"];
        assert!(headings.iter().all(|heading| text.contains(&format!("\n{heading}\n"))), "{lab}");
        assert!(text.contains(&format!("-- grade {lab} -r ")) && text.lines().count() < 120, "{lab}");
    }
}

#[test]
fn every_handout_has_three_hints_the_first_of_which_asks() {
    for lab in labs().map(|lab| lab.name) {
        let hints: Vec<_> = (1..=HINTS).map(|number| hint(lab, number).unwrap_or_default()).collect();
        assert!(hints.iter().all(|hint| hint.len() > 60 && !hint.contains('#')), "{lab}: {hints:?}");
        assert!(hints[0].contains('?') && !hints[0].contains("```") && !hints[1].contains("```"), "{lab}");
        assert!(hints[2].contains("```"), "{lab}: the third is nearly the code");
        assert_eq!((hint(lab, 0), hint(lab, HINTS + 1)), (None, None));
    }
}

#[test]
fn handouts_tell_the_aspects_and_points_that_are_graded() {
    for lab in labs() {
        let text = handout(lab.name).expect("a handout");
        let table = text.split("\n## Graded\n").nth(1).and_then(|rest| rest.split("\n## ").next()).expect("a table");
        let rows: Vec<String> =
            table.lines().filter(|line| line.starts_with("| ")).skip(1).map(str::to_string).collect();
        let mut right: Vec<String> = lab
            .aspects
            .iter()
            .map(|aspect| format!("| {} | {} | {} |", aspect.name, aspect.points, aspect.asks))
            .collect();
        right.push(format!("| in all | {} | |", lab.aspects.iter().map(|aspect| aspect.points).sum::<u32>()));
        assert_eq!(rows, right, "docs/labs/{}.md", lab.name);
    }
}
