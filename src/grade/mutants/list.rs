//! Mistakes in the loop over the list, in comparing depths, and in the arithmetic of channels.

use super::{Mutant, mutant};
use crate::grade::listed::{Listed, Tone};
use crate::grade::rules::{Blending, DepthFrom, Front, Levels};

const PAGE: &str = "docs/conventions.md";
const GLASS: &str = "docs/transparency.md";
const FEW: [&str; 4] = [
    "some polygons lost",
    "Not every polygon of the list is drawn.",
    "The loop runs over the whole list, its first and its last polygon included.",
    PAGE,
];
const MARGIN: [&str; 4] = [
    "a margin in the comparison",
    "A polygon must be nearer by a margin to be shown, or may be farther by one.",
    "Compare with >, without a margin: depths are decided by the last digit.",
    PAGE,
];
const LIMIT: [&str; 4] = [
    "near polygons lost",
    "Polygons nearer than some depth are never shown: depth is held against a limit, or cut at one.",
    "Depth is 1/w and has no upper limit.",
    PAGE,
];
const STEPS: [&str; 4] = [
    "depth in too few steps",
    "Depth is kept in steps so coarse that different depths become equal.",
    "Keep depth as a number with a fraction: f32 at least.",
    PAGE,
];
const GRAY: [&str; 4] =
    ["gray for color", "All three channels get the same value.", "Red, green and blue are levels of their own.", PAGE];
const CHANNEL: [&str; 4] =
    ["a channel lost", "A channel is always 0.", "Red, green and blue are all written, in this order.", PAGE];
const INVERTED: [&str; 4] = ["colors inverted", "1 - c is written for c.", "0 is dark, 1 is bright.", PAGE];
const STEPPED: [&str; 4] =
    ["levels in other steps", "Levels are counted in other steps than 255.", "A level is round(255 c).", PAGE];
const BACKGROUND: [&str; 4] = [
    "another background",
    "Samples without a polygon show a color that is not the sheet's.",
    "Samples without a polygon show the sheet's background.",
    PAGE,
];
const AT_ONCE: [&str; 4] = [
    "glass blended at once",
    "A transparent polygon is mixed with what has been drawn so far, when its turn comes.",
    "What is behind glass may come later: keep transparent fragments, and blend them when all is drawn, the farthest first.",
    GLASS,
];

pub(super) const MUTANTS: &[Mutant] = &[
    mutant(FEW, |rules| rules.listed = Listed::WithoutFirst),
    mutant(FEW, |rules| rules.listed = Listed::WithoutLast),
    mutant(FEW, |rules| rules.listed = Listed::OnlyFirst),
    mutant(FEW, |rules| rules.listed = Listed::OnlyLast),
    mutant(FEW, |rules| rules.listed = Listed::EveryOther),
    mutant(MARGIN, |rules| rules.margin = 0.2),
    mutant(MARGIN, |rules| (rules.margin, rules.clear) = (0.2, 0.2)),
    mutant(MARGIN, |rules| rules.margin = 0.1),
    mutant(MARGIN, |rules| (rules.margin, rules.clear) = (0.1, 0.1)),
    mutant(MARGIN, |rules| rules.margin = 0.05),
    mutant(MARGIN, |rules| (rules.margin, rules.clear) = (0.05, 0.05)),
    mutant(MARGIN, |rules| rules.margin = 0.02),
    mutant(MARGIN, |rules| (rules.margin, rules.clear) = (0.02, 0.02)),
    mutant(MARGIN, |rules| rules.margin = 0.01),
    mutant(MARGIN, |rules| (rules.margin, rules.clear) = (0.01, 0.01)),
    mutant(MARGIN, |rules| rules.margin = 0.001),
    mutant(MARGIN, |rules| (rules.margin, rules.clear) = (0.001, 0.001)),
    mutant(MARGIN, |rules| rules.margin = -0.01),
    mutant(MARGIN, |rules| rules.margin = -0.05),
    mutant(MARGIN, |rules| rules.margin = -0.1),
    mutant(LIMIT, |rules| rules.limit = 1.0),
    mutant(LIMIT, |rules| rules.limit = 2.0),
    mutant(LIMIT, |rules| rules.limit = 10.0),
    mutant(STEPS, |rules| rules.depth = DepthFrom::Steps(10.0)),
    mutant(STEPS, |rules| rules.depth = DepthFrom::Steps(16.0)),
    mutant(STEPS, |rules| rules.depth = DepthFrom::Steps(64.0)),
    mutant(STEPS, |rules| rules.depth = DepthFrom::Steps(100.0)),
    mutant(STEPS, |rules| rules.depth = DepthFrom::Steps(255.0)),
    mutant(STEPS, |rules| rules.depth = DepthFrom::Steps(256.0)),
    mutant(STEPS, |rules| rules.depth = DepthFrom::Steps(1000.0)),
    mutant(STEPS, |rules| rules.depth = DepthFrom::RoundSteps(10.0)),
    mutant(STEPS, |rules| rules.depth = DepthFrom::RoundSteps(100.0)),
    mutant(STEPS, |rules| rules.depth = DepthFrom::RoundSteps(255.0)),
    mutant(STEPS, |rules| (rules.depth, rules.limit) = (DepthFrom::Steps(255.0), 1.0 + 1.0 / 255.0)),
    mutant(STEPS, |rules| (rules.depth, rules.limit) = (DepthFrom::RoundSteps(255.0), 1.0 + 1.0 / 255.0)),
    mutant(STEPS, |rules| (rules.depth, rules.capped) = (DepthFrom::Steps(255.0), 1.0)),
    mutant(STEPS, |rules| (rules.depth, rules.capped) = (DepthFrom::Steps(256.0), 1.0)),
    mutant(STEPS, |rules| (rules.depth, rules.capped) = (DepthFrom::RoundSteps(255.0), 1.0)),
    mutant(LIMIT, |rules| rules.capped = 1.0),
    mutant(GRAY, |rules| rules.tone = Tone::Mean),
    mutant(GRAY, |rules| rules.tone = Tone::Luma),
    mutant(GRAY, |rules| rules.channels = [0, 0, 0]),
    mutant(GRAY, |rules| rules.channels = [1, 1, 1]),
    mutant(GRAY, |rules| rules.channels = [2, 2, 2]),
    mutant(GRAY, |rules| rules.face_tone = Tone::Mean),
    mutant(GRAY, |rules| rules.face_tone = Tone::Luma),
    mutant(CHANNEL, |rules| rules.tone = Tone::Without(0)),
    mutant(CHANNEL, |rules| rules.tone = Tone::Without(1)),
    mutant(CHANNEL, |rules| rules.tone = Tone::Without(2)),
    mutant(CHANNEL, |rules| rules.tone = Tone::Only(0)),
    mutant(CHANNEL, |rules| rules.tone = Tone::Only(1)),
    mutant(CHANNEL, |rules| rules.tone = Tone::Only(2)),
    mutant(
        [
            "a channel written twice",
            "One channel is written in the place of another.",
            "The order is red, green, blue.",
            PAGE,
        ],
        |rules| rules.channels = [0, 1, 1],
    ),
    mutant(
        [
            "a channel written twice",
            "One channel is written in the place of another.",
            "The order is red, green, blue.",
            PAGE,
        ],
        |rules| rules.channels = [0, 0, 2],
    ),
    mutant(
        [
            "a channel written twice",
            "One channel is written in the place of another.",
            "The order is red, green, blue.",
            PAGE,
        ],
        |rules| rules.channels = [0, 2, 2],
    ),
    mutant(INVERTED, |rules| rules.tone = Tone::Inverted),
    mutant(INVERTED, |rules| rules.face_tone = Tone::Inverted),
    mutant(
        ["levels rounded up", "Levels are rounded up.", "A level is round(255 c): the nearest one.", PAGE],
        |rules| rules.levels = Levels::Up,
    ),
    mutant(
        [
            "levels wrap around",
            "A level above 255 starts again at 0.",
            "A level is round(255 c): never above 255.",
            PAGE,
        ],
        |rules| rules.levels = Levels::Wraps,
    ),
    mutant(STEPPED, |rules| rules.levels = Levels::Of(100.0)),
    mutant(STEPPED, |rules| rules.levels = Levels::Of(127.0)),
    mutant(STEPPED, |rules| rules.levels = Levels::Of(15.0)),
    mutant(STEPPED, |rules| rules.levels = Levels::Scaled(254.0)),
    mutant(STEPPED, |rules| rules.levels = Levels::Scaled(250.0)),
    mutant(STEPPED, |rules| rules.levels = Levels::Scaled(256.0)),
    mutant(STEPPED, |rules| rules.levels = Levels::Scaled(128.0)),
    mutant(STEPPED, |rules| rules.levels = Levels::Scaled(100.0)),
    mutant(BACKGROUND, |rules| rules.background = Some(0.5)),
    mutant(BACKGROUND, |rules| rules.background = Some(128.0 / 255.0)),
    mutant(BACKGROUND, |rules| rules.background = Some(127.0 / 255.0)),
    mutant(BACKGROUND, |rules| rules.background = Some(0.25)),
    mutant(BACKGROUND, |rules| rules.background = Some(0.75)),
    mutant(BACKGROUND, |rules| rules.background = Some(0.2)),
    mutant(BACKGROUND, |rules| rules.background = Some(0.1)),
    mutant(AT_ONCE, |rules| rules.blending = Blending::AtOnce),
    mutant(AT_ONCE, |rules| rules.blending = Blending::AtOnceKept),
    mutant(
        [
            "glass shown before what hides it",
            "Transparent polygons are blended over what is in front of them, too.",
            "Only what is nearer than the opaque depth is blended.",
            GLASS,
        ],
        |rules| rules.blending = Blending::Everywhere,
    ),
    mutant(
        [
            "last wins",
            "The polygon that comes last is shown, whatever its depth: nothing is compared, or what was compared is not kept.",
            "Compare with the depth kept at the sample, and keep the depth of what is shown.",
            PAGE,
        ],
        |rules| (rules.front, rules.blending) = (Front::Last, Blending::Everywhere),
    ),
];
