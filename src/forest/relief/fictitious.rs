//! Fictitious vertices: the paper's way to let a triangle be halved while its neighbor stays whole.
//!
//! Hierarchy, error -FICTITIOUS-> ReliefMesh without forced halving
//!
//! The middle of a hypotenuse is *selected* when both triangles of its diamond are halved: it has its real height. When only one is, it is
//! *fictitious*: its height is the mean of the ends, so that it lies on the edge of the neighbor that stayed whole. When none is, it is
//! *deselected*. Heights are settled from coarse to fine, because the ends may be fictitious themselves; no chain of neighbors is followed.
//!
//! What it costs: the error is no longer bounded (a triangle within the limit moves with its fictitious corners), and the edge of the whole
//! neighbor has a vertex in its middle that it does not know. On paper the vertex lies on the edge; on a grid of samples it is snapped to
//! a place beside it, and pinholes open. [`Seams::Stitched`] gives the vertex to both sides and closes them. The default relief does not
//! need either: see [`super::mesh`].
//!
//! Units: metres. Source: M. Cifuentes et al., "Remallado de Terrenos Multirresolución", section 3 and figure 4.

use super::hierarchy::Hierarchy;
use super::lattice::{Diamond, Field, Lattice, Point, Triangle};
use super::mesh::{Builder, ReliefMesh, Vertex, for_each_leaf};

/// What becomes of vertices in the middle of a neighbor's edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Seams {
    /// The neighbor does not know them: T-junctions, as in the paper.
    Open,
    /// They stand in the neighbor's outline, too.
    Stitched,
}

/// A mesh with fictitious vertices, and how many there are.
#[derive(Clone, Debug)]
pub struct Fictitious {
    /// The faces.
    pub mesh: ReliefMesh,
    /// Vertices with their real height, other than the corners of the square.
    pub selected: usize,
    /// Vertices on the edge of a neighbor that stayed whole.
    pub fictitious: usize,
    /// Triangles that are whole.
    pub leaves: usize,
    /// Edges with a vertex in their middle.
    pub junctions: usize,
}

/// Halves every triangle that `is_halved` names, whatever its neighbors do.
#[must_use]
pub fn fictitious(hierarchy: &Hierarchy<'_>, is_halved: impl Fn(&Triangle) -> bool, seams: Seams) -> Fictitious {
    let lattice = hierarchy.lattice;
    let halved = Halved::new(&lattice, is_halved);
    let Settled { heights, selected, fictitious } = settle(hierarchy, &halved);

    // What is whole becomes a face.
    let mut builder = Builder::new(hierarchy);
    let (mut leaves, mut junctions) = (0, 0);
    for_each_leaf(&lattice, &|triangle| halved.is_halved(&lattice, triangle), &mut |triangle| {
        let corners = [triangle.a, triangle.b, triangle.apex];
        let mut hanging = Vec::new();
        for (&from, &to) in crate::math::edges(&corners) {
            let before = hanging.len();
            hang(&halved.sides, (from, to), &heights, &mut hanging);
            junctions += usize::from(hanging.len() > before);
        }
        leaves += 1;
        if seams == Seams::Open {
            hanging.clear();
        }
        builder.add_outline(triangle, corners.map(|corner| heights.at(corner)), &hanging);
    });
    Fictitious { mesh: builder.mesh, selected, fictitious, leaves, junctions }
}

/// Heights of all vertices, and how many are in which state.
struct Settled {
    heights: Field<f64>,
    selected: usize,
    fictitious: usize,
}

/// Settles heights from coarse to fine: the ends of a hypotenuse before its middle.
fn settle(hierarchy: &Hierarchy<'_>, halved: &Halved) -> Settled {
    let lattice = hierarchy.lattice;
    let mut settled = Settled { heights: Field::new(&lattice, f64::NAN), selected: 0, fictitious: 0 };
    for root in lattice.roots() {
        [root.a, root.b, root.apex].iter().for_each(|&corner| settled.heights.set(corner, hierarchy.height(corner)));
    }
    for &middle in halved.order.iter().flatten() {
        let Some(Diamond { a, b, apexes }) = lattice.diamond(middle) else { continue };
        // A neighbor that is not there, or beyond the border, has no edge to keep to.
        let agrees = |side: usize| {
            let drawn = apexes[side].is_some_and(|apex| has_area(&lattice, &Triangle { a, b, apex }));
            !drawn || halved.sides.at(middle) & (1 << side) != 0
        };
        let height = if agrees(0) && agrees(1) {
            settled.selected += 1;
            hierarchy.height(middle)
        } else {
            settled.fictitious += 1;
            (settled.heights.at(a) + settled.heights.at(b)) / 2.0
        };
        settled.heights.set(middle, height);
    }
    settled
}

/// Halves what is farther than `error` metres from its samples, whatever its neighbors do.
#[must_use]
pub fn within(hierarchy: &Hierarchy<'_>, error: f64, seams: Seams) -> Fictitious {
    fictitious(hierarchy, |triangle| hierarchy.error(triangle) > error, seams)
}

/// Which triangles are halved.
struct Halved {
    /// Two bits a middle: the sides of its diamond.
    sides: Field<u8>,
    /// The middles, by depth.
    order: Vec<Vec<Point>>,
}

impl Halved {
    fn new(lattice: &Lattice, is_halved: impl Fn(&Triangle) -> bool) -> Halved {
        let mut halved = Halved { sides: Field::new(lattice, 0), order: Vec::new() };
        let mut stack: Vec<(Triangle, usize)> = lattice.roots().map(|root| (root, 0)).to_vec();
        while let Some((triangle, depth)) = stack.pop() {
            if !triangle.can_be_halved() || !has_area(lattice, &triangle) || !is_halved(&triangle) {
                continue;
            }
            let middle = triangle.middle();
            let before = halved.sides.at(middle);
            if before == 0 {
                halved.order.resize(halved.order.len().max(depth + 1), Vec::new());
                halved.order[depth].push(middle);
            }
            halved.sides.set(middle, before | side(lattice, &triangle));
            stack.extend(triangle.halves().map(|half| (half, depth + 1)));
        }
        halved
    }

    fn is_halved(&self, lattice: &Lattice, triangle: &Triangle) -> bool {
        self.sides.at(triangle.middle()) & side(lattice, triangle) != 0
    }
}

/// The bit of a triangle in its diamond.
fn side(lattice: &Lattice, triangle: &Triangle) -> u8 {
    let first = lattice.diamond(triangle.middle()).and_then(|diamond| diamond.apexes[0]);
    if first == Some(triangle.apex) { 1 } else { 2 }
}

/// Whether some of the triangle lies within the grid, not only an edge.
fn has_area(lattice: &Lattice, triangle: &Triangle) -> bool {
    let corners = [triangle.a, triangle.b, triangle.apex];
    corners.iter().any(|corner| corner.x < lattice.east) && corners.iter().any(|corner| corner.y < lattice.south)
}

/// Collects the vertices on the edge of a whole triangle, at any depth.
fn hang(sides: &Field<u8>, (from, to): (Point, Point), heights: &Field<f64>, found: &mut Vec<Vertex>) {
    if from.x.abs_diff(to.x).max(from.y.abs_diff(to.y)) < 2 {
        return;
    }
    let middle = from.middle(to);
    if sides.at(middle) != 0 {
        found.push(Vertex { point: middle, height: heights.at(middle) });
        hang(sides, (from, middle), heights, found);
        hang(sides, (middle, to), heights, found);
    }
}

#[cfg(test)]
mod tests {
    use super::super::mesh::edge_uses;
    use super::super::tests::{grid, hills};
    use super::super::{mesh, quality};
    use super::*;
    use crate::forest::elevation::Grid;

    /// Rough hills in one corner, gentle ones elsewhere: triangles of all sizes meet.
    fn mixed(columns: usize, rows: usize) -> Grid {
        let rough = hills(columns, rows);
        grid(columns, rows, |x, y| if x + y < 24 { rough.height(x, y) } else { (x * x) as f32 / 8.0 - y as f32 })
    }

    #[test]
    fn stitched_edges_have_two_sides_and_open_ones_do_not() {
        for grid in [mixed(33, 33), mixed(45, 30)] {
            let hierarchy = Hierarchy::new(&grid);
            let at_border = |mesh: &ReliefMesh, (from, to): (u32, u32)| {
                let [p, q] = [from, to].map(|index| mesh.vertices[index as usize].point);
                let (east, south) = (hierarchy.lattice.east, hierarchy.lattice.south);
                (p.x == q.x && (p.x == 0 || p.x == east)) || (p.y == q.y && (p.y == 0 || p.y == south))
            };
            let lonely = |mesh: &ReliefMesh| {
                edge_uses(mesh).iter().filter(|&(&edge, &uses)| uses != 2 && !at_border(mesh, edge)).count()
            };
            let stitched = within(&hierarchy, 14.0, Seams::Stitched);
            let open = within(&hierarchy, 14.0, Seams::Open);
            assert_eq!((lonely(&stitched.mesh), open.leaves), (0, stitched.leaves));
            assert!(lonely(&open.mesh) > 20 && open.junctions > 5 && open.fictitious > 5, "{}", open.junctions);
            let conforming = mesh::within(&hierarchy, 14.0);
            assert_eq!(lonely(&conforming), 0);
            assert!(open.mesh.triangles() < conforming.triangles());
            assert!(quality(&grid, &conforming).largest <= 14.0 && quality(&grid, &open.mesh).largest > 14.0);
        }
    }

    #[test]
    fn nothing_to_halve_and_everything_to_halve_have_no_fictitious_vertices() {
        let grid = hills(17, 17);
        let hierarchy = Hierarchy::new(&grid);
        let none = fictitious(&hierarchy, |_| false, Seams::Open);
        assert_eq!((none.leaves, none.selected, none.fictitious), (2, 0, 0));
        let all = fictitious(&hierarchy, |_| true, Seams::Open);
        assert_eq!((all.leaves, all.selected, all.fictitious), (2 * 16 * 16, 17 * 17 - 4, 0));
        assert_eq!(quality(&grid, &all.mesh).ssd, 0.0);
    }
}
