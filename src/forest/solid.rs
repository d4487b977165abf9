//! Solid: a tree as a mesh, turned on the lathe from its picture.
//!
//! a species' picture -SOLID-> vertices, normals, colors, triangles -> one copy a near tree, moved, turned and stretched
//!
//! Why from the picture: whoever comes near must find the tree that was seen from afar. So each row of the picture says how wide the solid is at
//! that height, and in which color: a cone, an egg, an umbrella or a column comes out of the picture of one, a stem below it too, and pictures
//! that an area brings along work like painted ones. Radii, heights and colors differ a little from corner to corner: leaves are not turned wood.
//!
//! Space: the tree's own: x and y in crown diameters, z in heights, the foot in the origin. Source: ours.
//! Cost: 276 triangles and 145 vertices a picture, made once.

use super::pictures::Painted;
use super::random::{key, unit};
use crate::color::{Encoding, Rgb};
use crate::math::{PI, Vec3, cos, sin};

/// Corners of a ring.
const AROUND: usize = 12;
/// Rings from the foot up, below the top.
const RINGS: usize = 12;
/// Triangles of every solid.
pub const TRIANGLES: usize = AROUND * (2 * (RINGS - 1) + 1);
/// From this radius on a ring has leaves and is uneven.
const LEAFY: f64 = 0.12;
/// Tells the chances of solids from all others.
const SOLIDS: u64 = 0x501D;

/// The mesh of one picture, shared by all trees that wear it.
#[derive(Clone, Debug, PartialEq)]
pub struct Solid {
    /// Rings from below, then the top.
    pub vertices: Vec<Vec3>,
    /// Outward, of the smooth surface, in the tree's own space: a stretched tree stretches them the other way.
    pub normals: Vec<Vec3>,
    /// Display values by vertex.
    pub colors: Vec<Rgb>,
    /// Counterclockwise from outside.
    pub triangles: Vec<[u32; 3]>,
}

/// What a picture says of a height.
struct Row {
    /// Half of what is between its leftmost and its rightmost leaf, in widths of the picture.
    radius: f64,
    color: Rgb,
}

impl Solid {
    /// Turns the solid of a picture; `number` makes its unevenness its own.
    #[must_use]
    pub fn new(picture: &Painted, number: u64) -> Solid {
        let rows: Vec<Row> = (0..=RINGS).map(|ring| row(picture, ring)).collect();
        let (mut vertices, mut colors) = (Vec::new(), Vec::new());
        for (ring, row) in rows[..RINGS].iter().enumerate() {
            let leafy = if row.radius > LEAFY { 1.0 } else { 0.0 };
            for corner in 0..AROUND {
                let of = |what: u64| 2.0 * unit(key(&[SOLIDS, number, ring as u64, corner as u64, what])) - 1.0;
                let angle = 2.0 * PI * (corner as f64 + 0.2 * leafy * of(0)) / AROUND as f64;
                let radius = row.radius * (1.0 + 0.2 * leafy * of(1));
                let lift = if ring > 0 { 0.25 * leafy * of(2) } else { 0.0 };
                let z = (ring as f64 + lift) / RINGS as f64;
                vertices.push(Vec3::new(radius * cos(angle), radius * sin(angle), z));
                colors.push(shade(row.color, 1.0 + 0.14 * leafy * of(3)));
            }
        }
        vertices.push(Vec3::Z);
        colors.push(rows[RINGS].color);
        let triangles = triangles();
        let normals = normals(&vertices, &triangles);
        Solid { vertices, normals, colors, triangles }
    }
}

/// Reads the rows of a picture around a ring's height.
fn row(picture: &Painted, ring: usize) -> Row {
    let (width, height) = picture.texels.size();
    let middle = ring as f64 / RINGS as f64 * f64::from(height);
    let half = 0.4 * f64::from(height) / RINGS as f64;
    let first = ((middle - half).max(0.0) as u32).min(height.saturating_sub(1));
    let last = ((middle + half).ceil() as u32).clamp(first + 1, height.max(first + 1));
    let (mut sum, mut count, mut spans) = ([0.0; 3], 0.0, 0.0);
    for y in first..last {
        let mut span: Option<(u32, u32)> = None;
        for x in 0..width {
            let [r, g, b, alpha] = picture.texels.at(x, y);
            if alpha > 127 {
                span = Some((span.map_or(x, |(left, _)| left), x + 1));
                let level = |level: u8| f64::from(level) / 255.0;
                let light = Encoding::Srgb.decode(Rgb::new(level(r), level(g), level(b)));
                sum = [sum[0] + light.r, sum[1] + light.g, sum[2] + light.b];
                count += 1.0;
            }
        }
        spans += span.map_or(0.0, |(left, right)| f64::from(right - left));
    }
    let radius = 0.5 * spans / (f64::from(last - first) * f64::from(width.max(1)));
    if count == 0.0 {
        return Row { radius: 0.0, color: picture.color };
    }
    let mean = sum.map(|sum| f64::from(Encoding::Srgb.level((sum / count) as f32)) / 255.0);
    Row { radius, color: Rgb::new(mean[0], mean[1], mean[2]) }
}

fn shade(color: Rgb, by: f64) -> Rgb {
    let [r, g, b] = [color.r, color.g, color.b].map(|value| (value * by).clamp(0.0, 1.0));
    Rgb::new(r, g, b)
}

fn triangles() -> Vec<[u32; 3]> {
    let at = |ring: usize, corner: usize| (ring * AROUND + corner % AROUND) as u32;
    let mut all = Vec::with_capacity(TRIANGLES);
    for ring in 0..RINGS - 1 {
        for corner in 0..AROUND {
            let [a, b] = [at(ring, corner), at(ring, corner + 1)];
            let [c, d] = [at(ring + 1, corner), at(ring + 1, corner + 1)];
            all.extend([[a, b, d], [a, d, c]]);
        }
    }
    let top = (RINGS * AROUND) as u32;
    all.extend((0..AROUND).map(|corner| [at(RINGS - 1, corner), at(RINGS - 1, corner + 1), top]));
    all
}

/// Sums of the faces around each vertex, by their areas; outward on the level where they cancel.
fn normals(vertices: &[Vec3], triangles: &[[u32; 3]]) -> Vec<Vec3> {
    let mut sums = vec![Vec3::ZERO; vertices.len()];
    for corners in triangles {
        let [a, b, c] = corners.map(|corner| vertices[corner as usize]);
        let area = (b - a).cross(c - a);
        corners.iter().for_each(|&corner| sums[corner as usize] += area);
    }
    let outward = |vertex: &Vec3| crate::math::unit(vertex.with_z(0.0)).unwrap_or(Vec3::Z);
    sums.iter().zip(vertices).map(|(&sum, vertex)| crate::math::unit(sum).unwrap_or_else(|| outward(vertex))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::forest::area::Form;
    use crate::forest::paint;
    use std::collections::HashMap;

    fn solid(form: Form) -> Solid {
        Solid::new(&Painted::new(paint::tree(form, 0)), 3)
    }

    /// Widest radius of a ring.
    fn radius(solid: &Solid, ring: usize) -> f64 {
        let corners = &solid.vertices[ring * AROUND..(ring + 1) * AROUND];
        corners.iter().map(|at| at.with_z(0.0).length()).fold(0.0, f64::max)
    }

    #[test]
    fn solids_have_the_outline_of_their_form() {
        let [cone, egg, umbrella, column, shrub] =
            [Form::Conifer, Form::Broadleaf, Form::Umbrella, Form::Column, Form::Shrub].map(solid);
        assert!(radius(&cone, 3) > 1.4 * radius(&cone, 9), "a conifer grows narrow");
        assert!(radius(&egg, 7) > 2.0 * radius(&egg, 1), "an oak has a stem");
        assert!(radius(&umbrella, 10) > 2.5 * radius(&umbrella, 4), "a stone pine is wide above");
        assert!(radius(&column, 2) < 0.3 * radius(&column, 8), "a eucalypt is bare below");
        assert!(radius(&shrub, 4) > 2.0 * radius(&egg, 2), "a shrub has leaves where an oak has a stem");
    }

    #[test]
    fn solids_are_closed_but_for_the_foot_and_their_triangles_look_outward() {
        for (name, form) in Form::ALL {
            let solid = solid(form);
            assert_eq!(solid.triangles.len(), TRIANGLES, "{name}");
            let mut sides: HashMap<[u32; 2], i32> = HashMap::new();
            for [a, b, c] in &solid.triangles {
                for [from, to] in [[a, b], [b, c], [c, a]] {
                    *sides.entry([*from.min(to), *from.max(to)]).or_default() += if from < to { 1 } else { -1 };
                }
            }
            let open: Vec<_> = sides.into_iter().filter(|(_, sum)| *sum != 0).collect();
            assert!(open.len() == AROUND && open.iter().all(|(side, _)| side[1] < AROUND as u32), "{name}: {open:?}");
            // The open foot lies in the plane of the origin and adds nothing.
            let volume = solid.triangles.iter().map(|corners| {
                let [a, b, c] = corners.map(|corner| solid.vertices[corner as usize]);
                a.dot(b.cross(c)) / 6.0
            });
            assert!(volume.sum::<f64>() > 0.02, "{name}");
            assert!(solid.normals.iter().all(|normal| (normal.length() - 1.0).abs() < 1e-12), "{name}");
        }
    }

    #[test]
    fn a_picture_of_nothing_makes_a_line_and_no_panic() {
        use crate::image::textures::{FirstRow, Texels};
        for size in [1_u32, 3] {
            let texels = vec![[9, 9, 9, 0]; (size * size) as usize];
            let solid = Solid::new(&Painted::new(Texels::new(size, size, texels, FirstRow::AtV0).expect("square")), 0);
            assert!(solid.vertices.iter().all(|at| at.is_finite()) && radius(&solid, 5) == 0.0);
        }
    }
}
