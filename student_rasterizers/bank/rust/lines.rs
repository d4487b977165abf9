//! Lines by the diamond-exit rule as it is said: for every sample near a segment, does it leave the diamond around the center?
//! Turned by 45 degrees (u = x + y, v = x - y) the diamond is a square, and the question is two slabs.

use super::Slip;
use farop::raster::{PolygonRasterizer, Target};
use farop::screen::{EdgeKind, ScreenPolygon, Shader};

pub struct Lines {
    pub slip: Slip,
}

impl Lines {
    /// The part of the segment within the slab `from` + t `along` in -half ... half, as (first t, last t).
    fn slab(from: f64, along: f64, half: f64) -> (f64, f64) {
        if along == 0.0 {
            return if from.abs() < half { (f64::NEG_INFINITY, f64::INFINITY) } else { (1.0, 0.0) };
        }
        let (one, other) = ((-half - from) / along, (half - from) / along);
        (one.min(other), one.max(other))
    }

    fn shows(&self, a: (f64, f64), b: (f64, f64), x: i32, y: i32) -> bool {
        let middle = if self.slip.is("diamond_at_the_corner") { 0.0 } else { 0.5 };
        let half = if self.slip.is("small_diamond") { 0.25 } else { 0.5 };
        let (cx, cy) = (f64::from(x) + middle, f64::from(y) + middle);
        let (mut ua, mut va, mut ub, mut vb) =
            (a.0 - cx + a.1 - cy, a.0 - cx - a.1 + cy, b.0 - cx + b.1 - cy, b.0 - cx - b.1 + cy);
        if self.slip.is("square_for_diamond") {
            (ua, va, ub, vb) = (a.0 - cx, a.1 - cy, b.0 - cx, b.1 - cy);
        }
        let (one, other) = (Self::slab(ua, ub - ua, half), Self::slab(va, vb - va, half));
        let (enters, leaves) = (one.0.max(other.0).max(0.0), one.1.min(other.1).min(1.0));
        if enters >= leaves {
            return false;
        }
        let starts_inside = ua.abs() < half && va.abs() < half;
        let ends_inside = ub.abs() < half && vb.abs() < half;
        match self.slip.0.as_str() {
            "end_shown" => true,
            "enter_for_exit" => !starts_inside,
            "both_ends_hidden" => !ends_inside && !starts_inside,
            _ => !ends_inside,
        }
    }
}

impl PolygonRasterizer for Lines {
    fn draw_polygon(&self, polygon: &ScreenPolygon<'_>, shader: &Shader, target: &mut Target<'_>) {
        let corners = polygon.vertices();
        let edges = if self.slip.is("last_edge_lost") { corners.len() - 1 } else { corners.len() };
        for n in 0..edges {
            let (from, to) = (&corners[n], &corners[(n + 1) % corners.len()]);
            if from.edge == EdgeKind::Cut {
                continue;
            }
            let (mut a, b) = ((from.x, from.y), (to.x, to.y));
            if self.slip.is("all_from_first_corner") {
                a = (corners[0].x, corners[0].y);
            }
            let range = |p: f64, q: f64, most: i32| {
                let (low, high) = (p.min(q).floor() as i32 - 1, p.max(q).floor() as i32 + 1);
                low.max(0)..=high.min(most - 1)
            };
            for y in range(a.1, b.1, target.height()) {
                for x in range(a.0, b.0, target.width()) {
                    if self.shows(a, b, x, y) {
                        let mut fragment = shader.fragment(polygon, x, y);
                        if self.slip.is("dark_lines") {
                            fragment.color = fragment.color.map(|light| light * 0.5);
                        }
                        target.put(fragment);
                    }
                }
            }
        }
    }
}
