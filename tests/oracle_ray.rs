//! The ray oracle: against cases by hand, the pipeline's pictures against it, and outlines of spheres and cones.

mod support;

use farop::color::Rgb;
use farop::image::Image;
use farop::math::{Affine3, Mat3, Vec3};
use farop::oracle::Vertices;
use farop::oracle::exact::{Rules, judge};
use farop::oracle::ray::silhouette::{Polygons, deviation, traced};
use farop::oracle::ray::{Hit, Part, RayError, RayPicture, Tracer, trace};
use farop::plan::{AngleSpan, Choices, Culling, Shading};
use farop::raster::ZBuffer;
use farop::render::render;
use farop::scene::{Material, Mesh, Primitive, Scene, Shape};
use farop::spd::{Curves, SMALL};
use support::built_in::built_in;
use support::owners::numbered;
use support::random::Random;
use support::scenes::{camera, run, scene, surface};

/// A scene of one shape, seen from the origin along -z with 90 degrees.
fn of_shape(shape: Shape, inside: bool, side: u32) -> Scene {
    let mut one = surface(Material { diffuse: 1.0, ..Material::default() }, Mesh::default());
    one.primitives.push(Primitive { inside, ..Primitive::new(shape, 0, 1) });
    scene(camera(side, side), vec![one])
}

fn sphere(z: f64, radius: f64) -> Shape {
    Shape::Sphere { center: Vec3::new(0.0, 0.0, -z), radius }
}

#[test]
fn depth_and_facing_by_hand() {
    let choices = Choices::default();
    let hit = |shape: Shape, inside: bool, choices: &Choices| {
        let scene = of_shape(shape, inside, 16);
        Tracer::new(&scene, choices)
            .expect("a fine scene")
            .hit(8.0, 8.0)
            .map(|hit: Hit| (hit.depth, hit.back, hit.normal))
    };
    // The front of a sphere, then of one whose inside is visible: its far wall, lit on the near side.
    assert_eq!(hit(sphere(10.0, 4.0), false, &choices), Some((6.0, false, Vec3::Z)));
    assert_eq!(hit(sphere(10.0, 4.0), true, &choices), Some((14.0, false, Vec3::Z)));
    // Around the eye: hither cuts nothing away, the outside faces away, unless both sides count.
    assert_eq!(hit(sphere(0.0, 4.0), false, &choices), None);
    let both = Choices { culling: Culling::None, ..Choices::default() };
    assert_eq!(hit(sphere(0.0, 4.0), false, &both), Some((4.0, true, Vec3::Z)));
    // Hither, at 1, cuts the front away: the back shows only where it may.
    assert_eq!(hit(sphere(2.0, 1.5), false, &choices), None);
    assert_eq!(hit(sphere(2.0, 1.5), false, &both), Some((3.5, true, Vec3::Z)));
    assert_eq!(hit(sphere(2.0, 1.5), true, &choices), Some((3.5, false, Vec3::Z)));
}

#[test]
fn the_outline_of_a_sphere_is_where_geometry_says() {
    // Radius 5 at distance 13: the cone of tangents has the tangent 5 / 12.
    let scene = of_shape(sphere(13.0, 5.0), false, 96);
    for (angle, samples) in [(AngleSpan::Edges, 1), (AngleSpan::Edges, 2), (AngleSpan::Centers, 2)] {
        let choices = Choices { angle, samples, ..Choices::default() };
        let tracer = Tracer::new(&scene, &choices).expect("a fine scene");
        let span = if angle == AngleSpan::Edges { 96.0 } else { 95.0 };
        let (middle, radius) = (48.0 * f64::from(samples), span / 2.0 * f64::from(samples) * 5.0 / 12.0);
        let circle = |x: f64, y: f64| (x - middle).hypot(y - middle) < radius;
        let found = deviation(&traced(&tracer, |_| true), &circle, tracer.size(), 2.0);
        assert!(found.largest < 1e-2 && found.mean < 5e-3 && found.points > 200, "{angle:?}: {found:?}");
        // Along one row, to the last digits.
        assert!(tracer.hit(middle + radius - 1e-9, middle).is_some());
        assert!(tracer.hit(middle + radius + 1e-9, middle).is_none());
    }
}

#[test]
fn a_transform_of_the_object_is_one_of_the_shape() {
    // A unit sphere, stretched, mirrored and moved, is the ellipsoid moved: same hits, same normals.
    let matrix = Mat3::from_diagonal(Vec3::new(-3.0, 1.0, 2.0));
    let to = Vec3::new(0.5, 0.25, -8.0);
    let mut moved = of_shape(Shape::Sphere { center: Vec3::ZERO, radius: 1.0 }, false, 48);
    moved.objects[0].parent_from_local = Affine3::from_mat3_translation(matrix, to);
    let mut plain = of_shape(Shape::Ellipsoid { radii: Vec3::new(3.0, 1.0, 2.0) }, false, 48);
    plain.objects[0].parent_from_local = Affine3::from_translation(to);
    let (a, b) = (picture(&moved, &Choices::default()), picture(&plain, &Choices::default()));
    let mut hits = 0;
    for (a, b) in a.hits.iter().zip(&b.hits).filter(|(a, b)| a.is_some() || b.is_some()) {
        let (a, b) = (a.expect("hit"), b.expect("hit"));
        assert!((a.depth - b.depth).abs() < 1e-12 && (a.normal - b.normal).length() < 1e-12);
        hits += 1;
    }
    assert!(hits > 60, "{hits}");
}

#[test]
fn shapes_without_equation_are_refused_by_name() {
    let torus = of_shape(Shape::Torus { ring_radius: 2.0, tube_radius: 1.0 }, false, 8);
    let error = trace(&torus, &Choices::default()).expect_err("no equation");
    assert!(matches!(error, RayError::NotAnalytic { shape: "torus", .. }), "{error}");
}

fn picture(scene: &Scene, choices: &Choices) -> RayPicture {
    trace(scene, choices).unwrap_or_else(|error| panic!("{error}"))
}

/// Samples whose color differs by more than `level` of light, and those of them that are not next to an outline.
fn differing(drawn: &Image, truth: &RayPicture, level: f32) -> (usize, Vec<(usize, usize)>) {
    let (width, height) = (truth.width as usize, truth.height as usize);
    let apart = |a: Rgb<f32>, b: Rgb<f32>| (a.r - b.r).abs().max((a.g - b.g).abs()).max((a.b - b.b).abs());
    let light = |x: usize, y: usize| truth.light[y * width + x].to_f32().map(|c| c.min(1.0));
    let part = |x: usize, y: usize| {
        truth.hits[y * width + x].map(|hit| match hit.part {
            Part::Polygon(_) => (hit.instance, hit.surface.0, None),
            Part::Primitive(number) => (hit.instance, hit.surface.0, Some(number)),
        })
    };
    // An outline: another object beside it, or the same one at quite another depth or with quite another light.
    let is_outline = |x: usize, y: usize| {
        let depth = |x: usize, y: usize| truth.hits[y * width + x].map_or(f64::INFINITY, |hit| hit.depth);
        let around =
            (y.max(1) - 1..(y + 2).min(height)).flat_map(|y| (x.max(1) - 1..(x + 2).min(width)).map(move |x| (x, y)));
        around.into_iter().any(|(u, v)| {
            part(u, v) != part(x, y)
                || apart(light(u, v), light(x, y)) > level
                || (depth(u, v) / depth(x, y) - 1.0).abs() > 0.05
        })
    };
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let other: Vec<_> =
        places.filter(|&(x, y)| apart(drawn.pixel(x, y).map(|c| c.min(1.0)), light(x, y)) > level).collect();
    (other.len(), other.into_iter().filter(|&(x, y)| !is_outline(x, y)).collect())
}

/// Light that tessellation to 1/16 pixel and Phong's interpolated normals may be off.
const LEVEL: f32 = 0.02;

#[test]
fn built_in_scenes_differ_only_at_outlines() {
    for (name, size) in SMALL {
        let scene = built_in(name, size, Curves::Kept);
        for culling in [Culling::Back, Culling::Nff] {
            let choices = Choices {
                size: Some((96, 80)),
                shading: Shading::Phong,
                tolerance: 1.0 / 16.0,
                culling,
                ..Choices::default()
            };
            let drawn = render(&scene, &choices, Some(&ZBuffer)).unwrap_or_else(|error| panic!("{error}"));
            let truth = picture(&scene, &choices);
            let hits = truth.hits.iter().flatten().count();
            let (other, wrong) = differing(&drawn.image, &truth, LEVEL);
            println!("{name}, {}: {hits} hits, {other} differ, {} not at an outline", culling.name(), wrong.len());
            assert!(hits > 100 && wrong.is_empty(), "{name}: {wrong:?}");
            assert!(other * 25 < 96 * 80, "{name}: {other}");
        }
    }
}

/// The shapes of the silhouette test: spheres and cones, some close, at all angles.
fn shapes(random: &mut Random) -> Vec<Shape> {
    let mut shapes = Vec::new();
    for _ in 0..6 {
        let distance = random.between(3.0, 12.0);
        let center = Vec3::new(random.between(-0.5, 0.5), random.between(-0.5, 0.5), -1.0) * distance;
        shapes.push(Shape::Sphere { center, radius: random.between(0.05, 0.25) * distance });
        let axis = Vec3::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0));
        let radius = random.between(0.05, 0.2) * distance;
        let apex_radius = if random.one_in(3) { 0.0 } else { random.between(0.3, 1.0) * radius };
        shapes.push(Shape::Cone {
            base: center,
            base_radius: radius,
            apex: center + axis * 0.3 * distance,
            apex_radius,
        });
    }
    shapes
}

#[test]
fn tessellated_outlines_are_within_the_tolerance() {
    let mut random = Random::new(21);
    for tolerance in [1.0, 0.25, 1.0 / 16.0] {
        let (mut worst, mut least, mut points) = (0.0_f64, f64::INFINITY, 0);
        for shape in shapes(&mut random) {
            let scene = of_shape(shape, false, 96);
            let choices = Choices { culling: Culling::None, tolerance, ..Choices::default() };
            let (list, _, _) = run(&scene, &choices);
            let tracer = Tracer::new(&scene, &choices).expect("analytic");
            let polygons = Polygons::new(&list, Vertices::Raw, |_| true);
            let found = deviation(&traced(&tracer, |_| true), &polygons, tracer.size(), 4.0);
            // The search meets an outline up to 1 % too late.
            assert!(found.largest <= tolerance * 1.01 + 1e-3, "{:?}: {found:?}", scene.surfaces[0].primitives[0].shape);
            worst = worst.max(found.largest);
            least = least.min(found.largest);
            points += found.points;
        }
        println!("tolerance {tolerance}: {least:.4} to {worst:.4}, {points} points");
        // The oracle sees the facets: no outline of a polygon is a circle.
        assert!(worst > tolerance * 0.3, "{worst}");
    }
}

#[test]
fn rays_and_determinants_agree_about_every_polygon() {
    for (name, size) in [("gears", 2), ("mount", 4), ("nurbtst", 1), ("sombrero", 1), ("teapot", 4), ("tetra", 4)] {
        let scene = built_in(name, size, Curves::Kept);
        let choices = Choices { size: Some((150, 120)), ..Choices::default() };
        let truth = picture(&scene, &choices);
        // As if opaque: rays stop at what they meet first.
        let list = numbered(&run(&scene, &choices).0);
        let exact = judge(&list, &Rules::UNSNAPPED);
        let (mut same, mut other, mut disputed) = (0, 0, 0);
        for (index, (owner, hit)) in exact.owner.iter().zip(&truth.hits).enumerate() {
            let source = owner.map(|owner| list.polygons[owner as usize].source);
            // The polygons of spheres are no spheres: only what both see as a polygon is compared.
            match (source, hit.map(|hit| hit.part)) {
                (None, None) => same += 1,
                (Some(source), Some(Part::Polygon(number))) if !source.tessellated => {
                    let depth = list
                        .polygon(owner.expect("an owner") as usize)
                        .inverse_w((index % 150) as i32, (index / 150) as i32);
                    let far = hit.expect("a hit").depth * depth;
                    same += u32::from(source.number == number && (far - 1.0).abs() < 1e-5);
                    disputed += u32::from(source.number != number && exact.disputed[index]);
                    other += u32::from(source.number != number && !exact.disputed[index]);
                }
                (Some(source), Some(Part::Primitive(_))) if source.tessellated => (),
                _ => other += u32::from(name != "mount"),
            }
        }
        println!("{name}: {same} the same, {disputed} disputed, {other} other");
        assert!(same > 10_000 && other == 0, "{name}: {same} {other}");
    }
}
