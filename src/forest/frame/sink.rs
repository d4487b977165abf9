//! Sink: polygons by what they wear, in memory that frames share.
//!
//! quads, triangles -SINK-> surfaces of the scene
//!
//! Trees come from near to far, and a rasterizer is quickest when near ones come first: what is behind then costs one test. But a surface has one
//! picture. So trees are dealt out by picture for a while, then all surfaces are closed and new ones begun: a *batch*. The first batch is
//! small, because what is nearest hides most; each next one is larger, because surfaces cost, too.
//!
//! Cost: 232 bytes a quad, written once.

use super::dress::Dress;
use crate::color::Rgb;
use crate::forest::solid::Solid;
use crate::math::Vec3;
use crate::scene::{Material, Mesh, NormalSource, Place, Polygon, Surface};

/// Trees of the first batch, and of the largest.
const BATCH: [usize; 2] = [512, 16_384];

/// Surfaces that are being filled.
#[derive(Default)]
pub(super) struct Sink {
    /// Filled in this frame, in their order.
    pub surfaces: Vec<Surface>,
    /// Empty, with memory that earlier frames have warmed.
    spare: Vec<Surface>,
    /// Index + 1 of the surface of each key in this batch.
    open: Vec<u32>,
    keys: Vec<u32>,
    /// Trees of this batch so far, and how many it takes.
    count: usize,
    limit: usize,
    pub polygons: u64,
}

impl Sink {
    /// Empties everything; `keys` are all there may be.
    pub fn clear(&mut self, keys: usize) {
        self.close();
        self.open.resize(keys, 0);
        // The largest memory goes to those who ask first: they asked for it in the last frame.
        while let Some(mut surface) = self.surfaces.pop() {
            surface.mesh.clear();
            self.spare.push(surface);
        }
        (self.limit, self.polygons) = (BATCH[0], 0);
    }

    /// Counts trees; a full batch is closed. Called between groups of trees, so that groups stay whole.
    pub fn count(&mut self, trees: usize) {
        self.count += trees;
        if self.count > self.limit {
            self.close();
            self.limit = (2 * self.limit).min(BATCH[1]);
        }
    }

    fn close(&mut self) {
        self.keys.drain(..).for_each(|key| self.open[key as usize] = 0);
        self.count = 0;
    }

    /// A new surface behind all others.
    pub fn surface(&mut self, material: Material, two_sided: bool) -> &mut Mesh {
        let empty =
            || Surface { material, mesh: Mesh::default(), primitives: Vec::new(), two_sided, place: Place::default() };
        let mut surface = self.spare.pop().unwrap_or_else(empty);
        (surface.material, surface.two_sided) = (material, two_sided);
        let at = self.surfaces.len();
        self.surfaces.push(surface);
        &mut self.surfaces[at].mesh
    }

    /// The mesh of a key in this batch.
    #[inline]
    pub fn mesh(&mut self, dress: &Dress, key: usize) -> &mut Mesh {
        if self.open[key] == 0 {
            self.surface(dress.material(key), true);
            self.open[key] = self.surfaces.len() as u32;
            self.keys.push(key as u32);
        }
        &mut self.surfaces[self.open[key] as usize - 1].mesh
    }
}

/// A parallelogram with a picture: its lower left corner, and the ways along its lower and left edges.
#[derive(Clone, Copy, Debug)]
pub(super) struct Quad {
    pub corner: Vec3,
    pub along: Vec3,
    pub up: Vec3,
}

/// The corners of pictures, counterclockwise from the lower left.
pub(super) const UPRIGHT: [Vec3; 4] = [Vec3::ZERO, Vec3::X, Vec3::new(1.0, 1.0, 0.0), Vec3::Y];
/// The upper half alone: of a tree seen from above there are leaves and no stem.
pub(super) const CROWN: [Vec3; 4] =
    [Vec3::new(0.0, 0.4, 0.0), Vec3::new(1.0, 0.4, 0.0), Vec3::new(1.0, 0.9, 0.0), Vec3::new(0.0, 0.9, 0.0)];

/// Adds a quad. `number` is the tree's own: fades of its parts are turned alike.
#[inline]
pub(super) fn add_quad(mesh: &mut Mesh, Quad { corner, along, up }: Quad, places: &[Vec3; 4], number: u32) {
    let (first, start) = (mesh.vertices.len() as u32, mesh.outlines.len() as u32);
    let far = corner + along;
    mesh.vertices.extend_from_slice(&[corner, far, far + up, corner + up]);
    mesh.texture.extend_from_slice(places);
    mesh.outlines.extend_from_slice(&[first, first + 1, first + 2, first + 3]);
    mesh.polygons.push(Polygon { start, count: 4, line: number, normals: NormalSource::Facet });
}

/// Adds a triangle; where it fades it wears one texel, and any place in it will do.
#[inline]
pub(super) fn add_triangle(mesh: &mut Mesh, corners: [Vec3; 3], is_worn: bool, number: u32) {
    let (first, start) = (mesh.vertices.len() as u32, mesh.outlines.len() as u32);
    mesh.vertices.extend_from_slice(&corners);
    if is_worn {
        mesh.texture.extend_from_slice(&[Vec3::ZERO, Vec3::X, Vec3::Y]);
    }
    mesh.outlines.extend_from_slice(&[first, first + 1, first + 2]);
    mesh.polygons.push(Polygon { start, count: 3, line: number, normals: NormalSource::Facet });
}

/// Where a mesh stands: its foot, cosine and sine of its turn, crown and height.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stand {
    pub foot: Vec3,
    pub turn: (f64, f64),
    pub size: (f64, f64),
}

/// Adds a copy of a solid. Normals are stretched the other way than corners, so that they stay at right angles to the faces.
pub(super) fn add_solid(mesh: &mut Mesh, solid: &Solid, at: &Stand, (is_worn, number): (bool, u32)) {
    let first = mesh.vertices.len() as u32;
    let ((cos, sin), (crown, height)) = (at.turn, at.size);
    let turned = |v: Vec3| Vec3::new(cos * v.x - sin * v.y, sin * v.x + cos * v.y, v.z);
    let placed = |v: &Vec3| at.foot + turned(Vec3::new(v.x * crown, v.y * crown, v.z * height));
    let looking = |n: &Vec3| {
        let stretched = turned(Vec3::new(n.x * height, n.y * height, n.z * crown));
        crate::math::unit(stretched).unwrap_or(Vec3::Z)
    };
    mesh.vertices.extend(solid.vertices.iter().map(placed));
    mesh.normals.extend(solid.normals.iter().map(looking));
    mesh.colors.extend_from_slice(&solid.colors);
    if is_worn {
        mesh.texture.extend(solid.vertices.iter().map(|_| Vec3::ZERO));
    }
    for corners in &solid.triangles {
        let start = mesh.outlines.len() as u32;
        mesh.outlines.extend(corners.map(|corner| first + corner));
        mesh.polygons.push(Polygon { start, count: 3, line: number, normals: NormalSource::Given });
    }
}

/// Adds a corner of the ground.
#[inline]
pub(super) fn add_corner(
    mesh: &mut Mesh,
    (position, normal): (Vec3, Vec3),
    color: Option<Rgb>,
    place: Option<Vec3>,
) -> u32 {
    mesh.vertices.push(position);
    mesh.normals.push(normal);
    mesh.colors.extend(color);
    mesh.texture.extend(place);
    (mesh.vertices.len() - 1) as u32
}
