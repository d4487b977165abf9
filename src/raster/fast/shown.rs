//! Shown: planes of what varies over the polygons that show in a tile.
//!
//! owners, list -SHOWN-> planes -> shade
//!
//! Shared triangles come without planes. When all polygons of a tile are through, those that are left on some sample get theirs here, once a
//! tile; all others have them in the list.
//!
//! Cost: as many planes as polygons show; 4 bytes for each polygon of the list.

use super::tile::NOBODY;
use crate::screen::{DrawList, Plane};

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
            let place = self.places[polygon as usize];
            if self.polygons.get(place as usize) == Some(&polygon) {
                continue;
            }
            let record = &list.polygons[polygon as usize];
            if record.is_shared() {
                self.places[polygon as usize] = self.polygons.len() as u32;
                self.polygons.push(polygon);
                list.shared.push_varying_planes(list.shared.triangle(record), &mut self.planes);
            }
        }
    }

    /// The planes of what varies over a polygon of the list; a shared triangle was added before.
    #[inline(always)]
    pub fn planes<'a>(&'a self, list: &'a DrawList, polygon: u32) -> &'a [Plane] {
        let record = &list.polygons[polygon as usize];
        let each = list.varying.count();
        let (planes, first) = match record.is_shared() {
            true => (&self.planes, self.places[polygon as usize] as usize * each),
            false => (&list.planes, record.first_plane as usize + 1),
        };
        planes.get(first..first + each).unwrap_or_default()
    }
}
