//! Seams: meshes that cover the picture, or a band of its rows, must cover every sample exactly once.
//!
//! Grids with shaken corners, fans and strips of triangles, and strips between jagged chains (concave) reach beyond all four
//! sides; half of them are cut at hither and yon, too. They run through the geometry stage, whole or split into triangles. Then
//! every polygon gets a constant depth nearer than that of the one before, so the z-buffer puts every sample of each, and
//! puts and overdraw are holes and doubles. No judge is needed: once is once.
//!
//! Planes of constant 1/w are tilted about the horizontal axis, so that hither and yon cut along rows of the picture.
//! Where snapping turned a polygon round, once is not what even-odd gives: such pictures are counted and left out.

use super::scenes::{camera, draw, scene, stack, world};
use super::tally::{Tally, sum};
use super::{Effort, Random, Report};
use crate::math::{PI, Vec3, cos, sin};
use crate::plan::{Accepts, Choices, Culling, Plan, Shading};
use crate::raster::{Watkins, ZBuffer};
use crate::scene::{Material, Mesh, NormalSource};
use crate::screen::{DrawList, EdgeKind};

/// Draws meshes and counts.
pub(super) fn run(effort: &Effort, report: &mut Report) {
    let meshes = effort.count(2_500, 100_000);
    let tally = sum(meshes, |number, tally| mesh(number, &mut effort.random(number), tally));
    report.count("meshes", meshes);
    report.count("samples", tally.of("samples"));
    report.count("screen polygons", tally.of("polygons"));
    report.some("shared edges", tally.of("shared edges"));
    report.some("polygons cut by a plane", tally.of("cut"));
    report.some("concave polygons", tally.of("concave"));
    report.some("diagonals of splitting", tally.of("diagonals"));
    report.some("meshes cut at hither and yon", tally.of("bands"));
    report.count("meshes left out, a polygon turned by snapping", tally.of("turned"));
    report.none("polygons lost", tally.of("lost"));
    report.none("holes", tally.of("holes"));
    report.none("doubles", tally.of("doubles"));
    report.none("samples that Watkins leaves open", tally.of("open"));
    report.none("samples that depend on threads", tally.of("threads"));
    tally.examples.iter().for_each(|example| report.miss(example));
}

/// The plane 1/w = 1 + tilt y/w, as a place for meshes.
#[derive(Clone, Copy)]
struct Tilted(f64);

impl Tilted {
    /// The eye-space point that is seen at (x, y), in half pictures from the middle, y up.
    fn at(self, x: f64, y: f64) -> Vec3 {
        Vec3::new(x, y, 1.0) / (1.0 + self.0 * y)
    }
}

fn mesh(number: u64, random: &mut Random, tally: &mut Tally) {
    let side = 16 << random.below(4);
    let plane = Tilted(random.between(0.05, 0.2));
    let mesh = match number % 4 {
        0 => grid(random, plane),
        1 => fan(random, plane),
        2 => strips(random, plane, 0.0),
        _ => strips(random, plane, 0.7),
    };
    let mut view = camera(side, side);
    let mut rows = (0.0, f64::from(side));
    if random.once_in(2) {
        let (low, high) = (random.between(-0.9, -0.1), random.between(0.1, 0.9));
        (view.hither, view.yon) = (plane.at(0.0, high).z, Some(plane.at(0.0, low).z));
        rows = ((1.0 - high) * f64::from(side) / 2.0, (1.0 - low) * f64::from(side) / 2.0);
        tally.add("bands", 1);
    }
    let choices = Choices {
        shading: Shading::Flat,
        subpixel_bits: [8, 0, 4, 12, 16][random.below(5) as usize],
        triangles: random.once_in(2),
        culling: Culling::None,
        ..Choices::default()
    };
    let inner_edges = shared_by_polygons(&mesh);
    let scene = scene(view, Material::default(), mesh, true);
    let Ok(plan) = Plan::new(&scene, &choices, Accepts::AnyPolygon) else { return };
    let mut list = DrawList::new(0, 0);
    let counts = crate::geometry::run(&scene, &plan, &mut list);
    if is_turned(&list) {
        tally.add("turned", 1);
        return;
    }
    // Every triangle has at most three edges; a diagonal is in two.
    let edges = |kind| list.vertices.iter().filter(|vertex| vertex.edge == kind).count() as u64;
    let diagonals = edges(EdgeKind::Diagonal) / 2;
    tally.add("diagonals", diagonals);
    tally.add("shared edges", inner_edges + diagonals);
    tally.add("cut", counts.cut);
    tally.add("concave", u64::from(number % 4 == 3) * counts.rendered);
    tally.add("lost", counts.skipped);
    let rows = (list.grid.snap(rows.0), list.grid.snap(rows.1));
    judge(&mut list, rows, tally);
}

/// Counts samples that are covered otherwise than once between two heights, and not at all elsewhere.
fn judge(list: &mut DrawList, rows: (f64, f64), tally: &mut Tally) {
    stack(list);
    let drawn = draw(list, &ZBuffer, 1);
    // A row belongs to the band when its center is at or below the upper end and above the lower one.
    let within = |index: usize| {
        let center = (index / list.width as usize) as f64 + 0.5;
        rows.0 <= center && center < rows.1
    };
    let holes = |owner: &[Option<u32>]| {
        owner.iter().enumerate().filter(|&(index, owner)| within(index) && owner.is_none()).count() as u64
    };
    let outside = drawn.owner.iter().enumerate().filter(|&(index, owner)| !within(index) && owner.is_some());
    let (holes_here, doubles) = (holes(&drawn.owner), drawn.puts.overdraw + outside.count() as u64);
    tally.add("samples", drawn.owner.len() as u64);
    tally.add("polygons", list.len() as u64);
    tally.add("holes", holes_here);
    tally.add("doubles", doubles);
    if holes_here + doubles > 0 {
        let (width, bits) = (list.width, list.grid.bits);
        tally.example(|| format!("{holes_here} holes, {doubles} doubles, {width} samples wide, {bits} bits"));
    }
    tally.add("open", holes(&draw(list, &Watkins, 1).owner));
    let threaded = draw(list, &ZBuffer, 3).owner;
    tally.add("threads", threaded.iter().zip(&drawn.owner).filter(|(a, b)| a != b).count() as u64);
}

/// Whether polygons turn both ways, by the doubled areas of their snapped outlines.
fn is_turned(list: &DrawList) -> bool {
    let areas = list.polygons().map(|polygon| {
        let corners: Vec<(i64, i64)> =
            polygon.vertices().iter().map(|v| (list.grid.fixed(v.x), list.grid.fixed(v.y))).collect();
        crate::math::edges(&corners).map(|(a, b)| a.0 * b.1 - b.0 * a.1).sum::<i64>()
    });
    let (mut left, mut right) = (false, false);
    areas.for_each(|area| {
        left |= area < 0;
        right |= area > 0;
    });
    left && right
}

/// Edges that two polygons of the mesh walk.
fn shared_by_polygons(mesh: &Mesh) -> u64 {
    let mut edges: Vec<(u32, u32)> = Vec::new();
    for polygon in &mesh.polygons {
        let outline = mesh.outline(polygon);
        edges.extend(crate::math::edges(outline).map(|(&a, &b)| (a.min(b), a.max(b))));
    }
    edges.sort_unstable();
    edges.windows(2).filter(|pair| pair[0] == pair[1]).count() as u64
}

/// Two triangles a cell over shaken corners, far beyond all sides.
fn grid(random: &mut Random, plane: Tilted) -> Mesh {
    let cells = 3 + random.below(9) as u32;
    let mut mesh = Mesh::default();
    for index in 0..(cells + 1) * (cells + 1) {
        let mut along = |i: u32| ((f64::from(i) + random.between(-0.25, 0.25)) / f64::from(cells) * 2.0 - 1.0) * 2.2;
        mesh.push_vertex(world(plane.at(along(index % (cells + 1)), along(index / (cells + 1)))));
    }
    for index in (0..cells * (cells + 1)).filter(|index| index % (cells + 1) < cells) {
        let [p, q, r, s] = [index, index + 1, index + cells + 2, index + cells + 1];
        let halves = if random.once_in(2) { [[p, q, r], [p, r, s]] } else { [[p, q, s], [q, r, s]] };
        halves.iter().for_each(|half| mesh.push_polygon(half, NormalSource::Facet, 1));
    }
    mesh
}

/// Triangles around a hub in the picture, or just beside it.
fn fan(random: &mut Random, plane: Tilted) -> Mesh {
    let spokes = 9 + random.below(120) as u32;
    let mut mesh = Mesh::default();
    let hub = (random.between(-0.5, 0.5), random.between(-0.5, 0.5));
    mesh.push_vertex(world(plane.at(hub.0, hub.1)));
    for spoke in 0..spokes {
        let angle = (f64::from(spoke) + random.between(0.0, 0.5)) / f64::from(spokes) * 2.0 * PI;
        // Far enough that even the chord between two spokes stays outside the picture.
        let radius = random.between(2.6, 3.1);
        mesh.push_vertex(world(plane.at(hub.0 + radius * cos(angle), hub.1 + radius * sin(angle))));
    }
    for spoke in 0..spokes {
        mesh.push_polygon(&[0, 1 + spoke, 1 + (spoke + 1) % spokes], NormalSource::Facet, 1);
    }
    mesh
}

/// Polygons between neighboring chains from left to right; `jag` is how far a chain swings, in half pictures.
fn strips(random: &mut Random, plane: Tilted, jag: f64) -> Mesh {
    let (chains, links) = (3 + random.below(8) as u32, 2 + random.below(30) as u32);
    let swing: Vec<f64> = (0..=links).map(|_| random.between(-jag, jag)).collect();
    let mut mesh = Mesh::default();
    for chain in 0..chains {
        for link in 0..=links {
            // All chains swing alike, and the shake is less than their distance: they never meet.
            let y = (f64::from(chain) + random.between(-0.4, 0.4)) / f64::from(chains - 1) * 2.0 - 1.0;
            let x = f64::from(link) / f64::from(links) * 2.0 - 1.0;
            let reach = if chain == 0 || chain + 1 == chains { 3.0 } else { 2.1 };
            mesh.push_vertex(world(plane.at(x * 2.2, y * reach + swing[link as usize])));
        }
    }
    for chain in 0..chains - 1 {
        let at = |chain: u32, link: u32| chain * (links + 1) + link;
        let outline: Vec<u32> =
            (0..=links).map(|link| at(chain, link)).chain((0..=links).rev().map(|link| at(chain + 1, link))).collect();
        mesh.push_polygon(&outline, NormalSource::Facet, 1);
    }
    mesh
}
