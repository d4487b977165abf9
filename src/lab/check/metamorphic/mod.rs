//! Metamorphic: a changed scene must give the same picture, or the picture changed in a way that is known.
//!
//! random scene -> picture; the scene changed -> picture, changed back -> compare
//!
//! No oracle says what the picture is; two runs of the program must agree. Two kinds of relation: *exact* ones leave every number alone that
//! a sample depends on, and every byte must be the same. *Rounded* ones turn a plane or an outline about, so that last digits differ: which
//! polygon shows must be the same and its light within [`SLACK`]. Either way a *tie set* is predicted beforehand: samples whose two nearest
//! polygons are equally near (by the contract, or within the band of true depth), and samples exactly on an outline where the relation
//! turns the tie rule about. Nothing else is excused.
//!
//! Space: samples. Source: T. Y. Chen, S. C. Cheung, S. M. Yiu, "Metamorphic Testing", HKUST-CS98-01, 1998.
//! Cost: some 20 pictures a scene.

mod lists;
mod scenes;

use super::random_scenes::hard;
use super::{Effort, Random, Report};
use crate::color::Rgb;
use crate::image::Image;
use crate::oracle::exact::{Rules, judge};
use crate::plan::{Choices, Culling, DepthFormat, Shading};
use crate::raster::ZBuffer;
use crate::render::{Rendered, render};
use crate::scene::Scene;
use crate::screen::DrawList;

/// Light that rounded relations may be off: a fortieth of a level.
const SLACK: f32 = 1e-4;

/// What a relation is told: a scene, how it is drawn, its picture, and numbers for whatever is random.
struct Case {
    scene: Scene,
    choices: Choices,
    plain: Rendered,
    random: Random,
}

/// Two pictures that must be one.
struct Pair {
    expected: Image,
    actual: Image,
    /// Predicted ties.
    excused: Vec<bool>,
    /// Light that may differ: 0 for exact relations.
    slack: f32,
}

/// A relation: its name, and the pair for a case; `None` where the case has nothing to change.
type Relation = (&'static str, fn(&mut Case) -> Result<Option<Pair>, String>);

const RELATIONS: [Relation; 14] = [
    ("order of polygons", scenes::order),
    ("where outlines start", scenes::start),
    ("shift by whole pixels", scenes::shift),
    ("scale by a power of two", scenes::scale),
    ("x and y exchanged", scenes::exchange),
    ("mirrored", scenes::mirror),
    ("order of merging", scenes::merge),
    ("all needs computed", scenes::full_needs),
    ("written as NFF and read", scenes::written),
    ("threads", lists::threads),
    ("bands of rows", lists::bands),
    ("split by a chord", lists::chord),
    ("corners inserted on edges", lists::inserted),
    ("dumped and read", lists::dumped),
];

/// Tries every relation on every scene.
pub(super) fn run(effort: &Effort, report: &mut Report) {
    let scenes = effort.count(120, 10_000).max(12);
    let mut sums = vec![Sum::default(); RELATIONS.len()];
    for number in 0..scenes {
        let seed = effort.seed.wrapping_add(number);
        for ((name, relation), sum) in RELATIONS.into_iter().zip(&mut sums) {
            let outcome = case(seed).and_then(|mut case| relation(&mut case));
            match outcome {
                Ok(Some(pair)) => sum.add(name, seed, &pair, report),
                Ok(None) => {}
                Err(error) => report.miss(format!("{name}, scene {seed}: {error}")),
            }
        }
    }
    report.count("random scenes", scenes);
    for ((name, _), sum) in RELATIONS.into_iter().zip(&sums) {
        report.some(format!("pictures: {name}"), sum.pictures);
        report.count(format!("predicted ties: {name}"), sum.excused);
        report.count(format!("ties that differ: {name}"), sum.tied);
        report.none(format!("other samples that differ: {name}"), sum.wrong);
    }
    scenes::reach(effort, report);
}

/// What was found for one relation.
#[derive(Clone, Default)]
struct Sum {
    pictures: u64,
    excused: u64,
    tied: u64,
    wrong: u64,
}

impl Sum {
    fn add(&mut self, name: &str, seed: u64, pair: &Pair, report: &mut Report) {
        self.pictures += 1;
        self.excused += pair.excused.iter().filter(|&&excused| excused).count() as u64;
        let (expected, actual) = (pair.expected.pixels(), pair.actual.pixels());
        if expected.len() != actual.len() {
            self.wrong += expected.len() as u64;
            report.miss(format!("{name}, scene {seed}: another size"));
            return;
        }
        let apart = |at: &usize| !alike(expected[*at], actual[*at], pair.slack);
        let (tied, wrong): (Vec<usize>, Vec<usize>) =
            (0..expected.len()).filter(apart).partition(|&at| pair.excused.get(at).copied().unwrap_or(false));
        self.tied += tied.len() as u64;
        self.wrong += wrong.len() as u64;
        if let Some(&at) = wrong.first() {
            let (column, row) = (at % pair.expected.width(), at / pair.expected.width());
            let (was, is) = (expected[at], actual[at]);
            report.miss(format!("{name}, scene {seed}: sample {column},{row} was {was:?}, is {is:?}"));
        }
    }
}

fn alike(a: Rgb<f32>, b: Rgb<f32>, slack: f32) -> bool {
    a == b || a.to_array().into_iter().zip(b.to_array()).all(|(a, b)| (a - b).abs() <= slack)
}

/// The scene of a seed, opaque, and its picture.
fn case(seed: u64) -> Result<Case, String> {
    let mut scene = hard(seed);
    scene.surfaces.iter_mut().for_each(|surface| surface.material.opacity = Rgb::WHITE);
    let choices = Choices {
        shading: [Shading::Gouraud, Shading::Phong, Shading::Flat][(seed % 3) as usize],
        depth: [DepthFormat::F32, DepthFormat::F64][(seed / 3 % 2) as usize],
        subpixel_bits: [8, 4, 16, 11][(seed / 6 % 4) as usize],
        culling: Culling::None,
        threads: Some(1),
        ..Choices::default()
    };
    let plain = drawn(&scene, &choices)?;
    Ok(Case { scene, choices, plain, random: Random::new(seed ^ 0x6D65_7461) })
}

fn drawn(scene: &Scene, choices: &Choices) -> Result<Rendered, String> {
    render(scene, choices, Some(&ZBuffer)).map_err(|error| error.to_string())
}

impl Case {
    /// Every byte the same, but where the two nearest polygons are equally near.
    fn exact(&self, actual: Image) -> Pair {
        let excused = judge(&self.plain.list, &Rules::CONTRACT).disputed;
        Pair { expected: self.plain.image.clone(), actual, excused, slack: 0.0 }
    }

    /// Every byte the same, no excuse.
    fn bytes(&self, actual: Image) -> Pair {
        Pair { expected: self.plain.image.clone(), actual, excused: Vec::new(), slack: 0.0 }
    }

    /// The same but for last digits; where `outlines`, samples exactly on an outline are ties, too.
    fn rounded(&self, actual: Image, outlines: bool) -> Pair {
        let mut excused = judge(&self.plain.list, &Rules::TRUE_DEPTH).disputed;
        if outlines {
            on_outline(&self.plain.list, &mut excused);
        }
        Pair { expected: self.plain.image.clone(), actual, excused, slack: SLACK }
    }
}

/// Marks the samples whose center lies exactly on an edge, in whole half steps of the grid.
fn on_outline(list: &DrawList, marked: &mut [bool]) {
    let steps = list.grid.steps();
    for polygon in list.polygons() {
        let corners: Vec<[i64; 2]> =
            polygon.vertices().iter().map(|v| [v.x, v.y].map(|at| 2 * list.grid.fixed(at))).collect();
        for (a, b) in crate::math::edges(&corners) {
            let rows = a[1].min(b[1]).div_euclid(2 * steps)..=a[1].max(b[1]).div_euclid(2 * steps);
            for row in rows.start().max(&0).to_owned()..=*rows.end().min(&(i64::from(list.height) - 1)) {
                let y = (2 * row + 1) * steps;
                let columns = a[0].min(b[0]).div_euclid(2 * steps)..=a[0].max(b[0]).div_euclid(2 * steps);
                for column in columns.start().max(&0).to_owned()..=*columns.end().min(&(i64::from(list.width) - 1)) {
                    let x = (2 * column + 1) * steps;
                    let cross =
                        i128::from(b[0] - a[0]) * i128::from(y - a[1]) - i128::from(b[1] - a[1]) * i128::from(x - a[0]);
                    if cross == 0 {
                        marked[(row * i64::from(list.width) + column) as usize] = true;
                    }
                }
            }
        }
    }
}
