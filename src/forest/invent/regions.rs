//! Regions: land parted among sites, each position to the nearest one, and cut at the borders of cells.
//!
//! sites on a jittered lattice, cell -REGIONS-> polygons that leave no gap
//!
//! Why edges have names: a polygon is kept as the list of what bounds it (a border of the cell, or the line halfway to another site), and a corner is computed from the
//! names of the two edges that meet there, in one order whoever asks. So neighbors, in this cell or the next, get the same corner bit for
//! bit; rounded to 1/256 m of the world, it is also the same number on both sides of a border.
//!
//! Space: world metres. Source: G. Voronoi, 1908; clipping by I. Sutherland, G. Hodgman, "Reentrant Polygon Clipping", CACM 17(1), 1974.
//! Cost: about 6 sites a cell, clipped by each other.

use crate::forest::random::{key, unit};

/// A position, world metres.
pub(super) type Point = [f64; 2];

/// Metres between sites.
pub(super) const SPACING: f64 = 430.0;

/// A site: column and row on the lattice of sites, and where it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Site {
    pub(super) index: [i32; 2],
    pub(super) at: Point,
}

/// The site of a lattice square: somewhere in its middle.
pub(super) fn site(seed: u64, index: [i32; 2]) -> Site {
    let at = [0, 1].map(|axis| {
        let share = unit(key(&[seed, 0x31, axis as u64, index[0] as u32 as u64, index[1] as u32 as u64]));
        (f64::from(index[axis]) + 0.12 + 0.76 * share) * SPACING
    });
    Site { index, at }
}

/// What bounds a region.
#[derive(Clone, Copy, PartialEq)]
enum Edge {
    /// A border of the cell: the line where this coordinate has this value.
    Border(usize, f64),
    /// Halfway to another site.
    Site(Site),
}

/// The regions in a square, each with its corners counterclockwise, rounded to 1/256 m.
pub(super) fn in_square(seed: u64, low: Point, side: f64) -> Vec<(Site, Vec<Point>)> {
    let high = [low[0] + side, low[1] + side];
    let sites = near(seed, low, high);
    let region = |own: &Site| {
        let mut edges =
            vec![Edge::Border(1, low[1]), Edge::Border(0, high[0]), Edge::Border(1, high[1]), Edge::Border(0, low[0])];
        for other in sites.iter().filter(|other| other.index != own.index) {
            clip(own, &mut edges, other);
        }
        let mut corners: Vec<Point> = corners(own, &edges).map(|corner| corner.map(round)).collect();
        corners.dedup();
        if corners.len() > 1 && corners.first() == corners.last() {
            corners.pop();
        }
        (corners.len() >= 3 && crate::forest::polygon::area(&corners) > 0.0).then_some((*own, corners))
    };
    sites.iter().filter_map(region).collect()
}

/// To 1/256 m: exact, and exact again after the corner of a cell (whole metres) is taken off.
pub(super) fn round(metres: f64) -> f64 {
    (metres * 256.0).round() / 256.0
}

/// Sites whose region can touch a square: not farther from it than some other site is from its farthest corner.
fn near(seed: u64, low: Point, high: Point) -> Vec<Site> {
    let range = |axis: usize| ((low[axis] / SPACING).floor() as i32 - 2)..=((high[axis] / SPACING).floor() as i32 + 2);
    let all: Vec<Site> = range(1).flat_map(|row| range(0).map(move |column| site(seed, [column, row]))).collect();
    let distance = |at: Point, choose: fn(f64, f64) -> f64, inside: f64| {
        (0..2)
            .map(|axis| {
                choose((at[axis] - low[axis]).abs(), (at[axis] - high[axis]).abs())
                    * if low[axis] < at[axis] && at[axis] < high[axis] { inside } else { 1.0 }
            })
            .map(|off| off * off)
            .sum::<f64>()
    };
    let reach = all.iter().map(|site| distance(site.at, f64::max, 1.0)).fold(f64::INFINITY, f64::min);
    all.into_iter().filter(|site| distance(site.at, f64::min, 0.0) <= reach).collect()
}

/// Keeps what is nearer to `own` than to `other`.
fn clip(own: &Site, edges: &mut Vec<Edge>, other: &Site) {
    let all: Vec<Point> = corners(own, edges).collect();
    let count = all.len();
    let is_own = |corner: &Point| square_distance(*corner, own.at) <= square_distance(*corner, other.at);
    let kept: Vec<bool> = all.iter().map(is_own).collect();
    if kept.iter().all(|kept| *kept) {
        return;
    }
    // Corner i is where edge i ends and edge i + 1 begins.
    let mut clipped = Vec::with_capacity(count + 1);
    for index in 0..count {
        let (begins, ends) = (kept[(index + count - 1) % count], kept[index]);
        if begins || ends {
            clipped.push(edges[index]);
        }
        if begins && !ends {
            clipped.push(Edge::Site(*other));
        }
    }
    *edges = clipped;
}

/// Where each edge meets the next one.
fn corners<'a>(own: &'a Site, edges: &'a [Edge]) -> impl Iterator<Item = Point> + 'a {
    (0..edges.len()).map(move |index| corner(own, edges[index], edges[(index + 1) % edges.len()]))
}

fn corner(own: &Site, one: Edge, other: Edge) -> Point {
    match (one, other) {
        (Edge::Border(axis, value), Edge::Border(_, across)) => {
            if axis == 0 {
                [value, across]
            } else {
                [across, value]
            }
        }
        (Edge::Border(axis, value), Edge::Site(site)) | (Edge::Site(site), Edge::Border(axis, value)) => {
            let [a, b] = if own.index < site.index { [own.at, site.at] } else { [site.at, own.at] };
            on_border(a, b, axis, value)
        }
        (Edge::Site(one), Edge::Site(other)) => {
            let mut sites = [*own, one, other];
            sites.sort_by_key(|site| site.index);
            circumcenter(sites.map(|site| site.at))
        }
    }
}

/// Where the line halfway between two sites has this value of this coordinate.
fn on_border(a: Point, b: Point, axis: usize, value: f64) -> Point {
    let across = 1 - axis;
    let middle = [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
    let off = middle[across] - (value - middle[axis]) * (b[axis] - a[axis]) / (b[across] - a[across]);
    if axis == 0 { [value, off] } else { [off, value] }
}

/// The position as far from one as from the others.
fn circumcenter([a, b, c]: [Point; 3]) -> Point {
    let (b, c) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
    let double = 2.0 * (b[0] * c[1] - b[1] * c[0]);
    let (bb, cc) = (b[0] * b[0] + b[1] * b[1], c[0] * c[0] + c[1] * c[1]);
    [a[0] + (c[1] * bb - b[1] * cc) / double, a[1] + (b[0] * cc - c[0] * bb) / double]
}

fn square_distance(a: Point, b: Point) -> f64 {
    (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_sites_have_one_corner_whoever_asks() {
        for index in 0..300 {
            let [a, b, c] = [[index, 5], [index + 1, 5], [index, 6]].map(|index| site(9, index));
            let asked = [(a, b, c), (b, c, a), (c, a, b), (a, c, b)];
            let corners =
                asked.map(|(own, one, other)| corner(&own, Edge::Site(one), Edge::Site(other)).map(f64::to_bits));
            assert!(corners.iter().all(|corner| *corner == corners[0]), "{index}");
            let ends = [(a, b), (b, a)].map(|(own, other)| {
                corner(&own, Edge::Border(0, 240.0 * f64::from(index)), Edge::Site(other)).map(f64::to_bits)
            });
            assert_eq!(ends[0], ends[1]);
        }
    }
}
