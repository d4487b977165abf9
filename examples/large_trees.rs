//! What trees of extreme form cost: 100,000 objects inside each other, 1,000,000 beside each other.
//!
//! `cargo run --release --example large_trees` prints, for each, the size of its text and the seconds of printing, parsing, drawing at
//! 64 x 64 and dropping. Nothing of it may recurse: the stack of a thread holds some ten thousand calls.

use farop::math::{Affine3, Vec3};
use farop::parse::{ParseOptions, read_sipp};
use farop::plan::Choices;
use farop::raster::ZBuffer;
use farop::render::render;
use farop::scene::{
    Camera, Material, Mesh, NormalSource, Object, ObjectId, Place, Reflection, Scene, Surface, SurfaceId,
};
use farop::write::write_sipp;
use std::time::Instant;

fn main() {
    println!("{:<26}{:>10}{:>9}{:>9}{:>9}{:>9}", "objects", "MB", "print", "parse", "draw", "drop");
    measure("100,000 nested", nested(100_000));
    measure("1,000,000 uses of one", siblings(1_000_000, true));
    measure("1,000,000 of their own", siblings(1_000_000, false));
}

fn measure(name: &str, scene: Scene) {
    let mut text = Vec::new();
    let printing = seconds(|| write_sipp(&scene, &mut text).expect("memory takes it"));
    drop(scene);
    let mut parsed = None;
    let parsing = seconds(|| {
        parsed = Some(read_sipp(name, &text, ParseOptions::default()).unwrap_or_else(|errors| panic!("{errors}")).scene)
    });
    let scene = parsed.expect("it was read");
    let choices = Choices { size: Some((64, 64)), ..Choices::default() };
    let mut polygons = 0;
    let drawing =
        seconds(|| polygons = render(&scene, &choices, Some(&ZBuffer)).expect("a plain scene").counts.polygons);
    let dropping = seconds(|| drop(scene));
    let megabytes = text.len() as f64 / 1e6;
    println!(
        "{name:<26}{megabytes:>10.1}{printing:>9.2}{parsing:>9.2}{drawing:>9.2}{dropping:>9.2}   {polygons} polygons"
    );
}

fn seconds<T>(work: impl FnOnce() -> T) -> f64 {
    let start = Instant::now();
    let _ = work();
    start.elapsed().as_secs_f64()
}

/// Each inside the one before, a little to its right.
fn nested(count: u32) -> Scene {
    let objects = (0..count).map(|index| Object {
        name: String::new(),
        parent_from_local: Affine3::from_translation(Vec3::X / f64::from(count)),
        surfaces: vec![SurfaceId(0)],
        children: (index + 1 < count).then_some(ObjectId(index + 1)).into_iter().collect(),
        place: Place::default(),
    });
    Scene {
        objects: objects.collect(),
        surfaces: vec![leaf()],
        world: vec![ObjectId(0)],
        camera: Some(camera()),
        ..Scene::default()
    }
}

/// All children of the world, in rows; each with a surface of its own, or all with the same.
fn siblings(count: u32, same: bool) -> Scene {
    let side = f64::from(count).sqrt().ceil();
    let objects = (0..count).map(|index| {
        let place = Vec3::new(f64::from(index) % side, (f64::from(index) / side).floor(), 0.0) * (2.0 / side)
            - Vec3::splat(1.0);
        Object {
            name: if same { "leaf".to_string() } else { String::new() },
            parent_from_local: Affine3::from_translation(place),
            surfaces: vec![SurfaceId(if same { 0 } else { index })],
            children: Vec::new(),
            place: Place::default(),
        }
    });
    let surfaces = vec![leaf(); if same { 1 } else { count as usize }];
    Scene {
        objects: objects.collect(),
        surfaces,
        world: (0..count).map(ObjectId).collect(),
        camera: Some(camera()),
        ..Scene::default()
    }
}

/// A small triangle.
fn leaf() -> Surface {
    let mut mesh = Mesh::default();
    let corners = [(0.0, 0.0), (0.1, 0.0), (0.0, 0.1)].map(|(x, y)| mesh.push_vertex(Vec3::new(x, y, 0.0)));
    mesh.push_polygon(&corners, NormalSource::Facet, 0);
    let material = Material { reflection: Reflection::Phong, ambient: Some(0.3), ..Material::default() };
    Surface { material, mesh, primitives: Vec::new(), two_sided: false, place: Place::default() }
}

fn camera() -> Camera {
    let (from, at, up) = (Vec3::Z * 5.0, Vec3::ZERO, Vec3::Y);
    Camera { from, at, up, angle: 40.0, hither: 0.1, yon: None, resolution: (64, 64), place: Place::default() }
}
