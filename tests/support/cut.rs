//! Polygons that the whole pipeline has cut at the sides of the picture and at hither and yon: their coverage, and that
//! neighbors along a cut edge leave no hole and draw nothing twice.

use super::half_planes::{Point, Span, side};
use super::random::Random;
use super::scenes::{camera, run, scene, surface, wide_mesh};
use super::tally::Tally;
use farop::plan::{Choices, Shading};
use farop::scene::Material;
use farop::screen::DrawList;

/// What was met.
#[derive(Default)]
pub struct CutTally {
    /// Spans against the half-planes.
    pub tally: Tally,
    /// Pictures.
    pub meshes: u64,
    /// Polygons that a plane cut.
    pub cut: u64,
    /// Polygons that snapping turned round: then the union is not compared.
    pub flipped: u64,
    /// Polygons of which culling, clipping or a number that is not finite left nothing, where something should be.
    pub lost: u64,
}

impl CutTally {
    /// Draws `meshes` meshes that cover the whole picture, or a band of rows between hither and yon.
    pub fn run(&mut self, random: &mut Random, bits: u32, meshes: u64) {
        for _ in 0..meshes {
            let side = 16 * 2.0_f64.powf(random.between(0.0, 6.0)) as u32;
            let quads = random.one_in(2);
            let cells = random.whole(2, 9) as usize;
            let band = random.one_in(2);
            let choices = Choices { shading: Shading::Flat, subpixel_bits: bits, ..Choices::default() };
            let mut view = camera(side, side);
            view.hither = 1e-3;
            // Tilted away from the eye about the horizontal axis, rows of the picture are lines of equal w.
            let tilt = if band { (0.0, random.between(0.2, 0.35)) } else { (random.between(-0.15, 0.15), 0.2) };
            let mut rows = (0.0, f64::from(side));
            if band {
                let (near, far) = (random.between(0.0, 0.9), random.between(-0.9, 0.0));
                view.hither = 1.0 / (1.0 + tilt.1 * near);
                view.yon = Some(1.0 / (1.0 + tilt.1 * far));
                rows = ((1.0 - near) * f64::from(side) / 2.0, (1.0 - far) * f64::from(side) / 2.0);
            }
            let mesh = wide_mesh(random, cells, tilt, quads);
            let (list, counts, _) = run(&scene(view, vec![surface(Material::default(), mesh)]), &choices);
            self.meshes += 1;
            self.cut += counts.cut;
            self.lost += counts.backfacing + counts.skipped;
            let rows = (list.grid.fixed(list.grid.snap(rows.0)), list.grid.fixed(list.grid.snap(rows.1)));
            self.compare(&list, rows);
        }
    }

    /// Compares every polygon of `list`, and all together with the rows between two heights (grid steps).
    fn compare(&mut self, list: &DrawList, rows: (i64, i64)) {
        let steps = list.grid.steps();
        let mut all: Vec<Span> = Vec::new();
        let mut turned = [0, 0];
        for polygon in list.polygons() {
            let corners = polygon.vertices().iter().map(|v| (list.grid.fixed(v.x), list.grid.fixed(v.y)));
            let corners: Vec<Point> = corners.collect();
            self.tally.outline(&corners, steps);
            all.append(self.tally.drawn());
            let area: i64 = (2..corners.len()).map(|i| side(corners[0], corners[i - 1], corners[i])).sum();
            turned[usize::from(area < 0)] += u64::from(area != 0);
        }
        let flipped = turned[0].min(turned[1]);
        self.flipped += flipped;
        if flipped == 0 {
            let right = i64::from(list.width) * steps;
            let outline = [(0, rows.0), (right, rows.0), (right, rows.1), (0, rows.1)];
            self.tally.union(all, &outline, steps);
        }
    }
}
