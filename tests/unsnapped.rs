//! Nothing snapped: coverage of corners that lie on no grid and up to a billion samples away, held against big integers.

mod support;

use farop::math::Vec3;
use farop::plan::{Choices, Culling, EXACT_SUBPIXELS, Shading};
use farop::raster::coverage::Spans;
use farop::raster::{Rasterizer, Watkins, ZBuffer};
use farop::render::render;
use farop::screen::file::{Attributes, ClassicOptions, Sheet, write_classic, write_v2};
use farop::screen::{DrawList, EdgeKind, Grid, ScreenVertex};
use num_bigint::BigInt;
use num_bigint::Sign::{Minus, NoSign};
use support::draw;
use support::mixed::Mix;
use support::random::Random;
use support::shapes::{SIDE, Shapes};

const SIZE: (u32, u32) = (16, 12);

/// `x * 2^1074`: every finite `f64` is that many whole numbers.
fn whole(x: f64) -> BigInt {
    let (fraction, biased) = (x.to_bits() & ((1 << 52) - 1), (x.to_bits() >> 52) & 0x7FF);
    let magnitude = if biased == 0 { BigInt::from(fraction) } else { BigInt::from(fraction | 1 << 52) << (biased - 1) };
    if x < 0.0 { -magnitude } else { magnitude }
}

type Whole = [BigInt; 3];

/// Sign of the determinant of three homogeneous points.
fn side(a: &Whole, b: &Whole, p: &Whole) -> i32 {
    let minor = |i: usize, j: usize| &a[i] * &b[j] - &a[j] * &b[i];
    let determinant = minor(1, 2) * &p[0] + minor(2, 0) * &p[1] + minor(0, 1) * &p[2];
    match determinant.sign() {
        Minus => -1,
        NoSign => 0,
        _ => 1,
    }
}

/// Whether a lies left of b, by the columns.
fn is_left(a: &Whole, b: &Whole) -> bool {
    &a[0] * &b[2] < &b[0] * &a[2]
}

/// Even-odd by a ray straight up, from a hair right of the center and a hair of a hair below it.
fn covers(outline: &[Whole], (x, y): (i32, i32)) -> bool {
    let p: Whole = [2 * x + 1, 2 * y + 1, 2].map(BigInt::from);
    let mut inside = false;
    for (i, from) in outline.iter().enumerate() {
        let to = &outline[(i + 1) % outline.len()];
        let (left, right) = if is_left(to, from) { (to, from) } else { (from, to) };
        if is_left(&p, left) || !is_left(&p, right) {
            continue;
        }
        let below = side(left, right, &p);
        let falls_or_level = &right[1] * &left[2] <= &left[1] * &right[2];
        inside ^= below > 0 || (below == 0 && falls_or_level);
    }
    inside
}

fn corners(outline: &[Vec3]) -> Vec<ScreenVertex> {
    let corner = |&p: &Vec3| ScreenVertex { x: p.x / p.z, y: p.y / p.z, homogeneous: p, edge: EdgeKind::Original };
    outline.iter().map(corner).collect()
}

/// Which samples of the picture are covered, row by row.
fn drawn(outline: &[Vec3]) -> Vec<bool> {
    let mut covered = vec![false; (SIZE.0 * SIZE.1) as usize];
    let (width, height) = (SIZE.0 as i32, SIZE.1 as i32);
    Spans::within(0..width).of(&corners(outline), Grid::EXACT, 0..height, |y, columns| {
        columns.for_each(|x| covered[(y * width + x) as usize] = true);
    });
    covered
}

/// Compares every sample; returns how many are covered, and how many lie exactly on an edge's line.
fn check(outline: &[Vec3]) -> (usize, usize) {
    let exact: Vec<Whole> = outline.iter().map(|p| p.to_array().map(whole)).collect();
    let (mut count, mut ties) = (0, 0);
    for (index, is_drawn) in drawn(outline).into_iter().enumerate() {
        let sample = (index as i32 % SIZE.0 as i32, index as i32 / SIZE.0 as i32);
        assert_eq!(is_drawn, covers(&exact, sample), "sample {sample:?} of {outline:?}");
        count += usize::from(is_drawn);
        let center: Whole = [2 * sample.0 + 1, 2 * sample.1 + 1, 2].map(BigInt::from);
        ties += (0..exact.len()).filter(|&i| side(&exact[i], &exact[(i + 1) % exact.len()], &center) == 0).count();
    }
    (count, ties)
}

/// A distance from 1 to `10^reach` samples, all sizes alike, to either side of the picture's middle.
fn away(random: &mut Random, reach: f64) -> f64 {
    let distance = 10_f64.powf(random.between(0.0, reach));
    8.0 + if random.one_in(2) { distance } else { -distance }
}

#[test]
fn random_outlines_up_to_a_billion_samples_away() {
    let mut random = Random::new(1997);
    let (mut covered, mut all) = (0, 0);
    for _ in 0..600 {
        let reach = random.between(0.5, 9.0);
        let count = random.whole(3, 7);
        let outline: Vec<Vec3> = (0..count)
            .map(|_| {
                let w = 10_f64.powf(random.between(-3.0, 3.0));
                Vec3::new(away(&mut random, reach), away(&mut random, reach), 1.0) * w
            })
            .collect();
        covered += check(&outline).0;
        all += (SIZE.0 * SIZE.1) as usize;
    }
    assert!(covered * 5 > all && covered * 5 < 4 * all, "{covered} of {all}");
}

#[test]
fn edges_through_sample_centers_far_and_near() {
    let mut random = Random::new(7);
    let (mut covered, mut ties) = (0, 0);
    for _ in 0..600 {
        // Corners on lines of small whole slopes through centers, some of them moved by one last place.
        let outline: Vec<Vec3> = (0..random.whole(3, 6))
            .map(|_| {
                let center = (random.whole(0, 15) as f64 + 0.5, random.whole(0, 11) as f64 + 0.5);
                let (dx, dy) = (random.whole(-4, 4) as f64, random.whole(-4, 4) as f64);
                let length = (1_u64 << random.whole(0, 27)) as f64;
                let w = random.whole(1, 1 << 18) as f64 / 4096.0;
                let mut corner = Vec3::new(center.0 + dx * length, center.1 + dy * length, 1.0) * w;
                if random.one_in(4) {
                    corner.x = if random.one_in(2) { corner.x.next_up() } else { corner.x.next_down() };
                }
                corner
            })
            .collect();
        let found = check(&outline);
        (covered, ties) = (covered + found.0, ties + found.1);
    }
    // Lines through two centers, too: both ends on the same line, far off the picture on either side.
    for _ in 0..300 {
        let center = (random.whole(4, 11) as f64 + 0.5, random.whole(4, 7) as f64 + 0.5);
        let (dx, dy) = (random.whole(-3, 3) as f64, random.whole(-3, 3) as f64);
        let mut along = |sign: f64| {
            let length = sign * random.whole(1, 200_000_000) as f64;
            let w = random.whole(1, 1 << 18) as f64 / 256.0;
            Vec3::new(center.0 + dx * length, center.1 + dy * length, 1.0) * w
        };
        let (a, b) = (along(1.0), along(-1.0));
        let third = Vec3::new(away(&mut random, 9.0), away(&mut random, 9.0), 1.0);
        let found = check(&[a, b, third]);
        (covered, ties) = (covered + found.0, ties + found.1);
    }
    assert!(covered > 20_000 && ties > 3_500, "{covered} covered, {ties} ties");
}

#[test]
fn extreme_w_and_coordinates_do_not_leave_the_proof() {
    for w in [1e-300, 1e-160, 1e-30, 1.0, 1e150, 1e290] {
        check(&[Vec3::new(2.5 * w, 1.5 * w, w), Vec3::new(1e9 * w, 3.25 * w, w), Vec3::new(-7e8, 9e8, 1.0) * w]);
        check(&[Vec3::new(-1.0, -1.0, 1.0) * w, Vec3::new(40.0, 0.0, 1.0) / w, Vec3::new(3.0, 1e9, 1.0)]);
    }
    check(&[Vec3::new(-1e300, 0.0, 1.0), Vec3::new(1e300, 0.0, 1.0), Vec3::new(8.5, 8.5, 1.0)]);
    // Nothing of any of these is in the picture, or everything.
    assert_eq!(check(&[Vec3::new(1e9, 1e9, 1.0), Vec3::new(2e9, 1e9, 1.0), Vec3::new(1e9, 2e9, 1.0)]).0, 0);
    assert_eq!(check(&[Vec3::new(-1e9, -1e9, 1.0), Vec3::new(4e9, 0.0, 1.0), Vec3::new(0.0, 4e9, 1.0)]).0, 192);
}

#[test]
fn fans_cover_every_sample_once() {
    let mut random = Random::new(31);
    let mut inside = 0;
    for round in 0..400 {
        let count = random.whole(3, 12) as usize;
        let on_center = round % 2 == 0;
        let mut at =
            |size: f64| if on_center { random.whole(0, size as i64) as f64 + 0.5 } else { random.between(0.0, size) };
        let hub = (at(15.0), at(11.0));
        // Angles in order and less than half a turn apart, on whole directions so that edges meet centers.
        let directions = [
            (1, 0),
            (3, 1),
            (1, 1),
            (1, 3),
            (0, 1),
            (-1, 3),
            (-1, 1),
            (-3, 1),
            (-1, 0),
            (-3, -1),
            (-1, -1),
            (0, -1),
            (1, -1),
            (3, -1),
        ];
        let mut chosen: Vec<(i32, i32)> = directions.into_iter().filter(|_| random.one_in(14 / count as u64)).collect();
        chosen.extend([(1, 0), (-1, 3), (-3, -1), (0, -1)]);
        chosen.sort_by(|a, b| f64::from(a.1).atan2(f64::from(a.0)).total_cmp(&f64::from(b.1).atan2(f64::from(b.0))));
        chosen.dedup();
        let ring: Vec<Vec3> = chosen
            .iter()
            .map(|&(dx, dy)| {
                let length = (2_f64).powf(random.between(0.0, 29.0)).floor();
                let w = random.whole(1, 4096) as f64 / 64.0;
                Vec3::new(hub.0 + f64::from(dx) * length, hub.1 + f64::from(dy) * length, 1.0) * w
            })
            .collect();
        let hub = Vec3::new(hub.0, hub.1, 1.0) * (random.whole(1, 4096) as f64 / 64.0);
        let mut times = vec![0; (SIZE.0 * SIZE.1) as usize];
        for (i, &corner) in ring.iter().enumerate() {
            let covered = drawn(&[hub, corner, ring[(i + 1) % ring.len()]]);
            times.iter_mut().zip(covered).for_each(|(times, covered)| *times += u32::from(covered));
        }
        for (times, covered) in times.into_iter().zip(drawn(&ring)) {
            assert_eq!(times, u32::from(covered), "{ring:?}");
            inside += u64::from(covered);
        }
    }
    assert!(inside > 10_000, "{inside}");
}

#[test]
fn corners_on_the_grid_are_drawn_as_on_the_grid() {
    let mut shapes = Shapes { random: Random::new(5), steps: 256 };
    let mut samples = 0;
    for _ in 0..2_000 {
        let outline: Vec<_> =
            if shapes.random.one_in(3) { shapes.outline(300.0) } else { shapes.triangle(300.0).to_vec() };
        let corner = |&(x, y): &(i64, i64)| {
            let (x, y) = (x as f64 / 256.0, y as f64 / 256.0);
            let w = shapes.random.whole(1, 1 << 20) as f64 / 1024.0;
            ScreenVertex { x, y, homogeneous: Vec3::new(x, y, 1.0) * w, edge: EdgeKind::Original }
        };
        let outline: Vec<ScreenVertex> = outline.iter().map(corner).collect();
        let spans = |grid: Grid| {
            let mut all = Vec::new();
            Spans::within(0..SIDE as i32).of(&outline, grid, 0..SIDE as i32, |row, columns| all.push((row, columns)));
            all
        };
        let exact = spans(Grid::EXACT);
        assert_eq!(exact, spans(Grid { bits: 8 }), "{outline:?}");
        samples += exact.iter().map(|(_, columns)| columns.len()).sum::<usize>();
    }
    assert!(samples > 100_000, "{samples}");
}

#[test]
fn every_rasterizer_draws_unsnapped_scenes_and_clipping_the_sides_changes_nothing_else() {
    let exact =
        |shading| Choices { subpixel_bits: EXACT_SUBPIXELS, shading, culling: Culling::None, ..Choices::default() };
    let (mut differing, mut all) = (0, 0);
    for seed in 1..=40 {
        let shading = [Shading::Flat, Shading::Gouraud, Shading::Phong][seed as usize % 3];
        let mix = Mix {
            seed,
            polygons: 30,
            corners: if seed % 2 == 0 { (3, 6) } else { (3, 3) },
            transparent: seed % 4 == 0,
            distance: (0.5, 9.0),
            spread: 1.5,
            ..Mix::default()
        };
        let scene = mix.scene(64);
        let draw = |choices: &Choices, rasterizer: &dyn Rasterizer| {
            render(&scene, choices, Some(rasterizer)).unwrap_or_else(|error| panic!("{error}"))
        };
        let (by_z, by_lines) = (draw(&exact(shading), &ZBuffer), draw(&exact(shading), &Watkins));
        assert!(by_z.image == by_lines.image, "seed {seed}");
        assert_eq!(by_z.puts.stray_writes, 0);
        // Corners reach beyond the picture, so nothing was cut there.
        assert!(by_z.list.vertices.iter().any(|v| !(0.0..=64.0).contains(&v.x)), "seed {seed}");
        // Of polygons with more corners, clipping the sides changes the triangles that colors run over.
        if seed % 2 == 0 {
            continue;
        }
        let snapped = draw(&Choices { subpixel_bits: 16, ..exact(shading) }, &ZBuffer);
        let close = |a: &farop::color::Rgb<f32>, b: &farop::color::Rgb<f32>| {
            a.to_array().iter().zip(b.to_array()).all(|(a, b)| (a - b).abs() < 1e-4)
        };
        differing += by_z.image.pixels().iter().zip(snapped.image.pixels()).filter(|(a, b)| !close(a, b)).count();
        all += 64 * 64;
    }
    assert!(differing * 2_000 < all, "{differing} of {all}");
}

#[test]
fn lines_and_files_need_a_grid() {
    let scene = Mix { seed: 2, spread: 1.5, ..Mix::default() }.scene(64);
    let wire = |bits| Choices { subpixel_bits: bits, shading: Shading::Wire, ..Choices::default() };
    let lines = |bits| {
        let drawn =
            render(&scene, &wire(bits), Some(&farop::raster::PerPolygon(farop::raster::Wire))).expect("has a view");
        (drawn.image, drawn.puts.stray_writes)
    };
    assert!(lines(EXACT_SUBPIXELS) == lines(16));
    let mut list = DrawList::new(4, 4);
    list.grid = Grid::EXACT;
    list.push_flat(&[(-9.0, 1.0), (40.0, 0.25), (2.0, 1e9)], 1.0, [1.0; 3]);
    let message = "a screen file needs a grid";
    let error = write_v2(&list, &Sheet::default(), Attributes::default(), &mut Vec::new()).expect_err("refused");
    assert!(error.to_string().contains(message), "{error}");
    let error = write_classic(&list, &ClassicOptions::default(), &mut Vec::new()).expect_err("refused");
    assert!(error.to_string().contains(message), "{error}");
    // The same list is drawn all the same, and only inside the picture.
    let (_, counts) = draw(&list, &ZBuffer);
    assert!(counts.puts > 0 && counts.stray_writes == 0, "{counts:?}");
}
