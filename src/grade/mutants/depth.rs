//! Mistakes about which polygon is in front.

use super::{Mutant, mutant};
use crate::grade::rules::{Blending, DepthFrom, Front};

const PAGE: &str = "docs/conventions.md";
const CLEAR: [&str; 4] = [
    "depth cleared to a distance",
    "The depth memory starts with a depth at which there are polygons: farther ones are never shown.",
    "Depth is 1/w: infinitely far is 0, and that is what the memory starts with.",
    PAGE,
];
const CORNER_DEPTH: [&str; 4] = [
    "one depth a polygon",
    "A whole polygon is compared by one depth, so polygons cannot pierce or overlap in a ring.",
    "Compare at every sample the depth that the plane of 1/w has there.",
    PAGE,
];

pub(super) const MUTANTS: &[Mutant] = &[
    mutant(
        [
            "far wins",
            "The farther polygon hides the nearer: depth is compared the wrong way.",
            "Depth is 1/w, larger is nearer: a fragment is shown when its depth is greater than what is there.",
            PAGE,
        ],
        |rules| rules.front = Front::Farthest,
    ),
    mutant(
        [
            "last wins",
            "The polygon that comes last is shown, whatever its depth: nothing is compared, or what was compared is not kept.",
            "Compare with the depth kept at the sample, and keep the depth of what is shown.",
            PAGE,
        ],
        |rules| rules.front = Front::Last,
    ),
    mutant(
        [
            "first wins",
            "The polygon that comes first keeps its samples, whatever comes after.",
            "A nearer fragment replaces what is there, however early that came.",
            PAGE,
        ],
        |rules| rules.front = Front::First,
    ),
    mutant(
        [
            "the later of equals",
            "Of equal depths the polygon that comes later is shown (>= instead of >).",
            "Of equal depths the polygon that comes first in the list keeps the sample: compare with >.",
            PAGE,
        ],
        |rules| rules.later_wins_ties = true,
    ),
    mutant(CLEAR, |rules| rules.clear = 1.0),
    mutant(CLEAR, |rules| rules.clear = 0.01),
    mutant(CLEAR, |rules| rules.clear = 0.1),
    mutant(CORNER_DEPTH, |rules| rules.depth = DepthFrom::Corner(0)),
    mutant(CORNER_DEPTH, |rules| rules.depth = DepthFrom::NearestCorner),
    mutant(CORNER_DEPTH, |rules| rules.depth = DepthFrom::MeanCorner),
    mutant(
        [
            "w drawn out straight",
            "w itself is interpolated linearly on the screen, and it is not linear there.",
            "1/w is linear on the screen: interpolate that.",
            PAGE,
        ],
        |rules| rules.depth = DepthFrom::LinearW,
    ),
    mutant(
        [
            "whole depths",
            "Depths are kept as whole numbers.",
            "Keep depth as a number with a fraction: f32 at least.",
            PAGE,
        ],
        |rules| rules.depth = DepthFrom::Whole,
    ),
    mutant(
        [
            "transparency ignored",
            "Transparent polygons are drawn as if they hid what is behind.",
            "Opacity < 1 lets light through: color = own * opacity + behind * (1 - opacity), the nearest last.",
            "docs/transparency.md",
        ],
        |rules| rules.blending = Blending::Ignored,
    ),
    mutant(
        [
            "transparent polygons lost",
            "Transparent polygons are not drawn at all.",
            "Opacity < 1 lets light through: color = own * opacity + behind * (1 - opacity), the nearest last.",
            "docs/transparency.md",
        ],
        |rules| rules.blending = Blending::Invisible,
    ),
    mutant(
        [
            "opacity taken for transparency",
            "Opacity and transparency are exchanged.",
            "Opacity 1 hides what is behind: color = own * opacity + behind * (1 - opacity).",
            "docs/transparency.md",
        ],
        |rules| rules.blending = Blending::Swapped,
    ),
    mutant(
        [
            "blended in list order",
            "Transparent polygons are blended in the order of the list, not by depth.",
            "Blend what is in front of the opaque depth from the farthest to the nearest.",
            "docs/transparency.md",
        ],
        |rules| rules.blending = Blending::ListOrder,
    ),
];
