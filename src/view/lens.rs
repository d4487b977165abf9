//! Lens: the pixels around one, large; edges stay lines one pixel wide, samples stay dots.
//!
//! board, DrawList, pixel -LENS-> board
//!
//! Why not a larger picture: a picture drawn larger has more samples, and what is asked about is gone. Here the samples are
//! those of the picture, and only the drawing of edges and dots is new, at any zoom.
//!
//! Space: pixels of the picture -> pixels of the lens, around the middle of the pixel in question.

use super::board::{Board, ink};
use super::maps;
use crate::screen::DrawList;

/// The lens over `picture`, a square board of `side` pixels, `zoom` of them a pixel, around `pixel`.
#[must_use]
pub fn lens(picture: &Board, list: Option<(&DrawList, u32)>, pixel: (i32, i32), zoom: i32, side: i64) -> Board {
    let mut board = Board::new(side as usize, side as usize, 0x28_28_28);
    let (zoom, half) = (f64::from(zoom), side as f64 / 2.0);
    let center = (f64::from(pixel.0) + 0.5, f64::from(pixel.1) + 0.5);
    // What pixel of the picture a pixel of the lens shows, by its middle.
    let source = |place: i64, center: f64| ((place as f64 + 0.5 - half) / zoom + center).floor() as i64;
    for y in 0..side {
        for x in 0..side {
            if let Some(color) = picture.pixel(source(x, center.0), source(y, center.1)) {
                board.put(x, y, color);
            }
        }
    }
    let to_lens = |(x, y): (f64, f64)| ((x - center.0) * zoom + half, (y - center.1) * zoom + half);
    let reach = half / zoom + 1.0;
    let range = |center: f64| ((center - reach).floor() as i64, (center + reach).ceil() as i64);
    let (columns, rows) = (range(center.0), range(center.1));
    if zoom >= 8.0 {
        grid(&mut board, (columns, rows), to_lens);
    }
    if let Some((list, samples)) = list {
        edges(&mut board, list, samples, (center, reach), to_lens);
        if zoom >= 6.0 * f64::from(samples) {
            dots(&mut board, samples, (columns, rows), to_lens);
        }
    }
    let corner = |x: f64, y: f64| to_lens((f64::from(pixel.0) + x, f64::from(pixel.1) + y));
    board.outline(&[corner(0.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0), corner(0.0, 1.0)], ink::YELLOW);
    let last = side as f64 - 1.0;
    board.outline(&[(0.0, 0.0), (last, 0.0), (last, last), (0.0, last)], ink::WHITE);
    board
}

/// Columns and rows, first and last.
type Window = ((i64, i64), (i64, i64));

/// Faint borders between pixels.
fn grid(board: &mut Board, (columns, rows): Window, to_lens: impl Fn((f64, f64)) -> (f64, f64)) {
    let (width, height) = (board.width() as i64, board.height() as i64);
    for x in columns.0..=columns.1 {
        let place = to_lens((x as f64, 0.0)).0.floor() as i64;
        board.tint((place, 0), (place + 1, height), ink::GRAY, 60);
    }
    for y in rows.0..=rows.1 {
        let place = to_lens((0.0, y as f64)).1.floor() as i64;
        board.tint((0, place), (width, place + 1), ink::GRAY, 60);
    }
}

/// Outlines that come near, and their corners, as they are on the grid.
fn edges(
    board: &mut Board,
    list: &DrawList,
    samples: u32,
    (center, reach): ((f64, f64), f64),
    to_lens: impl Fn((f64, f64)) -> (f64, f64),
) {
    for polygon in list.polygons() {
        let corners = maps::corners(&polygon, samples);
        let bounds = |axis: fn(&(f64, f64)) -> f64| {
            corners.iter().map(axis).fold((f64::MAX, f64::MIN), |(low, high), x| (low.min(x), high.max(x)))
        };
        let far = |(low, high): (f64, f64), center: f64| low > center + reach || high < center - reach;
        if far(bounds(|p| p.0), center.0) || far(bounds(|p| p.1), center.1) {
            continue;
        }
        let placed: Vec<_> = corners.into_iter().map(&to_lens).collect();
        let color = maps::color_of(polygon.index);
        board.outline(&placed, color);
        placed.into_iter().for_each(|corner| board.dot(corner, 3, color));
    }
}

/// The centers of samples.
fn dots(board: &mut Board, samples: u32, (columns, rows): Window, to_lens: impl Fn((f64, f64)) -> (f64, f64)) {
    let side = i64::from(samples);
    for y in rows.0 * side..rows.1 * side {
        for x in columns.0 * side..columns.1 * side {
            let center = [x, y].map(|place| (place as f64 + 0.5) / side as f64);
            let at = to_lens((center[0], center[1]));
            board.dot(at, 3, ink::BLACK);
            board.dot(at, 1, ink::WHITE);
        }
    }
}
