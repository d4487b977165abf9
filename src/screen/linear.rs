//! Linear: the planes of depth and of what varies, as functions that are linear over the screen.
//!
//! project -> LINEAR -> DrawList; a shared triangle -LINEAR-> its planes, when they are asked for
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

use super::Plane;
use super::corner::{Corner, Outline, ScreenMap};
use crate::math::{Vec3, largest_coordinate, ordinary_scale};
use crate::plan::Varying;

/// What planes are made for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Planes {
    pub screen: ScreenMap,
    pub varying: Varying,
    pub has_depth: bool,
    pub scan_line: bool,
}

impl Planes {
    /// Adds the depth plane and the varying planes of the polygon, or of one `triangle` of it where it is not affine; returns the
    /// place of the first.
    #[inline(always)]
    pub fn push(&self, outline: &Outline<'_>, triangle: [u32; 3], planes: &mut Vec<Plane>) -> u32 {
        let first_plane = planes.len() as u32;
        if !self.has_depth {
            return first_plane;
        }
        let inverse_w = outline.inverse_w();
        planes.push(self.depth(inverse_w, outline.clipped.iter().map(|corner| corner.ready.inverse_w)));
        self.push_varying(outline, (triangle, inverse_w), planes);
        first_plane
    }

    /// The plane of depth, from the functional of 1/w and its values at the corners that are left.
    #[inline(always)]
    pub fn depth(&self, inverse_w: Vec3, at_corners: impl Iterator<Item = f64>) -> Plane {
        let range = range(at_corners);
        Plane::new(self.screen.plane(inverse_w), range, range, self.screen.precision)
    }

    /// Adds the planes of what varies; `inverse_w` is the functional of 1/w.
    #[inline(always)]
    pub fn push_varying(
        &self,
        outline: &Outline<'_>,
        (triangle, inverse_w): ([u32; 3], Vec3),
        planes: &mut Vec<Plane>,
    ) {
        if self.varying == Varying::Nothing {
            return;
        }
        let space = Space { planes: self, outline, triangle, inverse_w };
        space.push(|corner| corner.values, planes);
        if self.varying.has_normals() {
            self.push_eye_point(outline.clipped, planes);
        }
        if self.varying.has_factor() {
            space.push(|corner| corner.factor, planes);
        }
        if self.varying.texture_count() > 0 {
            space.push(|corner| corner.place, planes);
        }
    }

    /// In place of a plane: the mark that a number runs along scan lines, with its range at the corners.
    fn scan_line_rule(&self, range: (f64, f64)) -> Plane {
        if range.0 == range.1 {
            return Plane::constant(range.0, self.screen.precision);
        }
        Plane::along_scan_lines(range, self.screen.precision)
    }

    /// Planes of the eye point: x/w = X, y/w = Y and z/w = 1, exactly, whatever the polygon.
    #[inline(always)]
    fn push_eye_point(&self, corners: &[Corner], planes: &mut Vec<Plane>) {
        for (axis, functional) in Vec3::AXES.into_iter().enumerate() {
            let value_range = range(corners.iter().map(|corner| corner.ready.eye[axis]));
            let plane_range = range(corners.iter().map(|corner| corner.ready.eye[axis] / corner.ready.eye.z));
            planes.push(Plane::new(self.screen.plane(functional), plane_range, value_range, self.screen.precision));
        }
    }
}

/// One polygon, or one triangle of it, while the planes of what varies are made.
struct Space<'a> {
    planes: &'a Planes,
    outline: &'a Outline<'a>,
    /// Three corners that fix what is linear.
    triangle: [u32; 3],
    /// The functional of 1/w.
    inverse_w: Vec3,
}

impl Space<'_> {
    /// Adds the planes of N numbers `of` a corner.
    #[inline(always)]
    fn push<const N: usize>(&self, of: impl Fn(&Corner) -> [f64; N] + Copy, planes: &mut Vec<Plane>) {
        let outline = self.outline;
        // Over more corners than a plane has room for, the scan line decides (`ScreenPolygon::values`).
        if self.planes.scan_line && !outline.affine {
            for number in 0..N {
                let range = range(outline.clipped.iter().map(|corner| of(corner)[number]));
                planes.push(self.planes.scan_line_rule(range));
            }
        } else if outline.affine {
            self.push_values(of, outline.clipped.iter(), planes);
        } else {
            self.push_values(of, self.triangle.iter().map(|&corner| &outline.clipped[corner as usize]), planes);
        }
    }

    /// Adds their planes: value / w in space, or the values themselves on the screen.
    #[inline(always)]
    fn push_values<'v, const N: usize>(
        &self,
        of: impl Fn(&Corner) -> [f64; N],
        at_corners: impl Iterator<Item = &'v Corner> + Clone,
        planes: &mut Vec<Plane>,
    ) {
        let screen = &self.planes.screen;
        let [a, b, c] = self.triangle;
        let [a, b, c] =
            [self.outline.fixing(a as usize), self.outline.fixing(b as usize), self.outline.fixing(c as usize)];
        let mut value_ranges = [(0.0, 0.0); N];
        for (number, value_range) in value_ranges.iter_mut().enumerate() {
            *value_range = range(at_corners.clone().map(|corner| of(corner)[number]));
        }
        // Gradients are the same for all numbers; where all are constant nobody asks.
        let varies = value_ranges.iter().any(|range| range.0 != range.1);
        let gradients = if varies { self.gradients([a.ready.eye, b.ready.eye, c.ready.eye]) } else { None };
        for (number, value_range) in value_ranges.into_iter().enumerate() {
            let values = [of(a)[number], of(b)[number], of(c)[number]];
            let gradients = if value_range.0 == value_range.1 { None } else { gradients.as_ref() };
            let Some(coefficients) = gradients.and_then(|gradients| self.coefficients(gradients, values)) else {
                // A triangle without area covers next to nothing; its first corner speaks for it.
                planes.push(Plane::constant(values[0], screen.precision));
                continue;
            };
            let plane_range = match screen.perspective {
                true => range(at_corners.clone().map(|corner| of(corner)[number] / corner.ready.eye.z)),
                false => value_range,
            };
            planes.push(Plane::new(coefficients, plane_range, value_range, screen.precision));
        }
    }

    #[inline(always)]
    fn gradients(&self, [a, b, c]: [Vec3; 3]) -> Option<Gradients> {
        let screen = &self.planes.screen;
        Gradients::over(if screen.perspective {
            [a, b, c]
        } else {
            [screen.exact(a), screen.exact(b), screen.exact(c)]
        })
    }

    /// Coefficients of one number's plane; `None` if one of them is not finite.
    #[inline(always)]
    fn coefficients(&self, gradients: &Gradients, values: [f64; 3]) -> Option<[f64; 3]> {
        let (g, h) = gradients.of(values);
        let coefficients = match self.planes.screen.perspective {
            true => self.planes.screen.plane(g + self.inverse_w * h),
            false => [g.x, g.y, h],
        };
        coefficients.iter().all(|number| number.is_finite()).then_some(coefficients)
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
    #[inline(always)]
    fn over(points: [Vec3; 3]) -> Option<Gradients> {
        let scale = ordinary_scale(largest_coordinate(&points));
        let points = [points[0] * scale, points[1] * scale, points[2] * scale];
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
    #[inline(always)]
    fn of(&self, values: [f64; 3]) -> (Vec3, f64) {
        let g = self.weights[0] * (values[1] - values[0]) + self.weights[1] * (values[2] - values[0]);
        (g * self.scale, values[0] - g.dot(self.first))
    }
}

/// The least and the greatest; of two zeros the first, whatever its sign (`f64::min` may choose either).
#[inline(always)]
fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (if value < low { value } else { low }, if value > high { value } else { high })
    })
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
