//! Depth and varyings: the contract's one order of operations, written once more, and the depth formats.

mod support;

use farop::plan::{DepthFormat, Interpolation};
use farop::raster::ZBuffer;
use farop::screen::{BLOCK, DepthMapping, DrawList, Evaluation, Plane, Precision};
use support::random::Random;
use support::{digits, draw};

/// The written order of operations, once more: anchor in f64, rounded once, steps in f32.
fn by_the_book(plane: &Plane, x: i32, y: i32) -> f32 {
    let (left, top) = (x.div_euclid(16) * 16, y.div_euclid(16) * 16);
    let anchor = plane.a * (f64::from(left) + 0.5) + plane.b * (f64::from(top) + 0.5) + plane.c;
    anchor as f32 + (plane.a as f32 * (x - left) as f32 + plane.b as f32 * (y - top) as f32)
}

fn clamped(value: f32, plane: &Plane) -> f32 {
    value.max(plane.low as f32).min(plane.high as f32)
}

/// A triangle whose depth and colors vary; the values / w of the colors are planes of their own.
fn sloping(random: &mut Random, precision: Precision) -> DrawList {
    let mut list = DrawList::new(300, 300);
    list.precision = precision;
    list.push_flat(&[(0.0, 0.0), (300.0, 0.0), (0.0, 300.0)], 1.0, [0.5; 3]);
    let mut slope = |low: f64, high: f64| {
        let (c, a, b) = (random.between(low, high), random.between(-1e-3, 1e-3), random.between(-1e-3, 1e-3));
        [a, b, c]
    };
    // The ranges are narrower than the planes over the picture, so that clamping happens.
    list.planes[0] = Plane::new(slope(1.0, 2.0), (0.9, 1.9), (0.9, 1.9), precision);
    for number in 1..4 {
        list.planes[number] = Plane::new(slope(0.5, 1.0), (0.4, 1.0), (0.4, 0.9), precision);
    }
    list
}

#[test]
fn planes_are_evaluated_in_the_written_order() {
    assert_eq!(BLOCK, 16);
    let mut random = Random::new(11);
    let (mut low, mut high) = (0, 0);
    for _ in 0..20 {
        let list = sloping(&mut random, Precision::Single);
        assert!(list.planes.iter().all(|plane| plane.evaluation == Evaluation::Blocks));
        let polygon = list.polygon(0);
        for _ in 0..2_000 {
            let (x, y) = (random.whole(0, 299) as i32, random.whole(0, 299) as i32);
            let inverse_w = clamped(by_the_book(&list.planes[0], x, y), &list.planes[0]);
            assert_eq!(polygon.depth(x, y), f64::from(inverse_w), "depth at ({x}, {y})");
            low += u32::from(inverse_w == 0.9);
            high += u32::from(inverse_w == 1.9);
            let values = polygon.values(x, y);
            let fragment = list.shader.fragment(&polygon, x, y);
            for number in 0..3 {
                let plane = &list.planes[number + 1];
                let value = clamped(by_the_book(plane, x, y) / inverse_w, plane);
                assert_eq!(values[number], f64::from(value), "color {number} at ({x}, {y})");
                assert_eq!(fragment.color.to_array()[number], value);
            }
            assert_eq!((fragment.x, fragment.y, fragment.depth), (x, y, f64::from(inverse_w)));
        }
    }
    assert!(low > 100 && high > 100, "clamped {low} and {high} times");
}

#[test]
fn screen_interpolation_does_not_divide() {
    let mut list = sloping(&mut Random::new(2), Precision::Single);
    list.interpolation = Interpolation::Screen;
    let plane = &list.planes[2];
    for (x, y) in [(0, 0), (17, 40), (299, 3)] {
        assert_eq!(list.polygon(0).values(x, y)[1], f64::from(clamped(by_the_book(plane, x, y), plane)));
    }
}

#[test]
fn depth_f64_rounds_nothing_to_f32() {
    let mut random = Random::new(12);
    let list = sloping(&mut random, Precision::Double);
    let exact =
        |plane: &Plane, x: i32, y: i32| plane.a * (f64::from(x) + 0.5) + plane.b * (f64::from(y) + 0.5) + plane.c;
    let mut longer = 0;
    for _ in 0..1_000 {
        let (x, y) = (random.whole(0, 299) as i32, random.whole(0, 299) as i32);
        let inverse_w = exact(&list.planes[0], x, y).clamp(0.9, 1.9);
        let value = (exact(&list.planes[3], x, y) / inverse_w).clamp(0.4, 0.9);
        assert_eq!((list.polygon(0).depth(x, y), list.polygon(0).values(x, y)[2]), (inverse_w, value));
        longer += u32::from(inverse_w != f64::from(inverse_w as f32));
    }
    assert!(longer > 500);
}

#[test]
fn a_steep_plane_is_evaluated_at_every_sample() {
    // Changes by 15 * 20 in a block, more than 256 times its range of 1.
    let plane = Plane::new([20.0, 1e-9, -100.03], (0.0, 1.0), (0.0, 1.0), Precision::Single);
    assert_eq!(plane.evaluation, Evaluation::Samples);
    let gentle = Plane::new([17.0, 0.0, -100.03], (0.0, 1.0), (0.0, 1.0), Precision::Single);
    assert_eq!(gentle.evaluation, Evaluation::Blocks);
    for (x, y) in [(3, 900), (4, 11), (5, 0), (31, 2)] {
        let exact = 20.0 * (f64::from(x) + 0.5) + 1e-9 * (f64::from(y) + 0.5) - 100.03;
        assert_eq!(plane.at(x, y), f64::from(exact as f32));
        assert_eq!(plane.clamped_at(x, y), f64::from((exact as f32).clamp(0.0, 1.0)));
    }
}

#[test]
fn integer_depth_counts_steps_from_yon_to_hither() {
    for (format, steps) in [(DepthFormat::Int16, 65_535.0), (DepthFormat::Int24, 16_777_215.0)] {
        // hither 1, yon 4.
        let mapping = DepthMapping { format, nearest: 1.0, farthest: 0.25 };
        assert_eq!([0.25, 1.0].map(|inverse_w| mapping.apply(inverse_w)), [1.0, steps]);
        let step = 0.75 / (steps - 1.0);
        for k in [2.0, 3.0, 1000.0, steps - 1.0] {
            let at = |offset: f64| mapping.apply(0.25 + (k - 1.0 + offset) * step);
            assert_eq!([at(-0.49), at(0.0), at(0.49), at(0.51)], [k, k, k, k + 1.0], "{format:?} step {k}");
        }
        assert_eq!([mapping.apply(0.1), mapping.apply(7.0)], [1.0, steps], "held in the range");
    }
    let plain = DepthMapping { format: DepthFormat::F32, nearest: 1.0, farthest: 0.25 };
    assert_eq!(plain.apply(0.3), 0.3);
}

#[test]
fn integer_depth_merges_what_is_closer_than_a_step() {
    // Two squares 1/3 of a step apart: in f32 the nearer wins, in 16 bits the first.
    let mut list = DrawList::new(1, 1);
    let square = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
    let step = 0.75 / 65_534.0;
    list.push_flat(&square, 0.25 + 1000.0 * step, [1.0 / 16.0; 3]);
    list.push_flat(&square, 0.25 + (1000.0 + 1.0 / 3.0) * step, [2.0 / 16.0; 3]);
    let mut drawn = |format| {
        list.depth_mapping = DepthMapping { format, nearest: 1.0, farthest: 0.25 };
        digits(&draw(&list, &ZBuffer).0)
    };
    let formats = [DepthFormat::F32, DepthFormat::F64, DepthFormat::Int24, DepthFormat::Int16];
    assert_eq!(formats.map(&mut drawn), ["2", "2", "2", "1"]);
}
