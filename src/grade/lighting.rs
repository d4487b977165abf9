//! Lighting: the light of a lit face at a sample, right or with one mistake.
//!
//! Ambient + Kd max(0, N.L) + Ks max(0, R.V)^n, the highlight only where N.L > 0; lamps that do not fade.
//! Written anew from the formula: the shader that students call must not judge itself.

use super::case::{Case, Face, Lamp};
use super::light_rules::{
    Cosine, Cut, EyeFrom, Factor, Fading, Gate, Highlight, Lamps, Length, LightRules, LitAt, NormalFrom, Power, Reach,
    Sum, Tint, ToEye, ToLamp,
};
use super::rules::{Interpolation, Rules};
use super::values::{self, Corners};
use crate::math::{Vec3, acos, pow, unit};

type Light = [f64; 3];
const HALF_PI: f64 = std::f64::consts::FRAC_PI_2;

/// The light of `face` at point `at` of the screen, in the light of `lamp`.
pub(super) fn light(
    (case, lamp): (&Case, &Lamp),
    (face, corners): (&Face, &Corners),
    rules: &Rules,
    at: (f64, f64),
) -> Light {
    let rule = &rules.light;
    // What takes one corner's value for a color takes one normal here, and that has its own names.
    let spread = match rules.values {
        Interpolation::Corner(_)
        | Interpolation::Mean
        | Interpolation::Least
        | Interpolation::Greatest
        | Interpolation::Middle
        | Interpolation::NearestToEye
        | Interpolation::Heaviest
        | Interpolation::Closest => Rules { values: Interpolation::Perspective, ..rules.clone() },
        _ => rules.clone(),
    };
    let scene = Lit { case, face, corners, rules: &spread };
    let lit = |at: (f64, f64)| sent(lamp, rule, scene.normal(at), scene.eye(at));
    let corner = |number: usize| lit(face.corners[number]);
    let all = || [0, 1, 2].map(corner);
    let mean = |lights: [Light; 3]| [0, 1, 2].map(|c| (lights[0][c] + lights[1][c] + lights[2][c]) / 3.0);
    match rule.at {
        LitAt::Sample => lit(at),
        LitAt::Corner(number) => corner(number),
        LitAt::Nearest => corner(values::nearest(face)),
        LitAt::Mean => mean(all()),
        LitAt::Middle => lit(values::middle(face)),
        LitAt::CornersOnScreen => values::weighted(&values::weights(face, at), &all()),
        LitAt::Corners => {
            let [a, b, c] = values::weights(face, at);
            let over = |number: usize| face.inverse_w_at(face.corners[number]) / face.inverse_w_at(at);
            values::weighted(&[a * over(0), b * over(1), c * over(2)], &all())
        }
    }
}

struct Lit<'a> {
    case: &'a Case,
    face: &'a Face,
    corners: &'a Corners,
    rules: &'a Rules,
}

impl Lit<'_> {
    fn normal(&self, at: (f64, f64)) -> Vec3 {
        let values = &self.corners.values;
        Vec3::from(match self.rules.light.normal {
            NormalFrom::Corners => values::interpolated(self.face, self.corners, self.rules, (at, None)),
            NormalFrom::Corner(number) => values[number],
            NormalFrom::Nearest => values[values::nearest(self.face)],
            NormalFrom::Heaviest => values[values::heaviest(self.face, at)],
            NormalFrom::Mean => [0, 1, 2].map(|axis| values[0][axis] + values[1][axis] + values[2][axis]),
            NormalFrom::Fixed => [0.0, 0.0, -1.0],
            NormalFrom::Plane => {
                let [a, b, c] = [0, 1, 2].map(|number| self.seen(self.face.corners[number]));
                let normal = (b - a).cross(c - a);
                if normal.dot(a) > 0.0 { -normal } else { normal }.to_array()
            }
        })
    }

    fn seen(&self, at: (f64, f64)) -> Vec3 {
        self.case.eye(at, 1.0 / self.face.inverse_w_at(at))
    }

    fn eye(&self, at: (f64, f64)) -> Vec3 {
        let corner = |number: usize| self.seen(self.face.corners[number]);
        match self.rules.light.eye {
            EyeFrom::Sample => self.seen(at),
            EyeFrom::Corner(number) => corner(number),
            EyeFrom::Mean => (corner(0) + corner(1) + corner(2)) / 3.0,
            EyeFrom::OverW => self.case.eye(at, 1.0),
            EyeFrom::Twice => self.case.eye(at, pow(self.face.inverse_w_at(at), -2.0)),
            EyeFrom::Screen => {
                let [a, b, c] = values::weights(self.face, at);
                corner(0) * a + corner(1) * b + corner(2) * c
            }
        }
    }
}

fn divided(v: Vec3, length: Length) -> Vec3 {
    let by = |divisor: f64| if divisor > 0.0 { v / divisor } else { Vec3::ZERO };
    match length {
        Length::Unit => unit(v).unwrap_or(Vec3::ZERO),
        Length::AsIs => v,
        Length::Sum => by(v.x.abs() + v.y.abs() + v.z.abs()),
        Length::Greatest => by(v.x.abs().max(v.y.abs()).max(v.z.abs())),
        Length::Squared => by(v.dot(v)),
        Length::Root => by(v.length().sqrt()),
    }
}

/// What one lamp adds, without coefficients: diffuse light, the highlight, and N.L.
struct Term {
    diffuse: f64,
    highlight: f64,
    cosine: f64,
}

fn term(lamp: &Lamp, rule: &LightRules, position: Vec3, (n, eye): (Vec3, Vec3)) -> Term {
    let flipped = |axis: usize| {
        let mut numbers = position.to_array();
        numbers[axis] = -numbers[axis];
        Vec3::from(numbers)
    };
    let l = divided(
        match rule.lamp {
            ToLamp::FromPoint => position - eye,
            ToLamp::Reversed => eye - position,
            ToLamp::Position => position,
            ToLamp::Plus => position + eye,
            ToLamp::AtEye => -eye,
            ToLamp::Flipped(axis) => flipped(axis) - eye,
        },
        rule.lamp_length,
    );
    let v = match rule.view {
        ToEye::FromPoint => divided(-eye, Length::Unit),
        ToEye::NotUnit => -eye,
        ToEye::Fixed => Vec3::NEG_Z,
        ToEye::Reversed => divided(eye, Length::Unit),
        ToEye::FixedReversed => Vec3::Z,
        ToEye::Lamp => l,
    };
    let cosine = n.dot(l);
    let changed = changed(cosine, rule.cosine);
    let (gate, mirrored) = match rule.reach {
        Reach::Diffuse => (cosine, cosine),
        Reach::Gate => (changed, cosine),
        Reach::All => (changed, changed),
    };
    let has_highlight = match rule.gate {
        Gate::Lamp => gate > 0.0,
        Gate::Everywhere => true,
        Gate::Eye => n.dot(v) > 0.0,
        Gate::Reversed => gate <= 0.0,
    };
    let base = base(rule.highlight, mirrored, (n, l, v));
    let fading = if rule.lamps == Lamps::FadeTogether { 1.0 } else { faded(rule.fading, (position - eye).length()) };
    let diffuse = if rule.cosine == Cosine::Uncut { changed } else { changed.max(0.0) };
    let is_raised = matches!(rule.power, Power::OnDiffuse | Power::OnBoth);
    let diffuse = if is_raised { raised(diffuse, lamp.shine, Cut::AtZero) } else { diffuse };
    let highlight = if has_highlight { powered(lamp, rule, base) } else { 0.0 };
    Term { diffuse: diffuse * fading, highlight: highlight * fading, cosine: gate }
}

fn changed(cosine: f64, rule: Cosine) -> f64 {
    match rule {
        Cosine::Plain | Cosine::Uncut => cosine,
        Cosine::Absolute => cosine.abs(),
        Cosine::Half => cosine * 0.5 + 0.5,
        Cosine::HalfSquared => (cosine * 0.5 + 0.5) * (cosine * 0.5 + 0.5),
        Cosine::Squared => cosine * cosine.abs(),
        Cosine::Root => cosine.abs().sqrt() * cosine.signum(),
        Cosine::Reversed => -cosine,
        Cosine::One => f64::from(u8::from(cosine > 0.0)),
        Cosine::Angle => 1.0 - acos(cosine.clamp(-1.0, 1.0)) / HALF_PI,
        Cosine::Sine => (1.0 - cosine * cosine).max(0.0).sqrt() * cosine.signum(),
    }
}

/// The cosine that is raised to the exponent.
fn base(rule: Highlight, cosine: f64, (n, l, v): (Vec3, Vec3, Vec3)) -> f64 {
    let twice = 2.0 * cosine;
    match rule {
        Highlight::Mirrored => (n * twice - l).dot(v),
        Highlight::Reversed => (l - n * twice).dot(v),
        Highlight::WithoutTwo => (n * cosine - l).dot(v),
        Highlight::Plus => (n * twice + l).dot(v),
        Highlight::WithoutCosine => (n * 2.0 - l).dot(v),
        Highlight::NothingTaken => (n * twice).dot(v),
        Highlight::AroundLamp => (l * twice - n).dot(v),
        Highlight::AroundView => 2.0 * v.dot(l) * v.dot(n) - l.dot(n),
        Highlight::Halfway => n.dot(divided(l + v, Length::Unit)),
        Highlight::HalfwayNotUnit => n.dot(l + v),
        Highlight::HalfwayMean => n.dot(l + v) * 0.5,
        Highlight::Normal => n.dot(v),
        Highlight::Lamp => l.dot(v),
        Highlight::Diffuse => cosine,
        Highlight::Everywhere => 1.0,
    }
}

fn powered(lamp: &Lamp, rule: &LightRules, base: f64) -> f64 {
    let cut = |base: f64, power: f64| raised(base, power, rule.cut);
    match rule.power {
        Power::Times(factor) => cut(base, lamp.shine * factor),
        Power::Plus(more) => cut(base, lamp.shine + more),
        Power::Fixed(power) => cut(base, power),
        Power::Multiplied => cut(base, 1.0) * lamp.shine,
        // The sum multiplies by Ks once more; what is meant is (Ks base)^n alone.
        Power::WithCoefficient if lamp.specular > 0.0 => cut(base * lamp.specular, lamp.shine) / lamp.specular,
        Power::WithCoefficient => 0.0,
        Power::OnDiffuse => cut(base, 1.0),
        Power::OnBoth => cut(base, lamp.shine),
        Power::Root => cut(base, lamp.shine.sqrt()),
    }
}

fn raised(base: f64, power: f64, cut: Cut) -> f64 {
    match cut {
        _ if base > 0.0 => pow(base, power),
        Cut::AtZero => 0.0,
        Cut::Absolute => pow(-base, power),
        // An odd power keeps the sign; one that is no whole number has no value.
        Cut::Not if power % 2.0 == 0.0 => pow(-base, power),
        Cut::Not if power % 2.0 == 1.0 => -pow(-base, power),
        Cut::Not => 0.0,
    }
}

fn faded(fading: Fading, distance: f64) -> f64 {
    match fading {
        Fading::None => 1.0,
        Fading::Inverse => 1.0 / distance,
        Fading::Square => 1.0 / (distance * distance),
        Fading::OneAndInverse => 1.0 / (1.0 + distance),
        Fading::OneAndSquare => 1.0 / (1.0 + distance * distance),
    }
}

fn coefficient(lamp: &Lamp, own: Light, factor: Factor) -> Light {
    match factor {
        Factor::Own => own,
        Factor::Times(times) => own.map(|channel| channel * times),
        Factor::One => [1.0; 3],
        Factor::Ambient => lamp.ambient,
        Factor::Diffuse => lamp.diffuse,
        Factor::Specular => [lamp.specular; 3],
        Factor::Shine => [lamp.shine; 3],
        Factor::Squared => own.map(|channel| channel * channel),
        Factor::Gray => [own.iter().sum::<f64>() / 3.0; 3],
        Factor::Rest => own.map(|channel| 1.0 - channel),
    }
}

fn sent(lamp: &Lamp, rule: &LightRules, normal: Vec3, eye: Vec3) -> Light {
    let n = divided(normal * Vec3::from(rule.signs), rule.length);
    let n = if rule.steps > 0.0 { n.map(|number| (number * rule.steps).round() / rule.steps) } else { n };
    let own = [lamp.ambient, lamp.diffuse, [lamp.specular; 3]];
    let coefficients = [0, 1, 2].map(|term| coefficient(lamp, own[term], rule.factors[term]));
    let count = lamp.lamps().count();
    let (mut matte, mut shiny, mut is_dark) = ([0.0; 3], [0.0; 3], true);
    for (number, (position, color)) in lamp.lamps().enumerate() {
        let is_left_out = match rule.lamps {
            Lamps::First => number > 0,
            Lamps::Last => number + 1 < count,
            _ => false,
        };
        if is_left_out {
            continue;
        }
        let position = if rule.lamps == Lamps::OnePlace { lamp.position } else { position };
        let term = term(lamp, rule, position, (n, eye));
        is_dark &= term.cosine <= 0.0;
        for channel in 0..3 {
            let share = if rule.lamps == Lamps::Mean { 1.0 / count as f64 } else { 1.0 };
            let (more, shine) = reflected(rule, &coefficients, &term, (color[channel] * share, channel));
            if rule.lamps != Lamps::Brightest {
                matte[channel] += more;
                shiny[channel] += shine;
            } else if number == 0 || more + shine > matte[channel] + shiny[channel] {
                (matte[channel], shiny[channel]) = (more, shine);
            }
        }
        if rule.lamps == Lamps::FadeTogether && term.cosine > 0.0 {
            let fading = faded(rule.fading, (position - eye).length());
            (matte, shiny) = (matte.map(|light| light * fading), shiny.map(|light| light * fading));
        }
    }
    let ambients = if rule.lamps == Lamps::AmbientEach { count as f64 } else { 1.0 };
    let whole: f64 = own.iter().map(|term| term[0]).sum();
    [0, 1, 2].map(|c| together(rule.sum, [coefficients[0][c] * ambients, matte[c], shiny[c]], (is_dark, whole)))
}

/// What one lamp adds to one channel: diffuse light and highlight.
fn reflected(rule: &LightRules, coefficients: &[Light; 3], term: &Term, (color, channel): (f64, usize)) -> (f64, f64) {
    let [ambient, diffuse, specular] = coefficients.map(|coefficient| coefficient[channel]);
    let color = if rule.lamps == Lamps::White { 1.0 } else { color };
    let matte = diffuse * term.diffuse;
    let tint = match rule.tint {
        Tint::White => 1.0,
        Tint::Surface => diffuse,
        Tint::Ambient => ambient,
        Tint::Cosine => term.cosine,
        Tint::DiffuseTerm => matte,
    };
    let shine = tint * specular * term.highlight;
    (color * matte, if rule.lamps == Lamps::WhiteHighlights { shine } else { color * shine })
}

fn together(sum: Sum, [ambient, matte, shiny]: [f64; 3], (is_dark, whole): (bool, f64)) -> f64 {
    let all = ambient + matte + shiny;
    match sum {
        Sum::All => all,
        Sum::Times(factor) => all * factor,
        Sum::Normalized => all / whole,
        Sum::AmbientTimes => ambient * (matte + shiny),
        Sum::Greatest => ambient.max(matte).max(shiny),
        Sum::AmbientInTheDark => {
            if is_dark {
                ambient
            } else {
                matte + shiny
            }
        }
        Sum::DarkIsBlack => {
            if is_dark {
                0.0
            } else {
                all
            }
        }
        Sum::HighlightReplaces => ambient + if shiny > 0.0 { shiny } else { matte },
        Sum::Wraps => (all * 255.0).round().rem_euclid(256.0) / 255.0,
        Sum::Squared => all * all,
        Sum::Inverted => 1.0 - all,
    }
}
