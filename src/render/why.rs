//! Why a sample shows what it shows: every polygon over it, its edges, its depth, who wins and by which rule.
//!
//! DrawList -WHY-> explanation; with a rasterizer, also what that one drew.
//!
//! Everything here is asked of the list and decided by the contract's rules, not read from a picture: so it can be held
//! against what a rasterizer drew.

mod tell;

pub use tell::Asked;

use super::Canvas;
use crate::color::Rgb;
use crate::math::edges;
use crate::plan::DepthFormat;
use crate::raster::{Frame, Rasterizer, coverage};
use crate::screen::{DrawList, ScreenPolygon, Source};

/// What lies over one sample.
#[derive(Clone, Debug, PartialEq)]
pub struct Explanation {
    /// The sample, column and row.
    pub sample: (i32, i32),
    /// Every polygon that covers it, in list order.
    pub candidates: Vec<Candidate>,
    /// Which candidate is in front of all others, if any is opaque.
    pub winner: Option<usize>,
    /// Why that one.
    pub rule: &'static str,
}

/// One polygon over a sample.
#[derive(Clone, Debug, PartialEq)]
pub struct Candidate {
    /// Its number in the list.
    pub polygon: u32,
    /// Where it comes from.
    pub source: Source,
    /// Its surface in the shader.
    pub surface: u32,
    /// Its depth there; larger is nearer. 0 in a hole.
    pub depth: f64,
    /// What it would show there.
    pub color: Rgb<f32>,
    /// 1 hides what is behind.
    pub opacity: Rgb<f32>,
    /// For every edge: twice the area of the triangle it makes with the sample's center, in samples. 0: the edge, or its line,
    /// passes exactly through the center.
    pub edges: Vec<f64>,
}

impl Candidate {
    /// Whether the surface has a hole there: it is covered, and nothing is to be put.
    #[must_use]
    pub fn is_hole(&self) -> bool {
        self.depth <= 0.0 && self.opacity == Rgb::gray(0.0)
    }
}

/// What a rasterizer left at one sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drawn {
    /// The opaque polygon it put there last.
    pub polygon: Option<u32>,
    /// The depth it put.
    pub depth: f64,
    /// The color there, transparent layers included.
    pub color: Rgb<f32>,
}

/// Explains sample (x, y) of `list`.
#[must_use]
pub fn explain(list: &DrawList, x: i32, y: i32) -> Explanation {
    let over = list.polygons().filter(|polygon| coverage::covers(polygon.vertices(), list.grid, x, y));
    let candidates: Vec<_> = over.map(|polygon| candidate(list, &polygon, x, y)).collect();
    let (winner, rule) = decide(&candidates, list.depth_mapping.format);
    Explanation { sample: (x, y), candidates, winner, rule }
}

fn candidate(list: &DrawList, polygon: &ScreenPolygon<'_>, x: i32, y: i32) -> Candidate {
    let fragment = list.shader.fragment(polygon, x, y);
    let center = (f64::from(x) + 0.5, f64::from(y) + 0.5);
    let area = |(start, end): (&crate::screen::ScreenVertex, &crate::screen::ScreenVertex)| {
        (end.x - start.x) * (center.1 - start.y) - (end.y - start.y) * (center.0 - start.x)
    };
    Candidate {
        polygon: polygon.index,
        source: polygon.record().source,
        surface: polygon.surface(),
        depth: fragment.depth,
        color: fragment.color,
        opacity: fragment.opacity,
        edges: edges(polygon.vertices()).map(area).collect(),
    }
}

fn decide(candidates: &[Candidate], format: DepthFormat) -> (Option<usize>, &'static str) {
    let opaque = || candidates.iter().enumerate().filter(|(_, candidate)| candidate.opacity == Rgb::gray(1.0));
    // The first of the nearest: max_by would give the last.
    let winner = opaque().reduce(|best, next| if next.1.depth > best.1.depth { next } else { best });
    let Some((index, nearest)) = winner else {
        return (
            None,
            match candidates.iter().filter(|candidate| !candidate.is_hole()).count() {
                _ if candidates.is_empty() => "no polygon covers it: the background shows",
                0 => "only holes of surfaces cover it: the background shows",
                _ => "only transparent polygons cover it",
            },
        );
    };
    let ties = opaque().filter(|(_, candidate)| candidate.depth == nearest.depth).count();
    let rule = match (opaque().count(), ties, format) {
        (1, _, _) => "the only opaque polygon over it",
        (_, 1, _) => "the nearest: the largest depth",
        (_, _, DepthFormat::Int16 | DepthFormat::Int24) => {
            "equal depth after rounding to integers: the first in the list keeps the sample"
        }
        _ => "equal depth: the first in the list keeps the sample",
    };
    (Some(index), rule)
}

/// Draws the whole list with `rasterizer` and reads sample (x, y).
#[must_use]
pub fn drawn(list: &DrawList, rasterizer: &dyn Rasterizer, canvas: &Canvas, (x, y): (i32, i32)) -> Option<Drawn> {
    let row = u32::try_from(y).ok().filter(|&row| row < list.height)?;
    let column = u32::try_from(x).ok().filter(|&column| column < list.width)?;
    let mut frame = Frame::default();
    // One row is enough: what is put elsewhere is dropped.
    let mut target = frame.target((list.width, list.height), row..row + 1, canvas.background, canvas.transparency);
    rasterizer.draw(list, &mut target);
    target.finish();
    let (polygon, depth, color) = frame.sample(column as usize);
    Some(Drawn { polygon, depth, color })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ties_go_to_the_first_and_the_rule_is_named() {
        let mut list = DrawList::new(4, 4);
        let square = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)];
        list.push_flat(&square, 0.5, [1.0, 0.0, 0.0]);
        list.push_flat(&square, 0.5, [0.0, 1.0, 0.0]);
        let tie = explain(&list, 1, 1);
        assert_eq!((tie.winner, tie.candidates.len()), (Some(0), 2));
        assert!(tie.rule.contains("first in the list"));
        list.push_flat(&square, 0.75, [0.0, 0.0, 1.0]);
        assert_eq!(explain(&list, 1, 1).winner, Some(2));
        assert!(explain(&list, 9, 9).candidates.is_empty());
    }

    #[test]
    fn an_edge_through_the_center_has_value_zero() {
        let mut list = DrawList::new(4, 4);
        list.push_flat(&[(1.5, 0.0), (4.0, 0.0), (4.0, 4.0), (1.5, 4.0)], 0.5, [1.0; 3]);
        assert_eq!(explain(&list, 1, 1).candidates[0].edges[3], 0.0);
    }
}
