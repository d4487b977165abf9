//! Labs about functions: right ones pass, however built; mistakes as students make them are found and named.

use farop::geometry::clip::{ClipVertex, ClipVolume};
use farop::geometry::predicates::{Orientation, orientation};
use farop::grade::functions::{FUNCTION_LABS, grade_clip, grade_triangulate};
use farop::grade::labs::{Aspect, Lab};
use farop::grade::{Request, Verdict, write};
use farop::math::{Vec2, Vec3};
use farop::raster::Registry;

fn lab(name: &str) -> &'static Lab {
    FUNCTION_LABS.iter().find(|lab| lab.name == name).expect("a lab")
}

type Polygon = Vec<ClipVertex>;

fn clip_graded(clip: impl Fn(&[ClipVertex], &ClipVolume, usize) -> Polygon + Send + Sync + 'static) -> Verdict {
    let points = |aspect: &Aspect| f64::from(aspect.points);
    let request = Request { lab: lab("clip"), name: "planted".to_string(), seed: 1, points: &points };
    grade_clip(&clip, &request, &mut |_| ())
}

fn split_graded(split: impl Fn(&[Vec3], Vec3) -> Vec<[u32; 3]> + Send + Sync + 'static) -> Verdict {
    let points = |aspect: &Aspect| f64::from(aspect.points);
    let request = Request { lab: lab("triangulate"), name: "planted".to_string(), seed: 1, points: &points };
    grade_triangulate(&split, &request, &mut |_| ())
}

#[test]
fn built_in_functions_pass() {
    let registry = Registry::built_in();
    let points = |aspect: &Aspect| f64::from(aspect.points);
    for seed in [1, 2, 3] {
        let request = |name: &'static str| Request { lab: lab(name), name: name.to_string(), seed, points: &points };
        let clip = &registry.clips()[0];
        let verdict = grade_clip(&*clip.function, &request("clip"), &mut |_| ());
        assert!(verdict.is_passed() && verdict.faults.is_empty(), "{}", write::text(&verdict));
        let split = &registry.triangulations()[0];
        let verdict = grade_triangulate(&*split.function, &request("triangulate"), &mut |_| ());
        assert!(verdict.is_passed() && verdict.faults.is_empty(), "{}", write::text(&verdict));
    }
    assert!(FUNCTION_LABS.iter().all(|lab| lab.aspects.iter().map(|aspect| aspect.points).sum::<u32>() == 100));
}

fn found(verdict: &Verdict, name: &str) {
    let text = write::text(verdict);
    assert!(!verdict.is_passed(), "{name}\n{text}");
    let aspect = &verdict.aspects[verdict.faults[0].aspect];
    let witness = &aspect.answers.as_ref().expect("answers").witness;
    assert!(witness.contains("smallest case") && text.contains(witness.as_str()), "{text}");
    assert!(text.contains(&format!("docs/labs/{}.md", verdict.lab)), "{text}");
}

/// A clip by remembering the corner before, as many write it; `slip` says what went wrong.
fn clip(slip: &str, polygon: &[ClipVertex], volume: &ClipVolume, attributes: usize) -> Polygon {
    let is_out = |v: &ClipVertex| !volume.outcode(v.position).is_inside();
    let outside = polygon.iter().filter(|v| is_out(v)).count();
    match slip {
        "nothing" => return Vec::new(),
        "as it came" => return polygon.to_vec(),
        "drop partly" if outside > 0 => return Vec::new(),
        "needs corner" if outside == polygon.len() => return Vec::new(),
        "limit" if outside < polygon.len() => return polygon.iter().map(|v| limited(v, volume)).collect(),
        _ => {}
    }
    let mut kept = polygon.to_vec();
    for plane in 0..6 {
        if (slip == "no bottom" && plane == 3) || (slip == "no sides" && (1..5).contains(&plane)) {
            continue;
        }
        let given = if slip == "original" { polygon.to_vec() } else { kept.clone() };
        if given.iter().any(|v| distance(slip, v, volume, plane) < 0.0) {
            kept = step(slip, &given, volume, plane, attributes);
        }
    }
    if kept.len() < 3 || kept.iter().all(|v| v.position == kept[0].position) {
        return Vec::new();
    }
    if slip == "divides" {
        kept.iter_mut().for_each(|v| v.position /= v.position.z);
    }
    if slip == "reversed" && outside > 0 {
        kept.reverse();
    }
    kept
}

fn limited(v: &ClipVertex, volume: &ClipVolume) -> ClipVertex {
    let w = v.position.z.max(volume.hither).min(volume.yon.unwrap_or(f64::INFINITY));
    ClipVertex { position: Vec3::new(v.position.x.clamp(-w, w), v.position.y.clamp(-w, w), w), ..*v }
}

fn distance(slip: &str, v: &ClipVertex, volume: &ClipVolume, plane: usize) -> f64 {
    let Vec3 { x, y, z } = v.position;
    let side = if slip == "unit" { 1.0 } else { z };
    let hither = if slip == "hither 0" { 0.0 } else { volume.hither };
    let far = volume.yon.map_or(f64::INFINITY, |yon| yon - z);
    [z - hither, side + x, side - x, side + y, side - y, far][plane]
}

fn step(slip: &str, given: &[ClipVertex], volume: &ClipVolume, plane: usize, attributes: usize) -> Polygon {
    let mut kept: Polygon = Vec::new();
    let start = usize::from(slip == "last edge");
    for index in start..given.len() {
        let (before, now) = (&given[(index + given.len() - 1) % given.len()], &given[index]);
        // Outcodes are right, the cut is not.
        let sign = if slip == "other side" { -1.0 } else { 1.0 };
        let (from, to) = (sign * distance(slip, before, volume, plane), sign * distance(slip, now, volume, plane));
        let is_in = |distance: f64| if slip == "strict" { distance > 0.0 } else { distance >= 0.0 };
        if is_in(from) != is_in(to) && ((from != 0.0 && to != 0.0) || slip == "doubles") {
            let mut new = crossing(slip, (before, from), (now, to), attributes);
            settle(slip, &mut new.position, volume, plane);
            new.edge = if is_in(from) { farop::screen::EdgeKind::Cut } else { before.edge };
            if slip == "no marks" {
                new.edge = before.edge;
            }
            if slip != "no entering" || is_in(from) {
                kept.push(new);
            }
        } else if from == 0.0
            && to < 0.0
            && slip != "no marks"
            && let Some(last) = kept.last_mut()
        {
            last.edge = farop::screen::EdgeKind::Cut;
        }
        let is_behind_entering = is_in(to) && !is_in(from) && slip == "behind entering";
        if is_in(to) && !is_behind_entering {
            kept.push(*now);
        }
    }
    // The walk begins with the edge to the first corner: its mark comes last.
    if let (Some(first), Some(last)) = (given.first(), kept.last_mut())
        && given.last().is_some_and(|end| distance(slip, end, volume, plane) == 0.0 && last.position == end.position)
        && distance(slip, first, volume, plane) < 0.0
        && slip != "no marks"
    {
        last.edge = farop::screen::EdgeKind::Cut;
    }
    if slip == "drops last" {
        kept.pop();
    }
    kept
}

fn crossing(slip: &str, a: (&ClipVertex, f64), b: (&ClipVertex, f64), attributes: usize) -> ClipVertex {
    let ((inner, p), (outer, q)) = if a.1 > b.1 { (a, b) } else { (b, a) };
    let mix = |x: f64, y: f64| (p * y - q * x) / (p - q);
    let walk = |x: f64, y: f64| x + (y - x) * (a.1 / (a.1 - b.1));
    let from_inside = |x: f64, y: f64| x + (y - x) * (p / (p - q));
    let mut new = ClipVertex::default();
    for axis in 0..3 {
        let (x, y) = (inner.position[axis], outer.position[axis]);
        new.position[axis] = match slip {
            "walk" => walk(a.0.position[axis], b.0.position[axis]),
            "one side" => from_inside(x, y),
            "f32" => f64::from((p as f32 * y as f32 - q as f32 * x as f32) / (p as f32 - q as f32)),
            "turned" => from_inside(y, x),
            _ => mix(x, y),
        };
    }
    for number in 0..attributes {
        let (x, y) = (inner.attributes[number], outer.attributes[number]);
        new.attributes[number] = match slip {
            "copies" => a.0.attributes[number],
            "first only" if number > 0 => 0.0,
            "turned" | "other t" => from_inside(y, x),
            "screen" => {
                let t = p / (p - q);
                let (near, far) = (inner.position.z, outer.position.z);
                x + (y - x) * (t * far / (t * far + (1.0 - t) * near))
            }
            _ => mix(x, y),
        };
    }
    new
}

/// Onto the plane, and inside the planes before it.
fn settle(slip: &str, p: &mut Vec3, volume: &ClipVolume, plane: usize) {
    if matches!(slip, "no snap" | "other side" | "unit" | "turned" | "hither 0" | "f32") {
        return;
    }
    match plane {
        0 => p.z = volume.hither,
        1 => p.x = -p.z,
        2 => p.x = p.z,
        3 => (p.x, p.y) = (p.x.clamp(-p.z, p.z), -p.z),
        4 => (p.x, p.y) = (p.x.clamp(-p.z, p.z), p.z),
        _ => {
            p.z = volume.yon.unwrap_or(p.z);
            (p.x, p.y) = (p.x.clamp(-p.z, p.z), p.y.clamp(-p.z, p.z));
        }
    }
}

#[test]
fn a_clip_built_differently_passes() {
    let verdict = clip_graded(|polygon, volume, attributes| clip("", polygon, volume, attributes));
    assert!(verdict.is_passed(), "{}", write::text(&verdict));
}

#[test]
fn mistakes_of_clips_are_named() {
    let slips = [
        ("nothing", "nothing comes back"),
        ("as it came", "nothing is cut"),
        ("drop partly", "what is partly outside is dropped"),
        ("needs corner", "no corner inside: dropped"),
        ("limit", "corners are moved onto the planes"),
        ("no bottom", "bottom is not cut"),
        ("no sides", "the sides are not cut"),
        ("original", "every plane cuts the original"),
        ("divides", "divides by w"),
        ("reversed", "orientation turned"),
        ("unit", "the sides are compared with 1"),
        ("hither 0", "hither is not cut"),
        ("other side", "clips against the other side"),
        ("last edge", "the last edge is forgotten"),
        ("strict", "a corner on a plane is lost"),
        ("doubles", "a corner on a plane comes twice"),
        ("no marks", "new edges are not marked"),
        ("no entering", "no crossing where the outline enters"),
        ("behind entering", "the corner behind an entering edge is lost"),
        ("drops last", "drops the last corner"),
        ("turned", "the proportion is turned round"),
        ("walk", "cracks: computed from the end where the walk begins"),
        ("one side", "the crossing depends on the side that is kept"),
        ("no snap", "new corners miss their plane by a last place"),
        ("f32", "computed in f32"),
        ("copies", "attributes not interpolated"),
        ("first only", "only the first attribute is interpolated"),
        ("other t", "attributes mixed the other way round"),
        ("screen", "attributes mixed as on the screen"),
    ];
    let mut wrong = Vec::new();
    for (slip, name) in slips {
        let verdict = clip_graded(move |polygon, volume, attributes| clip(slip, polygon, volume, attributes));
        let names: Vec<_> = verdict.faults.iter().map(|fault| fault.name).collect();
        if names.first() != Some(&name) || names.len() > 2 || verdict.is_passed() {
            wrong.push(format!("{slip}: {names:?}, not {name}\n{}", write::text(&verdict)));
            continue;
        }
        found(&verdict, name);
    }
    assert!(wrong.is_empty(), "{} of {}\n{}", wrong.len(), slips.len(), wrong.join("\n"));
}

/// Axes that are left when the largest one of the normal is dropped; `slip` may not look.
fn flattened(slip: &str, outline: &[Vec3], normal: Vec3) -> Vec<Vec2> {
    let size = normal.abs();
    let dropped = (0..3).max_by(|&a, &b| size[a].total_cmp(&size[b])).expect("three axes");
    let dropped = if matches!(slip, "along z" | "no normal") { 2 } else { dropped };
    let (right, up) = ((dropped + 1) % 3, (dropped + 2) % 3);
    let is_behind = normal[dropped] < 0.0 && !matches!(slip, "no sign" | "no normal");
    outline.iter().map(|p| if is_behind { Vec2::new(p[up], p[right]) } else { Vec2::new(p[right], p[up]) }).collect()
}

fn turns_left(slip: &str, a: Vec2, b: Vec2, c: Vec2) -> i32 {
    let plain = (b - a).perp_dot(c - a);
    match slip {
        "epsilon" => i32::from(plain > 1e-9) - i32::from(plain < -1e-9),
        "plain" => i32::from(plain > 0.0) - i32::from(plain < 0.0),
        _ => match orientation(a, b, c) {
            Orientation::Counterclockwise => 1,
            Orientation::Collinear => 0,
            Orientation::Clockwise => -1,
        },
    }
}

fn is_between(a: Vec2, b: Vec2, p: Vec2) -> bool {
    let inside = p.cmpge(a.min(b)).all() && p.cmple(a.max(b)).all();
    inside && p != a && p != b && turns_left("", a, b, p) == 0
}

/// Not by ears: the best triangle below every diagonal, from short chains to long ones. None may turn the other way.
fn best_triangles(slip: &str, outline: &[Vec3], normal: Vec3) -> Vec<[u32; 3]> {
    const NEVER: u64 = 1 << 40;
    let (points, count) = (flattened(slip, outline, normal), outline.len());
    let touched = |i: usize, j: usize| points.iter().any(|&p| is_between(points[i], points[j], p));
    let mut best = vec![vec![(0_u64, 0_usize); count]; count];
    for length in 2..count {
        for i in 0..count - length {
            let j = i + length;
            let cost = |k: usize| {
                let turn = turns_left(slip, points[i], points[k], points[j]);
                best[i][k].0 + best[k][j].0 + u64::from(turn < 0) * NEVER + u64::from(turn == 0) * 9
            };
            let (least, k) = (i + 1..j).map(|k| (cost(k), k)).min().expect("a corner between");
            best[i][j] = (least + 3 * u64::from(touched(i, j)), k);
        }
    }
    let (mut open, mut triangles) = (vec![(0, count - 1)], Vec::new());
    while let Some((i, j)) = open.pop() {
        if j - i >= 2 {
            let k = best[i][j].1;
            triangles.push([i as u32, k as u32, j as u32]);
            open.extend([(i, k), (k, j)]);
        }
    }
    match slip {
        "last missing" => _ = triangles.pop(),
        "too many" => triangles.push(triangles[0]),
        "turned" => triangles.iter_mut().for_each(|triangle| triangle.reverse()),
        "from one" => triangles.iter_mut().for_each(|triangle| *triangle = triangle.map(|index| index + 1)),
        _ => {}
    }
    triangles
}

/// The first ear that is found is cut.
fn first_ears(slip: &str, outline: &[Vec3], normal: Vec3) -> Vec<[u32; 3]> {
    let points = flattened("", outline, normal);
    let (mut left, mut triangles): (Vec<usize>, _) = ((0..outline.len()).collect(), Vec::new());
    while left.len() > 3 {
        let around = |i: usize| [left[(i + left.len() - 1) % left.len()], left[i], left[(i + 1) % left.len()]];
        let is_free = |ear: [usize; 3]| {
            let [a, b, c] = ear.map(|index| points[index]);
            left.iter().filter(|index| !ear.map(|corner| points[corner]).contains(&points[**index])).all(|&index| {
                let p = points[index];
                let sides = [turns_left("", a, b, p), turns_left("", b, c, p), turns_left("", c, a, p)];
                sides.iter().any(|&side| if slip == "open" { side <= 0 } else { side < 0 })
            })
        };
        let is_ear = |i: &usize| {
            let ear = around(*i);
            let [a, b, c] = ear.map(|index| points[index]);
            let turn = turns_left("", a, b, c);
            let is_convex = turn > 0 || slip == "any turn" || (slip == "straight" && turn == 0);
            is_convex && (slip == "no test" || (slip == "straight" && turn == 0) || is_free(ear))
        };
        let Some(i) = (0..left.len()).find(is_ear) else { return triangles };
        let ear =
            if slip == "places" { [(i + left.len() - 1) % left.len(), i, (i + 1) % left.len()] } else { around(i) };
        triangles.push(ear.map(|index| index as u32));
        left.remove(i);
    }
    let last = if slip == "places" { [0, 1, 2] } else { [left[0], left[1], left[2]] };
    triangles.push(last.map(|index| index as u32));
    triangles
}

fn hull(outline: &[Vec3], normal: Vec3) -> Vec<[u32; 3]> {
    let points = flattened("", outline, normal);
    let least =
        |a: &usize, b: &usize| points[*a].x.total_cmp(&points[*b].x).then(points[*a].y.total_cmp(&points[*b].y));
    let start = (0..points.len()).min_by(least).expect("corners");
    let (mut ring, mut at) = (vec![start], start);
    loop {
        let is_right_of_none = |&next: &usize| {
            points[next] != points[at]
                && points.iter().all(|&p| {
                    turns_left("", points[at], points[next], p) >= 0 && !is_between(points[at], p, points[next])
                })
        };
        at = (0..points.len()).find(is_right_of_none).expect("a next corner");
        if points[at] == points[start] {
            break;
        }
        ring.push(at);
    }
    (1..ring.len() - 1).map(|k| [ring[0] as u32, ring[k] as u32, ring[k + 1] as u32]).collect()
}

fn split(slip: &str, outline: &[Vec3], normal: Vec3) -> Vec<[u32; 3]> {
    let count = outline.len() as u32;
    match slip {
        "none" => Vec::new(),
        "one" => vec![[0, 1, 2]],
        "fan" => (1..count - 1).map(|k| [0, k, k + 1]).collect(),
        "strip" => (0..count - 2)
            .map(|k| {
                if k % 2 == 0 {
                    [k / 2, k / 2 + 1, count - 1 - k / 2]
                } else {
                    [k / 2 + 1, count - 2 - k / 2, count - 1 - k / 2]
                }
            })
            .collect(),
        "hull" => hull(outline, normal),
        "any turn" | "no test" | "open" | "straight" | "places" | "first" => first_ears(slip, outline, normal),
        _ => best_triangles(slip, outline, normal),
    }
}

#[test]
fn a_triangulation_built_differently_passes() {
    let verdict = split_graded(|outline, normal| split("", outline, normal));
    assert!(verdict.is_passed(), "{}", write::text(&verdict));
}

#[test]
fn mistakes_of_triangulations_are_named() {
    let slips = [
        ("none", "nothing comes back"),
        ("one", "one triangle only"),
        ("fan", "fan from one corner: wrong for concave polygons"),
        ("strip", "strip from both ends: wrong for concave polygons"),
        ("hull", "the outline is not looked at"),
        ("last missing", "the last triangle is missing"),
        ("too many", "one triangle too many"),
        ("turned", "orientation turned"),
        ("from one", "corners counted from 1"),
        ("no normal", "the normal is not looked at"),
        ("no sign", "outlines seen from behind fail"),
        ("along z", "only x and y are looked at"),
        ("epsilon", "depends on the size"),
        ("plain", "signs in plain f64"),
        ("places", "places in the shrunken list"),
        ("any turn", "a reflex corner is cut off"),
        ("no test", "corners inside an ear are not looked for"),
        ("open", "ear test ignores corners on the diagonal"),
        ("straight", "straight corners are cut off"),
    ];
    let mut wrong = Vec::new();
    for (slip, name) in slips {
        let verdict = split_graded(move |outline, normal| split(slip, outline, normal));
        let names: Vec<_> = verdict.faults.iter().map(|fault| fault.name).collect();
        if names.first() != Some(&name) || names.len() > 2 || verdict.is_passed() {
            wrong.push(format!("{slip}: {names:?}, not {name}\n{}", write::text(&verdict)));
            continue;
        }
        found(&verdict, name);
    }
    assert!(wrong.is_empty(), "{} of {}\n{}", wrong.len(), slips.len(), wrong.join("\n"));
}

#[test]
fn a_panic_is_told_and_the_rest_is_graded() {
    let verdict = split_graded(|outline, normal| {
        assert!(outline.len() < 12, "too many for me");
        split("", outline, normal)
    });
    let text = write::text(&verdict);
    assert!(text.contains("too many for me") && verdict.earned() > 60.0 && !verdict.is_passed(), "{text}");
}
