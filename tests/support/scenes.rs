//! Scenes built by hand, without a parser.
//!
//! The camera stands at the world's origin, looks along -z, up is +y: the eye-space point (x, y, w) is (x, y, -w) in the
//! world. With an opening of 90 degrees and a square picture of n samples, it lands n/2 x/w right of the middle.

use super::random::Random;
use farop::color::Rgb;
use farop::math::{Affine3, Vec3};
use farop::plan::{Accepts, Choices, Plan};
use farop::report::Counts;
use farop::scene::{Camera, Light, Material, Mesh, NormalSource, Object, ObjectId, Place, Scene, Surface, SurfaceId};
use farop::screen::DrawList;

/// The world point at eye-space point (x, y, w).
pub fn world(eye: Vec3) -> Vec3 {
    Vec3::new(eye.x, eye.y, -eye.z)
}

/// A camera at the origin with an opening of 90 degrees, hither 1, no yon.
pub fn camera(width: u32, height: u32) -> Camera {
    Camera {
        from: Vec3::ZERO,
        at: Vec3::NEG_Z,
        up: Vec3::Y,
        angle: 90.0,
        hither: 1.0,
        yon: None,
        resolution: (width, height),
        place: Place::default(),
    }
}

/// A scene of one object, not moved, seen by `camera`; one white light at the eye's upper left.
pub fn scene(camera: Camera, surfaces: Vec<Surface>) -> Scene {
    let object = Object {
        name: String::new(),
        parent_from_local: Affine3::IDENTITY,
        surfaces: (0..surfaces.len() as u32).map(SurfaceId).collect(),
        children: Vec::new(),
        place: Place::default(),
    };
    let (position, place) = (Vec3::new(-3.0, 4.0, 2.0), Place::default());
    Scene {
        files: vec!["by hand".into()],
        objects: vec![object],
        surfaces,
        world: vec![ObjectId(0)],
        lights: vec![Light::point(position, Rgb::WHITE, place)],
        camera: Some(camera),
        ..Scene::default()
    }
}

/// A surface of one material over `mesh`.
pub fn surface(material: Material, mesh: Mesh) -> Surface {
    Surface { material, mesh, primitives: Vec::new(), two_sided: false, place: Place::default() }
}

/// A mesh of facets, each with corners of its own (world space), counterclockwise from the front.
pub fn facets(outlines: &[Vec<Vec3>]) -> Mesh {
    let mut mesh = Mesh::default();
    for outline in outlines {
        let indices: Vec<u32> = outline.iter().map(|&corner| mesh.push_vertex(corner)).collect();
        mesh.push_polygon(&indices, NormalSource::Facet, mesh.polygons.len() as u32 + 1);
    }
    mesh
}

/// Plans and runs the geometry stage.
pub fn run(scene: &Scene, choices: &Choices) -> (DrawList, Counts, Plan) {
    let plan = Plan::new(scene, choices, Accepts::AnyPolygon).expect("scenes of tests have a view");
    let mut list = DrawList::new(0, 0);
    let counts = farop::geometry::run(scene, &plan, &mut list);
    (list, counts, plan)
}

/// A flat mesh that reaches far beyond all sides of the picture: cells of triangles or quadrilaterals over a shaken grid
/// of `cells` x `cells`, on the plane 1/w = 1 + a x/w + b y/w.
pub fn wide_mesh(random: &mut Random, cells: usize, (a, b): (f64, f64), quads: bool) -> Mesh {
    let mut mesh = Mesh::default();
    for row in 0..=cells {
        for column in 0..=cells {
            let mut along = |i: usize| ((i as f64 + random.between(-0.2, 0.2)) / cells as f64 * 2.0 - 1.0) * 2.2;
            let (x, y) = (along(column), along(row));
            let w = 1.0 / (1.0 + a * x + b * y);
            mesh.push_vertex(world(Vec3::new(x * w, y * w, w)));
        }
    }
    for row in 0..cells {
        for column in 0..cells {
            let at = |row: usize, column: usize| (row * (cells + 1) + column) as u32;
            let [p, q] = [at(row, column), at(row, column + 1)];
            let [s, r] = [at(row + 1, column), at(row + 1, column + 1)];
            if quads {
                mesh.push_polygon(&[p, q, r, s], NormalSource::Facet, 1);
            } else {
                mesh.push_polygon(&[p, q, r], NormalSource::Facet, 1);
                mesh.push_polygon(&[p, r, s], NormalSource::Facet, 1);
            }
        }
    }
    mesh
}
