//! Owners: which polygon every sample shows, and whether it should.
//!
//! DrawList, rasterizer -OWNERS-> polygon of each sample; compared with rays, and with exact coverage
//!
//! Space: samples, row after row from the top.

use super::check::Random;
use crate::oracle::exact::{Rules, judge_rows};
use crate::oracle::ray::{Hit, Part, Tracer};
use crate::raster::{Frame, Rasterizer};
use crate::render::Canvas;
use crate::scene::Scene;
use crate::screen::DrawList;
use std::collections::BTreeMap;

/// Rows drawn at once are as many as have this many samples.
const SAMPLES_AT_ONCE: u32 = 1 << 22;
/// Samples that are compared with rays, at most.
const RAYS: u64 = 1 << 16;
/// Rows that are compared with exact coverage: so many bands, of so many samples together.
const BANDS: u32 = 4;
const EXACT_SAMPLES: u32 = 1 << 17;

/// The polygon that each sample of `list` shows.
#[must_use]
pub fn owners(list: &DrawList, rasterizer: &dyn Rasterizer, canvas: &Canvas) -> Vec<Option<u32>> {
    let mut all = Vec::with_capacity(list.width as usize * list.height as usize);
    let mut frame = Frame::default();
    let rows_at_once = (SAMPLES_AT_ONCE / list.width.max(1)).max(1);
    for first in (0..list.height).step_by(rows_at_once as usize) {
        let rows = first..(first + rows_at_once).min(list.height);
        let samples = rows.len() * list.width as usize;
        let target = frame.target((list.width, list.height), rows, canvas.background, canvas.transparency);
        let mut target = target.with_threads(canvas.threads);
        rasterizer.draw(list, &mut target);
        target.finish();
        all.extend((0..samples).map(|index| frame.sample(index).0));
    }
    all
}

/// Of a million samples at edges, those whose owner is not the one that the exact oracle finds with nothing snapped.
///
/// A sample is at an edge when the exact owner right of it or below it is another. Disputed depths do not count. `None`
/// where no edge was met.
#[must_use]
pub fn wrong_coverage(list: &DrawList, drawn: &[Option<u32>]) -> Option<f64> {
    let (mut edges, mut wrong) = (0_u64, 0_u64);
    let width = list.width as usize;
    for rows in bands(list) {
        let exact = judge_rows(list, &Rules::UNSNAPPED, rows.clone());
        let height = rows.len();
        let owner = |x: usize, y: usize| exact.owner[y * width + x];
        for (y, x) in (0..height).flat_map(|y| (0..width).map(move |x| (y, x))) {
            let here = owner(x, y);
            edges +=
                u64::from((x + 1 < width && owner(x + 1, y) != here) || (y + 1 < height && owner(x, y + 1) != here));
            let shown = drawn[(rows.start as usize + y) * width + x];
            wrong += u64::from(shown != here && !exact.disputed[y * width + x]);
        }
    }
    (edges > 0).then(|| wrong as f64 / edges as f64 * 1e6)
}

/// Bands of rows spread over the picture, or all of it.
fn bands(list: &DrawList) -> Vec<std::ops::Range<u32>> {
    let rows = (EXACT_SAMPLES / BANDS / list.width.max(1)).max(1);
    if rows * BANDS >= list.height {
        return std::iter::once(0..list.height).collect();
    }
    let first = |band: u32| (2 * band + 1) * list.height / (2 * BANDS) - rows / 2;
    (0..BANDS).map(|band| first(band)..first(band) + rows).collect()
}

/// The placed surfaces of a scene, as rays and lists number them.
pub struct Parts {
    /// Where the surfaces of an object instance begin in the list's numbering.
    of: BTreeMap<(u32, u32), u32>,
    /// Whether a surface lets light through, in the list's numbering.
    transparent: Vec<bool>,
}

impl Parts {
    /// Numbers the surfaces in the order of the tree.
    #[must_use]
    pub fn new(scene: &Scene) -> Parts {
        let mut parts = Parts { of: BTreeMap::new(), transparent: Vec::new() };
        let mut instance = 0;
        // A plan has walked the same tree within its budget.
        let _ = scene.walk(|placed| {
            for &id in &placed.object.surfaces {
                parts.of.insert((instance, id.0), parts.transparent.len() as u32);
                parts.transparent.push(!scene.surface(id).material.is_opaque());
            }
            instance += 1;
        });
        parts
    }

    /// Samples in a million that show another part than the one a ray meets first.
    ///
    /// Samples where a ray meets something transparent first are left out: there several layers show. `None` where
    /// nothing is left. The ray goes through the sample's own place, so that only what is visible counts, not antialiasing.
    #[must_use]
    pub fn wrong_visible(
        &self,
        tracer: &Tracer<'_>,
        list: &DrawList,
        drawn: &[Option<u32>],
        samples: u32,
    ) -> Option<f64> {
        let count = drawn.len() as u64;
        let mut random = Random::new(count);
        let (mut judged, mut wrong) = (0_u64, 0_u64);
        for turn in 0..count.min(RAYS) {
            let index = if count <= RAYS { turn } else { random.below(count) };
            let center = |at: u64| (at as f64 + 0.5) / f64::from(samples);
            let width = u64::from(list.width);
            let met = tracer.hit(center(index % width), center(index / width));
            let right = met.as_ref().map(|hit| self.part(hit));
            if right.is_some_and(|(surface, ..)| self.transparent[surface as usize]) {
                continue;
            }
            let shown = drawn[index as usize].map(|polygon| {
                let record = &list.polygons[polygon as usize];
                (record.surface, record.source.tessellated, record.source.number)
            });
            judged += 1;
            wrong += u64::from(shown != right);
        }
        (judged > 0).then(|| wrong as f64 / judged as f64 * 1e6)
    }

    /// Surface, whether it is a shape, number within the surface.
    fn part(&self, hit: &Hit) -> (u32, bool, u32) {
        let surface = self.of[&(hit.instance, hit.surface.0)];
        match hit.part {
            Part::Polygon(number) => (surface, false, number),
            Part::Primitive(number) => (surface, true, number),
        }
    }
}
