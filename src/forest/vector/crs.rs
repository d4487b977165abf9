//! Crs: what the two numbers of a position mean.
//!
//! "EPSG:32629" -CRS-> longitude and latitude -CRS-> the map of the area
//!
//! Why only three kinds: inventories and maps of a landscape come in degrees on WGS 84 or on a UTM map of it. A national grid has a datum of its own, and
//! guessing at it would move roads by hundreds of metres without a word: such a file is refused and must be converted first.
//!
//! Space: degrees east and north, or metres east and north.

use crate::forest::elevation::{Utm, from_utm, utm};

/// A reference system of the plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Crs {
    /// Longitude and latitude in degrees, WGS 84, in this order: `EPSG:4326`, `OGC:CRS84`.
    Degrees,
    /// A zone of UTM on WGS 84, metres: `EPSG:326zz` north, `EPSG:327zz` south.
    Utm {
        /// 1 to 60.
        zone: u32,
        /// South of the equator.
        south: bool,
    },
}

impl Crs {
    /// What a file calls it; `None`: unknown here.
    ///
    /// ```
    /// use farop::forest::vector::Crs;
    /// assert_eq!(Crs::named("EPSG:32631"), Some(Crs::Utm { zone: 31, south: false }));
    /// assert_eq!(Crs::named("urn:ogc:def:crs:OGC:1.3:CRS84"), Some(Crs::Degrees));
    /// assert_eq!(Crs::named("EPSG:3763"), None);
    /// ```
    #[must_use]
    pub fn named(name: &str) -> Option<Crs> {
        let upper = name.trim().to_ascii_uppercase();
        let last = upper.rsplit(':').next()?;
        if last == "CRS84" {
            return Some(Crs::Degrees);
        }
        if !upper.contains("EPSG") {
            return None;
        }
        Crs::of_code(last.parse().ok()?)
    }

    /// The system with this EPSG number; `None`: unknown here.
    #[must_use]
    pub fn of_code(code: u32) -> Option<Crs> {
        match code {
            4326 => Some(Crs::Degrees),
            32_601..=32_660 => Some(Crs::Utm { zone: code - 32_600, south: false }),
            32_701..=32_760 => Some(Crs::Utm { zone: code - 32_700, south: true }),
            _ => None,
        }
    }

    /// Its EPSG number.
    #[must_use]
    pub fn code(self) -> u32 {
        match self {
            Crs::Degrees => 4326,
            Crs::Utm { zone, south: false } => 32_600 + zone,
            Crs::Utm { zone, south: true } => 32_700 + zone,
        }
    }

    /// A position of this system in another one.
    #[must_use]
    pub fn to(self, other: Crs, position: [f64; 2]) -> [f64; 2] {
        if self == other {
            return position;
        }
        let (longitude, latitude) = match self {
            Crs::Degrees => (position[0], position[1]),
            Crs::Utm { zone, south } => from_utm(&Utm { zone, south, east: position[0], north: position[1] }),
        };
        match other {
            Crs::Degrees => [longitude, latitude],
            Crs::Utm { zone, south } => {
                let map = utm(longitude, latitude, zone);
                [
                    map.east,
                    map.north
                        + if south == map.south {
                            0.0
                        } else if south {
                            10e6
                        } else {
                            -10e6
                        },
                ]
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_known_number_comes_back() {
        let known: Vec<u32> = (0..40_000).filter(|code| Crs::of_code(*code).is_some()).collect();
        assert_eq!(known.len(), 121);
        for code in known {
            assert_eq!(Crs::named(&format!("urn:ogc:def:crs:EPSG::{code}")).map(Crs::code), Some(code));
        }
        for name in ["", "EPSG:", "EPSG:32600", "EPSG:32661", "UTM 29", "32629"] {
            assert_eq!(Crs::named(name), None, "{name}");
        }
    }

    #[test]
    fn there_and_back_is_the_same_place_also_over_the_equator() {
        let north = Crs::Utm { zone: 31, south: false };
        let south = Crs::Utm { zone: 31, south: true };
        for place in [[1.5, 42.5], [3.0, -0.01], [5.9, 0.0]] {
            for map in [north, south] {
                let back = map.to(Crs::Degrees, Crs::Degrees.to(map, place));
                assert!((back[0] - place[0]).abs() < 1e-9 && (back[1] - place[1]).abs() < 1e-9, "{place:?} {back:?}");
            }
        }
        assert!((north.to(south, [500_000.0, 10.0])[1] - 10_000_010.0).abs() < 1e-6);
    }
}
