//! The fast rasterizer draws the z-buffer's bytes, whatever the tiles, threads and instructions. `farop check fast` does the same with many more
//! scenes.

mod support;

use farop::color::Rgb;
use farop::lab::check::random_scenes::{choices, hard};
use farop::math::Vec3;
use farop::plan::{Choices, Culling, DepthFormat, Interpolation, Shading};
use farop::raster::fast::{Fast, Instructions};
use farop::raster::{Frame, Rasterizer, ZBuffer};
use farop::render::{Canvas, Rendered, draw, render};
use farop::scene::{Material, Mesh, NormalSource, Scene};
use farop::spd::Curves;
use farop::spd::SMALL;
use support::built_in::built_in;
use support::census::{Census, census};
use support::mixed::Mix;
use support::scenes::{camera, scene, surface, world};

fn drawn(scene: &Scene, choices: &Choices, rasterizer: &dyn Rasterizer) -> Rendered {
    render(scene, choices, Some(rasterizer)).unwrap_or_else(|error| panic!("{error}"))
}

/// Draws with both and compares the bits of the light; returns what was counted.
fn compare(name: &str, scene: &Scene, choices: &Choices, fast: &Fast) -> Rendered {
    let (expected, actual) = (drawn(scene, choices, &ZBuffer), drawn(scene, choices, fast));
    let [expected, drawn] = [&expected, &actual].map(|rendered| {
        let bits = |light: &farop::color::Rgb<f32>| light.to_array().map(f32::to_bits);
        rendered.image.pixels().iter().map(bits).collect::<Vec<_>>()
    });
    assert!(expected == drawn, "{name}, {choices:?}, {fast:?}");
    actual
}

/// Tile side, threads and instructions that belong to a number; all combinations come up.
fn ways(number: u64) -> (Fast, Option<u32>) {
    let tile = [64, 8, 16, 24, 256, 40, 128][number as usize % 7];
    let threads = [1, 2, 3, 8, 1][number as usize % 5];
    (Fast::new(tile, Instructions::ALL[number as usize % 4]), Some(threads))
}

#[test]
fn built_in_scenes() {
    let mut number = 0;
    for (name, size) in SMALL {
        let scene = built_in(name, size, Curves::Kept);
        for shading in [Shading::Flat, Shading::Gouraud, Shading::Phong] {
            for (culling, samples) in [(Culling::Back, 1), (Culling::None, 1 + number as u32 % 4)] {
                let (fast, threads) = ways(number);
                number += 1;
                let choices =
                    Choices { size: Some((120, 90)), shading, culling, samples, threads, ..Choices::default() };
                compare(name, &scene, &choices, &fast);
            }
        }
    }
}

#[test]
fn random_scenes() {
    let (mut total, mut edges, mut spans, mut samples) = (Census::default(), 0, 0, 0);
    for seed in 1..=400 {
        let mix = Mix {
            seed,
            polygons: 5 + (seed as usize * 7) % 40,
            transparent: seed % 3 == 0,
            corners: if seed % 2 == 0 { (3, 6) } else { (3, 4) },
            ..Mix::default()
        };
        let depth = DepthFormat::ALL[if seed % 4 == 0 { seed as usize / 4 % 4 } else { 0 }];
        let mut scene = mix.scene(64);
        if seed % 2 == 0 {
            // The same polygons once more in another color: exact ties at every sample.
            let mut again = mix.scene(64);
            again
                .surfaces
                .iter_mut()
                .for_each(|surface| surface.material.color = farop::color::Rgb::new(0.1, 0.9, 0.2));
            scene.merge(again);
        }
        if let Some(camera) = &mut scene.camera {
            camera.yon = Some(1e3);
        }
        let (fast, threads) = ways(seed);
        let choices = Choices {
            shading: [Shading::Flat, Shading::Gouraud, Shading::Phong][seed as usize % 3],
            subpixel_bits: [8, 8, 0, 8, 4, 16][seed as usize % 6],
            samples: 1 + seed as u32 / 5 % 4,
            depth,
            threads,
            ..Choices::default()
        };
        let rendered = compare(&format!("seed {seed}"), &scene, &choices, &fast);
        total += census(&rendered.list);
        edges += rendered.puts.own["polygons in tiles, by edges"];
        spans += rendered.puts.own["polygons in tiles, by spans"];
        samples += rendered.puts.own["polygons in tiles, sample by sample"];
    }
    assert!(edges > 2000 && spans > 2000 && samples > 2000, "{edges} {spans} {samples}");
    assert!(total.exact_ties > 1000 && total.transparent_samples > 1000, "{total:?}");
}

#[test]
fn scenes_made_to_be_hard() {
    for seed in 1..=300 {
        let (scene, choices) = (hard(seed), choices(seed));
        let (fast, threads) = ways(seed);
        compare(&format!("seed {seed}"), &scene, &Choices { threads, ..choices }, &fast);
    }
}

#[test]
fn nothing_snapped_and_values_along_scan_lines() {
    for seed in 1..=20 {
        let scene = Mix { seed, polygons: 12, ..Mix::default() }.scene(64);
        let (fast, threads) = ways(seed);
        let bits = farop::plan::EXACT_SUBPIXELS;
        compare("unsnapped", &scene, &Choices { subpixel_bits: bits, threads, ..Choices::default() }, &fast);
        let interpolation = [Interpolation::ScanLine, Interpolation::Screen][seed as usize % 2];
        compare("interpolation", &scene, &Choices { interpolation, threads, ..Choices::default() }, &fast);
    }
}

#[test]
fn owners_and_depths_in_a_target() {
    let scene = Mix { seed: 3, polygons: 60, transparent: true, ..Mix::default() }.scene(64);
    let list = drawn(&scene, &Choices::default(), &ZBuffer).list;
    // A band that starts and ends within tiles.
    let rows = 5..59;
    let samples = |rasterizer: &dyn Rasterizer, threads| {
        let mut frame = Frame::default();
        let choices = Choices::default();
        let background = farop::color::Rgb::gray(0.25);
        let size = (list.width, list.height);
        let mut target = frame.target(size, rows.clone(), background, choices.transparency).with_threads(threads);
        rasterizer.draw(&list, &mut target);
        target.finish();
        (0..list.width as usize * rows.len()).map(|index| frame.sample(index)).collect::<Vec<_>>()
    };
    let expected = samples(&ZBuffer, 1);
    for (tile, threads) in [(64, 1), (8, 3), (24, 2), (256, 9)] {
        assert!(samples(&Fast::new(tile, Instructions::Best), threads) == expected, "{tile} {threads}");
    }
}

#[test]
fn lines_and_too_many_samples_are_handed_over() {
    let scene = Mix { seed: 5, polygons: 9, ..Mix::default() }.scene(40);
    let wire = Choices { shading: Shading::Wire, ..Choices::default() };
    assert!(compare("wire", &scene, &wire, &Fast::default()).puts.own.contains_key("lists_handed_to_zbuffer"));
    // No tile up to 256 samples holds whole pixels of 33 x 33: the target averages.
    let many = Choices { samples: 33, threads: Some(2), ..Choices::default() };
    compare("33 x 33", &scene, &many, &Fast::default());
}

#[test]
fn memory_of_other_pictures_leaves_no_trace() {
    let fast = Fast::default();
    for (seed, side) in [(1, 90), (2, 30), (3, 130), (4, 8)] {
        for depth in [DepthFormat::F32, DepthFormat::F64] {
            let scene = Mix { seed, polygons: 30, transparent: seed == 3, ..Mix::default() }.scene(side);
            compare("reused", &scene, &Choices { depth, threads: Some(2), ..Choices::default() }, &fast);
        }
    }
}

/// Steps of eight samples in which one polygon has the same color all over and its neighbor has not.
#[test]
fn even_and_varying_side_by_side() {
    let (mut even, mut varying) = (Mesh::default(), Mesh::default());
    for strip in 0..24_u32 {
        let left = f64::from(strip) / 12.0 - 1.0;
        let mesh = if strip % 2 == 0 { &mut even } else { &mut varying };
        let corners = [(left, -1.0), (left + 1.0 / 12.0, -1.0), (left + 1.0 / 12.0, 1.0), (left, 1.0)];
        let corners = corners.map(|(x, y)| {
            let w = 2.0 + 0.5 * x + 0.25 * y;
            mesh.push_vertex(world(Vec3::new(x * w, y * w, w)))
        });
        mesh.push_polygon(&corners[..3], NormalSource::Facet, strip);
        mesh.push_polygon(&[corners[0], corners[2], corners[3]], NormalSource::Facet, strip);
    }
    let glowing = Material { ambient: Some(1.0), diffuse: 0.0, color: Rgb::new(0.3, 0.6, 0.9), ..Material::default() };
    let surfaces = vec![surface(glowing, even), surface(Material::default(), varying)];
    let scene = scene(camera(64, 64), surfaces);
    for number in 0..8 {
        let (fast, threads) = ways(number);
        let samples = 1 + number as u32 % 2;
        compare("strips", &scene, &Choices { samples, threads, ..Choices::default() }, &fast);
    }
}

#[test]
fn an_empty_list_shows_the_background() {
    let list = farop::screen::DrawList::new(70, 3);
    let background = farop::color::Rgb::gray(0.5);
    let transparency = Choices::default().transparency;
    let canvas = Canvas { samples: 1, background, transparency, threads: 4 };
    let (image, _) = draw(&list, Some(&Fast::default()), &canvas);
    assert!(image.pixels().len() == 210 && image.pixels().iter().all(|&light| light == background));
}

/// What lanes light must not depend on which surfaces share a step: many small ones side by side, every reflection model and light.
#[test]
fn every_reflection_and_light_in_lanes() {
    use farop::math::Vec3;
    use farop::scene::{Light, LightSource, Place, Reflection, SpotEdge};
    for seed in 1..=12 {
        let mut scene = Mix { seed, polygons: 80, transparent: seed % 2 == 0, ..Mix::default() }.scene(72);
        for (number, surface) in scene.surfaces.iter_mut().enumerate() {
            let material = &mut surface.material;
            material.reflection =
                [Reflection::Nff, Reflection::Phong, Reflection::Basic { c3: 0.3 }][(number + seed as usize) % 3];
            material.specular = 0.5;
            material.shine = [0.0, 3.7, 1e5, 20.0][(number / 3 + seed as usize) % 4];
        }
        let point = Light::point(Vec3::new(-3.0, 4.0, 2.0), farop::color::Rgb::WHITE, Place::default());
        let spot = |edge| LightSource::Spot {
            position: Vec3::new(1.0, 2.0, 3.0),
            at: Vec3::new(0.0, 0.0, -4.0),
            opening: 40.0,
            edge,
        };
        for source in [
            LightSource::Directional { to_light: Vec3::new(1.0, 1.0, 2.0) },
            spot(SpotEdge::Sharp),
            spot(SpotEdge::Soft),
        ] {
            scene.lights.push(Light { source, ..point });
        }
        scene.lights.push(point);
        for number in 0..4 {
            let (fast, threads) = ways(seed * 4 + number);
            let choices =
                Choices { shading: Shading::Phong, threads, samples: 1 + seed as u32 % 2, ..Choices::default() };
            let rendered = compare("lights", &scene, &choices, &fast);
            let alone = drawn(&scene, &choices, &ZBuffer);
            assert!(rendered.list.shader.powers() > 0 && alone.list.shader.powers() > 0);
        }
    }
}

#[test]
fn instructions_have_names() {
    let names = Instructions::ALL.map(|instructions| (instructions.name(), instructions.here()));
    println!("{names:?}");
    assert_eq!(names.each_ref().map(|(name, _)| *name), ["plain", "sse2", "avx2", "best"]);
    assert_eq!(names[0].1, "fallback");
}
