//! Judge: what is wrong with a clip's answer.
//!
//! By what a clipped polygon is: corners inside the volume and on the polygon's plane, the exact area with the right sign, and an
//! even number of crossings around every point that is not in polygon and volume, an odd one around every point that is.

use super::{ATTRIBUTES, Answer, Asks, Case, attributes_at, exact};
use crate::geometry::clip::{ClipVertex, ClipVolume};
use crate::math::{Vec3, edges};
use crate::screen::EdgeKind;

/// What places may be off by, in sizes of the polygon.
pub(super) const NEAR: f64 = 1e-9;
/// Points a side that are asked whether they are covered.
const POINTS: usize = 14;

/// What is wrong, in one sentence.
pub(super) fn complaint(case: &Case, answer: &Answer) -> Option<String> {
    let answers = match answer {
        Ok(answers) => answers,
        Err(words) => return Some(words.clone()),
    };
    let first = &answers[0];
    let strayed = first.iter().position(|v| !v.position.is_finite());
    if let Some(corner) = strayed {
        return Some(format!("corner {corner} is not finite: {}", place(first[corner].position)));
    }
    match case.asks {
        Asks::Same => same(case, first),
        Asks::Shape => shape(case, first),
        Asks::NoDoubles => shape(case, first).or_else(|| doubles(first)),
        Asks::Attributes => shape(case, first).or_else(|| attributes(case, first)),
        Asks::Marks => shape(case, first).or_else(|| marks(case, first)),
        Asks::Neighbor => shape(case, first).or_else(|| neighbors(case, first, &answers[1])),
        Asks::OtherSide => shape(case, first).or_else(|| sides(case, first, &answers[1])),
        Asks::LastPlace => shape(case, first).or_else(|| last_places(case, first)),
    }
}

fn same(case: &Case, answer: &[ClipVertex]) -> Option<String> {
    let given = &case.inputs()[0].0;
    if answer.len() != given.len() {
        return Some(format!("{} corners came back of {} that are all inside", answer.len(), given.len()));
    }
    let bits = |v: &ClipVertex| (v.position.to_array().map(f64::to_bits), v.attributes.map(f64::to_bits));
    let changed = given.iter().zip(answer).position(|(a, b)| bits(a) != bits(b))?;
    Some(format!("all is inside, but corner {changed} has changed: {}", place(answer[changed].position)))
}

/// Names of the planes with how far inside them a point is.
pub(super) fn distances(volume: &ClipVolume, p: Vec3) -> [(&'static str, f64); 6] {
    let Vec3 { x, y, z: w } = p;
    let yon = volume.yon.map_or(f64::INFINITY, |yon| yon - w);
    let hither = w - volume.hither;
    [("hither", hither), ("left", w + x), ("right", w - x), ("bottom", w + y), ("top", w - y), ("yon", yon)]
}

fn shape(case: &Case, answer: &[ClipVertex]) -> Option<String> {
    let (right, near) = (exact::doubled_area(case), NEAR * case.size());
    let is_empty = right.iter().all(|area| area.abs() < 1e-12);
    if is_empty && answer.len() < 3 {
        return None;
    }
    let volume = case.volume();
    for (corner, vertex) in answer.iter().enumerate() {
        let outside = distances(&volume, vertex.position).into_iter().find(|(_, distance)| *distance < -near);
        if let Some((plane, distance)) = outside {
            return Some(format!(
                "corner {corner}, {}, is outside the {plane} plane by {}",
                place(vertex.position),
                short(-distance)
            ));
        }
        if off_plane(case, vertex.position) > near {
            return Some(format!("corner {corner}, {}, is not on the plane of the polygon", place(vertex.position)));
        }
    }
    if answer.len() < 3 {
        return Some(format!("{} corners came back, but a part of the polygon is inside", answer.len()));
    }
    area(case, answer, right).or_else(|| coverage(case, answer))
}

fn newell(points: &[Vec3]) -> Vec3 {
    let origin = points.first().copied().unwrap_or_default();
    edges(points).map(|(&a, &b)| (a - origin).cross(b - origin)).sum()
}

fn corners(case: &Case) -> Vec<Vec3> {
    case.inputs()[0].0.iter().map(|v| v.position).collect()
}

fn off_plane(case: &Case, p: Vec3) -> f64 {
    let corners = corners(case);
    let normal = newell(&corners);
    let length = normal.length();
    if length > 0.0 { (p - corners[0]).dot(normal).abs() / length } else { 0.0 }
}

fn area(case: &Case, answer: &[ClipVertex], right: [f64; 3]) -> Option<String> {
    let got = newell(&positions(answer));
    let right = Vec3::from_array(right);
    let near = 16.0 * NEAR * case.size() * case.size();
    if (got - right).length() <= near {
        return None;
    }
    if (got + right).length() <= near {
        return Some("the outline runs the other way round".to_string());
    }
    Some(format!("the area is {}, not {}", short(got.length() / 2.0), short(right.length() / 2.0)))
}

fn positions(answer: &[ClipVertex]) -> Vec<Vec3> {
    answer.iter().map(|v| v.position).collect()
}

/// Points of the polygon's plane that are covered and should not be, or the other way.
fn coverage(case: &Case, answer: &[ClipVertex]) -> Option<String> {
    let (given, got, volume) = (corners(case), positions(answer), case.volume());
    let normal = newell(&given);
    let dropped = (0..3).max_by(|&a, &b| normal[a].abs().total_cmp(&normal[b].abs())).unwrap_or(2);
    let (u, v) = ((dropped + 1) % 3, (dropped + 2) % 3);
    let (low, high) = given.iter().fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(l, h), &p| (l.min(p), h.max(p)));
    let step =
        |axis: usize, index: usize| low[axis] + (high[axis] - low[axis]) * (index as f64 + 0.437) / POINTS as f64;
    for index in 0..POINTS * POINTS {
        let mut p = Vec3::ZERO;
        (p[u], p[v]) = (step(u, index / POINTS), step(v, index % POINTS));
        p[dropped] =
            given[0][dropped] - ((p[u] - given[0][u]) * normal[u] + (p[v] - given[0][v]) * normal[v]) / normal[dropped];
        let inside = distances(&volume, p).iter().fold(f64::INFINITY, |least, (_, distance)| least.min(*distance));
        let near = 1e-6 * case.size();
        // Points at an outline or a plane say nothing.
        if inside.abs() < near || near_outline(&given, p, near) || near_outline(&got, p, near) {
            continue;
        }
        let expected = inside > 0.0 && is_odd(&given, p, (u, v));
        if is_odd(&got, p, (u, v)) != expected {
            let words = if expected { "is not covered and should be" } else { "is covered and should not be" };
            return Some(format!("the area is right, but {} {words}", place(p)));
        }
    }
    None
}

fn near_outline(outline: &[Vec3], p: Vec3, near: f64) -> bool {
    edges(outline).any(|(&a, &b)| from_edge(a, b, p) < near)
}

/// How far a point is from an edge.
fn from_edge(a: Vec3, b: Vec3, p: Vec3) -> f64 {
    let along = b - a;
    let length = along.length_squared();
    let t = if length > 0.0 { ((p - a).dot(along) / length).clamp(0.0, 1.0) } else { 0.0 };
    (p - (a + along * t)).length()
}

fn is_odd(outline: &[Vec3], p: Vec3, (u, v): (usize, usize)) -> bool {
    let crosses = |a: Vec3, b: Vec3| {
        (a[v] > p[v]) != (b[v] > p[v]) && p[u] < a[u] + (b[u] - a[u]) * (p[v] - a[v]) / (b[v] - a[v])
    };
    edges(outline).filter(|&(&a, &b)| crosses(a, b)).count() % 2 == 1
}

fn doubles(answer: &[ClipVertex]) -> Option<String> {
    let twice = edges(answer).position(|(a, b)| a.position == b.position)?;
    Some(format!("corners {twice} and {} are the same, {}", (twice + 1) % answer.len(), place(answer[twice].position)))
}

fn attributes(case: &Case, answer: &[ClipVertex]) -> Option<String> {
    let near = 16.0 * NEAR * case.size();
    answer.iter().enumerate().find_map(|(corner, vertex)| {
        let right = attributes_at(vertex.position);
        // What is not a number is off, too.
        let is_near = |&number: &usize| (vertex.attributes[number] - right[number]).abs() <= near;
        let off = (0..ATTRIBUTES).find(|number| !is_near(number))?;
        Some(format!(
            "corner {corner}, {}: attribute {off} is {}, not {}",
            place(vertex.position),
            short(vertex.attributes[off]),
            short(right[off])
        ))
    })
}

/// An edge of the answer is as it was where it runs along an edge of the polygon; else clipping made it.
fn marks(case: &Case, answer: &[ClipVertex]) -> Option<String> {
    let (given, near) = (corners(case), 16.0 * NEAR * case.size());
    edges(answer).enumerate().find_map(|(number, (a, b))| {
        if a.position == b.position {
            return None;
        }
        let is_old =
            edges(&given).any(|(&p, &q)| from_edge(p, q, a.position) < near && from_edge(p, q, b.position) < near);
        let right = if is_old { EdgeKind::Original } else { EdgeKind::Cut };
        (a.edge != right).then(|| {
            format!(
                "the edge from corner {number}, {}, to the next is marked {:?}, not {right:?}",
                place(a.position),
                a.edge
            )
        })
    })
}

/// Bits of the points on the first edge, in order.
fn on_edge(case: &Case, answer: &[ClipVertex]) -> Vec<[u64; 3]> {
    let (given, near) = (corners(case), NEAR * case.size());
    let is_on = |v: &&ClipVertex| from_edge(given[0], given[1], v.position) < near;
    sorted(answer.iter().filter(is_on))
}

fn sorted<'a>(vertices: impl Iterator<Item = &'a ClipVertex>) -> Vec<[u64; 3]> {
    // Adding 0 makes -0 the same as 0.
    let mut bits: Vec<_> = vertices.map(|v| v.position.to_array().map(|x| (x + 0.0).to_bits())).collect();
    bits.sort_unstable();
    bits.dedup();
    bits
}

fn neighbors(case: &Case, answer: &[ClipVertex], other: &[ClipVertex]) -> Option<String> {
    different(&on_edge(case, answer), &on_edge(case, other), "the neighbor, who walks the edge the other way, has")
}

fn different(one: &[[u64; 3]], two: &[[u64; 3]], who: &str) -> Option<String> {
    let at = one.iter().zip(two).position(|(a, b)| a != b);
    let point = |bits: [u64; 3]| digits(Vec3::from_array(bits.map(f64::from_bits)));
    match at {
        Some(at) => Some(format!("a common point is {}, and {who} {}", point(one[at]), point(two[at]))),
        None if one.len() == two.len() => None,
        None => Some(format!("{} points are on the common edge, and {who} {}", one.len(), two.len())),
    }
}

fn sides(case: &Case, before: &[ClipVertex], behind: &[ClipVertex]) -> Option<String> {
    let yon = case.yon.map_or(0.0, super::units);
    let on_plane = |answer: &[ClipVertex]| {
        let near = NEAR * case.size();
        sorted(answer.iter().filter(|v| (v.position.z - yon).abs() < near))
    };
    let other = Case { hither: case.yon.unwrap_or(case.hither), yon: None, asks: Asks::Shape, ..case.clone() };
    let who = "the part behind the plane has";
    shape(&other, behind)
        .map(|words| format!("behind the plane: {words}"))
        .or_else(|| different(&on_plane(before), &on_plane(behind), who))
}

fn last_places(case: &Case, answer: &[ClipVertex]) -> Option<String> {
    let volume = case.volume();
    answer.iter().enumerate().find_map(|(corner, vertex)| {
        let (plane, distance) =
            distances(&volume, vertex.position).into_iter().find(|(_, distance)| *distance < 0.0)?;
        Some(format!("corner {corner}, {}, is outside the {plane} plane by {:e}", digits(vertex.position), -distance))
    })
}

/// The question and the answer for a reader.
pub(super) fn show(case: &Case, answer: &Answer, complaint: &str) -> String {
    let volume = case.volume();
    let yon = volume.yon.map_or("none".to_string(), short);
    let list = |points: &[Vec3]| points.iter().map(|&p| place(p)).collect::<Vec<_>>().join(" ");
    let mut text = format!(
        "  smallest case: {} corners (x, y, w), hither {}, yon {yon}\n    given:  {}\n",
        case.corners.len(),
        short(volume.hither),
        list(&corners(case))
    );
    if let Some(apex) = case.apex {
        text += &format!("    and the neighbor beyond the first edge, with {}\n", place(super::vertex(apex).position));
    }
    let right = super::mutants::right(case);
    let answer = answer.as_ref().map(|answers| list(&positions(&answers[0]))).unwrap_or_default();
    let named = |list: String| if list.is_empty() { "nothing".to_string() } else { list };
    text += &format!(
        "    answer: {}\n    right:  {}\n    wrong:  {complaint}\n",
        named(answer),
        named(list(&positions(&right)))
    );
    text
}

fn place(p: Vec3) -> String {
    format!("({}, {}, {})", short(p.x), short(p.y), short(p.z))
}

/// A number with four places, fewer where they are 0.
fn short(x: f64) -> String {
    let text = format!("{x:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_string()
}

/// A place with all its digits: the last ones matter.
fn digits(p: Vec3) -> String {
    format!("({:?}, {:?}, {:?})", p.x, p.y, p.z)
}
