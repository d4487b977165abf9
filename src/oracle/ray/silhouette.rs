//! Silhouette: how far two outlines are apart, to a small part of a pixel.
//!
//! [`Tracer`](super::Tracer) or polygons, as regions of the picture -SILHOUETTE-> distances in pixels
//!
//! Both are asked at any place whether it is inside. Where the answer changes between neighboring sample centers, bisection
//! finds the outline; around every such point, the radius at which the other region's answer changes is its distance from
//! the other outline. Taken both ways, the largest is the Hausdorff distance of the two outlines.
//!
//! Space: samples, continuous. An outline that passes twice between two neighboring centers is not seen there.
//! Cost: some 300 questions a point of an outline, which has about one a sample that it passes.

use super::super::Vertices;
use super::super::area::outline;
use super::{Hit, Tracer};
use crate::math::{PI, cos, edges, sin};
use crate::screen::DrawList;

/// A part of the picture: places in samples.
pub trait Region {
    /// Whether the place (x, y) belongs to it.
    fn contains(&self, x: f64, y: f64) -> bool;
}

impl<F: Fn(f64, f64) -> bool> Region for F {
    fn contains(&self, x: f64, y: f64) -> bool {
        self(x, y)
    }
}

/// Where the first hit is one of some kind: the analytic outline.
pub fn traced<'a>(tracer: &'a Tracer<'a>, is_of: impl Fn(&Hit) -> bool + 'a) -> impl Region + 'a {
    move |x: f64, y: f64| tracer.hit(x, y).is_some_and(|hit| is_of(&hit))
}

/// Polygons of a draw list: what they cover together.
pub struct Polygons {
    outlines: Vec<Vec<(f64, f64)>>,
    /// Which outlines reach into each cell.
    cells: Vec<Vec<u32>>,
    columns: usize,
}

/// Side of a cell, in samples.
const CELL: f64 = 8.0;

impl Polygons {
    /// The polygons of `list` for which `is_of` holds, by their corners on the grid or before snapping.
    pub fn new(list: &DrawList, vertices: Vertices, is_of: impl Fn(u32) -> bool) -> Polygons {
        let chosen = list.polygons().filter(|polygon| is_of(polygon.index));
        let outlines: Vec<_> = chosen.map(|polygon| outline(&polygon, vertices, 1.0)).collect();
        let cell = |at: f64, end: u32| ((at / CELL).max(0.0) as usize).min((f64::from(end) / CELL) as usize);
        let columns = (f64::from(list.width) / CELL) as usize + 1;
        let mut cells = vec![Vec::new(); columns * ((f64::from(list.height) / CELL) as usize + 1)];
        for (index, outline) in outlines.iter().enumerate() {
            let reach = |axis: fn(&(f64, f64)) -> f64, end: u32| {
                let (low, high) =
                    outline.iter().map(axis).fold((f64::MAX, f64::MIN), |(l, h), at| (l.min(at), h.max(at)));
                cell(low, end)..=cell(high, end)
            };
            for row in reach(|p| p.1, list.height) {
                for column in reach(|p| p.0, list.width) {
                    cells[row * columns + column].push(index as u32);
                }
            }
        }
        Polygons { outlines, cells, columns }
    }
}

impl Region for Polygons {
    fn contains(&self, x: f64, y: f64) -> bool {
        if x < 0.0 || y < 0.0 || x >= self.columns as f64 * CELL {
            return false;
        }
        let cell = (y / CELL) as usize * self.columns + (x / CELL) as usize;
        let candidates = self.cells.get(cell).map_or(&[][..], Vec::as_slice);
        candidates.iter().any(|&index| {
            let crossed = edges(&self.outlines[index as usize])
                .filter(|&(a, b)| (a.1 <= y) != (b.1 <= y) && a.0 + (y - a.1) / (b.1 - a.1) * (b.0 - a.0) > x);
            crossed.count() % 2 == 1
        })
    }
}

/// A mask of samples: a place belongs to the sample it lies in. Its outline is known to half a sample.
pub struct Mask {
    /// Samples across.
    pub width: u32,
    /// Row after row from the top.
    pub inside: Vec<bool>,
}

impl Region for Mask {
    fn contains(&self, x: f64, y: f64) -> bool {
        let inside = x >= 0.0 && y >= 0.0 && x < f64::from(self.width);
        inside && self.inside.get(y as usize * self.width as usize + x as usize).copied().unwrap_or(false)
    }
}

/// How far two outlines are apart, in samples.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Deviation {
    /// The largest distance of a point of either outline from the other outline: Hausdorff's.
    pub largest: f64,
    /// The mean over all points found.
    pub mean: f64,
    /// How many points of outlines were found.
    pub points: u64,
    /// Points farther from the other outline than the limit of the search; they count as at the limit.
    pub beyond: u64,
}

/// The deviation of two regions of a picture of `size` samples; distances above `limit` samples are not told apart.
///
/// The border of the picture is no outline.
#[must_use]
pub fn deviation(first: &dyn Region, second: &dyn Region, size: (u32, u32), limit: f64) -> Deviation {
    let mut found = Deviation::default();
    for (own, other) in [(first, second), (second, first)] {
        for point in points(own, size) {
            let distance = distance(other, point, size, limit);
            found.largest = found.largest.max(distance);
            found.mean += distance;
            found.points += 1;
            found.beyond += u64::from(distance >= limit);
        }
    }
    found.mean /= (found.points as f64).max(1.0);
    found
}

/// Points of the outline of `region`, on the lines between neighboring sample centers.
pub fn points(region: &dyn Region, (width, height): (u32, u32)) -> Vec<(f64, f64)> {
    let at = |x: u32, y: u32| (f64::from(x) + 0.5, f64::from(y) + 0.5);
    let inside: Vec<Vec<bool>> =
        (0..height).map(|y| (0..width).map(|x| region.contains(at(x, y).0, at(x, y).1)).collect()).collect();
    let mut points = Vec::new();
    for y in 0..height {
        for x in 0..width {
            let here = inside[y as usize][x as usize];
            if x + 1 < width && inside[y as usize][x as usize + 1] != here {
                points.push(bisect(region, at(x, y), at(x + 1, y)));
            }
            if y + 1 < height && inside[y as usize + 1][x as usize] != here {
                points.push(bisect(region, at(x, y), at(x, y + 1)));
            }
        }
    }
    points
}

/// The place between `from` and `to` where the answer of `region` changes.
fn bisect(region: &dyn Region, mut from: (f64, f64), mut to: (f64, f64)) -> (f64, f64) {
    let start = region.contains(from.0, from.1);
    // 2^-30 of a sample.
    for _ in 0..30 {
        let middle = ((from.0 + to.0) / 2.0, (from.1 + to.1) / 2.0);
        if region.contains(middle.0, middle.1) == start { from = middle } else { to = middle }
    }
    ((from.0 + to.0) / 2.0, (from.1 + to.1) / 2.0)
}

/// Directions of the search: a straight outline is met at most 1 / cos(PI / 24), 0.9 %, too late.
const DIRECTIONS: u32 = 24;

/// The distance of a point from the outline of `region` within the picture, at most `limit`.
fn distance(region: &dyn Region, (x, y): (f64, f64), size: (u32, u32), limit: f64) -> f64 {
    let here = region.contains(x, y);
    let changes = |radius: f64| {
        (0..DIRECTIONS).any(|step| {
            let angle = 2.0 * PI * f64::from(step) / f64::from(DIRECTIONS);
            let (x, y) = (x + radius * cos(angle), y + radius * sin(angle));
            // Polygons end at the border of the picture, which is no outline.
            let seen = x > 0.0 && y > 0.0 && x < f64::from(size.0) && y < f64::from(size.1);
            seen && region.contains(x, y) != here
        })
    };
    // Doubling finds a radius that reaches over the outline, halving the smallest.
    let mut far = limit / 1024.0;
    while !changes(far) {
        if far >= limit {
            return limit;
        }
        far = (far * 2.0).min(limit);
    }
    let mut near = if far <= limit / 1024.0 { 0.0 } else { far / 2.0 };
    for _ in 0..8 {
        let middle = (near + far) / 2.0;
        if changes(middle) { far = middle } else { near = middle }
    }
    far
}

#[cfg(test)]
mod tests {
    use super::*;

    fn disc(radius: f64, center: (f64, f64)) -> impl Region {
        move |x: f64, y: f64| (x - center.0).hypot(y - center.1) < radius
    }

    #[test]
    fn circles_are_as_far_apart_as_their_radii_and_centers() {
        let size = (64, 64);
        let measured = |a: &dyn Region, b: &dyn Region| deviation(a, b, size, 8.0);
        let wider = measured(&disc(20.0, (32.0, 32.0)), &disc(20.25, (32.0, 32.0)));
        assert!((wider.largest - 0.25).abs() < 0.01 && (wider.mean - 0.25).abs() < 0.005, "{wider:?}");
        let moved = measured(&disc(20.0, (32.0, 32.0)), &disc(20.0, (32.0, 32.5)));
        assert!((moved.largest - 0.5).abs() < 0.01 && moved.mean < 0.4, "{moved:?}");
        let same = measured(&disc(20.0, (32.0, 32.0)), &disc(20.0, (32.0, 32.0)));
        assert!(same.largest < 1e-4 && same.points > 200, "{same:?}");
        let gone = measured(&disc(20.0, (32.0, 32.0)), &|_: f64, _: f64| false);
        assert_eq!((gone.largest, gone.beyond), (8.0, gone.points));
    }

    #[test]
    fn a_mask_is_known_to_half_a_sample() {
        let round = disc(20.0, (32.0, 32.0));
        let inside = (0..64 * 64).map(|at| round.contains(f64::from(at % 64) + 0.5, f64::from(at / 64) + 0.5));
        let mask = Mask { width: 64, inside: inside.collect() };
        let found = deviation(&round, &mask, (64, 64), 8.0);
        assert!(found.largest < 0.75 && found.mean > 0.1, "{found:?}");
    }
}
