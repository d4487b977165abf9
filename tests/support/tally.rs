//! Compares the spans of `farop::raster::coverage` with the half-planes, and counts what was met.

use super::half_planes::{HalfPlanes, Point, Span, Ties, outline_spans, push_span};
use super::shapes::{Group, Shapes};
use farop::math::Vec3;
use farop::raster::coverage::Spans;
use farop::screen::{EdgeKind, Grid, ScreenVertex};

/// Triangles in a box of at most this many samples are tested sample by sample, others row by row.
const ONE_BY_ONE: usize = 20_000;

/// What was compared, what was met, what was wrong.
#[derive(Default)]
pub struct Tally {
    /// Triangles, alone and in groups.
    pub triangles: u64,
    /// Other outlines.
    pub outlines: u64,
    /// Covered samples.
    pub samples: u64,
    /// Ties met, and samples decided one by one.
    pub ties: Ties,
    /// Corners exactly on sample centers.
    pub corners_on_centers: u64,
    /// Edges that two triangles share.
    pub shared_edges: u64,
    /// Samples where the rasterizer and the half-planes differ.
    pub wrong: u64,
    /// Samples inside a group that none of its triangles covers.
    pub holes: u64,
    /// Samples that two triangles of a group cover.
    pub doubles: u64,
    spans: Spans,
    vertices: Vec<ScreenVertex>,
    drawn: Vec<Span>,
}

impl Tally {
    /// Whether nothing was wrong.
    pub fn is_clean(&self) -> bool {
        self.wrong + self.holes + self.doubles == 0
    }

    /// Adds what another tally counted.
    pub fn add(&mut self, other: &Tally) {
        self.triangles += other.triangles;
        self.outlines += other.outlines;
        self.samples += other.samples;
        self.ties.on_edges += other.ties.on_edges;
        self.ties.one_by_one += other.ties.one_by_one;
        self.corners_on_centers += other.corners_on_centers;
        self.shared_edges += other.shared_edges;
        self.wrong += other.wrong;
        self.holes += other.holes;
        self.doubles += other.doubles;
    }

    /// Draws until `triangles` were compared: half of them alone, half in groups, and an outline for every 20.
    pub fn run(&mut self, shapes: &mut Shapes, triangles: u64, largest: f64) {
        let goal = self.triangles + triangles;
        let mut in_groups = 0;
        while self.triangles < goal {
            if in_groups < self.triangles / 2 {
                if let Some(group) = shapes.group(largest) {
                    in_groups += group.triangles.len() as u64;
                    self.group(&group, shapes.steps);
                }
                continue;
            }
            let triangle = shapes.triangle(largest);
            self.triangle(triangle, shapes.steps);
            if shapes.random.one_in(20) {
                let outline = shapes.outline(largest);
                self.outline(&outline, shapes.steps);
            }
        }
    }

    /// Compares one triangle, corners in grid steps.
    pub fn triangle(&mut self, corners: [Point; 3], steps: i64) {
        self.draw(&corners, steps);
        self.triangles += 1;
        self.corners_on_centers += corners.iter().filter(|&&p| is_center(p, steps)).count() as u64;
        let half_planes = HalfPlanes::new(corners.map(doubled), steps);
        let (rows, columns) = half_planes.bounds();
        if rows.len() * columns.len() <= ONE_BY_ONE {
            self.wrong += half_planes.wrong_one_by_one(&self.drawn, &mut self.ties);
            return;
        }
        let mut drawn = self.drawn.iter().peekable();
        for row in rows {
            let expected = half_planes.row(row, &mut self.ties);
            let is = drawn.next_if(|(y, _)| *y == row).map_or(0..0, |(_, columns)| columns.clone());
            let both = (expected.end.min(is.end) - expected.start.max(is.start)).max(0) as usize;
            self.wrong += (expected.len() + is.len() - 2 * both) as u64;
        }
        self.wrong += drawn.map(|(_, columns)| columns.len() as u64).sum::<u64>();
    }

    /// Compares triangles that share edges one by one, and that together they cover their union once.
    pub fn group(&mut self, group: &Group, steps: i64) {
        let mut all: Vec<Span> = Vec::new();
        for &triangle in &group.triangles {
            self.triangle(triangle, steps);
            all.append(&mut self.drawn);
        }
        self.shared_edges += group.shared_edges;
        self.union(all, &group.outline, steps);
    }

    /// Compares what several polygons cover together with the inside of `outline` (grid steps).
    pub fn union(&mut self, mut all: Vec<Span>, outline: &[Point], steps: i64) {
        all.sort_unstable_by_key(|(row, columns)| (*row, columns.start));
        let mut union: Vec<Span> = Vec::new();
        for (row, columns) in all {
            let end = union.last().filter(|last| last.0 == row).map_or(columns.start, |last| last.1.end);
            self.doubles += (end.min(columns.end) - columns.start).max(0) as u64;
            if columns.end > end {
                push_span(&mut union, row, columns.start.max(end)..columns.end);
            }
        }
        let outline: Vec<Point> = outline.iter().copied().map(doubled).collect();
        let expected = outline_spans(&outline, steps, &mut self.ties);
        let both = common(&union, &expected);
        self.holes += length(&expected) - both;
        self.wrong += length(&union) - both;
    }

    /// Compares one outline of any form.
    pub fn outline(&mut self, outline: &[Point], steps: i64) {
        if outline.len() < 3 {
            return;
        }
        self.draw(outline, steps);
        self.outlines += 1;
        self.corners_on_centers += outline.iter().filter(|&&p| is_center(p, steps)).count() as u64;
        let mut drawn = Vec::new();
        self.drawn.iter().for_each(|(row, columns)| push_span(&mut drawn, *row, columns.clone()));
        let outline: Vec<Point> = outline.iter().copied().map(doubled).collect();
        let expected = outline_spans(&outline, steps, &mut self.ties);
        self.wrong += length(&expected) + length(&drawn) - 2 * common(&expected, &drawn);
    }

    /// The spans of the polygon that was compared last.
    pub fn drawn(&mut self) -> &mut Vec<Span> {
        &mut self.drawn
    }

    /// Asks the rasterizer, with one row too many on each side.
    fn draw(&mut self, corners: &[Point], steps: i64) {
        let vertex = |&(x, y): &Point| {
            let (x, y) = (x as f64 / steps as f64, y as f64 / steps as f64);
            ScreenVertex { x, y, homogeneous: Vec3::new(x, y, 1.0), edge: EdgeKind::Original }
        };
        self.vertices.clear();
        self.vertices.extend(corners.iter().map(vertex));
        let rows = -1..super::shapes::SIDE as i32 + 1;
        let drawn = &mut self.drawn;
        drawn.clear();
        let grid = Grid { bits: steps.trailing_zeros() };
        self.spans.of(&self.vertices, grid, rows, |row, columns| drawn.push((row, columns)));
        self.samples += length(drawn);
    }
}

fn doubled((x, y): Point) -> Point {
    (2 * x, 2 * y)
}

fn is_center((x, y): Point, steps: i64) -> bool {
    let is = |v: i64| (2 * v - steps).rem_euclid(2 * steps) == 0;
    is(x) && is(y)
}

fn length(spans: &[Span]) -> u64 {
    spans.iter().map(|(_, columns)| columns.len() as u64).sum()
}

/// Samples in both; spans of each sorted and disjoint.
fn common(a: &[Span], b: &[Span]) -> u64 {
    let (mut i, mut j, mut both) = (0, 0, 0);
    while let (Some((row, columns)), Some((other_row, other))) = (a.get(i), b.get(j)) {
        if row == other_row {
            both += (columns.end.min(other.end) - columns.start.max(other.start)).max(0) as u64;
        }
        if (row, columns.end) <= (other_row, other.end) { i += 1 } else { j += 1 }
    }
    both
}
