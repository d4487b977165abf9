//! Random meshes, for checks of rasterizers that treat polygons by their size: finer than a sample, slivers, huge, coplanar.
//!
//! seed -> Scene, Choices
//!
//! Space: as in [`super::random_scenes`].

use super::Random;
use super::random_scenes::{camera, scene, surface, world};
use crate::color::Rgb;
use crate::math::{Vec3, unit};
use crate::plan::{Choices, Culling, DepthFormat, Shading, Transparency};
use crate::scene::{Light, Material, Mesh, NormalSource, Place, Scene};

/// The mesh scene that belongs to `seed`.
pub(super) fn mesh(seed: u64) -> Scene {
    let mut random = Random::new(seed ^ 0x6D65_7368);
    let (width, height) = (1 + random.below(160) as u32, 1 + random.below(120) as u32);
    let transparent = random.once_in(3);
    let mut surfaces = Vec::new();
    for number in 0..1 + random.below(3) {
        let mut mesh = Mesh::default();
        match random.below(5) {
            0 => push_patch(&mut random, &mut mesh, 24),
            1 => push_patch(&mut random, &mut mesh, 4),
            2 => push_slivers(&mut random, &mut mesh),
            3 => push_huge(&mut random, &mut mesh),
            _ => push_layers(&mut random, &mut mesh),
        }
        let color = Rgb::new(random.unit(), random.unit(), random.unit());
        let mut material = Material { color, diffuse: 0.7, specular: 0.2, shine: 9.0, ..Material::default() };
        if transparent && number % 2 == 0 {
            material.opacity = Rgb::new(0.25, random.unit(), 0.75);
        }
        surfaces.push(surface(material, mesh));
    }
    let mut scene = scene(camera(width, height), surfaces);
    if let Some(camera) = &mut scene.camera {
        camera.yon = Some(1e3);
    }
    scene.lights.push(Light::point(Vec3::new(5.0, 1.0, 0.0), Rgb::new(1.0, 0.75, 0.5), Place::default()));
    scene.background = Some(Rgb::new(0.25, 0.375, 0.5));
    scene
}

/// Choices for it: mostly the common ones, as those have paths of their own.
pub(super) fn mesh_choices(seed: u64) -> Choices {
    let mut random = Random::new(seed ^ 0x6368_6F69);
    let mut pick = |count: u64| random.below(count) as usize;
    Choices {
        shading: [Shading::Flat, Shading::Gouraud, Shading::Phong][pick(3)],
        subpixel_bits: [8, 8, 8, 8, 0, 4, 16][pick(7)],
        depth: [DepthFormat::F32, DepthFormat::F32, DepthFormat::F32, DepthFormat::F64, DepthFormat::Int16][pick(5)],
        culling: [Culling::None, Culling::Back][pick(2)],
        transparency: Transparency::ALL[pick(2)],
        samples: [1, 1, 1, 2, 3, 4][pick(6)],
        ..Choices::default()
    }
}

fn place(random: &mut Random) -> Vec3 {
    let w = random.between(1.2, 6.0);
    Vec3::new(random.between(-0.9, 0.9) * w, random.between(-0.9, 0.9) * w, w)
}

fn push(random: &mut Random, mesh: &mut Mesh, eye: Vec3) -> u32 {
    let normal = Vec3::new(random.between(-0.7, 0.7), random.between(-0.7, 0.7), 1.0);
    mesh.push_vertex_with_normal(world(eye), unit(normal).unwrap_or(Vec3::Z))
}

/// A bent patch of `n` x `n` cells, as triangles or quads; from all over the picture to a few samples.
fn push_patch(random: &mut Random, mesh: &mut Mesh, n: u32) {
    let (origin, size) = (place(random), random.between(0.02, 3.0));
    let (u, v) = (place(random) * (size / 4.0), place(random) * (size / 4.0));
    let flat = random.once_in(2);
    let mut corners = Vec::new();
    for row in 0..=n {
        for column in 0..=n {
            let (s, t) = (f64::from(column) / f64::from(n), f64::from(row) / f64::from(n));
            let bump = if flat { 0.0 } else { random.between(-0.01, 0.01) };
            corners.push(push(random, mesh, origin + u * s + v * t + Vec3::new(0.0, 0.0, bump)));
        }
    }
    let at = |column: u32, row: u32| corners[(row * (n + 1) + column) as usize];
    for row in 0..n {
        for column in 0..n {
            let [a, b, c, d] = [at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1)];
            if flat && (row + column) % 3 == 0 {
                mesh.push_polygon(&[a, b, c, d], NormalSource::Given, 1);
            } else {
                mesh.push_polygon(&[a, b, c], NormalSource::Given, 1);
                mesh.push_polygon(&[a, c, d], NormalSource::Given, 1);
            }
        }
    }
}

/// Long triangles, hardly any width.
fn push_slivers(random: &mut Random, mesh: &mut Mesh) {
    for _ in 0..30 {
        let (from, to) = (place(random), place(random));
        let aside = place(random) * random.between(1e-5, 0.01);
        let corners = [from, to, to + aside].map(|corner| push(random, mesh, corner));
        mesh.push_polygon(&corners, NormalSource::Given, 1);
    }
}

/// Triangles far larger than the picture.
fn push_huge(random: &mut Random, mesh: &mut Mesh) {
    for _ in 0..4 {
        let middle = place(random);
        let corners = [(); 3].map(|()| {
            let away = place(random) * random.between(1.0, 200.0);
            let corner = middle + Vec3::new(away.x, away.y, random.between(-1.0, 4.0));
            push(random, mesh, corner)
        });
        mesh.push_polygon(&corners, NormalSource::Given, 1);
    }
}

/// Quads over each other, some in the same plane, nearer and farther in turn.
fn push_layers(random: &mut Random, mesh: &mut Mesh) {
    let distances = [4.0, 2.0, 2.0, 3.0, random.between(1.1, 5.0), 2.0];
    for distance in distances {
        let (left, top) = (random.between(-1.1, 0.3) * distance, random.between(-1.1, 0.3) * distance);
        let (width, height) = (random.between(0.1, 1.5) * distance, random.between(0.1, 1.5) * distance);
        let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]
            .map(|(s, t)| push(random, mesh, Vec3::new(left + s * width, top + t * height, distance)));
        mesh.push_polygon(&corners, NormalSource::Given, 1);
    }
}
