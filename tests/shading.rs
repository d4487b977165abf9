//! Depth and color of every sample against rays from the eye: plane, weights and light computed by another way.

mod support;

use farop::color::Encoding;
use farop::math::Vec3;
use farop::plan::{Choices, Culling, DepthFormat, Shading};
use farop::scene::{Material, NormalSource, Scene};
use farop::screen::{DrawList, ScreenPolygon};
use support::mixed::{Mix, light, meet, mix, weights};
use support::scenes::{run, world};

const SIDE: u32 = 96;

/// Error of depth in f32, as a share of the largest 1/w its plane has in the block: the rounding of the anchor, of the
/// two slopes, their products and the sums, 2^-24 each.
const DEPTH: f64 = 3e-7;
/// The required relative error. It may be missed where a steep polygon covers the far corner of a block: its anchor
/// then lies outside the polygon and is much larger than its depths.
const RELATIVE: f64 = 1e-6;
/// Error of a color, in 8-bit levels. The requirement is half a level.
const LEVEL: f64 = 0.01;

fn choices(shading: Shading) -> Choices {
    Choices { shading, culling: Culling::None, encoding: Encoding::Linear, ..Choices::default() }
}

/// The file's polygon that a screen polygon comes from: material, corners and normals towards the eye, eye space.
fn source<'a>(scene: &'a Scene, polygon: &ScreenPolygon<'_>) -> (&'a Material, Vec<Vec3>, Vec<Vec3>) {
    let surface = &scene.surfaces[polygon.surface() as usize];
    let of_mesh = &surface.mesh.polygons[polygon.record().source.number as usize];
    let outline = surface.mesh.outline(of_mesh);
    let corners: Vec<Vec3> = outline.iter().map(|&i| world(surface.mesh.vertices[i as usize])).collect();
    let face = newell(&corners).normalize();
    let is_front = face.dot(corners[0]) > 0.0;
    let towards_eye = if is_front { -face } else { face };
    let normal = |&i: &u32| match (of_mesh.normals, is_front) {
        (NormalSource::Given, true) => world(surface.mesh.normals[i as usize]),
        (NormalSource::Given, false) => -world(surface.mesh.normals[i as usize]),
        _ => towards_eye,
    };
    let normals = outline.iter().map(normal).collect();
    (&surface.material, corners, normals)
}

/// Calls `check` with every sample that `list` covers and whose center lies within the true triangle.
fn for_samples(
    scene: &Scene,
    list: &DrawList,
    mut check: impl FnMut(&ScreenPolygon<'_>, (i32, i32), Sample<'_>),
) -> u32 {
    let mut samples = 0;
    for polygon in list.polygons() {
        let (material, corners, normals) = source(scene, &polygon);
        let mut spans = farop::raster::coverage::Spans::default();
        spans.of(polygon.vertices(), list.grid, 0..SIDE as i32, |y, columns| {
            for x in columns {
                let plane = [corners[0], corners[1], corners[2]];
                let point = meet(plane, (x, y), SIDE);
                let weights = weights(plane, point);
                if corners.len() > 3 || weights.iter().all(|&weight| weight >= 0.0) {
                    let normals = [normals[0], normals[1], normals[2]];
                    samples += 1;
                    check(&polygon, (x, y), Sample { material, corners: plane, normals, point, weights });
                }
            }
        });
    }
    samples
}

/// What a ray meets.
struct Sample<'a> {
    material: &'a Material,
    corners: [Vec3; 3],
    normals: [Vec3; 3],
    point: Vec3,
    weights: [f64; 3],
}

/// The largest difference of two colors, in levels.
fn levels(a: farop::color::Rgb<f32>, b: Vec3) -> f64 {
    let a = a.to_f64();
    (Vec3::new(a.r, a.g, a.b) - b).abs().max_element() * 255.0
}

#[test]
fn depth_is_where_the_ray_meets_the_plane() {
    let mix = Mix { corners: (3, 7), distance: (0.5, 20.0), polygons: 80, spread: 1.0, ..Mix::default() };
    let scene = mix.scene(SIDE);
    for (depth, tolerance) in [(DepthFormat::F32, DEPTH), (DepthFormat::F64, 1e-14)] {
        let (list, counts, _) = run(&scene, &Choices { depth, ..choices(Shading::Flat) });
        assert!(counts.cut > 10);
        let (mut held, mut coarse, mut worst) = (0, 0, 0.0_f64);
        let samples = for_samples(&scene, &list, |polygon, (x, y), sample| {
            let plane = polygon.depth_plane().expect("has depth");
            let exact = sample.point.z.recip();
            // Where snapping moved an edge over the sample, depth is held at the nearest or farthest corner.
            if exact > plane.high || exact < plane.low {
                held += 1;
                return;
            }
            let error = (polygon.depth(x, y) - exact).abs();
            let corners = [(0, 0), (15, 0), (0, 15), (15, 15)];
            let at =
                |(dx, dy): (i32, i32)| meet(sample.corners, ((x & !15) + dx, (y & !15) + dy), SIDE).z.recip().abs();
            worst = worst.max(error / corners.map(at).into_iter().fold(0.0, f64::max));
            coarse += u32::from(error > RELATIVE * exact);
        });
        assert!(worst < tolerance, "{depth:?}: {worst:e} in {samples} samples");
        assert!(coarse * 1000 < samples, "{coarse} of {samples} are off by more than {RELATIVE}");
        assert!(samples > 20_000 && held < samples / 100, "{held} of {samples} held");
    }
}

#[test]
fn gouraud_colors_are_linear_on_the_triangle_in_space() {
    let scene = Mix { distance: (0.5, 9.0), polygons: 80, spread: 1.0, ..Mix::default() }.scene(SIDE);
    let (list, counts, _) = run(&scene, &choices(Shading::Gouraud));
    assert!(counts.cut > 10);
    let samples = for_samples(&scene, &list, |polygon, (x, y), sample| {
        let lit = [0, 1, 2].map(|i| light(&scene, sample.material, sample.corners[i], sample.normals[i]));
        let color = list.shader.fragment(polygon, x, y).color;
        let error = levels(color, mix(lit, sample.weights));
        assert!(error < LEVEL, "({x}, {y}): {error} levels");
    });
    assert!(samples > 10_000, "{samples}");
}

#[test]
fn phong_light_is_computed_at_the_sample() {
    let scene = Mix { distance: (0.5, 9.0), polygons: 80, spread: 1.0, ..Mix::default() }.scene(SIDE);
    let (list, ..) = run(&scene, &choices(Shading::Phong));
    let mut bright = 0;
    let samples = for_samples(&scene, &list, |polygon, (x, y), sample| {
        let normal = mix(sample.normals, sample.weights).normalize();
        let expected = light(&scene, sample.material, sample.point, normal);
        let error = levels(list.shader.fragment(polygon, x, y).color, expected);
        assert!(error < LEVEL, "({x}, {y}): {error} levels");
        bright += u32::from(expected.max_element() > 0.5);
    });
    assert!(samples > 10_000 && bright > 500, "{samples}, {bright} bright");
}

#[test]
fn flat_color_is_the_light_at_the_first_vertex() {
    let scene = Mix { corners: (3, 7), distance: (0.5, 9.0), polygons: 80, spread: 1.0, ..Mix::default() }.scene(SIDE);
    for triangles in [false, true] {
        let (list, counts, _) = run(&scene, &Choices { triangles, ..choices(Shading::Flat) });
        assert!(counts.cut > 10);
        for polygon in list.polygons() {
            let (material, corners, _) = source(&scene, &polygon);
            // The face's normal, whatever normals the file gives.
            let face = newell(&corners).normalize();
            let towards_eye = if face.dot(corners[0]) > 0.0 { -face } else { face };
            let expected = light(&scene, material, corners[0], towards_eye);
            let colors: Vec<_> =
                [(0, 0), (40, 40), (95, 3)].map(|(x, y)| list.shader.fragment(&polygon, x, y).color).to_vec();
            assert!(colors.iter().all(|&color| color == colors[0]), "one color");
            assert!(levels(colors[0], expected) < LEVEL, "{:?} {expected}", colors[0]);
        }
    }
}

/// Not unit; right for outlines with a reflex second corner, too.
fn newell(corners: &[Vec3]) -> Vec3 {
    (2..corners.len()).map(|i| (corners[i - 1] - corners[0]).cross(corners[i] - corners[0])).sum()
}
