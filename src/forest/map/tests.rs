//! Tests of maps: texels against exact answers, and the two ways of drawing against each other.

use super::*;
use crate::forest::drape::Drape;
use crate::forest::polygon::{Point, contains};
use crate::forest::random::mix64;
use crate::forest::vector::{Geometry, Rings};
use crate::image::textures::{FirstRow, Texels};
use crate::math::{Mat3, Vec2, Vec3};

/// Texels each way.
const SIDE: f64 = 64.0;
const METRES: Length = Length { value: 3.0, unit: Unit::Metres };

/// A drape that lays 100 m x 100 m on the texture, evenly.
fn even() -> Drape {
    let texture_from_ground = Mat3::from_diagonal(Vec3::new(0.01, 0.01, 1.0));
    Drape { texture_from_ground, strength: None }
}

/// A drape with a perspective: its center is 20 m south of the square.
fn steep() -> Drape {
    let w = Vec3::new(0.0, 1.0, 20.0);
    // Across: 5/6 of the texture at the far side; along: -1/w from 1/20 to 1/120.
    let height = 1.0 / 20.0 - 1.0 / 120.0;
    let rows = [Vec3::new(1.0, 0.0, 0.0), (w / 20.0 - Vec3::Z) / height, w];
    let texture_from_ground = Mat3::from_cols(rows[0], rows[1], rows[2]).transpose();
    Drape { texture_from_ground, strength: Some(20.0) }
}

fn number(key: u64) -> f64 {
    (mix64(key) >> 11) as f64 / (1u64 << 53) as f64
}

/// A star of `corners` corners around a middle: concave, and simple.
fn star(key: u64, [x, y]: Point, corners: usize, [near, far]: [f64; 2]) -> Vec<Point> {
    (0..corners)
        .map(|corner| {
            let angle = 2.0 * crate::math::PI * corner as f64 / corners as f64;
            let radius = near + (far - near) * number(key * 1000 + corner as u64);
            [x + radius * crate::math::cos(angle), y + radius * crate::math::sin(angle)]
        })
        .collect()
}

fn lakes(count: u64) -> Vec<Rings> {
    (0..count)
        .map(|key| {
            let middle = [20.0 + 60.0 * number(key * 7 + 1), 20.0 + 60.0 * number(key * 7 + 2)];
            Rings {
                outer: star(key * 2, middle, 17, [12.0, 20.0]),
                holes: vec![star(key * 2 + 1, middle, 7, [3.0, 9.0])],
            }
        })
        .collect()
}

fn area(rings: Rings, color: [u8; 3]) -> Shape {
    Shape { geometry: Geometry::Polygons(vec![rings]), pen: None, fill: Some(color), size: METRES }
}

fn texel(texels: &Texels, column: u32, row: u32) -> [u8; 4] {
    texels.rgba()[(row * texels.size().0 + column) as usize]
}

/// Whether all of a texel and what is around it are on one side, as far as 5 x 5 places tell.
fn is_plain(rings: &Rings, ground: impl Fn(Vec2) -> Point, (column, row): (u32, u32)) -> bool {
    let at = |step: u32| {
        let part = |index: u32| f64::from(index) / 2.0 - 0.5;
        let place = Vec2::new(f64::from(column) + part(step % 5), f64::from(row) + part(step / 5));
        contains(&rings.outer, &rings.holes, ground(place / SIDE))
    };
    (1..25).all(|step| at(step) == at(0))
}

#[test]
fn polygons_with_holes_cover_what_is_inside_in_any_drape() {
    let (mut judged, mut inside) = (0, 0);
    for (number, rings) in lakes(8).into_iter().enumerate() {
        for drape in [even(), steep()] {
            let shapes = [area(rings.clone(), [10, 200, 30])];
            let texels = draw(&shapes, &drape, SIDE as u32, &|_| 1.0).expect("texels");
            let ground_from_texture = drape.texture_from_ground.inverse();
            for index in 0..64 * 64 {
                let (column, row) = (index % 64, index / 64);
                let ground = |place: Vec2| {
                    let ground = ground_from_texture * place.extend(1.0);
                    (ground.truncate() / ground.z).to_array()
                };
                if !is_plain(&rings, ground, (column, row)) {
                    continue;
                }
                let middle = ground(Vec2::new(f64::from(column) + 0.5, f64::from(row) + 0.5) / SIDE);
                let is_inside = contains(&rings.outer, &rings.holes, middle);
                let [red, green, blue, alpha] = texel(&texels, column, row);
                // A tip may lie between the places that were asked.
                assert!(if is_inside { alpha > 200 } else { alpha < 55 }, "{number} {middle:?}: {alpha}");
                assert!(alpha == 0 || [red, green, blue] == [10, 200, 30], "{number} {middle:?}");
                judged += 1;
                inside += u32::from(is_inside);
            }
        }
    }
    assert!(judged > 40_000 && inside > 500, "{judged} {inside}");
}

#[test]
fn shares_of_texels_add_up_to_the_area() {
    for rings in lakes(20) {
        let area_of = |ring: &[Point]| {
            let twice: f64 = crate::math::edges(ring).map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum();
            (twice / 2.0).abs()
        };
        let exact = area_of(&rings.outer) - area_of(&rings.holes[0]);
        let texels = draw(&[area(rings, [255; 3])], &even(), 100, &|_| 1.0).expect("texels");
        let drawn: f64 = texels.rgba().iter().map(|texel| f64::from(texel[3]) / 255.0).sum();
        assert!((drawn / exact - 1.0).abs() < 0.01, "{drawn} {exact}");
    }
}

#[test]
fn a_line_is_as_wide_as_it_says_and_crosses_itself_once() {
    let line = |points: &[Point], width, unit| Shape {
        geometry: Geometry::Lines(vec![points.to_vec()]),
        pen: Some(Pen { color: [255, 0, 0], width: Length { value: width, unit }, dash: None }),
        fill: None,
        size: METRES,
    };
    let covered = |shape: Shape, pixel: f64| {
        let texels = draw(&[shape], &even(), 200, &|_| pixel).expect("texels");
        texels.rgba().iter().map(|texel| f64::from(texel[3]) / 255.0).sum::<f64>() / 4.0
    };
    // 60 m of road 4 m wide, in square metres; ends are straight.
    let straight = [[20.0, 30.3], [80.0, 30.3]];
    assert!((covered(line(&straight, 4.0, Unit::Metres), 1.0) - 240.0).abs() < 1.0);
    // Eight pixels of half a metre.
    assert!((covered(line(&straight, 8.0, Unit::Pixels), 0.5) - 240.0).abs() < 1.0);
    // A cross over itself: the square in the middle counts once.
    let cross = [[20.0, 50.0], [80.0, 50.0], [80.0, 90.0], [50.0, 90.0], [50.0, 20.0]];
    let expected = 4.0 * (60.0 + 40.0 + 30.0 + 70.0) - 16.0;
    assert!((covered(line(&cross, 4.0, Unit::Metres), 1.0) - expected).abs() < 8.0);
    let mut dashed = line(&straight, 4.0, Unit::Metres);
    dashed.pen = dashed.pen.map(|pen| Pen { dash: Some([6.0, 4.0]), ..pen });
    assert!((covered(dashed, 1.0) - 0.6 * 240.0).abs() < 2.0);
}

/// The same shapes drawn into ever more texels come closer to what the vectors themselves say.
#[test]
fn texels_come_to_the_exact_picture() {
    let mut shapes: Vec<Shape> = lakes(6).into_iter().map(|rings| area(rings, [20, 90, 200])).collect();
    for key in 0..30 {
        let at = |step: u64| [100.0 * number(key * 90 + step), 100.0 * number(key * 90 + step + 40)];
        let pen = Pen { color: [200, 40, 20], width: METRES, dash: (key % 3 == 0).then_some([5.0, 3.0]) };
        let geometry = Geometry::Lines(vec![(0..5).map(at).collect()]);
        shapes.push(Shape { geometry, pen: Some(pen), fill: None, size: METRES });
        let size = Length { value: 4.0, unit: Unit::Metres };
        shapes.push(Shape { geometry: Geometry::Points(vec![at(9)]), pen: None, fill: Some([9, 9, 9]), size });
    }
    let exact = Exact::new(&shapes, [0.0, 0.0], 100.0);
    for drape in [even(), steep()] {
        let wrong = [32, 128, 512].map(|side: u32| {
            let texels = draw(&shapes, &drape, side, &|_| 1.0).expect("texels");
            let mut wrong = 0;
            for key in 0..20_000 {
                let ground = Vec2::new(number(key * 2 + 1) * 100.0, number(key * 2 + 2) * 100.0);
                let place = drape.place(ground).expect("ahead") * f64::from(side);
                if place.min_element() < 0.0 || place.max_element() >= f64::from(side) {
                    continue;
                }
                let texel = texel(&texels, place.x as u32, place.y as u32);
                let found = (texel[3] > 127).then_some([texel[0], texel[1], texel[2]]);
                let is_near = |one: [u8; 3], other: [u8; 3]| (0..3).all(|c| one[c].abs_diff(other[c]) < 60);
                wrong += u32::from(match (found, exact.color(ground, 1.0)) {
                    (Some(one), Some(other)) => !is_near(one, other),
                    (one, other) => one.is_some() != other.is_some(),
                });
            }
            wrong
        });
        assert!(2 * wrong[0] > 3 * wrong[1] && 2 * wrong[1] > 3 * wrong[2] && wrong[2] < 1000, "{wrong:?}");
    }
}

#[test]
fn what_comes_near_the_center_is_cut_before_it_is_divided() {
    // A road from far behind the center to far ahead: only what is ahead is drawn, and it stays where it is.
    let pen = Pen { color: [255; 3], width: METRES, dash: None };
    let through = |from: f64| Shape {
        geometry: Geometry::Lines(vec![vec![[50.0, from], [50.0, 90.0]]]),
        pen: Some(pen),
        fill: None,
        size: METRES,
    };
    let of = |from: f64| draw(&[through(from)], &steep(), 64, &|_| 1.0).expect("texels");
    assert_eq!(of(-500.0), of(-5.0), "cut at half the distance of what can be seen");
    assert!(of(-500.0).rgba().iter().any(|texel| texel[3] == 255));
}

#[test]
fn nothing_makes_no_texture_and_odd_numbers_no_panic() {
    assert!(draw(&[], &even(), 0, &|_| 1.0).is_none());
    let odd = [f64::NAN, f64::INFINITY, -1e300];
    for x in odd {
        for y in odd {
            let points = vec![[x, y], [1.0, y], [x, 2.0]];
            let rings = Rings { outer: points.clone(), holes: vec![] };
            let shapes = [
                area(rings, [1; 3]),
                Shape {
                    geometry: Geometry::Lines(vec![points]),
                    ..area(Rings { outer: vec![], holes: vec![] }, [1; 3])
                },
            ];
            assert!(draw(&shapes, &steep(), 16, &|_| x).is_some());
            let exact = Exact::new(&shapes, [0.0, 0.0], 100.0);
            assert_eq!(exact.color(Vec2::new(x, y), y), None);
        }
    }
    let none = Texels::new(1, 1, vec![[0; 4]], FirstRow::AtV0);
    assert_eq!(draw(&[], &even(), 1, &|_| 1.0), none);
}
