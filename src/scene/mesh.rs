//! The polygons of one surface over one list of shared vertices.
//!
//! Why flat arrays and no object per polygon: a million polygons then cost four allocations, and the geometry
//! stage transforms, classifies and lights every shared vertex once.

use crate::color::Rgb;
use crate::math::Vec3;

/// Polygons over a shared list of vertices. A part of a scene, or the polygons that a sphere was turned into.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Positions, local space.
    pub vertices: Vec<Vec3>,
    /// Given unit normals, one a vertex; empty where no polygon of the mesh has any. Zero: none given at this vertex.
    pub normals: Vec<Vec3>,
    /// Texture coordinates (u, v, w), one triple a vertex; empty where no polygon of the mesh has any.
    pub texture: Vec<Vec3>,
    /// Factors on the color of the material, one a vertex, display values; empty where the material has the whole color.
    pub colors: Vec<Rgb>,
    /// The outlines of all polygons, one behind the other, as indices into `vertices`.
    pub outlines: Vec<u32>,
    /// The polygons, in file order.
    pub polygons: Vec<Polygon>,
}

/// One polygon of a [`Mesh`]: planar, simple, without holes, convex or not; counterclockwise seen from its front.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Polygon {
    /// Where its outline starts in [`Mesh::outlines`].
    pub start: u32,
    /// How many vertices it has; at least 3.
    pub count: u32,
    /// 1-based line in the file of the surface; for a tessellated shape, the line of the shape.
    pub line: u32,
    /// Which normals light it.
    pub normals: NormalSource,
}

/// Which normals light the vertices of a polygon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NormalSource {
    /// The polygon's own: a flat facet (NFF's `p`).
    Facet,
    /// The mean of the unit normals of all polygons of the surface around the vertex, back faces included (SIPP's rule).
    Averaged,
    /// Those of [`Mesh::normals`] (NFF's `pp`); where that is zero, the polygon's own.
    Given,
}

impl Mesh {
    /// The outline of `polygon`, as indices into [`Mesh::vertices`].
    #[must_use]
    pub fn outline(&self, polygon: &Polygon) -> &[u32] {
        &self.outlines[polygon.start as usize..(polygon.start + polygon.count) as usize]
    }

    /// Adds a vertex without normal and returns its index.
    pub fn push_vertex(&mut self, position: Vec3) -> u32 {
        self.vertices.push(position);
        if !self.normals.is_empty() {
            self.normals.push(Vec3::ZERO);
        }
        if !self.texture.is_empty() {
            self.texture.push(Vec3::ZERO);
        }
        if !self.colors.is_empty() {
            self.colors.push(Rgb::WHITE);
        }
        (self.vertices.len() - 1) as u32
    }

    /// Adds a vertex with a given normal and returns its index. The normal is unit, or zero for "none given".
    pub fn push_vertex_with_normal(&mut self, position: Vec3, normal: Vec3) -> u32 {
        self.normals.resize(self.vertices.len(), Vec3::ZERO);
        self.normals.push(normal);
        if !self.texture.is_empty() {
            self.texture.push(Vec3::ZERO);
        }
        if !self.colors.is_empty() {
            self.colors.push(Rgb::WHITE);
        }
        self.vertices.push(position);
        (self.vertices.len() - 1) as u32
    }

    /// Adds a polygon over vertices that are already there.
    pub fn push_polygon(&mut self, outline: &[u32], normals: NormalSource, line: u32) {
        let start = self.outlines.len() as u32;
        self.outlines.extend_from_slice(outline);
        self.polygons.push(Polygon { start, count: outline.len() as u32, line, normals });
    }

    /// Empties it and keeps its memory for the next shape.
    pub fn clear(&mut self) {
        self.vertices.clear();
        self.normals.clear();
        self.texture.clear();
        self.colors.clear();
        self.outlines.clear();
        self.polygons.clear();
    }
}
