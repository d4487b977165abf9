//! Frames of a forest: the same whichever way they were come to, whole at extreme eyes, without cracks; and what land hides no picture shows.

use farop::forest::area::{
    Area, Cell, CellIndex, Cover, Form, Ground, Head, Owner, Patch, Plant, Species, Spread, Stand, StandState,
};
use farop::forest::cells::Cells;
use farop::forest::frame::{Choices, Composer, FrameCounts, FrameError, GroundLook, Trees};
use farop::forest::pictures::Pictures;
use farop::forest::relief::criterion::Observer;
use farop::forest::terrain::Terrain;
use farop::forest::terrain::relief::{self, Faces, View};
use farop::forest::window::Stock;
use farop::math::{Vec3, cos, edges, sin};
use farop::raster::fast::Fast;
use farop::render::render;
use farop::scene::{Camera, Place, Scene, Surface};
use std::collections::{BTreeMap, HashMap};
use std::path::Path;
use std::sync::OnceLock;

/// Hills of 5 x 5 cells of 240 m: one cell is missing, one is a mesh, one has a void.
fn area() -> Cells {
    let place = Place::default();
    let species = |code: &str, form| Species { code: code.into(), form, images: vec![], place };
    let cover = |number: u32, name: &str| Cover { number, image: format!("paint:{name}"), tile: 30.0, place };
    let head = Head {
        objects: Vec::new(),
        side: 240.0,
        seed: 11,
        species: vec![species("PINE", Form::Conifer), species("OAK", Form::Broadleaf)],
        covers: vec![cover(1, "pine_floor"), cover(2, "water")],
        ..Head::default()
    };
    let indices = (0..5).flat_map(|column| (0..5).map(move |row| [column, row]));
    let cells: BTreeMap<_, _> = indices.filter(|&index| index != [3, 1]).map(|index| (index, cell(index))).collect();
    Cells::Loaded(Area { head, cells })
}

/// The pictures of the area, painted once for all tests.
fn pictures(cells: &Cells) -> Pictures {
    static PICTURES: OnceLock<Pictures> = OnceLock::new();
    PICTURES.get_or_init(|| Pictures::new(cells.head(), Path::new(".")).expect("painted")).clone()
}

fn height(column: usize, row: usize) -> i16 {
    let (x, y) = (column as f64 * 30.0, row as f64 * 30.0);
    (900.0 * (sin(x / 170.0) + cos(y / 130.0)) + 1000.0 * sin((x + y) / 400.0)).round() as i16
}

fn cell(index: CellIndex) -> Cell {
    let place = Place::default();
    let [column, row] = index.map(|index| index as usize * 8);
    let at = |i: usize, j: usize| height(column + i, row + 8 - j);
    let mut counts: Vec<i16> = (0..81).map(|at_index| at(at_index % 9, at_index / 9)).collect();
    if index == [4, 4] {
        counts[40] = Ground::VOID;
    }
    let mut ground = Ground::Lattice { size: [9, 9], base: 100.0, step: 0.05, counts };
    if index == [1, 3] {
        let vertex = |i: usize, j: usize| {
            Vec3::new(i as f64 * 30.0, 240.0 - j as f64 * 30.0, 100.0 + 0.05 * f64::from(at(i, j)))
        };
        let vertices = (0..81).map(|at| vertex(at % 9, at / 9)).collect();
        let squares = (0..8).flat_map(|j| (0..8).map(move |i| (j * 9 + i) as u32));
        let both = squares.flat_map(|nw| [([nw, nw + 9, nw + 10], None), ([nw, nw + 10, nw + 1], Some(0))]);
        ground = Ground::Mesh { vertices, triangles: both.collect() };
    }
    let state = StandState {
        year: None,
        species: (index[0] & 1) as u16,
        height: Spread { mean: 14.0, deviation: 2.0 },
        crown: Spread { mean: 4.0, deviation: 0.5 },
        density: 300.0,
        crown_base: None,
        plant: Plant::Poisson,
        picture: None,
        cover: Some(0),
    };
    let outer = vec![[10.0, 0.0], [240.0, 20.0], [220.0, 230.0], [0.0, 240.0]];
    Cell {
        index,
        seed: 0,
        cover: None,
        ground,
        stands: vec![Stand { number: 1, states: vec![state], place }],
        patches: vec![Patch { owner: Owner::Stand(0), outer, holes: vec![], place }],
        trees: vec![],
        lines: vec![],
        place,
    }
}

fn terrain() -> (Cells, Terrain) {
    let cells = area();
    let pictures = pictures(&cells);
    let terrain = Terrain::new(&cells, None, &pictures).expect("an area");
    (cells, terrain)
}

fn view(from: Vec3, at: Vec3, near: f64) -> View {
    let camera = Camera {
        from,
        at,
        up: Vec3::Z,
        angle: 45.0,
        hither: 0.5,
        yon: None,
        resolution: (640, 480),
        place: Place::default(),
    };
    View { observer: Observer::new(&camera, (640, 480)), tolerance: 1.0, near }
}

#[test]
fn heights_are_those_of_the_samples() {
    let (cells, terrain) = terrain();
    assert_eq!((terrain.squares(), terrain.filled()), (8, 1));
    for index in [[0, 0], [2, 3], [4, 2]] {
        let cell = cells.load(index).expect("memory").expect("is there");
        for (i, j) in [(0, 0), (8, 8), (3, 5), (8, 0)] {
            let at = [f64::from(i) * 30.0, 240.0 - f64::from(j) * 30.0];
            let sample = cell.ground.sample(i as usize, j as usize);
            assert!((terrain.height(&cell, at) - sample).abs() < 1e-4, "{index:?} {i} {j}");
        }
        // Between samples: between their heights.
        let found = terrain.height(&cell, [97.0, 131.0]);
        let around = [(3, 3), (4, 3), (3, 4), (4, 4)].map(|(i, j)| cell.ground.sample(i, j));
        assert!(
            (around.iter().fold(f64::MAX, |a, b| a.min(*b))..=around.iter().fold(f64::MIN, |a, b| a.max(*b)))
                .contains(&found)
        );
    }
    let mesh = cells.load([1, 3]).expect("memory").expect("is there");
    let inside = terrain.height(&mesh, [100.0, 100.0]);
    assert!(inside.is_finite() && terrain.height(&mesh, [300.0, 0.0]).is_nan());
    let gone = Cell { index: [3, 1], ..cells.load([0, 0]).expect("memory").expect("is there") };
    assert!(
        terrain.height(&gone, [1.0, 1.0]).is_nan()
            && terrain.range([3, 1]).is_none()
            && terrain.range([9, 9]).is_none()
    );
}

#[test]
fn under_the_feet_faces_are_the_finest_triangles() {
    let (cells, terrain) = terrain();
    let (mut faces, eye) = (Faces::default(), Vec3::new(600.0, 700.0, 140.0));
    terrain.faces(&View { tolerance: 1e-9, ..view(eye, Vec3::new(600.0, 900.0, 100.0), 2000.0) }, &mut faces);
    let mut compared = 0;
    for face in &faces.faces {
        let corners: Vec<Vec3> = faces.outline(face).iter().map(|&at| faces.corners[at as usize].position).collect();
        let middle = corners.iter().sum::<Vec3>() / corners.len() as f64;
        let largest = corners.iter().map(|corner| (*corner - middle).truncate().length()).fold(0.0, f64::max);
        let index = cells.head().cell_at([middle.x, middle.y]);
        let Some(cell) = cells.load(index).expect("memory").filter(|_| largest < 25.0) else { continue };
        let corner = cells.head().corner(index);
        let height = terrain.height(&cell, [middle.x - corner.x, middle.y - corner.y]);
        assert!((height - middle.z).abs() < 1e-3, "{middle}: {height}");
        compared += 1;
    }
    assert!(compared > 200, "{compared}");
}

#[test]
fn every_edge_inside_is_used_twice_and_borders_are_those_of_cells() {
    let (_, terrain) = terrain();
    let mut faces = Faces::default();
    let eyes = [
        (Vec3::new(600.0, 600.0, 150.0), Vec3::new(900.0, 800.0, 100.0)),
        (Vec3::new(480.0, 480.0, 120.0), Vec3::new(480.0, 480.0, 0.0)),
        (Vec3::new(0.0, 0.0, 160.0), Vec3::new(600.0, 600.0, 100.0)),
        (Vec3::new(1e6, 1e6, 1e6), Vec3::ZERO),
        (Vec3::new(600.0, 600.0, 3000.0), Vec3::new(600.0, 601.0, 0.0)),
    ];
    for (eye, at) in eyes {
        for near in [0.0, 300.0, 5000.0] {
            terrain.faces(&view(eye, at, near), &mut faces);
            assert!(faces.faces.len() > 2 && faces.corners.iter().all(|corner| corner.position.is_finite()));
            let mut uses: HashMap<(u32, u32), u32> = HashMap::new();
            for face in &faces.faces {
                for (&a, &b) in edges(faces.outline(face)) {
                    *uses.entry((a.min(b), a.max(b))).or_default() += 1;
                }
            }
            for ((a, b), count) in uses {
                assert!(count <= 2, "an edge of {count} faces");
                let [a, b] = [a, b].map(|at| faces.corners[at as usize].position);
                let on_border = |axis: usize| a[axis] == b[axis] && a[axis] % 240.0 == 0.0;
                assert!(count == 2 || on_border(0) || on_border(1), "a crack from {a} to {b}, eye {eye}, near {near}");
            }
        }
    }
}

#[test]
fn no_face_lies_over_a_missing_cell_nor_over_a_mesh_nearby() {
    let (_, terrain) = terrain();
    let mut faces = Faces::default();
    for (near, is_mesh_drawn) in [(5000.0, false), (0.0, true)] {
        terrain.faces(&view(Vec3::new(500.0, -2000.0, 900.0), Vec3::new(600.0, 600.0, 100.0), near), &mut faces);
        let over = |cell: CellIndex| {
            let is_over = |face: &&relief::Face| {
                let corners = faces.outline(face).iter().map(|&at| faces.corners[at as usize].position);
                let middle = corners.sum::<Vec3>() / f64::from(face.count);
                [middle.x, middle.y].map(|metres| (metres / 240.0).floor() as i32) == cell
            };
            faces.faces.iter().filter(is_over).count()
        };
        assert_eq!(over([3, 1]), 0);
        assert_eq!(over([1, 3]) > 0, is_mesh_drawn, "near {near}");
        assert!(over([2, 2]) > 0);
    }
}

#[test]
fn faces_depend_on_the_eye_alone() {
    let (_, terrain) = terrain();
    let (mut walked, mut jumped) = (Faces::default(), Faces::default());
    let eye = |step: usize| view(Vec3::new(100.0 * step as f64, 500.0, 150.0), Vec3::new(600.0, 1000.0, 100.0), 400.0);
    (0..9).for_each(|step| terrain.faces(&eye(step), &mut walked));
    terrain.faces(&eye(8), &mut jumped);
    assert!(walked.faces == jumped.faces && walked.corners == jumped.corners && walked.outlines == jumped.outlines);
}

const SIZE: (u32, u32) = (320, 240);

fn composer(cells: &Cells, choices: Choices) -> Composer<'_> {
    let pictures = pictures(cells);
    Composer::new(cells, pictures, choices).expect("an area")
}

fn choices() -> Choices {
    Choices { horizon: 500.0, ..Choices::default() }
}

fn camera(from: Vec3, at: Vec3) -> Camera {
    let place = Place::default();
    Camera { from, at, up: Vec3::Z, angle: 60.0, hither: 0.2, yon: None, resolution: SIZE, place }
}

/// Over cell borders, diagonally, and a jump at the end.
fn path() -> Vec<Camera> {
    let step = |index: usize| {
        let at = Vec3::new(430.0 + 20.0 * index as f64, 460.0 + 9.0 * index as f64, 160.0);
        camera(at, at + Vec3::new(1.0, 0.5, -0.2))
    };
    let jump = Vec3::new(1100.0, 1100.0, 140.0);
    (0..7).map(step).chain([camera(jump, Vec3::new(600.0, 600.0, 100.0))]).collect()
}

fn shown(composer: &mut Composer<'_>, camera: &Camera) -> (Vec<Surface>, FrameCounts) {
    let (scene, counts) = composer.compose(camera, SIZE).expect("in memory");
    let counts = FrameCounts { loaded: 0, cells: 0, trees: 0, out_of_view: 0, ..counts };
    (scene.surfaces.clone(), counts)
}

fn check(scene: &Scene) {
    for surface in &scene.surfaces {
        let mesh = &surface.mesh;
        assert!(mesh.vertices.iter().chain(&mesh.normals).chain(&mesh.texture).all(|vector| vector.is_finite()));
        assert!(mesh.outlines.iter().all(|&at| (at as usize) < mesh.vertices.len()));
        assert!([0, mesh.vertices.len()].contains(&mesh.texture.len()));
        assert!([0, mesh.vertices.len()].contains(&mesh.normals.len()));
        assert!([0, mesh.vertices.len()].contains(&mesh.colors.len()));
        assert!(surface.material.texture.is_none_or(|id| (id.0 as usize) < scene.textures.len()));
    }
}

#[test]
fn a_path_played_twice_and_backwards_gives_the_same_scenes() {
    let cells = area();
    let (mut first, mut second) = (composer(&cells, choices()), composer(&cells, choices()));
    let path = path();
    let forward: Vec<_> = path.iter().map(|camera| shown(&mut first, camera)).collect();
    assert!(forward.iter().all(|(_, counts)| counts.submitted > 50 && counts.terrain_polygons > 20));
    for (camera, expected) in path.iter().zip(&forward).rev() {
        assert!(shown(&mut second, camera) == *expected, "backwards, at {}", camera.from);
    }
    for (camera, expected) in path.iter().zip(&forward) {
        assert!(shown(&mut first, camera) == *expected, "again, at {}", camera.from);
    }
}

#[test]
fn extreme_eyes_make_whole_scenes() {
    let cells = area();
    for trees in [Trees::Auto, Trees::Crossed, Trees::Billboards] {
        let mut composer = composer(&cells, Choices { trees, ..choices() });
        let mut stock = Stock::new(cells.head(), None, (500.0, 1), 0);
        let pictures = pictures(&cells);
        stock.follow(&cells, composer.terrain(), &pictures, path()[0].from).expect("in memory");
        let stocked = stock.at([1, 1]).expect("near");
        let tree = stocked.trees()[7];
        let [x, y] = tree.at(240.0);
        let foot = Vec3::new(240.0 + x, 240.0 + y, tree.height_above_sea(stocked.base));
        let eyes = [
            (foot, foot + Vec3::X),
            (foot + Vec3::Z * 3.0, foot),
            (Vec3::new(480.0, 480.0, 150.0), Vec3::new(480.0, 480.0, 0.0)),
            (Vec3::new(1e6, -1e6, 1e6), Vec3::ZERO),
            (Vec3::new(600.0, 600.0, 1e6), Vec3::new(600.0, 600.0, 0.0)),
            (Vec3::new(f64::NAN, 0.0, 0.0), Vec3::X),
            (Vec3::new(1e300, 0.0, 0.0), Vec3::X),
        ];
        for (from, at) in eyes {
            let (scene, _) = composer.compose(&camera(from, at), SIZE).expect("in memory");
            check(scene);
        }
    }
}

#[test]
fn counts_add_up_and_near_trees_come_first() {
    let cells = area();
    let mut composer = composer(&cells, choices());
    let ground = ground_at(&cells, composer.terrain(), [490.0, 487.0]);
    let eye = Vec3::new(490.0, 487.0, ground + 4.0);
    let camera = camera(eye, eye + Vec3::new(1.0, 0.5, 0.0));
    let (scene, counts) = composer.compose(&camera, SIZE).expect("in memory");
    check(scene);
    assert_eq!(counts.trees, counts.out_of_view + counts.hidden + counts.submitted);
    let polygons: usize = scene.surfaces.iter().map(|surface| surface.mesh.polygons.len()).sum();
    assert_eq!(polygons as u64, counts.tree_polygons + counts.terrain_polygons);
    assert!(counts.crossed > 0 && counts.facing > 0, "{counts:?}");
    let mut all =
        Composer::new(&cells, pictures(&cells), Choices { trees: Trees::Crossed, ..choices() }).expect("an area");
    let (_, whole) = all.compose(&camera, SIZE).expect("in memory");
    assert_eq!((whole.submitted, whole.tree_polygons), (counts.submitted, 2 * counts.submitted));
}

#[test]
fn near_trees_are_meshes_where_that_is_asked_for_and_far_ones_stay() {
    let cells = area();
    let solid_above = Some(60.0);
    let (mut usual, mut near) = (composer(&cells, choices()), composer(&cells, Choices { solid_above, ..choices() }));
    let ground = ground_at(&cells, usual.terrain(), [490.0, 487.0]);
    let eye = Vec3::new(490.0, 487.0, ground + 4.0);
    let camera = camera(eye, eye + Vec3::new(1.0, 0.5, 0.0));
    let (_, before) = usual.compose(&camera, SIZE).expect("in memory");
    let (scene, counts) = near.compose(&camera, SIZE).expect("in memory");
    check(scene);
    assert!(counts.solid > 0 && counts.solid_triangles == counts.solid * 276, "{counts:?}");
    assert!(counts.crossed < before.crossed, "{counts:?}");
    let far = |counts: &FrameCounts| (counts.submitted, counts.facing, counts.narrow, counts.thinned);
    assert_eq!(far(&counts), far(&before));
    let plan = farop::plan::Choices::default();
    let slow = render(scene, &plan, Some(&farop::raster::ZBuffer)).expect("a view").image;
    assert!(slow == render(scene, &plan, Some(&Fast::default())).expect("a view").image, "all rasterizers agree");
    let lit = scene.surfaces.iter().filter(|surface| surface.two_sided && surface.material.diffuse > 0.0);
    let triangles: usize = lit.map(|surface| surface.mesh.polygons.len()).sum();
    assert_eq!(triangles as u64, counts.solid_triangles, "meshes and no other trees have the scene's light");
}

#[test]
fn frames_share_memory() {
    let cells = area();
    let mut composer = composer(&cells, choices());
    for _ in 0..2 {
        for camera in path() {
            composer.compose(&camera, SIZE).expect("in memory");
        }
    }
    let camera = path()[2];
    let memory = |scene: &Scene| {
        let of = |surface: &Surface| (surface.mesh.vertices.as_ptr(), surface.mesh.vertices.capacity());
        scene.surfaces.iter().map(of).collect::<Vec<_>>()
    };
    composer.compose(&camera, SIZE).expect("in memory");
    let before = memory(composer.compose(&camera, SIZE).expect("in memory").0);
    assert!(memory(composer.compose(&camera, SIZE).expect("in memory").0) == before, "something was allocated anew");
    assert!(before.len() > 3);
}

#[test]
fn what_is_no_choice_is_refused() {
    let cells = area();
    for choices in [
        Choices { horizon: f64::NAN, ..choices() },
        Choices { horizon: 1e9, ..choices() },
        Choices { tolerance: 0.0, ..choices() },
        Choices { threshold: 2.0, ..choices() },
        Choices { solid_above: Some(20.0), ..choices() },
        Choices { solid_above: Some(f64::NAN), ..choices() },
    ] {
        let pictures = pictures(&cells);
        let error = Composer::new(&cells, pictures, choices).err().expect("refused");
        assert!(matches!(error, FrameError::Choice { .. }), "{error}");
    }
    let empty = Cells::Loaded(Area::default());
    let error = Composer::new(&empty, Pictures::new(empty.head(), Path::new(".")).expect("none"), choices());
    assert!(matches!(error.err(), Some(FrameError::Terrain(_))));
}

#[test]
fn what_land_hides_no_picture_shows() {
    let cells = area();
    let (mut with, mut without) =
        (composer(&cells, choices()), composer(&cells, Choices { hiding: false, ..choices() }));
    let mut hidden = 0;
    for step in 0..6 {
        // Low in the valleys between the hills.
        let at = Vec3::new(250.0 + 140.0 * f64::from(step), 300.0 + 90.0 * f64::from(step), 85.0);
        let eye = Vec3::new(at.x, at.y, ground_at(&cells, with.terrain(), [at.x, at.y]) + 1.7);
        let camera = camera(eye, eye + Vec3::new(cos(f64::from(step)), sin(f64::from(step)), 0.0));
        let size = (160, 120);
        let plan = farop::plan::Choices::default();
        let (scene, counts) = with.compose(&camera, size).expect("in memory");
        let picture = render(scene, &plan, Some(&Fast::default())).expect("a view").image;
        hidden += counts.hidden;
        let (scene, all) = without.compose(&camera, size).expect("in memory");
        assert!(all.hidden == 0 && all.submitted >= counts.submitted);
        assert!(picture == render(scene, &plan, Some(&Fast::default())).expect("a view").image, "step {step}");
    }
    assert!(hidden > 0);
}

#[test]
fn every_look_of_ground_and_trees_is_drawn_alike_by_all() {
    let cells = area();
    for (trees, ground) in [(Trees::Auto, GroundLook::Pictures), (Trees::None, GroundLook::Colors)] {
        let mut composer = composer(&cells, Choices { trees, ground, ..choices() });
        let (scene, _) = composer.compose(&path()[2], (96, 72)).expect("in memory");
        let plan = farop::plan::Choices::default();
        let zbuffer = farop::raster::ZBuffer;
        let slow = render(scene, &plan, Some(&zbuffer)).expect("a view").image;
        assert!(slow == render(scene, &plan, Some(&Fast::default())).expect("a view").image);
    }
}

fn ground_at(cells: &Cells, terrain: &Terrain, at: [f64; 2]) -> f64 {
    let index = cells.head().cell_at(at);
    let cell = cells.load(index).expect("memory").expect("is there");
    let corner = cells.head().corner(index);
    terrain.height(&cell, [at[0] - corner.x, at[1] - corner.y])
}
