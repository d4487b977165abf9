//! Relief: the triangles of the terrain that one frame needs.
//!
//! Terrain, eye -RELIEF-> leaves -> faces over shared corners
//!
//! A diamond is halved where its error would show as more than the tolerance, seen from the nearest point of its sphere; and, within
//! the horizon of the trees, until it lies in one cell, because that is what wears one picture; and, where borders between covers are kept, until
//! it crosses none by more than the tolerance. What is out of view stays coarse. Nothing is kept
//! from frame to frame: a few thousand triangles are found from the roots faster than two queues are sorted, and the mesh depends on the eye
//! alone.
//!
//! Space: lattice points; metres from the south-west corner of the area until the faces, which are in world metres.
//! Source: P. Lindstrom, V. Pascucci, "Visualization of Large Terrains Made Easy", IEEE Visualization 2001. Cost: a root a triangle.

use super::{Kind, Terrain};
use crate::color::Rgb;
use crate::forest::area::CellIndex;
use crate::forest::relief::criterion::{Criterion, Observer};
use crate::forest::relief::lattice::{Lattice, Point, Triangle};
use crate::forest::relief::mesh::{Vertex, clipped, for_each_leaf, turn};
use crate::math::Vec3;

/// Who looks at the relief.
#[derive(Clone, Copy, Debug)]
pub struct View {
    /// The eye, world metres, and what it sees.
    pub observer: Observer,
    /// The error that may show, in pixels; above 0.
    pub tolerance: f64,
    /// Cells nearer than this, in metres, have triangles of their own.
    pub near: f64,
}

/// A face: a part of a triangle, and the cell whose picture it wears.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Face {
    /// Where its outline begins in [`Faces::outlines`].
    pub start: u32,
    /// Corners.
    pub count: u32,
    /// `None`: it lies in several cells or far away.
    pub cell: Option<CellIndex>,
    /// The ground that all of it wears, numbered as in [`cover::raster`](crate::forest::cover::raster), where borders are kept and it is near.
    pub cover: Option<u8>,
}

/// A corner of faces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner {
    /// World metres.
    pub position: Vec3,
    /// Of the samples around it, whatever triangles there are.
    pub normal: Vec3,
    /// What it looks like from afar.
    pub color: Rgb,
}

/// The relief of one frame. Memory is kept for the next.
#[derive(Clone, Debug, Default)]
pub struct Faces {
    /// Each once.
    pub corners: Vec<Corner>,
    /// Of all faces, as indices into `corners`; counterclockwise seen from above.
    pub outlines: Vec<u32>,
    /// Along the Sierpinski curve.
    pub faces: Vec<Face>,
    /// Metres within which every wrong cover of a near face in view is from a border.
    pub border_error: Option<f64>,
    /// Index + 1 of the corner at each sample, 0: none; and which are not 0.
    index: Vec<u32>,
    used: Vec<u32>,
}

impl Faces {
    /// The outline of a face.
    #[must_use]
    pub fn outline(&self, face: &Face) -> &[u32] {
        &self.outlines[face.start as usize..(face.start + face.count) as usize]
    }

    fn clear(&mut self, samples: usize) {
        self.index.resize(samples, 0);
        self.used.drain(..).for_each(|at| self.index[at as usize] = 0);
        self.corners.clear();
        self.outlines.clear();
        self.faces.clear();
        self.border_error = None;
    }
}

/// How much a diamond wants to be halved.
struct Score<'a> {
    terrain: &'a Terrain,
    view: View,
    /// The eye, from the south-west corner of the area.
    eye: Vec3,
}

impl Score<'_> {
    /// The sphere around a diamond that holds it and all below, from the south-west corner of the area.
    fn sphere(&self, middle: Point) -> (Vec3, f64) {
        (self.center(middle), f64::from(self.terrain.radii.at(middle)))
    }

    /// Whether some of a triangle may be in view.
    fn is_seen(&self, triangle: &Triangle) -> bool {
        // The smallest have no diamond of their own.
        let (center, radius) = self.sphere(if triangle.can_be_halved() { triangle.middle() } else { triangle.apex });
        self.view.observer.sees(center - self.eye + self.view.observer.eye, radius)
    }

    /// Whether a diamond, if nearby, crosses a border by too much.
    fn crosses(&self, middle: Point) -> bool {
        let borders = self.terrain.borders.as_ref();
        borders.is_some_and(|(borders, tolerance)| f64::from(borders.bound(middle)) > *tolerance)
    }

    fn center(&self, middle: Point) -> Vec3 {
        let terrain = self.terrain;
        let Point { x, y } = terrain.lattice.nearest(middle);
        let height = f64::from(terrain.grid.height(x as usize, y as usize));
        let (x, y) = (f64::from(middle.x), f64::from(terrain.lattice.south) - f64::from(middle.y));
        Vec3::new(x * terrain.step(), y * terrain.step(), height)
    }
}

impl Criterion for Score<'_> {
    fn score(&self, middle: Point) -> f64 {
        let View { observer, tolerance, near } = self.view;
        let bound = f64::from(self.terrain.bounds.at(middle));
        let is_large = 2 * Lattice::reach(middle) as usize > self.terrain.squares;
        let crosses = self.crosses(middle);
        if bound == 0.0 && !is_large && !crosses {
            return 0.0;
        }
        let (center, radius) = self.sphere(middle);
        if !observer.sees(center - self.eye + observer.eye, radius) {
            return 0.0;
        }
        let distance = ((center - self.eye).length() - radius).max(0.0);
        // On the map, as the horizon is measured: an eye high above still looks at single cells. A cell that is near in one corner wears
        // covers in all others, too.
        let away = (center - self.eye).truncate().length() - radius;
        if is_large && away < near || crosses && away < near + 2.0_f64.sqrt() * self.terrain.side {
            return f64::INFINITY;
        }
        if bound == 0.0 { 0.0 } else { bound * observer.focal / (distance * tolerance) }
    }
}

impl Terrain {
    /// Finds the faces of one frame.
    pub fn faces(&self, view: &View, faces: &mut Faces) {
        faces.clear(self.grid.heights().len());
        let [west, south] = self.origin();
        let score = Score { terrain: self, view: *view, eye: view.observer.eye - Vec3::new(west, south, 0.0) };
        // What touches no sample is never halved: it is not drawn.
        let is_halved = |triangle: &Triangle| {
            let middle = triangle.middle();
            self.lattice.touches(middle) && score.score(middle) > 1.0
        };
        for_each_leaf(&self.lattice, &is_halved, &mut |triangle| self.add(triangle, &score, faces));
    }

    fn add(&self, triangle: &Triangle, score: &Score<'_>, faces: &mut Faces) {
        let Some(cell) = self.cell_for(triangle, score) else { return };
        let Triangle { a, b, apex } = *triangle;
        let corners = if turn(a, b, apex) > 0 { [b, a, apex] } else { [a, b, apex] };
        let corners = corners.map(|point| {
            let Point { x, y } = self.lattice.nearest(point);
            Vertex { point, height: f64::from(self.grid.height(x as usize, y as usize)) }
        });
        let is_inside = corners.iter().all(|corner| corner.point == self.lattice.nearest(corner.point));
        let start = faces.outlines.len() as u32;
        if is_inside {
            corners.iter().for_each(|corner| self.push(corner, faces));
        } else {
            let outline = clipped(&self.lattice, &corners);
            if outline.len() >= 3 {
                outline.iter().for_each(|corner| self.push(corner, faces));
            }
        }
        let count = faces.outlines.len() as u32 - start;
        if count >= 3 {
            let kept = self.borders.as_ref().filter(|_| cell.is_some()).map(|(borders, _)| borders);
            if let Some(borders) = kept.filter(|_| score.is_seen(triangle)) {
                let error = borders.promise(std::iter::once(triangle));
                faces.border_error = Some(faces.border_error.unwrap_or(0.0).max(error));
            }
            faces.faces.push(Face { start, count, cell, cover: kept.map(|borders| borders.cover(triangle)) });
        }
    }

    /// The cell whose picture a triangle wears, if it wears one; `None` where it is not drawn.
    fn cell_for(&self, triangle: &Triangle, score: &Score<'_>) -> Option<Option<CellIndex>> {
        let points = [triangle.a, triangle.b, triangle.apex];
        let [west, east] = self.span(points.map(|point| point.x), self.size[0]);
        let [north, south] = self.span(points.map(|point| point.y), self.size[1]);
        let mut all = (west..east).flat_map(|column| (north..south).map(move |row| (column, row)));
        let at = |(column, row): (usize, usize)| self.cell_of(column * self.squares, row * self.squares);
        if east - west > 1 || south - north > 1 {
            return all.any(|cell| self.outlines[at(cell).1].kind != Kind::Missing).then_some(None);
        }
        let (index, place) = at((west, north));
        match self.outlines[place].kind {
            Kind::Missing => None,
            Kind::Mesh if self.is_near(index, score) => None,
            _ => Some(self.is_near(index, score).then_some(index)),
        }
    }

    fn is_near(&self, index: CellIndex, score: &Score<'_>) -> bool {
        distance_to_cell(index, self.side, score.view.observer.eye) < score.view.near
    }

    /// Adds a corner to the outline in hand.
    fn push(&self, vertex: &Vertex, faces: &mut Faces) {
        let (x, y) = (vertex.point.x as usize, vertex.point.y as usize);
        let at = y * self.grid.columns() + x;
        if faces.index[at] == 0 {
            let [west, south] = self.origin();
            let up = f64::from(self.lattice.south - vertex.point.y);
            let position = Vec3::new(west + x as f64 * self.step(), south + up * self.step(), vertex.height);
            faces.corners.push(Corner { position, normal: self.normal(x, y), color: self.color(x, y) });
            faces.index[at] = faces.corners.len() as u32;
            faces.used.push(at as u32);
        }
        faces.outlines.push(faces.index[at] - 1);
    }
}

/// Metres on the map from an eye to the nearest point of a cell; 0 over it.
#[must_use]
pub fn distance_to_cell(index: CellIndex, side: f64, eye: Vec3) -> f64 {
    let away = |index: i32, at: f64| {
        let low = f64::from(index) * side;
        (low - at).max(at - low - side).max(0.0)
    };
    let (x, y) = (away(index[0], eye.x), away(index[1], eye.y));
    (x * x + y * y).sqrt()
}
