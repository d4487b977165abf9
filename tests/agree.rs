//! Rasterizers that must draw the z-buffer's bytes: Watkins on built-in scenes and on random ones.

mod support;

use farop::plan::{Choices, Culling, DepthFormat, NeedsMode, Shading};
use farop::raster::{Rasterizer, Watkins, ZBuffer};
use farop::render::render;
use farop::scene::Scene;
use farop::spd::Curves;
use support::built_in::{SMALL, built_in};
use support::mixed::Mix;

/// Draws with both, compares, and returns what Watkins counted.
fn compare(name: &str, scene: &Scene, choices: &Choices) -> std::collections::BTreeMap<&'static str, u64> {
    let draw = |rasterizer: &dyn Rasterizer| {
        render(scene, choices, Some(rasterizer)).unwrap_or_else(|error| panic!("{error}"))
    };
    let (expected, actual) = (draw(&ZBuffer), draw(&Watkins));
    assert!(expected.image == actual.image, "{name}, {choices:?}");
    actual.puts.own
}

#[test]
fn watkins_draws_built_in_scenes_like_the_z_buffer() {
    for (name, size) in SMALL {
        let scene = built_in(name, size, Curves::Kept);
        for shading in [Shading::Flat, Shading::Gouraud, Shading::Phong] {
            for culling in [Culling::Back, Culling::None] {
                let choices = Choices { size: Some((120, 90)), shading, culling, ..Choices::default() };
                compare(name, &scene, &choices);
            }
        }
    }
}

#[test]
fn watkins_draws_random_scenes_like_the_z_buffer() {
    let (mut spans, mut halvings) = (0, 0);
    for seed in 1..=300 {
        let mix = Mix {
            seed,
            polygons: 5 + (seed as usize * 7) % 40,
            transparent: seed % 3 == 0,
            corners: (3, 6),
            ..Mix::default()
        };
        let depth = DepthFormat::ALL[seed as usize % 4];
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
        let shading = [Shading::Flat, Shading::Gouraud, Shading::Phong][seed as usize % 3];
        let subpixel_bits = [8, 0, 16][seed as usize % 3];
        let choices = Choices {
            shading,
            depth,
            subpixel_bits,
            culling: Culling::None,
            needs: NeedsMode::Full,
            ..Choices::default()
        };
        let counted = compare(&format!("seed {seed}"), &scene, &choices);
        spans += counted["spans"];
        halvings += counted["halvings"];
    }
    // The scenes are hard: polygons do pierce each other.
    assert!(halvings > 1000, "{halvings} halvings of {spans} spans");
}

#[test]
fn nearly_all_spans_of_gears_are_decided_by_their_ends() {
    let gears = built_in("gears", 4, Curves::Kept);
    let choices = Choices { size: Some((256, 256)), ..Choices::default() };
    let counted = compare("gears", &gears, &choices);
    let share = counted["spans decided by their ends"] as f64 / counted["spans"] as f64;
    assert!(share > 0.9, "{share}");
}
