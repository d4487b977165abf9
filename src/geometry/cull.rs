//! Cull: which side of a polygon the eye sees.
//!
//! walk -> EyePolygon -> CULL -> clip
//!
//! Facing is decided once, here, before any vertex is snapped: snapping may turn a tiny polygon round, and deciding on
//! snapped vertices would punch holes. The polygon's normal is Newell's; it faces away when the eye is not in front of
//! its plane.
//!
//! Why scaled: area and distance multiply three coordinates, which leaves `f64` beyond 1e103. A power of two brings them
//! near 1 first and changes no sign.
//!
//! An outline that crosses itself so that its parts cancel (a bow-tie) has no Newell normal, but covers samples. Its winding is
//! undefined, so it counts as a front, on the plane of its largest part; coverage is even-odd as ever.
//!
//! Space: eye space, the eye at the origin. Eye space is left-handed, so the Newell normal of a polygon that runs
//! counterclockwise for the viewer points *away* from the viewer.

use super::split::Crossing;
use crate::math::{Vec3, edges, largest_coordinate, newell_normal, ordinary_scale};

/// Coordinates above this are counted as not finite: sums of a few of them are not.
const LARGEST: f64 = f64::MAX / 1024.0;

/// Which side of a polygon the eye sees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Facing {
    /// Its front.
    Front {
        /// Newell normal of the outline, eye space: away from the viewer; see [`newell_normal`] for its length.
        newell: Vec3,
    },
    /// Its back.
    Back {
        /// Newell normal of the outline, eye space: towards the viewer.
        newell: Vec3,
    },
    /// Neither: the eye lies in its plane, or it has no area.
    EdgeOn,
    /// A coordinate is not finite, or so large that sums are not.
    NotFinite,
}

/// A polygon that culling and outcodes leave.
#[derive(Clone, Copy, Debug)]
pub(super) struct Survivor {
    /// Its number in its mesh.
    pub polygon: u32,
    /// Which side the eye sees: front or back.
    pub facing: Facing,
    /// Some of its vertices lie outside a plane, so that it has to be cut.
    pub crossed: bool,
}

impl Facing {
    /// The side of `corners` (eye space) that an eye at the origin sees.
    #[must_use]
    #[inline]
    pub fn of(corners: &[Vec3]) -> Facing {
        let largest = largest_coordinate(corners);
        if corners.is_empty() || largest.is_nan() || largest > LARGEST {
            return Facing::NotFinite;
        }
        let scale = ordinary_scale(largest);
        let newell = newell_normal(corners);
        if corners.len() > 3
            && let Some(normal) = normal_of_bow_tie(corners, newell, scale)
        {
            // It winds both ways, so both its sides are fronts.
            let towards = normal.dot(corners[0] * scale);
            let newell = if towards < 0.0 { -normal } else { normal };
            return if towards == 0.0 { Facing::EdgeOn } else { Facing::Front { newell } };
        }
        let towards = newell.dot(corners[0] * scale);
        if towards > 0.0 {
            Facing::Front { newell }
        } else if towards < 0.0 {
            Facing::Back { newell }
        } else {
            Facing::EdgeOn
        }
    }

    /// The Newell normal of the outline, eye space; zero where there is none.
    #[must_use]
    #[inline]
    pub fn newell(&self) -> Vec3 {
        match *self {
            Facing::Front { newell } | Facing::Back { newell } => newell,
            Facing::EdgeOn | Facing::NotFinite => Vec3::ZERO,
        }
    }

    /// Whether the eye sees the back.
    #[must_use]
    #[inline]
    pub fn is_back(&self) -> bool {
        matches!(self, Facing::Back { .. })
    }

    /// The unit normal on the side that the eye sees.
    #[must_use]
    #[inline]
    pub fn normal_towards_eye(&self) -> Vec3 {
        match *self {
            Facing::Front { newell } => crate::math::unit(-newell).unwrap_or(Vec3::NEG_Z),
            Facing::Back { newell } => crate::math::unit(newell).unwrap_or(Vec3::NEG_Z),
            Facing::EdgeOn | Facing::NotFinite => Vec3::NEG_Z,
        }
    }
}

/// A normal of the plane of an outline that crosses itself so that its parts cancel: it covers samples, and yet its Newell
/// normal is nothing but rounding. `None` for all others.
fn normal_of_bow_tie(corners: &[Vec3], newell: Vec3, scale: f64) -> Option<Vec3> {
    let size = |v: Vec3| v.abs().max_element();
    let from_first = |corner: &Vec3| *corner * scale - corners[0] * scale;
    let reach = corners.iter().map(|corner| size(from_first(corner))).fold(0.0, f64::max);
    if size(newell) > CANCELLED * reach * reach {
        return None;
    }
    // Slender polygons get here, too: against their own triangles they are not small.
    let triangles = || edges(corners).map(|(a, b)| from_first(a).cross(from_first(b)));
    let largest = triangles().reduce(|best, next| if size(next) > size(best) { next } else { best })?;
    let cancels = size(newell) <= CANCELLED * size(largest) && size(largest) > 0.0;
    (cancels && Crossing::default().is_in(corners, largest)).then_some(largest)
}

/// Parts that cancel leave less than this of the largest; far above rounding, far below any area that is meant.
const CANCELLED: f64 = 1e-12;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counterclockwise_for_the_viewer_is_the_front() {
        let mut corners = [Vec3::new(0.0, 0.0, 5.0), Vec3::new(1.0, 0.0, 5.0), Vec3::new(0.0, 1.0, 5.0)];
        assert!(matches!(Facing::of(&corners), Facing::Front { .. }));
        assert_eq!(Facing::of(&corners).normal_towards_eye(), Vec3::NEG_Z);
        corners.reverse();
        assert!(Facing::of(&corners).is_back());
        assert_eq!(Facing::of(&corners).normal_towards_eye(), Vec3::NEG_Z);
    }

    #[test]
    fn a_plane_through_the_eye_is_seen_edge_on() {
        let corners = [Vec3::new(0.0, 0.0, 5.0), Vec3::new(0.0, 1.0, 5.0), Vec3::new(0.0, 0.0, 9.0)];
        assert_eq!(Facing::of(&corners), Facing::EdgeOn);
    }
}
