//! What is hard in a draw list, counted sample by sample: coverage by `half_planes`, depths compared one by one. No
//! rasterizer is asked.

use super::half_planes::{Point, Ties, outline_spans, side};
use farop::color::Rgb;
use farop::screen::DrawList;
use std::collections::BTreeSet;

/// Counts over one list, or summed over many.
#[derive(Clone, Copy, Debug, Default)]
pub struct Census {
    /// Polygons.
    pub polygons: u64,
    /// Polygons with an inward corner.
    pub concave: u64,
    /// Pairs of polygons that share an edge.
    pub touching_pairs: u64,
    /// Samples that two or more polygons cover.
    pub crowded_samples: u64,
    /// Pairs of polygons that change their order between two neighboring samples.
    pub piercing_pairs: u64,
    /// Samples where the nearest depth is that of two polygons or more.
    pub exact_ties: u64,
    /// Samples with a transparent polygon in front of everything opaque.
    pub transparent_samples: u64,
}

/// A polygon at a sample: index and depth.
type Layer = (u32, f64);

/// Counts one list.
pub fn census(list: &DrawList) -> Census {
    let mut census = Census { polygons: list.len() as u64, ..Census::default() };
    let outlines: Vec<Vec<Point>> = (0..list.len()).map(|index| outline(list, index)).collect();
    census.concave = outlines.iter().filter(|outline| is_concave(outline)).count() as u64;
    census.touching_pairs = touching_pairs(&outlines);
    let layers = layers(list, &outlines);
    for at in &layers {
        count_sample(list, at, &mut census);
    }
    census.piercing_pairs = piercing_pairs(&layers, list.width as usize);
    census
}

impl std::ops::AddAssign for Census {
    fn add_assign(&mut self, other: Census) {
        self.polygons += other.polygons;
        self.concave += other.concave;
        self.touching_pairs += other.touching_pairs;
        self.crowded_samples += other.crowded_samples;
        self.piercing_pairs += other.piercing_pairs;
        self.exact_ties += other.exact_ties;
        self.transparent_samples += other.transparent_samples;
    }
}

/// Corners in half grid steps.
fn outline(list: &DrawList, index: usize) -> Vec<Point> {
    let scale = f64::from(2_u32 << list.grid.bits);
    list.polygon(index).vertices().iter().map(|vertex| ((vertex.x * scale) as i64, (vertex.y * scale) as i64)).collect()
}

fn is_concave(outline: &[Point]) -> bool {
    let count = outline.len();
    let turns = (0..count).map(|i| side(outline[i], outline[(i + 1) % count], outline[(i + 2) % count]).signum());
    let (left, right) = turns.fold((false, false), |seen, turn| (seen.0 || turn < 0, seen.1 || turn > 0));
    left && right
}

fn touching_pairs(outlines: &[Vec<Point>]) -> u64 {
    let edges = |outline: &[Point]| -> BTreeSet<(Point, Point)> {
        let edge = |i: usize| (outline[i], outline[(i + 1) % outline.len()]);
        (0..outline.len()).map(edge).map(|(a, b)| (a.min(b), a.max(b))).collect()
    };
    let edges: Vec<_> = outlines.iter().map(|outline| edges(outline)).collect();
    let touches = |(i, j): (usize, usize)| edges[i] != edges[j] && !edges[i].is_disjoint(&edges[j]);
    (0..edges.len()).flat_map(|j| (0..j).map(move |i| (i, j))).filter(|&pair| touches(pair)).count() as u64
}

/// Every sample's polygons, row by row.
fn layers(list: &DrawList, outlines: &[Vec<Point>]) -> Vec<Vec<Layer>> {
    let (width, height) = (list.width as i32, list.height as i32);
    let mut layers = vec![Vec::new(); (width * height) as usize];
    for (index, outline) in outlines.iter().enumerate() {
        let polygon = list.polygon(index);
        for (y, columns) in outline_spans(outline, 1 << list.grid.bits, &mut Ties::default()) {
            for x in columns.filter(|&x| x < width && y < height) {
                layers[(y * width + x) as usize].push((index as u32, polygon.depth(x, y)));
            }
        }
    }
    layers
}

fn count_sample(list: &DrawList, layers: &[Layer], census: &mut Census) {
    let opaque = |layer: &&Layer| list.shader.opacity(&list.polygon(layer.0 as usize)) == Rgb::gray(1.0);
    census.crowded_samples += u64::from(layers.len() > 1);
    let nearest = layers.iter().map(|layer| layer.1).fold(0.0, f64::max);
    census.exact_ties += u64::from(layers.iter().filter(|layer| layer.1 == nearest).count() > 1);
    let wall = layers.iter().filter(opaque).map(|layer| layer.1).fold(0.0, f64::max);
    census.transparent_samples += u64::from(layers.iter().any(|layer| !opaque(&layer) && layer.1 > wall));
}

fn piercing_pairs(layers: &[Vec<Layer>], width: usize) -> u64 {
    let mut pairs = BTreeSet::new();
    for index in 0..layers.len() {
        let right = (index % width + 1 < width).then_some(index + 1);
        for neighbor in [right, Some(index + width)].into_iter().flatten().filter(|&next| next < layers.len()) {
            changed_order(&layers[index], &layers[neighbor], &mut pairs);
        }
    }
    pairs.len() as u64
}

/// Adds the pairs that are ordered one way at `here` and the other way at `there`, by more than rounding could do.
fn changed_order(here: &[Layer], there: &[Layer], pairs: &mut BTreeSet<(u32, u32)>) {
    let depth_there = |polygon: u32| there.iter().find(|layer| layer.0 == polygon).map(|layer| layer.1);
    let clear = |a: f64, b: f64| (a - b).abs() > 1e-5 * a.max(b);
    for (place, a) in here.iter().enumerate() {
        for b in &here[..place] {
            let (Some(a_there), Some(b_there)) = (depth_there(a.0), depth_there(b.0)) else { continue };
            if (a.1 > b.1) != (a_there > b_there) && clear(a.1, b.1) && clear(a_there, b_there) {
                pairs.insert((b.0, a.0));
            }
        }
    }
}
