//! Maps: depth, normals, overdraw and polygon numbers as colors.
//!
//! DrawList, samples -MAPS-> board
//!
//! A pixel shows its middle sample. Depth: near is bright, over the depths that are there; the background is dark blue.
//! Normals: red to the right, green up, blue towards the eye, 0 in the middle. Overdraw: how many polygons cover the
//! sample, hidden ones included. Polygons: every number has a color of its own.

use super::board::{Board, ink, packed};
use super::made::{Listed, Samples};
use crate::raster::coverage::Spans;
use crate::screen::{DrawList, ScreenPolygon};

/// The color of what no polygon covers.
const NOTHING: u32 = 0x10_18_30;

/// A board where pixel (x, y) has the color of its middle sample.
fn map(samples: &Samples, side: u32, color: impl Fn(usize, usize) -> u32) -> Board {
    let side = side as usize;
    let (width, height) = (samples.width / side, samples.height / side);
    let mut board = Board::new(width, height, NOTHING);
    for y in 0..height {
        for x in 0..width {
            board.put(x as i64, y as i64, color(x * side + side / 2, y * side + side / 2));
        }
    }
    board
}

/// Depth, and the distances along the view of its darkest and its brightest, scene units.
pub(super) fn depth(samples: &Samples, listed: &Listed) -> (Board, Option<(f64, f64)>) {
    let all = (0..samples.height).flat_map(|y| (0..samples.width).map(move |x| (x, y)));
    let depths = all.map(|(x, y)| samples.at(x, y).1).filter(|&depth| depth > 0.0);
    let (low, high) = depths.fold((f64::INFINITY, 0.0_f64), |(low, high), depth| (low.min(depth), high.max(depth)));
    let gray = |depth: f64| {
        let share = if high > low { (depth - low) / (high - low) } else { 1.0 };
        packed([(48.0 + 207.0 * share).round() as u8; 3])
    };
    let board = map(samples, listed.plan.choices.samples, |x, y| match samples.at(x, y).1 {
        depth if depth > 0.0 => gray(depth),
        _ => NOTHING,
    });
    let distance = |depth: f64| 1.0 / listed.list.depth_in_scene_units(depth);
    (board, (high > 0.0).then(|| (distance(low), distance(high))))
}

/// Normals, from a list that carries them.
pub(super) fn normals(samples: &Samples, listed: &Listed) -> Board {
    map(samples, listed.plan.choices.samples, |x, y| {
        let Some(owner) = samples.at(x, y).0 else { return NOTHING };
        let values = listed.list.polygon(owner as usize).values(x as i32, y as i32);
        let level = |share: f64| (127.5 + 127.5 * share).round().clamp(0.0, 255.0) as u8;
        let length = values.iter().take(3).map(|n| n * n).sum::<f64>().sqrt().max(1e-9);
        packed([level(values[0] / length), level(values[1] / length), level(-values[2] / length)])
    })
}

/// How many polygons cover every sample, and the most that cover one.
pub(super) fn overdraw(samples: &Samples, listed: &Listed) -> (Board, u32) {
    const HEAT: [u32; 7] = [NOTHING, 0x30_50_A0, 0x30_90_50, 0xC0_C0_40, 0xE0_90_30, 0xD0_40_30, 0xFF_FF_FF];
    let covering = covering(&listed.list);
    let board = map(samples, listed.plan.choices.samples, |x, y| {
        HEAT[(covering[y * samples.width + x] as usize).min(HEAT.len() - 1)]
    });
    (board, covering.iter().copied().max().unwrap_or(0))
}

fn covering(list: &DrawList) -> Vec<u32> {
    let mut covering = vec![0; list.width as usize * list.height as usize];
    let mut spans = Spans::within(0..list.width as i32);
    for polygon in list.polygons() {
        spans.of(polygon.vertices(), list.grid, 0..list.height as i32, |row, columns| {
            let start = row as usize * list.width as usize;
            covering[start + columns.start as usize..start + columns.end as usize].iter_mut().for_each(|n| *n += 1);
        });
    }
    covering
}

/// Which polygon is in front.
pub(super) fn polygons(samples: &Samples, listed: &Listed) -> Board {
    map(samples, listed.plan.choices.samples, |x, y| samples.at(x, y).0.map_or(NOTHING, color_of))
}

/// A color for a number; neighbors differ. Never dark.
pub(super) fn color_of(number: u32) -> u32 {
    // Multiplying by an odd number spreads the bits (Knuth, "The Art of Computer Programming", 6.4).
    let spread = number.wrapping_add(1).wrapping_mul(0x9E37_79B1);
    0x40_40_40 + (spread >> 8 & 0x7F_7F_7F) + (spread >> 1 & 0x3F_3F_3F)
}

/// The corners of a screen polygon, in pixels of the picture.
pub(super) fn corners(polygon: &ScreenPolygon<'_>, samples: u32) -> Vec<(f64, f64)> {
    let side = f64::from(samples);
    polygon.vertices().iter().map(|corner| (corner.x / side, corner.y / side)).collect()
}

/// Draws the outlines of all polygons; edges that clipping made are blue, diagonals dark.
pub(super) fn edges(board: &mut Board, list: &DrawList, samples: u32, color: u32) {
    use crate::screen::EdgeKind;
    for polygon in list.polygons() {
        let corners = corners(&polygon, samples);
        for (index, vertex) in polygon.vertices().iter().enumerate() {
            let color = match vertex.edge {
                EdgeKind::Original => color,
                EdgeKind::Cut => ink::BLUE,
                EdgeKind::Diagonal => 0x50_50_50,
            };
            board.line(corners[index], corners[(index + 1) % corners.len()], color);
        }
    }
}
