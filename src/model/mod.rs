//! Model: the shapes of NFF and SIPP become polygons.
//!
//! Scene (shapes) -MODEL-> Mesh (polygons) -> geometry
//!
//! Why late and not in the parser: how many polygons a sphere needs depends on how large it is in the picture
//! ([`segments`]), and the file knows neither camera nor resolution.
//!
//! One file a family: `sphere` (with ellipsoids), `cone`, `capped_cone`, `prism` (with blocks), `torus`, `patches` and `curves` over
//! `bezier`, `teapot` over both. What each says: where its vertices are, which way they face, and which of them are neighbors.
//!
//! Space: the shape's own local space, in and out. Every polygon is planar ([`PLANAR`] is the tolerance), counterclockwise seen from
//! the side that is visible, and carries given unit normals, or its own where the shape has hard edges; neighbors stand on
//! the same points, to the last bit, so that nothing opens between them.
//! A shape whose *inside* is visible has its outlines reversed and its normals turned around, both.
//! Cost: one sine and cosine a column, none a vertex; no memory once the mesh has grown to size, but for Bezier shapes, which
//! look up the vertices on their borders.

mod bezier;
mod bounds;
mod capped_cone;
mod cone;
mod curves;
pub(crate) mod newell;
mod normals;
mod patches;
mod prism;
pub mod segments;
mod sheet;
mod sphere;
mod teapot;
mod torus;
mod turn;
mod weld;

pub use bounds::{Ball, bounding_ball, bounding_ball_of_mesh};
pub use normals::{averaged_normals, mirrors, normals_from, polygon_normal};
pub use sheet::PLANAR;

use crate::math::Vec3;
use crate::scene::{Mesh, Shape};
use sheet::Sheet;

/// How finely a shape is divided.
///
/// | shape | polygons for n, or for (n, m) |
/// |---|---|
/// | sphere, ellipsoid | n n / 2; n is rounded up to an even number |
/// | cone (open) | n, or 1 where it is a disc |
/// | capped cone | n, and n more for each end with a radius |
/// | block; prism of k points | 6; k + 2 |
/// | torus | n m: n around the ring, m around the tube |
/// | patches | n n a patch |
/// | curves | n 4m a curve: n along it, 4m around the axis |
/// | teapot | body 3 and lid 2 curves, handle and spout 4 patches each: 28 n n |
///
/// A cell of a net that shrinks to a line or a point is left out; a quad that is not planar counts once, though it becomes two triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Detail {
    /// The same number in both directions, SIPP's `res`. Each shape keeps to limits of its own: a sphere has 4 to
    /// [`segments::MAX_SPHERE`], a cone 3 to [`segments::MAX_CIRCLE`], a torus 3 to [`segments::MAX_SPHERE`], patches and curves 1 to
    /// [`Detail::MAX_RESOLUTION`], less where there are many.
    Segments(u32),
    /// One number for each direction, as [`segments`] finds them; shapes with one direction take the first.
    Grid([u32; 2]),
    /// SPD's own pattern for NFF's shapes, all triangles: 12 n^2 a sphere, 8n a cone. From 1 to [`Detail::MAX_RESOLUTION`].
    /// SIPP's shapes have no such pattern and take it as [`Detail::Segments`].
    Resolution(u32),
}

impl Detail {
    /// Larger resolutions are taken as this one: a sphere then has 12,582,912 triangles.
    pub const MAX_RESOLUTION: u32 = 1024;

    /// A net becomes at most this many cells, whatever its file asks: the body of a teapot at the largest resolution, and not more.
    const MOST_CELLS: f64 = 16_777_216.0;

    /// Segments in the two directions, for each of `pieces` of a net.
    fn of_net(self, pieces: usize) -> [u32; 2] {
        let most = ((Detail::MOST_CELLS / pieces.max(1) as f64).sqrt() as u32).clamp(1, Detail::MAX_RESOLUTION);
        self.pair().map(|n| n.clamp(1, most))
    }

    /// Segments in the two directions.
    fn pair(self) -> [u32; 2] {
        match self {
            Detail::Segments(n) | Detail::Resolution(n) => [n, n],
            Detail::Grid(pair) => pair,
        }
    }
}

/// Adds the polygons of `shape` to `mesh`, behind what is there; clear the mesh first to reuse its memory.
///
/// * `inside`: only the inside is visible, as NFF's negative radii say.
/// * `line`: of the shape in its file; every polygon carries it.
///
/// Returns how many quads were cut in two because they are not planar; in `mesh` each of them is two triangles.
///
/// A shape without extent (a sphere of radius 0, a cone with both radii 0, a ring with equal radii) and one with
/// a coordinate or radius that is not finite adds nothing.
pub fn tessellate(shape: &Shape, inside: bool, detail: Detail, line: u32, mesh: &mut Mesh) -> u64 {
    let mut sheet = Sheet { mesh, inside, line, nonplanar: 0 };
    match *shape {
        Shape::Sphere { center, radius } => sphere::sphere(center, radius, detail, &mut sheet),
        Shape::Ellipsoid { radii } => sphere::ellipsoid(radii, detail, &mut sheet),
        Shape::Cone { base, base_radius, apex, apex_radius } => {
            let cone = cone::Cone { base, base_radius, apex, apex_radius };
            cone.tessellate(detail, &mut sheet);
        }
        Shape::CappedCone { bottom_radius, top_radius, length } => {
            capped_cone::capped_cone(&cone_about_z(bottom_radius, top_radius, length), detail, &mut sheet);
        }
        Shape::Block { size } => prism::block(size, &mut sheet),
        Shape::Prism { ref outline, height } => prism::prism(outline, height, &mut sheet),
        Shape::Torus { ring_radius, tube_radius } => torus::torus(ring_radius, tube_radius, detail, &mut sheet),
        Shape::Patches(ref net) => patches::patches(net, detail, &mut sheet),
        Shape::Curves(ref net) => curves::curves(net, detail, &mut sheet),
        Shape::Teapot(part) => teapot::teapot(part, detail, &mut sheet),
    }
    sheet.nonplanar
}

/// The side of SIPP's cone: about the z axis, the origin half way up.
fn cone_about_z(bottom_radius: f64, top_radius: f64, length: f64) -> cone::Cone {
    let apex = Vec3::Z * (length / 2.0);
    cone::Cone { base: -apex, base_radius: bottom_radius, apex, apex_radius: top_radius }
}

#[cfg(test)]
mod net_tests;
#[cfg(test)]
mod shape_tests;
#[cfg(test)]
mod test_bodies;
#[cfg(test)]
mod tests;
