//! Coverage against an independent integer test: every sample, every tie, every shared edge.
//!
//! A small run; the full one, a million triangles, is `cargo run --release --example coverage_full`.

mod support;

use farop::raster::ZBuffer;
use farop::screen::DrawList;
use support::cut::CutTally;
use support::half_planes::HalfPlanes;
use support::random::Random;
use support::shapes::Shapes;
use support::tally::Tally;

const BITS: [u32; 5] = [0, 4, 8, 12, 16];

#[test]
fn spans_equal_half_planes() {
    for bits in BITS {
        let mut tally = Tally::default();
        let mut shapes = Shapes { random: Random::new(u64::from(bits) + 1), steps: 1 << bits };
        // Many small ones, sample by sample, and some of all sizes.
        tally.run(&mut shapes, 1_500, 64.0);
        tally.run(&mut shapes, 300, 4096.0);
        assert!(
            tally.is_clean(),
            "{bits} bits: {} wrong, {} holes, {} doubles",
            tally.wrong,
            tally.holes,
            tally.doubles
        );
        // The test is worth something only if it met what is difficult.
        let met = [tally.ties.on_edges, tally.shared_edges, tally.outlines, tally.ties.one_by_one, tally.samples];
        let least = [4_000, 500, 20, 200_000, 3_000_000];
        assert!(met.iter().zip(least).all(|(&met, least)| met >= least), "{bits} bits: {met:?}");
        assert!(bits == 0 || tally.corners_on_centers > 1_000, "{bits} bits: {}", tally.corners_on_centers);
    }
}

#[test]
fn cut_polygons_leave_no_hole() {
    for bits in BITS {
        let mut cut = CutTally::default();
        cut.run(&mut Random::new(u64::from(bits) + 77), bits, 12);
        assert!(cut.tally.is_clean(), "{bits} bits: {} holes, {} doubles", cut.tally.holes, cut.tally.doubles);
        assert_eq!((cut.lost, cut.flipped), (0, 0), "{bits} bits");
        assert!(cut.cut > 80, "{bits} bits: {} cut", cut.cut);
    }
}

/// The z-buffer itself: meshes, each triangle in a color of its own, every sample by the half-planes.
#[test]
fn zbuffer_shows_the_covering_triangle() {
    let mut shapes = Shapes { random: Random::new(5), steps: 256 };
    let (mut groups, mut samples) = (0, 0);
    while groups < 40 {
        let Some(group) = shapes.group(80.0) else { continue };
        groups += 1;
        let all = || group.triangles.iter().flatten();
        let (left, top) = (all().map(|p| p.0 >> 8).min(), all().map(|p| p.1 >> 8).min());
        let origin = (left.unwrap_or(0) << 8, top.unwrap_or(0) << 8);
        let moved = |p: (i64, i64)| (p.0 - origin.0, p.1 - origin.1);
        let mut list = DrawList::new(100, 100);
        let mut triangles = Vec::new();
        for (index, triangle) in group.triangles.iter().enumerate() {
            let corners = triangle.map(moved).map(|(x, y)| (x as f64 / 256.0, y as f64 / 256.0));
            list.push_flat(&corners, 1.0 + index as f64, [(index + 1) as f64, 0.0, 0.0]);
            triangles.push(HalfPlanes::new(triangle.map(moved).map(|(x, y)| (2 * x, 2 * y)), 256));
        }
        let (image, counts) = support::draw(&list, &ZBuffer);
        let mut covered = 0;
        for (x, y) in (0..100).flat_map(|y| (0..100).map(move |x| (x, y))) {
            let of = triangles.iter().position(|triangle| triangle.covers(x, y)).map_or(0, |index| index + 1);
            assert_eq!(image.pixel(x as usize, y as usize).r, of as f32, "group {groups}, sample ({x}, {y})");
            covered += u64::from(of > 0);
        }
        assert_eq!((counts.puts, counts.overdraw, counts.stray_writes), (covered, 0, 0));
        samples += covered;
    }
    assert!(samples > 10_000, "{samples}");
}
