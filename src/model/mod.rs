//! Model: spheres and cones become polygons.
//!
//! Scene (shapes) -MODEL-> Mesh (polygons) -> geometry
//!
//! Why late and not in the parser: how many polygons a sphere needs depends on how large it is in the picture
//! ([`segments`]), and the file knows neither camera nor resolution.
//!
//! Space: the shape's own local space, in and out. Every polygon is planar, counterclockwise seen from the side
//! that is visible, and carries given unit normals; neighbors share vertices, so that nothing opens between them.
//! A shape whose *inside* is visible has its outlines reversed and its normals turned around, both.
//! Cost: one sine and cosine a column, none a vertex; no memory once the mesh has grown to size.

mod bounds;
mod cone;
mod normals;
pub mod segments;
mod sphere;
mod turn;

pub use bounds::{Ball, bounding_ball, bounding_ball_of_mesh};
pub use normals::{averaged_normals, mirrors, normals_from, polygon_normal, vertex_normals};

use crate::math::Vec3;
use crate::scene::{Mesh, NormalSource, Shape};

/// How finely a shape is divided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Detail {
    /// Segments around, as [`segments`] finds them: a sphere becomes n columns and n/2 bands (n is rounded up to an even
    /// number, 4 to [`segments::MAX_SPHERE`]), a cone n quads or triangles (3 to [`segments::MAX_CIRCLE`]).
    Segments(u32),
    /// SPD's own pattern, all triangles: 12 n^2 a sphere, 8n a cone. From 1 to [`Detail::MAX_RESOLUTION`].
    Resolution(u32),
}

impl Detail {
    /// Larger resolutions are taken as this one: a sphere then has 12,582,912 triangles.
    pub const MAX_RESOLUTION: u32 = 1024;
}

/// Adds the polygons of `shape` to `mesh`, behind what is there; clear the mesh first to reuse its memory.
///
/// * `inside`: only the inside is visible, as NFF's negative radii say.
/// * `line`: of the shape in its file; every polygon carries it.
///
/// A shape without extent (a sphere of radius 0, a cone with both radii 0, a ring with equal radii) and one with
/// a coordinate or radius that is not finite adds nothing.
pub fn tessellate(shape: &Shape, inside: bool, detail: Detail, line: u32, mesh: &mut Mesh) {
    let mut sheet = Sheet { mesh, inside, line };
    match *shape {
        Shape::Sphere { center, radius } => sphere::tessellate(center, radius, detail, &mut sheet),
        Shape::Cone { base, base_radius, apex, apex_radius } => {
            let cone = cone::Cone { base, base_radius, apex, apex_radius };
            cone.tessellate(detail, &mut sheet);
        }
        // The shapes of SIPP follow.
        _ => (),
    }
}

/// Where the polygons of one shape go. Shapes describe their outside; this turns it inside out where asked.
struct Sheet<'a> {
    mesh: &'a mut Mesh,
    inside: bool,
    line: u32,
}

impl Sheet<'_> {
    /// Adds a vertex; `normal` points outward and is unit.
    fn vertex(&mut self, position: Vec3, normal: Vec3) -> u32 {
        self.mesh.push_vertex_with_normal(position, if self.inside { -normal } else { normal })
    }

    /// Adds a polygon, counterclockwise seen from outside.
    fn facet(&mut self, outline: impl IntoIterator<Item = u32>) {
        let start = self.mesh.outlines.len();
        self.mesh.outlines.extend(outline);
        if self.inside {
            // The first vertex stays the first: flat shading takes its light from there.
            self.mesh.outlines[start + 1..].reverse();
        }
        let count = (self.mesh.outlines.len() - start) as u32;
        let polygon =
            crate::scene::Polygon { start: start as u32, count, line: self.line, normals: NormalSource::Given };
        self.mesh.polygons.push(polygon);
    }
}

#[cfg(test)]
mod tests;
