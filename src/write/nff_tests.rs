//! The text, token by token; the NFF reader has its own round-trip test.

use super::*;
use crate::model::averaged_normals;
use crate::scene::{Object, ObjectId, Place, SurfaceId};

fn triangle(normals: NormalSource) -> Mesh {
    let mut mesh = Mesh::default();
    for (x, y) in [(0.1, 0.2), (1.0, 0.0), (0.0, 1.0 / 3.0)] {
        mesh.push_vertex_with_normal(
            Vec3::new(x, y, 0.5),
            if x == 1.0 { Vec3::ZERO } else { Vec3::new(0.6, 0.0, 0.8) },
        );
    }
    mesh.push_polygon(&[0, 1, 2], normals, 1);
    mesh
}

fn surface(mesh: Mesh, shapes: &[(Shape, bool, u32)]) -> Surface {
    let primitives = shapes
        .iter()
        .map(|&(ref shape, inside, before)| Primitive { inside, ..Primitive::new(shape.clone(), before, 0) })
        .collect();
    Surface { material: Material::default(), mesh, primitives, two_sided: false, place: Place::default() }
}

fn scene(surface: Surface, parent_from_local: Affine3) -> Scene {
    let object = Object {
        name: "thing".to_string(),
        parent_from_local,
        surfaces: vec![SurfaceId(0)],
        children: vec![],
        place: Place::default(),
    };
    Scene { objects: vec![object], surfaces: vec![surface], world: vec![ObjectId(0)], ..Scene::default() }
}

fn written(scene: &Scene) -> (String, Vec<String>) {
    let mut out = Vec::new();
    let notices = write_nff(scene, &mut out).expect("can be written");
    (String::from_utf8(out).expect("ascii"), notices)
}

/// Every line's words and numbers.
fn lines(text: &str) -> Vec<(String, Vec<f64>)> {
    let of_line = |line: &str| {
        let (words, numbers): (Vec<_>, Vec<_>) = line.split(' ').partition(|token| token.parse::<f64>().is_err());
        (words.join(" "), numbers.iter().map(|token| token.parse().expect("sorted out above")).collect())
    };
    text.lines().map(of_line).collect()
}

fn words(text: &str) -> String {
    lines(text).into_iter().filter(|(word, _)| !word.is_empty()).map(|(word, _)| word).collect::<Vec<_>>().join(" ")
}

const BALL: Shape = Shape::Sphere { center: Vec3::new(1.0, 2.0, 3.0), radius: 0.5 };
const TUBE: Shape = Shape::Cone { base: Vec3::ZERO, base_radius: 1.0, apex: Vec3::Z, apex_radius: 0.5 };

#[test]
fn a_whole_scene_in_order() {
    let mut mesh = triangle(NormalSource::Facet);
    mesh.push_polygon(&[2, 1, 0], NormalSource::Given, 2);
    let shapes = [(BALL, false, 0), (TUBE, true, 1), (BALL, true, 1), (TUBE, false, 2)];
    let mut scene = scene(surface(mesh, &shapes), Affine3::IDENTITY);
    scene.surfaces[0].material =
        Material { color: Rgb::new(0.1, 0.2, 0.3), opacity: Rgb::gray(0.75), shine: 1e5, ..Material::default() };
    scene.background = Some(Rgb::new(0.078, 0.361, 0.753));
    scene.camera = Some(Camera {
        from: Vec3::new(1.0 / 3.0, 1e-3, 5.0),
        at: Vec3::ZERO,
        up: Vec3::Z,
        angle: 45.0,
        hither: 1.0,
        yon: None,
        resolution: (640, 480),
        place: Place::default(),
    });
    let light = Light::point(Vec3::ONE, Rgb::WHITE, Place::default());
    scene.lights = vec![light, Light { color: Rgb::new(1.0, 0.5, 0.0), ..light }];
    let (text, notices) = written(&scene);
    let third = 1.0 / 3.0;
    assert_eq!(
        text,
        format!(
            "b 0.078 0.361 0.753\nv\nfrom {third} 1e-3 5\nat 0 0 0\nup 0 0 1\nangle 45\nhither 1\nresolution 640 480\n\
             l 1 1 1\nl 1 1 1 1 0.5 0\nf 0.1 0.2 0.3 0.8 0 1e5 0.25 1\ns 1 2 3 0.5\np 3\n0.1 0.2 0.5\n1 0 0.5\n0 {third} 0.5\n\
             c 0 0 0 -1 0 0 1 -0.5\ns 1 2 3 -0.5\npp 3\n0 {third} 0.5 0.6 0 0.8\n1 0 0.5 0 0 -1\n0.1 0.2 0.5 0.6 0 0.8\n\
             c 0 0 0 1 0 0 1 0.5\n"
        )
    );
    assert_eq!(notices, Vec::<String>::new());
}

#[test]
fn averaged_normals_are_written_out() {
    let mut mesh = triangle(NormalSource::Averaged);
    let top = mesh.push_vertex(Vec3::new(0.1, 0.2, 1.5));
    mesh.push_polygon(&[1, 0, top], NormalSource::Averaged, 2);
    let (text, _) = written(&scene(surface(mesh.clone(), &[]), Affine3::IDENTITY));
    let mut normals = Vec::new();
    averaged_normals(&mesh, &mut normals);
    let vertices: Vec<_> = lines(&text).into_iter().filter(|(word, _)| word.is_empty()).map(|(_, n)| n).collect();
    assert_eq!(words(&text), "f pp pp");
    for (written, index) in vertices.iter().zip([0, 1, 2, 1, 0, 3]) {
        assert_eq!(written[..3], mesh.vertices[index].to_array());
        // A normal of the file wins over the mean, as in the geometry stage; vertices 1 and 3 have none.
        let given = mesh.normals[index];
        let expected = if given == Vec3::ZERO { normals[index] } else { given };
        assert_eq!(written[3..], expected.to_array());
    }
}

#[test]
fn a_mirror_reverses_outlines_and_keeps_fronts() {
    let mirror = Affine3::from_translation(Vec3::X) * Affine3::from_scale(Vec3::new(-2.0, 2.0, 2.0));
    for normals in [NormalSource::Facet, NormalSource::Averaged, NormalSource::Given] {
        let shapes = [(BALL, false, 0), (TUBE, true, 0)];
        let (text, notices) = written(&scene(surface(triangle(normals), &shapes), mirror));
        let vertices: Vec<_> = lines(&text).into_iter().filter(|(word, _)| word.is_empty()).map(|(_, n)| n).collect();
        let points: Vec<Vec3> = vertices.iter().map(|n| Vec3::new(n[0], n[1], n[2])).collect();
        assert_eq!(points[0], Vec3::new(0.8, 0.4, 1.0));
        // The front was +z and still is.
        assert!(crate::math::newell_normal(&points).z > 0.0);
        assert!(vertices.iter().all(|n| n.len() == 3 || n[5] > 0.0));
        if normals == NormalSource::Given {
            assert!((Vec3::from_slice(&vertices[0][3..]) - Vec3::new(-0.6, 0.0, 0.8)).length() < 1e-15);
            assert_eq!(vertices[2][3..], [0.0, 0.0, 1.0]);
        }
        assert!(text.contains("s -1 4 6 1\nc 1 0 0 -2 1 0 2 -1\n"), "{text}");
        assert_eq!(notices.len(), 3, "{notices:?}");
    }
}

#[test]
fn stretched_shapes_become_polygons_and_say_so() {
    let stretch = Affine3::from_scale(Vec3::new(1.0, 1.0, 3.0));
    let (text, notices) = written(&scene(surface(Mesh::default(), &[(BALL, false, 0), (TUBE, false, 0)]), stretch));
    let polygons = text.lines().filter(|line| line.starts_with("pp ")).count();
    assert_eq!(polygons, 64 * 32 + 64);
    assert!(
        notices.iter().any(|notice| notice.starts_with("spheres and cones") && notice.ends_with(": 2")),
        "{notices:?}"
    );
    // All of it faces outward, and its normals are square to the ellipsoid.
    let vertices: Vec<_> = lines(&text).into_iter().filter(|(word, _)| word.is_empty()).map(|(_, n)| n).collect();
    for vertex in &vertices[..64 * 32 * 3] {
        let (from_center, normal) =
            (Vec3::from_slice(vertex) - Vec3::new(1.0, 2.0, 9.0), Vec3::from_slice(&vertex[3..]));
        let gradient = unit(from_center / Vec3::new(1.0, 1.0, 9.0)).expect("not the center");
        assert!((normal - gradient).length() < 1e-13);
    }
    assert!(text.lines().count() > polygons && !text.contains("\ns ") && !text.contains("\nc "));

    // A disc that faces +z has a word, one that does not has none.
    let disc = Shape::Cone { base: Vec3::ONE, base_radius: 1.0, apex: Vec3::ONE, apex_radius: 0.0 };
    let turned = |angle: f64| {
        written(&scene(surface(Mesh::default(), &[(disc.clone(), false, 0)]), Affine3::from_rotation_x(angle)))
    };
    assert_eq!((words(&turned(0.0).0), words(&turned(0.5).0)), ("f c".to_string(), "f pp".to_string()));
}

#[test]
fn what_nff_cannot_say_is_listed() {
    let mut scene = scene(surface(triangle(NormalSource::Facet), &[]), Affine3::from_scale(Vec3::new(1.0, 1.0, 0.0)));
    scene.objects.push(Object { parent_from_local: Affine3::IDENTITY, ..scene.objects[0].clone() });
    scene.world.push(ObjectId(1));
    scene.surfaces[0].material.ambient = Some(0.5);
    scene.surfaces[0].material.opacity = Rgb::new(1.0, 0.5, 0.75);
    scene.lights = vec![Light { intensity: Some(2.0), ..Light::point(Vec3::ONE, Rgb::WHITE, Place::default()) }];
    let (text, notices) = written(&scene);
    assert_eq!(words(&text), "#farop light intensity l #farop surface ambient opacity f p");
    assert!(
        text.starts_with(
            "#farop light intensity 2\nl 1 1 1\n#farop surface ambient 0.5 opacity 1 0.5 0.75\nf 1 1 1 0.8 0 0 0.25 1\n"
        ),
        "{text}"
    );
    let expected = [
        "no camera",
        "comments: light intensities, ambient coefficients, reflection models, opacity per channel and two-sidedness of 1 lights and 1 surfaces",
        "world coordinates, without their nesting: 2",
        "names of objects left out: 2",
        "flattens them to nothing: 1",
    ];
    assert_eq!(notices.len(), expected.len(), "{notices:?}");
    assert!(notices.iter().zip(expected).all(|(notice, part)| notice.contains(part)), "{notices:?}");
}

#[test]
fn numbers_that_are_none_are_errors() {
    let mut scene = scene(surface(triangle(NormalSource::Facet), &[]), Affine3::IDENTITY);
    scene.surfaces[0].mesh.vertices[1].y = f64::NAN;
    let error = write_nff(&scene, &mut Vec::new()).expect_err("refused");
    assert_eq!(error.kind(), io::ErrorKind::InvalidData);
}

#[test]
fn a_full_disk_is_reported() {
    let mut short = [0u8; 20];
    let scene = scene(surface(triangle(NormalSource::Facet), &[]), Affine3::IDENTITY);
    assert!(write_nff(&scene, &mut &mut short[..]).is_err());
}
