//! Clipping: no cracks between neighbors, no vertex outside, no area lost, nothing moved that is inside.

use farop::geometry::clip::{ClipVertex, ClipVolume, Clipped, Clipper, MAX_ATTRIBUTES};
use farop::math::{Vec3, edges};
use farop::screen::EdgeKind;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

const OPEN: ClipVolume = ClipVolume { hither: 1.0, yon: None };
const CLOSED: ClipVolume = ClipVolume { hither: 1.0, yon: Some(8.0) };

fn vertex(x: f64, y: f64, w: f64) -> ClipVertex {
    ClipVertex { position: Vec3::new(x, y, w), ..ClipVertex::default() }
}

fn polygon(points: &[(f64, f64, f64)]) -> Vec<ClipVertex> {
    points.iter().map(|&(x, y, w)| vertex(x, y, w)).collect()
}

/// What is left, with `Inside` spelled out.
fn clipped(polygon: &[ClipVertex], volume: &ClipVolume) -> Vec<ClipVertex> {
    match Clipper::default().clip(polygon, volume, MAX_ATTRIBUTES) {
        Clipped::Inside => polygon.to_vec(),
        Clipped::Cut(kept) => kept.to_vec(),
        Clipped::Outside => Vec::new(),
        Clipped::NotFinite => panic!("not finite"),
    }
}

fn positions(polygon: &[ClipVertex]) -> Vec<[f64; 3]> {
    polygon.iter().map(|v| v.position.to_array()).collect()
}

fn is_inside(p: Vec3, volume: &ClipVolume) -> bool {
    p.x.abs() <= p.z && p.y.abs() <= p.z && p.z >= volume.hither && volume.yon.is_none_or(|yon| p.z <= yon)
}

/// Twice the area on the screen, counterclockwise positive.
fn doubled_area(polygon: &[ClipVertex]) -> f64 {
    let screen = |v: &ClipVertex| (v.position.x / v.position.z, v.position.y / v.position.z);
    edges(polygon).map(|(a, b)| (screen(a), screen(b))).map(|(a, b)| a.0 * b.1 - a.1 * b.0).sum()
}

/// The same random numbers in every run (Marsaglia's xorshift).
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0 >> 11
    }
    /// Between -1 and 1; one in four is a multiple of 1/4, so that vertices meet planes exactly.
    fn number(&mut self) -> f64 {
        let x = self.bits() as f64 / (1_u64 << 52) as f64 - 1.0;
        if self.bits().is_multiple_of(4) { (x * 4.0).round() / 4.0 } else { x }
    }
    fn position(&mut self) -> Vec3 {
        let w = 5.0 * self.number() + 3.0;
        let reach = if self.bits().is_multiple_of(2) { 1.5 * w.abs() } else { 12.0 };
        // Now and then exactly on a side, where rounding has most to break.
        match self.bits() % 8 {
            0 => Vec3::new(w, self.number() * reach, w),
            1 => Vec3::new(self.number() * reach, -w, w),
            _ => Vec3::new(self.number() * reach, self.number() * reach, w),
        }
    }
    fn vertex(&mut self) -> ClipVertex {
        let mut attributes = [0.0; MAX_ATTRIBUTES];
        attributes.fill_with(|| self.number());
        ClipVertex { position: self.position(), attributes, edge: EdgeKind::Original }
    }
}

/// The vertices left on the edge from `a` to `b`, found by an attribute that is 0 on it and more elsewhere, however near.
fn points_on_edge(a: Vec3, b: Vec3, apex: Vec3, volume: &ClipVolume) -> Vec<[u64; 3]> {
    let with = |position, off_edge| {
        let mut attributes = [0.0; MAX_ATTRIBUTES];
        attributes[0] = off_edge;
        ClipVertex { position, attributes, edge: EdgeKind::Original }
    };
    let triangle = [with(a, 0.0), with(b, 0.0), with(apex, 1.0)];
    let kept = clipped(&triangle, volume);
    kept.iter().filter(|v| v.attributes[0] == 0.0).map(|v| v.position.to_array().map(f64::to_bits)).collect()
}

/// Two triangles on either side of an edge: the kept parts of the edge must agree in every bit. Returns how many points they share.
fn assert_watertight(a: Vec3, b: Vec3, apexes: [Vec3; 2], volume: &ClipVolume) -> usize {
    let mut left = points_on_edge(a, b, apexes[0], volume);
    let mut right = points_on_edge(b, a, apexes[1], volume);
    left.sort_unstable();
    right.sort_unstable();
    // A side that only touches the volume with this edge is dropped whole; then there is nothing to leak.
    if !left.is_empty() && !right.is_empty() {
        assert_eq!(left, right, "{a} {b} {apexes:?}");
    }
    left.len().min(right.len())
}

proptest! {
    #![proptest_config(ProptestConfig { rng_seed: RngSeed::Fixed(1996), ..ProptestConfig::default() })]
    #[test]
    fn neighbors_stay_watertight(
        coordinates in prop::array::uniform12(prop_oneof![-20.0..20.0_f64, (-8..9_i32).prop_map(f64::from), -1e9..1e9_f64]),
        closed in any::<bool>(),
    ) {
        let point = |i: usize| Vec3::from_slice(&coordinates[3 * i..]);
        assert_watertight(point(0), point(1), [point(2), point(3)], if closed { &CLOSED } else { &OPEN });
    }
}

#[test]
fn many_neighbors_stay_watertight() {
    let mut random = Random(7);
    let mut shared = 0;
    for _ in 0..200_000 {
        let [a, b, c, d] = std::array::from_fn(|_| random.position());
        shared += assert_watertight(a, b, [c, d], &CLOSED);
    }
    assert!(shared > 100_000, "only {shared} points were shared");
}

#[test]
fn no_vertex_is_left_outside() {
    let mut random = Random(11);
    let mut clipper = Clipper::default();
    // Planes at round numbers would hide what rounding does.
    let volume = ClipVolume { hither: 0.3, yon: Some(7.7) };
    let mut made = 0;
    for _ in 0..1_000_000 {
        let mut vertices: [ClipVertex; 5] = std::array::from_fn(|_| random.vertex());
        // Every fourth polygon has an edge that lies in hither or yon and is cut by a side.
        match random.bits() % 8 {
            0 => vertices[..2].iter_mut().for_each(|v| v.position.z = 0.3),
            1 => vertices[1..3].iter_mut().for_each(|v| v.position.z = 7.7),
            _ => {}
        }
        let kept = match clipper.clip(&vertices[..3 + (random.bits() % 3) as usize], &volume, 2) {
            Clipped::Cut(kept) => kept,
            Clipped::NotFinite => panic!("{vertices:?}"),
            Clipped::Inside | Clipped::Outside => continue,
        };
        for (a, b) in edges(kept) {
            assert!(is_inside(a.position, &volume), "{} of {vertices:?}", a.position);
            assert!(a.position != b.position, "doubled {}", a.position);
        }
        made += kept.len();
    }
    assert!(made > 1_000_000, "only {made} vertices were made");
}

#[test]
fn inside_is_untouched_and_outside_is_nothing() {
    let inside = polygon(&[(-1.0, -1.0, 1.0), (8.0, -8.0, 8.0), (0.0, 2.0, 3.0)]);
    let mut clipper = Clipper::default();
    assert_eq!(clipper.clip(&inside, &CLOSED, 0), Clipped::Inside);
    for outside in [
        [(0.0, 0.0, 0.5), (0.1, 0.0, 0.5), (0.0, 0.1, -3.0)],
        [(3.0, 0.0, 2.0), (9.0, 1.0, 2.0), (5.0, 9.0, 4.0)],
        [(0.0, 0.0, 9.0), (1.0, 0.0, 8.5), (0.0, 1.0, 10.0)],
        // Behind the eye; its mirror image would be in the middle of the screen.
        [(0.1, 0.0, -2.0), (0.0, 0.1, -2.0), (-0.1, -0.1, -2.0)],
        // Past a corner: no plane has all of it outside, but the planes together do.
        [(3.5, 1.0, 2.0), (4.0, 4.0, 2.0), (1.0, 3.5, 2.0)],
    ] {
        assert_eq!(clipper.clip(&polygon(&outside), &CLOSED, 0), Clipped::Outside, "{outside:?}");
    }
}

#[test]
fn polygon_around_the_volume_becomes_the_window() {
    let around = polygon(&[(-99.0, -99.0, 2.0), (99.0, -99.0, 2.0), (99.0, 99.0, 2.0), (-99.0, 99.0, 2.0)]);
    let mut kept = clipped(&around, &CLOSED);
    kept.sort_by_key(|v| (v.position.y > 0.0, (v.position.x > 0.0) != (v.position.y > 0.0)));
    assert_eq!(positions(&kept), [[-2.0, -2.0, 2.0], [2.0, -2.0, 2.0], [2.0, 2.0, 2.0], [-2.0, 2.0, 2.0]]);
    assert!(kept.iter().all(|v| v.edge == EdgeKind::Cut));

    // Tilted, so that every corner has its own w: still the four corners, each exactly on its two planes.
    let tilted = polygon(&[(-90.0, -70.0, 2.3), (95.0, -80.0, 2.9), (99.0, 91.0, 3.7), (-94.0, 81.0, 3.1)]);
    let kept = clipped(&tilted, &OPEN);
    assert_eq!(kept.len(), 4);
    assert!(kept.iter().all(|v| v.position.x.abs() == v.position.z && v.position.y.abs() == v.position.z));
    assert_eq!(doubled_area(&kept), 8.0);
}

#[test]
fn touching_is_not_enough() {
    // A corner in a corner of the window, an edge along a side, a corner on hither: nothing of them is inside.
    for touching in [
        [(2.0, 2.0, 2.0), (3.0, 2.0, 2.0), (3.0, 3.0, 2.0)],
        [(2.0, -1.0, 2.0), (3.0, 0.0, 2.0), (2.0, 1.0, 2.0)],
        [(0.0, 0.0, 1.0), (0.1, 0.0, 0.5), (0.0, 0.1, 0.5)],
    ] {
        assert!(clipped(&polygon(&touching), &CLOSED).is_empty(), "{touching:?}");
    }
    // Several points on a side are still no area.
    let fingers = [(2.0, -1.0), (4.0, 0.0), (2.0, 1.0), (3.0, 0.5), (2.0, 0.0), (3.0, -0.5)].map(|(x, y)| (x, y, 2.0));
    assert!(clipped(&polygon(&fingers), &CLOSED).is_empty());
    // From inside, the same edge along a side is no reason to cut.
    let inside = polygon(&[(2.0, 1.0, 2.0), (1.0, 0.0, 2.0), (2.0, -1.0, 2.0)]);
    assert_eq!(Clipper::default().clip(&inside, &CLOSED, 0), Clipped::Inside);
}

#[test]
fn vertex_on_a_plane_is_its_own_crossing() {
    let kept = clipped(&polygon(&[(0.0, -1.0, 2.0), (2.0, 0.0, 2.0), (3.0, 0.0, 2.0), (0.0, 1.5, 2.0)]), &OPEN);
    assert_eq!(positions(&kept), [[0.0, -1.0, 2.0], [2.0, 0.0, 2.0], [2.0, 0.5, 2.0], [0.0, 1.5, 2.0]]);
    let kinds: Vec<_> = kept.iter().map(|v| v.edge).collect();
    assert_eq!(kinds, [EdgeKind::Original, EdgeKind::Cut, EdgeKind::Original, EdgeKind::Original]);
}

#[test]
fn edge_on_a_side_stays_on_it() {
    let mut random = Random(13);
    for _ in 0..10_000 {
        let [near, far] = [3.0 + random.number(), 9.0 + random.number()];
        let kept = clipped(&polygon(&[(-near, 0.0, near), (-far, 0.1 * far, far), (0.0, 0.2, near)]), &CLOSED);
        assert_eq!(kept[1].position.with_y(0.0), Vec3::new(-8.0, 0.0, 8.0));
    }
}

#[test]
fn vertex_at_the_eye_and_behind_it() {
    let kept = clipped(&polygon(&[(0.0, -0.5, 2.0), (0.0, 0.0, 0.0), (0.0, 0.5, 2.0), (-0.5, 0.0, 2.0)]), &OPEN);
    assert_eq!(positions(&kept)[1..3], [[0.0, -0.25, 1.0], [0.0, 0.25, 1.0]]);
    assert_eq!(kept[1].edge, EdgeKind::Cut);
    let kept = clipped(&polygon(&[(0.0, -1.0, 3.0), (0.5, 0.0, -1.0), (0.0, 1.0, 3.0)]), &OPEN);
    assert_eq!(positions(&kept), [[0.0, -1.0, 3.0], [0.25, -0.5, 1.0], [0.25, 0.5, 1.0], [0.0, 1.0, 3.0]]);
}

/// A comb of `teeth` teeth, each 1 wide and 9 long from y = 0, on a spine down to y = -1.
fn comb(teeth: i32) -> Vec<(f64, f64)> {
    let mut points = vec![(0.0, -1.0), (f64::from(2 * teeth - 1), -1.0)];
    for tooth in (0..teeth).rev() {
        let (left, right) = (f64::from(2 * tooth), f64::from(2 * tooth + 1));
        points.extend([(right, 0.0), (right, 9.0), (left, 9.0), (left, 0.0)]);
    }
    points
}

#[test]
fn comb_leaves_exact_area_at_every_plane() {
    // Inside are the spine (31 wide, and 1 high) and half of every tooth, or the other halves alone.
    for (keeps_spine, area) in [(true, 31.0 + 16.0 * 4.5), (false, 16.0 * 4.5)] {
        let flip = if keeps_spine { 1.0 } else { -1.0 };
        for quarter_turns in 0..4 {
            let placed = comb(16).into_iter().map(|(x, y)| {
                let (mut x, mut y) = (flip * (x - 16.0), 128.0 + flip * (y - 4.5));
                for _ in 0..quarter_turns {
                    (x, y) = (-y, x);
                }
                vertex(x, y, 128.0)
            });
            let kept = clipped(&placed.collect::<Vec<_>>(), &OPEN);
            assert_eq!(doubled_area(&kept) * 128.0 * 128.0, 2.0 * area, "{quarter_turns} {keeps_spine}");
            assert!(kept.iter().all(|v| is_inside(v.position, &OPEN)));
        }
        // Against hither and yon the comb stands in depth: y becomes w.
        for (volume, offset, sign) in [(OPEN, 1.0, -flip), (CLOSED, 8.0, flip)] {
            let placed = comb(16).into_iter().map(|(x, y)| vertex(x / 64.0, 0.0, offset + sign * (y - 4.5) / 16.0));
            let kept = clipped(&placed.collect::<Vec<_>>(), &volume);
            let doubled: f64 =
                edges(&kept).map(|(a, b)| (a.position, b.position)).map(|(a, b)| a.x * b.z - a.z * b.x).sum();
            assert_eq!(doubled * sign * 64.0 * 16.0, 2.0 * area, "{volume:?} {keeps_spine}");
        }
    }
}

#[test]
fn winding_and_area_stay() {
    // The part of a random triangle inside the window, against a sum of thin strips.
    let mut random = Random(3);
    for _ in 0..300 {
        let corners: [(f64, f64); 3] = std::array::from_fn(|_| (2.0 * random.number(), 2.0 * random.number()));
        let triangle = corners.map(|(x, y)| vertex(4.0 * x, 4.0 * y, 4.0));
        let whole = doubled_area(&triangle);
        let kept = doubled_area(&clipped(&triangle, &OPEN));
        assert!(kept * whole >= 0.0 && kept.abs() <= whole.abs() + 1e-14, "{kept} of {whole}");
        let strips: f64 = (0..2048).map(|i| width_at(&corners, (f64::from(i) + 0.5) / 1024.0 - 1.0) / 1024.0).sum();
        assert!((kept.abs() - 2.0 * strips).abs() < 5e-3, "{kept} {strips}");
    }
}

/// How wide the triangle is at height `y`, counting only |x| <= 1.
fn width_at(corners: &[(f64, f64)], y: f64) -> f64 {
    let crossings: Vec<f64> = edges(corners)
        .filter(|(a, b)| (a.1 < y) != (b.1 < y))
        .map(|(a, b)| a.0 + (b.0 - a.0) * ((y - a.1) / (b.1 - a.1)))
        .map(|x| x.clamp(-1.0, 1.0))
        .collect();
    crossings.first().zip(crossings.get(1)).map_or(0.0, |(a, b)| (a - b).abs())
}

#[test]
fn attributes_are_linear_and_constants_stay_constant() {
    let mut random = Random(5);
    let mut clipper = Clipper::default();
    for _ in 0..20_000 {
        let mut triangle: [ClipVertex; 3] = std::array::from_fn(|_| random.vertex());
        for v in &mut triangle {
            v.attributes = [v.position.x, v.position.y, v.position.z, 0.1, 0.7, 9.0, 9.0, 9.0];
        }
        let Clipped::Cut(kept) = clipper.clip(&triangle, &CLOSED, 5) else { continue };
        for v in kept {
            let [x, y, w, tenth, most, rest @ ..] = v.attributes;
            assert!((Vec3::new(x, y, w) - v.position).abs().max_element() < 1e-13, "{v:?}");
            assert_eq!((tenth, most), (0.1, 0.7));
            assert!(rest == [9.0; 3] || rest == [0.0; 3]);
        }
    }
}

#[test]
fn extremes_are_exact_or_reported() {
    let mut clipper = Clipper::default();
    for exponent in [-1000, -600, -100, 100, 600, 1000] {
        let size = f64::from(exponent).exp2();
        let volume = ClipVolume { hither: size, yon: None };
        let shape = polygon(
            &[(0.0, -1.0, 3.0), (0.5, 0.0, -1.0), (0.0, 1.0, 3.0)].map(|(x, y, w)| (x * size, y * size, w * size)),
        );
        let Clipped::Cut(kept) = clipper.clip(&shape, &volume, 0) else { panic!("2^{exponent}") };
        assert_eq!(kept[1].position / size, Vec3::new(0.25, -0.5, 1.0), "2^{exponent}");
    }
    let m = f64::MAX;
    for huge in [[(m, m, m), (-m, 0.0, -m), (0.0, -m, m)], [(f64::NAN, 0.0, 2.0), (0.0, 0.0, 2.0), (1.0, 0.0, 2.0)]] {
        assert_eq!(clipper.clip(&polygon(&huge), &OPEN, 0), Clipped::NotFinite, "{huge:?}");
    }
    let infinite = polygon(&[(1.0, 0.0, f64::INFINITY), (0.0, 1.0, 2.0), (-1.0, 0.0, 2.0)]);
    assert_eq!(clipper.clip(&infinite, &OPEN, 0), Clipped::NotFinite);
    assert_eq!(clipper.clip(&[], &OPEN, 0), Clipped::Outside);
}
