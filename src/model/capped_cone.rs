//! Capped cones: SIPP's cone and cylinder, closed at every end that has a radius.
//!
//! Why caps of triangles around a middle and not one n-gon: it is SIPP's count, and a rasterizer that takes triangles only
//! gets round ones. The caps stand on the side's own rim vertices, so nothing opens; they are flat, so the rim is a hard edge.
//!
//! Source: J. Yngvesson and I. Wallin, "SIPP User's Guide", Linkoping University.

use super::cone::Cone;
use super::segments::{MAX_CIRCLE, MIN_CIRCLE};
use super::{Detail, Sheet};

/// Adds the side of `side` and its caps; nothing where it has no length or no radius.
pub(super) fn capped_cone(side: &Cone, detail: Detail, sheet: &mut Sheet<'_>) {
    if !side.has_extent() || side.is_flat() {
        return;
    }
    let n = detail.pair()[0].clamp(MIN_CIRCLE, MAX_CIRCLE);
    let base = side.quads(n, sheet);
    let apex = base + n;
    if side.base_radius > 0.0 {
        let middle = sheet.corner(side.base);
        // Seen from below, the rim runs the other way round.
        (0..n).for_each(|i| sheet.flat([base + (i + 1) % n, base + i, middle]));
    }
    if side.apex_radius > 0.0 {
        let middle = sheet.corner(side.apex);
        (0..n).for_each(|i| sheet.flat([apex + i, apex + (i + 1) % n, middle]));
    }
}
