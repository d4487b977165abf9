//! Split: cut a polygon into triangles, an ear at a time.
//!
//! ```text
//! light -> EyePolygon -> SPLIT -> triangles -> project
//! ```
//!
//! An *ear* is three consecutive vertices Previous, Current, Next whose triangle lies inside the polygon. FAROP
//! (4.3.2, after Judd 1988) cuts the ear with the smallest distance Previous-Next, removes Current, and goes on until
//! three vertices remain. Short diagonals first keeps the triangles compact, and no vertex is ever invented, so
//! colors and neighbors stay as they were. Always n - 2 triangles, whatever the outline.
//!
//! Why exact signs (`predicates`): if every triangle turns the polygon's way, the triangles cover the polygon once
//! and overlap nowhere, because their areas add up to the polygon's. Exactness makes that an argument, not a hope.
//!
//! Outlines that touch themselves are usual here: clipping a comb leaves teeth joined by bridges of no width. Three
//! rules keep them whole. A vertex on the border of an ear counts as inside, for a diagonal through it would make a
//! T-junction; such ears wait for the better ones. A vertex in the same place as a corner is no obstacle unless its
//! own edges enter the ear. Triangles without area come last: they never hide anything, but they make T-junctions.
//!
//! Where clipping has rounded the ends of the bridges, they may cross by a last place, and no cutting is free of overlap.
//! Then everything starts again with signs that take what rounding can move for collinear. Measured on 200 slanted
//! combs: without it a forced ear overlapped the rest by up to 5 times the polygon; with it, by less than 1e-13.
//!
//! Space: eye space. Distances are measured there; signs are taken in the plane that is left when the axis of
//! the largest normal component is dropped, which changes no coordinate.
//! Sources: FAROP, IST/INESC 1996, 4.3.2; G. H. Meisters, "Polygons Have Ears", American Mathematical Monthly 82(6), 1975.
//! Cost: O(n log n) for n vertices, about 1 microsecond a triangle at a million; more where long thin ears pass close to
//! slanted rows of vertices. Nothing is allocated once the scratch has grown.

mod crossing;
mod fit;
mod obstacles;
mod plane;
mod queue;

pub use crossing::Crossing;

use crate::geometry::predicates::{Orientation, orientation};
use crate::math::{Vec2, Vec3};
use fit::Turns;
use obstacles::Obstacles;
use plane::Plane;
use queue::{Candidate, Queue, Rank};

/// What splitting one polygon met.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SplitReport {
    /// Triangles cut although they were no ears: the outline crosses itself, or runs against its normal.
    pub forced: usize,
    /// Triangles without area: from spikes, doubled vertices and bridges.
    pub flat: usize,
    /// Whether the outline crosses itself. With nothing forced it does so by no more than rounding, and triangles overlap by as little.
    pub rounded: bool,
}

/// Working memory of [`split`]; keep one and pass it again.
#[derive(Debug, Default)]
pub struct SplitScratch {
    corners: Vec<Corner>,
    candidates: Queue,
    obstacles: Obstacles,
}

/// Cuts `outline` into `outline.len() - 2` triangles and appends them to `triangles`, as indices into `outline`.
///
/// `outline` is in eye space, planar or nearly so; `normal` points to the side from which it runs counterclockwise
/// (any length; without one, the flattest axis is dropped). Triangles keep the outline's winding. Each edge
/// of the outline is in one triangle, each diagonal in two that walk it in opposite directions.
///
/// Outlines that cross themselves are cut all the same, and counted as forced; if they do so by less than 16 last places of
/// the largest coordinate, they are cut with that allowance and only marked as rounded. Not noticed is an outline that overlaps
/// itself like a coiled ribbon, turning once in all, or is drawn twice over: it has true ears only. Fewer than three vertices give nothing.
///
/// ```
/// use farop::geometry::split::{SplitScratch, split};
/// use farop::math::Vec3;
/// let kite = [(0.0, 0.0), (2.0, -1.0), (9.0, 0.0), (2.0, 1.0)].map(|(x, y)| Vec3::new(x, y, 5.0));
/// let mut triangles = Vec::new();
/// let report = split(&kite, Vec3::Z, &mut SplitScratch::default(), &mut triangles);
/// assert_eq!(triangles, [[3, 0, 1], [1, 2, 3]]);
/// assert_eq!(report.forced, 0);
/// ```
pub fn split(outline: &[Vec3], normal: Vec3, scratch: &mut SplitScratch, triangles: &mut Vec<[u32; 3]>) -> SplitReport {
    let plane = Plane::facing(outline, normal);
    match *outline {
        [] | [_] | [_, _] => SplitReport::default(),
        [a, b, c] => {
            triangles.push([0, 1, 2]);
            let mut report = SplitReport::default();
            report.count([a, b, c].map(|p| plane.flatten(p)), Turns::Exact);
            report
        }
        [a, b, c, d] if is_strictly_convex([a, b, c, d].map(|p| plane.flatten(p))) => {
            let scale = scale_to_one(outline);
            triangles.extend(split_convex_quad(distance_squared(b, d, scale) <= distance_squared(a, c, scale)));
            SplitReport::default()
        }
        _ => {
            let scale = scale_to_one(outline);
            let mut splitter =
                Splitter { outline, scale, turns: Turns::Exact, scratch, report: SplitReport::default() };
            let start = triangles.len();
            splitter.run(plane, triangles);

            // The outline crosses itself. If only rounding made it, the bridges clipping left are on one line again after this.
            if splitter.report.forced > 0 {
                triangles.truncate(start);
                splitter.turns = Turns::Rounded(scale);
                splitter.report = SplitReport { rounded: true, ..SplitReport::default() };
                splitter.run(plane, triangles);
            }
            splitter.report
        }
    }
}

/// The two triangles of a quadrilateral with four ears: of equally short diagonals the one that cuts vertex 0.
fn split_convex_quad(cut_at_zero: bool) -> [[u32; 3]; 2] {
    if cut_at_zero { [[3, 0, 1], [1, 2, 3]] } else { [[0, 1, 2], [0, 2, 3]] }
}

fn is_strictly_convex([a, b, c, d]: [Vec2; 4]) -> bool {
    [[a, b, c], [b, c, d], [c, d, a], [d, a, b]]
        .iter()
        .all(|&[p, q, r]| orientation(p, q, r) == Orientation::Counterclockwise)
}

impl SplitReport {
    /// Counts the triangle that remains at the end.
    fn count(&mut self, [a, b, c]: [Vec2; 3], turns: Turns) {
        match turns.orientation(a, b, c) {
            Orientation::Clockwise => self.forced += 1,
            Orientation::Collinear => self.flat += 1,
            Orientation::Counterclockwise => {}
        }
    }
}

/// A power of two that brings the coordinates near 1, so that squared distances neither overflow nor vanish.
fn scale_to_one(outline: &[Vec3]) -> f64 {
    let largest = outline.iter().fold(0.0, |largest: f64, p| largest.max(p.abs().max_element()));
    let exponent = largest.to_bits() >> 52;
    f64::from_bits((2046 - exponent.min(2045)) << 52)
}

fn distance_squared(a: Vec3, b: Vec3, scale: f64) -> f64 {
    (a * scale - b * scale).length_squared()
}

/// A vertex of what remains of the outline.
#[derive(Clone, Copy, Debug)]
struct Corner {
    point: Vec2,
    previous: u32,
    next: u32,
    /// What was in the way of this ear when it was last judged, or the corner itself.
    blocker: u32,
    /// The one entry among the candidates that counts; all others of this corner are out of date.
    candidate: Candidate,
}

/// One polygon being split.
struct Splitter<'a> {
    outline: &'a [Vec3],
    scale: f64,
    turns: Turns,
    scratch: &'a mut SplitScratch,
    report: SplitReport,
}

impl Splitter<'_> {
    /// Appends all triangles; gives up at the first that is forced, if signs are exact.
    fn run(&mut self, plane: Plane, triangles: &mut Vec<[u32; 3]>) {
        self.start(plane);
        for _ in 3..self.outline.len() {
            let Some(vertex) = self.best_candidate() else { break };
            let Corner { previous, next, .. } = self.corner(vertex);
            triangles.push([previous, vertex, next]);
            self.cut(vertex);
            if self.turns == Turns::Exact && self.report.forced > 0 {
                return;
            }
        }

        // Emit the three that remain, in the order of the outline.
        let mut remaining = (0..).zip(&self.scratch.corners).filter(|(_, corner)| corner.candidate != Candidate::NONE);
        if let (Some((a, at_a)), Some((b, at_b)), Some((c, at_c))) =
            (remaining.next(), remaining.next(), remaining.next())
        {
            triangles.push([a, b, c]);
            self.report.count([at_a.point, at_b.point, at_c.point], self.turns);
        }
    }

    /// Links the corners into a ring, gathers the obstacles and ranks everything.
    fn start(&mut self, plane: Plane) {
        let count = self.outline.len() as u32;
        let turns = self.turns;
        let SplitScratch { corners, candidates, obstacles } = &mut *self.scratch;
        corners.clear();
        corners.extend((0..count).zip(self.outline).map(|(i, &p)| Corner {
            point: plane.flatten(p),
            previous: if i == 0 { count - 1 } else { i - 1 },
            next: if i + 1 == count { 0 } else { i + 1 },
            blocker: i,
            candidate: Candidate::NONE,
        }));
        let is_convex = |c: &Corner| {
            let (previous, next) = (corners[c.previous as usize].point, corners[c.next as usize].point);
            turns.orientation(previous, c.point, next) == Orientation::Counterclockwise
        };
        if corners.iter().all(is_convex) {
            obstacles.clear();
        } else {
            obstacles.gather(corners.iter().map(|c| c.point));
        }
        candidates.clear();
        for vertex in 0..count {
            self.rank_again(vertex);
        }
    }

    fn corner(&self, vertex: u32) -> Corner {
        self.scratch.corners[vertex as usize]
    }

    fn point(&self, vertex: u32) -> Vec2 {
        self.scratch.corners[vertex as usize].point
    }

    /// Ranks a corner whose neighbors are new. Whether an ear is free is asked only when its turn comes.
    fn rank_again(&mut self, vertex: u32) {
        let Corner { point, previous, next, candidate: old, .. } = self.corner(vertex);
        let (before, after) = (self.point(previous), self.point(next));
        let rank = match self.turns.orientation(before, point, after) {
            _ if before == point || point == after || before == after => Rank::Collapsed,
            Orientation::Counterclockwise => Rank::Ear,
            Orientation::Collinear => Rank::Flat,
            Orientation::Clockwise => Rank::Reflex,
        };
        self.scratch.obstacles.set(vertex, rank != Rank::Ear);
        let dimension = distance_squared(self.outline[previous as usize], self.outline[next as usize], self.scale);
        let candidate = Candidate::new(rank, dimension, vertex);
        if candidate != old {
            self.enter(candidate);
        }
    }

    fn enter(&mut self, candidate: Candidate) {
        self.scratch.corners[candidate.vertex() as usize].candidate = candidate;
        self.scratch.candidates.push(candidate);
    }

    /// The corner to cut next. Every remaining corner has an entry, so there always is one.
    fn best_candidate(&mut self) -> Option<u32> {
        loop {
            let SplitScratch { corners, candidates, .. } = &mut *self.scratch;
            let candidate = candidates.pop(|candidate| corners[candidate.vertex() as usize].candidate == candidate)?;
            let vertex = candidate.vertex();

            // Send an ear that is worse than its rank back to wait, at first only until flat corners are gone. Otherwise
            // only its neighbors' cutting makes it better, and that ranks it again: what lies in an ear stays there.
            let rank = candidate.rank();
            let judged = match rank {
                Rank::Ear | Rank::TouchedEar | Rank::DoubtfulEar => self.judge(vertex, rank),
                _ => rank,
            };
            if judged <= rank {
                return Some(vertex);
            }
            let waiting = if rank < Rank::DoubtfulEar { judged.min(Rank::DoubtfulEar) } else { judged };
            self.enter(candidate.with_rank(waiting));
        }
    }

    fn cut(&mut self, vertex: u32) {
        let Corner { previous, next, candidate, .. } = self.corner(vertex);
        match candidate.rank() {
            Rank::Collapsed | Rank::Flat => self.report.flat += 1,
            Rank::Forced | Rank::Reflex => self.report.forced += 1,
            Rank::Ear | Rank::TouchedEar | Rank::DoubtfulEar => {}
        }
        self.scratch.obstacles.set(vertex, false);
        self.scratch.corners[vertex as usize].candidate = Candidate::NONE;
        self.scratch.corners[previous as usize].next = next;
        self.scratch.corners[next as usize].previous = previous;
        self.rank_again(previous);
        self.rank_again(next);
    }

    /// The rank of a convex corner by what is in its triangle, if it is `hoped` or better; else some rank between `hoped` and the
    /// true one. At least four vertices remain, no two neighbors in one place.
    fn judge(&mut self, vertex: u32, hoped: Rank) -> Rank {
        let Corner { point, previous, next, mut blocker, .. } = self.corner(vertex);
        let ear = [self.point(previous), point, self.point(next)];

        // The diagonal must start into the polygon at both of its ends.
        let ends = [self.point(self.corner(previous).previous), self.point(self.corner(next).next)];
        let mut rank = Rank::of_ear(self.turns.fit_of_diagonal(ear, ends));

        // Nothing else may lie in the ear. Ask first what was there before, for it mostly still is, and stop at the first
        // that is too bad, for many a long diagonal is touched by thousands.
        let rank_of = |obstacle| {
            let Corner { point, previous: before, next: after, .. } = self.corner(obstacle);
            if [previous, vertex, next].contains(&obstacle) {
                return Rank::Ear;
            }
            Rank::of_ear(self.turns.fit_of_obstacle(ear, point, [self.point(before), self.point(after)]))
        };
        if self.scratch.obstacles.stands(blocker) {
            rank = rank.max(rank_of(blocker));
        }
        if rank <= hoped {
            self.scratch.obstacles.visit_near(&ear, self.turns.margin(), |obstacle| {
                rank = rank.max(rank_of(obstacle));
                if rank > hoped {
                    blocker = obstacle;
                }
                rank <= hoped
            });
        }
        self.scratch.corners[vertex as usize].blocker = blocker;
        rank
    }
}
