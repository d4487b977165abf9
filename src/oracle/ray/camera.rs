//! Camera: from a place in the picture to a ray.
//!
//! The angle is measured across the smaller side of the picture, between its outer edges or (`--angle centers`) between the
//! centers of its first and last pixel: there the direction is half the angle off the axis, and directions are linear in
//! between.
//!
//! Space: places are in samples, x right, y down; rays in world space.

use super::RayError;
use crate::math::{Vec3, radians, tan, unit};
use crate::plan::{AngleSpan, Choices};
use crate::scene::Camera;

/// The view mapping.
#[derive(Clone, Copy, Debug)]
pub(super) struct Eye {
    pub position: Vec3,
    forward: Vec3,
    /// Change of direction a sample to the right, and a sample down.
    across: Vec3,
    down: Vec3,
    middle: (f64, f64),
    /// What is nearer, or farther, is not seen.
    pub hither: f64,
    pub yon: f64,
    /// Width and height in samples.
    pub size: (u32, u32),
}

impl Eye {
    pub fn new(camera: &Camera, choices: &Choices) -> Result<Eye, RayError> {
        let (width, height) = choices.size.unwrap_or(camera.resolution);
        if width == 0 || height == 0 || choices.samples == 0 {
            return Err(RayError::Camera("it has no pixels"));
        }
        let gaze = camera.at - camera.from;
        let forward = unit(gaze).ok_or(RayError::Camera("it looks nowhere"))?;
        let up = unit(camera.up).ok_or(RayError::Camera("it has no up"))?;
        if !(camera.angle > 0.0 && camera.angle < 180.0) {
            return Err(RayError::Camera("its angle is not between 0 and 180 degrees"));
        }
        let hither = if camera.hither > 0.0 { camera.hither } else { gaze.length() / 1000.0 };
        let yon = camera.yon.unwrap_or(f64::INFINITY);
        if !(yon > hither && hither.is_finite()) {
            return Err(RayError::Camera("yon is not behind hither"));
        }
        let right = sideways(forward, up);
        // Pixels between the two places that are the whole angle apart.
        let apart = match (width.min(height), choices.angle) {
            (1, _) | (_, AngleSpan::Edges) => f64::from(width.min(height)),
            (pixels, AngleSpan::Centers) => f64::from(pixels) - 1.0,
        };
        let tangent_a_sample = 2.0 * tan(radians(camera.angle) / 2.0) / (apart * f64::from(choices.samples));
        let size = (width * choices.samples, height * choices.samples);
        Ok(Eye {
            position: camera.from,
            forward,
            across: right * tangent_a_sample,
            down: forward.cross(right) * tangent_a_sample,
            middle: (f64::from(size.0) / 2.0, f64::from(size.1) / 2.0),
            hither,
            yon,
            size,
        })
    }

    /// The direction of the ray through a place; 1 along the view.
    pub fn ray(&self, x: f64, y: f64) -> Vec3 {
        self.forward + self.across * (x - self.middle.0) + self.down * (y - self.middle.1)
    }
}

/// Right of the view. Where `up` lies along it, the axis that lies least along it takes its place.
fn sideways(forward: Vec3, up: Vec3) -> Vec3 {
    let right = forward.cross(up);
    if right.length() > 1e-12 {
        return right.normalize();
    }
    let along = forward.abs();
    let axis = if along.x <= along.y && along.x <= along.z {
        Vec3::X
    } else if along.y <= along.z {
        Vec3::Y
    } else {
        Vec3::Z
    };
    forward.cross(axis).normalize()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Place;

    fn camera(resolution: (u32, u32)) -> Camera {
        let (from, at, up) = (Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, Vec3::Y);
        Camera { from, at, up, angle: 90.0, hither: 1.0, yon: None, resolution, place: Place::default() }
    }

    #[test]
    fn the_border_is_half_the_angle_off() {
        let close = |a: Vec3, b: Vec3| assert!((a - b).length() < 1e-14, "{a} {b}");
        let edges = Eye::new(&camera((8, 4)), &Choices::default()).expect("a fine camera");
        // The upper edge, 45 degrees up; the left edge, twice as far.
        close(edges.ray(4.0, 0.0), Vec3::new(0.0, 1.0, -1.0));
        close(edges.ray(0.0, 2.0), Vec3::new(-2.0, 0.0, -1.0));
        let choices = Choices { angle: AngleSpan::Centers, samples: 2, ..Choices::default() };
        let centers = Eye::new(&camera((8, 4)), &choices).expect("a fine camera");
        // The center of the first row of pixels is at sample height 1 of 8.
        close(centers.ray(8.0, 1.0), Vec3::new(0.0, 1.0, -1.0));
    }
}
