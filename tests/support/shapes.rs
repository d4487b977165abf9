//! Random triangles, fans, strips, meshes and concave outlines, on a grid, many of them exactly on sample centers.
//!
//! Space: grid steps; the picture is [`SIDE`] samples wide and high.

use super::half_planes::{Point, side};
use super::random::Random;

/// Samples across and down the picture.
pub const SIDE: i64 = 4096;

/// Triangles that share edges, and the outline of all of them together.
pub struct Group {
    /// Each with positive area, all turning the same way.
    pub triangles: Vec<[Point; 3]>,
    /// Where the union ends.
    pub outline: Vec<Point>,
    /// Edges that two of the triangles share.
    pub shared_edges: u64,
}

/// Makes shapes on a grid of `steps` steps a sample.
pub struct Shapes {
    /// The source of randomness.
    pub random: Random,
    /// Grid steps a sample.
    pub steps: i64,
}

impl Shapes {
    /// A box of random size, log-uniform up to the picture: its upper left corner and its side, in steps.
    fn place(&mut self, largest: f64) -> (Point, i64) {
        let size = largest.powf(self.random.unit()) * self.steps as f64;
        let size = (size as i64).max(1);
        let room = SIDE * self.steps - size;
        ((self.random.whole(0, room), self.random.whole(0, room)), size)
    }

    fn point_in(&mut self, (origin, size): (Point, i64)) -> Point {
        (origin.0 + self.random.whole(0, size), origin.1 + self.random.whole(0, size))
    }

    /// The sample center (for a grid of whole samples: the corner) at or before a point.
    fn to_center(&self, (x, y): Point) -> Point {
        let snap = |v: i64| (v.div_euclid(self.steps) * self.steps + self.steps / 2).min(SIDE * self.steps);
        (snap(x), snap(y))
    }

    fn inside(&self, (x, y): Point) -> Point {
        (x.clamp(0, SIDE * self.steps), y.clamp(0, SIDE * self.steps))
    }

    /// One triangle: anywhere, on centers, with edges through many centers, along rows and columns of centers, or a sliver.
    pub fn triangle(&mut self, largest: f64) -> [Point; 3] {
        let place = self.place(largest);
        let free = [self.point_in(place), self.point_in(place), self.point_in(place)];
        let kind = self.random.whole(0, 5);
        let corner = self.to_center(free[0]);
        let across = (place.1 / self.steps).max(1);
        let triangle = match kind {
            0 | 1 => free,
            2 => free.map(|p| self.to_center(p)),
            3 => {
                // Small whole directions: such an edge passes through a center every few samples.
                let mut far = || {
                    let (dx, dy) = (self.random.whole(-3, 3), self.random.whole(-3, 3));
                    let length = self.random.whole(1, across);
                    (corner.0 + dx * length * self.steps, corner.1 + dy * length * self.steps)
                };
                let (second, third) = (far(), far());
                [corner, self.inside(second), self.inside(third)]
            }
            4 => {
                let (width, height) = (self.random.whole(1, across), self.random.whole(1, across));
                let (right, low) = (corner.0 + width * self.steps, corner.1 + height * self.steps);
                [corner, self.inside((right, corner.1)), self.inside((corner.0, low))]
            }
            _ => {
                let [a, b, _] = free;
                let t = self.random.whole(0, 1024);
                let mut beside = |a: i64, b: i64| a + (b - a) * t / 1024 + self.random.whole(-2, 2);
                let third = (beside(a.0, b.0), beside(a.1, b.1));
                [a, b, self.inside(third)]
            }
        };
        if self.random.one_in(2) { [triangle[0], triangle[2], triangle[1]] } else { triangle }
    }

    /// A fan, a strip or a mesh; `None` when rounding turned one of its triangles round.
    pub fn group(&mut self, largest: f64) -> Option<Group> {
        let place = self.place(largest);
        let on_centers = self.random.one_in(2);
        let kind = self.random.whole(0, 2);
        let (rows, columns, points) = match kind {
            0 => return self.fan(place, on_centers),
            1 => (1, self.random.whole(1, 30) as usize),
            _ => (self.random.whole(2, 8) as usize, self.random.whole(2, 8) as usize),
        }
        .into_points(self, place, on_centers);
        self.mesh(rows, columns, &points)
    }

    fn fan(&mut self, (origin, size): (Point, i64), on_centers: bool) -> Option<Group> {
        let count = self.random.whole(3, 24) as usize;
        let half = size as f64 / 2.0;
        let middle = (origin.0 + size / 2, origin.1 + size / 2);
        let mut ring: Vec<Point> = (0..count)
            .map(|i| {
                let angle = (i as f64 + self.random.between(0.0, 0.9)) / count as f64 * std::f64::consts::TAU;
                let radius = half * self.random.between(0.3, 1.0);
                (middle.0 + (radius * angle.cos()) as i64, middle.1 + (radius * angle.sin()) as i64)
            })
            .collect();
        let mut hub = middle;
        if on_centers {
            ring.iter_mut().for_each(|p| *p = self.to_center(*p));
            hub = self.to_center(hub);
        }
        let triangles = (0..count).map(|i| [hub, ring[i], ring[(i + 1) % count]]).collect();
        Group { triangles, outline: ring, shared_edges: count as u64 }.checked()
    }

    /// Two triangles a cell, cut along one or the other diagonal.
    fn mesh(&mut self, rows: usize, columns: usize, points: &[Point]) -> Option<Group> {
        let at = |row: usize, column: usize| points[row * (columns + 1) + column];
        let mut triangles = Vec::new();
        for row in 0..rows {
            for column in 0..columns {
                let [a, b] = [at(row, column), at(row, column + 1)];
                let [d, c] = [at(row + 1, column), at(row + 1, column + 1)];
                let halves = if self.random.one_in(2) { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] };
                triangles.extend(halves);
            }
        }
        let mut outline: Vec<Point> = (0..columns).map(|column| at(0, column)).collect();
        outline.extend((0..rows).map(|row| at(row, columns)));
        outline.extend((1..=columns).rev().map(|column| at(rows, column)));
        outline.extend((1..=rows).rev().map(|row| at(row, 0)));
        let shared_edges = (rows * columns + rows * (columns - 1) + columns * (rows - 1)) as u64;
        Group { triangles, outline, shared_edges }.checked()
    }

    /// A simple outline with many notches, a comb, or one that crosses itself.
    pub fn outline(&mut self, largest: f64) -> Vec<Point> {
        let place = self.place(largest);
        let on_centers = self.random.one_in(2);
        let count = self.random.whole(3, 16) as usize;
        let mut outline: Vec<Point> = match self.random.whole(0, 2) {
            0 => (0..count).map(|_| self.point_in(place)).collect(),
            1 => self.fan(place, false).map_or_else(Vec::new, |group| group.outline),
            _ => {
                let (origin, size) = place;
                let tooth = |i: usize| origin.0 + size * i as i64 / (2 * count) as i64;
                let bar = origin.1 + size / 4;
                let mut comb = vec![(tooth(2 * count), origin.1), (origin.0, origin.1)];
                comb.extend((0..2 * count).map(|i| (tooth(i), if i % 2 == 0 { origin.1 + size } else { bar })));
                comb
            }
        };
        if on_centers {
            outline.iter_mut().for_each(|p| *p = self.to_center(*p));
        }
        if self.random.one_in(2) {
            outline.reverse();
        }
        outline
    }
}

/// Rows and columns of cells, with their corners shaken.
trait IntoPoints {
    fn into_points(self, shapes: &mut Shapes, place: (Point, i64), on_centers: bool) -> (usize, usize, Vec<Point>);
}

impl IntoPoints for (usize, usize) {
    fn into_points(self, shapes: &mut Shapes, place: (Point, i64), on_centers: bool) -> (usize, usize, Vec<Point>) {
        let ((rows, columns), (origin, size)) = (self, place);
        let cell = |count: usize| size as f64 / (count as f64 + 1.0);
        let mut points = Vec::new();
        for row in 0..=rows {
            for column in 0..=columns {
                let mut along =
                    |i: usize, count: usize| ((i as f64 + 0.5 + shapes.random.between(-0.3, 0.3)) * cell(count)) as i64;
                let p = (origin.0 + along(column, columns), origin.1 + along(row, rows));
                points.push(if on_centers { shapes.to_center(p) } else { p });
            }
        }
        (rows, columns, points)
    }
}

impl Group {
    /// Itself, if all triangles turn the same way: then the union is covered exactly once.
    fn checked(self) -> Option<Group> {
        self.triangles.iter().all(|&[a, b, c]| side(a, b, c) > 0).then_some(self)
    }
}
