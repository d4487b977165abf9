//! Mutants: a clip with one rule changed, to give wrong answers their names.

use super::{ATTRIBUTES, Case};
use crate::geometry::clip::{ClipVertex, ClipVolume};
use crate::grade::functions::clip::judge::distances;
use crate::math::edges;
use crate::screen::EdgeKind;

/// What happens to polygons partly outside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Partly {
    Cut,
    Dropped,
    Kept,
    /// Dropped when no corner is inside.
    NeedsCorner,
}

/// What a step puts out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Emits {
    All,
    NoLeaving,
    NoEntering,
    NoCrossing,
    /// Not the corner behind an entering crossing.
    NotBehindEntering,
    NotFirst,
    NotLast,
    /// The same for those who put each edge's end, not its start: the walk begins with the edge to the first corner.
    NotLastEnd,
}

/// The edges that are walked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Edges {
    All,
    /// Without the last, which runs to the first corner.
    NotLast,
    /// The same for those who put each edge's end: the first corner is lost.
    NotLastNorFirstCorner,
}

/// The value at a new corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Mixed {
    Right,
    Inner,
    Outer,
    /// That of the end where the walk begins; of the other.
    Start,
    End,
    Middle,
    Nothing,
    /// The proportion of the other end.
    Turned,
    /// The first number only, the others of the inner end, or nothing.
    FirstThenInner,
    FirstThenNothing,
    /// By the proportion on the screen.
    Screen,
}

/// The mark of edges.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Marks {
    Right,
    None,
    /// On the edge that leads to the crossing, not on the one from it.
    Before,
    /// On edges from both crossings.
    Both,
    Entering,
}

/// The rules of a clip.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rules {
    pub turned_sides: bool,
    /// This plane's, the others are right.
    pub turned_plane: Option<usize>,
    pub skipped: Option<usize>,
    pub only_first_plane: bool,
    pub all_sides_skipped: bool,
    /// x and y are compared with 1.
    pub unit_sides: bool,
    pub partly: Partly,
    pub edges: Edges,
    pub emits: Emits,
    pub position: Mixed,
    pub attributes: Mixed,
    pub marks: Marks,
    pub each_from_original: bool,
    pub clamps: bool,
    pub reversed: bool,
    pub divides: bool,
    pub empties: bool,
    pub untouched: bool,
    /// A corner on a plane is outside.
    pub strict: bool,
}

/// The right ones.
pub(super) const RIGHT: Rules = Rules {
    turned_sides: false,
    turned_plane: None,
    skipped: None,
    only_first_plane: false,
    all_sides_skipped: false,
    unit_sides: false,
    partly: Partly::Cut,
    edges: Edges::All,
    emits: Emits::All,
    position: Mixed::Right,
    attributes: Mixed::Right,
    marks: Marks::Right,
    each_from_original: false,
    clamps: false,
    reversed: false,
    divides: false,
    empties: false,
    untouched: false,
    strict: false,
};

/// The right answer, up to rounding.
pub(super) fn right(case: &Case) -> Vec<ClipVertex> {
    let (polygon, volume) = &case.inputs()[0];
    clip(&RIGHT, polygon, volume)
}

/// Clips by `rules`.
pub(super) fn clip(rules: &Rules, polygon: &[ClipVertex], volume: &ClipVolume) -> Vec<ClipVertex> {
    if rules.empties {
        return Vec::new();
    }
    let is_inside = |v: &&ClipVertex| (0..6).all(|plane| distance(&RIGHT, volume, plane, v) >= 0.0);
    let inside = polygon.iter().filter(is_inside).count();
    let mut kept = match rules.partly {
        _ if rules.untouched => polygon.to_vec(),
        Partly::Dropped if inside < polygon.len() => Vec::new(),
        Partly::Kept if inside > 0 => polygon.to_vec(),
        Partly::NeedsCorner if inside == 0 => Vec::new(),
        _ if rules.clamps && inside > 0 => polygon.iter().map(|v| clamped(v, volume)).collect(),
        _ => planes(rules, polygon, volume),
    };
    if rules.divides {
        kept.iter_mut().for_each(|v| v.position /= v.position.z);
    }
    if rules.reversed && inside < polygon.len() {
        kept.reverse();
    }
    kept
}

fn planes(rules: &Rules, polygon: &[ClipVertex], volume: &ClipVolume) -> Vec<ClipVertex> {
    let mut kept = polygon.to_vec();
    for plane in 0..6 {
        let skipped = rules.skipped == Some(plane) || (rules.all_sides_skipped && (1..5).contains(&plane));
        let from = if rules.each_from_original { polygon.to_vec() } else { kept.clone() };
        let is_cut = from.iter().any(|v| distance(rules, volume, plane, v) < 0.0);
        if skipped || !is_cut {
            continue;
        }
        kept = step(rules, &from, volume, plane);
        if rules.only_first_plane {
            break;
        }
    }
    // What has no area inside is nothing.
    if kept.len() < 3 { Vec::new() } else { kept }
}

fn distance(rules: &Rules, volume: &ClipVolume, plane: usize, v: &ClipVertex) -> f64 {
    let mut p = v.position;
    if rules.unit_sides && (1..5).contains(&plane) {
        p.z = 1.0;
    }
    let distance = distances(volume, p)[plane].1;
    if rules.turned_plane == Some(plane) && distance.is_finite() { -distance } else { distance }
}

fn step(rules: &Rules, polygon: &[ClipVertex], volume: &ClipVolume, plane: usize) -> Vec<ClipVertex> {
    let mut kept = Vec::new();
    let sign = if rules.turned_sides { -1.0 } else { 1.0 };
    let at = |v: &ClipVertex| sign * distance(rules, volume, plane, v);
    let is_inside = |distance: f64| if rules.strict { distance > 0.0 } else { distance >= 0.0 };
    let last = polygon.len() - 1;
    let mut entered = !is_inside(at(&polygon[last])) && is_inside(at(&polygon[0]));
    let edge_count = polygon.len() - usize::from(rules.edges == Edges::NotLast);
    for (number, (a, b)) in edges(polygon).enumerate().take(edge_count) {
        let (at_a, at_b) = (at(a), at(b));
        let (inside_a, inside_b) = (is_inside(at_a), is_inside(at_b));
        let leaves = inside_a && !inside_b;
        let loses_first = rules.emits == Emits::NotFirst || rules.edges == Edges::NotLastNorFirstCorner;
        let lost = (rules.emits == Emits::NotBehindEntering && entered) || (loses_first && number == 0);
        entered = !inside_a && inside_b;
        if inside_a && !lost {
            let made = leaves && at_a == 0.0 && rules.marks == Marks::Right;
            kept.push(ClipVertex { edge: if made { EdgeKind::Cut } else { a.edge }, ..*a });
        }
        let is_put = match rules.emits {
            Emits::NoLeaving => !leaves,
            Emits::NoEntering => leaves,
            Emits::NoCrossing => false,
            _ => rules.edges == Edges::All || number < last,
        };
        if inside_a != inside_b && is_put && at_a != 0.0 && at_b != 0.0 {
            let mut crossing = between(rules, (a, at_a), (b, at_b), leaves);
            let (after_leaving, after_entering) = match rules.marks {
                Marks::Right => (EdgeKind::Cut, a.edge),
                Marks::None => (a.edge, a.edge),
                Marks::Both => (EdgeKind::Cut, EdgeKind::Cut),
                Marks::Before | Marks::Entering => (a.edge, EdgeKind::Cut),
            };
            crossing.edge = if leaves { after_leaving } else { after_entering };
            if leaves
                && rules.marks == Marks::Before
                && let Some(last) = kept.last_mut()
            {
                last.edge = EdgeKind::Cut;
            }
            kept.push(crossing);
        }
    }
    if rules.emits == Emits::NotLast {
        kept.pop();
    }
    if rules.emits == Emits::NotLastEnd {
        // In that order the crossing of the last edge stands first.
        let crosses = is_inside(at(&polygon[last])) != is_inside(at(&polygon[0]));
        let by = usize::from(crosses).min(kept.len());
        kept.rotate_right(by);
        kept.pop();
    }
    kept
}

fn between(rules: &Rules, (a, at_a): (&ClipVertex, f64), (b, at_b): (&ClipVertex, f64), leaves: bool) -> ClipVertex {
    let ((inner, p), (outer, q)) = if leaves { ((a, at_a), (b, at_b)) } else { ((b, at_b), (a, at_a)) };
    let mix = |kind: Mixed, number: usize, inner_value: f64, outer_value: f64| {
        let blend = |t: f64| inner_value + (outer_value - inner_value) * t;
        let t = p / (p - q);
        // The same bits from both ends and both sides.
        let exact = (p * outer_value - q * inner_value) / (p - q);
        match kind {
            Mixed::Inner => inner_value,
            Mixed::FirstThenInner if number > 0 => inner_value,
            Mixed::Nothing => 0.0,
            Mixed::FirstThenNothing if number > 0 => 0.0,
            Mixed::Outer => outer_value,
            Mixed::Start => {
                if leaves {
                    inner_value
                } else {
                    outer_value
                }
            }
            Mixed::End => {
                if leaves {
                    outer_value
                } else {
                    inner_value
                }
            }
            Mixed::Middle => blend(0.5),
            Mixed::Turned => blend(1.0 - t),
            // x / w goes from end to end by this part of the way.
            Mixed::Screen => blend(t * outer.position.z / (t * outer.position.z + (1.0 - t) * inner.position.z)),
            Mixed::Right | Mixed::FirstThenInner | Mixed::FirstThenNothing => exact,
        }
    };
    let mut vertex = ClipVertex::default();
    for axis in 0..3 {
        vertex.position[axis] = mix(rules.position, axis, inner.position[axis], outer.position[axis]);
    }
    for number in 0..ATTRIBUTES {
        let kind = if rules.position == Mixed::Right { rules.attributes } else { rules.position };
        vertex.attributes[number] = mix(kind, number, inner.attributes[number], outer.attributes[number]);
    }
    vertex
}

/// A corner moved onto the planes that it is outside of.
fn clamped(v: &ClipVertex, volume: &ClipVolume) -> ClipVertex {
    let mut p = v.position;
    p.z = p.z.max(volume.hither).min(volume.yon.unwrap_or(f64::INFINITY));
    (p.x, p.y) = (p.x.clamp(-p.z, p.z), p.y.clamp(-p.z, p.z));
    ClipVertex { position: p, ..*v }
}
