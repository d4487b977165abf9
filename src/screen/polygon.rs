//! A view of one polygon of a draw list: the value that rasterizers read.

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
    /// Its position in the list: the lower one keeps a sample when depths are equal.
    pub index: u32,
}

impl<'a> ScreenPolygon<'a> {
    pub(super) fn new(list: &'a DrawList, index: usize) -> Self {
        ScreenPolygon { list, record: &list.polygons[index], index: index as u32 }
    }

    /// The corners, in order around the outline.
    #[must_use]
    pub fn vertices(&self) -> &'a [ScreenVertex] {
        let first = self.record.first_vertex as usize;
        &self.list.vertices[first..first + self.record.vertex_count as usize]
    }

    /// What varies, at corner `corner`: the numbers that [`ScreenPolygon::values`] interpolates.
    #[must_use]
    pub fn vertex_values(&self, corner: usize) -> &'a [f64] {
        let count = self.list.varying.count();
        let first = (self.record.first_vertex as usize + corner) * count;
        &self.list.values[first..first + count]
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
    pub fn surface(&self) -> u32 {
        self.record.surface
    }

    /// The plane of 1/w. `None` in lists without depth (wire).
    #[must_use]
    pub fn depth_plane(&self) -> Option<&'a Plane> {
        self.list.planes.get(self.record.first_plane as usize).filter(|_| self.list.has_depth)
    }

    /// The planes of what varies, one a number: of value / w, or of the value itself with `--interpolation screen`.
    #[must_use]
    pub fn varying_planes(&self) -> &'a [Plane] {
        if !self.list.has_depth {
            return &[];
        }
        let first = self.record.first_plane as usize + 1;
        &self.list.planes[first..first + self.list.varying.count()]
    }

    /// 1/w at the center of sample (x, y), within the range at the corners; 0 in lists without depth.
    #[must_use]
    pub fn inverse_w(&self, x: i32, y: i32) -> f64 {
        self.depth_plane().map_or(0.0, |plane| plane.clamped_at(x, y))
    }

    /// Depth at the center of sample (x, y): 1/w, or integer steps. Larger is nearer.
    #[must_use]
    pub fn depth(&self, x: i32, y: i32) -> f64 {
        self.list.depth_mapping.apply(self.inverse_w(x, y))
    }

    /// What varies, at the center of sample (x, y): red, green, blue; or normal and eye point.
    ///
    /// The contract's one definition: value / w and 1/w by their planes, one division, within the range at the corners.
    #[must_use]
    pub fn values(&self, x: i32, y: i32) -> Values {
        let mut values = Values::default();
        let inverse_w = self.inverse_w(x, y);
        for plane in self.varying_planes() {
            values.push(plane.clamp(self.divide(plane, plane.at(x, y), inverse_w)));
        }
        values
    }

    /// What varies, from `inverse_w` and value / w of every number, however a rasterizer came by them: incrementally, say.
    ///
    /// `over_w` has one number for each of [`ScreenPolygon::varying_planes`]; further ones are not looked at.
    #[must_use]
    pub fn values_from(&self, inverse_w: f64, over_w: &[f32]) -> Values {
        let mut values = Values::default();
        for (plane, &number) in self.varying_planes().iter().zip(over_w) {
            values.push(plane.clamp(self.divide(plane, f64::from(number), inverse_w)));
        }
        values
    }

    fn divide(&self, plane: &Plane, value_over_w: f64, inverse_w: f64) -> f64 {
        if plane.evaluation == Evaluation::Constant || self.list.interpolation == Interpolation::Screen {
            return value_over_w;
        }
        match self.list.precision {
            Precision::Single => f64::from(value_over_w as f32 / inverse_w as f32),
            Precision::Double => value_over_w / inverse_w,
        }
    }

    /// A fragment of this polygon at sample (x, y), with color and opacity still to be filled in by a shader.
    pub(super) fn bare_fragment(&self, x: i32, y: i32) -> Fragment {
        let (color, opacity) = (crate::color::Rgb::gray(0.0), crate::color::Rgb::gray(1.0));
        Fragment { x, y, depth: self.depth(x, y), color, opacity, polygon: self.index }
    }
}
