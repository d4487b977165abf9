//! Steps: the rasterizer at work: a z-buffer polygon by polygon, Watkins scan line by scan line.
//!
//! DrawList, step -STEPS-> board, text
//!
//! Why the first part of a list and not hooks in rasterizers: what a rasterizer has drawn after n polygons is what it draws of
//! a list of n. So every rasterizer can be stepped, students' too, forward and backward.
//!
//! Space: samples; the board shows pixels.

use super::board::{Board, ink};
use super::made::{Listed, carefully};
use super::maps;
use super::solids::Shown;
use super::stages::short;
use crate::color::Rgb;
use crate::plan::Transparency;
use crate::raster::coverage::{Edge, Spans};
use crate::raster::watkins::{Decision, Span, spans};
use crate::raster::{Frame, Rasterizer};
use crate::render::{self, Canvas};
use crate::screen::{DrawList, ScreenPolygon};
use std::ops::Range;

/// The list as it is after its first `count` polygons.
fn first(list: &DrawList, count: usize) -> DrawList {
    let mut first = list.clone();
    first.polygons.truncate(count);
    first
}

/// The picture after every polygon up to the one in hand: its winning samples bright, its losing ones red.
pub(super) fn polygon(
    listed: &Listed,
    step: Option<usize>,
    (rasterizer, canvas): (&dyn Rasterizer, &Canvas),
) -> Result<Shown, String> {
    let (list, choices) = (&listed.list, &listed.plan.choices);
    let step = step.filter(|_| !list.is_empty()).map(|step| step.min(list.len() - 1));
    let drawn = first(list, step.map_or(list.len(), |step| step + 1));
    let (image, _) = carefully(|| render::draw(&drawn, Some(rasterizer), canvas))?;
    let mut board = Board::of_picture(&image.encode(choices.encoding));
    let Some(step) = step else {
        return Ok((board, vec![format!("all {} polygons are drawn", list.len())], list.len()));
    };
    let polygon = list.polygon(step);
    let (won, lost, range) = contest(&mut board, listed, step, rasterizer)?;
    board.outline(&maps::corners(&polygon, choices.samples), ink::YELLOW);
    let mut text = vec![
        format!("polygon {step} of {}, line {}, is put into the z-buffer", list.len(), polygon.record().source.line),
        format!("covers {} samples: nearer at {won} (yellow), not nearer at {lost} (red)", won + lost),
    ];
    if won + lost > 0 {
        text.push(format!("depth 1/w from {} to {}", short(range.0), short(range.1)));
    }
    Ok((board, text, list.len()))
}

/// Marks where polygon `step` is nearer than all before it, and where not; returns how often, and the range of its depths.
fn contest(
    board: &mut Board,
    listed: &Listed,
    step: usize,
    rasterizer: &dyn Rasterizer,
) -> Result<(u32, u32, (f64, f64)), String> {
    let list = &listed.list;
    let before = first(list, step);
    let mut frame = Frame::default();
    let mut target = frame.target((list.width, list.height), 0..list.height, Rgb::gray(0.0), Transparency::Over);
    carefully(|| rasterizer.draw(&before, &mut target))?;
    target.finish();
    let (polygon, side) = (list.polygon(step), listed.plan.choices.samples as i32);
    let (mut won, mut lost, mut range) = (0, 0, (f64::INFINITY, 0.0_f64));
    each_sample(&polygon, list, 0..list.height as i32, |x, y| {
        let depth = polygon.depth(x, y);
        range = (range.0.min(depth), range.1.max(depth));
        let is_nearer = depth > frame.sample(y as usize * list.width as usize + x as usize).1;
        *(if is_nearer { &mut won } else { &mut lost }) += 1;
        let (color, share) = if is_nearer { (ink::YELLOW, 70) } else { (ink::RED, 150) };
        board.blend(i64::from(x / side), i64::from(y / side), color, share / (side * side) as u32);
    });
    Ok((won, lost, range))
}

fn each_sample(polygon: &ScreenPolygon<'_>, list: &DrawList, rows: Range<i32>, mut sample: impl FnMut(i32, i32)) {
    let mut spans = Spans::within(0..list.width as i32);
    spans.of(polygon.vertices(), list.grid, rows, |row, columns| columns.for_each(|column| sample(column, row)));
}

/// The picture down to the scan line in hand, its active edges, and below or above it its segments and spans.
pub(super) fn scan_line(listed: &Listed, step: Option<usize>, mut board: Board) -> Shown {
    let (list, samples) = (&listed.list, listed.plan.choices.samples);
    let rows = list.height as usize;
    let Some(row) = step.map(|row| row.min(rows.saturating_sub(1)) as i32).filter(|_| rows > 0) else {
        return (board, vec![format!("all {rows} scan lines are drawn")], rows);
    };
    let (width, height) = (board.width() as i64, board.height() as i64);
    let line = i64::from(row) / i64::from(samples);
    board.tint((0, line + 1), (width, height), ink::BLACK, 190);
    board.tint((0, line), (width, line + 1), ink::WHITE, 60);
    let active = active_edges(&mut board, list, row, samples);
    let segments = segments(list, row);
    let spans = spans(list, row);
    strip(&mut board, samples, line, (&segments, &spans));
    let mut text = vec![
        format!("scan line {row} of {rows}: {active} active edges, {} segments, {} spans", segments.len(), spans.len()),
        "bars: segments; below: spans, and what decided (gray alone, blue range, green ends, red sample)".to_string(),
    ];
    let said = |span: &Span| {
        let Range { start, end } = span.columns;
        format!("  {start} to before {end}: polygon {}, {}", span.polygon, decision_name(span.decision))
    };
    text.extend(spans.iter().map(said));
    (board, text, rows)
}

/// Draws segments as bars, and below them spans and what decided each, on the half of the board where the scan line is not.
fn strip(board: &mut Board, samples: u32, line: i64, (segments, spans): (&[(u32, Range<i32>)], &[Span])) {
    let (width, height) = (board.width() as i64, board.height() as i64);
    let strip = height / 4;
    let top = if line < height / 2 { height - strip } else { 0 };
    board.tint((0, top), (width, top + strip), ink::BLACK, 220);
    let place = |columns: &Range<i32>| {
        let side = i64::from(samples);
        (i64::from(columns.start) / side, (i64::from(columns.end) / side).max(i64::from(columns.start) / side + 1))
    };
    let room = ((strip - 8) / 3).max(1) as usize;
    for (number, (polygon, columns)) in segments.iter().enumerate().take(room) {
        let ((left, right), y) = (place(columns), top + 1 + number as i64 * 3);
        board.fill((left, y), (right, y + 2), maps::color_of(*polygon));
    }
    for span in spans {
        let ((left, right), y) = (place(&span.columns), top + strip - 6);
        board.fill((left, y), (right, y + 4), maps::color_of(span.polygon));
        board.fill((left, y - 1), (left + 1, y + 4), ink::WHITE);
        board.fill((left, y + 4), (right, y + 6), decision_color(span.decision));
    }
}

/// Draws the edges that cross the row, and a dot where; returns how many.
fn active_edges(board: &mut Board, list: &DrawList, row: i32, samples: u32) -> usize {
    let side = f64::from(samples);
    let mut count = 0;
    for polygon in list.polygons() {
        for (from, to) in crate::math::edges(polygon.vertices()) {
            let edge = Edge::downward(from, to, list.grid);
            if !edge.rows(list.grid).contains(&i64::from(row)) {
                continue;
            }
            count += 1;
            board.line((from.x / side, from.y / side), (to.x / side, to.y / side), ink::BLUE);
            let crossing = edge.crossing(i64::from(row), list.grid);
            board.dot((crossing / side, (f64::from(row) + 0.5) / side), 3, ink::WHITE);
        }
    }
    count
}

/// The samples of every polygon on the row, from left to right.
fn segments(list: &DrawList, row: i32) -> Vec<(u32, Range<i32>)> {
    let mut segments = Vec::new();
    let mut spans = Spans::within(0..list.width as i32);
    for polygon in list.polygons() {
        let mut push = |columns: Range<i32>| segments.push((polygon.index, columns));
        spans.of(polygon.vertices(), list.grid, row..row + 1, |_, columns| push(columns));
    }
    segments.sort_by_key(|(polygon, columns)| (columns.start, *polygon));
    segments
}

fn decision_color(decision: Decision) -> u32 {
    match decision {
        Decision::Alone => ink::GRAY,
        Decision::Range => ink::BLUE,
        Decision::Ends => ink::GREEN,
        Decision::Sample => ink::RED,
    }
}

fn decision_name(decision: Decision) -> &'static str {
    match decision {
        Decision::Alone => "alone",
        Decision::Range => "nearer by its depth range",
        Decision::Ends => "nearer at both ends",
        Decision::Sample => "one sample, compared",
    }
}
