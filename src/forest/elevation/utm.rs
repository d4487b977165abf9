//! UTM: longitude and latitude as metres on a map, and back.
//!
//! Why the series of Krüger and not the usual one by powers of the longitude: with six terms it is right to a millionth of a
//! millimetre within a zone and to millimetres far beyond, and it is twelve coefficients instead of a page of them.
//!
//! Space: degrees, WGS 84; metres east (500,000 on the zone's middle meridian) and north (0 on the equator; south of it 10,000,000).
//! Source: L. Krüger, "Konforme Abbildung des Erdellipsoids in der Ebene", 1912; the coefficients by powers of the third flattening
//! as in C. Karney, "Transverse Mercator with an accuracy of a few nanometers", J. Geodesy 85, 2011, 475-485.

use super::{FLATTENING, RADIUS};
use crate::math::{PI, atan, cos, radians, sin};
use libm::{asinh, atan2, atanh, cosh, sinh, tanh};

/// A position on a UTM map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Utm {
    /// 1 to 60, from 180 degrees west.
    pub zone: u32,
    /// On the southern half: `north` counts from 10,000 km below the equator.
    pub south: bool,
    /// Metres; 500,000 on the middle meridian of the zone.
    pub east: f64,
    /// Metres.
    pub north: f64,
}

/// The scale on the middle meridian.
const SCALE: f64 = 0.9996;
/// The third flattening n = f / (2 - f).
const N: f64 = FLATTENING / (2.0 - FLATTENING);

/// Coefficients of sin 2jx that lead from the sphere to the ellipsoid, j = 1..6.
const FORWARD: [[f64; 7]; 6] = [
    [0.0, 1.0 / 2.0, -2.0 / 3.0, 5.0 / 16.0, 41.0 / 180.0, -127.0 / 288.0, 7891.0 / 37800.0],
    [0.0, 0.0, 13.0 / 48.0, -3.0 / 5.0, 557.0 / 1440.0, 281.0 / 630.0, -1_983_433.0 / 1_935_360.0],
    [0.0, 0.0, 0.0, 61.0 / 240.0, -103.0 / 140.0, 15061.0 / 26880.0, 167_603.0 / 181_440.0],
    [0.0, 0.0, 0.0, 0.0, 49561.0 / 161_280.0, -179.0 / 168.0, 6_601_661.0 / 7_257_600.0],
    [0.0, 0.0, 0.0, 0.0, 0.0, 34729.0 / 80640.0, -3_418_889.0 / 1_995_840.0],
    [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 212_378_941.0 / 319_334_400.0],
];
/// And back.
const BACKWARD: [[f64; 7]; 6] = [
    [0.0, 1.0 / 2.0, -2.0 / 3.0, 37.0 / 96.0, -1.0 / 360.0, -81.0 / 512.0, 96199.0 / 604_800.0],
    [0.0, 0.0, 1.0 / 48.0, 1.0 / 15.0, -437.0 / 1440.0, 46.0 / 105.0, -1_118_711.0 / 3_870_720.0],
    [0.0, 0.0, 0.0, 17.0 / 480.0, -37.0 / 840.0, -209.0 / 4480.0, 5569.0 / 90720.0],
    [0.0, 0.0, 0.0, 0.0, 4397.0 / 161_280.0, -11.0 / 504.0, -830_251.0 / 7_257_600.0],
    [0.0, 0.0, 0.0, 0.0, 0.0, 4583.0 / 161_280.0, -108_847.0 / 3_991_680.0],
    [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 20_648_693.0 / 638_668_800.0],
];

/// The zone of a longitude in degrees. The exceptions around Norway and Svalbard are not made.
#[must_use]
pub fn zone_of(longitude: f64) -> u32 {
    let turned = (longitude + 180.0).rem_euclid(360.0);
    (turned / 6.0) as u32 % 60 + 1
}

/// The position of a longitude and latitude, in degrees, on the map of `zone`.
///
/// Right to a thousandth of a millimetre within 10 degrees of the zone's middle.
///
/// ```
/// let monchique = farop::forest::elevation::utm(-8.5936, 37.3158, 29);
/// assert!((monchique.east - 536_009.861).abs() < 1e-3 && (monchique.north - 4_129_983.446).abs() < 1e-3);
/// ```
#[must_use]
pub fn utm(longitude: f64, latitude: f64, zone: u32) -> Utm {
    let lambda = radians(longitude - middle_of(zone));
    // The conformal latitude, by its tangent.
    let sine = sin(radians(latitude));
    let e = (FLATTENING * (2.0 - FLATTENING)).sqrt();
    let tau = sinh(atanh(sine) - e * atanh(e * sine));
    let (xi, eta) = (atan2(tau, cos(lambda)), asinh(sin(lambda) / (tau * tau + cos(lambda) * cos(lambda)).sqrt()));
    let (north, east) = bent(xi, eta, &FORWARD, 1.0);
    let south = latitude < 0.0;
    let false_north = if south { 10_000_000.0 } else { 0.0 };
    Utm {
        zone,
        south,
        east: 500_000.0 + SCALE * rectifying() * east,
        north: false_north + SCALE * rectifying() * north,
    }
}

/// Longitude and latitude, in degrees, of a position on the map.
#[must_use]
pub fn from_utm(place: &Utm) -> (f64, f64) {
    let false_north = if place.south { 10_000_000.0 } else { 0.0 };
    let scale = SCALE * rectifying();
    let (xi, eta) = bent((place.north - false_north) / scale, (place.east - 500_000.0) / scale, &BACKWARD, -1.0);
    let tau = sin(xi) / (sinh(eta) * sinh(eta) + cos(xi) * cos(xi)).sqrt();
    let lambda = atan2(sinh(eta), cos(xi));
    // From the conformal latitude to the true one: a fixed point, which closes in by e^2 = 1/150 a round.
    let e = (FLATTENING * (2.0 - FLATTENING)).sqrt();
    let isometric = asinh(tau);
    let mut sine = tanh(isometric);
    for _ in 0..9 {
        sine = tanh(isometric + e * atanh(e * sine));
    }
    let latitude = atan(sine / ((1.0 - sine) * (1.0 + sine)).sqrt());
    (middle_of(place.zone) + lambda * (180.0 / PI), latitude * (180.0 / PI))
}

/// Longitude of the middle meridian of a zone.
fn middle_of(zone: u32) -> f64 {
    f64::from(zone) * 6.0 - 183.0
}

/// Radius of the sphere whose meridians are as long as the ellipsoid's.
fn rectifying() -> f64 {
    RADIUS / (1.0 + N) * (1.0 + N * N / 4.0 + N.powi(4) / 64.0 + N.powi(6) / 256.0)
}

/// Adds the series of `coefficients` to a position on the sphere, `sign` times.
fn bent(xi: f64, eta: f64, coefficients: &[[f64; 7]; 6], sign: f64) -> (f64, f64) {
    let (mut bent_xi, mut bent_eta) = (xi, eta);
    for (j, powers) in coefficients.iter().enumerate() {
        let value = powers.iter().rev().fold(0.0, |sum, &power| sum * N + power);
        let twice = 2.0 * (j + 1) as f64;
        bent_xi += sign * value * sin(twice * xi) * cosh(twice * eta);
        bent_eta += sign * value * cos(twice * xi) * sinh(twice * eta);
    }
    (bent_xi, bent_eta)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_and_back_is_a_micrometre() {
        for zone in [1, 31, 60] {
            for (dx, latitude) in [(0.0, 0.0), (-3.0, 84.0), (2.9, -79.5), (9.0, 41.25), (-0.001, -0.001)] {
                let longitude = middle_of(zone) + dx;
                let (x, y) = from_utm(&utm(longitude, latitude, zone));
                assert!(
                    (x - longitude).abs() < 1e-11 && (y - latitude).abs() < 1e-11,
                    "{zone} {dx} {latitude}: {x} {y}"
                );
            }
        }
    }

    #[test]
    fn zones_turn_round_the_earth() {
        assert_eq!([-180.0, -179.9, 0.0, 5.999, 6.0, 179.9, 180.0].map(zone_of), [1, 1, 31, 31, 32, 60, 1]);
    }
}
