//! Pictures of a grade: what was drawn, what is right, where they differ, and how many faces lie over each sample.
//!
//! Shot -PICTURES-> small pictures, a pixel a pixel; enlarged for readers that cannot do that themselves
//!
//! Nothing is judged here: which pixels are wrong stands in the shot.

use super::case::Case;
use super::paint::paint;
use super::rules::Rules;
use super::verdict::Shot;
use crate::image::{Picture, encode_for};
use crate::plan::Accepts;
use crate::raster::coverage::Spans;
use std::path::Path;

/// A wrong pixel.
pub const WRONG: [u8; 3] = [0xE0, 0x2F, 0x44];
/// How many faces lie over a sample: none, one, two and so on, the last for six and more. Told apart in gray, too.
pub const HEAT: [[u8; 3]; 7] = [
    [0x10, 0x18, 0x30],
    [0x2B, 0x4C, 0x8C],
    [0x2A, 0x82, 0x86],
    [0x5E, 0xAF, 0x5B],
    [0xC9, 0xC2, 0x4A],
    [0xF2, 0xA9, 0x5C],
    [0xFF, 0xF3, 0xE0],
];

/// The picture that is right; of levels that may be one of two, the lower.
#[must_use]
pub fn right(case: &Case) -> Picture {
    let painted = paint(case, &Rules::default());
    of_pixels((painted.width, painted.height), |at| painted.low[at])
}

/// Where a picture is wrong: red on what is right, paled.
#[must_use]
pub fn difference(shot: &Shot) -> Picture {
    let right = right(&shot.case);
    let pale = |[r, g, b]: [u8; 3]| {
        let gray = (2 * u32::from(r) + 5 * u32::from(g) + u32::from(b)) / 8;
        [(0xB8 + gray / 4) as u8; 3]
    };
    let mut is_wrong = vec![false; right.width() * right.height()];
    shot.wrong.iter().for_each(|&at| is_wrong[at] = true);
    let colors: Vec<_> = right.colors().collect();
    of_pixels((right.width(), right.height()), |at| if is_wrong[at] { WRONG } else { pale(colors[at]) })
}

/// How many faces lie over each sample, in rows from the top.
#[must_use]
pub fn overdraw(case: &Case) -> Vec<u32> {
    let list = case.list(Accepts::AnyPolygon);
    let (width, height) = (list.width as i32, list.height as i32);
    let mut covering = vec![0; (width * height) as usize];
    if case.lines {
        return covering;
    }
    let mut spans = Spans::within(0..width);
    for polygon in list.polygons() {
        spans.of(polygon.vertices(), list.grid, 0..height, |row, columns| {
            for column in columns {
                covering[(row * width + column) as usize] += 1;
            }
        });
    }
    covering
}

/// [`overdraw`] in colors, a sample a pixel.
#[must_use]
pub fn overdraw_map(case: &Case) -> Picture {
    let covering = overdraw(case);
    let heat = |at: usize| HEAT[(covering[at] as usize).min(HEAT.len() - 1)];
    of_pixels((case.width as usize, case.height as usize), heat)
}

/// What was drawn, what is right, and the difference, side by side and large; `None` where nothing was drawn.
#[must_use]
pub fn triptych(shot: &Shot) -> Option<Picture> {
    let drawn = shot.picture()?;
    let parts = [drawn.clone(), right(&shot.case), difference(shot)];
    let (width, height) = (drawn.width(), drawn.height());
    let scale = (128 / width.max(height)).max(1);
    let gap = 4;
    let mut whole = Picture::filled(3 * width * scale + 2 * gap, height * scale, [0xFF; 3]);
    for (number, part) in parts.iter().enumerate() {
        let left = number * (width * scale + gap);
        for y in 0..height * scale {
            for x in 0..width * scale {
                whole.set_pixel(left + x, y, part.pixel(x / scale, y / scale));
            }
        }
    }
    Some(whole)
}

/// The bytes of a PNG file.
#[must_use]
pub fn png(picture: &Picture) -> Vec<u8> {
    // A picture in memory has a size that a PNG can have.
    encode_for(Path::new("picture.png"), picture).unwrap_or_default()
}

fn of_pixels((width, height): (usize, usize), color: impl Fn(usize) -> [u8; 3]) -> Picture {
    let mut picture = Picture::filled(width, height, [0; 3]);
    for y in 0..height {
        for x in 0..width {
            picture.set_pixel(x, y, color(y * width + x));
        }
    }
    picture
}
