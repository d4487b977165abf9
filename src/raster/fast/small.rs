//! Small: convex polygons whose samples all lie in a square of 8 x 8.
//!
//! outline -SMALL-> which of 64 samples are covered, kept with the plane of depth in one line of the cache -> tile
//!
//! Why apart: in a fine mesh a polygon covers two or three samples. Setting up edges for a tile, asking blocks and fetching corners would
//! cost more than the samples. So coverage is decided once, when the polygon is binned, and half of such polygons end there, as they
//! cover nothing; in the tile there is nothing left to do but to compare depths.
//!
//! Numbers are small, too: corners are at most 2^12 steps from the square's first center, products below 2^25.
//!
//! Space: samples. Cost: some 10 ns to bin, some 10 ns in a tile; 64 bytes.

use super::bins::{BITS, Reach};
use super::cover::{Samples, show};
use super::edges::Outline;
use super::lanes::counting;
use super::layout::LANES;
use crate::screen::lane::{Lane, in_block};
use crate::screen::{BLOCK, Plane};
use fearless_simd::{Select, Simd, SimdBase, SimdMask, f32x8, i32x8, mask32x8};

/// Samples of the square's side: one row is one step.
const SIDE: i32 = LANES as i32;

/// A small polygon, made ready: all that a tile needs of it.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(super) struct Small {
    /// The plane of its depth.
    plane: [f64; 3],
    range: [f32; 2],
    /// The covered samples, 8 bits a row from the top, the leftmost lowest.
    covered: u64,
    /// The square's first sample.
    left: i32,
    top: i32,
    /// Its place in the list.
    polygon: u32,
    transparent: bool,
    /// Its surface has holes.
    cut_out: bool,
}

/// Whether a box of samples is one for this room.
#[inline(always)]
pub(super) fn is_small([columns, rows]: Reach) -> bool {
    columns[1] - columns[0] <= SIDE && rows[1] - rows[0] <= SIDE
}

/// Which samples of the square at the upper left of `reach` an outline covers, which lies within `reach` and was made ready: 8 bits a row.
#[inline(always)]
pub(super) fn covered<S: Simd>(simd: S, outline: &Outline, [columns, rows]: Reach) -> u64 {
    let corners = outline.corners();
    let Some(&last) = corners.last() else { return 0 };
    let half = 1 << (BITS - 1);
    let center = [(columns[0] << BITS) + half, (rows[0] << BITS) + half];
    let numbers = i32x8::from_slice(simd, &[0, 1, 2, 3, 4, 5, 6, 7]);
    let mut outside = [i32x8::splat(simd, 0); SIDE as usize];
    let mut from = last;
    for &to in corners {
        // As edges of tiles are made, in 32 bits.
        let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
        let value = dx * (center[1] - from[1]) - dy * (center[0] - from[0]);
        let keeps_centers = dy < 0 || (dy == 0 && dx > 0);
        let start = (value - i32::from(!keeps_centers)) >> BITS;
        let down = i32x8::splat(simd, dx);
        let mut along = numbers * i32x8::splat(simd, -dy) + i32x8::splat(simd, start);
        let mut row = 0;
        while row < SIDE as usize {
            outside[row] |= along;
            along += down;
            row += 1;
        }
        from = to;
    }
    let mut covered = 0;
    let mut row = 0;
    while row < SIDE as usize {
        covered |= outside[row].simd_ge(i32x8::splat(simd, 0)).to_bitmask() << (8 * row);
        row += 1;
    }
    covered
}

impl Small {
    #[inline(always)]
    pub fn new(
        plane: &Plane,
        covered: u64,
        [columns, rows]: Reach,
        (polygon, transparent, cut_out): (u32, bool, bool),
    ) -> Small {
        let range = [plane.low as f32, plane.high as f32];
        let plane = [plane.a, plane.b, plane.c];
        Small { plane, range, covered, left: columns[0], top: rows[0], polygon, transparent, cut_out }
    }

    /// Draws what lies in the tile.
    #[inline(always)]
    pub fn draw<S: Simd>(&self, simd: S, samples: &mut Samples<'_>) {
        let first = samples.veils.len();
        self.draw_lanes(simd, samples);
        if self.cut_out {
            samples.settle(self.polygon, self.transparent, first);
        }
    }

    #[inline(always)]
    fn draw_lanes<S: Simd>(&self, simd: S, samples: &mut Samples<'_>) {
        let apart = self.transparent || self.cut_out;
        let (mut rest, left) = self.cut(samples);
        let (a, b) = (f32x8::splat(simd, self.plane[0] as f32), f32x8::splat(simd, self.plane[1] as f32));
        let (low, high) = (f32x8::splat(simd, self.range[0]), f32x8::splat(simd, self.range[1]));
        // A row lies in one block or in two.
        let block_x = left & !(BLOCK - 1);
        let from_block = counting(simd) + f32x8::splat(simd, (left - block_x) as f32);
        let side = f32x8::splat(simd, BLOCK as f32);
        let in_second = from_block.simd_ge(side);
        let dx = in_second.select(from_block - side, from_block);
        let mut block_y = i32::MIN;
        let mut anchor = f32x8::splat(simd, 0.0);
        while rest != 0 {
            let row = rest.trailing_zeros() as i32 / SIDE;
            let lanes = rest >> (SIDE * row) & 0xFF;
            rest &= !(0xFF << (SIDE * row));
            let y = self.top + row;
            if block_y != y & !(BLOCK - 1) {
                block_y = y & !(BLOCK - 1);
                let first = f32x8::splat(simd, self.anchor(block_x, block_y));
                let second = f32x8::splat(simd, self.anchor(block_x + BLOCK, block_y));
                anchor = in_second.select(second, first);
            }
            let dy = f32x8::splat(simd, (y - block_y) as f32);
            let depth = in_block(anchor, [a, b], [dx, dy]).hold(low, high);
            let (column, line) = (left - samples.area.columns.start, y - samples.area.rows.start);
            let index = line as usize * samples.stride + column as usize;
            let inside = mask32x8::from_bitmask(simd, lanes);
            show(simd, samples, index, (depth, inside), (self.polygon, apart));
        }
    }

    /// The covered samples in the tile, and the column of the first of each row.
    #[inline(always)]
    fn cut(&self, samples: &Samples<'_>) -> (u64, i32) {
        /// The first bit of every row.
        const ROWS: u64 = 0x0101_0101_0101_0101;
        let (columns, rows) = (&samples.area.columns, &samples.area.rows);
        let (mut covered, mut left) = (self.covered, self.left);
        let beyond = left + SIDE - columns.end;
        if beyond > 0 {
            covered &= ROWS * (0xFF >> beyond.min(SIDE));
        }
        if left < columns.start {
            let before = (columns.start - left).min(SIDE);
            covered = (covered & (ROWS * ((0xFF << before) & 0xFF))) >> before;
            left = columns.start;
        }
        let above = (rows.start - self.top).clamp(0, SIDE);
        let below = (self.top + SIDE - rows.end).clamp(0, SIDE);
        if above > 0 {
            covered &= u64::MAX.checked_shl((SIDE * above) as u32).unwrap_or(0);
        }
        if below > 0 {
            covered &= u64::MAX.checked_shr((SIDE * below) as u32).unwrap_or(0);
        }
        (covered, left)
    }

    /// [`Plane::anchor`].
    #[inline(always)]
    fn anchor(&self, x: i32, y: i32) -> f32 {
        let [a, b, c] = self.plane;
        (a * (f64::from(x) + 0.5) + b * (f64::from(y) + 0.5) + c) as f32
    }
}
