//! Planes: depth and what varies, as functions that are linear over the screen.
//!
//! project -> PLANES -> DrawList
//!
//! Why planes come from eye space: a plane through snapped vertices would carry their rounding into every depth, a
//! relative error of 1e-3 on a grazing ground where the plane in space has 1e-8. On the polygon's plane in eye
//! space n.P = d, so 1/w = (n/d).(X, Y, 1) with X = x/w, Y = y/w: linear on the screen, whatever was cut or split.
//! A value that is linear on the plane, v = g.P + h, gives v/w = (g + h n/d).(X, Y, 1) the same way.
//!
//! Space: eye space in, coefficients over samples out. Source: Olano and Greer, "Triangle Scan Conversion using 2D Homogeneous
//! Coordinates", Graphics Hardware 1997; Akeley and Su, "Minimum Triangle Separation for Correct z-Buffer
//! Occlusion", Graphics Hardware 2006, on what snapped vertices do to depth.
//! Cost: divisions, hardly anything else: 5 for depth, 6 for the gradients of a polygon, 2 for each value and 1 for each value at
//! a corner; 48 bytes a plane.

use super::clip::ClipVertex;
use super::light::{FACTOR, LIGHT};
use super::project::{Outline, ScreenMap};
use crate::math::{Vec3, largest_coordinate, ordinary_scale};
use crate::plan::Varying;
use crate::screen::Plane;
use std::ops::Range;

/// What planes are made for.
#[derive(Clone, Copy)]
pub(super) struct Planes {
    pub screen: ScreenMap,
    pub varying: Varying,
    pub has_depth: bool,
    pub scan_line: bool,
}

impl Planes {
    /// Adds the depth plane and the varying planes of the polygon, or of one `triangle` of it where it is not affine; returns the
    /// place of the first.
    #[inline]
    pub fn push(&self, outline: &Outline<'_>, triangle: [u32; 3], planes: &mut Vec<Plane>) -> u32 {
        let first_plane = planes.len() as u32;
        if !self.has_depth {
            return first_plane;
        }
        // 1/w over the screen: n/d, from the polygon as it was before clipping.
        let inverse_w = outline.newell / outline.newell.dot(outline.before_eye[0]);
        let range = range(outline.clipped.iter().map(|vertex| 1.0 / vertex.position.z));
        planes.push(Plane::new(self.screen.plane(inverse_w), range, range, self.screen.precision));
        if self.varying == Varying::Nothing {
            return first_plane;
        }
        let mut gradients = None;
        let mut values = |numbers: Range<usize>, planes: &mut Vec<Plane>| {
            // Over more corners than a plane has room for, the scan line decides (`ScreenPolygon::values`).
            if self.scan_line && !outline.affine {
                planes.extend(numbers.map(|number| self.scan_line_rule(outline, number)));
                return;
            }
            let of = (outline, triangle, inverse_w);
            if outline.affine {
                let corners = outline.clipped.iter();
                planes.extend(numbers.map(|number| self.value_plane(of, number, corners.clone(), &mut gradients)));
            } else {
                let corners = triangle.iter().map(|&corner| &outline.clipped[corner as usize]);
                planes.extend(numbers.map(|number| self.value_plane(of, number, corners.clone(), &mut gradients)));
            }
        };
        values(0..LIGHT, planes);
        if self.varying.has_normals() {
            planes.extend(self.eye_point_planes(outline.clipped_eye));
        }
        if self.varying.has_factor() {
            values(FACTOR..FACTOR + 3, planes);
        }
        if self.varying.texture_count() > 0 {
            values(LIGHT..FACTOR, planes);
        }
        first_plane
    }

    /// The plane of one number: value / w in space, or the value itself on the screen. `gradients` serve all numbers of the outline.
    #[inline]
    fn value_plane<'v>(
        &self,
        (outline, triangle, inverse_w): (&Outline<'_>, [u32; 3], Vec3),
        number: usize,
        at_corners: impl Iterator<Item = &'v ClipVertex> + Clone,
        gradients: &mut Option<Option<Gradients>>,
    ) -> Plane {
        // Three corners fix what is linear over the polygon.
        let three = triangle.map(|corner| outline.fixing(corner as usize));
        let values = three.map(|(_, attributes)| attributes[number]);
        let value_range = range(at_corners.clone().map(|vertex| vertex.attributes[number]));
        if value_range.0 == value_range.1 {
            return Plane::constant(values[0], self.screen.precision);
        }
        let points =
            || if self.screen.perspective { three.map(|at| at.0) } else { three.map(|at| self.screen.exact(at.0)) };
        let gradients: &Option<Gradients> = gradients.get_or_insert_with(|| Gradients::over(points()));
        let linear = gradients.as_ref().map(|gradients| gradients.of(values));
        let (coefficients, plane_range) = if self.screen.perspective {
            let over_w = range(at_corners.map(|vertex| vertex.attributes[number] / vertex.position.z));
            (linear.map(|(g, h)| self.screen.plane(g + inverse_w * h)), over_w)
        } else {
            (linear.map(|(g, h)| [g.x, g.y, h]), value_range)
        };
        match coefficients.filter(|numbers| numbers.iter().all(|number| number.is_finite())) {
            Some(coefficients) => Plane::new(coefficients, plane_range, value_range, self.screen.precision),
            // A triangle without area covers next to nothing; its first corner speaks for it.
            None => Plane::constant(values[0], self.screen.precision),
        }
    }

    /// In place of a plane: the mark that a number runs along scan lines, with its range at the corners.
    fn scan_line_rule(&self, outline: &Outline<'_>, number: usize) -> Plane {
        let range = range(outline.clipped.iter().map(|vertex| vertex.attributes[number]));
        if range.0 == range.1 {
            return Plane::constant(range.0, self.screen.precision);
        }
        Plane::along_scan_lines(range, self.screen.precision)
    }

    /// Planes of the eye point: x/w = X, y/w = Y and z/w = 1, exactly, whatever the polygon.
    #[inline]
    fn eye_point_planes(&self, corners: &[Vec3]) -> [Plane; 3] {
        let mut axis = 0;
        Vec3::AXES.map(|functional| {
            let value_range = range(corners.iter().map(|eye| eye[axis]));
            let plane_range = range(corners.iter().map(|eye| eye[axis] / eye.z));
            axis += 1;
            Plane::new(self.screen.plane(functional), plane_range, value_range, self.screen.precision)
        })
    }
}

/// The part of a linear function over a triangle that does not depend on its values: computed once for all that vary.
///
/// Written from differences, so that a small triangle far from the origin loses no digits.
struct Gradients {
    /// What coordinates are multiplied by, so that fourth powers of lengths can be divided.
    scale: f64,
    /// The first corner, scaled.
    first: Vec3,
    /// Gradients of the two barycentric weights that belong to the second and third corner.
    weights: [Vec3; 2],
}

impl Gradients {
    /// Over three points; `None` where they span no triangle.
    #[inline]
    fn over(points: [Vec3; 3]) -> Option<Gradients> {
        let scale = ordinary_scale(largest_coordinate(&points));
        let points = points.map(|point| point * scale);
        let (first, second) = (points[1] - points[0], points[2] - points[0]);
        let normal = first.cross(second);
        let squared = normal.length_squared();
        if !(squared > 0.0 && squared.is_finite()) {
            return None;
        }
        let weights = [second.cross(normal) / squared, normal.cross(first) / squared];
        Some(Gradients { scale, first: points[0], weights })
    }

    /// `g` and `h` such that g.P + h takes `values` at the three points.
    #[inline]
    fn of(&self, values: [f64; 3]) -> (Vec3, f64) {
        let g = self.weights[0] * (values[1] - values[0]) + self.weights[1] * (values[2] - values[0]);
        (g * self.scale, values[0] - g.dot(self.first))
    }
}

#[inline]
fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_linear_function_is_found_again_far_away() {
        let points = [Vec3::new(1e6, 0.0, 2e6), Vec3::new(1e6 + 1.0, 0.0, 2e6), Vec3::new(1e6, 1.0, 2e6 + 1.0)];
        let (g, h) = Gradients::over(points).expect("a triangle").of([1.0, 3.0, 8.0]);
        for (point, value) in points.into_iter().zip([1.0, 3.0, 8.0]) {
            assert!((g.dot(point) + h - value).abs() < 1e-8);
        }
        assert!(Gradients::over([points[0]; 3]).is_none());
    }
}
