//! Terminal: a picture made of characters, for a look without leaving the command line.
//!
//! `Picture` -> shrink -> text
//!
//! A character cell is about twice as high as wide. In color the upper half block gives each cell two square pixels:
//! its ink is the upper one, its background the lower one. Without color, a ramp of ten characters, dark to bright.
//!
//! Space: display values. Shrinking averages them as they are: a thumbnail is for the eye, and whole numbers keep
//! it equal on every machine.

use super::Picture;
use super::picture::luma;
use std::fmt::Write;

/// From no light to full.
const RAMP: &[u8; 10] = b" .:-=+*#%@";

/// The picture as lines of text, at most `columns` characters wide and never enlarged; every line ends in a newline.
///
/// With `color`, half blocks in 24-bit color (ANSI escapes, reset at the end of every line); without, plain ASCII.
/// No columns, or a picture without pixels, give an empty text.
#[must_use]
pub fn half_blocks(picture: &Picture, columns: usize, color: bool) -> String {
    let columns = columns.min(picture.width());
    if columns == 0 || picture.height() == 0 {
        return String::new();
    }
    let in_proportion = |halves: usize| {
        let (width, height) = (picture.width() as u64 * halves as u64, picture.height() as u64 * columns as u64);
        (((height + width / 2) / width) as usize).max(1)
    };
    if color {
        color_text(&shrink(picture, columns, in_proportion(1)))
    } else {
        ascii(picture, columns, in_proportion(2))
    }
}

/// The picture as `rows` lines of `columns` ASCII characters, dark to bright; a smaller picture is enlarged.
#[must_use]
pub fn ascii(picture: &Picture, columns: usize, rows: usize) -> String {
    if columns == 0 || picture.rgb().is_empty() {
        return String::new();
    }
    let small = shrink(picture, columns, rows);
    let mut text = String::with_capacity((columns + 1) * rows);
    for (index, color) in small.colors().enumerate() {
        let step = usize::from(luma(color)) * RAMP.len() / 256;
        text.push(char::from(RAMP[step]));
        if (index + 1) % columns == 0 {
            text.push('\n');
        }
    }
    text
}

fn color_text(small: &Picture) -> String {
    let mut text = String::new();
    for upper in (0..small.height()).step_by(2) {
        // A color that does not change is not said again.
        let (mut ink, mut ground) = (None, None);
        for x in 0..small.width() {
            let above = small.pixel(x, upper);
            if ink.replace(above) != Some(above) {
                push_color(&mut text, 38, above);
            }
            // Below an odd last row the terminal's own background shows.
            if let Some(below) = small.pixel_if_inside(x, upper + 1)
                && ground.replace(below) != Some(below)
            {
                push_color(&mut text, 48, below);
            }
            text.push('▀');
        }
        text.push_str("\x1b[0m\n");
    }
    text
}

fn push_color(text: &mut String, layer: u8, [red, green, blue]: [u8; 3]) {
    write!(text, "\x1b[{layer};2;{red};{green};{blue}m").expect("a String takes everything");
}

/// The mean of the box of pixels under each of `columns` x `rows` pixels; boxes are at least one pixel large.
fn shrink(picture: &Picture, columns: usize, rows: usize) -> Picture {
    let mut small = Picture::filled(columns, rows, [0; 3]);
    for y in 0..rows {
        let (top, bottom) = box_of(y, rows, picture.height());
        for x in 0..columns {
            let (left, right) = box_of(x, columns, picture.width());
            let mut sum = [0u64; 3];
            for (row, column) in (top..bottom).flat_map(|row| (left..right).map(move |column| (row, column))) {
                let color = picture.pixel(column, row);
                sum = [0, 1, 2].map(|channel| sum[channel] + u64::from(color[channel]));
            }
            let count = ((bottom - top) * (right - left)) as u64;
            small.set_pixel(x, y, sum.map(|total| ((total + count / 2) / count) as u8));
        }
    }
    small
}

/// The pixels `from..to` of `length` that belong to step `index` of `steps`.
fn box_of(index: usize, steps: usize, length: usize) -> (usize, usize) {
    let from = index * length / steps;
    (from, ((index + 1) * length / steps).max(from + 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_pixels_share_a_cell() {
        let mut picture = Picture::filled(2, 3, [9, 9, 9]);
        picture.set_pixel(0, 0, [255, 0, 0]);
        picture.set_pixel(0, 1, [0, 0, 255]);
        let text = half_blocks(&picture, 80, true);
        assert_eq!(
            text,
            "\x1b[38;2;255;0;0m\x1b[48;2;0;0;255m▀\x1b[38;2;9;9;9m\x1b[48;2;9;9;9m▀\x1b[0m\n\x1b[38;2;9;9;9m▀▀\x1b[0m\n"
        );
    }

    #[test]
    fn large_pictures_shrink_in_proportion() {
        let picture = Picture::filled(300, 200, [80; 3]);
        let plain = half_blocks(&picture, 60, false);
        assert_eq!((plain.lines().count(), plain.lines().next().map(str::len)), (20, Some(60)));
        let color = half_blocks(&picture, 60, true);
        assert_eq!((color.lines().count(), color.matches('▀').count()), (20, 20 * 60));
        assert_eq!(half_blocks(&Picture::filled(1000, 1, [0; 3]), 10, false), "          \n");
        assert_eq!(half_blocks(&picture, 0, true), "");
    }

    #[test]
    fn the_ramp_goes_from_dark_to_bright() {
        let rgb = (0..=255u8).flat_map(|level| [level; 3]).collect();
        let picture = Picture::from_rgb(256, 1, rgb).expect("256 pixels");
        assert_eq!(ascii(&picture, 10, 1), " .:-=+*#%@\n");
    }

    #[test]
    fn small_pictures_are_enlarged_and_large_ones_averaged() {
        let mut picture = Picture::filled(2, 2, [0; 3]);
        picture.set_pixel(1, 0, [255; 3]);
        assert_eq!(ascii(&picture, 4, 2), "  @@\n    \n");
        assert_eq!(shrink(&picture, 1, 1).pixel(0, 0), [64; 3]);
    }
}
