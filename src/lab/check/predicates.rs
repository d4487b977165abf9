//! Predicates: the turn of three points against whole numbers wide enough for every product.
//!
//! The judge: a finite `f64` is m 2^e. The exponents of the six coordinates are brought to the least one among them and the determinant is
//! summed in big integers, with plain school multiplication; it shares nothing with `geometry::predicates` but the definition.

use super::{Effort, Random, Report};
use crate::geometry::predicates::{Orientation, orientation};
use crate::math::{Vec2, pow};
use num_bigint::{BigInt, Sign};
use std::time::Instant;

/// Draws points of every kind and compares the signs.
pub(super) fn run(effort: &Effort, report: &mut Report) {
    let cases = effort.count(200_000, 100_000_000);
    let judged = effort.count(200_000, 3_000_000);
    let mut random = effort.random(1);
    let (mut wrong, mut collinear, mut extreme) = (0, 0, 0);
    for case in 0..cases {
        let (points, expected) = if case < judged {
            let points = adversarial(&mut random);
            (points, judge(points))
        } else {
            // Beyond what the slow judge can do: points whose turn is known by how they were made.
            known(&mut random)
        };
        let [a, b, c] = points;
        collinear += u64::from(expected == 0);
        let sizes = points.iter().flat_map(|point| [point.x.abs(), point.y.abs()]);
        extreme += u64::from(sizes.clone().any(|size| size > 1e155 || (size > 0.0 && size < 1e-155)));
        let signs = [orientation(a, b, c), orientation(b, c, a), orientation(b, a, c)].map(sign);
        wrong += u64::from(signs != [expected, expected, -expected]);
    }
    report.count("triples of points", cases);
    report.count("of them against big integers", judged);
    report.some("collinear triples", collinear);
    report.some("coordinates beyond 1e155 or below 1e-155", extreme);
    report.none("wrong signs", wrong);
    // Informs only: a busy machine must not decide whether a claim holds.
    report.measure("time as a multiple of the plain formula", slowdown(effort));
}

fn sign(orientation: Orientation) -> i32 {
    match orientation {
        Orientation::Clockwise => -1,
        Orientation::Collinear => 0,
        Orientation::Counterclockwise => 1,
    }
}

/// The sign by big integers.
fn judge([a, b, c]: [Vec2; 3]) -> i32 {
    let coordinates = [a.x, a.y, b.x, b.y, c.x, c.y];
    let least = coordinates.iter().map(|&x| parts(x).1).min().unwrap_or(0);
    let whole = coordinates.map(|x| {
        let (mantissa, exponent) = parts(x);
        BigInt::from(mantissa) << (exponent - least) as usize
    });
    let [ax, ay, bx, by, cx, cy] = whole;
    let determinant = (ax - &cx) * (by - &cy) - (ay - &cy) * (bx - &cx);
    match determinant.sign() {
        Sign::Minus => -1,
        Sign::NoSign => 0,
        Sign::Plus => 1,
    }
}

/// x = mantissa 2^exponent.
fn parts(x: f64) -> (i64, i32) {
    let bits = x.to_bits();
    let (fraction, exponent) = ((bits & ((1 << 52) - 1)) as i64, (bits >> 52 & 0x7FF) as i32);
    let mantissa = if exponent == 0 { fraction } else { fraction | 1 << 52 };
    (if x < 0.0 { -mantissa } else { mantissa }, exponent.max(1) - 1075)
}

/// Points that rounding gets wrong: any bits, meeting extremes, nearly and exactly collinear.
fn adversarial(random: &mut Random) -> [Vec2; 3] {
    match random.below(4) {
        0 => std::array::from_fn(|_| Vec2::new(any_finite(random), any_finite(random))),
        1 => std::array::from_fn(|_| Vec2::new(extreme(random), extreme(random))),
        2 => {
            let scale = [1.0, 1e-300, 1e300, 1e-155, 1e155, 1e-320][random.below(6) as usize];
            let mut point = || Vec2::new(random.unit(), random.unit()) * scale;
            let (a, b) = (point(), point());
            let between = a + (b - a) * (random.below(1025) as f64 / 1024.0);
            [a, b, Vec2::new(nudged(between.x, random), nudged(between.y, random))]
        }
        _ => {
            let mut whole = |end| Vec2::new(random.below(end) as f64, random.below(end) as f64);
            let (origin, step) = (whole(1 << 40), whole(1 << 20));
            let off = Vec2::X * (random.below(3) as f64 - 1.0);
            [origin, origin + step * 12_345.0, origin + step * 98_765.0 + off]
        }
    }
}

fn any_finite(random: &mut Random) -> f64 {
    let x = f64::from_bits(random.bits());
    if x.is_finite() { x } else { any_finite(random) }
}

fn extreme(random: &mut Random) -> f64 {
    let scales = [5e-324, 1e-310, 1e-300, 1e-170, 1e-155, 1.0, 1e155, 1e170, 1e300, f64::MAX / 16.0];
    let factors = [0.0, -0.0, 1.0, -1.0, 3.0, -5.0, 16.0, 1.0 + f64::EPSILON];
    scales[random.below(10) as usize] * factors[random.below(8) as usize]
}

/// At most two last places away.
fn nudged(x: f64, random: &mut Random) -> f64 {
    let moved = f64::from_bits(x.to_bits().wrapping_add(random.below(5)).wrapping_sub(2));
    if moved.is_finite() { moved } else { x }
}

/// A triangle whose turn follows from its making: whole numbers below 2^50, scaled by a power of two, by `i128`.
fn known(random: &mut Random) -> ([Vec2; 3], i32) {
    let mut whole = || [random.below(1 << 50) as i128, random.below(1 << 50) as i128];
    let (a, b) = (whole(), whole());
    // Half of them right beside the line: between a and b, one unit off at most.
    let c = if random.once_in(2) {
        let part = i128::from(random.below(1 << 10));
        let off = i128::from(random.below(3)) - 1;
        [a[0] + (b[0] - a[0]) * part / 1024, a[1] + (b[1] - a[1]) * part / 1024 + off]
    } else {
        [i128::from(random.below(1 << 50)), i128::from(random.below(1 << 50))]
    };
    let determinant = (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0]);
    let scale = pow(2.0, random.below(1900) as f64 - 1000.0);
    ([a, b, c].map(|[x, y]| Vec2::new(x as f64 * scale, y as f64 * scale)), determinant.signum() as i32)
}

/// Median time of the predicate over that of the plain formula, on points in general position, both interleaved.
fn slowdown(effort: &Effort) -> f64 {
    let mut random = effort.random(2);
    let points: Vec<Vec2> = (0..30_000).map(|_| Vec2::new(random.unit(), random.unit())).collect();
    let timed = |turn: &dyn Fn(Vec2, Vec2, Vec2) -> bool| {
        let start = Instant::now();
        let left = (0..20).map(|_| points.windows(3).filter(|p| turn(p[0], p[1], p[2])).count()).sum::<usize>();
        std::hint::black_box(left);
        start.elapsed().as_secs_f64()
    };
    let mut ratios: Vec<f64> = (0..15)
        .map(|_| {
            let exact = timed(&|a, b, c| orientation(a, b, c) == Orientation::Counterclockwise);
            let plain = timed(&|a, b, c| (a - c).perp_dot(b - c) > 0.0);
            exact / plain
        })
        .collect();
    ratios.sort_by(f64::total_cmp);
    ratios[ratios.len() / 2]
}
