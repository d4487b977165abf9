//! Scenes as SIPP has them, built by hand: a tree of turned, stretched and mirrored objects, three reflection models, lights of three kinds.

use super::random::Random;
use farop::color::Rgb;
use farop::math::{Affine3, Mat3, Vec3, cos, sin};
use farop::model::{Detail, tessellate};
use farop::scene::{
    Camera, Light, LightSource, Material, Mesh, NormalSource, Object, ObjectId, Place, Reflection, Scene, Shape,
    SpotEdge, Surface, SurfaceId,
};

/// What the scene may have beyond what NFF can say in comments.
#[derive(Clone, Copy, PartialEq)]
pub enum Kinds {
    /// Surfaces of `phong` and NFF's model, point lights.
    PhongAndPoints,
    /// All models, all lights.
    All,
}

/// A scene of twelve objects, three levels deep.
pub fn scene(random: &mut Random, kinds: Kinds) -> Scene {
    let surfaces: Vec<Surface> = (0..6).map(|index| surface(random, index, kinds)).collect();
    let objects: Vec<Object> = (0..12u32)
        .map(|index| {
            let depth = index / 4;
            let children = if depth < 2 { vec![ObjectId(index + 4), ObjectId(4 * (depth + 1))] } else { Vec::new() };
            let surfaces = vec![SurfaceId(index % 6), SurfaceId((index * 5 + 1) % 6)];
            let (name, place) = (format!("object {index}"), Place::default());
            Object { name, parent_from_local: transform(random, depth), surfaces, children, place }
        })
        .collect();
    Scene {
        facing: Default::default(),
        textures: Vec::new(),
        files: vec!["by hand".into()],
        objects,
        surfaces,
        world: (0..4).map(ObjectId).collect(),
        lights: (0..4).map(|index| light(random, index, kinds)).collect(),
        camera: Some(Camera {
            from: Vec3::new(0.3, -9.0, 2.1),
            at: Vec3::new(0.1, 0.0, 0.2),
            up: Vec3::Z,
            angle: 41.0,
            hither: 0.5,
            yon: None,
            resolution: (72, 64),
            place: Place::default(),
        }),
        background: Some(Rgb::new(0.078, 0.361, 0.753)),
    }
}

fn color(random: &mut Random) -> Rgb {
    Rgb::new(random.between(0.1, 1.0), random.between(0.1, 1.0), random.between(0.1, 1.0))
}

/// Turned about a skew axis, stretched unequally, every other one mirrored.
fn transform(random: &mut Random, depth: u32) -> Affine3 {
    let axis = Vec3::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0), 1.0).normalize();
    let turn = turned(axis, random.between(-3.0, 3.0));
    let mut stretch = Vec3::new(random.between(0.5, 1.3), random.between(0.5, 1.3), random.between(0.5, 1.3));
    stretch.x *= if random.between(0.0, 1.0) < 0.5 { -1.0 } else { 1.0 };
    let reach = if depth == 0 { 2.2 } else { 0.9 };
    let mut along = || random.between(-reach, reach);
    let translation = Vec3::new(along(), along(), along());
    Affine3 { matrix3: turn * Mat3::from_diagonal(stretch), translation }
}

/// Rodrigues' rotation.
fn turned(axis: Vec3, angle: f64) -> Mat3 {
    let column = |v: Vec3| v * cos(angle) + axis.cross(v) * sin(angle) + axis * (axis.dot(v) * (1.0 - cos(angle)));
    Mat3::from_cols(column(Vec3::X), column(Vec3::Y), column(Vec3::Z))
}

fn light(random: &mut Random, index: u32, kinds: Kinds) -> Light {
    let mut along = || random.between(-7.0, 7.0);
    let position = Vec3::new(along(), along() - 5.0, along() + 4.0);
    let (color, place) = (color(random) * 0.5, Place::default());
    let point = Light { intensity: Some(1.0), ..Light::point(position, color, place) };
    let source = match (kinds, index) {
        (Kinds::All, 0) => LightSource::Directional { to_light: position },
        (Kinds::All, 1) => LightSource::Spot { position, at: Vec3::ZERO, opening: 35.0, edge: SpotEdge::Soft },
        (Kinds::All, 2) => LightSource::Spot { position, at: Vec3::ZERO, opening: 20.0, edge: SpotEdge::Sharp },
        _ => point.source,
    };
    // The last leaves its intensity to the renderer.
    Light { source, intensity: if index == 3 { None } else { Some(0.3 + f64::from(index) * 0.7) }, ..point }
}

fn surface(random: &mut Random, index: u32, kinds: Kinds) -> Surface {
    let reflection = match (kinds, index % 3) {
        (_, 0) => Reflection::Phong,
        (Kinds::All, 1) => Reflection::Basic { c3: random.between(0.05, 1.0) },
        (_, 1) => Reflection::Phong,
        _ => Reflection::Nff,
    };
    let opacity = [Rgb::WHITE, Rgb::new(0.9, 0.3, 0.6), Rgb::gray(0.1), Rgb::WHITE, Rgb::gray(0.5), Rgb::WHITE];
    let material = Material {
        texture: None,
        reflection,
        color: color(random),
        ambient: if reflection == Reflection::Nff { None } else { Some(random.between(0.05, 0.4)) },
        diffuse: random.between(0.3, 0.9),
        specular: if index == 3 { 0.0 } else { random.between(0.1, 0.8) },
        shine: f64::from(index * 9 + 1),
        opacity: opacity[index as usize],
        refraction: 1.0,
    };
    let mesh = if index.is_multiple_of(2) { bowl(random) } else { ball() };
    Surface { material, mesh, primitives: Vec::new(), two_sided: index.is_multiple_of(2), place: Place::default() }
}

/// An open sheet of quadrilaterals, each split in two, with averaged normals; one vertex has a normal of its own.
fn bowl(random: &mut Random) -> Mesh {
    let mut mesh = Mesh::default();
    let bend = random.between(0.2, 0.6);
    for row in 0..5 {
        for column in 0..5 {
            let (x, y) = (f64::from(column) / 2.5 - 0.8, f64::from(row) / 2.5 - 0.8);
            mesh.push_vertex(Vec3::new(x, y, bend * (x * x + y * y)));
        }
    }
    mesh.normals = vec![Vec3::ZERO; mesh.vertices.len()];
    mesh.normals[7] = Vec3::new(0.6, 0.0, 0.8);
    for row in 0..4 {
        for column in 0..4 {
            let first = row * 5 + column;
            for outline in [[first, first + 1, first + 6], [first, first + 6, first + 5]] {
                mesh.push_polygon(&outline, NormalSource::Averaged, row + 1);
            }
        }
    }
    // And one flat facet.
    mesh.push_polygon(&[0, 4, 24, 20], NormalSource::Facet, 9);
    mesh
}

fn ball() -> Mesh {
    let mut mesh = Mesh::default();
    let shape = Shape::Sphere { center: Vec3::new(0.1, 0.0, 0.2), radius: 0.6 };
    tessellate(&shape, false, Detail::Segments(10), 3, &mut mesh);
    mesh
}
