//! SSIM: how much of the structure of one picture is in another, 1 where they are equal.
//!
//! `Picture` expected, `Picture` actual -> one number
//!
//! Brightness, contrast and correlation are compared within a Gaussian window around every pixel, and averaged. The weights of
//! a window sum to 1: sums that are not divided (a known library forgets it) make noise of one level look like a
//! different picture, 0.415 instead of 0.978. At the border the part of the window inside the picture counts.
//!
//! Space: brightness (ITU-R BT.709 weights) of 8-bit display values.
//! Source: Wang, Bovik, Sheikh, Simoncelli, "Image Quality Assessment: From Error Visibility to Structural Similarity", IEEE
//! Transactions on Image Processing 13(4), 2004, 600-612. Cost: 5 blurs of 22 products a pixel.

use super::Picture;
use super::planes::{Plane, gaussian, separable};

/// Half the 11 x 11 window, and the deviation of its Gaussian, in pixels.
const RADIUS: usize = 5;
const DEVIATION: f64 = 1.5;
/// The constants that keep quotients of dark and of even windows in bounds: (0.01 L)^2 and (0.03 L)^2 of L = 255 levels.
const OF_MEANS: f64 = 2.55 * 2.55;
const OF_VARIANCES: f64 = 7.65 * 7.65;

/// The mean structural similarity of two pictures of one size, at most 1; of pictures without pixels, 1.
///
/// # Panics
/// When the sizes differ.
#[must_use]
pub fn ssim(expected: &Picture, actual: &Picture) -> f64 {
    assert_eq!((expected.width(), expected.height()), (actual.width(), actual.height()), "pictures of one size");
    let [a, b] = [expected, actual].map(brightness);
    let window = gaussian(RADIUS, DEVIATION);
    let mean = |of: Plane| separable(&of, &window, &window);
    let (mean_a, mean_b) = (mean(a.clone()), mean(b.clone()));
    let (square_a, square_b, product) = (mean(a.times(&a)), mean(b.times(&b)), mean(a.times(&b)));
    let weight = mean(Plane { values: vec![1.0; a.values.len()], ..a });
    let similarity = |at: usize| {
        let of = |plane: &Plane| plane.values[at] / weight.values[at];
        let (a, b) = (of(&mean_a), of(&mean_b));
        let (variance_a, variance_b) = (of(&square_a) - a * a, of(&square_b) - b * b);
        let covariance = of(&product) - a * b;
        (2.0 * a * b + OF_MEANS) * (2.0 * covariance + OF_VARIANCES)
            / ((a * a + b * b + OF_MEANS) * (variance_a + variance_b + OF_VARIANCES))
    };
    let count = mean_a.values.len();
    if count == 0 { 1.0 } else { (0..count).map(similarity).sum::<f64>() / count as f64 }
}

fn brightness(picture: &Picture) -> Plane {
    let of = |[r, g, b]: [u8; 3]| 0.2126 * f64::from(r) + 0.7152 * f64::from(g) + 0.0722 * f64::from(b);
    Plane {
        width: picture.width(),
        height: picture.height(),
        values: picture.colors().map(of).collect(),
        repeat: false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gray(side: usize, level: impl Fn(usize, usize) -> u8) -> Picture {
        let mut picture = Picture::filled(side, side, [0; 3]);
        (0..side * side).for_each(|at| picture.set_pixel(at % side, at / side, [level(at % side, at / side); 3]));
        picture
    }

    #[test]
    fn noise_of_one_level_is_little() {
        // Each picture is 128 + (-1, 0 or 1): variance 2/3, no correlation. 58.5225 / (58.5225 + 4/3) = 0.97772.
        let mut state = 1_u64;
        let mut noise = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (127 + (state >> 33) % 3) as u8
        };
        let levels: Vec<u8> = (0..2 * 128 * 128).map(|_| noise()).collect();
        let [a, b] = [0, 128 * 128].map(|from| gray(128, |x, y| levels[from + y * 128 + x]));
        assert!((ssim(&a, &b) - 0.978).abs() < 0.002, "{}", ssim(&a, &b));
        assert_eq!(ssim(&a, &a), 1.0);
    }

    #[test]
    fn even_pictures_differ_by_their_brightness_alone() {
        let expected = (2.0 * 100.0 * 50.0 + 6.5025) / (100.0 * 100.0 + 50.0 * 50.0 + 6.5025);
        assert!((ssim(&gray(16, |_, _| 100), &gray(16, |_, _| 50)) - expected).abs() < 1e-9);
        // Smaller than the window.
        assert!((ssim(&gray(3, |_, _| 100), &gray(3, |_, _| 50)) - expected).abs() < 1e-9);
        assert_eq!(ssim(&gray(0, |_, _| 0), &gray(0, |_, _| 0)), 1.0);
    }

    #[test]
    fn the_negative_has_the_opposite_structure() {
        let board = gray(64, |x, y| if (x / 4 + y / 4) % 2 == 0 { 255 } else { 0 });
        let negative = gray(64, |x, y| if (x / 4 + y / 4) % 2 == 0 { 0 } else { 255 });
        assert!(ssim(&board, &negative) < -0.8);
    }
}
