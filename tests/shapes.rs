//! The shapes of SIPP through the whole pipeline: counts, resolutions, mirrors, flat transforms, conversion.

mod support;

use farop::geometry::flatten;
use farop::image::Image;
use farop::math::{Affine3, Vec3};
use farop::parse::{ParseOptions, read_nff};
use farop::plan::{Accepts, Choices, Culling, NeedsMode, Plan, Shading};
use farop::raster::{PerPolygon, Rasterizer, Wire, ZBuffer};
use farop::render::{Rendered, render};
use farop::scene::{
    Camera, CurveNet, Material, Mesh, NormalSource, Object, ObjectId, PatchNet, Place, Primitive, Scene, Shape,
    Surface, SurfaceId, TeapotPart,
};
use farop::write::write_nff;
use std::sync::Arc;
use support::scenes::{scene, surface};

const SHADINGS: [Shading; 4] = [Shading::Flat, Shading::Gouraud, Shading::Phong, Shading::Wire];

/// A camera that looks at the origin from `from`, z up.
fn camera(from: Vec3) -> Camera {
    let (at, up, place) = (Vec3::ZERO, Vec3::Z, Place::default());
    Camera { from, at, up, angle: 30.0, hither: 0.1, yon: None, resolution: (96, 96), place }
}

fn of_shape(shape: Shape, resolution: Option<u32>) -> Surface {
    let primitive = Primitive { resolution: resolution.map(|n| [n, n]), ..Primitive::new(shape, 0, 1) };
    let material = Material { specular: 0.3, shine: 20.0, ..Material::default() };
    Surface { primitives: vec![primitive], ..surface(material, Mesh::default()) }
}

/// One shape under a transform, lit from the camera's side.
fn one(shape: Shape, resolution: Option<u32>, world_from_local: Affine3, from: Vec3) -> Scene {
    let mut scene = scene(camera(from), vec![of_shape(shape, resolution)]);
    scene.objects[0].parent_from_local = world_from_local;
    scene.lights = vec![farop::scene::Light::point(from + Vec3::Z, farop::color::Rgb::WHITE, Place::default())];
    scene
}

/// A patch that is nowhere flat.
fn saddle() -> Shape {
    let at = |i: usize| (i as f64 - 1.5) / 1.5;
    let vertices = (0..16).map(|i| Vec3::new(at(i % 4), at(i / 4), at(i % 4) * at(i / 4) * 0.5)).collect();
    Shape::Patches(Arc::new(PatchNet { vertices, patches: vec![std::array::from_fn(|i| i as u32)] }))
}

fn bell() -> Shape {
    let vertices = [(1.0, -0.8), (0.6, -0.6), (0.5, 0.9), (0.0, 0.9)].map(|(x, z)| Vec3::new(x, 0.0, z)).to_vec();
    Shape::Curves(Arc::new(CurveNet { vertices, curves: vec![[0, 1, 2, 3]] }))
}

fn star() -> Shape {
    let corner = |i: u32| {
        let (angle, radius) =
            (f64::from(i) / 10.0 * std::f64::consts::TAU, if i.is_multiple_of(2) { 1.0 } else { 0.4 });
        [radius * angle.cos(), radius * angle.sin()]
    };
    Shape::Prism { outline: (0..10).map(corner).collect::<Vec<_>>().into(), height: 0.7 }
}

/// Every shape, its size about 1.
fn all() -> Vec<Shape> {
    vec![
        Shape::Ellipsoid { radii: Vec3::new(1.0, 0.6, 0.4) },
        Shape::CappedCone { bottom_radius: 0.8, top_radius: 0.3, length: 1.5 },
        Shape::CappedCone { bottom_radius: 0.8, top_radius: 0.0, length: 1.5 },
        Shape::Block { size: Vec3::new(1.0, 1.3, 0.6) },
        star(),
        Shape::Torus { ring_radius: 0.8, tube_radius: 0.25 },
        saddle(),
        bell(),
        Shape::Teapot(TeapotPart::Whole),
    ]
}

/// All shapes side by side; one in three is seen from inside, one in two has a resolution of its own, some are mirrored.
fn side_by_side() -> Scene {
    let mut whole = scene(camera(Vec3::new(3.0, -14.0, 7.0)), Vec::new());
    whole.objects.clear();
    whole.world.clear();
    for (number, shape) in all().into_iter().enumerate() {
        let mut surface = of_shape(shape, (number % 2 == 0).then_some(6));
        surface.primitives[0].inside = number % 3 == 2;
        let place = Vec3::new((number % 3) as f64 - 1.0, (number / 3) as f64 - 1.0, 0.0) * 2.2;
        let squeeze = Vec3::new(1.0, 0.8, if number % 4 == 1 { -1.0 } else { 1.0 });
        let turn = Affine3::from_rotation_x(number as f64) * Affine3::from_scale(squeeze);
        whole.objects.push(Object {
            name: String::new(),
            parent_from_local: Affine3::from_translation(place) * turn,
            surfaces: vec![SurfaceId(number as u32)],
            children: Vec::new(),
            place: Place::default(),
        });
        whole.world.push(ObjectId(number as u32));
        whole.surfaces.push(surface);
    }
    whole
}

fn draw(scene: &Scene, choices: &Choices) -> Rendered {
    let rasterizer: &dyn Rasterizer = if choices.shading == Shading::Wire { &PerPolygon(Wire) } else { &ZBuffer };
    render(scene, choices, Some(rasterizer)).unwrap_or_else(|error| panic!("{error}"))
}

fn unlike(a: &Image, b: &Image, above: f32) -> usize {
    let channels = |p: &farop::color::Rgb<f32>| [p.r, p.g, p.b];
    let differ = |(a, b): (&_, &_)| channels(a).iter().zip(channels(b)).any(|(a, b)| (a - b).abs() > above);
    a.pixels().iter().zip(b.pixels()).filter(|&(a, b)| differ((a, b))).count()
}

#[test]
fn a_converted_scene_gives_the_same_picture_byte_for_byte() {
    let scene = side_by_side();
    for shading in SHADINGS {
        for triangles in [false, true] {
            let choices = Choices { shading, triangles, ..Choices::default() };
            let plan = Plan::new(&scene, &choices, Accepts::AnyPolygon).expect("has a view");
            let mut text = Vec::new();
            let lost = write_nff(&flatten(&scene, &plan, false), &mut text).expect("memory takes it");
            assert!(lost.iter().all(|notice| notice.starts_with("objects moved")), "{lost:?}");
            let read = read_nff("flat", &text, ParseOptions::default()).unwrap_or_else(|errors| panic!("{errors}"));
            let (shapes, polygons) = (draw(&scene, &choices), draw(&read.scene, &choices));
            assert_eq!(shapes.image, polygons.image, "{shading:?} {triangles}");
            assert!(shapes.puts.puts > 500);
            let counts = &shapes.counts;
            assert_eq!(polygons.counts.polygons, counts.tessellated.polygons + counts.nonplanar);
        }
    }
}

#[test]
fn what_is_not_needed_changes_no_byte() {
    // From among them: some shapes are behind the eye, some are cut.
    let mut scene = side_by_side();
    scene.camera = Some(Camera { angle: 60.0, ..camera(Vec3::new(0.5, -1.2, 0.6)) });
    for shading in SHADINGS {
        let picture = |needs| draw(&scene, &Choices { shading, needs, ..Choices::default() });
        let (derived, full) = (picture(NeedsMode::Derived), picture(NeedsMode::Full));
        assert_eq!(derived.image, full.image, "{shading:?}");
        assert!(derived.counts.work.shapes_outside > 0 && full.counts.work.shapes_outside == 0);
        assert!(full.counts.tessellated.clipped > derived.counts.tessellated.clipped);
    }
}

#[test]
fn quads_that_are_not_planar_count_once() {
    for (shape, polygons, cut) in [
        (saddle(), 64, 64),
        (bell(), 8 * 32, 0),
        (Shape::Torus { ring_radius: 1.0, tube_radius: 0.3 }, 64, 0),
        (Shape::Teapot(TeapotPart::Body), 12 * 64, 0),
        (Shape::Teapot(TeapotPart::Whole), 28 * 64, 8 * 64),
    ] {
        for culling in [Culling::Back, Culling::None] {
            let scene = one(shape.clone(), Some(8), Affine3::IDENTITY, Vec3::new(3.0, -5.0, 2.0));
            let counts = draw(&scene, &Choices { culling, ..Choices::default() }).counts;
            let made = counts.tessellated;
            assert_eq!((made.polygons, counts.polygons), (polygons, 0), "{shape:?}");
            assert!(counts.nonplanar <= cut && counts.nonplanar >= cut * 9 / 10, "{shape:?}: {}", counts.nonplanar);
            let handled = made.backfacing + made.clipped + made.rendered + counts.skipped;
            assert_eq!(made.polygons + counts.nonplanar, handled, "{shape:?}");
        }
    }
}

#[test]
fn the_files_resolution_wins_then_the_users_then_the_tolerance() {
    let ellipsoid = || Shape::Ellipsoid { radii: Vec3::new(1.0, 0.6, 0.4) };
    let made = |resolution, choices: &Choices| {
        let scene = one(ellipsoid(), resolution, Affine3::IDENTITY, Vec3::new(0.0, -6.0, 1.0));
        draw(&scene, choices).counts.tessellated.polygons
    };
    let by_user = Choices { resolution: Some(10), ..Choices::default() };
    assert_eq!((made(Some(6), &by_user), made(None, &by_user)), (18, 50));
    assert_eq!(made(Some(6), &Choices::default()), 18);
    let tolerances = [1.0, 0.25, 0.0625].map(|tolerance| made(None, &Choices { tolerance, ..Choices::default() }));
    assert!(
        tolerances[0] > 18 && tolerances[1] > 2 * tolerances[0] && tolerances[2] > 2 * tolerances[1],
        "{tolerances:?}"
    );
    // Two numbers for a torus.
    let mut scene =
        one(Shape::Torus { ring_radius: 0.8, tube_radius: 0.2 }, None, Affine3::IDENTITY, Vec3::new(0.0, -6.0, 1.0));
    scene.surfaces[0].primitives[0].resolution = Some([20, 7]);
    assert_eq!(draw(&scene, &by_user).counts.tessellated.polygons, 140);
}

#[test]
fn from_outside_no_back_is_seen_mirrored_or_not() {
    let maps = [
        Affine3::IDENTITY,
        Affine3::from_scale(Vec3::new(1.0, 1.0, -1.0)),
        Affine3::from_scale(Vec3::new(-1.0, 1.2, 0.7)),
        Affine3::from_rotation_y(0.4)
            * Affine3::from_scale(Vec3::new(-1.0, -0.8, -0.9))
            * Affine3::from_rotation_z(2.0),
    ];
    // The saddle is a sheet and the bell has no bottom; the teapot is looked at from where its foot does not show.
    let closed = all().into_iter().filter(|shape| !matches!(shape, Shape::Patches(_) | Shape::Curves(_)));
    for shape in closed {
        for map in maps {
            for from in [Vec3::new(4.0, -3.0, 2.5), Vec3::new(-5.0, 0.5, 2.0), Vec3::new(0.3, 5.0, 3.0)] {
                // Above the shape as its own space has it.
                let above = if shape == Shape::Teapot(TeapotPart::Whole) { map.transform_vector3(from) } else { from };
                let scene = one(shape.clone(), Some(16), map, above);
                let picture = |culling| draw(&scene, &Choices { culling, ..Choices::default() });
                let (culled, whole) = (picture(Culling::Back), picture(Culling::None));
                let seen = unlike(&culled.image, &whole.image, 1e-3);
                // Rounding at silhouettes; and one sees into the mouth of the spout.
                let limit = if shape == Shape::Teapot(TeapotPart::Whole) { 30 } else { 6 };
                assert!(seen <= limit, "{shape:?} {map:?} from {from}: {seen} pixels of backs");
                let made = culled.counts.tessellated;
                assert!(culled.puts.puts > 100 && made.backfacing > 0 && made.rendered > 0, "{shape:?}");
            }
        }
    }
}

#[test]
fn a_mirror_moves_the_picture_and_two_mirrors_move_nothing() {
    let mirror = Affine3::from_scale(Vec3::new(1.0, -1.0, 1.0));
    let from = Vec3::new(5.0, 0.0, 2.0);
    for shading in [Shading::Flat, Shading::Gouraud, Shading::Phong] {
        let choices = Choices { shading, ..Choices::default() };
        // The teapot is its own mirror image: only its first corners, and cuts of quads, change sides.
        let plain = draw(&one(Shape::Teapot(TeapotPart::Whole), Some(12), Affine3::IDENTITY, from), &choices);
        let mirrored = draw(&one(Shape::Teapot(TeapotPart::Whole), Some(12), mirror, from), &choices);
        let differ = unlike(&plain.image, &mirrored.image, 0.05);
        let limit = if shading == Shading::Flat { 300 } else { 60 };
        assert!(differ < limit, "{shading:?}: {differ} of {}", plain.puts.puts);

        let mut nested = one(saddle(), Some(5), mirror, from);
        let inner = Object { parent_from_local: mirror, ..nested.objects[0].clone() };
        nested.objects[0].surfaces.clear();
        nested.objects[0].children = vec![ObjectId(1)];
        nested.objects.push(inner);
        assert_eq!(
            draw(&nested, &choices).image,
            draw(&one(saddle(), Some(5), Affine3::IDENTITY, from), &choices).image
        );
    }
}

#[test]
fn normals_stay_square_to_a_squeezed_surface() {
    // A flattened sphere and the ellipsoid it becomes, lit alike: the inverse transpose, not the matrix itself.
    let radii = Vec3::new(1.0, 0.9, 0.3);
    let from = Vec3::new(3.0, -4.0, 3.0);
    let squeezed = one(Shape::Sphere { center: Vec3::ZERO, radius: 1.0 }, Some(24), Affine3::from_scale(radii), from);
    let ellipsoid = one(Shape::Ellipsoid { radii }, Some(24), Affine3::IDENTITY, from);
    let [a, b] = [squeezed, ellipsoid].map(|scene| draw(&scene, &Choices::default()).image);
    assert_eq!(unlike(&a, &b, 1e-5), 0);
}

#[test]
fn a_flat_transform_skips_and_counts() {
    let flat =
        Affine3::from_rotation_z(0.3) * Affine3::from_scale(Vec3::new(1.0, 1.0, 0.0)) * Affine3::from_rotation_x(1.0);
    for map in [flat, Affine3::from_scale(Vec3::ZERO), Affine3::from_translation(Vec3::NAN)] {
        let mut scene =
            one(Shape::Torus { ring_radius: 1.0, tube_radius: 0.3 }, Some(8), map, Vec3::new(3.0, -5.0, 2.0));
        let mesh = &mut scene.surfaces[0].mesh;
        let corners = [Vec3::ZERO, Vec3::X, Vec3::Y].map(|corner| mesh.push_vertex(corner));
        mesh.push_polygon(&corners, NormalSource::Facet, 1);
        for culling in [Culling::Back, Culling::None] {
            let rendered = draw(&scene, &Choices { culling, ..Choices::default() });
            let counts = rendered.counts;
            assert_eq!((counts.skipped, counts.polygons, counts.tessellated.polygons), (2, 1, 0), "{map:?}");
            assert_eq!((rendered.puts.puts, rendered.list.len()), (0, 0));
        }
    }
}
