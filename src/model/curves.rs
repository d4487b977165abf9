//! Curves: cubic Bezier curves turned about the z axis, as on a lathe.
//!
//! Cells of a curve in a plane through the axis are trapezoids and planar; those of a curve that leaves such a plane are
//! twisted and cut ([`Sheet::cell`]).
//!
//! Normals: around the axis the surface runs along e = (-u_y, u_x, 0), u the direction away from the axis; along the curve it
//! runs along the tangent T. The front is e x T: to the right of a curve that runs upward. It needs no distance
//! from the axis and so holds at the axis too; there each segment has a vertex of its own, as at the tip of a cone.
//!
//! Source: J. Yngvesson and I. Wallin, "SIPP User's Guide", Linkoping University. Cost: six mixes a row, a turn a vertex.

use super::bezier::{At, Cut, cut};
use super::turn::turn;
use super::weld::Weld;
use super::{Detail, Sheet};
use crate::math::{Vec3, unit};
use crate::scene::CurveNet;

/// Adds all curves of `net`: for (n, m) segments, n rows of 4m cells each. Curves with a control point that is not finite are left out.
pub(super) fn curves(net: &CurveNet, detail: Detail, sheet: &mut Sheet<'_>) {
    let [rows, quarter] = detail.of_net(4 * net.curves.len());
    let mut weld = Weld::default();
    for curve in &net.curves {
        let controls = curve.map(|index| net.vertices[index as usize]);
        if !controls.iter().all(|point| point.is_finite()) {
            continue;
        }
        let mut row = |i: u32, sheet: &mut Sheet<'_>| {
            // Neighbors begin where this one ends.
            let at_end = i == 0 || i == rows;
            Row::new(&cut(&controls, At::step(i, rows)), 4 * quarter, at_end.then_some(&mut weld), sheet)
        };
        let mut below = row(0, sheet);
        for i in 1..=rows {
            let above = row(i, sheet);
            below.cells(&above, sheet);
            below = above;
        }
    }
}

/// A ring of vertices.
struct Row {
    vertices: Vec<u32>,
    /// All of them are one point of the axis.
    pole: bool,
}

impl Row {
    fn new(here: &Cut, columns: u32, mut weld: Option<&mut Weld>, sheet: &mut Sheet<'_>) -> Row {
        let (point, normal) = (here.point(), normal(here));
        let pole = point.x == 0.0 && point.y == 0.0;
        let mut vertex = |column: u32| {
            // At a pole a segment's normal stands at its middle.
            let (c, s) = if pole { turn(2 * column + 1, 2 * columns) } else { turn(column, columns) };
            let turned = |v: Vec3| Vec3::new(v.x * c - v.y * s, v.x * s + v.y * c, v.z);
            let (position, normal) = (if pole { point } else { turned(point) }, turned(normal));
            match &mut weld {
                Some(weld) => weld.vertex(position, normal, sheet),
                None => sheet.vertex(position, normal),
            }
        };
        Row { vertices: (0..columns).map(&mut vertex).collect(), pole }
    }

    /// Adds the cells between this row and the one `above` it, which is further along the curve.
    fn cells(&self, above: &Row, sheet: &mut Sheet<'_>) {
        let columns = self.vertices.len();
        for i in 0..columns {
            let next = (i + 1) % columns;
            let (low, low_next) = (self.vertices[i], self.vertices[next]);
            let (high, high_next) = (above.vertices[i], above.vertices[next]);
            match (self.pole, above.pole) {
                (false, false) => sheet.cell([low, low_next, high_next, high]),
                (true, false) => sheet.cell([low, low, high_next, high]),
                (false, true) => sheet.cell([low, low_next, high, high]),
                (true, true) => (),
            }
        }
    }
}

/// The unit normal where the curve is cut, before it is turned; zero where it runs around the axis only.
fn normal(here: &Cut) -> Vec3 {
    let tangent = here.tangent();
    // On the axis, away from it is where the curve comes from or goes to.
    let ways = here.right.iter().chain(here.left.iter().rev());
    let away = ways.filter_map(|point| unit(point.with_z(0.0))).next().unwrap_or(Vec3::X);
    unit(Vec3::new(-away.y, away.x, 0.0).cross(tangent)).unwrap_or(Vec3::ZERO)
}
