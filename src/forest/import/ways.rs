//! Ways: roads and rivers of a map, cut at the borders of cells.
//!
//! a line of the map -WAYS-> a line in each cell it goes through
//!
//! A line that goes along a border belongs to the cell north or east of it. Cuts are computed from the lower end of a stretch, so both cells have the same point.
//!
//! Space: metres from the south-west corner of cell 0 0. Cost: linear in points and cells crossed.

use crate::forest::area::CellIndex;
use crate::forest::polygon::Point;

/// The stretches of a line, in order, each with its cell; positions of the world.
#[must_use]
pub fn stretches(line: &[Point], side: f64) -> Vec<(CellIndex, Vec<Point>)> {
    let mut found: Vec<(CellIndex, Vec<Point>)> = Vec::new();
    for pair in line.windows(2) {
        let mut stops = vec![pair[0]];
        stops.extend(cuts(pair[0], pair[1], side));
        stops.push(pair[1]);
        stops.dedup();
        for step in stops.windows(2) {
            let middle = [0, 1].map(|axis| (step[0][axis] + step[1][axis]) / 2.0);
            let cell = middle.map(|number| (number / side).floor() as i32);
            match found.last_mut() {
                Some((last, points)) if *last == cell && points.last() == Some(&step[0]) => points.push(step[1]),
                _ => found.push((cell, step.to_vec())),
            }
        }
    }
    found
}

/// Where a straight stretch meets borders, from its beginning on.
fn cuts(from: Point, to: Point, side: f64) -> Vec<Point> {
    let mut all: Vec<(f64, Point)> = Vec::new();
    for axis in [0, 1] {
        let (a, b) = if from[axis] < to[axis] { (from, to) } else { (to, from) };
        let (first, last) = ((a[axis] / side).floor() as i64 + 1, (b[axis] / side).ceil() as i64 - 1);
        for number in first..=last {
            let border = number as f64 * side;
            let share = (border - a[axis]) / (b[axis] - a[axis]);
            let across = 1 - axis;
            let mut point = [border; 2];
            point[across] = a[across] + (b[across] - a[across]) * share;
            all.push((if a == from { share } else { 1.0 - share }, point));
        }
    }
    all.sort_by(|one, other| one.0.total_cmp(&other.0));
    all.into_iter().map(|(_, point)| point).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_road_over_borders_is_a_stretch_in_each_cell() {
        let found = stretches(&[[5.0, 5.0], [25.0, 5.0], [25.0, 15.0]], 10.0);
        let expected = vec![
            ([0, 0], vec![[5.0, 5.0], [10.0, 5.0]]),
            ([1, 0], vec![[10.0, 5.0], [20.0, 5.0]]),
            ([2, 0], vec![[20.0, 5.0], [25.0, 5.0], [25.0, 10.0]]),
            ([2, 1], vec![[25.0, 10.0], [25.0, 15.0]]),
        ];
        assert_eq!(found, expected);
    }

    #[test]
    fn the_way_back_has_the_same_cuts_and_a_corner_of_cells_is_no_stretch() {
        let way = [[3.0, 1.0], [37.0, 52.5], [-8.0, 20.0]];
        let back: Vec<Point> = way.iter().rev().copied().collect();
        let points = |line: &[Point]| {
            let mut points: Vec<[u64; 2]> = stretches(line, 10.0)
                .into_iter()
                .flat_map(|(_, points)| points)
                .map(|point| point.map(f64::to_bits))
                .collect();
            points.sort_unstable();
            points
        };
        assert_eq!(points(&way), points(&back));
        assert_eq!(stretches(&[[5.0, 5.0], [15.0, 15.0]], 10.0).len(), 2);
        assert!(stretches(&[[5.0, 5.0], [5.0, 5.0]], 10.0).is_empty());
    }
}
