//! Cases: small polygons for each aspect, in numbers that a reader can follow.

use super::{Asks, Case};

/// A unit in 64ths.
const ONE: i64 = 64;

/// A question about corners in units.
fn case(asks: Asks, corners: &[(f64, f64, f64)]) -> Case {
    let corners = corners.iter().map(|&(x, y, w)| [x, y, w].map(|x| (x * ONE as f64) as i64)).collect();
    Case { asks, corners, apex: None, hither: ONE, yon: Some(6 * ONE) }
}

/// A polygon that faces the eye at distance w.
fn facing(asks: Asks, w: f64, corners: &[(f64, f64)]) -> Case {
    case(asks, &corners.iter().map(|&(x, y)| (x, y, w)).collect::<Vec<_>>())
}

fn turned(case: &Case, by: usize) -> Case {
    let mut turned = case.clone();
    turned.corners.rotate_left(by);
    turned
}

fn backward(case: &Case) -> Case {
    let mut backward = case.clone();
    backward.corners.reverse();
    backward
}

fn asking(asks: Asks, cases: Vec<Case>) -> Vec<Case> {
    cases.into_iter().map(|case| Case { asks, ..case }).collect()
}

/// The questions of an aspect.
pub(super) fn of(aspect: &str, seed: u64) -> Vec<Case> {
    match aspect {
        "inside" => inside(),
        "outside" => outside(),
        "one plane" => one_plane(),
        "winding" => one_plane().iter().step_by(5).map(backward).collect(),
        "on the plane" => on_the_plane(),
        "several planes" => several_planes(seed),
        "concave" => concave(),
        "attributes" => {
            asking(Asks::Attributes, one_plane().into_iter().step_by(2).chain(several_planes(seed)).collect())
        }
        "edge marks" => marks(seed),
        "shared edges" => neighbors(seed),
        "both sides" => sides(seed),
        _ => asking(Asks::LastPlace, several_planes(seed).into_iter().chain(triangles(seed ^ 77, 30)).collect()),
    }
}

fn inside() -> Vec<Case> {
    vec![
        facing(Asks::Same, 4.0, &[(-1.0, -1.0), (2.0, -0.5), (0.25, 3.0)]),
        case(Asks::Same, &[(-1.0, -1.0, 2.0), (1.5, -1.0, 3.0), (1.0, 2.0, 5.0), (-1.0, 2.0, 4.0)]),
        // Corners on the planes are inside.
        facing(Asks::Same, 2.0, &[(-2.0, -2.0), (2.0, -2.0), (2.0, 2.0), (-2.0, 2.0)]),
        case(Asks::Same, &[(-1.0, -1.0, 1.0), (1.0, -1.0, 1.0), (0.0, 6.0, 6.0)]),
    ]
}

fn outside() -> Vec<Case> {
    let shape = [(-1.0, -1.0), (2.0, -0.5), (0.25, 1.0)];
    let moved = |dx: f64, dy: f64, w: f64| {
        let corners: Vec<_> = shape.iter().map(|&(x, y)| (x + dx, y + dy)).collect();
        facing(Asks::Shape, w, &corners)
    };
    vec![
        moved(9.0, 0.0, 4.0),
        moved(-9.0, 0.0, 4.0),
        moved(0.0, 9.0, 4.0),
        moved(0.0, -9.0, 4.0),
        moved(0.0, 0.0, 0.5),
        moved(0.0, 0.0, 7.0),
        moved(0.0, 0.0, -4.0),
        // Past a corner of the picture: outside of no single plane.
        facing(Asks::Shape, 4.0, &[(3.0, 8.0), (8.0, 3.0), (9.0, 9.0)]),
        // Only one corner touches the volume.
        facing(Asks::Shape, 4.0, &[(4.0, 0.0), (7.0, -1.0), (7.0, 1.0)]),
    ]
}

/// A triangle and a quadrilateral across each plane, begun at every corner.
fn one_plane() -> Vec<Case> {
    let across: [[(f64, f64, f64); 3]; 6] = [
        [(-0.25, 0.0, 3.0), (0.25, 0.25, 0.5), (0.5, -0.5, 4.0)],
        [(-6.0, 0.5, 4.0), (1.0, -1.0, 3.0), (1.0, 2.0, 5.0)],
        [(6.0, 0.5, 4.0), (-1.0, 2.0, 5.0), (-1.0, -1.0, 3.0)],
        [(0.5, -6.0, 4.0), (2.0, 1.0, 5.0), (-1.0, 1.0, 3.0)],
        [(0.5, 6.0, 4.0), (-1.0, -1.0, 3.0), (2.0, -1.0, 5.0)],
        [(0.0, 0.0, 8.0), (1.0, 1.0, 5.0), (-1.0, 1.5, 4.0)],
    ];
    let mut cases = Vec::new();
    for corners in across {
        let triangle = case(Asks::Shape, &corners);
        cases.extend((0..3).map(|by| turned(&triangle, by)));
        // Two corners outside: the first, and one between it and the second.
        let [a, b, c] = triangle.corners[..] else { continue };
        let beside = std::array::from_fn(|axis| (7 * a[axis] + b[axis]) / 8);
        let quadrilateral = Case { corners: vec![a, beside, b, c], ..triangle };
        cases.extend((0..4).map(|by| turned(&quadrilateral, by)));
    }
    cases
}

fn on_the_plane() -> Vec<Case> {
    let shapes = [
        // A corner on the right plane, the rest inside or on both sides.
        facing(Asks::NoDoubles, 4.0, &[(0.0, -1.0), (4.0, 0.0), (0.0, 2.0)]),
        facing(Asks::NoDoubles, 4.0, &[(4.0, 0.0), (0.0, 2.0), (-6.0, 0.0), (0.0, -2.0)]),
        facing(Asks::NoDoubles, 4.0, &[(0.0, -1.0), (6.0, -1.0), (4.0, 0.0), (0.0, 2.0)]),
        // The outline leaves in a corner, and enters in one.
        facing(Asks::NoDoubles, 4.0, &[(0.0, -2.0), (4.0, -1.0), (6.0, 0.0), (4.0, 1.0), (0.0, 2.0)]),
        // An edge along the plane, the rest inside; and outside.
        facing(Asks::NoDoubles, 4.0, &[(0.0, 0.0), (4.0, -1.0), (4.0, 1.0)]),
        facing(Asks::NoDoubles, 4.0, &[(4.0, 1.0), (4.0, -1.0), (7.0, 0.0)]),
        // A diagonal through two corners on two planes.
        facing(Asks::NoDoubles, 4.0, &[(-4.0, 0.0), (0.0, -4.0), (6.0, 6.0)]),
    ];
    shapes.iter().flat_map(|shape| (0..shape.corners.len()).map(|by| turned(shape, by))).collect()
}

fn several_planes(seed: u64) -> Vec<Case> {
    let mut cases = vec![
        // The volume's corner, and all four.
        facing(Asks::Shape, 4.0, &[(0.0, 0.0), (7.0, 1.0), (1.0, 9.0)]),
        facing(Asks::Shape, 4.0, &[(-9.0, -10.0), (11.0, -9.0), (10.0, 12.0), (-12.0, 9.0)]),
        // No corner inside, and the middle of the view is.
        facing(Asks::Shape, 4.0, &[(-9.0, -3.0), (9.0, -2.0), (0.0, 11.0)]),
        facing(Asks::Shape, 2.0, &[(-30.0, -9.0), (30.0, -9.0), (0.0, 40.0)]),
        // A floor from behind the eye to beyond yon; a wall beside it.
        case(Asks::Shape, &[(-3.0, -1.0, -2.0), (3.0, -1.0, -2.0), (5.0, -1.0, 9.0), (-5.0, -1.0, 9.0)]),
        case(Asks::Shape, &[(1.0, -2.0, -3.0), (1.0, 2.0, -3.0), (1.0, 2.0, 8.0), (1.0, -2.0, 8.0)]),
        case(Asks::Shape, &[(0.0, -1.0, 3.0), (6.0, 4.0, -5.0), (-7.0, 5.0, -4.0)]),
        // Through a band: in at the left, out at the right.
        facing(Asks::Shape, 4.0, &[(-9.0, -0.5), (9.0, -1.5), (9.0, 0.5), (-9.0, 2.0)]),
    ];
    cases[3].yon = None;
    cases.extend(triangles(seed, 8));
    cases
}

/// Triangles anywhere around the volume.
fn triangles(seed: u64, count: usize) -> Vec<Case> {
    let mut random = Random(seed.wrapping_mul(2) + 1);
    let mut triangles = Vec::new();
    while triangles.len() < count {
        let corners: Vec<_> = (0..3).map(|_| random.corner()).collect();
        let case = Case { corners, ..case(Asks::Shape, &[]) };
        let area = super::exact::doubled_area(&case);
        if area.iter().any(|area| area.abs() > 1.0) {
            triangles.push(case);
        }
    }
    triangles
}

fn concave() -> Vec<Case> {
    let star: Vec<(f64, f64)> = [
        (0.0, 5.5),
        (-1.25, 1.75),
        (-5.25, 1.75),
        (-2.0, -0.75),
        (-3.25, -4.5),
        (0.0, -2.25),
        (3.25, -4.5),
        (2.0, -0.75),
        (5.25, 1.75),
        (1.25, 1.75),
    ]
    .to_vec();
    // Three teeth through the top plane, and the letter U through the left one.
    let comb = [
        (3.0, -1.0),
        (3.0, 6.0),
        (2.0, 6.0),
        (2.0, 1.0),
        (0.5, 1.0),
        (0.5, 7.0),
        (-0.5, 7.0),
        (-0.5, 1.0),
        (-2.0, 1.0),
        (-2.0, 5.0),
        (-3.0, 5.0),
        (-3.0, -1.0),
    ];
    let letter =
        [(2.0, -2.0), (2.0, 2.0), (-7.0, 2.0), (-7.0, 1.0), (1.0, 1.0), (1.0, -1.0), (-7.0, -1.0), (-7.0, -2.0)];
    let arrow = [(0.0, 6.0), (-3.0, -3.0), (0.0, 0.0), (3.0, -3.0)];
    let shapes = [&star[..], &comb, &letter, &arrow].map(|corners| facing(Asks::Shape, 4.0, corners));
    shapes.iter().flat_map(|shape| [shape.clone(), turned(shape, 3)]).chain(shapes.iter().map(backward)).collect()
}

fn marks(seed: u64) -> Vec<Case> {
    let on = on_the_plane().into_iter().take(12);
    asking(Asks::Marks, one_plane().into_iter().step_by(3).chain(several_planes(seed)).chain(on).collect())
}

/// Pairs of triangles with an edge through the volume's border, and the mirror images of what a reader can follow.
fn neighbors(seed: u64) -> Vec<Case> {
    let mut random = Random(seed.wrapping_mul(2) + 9);
    let mut cases = Vec::new();
    while cases.len() < 24 {
        let corners: Vec<_> = (0..3).map(|_| random.corner()).collect();
        let apex = random.corner();
        let case = Case { corners, apex: Some(apex), ..case(Asks::Neighbor, &[]) };
        let other = Case { corners: vec![case.corners[1], case.corners[0], apex], ..case.clone() };
        // Both have some area inside, and the edge is cut.
        let has_area = |case: &Case| super::exact::doubled_area(case).iter().any(|area| area.abs() > 1.0);
        let volume = case.volume();
        let inputs = case.inputs();
        let ends = [0, 1].map(|end| volume.outcode(inputs[0].0[end].position).is_inside());
        if ends[0] != ends[1] && has_area(&case) && has_area(&other) {
            cases.push(case);
        }
    }
    cases
}

/// Triangles through a plane across the middle.
fn sides(seed: u64) -> Vec<Case> {
    let mut random = Random(seed.wrapping_mul(2) + 5);
    let mut sides = Vec::new();
    while sides.len() < 16 {
        let corners: Vec<_> =
            (0..3).map(|_| [random.between(-70, 70), random.between(-70, 70), random.between(100, 380)]).collect();
        let (before, behind) = (corners.iter().any(|c| c[2] < 210), corners.iter().any(|c| c[2] > 230));
        let case = Case { corners, yon: Some(220), ..case(Asks::OtherSide, &[]) };
        if before && behind && super::exact::doubled_area(&case).iter().any(|area| area.abs() > 0.1) {
            sides.push(case);
        }
    }
    sides
}

/// Smaller questions: a corner less; whole numbers; a number nearer to zero.
pub(super) fn smaller(case: &Case) -> Vec<Case> {
    let mut smaller = Vec::new();
    if case.corners.len() > 3 {
        for corner in 0..case.corners.len() {
            let mut fewer = case.clone();
            fewer.corners.remove(corner);
            smaller.push(fewer);
        }
    }
    let whole = |number: i64| (number as f64 / ONE as f64).round() as i64 * ONE;
    if case.yon.is_some() && case.asks != Asks::OtherSide {
        smaller.push(Case { yon: None, ..case.clone() });
    }
    for corner in 0..case.corners.len() {
        for axis in 0..3 {
            let mut rounder = case.clone();
            let number = &mut rounder.corners[corner][axis];
            if *number != whole(*number) {
                *number = whole(*number);
                smaller.push(rounder);
            }
        }
    }
    smaller
}

/// Pseudo-random numbers. Source: Steele, Lea and Flood, "Fast Splittable Pseudorandom Number Generators", OOPSLA 2014.
struct Random(u64);

impl Random {
    fn between(&mut self, low: i64, high: i64) -> i64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        low + ((mixed ^ (mixed >> 31)) % (high - low + 1) as u64) as i64
    }

    fn corner(&mut self) -> [i64; 3] {
        [self.between(-400, 400), self.between(-400, 400), self.between(-100, 500)]
    }
}
