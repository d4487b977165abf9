//! Kinds about the shape of outlines, and the pen that draws triangles no center lies on.

use super::kinds::powers;
use super::{Kind, Step, push};
use crate::grade::cases::Random;
use crate::math::{PI, cos, edges, sin};
use crate::screen::DrawList;

type Point = (f64, f64);

pub(super) const KINDS: &[Kind] = &[
    Kind {
        name: "number of corners",
        draws: "one star of that many corners on 64 x 64 samples",
        is_about_depth: false,
        has_polygons: true,
        steps: || powers(2..=12, star),
    },
    Kind {
        name: "corners that coincide",
        draws: "triangles without area, beside one that has some",
        is_about_depth: false,
        has_polygons: false,
        steps: degenerate,
    },
    Kind {
        name: "corners given twice",
        draws: "outlines with an edge of length 0, or one that runs back on itself",
        is_about_depth: false,
        has_polygons: true,
        steps: repeated,
    },
];

/// Random triangles on a grid.
pub(super) struct Pen {
    random: Random,
    bits: u32,
}

impl Pen {
    /// On a grid of 2^-bits samples.
    pub fn new(bits: u32, seed: u64) -> Pen {
        Pen { random: Random(seed), bits }
    }

    /// A triangle that fills a good part of a box (whole samples) and has no center on its outline.
    pub fn triangle(&mut self, (left, top): (u32, u32), (width, height): (u32, u32)) -> [Point; 3] {
        let steps = u64::from(1_u32 << self.bits);
        loop {
            let fixed = [0; 3].map(|_| {
                let x = self.random.next() % (u64::from(width) * steps + 1);
                let y = self.random.next() % (u64::from(height) * steps + 1);
                (i64::from(left) * steps as i64 + x as i64, i64::from(top) * steps as i64 + y as i64)
            });
            let at = |(x, y): (i64, i64)| (x as f64 / steps as f64, y as f64 / steps as f64);
            let corners = fixed.map(at);
            let area = crate::grade::covered::cross(corners[0], corners[1], corners[2]).abs() / 2.0;
            let is_large = area > f64::from(width) * f64::from(height) / 8.0;
            if is_large && edges(&fixed).all(|(&a, &b)| !meets_a_center(a, b, steps as i64)) {
                return corners;
            }
        }
    }
}

impl Pen {
    /// A triangle in a cell of 16 x 16 samples with an edge that passes the center of sample (left + 8, 8) as near as the grid
    /// allows: twice the area of edge and center is one step by one step.
    pub fn near_miss(&mut self, left: u32, side: i64) -> [Point; 3] {
        let steps = 1_i64 << self.bits;
        let center = (i64::from(left) * steps + 8 * steps + steps / 2, 8 * steps + steps / 2);
        // From center - (n, n - 1) to center + (n, n - 1) + side (1, 1). The direction (2n + side, 2n - 2 + side) has no common factor: no
        // point of the grid lies between the ends.
        let reach = 7 * steps;
        let ends = [(center.0 - reach, center.1 - reach + 1), (center.0 + reach + side, center.1 + reach - 1 + side)];
        loop {
            let place = |most: i64, number: u64| (number % most as u64) as i64;
            let third = (
                i64::from(left) * steps + 9 * steps + place(7 * steps, self.random.next()),
                place(5 * steps, self.random.next()),
            );
            let clear = ends.iter().all(|&end| !meets_a_center(end, third, steps));
            if clear && !meets_a_center(ends[0], ends[1], steps) {
                return [ends[0], ends[1], third].map(|(x, y)| (x as f64 / steps as f64, y as f64 / steps as f64));
            }
        }
    }
}

/// Whether a sample's center lies on the edge from a to b, in grid steps.
fn meets_a_center(a: (i64, i64), b: (i64, i64), steps: i64) -> bool {
    // In halves of a step, so that centers are whole even on a grid of whole samples.
    let [(ax, ay), (bx, by)] = [a, b].map(|(x, y)| (2 * x, 2 * y));
    let is_center = |coordinate: i64| coordinate.rem_euclid(2 * steps) == steps;
    // Rows whose center line passes at or below the upper end.
    let first = (ay.min(by) + steps - 1).div_euclid(2 * steps);
    let mut rows = (first..).map(|row| row * 2 * steps + steps).take_while(|&y| y <= ay.max(by));
    rows.any(|y| {
        if ay == by {
            let (low, high) = (ax.min(bx), ax.max(bx));
            return (low..=high).contains(&(low + (steps - low).rem_euclid(2 * steps)));
        }
        let across = (bx - ax) * (y - ay);
        across % (by - ay) == 0 && is_center(ax + across / (by - ay))
    })
}

/// A star around the middle.
fn star(corners: u32) -> DrawList {
    let mut list = DrawList::new(64, 64);
    let corner = |number: u32| {
        let angle = f64::from(number) / f64::from(corners) * 2.0 * PI + 0.1;
        let radius = if number.is_multiple_of(2) { 31.0 } else { 18.0 };
        (32.0 + cos(angle) * radius, 32.0 + sin(angle) * radius)
    };
    // On odd steps of the grid: no corner is a center.
    let odd = |x: f64| ((x * 128.0).floor() * 2.0 + 1.0) / 256.0;
    let outline: Vec<Point> = (0..corners).map(corner).map(|(x, y)| (odd(x), odd(y))).collect();
    push(&mut list, &outline, 0.5);
    list
}

const TRIANGLE: [Point; 3] = [(1.25, 1.25), (12.75, 3.5), (4.25, 13.75)];

fn shapes(shapes: &[(&str, &[Point])]) -> Vec<Step> {
    let step = |&(name, outline): &(&str, &[Point])| {
        let mut list = DrawList::new(16, 16);
        push(&mut list, outline, 0.75);
        push(&mut list, &[(9.25, 9.25), (15.25, 10.25), (10.75, 15.75)], 0.5);
        Step { name: name.to_string(), list }
    };
    shapes.iter().map(step).collect()
}

fn degenerate() -> Vec<Step> {
    let [a, b, _] = TRIANGLE;
    shapes(&[
        ("one point three times", &[a, a, a]),
        ("the first corner twice", &[a, a, b]),
        ("the last corner twice", &[a, b, b]),
        ("three corners on a line", &[(1.25, 1.25), (3.25, 2.25), (13.25, 7.25)]),
    ])
}

fn repeated() -> Vec<Step> {
    let [a, b, c] = TRIANGLE;
    shapes(&[
        ("a corner twice", &[a, b, b, c]),
        ("every corner twice", &[a, a, b, b, c, c]),
        ("the first again at the end", &[a, b, c, a]),
        ("a spike", &[a, b, (15.25, 1.75), b, c]),
        ("a corner on an edge", &[a, (7.0, 2.375), b, c]),
    ])
}

/// Fills the picture with cells of two triangles each, as many triangles as `count`.
pub(super) fn filled(list: &mut DrawList, (across, down): (u32, u32), count: usize) {
    let (width, height) = (f64::from(list.width) / f64::from(across), f64::from(list.height) / f64::from(down));
    // Lines of the mesh stand beside the centers: a grid step off whole samples, and slanted by as little.
    let step = 1.0 / 256.0;
    let at = |column: u32, row: u32| {
        let (x, y) = (f64::from(column) * width, f64::from(row) * height);
        let inside = |place: f64, side: u32| place.clamp(0.0, f64::from(side));
        let shift = step * f64::from(1 + (column * 3 + row * 5) % 7);
        (inside(x + shift, list.width), inside(y + shift * 2.0 + step, list.height))
    };
    let mut outlines = Vec::new();
    for (row, column) in (0..down).flat_map(|row| (0..across).map(move |column| (row, column))) {
        let [a, b] = [at(column, row), at(column + 1, row)];
        let [c, d] = [at(column + 1, row + 1), at(column, row + 1)];
        outlines.extend([[a, b, d], [b, c, d]]);
    }
    for outline in outlines.into_iter().take(count) {
        push(list, &outline, 0.5);
    }
}
