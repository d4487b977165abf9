//! What the geometry stage costs: `cargo run --release --example geometry_speed [ROUNDS] [THREADS] [NAME]`.
//!
//! Prints; judges nothing. Nanoseconds of processor time (user and system, of all threads) a polygon that goes in; scenes take
//! turns round by round; medians. *First*: with a new stage into a new draw list, as a single picture is made. *Again*: with stage and list of
//! the round before, as a walk through a scene does it. `scaling` as NAME prints how time and memory grow with the number of triangles
//! instead, up to five million: the list then takes 2.2 GB.

use farop::color::Rgb;
use farop::geometry::Stage;
use farop::math::{Affine3, Vec3, cos, sin};
use farop::parse::{ParseOptions, read_nff};
use farop::plan::{Accepts, Choices, Plan, Shading};
use farop::report::StageTimer;
use farop::scene::{Camera, Light, Material, Mesh, NormalSource, Object, ObjectId, Place, Scene, Surface, SurfaceId};
use farop::screen::{DrawList, Plane, PolygonRecord, ScreenVertex};
use farop::spd::{self, Curves};

/// Built-in scenes and their sizes; spheres and cones as such, so that turning them into polygons is part of the time.
const SCENES: [(&str, u32); 6] =
    [("tetra", 9), ("balls", 4), ("teapot", 40), ("gears", 4), ("mount", 8), ("lattice", 8)];

fn standard(name: &str, size: u32) -> Scene {
    let mut text = Vec::new();
    spd::generate(spd::find(name).expect("is built in"), size, Curves::Kept, &mut text).expect("memory takes it");
    read_nff(name, &text, ParseOptions::default()).expect("a legal scene").scene
}

/// Hills of `side` x `side` cells, two triangles each, in as many surfaces as asked for; lit by two lamps, all of it in view.
fn hills(side: usize, surfaces: usize) -> Scene {
    let place = Place::default();
    let material = Material { color: Rgb::new(0.7, 0.6, 0.5), diffuse: 0.7, ..Material::default() };
    let rows = side.div_ceil(surfaces);
    let surfaces: Vec<Surface> = (0..surfaces)
        .map(|part| {
            let mesh = strip(side, part * rows..((part + 1) * rows).min(side));
            Surface { material, mesh, primitives: vec![], two_sided: false, place }
        })
        .collect();
    let object = Object {
        name: String::new(),
        parent_from_local: Affine3::IDENTITY,
        surfaces: (0..surfaces.len() as u32).map(SurfaceId).collect(),
        children: vec![],
        place,
    };
    let (from, at, up) = (Vec3::new(0.0, 1.5, 2.2), Vec3::ZERO, Vec3::Y);
    Scene {
        facing: Default::default(),
        textures: Vec::new(),
        files: vec!["made".into()],
        objects: vec![object],
        surfaces,
        world: vec![ObjectId(0)],
        lights: vec![
            Light::point(Vec3::new(-3.0, 4.0, 2.0), Rgb::new(0.6, 0.6, 0.6), place),
            Light::point(Vec3::new(5.0, 1.0, 0.0), Rgb::new(0.4, 0.3, 0.3), place),
        ],
        camera: Some(Camera { from, at, up, angle: 60.0, hither: 0.1, yon: None, resolution: (1024, 1024), place }),
        background: None,
    }
}

/// Some rows of the hills; vertices are shared and have normals.
fn strip(side: usize, rows: std::ops::Range<usize>) -> Mesh {
    let mut mesh = Mesh::default();
    let along = |step: usize| step as f64 / side as f64 * 2.0 - 1.0;
    for row in rows.start..=rows.end.max(rows.start) {
        for column in 0..=side {
            let (x, z) = (along(column), along(row));
            let (height, slope) = (0.1 * sin(9.0 * x) * cos(7.0 * z), 0.9 * cos(9.0 * x) * cos(7.0 * z));
            let normal = Vec3::new(-slope, 1.0, 0.7 * sin(9.0 * x) * sin(7.0 * z)).normalize();
            mesh.push_vertex_with_normal(Vec3::new(x, height, z), normal);
        }
    }
    for row in 0..rows.len() {
        for column in 0..side {
            let [a, b] = [0, 1].map(|next| ((row + next) * (side + 1) + column) as u32);
            mesh.push_polygon(&[a, b, b + 1], NormalSource::Given, 0);
            mesh.push_polygon(&[a, b + 1, a + 1], NormalSource::Given, 0);
        }
    }
    mesh
}

/// Milliseconds of processor time, and how many polygons went in.
fn time(scene: &Scene, plan: &Plan, (stage, list): &mut (Stage, DrawList)) -> (f64, u64) {
    let timer = StageTimer::start();
    let counts = stage.run(scene, plan, list);
    let time = timer.stop();
    (time.user + time.system, counts.polygons + counts.tessellated.polygons)
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

fn plan(scene: &Scene, shading: Shading, threads: u32) -> Plan {
    let choices = Choices { size: Some((1024, 1024)), shading, threads: Some(threads), ..Choices::default() };
    Plan::new(scene, &choices, Accepts::AnyPolygon).expect("a usable view")
}

fn bytes(list: &DrawList) -> usize {
    list.vertices.len() * size_of::<ScreenVertex>()
        + list.values.len() * size_of::<f64>()
        + list.planes.len() * size_of::<Plane>()
        + list.polygons.len() * size_of::<PolygonRecord>()
}

/// A stage without memory, and an empty list.
fn new() -> (Stage, DrawList) {
    (Stage::default(), DrawList::new(0, 0))
}

/// A scene, how it is shaded, stage and list of its last frame, and the times of its first and later frames.
struct Case {
    name: String,
    scene: Scene,
    plan: Plan,
    kept: (Stage, DrawList),
    times: [Vec<f64>; 2],
    polygons: u64,
}

fn compare(rounds: usize, threads: u32, filter: &str) {
    let mut scenes: Vec<(String, Scene)> =
        SCENES.iter().map(|&(name, size)| (format!("{name}:{size}"), standard(name, size))).collect();
    scenes.push(("hills, 1 surface".into(), hills(362, 1)));
    scenes.push(("hills, 362 surfaces".into(), hills(362, 362)));
    let mut cases = Vec::new();
    for (name, scene) in scenes.into_iter().filter(|(name, _)| name.contains(filter)) {
        for shading in [Shading::Gouraud, Shading::Phong] {
            let (name, plan) = (format!("{name} {}", shading.name()), plan(&scene, shading, threads));
            cases.push(Case { name, scene: scene.clone(), plan, kept: new(), times: [vec![], vec![]], polygons: 0 });
        }
    }
    for _ in 0..rounds {
        for case in &mut cases {
            let (first, polygons) = time(&case.scene, &case.plan, &mut new());
            let (again, _) = time(&case.scene, &case.plan, &mut case.kept);
            case.polygons = polygons;
            case.times[0].push(first);
            case.times[1].push(again);
        }
    }
    println!("{rounds} rounds, {threads} threads, ns of processor time a polygon that goes in (medians)");
    println!("{:<28} {:>9} {:>9} {:>7} {:>7} {:>6}", "scene", "polygons", "drawn", "first", "again", "B/drawn");
    for case in cases {
        let [first, again] = case.times.map(|times| median(times) * 1e6 / case.polygons.max(1) as f64);
        let (polygons, drawn) = (case.polygons, case.kept.1.len());
        let each = bytes(&case.kept.1) / drawn.max(1);
        println!("{:<28} {polygons:>9} {drawn:>9} {first:>7.1} {again:>7.1} {each:>6}", case.name);
    }
}

/// How time and memory grow from a thousand triangles on.
fn scaling(rounds: usize, threads: u32) {
    println!("hills in one surface, {threads} threads, later frames");
    println!("{:>9} {:>12} {:>12} {:>9} {:>8}", "triangles", "ns each", "ms", "exponent", "B each");
    let mut last: Option<(f64, f64)> = None;
    for side in [23, 71, 224, 707, 1581] {
        let scene = hills(side, 1);
        let plan = plan(&scene, Shading::Gouraud, threads);
        let mut kept = new();
        time(&scene, &plan, &mut kept);
        // The clock of the processor ticks in microseconds: many small frames as one.
        let repeat = (500 / side).max(1);
        let rounds = if side > 1000 { rounds.min(3) } else { rounds };
        let times = (0..rounds).map(|_| (0..repeat).map(|_| time(&scene, &plan, &mut kept).0).sum::<f64>());
        let (time, triangles) = (median(times.collect()) / repeat as f64, (2 * side * side) as f64);
        let exponent = last.map_or(f64::NAN, |(time_before, triangles_before)| {
            (time / time_before).ln() / (triangles / triangles_before).ln()
        });
        let each = bytes(&kept.1) as f64 / kept.1.len() as f64;
        println!("{triangles:>9} {:>12.1} {time:>12.3} {exponent:>9.3} {each:>8.1}", time * 1e6 / triangles);
        last = Some((time, triangles));
    }
}

fn main() {
    let mut arguments = std::env::args().skip(1);
    let rounds = arguments.next().and_then(|text| text.parse().ok()).unwrap_or(7);
    let threads = arguments.next().and_then(|text| text.parse().ok()).unwrap_or(1);
    match arguments.next() {
        Some(name) if name == "scaling" => scaling(rounds, threads),
        name => compare(rounds, threads, &name.unwrap_or_default()),
    }
}
