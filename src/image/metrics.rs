//! Metrics: are two pictures the same, and if not, where and by how much.
//!
//! `Picture` expected, `Picture` actual -> `Comparison` (in words) and a difference picture (to look at)
//!
//! Space: pixels from the top left; differences in 8-bit levels, channel by channel.
//! Cost: one pass over both pictures.

use super::Picture;
use super::picture::luma;
use std::fmt;

/// How much two pictures may differ and still pass. The default is nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tolerance {
    /// A pixel differs when one of its channels differs by more than this, in 8-bit levels.
    pub max_diff: u8,
    /// So many pixels may differ.
    pub max_pixels: usize,
}

impl Tolerance {
    /// Every channel of every pixel must be equal.
    pub const EXACT: Tolerance = Tolerance { max_diff: 0, max_pixels: 0 };
}

/// What a comparison comes to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Equal to the last level.
    Identical,
    /// Not equal, but no more different than the tolerance allows.
    WithinTolerance,
    /// More different than the tolerance allows.
    Different,
    /// The sizes differ, so there are no pixels to compare.
    SizesDiffer,
}

/// One pixel that differs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Difference {
    /// Column, from the left.
    pub x: usize,
    /// Row, from the top.
    pub y: usize,
    /// Red, green and blue that should be there.
    pub expected: [u8; 3],
    /// Red, green and blue that are there.
    pub actual: [u8; 3],
}

/// The smallest box around some pixels; all four sides are inside it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bounds {
    /// First column.
    pub left: usize,
    /// First row.
    pub top: usize,
    /// Last column.
    pub right: usize,
    /// Last row.
    pub bottom: usize,
}

impl Bounds {
    fn around(before: Option<Bounds>, x: usize, y: usize) -> Bounds {
        let Bounds { left, top, right, bottom } = before.unwrap_or(Bounds { left: x, top: y, right: x, bottom: y });
        Bounds { left: left.min(x), top: top.min(y), right: right.max(x), bottom: bottom.max(y) }
    }
}

/// What [`compare`] found. Printed, it is a few plain sentences.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// What it comes to.
    pub verdict: Verdict,
    /// What was allowed.
    pub tolerance: Tolerance,
    /// Width and height of the expected picture.
    pub expected_size: (usize, usize),
    /// Width and height of the actual picture.
    pub actual_size: (usize, usize),
    /// Pixels with a channel that differs by more than `tolerance.max_diff`. 0 when the sizes differ, as below.
    pub different_pixels: usize,
    /// The first such pixel, row by row from the top left.
    pub first: Option<Difference>,
    /// The smallest box around them.
    pub bounds: Option<Bounds>,
    /// Largest difference of a channel over all pixels, in levels.
    pub largest: u8,
    /// Mean absolute difference over all channels of all pixels, in levels.
    pub mean: f64,
}

impl Comparison {
    /// Whether the actual picture passes: identical or within the tolerance.
    #[must_use]
    pub fn passes(&self) -> bool {
        matches!(self.verdict, Verdict::Identical | Verdict::WithinTolerance)
    }
}

/// Compares two pictures pixel by pixel.
#[must_use]
pub fn compare(expected: &Picture, actual: &Picture, tolerance: Tolerance) -> Comparison {
    let mut comparison = Comparison {
        verdict: Verdict::SizesDiffer,
        tolerance,
        expected_size: (expected.width(), expected.height()),
        actual_size: (actual.width(), actual.height()),
        different_pixels: 0,
        first: None,
        bounds: None,
        largest: 0,
        mean: 0.0,
    };
    if comparison.expected_size != comparison.actual_size {
        return comparison;
    }

    // Walk the pixels.
    let mut sum = 0u64;
    for (index, (want, have)) in expected.colors().zip(actual.colors()).enumerate() {
        let differences = channel_differences(want, have);
        sum += differences.iter().map(|&difference| u64::from(difference)).sum::<u64>();
        let largest = differences.into_iter().max().unwrap_or(0);
        comparison.largest = comparison.largest.max(largest);
        if largest > tolerance.max_diff {
            let (x, y) = (index % expected.width(), index / expected.width());
            comparison.different_pixels += 1;
            comparison.first.get_or_insert(Difference { x, y, expected: want, actual: have });
            comparison.bounds = Some(Bounds::around(comparison.bounds, x, y));
        }
    }

    // Judge.
    comparison.mean = sum as f64 / expected.rgb().len().max(1) as f64;
    comparison.verdict = match comparison.different_pixels {
        _ if sum == 0 => Verdict::Identical,
        count if count <= tolerance.max_pixels => Verdict::WithinTolerance,
        _ => Verdict::Different,
    };
    comparison
}

fn channel_differences(a: [u8; 3], b: [u8; 3]) -> [u8; 3] {
    [0, 1, 2].map(|channel| a[channel].abs_diff(b[channel]))
}

impl fmt::Display for Comparison {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (width, height) = self.expected_size;
        match self.verdict {
            Verdict::SizesDiffer => {
                let (actual_width, actual_height) = self.actual_size;
                write!(out, "The sizes differ: expected {width} x {height}, found {actual_width} x {actual_height}.")
            }
            Verdict::Identical => write!(out, "The pictures are identical: {width} x {height}, every pixel equal."),
            Verdict::WithinTolerance => {
                write!(out, "The pictures agree within the tolerance: ")?;
                self.describe(out)
            }
            Verdict::Different => {
                write!(out, "The pictures differ: ")?;
                self.describe(out)
            }
        }
    }
}

impl Comparison {
    fn describe(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let all = self.expected_size.0 * self.expected_size.1;
        let Tolerance { max_diff, max_pixels } = self.tolerance;
        let verb = if self.different_pixels == 1 { "differs" } else { "differ" };
        write!(out, "{} of {all} pixels {verb}", self.different_pixels)?;
        if self.tolerance != Tolerance::EXACT {
            write!(out, " by more than {max_diff} levels, {max_pixels} may")?;
        }
        writeln!(out, ".")?;
        if let Some(Difference { x, y, expected, actual }) = self.first {
            writeln!(out, "The first is x {x}, y {y}: expected {}, found {}.", Color(expected), Color(actual))?;
        }
        if let Some(Bounds { left, top, right, bottom }) = self.bounds {
            writeln!(out, "All lie in x {left} to {right}, y {top} to {bottom}.")?;
        }
        write!(out, "Largest difference {} levels, mean {:.4} levels.", self.largest, self.mean)
    }
}

/// A color as `(r, g, b)`.
struct Color([u8; 3]);

impl fmt::Display for Color {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [red, green, blue] = self.0;
        write!(out, "({red}, {green}, {blue})")
    }
}

/// Where one pixel is: only in one of two pictures of different size.
const ONE_SIDED: [u8; 3] = [255, 0, 255];

/// A picture of the differences: equal pixels as a dim gray shade of themselves, differing ones bright.
///
/// Orange where the actual picture is too bright, blue where it is too dark, brighter for larger differences, never
/// too faint to see. Pixels that only one of the pictures has are magenta, so the result is as large as both together.
#[must_use]
pub fn difference_picture(expected: &Picture, actual: &Picture) -> Picture {
    let width = expected.width().max(actual.width());
    let height = expected.height().max(actual.height());
    let mut difference = Picture::filled(width, height, [0; 3]);
    for y in 0..height {
        for x in 0..width {
            let color = match (expected.pixel_if_inside(x, y), actual.pixel_if_inside(x, y)) {
                (Some(want), Some(have)) => difference_color(want, have),
                (None, None) => [0; 3],
                _ => ONE_SIDED,
            };
            difference.set_pixel(x, y, color);
        }
    }
    difference
}

fn difference_color(want: [u8; 3], have: [u8; 3]) -> [u8; 3] {
    if want == have {
        return [luma(want) / 4; 3];
    }
    let largest = channel_differences(want, have).into_iter().max().unwrap_or(0);
    // From 60 % of full for one level to 100 % for 255, rising fast at the beginning.
    let strength = 0.6 + 0.4 * (f64::from(largest) / 255.0).sqrt();
    let total = |color: [u8; 3]| color.iter().map(|&channel| u32::from(channel)).sum::<u32>();
    let hue = if total(have) >= total(want) { [255.0, 150.0, 0.0] } else { [40.0, 140.0, 255.0] };
    hue.map(|channel: f64| (channel * strength).round() as u8)
}

/// Columns between two pictures that stand side by side.
const SEPARATOR: usize = 2;
/// The color of the separator, and of the room below a picture that is less high than its neighbor.
const SEPARATOR_COLOR: [u8; 3] = [128; 3];

/// The pictures in a row, from left to right, tops aligned, with a thin gray line between them.
///
/// No pictures give a picture of 0 x 0.
#[must_use]
pub fn side_by_side(pictures: &[&Picture]) -> Picture {
    let height = pictures.iter().map(|picture| picture.height()).max().unwrap_or(0);
    let lines = pictures.len().saturating_sub(1) * SEPARATOR;
    let width = pictures.iter().map(|picture| picture.width()).sum::<usize>() + lines;
    let mut row = Picture::filled(width, height, SEPARATOR_COLOR);
    let mut left = 0;
    for picture in pictures {
        for y in 0..picture.height() {
            for x in 0..picture.width() {
                row.set_pixel(left + x, y, picture.pixel(x, y));
            }
        }
        left += picture.width() + SEPARATOR;
    }
    row
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gray_with(changes: &[(usize, usize, [u8; 3])]) -> Picture {
        let mut picture = Picture::filled(8, 6, [100; 3]);
        for &(x, y, color) in changes {
            picture.set_pixel(x, y, color);
        }
        picture
    }

    #[test]
    fn identical_pictures_pass() {
        let comparison = compare(&gray_with(&[]), &gray_with(&[]), Tolerance::EXACT);
        assert_eq!((comparison.verdict, comparison.passes()), (Verdict::Identical, true));
        assert_eq!(comparison.to_string(), "The pictures are identical: 8 x 6, every pixel equal.");
    }

    #[test]
    fn differences_are_counted_placed_and_measured() {
        let actual = gray_with(&[(5, 1, [100, 103, 100]), (2, 4, [100, 100, 60]), (3, 3, [101, 100, 100])]);
        let comparison = compare(&gray_with(&[]), &actual, Tolerance { max_diff: 1, max_pixels: 1 });
        assert_eq!(comparison.verdict, Verdict::Different);
        assert_eq!(comparison.different_pixels, 2);
        assert_eq!(comparison.bounds, Some(Bounds { left: 2, top: 1, right: 5, bottom: 4 }));
        assert_eq!(comparison.largest, 40);
        assert_eq!(comparison.mean, 44.0 / (8.0 * 6.0 * 3.0));
        assert_eq!(
            comparison.to_string(),
            "The pictures differ: 2 of 48 pixels differ by more than 1 levels, 1 may.\n\
             The first is x 5, y 1: expected (100, 100, 100), found (100, 103, 100).\n\
             All lie in x 2 to 5, y 1 to 4.\n\
             Largest difference 40 levels, mean 0.3056 levels."
        );
    }

    #[test]
    fn the_tolerance_holds_at_its_limits() {
        let actual = gray_with(&[(0, 0, [103, 100, 100]), (1, 0, [100, 100, 97])]);
        let verdict =
            |max_diff, max_pixels| compare(&gray_with(&[]), &actual, Tolerance { max_diff, max_pixels }).verdict;
        assert_eq!(verdict(3, 0), Verdict::WithinTolerance);
        assert_eq!(verdict(2, 0), Verdict::Different);
        assert_eq!(verdict(2, 1), Verdict::Different);
        assert_eq!(verdict(2, 2), Verdict::WithinTolerance);
    }

    #[test]
    fn other_sizes_are_a_verdict_of_their_own() {
        let huge = Tolerance { max_diff: 255, max_pixels: usize::MAX };
        let comparison = compare(&gray_with(&[]), &Picture::filled(6, 8, [100; 3]), huge);
        assert_eq!((comparison.verdict, comparison.passes()), (Verdict::SizesDiffer, false));
        assert_eq!(comparison.to_string(), "The sizes differ: expected 8 x 6, found 6 x 8.");
    }

    #[test]
    fn the_difference_picture_dims_what_is_equal_and_shows_a_single_level() {
        let actual = gray_with(&[(1, 1, [101, 100, 100]), (2, 2, [0; 3])]);
        let difference = difference_picture(&gray_with(&[]), &actual);
        assert_eq!(difference.pixel(0, 0), [25; 3]);
        let [bright, dark] = [difference.pixel(1, 1), difference.pixel(2, 2)];
        assert!(bright[0] > 150 && bright[2] == 0, "{bright:?}");
        assert!(dark[2] > 200 && dark[0] < 60, "{dark:?}");
        let larger = difference_picture(&gray_with(&[]), &Picture::filled(2, 9, [100; 3]));
        assert_eq!((larger.width(), larger.height()), (8, 9));
        assert_eq!([larger.pixel(0, 8), larger.pixel(7, 0), larger.pixel(7, 8)], [ONE_SIDED, ONE_SIDED, [0; 3]]);
    }

    #[test]
    fn pictures_stand_in_a_row() {
        let row = side_by_side(&[&Picture::filled(2, 3, [1; 3]), &Picture::filled(1, 1, [2; 3])]);
        assert_eq!((row.width(), row.height()), (2 + SEPARATOR + 1, 3));
        assert_eq!([row.pixel(1, 2), row.pixel(2, 0), row.pixel(4, 0)], [[1; 3], SEPARATOR_COLOR, [2; 3]]);
        assert_eq!(row.pixel(4, 1), SEPARATOR_COLOR);
        assert_eq!(side_by_side(&[]).rgb(), [0u8; 0]);
    }
}
