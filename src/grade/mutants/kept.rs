//! Mistakes about which depth is compared, where it is taken, kept and addressed.

use super::{Mutant, each_with, family, mutant};
use crate::grade::listed::Mixed;
use crate::grade::rules::{
    Address, Blending, DepthFrom, DepthPoint, Front, Interpolation, Kept, Memory, Rules, Shape, Summed, Walk,
};

const PAGE: &str = "docs/conventions.md";
const PLACE: [&str; 4] = [
    "depth at another place",
    "Depth is taken beside the sample: at a neighbor, at a fixed column or row (a plane without its x or y), or at one place for all.",
    "Take depth at (x + 0.5, y + 0.5), where coverage is asked for.",
    PAGE,
];
const KEPT: [&str; 4] = [
    "another depth kept",
    "The depth that is kept is not that of what is shown: it is kept only the first time, also of what is hidden, or added up.",
    "Keep the depth of a fragment when it is shown, and only then.",
    PAGE,
];
const ADDRESS: [&str; 4] = [
    "depth memory addressed wrongly",
    "Depth is read or written at the place of another sample: with another row length, at a neighbor, or where there are too few places.",
    "The depth of a sample stands at y * width + x.",
    PAGE,
];
const FEW: [&str; 4] = [
    "polygons of a sample left out",
    "Only the first few polygons at a sample are looked at.",
    "Every polygon that covers a sample is compared.",
    PAGE,
];
const SECOND: [&str; 4] = [
    "the second nearest shown",
    "The nearest polygon but one is shown.",
    "After sorting, the nearest is the first: index 0.",
    PAGE,
];
const CORNER: [&str; 4] = [
    "one depth a polygon",
    "A whole polygon is compared by one depth, so polygons cannot pierce or overlap in a ring.",
    "Compare at every sample the depth that the plane of 1/w has there.",
    PAGE,
];
const STRAIGHT: [&str; 4] = [
    "w drawn out straight",
    "w itself is interpolated linearly on the screen, and it is not linear there.",
    "1/w is linear on the screen: interpolate that.",
    PAGE,
];
const STEPS: [&str; 4] = [
    "depth in too few steps",
    "Depth is kept in steps so coarse that different depths become equal.",
    "Keep depth as a number with a fraction: f32 at least.",
    PAGE,
];
const MARGIN: [&str; 4] = [
    "a margin in the comparison",
    "A polygon must be nearer by a margin to be shown, or may be farther by one.",
    "Compare with >, without a margin: depths are decided by the last digit.",
    PAGE,
];
const TEXT: [&str; 4] =
    ["distances sorted as text", "Distances are compared as texts: 100 comes before 20.", "Compare numbers.", PAGE];
const FAR: [&str; 4] = [
    "far wins",
    "The farther polygon hides the nearer: depth is compared the wrong way.",
    "Depth is 1/w, larger is nearer: a fragment is shown when its depth is greater than what is there.",
    PAGE,
];
const LAST: [&str; 4] = [
    "last wins",
    "The polygon that comes last is shown, whatever its depth: nothing is compared, or what was compared is not kept.",
    "Compare with the depth kept at the sample, and keep the depth of what is shown.",
    PAGE,
];
const FIRST: [&str; 4] = [
    "first wins",
    "The polygon that comes first keeps its samples, whatever comes after.",
    "A nearer fragment replaces what is there, however early that came.",
    PAGE,
];
const GLASS: [&str; 4] = [
    "glass shown before what hides it",
    "Transparent polygons are blended over what is in front of them, too.",
    "Only what is nearer than the opaque depth is blended.",
    "docs/transparency.md",
];

/// All of them.
pub(super) fn all() -> Vec<Mutant> {
    [of_depth(), anywhere()].concat()
}

/// Those that are tried where depth is what is asked for; elsewhere too little shows to tell them apart.
pub(super) fn of_depth() -> Vec<Mutant> {
    [places(), memory(), addresses(), one_depth(), steps(), glass()].concat()
}

/// Those that are tried in all labs.
pub(super) fn anywhere() -> Vec<Mutant> {
    let pixel = mutant(PIXEL, |rules| depth_at(rules, Address::Pixel));
    [vec![pixel], orders(), sums()].concat()
}

fn places() -> Vec<Mutant> {
    let beside: [fn(&mut Rules, f64); 3] = [
        |rules, by| rules.depth_point = DepthPoint::Beside(by, 0.0),
        |rules, by| rules.depth_point = DepthPoint::Beside(0.0, by),
        |rules, by| rules.depth_point = DepthPoint::Beside(by, by),
    ];
    let fixed: [fn(&mut Rules, f64); 2] =
        [|rules, x| rules.depth_point = DepthPoint::AtX(x), |rules, y| rules.depth_point = DepthPoint::AtY(y)];
    let beside = beside.iter().flat_map(|change| family(PLACE, &[-1.0, 1.0, -0.5, 0.5, 2.0, -2.0], *change));
    let fixed = fixed.iter().flat_map(|change| family(PLACE, &[0.5, 0.0, 1.0, 4.0, 6.0, 8.0], *change));
    beside.chain(fixed).collect()
}

fn memory() -> Vec<Mutant> {
    vec![
        mutant(KEPT, |rules| rules.kept = Kept::First),
        mutant(KEPT, |rules| rules.kept = Kept::Latest),
        mutant(KEPT, |rules| rules.kept = Kept::Sum),
        mutant(KEPT, |rules| rules.kept = Kept::Farthest),
        mutant(FEW, |rules| rules.most_at_sample = 2),
        mutant(FEW, |rules| rules.most_at_sample = 3),
        mutant(SECOND, |rules| rules.front = Front::Second),
        mutant(TEXT, |rules| rules.depth = DepthFrom::AsText(100.0)),
    ]
}

/// With each order in which samples of a polygon are drawn: where they share a place, the first keeps it.
fn addresses() -> Vec<Mutant> {
    let addresses = [
        mutant(ADDRESS, |rules| depth_at(rules, Address::TimesHeight)),
        mutant(ADDRESS, |rules| depth_at(rules, Address::Stride(-1))),
        mutant(ADDRESS, |rules| depth_at(rules, Address::Row)),
        mutant(ADDRESS, |rules| depth_at(rules, Address::Column)),
        mutant(ADDRESS, |rules| depth_at(rules, Address::One)),
    ];
    let walks: [fn(&mut Rules); 4] = [
        |_| (),
        |rules| rules.memory.walk = Walk::Columns,
        |rules| rules.memory.walk = Walk::Blocks(2),
        |rules| rules.memory.walk = Walk::BlocksOfBounds(2),
    ];
    let read: [fn(&mut Rules, f64); 2] =
        [|rules, by| rules.memory.read_beside = (by as i32, 0), |rules, by| rules.memory.read_beside = (0, by as i32)];
    let written: [fn(&mut Rules, f64); 2] = [
        |rules, by| rules.memory.written_beside = (by as i32, 0),
        |rules, by| rules.memory.written_beside = (0, by as i32),
    ];
    let beside = read.iter().chain(&written).flat_map(|change| family(ADDRESS, &[-1.0, 1.0], *change));
    beside.chain(each_with(&addresses, &walks)).collect()
}

const PIXEL: [&str; 4] = [
    "one depth a pixel",
    "Depth is taken or kept once a pixel, not at every sample.",
    "Every sample has a depth of its own.",
    PAGE,
];

fn depth_at(rules: &mut Rules, depth_at: Address) {
    rules.memory = Memory { depth_at, ..Memory::RIGHT };
}

/// One depth for a polygon, or for each triangle that it is cut into; that depth is what values are divided by, too.
fn one_depth() -> Vec<Mutant> {
    let depths = [
        mutant(CORNER, |rules| rules.depth = DepthFrom::Corner(0)),
        mutant(CORNER, |rules| rules.depth = DepthFrom::Corner(1)),
        mutant(CORNER, |rules| rules.depth = DepthFrom::Corner(2)),
        mutant(CORNER, |rules| rules.depth = DepthFrom::Corner(usize::MAX)),
        mutant(CORNER, |rules| rules.depth = DepthFrom::NearestCorner),
        mutant(CORNER, |rules| rules.depth = DepthFrom::FarthestCorner),
        mutant(CORNER, |rules| rules.depth = DepthFrom::MeanCorner),
        mutant(CORNER, |rules| rules.depth = DepthFrom::MeanDistance),
        mutant(CORNER, |rules| rules.depth = DepthFrom::Ends),
        mutant(STRAIGHT, |rules| rules.depth = DepthFrom::LinearW),
    ];
    let fan: fn(&mut Rules) = |rules| rules.shape = Shape { is_fan: true, ..Shape::RIGHT };
    let alone: fn(&mut Rules) = |_| ();
    each_with(&depths, &[alone, fan, divides, divides_all])
}

fn divides(rules: &mut Rules) {
    (rules.divides_by_kept, rules.spares_exact) = (true, true);
}

fn divides_all(rules: &mut Rules) {
    rules.divides_by_kept = true;
}

fn steps() -> Vec<Mutant> {
    let numbers =
        [4.0, 8.0, 10.0, 16.0, 20.0, 32.0, 50.0, 64.0, 100.0, 127.0, 128.0, 200.0, 255.0, 256.0, 500.0, 512.0];
    let fine = [1000.0, 1024.0, 4096.0];
    let all = [numbers.as_slice(), &fine].concat();
    let cut = family(STEPS, &all, |rules, steps| rules.depth = DepthFrom::Steps(steps));
    let rounded = family(STEPS, &all, |rules, steps| rules.depth = DepthFrom::RoundSteps(steps));
    let far = family(STEPS, &[1.0, 10.0, 100.0], |rules, steps| rules.depth = DepthFrom::DistanceSteps(steps));
    let kinds = [cut, rounded].concat();
    let wraps = family(STEPS, &[255.0, 256.0, 65_535.0, 65_536.0], |rules, steps| {
        rules.depth = DepthFrom::Wraps(steps, (steps + 1.0).log2().floor().exp2());
    });
    let kept: [fn(&mut Rules, f64); 2] =
        [|rules, steps| rules.kept = Kept::Cut(steps), |rules, steps| rules.kept = Kept::Rounded(steps)];
    let kept: Vec<Mutant> = kept.iter().flat_map(|change| family(STEPS, &numbers, *change)).collect();
    let margins = [-0.001, 0.0001, 0.002, 0.005, 0.03, 0.5, 1.0];
    let margin = family(MARGIN, &margins, |rules, margin| rules.margin = margin);
    let from_far = family(MARGIN, &margins, |rules, margin| (rules.margin, rules.clear) = (margin, margin));
    let capped: fn(&mut Rules) = |rules| rules.capped = 1.0;
    let alone: fn(&mut Rules) = |_| ();
    [each_with(&kinds, &[alone, capped, divides, divides_all]), far, wraps, kept, margin, from_far].concat()
}

/// What else is wrong with glass, and with equals, where depth is compared the wrong way or not at all.
fn orders() -> Vec<Mutant> {
    let fronts = [
        mutant(FAR, |rules| rules.front = Front::Farthest),
        mutant(LAST, |rules| rules.front = Front::Last),
        mutant(FIRST, |rules| rules.front = Front::First),
        mutant(FAR, |rules| (rules.front, rules.later_wins_ties) = (Front::Farthest, true)),
        mutant(FAR, |rules| (rules.front, rules.depth) = (Front::Farthest, DepthFrom::LinearW)),
        mutant(FAR, |rules| {
            (rules.front, rules.depth, rules.later_wins_ties) = (Front::Farthest, DepthFrom::LinearW, true)
        }),
    ];
    let glass: [fn(&mut Rules); 11] = [
        |rules| rules.blending = Blending::EverywhereSorted,
        |rules| rules.blending = Blending::EverywhereTurned,
        |rules| rules.blending = Blending::AtEnd,
        |_| (),
        |rules| rules.blending = Blending::Invisible,
        |rules| rules.blending = Blending::Ignored,
        |rules| rules.blending = Blending::AtOnce,
        |rules| rules.blending = Blending::AtOnceKept,
        |rules| rules.blending = Blending::AtOnceUntested,
        |rules| rules.blending = Blending::ListOrder,
        |rules| rules.blending = Blending::Turned,
    ];
    let untested = [
        mutant(GLASS, |rules| rules.blending = Blending::EverywhereSorted),
        mutant(GLASS, |rules| rules.blending = Blending::EverywhereTurned),
        mutant(GLASS, |rules| rules.blending = Blending::AtOnceUntested),
    ];
    [untested.to_vec(), each_with(&fronts, &glass)].concat()
}

const SUMMED: [&str; 4] = [
    "added up inexactly along spans",
    "The step of a value or of depth from sample to sample is cut or rounded (to whole levels, to a few bits), and the error adds up.",
    "Keep the step as it is, or evaluate the plane anew at every sample.",
    "docs/scanline.md",
];

const ALONG: [&str; 4] = [
    "affine along spans",
    "Along rows values are interpolated linearly on the screen, along edges in space.",
    "Interpolate value / w and 1/w along edges and along rows, and divide at every sample.",
    "docs/scanline.md",
];

/// Depth and values that are added up along a span.
fn sums() -> Vec<Mutant> {
    let parts = [8.0, 10.0, 16.0, 32.0, 64.0, 100.0, 127.0, 128.0, 255.0, 256.0, 512.0, 1000.0];
    let ways: [fn(&mut Rules, f64); 8] = [
        |rules, parts| rules.depth = DepthFrom::Summed(summed(parts, true, false)),
        |rules, parts| rules.depth = DepthFrom::Summed(summed(parts, false, false)),
        |rules, parts| rules.values = Interpolation::Summed(summed(parts, true, false)),
        |rules, parts| rules.values = Interpolation::Summed(summed(parts, false, false)),
        |rules, parts| rules.values = Interpolation::Summed(summed(parts, true, true)),
        |rules, parts| rules.values = Interpolation::Summed(summed(parts, false, true)),
        |rules, parts| rules.values = Interpolation::SummedOverW(summed(parts, true, false)),
        |rules, parts| rules.values = Interpolation::SummedOverW(summed(parts, false, false)),
    ];
    let straight = mutant(ALONG, |rules| rules.values = Interpolation::Summed(summed(f64::INFINITY, false, true)));
    let all: Vec<Mutant> = ways.iter().flat_map(|change| family(SUMMED, &parts, *change)).collect();
    [vec![straight], all].concat()
}

const fn summed(parts: f64, is_cut: bool, between_samples: bool) -> Summed {
    Summed { parts, is_cut, between_samples }
}

const SHARES: [&str; 4] = [
    "glass mixed in wrong shares",
    "The shares of glass and of what is behind it are wrong.",
    "color = own * opacity + behind * (1 - opacity).",
    "docs/transparency.md",
];
const NEAREST_FIRST: [&str; 4] = [
    "glass blended nearest first",
    "Transparent polygons are blended from the nearest to the farthest, each over the one before.",
    "The farthest is blended first, the nearest last.",
    "docs/transparency.md",
];
const GLASS_KEPT: [&str; 4] = [
    "glass keeps its depth",
    "Transparent polygons write their depth, so that what is drawn later behind them is lost.",
    "Only what is opaque writes depth.",
    "docs/transparency.md",
];

fn glass() -> Vec<Mutant> {
    vec![
        mutant(SHARES, |rules| rules.mixed = Mixed::Added),
        mutant(SHARES, |rules| rules.mixed = Mixed::Whole),
        mutant(SHARES, |rules| rules.mixed = Mixed::NothingBehind),
        mutant(SHARES, |rules| rules.mixed = Mixed::Sum),
        mutant(SHARES, |rules| rules.mixed = Mixed::Alike),
        mutant(SHARES, |rules| rules.mixed = Mixed::Half),
        mutant(SHARES, |rules| rules.mixed = Mixed::Filtered),
        mutant(NEAREST_FIRST, |rules| rules.blending = Blending::NearestFirst),
        mutant(GLASS_KEPT, |rules| rules.blending = Blending::OverKept),
    ]
}
