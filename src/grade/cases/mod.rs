//! The cases of every aspect, made in code.
//!
//! Colors of faces lie a quarter above a whole level: rounding, cutting off and multiplying by 256 agree about them, so only
//! the aspect "levels" asks about that.

pub mod color;
pub mod coverage;
pub mod depth;
pub mod light;
pub mod lines;
pub mod samples;

/// The color of face `number`: no two alike, no channel like another.
pub(super) fn tint(number: usize) -> [f64; 3] {
    let levels = [
        [150, 40, 90],
        [30, 170, 60],
        [60, 80, 180],
        [170, 140, 20],
        [120, 20, 160],
        [20, 130, 140],
        [90, 110, 30],
        [180, 70, 50],
    ];
    let [r, g, b] = levels[number % levels.len()];
    // From the ninth on a little darker, so that a mesh of many faces has no two alike either.
    let dark = (number / levels.len()) as f64;
    [r, g, b].map(|level| (f64::from(level) - dark + 0.25) / 255.0)
}

/// A rectangle's corners.
pub(super) fn rectangle(left: f64, top: f64, right: f64, bottom: f64) -> [(f64, f64); 4] {
    [(left, top), (right, top), (right, bottom), (left, bottom)]
}

/// Random numbers: splitmix64. Source: Steele, Lea and Flood, OOPSLA 2014.
pub(super) struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut mixed = self.0;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        mixed ^ (mixed >> 31)
    }

    /// A multiple of 1/256 from 0 to `most`.
    pub fn coordinate(&mut self, most: u32) -> f64 {
        (self.next() % (u64::from(most) * 256 + 1)) as f64 / 256.0
    }

    /// A triangle with some area in a picture of that size.
    pub fn triangle(&mut self, width: u32, height: u32) -> [(f64, f64); 3] {
        loop {
            let corners = [0; 3].map(|_| (self.coordinate(width), self.coordinate(height)));
            if super::covered::cross(corners[0], corners[1], corners[2]).abs() > f64::from(width * height) / 4.0 {
                return corners;
            }
        }
    }
}
