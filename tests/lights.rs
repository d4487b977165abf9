//! Lights and reflection models against formulas written another way, and against pictures whose shape is known.

mod support;

use farop::color::Rgb;
use farop::image::Image;
use farop::math::{PI, Vec3, cos, exp, log, radians, sin, tan};
use farop::plan::{Accepts, Choices, Culling, LightTerms, Plan, Shading};
use farop::raster::ZBuffer;
use farop::render::{Canvas, draw, render};
use farop::scene::{Camera, Light, LightSource, Material, NormalSource, Place, Reflection, Scene, SpotEdge};
use farop::screen::Shader;
use farop::screen::file::{Attributes, ReadOptions, Sheet, read, write_v2};
use farop::screen::shader::{EyeLight, EyeSource, Spot, SurfaceShading};
use support::random::Random;
use support::scenes;
use support::sipp_like::{self, Kinds};

const COLOR: Rgb = Rgb::new(0.75, 0.5, 0.25);
/// A point straight ahead: V is (0, 0, -1).
const POINT: Vec3 = Vec3::new(0.0, 0.0, 4.0);

/// The unit direction `degrees` away from V.
fn away(degrees: f64) -> Vec3 {
    let angle = radians(degrees);
    Vec3::new(sin(angle), 0.0, -cos(angle))
}

fn shader(reflection: Reflection, (ambient, diffuse, specular): (f64, f64, f64), lights: &[(f64, f64)]) -> Shader {
    let (ambient, diffuse, opacity) = (COLOR * ambient, COLOR * diffuse, Rgb::gray(1.0));
    let surface = SurfaceShading {
        reflection,
        ambient,
        diffuse,
        specular,
        shine: 9.0,
        opacity,
        texture: None,
        place: Place::default(),
    };
    let light = |&(degrees, level): &(f64, f64)| EyeLight {
        source: EyeSource::Directional { to_light: away(degrees) },
        color: Rgb::gray(level),
    };
    let mut shader = Shader::default();
    shader.lights.extend(lights.iter().map(light));
    shader.surfaces.push(surface);
    shader
}

fn assert_near(a: Rgb, b: Rgb, what: &str) {
    let difference = a.to_array().into_iter().zip(b.to_array()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(difference < 1e-12, "{what}: {a:?}, expected {b:?}");
}

#[test]
fn phong_and_basic_at_angles() {
    // All in one plane, angles measured from V: N at t, L at 2t + d, so R stands at -d and q is cos d.
    for (t, d) in [(0.0, 0.0), (0.0, 30.0), (20.0, 10.0), (35.0, -60.0), (60.0, 20.0), (60.0, 40.0), (80.0, 60.0)] {
        let lights = [(2.0 * t + d, 0.5)];
        let coefficients = (0.125, 0.375, 0.25);
        let lit = |reflection| shader(reflection, coefficients, &lights).light(0, POINT, away(t));
        let facing = cos(radians(t + d)).max(0.0) * 0.5;
        let (q, off) = (cos(radians(d)), sin(radians(d)));

        let power = exp(9.0 * log(q)) * 0.5;
        let expected = COLOR * (0.125 + 0.375 * facing) + Rgb::gray(0.25 * power);
        assert_near(lit(Reflection::Phong), expected, &format!("phong {t} {d}"));
        // NFF's is the same while the light is above the surface, and has no highlight where it is not.
        let gated = if t + d < 90.0 { expected } else { COLOR * 0.125 };
        assert_near(lit(Reflection::Nff), gated, &format!("nff {t} {d}"));

        for c3 in [0.01, 0.1, 0.5, 1.0] {
            // The quotient over sine and cosine instead of q alone.
            let quotient = q / (off * off / (c3 * c3) + q * q) * 0.5;
            let expected = COLOR * (0.125 + 0.375 * facing) + Rgb::gray(0.25 * quotient);
            assert_near(lit(Reflection::Basic { c3 }), expected, &format!("basic {c3} {t} {d}"));
        }
    }
}

#[test]
fn sums_and_results_are_cut_at_white() {
    let bright = [(0.0, 0.8), (0.0, 0.8)];
    for reflection in [Reflection::Phong, Reflection::Basic { c3: 0.3 }] {
        let lit = |coefficients| shader(reflection, coefficients, &bright).light(0, POINT, away(0.0));
        assert_near(lit((0.0, 0.5, 0.0)), COLOR * 0.5, "the diffuse sum of 1.6 counts as 1");
        assert_near(lit((0.0, 0.0, 0.5)), Rgb::gray(0.5), "so does that of the highlights");
        assert_near(lit((0.25, 1.0, 0.25)), Rgb::new(1.0, 0.875, 0.5625), "and no channel passes 1");
    }
    let nff = shader(Reflection::Nff, (0.0, 0.5, 0.0), &bright).light(0, POINT, away(0.0));
    assert_near(nff, COLOR * 0.8, "NFF's is not cut");
    // Behind: neither light nor highlight.
    let dark = shader(Reflection::Phong, (0.5, 1.0, 1.0), &[(180.0, 1.0)]).light(0, POINT, away(0.0));
    assert_near(dark, COLOR * 0.5, "a light behind the surface");
}

#[test]
fn a_spot_takes_its_share_of_both_terms() {
    let mut lit = shader(Reflection::Phong, (0.0, 0.5, 0.25), &[(0.0, 1.0)]);
    // It stands in the eye and is aimed beside the point; halfway between axis and cone, measured along the axis.
    let half_opening = radians(20.0);
    let share = (1.0 + cos(half_opening)) / 2.0;
    let axis = Vec3::new((1.0 - share * share).sqrt(), 0.0, share);
    let spot = Spot { position: Vec3::ZERO, axis, cosine: cos(half_opening), edge: SpotEdge::Soft };
    lit.lights[0].source = EyeSource::Spot(spot);
    assert_near(lit.light(0, POINT, away(0.0)), (COLOR * 0.5 + Rgb::gray(0.25)) * 0.5, "soft");
}

/// A white floor at height 0, `side` wide, seen from 10 above; 1 unit is 8 pixels.
fn floor(lights: Vec<Light>) -> Scene {
    let corner = |x: f64, y: f64| Vec3::new(x, y, 0.0);
    let outline = vec![corner(-9.0, -9.0), corner(9.0, -9.0), corner(9.0, 9.0), corner(-9.0, 9.0)];
    let material = Material { reflection: Reflection::Phong, ambient: Some(0.0), diffuse: 1.0, ..Material::default() };
    let camera = Camera {
        from: Vec3::new(0.0, 0.0, 10.0),
        at: Vec3::ZERO,
        up: Vec3::Y,
        angle: 2.0 * farop::math::atan(0.6).to_degrees(),
        resolution: (96, 96),
        ..scenes::camera(96, 96)
    };
    let surface = scenes::surface(material, scenes::facets(&[outline]));
    Scene { lights, ..scenes::scene(camera, vec![surface]) }
}

fn light(source: LightSource) -> Light {
    Light { source, color: Rgb::WHITE, intensity: Some(1.0), place: Place::default() }
}

fn picture(scene: &Scene, choices: &Choices) -> Image {
    render(scene, choices, Some(&ZBuffer)).expect("has a view").image
}

#[test]
fn a_spot_lights_a_circle_on_the_floor() {
    let phong = Choices { shading: Shading::Phong, ..Choices::default() };
    for (opening, height) in [(30.0, 6.0), (60.0, 5.0), (90.0, 4.0)] {
        let position = Vec3::new(1.0, -0.5, height);
        let at = Vec3::new(1.0, -0.5, 0.0);
        let of = |edge| picture(&floor(vec![light(LightSource::Spot { position, at, opening, edge })]), &phong);
        let (sharp, soft) = (of(SpotEdge::Sharp), of(SpotEdge::Soft));
        // The cone meets the floor in a circle around the point below.
        let radius = height * tan(radians(opening / 2.0)) * 8.0;
        let (center_x, center_y) = (48.0 + 8.0, 48.0 + 4.0);
        let mut lit = 0;
        for y in 0..96 {
            for x in 0..96 {
                let (dx, dy) = (x as f64 + 0.5 - center_x, y as f64 + 0.5 - center_y);
                let distance = (dx * dx + dy * dy).sqrt();
                let (sharp, soft) = (sharp.pixel(x, y).g, soft.pixel(x, y).g);
                lit += u32::from(sharp > 0.0);
                assert!(sharp > 0.0 || distance > radius - 0.01, "{opening}: dark inside at {x}, {y}");
                assert!(sharp == 0.0 || distance < radius + 0.01, "{opening}: lit outside at {x}, {y}");
                assert!(soft <= sharp && (soft > 0.0) == (sharp > 0.0), "{opening}: {soft} of {sharp} at {x}, {y}");
            }
        }
        let area = PI * radius * radius;
        assert!((f64::from(lit) - area).abs() < 4.0 * radius.sqrt() + 4.0, "{opening}: {lit} of {area}");
    }
}

#[test]
fn a_directional_light_is_a_point_light_far_away() {
    let mut scene = sipp_like::scene(&mut Random::new(2), Kinds::All);
    let to_light = Vec3::new(-3.0, -4.0, 6.0);
    let choices = Choices { shading: Shading::Phong, ..Choices::default() };
    let mut of = |source| {
        scene.lights = vec![light(source)];
        picture(&scene, &choices)
    };
    let near = of(LightSource::Directional { to_light });
    let far = of(LightSource::Point { position: to_light.normalize() * 1e9 });
    let level = |light: f32| i32::from(choices.encoding.level(light));
    for (a, b) in near.pixels().iter().zip(far.pixels()) {
        assert!(a.to_array().into_iter().zip(b.to_array()).all(|(a, b)| (level(a) - level(b)).abs() <= 1));
    }
    assert!(near != of(LightSource::Directional { to_light: -to_light }), "it leads towards the light");
}

#[test]
fn the_terms_add_up_to_the_picture() {
    let mut scene = sipp_like::scene(&mut Random::new(9), Kinds::All);
    // Dim enough that nothing is cut, and opaque: layers do not add up.
    scene.background = None;
    scene.lights.iter_mut().for_each(|light| (light.color, light.intensity) = (light.color * 0.2, Some(1.0)));
    for surface in &mut scene.surfaces {
        surface.material.opacity = Rgb::WHITE;
        surface.material.specular = 0.3;
    }
    for shading in [Shading::Flat, Shading::Gouraud, Shading::Phong] {
        let of = |ambient, diffuse, specular| {
            let light_terms = LightTerms { ambient, diffuse, specular };
            picture(&scene, &Choices { shading, light_terms, ..Choices::default() })
        };
        let parts = [of(true, false, false), of(false, true, false), of(false, false, true)];
        let whole = of(true, true, true);
        assert!(parts.iter().all(|part| part.pixels().iter().any(|pixel| pixel.g > 0.0)));
        for (index, pixel) in whole.pixels().iter().enumerate() {
            let sum: f32 = parts.iter().map(|part| part.pixels()[index].r).sum();
            assert!((sum - pixel.r).abs() < 1e-5, "{}: {sum} {}", shading.name(), pixel.r);
        }
    }
}

#[test]
fn two_sided_surfaces_keep_their_backs() {
    let mut scene = floor(vec![light(LightSource::Directional { to_light: Vec3::Z })]);
    scene.surfaces[0].mesh.outlines.reverse();
    let counts = |scene: &Scene, culling| {
        let choices = Choices { culling, ..Choices::default() };
        let rendered = render(scene, &choices, Some(&ZBuffer)).expect("has a view");
        (rendered.counts.backfacing, rendered.image.pixel(48, 48).g)
    };
    assert_eq!(counts(&scene, Culling::Back), (1, 0.0));
    scene.surfaces[0].two_sided = true;
    // The back is lit from the side that the eye sees.
    for culling in [Culling::Back, Culling::Nff, Culling::None] {
        assert_eq!(counts(&scene, culling), (0, 1.0));
    }
    let plan = Plan::new(&scene, &Choices::default(), Accepts::AnyPolygon).expect("has a view");
    let row = plan.explain().into_iter().find(|row| row.need == "culling").expect("the plan says it");
    assert_eq!(row.reason, "1 of 1 surfaces are two-sided and keep their back faces");
    scene.surfaces[0].mesh.polygons[0].normals = NormalSource::Averaged;
    assert_eq!(counts(&scene, Culling::Back), (0, 1.0));
}

/// What a v2 file of the scene says, and the picture it was made of.
fn dumped(scene: &Scene, choices: &Choices) -> (String, Image) {
    let rendered = render(scene, choices, Some(&ZBuffer)).expect("has a view");
    let Canvas { samples, background, transparency, .. } = Canvas::new(scene, choices);
    let sheet = Sheet { samples, background, transparency, encoding: choices.encoding };
    let mut bytes = Vec::new();
    let attributes = Attributes { phong: choices.shading == Shading::Phong, ..Attributes::default() };
    write_v2(&rendered.list, &sheet, attributes, &mut bytes).expect("memory takes everything");
    (String::from_utf8(bytes).expect("ASCII"), rendered.image)
}

#[test]
fn screen_files_keep_lights_and_models() {
    for seed in 0..3 {
        let scene = sipp_like::scene(&mut Random::new(70 + seed), Kinds::All);
        for shading in [Shading::Gouraud, Shading::Phong] {
            let (text, image) = dumped(&scene, &Choices { shading, ..Choices::default() });
            for words in [" directional\n", " soft\n", " sharp\n", " phong\n", " basic 0."] {
                assert!(text.contains(words), "{words}");
            }
            let file = read(&text, &ReadOptions::default()).unwrap_or_else(|error| panic!("{error}"));
            assert!(draw(&file.list, Some(&ZBuffer), &Canvas::of_sheet(&file.sheet)).0 == image, "seed {seed}");
        }
    }
}

#[test]
fn broken_lights_of_screen_files_are_named() {
    let scene = sipp_like::scene(&mut Random::new(70), Kinds::All);
    let text = dumped(&scene, &Choices { shading: Shading::Phong, ..Choices::default() }).0;
    let refused = |from: &str, to: &str| {
        assert!(text.contains(from), "{from}");
        let broken = text.replacen(from, to, 1);
        read(&broken, &ReadOptions::default()).expect_err("refused").to_string()
    };
    for (from, to, part) in [
        (" directional\n", " directed\n", "`directional` or `spot`"),
        (" directional\n", " directional 1\n", "end of the"),
        (" soft\n", " hazy\n", "`sharp` or `soft`"),
        (" soft\n", "\n", "`sharp` or `soft`"),
        (" phong\n", " phung\n", "`phong` or `basic`"),
        (" basic 0.", " basic 7.", "c3, a number from 0 to 1"),
    ] {
        let message = refused(from, to);
        assert!(message.contains(part) && message.starts_with("line "), "{from}: {message}");
    }
}
