//! What tests of shapes share: bodies to test on, and measures that know nothing of how they were made.

use super::*;
use crate::math::{edges, newell_normal, unit};
use crate::scene::{CurveNet, NormalSource, PatchNet, Polygon, TeapotPart};
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

pub(super) fn mesh_of(shape: &Shape, inside: bool, detail: Detail) -> (Mesh, usize) {
    let mut mesh = Mesh::default();
    let nonplanar = tessellate(shape, inside, detail, 7, &mut mesh);
    (mesh, nonplanar as usize)
}

pub(super) fn points(mesh: &Mesh, polygon: &Polygon) -> Vec<Vec3> {
    mesh.outline(polygon).iter().map(|&index| mesh.vertices[index as usize]).collect()
}

pub(super) fn bits(point: Vec3) -> [u64; 3] {
    point.to_array().map(|x| (x + 0.0).to_bits())
}

/// Corners, edges and faces by position; and the edges that are not run along once in each direction.
pub(super) fn topology(mesh: &Mesh) -> (i64, usize) {
    let mut corners = HashSet::new();
    let mut directed: HashMap<([u64; 3], [u64; 3]), i32> = HashMap::new();
    for polygon in &mesh.polygons {
        let outline = points(mesh, polygon);
        for (&a, &b) in edges(&outline) {
            assert_ne!(bits(a), bits(b), "an edge without length");
            corners.insert(bits(a));
            *directed.entry((bits(a), bits(b))).or_default() += 1;
        }
    }
    let open = directed.iter().filter(|&(&(a, b), &count)| count != 1 || directed.get(&(b, a)) != Some(&1)).count();
    let all_edges: HashSet<_> = directed.keys().map(|&(a, b)| (a.min(b), a.max(b))).collect();
    (corners.len() as i64 - all_edges.len() as i64 + mesh.polygons.len() as i64, open)
}

/// By the divergence theorem: a third of the flux of the position.
pub(super) fn volume(mesh: &Mesh) -> f64 {
    let flux = |polygon| {
        let outline = points(mesh, polygon);
        newell_normal(&outline).dot(outline[0]) / 6.0
    };
    mesh.polygons.iter().map(flux).sum()
}

/// Unit normals where given, planar outlines, and given normals within `cosine` of the polygon's own.
pub(super) fn check_normals(mesh: &Mesh, cosine: f64, name: &str) {
    for polygon in &mesh.polygons {
        let outline = points(mesh, polygon);
        let own = polygon_normal(mesh, polygon).unwrap_or_else(|| panic!("{name}: no area {outline:?}"));
        let longest = outline.iter().map(|&point| (point - outline[0]).length()).fold(0.0, f64::max);
        for (&index, &point) in mesh.outline(polygon).iter().zip(&outline) {
            assert!(own.dot(point - outline[0]).abs() <= 1e-9 * longest, "{name}: not planar {outline:?}");
            if polygon.normals == NormalSource::Given {
                let given = mesh.normals[index as usize];
                assert!((given.length() - 1.0).abs() < 1e-14, "{name}: {given}");
                assert!(given.dot(own) > cosine, "{name}: {given} at {point}, polygon {own}");
            }
        }
    }
}

pub(super) const ELLIPSOID: Shape = Shape::Ellipsoid { radii: Vec3::new(1.0, 2.0, 0.5) };
pub(super) const TORUS: Shape = Shape::Torus { ring_radius: 2.0, tube_radius: 0.75 };

pub(super) fn capped(bottom_radius: f64, top_radius: f64) -> Shape {
    Shape::CappedCone { bottom_radius, top_radius, length: 3.0 }
}

/// An L, concave.
pub(super) fn angle_iron() -> Shape {
    let outline = [[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [1.0, 1.0], [1.0, 4.0], [0.0, 4.0]];
    Shape::Prism { outline: Arc::from(outline), height: 2.0 }
}

/// A closed body of six patches: a cube's faces, bent. Every face has control points of its own.
pub(super) fn pillow() -> Shape {
    let bulge = |p: Vec3| unit(p).expect("not zero") * (1.0 + 0.3 * p.x * p.y * p.z);
    let turns = [
        |u: f64, v: f64| Vec3::new(1.0, u, v),
        |u: f64, v: f64| Vec3::new(-1.0, v, u),
        |u: f64, v: f64| Vec3::new(v, 1.0, u),
        |u: f64, v: f64| Vec3::new(u, -1.0, v),
        |u: f64, v: f64| Vec3::new(u, v, 1.0),
        |u: f64, v: f64| Vec3::new(v, u, -1.0),
    ];
    let mut net = PatchNet::default();
    for turn in turns {
        let first = net.vertices.len() as u32;
        let step = |i: usize| [-1.0, -0.25, 0.25, 1.0][i];
        net.vertices.extend((0..16).map(|i| bulge(turn(step(i % 4), step(i / 4)))));
        net.patches.push(std::array::from_fn(|i| first + i as u32));
    }
    Shape::Patches(Arc::new(net))
}

/// Two curves from pole to pole; neither stays in a plane through the axis when `twist` is not 0.
pub(super) fn vase(twist: f64) -> Shape {
    let at =
        |radius: f64, z: f64, turn: f64| Vec3::new(radius * (turn * twist).cos(), radius * (turn * twist).sin(), z);
    let vertices = vec![
        at(0.0, -1.0, 0.0),
        at(1.0, -1.0, 0.0),
        at(1.5, -0.5, 0.5),
        at(0.7, 0.2, 1.0),
        at(0.4, 0.5, 1.2),
        at(1.0, 1.5, 0.3),
        at(0.0, 2.0, 0.0),
    ];
    Shape::Curves(Arc::new(CurveNet { vertices, curves: vec![[0, 1, 2, 3], [3, 4, 5, 6]] }))
}

pub(super) fn teapot(part: TeapotPart) -> Shape {
    Shape::Teapot(part)
}

/// The point of a cubic by Bernstein's polynomials.
pub(super) fn bernstein(controls: &[Vec3; 4], t: f64) -> Vec3 {
    let s = 1.0 - t;
    let weights = [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t];
    controls.iter().zip(weights).map(|(&point, weight)| point * weight).sum()
}
