//! Cases: outlines for each aspect.

use super::judge::{doubled_area, is_within_edge, turn};
use super::{Case, Whole};
use crate::math::{edges, pow};

fn plain(ring: &[Whole]) -> Case {
    Case { ring: ring.to_vec(), axis: 2, is_flipped: false, tilt: 0, exponent: 0, is_simple: is_simple(ring) }
}

fn turned(case: &Case, by: usize) -> Case {
    let mut turned = case.clone();
    turned.ring.rotate_left(by % case.ring.len());
    turned
}

/// Begun at every corner.
fn everywhere(ring: &[Whole]) -> Vec<Case> {
    let case = plain(ring);
    (0..ring.len()).map(|by| turned(&case, by)).collect()
}

fn begun_at_some(rings: &[&[Whole]]) -> Vec<Case> {
    rings.iter().flat_map(|ring| [0, ring.len() / 3, 2 * ring.len() / 3].map(|by| turned(&plain(ring), by))).collect()
}

const ARROW: [Whole; 4] = [[0, 0], [4, -3], [1, 0], [4, 3]];
const LETTER: [Whole; 6] = [[0, 0], [6, 0], [6, 2], [2, 2], [2, 6], [0, 6]];
const PLUS: [Whole; 12] =
    [[2, 0], [4, 0], [4, 2], [6, 2], [6, 4], [4, 4], [4, 6], [2, 6], [2, 4], [0, 4], [0, 2], [2, 2]];
const STAR: [Whole; 10] =
    [[0, 56], [-13, 18], [-53, 17], [-21, -7], [-33, -45], [0, -22], [33, -45], [21, -7], [53, 17], [13, 18]];
const COMB: [Whole; 13] =
    [[0, 0], [16, 0], [16, 9], [14, 2], [12, 7], [10, 3], [8, 9], [7, 2], [5, 8], [4, 3], [2, 9], [1, 2], [0, 10]];
const SPIRAL: [Whole; 12] =
    [[0, 0], [10, 0], [10, 10], [2, 10], [2, 4], [6, 4], [6, 6], [4, 6], [4, 8], [8, 8], [8, 2], [0, 2]];
const HEXAGON: [Whole; 6] = [[4, 0], [8, 2], [8, 6], [4, 8], [0, 6], [0, 2]];

/// The questions of an aspect.
pub(super) fn of(aspect: &str, seed: u64) -> Vec<Case> {
    match aspect {
        "triangle" => vec![plain(&[[0, 0], [5, 1], [2, 4]]), plain(&[[3, 3], [-4, 2], [1, -5]])],
        "convex" => convex(),
        "winding" => winding(),
        "facing" => facing(),
        "concave" => concave(seed),
        "straight corners" => straight(),
        "touching" => touching(),
        "bridges" => bridges(),
        _ => sizes(),
    }
}

fn convex() -> Vec<Case> {
    let mut cases = everywhere(&[[0, 0], [6, -1], [7, 4], [1, 5]]);
    cases.extend(everywhere(&[[0, 0], [5, 1], [6, 4], [3, 7], [-1, 4]]));
    cases.push(plain(&HEXAGON));
    // A parabola is strictly convex with as many corners as one likes.
    let arc: Vec<Whole> = (-10..10).map(|x| [x, x * x]).collect();
    cases.push(plain(&arc));
    cases
}

/// Seen from behind: on the screen they run clockwise.
fn winding() -> Vec<Case> {
    let rings: [&[Whole]; 5] = [&[[0, 0], [5, 1], [2, 4]], &[[0, 0], [6, -1], [7, 4], [1, 5]], &ARROW, &LETTER, &STAR];
    rings.iter().flat_map(|ring| [0, 2].map(|by| Case { is_flipped: true, ..turned(&plain(ring), by) })).collect()
}

fn facing() -> Vec<Case> {
    let mut cases = Vec::new();
    for axis in 0..3 {
        for (is_flipped, tilt) in [(false, 0), (true, 0), (false, 1), (true, -1)] {
            for ring in [&ARROW[..], &LETTER] {
                // A flipped outline along z is another aspect's question.
                if axis != 2 || tilt != 0 && !is_flipped {
                    cases.push(Case { axis, is_flipped, tilt, ..plain(ring) });
                }
            }
        }
    }
    cases
}

fn concave(seed: u64) -> Vec<Case> {
    let mut cases = everywhere(&ARROW);
    cases.extend(everywhere(&LETTER));
    cases.extend(begun_at_some(&[&PLUS, &STAR, &COMB, &SPIRAL]));
    let mut state = seed.wrapping_mul(2) + 3;
    cases.extend((0..6).map(|_| plain(&random_star(&mut state))));
    cases
}

/// A star around the origin with arms of random length.
fn random_star(state: &mut u64) -> Vec<Whole> {
    const RAYS: [Whole; 16] = [
        [8, 0],
        [7, 3],
        [6, 6],
        [3, 7],
        [0, 8],
        [-3, 7],
        [-6, 6],
        [-7, 3],
        [-8, 0],
        [-7, -3],
        [-6, -6],
        [-3, -7],
        [0, -8],
        [3, -7],
        [6, -6],
        [7, -3],
    ];
    let mut arm = || {
        *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        1 + (*state >> 33) as i64 % 9
    };
    RAYS.iter().map(|&[x, y]| (arm(), x, y)).map(|(arm, x, y)| [arm * x, arm * y]).collect()
}

fn straight() -> Vec<Case> {
    let mut cases = everywhere(&[[0, 0], [2, 0], [4, 0], [2, 3]]);
    cases.extend(everywhere(&[[0, 0], [3, 0], [6, 0], [6, 6], [0, 6]]));
    cases.extend(begun_at_some(&[
        &[[0, 0], [2, 0], [4, 0], [4, 2], [4, 4], [2, 4], [0, 4], [0, 2]],
        &[[0, 0], [3, 0], [6, 0], [6, 2], [4, 2], [2, 2], [2, 4], [2, 6], [0, 6], [0, 3]],
    ]));
    cases
}

/// A reflex corner exactly on the line between two others.
fn touching() -> Vec<Case> {
    let mut cases = everywhere(&[[0, 0], [8, 0], [8, 4], [4, 2], [2, 6]]);
    cases.extend(everywhere(&[[0, 0], [6, 0], [3, 3], [6, 6], [0, 6]]));
    cases.extend(everywhere(&[[0, 0], [4, 0], [8, 0], [4, 4], [8, 8], [0, 8], [2, 4]]));
    cases.extend(begun_at_some(&[
        &[[0, 0], [12, 0], [12, 4], [10, 2], [8, 4], [6, 2], [4, 4], [2, 2], [0, 4]],
        &[[0, 0], [4, 2], [8, 0], [6, 4], [8, 8], [4, 6], [0, 8], [2, 4]],
    ]));
    cases
}

fn bridges() -> Vec<Case> {
    // A square with one hole, with two; a spike; teeth on a common line; two corners in one place.
    let hole: [Whole; 10] = [[0, 0], [4, 2], [4, 6], [8, 6], [8, 2], [4, 2], [0, 0], [12, 0], [12, 8], [0, 8]];
    let holes: [Whole; 18] = [
        [0, 0],
        [2, 0],
        [2, 2],
        [2, 6],
        [6, 6],
        [6, 2],
        [2, 2],
        [2, 0],
        [9, 0],
        [9, 3],
        [9, 5],
        [11, 5],
        [11, 3],
        [9, 3],
        [9, 0],
        [14, 0],
        [14, 8],
        [0, 8],
    ];
    let spike: [Whole; 6] = [[0, 0], [6, 0], [6, 4], [3, 4], [3, 7], [3, 4]];
    let teeth: [Whole; 8] = [[0, 0], [12, 0], [12, 2], [10, 6], [8, 2], [4, 2], [2, 6], [0, 2]];
    let joined: [Whole; 8] = [[0, 4], [2, 0], [4, 4], [8, 4], [10, 0], [12, 4], [8, 4], [4, 4]];
    let doubled: [Whole; 6] = [[0, 0], [6, 0], [6, 0], [6, 5], [2, 2], [0, 5]];
    begun_at_some(&[&hole, &holes, &spike, &teeth, &joined, &doubled])
}

/// The third corner is reflex by a hair. Differences of these coordinates round in `f64`, and the plain formula takes it for convex,
/// whichever of the three corners it begins with.
const NEARLY_STRAIGHT: [[Whole; 4]; 3] = [
    [
        [-9_007_199_254_740_986, -9_007_199_254_740_984],
        [9_007_199_254_203_230, -9_007_199_254_157_540],
        [-3_791_276_255_014_043, 3_791_276_255_539_543],
        [-9_007_199_253_710_831, 9_007_199_254_431_874],
    ],
    [
        [-9_007_199_254_740_986, -9_007_199_254_740_984],
        [9_007_199_254_158_562, -9_007_199_254_117_579],
        [939_129_420_215_074, -939_129_420_285_683],
        [-9_007_199_254_218_901, 9_007_199_254_010_722],
    ],
    [
        [-9_007_199_254_740_986, -9_007_199_254_740_984],
        [9_007_199_254_672_667, -9_007_199_254_180_899],
        [5_301_854_611_138_627, -5_301_854_610_721_338],
        [-9_007_199_254_296_840, 9_007_199_254_426_511],
    ],
];

fn sizes() -> Vec<Case> {
    let sized = |exponent: i32, ring: &[Whole]| Case { exponent, ..plain(ring) };
    let mut cases = Vec::new();
    for exponent in [-300, -40, 40, 300] {
        cases.extend([sized(exponent, &STAR), sized(exponent, &LETTER)]);
    }
    cases.extend(NEARLY_STRAIGHT.iter().map(|ring| plain(ring)));
    cases
}

/// Whether no two edges meet but neighbors in their corner.
pub(super) fn is_simple(ring: &[Whole]) -> bool {
    let sides: Vec<(Whole, Whole)> = edges(ring).map(|(&a, &b)| (a, b)).collect();
    let count = sides.len();
    let meet = |(a, b): (Whole, Whole), (c, d): (Whole, Whole)| {
        let sign = |p, q, r| turn(p, q, r).signum();
        let crosses = sign(a, b, c) * sign(a, b, d) < 0 && sign(c, d, a) * sign(c, d, b) < 0;
        let touches = |(p, q), r| r == p || r == q || is_within_edge(p, q, r);
        crosses || touches((a, b), c) || touches((a, b), d) || touches((c, d), a) || touches((c, d), b)
    };
    (0..count).all(|one| {
        let (a, b) = sides[one];
        let next = sides[(one + 1) % count];
        let turns_back = is_within_edge(a, b, next.1) || is_within_edge(next.0, next.1, a) || a == next.1;
        let others = (one + 2..count).filter(|&other| !(one == 0 && other == count - 1));
        a != b && !turns_back && !others.into_iter().any(|other| meet((a, b), sides[other]))
    })
}

/// Smaller questions: a corner less, an ordinary size, an ordinary place.
pub(super) fn smaller(case: &Case) -> Vec<Case> {
    let mut smaller = Vec::new();
    if case.exponent != 0 {
        smaller.push(Case { exponent: 0, ..case.clone() });
    }
    if case.tilt != 0 {
        smaller.push(Case { tilt: 0, ..case.clone() });
    }
    if !case.is_plain() {
        smaller.push(Case { axis: 2, is_flipped: false, ..case.clone() });
    }
    for corner in 0..case.ring.len() {
        let mut fewer = case.clone();
        fewer.ring.remove(corner);
        // Where the outline touched itself, the rest may cross itself: such corners stay.
        if case.is_simple && fewer.ring.len() >= 3 && is_simple(&fewer.ring) && doubled_area(&fewer.ring) > 0 {
            smaller.push(fewer);
        }
    }
    smaller
}

/// The convex hull's doubled area, by walking around it.
pub(super) fn doubled_hull_area(ring: &[Whole]) -> i128 {
    let Some(start) = ring.iter().min().copied() else { return 0 };
    let (mut hull, mut at) = (vec![start], start);
    for _ in 0..ring.len() {
        let mut next = ring[0];
        for &p in ring {
            let side = turn(at, next, p);
            let is_farther = distance(at, p) > distance(at, next);
            if next == at || side < 0 || (side == 0 && is_farther) {
                next = p;
            }
        }
        if next == start {
            break;
        }
        hull.push(next);
        at = next;
    }
    doubled_area(&hull)
}

fn distance(a: Whole, b: Whole) -> f64 {
    pow((a[0] - b[0]) as f64, 2.0) + pow((a[1] - b[1]) as f64, 2.0)
}
