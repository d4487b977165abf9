//! The draw list does not tell how many threads made it, nor what was made before it in the same memory.

mod support;

use farop::geometry::{Stage, run};
use farop::math::{Affine3, Vec3};
use farop::plan::{Accepts, Choices, ClipLight, Culling, DepthFormat, FlatRule, Interpolation, Plan, Shading};
use farop::report::Counts;
use farop::scene::{Material, NormalSource, Object, ObjectId, Place, Scene, SurfaceId};
use farop::screen::{DrawList, Shared, Whole};
use farop::spd::Curves;
use support::built_in::built_in;
use support::mixed::Mix;
use support::random::Random;
use support::scenes::{camera, scene, surface, wide_mesh};

fn plan(scene: &Scene, choices: &Choices, threads: u32) -> Plan {
    let choices = Choices { size: Some((96, 80)), threads: Some(threads), ..choices.clone() };
    Plan::new(scene, &choices, Accepts::AnyPolygon).expect("has a view")
}

/// Every number of a list as its bits: 0 and -0 are equal, and yet two numbers.
fn bits(list: &DrawList) -> Vec<u64> {
    let vertices = list.vertices.iter().flat_map(|v| [v.x, v.y, v.homogeneous.x, v.homogeneous.y, v.homogeneous.z]);
    let planes = list.planes.iter().flat_map(|plane| [plane.a, plane.b, plane.c, plane.low, plane.high]);
    vertices.chain(planes).chain(list.values.iter().copied()).map(f64::to_bits).collect()
}

fn assert_same(known: &(DrawList, Counts), found: &(DrawList, Counts), what: &str) {
    // Polygons first: where they differ, nothing else can be compared.
    assert_eq!(known.0.len(), found.0.len(), "{what}: polygons");
    assert!(known.0.polygons == found.0.polygons, "{what}: records");
    assert!(known.0 == found.0, "{what}: lists");
    assert!(bits(&known.0) == bits(&found.0), "{what}: bits");
    assert_eq!(known.1, found.1, "{what}: counts");
}

fn of(scene: &Scene, plan: &Plan) -> (DrawList, Counts) {
    let mut list = DrawList::new(0, 0);
    let counts = run(scene, plan, &mut list);
    (list, counts)
}

/// A large surface whose polygons reach over all sides, shared vertices, means and given normals beside facets; then many small ones.
fn large_and_small() -> Scene {
    let material = Material { specular: 0.5, shine: 7.0, ..Material::default() };
    let mut mesh = wide_mesh(&mut Random::new(3), 80, (0.3, -0.2), false);
    for (number, polygon) in mesh.polygons.iter_mut().enumerate() {
        polygon.normals = [NormalSource::Averaged, NormalSource::Facet][number % 2];
    }
    let mut small =
        Mix { polygons: 400, corners: (3, 6), distance: (0.5, 9.0), spread: 1.0, ..Mix::default() }.scene(96);
    small.surfaces.insert(2, surface(material, mesh));
    let surfaces = small.surfaces;
    let mut made = scene(camera(96, 80), surfaces);
    made.lights = small.lights;
    made.objects[0].surfaces = (0..5).map(SurfaceId).collect();
    // Twenty copies of the small ones, every other one mirrored.
    for number in 0..20 {
        let (name, place) = (String::new(), Place::default());
        let mirror = Vec3::new(if number % 2 == 0 { 1.0 } else { -1.0 }, 1.0, 1.0);
        let parent_from_local =
            Affine3::from_translation(Vec3::X * 0.1 * f64::from(number)) * Affine3::from_scale(mirror);
        let surfaces = [0, 1, 3, 4].map(SurfaceId).to_vec();
        made.world.push(ObjectId(made.objects.len() as u32));
        made.objects.push(Object { name, parent_from_local, surfaces, children: vec![], place });
    }
    made
}

#[test]
fn any_number_of_threads_makes_the_same_list() {
    let made = large_and_small();
    let shapes = built_in("balls", 2, Curves::Kept);
    let relight = Choices { clip_light: ClipLight::Relight, culling: Culling::None, ..Choices::default() };
    let all = [
        (&made, "gouraud", Choices::default()),
        (&made, "phong", Choices { shading: Shading::Phong, culling: Culling::None, ..Choices::default() }),
        (&made, "flat in triangles", Choices { shading: Shading::Flat, triangles: true, ..Choices::default() }),
        (&made, "relight", relight),
        (&made, "wire", Choices { shading: Shading::Wire, ..Choices::default() }),
        (&shapes, "shapes", Choices { tolerance: 0.02, ..Choices::default() }),
        (&shapes, "shapes on screen", Choices { interpolation: Interpolation::Screen, ..Choices::default() }),
    ];
    for (scene, name, choices) in all {
        let known = of(scene, &plan(scene, &choices, 1));
        assert!(known.0.len() > 2000, "{name}: {} polygons", known.0.len());
        for threads in [2, 3, 7, 64] {
            assert_same(&known, &of(scene, &plan(scene, &choices, threads)), &format!("{name}, {threads} threads"));
        }
    }
}

#[test]
fn a_stage_remembers_nothing_but_its_memory() {
    let (mut stage, mut list) = (Stage::default(), DrawList::new(0, 0));
    let scenes = [large_and_small(), Mix::default().scene(96), built_in("gears", 1, Curves::Kept)];
    for round in 0..3 {
        for (number, scene) in scenes.iter().enumerate() {
            for shading in [Shading::Gouraud, Shading::Wire, Shading::Phong] {
                let plan = plan(scene, &Choices { shading, ..Choices::default() }, 1 + (round + number as u32) % 3);
                let counts = stage.run(scene, &plan, &mut list);
                let again = (std::mem::replace(&mut list, DrawList::new(0, 0)), counts);
                assert_same(&of(scene, &plan), &again, &format!("round {round}, scene {number}, {shading:?}"));
                list = again.0;
            }
        }
    }
}

#[test]
fn shared_triangles_are_whole_as_those_of_everybody_else() {
    let made = large_and_small();
    let shapes = built_in("balls", 2, Curves::Kept);
    let colored = colored_flake();
    let phong = Choices { shading: Shading::Phong, culling: Culling::None, ..Choices::default() };
    let all = [
        (&made, "gouraud", Choices::default(), true),
        (&made, "phong", phong.clone(), true),
        (&made, "flat", Choices { shading: Shading::Flat, ..Choices::default() }, true),
        (
            &made,
            "flat by vertices",
            Choices { shading: Shading::Flat, flat: FlatRule::Vertex, ..Choices::default() },
            true,
        ),
        (&made, "on screen", Choices { interpolation: Interpolation::Screen, ..Choices::default() }, true),
        // Spheres are quads but for their poles, and only meshes of nothing but triangles are shared.
        (&shapes, "shapes", Choices { tolerance: 0.02, ..Choices::default() }, false),
        (&colored, "colors", Choices::default(), true),
        (&colored, "colors, phong", phong, true),
        (&made, "relight", Choices { clip_light: ClipLight::Relight, ..Choices::default() }, false),
        (&made, "SIPP's flat", Choices { shading: Shading::Flat, flat: FlatRule::Sipp, ..Choices::default() }, false),
        (&made, "wire", Choices { shading: Shading::Wire, ..Choices::default() }, false),
        (&made, "f64", Choices { depth: DepthFormat::F64, ..Choices::default() }, false),
        (&made, "finer grid", Choices { subpixel_bits: 9, ..Choices::default() }, false),
    ];
    let (mut stage, mut list) = (Stage::sharing(true), DrawList::new(0, 0));
    for (scene, name, choices, shares) in all {
        for threads in [1, 3] {
            let plan = plan(scene, &choices, threads);
            let known = of(scene, &plan);
            let counts = stage.run(scene, &plan, &mut list);
            assert_eq!(list.shared.is_empty(), !shares, "{name}");
            let mut room = Whole::default();
            for index in (0..known.0.len()).step_by(7) {
                let (one, other) = (list.polygon_in(index, &mut room), known.0.polygon(index));
                assert_eq!(
                    (one.vertices(), one.depth_plane()),
                    (other.vertices(), other.depth_plane()),
                    "{name}: {index}"
                );
                assert_eq!(one.varying_planes(), other.varying_planes(), "{name}: {index}");
                assert_eq!((one.vertex_values(2), one.surface()), (other.vertex_values(2), other.surface()), "{name}");
            }
            // A list that could share and does not is ready to: that is no part of what it draws.
            let whole = DrawList { shared: Shared::default(), ..list.whole().clone() };
            assert_same(&known, &(whole, counts), &format!("{name}, {threads} threads"));
        }
    }
}

/// Triangles with a color at every vertex.
fn colored_flake() -> Scene {
    let mut triangles = farop::spd::bench::triangles("flake:10k").expect("it is built in");
    let count = triangles.colors.len();
    for (number, color) in triangles.colors.iter_mut().enumerate() {
        color[number % 3] = number as f32 / count as f32;
    }
    farop::parse::scene_of_triangles("colors", &triangles).expect("a camera").scene
}
