//! Fast, in pictures: scenes that wear pictures are drawn in the z-buffer's bytes.
//!
//! random dressed scenes -> DrawList -> two pictures that must be one
//!
//! Samples of surfaces with holes are compared in lanes and decided afterwards; colors are found in lanes and multiplied by pictures. Both are an
//! order of work of `fast` alone, so every combination of filter, rule, fade and mosaic is tried against the sample-by-sample path.
//!
//! Space: samples. Cost: as [`super::fast`].

use super::fast::{Tally, any_way};
use super::random_textured::dressed;
use super::{Effort, Report};
use crate::raster::fast::Instructions;
use crate::scene::Scene;

/// Draws every scene twice; one in fifty with each set of instructions.
pub(super) fn run(effort: &Effort, report: &mut Report) {
    let scenes = effort.count(1000, 50_000);
    let (mut tally, mut worn) = (Tally::default(), Worn::default());
    for number in 0..scenes {
        let seed = effort.seed.wrapping_add(number);
        let mut random = effort.random(number ^ 0x7765_6172);
        let (scene, choices) = dressed(seed);
        let way = any_way(&mut random);
        let ways = match number % 50 {
            7 => Instructions::ALL.map(|instructions| (way.0, way.1, instructions, way.3)).to_vec(),
            _ => vec![way],
        };
        worn.count(&scene);
        tally.scene(&format!("random scene in pictures {seed}"), (&scene, &choices), &ways, report);
    }
    report.count("random scenes in pictures", tally.scenes);
    report.count("polygons in them, in pictures", tally.polygons);
    report.some("such scenes with samples that several polygons cover", tally.overlapped);
    report.some("such scenes with transparent surfaces", tally.transparent);
    report.some("such scenes with holes", worn.cut_outs);
    report.some("such scenes with fades", worn.fades);
    report.some("such scenes with mosaics", worn.mosaics);
    report.some("such scenes with two-sided surfaces", worn.two_sided);
    report.count("pictures of such scenes by fast", tally.pictures);
    report.some("polygons in tiles of such scenes drawn by edges", tally.by_edges);
    report.some("polygons in tiles of such scenes drawn by spans", tally.by_spans);
    report.none("pictures of such scenes with other bytes than the z-buffer's", tally.different);
}

/// How many scenes had surfaces that wear what.
#[derive(Default)]
struct Worn {
    cut_outs: u64,
    fades: u64,
    mosaics: u64,
    two_sided: u64,
}

impl Worn {
    fn count(&mut self, scene: &Scene) {
        let some = |what: &dyn Fn(&crate::scene::Texture) -> bool| u64::from(scene.textures.iter().any(what));
        self.cut_outs += some(&|texture| texture.cut_out.is_some());
        self.fades += some(&|texture| texture.fade.is_some());
        self.mosaics += some(&|texture| texture.mosaic.is_some());
        self.two_sided += u64::from(scene.surfaces.iter().any(|surface| surface.two_sided));
    }
}
