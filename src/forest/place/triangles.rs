//! Triangles: trees as the paper places them, triangle by triangle of the relief.
//!
//! Triangle -TRIANGLES-> rectangle on its longest edge -> random places -> those inside
//!
//! Kept to compare: when the relief gets finer as the observer comes near, its triangles are others, and so are the trees. The default does not move them.
//!
//! Deliberately otherwise than printed: areas are those of the map's plane, because a hectare is (on slopes the paper has 1/cos too many); and the number of
//! places is floor(d A + xi) with xi from 0 to 1, because a plain floor leaves small triangles empty.
//!
//! Space: metres in the cell. Source: Falcão, Próspero dos Santos, figure of the rectangle P0, V0, V1.
//! Cost: two places a tree.

use super::{Site, Tree, planted};
use crate::forest::polygon::{Point, contains};
use crate::forest::random::{mix64, unit};
use crate::math::Vec3;

pub(super) fn grow(site: &mut Site, triangles: &[[Vec3; 3]]) {
    let is_here = planted(&site.states, |_| true);
    let keys: Vec<u64> = (0..site.states.len()).map(|stand| site.key(stand)).collect();
    for (index, triangle) in triangles.iter().enumerate() {
        let Some(near) = squares_of(site, triangle) else { continue };
        for stand in near.into_iter().filter(|&stand| is_here[stand]) {
            grow_one(site, stand, mix64(keys[stand] ^ mix64(index as u64)), triangle);
        }
    }
}

/// Stands that a triangle may touch.
fn squares_of(site: &Site, triangle: &[Vec3; 3]) -> Option<Vec<usize>> {
    use crate::forest::land::SQUARES;
    if !triangle.iter().all(|corner| corner.is_finite()) {
        return None;
    }
    let square = |metres: f64| ((metres / site.head.side * SQUARES as f64) as usize).min(SQUARES - 1);
    let range = |axis: fn(&Vec3) -> f64| {
        let all = triangle.iter().map(axis);
        square(all.clone().fold(f64::INFINITY, f64::min))..square(all.fold(f64::NEG_INFINITY, f64::max)) + 1
    };
    let patches: Vec<usize> = site.land.patches_in(range(|corner| corner.x), range(|corner| corner.y)).collect();
    Some(site.stands_of(patches.into_iter()))
}

fn grow_one(site: &mut Site, stand: usize, key: u64, triangle: &[Vec3; 3]) {
    let Some(density) = site.states[stand].map(|state| state.density) else { return };
    // The longest edge first: the foot of the third corner is then between its ends, and the rectangle encloses the triangle.
    let plane = triangle.map(|corner| [corner.x, corner.y]);
    let length = |index: usize| square_length(plane[index], plane[(index + 1) % 3]);
    let longest = (0..3).max_by(|&a, &b| length(a).total_cmp(&length(b))).unwrap_or(0);
    let [p0, p1, p2] = [0, 1, 2].map(|step| plane[(longest + step) % 3]);
    let (v0, to_p2) = ([p1[0] - p0[0], p1[1] - p0[1]], [p2[0] - p0[0], p2[1] - p0[1]]);
    let square = v0[0] * v0[0] + v0[1] * v0[1];
    let foot = (to_p2[0] * v0[0] + to_p2[1] * v0[1]) / square;
    let v1 = [to_p2[0] - v0[0] * foot, to_p2[1] - v0[1] * foot];
    let hectares = (v0[0] * v1[1] - v0[1] * v1[0]).abs() / 1e4;
    let wanted = density * hectares + unit(key);
    if !wanted.is_finite() {
        return;
    }
    let side = site.head.side;
    let ground = |at: Point| height(triangle, at);
    for number in 0..wanted as u64 {
        let bits = mix64(key ^ mix64(number + 1));
        let [u, v] = [bits >> 32, bits & 0xFFFF_FFFF].map(|bits| bits as f64 / (1_u64 << 32) as f64);
        let at = [0, 1].map(|axis| p0[axis] + u * v0[axis] + v * v1[axis]);
        if at.iter().all(|metres| (0.0..side).contains(metres)) {
            let [x, y] = at.map(|metres| (metres / side * 65_536.0) as u16);
            // Where it stands after rounding is what counts: two triangles of an edge share no tree.
            if contains(&plane, &[], Tree { x, y, z: 0, kind: 0 }.at(side)) {
                site.plant_at(stand, [x, y], &ground);
            }
        }
    }
}

fn square_length(a: Point, b: Point) -> f64 {
    (b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1])
}

/// The height of a triangle's plane over a position.
fn height(triangle: &[Vec3; 3], at: Point) -> f64 {
    let normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
    let from = [at[0] - triangle[0].x, at[1] - triangle[0].y];
    triangle[0].z - (normal.x * from[0] + normal.y * from[1]) / normal.z
}
