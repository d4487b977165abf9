//! Cut: both parts of a polygon at a plane of the view volume, the one that stays and the one that goes.
//!
//! EyePolygon -CUT-> kept, cut off
//!
//! Why not the clipper: it throws away what this is about. What stays is shown as the clipper left it; only what goes, and the
//! states in between, are made here, by the same method.
//!
//! Space: eye space. Source: Sutherland and Hodgman, "Reentrant Polygon Clipping", CACM 17(1), 1974.

use crate::math::{Vec3, edges};
use crate::plan::{ClipPlane, Plan};

/// A polygon meets a plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Crossing {
    /// Number of the polygon that culling saw.
    pub polygon: usize,
    /// The plane.
    pub plane: ClipPlane,
}

/// The planes a polygon crosses, in the order in which it meets them; only one where it lies wholly outside.
#[must_use]
pub fn crossings(polygon: usize, corners: &[Vec3], plan: &Plan) -> Vec<Crossing> {
    let crossing = |plane: ClipPlane| Crossing { polygon, plane };
    let outside = |plane: ClipPlane| corners.iter().filter(|&&corner| plane.distance(corner, &plan.view) < 0.0).count();
    let planes = ClipPlane::ALL.into_iter();
    if let Some(plane) = planes.clone().find(|&plane| outside(plane) == corners.len()) {
        return vec![crossing(plane)];
    }
    let cuts = |plane: &ClipPlane| !plan.is_unsnapped() || matches!(plane, ClipPlane::Hither | ClipPlane::Yon);
    planes.filter(cuts).filter(|&plane| outside(plane) > 0).map(crossing).collect()
}

/// What of `corners` lies inside the plane, and what outside; either may have no corners.
#[must_use]
pub fn cut(corners: &[Vec3], plane: ClipPlane, plan: &Plan) -> [Vec<Vec3>; 2] {
    let (mut kept, mut gone) = (Vec::new(), Vec::new());
    for (&here, &next) in edges(corners) {
        let (a, b) = (plane.distance(here, &plan.view), plane.distance(next, &plan.view));
        if a >= 0.0 {
            kept.push(here);
        }
        if a <= 0.0 {
            gone.push(here);
        }
        if a * b < 0.0 {
            let on_plane = here + (next - here) * (a / (a - b));
            kept.push(on_plane);
            gone.push(on_plane);
        }
    }
    [kept, gone].map(|part| if part.len() < 3 { Vec::new() } else { part })
}

/// The plane as an equation in clip space.
#[must_use]
pub fn equation(plane: ClipPlane) -> &'static str {
    match plane {
        ClipPlane::Hither => "w = hither",
        ClipPlane::Left => "x = -w",
        ClipPlane::Right => "x = w",
        ClipPlane::Bottom => "y = -w",
        ClipPlane::Top => "y = w",
        ClipPlane::Yon => "w = yon",
    }
}
