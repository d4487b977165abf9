//! The geometry stage on scenes built by hand: what is dropped, what is cut, and where everything lands.

mod support;

use farop::math::{Affine3, Mat3, Vec3};
use farop::plan::{Choices, ClipPlane, Culling, NeedsMode, Shading};
use farop::raster::ZBuffer;
use farop::report::Counts;
use farop::scene::{Light, LightSource, Material, Scene};
use farop::screen::{DrawList, EdgeKind, ScreenVertex};
use support::draw;
use support::mixed::Mix;
use support::scenes::{camera, facets, run, scene, surface, world};

/// The outline of (x, y) at distance `w`.
fn at(w: f64, outline: &[(f64, f64)]) -> Vec<Vec3> {
    outline.iter().map(|&(x, y)| world(Vec3::new(x, y, w))).collect()
}

fn reversed(outline: &[Vec3]) -> Vec<Vec3> {
    outline.iter().rev().copied().collect()
}

fn one_surface(outlines: &[Vec<Vec3>], material: Material) -> Scene {
    scene(camera(64, 64), vec![surface(material, facets(outlines))])
}

#[test]
fn culling_drops_back_faces_and_counts_them() {
    let front = at(4.0, &[(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]);
    let back = reversed(&front);
    let edge_on = [(0.5, 2.0), (0.5, 4.0), (0.75, 6.0)].map(|(y, w)| world(Vec3::new(0.0, y, w))).to_vec();
    let far_back = reversed(&at(4.0, &[(9.0, 0.0), (10.0, 0.0), (9.0, 1.0)]));
    let outlines = [front, back, edge_on, far_back];
    let glass = Material { opacity: farop::color::Rgb::gray(0.5), ..Material::default() };
    let counts = |culling, material: Material| {
        let (list, counts, _) = run(&one_surface(&outlines, material), &Choices { culling, ..Choices::default() });
        assert_eq!(list.len() as u64, counts.rendered);
        assert_eq!(counts.polygons, counts.backfacing + counts.clipped + counts.rendered + counts.skipped);
        [counts.backfacing, counts.clipped, counts.rendered, counts.skipped]
    };
    assert_eq!(counts(Culling::Back, Material::default()), [3, 0, 1, 0]);
    assert_eq!(counts(Culling::Back, glass), [3, 0, 1, 0]);
    assert_eq!(counts(Culling::Nff, Material::default()), [3, 0, 1, 0]);
    // What is seen edge-on covers nothing; two-sided, it is skipped.
    assert_eq!(counts(Culling::Nff, glass), [0, 1, 2, 1]);
    assert_eq!(counts(Culling::None, Material::default()), [0, 1, 2, 1]);
}

#[test]
fn a_back_face_is_lit_from_the_side_that_is_seen() {
    let front = at(4.0, &[(-1.0, -1.0), (1.0, -1.0), (0.0, 1.0)]);
    for shading in [Shading::Flat, Shading::Gouraud, Shading::Phong] {
        let choices = Choices { culling: Culling::None, shading, ..Choices::default() };
        // The same first vertex, the other way round.
        let back = vec![front[0], front[2], front[1]];
        let [seen, turned] = [front.clone(), back].map(|outline| {
            let (list, ..) = run(&one_surface(&[outline], Material::default()), &choices);
            draw(&list, &ZBuffer).0
        });
        let same = seen.pixels().iter().zip(turned.pixels()).filter(|(a, b)| (a.r - b.r).abs() < 1e-6).count();
        assert_eq!(same, seen.pixels().len(), "{shading:?}");
        assert!(seen.pixels().iter().any(|pixel| pixel.r > 0.1));
    }
}

fn snapped(list: &DrawList) -> Vec<(i64, i64)> {
    list.vertices.iter().map(|v| (list.grid.fixed(v.x), list.grid.fixed(v.y))).collect()
}

/// The scene and its camera moved by `offset`.
fn moved(scene: &Scene, offset: Vec3) -> Scene {
    let mut scene = scene.clone();
    let vertices = scene.surfaces.iter_mut().flat_map(|surface| &mut surface.mesh.vertices);
    vertices.for_each(|vertex| *vertex += offset);
    scene.lights.iter_mut().for_each(|light| *position(light) += offset);
    if let Some(camera) = &mut scene.camera {
        camera.from += offset;
        camera.at += offset;
    }
    scene
}

/// Polygons in view and reaching over its sides, seen by a camera that looks along no axis.
fn tilted() -> Scene {
    let mix = Mix { corners: (3, 6), distance: (0.5, 9.0), polygons: 80, spread: 1.0, ..Mix::default() };
    let mut scene = mix.scene(256);
    if let Some(camera) = &mut scene.camera {
        camera.at = Vec3::new(0.125, -0.25, -1.0);
        camera.up = Vec3::new(0.25, 1.0, 0.125);
    }
    scene
}

#[test]
fn far_from_the_origin_everything_lands_within_a_step() {
    let choices = Choices { culling: Culling::None, shading: Shading::Flat, ..Choices::default() };
    let near = tilted();
    let far = moved(&near, Vec3::new(1e8, -1e8, 1e8));
    let ((near, near_counts, _), (far, far_counts, _)) = (run(&near, &choices), run(&far, &choices));
    assert_eq!(near_counts.rendered, far_counts.rendered);
    assert!(near_counts.cut > 10, "{}", near_counts.cut);
    let (near, far) = (snapped(&near), snapped(&far));
    assert_eq!(near.len(), far.len());
    let apart = near.iter().zip(&far).map(|(a, b)| (a.0 - b.0).abs().max((a.1 - b.1).abs()));
    assert!(apart.clone().max() <= Some(1), "{:?} steps", apart.max());
}

#[test]
fn what_can_be_written_down_far_away_changes_no_bit() {
    // On multiples of 2^-10 the scene can be moved by 2^40 without rounding: only the size of the numbers is new.
    let mut near = tilted();
    let vertices = near.surfaces.iter_mut().flat_map(|surface| &mut surface.mesh.vertices);
    vertices.chain(near.lights.iter_mut().map(position)).for_each(|v| *v = (*v * 1024.0).round() / 1024.0);
    let far = moved(&near, Vec3::new(1.0, -1.0, 1.0) * (1_u64 << 40) as f64);
    for shading in [Shading::Flat, Shading::Gouraud, Shading::Phong] {
        let choices = Choices { culling: Culling::None, shading, ..Choices::default() };
        let ((near, near_counts, _), (far, far_counts, _)) = (run(&near, &choices), run(&far, &choices));
        assert_eq!(near_counts, far_counts);
        assert!(near == far, "{shading:?}");
    }
}

#[test]
fn a_mirroring_transform_shows_what_the_mirrored_scene_shows() {
    let mix = Mix { corners: (3, 6), distance: (0.5, 9.0), polygons: 60, spread: 1.0, ..Mix::default() };
    let flip = |v: Vec3| Vec3::new(-v.x, v.y, v.z);
    let mut transformed = mix.scene(96);
    transformed.objects[0].parent_from_local = Affine3::from_mat3(Mat3::from_diagonal(Vec3::new(-1.0, 1.0, 1.0)));
    // By hand: every position and normal mirrored, every outline turned round, its first vertex kept.
    let mut by_hand = mix.scene(96);
    for surface in &mut by_hand.surfaces {
        let mesh = &mut surface.mesh;
        mesh.vertices.iter_mut().chain(&mut mesh.normals).for_each(|v| *v = flip(*v));
        for polygon in &mesh.polygons {
            let (first, end) = (polygon.start as usize + 1, (polygon.start + polygon.count) as usize);
            mesh.outlines[first..end].reverse();
        }
    }
    for shading in [Shading::Flat, Shading::Gouraud, Shading::Phong, Shading::Wire] {
        let choices = Choices { shading, ..Choices::default() };
        let ((a, a_counts, _), (b, b_counts, _)) = (run(&transformed, &choices), run(&by_hand, &choices));
        assert_eq!(a_counts, b_counts);
        assert!(a_counts.backfacing > 5 && a_counts.rendered > 5);
        assert_eq!(snapped(&a), snapped(&b));
        let close = |a: &[f64], b: &[f64]| a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-12);
        assert!(close(&a.values, &b.values), "{shading:?}");
    }
}

/// A quadrilateral that reaches over one plane, with two corners on each side of it; counterclockwise.
fn reaching_over(plane: ClipPlane) -> Vec<Vec3> {
    let flat = |low: (f64, f64), high: (f64, f64)| at(4.0, &[low, (high.0, low.1), high, (low.0, high.1)]);
    // A floor from distance `near` to `far`, one below the eye.
    let floor = |near: f64, far: f64| {
        let corner = |x: f64, w: f64| world(Vec3::new(x * near, -0.4, w));
        vec![corner(-0.5, near), corner(0.5, near), corner(0.5, far), corner(-0.5, far)]
    };
    match plane {
        ClipPlane::Left => flat((-6.0, -1.0), (-2.0, 1.0)),
        ClipPlane::Right => flat((2.0, -1.0), (6.0, 1.0)),
        ClipPlane::Bottom => flat((-1.0, -6.0), (1.0, -2.0)),
        ClipPlane::Top => flat((-1.0, 2.0), (1.0, 6.0)),
        ClipPlane::Hither => floor(0.5, 3.0),
        ClipPlane::Yon => floor(3.0, 12.0),
    }
}

#[test]
fn each_plane_cuts_what_reaches_over_it() {
    for plane in ClipPlane::ALL {
        let mut scene = one_surface(&[reaching_over(plane)], Material::default());
        if let Some(camera) = &mut scene.camera {
            camera.yon = Some(10.0);
        }
        let choices = Choices { shading: Shading::Flat, ..Choices::default() };
        let (list, counts, plan) = run(&scene, &choices);
        assert_eq!(plan.needs.clip, plane.bit(), "{plane:?}");
        let expected = Counts { cut: 1, inside: 0, clipped: 0, rendered: 1, triangles: 2, ..counts.clone() };
        assert_eq!(counts, expected, "{plane:?}");
        let on_plane = |vertex: &&ScreenVertex| match plane {
            ClipPlane::Left => vertex.x == 0.0,
            ClipPlane::Right => vertex.x == 64.0,
            ClipPlane::Bottom => vertex.y == 64.0,
            ClipPlane::Top => vertex.y == 0.0,
            ClipPlane::Hither => vertex.homogeneous.z == 1.0,
            ClipPlane::Yon => vertex.homogeneous.z == 10.0,
        };
        assert_eq!((list.vertices.len(), list.vertices.iter().filter(on_plane).count()), (4, 2), "{plane:?}");
        // The one edge between them was made by clipping.
        let cut: Vec<_> = (0..4).filter(|&i| list.vertices[i].edge == EdgeKind::Cut).collect();
        let ends = [list.vertices[cut[0]], list.vertices[(cut[0] + 1) % 4]];
        assert!(cut.len() == 1 && ends.iter().all(|vertex| on_plane(&vertex)), "{plane:?}");
        // Moved well inside, or well outside.
        let outside = match plane {
            ClipPlane::Left => Vec3::new(-40.0, 0.0, 0.0),
            ClipPlane::Right => Vec3::new(40.0, 0.0, 0.0),
            ClipPlane::Bottom => Vec3::new(0.0, -40.0, 0.0),
            ClipPlane::Top => Vec3::new(0.0, 40.0, 0.0),
            ClipPlane::Hither => Vec3::new(0.0, 0.0, 5.0),
            ClipPlane::Yon => Vec3::new(0.0, 0.0, -20.0),
        };
        scene.objects[0].parent_from_local = Affine3::from_translation(outside);
        let (list, counts, _) = run(&scene, &choices);
        assert_eq!((counts.clipped, counts.rendered, list.len()), (1, 0, 0), "{plane:?}");
    }
    let inside = at(4.0, &[(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0)]);
    let (_, counts, plan) = run(&one_surface(&[inside], Material::default()), &Choices::default());
    assert_eq!((counts.inside, counts.cut, plan.needs.clip), (1, 0, 0));
    assert_eq!(counts.work.plane_tests, 0, "what is not needed is not done");
}

#[test]
fn split_triangles_draw_what_the_whole_polygon_draws() {
    for seed in 0..12 {
        let mix = Mix { seed, corners: (4, 9), distance: (0.5, 9.0), polygons: 40, spread: 1.0, ..Mix::default() };
        for needs in [NeedsMode::Derived, NeedsMode::Full] {
            let flat = Choices { shading: Shading::Flat, culling: Culling::None, needs, ..Choices::default() };
            let (whole, whole_counts, _) = run(&mix.scene(200), &flat);
            let (split, split_counts, _) = run(&mix.scene(200), &Choices { triangles: true, ..flat });
            assert_eq!(split.len() as u64, whole_counts.triangles);
            assert_eq!((whole_counts.split, split_counts.forced_ears), (0, 0));
            assert!(split_counts.split > 10 && split.polygons().all(|polygon| polygon.vertices().len() == 3));
            let (whole, split) = (draw(&whole, &ZBuffer).0, draw(&split, &ZBuffer).0);
            let differ = whole.pixels().iter().zip(split.pixels()).filter(|(a, b)| a != b).count();
            assert_eq!(differ, 0, "seed {seed}");
        }
    }
}

fn position(light: &mut Light) -> &mut Vec3 {
    match &mut light.source {
        LightSource::Point { position } => position,
        other => panic!("{other:?} is not a point light"),
    }
}
