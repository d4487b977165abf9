//! Lab: split a polygon into triangles. The handout is `docs/labs/triangulate.md`.
//!
//! What is here compiles and returns something: one triangle.

use farop::math::Vec3;

/// Triangles of the corners of `outline`, three indices each, that cover it once. To be written.
///
/// * `outline`: corners in order, in one plane of space; at least three.
/// * `normal`: points to the side from which the outline runs counterclockwise; any length.
#[must_use]
pub fn triangulate(_outline: &[Vec3], _normal: Vec3) -> Vec<[u32; 3]> {
    // To do: cut ears until three corners are left.
    vec![[0, 1, 2]]
}
