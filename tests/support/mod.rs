//! What several tests share: an independent coverage test, shapes, scenes built by hand, pictures in ASCII.

#![allow(dead_code, reason = "every test binary uses a part")]

pub mod built_in;
pub mod census;
pub mod cut;
pub mod half_planes;
pub mod mixed;
pub mod owners;
pub mod random;
pub mod scenes;
pub mod shapes;
pub mod sipp_like;
pub mod tally;

use farop::color::Rgb;
use farop::image::Image;
use farop::plan::Transparency;
use farop::raster::{Frame, PutCounts, Rasterizer, ZBuffer};
use farop::screen::DrawList;

/// A polygon for [`assert_coverage`]: the digit it shows, and its corners in samples.
pub struct Flat {
    digit: u8,
    corners: Vec<(f64, f64)>,
}

/// A polygon that shows `digit`, 1 to 9.
pub fn polygon(digit: u8, corners: &[(f64, f64)]) -> Flat {
    Flat { digit, corners: corners.to_vec() }
}

/// Draws `list` over black, as one target of all rows.
pub fn draw(list: &DrawList, rasterizer: &dyn Rasterizer) -> (Image, PutCounts) {
    draw_over(list, rasterizer, Rgb::gray(0.0), Transparency::Over)
}

/// Draws `list` over `background`.
pub fn draw_over(
    list: &DrawList,
    rasterizer: &dyn Rasterizer,
    background: Rgb<f32>,
    rule: Transparency,
) -> (Image, PutCounts) {
    let mut frame = Frame::default();
    let mut target = frame.target((list.width, list.height), 0..list.height, background, rule);
    rasterizer.draw(list, &mut target);
    let counts = target.finish();
    (frame.image(list.width, 0..list.height), counts)
}

/// The digits of a picture whose gray is digit / 16, a point for black.
pub fn digits(image: &Image) -> String {
    let digit = |light: &Rgb<f32>| match (light.r * 16.0).round() as u32 {
        0 => '.',
        digit => char::from_digit(digit, 36).unwrap_or('?'),
    };
    let rows =
        (0..image.height()).map(|y| image.row(y).iter().map(digit).map(String::from).collect::<Vec<_>>().join(" "));
    rows.collect::<Vec<_>>().join("\n")
}

/// Checks that the z-buffer draws `polygons` as in `picture`; no sample is put twice.
pub fn assert_coverage(polygons: &[Flat], picture: &str) {
    let expected: Vec<&str> = picture.lines().map(str::trim).filter(|line| !line.is_empty()).collect();
    let width = expected.first().map_or(0, |line| line.split_whitespace().count()) as u32;
    let mut list = DrawList::new(width, expected.len() as u32);
    for (index, polygon) in polygons.iter().enumerate() {
        // Each a little nearer than the one before, so that a sample drawn twice shows in the overdraw.
        list.push_flat(&polygon.corners, 1.0 + index as f64 / 64.0, [f64::from(polygon.digit) / 16.0; 3]);
    }
    let (image, counts) = draw(&list, &ZBuffer);
    let drawn = digits(&image);
    assert_eq!(drawn, expected.join("\n"), "drawn (left), expected (right):\n{drawn}");
    assert_eq!((counts.overdraw, counts.stray_writes), (0, 0), "drawn twice or outside:\n{drawn}");
}
