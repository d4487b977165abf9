//! A line for every draw list of many scenes and choices, with a hash of all its bits and of the counts: `cargo run --example list_hashes`.
//!
//! For whoever changes the geometry stage and means to change no bit: keep the output from before, compare with `diff`.
//! Every built-in scene, small, and random polygons that reach over all planes; shadings, culling, needs, historic rules.

#![allow(dead_code, reason = "the tests use more of these files")]

#[path = "../tests/support/built_in.rs"]
mod built_in;
#[path = "../tests/support/mixed.rs"]
mod mixed;
#[path = "../tests/support/random.rs"]
mod random;
#[path = "../tests/support/scenes.rs"]
mod scenes;

use farop::geometry::{Stage, Trace, run_traced};
use farop::math::Vec3;
use farop::plan::{
    Accepts, Choices, ClipLight, Culling, DepthFormat, EXACT_SUBPIXELS, FlatRule, Interpolation, NeedsMode, Plan,
    Shading,
};
use farop::scene::{NormalSource, Scene};
use farop::screen::DrawList;
use farop::spd::{Curves, SMALL};
use mixed::Mix;

/// FNV-1a, 64 bits, over words.
struct Hash(u64);

impl Hash {
    fn word(&mut self, word: u64) {
        self.0 = (self.0 ^ word).wrapping_mul(0x0000_0100_0000_01B3).rotate_left(23);
    }

    fn number(&mut self, number: f64) {
        self.word(number.to_bits());
    }

    fn point(&mut self, point: Vec3) {
        point.to_array().into_iter().for_each(|number| self.number(number));
    }

    fn text(&mut self, text: &str) {
        text.bytes().for_each(|byte| self.word(u64::from(byte)));
    }
}

fn hash_of(list: &DrawList) -> u64 {
    let mut hash = Hash(0xCBF2_9CE4_8422_2325);
    hash.text(&format!("{:?}{:?}{:?}{:?}", list.width, list.height, list.grid, list.varying));
    hash.text(&format!("{:?}{:?}{:?}", list.shader.lights, list.shader.surfaces, list.shader.powers()));
    for vertex in &list.vertices {
        hash.point(Vec3::new(vertex.x, vertex.y, 0.0));
        hash.point(vertex.homogeneous);
        hash.word(vertex.edge as u64);
    }
    list.values.iter().for_each(|&value| hash.number(value));
    for plane in &list.planes {
        [plane.a, plane.b, plane.c, plane.low, plane.high].into_iter().for_each(|number| hash.number(number));
        hash.word(plane.evaluation as u64);
    }
    for record in &list.polygons {
        [record.first_vertex, record.vertex_count, record.first_plane, record.surface]
            .into_iter()
            .for_each(|number| hash.word(u64::from(number)));
        hash.text(&format!("{:?}", record.source));
    }
    hash.0
}

fn hash_of_trace(trace: &Trace) -> u64 {
    let mut hash = Hash(0xCBF2_9CE4_8422_2325);
    trace.eye.iter().for_each(|polygon| hash.text(&format!("{polygon:?}")));
    trace.clipped.iter().for_each(|polygon| hash.text(&format!("{polygon:?}")));
    hash.0
}

fn variants() -> Vec<(&'static str, Choices)> {
    let base = || Choices { size: Some((96, 80)), ..Choices::default() };
    let mut all = vec![
        ("triangles", Choices { triangles: true, ..base() }),
        ("f64", Choices { depth: DepthFormat::F64, ..base() }),
        ("int24", Choices { depth: DepthFormat::Int24, ..base() }),
        ("relight", Choices { clip_light: ClipLight::Relight, ..base() }),
        ("screen", Choices { interpolation: Interpolation::Screen, ..base() }),
        ("screen-phong", Choices { interpolation: Interpolation::Screen, shading: Shading::Phong, ..base() }),
        ("scanline", Choices { interpolation: Interpolation::ScanLine, ..base() }),
        ("scanline-phong", Choices { interpolation: Interpolation::ScanLine, shading: Shading::Phong, ..base() }),
        ("sipp-flat", Choices { flat: FlatRule::Sipp, shading: Shading::Flat, ..base() }),
        ("exact", Choices { subpixel_bits: EXACT_SUBPIXELS, ..base() }),
        ("exact-wire", Choices { subpixel_bits: EXACT_SUBPIXELS, shading: Shading::Wire, ..base() }),
        ("bits4", Choices { subpixel_bits: 4, samples: 3, ..base() }),
        ("phong-triangles", Choices { shading: Shading::Phong, triangles: true, ..base() }),
    ];
    for &shading in Shading::ALL {
        for &culling in Culling::ALL {
            for needs in [NeedsMode::Derived, NeedsMode::Full] {
                all.push((shading.name(), Choices { shading, culling, needs, ..base() }));
            }
        }
    }
    all
}

/// Random polygons: hardly cut, cut a lot, mirrored, far away, with mean normals and shared vertices.
fn random_scenes() -> Vec<(String, Scene)> {
    let mut all = Vec::new();
    for seed in 0..3 {
        let mix = Mix { seed, corners: (3, 6), polygons: 120, transparent: true, ..Mix::default() };
        all.push((format!("inside {seed}"), mix.scene(96)));
        let cut = Mix { distance: (0.5, 9.0), spread: 1.0, ..mix };
        all.push((format!("cut {seed}"), cut.scene(96)));
        let behind = Mix { distance: (-4.0, 9.0), spread: 3.0, ..mix };
        all.push((format!("behind {seed}"), behind.scene(96)));
        let mut averaged = cut.scene(96);
        for (number, polygon) in averaged.surfaces.iter_mut().flat_map(|s| &mut s.mesh.polygons).enumerate() {
            polygon.normals = [NormalSource::Averaged, NormalSource::Given, NormalSource::Facet][number % 3];
        }
        averaged.objects[0].parent_from_local.matrix3.x_axis *= -1.0;
        averaged.camera.iter_mut().for_each(|camera| camera.yon = Some(6.0));
        all.push((format!("averaged, mirrored {seed}"), averaged));
        let mut tiny = cut.scene(96);
        tiny.surfaces.iter_mut().flat_map(|s| &mut s.mesh.vertices).for_each(|v| *v *= 1e-200);
        tiny.camera.iter_mut().for_each(|camera| camera.hither = 1e-200);
        all.push((format!("tiny {seed}"), tiny));
        for mut wide in [false, true].map(|quads| {
            let mut random = random::Random::new(seed);
            let material = farop::scene::Material { specular: 0.5, shine: 7.0, ..farop::scene::Material::default() };
            let mesh = scenes::wide_mesh(&mut random, 20, (0.3, -0.2), quads);
            scenes::scene(scenes::camera(96, 80), vec![scenes::surface(material, mesh)])
        }) {
            if seed == 1 {
                wide.surfaces[0].mesh.polygons.iter_mut().for_each(|polygon| polygon.normals = NormalSource::Averaged);
            }
            all.push((format!("wide {seed}"), wide));
        }
    }
    all
}

fn main() {
    let mut triangles = 0;
    let mut all = random_scenes();
    for (name, size) in SMALL {
        all.push((name.to_string(), built_in::built_in(name, size, Curves::Kept)));
        all.push((format!("{name} in patches"), built_in::built_in(name, size, Curves::Patches(2))));
    }
    for (name, scene) in &all {
        for (number, (variant, choices)) in variants().iter().enumerate() {
            let accepts = if number % 5 == 4 { Accepts::Triangles } else { Accepts::AnyPolygon };
            let Ok(plan) = Plan::new(scene, choices, accepts) else {
                println!("{name}, {number} {variant}: refused");
                continue;
            };
            let (mut list, mut trace) = (DrawList::new(0, 0), Trace::default());
            let counts = run_traced(scene, &plan, &mut list, &mut trace);
            let mut untraced = DrawList::new(0, 0);
            let again = farop::geometry::run(scene, &plan, &mut untraced);
            assert!(counts == again && hash_of(&list) == hash_of(&untraced), "tracing changes nothing");
            let mut shared = DrawList::new(0, 0);
            let shared_counts = Stage::sharing(true).run(scene, &plan, &mut shared);
            triangles += shared.shared.len();
            assert!(counts == shared_counts && hash_of(&list) == hash_of(shared.whole()), "sharing changes nothing");
            let (bits, traced) = (hash_of(&list), hash_of_trace(&trace));
            println!("{name}, {number} {variant}: {} {bits:016x} {traced:016x} {counts:?}", list.len());
        }
    }
    eprintln!("{triangles} triangles were shared");
}
