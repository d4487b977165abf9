//! Wire against an independent statement of its one rule, diamond exit, in fractions of whole numbers.

mod support;

use farop::math::Vec3;
use farop::plan::{Choices, Shading};
use farop::raster::{PerPolygon, Rasterizer, Wire};
use farop::scene::Material;
use farop::screen::{DrawList, EdgeKind, Grid, Plane, PolygonRecord, Precision, ScreenVertex, Source};
use support::mixed::Mix;
use support::random::Random;
use support::scenes::{camera, facets, run, scene, surface, world};
use support::{digits, draw};

/// A coordinate in half grid steps, and half a sample in the same unit.
const HALF: i64 = 4;
const SIZE: i64 = 12;

type Point = (i64, i64);

/// Draws open lines from point to point; returns how often each sample is put.
fn lines(path: &[Point]) -> Vec<u32> {
    let mut list = DrawList::new(SIZE as u32, SIZE as u32);
    list.grid = Grid { bits: 2 };
    list.shader.line_color = farop::color::Rgb::gray(1.0);
    list.varying = farop::plan::Varying::Nothing;
    list.shader.push_unlit_surface();
    list.planes.push(Plane::constant(1.0, Precision::Single));
    for pair in path.windows(2) {
        let first_vertex = list.vertices.len() as u32;
        // There and back; the way back is not drawn, like an edge that clipping made.
        for (&(x, y), edge) in pair.iter().zip([EdgeKind::Original, EdgeKind::Cut]) {
            let (x, y) = (x as f64 / 8.0, y as f64 / 8.0);
            list.vertices.push(ScreenVertex { x, y, homogeneous: Vec3::new(x, y, 1.0), edge });
        }
        let source = Source::default();
        list.polygons.push(PolygonRecord { first_vertex, vertex_count: 2, first_plane: 0, surface: 0, source });
    }
    // Transparent layers of no light add up to nothing; count by drawing every line alone.
    let mut counts = vec![0; (SIZE * SIZE) as usize];
    let polygons = std::mem::take(&mut list.polygons);
    for polygon in polygons {
        list.polygons = vec![polygon];
        let (image, puts) = draw(&list, &PerPolygon(Wire));
        assert_eq!((puts.overdraw, puts.stray_writes), (0, 0), "one line shows a sample once: {path:?}");
        counts.iter_mut().zip(image.pixels()).for_each(|(count, light)| *count += u32::from(light.r > 0.0));
    }
    counts
}

/// Where a point lies from the center of a sample.
fn from_center((x, y): Point, (column, row): Point) -> Point {
    (x - (2 * column + 1) * HALF, y - (2 * row + 1) * HALF)
}

/// The diamond: its inside, its two upper sides without the right corner, its left corner.
fn in_diamond(point: Point, sample: Point) -> bool {
    let (dx, dy) = from_center(point, sample);
    let distance = dx.abs() + dy.abs();
    distance < HALF || (distance == HALF && (dy < 0 || dx == -HALF))
}

/// Whether a line has a point inside the diamond, or passes its upper or left corner.
fn meets_diamond(a: Point, b: Point, sample: Point) -> bool {
    let (a, b) = (from_center(a, sample), from_center(b, sample));
    // Turned by an eighth, the diamond is a square: |x + y| < HALF and |x - y| < HALF. Parameters in 0..1 as fractions
    // over one denominator: each of the four sides cuts off a part.
    let (mut low, mut high) = ((0_i64, 1_i64), (1_i64, 1_i64));
    for turned in [|p: Point| p.0 + p.1, |p: Point| p.0 - p.1, |p: Point| -p.0 - p.1, |p: Point| p.1 - p.0] {
        // HALF - turned(p) > 0, linear from `at_a` to `at_b`.
        let (at_a, at_b) = (HALF - turned(a), HALF - turned(b));
        let change = at_b - at_a;
        if change == 0 {
            if at_a <= 0 {
                low = (1, 1);
                high = (0, 1);
            }
            continue;
        }
        let root = if change > 0 { (-at_a, change) } else { (at_a, -change) };
        let less = |p: (i64, i64), q: (i64, i64)| p.0 * q.1 < q.0 * p.1;
        if change > 0 && less(low, root) {
            low = root;
        } else if change < 0 && less(root, high) {
            high = root;
        }
    }
    let inside = low.0 * high.1 < high.0 * low.1;
    let passes = |corner: Point| {
        let cross = (b.0 - a.0) * (corner.1 - a.1) - (b.1 - a.1) * (corner.0 - a.0);
        let within = |a: i64, b: i64, c: i64| a.min(b) <= c && c <= a.max(b);
        cross == 0 && within(a.0, b.0, corner.0) && within(a.1, b.1, corner.1)
    };
    inside || passes((0, -HALF)) || passes((-HALF, 0))
}

#[test]
fn a_line_shows_the_samples_whose_diamonds_it_leaves() {
    let mut random = Random::new(8);
    let mut shown = 0;
    for _ in 0..3_000 {
        let mut point = || (2 * random.whole(4, 44), 2 * random.whole(4, 44));
        let (a, b) = (point(), point());
        // At 45 degrees a line may run along the sides of a diamond without entering it: tested apart.
        if (a.0 - b.0).abs() == (a.1 - b.1).abs() {
            continue;
        }
        let drawn = lines(&[a, b]);
        for sample in (0..SIZE).flat_map(|y| (0..SIZE).map(move |x| (x, y))) {
            let touched = meets_diamond(a, b, sample) || in_diamond(a, sample);
            let expected = touched && !in_diamond(b, sample);
            assert_eq!(drawn[(sample.1 * SIZE + sample.0) as usize] > 0, expected, "{a:?} {b:?} at {sample:?}");
            shown += u32::from(expected);
        }
    }
    assert!(shown > 10_000);
}

#[test]
fn where_one_line_ends_and_the_next_begins_the_sample_is_shown_once() {
    let mut random = Random::new(9);
    for _ in 0..3_000 {
        let mut point = || (2 * random.whole(4, 44), 2 * random.whole(4, 44));
        let (a, joint, b) = (point(), point(), point());
        let drawn = lines(&[a, joint, b]);
        let at = |p: Point| (p.0.div_euclid(2 * HALF), p.1.div_euclid(2 * HALF));
        let sample = at(joint);
        let revisited = [a, b].iter().any(|&end| in_diamond(end, sample));
        if in_diamond(joint, sample) && !revisited {
            assert_eq!(drawn[(sample.1 * SIZE + sample.0) as usize], 1, "{a:?} {joint:?} {b:?}");
        }
    }
}

#[test]
fn an_edge_walked_back_differs_at_its_ends_alone() {
    let mut random = Random::new(10);
    let mut differ = 0;
    for _ in 0..2_000 {
        let mut point = || (2 * random.whole(4, 44), 2 * random.whole(4, 44));
        let (a, b) = (point(), point());
        let (there, back) = (lines(&[a, b]), lines(&[b, a]));
        for sample in (0..SIZE).flat_map(|y| (0..SIZE).map(move |x| (x, y))) {
            let index = (sample.1 * SIZE + sample.0) as usize;
            let is_end = in_diamond(a, sample) || in_diamond(b, sample);
            assert!(is_end || there[index] == back[index], "{a:?} {b:?} at {sample:?}");
            differ += u32::from(there[index] != back[index]);
        }
    }
    assert!(differ > 100);
}

/// The picture of outlines on the plane at distance 4, in samples of a 12 x 12 picture.
fn wire(outlines: &[&[(f64, f64)]], choices: &Choices) -> String {
    let place = |&(x, y): &(f64, f64)| world(Vec3::new((x - 6.0) / 6.0, (6.0 - y) / 6.0, 1.0) * 4.0);
    let outlines: Vec<Vec<Vec3>> = outlines.iter().map(|outline| outline.iter().map(place).collect()).collect();
    let choices = Choices { shading: Shading::Wire, ..choices.clone() };
    let (list, ..) = run(&scene(camera(12, 12), vec![surface(Material::default(), facets(&outlines))]), &choices);
    let (image, counts) = draw(&list, &PerPolygon(Wire));
    assert_eq!(counts.stray_writes, 0);
    digits(&image).replace(['1', 'g'], "#").replace(' ', "")
}

fn picture(text: &str) -> String {
    text.lines().map(str::trim).filter(|line| !line.is_empty()).collect::<Vec<_>>().join("\n")
}

#[test]
fn edges_made_by_clipping_are_not_drawn() {
    // Open to the left, where it is cut. Counterclockwise for the viewer.
    let outline = [(-5.5, 3.6), (-5.5, 8.6), (6.5, 8.6), (6.5, 3.6)];
    let expected = picture(
        "............
         ............
         ............
         #######.....
         ......#.....
         ......#.....
         ......#.....
         ......#.....
         #######.....
         ............
         ............
         ............",
    );
    assert_eq!(wire(&[&outline], &Choices::default()), expected);
    // A comb cut through its teeth: no line along the side of the picture joins them.
    let comb = [(5.5, 1.6), (-5.5, 1.6), (-5.5, 3.6), (4.5, 3.6), (4.5, 7.6), (-5.5, 7.6), (-5.5, 9.6), (5.5, 9.6)];
    let expected = picture(
        "............
         ######......
         .....#......
         ######......
         ....##......
         ....##......
         ....##......
         ######......
         .....#......
         ######......
         ............
         ............",
    );
    assert_eq!(wire(&[&comb], &Choices::default()), expected);
}

#[test]
fn two_triangles_share_the_samples_of_their_edge() {
    let [a, b, c, d] = [(1.5, 1.5), (1.5, 9.5), (9.5, 9.5), (9.5, 1.5)];
    let expected = picture(
        "............
         .#########..
         .##......#..
         .#.#.....#..
         .#..#....#..
         .#...#...#..
         .#....#..#..
         .#.....#.#..
         .#......##..
         .#########..
         ............
         ............",
    );
    assert_eq!(wire(&[&[a, b, c], &[a, c, d]], &Choices::default()), expected);
    // A quadrilateral split by choice shows its diagonal, one left whole does not; back faces are not there.
    let split = Choices { triangles: true, ..Choices::default() };
    let whole = wire(&[&[a, b, c, d]], &Choices::default());
    assert_eq!(whole.matches('#').count(), 32);
    assert_eq!(wire(&[&[a, b, c, d]], &split).matches('#').count(), 32 + 7);
    assert_eq!(wire(&[&[d, c, b, a]], &Choices::default()).matches('#').count(), 0);
}

#[test]
fn without_a_target_the_picture_and_the_counts_are_the_same() {
    for seed in 1..=60 {
        let mix = Mix { seed, polygons: 20, transparent: seed % 5 == 0, ..Mix::default() };
        let scene = mix.scene(60);
        let (samples, subpixel_bits) =
            (1 + seed as u32 % 3, [8, 0, 16, farop::plan::EXACT_SUBPIXELS][seed as usize % 4]);
        let choices = Choices { shading: Shading::Wire, samples, subpixel_bits, ..Choices::default() };
        let [target, pixels] = [&PerPolygon(Wire) as &dyn Rasterizer, &Wire].map(|wire| {
            let rendered = farop::render::render(&scene, &choices, Some(wire)).expect("has a view");
            let lit = rendered.image.pixels().iter().filter(|&&light| light != rendered.image.pixel(0, 0)).count();
            assert!(lit > 20, "{lit}");
            let bits = |light: &farop::color::Rgb<f32>| light.to_array().map(f32::to_bits);
            let bits: Vec<_> = rendered.image.pixels().iter().map(bits).collect();
            (bits, rendered.puts.puts, rendered.puts.overdraw)
        });
        assert!(target == pixels, "seed {seed}: {} {} {} {}", target.1, pixels.1, target.2, pixels.2);
    }
}
