//! mount: a fractal mountain of 2 * 4^size triangles under four glass spheres.
//!
//! What it tests: a height field of rough triangles, transparency, a part of the mountain outside the view.
//! A square is halved, again and again; new points are the mean of old ones plus a random height, less
//! at every step. The height of a lattice point comes from a hash of its position, so that neighboring squares
//! agree on their edge without memory. The hash is the historical one, which uses one coordinate twice and so makes
//! visible repetition: it is what the published scene has.
//!
//! Source: SPD 3.14; A. Fournier, D. Fussell, L. Carpenter, "Computer Rendering of Stochastic Models",
//! CACM 25(6), 1982, 371-384; normal numbers by the polar method of G. Marsaglia, 1962.

use super::nff::{NO_HIGHLIGHT, Nff, SKY, View};
use super::turn::rotation_z;
use super::{Counts, SpdScene, power};
use crate::math::{PI, Vec3, log, pow};
use std::io;

pub(super) const SCENE: SpdScene = SpdScene {
    name: "mount",
    default_size: 6,
    summary: "a fractal mountain of 2 * 4^size triangles under four glass spheres",
    sized: true,
    fixed_resolution: None,
    view,
    body,
    count: |size, _| Counts { p: power(4, size).saturating_mul(2), s: 4, l: 1, f: 2, ..Counts::default() },
};

/// How much farther the middle of a square is from its corners than the middle of an edge, in the original's digits:
/// with the true root some heights near zero change in the fifth digit.
#[expect(clippy::approx_constant, reason = "the published scene was made with this number")]
const ROOT_OF_2: f64 = 1.414_213_6;

fn view(_size: u32) -> View {
    View {
        background: SKY,
        from: Vec3::new(-1.6, 1.6, 1.7),
        at: Vec3::ZERO,
        up: Vec3::Z,
        angle: 45.0,
        hither: 0.01,
        resolution: 512,
        lights: vec![Vec3::new(-100.0, -100.0, 100.0)],
    }
}

fn body(nff: &mut Nff<'_>, size: u32) -> io::Result<()> {
    nff.surface([1.0, 1.0, 1.0], [0.1, 0.1, 101.148, 0.9, 1.5])?;
    spheres(nff)?;
    nff.surface([0.5, 0.45, 0.35], [1.0, 0.0, NO_HIGHLIGHT, 0.0, 0.0])?;
    // Fractal dimension 2.2: the variance falls by 2^(1/(2.2 - 1)) when the width halves.
    let roughness = (pow(2.0, 1.0 / 3.0) - 1.0).sqrt();
    let mountain = Mountain { size, width: 1 << size, roughness };
    mountain.square(nff, Square { x: 0, y: 0, width: mountain.width }, [0.0; 4])
}

/// One sphere above, three below, all touching.
fn spheres(nff: &mut Nff<'_>) -> io::Result<()> {
    let middle = Vec3::new(-0.8, 0.8, 1.0);
    let radius = 0.17;
    let rise = radius * 1.5_f64.sqrt();
    nff.sphere(middle + Vec3::new(0.0, 0.0, rise), radius)?;
    (0..3).try_for_each(|i| {
        let arm = Vec3::new(2.0 * rise / 3.0, -2.0 * rise / 3.0, -rise / 3.0);
        nff.sphere(middle + rotation_z(2.0 * PI * f64::from(i) / 3.0) * arm, radius)
    })
}

struct Mountain {
    size: u32,
    /// Cells a side.
    width: u32,
    roughness: f64,
}

/// A square of lattice cells, by its corner of least x and y.
struct Square {
    x: u32,
    y: u32,
    width: u32,
}

impl Mountain {
    /// Draws a square whose corners, counterclockwise from (x, y), have the given heights.
    fn square(&self, nff: &mut Nff<'_>, square: Square, heights: [f64; 4]) -> io::Result<()> {
        if square.width == 1 {
            return self.cell(nff, &square, heights);
        }

        // Heights at the middle of the edges and of the square.
        let Square { x, y, width } = square;
        let half = width / 2;
        let [ll, lr, ur, ul] = heights;
        let rise = 2.0 * f64::from(half) / f64::from(self.width) * self.roughness;
        let lower = (ll + lr) / 2.0 + rise * self.normal(x + half, y);
        let right = (lr + ur) / 2.0 + rise * self.normal(x + width, y + half);
        let upper = (ur + ul) / 2.0 + rise * self.normal(x + half, y + width);
        let left = (ul + ll) / 2.0 + rise * self.normal(x, y + half);
        let middle = (ll + lr + ur + ul) / 4.0 + ROOT_OF_2 * rise * self.normal(x + half, y + half);

        let quarter = |x, y| Square { x, y, width: half };
        self.square(nff, quarter(x, y), [ll, lower, middle, left])?;
        self.square(nff, quarter(x + half, y), [lower, lr, right, middle])?;
        self.square(nff, quarter(x + half, y + half), [middle, right, ur, upper])?;
        self.square(nff, quarter(x, y + half), [left, middle, upper, ul])
    }

    /// Two triangles.
    fn cell(&self, nff: &mut Nff<'_>, cell: &Square, heights: [f64; 4]) -> io::Result<()> {
        let at = |place: u32| -1.0 + 2.0 * f64::from(place) / f64::from(self.width);
        let (x0, x1, y0, y1) = (at(cell.x), at(cell.x + 1), at(cell.y), at(cell.y + 1));
        let [ll, lr, ur, ul] = heights;
        let [c0, c1, c2, c3] =
            [Vec3::new(x0, y0, ll), Vec3::new(x1, y0, lr), Vec3::new(x1, y1, ur), Vec3::new(x0, y1, ul)];
        nff.polygon(&[c0, c1, c2])?;
        nff.polygon(&[c2, c3, c0])
    }

    /// The random number of a lattice point: normal distribution, mean 0, variance 1.
    fn normal(&self, x: u32, y: u32) -> f64 {
        gauss(seed(self.size, x, y))
    }
}

/// The seed of lattice point (x, y), 21 to 65556.
fn seed(size: u32, x: u32, y: u32) -> u64 {
    let shifted = |place: u32, places: u32| places.checked_sub(size).map_or(0, |by| u64::from(place) << by);
    21 + (shifted(x, 23) + shifted(y, 15) + shifted(x, 7)) % 65536
}

/// A normally distributed number that depends on the seed alone.
fn gauss(seed: u64) -> f64 {
    let next = |state: u64| (28411 + 8121 * state) % 134_456;
    let mut state = seed;
    loop {
        let first = next(state);
        state = next(first);
        let [x, y] = [first, state].map(|drawn| 2.0 * drawn as f64 / 134_456.0 - 1.0);
        let square = x * x + y * y;
        if square < 1.0 {
            return x * (-2.0 * log(square) / square).sqrt();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seeds_and_numbers_are_the_published_ones() {
        for (size, (x, y), expected_seed, expected) in [
            (6, (32, 0), 85, -1.075_075_93),
            (6, (64, 32), 16533, 1.289_156_66),
            (6, (33, 47), 24151, 1.503_406_14),
            (8, (129, 255), 65429, -0.632_678_14),
        ] {
            assert_eq!(seed(size, x, y), expected_seed);
            assert!((gauss(expected_seed) - expected).abs() < 5e-9, "{}", gauss(expected_seed));
        }
    }

    #[test]
    fn every_seed_gives_a_modest_number() {
        let largest = (21..21 + 65536).map(|seed| gauss(seed).abs()).fold(0.0, f64::max);
        assert!((4.233..4.2335).contains(&largest), "{largest}");
    }
}
