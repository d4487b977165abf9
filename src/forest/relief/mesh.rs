//! Mesh: the relief as polygons over lattice points.
//!
//! set of halved diamonds -MESH-> faces -> quality, strip, Scene
//!
//! A face is a triangle of the hierarchy, cut at the border of the grid. Its edges run along rows, columns and diagonals, so a cut point is a
//! lattice point, and its height is interpolated over a power of two: neighbors compute the same bits, and no crack opens.
//!
//! Space: lattice points, heights in metres. Source: I. Sutherland, G. Hodgman, "Reentrant Polygon Clipping", CACM 17(1), 1974.
//! Cost: one visit of every triangle of the mesh and of those above.

use super::hierarchy::Hierarchy;
use super::lattice::{Lattice, Point, Triangle};
use std::collections::HashMap;

/// A corner of faces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vertex {
    /// Where it is.
    pub point: Point,
    /// Metres.
    pub height: f64,
}

/// A polygon of the mesh, and the plane it lies in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Face {
    /// Where its outline starts in [`ReliefMesh::outlines`].
    pub start: u32,
    /// Corners.
    pub count: u32,
    /// The triangle it is a part of.
    pub triangle: Triangle,
    /// Heights of the triangle's corners `a`, `b` and `apex`, in metres.
    pub heights: [f64; 3],
}

/// The relief: faces over shared vertices.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ReliefMesh {
    /// Corners, each once.
    pub vertices: Vec<Vertex>,
    /// Outlines of all faces, one behind the other, as indices into `vertices`; counterclockwise seen from above.
    pub outlines: Vec<u32>,
    /// The faces, along the Sierpinski curve.
    pub faces: Vec<Face>,
}

impl ReliefMesh {
    /// The outline of a face.
    #[must_use]
    pub fn outline(&self, face: &Face) -> &[u32] {
        &self.outlines[face.start as usize..(face.start + face.count) as usize]
    }

    /// How many triangles the faces are.
    #[must_use]
    pub fn triangles(&self) -> usize {
        self.faces.iter().map(|face| face.count as usize - 2).sum()
    }
}

/// The mesh in which exactly the diamonds are halved that `is_halved` names.
///
/// Without cracks only if a diamond is never halved before both of its parents are. Faces over voids are left out.
#[must_use]
pub fn mesh(hierarchy: &Hierarchy<'_>, is_halved: impl Fn(Point) -> bool) -> ReliefMesh {
    let mut builder = Builder::new(hierarchy);
    for_each_leaf(&hierarchy.lattice, &|triangle| is_halved(triangle.middle()), &mut |triangle| {
        builder.add(triangle, hierarchy.corners(triangle));
    });
    builder.mesh
}

/// The mesh that is nowhere farther than `error` metres from the samples.
#[must_use]
pub fn within(hierarchy: &Hierarchy<'_>, error: f64) -> ReliefMesh {
    mesh(hierarchy, |middle| f64::from(hierarchy.bound(middle)) > error)
}

/// Calls `visit` for every triangle that is not halved, along the Sierpinski curve.
pub fn for_each_leaf(lattice: &Lattice, is_halved: &impl Fn(&Triangle) -> bool, visit: &mut impl FnMut(&Triangle)) {
    fn descend(triangle: &Triangle, is_halved: &impl Fn(&Triangle) -> bool, visit: &mut impl FnMut(&Triangle)) {
        // At most 2 log2(side) deep, whatever the heights are.
        if triangle.can_be_halved() && is_halved(triangle) {
            triangle.halves().iter().for_each(|half| descend(half, is_halved, visit));
        } else {
            visit(triangle);
        }
    }
    lattice.roots().iter().for_each(|root| descend(root, is_halved, visit));
}

/// Collects faces over shared vertices.
pub struct Builder<'a, 'b> {
    hierarchy: &'a Hierarchy<'b>,
    /// Index + 1 of the vertex at each sample; 0: none yet.
    index: Vec<u32>,
    /// Of cut points too: they are samples. What is beyond the grid never gets here.
    pub mesh: ReliefMesh,
}

impl<'a, 'b> Builder<'a, 'b> {
    /// No faces yet.
    #[must_use]
    pub fn new(hierarchy: &'a Hierarchy<'b>) -> Builder<'a, 'b> {
        Builder { hierarchy, index: vec![0; hierarchy.grid.heights().len()], mesh: ReliefMesh::default() }
    }

    /// Adds a triangle with the given heights of its corners, cut at the border of the grid; nothing where a sample under it is a void.
    pub fn add(&mut self, triangle: &Triangle, heights: [f64; 3]) {
        self.add_outline(triangle, heights, &[]);
    }

    /// As [`Builder::add`]; `more` are further points on its edges, each with its height.
    pub fn add_outline(&mut self, triangle: &Triangle, heights: [f64; 3], more: &[Vertex]) {
        // A corner beyond the grid has the height of the nearest sample, which may be a void that the triangle does not cover.
        if heights.iter().any(|height| height.is_nan()) {
            return;
        }
        let lattice = self.hierarchy.lattice;
        let outline = clipped(&lattice, &with_points(triangle, heights, more));
        if outline.len() < 3 || (self.hierarchy.has_voids && self.covers_void(triangle)) {
            return;
        }
        let start = self.mesh.outlines.len() as u32;
        for vertex in &outline {
            let at = vertex.point.y as usize * self.hierarchy.grid.columns() + vertex.point.x as usize;
            if self.index[at] == 0 {
                self.mesh.vertices.push(*vertex);
                self.index[at] = self.mesh.vertices.len() as u32;
            }
            self.mesh.outlines.push(self.index[at] - 1);
        }
        self.mesh.faces.push(Face { start, count: outline.len() as u32, triangle: *triangle, heights });
    }

    fn covers_void(&self, triangle: &Triangle) -> bool {
        let lattice = &self.hierarchy.lattice;
        let mut found = false;
        super::scan::rows(triangle, (lattice.east, lattice.south), |y, first, last| {
            let row = self.hierarchy.grid.row(y as usize);
            found |= row[first as usize..=last as usize].iter().any(|height| height.is_nan());
        });
        found
    }
}

/// The corners of a triangle with further points on its edges, counterclockwise seen from above.
fn with_points(triangle: &Triangle, heights: [f64; 3], more: &[Vertex]) -> Vec<Vertex> {
    let Triangle { a, b, apex } = *triangle;
    let [height_a, height_b, height_apex] = heights;
    let mut corners = [
        Vertex { point: a, height: height_a },
        Vertex { point: b, height: height_b },
        Vertex { point: apex, height: height_apex },
    ];
    // Rows count southward: what turns left in columns and rows turns right on the map.
    if turn(a, b, apex) > 0 {
        corners.swap(0, 1);
    }
    if more.is_empty() {
        return corners.to_vec();
    }
    let mut outline = Vec::with_capacity(3 + more.len());
    for (&from, &to) in crate::math::edges(&corners) {
        let distance = |vertex: &Vertex| {
            let point = vertex.point;
            from.point.x.abs_diff(point.x).max(from.point.y.abs_diff(point.y))
        };
        let on_edge = |vertex: &&Vertex| {
            let Vertex { point, .. } = **vertex;
            turn(from.point, to.point, point) == 0 && point != from.point && point != to.point
        };
        let mut between: Vec<Vertex> = more.iter().filter(on_edge).copied().collect();
        between.sort_by_key(distance);
        outline.push(from);
        outline.extend(between);
    }
    outline
}

/// How many triangles the part of a triangle within the grid is.
#[must_use]
pub fn pieces(lattice: &Lattice, triangle: &Triangle) -> usize {
    let corners = [triangle.a, triangle.b, triangle.apex];
    if corners.iter().all(|corner| corner.x <= lattice.east && corner.y <= lattice.south) {
        return 1;
    }
    clipped(lattice, &corners.map(|point| Vertex { point, height: 0.0 })).len().saturating_sub(2)
}

pub(in crate::forest) fn turn(p: Point, q: Point, r: Point) -> i64 {
    let side = |a: u32, b: u32| i64::from(a) - i64::from(b);
    side(q.x, p.x) * side(r.y, p.y) - side(q.y, p.y) * side(r.x, p.x)
}

/// The part of an outline within the grid; nothing where that has no area.
pub(in crate::forest) fn clipped(lattice: &Lattice, outline: &[Vertex]) -> Vec<Vertex> {
    let beyond_east = |vertex: &Vertex| i64::from(vertex.point.x) - i64::from(lattice.east);
    let beyond_south = |vertex: &Vertex| i64::from(vertex.point.y) - i64::from(lattice.south);
    let mut part = outline.to_vec();
    for beyond in [&beyond_east as &dyn Fn(&Vertex) -> i64, &beyond_south] {
        if part.iter().all(|vertex| beyond(vertex) <= 0) {
            continue;
        }
        if part.iter().all(|vertex| beyond(vertex) >= 0) {
            return Vec::new();
        }
        let mut kept = Vec::with_capacity(part.len() + 1);
        for (from, to) in crate::math::edges(&part) {
            if beyond(from) <= 0 {
                kept.push(*from);
            }
            if beyond(from).signum() * beyond(to).signum() < 0 {
                kept.push(cut(from, to, beyond(from), beyond(to)));
            }
        }
        part = kept;
    }
    part
}

/// The point of an edge where `beyond` is 0. The length of an edge is a power of two: the share, and so the height, is exact.
fn cut(from: &Vertex, to: &Vertex, at_from: i64, at_to: i64) -> Vertex {
    let along = |a: u32, b: u32| {
        let step = (i64::from(b) - i64::from(a)).signum() * at_from.abs();
        (i64::from(a) + step) as u32
    };
    let share = at_from as f64 / (at_from - at_to) as f64;
    let point = Point { x: along(from.point.x, to.point.x), y: along(from.point.y, to.point.y) };
    Vertex { point, height: from.height + (to.height - from.height) * share }
}

/// How many faces use every edge, as pairs of indices of vertices, the smaller first.
#[must_use]
pub fn edge_uses(mesh: &ReliefMesh) -> HashMap<(u32, u32), u32> {
    let mut uses = HashMap::new();
    for face in &mesh.faces {
        for (&from, &to) in crate::math::edges(mesh.outline(face)) {
            *uses.entry((from.min(to), from.max(to))).or_default() += 1;
        }
    }
    uses
}

#[cfg(test)]
mod tests {
    use super::super::tests::{grid, hills};
    use super::*;

    #[test]
    fn no_face_hangs_on_a_void_beyond_the_border() {
        // The triangle (16, 16), (32, 0), (32, 16) covers samples from row 13 on; the sample nearest to its second corner is (19, 0).
        let hills = hills(20, 33);
        let grid = grid(20, 33, |x, y| if x > 16 && y < 6 { f32::NAN } else { hills.height(x, y) });
        let hierarchy = Hierarchy::new(&grid);
        for depth in 0..10 {
            let mesh = mesh(&hierarchy, |middle| super::super::lattice::level(middle) > depth);
            assert!(mesh.faces.iter().all(|face| face.heights.iter().all(|height| height.is_finite())), "{depth}");
            assert!(mesh.vertices.iter().all(|vertex| vertex.height.is_finite()), "{depth}");
        }
        assert!(within(&hierarchy, 5.0).faces.len() > 50);
    }

    #[test]
    fn cut_points_have_the_same_bits_on_both_sides() {
        for (columns, rows) in [(20, 13), (33, 18), (7, 40)] {
            let grid = hills(columns, rows);
            let hierarchy = Hierarchy::new(&grid);
            let mesh = within(&hierarchy, 60.0);
            // Every vertex is on the plane of every face that has it, exactly: heights are whole metres.
            for face in &mesh.faces {
                let plane = super::super::scan::Plane::new(&face.triangle, face.heights);
                for &at in mesh.outline(face) {
                    let Vertex { point, height } = mesh.vertices[at as usize];
                    assert_eq!(plane.at(point.x, point.y), height, "{point:?}");
                }
            }
        }
    }
}
