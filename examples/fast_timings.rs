//! Raster times of `fast` beside the z-buffer, list in and picture out: `cargo run --release --example fast_timings [ROUNDS] [THREADS] [NAME]`.
//!
//! Prints; judges nothing. Cases take turns round by round; medians. NAME picks the scenes whose name contains it.

use farop::color::Rgb;
use farop::image::Image;
use farop::math::{Affine3, Vec3, cos, sin};
use farop::parse::{ParseOptions, read_nff, scene_of_triangles};
use farop::plan::{Choices, Culling, Shading};
use farop::raster::fast::{Fast, Instructions};
use farop::raster::{PerPolygon, Rasterizer, Wire, ZBuffer};
use farop::render::{Canvas, draw, draw_pixels, list};
use farop::scene::{Camera, Light, Material, Mesh, NormalSource, Object, ObjectId, Place, Scene, Surface, SurfaceId};
use farop::screen::DrawList;
use farop::spd::{self, Curves};
use nix::time::{ClockId, clock_gettime};
use std::time::Instant;

const SIDE: u32 = 1024;

fn standard(name: &str, size: u32) -> Scene {
    let mut text = Vec::new();
    spd::generate(spd::find(name).expect("is built in"), size, Curves::Kept, &mut text).expect("memory takes it");
    read_nff(name, &text, ParseOptions::default()).expect("a legal scene").scene
}

fn scene_of(mesh: Mesh) -> Scene {
    let place = Place::default();
    let material =
        Material { color: Rgb::new(0.7, 0.6, 0.5), diffuse: 0.7, specular: 0.3, shine: 20.0, ..Material::default() };
    let object = Object {
        name: String::new(),
        parent_from_local: Affine3::IDENTITY,
        surfaces: vec![SurfaceId(0)],
        children: vec![],
        place,
    };
    let (from, at, up) = (Vec3::ZERO, Vec3::NEG_Z, Vec3::Y);
    Scene {
        facing: Default::default(),
        textures: Vec::new(),
        files: vec!["made".into()],
        objects: vec![object],
        surfaces: vec![Surface { material, mesh, primitives: vec![], two_sided: false, place }],
        world: vec![ObjectId(0)],
        lights: vec![
            Light::point(Vec3::new(-3.0, 4.0, 2.0), Rgb::new(0.6, 0.6, 0.6), place),
            Light::point(Vec3::new(5.0, 1.0, 0.0), Rgb::new(0.4, 0.3, 0.3), place),
        ],
        camera: Some(Camera { from, at, up, angle: 90.0, hither: 0.5, yon: None, resolution: (SIDE, SIDE), place }),
        background: Some(Rgb::new(0.25, 0.375, 0.5)),
    }
}

/// Small balls in a shell, `triangles` in all: most pixels see several layers of small triangles.
fn balls(triangles: usize) -> Scene {
    let mut mesh = Mesh::default();
    let (rings, sectors) = (16, 32);
    let each = rings * sectors * 2;
    let count = (triangles / each).max(1);
    let mut state = 1u64;
    let mut random = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    let radius = 1.9 / (count as f64).sqrt();
    for _ in 0..count {
        let middle = Vec3::new(random() * 3.6 - 1.8, random() * 3.6 - 1.8, -2.0 - 2.0 * random());
        let mut vertices = Vec::new();
        for ring in 0..=rings {
            let latitude = (ring as f64 / rings as f64 - 0.5) * std::f64::consts::PI;
            for sector in 0..sectors {
                let longitude = sector as f64 / sectors as f64 * 2.0 * std::f64::consts::PI;
                let normal = Vec3::new(cos(latitude) * cos(longitude), sin(latitude), cos(latitude) * -sin(longitude));
                vertices.push(mesh.push_vertex_with_normal(middle + normal * radius * 2.0, normal));
            }
        }
        for ring in 0..rings {
            for sector in 0..sectors {
                let next = (sector + 1) % sectors;
                let [a, b, c, d] = [(ring, sector), (ring, next), (ring + 1, next), (ring + 1, sector)]
                    .map(|(ring, sector)| vertices[ring * sectors + sector]);
                mesh.push_polygon(&[a, b, c], NormalSource::Given, 1);
                mesh.push_polygon(&[a, c, d], NormalSource::Given, 1);
            }
        }
    }
    scene_of(mesh)
}

/// Four screen-filling layers of 8 x 8 quads, far to near.
fn fill() -> Scene {
    let mut mesh = Mesh::default();
    for layer in 0..4 {
        let distance = 5.0 - f64::from(layer);
        for row in 0..8 {
            for column in 0..8 {
                let corner = |x: i32, y: i32| {
                    let (x, y) = (f64::from(x - 4) / 4.0, f64::from(y - 4) / 4.0);
                    Vec3::new(x * distance, y * distance, -distance - 0.2 * x)
                };
                let corners = [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(dx, dy)| {
                    let place = corner(column + dx, row + dy);
                    mesh.push_vertex_with_normal(place, Vec3::new(place.x * 0.2, place.y * 0.2, 1.0).normalize())
                });
                mesh.push_polygon(&corners, NormalSource::Given, 1);
            }
        }
    }
    scene_of(mesh)
}

/// Trees with holes, one behind the other.
fn forest(name: &str) -> Scene {
    let triangles = spd::bench::triangles(name).expect("is built in");
    scene_of_triangles(name, &triangles).expect("a legal scene").scene
}

/// Milliseconds: of the processor on one thread, of the clock on several.
struct Stopwatch(Instant, f64, bool);

fn processor() -> f64 {
    let time = clock_gettime(ClockId::CLOCK_THREAD_CPUTIME_ID).expect("the clock is there");
    time.tv_sec() as f64 * 1e3 + time.tv_nsec() as f64 / 1e6
}

impl Stopwatch {
    fn start(threads: u32) -> Stopwatch {
        Stopwatch(Instant::now(), processor(), threads == 1)
    }

    fn stop(&self) -> f64 {
        if self.2 { processor() - self.1 } else { self.0.elapsed().as_secs_f64() * 1e3 }
    }
}

fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

struct Case {
    name: String,
    wire: bool,
    list: DrawList,
    canvas: Canvas,
}

/// Makes a scene when it is its turn.
type MakeScene = Box<dyn Fn() -> Scene>;

fn cases(threads: u32, only: &str) -> Vec<Case> {
    let scenes: Vec<(&str, MakeScene)> = vec![
        ("gears:4", Box::new(|| standard("gears", 4))),
        ("mount:8", Box::new(|| standard("mount", 8))),
        ("teapot:20", Box::new(|| standard("teapot", 20))),
        ("tetra:9", Box::new(|| standard("tetra", 9))),
        ("balls:10k", Box::new(|| balls(10_000))),
        ("balls:100k", Box::new(|| balls(100_000))),
        ("balls:1m", Box::new(|| balls(1_000_000))),
        ("fill", Box::new(fill)),
        ("forest:10k", Box::new(|| forest("forest:10k"))),
        ("forest:125k", Box::new(|| forest("forest:125k"))),
    ];
    let mut cases = Vec::new();
    for (name, scene) in scenes.into_iter().filter(|(name, _)| name.contains(only.split('/').next().unwrap_or(""))) {
        let scene = scene();
        let modes = [
            ("wire", Shading::Wire, 1),
            ("flat", Shading::Flat, 1),
            ("gouraud", Shading::Gouraud, 1),
            ("phong", Shading::Phong, 1),
            ("gouraud-A2", Shading::Gouraud, 2),
        ];
        for (mode, shading, samples) in modes {
            if !mode.contains(only.split('/').nth(1).unwrap_or("")) {
                continue;
            }
            let choices = Choices {
                size: Some((SIDE, SIDE)),
                shading,
                samples,
                culling: Culling::Back,
                threads: Some(threads),
                ..Choices::default()
            };
            let canvas = Canvas::new(&scene, &choices);
            let list = list(&scene, &choices, Some(&ZBuffer)).expect("a usable view");
            cases.push(Case { name: format!("{name} {mode}"), wire: shading == Shading::Wire, list, canvas });
        }
    }
    cases
}

/// What each trick buys: the same list with one of them left out.
fn each_trick(rounds: usize, threads: u32, only: &str) {
    let without = |change: fn(&mut Fast)| {
        let mut fast = Fast::default();
        change(&mut fast);
        fast
    };
    let ways: Vec<(&str, Fast)> = vec![
        ("all", Fast::default()),
        ("no small", without(|fast| fast.shortcuts.small = false)),
        ("no blocks", without(|fast| fast.shortcuts.blocks = false)),
        ("no far", without(|fast| fast.shortcuts.far = false)),
        ("no holes", without(|fast| fast.shortcuts.holes = false)),
        ("no light", without(|fast| fast.shortcuts.light = false)),
        ("avx2", without(|fast| fast.instructions = Instructions::Avx2)),
        ("sse2", without(|fast| fast.instructions = Instructions::Baseline)),
        ("plain", without(|fast| fast.instructions = Instructions::Plain)),
        ("tile 16", without(|fast| fast.tile_side = 16)),
        ("tile 32", without(|fast| fast.tile_side = 32)),
        ("tile 128", without(|fast| fast.tile_side = 128)),
        ("tile 256", without(|fast| fast.tile_side = 256)),
    ];
    println!("{:<22}{}", "case", ways.iter().map(|(name, _)| format!("{name:>10}")).collect::<String>());
    for case in cases(threads, only).into_iter().filter(|case| !case.wire) {
        let mut image = Image::new(SIDE as usize, SIDE as usize, Rgb::gray(0.0));
        let mut times = vec![Vec::new(); ways.len()];
        for round in 0..=rounds {
            for (times, (_, fast)) in times.iter_mut().zip(&ways) {
                let start = Stopwatch::start(threads);
                draw_pixels(&case.list, fast, &case.canvas, &mut image);
                // The first round warms up.
                if round > 0 {
                    times.push(start.stop());
                }
            }
        }
        let columns: String = times.iter_mut().map(|times| format!("{:>10.2}", median(times))).collect();
        println!("{:<22}{columns}", case.name);
    }
}

fn main() {
    let argument = |number: usize| std::env::args().nth(number);
    let rounds: usize = argument(1).and_then(|text| text.parse().ok()).unwrap_or(5);
    let threads = argument(2).and_then(|text| text.parse().ok()).unwrap_or(1);
    let only = argument(3).unwrap_or_default();
    let with_zbuffer = argument(4).as_deref() != Some("fast");
    let ways = [Instructions::Best, Instructions::Avx2, Instructions::Baseline].map(|level| Fast::new(64, level));
    if argument(4).as_deref() == Some("each") {
        return each_trick(rounds, threads, &only);
    }
    println!("{threads} threads, medians of {rounds} interleaved rounds, raster milliseconds");
    println!(
        "{:<22} {:>9} {:>9} {:>9} {:>7} {:>9} {:>9}",
        "case", "polygons", "readable", "fast", "ratio", "fast avx2", "fast sse2"
    );
    for case in cases(threads, &only) {
        let mut image = Image::new(SIDE as usize, SIDE as usize, Rgb::gray(0.0));
        let mut times = [const { Vec::new() }; 4];
        let readable: &dyn Rasterizer = if case.wire { &PerPolygon(Wire) } else { &ZBuffer };
        let (reference, _) = draw(&case.list, Some(readable), &case.canvas);
        for _ in 0..rounds {
            if with_zbuffer {
                let start = Stopwatch::start(threads);
                let drawn = draw(&case.list, Some(readable), &case.canvas);
                times[0].push(start.stop());
                drop(drawn);
            }
            for (index, fast) in ways.iter().enumerate() {
                let fast: &dyn Rasterizer = if case.wire { &Wire } else { fast };
                for _ in 0..2 {
                    let start = Stopwatch::start(threads);
                    draw_pixels(&case.list, fast, &case.canvas, &mut image);
                    times[index + 1].push(start.stop());
                }
            }
        }
        let equal = if image == reference { "" } else { "  DIFFERENT" };
        if !with_zbuffer {
            times[0].push(f64::NAN);
        }
        let [readable, fast, avx2, sse2] = times.each_mut().map(|times| median(times));
        let ratio = readable / fast;
        println!(
            "{:<22} {:>9} {readable:>9.2} {fast:>9.2} {ratio:>7.1} {avx2:>9.2} {sse2:>9.2}{equal}",
            case.name,
            case.list.len()
        );
    }
}
