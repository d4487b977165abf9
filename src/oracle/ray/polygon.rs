//! Polygon: whether a ray from the eye goes through a polygon of a mesh, and the normal there.
//!
//! Corners are seen along the ray: a corner's place beside the ray depends on that corner alone, and the side on which an
//! edge passes is computed from its two ends in one fixed order. So neighbors agree about a shared edge and no ray slips
//! through between them.
//!
//! Space: world space, the eye at the origin.
//! Source: Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013, here for any outline; Floater,
//! "Mean value coordinates", Computer Aided Geometric Design 20, 2003, for normals over more than three corners.

use crate::math::{Vec3, edges};

/// Where the ray of `direction` goes through the polygon of `corners` with the given normal: its t.
pub(super) fn meet(corners: impl Iterator<Item = Vec3> + Clone, normal: Vec3, direction: Vec3) -> Option<f64> {
    let first = corners.clone().next()?;
    is_around(corners, direction).then(|| normal.dot(first) / normal.dot(direction))
}

/// Even-odd along the ray.
fn is_around(corners: impl Iterator<Item = Vec3> + Clone, direction: Vec3) -> bool {
    let size = direction.abs();
    let axis = (0..3).max_by(|&a, &b| size[a].total_cmp(&size[b])).unwrap_or(2);
    let (p, q) = ((axis + 1) % 3, (axis + 2) % 3);
    let (lean_p, lean_q) = (direction[p] / direction[axis], direction[q] / direction[axis]);
    let beside = |corner: Vec3| (corner[p] - lean_p * corner[axis], corner[q] - lean_q * corner[axis]);
    let mut inside = false;
    let Some(mut from) = corners.clone().last().map(beside) else { return false };
    for to in corners.map(beside) {
        if (from.1 <= 0.0) != (to.1 <= 0.0) {
            let (low, high) = if from.1 < to.1 { (from, to) } else { (to, from) };
            inside ^= low.0 * high.1 - high.0 * low.1 > 0.0;
        }
        from = to;
    }
    inside
}

/// The mean of the corners' normals at `point`, by weight: linear over a triangle.
pub(super) fn blend(corners: &[Vec3], normals: &[Vec3], point: Vec3, face: Vec3) -> Vec3 {
    let weights = weights(corners, point, face);
    normals.iter().zip(weights).map(|(&normal, weight)| normal * weight).sum()
}

fn weights(corners: &[Vec3], point: Vec3, face: Vec3) -> Vec<f64> {
    if let [a, b, c] = *corners {
        let part = |from: Vec3, to: Vec3| (from - point).cross(to - point).dot(face);
        let parts = [part(b, c), part(c, a), part(a, b)];
        return parts.map(|one| one / parts.iter().sum::<f64>()).to_vec();
    }
    // tan of half the angle under which each edge is seen.
    let half_tangents: Vec<f64> = edges(corners)
        .map(|(&a, &b)| {
            let (a, b) = (a - point, b - point);
            let (sine, cosine) = (a.cross(b).dot(face) / face.length(), a.dot(b));
            sine / (a.length() * b.length() + cosine)
        })
        .collect();
    let count = corners.len();
    let weight = |corner: usize| {
        (half_tangents[(corner + count - 1) % count] + half_tangents[corner]) / (corners[corner] - point).length()
    };
    let all: Vec<f64> = (0..count).map(weight).collect();
    let sum: f64 = all.iter().sum();
    all.into_iter().map(|one| one / sum).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const CORNERS: [Vec3; 5] = [
        Vec3::new(-2.0, -2.0, 4.0),
        Vec3::new(2.0, -2.0, 4.0),
        Vec3::new(2.0, 2.0, 4.0),
        Vec3::new(0.0, -1.0, 4.0),
        Vec3::new(-2.0, 2.0, 4.0),
    ];

    #[test]
    fn a_notch_lets_the_ray_through() {
        let met = |x: f64, y: f64| meet(CORNERS.iter().copied(), Vec3::Z, Vec3::new(x, y, 1.0));
        assert_eq!(met(0.0, -0.375), Some(4.0));
        assert_eq!(met(0.0, 0.25), None);
        assert_eq!((met(0.45, -0.25), met(0.6, 0.0)), (Some(4.0), None));
    }

    #[test]
    fn weights_reproduce_the_point() {
        for corners in [&CORNERS[..], &CORNERS[..3], &CORNERS[..4]] {
            for point in [Vec3::new(0.5, -1.5, 4.0), Vec3::new(1.0, -1.0, 4.0), Vec3::new(1.25, -0.5, 4.0)] {
                let mean = blend(corners, corners, point, Vec3::Z);
                assert!((mean - point).length() < 1e-12, "{} corners: {mean}", corners.len());
            }
        }
    }
}
