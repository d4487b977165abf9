//! Unsnapped: coverage of corners that lie on no grid, near and up to 2^30 pixels away, against exact determinants.
//!
//! The truth is the polygon before clipping, its corners (x w, y w, w) in `f64`, decided by the oracle on raw vertices. On the
//! grids the error is what clipping and snapping cost, in parts per million of the samples that an edge passes. A rasterizer with
//! `--subpixel-bits exact` must agree everywhere with the corners it was given; how many samples the rounding of the
//! view's transform moved before that is counted apart.

use super::scenes::{AREA_RASTERIZERS, camera, draw, scene, world};
use super::tally::{Tally, sum};
use super::{Effort, Random, Report};
use crate::math::{Vec3, pow};
use crate::oracle::exact::{ExactPicture, Rules, judge};
use crate::plan::{Accepts, Choices, Plan, Shading};
use crate::scene::{Material, Mesh, NormalSource, Scene};
use crate::screen::DrawList;

/// The number of bits that stands for `--subpixel-bits exact`.
const EXACT: u32 = u32::MAX;
/// Samples a side: small, so that most of every picture is near an edge.
const SIDE: u32 = 32;
/// Distances of corners, as powers of two: named, because figures have names.
const MAGNITUDES: [(i32, &str); 7] = [
    (0, "wrong, ppm of edge samples, 8 bits, within 2^0 pictures"),
    (5, "wrong, ppm of edge samples, 8 bits, to 2^5 px"),
    (10, "wrong, ppm of edge samples, 8 bits, to 2^10 px"),
    (15, "wrong, ppm of edge samples, 8 bits, to 2^15 px"),
    (20, "wrong, ppm of edge samples, 8 bits, to 2^20 px"),
    (25, "wrong, ppm of edge samples, 8 bits, to 2^25 px"),
    (30, "wrong, ppm of edge samples, 8 bits, to 2^30 px"),
];
const GRIDS: [(u32, &str); 4] = [(0, "0 bits"), (4, "4 bits"), (12, "12 bits"), (16, "16 bits")];

/// Draws triangles and quadrilaterals of all sizes.
pub(super) fn run(effort: &Effort, report: &mut Report) {
    let cases = effort.count(7_000, 700_000);
    let tally = sum(cases, |number, tally| case(number, &mut effort.random(number), tally));
    let edges = tally.of("edge samples").max(1) as f64;
    report.count("polygons", cases);
    report.count("samples judged", tally.of("samples"));
    report.some("samples that an edge passes", tally.of("edge samples"));
    report.some("polygons with a corner beyond 2^20 pixels", tally.of("far"));
    report.some("samples exactly on an edge", tally.of("ties"));
    for (bits, name) in GRIDS {
        let wrong = tally.of(name) as f64 / edges * 1e6;
        report.measure(format!("wrong, ppm of edge samples, {bits} bits"), wrong);
    }
    for (magnitude, name) in MAGNITUDES {
        let edges = tally.of(EDGES[(magnitude / 5) as usize]).max(1) as f64;
        report.measure(name, tally.of(name) as f64 / edges * 1e6);
    }
    report.count("pictures of the unsnapped mode (0: not offered)", tally.of("unsnapped pictures"));
    report.count("samples that rounding in the view's transform moved", tally.of("moved"));
    report.none("wrong samples with nothing snapped", tally.of("unsnapped wrong"));
    tally.examples.iter().for_each(|example| report.miss(example));
}

const EDGES: [&str; 7] = ["edges 0", "edges 5", "edges 10", "edges 15", "edges 20", "edges 25", "edges 30"];

fn case(number: u64, random: &mut Random, tally: &mut Tally) {
    let (magnitude, name) = MAGNITUDES[(number % 7) as usize];
    let corners = corners(random, magnitude);
    let scene = one_polygon(&corners);
    let Some(truth) = truth(&corners) else { return };
    let edge_samples = edge_samples(&truth);
    tally.add("samples", truth.counts.samples);
    tally.add("edge samples", edge_samples);
    tally.add(EDGES[(magnitude / 5) as usize], edge_samples);
    tally.add("ties", truth.counts.on_outline);
    tally.add("far", u64::from(magnitude >= 25));
    for (bits, name) in GRIDS.into_iter().chain([(8, name)]) {
        if let Some(list) = geometry(&scene, bits) {
            let drawn = draw(&list, AREA_RASTERIZERS[0].1, 1);
            tally.add(name, wrong(&truth, &drawn.owner));
        }
    }
    let Some(list) = geometry(&scene, EXACT) else { return };
    let exact = judge(&list, &Rules::UNSNAPPED);
    tally.add("moved", exact.owner.iter().zip(&truth.owner).filter(|(a, b)| a.is_some() != b.is_some()).count() as u64);
    for (name, rasterizer) in AREA_RASTERIZERS {
        let wrong = wrong(&exact, &draw(&list, rasterizer, 1).owner);
        tally.add("unsnapped pictures", 1);
        tally.add("unsnapped wrong", wrong);
        if wrong > 0 {
            tally.example(|| format!("{name}: {wrong} samples wrong of {corners:?}"));
        }
    }
}

fn wrong(truth: &ExactPicture, owner: &[Option<u32>]) -> u64 {
    truth.owner.iter().zip(owner).filter(|(truth, drawn)| truth.is_some() != drawn.is_some()).count() as u64
}

/// Samples whose right or lower neighbor is covered otherwise: those on either side of an edge, about.
fn edge_samples(truth: &ExactPicture) -> u64 {
    let at = |x: u32, y: u32| truth.owner[(y * truth.width + x) as usize].is_some();
    let inner = (0..truth.height - 1).flat_map(|y| (0..truth.width - 1).map(move |x| (x, y)));
    inner.filter(|&(x, y)| at(x, y) != at(x + 1, y) || at(x, y) != at(x, y + 1)).count() as u64 * 2
}

/// Three or four corners in eye space, counterclockwise as the viewer sees them and planar. They land up to 2^magnitude
/// pixels from the middle; edges are pulled to pass the picture, in a third of the cases exactly through a sample's center: there
/// all corners are on centers and every w is a power of two, so no product is rounded.
fn corners(random: &mut Random, magnitude: i32) -> Vec<Vec3> {
    let half = f64::from(SIDE) / 2.0;
    let reach = if magnitude == 0 { half } else { pow(2.0, f64::from(magnitude)) };
    let on_centers = random.once_in(3);
    let mut point = |end: f64| {
        let mut along = || {
            let at = random.between(-end, end);
            if on_centers { at.floor() + 0.5 } else { at }
        };
        (along(), along())
    };
    let (p, q, a, c) = (point(half), point(half), point(reach), point(reach));
    // The second and the third corner lie behind points of the picture, seen from the first.
    let stretch = reach / half * random.between(0.5, 1.0);
    let beyond = |to: (f64, f64)| (a.0 + (to.0 - a.0) * 2.0, a.1 + (to.1 - a.1) * 2.0);
    let near = |to: (f64, f64)| (to.0 * stretch, to.1 * stretch);
    let outline = match random.below(3) {
        0 => [a, beyond(p), beyond(q)],
        1 => [a, c, near(p)],
        _ => [a, beyond(p), c],
    };
    let mut w = || {
        let exponent = if on_centers { random.below(7) as f64 - 3.0 } else { random.between(-3.0, 3.0) };
        pow(2.0, exponent)
    };
    let corners = outline.map(|(x, y)| {
        let w = w();
        Vec3::new(x / half * w, y / half * w, w)
    });
    corners.to_vec()
}

/// A scene of one polygon that shows both sides.
fn one_polygon(corners: &[Vec3]) -> Scene {
    let mut mesh = Mesh::default();
    let outline: Vec<u32> = corners.iter().map(|&corner| mesh.push_vertex(world(corner))).collect();
    mesh.push_polygon(&outline, NormalSource::Facet, 1);
    scene(camera(SIDE, SIDE), Material::default(), mesh, true)
}

/// The picture of the corners as they are: x = w (1 + X/w) SIDE/2, y downward.
fn truth(corners: &[Vec3]) -> Option<ExactPicture> {
    let half = f64::from(SIDE) / 2.0;
    let mut list = DrawList::new(SIDE, SIDE);
    list.push_flat(&vec![(0.0, 0.0); corners.len()], 1.0, [1.0; 3]);
    for (vertex, &eye) in list.vertices.iter_mut().zip(corners) {
        vertex.homogeneous = Vec3::new((eye.z + eye.x) * half, (eye.z - eye.y) * half, eye.z);
    }
    let picture = judge(&list, &Rules::UNSNAPPED);
    (picture.counts.refused == 0).then_some(picture)
}

/// What the geometry stage makes of it; none where it does not know the grid.
fn geometry(scene: &Scene, subpixel_bits: u32) -> Option<DrawList> {
    let choices = Choices { subpixel_bits, shading: Shading::Flat, ..Choices::default() };
    let plan = Plan::new(scene, &choices, Accepts::AnyPolygon).ok()?;
    let mut list = DrawList::new(0, 0);
    crate::geometry::run(scene, &plan, &mut list);
    Some(list)
}
