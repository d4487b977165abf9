//! Prisms and blocks: an outline raised along z and closed; flat faces, hard edges.
//!
//! Why shared corners although every face has a normal of its own: faces are lit as facets, which take no normal from
//! their vertices, so eight corners are enough for a block and closedness can be seen in the indices.
//!
//! Source: J. Yngvesson and I. Wallin, "SIPP User's Guide", Linkoping University. Cost: n + 2 polygons for n points.

use super::Sheet;
use crate::math::Vec3;

/// Adds a box about the origin of full size `size`; nothing where it is flat.
pub(super) fn block(size: Vec3, sheet: &mut Sheet<'_>) {
    let (x, y) = (size.x / 2.0, size.y / 2.0);
    if x > 0.0 && y > 0.0 {
        prism(&[[-x, -y], [x, -y], [x, y], [-x, y]], size.z, sheet);
    }
}

/// Adds the prism over `outline` (counterclockwise seen from +z) from -height/2 to height/2.
pub(super) fn prism(outline: &[[f64; 2]], height: f64, sheet: &mut Sheet<'_>) {
    let finite = height.is_finite() && outline.iter().flatten().all(|number| number.is_finite());
    if !finite || outline.len() < 3 || height <= 0.0 {
        return;
    }
    let mut level = |z: f64| {
        let first = sheet.mesh.vertices.len() as u32;
        outline.iter().for_each(|&[x, y]| {
            sheet.corner(Vec3::new(x, y, z));
        });
        first
    };
    let (bottom, top) = (level(-height / 2.0), level(height / 2.0));
    let n = outline.len() as u32;
    // Seen from below, the outline runs the other way round.
    sheet.flat((bottom..bottom + n).rev());
    sheet.flat(top..top + n);
    for i in 0..n {
        let next = (i + 1) % n;
        sheet.flat([bottom + i, bottom + next, top + next, top + i]);
    }
}
