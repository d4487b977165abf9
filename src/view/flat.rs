//! Flat: what is shown on the screen between geometry and rasterizer: ears in their order, and screen polygons.
//!
//! Traced -FLAT-> board, over the picture made dark
//!
//! Space: pixels of the picture.

use super::board::{Board, Point, ink};
use super::maps;
use super::solids::Shown;
use super::stages::Traced;
use crate::screen::EdgeKind;

/// Ears, in the order of cutting: those of all polygons, or those up to the step in hand.
pub(super) fn split(traced: &Traced, step: Option<usize>, mut board: Board) -> Shown {
    let ears = traced.ears();
    let step = step.filter(|_| !ears.is_empty()).map(|step| step.min(ears.len() - 1));
    let hand = step.map(|step| ears[step]);
    let with_ears = traced.trace.clipped.iter().filter(|polygon| polygon.vertices.len() > 3).count();
    for polygon in (0..traced.trace.clipped.len()).filter(|&polygon| traced.trace.clipped[polygon].vertices.len() > 3) {
        let corners = screen(traced, polygon);
        let shown = match hand {
            None => usize::MAX,
            Some((in_hand, ear)) if in_hand == polygon => ear + 1,
            Some((in_hand, _)) if polygon < in_hand => usize::MAX,
            Some(_) => 0,
        };
        let is_bright = hand.is_none_or(|hand| hand.0 == polygon);
        for (number, triangle) in traced.triangles(polygon).into_iter().enumerate().take(shown) {
            let triangle = triangle.map(|corner| corners[corner as usize]);
            ear(&mut board, number, &triangle, is_bright);
        }
        board.outline(&corners, if is_bright { ink::WHITE } else { ink::GRAY });
    }
    let text = match hand {
        Some(hand) => traced.ear_text(hand),
        None => vec![format!("ears: {}, in polygons with more than 3 corners: {with_ears}", ears.len())],
    };
    (board, text, ears.len())
}

fn ear(board: &mut Board, number: usize, corners: &[Point; 3], is_bright: bool) {
    let color = ink::WHEEL[number % ink::WHEEL.len()];
    board.area(corners, color, if is_bright { 150 } else { 60 });
    if !is_bright {
        return;
    }
    board.outline(corners, color);
    let [a, b, c] = corners;
    let double_area = ((b.0 - a.0) * (c.1 - a.1) - (c.0 - a.0) * (b.1 - a.1)).abs();
    let text = (number + 1).to_string();
    // A number that does not fit says nothing.
    if double_area > 400.0 * text.len() as f64 {
        let middle = ((a.0 + b.0 + c.0) / 3.0, (a.1 + b.1 + c.1) / 3.0);
        board.text((middle.0 as i64 - 2, middle.1 as i64 - 4), &text, 1, ink::WHITE);
    }
}

/// Corners of a polygon that clipping left, on the screen.
fn screen(traced: &Traced, polygon: usize) -> Vec<Point> {
    let view = &traced.plan.view;
    let ((half_width, half_height), side) = (view.half(), f64::from(view.samples));
    let on_screen = |eye: crate::math::Vec3| {
        let (x, y) = (eye.x / eye.z * view.scale, eye.y / eye.z * view.scale);
        ((half_width + x) / side, (half_height - y) / side)
    };
    traced.eye_corners(polygon).into_iter().map(on_screen).collect()
}

/// Polygons on the screen: outlines, corners on the grid, edges that clipping made.
pub(super) fn polygons(traced: &Traced, step: Option<usize>, mut board: Board) -> Shown {
    let (list, samples) = (&traced.list, traced.plan.choices.samples);
    let step = step.filter(|_| !list.is_empty()).map(|step| step.min(list.len() - 1));
    maps::edges(&mut board, list, samples, ink::GRAY);
    for polygon in list.polygons() {
        maps::corners(&polygon, samples).into_iter().for_each(|corner| board.dot(corner, 2, ink::GREEN));
    }
    let Some(step) = step else {
        let made = list.polygons().flat_map(|polygon| polygon.vertices()).filter(|v| v.edge == EdgeKind::Cut).count();
        let text = vec![format!("polygons on the screen: {}; edges made by clipping (blue): {made}", list.len())];
        return (board, text, list.len());
    };
    let polygon = list.polygon(step);
    let corners = maps::corners(&polygon, samples);
    board.area(&corners, ink::YELLOW, 90);
    board.outline(&corners, ink::YELLOW);
    for (number, &(x, y)) in corners.iter().enumerate().take(64) {
        board.dot((x, y), 3, ink::WHITE);
        board.text((x as i64 + 3, y as i64 - 9), &number.to_string(), 1, ink::WHITE);
    }
    (board, traced.screen_text(step), list.len())
}
