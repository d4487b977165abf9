//! Kinds about where and how large: offsets, sizes, numbers of things.

use super::outlines::{Pen, filled};
use super::{Kind, Step, push};
use crate::screen::DrawList;

/// Width and height of a picture.
type Size = (u32, u32);

/// The largest side of a picture: 2^14.
const LARGEST: u32 = 14;

const fn kind(name: &'static str, draws: &'static str, steps: fn() -> Vec<Step>) -> Kind {
    Kind { name, draws, is_about_depth: false, has_polygons: false, steps }
}

pub(super) const KINDS: &[Kind] = &[
    kind("empty list", "no polygon at all", || {
        [(1, 1), (7, 5)].map(|(w, h)| Step { name: format!("{w} x {h}"), list: DrawList::new(w, h) }).to_vec()
    }),
    kind("offset to the right", "small triangles that far from the left side", || {
        powers(4..=LARGEST, |side| small((side + 64, 12), (side, 0)))
    }),
    kind("offset down", "small triangles that far from the upper side", || {
        powers(4..=LARGEST, |side| small((12, side + 64), (0, side)))
    }),
    kind("width", "triangles that wide, 4 samples high", || powers(3..=LARGEST, |side| long((side, 12), Turn::Wide))),
    kind("height", "triangles that high, 4 samples wide", || powers(3..=LARGEST, |side| long((12, side), Turn::High))),
    kind("size", "two triangles on a square picture of that side", || powers(1..=10, square)),
    kind("slivers", "triangles that long, a few 256ths of a sample thick", || powers(5..=LARGEST, sliver)),
    kind("sub-pixel bits", "triangles on a grid of 2^-k samples, some with a center as near an edge as can be", || {
        (0..=16).map(|bits| Step { name: format!("k = {bits}"), list: on_grid(bits) }).collect()
    }),
    kind("1 row", "a picture of N x 1 samples", || powers(0..=LARGEST, |side| strip((side, 1)))),
    kind("1 column", "a picture of 1 x N samples", || powers(0..=LARGEST, |side| strip((1, side)))),
    kind("number of polygons", "that many triangles side by side on 128 x 128 samples", || powers(0..=14, many)),
];

/// A step for each power of two.
pub(super) fn powers(exponents: std::ops::RangeInclusive<u32>, list: impl Fn(u32) -> DrawList) -> Vec<Step> {
    exponents.map(|k| Step { name: format!("2^{k}"), list: list(1 << k) }).collect()
}

/// Eight triangles in cells of 8 x 12 samples (12 x 8 where they stand below each other), from a corner on.
fn small(size: Size, (left, top): Size) -> DrawList {
    let (mut list, mut pen) = (DrawList::new(size.0, size.1), Pen::new(8, u64::from(left + 2 * top)));
    for cell in 0..8 {
        let (x, y) = if top == 0 { (left + 8 * cell, 0) } else { (0, top + 8 * cell) };
        let extent = if top == 0 { (8, 12) } else { (12, 8) };
        let corners = pen.triangle((x, y), extent);
        push(&mut list, &corners, 0.5);
    }
    list
}

enum Turn {
    Wide,
    High,
}

/// Three triangles as long as the picture, side by side.
fn long(size: Size, turn: Turn) -> DrawList {
    let (mut list, mut pen) = (DrawList::new(size.0, size.1), Pen::new(8, u64::from(size.0) * 3 + u64::from(size.1)));
    for band in 0..3 {
        let corners = match turn {
            Turn::Wide => pen.triangle((0, 4 * band), (size.0, 4)),
            Turn::High => pen.triangle((4 * band, 0), (4, size.1)),
        };
        push(&mut list, &corners, 0.5);
    }
    list
}

/// A square in two triangles along a diagonal that passes no center.
fn square(side: u32) -> DrawList {
    let mut list = DrawList::new(side, side);
    let far = f64::from(side);
    let (start, end) = ((3.0 / 256.0, 0.0), (far, far - 2.0 / 256.0));
    push(&mut list, &[start, end, (0.0, far)], 0.5);
    push(&mut list, &[start, (far, 0.0), end], 0.5);
    list
}

fn sliver(length: u32) -> DrawList {
    let mut list = DrawList::new(length, 16);
    let step = 1.0 / 256.0;
    for number in 0..3 {
        let (y, far) = (4.0 + 4.0 * f64::from(number) + step, f64::from(length));
        let thick = step * f64::from(3 + 8 * number);
        push(&mut list, &[(0.0, y), (far, y - 3.0 + step), (far, y - 3.0 + step + thick)], 0.5);
    }
    // So that something shows even where no center is hit.
    push(&mut list, &[(0.25, 0.25), (4.75, 0.25), (0.25, 1.0)], 0.5);
    list
}

fn on_grid(bits: u32) -> DrawList {
    let (mut list, mut pen) = (DrawList::new(96, 16), Pen::new(bits, 77));
    list.grid.bits = bits;
    if bits > 0 {
        for (cell, side) in [(4, 1), (5, -1)] {
            push(&mut list, &pen.near_miss(16 * cell, side), 0.5);
        }
    }
    for cell in 0..4 {
        let corners = pen.triangle((16 * cell, 0), (16, 16));
        push(&mut list, &corners, 0.5);
    }
    list
}

/// Two triangles along a line of samples, with a gap between them and one at the end.
fn strip(size: Size) -> DrawList {
    let mut list = DrawList::new(size.0, size.1);
    let (far, step) = (f64::from(size.0.max(size.1)), 1.0 / 256.0);
    let turn = |corners: [(f64, f64); 3]| if size.1 == 1 { corners } else { corners.map(|(x, y)| (y, x)) };
    // The first covers the first center; the second ends before the last.
    push(&mut list, &turn([(0.0, 0.0), (far / 2.0 + 0.25, 0.375), (0.0, 1.0)]), 0.5);
    if far > 4.0 {
        push(&mut list, &turn([(far / 2.0 + 1.0 + step, 0.25), (far - 1.0 - step, 0.25), (far - 2.0, 0.875)]), 0.5);
    }
    list
}

/// A mesh of that many triangles.
fn many(count: u32) -> DrawList {
    let mut list = DrawList::new(128, 128);
    let cells = count.div_ceil(2);
    let across = 1 << (cells.ilog2().div_ceil(2));
    let down = cells.div_ceil(across).max(1);
    filled(&mut list, (across, down), count as usize);
    list
}
