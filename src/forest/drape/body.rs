//! Body: what of the land's box a view can show, as the corners of a convex solid.
//!
//! view, box -BODY-> points
//!
//! A corner of what two convex solids have in common lies on a face of one and inside the other. So faces of the box are cut by the planes
//! of the view, faces of the view by those of the box, and what is left of them has all corners, most of them several times.
//!
//! Space: world. Cost: twelve faces and six planes each.

use super::View;
use crate::math::Vec3;

/// The part of a face of the land that a view shows; its corners.
pub(super) fn in_view(view: &View, face: &[Vec3]) -> Vec<Vec3> {
    planes_of_view(view).iter().fold(face.to_vec(), |face, plane| cut(&face, plane))
}

/// Inside is where `normal . p >= offset`.
type HalfSpace = (Vec3, f64);

/// Corners of the four sides of each face of a box or of a view, whose corners are numbered in bits: x, y, z.
const FACES: [[usize; 4]; 6] = [[0, 2, 6, 4], [1, 3, 7, 5], [0, 1, 5, 4], [2, 3, 7, 6], [0, 1, 3, 2], [4, 5, 7, 6]];

/// The corners of the view's part of the land; none where it shows none of it.
pub(super) fn seen(view: &View) -> Vec<Vec3> {
    let (frustum, land) = (corners_of_view(view), corners_of_land(view));
    let mut points = Vec::new();
    for (corners, planes) in [(land, planes_of_view(view)), (frustum, planes_of_land(view))] {
        for face in FACES {
            let face = face.map(|corner| corners[corner]).to_vec();
            points.extend(planes.iter().fold(face, |face, plane| cut(&face, plane)));
        }
    }
    points
}

fn corners_of_land(view: &View) -> [Vec3; 8] {
    let [low, high] = view.land;
    std::array::from_fn(|corner| {
        let along = |bit: usize, low, high| if corner >> bit & 1 == 0 { low } else { high };
        Vec3::new(along(0, low.x, high.x), along(1, low.y, high.y), along(2, low.z, high.z))
    })
}

fn planes_of_land(view: &View) -> [HalfSpace; 6] {
    let [low, high] = view.land;
    [
        (Vec3::X, low.x),
        (-Vec3::X, -high.x),
        (Vec3::Y, low.y),
        (-Vec3::Y, -high.y),
        (Vec3::Z, low.z),
        (-Vec3::Z, -high.z),
    ]
}

/// Half the picture, at distance 1.
pub(super) fn half_picture(view: &View) -> [f64; 2] {
    [view.size.0, view.size.1].map(|pixels| f64::from(pixels.max(1)) / 2.0 / view.focal)
}

fn corners_of_view(view: &View) -> [Vec3; 8] {
    let [across, down] = half_picture(view);
    std::array::from_fn(|corner| {
        let sign = |bit: usize| if corner >> bit & 1 == 0 { -1.0 } else { 1.0 };
        let depth = view.depths[corner >> 2 & 1];
        view.from + (view.right * (sign(0) * across) + view.up * (sign(1) * down) + view.ahead) * depth
    })
}

fn planes_of_view(view: &View) -> [HalfSpace; 6] {
    let [across, down] = half_picture(view);
    let side = |axis: Vec3, half: f64| view.ahead + axis / half;
    let normals = [
        side(view.right, across),
        side(-view.right, across),
        side(view.up, down),
        side(-view.up, down),
        view.ahead,
        -view.ahead,
    ];
    let [near, far] = view.depths;
    let shifts = [0.0, 0.0, 0.0, 0.0, near, -far];
    std::array::from_fn(|plane| (normals[plane], normals[plane].dot(view.from) + shifts[plane]))
}

/// The part of a convex face inside a half-space.
fn cut(face: &[Vec3], (normal, offset): &HalfSpace) -> Vec<Vec3> {
    let mut left = Vec::with_capacity(face.len() + 1);
    for (index, &to) in face.iter().enumerate() {
        let from = face[(index + face.len() - 1) % face.len()];
        let (before, after) = (normal.dot(from) - offset, normal.dot(to) - offset);
        if (before < 0.0) != (after < 0.0) {
            left.push(from + (to - from) * (before / (before - after)));
        }
        if after >= 0.0 {
            left.push(to);
        }
    }
    left
}
