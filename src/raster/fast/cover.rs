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

use super::bins::{MOST_EDGES, Segment, Shape};
use super::edges::Edge;
use super::lanes::counting;
use super::layout::{Area, LANES};
use crate::screen::BLOCK;
use crate::screen::lane::{Lane, in_block};
use fearless_simd::{Level, Select, Simd, SimdBase, dispatch, f32x8, i32x8, prelude::*, u32x8};

const STEP: i32 = LANES as i32;

/// The samples of a tile.
pub(super) struct Samples<'a> {
    pub area: &'a Area,
    pub stride: usize,
    pub depth: &'a mut [f32],
    pub owner: &'a mut [u32],
}

/// Draws the shapes of a segment with these numbers, one after the other.
pub(super) fn draw(level: Level, mut samples: Samples<'_>, segment: &Segment, shapes: &[u32]) {
    dispatch!(level, simd => draw_all(simd, &mut samples, segment, shapes));
}

#[inline(always)]
fn draw_all<S: Simd>(simd: S, samples: &mut Samples<'_>, segment: &Segment, shapes: &[u32]) {
    for &number in shapes {
        let shape = &segment.shapes[number as usize];
        let first = shape.first_corner as usize;
        let corners = &segment.corners[first..first + usize::from(shape.corner_count)];
        match corners.len() {
            3 => draw_convex::<S, 3>(simd, samples, shape, corners),
            4 => draw_convex::<S, 4>(simd, samples, shape, corners),
            _ => draw_convex::<S, MOST_EDGES>(simd, samples, shape, corners),
        }
    }
}

/// A polygon with up to N edges; missing ones are nowhere outside.
#[inline(always)]
fn draw_convex<S: Simd, const N: usize>(simd: S, samples: &mut Samples<'_>, shape: &Shape, corners: &[[i32; 2]]) {
    let area = samples.area;
    let origin = (area.columns.start, area.rows.start);
    let mut edges = [Edge::default(); N];
    for (index, edge) in edges.iter_mut().enumerate().take(corners.len()) {
        let next = if index + 1 == corners.len() { 0 } else { index + 1 };
        *edge = Edge::new(corners[index], corners[next], origin);
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

#[inline(always)]
fn draw_in_block<S: Simd, const N: usize>(
    simd: S,
    samples: &mut Samples<'_>,
    (shape, edges): (&Shape, &[Edge; N]),
    ([x_start, x_end], [y_start, y_end]): Piece,
) {
    let (block_x, block_y) = (x_start & !(BLOCK - 1), y_start & !(BLOCK - 1));
    let plane = &shape.depth;
    let [a, b] = plane.slope().map(|slope| f32x8::splat(simd, slope));
    let anchor = f32x8::splat(simd, plane.anchor(block_x, block_y));
    let [low, high] = [plane.low, plane.high].map(|bound| f32x8::splat(simd, bound as f32));
    let owner = u32x8::splat(simd, shape.polygon);
    let numbers = i32x8::from_slice(simd, &[0, 1, 2, 3, 4, 5, 6, 7]);
    let (first_x, first_y) = (samples.area.columns.start, samples.area.rows.start);
    for y in y_start..y_end {
        let dy = f32x8::splat(simd, (y - block_y) as f32);
        let row = (y - first_y) as usize * samples.stride;
        let mut x = x_start;
        while x < x_end {
            let mut outside = i32x8::splat(simd, 0);
            for edge in edges {
                let value = edge.start + edge.right * (x - first_x) + edge.down * (y - first_y);
                outside = outside | (numbers * edge.right + value);
            }
            let inside = outside.simd_ge(0);
            let index = row + (x - first_x) as usize;
            let dx = counting(simd) + (x - block_x) as f32;
            let depth = in_block(anchor, [a, b], [dx, dy]).hold(low, high);
            let depths = &mut samples.depth[index..index + LANES as usize];
            let before = f32x8::from_slice(simd, depths);
            let shown = inside & depth.simd_gt(before);
            if shown.any_true() {
                shown.select(depth, before).store_slice(depths);
                let owners = &mut samples.owner[index..index + LANES as usize];
                shown.select(owner, u32x8::from_slice(simd, owners)).store_slice(owners);
            }
            x += STEP;
        }
    }
}
