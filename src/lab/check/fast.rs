//! Fast: the fast rasterizer draws the z-buffer's bytes.
//!
//! random scenes -> DrawList -> two pictures that must be one
//!
//! Every scene is drawn by `fast` with one random choice of threads, tile side and instructions, and compared bit by bit with the
//! z-buffer's picture; some with every combination. Stars and combs that pierce and touch ([`super::random_scenes`]) take turns with
//! meshes ([`super::random_meshes`]): slivers, triangles below a pixel, huge ones, coplanar ones, transparent ones. How hard they were is
//! counted sample by sample from the lists. Then scenes in pictures ([`super::fast_textured`]) and every built-in scene, at three sizes with all effort.
//!
//! Space: samples. Cost: a few milliseconds a scene, most of them for starting threads.

use super::random_meshes::{mesh, mesh_choices};
use super::random_scenes::{choices, hard};
use super::{Effort, Random, Report};
use crate::parse::{ParseOptions, read_nff};
use crate::plan::{Choices, Culling, Shading};
use crate::raster::ZBuffer;
use crate::raster::coverage::Spans;
use crate::raster::fast::{Fast, Instructions, Shortcuts};
use crate::render::{Rendered, render};
use crate::scene::Scene;
use crate::screen::DrawList;
use crate::spd::{Curves, SMALL, find, generate};

/// One scene in this many is drawn in every way.
const EVERY_WAY: u64 = 500;

/// Draws every scene twice or more.
pub(super) fn run(effort: &Effort, report: &mut Report) {
    let scenes = effort.count(2000, 100_000);
    let mut tally = Tally::default();
    for number in 0..scenes {
        let seed = effort.seed.wrapping_add(number);
        let mut random = effort.random(number);
        let (scene, choices) =
            if number % 2 == 0 { (hard(seed), choices(seed)) } else { (mesh(seed), mesh_choices(seed)) };
        let ways = if number % EVERY_WAY == 3 { every_way() } else { vec![any_way(&mut random)] };
        tally.scene(&format!("random scene {seed}"), (&scene, &choices), &ways, report);
    }
    tally.print(report);
    super::fast_textured::run(effort, report);
    standard_scenes(effort, report);
}

/// Every built-in scene: the small size, and for the record the size before the usual one and the usual one.
fn standard_scenes(effort: &Effort, report: &mut Report) {
    let mut tally = Tally::default();
    let mut random = effort.random(u64::MAX);
    for (name, small) in SMALL {
        let usual = find(name).map_or(small, |scene| scene.default_size);
        let sizes = [small, (usual - 1).max(1), usual];
        for &size in &sizes[..effort.count(1, 3) as usize] {
            let Some(scene) = standard(name, size) else {
                report.miss(format!("spd:{name}:{size} cannot be read"));
                continue;
            };
            for shading in [Shading::Flat, Shading::Gouraud, Shading::Phong] {
                let (samples, side) = (1 + random.below(3) as u32, effort.count(100, 360).max(24) as u32);
                let culling = [Culling::Back, Culling::None][random.below(2) as usize];
                let choices =
                    Choices { size: Some((side, side * 3 / 4)), shading, samples, culling, ..Choices::default() };
                let ways = Instructions::ALL.map(|instructions| (any_way(&mut random).0, 2, instructions, true));
                tally.scene(&format!("spd:{name}:{size}"), (&scene, &choices), &ways[1..], report);
            }
        }
    }
    report.count("lists of built-in scenes", tally.scenes);
    report.count("polygons in them, built-in", tally.polygons);
    report.count("pictures of built-in scenes by fast", tally.pictures);
    report.none("pictures of built-in scenes with other bytes than the z-buffer's", tally.different);
}

fn standard(name: &str, size: u32) -> Option<Scene> {
    let mut text = Vec::new();
    generate(find(name)?, size, Curves::Kept, &mut text).ok()?;
    Some(read_nff(name, &text, ParseOptions::default()).ok()?.scene)
}

/// Tile side, threads, instructions, and whether there are shortcuts.
pub(super) type Way = (u32, u32, Instructions, bool);

pub(super) fn any_way(random: &mut Random) -> Way {
    let tile = 8 * (1 + random.below(32) as u32);
    let threads = 1 + random.below(64) as u32;
    (tile, threads, Instructions::ALL[random.below(4) as usize], !random.once_in(4))
}

fn every_way() -> Vec<Way> {
    let mut ways = Vec::new();
    for tile in [8, 16, 24, 64, 256] {
        for threads in [1, 2, 7, 64] {
            ways.extend(Instructions::ALL.map(|instructions| (tile, threads, instructions, tile != 16)));
        }
    }
    ways
}

/// Sums over scenes.
#[derive(Default)]
pub(super) struct Tally {
    pub scenes: u64,
    pub pictures: u64,
    pub different: u64,
    pub by_edges: u64,
    pub by_spans: u64,
    by_samples: u64,
    pub polygons: u64,
    pub overlapped: u64,
    tied: u64,
    cut: u64,
    pub transparent: u64,
}

impl Tally {
    pub fn scene(&mut self, name: &str, (scene, choices): (&Scene, &Choices), ways: &[Way], report: &mut Report) {
        let alone = Choices { threads: Some(1), ..choices.clone() };
        let expected = match render(scene, &alone, Some(&ZBuffer)) {
            Ok(rendered) => rendered,
            Err(error) => return report.miss(format!("{name} has no plan: {error}")),
        };
        self.count(&expected);
        for &(tile, threads, instructions, short) in ways {
            let mut fast = Fast::new(tile, instructions);
            fast.shortcuts = Shortcuts::all(short);
            let choices = Choices { threads: Some(threads), ..choices.clone() };
            self.pictures += 1;
            let Ok(drawn) = render(scene, &choices, Some(&fast)) else { continue };
            let counted = |name| drawn.puts.own.get(name).copied().unwrap_or(0);
            self.by_edges += counted("polygons in tiles, by edges");
            self.by_spans += counted("polygons in tiles, by spans");
            self.by_samples += counted("polygons in tiles, sample by sample");
            if !same_bits(&expected, &drawn) {
                self.different += 1;
                report.miss(format!("{name}, tiles of {tile}, {threads} threads, {instructions:?}, shortcuts {short}: other bytes, {choices:?}"));
            }
        }
    }

    fn count(&mut self, expected: &Rendered) {
        let (overlapped, tied) = crowded(&expected.list);
        self.scenes += 1;
        self.polygons += expected.list.len() as u64;
        self.overlapped += u64::from(overlapped > 0);
        self.tied += u64::from(tied > 0);
        self.cut += u64::from(expected.counts.cut > 0);
        self.transparent += u64::from(expected.list.has_blending);
    }

    fn print(&self, report: &mut Report) {
        report.count("random scenes", self.scenes);
        report.count("polygons in them", self.polygons);
        report.some("scenes with samples that several polygons cover", self.overlapped);
        report.some("scenes with exact ties of depth", self.tied);
        report.some("scenes with cut polygons", self.cut);
        report.some("scenes with transparent surfaces", self.transparent);
        let here = Instructions::ALL.map(Instructions::here).join(", ");
        report.count(format!("pictures by fast, with {here}"), self.pictures);
        report.some("polygons in tiles drawn by edges", self.by_edges);
        report.some("polygons in tiles drawn by spans", self.by_spans);
        report.some("polygons in tiles drawn sample by sample", self.by_samples);
        report.none("pictures with other bytes than the z-buffer's", self.different);
    }
}

fn same_bits(a: &Rendered, b: &Rendered) -> bool {
    let same = |(a, b): (&crate::color::Rgb<f32>, &crate::color::Rgb<f32>)| {
        a.to_array().map(f32::to_bits) == b.to_array().map(f32::to_bits)
    };
    a.image.pixels().len() == b.image.pixels().len() && a.image.pixels().iter().zip(b.image.pixels()).all(same)
}

/// How many samples two polygons or more cover, and in how many a depth comes twice.
fn crowded(list: &DrawList) -> (u64, u64) {
    let (mut overlapped, mut tied) = (0, 0);
    let mut nearest = vec![0.0; list.width as usize * list.height as usize];
    let mut spans = Spans::within(0..list.width as i32);
    for polygon in list.polygons() {
        spans.of(polygon.vertices(), list.grid, 0..list.height as i32, |row, columns| {
            for column in columns {
                let before: &mut f64 = &mut nearest[row as usize * list.width as usize + column as usize];
                let depth = polygon.depth(column, row);
                overlapped += u64::from(*before > 0.0);
                tied += u64::from(depth == *before && depth > 0.0);
                *before = before.max(depth);
            }
        });
    }
    (overlapped, tied)
}
