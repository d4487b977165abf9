//! Watkins' way: edges wait in buckets, live in an active list, step from line to line by quotient and remainder; where
//! segments overlap, a span is halved until its two ends agree. Every sample is put once.

use super::Slip;
use farop::color::Rgb;
use farop::raster::{Rasterizer, Target};
use farop::screen::{DrawList, ScreenPolygon};

pub struct Spans {
    pub slip: Slip,
}

/// An edge that crosses the line: first column at or right of it is `column`; `rest` / `whole` of a column is what was rounded up.
#[derive(Clone)]
struct Active {
    polygon: usize,
    first_row: i64,
    end_row: i64,
    column: i64,
    rest: i64,
    step: i64,
    step_rest: i64,
    whole: i64,
}

/// What one polygon covers of a line.
#[derive(Clone, Copy)]
struct Segment {
    first: i64,
    end: i64,
    polygon: usize,
}

fn ceil(numerator: i64, divisor: i64) -> i64 {
    -(-numerator).div_euclid(divisor)
}

/// The edges of a polygon, as they are on their first line. Level ones have none.
fn edges_of(polygon: &ScreenPolygon<'_>, number: usize) -> Vec<Active> {
    let half = polygon.grid().steps();
    let at: Vec<(i64, i64)> =
        polygon.vertices().iter().map(|v| (polygon.grid().fixed(v.x) * 2, polygon.grid().fixed(v.y) * 2)).collect();
    let mut edges = Vec::new();
    for (n, &a) in at.iter().enumerate() {
        let b = at[(n + 1) % at.len()];
        let ((x, y), (xl, yl)) = if a.1 < b.1 { (a, b) } else { (b, a) };
        let (first_row, end_row) = (ceil(y - half, 2 * half), ceil(yl - half, 2 * half));
        if first_row >= end_row {
            continue;
        }
        let (dx, dy) = (xl - x, yl - y);
        let whole = 2 * half * dy;
        let numerator = (x - half) * dy + dx * ((2 * first_row + 1) * half - y);
        let column = ceil(numerator, whole);
        let step = (dx * 2 * half).div_euclid(whole);
        edges.push(Active {
            polygon: number,
            first_row,
            end_row,
            column,
            rest: column * whole - numerator,
            step,
            step_rest: dx * 2 * half - step * whole,
            whole,
        });
    }
    edges
}

impl Spans {
    fn advance(&self, edge: &mut Active) {
        edge.column += edge.step;
        if self.slip.is("remainder_lost") {
            return;
        }
        edge.rest -= edge.step_rest;
        if edge.rest < 0 {
            edge.rest += edge.whole;
            if !self.slip.is("carry_lost") {
                edge.column += 1;
            }
        }
    }

    /// The number of the nearest of these polygons at a sample; of equals the first.
    fn nearest(&self, polygons: &[ScreenPolygon<'_>], among: &[usize], x: i64, y: i64) -> usize {
        let depth = |p: usize| match self.slip.0.as_str() {
            "depth_at_a_corner" => 1.0 / polygons[p].vertices()[0].homogeneous.z,
            "depth_of_the_line_above" => polygons[p].depth(x as i32, y as i32 - 1),
            "depth_of_column_0" => polygons[p].depth(0, y as i32),
            _ => polygons[p].depth(x as i32, y as i32),
        };
        let mut best = among[0];
        for &other in &among[1..] {
            let wins = match self.slip.0.as_str() {
                "first_in_list" => other < best,
                "last_in_list" => other > best,
                "far_wins" => depth(other) < depth(best),
                "last_of_equals" => depth(other) >= depth(best),
                _ => depth(other) > depth(best),
            };
            if wins {
                best = other;
            }
        }
        best
    }

    /// Puts a span in which the same polygons overlap everywhere.
    fn show(&self, scene: &Scene<'_, '_>, among: &[usize], (first, last): (i64, i64), y: i64, target: &mut Target<'_>) {
        let winner_at = |x| self.nearest(&scene.polygons, among, x, y);
        let (left, right) = (winner_at(first), winner_at(last));
        let chosen = match self.slip.0.as_str() {
            "left_end_decides" => Some(left),
            "right_end_decides" => Some(right),
            "middle_decides" => Some(winner_at((first + last) / 2)),
            _ if left == right => Some(left),
            _ => None,
        };
        if let Some(winner) = chosen {
            for x in first..=last {
                scene.put(target, winner, (x, y));
            }
            return;
        }
        let middle = (first + last) / 2;
        if self.slip.is("halved_once") {
            for x in first..=last {
                scene.put(target, if x <= middle { left } else { right }, (x, y));
            }
            return;
        }
        if self.slip.is("middle_lost") {
            if middle > first {
                self.show(scene, among, (first, middle - 1), y, target);
            }
            return self.show(scene, among, (middle + 1, last), y, target);
        }
        self.show(scene, among, (first, middle), y, target);
        self.show(scene, among, (middle + 1, last), y, target);
    }

    fn segments(&self, active: &[Active], width: i64) -> Vec<Segment> {
        let mut segments = Vec::new();
        let mut at = 0;
        while at < active.len() {
            let polygon = active[at].polygon;
            let own = active[at..].iter().take_while(|edge| edge.polygon == polygon).count();
            let columns: Vec<i64> = active[at..at + own].iter().map(|edge| edge.column.clamp(0, width)).collect();
            for pair in columns.chunks(2) {
                let end = pair.get(1).copied().unwrap_or(width);
                if pair[0] < end {
                    segments.push(Segment { first: pair[0], end, polygon });
                }
            }
            at += own;
        }
        segments
    }

    fn line(&self, scene: &Scene<'_, '_>, segments: &[Segment], y: i64, target: &mut Target<'_>) {
        if self.slip.is("z_buffer_of_a_line") {
            for segment in segments {
                for x in segment.first..segment.end {
                    let (xi, yi) = (x as i32, y as i32);
                    if scene.polygons[segment.polygon].depth(xi, yi) > target.depth(xi, yi) {
                        scene.put(target, segment.polygon, (x, y));
                    }
                }
            }
            return;
        }
        if self.slip.is("painter") {
            let mean = |p: usize| {
                let corners = scene.polygons[p].vertices();
                corners.iter().map(|corner| corner.homogeneous.z).sum::<f64>() / corners.len() as f64
            };
            let mut sorted = segments.to_vec();
            sorted.sort_by(|a, b| mean(b.polygon).total_cmp(&mean(a.polygon)).then(b.polygon.cmp(&a.polygon)));
            for segment in sorted {
                (segment.first..segment.end).for_each(|x| scene.put(target, segment.polygon, (x, y)));
            }
            return;
        }
        let mut events: Vec<i64> = segments.iter().flat_map(|segment| [segment.first, segment.end]).collect();
        if self.slip.is("ends_cut_nothing") {
            events = segments.iter().map(|segment| segment.first).collect();
            events.extend(segments.iter().map(|segment| segment.end).max());
        }
        events.sort_unstable();
        events.dedup();
        let mut pairs: Vec<(i64, i64)> = events.windows(2).map(|pair| (pair[0], pair[1])).collect();
        if self.slip.is("last_span_lost") {
            pairs.pop();
        }
        // Glass does not compete: the target keeps it apart.
        let is_glass = |p: usize| scene.list.shader.opacity(&scene.polygons[p]) != Rgb::gray(1.0);
        for segment in segments.iter().filter(|segment| is_glass(segment.polygon)) {
            (segment.first..segment.end).for_each(|x| scene.put(target, segment.polygon, (x, y)));
        }
        for (first, end) in pairs {
            let covers =
                |segment: &&Segment| segment.first <= first && first < segment.end && !is_glass(segment.polygon);
            let among: Vec<usize> = segments.iter().filter(covers).map(|segment| segment.polygon).collect();
            let last = if self.slip.is("span_one_short") { end - 2 } else { end - 1 };
            if !among.is_empty() && first <= last {
                self.show(scene, &among, (first, last), y, target);
            }
        }
    }
}

struct Scene<'list, 'a> {
    list: &'list DrawList,
    polygons: Vec<ScreenPolygon<'a>>,
}

impl Scene<'_, '_> {
    fn put(&self, target: &mut Target<'_>, polygon: usize, (x, y): (i64, i64)) {
        target.put(self.list.shader.fragment(&self.polygons[polygon], x as i32, y as i32));
    }
}

impl Rasterizer for Spans {
    fn draw(&self, list: &DrawList, target: &mut Target<'_>) {
        let scene = Scene { list, polygons: list.polygons().collect() };
        let mut waiting: Vec<Active> =
            scene.polygons.iter().enumerate().flat_map(|(number, polygon)| edges_of(polygon, number)).collect();
        let mut active: Vec<Active> = Vec::new();
        for y in 0..i64::from(target.height()) {
            if !self.slip.is("finished_edges_stay") {
                let late = i64::from(self.slip.is("edges_end_late"));
                active.retain(|edge| edge.end_row + late > y);
            }
            let (starting, rest) = waiting.into_iter().partition(|edge| edge.first_row <= y);
            waiting = rest;
            let starting: Vec<Active> = starting;
            let is_late = self.slip.is("edges_start_late");
            if !is_late {
                for edge in &starting {
                    let before = |other: &Active| (other.polygon, other.column) <= (edge.polygon, edge.column);
                    let place = active.iter().take_while(|other| before(other)).count();
                    active.insert(place, edge.clone());
                }
            }
            if !self.slip.is("not_sorted_again") {
                active.sort_by_key(|edge| (edge.polygon, edge.column));
            }
            if self.slip.is("step_before_drawing") {
                active.iter_mut().for_each(|edge| self.advance(edge));
            }
            let segments = self.segments(&active, i64::from(target.width()));
            self.line(&scene, &segments, y, target);
            if is_late {
                active.extend(starting);
            }
            if !self.slip.is("step_before_drawing") {
                active.iter_mut().for_each(|edge| self.advance(edge));
            }
        }
    }
}
