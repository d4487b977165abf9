//! Relief: meshes of random land keep their bound and have no cracks; and what T-junctions cost, which the default does not have.
//!
//! Random land, of sizes that are no powers of two and with voids, goes through the hierarchy. The report of a mesh counts all samples
//! afresh; edges are counted by their ends. A frontier that walks must be the mesh from scratch at every step.
//!
//! T-junctions: an edge of given length on the screen, a triangle on one side, two on the other that meet in its exact middle. All
//! corners are snapped, so the middle leaves the edge, and samples between are covered by neither side. Expected are
//! L times E|offset| / 4 samples an edge of length L; with the vertex in both outlines there must be none.

use super::scenes::{camera, draw, scene, world};
use super::tally::{Tally, sum};
use super::{Effort, Random, Report};
use crate::forest::elevation::{Frame, Grid, Unit};
use crate::forest::relief::criterion::{Criterion, FromEye, Observer, Spheres};
use crate::forest::relief::fictitious::{self, Seams};
use crate::forest::relief::frontier::Frontier;
use crate::forest::relief::mesh::edge_uses;
use crate::forest::relief::{Hierarchy, ReliefMesh, mesh, quality};
use crate::math::{PI, Vec3, cos, sin};
use crate::plan::{Accepts, Choices, Culling, Plan, Shading};
use crate::raster::ZBuffer;
use crate::scene::{Camera, Material, Mesh, NormalSource, Place};
use crate::screen::DrawList;

/// Makes meshes and counts, then measures T-junctions.
pub(super) fn run(effort: &Effort, report: &mut Report) {
    let lands = effort.count(400, 4_000);
    let tally = sum(lands, |number, tally| land(number, &mut effort.random(number), tally));
    report.count("random lands", lands);
    report.some("triangles", tally.of("triangles"));
    report.some("lands with voids", tally.of("voids"));
    report.some("diamonds halved and joined while walking", tally.of("changes"));
    report.some("edges with a fictitious vertex", tally.of("junctions"));
    report.none("meshes farther from a sample than asked", tally.of("too far"));
    report.none("samples under no triangle, without voids", tally.of("uncovered"));
    report.none("edges within that have not two sides", tally.of("cracks"));
    report.none("stitched edges within that have not two sides", tally.of("stitched cracks"));
    report.none("walks that end in another mesh than from scratch", tally.of("walks"));
    tally.examples.iter().for_each(|example| report.miss(example));
    junctions(effort, report);
}

/// Land of random size: waves, noise in one half, perhaps a hole.
fn random_grid(random: &mut Random, has_hole: bool) -> Option<Grid> {
    let (columns, rows) = (2 + random.below(60) as usize, 2 + random.below(60) as usize);
    let (long, steep, rough) = (random.between(4.0, 30.0), random.between(0.0, 300.0), random.between(0.0, 60.0));
    let hole = (random.below(columns as u64) as usize, random.below(rows as u64) as usize);
    let mut heights = Vec::new();
    for at in 0..columns * rows {
        let (x, y) = (at % columns, at / columns);
        let noise = if x > y { random.between(0.0, rough) } else { 0.0 };
        let is_void = has_hole && x.abs_diff(hole.0) + y.abs_diff(hole.1) < 5;
        let height = steep * sin(x as f64 / long) * cos(y as f64 / long) + noise;
        heights.push(if is_void { f32::NAN } else { height as f32 });
    }
    let step = [random.between(5.0, 100.0), random.between(5.0, 100.0)];
    Grid::new("random", (columns, rows), heights, Frame { unit: Unit::Metres, west: 0.0, north: 0.0, step }).ok()
}

fn land(number: u64, random: &mut Random, tally: &mut Tally) {
    let Some(grid) = random_grid(random, number % 4 == 1) else { return };
    let hierarchy = Hierarchy::new(&grid);
    let error = random.between(0.0, 1.0) * random.between(0.0, 200.0);
    let relief = mesh::within(&hierarchy, error);
    let found = quality(&grid, &relief);
    tally.add("triangles", found.triangles as u64);
    tally.add("voids", u64::from(hierarchy.has_voids));
    if found.largest > error {
        tally.add("too far", 1);
        tally.example(|| format!("{} x {}: {} m, asked {error}", grid.columns(), grid.rows(), found.largest));
    }
    let stitched = fictitious::within(&hierarchy, error, Seams::Stitched);
    tally.add("junctions", stitched.junctions as u64);
    if !hierarchy.has_voids {
        tally.add("uncovered", found.uncovered as u64);
        tally.add("cracks", lonely(&hierarchy, &relief));
        tally.add("stitched cracks", lonely(&hierarchy, &stitched.mesh));
    }
    walk(&hierarchy, random, tally);
}

/// Edges within the grid that are not in exactly two faces.
fn lonely(hierarchy: &Hierarchy<'_>, mesh: &ReliefMesh) -> u64 {
    let (east, south) = (hierarchy.lattice.east, hierarchy.lattice.south);
    let is_lonely = |(&(from, to), &uses): (&(u32, u32), &u32)| {
        let [p, q] = [from, to].map(|index| mesh.vertices[index as usize].point);
        let at_border = (p.x == q.x && (p.x == 0 || p.x == east)) || (p.y == q.y && (p.y == 0 || p.y == south));
        uses != if at_border { 1 } else { 2 }
    };
    edge_uses(mesh).iter().filter(|&edge| is_lonely(edge)).count() as u64
}

fn walk(hierarchy: &Hierarchy<'_>, random: &mut Random, tally: &mut Tally) {
    let spheres = Spheres::new(hierarchy);
    let [width, height] = hierarchy.grid.extent();
    let mut frontier = Frontier::new(hierarchy);
    for _ in 0..4 {
        let mut place = |z| Vec3::new(random.between(-0.3, 1.3) * width, random.between(-0.3, 1.3) * height, z);
        let (from, at) = (place(350.0), place(0.0));
        let (up, angle, hither, yon) = (Vec3::Z, 40.0, 1.0, None);
        let camera = Camera { from, at, up, angle, hither, yon, resolution: (640, 480), place: Place::default() };
        let observer = Observer::new(&camera, camera.resolution);
        let criterion = FromEye { hierarchy, spheres: &spheres, observer, tolerance: random.between(0.5, 20.0) };
        let changes = frontier.follow(&criterion, usize::MAX);
        tally.add("changes", (changes.halved + changes.joined) as u64);
        let scratch = mesh::mesh(hierarchy, |middle| criterion.score(middle) > 1.0);
        tally.add("walks", u64::from(frontier.mesh() != scratch));
    }
}

/// Pinholes an edge, for three lengths and two grids of sub-pixels: open as in the paper, and stitched.
fn junctions(effort: &Effort, report: &mut Report) {
    let mut stitched = 0;
    for bits in [4, 8] {
        for length in [8.0, 30.0, 120.0] {
            let edges = effort.count(4_000, 40_000);
            let part = 1 << 32 | u64::from(bits) << 16 | length as u64;
            let tally = sum(edges, |number, tally| {
                junction(&mut effort.random(part + (number << 33)), (length, bits), tally);
            });
            stitched += tally.of("stitched");
            let per_thousand = 1000.0 * tally.of("open") as f64 / edges as f64;
            let name = format!("pinholes per 1000 open T-junctions, edges of {length} px, steps of 1/{} px", 1 << bits);
            // Three corners snapped by up to half a step: the offset has a standard deviation of step * sqrt(1.5 / 12).
            let step = 1.0 / f64::from(1 << bits);
            let expected = 1000.0 * length * 0.8 * step * (1.5_f64 / 12.0).sqrt() / 4.0;
            let spread = 5.0 * (expected / 1000.0 / edges as f64).sqrt() * 1000.0;
            report.within(name, per_thousand, (0.8 * expected - spread, 1.2 * expected + spread));
        }
    }
    report.none("pinholes of stitched edges", stitched);
}

/// One edge somewhere in a picture: how many samples of both sides' outline neither side covers.
fn junction(random: &mut Random, (mean, bits): (f64, u32), tally: &mut Tally) {
    let length = mean * random.between(0.5, 1.5);
    let side = (2.0 * mean) as u32;
    let (turn, half) = (random.between(0.0, 2.0 * PI), length / 2.0);
    let (along, across) = ((cos(turn), sin(turn)), (-sin(turn), cos(turn)));
    let middle = (random.between(-0.5, 0.5), random.between(-0.5, 0.5));
    // Eye space at distance 1: half a picture is 1.
    let scale = 2.0 / f64::from(side);
    let at = |u: f64, v: f64| {
        let (x, y) = (middle.0 + u * along.0 + v * across.0, middle.1 + u * along.1 + v * across.1);
        world(Vec3::new(x * scale, y * scale, 1.0))
    };
    let [a, b, c, d] = [at(-half, 0.0), at(half, 0.0), at(0.0, half * 0.9), at(0.0, -half * 0.9)];
    let m = (a + b) / 2.0;
    let covered = |outlines: &[&[Vec3]]| draw(&list(outlines, side, bits), &ZBuffer, 1).owner;
    let whole = covered(&[&[a, d, b, c]]);
    let missing = |drawn: &[Option<u32>]| {
        whole.iter().zip(drawn).filter(|(whole, drawn)| whole.is_some() && drawn.is_none()).count() as u64
    };
    tally.add("open", missing(&covered(&[&[a, b, c], &[a, d, m], &[m, d, b]])));
    tally.add("stitched", missing(&covered(&[&[a, m, b, c], &[a, d, m], &[m, d, b]])));
}

/// Polygons of a plane before the eye, snapped to `bits`.
fn list(outlines: &[&[Vec3]], side: u32, bits: u32) -> DrawList {
    let mut mesh = Mesh::default();
    for outline in outlines {
        let indices: Vec<u32> = outline.iter().map(|&corner| mesh.push_vertex(corner)).collect();
        mesh.push_polygon(&indices, NormalSource::Facet, 1);
    }
    let scene = scene(camera(side, side), Material::default(), mesh, true);
    let choices = Choices { shading: Shading::Flat, subpixel_bits: bits, culling: Culling::None, ..Choices::default() };
    let mut list = DrawList::new(0, 0);
    if let Ok(plan) = Plan::new(&scene, &choices, Accepts::AnyPolygon) {
        crate::geometry::run(&scene, &plan, &mut list);
    }
    list
}
