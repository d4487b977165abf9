//! Clip: the two sides of an edge are cut in the same points; nothing is left outside a plane; no area is lost.
//!
//! Two triangles walk one edge in opposite directions. The first attribute is 0 along it and 1 at either apex, so cut vertices
//! with a 0 are points of the edge: both sides must have the same ones, bit for bit. Where one side has no area inside there is
//! nothing to compare. The area is judged by a second clip on homogeneous big integers, which rounds nothing and shares nothing
//! with `geometry::clip` but the six inequalities.
//!
//! Space: clip space (x, y, w). Coordinates of the area's judge are whole numbers of 2^-20.

use super::tally::{Tally, sum};
use super::{Effort, Random, Report};
use crate::geometry::clip::{ClipVertex, ClipVolume, Clipped, Clipper};
use crate::math::{Vec3, edges, pow};
use num_bigint::BigInt;

/// Edges a part.
const PART: u64 = 10_000;

/// Cuts pairs of triangles, and polygons whose exact area is known.
pub(super) fn run(effort: &Effort, report: &mut Report) {
    let (parts, polygons) = (effort.count(200, 10_000), effort.count(4_000, 200_000));
    let mut tally = sum(parts, |number, tally| {
        let (mut random, mut clippers) = (effort.random(number), [Clipper::default(), Clipper::default()]);
        (0..PART).for_each(|_| neighbors(&mut random, &mut clippers, tally));
    });
    tally.append(sum(polygons, |number, tally| area(&mut effort.random(1 << 40 | number), tally)));
    report.count("pairs of neighbors", parts * PART);
    report.count("shared edges with an end in the volume or through it", tally.of("seen"));
    report.some("points where a plane cuts a shared edge", tally.of("cuts"));
    report.some("corners exactly on a plane", tally.of("on a plane"));
    report.count("pairs of which one side has no area inside", tally.of("one side"));
    report.none("shared edges cut in different points", tally.of("different"));
    report.none("vertices outside a plane", tally.of("outside"));
    report.count("polygons whose area is compared with the exact clip", polygons);
    report.some("of them concave", tally.of("concave"));
    report.some("of them with 5 or more corners after clipping", tally.of("many corners"));
    report.none("areas off by more than 4 n units in the last place", tally.of("area"));
    report.none("areas before and behind a plane that do not add up", tally.of("complement"));
    tally.examples.iter().for_each(|example| report.miss(example));
}

fn volume(random: &mut Random) -> ClipVolume {
    let hither = [1.0, 0.25, 1e-6, 3.0][random.below(4) as usize];
    ClipVolume { hither, yon: [None, Some(4.0), Some(7.5)][random.below(3) as usize] }
}

/// A point anywhere around the volume, behind the eye, too; some on its planes, some of another size.
fn point(random: &mut Random, volume: &ClipVolume, tally: &mut Tally) -> Vec3 {
    let mut along = |low: f64, high: f64| random.between(low, high);
    let mut point = Vec3::new(along(-6.0, 6.0), along(-6.0, 6.0), along(-2.0, 9.0));
    let on_plane = random.below(24);
    match on_plane {
        0 => point.x = point.z,
        1 => point.y = -point.z,
        2 => point.z = volume.hither,
        3 => point.z = volume.yon.unwrap_or(volume.hither),
        4 => return point * pow(2.0, random.between(-40.0, 40.0)),
        _ => return point,
    }
    tally.add("on a plane", 1);
    point
}

fn vertex(position: Vec3, apex: f64) -> ClipVertex {
    let mut vertex = ClipVertex { position, ..ClipVertex::default() };
    vertex.attributes[0] = apex;
    vertex
}

fn left<'a>(clipper: &'a mut Clipper, polygon: &'a [ClipVertex], volume: &ClipVolume) -> &'a [ClipVertex] {
    match clipper.clip(polygon, volume, 1) {
        Clipped::Inside => polygon,
        Clipped::Cut(vertices) => vertices,
        Clipped::Outside | Clipped::NotFinite => &[],
    }
}

fn neighbors(random: &mut Random, clippers: &mut [Clipper; 2], tally: &mut Tally) {
    let volume = volume(random);
    let [a, b, c, d] = std::array::from_fn(|_| point(random, &volume, tally));
    let triangles =
        [[vertex(a, 0.0), vertex(b, 0.0), vertex(c, 1.0)], [vertex(b, 0.0), vertex(a, 0.0), vertex(d, 1.0)]];
    let [one, other] = clippers;
    let sides = [left(one, &triangles[0], &volume), left(other, &triangles[1], &volume)];
    let outside = sides.iter().flat_map(|side| *side).filter(|v| !volume.outcode(v.position).is_inside());
    tally.add("outside", outside.count() as u64);
    if sides.iter().any(|side| side.is_empty()) {
        tally.add("one side", u64::from(sides.iter().any(|side| !side.is_empty())));
        return;
    }
    let [mut points, mut others] = sides.map(|side| {
        let on_edge = side.iter().filter(|v| v.attributes[0] == 0.0);
        on_edge.map(|v| v.position.to_array().map(f64::to_bits)).collect::<Vec<_>>()
    });
    points.sort_unstable();
    others.sort_unstable();
    points.dedup();
    others.dedup();
    let ends = [a, b].map(|end| end.to_array().map(f64::to_bits));
    tally.add("seen", u64::from(!points.is_empty()));
    tally.add("cuts", points.iter().filter(|point| !ends.contains(point)).count() as u64);
    if points != others {
        tally.add("different", 1);
        tally.example(|| format!("the edge from {a} to {b} is cut otherwise for {c} and {d} in {volume:?}"));
    }
}

/// A point without rounding: (x, y, w) / d, d > 0.
#[derive(Clone)]
struct Exact {
    place: [BigInt; 3],
    divisor: BigInt,
}

/// Binary places of whole coordinates.
const PLACES: i32 = 20;
/// Binary places that areas are summed with.
const FINE: usize = 220;

/// A polygon of whole coordinates on a plane w = constant or a tilted one, clipped both ways.
fn area(random: &mut Random, tally: &mut Tally) {
    let corners = 3 + random.below(5);
    let mut whole = |end: u64| random.below(2 * end) as i64 - end as i64;
    let tilt = [whole(3), whole(3)];
    let outline: Vec<[i64; 3]> = (0..corners)
        .map(|_| {
            // Multiples of 8, so that corners are exactly on one plane.
            let (x, y) = (8 * whole(3 << (PLACES - 2)), 8 * whole(3 << (PLACES - 2)));
            [x, y, (4 << PLACES) + (tilt[0] * x + tilt[1] * y) / 8]
        })
        .collect();
    let volume = ClipVolume { hither: 1.0, yon: Some(5.0) };
    let polygon: Vec<ClipVertex> = outline.iter().map(|p| vertex(Vec3::from_array(p.map(scaled)), 0.0)).collect();
    let signs = edges(&outline).zip(edges(&outline).skip(1)).map(|((a, b), (_, c))| {
        (b[0] - a[0]) as i128 * (c[1] - b[1]) as i128 - (b[1] - a[1]) as i128 * (c[0] - b[0]) as i128 > 0
    });
    let lefts = signs.filter(|&sign| sign).count() as u64;
    tally.add("concave", u64::from(lefts > 0 && lefts + 1 < corners));
    let mut clipper = Clipper::default();
    let kept = left(&mut clipper, &polygon, &volume);
    tally.add("many corners", u64::from(kept.len() >= 5));
    let exact = clip_exactly(&outline, &volume);
    // A unit in the last place of the square of the largest coordinate.
    let unit = 64.0 * f64::EPSILON;
    let most = 4.0 * (kept.len().max(exact.len()) as f64) * unit;
    let difference = difference(&doubled_area(&exact), &doubled_area(&rounded(kept)));
    if difference > most {
        tally.add("area", 1);
        tally.example(|| format!("the area of {outline:?} is off by {difference:.3e}"));
    }
    // What lies before and what lies behind a plane across the middle are the whole.
    let [before, behind] = [(1.0, Some(3.0)), (3.0, Some(5.0))].map(|(hither, yon)| {
        let mut clipper = Clipper::default();
        doubled_area(&rounded(left(&mut clipper, &polygon, &ClipVolume { hither, yon })))
    });
    let together = [&before[0] + &behind[0], &before[1] + &behind[1], &before[2] + &behind[2]];
    if self::difference(&together, &doubled_area(&rounded(kept))) > 3.0 * most.max(32.0 * unit) {
        tally.add("complement", 1);
    }
}

fn scaled(whole: i64) -> f64 {
    whole as f64 * pow(2.0, f64::from(-PLACES))
}

/// Cuts at hither, the four sides and yon.
fn clip_exactly(outline: &[[i64; 3]], volume: &ClipVolume) -> Vec<Exact> {
    let mut polygon: Vec<Exact> =
        outline.iter().map(|p| Exact { place: p.map(BigInt::from), divisor: BigInt::from(1) }).collect();
    let whole = |w: f64| BigInt::from((w * pow(2.0, f64::from(PLACES))) as i64);
    let (hither, yon) = (whole(volume.hither), whole(volume.yon.unwrap_or(1e6)));
    // Signed distance from each plane, times the divisor.
    let planes: [&dyn Fn(&Exact) -> BigInt; 6] = [
        &|p| &p.place[2] - &hither * &p.divisor,
        &|p| &p.place[2] + &p.place[0],
        &|p| &p.place[2] - &p.place[0],
        &|p| &p.place[2] + &p.place[1],
        &|p| &p.place[2] - &p.place[1],
        &|p| &yon * &p.divisor - &p.place[2],
    ];
    let zero = BigInt::from(0);
    for distance in planes {
        let mut kept = Vec::new();
        for (a, b) in edges(&polygon) {
            let (da, db) = (distance(a), distance(b));
            if da >= zero {
                kept.push(a.clone());
            }
            if (da < zero) != (db < zero) {
                kept.push(crossing((a, &da), (b, &db)));
            }
        }
        polygon = kept;
    }
    polygon
}

/// Where a -> b meets the plane that they are da and db (times their divisors) from.
fn crossing((a, da): (&Exact, &BigInt), (b, db): (&Exact, &BigInt)) -> Exact {
    let divisor = da * &b.divisor - db * &a.divisor;
    let place = std::array::from_fn(|axis| da * &b.place[axis] - db * &a.place[axis]);
    if divisor < BigInt::from(0) {
        return Exact { place: place.map(|x: BigInt| -x), divisor: -divisor };
    }
    Exact { place, divisor }
}

/// Vertices in `f64` as the exact numbers that they are.
fn rounded(vertices: &[ClipVertex]) -> Vec<Exact> {
    // 2^-100 is finer than any last place of coordinates that are not tiny; what is tiny is cut off by less than that.
    let exact =
        |v: &ClipVertex| Exact { place: v.position.to_array().map(fixed), divisor: BigInt::from(1) << (100 - PLACES) };
    vertices.iter().map(exact).collect()
}

fn fixed(x: f64) -> BigInt {
    let (bits, exponent) = (x.to_bits(), (x.to_bits() >> 52 & 0x7FF) as i32 - 1075 + 100);
    let mantissa = BigInt::from(bits & ((1 << 52) - 1) | u64::from(x != 0.0) << 52);
    let magnitude =
        if exponent >= 0 { mantissa << exponent as usize } else { mantissa >> exponent.unsigned_abs() as usize };
    if x < 0.0 { -magnitude } else { magnitude }
}

/// The doubled area on each pair of axes, in 2^-FINE.
fn doubled_area(polygon: &[Exact]) -> [BigInt; 3] {
    std::array::from_fn(|axis| {
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        edges(polygon).fold(BigInt::from(0), |sum, (a, b)| {
            let cross = &a.place[u] * &b.place[v] - &a.place[v] * &b.place[u];
            sum + (cross << FINE) / (&a.divisor * &b.divisor)
        })
    })
}

/// The largest difference, in squares of a unit.
fn difference(a: &[BigInt; 3], b: &[BigInt; 3]) -> f64 {
    let places = FINE + 2 * PLACES as usize;
    let off = a.iter().zip(b).map(|(a, b)| {
        // Down to 2^-80 what matters is whole.
        let rest: BigInt = (a - b) >> (places - 80);
        rest.to_string().parse::<f64>().unwrap_or(f64::INFINITY).abs() * pow(2.0, -80.0)
    });
    off.fold(0.0, f64::max)
}
