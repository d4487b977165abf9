//! Polygons by an edge table: every scan line asks which edges cross it, sorts the crossings, fills between pairs.
//! Crossings are whole-number divisions; depth and color are the contract's.

use super::Slip;
use farop::raster::{PolygonRasterizer, Target};
use farop::screen::{ScreenPolygon, Shader};

pub struct EdgeTable {
    pub slip: Slip,
}

/// From upper to lower end, in half steps of the grid.
struct Edge {
    x: i64,
    y: i64,
    dx: i64,
    dy: i64,
}

impl EdgeTable {
    fn edges(&self, polygon: &ScreenPolygon<'_>) -> Vec<Edge> {
        let at = |snapped: f64| polygon.grid().fixed(snapped) * 2;
        let mut corners: Vec<(i64, i64)> = polygon.vertices().iter().map(|v| (at(v.x), at(v.y))).collect();
        if self.slip.is("three_corners_only") {
            corners.truncate(3);
        }
        if self.slip.is("four_corners_only") {
            corners.truncate(4);
        }
        let mut edges = Vec::new();
        let closing = if self.slip.is("not_closed") { corners.len() - 1 } else { corners.len() };
        for number in 0..closing {
            let (a, b) = (corners[number], corners[(number + 1) % corners.len()]);
            let (upper, lower) = if a.1 <= b.1 { (a, b) } else { (b, a) };
            if self.slip.is("upward_edges_lost") && a.1 > b.1 {
                continue;
            }
            edges.push(Edge { x: upper.0, y: upper.1, dx: lower.0 - upper.0, dy: lower.1 - upper.1 });
        }
        edges
    }

    /// The first column whose center is at or right of the edge, on row `y`.
    fn column(&self, edge: &Edge, y: i32, scale: i64) -> i32 {
        let down = self.line(y, scale) - edge.y;
        let dy = edge.dy.max(1);
        let x = edge.x as f64 + edge.dx as f64 * down as f64 / dy as f64;
        let sample = 2.0 * scale as f64;
        match self.slip.0.as_str() {
            "floor_ends" => return (x / sample).floor() as i32,
            "ceil_ends" => return (x / sample).ceil() as i32,
            "summed_slopes" => {
                // From the first row on, the slope is added in 1/16 samples.
                let first = (edge.y + scale - 1).div_euclid(2 * scale) as i32;
                let start = edge.x + edge.dx * (self.line(first, scale) - edge.y) / dy;
                let slope = ((edge.dx as f64 / dy as f64) * 16.0).round() as i64;
                let sixteenths = (start as f64 / sample * 16.0).round() as i64 + slope * i64::from(y - first);
                return (sixteenths as f64 / 16.0 - 0.5).ceil() as i32;
            }
            "whole_slope" => {
                let first = (edge.y + scale - 1).div_euclid(2 * scale) as i32;
                let start = edge.x + edge.dx * (self.line(first, scale) - edge.y) / dy;
                let moved = start + (edge.dx / dy) * 2 * scale * i64::from(y - first);
                return (moved as f64 / sample - 0.5).ceil() as i32;
            }
            "upper_end_only" => return (edge.x as f64 / sample - 0.5).ceil() as i32,
            _ => {}
        }
        // center (2 column + 1) scale >= x + dx down / dy
        let numerator = i128::from(edge.x - scale) * i128::from(dy) + i128::from(edge.dx) * i128::from(down);
        let divisor = i128::from(2 * scale * dy);
        -((-numerator).div_euclid(divisor)) as i32
    }

    fn line(&self, y: i32, scale: i64) -> i64 {
        if self.slip.is("line_at_the_top") {
            return i64::from(y) * 2 * scale;
        }
        (2 * i64::from(y) + 1) * scale
    }

    fn crosses(&self, edge: &Edge, line: i64) -> bool {
        let (upper, lower) = (edge.y, edge.y + edge.dy);
        match self.slip.0.as_str() {
            "both_ends_count" => upper <= line && line <= lower && edge.dy > 0,
            "no_end_counts" => upper < line && line < lower,
            "lower_ends_count" => upper < line && line <= lower,
            "level_edges_count" => upper <= line && (line < lower || edge.dy == 0 && line == lower),
            _ => upper <= line && line < lower,
        }
    }
}

impl PolygonRasterizer for EdgeTable {
    fn draw_polygon(&self, polygon: &ScreenPolygon<'_>, shader: &Shader, target: &mut Target<'_>) {
        let scale = polygon.grid().steps();
        let edges = self.edges(polygon);
        let top = edges.iter().map(|edge| edge.y).min().unwrap_or(0) / (2 * scale);
        let bottom = edges.iter().map(|edge| edge.y + edge.dy).max().unwrap_or(0) / (2 * scale);
        let (mut top, mut bottom) = (top as i32, (bottom as i32).min(target.height() - 1));
        if self.slip.is("last_row_lost") {
            bottom -= 1;
        }
        if self.slip.is("first_row_lost") {
            top += 1;
        }
        for y in top..=bottom {
            let line = self.line(y, scale);
            let mut columns: Vec<i32> =
                edges.iter().filter(|e| self.crosses(e, line)).map(|edge| self.column(edge, y, scale)).collect();
            if !self.slip.is("not_sorted") {
                columns.sort_unstable();
            }
            if self.slip.is("notches_filled") && columns.len() > 2 {
                columns = vec![columns[0], columns[columns.len() - 1]];
            }
            if self.slip.is("first_pair_only") {
                columns.truncate(2);
            }
            if self.slip.is("pairs_overlap") {
                columns = columns.windows(2).flatten().copied().collect();
            }
            if self.slip.is("odd_runs_on") && columns.len() % 2 == 1 {
                columns.push(target.width());
            }
            for pair in columns.chunks(2) {
                let (first, mut end) = (pair[0], pair.get(1).copied().unwrap_or(target.width()));
                if self.slip.is("end_included") {
                    end += 1;
                }
                if self.slip.is("end_one_short") {
                    end -= 1;
                }
                for x in first.max(0)..end.min(target.width()) {
                    if polygon.depth(x, y) > target.depth(x, y) {
                        target.put(shader.fragment(polygon, x, y));
                    }
                }
            }
        }
    }
}
