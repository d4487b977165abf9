//! Cases about lines: outlines drawn as edges.
//!
//! No line comes near the border of a diamond: right programs that compute in different ways agree about all samples.

use super::{Random, rectangle};
use crate::grade::case::{Case, Face};
use crate::grade::lines::{outline, rule::Lines};

type Point = (f64, f64);

fn wires(name: &str, size: (u32, u32), outlines: &[&[Point]]) -> Case {
    let faces = outlines.iter().map(|outline| Face::flat(outline, 1.0, [1.0; 3])).collect();
    Case { lines: true, ..Case::new(name, size, faces) }
}

/// Shallow, steep and diagonal lines, in all eight octants, both ways round.
#[must_use]
pub fn directions(seed: u64) -> Vec<Case> {
    let octagon = [
        (8.22, 1.32),
        (13.12, 3.22),
        (14.62, 8.12),
        (13.22, 12.42),
        (8.32, 14.72),
        (3.12, 12.82),
        (1.42, 8.42),
        (2.92, 3.62),
    ]
    .map(snap);
    let mut other = octagon.map(|(x, y)| (15.875 - x, y + 0.0625));
    other.rotate_left(3);
    let mut random = Random(seed ^ 0x11E5);
    let mut cases = vec![
        wires("shallow", (14, 8), &[&[(0.62, 1.3), (13.22, 4.7), (2.12, 6.4)].map(snap)]),
        wires("steep", (8, 14), &[&[(1.32, 0.6), (4.72, 13.2), (6.42, 2.1)].map(snap)]),
        wires("both ways round", (12, 12), &[&[(1.2, 9.7), (6.3, 1.1), (10.9, 10.2)].map(snap)]),
        wires("eight octants", (16, 16), &[&octagon]),
        wires("the other way round", (16, 16), &[&other]),
    ];
    cases.extend((1..=3).map(|number| random_wires(&format!("random {number}"), (16, 13), 1, 16.0, &mut random)));
    cases
}

/// Quadrilaterals, lines that share corners, several outlines, and what they are drawn with.
#[must_use]
pub fn outlines(seed: u64) -> Vec<Case> {
    let mut random = Random(seed ^ 0x0C7);
    let star =
        [(7.32, 0.7), (8.62, 5.2), (14.32, 6.6), (9.22, 8.7), (10.62, 14.2), (6.42, 9.4), (1.22, 12.3), (4.72, 6.3)];
    let square = [(8.3125, 1.4375), (13.3125, 6.4375), (8.3125, 11.4375), (3.3125, 6.4375)];
    let other_square = square.map(|(x, y)| (15.5 - x, y + 0.0625));
    let on = |name: &str, background: [f64; 3]| {
        let triangle = [(1.3, 1.2), (9.2, 2.9), (4.4, 7.3)].map(snap);
        Case { background, ..wires(name, (11, 9), &[&triangle]) }
    };
    vec![
        wires("rectangle", (12, 10), &[&rectangle(1.625, 1.375, 9.625, 7.375)]),
        wires("along the borders", (11, 8), &[&rectangle(0.375, 0.4375, 10.5625, 7.625)]),
        wires("diagonals", (16, 13), &[&square]),
        wires("other diagonals", (14, 13), &[&[other_square[2], other_square[1], other_square[0], other_square[3]]]),
        wires("ends on centers", (11, 10), &[&[(2.5, 1.5), (9.5, 3.5), (4.5, 8.5)]]),
        wires("star", (16, 16), &[&star.map(snap)]),
        wires(
            "two triangles",
            (12, 12),
            &[&[(1.2, 1.3), (10.4, 2.2), (5.7, 10.6)].map(snap), &[(10.4, 2.2), (11.1, 11.2), (5.7, 10.6)].map(snap)],
        ),
        wires(
            "three outlines",
            (18, 12),
            &[
                &[(1.3, 1.22), (9.4, 3.32), (3.2, 10.42)].map(snap),
                &[(7.2, 1.42), (16.3, 2.22), (14.7, 9.32), (5.3, 7.12)].map(snap),
                &[(10.4, 5.72), (17.2, 8.32), (12.6, 11.22)].map(snap),
            ],
        ),
        on("on gray", [0.8; 3]),
        on("on yellow", [0.9, 0.8, 0.1]),
        on("on dark orange", [0.8, 0.4, 0.2]),
        on("on bright blue", [0.3, 0.4, 1.0]),
        on("on green", [0.1, 0.9, 0.2]),
        random_wires("random outlines", (16, 14), 3, 12.0, &mut random),
    ]
}

/// Lines within a sample or two.
#[must_use]
pub fn short(seed: u64) -> Vec<Case> {
    let mut random = Random(seed ^ 0x5407);
    let mut cases = vec![
        wires("small triangle", (6, 6), &[&[(1.3, 1.2), (3.6, 2.3), (2.2, 4.1)].map(snap)]),
        wires("within a sample", (6, 6), &[&[(2.3, 2.4), (2.7, 2.45), (2.5, 2.6)].map(snap)]),
        wires(
            "each within a sample",
            (9, 7),
            &[
                &[(1.4, 1.3), (1.6, 1.45), (1.5, 1.7)].map(snap),
                &[(4.25, 3.5), (4.6, 3.7), (4.7, 3.4)].map(snap),
                &rectangle(7.375, 5.375, 7.625, 5.625),
            ],
        ),
    ];
    cases.extend((1..=3).map(|number| random_wires(&format!("small {number}"), (12, 10), 5, 3.5, &mut random)));
    cases
}

/// Triangles within `reach` samples from their first corners, nowhere near the border of a diamond.
fn random_wires(name: &str, (width, height): (u32, u32), count: usize, reach: f64, random: &mut Random) -> Case {
    let mut triangles: Vec<[Point; 3]> = Vec::new();
    while triangles.len() < count {
        let first = (random.coordinate(width), random.coordinate(height));
        let mut near = || {
            let by = |random: &mut Random| (random.coordinate(2) - 1.0) * reach;
            (clamped(first.0 + by(random), width), clamped(first.1 + by(random), height))
        };
        let corners = [(clamped(first.0, width), clamped(first.1, height)), near(), near()].map(snap);
        let mut is_clear = is_large(&corners, reach);
        outline(&corners, &Lines::RIGHT, (width, height), |_, is_certain| is_clear &= is_certain);
        if is_clear {
            triangles.push(corners);
        }
    }
    let outlines: Vec<&[Point]> = triangles.iter().map(<[Point; 3]>::as_slice).collect();
    wires(name, (width, height), &outlines)
}

fn clamped(x: f64, most: u32) -> f64 {
    x.clamp(0.25, f64::from(most) - 0.25)
}

/// Whether a triangle is long enough to be seen, and no line doubled.
fn is_large([a, b, c]: &[Point; 3], reach: f64) -> bool {
    let area = (b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0);
    area.abs() > reach * reach / 4.0
}

fn snap((x, y): Point) -> Point {
    ((x * 256.0).round() / 256.0, (y * 256.0).round() / 256.0)
}
