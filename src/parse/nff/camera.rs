//! The view of a scene: which numbers make a camera, and which do not.

use super::grammar::View;
use super::nonsense::{Nonsense, refuse};
use super::notices::Oddity;
use crate::math::{Vec3, unit};
use crate::scene::{Camera, Place};

/// The camera that a `v` describes; `note` hears what is odd about it.
pub(super) fn camera(view: &View, place: Place, mut note: impl FnMut(Oddity)) -> Result<Camera, Nonsense> {
    let View { from, at, up, angle, hither, .. } = *view;
    if from == at {
        return refuse(2..=8, "the view looks nowhere: `from` and `at` are the same point", "move one of them");
    }
    if up == Vec3::ZERO {
        return refuse(10..=12, "`up` is 0 0 0, which is no direction", "write a direction such as `up 0 0 1`");
    }
    if !(angle > 0.0 && angle < 180.0) {
        let message = format!("the angle of view must be above 0 and below 180 degrees, and is {angle}");
        return refuse(14..=14, message, "it is the full angle across the picture; 45 is usual");
    }
    let resolution = (picture_size(view.resolution.0, 18)?, picture_size(view.resolution.1, 19)?);

    if hither <= 0.0 {
        note(Oddity::NoHither);
    }
    if is_parallel(up, at - from) {
        note(Oddity::UpAlongView);
    }
    Ok(Camera { from, at, up, angle, hither, yon: None, resolution, place })
}

/// A side of the picture in pixels.
fn picture_size(pixels: i64, word: usize) -> Result<u32, Nonsense> {
    let help = "write width and height in pixels: `resolution 512 512`";
    match u32::try_from(pixels) {
        Ok(size) if size > 0 => Ok(size),
        Ok(_) | Err(_) if pixels <= 0 => {
            refuse(word..=word, format!("a picture must be at least 1 pixel wide and high, not {pixels}"), help)
        }
        _ => refuse(word..=word, format!("a picture cannot have {pixels} pixels in a row or column"), help),
    }
}

/// The sine of the angle between two directions is below 10^-12.
pub(in crate::parse) fn is_parallel(a: Vec3, b: Vec3) -> bool {
    match (unit(a), unit(b)) {
        (Some(a), Some(b)) => a.cross(b).length() < 1e-12,
        _ => true,
    }
}
