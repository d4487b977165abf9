//! Coverage: every rasterizer that draws areas against [`exact`], sample by sample.
//!
//! Lists of one polygon show its whole coverage; lists of several, with crossing depths' simplest case, a depth of its own for
//! each, show that the nearest one owns every sample. Polygons come nearer in list order, so a z-buffer puts each covered
//! sample of each: the sum of its puts tells of samples that are hidden in the end.
//!
//! Three polygons in ten are adversarial: corners on sample centers, edges along them, slivers, finest steps, notches, touches.

use super::scenes::{AREA_RASTERIZERS, draw, outline};
use super::tally::{Tally, sum};
use super::{Effort, Random, Report};
use crate::oracle::exact::{Rules, judge};
use crate::screen::{DrawList, Grid};

const BITS: [u32; 5] = [8, 0, 4, 12, 16];

/// Draws random lists and compares every sample.
pub(super) fn run(effort: &Effort, report: &mut Report) {
    let lists = effort.count(LISTS_QUICK, LISTS_FULL);
    let tally = sum(lists, |number, tally| {
        let mut random = effort.random(number);
        let list = list(number, &mut random, tally);
        compare(&list, tally);
    });
    report.count("lists", lists);
    report.count("polygons", tally.of("polygons"));
    report
        .measure("share of adversarial polygons", tally.of("adversarial") as f64 / tally.of("polygons").max(1) as f64);
    report.count("pairs of polygon and sample that were judged", tally.of("tests"));
    report.count("samples compared, of all rasterizers", tally.of("compared"));
    report.some("samples exactly on an edge or corner", tally.of("on outline"));
    report.some("samples with two or more covering polygons", tally.of("overlapped"));
    for (name, _) in AREA_RASTERIZERS {
        report.none(format!("wrong samples of {name}"), tally.of(name));
    }
    report.none("samples put too often or not at all, z-buffer and scan line", tally.of("puts"));
    tally.examples.iter().for_each(|example| report.miss(example));
}

const LISTS_QUICK: u64 = 20_000;
const LISTS_FULL: u64 = 1_100_000;

/// One polygon, or up to six over one another, in a picture of any form.
fn list(number: u64, random: &mut Random, tally: &mut Tally) -> DrawList {
    let mut side = || 1 << random.below(7);
    let (width, height) = (side(), side());
    let (width, height) =
        (width + random.below(u64::from(width)) as u32, height + random.below(u64::from(height)) as u32);
    let mut list = DrawList::new(width, height);
    list.grid = Grid { bits: BITS[(number % 5) as usize] };
    let polygons = if random.once_in(2) { 1 } else { 2 + random.below(5) };
    for index in 0..polygons {
        let adversarial = random.below(10) < 3;
        let corners = outline(random, (width, height), adversarial);
        list.push_flat(&corners, 1.0 + index as f64, [1.0; 3]);
        tally.add("adversarial", u64::from(adversarial));
    }
    tally.add("polygons", polygons);
    list
}

fn compare(list: &DrawList, tally: &mut Tally) {
    let exact = judge(list, &Rules::CONTRACT);
    tally.add("tests", exact.counts.tests);
    tally.add("on outline", exact.counts.on_outline);
    tally.add("overlapped", exact.counts.overlapped);
    let covered: u64 = exact.covering.iter().map(|&count| u64::from(count)).sum();
    for (name, rasterizer) in AREA_RASTERIZERS {
        let drawn = draw(list, rasterizer, 1);
        let (wrong, disputed) = exact.differences(&drawn.owner);
        tally.add("compared", exact.counts.samples);
        tally.add(name, wrong + disputed);
        if name != "watkins" {
            tally.add("puts", drawn.puts.puts.abs_diff(covered) + drawn.puts.stray_writes);
        }
        if wrong > 0 {
            tally.example(|| format!("{name}: {wrong} samples wrong in {:?}", corners(list)));
        }
    }
}

/// The corners of all polygons, for a message.
fn corners(list: &DrawList) -> Vec<Vec<(f64, f64)>> {
    list.polygons().map(|polygon| polygon.vertices().iter().map(|v| (v.x, v.y)).collect()).collect()
}
