//! Cases about depth: which of several faces is in front.

use super::{Random, rectangle, tint};
use crate::grade::case::{Case, Face};

fn pair(first: f64, second: f64) -> Vec<Face> {
    vec![
        Face::flat(&rectangle(1.25, 1.25, 6.75, 5.75), first, tint(0)),
        Face::flat(&rectangle(3.25, 3.25, 9.75, 8.75), second, tint(1)),
    ]
}

/// Two and three faces at different depths in all orders.
#[must_use]
pub fn order(_: u64) -> Vec<Case> {
    let three = |order: [usize; 3]| {
        let faces = [
            Face::flat(&rectangle(0.25, 0.25, 6.75, 6.75), 0.25, tint(0)),
            Face::flat(&rectangle(2.25, 2.25, 8.75, 8.75), 0.5, tint(1)),
            Face::flat(&rectangle(4.25, 4.25, 10.75, 10.75), 0.75, tint(2)),
        ];
        order.map(|index| faces[index].clone()).to_vec()
    };
    let four = [(0.25, 0.2), (1.25, 0.4), (2.25, 0.6), (3.25, 0.8)].into_iter().enumerate();
    let four = four.map(|(number, (a, depth))| Face::flat(&rectangle(a, a, a + 6.5, a + 5.5), depth, tint(number)));
    vec![
        Case::new("near first", (11, 10), pair(0.75, 0.25)),
        Case::new("far first", (11, 10), pair(0.25, 0.75)),
        Case::new("near, middle, far", (11, 11), three([2, 1, 0])),
        Case::new("middle, near, far", (11, 11), three([1, 2, 0])),
        Case::new("far, near, middle", (11, 11), three([0, 2, 1])),
        Case::new("near, far, middle", (11, 11), three([2, 0, 1])),
        Case::new("four, the nearest last", (11, 10), four.collect()),
    ]
}

/// The same depth twice.
#[must_use]
pub fn equal(_: u64) -> Vec<Case> {
    vec![
        Case::new("equal depths", (11, 10), pair(0.5, 0.5)),
        Case::new("three equal", (11, 10), {
            let mut faces = pair(0.5, 0.5);
            faces.push(Face::flat(&rectangle(2.25, 0.25, 5.75, 9.75), 0.5, tint(2)));
            faces
        }),
    ]
}

/// Faces that pierce each other, and three that overlap in a ring.
#[must_use]
pub fn piercing(seed: u64) -> Vec<Case> {
    let triangle = |corners: [(f64, f64); 3], depths: [f64; 3], number| Face::slanted(&corners, depths, tint(number));
    let cross = vec![
        triangle([(0.25, 1.25), (11.75, 5.75), (0.25, 10.75)], [0.15, 0.85, 0.15], 0),
        triangle([(11.75, 1.25), (0.25, 5.75), (11.75, 10.75)], [0.2, 0.7, 0.2], 1),
    ];
    let ring = vec![
        triangle([(0.25, 8.75), (11.75, 11.25), (11.75, 9.25)], [0.9, 0.1, 0.1], 0),
        triangle([(11.25, 11.75), (6.25, 0.25), (8.25, 0.25)], [0.9, 0.1, 0.1], 1),
        triangle([(6.25, 0.25), (0.75, 11.25), (3.25, 11.25)], [0.9, 0.1, 0.1], 2),
    ];
    let mut random = Random(seed ^ 0xD3);
    let any = (0..3).map(|number| {
        let depths = [0; 3].map(|_| 0.1 + random.coordinate(1) * 0.8);
        triangle(random.triangle(12, 12), depths, number)
    });
    let any = any.collect();
    // They meet beside the middle of every line, and further right on each: neither one end nor one corner decides.
    let whole = rectangle(0.25, 0.25, 15.75, 8.75);
    let beside = vec![Face::slanted(&whole, [0.2, 0.8, 0.8], tint(0)), Face::slanted(&whole, [0.1, 0.1, 0.6], tint(1))];
    vec![
        Case::new("crossing", (12, 12), cross),
        Case::new("ring", (12, 12), ring),
        Case::new("random planes", (12, 12), any),
        Case::new("meeting beside the middle", (16, 9), beside),
    ]
}

/// Near and far faces: 1/w from 1/4096 to 64.
#[must_use]
pub fn range(_: u64) -> Vec<Case> {
    let at = |depths: [f64; 3]| {
        let places = [(0.25, 0.25, 7.75, 5.75), (2.25, 1.25, 9.75, 7.75), (4.25, 2.25, 11.75, 9.75)];
        let face = |(number, (a, b, c, d)): (usize, (f64, f64, f64, f64))| {
            Face::flat(&rectangle(a, b, c, d), depths[number], tint(number))
        };
        places.into_iter().enumerate().map(face).collect::<Vec<_>>()
    };
    vec![
        Case::new("far away", (12, 10), at([1.0 / 4096.0, 1.0 / 1024.0, 1.0 / 2048.0])),
        Case::new("near", (12, 10), at([16.0, 64.0, 32.0])),
        Case::new("near the eye and far away", (12, 10), at([0.03125, 2.5, 1.5])),
        Case::new("ladder", (12, 12), ladder()),
    ]
}

/// Pairs that are nearer and nearer to each other, at many depths: steps take some for equal, a margin takes all below it.
fn ladder() -> Vec<Face> {
    let pair = |number: u32| {
        let (x, y) = (f64::from(number % 6 * 2), f64::from(number / 6 * 2));
        let corners = rectangle(x + 0.25, y + 0.25, x + 1.75, y + 1.75);
        let depth = 0.1 + (f64::from(number) * 0.618_034).fract() * 0.55;
        // From a quarter to 2^-14.
        let gap = (2.0_f64).powi(-(number as i32 / 3) - 2) * [1.0, 0.8125, 0.625][number as usize % 3];
        let [first, second] = [depth, depth + gap].map(|depth| (depth * 65_536.0).round() / 65_536.0);
        let face = |depth: f64, color: u32| Face::flat(&corners, depth, tint(color as usize));
        let (near, far) = (face(second, 2 * number + 1), face(first, 2 * number));
        if number % 4 == 3 { [near, far] } else { [far, near] }
    };
    (0..36).flat_map(pair).collect()
}

/// Glass before, behind and between opaque faces.
#[must_use]
pub fn glass(_: u64) -> Vec<Case> {
    // Not square: no center lies on a diagonal, which a list of triangles would blend twice under a wrong tie rule.
    let pane = |a: f64, depth: f64, number: usize, opacity: f64| {
        Face::flat(&rectangle(a, a, a + 6.5, a + 5.5), depth, tint(number)).with_opacity(opacity)
    };
    vec![
        Case::new("glass before", (12, 12), vec![pane(0.25, 0.25, 0, 1.0), pane(3.25, 0.5, 1, 0.25)]),
        Case::new("glass first in the list", (12, 12), vec![pane(3.25, 0.5, 1, 0.25), pane(0.25, 0.25, 0, 1.0)]),
        Case::new("glass behind", (12, 12), vec![pane(0.25, 0.5, 0, 1.0), pane(3.25, 0.25, 1, 0.25)]),
        Case::new(
            "two panes",
            (12, 12),
            vec![pane(0.25, 0.75, 0, 0.75), pane(2.25, 0.5, 1, 0.25), pane(5.25, 0.25, 2, 1.0)],
        ),
    ]
}

/// Lists whose picture does not depend on their order.
#[must_use]
pub fn state(seed: u64) -> Vec<Case> {
    let mut cases = order(seed);
    cases.truncate(3);
    cases.extend(piercing(seed).into_iter().take(2));
    cases
}

/// Much overlap: whoever paints over does not put every sample once.
#[must_use]
pub fn once(seed: u64) -> Vec<Case> {
    let mut cases = order(seed);
    cases.extend(piercing(seed));
    cases
}
