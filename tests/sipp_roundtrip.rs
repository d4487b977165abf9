//! Printing and parsing are inverse: `.sipp` text of a scene reads back as the scene, to the bit.
//!
//! "Equal" is decided on the tree as somebody sees it who walks it: depth by depth, names, transforms, and of every surface the material,
//! two-sidedness, vertices, polygons or shape. Which index of an arena a thing has, how often shared things are stored, and whether a zero
//! has a sign is not compared; nor are lines.

mod support;

use farop::color::Rgb;
use farop::math::{Affine3, Vec3};
use farop::parse::{ParseOptions, read_sipp};
use farop::scene::{
    Camera, CurveNet, Light, LightSource, Material, Mesh, NormalSource, Object, ObjectId, PatchNet, Place, Primitive,
    Reflection, Scene, Shape, SpotEdge, Surface, SurfaceId, TeapotPart, TextureMapping,
};
use farop::write::write_sipp;
use proptest::prelude::*;
use support::random::Random;

fn printed(scene: &Scene) -> (String, Vec<String>) {
    let mut out = Vec::new();
    let notices = write_sipp(scene, &mut out).unwrap_or_else(|error| panic!("{error}"));
    (String::from_utf8(out).expect("text"), notices)
}

fn parsed(text: &str) -> Scene {
    read_sipp("a.sipp", text.as_bytes(), ParseOptions::default())
        .unwrap_or_else(|errors| panic!("{errors}\n{text}"))
        .scene
}

/// A scene as lines that say everything about it; no indices of arenas, no lines of files.
fn canonical(scene: &Scene) -> Vec<String> {
    let mut lines =
        vec![format!("{:?} {:?}", scene.camera.map(|c| Camera { place: Place::default(), ..c }), scene.background)];
    lines.extend(scene.lights.iter().map(|&light| format!("{:?}", Light { place: Place::default(), ..light })));
    let mut stack: Vec<(ObjectId, usize)> = scene.world.iter().rev().map(|&id| (id, 0)).collect();
    while let Some((id, depth)) = stack.pop() {
        let object = scene.object(id);
        lines.push(format!("{depth} {:?} {:?}", object.name, object.parent_from_local.to_cols_array()));
        object.surfaces.iter().for_each(|&surface| lines.extend(surface_lines(scene.surface(surface))));
        stack.extend(object.children.iter().rev().map(|&child| (child, depth + 1)));
    }
    // A zero has no sign.
    lines
        .iter()
        .map(|line| {
            line.replace("-0.0,", "0.0,").replace("-0.0]", "0.0]").replace("-0.0)", "0.0)").replace("-0.0 ", "0.0 ")
        })
        .collect()
}

fn surface_lines(surface: &Surface) -> Vec<String> {
    let mut material = surface.material;
    material.refraction = 1.0;
    if matches!(material.reflection, Reflection::Basic { .. }) {
        (material.diffuse, material.shine) = (1.0, 0.0);
    }
    let head = format!("  {material:?} {}", surface.two_sided);
    let shapes =
        surface.primitives.iter().map(|p| format!("{head} {:?}", Primitive { before: 0, line: 0, ..p.clone() }));
    let mut lines: Vec<String> = shapes.collect();
    if !surface.mesh.polygons.is_empty() {
        lines.push(format!("{head} {:?} {:?} {:?}", surface.mesh.vertices, surface.mesh.normals, surface.mesh.texture));
        let polygons = surface.mesh.polygons.iter();
        lines.extend(polygons.map(|polygon| format!("    {:?} {:?}", polygon.normals, surface.mesh.outline(polygon))));
    }
    lines
}

fn assert_reads_back(scene: &Scene) {
    let (text, notices) = printed(scene);
    assert!(notices.is_empty(), "{notices:?}\n{text}");
    let again = parsed(&text);
    let (expected, found) = (canonical(scene), canonical(&again));
    for (index, (expected, found)) in expected.iter().zip(&found).enumerate() {
        assert_eq!(expected, found, "line {index} of the walk\n{text}");
    }
    assert_eq!(expected.len(), found.len(), "{text}");
    assert_eq!(printed(&again).0, text, "printed again");
}

/// Makes scenes of everything the language can say.
struct Maker {
    random: Random,
}

impl Maker {
    /// Numbers of all sizes, short and long ones.
    fn number(&mut self) -> f64 {
        match self.random.whole(0, 5) {
            0 => self.random.whole(-9, 9) as f64,
            1 => self.random.whole(-99, 99) as f64 / 8.0,
            2 => self.random.between(-1.0, 1.0) * 10f64.powi(self.random.whole(-12, 12) as i32),
            _ => self.random.between(-4.0, 4.0),
        }
    }

    fn positive(&mut self) -> f64 {
        self.number().abs() + 1e-3
    }

    fn fraction(&mut self) -> f64 {
        if self.random.one_in(3) { 1.0 } else { self.random.between(0.0, 1.0) }
    }

    fn point(&mut self) -> Vec3 {
        Vec3::new(self.number(), self.number(), self.number())
    }

    fn color(&mut self) -> Rgb {
        Rgb::new(self.fraction(), self.fraction(), self.fraction())
    }

    fn transform(&mut self) -> Affine3 {
        match self.random.whole(0, 5) {
            0 => Affine3::IDENTITY,
            1 => Affine3::from_translation(self.point()),
            2 => Affine3::from_scale(self.point() + Vec3::splat(0.125)),
            3 => Affine3 { translation: self.point(), ..Affine3::from_scale(self.point()) },
            _ => Affine3::from_cols(self.point(), self.point(), self.point(), self.point()),
        }
    }

    fn material(&mut self) -> Material {
        let opacity = if self.random.one_in(2) { Rgb::WHITE } else { self.color() };
        let opacity = if self.random.one_in(3) { Rgb::gray(opacity.r) } else { opacity };
        let base = Material {
            color: self.color(),
            ambient: Some(self.fraction()),
            specular: self.fraction(),
            opacity,
            ..Material::default()
        };
        if self.random.one_in(2) {
            Material { reflection: Reflection::Phong, diffuse: self.fraction(), shine: self.positive(), ..base }
        } else {
            let c3 = self.random.between(0.01, 1.0);
            Material { reflection: Reflection::Basic { c3 }, diffuse: 1.0, ..base }
        }
    }

    fn shape(&mut self) -> Shape {
        match self.random.whole(0, 12) {
            0 => Shape::Sphere { center: Vec3::ZERO, radius: self.positive() },
            1 => Shape::Sphere { center: self.point(), radius: self.positive() },
            2 => Shape::Ellipsoid { radii: self.point().abs() + Vec3::splat(0.5) },
            3 => Shape::CappedCone { bottom_radius: self.positive(), top_radius: 0.0, length: self.positive() },
            4 => {
                let radius = self.positive();
                Shape::CappedCone { bottom_radius: radius, top_radius: radius, length: self.positive() }
            }
            5 => Shape::Block { size: Vec3::splat(self.positive()) },
            6 => Shape::Block { size: self.point().abs() + Vec3::splat(0.5) },
            7 => {
                // A saw: concave, and simple whatever the heights of its teeth.
                let teeth = self.random.whole(1, 5);
                let mut outline = vec![[0.0, 0.0], [2.0 * teeth as f64, 0.0]];
                (1..2 * teeth).rev().for_each(|x| outline.push([x as f64, self.random.between(0.5, 2.0)]));
                Shape::Prism { outline: outline.into(), height: self.positive() }
            }
            8 => Shape::Torus { ring_radius: self.positive(), tube_radius: self.positive() },
            9 => {
                let base = self.point();
                let (base_radius, apex_radius) =
                    (self.positive(), if self.random.one_in(2) { 0.0 } else { self.positive() });
                Shape::Cone { base, base_radius, apex: base + Vec3::splat(self.positive()), apex_radius }
            }
            10 => {
                let vertices = (0..5).map(|_| self.point()).collect();
                let patches =
                    (0..self.random.whole(1, 3)).map(|_| std::array::from_fn(|_| self.random.whole(0, 4) as u32));
                Shape::Patches(PatchNet { vertices, patches: patches.collect() }.into())
            }
            11 => {
                let vertices = (0..4).map(|_| self.point()).collect();
                let curves =
                    (0..self.random.whole(1, 3)).map(|_| std::array::from_fn(|_| self.random.whole(0, 3) as u32));
                Shape::Curves(CurveNet { vertices, curves: curves.collect() }.into())
            }
            _ => {
                use TeapotPart::{Body, Handle, Lid, Spout, Whole};
                Shape::Teapot([Whole, Body, Lid, Handle, Spout][self.random.whole(0, 4) as usize])
            }
        }
    }

    fn primitive(&mut self) -> Primitive {
        use TextureMapping::{Cylindrical, Natural, Spherical, World};
        let mut primitive = Primitive::new(self.shape(), 0, 0);
        if self.random.one_in(2) {
            let (n, m) = (self.random.whole(1, 60) as u32, self.random.whole(1, 60) as u32);
            let is_torus = matches!(primitive.shape, Shape::Torus { .. });
            primitive.resolution = Some([n, if is_torus { m } else { n }]);
        }
        primitive.inside = self.random.one_in(5);
        primitive.texture = [World, Natural, Cylindrical, Spherical][self.random.whole(0, 3) as usize];
        primitive
    }

    /// Polygons in planes of their own: no reader may drop them.
    fn mesh(&mut self) -> Mesh {
        let (with_normals, with_texture) = (self.random.one_in(2), self.random.one_in(3));
        let mut mesh = Mesh::default();
        for _ in 0..self.random.whole(1, 4) {
            let (center, corners) = (self.point(), self.random.whole(3, 7) as u32);
            let first = mesh.vertices.len() as u32;
            for corner in 0..corners {
                let angle = f64::from(corner) * std::f64::consts::TAU / f64::from(corners);
                let size = center.length() + 1.0;
                mesh.vertices.push(center + Vec3::new(angle.cos(), angle.sin(), 0.0) * size);
                if with_normals {
                    let normal = if self.random.one_in(3) {
                        Vec3::ZERO
                    } else {
                        farop::math::unit(self.point() + Vec3::X * 9.0).expect("not zero")
                    };
                    mesh.normals.push(normal);
                }
                if with_texture {
                    mesh.texture.push(self.point());
                }
            }
            let outline: Vec<u32> = (first..first + corners).collect();
            mesh.push_polygon(
                &outline,
                if self.random.one_in(2) { NormalSource::Facet } else { NormalSource::Averaged },
                0,
            );
        }
        if mesh.normals.iter().all(|&normal| normal == Vec3::ZERO) {
            mesh.normals.clear();
        }
        mesh
    }

    fn light(&mut self) -> Light {
        let position = self.point();
        let away = position + Vec3::new(0.0, self.positive(), position.x.abs() + 1.0);
        let source = match self.random.whole(0, 2) {
            0 => LightSource::Directional { to_light: away },
            1 => LightSource::Point { position },
            _ => {
                let edge = if self.random.one_in(2) { SpotEdge::Sharp } else { SpotEdge::Soft };
                LightSource::Spot { position, at: away, opening: self.random.between(1.0, 170.0), edge }
            }
        };
        Light { source, color: self.color(), intensity: Some(1.0), place: Place::default() }
    }

    fn camera(&mut self) -> Camera {
        let from = self.point();
        let yon = self.random.one_in(2).then_some(2e15);
        let resolution = (self.random.whole(1, 999) as u32, self.random.whole(1, 999) as u32);
        let (at, angle) =
            (from + Vec3::new(self.positive() + from.length(), 1.0, 0.0), self.random.between(1.0, 179.0));
        Camera { from, at, up: Vec3::Z, angle, hither: self.positive(), yon, resolution, place: Place::default() }
    }

    /// Objects that use later ones, any of them several times; the first is the world's, and perhaps others.
    fn scene(&mut self) -> Scene {
        let mut scene = Scene { camera: Some(self.camera()), ..Scene::default() };
        scene.background = self.random.one_in(2).then(|| self.color());
        scene.lights = (0..self.random.whole(0, 4)).map(|_| self.light()).collect();
        let materials: Vec<Material> = (0..3).map(|_| self.material()).collect();
        let all_two_sided = self.random.one_in(4);
        let count = self.random.whole(1, 9) as u32;
        for index in 0..count {
            let first = scene.surfaces.len() as u32;
            for _ in 0..self.random.whole(0, 3) {
                let is_shape = self.random.one_in(2);
                let mesh = if is_shape { Mesh::default() } else { self.mesh() };
                let primitives = if is_shape { vec![self.primitive()] } else { Vec::new() };
                let material = materials[self.random.whole(0, 2) as usize];
                let two_sided = all_two_sided || self.random.one_in(3);
                scene.surfaces.push(Surface { material, mesh, primitives, two_sided, place: Place::default() });
            }
            let surfaces = (first..scene.surfaces.len() as u32).map(SurfaceId).collect();
            let last = i64::from(count) - 1;
            let children = if index + 1 == count { 0 } else { self.random.whole(0, 3) };
            let children =
                (0..children).map(|_| ObjectId(self.random.whole(i64::from(index) + 1, last) as u32)).collect();
            let name = [format!("part{index}"), format!("my part {index}"), format!("_{index}.nff")]
                [self.random.whole(0, 2) as usize]
                .clone();
            scene.objects.push(Object {
                name,
                parent_from_local: self.transform(),
                surfaces,
                children,
                place: Place::default(),
            });
        }
        // An instance of another object: its name, surfaces and children, a transform of its own.
        if self.random.one_in(2) {
            let original = scene.objects[self.random.whole(0, i64::from(count) - 1) as usize].clone();
            scene.objects.push(Object { parent_from_local: self.transform(), ..original });
            scene.world.push(ObjectId(count));
        }
        scene.world.push(ObjectId(0));
        scene
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 500, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn what_is_printed_reads_back(seed in any::<u64>()) {
        assert_reads_back(&Maker { random: Random::new(seed) }.scene());
    }
}

fn object(name: &str, surfaces: &[u32], children: &[u32]) -> Object {
    Object {
        name: name.to_string(),
        parent_from_local: Affine3::from_translation(Vec3::X),
        surfaces: surfaces.iter().map(|&id| SurfaceId(id)).collect(),
        children: children.iter().map(|&id| ObjectId(id)).collect(),
        place: Place::default(),
    }
}

fn ball() -> Surface {
    let material = Material { reflection: Reflection::Phong, ambient: Some(0.25), ..Material::default() };
    let primitives = vec![Primitive::new(Shape::Sphere { center: Vec3::ZERO, radius: 1.0 }, 0, 0)];
    Surface { material, mesh: Mesh::default(), primitives, two_sided: false, place: Place::default() }
}

fn camera() -> Option<Camera> {
    Some(Maker { random: Random::new(1) }.camera())
}

/// 2^16 balls that 17 objects say.
#[test]
fn what_is_shared_is_said_once() {
    let mut objects: Vec<Object> = (0..16).map(|i| object(&format!("o{i}"), &[], &[i + 1, i + 1])).collect();
    objects.push(object("ball", &[0], &[]));
    let scene =
        Scene { objects, surfaces: vec![ball()], world: vec![ObjectId(0)], camera: camera(), ..Scene::default() };
    assert_reads_back(&scene);
    let (text, _) = printed(&scene);
    assert!(text.len() < 3000 && text.matches("sphere").count() == 1, "{text}");
    assert_eq!(parsed(&text).surfaces.len(), 1);
}

#[test]
fn copies_and_clones_read_back() {
    let text = "camera { } light sun directional { to 0 0 1 } shader a phong { } shader b basic { }
        object arm { object hand { move 1 0 0 sphere { radius 1 shader a } } cube { size 1 shader a } rotate x 30deg }
        world { use arm { move 1 2 3 } copy arm { rotate z 40deg } clone arm { shader b scale 1 2 1 }
                object { object hand { torus { ring 2 tube 1 shader a res 4 5 } } use arm } }";
    let scene = parsed(text);
    assert_reads_back(&scene);
    assert!(printed(&scene).0.matches("use arm").count() == 3);
}

/// Definitions need names of their own, nested objects do not.
#[test]
fn names_are_made_up_where_they_must_be() {
    let objects = vec![
        object("top", &[], &[1, 1, 2, 2, 3, 3, 4]),
        object("a", &[0], &[]),
        object("a", &[1], &[]),
        object("", &[0, 1], &[]),
        object("a \"#\n", &[1, 0], &[5]),
        object("a", &[0, 0], &[]),
    ];
    let scene = Scene {
        objects,
        surfaces: vec![ball(), ball()],
        world: vec![ObjectId(0)],
        camera: camera(),
        ..Scene::default()
    };
    let (text, notices) = printed(&scene);
    assert_eq!(notices.len(), 1, "{notices:?}");
    assert!(notices[0].ends_with(": 3"), "{notices:?}");
    for said in ["object a {", "object a-2 {", "object part {", "object \"a ___\" {", "use a {", "use a-2 {"] {
        let said = said.replace("___", "__\u{240a}");
        assert!(text.contains(&said), "{said}\n{text}");
    }
    assert_eq!(printed(&parsed(&text)).0, text);
}

#[test]
fn an_object_inside_itself_is_refused() {
    let scene = Scene {
        objects: vec![object("a", &[], &[1]), object("b", &[], &[0])],
        world: vec![ObjectId(0)],
        ..Scene::default()
    };
    let error = write_sipp(&scene, &mut Vec::new()).expect_err("a cycle");
    assert!(error.to_string().contains("inside itself"), "{error}");
}

#[test]
fn every_loss_has_its_notice() {
    let text = b"v from 0 0 5 at 0 0 0 up 0 1 0 angle 40 hither 1 resolution 9 9 l 1 2 3 f .9 .8 .7 .6 .5 30 .25 1
        p 3 0 0 0 1 0 0 0 1 0 s 0 0 0 1 pp 3 0 0 0 0 0 1 1 0 0 0 0 1 0 1 0 0 1 0";
    let scene = farop::parse::read_nff("a.nff", text, ParseOptions::default()).expect("legal").scene;
    let (text, notices) = printed(&scene);
    insta::with_settings!({ omit_expression => true, prepend_module_to_snapshot => false }, {
        insta::assert_snapshot!("sipp_losses", format!("{text}\n{}\n", notices.join("\n")));
    });
    let again = parsed(&text);
    assert_eq!(again.lights[0].color, Rgb::gray(0.5));
    assert_eq!(printed(&again), (text, Vec::new()));
}

#[test]
fn numbers_that_no_file_can_say_are_refused() {
    let mut scene = Scene {
        objects: vec![object("", &[0], &[])],
        surfaces: vec![ball()],
        world: vec![ObjectId(0)],
        ..Scene::default()
    };
    scene.objects[0].parent_from_local.translation.x = f64::NAN;
    assert_eq!(write_sipp(&scene, &mut Vec::new()).expect_err("refused").kind(), std::io::ErrorKind::InvalidData);
}

/// In the stack of a test thread, 2 MB. `examples/large_trees.rs` has the figures, and a million siblings.
#[test]
fn a_hundred_thousand_nested_objects_print_parse_and_drop() {
    let count = 100_000;
    let objects = (0..count).map(|i| object("", &[0], if i + 1 < count { &[1] } else { &[] }));
    let mut objects: Vec<Object> = objects.collect();
    objects.iter_mut().enumerate().for_each(|(i, object)| {
        object.children.iter_mut().for_each(|child| *child = ObjectId(i as u32 + 1));
    });
    let scene =
        Scene { objects, surfaces: vec![ball()], world: vec![ObjectId(0)], camera: camera(), ..Scene::default() };
    let (text, _) = printed(&scene);
    assert!(text.len() < 30_000_000, "{} bytes: indentation has an end", text.len());
    let again = parsed(&text);
    let mut placed = (0, 0.0);
    again.walk(|instance| placed = (placed.0 + 1, instance.world_from_local.translation.x)).expect("within the budget");
    assert_eq!(placed, (count, f64::from(count)));
}
