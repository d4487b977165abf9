//! Guide: a compass, and the names of the scene's objects where they are.
//!
//! scene, eye -GUIDE-> marks on the board, text
//!
//! North is +y where z is up, and -z where y is up; east is to its right. A landmark stands where the ball around its object
//! has its middle; hidden ones are named, too: that is what a walker looks for.

use super::board::{Board, ink};
use super::eye::Eye;
use super::stages::short;
use crate::math::Vec3;
use crate::model::{bounding_ball, bounding_ball_of_mesh};
use crate::plan::View;
use crate::scene::{Camera, Scene};

/// Something with a name.
#[derive(Clone, Debug, PartialEq)]
pub struct Landmark {
    /// Of the object.
    pub name: String,
    /// World space.
    pub place: Vec3,
}

/// More than these are not named.
const MOST: usize = 64;

/// The named objects of a scene, in its order.
#[must_use]
pub fn landmarks(scene: &Scene) -> Vec<Landmark> {
    let mut landmarks = Vec::new();
    // A scene that multiplies beyond its budget has no picture either; the plan says so.
    let _ = scene.walk(|placed| {
        if placed.object.name.is_empty() || landmarks.len() == MOST {
            return;
        }
        let surfaces = placed.object.surfaces.iter().map(|&id| scene.surface(id));
        let balls = surfaces.flat_map(|surface| {
            let shapes = surface.primitives.iter().map(|primitive| bounding_ball(&primitive.shape));
            bounding_ball_of_mesh(&surface.mesh).into_iter().chain(shapes)
        });
        let mut centers: Vec<Vec3> = balls.map(|ball| ball.center).collect();
        // A name and nothing else is a place: a landmark of an area.
        if placed.object.surfaces.is_empty() && placed.object.children.is_empty() {
            centers.push(Vec3::ZERO);
        }
        if !centers.is_empty() {
            let middle = centers.iter().copied().sum::<Vec3>() / centers.len() as f64;
            let place = placed.world_from_local.transform_point3(middle);
            landmarks.push(Landmark { name: placed.object.name.clone(), place });
        }
    });
    landmarks
}

/// Degrees that the eye looks to the right of north, 0 to before 360.
#[must_use]
pub fn heading(eye: &Eye) -> f64 {
    let forward = eye.pose.at - eye.pose.from;
    let (east, north) = (forward.dot(eye.east()), forward.dot(eye.north()));
    let length = (east * east + north * north).sqrt();
    if length == 0.0 {
        return 0.0;
    }
    let degrees = crate::math::acos((north / length).clamp(-1.0, 1.0)).to_degrees();
    if east < 0.0 { (360.0 - degrees) % 360.0 } else { degrees }
}

/// Draws the compass into the lower left corner: the letter on top is where the eye looks.
pub(super) fn compass(board: &mut Board, eye: &Eye, scale: i64) {
    let radius = 16 * scale;
    let middle = (radius + 6 * scale, board.height() as i64 - radius - 6 * scale);
    let turn = crate::math::radians(heading(eye));
    let around = |degrees: f64, radius: f64| {
        let angle = crate::math::radians(degrees) - turn;
        (middle.0 as f64 + crate::math::sin(angle) * radius, middle.1 as f64 - crate::math::cos(angle) * radius)
    };
    let (corner, far) = (radius + 4 * scale, radius as f64);
    board.tint((middle.0 - corner, middle.1 - corner), (middle.0 + corner, middle.1 + corner), ink::BLACK, 150);
    let ring: Vec<_> = (0..24).map(|step| around(f64::from(step) * 15.0, far)).collect();
    board.outline(&ring, ink::GRAY);
    board.line(around(0.0, far * 0.55), around(180.0, far * 0.55), ink::WHITE);
    board.area(&[around(0.0, far * 0.6), around(120.0, far * 0.15), around(240.0, far * 0.15)], ink::RED, 256);
    for (letter, degrees) in [("N", 0.0), ("E", 90.0), ("S", 180.0), ("W", 270.0)] {
        let (x, y) = around(degrees, far * 0.8);
        board.text((x as i64 - 2 * scale, y as i64 - 3 * scale), letter, scale, ink::WHITE);
    }
}

/// Writes the names of landmarks where they are in the picture, with their distances.
pub(super) fn names(board: &mut Board, landmarks: &[Landmark], view: &View, scale: i64) {
    names_and(board, landmarks, (view, scale), short);
}

/// As [`names`], with distances in words of the caller's.
fn names_and(board: &mut Board, landmarks: &[Landmark], (view, scale): (&View, i64), told: fn(f64) -> String) {
    let ((half_width, half_height), side) = (view.half(), f64::from(view.samples));
    for landmark in landmarks {
        let eye = view.to_eye(landmark.place);
        if eye.z <= view.hither || !eye.is_finite() {
            continue;
        }
        let x = (half_width + eye.x / eye.z * view.scale) / side;
        let y = (half_height - eye.y / eye.z * view.scale) / side;
        if x < 0.0 || y < 0.0 || x >= board.width() as f64 || y >= board.height() as f64 {
            continue;
        }
        let text = format!("{} {}", landmark.name, told((eye * view.unit).length()));
        board.dot((x, y), 3 * scale, ink::YELLOW);
        let (left, top) = (x as i64 + 4 * scale, y as i64 - 4 * scale);
        let width = text.chars().count() as i64 * 6 * scale;
        board.tint((left - 1, top - 1), (left + width, top + 9 * scale), ink::BLACK, 150);
        board.text((left, top), &text, scale, ink::YELLOW);
    }
}

/// A distance as people say it.
fn metres(distance: f64) -> String {
    if distance < 1000.0 { format!("{distance:.0} m") } else { format!("{:.1} km", distance / 1000.0) }
}

/// Draws the compass and the names of landmarks over a picture that `camera` has seen.
pub fn over(board: &mut Board, camera: &Camera, view: &View, landmarks: &[Landmark]) {
    let scale = if board.height() > 1400 { 2 } else { 1 };
    names_and(board, landmarks, (view, scale), metres);
    compass(board, &Eye::new(camera), scale);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Affine3;
    use crate::scene::{Object, ObjectId, Place};

    #[test]
    fn a_name_and_nothing_else_is_a_place() {
        let object = |name: &str, children: Vec<ObjectId>| Object {
            name: name.to_string(),
            parent_from_local: Affine3::from_translation(Vec3::new(1.0, 2.0, 3.0)),
            surfaces: Vec::new(),
            children,
            place: Place::default(),
        };
        let objects = vec![object("area", vec![ObjectId(1)]), object("Foia", Vec::new()), object("", Vec::new())];
        let scene = Scene { objects, world: vec![ObjectId(0), ObjectId(2)], ..Scene::default() };
        assert_eq!(landmarks(&scene), [Landmark { name: "Foia".to_string(), place: Vec3::new(2.0, 4.0, 6.0) }]);
    }

    #[test]
    fn north_is_ahead_and_east_is_right() {
        let camera = |at: Vec3, up: Vec3| {
            let (from, place) = (Vec3::ZERO, Place::default());
            Camera { from, at, up, angle: 45.0, hither: 0.0, yon: None, resolution: (8, 8), place }
        };
        let of = |at: Vec3, up: Vec3| heading(&Eye::new(&camera(at, up))).round();
        assert_eq!([Vec3::NEG_Z, Vec3::X, Vec3::Z, Vec3::NEG_X].map(|at| of(at, Vec3::Y)), [0.0, 90.0, 180.0, 270.0]);
        assert_eq!([Vec3::Y, Vec3::X, Vec3::NEG_Y].map(|at| of(at, Vec3::Z)), [0.0, 90.0, 180.0]);
        // Straight down there is no heading.
        assert_eq!(of(Vec3::NEG_Y, Vec3::Y), 0.0);
    }
}
