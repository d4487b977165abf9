//! Mistakes about how values get from corners to samples.

use super::{Mutant, mutant};
use crate::grade::rules::{Divisor, Interpolation};

const PAGE: &str = "docs/conventions.md";
const SHADING: &str = "docs/shading.md";
const AFFINE: [&str; 4] = [
    "affine interpolation",
    "Values are interpolated linearly on the screen, as if all corners were equally far away.",
    "Interpolate value / w and 1/w, and divide at every sample.",
    SHADING,
];
const NOT_DIVIDED: [&str; 4] = [
    "not divided by 1/w",
    "Value / w is interpolated, but not divided by the sample's 1/w.",
    "Interpolate value / w and 1/w, and divide the first by the second, once.",
    SHADING,
];
const TWICE: [&str; 4] = [
    "divided by 1/w twice",
    "Values are divided by 1/w twice.",
    "Interpolate value / w and 1/w, and divide the first by the second, once.",
    SHADING,
];
const TIMES: [&str; 4] = [
    "multiplied by 1/w",
    "Values are multiplied by the sample's 1/w where they should be divided by it.",
    "Interpolate value / w and 1/w, and divide the first by the second, once.",
    SHADING,
];
const UNEQUAL: [&str; 4] = [
    "divided by 1/w without need",
    "The value itself is interpolated, not value / w, and is divided by 1/w all the same.",
    "Interpolate value / w and 1/w, and divide the first by the second, once.",
    SHADING,
];
const OTHER_W: [&str; 4] = [
    "divided by another 1/w",
    "Value / w is divided by the 1/w of a corner (or by their mean, or by a w drawn out straight), not by that of the sample.",
    "Divide by 1/w as it is interpolated at the sample.",
    SHADING,
];
const BY_W: [&str; 4] = [
    "w for 1/w",
    "Values are interpolated with w where 1/w belongs.",
    "Weights on the screen go with value / w and 1/w: the nearer corner counts more.",
    SHADING,
];
const LIMITS: [&str; 4] = [
    "limits put on value / w",
    "Value / w is held inside the limits of the value, which are meant for the quotient.",
    "Divide value / w by 1/w first, and put the limits on what comes out.",
    "docs/screen-files.md",
];
const LOST: [&str; 4] = [
    "a corner without weight",
    "One of the three corners adds nothing to the values.",
    "The three weights add up to 1: the third is 1 - first - second.",
    PAGE,
];
const AREA: [&str; 4] = [
    "weights of another area",
    "Weights do not add up to 1: they are divided by twice the area or by half of it.",
    "Both areas of a weight are measured alike: each as a cross product, or each as half of one.",
    PAGE,
];
const HALF_PLANE: [&str; 4] = [
    "a plane without x or y",
    "The plane of value / w is evaluated without its x or its y.",
    "A plane is a x + b y + c, at the center of the sample.",
    PAGE,
];
const DISTANCES: [&str; 4] = [
    "weights from distances",
    "Corners are weighed by their distances, not by areas.",
    "The weight of a corner is the area of the triangle that the sample makes with the other two.",
    PAGE,
];
const FLAT: [&str; 4] = [
    "one color a polygon",
    "Values are not interpolated: the whole polygon shows one of them.",
    "Interpolate the corners' values at every sample (Gouraud).",
    SHADING,
];
const NEAREST: [&str; 4] = [
    "nearest corner's color",
    "Every sample shows the value of the nearest corner, or of that with the greatest weight.",
    "Interpolate the corners' values at every sample.",
    SHADING,
];
const BESIDE: [&str; 4] = [
    "values beside the center",
    "Values are taken beside the center of the sample, though coverage is asked for there.",
    "Take depth, color and normal at (x + 0.5, y + 0.5), where coverage is asked for.",
    PAGE,
];
const CORNER: [&str; 4] = [
    "values at the corner",
    "Depth and values are taken at (x, y), though coverage is asked for at the center.",
    "Take depth, color and normal at (x + 0.5, y + 0.5), where coverage is asked for.",
    PAGE,
];

pub(super) const MUTANTS: &[Mutant] = &[
    mutant(AFFINE, |rules| rules.values = Interpolation::Affine),
    mutant(NOT_DIVIDED, |rules| rules.values = Interpolation::NotMultipliedBack),
    mutant(NOT_DIVIDED, |rules| (rules.values, rules.spares_constants) = (Interpolation::NotMultipliedBack, true)),
    mutant(NOT_DIVIDED, |rules| (rules.values, rules.clamps) = (Interpolation::NotMultipliedBack, true)),
    mutant(NOT_DIVIDED, |rules| {
        (rules.values, rules.clamps, rules.spares_constants) = (Interpolation::NotMultipliedBack, true, true)
    }),
    mutant(TWICE, |rules| rules.values = Interpolation::MultipliedTwice),
    mutant(TWICE, |rules| (rules.values, rules.spares_constants) = (Interpolation::MultipliedTwice, true)),
    mutant(TWICE, |rules| (rules.values, rules.clamps) = (Interpolation::MultipliedTwice, true)),
    mutant(TWICE, |rules| {
        (rules.values, rules.clamps, rules.spares_constants) = (Interpolation::MultipliedTwice, true, true)
    }),
    mutant(TIMES, |rules| rules.values = Interpolation::TimesDepth),
    mutant(TIMES, |rules| (rules.values, rules.spares_constants) = (Interpolation::TimesDepth, true)),
    mutant(TIMES, |rules| (rules.values, rules.clamps) = (Interpolation::TimesDepth, true)),
    mutant(TIMES, |rules| {
        (rules.values, rules.clamps, rules.spares_constants) = (Interpolation::TimesDepth, true, true)
    }),
    mutant(TIMES, |rules| rules.values = Interpolation::AffineTimes),
    mutant(TIMES, |rules| (rules.values, rules.spares_constants) = (Interpolation::AffineTimes, true)),
    mutant(TIMES, |rules| (rules.values, rules.clamps) = (Interpolation::AffineTimes, true)),
    mutant(TIMES, |rules| {
        (rules.values, rules.clamps, rules.spares_constants) = (Interpolation::AffineTimes, true, true)
    }),
    mutant(UNEQUAL, |rules| rules.values = Interpolation::AffineDivided),
    mutant(UNEQUAL, |rules| (rules.values, rules.spares_constants) = (Interpolation::AffineDivided, true)),
    mutant(UNEQUAL, |rules| (rules.values, rules.clamps) = (Interpolation::AffineDivided, true)),
    mutant(UNEQUAL, |rules| {
        (rules.values, rules.clamps, rules.spares_constants) = (Interpolation::AffineDivided, true, true)
    }),
    mutant(OTHER_W, |rules| rules.values = Interpolation::DividedBy(Divisor::Nearest)),
    mutant(OTHER_W, |rules| {
        (rules.values, rules.spares_constants) = (Interpolation::DividedBy(Divisor::Nearest), true)
    }),
    mutant(OTHER_W, |rules| (rules.values, rules.clamps) = (Interpolation::DividedBy(Divisor::Nearest), true)),
    mutant(OTHER_W, |rules| {
        (rules.values, rules.clamps, rules.spares_constants) = (Interpolation::DividedBy(Divisor::Nearest), true, true)
    }),
    mutant(OTHER_W, |rules| rules.values = Interpolation::DividedBy(Divisor::Farthest)),
    mutant(OTHER_W, |rules| {
        (rules.values, rules.spares_constants) = (Interpolation::DividedBy(Divisor::Farthest), true)
    }),
    mutant(OTHER_W, |rules| (rules.values, rules.clamps) = (Interpolation::DividedBy(Divisor::Farthest), true)),
    mutant(OTHER_W, |rules| {
        (rules.values, rules.clamps, rules.spares_constants) = (Interpolation::DividedBy(Divisor::Farthest), true, true)
    }),
    mutant(OTHER_W, |rules| rules.values = Interpolation::DividedBy(Divisor::Mean)),
    mutant(OTHER_W, |rules| (rules.values, rules.spares_constants) = (Interpolation::DividedBy(Divisor::Mean), true)),
    mutant(OTHER_W, |rules| (rules.values, rules.clamps) = (Interpolation::DividedBy(Divisor::Mean), true)),
    mutant(OTHER_W, |rules| {
        (rules.values, rules.clamps, rules.spares_constants) = (Interpolation::DividedBy(Divisor::Mean), true, true)
    }),
    mutant(OTHER_W, |rules| rules.values = Interpolation::DividedBy(Divisor::LinearW)),
    mutant(OTHER_W, |rules| {
        (rules.values, rules.spares_constants) = (Interpolation::DividedBy(Divisor::LinearW), true)
    }),
    mutant(OTHER_W, |rules| (rules.values, rules.clamps) = (Interpolation::DividedBy(Divisor::LinearW), true)),
    mutant(OTHER_W, |rules| {
        (rules.values, rules.clamps, rules.spares_constants) = (Interpolation::DividedBy(Divisor::LinearW), true, true)
    }),
    mutant(OTHER_W, |rules| rules.values = Interpolation::DividedBy(Divisor::Corner(0))),
    mutant(OTHER_W, |rules| {
        (rules.values, rules.spares_constants) = (Interpolation::DividedBy(Divisor::Corner(0)), true)
    }),
    mutant(OTHER_W, |rules| (rules.values, rules.clamps) = (Interpolation::DividedBy(Divisor::Corner(0)), true)),
    mutant(OTHER_W, |rules| {
        (rules.values, rules.clamps, rules.spares_constants) =
            (Interpolation::DividedBy(Divisor::Corner(0)), true, true)
    }),
    mutant(OTHER_W, |rules| rules.values = Interpolation::DividedBy(Divisor::Corner(1))),
    mutant(OTHER_W, |rules| {
        (rules.values, rules.spares_constants) = (Interpolation::DividedBy(Divisor::Corner(1)), true)
    }),
    mutant(OTHER_W, |rules| (rules.values, rules.clamps) = (Interpolation::DividedBy(Divisor::Corner(1)), true)),
    mutant(OTHER_W, |rules| {
        (rules.values, rules.clamps, rules.spares_constants) =
            (Interpolation::DividedBy(Divisor::Corner(1)), true, true)
    }),
    mutant(OTHER_W, |rules| rules.values = Interpolation::DividedBy(Divisor::Corner(2))),
    mutant(OTHER_W, |rules| {
        (rules.values, rules.spares_constants) = (Interpolation::DividedBy(Divisor::Corner(2)), true)
    }),
    mutant(OTHER_W, |rules| (rules.values, rules.clamps) = (Interpolation::DividedBy(Divisor::Corner(2)), true)),
    mutant(OTHER_W, |rules| {
        (rules.values, rules.clamps, rules.spares_constants) =
            (Interpolation::DividedBy(Divisor::Corner(2)), true, true)
    }),
    mutant(BY_W, |rules| rules.values = Interpolation::ByW),
    mutant(LIMITS, |rules| rules.values = Interpolation::LimitsOnOverW),
    mutant(LIMITS, |rules| (rules.values, rules.spares_constants) = (Interpolation::LimitsOnOverW, true)),
    mutant(LOST, |rules| rules.values = Interpolation::Without(0)),
    mutant(LOST, |rules| (rules.values, rules.spares_constants) = (Interpolation::Without(0), true)),
    mutant(LOST, |rules| rules.values = Interpolation::Without(1)),
    mutant(LOST, |rules| (rules.values, rules.spares_constants) = (Interpolation::Without(1), true)),
    mutant(LOST, |rules| rules.values = Interpolation::Without(2)),
    mutant(LOST, |rules| (rules.values, rules.spares_constants) = (Interpolation::Without(2), true)),
    mutant(AREA, |rules| rules.values = Interpolation::Times(2.0)),
    mutant(AREA, |rules| (rules.values, rules.spares_constants) = (Interpolation::Times(2.0), true)),
    mutant(AREA, |rules| (rules.values, rules.clamps) = (Interpolation::Times(2.0), true)),
    mutant(AREA, |rules| {
        (rules.values, rules.clamps, rules.spares_constants) = (Interpolation::Times(2.0), true, true)
    }),
    mutant(AREA, |rules| rules.values = Interpolation::Times(0.5)),
    mutant(AREA, |rules| (rules.values, rules.spares_constants) = (Interpolation::Times(0.5), true)),
    mutant(AREA, |rules| (rules.values, rules.clamps) = (Interpolation::Times(0.5), true)),
    mutant(AREA, |rules| {
        (rules.values, rules.clamps, rules.spares_constants) = (Interpolation::Times(0.5), true, true)
    }),
    mutant(HALF_PLANE, |rules| rules.values = Interpolation::WithoutX),
    mutant(HALF_PLANE, |rules| (rules.values, rules.spares_constants) = (Interpolation::WithoutX, true)),
    mutant(HALF_PLANE, |rules| (rules.values, rules.clamps) = (Interpolation::WithoutX, true)),
    mutant(HALF_PLANE, |rules| {
        (rules.values, rules.clamps, rules.spares_constants) = (Interpolation::WithoutX, true, true)
    }),
    mutant(HALF_PLANE, |rules| rules.values = Interpolation::WithoutY),
    mutant(HALF_PLANE, |rules| (rules.values, rules.spares_constants) = (Interpolation::WithoutY, true)),
    mutant(HALF_PLANE, |rules| (rules.values, rules.clamps) = (Interpolation::WithoutY, true)),
    mutant(HALF_PLANE, |rules| {
        (rules.values, rules.clamps, rules.spares_constants) = (Interpolation::WithoutY, true, true)
    }),
    mutant(DISTANCES, |rules| rules.values = Interpolation::Distances),
    mutant(FLAT, |rules| rules.values = Interpolation::Corner(0)),
    mutant(FLAT, |rules| rules.values = Interpolation::Corner(1)),
    mutant(FLAT, |rules| rules.values = Interpolation::Corner(2)),
    mutant(FLAT, |rules| rules.values = Interpolation::Mean),
    mutant(FLAT, |rules| rules.values = Interpolation::Least),
    mutant(FLAT, |rules| rules.values = Interpolation::Greatest),
    mutant(FLAT, |rules| rules.values = Interpolation::Middle),
    mutant(FLAT, |rules| rules.values = Interpolation::NearestToEye),
    mutant(NEAREST, |rules| rules.values = Interpolation::Heaviest),
    mutant(NEAREST, |rules| rules.values = Interpolation::Closest),
    mutant(CORNER, |rules| (rules.value_at, rules.clamps) = ((0.0, 0.0), true)),
    mutant(BESIDE, |rules| rules.value_at = (1.0, 1.0)),
    mutant(BESIDE, |rules| (rules.value_at, rules.clamps) = ((1.0, 1.0), true)),
    mutant(BESIDE, |rules| rules.value_at = (0.5, 0.0)),
    mutant(BESIDE, |rules| (rules.value_at, rules.clamps) = ((0.5, 0.0), true)),
    mutant(BESIDE, |rules| rules.value_at = (0.0, 0.5)),
    mutant(BESIDE, |rules| (rules.value_at, rules.clamps) = ((0.0, 0.5), true)),
    mutant(BESIDE, |rules| rules.value_at = (1.0, 0.5)),
    mutant(BESIDE, |rules| (rules.value_at, rules.clamps) = ((1.0, 0.5), true)),
    mutant(BESIDE, |rules| rules.value_at = (0.5, 1.0)),
    mutant(BESIDE, |rules| (rules.value_at, rules.clamps) = ((0.5, 1.0), true)),
    mutant(BESIDE, |rules| rules.value_at = (1.5, 0.5)),
    mutant(BESIDE, |rules| (rules.value_at, rules.clamps) = ((1.5, 0.5), true)),
    mutant(BESIDE, |rules| rules.value_at = (0.5, 1.5)),
    mutant(BESIDE, |rules| (rules.value_at, rules.clamps) = ((0.5, 1.5), true)),
    mutant(BESIDE, |rules| rules.value_at = (-0.5, 0.5)),
    mutant(BESIDE, |rules| (rules.value_at, rules.clamps) = ((-0.5, 0.5), true)),
    mutant(BESIDE, |rules| rules.value_at = (0.5, -0.5)),
    mutant(BESIDE, |rules| (rules.value_at, rules.clamps) = ((0.5, -0.5), true)),
];
