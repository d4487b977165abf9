//! Lines: roads, paths and rivers as strips on the ground.
//!
//! Line -> points every few metres -> strip, a little above the ground
//!
//! Why above: a strip in the ground's own plane would fight with it for every sample. Why points in between: the ground bends under a long
//! stretch of road, and the road with it.

use super::ground::Land;
use crate::color::Rgb;
use crate::forest::area::{Cell, Line};
use crate::math::{Vec2, Vec3};
use crate::scene::{Material, Mesh, NormalSource, Reflection};

/// How far above the ground a strip lies, in metres.
const RAISED: f64 = 0.4;
/// The longest stretch of a strip, as a part of the side of a cell.
const STRETCH: f64 = 1.0 / 64.0;

/// The strip of a line, in the cell; empty where the line has no length or its ground is a void.
pub(super) fn strip(land: &Land<'_>, cell: &Cell, line: &Line) -> Mesh {
    let mut mesh = Mesh::default();
    let points = stretched(&line.points, land.side() * STRETCH);
    let mut last = None;
    for (index, &point) in points.iter().enumerate() {
        let (before, after) = (points[index.saturating_sub(1)], points[(index + 1).min(points.len() - 1)]);
        let Some(along) = (after - before).try_normalize() else { continue };
        let left = along.perp() * (line.width / 2.0);
        let mut edge = |at: Vec2| {
            let z = land.height_in(cell, at.to_array())?;
            Some(mesh.push_vertex(Vec3::new(at.x, at.y, z + RAISED)))
        };
        let pair = edge(point + left).zip(edge(point - left));
        if let (Some((left, right)), Some((last_left, last_right))) = (pair, last) {
            mesh.push_polygon(&[last_right, right, left], NormalSource::Averaged, line.place.line);
            mesh.push_polygon(&[last_right, left, last_left], NormalSource::Averaged, line.place.line);
        }
        last = pair;
    }
    mesh
}

/// The points of a line, and others between them, at most `step` from one to the next.
fn stretched(points: &[[f64; 2]], step: f64) -> Vec<Vec2> {
    let mut all: Vec<Vec2> = Vec::new();
    for pair in points.windows(2) {
        let [from, to] = [pair[0], pair[1]].map(Vec2::from_array);
        let count = ((to - from).length() / step).ceil().max(1.0) as u32;
        all.extend((0..count).map(|part| from.lerp(to, f64::from(part) / f64::from(count))));
    }
    all.extend(points.last().map(|&point| Vec2::from_array(point)));
    all.dedup();
    all
}

/// What a line is made of.
pub(super) fn material(kind: &str) -> Material {
    let (color, specular) = match kind {
        "road" => (Rgb::new(0.45, 0.44, 0.43), 0.0),
        "river" => (Rgb::new(0.22, 0.40, 0.52), 0.2),
        _ => (Rgb::new(0.66, 0.56, 0.42), 0.0),
    };
    let reflection = Reflection::Phong;
    Material { reflection, color, ambient: Some(0.4), diffuse: 0.6, specular, shine: 20.0, ..Material::default() }
}
