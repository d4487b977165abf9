//! Patches: bicubic Bezier patches over nets of 4 x 4 control points.
//!
//! u runs along a row of the net and v across rows. The front is where du x dv points: with u to the right and v upward, towards the viewer.
//!
//! Where a row shrinks to a point, or derivatives are parallel, du x dv is zero and the surface may still be smooth. The
//! normal is then taken a millionth of the way to the patch's middle: right to a millionth, and still ten digits above rounding.
//!
//! Source: E. Catmull, "A Subdivision Algorithm for Computer Display of Curved Surfaces", University of Utah, 1974; SIPP's
//! `bezier_patches`. Cost: 36 mixes a vertex.

use super::bezier::{At, cut};
use super::weld::Weld;
use super::{Detail, Sheet};
use crate::math::{Vec3, unit};
use crate::scene::PatchNet;

/// Products of derivatives below this part of the net's size, squared, are taken for zero.
const NO_AREA: f64 = 1e-10;
/// How far towards the middle a normal is looked for.
const INWARD: f64 = 1.0 / (1u32 << 20) as f64;

/// Adds all patches of `net`: for n segments, n x n cells each. Patches with a control point that is not finite are left out.
pub(super) fn patches(net: &PatchNet, detail: Detail, sheet: &mut Sheet<'_>) {
    // The same number both ways: a neighbor may run its u along our v.
    let [n, _] = detail.of_net(net.patches.len());
    let mut weld = Weld::default();
    let mut grid = Vec::new();
    for indices in &net.patches {
        let patch = Patch::new(indices.map(|index| net.vertices[index as usize]));
        if !patch.size.is_finite() {
            continue;
        }
        grid.clear();
        for (j, i) in (0..=n).flat_map(|j| (0..=n).map(move |i| (j, i))) {
            let (position, normal) = patch.vertex(At::step(i, n), At::step(j, n));
            let on_border = i == 0 || i == n || j == 0 || j == n;
            let vertex = if on_border { weld.vertex(position, normal, sheet) } else { sheet.vertex(position, normal) };
            grid.push(vertex);
        }
        let at = |i: u32, j: u32| grid[(j * (n + 1) + i) as usize];
        for (j, i) in (0..n).flat_map(|j| (0..n).map(move |i| (j, i))) {
            sheet.cell([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
        }
    }
}

struct Patch {
    rows: [[Vec3; 4]; 4],
    /// The largest distance of a control point from the first.
    size: f64,
}

impl Patch {
    fn new(controls: [Vec3; 16]) -> Patch {
        let rows = [0, 4, 8, 12].map(|start| [0, 1, 2, 3].map(|column| controls[start + column]));
        let distances = controls.iter().map(|&point| (point - controls[0]).length());
        // Also not finite where a control point is not a number.
        let size = distances.fold(0.0, |size: f64, distance| if distance <= size { size } else { distance });
        Patch { rows, size }
    }

    /// Point and unit normal; zero where even its neighborhood has none.
    fn vertex(&self, u: At, v: At) -> (Vec3, Vec3) {
        let (point, product) = self.point_and_product(u, v);
        if product.length() > NO_AREA * self.size * self.size {
            return (point, unit(product).unwrap_or(Vec3::ZERO));
        }
        let (_, product) = self.point_and_product(u.inward(INWARD), v.inward(INWARD));
        (point, unit(product).unwrap_or(Vec3::ZERO))
    }

    /// The point, and du x dv.
    fn point_and_product(&self, u: At, v: At) -> (Vec3, Vec3) {
        // Cut every row at u; the points make a curve in v, and so do the derivatives.
        let cuts = self.rows.map(|row| cut(&row, u));
        let across = cut(&cuts.map(|cut| cut.point()), v);
        let along = cut(&cuts.map(|cut| cut.derivative()), v).point();
        (across.point(), along.cross(across.derivative()))
    }
}
