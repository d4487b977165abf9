//! Cases about lines: outlines drawn as edges.

use super::rectangle;
use crate::grade::case::{Case, Face};

fn wires(name: &str, size: (u32, u32), outlines: &[&[(f64, f64)]]) -> Case {
    let faces = outlines.iter().map(|outline| Face::flat(outline, 1.0, [1.0; 3])).collect();
    Case { lines: true, ..Case::new(name, size, faces) }
}

/// Shallow, steep and diagonal lines.
#[must_use]
pub fn directions(_: u64) -> Vec<Case> {
    vec![
        wires("shallow", (14, 8), &[&[(0.6, 1.3), (13.2, 4.7), (2.1, 6.4)].map(snap)]),
        wires("steep", (8, 14), &[&[(1.3, 0.6), (4.7, 13.2), (6.4, 2.1)].map(snap)]),
        wires("both ways round", (12, 12), &[&[(1.2, 9.7), (6.3, 1.1), (10.9, 10.2)].map(snap)]),
    ]
}

/// Quadrilaterals and lines that share corners.
#[must_use]
pub fn outlines(_: u64) -> Vec<Case> {
    vec![
        wires("rectangle", (12, 10), &[&rectangle(1.625, 1.375, 9.625, 7.375)]),
        wires(
            "two triangles",
            (12, 12),
            &[&[(1.2, 1.3), (10.4, 2.2), (5.7, 10.6)].map(snap), &[(10.4, 2.2), (11.1, 11.2), (5.7, 10.6)].map(snap)],
        ),
    ]
}

/// Lines within a sample or two.
#[must_use]
pub fn short(_: u64) -> Vec<Case> {
    vec![
        wires("small triangle", (6, 6), &[&[(1.3, 1.2), (3.6, 2.3), (2.2, 4.1)].map(snap)]),
        wires("within a sample", (6, 6), &[&[(2.3, 2.4), (2.7, 2.45), (2.5, 2.6)].map(snap)]),
    ]
}

fn snap((x, y): (f64, f64)) -> (f64, f64) {
    ((x * 256.0).round() / 256.0, (y * 256.0).round() / 256.0)
}
