//! Clip: questions to a student's clip, and what is right.
//!
//! What a clip must do is judged by what it *is*, not by a second clip: every corner of the answer lies in the volume and on the
//! polygon's plane, its area is the exact one ([`exact`]), and it covers the points that polygon and volume share ([`judge`]). The
//! clip in [`mutants`] only gives names to wrong answers.
//!
//! Space: homogeneous clip coordinates (x, y, w). Not asked: numbers that are not finite.

mod cases;
mod exact;
mod fits;
mod judge;
mod mutants;
mod names;

use super::{Exercise, Mistake, called};
use crate::geometry::clip::{ClipVertex, ClipVolume};
use crate::math::Vec3;
use crate::raster::functions::ClipFunction;
use crate::screen::EdgeKind;

/// Attributes a corner has in every question.
pub(super) const ATTRIBUTES: usize = 3;

/// What an answer is judged by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Asks {
    /// The polygon as it was, to the bit.
    Same,
    /// Its corners, area and what it covers.
    Shape,
    /// The same, and no corner twice.
    NoDoubles,
    /// The values at its corners.
    Attributes,
    /// Which of its edges clipping made.
    Marks,
    /// The neighbor beyond the first edge has the same points on it.
    Neighbor,
    /// The part behind a plane w = constant meets the part before it in the same points.
    OtherSide,
    /// Corners inside every plane by the last place.
    LastPlace,
}

/// One question.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Case {
    pub asks: Asks,
    /// Corners x, y, w in 64ths.
    pub corners: Vec<[i64; 3]>,
    /// Where the other polygon's third corner is; only of neighbors.
    pub apex: Option<[i64; 3]>,
    /// In 64ths.
    pub hither: i64,
    pub yon: Option<i64>,
}

/// What the function answers to a question: one polygon, or two where there are two to clip.
pub(super) type Answer = Result<Vec<Vec<ClipVertex>>, String>;

impl Case {
    pub(super) fn volume(&self) -> ClipVolume {
        ClipVolume { hither: units(self.hither), yon: self.yon.map(units) }
    }

    /// The polygons that are clipped, each by its volume.
    pub(super) fn inputs(&self) -> Vec<(Vec<ClipVertex>, ClipVolume)> {
        let vertices = |corners: &[[i64; 3]]| corners.iter().map(|&corner| vertex(corner)).collect::<Vec<_>>();
        let mut inputs = vec![(vertices(&self.corners), self.volume())];
        if let Some(apex) = self.apex {
            // The neighbor walks the first edge the other way.
            inputs.push((vertices(&[self.corners[1], self.corners[0], apex]), self.volume()));
        }
        if self.asks == Asks::OtherSide {
            let behind = ClipVolume { hither: units(self.yon.unwrap_or(self.hither)), yon: None };
            inputs.push((vertices(&self.corners), behind));
        }
        inputs
    }

    /// The largest coordinate.
    pub(super) fn size(&self) -> f64 {
        self.corners.iter().flatten().fold(1.0, |size: f64, &x| size.max(units(x).abs()))
    }
}

fn units(whole: i64) -> f64 {
    whole as f64 / 64.0
}

/// What the attributes are at a place: linear in space, and one of them constant.
pub(super) fn attributes_at(p: Vec3) -> [f64; ATTRIBUTES] {
    [p.x - 2.0 * p.y + 3.0 * p.z, p.y, 5.0]
}

fn vertex(corner: [i64; 3]) -> ClipVertex {
    let position = Vec3::from_array(corner.map(units));
    let mut vertex = ClipVertex { position, edge: EdgeKind::Original, ..ClipVertex::default() };
    vertex.attributes[..ATTRIBUTES].copy_from_slice(&attributes_at(position));
    vertex
}

/// A student's clip under examination.
pub(super) struct ClipExercise<'a> {
    clip: &'a ClipFunction,
    mutants: Vec<names::Known>,
}

impl<'a> ClipExercise<'a> {
    pub(super) fn new(clip: &'a ClipFunction) -> ClipExercise<'a> {
        ClipExercise { clip, mutants: names::all() }
    }
}

impl Exercise for ClipExercise<'_> {
    type Case = Case;
    type Answer = Answer;

    fn cases(&self, aspect: &str, seed: u64) -> Vec<Case> {
        cases::of(aspect, seed)
    }

    fn ask(&self, case: &Case) -> Answer {
        let clip = |(polygon, volume): &(Vec<ClipVertex>, ClipVolume)| (self.clip)(polygon, volume, ATTRIBUTES);
        called(|| case.inputs().iter().map(clip).collect())
    }

    fn complaint(&self, case: &Case, answer: &Answer) -> Option<String> {
        judge::complaint(case, answer)
    }

    fn mistakes(&self) -> Vec<Mistake> {
        self.mutants.iter().map(|known| known.mistake).collect()
    }

    fn fits(&self, mistake: usize, case: &Case, answer: &Answer, is_right: bool) -> bool {
        fits::fits(&self.mutants[mistake].kind, case, answer, is_right)
    }

    fn smaller(&self, case: &Case) -> Vec<Case> {
        cases::smaller(case)
    }

    fn show(&self, case: &Case, answer: &Answer, complaint: &str) -> String {
        judge::show(case, answer, complaint)
    }

    fn unit(&self) -> &'static str {
        "polygons"
    }

    fn read(&self) -> &'static str {
        "docs/clipping.md"
    }
}
