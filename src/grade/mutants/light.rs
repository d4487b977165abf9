//! Mistakes about light, but for the highlight: normals, lamps, coefficients, sums.

use super::{Mutant, mutant};
use crate::grade::light_rules::{Cosine, EyeFrom, Factor, Fading, Gate, Lamps, Length, LitAt, Reach, Sum, ToLamp};

const SHADING: &str = "docs/shading.md";
const AT_CORNERS: [&str; 4] = [
    "lit at the corners",
    "Light is computed at the corners and interpolated: that is Gouraud, not Phong.",
    "Interpolate normal and eye point, and compute the light at every sample.",
    SHADING,
];
const ONCE: [&str; 4] = [
    "lit once a polygon",
    "The light of one point stands for the polygon.",
    "Compute the light at every sample.",
    SHADING,
];
const LAMP_LENGTH: [&str; 4] = [
    "direction to the lamp not unit",
    "The vector to the lamp is not divided by its length.",
    "N.L is of unit vectors.",
    SHADING,
];
const LAMP_REVERSED: [&str; 4] = [
    "direction to the lamp reversed",
    "L leads from the lamp to the point.",
    "L leads from the point to the lamp: lamp - point.",
    SHADING,
];
const LAMP_DIRECTION: [&str; 4] = [
    "lamp taken for a direction",
    "The lamp's place is taken for the direction to it, as if seen from the eye.",
    "L leads from the point to the lamp: lamp - point.",
    SHADING,
];
const LAMP_PLUS: [&str; 4] = [
    "lamp and point added",
    "The vector to the lamp is lamp + point.",
    "L leads from the point to the lamp: lamp - point.",
    SHADING,
];
const LAMP_EYE: [&str; 4] = [
    "lamp at the eye",
    "The vector to the eye is used where that to the lamp belongs.",
    "L leads from the point to the lamp: lamp - point.",
    SHADING,
];
const LAMP_AXIS: [&str; 4] = [
    "an axis of the lamp reversed",
    "One axis of the lamp's place has the wrong sign.",
    "Places are in eye space: x right, y up, z away from the eye.",
    SHADING,
];
const BEHIND: [&str; 4] = [
    "lit from behind",
    "Surfaces turned away from the lamp are lit as well.",
    "Diffuse light is max(0, N.L).",
    SHADING,
];
const HALF: [&str; 4] = [
    "light wrapped round",
    "Diffuse light is of N.L / 2 + 1/2, so it reaches round to the dark side.",
    "Diffuse light is max(0, N.L).",
    SHADING,
];
const COSINE: [&str; 4] = [
    "another function of N.L",
    "Diffuse light is of a power, a root, the sine or the angle, not of N.L itself.",
    "Diffuse light is max(0, N.L).",
    SHADING,
];
const UNCUT: [&str; 4] = [
    "negative light",
    "N.L is not cut at 0: the dark side gets darker than ambient light.",
    "Diffuse light is max(0, N.L).",
    SHADING,
];
const AMBIENT_LOST: [&str; 4] =
    ["ambient light lost", "There is no ambient light.", "Ambient light is everywhere, the lamps' is added.", SHADING];
const AMBIENT: [&str; 4] = [
    "ambient coefficient wrong",
    "Ambient light is counted twice or by half, or has the coefficient of another term or none.",
    "Ambient light is Ka Ia C, once.",
    SHADING,
];
const AMBIENT_EACH: [&str; 4] = [
    "ambient light once a lamp",
    "Ambient light is added with every lamp.",
    "Ambient light is added once, before the lamps.",
    SHADING,
];
const AMBIENT_DARK: [&str; 4] = [
    "ambient light not added",
    "Ambient light is not added to the lamps': one replaces, multiplies or outshines the other.",
    "Ambient light is everywhere, the lamps' is added.",
    SHADING,
];
const DIFFUSE_LOST: [&str; 4] =
    ["diffuse light lost", "There is no diffuse light.", "Kd C max(0, N.L) is added for every lamp.", SHADING];
const DIFFUSE: [&str; 4] = [
    "diffuse coefficient wrong",
    "Diffuse light is counted twice or by half, or has the coefficient of another term or none.",
    "Diffuse light is Kd C max(0, N.L).",
    SHADING,
];
const GRAY: [&str; 4] = [
    "color of the surface lost",
    "Light is of the surface's brightness, not of its color.",
    "Each channel has its own Ka Ia C and Kd C.",
    SHADING,
];
const FADES: [&str; 4] = [
    "light fades with distance",
    "Light is divided by the distance of the lamp, or by its square.",
    "Lamps do not fade with distance.",
    SHADING,
];
const FEW_LAMPS: [&str; 4] = [
    "one lamp only",
    "Only the first or the last lamp counts, or the brightest, or all stand in one place.",
    "The lamps' light is added, each from its own place.",
    SHADING,
];
const MEAN_LAMPS: [&str; 4] =
    ["mean of the lamps", "Light is divided by the number of lamps.", "The lamps' light is added.", SHADING];
const WHITE_LAMPS: [&str; 4] = [
    "color of lamps lost",
    "Lamps, or their highlights, are taken for white.",
    "A lamp's light is multiplied by its color, channel by channel.",
    SHADING,
];
const SCALED: [&str; 4] = [
    "light scaled",
    "The whole light is multiplied by a number, or divided by the sum of the coefficients.",
    "Light is the sum of its terms: coefficients and colors are all there is to multiply by.",
    SHADING,
];
const SQUARED: [&str; 4] = [
    "light multiplied by itself",
    "The whole light is squared, or taken from 1.",
    "Light is the sum of its terms.",
    SHADING,
];
const WRAPS: [&str; 4] =
    ["light above 1 wraps", "Levels above 255 begin anew at 0.", "Cut light at 1 before it becomes a level.", SHADING];
const DARK_BLACK: [&str; 4] = [
    "dark side without ambient light",
    "Where no lamp shines nothing is drawn, not even ambient light.",
    "Ambient light is everywhere, the lamps' is added.",
    SHADING,
];
const EYE: [&str; 4] = [
    "one eye point a polygon",
    "The point of one corner, or of the middle, stands for all samples.",
    "Interpolate the eye point as the normal is, and use that of the sample.",
    SHADING,
];
const EYE_SCREEN: [&str; 4] = [
    "eye points without w",
    "The eye point is not interpolated in space: linearly on the screen, or over w and not divided, or divided twice.",
    "Interpolate eye point / w and 1/w, and divide at every sample.",
    SHADING,
];

pub(super) const MUTANTS: &[Mutant] = &[
    mutant(AT_CORNERS, |rules| rules.light.at = LitAt::Corners),
    mutant(AT_CORNERS, |rules| rules.light.at = LitAt::CornersOnScreen),
    mutant(ONCE, |rules| rules.light.at = LitAt::Corner(0)),
    mutant(ONCE, |rules| rules.light.at = LitAt::Corner(1)),
    mutant(ONCE, |rules| rules.light.at = LitAt::Corner(2)),
    mutant(ONCE, |rules| rules.light.at = LitAt::Nearest),
    mutant(ONCE, |rules| rules.light.at = LitAt::Mean),
    mutant(ONCE, |rules| rules.light.at = LitAt::Middle),
    mutant(LAMP_LENGTH, |rules| rules.light.lamp_length = Length::AsIs),
    mutant(LAMP_LENGTH, |rules| rules.light.lamp_length = Length::Sum),
    mutant(LAMP_LENGTH, |rules| rules.light.lamp_length = Length::Greatest),
    mutant(LAMP_LENGTH, |rules| rules.light.lamp_length = Length::Squared),
    mutant(LAMP_LENGTH, |rules| rules.light.lamp_length = Length::Root),
    mutant(LAMP_REVERSED, |rules| rules.light.lamp = ToLamp::Reversed),
    mutant(LAMP_DIRECTION, |rules| rules.light.lamp = ToLamp::Position),
    mutant(LAMP_DIRECTION, |rules| (rules.light.lamp, rules.light.lamp_length) = (ToLamp::Position, Length::AsIs)),
    mutant(LAMP_PLUS, |rules| rules.light.lamp = ToLamp::Plus),
    mutant(LAMP_EYE, |rules| rules.light.lamp = ToLamp::AtEye),
    mutant(LAMP_AXIS, |rules| rules.light.lamp = ToLamp::Flipped(0)),
    mutant(LAMP_AXIS, |rules| rules.light.lamp = ToLamp::Flipped(1)),
    mutant(LAMP_AXIS, |rules| rules.light.lamp = ToLamp::Flipped(2)),
    mutant(BEHIND, |rules| (rules.light.cosine, rules.light.reach) = (Cosine::Absolute, Reach::Diffuse)),
    mutant(BEHIND, |rules| (rules.light.cosine, rules.light.reach) = (Cosine::Absolute, Reach::Gate)),
    mutant(BEHIND, |rules| (rules.light.cosine, rules.light.reach) = (Cosine::Absolute, Reach::All)),
    mutant(BEHIND, |rules| (rules.light.cosine, rules.light.gate) = (Cosine::Reversed, Gate::Everywhere)),
    mutant(BEHIND, |rules| (rules.light.cosine, rules.light.reach) = (Cosine::Reversed, Reach::Diffuse)),
    mutant(HALF, |rules| (rules.light.cosine, rules.light.reach) = (Cosine::Half, Reach::Diffuse)),
    mutant(HALF, |rules| (rules.light.cosine, rules.light.reach) = (Cosine::Half, Reach::Gate)),
    mutant(HALF, |rules| (rules.light.cosine, rules.light.reach) = (Cosine::Half, Reach::All)),
    mutant(HALF, |rules| (rules.light.cosine, rules.light.reach) = (Cosine::HalfSquared, Reach::Diffuse)),
    mutant(HALF, |rules| (rules.light.cosine, rules.light.reach) = (Cosine::HalfSquared, Reach::Gate)),
    mutant(HALF, |rules| (rules.light.cosine, rules.light.reach) = (Cosine::HalfSquared, Reach::All)),
    mutant(COSINE, |rules| (rules.light.cosine, rules.light.reach) = (Cosine::Squared, Reach::Diffuse)),
    mutant(COSINE, |rules| (rules.light.cosine, rules.light.reach) = (Cosine::Squared, Reach::All)),
    mutant(COSINE, |rules| (rules.light.cosine, rules.light.reach) = (Cosine::Root, Reach::Diffuse)),
    mutant(COSINE, |rules| (rules.light.cosine, rules.light.reach) = (Cosine::Root, Reach::All)),
    mutant(COSINE, |rules| (rules.light.cosine, rules.light.reach) = (Cosine::One, Reach::Diffuse)),
    mutant(COSINE, |rules| (rules.light.cosine, rules.light.reach) = (Cosine::One, Reach::All)),
    mutant(COSINE, |rules| (rules.light.cosine, rules.light.reach) = (Cosine::Angle, Reach::Diffuse)),
    mutant(COSINE, |rules| (rules.light.cosine, rules.light.reach) = (Cosine::Angle, Reach::All)),
    mutant(COSINE, |rules| (rules.light.cosine, rules.light.reach) = (Cosine::Sine, Reach::Diffuse)),
    mutant(COSINE, |rules| (rules.light.cosine, rules.light.reach) = (Cosine::Sine, Reach::All)),
    mutant(UNCUT, |rules| rules.light.cosine = Cosine::Uncut),
    mutant(UNCUT, |rules| (rules.light.cosine, rules.light.gate) = (Cosine::Uncut, Gate::Everywhere)),
    mutant(AMBIENT_LOST, |rules| rules.light.factors[0] = Factor::Times(0.0)),
    mutant(AMBIENT, |rules| rules.light.factors[0] = Factor::Times(2.0)),
    mutant(AMBIENT, |rules| rules.light.factors[0] = Factor::Times(0.5)),
    mutant(AMBIENT, |rules| rules.light.factors[0] = Factor::Times(3.0)),
    mutant(AMBIENT, |rules| rules.light.factors[0] = Factor::One),
    mutant(AMBIENT, |rules| rules.light.factors[0] = Factor::Diffuse),
    mutant(AMBIENT, |rules| rules.light.factors[0] = Factor::Specular),
    mutant(AMBIENT, |rules| rules.light.factors[0] = Factor::Squared),
    mutant(AMBIENT, |rules| rules.light.factors[0] = Factor::Rest),
    mutant(AMBIENT_EACH, |rules| rules.light.lamps = Lamps::AmbientEach),
    mutant(AMBIENT_DARK, |rules| rules.light.sum = Sum::AmbientTimes),
    mutant(AMBIENT_DARK, |rules| rules.light.sum = Sum::Greatest),
    mutant(AMBIENT_DARK, |rules| rules.light.sum = Sum::AmbientInTheDark),
    mutant(DIFFUSE_LOST, |rules| rules.light.factors[1] = Factor::Times(0.0)),
    mutant(DIFFUSE, |rules| rules.light.factors[1] = Factor::Times(2.0)),
    mutant(DIFFUSE, |rules| rules.light.factors[1] = Factor::Times(0.5)),
    mutant(DIFFUSE, |rules| rules.light.factors[1] = Factor::Times(3.0)),
    mutant(DIFFUSE, |rules| rules.light.factors[1] = Factor::One),
    mutant(DIFFUSE, |rules| rules.light.factors[1] = Factor::Ambient),
    mutant(DIFFUSE, |rules| rules.light.factors[1] = Factor::Specular),
    mutant(DIFFUSE, |rules| rules.light.factors[1] = Factor::Squared),
    mutant(DIFFUSE, |rules| rules.light.factors[1] = Factor::Rest),
    mutant(GRAY, |rules| (rules.light.factors[0], rules.light.factors[1]) = (Factor::Gray, Factor::Gray)),
    mutant(GRAY, |rules| rules.light.factors[0] = Factor::Gray),
    mutant(GRAY, |rules| rules.light.factors[1] = Factor::Gray),
    mutant(FADES, |rules| rules.light.fading = Fading::Inverse),
    mutant(FADES, |rules| rules.light.fading = Fading::Square),
    mutant(FADES, |rules| rules.light.fading = Fading::OneAndInverse),
    mutant(FADES, |rules| rules.light.fading = Fading::OneAndSquare),
    mutant(FADES, |rules| (rules.light.fading, rules.light.lamps) = (Fading::Inverse, Lamps::FadeTogether)),
    mutant(FADES, |rules| (rules.light.fading, rules.light.lamps) = (Fading::Square, Lamps::FadeTogether)),
    mutant(FADES, |rules| (rules.light.fading, rules.light.lamps) = (Fading::OneAndInverse, Lamps::FadeTogether)),
    mutant(FADES, |rules| (rules.light.fading, rules.light.lamps) = (Fading::OneAndSquare, Lamps::FadeTogether)),
    mutant(FEW_LAMPS, |rules| rules.light.lamps = Lamps::First),
    mutant(FEW_LAMPS, |rules| rules.light.lamps = Lamps::Last),
    mutant(FEW_LAMPS, |rules| rules.light.lamps = Lamps::Brightest),
    mutant(FEW_LAMPS, |rules| rules.light.lamps = Lamps::OnePlace),
    mutant(MEAN_LAMPS, |rules| rules.light.lamps = Lamps::Mean),
    mutant(WHITE_LAMPS, |rules| rules.light.lamps = Lamps::White),
    mutant(WHITE_LAMPS, |rules| rules.light.lamps = Lamps::WhiteHighlights),
    mutant(SCALED, |rules| rules.light.sum = Sum::Times(0.5)),
    mutant(SCALED, |rules| rules.light.sum = Sum::Times(2.0)),
    mutant(SCALED, |rules| rules.light.sum = Sum::Times(0.25)),
    mutant(SCALED, |rules| rules.light.sum = Sum::Times(core::f64::consts::FRAC_1_PI)),
    mutant(SCALED, |rules| rules.light.sum = Sum::Normalized),
    mutant(SQUARED, |rules| rules.light.sum = Sum::Squared),
    mutant(SQUARED, |rules| rules.light.sum = Sum::Inverted),
    mutant(WRAPS, |rules| rules.light.sum = Sum::Wraps),
    mutant(DARK_BLACK, |rules| rules.light.sum = Sum::DarkIsBlack),
    mutant(EYE, |rules| rules.light.eye = EyeFrom::Corner(0)),
    mutant(EYE, |rules| rules.light.eye = EyeFrom::Corner(1)),
    mutant(EYE, |rules| rules.light.eye = EyeFrom::Corner(2)),
    mutant(EYE, |rules| rules.light.eye = EyeFrom::Mean),
    mutant(EYE_SCREEN, |rules| rules.light.eye = EyeFrom::Screen),
    mutant(EYE_SCREEN, |rules| rules.light.eye = EyeFrom::OverW),
    mutant(EYE_SCREEN, |rules| rules.light.eye = EyeFrom::Twice),
];
