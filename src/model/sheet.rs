//! Sheet: where the polygons of one shape go, turned inside out where asked.
//!
//! shape -> SHEET -> Mesh
//!
//! Shapes describe their outside; a sheet keeps them from having to know which side is asked for. Cells of curved nets
//! come through [`Sheet::cell`], which drops corners that coincide and cuts what is not planar: every later stage may
//! then rely on planes.
//!
//! Space: the shape's local space. Cost: a dozen operations a cell.

use crate::math::Vec3;
use crate::scene::{Mesh, NormalSource, Polygon};

/// A quad counts as planar when its diagonals pass each other at no more than this part of the longer one.
///
/// Why this number: the rounding of a cell's corners is 1e-16 of their coordinates, so cells down to a millionth of them are
/// not cut for noise; and a quad that fills a picture of 4,000 pixels is out of its plane by 4e-6 pixels at most, a
/// thousandth of the 1/256 pixel to which vertices are snapped.
pub const PLANAR: f64 = 1e-9;

/// Where the polygons of one shape go.
pub(super) struct Sheet<'a> {
    pub mesh: &'a mut Mesh,
    pub inside: bool,
    /// Of the shape in its file.
    pub line: u32,
    /// Cells that were cut in two because they are not planar.
    pub nonplanar: u64,
}

impl Sheet<'_> {
    /// Adds a vertex; `normal` points outward and is unit, or zero where the shape has none there.
    pub fn vertex(&mut self, position: Vec3, normal: Vec3) -> u32 {
        self.mesh.push_vertex_with_normal(position, if self.inside { -normal } else { normal })
    }

    /// Adds a vertex of flat faces only.
    pub fn corner(&mut self, position: Vec3) -> u32 {
        self.mesh.push_vertex(position)
    }

    /// Adds a piece of a curved face, counterclockwise seen from outside.
    pub fn facet(&mut self, outline: impl IntoIterator<Item = u32>) {
        self.push(outline, NormalSource::Given);
    }

    /// Adds a flat face with hard edges, counterclockwise seen from outside.
    pub fn flat(&mut self, outline: impl IntoIterator<Item = u32>) {
        self.push(outline, NormalSource::Facet);
    }

    /// Adds a cell of a curved net, counterclockwise seen from outside: a quad, the two triangles of a quad that is not planar,
    /// one triangle where two corners coincide, nothing where more do.
    pub fn cell(&mut self, corners: [u32; 4]) {
        let at = |index: u32| self.mesh.vertices[index as usize];
        let differs = |&step: &usize| at(corners[step]) != at(corners[(step + 3) % 4]);
        let mut outline = [0; 4];
        let mut count = 0;
        for step in (0..4).filter(differs) {
            outline[count] = corners[step];
            count += 1;
        }
        if count == 3 {
            self.facet(outline.into_iter().take(3));
        } else if count == 4 {
            self.quad(corners);
        }
    }

    fn quad(&mut self, corners: [u32; 4]) {
        let [a, b, c, d] = corners;
        let [at_a, at_b, at_c, at_d] = corners.map(|index| self.mesh.vertices[index as usize]);
        let (first, second) = (at_c - at_a, at_d - at_b);
        if is_planar(first, second, at_b - at_a) {
            return self.facet(corners);
        }
        self.nonplanar += 1;
        // The shorter diagonal makes the rounder triangles. Both halves keep the quad's order of corners.
        let halves = if first.length_squared() <= second.length_squared() {
            [[a, b, c], [a, c, d]]
        } else {
            [[a, b, d], [b, c, d]]
        };
        halves.into_iter().for_each(|triangle| self.facet(triangle));
    }

    fn push(&mut self, outline: impl IntoIterator<Item = u32>, normals: NormalSource) {
        let start = self.mesh.outlines.len();
        self.mesh.outlines.extend(outline);
        if self.inside {
            // The first vertex stays the first: flat shading takes its light from there.
            self.mesh.outlines[start + 1..].reverse();
        }
        let count = (self.mesh.outlines.len() - start) as u32;
        self.mesh.polygons.push(Polygon { start: start as u32, count, line: self.line, normals });
    }
}

/// Whether a quad with these diagonals lies in a plane; `between` leads from the first diagonal's start to the second's.
fn is_planar(first: Vec3, second: Vec3, between: Vec3) -> bool {
    // The common perpendicular of the diagonals; where it is zero they are parallel and lie in a plane.
    let normal = first.cross(second);
    let longer = first.length_squared().max(second.length_squared()).sqrt();
    normal.dot(between).abs() <= PLANAR * longer * normal.length()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// How many corners the polygons have, and how many cells were cut, of a unit cell whose third corner is raised.
    fn cells(third: Vec3) -> (Vec<u32>, u64) {
        let mut mesh = Mesh::default();
        let mut sheet = Sheet { mesh: &mut mesh, inside: false, line: 1, nonplanar: 0 };
        let corners = [Vec3::ZERO, Vec3::X, third, Vec3::Y].map(|corner| sheet.vertex(corner, Vec3::Z));
        sheet.cell(corners);
        let nonplanar = sheet.nonplanar;
        (mesh.polygons.iter().map(|polygon| polygon.count).collect(), nonplanar)
    }

    #[test]
    fn what_is_not_planar_is_cut_once() {
        assert_eq!(cells(Vec3::new(1.0, 1.0, 0.0)), (vec![4], 0));
        assert_eq!(cells(Vec3::new(1.0, 1.0, 1e-10)), (vec![4], 0));
        assert_eq!(cells(Vec3::new(1.0, 1.0, 1e-8)), (vec![3, 3], 1));
        assert_eq!(cells(Vec3::X), (vec![3], 0));
    }

    #[test]
    fn the_cut_is_the_shorter_diagonal_and_keeps_the_first_corner() {
        for (third, expected) in
            [(Vec3::new(0.6, 0.6, 0.2), [0, 1, 2, 0, 2, 3]), (Vec3::new(1.5, 1.5, 0.2), [0, 1, 3, 1, 2, 3])]
        {
            let mut mesh = Mesh::default();
            let mut sheet = Sheet { mesh: &mut mesh, inside: false, line: 1, nonplanar: 0 };
            let corners = [Vec3::ZERO, Vec3::X, third, Vec3::Y].map(|corner| sheet.vertex(corner, Vec3::Z));
            sheet.cell(corners);
            assert_eq!(mesh.outlines, expected);
        }
    }
}
