//! Mistakes about colors: how values spread, what light there is, and how it becomes levels.

use super::{Mutant, mutant};
use crate::grade::rules::{Carried, Interpolation, Levels, Light};

const PAGE: &str = "docs/conventions.md";
const SHADING: &str = "docs/shading.md";
const PERMUTED: [&str; 4] = [
    "values at the wrong corners",
    "Every corner gets the value of another: weights and values are in different orders.",
    "The weight of a corner is the area of the triangle that the sample makes with the other two.",
    PAGE,
];
const FLAT: [&str; 4] = [
    "one color a polygon",
    "Values are not interpolated: the whole polygon shows one of them.",
    "Interpolate the corners' values at every sample (Gouraud).",
    SHADING,
];
const CHANNELS: [&str; 4] = [
    "channels exchanged",
    "Red, green and blue are written in another order.",
    "A pixel is red, green, blue, in that order.",
    PAGE,
];
const GAMMA: [&str; 4] = [
    "encoded for a display",
    "Levels are encoded with a gamma curve, which this sheet does not ask for (`encoding linear`).",
    "With linear encoding a level is round(255 light).",
    SHADING,
];
const CUT: [&str; 4] = [
    "levels cut off",
    "Light is turned into a level by cutting the fraction off (`int(255 * c)`).",
    "A level is round(255 light): add a half before cutting.",
    PAGE,
];

pub(super) const MUTANTS: &[Mutant] = &[
    mutant(
        [
            "affine interpolation",
            "Values are interpolated linearly on the screen, as if all corners were equally far away.",
            "Interpolate value / w and 1/w, and divide at every sample.",
            SHADING,
        ],
        |rules| rules.values = Interpolation::Affine,
    ),
    mutant(
        [
            "not divided by 1/w",
            "Value / w is interpolated, but not divided by the sample's 1/w.",
            "Interpolate value / w and 1/w, and divide the first by the second.",
            SHADING,
        ],
        |rules| rules.values = Interpolation::NotMultipliedBack,
    ),
    mutant(
        [
            "divided by 1/w twice",
            "Values are divided by 1/w twice.",
            "Interpolate value / w and 1/w, and divide the first by the second, once.",
            SHADING,
        ],
        |rules| rules.values = Interpolation::MultipliedTwice,
    ),
    mutant(FLAT, |rules| rules.values = Interpolation::FirstCorner),
    mutant(FLAT, |rules| rules.values = Interpolation::LastCorner),
    mutant(FLAT, |rules| rules.values = Interpolation::Mean),
    mutant(
        [
            "nearest corner's color",
            "Every sample shows the value of the corner with the greatest weight.",
            "Interpolate the corners' values at every sample.",
            SHADING,
        ],
        |rules| rules.values = Interpolation::NearestCorner,
    ),
    mutant(PERMUTED, |rules| rules.carried = Carried::Rotated),
    mutant(PERMUTED, |rules| rules.carried = Carried::RotatedBack),
    mutant(PERMUTED, |rules| rules.carried = Carried::LastTwoSwapped),
    mutant(PERMUTED, |rules| rules.carried = Carried::FirstTwoSwapped),
    mutant(PERMUTED, |rules| rules.carried = Carried::OuterSwapped),
    mutant(
        [
            "corners sorted without their values",
            "Corners are sorted by y, but their values stay in the old order.",
            "Sort corners together with everything that belongs to them.",
            PAGE,
        ],
        |rules| rules.carried = Carried::SortedByY,
    ),
    mutant(CHANNELS, |rules| rules.channels = [2, 1, 0]),
    mutant(CHANNELS, |rules| rules.channels = [1, 0, 2]),
    mutant(CHANNELS, |rules| rules.channels = [0, 2, 1]),
    mutant(CHANNELS, |rules| rules.channels = [1, 2, 0]),
    mutant(CHANNELS, |rules| rules.channels = [2, 0, 1]),
    mutant(CHANNELS, |rules| rules.face_channels = [2, 1, 0]),
    mutant(CHANNELS, |rules| rules.face_channels = [1, 0, 2]),
    mutant(CHANNELS, |rules| rules.face_channels = [0, 2, 1]),
    mutant(CHANNELS, |rules| rules.face_channels = [1, 2, 0]),
    mutant(CHANNELS, |rules| rules.face_channels = [2, 0, 1]),
    mutant(
        ["one channel for all", "All three channels show the same one.", "A pixel is red, green, blue.", PAGE],
        |rules| rules.channels = [0, 0, 0],
    ),
    mutant(GAMMA, |rules| rules.levels = Levels::Srgb),
    mutant(GAMMA, |rules| rules.levels = Levels::Gamma22),
    mutant(CUT, |rules| rules.levels = Levels::Down),
    mutant(
        ["levels of 256", "Levels are made by multiplying with 256.", "A level is round(255 light).", PAGE],
        |rules| rules.levels = Levels::Times256,
    ),
    mutant(
        ["light not scaled", "Light 0..1 is written as a level 0 or 1.", "A level is round(255 light).", PAGE],
        |rules| rules.levels = Levels::Unscaled,
    ),
    mutant(
        ["light squared", "Light is decoded or multiplied once too often.", "A level is round(255 light).", PAGE],
        |rules| rules.levels = Levels::Squared,
    ),
    mutant(
        [
            "lit at the corners",
            "Light is computed at the corners and interpolated: that is Gouraud, not Phong.",
            "Interpolate normal and eye point, and compute the light at every sample.",
            SHADING,
        ],
        |rules| rules.light = Light::AtCorners,
    ),
    mutant(
        [
            "lit once a polygon",
            "The light of one corner stands for the polygon.",
            "Compute the light at every sample.",
            SHADING,
        ],
        |rules| rules.light = Light::AtFirstCorner,
    ),
    mutant(
        [
            "normals not made unit again",
            "Interpolated normals are shorter than 1 between the corners, and are used as they are.",
            "Make the interpolated normal a unit vector before the light is computed.",
            SHADING,
        ],
        |rules| rules.light = Light::NormalNotUnit,
    ),
    mutant(
        [
            "direction to the lamp not unit",
            "The vector to the lamp has its length left.",
            "N.L is of unit vectors.",
            SHADING,
        ],
        |rules| rules.light = Light::LampNotUnit,
    ),
    mutant(
        [
            "lit from behind",
            "Surfaces turned away from the lamp are lit as well.",
            "Diffuse light is max(0, N.L).",
            SHADING,
        ],
        |rules| rules.light = Light::BothSides,
    ),
    mutant(
        [
            "ambient light lost",
            "There is no ambient light.",
            "Ambient light is everywhere, the lamp's is added.",
            SHADING,
        ],
        |rules| rules.light = Light::NoAmbient,
    ),
    mutant(
        ["highlight lost", "There is no highlight.", "Ks max(0, R.V)^n is added where N.L > 0.", SHADING],
        |rules| rules.light = Light::NoHighlight,
    ),
    mutant(
        [
            "highlight from the halfway vector",
            "The highlight is Blinn's (N.H)^n, which is wider.",
            "The highlight is (R.V)^n with R = 2 (N.L) N - L.",
            SHADING,
        ],
        |rules| rules.light = Light::HalfwayHighlight,
    ),
    mutant(
        [
            "highlight on the dark side",
            "A highlight is added where the lamp is behind the surface.",
            "There is a highlight only where N.L > 0.",
            SHADING,
        ],
        |rules| rules.light = Light::HighlightEverywhere,
    ),
    mutant(["exponent lost", "The highlight has no exponent.", "The highlight is (R.V)^n.", SHADING], |rules| {
        rules.light = Light::ExponentOne
    }),
];
