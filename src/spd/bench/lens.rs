//! Matrices of a camera and colors by chance, for the scenes of this room.
//!
//! Space: OpenGL's: eye space looks along -z, clip space has w = -z. Column-major.

use crate::math::{Vec3, radians, tan};

/// A view matrix: the world as an eye at `from` sees it that looks at `at`; `up` is not along the view.
pub(super) fn view(from: Vec3, at: Vec3, up: Vec3) -> [f32; 16] {
    let back = (from - at).normalize();
    let right = up.cross(back).normalize();
    let up = back.cross(right);
    let [r, u, b] = [right, up, back];
    let columns = [
        [r.x, u.x, b.x, 0.0],
        [r.y, u.y, b.y, 0.0],
        [r.z, u.z, b.z, 0.0],
        [-r.dot(from), -u.dot(from), -b.dot(from), 1.0],
    ];
    matrix(columns)
}

/// A perspective with `angle` degrees across a square picture.
pub(super) fn perspective(angle: f64, near: f64, far: f64) -> [f32; 16] {
    let scale = 1.0 / tan(radians(angle) / 2.0);
    let depth = far - near;
    matrix([
        [scale, 0.0, 0.0, 0.0],
        [0.0, scale, 0.0, 0.0],
        [0.0, 0.0, -(far + near) / depth, -1.0],
        [0.0, 0.0, -2.0 * far * near / depth, 0.0],
    ])
}

fn matrix(columns: [[f64; 4]; 4]) -> [f32; 16] {
    std::array::from_fn(|at| columns[at / 4][at % 4] as f32)
}

/// Three channels in `from..1`, different for every `number`: a mixed counter, no state.
pub(super) fn color(number: u64, from: f32) -> [f32; 3] {
    let mut bits = number.wrapping_mul(0x9E37_79B9_7F4A_7C15).wrapping_add(0x1996);
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    bits ^= bits >> 31;
    // Sixteen bits a channel are exact in single precision.
    [0, 16, 32].map(|shift| from + (1.0 - from) * ((bits >> shift) & 0xFFFF) as f32 / 65536.0)
}

/// A point in single precision.
pub(super) fn single(point: Vec3) -> [f32; 3] {
    point.to_array().map(|number| number as f32)
}
