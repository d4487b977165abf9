//! Heights: the ground below a point, straight from the samples.
//!
//! Cells -HEIGHTS-> metres below an observer, a mark, a waypoint
//!
//! Why from the samples and not from the relief that is drawn: a path must not change with the tolerance of the picture.
//! Between four samples the height is bilinear; on a mesh it is that of the triangle above the point.
//!
//! Space: world, metres. Cost: the last cells are kept, so a walk reads each of them once.

use super::area::{Cell, CellIndex, Ground};
use super::cells::Cells;
use super::pack::PackError;
use std::collections::VecDeque;

/// Cells that are kept: those around an observer at a corner, twice over.
const KEPT: usize = 8;

/// The ground of an area, asked point by point.
#[derive(Debug, Default)]
pub struct Heights {
    kept: VecDeque<(CellIndex, Option<Cell>)>,
}

impl Heights {
    /// The height of the ground of `cells` at a world position; `None` where there is no cell, a void, or no number.
    ///
    /// # Errors
    /// [`PackError`] where the cell cannot be loaded.
    pub fn at(&mut self, cells: &Cells, position: [f64; 2]) -> Result<Option<f64>, PackError> {
        if !position.iter().all(|number| number.is_finite()) {
            return Ok(None);
        }
        let head = cells.head();
        let corner = head.corner(head.cell_at(position));
        let (side, place) = (head.side, [position[0] - corner.x, position[1] - corner.y]);
        Ok(self.cell(cells, head.cell_at(position))?.and_then(|cell| height(&cell.ground, side, place)))
    }

    /// A cell, kept from before or loaded.
    ///
    /// # Errors
    /// [`PackError`] where it cannot be loaded.
    pub fn cell(&mut self, cells: &Cells, index: CellIndex) -> Result<Option<&Cell>, PackError> {
        match self.kept.iter().position(|kept| kept.0 == index) {
            Some(at) => self.kept.swap(0, at),
            None => {
                let cell = cells.load(index)?;
                self.kept.truncate(KEPT - 1);
                self.kept.push_front((index, cell));
            }
        }
        Ok(self.kept.front().and_then(|kept| kept.1.as_ref()))
    }
}

/// The height of a cell's ground at a place in the cell; `None` in a void and where no triangle is.
#[must_use]
pub fn height(ground: &Ground, side: f64, place: [f64; 2]) -> Option<f64> {
    let Ground::Lattice { size, .. } = ground else { return on_mesh(ground, place) };
    let steps = size.map(|count| f64::from(count.max(2)) - 1.0);
    // Rows are counted from the north.
    let along = [place[0] / side * steps[0], (1.0 - place[1] / side) * steps[1]];
    let first: [f64; 2] = std::array::from_fn(|axis| along[axis].floor().clamp(0.0, steps[axis] - 1.0));
    let [x, y]: [f64; 2] = std::array::from_fn(|axis| (along[axis] - first[axis]).clamp(0.0, 1.0));
    let sample = |column: f64, row: f64| ground.sample((first[0] + column) as usize, (first[1] + row) as usize);
    let mixed = |from: f64, to: f64, share: f64| if share == 0.0 { from } else { from + (to - from) * share };
    let row = |row: f64| {
        let (west, east) = (sample(0.0, row), if x == 0.0 { 0.0 } else { sample(1.0, row) });
        mixed(west, east, x)
    };
    let found = mixed(row(0.0), if y == 0.0 { 0.0 } else { row(1.0) }, y);
    found.is_finite().then_some(found)
}

/// The highest triangle of a mesh above or below a place.
fn on_mesh(ground: &Ground, place: [f64; 2]) -> Option<f64> {
    let Ground::Mesh { vertices, triangles } = ground else { return None };
    let mut found: Option<f64> = None;
    for (corners, _) in triangles {
        let corner = |number: usize| vertices.get(corners[number] as usize);
        let (Some(a), Some(b), Some(c)) = (corner(0), corner(1), corner(2)) else { continue };
        let area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        let (x, y) = (place[0] - a.x, place[1] - a.y);
        let (u, v) = ((x * (c.y - a.y) - y * (c.x - a.x)) / area, ((b.x - a.x) * y - (b.y - a.y) * x) / area);
        if u >= 0.0 && v >= 0.0 && u + v <= 1.0 {
            let height = a.z + u * (b.z - a.z) + v * (c.z - a.z);
            found = Some(found.map_or(height, |found| found.max(height)));
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Vec3;

    fn lattice(counts: Vec<i16>) -> Ground {
        Ground::Lattice { size: [3, 2], base: 100.0, step: 1.0, counts }
    }

    #[test]
    fn heights_are_those_of_the_samples_and_bilinear_between() {
        // North row 0 10 20, south row 4 14 24; columns 120 m apart, rows 240 m.
        let ground = lattice(vec![0, 10, 20, 4, 14, 24]);
        let at = |x: f64, y: f64| height(&ground, 240.0, [x, y]);
        assert_eq!([at(0.0, 240.0), at(240.0, 240.0), at(120.0, 0.0)], [Some(100.0), Some(120.0), Some(114.0)]);
        assert_eq!([at(60.0, 240.0), at(60.0, 120.0), at(240.0, 0.0)], [Some(105.0), Some(107.0), Some(124.0)]);
    }

    #[test]
    fn a_void_is_felt_only_where_it_counts() {
        let ground = lattice(vec![0, Ground::VOID, 20, 4, 14, 24]);
        let at = |x: f64, y: f64| height(&ground, 240.0, [x, y]);
        assert_eq!([at(0.0, 240.0), at(0.0, 120.0), at(60.0, 0.0)], [Some(100.0), Some(102.0), None]);
        assert_eq!(at(120.0, 240.0), None);
    }

    #[test]
    fn a_mesh_has_the_height_of_its_triangle() {
        let corners = [(0.0, 0.0, 5.0), (240.0, 0.0, 5.0), (0.0, 240.0, 29.0)];
        let vertices = corners.iter().map(|&(x, y, z)| Vec3::new(x, y, z)).collect();
        let ground = Ground::Mesh { vertices, triangles: vec![([0, 1, 2], None)] };
        assert_eq!(height(&ground, 240.0, [10.0, 100.0]), Some(15.0));
        assert_eq!(height(&ground, 240.0, [200.0, 200.0]), None);
    }
}
