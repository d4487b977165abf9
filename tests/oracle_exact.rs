//! The exact oracle: against cases by hand, against other programs, and the z-buffer against it.

mod support;

use farop::math::Vec3;
use farop::oracle::Vertices;
use farop::oracle::depth::{Depth, DepthOrder};
use farop::oracle::exact::{ExactCounts, Rules, covers, judge, layers};
use farop::plan::{Choices, Culling, DepthFormat};
use farop::raster::ZBuffer;
use farop::screen::{DrawList, Grid};
use farop::spd::{Curves, SMALL};
use num_bigint::BigInt;
use support::built_in::{built_in, geometry_of};
use support::half_planes::outline_covers;
use support::mixed::Mix;
use support::owners::{numbered, owners};
use support::random::Random;

#[test]
fn ties_by_hand() {
    let mut list = DrawList::new(6, 6);
    list.push_flat(&[(1.5, 1.5), (4.5, 1.5), (4.5, 4.5), (1.5, 4.5)], 1.0, [1.0; 3]);
    list.push_flat(&[(0.0, 0.0), (6.0, 0.0), (6.0, 6.0), (3.0, 2.0), (0.0, 6.0)], 0.5, [1.0; 3]);
    // Through the same centers, equally near: the first in the list keeps them.
    list.push_flat(&[(1.5, 1.5), (4.5, 4.5), (1.5, 4.5)], 1.0, [1.0; 3]);
    for rules in [Rules::CONTRACT, Rules::TRUE_DEPTH, Rules::UNSNAPPED] {
        let picture = judge(&list, &rules);
        let digit = |owner: &Option<u32>| owner.map_or('.', |owner| char::from(b'1' + owner as u8));
        let rows: Vec<String> = picture.owner.chunks(6).map(|row| row.iter().map(digit).collect()).collect();
        assert_eq!(rows, ["222222", "211122", "211122", "211122", "2....2", "......"], "{rules:?}");
        let counts = picture.counts;
        assert_eq!((counts.depth_ties, counts.disputed, counts.piercing), (3, 3, 0), "{rules:?}");
        // 12 centers on the square's outline, 9 on the triangle's, none on the notched one's.
        assert_eq!((counts.overlapped, counts.on_outline), (8, 21), "{rules:?}");
        assert_eq!(layers(&list, &rules, (1, 3)), [0, 2, 1], "{rules:?}");
    }
}

#[test]
fn snapped_coverage_equals_another_program() {
    let mut random = Random::new(11);
    let (mut covered, mut on_outline) = (0, 0);
    for round in 0..600 {
        let bits = [0, 1, 4, 8, 16][round % 5];
        let mut list = DrawList::new(24, 24);
        list.grid = Grid { bits };
        let steps = 1_i64 << bits;
        // Every third corner on a center or on the whole: ties.
        let mut at = || {
            let free = random.whole(0, 24 * steps);
            if random.one_in(3) { free / steps * steps + steps / 2 } else { free }
        };
        let points: Vec<(i64, i64)> = (0..3 + round % 6).map(|_| (at(), at())).collect();
        let corners: Vec<(f64, f64)> =
            points.iter().map(|&(x, y)| (x as f64 / steps as f64, y as f64 / steps as f64)).collect();
        list.push_flat(&corners, 1.0, [1.0; 3]);
        let doubled: Vec<(i64, i64)> = points.iter().map(|&(x, y)| (2 * x, 2 * y)).collect();
        // The grid holds these numbers: snapped and raw corners are the same, and so must be the answers.
        for rules in [Rules::CONTRACT, Rules::UNSNAPPED] {
            let picture = judge(&list, &rules);
            for (index, owner) in picture.owner.iter().enumerate() {
                let sample = ((index % 24) as i32, (index / 24) as i32);
                let expected = outline_covers(&doubled, steps, sample);
                assert_eq!(owner.is_some(), expected, "{corners:?}, {sample:?}, {rules:?}");
                covered += u64::from(expected);
            }
            on_outline += picture.counts.on_outline;
        }
    }
    assert!(covered > 80_000 && on_outline > 3_000, "{covered} {on_outline}");
}

/// An exact dyadic number times 2^2200.
fn big(value: f64) -> BigInt {
    let bits = value.abs().to_bits();
    let (biased, fraction) = (bits >> 52, bits & ((1 << 52) - 1));
    let (whole, exponent) = if biased == 0 { (fraction, 1) } else { (fraction | 1 << 52, biased) };
    let size = BigInt::from(whole) << (exponent + 1125);
    if value < 0.0 { -size } else { size }
}

/// Even-odd by a level line to the left; below an upper end or on it, strictly above a lower one; on an edge: right of it.
fn covers_by_big_numbers(corners: &[Vec3], (x, y): (i32, i32)) -> bool {
    let one = big(1.0);
    let center = |at: i32| big(f64::from(at) + 0.5);
    // Rows of the determinant, moved so that the sample is the origin; the common factor is positive.
    let moved = |corner: &Vec3, axis: usize, at: i32| big(corner[axis]) * &one - center(at) * big(corner.z);
    let mut inside = false;
    for (index, from) in corners.iter().enumerate() {
        let to = &corners[(index + 1) % corners.len()];
        let zero = BigInt::from(0);
        let reached = |corner: &Vec3| moved(corner, 1, y) <= zero;
        if reached(from) == reached(to) {
            continue;
        }
        let (upper, lower) = if reached(from) { (from, to) } else { (to, from) };
        let cross = moved(upper, 0, x) * moved(lower, 1, y) - moved(upper, 1, y) * moved(lower, 0, x);
        inside ^= cross <= zero;
    }
    inside
}

#[test]
fn raw_coverage_equals_numbers_of_any_length() {
    let mut random = Random::new(5);
    let (mut tests, mut covered, mut extreme) = (0, 0, 0);
    for round in 0..1500 {
        let mut list = DrawList::new(8, 8);
        let reach = [8.0, 1e3, 1e6, 1e9][round % 4];
        let count = 3 + round % 3;
        let corners: Vec<(f64, f64)> =
            (0..count).map(|_| (random.between(-reach, reach) + 4.0, random.between(-reach, reach) + 4.0)).collect();
        list.push_flat(&corners, 1.0, [1.0; 3]);
        for corner in &mut list.vertices {
            // Any distance; every fifth round at the ends of what f64 can say.
            let w = if round % 5 == 0 { [1e-290, 1e280, 5e-324, 3e-308][round % 4] } else { random.between(0.1, 1e4) };
            corner.homogeneous *= w;
            corner.homogeneous.z = w;
            extreme += u64::from(round % 5 == 0);
        }
        if !list.vertices.iter().all(|corner| corner.homogeneous.is_finite()) {
            continue;
        }
        // A third corner on the line of the first two and a sample center, as nearly as f64 allows.
        if round % 3 == 0 {
            let (a, b) = (list.vertices[0].homogeneous, list.vertices[1].homogeneous);
            let center = Vec3::new(3.5, 4.5, 1.0) * b.z;
            list.vertices[2].homogeneous = if round % 2 == 0 { center } else { (a + b) / 2.0 };
        }
        let raw: Vec<Vec3> = list.vertices.iter().map(|corner| corner.homogeneous).collect();
        for sample in (0..64).map(|at| (at % 8, at / 8)) {
            let expected = covers_by_big_numbers(&raw, sample);
            let found = covers(&list.polygon(0), Vertices::Raw, sample);
            assert_eq!(found, (raw.iter().all(|corner| corner.z > 0.0)).then_some(expected), "{raw:?} {sample:?}");
            tests += 1;
            covered += u64::from(expected);
        }
    }
    println!("{tests} samples, {covered} covered, {extreme} extreme corners");
    assert!(tests > 50_000 && covered > 10_000 && extreme > 800, "{tests} {covered} {extreme}");
}

/// The z-buffer against the oracle; what was judged, and the samples where the true planes say otherwise.
fn agree(name: &str, list: &DrawList) -> (ExactCounts, u64) {
    let list = numbered(list);
    let drawn = owners(&list, &ZBuffer);
    let contract = judge(&list, &Rules::CONTRACT);
    assert!(contract.owner == drawn, "{name}: {:?}", first_difference(&contract.owner, &drawn));
    let truth = judge(&list, &Rules::TRUE_DEPTH);
    assert!(truth.covering == contract.covering, "{name}");
    let (wrong, other) = truth.differences(&drawn);
    assert_eq!(wrong, 0, "{name}: {:?}", first_difference(&truth.owner, &drawn));
    (truth.counts, other)
}

fn first_difference(a: &[Option<u32>], b: &[Option<u32>]) -> Option<(usize, Option<u32>, Option<u32>)> {
    (0..a.len()).find(|&index| a[index] != b[index]).map(|index| (index, a[index], b[index]))
}

#[test]
fn z_buffer_shows_the_owner_in_built_in_scenes() {
    for (name, size) in SMALL {
        let scene = built_in(name, size, Curves::Kept);
        for culling in [Culling::Back, Culling::None] {
            let choices = Choices { size: Some((72, 60)), culling, ..Choices::default() };
            let (counts, other) = agree(name, &geometry_of(&scene, &choices).0);
            println!("{name}, {}: {counts:?}, {other} otherwise in truth", culling.name());
            assert!(counts.covered > 100, "{name}");
        }
    }
}

#[test]
fn z_buffer_shows_the_owner_in_random_scenes() {
    let (mut sum, mut otherwise) = (ExactCounts::default(), 0);
    for seed in 1..=120 {
        let mix = Mix { seed, polygons: 8 + (seed as usize * 7) % 40, corners: (3, 6), ..Mix::default() };
        let mut scene = mix.scene(48);
        if seed % 4 == 0 {
            scene.merge(mix.scene(48));
        }
        scene.camera.iter_mut().for_each(|camera| camera.yon = Some(1e3));
        let depth = DepthFormat::ALL[seed as usize % 2];
        let subpixel_bits = [8, 8, 4, 0, 16][seed as usize % 5];
        let culling = [Culling::Back, Culling::None][seed as usize % 2];
        let choices = Choices { depth, subpixel_bits, culling, ..Choices::default() };
        let (counts, other) = agree(&format!("seed {seed}"), &geometry_of(&scene, &choices).0);
        sum += counts;
        otherwise += other;
    }
    println!("{sum:?}, {otherwise} otherwise in truth");
    assert!(sum.overlapped > 50_000 && sum.piercing > 100 && sum.depth_ties > 1_000 && sum.cut > 100, "{sum:?}");
}

#[test]
fn integer_depth_follows_the_contract() {
    let mut scene = Mix { seed: 3, polygons: 32, corners: (3, 5), ..Mix::default() }.scene(48);
    scene.camera.iter_mut().for_each(|camera| camera.yon = Some(50.0));
    for depth in [DepthFormat::Int16, DepthFormat::Int24] {
        let list = numbered(&geometry_of(&scene, &Choices { depth, ..Choices::default() }).0);
        assert!(judge(&list, &Rules::CONTRACT).owner == owners(&list, &ZBuffer), "{depth:?}");
    }
}

#[test]
fn snapping_is_seen() {
    // An edge a hair right of a column of centers snaps onto it: only the snapped polygon covers these centers.
    let mut list = DrawList::new(4, 4);
    list.push_flat(&[(1.5 + 1e-9, 0.0), (4.0, 0.0), (4.0, 4.0), (1.5 + 1e-9, 4.0)], 1.0, [1.0; 3]);
    let covered = |rules: &Rules| judge(&list, rules).counts.covered;
    assert_eq!((covered(&Rules::CONTRACT), covered(&Rules::UNSNAPPED)), (12, 8));
}

/// The same polygons twice, seen at the same places, the second time nearer by one part in `parts`.
fn doubled(parts: f64) -> DrawList {
    let mut scene = Mix { seed: 8, polygons: 60, corners: (3, 3), ..Mix::default() }.scene(48);
    let mut nearer = scene.clone();
    let corners = nearer.surfaces.iter_mut().flat_map(|surface| &mut surface.mesh.vertices);
    corners.for_each(|corner| *corner *= 1.0 - 1.0 / parts);
    scene.merge(nearer);
    let mut list = geometry_of(&scene, &Choices { culling: Culling::None, ..Choices::default() }).0;
    // Snapped corners must not differ: this is about depth alone.
    let half = list.len() / 2;
    for index in 0..half {
        let (from, to) = (list.polygons[index], list.polygons[index + half]);
        for corner in 0..from.vertex_count as usize {
            let (x, y) = {
                let vertex = &list.vertices[from.first_vertex as usize + corner];
                (vertex.x, vertex.y)
            };
            let vertex = &mut list.vertices[to.first_vertex as usize + corner];
            (vertex.x, vertex.y) = (x, y);
        }
    }
    list
}

#[test]
fn true_depth_tells_apart_what_single_precision_cannot() {
    for parts in [1e4, 1e6, 1e7, 1e8, 1e11] {
        let list = numbered(&doubled(parts));
        let half = (list.len() / 2) as u32;
        let truth = judge(&list, &Rules::TRUE_DEPTH);
        let behind = truth.owner.iter().flatten().filter(|&&owner| owner < half).count();
        assert_eq!(behind, 0, "1 / {parts}: the nearer twin is in front everywhere");
        let drawn = owners(&list, &ZBuffer);
        let (wrong, close) = truth.differences(&drawn);
        println!(
            "1 / {parts:e}: {} covered, {} disputed, {close} drawn otherwise",
            truth.counts.covered, truth.counts.disputed
        );
        assert_eq!(wrong, 0, "1 / {parts}");
        // Eight last digits are the band; half of one is where single precision ends.
        assert_eq!(truth.counts.disputed > truth.counts.covered / 2, parts > 1e6, "1 / {parts}");
        assert!(if parts < 1e7 { close == 0 } else { close > 0 || parts < 1e8 }, "1 / {parts}: {close}");
    }
}

#[test]
fn the_contract_is_met_to_the_last_bit() {
    let mut judged = 0;
    for seed in 1..=12 {
        let mut scene = Mix { seed, polygons: 24, corners: (3, 6), ..Mix::default() }.scene(48);
        scene.camera.iter_mut().for_each(|camera| camera.yon = Some(50.0));
        let depth = DepthFormat::ALL[seed as usize % 4];
        let list = geometry_of(&scene, &Choices { depth, ..Choices::default() }).0;
        for polygon in list.polygons() {
            let oracle = Depth::new(&polygon, DepthOrder::Contract).expect("a list with depth");
            // Everywhere, not only where it is covered: there its range holds most, so its middle is asked, too.
            for sample in (0..48 * 48).map(|at| (at % 48, at / 48)) {
                assert_eq!(oracle.at(&list, sample), polygon.depth(sample.0, sample.1), "{depth:?} {sample:?}");
                judged += u64::from(covers(&polygon, Vertices::Snapped, sample) == Some(true));
            }
        }
    }
    assert!(judged > 5_000, "{judged}");
}

/// 1/w of the plane of three corners at a sample, as numerator and denominator of any length; the latter positive.
fn fraction([a, b, c]: [Vec3; 3], (x, y): (i32, i32)) -> (BigInt, BigInt) {
    let minus = |p: Vec3, q: Vec3| [0, 1, 2].map(|axis| big(p[axis]) - big(q[axis]));
    let (first, second) = (minus(b, a), minus(c, a));
    let normal = [(1, 2), (2, 0), (0, 1)].map(|(p, q)| &first[p] * &second[q] - &first[q] * &second[p]);
    let dot = |v: [f64; 3]| &normal[0] * big(v[0]) + &normal[1] * big(v[1]) + &normal[2] * big(v[2]);
    let (above, below) = (dot([f64::from(x) + 0.5, f64::from(y) + 0.5, 1.0]), dot(a.to_array()));
    if below < BigInt::from(0) { (-above, -below) } else { (above, below) }
}

#[test]
fn true_depth_equals_numbers_of_any_length() {
    let mut random = Random::new(31);
    let (mut equal, mut near) = (0, 0);
    for round in 0..400 {
        let mut list = DrawList::new(8, 8);
        let mut corner = || {
            let w = random.between(1.0, 20.0);
            Vec3::new(random.between(-4.0, 12.0) * w, random.between(-4.0, 12.0) * w, w)
        };
        let first: [Vec3; 3] = std::array::from_fn(|_| corner());
        let mut second = first;
        // The same plane again, one coordinate of one corner a last digit off; every fourth not at all.
        if round % 4 > 0 {
            let moved = &mut second[random.whole(0, 2) as usize][random.whole(0, 2) as usize];
            *moved = if random.one_in(2) { moved.next_up() } else { moved.next_down() };
        }
        for corners in [first, second] {
            list.push_flat(&[(0.0, 0.0), (8.0, 0.0), (0.0, 8.0)], 1.0, [1.0; 3]);
            let vertices = list.vertices.len() - 3;
            (0..3).for_each(|index| list.vertices[vertices + index].homogeneous = corners[index]);
        }
        list.planes.iter_mut().for_each(|plane| (plane.low, plane.high) = (-1e9, 1e9));
        let depths = [0, 1].map(|index| Depth::new(&list.polygon(index), DepthOrder::True).expect("finite"));
        for sample in (0..64).map(|at| (at % 8, at / 8)) {
            let ((a, a_below), (b, b_below)) = (fraction(first, sample), fraction(second, sample));
            let expected = (a * b_below).cmp(&(b * a_below));
            assert_eq!(depths[0].compare(&depths[1], &list, sample), expected, "{first:?} {second:?} {sample:?}");
            equal += u64::from(expected.is_eq());
            near += u64::from(expected.is_ne() && depths[0].at(&list, sample) == depths[1].at(&list, sample));
        }
    }
    println!("{equal} equal, {near} of the others equal in f64");
    assert!(equal > 5_000 && near > 500, "{equal} {near}");
}
