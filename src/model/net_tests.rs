//! Bezier nets and the teapot by independent means: openings, normals against windings, Bernstein's points, shared vertices.

use super::test_bodies::*;
use super::*;
use crate::math::newell_normal;
use crate::scene::{PatchNet, TeapotPart};
use std::sync::Arc;

#[test]
fn the_teapot_is_open_only_where_its_parts_end() {
    // The foot and the lip of the body, the lid's rim, both ends of the handle and of the spout: nothing else is open.
    let n = 6usize;
    for (part, rims) in [
        (TeapotPart::Body, 2 * 4 * n),
        (TeapotPart::Lid, 4 * n),
        (TeapotPart::Handle, 2 * 2 * n),
        (TeapotPart::Spout, 2 * 2 * n),
    ] {
        let (mesh, _) = mesh_of(&teapot(part), false, Detail::Segments(n as u32));
        assert_eq!(topology(&mesh).1, rims, "{part:?}");
    }
}

#[test]
fn given_normals_are_near_the_mean_of_the_polygons_around() {
    // The mean knows nothing of derivatives: it is made of windings alone.
    for part in [TeapotPart::Body, TeapotPart::Lid, TeapotPart::Handle, TeapotPart::Spout] {
        let (mesh, _) = mesh_of(&teapot(part), false, Detail::Segments(30));
        check_normals(&mesh, 0.9, &format!("{part:?}"));
        let mut means = Vec::new();
        averaged_normals(&mesh, &mut means);
        let worst = mesh.normals.iter().zip(&means).map(|(given, mean)| given.dot(*mean)).fold(1.0, f64::min);
        assert!(worst > 0.94, "{part:?}: {worst}");
    }
}

#[test]
fn the_teapot_faces_outward() {
    // Each half of a tube faces its own side; the body, all in all, away from the axis.
    for part in [TeapotPart::Handle, TeapotPart::Spout] {
        let n = 8;
        let (mesh, _) = mesh_of(&teapot(part), false, Detail::Segments(n));
        let area = |side: f64| -> f64 {
            let sides = mesh.polygons.iter().map(|polygon| newell_normal(&points(&mesh, polygon)).y * side);
            let of_half =
                mesh.polygons.iter().zip(sides).filter(|(polygon, _)| points(&mesh, polygon)[0].y * side > 1e-9);
            of_half.map(|(_, y)| y).sum()
        };
        assert!(area(1.0) > 0.0 && area(-1.0) > 0.0, "{part:?}");
    }
    let (mesh, _) = mesh_of(&teapot(TeapotPart::Body), false, Detail::Segments(8));
    let outward = mesh.polygons.iter().map(|polygon| {
        let outline = points(&mesh, polygon);
        newell_normal(&outline).dot(outline[0].with_z(0.0))
    });
    assert!(outward.sum::<f64>() > 0.0);
    // On the table, as high as three quarters, and as long as spout and handle together.
    let (whole, _) = mesh_of(&teapot(TeapotPart::Whole), false, Detail::Segments(8));
    let (low, high) = whole.vertices.iter().fold((Vec3::MAX, Vec3::MIN), |(low, high), &v| (low.min(v), high.max(v)));
    assert_eq!((low.z, high.z), (0.0, 0.75));
    assert!((low.x + 0.75).abs() < 0.02 && (high.x - 0.86).abs() < 0.02, "{low} {high}");
}

#[test]
fn patches_and_curves_pass_through_bernsteins_points() {
    let n = 6;
    let Shape::Patches(net) = pillow() else { unreachable!("a pillow") };
    let (mesh, _) = mesh_of(&pillow(), false, Detail::Segments(n));
    let at = |i: u32| f64::from(i) / f64::from(n);
    for patch in &net.patches {
        let row = |r: usize, u: f64| bernstein(&std::array::from_fn(|c| net.vertices[patch[4 * r + c] as usize]), u);
        for (i, j) in (0..=n).flat_map(|i| (0..=n).map(move |j| (i, j))) {
            let expected = bernstein(&std::array::from_fn(|r| row(r, at(i))), at(j));
            let nearest = mesh.vertices.iter().map(|&v| (v - expected).length()).fold(f64::INFINITY, f64::min);
            assert!(nearest < 1e-14, "{expected}: {nearest}");
        }
    }
    let Shape::Curves(net) = vase(0.7) else { unreachable!("a vase") };
    let (mesh, _) = mesh_of(&vase(0.7), false, Detail::Segments(n));
    for curve in &net.curves {
        for i in 0..=n {
            let expected = bernstein(&curve.map(|index| net.vertices[index as usize]), at(i));
            let on_ring = |v: &Vec3| (v.z - expected.z).hypot(v.truncate().length() - expected.truncate().length());
            let ring = mesh.vertices.iter().filter(|v| on_ring(v) < 1e-14).count();
            // All columns of a ring; one vertex, or one a column, at a pole.
            assert!(
                ring == 4 * n as usize || expected.truncate().length() < 1e-15 && ring >= 1,
                "{ring} at {expected}"
            );
        }
    }
}

#[test]
fn neighbors_share_vertices_across_the_pieces_of_a_net() {
    // 4n columns; 3 curves have 3n + 1 rows. The lid's tip is one vertex, its normal points up.
    let n = 5usize;
    let (body, _) = mesh_of(&teapot(TeapotPart::Body), false, Detail::Segments(n as u32));
    assert_eq!(body.vertices.len(), 4 * n * (3 * n + 1));
    let (lid, _) = mesh_of(&teapot(TeapotPart::Lid), false, Detail::Segments(n as u32));
    assert_eq!(lid.vertices.len(), 4 * n * 2 * n + 1);
    let tip = lid.vertices.iter().position(|v| v.z == 0.75).expect("has a tip");
    assert!((lid.normals[tip] - Vec3::Z).length() < 1e-15);
    // Two half tubes of two pieces: rings of 2n vertices, 2n + 1 of them.
    let (handle, _) = mesh_of(&teapot(TeapotPart::Handle), false, Detail::Segments(n as u32));
    assert_eq!(handle.vertices.len(), 2 * n * (2 * n + 1));
}

#[test]
fn where_derivatives_vanish_there_is_still_a_normal() {
    // A quarter of a dome: its last row is one point, the top.
    let k = 0.5523;
    let rows = [(1.0, 0.0), (1.0, k), (k, 1.0), (0.0, 1.0)];
    let vertices: Vec<Vec3> = rows
        .iter()
        .flat_map(|&(r, z)| [(1.0, 0.0), (1.0, k), (k, 1.0), (0.0, 1.0)].map(|(x, y)| Vec3::new(r * x, r * y, z)))
        .collect();
    let net = PatchNet { vertices, patches: vec![std::array::from_fn(|i| i as u32)] };
    let (mesh, _) = mesh_of(&Shape::Patches(Arc::new(net)), false, Detail::Segments(6));
    let (corners, open) = topology(&mesh);
    assert_eq!((corners, open), (1, 6 + 6 + 6), "a disc, open on three sides of six cells");
    check_normals(&mesh, 0.9, "dome");
    let top: Vec<_> = mesh.vertices.iter().zip(&mesh.normals).filter(|(v, _)| v.z == 1.0).collect();
    assert!(top.len() == 1 && (*top[0].1 - Vec3::Z).length() < 1e-5, "{top:?}");
}
