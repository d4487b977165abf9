//! Shown: planes of the polygons that show in a tile, or might.
//!
//! owners, list -SHOWN-> planes -> shade
//!
//! Shared triangles come without planes. When all polygons of a tile are through, those that are left on some sample get theirs here, once a
//! tile; all others have them in the list. Those with holes get theirs before, when they have samples in front: alpha asks for u and v. Where
//! lists have pictures the plane of depth is kept with the others, as the size of a sample on a picture needs it.
//!
//! Cost: as many planes as polygons show; 4 bytes for each polygon of the list.

use super::tile::NOBODY;
use crate::screen::{DrawList, Plane, ScreenPolygon};

/// The planes of one tile's polygons. Kept from tile to tile and from frame to frame.
#[derive(Debug, Default)]
pub(super) struct Shown {
    /// Of every polygon of the list, its place among those that have planes here; whatever it is for others.
    places: Vec<u32>,
    /// The polygons that have planes here.
    polygons: Vec<u32>,
    /// Their planes, one behind the other.
    planes: Vec<Plane>,
}

impl Shown {
    /// Forgets the tile before.
    pub fn clear(&mut self) {
        self.polygons.clear();
        self.planes.clear();
    }

    /// Makes the planes of all `owners` that the list has none of.
    pub fn add(&mut self, list: &DrawList, owners: impl IntoIterator<Item = u32>) {
        if list.shared.is_empty() {
            return;
        }
        if self.places.len() < list.len() {
            self.places.resize(list.len(), 0);
        }
        let mut before = NOBODY;
        for polygon in owners {
            // Neighbors often show the same.
            if polygon == before || polygon == NOBODY {
                continue;
            }
            before = polygon;
            self.add_one(list, polygon);
        }
    }

    #[inline]
    fn add_one(&mut self, list: &DrawList, polygon: u32) {
        let place = self.places[polygon as usize];
        if self.polygons.get(place as usize) == Some(&polygon) {
            return;
        }
        let record = &list.polygons[polygon as usize];
        if record.is_shared() {
            self.places[polygon as usize] = self.polygons.len() as u32;
            self.polygons.push(polygon);
            let triangle = list.shared.triangle(record);
            if list.has_texture() {
                self.planes.extend(list.shared.depth_plane(triangle));
            }
            list.shared.push_varying_planes(triangle, &mut self.planes);
        }
    }

    /// The planes of what varies over a polygon of the list; a shared triangle was added before.
    #[inline(always)]
    pub fn planes<'a>(&'a self, list: &'a DrawList, polygon: u32) -> &'a [Plane] {
        let record = &list.polygons[polygon as usize];
        let each = list.varying.count();
        let (planes, first) = match record.is_shared() {
            true => (&self.planes, self.first_of(list, polygon) + usize::from(list.has_texture())),
            false => (&list.planes, record.first_plane as usize + 1),
        };
        planes.get(first..first + each).unwrap_or_default()
    }

    #[inline(always)]
    fn first_of(&self, list: &DrawList, polygon: u32) -> usize {
        self.places[polygon as usize] as usize * (list.varying.count() + usize::from(list.has_texture()))
    }

    /// A polygon of a list with pictures, for whoever looks at its planes: a shared triangle, which was added before, comes without corners.
    #[inline]
    pub fn polygon<'a>(&'a self, list: &'a DrawList, polygon: u32) -> ScreenPolygon<'a> {
        let index = polygon as usize;
        if !list.polygons[index].is_shared() {
            return list.polygon_in_arrays(index);
        }
        let first = self.first_of(list, polygon);
        let planes = self.planes.get(first..first + 1 + list.varying.count()).unwrap_or_default();
        ScreenPolygon::of_planes(list, index, planes)
    }
}
