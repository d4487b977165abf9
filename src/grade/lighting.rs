//! Lighting: the light of a lit face at a sample, right or with one mistake.
//!
//! Ambient + Kd max(0, N.L) + Ks max(0, R.V)^n, the highlight only where N.L > 0; one lamp that does not fade.
//! Written anew from the formula: the shader that students call must not judge itself.

use super::case::{Case, Face, Lamp};
use super::rules::{Light, Rules};
use crate::math::{Vec3, pow, unit};

/// The light at point `at` of the screen, where `normal` gives the normal of any point.
pub(super) fn light(
    case: &Case,
    face: &Face,
    (lamp, rules): (&Lamp, &Rules),
    at: (f64, f64),
    normal: impl Fn((f64, f64)) -> [f64; 3],
) -> [f64; 3] {
    let lit =
        |at: (f64, f64)| sent(lamp, rules.light, case.eye(at, 1.0 / face.inverse_w_at(at)), Vec3::from(normal(at)));
    let value = match rules.light {
        Light::AtFirstCorner => lit(face.corners[0]),
        Light::AtCorners => {
            let corners = [0, 1, 2].map(|corner| face.corners[corner]);
            let values = corners.map(|corner| [lit(corner); 3]);
            Face::smooth([corners[0], corners[1], corners[2]], corners.map(|c| 1.0 / face.inverse_w_at(c)), values)
                .values_at(at)[0]
        }
        _ => lit(at),
    };
    [value; 3]
}

fn sent(lamp: &Lamp, rule: Light, eye: Vec3, normal: Vec3) -> f64 {
    let or_zero = |v: Vec3| unit(v).unwrap_or(Vec3::ZERO);
    let normal = if rule == Light::NormalNotUnit { normal } else { or_zero(normal) };
    let to_lamp = if rule == Light::LampNotUnit { lamp.position - eye } else { or_zero(lamp.position - eye) };
    let view = or_zero(-eye);
    let cosine = normal.dot(to_lamp);
    let ambient = if rule == Light::NoAmbient { 0.0 } else { lamp.ambient };
    let diffuse = if rule == Light::BothSides { cosine.abs() } else { cosine.max(0.0) };
    let mirrored = (normal * (2.0 * cosine) - to_lamp).dot(view);
    let halfway = normal.dot(or_zero(to_lamp + view));
    let exponent = if rule == Light::ExponentOne { 1.0 } else { lamp.shine };
    let base = if rule == Light::HalfwayHighlight { halfway } else { mirrored }.max(0.0);
    let has_highlight = match rule {
        Light::NoHighlight => false,
        Light::HighlightEverywhere => true,
        _ => cosine > 0.0,
    };
    let highlight = if has_highlight && base > 0.0 { pow(base, exponent) } else { 0.0 };
    ambient + lamp.diffuse * diffuse + lamp.specular * highlight
}
