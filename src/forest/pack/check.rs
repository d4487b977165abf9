//! Check: what a cell must keep, whoever made it.
//!
//! Cell -CHECK-> Cell whose every index points at something
//!
//! Why on both ways: what is written was made by a program, what is read by anybody; whoever takes a cell out of a pack need not look again.

use crate::forest::area::{Cell, Ground, Head, MOST_DENSITY, Owner, SMALLEST, Spread, Stand};

/// What is wrong with `cell`.
pub(super) fn check(head: &Head, cell: &Cell) -> Result<(), String> {
    let has_cover = |cover: Option<u8>| cover.is_none_or(|cover| usize::from(cover) < head.covers.len());
    if !has_cover(cell.cover) {
        return Err("its ground has a cover that is not there".to_string());
    }
    ground(&cell.ground, has_cover)?;
    for stand in &cell.stands {
        check_stand(head, stand, has_cover)?;
    }
    for patch in &cell.patches {
        let exists = match patch.owner {
            Owner::Stand(stand) => (stand as usize) < cell.stands.len(),
            Owner::Cover(cover) => has_cover(Some(cover)),
        };
        if !exists {
            return Err("a patch belongs to nobody".to_string());
        }
        if std::iter::once(&patch.outer).chain(&patch.holes).any(|ring| ring.len() < 3) {
            return Err("a patch has an outline of less than 3 corners".to_string());
        }
    }
    if cell.trees.iter().any(|tree| usize::from(tree.species) >= head.species.len()) {
        return Err("a tree has a species that is not there".to_string());
    }
    if cell.trees.iter().any(|tree| !(tree.height >= SMALLEST && tree.crown >= SMALLEST)) {
        return Err("a tree has no height or no crown".to_string());
    }
    if cell.lines.iter().any(|line| line.points.len() < 2 || line.width.is_nan() || line.width < SMALLEST) {
        return Err("a line has less than 2 points, or no width".to_string());
    }
    Ok(())
}

fn ground(ground: &Ground, has_cover: impl Fn(Option<u8>) -> bool) -> Result<(), String> {
    match ground {
        Ground::Lattice { size, base, step, counts } => {
            let count = usize::from(size[0]) * usize::from(size[1]);
            if size[0] < 2 || size[1] < 2 || counts.len() != count {
                return Err(format!("{} heights make no lattice of {} x {}", counts.len(), size[0], size[1]));
            }
            let steps = *step > 0.0 && step.is_finite() && base.is_finite();
            if steps { Ok(()) } else { Err(format!("its heights count in {step} m from {base} m")) }
        }
        Ground::Mesh { vertices, triangles } => {
            let has = |corner: &u32| (*corner as usize) < vertices.len();
            if !triangles.iter().all(|(corners, cover)| corners.iter().all(has) && has_cover(*cover)) {
                return Err("a triangle has a corner or a cover that is not there".to_string());
            }
            if vertices.iter().all(|vertex| vertex.is_finite()) {
                Ok(())
            } else {
                Err("a corner is nowhere".to_string())
            }
        }
    }
}

fn check_stand(head: &Head, stand: &Stand, has_cover: impl Fn(Option<u8>) -> bool) -> Result<(), String> {
    let wrong = |what: &str| Err(format!("stand {} {what}", stand.number));
    let is_spread = |spread: Spread| spread.mean >= SMALLEST && spread.deviation >= 0.0;
    if stand.states.is_empty() {
        return wrong("is nothing");
    }
    for state in &stand.states {
        if usize::from(state.species) >= head.species.len() || !has_cover(state.cover) {
            return wrong("has a species or a cover that is not there");
        }
        if !is_spread(state.height) || !is_spread(state.crown) || !(0.0..=MOST_DENSITY).contains(&state.density) {
            return wrong("has trees without height, crown or a density that can be");
        }
    }
    Ok(())
}
