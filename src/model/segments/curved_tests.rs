//! Images of tori and Bezier shapes against images twice as fine.

use super::super::tests::{Random, ball_in_view, image};
use super::*;
use crate::math::{Vec2, edges};
use crate::model::segments::segments;
use crate::model::test_bodies::{TORUS, pillow, vase};
use crate::model::{Detail, bounding_ball, tessellate};
use crate::scene::{Mesh, Shape, TeapotPart};

/// The polygons of `shape` in the picture; both windings.
fn picture(shape: &Shape, pair: [u32; 2], eye_from_local: &Affine3, lens: &Lens) -> (Vec<Vec2>, Vec<Vec<Vec2>>) {
    let mut mesh = Mesh::default();
    tessellate(shape, false, Detail::Grid(pair), 0, &mut mesh);
    let vertices: Vec<Vec2> = mesh.vertices.iter().map(|&v| image(lens, eye_from_local.transform_point3(v))).collect();
    let outline = |polygon| mesh.outline(polygon).iter().map(|&index| vertices[index as usize]).collect();
    let polygons = mesh.polygons.iter().map(outline).collect();
    (vertices, polygons)
}

/// The distance of a point from a convex polygon; 0 inside.
fn distance(point: Vec2, polygon: &[Vec2]) -> f64 {
    let sides = edges(polygon).map(|(&a, &b)| (b - a).perp_dot(point - a));
    let (low, high) = sides.fold((0.0f64, 0.0f64), |(low, high), side| (low.min(side), high.max(side)));
    if low == 0.0 || high == 0.0 {
        return 0.0;
    }
    let to_edge = |(&a, &b): (&Vec2, &Vec2)| {
        let part = (point - a).dot(b - a) / (b - a).length_squared().max(f64::MIN_POSITIVE);
        (point - (a + (b - a) * part.clamp(0.0, 1.0))).length()
    };
    edges(polygon).map(to_edge).fold(f64::INFINITY, f64::min)
}

/// How far the fine picture reaches beyond the coarse one, at most.
fn beyond(fine: &[Vec2], coarse: &[Vec<Vec2>], enough: f64) -> f64 {
    // Neighbors in the list are neighbors in the picture: look first where the last point was found.
    let mut last = 0;
    let mut of_point = |&point: &Vec2| {
        let mut least = f64::INFINITY;
        for step in 0..coarse.len() {
            let at = (last + step) % coarse.len();
            let here = distance(point, &coarse[at]);
            if here < least {
                (least, last) = (here, if here == 0.0 { at } else { last });
            }
            if least < 0.1 * enough {
                break;
            }
        }
        least
    };
    fine.iter().map(&mut of_point).fold(0.0, f64::max)
}

#[test]
fn tori_and_bezier_shapes_keep_the_tolerance() {
    let mut random = Random(23);
    let shapes =
        [TORUS, pillow(), vase(0.0), vase(0.7), Shape::Teapot(TeapotPart::Spout), Shape::Teapot(TeapotPart::Lid)];
    let mut ratios = Vec::new();
    for sample in 0..18 {
        let shape = &shapes[sample % shapes.len()];
        let view = ball_in_view(&mut random);
        // Fit the shape, turned and squeezed, into the ball.
        let turn = |random: &mut Random| Affine3::from_axis_angle(random.direction(), random.between(0.0, 6.0));
        let squeeze = Vec3::new(1.0, random.between(0.3, 1.0), random.between(0.3, 1.0));
        let ball = bounding_ball(shape);
        let map = turn(&mut random) * Affine3::from_scale(squeeze) * turn(&mut random);
        let eye_from_local = Affine3::from_translation(view.center)
            * Affine3::from_scale(Vec3::splat(
                view.radius.min(120.0 * view.center.z / view.lens.pixels_per_unit_tangent) / ball.radius,
            ))
            * map
            * Affine3::from_translation(-ball.center);
        let tolerance = [1.0, 0.5][sample / shapes.len() % 2];
        let pair = segments(shape, &eye_from_local, &view.lens, tolerance);
        let (_, coarse) = picture(shape, pair, &eye_from_local, &view.lens);
        let (fine, _) = picture(shape, pair.map(|n| 2 * n + 1), &eye_from_local, &view.lens);
        let error = beyond(&fine, &coarse, tolerance);
        assert!(error <= tolerance, "{error} px of {tolerance}: {shape:?} {pair:?}");
        ratios.push(error / tolerance);
    }
    ratios.sort_by(f64::total_cmp);
    println!("error / tolerance: median {:.3}, largest {:.3}", ratios[ratios.len() / 2], ratios[ratios.len() - 1]);
    // Bounds of derivatives cost something, but not everything.
    assert!(ratios[ratios.len() - 1] > 0.3, "{ratios:?}");
}

#[test]
fn the_budget_ends_what_a_tolerance_asks() {
    let lens = Lens { pixels_per_unit_tangent: 500.0, hither: 0.1, corner_cosine: 0.8 };
    // Around the eye: only hither bounds how near it is.
    for (shape, pieces) in [(TORUS, 1.0), (pillow(), 6.0), (vase(0.7), 8.0), (Shape::Teapot(TeapotPart::Whole), 28.0)] {
        for tolerance in [1e-9, 0.0, -1.0] {
            let [n, m] = segments(&shape, &Affine3::IDENTITY, &lens, tolerance);
            let polygons = f64::from(n) * f64::from(m) * pieces;
            assert!(polygons > 0.9 * MOST_POLYGONS && polygons <= MOST_POLYGONS, "{shape:?}: {n} {m}");
        }
        let far = Affine3::from_translation(Vec3::Z * 1e9);
        let [n, m] = segments(&shape, &far, &lens, 0.25);
        assert!(n <= 3 && m <= 3, "{shape:?}: {n} {m}");
    }
}
