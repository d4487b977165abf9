//! Cover: draws convex polygons into a tile, eight samples at a time.
//!
//! shapes, EDGES -> depth and owner of samples
//!
//! A polygon's box within the tile is drawn block by block, as planes are anchored at blocks. Eight samples of a row take a step: the
//! signs of the edge functions say which are covered, the plane gives their depth, a comparison says which are nearer.
//!
//! What is nowhere a matter of correctness, only of time: a block that lies outside one edge is left out; edges are not looked at in a
//! block that is inside all of them; a block in which the polygon is nowhere nearer than the farthest that is there is left out. The last
//! uses that rounding keeps order: no depth inside a block is above the largest of those at its four corners, computed in the
//! same way.
//!
//! Space: samples. Cost: see `docs/fast.md`.

use super::bins::{Entry, Kind, MOST_EDGES, Segment, Shape};
use super::edges::Edge;
use super::lanes::counting;
use super::layout::{Area, LANES};
use super::level::Shortcuts;
use super::shown::Shown;
use super::tile::Veil;
use crate::screen::lane::{Lane, in_block};
use crate::screen::{BLOCK, DrawList};
use fearless_simd::{Level, Select, Simd, SimdBase, SimdMask, dispatch, f32x8, i32x8, mask32x8, u32x8};

/// Samples of a step.
pub(super) const STEP: i32 = LANES as i32;
/// Pieces of at least this many samples are first asked for as a whole.
const LARGE: i32 = 64;

/// The samples of a tile.
pub(super) struct Samples<'a> {
    pub area: &'a Area,
    pub stride: usize,
    pub depth: &'a mut [f32],
    pub owner: &'a mut [u32],
    /// Per block, rows of [`blocks_across`]: no sample of the block is farther than this.
    pub far: &'a mut [f32],
    /// Per block, how many samples of surfaces with holes were kept since then.
    pub stale: &'a mut [u16],
    pub veils: &'a mut Vec<Veil>,
    /// Planes of polygons with holes that might show.
    pub shown: &'a mut Shown,
    pub shortcuts: Shortcuts,
    pub list: &'a DrawList,
}

impl Samples<'_> {
    /// Where the bound of the block of sample (x, y) is kept.
    #[inline(always)]
    pub fn far_index(&self, x: i32, y: i32) -> usize {
        let block = |sample: i32, start: i32| (sample / BLOCK - start / BLOCK) as usize;
        block(y, self.area.rows.start) * blocks_across(self.stride) + block(x, self.area.columns.start)
    }
}

/// The most blocks that `samples` samples in a row touch.
pub(super) fn blocks_across(samples: usize) -> usize {
    samples.div_ceil(BLOCK as usize) + 1
}

/// Draws small shapes and those with edges, one after the other.
pub(super) fn draw(level: Level, mut samples: Samples<'_>, segment: &Segment, entries: &[Entry]) {
    dispatch!(level, simd => draw_all(simd, &mut samples, segment, entries));
}

/// Columns of a row that a polygon covers: row, first column, end.
pub(super) type Run = (i32, i32, i32);

/// Draws a polygon whose covered columns were found by other means.
pub(super) fn draw_runs(level: Level, mut samples: Samples<'_>, shape: &Shape, runs: &[Run]) {
    let first = samples.veils.len();
    dispatch!(level, simd => draw_steps(simd, &mut samples, shape, runs));
    if shape.cut_out {
        samples.settle(shape.polygon, shape.transparent, first);
    }
}

#[inline(always)]
fn draw_steps<S: Simd>(simd: S, samples: &mut Samples<'_>, shape: &Shape, runs: &[Run]) {
    let plane = &shape.depth;
    let [a, b] = plane.slope();
    let slope = [f32x8::splat(simd, a), f32x8::splat(simd, b)];
    let (low, high) = (f32x8::splat(simd, plane.low as f32), f32x8::splat(simd, plane.high as f32));
    let numbers = i32x8::from_slice(simd, &[0, 1, 2, 3, 4, 5, 6, 7]);
    for &(y, start, end) in runs {
        let block_y = y & !(BLOCK - 1);
        let dy = f32x8::splat(simd, (y - block_y) as f32);
        let mut x = start & !(STEP - 1);
        while x < end {
            let block_x = x & !(BLOCK - 1);
            let anchor = plane.anchor(block_x, block_y);
            let first = [x - samples.area.columns.start, y - samples.area.rows.start];
            let index = first[1] as usize * samples.stride + first[0] as usize;
            let dx = counting(simd) + f32x8::splat(simd, (x - block_x) as f32);
            let depth = in_block(f32x8::splat(simd, anchor), slope, [dx, dy]).hold(low, high);
            let column = numbers + i32x8::splat(simd, x);
            let inside = column.simd_ge(i32x8::splat(simd, start)) & column.simd_lt(i32x8::splat(simd, end));
            show(simd, samples, index, (depth, inside), (shape.polygon, shape.is_kept_apart()));
            x += STEP;
        }
    }
}

#[inline(always)]
fn draw_all<S: Simd>(simd: S, samples: &mut Samples<'_>, segment: &Segment, entries: &[Entry]) {
    for &entry in entries {
        if entry.kind() == Kind::Small {
            segment.smalls[entry.index()].draw(simd, samples);
            continue;
        }
        let shape = &segment.shapes[entry.index()];
        let (first, before) = (shape.first_corner as usize, samples.veils.len());
        let corners = &segment.corners[first..first + usize::from(shape.corner_count)];
        match corners.len() {
            3 => draw_convex::<S, 3>(simd, samples, shape, corners),
            4 => draw_convex::<S, 4>(simd, samples, shape, corners),
            _ => draw_convex::<S, MOST_EDGES>(simd, samples, shape, corners),
        }
        if shape.cut_out {
            samples.settle(shape.polygon, shape.transparent, before);
        }
    }
}

/// A polygon with up to N edges; missing ones are nowhere outside.
#[inline(always)]
fn draw_convex<S: Simd, const N: usize>(simd: S, samples: &mut Samples<'_>, shape: &Shape, corners: &[[i32; 2]]) {
    let area = samples.area;
    let origin = (area.columns.start, area.rows.start);
    let mut edges = [Edge::default(); N];
    let mut from = corners[corners.len() - 1];
    for (edge, &to) in edges.iter_mut().zip(corners) {
        *edge = Edge::new(from, to, origin);
        from = to;
    }
    // Whole steps; what lies in them beside the box is outside some edge.
    let left = shape.columns[0].max(area.columns.start) & !(STEP - 1);
    let right = shape.columns[1].min(area.columns.end);
    let (top, bottom) = (shape.rows[0].max(area.rows.start), shape.rows[1].min(area.rows.end));
    let mut y = top;
    while y < bottom {
        let y_end = ((y & !(BLOCK - 1)) + BLOCK).min(bottom);
        let mut x = left;
        while x < right {
            let x_end = ((x & !(BLOCK - 1)) + BLOCK).min(right);
            draw_in_block(simd, samples, (shape, &edges), ([x, x_end], [y, y_end]));
            x = x_end;
        }
        y = y_end;
    }
}

/// Columns and rows within one block.
type Piece = ([i32; 2], [i32; 2]);

/// Where a piece of a block lies relative to a polygon's edges.
enum Lies {
    Outside,
    Inside,
    Across,
}

/// The whole steps of a piece, against every edge. Edge functions are linear, so the corners decide.
#[inline(always)]
fn lies<const N: usize>(edges: &[Edge; N], first: [i32; 2], size: [i32; 2]) -> Lies {
    let mut inside = true;
    for edge in edges {
        let value = edge.start + edge.right * first[0] + edge.down * first[1];
        let (right, down) = (edge.right * (size[0] - 1), edge.down * (size[1] - 1));
        if value + right.max(0) + down.max(0) < 0 {
            return Lies::Outside;
        }
        inside &= value + right.min(0) + down.min(0) >= 0;
    }
    if inside { Lies::Inside } else { Lies::Across }
}

#[inline(always)]
fn draw_in_block<S: Simd, const N: usize>(
    simd: S,
    samples: &mut Samples<'_>,
    (shape, edges): (&Shape, &[Edge; N]),
    ([x, x_end], [y, y_end]): Piece,
) {
    let plane = &shape.depth;
    let far = samples.far_index(x, y);
    // No depth is above the polygon's greatest.
    if samples.shortcuts.far && plane.high as f32 <= samples.far[far] {
        return;
    }
    let steps = (x_end - x + STEP - 1) / STEP;
    let size = [steps * STEP, y_end - y];
    let first = [x - samples.area.columns.start, y - samples.area.rows.start];
    let is_large = size[0] * size[1] >= LARGE;
    let lies = if is_large && samples.shortcuts.blocks { lies(edges, first, size) } else { Lies::Across };
    if matches!(lies, Lies::Outside) {
        return;
    }
    let (block_x, block_y) = (x & !(BLOCK - 1), y & !(BLOCK - 1));
    let (anchor, [a, b]) = (plane.anchor(block_x, block_y), plane.slope());
    let range = [plane.low as f32, plane.high as f32];
    if is_large && samples.shortcuts.far {
        // Rounding keeps order: the corner where the plane is greatest has the greatest rounded depth as well.
        let nearest = [nearest_end(a, x - block_x, size[0]), nearest_end(b, y - block_y, size[1])];
        if in_block(anchor, [a, b], nearest).hold(range[0], range[1]) <= samples.far[far] {
            return;
        }
    }
    let rows = Rows { simd, index: first[1] as usize * samples.stride + first[0] as usize, first, size, shape, anchor };
    let is_whole = size == [BLOCK, BLOCK];
    let farthest = match lies {
        Lies::Inside => rows.draw::<0>(samples, &[], (x - block_x, y - block_y)),
        _ => rows.draw(samples, edges, (x - block_x, y - block_y)),
    };
    // What is kept apart leaves what was there, and that is a bound as well.
    if is_whole {
        samples.far[far] = farthest;
    }
}

/// The end of `size` samples from `start` on where a plane with this slope is nearest.
#[inline(always)]
fn nearest_end(slope: f32, start: i32, size: i32) -> f32 {
    if slope > 0.0 { (start + size - 1) as f32 } else { start as f32 }
}

/// Rows of whole steps within one block.
struct Rows<'a, S> {
    simd: S,
    /// Where the first sample is kept.
    index: usize,
    /// The first sample, from the tile's first.
    first: [i32; 2],
    size: [i32; 2],
    shape: &'a Shape,
    /// The plane at the block's first sample.
    anchor: f32,
}

impl<S: Simd> Rows<'_, S> {
    /// Draws all samples that lie inside all `edges`, and returns the farthest depth that is left in the rows.
    #[inline(always)]
    fn draw<const N: usize>(&self, samples: &mut Samples<'_>, edges: &[Edge; N], (dx, dy): (i32, i32)) -> f32 {
        let simd = self.simd;
        let plane = &self.shape.depth;
        let [a, b] = plane.slope();
        let (a, b) = (f32x8::splat(simd, a), f32x8::splat(simd, b));
        let (low, high) = (f32x8::splat(simd, plane.low as f32), f32x8::splat(simd, plane.high as f32));
        let anchor = f32x8::splat(simd, self.anchor);
        let mut farthest = f32x8::splat(simd, f32::INFINITY);
        let mut step = 0;
        while step * STEP < self.size[0] {
            let mut values = self.values(edges, step * STEP);
            let dx = counting(simd) + f32x8::splat(simd, (dx + step * STEP) as f32);
            let mut index = self.index + (step * STEP) as usize;
            let mut row = 0;
            while row < self.size[1] {
                let mut outside = i32x8::splat(simd, 0);
                let mut edge = 0;
                while edge < N {
                    outside |= values[edge];
                    values[edge] += i32x8::splat(simd, edges[edge].down);
                    edge += 1;
                }
                let dy = f32x8::splat(simd, (dy + row) as f32);
                let depth = in_block(anchor, [a, b], [dx, dy]).hold(low, high);
                let inside = outside.simd_ge(i32x8::splat(simd, 0));
                let what = (self.shape.polygon, self.shape.is_kept_apart());
                let after = show(simd, samples, index, (depth, inside), what);
                farthest = after.simd_lt(farthest).select(after, farthest);
                index += samples.stride;
                row += 1;
            }
            step += 1;
        }
        least(farthest)
    }

    /// The edge functions at eight samples of the first row, `right` samples from the first one on.
    #[inline(always)]
    fn values<const N: usize>(&self, edges: &[Edge; N], right: i32) -> [i32x8<S>; N] {
        let simd = self.simd;
        let numbers = i32x8::from_slice(simd, &[0, 1, 2, 3, 4, 5, 6, 7]);
        let mut values = [i32x8::splat(simd, 0); N];
        let mut index = 0;
        while index < N {
            let edge = edges[index];
            let start = edge.start + edge.right * (self.first[0] + right) + edge.down * self.first[1];
            values[index] = numbers * i32x8::splat(simd, edge.right) + i32x8::splat(simd, start);
            index += 1;
        }
        values
    }
}

/// Shows a polygon in those of eight lanes that are `inside` and where it is nearer; returns the depths that are left.
#[inline(always)]
pub(super) fn show<S: Simd>(
    simd: S,
    samples: &mut Samples<'_>,
    index: usize,
    (depth, inside): (f32x8<S>, mask32x8<S>),
    (polygon, apart): (u32, bool),
) -> f32x8<S> {
    let depths = &mut samples.depth[index..index + LANES as usize];
    let before = f32x8::from_slice(simd, depths);
    // Strictly nearer: of two polygons at the same depth, the first in the list keeps the sample.
    let shown = inside & depth.simd_gt(before);
    if apart {
        push_veils(samples.veils, index, shown.to_bitmask(), (depth, polygon));
        return before;
    }
    let after = shown.select(depth, before);
    if shown.any_true() {
        after.store_slice(depths);
        let owners = &mut samples.owner[index..index + LANES as usize];
        let owner = u32x8::splat(simd, polygon);
        shown.select(owner, u32x8::from_slice(simd, owners)).store_slice(owners);
    }
    after
}

/// Keeps the lanes in `lanes` apart; those beside the picture are never asked for.
#[inline(always)]
fn push_veils<S: Simd>(veils: &mut Vec<Veil>, index: usize, lanes: u64, (depth, polygon): (f32x8<S>, u32)) {
    let mut rest = lanes;
    while rest != 0 {
        let lane = rest.trailing_zeros() as usize;
        veils.push(Veil { index: (index + lane) as u32, polygon, depth: f64::from(depth.as_slice()[lane]) });
        rest &= rest - 1;
    }
}

/// The least of eight depths; 0 where there are none.
#[inline(always)]
fn least<S: Simd>(depths: f32x8<S>) -> f32 {
    let mut least = f32::INFINITY;
    for &depth in depths.as_slice() {
        if depth < least {
            least = depth;
        }
    }
    if least < f32::INFINITY { least } else { 0.0 }
}
