//! Quality: how far a mesh is from *all* samples of its grid, counted afresh from its faces.
//!
//! Grid, ReliefMesh -QUALITY-> largest distance, RMSE, SSD
//!
//! Why afresh: the bounds of the hierarchy are what the mesh was made with; a report that repeats them proves nothing.
//! The paper's own measure is the sum of squared differences (SSD); it says nothing without the number of samples, and none of the
//! three says what the others do, so they are always told together.
//!
//! Units: metres. Cost: one visit of every sample.

use super::mesh::ReliefMesh;
use super::scan::{Plane, rows};
use crate::forest::elevation::Grid;

/// How far a mesh is from the samples.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize)]
pub struct Quality {
    /// Triangles of the mesh.
    pub triangles: usize,
    /// Corners of the mesh.
    pub vertices: usize,
    /// Triangles of the mesh in percent of two a cell of the grid.
    pub percent: f64,
    /// The largest distance of a sample, straight up or down.
    pub largest: f64,
    /// Root of the mean square.
    pub rmse: f64,
    /// Sum of squares (the paper's measure), in square metres.
    pub ssd: f64,
    /// Samples under the mesh.
    pub samples: usize,
    /// Samples with a height that lie under no face: beside voids.
    pub uncovered: usize,
}

/// Measures `mesh` against every sample of `grid`; a sample on an edge counts once, for the face that comes first.
#[must_use]
pub fn quality(grid: &Grid, mesh: &ReliefMesh) -> Quality {
    let limits = (grid.columns() as u32 - 1, grid.rows() as u32 - 1);
    let mut seen = vec![false; grid.heights().len()];
    let (mut largest, mut ssd, mut samples) = (0.0_f64, 0.0, 0);
    for face in &mesh.faces {
        let plane = Plane::new(&face.triangle, face.heights);
        rows(&face.triangle, limits, |y, first, last| {
            let start = y as usize * grid.columns();
            for x in first..=last {
                let at = start + x as usize;
                let distance = (f64::from(grid.heights()[at]) - plane.at(x, y)).abs();
                // Also where two faces of a mesh with cracks disagree.
                largest = largest.max(distance);
                if !seen[at] {
                    seen[at] = true;
                    samples += 1;
                    ssd += distance * distance;
                }
            }
        });
    }
    let known = grid.heights().len() - grid.voids();
    let all = 2.0 * (grid.columns() - 1) as f64 * (grid.rows() - 1) as f64;
    let (triangles, vertices) = (mesh.triangles(), mesh.vertices.len());
    Quality {
        triangles,
        vertices,
        percent: 100.0 * triangles as f64 / all,
        largest,
        rmse: if samples > 0 { (ssd / samples as f64).sqrt() } else { 0.0 },
        ssd,
        samples,
        uncovered: known - samples,
    }
}
