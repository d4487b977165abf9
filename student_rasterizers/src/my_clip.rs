//! Lab: cut a polygon to the view volume. The handout is `docs/labs/clip.md`.
//!
//! What is here compiles and returns something: the polygon as it came.

use farop::geometry::clip::{ClipVertex, ClipVolume};

/// What is left of `polygon` inside `volume`; no corners when nothing is. To be written.
///
/// * `polygon`: corners in order. `position` is (x, y, w); `edge` is the mark of the edge to the next corner.
/// * `volume`: hither <= w <= yon, -w <= x <= w, -w <= y <= w.
/// * `attributes`: how many of a corner's attributes a new corner interpolates.
#[must_use]
pub fn clip(polygon: &[ClipVertex], _volume: &ClipVolume, _attributes: usize) -> Vec<ClipVertex> {
    // To do: one plane after another. For each edge from a to b: put a if it is inside; put the crossing if one end is.
    polygon.to_vec()
}
