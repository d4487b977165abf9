//! Cases about several samples a pixel.

use super::tint;
use crate::grade::case::{Case, Face};

const WHITE: [f64; 3] = [0.98; 3];

fn sampled(name: &str, samples: u32, faces: Vec<Face>) -> Case {
    let mut case = Case::new(name, (8 * samples, 8 * samples), faces);
    case.samples = samples;
    case
}

/// Edges on black and on a background, faces side by side, faces that pierce each other.
#[must_use]
pub fn samples(_: u64) -> Vec<Case> {
    let edge = |side: f64| {
        vec![Face::flat(
            &[(0.25, 0.25), (side - 0.5, side * 85.0 / 256.0 + 0.125), (side / 4.0, side - 0.25)],
            0.5,
            WHITE,
        )]
    };
    let abutting = vec![
        Face::flat(&[(0.0, 0.0), (19.25, 0.0), (12.25, 32.0), (0.0, 32.0)], 0.5, WHITE),
        Face::flat(&[(19.25, 0.0), (32.0, 0.0), (32.0, 32.0), (12.25, 32.0)], 0.5, WHITE),
    ];
    let piercing = vec![
        Face::slanted(&[(0.5, 1.25), (31.25, 14.75), (1.25, 30.75)], [0.2, 0.8, 0.15], tint(0)),
        Face::slanted(&[(31.5, 2.25), (0.75, 17.75), (29.75, 29.25)], [0.15, 0.75, 0.25], tint(1)),
    ];
    let mut on_background = vec![
        Face::flat(&[(1.25, 1.75), (20.5, 7.25), (6.25, 17.75)], 0.25, tint(3)),
        Face::flat(&[(9.25, 3.5), (23.25, 11.75), (4.75, 22.25)], 0.5, tint(2)),
    ];
    on_background.swap(0, 1);
    let on_background = Case { background: tint(5), ..sampled("on a background, 3 x 3", 3, on_background) };
    vec![
        sampled("slanted edges, 2 x 2", 2, edge(16.0)),
        sampled("slanted edges, 4 x 4", 4, edge(32.0)),
        sampled("two faces side by side", 4, abutting),
        sampled("colors, 3 x 3", 3, vec![Face::flat(&[(1.25, 2.25), (22.5, 5.75), (9.25, 23.25)], 0.5, tint(0))]),
        on_background,
        sampled("two faces that pierce each other", 4, piercing),
    ]
}
