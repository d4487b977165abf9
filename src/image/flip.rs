//! FLIP: how large the difference between two pictures looks when one flips between them on a display.
//!
//! `Picture` expected, `Picture` actual -> one number from 0 to 1 for every pixel
//!
//! 1. Colors: both pictures are blurred as the eye blurs them at that distance, in a space of one brightness and two color
//!    axes; the difference is taken in a space of even steps (HyAB in CIELAB) and compressed to 0..1.
//! 2. Features: edges and points are looked for in the brightness; those that only one picture has make the
//!    difference larger.
//!
//! Space: sRGB display values; filters in degrees of sight, at 67 pixels a degree (a screen of 0.7 m and 3840 pixels seen from
//! 0.7 m). Outside the picture its border pixels go on.
//! Source: Andersson, Nilsson, Akenine-Moeller, Oskarsson, Astroem, Fairchild, "FLIP: A Difference Evaluator for Alternating
//! Images", Proceedings of the ACM on Computer Graphics 3(2), 2020. Cost: about 300 products a pixel and picture.

use super::Picture;
use super::planes::{Plane, separable};
use crate::color::{Encoding, Rgb};
use crate::math::{Mat3, PI, Vec3, exp, pow};

/// 0.7 m away, 3840 pixels on 0.7 m.
const PIXELS_A_DEGREE: f64 = 0.7 * (3840.0 / 0.7) * (PI / 180.0);
/// How differences of color are compressed: exponent, and the part `KNEE` of the largest that is mapped to `HIGH`.
const COLOR_EXPONENT: f64 = 0.7;
const KNEE: f64 = 0.4;
const HIGH: f64 = 0.95;
const FEATURE_EXPONENT: f64 = 0.5;
/// Width of the feature detector, degrees.
const FEATURE_WIDTH: f64 = 0.082;
/// Sensitivity to contrast as a sum of two Gaussians (weight, spread): brightness, red-green, blue-yellow.
const SENSITIVITY: [[(f64, f64); 2]; 3] =
    [[(1.0, 0.0047), (0.0, 1e-5)], [(1.0, 0.0053), (0.0, 1e-5)], [(34.1, 0.04), (13.5, 0.025)]];
/// XYZ of display white.
const WHITE: [f64; 3] = [0.950_428_545_4, 1.0, 1.088_900_370_8];

/// The difference of every pixel of two pictures of one size, row after row from the top: 0 equal, 1 as different as can be.
///
/// # Panics
/// When the sizes differ.
#[must_use]
pub fn flip(expected: &Picture, actual: &Picture) -> Vec<f64> {
    FlipReference::new(expected).differences(actual)
}

/// The expected picture, seen once and compared with many.
pub struct FlipReference(Seen);

/// What the eye makes of a picture.
struct Seen {
    size: (usize, usize),
    /// CIELAB, the color axes weighted by brightness (Hunt's effect).
    colors: Vec<[f64; 3]>,
    /// Strength of edges and of points.
    features: Vec<[f64; 2]>,
}

impl FlipReference {
    /// Looks at the expected picture.
    #[must_use]
    pub fn new(expected: &Picture) -> FlipReference {
        FlipReference(see(expected))
    }

    /// The difference of every pixel; see [`flip`].
    ///
    /// # Panics
    /// When the sizes differ.
    #[must_use]
    pub fn differences(&self, actual: &Picture) -> Vec<f64> {
        let (expected, actual) = (&self.0, see(actual));
        assert_eq!(expected.size, actual.size, "pictures of one size");
        let largest = largest_color_difference();
        let pixel = |at: usize| {
            let color = compressed(hyab(expected.colors[at], actual.colors[at]), largest);
            let [edges, points] = [0, 1].map(|kind| (expected.features[at][kind] - actual.features[at][kind]).abs());
            let feature = pow(edges.max(points) / 2.0_f64.sqrt(), FEATURE_EXPONENT);
            pow(color, 1.0 - feature.min(1.0))
        };
        (0..expected.colors.len()).map(pixel).collect()
    }
}

fn see(picture: &Picture) -> Seen {
    let (width, height) = (picture.width(), picture.height());
    let opponents: Vec<[f64; 3]> = picture
        .colors()
        .map(|color| opponent(xyz(Encoding::Srgb.decode(Rgb::from(color.map(|level| f64::from(level) / 255.0))))))
        .collect();
    let plane = |axis: usize| {
        let values = opponents.iter().map(|color| color[axis]).collect();
        Plane { width, height, values, repeat: true }
    };
    let blurred = [0, 1, 2].map(|axis| blur(&plane(axis), &SENSITIVITY[axis]));
    let color = |at: usize| perceived([0, 1, 2].map(|axis| blurred[axis].values[at]));
    // Brightness from 0 to 1.
    let mut brightness = plane(0);
    brightness.values.iter_mut().for_each(|value| *value = (*value + 16.0) / 116.0);
    Seen { size: (width, height), colors: (0..opponents.len()).map(color).collect(), features: features(&brightness) }
}

/// The blur of one axis; its weights sum to 1.
fn blur(plane: &Plane, sensitivity: &[(f64, f64); 2]) -> Plane {
    let widest = SENSITIVITY.iter().flatten().map(|part| part.1).fold(0.0, f64::max);
    let radius = (3.0 * (widest / (2.0 * PI * PI)).sqrt() * PIXELS_A_DEGREE).ceil() as i32;
    let mut sum = Plane { values: vec![0.0; plane.values.len()], ..*plane };
    let mut total = 0.0;
    for &(weight, spread) in sensitivity.iter().filter(|part| part.0 > 0.0) {
        let place = |step: i32| f64::from(step) / PIXELS_A_DEGREE;
        let row: Vec<f64> = (-radius..=radius).map(|step| exp(-PI * PI * place(step) * place(step) / spread)).collect();
        let height = weight * (PI / spread).sqrt();
        total += height * row.iter().sum::<f64>() * row.iter().sum::<f64>();
        let part = separable(plane, &row, &row);
        sum.values.iter_mut().zip(&part.values).for_each(|(sum, part)| *sum += height * part);
    }
    sum.values.iter_mut().for_each(|value| *value /= total);
    sum
}

/// Strength of edges (first derivative of a Gaussian) and of points (second) around every pixel.
fn features(brightness: &Plane) -> Vec<[f64; 2]> {
    let deviation = 0.5 * FEATURE_WIDTH * PIXELS_A_DEGREE;
    let radius = (3.0 * deviation).ceil() as i32;
    let bell = |step: i32| exp(-f64::from(step * step) / (2.0 * deviation * deviation));
    let weights = |shape: &dyn Fn(f64) -> f64| -> Vec<f64> {
        let raw: Vec<f64> = (-radius..=radius).map(|step| shape(f64::from(step)) * bell(step)).collect();
        // Weights above and below 0 sum to 1 and -1, each for themselves.
        let part = |sign: f64| raw.iter().filter(|&&weight| weight * sign > 0.0).sum::<f64>().abs();
        let (above, below) = (part(1.0), part(-1.0));
        raw.iter()
            .map(|&weight| if weight > 0.0 { weight / above } else { weight / below.max(f64::MIN_POSITIVE) })
            .collect()
    };
    let (edge, point) = (weights(&|x| -x), weights(&|x| x * x / (deviation * deviation) - 1.0));
    let even = weights(&|_| 1.0);
    let both = |shape: &[f64]| (separable(brightness, shape, &even), separable(brightness, &even, shape));
    let (edges, points) = (both(&edge), both(&point));
    let length = |of: &(Plane, Plane), at: usize| of.0.values[at].hypot(of.1.values[at]);
    (0..brightness.values.len()).map(|at| [length(&edges, at), length(&points, at)]).collect()
}

/// Blurred opponent color -> light a display can show -> CIELAB with Hunt's effect.
fn perceived(opponent: [f64; 3]) -> [f64; 3] {
    let light = rgb(of_opponent(opponent)).map(|channel| channel.clamp(0.0, 1.0));
    hunt(lab(xyz(light)))
}

/// Light of sRGB primaries to XYZ.
fn xyz(Rgb { r, g, b }: Rgb) -> [f64; 3] {
    (Mat3::from_cols_array(&SRGB_TO_XYZ) * Vec3::new(r, g, b)).to_array()
}

fn rgb([x, y, z]: [f64; 3]) -> Rgb {
    let of = Mat3::from_cols_array(&SRGB_TO_XYZ).inverse() * Vec3::new(x, y, z);
    Rgb::new(of.x, of.y, of.z)
}

/// Columns: XYZ of red, green and blue.
const SRGB_TO_XYZ: [f64; 9] = [
    10_135_552.0 / 24_577_794.0,
    2_613_072.0 / 12_288_897.0,
    1_425_312.0 / 73_733_382.0,
    8_788_810.0 / 24_577_794.0,
    8_788_810.0 / 12_288_897.0,
    8_788_810.0 / 73_733_382.0,
    4_435_075.0 / 24_577_794.0,
    887_015.0 / 12_288_897.0,
    70_074_185.0 / 73_733_382.0,
];

/// YCxCz: brightness and two color axes, linear in light, so that a blur in it is a blur of light.
fn opponent(xyz: [f64; 3]) -> [f64; 3] {
    let [x, y, z] = [0, 1, 2].map(|axis| xyz[axis] / WHITE[axis]);
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

fn of_opponent([brightness, cx, cz]: [f64; 3]) -> [f64; 3] {
    let y = (brightness + 16.0) / 116.0;
    [(y + cx / 500.0) * WHITE[0], y * WHITE[1], (y - cz / 200.0) * WHITE[2]]
}

fn lab(xyz: [f64; 3]) -> [f64; 3] {
    let delta: f64 = 6.0 / 29.0;
    let root = |t: f64| if t > delta * delta * delta { libm::cbrt(t) } else { t / (3.0 * delta * delta) + 4.0 / 29.0 };
    let [x, y, z] = [0, 1, 2].map(|axis| root(xyz[axis] / WHITE[axis]));
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

/// Colors look stronger where it is bright.
fn hunt([l, a, b]: [f64; 3]) -> [f64; 3] {
    [l, 0.01 * l * a, 0.01 * l * b]
}

/// A distance for large differences: brightness and color added up.
fn hyab(p: [f64; 3], q: [f64; 3]) -> f64 {
    (p[0] - q[0]).abs() + (p[1] - q[1]).hypot(p[2] - q[2])
}

/// The largest difference there is, of green and blue.
fn largest_color_difference() -> f64 {
    let of = |light: Rgb| hunt(lab(xyz(light)));
    pow(hyab(of(Rgb::new(0.0, 1.0, 0.0)), of(Rgb::new(0.0, 0.0, 1.0))), COLOR_EXPONENT)
}

/// A color difference compressed to 0..1: most of the range for differences below the knee.
fn compressed(difference: f64, largest: f64) -> f64 {
    let (powered, knee) = (pow(difference, COLOR_EXPONENT), KNEE * largest);
    if powered < knee { HIGH / knee * powered } else { HIGH + (powered - knee) / (largest - knee) * (1.0 - HIGH) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn even(color: [u8; 3]) -> Picture {
        Picture::filled(24, 24, color)
    }

    #[test]
    fn the_extremes_are_0_and_1() {
        assert!(flip(&even([9, 99, 200]), &even([9, 99, 200])).iter().all(|&error| error == 0.0));
        // Green and blue are as different as colors can be; there is no feature.
        let most = flip(&even([0, 255, 0]), &even([0, 0, 255]));
        assert!(most.iter().all(|&error| (error - 1.0).abs() < 1e-6), "{}", most[0]);
    }

    #[test]
    fn black_and_white_by_hand() {
        // HyAB is 100, 100^0.7 = 25.119. Green is (87.736, -75.610, 72.981), blue (32.298, 25.578, -34.836) with Hunt's effect:
        // 55.438 + hypot(101.188, 107.818) = 203.302, ^0.7 = 41.276, the knee at 16.510; 0.95 + 0.05 * 8.608 / 24.766.
        let found = flip(&even([0; 3]), &even([255; 3]));
        assert!(found.iter().all(|&error| (error - 0.967_379_76).abs() < 1e-6), "{}", found[0]);
    }

    #[test]
    fn a_lost_point_weighs_more_than_its_color() {
        let mut dotted = even([120; 3]);
        dotted.set_pixel(12, 12, [180; 3]);
        let found = flip(&even([120; 3]), &dotted);
        let color_alone = {
            let (a, b) = (see(&even([120; 3])), see(&dotted));
            compressed(hyab(a.colors[12 * 24 + 12], b.colors[12 * 24 + 12]), largest_color_difference())
        };
        assert!(found[12 * 24 + 12] > color_alone && color_alone > 0.01, "{} {color_alone}", found[12 * 24 + 12]);
        // Filters reach 10 pixels.
        assert_eq!(found[12 * 24 + 23], 0.0);
        // It does not matter which of the two is called expected.
        assert_eq!(flip(&dotted, &even([120; 3])), found);
    }

    #[test]
    fn spaces_lead_back() {
        let light = Rgb::new(0.2, 0.5, 0.9);
        let back = rgb(of_opponent(opponent(xyz(light))));
        assert!((back.r - 0.2).abs() + (back.g - 0.5).abs() + (back.b - 0.9).abs() < 1e-12);
        let [l, a, b] = lab(xyz(Rgb::WHITE));
        assert!((l - 100.0).abs() < 1e-6 && a.abs() < 1e-6 && b.abs() < 1e-6);
    }
}
