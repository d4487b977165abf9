//! Plane: a polygon in space seen as one in the plane.
//!
//! One axis is dropped, the one nearest the normal, and the other two stay as they are: nothing is rounded, so a sign in the
//! plane is the sign in space. A projection along the normal itself would round every coordinate.

use crate::math::{Vec2, Vec3};

/// The two axes that are kept, ordered so that the outline runs counterclockwise.
#[derive(Clone, Copy)]
pub(super) struct Plane {
    right: usize,
    up: usize,
}

impl Plane {
    /// Drops the axis of the largest component of `normal`.
    pub(super) fn facing(outline: &[Vec3], normal: Vec3) -> Plane {
        let size = normal.abs();
        let size = if size.max_element() > 0.0 { size } else { flatness(outline) };
        let dropped = if size.z >= size.x && size.z >= size.y {
            2
        } else if size.y >= size.x {
            1
        } else {
            0
        };
        // Right x up = the dropped axis; seen from its other end, left and right change places.
        let (right, up) = ((dropped + 1) % 3, (dropped + 2) % 3);
        if normal[dropped] < 0.0 { Plane { right: up, up: right } } else { Plane { right, up } }
    }

    /// A point of the outline in the plane.
    pub(super) fn flatten(self, p: Vec3) -> Vec2 {
        Vec2::new(p[self.right], p[self.up])
    }
}

/// Per axis a number that is larger the less the outline extends along it.
fn flatness(outline: &[Vec3]) -> Vec3 {
    let low = outline.iter().copied().fold(Vec3::INFINITY, Vec3::min);
    let high = outline.iter().copied().fold(Vec3::NEG_INFINITY, Vec3::max);
    low - high
}
