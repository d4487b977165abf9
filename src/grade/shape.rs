//! Shape: a case as a program sees it that cuts, moves or turns polygons before it draws them.
//!
//! Case, [`Shape`] -> the case with other corners, and with planes that follow them or not
//!
//! Space: samples. Cost: a few operations a corner.

use super::case::{Case, Face, plane_through};
use super::covered::rounded;
use super::rules::{Rules, Shape, Turned};
use std::borrow::Cow;

/// The case as it is drawn.
pub(super) fn seen<'a>(case: &'a Case, rules: &Rules) -> Cow<'a, Case> {
    let shape = rules.shape;
    if shape == Shape::RIGHT || case.lines {
        return Cow::Borrowed(case);
    }
    let mut seen = case.clone();
    seen.faces = case.faces.iter().flat_map(|face| if shape.is_fan { fan(face) } else { vec![face.clone()] }).collect();
    let size = (f64::from(case.width), f64::from(case.height));
    for face in &mut seen.faces {
        let mut corners: Vec<_> = face.corners.iter().map(|&corner| turned(corner, shape.turned, size)).collect();
        if shape.planes_follow {
            corners = corners.iter().map(|&(x, y)| (rounded(x, rules.corners), rounded(y, rules.corners))).collect();
            follow(face, &corners);
        }
        face.corners = corners;
    }
    Cow::Owned(seen)
}

/// The triangles from the first corner; their planes are the polygon's.
fn fan(face: &Face) -> Vec<Face> {
    let corners = &face.corners;
    let triangle = |number: usize| vec![corners[0], corners[number], corners[number + 1]];
    (1..corners.len() - 1).map(|number| Face { corners: triangle(number), ..face.clone() }).collect()
}

fn turned((x, y): (f64, f64), turned: Turned, (width, height): (f64, f64)) -> (f64, f64) {
    match turned {
        Turned::No => (x, y),
        Turned::UpsideDown => (x, height - y),
        Turned::Mirrored => (width - x, y),
        Turned::Half => (width - x, height - y),
        Turned::Transposed => (y, x),
    }
}

/// Gives a face the planes that take at `corners` what its own take at its corners.
fn follow(face: &mut Face, corners: &[(f64, f64)]) {
    let first = [corners[0], corners[1], corners[2]];
    let over = |[a, b, c]: [f64; 3]| {
        [0, 1, 2].map(|corner: usize| a * face.corners[corner].0 + b * face.corners[corner].1 + c)
    };
    let through = |plane: [f64; 3]| plane_through(first, over(plane));
    (face.inverse_w, face.over_w) = (through(face.inverse_w), face.over_w.map(through));
}
