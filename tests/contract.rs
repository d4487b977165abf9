//! The rasterizer contract, on lists small enough to check by eye or by hand; `planes.rs` has depth and varyings.

mod support;

use farop::color::Rgb;
use farop::plan::Transparency;
use farop::raster::{Frame, PerPolygon, PolygonRasterizer, Rasterizer, Target, ZBuffer};
use farop::render::{Canvas, draw as draw_canvas};
use farop::screen::{DrawList, Fragment, ScreenPolygon, Shader};
use support::random::Random;
use support::{assert_coverage, digits, draw, draw_over, polygon};

const BLACK: Rgb<f32> = Rgb::gray(0.0);

#[test]
fn shared_edge_is_drawn_once() {
    let [a, b, c, d] = [(1.0, 1.0), (5.0, 1.0), (5.0, 5.0), (1.0, 5.0)];
    assert_coverage(
        &[polygon(1, &[a, b, c]), polygon(2, &[a, c, d])],
        "
        . . . . . .
        . 1 1 1 1 .
        . 2 1 1 1 .
        . 2 2 1 1 .
        . 2 2 2 1 .
        . . . . . .",
    );
}

#[test]
fn centers_on_left_and_upper_edges_are_covered() {
    let [a, b, c, d] = [(1.5, 1.5), (4.5, 1.5), (4.5, 4.5), (1.5, 4.5)];
    let right = [(4.5, 1.5), (5.5, 3.5), (4.5, 4.5)];
    assert_coverage(
        &[polygon(1, &[d, c, b, a]), polygon(2, &right)],
        "
        . . . . . .
        . 1 1 1 . .
        . 1 1 1 2 .
        . 1 1 1 2 .
        . . . . . .
        . . . . . .",
    );
}

#[test]
fn coverage_is_even_odd() {
    // A five-pointed star: its middle is inside twice.
    let star = [(5.5, 0.0), (8.9, 10.5), (0.0, 4.0), (11.0, 4.0), (2.1, 10.5)];
    assert_coverage(
        &[polygon(7, &star)],
        "
        . . . . . 7 . . . . .
        . . . . . 7 . . . . .
        . . . . . 7 . . . . .
        . . . . 7 7 7 . . . .
        . 7 7 7 . . . 7 7 7 .
        . . 7 7 . . . 7 7 . .
        . . . . . . . . . . .
        . . . 7 7 . 7 7 . . .
        . . . 7 7 . 7 7 . . .
        . . 7 . . . . . 7 . .
        . . . . . . . . . . .",
    );
}

#[test]
fn at_equal_depth_the_first_of_the_list_stays() {
    let mut list = DrawList::new(4, 2);
    list.push_flat(&[(0.0, 0.0), (3.0, 0.0), (3.0, 2.0), (0.0, 2.0)], 0.5, [1.0 / 16.0; 3]);
    list.push_flat(&[(1.0, 0.0), (4.0, 0.0), (4.0, 2.0), (1.0, 2.0)], 0.5, [2.0 / 16.0; 3]);
    list.push_flat(&[(2.0, 1.0), (4.0, 1.0), (4.0, 2.0), (2.0, 2.0)], 0.75, [3.0 / 16.0; 3]);
    assert_eq!(digits(&draw(&list, &ZBuffer).0), "1 1 1 2\n1 1 3 3");
}

/// Puts every polygon's samples at their place and far outside, too.
struct Careless;

impl PolygonRasterizer for Careless {
    fn draw_polygon(&self, polygon: &ScreenPolygon<'_>, shader: &Shader, target: &mut Target<'_>) {
        for (x, y) in [(0, 0), (-1, 0), (0, -1), (2, 0), (0, 2), (i32::MIN, i32::MAX), (1, 1)] {
            target.put(shader.fragment(polygon, x, y));
        }
    }
}

#[test]
fn stray_writes_are_dropped_and_counted() {
    let mut list = DrawList::new(2, 2);
    list.push_flat(&[(0.0, 0.0), (2.0, 0.0), (0.0, 2.0)], 1.0, [5.0 / 16.0; 3]);
    let (image, counts) = draw(&list, &PerPolygon(Careless));
    assert_eq!(digits(&image), "5 .\n. 5");
    assert_eq!((counts.puts, counts.stray_writes, counts.overdraw), (2, 5, 0));
}

#[test]
fn a_target_arrives_with_background_and_depth_zero() {
    let mut frame = Frame::default();
    let sky = Rgb::new(0.1, 0.2, 0.3);
    for _ in 0..2 {
        let mut target = frame.target((3, 2), 0..2, sky, Transparency::Over);
        assert_eq!((target.width(), target.height(), target.row_range()), (3, 2, 0..2));
        assert!((0..3).all(|x| target.depth(x, 1) == 0.0) && target.depth(7, 7) == 0.0);
        target.put(Fragment { x: 1, y: 1, depth: 0.25, color: BLACK, opacity: Rgb::gray(1.0), polygon: 0 });
        assert_eq!(target.depth(1, 1), 0.25);
        target.finish();
        let image = frame.image(3, 0..2);
        assert_eq!((image.pixel(0, 1), image.pixel(1, 1)), (sky, BLACK));
    }
}

/// Overlapping triangles at random, some of them transparent.
fn crowd(width: u32, height: u32, seed: u64) -> DrawList {
    let mut random = Random::new(seed);
    let mut list = DrawList::new(width, height);
    for index in 0..60 {
        let mut corner = || (random.between(0.0, f64::from(width)), random.between(0.0, f64::from(height)));
        let corners = [corner(), corner(), corner()];
        // Few depths, so that ties are frequent.
        let depth = random.whole(1, 8) as f64 / 8.0;
        list.push_flat(&corners, depth, [random.unit(), random.unit(), random.unit()]);
        if random.one_in(3) {
            list.shader.surfaces[index].opacity = Rgb::new(0.25, 0.5, 0.75);
        }
    }
    list
}

#[test]
fn bands_draw_what_one_target_draws() {
    let list = crowd(50, 37, 3);
    let sky = Rgb::new(0.5, 0.25, 0.125);
    let whole = draw_over(&list, &ZBuffer, sky, Transparency::Over);
    assert!(whole.1.overdraw > 100);
    for count in [1, 2, 3, 8, 37, 100] {
        let mut frame = Frame::default();
        let mut target = frame.target((50, 37), 0..37, sky, Transparency::Over);
        target.bands(count, |band| ZBuffer.draw(&list, band));
        let counts = target.finish();
        assert_eq!((frame.image(50, 0..37), counts), whole, "{count} bands");
    }
}

#[test]
fn the_same_list_gives_the_same_picture_twice() {
    let list = crowd(40, 40, 9);
    assert_eq!(draw(&list, &ZBuffer), draw(&list, &ZBuffer));
}

/// A fragment of gray light in the only sample.
fn fragment(polygon: u32, depth: f64, light: f32, opacity: f32) -> Fragment {
    Fragment { x: 0, y: 0, depth, color: Rgb::gray(light), opacity: Rgb::gray(opacity), polygon }
}

fn shown(fragments: &[Fragment], rule: Transparency) -> f32 {
    let mut frame = Frame::default();
    let mut target = frame.target((1, 1), 0..1, Rgb::gray(0.5), rule);
    fragments.iter().for_each(|&fragment| target.put(fragment));
    target.finish();
    frame.image(1, 0..1).pixel(0, 0).r
}

#[test]
fn transparency_does_not_depend_on_drawing_order() {
    // Front to back: a quarter of 1, half of 0.25, the wall at 0.75; one layer lies behind the wall.
    let layers = [
        fragment(0, 2.0, 1.0, 0.25),
        fragment(1, 1.5, 0.25, 0.5),
        fragment(2, 1.0, 0.75, 1.0),
        fragment(3, 0.5, 9.0, 0.5),
    ];
    let over = 0.25 + 0.75 * (0.5 * 0.25 + 0.5 * 0.75);
    let additive = 0.25 + 0.5 * 0.25 + 0.25 * 0.75;
    for (rule, expected) in [(Transparency::Over, over), (Transparency::Additive, additive)] {
        for first in 0..4 {
            for step in [1, 3] {
                let order: Vec<_> = (0..4).map(|i| layers[(first + i * step) % 4]).collect();
                assert_eq!(shown(&order, rule), expected, "{rule:?} from {first} by {step}");
            }
        }
    }
    // At equal depth the first of the list is in front: of two layers, and of a layer and the wall.
    let [a, b] = [fragment(0, 1.0, 1.0, 0.5), fragment(1, 1.0, 0.0, 0.5)];
    assert_eq!([shown(&[a, b], Transparency::Over), shown(&[b, a], Transparency::Over)], [0.625; 2]);
    assert_eq!(shown(&[fragment(2, 1.0, 1.0, 0.5), fragment(1, 1.0, 0.25, 1.0)], Transparency::Over), 0.25);
    assert_eq!(shown(&[fragment(0, 1.0, 1.0, 0.5), fragment(1, 1.0, 0.25, 1.0)], Transparency::Over), 0.625);
}

#[test]
fn a_transparent_fragment_leaves_depth_alone() {
    let mut frame = Frame::default();
    let mut target = frame.target((1, 1), 0..1, BLACK, Transparency::Over);
    target.put(fragment(0, 2.0, 1.0, 0.5));
    assert_eq!(target.depth(0, 0), 0.0);
    let counts = target.finish();
    assert_eq!((counts.puts, counts.overdraw), (1, 0));
}

#[test]
fn supersampling_is_a_larger_picture_averaged() {
    let list = crowd(60, 42, 5);
    let sky = Rgb::new(0.5, 0.25, 0.125);
    let large = draw_over(&list, &ZBuffer, sky, Transparency::Over).0;
    for samples in [1, 2, 3, 6] {
        let canvas = Canvas { samples, background: sky, transparency: Transparency::Over, threads: 1 };
        let (small, _) = draw_canvas(&list, Some(&ZBuffer), &canvas);
        let a = samples as usize;
        assert_eq!((small.width(), small.height()), (60 / a, 42 / a));
        for (x, y) in (0..42 / a).flat_map(|y| (0..60 / a).map(move |x| (x, y))) {
            let mut sum = [0.0; 3];
            for (i, j) in (0..a).flat_map(|j| (0..a).map(move |i| (i, j))) {
                let light = large.pixel(x * a + i, y * a + j).to_array();
                (0..3).for_each(|channel| sum[channel] += f64::from(light[channel]));
            }
            let mean = sum.map(|channel| (channel / (a * a) as f64) as f32);
            assert_eq!(small.pixel(x, y).to_array(), mean, "{samples} samples, ({x}, {y})");
        }
    }
}

#[test]
fn without_a_rasterizer_there_is_only_background() {
    let canvas = Canvas { samples: 2, background: Rgb::gray(0.25), transparency: Transparency::Over, threads: 1 };
    let (image, counts) = draw_canvas(&crowd(8, 8, 1), None, &canvas);
    assert!(image.pixels().iter().all(|&pixel| pixel == Rgb::gray(0.25)) && image.pixels().len() == 16);
    assert_eq!(counts.puts, 0);
}
