//! Shared: triangles of a mesh as indices of their corners, with nothing that can be computed from these.
//!
//! geometry -> SHARED -> `fast`; for all others a polygon is made whole when it is asked for
//!
//! Why: in a fine mesh six triangles meet at a vertex, most of them cover no sample, and of those that do many are hidden. Copies of corners
//! and planes for all of them are most of what the geometry stage writes. So a corner is kept once, and planes are made by [`super::linear`], from the
//! same numbers in the same order, of those triangles alone that show. `docs/decisions/0038` tells what was weighed.
//!
//! Space: eye space; places in 1/256 of a sample. Cost: 60 bytes a corner, 16 more where lists have pictures, 24 for each light of it, 24 a
//! triangle.

use super::corner::{Corner, Outline, Projection, Ready};
use super::{DrawList, EdgeKind, Plane, PolygonRecord, ScreenPolygon, ScreenVertex};
use crate::math::{Vec3, newell_normal};
use std::sync::OnceLock;

/// In place of the first plane of a polygon: it is a shared triangle, and its first vertex is its place among these.
const SHARED: u32 = u32::MAX;
/// Values that belong to one triangle alone are apart from those of vertices.
pub(crate) const OWN: u32 = 1 << 31;

/// The shared triangles of a [`DrawList`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shared {
    /// From clip space to screen and planes; `None` in lists that share nothing.
    pub(crate) projection: Option<Projection>,
    /// Of every corner, its snapped place in 1/256 of a sample.
    pub(crate) places: Vec<[i32; 2]>,
    /// Of every corner, what planes are made of.
    pub(crate) corners: Vec<SharedCorner>,
    /// Of every corner, u and v; none in lists without pictures.
    pub(crate) uv: Vec<[f64; 2]>,
    /// What varies at vertices, seen from one side.
    pub(crate) of_vertices: SharedValues,
    /// What varies at corners of one triangle alone.
    pub(crate) own: SharedValues,
    pub(crate) triangles: Vec<SharedTriangle>,
    whole: OnceLock<Box<DrawList>>,
}

/// A corner of shared triangles.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct SharedCorner {
    /// Eye space, as the geometry stage has it.
    pub position: Vec3,
    /// x and y of the eye point that clip space gives back; z is that of `position`.
    pub eye: [f64; 2],
    pub inverse_w: f64,
}

/// Colors or normals, and factors on colors where the list has them.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct SharedValues {
    pub light: Vec<[f64; 3]>,
    pub factors: Vec<[f64; 3]>,
}

/// A shared triangle: its corners, and where what varies there is kept (marked [`OWN`] where it is its own).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct SharedTriangle {
    pub corners: [u32; 3],
    pub values: [u32; 3],
}

/// Memory for a polygon that is made whole.
#[derive(Clone, Debug, Default)]
pub struct Whole {
    vertices: Vec<ScreenVertex>,
    values: Vec<f64>,
    planes: Vec<Plane>,
}

impl PolygonRecord {
    /// The record of shared triangle `number`.
    #[inline(always)]
    pub(crate) fn shared(number: u32, surface: u32, source: super::Source) -> PolygonRecord {
        PolygonRecord { first_vertex: number, vertex_count: 3, first_plane: SHARED, surface, source }
    }

    /// Whether it is a shared triangle.
    #[inline(always)]
    pub(crate) fn is_shared(&self) -> bool {
        self.first_plane == SHARED
    }
}

impl SharedValues {
    fn clear(&mut self) {
        self.light.clear();
        self.factors.clear();
    }

    fn bytes(&self) -> usize {
        size_of_val(&self.light[..]) + size_of_val(&self.factors[..])
    }

    /// Appends those of `others`.
    pub fn append(&mut self, others: &SharedValues) {
        self.light.extend_from_slice(&others.light);
        self.factors.extend_from_slice(&others.factors);
    }
}

impl Shared {
    /// How many triangles there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.triangles.len()
    }

    /// Whether there are none.
    #[must_use]
    #[inline(always)]
    pub fn is_empty(&self) -> bool {
        self.triangles.is_empty()
    }

    /// Empties it and keeps its memory.
    pub(crate) fn clear(&mut self) {
        self.projection = None;
        self.places.clear();
        self.corners.clear();
        self.uv.clear();
        self.of_vertices.clear();
        self.own.clear();
        self.triangles.clear();
        self.whole = OnceLock::new();
    }

    /// Bytes of its arrays.
    pub(crate) fn bytes(&self) -> usize {
        size_of_val(&self.places[..])
            + size_of_val(&self.corners[..])
            + size_of_val(&self.uv[..])
            + size_of_val(&self.triangles[..])
            + self.of_vertices.bytes()
            + self.own.bytes()
    }

    /// The triangle of a shared record.
    #[inline(always)]
    pub(crate) fn triangle(&self, record: &PolygonRecord) -> &SharedTriangle {
        &self.triangles[record.first_vertex as usize]
    }

    /// Its snapped corners, in 1/256 of a sample.
    #[inline(always)]
    pub(crate) fn places(&self, triangle: &SharedTriangle) -> [[i32; 2]; 3] {
        let [a, b, c] = triangle.corners;
        [self.places[a as usize], self.places[b as usize], self.places[c as usize]]
    }

    #[inline(always)]
    fn corner(&self, triangle: &SharedTriangle, number: usize) -> Corner {
        let place = triangle.corners[number] as usize;
        let &SharedCorner { position, eye: [x, y], inverse_w } = &self.corners[place];
        let ready = Ready { eye: Vec3::new(x, y, position.z), inverse_w, ..Ready::default() };
        let value = triangle.values[number];
        let values = if value & OWN == 0 { &self.of_vertices } else { &self.own };
        let index = (value & !OWN) as usize;
        let factor = values.factors.get(index).copied().unwrap_or_default();
        Corner { ready, values: values.light[index], factor, place: self.uv.get(place).copied().unwrap_or_default() }
    }

    #[inline(always)]
    fn newell(&self, triangle: &SharedTriangle) -> Vec3 {
        newell_normal(&triangle.corners.map(|corner| self.corners[corner as usize].position))
    }

    /// The plane of a triangle's depth.
    #[inline(always)]
    pub(crate) fn depth_plane(&self, triangle: &SharedTriangle) -> Option<Plane> {
        let corners = triangle.corners.map(|corner| &self.corners[corner as usize]);
        let eye = Vec3::new(corners[0].eye[0], corners[0].eye[1], corners[0].position.z);
        let newell = self.newell(triangle);
        let at_corners = corners.into_iter().map(|corner| corner.inverse_w);
        self.projection.as_ref().map(|projection| projection.planes.depth(newell / newell.dot(eye), at_corners))
    }

    /// Adds the planes of what varies over a triangle.
    #[inline(always)]
    pub(crate) fn push_varying_planes(&self, triangle: &SharedTriangle, planes: &mut Vec<Plane>) {
        let Some(projection) = &self.projection else { return };
        let corners = [self.corner(triangle, 0), self.corner(triangle, 1), self.corner(triangle, 2)];
        let newell = self.newell(triangle);
        let outline = Outline { before: &corners, clipped: &corners, from_clipped: false, newell, affine: true };
        projection.planes.push_varying(&outline, ([0, 1, 2], outline.inverse_w()), planes);
    }

    /// Makes a triangle whole, at the end of these arrays.
    fn push_whole(&self, triangle: &SharedTriangle, whole: &mut Whole) {
        let Some(projection) = &self.projection else { return };
        let mut corners = [self.corner(triangle, 0), self.corner(triangle, 1), self.corner(triangle, 2)];
        let constants = projection.constants(&corners);
        for (corner, index) in corners.iter_mut().zip(triangle.corners) {
            let clip = projection.clip_space(self.corners[index as usize].position);
            corner.ready = projection.ready(clip, EdgeKind::Original);
            constants.hold(corner);
            whole.vertices.push(corner.ready.screen);
            projection.push_values(corner, &mut whole.values);
        }
        let newell = self.newell(triangle);
        let outline = Outline { before: &corners, clipped: &corners, from_clipped: false, newell, affine: true };
        projection.planes.push(&outline, [0, 1, 2], &mut whole.planes);
    }
}

impl DrawList {
    /// The same list without shared triangles: all corners, values and planes are in its arrays. Made once; a list that shares
    /// nothing is it already.
    #[must_use]
    pub fn whole(&self) -> &DrawList {
        if self.shared.is_empty() {
            return self;
        }
        self.shared.whole.get_or_init(|| Box::new(self.made_whole()))
    }

    fn made_whole(&self) -> DrawList {
        let mut list = DrawList { shader: self.shader.clone(), ..DrawList::new(0, 0) };
        list.take_setting(self);
        let planes_each = if self.has_depth { 1 + self.varying.count() } else { 0 };
        let mut room = Whole::default();
        let mut before = None;
        for record in &self.polygons {
            let (first_vertex, first_plane) = (room.vertices.len() as u32, room.planes.len() as u32);
            if record.is_shared() {
                self.shared.push_whole(self.shared.triangle(record), &mut room);
                list.polygons.push(PolygonRecord { first_vertex, first_plane, ..*record });
                before = None;
                continue;
            }
            let numbers = self.varying.count();
            let vertices = record.first_vertex as usize..(record.first_vertex + record.vertex_count) as usize;
            room.values.extend_from_slice(&self.values[vertices.start * numbers..vertices.end * numbers]);
            room.vertices.extend_from_slice(&self.vertices[vertices]);
            // Pieces of one polygon share its planes.
            let first_plane = match before {
                Some((own, made)) if own == record.first_plane => made,
                _ => {
                    let first = record.first_plane as usize;
                    room.planes.extend_from_slice(&self.planes[first..first + planes_each]);
                    first_plane
                }
            };
            before = Some((record.first_plane, first_plane));
            list.polygons.push(PolygonRecord { first_vertex, first_plane, ..*record });
        }
        (list.vertices, list.values, list.planes) = (room.vertices, room.values, room.planes);
        list
    }

    /// As [`DrawList::polygon`]; a shared triangle is made whole in `room`, and the rest of the list stays as it is.
    ///
    /// # Panics
    /// If there is no such polygon.
    #[must_use]
    #[inline]
    pub fn polygon_in<'a>(&'a self, index: usize, room: &'a mut Whole) -> ScreenPolygon<'a> {
        let record = &self.polygons[index];
        if !record.is_shared() {
            return ScreenPolygon::new(self, index);
        }
        room.vertices.clear();
        room.values.clear();
        room.planes.clear();
        self.shared.push_whole(self.shared.triangle(record), room);
        ScreenPolygon::of((self, record, index), (&room.vertices, &room.values, &room.planes))
    }
}
