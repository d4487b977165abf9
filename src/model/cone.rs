//! Cones, cylinders, discs and rings: the side of a cone, open at both ends, or the flat piece where both ends coincide.
//!
//! Why an apex vertex for every triangle: a cone has no normal at its tip, but each segment next to it has one. One
//! shared tip would have to average them to the direction of the axis, and Gouraud shading would show a bright star.
//!
//! Source: E. Haines, "A Proposal for Standard Graphics Environments", IEEE CG&A 7(11), 1987, and the SPD package.

use super::segments::{MAX_CIRCLE, MIN_CIRCLE};
use super::turn::turn;
use super::{Detail, Sheet};
use crate::math::{Vec3, unit};

/// [`crate::scene::Shape::Cone`].
#[derive(Clone, Copy, Debug)]
pub(super) struct Cone {
    pub base: Vec3,
    pub base_radius: f64,
    pub apex: Vec3,
    pub apex_radius: f64,
}

/// The sine of the angle to the z axis below which a cone counts as upright.
const UPRIGHT: f64 = 1e-6;

/// Three directions, unit and square to each other, in which a cone is simple; and how far its ends are apart.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    /// From base to apex; +z where they coincide.
    pub along: Vec3,
    /// Where the circles start.
    pub across: Vec3,
    /// A quarter turn on, counterclockwise about `along`.
    pub beside: Vec3,
    /// Distance of the ends.
    pub height: f64,
}

impl Frame {
    /// The direction `i / n` turns around the axis.
    fn around(&self, i: u32, n: u32) -> Vec3 {
        let (x, y) = turn(i, n);
        self.across * x + self.beside * y
    }
}

impl Cone {
    /// Finite, and not shrunk to a line, a circle or a point.
    pub(super) fn has_extent(&self) -> bool {
        let radii = [self.base_radius, self.apex_radius];
        let finite =
            (self.apex - self.base).is_finite() && self.base.is_finite() && radii.iter().all(|r| r.is_finite());
        let flat_and_empty = self.is_flat() && self.base_radius == self.apex_radius;
        finite && radii.iter().all(|&r| r >= 0.0) && radii != [0.0, 0.0] && !flat_and_empty
    }

    /// Both ends coincide: a disc or a ring.
    pub(super) fn is_flat(&self) -> bool {
        self.base == self.apex
    }

    /// The frame of the axis; circles start where SPD starts them. The ends are finite.
    pub(super) fn frame(&self) -> Frame {
        let axis = self.apex - self.base;
        let Some(along) = unit(axis) else {
            return Frame { along: Vec3::Z, across: Vec3::X, beside: Vec3::Y, height: 0.0 };
        };
        // Too close to z, the cross product has no direction to speak of. SPD's limit is absolute; a tiny cone would fail it in every
        // direction and a huge one in none, so here it is a part of the cone's own length.
        let beside_z = axis.cross(Vec3::Z);
        let is_upright = along.cross(Vec3::Z).length() < UPRIGHT;
        let across = if is_upright { unit(axis.cross(Vec3::X)) } else { unit(beside_z) };
        let across = across.unwrap_or_else(|| along.any_orthonormal_vector());
        Frame { along, across, beside: along.cross(across), height: axis.dot(along) }
    }

    /// The normal where the circles start to turn: across, tilted towards the thinner end. Divides nothing.
    fn normal(&self, frame: &Frame, outward: Vec3) -> Vec3 {
        if self.is_flat() {
            return Vec3::Z;
        }
        if self.base_radius == self.apex_radius {
            return outward;
        }
        let tilted = outward * frame.height + frame.along * (self.base_radius - self.apex_radius);
        unit(tilted).unwrap_or(outward)
    }

    /// Adds the cone; it has extent.
    pub(super) fn tessellate(&self, detail: Detail, sheet: &mut Sheet<'_>) {
        if !self.has_extent() {
            return;
        }
        let (n, triangles) = match detail {
            Detail::Segments(n) | Detail::Grid([n, _]) => (n.clamp(MIN_CIRCLE, MAX_CIRCLE), false),
            Detail::Resolution(n) => (4 * n.clamp(1, Detail::MAX_RESOLUTION), true),
        };
        match (self.is_flat(), triangles) {
            (true, _) => self.flat(n, triangles, sheet),
            (false, true) => self.triangles(n, sheet),
            (false, false) => {
                self.quads(n, sheet);
            }
        }
    }

    /// The side as `n` planar quads, or as triangles where one end is a point.
    ///
    /// Returns the first of the base's `n` vertices; the apex's follow behind them.
    pub(super) fn quads(&self, n: u32, sheet: &mut Sheet<'_>) -> u32 {
        let frame = self.frame();
        // Push end by end: one vertex a corner, or one a segment where the end is a point.
        let mut end = |center: Vec3, radius: f64| {
            let first = sheet.mesh.vertices.len() as u32;
            for i in 0..n {
                let (position, outward) = if radius == 0.0 {
                    (center, frame.around(2 * i + 1, 2 * n))
                } else {
                    (center + frame.around(i, n) * radius, frame.around(i, n))
                };
                sheet.vertex(position, self.normal(&frame, outward));
            }
            first
        };
        let base = end(self.base, self.base_radius);
        let apex = end(self.apex, self.apex_radius);
        for i in 0..n {
            let next = (i + 1) % n;
            if self.apex_radius == 0.0 {
                sheet.facet([base + i, base + next, apex + i]);
            } else if self.base_radius == 0.0 {
                sheet.facet([base + i, apex + next, apex + i]);
            } else {
                sheet.facet([base + i, base + next, apex + next, apex + i]);
            }
        }
        base
    }

    /// The side as SPD's `2 n` triangles, in SPD's order; at a pointed end every other one has no area.
    fn triangles(&self, n: u32, sheet: &mut Sheet<'_>) {
        let frame = self.frame();
        let base = sheet.mesh.vertices.len() as u32;
        for i in 0..n {
            let outward = frame.around(i, n);
            let normal = self.normal(&frame, outward);
            sheet.vertex(self.base + outward * self.base_radius, normal);
            sheet.vertex(self.apex + outward * self.apex_radius, normal);
        }
        let base_at = |i: u32| base + 2 * (i % n);
        let apex_at = |i: u32| base_at(i) + 1;
        for i in 1..=n {
            sheet.facet([apex_at(i), apex_at(i - 1), base_at(i - 1)]);
            sheet.facet([base_at(i), apex_at(i), base_at(i - 1)]);
        }
    }

    /// The disc (one n-gon, or n triangles around its center) or the ring (quads, or twice as many triangles).
    fn flat(&self, n: u32, triangles: bool, sheet: &mut Sheet<'_>) {
        let frame = self.frame();
        let mut circle = |radius: f64| {
            let first = sheet.mesh.vertices.len() as u32;
            for i in 0..n {
                sheet.vertex(self.base + frame.around(i, n) * radius, Vec3::Z);
            }
            first
        };
        let (inner_radius, outer_radius) =
            (self.base_radius.min(self.apex_radius), self.base_radius.max(self.apex_radius));
        let outer = circle(outer_radius);
        if inner_radius == 0.0 && !triangles {
            return sheet.facet(outer..outer + n);
        }
        if inner_radius == 0.0 {
            let center = sheet.vertex(self.base, Vec3::Z);
            return (0..n).for_each(|i| sheet.facet([outer + i, outer + (i + 1) % n, center]));
        }
        let inner = circle(inner_radius);
        for i in 0..n {
            let next = (i + 1) % n;
            if triangles {
                sheet.facet([outer + i, outer + next, inner + next]);
                sheet.facet([inner + next, inner + i, outer + i]);
            } else {
                sheet.facet([outer + i, outer + next, inner + next, inner + i]);
            }
        }
    }
}
