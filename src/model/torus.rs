//! Tori: a tube bent to a ring about the z axis.
//!
//! All quads are planar: two neighbors across the ring are mirror images, so the four corners are an isosceles trapezoid.
//!
//! Why the tube starts at -45 degrees: it is SIPP's; a tube of four segments then has flat top and bottom.
//! Source: J. Yngvesson and I. Wallin, "SIPP User's Guide", Linkoping University. Cost: a sine and cosine a row and a column.

use super::segments::{MAX_SPHERE, MIN_CIRCLE};
use super::turn::turn;
use super::{Detail, Sheet};
use crate::math::Vec3;

/// Adds the torus; nothing where a radius is not above 0. A tube thicker than the ring crosses itself.
pub(super) fn torus(ring_radius: f64, tube_radius: f64, detail: Detail, sheet: &mut Sheet<'_>) {
    let radii = [ring_radius, tube_radius];
    if !radii.iter().all(|&radius| radius > 0.0 && radius.is_finite()) {
        return;
    }
    let [around_ring, around_tube] = detail.pair().map(|n| n.clamp(MIN_CIRCLE, MAX_SPHERE));
    let first = sheet.mesh.vertices.len() as u32;
    for i in 0..around_ring {
        let (x, y) = turn(i, around_ring);
        for j in 0..around_tube {
            // An eighth of a turn back, counted in eighths of a segment.
            let (out, up) = turn((8 * j + 7 * around_tube) % (8 * around_tube), 8 * around_tube);
            let radius = ring_radius + tube_radius * out;
            sheet.vertex(Vec3::new(radius * x, radius * y, tube_radius * up), Vec3::new(out * x, out * y, up));
        }
    }
    let at = |i: u32, j: u32| first + (i % around_ring) * around_tube + j % around_tube;
    for i in 0..around_ring {
        // Outside, the ring runs to the left and the tube upward.
        (0..around_tube).for_each(|j| sheet.facet([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]));
    }
}
