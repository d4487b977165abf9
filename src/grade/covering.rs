//! Covering: which faces lie over every sample of a case, under any of the rules.
//!
//! Faces, [`Rules`] -COVERING-> for every sample the faces over it, in list order
//!
//! What one polygon leaves behind for the next (a mask, a list of crossings, the ends of rows that nobody cleared) is decided here,
//! because it depends on all faces before. Cost: faces times samples, once a picture.

use super::case::Case;
use super::covered::Outline;
use super::rules::{Rules, Stencil};

/// The samples of every face.
pub(super) struct Covering {
    width: usize,
    /// Of every face that is drawn: its number, and its samples in rows from the top.
    faces: Vec<(usize, Vec<bool>)>,
}

impl Covering {
    pub fn of(case: &Case, rules: &Rules) -> Covering {
        let (width, count) = (case.width as usize, case.faces.len());
        let samples = width * case.height as usize;
        let mut faces = Vec::new();
        for (number, face) in case.faces.iter().enumerate().filter(|&(number, _)| rules.listed.has(number, count)) {
            let outline = Outline::new(&face.corners, rules, (case.width, case.height));
            let covers = |at: usize| {
                let sample = ((at % width) as i32, (at / width) as i32);
                outline.covers(if rules.block.of_cover { rules.block.of(face, sample) } else { sample }, rules)
            };
            faces.push((number, (0..samples).map(covers).collect()));
        }
        let mut covering = Covering { width, faces };
        covering.keep(case, rules.stencil);
        covering
    }

    /// Whether the samples of all faces are the contract's.
    pub fn is_of_contract(rules: &Rules) -> bool {
        let right = Rules::default();
        let Rules { shape, stencil, listed, bounds, winding, .. } = right;
        rules.fill == right.fill
            && (rules.cover_at, rules.corners, rules.ties) == (right.cover_at, right.corners, right.ties)
            && (rules.shape, rules.stencil, rules.listed) == (shape, stencil, listed)
            && (rules.bounds, rules.winding, rules.pieces) == (bounds, winding, right.pieces)
            && rules.least_area == right.least_area
            && (rules.dropped, rules.stepped) == (right.dropped, right.stepped)
            && !rules.block.of_cover
    }

    /// The faces over a sample, in list order.
    pub fn at(&self, (x, y): (i32, i32)) -> impl Iterator<Item = usize> + '_ {
        let at = y as usize * self.width + x as usize;
        self.faces.iter().filter(move |face| face.1[at]).map(|face| face.0)
    }

    /// Every face that is drawn with its samples, in list order.
    pub fn faces(&self) -> impl Iterator<Item = (usize, impl Iterator<Item = (i32, i32)> + '_)> + '_ {
        let place = move |at: usize| ((at % self.width) as i32, (at / self.width) as i32);
        self.faces.iter().map(move |(number, covered)| {
            (*number, covered.iter().enumerate().filter(|covered| *covered.1).map(move |(at, _)| place(at)))
        })
    }

    /// Leaves to every face what those before it did not clear.
    fn keep(&mut self, case: &Case, stencil: Stencil) {
        if stencil == Stencil::Cleared {
            return;
        }
        let mut old = vec![false; self.faces.first().map_or(0, |face| face.1.len())];
        for (number, covered) in &mut self.faces {
            let corners = &case.faces[*number].corners;
            let range = |pick: fn(&(f64, f64)) -> f64| {
                let (low, high) = corners
                    .iter()
                    .map(pick)
                    .fold((f64::INFINITY, 0.0_f64), |(low, high), at| (low.min(at), high.max(at)));
                low as usize..=high as usize
            };
            let (columns, rows) = (range(|corner| corner.0), range(|corner| corner.1));
            for (kept, own) in old.iter_mut().zip(covered.iter()) {
                *kept = if stencil == Stencil::Toggled { *kept != *own } else { *kept || *own };
            }
            if stencil == Stencil::Rows {
                fill_rows(&mut old, self.width);
            }
            let is_near = |at: usize| {
                rows.contains(&(at / self.width)) && (stencil == Stencil::Rows || columns.contains(&(at % self.width)))
            };
            *covered = (0..old.len()).map(|at| old[at] && is_near(at)).collect();
        }
    }
}

/// Fills every row from its first to its last sample.
fn fill_rows(covered: &mut [bool], width: usize) {
    for row in covered.chunks_mut(width) {
        if let (Some(first), Some(last)) = (row.iter().position(|&own| own), row.iter().rposition(|&own| own)) {
            row[first..=last].fill(true);
        }
    }
}
