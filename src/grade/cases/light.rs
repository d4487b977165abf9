//! Cases about light: triangles with normals that bend, under lamps.

use super::color::LEFT;
use crate::grade::case::{Case, Face, Lamp};
use crate::math::Vec3;

/// The corners' normals, before they are made unit.
const BENT: [[f64; 3]; 3] = [[-0.8, 0.5, -0.6], [0.9, 0.2, -0.5], [0.1, -0.9, -0.6]];
const LAMP: Lamp = Lamp {
    position: Vec3::new(2.0, 3.0, -1.0),
    color: [1.0; 3],
    second: None,
    ambient: [0.1; 3],
    diffuse: [0.4; 3],
    specular: 0.45,
    shine: 12.0,
};

fn lit(name: &str, lamp: Lamp, w: [f64; 3]) -> Case {
    let normals = BENT.map(|v| crate::math::unit(Vec3::from(v)).unwrap_or(Vec3::NEG_Z).to_array());
    let mut case = Case::new(name, (12, 12), vec![Face::smooth(LEFT, w, normals)]);
    case.lamp = Some(lamp);
    case
}

/// Triangles with normals that bend: matte, shiny, colored, under one lamp and two, from before and behind.
#[must_use]
pub fn light(_: u64) -> Vec<Case> {
    let behind = Lamp { position: Vec3::new(-6.0, 1.0, 9.0), diffuse: [0.8; 3], shine: 3.0, ..LAMP };
    let matte = Lamp { specular: 0.0, diffuse: [0.8; 3], ..LAMP };
    // Orange under a lamp that is not white: the highlight has the lamp's color and not the surface's.
    let orange = Lamp {
        position: Vec3::new(0.5, 0.5, -2.0),
        color: [0.9, 0.7, 1.0],
        ambient: [0.16, 0.08, 0.03],
        diffuse: [0.5, 0.25, 0.1],
        ..LAMP
    };
    // A small exponent and a lamp far to the side: much of the highlight is where R.V is small or negative.
    let wide =
        Lamp { position: Vec3::new(7.0, -4.0, 5.0), diffuse: [0.3, 0.25, 0.2], specular: 0.6, shine: 2.0, ..LAMP };
    let second = Some((Vec3::new(4.0, -3.0, 0.0), [0.2, 0.5, 0.9]));
    let two = Lamp { position: Vec3::new(-4.0, 2.0, 1.0), color: [0.9, 0.4, 0.3], second, shine: 5.0, ..orange };
    // Sums above 1 are cut, once.
    let bright = Lamp { ambient: [0.3, 0.2, 0.1], diffuse: [0.7, 0.6, 0.3], specular: 0.8, shine: 3.0, ..LAMP };
    let bright =
        Lamp { position: Vec3::new(1.0, 1.0, -2.0), second: Some((Vec3::new(-3.0, 0.0, -1.0), [0.6; 3])), ..bright };
    vec![
        lit("matte", matte, [4.0; 3]),
        lit("highlight", Lamp { position: Vec3::new(0.5, 0.5, -2.0), ..LAMP }, [4.0; 3]),
        lit("lamp behind", behind, [4.0, 5.0, 4.0]),
        lit("receding", LAMP, [3.0, 8.0, 5.0]),
        lit("orange", orange, [4.0, 2.0, 3.0]),
        lit("wide highlight", wide, [2.0, 3.0, 2.0]),
        lit("two lamps", two, [4.0, 3.0, 5.0]),
        lit("too bright", bright, [4.0; 3]),
    ]
}
