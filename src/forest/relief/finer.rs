//! Finer: a grid with samples between its samples, on its finest triangles.
//!
//! Grid -FINER-> Grid of the same surface -> hierarchy, borders
//!
//! Why: borders between covers may be wanted more exactly than heights were measured. A triangle can only be halved down to the
//! samples; so there must be more of them. The surface stays what it was, to the last bit of an `f32`: new samples lie on the triangles that
//! halving down to the old ones makes, and cost no triangle where no border is.
//!
//! Space: columns from the west, rows from the north. Cost: one sample of the new grid, 4 bytes.

use super::lattice::{Lattice, Point, Triangle};
use super::scan::{Plane, rows};
use crate::forest::elevation::Grid;

/// The grid with `parts` squares where one was, along each side. `parts` is a power of two; voids stay voids, and so do squares that touch one.
#[must_use]
pub fn finer(grid: &Grid, parts: u32) -> Grid {
    if parts <= 1 {
        return grid.clone();
    }
    let (columns, lines) = ((grid.columns() - 1) * parts as usize + 1, (grid.rows() - 1) * parts as usize + 1);
    let mut heights = vec![f32::NAN; columns * lines];
    let mut stack = Lattice::new(grid).roots().to_vec();
    while let Some(triangle) = stack.pop() {
        if triangle.can_be_halved() {
            stack.extend(triangle.halves());
            continue;
        }
        let corners = [triangle.a, triangle.b, triangle.apex];
        let Some(heights_of) = known(grid, corners) else { continue };
        let [a, b, apex] = corners.map(|point| Point { x: point.x * parts, y: point.y * parts });
        let large = Triangle { a, b, apex };
        let plane = Plane::new(&large, heights_of);
        rows(&large, (columns as u32 - 1, lines as u32 - 1), |y, first, last| {
            (first..=last).for_each(|x| heights[y as usize * columns + x as usize] = plane.at(x, y) as f32);
        });
    }
    // Lone samples beside voids keep their height.
    for (x, y) in (0..grid.rows()).flat_map(|y| (0..grid.columns()).map(move |x| (x, y))) {
        heights[y * parts as usize * columns + x * parts as usize] = grid.height(x, y);
    }
    let mut frame = grid.frame;
    frame.step = frame.step.map(|step| step / f64::from(parts));
    Grid::new(&grid.name, (columns, lines), heights, frame).unwrap_or_else(|_| grid.clone())
}

/// The heights of samples; `None` where one is a void or beyond the grid.
fn known(grid: &Grid, points: [Point; 3]) -> Option<[f64; 3]> {
    let is_inside = |point: &Point| (point.x as usize) < grid.columns() && (point.y as usize) < grid.rows();
    let heights = points
        .iter()
        .all(is_inside)
        .then(|| points.map(|point| f64::from(grid.height(point.x as usize, point.y as usize))))?;
    heights.iter().all(|height| !height.is_nan()).then_some(heights)
}
