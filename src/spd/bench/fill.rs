//! fill: four tilted layers of four squares, each wider than the picture; every vertex has a color of its own.

use super::lens::{color, perspective, single, view};
use crate::math::Vec3;
use crate::scene::{TriangleKind, TriangleRange, Triangles};

/// In which order the layers come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Order {
    FarToNear,
    NearToFar,
}

/// Distances of the layers from the eye, far to near.
const DISTANCES: [f64; 4] = [8.0, 6.0, 4.0, 2.0];

/// The layers, in that order.
pub(super) fn make(order: Order) -> Triangles {
    let mut made = Triangles {
        view: view(Vec3::ZERO, Vec3::NEG_Z, Vec3::Y),
        projection: perspective(60.0, 0.5, 40.0),
        material: [0.1, 0.7, 0.4, 20.0],
        lights: vec![([2.0, 3.0, 2.0], [0.6; 3]), ([-3.0, 1.0, 1.0], [0.5; 3])],
        ..Triangles::default()
    };
    let mut distances = DISTANCES;
    if order == Order::NearToFar {
        distances.reverse();
    }
    for distance in distances {
        layer(distance, &mut made);
    }
    made.texture = vec![[0.0; 2]; made.positions.len()];
    made.ranges = vec![TriangleRange { first: 0, count: made.indices.len() as u32, kind: TriangleKind::Lit }];
    made
}

/// Three by three vertices, six times as wide as far away: wider than any 16:9 picture sees. Right and upper sides lean away.
fn layer(distance: f64, made: &mut Triangles) {
    let first = made.positions.len() as u32;
    for row in 0..3_u32 {
        for column in 0..3_u32 {
            let (x, y) = (f64::from(column) - 1.0, f64::from(row) - 1.0);
            let depth = distance * (1.0 + 0.15 * x + 0.1 * y);
            made.positions.push(single(Vec3::new(3.0 * distance * x, 3.0 * distance * y, -depth)));
            made.normals.push(single(Vec3::new(0.3 * x, 0.3 * y, 1.0).normalize()));
            // A layer keeps its colors in either order.
            made.colors.push(color(distance as u64 * 9 + u64::from(row * 3 + column), 0.3));
        }
    }
    for row in 0..2 {
        for column in 0..2 {
            let a = first + row * 3 + column;
            made.indices.extend([a, a + 1, a + 4, a, a + 4, a + 3]);
        }
    }
}
