//! Random scenes of flat polygons, with normals, materials and lights; and what a ray from the eye meets.
//!
//! Space: eye space (x right, y up, z along the view) of the camera of `scenes`.

use super::random::Random;
use super::scenes::{camera, scene, surface, world};
use farop::color::Rgb;
use farop::math::Vec3;
use farop::scene::{Light, Material, Mesh, NormalSource, Place, Scene};

/// What a random scene is made of.
#[derive(Clone, Copy, Debug)]
pub struct Mix {
    /// Seed of everything random.
    pub seed: u64,
    /// Polygons, half of them with normals of their own.
    pub polygons: usize,
    /// Corners of each.
    pub corners: (i64, i64),
    /// Distances between which they lie; hither is 1.
    pub distance: (f64, f64),
    /// How far from the middle of the view, and how large, in units of the distance.
    pub spread: f64,
    /// Lights.
    pub lights: usize,
    /// Every other surface has highlights.
    pub shiny: bool,
    /// Every other surface lets light through.
    pub transparent: bool,
}

impl Default for Mix {
    fn default() -> Self {
        let (distance, spread) = ((1.5, 9.0), 0.6);
        Mix { seed: 1, polygons: 24, corners: (3, 3), distance, spread, lights: 2, shiny: true, transparent: false }
    }
}

impl Mix {
    /// The scene in a square picture of `side` pixels: four surfaces.
    pub fn scene(&self, side: u32) -> Scene {
        let mut random = Random::new(self.seed);
        let mut surfaces = Vec::new();
        for number in 0..4 {
            let mut mesh = Mesh::default();
            for _ in 0..self.polygons / 4 {
                self.push(&mut random, &mut mesh);
            }
            let color = Rgb::new(random.unit(), random.unit(), random.unit());
            let mut material = Material { color, diffuse: 0.7, ..Material::default() };
            if self.shiny && number % 2 == 0 {
                (material.specular, material.shine) = (0.4, random.between(1.0, 40.0));
            }
            if self.transparent && number % 2 == 1 {
                material.opacity = Rgb::new(0.25, 0.5, 0.75);
            }
            surfaces.push(surface(material, mesh));
        }
        let mut scene = scene(camera(side, side), surfaces);
        let place = Place::default();
        let light = |_| {
            let position = Vec3::new(random.between(-9.0, 9.0), random.between(-9.0, 9.0), random.between(-3.0, 3.0));
            Light::point(world(position), Rgb::new(1.0, 0.875, 0.75), place)
        };
        scene.lights = (0..self.lights).map(light).collect();
        scene.background = Some(Rgb::new(0.25, 0.375, 0.5));
        scene
    }

    /// A star-shaped polygon on a random plane, counterclockwise for the viewer or not.
    fn push(&self, random: &mut Random, mesh: &mut Mesh) {
        let w = random.between(self.distance.0, self.distance.1);
        let mut at = || random.between(-self.spread, self.spread) * w;
        let middle = Vec3::new(at(), at(), w);
        let mut axis = || Vec3::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-0.4, 0.4));
        let (u, v) = (axis() * w * self.spread, axis() * w * self.spread);
        let count = random.whole(self.corners.0, self.corners.1);
        let normal = u.cross(v).normalize();
        let outline: Vec<u32> = (0..count)
            .map(|i| {
                let angle = (i as f64 + random.between(0.0, 0.6)) / count as f64 * std::f64::consts::TAU;
                let corner = middle + (u * angle.cos() + v * angle.sin()) * random.between(0.4, 1.0);
                let tilt = Vec3::new(random.unit(), random.unit(), random.unit()) * 0.5;
                mesh.push_vertex_with_normal(world(corner), world((normal + tilt).normalize()))
            })
            .collect();
        let source = if random.one_in(2) { NormalSource::Given } else { NormalSource::Facet };
        mesh.push_polygon(&outline, source, mesh.polygons.len() as u32 + 1);
    }
}

/// The eye-space point of sample center (x, y) of a square picture of `side` samples on the plane of three points.
pub fn meet(plane: [Vec3; 3], (x, y): (i32, i32), side: u32) -> Vec3 {
    let half = f64::from(side) / 2.0;
    let ray = Vec3::new((f64::from(x) + 0.5 - half) / half, (half - f64::from(y) - 0.5) / half, 1.0);
    let [a, b, c] = plane;
    let normal = (b - a).cross(c - a);
    ray * (normal.dot(a) / normal.dot(ray))
}

/// How much each corner of a triangle weighs at a point of its plane; negative outside.
pub fn weights([a, b, c]: [Vec3; 3], p: Vec3) -> [f64; 3] {
    let normal = (b - a).cross(c - a);
    let part = |q: Vec3, r: Vec3| (q - p).cross(r - p).dot(normal) / normal.length_squared();
    [part(b, c), part(c, a), part(a, b)]
}

/// The mean of three values by weight.
pub fn mix(values: [Vec3; 3], weights: [f64; 3]) -> Vec3 {
    values[0] * weights[0] + values[1] * weights[1] + values[2] * weights[2]
}

/// Phong's model, written from the formula: colors are light, Ia and Ii are sqrt(n) / 2n of n lights.
pub fn light(scene: &Scene, material: &Material, point: Vec3, normal: Vec3) -> Vec3 {
    let count = scene.lights.len() as f64;
    let level = if count == 0.0 { 1.0 } else { count.sqrt() / (2.0 * count) };
    let rgb = |color: Rgb| Vec3::new(color.r, color.g, color.b);
    let mut total = rgb(material.color) * material.diffuse * level;
    for light in &scene.lights {
        let to_light = (world(light.source.position()) - point).normalize();
        let cosine = normal.dot(to_light);
        if cosine <= 0.0 {
            continue;
        }
        let mirrored = normal * (2.0 * cosine) - to_light;
        let highlight = mirrored.dot(-point.normalize()).max(0.0).powf(material.shine) * material.specular;
        total += rgb(light.color) * level * (rgb(material.color) * material.diffuse * cosine + Vec3::splat(highlight));
    }
    total
}
