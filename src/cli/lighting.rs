//! Lights and reflection models in words, for `--stats` and `--dump-stage scene`. NFF's own need none.

use crate::scene::{Light, LightSource, Reflection, SpotEdge, Surface};

/// What a light is besides a point with a color, behind a comma; empty for NFF's.
pub(super) fn light_words(light: &Light) -> String {
    let mut words = match light.source {
        LightSource::Point { .. } => String::new(),
        LightSource::Directional { .. } => ", directional".to_string(),
        LightSource::Spot { at, opening, edge, .. } => {
            let edge = if edge == SpotEdge::Soft { "soft" } else { "sharp" };
            format!(", {edge} spot of {opening} degrees at ({:.2} {:.2} {:.2})", at.x, at.y, at.z)
        }
    };
    if let Some(intensity) = light.intensity {
        words += &format!(", intensity {intensity}");
    }
    words
}

/// What a surface is besides NFF's, behind commas; empty for NFF's.
pub(super) fn surface_words(surface: &Surface) -> String {
    let mut words = match surface.material.reflection {
        Reflection::Nff => String::new(),
        Reflection::Phong => ", phong".to_string(),
        Reflection::Basic { c3 } => format!(", basic c3 {c3}"),
    };
    if !surface.mesh.colors.is_empty() {
        words += ", colors at vertices";
    }
    if surface.two_sided {
        words += ", two-sided";
    }
    words
}
