//! Wire: the edges of polygons, without hidden-line removal.
//!
//! DrawList -WIRE-> Fragment
//!
//! One rule, diamond exit: around every sample center lies a diamond, the points with |dx| + |dy| < 1/2. A line shows a
//! sample when it leaves the sample's diamond. So a line that ends where the next begins shows the shared sample
//! once, and the picture does not depend on which way an edge is walked but for its two ends.
//!
//! Why whole numbers: ends lie on a grid, so "leaves the diamond" has an exact answer.
//! Edges that clipping made lie on the sides of the view volume, not on the object: they are not drawn.
//!
//! Space: samples. Source: the line rule of OpenGL (specification 1.4, section 3.4.1) and Direct3D.
//! Cost: one division a line, a few additions a sample of the longer direction.

use super::{PerPolygon, Pixels, PolygonRasterizer, Rasterizer, Target};
use crate::color::Rgb;
use crate::image::box_mean;
use crate::math::edges;
use crate::plan::Varying;
use crate::screen::shader::SurfaceShading;
use crate::screen::{DrawList, EdgeKind, Grid, ScreenPolygon, ScreenVertex, Shader};
use std::ops::Range;

/// Draws the edges of every polygon.
#[derive(Clone, Copy, Debug, Default)]
pub struct Wire;

impl PolygonRasterizer for Wire {
    fn draw_polygon(&self, polygon: &ScreenPolygon<'_>, shader: &Shader, target: &mut Target<'_>) {
        each_sample(polygon, [0..target.width(), target.row_range()], |x, y| {
            target.put(shader.fragment(polygon, x, y));
        });
    }
}

/// Calls `show` for every sample that an edge of the polygon shows and that is inside.
fn each_sample(polygon: &ScreenPolygon<'_>, [columns, rows]: [Range<i32>; 2], mut show: impl FnMut(i32, i32)) {
    for (start, end) in edges(polygon.vertices()) {
        if start.edge == EdgeKind::Cut {
            continue;
        }
        for_each_sample(&Line::new(start, end, polygon.grid()), |x, y| {
            // Lines along the lower and right sides of the picture pass through samples just outside.
            if columns.contains(&x) && rows.contains(&y) {
                show(x, y);
            }
        });
    }
}

impl Rasterizer for Wire {
    fn draw(&self, list: &DrawList, target: &mut Target<'_>) {
        PerPolygon(Wire).draw(list, target);
    }

    /// Lines of one color without depth need no target: which samples they show is all there is to keep.
    fn draw_pixels(&self, list: &DrawList, pixels: &mut Pixels<'_>) -> bool {
        let opaque = |surface: &SurfaceShading| surface.opacity == Rgb::gray(1.0);
        if list.varying != Varying::Nothing || !list.shader.surfaces.iter().all(opaque) {
            return false;
        }
        let (width, height) = (list.width as usize, list.height as usize);
        let mut shown = vec![false; width * height];
        for polygon in list.polygons() {
            each_sample(&polygon, [0..width as i32, 0..height as i32], |x, y| {
                let before = std::mem::replace(&mut shown[y as usize * width + x as usize], true);
                pixels.counts.puts += 1;
                pixels.counts.overdraw += u64::from(before);
            });
        }
        let (samples, colors) = (pixels.samples.max(1) as usize, [pixels.background, list.shader.line_color]);
        let mut lights = vec![colors[0]; samples * samples];
        for (row, line) in pixels.light.chunks_mut(pixels.width.max(1)).enumerate() {
            for (column, pixel) in line.iter_mut().enumerate() {
                let first = row * samples * width + column * samples;
                let rows = (0..samples).map(|row| &shown[first + row * width..][..samples]);
                for (light, &shown) in lights.iter_mut().zip(rows.flatten()) {
                    *light = colors[usize::from(shown)];
                }
                *pixel = if samples == 1 { lights[0] } else { box_mean(&lights, samples, samples) };
            }
        }
        true
    }
}

/// A line in half grid steps, turned so that it runs along u at least as far as along v.
struct Line {
    start: (i64, i64),
    end: (i64, i64),
    /// u is y and v is x.
    steep: bool,
    /// Half the width of a sample.
    half: i64,
    /// The width of a sample is 2 to this power.
    shift: u32,
}

impl Line {
    fn new(start: &ScreenVertex, end: &ScreenVertex, grid: Grid) -> Line {
        let fixed = |vertex: &ScreenVertex| (2 * grid.fixed(vertex.x), 2 * grid.fixed(vertex.y));
        let (start, end) = (fixed(start), fixed(end));
        let steep = (end.1 - start.1).abs() > (end.0 - start.0).abs();
        let turn = |(x, y): (i64, i64)| if steep { (y, x) } else { (x, y) };
        Line { start: turn(start), end: turn(end), steep, half: grid.steps(), shift: grid.steps().trailing_zeros() + 1 }
    }

    /// The sample whose cell holds a coordinate.
    fn cell(&self, coordinate: i64) -> i64 {
        // A sample is a power of two wide.
        coordinate >> self.shift
    }

    fn center(&self, cell: i64) -> i64 {
        (2 * cell + 1) * self.half
    }

    /// Whether a point lies in the diamond of its cell. Of its border only the left corner and the two upper sides belong to
    /// it, so that every point lies in at most one diamond.
    fn in_diamond(&self, (u, v): (i64, i64)) -> bool {
        let (du, dv) = (u - self.center(self.cell(u)), v - self.center(self.cell(v)));
        // Turned back: a steep line and a shallow one that meet on the border must agree on whose it is.
        let (dx, dy) = if self.steep { (dv, du) } else { (du, dv) };
        let distance = dx.abs() + dy.abs();
        distance < self.half || (distance == self.half && (dy < 0 || dx == -self.half))
    }

    /// The row (v cell) in which the line passes the center line of column `cell`, and what is left of the division.
    fn row_at(&self, cell: i64) -> (i64, i64) {
        let (du, dv) = (self.end.0 - self.start.0, self.end.1 - self.start.1);
        let along = self.center(cell) - self.start.0;
        // v = start.v + along dv / du, floored to a cell: exact, |du| is the denominator.
        if self.reach().max(along.abs()) < 1 << 29 && self.half < 1 << 17 {
            let (numerator, denominator) = ((self.start.1 * du + along * dv) * du.signum(), self.denominator());
            let row = numerator.div_euclid(denominator);
            return (row, numerator - row * denominator);
        }
        let [start, du, along, dv] = [self.start.1, du, along, dv].map(i128::from);
        let numerator = (start * du + along * dv) * du.signum();
        let denominator = du.abs() * i128::from(2 * self.half);
        (numerator.div_euclid(denominator) as i64, numerator.rem_euclid(denominator) as i64)
    }

    /// The largest coordinate.
    fn reach(&self) -> i64 {
        [self.start.0, self.start.1, self.end.0, self.end.1].into_iter().fold(0, |most, along| most.max(along.abs()))
    }

    /// Whether what [`Line::next_row`] computes fits: not for corners a billion samples away on the finest grid.
    fn is_near(&self) -> bool {
        self.reach() < 1 << 40
    }

    /// What [`Line::row_at`] divides by.
    fn denominator(&self) -> i64 {
        (self.end.0 - self.start.0).abs() * 2 * self.half
    }

    /// The row of the next column, `forward` or back, after `row`: the same numbers without a division. The line rises by at most one
    /// row a column.
    fn next_row(&self, (row, rest): (i64, i64), forward: bool) -> (i64, i64) {
        let (du, dv) = (self.end.0 - self.start.0, self.end.1 - self.start.1);
        let (change, denominator) = (2 * self.half * dv * du.signum(), self.denominator());
        let rest = if forward { rest + change } else { rest - change };
        if rest < 0 {
            (row - 1, rest + denominator)
        } else if rest >= denominator {
            (row + 1, rest - denominator)
        } else {
            (row, rest)
        }
    }
}

/// Calls `show` for every sample whose diamond the line leaves, from start to end.
fn for_each_sample(line: &Line, mut show: impl FnMut(i32, i32)) {
    let mut emit = |u: i64, v: i64| if line.steep { show(v as i32, u as i32) } else { show(u as i32, v as i32) };
    let cell_of = |(u, v): (i64, i64)| (line.cell(u), line.cell(v));
    let (first, last) = (cell_of(line.start), cell_of(line.end));
    let starts_inside = line.in_diamond(line.start);
    let ends_inside = line.in_diamond(line.end);
    if starts_inside && ends_inside && first == last {
        return;
    }
    // The start's diamond is left even where the line begins beyond its center.
    if starts_inside {
        emit(first.0, first.1);
    }
    let forward = line.end.0 >= line.start.0;
    let (low, high) = if forward { (first.0, last.0) } else { (last.0, first.0) };
    let columns = (low..=high).map(|step| if forward { step } else { low + high - step });
    let (mut before, is_near) = (None, line.is_near());
    for column in columns {
        let center = line.center(column);
        let reached = if forward {
            line.start.0 <= center && center < line.end.0
        } else {
            line.end.0 < center && center <= line.start.0
        };
        if !reached {
            continue;
        }
        let row = match before.filter(|_| is_near) {
            Some(row) => line.next_row(row, forward),
            None => line.row_at(column),
        };
        before = Some(row);
        let sample = (column, row.0);
        let is_start = starts_inside && sample == first;
        let is_end = ends_inside && sample == last;
        if !is_start && !is_end {
            emit(sample.0, sample.1);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Vec3;

    fn samples(start: (f64, f64), end: (f64, f64)) -> Vec<(i32, i32)> {
        let vertex = |(x, y)| ScreenVertex { x, y, homogeneous: Vec3::ONE, edge: EdgeKind::Original };
        let mut shown = Vec::new();
        for_each_sample(&Line::new(&vertex(start), &vertex(end), Grid { bits: 8 }), |x, y| shown.push((x, y)));
        shown
    }

    #[test]
    fn a_line_between_centers_leaves_its_last_sample_to_the_next_line() {
        assert_eq!(samples((0.5, 0.5), (3.5, 0.5)), [(0, 0), (1, 0), (2, 0)]);
        assert_eq!(samples((3.5, 0.5), (0.5, 0.5)), [(3, 0), (2, 0), (1, 0)]);
        assert_eq!(samples((0.5, 0.5), (0.5, 2.5)), [(0, 0), (0, 1)]);
        assert_eq!(samples((0.5, 0.5), (2.5, 2.5)), [(0, 0), (1, 1)]);
    }

    #[test]
    fn a_closed_outline_shows_every_sample_once() {
        let corners = [(0.5, 0.5), (5.5, 2.0), (3.25, 6.5)];
        let mut shown: Vec<_> = edges(&corners).flat_map(|(&a, &b)| samples(a, b)).collect();
        let count = shown.len();
        shown.sort_unstable();
        shown.dedup();
        assert_eq!(shown.len(), count);
    }

    #[test]
    fn a_line_inside_one_diamond_shows_nothing() {
        assert_eq!(samples((0.4, 0.5), (0.6, 0.5)), []);
    }
}
