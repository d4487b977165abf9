//! Cut: polygons with holes at the borders of cells.
//!
//! a polygon of the map -CUT-> one piece or several in each cell it reaches
//!
//! A polygon is halved at a border, its halves are halved again, until each piece is in one column, and then in one row. A half plane is cut exactly: the
//! outlines become chains that end on the border, the ends are sorted along it, and between the first and the second, the third and the fourth, ... lies land.
//! So a polygon that leaves a cell and comes back is two there, and a hole that a border goes through becomes part of the outline.
//!
//! Why not corner by corner against the cell (Sutherland and Hodgman): pieces would hang together by edges of no width along the border, and a reader that checks outlines refuses them.
//! Why cuts are computed from the lower end of an edge: both cells at a border get the same corner, to the last bit.
//!
//! Space: metres from the south-west corner of cell 0 0; a corner on a border has exactly its coordinate.
//! Source: K. Weiler, P. Atherton, "Hidden Surface Removal Using Polygon Area Sorting", SIGGRAPH 1977, for a border that is a line.
//! Cost: n log(cells across) corners.

use crate::forest::area::CellIndex;
use crate::forest::polygon::{Point, area, contains, turn};
use crate::forest::vector::Rings;
use crate::math::edges;
use std::cmp::Ordering;
use std::collections::BTreeMap;

/// A polygon that cannot be cut, because its outline crosses itself: the border where that came out.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("its outlines cross near {} {}", near[0], near[1])]
pub struct Tangled {
    /// Where on the border.
    pub near: Point,
}

/// The pieces of a polygon, by the cell they are in, in metres of the world. Outlines run counterclockwise, holes clockwise.
///
/// # Errors
/// [`Tangled`] where ends on a border are not in and out by turns.
///
/// ```
/// use farop::forest::import::cut;
/// use farop::forest::vector::Rings;
/// let field = Rings { outer: vec![[200.0, 10.0], [300.0, 10.0], [300.0, 20.0], [200.0, 20.0]], holes: vec![] };
/// let pieces = cut(&field, 240.0).expect("a square");
/// assert_eq!(pieces.keys().collect::<Vec<_>>(), [&[0, 0], &[1, 0]]);
/// ```
pub fn cut(polygon: &Rings, side: f64) -> Result<BTreeMap<CellIndex, Vec<Rings>>, Tangled> {
    let mut found = BTreeMap::new();
    let mut columns = Vec::new();
    split(vec![directed(polygon)], 0, side, &mut columns)?;
    for (column, pieces) in columns {
        let mut rows = Vec::new();
        split(pieces, 1, side, &mut rows)?;
        for (row, pieces) in rows {
            found.insert([column, row], pieces);
        }
    }
    Ok(found)
}

/// Land of a polygon in square metres, holes taken off.
#[must_use]
pub fn land(rings: &Rings) -> f64 {
    area(&rings.outer).abs() - rings.holes.iter().map(|hole| area(hole).abs()).sum::<f64>()
}

/// The polygon with its outline counterclockwise and its holes clockwise.
fn directed(polygon: &Rings) -> Rings {
    let turned = |ring: &Vec<Point>, counterclockwise: bool| {
        // A zero has one sign: corners are compared by their bits.
        let mut ring: Vec<Point> = ring.iter().map(|corner| corner.map(|number| number + 0.0)).collect();
        if (area(&ring) > 0.0) != counterclockwise {
            ring.reverse();
        }
        ring
    };
    Rings { outer: turned(&polygon.outer, true), holes: polygon.holes.iter().map(|hole| turned(hole, false)).collect() }
}

/// Halves pieces along an axis until each is in one strip of cells; appends them to `strips`, in order.
fn split(pieces: Vec<Rings>, axis: usize, side: f64, strips: &mut Vec<(i32, Vec<Rings>)>) -> Result<(), Tangled> {
    let corners = || pieces.iter().flat_map(|piece| &piece.outer).map(|corner| corner[axis]);
    let (low, high) = (corners().fold(f64::INFINITY, f64::min), corners().fold(f64::NEG_INFINITY, f64::max));
    if pieces.is_empty() {
        return Ok(());
    }
    let (first, last) = ((low / side).floor(), (high / side).ceil() - 1.0);
    if last <= first {
        strips.push((first as i32, pieces));
        return Ok(());
    }
    let border = ((first + last + 1.0) / 2.0).floor() * side;
    for is_low in [true, false] {
        let kept = Side { axis, border, is_low };
        let mut halves = Vec::new();
        for piece in &pieces {
            halves.extend(half(piece, kept)?);
        }
        split(halves, axis, side, strips)?;
    }
    Ok(())
}

/// The half plane that is kept.
#[derive(Clone, Copy)]
struct Side {
    axis: usize,
    border: f64,
    /// What is kept is below the border.
    is_low: bool,
}

impl Side {
    /// A point on the border is not kept: then what lies in the border has no say in where land is.
    fn keeps(self, point: Point) -> bool {
        if self.is_low { point[self.axis] < self.border } else { point[self.axis] > self.border }
    }

    /// Where an edge that is kept at one end meets the border.
    fn meets(self, a: Point, b: Point) -> Point {
        let (a, b) = if a[self.axis] < b[self.axis] { (a, b) } else { (b, a) };
        if let Some(&on) = [a, b].iter().find(|end| end[self.axis] == self.border) {
            return on;
        }
        let across = 1 - self.axis;
        let share = (self.border - a[self.axis]) / (b[self.axis] - a[self.axis]);
        let at =
            (a[across] + (b[across] - a[across]) * share).clamp(a[across].min(b[across]), a[across].max(b[across]));
        let mut point = [self.border; 2];
        point[across] = at;
        point
    }

    /// The order of ends along the border, seen a little inside of what is kept.
    fn order(self, a: &End, b: &End) -> Ordering {
        let across = 1 - self.axis;
        let by_angle = || {
            let turned = turn(a.at, a.inner, b.inner);
            if self.is_low == (self.axis == 1) { turned.reverse() } else { turned }
        };
        a.at[across].total_cmp(&b.at[across]).then_with(by_angle)
    }
}

/// An end of a chain on the border.
struct End {
    at: Point,
    /// Its neighbor in the chain.
    inner: Point,
    chain: usize,
    /// The chain leaves what is kept here.
    leaves: bool,
}

/// The part of a polygon on one side of a border.
fn half(piece: &Rings, side: Side) -> Result<Vec<Rings>, Tangled> {
    let (mut rings, mut chains) = (Vec::new(), Vec::new());
    for ring in std::iter::once(&piece.outer).chain(&piece.holes) {
        match ring.iter().filter(|corner| side.keeps(**corner)).count() {
            0 => {}
            kept if kept == ring.len() => rings.push(ring.clone()),
            _ => chains.extend(chains_of(ring, side)),
        }
    }
    if chains.is_empty() {
        return Ok(nested(rings));
    }
    for ring in joined(&chains, side)? {
        unpinched(&ring, &mut rings);
    }
    Ok(nested(rings))
}

/// The stretches of a ring that are kept, each with its two ends on the border.
fn chains_of(ring: &[Point], side: Side) -> Vec<Vec<Point>> {
    let count = ring.len();
    let corner = |index: usize| ring[index % count];
    let begins = (0..count).filter(|&index| side.keeps(corner(index)) && !side.keeps(corner(index + count - 1)));
    let chain = |begin: usize| {
        let mut chain = vec![side.meets(corner(begin + count - 1), corner(begin))];
        let length = (0..count).take_while(|step| side.keeps(corner(begin + step))).count();
        chain.extend((0..length).map(|step| corner(begin + step)));
        chain.push(side.meets(corner(begin + length - 1), corner(begin + length)));
        chain
    };
    begins.map(chain).collect()
}

/// Chains joined along the border to rings.
fn joined(chains: &[Vec<Point>], side: Side) -> Result<Vec<Vec<Point>>, Tangled> {
    let mut ends = Vec::with_capacity(2 * chains.len());
    for (chain, points) in chains.iter().enumerate() {
        let last = points.len() - 1;
        ends.push(End { at: points[0], inner: points[1], chain, leaves: false });
        ends.push(End { at: points[last], inner: points[last - 1], chain, leaves: true });
    }
    ends.sort_by(|a, b| side.order(a, b));
    let mut next = vec![0; chains.len()];
    for pair in ends.chunks(2) {
        match pair {
            [a, b] if a.leaves && !b.leaves => next[a.chain] = b.chain,
            [a, b] if b.leaves && !a.leaves => next[b.chain] = a.chain,
            _ => return Err(Tangled { near: pair[0].at }),
        }
    }
    let mut done = vec![false; chains.len()];
    let mut rings = Vec::new();
    for start in 0..chains.len() {
        let (mut ring, mut chain) = (Vec::new(), start);
        while !done[chain] {
            done[chain] = true;
            ring.extend_from_slice(&chains[chain]);
            chain = next[chain];
        }
        rings.push(ring);
    }
    Ok(rings)
}

/// A ring that comes to a corner twice is two rings.
fn unpinched(ring: &[Point], rings: &mut Vec<Vec<Point>>) {
    let mut walked: Vec<Point> = Vec::new();
    let mut at: BTreeMap<[u64; 2], usize> = BTreeMap::new();
    for &corner in ring {
        if let Some(&before) = at.get(&corner.map(f64::to_bits)) {
            let closed = walked.split_off(before);
            for gone in &closed {
                at.remove(&gone.map(f64::to_bits));
            }
            if closed.len() >= 3 {
                rings.push(closed);
            }
        }
        at.insert(corner.map(f64::to_bits), walked.len());
        walked.push(corner);
    }
    if walked.len() >= 3 {
        rings.push(walked);
    }
}

/// Outlines with the holes that are theirs.
fn nested(rings: Vec<Vec<Point>>) -> Vec<Rings> {
    let (mut outlines, mut holes) = (Vec::new(), Vec::new());
    for ring in rings {
        match area(&ring) {
            land if land > 0.0 => outlines.push(Rings { outer: ring, holes: Vec::new() }),
            land if land < 0.0 => holes.push(ring),
            _ => {}
        }
    }
    for hole in holes {
        // A hole may touch its outline with corners, so all of them and the middles of its edges are asked.
        let inside = |outline: &Rings| {
            let middle = |(a, b): (&Point, &Point)| [0, 1].map(|axis| (a[axis] + b[axis]) / 2.0);
            let asked = hole.iter().copied().chain(edges(&hole).map(middle));
            asked.filter(|point| contains(&outline.outer, &[], *point)).count()
        };
        let owner = if outlines.len() > 1 {
            (0..outlines.len()).max_by_key(|&index| inside(&outlines[index]))
        } else {
            Some(0)
        };
        if let Some(outline) = owner.and_then(|index| outlines.get_mut(index)) {
            outline.holes.push(hole);
        }
    }
    outlines
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::forest::random::{mix64, unit};

    fn rectangle(x: [f64; 2], y: [f64; 2]) -> Vec<Point> {
        vec![[x[0], y[0]], [x[1], y[0]], [x[1], y[1]], [x[0], y[1]]]
    }

    fn lands(pieces: &BTreeMap<CellIndex, Vec<Rings>>) -> Vec<(CellIndex, Vec<f64>)> {
        pieces.iter().map(|(index, pieces)| (*index, pieces.iter().map(land).collect())).collect()
    }

    #[test]
    fn a_comb_is_several_pieces_in_the_cell_of_its_teeth() {
        // A spine in column 1, teeth that reach into column 0.
        let comb = vec![
            [15.0, 1.0],
            [15.0, 9.0],
            [5.0, 9.0],
            [5.0, 7.0],
            [12.0, 7.0],
            [12.0, 6.0],
            [5.0, 6.0],
            [5.0, 4.0],
            [12.0, 4.0],
            [12.0, 3.0],
            [5.0, 3.0],
            [5.0, 1.0],
        ];
        let pieces = cut(&Rings { outer: comb, holes: vec![] }, 10.0).expect("a comb");
        assert_eq!(lands(&pieces), [([0, 0], vec![10.0, 10.0, 10.0]), ([1, 0], vec![5.0 * 8.0 - 2.0 * 2.0])]);
    }

    #[test]
    fn a_hole_over_a_border_becomes_part_of_the_outlines_and_others_stay_holes() {
        let holes = vec![rectangle([8.0, 12.0], [4.0, 6.0]), rectangle([2.0, 4.0], [2.0, 4.0])];
        let pieces = cut(&Rings { outer: rectangle([1.0, 19.0], [1.0, 9.0]), holes }, 10.0).expect("a frame");
        assert_eq!(lands(&pieces), [([0, 0], vec![72.0 - 4.0 - 4.0]), ([1, 0], vec![72.0 - 4.0])]);
        assert_eq!((pieces[&[0, 0]][0].holes.len(), pieces[&[1, 0]][0].holes.len()), (1, 0));
    }

    #[test]
    fn what_touches_a_border_is_cut_there_without_edges_of_no_width() {
        // A hole that touches the border with a corner; an outline with an edge in it.
        let hole = vec![[10.0, 5.0], [7.0, 4.0], [7.0, 6.0]];
        let outer = vec![[2.0, 1.0], [10.0, 1.0], [10.0, 2.0], [15.0, 2.0], [15.0, 9.0], [2.0, 9.0]];
        let pieces = cut(&Rings { outer, holes: vec![hole] }, 10.0).expect("land");
        assert_eq!(lands(&pieces), [([0, 0], vec![64.0 - 3.0]), ([1, 0], vec![35.0])]);
        let left = &pieces[&[0, 0]][0];
        assert_eq!((left.outer.len(), left.holes.len()), (5, 1), "{left:?}");
    }

    #[test]
    fn a_bow_tie_is_told_where_a_border_finds_it() {
        let tie = Rings {
            outer: vec![[5.0, 2.0], [15.0, 2.0], [5.0, 8.0], [15.0, 8.0], [30.0, 9.0], [30.0, 1.0]],
            holes: vec![],
        };
        // Cut or not, never a panic; and the reader of files refuses it before.
        let _ = cut(&tie, 10.0);
    }

    /// Of stars with a star for a hole, every point of the plane is in a piece exactly where it was in the star, and land is kept.
    #[test]
    fn stars_keep_their_land_and_their_points() {
        for star in 0..40_u64 {
            let chance = |number: u64| unit(mix64(star * 10_000 + number));
            let ring = |reach: f64, first: u64| -> Vec<Point> {
                (0..60)
                    .map(|corner| {
                        let angle = f64::from(corner) / 60.0 * 2.0 * crate::math::PI;
                        let far = reach * (0.45 + 0.55 * chance(first + corner as u64));
                        [47.0 + far * crate::math::cos(angle), -13.0 + far * crate::math::sin(angle)]
                    })
                    .collect()
            };
            let whole = Rings { outer: ring(60.0, 0), holes: vec![ring(26.0, 100)] };
            let pieces = cut(&whole, 10.0).expect("a star");
            let sum: f64 = pieces.values().flatten().map(land).sum();
            assert!((sum - land(&whole)).abs() < 1e-9 * sum, "{star}: {sum} {}", land(&whole));
            for number in 0..500 {
                let point = [110.0 * chance(1000 + 2 * number) - 10.0, 120.0 * chance(1001 + 2 * number) - 75.0];
                let index = point.map(|number| (number / 10.0).floor() as i32);
                let count = pieces.get(&index).map_or(0, |pieces| {
                    pieces.iter().filter(|piece| contains(&piece.outer, &piece.holes, point)).count()
                });
                assert_eq!(count, usize::from(contains(&whole.outer, &whole.holes, point)), "{star} {point:?}");
            }
            for (index, pieces) in &pieces {
                for piece in pieces {
                    assert_eq!(
                        crate::forest::polygon::self_crossing(&piece.outer, &piece.holes),
                        None,
                        "{star} {index:?}"
                    );
                    assert!(piece.outer.iter().all(|corner| (0..2).all(|axis| {
                        (10.0 * f64::from(index[axis])..=10.0 * f64::from(index[axis] + 1)).contains(&corner[axis])
                    })));
                }
            }
        }
    }
}
