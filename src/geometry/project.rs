//! Project: from clip space to the screen, with the plane of depth and of everything that varies.
//!
//! light -> SPLIT, PROJECT -> ScreenPolygon -> rasterizer
//!
//! Why planes come from eye space: a plane through snapped vertices would carry their rounding into every depth, a
//! relative error of 1e-3 on a grazing ground where the plane in space has 1e-8. On the polygon's plane in eye
//! space n.P = d, so 1/w = (n/d).(X, Y, 1) with X = x/w, Y = y/w: linear on the screen, whatever was cut or split.
//! A value that is linear on the plane, v = g.P + h, gives v/w = (g + h n/d).(X, Y, 1) the same way.
//!
//! Space: clip space in, samples out. Source: Olano and Greer, "Triangle Scan Conversion using 2D Homogeneous
//! Coordinates", Graphics Hardware 1997; Akeley and Su, "Minimum Triangle Separation for Correct z-Buffer
//! Occlusion", Graphics Hardware 2006, on what snapped vertices do to depth.
//! Texture coordinates are two more such values, behind all others.
//! Cost: one division a vertex, one a polygon; 48 bytes a plane.

use super::clip::ClipVertex;
use super::split::{SplitReport, SplitScratch, split};
use crate::math::{Vec3, largest_coordinate, ordinary_scale};
use crate::plan::{DepthFormat, Interpolation, Plan, Varying};
use crate::screen::{DepthMapping, DrawList, EdgeKind, Grid, Plane, PolygonRecord, Precision, ScreenVertex, Source};

/// Numbers of light a vertex carries, and all it may carry: with u and v.
const LIGHT: usize = 3;
const CARRIED: usize = LIGHT + 2;

/// A polygon before clipping, as far as its planes need it.
pub(super) struct Outline<'a> {
    /// Its corners in clip space, with what varies at them.
    pub corners: &'a [ClipVertex],
    /// What varies is taken from the clipped vertices instead.
    pub from_clipped: bool,
    /// Newell normal, eye space.
    pub newell: Vec3,
    /// What varies is linear over it.
    pub affine: bool,
}

/// Turns clipped polygons into screen polygons; keeps its memory.
pub(super) struct Projector {
    /// The clipped polygon in hand.
    pub clipped: Vec<ClipVertex>,
    /// Factors from eye x, y to clip x, y.
    pub clip_from_eye: (f64, f64),
    screen: ScreenMap,
    varying: Varying,
    has_depth: bool,
    scan_line: bool,
    eye: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
    scratch: SplitScratch,
}

/// From eye and clip space to samples.
#[derive(Clone, Copy)]
struct ScreenMap {
    half: (f64, f64),
    scale: f64,
    grid: Grid,
    precision: Precision,
    perspective: bool,
}

impl Projector {
    pub fn new(plan: &Plan) -> Projector {
        let choices = &plan.choices;
        let precision = if choices.depth == DepthFormat::F64 { Precision::Double } else { Precision::Single };
        let screen = ScreenMap {
            half: plan.view.half(),
            scale: plan.view.scale,
            // Lines lie on a grid, on the finest if nothing is to be snapped.
            grid: if plan.is_unsnapped() { Grid::EXACT } else { Grid { bits: choices.subpixel_bits.min(16) } },
            precision,
            perspective: choices.interpolation == Interpolation::Perspective,
        };
        Projector {
            clipped: Vec::new(),
            clip_from_eye: plan.view.clip_from_eye(),
            screen,
            varying: plan.varying(),
            has_depth: plan.needs.depth,
            scan_line: choices.interpolation == Interpolation::ScanLine,
            eye: Vec::new(),
            triangles: Vec::new(),
            scratch: SplitScratch::default(),
        }
    }

    /// Empties `list` and sets what holds for all its polygons.
    pub fn prepare(&self, plan: &Plan, list: &mut DrawList) {
        list.clear();
        (list.width, list.height) = plan.view.sample_size();
        list.unit = plan.view.unit;
        list.grid = self.screen.grid;
        list.precision = self.screen.precision;
        list.varying = self.varying;
        list.interpolation = plan.choices.interpolation;
        list.has_depth = self.has_depth;
        list.has_blending = plan.needs.blending;
        let (nearest, farthest) = (1.0 / plan.view.hither, 1.0 / plan.view.yon);
        list.depth_mapping = DepthMapping { format: plan.choices.depth, nearest, farthest };
    }

    /// Adds the clipped polygon in hand to `list`: whole, or in triangles.
    pub fn emit(
        &mut self,
        outline: &Outline<'_>,
        in_triangles: bool,
        owner: (u32, Source),
        list: &mut DrawList,
    ) -> SplitReport {
        let (kx, ky) = self.clip_from_eye;
        self.eye.clear();
        self.eye.extend(self.clipped.iter().map(|v| Vec3::new(v.position.x / kx, v.position.y / ky, v.position.z)));
        self.flatten_constants(outline);
        if !in_triangles || self.clipped.len() == 3 {
            let first_plane = self.push_planes(outline, [0, 1, 2], list);
            let corners = 0..self.clipped.len() as u32;
            self.push_polygon(corners.map(|corner| (corner, None)), first_plane, owner, list);
            return SplitReport::default();
        }
        self.triangles.clear();
        let report = split(&self.eye, outline.newell, &mut self.scratch, &mut self.triangles);
        // Triangles of a polygon over which everything is linear share its planes: the picture is that of the whole.
        let shared = outline.affine.then(|| self.push_planes(outline, [0, 1, 2], list));
        for index in 0..self.triangles.len() {
            let triangle = self.triangles[index];
            let first_plane = shared.unwrap_or_else(|| self.push_planes(outline, triangle, list));
            let corners = [(0, 1), (1, 2), (2, 0)].map(|(from, to)| (triangle[from], Some(triangle[to])));
            self.push_polygon(corners.into_iter(), first_plane, owner, list);
        }
        report
    }

    /// A number that is the same at all corners stays the same, to the last bit, at the vertices that clipping made.
    fn flatten_constants(&mut self, outline: &Outline<'_>) {
        if outline.from_clipped {
            return;
        }
        for number in 0..self.carried() {
            let value = outline.corners[0].attributes[number];
            if outline.corners.iter().all(|corner| corner.attributes[number] == value) {
                self.clipped.iter_mut().for_each(|vertex| vertex.attributes[number] = value);
            }
        }
    }

    /// Adds a polygon; each corner comes with the corner its edge leads to, where that is not the next of the outline.
    fn push_polygon(
        &self,
        corners: impl Iterator<Item = (u32, Option<u32>)>,
        first_plane: u32,
        (surface, source): (u32, Source),
        list: &mut DrawList,
    ) {
        let first_vertex = list.vertices.len() as u32;
        let count = self.clipped.len() as u32;
        for (corner, leads_to) in corners {
            let vertex = &self.clipped[corner as usize];
            let on_outline = leads_to.is_none_or(|next| next == (corner + 1) % count);
            let edge = if on_outline { vertex.edge } else { EdgeKind::Diagonal };
            list.vertices.push(self.screen.vertex(vertex.position, edge));
            self.push_values(corner as usize, list);
        }
        let vertex_count = list.vertices.len() as u32 - first_vertex;
        list.polygons.push(PolygonRecord { first_vertex, vertex_count, first_plane, surface, source });
    }

    fn push_values(&self, corner: usize, list: &mut DrawList) {
        let values = &self.clipped[corner].attributes;
        let light = self.carried() - self.varying.texture_count();
        list.values.extend_from_slice(&values[..light]);
        if self.varying.is_eye_point(3) {
            list.values.extend_from_slice(&self.eye[corner].to_array());
        }
        list.values.extend_from_slice(&values[light..self.carried()]);
    }

    /// Adds the depth plane and the varying planes of the polygon, or of one `triangle` of it where it is not affine.
    fn push_planes(&self, outline: &Outline<'_>, triangle: [u32; 3], list: &mut DrawList) -> u32 {
        let first_plane = list.planes.len() as u32;
        if !self.has_depth {
            return first_plane;
        }
        // 1/w over the screen: n/d, from the polygon as it was before clipping.
        let inverse_w = outline.newell / outline.newell.dot(self.to_eye(&outline.corners[0]));
        let range = range(self.clipped.iter().map(|vertex| 1.0 / vertex.position.z));
        list.planes.push(Plane::new(self.screen.plane(inverse_w), range, range, self.screen.precision));
        if self.varying == Varying::Nothing {
            return first_plane;
        }
        let three = self.three_corners(outline, triangle);
        let corners = if outline.affine { 0..self.clipped.len() } else { 0..0 };
        let corners = corners.chain(triangle.iter().map(|&corner| corner as usize).filter(|_| !outline.affine));
        // Over more corners than a plane has room for, the scan line decides (`ScreenPolygon::values`).
        let along_scan_lines = self.scan_line && !outline.affine;
        let plane = |number: usize| {
            let value = |corner: usize| (self.clipped[corner].attributes[number], self.clipped[corner].position.z);
            match along_scan_lines {
                true => self.scan_line_rule(number),
                false => self.value_plane(&three, inverse_w, number, corners.clone().map(value)),
            }
        };
        list.planes.extend((0..LIGHT).map(plane));
        if self.varying.is_eye_point(LIGHT) {
            list.planes.extend(self.eye_point_planes());
        }
        list.planes.extend((LIGHT..self.carried()).map(plane));
        first_plane
    }

    /// Three corners that fix what is linear over the polygon, in eye space, with what varies at them.
    fn three_corners(&self, outline: &Outline<'_>, triangle: [u32; 3]) -> [(Vec3, [f64; CARRIED]); 3] {
        let before = outline.affine && !outline.from_clipped;
        let vertices = if before { outline.corners } else { &self.clipped };
        triangle.map(|corner| {
            let vertex = &vertices[corner as usize];
            let [a, b, c, u, v, ..] = vertex.attributes;
            let eye = if before { self.to_eye(vertex) } else { self.eye[corner as usize] };
            (eye, [a, b, c, u, v])
        })
    }

    /// The plane of one number: value / w in space, or the value itself on the screen.
    fn value_plane(
        &self,
        three: &[(Vec3, [f64; CARRIED]); 3],
        inverse_w: Vec3,
        number: usize,
        at_corners: impl Iterator<Item = (f64, f64)> + Clone,
    ) -> Plane {
        let values = three.map(|(_, values)| values[number]);
        let value_range = range(at_corners.clone().map(|(value, _)| value));
        if value_range.0 == value_range.1 {
            return Plane::constant(values[0], self.screen.precision);
        }
        let coefficients = if self.screen.perspective {
            linear_over_plane(three.map(|(eye, _)| eye), values).map(|(g, h)| self.screen.plane(g + inverse_w * h))
        } else {
            let on_screen = three.map(|(eye, _)| self.screen.exact(eye));
            linear_over_plane(on_screen, values).map(|(g, h)| [g.x, g.y, h])
        };
        let plane_range =
            if self.screen.perspective { range(at_corners.map(|(value, w)| value / w)) } else { value_range };
        match coefficients.filter(|numbers| numbers.iter().all(|number| number.is_finite())) {
            Some(coefficients) => Plane::new(coefficients, plane_range, value_range, self.screen.precision),
            // A triangle without area covers next to nothing; its first corner speaks for it.
            None => Plane::constant(values[0], self.screen.precision),
        }
    }

    /// In place of a plane: the mark that a number runs along scan lines, with its range at the corners.
    fn scan_line_rule(&self, number: usize) -> Plane {
        let range = range(self.clipped.iter().map(|vertex| vertex.attributes[number]));
        if range.0 == range.1 {
            return Plane::constant(range.0, self.screen.precision);
        }
        Plane::along_scan_lines(range, self.screen.precision)
    }

    /// Planes of the eye point: x/w = X, y/w = Y and z/w = 1, exactly, whatever the polygon.
    fn eye_point_planes(&self) -> [Plane; 3] {
        let mut axis = 0;
        Vec3::AXES.map(|functional| {
            let value_range = range(self.eye.iter().map(|eye| eye[axis]));
            let plane_range = range(self.eye.iter().map(|eye| eye[axis] / eye.z));
            axis += 1;
            Plane::new(self.screen.plane(functional), plane_range, value_range, self.screen.precision)
        })
    }

    /// How many numbers a vertex carries through clipping: color or normal, then u and v.
    fn carried(&self) -> usize {
        self.varying.light_count().min(LIGHT) + self.varying.texture_count()
    }

    fn to_eye(&self, vertex: &ClipVertex) -> Vec3 {
        let (kx, ky) = self.clip_from_eye;
        Vec3::new(vertex.position.x / kx, vertex.position.y / ky, vertex.position.z)
    }
}

impl ScreenMap {
    /// A clip-space position on the screen, snapped.
    fn vertex(&self, clip: Vec3, edge: EdgeKind) -> ScreenVertex {
        let (half_width, half_height) = self.half;
        let homogeneous = Vec3::new((clip.z + clip.x) * half_width, (clip.z - clip.y) * half_height, clip.z);
        if self.grid.is_exact() {
            // Not held in the picture: it was not clipped to it.
            let (x, y) = (homogeneous.x / clip.z, homogeneous.y / clip.z);
            return ScreenVertex { x, y, homogeneous, edge };
        }
        // Rounding may leave a vertex on the right or lower side a hair outside; snapping brings it back.
        let (x, y) = (self.grid.snap(homogeneous.x / clip.z), self.grid.snap(homogeneous.y / clip.z));
        ScreenVertex { x: x.clamp(0.0, 2.0 * half_width), y: y.clamp(0.0, 2.0 * half_height), homogeneous, edge }
    }

    /// An eye-space point on the screen, not snapped; z is 0.
    fn exact(&self, eye: Vec3) -> Vec3 {
        let (half_width, half_height) = self.half;
        Vec3::new(half_width + eye.x / eye.z * self.scale, half_height - eye.y / eye.z * self.scale, 0.0)
    }

    /// Coefficients over samples of a functional on (X, Y, 1), X = x/w, Y = y/w.
    fn plane(&self, functional: Vec3) -> [f64; 3] {
        let (a, b) = (functional.x / self.scale, -functional.y / self.scale);
        [a, b, functional.z - a * self.half.0 - b * self.half.1]
    }
}

/// `g` and `h` such that g.P + h takes `values` at three points; `None` where they span no triangle.
///
/// Written from differences, so that a small triangle far from the origin loses no digits.
fn linear_over_plane(points: [Vec3; 3], values: [f64; 3]) -> Option<(Vec3, f64)> {
    // Fourth powers of lengths are divided below.
    let scale = ordinary_scale(largest_coordinate(&points));
    let points = points.map(|point| point * scale);
    let (first, second) = (points[1] - points[0], points[2] - points[0]);
    let normal = first.cross(second);
    let squared = normal.length_squared();
    if !(squared > 0.0 && squared.is_finite()) {
        return None;
    }
    // Gradients of the two barycentric weights that belong to the second and third point.
    let (along_first, along_second) = (second.cross(normal) / squared, normal.cross(first) / squared);
    let g = along_first * (values[1] - values[0]) + along_second * (values[2] - values[0]);
    Some((g * scale, values[0] - g.dot(points[0])))
}

fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_linear_function_is_found_again_far_away() {
        let points = [Vec3::new(1e6, 0.0, 2e6), Vec3::new(1e6 + 1.0, 0.0, 2e6), Vec3::new(1e6, 1.0, 2e6 + 1.0)];
        let (g, h) = linear_over_plane(points, [1.0, 3.0, 8.0]).expect("a triangle");
        for (point, value) in points.into_iter().zip([1.0, 3.0, 8.0]) {
            assert!((g.dot(point) + h - value).abs() < 1e-8);
        }
        assert!(linear_over_plane([points[0]; 3], [0.0; 3]).is_none());
    }
}
