//! Mistakes about the highlight.

use super::{Mutant, mutant};
use crate::grade::light_rules::{Cut, Factor, Gate, Highlight, Power, Sum, Tint, ToEye};

const SHADING: &str = "docs/shading.md";
const LOST: [&str; 4] = [
    "highlight lost",
    "There is no highlight.",
    "The highlight is Ks max(0, R.V)^n with R = 2 (N.L) N - L, where N.L > 0.",
    SHADING,
];
const COEFFICIENT: [&str; 4] = [
    "highlight coefficient wrong",
    "The highlight is counted twice or by half, or has the coefficient of another term or none.",
    "The highlight is Ks max(0, R.V)^n with R = 2 (N.L) N - L, where N.L > 0.",
    SHADING,
];
const TINTED: [&str; 4] = [
    "highlight tinted",
    "The highlight has the color of the surface, or fades with N.L as diffuse light does.",
    "The highlight has the lamp's color and Ks, and nothing else to multiply by.",
    SHADING,
];
const HALFWAY: [&str; 4] = [
    "highlight from the halfway vector",
    "The highlight is Blinn's (N.H)^n, which is wider.",
    "The highlight is (R.V)^n with R = 2 (N.L) N - L.",
    SHADING,
];
const DARK: [&str; 4] = [
    "highlight on the dark side",
    "A highlight is added where the lamp is behind the surface.",
    "There is a highlight only where N.L > 0.",
    SHADING,
];
const SIGN: [&str; 4] = [
    "highlight on the wrong side",
    "R.V has the wrong sign: V leads away from the eye, or R is L - 2 (N.L) N.",
    "The highlight is Ks max(0, R.V)^n with R = 2 (N.L) N - L, where N.L > 0.",
    SHADING,
];
const MIRROR: [&str; 4] = [
    "lamp mirrored wrongly",
    "The vector to the lamp is not mirrored at the normal: the 2, N.L or - L is missing, or another vector is mirrored.",
    "The highlight is Ks max(0, R.V)^n with R = 2 (N.L) N - L, where N.L > 0.",
    SHADING,
];
const OTHER: [&str; 4] = [
    "highlight of another cosine",
    "The highlight is of N.V, L.V or N.L, not of R.V.",
    "The highlight is Ks max(0, R.V)^n with R = 2 (N.L) N - L, where N.L > 0.",
    SHADING,
];
const UNCUT: [&str; 4] = [
    "R.V not cut at 0",
    "Where the mirrored light leads away from the eye there is a highlight as well.",
    "The highlight is max(0, R.V)^n.",
    SHADING,
];
const ONE: [&str; 4] = ["exponent lost", "The highlight has no exponent.", "The highlight is (R.V)^n.", SHADING];
const POWER: [&str; 4] = [
    "exponent wrong",
    "The exponent is halved, doubled, off by one, a root, or a fixed number.",
    "The exponent is the material's n, as it is.",
    SHADING,
];
const TIMES: [&str; 4] =
    ["multiplied by the exponent", "R.V is multiplied by n, not raised to it.", "The highlight is (R.V)^n.", SHADING];
const PLACE: [&str; 4] = [
    "exponent at the wrong place",
    "The exponent is put on something else than R.V: on N.L, or on Ks as well.",
    "The highlight is Ks (R.V)^n, diffuse light has no exponent.",
    SHADING,
];
const EYE_FIXED: [&str; 4] = [
    "eye infinitely far away",
    "V is (0, 0, -1) for all points.",
    "V leads from the point to the eye, which stands at the origin: -point, made unit.",
    SHADING,
];
const EYE_LENGTH: [&str; 4] = [
    "direction to the eye not unit",
    "The vector to the eye is not divided by its length.",
    "R.V is of unit vectors.",
    SHADING,
];
const REPLACES: [&str; 4] = [
    "highlight instead of diffuse light",
    "Where there is a highlight there is no diffuse light.",
    "Ambient light, diffuse light and the highlight are added.",
    SHADING,
];

pub(super) const MUTANTS: &[Mutant] = &[
    mutant(LOST, |rules| rules.light.factors[2] = Factor::Times(0.0)),
    mutant(COEFFICIENT, |rules| rules.light.factors[2] = Factor::Times(2.0)),
    mutant(COEFFICIENT, |rules| rules.light.factors[2] = Factor::Times(0.5)),
    mutant(COEFFICIENT, |rules| rules.light.factors[2] = Factor::Times(3.0)),
    mutant(COEFFICIENT, |rules| rules.light.factors[2] = Factor::One),
    mutant(COEFFICIENT, |rules| rules.light.factors[2] = Factor::Diffuse),
    mutant(COEFFICIENT, |rules| rules.light.factors[2] = Factor::Ambient),
    mutant(COEFFICIENT, |rules| rules.light.factors[2] = Factor::Shine),
    mutant(COEFFICIENT, |rules| rules.light.factors[2] = Factor::Squared),
    mutant(COEFFICIENT, |rules| rules.light.factors[2] = Factor::Rest),
    mutant(TINTED, |rules| rules.light.tint = Tint::Surface),
    mutant(TINTED, |rules| rules.light.tint = Tint::Ambient),
    mutant(TINTED, |rules| rules.light.tint = Tint::Cosine),
    mutant(TINTED, |rules| rules.light.tint = Tint::DiffuseTerm),
    mutant(HALFWAY, |rules| rules.light.highlight = Highlight::Halfway),
    mutant(HALFWAY, |rules| rules.light.highlight = Highlight::HalfwayNotUnit),
    mutant(HALFWAY, |rules| rules.light.highlight = Highlight::HalfwayMean),
    mutant(HALFWAY, |rules| (rules.light.highlight, rules.light.power) = (Highlight::Halfway, Power::Times(4.0))),
    mutant(HALFWAY, |rules| (rules.light.highlight, rules.light.power) = (Highlight::Halfway, Power::Times(2.0))),
    mutant(HALFWAY, |rules| (rules.light.highlight, rules.light.gate) = (Highlight::Halfway, Gate::Everywhere)),
    mutant(DARK, |rules| rules.light.gate = Gate::Everywhere),
    mutant(DARK, |rules| (rules.light.gate, rules.light.cut) = (Gate::Everywhere, Cut::Absolute)),
    mutant(DARK, |rules| (rules.light.gate, rules.light.cut) = (Gate::Everywhere, Cut::Not)),
    mutant(DARK, |rules| rules.light.gate = Gate::Eye),
    mutant(DARK, |rules| rules.light.gate = Gate::Reversed),
    mutant(SIGN, |rules| rules.light.highlight = Highlight::Reversed),
    mutant(SIGN, |rules| (rules.light.highlight, rules.light.gate) = (Highlight::Reversed, Gate::Everywhere)),
    mutant(SIGN, |rules| (rules.light.highlight, rules.light.cut) = (Highlight::Reversed, Cut::Not)),
    mutant(MIRROR, |rules| rules.light.highlight = Highlight::WithoutTwo),
    mutant(MIRROR, |rules| rules.light.highlight = Highlight::Plus),
    mutant(MIRROR, |rules| rules.light.highlight = Highlight::WithoutCosine),
    mutant(MIRROR, |rules| rules.light.highlight = Highlight::NothingTaken),
    mutant(MIRROR, |rules| rules.light.highlight = Highlight::AroundLamp),
    mutant(MIRROR, |rules| rules.light.highlight = Highlight::AroundView),
    mutant(MIRROR, |rules| (rules.light.highlight, rules.light.gate) = (Highlight::Plus, Gate::Everywhere)),
    mutant(OTHER, |rules| rules.light.highlight = Highlight::Normal),
    mutant(OTHER, |rules| rules.light.highlight = Highlight::Lamp),
    mutant(OTHER, |rules| rules.light.highlight = Highlight::Diffuse),
    mutant(OTHER, |rules| rules.light.highlight = Highlight::Everywhere),
    mutant(UNCUT, |rules| rules.light.cut = Cut::Absolute),
    mutant(UNCUT, |rules| rules.light.cut = Cut::Not),
    mutant(ONE, |rules| rules.light.power = Power::Fixed(1.0)),
    mutant(POWER, |rules| rules.light.power = Power::Times(0.5)),
    mutant(POWER, |rules| rules.light.power = Power::Times(2.0)),
    mutant(POWER, |rules| rules.light.power = Power::Times(0.25)),
    mutant(POWER, |rules| rules.light.power = Power::Times(4.0)),
    mutant(POWER, |rules| rules.light.power = Power::Plus(1.0)),
    mutant(POWER, |rules| rules.light.power = Power::Plus(-1.0)),
    mutant(POWER, |rules| rules.light.power = Power::Fixed(2.0)),
    mutant(POWER, |rules| rules.light.power = Power::Fixed(8.0)),
    mutant(POWER, |rules| rules.light.power = Power::Fixed(10.0)),
    mutant(POWER, |rules| rules.light.power = Power::Fixed(16.0)),
    mutant(POWER, |rules| rules.light.power = Power::Fixed(32.0)),
    mutant(POWER, |rules| rules.light.power = Power::Root),
    mutant(TIMES, |rules| rules.light.power = Power::Multiplied),
    mutant(PLACE, |rules| rules.light.power = Power::WithCoefficient),
    mutant(PLACE, |rules| rules.light.power = Power::OnDiffuse),
    mutant(PLACE, |rules| rules.light.power = Power::OnBoth),
    mutant(EYE_FIXED, |rules| rules.light.view = ToEye::Fixed),
    mutant(SIGN, |rules| rules.light.view = ToEye::FixedReversed),
    mutant(OTHER, |rules| rules.light.view = ToEye::Lamp),
    mutant(EYE_LENGTH, |rules| rules.light.view = ToEye::NotUnit),
    mutant(REPLACES, |rules| rules.light.sum = Sum::HighlightReplaces),
];
