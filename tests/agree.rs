//! Rasterizers that must draw the z-buffer's bytes: Watkins on built-in scenes, on random ones, and on ones made to be hard.
//! `examples/watkins_agree.rs` does the same with 10,000 scenes.

mod support;

use farop::lab::check::random_scenes::{choices, hard};
use farop::plan::{Choices, Culling, DepthFormat, NeedsMode, Shading};
use farop::raster::{Rasterizer, Watkins, ZBuffer};
use farop::render::render;
use farop::scene::Scene;
use farop::spd::{Curves, SMALL};
use support::built_in::built_in;
use support::census::{Census, census};
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
fn watkins_draws_hard_scenes_like_the_z_buffer() {
    let (mut total, mut cut) = (Census::default(), 0);
    for seed in 1..=300 {
        let (scene, choices) = (hard(seed), choices(seed));
        compare(&format!("seed {seed}"), &scene, &choices);
        let rendered = render(&scene, &choices, None).expect("a usable view");
        cut += rendered.counts.cut + rendered.counts.clipped;
        total += census(&rendered.list);
    }
    // Every kind of difficulty is there, counted from the lists and not by Watkins.
    assert!(total.concave > 300 && total.touching_pairs > 300 && cut > 100, "{total:?}, {cut} cut");
    assert!(total.crowded_samples > 30_000 && total.transparent_samples > 10_000, "{total:?}");
    assert!(total.piercing_pairs > 100 && total.exact_ties > 1000, "{total:?}");
}

#[test]
fn nearly_all_spans_of_gears_are_decided_as_a_whole() {
    let gears = built_in("gears", 2, Curves::Kept);
    let choices = Choices { size: Some((1024, 1024)), ..Choices::default() };
    let counted = compare("gears", &gears, &choices);
    let pixel_work = counted["spans halved"] + counted["spans of one sample, compared"];
    let share = 1.0 - pixel_work as f64 / counted["spans"] as f64;
    assert!(share >= 0.9, "{share}");
    // And they are spans: of several samples, and of several segments.
    assert!(counted["spans"] * 3 < 1024 * 1024 && counted["spans decided by their ends"] > counted["spans"] / 20);
}

#[test]
fn threads_change_neither_the_picture_nor_what_is_counted() {
    let gears = built_in("gears", 2, Curves::Kept);
    let picture = |threads| {
        let choices = Choices { size: Some((90, 110)), threads: Some(threads), ..Choices::default() };
        let rendered = render(&gears, &choices, Some(&Watkins)).expect("a usable view");
        (rendered.image, rendered.puts)
    };
    let alone = picture(1);
    assert!(alone.1.most["longest active edge list"] > 10);
    for threads in [2, 3, 50] {
        assert!(picture(threads) == alone, "{threads} threads: {:?}, alone {:?}", picture(threads).1, alone.1);
    }
}

#[test]
fn a_piercing_is_found_by_halving_and_shown_in_its_spans() {
    // Two ramps that cross in the middle of 64 samples.
    let mut list = farop::screen::DrawList::new(64, 1);
    for color in [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]] {
        list.push_flat(&[(0.0, 0.0), (64.0, 0.0), (64.0, 1.0), (0.0, 1.0)], 0.5, color);
    }
    for (polygon, a) in [(0, -0.001), (1, 0.001)] {
        let plane = &mut list.planes[polygon * 4];
        let range = (0.4, 0.6);
        *plane = farop::screen::Plane::new([a, 0.0, 0.5 - 30.25 * a], range, range, list.precision);
    }
    let spans = farop::raster::watkins::spans(&list, 0);
    let shown =
        |polygon| spans.iter().filter(|span| span.polygon == polygon).map(|span| span.columns.len()).sum::<usize>();
    // Depths are equal at x = 30.25: the center of sample 29 lies left of it, that of sample 30 right of it.
    assert_eq!([shown(0), shown(1)], [30, 34]);
    assert!(spans.len() <= 7, "a binary search, not a walk: {spans:?}");
    let ends: Vec<_> = spans.iter().map(|span| span.columns.end).collect();
    assert!(spans.iter().skip(1).map(|span| span.columns.start).eq(ends[..ends.len() - 1].iter().copied()), "no gap");
}
