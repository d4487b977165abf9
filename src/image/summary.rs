//! Summary: a picture in twenty lines of text, for reviews and logs where pictures cannot be shown.
//!
//! `Picture` -> text -> `.snap` file (`snapshot`)
//!
//! The hash tells whether anything changed, the numbers and the thumbnail tell roughly what.

use super::Picture;
use super::terminal::ascii;

/// Size of the thumbnail in characters; a cell is about twice as high as wide.
const THUMBNAIL: (usize, usize) = (32, 16);

/// The picture in text: size, hash, mean of each channel, covered pixels and an ASCII thumbnail.
///
/// Covered are the pixels unlike the top left one, which usually shows the background.
#[must_use]
pub fn summary(picture: &Picture) -> String {
    let (width, height) = (picture.width(), picture.height());
    let [red, green, blue] = channel_means(picture);
    let background = picture.pixel_if_inside(0, 0);
    let covered = picture.colors().filter(|&color| Some(color) != background).count();
    let mut text = format!(
        "size: {width} x {height}\n\
         hash: {:016x}\n\
         mean: {red:.3} {green:.3} {blue:.3}\n\
         covered: {covered} of {} pixels\n",
        hash(picture),
        width * height,
    );

    // Frame the thumbnail, so that no editor strips blanks from the ends of its lines.
    let (columns, rows) = THUMBNAIL;
    let rule = format!("+{}+\n", "-".repeat(columns));
    text.push_str(&rule);
    for line in ascii(picture, columns, rows).lines() {
        text.push_str(&format!("|{line}|\n"));
    }
    text.push_str(&rule);
    text
}

/// FNV-1a, 64 bits, of width, height (8 bytes each, low byte first) and the colors.
///
/// It tells accidents apart, not forgeries. Source: G. Fowler, L. C. Noll, P. Vo, 1991 (draft-eastlake-fnv).
#[must_use]
pub fn hash(picture: &Picture) -> u64 {
    let sides = [picture.width() as u64, picture.height() as u64];
    fnv_1a(sides.into_iter().flat_map(u64::to_le_bytes).chain(picture.rgb().iter().copied()))
}

fn fnv_1a(bytes: impl Iterator<Item = u8>) -> u64 {
    bytes.fold(0xCBF2_9CE4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01B3))
}

fn channel_means(picture: &Picture) -> [f64; 3] {
    let mut sums = [0u64; 3];
    for color in picture.colors() {
        sums = [0, 1, 2].map(|channel| sums[channel] + u64::from(color[channel]));
    }
    let count = (picture.rgb().len() / 3).max(1) as f64;
    sums.map(|sum| sum as f64 / count)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hash_is_the_published_one() {
        assert_eq!(fnv_1a(b"".iter().copied()), 0xCBF2_9CE4_8422_2325);
        assert_eq!(fnv_1a(b"a".iter().copied()), 0xAF63_DC4C_8601_EC8C);
        assert_eq!(fnv_1a(b"foobar".iter().copied()), 0x8594_4171_F739_67E8);
    }

    #[test]
    fn the_hash_sees_shape_and_every_level() {
        let wide = Picture::filled(4, 2, [7; 3]);
        assert_ne!(hash(&wide), hash(&Picture::filled(2, 4, [7; 3])));
        let mut changed = wide.clone();
        changed.set_pixel(3, 1, [7, 7, 8]);
        assert_ne!(hash(&wide), hash(&changed));
    }

    #[test]
    fn the_text_shows_size_means_coverage_and_shape() {
        let mut picture = Picture::filled(32, 32, [0; 3]);
        for (x, y) in (0..32).flat_map(|y| (0..=y).map(move |x| (x, y))).filter(|&(_, y)| y >= 16) {
            picture.set_pixel(x, y, [255, 255, 254]);
        }
        let text = summary(&picture);
        let lines: Vec<_> = text.lines().collect();
        assert_eq!(lines.len(), 4 + 18);
        assert_eq!(lines[0], "size: 32 x 32");
        assert_eq!(lines[2], "mean: 97.617 97.617 97.234");
        assert_eq!(lines[3], "covered: 392 of 1024 pixels");
        assert_eq!(lines[12], format!("|{}|", " ".repeat(32)));
        assert_eq!(lines[20], format!("|{}=|", "@".repeat(31)));
    }
}
