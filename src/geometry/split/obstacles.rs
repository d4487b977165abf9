//! Obstacles: the corners that can spoil an ear, found by place.
//!
//! An ear of a polygon contains another vertex only if it contains one whose corner is not convex (the one farthest
//! from the diagonal: the polygon lies on its far side, so its corner opens by half a turn or more). So only those
//! corners stand in the way. Cutting ears makes them convex, and they step aside; cutting a spike may bring one back.
//!
//! Why a tree of boxes: a long comb has half a million such corners, and asking each of them about each ear would
//! take hours. A grid is no help where all points crowd into few cells, and its cell size overflows at the
//! extremes of `f64`; a k-d tree only compares coordinates. Every node counts the corners still standing, so a star
//! whose center has become convex costs nothing.
//!
//! Boxes stand upright, and a row of vertices at a slant fills boxes that every long ear beside it meets. So a large outline
//! is first turned until most of its length runs along an axis. That rounds, and boxes grow by as much: they only say
//! what need not be looked at.
//!
//! Space: the plane of the polygon, counterclockwise; in large outlines turned.
//! Sources: J. L. Bentley, "Multidimensional Binary Search Trees Used for Associative Searching", CACM 18(9), 1975.
//! Cost: O(n log n) to build for n vertices, O(log n) a change, about O(log n) a question.

use crate::geometry::predicates::{Orientation, orientation};
use crate::math::{Vec2, edges};

/// The vertices of one polygon in a k-d tree that tells which of them stand in the way. Its memory is reused.
#[derive(Debug, Default)]
pub(super) struct Obstacles {
    /// Vertices with their places, each leaf a contiguous run.
    points: Vec<(Vec2, u32)>,
    /// The nodes by level, the root first: node i has the children 2i + 1 and 2i + 2.
    nodes: Vec<Node>,
    /// What is known of each vertex, by index.
    vertices: Vec<Vertex>,
    /// Levels below the root.
    depth: u32,
    /// The direction that became the x axis, and what turning may have moved points by; `None` where nothing was turned.
    turn: Option<(Vec2, f64)>,
}

#[derive(Clone, Copy, Debug, Default)]
struct Vertex {
    point: Vec2,
    leaf: u32,
    stands: bool,
}

/// The vertices of a part of the plane.
#[derive(Clone, Copy, Debug, Default)]
struct Node {
    low: Vec2,
    high: Vec2,
    /// How many of them stand in the way.
    standing: u32,
}

const EMPTY: Node = Node { low: Vec2::INFINITY, high: Vec2::NEG_INFINITY, standing: 0 };
/// Outlines with fewer vertices are not turned: there is nothing to gain.
const LARGE: usize = 10_000;
/// Up to this many vertices in a leaf.
const LEAF: usize = 8;

impl Obstacles {
    /// Starts anew without any.
    pub(super) fn clear(&mut self) {
        self.nodes.clear();
        self.vertices.clear();
    }

    /// Starts anew with the vertices of a polygon in order; none stands in the way yet.
    pub(super) fn gather(&mut self, vertices: impl Iterator<Item = Vec2>) {
        self.clear();
        self.points.clear();
        self.points.extend(vertices.zip(0..));
        self.turn = if self.points.len() < LARGE { None } else { main_direction(&self.points) };
        if let Some((direction, _)) = self.turn {
            self.points.iter_mut().for_each(|(point, _)| *point = turned(*point, direction));
        }
        self.vertices.resize(self.points.len(), Vertex::default());
        self.depth = self.points.len().div_ceil(LEAF).next_power_of_two().ilog2();

        // Halve every part across its longer side, level by level.
        for level in 0..=self.depth {
            for part in 0..1_usize << level {
                let (start, end) = self.run(level, part);
                self.nodes.push(EMPTY);
                if level == self.depth {
                    self.settle(start, end);
                } else {
                    let middle = self.run(level + 1, 2 * part + 1).0 - start;
                    let size = extent(&self.points[start..end]);
                    let coordinate = |p: &(Vec2, u32)| if size.x > size.y { p.0.x } else { p.0.y };
                    self.points[start..end]
                        .select_nth_unstable_by(middle, |a, b| coordinate(a).total_cmp(&coordinate(b)));
                }
            }
        }
    }

    /// The run of points that belongs to a part of a level.
    fn run(&self, level: u32, part: usize) -> (usize, usize) {
        let edge = |i: usize| (self.points.len() * i) >> level;
        (edge(part), edge(part + 1))
    }

    /// Notes the leaf pushed last as the place of these points.
    fn settle(&mut self, start: usize, end: usize) {
        for &(point, vertex) in &self.points[start..end] {
            self.vertices[vertex as usize] = Vertex { point, leaf: self.nodes.len() as u32 - 1, stands: false };
        }
    }

    /// Whether a vertex stands in the way.
    pub(super) fn stands(&self, vertex: u32) -> bool {
        self.vertices.get(vertex as usize).is_some_and(|known| known.stands)
    }

    /// Says whether a vertex stands in the way from now on. Ignored if nothing was gathered.
    pub(super) fn set(&mut self, vertex: u32, stands: bool) {
        let Some(known) = self.vertices.get_mut(vertex as usize).filter(|known| known.stands != stands) else { return };
        known.stands = stands;
        let point = known.point;
        let mut index = known.leaf as usize;
        loop {
            let node = &mut self.nodes[index];
            if stands {
                node.standing += 1;
                (node.low, node.high) = (node.low.min(point), node.high.max(point));
            } else {
                node.standing -= 1;
            }
            if index == 0 {
                break;
            }
            index = (index - 1) / 2;
        }
    }

    /// Shows the vertices that may lie within `margin` of a counterclockwise `triangle` to `visit`, until it answers false.
    pub(super) fn visit_near(&self, triangle: &[Vec2; 3], margin: f64, mut visit: impl FnMut(u32) -> bool) {
        if !self.nodes.is_empty() {
            let near = match self.turn {
                None => Near::new(*triangle, margin),
                Some((direction, moved)) => {
                    let triangle = triangle.map(|point| turned(point, direction));
                    // A sliver that rounding turned over has no sides to go by.
                    let [a, b, c] = triangle;
                    let has_sides = orientation(a, b, c) == Orientation::Counterclockwise;
                    Near { has_sides, ..Near::new(triangle, margin * 2.0 + moved) }
                }
            };
            self.visit_below(0, &near, &mut visit);
        }
    }

    fn visit_below(&self, index: usize, near: &Near, visit: &mut impl FnMut(u32) -> bool) -> bool {
        let node = &self.nodes[index];
        if node.standing == 0 || near.is_apart(node) {
            return true;
        }
        let first_leaf = (1_usize << self.depth) - 1;
        if index < first_leaf {
            return self.visit_below(2 * index + 1, near, visit) && self.visit_below(2 * index + 2, near, visit);
        }
        let (start, end) = self.run(self.depth, index - first_leaf);
        let mut standing = self.points[start..end].iter().filter(|point| self.vertices[point.1 as usize].stands);
        standing.all(|&(_, vertex)| visit(vertex))
    }
}

/// The size of the box around a run of points.
fn extent(points: &[(Vec2, u32)]) -> Vec2 {
    let low = points.iter().fold(Vec2::INFINITY, |low, &(point, _)| low.min(point));
    let high = points.iter().fold(Vec2::NEG_INFINITY, |high, &(point, _)| high.max(point));
    high - low
}

/// `point` in axes of which the first runs along `direction`, a unit vector.
fn turned(point: Vec2, direction: Vec2) -> Vec2 {
    Vec2::new(point.dot(direction), direction.perp_dot(point))
}

/// The direction, up to quarter turns, along which an outline runs for most of its length, and by how much turning it there may
/// move points against each other. `None` where that is an axis anyway, or coordinates leave the range.
fn main_direction(outline: &[(Vec2, u32)]) -> Option<(Vec2, f64)> {
    let largest = outline.iter().fold(0.0, |largest: f64, (p, _)| largest.max(p.abs().max_element()));
    let scale = crate::math::ordinary_scale(largest);
    // Four times the angle is the same for all four quarter turns: lengths with that angle add up or cancel.
    let square = |v: Vec2| Vec2::new(v.x * v.x - v.y * v.y, 2.0 * v.x * v.y);
    let fourfold = |(a, b): (&(Vec2, u32), &(Vec2, u32))| {
        let along = (b.0 - a.0) * scale;
        along.try_normalize().map_or(Vec2::ZERO, |unit| square(square(unit)) * along.length())
    };
    let sum = edges(outline).map(fourfold).sum::<Vec2>().try_normalize()?;
    let half = |v: Vec2| {
        let cosine = ((1.0 + v.x) / 2.0).max(0.0).sqrt();
        if cosine > 0.0 { Vec2::new(cosine, v.y / (2.0 * cosine)) } else { Vec2::Y }
    };
    let direction = half(half(sum)).try_normalize()?;
    // Two products and a sum, each within half a last place of twice the largest coordinate; for two points, doubled.
    (direction.y.abs() > 1e-3).then_some((direction, largest * 16.0 * f64::EPSILON))
}

/// A triangle and what lies within a margin of it.
struct Near {
    triangle: [Vec2; 3],
    margin: f64,
    low: Vec2,
    high: Vec2,
    /// It is counterclockwise.
    has_sides: bool,
}

impl Near {
    fn new(triangle: [Vec2; 3], margin: f64) -> Near {
        let [a, b, c] = triangle;
        Near { triangle, margin, low: a.min(b).min(c) - margin, high: a.max(b).max(c) + margin, has_sides: true }
    }

    /// Whether a box lies outside, as far as the sides of box and triangle can tell. Never wrong with true.
    fn is_apart(&self, node: &Node) -> bool {
        if self.low.cmpgt(node.high).any() || self.high.cmplt(node.low).any() {
            return true;
        }
        if !self.has_sides || (self.low.cmpge(node.low).all() && self.high.cmple(node.high).all()) {
            return false;
        }
        // The box is off an edge when even the corner farthest to the left of the edge is to its right.
        let (low, high) = (node.low - self.margin, node.high + self.margin);
        let [a, b, c] = self.triangle;
        [(a, b), (b, c), (c, a)].into_iter().any(|(from, to)| {
            let x = if to.y > from.y { low.x } else { high.x };
            let y = if to.x > from.x { high.y } else { low.y };
            orientation(from, to, Vec2::new(x, y)) == Orientation::Clockwise
        })
    }
}
