//! The values between the stages, kept for those who want to look: `--dump-stage`.
//!
//! A normal run keeps none of them: polygons take turns in the same memory.

use super::Facing;
use super::clip::ClipVertex;
use crate::math::Vec3;
use crate::screen::Source;

/// Every value that passed between the stages, in order.
#[derive(Clone, Debug, Default)]
pub struct Trace {
    /// What culling saw.
    pub eye: Vec<EyePolygon>,
    /// What clipping left, lit.
    pub clipped: Vec<ClippedPolygon>,
}

/// A polygon in eye space, as culling sees it.
#[derive(Clone, Debug, PartialEq)]
pub struct EyePolygon {
    /// Where it comes from.
    pub source: Source,
    /// Its corners, eye space.
    pub corners: Vec<Vec3>,
    /// Which side the eye sees.
    pub facing: Facing,
}

/// A polygon inside the view volume, as splitting and projecting see it.
#[derive(Clone, Debug, PartialEq)]
pub struct ClippedPolygon {
    /// Where it comes from.
    pub source: Source,
    /// Its corners: clip space (x, y, w), what varies, and where the edge comes from.
    pub vertices: Vec<ClipVertex>,
}
