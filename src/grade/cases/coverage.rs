//! Cases about coverage: one color a face, all at the same depth unless one must hide another.

use super::{Random, rectangle, tint};
use crate::grade::case::{Case, Face};

fn flat(corners: &[(f64, f64)], number: usize) -> Face {
    Face::flat(corners, 0.5, tint(number))
}

/// A triangle and a rectangle whose outlines pass no center.
#[must_use]
pub fn first(_: u64) -> Vec<Case> {
    vec![
        Case::new("rectangle", (8, 8), vec![flat(&rectangle(1.75, 2.75, 6.25, 5.25), 0)]),
        Case::new("triangle", (9, 9), vec![flat(&[(1.25, 1.125), (7.75, 2.875), (3.375, 7.625)], 1)]),
    ]
}

/// An F, which no turn and no mirror leaves as it is; wide, high, and touching no border.
#[must_use]
pub fn orientation(_: u64) -> Vec<Case> {
    let glyph = |dx: f64, dy: f64| {
        let bars = [(2.25, 1.25, 3.75, 8.75), (3.75, 1.25, 7.75, 2.75), (3.75, 4.25, 6.75, 5.75)];
        bars.map(|(a, b, c, d)| flat(&rectangle(a + dx, b + dy, c + dx, d + dy), 0)).to_vec()
    };
    vec![
        Case::new("F on a wide picture", (15, 10), glyph(1.0, 0.0)),
        Case::new("F on a high picture", (9, 16), glyph(0.0, 2.0)),
    ]
}

/// Small squares at 25 places inside a sample, and triangles between samples.
#[must_use]
pub fn position(seed: u64) -> Vec<Case> {
    let dots = |number: u32| {
        let (column, row) = (number % 5, number / 5);
        let (x, y) = (f64::from(3 * column) + 0.2 * f64::from(column), f64::from(3 * row) + 0.2 * f64::from(row));
        let snap = |x: f64| (x * 256.0).round() / 256.0;
        flat(&rectangle(snap(x + 0.01), snap(y + 0.01), snap(x + 0.19), snap(y + 0.19)), number as usize)
    };
    let mut random = Random(seed);
    let mut cases = vec![
        Case::new("25 small squares", (16, 16), (0..25).map(dots).collect()),
        Case::new("slanted", (8, 8), vec![flat(&[(0.375, 0.25), (7.625, 3.5), (2.5, 7.375)], 0)]),
    ];
    for number in 0..4 {
        let name = format!("random triangle {}", number + 1);
        cases.push(Case::new(&name, (12, 12), vec![flat(&random.triangle(12, 12), number)]));
    }
    cases
}

/// Edges through centers.
#[must_use]
pub fn ties(_: u64) -> Vec<Case> {
    let square = rectangle(1.5, 1.5, 5.5, 5.5);
    vec![
        Case::new("square on centers", (8, 8), vec![flat(&square, 0)]),
        Case::new("diamond on centers", (8, 8), vec![flat(&[(3.5, 0.5), (6.5, 3.5), (3.5, 6.5), (0.5, 3.5)], 1)]),
        Case::new("slanted through centers", (8, 8), vec![flat(&[(0.5, 0.5), (6.5, 2.5), (4.5, 6.5)], 2)]),
        Case::new("steep through centers", (8, 8), vec![flat(&[(2.5, 0.5), (7.5, 3.5), (1.5, 7.5), (0.5, 6.5)], 3)]),
    ]
}

/// A fan around a center and meshes, all their inner edges shared.
#[must_use]
pub fn shared(seed: u64) -> Vec<Case> {
    let rim = [(0.5, 0.5), (3.5, 0.5), (6.5, 0.5), (6.5, 3.5), (6.5, 6.5), (3.5, 6.5), (0.5, 6.5), (0.5, 3.5)];
    let spoke = |number: usize| flat(&[(3.5, 3.5), rim[number], rim[(number + 1) % 8]], number);
    let diagonal = vec![flat(&[(1.0, 1.0), (7.0, 1.0), (7.0, 7.0)], 0), flat(&[(1.0, 1.0), (7.0, 7.0), (1.0, 7.0)], 1)];
    let mut random = Random(seed ^ 0x5EED);
    let middle = (random.coordinate(6) + 3.0, random.coordinate(6) + 3.0);
    let corners = [(0.5, 0.0), (12.0, 1.5), (11.5, 12.0), (0.0, 10.5)];
    let around = |number: usize| flat(&[middle, corners[number], corners[(number + 1) % 4]], number);
    vec![
        Case::new("diagonal", (8, 8), diagonal),
        Case::new("fan of eight", (8, 8), (0..8).map(spoke).collect()),
        Case::new("fan of four", (12, 12), (0..4).map(around).collect()),
        Case::new("mesh on centers", (11, 11), mesh(2.5, 4, 0.5)),
    ]
}

/// Squares of `side` in `count` rows, each cut in two, from (`start`, `start`).
fn mesh(side: f64, count: u32, start: f64) -> Vec<Face> {
    let mut faces = Vec::new();
    let place = |index: u32| ((start + f64::from(index) * side) * 256.0).round() / 256.0;
    for row in 0..count {
        for column in 0..count {
            let (a, b, c, d) = (place(column), place(row), place(column + 1), place(row + 1));
            faces.push(flat(&[(a, b), (c, b), (c, d)], faces.len()));
            faces.push(flat(&[(a, b), (c, d), (a, d)], faces.len()));
        }
    }
    faces
}

/// Both ways round.
#[must_use]
pub fn winding(_: u64) -> Vec<Case> {
    let (right, left) = ([(0.75, 0.75), (6.75, 1.25), (1.25, 6.75)], [(15.25, 7.25), (9.25, 6.75), (14.75, 1.25)]);
    let turned = |corners: [(f64, f64); 3]| [corners[0], corners[2], corners[1]];
    vec![
        Case::new("clockwise", (16, 8), vec![flat(&right, 0), flat(&left, 1)]),
        Case::new("counterclockwise", (16, 8), vec![flat(&turned(right), 0), flat(&turned(left), 1)]),
    ]
}

/// Notches, and corners exactly on scan lines.
#[must_use]
pub fn concave(_: u64) -> Vec<Case> {
    let star = [
        (0.25, 0.25),
        (5.75, 4.25),
        (11.75, 0.75),
        (11.25, 11.75),
        (8.25, 6.75),
        (5.25, 11.25),
        (3.25, 7.25),
        (0.75, 11.5),
    ];
    let comb = [
        (0.25, 1.25),
        (2.25, 1.25),
        (2.25, 5.75),
        (4.25, 5.75),
        (4.25, 1.25),
        (6.25, 1.25),
        (6.25, 7.75),
        (0.25, 7.75),
    ];
    // A notch from below ends, and one from above begins, on a row's center line.
    let notched = [(1.25, 0.75), (4.25, 2.5), (11.75, 0.25), (11.25, 9.25), (7.25, 5.5), (1.75, 8.75)];
    let on_lines = [(4.25, 0.5), (7.25, 3.5), (11.25, 1.5), (9.25, 6.5), (4.75, 9.5), (0.75, 5.5)];
    vec![
        Case::new("two notches", (12, 12), vec![flat(&star, 0)]),
        Case::new("comb", (8, 9), vec![flat(&comb, 1)]),
        Case::new("corners on scan lines", (13, 11), vec![flat(&on_lines, 2)]),
        Case::new("notches on scan lines", (13, 10), vec![flat(&notched, 4)]),
        Case::new(
            "diamond on a scan line",
            (13, 8),
            vec![flat(&[(3.25, 0.75), (7.75, 3.5), (4.25, 6.75), (0.75, 3.5)], 3)],
        ),
    ]
}

/// Faces that reach every border, of pictures that are not square.
#[must_use]
pub fn borders(_: u64) -> Vec<Case> {
    let (w, h) = (11.0, 6.0);
    vec![
        Case::new("whole picture", (11, 6), vec![flat(&rectangle(0.0, 0.0, w, h), 0)]),
        Case::new(
            "over the corners",
            (11, 6),
            vec![
                flat(&[(0.0, 0.0), (4.25, 0.0), (0.0, 3.25)], 0),
                flat(&[(w, 0.0), (w, 3.25), (6.75, 0.0)], 1),
                flat(&[(w, h), (6.75, h), (w, 3.75)], 2),
                flat(&[(0.0, h), (0.0, 3.75), (4.25, h)], 3),
            ],
        ),
        Case::new("a single row", (13, 1), vec![flat(&rectangle(0.0, 0.0, 13.0, 1.0), 1)]),
        Case::new("a single column", (1, 13), vec![flat(&rectangle(0.0, 0.0, 1.0, 13.0), 2)]),
    ]
}

/// Meshes of cells about as large as a sample, and faces without area.
#[must_use]
pub fn tiny(_: u64) -> Vec<Case> {
    let mesh_case = |side: f64, count| Case::new(&format!("cells of {side} samples"), (8, 8), mesh(side, count, 0.25));
    let line = [(1.25, 1.25), (6.75, 6.75), (3.25, 3.25)];
    vec![
        mesh_case(1.4, 5),
        mesh_case(1.0, 7),
        mesh_case(0.7, 10),
        Case::new("without area", (8, 8), vec![flat(&line, 0), flat(&[(2.5, 2.5), (5.5, 2.5), (2.5, 2.5)], 1)]),
    ]
}

/// Thin and long faces.
#[must_use]
pub fn slivers(seed: u64) -> Vec<Case> {
    let thin = vec![
        flat(&rectangle(0.75, 0.0, 1.25, 12.0), 0),
        flat(&[(2.0, 0.0), (2.375, 0.0), (11.0, 12.0), (10.625, 12.0)], 1),
        flat(&[(0.0, 11.5), (12.0, 4.0), (12.0, 4.25)], 2),
    ];
    let mut random = Random(seed ^ 0x511);
    let (a, b) = ((random.coordinate(3), random.coordinate(2)), (random.coordinate(3), 238.0 + random.coordinate(2)));
    let long = vec![flat(&[a, (a.0 + 0.8125, a.1 + 0.5), b], 0)];
    vec![Case::new("thin", (12, 12), thin), Case::new("long", (4, 240), long)]
}
