//! Runs: values that go along edges first and then along scan lines, with a mistake on the way.
//!
//! Without one this is the plane of value / w, by another way. A row is crossed at its middle; the ends of its run get 1/w and
//! value / w from their edges by the share of the edge above, and a sample gets them from the ends by its share of the run.

use super::case::Face;
use super::values::Corners;
use crate::math::edges;

/// The ways along edges and along rows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RunRule {
    /// Along an edge.
    pub edge: EdgeShare,
    /// Along a row.
    pub row: RowShare,
    /// Values along edges are linear on the screen.
    pub affine_edges: bool,
    /// Values along rows are.
    pub affine_rows: bool,
    /// The quotient is by the right 1/w, whatever the shares.
    pub own_depth: bool,
}

impl RunRule {
    /// All right.
    pub const RIGHT: RunRule = RunRule {
        edge: EdgeShare::Middle,
        row: RowShare::Center,
        affine_edges: false,
        affine_rows: false,
        own_depth: false,
    };
}

/// How far down an edge a row is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum EdgeShare {
    /// At the middle of the row.
    Middle,
    /// This much below the upper side of the row, inside the edge.
    Row(f64),
    /// The same, and outside where that leads.
    RowUnlimited(f64),
    /// Measured from the lower end.
    Turned,
    /// This share everywhere.
    Fixed(f64),
    /// Rounded to 0 or 1.
    Rounded,
    /// In whole rows from the first one of the edge, of as many as there are and this.
    Whole(f64),
    /// Of a height that is this much too large.
    Longer(f64),
}

/// How far along a row a sample is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RowShare {
    /// At its center.
    Center,
    /// This much right of its left side, inside the run.
    Left(f64),
    /// The same, and outside where that leads.
    LeftUnlimited(f64),
    /// In whole columns from the first one and this, of as many as there are and that.
    Whole(f64, f64),
    /// From whole column to whole column.
    Cut,
    /// Measured from the right end.
    Turned,
    /// This share everywhere.
    Fixed(f64),
    /// Of a width that is this much too large.
    Longer(f64),
}

/// Where a row meets an edge.
#[derive(Clone, Copy)]
struct End {
    x: f64,
    inverse_w: f64,
    over_w: [f64; 3],
}

/// Values at a point that is in the face.
pub(super) fn values(face: &Face, corners: &Corners, rule: RunRule, at: (f64, f64)) -> [f64; 3] {
    let Some((inverse_w, over_w)) = followed(face, corners, rule, at) else { return face.values_at(at) };
    let inverse_w = if rule.own_depth { face.inverse_w_at(at) } else { inverse_w };
    over_w.map(|value| value / inverse_w)
}

/// 1/w at a point that is in the face.
pub(super) fn depth(face: &Face, rule: RunRule, at: (f64, f64)) -> f64 {
    let inverse_w = [0, 1, 2].map(|corner| face.inverse_w_at(face.corners[corner]));
    let corners = Corners { values: [[0.0; 3]; 3], inverse_w, is_flat: true };
    followed(face, &corners, rule, at).map_or_else(|| face.inverse_w_at(at), |(inverse_w, _)| inverse_w)
}

/// 1/w and value / w; none where the row crosses no two edges of a triangle.
fn followed(face: &Face, corners: &Corners, rule: RunRule, at: (f64, f64)) -> Option<(f64, [f64; 3])> {
    if face.corners.len() != 3 {
        return None;
    }
    let points = [0, 1, 2].map(|corner: usize| (face.corners[corner], corner));
    let mut ends = edges(&points).filter_map(|(&a, &b)| end(corners, rule, (a, b), at.1));
    let (mut left, mut right) = (ends.next()?, ends.next()?);
    if left.x > right.x {
        std::mem::swap(&mut left, &mut right);
    }
    let share = along(rule.row, at.0, left.x, right.x);
    let between = |a: f64, b: f64| a + share * (b - a);
    let inverse_w = between(left.inverse_w, right.inverse_w);
    let over = |end: &End, number: usize| end.over_w[number];
    let over_w = [0, 1, 2].map(|number| {
        if rule.affine_rows {
            let value = |end: &End| over(end, number) / end.inverse_w;
            return between(value(&left), value(&right)) * inverse_w;
        }
        between(over(&left, number), over(&right, number))
    });
    Some((inverse_w, over_w))
}

type Corner = ((f64, f64), usize);

fn end(corners: &Corners, rule: RunRule, (a, b): (Corner, Corner), y: f64) -> Option<End> {
    let (((ax, ay), upper), ((bx, by), lower)) = if a.0.1 <= b.0.1 { (a, b) } else { (b, a) };
    if !(ay <= y && y < by) {
        return None;
    }
    let share = down(rule.edge, y, ay, by);
    let between = |a: f64, b: f64| a + share * (b - a);
    let inverse_w = between(corners.inverse_w[upper], corners.inverse_w[lower]);
    let over_w = [0, 1, 2].map(|number| {
        let value = |corner: usize| corners.values[corner][number];
        if rule.affine_edges {
            return between(value(upper), value(lower)) * inverse_w;
        }
        between(value(upper) * corners.inverse_w[upper], value(lower) * corners.inverse_w[lower])
    });
    Some(End { x: ax + (y - ay) * (bx - ax) / (by - ay), inverse_w, over_w })
}

fn down(rule: EdgeShare, y: f64, top: f64, bottom: f64) -> f64 {
    let (row, height) = (y.floor(), bottom - top);
    let first = (top - 0.5).ceil();
    match rule {
        EdgeShare::Middle => (y - top) / height,
        EdgeShare::Row(part) => ((row + part - top) / height).clamp(0.0, 1.0),
        EdgeShare::RowUnlimited(part) => (row + part - top) / height,
        EdgeShare::Turned => 1.0 - (y - top) / height,
        EdgeShare::Fixed(share) => share,
        EdgeShare::Rounded => ((y - top) / height).round(),
        EdgeShare::Whole(more) => (row - first) / ((bottom - 0.5).ceil() - first + more).max(1.0),
        EdgeShare::Longer(more) => (y - top) / (height + more).max(0.25),
    }
}

fn along(rule: RowShare, x: f64, left: f64, right: f64) -> f64 {
    let (column, width) = (x.floor(), right - left);
    let (first, end) = ((left - 0.5).ceil(), (right - 0.5).ceil());
    match rule {
        RowShare::Center => (x - left) / width,
        RowShare::Left(part) => ((column + part - left) / width).clamp(0.0, 1.0),
        RowShare::LeftUnlimited(part) => (column + part - left) / width,
        RowShare::Whole(more, longer) => (column - first + more) / (end - first + longer).max(1.0),
        RowShare::Cut => (column - left.floor()) / (right.floor() - left.floor()).max(1.0),
        RowShare::Turned => 1.0 - (x - left) / width,
        RowShare::Fixed(share) => share,
        RowShare::Longer(more) => (x - left) / (width + more).max(0.25),
    }
}
