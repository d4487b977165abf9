//! A view of one polygon of a draw list: the value that rasterizers read.

use super::scan_line::ScanLine;
use super::{DrawList, Evaluation, Fragment, Plane, PolygonRecord, Precision, ScreenVertex, Values};
use crate::plan::Interpolation;

/// One polygon on the screen: clipped, snapped, with the plane of its depth and of everything that varies over it.
///
/// Finite, inside the picture, at least three vertices, convex or not. It covers a sample when the sample's center is
/// inside the snapped outline by the even-odd rule; a center on the outline belongs to it on left and upper edges.
#[derive(Clone, Copy, Debug)]
pub struct ScreenPolygon<'a> {
    list: &'a DrawList,
    record: &'a PolygonRecord,
    vertices: &'a [ScreenVertex],
    /// What varies at the corners, one behind the other.
    corner_values: &'a [f64],
    /// Of depth, then of what varies; none in lists without depth.
    planes: &'a [Plane],
    /// Its position in the list: the lower one keeps a sample when depths are equal.
    pub index: u32,
}

impl<'a> ScreenPolygon<'a> {
    #[inline]
    pub(super) fn new(list: &'a DrawList, index: usize) -> Self {
        let (record, numbers) = (&list.polygons[index], list.varying.count());
        let first = record.first_vertex as usize;
        let corners = first..first + record.vertex_count as usize;
        let first = record.first_plane as usize;
        let planes = if list.has_depth { first..(first + 1 + numbers).min(list.planes.len()) } else { 0..0 };
        // Whoever makes lists by hand may leave out what is not looked at.
        let values = list.values.get(corners.start * numbers..corners.end * numbers).unwrap_or_default();
        let planes = list.planes.get(planes).unwrap_or_default();
        Self::of((list, record, index), (&list.vertices[corners], values, planes))
    }

    /// From its parts: its corners, what varies there, its planes.
    #[inline]
    pub(super) fn of(
        (list, record, index): (&'a DrawList, &'a PolygonRecord, usize),
        (vertices, corner_values, planes): (&'a [ScreenVertex], &'a [f64], &'a [Plane]),
    ) -> Self {
        ScreenPolygon { list, record, vertices, corner_values, planes, index: index as u32 }
    }

    /// One that is known by its planes alone: no corners, and nothing at them.
    #[inline]
    pub(crate) fn of_planes(list: &'a DrawList, index: usize, planes: &'a [Plane]) -> Self {
        Self::of((list, &list.polygons[index], index), (&[], &[], planes))
    }

    /// The corners, in order around the outline.
    #[must_use]
    #[inline]
    pub fn vertices(&self) -> &'a [ScreenVertex] {
        self.vertices
    }

    /// What varies, at corner `corner`: the numbers that [`ScreenPolygon::values`] interpolates.
    #[must_use]
    #[inline]
    pub fn vertex_values(&self, corner: usize) -> &'a [f64] {
        let count = self.list.varying.count();
        &self.corner_values[corner * count..(corner + 1) * count]
    }

    /// The grid its corners are snapped to.
    #[must_use]
    pub fn grid(&self) -> super::Grid {
        self.list.grid
    }

    /// Where it comes from and which planes it has.
    #[must_use]
    pub fn record(&self) -> &'a PolygonRecord {
        self.record
    }

    /// Index of its surface in the shader.
    #[must_use]
    #[inline]
    pub fn surface(&self) -> u32 {
        self.record.surface
    }

    /// The plane of 1/w. `None` in lists without depth (wire).
    #[must_use]
    #[inline]
    pub fn depth_plane(&self) -> Option<&'a Plane> {
        self.planes.first()
    }

    /// The planes of what varies, one a number: of value / w, or of the value itself with `--interpolation screen`.
    ///
    /// Eye points are always / w. A plane marked [`Evaluation::ScanLine`] is none: ask [`ScreenPolygon::values`].
    #[must_use]
    #[inline]
    pub fn varying_planes(&self) -> &'a [Plane] {
        self.planes.get(1..).unwrap_or_default()
    }

    /// 1/w at the center of sample (x, y), within the range at the corners; 0 in lists without depth.
    #[must_use]
    #[inline]
    pub fn inverse_w(&self, x: i32, y: i32) -> f64 {
        self.depth_plane().map_or(0.0, |plane| plane.clamped_at(x, y))
    }

    /// Depth at the center of sample (x, y): 1/w, or integer steps. Larger is nearer.
    #[must_use]
    #[inline]
    pub fn depth(&self, x: i32, y: i32) -> f64 {
        self.list.depth_mapping.apply(self.inverse_w(x, y))
    }

    /// What varies, at the center of sample (x, y): red, green, blue; or normal and eye point; then u and v, where surfaces have pictures.
    ///
    /// The contract's one definition: value / w and 1/w by their planes, one division, within the range at the corners.
    /// With `--interpolation scanline`, what is not linear over the polygon runs along its edges and the scan line.
    #[must_use]
    #[inline]
    pub fn values(&self, x: i32, y: i32) -> Values {
        self.assemble((x, y), self.inverse_w(x, y), |_, plane| plane.at(x, y))
    }

    /// The same at sample (x, y), from 1/w and value / w of every number, however a rasterizer came by them: incrementally, say.
    ///
    /// `over_w` has one number for each of [`ScreenPolygon::varying_planes`]; further ones are not looked at.
    #[must_use]
    pub fn values_from(&self, sample: (i32, i32), inverse_w: f64, over_w: &[f32]) -> Values {
        self.assemble(sample, inverse_w, |number, _| f64::from(over_w[number]))
    }

    #[inline]
    fn assemble(&self, (x, y): (i32, i32), inverse_w: f64, over_w: impl Fn(usize, &Plane) -> f64) -> Values {
        let mut values = Values::default();
        let scan_line = self.scan_line(x, y);
        for (number, plane) in self.varying_planes().iter().enumerate() {
            values.push(self.value((number, plane), scan_line, inverse_w, |plane| over_w(number, plane)));
        }
        values
    }

    /// One number of what varies.
    #[inline]
    fn value(
        &self,
        (number, plane): (usize, &Plane),
        scan_line: Option<ScanLine>,
        inverse_w: f64,
        over_w: impl Fn(&Plane) -> f64,
    ) -> f64 {
        plane.clamp(match scan_line.filter(|_| plane.evaluation == Evaluation::ScanLine) {
            Some(line) => self.round(line.value(|corner| self.vertex_values(corner)[number])),
            None if self.is_over_w(number, plane) => self.divide(over_w(plane), inverse_w),
            None => over_w(plane),
        })
    }

    /// The edges around the sample, where some value runs between them.
    #[inline]
    fn scan_line(&self, x: i32, y: i32) -> Option<ScanLine> {
        let needed = self.list.interpolation == Interpolation::ScanLine
            && self.varying_planes().iter().any(|plane| plane.evaluation == Evaluation::ScanLine);
        if needed { ScanLine::around(self.vertices(), x, y) } else { None }
    }

    /// Whether a plane is that of value / w. Colors and normals may run on the screen; the eye point, behind three others, is a point
    /// in space.
    #[inline]
    pub(crate) fn is_over_w(&self, number: usize, plane: &Plane) -> bool {
        let in_space = self.list.interpolation == Interpolation::Perspective || self.list.varying.is_eye_point(number);
        in_space && !matches!(plane.evaluation, Evaluation::Constant | Evaluation::ScanLine)
    }

    /// u and v at the center of sample (x, y), the last two of [`ScreenPolygon::values`]; 0 in lists without them.
    #[inline]
    pub(crate) fn texture_place(&self, x: i32, y: i32) -> [f64; 2] {
        let first = self.list.varying.light_count();
        let [u, v] = self.varying_planes().get(first..).unwrap_or_default() else { return [0.0; 2] };
        let (inverse_w, scan_line) = (self.inverse_w(x, y), self.scan_line(x, y));
        [(first, u), (first + 1, v)]
            .map(|(number, plane)| self.value((number, plane), scan_line, inverse_w, |plane| plane.at(x, y)))
    }

    /// Change of (u, v) from sample to sample, to the right and down, where 1/w and (u, v) are these: from the planes alone.
    ///
    /// 0 where the list has no texture coordinates, and where they run along scan lines and have no planes.
    #[inline]
    pub(crate) fn texture_slopes(&self, inverse_w: f64, uv: [f64; 2]) -> [[f32; 2]; 2] {
        let first = self.list.varying.light_count();
        let (Some(depth), [u, v]) = (self.depth_plane(), self.varying_planes().get(first..).unwrap_or_default()) else {
            return [[0.0; 2]; 2];
        };
        let (by_w, w) = (depth.slope(), 1.0 / inverse_w as f32);
        let slope = |number: usize, plane: &Plane, value: f64| {
            let slope = plane.slope();
            if !self.is_over_w(number, plane) {
                return slope;
            }
            // The rule of quotients.
            [0, 1].map(|axis| (slope[axis] - value as f32 * by_w[axis]) * w)
        };
        let (u, v) = (slope(first, u, uv[0]), slope(first + 1, v, uv[1]));
        [[u[0], v[0]], [u[1], v[1]]]
    }

    #[inline]
    fn round(&self, value: f64) -> f64 {
        match self.list.precision {
            Precision::Single => f64::from(value as f32),
            Precision::Double => value,
        }
    }

    #[inline]
    fn divide(&self, value_over_w: f64, inverse_w: f64) -> f64 {
        match self.list.precision {
            Precision::Single => f64::from(value_over_w as f32 / inverse_w as f32),
            Precision::Double => value_over_w / inverse_w,
        }
    }

    /// A fragment of this polygon at sample (x, y), where 1/w is this, with color and opacity still to be filled in by a shader.
    #[inline]
    pub(super) fn bare_fragment(&self, (x, y): (i32, i32), inverse_w: f64) -> Fragment {
        let (color, opacity) = (crate::color::Rgb::gray(0.0), crate::color::Rgb::gray(1.0));
        let depth = self.list.depth_mapping.apply(inverse_w);
        Fragment { x, y, depth, color, opacity, polygon: self.index }
    }

    /// Whether the surface has holes, which are no part of the outline: samples are there or not one by one.
    #[must_use]
    #[inline]
    pub fn is_cut_out(&self) -> bool {
        self.list.shader.is_cut_out(self.record.surface)
    }
}
