//! Cases about color: channels, levels, interpolation.

use super::{Random, rectangle, tint};
use crate::grade::case::{Case, Face};

pub(super) const LEFT: [(f64, f64); 3] = [(0.75, 0.25), (11.25, 4.75), (2.25, 11.75)];

/// Three faces of one channel each, and a background of its own.
#[must_use]
pub fn channels(_: u64) -> Vec<Case> {
    let bar = |number: usize, color| {
        let left = 0.75 + 3.0 * number as f64;
        Face::flat(&rectangle(left, 0.75, left + 2.5, 4.25), 0.5, color)
    };
    let high = 170.25 / 255.0;
    let faces = vec![bar(0, [high, 0.0, 0.0]), bar(1, [0.0, high, 0.0]), bar(2, [0.0, 0.0, high]), bar(3, tint(4))];
    let mut on_gray = Case::new("on a background", (13, 5), vec![bar(1, tint(0))]);
    on_gray.background = tint(5);
    vec![Case::new("red, green, blue", (13, 5), faces), on_gray]
}

/// Levels with every fraction.
#[must_use]
pub fn levels(_: u64) -> Vec<Case> {
    let steps = |first: f64, step: f64| {
        let bar = |number: usize| {
            let left = 0.75 + number as f64;
            let light = (first + step * number as f64) / 255.0;
            Face::flat(&rectangle(left, 0.75, left + 1.0, 3.25), 0.5, [light, light / 2.0, light / 4.0])
        };
        (0..14).map(bar).collect::<Vec<_>>()
    };
    let white = vec![Face::flat(&rectangle(0.75, 0.75, 2.25, 2.25), 0.5, [1.0; 3])];
    vec![
        Case::new("dark levels", (16, 4), steps(2.25, 1.375)),
        Case::new("bright levels", (16, 4), steps(120.75, 9.625)),
        Case::new("white", (4, 4), white),
    ]
}

/// Values on triangles that face the viewer.
#[must_use]
pub fn interpolation(seed: u64) -> Vec<Case> {
    let mut random = Random(seed ^ 0x60);
    let mut cases =
        vec![Case::new("red, green, blue corners", (12, 12), vec![Face::smooth(LEFT, [2.0; 3], corner_colors())])];
    for number in 0..3 {
        let colors = [0; 3].map(|_| [0; 3].map(|_| random.coordinate(1) * 0.9));
        let face = Face::smooth(random.triangle(12, 12), [2.0; 3], colors);
        cases.push(Case::new(&format!("random colors {}", number + 1), (12, 12), vec![face]));
    }
    cases
}

fn corner_colors() -> [[f64; 3]; 3] {
    [[0.9, 0.1, 0.2], [0.1, 0.8, 0.3], [0.2, 0.3, 0.7]]
}

/// The same triangle with its corners in all six orders.
#[must_use]
pub fn corner_order(_: u64) -> Vec<Case> {
    let orders = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [1, 0, 2], [2, 1, 0]];
    let case = |order: [usize; 3]| {
        let corners = order.map(|corner| LEFT[corner]);
        let colors = order.map(|corner| corner_colors()[corner]);
        let name = format!("corners {}, {}, {}", order[0] + 1, order[1] + 1, order[2] + 1);
        Case::new(&name, (12, 12), vec![Face::smooth(corners, [2.0; 3], colors)])
    };
    orders.map(case).to_vec()
}

/// Triangles that recede, w from 1 to 8.
#[must_use]
pub fn perspective(seed: u64) -> Vec<Case> {
    let mut random = Random(seed ^ 0x9E);
    let face = |w| Face::smooth(LEFT, w, corner_colors());
    let floor = vec![
        Face::smooth(
            [(0.25, 11.75), (11.75, 11.75), (8.25, 1.25)],
            [1.0, 1.0, 8.0],
            [[0.9, 0.1, 0.1], [0.1, 0.9, 0.1], [0.1, 0.9, 0.9]],
        ),
        Face::smooth(
            [(0.25, 11.75), (8.25, 1.25), (3.75, 1.25)],
            [1.0, 8.0, 8.0],
            [[0.9, 0.1, 0.1], [0.1, 0.9, 0.9], [0.9, 0.1, 0.9]],
        ),
    ];
    let any = Face::smooth(random.triangle(12, 12), [0; 3].map(|_| 1.0 + random.coordinate(4)), corner_colors());
    vec![
        Case::new("one corner far", (12, 12), vec![face([1.0, 8.0, 1.0])]),
        Case::new("three distances", (12, 12), vec![face([4.0, 1.0, 2.0])]),
        Case::new("floor", (12, 12), floor),
        Case::new("random distances", (12, 12), vec![any]),
    ]
}
