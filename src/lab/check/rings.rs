//! Rings: outlines on whole numbers that are simple, or touch themselves without crossing.
//!
//! Combs, stars, spirals, Hilbert's curve made thick, and squares with holes joined by bridges; then corners doubled, spikes,
//! and corners in the middle of edges, which change no area.

use super::Random;
use crate::math::{PI, cos, sin};

/// A corner.
pub(super) type Whole = [i64; 2];

/// The forms that [`ring`] makes.
pub(super) const FORMS: [&str; 5] = ["combs", "stars", "spirals", "Hilbert curves", "holes on bridges"];

/// A counterclockwise ring of the form `number`, with what is hard added to it.
pub(super) fn ring(form: usize, random: &mut Random) -> Vec<Whole> {
    let ring = match form {
        0 => comb(random),
        1 => star(random),
        2 => spiral(random),
        3 => hilbert(1 + random.below(3) as u32),
        _ => holes(random),
    };
    harden(ring, random)
}

/// Twice the area; positive when counterclockwise.
pub(super) fn doubled_area(ring: &[Whole]) -> i128 {
    let cross = |(a, b): (&Whole, &Whole)| i128::from(a[0]) * i128::from(b[1]) - i128::from(a[1]) * i128::from(b[0]);
    crate::math::edges(ring).map(cross).sum()
}

fn comb(random: &mut Random) -> Vec<Whole> {
    let teeth = 1 + random.below(12) as i64;
    let mut ring = vec![[0, 0], [8 * teeth, 0]];
    for tooth in (0..teeth).rev() {
        let height = 20 + random.below(60) as i64;
        // Teeth without width touch themselves.
        let width = 4 * random.below(2) as i64;
        ring.extend([[8 * tooth + 4 + width, 10], [8 * tooth + 4, 10 + height], [8 * tooth + 4 - width, 10]]);
    }
    ring
}

fn star(random: &mut Random) -> Vec<Whole> {
    let corners = 4 + random.below(30);
    let on_ring = |index| {
        let angle = index as f64 / corners as f64 * 2.0 * PI;
        (cos(angle), sin(angle))
    };
    let mut radius = || 1000.0 + random.below(60_000) as f64;
    (0..corners)
        .map(|index| {
            let ((x, y), radius) = (on_ring(index), radius());
            [(x * radius).round() as i64, (y * radius).round() as i64]
        })
        .collect()
}

/// A rectangular spiral corridor, inward on one wall and out again on the other.
fn spiral(random: &mut Random) -> Vec<Whole> {
    let turns = 1 + random.below(5) as i64;
    let gap = 4;
    let wall = |inset: i64| {
        let mut corners = Vec::new();
        for turn in 0..turns {
            let (low, high) = (2 * gap * turn + inset, 2 * gap * (2 * turns + 1 - turn) - inset);
            corners.extend([[low, low], [high, low], [high, high], [low, high]]);
            corners.push([low, low + 2 * gap]);
        }
        corners
    };
    let (outer, mut inner) = (wall(0), wall(gap));
    inner.reverse();
    [outer, inner].concat()
}

/// Both sides of Hilbert's curve of the given order.
fn hilbert(order: u32) -> Vec<Whole> {
    let side = 1_i64 << order;
    let place = |index: i64| {
        let (mut x, mut y, mut rest) = (0, 0, index);
        let mut size = 1;
        while size < side {
            let (right, up) = (1 & (rest / 2), 1 & (rest ^ (rest / 2)));
            if up == 0 {
                if right == 1 {
                    (x, y) = (size - 1 - x, size - 1 - y);
                }
                (x, y) = (y, x);
            }
            (x, y) = (x + size * right, y + size * up);
            rest /= 4;
            size *= 2;
        }
        [4 * x, 4 * y]
    };
    let path: Vec<Whole> = (0..side * side).map(place).collect();
    let step = |i: usize, j: usize| [(path[j][0] - path[i][0]).signum(), (path[j][1] - path[i][1]).signum()];
    let last = path.len() - 1;
    // To the right of the way, a step aside and, at corners, along both directions.
    let side_of = |sign: i64| {
        let corner = |i: usize| {
            let before = step(i.max(1) - 1, i.max(1));
            let after = step(i.min(last - 1), i.min(last - 1) + 1);
            let turned = before != after;
            let aside = |d: Whole| [sign * d[1], -sign * d[0]];
            let (p, q) = (aside(before), aside(after));
            let both = if turned { [p[0] + q[0], p[1] + q[1]] } else { p };
            [path[i][0] + both[0], path[i][1] + both[1]]
        };
        (0..=last).map(corner).collect::<Vec<_>>()
    };
    let (right, mut left) = (side_of(1), side_of(-1));
    left.reverse();
    [right, left].concat()
}

/// A square with square holes in a row, each joined to the lower side by a bridge to and fro.
fn holes(random: &mut Random) -> Vec<Whole> {
    let count = 1 + random.below(6) as i64;
    let mut ring = vec![[0, 0]];
    for hole in 0..count {
        let (x, y) = (20 * hole + 6, 4 + random.below(8) as i64);
        let (width, height) = (1 + random.below(8) as i64, 1 + random.below(8) as i64);
        // Clockwise around the hole.
        ring.extend([[x, 0], [x, y], [x, y + height], [x + width, y + height], [x + width, y], [x, y], [x, 0]]);
    }
    ring.extend([[20 * count, 0], [20 * count, 24], [0, 24]]);
    ring
}

/// Doubled corners, corners in the middle of edges, and spikes to the middle of an edge and back.
fn harden(ring: Vec<Whole>, random: &mut Random) -> Vec<Whole> {
    let mut hard = Vec::new();
    for (a, b) in crate::math::edges(&ring) {
        let (a, b) = (a.map(|x| 2 * x), b.map(|x| 2 * x));
        hard.push(a);
        let middle = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
        match random.below(16) {
            0 => hard.push(a),
            1 => hard.push(middle),
            2 => hard.extend([middle, a, middle]),
            _ => {}
        }
    }
    hard
}
