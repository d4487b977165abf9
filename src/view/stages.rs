//! Stages: which value of one stage became which of the next, and what there is to say about each.
//!
//! Trace, DrawList -STAGES-> steps, text
//!
//! The trace holds the polygons that culling saw and those that clipping left, in order, without a link: most are dropped.
//! A polygon is found again by cutting it anew: the same cut gives the same bits.
//!
//! Space: eye space for what culling saw, clip space (x, y, w) for what clipping left.

use super::cut::{self, Crossing};
use crate::geometry::clip::{ClipVertex, ClipVolume, Clipped, Clipper, Outcode};
use crate::geometry::split::{SplitScratch, split};
use crate::geometry::{self, EyePolygon, Facing, Trace};
use crate::math::Vec3;
use crate::plan::Plan;
use crate::report::Counts;
use crate::scene::Scene;
use crate::screen::{DrawList, EdgeKind};
use std::ops::Range;

/// What the geometry stage made, and the values between its stages.
#[derive(Debug)]
pub struct Traced {
    /// What culling and clipping saw.
    pub trace: Trace,
    /// Needs and view.
    pub plan: Plan,
    /// The polygons on the screen.
    pub list: DrawList,
    /// What was counted.
    pub counts: Counts,
    /// For every polygon that culling saw, the one that clipping left.
    pub kept: Vec<Option<usize>>,
    /// For every polygon that clipping left, the one that culling saw.
    pub origins: Vec<usize>,
    /// For every polygon that clipping left, those on the screen.
    pub pieces: Vec<Range<usize>>,
}

impl Traced {
    /// Runs the geometry stage and links its values.
    #[must_use]
    pub fn new(scene: &Scene, plan: Plan) -> Traced {
        let (mut list, mut trace) = (DrawList::new(0, 0), Trace::default());
        let counts = geometry::run_traced(scene, &plan, &mut list, &mut trace);
        let kept = link(&trace, &plan);
        let mut origins = vec![0; trace.clipped.len()];
        kept.iter().enumerate().for_each(|(eye, clipped)| {
            if let Some(clipped) = clipped {
                origins[*clipped] = eye;
            }
        });
        let pieces = pieces(&trace, &list);
        Traced { trace, plan, list, counts, kept, origins, pieces }
    }

    /// Whether a polygon went on to clipping, as far as the trace tells.
    #[must_use]
    pub fn is_culled(&self, number: usize) -> bool {
        self.kept[number].is_none() && !matches!(self.trace.eye[number].facing, Facing::Front { .. })
    }

    /// Every plane that every polygon crosses, in order; what lies wholly outside a plane has one step of its own.
    #[must_use]
    pub fn crossings(&self) -> Vec<Crossing> {
        let polygons = (0..self.trace.eye.len()).filter(|&number| !self.is_culled(number));
        polygons.flat_map(|number| cut::crossings(number, &self.trace.eye[number].corners, &self.plan)).collect()
    }

    /// All ears: the polygon that clipping left, and which of its triangles.
    #[must_use]
    pub fn ears(&self) -> Vec<(usize, usize)> {
        let count = |polygon: usize| self.trace.clipped[polygon].vertices.len();
        let with_ears = (0..self.trace.clipped.len()).filter(|&polygon| count(polygon) > 3);
        with_ears.flat_map(|polygon| (0..count(polygon) - 2).map(move |ear| (polygon, ear))).collect()
    }

    /// The corners of a polygon that clipping left, in eye space.
    #[must_use]
    pub fn eye_corners(&self, polygon: usize) -> Vec<Vec3> {
        let (kx, ky) = self.plan.view.clip_from_eye();
        let to_eye = |vertex: &ClipVertex| {
            let Vec3 { x, y, z } = vertex.position;
            Vec3::new(x / kx, y / ky, z)
        };
        self.trace.clipped[polygon].vertices.iter().map(to_eye).collect()
    }

    /// The triangles of a polygon that clipping left, in the order of cutting.
    #[must_use]
    pub fn triangles(&self, polygon: usize) -> Vec<[u32; 3]> {
        let normal = self.trace.eye[self.origins[polygon]].facing.newell();
        let mut triangles = Vec::new();
        split(&self.eye_corners(polygon), normal, &mut SplitScratch::default(), &mut triangles);
        triangles
    }

    /// What there is to say about a polygon that culling saw.
    #[must_use]
    pub fn eye_text(&self, number: usize) -> Vec<String> {
        let EyePolygon { source, corners, facing } = &self.trace.eye[number];
        let towards = facing.newell().dot(corners.first().copied().unwrap_or(Vec3::ZERO));
        let verdict = match (facing, self.kept[number]) {
            (Facing::Front { .. }, Some(_)) => "> 0: the front".to_string(),
            (Facing::Front { .. }, None) => "> 0: the front, outside the view volume".to_string(),
            (Facing::Back { .. }, None) => "< 0: the back, culled".to_string(),
            (Facing::Back { .. }, Some(_)) => "< 0: the back, kept".to_string(),
            (Facing::EdgeOn, _) => "= 0: edge-on, dropped".to_string(),
            (Facing::NotFinite, _) => ": not finite, dropped".to_string(),
        };
        vec![
            format!("polygon {number} of {}, line {}: eye space", self.trace.eye.len(), source.line),
            format!("corners {}", points(corners.iter().map(|p| p.to_array().to_vec()))),
            format!("Newell normal . corner = {} {verdict}", short(towards)),
        ]
    }

    /// What there is to say about an ear.
    #[must_use]
    pub fn ear_text(&self, (polygon, ear): (usize, usize)) -> Vec<String> {
        let triangles = self.triangles(polygon);
        let [a, b, c] = triangles[ear.min(triangles.len() - 1)];
        vec![
            format!("polygon {}: {} corners", self.origins[polygon], self.trace.clipped[polygon].vertices.len()),
            format!("ear {} of {}: corners {a} {b} {c}", ear + 1, triangles.len()),
        ]
    }

    /// What there is to say about a polygon on the screen.
    #[must_use]
    pub fn screen_text(&self, number: usize) -> Vec<String> {
        let polygon = self.list.polygon(number);
        let made = polygon.vertices().iter().filter(|vertex| vertex.edge != EdgeKind::Original).count();
        let corners = points(polygon.vertices().iter().map(|corner| vec![corner.x, corner.y]));
        let colors: Vec<Vec<f64>> =
            (0..polygon.vertices().len()).map(|corner| polygon.vertex_values(corner).to_vec()).collect();
        let same = colors.iter().all(|color| *color == colors[0]);
        let shown = if same { points(colors.into_iter().take(1)) } else { points(colors.into_iter()) };
        let mut lines = vec![
            format!("polygon {number} of {}, line {}: screen", self.list.len(), polygon.record().source.line),
            format!("corners {corners}; edges made by clipping or splitting: {made}"),
        ];
        if let Some(plane) = polygon.depth_plane() {
            lines.push(format!("1/w = {} + {} x + {} y", short(plane.c), short(plane.a), short(plane.b)));
            lines.push(format!("{} {shown}", if self.list.varying.count() == 3 { "light" } else { "normal, eye" }));
        }
        lines
    }
}

/// Finds for every polygon that culling saw what clipping left of it.
fn link(trace: &Trace, plan: &Plan) -> Vec<Option<usize>> {
    let (kx, ky) = plan.view.clip_from_eye();
    let volume = ClipVolume { hither: plan.view.hither, yon: Some(plan.view.yon) };
    let planes = if plan.is_unsnapped() { Outcode::DEPTHS } else { Outcode::ALL };
    let (mut clipper, mut next, mut polygon) = (Clipper::default(), 0, Vec::new());
    let find = |eye: &EyePolygon| {
        let clipped = trace.clipped.get(next).filter(|clipped| clipped.source == eye.source)?;
        polygon.clear();
        polygon.extend(eye.corners.iter().map(|corner| ClipVertex {
            position: Vec3::new(corner.x * kx, corner.y * ky, corner.z),
            ..ClipVertex::default()
        }));
        let left = match clipper.clip_by(planes, &polygon, &volume, 0) {
            Clipped::Inside => &polygon[..],
            Clipped::Cut(vertices) => vertices,
            Clipped::Outside | Clipped::NotFinite => return None,
        };
        let same = left.len() == clipped.vertices.len()
            && left.iter().zip(&clipped.vertices).all(|(ours, theirs)| ours.position == theirs.position);
        same.then(|| {
            next += 1;
            next - 1
        })
    };
    trace.eye.iter().map(find).collect()
}

/// Which polygons on the screen each clipped polygon became: itself, or triangles.
fn pieces(trace: &Trace, list: &DrawList) -> Vec<Range<usize>> {
    let mut next = 0;
    let of = |clipped: &geometry::ClippedPolygon| {
        let corners = clipped.vertices.len();
        let whole = next >= list.len() || list.polygon(next).vertices().len() == corners;
        let start = next;
        next = (start + if whole { 1 } else { corners - 2 }).min(list.len());
        start.min(next)..next
    };
    trace.clipped.iter().map(of).collect()
}

/// A number with at most four digits behind the point.
#[must_use]
pub fn short(number: f64) -> String {
    if number != 0.0 && (number.abs() >= 1e6 || number.abs() < 1e-3) {
        return format!("{number:.3e}");
    }
    let text = format!("{number:.4}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_string() } else { text.to_string() }
}

/// Points in brackets; of many only the first. What is nothing but rounding beside the largest number of its point is 0.
pub(super) fn points(points: impl ExactSizeIterator<Item = Vec<f64>>) -> String {
    const SHOWN: usize = 8;
    let count = points.len();
    let point = |numbers: Vec<f64>| {
        let largest = numbers.iter().fold(0.0_f64, |largest, number| largest.max(number.abs()));
        let short = |number: f64| if number.abs() < largest * 1e-12 { short(0.0) } else { short(number) };
        format!("({})", numbers.into_iter().map(short).collect::<Vec<_>>().join(", "))
    };
    let mut words: Vec<_> = points.take(SHOWN).map(point).collect();
    words.extend((count > SHOWN).then(|| format!("and {} more", count - SHOWN)));
    words.join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        assert_eq!(
            [0.0, -0.0, 1.0 / 3.0, -2.5, 0.00001, 1e9].map(short),
            ["0", "0", "0.3333", "-2.5", "1.000e-5", "1.000e9"]
        );
        assert_eq!(points(vec![vec![1.0, 2.0]; 9].into_iter()), format!("{}and 1 more", "(1, 2) ".repeat(8)));
    }
}
