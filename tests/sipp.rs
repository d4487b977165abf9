//! What a `.sipp` scene means: where things stand, what is shared, which vertices are one.

#[path = "support/command.rs"]
mod command;

use command::Desk;
use farop::math::{Affine3, Vec3};
use farop::parse::{ParseOptions, Parsed, load, read_sipp};
use farop::scene::{LightSource, NormalSource, Reflection, Scene, Shape, SpotEdge, Surface, TextureMapping};

const RED: &str = "shader red phong { color 1 0 0 }\n";

const SQUARE: &str = "surface red { polygon { v 0 0 0 v 1 0 0 v 1 1 0 v 0 1 0 } }";

fn parsed(text: &str) -> Parsed {
    read_sipp("scene.sipp", format!("{RED}{text}").as_bytes(), ParseOptions::default())
        .unwrap_or_else(|errors| panic!("{errors}"))
}

fn read(text: &str) -> Scene {
    parsed(text).scene
}

/// Name and place of the origin of every object instance, in the order they are drawn.
fn origins(scene: &Scene) -> Vec<(String, [f64; 3])> {
    let mut origins = Vec::new();
    let origin = |map: &Affine3| map.translation.to_array();
    scene
        .walk(|placed| origins.push((placed.object.name.clone(), origin(&placed.world_from_local))))
        .expect("within the budget");
    origins
}

fn only_surface(text: &str) -> Surface {
    let mut scene = read(&format!("world {{ {text} }}"));
    assert_eq!(scene.surfaces.len(), 1);
    scene.surfaces.remove(0)
}

/// The map of an object with these transforms.
fn map(transforms: &str) -> Affine3 {
    read(&format!("world {{ object {{ {transforms} }} }}")).objects[0].parent_from_local
}

#[test]
fn transforms_are_applied_in_the_listed_order() {
    let point = Vec3::new(1.0, 2.0, 3.0);
    assert_eq!(map("move 1 0 0  scale 2 2 2").transform_point3(point), Vec3::new(4.0, 4.0, 6.0));
    assert_eq!(map("scale 2 2 2  move 1 0 0").transform_point3(point), Vec3::new(3.0, 4.0, 6.0));
    // Between items they count all the same, and for the whole object.
    let scene = read("world { object { move 1 0 0 cube { size 1 shader red } scale 2 2 2 } }");
    assert_eq!(scene.objects[0].parent_from_local.transform_point3(point), Vec3::new(4.0, 4.0, 6.0));
}

#[test]
fn quarter_turns_follow_the_right_hand_rule_exactly() {
    let (x, y, z) = (Vec3::X, Vec3::Y, Vec3::Z);
    assert_eq!(map("rotate x 90deg").transform_point3(y), z);
    assert_eq!(map("rotate y 90deg").transform_point3(z), x);
    assert_eq!(map("rotate z 90deg").transform_point3(x), y);
    assert_eq!(map("rotate z -90deg").transform_point3(y), x);
    assert_eq!(map("rotate z 450deg").transform_point3(x), y);
    assert_eq!(map("rotate point 1 0 0 axis 0 0 5 180deg").transform_point3(Vec3::ZERO), Vec3::new(2.0, 0.0, 0.0));
    let turned = map("rotate z 0.5rad").transform_point3(x);
    assert!((turned - Vec3::new(0.5f64.cos(), 0.5f64.sin(), 0.0)).length() < 1e-15);
    assert_eq!(map("rotate x 30deg").transform_point3(x), x, "the axis stays, to the last bit");
}

#[test]
fn a_matrix_has_rows_and_a_mirror_has_a_plane() {
    let moved = map("matrix 0 1 0  -1 0 0  0 0 1  5 6 7");
    assert_eq!(moved.transform_point3(Vec3::X), Vec3::new(5.0, 7.0, 7.0), "row vectors: v' = v M");
    let mirrored = map("mirror point 0 0 1 normal 0 0 -3");
    assert_eq!(mirrored.transform_point3(Vec3::new(1.0, 2.0, 5.0)), Vec3::new(1.0, 2.0, -3.0));
    assert_eq!(mirrored.matrix3.determinant(), -1.0);
}

#[test]
fn transforms_multiply_down_the_tree() {
    let scene =
        read("world { object a { move 1 0 0 object b { move 0 1 0 rotate z 90deg object c { move 5 0 0 } } } }");
    let expected = [("a", [1.0, 0.0, 0.0]), ("b", [0.0; 3]), ("c", [0.0, 5.0, 0.0])];
    // b turns what it moved before: its origin is (-1, 0, 0) in a.
    let expected = expected.map(|(name, place)| (name.to_string(), place));
    assert_eq!(origins(&scene), expected);
}

#[test]
fn a_use_starts_from_the_identity_and_shares() {
    let scene = read(
        "world { use arm { move 1 0 0 } use arm }
         object arm { move 100 0 0 cube { size 1 shader red } object hand { move 0 0 2 cube { size 1 shader red } } }",
    );
    let expected = [("arm", [1.0, 0.0, 0.0]), ("hand", [1.0, 0.0, 2.0]), ("arm", [0.0; 3]), ("hand", [0.0, 0.0, 2.0])];
    assert_eq!(origins(&scene), expected.map(|(name, place)| (name.to_string(), place)));
    assert_eq!(
        (scene.objects.len(), scene.surfaces.len()),
        (3, 2),
        "one hand for both arms, no object for the definition"
    );
    let [first, second] = [0, 1].map(|index| scene.object(scene.world[index]));
    assert_eq!((&first.surfaces, &first.children), (&second.surfaces, &second.children));
}

#[test]
fn a_copy_has_its_own_nodes_and_a_clone_its_own_surfaces() {
    let arm = "object arm { cube { size 1 shader red } object hand { cube { size 2 shader red } } }
               shader blue basic { color 0 0 1 }";
    let scene = read(&format!("{arm} world {{ use arm copy arm }}"));
    assert_eq!((scene.objects.len(), scene.surfaces.len()), (4, 2));
    let [used, copied] = [0, 1].map(|index| scene.object(scene.world[index]));
    assert_eq!(used.surfaces, copied.surfaces);
    assert_ne!(used.children, copied.children);
    assert_eq!(scene.object(used.children[0]).surfaces, scene.object(copied.children[0]).surfaces);

    let scene = read(&format!("{arm} world {{ use arm clone arm {{ shader blue }} }}"));
    assert_eq!((scene.objects.len(), scene.surfaces.len()), (4, 4));
    let [used, cloned] = [0, 1].map(|index| scene.object(scene.world[index]));
    let reflection = |object: &farop::scene::Object| scene.surface(object.surfaces[0]).material.reflection;
    for (object, expected) in [(used, Reflection::Phong), (cloned, Reflection::Basic { c3: 0.2 })] {
        assert_eq!(reflection(object), expected);
        assert_eq!(reflection(scene.object(object.children[0])), expected, "all the way down");
    }
}

#[test]
fn names_may_be_used_above_their_lines_and_nested_objects_too() {
    let scene =
        read("world { use finger { move 1 0 0 } } object hand { object finger { cube { size 1 shader red } } }");
    assert_eq!(origins(&scene), [("finger".to_string(), [1.0, 0.0, 0.0])]);
    let scene = read("world { object a { object hand {} } object b { object hand {} } }");
    assert_eq!(scene.objects.len(), 4, "nested names may repeat as long as nobody uses them");
    let scene = read("object \"my arm\" {} world { use \"my arm\" object cube { cube { size 1 shader red } } }");
    assert_eq!(scene.object(scene.world[0]).name, "my arm");
}

#[test]
fn several_worlds_add_up_and_one_with_surfaces_is_an_object() {
    let scene = read("world { object a {} } world { move 0 0 1 object b {} cube { size 1 shader red } }");
    let expected = [("a", [0.0; 3]), ("", [0.0, 0.0, 1.0]), ("b", [0.0, 0.0, 1.0])];
    assert_eq!(origins(&scene), expected.map(|(name, place)| (name.to_string(), place)));
}

#[test]
fn vertices_in_place_are_welded_and_listed_ones_are_not() {
    let near =
        "surface red { polygon { v 0 0 0 v 100 0 0 v 100 100 0 } polygon { v 0.000000009 0 0 v 100 100 0 v 0 100 0 } }";
    assert_eq!(only_surface(near).mesh.outlines, [0, 1, 2, 0, 2, 3]);
    let far = near.replace("0.000000009", "0.000000011");
    assert_eq!(only_surface(&far).mesh.outlines, [0, 1, 2, 3, 2, 4]);
    let normals =
        "surface red { polygon { v 0 0 0 v 1 0 0 v 0 1 0 } polygon { v 0 0 0 n 0 0 2 v 1 0 0 v 0 -1 0 t 1 2 3 } }";
    let mesh = only_surface(normals).mesh;
    assert_eq!(mesh.outlines, [0, 1, 2, 3, 1, 4]);
    assert_eq!((mesh.normals[3], mesh.normals[0]), (Vec3::Z, Vec3::ZERO));
    assert_eq!((mesh.texture[4], mesh.texture[0]), (Vec3::new(1.0, 2.0, 3.0), Vec3::ZERO));
    let listed = "surface red { facet { 3 1 2 } v 0 0 0 v 0 0 0 v 1 0 0 v 0 1 0 polygon { 1 3 4 } polygon { v 0 0 0 v 1 0 0 v 0 1 0 } }";
    let mesh = only_surface(listed).mesh;
    assert_eq!(
        mesh.outlines,
        [0, 2, 3, 4, 5, 6],
        "the facet has no area; what is written in place comes behind the list"
    );
    assert_eq!(mesh.vertices[0], mesh.vertices[1]);
}

#[test]
fn winding_turns_outlines_and_keeps_the_first_vertex() {
    let mesh = only_surface(
        "surface red { v 0 0 0 v 1 0 0 v 1 1 0 v 0 1 0 facet { 1 2 3 4 } winding cw polygon { 1 2 3 4 } winding ccw polygon { 2 3 4 } }",
    )
    .mesh;
    assert_eq!(mesh.outlines, [0, 1, 2, 3, 0, 3, 2, 1, 1, 2, 3]);
    let normals: Vec<NormalSource> = mesh.polygons.iter().map(|polygon| polygon.normals).collect();
    assert_eq!(normals, [NormalSource::Facet, NormalSource::Averaged, NormalSource::Averaged]);
}

#[test]
fn two_sided_is_said_by_the_surface_or_by_the_file() {
    let items = "world { cube { size 1 shader red two_sided off } cube { size 1 shader red } \
                 surface red { two_sided on polygon { v 0 0 0 v 1 0 0 v 0 1 0 } } }";
    let sides = |text: &str| read(text).surfaces.iter().map(|surface| surface.two_sided).collect::<Vec<_>>();
    assert_eq!(sides(items), [false, false, true]);
    assert_eq!(sides(&format!("{items} two_sided on")), [false, true, true]);
}

#[test]
fn shapes_say_what_they_are() {
    let primitive = |text: &str| only_surface(text).primitives.remove(0);
    let torus = primitive("torus { ring 2 tube .5 res 20 10 shader red inside texture natural }");
    assert_eq!(torus.shape, Shape::Torus { ring_radius: 2.0, tube_radius: 0.5 });
    assert_eq!((torus.resolution, torus.inside, torus.texture), (Some([20, 10]), true, TextureMapping::Natural));
    let cylinder = primitive("cylinder { radius 1 length 3 shader red res 7 }");
    assert_eq!(cylinder.shape, Shape::CappedCone { bottom_radius: 1.0, top_radius: 1.0, length: 3.0 });
    assert_eq!((cylinder.resolution, cylinder.texture), (Some([7, 7]), TextureMapping::World));
    let Shape::Prism { outline, height } = primitive("prism { outline 0 0 0 1 2 0 height 3 shader red }").shape else {
        panic!("a prism")
    };
    assert_eq!((&outline[..], height), (&[[0.0, 0.0], [2.0, 0.0], [0.0, 1.0]][..], 3.0), "turned to counterclockwise");
    let Shape::Curves(net) = primitive("bezier { curve 1 2 3 4 v 1 0 0 v 1 0 1 v 1 0 2 v 1 0 3 shader red }").shape
    else {
        panic!("curves")
    };
    assert_eq!(net.curves, [[3, 2, 1, 0]], "from a file's direction to the scene's");
}

#[test]
fn shaders_and_lights_have_sipps_defaults() {
    let scene = read(
        "shader plain basic {} light directional { to 0 0 2 } light lamp spot { from 0 0 1 at 0 0 0 opening 30 edge soft }
         world { cube { size 1 shader plain } cube { size 1 shader red } }",
    );
    let [plain, red] = [0, 1].map(|index| scene.surfaces[index].material);
    assert_eq!((plain.reflection, plain.ambient, plain.specular), (Reflection::Basic { c3: 0.2 }, Some(0.3), 0.3));
    assert_eq!((red.reflection, red.diffuse, red.shine, red.opacity.g), (Reflection::Phong, 0.6, 20.0, 1.0));
    assert_eq!(scene.lights[0].source, LightSource::Directional { to_light: Vec3::new(0.0, 0.0, 2.0) });
    let (position, at, opening, edge) = (Vec3::Z, Vec3::ZERO, 30.0, SpotEdge::Soft);
    assert_eq!(scene.lights[1].source, LightSource::Spot { position, at, opening, edge });
    assert_eq!((scene.lights[1].intensity, scene.lights[1].color.b), (Some(1.0), 1.0));
}

#[test]
fn a_camera_has_sipps_defaults_and_the_picture_size() {
    let camera = read("camera { from 0 -20 0 up 0 0 1 } image 30 20").camera.expect("it has one");
    assert_eq!((camera.hither, camera.yon, camera.resolution), (0.2, None, (30, 20)));
    assert!((camera.angle - 28.072_486_935_852_95).abs() < 1e-12, "focal .25: {}", camera.angle);
    assert_eq!(read("camera { angle 40 }").camera.map(|camera| camera.angle), Some(40.0));
    let without = parsed("image 30 20");
    assert_eq!(without.scene.camera, None);
    let default = without.default_camera.expect("SIPP has one");
    assert_eq!((default.from, default.hither, default.resolution), (Vec3::new(0.0, 0.0, 10.0), 0.1, (30, 20)));
    assert_eq!(parsed("camera {}").default_camera, None);
}

#[test]
fn imports_stand_under_their_transforms_and_are_shared() {
    let desk = Desk::new();
    desk.write("ball.nff", "b 1 0 0\nl 1 1 1\nf 0 1 0 .8 0 0 0 1\ns 0 0 0 1\n");
    desk.write(
        "scene.sipp",
        "world { import \"ball.nff\" { move 1 0 0 } use far }\nobject far { import \"ball.nff\" { move 0 5 0 } }",
    );
    let scene = load(&desk.path("scene.sipp"), None, ParseOptions::default()).expect("legal").scene;
    let expected = [
        ("ball.nff", [1.0, 0.0, 0.0]),
        ("ball.nff", [1.0, 0.0, 0.0]),
        ("far", [0.0; 3]),
        ("ball.nff", [0.0, 5.0, 0.0]),
        ("ball.nff", [0.0, 5.0, 0.0]),
    ];
    assert_eq!(origins(&scene), expected.map(|(name, place)| (name.to_string(), place)));
    assert_eq!((scene.surfaces.len(), scene.lights.len(), scene.background), (1, 0, None), "read once, objects alone");
    assert!(scene.describe(scene.surfaces[0].place).ends_with("ball.nff:3"));
}

#[test]
fn nff_and_sipp_merge_on_the_command_line() {
    let desk = Desk::new();
    let nff = |z: u32| {
        format!(
            "b 1 0 0\nv\nfrom 0 0 {z}\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\nresolution 16 16\nl 1 1 1\ns 0 0 0 1\n"
        )
    };
    desk.write("a.nff", nff(5));
    desk.write(
        "b.sipp",
        format!(
            "{RED} world {{ {SQUARE} }} light point {{ at 2 2 2 }} background 0 0 1 camera {{ from 0 0 20 }} image 8 8"
        ),
    );
    desk.write("c.sipp", format!("{RED} world {{ {SQUARE} }} image 4 4"));
    let stats = |scenes: &str| desk.done(&format!("plan {scenes}"));
    let both = stats("a.nff b.sipp");
    assert!(
        both.stderr.contains("the camera of b.sipp wins") && both.stderr.contains("the background of b.sipp wins"),
        "{}",
        both.stderr
    );
    let other = stats("b.sipp a.nff");
    assert!(other.stderr.contains("the camera of a.nff wins"), "{}", other.stderr);
    // SIPP's default camera never wins over one that somebody wrote, whatever the order, and says nothing.
    for scenes in ["a.nff c.sipp", "c.sipp a.nff"] {
        assert!(!stats(scenes).stderr.contains("camera"), "{scenes}");
        assert_eq!(size_of(&desk, scenes), (16, 16), "{scenes}");
    }
    assert_eq!(size_of(&desk, "c.sipp"), (4, 4));
    let overridden = stats("c.sipp --from 0,0,7");
    assert_eq!(overridden.stderr, "", "nobody wrote what --from replaces");
}

/// Every example of the document is a whole scene without a mistake.
#[test]
fn the_examples_of_the_document_are_read() {
    let document = include_str!("../docs/formats.md");
    let examples: Vec<&str> =
        document.split("```sipp\n").skip(1).map(|rest| rest.split("```").next().expect("a block ends")).collect();
    assert!(examples.len() >= 8);
    for example in examples {
        let parsed = read_sipp("example.sipp", example.as_bytes(), ParseOptions::default());
        let parsed = parsed.unwrap_or_else(|errors| panic!("{errors}\n{example}"));
        let said = parsed.notices.to_string();
        assert!(said.is_empty() || example.contains("import"), "{said}\n{example}");
    }
}

/// Deep nesting and many siblings take time in proportion, and no stack.
#[test]
fn a_hundred_thousand_nested_objects_and_as_many_siblings() {
    let count = 100_000;
    let nested = format!("world {{ {} {} }}", "object { move 0 0 1\n".repeat(count), "}".repeat(count));
    let scene = read(&nested);
    assert_eq!(scene.objects.len(), count);
    assert_eq!(origins(&scene).last().map(|(_, place)| place[2]), Some(count as f64));
    let siblings = "use ball { move 1 0 0 }\n".repeat(count);
    let scene = read(&format!("object ball {{ sphere {{ radius 1 shader red }} }} world {{ {siblings} }}"));
    assert_eq!((scene.world.len(), scene.objects.len(), scene.surfaces.len()), (count, count, 1));
    let chain: String = (0..count).map(|i| format!("object d{i} {{ use d{} }}\n", i + 1)).collect();
    assert_eq!(origins(&read(&format!("{chain} object d{count} {{}} world {{ use d0 }}"))).len(), count + 1);
}

/// Width and height of the picture of some scenes.
fn size_of(desk: &Desk, scenes: &str) -> (u32, u32) {
    let dumped = desk.done(&format!("dump {scenes} --classic --yon 50 -o -"));
    let mut numbers = dumped.text().split_whitespace().map(|word| word.parse().expect("a number"));
    (numbers.next().expect("width"), numbers.next().expect("height"))
}
