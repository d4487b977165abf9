//! The view: how eye space lies in the world and how the picture lies in eye space.
//!
//! Eye space: origin in the eye, x right, y up, z along the view. It is left-handed (the world is right-handed),
//! so that depth grows away from the eye; turning world into eye space therefore mirrors.
//!
//! Why world minus eye first: both may be 1e8 large and the detail 1 small. The difference of two nearby `f64` is
//! exact; a matrix with the eye's position folded in would round at the size of the world.
//!
//! Why a unit: depth is 1/w, and in single precision 1/w has no room below 1e-45 and above 3e38. In a scene whose hither is
//! that small or large, eye space is measured in another unit, a power of two, so that nothing is rounded. In all
//! others the unit is 1 (`docs/decisions/0012-eye-space-has-a-unit.md`).

use super::PlanError;
use super::choices::{AngleSpan, Choices};
use crate::math::{Affine3, Mat3, Vec3, length, radians, tan, unit};
use crate::scene::Camera;

/// A camera made ready: orientation, planes, and the scale from eye space to samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// The eye, world space.
    pub eye: Vec3,
    /// Rows right, up, forward; applies to `world - eye`.
    pub eye_from_world: Mat3,
    /// Scene units in one unit of eye space: a power of two, and 1 unless hither is extreme.
    pub unit: f64,
    /// Distance of the near plane, in units of eye space; above 0.
    pub hither: f64,
    /// Distance of the far plane, in units of eye space; above `hither`, or infinite.
    pub yon: f64,
    /// Width and height of the picture in pixels.
    pub pixels: (u32, u32),
    /// A: samples per pixel in each direction.
    pub samples: u32,
    /// Samples per unit of x/z: a point (x, y, z) lands `x / z * scale` samples right of the middle.
    pub scale: f64,
}

impl View {
    /// Makes `camera` ready for a picture of the chosen size.
    ///
    /// # Errors
    /// [`PlanError`] when the camera has no direction, the angle or the planes make no sense, or the picture is too large.
    pub fn new(camera: &Camera, choices: &Choices) -> Result<View, PlanError> {
        let pixels = choices.size.unwrap_or(camera.resolution);
        check_size(pixels, choices)?;
        let distance = camera.at - camera.from;
        let forward = unit(distance).ok_or(PlanError::NoDirection)?;
        let up = unit(camera.up).ok_or(PlanError::NoUp)?;
        if !(camera.angle > 0.0 && camera.angle < 180.0) {
            return Err(PlanError::Angle(camera.angle));
        }
        let hither = if camera.hither > 0.0 { camera.hither } else { length(distance) / 1000.0 };
        let yon = camera.yon.unwrap_or(f64::INFINITY);
        if !(yon > hither && hither.is_finite()) {
            return Err(PlanError::YonNotBehindHither { hither, yon });
        }
        // The angle spans the smaller side, as in SIPP: nothing of a square view is lost in a wide window.
        let side = f64::from(pixels.0.min(pixels.1));
        // One pixel has no first and last center to measure between.
        let span = if choices.angle == AngleSpan::Centers && side > 1.0 { side - 1.0 } else { side };
        let scale = span / 2.0 / tan(radians(camera.angle) / 2.0) * f64::from(choices.samples);
        let right = right_of(forward, up);
        let eye_from_world = Mat3::from_cols(right, right.cross(forward), forward).transpose();
        let unit = unit_of_eye_space(hither);
        let (hither, yon) = (hither / unit, yon / unit);
        Ok(View { eye: camera.from, eye_from_world, unit, hither, yon, pixels, samples: choices.samples, scale })
    }

    /// A world point in eye space.
    #[must_use]
    pub fn to_eye(&self, world: Vec3) -> Vec3 {
        self.eye_from_world * ((world - self.eye) * (1.0 / self.unit))
    }

    /// The whole map from world to eye space as one matrix, for estimates; [`View::to_eye`] rounds less.
    #[must_use]
    pub fn eye_from_world_affine(&self) -> Affine3 {
        let per_unit = 1.0 / self.unit;
        Affine3::from_mat3_translation(self.eye_from_world * per_unit, -(self.eye_from_world * (self.eye * per_unit)))
    }

    /// Width and height of the sample grid.
    #[must_use]
    pub fn sample_size(&self) -> (u32, u32) {
        (self.pixels.0 * self.samples, self.pixels.1 * self.samples)
    }

    /// Half the sample grid, the middle of the picture in samples.
    #[must_use]
    pub fn half(&self) -> (f64, f64) {
        let (width, height) = self.sample_size();
        (f64::from(width) / 2.0, f64::from(height) / 2.0)
    }

    /// Factors that take eye x and y to clip coordinates, where the sides of the picture are x = +-w and y = +-w.
    #[must_use]
    pub fn clip_from_eye(&self) -> (f64, f64) {
        let (half_width, half_height) = self.half();
        (self.scale / half_width, self.scale / half_height)
    }
}

fn check_size(pixels: (u32, u32), choices: &Choices) -> Result<(), PlanError> {
    let (width, height) = pixels;
    if width == 0 || height == 0 {
        return Err(PlanError::EmptyPicture { width, height });
    }
    if choices.samples == 0 || choices.samples > 64 {
        return Err(PlanError::Samples(choices.samples));
    }
    let count = u64::from(width) * u64::from(height);
    if count > choices.max_pixels {
        return Err(PlanError::PictureTooLarge { width, height, limit: choices.max_pixels });
    }
    // Fixed-point products of screen coordinates are proven not to overflow up to 2^22 samples a side.
    if u64::from(width.max(height)) * u64::from(choices.samples) > 1 << 22 {
        return Err(PlanError::TooManySamples { width, height, samples: choices.samples });
    }
    Ok(())
}

/// The unit that keeps hither between 2^-100 and 2^32. Then 1/w is at most 2^100 and has at least 2^94 below it, in `f32`.
fn unit_of_eye_space(hither: f64) -> f64 {
    let power = |exponent: i64| f64::from_bits(((1023 + exponent) as u64) << 52);
    let (nearest, farthest) = (power(-100), power(32));
    let exponent = crate::math::exponent(hither);
    if hither < nearest {
        power(exponent + 100)
    } else if hither > farthest {
        power(exponent - 32)
    } else {
        1.0
    }
}

/// The picture's x axis. Where `up` lies along the view, the world axis least along it takes its place.
fn right_of(forward: Vec3, up: Vec3) -> Vec3 {
    if let Some(right) = unit(forward.cross(up)).filter(|_| forward.cross(up).length() > 1e-12) {
        return right;
    }
    let least = forward.abs().min_element();
    let axis = Vec3::AXES.into_iter().find(|axis| axis.dot(forward).abs() == least).unwrap_or(Vec3::Y);
    unit(forward.cross(axis)).unwrap_or(Vec3::X)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Place;

    fn camera() -> Camera {
        Camera {
            from: Vec3::new(0.0, 0.0, 5.0),
            at: Vec3::ZERO,
            up: Vec3::Y,
            angle: 90.0,
            hither: 1.0,
            yon: None,
            resolution: (4, 2),
            place: Place::default(),
        }
    }

    #[test]
    fn right_is_right_and_up_is_up() {
        let view = View::new(&camera(), &Choices::default()).expect("a fine camera");
        assert_eq!(view.to_eye(Vec3::new(1.0, 0.0, 0.0)), Vec3::new(1.0, 0.0, 5.0));
        assert_eq!(view.to_eye(Vec3::new(0.0, 2.0, 1.0)), Vec3::new(0.0, 2.0, 4.0));
    }

    #[test]
    fn the_angle_spans_the_smaller_side() {
        let view = View::new(&camera(), &Choices::default()).expect("a fine camera");
        // 90 degrees: x/z = 1 at the upper edge, 1 pixel above the middle of a picture 2 high.
        assert!((view.scale - 1.0).abs() < 1e-15);
    }

    #[test]
    fn up_along_the_view_takes_a_fallback_axis() {
        let view = View::new(&Camera { up: Vec3::Z, ..camera() }, &Choices::default()).expect("falls back");
        assert!(view.eye_from_world.is_finite());
        assert!((view.eye_from_world.determinant().abs() - 1.0).abs() < 1e-12);
    }

    #[test]
    fn an_extreme_hither_has_a_unit_of_its_own() {
        let unit = |hither: f64| {
            let view = View::new(&Camera { hither, ..camera() }, &Choices::default()).expect("a fine camera");
            assert_eq!(view.hither * view.unit, hither);
            (view.unit.log2(), view.hither.log2())
        };
        let power = f64::exp2;
        assert_eq!([1e-30, 1e-3, 1.0, 1e9].map(|hither| unit(hither).0), [0.0; 4]);
        assert_eq!(
            [-1074.0, -128.0, 200.0, 1023.0].map(|k| unit(power(k))),
            [(-974.0, -100.0), (-28.0, -100.0), (168.0, 32.0), (991.0, 32.0)]
        );
    }

    #[test]
    fn nonsense_is_refused() {
        let refused = |camera: Camera| View::new(&camera, &Choices::default()).expect_err("refused").to_string();
        assert!(refused(Camera { at: camera().from, ..camera() }).contains("same point"));
        assert!(refused(Camera { up: Vec3::ZERO, ..camera() }).contains("up"));
        assert!(refused(Camera { angle: 180.0, ..camera() }).contains("180"));
        assert!(refused(Camera { yon: Some(0.5), ..camera() }).contains("yon"));
        assert!(refused(Camera { resolution: (0, 4), ..camera() }).contains("0x4"));
    }
}
