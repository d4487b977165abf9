//! Random scenes that are hard to decide, for checks that need whole pictures: stars and combs, polygons that pierce each other,
//! touch, lie in one plane or one on the other, reach in front of hither and out of the picture.
//!
//! seed -> Scene, Choices
//!
//! The same seed gives the same scene on every machine. [`hard`] and [`choices`] are public because tests and other programs that judge a
//! rasterizer want the same cases as `farop check agree`.
//!
//! Space: the camera stands at the world's origin and looks along -z with an opening of 90 degrees; places are drawn in eye space (x right,
//! y up, z along the view). The eye-space point (x, y, w) lands n/2 x/w right of the middle of a square picture of n samples.

use super::Random;
use crate::color::Rgb;
use crate::math::{Affine3, PI, Vec3, cos, sin, unit};
use crate::plan::{Choices, Culling, DepthFormat, Shading, Transparency};
use crate::scene::{
    Camera, Light, Material, Mesh, NormalSource, Object, ObjectId, Place, Primitive, Scene, Shape, Surface, SurfaceId,
};

/// Pixels of a side of [`hard`]'s pictures.
pub const SIDE: u32 = 44;

/// The hard scene that belongs to `seed`; every other one has surfaces that let light through.
#[must_use]
pub fn hard(seed: u64) -> Scene {
    let mut crowd = Crowd { random: Random::new(seed), meshes: vec![Mesh::default(); 6], next: 0 };
    for _ in 0..2 + crowd.random.below(5) {
        crowd.push_group();
    }
    crowd.scene(seed.is_multiple_of(2))
}

/// Choices for it; every combination comes up, as the periods have no common divisor worth speaking of.
#[must_use]
pub fn choices(seed: u64) -> Choices {
    let pick = |count: usize, shift: u64| (seed / shift) as usize % count;
    Choices {
        shading: [Shading::Flat, Shading::Gouraud, Shading::Phong][pick(3, 1)],
        subpixel_bits: [8, 0, 16, 4, 11][pick(5, 1)],
        depth: DepthFormat::ALL[pick(4, 1)],
        culling: [Culling::None, Culling::Back, Culling::Nff, Culling::None][pick(4, 4)],
        transparency: Transparency::ALL[pick(2, 16)],
        samples: if pick(7, 1) == 6 { 2 } else { 1 },
        threads: Some([1, 2, 1, 3, 1, 1, 1, 1, 1, 1, 1][pick(11, 1)]),
        triangles: seed.is_multiple_of(13),
        ..Choices::default()
    }
}

/// The world point at eye-space point (x, y, w).
pub(super) fn world(eye: Vec3) -> Vec3 {
    Vec3::new(eye.x, eye.y, -eye.z)
}

/// A camera at the origin with an opening of 90 degrees, hither 1, no yon.
pub(super) fn camera(width: u32, height: u32) -> Camera {
    let (from, at, up, place) = (Vec3::ZERO, Vec3::NEG_Z, Vec3::Y, Place::default());
    Camera { from, at, up, angle: 90.0, hither: 1.0, yon: None, resolution: (width, height), place }
}

/// A scene of one object, not moved, with one light at the eye's upper left.
pub(super) fn scene(camera: Camera, surfaces: Vec<Surface>) -> Scene {
    let object = Object {
        name: String::new(),
        parent_from_local: Affine3::IDENTITY,
        surfaces: (0..surfaces.len() as u32).map(SurfaceId).collect(),
        children: Vec::new(),
        place: Place::default(),
    };
    Scene {
        facing: std::collections::BTreeSet::new(),
        textures: Vec::new(),
        files: vec!["made".into()],
        objects: vec![object],
        surfaces,
        world: vec![ObjectId(0)],
        lights: vec![Light::point(Vec3::new(-3.0, 4.0, 2.0), Rgb::WHITE, Place::default())],
        camera: Some(camera),
        background: None,
    }
}

/// A surface of one material over `mesh`.
pub(super) fn surface(material: Material, mesh: Mesh) -> Surface {
    Surface { material, mesh, primitives: Vec::new(), two_sided: false, place: Place::default() }
}

/// A scene of one shape.
pub(super) fn of_shape(shape: Shape, side: u32) -> Scene {
    let mut one = surface(Material { diffuse: 1.0, ..Material::default() }, Mesh::default());
    one.primitives.push(Primitive::new(shape, 0, 1));
    scene(camera(side, side), vec![one])
}

/// Facets with corners of their own, given in eye space.
pub(super) fn facets(outlines: &[Vec<Vec3>]) -> Mesh {
    let mut mesh = Mesh::default();
    for outline in outlines {
        let indices: Vec<u32> = outline.iter().map(|&corner| mesh.push_vertex(world(corner))).collect();
        mesh.push_polygon(&indices, NormalSource::Facet, mesh.polygons.len() as u32 + 1);
    }
    mesh
}

/// A plane with two directions on it.
#[derive(Clone, Copy)]
struct Frame {
    middle: Vec3,
    u: Vec3,
    v: Vec3,
}

impl Frame {
    fn outline(&self, corners: &[(f64, f64)]) -> Vec<Vec3> {
        corners.iter().map(|&(s, t)| self.middle + self.u * s + self.v * t).collect()
    }
}

struct Crowd {
    random: Random,
    meshes: Vec<Mesh>,
    next: usize,
}

impl Crowd {
    fn push_group(&mut self) {
        let frame = self.frame();
        match self.random.below(8) {
            0 => self.push(&frame.outline(&star(5, 0.35))),
            1 => self.push(&frame.outline(&comb(4))),
            2 => self.push_piercing(frame),
            3 => self.push_touching(frame),
            4 => self.push_coplanar(frame),
            5 => self.push_twice(frame),
            6 => self.push_cut(frame),
            _ => self.push(&frame.outline(&star(3, 0.5)[..3])),
        }
    }

    /// A random plane in the view, tilted or (one in four) parallel to the picture.
    fn frame(&mut self) -> Frame {
        let w = self.random.between(1.4, 7.0);
        let middle = Vec3::new(self.random.between(-0.6, 0.6) * w, self.random.between(-0.6, 0.6) * w, w);
        let depth = if self.random.once_in(4) { 0.0 } else { 0.5 };
        let mut axis = || {
            let mut across = || self.random.between(-0.8, 0.8) * w;
            Vec3::new(across(), across(), across() * depth)
        };
        Frame { middle, u: axis(), v: axis() }
    }

    /// Two polygons through one point, on planes of their own.
    fn push_piercing(&mut self, frame: Frame) {
        let other = Frame { middle: frame.middle, ..self.frame() };
        self.push(&frame.outline(&star(4, 0.6)));
        self.push(&other.outline(&[(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]));
    }

    /// A fan of triangles with a common apex and common edges, and a triangle that touches it in one corner.
    fn push_touching(&mut self, frame: Frame) {
        let apex = frame.middle + Vec3::new(0.0, 0.0, self.random.between(-0.3, 0.3));
        let rim: Vec<Vec3> = frame.outline(&star(3, 0.8));
        for i in 0..rim.len() {
            self.push(&[apex, rim[i], rim[(i + 1) % rim.len()]]);
        }
        self.push(&[rim[0], rim[0] + frame.u * 0.5, rim[0] + frame.v * 0.5]);
    }

    /// Two outlines that overlap in one plane.
    fn push_coplanar(&mut self, frame: Frame) {
        let shift = (self.random.between(-0.5, 0.5), self.random.between(-0.5, 0.5));
        let moved: Vec<_> = star(5, 0.5).iter().map(|&(s, t)| (s + shift.0, t + shift.1)).collect();
        self.push(&frame.outline(&star(4, 0.7)));
        self.push(&frame.outline(&moved));
    }

    /// The same outline twice: equal depths at every sample.
    fn push_twice(&mut self, frame: Frame) {
        let outline = frame.outline(&star(4, 0.5));
        self.push(&outline);
        self.push(&outline);
    }

    /// In front of hither at one end, far out of the picture at the other, or wholly outside.
    fn push_cut(&mut self, frame: Frame) {
        let near = Vec3::new(frame.middle.x * 0.2, frame.middle.y * 0.2, self.random.between(0.2, 0.9));
        self.push(&[near, frame.middle + frame.u * 3.0, frame.middle + frame.v * 3.0]);
        let aside = Frame { middle: frame.middle + frame.u * self.random.between(0.5, 3.0), ..frame };
        self.push(&aside.outline(&comb(3)));
    }

    fn push(&mut self, outline: &[Vec3]) {
        let count = self.meshes.len();
        let mesh = &mut self.meshes[self.next % count];
        self.next += 1;
        let random = &mut self.random;
        let mut tilted = || {
            let normal = Vec3::new(random.between(-0.7, 0.7), random.between(-0.7, 0.7), 1.0);
            unit(normal).unwrap_or(Vec3::Z)
        };
        let indices: Vec<u32> =
            outline.iter().map(|&corner| mesh.push_vertex_with_normal(world(corner), tilted())).collect();
        let normals = if random.once_in(2) { NormalSource::Given } else { NormalSource::Facet };
        mesh.push_polygon(&indices, normals, mesh.polygons.len() as u32 + 1);
    }

    /// Six surfaces, of which every other one lets light through where asked for.
    fn scene(mut self, transparent: bool) -> Scene {
        let mut surfaces = Vec::new();
        for (number, mesh) in std::mem::take(&mut self.meshes).into_iter().enumerate() {
            let color = Rgb::new(self.random.unit(), self.random.unit(), self.random.unit());
            let mut material = Material { color, diffuse: 0.7, specular: 0.2, shine: 9.0, ..Material::default() };
            if transparent && number % 2 == 1 {
                material.opacity = Rgb::new(0.25, 0.5, self.random.unit());
            }
            surfaces.push(surface(material, mesh));
        }
        let mut scene = scene(Camera { yon: Some(1e3), ..camera(SIDE, SIDE) }, surfaces);
        scene.lights.push(Light::point(Vec3::new(5.0, 1.0, 0.0), Rgb::new(1.0, 0.75, 0.5), Place::default()));
        scene.background = Some(Rgb::new(0.25, 0.375, 0.5));
        scene
    }
}

/// A star of `tips` tips, its inner corners at `inner`: 2 * `tips` corners.
fn star(tips: usize, inner: f64) -> Vec<(f64, f64)> {
    let corner = |i: usize| {
        let angle = i as f64 / tips as f64 * PI;
        let radius = if i.is_multiple_of(2) { 1.0 } else { inner };
        (cos(angle) * radius, sin(angle) * radius)
    };
    (0..2 * tips).map(corner).collect()
}

/// A comb of `teeth` teeth.
fn comb(teeth: usize) -> Vec<(f64, f64)> {
    let mut corners = vec![(-1.0, -1.0), (1.0, -1.0)];
    let at = |i: usize| 1.0 - i as f64 / teeth as f64;
    corners.extend((0..2 * teeth).map(|i| (at(i), if i.is_multiple_of(2) { 1.0 } else { -0.4 })));
    corners
}
