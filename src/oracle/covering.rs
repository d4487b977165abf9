//! Covering: which samples a polygon covers, by the signs of edge functions and a ray straight up.
//!
//! The tie rule says that a center on a left or an upper edge belongs to the polygon. That is the even-odd rule for the
//! point a hair right of the center and a hair of that hair below it, and such a point never lies on an edge. So: count the
//! edges above that point, column by column. The rasterizers go row by row and divide; nothing is divided here.
//!
//! Snapped corners are whole numbers of half grid steps, edge functions fit `i128`. Raw corners stay homogeneous,
//! (x w, y w, w) with w > 0: then x/w < px is x < px w, and the edge function is the determinant of the two corners and
//! (px, py, 1). Its sign is taken from `f64` where the rounding error is provably smaller, else from exact numbers.
//!
//! Source: Olano and Greer, "Triangle Scan Conversion using 2D Homogeneous Coordinates", Graphics Hardware 1997, for the
//! determinant; Edelsbrunner and Muecke, "Simulation of Simplicity", ACM Transactions on Graphics 9(1), 1990, for the hair.
//! Cost: a sign an edge and sample, of the edges that pass the sample's column.

use super::Vertices;
use super::number::Exact;
use crate::math::Vec3;
use crate::screen::ScreenPolygon;
use std::cmp::Ordering;
use std::ops::Range;

/// A polygon made ready to be asked.
pub(super) struct Outline {
    corners: Corners,
    columns: Range<i32>,
    rows: Range<i32>,
}

/// Corners in the arithmetic they are exact in.
enum Corners {
    /// Half grid steps: centers are whole numbers, too, sample i is at (2 i + 1) steps.
    Whole { points: Vec<(i64, i64)>, steps: i64 },
    /// (x w, y w, w), w > 0.
    Homogeneous(Vec<Vec3>),
}

/// What one sample is to one polygon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Standing {
    /// Covered.
    pub inside: bool,
    /// Its center lies exactly on the outline: the tie rule decided.
    pub on_outline: bool,
}

/// The edges that meet one column, the left corner first.
pub(super) struct Column<'a> {
    outline: &'a Outline,
    x: i32,
    edges: Vec<(usize, usize)>,
    /// Edges that end here or are vertical: they can be met, but are not crossed a hair to the right.
    touching: Vec<(usize, usize)>,
}

impl Outline {
    /// The outline of `polygon` within a picture of `size` samples; `None` where a raw corner has no place on the screen
    /// (w not above 0, or not finite).
    pub fn new(polygon: &ScreenPolygon<'_>, vertices: Vertices, size: (u32, u32)) -> Option<Outline> {
        let steps = polygon.grid().steps();
        let whole = |value: f64| (value * (2 * steps) as f64) as i64;
        let corners = polygon.vertices().iter();
        let raw = vertices == Vertices::Raw;
        if raw && !corners.clone().all(|corner| corner.homogeneous.is_finite() && corner.homogeneous.z > 0.0) {
            return None;
        }
        let place = |axis: usize| {
            let at = corners.clone().map(move |corner| match (raw, axis) {
                (true, _) => corner.homogeneous[axis] / corner.homogeneous.z,
                (false, 0) => corner.x,
                (false, _) => corner.y,
            });
            at.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| (low.min(at), high.max(at)))
        };
        let reach = |axis: usize, end: u32| {
            let (low, high) = place(axis);
            // One sample more than can be met; casts of floats saturate.
            let start = (low.floor() as i32).saturating_sub(1).max(0);
            start..(high.ceil() as i32).saturating_add(1).min(end as i32)
        };
        let (columns, rows) = (reach(0, size.0), reach(1, size.1));
        let corners = if raw {
            Corners::Homogeneous(corners.map(|corner| corner.homogeneous).collect())
        } else {
            Corners::Whole { points: corners.map(|corner| (whole(corner.x), whole(corner.y))).collect(), steps }
        };
        Some(Outline { corners, columns, rows })
    }

    /// The columns it can cover anything in.
    pub fn columns(&self) -> Range<i32> {
        self.columns.clone()
    }

    /// The rows it can cover anything in.
    pub fn rows(&self) -> Range<i32> {
        self.rows.clone()
    }

    /// Its edges as far as they concern column `x`.
    pub fn column(&self, x: i32) -> Column<'_> {
        let count = self.corners.count();
        let past: Vec<Ordering> = (0..count).map(|corner| self.corners.beside(corner, x)).collect();
        let (mut edges, mut touching) = (Vec::new(), Vec::new());
        for from in 0..count {
            let to = (from + 1) % count;
            // Of a vertical edge, or one beside the column, any order will do.
            let (left, right) = if past[from] <= past[to] { (from, to) } else { (to, from) };
            if past[left].is_le() && past[right].is_gt() {
                edges.push((left, right));
            } else if past[left].is_le() && past[right].is_ge() {
                touching.push((left, right));
            }
        }
        Column { outline: self, x, edges, touching }
    }
}

impl Column<'_> {
    /// What the sample in row `y` is to the polygon.
    pub fn standing(&self, y: i32) -> Standing {
        let corners = &self.outline.corners;
        let mut standing = Standing { inside: false, on_outline: false };
        for &(left, right) in &self.edges {
            let side = corners.side(left, right, (self.x, y));
            // On the edge: the hair to the right leaves the point below an edge that rises there. One that falls leaves
            // it above. Along a horizontal edge, the smaller hair puts it below.
            standing.inside ^= match side {
                Ordering::Equal => corners.below(right, y).is_le(),
                side => side.is_gt(),
            };
            standing.on_outline |= side.is_eq();
        }
        standing.on_outline |= self.touching.iter().any(|&(from, to)| {
            let reached = |corner: usize| corners.below(corner, y);
            let between = reached(from).is_le() && reached(to).is_ge() || reached(from).is_ge() && reached(to).is_le();
            corners.side(from, to, (self.x, y)).is_eq() && between
        });
        standing
    }
}

impl Corners {
    fn count(&self) -> usize {
        match self {
            Corners::Whole { points, .. } => points.len(),
            Corners::Homogeneous(points) => points.len(),
        }
    }

    /// Whether a corner is left of (`Less`), on or right of the centers of column `x`.
    fn beside(&self, corner: usize, x: i32) -> Ordering {
        match self {
            Corners::Whole { points, steps } => points[corner].0.cmp(&((2 * i64::from(x) + 1) * steps)),
            Corners::Homogeneous(points) => sign_of_offset(points[corner].x, points[corner].z, center(x)),
        }
    }

    /// Whether a corner is above (`Less`), at or below the centers of row `y`.
    fn below(&self, corner: usize, y: i32) -> Ordering {
        match self {
            Corners::Whole { points, steps } => points[corner].1.cmp(&((2 * i64::from(y) + 1) * steps)),
            Corners::Homogeneous(points) => sign_of_offset(points[corner].y, points[corner].z, center(y)),
        }
    }

    /// Whether a sample lies above (`Less`), on or below the line from `left` to `right`.
    fn side(&self, left: usize, right: usize, (x, y): (i32, i32)) -> Ordering {
        match self {
            Corners::Whole { points, steps } => {
                let at = |sample: i32| (2 * i64::from(sample) + 1) * steps;
                let (a, b) = (points[left], points[right]);
                let product = |p: i64, q: i64| i128::from(p) * i128::from(q);
                product(b.0 - a.0, at(y) - a.1).cmp(&product(b.1 - a.1, at(x) - a.0))
            }
            Corners::Homogeneous(points) => sign_of_determinant(points[left], points[right], (center(x), center(y))),
        }
    }
}

fn center(sample: i32) -> f64 {
    f64::from(sample) + 0.5
}

/// The sign of `scaled - at * w`.
fn sign_of_offset(scaled: f64, w: f64, at: f64) -> Ordering {
    let product = at * w;
    let offset = scaled - product;
    // One rounding of the product, one of the difference; far from underflow.
    if offset.abs() > f64::EPSILON * product.abs() && product.abs() > 1e-280 && offset.is_finite() {
        return offset.total_cmp(&0.0);
    }
    exact_offset(scaled, w, at).map_or(Ordering::Equal, |offset| offset.sign())
}

fn exact_offset(scaled: f64, w: f64, at: f64) -> Option<Exact> {
    Some(&Exact::new(scaled)? - &(&Exact::new(at)? * &Exact::new(w)?))
}

/// The sign of the determinant with the rows `a`, `b` and (px, py, 1).
pub(super) fn sign_of_determinant(a: Vec3, b: Vec3, (px, py): (f64, f64)) -> Ordering {
    // Columns 1 and 2 minus px and py times column 3: a determinant of two rows is left.
    let (ax, ay, bx, by) = (a.x - px * a.z, a.y - py * a.z, b.x - px * b.z, b.y - py * b.z);
    let determinant = ax * by - ay * bx;
    let size = |scaled: f64, at: f64, w: f64| scaled.abs() + (at * w).abs();
    let sizes = [size(a.x, px, a.z), size(b.y, py, b.z), size(a.y, py, a.z), size(b.x, px, b.z)];
    // Each entry is off by 2 u of its size, each product by 5 u, the difference by one more; u is EPSILON / 2.
    let error = 4.0 * f64::EPSILON * (sizes[0] * sizes[1] + sizes[2] * sizes[3]);
    let tame = sizes.iter().all(|size| (1e-140..1e140).contains(size));
    if tame && determinant.abs() > error {
        return determinant.total_cmp(&0.0);
    }
    exact_determinant(a, b, (px, py)).map_or(Ordering::Equal, |determinant| determinant.sign())
}

fn exact_determinant(a: Vec3, b: Vec3, (px, py): (f64, f64)) -> Option<Exact> {
    let ax_by = &exact_offset(a.x, a.z, px)? * &exact_offset(b.y, b.z, py)?;
    let ay_bx = &exact_offset(a.y, a.z, py)? * &exact_offset(b.x, b.z, px)?;
    Some(&ax_by - &ay_bx)
}
