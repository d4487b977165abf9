//! Mistakes that leave polygons out for what they are, or rows and columns of them.

use super::coverage::{SHORT, SHORT_FIRST};
use super::{Mutant, family, mutant};
use crate::grade::rules::{Bounds, BoundsBy, BoundsOf, Dropped, Rules};

const PAGE: &str = "docs/conventions.md";
const MANY: [&str; 4] = [
    "polygons of many corners lost",
    "Polygons with more corners than three, or four, are not drawn at all.",
    "A polygon may have any number of corners; or ask for triangles: fn accepts() of the trait.",
    "docs/splitting.md",
];
const TRIANGLES: [&str; 4] =
    ["triangles lost", "Polygons with three corners are not drawn.", "A polygon has three corners or more.", PAGE];
const BORDER: [&str; 4] = [
    "polygons at the border lost",
    "Polygons that reach a side of the picture are left out.",
    "Polygons are clipped before they come: all of them are inside, and their corners may lie on the sides.",
    PAGE,
];
const SMALL: [&str; 4] = [
    "small polygons dropped",
    "Polygons with a small area are thrown away.",
    "A polygon smaller than a sample still covers a center if one lies in it; only zero area draws nothing.",
    PAGE,
];
const LARGE: [&str; 4] = [
    "large polygons lost",
    "Polygons larger than some size are not drawn.",
    "A polygon may be as large as the picture.",
    PAGE,
];
const SKIPPED: [&str; 4] = [
    "rows or columns skipped",
    "Only every other row or column of a polygon is drawn: the loop steps by more than one, or counts twice.",
    "Go over every row and every column of the bounds.",
    PAGE,
];

/// All of them.
pub(super) fn all() -> Vec<Mutant> {
    let own = [
        mutant(MANY, |rules| rules.dropped = Dropped::MoreCorners(3)),
        mutant(MANY, |rules| rules.dropped = Dropped::MoreCorners(4)),
        mutant(MANY, |rules| rules.dropped = Dropped::MoreCorners(5)),
        mutant(TRIANGLES, |rules| rules.dropped = Dropped::FewerCorners(4)),
        mutant(BORDER, |rules| rules.dropped = Dropped::AtBorder),
        mutant(BORDER, |rules| rules.dropped = Dropped::AtFirst),
        mutant(BORDER, |rules| rules.dropped = Dropped::AtLast),
        mutant(SKIPPED, |rules| (rules.stepped, rules.bounds.by) = ((1, 2), CLIPPED)),
        mutant(SKIPPED, |rules| (rules.stepped, rules.bounds.by) = ((2, 1), CLIPPED)),
        mutant(SKIPPED, |rules| (rules.stepped, rules.bounds.by) = ((2, 2), CLIPPED)),
        mutant(SKIPPED, |rules| (rules.stepped, rules.bounds.by) = ((1, 2), CENTERS)),
        mutant(SKIPPED, |rules| (rules.stepped, rules.bounds.by) = ((2, 1), CENTERS)),
        mutant(SKIPPED, |rules| rules.stepped = (1, 2)),
        mutant(SKIPPED, |rules| rules.stepped = (2, 1)),
    ];
    let thin = family(SMALL, &[0.25, 0.5, 1.0, 1.5, 2.0], |rules, least| rules.dropped = Dropped::Thin(least));
    let small = family(SMALL, &[0.25, 0.5, 1.0, 1.5, 2.0], |rules, least| rules.dropped = Dropped::Small(least));
    let areas = family(SMALL, &[0.1, 0.25, 0.75, 4.0], |rules, least| rules.least_area = least);
    let large = family(LARGE, &[16.0, 32.0, 64.0, 100.0], |rules, most| rules.dropped = Dropped::Large(most));
    let first = family(SHORT_FIRST, &[0.0, 2.0], |rules, side| of_side(rules, BoundsOf::SideOfFirst(side as usize)));
    let second = family(SHORT_FIRST, &[0.0, 2.0], |rules, side| of_side(rules, BoundsOf::SideOfSecond(side as usize)));
    let at_end = [
        family(SHORT, &[1.0, 3.0], |rules, side| of_side(rules, BoundsOf::SideOfFirst(side as usize))),
        family(SHORT, &[1.0, 3.0], |rules, side| of_side(rules, BoundsOf::SideOfSecond(side as usize))),
        family(SHORT, &[1.0, 3.0], |rules, side| of_side(rules, BoundsOf::SideOfLast(side as usize))),
    ];
    let some = [
        mutant(SHORT, |rules| of_side(rules, BoundsOf::FirstThree)),
        mutant(SHORT, |rules| of_side(rules, BoundsOf::FirstAndThird)),
        mutant(SHORT, |rules| of_side(rules, BoundsOf::AllButLast)),
    ];
    [first, second, at_end.concat(), some.to_vec(), own.to_vec(), thin, small, areas, large].concat()
}

fn of_side(rules: &mut Rules, of: BoundsOf) {
    rules.bounds = Bounds { by: BoundsBy::Clipped, of, ..Bounds::WHOLE };
}

const CLIPPED: BoundsBy = BoundsBy::Clipped;
const CENTERS: BoundsBy = BoundsBy::Centers;
