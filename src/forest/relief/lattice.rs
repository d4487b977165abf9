//! Lattice: the binary hierarchy of right triangles over a grid, as arithmetic on points.
//!
//! Grid -> LATTICE -> hierarchy (errors), mesh, frontier
//!
//! A square of 2^k x 2^k cells, two root triangles, each halved again and again from its right angle to the middle of its hypotenuse.
//! The two triangles on both sides of one hypotenuse are a *diamond*; in a mesh without cracks both are halved or none. So a mesh is a
//! set of diamonds, and a diamond is its middle: one point of the lattice, from which everything else follows by arithmetic on its
//! bits. No tree is stored.
//!
//! The square is virtual: it reaches beyond the grid where that is no 2^k + 1 samples wide. Points out there have the height of the
//! nearest sample, their triangles no error of their own, and what is drawn is cut at the grid's border.
//!
//! The paper writes "2^k x 2^k"; halving needs 2^k + 1 vertices a side.
//!
//! Space: columns from the west, rows from the north.
//! Source: M. Cifuentes et al., "Remallado de Terrenos Multirresolución"; W. Evans, D. Kirkpatrick, G. Townsend, "Right-Triangulated
//! Irregular Networks", Algorithmica 30, 2001, 264-286.

use crate::forest::elevation::Grid;
use std::collections::HashMap;

/// A sample of the virtual square: column from the west, row from the north.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Point {
    /// Column.
    pub x: u32,
    /// Row.
    pub y: u32,
}

impl Point {
    /// The point halfway to `other`. Only for ends of edges that can be halved.
    #[must_use]
    #[inline]
    pub fn middle(self, other: Point) -> Point {
        Point { x: (self.x + other.x) / 2, y: (self.y + other.y) / 2 }
    }
}

/// A right triangle of the hierarchy: the ends of the hypotenuse, and the right angle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Triangle {
    /// One end of the hypotenuse.
    pub a: Point,
    /// The other.
    pub b: Point,
    /// The right angle.
    pub apex: Point,
}

impl Triangle {
    /// The middle of the hypotenuse: the name of its diamond.
    #[must_use]
    #[inline]
    pub fn middle(&self) -> Point {
        self.a.middle(self.b)
    }

    /// Its halves, in the order in which the Sierpinski curve passes them when it enters at `a` and leaves at `b`: every two
    /// triangles in a row share an edge. A half turns the other way round than the whole.
    #[must_use]
    #[inline]
    pub fn halves(&self) -> [Triangle; 2] {
        let middle = self.middle();
        [Triangle { a: self.a, b: self.apex, apex: middle }, Triangle { a: self.apex, b: self.b, apex: middle }]
    }

    /// Whether there are samples between its corners: the smallest has none.
    #[must_use]
    #[inline]
    pub fn can_be_halved(&self) -> bool {
        self.a.x.abs_diff(self.b.x).max(self.a.y.abs_diff(self.b.y)) > 1
    }
}

/// The two triangles of one hypotenuse.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Diamond {
    /// One end of the hypotenuse.
    pub a: Point,
    /// The other.
    pub b: Point,
    /// The right angles, which are the middles of the parents. At the border of the square one is missing.
    pub apexes: [Option<Point>; 2],
}

/// The virtual square over a grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Lattice {
    /// Cells a side: 2^k.
    pub side: u32,
    /// Last column of the grid.
    pub east: u32,
    /// Last row of the grid.
    pub south: u32,
}

impl Lattice {
    /// The smallest square of 2^k cells that holds `grid`.
    #[must_use]
    pub fn new(grid: &Grid) -> Lattice {
        let (east, south) = (grid.columns() as u32 - 1, grid.rows() as u32 - 1);
        Lattice { side: east.max(south).next_power_of_two(), east, south }
    }

    /// The two triangles that everything comes from, entered where the other one is left.
    #[must_use]
    pub fn roots(&self) -> [Triangle; 2] {
        let corner = |x, y| Point { x, y };
        let (low, high) = (corner(0, 0), corner(self.side, self.side));
        [
            Triangle { a: low, b: high, apex: corner(self.side, 0) },
            Triangle { a: high, b: low, apex: corner(0, self.side) },
        ]
    }

    /// Half the width of the box around the diamond of a middle: a power of two. The diamond reaches this far to every side.
    #[must_use]
    #[inline]
    pub fn reach(middle: Point) -> u32 {
        1 << (middle.x | middle.y).trailing_zeros().min(31)
    }

    /// The diamond of a middle; `None` for the corners of the square, which are in no hypotenuse's middle.
    #[must_use]
    #[inline]
    pub fn diamond(&self, middle: Point) -> Option<Diamond> {
        let Point { x, y } = middle;
        let s = Lattice::reach(middle);
        if s >= self.side {
            return None;
        }
        let at = |x: u32, y: u32| Point { x, y };
        let inside = |at: u32| at <= self.side;
        Some(match (x & s != 0, y & s != 0) {
            // The middle of a cell of 2 s: its diagonal runs the way that both of its ends are corners of the cell above.
            (true, true) => {
                let falls = (x ^ y) & (2 * s) == 0;
                let (a, b) = if falls { (y - s, y + s) } else { (y + s, y - s) };
                Diamond { a: at(x - s, a), b: at(x + s, b), apexes: [Some(at(x - s, b)), Some(at(x + s, a))] }
            }
            (true, false) => Diamond {
                a: at(x - s, y),
                b: at(x + s, y),
                apexes: [(y >= s).then(|| at(x, y.wrapping_sub(s))), inside(y + s).then(|| at(x, y + s))],
            },
            _ => Diamond {
                a: at(x, y - s),
                b: at(x, y + s),
                apexes: [(x >= s).then(|| at(x.wrapping_sub(s), y)), inside(x + s).then(|| at(x + s, y))],
            },
        })
    }

    /// The middles of the diamonds that can be halved once this one is: of its legs. None below the smallest.
    #[inline]
    pub fn children(&self, middle: Point) -> impl Iterator<Item = Point> + use<> {
        let s = Lattice::reach(middle);
        let is_cell = middle.x & s != 0 && middle.y & s != 0;
        let diamond = self.diamond(middle).filter(|_| is_cell || s > 1);
        diamond.into_iter().flat_map(|Diamond { a, b, apexes }| {
            apexes.into_iter().flatten().flat_map(move |apex| [a.middle(apex), b.middle(apex)])
        })
    }

    /// The diamonds that must be halved before this one: its right angles. Those beyond the grid do not matter and are left out.
    #[inline]
    pub fn parents(&self, middle: Point) -> impl Iterator<Item = Point> + use<> {
        let lattice = *self;
        let apexes = self.diamond(middle).into_iter().flat_map(|diamond| diamond.apexes.into_iter().flatten());
        apexes.filter(move |&apex| lattice.touches(apex) && lattice.diamond(apex).is_some())
    }

    /// The triangles of a diamond, those that lie in the square.
    #[inline]
    pub fn triangles(&self, middle: Point) -> impl Iterator<Item = Triangle> + use<> {
        let diamond = self.diamond(middle);
        diamond
            .into_iter()
            .flat_map(|Diamond { a, b, apexes }| apexes.into_iter().flatten().map(move |apex| Triangle { a, b, apex }))
    }

    /// Whether a part of the box around the diamond of `middle` lies in the grid or on its border.
    #[must_use]
    #[inline]
    pub fn touches(&self, middle: Point) -> bool {
        let s = Lattice::reach(middle);
        middle.x <= self.east + s && middle.y <= self.south + s
    }

    /// The sample nearest to a point: itself, or one of the grid's border.
    #[must_use]
    #[inline]
    pub fn nearest(&self, point: Point) -> Point {
        Point { x: point.x.min(self.east), y: point.y.min(self.south) }
    }

    /// Calls `visit` for the middle of every diamond that touches the grid: children before parents.
    pub fn from_the_smallest(&self, mut visit: impl FnMut(Point)) {
        let mut s = 1;
        while s < self.side {
            // First the diamonds on edges of cells of 2 s, then those in their middles.
            let (east, south) = ((self.east + s).min(self.side), (self.south + s).min(self.side));
            for y in (0..=south).step_by(s as usize) {
                let first = if (y / s) % 2 == 0 { s } else { 0 };
                for x in (first..=east).step_by(2 * s as usize) {
                    visit(Point { x, y });
                }
            }
            for y in (s..=south).step_by(2 * s as usize) {
                for x in (s..=east).step_by(2 * s as usize) {
                    visit(Point { x, y });
                }
            }
            s *= 2;
        }
    }
}

/// The level of a diamond, counted from the smallest: 2 log2 of its reach, and 1 more for the middle of a cell.
#[must_use]
pub fn level(middle: Point) -> usize {
    let s = Lattice::reach(middle);
    2 * s.trailing_zeros() as usize + usize::from(middle.x & s != 0 && middle.y & s != 0)
}

/// A value for every middle of a diamond: an array over the grid, and a table for the few middles beyond it.
#[derive(Clone, Debug)]
pub struct Field<T> {
    columns: usize,
    rows: usize,
    inside: Vec<T>,
    outside: HashMap<Point, T>,
    nothing: T,
}

impl<T: Copy> Field<T> {
    /// A field that is `nothing` everywhere.
    #[must_use]
    pub fn new(lattice: &Lattice, nothing: T) -> Field<T> {
        let (columns, rows) = (lattice.east as usize + 1, lattice.south as usize + 1);
        Field { columns, rows, inside: vec![nothing; columns * rows], outside: HashMap::new(), nothing }
    }

    /// The value at a point.
    #[must_use]
    #[inline]
    pub fn at(&self, point: Point) -> T {
        if (point.x as usize) < self.columns && (point.y as usize) < self.rows {
            return self.inside[point.y as usize * self.columns + point.x as usize];
        }
        self.outside.get(&point).copied().unwrap_or(self.nothing)
    }

    /// Replaces the value at a point.
    #[inline]
    pub fn set(&mut self, point: Point, value: T) {
        if (point.x as usize) < self.columns && (point.y as usize) < self.rows {
            self.inside[point.y as usize * self.columns + point.x as usize] = value;
        } else {
            self.outside.insert(point, value);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every triangle by halving from the roots, with its depth.
    fn all(lattice: &Lattice) -> Vec<Triangle> {
        let (mut found, mut stack) = (Vec::new(), lattice.roots().to_vec());
        while let Some(triangle) = stack.pop() {
            found.push(triangle);
            if triangle.can_be_halved() {
                stack.extend(triangle.halves());
            }
        }
        found
    }

    #[test]
    fn the_bits_of_a_middle_say_what_halving_makes() {
        let lattice = Lattice { side: 16, east: 16, south: 16 };
        let mut seen = std::collections::BTreeMap::<Point, Vec<Triangle>>::new();
        for triangle in all(&lattice).into_iter().filter(Triangle::can_be_halved) {
            seen.entry(triangle.middle()).or_default().push(triangle);
        }
        assert_eq!(seen.len(), 17 * 17 - 4, "every sample but the corners");
        for (middle, triangles) in seen {
            let diamond = lattice.diamond(middle).expect("it is one");
            let mut apexes: Vec<_> = triangles.iter().map(|triangle| triangle.apex).collect();
            let mut expected: Vec<_> = diamond.apexes.into_iter().flatten().collect();
            apexes.sort();
            expected.sort();
            assert_eq!(apexes, expected, "{middle:?}");
            assert!(triangles.iter().all(|t| [(t.a, t.b), (t.b, t.a)].contains(&(diamond.a, diamond.b))), "{middle:?}");
            let mut below: Vec<_> = triangles
                .iter()
                .flat_map(Triangle::halves)
                .filter(Triangle::can_be_halved)
                .map(|half| half.middle())
                .collect();
            let mut children: Vec<_> = lattice.children(middle).collect();
            below.sort();
            children.sort();
            assert_eq!(below, children, "{middle:?}");
        }
        for corner in [(0, 0), (16, 0), (0, 16), (16, 16)] {
            assert_eq!(lattice.diamond(Point { x: corner.0, y: corner.1 }), None);
        }
    }

    #[test]
    fn children_come_before_parents_and_all_come_once() {
        for (east, south) in [(16, 16), (11, 5), (1, 1), (2, 9), (1, 16)] {
            let side = u32::max(east, south).next_power_of_two();
            let lattice = Lattice { side, east, south };
            let mut order = Vec::new();
            lattice.from_the_smallest(|middle| order.push(middle));
            let place: HashMap<_, _> = order.iter().enumerate().map(|(at, &middle)| (middle, at)).collect();
            assert_eq!(place.len(), order.len(), "none twice");
            for (&middle, &at) in &place {
                let parents = lattice.diamond(middle).expect("a diamond").apexes.into_iter().flatten();
                let touching = parents.filter(|&parent| lattice.diamond(parent).is_some() && lattice.touches(parent));
                touching.for_each(|parent| assert!(place[&parent] > at, "{parent:?} before {middle:?}"));
            }
            let inside = order.iter().filter(|middle| middle.x <= east && middle.y <= south).count() as u32;
            let corners = [(0, 0), (side, 0), (0, side), (side, side)];
            let corners = corners.iter().filter(|corner| corner.0 <= east && corner.1 <= south).count() as u32;
            assert_eq!(inside, (east + 1) * (south + 1) - corners, "{east} {south}");
        }
    }
}
