//! Exact: the area of what polygon and volume share, without rounding.
//!
//! The polygon is the sum of the triangles from its first corner, each with the sign of its turn; a triangle is convex, so what it
//! shares with a half space is at most a quadrilateral. Fractions of whole numbers of any length.
//!
//! Space: 64ths of a unit.

use super::Case;
use num_bigint::BigInt;

/// A point (x, y, w) / divisor, divisor > 0.
#[derive(Clone)]
struct Point {
    place: [BigInt; 3],
    divisor: BigInt,
}

/// Binary places kept in sums of areas.
const PLACES: usize = 160;

/// Twice the area that is left, on the planes yw, wx, xy, in units.
pub(super) fn doubled_area(case: &Case) -> [f64; 3] {
    let whole = |corner: [i64; 3]| Point { place: corner.map(BigInt::from), divisor: BigInt::from(1) };
    let mut sum = [0; 3].map(BigInt::from);
    for pair in case.corners.windows(2).skip(1) {
        let mut triangle = vec![whole(case.corners[0]), whole(pair[0]), whole(pair[1])];
        for plane in planes(case) {
            triangle = inside(&triangle, &plane);
        }
        for (a, b) in crate::math::edges(&triangle) {
            for (axis, sum) in sum.iter_mut().enumerate() {
                let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
                let cross = &a.place[u] * &b.place[v] - &a.place[v] * &b.place[u];
                *sum += (cross << PLACES) / (&a.divisor * &b.divisor);
            }
        }
    }
    // 2^-40 of a 64th squared is far below what is compared.
    sum.map(|sum| ((sum >> (PLACES - 40)).to_string().parse::<f64>().unwrap_or(f64::NAN)) / (1_u64 << 52) as f64)
}

/// Half spaces: a x + b y + c w + d >= 0.
fn planes(case: &Case) -> Vec<[i64; 4]> {
    let mut planes = vec![[0, 0, 1, -case.hither], [1, 0, 1, 0], [-1, 0, 1, 0], [0, 1, 1, 0], [0, -1, 1, 0]];
    planes.extend(case.yon.map(|yon| [0, 0, -1, yon]));
    planes
}

fn inside(polygon: &[Point], plane: &[i64; 4]) -> Vec<Point> {
    let zero = BigInt::from(0);
    // The true distance times the divisor.
    let distance = |p: &Point| {
        let linear: BigInt = p.place.iter().zip(plane).map(|(x, &factor)| x * factor).sum();
        linear + &p.divisor * plane[3]
    };
    let mut kept = Vec::new();
    for (a, b) in crate::math::edges(polygon) {
        let (at_a, at_b) = (distance(a), distance(b));
        if at_a >= zero {
            kept.push(a.clone());
        }
        if (at_a >= zero) != (at_b >= zero) {
            let divisor = &at_a * &b.divisor - &at_b * &a.divisor;
            let place: [BigInt; 3] = std::array::from_fn(|axis| &at_a * &b.place[axis] - &at_b * &a.place[axis]);
            let is_negative = divisor < zero;
            let sign = BigInt::from(if is_negative { -1 } else { 1 });
            kept.push(Point { place: place.map(|x| x * &sign), divisor: divisor * sign });
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::super::Asks;
    use super::*;

    #[test]
    fn areas_of_a_square_and_of_its_part() {
        // x = -1..3, y = -1..1 at w = 2: the right plane leaves x <= 2.
        let corners = [(-1, -1), (3, -1), (3, 1), (-1, 1)].map(|(x, y)| [64 * x, 64 * y, 128]);
        let case = |corners: &[[i64; 3]]| Case {
            asks: Asks::Shape,
            corners: corners.to_vec(),
            apex: None,
            hither: 64,
            yon: None,
        };
        assert_eq!(doubled_area(&case(&corners)), [0.0, 0.0, 12.0]);
        let behind = corners.map(|[x, y, w]| [x, y, -w]);
        assert_eq!(doubled_area(&case(&behind)), [0.0; 3]);
        // A notch from above: what is cut out counts against the rest.
        let notched = [[-64, -64, 128], [64, -64, 128], [64, 64, 128], [0, 0, 128], [-64, 64, 128]];
        assert_eq!(doubled_area(&case(&notched)), [0.0, 0.0, 6.0]);
    }
}
