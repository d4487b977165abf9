//! A scene written as NFF and read back draws the same bytes, as far as comments for farop reach; what is lost is said.

#[path = "support/command.rs"]
mod command;
mod support;

use command::{Desk, project_scene};
use farop::geometry::flatten;
use farop::image::Image;
use farop::parse::{ParseOptions, read_nff};
use farop::plan::{Accepts, Choices, Culling, NeedsMode, Plan, Shading};
use farop::raster::ZBuffer;
use farop::render::render;
use farop::scene::{Material, Reflection, Scene};
use farop::write::write_nff;
use support::random::Random;
use support::sipp_like::{self, Kinds};

fn written(scene: &Scene) -> (String, Vec<String>) {
    let mut bytes = Vec::new();
    let notices = write_nff(scene, &mut bytes).expect("memory takes everything");
    (String::from_utf8(bytes).expect("ASCII"), notices)
}

/// As `farop convert` does it.
fn converted(scene: &Scene) -> (Scene, Vec<String>) {
    let plan = Plan::new(scene, &Choices::default(), Accepts::AnyPolygon).expect("has a view");
    let (text, notices) = written(&flatten(scene, &plan, false));
    (read_nff("scene.nff", text.as_bytes(), ParseOptions::default()).expect("what farop writes").scene, notices)
}

fn picture(scene: &Scene, choices: &Choices) -> Image {
    render(scene, choices, Some(&ZBuffer)).expect("has a view").image
}

#[test]
fn a_sipp_scene_of_phong_and_points_comes_back_to_the_byte() {
    for seed in 0..6 {
        let scene = sipp_like::scene(&mut Random::new(1996 + seed), Kinds::PhongAndPoints);
        let (back, _) = converted(&scene);
        for shading in [Shading::Flat, Shading::Gouraud, Shading::Phong] {
            for culling in [Culling::Back, Culling::Nff, Culling::None] {
                let choices = Choices { shading, culling, ..Choices::default() };
                let (before, after) = (picture(&scene, &choices), picture(&back, &choices));
                assert!(before == after, "seed {seed}, {} {}", shading.name(), culling.name());
            }
        }
    }
}

#[test]
fn what_the_comments_say_is_seen() {
    let mut scene = sipp_like::scene(&mut Random::new(7), Kinds::PhongAndPoints);
    // Bright enough that `phong` cuts sums which NFF's model does not.
    scene.lights.iter_mut().for_each(|light| light.color = light.color * 4.0);
    let plan = Plan::new(&scene, &Choices::default(), Accepts::AnyPolygon).expect("has a view");
    let (text, _) = written(&flatten(&scene, &plan, false));
    let whole = picture(&scene, &Choices::default());
    for word in ["light intensity", " phong", " ambient", " opacity", " two_sided"] {
        // Other readers see no comment at all; here, one word of them is taken away.
        let without = |line: &str| {
            let Some(at) = line.find(word).filter(|_| line.starts_with("#farop")) else { return line.to_string() };
            if word == "light intensity" {
                return "# nothing".to_string();
            }
            let numbers = [(" ambient", 1), (" opacity", 3)].iter().find(|(name, _)| *name == word).map_or(0, |n| n.1);
            let rest: Vec<&str> = line[at + word.len()..].split_whitespace().skip(numbers).collect();
            let left = format!("{} {}", &line[..at], rest.join(" "));
            if left.trim() == "#farop surface" { "# nothing".to_string() } else { left }
        };
        let less: String = text.lines().map(|line| without(line) + "\n").collect();
        let read = read_nff("", less.as_bytes(), ParseOptions::default()).unwrap_or_else(|errors| panic!("{errors}"));
        assert!(picture(&read.scene, &Choices::default()) != whole, "nobody misses `{word}`");
    }
}

#[test]
fn the_commands_convert_and_render_give_the_same_bytes() {
    let folder = Desk::new();
    let scene = sipp_like::scene(&mut Random::new(3), Kinds::PhongAndPoints);
    folder.write("scene.nff", written(&scene).0);
    let direct = folder.made("render scene.nff -s phong", "direct.png");
    let outcome = folder.done("convert scene.nff -o again.nff");
    assert!(outcome.stderr.contains("for readers other than farop"), "{}", outcome.stderr);
    assert_eq!(direct, folder.made("render again.nff -s phong", "again.png"));
    assert_eq!(folder.read("scene.nff"), folder.read("again.nff"), "the file of the file is the file");
}

#[test]
fn commands_say_what_nff_could_not() {
    let desk = Desk::new();
    desk.write("scene.nff", written(&sipp_like::scene(&mut Random::new(3), Kinds::PhongAndPoints)).0);
    let stage = desk.done("render scene.nff --dump-stage scene");
    for words in [", intensity 0.3\n", " shapes, phong, two-sided\n"] {
        assert!(stage.text().contains(words), "{words}: {}", stage.text());
    }
    let stats = desk.done("render scene.nff --stats -o scene.png");
    let said = stats.text().to_string() + &stats.stderr;
    assert!(said.contains(", intensity 0.3\n") && said.contains("), phong, two-sided\n"), "{said}");
    let plan = desk.done("plan scene.nff");
    assert!(plan.text().contains("each of 1 lights 0.500, 3 lights with their own, "), "{}", plan.text());
    assert!(plan.text().contains("are two-sided and keep their back faces"), "{}", plan.text());
}

#[test]
fn a_plain_scene_is_written_without_comments() {
    for name in ["highlight.nff", "glass.nff", "smooth_normals.nff"] {
        let folder = Desk::new();
        folder.done(&format!("convert {} -o plain.nff", project_scene(name)));
        let text = String::from_utf8(folder.read("plain.nff")).expect("ASCII");
        assert!(!text.contains('#'), "{name}: {text}");
    }
}

#[test]
fn what_nff_cannot_say_is_said_once() {
    let scene = sipp_like::scene(&mut Random::new(5), Kinds::All);
    let (back, notices) = converted(&scene);
    for part in
        ["directional lights, written as point lights far away", "spots without their cone", "surfaces of `basic`"]
    {
        assert_eq!(notices.iter().filter(|notice| notice.contains(part)).count(), 1, "{part}: {notices:?}");
    }
    // The directional light stands a billion times as far away as the eye.
    let far = (back.lights[0].source.position() - scene.lights[0].source.position()).length();
    assert!((8e9..1e10).contains(&far), "{far}");
    assert!(back.surfaces.iter().all(|surface| !matches!(surface.material.reflection, Reflection::Basic { .. })));
}

#[test]
fn a_directional_light_survives_as_a_far_point() {
    let mut scene = sipp_like::scene(&mut Random::new(11), Kinds::All);
    scene.lights.truncate(1);
    scene.surfaces.iter_mut().for_each(|surface| surface.material = Material::default());
    let (before, after) = (picture(&scene, &Choices::default()), picture(&converted(&scene).0, &Choices::default()));
    let level = |light: f32| i32::from(farop::color::Encoding::Srgb.level(light));
    for (a, b) in before.pixels().iter().zip(after.pixels()) {
        for (a, b) in a.to_array().into_iter().zip(b.to_array()) {
            assert!((level(a) - level(b)).abs() <= 1);
        }
    }
}

#[test]
fn needs_change_no_bit_of_sipp_scenes() {
    for seed in 0..4 {
        let scene = sipp_like::scene(&mut Random::new(40 + seed), Kinds::All);
        for shading in [Shading::Flat, Shading::Gouraud, Shading::Phong] {
            let of = |needs| picture(&scene, &Choices { shading, needs, ..Choices::default() });
            assert!(of(NeedsMode::Derived) == of(NeedsMode::Full), "seed {seed}, {}", shading.name());
        }
    }
    // Without a highlight anywhere not one is computed, whatever the model.
    let mut dull = sipp_like::scene(&mut Random::new(40), Kinds::All);
    dull.surfaces.iter_mut().for_each(|surface| surface.material.specular = 0.0);
    let choices = Choices { shading: Shading::Phong, ..Choices::default() };
    assert_eq!(render(&dull, &choices, Some(&ZBuffer)).expect("has a view").counts.work.specular_powers, 0);
    // A surface of `basic` alone needs them.
    let basic = |surface: &&mut farop::scene::Surface| matches!(surface.material.reflection, Reflection::Basic { .. });
    dull.surfaces.iter_mut().filter(basic).for_each(|surface| surface.material.specular = 0.5);
    let rendered = render(&dull, &choices, Some(&ZBuffer)).expect("has a view");
    assert!(rendered.plan.needs.specular && rendered.counts.work.specular_powers > 0);
}
