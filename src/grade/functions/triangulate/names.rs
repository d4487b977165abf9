//! Names: the mistakes of a triangulation that are told apart.

use super::cases::doubled_hull_area;
use super::judge::{self, corners, doubled_area, turn};
use super::replay::{Slip, decoded, first_slip};
use super::{Case, Whole};
use crate::grade::functions::Mistake;
use crate::math::edges;

/// How a mistake is recognized.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Nothing,
    OneTriangle,
    Fan,
    Strip,
    LastMissing,
    OneTooMany,
    Turned,
    NormalIgnored,
    SignIgnored,
    AlongZ,
    FromOne,
    ShrunkenList,
    Hull,
    Slip(Slip),
    StopsAtStraight,
    Size,
    PlainSigns,
}

const fn mistake(name: &'static str, cause: &'static str, rule: &'static str, kind: Kind) -> (Mistake, Kind) {
    let is_forgiven = !matches!(kind, Kind::Nothing | Kind::OneTriangle | Kind::Fan | Kind::Strip | Kind::Hull);
    let special = match kind {
        Kind::PlainSigns => 2,
        Kind::Size | Kind::NormalIgnored | Kind::SignIgnored | Kind::AlongZ | Kind::StopsAtStraight => 1,
        _ => 0,
    };
    (Mistake { name, cause, rule, is_forgiven, special }, kind)
}

const EAR_RULE: &str =
    "an ear turns the polygon's way, and no other corner of what is left lies in it or on its border";
const COUNT_RULE: &str = "n corners make n - 2 triangles";
const NORMAL_RULE: &str =
    "drop the axis of the normal's largest component; where that is negative, exchange the two axes left";

/// All of them.
pub(super) const ALL: &[(Mistake, Kind)] = &[
    mistake("nothing comes back", "there are no triangles", COUNT_RULE, Kind::Nothing),
    mistake("one triangle only", "the first triangle is the only one", COUNT_RULE, Kind::OneTriangle),
    mistake(
        "fan from one corner: wrong for concave polygons",
        "all triangles share one corner; diagonals leave the polygon where it is concave",
        EAR_RULE,
        Kind::Fan,
    ),
    mistake(
        "strip from both ends: wrong for concave polygons",
        "triangles zigzag between both ends of the list; diagonals leave the polygon where it is concave",
        EAR_RULE,
        Kind::Strip,
    ),
    mistake(
        "the last triangle is missing",
        "three corners are left at the end, and they are not put out",
        COUNT_RULE,
        Kind::LastMissing,
    ),
    mistake("one triangle too many", "the walk goes on when all is covered", COUNT_RULE, Kind::OneTooMany),
    mistake(
        "orientation turned",
        "every triangle runs the other way than the outline",
        "put Previous, Current, Next in this order",
        Kind::Turned,
    ),
    mistake(
        "the normal is not looked at",
        "the outline is taken for one in x and y, counterclockwise: others fail",
        NORMAL_RULE,
        Kind::NormalIgnored,
    ),
    mistake(
        "outlines seen from behind fail",
        "which way is convex depends on where the normal points; here it is always taken for one towards the viewer",
        NORMAL_RULE,
        Kind::SignIgnored,
    ),
    mistake(
        "only x and y are looked at",
        "outlines in planes along z have no area in x and y",
        NORMAL_RULE,
        Kind::AlongZ,
    ),
    mistake("corners counted from 1", "the first corner has the number 0", "corners are 0 to n - 1", Kind::FromOne),
    mistake(
        "places in the shrunken list",
        "triangles name places in what is left, not corners of the outline",
        "keep a list of the corners that are left, and put out its entries",
        Kind::ShrunkenList,
    ),
    mistake(
        "the outline is not looked at",
        "the triangles cover the convex hull of the corners",
        "every edge of the outline is an edge of one triangle",
        Kind::Hull,
    ),
    mistake(
        "a reflex corner is cut off",
        "the first wrong triangle turns the other way: its middle corner is reflex",
        EAR_RULE,
        Kind::Slip(Slip::Reflex),
    ),
    mistake(
        "corners inside an ear are not looked for",
        "the first wrong triangle turns the right way, but another corner is inside",
        EAR_RULE,
        Kind::Slip(Slip::Inside),
    ),
    mistake(
        "ear test ignores corners on the diagonal",
        "a diagonal runs through another corner",
        EAR_RULE,
        Kind::Slip(Slip::OnDiagonal),
    ),
    mistake(
        "straight corners are cut off",
        "three corners on one line are cut as an ear; the long edge then runs through the middle one",
        "an ear has an area; wait until another cut has bent the straight corner",
        Kind::Slip(Slip::Flat),
    ),
    mistake(
        "gives up where no ear is found",
        "all triangles are ears, but the walk stops before the end",
        "there are always two ears, unless a corner in the same place as one of the ear's counts as inside",
        Kind::Slip(Slip::Early),
    ),
    mistake(
        "stops at straight corners",
        "outlines with corners in the middle of an edge are not finished",
        COUNT_RULE,
        Kind::StopsAtStraight,
    ),
    mistake(
        "depends on the size",
        "an outline fails that is right at an ordinary size: a fixed epsilon, or products that overflow, vanish or round",
        "compare with 0, or scale by a power of two first",
        Kind::Size,
    ),
    mistake(
        "signs in plain f64",
        "the turn of three corners that are nearly on one line is rounded to the wrong sign",
        "farop::geometry::predicates::orientation has the exact sign",
        Kind::PlainSigns,
    ),
];

/// Whether `triangles`, which are right or not, are those of the mistake.
pub(super) fn fits(kind: Kind, case: &Case, triangles: &[[u32; 3]], is_right: bool) -> bool {
    let (ring, count) = (&case.ring, case.ring.len());
    let becomes_right = |changed: &[[u32; 3]]| judge::complaint(case, changed).is_none();
    let is_concave = !is_convex(ring);
    match kind {
        Kind::Nothing => !is_right && triangles.is_empty(),
        Kind::OneTriangle => triangles.len() == 1,
        Kind::Fan => is_fan(count, triangles),
        Kind::Strip => is_strip(count, triangles),
        Kind::Turned => {
            let turned: Vec<_> = triangles.iter().map(|&[a, b, c]| [c, b, a]).collect();
            !is_right && becomes_right(&turned)
        }
        Kind::NormalIgnored => match is_right {
            true => !(is_concave && case.tilt == 0 && !case.is_plain()),
            false => !case.is_plain(),
        },
        Kind::SignIgnored => {
            if is_right {
                !(is_concave && case.is_flipped)
            } else {
                case.is_flipped
            }
        }
        _ if is_right => true,
        Kind::AlongZ => case.axis != 2,
        Kind::LastMissing => judge::missing(case, triangles)
            .is_some_and(|last| triangles.len() + 3 == count && becomes_right(&[triangles, &[last]].concat())),
        Kind::OneTooMany => triangles.split_last().is_some_and(|(_, rest)| becomes_right(rest)),
        Kind::FromOne => {
            let lower: Option<Vec<_>> =
                triangles.iter().map(|t| if t.contains(&0) { None } else { Some(t.map(|index| index - 1)) }).collect();
            lower.is_some_and(|lower| becomes_right(&lower))
        }
        Kind::ShrunkenList => decoded(count, triangles).is_some_and(|meant| becomes_right(&meant)),
        Kind::Hull => is_hull(ring, triangles),
        Kind::Slip(Slip::Early) => first_slip(case, triangles) == Some(Slip::Early) && !has_straight(ring),
        Kind::Slip(slip) => first_slip(case, triangles) == Some(slip),
        Kind::StopsAtStraight => first_slip(case, triangles) == Some(Slip::Early) && has_straight(ring),
        Kind::Size => case.exponent != 0 || is_large(ring),
        Kind::PlainSigns => is_large(ring),
    }
}

fn is_large(ring: &[Whole]) -> bool {
    ring.iter().flatten().any(|x| x.abs() > 1 << 30)
}

fn turns(ring: &[Whole]) -> impl Iterator<Item = i128> {
    let count = ring.len();
    (0..count).map(move |at| turn(ring[at], ring[(at + 1) % count], ring[(at + 2) % count]))
}

fn is_convex(ring: &[Whole]) -> bool {
    turns(ring).all(|turn| turn >= 0)
}

fn has_straight(ring: &[Whole]) -> bool {
    turns(ring).any(|turn| turn == 0)
}

/// The same triangles, whichever corner each begins with and whichever way it runs.
fn same(one: &[[u32; 3]], two: &[[u32; 3]]) -> bool {
    let sorted = |triangles: &[[u32; 3]]| {
        let mut all: Vec<_> = triangles.to_vec();
        all.iter_mut().for_each(|triangle| triangle.sort_unstable());
        all.sort_unstable();
        all
    };
    sorted(one) == sorted(two)
}

fn is_fan(count: usize, triangles: &[[u32; 3]]) -> bool {
    let count = count as u32;
    let at = |corner: u32| corner % count;
    // Only fans from the first or the last corner: those from others may be chosen with care.
    [0, count - 1].iter().any(|&corner| {
        let fan: Vec<_> = (1..count - 1).map(|step| [corner, at(corner + step), at(corner + step + 1)]).collect();
        same(triangles, &fan)
    })
}

fn is_strip(count: usize, triangles: &[[u32; 3]]) -> bool {
    let (mut low, mut high, mut strip, mut from_low) = (0, count as u32 - 1, Vec::new(), true);
    while high - low >= 2 {
        if from_low {
            strip.push([low, low + 1, high]);
            low += 1;
        } else {
            strip.push([low, high - 1, high]);
            high -= 1;
        }
        from_low = !from_low;
    }
    same(triangles, &strip)
}

fn is_hull(ring: &[Whole], triangles: &[[u32; 3]]) -> bool {
    let is_named = triangles.iter().flatten().all(|&index| (index as usize) < ring.len());
    let area = |&triangle: &[u32; 3]| {
        let [a, b, c] = corners(ring, triangle);
        turn(a, b, c).abs()
    };
    let hull = doubled_hull_area(ring);
    let count = ring.len() as u32;
    let has_edge = |index: u32| {
        let next = (index + 1) % count;
        triangles.iter().any(|triangle| triangle.contains(&index) && triangle.contains(&next))
    };
    is_named
        && hull > doubled_area(ring)
        && triangles.iter().map(area).sum::<i128>() == hull
        && edges(ring).count() == ring.len()
        && (!(0..count).all(has_edge) || triangles.len() > ring.len() - 2)
}
