//! Tri: splitting keeps its promises on weakly simple rings of whole numbers, in every plane, at every scale.
//!
//! Promises: n - 2 triangles over the given corners; doubled areas that are not negative and add up to the ring's, in `i128`; every
//! edge of the ring in one triangle, every diagonal in two that walk it in opposite directions, and so no corner inside
//! an edge that others end on; the same triangles at 2^-300 and 2^300 times the size; all this wherever the ring starts.
//! Outlines whose edges truly cross get their n - 2 triangles, too, and every one of them is flagged where a user sees it: the
//! whole geometry stage runs on it, and its count of polygons that cross themselves, which `--stats` prints, must be 1. Rings that
//! only touch themselves must not be counted. How many crossings splitting alone would have reported is shown beside.

use super::random_scenes::{camera, facets, scene, surface};
use super::rings::{FORMS, Whole, doubled_area, ring};
use super::tally::{Tally, sum};
use super::{Effort, Random, Report};
use crate::geometry;
use crate::geometry::split::{SplitReport, SplitScratch, split};
use crate::math::{Vec3, pow};
use crate::plan::{Accepts, Choices, Culling, Plan, Shading};
use crate::report::Counts;
use crate::scene::Material;
use crate::screen::DrawList;

/// Splits rings and outlines that cross themselves.
pub(super) fn run(effort: &Effort, report: &mut Report) {
    let (rings, crossings) = (effort.count(20_000, 1_000_000), effort.count(20_000, 1_000_000));
    let mut tally = sum(rings, |number, tally| one_ring(number, &mut effort.random(number), tally));
    tally.append(sum(crossings, |number, tally| one_crossing(&mut effort.random(1 << 40 | number), tally)));
    report.count("rings", rings);
    FORMS.iter().for_each(|form| report.some(*form, tally.of(form)));
    report.count("splits (4 starts, 3 scales)", tally.of("splits"));
    report.count("triangles", tally.of("triangles"));
    report.some("rings with two corners in one place", tally.of("doubled"));
    report.some("triangles without area", tally.of("flat"));
    report.none("splits with another number of triangles than n - 2", tally.of("number"));
    report.none("splits of another area, or with a triangle that turns the wrong way", tally.of("area"));
    report.none("splits with an edge that has no partner", tally.of("edges"));
    report.none("splits with a forced ear", tally.of("forced"));
    report.none("rings split otherwise at another scale", tally.of("scale"));
    report.some("outlines that cross themselves", tally.of("crossings"));
    // Those that turn once in all, like a coiled ribbon, have true ears only.
    report.count("of them not noticed by splitting alone", tally.of("not reported"));
    report.none("of them not flagged in the counts of the picture", tally.of("not flagged"));
    report.none("rings that only touch themselves, and are flagged", tally.of("false alarms"));
    tally.examples.iter().for_each(|example| report.miss(example));
}

type Triangles = Vec<[u32; 3]>;

/// Puts whole numbers on a plane of space: two axes as they are, the third tilted, all times 2^`exponent`.
fn in_space(ring: &[Whole], facing: u64, exponent: i32) -> (Vec<Vec3>, Vec3) {
    let scale = pow(2.0, f64::from(exponent));
    let (dropped, tilt) = ((facing % 3) as usize, [0.0, 0.5, -0.25][(facing / 3 % 3) as usize]);
    let place = |p: &Whole| {
        let (u, v) = (p[0] as f64, p[1] as f64);
        let mut place = [0.0; 3];
        (place[(dropped + 1) % 3], place[(dropped + 2) % 3]) = (u, v);
        place[dropped] = tilt * u;
        Vec3::from_array(place) * scale
    };
    let mut normal = [0.0; 3];
    normal[dropped] = 1.0;
    normal[(dropped + 1) % 3] = -tilt;
    (ring.iter().map(place).collect(), Vec3::from_array(normal))
}

fn triangles(ring: &[Whole], facing: u64, exponent: i32) -> (Triangles, SplitReport) {
    let (outline, normal) = in_space(ring, facing, exponent);
    let mut triangles = Vec::new();
    let report = split(&outline, normal, &mut SplitScratch::default(), &mut triangles);
    (triangles, report)
}

fn one_ring(number: u64, random: &mut Random, tally: &mut Tally) {
    let form = (number % FORMS.len() as u64) as usize;
    let mut ring = ring(form, random);
    let facing = random.below(9);
    tally.add(FORMS[form], 1);
    let mut places = ring.clone();
    places.sort_unstable();
    places.dedup();
    tally.add("doubled", u64::from(places.len() < ring.len()));
    for start in 0..4 {
        let (split, report) = triangles(&ring, facing, 0);
        tally.add("splits", 1);
        tally.add("triangles", split.len() as u64);
        tally.add("flat", report.flat as u64);
        let failures = failures(&ring, &split, report);
        failures.iter().for_each(|failure| tally.add(failure, 1));
        if !failures.is_empty() {
            tally.example(|| format!("{failures:?} for {}, facing {facing}: {ring:?}", FORMS[form]));
        }
        if start == 0 {
            let is_flagged = counts(&ring, facing).is_none_or(|counts| counts.self_crossing > 0);
            tally.add("false alarms", u64::from(is_flagged));
            if is_flagged {
                tally.example(|| format!("flagged, {}, facing {facing}: {ring:?}", FORMS[form]));
            }
            let others = [-300, 300].map(|exponent| triangles(&ring, facing, exponent).0);
            tally.add("splits", 2);
            tally.add("scale", u64::from(others.iter().any(|other| *other != split)));
        }
        let by = ring.len() / 4;
        ring.rotate_left(by.max(1));
    }
}

/// The promises that do not hold, by the names of their counts.
fn failures(ring: &[Whole], split: &Triangles, report: SplitReport) -> Vec<&'static str> {
    let areas = split.iter().map(|t| doubled_area(&t.map(|corner| ring[corner as usize])));
    let is_positive = areas.clone().all(|area| area >= 0);
    let failing = [
        ("number", split.len() + 2 != ring.len()),
        ("area", !is_positive || areas.sum::<i128>() != doubled_area(ring)),
        ("edges", !has_all_edges(ring.len(), split)),
        ("forced", report.forced > 0),
    ];
    failing.into_iter().filter_map(|(name, fails)| fails.then_some(name)).collect()
}

/// Whether every edge of the ring is walked once, and every other edge once in each direction.
fn has_all_edges(corners: usize, split: &Triangles) -> bool {
    let mut walked: Vec<(u32, u32)> = split.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]).collect();
    // The ring, walked backward, closes everything.
    walked.extend((0..corners as u32).map(|corner| ((corner + 1) % corners as u32, corner)));
    let mut backward: Vec<(u32, u32)> = walked.iter().map(|&(a, b)| (b, a)).collect();
    walked.sort_unstable();
    backward.sort_unstable();
    walked == backward && walked.windows(2).all(|pair| pair[0] != pair[1])
}

/// A star with two of its corners exchanged, or any points: where edges cross, splitting must say so.
fn one_crossing(random: &mut Random, tally: &mut Tally) {
    let corners = 4 + random.below(9);
    let mut outline: Vec<Whole> =
        (0..corners).map(|_| [random.below(64) as i64 * 2, random.below(64) as i64 * 2]).collect();
    if random.once_in(2) {
        outline = ring(1, random);
        let (a, b) = (random.below(outline.len() as u64) as usize, random.below(outline.len() as u64) as usize);
        outline.swap(a, b);
    }
    if doubled_area(&outline) < 0 {
        outline.reverse();
    }
    if !crosses(&outline) {
        return;
    }
    tally.add("crossings", 1);
    let facing = random.below(9);
    let (split, report) = triangles(&outline, facing, 0);
    tally.add("number", u64::from(split.len() + 2 != outline.len()));
    tally.add("not reported", u64::from(report.forced == 0 && !report.rounded));
    if counts(&outline, facing).is_none_or(|counts| counts.self_crossing != 1) {
        tally.add("not flagged", 1);
        tally.example(|| format!("not flagged, facing {facing}: {outline:?}"));
    }
}

/// What the geometry stage counts in a scene of this outline alone; `None` when there is no plan.
///
/// Whole, in view, and not edge-on: the numbers of a ring are below 2^17, so sums of them and these offsets are exact.
fn counts(outline: &[Whole], facing: u64) -> Option<Counts> {
    let mut offset = Vec3::Z * pow(2.0, 21.0);
    offset[(facing % 3) as usize] += pow(2.0, 18.0);
    let corners = in_space(outline, facing, 0).0.into_iter().map(|corner| corner + offset).collect();
    let scene = scene(camera(16, 16), vec![surface(Material::default(), facets(&[corners]))]);
    let choices = Choices { shading: Shading::Flat, culling: Culling::None, ..Choices::default() };
    let plan = Plan::new(&scene, &choices, Accepts::AnyPolygon).ok()?;
    let counts = geometry::run(&scene, &plan, &mut DrawList::new(0, 0));
    // Culled or clipped, it would say nothing.
    (counts.polygons == 1 && counts.inside == 1).then_some(counts)
}

/// Whether two edges cross in a point inside both, by `i128`.
fn crosses(outline: &[Whole]) -> bool {
    let turn = |a: &Whole, b: &Whole, c: &Whole| doubled_area(&[*a, *b, *c]).signum();
    let edges: Vec<(&Whole, &Whole)> = crate::math::edges(outline).collect();
    edges.iter().enumerate().any(|(index, &(a, b))| {
        edges[..index].iter().any(|&(c, d)| turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0)
    })
}
