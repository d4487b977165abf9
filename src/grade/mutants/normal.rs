//! Mistakes about the normals of a lit face.

use super::{Mutant, mutant};
use crate::grade::light_rules::{Cosine, Length, NormalFrom, Reach};

const SHADING: &str = "docs/shading.md";
const NORMAL_ONE: [&str; 4] = [
    "one normal a polygon",
    "Normals are not interpolated: one of them, or their mean, stands for the polygon.",
    "Interpolate the corners' normals at every sample, make the result a unit vector, and use it as it points.",
    SHADING,
];
const NORMAL_NEAREST: [&str; 4] = [
    "nearest corner's normal",
    "Every sample has the normal of the corner with the greatest weight.",
    "Interpolate the corners' normals at every sample, make the result a unit vector, and use it as it points.",
    SHADING,
];
const NORMAL_FIXED: [&str; 4] = [
    "normals ignored",
    "The normal is that of the polygon's plane or a fixed one, not that of its corners.",
    "Interpolate the corners' normals at every sample, make the result a unit vector, and use it as it points.",
    SHADING,
];
const NORMAL_LENGTH: [&str; 4] = [
    "normals not made unit again",
    "Interpolated normals are shorter than 1 between the corners, and are used as they are.",
    "Make the interpolated normal a unit vector before the light is computed.",
    SHADING,
];
const NORMAL_OTHER: [&str; 4] = [
    "normals divided by another length",
    "Normals are divided by something else than their length: the sum of their numbers, the greatest, the square.",
    "A unit vector is the vector divided by sqrt(x x + y y + z z).",
    SHADING,
];
const NORMAL_ROUNDED: [&str; 4] =
    ["normals rounded", "Normals are rounded to a few steps.", "Keep normals as numbers with a fraction.", SHADING];
const NORMAL_REVERSED: [&str; 4] = [
    "normals reversed",
    "Normals point to the other side of the surface, or N.L has the other sign.",
    "Normals point as the file says: the lit side has N.L > 0.",
    SHADING,
];
const NORMAL_AXIS: [&str; 4] = [
    "an axis of the normal reversed",
    "One or two axes of the normal have the wrong sign.",
    "Normals are in eye space: x right, y up, z away from the eye.",
    SHADING,
];

pub(super) const MUTANTS: &[Mutant] = &[
    mutant(NORMAL_ONE, |rules| rules.light.normal = NormalFrom::Corner(0)),
    mutant(NORMAL_ONE, |rules| rules.light.normal = NormalFrom::Corner(1)),
    mutant(NORMAL_ONE, |rules| rules.light.normal = NormalFrom::Corner(2)),
    mutant(NORMAL_ONE, |rules| rules.light.normal = NormalFrom::Nearest),
    mutant(NORMAL_ONE, |rules| rules.light.normal = NormalFrom::Mean),
    mutant(NORMAL_NEAREST, |rules| rules.light.normal = NormalFrom::Heaviest),
    mutant(NORMAL_FIXED, |rules| rules.light.normal = NormalFrom::Plane),
    mutant(NORMAL_FIXED, |rules| rules.light.normal = NormalFrom::Fixed),
    mutant(NORMAL_LENGTH, |rules| rules.light.length = Length::AsIs),
    mutant(NORMAL_OTHER, |rules| rules.light.length = Length::Sum),
    mutant(NORMAL_OTHER, |rules| rules.light.length = Length::Greatest),
    mutant(NORMAL_OTHER, |rules| rules.light.length = Length::Squared),
    mutant(NORMAL_OTHER, |rules| rules.light.length = Length::Root),
    mutant(NORMAL_ROUNDED, |rules| rules.light.steps = 2.0),
    mutant(NORMAL_ROUNDED, |rules| rules.light.steps = 4.0),
    mutant(NORMAL_ROUNDED, |rules| rules.light.steps = 8.0),
    mutant(NORMAL_ROUNDED, |rules| rules.light.steps = 10.0),
    mutant(NORMAL_ROUNDED, |rules| rules.light.steps = 16.0),
    mutant(NORMAL_ROUNDED, |rules| rules.light.steps = 32.0),
    mutant(NORMAL_ROUNDED, |rules| rules.light.steps = 64.0),
    mutant(NORMAL_ROUNDED, |rules| rules.light.steps = 100.0),
    mutant(NORMAL_ROUNDED, |rules| rules.light.steps = 127.0),
    mutant(NORMAL_REVERSED, |rules| rules.light.signs = [-1.0; 3]),
    mutant(NORMAL_AXIS, |rules| rules.light.signs = [-1.0, 1.0, 1.0]),
    mutant(NORMAL_AXIS, |rules| rules.light.signs = [1.0, -1.0, 1.0]),
    mutant(NORMAL_AXIS, |rules| rules.light.signs = [1.0, 1.0, -1.0]),
    mutant(NORMAL_AXIS, |rules| rules.light.signs = [-1.0, -1.0, 1.0]),
    mutant(NORMAL_AXIS, |rules| rules.light.signs = [1.0, -1.0, -1.0]),
    mutant(NORMAL_AXIS, |rules| rules.light.signs = [-1.0, 1.0, -1.0]),
    mutant(NORMAL_REVERSED, |rules| (rules.light.cosine, rules.light.reach) = (Cosine::Reversed, Reach::Gate)),
];
