//! Matrices -> camera: where a `.ftri` file is seen from.
//!
//! The projection is for a picture as wide as high; a renderer divides its first number by width / height, so the angle is that of
//! the height. farop's angle spans the smaller side (decision 3): the same unless the picture is higher than wide.
//!
//! Why checked: a matrix that shears or mirrors would be drawn as something else in silence.

use super::vector;
use crate::diagnostic::Diagnostic;
use crate::math::{PI, Vec3, atan};
use crate::scene::{Camera, Place, Triangles};

/// Width and height where nobody asks for others; the file names none.
const RESOLUTION: (u32, u32) = (1024, 1024);
/// How far from a turn the numbers of a matrix in single precision may be.
const ROUGH: f64 = 1e-3;
/// Where the two matrices stand in the file.
const VIEW_AT: usize = 40;
const PROJECTION_AT: usize = 104;

/// The camera of the two matrices and the eye.
pub(super) fn camera(name: &str, triangles: &Triangles) -> Result<Camera, Diagnostic> {
    let wrong = |at: usize, message: &str, help: &str| {
        Err(Diagnostic::error(format!("`{name}`, byte {at}: {message}")).help(help.to_string()))
    };
    let from = vector(triangles.eye);
    let Some((up, forward)) = axes(&triangles.view, from) else {
        let help = "its rows are right, up and back, unit and square to each other, and it takes the eye to 0 0 0";
        return wrong(VIEW_AT, "expected a view matrix that turns and moves, and nothing else", help);
    };
    let Some((scale, hither, yon)) = planes(&triangles.projection) else {
        let help = "a perspective for a picture as wide as high: t 0 0 0, 0 t 0 0, 0 0 a -1, 0 0 b 0, column by column";
        return wrong(PROJECTION_AT, "expected a perspective with 0 < near < far", help);
    };
    let angle = 2.0 * atan(1.0 / scale) * (180.0 / PI);
    let place = Place::default();
    Ok(Camera { from, at: from + forward, up, angle, hither, yon, resolution: RESOLUTION, place })
}

/// Up and forward of a view matrix; `None` where it is none, or not that of the eye at `from`.
fn axes(view: &[f32; 16], from: Vec3) -> Option<(Vec3, Vec3)> {
    let row = |row: usize| Vec3::new(view[row].into(), view[4 + row].into(), view[8 + row].into());
    let moved = Vec3::new(view[12].into(), view[13].into(), view[14].into());
    let [right, up, back] = [0, 1, 2].map(row);
    let is_near = |a: f64, b: f64| (a - b).abs() <= ROUGH;
    let is_square = is_near(right.dot(up), 0.0) && is_near(up.dot(back), 0.0) && is_near(back.dot(right), 0.0);
    let is_unit = [right, up, back].iter().all(|axis| is_near(axis.length_squared(), 1.0));
    let is_turn = is_near(right.cross(up).dot(back), 1.0);
    let eye = Vec3::new(right.dot(from), up.dot(from), back.dot(from)) + moved;
    let is_eye = eye.length() <= ROUGH * (1.0 + from.length());
    let last_row = [view[3], view[7], view[11], view[15]] == [0.0, 0.0, 0.0, 1.0];
    (is_square && is_unit && is_turn && is_eye && last_row).then_some((up, -back))
}

/// 1 / tan of half the angle, hither and yon (`None`: infinitely far) of a perspective; `None` where it is none.
fn planes(projection: &[f32; 16]) -> Option<(f64, f64, Option<f64>)> {
    let others = [1, 2, 3, 4, 6, 7, 8, 9, 12, 13, 15];
    let is_perspective = others.iter().all(|&at| projection[at] == 0.0) && projection[11] == -1.0;
    let [x, y, a, b] = [0, 5, 10, 14].map(|at| f64::from(projection[at]));
    // a = -(far + near) / (far - near), b = -2 far near / (far - near)
    let (hither, yon) = (b / (a - 1.0), b / (a + 1.0));
    let yon = (a != -1.0).then_some(yon);
    let in_order = hither > 0.0 && hither.is_finite() && yon.is_none_or(|yon| yon > hither);
    (is_perspective && x == y && x > 0.0 && in_order).then_some((x, hither, yon))
}
