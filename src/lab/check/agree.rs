//! Agree: the z-buffer, Watkins and the exact oracle show the same polygon at every sample.
//!
//! random and standard scenes -> DrawList -> three pictures that must be one
//!
//! Watkins sorts spans and never compares all depths of a sample, the z-buffer does nothing else, the oracle counts edges above a point
//! in whole numbers: three ways that share only the list. Twice the oracle judges: by the contract's depth, where not one sample may
//! differ, and by the true planes, where samples whose two nearest polygons are closer than the stated band may, and are counted.
//!
//! Space: samples. Cost: some 3 ms a random scene, mostly the oracle's.

use super::random_scenes::{choices, hard};
use super::{Effort, Report};
use crate::oracle::exact::{ExactCounts, Rules, SINGLE_BAND, judge};
use crate::parse::{ParseOptions, read_nff};
use crate::plan::{Choices, Culling, DepthFormat, Shading};
use crate::raster::{Frame, Rasterizer, Watkins, ZBuffer};
use crate::render::{list, render};
use crate::scene::Scene;
use crate::screen::DrawList;
use crate::spd::{self, Curves, SMALL};

/// Draws every scene three times.
pub(super) fn run(effort: &Effort, report: &mut Report) {
    let scenes = effort.count(600, 10_000).max(60);
    let mut tally = Tally::default();
    for number in 0..scenes {
        let seed = effort.seed.wrapping_add(number);
        tally.scene(&format!("random scene {seed}"), &hard(seed), &choices(seed), report);
    }
    report.count("random scenes", scenes);
    tally.print(report);
    let mut standard = Tally::default();
    for (name, size) in SMALL {
        match standard_scene(name, size) {
            Some(scene) => standard.standard(name, scene, effort, report),
            None => report.miss(format!("spd:{name}:{size} cannot be read")),
        }
    }
    report.count("standard scenes", SMALL.len() as u64);
    standard.print_totals("of standard scenes", report);
}

/// A standard scene, read from its own text.
pub(super) fn standard_scene(name: &str, size: u32) -> Option<Scene> {
    let mut text = Vec::new();
    spd::generate(spd::find(name)?, size, Curves::Kept, &mut text).ok()?;
    Some(read_nff(name, &text, ParseOptions::default()).ok()?.scene)
}

/// The opaque polygon that `rasterizer` leaves at every sample.
pub(super) fn owners(list: &DrawList, rasterizer: &dyn Rasterizer) -> Vec<Option<u32>> {
    let mut frame = Frame::default();
    let canvas = Choices::default();
    let background = crate::color::Rgb::gray(0.0);
    let mut target = frame.target((list.width, list.height), 0..list.height, background, canvas.transparency);
    rasterizer.draw(list, &mut target);
    target.finish();
    (0..list.width as usize * list.height as usize).map(|index| frame.sample(index).0).collect()
}

/// Sums over scenes.
#[derive(Default)]
struct Tally {
    pictures: u64,
    different: u64,
    against_contract: u64,
    beyond_band: u64,
    within_band: u64,
    within_before: u64,
    transparent: u64,
    counts: ExactCounts,
    disputed: u64,
}

impl Tally {
    /// One picture, three ways.
    fn scene(&mut self, name: &str, scene: &Scene, choices: &Choices, report: &mut Report) {
        let both = [&ZBuffer as &dyn Rasterizer, &Watkins].map(|rasterizer| render(scene, choices, Some(rasterizer)));
        let [Ok(buffered), Ok(sorted)] = both else {
            report.miss(format!("{name} has no plan"));
            return;
        };
        self.pictures += 1;
        if buffered.image != sorted.image {
            self.different += 1;
            report.miss(format!("{name}: Watkins and the z-buffer draw different bytes"));
        }
        self.transparent += u64::from(buffered.list.has_blending);
        self.judge(name, &buffered.list, report);
    }

    /// The owner of every sample, by both rasterizers and by the oracle, twice.
    fn judge(&mut self, name: &str, list: &DrawList, report: &mut Report) {
        let contract = judge(list, &Rules::CONTRACT);
        let integers = matches!(list.depth_mapping.format, DepthFormat::Int16 | DepthFormat::Int24);
        self.counts += contract.counts;
        // Steps of integers are no rounding errors of a plane: there the contract alone is the judge.
        let truth = (!integers).then(|| judge(list, &Rules::TRUE_DEPTH));
        self.disputed += truth.as_ref().map_or(0, |truth| truth.counts.disputed);
        for rasterizer in [&ZBuffer as &dyn Rasterizer, &Watkins] {
            let drawn = owners(list, rasterizer);
            let (other, tied) = contract.differences(&drawn);
            if other + tied > 0 {
                report.miss(format!("{name}: {} samples against the contract's owner", other + tied));
            }
            self.against_contract += other + tied;
            let (wrong, close) = truth.as_ref().map_or((0, 0), |truth| truth.differences(&drawn));
            self.beyond_band += wrong;
            self.within_band = self.within_band.max(self.within_before + close);
        }
        self.within_before = self.within_band;
    }

    /// A standard scene in all shadings, with all depth formats, with back faces and without.
    fn standard(&mut self, name: &str, mut scene: Scene, effort: &Effort, report: &mut Report) {
        let side = effort.count(64, 200).max(48) as u32;
        // Integer depth needs a farthest plane.
        if let Some(camera) = &mut scene.camera {
            camera.yon = Some(camera.from.distance(camera.at) * 20.0);
        }
        let shadings = [Shading::Gouraud, Shading::Flat, Shading::Phong];
        let cullings = [Culling::Back, Culling::None, Culling::Back, Culling::Nff];
        for (number, shading) in shadings.into_iter().enumerate().take(effort.count(1, 3) as usize) {
            for (index, &depth) in DepthFormat::ALL.iter().enumerate().take(effort.count(2, 4) as usize) {
                let subpixel_bits = if depth == DepthFormat::Int16 { 0 } else { 8 };
                let size = Some((side, side));
                let choices =
                    Choices { size, shading, depth, culling: cullings[index], subpixel_bits, ..Choices::default() };
                self.pictures_of(&format!("spd:{name}"), &scene, (&choices, number == 0), report);
            }
        }
    }

    /// Bytes for every picture; owners once a list, as shading does not change them.
    fn pictures_of(&mut self, name: &str, scene: &Scene, (choices, owners): (&Choices, bool), report: &mut Report) {
        let image = |rasterizer: &dyn Rasterizer| render(scene, choices, Some(rasterizer)).map(|drawn| drawn.image);
        self.pictures += 1;
        if image(&ZBuffer) != image(&Watkins) {
            self.different += 1;
            report.miss(format!("{name}, {choices:?}: Watkins and the z-buffer draw different bytes"));
        }
        match list(scene, choices, None) {
            Ok(list) if owners => self.judge(name, &list, report),
            Ok(_) => {}
            Err(error) => report.miss(format!("{name}: {error}")),
        }
    }

    fn print(&self, report: &mut Report) {
        let counts = &self.counts;
        report.some("pixels with two or more polygons", counts.overlapped);
        report.some("pairs that pierce each other", counts.piercing);
        report.some("exact ties in front", counts.depth_ties);
        report.some("samples exactly on an outline", counts.on_outline);
        report.some("cut polygons", counts.cut);
        report.some("scenes with transparent surfaces", self.transparent);
        self.print_totals("of random scenes", report);
    }

    fn print_totals(&self, of: &str, report: &mut Report) {
        report.count(format!("pictures {of}"), self.pictures);
        report.none(format!("pictures {of} in which Watkins and the z-buffer differ"), self.different);
        report.some(format!("samples {of} that a polygon covers"), self.counts.covered);
        report.none(format!("samples {of} against the exact owner"), self.against_contract);
        report.none(format!("samples {of} wrong by true depth, beyond {SINGLE_BAND:.1e} of it"), self.beyond_band);
        report.count(format!("samples {of} within that band"), self.disputed);
        report.count(format!("of them drawn otherwise, {of}"), self.within_band);
    }
}
