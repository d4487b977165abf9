//! Scenes of any size: a power of two changes no byte of a picture, and numbers at the ends of `f64` are drawn or counted.

mod support;

use farop::color::Rgb;
use farop::math::Vec3;
use farop::plan::{Choices, Culling, DepthFormat, Shading};
use farop::raster::{Rasterizer, Watkins, ZBuffer};
use farop::render::{Rendered, render, why};
use farop::scene::{Material, Scene, Shape};
use farop::screen::file::{Attributes, ReadOptions, Sheet, read, write_v2};
use farop::spd::Curves;
use support::built_in::built_in;
use support::digits;
use support::mixed::Mix;
use support::scenes::{camera, facets, scene, surface, world};

/// 2^k as an exact number; powers below 2^-1022 are subnormal.
fn power(k: i32) -> f64 {
    f64::from(k).exp2()
}

/// Everything that is a length, times 2^k.
fn scaled(scene: &Scene, k: i32) -> Scene {
    let mut scene = scene.clone();
    let factor = power(k);
    if let Some(camera) = &mut scene.camera {
        camera.from *= factor;
        camera.at *= factor;
        camera.hither *= factor;
        camera.yon = camera.yon.map(|yon| yon * factor);
    }
    for surface in &mut scene.surfaces {
        surface.mesh.vertices.iter_mut().for_each(|vertex| *vertex *= factor);
        for primitive in &mut surface.primitives {
            match &mut primitive.shape {
                Shape::Sphere { center, radius } => (*center, *radius) = (*center * factor, *radius * factor),
                Shape::Cone { base, base_radius, apex, apex_radius } => {
                    (*base, *apex) = (*base * factor, *apex * factor);
                    (*base_radius, *apex_radius) = (*base_radius * factor, *apex_radius * factor);
                }
                _ => panic!("no such shape here"),
            }
        }
    }
    for light in &mut scene.lights {
        let position = light.source.position() * factor;
        *light = farop::scene::Light {
            intensity: light.intensity,
            ..farop::scene::Light::point(position, light.color, light.place)
        };
    }
    scene
}

fn draw(scene: &Scene, choices: &Choices, rasterizer: &dyn Rasterizer) -> Rendered {
    render(scene, choices, Some(rasterizer)).unwrap_or_else(|error| panic!("{error}"))
}

const EXPONENTS: [i32; 11] = [-300, -200, -150, -128, -101, -1, 33, 126, 128, 200, 300];

#[test]
fn a_power_of_two_changes_no_byte_of_random_scenes() {
    for seed in 1..=24 {
        let corners = if seed % 2 == 0 { (3, 3) } else { (4, 7) };
        let mut original = Mix { seed, polygons: 40, transparent: seed % 3 == 0, corners, ..Mix::default() }.scene(48);
        if let Some(camera) = &mut original.camera {
            camera.yon = Some(1e3);
        }
        let choices = Choices {
            shading: [Shading::Gouraud, Shading::Phong, Shading::Flat][seed as usize % 3],
            depth: DepthFormat::ALL[seed as usize % 4],
            culling: Culling::None,
            triangles: seed % 5 == 0,
            subpixel_bits: if seed % 4 == 1 { farop::plan::EXACT_SUBPIXELS } else { 8 },
            ..Choices::default()
        };
        let expected = draw(&original, &choices, &ZBuffer);
        assert_eq!(expected.counts.skipped, 0);
        for k in EXPONENTS {
            let scene = scaled(&original, k);
            for rasterizer in [&ZBuffer as &dyn Rasterizer, &Watkins] {
                let drawn = draw(&scene, &choices, rasterizer);
                assert!(drawn.image == expected.image, "seed {seed}, 2^{k}, {choices:?}");
                // Which samples are shaded twice is the rasterizer's affair.
                let mut counts = drawn.counts;
                counts.work.specular_powers = expected.counts.work.specular_powers;
                assert_eq!(counts, expected.counts, "seed {seed}, 2^{k}");
            }
        }
    }
}

#[test]
fn a_power_of_two_changes_no_byte_of_spheres_and_cones() {
    // A cone below 1e-6 starts its circle elsewhere: the standard procedural databases' limit is absolute.
    for (name, exponents) in [("balls", &[-300, -128, 128, 300][..]), ("tree", &[128, 300])] {
        let original = built_in(name, 2, Curves::Kept);
        for shading in [Shading::Gouraud, Shading::Phong] {
            let choices = Choices { size: Some((64, 64)), shading, ..Choices::default() };
            let expected = draw(&original, &choices, &ZBuffer);
            for &k in exponents {
                let drawn = draw(&scaled(&original, k), &choices, &ZBuffer);
                assert_eq!(drawn.counts, expected.counts, "{name}, 2^{k}, {shading:?}");
                assert!(drawn.image == expected.image, "{name}, 2^{k}, {shading:?}");
            }
        }
    }
}

#[test]
fn a_screen_file_is_in_scene_units_and_comes_back_whole() {
    for shading in [Shading::Gouraud, Shading::Phong] {
        let original = Mix { seed: 3, corners: (4, 6), ..Mix::default() }.scene(32);
        let choices = Choices { shading, ..Choices::default() };
        for k in [-200, 0, 200] {
            let drawn = draw(&scaled(&original, k), &choices, &ZBuffer);
            let mut text = Vec::new();
            write_v2(&drawn.list, &Sheet::default(), Attributes::default(), &mut text)
                .expect("memory takes everything");
            let text = String::from_utf8(text).expect("text");
            assert_eq!(text.contains("eye_unit"), k != 0);
            let file = read(&text, &ReadOptions::default()).expect("reads what was written");
            assert!(file.list == drawn.list, "2^{k}");
            // 1/w of the first vertex, in scene units: that of the scene as it was, times 2^-k.
            let vertex = text.lines().find(|line| line.starts_with("vertex ")).expect("has vertices");
            let inverse_w: f64 = vertex.split(' ').nth(3).and_then(|word| word.parse().ok()).expect("a number");
            let scene_w = draw(&original, &choices, &ZBuffer).list.vertices[0].homogeneous.z;
            assert_eq!(inverse_w, 1.0 / scene_w / power(k));
            // And so is the depth that `farop why` prints.
            let shown =
                why::explain(&drawn.list, 16, 16).candidates.first().map(|c| drawn.list.depth_in_scene_units(c.depth));
            let plain = draw(&original, &choices, &ZBuffer).list;
            let expected = why::explain(&plain, 16, 16).candidates.first().map(|c| c.depth / power(k));
            assert_eq!(shown, expected);
        }
    }
}

/// Facets of the colors 1/16, 2/16, ... in an 8 x 8 picture, lit by nothing but ambient light.
fn gray_facets(hither: f64, outlines: &[&[Vec3]]) -> Scene {
    let surfaces = outlines.iter().zip(1..).map(|(outline, digit)| {
        let material =
            Material { color: Rgb::gray(f64::from(digit) / 16.0), ambient: Some(1.0), ..Material::default() };
        surface(material, facets(&[outline.iter().map(|&corner| world(corner)).collect()]))
    });
    let mut scene = scene(farop::scene::Camera { hither, ..camera(8, 8) }, surfaces.collect());
    scene.lights.clear();
    scene
}

fn linear(depth: DepthFormat) -> Choices {
    Choices {
        depth,
        encoding: farop::color::Encoding::Linear,
        culling: Culling::None,
        ambient: Some(1.0),
        ..Choices::default()
    }
}

/// A square across the view at distance `w`: it shows from -`half` to `half` of the way to the sides.
fn square(w: f64, half: f64) -> [Vec3; 4] {
    [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| Vec3::new(x * half, y * half, 1.0) * w)
}

/// What is drawn of `outlines`, as digits, and how many were skipped.
fn picture(hither: f64, outlines: &[&[Vec3]], depth: DepthFormat) -> (String, u64) {
    let drawn = draw(&gray_facets(hither, outlines), &linear(depth), &ZBuffer);
    assert!(drawn.image.pixels().iter().all(|color| color.to_array().iter().all(|channel| channel.is_finite())));
    (digits(&drawn.image).lines().nth(4).unwrap_or_default().to_string(), drawn.counts.skipped)
}

#[test]
fn near_1e_minus_30_and_far_1e30_keep_their_order() {
    // Extreme 28. Nearer ones come later in the list and are smaller, so that all are seen.
    let squares = [(1e30, 1.0), (1e15, 0.75), (1.0, 0.5), (1e-29, 0.25)].map(|(w, half)| square(w, half));
    let outlines: Vec<&[Vec3]> = squares.iter().map(|square| &square[..]).collect();
    for depth in [DepthFormat::F32, DepthFormat::F64] {
        assert_eq!(picture(1e-30, &outlines, depth), ("1 2 3 4 4 3 2 1".to_string(), 0));
        let reversed: Vec<&[Vec3]> = outlines.iter().rev().copied().collect();
        assert_eq!(picture(1e-30, &reversed, depth).0, "4 3 2 1 1 2 3 4");
    }
}

#[test]
fn coordinates_at_the_ends_of_f64_are_drawn() {
    // Extremes 39, 40, 41 and the first half of 44, with hither a hundredth of the distance.
    let f32_max = f64::from(f32::MAX) / 16.0;
    for w in [1e30, 1e-30, 1e100, 1e-110, 1e150, 1e-160, 1e300, 1e-300, 1e-308, 1e-315, f32_max] {
        let (far, near) = (square(w, 1.0), square(w / 2.0, 0.5));
        for depth in [DepthFormat::F32, DepthFormat::F64] {
            assert_eq!(picture(w / 100.0, &[&far, &near], depth), ("1 1 2 2 2 2 1 1".to_string(), 0), "{w} {depth:?}");
            assert_eq!(picture(w / 100.0, &[&near, &far], depth), ("2 2 1 1 1 1 2 2".to_string(), 0), "{w} {depth:?}");
        }
    }
    // The same before a hither of 1, as far as 1/w has room in single precision.
    for w in [1e30, f32_max, 1e100, 1e150, 1e300] {
        let expected = ("1 1 2 2 2 2 1 1".to_string(), 0);
        assert_eq!(picture(1.0, &[&square(w, 1.0), &square(w / 2.0, 0.5)], DepthFormat::F64), expected, "{w}");
    }
}

#[test]
fn a_polygon_of_large_and_small_coordinates_is_exact() {
    // Extreme 42: a floor from 1e-30 below the eye to the horizon at 1e30. It fills the lower half.
    let floor = [(-1e30, 1e-3), (1e30, 1e-3), (1e30, 1e30), (-1e30, 1e30)].map(|(x, w)| Vec3::new(x, -1e-30, w));
    for depth in [DepthFormat::F32, DepthFormat::F64] {
        let drawn = draw(&gray_facets(1e-31, &[&floor]), &linear(depth), &ZBuffer);
        let seen = drawn.image.pixels().iter().filter(|color| color.r > 0.0).count() as u64;
        // The whole floor lies within 1e-27 of the horizon: no center sees it, and it was not dropped for its numbers.
        assert_eq!((seen, drawn.counts.skipped), (0, 0));
    }
    let wide = [(-1e30, 1e-30), (1e30, 1e-30), (1e30, 1e30), (-1e30, 1e30)].map(|(x, w)| Vec3::new(x, -1e-30, w));
    let drawn = draw(&gray_facets(1e-31, &[&wide]), &linear(DepthFormat::F64), &ZBuffer);
    let rows: Vec<bool> = (0..8).map(|y| drawn.image.row(y).iter().all(|color| color.r > 0.0)).collect();
    assert_eq!(rows, [false, false, false, false, true, true, true, true]);
}

#[test]
fn the_largest_number_is_skipped_and_counted() {
    // Extreme 44.
    let huge = [Vec3::new(0.0, 0.0, 2.0), Vec3::new(f64::MAX, 0.0, 2.0), Vec3::new(0.0, f64::MAX, 2.0)];
    let near = square(2.0, 0.5);
    let (row, skipped) = picture(1.0, &[&huge, &near], DepthFormat::F32);
    assert_eq!((row.as_str(), skipped), (". . 2 2 2 2 . .", 1));
}
