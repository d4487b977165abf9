//! Depth: which of two polygons shows where one is only a little nearer, for every depth format.
//!
//! pairs of triangles, the second pushed away from the eye by a part of its distance -> DrawList -> owners, in both drawing orders
//!
//! Pushed away from the eye, a triangle keeps its place on the screen and its distance grows by the same part everywhere: the answer
//! is known without computing it. A sample is *wrong* when the farther one shows, *order-dependent* when the two orders show different ones.
//! Only samples that both cover are asked.
//!
//! Also here: the share of pairs that classic ways to store depth cannot tell apart, from their formulas alone.
//! Space: eye space, w from near to far, evenly in its logarithm. Source: N. Reed, "Depth Precision Visualized", 2015, for the formulas.
//! Cost: 64 pairs a picture.

use super::agree::owners;
use super::random_scenes::{camera, facets, scene, surface};
use super::report::Value;
use super::{Effort, Random, Report};
use crate::math::{Vec3, exp, log, pow};
use crate::plan::{Choices, Culling, DepthFormat};
use crate::raster::ZBuffer;
use crate::render::list;
use crate::scene::{Camera, Material, Mesh, Scene};

/// Near and far planes.
const RANGES: [(f64, f64); 4] = [(1.0, 1e3), (0.1, 1e4), (0.01, 1e6), (1e-3, 1e9)];
/// Parts of the distance by which the second polygon is farther.
const SEPARATIONS: [f64; 5] = [1e-3, 1e-4, 1e-5, 1e-6, 1e-7];
/// What double precision is asked for besides.
const FINEST: f64 = 1e-12;
/// Pairs across and down in one picture, and samples of a side of each one's place.
const TILES: u32 = 8;
const TILE: u32 = 12;

/// Draws pairs of every range, separation and format.
pub(super) fn run(effort: &Effort, report: &mut Report) {
    let mut hard = Hardness::default();
    for format in [DepthFormat::F32, DepthFormat::F64] {
        let mut separations = SEPARATIONS.to_vec();
        if format == DepthFormat::F64 {
            separations.extend([1e-9, FINEST]);
        }
        for separation in separations {
            let mut found = Found::default();
            for range in RANGES.into_iter().chain([(1.0, 1e12)]) {
                found += pairs(effort, &Setting { range, separation, format, slant: 1.0 }, &mut hard);
            }
            found.claim(format, separation, report);
        }
    }
    for format in [DepthFormat::Int24, DepthFormat::Int16] {
        for range in RANGES {
            let found = pairs(effort, &Setting { range, separation: 1e-3, format, slant: 1.0 }, &mut hard);
            let what = format!("{}, {:e} to {:e}, 1e-3 apart", format.name(), range.0, range.1);
            report.measure(format!("share of samples wrong in some order, {what}"), found.share());
        }
    }
    // Within one block of samples, single precision adds steps that are far larger than the depth itself.
    let steep = Setting { range: (1.0, 1e12), separation: 1e-5, format: DepthFormat::F32, slant: 4.0 };
    let found = pairs(effort, &steep, &mut Hardness::default());
    report.measure("share of wrong samples, f32, 1e-5 apart, corners up to 256 times as far", found.share());
    report.some("samples asked", hard.samples);
    report.some("pairs seen at a slant of more than 2 in distance", hard.slanted);
    report.some("pairs farther than 1e6 times the near plane", hard.far);
    formats(effort, report);
}

/// How hard the pairs were.
#[derive(Default)]
struct Hardness {
    samples: u64,
    slanted: u64,
    far: u64,
}

/// What a number of pairs showed.
#[derive(Clone, Copy, Default)]
struct Found {
    samples: u64,
    /// The farther one shows, in one order or the other.
    wrong: u64,
    order: u64,
}

impl std::ops::AddAssign for Found {
    fn add_assign(&mut self, other: Found) {
        self.samples += other.samples;
        self.wrong += other.wrong;
        self.order += other.order;
    }
}

impl Found {
    fn share(&self) -> f64 {
        self.wrong as f64 / self.samples.max(1) as f64
    }

    /// The goal where there is one, figures elsewhere.
    fn claim(&self, format: DepthFormat, separation: f64, report: &mut Report) {
        let promised = if format == DepthFormat::F64 { FINEST } else { 1e-5 };
        let what = format!("{}, {separation:e} apart, near/far to 1e12", format.name());
        if separation >= promised {
            report.none(format!("wrong samples, {what}"), self.wrong);
            report.none(format!("order-dependent samples, {what}"), self.order);
        } else {
            report.measure(format!("share of wrong samples, {what}"), self.share());
            report.measure(
                format!("share of order-dependent samples, {what}"),
                self.order as f64 / self.samples.max(1) as f64,
            );
        }
    }
}

/// What pairs are made of.
struct Setting {
    /// Near and far.
    range: (f64, f64),
    /// Part of the distance by which the second is farther.
    separation: f64,
    format: DepthFormat,
    /// Corners are up to 4 to the power of this times as far as each other.
    slant: f64,
}

/// Pictures of pairs between two planes.
fn pairs(effort: &Effort, setting: &Setting, hard: &mut Hardness) -> Found {
    let ((near, far), separation) = (setting.range, setting.separation);
    let mut random = effort.random((far / near).to_bits() ^ separation.to_bits().rotate_left(17));
    let mut found = Found::default();
    for _ in 0..effort.count(3, 120) {
        let front = triangles(&mut random, (near, far / 1.01), setting.slant, hard);
        let back: Vec<Vec<Vec3>> =
            front.iter().map(|corners| corners.iter().map(|&corner| corner * (1.0 + separation)).collect()).collect();
        let here = judge((near, far), &front, &back, setting.format);
        hard.samples += here.samples;
        found += here;
    }
    found
}

/// One triangle a tile, its distance anywhere between the planes, its corners at a slant.
fn triangles(random: &mut Random, (near, far): (f64, f64), slant: f64, hard: &mut Hardness) -> Vec<Vec<Vec3>> {
    let side = f64::from(TILES * TILE);
    let mut all = Vec::new();
    for tile in 0..TILES * TILES {
        let distance = exp(random.between(log(near), log(far)));
        let origin = [tile % TILES, tile / TILES].map(|at| f64::from(at * TILE));
        let slants = [0; 3].map(|_| pow(2.0, random.between(-slant, slant)));
        let corners = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)];
        let place = |(corner, slant): ((f64, f64), f64)| {
            let w = (distance * slant).clamp(near * 1.0001, far);
            let jitter = f64::from(TILE) * 0.9;
            let (x, y) = (origin[0] + 0.5 + corner.0 * jitter, origin[1] + 0.5 + corner.1 * jitter);
            Vec3::new((x / side * 2.0 - 1.0) * w, (1.0 - y / side * 2.0) * w, w)
        };
        let triangle: Vec<Vec3> = corners.into_iter().zip(slants).map(place).collect();
        let (low, high) = triangle.iter().fold((f64::MAX, 0.0_f64), |(l, h), p| (l.min(p.z), h.max(p.z)));
        hard.slanted += u64::from(high > 2.0 * low);
        hard.far += u64::from(low > 1e6 * near);
        all.push(triangle);
    }
    all
}

/// Owners in both orders, where both triangles of a pair cover the sample.
fn judge((near, far): (f64, f64), front: &[Vec<Vec3>], back: &[Vec<Vec3>], depth: DepthFormat) -> Found {
    let side = TILES * TILE;
    let count = front.len() as u32;
    let drawn = |outlines: &[Vec<Vec3>]| {
        let scene = seen((near, far), facets(outlines));
        let choices = Choices { depth, culling: Culling::None, ..Choices::default() };
        list(&scene, &choices, None).map(|list| owners(&list, &ZBuffer)).unwrap_or_default()
    };
    let alone = [drawn(front), drawn(back)];
    let nearer_first = drawn(&[front, back].concat());
    let farther_first = drawn(&[back, front].concat());
    let mut found = Found::default();
    for at in 0..(side * side) as usize {
        let [Some(Some(_)), Some(Some(_))] = alone.each_ref().map(|owners| owners.get(at).copied()) else { continue };
        let [first, second] = [&nearer_first, &farther_first].map(|owners| owners.get(at).copied().flatten());
        let shows_front = [first.is_some_and(|owner| owner < count), second.is_some_and(|owner| owner >= count)];
        found.samples += 1;
        found.wrong += u64::from(shows_front != [true, true]);
        found.order += u64::from(shows_front[0] != shows_front[1]);
    }
    found
}

fn seen((near, far): (f64, f64), mesh: Mesh) -> Scene {
    let side = TILES * TILE;
    let camera = Camera { hither: near, yon: Some(far * 2.0), ..camera(side, side) };
    scene(camera, vec![surface(Material::default(), mesh)])
}

/// A way to store depth: its name, and the stored number of a distance between near and far.
type Stored = (&'static str, fn(f64, f64, f64) -> f64);

/// What hardware and textbooks store.
const STORED: [Stored; 8] = [
    ("int16", |z, n, f| steps(standard(z, n, f), 16)),
    ("int24", |z, n, f| steps(standard(z, n, f), 24)),
    ("int32", |z, n, f| steps(standard(z, n, f), 32)),
    ("f32, z/w", |z, n, f| f64::from(standard(z, n, f) as f32)),
    ("f32, 1/w", |z, _, _| f64::from((1.0 / z) as f32)),
    ("int24, w", |z, n, f| steps((z - n) / (f - n), 24)),
    ("f32, log w", |z, n, f| f64::from((log(z / n) / log(f / n)) as f32)),
    ("f64, z/w", standard),
];

fn standard(z: f64, near: f64, far: f64) -> f64 {
    far / (far - near) - far * near / (far - near) / z
}

fn steps(share: f64, bits: i32) -> f64 {
    (share * (pow(2.0, f64::from(bits)) - 1.0)).round()
}

/// The share of pairs that each way to store depth cannot tell apart: the table of the plan, measured again.
fn formats(effort: &Effort, report: &mut Report) {
    let cases = [(1.0, 1e3, 1e-5), (0.1, 1e4, 1e-4), (0.01, 1e6, 1e-4), (1e-3, 1e9, 1e-6)];
    let count = effort.count(20_000, 2_000_000);
    for (near, far, separation) in cases {
        for (name, store) in STORED {
            let mut random = effort.random(40);
            let same = (0..count).filter(|_| {
                let z = exp(random.between(log(near), log(far)));
                store(z, near, far) == store(z * (1.0 + separation), near, far)
            });
            let percent = same.count() as f64 * 100.0 / count as f64;
            let what = format!("% of pairs alike: {name}, {near:e} to {far:e}, {separation:e} apart");
            if name == "f32, 1/w" {
                report.at_most(what, Value::Measure(percent), Value::Measure(0.0));
            } else {
                report.measure(what, percent);
            }
        }
    }
}
