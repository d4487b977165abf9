//! Functions: steps of the geometry stage that students write, by name: clipping a polygon, splitting one into triangles.
//!
//! A step is a plain function, value in, value out, with what the built-in one gets; only the buffers that the built-in keeps for
//! speed are left out. `farop grade clip` and `farop grade triangulate` judge them.

use crate::geometry::clip::{ClipVertex, ClipVolume, Clipped, Clipper};
use crate::geometry::split::{SplitScratch, split};
use crate::math::Vec3;

/// Cuts a polygon to a volume: its corners in order, the volume, and how many attributes a new corner interpolates.
///
/// What is left comes back, wound like the polygon; a polygon inside comes back as it was, one outside as no corners at all.
pub type ClipFunction = dyn Fn(&[ClipVertex], &ClipVolume, usize) -> Vec<ClipVertex> + Send + Sync;

/// Splits an outline in space into triangles of its corners, given a normal that points to where it runs counterclockwise.
pub type TriangulateFunction = dyn Fn(&[Vec3], Vec3) -> Vec<[u32; 3]> + Send + Sync;

/// A function that can be asked for by name.
pub struct Named<F: ?Sized> {
    /// What follows `-r`.
    pub name: String,
    /// One line for lists.
    pub summary: String,
    /// The function.
    pub function: Box<F>,
}

/// The built-in clip, as students write it.
#[must_use]
pub fn sutherland(polygon: &[ClipVertex], volume: &ClipVolume, attributes: usize) -> Vec<ClipVertex> {
    match Clipper::default().clip(polygon, volume, attributes) {
        Clipped::Inside => polygon.to_vec(),
        Clipped::Cut(vertices) => vertices.to_vec(),
        Clipped::Outside | Clipped::NotFinite => Vec::new(),
    }
}

/// The built-in split, as students write it.
#[must_use]
pub fn ears(outline: &[Vec3], normal: Vec3) -> Vec<[u32; 3]> {
    let mut triangles = Vec::new();
    split(outline, normal, &mut SplitScratch::default(), &mut triangles);
    triangles
}
