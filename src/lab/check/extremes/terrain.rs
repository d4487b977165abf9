//! Items 97 to 100: reliefs and forests.

use super::tools::{draw, ensure};
use super::{Effort, Item, Outcome, Trial::Run};
use crate::color::Rgb;
use crate::forest::elevation::{Frame, Grid, Unit};
use crate::forest::relief::criterion::{Criterion, FromEye, Observer, Spheres};
use crate::forest::relief::fictitious::{Seams, fictitious};
use crate::forest::relief::frontier::Frontier;
use crate::forest::relief::lattice::level;
use crate::forest::relief::mesh::edge_uses;
use crate::forest::relief::scene::{Colors, from_above, to_scene};
use crate::forest::relief::{Hierarchy, Point, ReliefMesh, Triangle, mesh, quality};
use crate::lab::check::Random;
use crate::math::{Affine3, Vec3};
use crate::plan::{Choices, Culling, DepthFormat, Shading};
use crate::scene::{Camera, Light, Material, Mesh, NormalSource, Object, ObjectId, Place, Scene, Surface, SurfaceId};

pub(super) const ITEMS: &[Item] = &[
    (97, "a flat heightfield, and one that is a cliff", Run(|_| flat_and_cliff())),
    (98, "seams between levels of detail: no cracks at any pair", Run(|_| level_pairs())),
    (99, "a horizon 1e6 m away", Run(|_| horizon())),
    (100, "1e6 trees, whatever their order", Run(trees)),
];

/// A square of samples, `step` metres apart.
fn grid(side: usize, step: f64, height: impl Fn(usize, usize) -> f32) -> Result<Grid, String> {
    let frame = Frame { unit: Unit::Metres, west: 0.0, north: step * (side - 1) as f64, step: [step, step] };
    let heights = (0..side * side).map(|at| height(at % side, at / side)).collect();
    Grid::new("extreme", (side, side), heights, frame).map_err(|error| error.to_string())
}

fn choices() -> Choices {
    Choices { shading: Shading::Flat, culling: Culling::None, ..Choices::default() }
}

/// The color behind the relief: no relief is that.
const BEHIND: Rgb = Rgb::new(1.0, 0.0, 1.0);

/// Pixels that show what is behind the relief, row by row.
fn holes(grid: &Grid, mesh: &ReliefMesh, camera: Camera) -> Result<Vec<usize>, String> {
    let scene = Scene { camera: Some(camera), background: Some(BEHIND), ..to_scene(grid, mesh, &Colors::Plain) };
    let drawn = draw(&scene, &choices())?;
    let row = |y: usize| drawn.image.row(y).iter().filter(|light| light.g == 0.0 && light.r > 0.5).count();
    Ok((0..drawn.image.height()).map(row).collect())
}

/// A camera above the middle that sees nothing beyond the borders.
fn within(grid: &Grid) -> Camera {
    let camera = from_above(grid);
    Camera { from: camera.at + (camera.from - camera.at) * 0.8, resolution: (96, 96), ..camera }
}

fn flat_and_cliff() -> Outcome {
    let flat = grid(65, 30.0, |_, _| 1234.5)?;
    let whole = mesh::within(&Hierarchy::new(&flat), 0.0);
    ensure(whole.triangles() == 2, format!("flat land takes {} triangles", whole.triangles()))?;
    ensure(holes(&flat, &whole, within(&flat))?.iter().sum::<usize>() == 0, "a hole in flat land")?;
    for rise in [1e3, 1e6, 1e30] {
        let cliff = grid(65, 30.0, |x, y| if 3 * x + y > 97 { rise } else { 0.0 })?;
        let hierarchy = Hierarchy::new(&cliff);
        let error = f64::from(rise) / 8.0;
        let relief = mesh::within(&hierarchy, error);
        let found = quality(&cliff, &relief);
        ensure(found.largest <= error && found.uncovered == 0, format!("a cliff of {rise} m: {found:?}"))?;
        ensure(edge_uses(&relief).values().all(|&uses| uses <= 2), "an edge with three sides")?;
        if rise < 1e5 {
            ensure(holes(&cliff, &relief, within(&cliff))?.iter().sum::<usize>() == 0, "a hole in the cliff")?;
        }
    }
    Ok(())
}

/// West of the middle down to one level, elsewhere to another: forced halves, and vertices given to both sides.
fn level_pairs() -> Outcome {
    let hills = grid(33, 30.0, |x, y| ((x * 37 + y * 61 + x * y) % 29) as f32)?;
    let hierarchy = Hierarchy::new(&hills);
    let camera = within(&hills);
    for fine in 0..10 {
        for coarse in fine..=10 {
            let is_wanted = |middle: Point| level(middle) >= if middle.x < 14 { fine } else { coarse };
            let mut frontier = Frontier::new(&hierarchy);
            hierarchy.lattice.from_the_smallest(|middle| {
                if is_wanted(middle) {
                    frontier.halve(middle);
                }
            });
            let stitched =
                fictitious(&hierarchy, |triangle: &Triangle| is_wanted(triangle.middle()), Seams::Stitched).mesh;
            for (name, mesh) in [("forced", frontier.mesh()), ("stitched", stitched)] {
                let holes: usize = holes(&hills, &mesh, camera)?.iter().sum();
                ensure(holes == 0, format!("levels {fine} and {coarse}, {name}: {holes} holes"))?;
            }
        }
    }
    Ok(())
}

fn horizon() -> Outcome {
    // Two million metres a side, the eye in the middle, 2 m above land that is nowhere higher than 1 m.
    let land = grid(257, 7812.5, |x, y| ((x * 7 + y * 13) % 11) as f32 / 10.0)?;
    let hierarchy = Hierarchy::new(&land);
    let spheres = Spheres::new(&hierarchy);
    let eye = Vec3::new(1e6, 1e6, 2.0);
    let mut camera = from_above(&land);
    (camera.from, camera.at, camera.up) = (eye, eye + Vec3::Y, Vec3::Z);
    (camera.angle, camera.hither, camera.resolution) = (60.0, 0.01, (96, 96));
    let criterion = FromEye {
        hierarchy: &hierarchy,
        spheres: &spheres,
        observer: Observer::new(&camera, camera.resolution),
        tolerance: 0.01,
    };
    let mut frontier = Frontier::new(&hierarchy);
    frontier.follow(&criterion, usize::MAX);
    let relief = frontier.mesh();
    ensure(relief == mesh::mesh(&hierarchy, |middle| criterion.score(middle) > 1.0), "not the mesh from scratch")?;
    let rows = holes(&land, &relief, camera)?;
    // The horizon is 2e-6 below the middle: every row below it is land, every row above is sky.
    let wrong = rows.iter().enumerate().position(|(y, &holes)| holes != if y < 48 { 96 } else { 0 });
    ensure(wrong.is_none(), format!("row {wrong:?} is neither land nor sky"))
}

/// Two crossed triangles, as instances; drawn in three orders.
fn trees(effort: &Effort) -> Outcome {
    let count = effort.count(20_000, 1_000_000) as u32;
    let mut random = effort.random(100);
    let mut scene = forest(count, &mut random);
    // In f64 no two trees are equally far at a sample; in f32 of so many some are, and then the first one wins.
    let choices = Choices { depth: DepthFormat::F64, ..choices() };
    let order: Vec<ObjectId> = (0..count).map(ObjectId).collect();
    let reversed: Vec<ObjectId> = order.iter().rev().copied().collect();
    let mut pictures = Vec::new();
    for children in [order.clone(), reversed, shuffled(order, &mut random)] {
        scene.objects[count as usize].children = children;
        let drawn = draw(&scene, &choices)?;
        ensure(drawn.counts.objects == u64::from(count) + 1, "not all trees are walked")?;
        pictures.push(drawn.image);
    }
    let lit = pictures[0].pixels().iter().filter(|light| light.g > 0.0).count();
    ensure(lit > 500, format!("only {lit} pixels show trees"))?;
    ensure(pictures.iter().all(|picture| *picture == pictures[0]), "another order, another picture")
}

/// That many trees before the eye; the last object is to have them as children.
fn forest(count: u32, random: &mut Random) -> Scene {
    let mut tree = Mesh::default();
    for across in [Vec3::X, Vec3::Y] {
        let corners = [-across, across, Vec3::Z * 6.0].map(|corner| tree.push_vertex(corner));
        tree.push_polygon(&corners, NormalSource::Facet, 1);
    }
    let place = Place::default();
    let surface = Surface { material: Material::default(), mesh: tree, primitives: Vec::new(), two_sided: true, place };
    let object = |parent_from_local: Affine3, surfaces: Vec<SurfaceId>| Object {
        name: String::new(),
        parent_from_local,
        surfaces,
        children: Vec::new(),
        place,
    };
    // About as dense as a young forest, however many there are.
    let reach = 2.0 * f64::from(count).sqrt();
    let mut objects: Vec<Object> = (0..count)
        .map(|_| {
            let (x, y) = (random.between(-reach, reach), random.between(5.0, 2.0 * reach));
            object(Affine3::from_translation(Vec3::new(x, y, random.between(-3.0, 0.0))), vec![SurfaceId(0)])
        })
        .collect();
    objects.push(object(Affine3::IDENTITY, Vec::new()));
    let (from, at, up) = (Vec3::new(0.0, 0.0, 4.0), Vec3::new(0.0, 10.0, 3.5), Vec3::Z);
    Scene {
        objects,
        surfaces: vec![surface],
        world: vec![ObjectId(count)],
        lights: vec![Light::point(Vec3::new(-300.0, -200.0, 500.0), Rgb::WHITE, place)],
        camera: Some(Camera { from, at, up, angle: 60.0, hither: 0.1, yon: None, resolution: (64, 64), place }),
        ..Scene::default()
    }
}

fn shuffled(mut order: Vec<ObjectId>, random: &mut Random) -> Vec<ObjectId> {
    for at in (1..order.len()).rev() {
        order.swap(at, random.below(at as u64 + 1) as usize);
    }
    order
}
