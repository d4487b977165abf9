//! Triangulate: questions to a student's split of a polygon into triangles, and what is right.
//!
//! Outlines have whole coordinates, so that areas are whole numbers and every judgment is exact (`i128`). Right is: n - 2
//! triangles of the outline's corners, none of which turns the other way; areas that add up to the outline's; every edge of the
//! outline in one triangle, every diagonal in two, once in each direction. From that it follows that the polygon is covered once.
//! Which triangles is left free. Not asked: outlines that cross themselves.
//!
//! Space: a plane of space; [`Case::in_space`] puts the whole numbers there without rounding.

mod cases;
mod draw;
mod judge;
mod names;
mod replay;

use super::{Exercise, Mistake, called};
use crate::math::{Vec3, pow};
use crate::raster::functions::TriangulateFunction;

/// A corner.
pub(super) type Whole = [i64; 2];

/// One question.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Case {
    /// Counterclockwise seen from the tip of the normal.
    pub ring: Vec<Whole>,
    /// The axis that the outline's plane is seen along.
    pub axis: usize,
    /// The normal points against that axis.
    pub is_flipped: bool,
    /// The plane rises by half of this along the outline's first coordinate.
    pub tilt: i64,
    /// Coordinates are times 2 to this power.
    pub exponent: i32,
    /// The outline does not touch itself.
    pub is_simple: bool,
}

/// What the function answers, or how it failed.
pub(super) type Answer = Result<Vec<[u32; 3]>, String>;

impl Case {
    /// Seen along z, with a normal towards the viewer.
    pub(super) fn is_plain(&self) -> bool {
        self.axis == 2 && !self.is_flipped
    }

    /// The outline and its normal as the function gets them.
    pub(super) fn in_space(&self) -> (Vec<Vec3>, Vec3) {
        let (right, up) = ((self.axis + 1) % 3, (self.axis + 2) % 3);
        let (right, up) = if self.is_flipped { (up, right) } else { (right, up) };
        let scale = pow(2.0, f64::from(self.exponent));
        let place = |&[x, y]: &Whole| {
            let mut place = Vec3::ZERO;
            (place[right], place[up], place[self.axis]) = (x as f64, y as f64, (self.tilt * x) as f64 / 2.0);
            place * scale
        };
        let mut normal = Vec3::ZERO;
        (normal[self.axis], normal[right]) = (1.0, -(self.tilt as f64) / 2.0);
        (self.ring.iter().map(place).collect(), if self.is_flipped { -normal } else { normal })
    }
}

/// A student's function under examination.
pub(super) struct TriangulateExercise<'a>(pub &'a TriangulateFunction);

impl Exercise for TriangulateExercise<'_> {
    type Case = Case;
    type Answer = Answer;

    fn cases(&self, aspect: &str, seed: u64) -> Vec<Case> {
        cases::of(aspect, seed)
    }

    fn ask(&self, case: &Case) -> Answer {
        let (outline, normal) = case.in_space();
        called(|| (self.0)(&outline, normal))
    }

    fn complaint(&self, case: &Case, answer: &Answer) -> Option<String> {
        match answer {
            Ok(triangles) => judge::complaint(case, triangles),
            Err(words) => Some(words.clone()),
        }
    }

    fn mistakes(&self) -> Vec<Mistake> {
        names::ALL.iter().map(|(mistake, _)| *mistake).collect()
    }

    fn fits(&self, mistake: usize, case: &Case, answer: &Answer, is_right: bool) -> bool {
        answer.as_ref().is_ok_and(|triangles| names::fits(names::ALL[mistake].1, case, triangles, is_right))
    }

    fn smaller(&self, case: &Case) -> Vec<Case> {
        cases::smaller(case)
    }

    fn show(&self, case: &Case, answer: &Answer, complaint: &str) -> String {
        draw::show(case, answer.as_ref().ok().map(Vec::as_slice), complaint)
    }

    fn unit(&self) -> &'static str {
        "outlines"
    }

    fn read(&self) -> &'static str {
        "docs/splitting.md"
    }
}
