//! Mistakes about channels and levels.

use super::{Mutant, mutant};
use crate::grade::rules::Levels;

const PAGE: &str = "docs/conventions.md";
const SHADING: &str = "docs/shading.md";
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
];
