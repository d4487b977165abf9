//! View: the sun, the sky and the eye of an area that brings none.

use super::ground::Land;
use crate::color::Rgb;
use crate::math::Vec3;
use crate::scene::{Camera, Light, LightSource, Place};

/// Display values of a sky with some haze.
pub(super) const SKY: Rgb = Rgb { r: 0.66, g: 0.78, b: 0.90 };

/// The sun of an early afternoon: from the south-west.
pub(super) fn sun() -> Light {
    let source = LightSource::Directional { to_light: Vec3::new(-2.0, -3.0, 4.0) };
    Light { source, color: Rgb::new(1.0, 0.98, 0.92), intensity: Some(1.0), place: Place::default() }
}

/// From above the south edge towards the north: all of the area is in the picture, from its near to its far border.
pub(super) fn camera(land: &Land<'_>) -> Camera {
    let ([west, south], [east, north]) = land.borders();
    let (low, high) = land.heights();
    let (width, depth) = (east - west, north - south);
    let size = width.max(depth).max(1.0);
    let middle = (west + east) / 2.0;
    // Half of the picture's width is tan(20 degrees) * 4/3 = 0.485 of the distance, and the near border is 1.08 sizes away.
    let from = Vec3::new(middle, south - 0.9 * size, high + 0.6 * size);
    let at = Vec3::new(middle, south + 0.45 * depth, (low + high) / 2.0);
    let (hither, resolution) = (size / 1000.0, (640, 480));
    Camera { from, at, up: Vec3::Z, angle: 40.0, hither, yon: None, resolution, place: Place::default() }
}
