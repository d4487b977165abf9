//! Random scenes that are hard to decide: stars and combs, polygons that pierce each other, touch, lie in one plane or one on
//! the other, reach in front of hither and out of the picture; and choices that change from scene to scene.
//!
//! Space: eye space (x right, y up, z along the view) of the camera of `scenes`.

use super::random::Random;
use super::scenes::{camera, scene, surface, world};
use farop::color::Rgb;
use farop::math::Vec3;
use farop::plan::{Choices, Culling, DepthFormat, Shading, Transparency};
use farop::scene::{Light, Material, Mesh, NormalSource, Place, Scene};

/// Pixels of a side.
pub const SIDE: u32 = 44;

/// The scene and the choices of `seed`.
pub fn hard(seed: u64) -> (Scene, Choices) {
    let mut crowd = Crowd { random: Random::new(seed), meshes: vec![Mesh::default(); 6], next: 0 };
    for _ in 0..crowd.random.whole(2, 6) {
        crowd.push_group();
    }
    (crowd.scene(seed), choices(seed))
}

/// Every combination comes up: the periods have no common divisor worth speaking of.
fn choices(seed: u64) -> Choices {
    let pick = |count: usize, shift: u64| (seed / shift) as usize % count;
    Choices {
        shading: [Shading::Flat, Shading::Gouraud, Shading::Phong][pick(3, 1)],
        subpixel_bits: [8, 0, 16, 4, 11][pick(5, 1)],
        depth: DepthFormat::ALL[pick(4, 1)],
        culling: [Culling::None, Culling::Back, Culling::Nff, Culling::None][pick(4, 4)],
        transparency: Transparency::ALL[pick(2, 16)],
        samples: [1, 1, 1, 1, 1, 1, 2][pick(7, 1)],
        threads: Some([1, 2, 1, 3, 1, 1, 1, 1, 1, 1, 1][pick(11, 1)]),
        triangles: seed.is_multiple_of(13),
        ..Choices::default()
    }
}

/// A plane with two directions on it.
#[derive(Clone, Copy)]
struct Place2 {
    middle: Vec3,
    u: Vec3,
    v: Vec3,
}

impl Place2 {
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
        let place = self.place();
        match self.random.whole(0, 7) {
            0 => self.push(&place.outline(&star(5, 0.35))),
            1 => self.push(&place.outline(&comb(4))),
            2 => self.push_piercing(place),
            3 => self.push_touching(place),
            4 => self.push_coplanar(place),
            5 => self.push_twice(place),
            6 => self.push_cut(place),
            _ => self.push(&place.outline(&star(3, 0.5)[..3])),
        }
    }

    /// A random plane in the view, tilted or (one in four) parallel to the picture.
    fn place(&mut self) -> Place2 {
        let w = self.random.between(1.4, 7.0);
        let middle = Vec3::new(self.random.between(-0.6, 0.6) * w, self.random.between(-0.6, 0.6) * w, w);
        let depth = if self.random.one_in(4) { 0.0 } else { 0.5 };
        let mut axis = || {
            let mut across = || self.random.between(-0.8, 0.8) * w;
            Vec3::new(across(), across(), across() * depth)
        };
        Place2 { middle, u: axis(), v: axis() }
    }

    /// Two polygons through one point, on planes of their own.
    fn push_piercing(&mut self, place: Place2) {
        let other = Place2 { middle: place.middle, ..self.place() };
        self.push(&place.outline(&star(4, 0.6)));
        self.push(&other.outline(&[(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]));
    }

    /// A fan of triangles with a common apex and common edges, and a triangle that touches it in one corner.
    fn push_touching(&mut self, place: Place2) {
        let apex = place.middle + Vec3::new(0.0, 0.0, self.random.between(-0.3, 0.3));
        let rim: Vec<Vec3> = place.outline(&star(3, 0.8));
        for i in 0..rim.len() {
            self.push(&[apex, rim[i], rim[(i + 1) % rim.len()]]);
        }
        let (across, down) = (rim[0] + place.u * 0.5, rim[0] + place.v * 0.5);
        self.push(&[rim[0], across, down]);
    }

    /// Two outlines that overlap in one plane.
    fn push_coplanar(&mut self, place: Place2) {
        let shift = (self.random.between(-0.5, 0.5), self.random.between(-0.5, 0.5));
        let moved: Vec<_> = star(5, 0.5).iter().map(|&(s, t)| (s + shift.0, t + shift.1)).collect();
        self.push(&place.outline(&star(4, 0.7)));
        self.push(&place.outline(&moved));
    }

    /// The same outline twice: equal depths at every sample.
    fn push_twice(&mut self, place: Place2) {
        let outline = place.outline(&star(4, 0.5));
        self.push(&outline);
        self.push(&outline);
    }

    /// In front of hither at one end, far out of the picture at the other, or wholly outside.
    fn push_cut(&mut self, place: Place2) {
        let near = Vec3::new(place.middle.x * 0.2, place.middle.y * 0.2, self.random.between(0.2, 0.9));
        self.push(&[near, place.middle + place.u * 3.0, place.middle + place.v * 3.0]);
        let aside = Place2 { middle: place.middle + place.u * self.random.between(0.5, 3.0), ..place };
        self.push(&aside.outline(&comb(3)));
    }

    fn push(&mut self, outline: &[Vec3]) {
        let count = self.meshes.len();
        let mesh = &mut self.meshes[self.next % count];
        self.next += 1;
        let random = &mut self.random;
        let mut tilted = || Vec3::new(random.between(-0.7, 0.7), random.between(-0.7, 0.7), 1.0).normalize();
        let indices: Vec<u32> =
            outline.iter().map(|&corner| mesh.push_vertex_with_normal(world(corner), tilted())).collect();
        let normals = if random.one_in(2) { NormalSource::Given } else { NormalSource::Facet };
        mesh.push_polygon(&indices, normals, mesh.polygons.len() as u32 + 1);
    }

    /// Six surfaces; in every other scene, every other one lets light through.
    fn scene(mut self, seed: u64) -> Scene {
        let mut surfaces = Vec::new();
        for (number, mesh) in std::mem::take(&mut self.meshes).into_iter().enumerate() {
            let color = Rgb::new(self.random.unit(), self.random.unit(), self.random.unit());
            let mut material = Material { color, diffuse: 0.7, specular: 0.2, shine: 9.0, ..Material::default() };
            if seed.is_multiple_of(2) && number % 2 == 1 {
                material.opacity = Rgb::new(0.25, 0.5, self.random.unit());
            }
            surfaces.push(surface(material, mesh));
        }
        let mut camera = camera(SIDE, SIDE);
        camera.yon = Some(1e3);
        let mut scene = scene(camera, surfaces);
        scene.lights.push(Light::point(Vec3::new(5.0, 1.0, 0.0), Rgb::new(1.0, 0.75, 0.5), Place::default()));
        scene.background = Some(Rgb::new(0.25, 0.375, 0.5));
        scene
    }
}

/// A star of `tips` tips, its inner corners at `inner`: 2 * `tips` corners.
fn star(tips: usize, inner: f64) -> Vec<(f64, f64)> {
    let corner = |i: usize| {
        let angle = i as f64 / tips as f64 * std::f64::consts::PI;
        let radius = if i.is_multiple_of(2) { 1.0 } else { inner };
        (angle.cos() * radius, angle.sin() * radius)
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
