//! Clip: keep the part of each polygon that lies inside the view volume.
//!
//! ```text
//! cull -> EyePolygon -> CLIP -> ClippedPolygon -> light -> split -> project
//! ```
//!
//! Why before the division by w: behind the eye w <= 0, and dividing first would fold the back of the scene onto the
//! screen. In clip coordinates each plane is one linear test, and attributes that are linear in space stay linear.
//!
//! Why a polygon inside comes back untouched: then a plan that skips clipping changes no bit of the picture.
//!
//! How cracks are ruled out: two neighbors walk their shared edge in opposite directions and must compute the same
//! vertices. Every cut is computed from its inner end to its outer end, whoever asks, so the operands are the same
//! and so are the bits; all polygons meet the planes in one order, so this holds after every plane.
//!
//! How rounding is kept from pushing a vertex out of a plane: the cut coordinate is set onto its plane, and a new vertex
//! is held between its two ends in every coordinate and inside every plane that has both ends inside. So by
//! induction no vertex ever lies outside a plane that was already applied, or that needed no cut.
//!
//! Space: homogeneous clip coordinates (x, y, w), y up. Inside: -w <= x <= w, -w <= y <= w, hither <= w <= yon. A vertex on a
//! plane is inside; signs decide, no epsilon.
//! Sources: I. E. Sutherland and G. W. Hodgman, "Reentrant Polygon Clipping", CACM 17(1), 1974; J. F. Blinn and M. E.
//! Newell, "Clipping Using Homogeneous Coordinates", SIGGRAPH 1978.
//! Cost: six comparisons per vertex; for a polygon that is cut, one distance per vertex and plane it crosses, and one division
//! per coordinate of a crossing. Nothing is allocated once the two buffers have grown.

use crate::math::Vec3;
use crate::screen::EdgeKind;

/// The most attributes a vertex carries through clipping.
pub const MAX_ATTRIBUTES: usize = 8;

/// A vertex on its way through the planes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ClipVertex {
    /// Homogeneous clip coordinates: x, y, and w in the place of z.
    pub position: Vec3,
    /// Anything linear in space: normals, colors, eye coordinates. Only the first few that the caller names are computed.
    pub attributes: [f64; MAX_ATTRIBUTES],
    /// The edge that starts here and runs to the next vertex.
    pub edge: EdgeKind,
}

/// The part of space that is seen, between two distances along the view; the four sides are always |x| <= w, |y| <= w.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClipVolume {
    /// The nearest w that is seen; positive.
    pub hither: f64,
    /// The farthest w that is seen; `None` is infinitely far.
    pub yon: Option<f64>,
}

/// The planes a point lies outside of, a bit for each. The `&` of all vertices tells what is wholly outside, the `|` what needs cutting.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Outcode(u8);

/// What is left of a polygon.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Clipped<'a> {
    /// All of it: use the polygon as it was.
    Inside,
    /// These vertices, at least three, wound like the polygon.
    Cut(&'a [ClipVertex]),
    /// Nothing.
    Outside,
    /// A number in it is NaN, infinite or so large that cutting overflows: skip it and count it.
    NotFinite,
}

/// Cuts polygons; keep one, for it owns the memory of the results.
#[derive(Debug, Default)]
pub struct Clipper {
    polygon: Vec<ClipVertex>,
    next: Vec<ClipVertex>,
}

#[derive(Clone, Copy, Debug)]
enum Plane {
    Hither(f64),
    Left,
    Right,
    Bottom,
    Top,
    Yon(f64),
}

impl Outcode {
    const NOT_FINITE: u8 = 1 << 6;
    /// Hither and yon, without the sides of the picture.
    pub const DEPTHS: Outcode = Outcode(1 | 1 << 5);
    /// Every plane.
    pub const ALL: Outcode = Outcode(u8::MAX);

    /// Whether the point is inside all planes.
    #[must_use]
    pub fn is_inside(self) -> bool {
        self.0 == 0
    }

    /// Whether a coordinate is NaN or infinite.
    #[must_use]
    pub fn is_not_finite(self) -> bool {
        self.0 & Outcode::NOT_FINITE != 0
    }
}

impl std::ops::BitAnd for Outcode {
    type Output = Outcode;
    fn bitand(self, other: Outcode) -> Outcode {
        Outcode(self.0 & other.0)
    }
}

impl std::ops::BitOr for Outcode {
    type Output = Outcode;
    fn bitor(self, other: Outcode) -> Outcode {
        Outcode(self.0 | other.0)
    }
}

impl ClipVolume {
    /// The planes that `position` (x, y, w) lies outside of. Comparisons round nothing, so this is exact.
    #[must_use]
    pub fn outcode(&self, position: Vec3) -> Outcode {
        let Vec3 { x, y, z: w } = position;
        let outside =
            [w < self.hither, x < -w, x > w, y < -w, y > w, self.yon.is_some_and(|yon| w > yon), !position.is_finite()];
        Outcode(outside.iter().enumerate().fold(0, |code, (plane, &is_outside)| code | u8::from(is_outside) << plane))
    }

    /// The planes in the order in which all polygons meet them. Hither comes first: after it, w is positive.
    fn planes(&self) -> [Plane; 6] {
        let yon = self.yon.unwrap_or(f64::INFINITY);
        [Plane::Hither(self.hither), Plane::Left, Plane::Right, Plane::Bottom, Plane::Top, Plane::Yon(yon)]
    }
}

impl Clipper {
    /// Cuts `polygon` to `volume`, interpolating the first `attributes` attributes (the rest of a new vertex is zero).
    ///
    /// Winding is kept. A concave polygon that falls into pieces stays one outline, its pieces joined by edges that run
    /// to and fro on the plane. What only touches a plane from outside, with no area inside, is outside.
    pub fn clip(&mut self, polygon: &[ClipVertex], volume: &ClipVolume, attributes: usize) -> Clipped<'_> {
        self.clip_by(Outcode::ALL, polygon, volume, attributes)
    }

    /// As [`Clipper::clip`], by some of the planes only: what lies wholly outside one of the others is outside, too, but nothing
    /// is cut by them.
    pub fn clip_by(
        &mut self,
        planes: Outcode,
        polygon: &[ClipVertex],
        volume: &ClipVolume,
        attributes: usize,
    ) -> Clipped<'_> {
        // Let the outcodes settle the many that need no cutting.
        let mut any = Outcode::default();
        let mut all = Outcode(u8::MAX);
        for vertex in polygon {
            let outcode = volume.outcode(vertex.position);
            any = any | outcode;
            all = all & outcode;
        }
        if any.is_not_finite() {
            return Clipped::NotFinite;
        }
        if !all.is_inside() || polygon.len() < 3 {
            return Clipped::Outside;
        }
        any = any & planes;
        if any.is_inside() {
            return Clipped::Inside;
        }

        // Cut by each plane that some vertex is outside of.
        self.polygon.clear();
        self.polygon.extend_from_slice(polygon);
        for (bit, plane) in volume.planes().into_iter().enumerate() {
            if any.0 & (1 << bit) == 0 {
                continue;
            }
            let is_finite = cut(&self.polygon, &mut self.next, plane, attributes.min(MAX_ATTRIBUTES));
            if !is_finite {
                return Clipped::NotFinite;
            }
            std::mem::swap(&mut self.polygon, &mut self.next);
            if self.polygon.len() < 3 {
                return Clipped::Outside;
            }
        }
        Clipped::Cut(&self.polygon)
    }
}

impl Plane {
    /// How far inside a point is, times a positive number; negative outside. The sign is exact.
    fn distance(self, position: Vec3) -> f64 {
        let Vec3 { x, y, z: w } = position;
        match self {
            Plane::Hither(hither) => w - hither,
            Plane::Left => w + x,
            Plane::Right => w - x,
            Plane::Bottom => w + y,
            Plane::Top => w - y,
            Plane::Yon(yon) => yon - w,
        }
    }

    /// Sets the coordinate that this plane determines.
    fn snap(self, position: &mut Vec3) {
        match self {
            Plane::Hither(w) | Plane::Yon(w) => position.z = w,
            Plane::Left => position.x = -position.z,
            Plane::Right => position.x = position.z,
            Plane::Bottom => position.y = -position.z,
            Plane::Top => position.y = position.z,
        }
    }
}

/// One step of Sutherland and Hodgman: `kept` becomes the part of `polygon` inside `plane`. False if a result is not finite.
fn cut(polygon: &[ClipVertex], kept: &mut Vec<ClipVertex>, plane: Plane, attributes: usize) -> bool {
    kept.clear();
    let mut is_finite = true;
    let mut has_inside = false;
    for (a, b) in crate::math::edges(polygon) {
        let (a_distance, b_distance) = (plane.distance(a.position), plane.distance(b.position));
        has_inside |= a_distance > 0.0;
        let leaves = a_distance >= 0.0 && b_distance < 0.0;
        let enters = a_distance < 0.0 && b_distance > 0.0;

        // A vertex on the plane is its own crossing: if the outline leaves there, the next edge runs along the plane.
        if a_distance >= 0.0 {
            let edge = if leaves && a_distance == 0.0 { EdgeKind::Cut } else { a.edge };
            push(kept, ClipVertex { edge, ..*a });
        }

        // Compute from the inner end, whichever way the edge is walked: two neighbors walk it in opposite directions and
        // must get the same bits (tests/clip.rs, `neighbors_stay_watertight`).
        let (inner, outer) = match (leaves && a_distance > 0.0, enters) {
            (true, _) => ((a, a_distance), (b, b_distance)),
            (_, true) => ((b, b_distance), (a, a_distance)),
            _ => continue,
        };
        let mut crossing = between(inner, outer, attributes);
        is_finite &= crossing.position.is_finite() && crossing.attributes.iter().all(|value| value.is_finite());
        settle(&mut crossing.position, plane, [inner.0.position, outer.0.position]);
        crossing.edge = if leaves { EdgeKind::Cut } else { a.edge };
        push(kept, crossing);
    }

    // Drop the last vertex if it closes on the first, and everything if it only touches the plane.
    while kept.len() > 1 && kept.first().map(|v| v.position) == kept.last().map(|v| v.position) {
        kept.pop();
    }
    if !has_inside {
        kept.clear();
    }
    is_finite
}

/// Appends a vertex. One in the place of the last takes over from it, and the edge between them is gone.
fn push(kept: &mut Vec<ClipVertex>, vertex: ClipVertex) {
    match kept.last_mut() {
        Some(last) if last.position == vertex.position => *last = vertex,
        _ => kept.push(vertex),
    }
}

/// The point between an `inner` vertex, at a positive distance, and an `outer` one, at a negative distance, where the distance is zero.
fn between(inner: (&ClipVertex, f64), outer: (&ClipVertex, f64), attributes: usize) -> ClipVertex {
    let ((a, a_distance), (b, b_distance)) = (inner, outer);
    // Bring the distances near 1 first: their products with coordinates then neither overflow nor vanish.
    let scale = power_of_two_near_reciprocal(a_distance - b_distance);
    let (from_a, from_b) = (a_distance * scale, b_distance * scale);
    let span = from_a - from_b;
    let mix = |a: f64, b: f64| (from_a * b - from_b * a) / span;

    let [p, q] = [a.position, b.position];
    let mut vertex =
        ClipVertex { position: Vec3::new(mix(p.x, q.x), mix(p.y, q.y), mix(p.z, q.z)), ..ClipVertex::default() };
    for (value, (&a, &b)) in vertex.attributes.iter_mut().zip(a.attributes.iter().zip(&b.attributes)).take(attributes) {
        let mixed = mix(a, b);
        *value = if mixed.is_finite() { hold(mixed, a, b) } else { mixed };
    }
    vertex
}

/// A power of two that brings a positive number near 1; multiplying by it rounds nothing.
fn power_of_two_near_reciprocal(x: f64) -> f64 {
    let exponent = x.to_bits() >> 52;
    f64::from_bits((2046 - exponent.min(2045)) << 52)
}

/// Undoes what rounding did to a crossing of `plane` between two `ends`: it lies between them, on the plane, and inside
/// whatever both are inside of.
fn settle(crossing: &mut Vec3, plane: Plane, ends: [Vec3; 2]) {
    let [a, b] = ends;
    *crossing = Vec3::new(hold(crossing.x, a.x, b.x), hold(crossing.y, a.y, b.y), hold(crossing.z, a.z, b.z));
    plane.snap(crossing);
    crossing.x = hold_inside(crossing.x, crossing.z, [(a.x, a.z), (b.x, b.z)]);
    crossing.y = hold_inside(crossing.y, crossing.z, [(a.y, a.z), (b.y, b.z)]);
}

/// `value`, or the nearer of `a` and `b` if it is not between them. By comparisons alone, because `f64::max` may choose
/// either zero.
fn hold(value: f64, a: f64, b: f64) -> f64 {
    let (low, high) = if a < b { (a, b) } else { (b, a) };
    match value {
        below if below < low => low,
        above if above > high => high,
        _ => value,
    }
}

/// Holds a crossing's x or y, with its w, inside each of the two side planes that both `ends` (x or y, w) are inside of, and on
/// the one that both are on.
fn hold_inside(value: f64, w: f64, ends: [(f64, f64); 2]) -> f64 {
    let mut held = value;
    for sign in [-1.0, 1.0] {
        let distances = ends.map(|(value, w)| w - sign * value);
        if distances == [0.0, 0.0] {
            return sign * w;
        }
        if distances.iter().all(|&distance| distance >= 0.0) {
            held = if sign * held > w { sign * w } else { held };
        }
    }
    held
}
