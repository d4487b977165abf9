//! Cts: the scenes that conformance suites draw, in our own numbers and with no tolerance.
//!
//! The suites allow what hardware may differ in: 10 to 25 pixels, one pixel around, 5 levels. Here every sample counts. What is
//! cut into pieces must show what the whole shows (by the oracle) with no sample put twice; other scenes have answers that
//! follow from their numbers.
//!
//! Source for the kinds of scenes: the rasterization and clipping groups of Khronos' VK-GL-CTS, and piglit's triangle
//! rasterization and overdraw tests; nothing of theirs is copied.

use super::scenes::{AREA_RASTERIZERS, Point, camera, draw, outline, scene, stack, world};
use super::tally::Tally;
use super::{Effort, Random, Report};
use crate::math::{PI, Vec3, cos, edges, pow, sin};
use crate::oracle::exact::{Rules, judge};
use crate::plan::{Accepts, Choices, Culling, Plan, Shading};
use crate::raster::{PerPolygon, Wire, ZBuffer};
use crate::scene::{Material, Mesh, NormalSource};
use crate::screen::{DrawList, Grid};

/// A kind of scene: draws some, and counts wrong samples under its own name.
type Kind = (&'static str, fn(&mut Random, &mut Tally));

const KINDS: [Kind; 14] = [
    ("fill rules: 16 quadrilaterals, turned", turned_quads),
    ("fans around a point on, beside and far from a center", fans),
    ("eight triangles around one center, in 256ths of a sample", tiny_fans),
    ("strips", strips),
    ("slivers 100,000 times as long as wide", slivers),
    ("pictures of 1 x N and N x 1 samples", thin_pictures),
    ("pictures 16,384 samples wide", wide_pictures),
    ("a polygon around the whole view volume", around),
    ("corners up to 2^30 pixels away", huge),
    ("culling of either side", culling),
    ("before and behind a plane: each sample once", complementary),
    ("whole pixels to the right and down", shifted),
    ("perspective: the point in space at every sample", perspective),
    ("outlines of lines without a gap", continuity),
];

/// Draws all kinds of scenes.
pub(super) fn run(effort: &Effort, report: &mut Report) {
    let rounds = effort.count(4, 400);
    let mut tally = Tally::default();
    for (number, (_, kind)) in KINDS.iter().enumerate() {
        let mut random = effort.random(number as u64);
        (0..rounds).for_each(|_| kind(&mut random, &mut tally));
    }
    report.count("kinds of scenes", KINDS.len() as u64);
    report.count("scenes", tally.of("scenes"));
    report.some("samples compared", tally.of("samples"));
    report.some("samples exactly on an edge", tally.of("ties"));
    for (name, _) in KINDS {
        report.none(name, tally.of(name));
    }
    tally.examples.iter().for_each(|example| report.miss(example));
}

fn found(name: usize, wrong: u64, samples: u64, tally: &mut Tally) {
    let name = KINDS[name].0;
    tally.add("scenes", 1);
    tally.add("samples", samples);
    tally.add(name, wrong);
    if wrong > 0 {
        tally.example(|| format!("{name}: {wrong} of {samples} samples wrong"));
    }
}

/// Draws `pieces`, which make up `whole`: every sample of the whole once, by every rasterizer.
fn once(name: usize, (width, height): (u32, u32), pieces: &[Vec<Point>], whole: &[Point], tally: &mut Tally) {
    let (mut list, mut one) = (DrawList::new(width, height), DrawList::new(width, height));
    pieces.iter().for_each(|piece| list.push_flat(piece, 1.0, [1.0; 3]));
    one.push_flat(whole, 1.0, [1.0; 3]);
    stack(&mut list);
    let exact = judge(&one, &Rules::CONTRACT);
    tally.add("ties", judge(&list, &Rules::CONTRACT).counts.on_outline);
    for (rasterizer_name, rasterizer) in AREA_RASTERIZERS {
        let drawn = draw(&list, rasterizer, 1);
        let other = drawn.owner.iter().zip(&exact.owner).filter(|(drawn, exact)| drawn.is_some() != exact.is_some());
        let twice = if rasterizer_name == "watkins" { 0 } else { drawn.puts.overdraw };
        found(name, other.count() as u64 + twice + drawn.puts.stray_writes, exact.counts.samples, tally);
    }
}

/// To the grid of 256ths, so that pieces and whole have the same corners.
fn snapped((x, y): Point) -> Point {
    let grid = Grid { bits: 8 };
    (grid.snap(x), grid.snap(y))
}

fn turned_quads(random: &mut Random, tally: &mut Tally) {
    for step in 0..16 {
        let angle = f64::from(step) / 15.0 * PI / 2.0;
        let (c, s) = (cos(angle), sin(angle));
        let middle = (64.0 + random.unit(), 64.0 + random.unit());
        let at = |column: u32, row: u32| {
            let (x, y) = (f64::from(column) * 20.0 - 40.0, f64::from(row) * 20.0 - 40.0);
            snapped((middle.0 + c * x - s * y, middle.1 + s * x + c * y))
        };
        let quad = |index: u32| {
            let (column, row) = (index % 4, index / 4);
            vec![at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1)]
        };
        let pieces: Vec<_> = (0..16).map(quad).collect();
        // All corners of the border: snapping moves each for itself.
        let border = (0..4).map(|i| at(i, 0)).chain((0..4).map(|i| at(4, i))).chain((0..4).map(|i| at(4 - i, 4)));
        let border: Vec<_> = border.chain((0..4).map(|i| at(0, 4 - i))).collect();
        once(0, (128, 128), &pieces, &border, tally);
    }
}

/// Triangles from `hub` to a ring of `spokes` corners `radius` away.
fn fan(hub: Point, radius: f64, spokes: u32, turn: f64) -> (Vec<Vec<Point>>, Vec<Point>) {
    let corner = |spoke: u32| {
        let angle = (f64::from(spoke) + turn) / f64::from(spokes) * 2.0 * PI;
        snapped((hub.0 + radius * cos(angle), hub.1 + radius * sin(angle)))
    };
    let ring: Vec<Point> = (0..spokes).map(corner).collect();
    (edges(&ring).map(|(&a, &b)| vec![hub, a, b]).collect(), ring)
}

fn fans(random: &mut Random, tally: &mut Tally) {
    for hub in [(32.5, 32.5), (32.0, 32.0), (32.5 + 1.0 / 256.0, 32.5 - 1.0 / 256.0), (32.5, 32.25)] {
        let spokes = 3 + random.below(40) as u32;
        let (pieces, ring) = fan(hub, random.between(2.0, 31.0), spokes, random.unit());
        once(1, (64, 64), &pieces, &ring, tally);
    }
}

fn tiny_fans(_: &mut Random, tally: &mut Tally) {
    for shift in 0..9 {
        let hub = (2.5 + f64::from(shift % 3 - 1) / 256.0, 2.5 + f64::from(shift / 3 - 1) / 256.0);
        let at = |x: i32, y: i32| (hub.0 + f64::from(x) / 256.0, hub.1 + f64::from(y) / 256.0);
        let ring = [(2, 0), (2, 2), (0, 2), (-2, 2), (-2, 0), (-2, -2), (0, -2), (2, -2)].map(|(x, y)| at(x, y));
        let pieces: Vec<_> = edges(&ring).map(|(&a, &b)| vec![hub, a, b]).collect();
        once(2, (5, 5), &pieces, &ring, tally);
    }
}

/// A band between two chains, in triangles, and its outline.
fn band(width: f64, upper: &[f64], lower: &[f64]) -> (Vec<Vec<Point>>, Vec<Point>) {
    let last = (upper.len() - 1) as f64;
    let chain = |heights: &[f64]| -> Vec<Point> {
        heights.iter().enumerate().map(|(i, &y)| snapped((i as f64 / last * width, y))).collect()
    };
    let (above, below) = (chain(upper), chain(lower));
    let cells = (1..above.len())
        .flat_map(|i| [vec![above[i - 1], above[i], below[i - 1]], vec![below[i - 1], above[i], below[i]]]);
    (cells.collect(), above.iter().copied().chain(below.iter().rev().copied()).collect())
}

fn strips(random: &mut Random, tally: &mut Tally) {
    let links = 2 + random.below(30);
    let upper: Vec<f64> = (0..=links).map(|_| random.between(0.0, 30.0)).collect();
    let lower: Vec<f64> = (0..=links).map(|_| random.between(33.0, 64.0)).collect();
    let (pieces, whole) = band(64.0, &upper, &lower);
    once(3, (64, 64), &pieces, &whole, tally);
}

fn slivers(random: &mut Random, tally: &mut Tally) {
    // Sixteen layers, each 4096 samples long and some 10 grid steps of 1/256 thick.
    let slope = random.between(-1.0, 1.0);
    let start = random.between(3.0, 4.0);
    let heights =
        |layer: u32| [start + f64::from(layer) * 10.0 / 256.0, start + slope + f64::from(layer) * 10.0 / 256.0];
    let pieces: Vec<_> = (0..16).flat_map(|layer| band(4096.0, &heights(layer), &heights(layer + 1)).0).collect();
    let whole = band(4096.0, &heights(0), &heights(16)).1;
    once(4, (4096, 8), &pieces, &whole, tally);
}

fn thin_pictures(random: &mut Random, tally: &mut Tally) {
    for (width, height) in [(1, 1), (1, 777), (777, 1), (2, 300)] {
        let (right, low) = (f64::from(width), f64::from(height));
        let hub = snapped((random.between(0.0, right), random.between(0.0, low)));
        let ring = [(0.0, 0.0), (right, 0.0), (right, low), (0.0, low)];
        let pieces: Vec<_> = edges(&ring).map(|(&a, &b)| vec![hub, a, b]).collect();
        once(5, (width, height), &pieces, &ring, tally);
    }
}

fn wide_pictures(random: &mut Random, tally: &mut Tally) {
    let heights = |random: &mut Random, low: f64| (0..9).map(|_| random.between(low, low + 1.5)).collect::<Vec<_>>();
    let (upper, lower) = (heights(random, 0.0), heights(random, 2.5));
    let (pieces, whole) = band(16_384.0, &upper, &lower);
    once(6, (16_384, 4), &pieces, &whole, tally);
}

/// The draw list of one polygon given in eye space, under a change of the plan's choices.
fn seen(corners: &[Vec3], side: u32, (hither, yon): (f64, Option<f64>), choices: Choices) -> Option<DrawList> {
    let mut mesh = Mesh::default();
    let indices: Vec<u32> = corners.iter().map(|&corner| mesh.push_vertex(world(corner))).collect();
    mesh.push_polygon(&indices, NormalSource::Facet, 1);
    let mut view = camera(side, side);
    (view.hither, view.yon) = (hither, yon);
    let material = Material { specular: 0.5, shine: 5.0, ..Material::default() };
    let scene = scene(view, material, mesh, false);
    let plan = Plan::new(&scene, &choices, Accepts::AnyPolygon).ok()?;
    let mut list = DrawList::new(0, 0);
    crate::geometry::run(&scene, &plan, &mut list);
    Some(list)
}

/// Flat, both sides shown.
fn flat() -> Choices {
    Choices { shading: Shading::Flat, culling: Culling::None, ..Choices::default() }
}

/// Samples of `list` whose coverage is not what `covers` says, over all rasterizers; all of them if there is no list.
fn unlike(list: Option<DrawList>, covers: impl Fn(u32, u32) -> bool) -> u64 {
    let Some(list) = list else { return 1 };
    let wrong = |owner: &[Option<u32>]| {
        let expected = |index: usize| covers(index as u32 % list.width, index as u32 / list.width);
        owner.iter().enumerate().filter(|&(index, owner)| owner.is_some() != expected(index)).count() as u64
    };
    AREA_RASTERIZERS.iter().map(|(_, rasterizer)| wrong(&draw(&list, *rasterizer, 1).owner)).sum()
}

fn around(random: &mut Random, tally: &mut Tally) {
    let angle = random.between(0.0, 2.0 * PI);
    let corner = |quarter: u32| {
        let angle = angle + f64::from(quarter) * PI / 2.0;
        Vec3::new(cos(angle) * 9.0, sin(angle) * 9.0, 3.0 + cos(angle))
    };
    let corners: Vec<Vec3> = (0..4).map(corner).collect();
    for triangles in [false, true] {
        let list = seen(&corners, 64, (0.1, None), Choices { triangles, ..flat() });
        found(7, unlike(list, |_, _| true), 64 * 64, tally);
    }
}

/// Half-planes: above a row, left of a column, on one side of a diagonal; the corners far away.
fn huge(random: &mut Random, tally: &mut Tally) {
    let far = pow(2.0, 10.0 + random.below(21) as f64);
    let line = 1.0 + random.below(62) as f64 + if random.once_in(2) { 0.5 } else { 0.0 };
    // In samples, y down; the picture is 64 wide.
    let upper = [(-far, line), (far, line), (32.0, -far)];
    let left = [(line, -far), (line, far), (-far, 32.0)];
    let diagonal = [(-far, 64.0 + far), (far, 64.0 - far), (-far, -far)];
    let is_before = |at: u32| f64::from(at) + 0.5 < line;
    let w = pow(2.0, random.below(5) as f64);
    let eye = |&(x, y): &Point| Vec3::new((x - 32.0) / 32.0 * w, (32.0 - y) / 32.0 * w, w);
    let list = |outline: [Point; 3]| seen(&outline.each_ref().map(eye), 64, (0.1, None), flat());
    found(8, unlike(list(upper), |_, y| is_before(y)), 64 * 64, tally);
    found(8, unlike(list(left), |x, _| is_before(x)), 64 * 64, tally);
    // Centers on the diagonal: it is a right edge, so they are not covered.
    found(8, unlike(list(diagonal), |x, y| x + y + 1 < 64), 64 * 64, tally);
}

fn culling(random: &mut Random, tally: &mut Tally) {
    let w = random.between(1.0, 5.0);
    // Counterclockwise with y up: the front.
    let front = [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)].map(|(x, y)| Vec3::new(x * w, y * w, w));
    let mut back = front;
    back.reverse();
    let inside = |x: u32, y: u32| (16..48).contains(&x) && (16..48).contains(&y);
    for culling in [Culling::Back, Culling::Nff, Culling::None] {
        let choices = || Choices { culling, ..flat() };
        let shows_back = culling == Culling::None;
        found(9, unlike(seen(&front, 64, (0.1, None), choices()), inside), 64 * 64, tally);
        found(9, unlike(seen(&back, 64, (0.1, None), choices()), |x, y| shows_back && inside(x, y)), 64 * 64, tally);
    }
}

/// A tilted polygon, once up to a plane and once from it: together each sample once.
fn complementary(random: &mut Random, tally: &mut Tally) {
    let tilt = 0.2;
    let at = |x: f64, y: f64| Vec3::new(x, y, 1.0) / (1.0 + tilt * y);
    let corners = [at(-2.0, -2.0), at(2.0, -2.0), at(2.0, 2.0), at(-2.0, 2.0)];
    // On a row of centers, or between.
    let row = 1.0 + random.below(62) as f64 + [0.5, 0.25, 0.0][random.below(3) as usize];
    let plane = at(0.0, 1.0 - row / 32.0).z;
    let covers = |range| {
        let list = seen(&corners, 64, range, flat())?;
        Some(draw(&list, &ZBuffer, 1).owner)
    };
    let (Some(near), Some(far)) = (covers((0.1, Some(plane))), covers((plane, None))) else {
        return found(10, 1, 0, tally);
    };
    let wrong = near.iter().zip(&far).filter(|(near, far)| near.is_some() == far.is_some()).count();
    found(10, wrong as u64, 64 * 64, tally);
}

fn shifted(random: &mut Random, tally: &mut Tally) {
    let bits = [0, 4, 8, 12, 16][random.below(5) as usize];
    let adversarial = random.once_in(2);
    let corners = outline(random, (32, 32), adversarial);
    let (right, down) = (random.below(4000) as u32, random.below(100) as u32);
    let drawn = |right: u32, down: u32| {
        let mut list = DrawList::new(32 + right, 32 + down);
        list.grid = Grid { bits };
        let grid = list.grid;
        let moved = |&(x, y): &Point| (grid.snap(x) + f64::from(right), grid.snap(y) + f64::from(down));
        list.push_flat(&corners.iter().map(moved).collect::<Vec<_>>(), 1.0, [1.0; 3]);
        list
    };
    for (_, rasterizer) in AREA_RASTERIZERS {
        let (here, there) = (draw(&drawn(0, 0), rasterizer, 1), draw(&drawn(right, down), rasterizer, 1));
        let at = |x: u32, y: u32| there.owner[((y + down) * (32 + right) + x + right) as usize];
        let wrong = (0..32 * 32).filter(|&index| here.owner[index as usize] != at(index % 32, index / 32));
        found(11, wrong.count() as u64 + here.puts.puts.abs_diff(there.puts.puts), 32 * 32, tally);
    }
}

/// Phong carries the point in space: at every sample it must lie on the sample's ray and on the polygon's plane.
fn perspective(random: &mut Random, tally: &mut Tally) {
    let (a, b) = (random.between(-0.45, 0.45), random.between(-0.4, 0.4));
    let at = |x: f64, y: f64| Vec3::new(x, y, 1.0) / (1.0 + a * x + b * y);
    let corners = [at(-0.9, -0.9), at(0.9, -0.8), at(0.8, 0.9), at(-0.9, 0.9)];
    let choices = Choices { shading: Shading::Phong, culling: Culling::None, ..Choices::default() };
    let Some(list) = seen(&corners, 64, (0.1, None), choices) else { return found(12, 1, 0, tally) };
    let drawn = draw(&list, &ZBuffer, 1);
    let is_wrong = |index: usize, polygon: u32| {
        let (x, y) = (index % 64, index / 64);
        let expected = at((x as f64 + 0.5) / 32.0 - 1.0, 1.0 - (y as f64 + 0.5) / 32.0);
        let values = list.polygon(polygon as usize).values(x as i32, y as i32);
        let eye = Vec3::new(values[3], values[4], values[5]);
        // Planes are evaluated in f32: 2^-20 of the size is some ten of its last places.
        // A distance that is no number counts as off.
        let off = (eye - expected).length();
        off.is_nan() || off > expected.length() * pow(2.0, -20.0)
    };
    let covered = drawn.owner.iter().enumerate().filter_map(|(index, owner)| owner.map(|polygon| (index, polygon)));
    let wrong = covered.filter(|&(index, polygon)| is_wrong(index, polygon)).count();
    found(12, wrong as u64, 64 * 64, tally);
}

/// The outline of a triangle in lines is one piece: from any of its samples all others are reached.
fn continuity(random: &mut Random, tally: &mut Tally) {
    let mut list = DrawList::new(48, 48);
    list.has_depth = false;
    let mut corner = || snapped((random.between(1.0, 47.0), random.between(1.0, 47.0)));
    list.push_flat(&[corner(), corner(), corner()], 1.0, [1.0; 3]);
    let drawn = draw(&list, &PerPolygon(Wire), 1).owner;
    let mut left: Vec<(i32, i32)> =
        (0..48 * 48).filter(|&index| drawn[index as usize].is_some()).map(|index| (index % 48, index / 48)).collect();
    let mut reached: Vec<(i32, i32)> = left.pop().into_iter().collect();
    while let Some((x, y)) = reached.pop() {
        let is_next = |&(u, v): &(i32, i32)| (u - x).abs() <= 1 && (v - y).abs() <= 1;
        reached.extend(left.iter().copied().filter(is_next));
        left.retain(|sample| !is_next(sample));
    }
    found(13, left.len() as u64, 48 * 48, tally);
}
