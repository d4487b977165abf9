//! Relief: a grid of heights as few triangles, as exact as asked.
//!
//! Grid -[`Hierarchy`]-> bounds -mesh, budget, frontier-> [`ReliefMesh`] -scene-> Scene
//!
//! | File | What is in it |
//! |---|---|
//! | [`lattice`] | the binary hierarchy of right triangles, as arithmetic on points |
//! | [`scan`] | the samples under one triangle |
//! | [`hierarchy`] | a true bound of the error for every diamond |
//! | [`mesh`] | which triangles there are, cut at the border |
//! | [`fictitious`] | the paper's way around cracks: neighbors stay as they are |
//! | [`criterion`] | what is worth halving: error, error seen from the eye, the paper's three factors |
//! | [`borders`] | triangles that wear one cover each, and how wrong that may be |
//! | [`finer`] | a grid with samples between samples |
//! | [`frontier`] | the mesh that follows the observer: two queues |
//! | [`budget`] | the best mesh of so many triangles |
//! | [`progressive`] | a stream of halvings, of which any beginning is a relief |
//! | [`strip`] | one strip of triangles over the whole relief |
//! | [`quality`] | how far the mesh is from all samples |
//! | [`scene`] | vertices in metres, normals, colors by height |
//!
//! Space: lattice points until [`scene`], then metres. Source: M. Cifuentes, A. Corbellin, M. Rolón, G. Rodríguez, P. Lotito,
//! A. Clausse, "Remallado de Terrenos Multirresolución".

pub mod borders;
pub mod budget;
pub mod criterion;
pub mod fictitious;
pub mod finer;
pub mod frontier;
pub mod hierarchy;
pub mod lattice;
pub mod mesh;
pub mod progressive;
pub mod quality;
pub mod scan;
pub mod scene;
pub mod strip;

pub use hierarchy::Hierarchy;
pub use lattice::{Lattice, Point, Triangle};
pub use mesh::{Face, ReliefMesh, Vertex};
pub use quality::{Quality, quality};

#[cfg(test)]
mod tests {
    use crate::forest::elevation::{Frame, Grid, Unit};

    /// A grid of 30 m with the given heights.
    pub(super) fn grid(columns: usize, rows: usize, height: impl Fn(usize, usize) -> f32) -> Grid {
        let frame = Frame { unit: Unit::Metres, west: 0.0, north: 0.0, step: [30.0, 30.0] };
        let heights = (0..columns * rows).map(|at| height(at % columns, at / columns)).collect();
        Grid::new("made", (columns, rows), heights, frame).expect("2 x 2 at least")
    }

    /// Hills of whole metres, rough enough that every level has errors.
    pub(super) fn hills(columns: usize, rows: usize) -> Grid {
        grid(columns, rows, |x, y| {
            let rough = (x * 7919 + y * 104_729 + x * y * 31) % 23;
            (200.0 * (crate::math::sin(x as f64 / 9.0) + crate::math::cos(y as f64 / 7.0))).round() as f32
                + rough as f32
        })
    }

    /// Hills with two holes.
    pub(super) fn with_voids(columns: usize, rows: usize) -> Grid {
        let hills = hills(columns, rows);
        grid(columns, rows, |x, y| {
            let is_void = (5..12).contains(&x) && (8..14).contains(&y) || x + y > columns + rows - 9;
            if is_void { f32::NAN } else { hills.height(x, y) }
        })
    }
}
