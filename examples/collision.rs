//! A ball that meets trees, as a moving picture: it turns red where their volumes have a point in common.
//!
//! `cargo run --release --example collision [OUT.gif|OUT.y4m|FOLDER]`
//!
//! The scene of paper 004: a ball of radius 0.5 rolls past trees and into them. Each tree's volumes are drawn: a thin box for the stem
//! and a ball for the crown. First half: the ball goes where it wants and shows what it hits; second half: it slides along.

use farop::color::{Encoding, Rgb};
use farop::forest::collide::{Obstacles, Response, Volume, of_tree};
use farop::image::movie::Movie;
use farop::math::{Affine3, Vec3};
use farop::plan::Choices;
use farop::raster::ZBuffer;
use farop::render::render;
use farop::scene::{
    Camera, Light, Material, Mesh, Object, ObjectId, Place, Primitive, Scene, Shape, Surface, SurfaceId,
};
use std::path::Path;

const RADIUS: f64 = 0.5;
const FRAMES: u32 = 60;
const SIZE: (u32, u32) = (192, 144);

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let name = std::env::args().nth(1).unwrap_or("collision.gif".to_string());
    let feet = [(0.0, 0.0), (3.0, 1.2), (5.6, -0.8), (8.0, 0.3)];
    let volumes: Vec<Volume> =
        feet.iter().flat_map(|&(x, y)| of_tree(Vec3::new(x, y, 0.0), 5.0, 2.2, Some(2.4))).collect();
    let obstacles = Obstacles::new(volumes);
    let mut movie = Movie::create(Path::new(&name), (SIZE.0 as usize, SIZE.1 as usize), 25)?;
    let mut hits = [0, 0];
    for (half, slides) in [false, true].into_iter().enumerate() {
        let mut ball = Vec3::new(-3.0, 0.05, RADIUS);
        for _ in 0..FRAMES {
            let wanted = ball + Vec3::new(14.0 / f64::from(FRAMES), 0.0, 0.0);
            let step = obstacles.advance((ball, wanted), RADIUS, Response::Slide);
            let is_hit = if slides { step.hit } else { obstacles.met_by(wanted, RADIUS) }.is_some();
            ball = if slides { step.to } else { wanted };
            hits[half] += u32::from(is_hit);
            let image = render(&scene(&obstacles, ball, is_hit), &Choices::default(), Some(&ZBuffer))?.image;
            movie.push(&image.encode(Encoding::Srgb))?;
        }
    }
    let frames = movie.finish()?;
    println!("{name}: {frames} frames; it met a tree in {} frames, and slid along one in {}", hits[0], hits[1]);
    Ok(())
}

/// Everything that is seen: volumes, ground, and the ball in its color.
fn scene(obstacles: &Obstacles, ball: Vec3, is_hit: bool) -> Scene {
    let mut scene = Scene { background: Some(Rgb::new(0.75, 0.85, 0.95)), ..Scene::default() };
    let color = if is_hit { Rgb::new(0.9, 0.1, 0.1) } else { Rgb::new(0.2, 0.4, 0.9) };
    add(&mut scene, color, Shape::Sphere { center: Vec3::ZERO, radius: RADIUS }, ball);
    for volume in obstacles.volumes() {
        match *volume {
            Volume::Ball { center, radius } => {
                add(&mut scene, Rgb::new(0.2, 0.5, 0.2), Shape::Sphere { center: Vec3::ZERO, radius }, center);
            }
            Volume::Box { low, high } => {
                add(&mut scene, Rgb::new(0.45, 0.3, 0.2), Shape::Block { size: high - low }, (low + high) * 0.5);
            }
        }
    }
    add(
        &mut scene,
        Rgb::new(0.6, 0.6, 0.4),
        Shape::Block { size: Vec3::new(30.0, 16.0, 0.1) },
        Vec3::new(3.0, 0.0, -0.05),
    );
    let (from, at) = (Vec3::new(1.0, -13.0, 7.0), Vec3::new(3.5, 0.0, 1.2));
    let place = Place::default();
    scene.camera = Some(Camera { from, at, up: Vec3::Z, angle: 45.0, hither: 0.5, yon: None, resolution: SIZE, place });
    scene.lights.push(Light::point(Vec3::new(-20.0, -30.0, 40.0), Rgb::WHITE, place));
    scene
}

fn add(scene: &mut Scene, color: Rgb, shape: Shape, at: Vec3) {
    let place = Place::default();
    let material = Material { color, ..Material::default() };
    let (object, surface) = (ObjectId(scene.objects.len() as u32), SurfaceId(scene.surfaces.len() as u32));
    let primitives = vec![Primitive::new(shape, 0, 0)];
    scene.surfaces.push(Surface { material, mesh: Mesh::default(), primitives, two_sided: false, place });
    let parent_from_local = Affine3::from_translation(at);
    let surfaces = vec![surface];
    scene.objects.push(Object { name: String::new(), parent_from_local, surfaces, children: Vec::new(), place });
    scene.world.push(object);
}
