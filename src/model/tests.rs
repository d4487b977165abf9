//! Counts, closedness, orientation and planarity of what shapes turn into.

use super::*;
use crate::math::{newell_normal, unit};
use std::collections::HashMap;

const SPHERE: Shape = Shape::Sphere { center: Vec3::new(1.0, -2.0, 3.0), radius: 2.5 };

fn cone(base_radius: f64, apex_radius: f64) -> Shape {
    Shape::Cone { base: Vec3::new(1.0, 2.0, 3.0), base_radius, apex: Vec3::new(-1.0, 5.0, 4.5), apex_radius }
}

fn mesh_of(shape: &Shape, inside: bool, detail: Detail) -> Mesh {
    let mut mesh = Mesh::default();
    tessellate(shape, inside, detail, 7, &mut mesh);
    mesh
}

fn points(mesh: &Mesh, polygon: &crate::scene::Polygon) -> Vec<Vec3> {
    mesh.outline(polygon).iter().map(|&index| mesh.vertices[index as usize]).collect()
}

/// How often each directed edge, by index, occurs without its opposite.
fn open_edges(mesh: &Mesh) -> usize {
    let mut balance: HashMap<(u32, u32), i32> = HashMap::new();
    for polygon in &mesh.polygons {
        for (&a, &b) in crate::math::edges(mesh.outline(polygon)) {
            assert_ne!(a, b);
            *balance.entry((a.min(b), a.max(b))).or_default() += if a < b { 1 } else { -1 };
            *balance.entry((b, a)).or_default() += 0;
        }
    }
    balance.values().filter(|&&sum| sum != 0).count()
}

#[test]
fn spheres_have_the_promised_counts_and_close() {
    for n in 1..=5 {
        let mesh = mesh_of(&SPHERE, false, Detail::Resolution(n));
        let n = n as usize;
        assert_eq!((mesh.polygons.len(), mesh.vertices.len()), (12 * n * n, 6 * n * n + 2));
        assert_eq!(open_edges(&mesh), 0, "resolution {n}");
    }
    for (asked, n) in [(0, 4), (4, 4), (5, 6), (6, 6), (17, 18), (50, 50)] {
        let mesh = mesh_of(&SPHERE, false, Detail::Segments(asked));
        assert_eq!((mesh.polygons.len(), mesh.vertices.len()), (n * n / 2, n * (n / 2 - 1) + 2));
        assert_eq!(open_edges(&mesh), 0, "segments {n}");
    }
}

#[test]
fn cones_have_the_promised_counts() {
    for (base_radius, apex_radius, corners) in [(1.0, 1.0, 4), (2.0, 0.5, 4), (0.0, 1.0, 3), (1.0, 0.0, 3)] {
        let mesh = mesh_of(&cone(base_radius, apex_radius), false, Detail::Segments(9));
        assert!(mesh.polygons.len() == 9 && mesh.polygons.iter().all(|polygon| polygon.count == corners));
        let triangles = mesh_of(&cone(base_radius, apex_radius), false, Detail::Resolution(3));
        assert_eq!((triangles.polygons.len(), triangles.vertices.len()), (24, 24));
    }
    // Open at both ends, and nowhere else: the seam closes on the same vertices.
    for detail in [Detail::Segments(12), Detail::Resolution(3)] {
        assert_eq!(open_edges(&mesh_of(&cone(1.0, 2.0), false, detail)), 24);
    }
}

#[test]
fn discs_and_rings_face_up() {
    let flat = |base_radius, apex_radius| Shape::Cone { base: Vec3::X, base_radius, apex: Vec3::X, apex_radius };
    for (shape, detail, polygons, area) in [
        (flat(2.0, 0.0), Detail::Segments(100), 1, 4.0),
        (flat(0.0, 2.0), Detail::Resolution(25), 100, 4.0),
        (flat(2.0, 1.0), Detail::Segments(100), 100, 3.0),
        (flat(1.0, 2.0), Detail::Resolution(25), 200, 3.0),
    ] {
        for (inside, up) in [(false, 1.0), (true, -1.0)] {
            let mesh = mesh_of(&shape, inside, detail);
            assert_eq!(mesh.polygons.len(), polygons);
            let normals: Vec<Vec3> =
                mesh.polygons.iter().map(|polygon| newell_normal(&points(&mesh, polygon))).collect();
            assert!(normals.iter().all(|normal| normal.z * up > 0.0));
            let total = normals.iter().sum::<Vec3>().length() / 2.0;
            assert!((total / (area * crate::math::PI) - 1.0).abs() < 1e-3, "{total}");
            assert!(mesh.normals.iter().all(|&normal| normal == Vec3::Z * up));
        }
    }
}

#[test]
fn normals_are_unit_and_agree_with_the_winding() {
    let shapes = [SPHERE, cone(1.0, 1.0), cone(2.0, 0.5), cone(0.0, 1.0), cone(1.0, 0.0), cone(0.1, 7.0)];
    for (shape, detail) in
        shapes.iter().flat_map(|shape| [(shape, Detail::Segments(16)), (shape, Detail::Resolution(4))])
    {
        for inside in [false, true] {
            let mesh = mesh_of(shape, inside, detail);
            assert!(mesh.normals.iter().all(|normal| (normal.length() - 1.0).abs() < 1e-15));
            let middle = match *shape {
                Shape::Sphere { center, .. } => center,
                Shape::Cone { base, apex, .. } => (base + apex) / 2.0,
                _ => unreachable!("none of these"),
            };
            for polygon in &mesh.polygons {
                let outline = points(&mesh, polygon);
                // SPD's pattern has triangles without area at a pointed end.
                let Some(front) = polygon_normal(&mesh, polygon) else { continue };
                let mean = outline.iter().sum::<Vec3>() / outline.len() as f64;
                assert_eq!(front.dot(mean - middle) < 0.0, inside);
                let given = mesh.outline(polygon).iter().map(|&index| mesh.normals[index as usize]);
                given.for_each(|normal| assert!(normal.dot(front) > 0.7, "{shape:?} {detail:?}"));
                assert!(outline.iter().all(|&point| front.dot(point - outline[0]).abs() < 1e-14), "not planar");
            }
        }
    }
}

#[test]
fn inside_reverses_outlines_and_keeps_their_first_vertex() {
    let (outside, inside) = (mesh_of(&SPHERE, false, Detail::Segments(8)), mesh_of(&SPHERE, true, Detail::Segments(8)));
    for (a, b) in outside.polygons.iter().zip(&inside.polygons) {
        let (mut a, b) = (outside.outline(a).to_vec(), inside.outline(b));
        a[1..].reverse();
        assert_eq!(a, b);
    }
    assert!(outside.normals.iter().zip(&inside.normals).all(|(&a, &b)| a == -b));
}

#[test]
fn the_cube_pattern_is_spds_own() {
    let (n, center, radius) = (3, Vec3::new(1.0, -2.0, 3.0), 2.5);
    let mesh = mesh_of(&SPHERE, false, Detail::Resolution(n));
    // SPD's formula word for word, with std's functions: it may differ in rounding only.
    let angle = |i: u32| std::f64::consts::FRAC_PI_4 * (2.0 * f64::from(i) / f64::from(n) - 1.0);
    let direction = |face: usize, u: u32, v: u32| {
        let ((su, cu), (sv, cv)) = (angle(u).sin_cos(), angle(v).sin_cos());
        let start = unit(Vec3::new(su * cv, -cu * sv, cu * cv)).expect("not zero");
        let turns = [
            |p: Vec3| Vec3::new(-p.z, p.y, p.x),
            |p: Vec3| Vec3::new(-p.y, p.x, p.z),
            |p: Vec3| Vec3::new(p.x, -p.z, p.y),
        ];
        (0..=face).fold(start, |point, step| turns[step % 3](point))
    };
    let mut polygons = mesh.polygons.iter();
    for (face, u, v) in (0..6).flat_map(|f| (0..n).flat_map(move |u| (0..n).map(move |v| (f, u, v)))) {
        let [q0, q1, q2, q3] = [(u, v), (u, v + 1), (u + 1, v + 1), (u + 1, v)].map(|(u, v)| direction(face, u, v));
        for triangle in [[q0, q1, q2], [q2, q3, q0]] {
            let outline = mesh.outline(polygons.next().expect("12 n^2"));
            for (&index, expected) in outline.iter().zip(triangle) {
                assert!((mesh.normals[index as usize] - expected).length() < 1e-15);
                assert!((mesh.vertices[index as usize] - (center + expected * radius)).length() < 1e-14);
            }
        }
    }
}

#[test]
fn normals_at_a_tip_belong_to_their_segment() {
    let mesh = mesh_of(&cone(1.0, 0.0), false, Detail::Segments(6));
    for polygon in &mesh.polygons {
        let normals: Vec<Vec3> = mesh.outline(polygon).iter().map(|&index| mesh.normals[index as usize]).collect();
        let (tip, mean) = (normals[2], unit(normals[0] + normals[1]).expect("not opposite"));
        // All three lean towards the tip by the same angle, so the tip's lies between the others but leans as they do.
        assert!(tip.dot(mean) > 0.99 && (tip.dot(normals[0]) - tip.dot(normals[1])).abs() < 1e-15);
    }
}

#[test]
fn extremes_stay_numbers() {
    let long = Shape::Cone { base: Vec3::ZERO, base_radius: 1e-9, apex: Vec3::new(6e8, 0.0, 8e8), apex_radius: 1e-9 };
    let tiny = Shape::Cone { base: Vec3::ZERO, base_radius: 1e-9, apex: Vec3::new(1e-9, 0.0, 0.0), apex_radius: 0.0 };
    let huge = Shape::Cone { base: Vec3::ZERO, base_radius: 1e200, apex: Vec3::new(0.0, 0.0, 1e200), apex_radius: 0.0 };
    for (shape, detail) in
        [long, tiny, huge].iter().flat_map(|s| [(s, Detail::Segments(8)), (s, Detail::Resolution(2))])
    {
        let mesh = mesh_of(shape, false, detail);
        assert!(mesh.vertices.iter().all(|v| v.is_finite()), "{shape:?}");
        assert!(
            mesh.normals.iter().all(|normal| (normal.length() - 1.0).abs() < 1e-15),
            "{shape:?} {:?}",
            mesh.normals
        );
    }
    let nothing = [
        Shape::Sphere { center: Vec3::ZERO, radius: 0.0 },
        Shape::Sphere { center: Vec3::NAN, radius: 1.0 },
        Shape::Sphere { center: Vec3::ZERO, radius: f64::INFINITY },
        cone(0.0, 0.0),
        cone(f64::NAN, 1.0),
        Shape::Cone { base: Vec3::X, base_radius: 1.0, apex: Vec3::X, apex_radius: 1.0 },
    ];
    nothing.iter().for_each(|shape| assert_eq!(mesh_of(shape, false, Detail::Segments(8)), Mesh::default()));
}

#[test]
fn a_warm_mesh_keeps_its_memory_and_a_used_one_its_polygons() {
    let mut mesh = Mesh::default();
    tessellate(&SPHERE, false, Detail::Segments(8), 1, &mut mesh);
    let first = mesh.clone();
    tessellate(&SPHERE, false, Detail::Segments(8), 2, &mut mesh);
    assert_eq!(mesh.polygons.len(), 64);
    assert_eq!(points(&mesh, &mesh.polygons[40]), points(&mesh, &mesh.polygons[8]));
    let capacities = |mesh: &Mesh| (mesh.vertices.capacity(), mesh.outlines.capacity(), mesh.polygons.capacity());
    let before = capacities(&mesh);
    mesh.clear();
    tessellate(&SPHERE, false, Detail::Segments(8), 1, &mut mesh);
    assert_eq!((capacities(&mesh), mesh == first), (before, true));
}

/// A cone a power of two larger or smaller is the same cone: whether it stands upright is a matter of its direction.
#[test]
fn cones_of_every_size_start_in_the_same_direction() {
    let of_size = |exponent: i32, tilt: f64| {
        let size = 2.0_f64.powi(exponent);
        let (base, apex) = (Vec3::ZERO, Vec3::new(tilt, tilt / 2.0, 1.0) * size);
        let mesh = mesh_of(
            &Shape::Cone { base, base_radius: size, apex, apex_radius: size / 2.0 },
            false,
            Detail::Segments(8),
        );
        mesh.vertices.iter().map(|&vertex| vertex / size).collect::<Vec<Vec3>>()
    };
    for tilt in [0.5, 1e-3, 1e-5, 1e-9, 0.0] {
        let plain = of_size(0, tilt);
        for exponent in [-40, -20, 20, 40] {
            assert_eq!(of_size(exponent, tilt), plain, "tilt {tilt}, size 2^{exponent}");
        }
    }
}
